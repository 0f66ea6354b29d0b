//! Whether a sum of terms is 0 for all integers of a context.
//!
//! Guards that the context does not decide split it in two. Where nothing is left to split, sums
//! over bound variables are evaluated in closed form, classes of terms must have rational
//! function 0, and equations that the context forces (i = 0, i = n) are put in.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::Zero;

use super::classes;
use super::context::Context;
use super::induction::{self, Plan};
use super::linear::Linear;
use super::summation::{Closed, close};
use super::term::{Term, add, collected};
use crate::budget;

/// How many contexts are looked at before the search is given up.
const MAX_CASES: u32 = 400;

/// What the proof made use of, for its reason.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Step {
    /// Both sides compared coefficient by coefficient.
    Coefficients,
    /// Cases such as i = 0 looked at by themselves.
    Cases,
    /// The recurrence of elementary symmetric functions.
    Symmetric,
    /// Σ C(n,i) x^i y^(n−i) = (x+y)^n.
    BinomialTheorem,
    /// Σ C(m,j) C(n,k−j) = C(m+n,k).
    Vandermonde,
    /// Sums of polynomials.
    PowerSum,
    /// Sums compared term by term.
    TermByTerm,
    /// Induction on the upper bound.
    Induction,
}

/// A search for a proof, with what it used.
#[derive(Debug, Default)]
pub struct Decision {
    cases: u32,
    /// What was used.
    pub steps: BTreeSet<Step>,
}

impl Decision {
    /// Whether the sum of the terms is 0 for all integers of the context; `false` may mean that
    /// this is not known. No indexed symbols may occur.
    pub fn vanishes(&mut self, terms: &[Term], context: &Context) -> bool {
        budget::step();
        self.cases += 1;
        if self.cases > MAX_CASES {
            return false;
        }
        let mut context = context.clone();
        let terms = decided(terms, &context);
        for term in terms.iter().filter(|term| term.bound.is_empty() && term.guards.is_empty()) {
            term.defined.iter().for_each(|fact| context.assume(fact));
        }
        if context.is_impossible() {
            return true;
        }
        if by_guards(&terms).values().all(|group| classes::vanishes(group)) {
            return true;
        }
        if let Some(guard) = open_guard(&terms) {
            self.steps.insert(Step::Cases);
            return self.vanishes(&terms, &context.with(&guard))
                && self.vanishes(&terms, &context.without(&guard));
        }
        if terms.iter().any(|term| !term.bound.is_empty()) {
            return self.summed(&terms, &context);
        }
        let alive: Vec<Term> = terms.iter().filter(|term| !is_dead(term, &context)).cloned().collect();
        if alive.len() < terms.len() {
            return self.vanishes(&alive, &context);
        }
        self.with_forced_values(&terms, &context)
    }

    /// A value that the context forces is put in; few possible values are tried one by one.
    fn with_forced_values(&mut self, terms: &[Term], context: &Context) -> bool {
        let Some((symbol, value)) = context.forced() else {
            return context.few_values().is_some_and(|form| {
                self.steps.insert(Step::Cases);
                self.vanishes(terms, &context.with(&form)) && self.vanishes(terms, &context.without(&form))
            });
        };
        let put: Option<Vec<Term>> = terms.iter().map(|term| term.substitute(&symbol, &value)).collect();
        put.is_some_and(|terms| self.vanishes(&collected(terms), &context.substitute(&symbol, &value)))
    }

    /// One sum over a bound variable is evaluated.
    fn summed(&mut self, terms: &[Term], context: &Context) -> bool {
        for (k, term) in terms.iter().enumerate() {
            for variable in &term.bound {
                match close(term, variable, context, &mut self.steps) {
                    Closed::Sum(found) => {
                        let mut rest: Vec<Term> = terms.to_vec();
                        rest.remove(k);
                        found.into_iter().for_each(|term| add(&mut rest, term));
                        return self.vanishes(&collected(rest), context);
                    }
                    Closed::Split(form) => {
                        self.steps.insert(Step::Cases);
                        return self.vanishes(terms, &context.with(&form))
                            && self.vanishes(terms, &context.without(&form));
                    }
                    Closed::Open => {}
                }
            }
        }
        self.matched(terms, context)
            || induction::united(terms).is_some_and(|terms| self.vanishes(&terms, context))
            || self.by_induction(terms, context)
            || self.with_forced_values(terms, context)
    }

    /// Sums that cancel term by term.
    fn matched(&mut self, terms: &[Term], context: &Context) -> bool {
        let before = self.steps.clone();
        for (group, rest) in induction::matchings(terms) {
            if self.vanishes(&group, context) && self.vanishes(&rest, context) {
                self.steps.insert(Step::TermByTerm);
                return true;
            }
            self.steps.clone_from(&before);
        }
        false
    }

    /// A sum with a given value.
    fn by_induction(&mut self, terms: &[Term], context: &Context) -> bool {
        match induction::plan(terms, context) {
            Some(Plan::Show(plan)) => {
                let shown =
                    self.vanishes(&plan.step.0, &plan.step.1) && self.vanishes(&plan.start.0, &plan.start.1);
                if shown {
                    self.steps.insert(Step::Induction);
                }
                shown
            }
            Some(Plan::Split(form)) => {
                self.vanishes(terms, &context.with(&form)) && self.vanishes(terms, &context.without(&form))
            }
            None => false,
        }
    }
}

/// The terms with the guards that hold taken away, without the terms that are 0.
fn decided(terms: &[Term], context: &Context) -> Vec<Term> {
    let mut kept = Vec::new();
    'terms: for term in terms {
        let mut term = term.clone();
        for guard in std::mem::take(&mut term.guards) {
            if term.bound.iter().any(|variable| guard.contains(variable)) {
                term.guards.insert(guard);
            } else if context.refutes(&guard) {
                continue 'terms;
            } else if !context.entails(&guard) {
                term.guards.insert(guard);
            }
        }
        add(&mut kept, term);
    }
    kept.retain(|term| !term.coefficient.is_zero());
    kept
}

/// Terms that are 0 together: for each set of guards those that have it. Sums are groups of
/// their own.
fn by_guards(terms: &[Term]) -> BTreeMap<(BTreeSet<Linear>, Option<usize>), Vec<Term>> {
    let mut groups: BTreeMap<(BTreeSet<Linear>, Option<usize>), Vec<Term>> = BTreeMap::new();
    for (k, term) in terms.iter().enumerate() {
        let own = (!term.bound.is_empty()).then_some(k);
        groups.entry((term.guards.clone(), own)).or_default().push(term.clone());
    }
    groups
}

/// A guard without bound variables that the context does not decide.
fn open_guard(terms: &[Term]) -> Option<Linear> {
    terms.iter().find_map(|term| {
        term.guards.iter().find(|guard| !term.bound.iter().any(|variable| guard.contains(variable))).cloned()
    })
}

/// Whether a factorial in the denominator makes the term 0 throughout the context.
fn is_dead(term: &Term, context: &Context) -> bool {
    term.factorials.iter().any(|(form, m)| *m < 0 && context.refutes(form))
}
