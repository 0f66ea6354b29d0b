//! Hypergeometric terms and their sums.
//!
//! A [`Term`] is r · Π (L!)^±1 · Π b^L · Π symbols, summed over the integer values of its bound
//! variables: r is a rational function, L stands for integer-linear forms, the bases b are not 0.
//!
//! **Factorials in the denominator are entire**: 1/L! is 0 for negative L. With that binomials
//! are n!/(i! (n−i)!) for all integers i and n ≥ 0, and 1/(L−1)! = L/L! holds without exception,
//! so no shift of an argument needs a second look at the boundary.
//!
//! **Guards and facts.** Where a guard G ≥ 0 fails the term is 0 whatever else it holds. A fact
//! D ≥ 0 (`defined`) is true wherever the guards hold and the formula, as written, has a value;
//! every factorial in a numerator comes with the fact that its argument is not negative.
//!
//! Reference for the normal form: Petkovšek, Wilf, Zeilberger, *A = B*, chapter 3.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::{One, Signed, Zero};

use super::linear::Linear;
use crate::budget;
use crate::math::number::{Int, Rational, binomial, factorial};
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Powers, Symbol};
use crate::math::ring::{Field, Ring};

/// Factorial arguments that lie further apart are not compared; larger constant powers are not
/// multiplied out.
const MAX_SHIFT: i64 = 24;
/// The largest factorial of a number that is computed.
const MAX_FACTORIAL: i64 = 300;
/// Powers with more terms are not multiplied out.
const MAX_POWER_TERMS: i64 = 300;

/// A base of powers, ordered by its terms: −1, a number ≥ 2, or a primitive polynomial.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Base(Vec<(Powers, Rational)>);

impl Base {
    /// The polynomial as a base.
    pub fn new(p: &MultiPoly) -> Self {
        Base(p.terms(MonomialOrder::Lex))
    }

    /// The base as a polynomial.
    pub fn poly(&self) -> MultiPoly {
        MultiPoly::from_terms(self.0.clone())
    }

    /// Whether it is −1.
    pub fn is_sign(&self) -> bool {
        self.poly().as_constant().is_some_and(|c| c.is_negative())
    }
}

/// A symbol with indices that may vary, such as b_{i+1}.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Indexed {
    /// What it is called.
    pub head: String,
    /// Its indices.
    pub indices: Vec<Linear>,
}

/// One term; see the head of the module.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// The rational function.
    pub coefficient: Fraction,
    /// Arguments of factorials with their multiplicities, negative in the denominator.
    pub factorials: BTreeMap<Linear, i32>,
    /// Bases with their exponents.
    pub powers: BTreeMap<Base, Linear>,
    /// Indexed symbols with their exponents.
    pub symbols: BTreeMap<Indexed, i32>,
    /// The term is 0 where one of these is negative.
    pub guards: BTreeSet<Linear>,
    /// Not negative where the guards hold and the formula has a value.
    pub defined: BTreeSet<Linear>,
    /// Summation variables.
    pub bound: BTreeSet<Symbol>,
}

impl Term {
    /// A rational function.
    pub fn new(coefficient: Fraction) -> Self {
        Term {
            coefficient,
            factorials: BTreeMap::new(),
            powers: BTreeMap::new(),
            symbols: BTreeMap::new(),
            guards: BTreeSet::new(),
            defined: BTreeSet::new(),
            bound: BTreeSet::new(),
        }
    }

    /// L! or 1/L!.
    pub fn factorial(form: Linear, multiplicity: i32) -> Self {
        let mut term = Term::new(Fraction::one());
        term.multiply_factorial(form, multiplicity);
        term
    }

    /// base^exponent; 0^0 is 1 and 0^L is 0 otherwise. `None` for huge constant exponents.
    pub fn power(base: &Fraction, exponent: &Linear) -> Option<Self> {
        let mut term = Term::new(Fraction::one());
        term.multiply_power(base, exponent)?;
        Some(term)
    }

    /// Multiplies by (L!)^multiplicity.
    pub fn multiply_factorial(&mut self, form: Linear, multiplicity: i32) {
        if multiplicity > 0 {
            self.defined.insert(form.clone());
        }
        let entry = self.factorials.entry(form).or_default();
        *entry = entry.saturating_add(multiplicity);
        self.factorials.retain(|_, m| *m != 0);
    }

