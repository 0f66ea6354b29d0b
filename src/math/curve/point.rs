//! Points and vectors: an affine space and the vector space of its differences.
//!
//! Definition: the difference q − p of two points is a vector, and p + (q − p) = q. Points have no
//! sum and no multiples; a combination Σ w_i p_i is a point if Σ w_i = 1, (1 − s) p + s q above all,
//! and a vector if Σ w_i = 0. Values of curves are points; derivatives, tangents and normals are
//! vectors. A curve drawn from vectors, such as the derivative of a curve (its hodograph) or the
//! homogeneous curve of a rational one, has the points o + v for an origin o.
//!
//! Both are kept by coordinates and read as a slice of them; cost of each operation: one operation
//! of the ring for each coordinate. Those on two operands need equal dimensions, further coordinates
//! of one are not looked at.
//!
//! Reference: J. Gallier, *Curves and Surfaces in Geometric Modeling* (2000), chapter 2.

use std::ops::{Add, Deref, DerefMut, Mul, Neg, Sub};

use crate::math::blossom::Argument;
use crate::math::ring::Ring;

/// A point by its coordinates.
///
/// ```
/// use polarform::curve::{Point, Vector};
/// use polarform::number::integer as z;
/// let (p, q) = (Point::from([z(1), z(2)]), Point::from([z(4), z(6)]));
/// let arm: Vector<_> = &q - &p;
/// assert_eq!(arm, [z(3), z(4)]);
/// assert_eq!(&p + &arm, q);
/// ```
///
/// Two points have no sum:
///
/// ```compile_fail,E0369
/// # use polarform::curve::Point;
/// # use polarform::number::integer as z;
/// let p = Point::from([z(1), z(2)]);
/// let sum = &p + &p;
/// ```
#[derive(Clone, PartialEq, Eq)]
pub struct Point<C>(Vec<C>);

/// A vector by its coordinates: the difference of two points.
///
/// ```
/// use polarform::curve::Vector;
/// use polarform::number::{integer as z, rational as q};
/// let (v, w) = (Vector::from([z(1), z(2)]), Vector::from([z(3), z(0)]));
/// assert_eq!(&(&v + &w) * &q(1, 2), [z(2), z(1)]);
/// assert_eq!(v.from_origin() - &w, [z(-2), z(2)]);
/// ```
#[derive(Clone, PartialEq, Eq)]
pub struct Vector<C>(Vec<C>);

/// What is the same for both: lists of coordinates.
macro_rules! coordinates {
    ($name:ident) => {
        impl<C> Deref for $name<C> {
            type Target = [C];
            fn deref(&self) -> &[C] {
                &self.0
            }
        }
        impl<C> DerefMut for $name<C> {
            fn deref_mut(&mut self) -> &mut [C] {
                &mut self.0
            }
        }
        impl<C> From<Vec<C>> for $name<C> {
            fn from(coordinates: Vec<C>) -> Self {
                $name(coordinates)
            }
        }
        impl<C, const N: usize> From<[C; N]> for $name<C> {
            fn from(coordinates: [C; N]) -> Self {
                $name(coordinates.into())
            }
        }
        impl<C: Clone> From<&[C]> for $name<C> {
            fn from(coordinates: &[C]) -> Self {
                $name(coordinates.into())
            }
        }
        impl<C> From<$name<C>> for Vec<C> {
            fn from(list: $name<C>) -> Vec<C> {
                list.0
            }
        }
        impl<C> FromIterator<C> for $name<C> {
            fn from_iter<I: IntoIterator<Item = C>>(coordinates: I) -> Self {
                $name(coordinates.into_iter().collect())
            }
        }
        impl<C> IntoIterator for $name<C> {
            type Item = C;
            type IntoIter = std::vec::IntoIter<C>;
            fn into_iter(self) -> Self::IntoIter {
                self.0.into_iter()
            }
        }
        impl<'a, C> IntoIterator for &'a $name<C> {
            type Item = &'a C;
            type IntoIter = std::slice::Iter<'a, C>;
            fn into_iter(self) -> Self::IntoIter {
                self.0.iter()
            }
        }
        impl<C: PartialEq, const N: usize> PartialEq<[C; N]> for $name<C> {
            fn eq(&self, coordinates: &[C; N]) -> bool {
                self.0 == coordinates
            }
        }
        impl<C: PartialEq> PartialEq<[C]> for $name<C> {
            fn eq(&self, coordinates: &[C]) -> bool {
                self.0 == coordinates
            }
        }
        impl<C: PartialEq> PartialEq<Vec<C>> for $name<C> {
            fn eq(&self, coordinates: &Vec<C>) -> bool {
                &self.0 == coordinates
            }
        }
    };
}
coordinates!(Point);
coordinates!(Vector);

