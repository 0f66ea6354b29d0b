//! Reports about checked files: text for a terminal, JSON, SARIF 2.1.0, annotations of GitHub, JUnit and a page of
//! HTML.
//!
//! Each report is a pure function of the findings. Wherever a place is given, lines and columns
//! count from 1; columns count characters, in SARIF UTF-16 code units (the specification's
//! default). A *claim* is what can be right or wrong; definitions and conditions are counted apart, and a
//! formula without a relation *states nothing*. What is refuted comes first; what was not read is listed.

mod excerpt;
mod fingerprint;
mod github;
mod html;
mod json;
mod junit;
mod listing;
mod mathml;
mod place;
mod policy;
mod sarif;
mod table;
mod terminal;
#[cfg(test)]
mod tests;

use std::ops::AddAssign;

pub use super::fixes::{Fix, fixed, fixes};
pub use fingerprint::{Rule, fingerprints};
pub use github::render_github;
pub use html::render_html;
pub use json::render_json;
pub use junit::render_junit;
pub use listing::{render_listing, render_listing_json};
pub use mathml::mathml_within;
pub use sarif::render_sarif;
pub use table::render_summary;
pub use terminal::{TextOptions, render_text};

use crate::judge::page::finding::{FileReport, Finding, Verdict};
use crate::language::diagnostic::{Code, Diagnostic};

/// How many findings there are of each kind.
///
/// ```
/// use polarform::judge::finding::{FileReport, Verdict};
/// use polarform::notes::report::Tally;
/// use polarform::source::SourceFile;
/// let report = FileReport::new(SourceFile::new("empty.md", ""), Vec::new(), Vec::new());
/// let tally = Tally::of(&[report]);
/// assert_eq!((tally.claims(), tally.definitions(), tally.count(Verdict::Refuted)), (0, 0, 0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    counts: [usize; Verdict::ALL.len()],
    silent: usize,
    warnings: usize,
    problems: usize,
    unseen: usize,
}

impl Tally {
    /// Counts the findings of some files. Cost: linear.
    pub fn of(reports: &[FileReport]) -> Self {
        let mut tally = Tally::default();
        for report in reports {
            let unseen = report.problems.iter().filter(|problem| is_unseen(problem)).count();
            tally.unseen += unseen;
            tally.problems += report.problems.len() - unseen;
            for finding in &report.findings {
                tally.warnings += usize::from(finding.warning.is_some());
                if states_something(finding) {
                    tally.counts[finding.verdict as usize] += 1;
                } else {
                    tally.silent += 1;
                }
            }
        }
        tally
    }

    /// Findings with this verdict, without formulas that state nothing.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.counts[verdict as usize]
    }

    /// Findings that state something: claims, definitions and conditions.
    pub fn statements(&self) -> usize {
        self.counts.iter().sum()
    }

    /// Findings that can be right or wrong, also those that could not be decided or read.
    pub fn claims(&self) -> usize {
        self.statements() - self.definitions()
    }

    /// Findings that introduce a name, a value or a condition.
    pub fn definitions(&self) -> usize {
        self.count(Verdict::Definition)
    }

    /// Formulas that state nothing.
    pub fn silent(&self) -> usize {
        self.silent
    }

    /// Findings with a warning.
    pub fn warnings(&self) -> usize {
        self.warnings
    }

    /// Problems with the files themselves.
    pub fn problems(&self) -> usize {
        self.problems
    }

    /// Whether there are formulas and none of them could be read.
    pub fn is_all_unread(&self) -> bool {
        let unread = self.count(Verdict::Unread);
        unread + self.unseen > 0 && self.statements() + self.silent == unread
    }

    /// Places that look like formulas and were not read.
    pub fn unseen(&self) -> usize {
        self.unseen
    }

    /// All of it in one line: `3 claims: 1 refuted, 2 proved; 1 warning`.
    pub fn words(&self) -> String {
        let words = std::iter::once(verdict_words(self)).chain(further_words(self));
        words.collect::<Vec<_>>().join("; ")
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Tally) {
        for (count, more) in self.counts.iter_mut().zip(other.counts) {
            *count += more;
        }
        self.silent += other.silent;
        self.warnings += other.warnings;
        self.problems += other.problems;
        self.unseen += other.unseen;
    }
}

/// Whether there is something to judge: a relation, or a formula of which nobody knows.
fn states_something(finding: &Finding) -> bool {
    finding.relation > 0 || !matches!(finding.verdict, Verdict::Undecided | Verdict::Definition)
}

/// Whether the problem is a formula that was not seen as one.
fn is_unseen(problem: &Diagnostic) -> bool {
    matches!(problem.code, Code::UnseenFormula | Code::UnclosedFormula)
}

/// The claims and what came of them, the same words in every report: `3 claims: 1 refuted, 2 proved`.
fn verdict_words(tally: &Tally) -> String {
    if tally.statements() == 0 {
        let unread = tally.problems() + tally.unseen() > 0;
        return if unread { "nothing could be read" } else { "nothing to judge" }.to_owned();
    }
    let claims = counted(tally.claims(), "claim", "claims");
    let parts: Vec<String> = CLAIMS
        .into_iter()
        .filter(|&verdict| tally.count(verdict) > 0)
        .map(|verdict| format!("{} {}", tally.count(verdict), verdict.word()))
        .collect();
    if parts.is_empty() { claims } else { format!("{claims}: {}", parts.join(", ")) }
}

/// What else there is, in words: `5 definitions and conditions`, `1 warning`.
fn further_words(tally: &Tally) -> Vec<String> {
    let kinds = [
        (tally.definitions(), "definition or condition", "definitions and conditions"),
        (tally.silent(), "formula without a statement", "formulas without a statement"),
        (tally.warnings(), "warning", "warnings"),
        (
            tally.unseen(),
            "place that looks like a formula and was not read",
            "places that look like formulas and were not read",
        ),
        (tally.problems(), "problem with the file itself", "problems with the files themselves"),
    ];
    let some = kinds.into_iter().filter(|(count, ..)| *count > 0);
    some.map(|(count, one, many)| counted(count, one, many)).collect()
}

/// The rule that a verdict falls under, if any, and what is said: the reason, the counterexample and the suggestion,
/// each on a line.
pub fn message(finding: &Finding) -> Option<(Rule, String)> {
    let rule = Rule::of(finding)?;
    let otherwise = match rule {
        Rule::Refuted | Rule::Suspicious => "the two sides differ",
        Rule::Undecided => "a condition or a definition is missing",
        Rule::Unread => "outside what polarform reads",
    };
    let mut message = format!("{}: {}", rule.id(), finding.reason.as_deref().unwrap_or(otherwise));
    for (label, text) in [("counterexample", &finding.witness), ("suggestion", &finding.suggestion)] {
        if let Some(text) = text {
            message.push_str(&format!("\n{label}: {text}"));
        }
    }
    Some((rule, message))
}

/// The verdicts of claims in the order in which a person asks for them.
const CLAIMS: [Verdict; 5] =
    [Verdict::Refuted, Verdict::Proved, Verdict::Sampled, Verdict::Undecided, Verdict::Unread];

/// `1 warning`, `2 warnings`.
fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
