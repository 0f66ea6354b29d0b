//! Sparse polynomials in several named symbols over Q.
//!
//! **Canonical form.** The variables are in ascending order and each occurs in some term;
//! the terms are in descending lexicographic order with nonzero integer coefficients; one
//! positive denominator is shared by all and has no factor in common with all of them.
//! Zero has no variables, no terms and denominator 1. All constructors establish this, so
//! equality of values is equality of representations.
//!
//! One common denominator means that sums and products take no gcd per coefficient; the
//! single pass at the end stops as soon as the gcd is 1.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use smallvec::SmallVec;

use super::symbol::Symbol;
use super::{dense, one_variable};
use crate::budget;
use crate::math::number::{Int, Rational};
use crate::math::ring::Ring;

/// Exponents of the variables, in their order.
pub(super) type Exponents = SmallVec<[u32; 6]>;
pub(super) type Terms = Vec<(Exponents, Int)>;

/// The order in which terms are listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MonomialOrder {
    /// By the exponent of the first variable, then the second, …
    Lex,
    /// By total degree, then lexicographically.
    GrLex,
    /// By total degree, then by the smallest exponent of the last variable.
    GrevLex,
}

impl MonomialOrder {
    /// Which of two monomials is larger, by their exponents.
    pub(in crate::math) fn compare(self, a: &[u32], b: &[u32]) -> std::cmp::Ordering {
        let total = |e: &[u32]| e.iter().map(|&x| u64::from(x)).sum::<u64>();
        match self {
            MonomialOrder::Lex => a.cmp(b),
            MonomialOrder::GrLex => total(a).cmp(&total(b)).then_with(|| a.cmp(b)),
            MonomialOrder::GrevLex => {
                total(a).cmp(&total(b)).then_with(|| b.iter().rev().cmp(a.iter().rev()))
            }
        }
    }
}

/// A monomial as symbols with their exponents.
pub type Powers = Vec<(Symbol, u32)>;

/// A polynomial in several symbols over Q.
///
/// ```
/// use polarform::number::rational;
/// use polarform::poly::{MultiPoly, Symbol};
/// let (x, y) = (MultiPoly::symbol(Symbol::new("x")), MultiPoly::symbol(Symbol::new("y")));
/// let p = (x.clone() + y.clone()) * (x.clone() - y.clone());
/// assert_eq!(p, x.clone() * x - y.clone() * y);
/// assert_eq!(p.to_string(), "x^2 - y^2");
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct MultiPoly {
    pub(super) vars: Arc<[Symbol]>,
    pub(super) terms: Terms,
    pub(super) den: Int,
}

/// One empty list for all constants of a thread.
fn no_variables() -> Arc<[Symbol]> {
    thread_local! {
        static NONE: Arc<[Symbol]> = Arc::from([]);
    }
    NONE.with(Arc::clone)
}

impl MultiPoly {
    /// 0
    pub fn zero() -> Self {
        MultiPoly { vars: no_variables(), terms: Vec::new(), den: Int::ONE }
    }

    /// The constant polynomial c.
    pub fn constant(c: Rational) -> Self {
        if c.is_zero() {
            return MultiPoly::zero();
        }
        let (numerator, den) = c.into_raw();
        MultiPoly { vars: no_variables(), terms: vec![(Exponents::new(), numerator)], den }
    }

    /// The polynomial that is just a symbol.
    pub fn symbol(symbol: Symbol) -> Self {
        let one = Exponents::from_slice(&[1]);
        MultiPoly { vars: Arc::from([symbol]), terms: vec![(one, Int::ONE)], den: Int::ONE }
    }

