//! Surfaces made of splines: ruled ones, and Coons' bilinearly blended surface.
//!
//! The ruled surface (1 − v) c(u) + v d(u) has the control points of both splines as its two columns, over common knots. Coons' surface of
//! four splines is the sum of two ruled surfaces without the bilinear surface of the corners, which both contain.
//!
//! S. A. Coons, "Surfaces for computer-aided design of space forms", MIT 1967.

use super::{BSpline, KnotVector, SplineError, SplineSurface};
use crate::math::curve::{CurveError, Interval, Point};
use crate::math::ring::Field;

/// The lines between points of two splines with the same parameter, over their interval and another one in v.
///
/// Cost: that of [`BSpline::in_common`].
///
/// # Errors
/// As [`BSpline::in_common`], and different dimensions.
///
/// ```
/// use polarform::interval::Interval;
/// use polarform::number::{integer as z, rational as q};
/// use polarform::spline::{BSpline, KnotVector, ruled_spline};
/// let whole = Interval::new(z(0), z(2))?;
/// let over = |inner: &[i64], points: &[i64]| {
///     let inner: Vec<_> = inner.iter().map(|&t| z(t)).collect();
///     BSpline::new(KnotVector::clamped(1, &inner, &whole)?, points.iter().map(|&x| vec![z(x)]).collect())
/// };
/// let s = ruled_spline(&over(&[1], &[0, 4, 0])?, &over(&[], &[2, 4])?, &Interval::unit())?;
/// assert_eq!(s.value(&z(1), &q(1, 2))?, [q(7, 2)]);
/// # Ok::<(), polarform::spline::SplineError>(())
/// ```
pub fn ruled_spline<C: Field>(
    c: &BSpline<C>,
    d: &BSpline<C>,
    v: &Interval<C>,
) -> Result<SplineSurface<C>, SplineError> {
    if c.dimension() != d.dimension() {
        return Err(CurveError::DimensionsOf { left: c.dimension(), right: d.dimension() }.into());
    }
    let (c, d) = c.in_common(d)?;
    let net: Vec<Vec<Point<C>>> =
        c.points().iter().zip(d.points()).map(|(p, q)| vec![p.clone(), q.clone()]).collect();
    SplineSurface::new(c.knots().clone(), KnotVector::clamped(1, &[], v)?, net)
}

/// Coons' surface of two splines in u, at both ends of v, and two in v, at both ends of u.
///
/// Cost: that of common knots in both directions.
///
/// # Errors
/// As [`ruled_spline`], and [`CurveError::NoCommonEnd`] unless the curves meet at the corners.
///
/// ```
/// use polarform::interval::Interval;
/// use polarform::number::{integer as z, rational as q};
/// use polarform::spline::{BSpline, KnotVector, coons_spline};
/// let over = |inner: &[i64], end: i64, points: &[i64]| {
///     let inner: Vec<_> = inner.iter().map(|&t| z(t)).collect();
///     let knots = KnotVector::clamped(1, &inner, &Interval::new(z(0), z(end))?)?;
///     BSpline::new(knots, points.iter().map(|&x| vec![z(x)]).collect())
/// };
/// let s = coons_spline(&[over(&[1], 2, &[0, 4, 0])?, over(&[], 2, &[1, 1])?], &[over(&[], 1, &[0, 1])?, over(&[], 1, &[0, 1])?])?;
/// assert_eq!((s.value(&z(1), &z(0))?, s.value(&z(1), &q(1, 2))?), (vec![z(4)].into(), vec![q(5, 2)].into()));
/// # Ok::<(), polarform::spline::SplineError>(())
/// ```
pub fn coons_spline<C: Field>(
    in_u: &[BSpline<C>; 2],
    in_v: &[BSpline<C>; 2],
) -> Result<SplineSurface<C>, SplineError> {
    let (u, v) = (in_u[0].interval().clone(), in_v[0].interval().clone());
    let ends = |s: &BSpline<C>| -> Result<[Point<C>; 2], SplineError> {
        let (a, b) = s.interval().ends();
        Ok([s.value(a)?, s.value(b)?])
    };
    let (bottom, top) = (ends(&in_u[0])?, ends(&in_u[1])?);
    let (left, right) = (ends(&in_v[0])?, ends(&in_v[1])?);
    if [&bottom[0], &top[0], &bottom[1], &top[1]] != [&left[0], &left[1], &right[0], &right[1]] {
        return Err(CurveError::NoCommonEnd.into());
    }
    let along_u = ruled_spline(&in_u[0], &in_u[1], &v)?;
    let along_v = ruled_spline(&in_v[0], &in_v[1], &u)?.transposed();
    let negative = |p: &Point<C>| -> Point<C> { p.iter().map(|x| -x.clone()).collect() };
    let corners =
        vec![vec![negative(&bottom[0]), negative(&top[0])], vec![negative(&bottom[1]), negative(&top[1])]];
    let bilinear =
        SplineSurface::new(KnotVector::clamped(1, &[], &u)?, KnotVector::clamped(1, &[], &v)?, corners)?;
    along_u.sum(&along_v)?.sum(&bilinear)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{Rational, integer as z, rational as q};
    use proptest::prelude::*;

    fn spline(n: usize, inner: &[i64], points: &[Rational]) -> BSpline<Rational> {
        let inner: Vec<_> = inner.iter().map(|&t| z(t)).collect();
        let knots = KnotVector::clamped(n, &inner, &Interval::new(z(0), z(3)).unwrap()).unwrap();
        BSpline::new(knots, points.iter().map(|x| vec![x.clone()]).collect()).unwrap()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        /// The formula of the Boolean sum, point by point.
        #[test]
        fn values_are_those_of_the_boolean_sum(list in prop::collection::vec(-9i64..10, 14), corners in prop::collection::vec(-5i64..6, 4)) {
            let corner = |i: usize| z(corners[i]);
            let with_ends = |a: Rational, inner: &[i64], b: Rational| -> Vec<Rational> {
                std::iter::once(a).chain(inner.iter().map(|&x| z(x))).chain([b]).collect()
            };
            let in_u = [
                spline(2, &[1], &with_ends(corner(0), &list[..2], corner(1))),
                spline(3, &[2, 2], &with_ends(corner(2), &list[2..6], corner(3))),
            ];
            let in_v = [
                spline(1, &[1, 2], &with_ends(corner(0), &list[6..8], corner(2))),
                spline(2, &[2], &with_ends(corner(1), &list[8..10], corner(3))),
            ];
            let s = coons_spline(&in_u, &in_v).unwrap();
            for (i, j) in (0..=6).flat_map(|i| (0..=6).map(move |j| (i, j))) {
                let (x, y) = (q(i, 2), q(j, 2));
                let (f, g) = (&x / z(3), &y / z(3));
                let value = |s: &BSpline<Rational>, t: &Rational| s.value(t).unwrap()[0].clone();
                let mix = |t: &Rational, a: Rational, b: Rational| (z(1) - t) * a + t * b;
                let expected = mix(&g, value(&in_u[0], &x), value(&in_u[1], &x)) + mix(&f, value(&in_v[0], &y), value(&in_v[1], &y))
                    - mix(&f, mix(&g, corner(0), corner(2)), mix(&g, corner(1), corner(3)));
                prop_assert_eq!(&s.value(&x, &y).unwrap()[0], &expected);
            }
            let [bottom, top] = in_u;
            let meet = corners[0] == corners[2] && corners[1] == corners[3];
            prop_assert_eq!(coons_spline(&[top, bottom], &in_v).is_ok(), meet);
        }
    }
}
