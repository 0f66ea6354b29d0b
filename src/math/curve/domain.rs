//! Parameter domains: an interval of the line, a triangle of the plane.
//!
//! Definition: over [a, b] each parameter is u = (1 − s) a + s b, and over a triangle with corners
//! a, b, c each point is p = λ_0 a + λ_1 b + λ_2 c with Σ λ_i = 1. These affine coordinates are
//! all that polar forms see: f(…, u, …) = (1 − s) f(…, a, …) + s f(…, b, …). A vector has
//! coordinates with sum 0.
//!
//! **Invariant.** a ≠ b; the corners of a triangle are affinely independent.
//!
//! Reference: G. Farin, *Curves and Surfaces for CAGD*, 5th ed. (2002), sections 3.2 and 17.1.

use super::{CurveError, Point, dimension};
use crate::math::blossom::{Argument, PointArgument};
use crate::math::interval::{Interval, not_negative};
use crate::math::number::Rational;
use crate::math::ring::{Field, Ring};

impl<C: Field> Interval<C> {
    /// The coordinates (1 − s, s) of a point, (−s, s) of a vector.
    pub(super) fn coordinates(&self, argument: &Argument<C>) -> [C; 2] {
        match argument {
            Argument::Point(u) => self.point_coordinates(u),
            Argument::Vector(v) => {
                let s = v.times(self.inverse_width());
                [-s.clone(), s]
            }
        }
    }

    /// (1 − s, s)
    pub(super) fn point_coordinates(&self, u: &C) -> [C; 2] {
        let s = self.local(u);
        [C::one().minus(&s), s]
    }
}

/// A corner of a [`Triangle`], or the edge opposite to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Corner {
    /// The first corner, a; the edge from b to c.
    A,
    /// The second corner, b; the edge from a to c.
    B,
    /// The third corner, c; the edge from a to b.
    C,
}

/// A triangle of the parameter plane, in either orientation.
///
/// ```
/// use polarform::curve::{CurveError, Triangle};
/// use polarform::number::{integer as z, rational as q};
/// let triangle = Triangle::new([vec![z(0), z(0)], vec![z(2), z(0)], vec![z(0), z(3)]])?;
/// assert_eq!(triangle.area(), z(3));
/// assert_eq!(triangle.barycentric(&[z(1), z(1)])?, [q(1, 6), q(1, 2), q(1, 3)]);
/// let flat = Triangle::new([vec![z(0), z(0)], vec![z(1), z(1)], vec![z(2), z(2)]]);
/// assert_eq!(flat, Err(CurveError::Degenerate));
/// # Ok::<(), CurveError>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct Triangle<C> {
    pub(super) corners: [Point<C>; 3],
    /// det(b − a, c − a), twice the signed area.
    determinant: C,
    inverse: C,
}

/// det(v, w) for two vectors of the plane.
pub(super) fn determinant<C: Ring>(v: &[C], w: &[C]) -> C {
    v[0].times(&w[1]).minus(&v[1].times(&w[0]))
}

impl<C: Field> Triangle<C> {
    /// The triangle with corners a, b, c in the plane.
    ///
    /// # Errors
    /// [`CurveError::Degenerate`] if they lie on a line, [`CurveError::Dimensions`], and
    /// [`CurveError::DimensionsOf`] unless the dimension is 2.
    pub fn new(corners: [impl Into<Point<C>>; 3]) -> Result<Self, CurveError> {
        let corners = corners.map(Into::into);
        plane(dimension(&corners)?)?;
        let [a, b, c] = &corners;
        let determinant = determinant(&(b - a), &(c - a));
        let inverse = determinant.inverse().ok_or(CurveError::Degenerate)?;
        Ok(Triangle { corners, determinant, inverse })
    }

    /// The triangle with corners (0, 0), (1, 0), (0, 1).
    pub fn unit() -> Self {
        let (zero, one) = (C::zero, C::one);
        Triangle {
            corners: [[zero(), zero()], [one(), zero()], [zero(), one()]].map(Point::from),
            determinant: one(),
            inverse: one(),
        }
    }

