//! Surfaces made of curves: ruled and swept ones, and those that blend a network of curves.
//!
//! **Ruled.** The lines from c(u) to d(u): s(u, v) = (1 − v) c(u) + v d(u).
//!
//! **Swept.** c moved along d: s(u, v) = c(u) + d(v) − d(0).
//!
//! **Gordon.** Curves c_0, …, c_m in u at the nodes v_j and d_0, …, d_n in v at the nodes u_i that meet, c_j(u_i) = d_i(v_j) = p_ij.
//! With Lagrange's polynomials L_i of the u_i and M_j of the v_j the surface
//! Σ_i L_i(u) d_i(v) + Σ_j M_j(v) c_j(u) − Σ_ij L_i(u) M_j(v) p_ij contains all of them: each sum interpolates one family, and the
//! last one what both count twice (a Boolean sum). For two and two curves it is Coons' bilinearly blended surface.
//!
//! S. A. Coons, "Surfaces for computer-aided design of space forms", MIT 1967; W. J. Gordon, "Spline-blended surface
//! interpolation through curve networks", J. Math. Mech. 18 (1969).

use super::{BezierCurve, CurveError, Interval, Net, Point, TensorPatch};
use crate::budget;
use crate::math::ring::Field;

/// The surface of the lines between points of two curves with the same parameter, over the interval of the first and [0, 1].
///
/// Cost: the lower degree raised.
///
/// # Errors
/// [`CurveError::DimensionsOf`].
///
/// ```
/// use polarform::curve::{BezierCurve, Interval, ruled_surface};
/// use polarform::number::{integer as z, rational as q};
/// let curve = |points: Vec<[i64; 2]>| BezierCurve::new(points.iter().map(|p| p.map(z).to_vec()).collect(), Interval::unit());
/// let s = ruled_surface(&curve(vec![[0, 0], [1, 0]])?, &curve(vec![[0, 2], [1, 4], [2, 2]])?)?;
/// assert_eq!(s.value(&q(1, 2), &q(1, 2)), [q(3, 4), q(3, 2)]);
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn ruled_surface<C: Field>(c: &BezierCurve<C>, d: &BezierCurve<C>) -> Result<TensorPatch<C>, CurveError> {
    same_dimension(c, d)?;
    let n = c.degree().max(d.degree());
    let (c, d) = (c.elevate(n - c.degree()), d.elevate(n - d.degree()));
    let net = c.points().iter().zip(d.points()).map(|(p, q)| vec![p.clone(), q.clone()]).collect();
    TensorPatch::new(net, c.interval().clone(), Interval::unit())
}

/// The surface that c sweeps when it is moved along d, from where d starts. Cost: m n sums for degrees m and n.
///
/// # Errors
/// [`CurveError::DimensionsOf`].
pub fn swept_surface<C: Field>(c: &BezierCurve<C>, d: &BezierCurve<C>) -> Result<TensorPatch<C>, CurveError> {
    same_dimension(c, d)?;
    budget::charge_terms((c.degree() as u64 + 1).saturating_mul(d.degree() as u64 + 1));
    let row = |p: &Point<C>| d.points().iter().map(|q| p + &(q - &d.points()[0])).collect();
    TensorPatch::new(c.points().iter().map(row).collect(), c.interval().clone(), d.interval().clone())
}

