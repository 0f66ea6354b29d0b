//! Univariate polynomials over Q.
//!
//! **Representation.** F = (a_0 + a_1 t + … + a_n t^n) / d with integers a_k over
//! one common denominator d.
//!
//! **Canonical form.** d > 0, a_n ≠ 0, and no integer above 1 divides d and every
//! a_k; the zero polynomial has no a_k and d = 1. Every constructor and operation
//! establishes it, so equality of values is equality of representations.
//!
//! One denominator means that arithmetic is arithmetic of integer vectors, without
//! a greatest common divisor per coefficient; the common factor is removed once at
//! the end, and where theory bounds it (Gauss's lemma for products, Knuth's rule
//! for sums) by gcds of much smaller numbers.
//!
//! D. E. Knuth, "The Art of Computer Programming" 2, sections 4.5.1 and 4.6;
//! the layout is that of FLINT's `fmpq_poly`.

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::{dense, dense_compose};
use crate::budget;
use crate::math::interval::Interval;
use crate::math::number::{Int, Rational};
use crate::math::ring::Ring;

/// A polynomial in one variable with rational coefficients.
///
/// ```
/// use polarform::number::rational;
/// use polarform::poly::Poly;
/// let t = Poly::variable();
/// let f = &t * &t + Poly::constant(rational(5, 3));
/// assert_eq!(f.to_string(), "t^2 + 5/3");
/// assert_eq!(f.value(&rational(1, 3)), rational(16, 9));
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Poly {
    num: Vec<Int>,
    den: Int,
}

impl Poly {
    /// The polynomial 0.
    pub fn zero() -> Self {
        Poly { num: Vec::new(), den: Int::ONE }
    }

    /// The polynomial 1.
    pub fn one() -> Self {
        Poly { num: vec![Int::ONE], den: Int::ONE }
    }

    /// The polynomial t.
    pub fn variable() -> Self {
        Poly { num: vec![Int::ZERO, Int::ONE], den: Int::ONE }
    }

    /// The polynomial of degree 0 (or 0 itself) with the value c.
    pub fn constant(c: Rational) -> Self {
        Poly::monomial(c, 0)
    }

    /// c t^k
    ///
    /// ```
    /// # use polarform::{number::rational, poly::Poly};
    /// assert_eq!(Poly::monomial(rational(2, 3), 4).to_string(), "2/3 t^4");
    /// ```
    pub fn monomial(c: Rational, k: usize) -> Self {
        if c.is_zero() {
            return Poly::zero();
        }
        budget::charge_terms((k as u64).saturating_add(1));
        let (c, den) = c.into_raw();
        let mut num = vec![Int::ZERO; k];
        num.push(c);
        Poly { num, den }
    }

    /// Σ c_k t^k; trailing zeros are allowed. Cost: one lcm per coefficient, at most.
    ///
    /// ```
    /// # use polarform::{number::rational, poly::Poly};
    /// let f = Poly::from_coefficients(vec![rational(1, 2), rational(0, 1), rational(-2, 3)]);
    /// assert_eq!(f.to_string(), "-2/3 t^2 + 1/2");
    /// ```
    pub fn from_coefficients(coefficients: Vec<Rational>) -> Self {
        let mut den = Int::ONE;
        for c in &coefficients {
            if !den.is_multiple_of(c.denom()) {
                den = den.lcm(c.denom());
            }
        }
        // No factor is common: where a prime power divides den exactly, it divides the
        // denominator of some c_k, whose numerator is then free of that prime.
        let numerator = |c: Rational| {
            let (p, q) = c.into_raw();
            if q == den { p } else { p * den.div_exact(&q) }
        };
        let mut num: Vec<Int> = coefficients.into_iter().map(numerator).collect();
        dense::trim(&mut num);
        Poly { num, den }
    }

    /// (Σ a_k t^k) / den, brought to canonical form.
    ///
    /// # Panics
    /// If `den` is 0.
    ///
    /// ```
    /// # use polarform::{number::Int, poly::Poly};
    /// let f = Poly::from_integers(vec![Int::from(2), Int::from(4), Int::from(0)], Int::from(-6));
    /// assert_eq!(f.to_string(), "-2/3 t - 1/3");
    /// ```
    pub fn from_integers(mut num: Vec<Int>, den: Int) -> Self {
        assert!(!den.is_zero(), "the denominator of a polynomial is 0");
        dense::trim(&mut num);
        if den.is_negative() {
            return Poly::reduced(dense::negated(&num), -&den, &den);
        }
        let bound = den.clone();
        Poly::reduced(num, den, &bound)
    }