    /// a, b, c
    pub fn corners(&self) -> &[Point<C>; 3] {
        &self.corners
    }

    /// The signed area: positive for corners in counter-clockwise order.
    pub fn area(&self) -> C {
        self.determinant.scaled(&Rational::new(1.into(), 2.into()))
    }

    /// (λ_0, λ_1, λ_2) with Σ λ_i = 1: each the signed area with that corner replaced by p,
    /// divided by the whole.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] unless p has 2 coordinates.
    pub fn barycentric(&self, p: &[C]) -> Result<[C; 3], CurveError> {
        plane(p.len())?;
        let [zeroth, first, second] = self.directed(&(Point::from(p) - &self.corners[0]));
        Ok([C::one() + zeroth, first, second])
    }

    /// The coordinates of a vector, with sum 0.
    fn directed(&self, v: &[C]) -> [C; 3] {
        let [a, b, c] = &self.corners;
        let first = determinant(v, &(c - a)).times(&self.inverse);
        let second = determinant(&(b - a), v).times(&self.inverse);
        [-first.plus(&second), first, second]
    }

    /// The coordinates of a point (sum 1) or a vector (sum 0).
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] unless it has 2 coordinates.
    pub fn coordinates(&self, argument: &PointArgument<C>) -> Result<[C; 3], CurveError> {
        match argument {
            Argument::Point(p) => self.barycentric(p),
            Argument::Vector(v) => {
                plane(v.len())?;
                Ok(self.directed(v))
            }
        }
    }

    /// Whether p lies inside or on the border; `None` if that depends on symbols.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] unless p has 2 coordinates.
    pub fn contains(&self, p: &[C]) -> Result<Option<bool>, CurveError> {
        let signs = self.barycentric(p)?.map(|x| not_negative(&x));
        Ok(signs.into_iter().try_fold(true, |inside, sign| Some(inside && sign?)))
    }

    /// λ_0 a + λ_1 b + λ_2 c
    pub fn point(&self, barycentric: &[C; 3]) -> Point<C> {
        super::combination(2, barycentric.iter().zip(&self.corners)).from_origin()
    }
}

fn plane(size: usize) -> Result<(), CurveError> {
    if size == 2 { Ok(()) } else { Err(CurveError::DimensionsOf { left: 2, right: size }) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::affine::{barycentric, signed_volume};
    use crate::math::number::integer as z;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn agrees_with_the_general_solver(c in prop::collection::vec((-6i64..7).prop_map(z), 8)) {
            let corners = [&c[0..2], &c[2..4], &c[4..6]].map(Point::from);
            let p = c[6..8].to_vec();
            match Triangle::new(corners.clone()) {
                Ok(triangle) => {
                    let found = triangle.barycentric(&p).unwrap();
                    prop_assert_eq!(barycentric(&corners, &p).unwrap(), found.to_vec());
                    prop_assert_eq!(triangle.point(&found), p.clone());
                    let inside = found.iter().all(|x| *x >= z(0));
                    prop_assert_eq!(triangle.contains(&p), Ok(Some(inside)));
                    prop_assert_eq!(signed_volume(&corners).unwrap(), triangle.area() * z(2));
                    let vector = triangle.coordinates(&Argument::Vector(p.clone())).unwrap();
                    prop_assert_eq!(triangle.point(&vector), p);
                    prop_assert_eq!(vector.iter().sum::<Rational>(), z(0));
                }
                Err(error) => {
                    prop_assert_eq!(error, CurveError::Degenerate);
                    prop_assert!(barycentric(&corners, &p).is_err());
                }
            }
        }
    }

    #[test]
    fn bad_domains_are_refused() {
        let corners = [vec![z(0)], vec![z(1)], vec![z(2)]];
        assert_eq!(Triangle::new(corners), Err(CurveError::DimensionsOf { left: 2, right: 1 }));
        assert!(Triangle::<Rational>::unit().barycentric(&[z(1)]).is_err());
    }
}
