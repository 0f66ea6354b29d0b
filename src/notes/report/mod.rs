//! Reports about checked files: text for a terminal, JSON, SARIF 2.1.0 and a page of HTML.
//!
//! Each report is a pure function of the findings. Wherever a place is given, lines and columns
//! count from 1; columns count characters, in SARIF UTF-16 code units (the specification's
//! default). A formula without a relation *states nothing*: it is listed where everything is
//! listed, but it counts neither as judged nor as not judged.

mod excerpt;
mod html;
mod json;
mod listing;
mod mathml;
mod place;
mod sarif;
mod table;
mod terminal;
#[cfg(test)]
mod tests;

use std::ops::AddAssign;

pub use html::render_html;
pub use json::render_json;
pub use listing::{render_listing, render_listing_json};
pub use sarif::render_sarif;
pub use table::render_summary;
pub use terminal::{TextOptions, render_text};

use crate::judge::finding::{FileReport, Finding, Verdict};

/// How many findings there are of each kind.
///
/// ```
/// use polarform::judge::finding::{FileReport, Verdict};
/// use polarform::notes::report::Tally;
/// use polarform::source::SourceFile;
/// let report = FileReport {
///     file: SourceFile::new("empty.md", ""),
///     findings: Vec::new(),
///     problems: Vec::new(),
/// };
/// let tally = Tally::of(&[report]);
/// assert_eq!((tally.statements(), tally.count(Verdict::Refuted)), (0, 0));
/// assert_eq!(tally.percent_judged(), None);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    counts: [usize; Verdict::ALL.len()],
    silent: usize,
    warnings: usize,
    problems: usize,
}

impl Tally {
    /// Counts the findings of some files. Cost: linear.
    pub fn of(reports: &[FileReport]) -> Self {
        let mut tally = Tally::default();
        for report in reports {
            tally.problems += report.problems.len();
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

    /// Findings that state something.
    pub fn statements(&self) -> usize {
        self.counts.iter().sum()
    }

    /// Findings whose verdict says whether they hold.
    pub fn judged(&self) -> usize {
        Verdict::ALL.iter().filter(|verdict| verdict.is_judged()).map(|&verdict| self.count(verdict)).sum()
    }

    /// The share of statements judged in percent, rounded down; `None` if there is no statement.
    pub fn percent_judged(&self) -> Option<usize> {
        (self.judged() * 100).checked_div(self.statements())
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
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Tally) {
        for (count, more) in self.counts.iter_mut().zip(other.counts) {
            *count += more;
        }
        self.silent += other.silent;
        self.warnings += other.warnings;
        self.problems += other.problems;
    }
}

/// Whether there is something to judge: a relation, or a formula of which nobody knows.
fn states_something(finding: &Finding) -> bool {
    finding.relation > 0 || !matches!(finding.verdict, Verdict::Undecided | Verdict::Definition)
}

/// `1 warning`, `2 warnings`.
fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
