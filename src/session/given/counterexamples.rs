//! Counterexamples where conditions hold: fractions between and beside the numbers that bound the names of a claim.

use std::collections::BTreeSet;

use crate::formula::Rel;
use crate::judge::values::inequality::positive;
use crate::language::lexicon::roles;
use crate::language::value::{Judgement, Verdict, Witness};
use crate::math::number::{Rational, integer, rational};
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Field;

/// How many points are tried at most.
const MOST: usize = 400;

/// The claim refuted by each point at which it fails, whether the conditions hold there or not.
pub(in crate::session) fn refutations<'a>(
    judgement: &'a Judgement,
    conditions: &'a [Judgement],
) -> impl Iterator<Item = Judgement> + 'a {
    let sides = judgement.left.as_scalar().zip(judgement.right.as_scalar());
    let mut names: Vec<Symbol> = sides.map_or(Vec::new(), |(left, right)| {
        let mut names = left.variables();
        names.extend(right.variables());
        names
    });
    names.sort();
    names.dedup();
    // A fraction is no value of n.
    let whole = |name: &Symbol| roles::is_degree(name.base()) || roles::is_index_letter(name.base());
    let names = if names.iter().any(whole) { Vec::new() } else { names };
    let values: Vec<Vec<Rational>> = names.iter().map(|name| trial_values(name, conditions)).collect();
    let count = values.iter().try_fold(1_usize, |count, own| count.checked_mul(own.len())).unwrap_or(MOST);
    let count = if names.is_empty() { 0 } else { count.min(MOST) };
    (0..count).filter_map(move |number| {
        crate::budget::steps(16);
        let mut rest = number;
        let point = values.iter().map(|own| {
            let value = own[rest % own.len()].clone();
            rest /= own.len();
            value
        });
        let assignment: Vec<(Symbol, Rational)> = names.iter().cloned().zip(point).collect();
        let at = |side: &Fraction| {
            side.value(&|name: &Symbol| {
                assignment.iter().find(|(known, _)| known == name).map(|(_, value)| value.clone())
            })
        };
        let (left, right) = sides?;
        let (left, right) = (at(left)?, at(right)?);
        let fails = match judgement.rel {
            Rel::Eq => left != right,
            Rel::Ne => left == right,
            Rel::Lt => left >= right,
            Rel::Le => left > right,
            Rel::Gt => left <= right,
            Rel::Ge => left < right,
            _ => false,
        };
        fails.then(|| Judgement {
            verdict: Verdict::Refuted,
            witness: Some(Witness { assignment, left, right }),
            reasons: Vec::new(),
            ..judgement.clone()
        })
    })
}

/// Values for a name: between the numbers that conditions compare it with, then these and what lies beside them.
fn trial_values(name: &Symbol, conditions: &[Judgement]) -> Vec<Rational> {
    let mut bounds: Vec<Rational> = conditions
        .iter()
        .filter_map(positive)
        .filter_map(|(positive, _)| {
            // c (t - a) or c (a - t)
            let slope = positive.derivative(name).as_rational()?;
            let at_zero = positive.value(&|other: &Symbol| (other == name).then(|| integer(0)))?;
            Some(-(at_zero * slope.inverse()?))
        })
        .collect();
    bounds.sort();
    bounds.dedup();
    let between = |pair: &[Rational]| {
        let part = |q: Rational| &pair[0] + &((&pair[1] - &pair[0]) * q);
        [part(rational(1, 2)), part(rational(1, 3)), part(rational(3, 4))]
    };
    let mut values: Vec<Rational> = bounds.windows(2).flat_map(between).collect();
    if let (Some(first), Some(last)) = (bounds.first(), bounds.last()) {
        values.extend([last + integer(1), first - integer(1), last + rational(1, 2)]);
    }
    values.extend([rational(1, 2), integer(2), rational(-1, 2), integer(1), integer(0), integer(-1)]);
    values.extend(bounds);
    let mut seen = BTreeSet::new();
    values.retain(|value| seen.insert(value.clone()));
    values
}
