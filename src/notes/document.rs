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
    /// In increasing order of their first byte in the text.
    runs: Vec<Run>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Run {
    /// First byte in the text.
    text: usize,
    /// Its place in the file.
    file: usize,
    /// How many bytes of the file all of the run stands for; 0 if it goes on byte by byte.
    width: usize,
}

impl Places {
    /// The text stands in the file as it is, from `start` on.
    pub fn plain(start: usize) -> Self {
        Places { runs: vec![Run { text: 0, file: start, width: 0 }] }
    }

    /// From `text` on, the text is that of the file from `file` on; or, if not `moving`, all of it
    /// comes from the one place `file`.
    pub fn push(&mut self, text: usize, file: usize, moving: bool) {
        self.push_run(Run { text, file, width: usize::from(!moving) });
    }

    /// From `text` on, all of the text stands for the bytes `file`, such as the call of a macro.
    pub fn push_whole(&mut self, text: usize, file: Span) {
        self.push_run(Run { text, file: file.start, width: file.len().max(1) });
    }

    fn push_run(&mut self, run: Run) {
        while self.runs.last().is_some_and(|last| last.text >= run.text) {
            self.runs.pop();
        }
        self.runs.push(run);
    }

    fn run(&self, text: usize) -> Option<Run> {
        let at = self.runs.partition_point(|run| run.text <= text);
        at.checked_sub(1).map(|at| self.runs[at])
    }

    /// The place in the file of a byte of the text.
    pub fn byte(&self, text: usize) -> usize {
        match self.run(text) {
            Some(Run { text: start, file, width: 0 }) => file + (text - start),
            Some(run) => run.file,
            None => text,
        }
    }

    /// The span in the file of a span of the text.
    pub fn span(&self, part: Span) -> Span {
        let start = self.byte(part.start);
        if part.is_empty() {
            return Span::new(start, start);
        }
        let width = self.run(part.end - 1).map_or(1, |run| run.width.max(1));
        Span::new(start, self.byte(part.end - 1) + width)
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
        places.push_whole(12, Span::new(50, 57));
        assert_eq!(places.span(Span::new(12, 14)), Span::new(50, 57));
        assert_eq!(places.span(Span::new(11, 13)), Span::new(48, 57));
    }
}
