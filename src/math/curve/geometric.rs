//! Geometric continuity: how two curves meet after a change of parameter.
//!
//! **Definition.** F at s and G at t meet G^k if there is a change of parameter φ with φ(t) = s and φ'(t) > 0 such that G and
//! F ∘ φ have the same derivatives up to order k at t. With β_j = φ^{(j)}(t), the chain rule (Faà di Bruno) says
//! G^{(j)} = Σ_i B_{j,i}(β_1, …, β_{j−i+1}) F^{(i)} for j ≤ k, where B_{0,0} = 1 and
//! B_{j,i} = Σ_m C(j − 1, m − 1) β_m B_{j−m,i−1} (Bell): the β-matrix, lower triangular with β_1^j on the diagonal.
//!
//! References: B. Barsky, T. DeRose, "Geometric continuity of parametric curves", IEEE CG&A 9 (1989); L. Comtet, "Advanced
//! Combinatorics", section 3.3.

use nalgebra::DMatrix;
use num_traits::Signed;

use super::{BezierCurve, CurveError, Vector};
use crate::budget;
use crate::math::number::{Rational, binomial};
use crate::math::ring::{Field, Ring};

/// The β-matrix of order k for β_1, …, β_k, with k + 1 rows and columns. Cost: k³/6 products.
///
/// ```
/// use polarform::curve::beta_matrix;
/// use polarform::number::integer as z;
/// let m = beta_matrix(&[2, 3, 5].map(z));
/// // G''' = β_1³ F''' + 3 β_1 β_2 F'' + β_3 F'
/// assert_eq!(m.row(3).iter().cloned().collect::<Vec<_>>(), [0, 5, 18, 8].map(z));
/// ```
pub fn beta_matrix<C: Ring>(betas: &[C]) -> DMatrix<C> {
    let k = betas.len();
    budget::charge_terms((k as u64 + 1).saturating_mul(k as u64 + 1));
    let mut bell = DMatrix::from_element(k + 1, k + 1, C::zero());
    bell[(0, 0)] = C::one();
    for j in 1..=k {
        for i in 1..=j {
            budget::step();
            let mut sum = C::zero();
            for m in 1..=j - i + 1 {
                let factor = Rational::from_integer(binomial(j - 1, m - 1));
                sum += betas[m - 1].times(&bell[(j - m, i - 1)]).scaled(&factor);
            }
            bell[(j, i)] = sum;
        }
    }
    bell
}

/// What the derivatives of order 0, …, k of G have to be: the β-matrix times those of F.
pub fn transferred<C: Ring>(derivatives: &[Vector<C>], betas: &[C]) -> Vec<Vector<C>> {
    let matrix = beta_matrix(betas);
    let dimension = derivatives.first().map_or(0, |v| v.len());
    let row = |j: usize| {
        let terms = derivatives.iter().enumerate().take(j + 1);
        terms.fold(Vector::zero(dimension), |sum, (i, v)| sum + &(v * &matrix[(j, i)]))
    };
    (0..=betas.len()).map(row).collect()
}

/// Up to which order two curves meet geometrically, with the change of parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct GeometricContinuity {
    /// The largest order with G^k, of those that were asked for; `None` if the points differ.
    pub order: Option<usize>,
    /// β_1, β_2, …, as far as there are any.
    pub betas: Vec<Rational>,
    /// Why the next order fails.
    pub failure: Option<GeometricFailure>,
}

/// Why two curves do not meet with a higher geometric continuity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GeometricFailure {
    /// The end of the first curve is not the start of the second.
    PointsDiffer,
    /// A derivative vanishes: the tangent is not given by it.
    NotRegular,
    /// The tangents have different directions.
    TangentsDiffer,
    /// The tangents are opposite: a cusp.
    Opposite,
    /// G'' − β_1² F'' is not parallel to the tangent: the curvatures differ.
    CurvaturesDiffer,
    /// G^{(k)} − Σ_{i ≥ 2} B_{k,i} F^{(i)} is not parallel to the tangent for some k ≥ 3.
    HigherDiffer,
}

/// The s with q = s p, if there is one (p ≠ 0).
fn ratio(p: &Vector<Rational>, q: &Vector<Rational>) -> Option<Rational> {
    let k = p.iter().position(|x| !num_traits::Zero::is_zero(x))?;
    let s = &q[k] / &p[k];
    (p * &s == *q).then_some(s)
}

