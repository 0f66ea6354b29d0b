//! A file of lecture notes as a stream of headings, words, formulas and declarations.
//!
//! Every piece knows its bytes in the file. The text of a formula may differ from the file: the
//! marks of a quotation inside a display are blanked, macros are expanded, strings of a notebook
//! are decoded. [`Places`] leads from one to the other.

use crate::formula::source::{SourceFile, Span};
use crate::language::diagnostic::Diagnostic;

/// A file taken apart.
#[derive(Clone, Debug)]
pub struct Document {
    /// The file as it was read (decoded to UTF-8, otherwise unchanged).
    pub file: SourceFile,
    /// Its pieces in the order of the file.
    pub items: Vec<Item>,
    /// What is wrong with the file: unclosed formulas, half a macro, a missing included file.
    pub problems: Vec<Diagnostic>,
    /// Whether its text stands in strings of JSON, as in notebooks.
    pub escaped: bool,
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
    /// `<!-- polarform: … -->` or `% polarform: …`, the text after the colon; or a block of queries,
    /// which weaving runs.
    Declaration {
        /// The statements.
        text: String,
        /// Where the text stands.
        span: Span,
        /// Whether it is a block of queries: what it defines is declared, its other statements are none.
        block: bool,
    },
    /// A quotation, list item or theorem-like environment begins.
    Enter(Enclosure),
    /// It ends.
    Leave(Enclosure),
    /// What the environment is that has just begun.
    Title {
        /// What it is called: example, Beispiel.
        kind: String,
        /// Its label, by which others speak of it.
        label: Option<String>,
    },
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
    /// In plain notation among words: F(u) = f(u, u, u). It reads with [`crate::language::syntax::parse`]; what needs
    /// [`crate::language::latex::read`], which knows more signs (∑) and splits `a_ju_j`, is [`Style::Inline`].
    Plain,
}

/// A formula of a document.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// How it is set.
    pub style: Style,
    /// Its bytes in the file, without the signs around it. `\begin{align}` and its `\end` belong to it.
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

    /// From `text` on, the text is the part `part` of another text, whose places are `from`.
    pub(super) fn append(&mut self, text: usize, from: &Places, part: Span) {
        let first = from.runs.partition_point(|run| run.text <= part.start).saturating_sub(1);
        for run in from.runs[first..].iter().take_while(|run| run.text < part.end.max(part.start + 1)) {
            let begin = run.text.max(part.start);
            let moved = if run.width == 0 { begin - run.text } else { 0 };
            let file = run.file + moved;
            self.push_run(Run { text: text + (begin - part.start), file, width: run.width });
        }
    }

    /// The same places, if the file they lead to is itself a derived text with places in `outer`.
    /// `len` is the length of the text.
    pub(super) fn through(&self, len: usize, outer: &Places) -> Places {
        let mut places = Places::default();
        for (i, run) in self.runs.iter().enumerate() {
            let end = self.runs.get(i + 1).map_or(len, |next| next.text).max(run.text);
            if run.width == 0 {
                places.append(run.text, outer, Span::new(run.file, run.file + (end - run.text)));
            } else {
                places.push_whole(run.text, outer.span(Span::new(run.file, run.file + run.width)));
            }
        }
        places
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

    #[test]
    fn places_of_parts_and_of_texts_of_texts() {
        // Bytes 0..4 at 10..14, 4..6 for 20..25, from 6 on at 30.
        let mut outer = Places::plain(10);
        outer.push_whole(4, Span::new(20, 25));
        outer.push(6, 30, true);
        let mut part = Places::plain(0);
        part.append(3, &outer, Span::new(2, 8));
        assert_eq!((2..9).map(|at| part.byte(at)).collect::<Vec<_>>(), [2, 12, 13, 20, 20, 30, 31]);
        // A text whose bytes 0..2 stand at 3..5 of the text above, and the rest for its 5..7.
        let mut inner = Places::plain(3);
        inner.push_whole(2, Span::new(5, 7));
        let both = inner.through(4, &outer);
        assert_eq!((0..4).map(|at| both.byte(at)).collect::<Vec<_>>(), [13, 20, 20, 20]);
        assert_eq!(both.span(Span::new(2, 4)), Span::new(20, 31));
    }
}
