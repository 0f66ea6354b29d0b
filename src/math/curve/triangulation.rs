//! Piecewise polynomials on triangulations: dimensions, and the macro elements of Clough and Tocher and of Powell and Sabin.
//!
//! **Smoothness.** Two polynomials of degree d over triangles (p, q, a) and (p, q, b) meet C^r along the common edge if and only if their polar
//! forms agree at p^i q^j b^m for i + j + m = d and m ≤ r. The values of the first are combinations of its Bézier points, by
//! b = λ_1 p + λ_2 q + λ_3 a; those of the second are Bézier points. These linear equations have the spline space as their null space.
//!
//! **Clough–Tocher.** A triangle split at an inner point s: cubics, C^1, with 12 degrees of freedom: values and gradients at the
//! corners, and the derivative across each edge at its midpoint.
//!
//! **Powell–Sabin.** Split into six by an inner point z and a point on each edge: quadratics, C^1, with 9 degrees of freedom: values and
//! gradients at the corners.
//!
//! R. W. Clough, J. L. Tocher, "Finite element stiffness matrices for analysis of plate bending" (1965); M. J. D. Powell, M. A. Sabin,
//! "Piecewise quadratic approximations on triangles", ACM TOMS 3 (1977); M.-J. Lai, L. L. Schumaker, "Spline Functions on
//! Triangulations" (2007).

use std::collections::BTreeMap;

use nalgebra::DMatrix;
use num_traits::{Signed, Zero};

use super::{CurveError, Point, Triangle, TrianglePatch, Vector, indices, lerp};
use crate::budget;
use crate::math::linalg::rank;
use crate::math::number::{Rational, multinomial, rational};
use crate::math::ring::{Field, Ring};

/// The corners of an edge, and its two triangles, each with its opposite corner.
type InnerEdge = ([usize; 2], [(usize, usize); 2]);

/// Triangles with common corners and edges.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangulation {
    points: Vec<[Rational; 2]>,
    triangles: Vec<[usize; 3]>,
    inner: Vec<InnerEdge>,
}

/// Twice the signed area.
fn turn(p: &[Rational; 2], q: &[Rational; 2], r: &[Rational; 2]) -> Rational {
    (&q[0] - &p[0]) * (&r[1] - &p[1]) - (&q[1] - &p[1]) * (&r[0] - &p[0])
}

impl Triangulation {
    /// Triangles by the numbers of their corners.
    ///
    /// Cost: a comparison of each point with each edge.
    ///
    /// # Errors
    /// [`CurveError::Degenerate`] for a triangle without an area, [`CurveError::Impossible`] for a number without a point, for
    /// triangles that overlap at a common edge, for an edge of three triangles and for a point inside of an edge.
    pub fn new(points: Vec<[Rational; 2]>, triangles: Vec<[usize; 3]>) -> Result<Self, CurveError> {
        let mut edges: BTreeMap<[usize; 2], Vec<(usize, usize)>> = BTreeMap::new();
        for (k, triangle) in triangles.iter().enumerate() {
            if triangle.iter().any(|&i| i >= points.len()) {
                return Err(CurveError::Impossible {
                    why: "a triangle has a corner that is not in the list",
                });
            }
            let [a, b, c] = triangle.map(|i| &points[i]);
            if turn(a, b, c).is_zero() {
                return Err(CurveError::Degenerate);
            }
            for i in 0..3 {
                let (p, q) = (triangle[(i + 1) % 3], triangle[(i + 2) % 3]);
                edges.entry([p.min(q), p.max(q)]).or_default().push((k, triangle[i]));
            }
        }
        let mut inner = Vec::new();
        for (&[p, q], sides) in &edges {
            budget::steps(points.len() as u32);
            let on_edge = |x: &[Rational; 2]| {
                let (a, b) = (&points[p], &points[q]);
                let dot = (&x[0] - &a[0]) * (&x[0] - &b[0]) + (&x[1] - &a[1]) * (&x[1] - &b[1]);
                turn(a, b, x).is_zero() && dot.is_negative()
            };
            if points.iter().any(on_edge) {
                return Err(CurveError::Impossible { why: "a point lies inside of an edge" });
            }
            match sides.as_slice() {
                [_] => {}
                [first, second] => {
                    let side = |x: usize| turn(&points[p], &points[q], &points[x]).is_positive();
                    if side(first.1) == side(second.1) {
                        return Err(CurveError::Impossible { why: "two triangles overlap at a common edge" });
                    }
                    inner.push(([p, q], [*first, *second]));
                }
                _ => return Err(CurveError::Impossible { why: "an edge belongs to three triangles" }),
            }
        }
        inner.sort();
        Ok(Triangulation { points, triangles, inner })
    }

