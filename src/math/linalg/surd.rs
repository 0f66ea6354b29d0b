//! The field Q(√2), for tests: it contains Q, and most of its elements are irrational.

use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use crate::math::number::{Rational, integer};
use crate::math::ring::{Field, Ring};

/// p + q √2
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Surd(pub(crate) Rational, pub(crate) Rational);

impl Add for Surd {
    type Output = Surd;
    fn add(self, other: Surd) -> Surd {
        Surd(self.0 + other.0, self.1 + other.1)
    }
}

impl Sub for Surd {
    type Output = Surd;
    fn sub(self, other: Surd) -> Surd {
        Surd(self.0 - other.0, self.1 - other.1)
    }
}

impl Mul for Surd {
    type Output = Surd;
    fn mul(self, other: Surd) -> Surd {
        Surd(&self.0 * &other.0 + &self.1 * &other.1 * integer(2), self.0 * other.1 + self.1 * other.0)
    }
}

impl Neg for Surd {
    type Output = Surd;
    fn neg(self) -> Surd {
        Surd(-self.0, -self.1)
    }
}

impl Div for Surd {
    type Output = Surd;
    fn div(self, other: Surd) -> Surd {
        self.times(&other.inverse().expect("a divisor that is not 0"))
    }
}

impl AddAssign for Surd {
    fn add_assign(&mut self, other: Surd) {
        *self = self.plus(&other);
    }
}

impl SubAssign for Surd {
    fn sub_assign(&mut self, other: Surd) {
        *self = self.minus(&other);
    }
}

impl MulAssign for Surd {
    fn mul_assign(&mut self, other: Surd) {
        *self = self.times(&other);
    }
}

impl Zero for Surd {
    fn zero() -> Self {
        Surd(Rational::zero(), Rational::zero())
    }
    fn is_zero(&self) -> bool {
        self.0.is_zero() && self.1.is_zero()
    }
}

impl One for Surd {
    fn one() -> Self {
        Surd(Rational::one(), Rational::zero())
    }
}

impl Ring for Surd {
    fn from_rational(q: &Rational) -> Self {
        Surd(q.clone(), Rational::zero())
    }
    fn plus(&self, other: &Self) -> Self {
        self.clone() + other.clone()
    }
    fn minus(&self, other: &Self) -> Self {
        self.clone() - other.clone()
    }
    fn times(&self, other: &Self) -> Self {
        self.clone() * other.clone()
    }
    fn as_rational(&self) -> Option<Rational> {
        self.1.is_zero().then(|| self.0.clone())
    }
}

impl Field for Surd {
    fn inverse(&self) -> Option<Self> {
        // (p + q√2)(p − q√2) = p² − 2q², which is 0 only for 0
        let norm = &self.0 * &self.0 - &self.1 * &self.1 * integer(2);
        (!norm.is_zero()).then(|| Surd(&self.0 / &norm, -&self.1 / &norm))
    }
}
