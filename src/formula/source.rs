//! Where a piece of text comes from: spans, files, line numbers.
//!
//! A [`Span`] is a **half-open** range of bytes, `start..end`, the only kind of
//! position in the crate. Lines and columns are computed from it on demand.

use std::fmt;
use std::slice::SliceIndex;
use std::sync::Arc;

/// The bytes `start..end` of a source text.
///
/// ```
/// use polarform::source::Span;
/// let span = Span::new(2, 5);
/// assert_eq!(&"F(t+1)"[span.range()], "t+1");
/// assert_eq!(span.to(Span::new(4, 6)), Span::new(2, 6));
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct Span {
    /// First byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

impl Span {
    /// The span `start..end`; an end before the start is moved to the start.
    pub fn new(start: usize, end: usize) -> Self {
        Span { start, end: end.max(start) }
    }

    /// The smallest span that covers both.
    pub fn to(self, other: Span) -> Span {
        Span { start: self.start.min(other.start), end: self.end.max(other.end) }
    }

    /// The same span, `offset` bytes further on.
    pub fn shifted(self, offset: usize) -> Span {
        Span { start: self.start + offset, end: self.end + offset }
    }

    /// The span as a range, for slicing.
    pub fn range(self) -> std::ops::Range<usize> {
        self.start..self.end
    }

    /// Number of bytes.
    pub fn len(self) -> usize {
        self.end - self.start
    }

    /// Whether the span covers no byte.
    pub fn is_empty(self) -> bool {
        self.start == self.end
    }
}

impl fmt::Debug for Span {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}..{}", self.start, self.end)
    }
}

/// A text with other words in the places of some spans, which are in its order and do not overlap.
///
/// Cost: linear in the result.
///
/// # Panics
/// If a span does not lie within the text on character boundaries, or begins before the one before it ends.
///
/// ```
/// use polarform::source::{Span, replaced};
/// assert_eq!(replaced("t^2 + 1", [(Span::new(2, 3), "3"), (Span::new(6, 7), "4")]), "t^3 + 4");
/// ```
pub fn replaced<'a>(text: &str, changes: impl IntoIterator<Item = (Span, &'a str)>) -> String {
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    for (span, new) in changes {
        out.push_str(&text[at..span.start]);
        out.push_str(new);
        at = span.end;
    }
    out.push_str(&text[at..]);
    out
}

/// A named text with its line starts. Cheap to clone.
#[derive(Clone, Debug)]
pub struct SourceFile {
    inner: Arc<Inner>,
}

#[derive(Debug)]
struct Inner {
    name: String,
    text: String,
    line_starts: Vec<usize>,
}

impl SourceFile {
    /// A source named `name` (a path, or a description such as `<query>`).
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        let text = text.into();
        let mut line_starts = vec![0];
        line_starts.extend(text.bytes().enumerate().filter(|&(_, b)| b == b'\n').map(|(i, _)| i + 1));
        SourceFile { inner: Arc::new(Inner { name: name.into(), text, line_starts }) }
    }

    /// The name given at construction.
    pub fn name(&self) -> &str {
        &self.inner.name
    }

    /// The whole text.
    pub fn text(&self) -> &str {
        &self.inner.text
    }

    /// The text of a span; empty if the span does not lie within the text on character boundaries.
    pub fn slice(&self, span: Span) -> &str {
        self.inner.text.get(span.range()).unwrap_or("")
    }

    /// The line of a byte, counted from 1. Cost: the logarithm of the number of lines.
    pub(crate) fn line(&self, byte: usize) -> usize {
        self.inner.line_starts.partition_point(|&start| start <= byte).max(1)
    }

    /// Line and column (in characters) of a byte, both counted from 1. Cost: the length of the line before it.
    ///
    /// ```
    /// use polarform::source::SourceFile;
    /// let file = SourceFile::new("a.txt", "f\nσ + t");
    /// assert_eq!(file.line_column(5), (2, 3));
    /// ```
    pub fn line_column(&self, byte: usize) -> (usize, usize) {
        let line = self.line(byte);
        let start = self.inner.line_starts[line - 1];
        let before = self.inner.text[start..].char_indices().take_while(|&(i, _)| start + i < byte);
        (line, before.count() + 1)
    }
}

/// The nearest place at or before `at` that does not cut a character in two.
pub(crate) fn floor_boundary(text: &str, mut at: usize) -> usize {
    at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// Pieces of a text by their bytes, as readers take them.
pub trait Pieces {
    /// The piece of a range. A range that leaves the text or cuts through a character is a defect of ours: it is
    /// met in debug builds; otherwise the piece is empty, so that one formula is lost and not all.
    ///
    /// ```
    /// use polarform::source::Pieces;
    /// assert_eq!("f(σ)".piece(2..4), "σ");
    /// ```
    fn piece(&self, range: impl SliceIndex<str, Output = str>) -> &str;
}

impl Pieces for str {
    #[track_caller]
    fn piece(&self, range: impl SliceIndex<str, Output = str>) -> &str {
        let piece = self.get(range);
        debug_assert!(piece.is_some(), "no piece of the text");
        piece.unwrap_or("")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_are_half_open() {
        let text = "abcdef";
        assert_eq!(&text[Span::new(1, 3).range()], "bc");
        assert_eq!(Span::new(1, 3).len(), 2);
        assert!(Span::new(3, 3).is_empty());
        assert_eq!(Span::new(3, 1), Span::new(3, 3));
    }

    #[test]
    fn lines_and_columns() {
        let file = SourceFile::new("x", "ab\n\ncd");
        assert_eq!(file.line_column(0), (1, 1));
        assert_eq!(file.line_column(2), (1, 3));
        assert_eq!(file.line_column(3), (2, 1));
        assert_eq!(file.line_column(4), (3, 1));
        assert_eq!(file.line_column(6), (3, 3));
        assert_eq!(file.line_column(99), (3, 3));
    }
}
