//! Between tensor-product and triangular patches.
//!
//! A polynomial surface of degree (m, n) has total degree at most m + n, and one of total degree n
//! has degree at most n in each variable, so each kind is also of the other kind:
//!
//! g(p_1, …, p_{m+n}) = mean over the m-subsets S of f(u_S; v_{S^c}),  p_i = (u_i, v_i),
//! f(u_1, …, u_n; v_1, …, v_n) = mean over the permutations π of g((u_1, v_π(1)), …, (u_n, v_π(n))).
//!
//! The means are taken by way of the power coefficients. To lower degrees come exact reductions.
//!
//! References: R. N. Goldman, D. J. Filip, "Conversion from Bézier rectangles to Bézier
//! triangles", CAD 19 (1987); S.-M. Hu, "Conversion of a triangular Bézier patch into three
//! rectangular Bézier patches", CAGD 13 (1996).

use super::domain::Triangle;
use super::patch::{Net, TensorPatch};
use super::triangle::{TrianglePatch, place};
use super::{CurveError, Point, Vector, polygon};
use crate::math::blossom::TotalDegreePolarForm;
use crate::math::interval::Interval;
use crate::math::ring::Field;

impl<C: Field> TensorPatch<C> {
    /// The same surface as a triangular patch of degree m + n. Cost: that of the power
    /// coefficients and of O((m + n)²) polar values.
    ///
    /// # Errors
    /// [`CurveError::TooFewPoints`] for points without coordinates.
    ///
    /// ```
    /// use polarform::curve::{CurveError, Interval, TensorPatch, Triangle};
    /// use polarform::number::{integer as z, rational as q};
    /// let net = vec![vec![vec![z(0)], vec![z(0)]], vec![vec![z(0)], vec![z(1)]]]; // u v
    /// let patch = TensorPatch::new(net, Interval::unit(), Interval::unit())?;
    /// let triangle = patch.to_triangle(Triangle::unit())?;
    /// assert_eq!(triangle.degree(), 2);
    /// assert_eq!(triangle.points()[4], [q(1, 2)]); // b_011
    /// # Ok::<(), CurveError>(())
    /// ```
    pub fn to_triangle(&self, triangle: Triangle<C>) -> Result<TrianglePatch<C>, CurveError> {
        let (m, n) = self.degrees();
        let grid = self.power_coefficients();
        let form = |k: usize| {
            let terms = grid.iter().zip(0u32..).flat_map(|(row, i)| {
                row.iter().zip(0u32..).map(move |(point, j)| (vec![i, j], point[k].clone()))
            });
            TotalDegreePolarForm::new(2, m + n, terms).expect("exponents with sum at most m + n")
        };
        let forms: Vec<_> = (0..self.dimension()).map(form).collect();
        TrianglePatch::from_polar_forms(&forms, triangle)
    }
}

impl<C: Field> TrianglePatch<C> {
    /// The same surface as a tensor-product patch of degree (n, n) over a rectangle, u and v
    /// being the coordinates of the parameter plane.
    ///
    /// Often [`TensorPatch::exact_degrees`] are lower and [`TensorPatch::reduce`] gets there.
    pub fn to_tensor(&self, u: Interval<C>, v: Interval<C>) -> TensorPatch<C> {
        let n = self.degree();
        let zero = Vector::zero(self.dimension()).from_origin();
        let mut grid: Net<C> = vec![vec![zero; n + 1]; n + 1];
        for ([r, s], point) in self.power_coefficients() {
            grid[r][s] = point;
        }
        TensorPatch::from_power_coefficients(grid, u, v).expect("a full grid of equal dimension")
    }

