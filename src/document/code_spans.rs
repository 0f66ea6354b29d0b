//! Code spans of Markdown, and what pages write in them that is no code.

use super::inline::NEARBY;
use super::signs::inline_end;
use crate::document::Style;
use crate::formula::source::{Pieces, Span};

/// What a page means by code spans, besides code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct InCode {
    /// Two backquotes enclose formulas, as in the manuals of Julia.
    pub(super) double_backquotes: bool,
    /// What `` `$…$` `` is.
    pub(super) dollars: Dollars,
}

/// What stands between dollars in code spans.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Dollars {
    /// Code: formulas stand outside of code, and the page may show how they are written.
    #[default]
    Code,
    /// None stand outside, and there are few.
    Unclear,
    /// All formulas of the page stand in code spans.
    Formulas,
}

/// What the page means by its code spans.
///
/// Cost: linear.
pub(super) fn in_code(text: &str) -> InCode {
    InCode { double_backquotes: double_backquotes(text), dollars: dollars(text) }
}

/// The code spans of a text: what stands between the backquotes, and how many there are on each side.
fn code_spans(text: &str) -> impl Iterator<Item = (Span, usize)> {
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            let open = at + text.piece(at..).find('`')?;
            let run = run_of(text, open, b'`');
            at = open + run;
            if let Some(end) = closing_run(text, at, run) {
                let inner = Span::new(at, end - run);
                at = end;
                return Some((inner, run));
            }
        }
    })
}

/// Whether somewhere in the text formulas of LaTeX stand in double backquotes.
fn double_backquotes(text: &str) -> bool {
    let signs = ["](@ref", "](@id", "```@", "```jldoctest"];
    if !text.contains("``") {
        return false;
    }
    signs.iter().any(|sign| text.contains(sign))
        || code_spans(text).any(|(inner, run)| {
            let content = text.piece(inner.range());
            run == 2 && is_latex(content) && !content.contains('`')
        })
}

fn is_latex(content: &str) -> bool {
    let mut signs = content.match_indices('\\').map(|(sign, _)| content.piece(sign + 1..));
    let command = signs.any(|name| name.starts_with(|c: char| c.is_ascii_alphabetic()));
    command || content.contains("_{") || content.contains("^{")
}

/// Whether all formulas of the page stand in code spans: three or more, one of them of LaTeX.
fn dollars(text: &str) -> Dollars {
    if !text.contains("`$") {
        return Dollars::Code;
    }
    let mut formulas = 0;
    let mut latex = false;
    let mut said = 0;
    for (inner, run) in code_spans(text) {
        if outside(text.piece(said..inner.start - run)) {
            return Dollars::Code;
        }
        said = inner.end + run;
        let content = text.piece(inner.range());
        let formula = dollars_in_code(content).is_some() && run == 1;
        formulas += usize::from(formula);
        latex |= formula && is_latex(content);
    }
    match formulas {
        _ if outside(text.piece(said..)) => Dollars::Code,
        3.. if latex => Dollars::Formulas,
        2.. => Dollars::Unclear,
        _ => Dollars::Code,
    }
}

/// Whether formulas stand in a text without code.
fn outside(text: &str) -> bool {
    text.contains("$$") || text.match_indices('$').any(|(at, _)| inline_end(text, at).is_some())
}

/// The formula that a code span consists of, with its dollars: `$a = b$`, `$$a = b$$`. A price, a variable of a
/// shell and the like are none.
pub(super) fn dollars_in_code(content: &str) -> Option<(Style, Span)> {
    let text = content.trim();
    let signs = if text.starts_with("$$") { 2 } else { 1 };
    let open = "$$".piece(..signs);
    let inner = text.strip_prefix(open)?.strip_suffix(open)?;
    let letter = inner.chars().filter(|c| c.is_alphanumeric()).count() == 1;
    let formula = letter || inner.contains(['\\', '^', '_', '=', '+', '-', '<', '>', '(']);
    if inner.trim().is_empty() || inner.contains('$') || !formula {
        return None;
    }
    let start = content.len() - content.trim_start().len() + signs;
    let style = if signs == 2 { Style::Display } else { Style::Inline };
    Some((style, Span::new(start, start + inner.len())))
}

/// The end of the code span that opens at `at`, or of the backquotes there.
pub(super) fn code_span(text: &str, at: usize) -> usize {
    let run = run_of(text, at, b'`');
    closing_run(text, at + run, run).unwrap_or(at + run)
}

pub(super) fn run_of(text: &str, at: usize, mark: u8) -> usize {
    text.as_bytes()[at..].iter().take_while(|&&byte| byte == mark).count()
}

/// The end of the next run of exactly `run` backquotes.
pub(super) fn closing_run(text: &str, from: usize, run: usize) -> Option<usize> {
    let mut at = from;
    while at < from + NEARBY {
        at += text.piece(at..).bytes().position(|byte| byte == b'`')?;
        let len = run_of(text, at, b'`');
        at += len;
        if len == run {
            return Some(at);
        }
    }
    None
}
