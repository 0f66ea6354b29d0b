//! What is claimed of any functions of known degrees, of which the page may say how they agree.
//!
//! **Definition.** The *facts* about two functions of known degrees are the equations of the page between their values,
//! and what its words say of derivatives that agree: linear equations in the coefficients of any polynomials of these
//! degrees. The *general solution* has those coefficients in terms of the others that stay free.
//!
//! **Rule.** What holds for the general solution follows from the facts. What fails for it is wrong, if every word that
//! may say a fact is understood.

use std::collections::BTreeSet;

use crate::budget;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::conditions::Conditions;
use crate::judge::instances::hypotheses::{self, is_coefficient};
use crate::judge::instances::tally::Tally;
use crate::judge::instances::trial::Trial;
use crate::judge::values::compare::{self, Outcome};
use crate::judge::written::names::bases;
use crate::language::value::Value;
use crate::math::poly::Symbol;

/// Equations between functions that words say agree.
#[derive(Default)]
pub struct Contacts {
    /// What they say for sure.
    pub(in crate::judge) certain: Vec<Expr>,
    /// What they may say; nothing if they are not understood.
    pub(in crate::judge) possible: Option<Vec<Expr>>,
}

impl Conditions<'_> {
    /// How a relation between functions of known degrees fares with the facts about them.
    pub(in crate::judge) fn by_contact(
        &self,
        trial: &Trial,
        left: &Value,
        right: &Value,
        bound: &[(String, i64)],
        degree: Option<usize>,
        tally: &mut Tally,
    ) -> Option<Outcome> {
        let coefficients = |value: &Value| -> BTreeSet<Symbol> {
            compare::symbols(value).into_iter().filter(is_coefficient).collect()
        };
        let own: BTreeSet<Symbol> = coefficients(left).into_iter().chain(coefficients(right)).collect();
        let name = |symbol: &Symbol| symbol.base().trim_matches(['[', ']']).to_owned();
        let functions: BTreeSet<String> = own.iter().map(name).collect();
        let known = functions.iter().all(|name| {
            trial.context.object_called(name, trial.place).is_some_and(|own| own.object.is_any_polynomial())
        });
        // F, or F_1 and F_2
        let members = |symbol: &Symbol| {
            let indices = symbol.indices();
            (symbol.base().to_owned(), indices[..indices.len().saturating_sub(1)].to_vec())
        };
        let several =
            own.first().is_some_and(|first| own.iter().any(|other| members(other) != members(first)));
        let one = !several && (coefficients(left).is_empty() || coefficients(right).is_empty());
        if one || own.is_empty() || !known {
            return None;
        }
        let value = |equation: &Expr| trial.evaluated_condition(equation, bound, degree);
        // Equations of the page between values of functions
        let (mut stated, mut understood) = (Vec::new(), true);
        for condition in trial.hypotheses() {
            let Kind::Chain(one, links) = &condition.kind else { continue };
            if !matches!(links.as_slice(), [link] if link.rel == Rel::Eq) || matches!(one.kind, Kind::Name(_))
            {
                continue;
            }
            let speaks = bases(condition)
                .iter()
                .any(|name| functions.contains(name) || functions.contains(&name.to_uppercase()));
            // F^{(k)}(a) = G^{(k)}(a) for k = 0, 1
            for own in trial.condition_instances(condition, bound, degree) {
                match trial.condition_values(condition, &own, degree) {
                    Some((a, b)) if !(coefficients(&a).is_empty() && coefficients(&b).is_empty()) => {
                        stated.push((a, b));
                    }
                    _ => understood &= !speaks,
                }
            }
        }
        let contacts = &trial.facts.contacts;
        let solved = |equations: &[Expr]| {
            let said: Option<Vec<(Value, Value)>> = equations.iter().map(value).collect();
            let all: Vec<(Value, Value)> = stated.iter().cloned().chain(said?).collect();
            budget::step();
            let solution = match all.is_empty() {
                true => Vec::new(),
                false => hypotheses::general(&all, &is_coefficient)?,
            };
            Some((compare::substituted(left, &solution)?, compare::substituted(right, &solution)?))
        };
        let related = |(l, r): &(Value, Value)| compare::relation(Rel::Eq, l, r, &[], compare::Domain::Reals);
        if let Some(sides) = solved(&contacts.certain)
            && matches!(related(&sides), Outcome::Holds)
        {
            tally.condition.get_or_insert(0);
            return Some(Outcome::Holds);
        }
        let possible = contacts.possible.as_ref().filter(|_| understood && bound.is_empty())?;
        // What relates them nobody has said.
        if several && stated.is_empty() && possible.is_empty() {
            return None;
        }
        let sides = solved(possible)?;
        match related(&sides) {
            outcome @ Outcome::Fails(_) => {
                tally.related += 1;
                Some(outcome)
            }
            _ => None,
        }
    }
}
