//! Findings as a page for a browser: one file, no network, formulas as MathML.
//!
//! Everything that comes from the notes is escaped by maud; [`mathml`] escapes its own text.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::mathml::mathml;
use super::place::Locator;
use super::policy::policy;
use super::{Tally, states_something};
use crate::judge::page::finding::{FileReport, Finding, Verdict};
use crate::language::diagnostic::Severity;

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// What a reader looks for first comes first.
const ORDER: [Verdict; 6] = [
    Verdict::Refuted,
    Verdict::Undecided,
    Verdict::Unread,
    Verdict::Proved,
    Verdict::Sampled,
    Verdict::Definition,
];

/// The report as one page of HTML: for each file its formulas in order with their verdicts, and
/// buttons that show only some of them.
pub fn render_html(reports: &[FileReport]) -> String {
    let tally = Tally::of(reports);
    let title = tally.words();
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(policy(STYLE, SCRIPT));
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                header {
                    h1 { (title) }
                    div class="bar" {
                        @for verdict in ORDER {
                            @let count = tally.count(verdict);
                            @if count > 0 {
                                span class={ (verdict.word()) "-text" } style={ "flex:" (count) }
                                    title={ (count) " " (verdict.word()) } {}
                            }
                        }
                    }
                    div class="filters" hidden { (filters(&tally)) }
                }
                @for (number, report) in reports.iter().enumerate() {
                    (section(number + 1, report, reports.len() > 1))
                }
                script { (PreEscaped(SCRIPT)) }
            }
        }
    };
    let mut text = page.into_string();
    text.push('\n');
    text
}

/// A button for everything and for each kind of finding that occurs.
fn filters(tally: &Tally) -> Markup {
    let button = |kind: &str, label: &str, count: usize, pressed: bool| {
        html! {
            button type="button" data-show=(kind) aria-pressed=(pressed) class={ (kind) "-text" } {
                (label) " " (count)
            }
        }
    };
    // The page opens on what somebody should look at.
    let counts = ORDER.map(|verdict| (verdict.word(), tally.count(verdict)));
    let urgent = [counts[0], ("suspicious", tally.warnings()), counts[1], counts[2]];
    let first = urgent.into_iter().find(|(_, count)| *count > 0).map_or("all", |(kind, _)| kind);
    html! {
        @for (word, count) in counts {
            @if count > 0 { (button(word, word, count, word == first)) }
        }
        @if tally.warnings() > 0 {
            (button("suspicious", "with a warning", tally.warnings(), first == "suspicious"))
        }
        (button("all", "all", tally.statements() + tally.silent(), first == "all"))
        @if tally.silent() > 0 { (button("silent", "without a statement", tally.silent(), false)) }
    }
}

/// The findings of a file; its own summary, if there are `several`.
fn section(number: usize, report: &FileReport, several: bool) -> Markup {
    let tally = Tally::of(std::slice::from_ref(report));
    let mut locator = Locator::new(&report.file);
    html! {
        section {
            h2 { (clean(report.file.name())) }
            @if several { p class="faint" { (tally.words()) } }
            @for problem in &report.problems {
                p class=[(problem.severity == Severity::Error).then_some("problem")] {
                    @if let Some(span) = problem.span {
                        "line " (locator.region(span).start.line) ": "
                    }
                    (clean(&problem.message))
                    @for more in problem.reason.iter().chain(&problem.hints) { "; " (clean(more)) }
                }
            }
            @for (place, finding) in report.findings.iter().enumerate() {
                (self::finding(&format!("f{number}-{}", place + 1), finding, &mut locator))
            }
        }
    }
}

fn finding(id: &str, finding: &Finding, locator: &mut Locator) -> Markup {
    let silent = !states_something(finding);
    let kind = if silent { "silent" } else { finding.verdict.word() };
    let badge = if silent { "no statement" } else { kind };
    let region = locator.region(finding.span);
    let (first, last) = (region.start.line, region.last_line());
    let warned = finding.warning.is_some();
    html! {
        article id=(id) class={ "finding " (kind) @if warned { " warned" } }
            data-kinds={ (kind) @if warned { " suspicious" } } {
            div class="formula" { (formula(&finding.latex)) }
            div {
                p {
                    span class="badge" { (badge) } " "
                    a class="line faint" href={ "#" (id) } {
                        @if first == last { "line " (first) } @else { "lines " (first) "–" (last) }
                    }
                    @if let Some(reason) = &finding.reason { " " (clean(reason)) }
                }
                (remarks(finding))
            }
            details {
                summary { "source" }
                pre class="source" { (clean(&finding.latex)) }
                @if finding.verdict != Verdict::Unread && !finding.reading.is_empty() {
                    "read as"
                    pre class="source" { (clean(&finding.reading)) }
                }
            }
        }
    }
}

fn remarks(finding: &Finding) -> Markup {
    let silent = [&finding.witness, &finding.suggestion, &finding.instances, &finding.warning]
        .into_iter()
        .all(Option::is_none);
    if silent && finding.notes.is_empty() {
        return html! {};
    }
    let remark = |label: &str, text: &str| html! { dt { (label) } dd { (clean(text)) } };
    html! {
        dl {
            @if let Some(witness) = &finding.witness { (remark("counterexample", witness)) }
            @if let Some(suggestion) = &finding.suggestion {
                dt { "suggestion" }
                dd {
                    @if let Some(math) = mathml(&clean(suggestion)) { div class="formula" { (PreEscaped(math)) } }
                    code class="copied" { (clean(suggestion)) } " "
                    button type="button" class="copy" hidden { "copy" }
                }
            }
            @if let Some(instances) = &finding.instances { (remark("tried", instances)) }
            @for evidence in &finding.evidence { (remark("certain because", evidence.words())) }
            @if let Some(warning) = &finding.warning {
                dt class="suspicious-text" { "warning" } dd { (clean(warning)) }
            }
            @for note in &finding.notes { (remark("assumed", note)) }
        }
    }
}

fn formula(latex: &str) -> Markup {
    let latex = clean(latex);
    match mathml(&latex) {
        Some(math) => PreEscaped(math),
        None => html! { code { (latex) } },
    }
}

/// The text without characters that HTML does not allow.
fn clean(text: &str) -> String {
    text.chars()
        .filter(|&c| c != '\r')
        .map(|c| if c.is_control() && !matches!(c, '\n' | '\t') { '\u{fffd}' } else { c })
        .collect()
}
