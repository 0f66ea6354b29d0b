//! Sums without a closed form of their own: compared with each other term by term, or shown to
//! have a given value by induction on their length.

use std::collections::BTreeSet;

use num_traits::{One, Signed, Zero};

use super::classes;
use super::context::Context;
use super::linear::Linear;
use super::term::{Base, Term};
use crate::math::number::{Int, integer};
use crate::math::poly::{Fraction, MultiPoly, Symbol};

/// Denominators are looked at for zeros up to this number.
const MAX_ROOT: i64 = 1000;
/// How many ways to compare sums are tried.
const MAX_MATCHINGS: usize = 5;

/// The terms with sums over the same range as one sum if their bodies are of one class; `None`
/// if there is nothing to unite.
pub fn united(terms: &[Term]) -> Option<Vec<Term>> {
    let mut result: Vec<Term> = Vec::new();
    let mut left: Vec<&Term> = terms.iter().collect();
    while let Some(first) = left.first().copied() {
        let same =
            |term: &Term| !term.bound.is_empty() && term.bound == first.bound && term.guards == first.guards;
        let (group, others): (Vec<&Term>, Vec<&Term>) = left.iter().partition(|term| same(term));
        if group.len() < 2 {
            result.push(first.clone());
            left.remove(0);
            continue;
        }
        left = others;
        let bodies: Vec<Term> = group
            .iter()
            .map(|term| Term { guards: BTreeSet::new(), bound: BTreeSet::new(), ..(*term).clone() })
            .collect();
        let facts: BTreeSet<Linear> = group.iter().flat_map(|term| term.defined.iter().cloned()).collect();
        for class in classes::classes(&bodies)?.into_iter().filter(|class| !class.coefficient.is_zero()) {
            let mut sum = class.common.scaled(&class.coefficient);
            sum.guards = first.guards.clone();
            sum.bound = first.bound.clone();
            sum.defined = facts.clone();
            result.push(sum);
        }
    }
    (result.len() < terms.len()).then_some(result)
}

/// What a sum over one variable is rewritten by: the form that becomes the variable.
#[derive(Clone, Debug, PartialEq)]
enum Pivot {
    /// The exponent of a base.
    Power(Base),
    /// The argument of a factorial, without its constant, and its multiplicity.
    Factorial(Linear, i32),
    /// The variable itself or a linear denominator.
    Variable,
}

/// A way to compare sums: bodies over a common variable, and the terms that are left.
pub type Matching = (Vec<Term>, Vec<Term>);

/// Sums over one variable whose bodies are of one class. If the bodies with their guards cancel
/// for each value of the common variable, so do the sums.
pub fn matchings(terms: &[Term]) -> Vec<Matching> {
    let common = Symbol::new("!");
    let Some(first) = terms.iter().position(|term| term.bound.len() == 1) else { return Vec::new() };
    let mut found = Vec::new();
    for (pivot, body) in bodies(&terms[first], &common) {
        let Some(key) = classes::key(&body) else { continue };
        let (mut group, mut rest) = (vec![body], Vec::new());
        for (k, term) in terms.iter().enumerate().filter(|(k, _)| *k != first) {
            let mut list = if term.bound.len() == 1 { bodies(term, &common) } else { Vec::new() };
            list.sort_by_key(|(other, _)| *other != pivot);
            match list.into_iter().find(|(_, other)| classes::key(other).as_ref() == Some(&key)) {
                Some((_, other)) => group.push(other),
                None => rest.push(terms[k].clone()),
            }
        }
        if group.len() > 1 && found.len() < MAX_MATCHINGS {
            found.push((group, rest));
        }
    }
    found
}

/// The body of a sum with one of the forms in it made the variable.
fn bodies(term: &Term, common: &Symbol) -> Vec<(Pivot, Term)> {
    let Some(variable) = term.bound.first() else { return Vec::new() };
    let j = Linear::symbol(common);
    let mut forms: Vec<(Pivot, Linear)> = Vec::new();
    forms.extend(term.powers.iter().map(|(base, e)| (Pivot::Power(base.clone()), e.clone())));
    forms.extend(term.factorials.iter().map(|(form, m)| {
        let part = form.substitute(variable, &j).without_offset();
        (Pivot::Factorial(part, *m), form.clone())
    }));
    forms.extend(Linear::from_poly(term.coefficient.denominator()).map(|form| (Pivot::Variable, form)));
    forms.push((Pivot::Variable, Linear::symbol(variable)));
    let mut found = Vec::new();
    for (pivot, form) in forms {
        let slope = form.coefficient(variable);
        if slope.as_small().is_none_or(|a| a.abs() != 1) {
            continue;
        }
        let rest = form.substitute(variable, &Linear::default());
        found.extend(term.substitute(variable, &j.minus(&rest).scaled(&slope)).map(|body| (pivot, body)));
    }
    found
}

/// What remains to be shown for Σ_{j=a}^{b} F(j) + T = 0 by induction on b.
pub struct Induction {
    /// T(n) − T(n−1) + F(b(n)), to vanish in the context.
    pub step: (Vec<Term>, Context),
    /// T where b = a − 1, to vanish in the context.
    pub start: (Vec<Term>, Context),
}

/// How an induction could go on.
pub enum Plan {
    /// These have to vanish.
    Show(Box<Induction>),
    /// It must be known whether this form is negative.
    Split(Linear),
}

