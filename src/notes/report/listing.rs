//! What was found in a file and how it was read.

use serde_json::{Value, json};

use super::counted;
use super::json::{pretty, problems};
use super::place::Locator;
use super::terminal::{BOLD, painted};
use crate::judge::page::finding::{FileReport, Finding, Verdict};
use crate::language::diagnostic::harmless;

/// The formulas of some files as they were read, printed anew as LaTeX; with what could not be read.
pub fn render_listing(reports: &[FileReport], color: bool) -> String {
    let mut out = String::new();
    for report in reports {
        let unread = report.count(Verdict::Unread);
        let entries = counted(report.findings.len(), "entry", "entries");
        let mut head = format!("{}: {entries}", harmless(report.file.name()));
        if unread > 0 {
            head.push_str(&format!(", {unread} not read"));
        }
        out.push_str(&painted(&head, BOLD, color));
        out.push('\n');
        let mut locator = Locator::new(&report.file);
        for finding in &report.findings {
            let start = locator.region(finding.span).start;
            let place = format!("{}:{}", start.line, start.column);
            out.push_str(&format!("  {place:<8} {}\n", entry(finding)));
        }
    }
    out
}

fn entry(finding: &Finding) -> String {
    if finding.verdict == Verdict::Unread {
        let reason = finding.reason.as_deref().unwrap_or("outside what polarform reads");
        return format!("not read: {}  ({})", words(&finding.latex), words(reason));
    }
    words(&finding.reading)
}

/// All of a text on one line.
fn words(text: &str) -> String {
    harmless(&text.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// The same as JSON: `{"files": [{"file", "formulas": [{"line", "column", "end_line", "latex",
/// "relation", "reading", "reason", "notes"}], "problems": […]}]}`; `reading` is null for what
/// could not be read, `reason` says why.
pub fn render_listing_json(reports: &[FileReport]) -> String {
    let files: Vec<Value> = reports
        .iter()
        .map(|report| {
            let mut locator = Locator::new(&report.file);
            let formulas: Vec<Value> = report
                .findings
                .iter()
                .map(|finding| {
                    let region = locator.region(finding.span);
                    let read = finding.verdict != Verdict::Unread;
                    json!({
                        "line": region.start.line,
                        "column": region.start.column,
                        "end_line": region.last_line(),
                        "latex": finding.latex,
                        "relation": finding.relation,
                        "reading": read.then_some(&finding.reading),
                        "reason": finding.reason,
                        "notes": finding.notes,
                    })
                })
                .collect();
            json!({"file": report.file.name(), "formulas": formulas, "problems": problems(report)})
        })
        .collect();
    pretty(&json!({"files": files}))
}
