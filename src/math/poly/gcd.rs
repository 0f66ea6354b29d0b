//! Exact division and greatest common divisors in several variables.
//!
//! The gcd is primitive with positive leading coefficient (lexicographic order). Trivial cases come
//! first, and one variable has an algorithm of its own. Then each variable gets a bound for its
//! degree in the gcd from images modulo a prime. A bound of 0 for all variables proves that the gcd
//! is 1, the common case. Otherwise contents in one variable are computed recursively, and the gcd of
//! the primitive parts is interpolated from images ([`gcd_modular`]). Only where exponents are too
//! large for that, the primitive remainder sequence finds it.
//!
//! Reference: W. S. Brown, *On Euclid's algorithm and the computation of polynomial greatest
//! common divisors*, J. ACM 18 (1971) 478–504; Knuth, TAOCP vol. 2, 4.6.1.

use super::divide;
use super::gcd_modular::{self, Problem};
use super::multivariate::{Exponents, MultiPoly, Terms, aligned};
use super::one_variable;
use super::symbol::Symbol;
use crate::budget;
use crate::math::number::{Int, Rational};
use crate::math::ring::Ring;
use num_integer::Integer;
use num_traits::{One, Zero};
use std::collections::BTreeMap;

impl MultiPoly {
    /// self / divisor if the division leaves no remainder.
    ///
    /// Cost: terms of the quotient times terms of the divisor; for sparse ones also the logarithm
    /// of the terms of the quotient.
    ///
    /// ```
    /// use polarform::poly::{MultiPoly, Symbol};
    /// let (x, y) = (MultiPoly::symbol(Symbol::new("x")), MultiPoly::symbol(Symbol::new("y")));
    /// let product = (x.clone() + y.clone()) * (x.clone() - y.clone());
    /// assert_eq!(product.div_exact(&(x.clone() + y.clone())), Some(x.clone() - y.clone()));
    /// assert_eq!(x.div_exact(&y), None);
    /// ```
    pub fn div_exact(&self, divisor: &MultiPoly) -> Option<MultiPoly> {
        if divisor.is_zero() {
            return None;
        }
        if self.is_zero() {
            return Some(MultiPoly::zero());
        }
        if let Some(c) = divisor.as_constant() {
            return Some(self.scaled(&c.recip()));
        }
        if divisor.variables().iter().any(|s| self.degree_in(s) < divisor.degree_in(s)) {
            return None;
        }
        // Over Z with primitive operands the quotient is integral (Gauss).
        let (a, b) = (self.primitive_part(), divisor.primitive_part());
        let (vars, dividend, by) = aligned(&a, &b);
        let scale = self.leading_coefficient()
            / a.leading_coefficient()
            / (divisor.leading_coefficient() / b.leading_coefficient());
        if let [_] = *vars
            && let Some(quotient) = one_variable::quotient(&dividend, &by)
        {
            return Some(MultiPoly::from_sorted(vars, quotient?, Int::ONE).scaled(&scale));
        }
        let quotient = match divide::quotient(&dividend, &by, vars.len()) {
            Some(quotient) => quotient?,
            None => by_table(&dividend, &by)?,
        };
        let quotient = MultiPoly::from_sorted(vars, quotient, Int::ONE);
        Some(quotient.scaled(&scale))
    }

