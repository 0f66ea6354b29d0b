//! Surfaces of revolution of rational profiles.
//!
//! A profile (x(v), z(v)) = (X, Z)/W turned about the z axis along a curve (C, S)/w of the unit
//! circle is the surface (X C, X S, Z w, W w): a rational patch whose control vectors are products
//! of those of the two curves, so nothing is approximated and no root is needed.
//!
//! Reference: L. Piegl, W. Tiller, *The NURBS Book* (1997), section 8.5.

use super::circle::circle_quarters;
use super::patch::TensorPatch;
use super::rational::RationalCurve;
use super::rational_surface::RationalPatch;
use super::{CurveError, Point};
use crate::math::ring::Field;

/// The surface that a profile (x, z) sweeps along a curve in the plane: u runs along the curve,
/// v along the profile, and the point is (x c, x s, z) for the point (c, s) of the curve. For a
/// curve on the unit circle it is a surface of revolution about the z axis.
///
/// # Errors
/// [`CurveError::DimensionsOf`] unless both curves are in the plane.
pub fn revolve_along<C: Field>(
    profile: &RationalCurve<C>,
    circle: &RationalCurve<C>,
) -> Result<RationalPatch<C>, CurveError> {
    for curve in [profile, circle] {
        if curve.dimension() != 2 {
            return Err(CurveError::DimensionsOf { left: curve.dimension(), right: 2 });
        }
    }
    let vector = |around: &Point<C>, along: &Point<C>| -> Point<C> {
        [(0, 0), (0, 1), (1, 2), (2, 2)].iter().map(|&(k, l)| along[k].times(&around[l])).collect()
    };
    let (around, along) = (circle.homogeneous(), profile.homogeneous());
    let row = |a: &Point<C>| along.points().iter().map(|p| vector(a, p)).collect();
    let net = around.points().iter().map(row).collect();
    let patch = TensorPatch::new(net, around.interval().clone(), along.interval().clone())?;
    RationalPatch::from_homogeneous(patch)
}

/// The surface of revolution of a profile (x, z) about the z axis as four patches of degree
/// (2, n), the k-th for u in [k, k + 1] over a quarter turn, counter-clockwise from the x axis.
///
/// # Errors
/// [`CurveError::DimensionsOf`] unless the profile is in the plane.
///
/// ```
/// use polarform::curve::{Interval, RationalCurve, revolve};
/// use polarform::number::{integer as z, rational as q};
/// // a cone: the segment from (2, 0) to (0, 1)
/// let profile = [[2, 0], [0, 1]].map(|p| p.map(z).to_vec()).to_vec();
/// let profile = RationalCurve::new(profile, vec![z(1), z(1)], Interval::unit())?;
/// let patches = revolve(&profile)?;
/// assert_eq!(patches[0].value(&q(1, 2), &q(1, 2))?, [q(3, 5), q(4, 5), q(1, 2)]);
/// assert_eq!(patches[2].value(&z(2), &z(0))?, [z(-2), z(0), z(0)]);
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn revolve<C: Field>(profile: &RationalCurve<C>) -> Result<Vec<RationalPatch<C>>, CurveError> {
    let quarters = circle_quarters(&[C::zero(), C::zero()], &[C::one(), C::zero()])?;
    quarters.iter().map(|quarter| revolve_along(profile, quarter)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::Interval;
    use crate::math::curve::circle::circle_quintic;
    use crate::math::curve::rational::tests::any_rational;
    use crate::math::number::{Rational, integer as z, rational as q};
    use crate::math::poly::{Fraction, MultiPoly, Symbol};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        #[test]
        fn every_parallel_is_a_circle(profile in any_rational(), u in (0i64..9, 1i64..9), v in (-5i64..6, 1i64..4)) {
            let v = q(v.0, v.1);
            let Ok(point) = profile.value(&v) else { return Ok(()) };
            let mut patches = revolve(&profile).unwrap();
            let circle = circle_quintic(&[z(0), z(0)], &[z(1), z(0)]).unwrap();
            patches.push(revolve_along(&profile, &circle).unwrap());
            for patch in &patches {
                let start = patch.homogeneous().u().start().clone();
                let [x, y, height] = &patch.value(&(start + q(u.0, 9)), &v).unwrap()[..] else { panic!() };
                prop_assert_eq!(x * x + y * y, &point[0] * &point[0]);
                prop_assert_eq!(height, &point[1]);
            }
            prop_assert_eq!(patches[0].homogeneous().degrees(), (2, profile.degree()));
            for (patch, next) in patches[..4].iter().zip(patches[..4].iter().cycle().skip(1)) {
                let (end, start) = (patch.homogeneous().u().end(), next.homogeneous().u().start());
                prop_assert_eq!(patch.value(end, &v), next.value(start, &v));
            }
        }
    }

    #[test]
    fn a_torus() {
        // the circle of radius 1 around (3, 0), turned
        let profile = circle_quintic(&[z(3), z(0)], &[z(4), z(0)]).unwrap();
        for patch in revolve(&profile).unwrap() {
            let u = patch.homogeneous().u().start() + q(1, 3);
            for v in 0..6 {
                let [x, y, h] = &patch.value(&u, &q(v, 5)).unwrap()[..] else { panic!() };
                let around = x * x + y * y;
                let sum: Rational = &around + h * h + z(8);
                assert_eq!(&sum * &sum, around * z(36));
            }
        }
    }

    #[test]
    fn a_symbolic_profile() {
        let name = |s: &str| Fraction::from(MultiPoly::symbol(Symbol::new(s)));
        let one = || Fraction::from(z(1));
        let points = vec![vec![name("a"), name("b")], vec![name("c"), name("d")]];
        let profile = RationalCurve::new(points, vec![one(), name("w")], Interval::unit()).unwrap();
        let patch = revolve(&profile).unwrap().swap_remove(0);
        let (x, y) = (name("u"), name("v"));
        let p = patch.value(&x, &y).unwrap();
        let r = profile.value(&y).unwrap()[0].clone();
        assert_eq!(p[0].clone() * p[0].clone() + p[1].clone() * p[1].clone(), r.clone() * r);
        let space = RationalCurve::new(vec![vec![one(); 3]], vec![one()], Interval::unit()).unwrap();
        assert_eq!(revolve(&space), Err(CurveError::DimensionsOf { left: 3, right: 2 }));
    }
}
