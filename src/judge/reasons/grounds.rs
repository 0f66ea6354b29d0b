//! How definitions and names of a page fared: what was misread makes more than one relation fail.
//!
//! **Rule.** A relation is not refuted with a definition with which another relation of the page fails as well, and
//! none holds: the definition was misread, or it is the one that is wrong. Nor is it refuted if another relation
//! fails for which nothing shows that it is wrong, and that shares a name with it which no relation confirms. The other
//! way round, a relation that fails alone is refuted if other relations hold with every name and definition in it.

use std::collections::BTreeMap;

use crate::formula::Expr;
use crate::judge::instances::tally::Tally;
use crate::judge::known::checker::Checker;
use crate::judge::known::found::{Ground, Outcome, Use};
use crate::judge::page::context::{Body, Definition, is_variable};
use crate::judge::page::finding::{Evidence, Finding, Verdict};
use crate::judge::written::names::{bases, is_index_letter};
use crate::language::lexicon::families;

/// Names with which so many times more relations hold than fail are understood.
const MANY: usize = 4;

/// How many of the relations that rest on something came out how.
#[derive(Default)]
struct Outcomes {
    holding: usize,
    refuted: usize,
    unfounded: usize,
}

impl Outcomes {
    fn add(&mut self, outcome: Outcome) {
        match outcome {
            Outcome::Holds => self.holding += 1,
            Outcome::Refuted => self.refuted += 1,
            Outcome::Unfounded => self.unfounded += 1,
            Outcome::Open => {}
        }
    }
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
    pub(in crate::judge) fn rely(
        &mut self,
        tally: &Tally,
        sides: [&Expr; 2],
        number: usize,
        verdict: Verdict,
        wrong: Option<Finding>,
    ) {
        let definitions = tally
            .record
            .definitions
            .iter()
            .map(|(number, _)| &self.context.definitions[*number])
            .filter(|definition| definition.source.is_text() && !gives_number(definition))
            .map(|definition| Ground::Definition(definition.place.formula, definition.head.base.clone()));
        let own = |name: &String| !is_variable(name) && !is_index_letter(name) && !families::is_family(name);
        let names = sides.into_iter().flat_map(bases).filter(own).map(Ground::Name);
        let outcome = match verdict {
            Verdict::Proved | Verdict::Sampled if tally.nonzero > 0 => Outcome::Holds,
            Verdict::Refuted => Outcome::Refuted,
            _ if wrong.is_some() => Outcome::Unfounded,
            _ => Outcome::Open,
        };
        // Only relations of the statement that is judged can be judged again.
        let own = self.uses.partition_point(|one| one.finding < self.findings.len());
        if let Some(again) = self.uses[own..].iter().position(|one| one.finding == number) {
            self.uses.remove(own + again);
        }
        self.uses.push(Use { finding: number, grounds: definitions.chain(names).collect(), outcome, wrong });
    }

    /// Takes back what was refuted on doubtful grounds, and refutes what fails alone among what holds. To be called
    /// after the last statement.
    pub(in crate::judge) fn finish(&mut self) {
        let mut record: BTreeMap<&Ground, Outcomes> = BTreeMap::new();
        for one in &self.uses {
            one.grounds.iter().for_each(|ground| record.entry(ground).or_default().add(one.outcome));
        }
        let doubtful = |ground: &&Ground| {
            let Some(outcomes) = record.get(ground) else { return false };
            let fails = match ground {
                Ground::Definition(..) => outcomes.refuted + outcomes.unfounded > 1,
                Ground::Name(_) => outcomes.unfounded > 0,
            };
            fails && outcomes.holding == 0
        };
        let confirmed = |ground: &Ground| {
            record.get(ground).is_some_and(|outcomes| {
                let failing = outcomes.unfounded + outcomes.refuted;
                let holding = outcomes.holding;
                failing == 1 && holding > 0 || holding >= MANY * failing
            })
        };
        // Without a name of its own it needs a truth next to it.
        let named = |one: &Use| {
            let near = one.wrong.as_ref().is_some_and(|wrong| wrong.suggestion.is_some());
            near || one.grounds.iter().any(|ground| matches!(ground, Ground::Name(_)))
        };
        let founded = |one: &Use| named(one) && !one.grounds.is_empty() && one.grounds.iter().all(confirmed);
        for one in self.uses.iter().filter(|one| founded(one)) {
            let wrong = one.wrong.as_ref().filter(|wrong| wrong.evidence.contains(&Evidence::Names));
            if let (Some(wrong), Some(finding)) = (wrong, self.findings.get_mut(one.finding)) {
                *finding = wrong.clone();
            }
        }
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