    /// The greatest common divisor: primitive with positive leading coefficient; for 0 and p it
    /// is the primitive part of p, and gcd(0, 0) = 0.
    ///
    /// Modular, by sparse interpolation, and proved by two exact divisions. Cost: about 2 T
    /// evaluations of both modulo a word for T terms of a coefficient of the gcd in one variable.
    ///
    /// ```
    /// use polarform::poly::{MultiPoly, Symbol};
    /// let (x, y) = (MultiPoly::symbol(Symbol::new("x")), MultiPoly::symbol(Symbol::new("y")));
    /// let (a, b) = (x.clone() * x.clone() - y.clone() * y.clone(), x.clone() * y.clone() + y.clone() * y.clone());
    /// assert_eq!(a.gcd(&b), x + y);
    /// ```
    pub fn gcd(&self, other: &MultiPoly) -> MultiPoly {
        if self.is_zero() {
            return other.primitive_part();
        }
        if other.is_zero() || self == other {
            return self.primitive_part();
        }
        if self.as_constant().is_some() || other.as_constant().is_some() {
            return MultiPoly::one();
        }
        let (a, b) = (self.primitive_part(), other.primitive_part());
        // Its cost grows with both; limits by steps rest on this count.
        crate::budget::steps(u32::try_from(a.len().saturating_mul(b.len())).unwrap_or(u32::MAX).max(16));
        if a.len() == 1 || b.len() == 1 {
            return monomial_gcd(&a, &b);
        }
        if one_variable::has_one_variable(&a) && a.variables() == b.variables() {
            return one_variable::gcd(&a, &b);
        }
        let ((of_a, a), (of_b, b)) = (without_monomial(a), without_monomial(b));
        if !of_a.is_one() || !of_b.is_one() {
            return monomial_gcd(&of_a, &of_b).times(&a.gcd(&b));
        }
        let (vars, in_a, in_b) = aligned(&a, &b);
        let bounds = gcd_modular::degree_bounds(&in_a, &in_b, vars.len());
        if bounds.iter().all(|&bound| bound == 0) {
            return MultiPoly::one();
        }
        let (small, large) = if a.len() <= b.len() { (&a, &b) } else { (&b, &a) };
        if vars.iter().zip(&bounds).all(|(symbol, bound)| small.degree_in(symbol) == *bound)
            && large.div_exact(small).is_some()
        {
            return small.clone();
        }
        // A variable that the gcd does not contain leaves it a divisor of all coefficients.
        if let Some(k) = bounds.iter().position(|&bound| bound == 0) {
            return coefficient_gcd(&[&a, &b], &vars[k]);
        }
        modular(&a, &b, &bounds).unwrap_or_else(|| {
            let main = a.variables().iter().min_by_key(|s| a.degree_in(s).max(b.degree_in(s)));
            euclid(&a, &b, main.unwrap_or(&vars[0]))
        })
    }
}

/// gcd when one of the two is a monomial with coefficient 1.
fn monomial_gcd(a: &MultiPoly, b: &MultiPoly) -> MultiPoly {
    let powers = a.variables().iter().filter_map(|symbol| {
        let lowest =
            |p: &MultiPoly| p.coefficients_in(symbol).iter().position(|c| !c.is_zero()).unwrap_or(0) as u32;
        let e = lowest(a).min(if b.degree_in(symbol) > 0 { lowest(b) } else { 0 });
        (e > 0).then(|| (symbol.clone(), e))
    });
    MultiPoly::from_terms([(powers.collect(), Rational::one())])
}

/// The gcd of all coefficients of the given polynomials in `symbol`.
fn coefficient_gcd(polys: &[&MultiPoly], symbol: &Symbol) -> MultiPoly {
    let mut list: Vec<MultiPoly> = polys.iter().flat_map(|p| p.coefficients_in(symbol)).collect();
    list.retain(|c| !c.is_zero());
    list.sort_by_key(MultiPoly::len);
    let mut g = MultiPoly::zero();
    for c in &list {
        g = g.gcd(c);
        if g.is_one() {
            break;
        }
    }
    g
}

/// The terms of a / b by a table of all monomials, however large their exponents.
fn by_table(dividend: &[(Exponents, Int)], by: &[(Exponents, Int)]) -> Option<Terms> {
    let (lead, lead_c) = by.first()?;
    let mut rest: BTreeMap<Exponents, Int> = dividend.iter().cloned().collect();
    let mut quotient: Terms = Vec::new();
    while let Some((e, c)) = rest.pop_last() {
        if c.is_zero() {
            continue;
        }
        budget::steps(by.len() as u32 / 16 + 1);
        let shift: Option<Exponents> = e.iter().zip(lead).map(|(x, y)| x.checked_sub(*y)).collect();
        let (shift, (q, r)) = (shift?, c.div_rem(lead_c));
        if !r.is_zero() {
            return None;
        }
        for (exponents, d) in &by[1..] {
            let place: Exponents = exponents.iter().zip(&shift).map(|(x, y)| x + y).collect();
            *rest.entry(place).or_default() -= d * &q;
        }
        quotient.push((shift, q));
    }
    Some(quotient)
}

