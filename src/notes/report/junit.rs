//! Findings as the results of tests: the XML of JUnit, which GitLab, Jenkins, Azure and others show.
//!
//! There is no standard; this keeps to what the schema of Jenkins' xUnit plugin (`junit-10.xsd`) asks for, with
//! `file` and `line` as GitLab reads them.

use maud::{Markup, PreEscaped, html};

use super::place::Locator;
use super::{Rule, message, states_something};
use crate::judge::page::finding::{FileReport, Finding, Verdict};
use crate::language::diagnostic::{Diagnostic, Severity};

/// The report as JUnit XML: a suite for each file, a test for each claim. A refuted claim fails, one that is undecided
/// or unread is skipped, a problem of a file is an error; definitions are no tests.
///
/// Cost: linear.
pub fn render_junit(reports: &[FileReport]) -> String {
    let suites: Vec<Suite> = reports.iter().map(suite).collect();
    let sum = |count: fn(&Suite) -> usize| suites.iter().map(count).sum::<usize>();
    let body = html! {
        testsuites name="polarform" tests=(sum(|s| s.tests)) failures=(sum(|s| s.failures)) errors=(sum(|s| s.errors)) skipped=(sum(|s| s.skipped)) {
            @for suite in &suites {
                "\n"
                testsuite name=(suite.name) tests=(suite.tests) failures=(suite.failures) errors=(suite.errors) skipped=(suite.skipped) {
                    (suite.cases)
                    "\n"
                }
            }
            "\n"
        }
    };
    format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}\n", body.into_string())
}

/// The tests of a file, counted.
struct Suite {
    name: String,
    tests: usize,
    failures: usize,
    errors: usize,
    skipped: usize,
    cases: Markup,
}

fn suite(report: &FileReport) -> Suite {
    let name = allowed(report.file.name());
    let mut locator = Locator::new(&report.file);
    let mut suite =
        Suite { name, tests: 0, failures: 0, errors: 0, skipped: 0, cases: PreEscaped(String::new()) };
    for problem in &report.problems {
        let line = problem.span.map(|span| locator.region(span).start.line);
        suite.problem(problem, line);
    }
    let claims = report.findings.iter();
    for finding in claims.filter(|f| states_something(f) && f.verdict != Verdict::Definition) {
        let start = locator.region(finding.span).start;
        suite.claim(finding, start.line, start.column);
    }
    suite
}

impl Suite {
    fn add(&mut self, title: &str, line: Option<usize>, outcome: Markup) {
        self.tests += 1;
        let case = html! {
            "\n"
            testcase classname=(self.name) name=(allowed(title)) file=(self.name) line=[line] { (outcome) }
        };
        self.cases.0.push_str(&case.0);
    }

    fn problem(&mut self, problem: &Diagnostic, line: Option<usize>) {
        let text = [problem.message.as_str()].into_iter().chain(problem.hints.iter().map(String::as_str));
        let text = allowed(&text.collect::<Vec<_>>().join("\n"));
        let code = problem.code.id();
        let outcome = match problem.severity {
            Severity::Error => {
                self.errors += 1;
                html! { error type=(code) message=(allowed(&problem.message)) { (text) } }
            }
            Severity::Warning | Severity::Note => {
                self.skipped += 1;
                html! { skipped message=(text) {} }
            }
        };
        let place = line.map_or_else(String::new, |line| format!("line {line}: "));
        self.add(&format!("{place}{code} {}", problem.code.title()), line, outcome);
    }

    fn claim(&mut self, finding: &Finding, line: usize, column: usize) {
        let said = message(finding);
        let outcome = match &said {
            None => html! {},
            Some((rule, text)) => {
                let first = allowed(text.lines().next().unwrap_or_default());
                if *rule == Rule::Refuted {
                    self.failures += 1;
                    html! { failure type=(rule.id()) message=(first) { (allowed(text)) } }
                } else {
                    self.skipped += 1;
                    html! { skipped message=(first) {} }
                }
            }
        };
        let warning = finding.warning.as_deref().map(allowed);
        let outcome = html! {
            (outcome)
            @if let Some(warning) = warning { system-out { (warning) } }
        };
        let formula = finding.latex.split_whitespace().collect::<Vec<_>>().join(" ");
        self.add(&format!("{line}:{column} {formula}"), Some(line), outcome);
    }
}

/// What XML 1.0 lets stand in a text.
fn allowed(text: &str) -> String {
    let is_allowed = |c: char| {
        matches!(c, '\t' | '\n' | '\r' | ' '..='\u{fffd}' | '\u{10000}'..)
            && !matches!(c, '\u{7f}'..='\u{9f}')
    };
    text.chars().map(|c| if is_allowed(c) { c } else { '\u{fffd}' }).collect()
}
