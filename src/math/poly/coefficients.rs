//! Polynomials in one variable over any ring.
//!
//! **Canonical form.** The list of coefficients, the constant one first, without trailing zeros; the
//! zero polynomial is the empty list. Equality of values is equality of lists.
//!
//! Long lists of numbers go through [`Poly`], which has one denominator and fast products.

use std::ops::Deref;

use num_traits::Zero;

use super::Poly;
use crate::budget;
use crate::math::number::{Int, Rational};
use crate::math::ring::{Field, Ring};

/// The coefficients of a polynomial c_0 + c_1 t + … + c_n t^n over a ring.
///
/// ```
/// use polarform::number::integer as z;
/// use polarform::poly::Coefficients;
/// let p = Coefficients::new([1, 2].map(z).to_vec()); // 1 + 2t
/// let square = p.times(&p);
/// assert_eq!(*square, [1, 4, 4].map(z));
/// assert_eq!(square.value(&z(3)), z(49));
/// assert_eq!(square.derivative(), p.scaled(&z(4)));
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Coefficients<C>(Vec<C>);

/// From this many products of numbers on, [`Poly`] is faster.
const MANY_PRODUCTS: usize = 64;

impl<C: Ring> Coefficients<C> {
    /// The polynomial with these coefficients, the constant one first; trailing zeros are allowed.
    pub fn new(mut list: Vec<C>) -> Self {
        while list.last().is_some_and(Zero::is_zero) {
            list.pop();
        }
        Coefficients(list)
    }

    /// The polynomial 0.
    pub fn zero() -> Self {
        Coefficients(Vec::new())
    }

    /// The polynomial with the value c everywhere.
    pub fn constant(c: C) -> Self {
        Coefficients::new(vec![c])
    }

    /// (t − x_1) ⋯ (t − x_m); 1 for no roots. Cost: m²/2 products.
    ///
    /// ```
    /// use polarform::number::integer as z;
    /// use polarform::poly::Coefficients;
    /// assert_eq!(*Coefficients::from_roots(&[2, 3].map(z)), [6, -5, 1].map(z));
    /// ```
    pub fn from_roots(roots: &[C]) -> Self {
        let mut product = Coefficients::constant(C::one());
        roots.iter().for_each(|root| product.multiply_by_root(root));
        product
    }

    /// Multiplies by t − root.
    pub fn multiply_by_root(&mut self, root: &C) {
        let list = &mut self.0;
        if list.is_empty() {
            return;
        }
        list.insert(0, C::zero());
        for i in 1..list.len() {
            budget::step();
            let lower = list[i].times(root);
            list[i - 1] -= lower;
        }
    }

    /// The degree; `None` for 0.
    pub fn degree(&self) -> Option<usize> {
        self.0.len().checked_sub(1)
    }

    /// The coefficients, the constant one first; none for 0.
    pub fn into_vec(self) -> Vec<C> {
        self.0
    }

    /// n + 1 coefficients, filled up with zeros.
    ///
    /// # Panics
    /// If the degree is above n.
    pub fn padded(mut self, n: usize) -> Vec<C> {
        assert!(self.0.len() <= n + 1, "the degree is at most {n}");
        self.0.resize(n + 1, C::zero());
        self.0
    }

    /// The same over Q, if all coefficients are numbers.
    fn over_q(&self) -> Option<Poly> {
        self.0.iter().map(Ring::as_rational).collect()
    }

    fn from_q(p: &Poly) -> Self {
        Coefficients(p.coefficients().iter().map(C::from_rational).collect())
    }

    /// The value at t, by Horner's rule. Cost: one product for each degree.
    pub fn value(&self, t: &C) -> C {
        horner(&self.0, t)
    }

    /// p + q
    pub fn plus(&self, other: &Self) -> Self {
        self.combined(other, C::plus)
    }

    /// p − q
    pub fn minus(&self, other: &Self) -> Self {
        self.combined(other, C::minus)
    }

    fn combined(&self, other: &Self, combine: impl Fn(&C, &C) -> C) -> Self {
        let zero = C::zero();
        let length = self.0.len().max(other.0.len());
        let at = |k: usize| combine(self.0.get(k).unwrap_or(&zero), other.0.get(k).unwrap_or(&zero));
        Coefficients::new((0..length).map(at).collect())
    }

