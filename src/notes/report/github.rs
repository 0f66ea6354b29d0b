//! Findings as annotations of GitHub: *workflow commands*, lines on standard output that GitHub Actions shows beside
//! the lines of a change.
//!
//! Reference: GitHub, *Workflow commands for GitHub Actions*; what must be escaped tells its toolkit
//! (`packages/core/src/command.ts`).

use super::place::{Locator, Region};
use super::{Rule, Tally, message, verdict_words};
use crate::judge::page::finding::FileReport;
use crate::language::diagnostic::Severity;

/// The report as workflow commands: an error for what is refuted, a warning for what is suspicious and, if `verbose`,
/// a notice for each claim that is undecided or unread; then one line with the numbers. Problems of the files
/// themselves are told, too.
///
/// Cost: linear.
pub fn render_github(reports: &[FileReport], verbose: bool) -> String {
    let mut out = String::new();
    for report in reports {
        let name = report.file.name();
        let mut locator = Locator::new(&report.file);
        for finding in &report.findings {
            let region = Some(locator.region(finding.span));
            if let Some((rule, text)) = message(finding)
                && (verbose || rule == Rule::Refuted)
            {
                let level = if rule == Rule::Refuted { "error" } else { "notice" };
                out.push_str(&command(level, name, region, rule.id(), &text));
            }
            if let Some(warning) = &finding.warning {
                out.push_str(&command("warning", name, region, Rule::Suspicious.id(), warning));
            }
        }
        for problem in &report.problems {
            let level = match problem.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
                Severity::Note => "notice",
            };
            let region = problem.span.map(|span| locator.region(span));
            let lines = [problem.message.clone()].into_iter().chain(problem.hints.iter().cloned());
            let text = lines.collect::<Vec<_>>().join("\n");
            out.push_str(&command(level, name, region, problem.code.id(), &text));
        }
    }
    out.push_str(&format!("polarform: {}\n", verdict_words(&Tally::of(reports))));
    out
}

fn command(level: &str, file: &str, region: Option<Region>, title: &str, text: &str) -> String {
    // Names of files in the repository have no dot before them.
    let file = file.strip_prefix("./").unwrap_or(file);
    let mut properties = format!("file={}", property(file));
    if let Some(region) = region {
        let (first, last) = (region.start.line, region.last_line());
        properties.push_str(&format!(",line={first},endLine={last}"));
        // Columns belong to one line.
        if first == region.end.line {
            let (start, end) = (region.start.column, region.end.column);
            properties.push_str(&format!(",col={start},endColumn={end}"));
        }
    }
    format!("::{level} {properties},title={}::{}\n", property(&format!("polarform: {title}")), data(text))
}

fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}
