//! What a coefficient must be able to do.
//!
//! Every coefficient ring of the crate contains the rational numbers (it is a
//! Q-algebra): means of products and binomial weights always make sense. The rings
//! are [`Rational`], multivariate polynomials and their fractions. Equality is
//! equality of values because every ring keeps its elements in canonical form.

use std::cmp::Ordering;
use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Signed, Zero};

use crate::math::number::Rational;

/// A commutative ring that contains Q.
///
/// ```
/// use polarform::number::rational;
/// use polarform::ring::Ring;
/// fn mean<C: Ring>(a: &C, b: &C) -> C {
///     a.plus(b).scaled(&rational(1, 2))
/// }
/// assert_eq!(mean(&rational(1, 1), &rational(2, 1)), rational(3, 2));
/// ```
pub trait Ring:
    Clone
    + PartialEq
    + Debug
    + Send
    + Sync
    + 'static
    + Zero
    + One
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
{
    /// The rational number `q` as an element of the ring.
    fn from_rational(q: &Rational) -> Self;

    /// self + other
    fn plus(&self, other: &Self) -> Self;

    /// self − other
    fn minus(&self, other: &Self) -> Self;

    /// self · other
    fn times(&self, other: &Self) -> Self;

    /// q · self
    fn scaled(&self, q: &Rational) -> Self {
        self.times(&Self::from_rational(q))
    }

    /// The rational number this element is, if it is one.
    fn as_rational(&self) -> Option<Rational>;

    /// How many terms it is written with, for limits on memory; 1 for a number.
    fn size(&self) -> u64 {
        1
    }

    /// self^exponent by repeated squaring.
    fn powered(&self, exponent: u32) -> Self {
        num_traits::pow(self.clone(), exponent as usize)
    }
}

/// A ring in which every element but 0 has an inverse.
pub trait Field: Ring + Div<Output = Self> {
    /// 1 / self, or `None` for 0.
    fn inverse(&self) -> Option<Self>;
}

/// How two elements are ordered, if their difference is a number.
///
/// ```
/// use polarform::{number::rational, ring::compare};
/// assert_eq!(compare(&rational(1, 3), &rational(1, 2)), Some(std::cmp::Ordering::Less));
/// ```
pub fn compare<C: Ring>(x: &C, y: &C) -> Option<Ordering> {
    let difference = x.minus(y).as_rational()?;
    Some(if difference.is_zero() {
        Ordering::Equal
    } else if difference.is_negative() {
        Ordering::Less
    } else {
        Ordering::Greater
    })
}

impl Ring for Rational {
    fn from_rational(q: &Rational) -> Self {
        q.clone()
    }
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn scaled(&self, q: &Rational) -> Self {
        self * q
    }
    fn as_rational(&self) -> Option<Rational> {
        Some(self.clone())
    }
}

impl Field for Rational {
    fn inverse(&self) -> Option<Self> {
        (!self.is_zero()).then(|| self.recip())
    }
}
