//! Trying the readings of ambiguous notations until one makes a chain true.

use std::collections::BTreeSet;

use crate::formula::{BigOp, Expr, Kind, Rel, Sign, Term};
use crate::judge::instances::integers::may_begin_with_one;
use crate::judge::instances::setting::Setting;
use crate::judge::instances::tally::{Outcomes, Tally};
use crate::judge::known::checker::Checker;
use crate::judge::model::{Ambiguity, Choices};
use crate::judge::page::context::Body;
use crate::judge::page::statement::{Chain, Curve};
use crate::judge::written::names::{Head, bases, own_names, walk};

/// An attempt to judge a chain under one way of reading it.
pub struct Attempt {
    pub outcomes: Outcomes,
    pub choices: Choices,
    pub curve: Option<Curve>,
}

impl Checker {
    /// Tries the readings of ambiguous notations until one makes everything true; else the first.
    pub(in crate::judge) fn attempts(
        &self,
        setting: &Setting,
        sides: &[&Expr],
        relations: &[Rel],
    ) -> Attempt {
        let best = self.best_reading(setting, sides, relations);
        let best = self.by_coordinates(setting, sides, relations, &best).unwrap_or(best);
        self.settle_readings(&best, setting, sides, relations);
        best
    }

    /// A notation that makes a formula true in one reading only is meant so on the whole page: N_0^2 is of degree 2
    /// or of order 2.
    fn settle_readings(&self, best: &Attempt, setting: &Setting, sides: &[&Expr], relations: &[Rel]) {
        let held = |tally: &Tally| tally.fails.is_empty() && tally.nonzero > 0;
        let mut found: BTreeSet<Ambiguity> =
            best.outcomes.tallies.iter().flat_map(|tally| tally.record.ambiguous.iter().copied()).collect();
        found.retain(|ambiguity| {
            *ambiguity == Ambiguity::Spline && !self.settled.borrow().contains_key(ambiguity)
        });
        if found.is_empty() || !best.outcomes.tallies.iter().all(held) {
            return;
        }
        for ambiguity in found {
            let mut other = best.choices;
            let reading = *other.reading(ambiguity);
            *other.reading(ambiguity) = !reading;
            let outcomes = self.trial(setting, sides, relations, other).first(4);
            if outcomes.tallies.iter().any(|tally| !tally.fails.is_empty()) {
                self.settled.borrow_mut().insert(ambiguity, reading);
            }
        }
    }

    /// Where unknown functions meet points, as f(0, 1) = (3, 6): the coordinates one by one.
    fn by_coordinates(
        &self,
        setting: &Setting,
        sides: &[&Expr],
        relations: &[Rel],
        best: &Attempt,
    ) -> Option<Attempt> {
        let decided = |tally: &Tally| tally.holds > 0 || !tally.fails.is_empty();
        let open = |attempt: &Attempt| !attempt.outcomes.tallies.iter().all(decided);
        let unclear = best.outcomes.tallies.iter().any(|tally| !tally.unclear.is_empty());
        let unknown = best.outcomes.tallies.iter().any(|tally| {
            let record = &tally.record;
            !record.unknown.is_empty() || !record.generic.is_empty()
        });
        if !open(best) || !unclear || !unknown {
            return None;
        }
        let count = sides.iter().find_map(|side| coordinates(side))?;
        let mut found: Vec<Attempt> = Vec::new();
        for number in 0..count {
            let choices = Choices { coordinate: Some((number, count)), ..best.choices };
            let outcomes = self.trial(setting, sides, relations, choices).run();
            let attempt = Attempt { outcomes, choices, curve: setting.curve.clone() };
            if open(&attempt) {
                return None;
            }
            found.push(attempt);
        }
        // What is no function and was compared as points stays so; else the coordinate in which it fails counts.
        let whole = best.outcomes.tallies.iter().any(decided);
        let worth = |tally: &Tally| (!tally.fails.is_empty(), tally.nonzero);
        let telling = |at: usize| {
            let tallies = found.iter().enumerate();
            tallies.max_by_key(|(_, attempt)| worth(&attempt.outcomes.tallies[at])).map(|(number, _)| number)
        };
        let first = found.get(telling(0)?)?;
        let choices = if whole { best.choices } else { first.choices };
        let mut outcomes = first.outcomes.clone();
        for (at, tally) in outcomes.tallies.iter_mut().enumerate() {
            *tally = match &best.outcomes.tallies[at] {
                own if decided(own) => own.clone(),
                _ => found[telling(at)?].outcomes.tallies[at].clone(),
            };
        }
        Some(Attempt { outcomes, choices, curve: setting.curve.clone() })
    }

