//! Findings for a person at a terminal: what is wrong with a caret under it, then the numbers.

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet, normalize_untrusted_str};
use unicode_width::UnicodeWidthStr;

use super::excerpt::{Excerpt, fitting};
use super::place::Locator;
use super::table::render_summary;
use crate::formula::source::SourceFile;
use crate::judge::page::finding::{FileReport, Finding, Verdict};
use crate::language::diagnostic::{harmless, shortened, with_column};

const RED: &str = "\x1b[1;31m";
const GREEN: &str = "\x1b[32m";
const YELLOW: &str = "\x1b[33m";
const BLUE: &str = "\x1b[34m";
const MAGENTA: &str = "\x1b[35m";
pub(super) const BOLD: &str = "\x1b[1m";
const FAINT: &str = "\x1b[2m";
const PLAIN: &str = "\x1b[0m";

/// Formulas are shown on one line of at most this many columns.
const FORMULA: usize = 64;

/// How to write for a terminal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TextOptions {
    /// With colors.
    pub color: bool,
    /// A line for every finding, not only for those a person should look at.
    pub verbose: bool,
    /// Only what a person should look at: no numbers, nothing of what was not read.
    pub quiet: bool,
}

/// The report for a terminal: a snippet for each refuted or suspicious finding, then a summary.
/// Problems of the files themselves are only counted; [`crate::language::diagnostic::render`] shows them.
/// Cost: linear in the findings shown and, once, in the file.
///
/// ```
/// use polarform::judge::finding::{FileReport, Finding, Verdict};
/// use polarform::notes::report::{TextOptions, render_text};
/// use polarform::source::{SourceFile, Span};
/// let wrong = Finding {
///     span: Span::new(1, 10),
///     mark: Span::new(9, 10),
///     latex: "2 + 2 = 5".to_owned(),
///     reading: "2 + 2 = 5".to_owned(),
///     relation: 1,
///     verdict: Verdict::Refuted,
///     reason: Some("the left side is 4".to_owned()),
///     witness: None,
///     suggestion: Some("2 + 2 = 4".to_owned()),
///     instances: None,
///     warning: None,
///     evidence: Vec::new(),
///     determined: false,
///     notes: Vec::new(),
/// };
/// let file = SourceFile::new("sums.md", "$2 + 2 = 5$");
/// let report = FileReport::new(file, vec![wrong], Vec::new());
/// let text = render_text(&[report], TextOptions::default());
/// assert!(text.starts_with("refuted: the left side is 4\n --> sums.md:1:10\n"));
/// ```
pub fn render_text(reports: &[FileReport], options: TextOptions) -> String {
    let mut out = String::new();
    for report in reports {
        if options.verbose && !report.findings.is_empty() {
            lines(&mut out, report, options.color);
            out.push('\n');
        }
        let mut locator = Locator::new(&report.file);
        let mut shown: Vec<&Finding> =
            report.findings.iter().filter(|finding| finding.is_suspicious()).collect();
        // What is wrong comes first.
        shown.sort_by_key(|finding| finding.verdict != Verdict::Refuted);
        for finding in shown {
            out.push_str(&snippet(finding, &report.file, &mut locator, options.color));
            out.push_str("\n\n");
        }
        if !options.verbose && !options.quiet {
            unread(&mut out, report, options.color);
        }
    }
    if !options.quiet {
        out.push_str(&render_summary(reports, options.color));
    }
    out
}

/// One line for each finding: the verdict, where, the formula, why.
fn lines(out: &mut String, report: &FileReport, color: bool) {
    out.push_str(&painted(&harmless(report.file.name()), BOLD, color));
    out.push('\n');
    let mut locator = Locator::new(&report.file);
    let places: Vec<String> = report
        .findings
        .iter()
        .map(|finding| {
            let start = locator.region(finding.span).start;
            format!("{}:{}", start.line, start.column)
        })
        .collect();
    let widest = places.iter().map(String::len).max().unwrap_or(0);
    for (finding, place) in report.findings.iter().zip(&places) {
        let word = format!("{:<10}", finding.verdict.word());
        let mut line = format!(
            "  {} {place:<widest$}  {}",
            painted(&word, style(finding.verdict), color),
            one_line(&finding.latex, FORMULA)
        );
        let remarks = [&finding.reason, &finding.instances, &finding.warning];
        for remark in remarks.into_iter().flatten() {
            line.push_str("  ");
            line.push_str(&painted(&one_line(remark, 2 * FORMULA), FAINT, color));
        }
        out.push_str(line.trim_end());
        out.push('\n');
    }
}