    /// The conditions for C^r on the Bézier points of degree d of all triangles, one after the other in the order of [`indices`].
    ///
    /// Cost: as many entries as written.
    pub fn smoothness(&self, d: usize, r: usize) -> DMatrix<Rational> {
        let count = (d + 1) * (d + 2) / 2;
        let orders = 0..=r.min(d);
        let rows: usize = orders.clone().map(|m| d + 1 - m).sum::<usize>() * self.inner.len();
        let columns = count * self.triangles.len();
        budget::charge_terms((rows as u64).saturating_mul(columns as u64));
        let mut matrix = DMatrix::from_element(rows, columns, Rational::zero());
        let places: BTreeMap<[usize; 3], usize> = indices(d).into_iter().zip(0..).collect();
        let place = |k: usize, powers: &[(usize, usize)]| {
            let exponent =
                |corner: usize| powers.iter().filter(|(x, _)| *x == corner).map(|(_, e)| e).sum::<usize>();
            k * count + places[&self.triangles[k].map(exponent)]
        };
        let mut row = 0;
        for ([p, q], [(first, a), (second, b)]) in &self.inner {
            let [x, y, z, o] = [p, q, a, b].map(|&i| &self.points[i]);
            let area = turn(x, y, z);
            let lambda = [turn(o, y, z) / &area, turn(x, o, z) / &area, turn(x, y, o) / &area];
            for m in orders.clone() {
                for i in 0..=d - m {
                    budget::step();
                    let j = d - m - i;
                    matrix[(row, place(*second, &[(*p, i), (*q, j), (*b, m)]))] += rational(1, 1);
                    for [alpha, beta, gamma] in indices(m) {
                        let weight = Rational::from_integer(multinomial(&[alpha, beta, gamma]))
                            * lambda[0].powered(alpha as u32)
                            * lambda[1].powered(beta as u32)
                            * lambda[2].powered(gamma as u32);
                        matrix[(row, place(*first, &[(*p, i + alpha), (*q, j + beta), (*a, gamma)]))] -=
                            weight;
                    }
                    row += 1;
                }
            }
        }
        matrix
    }

    /// The dimension of the space of piecewise polynomials of degree d that are C^r, exactly for these points.
    ///
    /// Cost: the rank of [`Triangulation::smoothness`].
    ///
    /// ```
    /// use polarform::curve::Triangulation;
    /// use polarform::number::integer as z;
    /// // A triangle split at an inner point: cubics, C^1.
    /// let points = [[0, 0], [3, 0], [0, 3], [1, 1]].map(|p| p.map(z)).to_vec();
    /// let split = Triangulation::new(points, vec![[0, 1, 3], [1, 2, 3], [2, 0, 3]])?;
    /// assert_eq!(split.dimension(3, 1), 12);
    /// # Ok::<(), polarform::curve::CurveError>(())
    /// ```
    pub fn dimension(&self, d: usize, r: usize) -> usize {
        let matrix = self.smoothness(d, r);
        matrix.ncols() - rank(&matrix)
    }
}

/// Value and gradient at a corner.
#[derive(Clone, Debug, PartialEq)]
pub struct CornerData<C> {
    /// f
    pub value: C,
    /// (f_x, f_y)
    pub gradient: [C; 2],
}

impl<C: Field> CornerData<C> {
    /// f + ∇f (x − p)/n: the Bézier point of degree n next to the corner p towards x.
    fn towards(&self, p: &Point<C>, x: &Point<C>, n: i64) -> C {
        let slope = self.along(&(x - p)).scaled(&rational(1, n));
        self.value.plus(&slope)
    }

    /// The derivative in a direction.
    fn along(&self, v: &Vector<C>) -> C {
        self.gradient[0].times(&v[0]).plus(&self.gradient[1].times(&v[1]))
    }
}

/// Three points in the plane that have an area.
fn corners_of<C: Field>(triangle: &Triangle<C>) -> [Point<C>; 3] {
    triangle.corners().clone()
}