    fn best_reading(&self, setting: &Setting, sides: &[&Expr], relations: &[Rel]) -> Attempt {
        let mut usual = Choices::default();
        for (ambiguity, reading) in &*self.settled.borrow() {
            *usual.reading(*ambiguity) = *reading;
        }
        let run = |choices: Choices| -> Attempt {
            let outcomes = self.trial(setting, sides, relations, choices).run();
            Attempt { outcomes, choices, curve: setting.curve.clone() }
        };
        let first = run(usual);
        let bad =
            |attempt: &Attempt| attempt.outcomes.tallies.iter().map(|tally| tally.fails.len()).sum::<usize>();
        let good =
            |attempt: &Attempt| attempt.outcomes.tallies.iter().map(|tally| tally.holds).sum::<usize>();
        if bad(&first) == 0 && good(&first) > 0 {
            return first;
        }
        let mut ambiguous = BTreeSet::new();
        let mut far = false;
        for tally in &first.outcomes.tallies {
            ambiguous.extend(tally.record.ambiguous.iter().copied());
            far |= tally.record.definitions.iter().any(|(_, near)| !near);
        }
        let numbers = first.outcomes.tallies.iter().flat_map(|tally| &tally.record.definitions);
        let bodies = numbers.filter_map(|(number, _)| match &self.context.definitions[*number].body {
            Body::Formula(body) => Some(body),
            Body::Value(_) => None,
        });
        if bodies.chain(sides.iter().copied()).any(sums_over_first) {
            ambiguous.remove(&Ambiguity::Bernstein);
        }
        ambiguous.retain(|ambiguity| !self.settled.borrow().contains_key(ambiguity));
        let mut options = vec![usual];
        for ambiguity in ambiguous {
            let more: Vec<Choices> = options
                .iter()
                .map(|choices| {
                    let mut other = *choices;
                    *other.reading(ambiguity) = true;
                    other
                })
                .collect();
            options.extend(more);
        }
        if far {
            let more: Vec<Choices> =
                options.iter().map(|choices| Choices { near_only: true, ..*choices }).collect();
            options.extend(more);
        }
        // A formula with integers in it speaks of functions in general.
        let general = !first.outcomes.integers.is_empty()
            || first.outcomes.tallies.iter().any(|tally| tally.record.infinite);
        let examples = |attempt: &Attempt| {
            attempt.outcomes.tallies.iter().any(|tally| !tally.record.definitions.is_empty())
        };
        let mut best = first;
        if general && examples(&best) {
            let attempt = run(Choices { general: true, ..usual });
            if good(&attempt) + bad(&attempt) > 0 {
                best = attempt;
                for choices in &mut options {
                    choices.general = true;
                }
                if bad(&best) == 0 {
                    return best;
                }
            }
        }
        for choices in options.into_iter().skip(1) {
            let attempt = run(choices);
            // Everything is zero: that is no reading anybody means.
            let solid = |attempt: &Attempt| {
                attempt.outcomes.tallies.iter().map(|tally| tally.nonzero + tally.fails.len()).sum::<usize>()
            };
            if solid(&attempt) * 2 < solid(&best) {
                continue;
            }
            let decides = good(&attempt) + bad(&attempt) > 0;
            if decides && bad(&attempt) < bad(&best) && good(&attempt) >= good(&best)
                || bad(&attempt) == 0 && good(&attempt) > 0
            {
                best = attempt;
            }
            if bad(&best) == 0 {
                break;
            }
        }
        // Σ 2i − 1, where the sign is meant for all that follows.
        if bad(&best) > 0 {
            let wide: Vec<Expr> = sides.iter().map(|side| reaching_on(side)).collect();
            let changed = wide.iter().zip(sides).any(|(wide, side)| !wide.same_as(side));
            if changed {
                let wide: Vec<&Expr> = wide.iter().collect();
                let outcomes = self.trial(setting, &wide, relations, best.choices).run();
                let attempt = Attempt { outcomes, choices: best.choices, curve: setting.curve.clone() };
                if bad(&attempt) == 0 && good(&attempt) > 0 {
                    return attempt;
                }
            }
        }
        best
    }

    /// Tries relations by themselves that were not reached because another side is too large.
    pub(in crate::judge) fn retry(
        &self,
        setting: &Setting,
        sides: &[&Expr],
        relations: &[Rel],
        best: &mut Attempt,
    ) {
        for at in 0..relations.len() {
            let tally = &best.outcomes.tallies[at];
            let open = tally.holds == 0 && tally.fails.is_empty() && !tally.unclear.is_empty();
            if open && relations.len() > 1 {
                let mut alone = self.attempts(setting, &sides[at..at + 2], &relations[at..=at]);
                let tally = alone.outcomes.tallies.remove(0);
                if tally.holds > 0 || !tally.fails.is_empty() {
                    best.outcomes.tallies[at] = tally;
                }
            }
        }
    }
}

