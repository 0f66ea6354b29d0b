//! Limit points and derivatives by stencils.

use nalgebra::DMatrix;

use super::{Contraction, Scheme, SubdivisionError, contraction};
use crate::math::curve::Point;
use crate::math::linalg::null_space;
use crate::math::number::{Int, Rational};
use crate::math::ring::Field;

/// Weights of the points p_{i+first}, p_{i+first+1}, …, which give a value at i.
#[derive(Clone, Debug, PartialEq)]
pub struct Stencil<C> {
    /// The weights.
    pub weights: Vec<C>,
    /// The place of the first of them, relative to i.
    pub first: i64,
}

impl<C: Field> Stencil<C> {
    /// Σ w_k p_{i+k} for all i: of a closed polygon, or for those of an open one that have all points.
    ///
    /// # Errors
    /// [`SubdivisionError::TooFewPoints`].
    pub fn apply(&self, points: &[Point<C>], closed: bool) -> Result<Vec<Point<C>>, SubdivisionError> {
        let (m, length) = (points.len(), self.weights.len());
        let needed = if closed { 1 } else { length };
        if m < needed {
            return Err(SubdivisionError::TooFewPoints { needed, given: m });
        }
        let count = if closed { m } else { m - length + 1 };
        let start = |i: usize| if closed { i as i64 + self.first } else { i as i64 };
        let value = |i: usize| -> Point<C> {
            let at = |k: usize| &points[(start(i) + k as i64).rem_euclid(m as i64) as usize];
            (0..points[0].len())
                .map(|x| {
                    let terms = self.weights.iter().enumerate();
                    terms.fold(C::zero(), |sum, (k, w)| sum.plus(&w.times(&at(k)[x])))
                })
                .collect()
        };
        Ok((0..count).map(value).collect())
    }
}

/// The stencil of the limit point at a point of the polygon (order 0), or of the derivative of an order by the
/// parameter in which the points of the polygon stand at the integers.
///
/// Its weights w_j = φ^(r)(−j) are a left eigenvector of the local matrix for 2^{−r} with
/// Σ j^r w_j = r!. Cost: that of [`contraction`], and a null space as large as the mask.
///
/// # Errors
/// [`SubdivisionError::NotShown`] unless norms of up to `most` steps show that the limits are so smooth,
/// [`SubdivisionError::Symbols`], [`SubdivisionError::NotDetermined`].
///
/// ```
/// use polarform::number::rational as q;
/// use polarform::subdivision::{Scheme, limit_stencil};
/// let cubic = limit_stencil(&Scheme::lane_riesenfeld(3), 0, 8)?;
/// assert_eq!((cubic.first, cubic.weights), (-1, vec![q(1, 6), q(2, 3), q(1, 6)]));
/// let tangent = limit_stencil(&Scheme::four_point(&q(1, 16)), 1, 8)?;
/// assert_eq!(tangent.weights, [q(1, 12), q(-2, 3), q(0, 1), q(2, 3), q(-1, 12)]);
/// # Ok::<(), polarform::subdivision::SubdivisionError>(())
/// ```
pub fn limit_stencil<C: Field>(
    scheme: &Scheme<C>,
    order: usize,
    most: usize,
) -> Result<Stencil<C>, SubdivisionError> {
    if !matches!(contraction(scheme, order, most)?, Contraction::Shown { .. }) {
        return Err(SubdivisionError::NotShown { order });
    }
    let undetermined = SubdivisionError::NotDetermined { order };
    let local = scheme.local_matrix();
    let size = local.nrows();
    let eigenvalue = C::from_rational(&Rational::new(Int::ONE, Int::from(2usize).pow(order as u32)));
    let shifted = DMatrix::from_fn(size, size, |i, j| match i == j {
        true => local[(i, i)].minus(&eigenvalue),
        false => local[(j, i)].clone(),
    });
    let space = null_space(&shifted);
    if space.ncols() != 1 {
        return Err(undetermined);
    }
    let place = |i: usize| i as i64 + 1 - scheme.last();
    let power = |i: usize| {
        let j = Rational::from_integer(Int::from(place(i)));
        (0..order).fold(Rational::from_integer(Int::ONE), |product, _| product * &j)
    };
    let moment = (0..size).fold(C::zero(), |sum, i| sum.plus(&space[(i, 0)].scaled(&power(i))));
    let factorial = (1..=order).fold(Int::ONE, |product, k| product * Int::from(k));
    let factor = moment.inverse().ok_or(undetermined)?.scaled(&Rational::from_integer(factorial));
    let mut weights: Vec<C> = (0..size).map(|i| space[(i, 0)].times(&factor)).collect();
    let mut first = place(0);
    // An interpolating scheme has zeros around its single 1.
    while weights.first().is_some_and(num_traits::Zero::is_zero) {
        weights.remove(0);
        first += 1;
    }
    while weights.last().is_some_and(num_traits::Zero::is_zero) {
        weights.pop();
    }
    Ok(Stencil { weights, first })
}
