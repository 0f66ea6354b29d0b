//! Findings for programs.

use serde_json::{Map, Value, json};

use super::place::Locator;
use super::{Tally, fingerprints, states_something};
use crate::judge::page::finding::{FileReport, Finding, Verdict};
use crate::language::diagnostic;

/// The report as JSON:
/// `{"files": [{"file", "formulas": […], "problems": […]}], "summary": {verdict: count}}`.
///
/// A formula is `{"line", "column", "end_line", "end_column", "start", "end", "latex", "relation", "kind",
/// "verdict", "reason", "witness", "evidence", "suggestion", "instances", "warning", "reading", "notes",
/// "fingerprint"}`; what is absent is null, and `evidence` says why a refuted one is certain to be wrong. `start` and `end` are bytes of the file, the columns count characters, and the end stands
/// just behind the formula. `kind` is `claim`, `definition` or `none`. The summary counts all entries by verdict,
/// also those of formulas that state nothing, and then `claims`, `definitions` and `unseen`.
pub fn render_json(reports: &[FileReport]) -> String {
    let files: Vec<Value> = reports.iter().map(file).collect();
    let mut summary: Map<String, Value> = Verdict::ALL
        .into_iter()
        .map(|verdict| {
            let count: usize = reports.iter().map(|report| report.count(verdict)).sum();
            (verdict.word().to_owned(), count.into())
        })
        .collect();
    let tally = Tally::of(reports);
    for (name, count) in
        [("claims", tally.claims()), ("definitions", tally.definitions()), ("unseen", tally.unseen())]
    {
        summary.insert(name.to_owned(), count.into());
    }
    pretty(&json!({"files": files, "summary": summary}))
}

fn file(report: &FileReport) -> Value {
    let mut locator = Locator::new(&report.file);
    let formulas: Vec<Value> = report
        .findings
        .iter()
        .zip(fingerprints(report))
        .map(|(finding, fingerprint)| formula(finding, &fingerprint, &mut locator))
        .collect();
    json!({"file": report.file.name(), "formulas": formulas, "problems": problems(report)})
}

pub(super) fn problems(report: &FileReport) -> Vec<Value> {
    report.problems.iter().map(|problem| diagnostic::render_json(problem, &report.file)).collect()
}

fn formula(finding: &Finding, fingerprint: &str, locator: &mut Locator) -> Value {
    let region = locator.region(finding.span);
    json!({
        "line": region.start.line,
        "column": region.start.column,
        "end_line": region.last_line(),
        "end_column": region.end.column,
        "start": finding.span.start,
        "end": finding.span.end,
        "latex": finding.latex,
        "relation": finding.relation,
        "kind": kind(finding),
        "verdict": finding.verdict.word(),
        "reason": finding.reason,
        "witness": finding.witness,
        "evidence": finding.evidence.iter().map(|evidence| evidence.words()).collect::<Vec<_>>(),
        "suggestion": finding.suggestion,
        "instances": finding.instances,
        "warning": finding.warning,
        "reading": finding.reading,
        "notes": finding.notes,
        "fingerprint": fingerprint,
    })
}

fn kind(finding: &Finding) -> &'static str {
    match finding.verdict {
        _ if !states_something(finding) => "none",
        Verdict::Definition => "definition",
        _ => "claim",
    }
}

/// Indented, with a line end.
pub(super) fn pretty(value: &Value) -> String {
    format!("{value:#}\n")
}