/// Gordon's surface of curves c_j in u at the nodes v_j and d_i in v at the nodes u_i, over the intervals from the first node to the last.
///
/// Cost: m n products of polynomials for m and n curves.
///
/// # Errors
/// [`CurveError::TooFewPoints`] if a family has fewer than two curves, [`CurveError::Degrees`] unless there is a node for each curve,
/// [`CurveError::DimensionsOf`], [`CurveError::EmptyInterval`] if nodes are equal, [`CurveError::NoCommonEnd`] unless the curves meet.
///
/// ```
/// use polarform::curve::{BezierCurve, Interval, gordon_surface};
/// use polarform::number::{integer as z, rational as q};
/// let curve = |heights: &[i64]| BezierCurve::new(heights.iter().map(|&h| vec![z(h)]).collect(), Interval::unit());
/// let s = gordon_surface(
///     &[curve(&[0, 2, 0])?, curve(&[1, 1])?], &[z(0), z(1)],
///     &[curve(&[0, 1])?, curve(&[0, 3, 1])?], &[z(0), z(1)],
/// )?;
/// assert_eq!(s.value(&q(1, 2), &z(0)), [z(1)]);
/// assert_eq!(s.value(&z(1), &q(1, 2)), [q(7, 4)]);
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn gordon_surface<C: Field>(
    in_u: &[BezierCurve<C>],
    v_nodes: &[C],
    in_v: &[BezierCurve<C>],
    u_nodes: &[C],
) -> Result<TensorPatch<C>, CurveError> {
    for (curves, nodes) in [(in_u, v_nodes), (in_v, u_nodes)] {
        if curves.len() < 2 {
            return Err(CurveError::TooFewPoints { needed: 2, given: curves.len() });
        }
        if curves.len() != nodes.len() {
            return Err(CurveError::Degrees { left: curves.len(), right: nodes.len() });
        }
    }
    let dimension = in_u[0].dimension();
    for curve in in_u.iter().chain(in_v) {
        same_dimension(&in_u[0], curve)?;
    }
    let (l, m) = (lagrange(u_nodes)?, lagrange(v_nodes)?);
    let (by_v, by_u): (Vec<_>, Vec<_>) =
        (in_v.iter().map(BezierCurve::power).collect(), in_u.iter().map(BezierCurve::power).collect());
    let height = l[0].len().max(by_u.iter().flatten().map(Vec::len).max().unwrap_or(1));
    let width = m[0].len().max(by_v.iter().flatten().map(Vec::len).max().unwrap_or(1));
    budget::charge_terms((height as u64).saturating_mul(width as u64));
    let mut grid: Net<C> = vec![vec![Point::from(vec![C::zero(); dimension]); width]; height];
    let mut add = |a: &[C], b: &[C], k: usize, factor: &C| {
        for (i, x) in a.iter().enumerate() {
            budget::steps(b.len() as u32);
            for (j, y) in b.iter().enumerate() {
                grid[i][j][k] += x.times(y).times(factor);
            }
        }
    };
    for k in 0..dimension {
        for (basis, curve) in l.iter().zip(&by_v) {
            add(basis, &curve[k], k, &C::one());
        }
        for (basis, curve) in m.iter().zip(&by_u) {
            add(&curve[k], basis, k, &C::one());
        }
        for (i, u) in u_nodes.iter().enumerate() {
            for (j, v) in v_nodes.iter().enumerate() {
                let point = in_u[j].value(u);
                if point != in_v[i].value(v) {
                    return Err(CurveError::NoCommonEnd);
                }
                add(&l[i], &m[j], k, &-point[k].clone());
            }
        }
    }
    let ends = |nodes: &[C]| Interval::new(nodes[0].clone(), nodes[nodes.len() - 1].clone());
    TensorPatch::from_power_coefficients(grid, ends(u_nodes)?, ends(v_nodes)?)
}

/// Lagrange's polynomials of some nodes, by powers.
fn lagrange<C: Field>(nodes: &[C]) -> Result<Vec<Vec<C>>, CurveError> {
    let polynomial = |i: usize| {
        let mut product = vec![C::one()];
        for (j, x) in nodes.iter().enumerate().filter(|(j, _)| *j != i) {
            let scale = nodes[i].minus(x).inverse().ok_or(CurveError::EmptyInterval)?;
            debug_assert!(i != j);
            let mut next = vec![C::zero(); product.len() + 1];
            for (k, c) in product.iter().enumerate() {
                next[k + 1] += c.times(&scale);
                next[k] += -c.times(x).times(&scale);
            }
            product = next;
        }
        Ok(product)
    };
    (0..nodes.len()).map(polynomial).collect()
}

