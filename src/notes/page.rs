//! A page: its statements, judged in their order.

use super::statement::statements;
use crate::budget::Limits;
use crate::document::Document;
use crate::judge::page::finding::{FileReport, Finding, Verdict, blank, of_side};
use crate::judge::page::statement::Said;

/// What to check with.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The limits of each formula.
    pub limits: Limits,
    /// Declarations in the query language, known before the first line.
    pub context: Option<String>,
}

/// Checks every formula of a document. When the limits are interrupted it ends with what it has found so far.
///
/// Cost: the statements are tried on up to some hundred small instances each; each chain has the
/// limits of the options.
pub fn check_document(document: &Document, options: &Options) -> FileReport {
    super::again::run(document, options, None, &mut |_| {})
}

/// How every formula of a document is read, without judging it.
pub fn listing(document: &Document) -> Vec<Finding> {
    let mut findings = Vec::new();
    for statement in statements(document) {
        match statement.said {
            Said::Chain(chain) => {
                for at in 0..chain.relations.len() {
                    findings.push(blank(&chain, at));
                }
            }
            Said::Condition(side) => findings.push(of_side(&side, Verdict::Definition, 1)),
            Said::Bare(side, problems) => {
                let mut finding = of_side(&side, Verdict::Undecided, 0);
                if side.is_unread() {
                    finding.verdict = Verdict::Unread;
                    finding.reason = problems.first().map(|problem| problem.message.clone());
                }
                findings.push(finding);
            }
            Said::Object(_)
            | Said::Contact(_)
            | Said::Triangles(..)
            | Said::Declaration(..)
            | Said::Queries(..) => {}
        }
    }
    findings
}
