//! Affine combinations, frames and barycentric coordinates, in any dimension.
//!
//! Points p_0, …, p_k are affinely independent iff the vectors p_i − p_0 are linearly
//! independent. Over k + 1 independent points each point of their span has unique barycentric
//! coordinates λ_i with Σ λ_i p_i = p and Σ λ_i = 1; by Cramer's rule they are quotients of
//! signed volumes.
//!
//! Reference: J. Gallier, *Curves and Surfaces in Geometric Modeling* (2000), chapter 2.

use nalgebra::DMatrix;

use super::{CurveError, Point, PolarValue, combination, dimension};
use crate::math::blossom::Argument;
use crate::math::linalg::{self, multiply};
use crate::math::ring::Field;

/// Σ w_i p_i: a point if the weights sum to 1, else a vector, which does not depend on the origin if
/// they sum to 0.
///
/// # Errors
/// [`CurveError::WeightCount`], [`CurveError::Dimensions`].
///
/// ```
/// use polarform::blossom::Argument;
/// use polarform::curve::{Point, affine::affine_combination};
/// use polarform::number::{integer as z, rational as q};
/// let points = [[z(0), z(0)], [z(2), z(4)]];
/// let points = points.map(Point::from);
/// let middle = affine_combination(&points, &[q(1, 2), q(1, 2)])?;
/// assert_eq!(middle, Argument::Point([z(1), z(2)].into()));
/// let edge = affine_combination(&points, &[z(-1), z(1)])?;
/// assert_eq!(edge, Argument::Vector([z(2), z(4)].into()));
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn affine_combination<C: Field>(points: &[Point<C>], weights: &[C]) -> Result<PolarValue<C>, CurveError> {
    let size = dimension(points)?;
    if weights.len() != points.len() {
        return Err(CurveError::WeightCount { weights: weights.len(), points: points.len() });
    }
    let total = combination(size, weights.iter().zip(points));
    let is_point = weights.iter().fold(C::zero(), |sum, weight| sum.plus(weight)).is_one();
    Ok(if is_point { Argument::Point(total.from_origin()) } else { Argument::Vector(total) })
}

/// The dimension of the affine span of the points: the rank of the vectors p_i − p_0.
///
/// # Errors
/// As [`dimension`].
pub fn affine_rank<C: Field>(points: &[Point<C>]) -> Result<usize, CurveError> {
    let size = dimension(points)?;
    let rows = points.len() - 1;
    Ok(linalg::rank(&DMatrix::from_fn(rows, size, |i, j| points[i + 1][j].minus(&points[0][j]))))
}

/// Whether no point is an affine combination of the others.
///
/// # Errors
/// As [`dimension`].
///
/// ```
/// use polarform::curve::affine::affinely_independent;
/// use polarform::number::integer as z;
/// let line = [[0, 0], [1, 1], [2, 2]].map(|p| p.map(z).into());
/// assert_eq!(affinely_independent(&line), Ok(false));
/// ```
pub fn affinely_independent<C: Field>(points: &[Point<C>]) -> Result<bool, CurveError> {
    Ok(affine_rank(points)? + 1 == points.len())
}

