//! Claims about families: `B_i^n(t) = …` for integers n and i without values.
//!
//! Such a claim is tried for all small values of its integer names. It is *sampled*, never
//! proved, when every instance that makes sense is an exact identity. It is refuted only when it
//! fails where nothing is degenerate; a claim that fails for some values and holds for others
//! is undecided, because its author may have meant a part of them.

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind, Link, Rel};
use crate::judge::values::claim::judge_plainly;
use crate::judge::written::names::{is_gcd, names_a_parameter, walk};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::names::stands_for_itself;
use crate::language::eval::{Machine, name_of};
use crate::language::lexicon::families;
use crate::language::value::{Judgement, Value, Verdict};
use crate::math::poly::Symbol;

/// Values tried for each name run from 0 to the entry for the number of names.
const LARGEST: [i64; 5] = [0, 10, 6, 4, 3];

/// Fewer instances than this say nothing.
const FEWEST: usize = 3;

/// How the instances of one relation went.
#[derive(Default)]
struct Tally {
    holds: usize,
    fails: Vec<(Vec<i64>, Judgement)>,
    last: Option<Judgement>,
}

/// Judges a chain by its instances; `None` if no names stand for integers, or too few
/// instances make sense.
pub(crate) fn judge_family(machine: &mut Machine, first: &Expr, links: &[Link]) -> Option<Vec<Judgement>> {
    if !links.iter().all(|link| matches!(link.rel, Rel::Eq | Rel::Equiv)) {
        return None;
    }
    let mut names = Vec::new();
    integer_names(machine, first, false, &mut names);
    links.iter().for_each(|link| integer_names(machine, &link.expr, false, &mut names));
    let largest = *LARGEST.get(names.len()).filter(|_| !names.is_empty())?;
    let mut tallies: Vec<Tally> = links.iter().map(|_| Tally::default()).collect();
    let mut count = 0;
    let mut values = vec![0i64; names.len()];
    loop {
        crate::budget::steps(64);
        let bound: Vec<(Symbol, Value)> =
            names.iter().cloned().zip(values.iter().map(|&v| Value::int(v))).collect();
        // An instance that makes no sense, such as (−1)!, is passed over.
        if let Ok(judgements) = machine.with_locals(bound, |machine| judge_plainly(machine, first, links)) {
            count += 1;
            for (tally, judgement) in tallies.iter_mut().zip(judgements) {
                match judgement.verdict {
                    Verdict::Proved => tally.holds += 1,
                    Verdict::Refuted => tally.fails.push((values.clone(), judgement.clone())),
                    _ => {}
                }
                tally.last = Some(judgement);
            }
        }
        if !advance(&mut values, largest) {
            break;
        }
    }
    if count < FEWEST {
        return None;
    }
    let range =
        format!("{} from 0 to {largest}", names.iter().map(Symbol::to_string).collect::<Vec<_>>().join(", "));
    tallies.into_iter().map(|tally| tally.verdict(&names, &range)).collect()
}

/// Whether a gcd stands in a chain whose arguments may be integers: gcd(a, b).
pub(crate) fn counts_divisors(first: &Expr, links: &[Link]) -> bool {
    let mut found = false;
    for side in std::iter::once(first).chain(links.iter().map(|link| &link.expr)) {
        walk(side, &mut |part| found |= of_letters(part));
    }
    found
}

/// Whether an expression is the gcd of what may be integers.
fn of_letters(expr: &Expr) -> bool {
    matches!(&expr.kind, Kind::Apply(callee, groups) if is_gcd(callee) && !groups.iter().flatten().any(names_a_parameter))
}

/// The verdicts on a chain with gcds that was judged for polynomials in its names: they have to hold for integers,
/// too.
pub(crate) fn of_integers(
    machine: &mut Machine,
    first: &Expr,
    links: &[Link],
    judgements: Vec<Judgement>,
) -> Vec<Judgement> {
    let Some(others) = judge_family(machine, first, links) else { return judgements };
    let agreed =
        |(polynomials, integers): (Judgement, Judgement)| match (polynomials.verdict, integers.verdict) {
            (Verdict::Refuted, Verdict::Refuted) => integers,
            (Verdict::Proved, Verdict::Sampled) => integers,
            (Verdict::Proved, _) => {
                let names = "it is true of polynomials, not of all integers".to_owned();
                let reasons = std::iter::once(names).chain(integers.reasons).collect();
                Judgement { verdict: Verdict::Undecided, reasons, ..polynomials }
            }
            (_, Verdict::Sampled) => {
                let reasons = vec!["it seems true of integers, not of polynomials".to_owned()];
                Judgement { verdict: Verdict::Undecided, reasons, witness: None, ..polynomials }
            }
            _ => integers,
        };
    judgements.into_iter().zip(others).map(agreed).collect()
}