/// Plans an induction for one sum with one lower and one upper end among terms without sums: on
/// the letter by which one of the ends moves.
pub fn plan(terms: &[Term], context: &Context) -> Option<Plan> {
    let sum = terms.iter().find(|term| !term.bound.is_empty())?;
    let variable = sum.bound.first().filter(|_| sum.bound.len() == 1)?;
    let others = terms.iter().filter(|term| *term != sum);
    if !others.clone().all(|term| term.bound.is_empty() && term.guards.is_empty()) {
        return None;
    }
    let (lower, upper) = ends(sum, variable)?;
    let mirror = Linear::symbol(&Symbol::new("~"));
    for (end, reflected) in [(&upper, false), (&lower, true)] {
        for (letter, slope) in end.terms() {
            // Where the lower end moves, j becomes −j; the upper end is to grow with the letter.
            let negative = slope.is_negative() != reflected;
            if !slope.abs().is_one() || mentions(sum, letter) {
                continue;
            }
            let turn = |term: &Term| -> Option<Term> {
                let mut term = term.clone();
                if reflected && term.bound.remove(variable) {
                    term = term.substitute(variable, &Linear::symbol(variable).negated())?;
                    term.bound.insert(variable.clone());
                }
                if negative { term.substitute(letter, &mirror.negated()) } else { Some(term) }
            };
            let Some(sum) = turn(sum) else { continue };
            let Some(rest) = others.clone().map(turn).collect::<Option<Vec<Term>>>() else { continue };
            let (known, n) = match (negative, mirror.as_symbol()) {
                (true, Some(n)) => (context.substitute(letter, &mirror.negated()), n),
                _ => (context.clone(), letter),
            };
            match upward(&sum, &rest, variable, n, &known) {
                Some(Plan::Split(form)) => {
                    return Some(Plan::Split(form.substitute(
                        n,
                        &if negative { Linear::symbol(letter).negated() } else { Linear::symbol(letter) },
                    )));
                }
                Some(plan) => return Some(plan),
                None => {}
            }
        }
    }
    None
}

/// The ends of a sum that has one of each.
fn ends(sum: &Term, variable: &Symbol) -> Option<(Linear, Linear)> {
    let (mut lower, mut upper) = (None, None);
    for guard in &sum.guards {
        let rest = guard.substitute(variable, &Linear::default());
        let slot = match guard.coefficient(variable).as_small()? {
            1 => lower.replace(rest.negated()),
            -1 => upper.replace(rest),
            _ => return None,
        };
        if slot.is_some() {
            return None;
        }
    }
    Some((lower?, upper?))
}

/// Induction on n, by which only the upper end grows.
fn upward(sum: &Term, rest: &[Term], variable: &Symbol, n: &Symbol, context: &Context) -> Option<Plan> {
    let sum = sum.cancelled()?;
    let (a, b) = ends(&sum, variable)?;
    let mut body = sum.clone();
    body.guards.clear();
    body.bound.clear();
    if a.contains(n) || mentions(&body, n) {
        return None;
    }
    let not_empty = b.minus(&a).shifted(1);
    if !context.entails(&not_empty) {
        return Some(Plan::Split(not_empty));
    }
    // T is used for all smaller n as well, where what is known of n need not hold.
    let fixed = context.forgetting(n);
    let from_start = fixed.with(&not_empty);
    let start = b.substitute(n, &Linear::default()).negated().plus(&a).shifted(-1);
    let mut total = Vec::new();
    for term in rest {
        let mut term = term.cancelled()?;
        term.defined.clear();
        let numerators = term.factorials.iter().filter(|(_, m)| **m > 0);
        if !numerators.into_iter().all(|(form, _)| from_start.entails(form)) {
            return None;
        }
        if !is_nonzero_from(term.coefficient.denominator(), n, &start) {
            return None;
        }
        total.push(term);
    }
    let minus = -Fraction::one();
    let before = Linear::symbol(n).shifted(-1);
    let mut step = total.clone();
    for term in &total {
        step.push(term.substitute(n, &before)?.scaled(&minus));
    }
    step.push(body.substitute(variable, &b)?);
    let at_start: Option<Vec<Term>> = total.iter().map(|term| term.substitute(n, &start)).collect();
    Some(Plan::Show(Box::new(Induction {
        step: (without_facts(step), fixed.with(&b.minus(&a))),
        start: (without_facts(at_start?), fixed),
    })))
}

/// Facts come from the formula as written; here the same terms stand for other values of n.
fn without_facts(mut terms: Vec<Term>) -> Vec<Term> {
    terms.iter_mut().for_each(|term| term.defined.clear());
    terms
}

fn mentions(term: &Term, symbol: &Symbol) -> bool {
    term.coefficient.variables().contains(symbol)
        || term.factorials.keys().chain(term.powers.values()).any(|form| form.contains(symbol))
}

/// Whether the polynomial has no zero at n = start, start + 1, …
fn is_nonzero_from(p: &MultiPoly, n: &Symbol, start: &Linear) -> bool {
    if !p.variables().contains(n) {
        return true;
    }
    let (Some(start), [_]) = (start.as_constant().and_then(Int::as_small), p.variables()) else {
        return false;
    };
    let coefficients = p.coefficients_in(n);
    let sizes: Option<Vec<i64>> = coefficients
        .iter()
        .map(|c| c.as_constant().filter(|c| c.is_integer())?.to_integer().as_small().map(i64::abs))
        .collect();
    let Some(sizes) = sizes else { return false };
    // Zeros are at most 1 + max |c_k| / |c_d| (Cauchy).
    let bound = sizes.iter().copied().max().unwrap_or(0).saturating_add(1);
    bound <= MAX_ROOT
        && (start..=bound).all(|x| {
            let value = p.value(&|_| Some(integer(x)));
            value.as_constant().is_some_and(|value| !value.is_zero())
        })
}
