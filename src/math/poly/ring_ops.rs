//! Multivariate polynomials as a ring: operators, constants, printing.

use std::fmt;
use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Signed, Zero};

use super::multiply;
use super::multivariate::{MonomialOrder, MultiPoly};
use crate::math::number::Rational;
use crate::math::ring::Ring;

impl Ring for MultiPoly {
    fn from_rational(q: &Rational) -> Self {
        MultiPoly::constant(q.clone())
    }
    fn plus(&self, other: &Self) -> Self {
        self.combined(other, false)
    }
    fn minus(&self, other: &Self) -> Self {
        self.combined(other, true)
    }
    fn times(&self, other: &Self) -> Self {
        match (self.as_constant(), other.as_constant()) {
            (_, Some(q)) => self.scaled(&q),
            (Some(q), _) => other.scaled(&q),
            _ => multiply::product(self, other),
        }
    }
    fn scaled(&self, q: &Rational) -> Self {
        if q.is_zero() {
            return MultiPoly::zero();
        }
        if q.is_one() {
            return self.clone();
        }
        let terms = self.terms.iter().map(|(e, c)| (e.clone(), c * q.numer())).collect();
        MultiPoly::from_sorted(self.vars.clone(), terms, &self.den * q.denom())
    }
    fn as_rational(&self) -> Option<Rational> {
        self.as_constant()
    }
    fn size(&self) -> u64 {
        self.len() as u64
    }
    fn powered(&self, exponent: u32) -> Self {
        self.pow(exponent)
    }
}

impl Zero for MultiPoly {
    fn zero() -> Self {
        MultiPoly::zero()
    }
    fn is_zero(&self) -> bool {
        self.is_empty()
    }
}

impl One for MultiPoly {
    fn one() -> Self {
        MultiPoly::constant(Rational::one())
    }
    fn is_one(&self) -> bool {
        self.as_constant().is_some_and(|c| c.is_one())
    }
}

impl Neg for MultiPoly {
    type Output = MultiPoly;
    fn neg(mut self) -> MultiPoly {
        self.terms.iter_mut().for_each(|(_, c)| *c = -std::mem::take(c));
        self
    }
}

/// The operators of a ring type by value, from the methods of [`Ring`].
macro_rules! ring_operators {
    ($($Trait:ident $method:ident $Assign:ident $assign:ident $op:ident),*; $T:ty) => {$(
        impl $Trait for $T {
            type Output = $T;
            fn $method(self, other: $T) -> $T {
                self.$op(&other)
            }
        }
        impl $Trait<&$T> for &$T {
            type Output = $T;
            fn $method(self, other: &$T) -> $T {
                self.$op(other)
            }
        }
        impl $Assign for $T {
            fn $assign(&mut self, other: $T) {
                *self = self.$op(&other);
            }
        }
    )*};
}
pub(super) use ring_operators;

ring_operators!(
    Add add AddAssign add_assign plus,
    Sub sub SubAssign sub_assign minus,
    Mul mul MulAssign mul_assign times;
    MultiPoly
);

impl fmt::Display for MultiPoly {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_empty() {
            return f.write_str("0");
        }
        for (i, (powers, c)) in self.terms(MonomialOrder::GrLex).iter().enumerate() {
            let sign = match (i, c.is_negative()) {
                (0, true) => "-",
                (0, false) => "",
                (_, true) => " - ",
                (_, false) => " + ",
            };
            f.write_str(sign)?;
            let magnitude = c.abs();
            if powers.is_empty() || !magnitude.is_one() {
                write!(f, "{magnitude}")?;
                if !powers.is_empty() {
                    f.write_str(" ")?;
                }
            }
            for (k, (symbol, e)) in powers.iter().enumerate() {
                let space = if k > 0 { " " } else { "" };
                write!(f, "{space}{symbol}")?;
                if *e > 1 {
                    write!(f, "^{e}")?;
                }
            }
        }
        Ok(())
    }
}

impl fmt::Debug for MultiPoly {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
