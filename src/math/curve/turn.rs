//! Surfaces of revolution about any axis.
//!
//! The quaternion s + w with a vector w turns v to ((s² − |w|²) v + 2 (w·v) w + 2 s w × v)/(s² + |w|²). For an axis through p with
//! direction d, w = r d and s, r linear in u, every orbit is a rational quadratic. Four arcs lead around: s + r d equals
//! 1 + u d, then |d|² (1 − u) + (|d|² + u) d up to half a turn, and both again after another half. No root is needed, since the arcs
//! need not be quarters: the first one turns by 2 arctan |d|.
//!
//! R. T. Farouki, "Pythagorean-Hodograph Curves" (2008), chapter 5.

use super::patch::TensorPatch;
use super::rational::RationalCurve;
use super::rational_surface::RationalPatch;
use super::{CurveError, Interval, Point};
use crate::math::number::integer;
use crate::math::ring::{Field, Ring};

/// The surface of revolution of a curve in space about the axis through p and q, as four patches of degree (2, n), the k-th for u in
/// [k, k + 1].
///
/// Cost: 12 products of coordinates for each control point.
///
/// # Errors
/// [`CurveError::DimensionsOf`] unless all are in space, [`CurveError::Degenerate`] if p = q.
///
/// ```
/// use polarform::curve::{Interval, RationalCurve, revolve_about};
/// use polarform::number::{integer as z, rational as q};
/// let line = RationalCurve::new([[1, 0, 0], [1, 0, 2]].map(|p| p.map(z).to_vec()).to_vec(), vec![z(1), z(1)], Interval::unit())?;
/// let patches = revolve_about(&line, &[0, 0, 0].map(z).into(), &[0, 0, 1].map(z).into())?;
/// assert_eq!(patches[0].value(&q(1, 2), &z(0))?, [q(3, 5), q(4, 5), z(0)]);
/// assert_eq!(patches[1].value(&z(2), &z(1))?, [z(-1), z(0), z(2)]);
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn revolve_about<C: Field>(
    curve: &RationalCurve<C>,
    p: &Point<C>,
    q: &Point<C>,
) -> Result<Vec<RationalPatch<C>>, CurveError> {
    for dimension in [curve.dimension(), p.len(), q.len()] {
        if dimension != 3 {
            return Err(CurveError::DimensionsOf { left: dimension, right: 3 });
        }
    }
    let d = q - p;
    if d.is_zero() {
        return Err(CurveError::Degenerate);
    }
    let square = d.iter().fold(C::zero(), |sum, x| sum.plus(&x.times(x)));
    let (zero, one) = (C::zero, C::one);
    // s and r at u = 0 and u = 1.
    let up = square.plus(&one());
    let arcs: [[[C; 2]; 2]; 4] = [
        [[one(), one()], [zero(), one()]],
        [[square.clone(), zero()], [square.clone(), up.clone()]],
        [[zero(), -square.clone()], [one(), one()]],
        [[-square.times(&square), -square.times(&up)], [square.clone(), zero()]],
    ];
    (0..).zip(arcs).map(|(k, [s, r])| arc(curve, p, &d, &square, (s, r), k)).collect()
}

/// The control vectors of the product of two linear functions.
fn product<C: Ring>(f: &[C; 2], g: &[C; 2]) -> [C; 3] {
    let half = crate::math::number::rational(1, 2);
    let middle = f[0].times(&g[1]).plus(&f[1].times(&g[0])).scaled(&half);
    [f[0].times(&g[0]), middle, f[1].times(&g[1])]
}

