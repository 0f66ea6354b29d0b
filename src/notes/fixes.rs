//! Suggestions put into the file: the smallest pieces of text that turn the one formula into the other.
//!
//! **Definition.** A *fix* is a stretch of the file and the text that takes its place. Those of a finding are
//! found by comparing the tree of the relation as it stands there with that of the suggestion: what is the same
//! in both keeps its bytes, its spaces and its macros.
//!
//! **Invariants.** The text with the fixes in it reads as the suggestion does, which is verified by reading it;
//! otherwise a larger piece is replaced, in the end the whole relation. Fixes do not overlap.

use crate::document::{Document, Formula, Item, Places, Style};
use crate::formula::Expr;
use crate::formula::source::{Pieces, Span, replaced};
use crate::judge::page::finding::{FileReport, Finding, Verdict};
use crate::language::{latex, syntax, write};

/// A replacement of some bytes of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// What goes.
    pub span: Span,
    /// What stands there instead.
    pub text: String,
}

/// The fixes of a file: those of its refuted relations for which there is a suggestion, in the order of the
/// file. Of two that overlap the second is left out; it may come up again when the file is checked anew.
///
/// Cost: linear in the findings; for each, its tree is read a few times.
pub fn fixes(document: &Document, report: &FileReport) -> Vec<Fix> {
    let mut all: Vec<(Span, Vec<Fix>)> = Vec::new();
    let wrong = report.findings.iter().filter(|finding| finding.verdict == Verdict::Refuted);
    for finding in wrong {
        let Some(suggestion) = &finding.suggestion else { continue };
        let found = match document.escaped {
            true => {
                let shifted = |fix: Fix| Fix { span: fix.span.shifted(finding.span.start), ..fix };
                in_string(report.file.slice(finding.span), suggestion).into_iter().map(shifted).collect()
            }
            false => {
                let written = Written::of(document, finding);
                let found = pieces(&written, suggestion);
                found
                    .into_iter()
                    .map(|fix| Fix { span: written.in_file(fix.span), ..fix })
                    .collect::<Vec<_>>()
            }
        };
        if let (Some(first), Some(last)) = (found.first(), found.last()) {
            all.push((first.span.to(last.span), found));
        }
    }
    all.sort_by_key(|(span, _)| (span.start, span.end));
    let mut end = 0;
    let mut kept = Vec::new();
    for (span, found) in all {
        if span.start >= end {
            end = span.end;
            kept.extend(found);
        }
    }
    kept
}

/// Writes a suggestion as the author would: what is the same in the formula keeps its macros and spaces. Where only the
/// whole could be replaced, and in plain notation, it stays as it is.
pub(super) fn in_own_words(document: &Document, finding: &mut Finding) {
    let Some(suggestion) = finding.suggestion.as_ref().filter(|_| finding.verdict == Verdict::Refuted) else {
        return;
    };
    if document.escaped {
        return;
    }
    let written = Written::of(document, finding);
    if matches!(written.notation, Notation::Plain) {
        return;
    }
    let whole = written.in_file(Span::new(0, written.text.len()));
    let source = document.file.slice(whole);
    let found = pieces(&written, suggestion);
    if found.iter().any(|fix| fix.span.start > 0 || fix.span.end < written.text.len()) {
        let place = |span: Span| {
            let span = written.in_file(span);
            Span::new(span.start - whole.start, span.end - whole.start)
        };
        let found: Vec<Fix> = found.into_iter().map(|fix| Fix { span: place(fix.span), ..fix }).collect();
        let text = without_columns(&fixed(source, &found));
        finding.suggestion = Some(text.split_whitespace().collect::<Vec<_>>().join(" "));
    }
}

/// The text with the fixes in it.
pub fn fixed(text: &str, fixes: &[Fix]) -> String {
    replaced(text, fixes.iter().map(|fix| (fix.span, fix.text.as_str())))
}

/// A relation as it is read: with its macros written out, and with all of the braces that it begins or ends in.
struct Written<'a> {
    text: &'a str,
    notation: Notation,
    /// Where the text begins in that of the formula, or in the file if it is none of one formula.
    start: usize,
    places: Option<&'a Places>,
}