    /// The sum of the given terms; equal monomials add up.
    ///
    /// ```
    /// use polarform::{number::integer, poly::{MultiPoly, Symbol}};
    /// let x = Symbol::new("x");
    /// let p = MultiPoly::from_terms([(vec![(x.clone(), 1)], integer(2)), (vec![(x, 1)], integer(3))]);
    /// assert_eq!(p.to_string(), "5 x");
    /// ```
    pub fn from_terms(terms: impl IntoIterator<Item = (Powers, Rational)>) -> Self {
        let terms: Vec<(Powers, Rational)> = terms.into_iter().collect();
        let mut vars: Vec<Symbol> =
            terms.iter().flat_map(|(powers, _)| powers.iter().map(|(symbol, _)| symbol.clone())).collect();
        vars.sort_unstable();
        vars.dedup();
        let den = terms.iter().fold(Int::ONE, |l, (_, c)| l.lcm(c.denom()));
        let list = terms
            .into_iter()
            .map(|(powers, c)| {
                let mut exponents = Exponents::from_elem(0, vars.len());
                for (symbol, e) in powers {
                    if let Ok(at) = vars.binary_search(&symbol) {
                        exponents[at] += e;
                    }
                }
                (exponents, c.numer() * den.div_exact(c.denom()))
            })
            .collect();
        MultiPoly::from_unsorted(vars.into(), list, den)
    }

    /// The polynomial with the given terms over one denominator, the exponents in the order of
    /// the variables; equal monomials add up. This avoids a search for symbols in every term.
    ///
    /// # Panics
    /// If the variables are not in strictly ascending order, an exponent list has another
    /// length, or the denominator is 0.
    pub fn from_exponents(
        variables: &[Symbol],
        terms: impl IntoIterator<Item = (Vec<u32>, Int)>,
        denominator: Int,
    ) -> Self {
        assert!(variables.windows(2).all(|pair| pair[0] < pair[1]), "variables in ascending order");
        assert!(!denominator.is_zero(), "a denominator");
        let list = terms
            .into_iter()
            .map(|(exponents, c)| {
                assert_eq!(exponents.len(), variables.len(), "one exponent for each variable");
                (Exponents::from_vec(exponents), c)
            })
            .collect();
        MultiPoly::from_unsorted(variables.into(), list, denominator)
    }

    /// Establishes the canonical form from terms in any order, perhaps repeated.
    pub(super) fn from_unsorted(vars: Arc<[Symbol]>, mut terms: Terms, den: Int) -> Self {
        terms.sort_unstable_by(|a, b| b.0.cmp(&a.0));
        terms.dedup_by(|later, first| {
            let same = later.0 == first.0;
            if same {
                first.1 += &later.1;
            }
            same
        });
        MultiPoly::from_sorted(vars, terms, den)
    }

    /// Establishes the canonical form from distinct terms in descending order.
    pub(super) fn from_sorted(mut vars: Arc<[Symbol]>, mut terms: Terms, mut den: Int) -> Self {
        terms.retain(|(_, c)| !c.is_zero());
        if terms.is_empty() {
            return MultiPoly::zero();
        }
        if !den.is_one() {
            let mut g = dense::common_divisor(&den, terms.iter().map(|(_, c)| c));
            if den.is_negative() {
                g = -g;
            }
            if !g.is_one() {
                den = den.div_exact(&g);
                terms.iter_mut().for_each(|(_, c)| *c = c.div_exact(&g));
            }
        }
        let used: Vec<bool> = (0..vars.len()).map(|k| terms.iter().any(|(e, _)| e[k] > 0)).collect();
        if used.contains(&false) {
            let keep = |k: usize| used[k];
            vars = vars.iter().enumerate().filter(|(k, _)| keep(*k)).map(|(_, s)| s.clone()).collect();
            for (exponents, _) in &mut terms {
                let mut k = 0;
                exponents.retain(|_| {
                    k += 1;
                    keep(k - 1)
                });
            }
        }
        let result = MultiPoly { vars, terms, den };
        debug_assert!(result.is_canonical());
        result
    }