    /// p q. Cost: the product of the lengths, for many numbers that of [`Poly`].
    pub fn times(&self, other: &Self) -> Self {
        let (p, q) = (&self.0, &other.0);
        if p.is_empty() || q.is_empty() {
            return Coefficients::zero();
        }
        if p.len() * q.len() > MANY_PRODUCTS
            && let (Some(p), Some(q)) = (self.over_q(), other.over_q())
        {
            return Coefficients::from_q(&(p * q));
        }
        budget::charge_terms((p.len() + q.len()) as u64);
        let mut product = vec![C::zero(); p.len() + q.len() - 1];
        for (i, x) in p.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
            budget::steps(q.len() as u32);
            for (j, y) in q.iter().enumerate() {
                product[i + j] += x.times(y);
            }
        }
        Coefficients::new(product)
    }

    /// c p
    pub fn scaled(&self, c: &C) -> Self {
        Coefficients::new(self.0.iter().map(|x| x.times(c)).collect())
    }

    /// p ∘ inner. Cost: by Horner's rule one product with inner for each degree, for numbers that of
    /// [`Poly::compose`].
    ///
    /// ```
    /// use polarform::number::integer as z;
    /// use polarform::poly::Coefficients;
    /// let p = Coefficients::new([0, 0, 1].map(z).to_vec());
    /// let inner = Coefficients::new([-1, 1].map(z).to_vec());
    /// assert_eq!(*p.compose(&inner), [1, -2, 1].map(z)); // (t − 1)²
    /// ```
    pub fn compose(&self, inner: &Self) -> Self {
        if self.0.len() * inner.0.len() > MANY_PRODUCTS
            && let (Some(p), Some(inner)) = (self.over_q(), inner.over_q())
        {
            return Coefficients::from_q(&p.compose(&inner));
        }
        let mut value = Coefficients::zero();
        for c in self.0.iter().rev() {
            budget::step();
            value = value.times(inner).plus(&Coefficients::constant(c.clone()));
        }
        value
    }

    /// p'
    pub fn derivative(&self) -> Self {
        let terms = self.0.iter().enumerate().skip(1);
        Coefficients(terms.map(|(k, c)| c.scaled(&Rational::from_integer(Int::from(k)))).collect())
    }

    /// The k-th derivative.
    pub fn nth_derivative(&self, k: usize) -> Self {
        (0..k.min(self.0.len())).fold(self.clone(), |p, _| p.derivative())
    }

    /// The antiderivative that is 0 at 0.
    pub fn antiderivative(&self) -> Self {
        let share = |k: usize| Rational::new(Int::ONE, Int::from(k + 1));
        let terms = self.0.iter().enumerate().map(|(k, c)| c.scaled(&share(k)));
        Coefficients::new(std::iter::once(C::zero()).chain(terms).collect())
    }

    /// (q, r) with p = q · (t − root) + r: Horner's rule with all values on the way, so r = p(root).
    ///
    /// ```
    /// use polarform::number::integer as z;
    /// use polarform::poly::Coefficients;
    /// let (quotient, rest) = Coefficients::new([5, 0, 1].map(z).to_vec()).divided_by_root(&z(2));
    /// assert_eq!((quotient.into_vec(), rest), ([2, 1].map(z).to_vec(), z(9)));
    /// ```
    pub fn divided_by_root(&self, root: &C) -> (Self, C) {
        let Some((last, rest)) = self.0.split_last() else { return (Coefficients::zero(), C::zero()) };
        let mut carry = last.clone();
        let mut quotient = Vec::with_capacity(rest.len());
        for c in rest.iter().rev() {
            budget::step();
            let following = carry.times(root).plus(c);
            quotient.push(std::mem::replace(&mut carry, following));
        }
        quotient.reverse();
        (Coefficients(quotient), carry)
    }
}

impl<C: Field> Coefficients<C> {
    /// Quotient and remainder: p = quotient · divisor + remainder with a remainder of lower degree than
    /// the divisor; `None` if that is 0.
    ///
    /// Cost: the product of the lengths of quotient and divisor, for numbers that of [`Poly::div_rem`].
    ///
    /// ```
    /// use polarform::number::{integer as z, rational as q};
    /// use polarform::poly::Coefficients;
    /// let p = Coefficients::new([0, 0, 1].map(z).to_vec());
    /// let (quotient, rest) = p.div_rem(&Coefficients::new([1, 2].map(z).to_vec())).unwrap();
    /// assert_eq!(*quotient, [q(-1, 4), q(1, 2)]);
    /// assert_eq!(*rest, [q(1, 4)]);
    /// ```
    pub fn div_rem(&self, divisor: &Self) -> Option<(Self, Self)> {
        let (lead, lower) = divisor.0.split_last()?;
        let inverse = lead.inverse()?;
        if self.0.len() * divisor.0.len() > MANY_PRODUCTS
            && let (Some(p), Some(divisor)) = (self.over_q(), divisor.over_q())
        {
            let (quotient, rest) = p.div_rem(&divisor)?;
            return Some((Coefficients::from_q(&quotient), Coefficients::from_q(&rest)));
        }
        let mut rest = self.0.clone();
        let mut quotient = vec![C::zero(); (rest.len() + 1).saturating_sub(divisor.0.len())];
        while rest.len() > lower.len() {
            budget::steps(divisor.0.len() as u32);
            let shift = rest.len() - divisor.0.len();
            let Some(top) = rest.pop() else { break };
            let factor = top.times(&inverse);
            for (x, c) in rest[shift..].iter_mut().zip(lower) {
                *x = x.minus(&c.times(&factor));
            }
            quotient[shift] = factor;
        }
        Some((Coefficients::new(quotient), Coefficients::new(rest)))
    }
}

