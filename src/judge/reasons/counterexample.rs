//! Failures in words: which one shows the slip best, why it is one, and where.

use crate::formula::{Kind, Rel};
use crate::judge::instances::hypotheses::is_coefficient;
use crate::judge::instances::tally::{Failure, Outcomes, Tally};
use crate::judge::page::statement::Chain;
use crate::judge::values::compare::{self, Outcome};
use crate::language::lexicon::roles;
use crate::language::write;

/// The failure that shows the slip best: nothing extreme, small numbers. `None` if the failures are
/// such that the relation may be meant for a part of the range.
pub(in crate::judge) fn best_failure(tally: &Tally, outcomes: &Outcomes, chain: &Chain) -> Option<Failure> {
    let explicit = chain.conditions.iter().any(|condition| {
        condition.alternatives().is_some()
            || matches!(&condition.kind, Kind::Chain(_, links)
            if links.iter().any(|link| matches!(link.expr.kind, Kind::Range(..))
                || matches!(link.rel, Rel::Le | Rel::Lt | Rel::Ge | Rel::Gt | Rel::In | Rel::NotIn)))
    });
    if outcomes.integers.is_empty() {
        // Degrees only: the highest tells most.
        let last = tally.fails.iter().max_by_key(|failure| failure.degree.unwrap_or(0))?;
        let mut smallest = tally.fails.iter().filter(|failure| failure.degree.unwrap_or(0) >= 1);
        return Some(smallest.next().unwrap_or(last).clone());
    }
    // Cases speak of the ends of the range.
    let cases = chain.sides.iter().any(|side| matches!(side.expr.kind, Kind::Cases(_)));
    let inner: Vec<&Failure> = tally
        .fails
        .iter()
        .filter(|failure| {
            failure.inner
                || cases
                    && !failure.outside
                    && failure.integers.iter().all(|(name, value)| !roles::is_degree(name) || *value >= 2)
        })
        .collect();
    let holds = tally.holds_inner;
    let wrong = !inner.is_empty() && inner.len() * 2 >= holds;
    let enough = wrong || (explicit && !inner.is_empty()) || (holds == 0 && tally.fails.len() > tally.holds);
    if !enough {
        return None;
    }
    let within = |failure: &&Failure| explicit || !failure.outside;
    let pool: Vec<&Failure> =
        if inner.is_empty() { tally.fails.iter().filter(within).collect() } else { inner };
    pool.into_iter()
        .filter(|failure| matches!(failure.outcome, Outcome::Fails(_)))
        .min_by_key(|failure| failure.integers.iter().map(|(_, value)| *value).sum::<i64>())
        .cloned()
}

/// Why it is wrong, in words.
pub(in crate::judge) fn reasons(failure: &Failure, tally: &Tally) -> String {
    let Outcome::Fails(judgement) = &failure.outcome else { return "the sides differ".to_owned() };
    let mut parts: Vec<String> = judgement.reasons.clone();
    if let Some(difference) = &judgement.difference
        && !compare::symbols(difference).iter().any(is_coefficient)
    {
        let text = write::text(&difference.to_expr());
        if text.chars().count() <= 140 {
            let instance = instance(failure);
            let place = if instance.is_empty() { String::new() } else { format!(" for {instance}") };
            parts.push(format!("left minus right is {text}{place}"));
        }
    }
    if tally.holds > 0 && parts.is_empty() {
        parts.push("the sides differ".to_owned());
    }
    if parts.is_empty() { "the sides differ".to_owned() } else { parts.join("; ") }
}

fn instance(failure: &Failure) -> String {
    let mut pairs: Vec<String> =
        failure.integers.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    if let (Some(degree), true) = (failure.degree, failure.integers.is_empty()) {
        pairs.push(format!("degree {degree}"));
    }
    if let Some(around) = failure.around.as_ref().filter(|_| failure.varies) {
        pairs.push(format!("near t = {around}"));
    }
    pairs.join(", ")
}

/// The counterexample in words: values of integers, functions and symbols, and of both sides.
pub fn counterexample(failure: &Failure) -> Option<String> {
    let Outcome::Fails(judgement) = &failure.outcome else { return None };
    let mut parts = Vec::new();
    let instance = instance(failure);
    if !instance.is_empty() {
        parts.push(instance);
    }
    let Some(witness) = &judgement.witness else {
        return (!parts.is_empty()).then(|| parts.join(", "));
    };
    // Coefficients of unknown functions are shown as the function.
    let mut functions: Vec<(String, Vec<String>)> = Vec::new();
    for (symbol, value) in &witness.assignment {
        match symbol.base().strip_prefix('[').and_then(|name| name.strip_suffix(']')) {
            Some(name) => {
                let text = value.to_string();
                match functions.iter_mut().find(|(known, _)| known == name) {
                    Some((_, list)) => list.push(text),
                    None => functions.push((name.to_owned(), vec![text])),
                }
            }
            None => parts.push(format!("{symbol} = {value}")),
        }
    }
    for (name, list) in functions {
        parts.push(format!("{name} with the coefficients {} of 1, t, ...", list.join(", ")));
    }
    let place = if parts.is_empty() { String::new() } else { format!("{}: ", parts.join(", ")) };
    Some(format!("{place}left {}, right {}", witness.left, witness.right))
}
