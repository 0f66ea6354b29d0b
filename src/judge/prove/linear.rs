//! Integer-linear forms such as n − i + 1: the entries of binomials, indices and exponents.
//!
//! **Canonical form.** Symbols in ascending order with nonzero integer coefficients, and a
//! constant. Equality of forms is equality of representations.

use std::collections::BTreeMap;

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::math::number::{Int, Rational};
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};

/// c + Σ a_s s with integers c and a_s.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Linear {
    terms: BTreeMap<Symbol, Int>,
    constant: Int,
}

impl Linear {
    /// The constant form.
    pub fn constant(value: impl Into<Int>) -> Self {
        Linear { terms: BTreeMap::new(), constant: value.into() }
    }

    /// The form that is just a symbol.
    pub fn symbol(symbol: &Symbol) -> Self {
        Linear { terms: BTreeMap::from([(symbol.clone(), Int::ONE)]), constant: Int::ZERO }
    }

    /// The polynomial as a form, if it has degree at most 1, integer coefficients and plain symbols.
    pub fn from_poly(p: &MultiPoly) -> Option<Self> {
        let mut form = Linear::default();
        for (powers, c) in p.terms(MonomialOrder::Lex) {
            if !c.is_integer() {
                return None;
            }
            match powers.as_slice() {
                [] => form.constant = c.numer().clone(),
                [(symbol, 1)] => {
                    form.terms.insert(symbol.clone(), c.numer().clone());
                }
                _ => return None,
            }
        }
        Some(form)
    }

    /// The form as a polynomial.
    pub fn to_poly(&self) -> MultiPoly {
        let linear =
            self.terms.iter().map(|(s, a)| (vec![(s.clone(), 1)], Rational::from_integer(a.clone())));
        MultiPoly::from_terms(linear.chain([(Vec::new(), Rational::from_integer(self.constant.clone()))]))
    }

    /// The form as a rational function.
    pub fn to_fraction(&self) -> Fraction {
        Fraction::from(self.to_poly())
    }

    /// The symbols with their coefficients.
    pub fn terms(&self) -> &BTreeMap<Symbol, Int> {
        &self.terms
    }

    /// The constant c.
    pub fn offset(&self) -> &Int {
        &self.constant
    }

    /// The form without its constant.
    pub fn without_offset(&self) -> Self {
        Linear { terms: self.terms.clone(), constant: Int::ZERO }
    }

    /// The value, if no symbol occurs.
    pub fn as_constant(&self) -> Option<&Int> {
        self.terms.is_empty().then_some(&self.constant)
    }

    /// The symbol, if the form is just a symbol.
    pub fn as_symbol(&self) -> Option<&Symbol> {
        match self.terms.first_key_value() {
            Some((symbol, a)) if self.terms.len() == 1 && a.is_one() && self.constant.is_zero() => {
                Some(symbol)
            }
            _ => None,
        }
    }

    /// The coefficient of a symbol.
    pub fn coefficient(&self, symbol: &Symbol) -> Int {
        self.terms.get(symbol).cloned().unwrap_or(Int::ZERO)
    }

    /// Whether the symbol occurs.
    pub fn contains(&self, symbol: &Symbol) -> bool {
        self.terms.contains_key(symbol)
    }

    /// self + factor · other
    pub fn plus_multiple(&self, other: &Linear, factor: &Int) -> Self {
        let mut sum = self.clone();
        for (symbol, a) in &other.terms {
            let entry = sum.terms.entry(symbol.clone()).or_default();
            *entry += &(a * factor);
        }
        sum.terms.retain(|_, a| !a.is_zero());
        sum.constant += &(&other.constant * factor);
        sum
    }

    /// self + other
    pub fn plus(&self, other: &Linear) -> Self {
        self.plus_multiple(other, &Int::ONE)
    }

    /// self − other
    pub fn minus(&self, other: &Linear) -> Self {
        self.plus_multiple(other, &-Int::ONE)
    }