/// The largest monomial that divides p, and the quotient.
fn without_monomial(p: MultiPoly) -> (MultiPoly, MultiPoly) {
    let lowest: Exponents =
        (0..p.vars.len()).map(|k| p.terms.iter().map(|(e, _)| e[k]).min().unwrap_or(0)).collect();
    if lowest.iter().all(|e| *e == 0) {
        return (MultiPoly::one(), p);
    }
    let divided =
        |(e, c): &(Exponents, Int)| (e.iter().zip(&lowest).map(|(x, low)| x - low).collect(), c.clone());
    let rest = MultiPoly::from_sorted(p.vars.clone(), p.terms.iter().map(divided).collect(), p.den.clone());
    (MultiPoly::from_sorted(p.vars, vec![(lowest, Int::ONE)], Int::ONE), rest)
}

/// The gcd of primitive polynomials in the same variables, each with a positive bound for its degree
/// in the gcd; `None` if exponents are too large.
pub(super) fn modular(a: &MultiPoly, b: &MultiPoly, bounds: &[u32]) -> Option<MultiPoly> {
    let lead =
        |p: &MultiPoly, symbol: &Symbol| p.coefficients_in(symbol).pop().unwrap_or_else(MultiPoly::zero);
    let leads = |p: &MultiPoly, k: usize| {
        let degree = p.degree_in(&p.vars[k]);
        p.terms.iter().filter(|(e, _)| e[k] == degree).count()
    };
    // A short leading coefficient adds few terms.
    let main = (0..a.vars.len()).min_by_key(|&k| (leads(a, k).min(leads(b, k)), bounds[k]))?;
    let symbol = &a.vars[main];
    let (lead_a, lead_b) = (lead(a, symbol), lead(b, symbol));
    let numbers = lead_a.content().numer().gcd(lead_b.content().numer());
    let common = lead_a.gcd(&lead_b);
    let has_content = common.as_constant().is_none();
    let gamma = common.scaled(&Rational::from(numbers));
    let (_, gamma_terms, _) = aligned(&gamma, a);
    let problem =
        Problem { a: &a.terms, b: &b.terms, variables: a.vars.len(), main, lead: &gamma_terms, bounds };
    let primitive = problem.solve(|terms| {
        let mut g = MultiPoly::from_unsorted(a.vars.clone(), terms, Int::ONE).primitive_part();
        if has_content {
            g = g.div_exact(&coefficient_gcd(&[&g], symbol))?.primitive_part();
        }
        (a.div_exact(&g).is_some() && b.div_exact(&g).is_some()).then_some(g)
    })?;
    Some(primitive.times(&coefficient_gcd(&[a, b], symbol)))
}

/// Primitive remainder sequence in the main variable.
pub(super) fn euclid(a: &MultiPoly, b: &MultiPoly, main: &Symbol) -> MultiPoly {
    let (content_a, content_b) = (coefficient_gcd(&[a], main), coefficient_gcd(&[b], main));
    let content = content_a.gcd(&content_b);
    let strip = |p: &MultiPoly, c: &MultiPoly| p.div_exact(c).unwrap_or_else(|| p.clone());
    let (mut p, mut q) = (strip(a, &content_a), strip(b, &content_b));
    if p.degree_in(main) < q.degree_in(main) {
        std::mem::swap(&mut p, &mut q);
    }
    while !q.is_zero() {
        budget::step();
        if q.degree_in(main) == 0 {
            return content.primitive_part();
        }
        let remainder = pseudo_remainder(&p, &q, main);
        p = q;
        q = if remainder.is_zero() {
            remainder
        } else {
            let c = coefficient_gcd(&[&remainder], main);
            strip(&remainder, &c).primitive_part()
        };
    }
    p.times(&content).primitive_part()
}

/// The remainder of lc(q)^k p by q in the main variable.
fn pseudo_remainder(p: &MultiPoly, q: &MultiPoly, main: &Symbol) -> MultiPoly {
    let mut rest = p.coefficients_in(main);
    let by = q.coefficients_in(main);
    let lead = &by[by.len() - 1];
    while rest.len() >= by.len() {
        budget::step();
        let Some(top) = rest.pop() else { break };
        let shift = rest.len() + 1 - by.len();
        if top.is_zero() {
            continue;
        }
        for (k, c) in rest.iter_mut().enumerate() {
            let scaled = c.times(lead);
            *c = match k.checked_sub(shift) {
                Some(j) => scaled.minus(&top.times(&by[j])),
                None => scaled,
            };
        }
    }
    MultiPoly::from_coefficients_in(main, &rest)
}