    /// num / den in canonical form, given that gcd(content(num), den) divides `bound`; den > 0.
    fn reduced(num: Vec<Int>, den: Int, bound: &Int) -> Self {
        if num.is_empty() {
            return Poly::zero();
        }
        let common = dense::common_divisor(bound, &num);
        Poly { den: den.div_exact(&common), num: dense::divided(num, &common) }
    }

    /// A polynomial with integer coefficients that is known to have no trailing zero.
    pub(super) fn integral_trimmed(num: Vec<Int>) -> Self {
        Poly { num, den: Int::ONE }
    }

    /// The coefficient of t^k; 0 above the degree. Cost: one gcd.
    pub fn coefficient(&self, k: usize) -> Rational {
        match self.num.get(k) {
            Some(a) => Rational::new(a.clone(), self.den.clone()),
            None => Rational::zero(),
        }
    }

    /// All coefficients, the constant one first; empty for 0. Cost: one gcd each.
    pub fn coefficients(&self) -> Vec<Rational> {
        (0..self.num.len()).map(|k| self.coefficient(k)).collect()
    }

    /// The integers a_k of the representation, the constant one first.
    pub fn numerators(&self) -> &[Int] {
        &self.num
    }

    /// The common denominator, positive.
    pub fn denominator(&self) -> &Int {
        &self.den
    }

    /// The numerators and the common denominator.
    pub fn into_parts(self) -> (Vec<Int>, Int) {
        (self.num, self.den)
    }

    /// The degree; `None` for the zero polynomial.
    pub fn degree(&self) -> Option<usize> {
        self.num.len().checked_sub(1)
    }

    /// Whether this is the zero polynomial.
    pub fn is_zero(&self) -> bool {
        self.num.is_empty()
    }

    /// The coefficient of the highest power; 0 for the zero polynomial.
    pub fn leading_coefficient(&self) -> Rational {
        self.degree().map_or_else(Rational::zero, |n| self.coefficient(n))
    }

    /// self / leading coefficient; 0 for the zero polynomial.
    ///
    /// ```
    /// # use polarform::{number::integer, poly::Poly};
    /// let f = Poly::from_coefficients(vec![integer(1), integer(2)]);
    /// assert_eq!(f.leading_monic().to_string(), "t + 1/2");
    /// ```
    pub fn leading_monic(&self) -> Self {
        match self.num.last() {
            Some(lead) => Poly::from_integers(self.num.clone(), lead.clone()),
            None => Poly::zero(),
        }
    }

    /// q · self. Cost: a gcd of the content with q, then one product per coefficient.
    pub fn scale(&self, q: &Rational) -> Self {
        if q.is_zero() || self.is_zero() {
            return Poly::zero();
        }
        let from_num = dense::common_divisor(q.denom(), &self.num);
        let from_den = q.numer().gcd(&self.den);
        let num = dense::divided(self.num.clone(), &from_num);
        Poly {
            num: dense::scaled(&num, &q.numer().div_exact(&from_den)),
            den: self.den.div_exact(&from_den) * q.denom().div_exact(&from_num),
        }
    }

    pub(super) fn sum(&self, other: &Poly) -> Poly {
        if self.den == other.den {
            return Poly::reduced(dense::sum(&self.num, &other.num), self.den.clone(), &self.den);
        }
        // With g = gcd(d, e), a factor common to numerator and denominator divides g
        // (Knuth 4.5.1: the argument for numbers holds for contents).
        let shared = self.den.gcd(&other.den);
        let (m, n) = (other.den.div_exact(&shared), self.den.div_exact(&shared));
        let num = dense::sum(&dense::scaled(&self.num, &m), &dense::scaled(&other.num, &n));
        Poly::reduced(num, &self.den * m, &shared)
    }

    pub(super) fn product(&self, other: &Poly) -> Poly {
        if self.is_zero() || other.is_zero() {
            return Poly::zero();
        }
        if std::ptr::eq(self, other) {
            return Poly { num: dense::product(&self.num, &self.num), den: &self.den * &self.den };
        }
        // Contents multiply (Gauss), so common factors can be removed beforehand.
        let left = dense::common_divisor(&other.den, &self.num);
        let right = dense::common_divisor(&self.den, &other.num);
        let den = self.den.div_exact(&right) * other.den.div_exact(&left);
        if left.is_one() && right.is_one() {
            return Poly { num: dense::product(&self.num, &other.num), den };
        }
        let a = dense::divided(self.num.clone(), &left);
        let b = dense::divided(other.num.clone(), &right);
        Poly { num: dense::product(&a, &b), den }
    }