/// Whether a sum over the first index up to the second tells which one is the degree: Σ_{i=0}^p B_{i,p}.
fn sums_over_first(expr: &Expr) -> bool {
    let mut found = false;
    walk(expr, &mut |part| {
        let Kind::Big { lower, upper: Some(upper), body, .. } = &part.kind else { return };
        let bound = own_names(lower);
        walk(body, &mut |inner| {
            if let Some(head) = Head::of(inner).filter(Head::is_bernstein)
                && let [first, second] = head.lower.as_slice()
            {
                found |=
                    matches!(&first.kind, Kind::Name(name) if bound.contains(name)) && second.same_as(upper);
            }
        });
    });
    found
}

/// A relation that fails only where it is not meant: for integers that are 0, or for indices beyond
/// the degree. Nothing is restricted if the file itself says for which integers it holds.
pub fn restricted(tally: &Tally, outcomes: &Outcomes, chain: &Chain) -> Option<&'static str> {
    if tally.fails.is_empty()
        || outcomes.cut
        || tally.holds_proper < 2
        || outcomes.integers.is_empty()
        || tally.fails.len() > tally.holds.max(12)
    {
        return None;
    }
    if tally.fails.iter().all(|failure| failure.outside) {
        return Some("true for indices from 0 to the degree");
    }
    let sides: Vec<&Expr> = chain.sides.iter().map(|side| &side.expr).collect();
    let mut free = may_begin_with_one(&sides);
    free.retain(|name| !chain.conditions.iter().any(|condition| bases(condition).contains(name)));
    let zero =
        |integers: &[(String, i64)]| integers.iter().any(|(name, value)| *value == 0 && free.contains(name));
    tally
        .fails
        .iter()
        .all(|failure| failure.outside || zero(&failure.integers))
        .then_some("true for positive integers")
}

/// The side with the numbers after a sum or product that is not closed taken into it: Σ (2i − 1) for Σ 2i − 1. Letters stay
/// outside: Σ x_i^2 − m^2 is not Σ (x_i^2 − m^2).
fn reaching_on(side: &Expr) -> Expr {
    let Kind::Add(terms) = &side.kind else { return side.clone() };
    let sums = |term: &Term| {
        let open = matches!(&term.expr.kind, Kind::Big { op: BigOp::Sum | BigOp::Product, .. });
        term.sign == Sign::Plus && open
    };
    let numbers = |at: usize| terms[at + 1..].iter().all(|term| bases(&term.expr).is_empty());
    let Some(at) = terms.iter().position(sums).filter(|&at| at + 1 < terms.len() && numbers(at)) else {
        return side.clone();
    };
    let mut sum = terms[at].expr.clone();
    if let Kind::Big { body, .. } = &mut sum.kind {
        let first = Term { sign: Sign::Plus, expr: body.as_ref().clone() };
        let all = std::iter::once(first).chain(terms[at + 1..].iter().cloned()).collect();
        **body = Expr::sum(all);
    }
    let sum = Term { sign: terms[at].sign, expr: sum };
    Expr::sum(terms[..at].iter().cloned().chain([sum]).collect())
}

/// A relation about members with numbers, such as x_2, that fails only for degrees so small that there are none.
pub fn beyond_degree(tally: &Tally, outcomes: &Outcomes, left: &Expr, right: &Expr) -> Option<&'static str> {
    let mut largest = 0;
    for side in [left, right] {
        walk(side, &mut |part| {
            if let Kind::Subscript(_, lower) = &part.kind {
                largest = lower.iter().filter_map(Expr::as_int).chain([largest]).max().unwrap_or(0);
            }
        });
    }
    let small = |degree: Option<usize>| degree.is_some_and(|degree| (degree as i64) < largest);
    let failed = !tally.fails.is_empty() && tally.fails.iter().all(|failure| small(failure.degree));
    (outcomes.degrees && outcomes.integers.is_empty() && largest < 3 && failed && tally.holds > 2)
        .then_some("true for all degrees for which there are these members")
}

/// How many coordinates the point has that a side is.
fn coordinates(side: &Expr) -> Option<usize> {
    let count = match &side.kind {
        Kind::List(items) | Kind::Tuple(items) => items.len(),
        Kind::Matrix(rows, _) if rows.iter().all(|row| row.len() == 1) => rows.len(),
        Kind::Binomial(..) => 2,
        _ => return None,
    };
    matches!(count, 2 | 3).then_some(count)
}