    /// Whether the representation is the canonical one; always true from outside.
    pub fn is_canonical(&self) -> bool {
        let n = self.vars.len();
        let content = self.terms.iter().fold(self.den.clone(), |g, (_, c)| g.gcd(c));
        self.vars.windows(2).all(|pair| pair[0] < pair[1])
            && self.terms.iter().all(|(e, c)| e.len() == n && !c.is_zero())
            && self.terms.windows(2).all(|pair| pair[0].0 > pair[1].0)
            && (0..n).all(|k| self.terms.iter().any(|(e, _)| e[k] > 0))
            && self.den.is_positive()
            && content.is_one()
    }

    /// The variables that occur, in natural order.
    pub fn variables(&self) -> &[Symbol] {
        &self.vars
    }

    /// Number of terms.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether there are no terms, that is, whether this is 0.
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// The constant this polynomial is, if it is one.
    pub fn as_constant(&self) -> Option<Rational> {
        match self.terms.as_slice() {
            [] => Some(Rational::zero()),
            [(e, c)] if e.is_empty() => Some(Rational::new_raw(c.clone(), self.den.clone())),
            _ => None,
        }
    }

    /// The terms with their coefficients, the largest first.
    pub fn terms(&self, order: MonomialOrder) -> Vec<(Powers, Rational)> {
        let mut list: Vec<&(Exponents, Int)> = self.terms.iter().collect();
        if order != MonomialOrder::Lex {
            list.sort_by(|a, b| order.compare(&b.0, &a.0));
        }
        list.into_iter()
            .map(|(e, c)| {
                let powers = self.vars.iter().cloned().zip(e.iter().copied()).filter(|(_, e)| *e > 0);
                (powers.collect(), Rational::new(c.clone(), self.den.clone()))
            })
            .collect()
    }

    /// The coefficient of the first term in lexicographic order; 0 for 0.
    pub(in crate::math) fn leading_coefficient(&self) -> Rational {
        self.terms.first().map_or_else(Rational::zero, |(_, c)| Rational::new(c.clone(), self.den.clone()))
    }

    fn place(&self, symbol: &Symbol) -> Option<usize> {
        self.vars.binary_search(symbol).ok()
    }

    /// The degree in one symbol; 0 if it does not occur.
    pub fn degree_in(&self, symbol: &Symbol) -> u32 {
        self.place(symbol).and_then(|k| self.terms.iter().map(|(e, _)| e[k]).max()).unwrap_or(0)
    }

    /// The total degree; `None` for 0.
    pub fn total_degree(&self) -> Option<u32> {
        self.terms.iter().map(|(e, _)| e.iter().sum()).max()
    }

    /// c_0, c_1, …, c_d with self = Σ c_k symbol^k, each a polynomial in the other symbols.
    /// At least one entry (0 for the zero polynomial). Cost: linear in the number of terms.
    pub fn coefficients_in(&self, symbol: &Symbol) -> Vec<MultiPoly> {
        let Some(k) = self.place(symbol) else { return vec![self.clone()] };
        let degree = self.degree_in(symbol);
        budget::charge_terms(u64::from(degree) + 1);
        let others: Arc<[Symbol]> = self.vars.iter().filter(|s| *s != symbol).cloned().collect();
        let mut lists: Vec<Terms> = vec![Vec::new(); degree as usize + 1];
        for (e, c) in &self.terms {
            let mut rest = e.clone();
            let power = rest.remove(k);
            lists[power as usize].push((rest, c.clone()));
        }
        lists
            .into_iter()
            .map(|terms| MultiPoly::from_sorted(others.clone(), terms, self.den.clone()))
            .collect()
    }

    /// Σ c_k symbol^k.
    pub fn from_coefficients_in(symbol: &Symbol, coefficients: &[MultiPoly]) -> Self {
        let mut sum = MultiPoly::zero();
        for (k, c) in coefficients.iter().enumerate().filter(|(_, c)| !c.is_zero()) {
            let exponent = u32::try_from(k).unwrap_or(u32::MAX);
            sum += c.times(&MultiPoly::from_terms([(vec![(symbol.clone(), exponent)], Rational::one())]));
        }
        sum
    }