impl<'a> Written<'a> {
    fn of(document: &'a Document, finding: &Finding) -> Self {
        let within = |formula: &&'a Formula| {
            formula.span.start <= finding.span.start && finding.span.end <= formula.span.end
        };
        let mut formulas = document.items.iter().filter_map(|item| match item {
            Item::Formula(formula) => Some(formula),
            _ => None,
        });
        let formula = formulas.rfind(within);
        let plain = formula.is_some_and(|formula| formula.style == Style::Plain);
        let notation = if plain { Notation::Plain } else { Notation::Latex };
        let found = formula.and_then(|formula| {
            let inside = |at: &usize| {
                let place = formula.in_file(Span::new(*at, at + 1));
                finding.span.start <= place.start && place.end <= finding.span.end
            };
            let bytes = || 0..formula.text.len();
            let part = Span::new(bytes().find(inside)?, bytes().rfind(inside)? + 1);
            formula.text.get(part.range())?;
            let part = with_braces(&formula.text, part);
            Some((formula.text.get(part.range())?, part.start, &formula.places))
        });
        match found {
            Some((text, start, places)) => Written { text, notation, start, places: Some(places) },
            None => {
                let text = document.file.slice(finding.span);
                Written { text, notation, start: finding.span.start, places: None }
            }
        }
    }

    /// A text that stands for itself.
    fn alone(text: &'a str, notation: Notation) -> Self {
        Written { text, notation, start: 0, places: None }
    }

    fn in_file(&self, span: Span) -> Span {
        let span = span.shifted(self.start);
        self.places.map_or(span, |places| places.span(span))
    }

    /// Whether a part of the text stands so in the file, or is all that a macro stands for.
    fn is_whole(&self, span: Span) -> bool {
        let own = self.in_file(span);
        let ends = |at: usize| match at < self.text.len() {
            true => self.in_file(Span::new(at, at + 1)).start >= own.end,
            false => true,
        };
        let begins = |at: usize| match at.checked_sub(1) {
            Some(before) => self.in_file(Span::new(before, at)).end <= own.start,
            None => true,
        };
        self.places.is_none() || begins(span.start) && ends(span.end)
    }
}

/// A part of a text and as much around it as its braces need.
fn with_braces(text: &str, part: Span) -> Span {
    let (mut depth, mut least) = (0_i32, 0_i32);
    let mut escaped = false;
    for c in text.piece(part.range()).chars() {
        match c {
            '{' if !escaped => depth += 1,
            '}' if !escaped => depth -= 1,
            _ => {}
        }
        escaped = c == '\\' && !escaped;
        least = least.min(depth);
    }
    let (mut start, mut end) = (part.start, part.end);
    for _ in 0..-least {
        match text.piece(..start).trim_end().strip_suffix('{') {
            Some(before) => start = before.len(),
            None => return part,
        }
    }
    for _ in 0..depth - least {
        let rest = text.piece(end..);
        match rest.trim_start().strip_prefix('}') {
            Some(after) => end = text.len() - after.len(),
            None => return part,
        }
    }
    Span::new(start, end)
}

#[derive(Clone, Copy)]
enum Notation {
    Latex,
    Plain,
}

impl Notation {
    fn read(self, text: &str) -> Option<Expr> {
        match self {
            // Signs between the cells and rows of a table are no part of the relation.
            Notation::Latex => latex::read(&without_columns(text)).ok(),
            Notation::Plain => syntax::parse(text).ok(),
        }
    }

    fn write(self, expr: &Expr) -> String {
        match self {
            Notation::Latex => write::latex(expr),
            Notation::Plain => write::text(expr),
        }
    }
}

/// The text with blanks in place of `&` and `\\`.
fn without_columns(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        match c {
            '&' => out.push(' '),
            '\\' if rest.peek() == Some(&'\\') => {
                rest.next();
                out.push_str("  ");
            }
            '\\' => {
                out.push(c);
                out.extend(rest.next());
            }
            _ => out.push(c),
        }
    }
    out
}

