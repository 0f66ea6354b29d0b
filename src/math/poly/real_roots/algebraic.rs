//! Real algebraic numbers: a polynomial, and an interval in which it has one root.
//!
//! S. Basu, R. Pollack, M.-F. Roy, "Algorithms in Real Algebraic Geometry", section 10.2.

use std::cmp::Ordering;
use std::fmt;

use num_traits::{One, Signed, Zero};

use super::bernstein;
use crate::budget;
use crate::math::number::{Rational, integer};
use crate::math::poly::Poly;

/// A real number that is not rational, the only root of a polynomial between two rational numbers.
///
/// **Invariant.** The polynomial has coprime integer coefficients, simple roots and no rational root; it has
/// exactly one root in the interval, so its values at the ends differ in sign. Two such numbers are equal if they are
/// the same number, whatever their polynomials and intervals.
///
/// ```
/// use polarform::number::{integer, rational};
/// use polarform::poly::{Poly, RealRoot};
/// let f = Poly::variable().pow(2) - Poly::from(2);
/// let roots = f.real_roots(Some(&integer(0)), None).unwrap();
/// let [(RealRoot::Irrational(root), 1)] = roots.as_slice() else { panic!("one root") };
/// assert!(root.compare_with(&rational(7, 5)).is_gt());
/// let (lower, upper) = root.refined(&rational(1, 1000)).ends();
/// assert!(upper - lower <= rational(1, 1000));
/// ```
#[derive(Clone, Debug)]
pub struct AlgebraicNumber {
    polynomial: Poly,
    lower: Rational,
    upper: Rational,
}

impl AlgebraicNumber {
    /// The root in an interval that contains at most one; `None` if there is none.
    pub(super) fn between(polynomial: &Poly, lower: Rational, upper: Rational) -> Option<Self> {
        let changes = polynomial.value(&lower).is_negative() != polynomial.value(&upper).is_negative();
        changes.then(|| AlgebraicNumber { polynomial: polynomial.clone(), lower, upper })
    }

    /// A polynomial of which it is a simple root.
    pub fn polynomial(&self) -> &Poly {
        &self.polynomial
    }

    /// The ends of an interval that contains no other root of the polynomial.
    pub fn ends(&self) -> (Rational, Rational) {
        (self.lower.clone(), self.upper.clone())
    }

    /// The same number in an interval that is not wider. Cost: one value of the polynomial for each bit.
    ///
    /// # Panics
    /// If the width is not positive.
    pub fn refined(&self, width: &Rational) -> Self {
        assert!(width.is_positive(), "an interval needs a positive width");
        let mut number = self.clone();
        while &number.upper - &number.lower > *width {
            number.halve();
        }
        number
    }

    /// How it compares with a rational number. Cost: a value of the polynomial.
    pub fn compare_with(&self, q: &Rational) -> Ordering {
        if *q <= self.lower {
            return Ordering::Greater;
        }
        if *q >= self.upper {
            return Ordering::Less;
        }
        match self.polynomial.value(q).is_negative() == self.polynomial.value(&self.lower).is_negative() {
            true => Ordering::Greater,
            false => Ordering::Less,
        }
    }

    /// The sign of F at the number: equal if F is 0 there. Cost: a gcd, then bisection until F has
    /// Bernstein coefficients of one sign.
    ///
    /// ```
    /// # use polarform::poly::{Poly, RealRoot};
    /// let t = Poly::variable();
    /// let f = t.pow(2) - Poly::from(2);
    /// let RealRoot::Irrational(root) = f.real_roots(None, None).unwrap().remove(1).0 else { panic!() };
    /// assert!(root.sign_of(&(t.pow(4) - Poly::from(4))).is_eq());
    /// assert!(root.sign_of(&(t.pow(3) - Poly::from(3))).is_lt());
    /// ```
    pub fn sign_of(&self, f: &Poly) -> Ordering {
        if f.is_zero() || self.is_root_of(&self.polynomial.gcd(f)) {
            return Ordering::Equal;
        }
        let mut number = self.clone();
        loop {
            let list = bernstein::over(f.numerators(), &number.lower, &number.upper);
            if list.iter().all(Signed::is_positive) {
                return Ordering::Greater;
            }
            if list.iter().all(Signed::is_negative) {
                return Ordering::Less;
            }
            number.halve();
        }
    }