/// The barycentric coordinates of p with respect to the corners of a simplex.
///
/// Solves Σ λ_i a_i = p, Σ λ_i = 1. Cost: one elimination of size k + 1.
///
/// # Errors
/// [`CurveError::Degenerate`] for affinely dependent corners, [`CurveError::Dimensions`], and
/// [`CurveError::Impossible`] if p is outside of the affine span.
///
/// ```
/// use polarform::curve::affine::barycentric;
/// use polarform::number::{integer as z, rational as q};
/// let corners = [[0, 0], [1, 0], [0, 1]].map(|p| p.map(z).into());
/// assert_eq!(barycentric(&corners, &[q(1, 3), q(1, 3)]), Ok(vec![q(1, 3), q(1, 3), q(1, 3)]));
/// ```
pub fn barycentric<C: Field>(corners: &[Point<C>], p: &[C]) -> Result<Vec<C>, CurveError> {
    let size = dimension(corners)?;
    if p.len() != size {
        return Err(CurveError::DimensionsOf { left: size, right: p.len() });
    }
    if !affinely_independent(corners)? {
        return Err(CurveError::Degenerate);
    }
    let k = corners.len();
    let system =
        DMatrix::from_fn(size + 1, k, |i, j| if i < size { corners[j][i].clone() } else { C::one() });
    let right = DMatrix::from_fn(size + 1, 1, |i, _| if i < size { p[i].clone() } else { C::one() });
    if k == size + 1 {
        let solved = linalg::solve(&system, &right).map_err(|_| CurveError::Degenerate)?;
        return Ok(solved.iter().cloned().collect());
    }
    // More equations than unknowns: solve the normal ones and see whether all hold.
    let transposed = system.transpose();
    let square = multiply(&transposed, &system).map_err(|_| CurveError::Degenerate)?;
    let projected = multiply(&transposed, &right).map_err(|_| CurveError::Degenerate)?;
    let solved = linalg::solve(&square, &projected).map_err(|_| CurveError::Degenerate)?;
    if multiply(&system, &solved).map_err(|_| CurveError::Degenerate)? != right {
        return Err(CurveError::Impossible { why: "the point lies outside of the span of the corners" });
    }
    Ok(solved.iter().cloned().collect())
}

/// d! times the signed volume of the simplex with d + 1 corners in dimension d: for a triangle
/// twice its signed area.
///
/// # Errors
/// [`CurveError::TooFewPoints`] if the number of corners is not d + 1, [`CurveError::Dimensions`].
#[cfg(test)]
pub(super) fn signed_volume<C: Field>(corners: &[Point<C>]) -> Result<C, CurveError> {
    let size = dimension(corners)?;
    if corners.len() != size + 1 {
        return Err(CurveError::TooFewPoints { needed: size + 1, given: corners.len() });
    }
    let matrix = DMatrix::from_fn(size, size, |i, j| corners[i + 1][j].minus(&corners[0][j]));
    linalg::determinant(&matrix).map_err(|_| CurveError::Degenerate)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{Rational, integer as z, rational as q};
    use num_traits::{One, Zero};
    use proptest::prelude::*;

    fn points(count: usize, size: usize) -> impl Strategy<Value = Vec<Point<Rational>>> {
        let point = prop::collection::vec((-9i64..10).prop_map(z), size).prop_map(Point::from);
        prop::collection::vec(point, count)
    }

    proptest! {
        #[test]
        fn barycentric_coordinates_reproduce_the_point(
            corners in points(4, 3), p in points(1, 3)
        ) {
            let p = &p[0];
            match barycentric(&corners, p) {
                Ok(weights) => {
                    prop_assert!(weights.iter().sum::<Rational>().is_one());
                    prop_assert_eq!(affine_combination(&corners, &weights).unwrap(), Argument::Point(p.clone()));
                    // Cramer: each is a quotient of signed volumes
                    let whole = signed_volume(&corners).unwrap();
                    for (i, weight) in weights.iter().enumerate() {
                        let mut replaced = corners.clone();
                        replaced[i] = p.clone();
                        prop_assert_eq!(signed_volume(&replaced).unwrap(), weight * &whole);
                    }
                }
                Err(error) => {
                    prop_assert_eq!(error, CurveError::Degenerate);
                    prop_assert!(signed_volume(&corners).unwrap().is_zero());
                }
            }
        }
    }

    #[test]
    fn corners_that_do_not_span_space() {
        let line = [[z(0), z(0)], [z(2), z(4)]].map(Point::from);
        assert_eq!(barycentric(&line, &[z(1), z(2)]), Ok(vec![q(1, 2), q(1, 2)]));
        assert!(matches!(barycentric(&line, &[z(1), z(1)]), Err(CurveError::Impossible { .. })));
        assert_eq!(affine_rank(&[[z(3)], [z(3)]].map(Point::from)), Ok(0));
        assert!(matches!(affine_rank::<Rational>(&[]), Err(CurveError::TooFewPoints { .. })));
    }
}