/// What is replaced in the source of a relation.
fn pieces(written: &Written, suggestion: &str) -> Vec<Fix> {
    let Written { text: source, notation, .. } = *written;
    let whole = |text: String| vec![Fix { span: Span::new(0, source.len()), text }];
    let Ok(wanted) = latex::read(suggestion) else { return whole(suggestion.to_owned()) };
    let plain = matches!(notation, Notation::Plain);
    let Some(given) = notation.read(source) else {
        // In words LaTeX would not be read.
        return if plain { Vec::new() } else { whole(suggestion.to_owned()) };
    };
    let is_right = |found: &[Fix]| {
        let read = notation.read(&fixed(source, found));
        read.is_some_and(|read| read.same_as(&wanted))
    };
    let rows =
        |span: Span| source.piece(span.range()).contains(r"\\") || source.piece(span.range()).contains('&');
    // From the smallest pieces to the sides.
    let deepest = depth(&given).min(MAX_DEPTH);
    for limit in (0..=deepest).rev() {
        let mut places = Vec::new();
        differences(&given, &wanted, limit, &mut places);
        if places.is_empty() || places.iter().any(|(span, _)| rows(*span)) {
            continue;
        }
        for brace in [false, true] {
            let text = |span: Span, expr: &Expr| {
                let mut text = notation.write(expr);
                if !source.piece(span.range()).contains(' ') {
                    text = text.replace(" + ", "+").replace(" - ", "-");
                }
                if !plain && counts(source).is_empty() {
                    counts(&text).into_iter().rev().for_each(|at| text.replace_range(at..at + 1, ""));
                }
                let brace = brace || !plain && signs(&text).len() > 1 && is_bare_argument(source, span.start);
                match (brace, plain) {
                    (false, _) => text,
                    (true, false) => format!("{{{text}}}"),
                    (true, true) => format!("({text})"),
                }
            };
            let mut found: Vec<Fix> =
                places.iter().map(|(span, expr)| Fix { span: *span, text: text(*span, expr) }).collect();
            found.sort_by_key(|fix| fix.span.start);
            let apart = found.windows(2).all(|pair| pair[0].span.end <= pair[1].span.start);
            let is_whole = |found: &[Fix]| found.iter().all(|fix| written.is_whole(fix.span));
            if apart && is_right(&found) {
                let small: Vec<Fix> = found.iter().map(|fix| trimmed(source, fix)).collect();
                if is_whole(&small) && is_right(&small) {
                    return small;
                }
                if is_whole(&found) {
                    return found;
                }
            }
        }
    }
    if plain { Vec::new() } else { whole(suggestion.to_owned()) }
}

/// Where a space stands between a number and the letter that it counts: 2 x.
fn counts(text: &str) -> Vec<usize> {
    let bytes = text.as_bytes();
    let counts = |at: &usize| {
        let before = at.checked_sub(1).is_some_and(|before| bytes[before].is_ascii_digit());
        let after = bytes.get(at + 1).is_some_and(u8::is_ascii_alphabetic);
        bytes[*at] == b' ' && before && after
    };
    (0..bytes.len()).filter(counts).collect()
}

/// Whether an argument of `\frac`, `\binom` or `\sqrt` without braces begins at `at`: TeX takes one sign only.
fn is_bare_argument(source: &str, at: usize) -> bool {
    let takes = |before: &str| {
        let before = before.trim_end();
        let letters = before.bytes().rev().take_while(u8::is_ascii_alphabetic).count();
        let (rest, name) = before.split_at(before.len() - letters);
        rest.ends_with('\\') && (name.ends_with("frac") || name.ends_with("binom") || name == "sqrt")
    };
    let before = source.piece(..at);
    let first = signs(before).last().map(|sign| before.piece(..sign.start));
    takes(before) || first.is_some_and(takes)
}

/// The fix without the signs that its text and what it replaces have in common at both ends, whatever the spaces
/// between them: of `2b_1 - b_0` and `2 b_1 + b_0` only the sign is left.
fn trimmed(source: &str, fix: &Fix) -> Fix {
    let old = source.piece(fix.span.range());
    let (before, after) = (signs(old), signs(&fix.text));
    let text =
        |signs: &[Span], all: &str, at: usize| signs.get(at).map(|sign| all.piece(sign.range()).to_owned());
    let same = |i: usize, j: usize| text(&before, old, i) == text(&after, &fix.text, j);
    let most = before.len().min(after.len());
    let head = (0..most).take_while(|&at| same(at, at)).count();
    let tail = (0..most - head).take_while(|&at| same(before.len() - 1 - at, after.len() - 1 - at)).count();
    let middle = |signs: &[Span], len: usize| {
        let start = if head == 0 { 0 } else { signs[head - 1].end };
        let end = if tail == 0 { len } else { signs[signs.len() - tail].start };
        Span::new(start, end)
    };
    let (gone, new) = (middle(&before, old.len()), middle(&after, fix.text.len()));
    Fix { span: gone.shifted(fix.span.start), text: fix.text.piece(new.range()).to_owned() }
}

/// The commands and other signs of a formula, without the spaces.
fn signs(text: &str) -> Vec<Span> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(c) = text.piece(at..).chars().next() {
        let letters = text.piece(at + c.len_utf8()..).bytes().take_while(u8::is_ascii_alphabetic).count();
        let len = c.len_utf8() + if c == '\\' { letters } else { 0 };
        if !c.is_whitespace() {
            found.push(Span::new(at, at + len));
        }
        at += len;
    }
    found
}

/// Deeper trees are not compared to their leaves.
const MAX_DEPTH: usize = 40;