    /// Multiplies by base^exponent; `None` for huge constant exponents.
    pub fn multiply_power(&mut self, base: &Fraction, exponent: &Linear) -> Option<()> {
        if base.is_zero() {
            self.guards.insert(exponent.clone());
            self.guards.insert(exponent.negated());
            return Some(());
        }
        if let Some(c) = exponent.as_constant() {
            self.coefficient *= power(base, c.as_small()?)?;
            return Some(());
        }
        for (p, e) in [(base.numerator(), exponent.clone()), (base.denominator(), exponent.negated())] {
            let primitive = p.primitive_part();
            let content = p.div_exact(&primitive)?.as_constant()?;
            if !primitive.is_one() {
                self.multiply_base(&primitive, &e);
            }
            if content.is_negative() {
                self.multiply_base(&MultiPoly::constant(-Rational::one()), &e);
            }
            for (prime, multiplicity) in factors(&content.numer().abs()) {
                self.multiply_base(&prime, &e.scaled(&Int::from(multiplicity)));
            }
            for (prime, multiplicity) in factors(content.denom()) {
                self.multiply_base(&prime, &e.scaled(&Int::from(-multiplicity)));
            }
        }
        Some(())
    }

    fn multiply_base(&mut self, base: &MultiPoly, exponent: &Linear) {
        let base = Base::new(base);
        let sum = match self.powers.remove(&base) {
            Some(old) => old.plus(exponent),
            None => exponent.clone(),
        };
        if sum != Linear::default() {
            self.powers.insert(base, sum);
        }
    }

    /// The product; bound variables must be different ones.
    pub fn times(&self, other: &Term) -> Self {
        let mut product = self.clone();
        product.coefficient = product.coefficient.times(&other.coefficient);
        other.factorials.iter().for_each(|(form, m)| product.multiply_factorial(form.clone(), *m));
        other.powers.iter().for_each(|(base, e)| product.multiply_base(&base.poly(), e));
        for (symbol, e) in &other.symbols {
            let entry = product.symbols.entry(symbol.clone()).or_default();
            *entry = entry.saturating_add(*e);
        }
        product.symbols.retain(|_, e| *e != 0);
        product.guards.extend(other.guards.iter().cloned());
        product.defined.extend(other.defined.iter().cloned());
        product.bound.extend(other.bound.iter().cloned());
        product
    }

    /// r · self
    pub fn scaled(&self, r: &Fraction) -> Self {
        Term { coefficient: self.coefficient.times(r), ..self.clone() }
    }

    /// 1 / self for a term that is no sum and not 0. What made it 0 becomes a fact.
    pub fn inverse(&self) -> Option<Self> {
        if !self.bound.is_empty() {
            return None;
        }
        let mut inverse = Term::new(self.coefficient.inverse()?);
        inverse.defined = self.defined.union(&self.guards).cloned().collect();
        for (form, m) in &self.factorials {
            inverse.defined.insert(form.clone());
            inverse.factorials.insert(form.clone(), m.checked_neg()?);
        }
        inverse.powers = self.powers.iter().map(|(base, e)| (base.clone(), e.negated())).collect();
        inverse.symbols =
            self.symbols.iter().map(|(s, e)| Some((s.clone(), e.checked_neg()?))).collect::<Option<_>>()?;
        Some(inverse)
    }

    /// Puts a form in for an integer symbol; `None` if a denominator vanishes.
    pub fn substitute(&self, symbol: &Symbol, value: &Linear) -> Option<Self> {
        let put = |form: &Linear| form.substitute(symbol, value);
        let coefficient = self.coefficient.substitute(&[(symbol.clone(), value.to_fraction())]).ok()?;
        let mut result = Term::new(coefficient);
        result.guards = self.guards.iter().map(put).collect();
        result.defined = self.defined.iter().map(put).collect();
        result.bound = self.bound.iter().filter(|s| *s != symbol).cloned().collect();
        self.factorials.iter().for_each(|(form, m)| result.multiply_factorial(put(form), *m));
        for (base, e) in &self.powers {
            result.multiply_power(&Fraction::from(base.poly()), &put(e))?;
        }
        for (indexed, e) in &self.symbols {
            let indices = indexed.indices.iter().map(put).collect();
            let entry = result.symbols.entry(Indexed { head: indexed.head.clone(), indices }).or_default();
            *entry = entry.saturating_add(*e);
        }
        result.symbols.retain(|_, e| *e != 0);
        Some(result)
    }

    /// Whether everything but the coefficient and the facts is the same.
    fn is_like(&self, other: &Term) -> bool {
        self.factorials == other.factorials
            && self.powers == other.powers
            && self.symbols == other.symbols
            && self.guards == other.guards
            && self.bound == other.bound
    }

    /// Whether the term is nothing but its coefficient.
    pub fn is_rational(&self) -> bool {
        self.is_like(&Term::new(Fraction::zero()))
    }