impl<C> Deref for Coefficients<C> {
    type Target = [C];
    fn deref(&self) -> &[C] {
        &self.0
    }
}

impl<C: Ring> FromIterator<C> for Coefficients<C> {
    fn from_iter<I: IntoIterator<Item = C>>(list: I) -> Self {
        Coefficients::new(list.into_iter().collect())
    }
}

impl<C: Ring> From<Vec<C>> for Coefficients<C> {
    fn from(list: Vec<C>) -> Self {
        Coefficients::new(list)
    }
}

/// Σ c_i t^i, lowest coefficient first, as by [`Coefficients::value`].
pub(crate) fn horner<C: Ring>(coefficients: &[C], t: &C) -> C {
    coefficients.iter().rev().fold(C::zero(), |sum, c| {
        budget::step();
        sum.times(t).plus(c)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer, rational};
    use crate::math::poly::{Fraction, MultiPoly, Symbol};
    use proptest::prelude::*;

    fn any_list(length: usize) -> impl Strategy<Value = Coefficients<Rational>> {
        prop::collection::vec((-9i64..10, 1i64..4), 0..length)
            .prop_map(|list| Coefficients::new(list.into_iter().map(|(p, q)| rational(p, q)).collect()))
    }

    /// The same over a ring that is not Q: each coefficient times a + 1, with a put in afterwards.
    fn symbolic(p: &Coefficients<Rational>) -> Coefficients<Fraction> {
        let a = Fraction::from(MultiPoly::symbol(Symbol::new("a")));
        Coefficients::new(
            p.iter().map(|c| Fraction::from(c.clone()).times(&a.plus(&num_traits::One::one()))).collect(),
        )
    }

    fn at_zero(p: &Coefficients<Fraction>) -> Coefficients<Rational> {
        let zero = |_: &Symbol| Some(integer(0));
        Coefficients::new(p.iter().map(|c| c.value(&zero).unwrap()).collect())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(60))]
        #[test]
        fn operations_agree_with_values(p in any_list(14), q in any_list(14), x in -3i64..4) {
            let x = integer(x);
            let (a, b) = (p.value(&x), q.value(&x));
            prop_assert_eq!(p.plus(&q).value(&x), &a + &b);
            prop_assert_eq!(p.minus(&q).value(&x), &a - &b);
            prop_assert_eq!(p.times(&q).value(&x), &a * &b);
            prop_assert_eq!(p.compose(&q).value(&x), p.value(&b));
            prop_assert_eq!(p.antiderivative().derivative(), p.clone());
            let (quotient, rest) = p.divided_by_root(&x);
            prop_assert_eq!(&rest, &a);
            let mut back = quotient;
            back.multiply_by_root(&x);
            prop_assert_eq!(back.plus(&Coefficients::constant(rest)), p.clone());
            match p.div_rem(&q) {
                None => prop_assert_eq!(q.degree(), None),
                Some((quotient, rest)) => {
                    prop_assert!(rest.degree() < q.degree());
                    prop_assert_eq!(quotient.times(&q).plus(&rest), p);
                }
            }
        }

        #[test]
        fn every_ring_agrees_with_numbers(p in any_list(12), q in any_list(12)) {
            let (f, g) = (symbolic(&p), symbolic(&q));
            prop_assert_eq!(at_zero(&f.times(&g)), p.times(&q));
            prop_assert_eq!(at_zero(&f.plus(&g)), p.plus(&q));
            if let Some((quotient, rest)) = f.div_rem(&g) {
                let expected = p.div_rem(&q).unwrap();
                prop_assert_eq!((at_zero(&quotient), at_zero(&rest)), expected);
            }
        }
    }
}
