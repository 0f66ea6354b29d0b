//! The octant of a sphere, exactly, as a tensor-product and as a triangular patch.
//!
//! The stereographic projection of the plane onto the sphere, from the south pole, is
//! (x, y) = (X, Y)/W ↦ (2XW, 2YW, W² − X² − Y², W² + X² + Y²). A rational quadratic triangle over a
//! quarter of the unit disc therefore becomes a rational quartic triangle over an octant, without
//! a degenerate corner. The octant with symmetric weights needs √2 and √3; this one is over Q.
//!
//! References: G. Farin, B. Piper, A. Worsey, "The octant of a sphere as a non-degenerate
//! triangular Bézier patch", CAGD 4 (1987); R. Dietz, J. Hoschek, B. Jüttler, "An algebraic
//! approach to curves and surfaces on the sphere and on other quadrics", CAGD 10 (1993).

use super::domain::Triangle;
use super::patch::TensorPatch;
use super::rational::RationalCurve;
use super::rational_surface::{RationalPatch, RationalTriangle};
use super::revolve::revolve_along;
use super::triangle::{TrianglePatch, product};
use super::{CurveError, Interval, Point};
use crate::math::number::rational;
use crate::math::ring::Field;

/// The vector of (centre + radius x) for the vector of x.
fn placed<C: Field>(vector: &[C], centre: &[C], radius: &C) -> Point<C> {
    let weight = &vector[3];
    let place = |k: usize| centre[k].times(weight).plus(&radius.times(&vector[k]));
    [place(0), place(1), place(2), weight.clone()].into()
}

fn check_sphere<C: Field>(centre: &[C], radius: &C) -> Result<(), CurveError> {
    if centre.len() != 3 {
        return Err(CurveError::DimensionsOf { left: centre.len(), right: 3 });
    }
    if radius.is_zero() { Err(CurveError::Degenerate) } else { Ok(()) }
}

/// The octant x, y, z ≥ 0 of a sphere (as seen from its centre) as a patch of degree (2, 2) over
/// the unit square; u turns from the x axis to the y axis, v goes up to the pole, where it is
/// degenerate.
///
/// # Errors
/// [`CurveError::DimensionsOf`] unless the centre is in space, [`CurveError::Degenerate`] for
/// radius 0.
///
/// ```
/// use polarform::curve::sphere_octant;
/// use polarform::number::{integer as z, rational as q};
/// let octant = sphere_octant(&[z(0), z(0), z(0)], &z(1))?;
/// assert_eq!(octant.value(&q(1, 2), &q(1, 2))?, [q(9, 25), q(12, 25), q(4, 5)]);
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn sphere_octant<C: Field>(centre: &[C], radius: &C) -> Result<RationalPatch<C>, CurveError> {
    check_sphere(centre, radius)?;
    let number = |x: i64| C::from_rational(&rational(x, 1));
    let points = [[1, 0], [1, 1], [0, 1]].map(|p| p.map(number).to_vec()).to_vec();
    let quarter = RationalCurve::new(points, [1, 1, 2].map(number).to_vec(), Interval::unit())?;
    let unit = revolve_along(&quarter, &quarter)?;
    let patch = unit.homogeneous();
    let place = |row: &Vec<Point<C>>| row.iter().map(|vector| placed(vector, centre, radius)).collect();
    let net = patch.net().iter().map(place).collect();
    RationalPatch::from_homogeneous(TensorPatch::new(net, patch.u().clone(), patch.v().clone())?)
}