    /// self + other · (1 or −1), on common variables.
    pub(super) fn combined(&self, other: &Self, subtract: bool) -> Self {
        if other.is_empty() {
            return self.clone();
        }
        budget::steps(((self.len() + other.len()) / 16) as u32 + 1);
        let (vars, left, right) = aligned(self, other);
        let (a_factor, b_factor, den) = if self.den == other.den {
            (Int::ONE, Int::ONE, self.den.clone())
        } else {
            let den = self.den.lcm(&other.den);
            (den.div_exact(&self.den), den.div_exact(&other.den), den)
        };
        let b_factor = if subtract { -b_factor } else { b_factor };
        let times = |c: &Int, factor: &Int| if factor.is_one() { c.clone() } else { c * factor };
        let mut terms = Vec::with_capacity(left.len() + right.len());
        let (mut a, mut b) = (left.iter().peekable(), right.iter().peekable());
        loop {
            use std::cmp::Ordering::{Equal, Greater, Less};
            let order = match (a.peek(), b.peek()) {
                (Some(x), Some(y)) => x.0.cmp(&y.0),
                (Some(_), None) => Greater,
                (None, Some(_)) => Less,
                (None, None) => break,
            };
            match order {
                Greater => terms.extend(a.next().map(|(e, c)| (e.clone(), times(c, &a_factor)))),
                Less => terms.extend(b.next().map(|(e, c)| (e.clone(), times(c, &b_factor)))),
                Equal => {
                    if let (Some((e, x)), Some((_, y))) = (a.next(), b.next()) {
                        terms.push((e.clone(), times(x, &a_factor) + times(y, &b_factor)));
                    }
                }
            }
        }
        budget::charge_terms(terms.len() as u64);
        MultiPoly::from_sorted(vars, terms, den)
    }

    /// self^exponent, with the size of the result asked for beforehand. Cost: that of
    /// multiplying the result out.
    pub fn pow(&self, exponent: u32) -> Self {
        match (self.terms.as_slice(), exponent) {
            (_, 0) => return <MultiPoly as Ring>::from_rational(&Rational::one()),
            ([], _) => return MultiPoly::zero(),
            ([(e, c)], k) => {
                let bits = c.bits().max(self.den.bits()).saturating_sub(1);
                budget::charge_bits(bits.saturating_mul(u64::from(k)));
                let exponents: Option<Exponents> = e.iter().map(|x| x.checked_mul(k)).collect();
                let Some(exponents) = exponents else {
                    budget::charge_terms(u64::MAX);
                    return MultiPoly::zero();
                };
                return MultiPoly {
                    vars: self.vars.clone(),
                    terms: vec![(exponents, c.pow(k))],
                    den: self.den.pow(k),
                };
            }
            _ => {}
        }
        // At least k (m − 1) + 1 terms for m terms, in one variable and generically.
        let k = u64::from(exponent);
        budget::charge_terms(k.saturating_mul(self.len() as u64 - 1).saturating_add(1));
        let bits = self.terms.iter().map(|(_, c)| c.bits()).max().unwrap_or(0);
        budget::charge_bits(bits.max(1).saturating_mul(k));
        if one_variable::has_one_variable(self)
            && let Some(terms) = one_variable::power(&self.terms, exponent)
        {
            // No common factor appears (Gauss), so the form stays canonical.
            return MultiPoly { vars: self.vars.clone(), terms, den: self.den.pow(exponent) };
        }
        let (mut result, mut base, mut left) = (MultiPoly::one(), self.clone(), exponent);
        loop {
            if left & 1 == 1 {
                result = result.times(&base);
            }
            left >>= 1;
            if left == 0 {
                return result;
            }
            base = base.times(&base);
        }
    }