/// The element of Clough and Tocher, split at a point s inside, or at the centroid: a cubic patch over (p_i, p_{i+1}, s) for each edge. `across` has the derivatives at the
/// midpoints of the edges in the direction of p_{i+1} − p_i turned to the left; where it is `None` they are the means of those at the ends.
///
/// ```
/// use polarform::curve::{CornerData, Triangle, clough_tocher};
/// use polarform::number::{integer as z, rational as q};
/// // x² y
/// let at = |x: i64, y: i64| CornerData { value: z(x * x * y), gradient: [z(2 * x * y), z(x * x)] };
/// let across = [q(1, 4), q(-3, 4), q(0, 1)]; // y-derivative at (1/2, 0); −f_x − f_y at (1/2, 1/2); f_x at (0, 1/2)
/// let triangle = Triangle::new([[0, 0], [1, 0], [0, 1]].map(|p| p.map(z).to_vec()))?;
/// let patches = clough_tocher(&triangle, &[at(0, 0), at(1, 0), at(0, 1)], Some(&across), None)?;
/// assert_eq!(patches[0].value(&[q(1, 3), q(1, 6)])?, [q(1, 54)]);
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn clough_tocher<C: Field>(
    triangle: &Triangle<C>,
    data: &[CornerData<C>; 3],
    across: Option<&[C; 3]>,
    split: Option<&Point<C>>,
) -> Result<[TrianglePatch<C>; 3], CurveError> {
    let p = corners_of(triangle);
    let third = rational(1, 3);
    let s = split.cloned().unwrap_or_else(|| centroid(&p));
    let lambda = triangle.barycentric(&s)?;
    for i in 0..3 {
        // On an edge one of the small triangles has no area.
        Triangle::new([p[i].clone(), p[(i + 1) % 3].clone(), s.clone()])?;
    }
    let edge = |i: usize| {
        let (a, b) = (&p[i], &p[(i + 1) % 3]);
        let (f, g) = (&data[i], &data[(i + 1) % 3]);
        let along = b - a;
        let normal = Vector::from([-along[1].clone(), along[0].clone()]);
        let slope = match across {
            Some(list) => list[i].clone(),
            None => f.along(&normal).plus(&g.along(&normal)).scaled(&rational(1, 2)),
        };
        let near = [f.value.clone(), f.towards(a, b, 3), g.towards(b, a, 3), g.value.clone()];
        let inner = [f.towards(a, &s, 3), g.towards(b, &s, 3)];
        // The normal as α a + β b + γ s with sum 0; D F(m) = 3 f(m, m, ν).
        let small = Triangle::new([a.clone(), b.clone(), s.clone()]).expect("the point is on no edge");
        let [alpha, beta, gamma] = small
            .coordinates(&crate::math::blossom::Argument::Vector(normal.to_vec()))
            .expect("a vector of the plane");
        let quarter = rational(1, 4);
        let mean = |x: &C, y: &C, z: &C| x.plus(&y.scaled(&rational(2, 1))).plus(z).scaled(&quarter);
        let rest = slope
            .scaled(&third)
            .minus(&alpha.times(&mean(&near[0], &near[1], &near[2])))
            .minus(&beta.times(&mean(&near[1], &near[2], &near[3])));
        // γ (inner_0 + 2 c + inner_1)/4 = rest
        let four = rational(4, 1);
        let whole = (rest / gamma).scaled(&four);
        let middle = whole.minus(&inner[0]).minus(&inner[1]).scaled(&rational(1, 2));
        (near, inner, middle)
    };
    let edges = [edge(0), edge(1), edge(2)];
    // f(p_i, s, s) by s = Σ λ_j p_j, and f(s, s, s).
    let spoke: [C; 3] = std::array::from_fn(|i| {
        let (next, before) = ((i + 1) % 3, (i + 2) % 3);
        let own = data[i].towards(&p[i], &s, 3).times(&lambda[i]);
        own.plus(&edges[i].2.times(&lambda[next])).plus(&edges[before].2.times(&lambda[before]))
    });
    let top = spoke.iter().zip(&lambda).fold(C::zero(), |sum, (x, l)| sum.plus(&x.times(l)));
    Ok(std::array::from_fn(|i| {
        let j = (i + 1) % 3;
        let (near, inner, middle) = &edges[i];
        // In the order of indices: 300, 210, 201, 120, 111, 102, 030, 021, 012, 003.
        let list = [
            &near[0], &near[1], &inner[0], &near[2], middle, &spoke[i], &near[3], &inner[1], &spoke[j], &top,
        ];
        let points = list.iter().map(|x| vec![(*x).clone()]).collect();
        let small = Triangle::new([p[i].clone(), p[j].clone(), s.clone()]).expect("the point is on no edge");
        TrianglePatch::new(points, small).expect("ten points are a cubic patch")
    }))
}