    /// The surface over the triangle as a degenerate tensor-product patch of degree (n, n) over
    /// the unit square: (s, t) ↦ the surface point at (1 − s) a + s ((1 − t) b + t c).
    ///
    /// The side s = 0 is the single point at a. Row r of the net is row r of the triangle, a
    /// polygon of degree r, with the degree raised to n.
    pub fn to_degenerate_tensor(&self) -> TensorPatch<C> {
        let n = self.degree();
        let row = |r: usize| {
            let points: Vec<Point<C>> = (0..=r).map(|k| self.points()[place(r - k, k)].clone()).collect();
            polygon::elevated(&points, n - r)
        };
        TensorPatch::new((0..=n).map(row).collect(), Interval::unit(), Interval::unit())
            .expect("rows of n + 1 points of equal dimension")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::blossom::Argument;
    use crate::math::curve::{PolarValue, combination, patch, triangle};
    use crate::math::number::{Combinations, Rational, integer as z, rational as q};
    use proptest::prelude::*;

    fn mean(values: Vec<PolarValue<Rational>>) -> PolarValue<Rational> {
        let share = q(1, values.len() as i64);
        let points: Vec<_> = values.into_iter().map(PolarValue::into_point).collect();
        let total = combination(points[0].len(), points.iter().map(|point| (&share, point)));
        PolarValue::Point(total.from_origin())
    }

    fn permutations(n: usize) -> Vec<Vec<usize>> {
        if n == 0 {
            return vec![vec![]];
        }
        let insert = |p: &Vec<usize>, at: usize| {
            let mut p = p.clone();
            p.insert(at, n - 1);
            p
        };
        permutations(n - 1).iter().flat_map(|p| (0..n).map(|at| insert(p, at)).collect::<Vec<_>>()).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        #[test]
        fn rectangles_to_triangles(patch in patch::tests::any_patch(2), over in triangle::tests::any_triangle(),
                                   p in prop::collection::vec((-5i64..6).prop_map(z), 12)) {
            let (m, n) = patch.degrees();
            let triangle = patch.to_triangle(over.clone()).unwrap();
            prop_assert_eq!(triangle.value(&p[..2]).unwrap(), patch.value(&p[0], &p[1]));
            // polar values as means over subsets
            let points: Vec<Vec<Rational>> = p.chunks(2).take(m + n).map(<[_]>::to_vec).collect();
            let at = |k: usize, list: &[usize]| -> Vec<Argument<Rational>> {
                list.iter().map(|&i| Argument::Point(points[i][k].clone())).collect()
            };
            let values = Combinations::new(m + n, m).map(|chosen| {
                let others: Vec<usize> = (0..m + n).filter(|i| !chosen.contains(i)).collect();
                patch.blossom(&at(0, &chosen), &at(1, &others)).unwrap()
            });
            let arguments: Vec<_> = points.iter().cloned().map(Argument::Point).collect();
            prop_assert_eq!(mean(values.collect()), triangle.blossom(&arguments).unwrap());
            // and back
            let tensor = triangle.to_tensor(patch.u().clone(), patch.v().clone());
            prop_assert_eq!(tensor.reduce(n, m).unwrap(), patch.clone());
        }

        #[test]
        fn triangles_to_rectangles(patch in triangle::tests::any_patch(2),
                                   p in prop::collection::vec((-5i64..6).prop_map(z), 6), s in 0i64..5, t in 0i64..5) {
            let n = patch.degree();
            let (u, v) = (Interval::new(z(-1), z(3)).unwrap(), Interval::new(z(2), z(1)).unwrap());
            let tensor = patch.to_tensor(u, v);
            let list = |k: usize| -> Vec<Argument<Rational>> {
                (0..n).map(|i| Argument::Point(p[2 * i + k].clone())).collect()
            };
            let values = permutations(n).into_iter().map(|order| {
                let paired = |(i, j): (usize, usize)| {
                    Argument::Point(vec![p[2 * i].clone(), p[2 * j + 1].clone()])
                };
                patch.blossom(&order.into_iter().enumerate().map(paired).collect::<Vec<_>>()).unwrap()
            });
            prop_assert_eq!(mean(values.collect()), tensor.blossom(&list(0), &list(1)).unwrap());
            let back = tensor.to_triangle(patch.triangle().clone()).unwrap();
            prop_assert_eq!(back.reduce(back.degree() - n).unwrap(), patch.clone());

            let (s, t) = (q(s, 4), q(t, 4));
            let lambda = [z(1) - &s, &s * (z(1) - &t), &s * &t];
            let point = patch.triangle().point(&lambda);
            prop_assert_eq!(patch.to_degenerate_tensor().value(&s, &t), patch.value(&point).unwrap());
        }
    }

    #[test]
    fn degrees_that_are_too_low() {
        let net = vec![vec![vec![z(0)], vec![z(0)]], vec![vec![z(0)], vec![z(1)]]];
        let patch = TensorPatch::new(net, Interval::unit(), Interval::unit()).unwrap();
        let error = CurveError::NotReducible { degree: 2, exact: 2, by: 1 };
        assert_eq!(patch.to_triangle(Triangle::unit()).unwrap().reduce(1), Err(error));
        let empty = TensorPatch::new(vec![vec![vec![]]], Interval::<Rational>::unit(), Interval::unit());
        assert!(empty.unwrap().to_triangle(Triangle::unit()).is_err());
    }
}
