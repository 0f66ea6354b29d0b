//! A file of lecture notes, taken apart.
//!
//! **Definition.** A *document* is the sequence of the headings, words, formulas and declarations
//! of a file, in its order, with what encloses them: quotations, list items, rows of tables,
//! environments of LaTeX.
//!
//! **Invariants.** All spans are bytes of the file, on character boundaries. Items do not overlap
//! and follow each other in the order of the file. What is wrong with a file (a formula that is
//! never closed) is a problem of the document; the rest of the file is still taken apart. Any text
//! whatever is taken apart, in time linear in its length.
//!
//! **Reference.** CommonMark 0.31 with the tables of GitHub and the formulas of Pandoc, GitHub, GitLab,
//! kramdown, Documenter (Julia) and MyST; the reStructuredText markup specification of Docutils.

// Pieces of a text are taken by `Pieces`, which no text can bring down.
#![cfg_attr(not(test), deny(clippy::string_slice))]

mod arguments;
mod blocks;
mod clean;
mod code_spans;
mod collect;
mod cursor;
#[cfg(feature = "files")]
mod decode;
mod directives;
#[cfg(feature = "files")]
mod files;
mod front;
mod html;
mod inline;
#[cfg(feature = "files")]
mod input;
mod item;
mod kinds;
mod macros;
mod notebook;
mod parts;
mod plain;
mod rst;
mod rst_inline;
mod signs;
mod tex;
mod tex_parts;
mod text;
mod vocabulary;
mod words;

#[cfg(feature = "files")]
pub use files::{Reading, macros_in, read_files, read_macros, read_text};
#[cfg(feature = "files")]
pub use input::{MAX_BYTES, read_bytes, read_stream, read_string, standing, utf8};
pub use item::{Document, Enclosure, Formula, Item, Places, Style};
pub use macros::Macros;
pub use notebook::{Cell, markdown_cells};
pub use parts::{Opening, Part, PartKind, latex_parts, markdown_parts, options_in, query_at};

use crate::formula::source::SourceFile;
use crate::language::diagnostic::{Code, Diagnostic};
use collect::{Collector, Include};

/// How the formulas stand in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Container {
    /// Markdown in its dialects, also plain text.
    Markdown,
    /// reStructuredText.
    Rst,
    /// LaTeX.
    Latex,
    /// The Markdown cells of a Jupyter notebook.
    Notebook,
}

/// Takes a text apart. Files that it includes are not read, and it says so; `read_files`, of the feature `files`, reads them.
///
/// Cost: linear in the length of the text.
///
/// ```
/// use polarform::document::{Item, Style};
/// use polarform::document::{Container, document};
/// use polarform::source::SourceFile;
/// let notes = document(SourceFile::new("a.md", "Let $F(t) = t^2$.\n"), Container::Markdown);
/// let Item::Formula(formula) = &notes.items[1] else { unreachable!() };
/// assert_eq!((formula.text.as_str(), formula.style), ("F(t) = t^2", Style::Inline));
/// assert_eq!(notes.file.line_column(formula.span.start), (1, 6));
/// ```
pub fn document(file: SourceFile, kind: Container) -> Document {
    one(file, kind, Collector::default())
}

fn one(file: SourceFile, kind: Container, mut out: Collector) -> Document {
    scan(file.text(), kind, &mut out);
    for Include { name, place } in std::mem::take(&mut out.includes) {
        let unread = Diagnostic::warning(Code::Include, format!("the included file {name} was not read"));
        out.problem(unread.at(place).hint("check the page as a file, or that file by itself"));
    }
    out.into_document(file)
}

fn scan(text: &str, kind: Container, out: &mut Collector) {
    match kind {
        Container::Markdown => blocks::scan(text, out),
        Container::Rst => rst::scan(text, 0..text.len(), out),
        Container::Latex => tex::scan(text, true, out, &mut |_, _, _, _| {}),
        Container::Notebook => notebook::scan(text, out),
    }
}

#[cfg(test)]
mod tests;