    pub(super) fn negated(&self) -> Poly {
        Poly { num: dense::negated(&self.num), den: self.den.clone() }
    }

    /// self^exponent by repeated squaring; 0^0 = 1.
    ///
    /// ```
    /// # use polarform::poly::Poly;
    /// let f = Poly::variable() + Poly::one();
    /// assert_eq!(f.pow(3).to_string(), "t^3 + 3 t^2 + 3 t + 1");
    /// ```
    pub fn pow(&self, exponent: u32) -> Poly {
        let (Some(n), false) = (self.degree(), exponent == 0) else {
            return if exponent == 0 { Poly::one() } else { Poly::zero() };
        };
        budget::charge_terms((n as u64).saturating_mul(u64::from(exponent)).saturating_add(1));
        let bits = |x: &Int| x.bits().saturating_sub(1).saturating_mul(u64::from(exponent));
        budget::charge_bits(bits(&self.num[n]).max(bits(&self.den)));
        // Contents multiply (Gauss), so the power is in lowest terms.
        let den = self.den.pow(exponent);
        if self.num[..n].iter().all(Zero::is_zero) {
            let mut num = vec![Int::ZERO; n * exponent as usize];
            num.push(self.num[n].pow(exponent));
            return Poly { num, den };
        }
        Poly { num: dense::power(&self.num, exponent), den }
    }

    /// The value at x. Cost: no gcd but one at the end; O(n) products for small
    /// degree, divide and conquer above.
    ///
    /// ```
    /// # use polarform::{number::rational, poly::Poly};
    /// let f = Poly::variable().pow(2) - Poly::constant(rational(1, 4));
    /// assert_eq!(f.value(&rational(-1, 2)), rational(0, 1));
    /// ```
    pub fn value(&self, x: &Rational) -> Rational {
        let (Some(n), Some(lead)) = (self.degree(), self.num.last()) else {
            return Rational::zero();
        };
        let (p, q) = (x.numer(), x.denom());
        let bits = |y: &Int| y.bits().saturating_sub(1).saturating_mul(n as u64);
        budget::charge_bits(bits(p).max(bits(q)));
        let value = dense_compose::homogeneous_value(&self.num, p, q);
        // The value is N / (d q^n). When lead is prime to q so is N, which spares the long gcd.
        let common = dense::common_divisor(&self.den, std::slice::from_ref(&value));
        let (value, den) = (value.div_exact(&common), self.den.div_exact(&common));
        let q_power = q.pow(n as u32);
        if lead.gcd(q).is_one() {
            Rational::new_raw(value, den * q_power)
        } else {
            Rational::new(value, den * q_power)
        }
    }

    /// The value at an element of a ring over Q, by Horner's rule: n products in the ring.
    ///
    /// ```
    /// # use polarform::poly::Poly;
    /// let f = Poly::variable().pow(2) + Poly::one();
    /// assert_eq!(f.value_in(&f).to_string(), "t^4 + 2 t^2 + 2");
    /// ```
    pub fn value_in<R: Ring>(&self, x: &R) -> R {
        let constant = |a: &Int| R::from_rational(&Rational::from_integer(a.clone()));
        let Some((lead, rest)) = self.num.split_last() else {
            return R::zero();
        };
        let mut value = constant(lead);
        for a in rest.iter().rev() {
            budget::step();
            value *= x.clone();
            if !a.is_zero() {
                value += constant(a);
            }
        }
        if self.den.is_one() {
            return value;
        }
        value.scaled(&Rational::new_raw(Int::ONE, self.den.clone()))
    }

    /// F'
    pub fn derivative(&self) -> Poly {
        self.nth_derivative(1)
    }

    /// The k-th derivative: Σ j (j−1) … (j−k+1) c_j t^{j−k}. Cost: k word products per coefficient, at most.
    ///
    /// ```
    /// # use polarform::poly::Poly;
    /// let f = Poly::variable().pow(4);
    /// assert_eq!(f.nth_derivative(3).to_string(), "24 t");
    /// assert!(f.nth_derivative(5).is_zero());
    /// ```
    pub fn nth_derivative(&self, k: usize) -> Poly {
        if k >= self.num.len() {
            return Poly::zero();
        }
        // j (j−1) … (j−k+1), from one j to the next.
        let mut falling: Int = (1..=k).map(Int::from).product();
        let mut num = Vec::with_capacity(self.num.len() - k);
        for (j, a) in self.num.iter().enumerate().skip(k) {
            if j > k {
                falling = (falling * Int::from(j)).div_exact(&Int::from(j - k));
            }
            num.push(a * &falling);
        }
        Poly::reduced(num, self.den.clone(), &self.den)
    }

