//! The nearest curve of a lower degree.

use nalgebra::DMatrix;

use super::ApproximationError;
use super::gram::unit_gram;
use crate::math::curve::{BezierCurve, CurveError, Point, Vector};
use crate::math::linalg::solve;
use crate::math::number::{Rational, binomial_row};
use crate::math::ring::Field;

/// The curve d of degree m that has the least ∫ |c − d|² among those whose derivatives of orders below `ends`
/// agree with those of c at both ends; `ends` = 0 leaves them free, 1 fixes the end points.
///
/// The residual is orthogonal to all B_i^m that are free, which is a system of m + 1 − 2 `ends` equations
/// for all coordinates. Cost: its exact solution, of numbers only, and n m products in C.
///
/// # Errors
/// [`CurveError::Degrees`] for m above the degree, [`ApproximationError::TooManyEnds`].
///
/// ```
/// use polarform::approximation::best_reduction;
/// use polarform::curve::{BezierCurve, Interval};
/// use polarform::number::{integer as z, rational as q};
/// // t² on [0, 1]: the nearest line is t − 1/6
/// let square = BezierCurve::new(vec![[z(0)], [z(0)], [z(1)]], Interval::unit())?;
/// let line = best_reduction(&square, 1, 0)?;
/// assert_eq!(line.points(), [[q(-1, 6)], [q(5, 6)]]);
/// assert_eq!(best_reduction(&square, 1, 1)?.points(), [[z(0)], [z(1)]]);
/// # Ok::<(), polarform::approximation::ApproximationError>(())
/// ```
pub fn best_reduction<C: Field>(
    curve: &BezierCurve<C>,
    m: usize,
    ends: usize,
) -> Result<BezierCurve<C>, ApproximationError> {
    let n = curve.degree();
    if m > n {
        return Err(CurveError::Degrees { left: n, right: m }.into());
    }
    let fixed = ends.saturating_mul(2);
    if fixed > m + 1 {
        return Err(ApproximationError::TooManyEnds { fixed, points: m + 1 });
    }
    let size = curve.dimension();
    let mut points: Vec<Point<C>> = vec![Vector::zero(size).from_origin(); m + 1];
    let mirrored: Vec<Point<C>> = curve.points().iter().rev().cloned().collect();
    for (i, (first, last)) in
        taylor_points(curve.points(), m, ends).into_iter().zip(taylor_points(&mirrored, m, ends)).enumerate()
    {
        points[i] = first;
        points[m - i] = last;
    }
    let free: Vec<usize> = (ends..m + 1 - ends).collect();
    if !free.is_empty() {
        // G_free d_free = ∫ B_free c − G_fixed d_fixed, the width of the interval cancels.
        let (own, mixed) = (unit_gram(m, m), unit_gram(m, n));
        let kept: Vec<usize> = (0..=m).filter(|i| !free.contains(i)).collect();
        let system = DMatrix::from_fn(free.len(), free.len(), |i, j| own[(free[i], free[j])].clone());
        let right = DMatrix::from_fn(free.len(), n + 1 + kept.len(), |i, j| match j.checked_sub(n + 1) {
            Some(k) => -own[(free[i], kept[k])].clone(),
            None => mixed[(free[i], j)].clone(),
        });
        let weights = solve(&system, &right).expect("Bernstein polynomials are independent");
        for (row, &i) in free.iter().enumerate() {
            let given = curve.points().iter().chain(kept.iter().map(|&k| &points[k]));
            let mut point = vec![C::zero(); size];
            for (column, other) in given.enumerate() {
                for (sum, x) in point.iter_mut().zip(other.iter()) {
                    *sum += x.scaled(&weights[(row, column)]);
                }
            }
            points[i] = point.into();
        }
    }
    Ok(BezierCurve::new(points, curve.interval().clone())?)
}

/// The first `count` points of the curve of degree m with the derivatives of orders below `count` of the curve
/// with these points at its start: Δ^r d_0 = C(n,r)/C(m,r) Δ^r b_0 and d_i = Σ_r C(i,r) Δ^r d_0.
fn taylor_points<C: Field>(points: &[Point<C>], m: usize, count: usize) -> Vec<Point<C>> {
    let n = points.len() - 1;
    let (high, low) = (binomial_row(n), binomial_row(m));
    let mut level: Vec<Point<C>> = points.to_vec();
    let mut differences: Vec<Point<C>> = Vec::with_capacity(count);
    for r in 0..count {
        let factor = Rational::new(high[r].clone(), low[r].clone());
        differences.push(level[0].iter().map(|x| x.scaled(&factor)).collect());
        level = level.windows(2).map(|pair| (&pair[1] - &pair[0]).from_origin()).collect();
    }
    let point = |i: usize| -> Point<C> {
        let row: Vec<Rational> = binomial_row(i).into_iter().map(Rational::from_integer).collect();
        (0..points[0].len())
            .map(|k| {
                let terms = row.iter().zip(&differences);
                terms.fold(C::zero(), |sum, (w, difference)| sum.plus(&difference[k].scaled(w)))
            })
            .collect()
    };
    (0..count).map(point).collect()
}