/// So many formulas that were not read are listed unless all are.
const UNREAD: usize = 10;

/// The formulas of a file that were not read, a line for each.
fn unread(out: &mut String, report: &FileReport, color: bool) {
    let all: Vec<&Finding> =
        report.findings.iter().filter(|finding| finding.verdict == Verdict::Unread).collect();
    if all.is_empty() {
        return;
    }
    let title = format!("{}: not read", harmless(report.file.name()));
    out.push_str(&painted(&title, BOLD, color));
    out.push('\n');
    let mut locator = Locator::new(&report.file);
    for finding in all.iter().take(UNREAD) {
        let start = locator.region(finding.span).start;
        let place = format!("{}:{}", start.line, start.column);
        let reason = finding.reason.as_deref().unwrap_or("outside what polarform reads");
        let line = format!(
            "  {place:<8}  {}  {}",
            one_line(&finding.latex, FORMULA),
            painted(&one_line(reason, 2 * FORMULA), FAINT, color)
        );
        out.push_str(line.trim_end());
        out.push('\n');
    }
    if all.len() > UNREAD {
        out.push_str(&format!("  and {} more; --verbose lists all\n", all.len() - UNREAD));
    }
    out.push('\n');
}

/// The source with a caret, and what is to be said about it.
fn snippet(finding: &Finding, file: &SourceFile, locator: &mut Locator, color: bool) -> String {
    let refuted = finding.verdict == Verdict::Refuted;
    let headline = match (refuted, &finding.reason, &finding.warning) {
        (true, Some(reason), _) => shortened(reason),
        (true, None, _) => "the two sides differ".into(),
        (false, _, Some(warning)) => shortened(warning),
        (false, _, None) => "worth a look".into(),
    };
    let level =
        if refuted { Level::ERROR.with_name("refuted") } else { Level::WARNING.with_name("suspicious") };
    let excerpt = Excerpt::new(file, finding.span, finding.mark);
    let place = locator.place(excerpt.start);
    let source = Snippet::source(excerpt.text.as_str())
        .line_start(place.line.saturating_sub(excerpt.before))
        .path(file.name())
        .fold(false)
        .annotation(AnnotationKind::Primary.span(excerpt.mark.clone()));
    let mut group = Group::with_title(level.primary_title(headline)).element(source);
    let suspicion = finding.warning.as_ref().filter(|_| refuted);
    let reason = finding.reason.as_ref().filter(|_| !refuted);
    let short = |text: &'_ String| normalize_untrusted_str(&shortened(text));
    // A suggestion is there to be copied: all of it.
    let whole = |text: &'_ String| normalize_untrusted_str(text.trim());
    let remarks = [
        (Level::NOTE.with_name(finding.verdict.word()), reason.map(short)),
        (Level::NOTE.with_name("counterexample"), finding.witness.as_ref().map(short)),
        (Level::HELP.with_name("suggestion"), finding.suggestion.as_ref().map(whole)),
        (Level::NOTE.with_name("tried"), finding.instances.as_ref().map(short)),
        (Level::WARNING, suspicion.map(short)),
    ];
    let assumed = finding.notes.iter().map(|note| (Level::NOTE.with_name("assumed"), Some(short(note))));
    for (level, text) in remarks.into_iter().chain(assumed) {
        if let Some(text) = text {
            group = group.element(level.message(text));
        }
    }
    let renderer = if color { Renderer::styled() } else { Renderer::plain() };
    with_column(renderer.render(&[group]), file, (place.line, place.column), excerpt.column)
}

fn style(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Definition => BLUE,
        Verdict::Proved | Verdict::Sampled => GREEN,
        Verdict::Refuted => RED,
        Verdict::Undecided => YELLOW,
        Verdict::Unread => MAGENTA,
    }
}

pub(super) fn painted(text: &str, style: &str, color: bool) -> String {
    if color { format!("{style}{text}{PLAIN}") } else { text.to_owned() }
}

/// The text on one line of limited width.
pub(super) fn one_line(text: &str, columns: usize) -> String {
    let mut line = String::new();
    for word in text.split_whitespace() {
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
        // What comes after cannot be seen; a formula may be very long.
        if line.len() > 16 * columns {
            break;
        }
    }
    let mut line = harmless(&line);
    if line.width() > columns {
        line.truncate(fitting(&line, columns - 1));
        line.push('…');
    }
    line
}
