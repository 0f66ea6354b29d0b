//! Findings for programs.

use serde_json::{Map, Value, json};

use super::place::Locator;
use crate::judge::finding::{FileReport, Finding, Verdict};
use crate::language::diagnostic;

/// The report as JSON:
/// `{"files": [{"file", "formulas": […], "problems": […]}], "summary": {verdict: count}}`.
///
/// A formula is `{"line", "column", "end_line", "latex", "relation", "verdict", "reason",
/// "witness", "suggestion", "instances", "warning", "reading", "notes"}`; what is absent is null.
/// The summary counts all entries, also those of formulas that state nothing.
pub fn render_json(reports: &[FileReport]) -> String {
    let files: Vec<Value> = reports.iter().map(file).collect();
    let summary: Map<String, Value> = Verdict::ALL
        .into_iter()
        .map(|verdict| {
            let count: usize = reports.iter().map(|report| report.count(verdict)).sum();
            (verdict.word().to_owned(), count.into())
        })
        .collect();
    pretty(&json!({"files": files, "summary": summary}))
}

fn file(report: &FileReport) -> Value {
    let mut locator = Locator::new(&report.file);
    let formulas: Vec<Value> = report.findings.iter().map(|finding| formula(finding, &mut locator)).collect();
    json!({"file": report.file.name(), "formulas": formulas, "problems": problems(report)})
}

pub(super) fn problems(report: &FileReport) -> Vec<Value> {
    report.problems.iter().map(|problem| diagnostic::render_json(problem, &report.file)).collect()
}

fn formula(finding: &Finding, locator: &mut Locator) -> Value {
    let region = locator.region(finding.span);
    json!({
        "line": region.start.line,
        "column": region.start.column,
        "end_line": region.last_line(),
        "latex": finding.latex,
        "relation": finding.relation,
        "verdict": finding.verdict.word(),
        "reason": finding.reason,
        "witness": finding.witness,
        "suggestion": finding.suggestion,
        "instances": finding.instances,
        "warning": finding.warning,
        "reading": finding.reading,
        "notes": finding.notes,
    })
}

/// Indented, with a line end.
pub(super) fn pretty(value: &Value) -> String {
    format!("{value:#}\n")
}