fn arc<C: Field>(
    curve: &RationalCurve<C>,
    p: &Point<C>,
    d: &[C],
    square: &C,
    (s, r): ([C; 2], [C; 2]),
    k: i64,
) -> Result<RationalPatch<C>, CurveError> {
    let (ss, rr, sr) = (product(&s, &s), product(&r, &r), product(&s, &r));
    let along = curve.homogeneous();
    let row = |i: usize| -> Vec<Point<C>> {
        let length = ss[i].plus(&rr[i].times(square));
        let keep = ss[i].minus(&rr[i].times(square));
        let control = |point: &Point<C>| -> Point<C> {
            let weight = &point[3];
            // W (x − p), so that points at infinity turn as well.
            let v: Vec<C> = (0..3).map(|j| point[j].minus(&weight.times(&p[j]))).collect();
            let dot = (0..3).fold(C::zero(), |sum, j| sum.plus(&d[j].times(&v[j])));
            let cross = |j: usize| {
                let (a, b) = ((j + 1) % 3, (j + 2) % 3);
                d[a].times(&v[b]).minus(&d[b].times(&v[a]))
            };
            let two = integer(2);
            let coordinate = |j: usize| {
                let turned = keep
                    .times(&v[j])
                    .plus(&rr[i].times(&dot).times(&d[j]).scaled(&two))
                    .plus(&sr[i].times(&cross(j)).scaled(&two));
                turned.plus(&length.times(weight).times(&p[j]))
            };
            (0..3).map(coordinate).chain([length.times(weight)]).collect()
        };
        along.points().iter().map(control).collect()
    };
    let number = |k: i64| C::from_rational(&integer(k));
    let interval = Interval::new(number(k), number(k + 1))?;
    let net = (0..3).map(row).collect();
    RationalPatch::from_homogeneous(TensorPatch::new(net, interval, along.interval().clone())?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::Vector;
    use crate::math::number::{Rational, rational};
    use proptest::prelude::*;

    fn point() -> impl Strategy<Value = Point<Rational>> {
        prop::collection::vec((-4i64..5, 1i64..3), 3)
            .prop_map(|list| list.into_iter().map(|(a, b)| rational(a, b)).collect())
    }

    fn dot(a: &Vector<Rational>, b: &Vector<Rational>) -> Rational {
        a.iter().zip(b.iter()).map(|(x, y)| x * y).sum()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// Orbits keep the distance from two points of the axis, close, and run through half a turn and back.
        #[test]
        fn orbits_are_circles_about_the_axis(a in point(), b in point(), p in point(), q in point(), w in 1i64..4, t in 0i64..5) {
            prop_assume!(p != q);
            let curve = RationalCurve::new(vec![a, b], vec![integer(1), integer(w)], Interval::unit()).unwrap();
            let patches = revolve_about(&curve, &p, &q).unwrap();
            let t = rational(t, 4);
            let start = curve.value(&t).unwrap();
            let distances = |x: &Point<Rational>| [&p, &q].map(|c| { let v = x - c; dot(&v, &v) });
            for (k, patch) in (0..).zip(&patches) {
                for u in [rational(0, 1), rational(1, 3), rational(1, 1)] {
                    let x = patch.value(&(integer(k) + &u), &t).unwrap();
                    prop_assert_eq!(distances(&x), distances(&start));
                }
                let next = &patches[(k as usize + 1) % 4];
                let end = patch.value(&integer(k + 1), &t).unwrap();
                prop_assert_eq!(end, next.value(&integer((k + 1) % 4), &t).unwrap());
            }
            prop_assert_eq!(patches[0].value(&integer(0), &t).unwrap(), start.clone());
            // Half a turn: x + x' = 2 foot.
            let half = patches[1].value(&integer(2), &t).unwrap();
            let d = &q - &p;
            let foot = &p + &(&d * &(dot(&d, &(&start - &p)) / dot(&d, &d)));
            prop_assert_eq!(&half - &foot, -(&start - &foot));
            // Always onwards: the normal part turns by an angle with a positive sine with the next point.
            let first = patches[0].value(&rational(1, 2), &t).unwrap();
            let (x, y) = (&start - &foot, &first - &foot);
            let cross = [0, 1, 2].map(|j| &x[(j + 1) % 3] * &y[(j + 2) % 3] - &x[(j + 2) % 3] * &y[(j + 1) % 3]);
            let sine: Rational = cross.iter().zip(d.iter()).map(|(x, y)| x * y).sum();
            prop_assert!(sine > integer(0) || x.is_zero());
        }
    }
}