fn same_dimension<C: Field>(c: &BezierCurve<C>, d: &BezierCurve<C>) -> Result<(), CurveError> {
    match c.dimension() == d.dimension() {
        true => Ok(()),
        false => Err(CurveError::DimensionsOf { left: c.dimension(), right: d.dimension() }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{Rational, integer as z, rational as q};
    use proptest::prelude::*;

    /// A surface by its net, from which networks are taken.
    fn surface() -> impl Strategy<Value = TensorPatch<Rational>> {
        prop::collection::vec(prop::collection::vec(prop::collection::vec(-5i64..6, 2), 4), 3).prop_map(
            |net| {
                let net = net
                    .iter()
                    .map(|row| row.iter().map(|p| p.iter().map(|&x| z(x)).collect::<Vec<_>>()).collect())
                    .collect();
                TensorPatch::new(net, Interval::unit(), Interval::unit()).unwrap()
            },
        )
    }

    /// The curve of a surface for a fixed parameter, through its values.
    fn iso(s: &TensorPatch<Rational>, t: &Rational, in_u: bool) -> BezierCurve<Rational> {
        let n = if in_u { s.degrees().0 } else { s.degrees().1 };
        let at = |x: &Rational| if in_u { s.value(x, t) } else { s.value(t, x) };
        let nodes: Vec<Rational> = (0..=n as i64).map(|k| q(k, n as i64)).collect();
        let basis = lagrange(&nodes).unwrap();
        let coordinates: Vec<Vec<Rational>> = (0..s.dimension())
            .map(|k| {
                let mut sum = vec![z(0); n + 1];
                for (node, l) in nodes.iter().zip(&basis) {
                    let value = at(node)[k].clone();
                    for (x, c) in sum.iter_mut().zip(l) {
                        *x += c * &value;
                    }
                }
                sum
            })
            .collect();
        BezierCurve::from_power(&coordinates, Interval::unit()).unwrap()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        /// The surface contains all curves; with as many as the degrees ask for it is the surface they were taken from.
        #[test]
        fn networks_are_interpolated(s in surface(), t in -3i64..4) {
            let (us, vs) = ([z(0), q(1, 2), z(1)], [z(0), q(1, 3), q(3, 4), z(1)]);
            let in_u: Vec<_> = vs.iter().map(|v| iso(&s, v, true)).collect();
            let in_v: Vec<_> = us.iter().map(|u| iso(&s, u, false)).collect();
            let t = q(t, 2);
            let few = gordon_surface(&[in_u[0].clone(), in_u[3].clone()], &[z(0), z(1)], &[in_v[0].clone(), in_v[2].clone()], &[z(0), z(1)]).unwrap();
            for k in [0, 1] {
                prop_assert_eq!(few.value(&t, &z(k)), s.value(&t, &z(k)));
                prop_assert_eq!(few.value(&z(k), &t), s.value(&z(k), &t));
            }
            let all = gordon_surface(&in_u, &vs, &in_v, &us).unwrap();
            prop_assert_eq!(all.value(&t, &q(2, 5)), s.value(&t, &q(2, 5)));
            // Coons' formula at a point.
            let (u, v) = (q(2, 7), q(3, 7));
            let mix = |a: &Point<Rational>, b: &Point<Rational>, t: &Rational| super::super::lerp(a, b, t);
            let along_u = mix(&s.value(&u, &z(0)), &s.value(&u, &z(1)), &v);
            let along_v = mix(&s.value(&z(0), &v), &s.value(&z(1), &v), &u);
            let corners = mix(&mix(&s.value(&z(0), &z(0)), &s.value(&z(1), &z(0)), &u), &mix(&s.value(&z(0), &z(1)), &s.value(&z(1), &z(1)), &u), &v);
            prop_assert_eq!(few.value(&u, &v), &along_u + &(&along_v - &corners));
            prop_assert_eq!(ruled_surface(&in_u[0], &in_u[1]).unwrap().value(&u, &v), mix(&in_u[0].value(&u), &in_u[1].value(&u), &v));
            let moved = swept_surface(&in_u[0], &in_v[0]).unwrap();
            prop_assert_eq!(moved.value(&u, &v), &in_u[0].value(&u) + &(&in_v[0].value(&v) - &in_v[0].value(&z(0))));
        }
    }

    #[test]
    fn networks_have_to_meet() {
        let line = |a: i64, b: i64| BezierCurve::new(vec![vec![z(a)], vec![z(b)]], Interval::unit()).unwrap();
        let nodes = [z(0), z(1)];
        let apart = gordon_surface(&[line(0, 1), line(0, 1)], &nodes, &[line(0, 0), line(2, 1)], &nodes);
        assert_eq!(apart, Err(CurveError::NoCommonEnd));
        let one = gordon_surface(&[line(0, 1)], &nodes[..1], &[line(0, 0), line(2, 1)], &nodes);
        assert_eq!(one, Err(CurveError::TooFewPoints { needed: 2, given: 1 }));
        let equal =
            gordon_surface(&[line(0, 1), line(0, 1)], &[z(0), z(0)], &[line(0, 0), line(2, 1)], &nodes);
        assert_eq!(equal, Err(CurveError::EmptyInterval));
    }
}
