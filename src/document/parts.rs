//! The parts of a text that somebody who writes into it must know: queries, formulas, comments, code.
//!
//! **Definition.** A *part* is a stretch of the file that is not plain words: a query `{{ … }}`, a
//! formula with its signs, a comment, a fenced block of code. Code spans, tags, addresses, front matter
//! and indented code are parts of nobody: nothing in them is a query.
//!
//! **Invariants.** Parts do not overlap and stand in the order of the file. They are found by the same
//! walk as the formulas of [`super::document`], in linear time.

use std::ops::Range;

use super::collect::Collector;
use super::{blocks, tex_parts};
use crate::document::{Places, Style};
use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic};

/// What a part is.
#[derive(Clone, Debug, PartialEq)]
pub enum PartKind {
    /// `{{ … }}` among words, or `\polarform{…}`; its text stands between the braces.
    Query,
    /// A formula; its text is all of it, with the signs.
    Formula {
        /// How it is set.
        style: Style,
        /// The bytes of its text between the signs.
        inner: Range<usize>,
    },
    /// `<!-- … -->`; its text stands between the marks.
    Comment,
    /// A fenced block, or `\begin{polarform}…\end{polarform}`; its text is the code.
    Code {
        /// What is said of it after the opening fence, or in brackets after `\begin{polarform}`.
        info: Span,
        /// Whether it has an end.
        closed: bool,
    },
    /// A file that is read here (LaTeX); its text is the name.
    Include,
    /// A package that is loaded (LaTeX); its text is the name.
    Package,
}

/// A part of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// What it is.
    pub kind: PartKind,
    /// All its bytes, with signs and marks.
    pub span: Span,
    /// Its text; the marks of enclosing blocks are blanked.
    pub text: String,
    /// From bytes of the text to bytes of the file.
    pub places: Places,
    /// What a further line of the enclosing blocks begins with: the marks of quotations, the
    /// indentation of list items.
    pub margin: String,
}

/// The parts found so far, and the margin where the walk stands.
#[derive(Debug, Default)]
pub(super) struct Layout {
    pub(super) parts: Vec<Part>,
    pub(super) margin: String,
}

impl Layout {
    /// Notes a part whose text stands in the file as it is, from `start` on, apart from blanks.
    pub(super) fn push(&mut self, kind: PartKind, span: Span, text: &str, start: usize) {
        let part = Part {
            kind,
            span,
            text: text.to_owned(),
            places: Places::plain(start),
            margin: self.margin.clone(),
        };
        self.parts.push(part);
    }
}

/// Where the options stand in the words after an opening fence, if the block is one of queries.
///
/// ```
/// use polarform::document::options_in;
/// assert_eq!(options_in("polarform steps=true"), Some(9..20));
/// assert_eq!(options_in("{.polarform hide}"), Some(11..16));
/// assert_eq!(options_in("python"), None);
/// ```
pub fn options_in(info: &str) -> Option<std::ops::Range<usize>> {
    let end = info.trim_end().len();
    let (mut start, mut end) = (info.len() - info.trim_start().len(), end);
    let braced = |start: usize, end: usize| start < end && info.piece(start..end).starts_with('{');
    if braced(start, end) && info.piece(start..end).ends_with('}') {
        (start, end) = (start + 1, end - 1);
        start += info.piece(start..end).len() - info.piece(start..end).trim_start().len();
        start += usize::from(info.piece(start..end).starts_with('.'));
    }
    let rest = info.get(start..end)?.strip_prefix("polarform")?;
    let separate = rest.is_empty() || rest.starts_with([' ', '\t', ',']);
    separate.then_some(end - rest.len()..end)
}

/// The parts of a Markdown text, with the queries that have no end.
///
/// Cost: linear in the length of the text.
///
/// ```
/// use polarform::document::{PartKind, markdown_parts};
/// let (parts, problems) = markdown_parts("Then $F(0) = {{ F(0) }}$ and `{{ x }}` is {{ F(1) }}.\n");
/// assert_eq!((parts.len(), problems.len()), (2, 0));
/// assert!(matches!(parts[0].kind, PartKind::Formula { .. }));
/// assert_eq!((&parts[1].kind, parts[1].text.trim()), (&PartKind::Query, "F(1)"));
/// ```
pub fn markdown_parts(text: &str) -> (Vec<Part>, Vec<Diagnostic>) {
    let mut out = Collector::default();
    out.layout = Some(Layout::default());
    blocks::scan(text, &mut out);
    let parts = out.layout.take().map(|layout| layout.parts).unwrap_or_default();
    let (_, mut problems, _) = out.into_parts();
    problems.retain(|problem| problem.code == Code::UnclosedQuery);
    (parts, problems)
}

/// The block of queries that a comment holds, if it holds nothing else.
pub(super) fn hidden_queries(comment: &str) -> Option<Part> {
    if !comment.trim_start().starts_with(['`', '~']) {
        return None;
    }
    let (mut parts, _) = markdown_parts(comment);
    let part = parts.pop().filter(|_| parts.is_empty())?;
    match &part.kind {
        PartKind::Code { info, closed: true } => options_in(comment.piece(info.range())).map(|_| part),
        _ => None,
    }
}

/// The queries of a LaTeX text, the files it reads and the packages it loads; with what is wrong.
///
/// Queries are `\polarform{…}` and the environment `polarform`; comments and verbatim text are passed
/// over.
///
/// Cost: linear in the length of the text.
pub fn latex_parts(text: &str) -> (Vec<Part>, Vec<Diagnostic>) {
    tex_parts::scan(text)
}