/// How smoothly two curves meet geometrically, up to G^k, where the first interval ends. Each β_j is determined, since F' ≠ 0.
///
/// Cost: k derivatives of both, and k⁴ products.
///
/// # Errors
/// [`CurveError::DimensionsOf`].
pub fn geometric_continuity(
    left: &BezierCurve<Rational>,
    right: &BezierCurve<Rational>,
    k: usize,
) -> Result<GeometricContinuity, CurveError> {
    if left.dimension() != right.dimension() {
        return Err(CurveError::DimensionsOf { left: left.dimension(), right: right.dimension() });
    }
    let f = jet(left, left.interval().end(), k);
    let g = jet(right, right.interval().start(), k);
    let report = |order, betas, failure| GeometricContinuity { order, betas, failure };
    if f[0] != g[0] {
        return Ok(report(None, Vec::new(), Some(GeometricFailure::PointsDiffer)));
    }
    let mut betas: Vec<Rational> = Vec::new();
    for j in 1..=k {
        let failure = if f[1].is_zero() || g[1].is_zero() {
            Some(GeometricFailure::NotRegular)
        } else {
            // With β_j = 0 everything but β_j F'.
            let known: Vec<Rational> = betas.iter().cloned().chain([num_traits::Zero::zero()]).collect();
            let rest = &g[j] - &transferred(&f[..=j], &known)[j];
            match ratio(&f[1], &rest) {
                Some(beta) if j == 1 && beta.is_negative() => Some(GeometricFailure::Opposite),
                Some(beta) => {
                    betas.push(beta);
                    None
                }
                None => Some(match j {
                    1 => GeometricFailure::TangentsDiffer,
                    2 => GeometricFailure::CurvaturesDiffer,
                    _ => GeometricFailure::HigherDiffer,
                }),
            }
        };
        if failure.is_some() {
            return Ok(report(Some(j - 1), betas, failure));
        }
    }
    Ok(report(Some(k), betas, None))
}

/// The derivatives of order 0, …, k at a parameter.
pub fn jet<C: Field>(curve: &BezierCurve<C>, at: &C, k: usize) -> Vec<Vector<C>> {
    (0..=k).map(|j| curve.nth_derivative(j).value(at).position()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::blossom::PolarForm;
    use crate::math::curve::Interval;
    use crate::math::curve::bezier::tests::any_curve;
    use crate::math::number::{integer as z, rational as q};
    use crate::math::poly::Poly;
    use proptest::prelude::*;

    proptest! {
        /// A regular change of parameter keeps G^k and its derivatives are found; a point moved across the tangent breaks it.
        #[test]
        fn a_change_of_parameter_is_found(
            f in any_curve(), b1 in 1i64..5, others in prop::collection::vec(-4i64..5, 3), broken in 1usize..5,
        ) {
            let b = f.interval().end();
            let inner: Vec<Rational> = [b.clone(), z(b1)].into_iter().chain(others.iter().map(|&c| z(c))).collect();
            let polynomial: Poly = inner.iter().cloned().collect();
            let g = f.compose(&PolarForm::new(inner), Interval::unit()).unwrap();
            let report = geometric_continuity(&f, &g, 4).unwrap();
            let tangent = f.derivative().value(b);
            if tangent.iter().all(num_traits::Zero::is_zero) {
                prop_assert_eq!(report.failure, Some(GeometricFailure::NotRegular));
                return Ok(());
            }
            prop_assert_eq!(report.order, Some(4));
            let betas: Vec<Rational> = (1..=4).map(|j| polynomial.nth_derivative(j).value(&z(0))).collect();
            prop_assert_eq!(&report.betas, &betas);
            prop_assert_eq!(transferred(&jet(&f, b, 4), &betas), jet(&g, &z(0), 4));
            if f.dimension() == 2 && broken <= g.degree() {
                let mut points = g.points().to_vec();
                points[broken][0] -= tangent[1].clone();
                points[broken][1] += tangent[0].clone();
                let g = BezierCurve::new(points, Interval::unit()).unwrap();
                prop_assert_eq!(geometric_continuity(&f, &g, 4).unwrap().order, Some(broken - 1));
            }
        }
    }

    #[test]
    fn geometric_failures() {
        let curve = |points: &[[i64; 2]], end: Rational| {
            let points = points.iter().map(|p| p.map(z).to_vec()).collect();
            BezierCurve::new(points, Interval::new(z(0), end).unwrap()).unwrap()
        };
        let line = |p: [i64; 2], r: [i64; 2]| curve(&[p, r], z(1));
        let start = line([0, 0], [1, 0]);
        let failure = |next: &BezierCurve<Rational>| geometric_continuity(&start, next, 3).unwrap().failure;
        assert_eq!(failure(&line([2, 0], [3, 0])), Some(GeometricFailure::PointsDiffer));
        assert_eq!(failure(&line([1, 0], [1, 0])), Some(GeometricFailure::NotRegular));
        assert_eq!(failure(&line([1, 0], [1, 1])), Some(GeometricFailure::TangentsDiffer));
        assert_eq!(failure(&line([1, 0], [0, 0])), Some(GeometricFailure::Opposite));
        assert_eq!(failure(&line([1, 0], [7, 0])), None);
        assert_eq!(
            failure(&curve(&[[1, 0], [2, 0], [3, 1]], z(1))),
            Some(GeometricFailure::CurvaturesDiffer)
        );
        let late = curve(&[[1, 0], [2, 0], [3, 0], [4, 1]], q(1, 2));
        let report = geometric_continuity(&start, &late, 3).unwrap();
        assert_eq!((report.order, report.failure), (Some(2), Some(GeometricFailure::HigherDiffer)));
    }
}