    /// Replaces symbols by polynomials, all at once.
    ///
    /// ```
    /// use polarform::poly::{MultiPoly, Symbol};
    /// let (x, y) = (Symbol::new("x"), Symbol::new("y"));
    /// let p = |s: &Symbol| MultiPoly::symbol(s.clone());
    /// let swapped = (p(&x) - p(&y)).substitute(&[(x.clone(), p(&y)), (y.clone(), p(&x))]);
    /// assert_eq!(swapped, p(&y) - p(&x));
    /// ```
    pub fn substitute(&self, replacements: &[(Symbol, MultiPoly)]) -> Self {
        let active: Vec<(usize, &MultiPoly)> =
            replacements.iter().filter_map(|(symbol, p)| Some((self.place(symbol)?, p))).collect();
        if active.is_empty() {
            return self.clone();
        }
        // One replaced symbol: Horner's scheme; several: group the terms by their powers.
        if let [(place, value)] = active.as_slice() {
            if one_variable::has_one_variable(self) {
                if let Some(q) = value.as_constant() {
                    return MultiPoly::constant(one_variable::value(self, &q));
                }
                if one_variable::has_one_variable(value) {
                    return one_variable::composition(self, value);
                }
            }
            let symbol = self.vars[*place].clone();
            let mut sum = MultiPoly::zero();
            for c in self.coefficients_in(&symbol).iter().rev() {
                budget::step();
                sum = sum.times(value).plus(c);
            }
            return sum;
        }
        let mut powers: Vec<Vec<MultiPoly>> = vec![vec![MultiPoly::one()]; active.len()];
        let mut groups: BTreeMap<Vec<u32>, Terms> = BTreeMap::new();
        for (e, c) in &self.terms {
            let key = active.iter().map(|(k, _)| e[*k]).collect();
            let mut rest = e.clone();
            active.iter().for_each(|(k, _)| rest[*k] = 0);
            groups.entry(key).or_default().push((rest, c.clone()));
        }
        let mut sum = MultiPoly::zero();
        for (key, terms) in groups {
            budget::step();
            let mut product = MultiPoly::from_sorted(self.vars.clone(), terms, self.den.clone());
            for ((list, exponent), (_, value)) in powers.iter_mut().zip(key).zip(&active) {
                while list.len() <= exponent as usize {
                    let next = list[list.len() - 1].times(value);
                    list.push(next);
                }
                product = product.times(&list[exponent as usize]);
            }
            sum += product;
        }
        sum
    }

    /// Puts in numbers for some symbols. Integers for all of them are the fast case: powers and
    /// one sum, whatever the degree.
    pub fn value(&self, value: &dyn Fn(&Symbol) -> Option<Rational>) -> Self {
        if let [symbol] = &*self.vars {
            return match value(symbol) {
                Some(x) => MultiPoly::constant(one_variable::value(self, &x)),
                None => self.clone(),
            };
        }
        let integers: Option<Vec<Int>> = self
            .vars
            .iter()
            .map(|symbol| value(symbol).filter(Rational::is_integer).map(|q| q.into_raw().0))
            .collect();
        if let Some(integers) = integers {
            let mut sum = Int::ZERO;
            for (e, c) in &self.terms {
                budget::step();
                let mut term = c.clone();
                for (x, k) in integers.iter().zip(e).filter(|(_, k)| **k > 0) {
                    budget::charge_bits(x.bits().saturating_sub(1).saturating_mul(u64::from(*k)));
                    term *= x.pow(*k);
                }
                sum += term;
            }
            return MultiPoly::constant(Rational::new(sum, self.den.clone()));
        }
        let replacements: Vec<(Symbol, MultiPoly)> = self
            .vars
            .iter()
            .filter_map(|symbol| Some((symbol.clone(), MultiPoly::constant(value(symbol)?))))
            .collect();
        self.substitute(&replacements)
    }