/// What `{{` leads to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Opening {
    /// A query: the bytes between the braces; two bytes more and it ends.
    Query(Range<usize>),
    /// A query without its closing braces.
    Unclosed,
    /// Something else, such as an include of mdBook, or the braces of a formula.
    Other,
}

/// What the `{{` at byte `at` of a text opens.
///
/// A query goes on to the first `}}` outside of further braces and does not reach over a blank line or
/// another `{{`. In a formula a blank must follow the opening braces: `{{n}\choose{k}}` is none.
/// Elsewhere `{{#`, `{{<`, `{{%` and the like belong to other programs.
///
/// Cost: linear in the length of the query; searches that fail do not overlap.
pub fn query_at(text: &str, at: usize, in_formula: bool) -> Opening {
    let from = at + 2;
    let bytes = text.as_bytes();
    let blank = bytes.get(from).is_some_and(u8::is_ascii_whitespace);
    let foreign = || bytes.get(from).is_none_or(|byte| b"#<%!/>&^{}$@".contains(byte));
    if !blank && (in_formula || foreign()) {
        return Opening::Other;
    }
    let missing = if blank && !in_formula { Opening::Unclosed } else { Opening::Other };
    let mut depth = 0_usize;
    let mut at = from;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'\\' => at += 1,
            b'{' if bytes.get(at + 1) == Some(&b'{') => return missing,
            b'{' => depth += 1,
            b'}' if depth > 0 => depth -= 1,
            b'}' if bytes.get(at + 1) == Some(&b'}') => return Opening::Query(from..at),
            b'}' => return missing,
            b'\n' => {
                let line = text.piece(at + 1..);
                if line.split('\n').next().is_none_or(|line| line.trim().is_empty()) {
                    return missing;
                }
            }
            _ => {}
        }
        at += 1;
    }
    missing
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn found(text: &str, in_formula: bool) -> Option<&str> {
        match query_at(text, 0, in_formula) {
            Opening::Query(range) => Some(&text[range]),
            _ => None,
        }
    }

    #[test]
    fn queries_and_other_braces() {
        assert_eq!(found("{{ f(0) }}", true), Some(" f(0) "));
        assert_eq!(found("{{f(0)}}", false), Some("f(0)"));
        assert_eq!(found(r"{{ \frac{1}{2} }}", true), Some(r" \frac{1}{2} "));
        assert_eq!(found(r"{{ \frac{1}{2}}}", true), Some(r" \frac{1}{2}"));
        assert_eq!(found("{{ a\nb }}", false), Some(" a\nb "));
        for other in [r"{{n}\choose{k}}", "{{f(0)}}", "{{ a}+b}}"] {
            assert_eq!(found(other, true), None, "{other}");
        }
        for other in ["{{#include a.md}}", "{{< video x >}}", "{{{ x }}}", "{{", "{{}}"] {
            assert_eq!(query_at(other, 0, false), Opening::Other, "{other}");
        }
        for open in ["{{ f(0)", "{{ f(0) }", "{{ a\n\nb }}", "{{ a {{ b }}"] {
            assert_eq!(query_at(open, 0, false), Opening::Unclosed, "{open}");
        }
    }

    #[test]
    fn parts_know_their_margin_and_their_text() {
        let text = "> - so $$a\n>   = {{ b }}$$\n>   ```polarform x=y\n>   f(0)\n>\n>     1\n>   ```\n";
        let parts = markdown_parts(text).0;
        assert_eq!(parts.len(), 2, "{parts:?}");
        assert_eq!((parts[0].margin.as_str(), parts[1].margin.as_str()), (">   ", ">   "));
        assert_eq!(parts[0].text, "$$a\n    = {{ b }}$$");
        let PartKind::Code { info, closed: true } = &parts[1].kind else { panic!("{parts:?}") };
        assert_eq!(&text[info.range()], "polarform x=y");
        assert_eq!(parts[1].text, "f(0)\n\n  1\n");
        let one = parts[1].places.span(Span::new(8, 9));
        assert_eq!(&text[one.range()], "1");
        assert!(
            text[parts[1].span.range()].starts_with("```p") && text[parts[1].span.range()].ends_with("```")
        );
    }

    #[test]
    fn what_is_no_part() {
        let text = "---\na: {{ x }}\n---\n`{{ x }}`, \\{{ x }}, <a href=\"{{ x }}\">\n\n    {{ x }}\n";
        assert_eq!(markdown_parts(text).0, []);
        let text = "~~~\n{{ x }} $y$\n~~~\n<!-- a\n\n{{ x }} -->\n";
        let kinds: Vec<PartKind> = markdown_parts(text).0.into_iter().map(|part| part.kind).collect();
        assert!(matches!(kinds[..], [PartKind::Code { .. }, PartKind::Comment]), "{kinds:?}");
    }

    #[test]
    fn code_without_end() {
        let parts = markdown_parts("> ```polarform\n> a\n\nb\n\n```polarform\nc").0;
        let closed = |part: &Part| matches!(part.kind, PartKind::Code { closed: true, .. });
        assert_eq!(parts.iter().map(closed).collect::<Vec<_>>(), [false, false]);
        assert_eq!(parts[1].text, "c\n");
    }

    proptest! {
        #[test]
        fn parts_are_in_order(text in "([ >`$\\\\{}\n!<ax1-]|\\{\\{ |```polarform\n|<!--|-->|é){0,60}") {
            for parts in [markdown_parts(&text).0, latex_parts(&text).0] {
                let mut at = 0;
                for part in parts {
                    prop_assert!(part.span.start >= at && part.span.end <= text.len(), "{part:?}");
                    prop_assert!(text.get(part.span.range()).is_some(), "{part:?}");
                    at = part.span.end;
                }
            }
        }
    }
}