fn depth(expr: &Expr) -> usize {
    let mut deepest = 0;
    expr.for_each_child(&mut |child| deepest = deepest.max(1 + depth(child)));
    deepest
}

/// The places where the trees differ, not deeper than `limit`, with what should stand there.
fn differences(given: &Expr, wanted: &Expr, limit: usize, found: &mut Vec<(Span, Expr)>) {
    if given.same_as(wanted) {
        return;
    }
    let (mut left, mut right) = (Vec::new(), Vec::new());
    given.for_each_child(&mut |child| left.push(child));
    wanted.for_each_child(&mut |child| right.push(child));
    let inner = |child: &Expr| {
        !child.span.is_empty() && given.span.start <= child.span.start && child.span.end <= given.span.end
    };
    let changed = || left.iter().zip(&right).filter(|(a, b)| !a.same_as(b));
    let descends = limit > 0
        && left.len() == right.len()
        && changed().all(|(a, _)| inner(a))
        && same_head(given, wanted);
    if descends {
        for (a, b) in left.iter().zip(&right) {
            differences(a, b, limit - 1, found);
        }
    } else {
        found.push((given.span, wanted.clone()));
    }
}

/// Whether two trees are the same but for their children.
fn same_head(a: &Expr, b: &Expr) -> bool {
    let bare = |expr: &Expr| {
        let mut expr = expr.clone();
        expr.for_each_child_mut(&mut |child| *child = Expr::int(0));
        expr
    };
    bare(a).same_as(&bare(b))
}

/// The same for a relation that stands in a string of a notebook: all of it is written anew.
fn in_string(source: &str, suggestion: &str) -> Vec<Fix> {
    let Ok(text) = serde_json::from_str::<String>(&format!("\"{source}\"")) else { return Vec::new() };
    let quoted = |text: &str| {
        let quoted = serde_json::Value::from(text).to_string();
        quoted.piece(1..quoted.len() - 1).to_owned()
    };
    // Only what is written as it would be written anew.
    if quoted(&text) != source {
        return Vec::new();
    }
    let fix = Fix {
        span: Span::new(0, source.len()),
        text: quoted(&fixed(&text, &pieces(&Written::alone(&text, Notation::Latex), suggestion))),
    };
    vec![fix]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after(source: &str, suggestion: &str) -> String {
        fixed(source, &pieces(&Written::alone(source, Notation::Latex), suggestion))
    }

    #[test]
    fn the_smallest_piece_is_replaced() {
        for (source, suggestion, wanted) in [
            (r"F(t)  =  t^2+ 2 t", r"F(t) = t^2 + 3 t", r"F(t)  =  t^2+ 3 t"),
            (r"2^{10} = 1025", r"2^{10} = 1024", r"2^{10} = 1024"),
            (r"x &= \tfrac{1}{2}  y", r"x = \frac{1}{3} y", r"x &= \tfrac{1}{3}  y"),
            (r"b_0\,+b_1 = b_2", r"b_0 + b_1 = b_{12}", r"b_0\,+b_1 = b_{12}"),
            (r"x^2 = y", r"x^{10} = y", r"x^{10} = y"),
            (r"d = b_2 -  2b_1 - b_0", r"d = b_2 - 2 b_1 + b_0", r"d = b_2 -  2b_1 + b_0"),
            (r"c = a^2 + ab+b^2", r"c = a^2 + 2 a b + b^2", r"c = a^2 + 2ab+b^2"),
            (r"c = \frac 1 n", r"c = \frac{1}{(n + 1)}", r"c = \frac 1 {(n+1)}"),
            (r"c = a\alpha + b", r"c = a\beta + b", r"c = a\beta + b"),
        ] {
            let read = |text: &str| latex::read(&without_columns(text)).unwrap();
            let fixed = after(source, suggestion);
            assert!(read(&fixed).same_as(&read(suggestion)), "{fixed}");
            assert_eq!(fixed, wanted);
        }
    }

    #[test]
    fn in_plain_notation_nothing_of_latex_is_written() {
        let source = "F(t) = t^2 + 2t";
        let found = pieces(&Written::alone(source, Notation::Plain), r"F(t) = \frac{1}{3} t^2");
        let text = fixed(source, &found);
        assert!(!text.contains('\\') && text.starts_with("F(t) = "), "{text}");
    }

    #[test]
    fn strings_of_notebooks() {
        let found = in_string(r"\\sigma = 1", r"\sigma = 2");
        assert_eq!(found[0].text, r"\\sigma = 2");
        assert_eq!(in_string("a = 1\",\n \"b", "a = 2"), []);
    }
}
