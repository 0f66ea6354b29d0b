//! What the page supposes of the names of a relation and the judge does not use: a relation that fails may rest on it.
//!
//! **Rule.** Red is certain only if all is used that the section says of what a relation speaks of: in words that are
//! not understood, in laws such as f(t) = f(1 - t) that stay open, and in equations between members of one family.

use std::collections::BTreeSet;

use super::check::{Checker, equates_values};
use super::context::{Body, is_variable};
use super::finding::{Finding, Verdict};
use super::names::{Head, bases};
use super::statement::{Chain, Place, Statement};
use super::topic::Topic;
use crate::formula::{Expr, Kind};

impl Checker {
    /// Keeps open what was called wrong if something that the page supposes may have been needed for it.
    pub(super) fn as_supposed(&self, chain: &Chain, statement: &Statement, findings: &mut [Finding]) {
        let place = &statement.place;
        // The field knows what rational curves are, and what d_1, d_2 or N_0, N_1 are, consecutive or normalised.
        let rational = statement.topics.has(Topic::Rational);
        let one = |expr: &Expr| match &expr.kind {
            Kind::Apply(callee, _) => match &callee.kind {
                Kind::Prime(inner, _) => matches!(inner.kind, Kind::Name(_)),
                own => matches!(own, Kind::Name(_)),
            },
            _ => false,
        };
        for (at, finding) in findings.iter_mut().enumerate() {
            if finding.verdict != Verdict::Refuted {
                continue;
            }
            let sides = [&chain.sides[at].expr, &chain.sides[at + 1].expr];
            let unknown = (!rational && sides.iter().any(|side| side.has(&one)))
                .then(|| self.said_in_unknown_words(sides, place))
                .flatten();
            let doubt = unknown.or_else(|| self.open_law(sides, place));
            if let Some(reason) = doubt {
                finding.verdict = Verdict::Undecided;
                finding.reason = Some(reason);
                (finding.witness, finding.suggestion) = (None, None);
                finding.evidence.clear();
            }
        }
    }

    /// A law of a function in a relation that stayed open, with its line.
    fn open_law(&self, sides: [&Expr; 2], place: &Place) -> Option<String> {
        let own: BTreeSet<String> = sides.into_iter().flat_map(bases).collect();
        let mut laws =
            self.laws.iter().filter(|(name, other, _)| own.contains(name) && place.knows(other, false));
        laws.next().map(|(name, _, line)| format!("what line {line} says of {name} is not used"))
    }

    /// Remembers a law that stayed open: f(t) = f(1 - t).
    pub(super) fn remember_law(&mut self, chain: &Chain, place: &Place, findings: &[Finding]) {
        let open = findings.iter().all(|finding| finding.verdict == Verdict::Undecided);
        if !open || !equates_values(chain) {
            return;
        }
        let called = |expr: &Expr| match &expr.kind {
            Kind::Apply(callee, groups) => {
                let varies = |argument: &Expr| bases(argument).iter().any(|name| is_variable(name));
                Head::of(callee).filter(|_| groups.iter().flatten().any(varies))
            }
            _ => None,
        };
        let (Some(one), Some(other)) = (called(&chain.sides[0].expr), called(&chain.sides[1].expr)) else {
            return;
        };
        if one.base == other.base {
            let line = self.line(chain.sides[0].expr.span);
            self.laws.push((one.base, place.clone(), line));
        }
    }

    /// Whether the page says that a member of one of these families is another one: b_3 = b_0.
    pub(super) fn has_equal_members(&self, letters: &BTreeSet<String>, place: &Place) -> bool {
        let member = |head: &Head| head.arguments.is_none() && head.lower.len() == 1 && head.upper.is_empty();
        letters.iter().any(|letter| {
            self.context.visible(letter, place).any(|(_, definition, near)| {
                let Body::Formula(body) = &definition.body else { return false };
                let same = Head::of(body).filter(&member).is_some_and(|other| other.base == *letter);
                near && member(&definition.head) && same
            })
        })
    }
}