/// The octant x, y, z ≥ 0 of a sphere (as seen from its centre) as a triangular patch of degree 4
/// with rational weights; the corners of the triangle go to the points on the z, x and y axes.
///
/// # Errors
/// As for [`sphere_octant`].
///
/// ```
/// use polarform::curve::{Triangle, sphere_octant_triangle};
/// use polarform::number::{integer as z, rational as q};
/// let octant = sphere_octant_triangle(&[z(0), z(0), z(0)], &z(1), Triangle::unit())?;
/// assert_eq!(octant.homogeneous().degree(), 4);
/// let point = octant.value(&[q(1, 4), q(1, 2)])?;
/// assert_eq!(point.iter().map(|x| x * x).sum::<polarform::number::Rational>(), z(1));
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn sphere_octant_triangle<C: Field>(
    centre: &[C],
    radius: &C,
    triangle: Triangle<C>,
) -> Result<RationalTriangle<C>, CurveError> {
    check_sphere(centre, radius)?;
    let halves = |list: [i64; 6]| list.map(|x| C::from_rational(&rational(x, 2))).to_vec();
    // The quarter disc: two segments from the origin, and the quarter (1, 0; 1), (1, 1; 1),
    // (0, 1; 2) of the circle as the edge opposite to it.
    let x = halves([0, 1, 0, 2, 2, 0]);
    let y = halves([0, 0, 2, 0, 2, 4]);
    let w = halves([2, 2, 3, 2, 2, 4]);
    let times = |f: &[C], g: &[C]| product((f, 2), (g, 2));
    let with = |f: &[C], g: &[C], rule: fn(&C, &C) -> C| -> Vec<C> {
        f.iter().zip(g).map(|(x, y)| rule(x, y)).collect()
    };
    let twice = |f: Vec<C>| with(&f, &f, C::plus);
    let (flat, square) = (with(&times(&x, &x), &times(&y, &y), C::plus), times(&w, &w));
    let coordinates = [
        twice(times(&x, &w)),
        twice(times(&y, &w)),
        with(&square, &flat, C::minus),
        with(&square, &flat, C::plus),
    ];
    let vector = |at: usize| -> Point<C> {
        let vector: Point<C> = coordinates.iter().map(|coordinate| coordinate[at].clone()).collect();
        placed(&vector, centre, radius)
    };
    let points = (0..coordinates[0].len()).map(vector).collect();
    RationalTriangle::from_homogeneous(TrianglePatch::new(points, triangle)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::domain::Corner;
    use crate::math::curve::patch::Direction;
    use crate::math::curve::polygon;
    use crate::math::number::{Rational, integer as z, rational as q};
    use num_traits::Signed;

    fn squared(p: &[Rational]) -> Rational {
        p.iter().map(|x| x * x).sum()
    }

    #[test]
    fn both_octants_lie_on_the_sphere_as_polynomials() {
        let (centre, radius) = (vec![z(1), z(-2), q(1, 3)], q(5, 2));
        let patch = sphere_octant(&centre, &radius).unwrap();
        let triangle = sphere_octant_triangle(&centre, &radius, Triangle::unit()).unwrap();
        // |x − m w|² = r² w², coefficient by coefficient
        let tensor = patch.homogeneous();
        let shifted = |k: usize| -> Vec<Vec<Rational>> {
            let shift = |h: &Point<Rational>| if k < 3 { &h[k] - &centre[k] * &h[3] } else { h[3].clone() };
            tensor.net().iter().map(|row| row.iter().map(shift).collect()).collect()
        };
        let squares: Vec<_> = (0..4).map(|k| polygon::product(&shifted(k), &shifted(k))).collect();
        for i in 0..5 {
            for j in 0..5 {
                let sum: Rational = squares[..3].iter().map(|f| &f[i][j]).sum();
                assert_eq!(sum, &squares[3][i][j] * &radius * &radius);
            }
        }
        let shifted = |k: usize| -> Vec<Rational> {
            let shift = |h: &Point<Rational>| if k < 3 { &h[k] - &centre[k] * &h[3] } else { h[3].clone() };
            triangle.homogeneous().points().iter().map(shift).collect()
        };
        let squares: Vec<_> = (0..4).map(|k| product((&shifted(k), 4), (&shifted(k), 4))).collect();
        for i in 0..squares[0].len() {
            let sum: Rational = squares[..3].iter().map(|f| &f[i]).sum();
            assert_eq!(sum, &squares[3][i] * &radius * &radius);
        }
        assert!(triangle.weights().iter().all(Rational::is_positive));
        assert!(patch.weights().iter().flatten().all(Rational::is_positive));
    }

    #[test]
    fn the_triangle_covers_the_octant_without_a_degenerate_point() {
        let origin = [z(0), z(0), z(0)];
        let octant = sphere_octant_triangle(&origin, &z(1), Triangle::unit()).unwrap();
        let n = 6;
        for i in 0..=n {
            for j in 0..=n - i {
                let p = [q(i, n), q(j, n)];
                let point = octant.value(&p).unwrap();
                assert!(point.iter().all(|x| !x.is_negative()));
                assert_eq!(squared(&point), z(1));
                // the normal points outwards everywhere, so the patch is regular
                let normal = octant.normal_at(&p).unwrap();
                let outwards: Rational = normal.iter().zip(&point).map(|(x, y)| x * y).sum();
                assert!(outwards.is_positive());
            }
        }
        // the edges lie in the coordinate planes
        for (corner, k) in [(Corner::A, 2), (Corner::B, 0), (Corner::C, 1)] {
            let edge = octant.homogeneous().boundary(corner);
            assert!(edge.iter().all(|vector| vector[k] == z(0)));
        }
    }

    #[test]
    fn the_pole_of_the_tensor_patch_is_degenerate() {
        let octant = sphere_octant(&[z(0), z(0), z(0)], &z(2)).unwrap();
        assert_eq!(octant.normal_at(&q(1, 2), &z(1)).unwrap(), [z(0), z(0), z(0)]);
        let (lower, _) = octant.subdivide(Direction::V, &q(1, 2)).unwrap();
        assert_eq!(squared(&lower.value(&q(2, 7), &q(1, 5)).unwrap()), z(4));
        assert_eq!(sphere_octant(&[z(0)], &z(1)), Err(CurveError::DimensionsOf { left: 1, right: 3 }));
        let flat = sphere_octant_triangle(&[z(0), z(0), z(0)], &z(0), Triangle::unit());
        assert_eq!(flat, Err(CurveError::Degenerate));
    }
}