    /// Renames symbols; the map need not be one-to-one. Cost: one pass and a sort.
    pub fn rename(&self, map: &dyn Fn(&Symbol) -> Symbol) -> Self {
        let images: Vec<Symbol> = self.vars.iter().map(map).collect();
        let mut vars = images.clone();
        vars.sort_unstable();
        vars.dedup();
        let places: Vec<usize> = images.iter().map(|image| vars.binary_search(image).unwrap_or(0)).collect();
        let terms = self
            .terms
            .iter()
            .map(|(e, c)| {
                let mut exponents = Exponents::from_elem(0, vars.len());
                e.iter().zip(&places).for_each(|(x, place)| exponents[*place] += x);
                (exponents, c.clone())
            })
            .collect();
        MultiPoly::from_unsorted(vars.into(), terms, self.den.clone())
    }

    /// ∂/∂symbol. Cost: linear.
    pub fn derivative(&self, symbol: &Symbol) -> Self {
        let Some(k) = self.place(symbol) else { return MultiPoly::zero() };
        let terms = self
            .terms
            .iter()
            .filter(|(e, _)| e[k] > 0)
            .map(|(e, c)| {
                let mut lower = e.clone();
                lower[k] -= 1;
                (lower, c * Int::from(e[k]))
            })
            .collect();
        MultiPoly::from_sorted(self.vars.clone(), terms, self.den.clone())
    }

    /// The integers over the common denominator.
    fn coefficients(&self) -> impl Iterator<Item = &Int> {
        self.terms.iter().map(|(_, c)| c)
    }

    /// The positive rational c with self / c primitive (integer coefficients without common factor);
    /// 0 for 0.
    pub fn content(&self) -> Rational {
        // In lowest terms because the form is canonical.
        Rational::new_raw(dense::common_divisor(&Int::ZERO, self.coefficients()), self.den.clone())
    }

    /// self divided by its content, with positive leading coefficient (lex); 0 for 0.
    pub fn primitive_part(&self) -> Self {
        if self.is_empty() {
            return self.clone();
        }
        let mut g = dense::common_divisor(&Int::ZERO, self.coefficients());
        if self.terms[0].1.is_negative() {
            g = -g;
        }
        let terms = self.terms.iter().map(|(e, c)| (e.clone(), c.div_exact(&g))).collect();
        MultiPoly { vars: self.vars.clone(), terms, den: Int::ONE }
    }
}

/// A list of terms, borrowed if no variable had to be added.
type TermsOver<'a> = Cow<'a, [(Exponents, Int)]>;

/// Both lists of terms over the union of the variables.
pub(super) fn aligned<'a>(
    a: &'a MultiPoly,
    b: &'a MultiPoly,
) -> (Arc<[Symbol]>, TermsOver<'a>, TermsOver<'a>) {
    if Arc::ptr_eq(&a.vars, &b.vars) || a.vars == b.vars {
        return (a.vars.clone(), Cow::Borrowed(&a.terms), Cow::Borrowed(&b.terms));
    }
    let mut vars: Vec<Symbol> = a.vars.iter().chain(b.vars.iter()).cloned().collect();
    vars.sort_unstable();
    vars.dedup();
    let (left, right) = (spread(a, &vars), spread(b, &vars));
    (vars.into(), left, right)
}

fn spread<'a>(p: &'a MultiPoly, vars: &[Symbol]) -> TermsOver<'a> {
    if p.vars.len() == vars.len() {
        return Cow::Borrowed(&p.terms);
    }
    let places: Vec<usize> = p.vars.iter().map(|symbol| vars.binary_search(symbol).unwrap_or(0)).collect();
    let terms = p.terms.iter().map(|(e, c)| {
        let mut exponents = Exponents::from_elem(0, vars.len());
        places.iter().zip(e).for_each(|(place, x)| exponents[*place] = *x);
        (exponents, c.clone())
    });
    Cow::Owned(terms.collect())
}