    /// The antiderivative with constant term 0.
    ///
    /// ```
    /// # use polarform::poly::Poly;
    /// assert_eq!(Poly::variable().pow(2).antiderivative().to_string(), "1/3 t^3");
    /// ```
    pub fn antiderivative(&self) -> Poly {
        let mut scale = Int::ONE;
        for (k, a) in self.num.iter().enumerate() {
            let exponent = Int::from(k + 1);
            let needed = exponent.div_exact(&exponent.gcd(a));
            if !scale.is_multiple_of(&needed) {
                scale = scale.lcm(&needed);
            }
        }
        let mut num = vec![Int::ZERO];
        num.extend(self.num.iter().enumerate().map(|(k, a)| (a * &scale).div_exact(&Int::from(k + 1))));
        dense::trim(&mut num);
        let den = &self.den * scale;
        Poly::reduced(num, den.clone(), &den)
    }

    /// The integral from the first end to the second one (negative of the one back).
    ///
    /// ```
    /// # use polarform::{interval::Interval, number::integer, poly::Poly};
    /// let f = Poly::variable().pow(2);
    /// assert_eq!(f.integral(&Interval::new(integer(0), integer(3))?), integer(9));
    /// # Ok::<(), polarform::interval::EmptyInterval>(())
    /// ```
    pub fn integral(&self, interval: &Interval<Rational>) -> Rational {
        let (a, b) = interval.ends();
        let antiderivative = self.antiderivative();
        antiderivative.value(b) - antiderivative.value(a)
    }

    /// self ∘ inner, that is self(inner(t)), by divide and conquer.
    ///
    /// Cost: O(M(N) log n) for a result of N bits in all, M the cost of a product.
    ///
    /// ```
    /// # use polarform::poly::Poly;
    /// let t = Poly::variable();
    /// let f = t.pow(2) + &t + &t;
    /// let g = t.pow(3) + Poly::one();
    /// assert_eq!(f.compose(&g).to_string(), "t^6 + 4 t^3 + 3");
    /// ```
    pub fn compose(&self, inner: &Poly) -> Poly {
        let Some(n) = self.degree() else {
            return Poly::zero();
        };
        let Some(lead) = inner.num.last() else {
            return Poly::constant(self.coefficient(0));
        };
        budget::charge_terms((n as u64).saturating_mul(inner.num.len() as u64 - 1).saturating_add(1));
        let bits = |x: &Int| x.bits().saturating_sub(1).saturating_mul(n as u64);
        budget::charge_bits(bits(lead).max(bits(&inner.den)));
        let mut num = dense_compose::composed(&self.num, &inner.num, &inner.den);
        dense::trim(&mut num);
        let den = &self.den * inner.den.pow(n as u32);
        Poly::reduced(num, den.clone(), &den)
    }

    /// F(t + a), the Taylor shift.
    ///
    /// ```
    /// # use polarform::{number::integer, poly::Poly};
    /// assert_eq!(Poly::variable().pow(2).shift(&integer(-1)).to_string(), "t^2 - 2 t + 1");
    /// ```
    pub fn shift(&self, a: &Rational) -> Poly {
        if a.is_zero() || self.num.len() < 2 {
            return self.clone();
        }
        let n = self.num.len() - 1;
        let bits = |x: &Int| x.bits().saturating_sub(1).saturating_mul(n as u64);
        budget::charge_bits(bits(a.numer()).max(bits(a.denom())));
        let num = dense_compose::shifted(&self.num, a.numer(), a.denom());
        let den = &self.den * a.denom().pow(n as u32);
        Poly::reduced(num, den.clone(), &den)
    }

    /// The positive rational c for which self / c has coprime integer coefficients; 0 for 0.
    ///
    /// ```
    /// # use polarform::{number::rational, poly::Poly};
    /// let f = Poly::from_coefficients(vec![rational(-4, 3), rational(2, 1)]);
    /// assert_eq!(f.content(), rational(2, 3));
    /// assert_eq!(f.primitive_part().to_string(), "3 t - 2");
    /// ```
    pub fn content(&self) -> Rational {
        // In lowest terms because the form is canonical.
        Rational::new_raw(dense::content(&self.num), self.den.clone())
    }

    /// self / content: coprime integer coefficients, with the sign of self.
    pub fn primitive_part(&self) -> Poly {
        Poly::integral_trimmed(dense::primitive(self.num.clone()))
    }
}
