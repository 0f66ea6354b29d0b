//! Points with a weight: what rational curves and surfaces share.
//!
//! A point p with weight w ≠ 0 is the vector (w p, w); a vector with weight 0 is a point at
//! infinity, a direction. A rational curve is the image of a polynomial one under the projection
//! (x, w) ↦ x / w.

use super::{CurveError, Net, Point, Vector};
use crate::math::number::{Rational, binomial};
use crate::math::ring::Field;

/// The vectors (w p, w).
///
/// # Errors
/// [`CurveError::WeightCount`], [`CurveError::ZeroWeight`].
pub(in crate::math) fn lifted<C: Field>(
    points: &[Point<C>],
    weights: &[C],
) -> Result<Vec<Point<C>>, CurveError> {
    if points.len() != weights.len() {
        return Err(CurveError::WeightCount { weights: weights.len(), points: points.len() });
    }
    if let Some(index) = weights.iter().position(C::is_zero) {
        return Err(CurveError::ZeroWeight { index });
    }
    let lift = |(point, weight): (&Point<C>, &C)| -> Point<C> {
        point.iter().map(|x| x.times(weight)).chain([weight.clone()]).collect()
    };
    Ok(points.iter().zip(weights).map(lift).collect())
}

/// The vectors (w p, w) of a net; a weight is told by its place along the rows.
///
/// # Errors
/// [`CurveError::WeightCount`] of all points, or of the first row that differs;
/// [`CurveError::ZeroWeight`].
pub(in crate::math) fn lifted_net<C: Field>(
    net: &[Vec<Point<C>>],
    weights: &[Vec<C>],
) -> Result<Net<C>, CurveError> {
    if net.len() != weights.len() {
        let (weights, points) = (weights.iter().map(Vec::len).sum(), net.iter().map(Vec::len).sum());
        return Err(CurveError::WeightCount { weights, points });
    }
    let mut before = 0;
    let lift = |(row, weights): (&Vec<Point<C>>, &Vec<C>)| {
        let place = before;
        before += row.len();
        lifted(row, weights).map_err(|error| match error {
            CurveError::ZeroWeight { index } => CurveError::ZeroWeight { index: place + index },
            other => other,
        })
    };
    net.iter().zip(weights).map(lift).collect()
}

/// x and w of a vector (x, w).
pub(in crate::math) fn parted<C>(vector: &[C]) -> (&[C], &C) {
    let (weight, x) = vector.split_last().expect("a homogeneous vector has a weight");
    (x, weight)
}

/// x / w
///
/// # Errors
/// [`CurveError::ZeroDenominator`] if w = 0.
pub(in crate::math) fn projected<C: Field>(vector: &[C]) -> Result<Point<C>, CurveError> {
    let (x, weight) = parted(vector);
    let inverse = weight.inverse().ok_or(CurveError::ZeroDenominator)?;
    Ok(x.iter().map(|x| inverse.times(x)).collect())
}

/// Whether a homogeneous object has the weight that it needs.
pub(in crate::math) fn check_weight(dimension: usize) -> Result<(), CurveError> {
    if dimension > 0 { Ok(()) } else { Err(CurveError::DimensionsOf { left: 0, right: 1 }) }
}

/// The derivatives of x/w from those of (x, w), the position vector first: entry (r, s) belongs to ∂^{r+s}/∂u^r ∂v^s, and
/// each row is at least as long as the next. From Leibniz' rule for x = w p,
/// w p^{(r,s)} = x^{(r,s)} − Σ_{(i,j) ≠ 0} C(r,i) C(s,j) w^{(i,j)} p^{(r−i,s−j)}.
///
/// Reference: L. Piegl, W. Tiller, *The NURBS Book* (1997), section 4.5.
///
/// # Errors
/// [`CurveError::ZeroDenominator`].
pub(super) fn quotient_derivatives<C: Field>(
    homogeneous: &[Vec<Vector<C>>],
) -> Result<Vec<Vec<Vector<C>>>, CurveError> {
    let inverse = parted(&homogeneous[0][0]).1.inverse().ok_or(CurveError::ZeroDenominator)?;
    let mut result: Vec<Vec<Vector<C>>> = Vec::with_capacity(homogeneous.len());
    for (r, row) in homogeneous.iter().enumerate() {
        result.push(Vec::with_capacity(row.len()));
        for (s, vector) in row.iter().enumerate() {
            let mut total = Vector::from(parted(vector).0);
            for i in 0..=r {
                for j in 0..=s {
                    if (i, j) == (0, 0) {
                        continue;
                    }
                    crate::budget::step();
                    let count = Rational::from_integer(binomial(r, i) * binomial(s, j));
                    let weight = parted(&homogeneous[i][j]).1.scaled(&count);
                    total = total - &result[r - i][s - j] * &weight;
                }
            }
            result[r].push(total * &inverse);
        }
    }
    Ok(result)
}
