//! A file of lecture notes as a stream of headings, words, formulas and declarations.
//!
//! Every piece knows its bytes in the file. The text of a formula may differ from the file: the
//! marks of a quotation inside a display are blanked, macros are expanded, strings of a notebook
//! are decoded. [`Places`] leads from one to the other.

use crate::diagnostic::Diagnostic;
use crate::source::{SourceFile, Span};

/// A file taken apart.
#[derive(Clone, Debug)]
pub struct Document {
    /// The file as it was read (decoded to UTF-8, otherwise unchanged).
    pub file: SourceFile,
    /// Its pieces in the order of the file.
    pub items: Vec<Item>,
    /// What is wrong with the file: unclosed formulas, half a macro, a missing included file.
    pub problems: Vec<Diagnostic>,
}

/// A piece of a document.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// A heading; level 1 is the highest.
    Heading {
        /// Its level.
        level: u8,
        /// The bytes of its text.
        span: Span,
    },
    /// Words between formulas: a line of text, or the part of it between two formulas.
    Words(Span),
    /// The end of a paragraph, or of a row of a table.
    Break,
    /// A formula.
    Formula(Formula),
    /// `<!-- polarform: … -->` or `% polarform: …`: the text after the colon.
    Declaration {
        /// The statements.
        text: String,
        /// Where the text stands.
        span: Span,
    },
    /// A quotation, list item or theorem-like environment begins.
    Enter(Enclosure),
    /// It ends.
    Leave(Enclosure),
}

/// What may enclose formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Enclosure {
    /// A quotation.
    Quotation,
    /// An item of a list.
    Item,
    /// A row of a table.
    Row,
    /// A theorem, example, proof … of LaTeX.
    Environment,
}

/// How a formula is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Within a line.
    Inline,
    /// On lines of its own.
    Display,
    /// In plain notation among words: F(u) = f(u, u, u).
    Plain,
}

/// A formula of a document.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// How it is set.
    pub style: Style,
    /// Its bytes in the file, without the signs around it.
    pub span: Span,
    /// Its text, ready for the reader of formulas.
    pub text: String,
    /// From bytes of the text to bytes of the file.
    pub places: Places,
}

impl Formula {
    /// The bytes of the file that a part of the text stands for.
    pub fn in_file(&self, part: Span) -> Span {
        self.places.span(part)
    }
}

/// Where the bytes of a derived text stand in the file: runs of text of equal length in both, or
/// stretches that come from one place (an expanded macro).
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Places {
    /// (first byte in the text, its place in the file, whether the run goes on byte by byte),
    /// in increasing order of the first.
    runs: Vec<(usize, usize, bool)>,
}

impl Places {
    /// The text stands in the file as it is, from `start` on.
    pub fn plain(start: usize) -> Self {
        Places { runs: vec![(0, start, true)] }
    }

    /// From `text` on, the text is that of the file from `file` on; or, if not `moving`, all of it
    /// comes from the one place `file`.
    pub fn push(&mut self, text: usize, file: usize, moving: bool) {
        self.runs.retain(|run| run.0 < text);
        self.runs.push((text, file, moving));
    }

    /// The place in the file of a byte of the text.
    pub fn byte(&self, text: usize) -> usize {
        let at = self.runs.partition_point(|run| run.0 <= text);
        match at.checked_sub(1).map(|at| self.runs[at]) {
            Some((start, file, true)) => file + (text - start),
            Some((_, file, false)) => file,
            None => text,
        }
    }

    /// The span in the file of a span of the text.
    pub fn span(&self, part: Span) -> Span {
        let start = self.byte(part.start);
        let end = if part.is_empty() { start } else { self.byte(part.end - 1) + 1 };
        Span::new(start, end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_lead_back_to_the_file() {
        let mut places = Places::plain(10);
        places.push(5, 40, false);
        places.push(8, 45, true);
        assert_eq!(places.byte(3), 13);
        assert_eq!(places.byte(6), 40);
        assert_eq!(places.byte(9), 46);
        assert_eq!(places.span(Span::new(2, 9)), Span::new(12, 46));
        assert_eq!(places.span(Span::new(3, 3)), Span::new(13, 13));
    }
}