/// Names without a value that stand where only integers make sense: in exponents, upper and
/// lower entries of binomials, factorials, bounds of sums, indices of families.
fn integer_names(machine: &mut Machine, expr: &Expr, inside: bool, names: &mut Vec<Symbol>) {
    if let Kind::Name(_) = &expr.kind {
        if inside
            && let Some(name) = name_of(expr, machine)
            && machine.lookup(&name).is_none()
            && stands_for_itself(name.base())
            && !names.contains(&name)
        {
            names.push(name);
        }
        return;
    }
    match &expr.kind {
        Kind::Pow(base, exponent) => {
            // f^T and the like are not powers.
            integer_names(machine, base, inside, names);
            integer_names(machine, exponent, true, names);
        }
        Kind::Subscript(base, indices) => {
            let family = name_of(base, machine).is_some_and(|name| {
                matches!(machine.lookup(&name), Some(Value::Function(_))) || families::has_values(name.base())
            });
            for index in indices {
                integer_names(machine, index, family, names);
            }
        }
        Kind::Binomial(n, k, _) => {
            integer_names(machine, n, true, names);
            integer_names(machine, k, true, names);
        }
        Kind::Factorial(body) => integer_names(machine, body, true, names),
        Kind::Apply(_, groups) if of_letters(expr) => {
            groups.iter().flatten().for_each(|item| integer_names(machine, item, true, names));
        }
        Kind::Big { lower, upper, body, .. } => {
            let mut own = Vec::new();
            for piece in lower {
                if let Kind::Chain(left, links) = &piece.kind {
                    own.extend(name_of(left, machine));
                    links.iter().for_each(|link| integer_names(machine, &link.expr, true, names));
                }
            }
            if let Some(upper) = upper {
                integer_names(machine, upper, true, names);
            }
            let mut inner = Vec::new();
            integer_names(machine, body, inside, &mut inner);
            names.extend(inner.into_iter().filter(|name| !own.contains(name)));
            let mut seen = BTreeSet::new();
            names.retain(|name| seen.insert(name.clone()));
        }
        Kind::Range(from, to) => {
            integer_names(machine, from, true, names);
            integer_names(machine, to, true, names);
        }
        _ => {
            let mut children = Vec::new();
            expr.for_each_child(&mut |child| children.push(child));
            for child in children {
                integer_names(machine, child, inside, names);
            }
        }
    }
}

impl Tally {
    fn verdict(self, names: &[Symbol], range: &str) -> Option<Judgement> {
        let mut judgement = self.last?;
        let instance = |values: &[i64]| -> String {
            let pairs = names.iter().zip(values).map(|(name, value)| format!("{name} = {value}"));
            pairs.collect::<Vec<_>>().join(", ")
        };
        judgement.difference = None;
        judgement.witness = None;
        if self.fails.is_empty() {
            let enough = self.holds >= FEWEST;
            judgement.verdict = if enough { Verdict::Sampled } else { Verdict::Undecided };
            judgement.reasons = vec![format!("exact for all {} instances tried: {range}", self.holds)];
            return Some(judgement);
        }
        let degenerate = |values: &[i64]| values.contains(&0);
        let inner = self.fails.iter().find(|(values, _)| !degenerate(values));
        // More failures than successes: it is wrong, not merely meant for a part.
        if let Some((values, failed)) = inner
            && self.fails.len() > self.holds
        {
            let mut failed = failed.clone();
            failed.reasons.insert(0, format!("it fails for {}", instance(values)));
            return Some(failed);
        }
        judgement.verdict = Verdict::Undecided;
        judgement.reasons = vec![
            format!("exact for {} of {} instances tried: {range}", self.holds, self.holds + self.fails.len()),
            format!("it fails for {}; is it meant for a part of the range?", instance(&self.fails[0].0)),
        ];
        Some(judgement)
    }
}

/// Errors that a claim with integer names runs into when these have no values.
pub(crate) fn may_be_family(error: &Diagnostic) -> bool {
    matches!(error.code, Code::Type | Code::BadExponent | Code::Undecided | Code::Domain | Code::Arity)
}

/// The next combination of values, the last one fastest; false after the last combination.
pub(in crate::judge) fn advance(values: &mut [i64], largest: i64) -> bool {
    for value in values.iter_mut().rev() {
        if *value < largest {
            *value += 1;
            return true;
        }
        *value = 0;
    }
    false
}