/// The mean of the corners.
fn centroid<C: Field>(p: &[Point<C>; 3]) -> Point<C> {
    let third = rational(1, 3);
    (0..2).map(|k| p.iter().fold(C::zero(), |sum, x| sum.plus(&x[k])).scaled(&third)).collect()
}

/// The element of Powell and Sabin, split at a point z inside, or at the centroid, and at e_i = (1 − t_i) p_i + t_i p_{i+1} on the edges, or at their
/// midpoints: quadratic patches over (p_i, e_i, z) and (e_i, p_{i+1}, z) for each edge. Elements of two neighbours meet C^1 if e_i lies on the line
/// between their inner points.
///
/// # Errors
/// [`CurveError::Degenerate`] for points on other edges, where parts have no area.
///
/// ```
/// use polarform::curve::{CornerData, Triangle, powell_sabin};
/// use polarform::number::{integer as z, rational as q};
/// // x y
/// let at = |x: i64, y: i64| CornerData { value: z(x * y), gradient: [z(y), z(x)] };
/// let triangle = Triangle::new([[0, 0], [1, 0], [0, 1]].map(|p| p.map(z).to_vec()))?;
/// let patches = powell_sabin(&triangle, &[at(0, 0), at(1, 0), at(0, 1)], None, None)?;
/// assert_eq!(patches[0].value(&[q(1, 3), q(1, 6)])?, [q(1, 18)]);
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn powell_sabin<C: Field>(
    triangle: &Triangle<C>,
    data: &[CornerData<C>; 3],
    split: Option<&Point<C>>,
    edges: Option<&[C; 3]>,
) -> Result<Vec<TrianglePatch<C>>, CurveError> {
    let p = corners_of(triangle);
    let z = split.cloned().unwrap_or_else(|| centroid(&p));
    let lambda = triangle.barycentric(&z)?;
    let half = C::from_rational(&rational(1, 2));
    let to_z: [C; 3] = std::array::from_fn(|i| data[i].towards(&p[i], &z, 2));
    let top = to_z.iter().zip(&lambda).fold(C::zero(), |sum, (x, l)| sum.plus(&x.times(l)));
    let mut patches = Vec::with_capacity(6);
    for i in 0..3 {
        let j = (i + 1) % 3;
        let t = edges.map_or(&half, |list| &list[i]);
        let mean = |x: &C, y: &C| x.plus(&y.minus(x).times(t));
        let e = lerp(&p[i], &p[j], t);
        let (left, right) = (data[i].towards(&p[i], &e, 2), data[j].towards(&p[j], &e, 2));
        let (middle, up) = (mean(&left, &right), mean(&to_z[i], &to_z[j]));
        // In the order of indices: 200, 110, 101, 020, 011, 002.
        let mut patch = |corners: [&Point<C>; 3], list: [&C; 6]| -> Result<(), CurveError> {
            let small = Triangle::new(corners.map(Clone::clone))?;
            let points = list.iter().map(|x| vec![(*x).clone()]).collect();
            patches.push(TrianglePatch::new(points, small)?);
            Ok(())
        };
        patch([&p[i], &e, &z], [&data[i].value, &left, &to_z[i], &middle, &up, &top])?;
        patch([&e, &p[j], &z], [&middle, &right, &up, &data[j].value, &to_z[j], &top])?;
    }
    Ok(patches)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::integer as z;
    use proptest::prelude::*;

    fn corner(f: &[Rational], p: &Point<Rational>) -> CornerData<Rational> {
        // f by the monomials 1, x, y, x², xy, y², x³, x²y, xy², y³.
        let (x, y) = (&p[0], &p[1]);
        let monomials =
            [z(1), x.clone(), y.clone(), x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y];
        let by_x = [z(0), z(1), z(0), x * z(2), y.clone(), z(0), x * x * z(3), x * y * z(2), y * y, z(0)];
        let by_y = [z(0), z(0), z(1), z(0), x.clone(), y * z(2), z(0), x * x, x * y * z(2), y * y * z(3)];
        let sum = |list: [Rational; 10]| list.iter().zip(f).map(|(m, c)| m * c).sum::<Rational>();
        CornerData { value: sum(monomials), gradient: [sum(by_x), sum(by_y)] }
    }

    /// The C^1 conditions along every common edge, by values and derivatives at points of it.
    fn smooth(patches: &[TrianglePatch<Rational>]) -> bool {
        let same = |a: &Point<Rational>, b: &Point<Rational>| a == b;
        patches.iter().enumerate().all(|(k, left)| {
            patches[k + 1..].iter().all(|right| {
                let shared: Vec<&Point<Rational>> = left
                    .triangle()
                    .corners()
                    .iter()
                    .filter(|p| right.triangle().corners().iter().any(|q| same(p, q)))
                    .collect();
                let [p, q] = shared.as_slice() else { return true };
                [0, 1, 2, 3, 4].iter().all(|&t| {
                    let x = lerp(p, q, &rational(t, 4));
                    let derivative = |patch: &TrianglePatch<Rational>, r, s| {
                        patch.partial_derivative(r, s).value(&x).unwrap()
                    };
                    [(0, 0), (1, 0), (0, 1)]
                        .iter()
                        .all(|&(r, s)| derivative(left, r, s) == derivative(right, r, s))
                })
            })
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        /// Elements interpolate, are C^1, and reproduce polynomials of their degree.
        #[test]
        fn elements_are_smooth_and_exact(
            points in prop::collection::vec((-4i64..5, -4i64..5), 3), f in prop::collection::vec(-3i64..4, 10),
            data in prop::collection::vec(prop::collection::vec(-4i64..5, 3), 3), across in prop::collection::vec(-4i64..5, 3),
        ) {
            let p: Vec<Point<Rational>> = points.iter().map(|&(x, y)| [z(x), z(y)].into()).collect();
            let Ok(triangle) = Triangle::new([p[0].clone(), p[1].clone(), p[2].clone()]) else { return Ok(()) };
            let data: [CornerData<Rational>; 3] =
                std::array::from_fn(|i| CornerData { value: z(data[i][0]), gradient: [z(data[i][1]), z(data[i][2])] });
            let across: [Rational; 3] = std::array::from_fn(|i| z(across[i]));
            // A point inside, and ratios between 0 and 1, of their own for each case.
            let weights: [Rational; 3] = std::array::from_fn(|i| z(6) + &data[i].value);
            let whole: Rational = weights.iter().sum();
            let split: Point<Rational> =
                (0..2).map(|k| (0..3).map(|i| &p[i][k] * &weights[i]).sum::<Rational>() / &whole).collect();
            let ratios: [Rational; 3] = std::array::from_fn(|i| &weights[i] / &whole);
            let elements = clough_tocher(&triangle, &data, Some(&across), Some(&split)).unwrap();
            prop_assert!(smooth(&elements));
            prop_assert!(smooth(&clough_tocher(&triangle, &data, None, None).unwrap()));
            let quadratic = powell_sabin(&triangle, &data, Some(&split), Some(&ratios)).unwrap();
            prop_assert!(smooth(&powell_sabin(&triangle, &data, None, None).unwrap()));
            prop_assert!(smooth(&quadratic));
            for (i, datum) in data.iter().enumerate() {
                for patch in elements.iter().chain(&quadratic) {
                    if patch.triangle().corners().contains(&p[i]) {
                        prop_assert_eq!(&patch.value(&p[i]).unwrap()[0], &datum.value);
                        prop_assert_eq!(&patch.partial_derivative(1, 0).value(&p[i]).unwrap()[0], &datum.gradient[0]);
                        prop_assert_eq!(&patch.partial_derivative(0, 1).value(&p[i]).unwrap()[0], &datum.gradient[1]);
                    }
                }
                let middle = lerp(&p[i], &p[(i + 1) % 3], &rational(1, 2));
                let edge = &p[(i + 1) % 3] - &p[i];
                let slope = |r, s| elements[i].partial_derivative(r, s).value(&middle).unwrap()[0].clone();
                prop_assert_eq!(slope(0, 1) * &edge[0] - slope(1, 0) * &edge[1], across[i].clone());
            }
            // Cubics, with their derivatives across the edges; quadratics.
            let f: Vec<Rational> = f.iter().map(|&c| z(c)).collect();
            let exact: [CornerData<Rational>; 3] = std::array::from_fn(|i| corner(&f, &p[i]));
            let normals: [Rational; 3] = std::array::from_fn(|i| {
                let (a, b) = (&p[i], &p[(i + 1) % 3]);
                let at = corner(&f, &lerp(a, b, &rational(1, 2)));
                let edge = b - a;
                at.gradient[1].clone() * &edge[0] - at.gradient[0].clone() * &edge[1]
            });
            let inside = |patch: &TrianglePatch<Rational>| {
                let [a, b, c] = patch.triangle().corners();
                lerp(&lerp(a, b, &rational(1, 3)), c, &rational(2, 5))
            };
            for patch in clough_tocher(&triangle, &exact, Some(&normals), Some(&split)).unwrap() {
                let x = inside(&patch);
                prop_assert_eq!(&patch.value(&x).unwrap()[0], &corner(&f, &x).value);
            }
            let low: Vec<Rational> = f.iter().enumerate().map(|(k, c)| if k < 6 { c.clone() } else { z(0) }).collect();
            let exact: [CornerData<Rational>; 3] = std::array::from_fn(|i| corner(&low, &p[i]));
            for patch in powell_sabin(&triangle, &exact, Some(&split), Some(&ratios)).unwrap() {
                let x = inside(&patch);
                prop_assert_eq!(&patch.value(&x).unwrap()[0], &corner(&low, &x).value);
            }
        }
    }

    #[test]
    fn dimensions_that_are_known() {
        let points = |list: &[[i64; 2]]| -> Vec<[Rational; 2]> { list.iter().map(|p| p.map(z)).collect() };
        let one = Triangulation::new(points(&[[0, 0], [1, 0], [0, 1]]), vec![[0, 1, 2]]).unwrap();
        assert_eq!(one.dimension(4, 2), 15);
        // Two triangles: (d+1)(d+2)/2 + (d−r)(d−r+1)/2.
        let two = Triangulation::new(points(&[[0, 0], [1, 0], [0, 1], [2, 3]]), vec![[0, 1, 2], [1, 3, 2]])
            .unwrap();
        for (d, r) in [(1, 0), (2, 1), (3, 1), (4, 2)] {
            assert_eq!(two.dimension(d, r), (d + 1) * (d + 2) / 2 + (d - r) * (d - r + 1) / 2);
        }
        // Powell and Sabin's split.
        let split = points(&[[0, 0], [6, 0], [0, 6], [2, 2], [3, 0], [3, 3], [0, 3]]);
        let six = vec![[0, 4, 3], [4, 1, 3], [1, 5, 3], [5, 2, 3], [2, 6, 3], [6, 0, 3]];
        assert_eq!(Triangulation::new(split, six).unwrap().dimension(2, 1), 9);
        // A quadrilateral with both diagonals has one C^1 quadratic more than with others: a singular vertex.
        let cross = |x: i64| {
            let p = points(&[[-4, 0], [0, -4], [4, 0], [x, 4], [0, 0]]);
            Triangulation::new(p, vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]).unwrap().dimension(2, 1)
        };
        assert_eq!((cross(0), cross(1)), (8, 7));
        // Morgan and Scott: the dimension depends on the symmetry.
        let morgan = |shift: i64| {
            let p = points(&[[-30, -17], [30, -17], [shift, 34], [0, -10], [9, 5], [-9, 5]]);
            let t = vec![[0, 1, 3], [1, 4, 3], [1, 2, 4], [2, 5, 4], [2, 0, 5], [0, 3, 5], [3, 4, 5]];
            Triangulation::new(p, t).unwrap().dimension(2, 1)
        };
        assert_eq!((morgan(0), morgan(4)), (7, 6));
    }

    #[test]
    fn what_is_no_triangulation() {
        let points: Vec<[Rational; 2]> = [[0, 0], [2, 0], [0, 2], [1, 0], [1, 1]].map(|p| p.map(z)).to_vec();
        let why = |t: Vec<[usize; 3]>| Triangulation::new(points.clone(), t).unwrap_err();
        assert_eq!(why(vec![[0, 1, 3]]), CurveError::Degenerate);
        assert!(matches!(why(vec![[0, 1, 2]]), CurveError::Impossible { .. }));
        assert!(matches!(why(vec![[0, 1, 9]]), CurveError::Impossible { .. }));
        assert!(matches!(why(vec![[0, 3, 2], [0, 3, 4]]), CurveError::Impossible { .. }));
    }
}