    /// Factorials whose arguments differ by a constant cancelled against each other, factorials
    /// of numbers computed. `None` if the arguments lie too far apart, or for (−1)! where the
    /// facts do not say that there is no such place.
    pub fn cancelled(&self) -> Option<Self> {
        let mut by_part: BTreeMap<Linear, (Vec<i64>, Vec<i64>)> = BTreeMap::new();
        let mut term = Term { factorials: BTreeMap::new(), ..self.clone() };
        for (form, m) in &self.factorials {
            let offset = form.offset().as_small()?;
            if form.as_constant().is_some() {
                let value = match usize::try_from(offset) {
                    Ok(small) if offset <= MAX_FACTORIAL => {
                        Fraction::from(Rational::from_integer(factorial(small)))
                    }
                    Ok(_) => return None,
                    Err(_) if *m < 0 => return Some(Term::new(Fraction::zero())),
                    Err(_) => return None,
                };
                term.coefficient *= value.pow(*m).ok()?;
                continue;
            }
            let lists = by_part.entry(form.without_offset()).or_default();
            let list = if *m > 0 { &mut lists.0 } else { &mut lists.1 };
            for _ in 0..m.unsigned_abs().min(64) {
                list.push(offset);
            }
        }
        for (part, (mut above, mut below)) in by_part {
            budget::step();
            let pairs = above.len().min(below.len());
            for (a, b) in above.drain(..pairs).zip(below.drain(..pairs)) {
                // (L+a)!/(L+b)!, where L + a ≥ 0
                let ratio = if a >= b {
                    Fraction::from(rising(&part, b + 1, a)?)
                } else {
                    Fraction::from(rising(&part, a + 1, b)?).inverse()?
                };
                term.coefficient *= ratio;
            }
            for (list, m) in [(above, 1), (below, -1)] {
                for offset in list {
                    *term.factorials.entry(part.shifted(offset)).or_default() += m;
                }
            }
        }
        Some(term)
    }
}

/// base^exponent, if it has not too many terms.
pub fn power(base: &Fraction, exponent: i64) -> Option<Fraction> {
    let k = i32::try_from(exponent).ok().filter(|k| i64::from(k.abs()) <= MAX_SHIFT)?;
    // (x_1 + … + x_m)^k has C(m+k−1, k) terms.
    let most = |p: &MultiPoly| binomial(p.len() + k.unsigned_abs() as usize, k.unsigned_abs() as usize);
    let small = |p: &MultiPoly| p.len() <= 2 || most(p) <= Int::from(MAX_POWER_TERMS);
    if !small(base.numerator()) || !small(base.denominator()) {
        return None;
    }
    base.pow(k).ok()
}

/// (L + from)(L + from + 1) … (L + to); `None` for too many factors.
pub fn rising(part: &Linear, from: i64, to: i64) -> Option<MultiPoly> {
    if to.checked_sub(from)? > MAX_SHIFT {
        return None;
    }
    Some((from..=to).fold(MultiPoly::one(), |product, k| product.times(&part.shifted(k).to_poly())))
}

/// The prime factors up to 1000 of a positive number, and what is left over.
fn factors(number: &Int) -> Vec<(MultiPoly, i64)> {
    let mut rest = number.clone();
    let mut found = Vec::new();
    for p in 2..1000 {
        let prime = Int::from(p);
        let mut multiplicity = 0;
        while !rest.is_one() && (&rest % &prime).is_zero() {
            rest = rest.div_exact(&prime);
            multiplicity += 1;
        }
        if multiplicity > 0 {
            found.push((MultiPoly::constant(Rational::from_integer(prime)), multiplicity));
        }
    }
    if !rest.is_one() {
        found.push((MultiPoly::constant(Rational::from_integer(rest)), 1));
    }
    found
}

/// Adds a term to a sum; like terms become one.
pub fn add(sum: &mut Vec<Term>, term: Term) {
    budget::step();
    if term.coefficient.is_zero() {
        // It may still be undefined somewhere; then the formula says nothing there.
        return;
    }
    match sum.iter_mut().find(|other| other.is_like(&term)) {
        Some(other) => {
            other.coefficient = other.coefficient.plus(&term.coefficient);
            other.defined.extend(term.defined);
        }
        None => sum.push(term),
    }
}

/// A sum with its like terms collected, without those that are 0.
pub fn collected(terms: impl IntoIterator<Item = Term>) -> Vec<Term> {
    let mut sum = Vec::new();
    terms.into_iter().for_each(|term| add(&mut sum, term));
    sum.retain(|term| !term.coefficient.is_zero());
    sum
}
