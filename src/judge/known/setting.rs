//! What a chain is tried with: the facts that it may rest on.

use std::collections::BTreeSet;
use std::rc::Rc;

use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::setting::{Facts, Setting};
use crate::judge::instances::trial::Trial;
use crate::judge::known::checker::Checker;
use crate::judge::model::Choices;
use crate::judge::page::context::{Condition, is_variable};
use crate::judge::page::statement::{Chain, Curve, Place};
use crate::judge::written::names::{Head, bases, is_index_letter, is_range};

impl Checker {
    /// What surrounds a chain: the facts that it may rest on.
    pub(in crate::judge) fn setting<'a>(
        &self,
        chain: &'a Chain,
        place: &'a Place,
        curve: Option<Curve>,
    ) -> Setting<'a> {
        let mut earlier: Vec<&Condition> = self
            .context
            .conditions
            .iter()
            .filter(|c| !chain.conditions.contains(&c.expr) && place.in_reach(&c.place, c.assumed))
            // "n = 1:", "n = 2:", … are values, each for its own paragraph.
            .filter(|c| c.place.group == place.group || !gives_a_number(&c.expr))
            .filter(|c| !bases(&c.expr).iter().any(|name| place.frees(name, &c.place)))
            .collect();
        // Of a letter that this section introduces anew another one says nothing.
        earlier.retain(|condition| {
            place.sees(&condition.place)
                || !bases(&condition.expr)
                    .iter()
                    .any(|base| self.context.is_spoken_of_anew(base, &condition.place, place))
        });
        // The nearest and latest first.
        earlier.sort_by_key(|condition| (place.sees(&condition.place), condition.line));
        earlier.reverse();
        // What says what a name is, is no condition on other names.
        let defines = |condition: &Condition| {
            named(&condition.expr).is_some_and(|head| {
                self.context.visible(&head.base, place).any(|(_, definition, _)| {
                    definition.line == condition.line
                        && definition.head.lower.len() == head.lower.len()
                        && definition.head.lower.iter().zip(&head.lower).all(|(a, b)| a.same_as(b))
                })
            })
        };
        earlier.retain(|condition| !defines(condition));
        let sides: Vec<&Expr> = chain.sides.iter().map(|side| &side.expr).collect();
        let reached = self.context.reached(&sides, place);
        let relevant = about(&earlier, &reached, &|expr| self.context.reached(&[expr], place));
        let mut relevant = relevant.into_iter();
        earlier.retain(|_| relevant.next() == Some(true));
        let knot_letters = self.context.knot_letters(place, &sides);
        let facts = Facts {
            contacts: self.contacts(place),
            given_knots: Rc::new(self.context.given_knots(&knot_letters, place)),
            near: earlier.iter().filter(|condition| place.sees(&condition.place)).count(),
            earlier: earlier.iter().map(|condition| condition.expr.clone()).collect(),
            ranges: earlier.iter().map(|condition| condition.ranges.clone()).collect(),
            reached,
            knot_letters,
        };
        Setting { chain, place, curve, facts: Rc::new(facts) }
    }

    pub(in crate::judge) fn trial<'a>(
        &self,
        setting: &Setting<'a>,
        sides: &[&'a Expr],
        relations: &[Rel],
        choices: Choices,
    ) -> Trial<'a> {
        Trial::new(self.context.clone(), setting, sides.to_vec(), relations.to_vec(), choices, &self.limits)
    }
}

/// The name that an equation gives a value.
fn named(condition: &Expr) -> Option<Head> {
    match &condition.kind {
        Kind::Chain(left, links) if links.len() == 1 && links[0].rel == Rel::Eq => {
            Head::of(left).filter(|head| head.arguments.is_none())
        }
        _ => None,
    }
}

/// Whether a condition gives an integer its value: n = 2.
fn gives_a_number(condition: &Expr) -> bool {
    match &condition.kind {
        Kind::Chain(left, links) => {
            matches!(&left.kind, Kind::Name(name) if is_index_letter(name))
                && matches!(links.as_slice(), [link] if link.rel == Rel::Eq && matches!(link.expr.kind, Kind::Number(_)))
        }
        _ => false,
    }
}

/// Those of some conditions that speak of the names of a claim, or of names that others of them speak of, through
/// definitions too. What a parameter or an index is called says nothing.
fn about(
    conditions: &[&Condition],
    claim: &BTreeSet<String>,
    names: &dyn Fn(&Expr) -> BTreeSet<String>,
) -> Vec<bool> {
    let telling = |name: &String| !is_variable(name) && (!is_index_letter(name) || claim.contains(name));
    let own: Vec<BTreeSet<String>> = conditions
        .iter()
        .map(|condition| names(&condition.expr).into_iter().filter(|name| telling(name)).collect())
        .collect();
    let mut known: BTreeSet<String> = claim.iter().filter(|name| telling(name)).cloned().collect();
    let mut taken: Vec<bool> = conditions.iter().map(|condition| is_range(&condition.expr)).collect();
    while let Some(at) = (0..own.len()).find(|&at| !taken[at] && !own[at].is_disjoint(&known)) {
        taken[at] = true;
        known.extend(own[at].iter().cloned());
    }
    // A relation between parameters alone, such as u + v = 1, is about all of them.
    (0..own.len()).map(|at| taken[at] || own[at].is_empty()).collect()
}