    /// factor · self
    pub fn scaled(&self, factor: &Int) -> Self {
        Linear::default().plus_multiple(self, factor)
    }

    /// −self
    pub fn negated(&self) -> Self {
        self.scaled(&-Int::ONE)
    }

    /// self + value
    pub fn shifted(&self, value: i64) -> Self {
        self.plus(&Linear::constant(value))
    }

    /// The form with another form put in for a symbol.
    pub fn substitute(&self, symbol: &Symbol, value: &Linear) -> Self {
        let mut rest = self.clone();
        match rest.terms.remove(symbol) {
            Some(a) => rest.plus_multiple(value, &a),
            None => rest,
        }
    }

    /// The inequality self ≥ 0 with the common factor of its coefficients taken out; integers
    /// allow the constant to be rounded down.
    pub fn tightened(&self) -> Self {
        let g = self.terms.values().fold(Int::ZERO, |g, a| g.gcd(a));
        if g.is_zero() || g.is_one() {
            return self.clone();
        }
        let terms = self.terms.iter().map(|(s, a)| (s.clone(), a.div_exact(&g))).collect();
        Linear { terms, constant: self.constant.div_floor(&g) }
    }
}

impl std::fmt::Display for Linear {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        // Positive terms first, as one writes n − i + 1.
        let (positive, negative): (Vec<_>, Vec<_>) = self.terms.iter().partition(|(_, a)| a.is_positive());
        for (k, (symbol, a)) in positive.into_iter().chain(negative).enumerate() {
            match (k, a.is_negative()) {
                (0, true) => f.write_str("-")?,
                (0, false) => {}
                (_, true) => f.write_str(" - ")?,
                (_, false) => f.write_str(" + ")?,
            }
            let size = a.abs();
            if !size.is_one() {
                write!(f, "{size}")?;
            }
            write!(f, "{symbol}")?;
        }
        match (self.terms.is_empty(), self.constant.is_negative(), self.constant.is_zero()) {
            (true, ..) => write!(f, "{}", self.constant),
            (_, _, true) => Ok(()),
            (_, true, _) => write!(f, " - {}", self.constant.abs()),
            _ => write!(f, " + {}", self.constant),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn form(n: i64, i: i64, c: i64) -> Linear {
        let part = |name: &str, a: i64| Linear::symbol(&Symbol::new(name)).scaled(&Int::from(a));
        part("n", n).plus(&part("i", i)).shifted(c)
    }

    #[test]
    fn text() {
        assert_eq!(form(1, -1, 1).to_string(), "n - i + 1");
        assert_eq!(form(0, -2, 0).to_string(), "-2i");
        assert_eq!(form(0, 0, -3).to_string(), "-3");
    }

    proptest! {
        #[test]
        fn forms_are_polynomials(a in -4i64..5, b in -4i64..5, c in -4i64..5, d in -4i64..5) {
            let (x, y) = (form(a, b, c), form(b, d, a));
            prop_assert_eq!(Linear::from_poly(&x.to_poly()), Some(x.clone()));
            prop_assert_eq!(x.plus(&y).to_poly(), x.to_poly() + y.to_poly());
            prop_assert_eq!(x.minus(&x), Linear::default());
            let n = Symbol::new("n");
            let by_poly = x.to_poly().substitute(&[(n.clone(), y.to_poly())]);
            prop_assert_eq!(x.substitute(&n, &y).to_poly(), by_poly);
        }

        #[test]
        fn tightening_keeps_the_integer_points(a in -4i64..5, b in -4i64..5, c in -9i64..10, n in -9i64..10, i in -9i64..10) {
            let at = |f: &Linear| f.substitute(&Symbol::new("n"), &Linear::constant(n))
                .substitute(&Symbol::new("i"), &Linear::constant(i))
                .as_constant().is_some_and(|value| !value.is_negative());
            let f = form(a, b, c);
            prop_assert_eq!(at(&f), at(&f.tightened()));
        }
    }
}
