//! How the definitions of a page fared: what was misread makes more than one relation fail.
//!
//! **Rule.** A relation is not refuted with a definition with which another relation of the page fails as well, and
//! none holds: the definition was misread, or it is the one that is wrong.

use std::collections::BTreeMap;

use super::check::Checker;
use super::context::{Body, Definition, Source};
use super::finding::{Finding, Verdict};
use super::names::bases;
use super::tally::Tally;
use super::verdict::UNFOUNDED;

/// A definition of the page: the number of its formula, and its name.
type Key = (usize, String);

/// A relation that was judged with definitions.
pub(super) struct Use {
    finding: usize,
    definitions: Vec<Key>,
    fails: bool,
    holds: bool,
}

/// n = 3 is not misread.
fn gives_number(definition: &Definition) -> bool {
    match &definition.body {
        Body::Formula(body) => bases(body).is_empty(),
        Body::Value(value) => value.as_rational().is_some(),
    }
}

impl Checker {
    /// Keeps with which definitions a relation was judged; `number` is that of the finding on the page.
    pub(super) fn rely(&mut self, tally: &Tally, number: usize, finding: &Finding) {
        let definitions: Vec<Key> = tally
            .record
            .definitions
            .iter()
            .map(|(number, _)| &self.context.definitions[*number])
            .filter(|definition| definition.source == Source::Page && !gives_number(definition))
            .map(|definition| (definition.place.formula, definition.head.base.clone()))
            .collect();
        if definitions.is_empty() {
            return;
        }
        let holds = matches!(finding.verdict, Verdict::Proved | Verdict::Sampled) && tally.nonzero > 0;
        let fails = finding.verdict == Verdict::Refuted || finding.reason.as_deref() == Some(UNFOUNDED);
        self.uses.retain(|one| one.finding != number);
        self.uses.push(Use { finding: number, definitions, fails, holds });
    }

    /// Takes back what was refuted with a definition that nothing confirms and that makes others fail, too. To be
    /// called after the last statement.
    pub fn finish(&mut self) {
        let mut record: BTreeMap<&Key, (usize, usize)> = BTreeMap::new();
        for one in &self.uses {
            for key in &one.definitions {
                let (holds, fails) = record.entry(key).or_default();
                *holds += usize::from(one.holds);
                *fails += usize::from(one.fails);
            }
        }
        let doubtful = |key: &&Key| record.get(key).is_some_and(|(holds, fails)| *holds == 0 && *fails > 1);
        for one in &self.uses {
            let Some((_, name)) = one.definitions.iter().find(doubtful) else { continue };
            let Some(finding) = self.findings.get_mut(one.finding) else { continue };
            if finding.verdict == Verdict::Refuted {
                *finding = Finding {
                    verdict: Verdict::Undecided,
                    reason: Some(format!(
                        "all that is said with {name} fails: its definition may be wrong, or was misread"
                    )),
                    warning: finding.reason.take(),
                    suggestion: None,
                    evidence: Vec::new(),
                    ..finding.clone()
                };
            }
        }
    }
}
