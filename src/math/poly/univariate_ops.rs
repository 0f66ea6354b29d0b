//! Operators, text and conversions of [`Poly`].

use std::fmt;
use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Signed, Zero};

use super::Poly;
use crate::math::number::{Int, Rational};
use crate::math::ring::Ring;

macro_rules! binary {
    ($Trait:ident, $method:ident, $Assign:ident, $assign:ident, |$a:ident, $b:ident| $result:expr) => {
        impl $Trait<&Poly> for &Poly {
            type Output = Poly;
            fn $method(self, rhs: &Poly) -> Poly {
                let ($a, $b) = (self, rhs);
                $result
            }
        }
        impl $Trait<Poly> for &Poly {
            type Output = Poly;
            fn $method(self, rhs: Poly) -> Poly {
                self.$method(&rhs)
            }
        }
        impl $Trait<&Poly> for Poly {
            type Output = Poly;
            fn $method(self, rhs: &Poly) -> Poly {
                (&self).$method(rhs)
            }
        }
        impl $Trait<Poly> for Poly {
            type Output = Poly;
            fn $method(self, rhs: Poly) -> Poly {
                (&self).$method(&rhs)
            }
        }
        impl $Assign<&Poly> for Poly {
            fn $assign(&mut self, rhs: &Poly) {
                *self = (&*self).$method(rhs);
            }
        }
        impl $Assign<Poly> for Poly {
            fn $assign(&mut self, rhs: Poly) {
                *self = (&*self).$method(&rhs);
            }
        }
    };
}
binary!(Add, add, AddAssign, add_assign, |a, b| a.sum(b));
binary!(Sub, sub, SubAssign, sub_assign, |a, b| a.sum(&b.negated()));
binary!(Mul, mul, MulAssign, mul_assign, |a, b| a.product(b));

impl Neg for &Poly {
    type Output = Poly;
    fn neg(self) -> Poly {
        self.negated()
    }
}

impl Neg for Poly {
    type Output = Poly;
    fn neg(self) -> Poly {
        self.negated()
    }
}

impl Zero for Poly {
    fn zero() -> Self {
        Poly::zero()
    }
    fn is_zero(&self) -> bool {
        Poly::is_zero(self)
    }
}

impl One for Poly {
    fn one() -> Self {
        Poly::one()
    }
}

impl Default for Poly {
    fn default() -> Self {
        Poly::zero()
    }
}

impl Ring for Poly {
    fn from_rational(q: &Rational) -> Self {
        Poly::constant(q.clone())
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
        self.scale(q)
    }
    fn as_rational(&self) -> Option<Rational> {
        self.degree().is_none_or(|n| n == 0).then(|| self.coefficient(0))
    }
    fn powered(&self, exponent: u32) -> Self {
        self.pow(exponent)
    }
}

impl From<Rational> for Poly {
    fn from(c: Rational) -> Self {
        Poly::constant(c)
    }
}

impl From<Int> for Poly {
    fn from(c: Int) -> Self {
        Poly::constant(Rational::from_integer(c))
    }
}

impl From<i64> for Poly {
    fn from(c: i64) -> Self {
        Poly::from(Int::from(c))
    }
}

impl FromIterator<Rational> for Poly {
    /// The polynomial with these coefficients, the constant one first.
    fn from_iter<I: IntoIterator<Item = Rational>>(coefficients: I) -> Self {
        Poly::from_coefficients(coefficients.into_iter().collect())
    }
}

impl std::iter::Sum for Poly {
    fn sum<I: Iterator<Item = Poly>>(terms: I) -> Poly {
        terms.fold(Poly::zero(), |a, b| a + b)
    }
}

impl std::iter::Product for Poly {
    fn product<I: Iterator<Item = Poly>>(factors: I) -> Poly {
        factors.fold(Poly::one(), |a, b| a * b)
    }
}

/// In the variable t, highest power first: `t^3 - 3 t^2 + 5/3`.
impl fmt::Display for Poly {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return f.write_str("0");
        }
        let mut first = true;
        for k in (0..self.numerators().len()).rev() {
            if self.numerators()[k].is_zero() {
                continue;
            }
            let c = self.coefficient(k);
            f.write_str(match (first, c.is_negative()) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            })?;
            first = false;
            let size = c.abs();
            if k == 0 {
                write!(f, "{size}")?;
                continue;
            }
            if !size.is_one() {
                write!(f, "{size} ")?;
            }
            match k {
                1 => f.write_str("t")?,
                _ => write!(f, "t^{k}")?,
            }
        }
        Ok(())
    }
}

impl fmt::Debug for Poly {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
