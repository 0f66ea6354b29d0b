//! How definitions and names of a page fared: what was misread makes more than one relation fail.
//!
//! **Rule.** A relation is not refuted with a definition with which another relation of the page fails as well, and
//! none holds: the definition was misread, or it is the one that is wrong. Nor is it refuted if another relation
//! fails for which nothing shows that it is wrong, and that shares a name with it which no relation confirms.

use std::collections::{BTreeMap, BTreeSet};

use super::check::Checker;
use super::context::{Body, Definition, Source, is_variable};
use super::finding::{Finding, Verdict};
use super::names::{bases, is_index_letter};
use super::tally::Tally;
use super::verdict::UNFOUNDED;
use crate::formula::Expr;
use crate::language::lexicon::families;

/// What a relation rests on.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Ground {
    /// A definition of the page: the number of its formula, and its name.
    Definition(usize, String),
    Name(String),
}

/// A relation that was judged.
pub(super) struct Use {
    finding: usize,
    grounds: BTreeSet<Ground>,
    outcome: Outcome,
}

#[derive(Clone, Copy, PartialEq)]
enum Outcome {
    Holds,
    Refuted,
    /// It fails, and nothing shows that it is wrong.
    Unfounded,
    Open,
}

/// n = 3 is not misread.
fn gives_number(definition: &Definition) -> bool {
    match &definition.body {
        Body::Formula(body) => bases(body).is_empty(),
        Body::Value(value) => value.as_rational().is_some(),
    }
}

impl Checker {
    /// Keeps what a relation was judged with; `number` is that of the finding on the page.
    pub(super) fn rely(&mut self, tally: &Tally, sides: [&Expr; 2], number: usize, finding: &Finding) {
        let definitions = tally
            .record
            .definitions
            .iter()
            .map(|(number, _)| &self.context.definitions[*number])
            .filter(|definition| definition.source == Source::Page && !gives_number(definition))
            .map(|definition| Ground::Definition(definition.place.formula, definition.head.base.clone()));
        let own = |name: &String| !is_variable(name) && !is_index_letter(name) && !families::is_family(name);
        let names = sides.into_iter().flat_map(bases).filter(own).map(Ground::Name);
        let outcome = match finding.verdict {
            Verdict::Proved | Verdict::Sampled if tally.nonzero > 0 => Outcome::Holds,
            Verdict::Refuted => Outcome::Refuted,
            _ if finding.reason.as_deref() == Some(UNFOUNDED) => Outcome::Unfounded,
            _ => Outcome::Open,
        };
        self.uses.retain(|one| one.finding != number);
        self.uses.push(Use { finding: number, grounds: definitions.chain(names).collect(), outcome });
    }

    /// Takes back what was refuted on doubtful grounds. To be called after the last statement.
    pub fn finish(&mut self) {
        let mut record: BTreeMap<&Ground, Vec<Outcome>> = BTreeMap::new();
        for one in &self.uses {
            one.grounds.iter().for_each(|ground| record.entry(ground).or_default().push(one.outcome));
        }
        let doubtful = |ground: &&Ground| {
            let Some(outcomes) = record.get(ground) else { return false };
            let count = |outcome| outcomes.iter().filter(|own| **own == outcome).count();
            let (refuted, unfounded) = (count(Outcome::Refuted), count(Outcome::Unfounded));
            let fails = match ground {
                Ground::Definition(..) => refuted + unfounded > 1,
                Ground::Name(_) => unfounded > 0,
            };
            fails && count(Outcome::Holds) == 0
        };
        for one in self.uses.iter().filter(|one| one.outcome == Outcome::Refuted) {
            let Some(Ground::Definition(_, name) | Ground::Name(name)) = one.grounds.iter().find(doubtful)
            else {
                continue;
            };
            let Some(finding) = self.findings.get_mut(one.finding) else { continue };
            *finding = Finding {
                verdict: Verdict::Undecided,
                reason: Some(format!("all that is said with {name} fails: it may mean something else")),
                warning: finding.reason.take(),
                suggestion: None,
                evidence: Vec::new(),
                ..finding.clone()
            };
        }
    }
}