/// An operation on two lists of coordinates, of values and of references.
macro_rules! operation {
    ($trait:ident $method:ident: $left:ident, $right:ident -> $result:ident by $rule:ident) => {
        impl<C: Ring> $trait<&$right<C>> for &$left<C> {
            type Output = $result<C>;
            fn $method(self, other: &$right<C>) -> $result<C> {
                self.iter().zip(&**other).map(|(x, y)| x.$rule(y)).collect()
            }
        }
        impl<C: Ring> $trait<&$right<C>> for $left<C> {
            type Output = $result<C>;
            fn $method(self, other: &$right<C>) -> $result<C> {
                (&self).$method(other)
            }
        }
        impl<C: Ring> $trait<$right<C>> for $left<C> {
            type Output = $result<C>;
            fn $method(self, other: $right<C>) -> $result<C> {
                (&self).$method(&other)
            }
        }
    };
}

operation!(Sub sub: Point, Point -> Vector by minus);
operation!(Add add: Point, Vector -> Point by plus);
operation!(Sub sub: Point, Vector -> Point by minus);
operation!(Add add: Vector, Vector -> Vector by plus);
operation!(Sub sub: Vector, Vector -> Vector by minus);

impl<C: Ring> Mul<&C> for &Vector<C> {
    type Output = Vector<C>;
    fn mul(self, factor: &C) -> Vector<C> {
        self.iter().map(|x| factor.times(x)).collect()
    }
}

impl<C: Ring> Mul<&C> for Vector<C> {
    type Output = Vector<C>;
    fn mul(self, factor: &C) -> Vector<C> {
        &self * factor
    }
}

impl<C: Ring> Neg for Vector<C> {
    type Output = Vector<C>;
    fn neg(self) -> Vector<C> {
        self.into_iter().map(|x| -x).collect()
    }
}

/// The value of the polar form of a curve or surface: a point, or a vector if one of the arguments
/// is a vector.
pub type PolarValue<C> = Argument<Point<C>, Vector<C>>;

impl<C: Ring> PolarValue<C> {
    /// What these coordinates are, by the arguments of the polar form.
    pub(in crate::math) fn of<P, V>(coordinates: Point<C>, arguments: &[Argument<P, V>]) -> Self {
        match arguments.iter().any(|argument| matches!(argument, Argument::Vector(_))) {
            true => Argument::Vector(coordinates.position()),
            false => Argument::Point(coordinates),
        }
    }

    /// The coordinates of either.
    pub fn coordinates(&self) -> &[C] {
        match self {
            Argument::Point(p) => p,
            Argument::Vector(v) => v,
        }
    }

    /// The point; for a vector the one where it ends if it is drawn from the origin.
    pub fn into_point(self) -> Point<C> {
        match self {
            Argument::Point(p) => p,
            Argument::Vector(v) => v.from_origin(),
        }
    }
}

impl<C: Ring> Point<C> {
    /// The position vector p − o.
    pub fn position(&self) -> Vector<C> {
        Vector(self.0.clone())
    }
}

impl<C: Ring> Vector<C> {
    /// The zero vector.
    pub fn zero(dimension: usize) -> Self {
        Vector(vec![C::zero(); dimension])
    }

    /// Whether all coordinates are zero.
    pub fn is_zero(&self) -> bool {
        self.iter().all(C::is_zero)
    }

    /// The point o + v.
    pub fn from_origin(self) -> Point<C> {
        Point(self.0)
    }
}

/// (1 − s) p + s q
pub fn lerp<C: Ring>(p: &Point<C>, q: &Point<C>, s: &C) -> Point<C> {
    p.iter().zip(q).map(|(x, y)| x.plus(&s.times(&y.minus(x)))).collect()
}

/// Σ w_i (p_i − o), of which the empty one has `dimension` zeros. If Σ w_i = 1 it is the position
/// vector of the affine combination, if Σ w_i = 0 it does not depend on the origin.
pub fn combination<'a, C: Ring>(
    dimension: usize,
    terms: impl IntoIterator<Item = (&'a C, &'a Point<C>)>,
) -> Vector<C> {
    let mut total = Vector::zero(dimension);
    for (weight, point) in terms {
        for (x, y) in total.iter_mut().zip(point) {
            *x += weight.times(y);
        }
    }
    total
}
