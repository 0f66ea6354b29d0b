//! Findings for code hosts and editors: SARIF 2.1.0 (OASIS, Static Analysis Results Interchange
//! Format, 2020): one run, a rule for each kind of finding, columns in UTF-16 code units.

use serde_json::{Value, json};

use super::json::pretty;
use super::place::{Locator, Region};
use super::{Rule, fingerprints, message};
use crate::formula::source::Pieces;
use crate::judge::page::finding::FileReport;
use crate::language::diagnostic::{Code, Diagnostic, Severity};

/// Where the pages about this version stand.
const PAGES: &str =
    concat!("https://docs.rs/", env!("CARGO_PKG_NAME"), "/", env!("CARGO_PKG_VERSION"), "/polarform/notes/");

impl Rule {
    fn level(self) -> &'static str {
        match self {
            Rule::Refuted => "error",
            Rule::Suspicious => "warning",
            Rule::Undecided | Rule::Unread => "note",
        }
    }

    fn summary(self) -> &'static str {
        match self {
            Rule::Refuted => "The formula is wrong; a counterexample is given.",
            Rule::Suspicious => "The formula is unusual and may be wrong.",
            Rule::Undecided => "The formula was read, but a condition or a definition is missing.",
            Rule::Unread => "The formula is outside what polarform reads.",
        }
    }

    fn help(self) -> &'static str {
        match self {
            Rule::Refuted => {
                "Compare the two sides at the counterexample. If the formula is meant, say what the text leaves open in a declaration, or write 'polarform: ignore' before it."
            }
            Rule::Suspicious => {
                "Nothing is proved to be wrong; look at the index, name or bound that is named."
            }
            Rule::Undecided => {
                "Declare what is missing: <!-- polarform: … --> in Markdown, % polarform: … in LaTeX."
            }
            Rule::Unread => {
                "The reason names the construct. Another notation may be read; docs/notes.md lists them."
            }
        }
    }

    fn to_json(self) -> Value {
        json!({
            "id": self.id(),
            "name": self.id(),
            "shortDescription": {"text": self.summary()},
            "help": {"text": self.help()},
            "helpUri": PAGES,
            "defaultConfiguration": {"level": self.level()},
        })
    }
}

/// The report as SARIF 2.1.0. What is proved, sampled or defined, and what states nothing, is no
/// result. A suggestion is a fix that replaces the region of its result. Problems of the files
/// themselves are notifications.
pub fn render_sarif(reports: &[FileReport]) -> String {
    let mut results = Vec::new();
    let mut notifications = Vec::new();
    let mut codes: Vec<Code> = Vec::new();
    for (index, report) in reports.iter().enumerate() {
        let artifact = json!({"uri": uri(report.file.name()), "index": index});
        let mut locator = Locator::new(&report.file);
        for (finding, fingerprint) in report.findings.iter().zip(fingerprints(report)) {
            let region = region(locator.region(finding.span));
            if let Some((rule, message)) = message(finding) {
                let mut result = result(rule, &message, &artifact, &region, &fingerprint);
                if let Some(suggestion) = &finding.suggestion {
                    result["fixes"] = json!([fix(suggestion, report.file.name(), &artifact, &region)]);
                }
                results.push(result);
            }
            if let Some(warning) = &finding.warning {
                results.push(result(Rule::Suspicious, warning, &artifact, &region, &fingerprint));
            }
        }
        for problem in &report.problems {
            codes.push(problem.code);
            notifications.push(notification(problem, &mut locator, &artifact));
        }
    }
    codes.sort();
    codes.dedup();
    let kinds: Vec<Value> = codes
        .into_iter()
        .map(|code| json!({"id": code.id(), "shortDescription": {"text": code.title()}}))
        .collect();
    let failed = reports.iter().flat_map(|r| &r.problems).any(|problem| problem.severity == Severity::Error);
    let artifacts: Vec<Value> =
        reports.iter().map(|report| json!({"location": {"uri": uri(report.file.name())}})).collect();
    pretty(&json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": {"driver": {
                "name": "polarform",
                "version": env!("CARGO_PKG_VERSION"),
                "semanticVersion": env!("CARGO_PKG_VERSION"),
                "rules": Rule::ALL.map(Rule::to_json),
                "notifications": kinds,
            }},
            "columnKind": "utf16CodeUnits",
            "artifacts": artifacts,
            "invocations": [{
                "executionSuccessful": !failed,
                "toolExecutionNotifications": notifications,
            }],
            "results": results,
        }],
    }))
}

fn result(rule: Rule, message: &str, artifact: &Value, region: &Value, fingerprint: &str) -> Value {
    json!({
        "ruleId": rule.id(),
        "ruleIndex": rule as usize,
        "level": rule.level(),
        "message": {"text": message},
        "locations": [{"physicalLocation": {"artifactLocation": artifact, "region": region}}],
        "partialFingerprints": {"polarformFormula/v1": format!("{}:{fingerprint}", rule.id())},
    })
}

fn region(region: Region) -> Value {
    json!({
        "startLine": region.start.line,
        "startColumn": region.start.unit,
        "endLine": region.end.line,
        "endColumn": region.end.unit,
    })
}

fn fix(suggestion: &str, name: &str, artifact: &Value, region: &Value) -> Value {
    // In a notebook the formula stands within a string of JSON.
    let text = if name.ends_with(".ipynb") {
        let quoted = Value::from(suggestion).to_string();
        quoted.piece(1..quoted.len() - 1).to_owned()
    } else {
        suggestion.to_owned()
    };
    json!({
        "description": {"text": "the likely repair"},
        "artifactChanges": [{
            "artifactLocation": artifact,
            "replacements": [{"deletedRegion": region, "insertedContent": {"text": text}}],
        }],
    })
}

fn notification(problem: &Diagnostic, locator: &mut Locator, artifact: &Value) -> Value {
    let level = match problem.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    };
    let mut place = json!({"artifactLocation": artifact});
    if let Some(span) = problem.span {
        place["region"] = region(locator.region(span));
    }
    let mut text = problem.message.clone();
    for more in problem.reason.iter().chain(&problem.hints) {
        text.push('\n');
        text.push_str(more);
    }
    json!({
        "descriptor": {"id": problem.code.id()},
        "level": level,
        "message": {"text": text},
        "locations": [{"physicalLocation": place}],
    })
}

/// A path as a URI reference (RFC 3986).
fn uri(path: &str) -> String {
    let mut uri = String::new();
    let path = if std::path::MAIN_SEPARATOR == '\\' { path.replace('\\', "/") } else { path.to_owned() };
    if path.starts_with('/') {
        uri.push_str("file://");
    } else if path.split('/').next().is_some_and(|first| first.contains(':')) {
        // A colon in the first segment would be taken for a scheme; on Windows it is a drive.
        uri.push_str(if std::path::MAIN_SEPARATOR == '\\' { "file:///" } else { "./" });
    }
    for byte in path.bytes() {
        match byte {
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => {
                uri.push(byte.into())
            }
            _ => uri.push_str(&format!("%{byte:02X}")),
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::uri;

    #[test]
    fn paths_become_uris() {
        assert_eq!(uri("notes/第 1.md"), "notes/%E7%AC%AC%201.md");
        assert_eq!(uri("/tmp/a.md"), "file:///tmp/a.md");
        assert_eq!(uri("50%.md"), "50%25.md");
    }
}