    /// Whether it is a root of a divisor of its polynomial.
    fn is_root_of(&self, divisor: &Poly) -> bool {
        divisor.value(&self.lower).is_negative() != divisor.value(&self.upper).is_negative()
    }

    fn halve(&mut self) {
        budget::steps(1 + self.polynomial.degree().unwrap_or(0) as u32);
        let middle = (&self.lower + &self.upper) / integer(2);
        match self.compare_with(&middle) {
            Ordering::Greater => self.lower = middle,
            _ => self.upper = middle,
        }
    }

    /// Halves the interval until it tells the sign of the number, and the number up to a factor of 2 and to 1.
    pub(super) fn tighten(&mut self) {
        loop {
            let width = &self.upper - &self.lower;
            let least = self.lower.abs().min(self.upper.abs());
            let one_sign = self.lower.is_positive() || self.upper.is_negative();
            if one_sign && width <= least && width <= Rational::one() {
                return;
            }
            self.halve();
        }
    }

    /// Halves the interval until another number is not between its ends.
    pub(super) fn separate(&mut self, q: &Rational) {
        while self.lower < *q && *q < self.upper {
            self.halve();
        }
    }
}

impl fmt::Display for AlgebraicNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} in ({}, {})", self.polynomial, self.lower, self.upper)
    }
}

impl Ord for AlgebraicNumber {
    /// Cost: a gcd if the intervals overlap, then bisection until they do not.
    fn cmp(&self, other: &Self) -> Ordering {
        let (mut a, mut b) = (self.clone(), other.clone());
        let mut known_to_differ = false;
        loop {
            if a.upper <= b.lower {
                return Ordering::Less;
            }
            if b.upper <= a.lower {
                return Ordering::Greater;
            }
            if !known_to_differ {
                // They are equal if a common factor has a root where the intervals overlap: it is the only
                // root of both polynomials there.
                let common = a.polynomial.gcd(&b.polynomial);
                let lower = a.lower.clone().max(b.lower.clone());
                let upper = a.upper.clone().min(b.upper.clone());
                if AlgebraicNumber::between(&common, lower, upper).is_some() {
                    return Ordering::Equal;
                }
                known_to_differ = true;
            }
            a.halve();
            b.halve();
        }
    }
}

impl PartialOrd for AlgebraicNumber {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for AlgebraicNumber {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for AlgebraicNumber {}

/// A real root of a polynomial with rational coefficients.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RealRoot {
    /// A rational number.
    Rational(Rational),
    /// Another number.
    Irrational(AlgebraicNumber),
}

impl RealRoot {
    /// The sign of F there.
    pub fn sign_of(&self, f: &Poly) -> Ordering {
        match self {
            RealRoot::Rational(q) => f.value(q).cmp(&Rational::zero()),
            RealRoot::Irrational(number) => number.sign_of(f),
        }
    }
}

impl Ord for RealRoot {
    fn cmp(&self, other: &Self) -> Ordering {
        match (self, other) {
            (RealRoot::Rational(a), RealRoot::Rational(b)) => a.cmp(b),
            (RealRoot::Irrational(a), RealRoot::Rational(b)) => a.compare_with(b),
            (RealRoot::Rational(a), RealRoot::Irrational(b)) => b.compare_with(a).reverse(),
            (RealRoot::Irrational(a), RealRoot::Irrational(b)) => a.cmp(b),
        }
    }
}

impl PartialOrd for RealRoot {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Display for RealRoot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RealRoot::Rational(q) => q.fmt(f),
            RealRoot::Irrational(number) => number.fmt(f),
        }
    }
}
