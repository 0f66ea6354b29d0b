//! Weaving: results filled into the source of lecture notes.
//!
//! **Definition.** A *query* is a statement of the language in a document: `{{ f(0, 1) }}` among words
//! or in a formula, a fenced block `polarform`; in LaTeX `\polarform{…}` and the environment
//! `polarform`. *Weaving* runs all queries of a file in their order, in one session, and puts what comes
//! out where it belongs: into the file itself ([`Mode::InPlace`]), into a copy that holds results only
//! ([`Mode::Template`]), or, for LaTeX, into a file beside it that a small package reads.
//!
//! **Invariants.** What is not a query or its result keeps every byte. Weaving twice changes nothing. A
//! query that fails leaves its old result where it is, and the others are run all the same. Nothing is
//! replaced in code, code spans, comments or front matter; in a formula a result stands without signs
//! around it. Time is linear in the length of the text, apart from the queries.
//!
//! **Reference.** Knuth, *Literate Programming* (1984), for the word; the package SageTeX for the way of
//! LaTeX; Pandoc and CommonMark 0.31 for what is a formula and a comment.
//!
//! A new kind of value is added in [`render`], which makes a [`Piece`]; how pieces look in Markdown and
//! LaTeX stands in `markup`.

// Pieces of a text are taken by `Pieces`, which no text can bring down.
#![cfg_attr(not(test), deny(clippy::string_slice))]

mod book;
mod breakable;
#[cfg(feature = "writing")]
mod files;
mod markdown;
mod markup;
mod notebook;
mod options;
mod plan;
mod render;
mod runner;
mod side;
mod stamp;
mod tex;

#[cfg(test)]
mod tests;

pub use crate::document::options_in;
pub use book::{BookError, weave_book};
#[cfg(feature = "writing")]
pub use files::{Input, read_input, replace_file, write_file};
pub use notebook::weave_notebook;
pub use options::{BlockOptions, Show, Style};
pub use render::{Picture, Piece, Shown, StepLine, render};
pub use tex::{Load, side_name, weave_latex};

use crate::budget::Limits;
use crate::formula::source::{SourceFile, Span};
use crate::session::{Failure, Session};
use markdown::{edited, edits, line_end, signature};
use runner::Runner;
use stamp::{with_stamp, without_stamp};

/// The package `polarform.sty` for LaTeX documents.
pub const PACKAGE: &str = include_str!("polarform.sty");

/// Where results go.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Into the source, beside the queries, where they are replaced the next time.
    #[default]
    InPlace,
    /// Into a copy, in place of the queries.
    Template,
}

/// How to weave.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Where results go.
    pub mode: Mode,
    /// The limits of each statement.
    pub limits: Limits,
    /// What holds for queries within a line, and for blocks that say nothing else.
    pub blocks: BlockOptions,
    /// What the names of the files of pictures begin with, relative to the document; `None` to put
    /// pictures into the text of Markdown.
    pub pictures: Option<String>,
    /// Run the queries even if the stamp says that nothing changed.
    pub fresh: bool,
    /// How formulas of books become HTML, if they shall: their LaTeX, and whether they stand on a line of their own.
    pub set: Option<fn(&str, bool) -> Option<String>>,
}

/// What came of weaving.
#[derive(Clone, Debug, Default)]
pub struct Woven {
    /// The new text of the file (for LaTeX, of the file beside it).
    pub text: String,
    /// What is wrong, with the file where it is.
    pub problems: Vec<Failure>,
    /// How many claims are refuted; each is a problem, too.
    pub refuted: usize,
    /// Whether a query could not be read, evaluated or decided.
    pub failed: bool,
    /// How many results there are; 0 if nothing was run.
    pub results: usize,
    /// The files of pictures, relative to the document, with their contents.
    pub pictures: Vec<(String, String)>,
    /// The queries whose results changed, with their files.
    pub stale: Vec<(SourceFile, Span)>,
    /// Whether the stamp said that nothing changed, so that nothing was run.
    pub unchanged: bool,
}

impl Woven {
    /// The same text, with nothing run.
    fn unchanged(text: &str) -> Self {
        Woven { text: text.to_owned(), unchanged: true, ..Woven::default() }
    }

    /// Takes over what a runner found.
    fn take(&mut self, runner: Runner) {
        self.failed |= runner.failed();
        self.refuted += runner.refuted;
        self.results += runner.results;
        self.pictures.extend(runner.pictures);
        self.problems.extend(runner.problems);
    }

    /// Whether there is nothing that must be told again at the next run.
    fn is_clean(&self) -> bool {
        !self.failed && self.refuted == 0
    }
}

/// The files of the pictures that were woven into a Markdown text, relative to the document. If one of
/// them is gone, the text has to be woven afresh.
///
/// Cost: linear in the length of the text.
///
/// ```
/// let text = "```polarform picture=a\nfigure_basis(2)\n```\n<!-- woven -->\n\n![B](a.svg)\n\n<!-- /woven -->\n";
/// assert_eq!(polarform::weave::pictures_in(text), ["a.svg"]);
/// ```
pub fn pictures_in(text: &str) -> Vec<String> {
    let (text, _) = without_stamp(text);
    plan::plan(text, &BlockOptions::default()).pictures(text)
}

/// Weaves a Markdown text.
///
/// In place, a file whose results are all right gets a stamp at its end, a comment; if the next run
/// finds it right, no query is run.
///
/// Cost: the queries, and time linear in the length of the text.
///
/// ```
/// use polarform::source::SourceFile;
/// use polarform::weave::{Mode, Options, weave_markdown};
/// let notes = SourceFile::new("a.md", "```polarform\nf := polar(t^2)\n```\nso $f(0,1) = {{ f(0,1) }}$\n");
/// let woven = weave_markdown(&notes, &Options::default());
/// assert!(woven.text.contains("so $f(0,1) = 0$<!-- $f(0,1) = {{ f(0,1) }}$ -->\n"));
/// let again = weave_markdown(&SourceFile::new("a.md", woven.text.as_str()), &Options::default());
/// assert!(again.unchanged && again.text == woven.text);
/// let copy = weave_markdown(&notes, &Options { mode: Mode::Template, ..Options::default() });
/// assert!(copy.text.ends_with("so $f(0,1) = 0$\n"));
/// ```
pub fn weave_markdown(file: &SourceFile, options: &Options) -> Woven {
    let (text, stamp) = without_stamp(file.text());
    let plan = plan::plan(text, &options.blocks);
    let in_place = options.mode == Mode::InPlace;
    let signature = signature(options);
    if in_place
        && !options.fresh
        && plan.problems.is_empty()
        && stamp.is_some_and(|stamp| stamp == plan.digest(text, &signature))
    {
        return Woven::unchanged(file.text());
    }
    let session = Session::new(options.limits.clone());
    let mut runner = Runner::new(session).with_pictures(options.pictures.as_deref());
    let edits = edits(text, &plan, &mut runner, file, &|span| span, options);
    let mut woven = Woven { text: edited(text, &edits), ..Woven::default() };
    woven.stale = edits.iter().map(|edit| (file.clone(), edit.query)).collect();
    woven.take(runner);
    if in_place && woven.is_clean() && !plan.sites.is_empty() {
        let digest = plan::plan(&woven.text, &options.blocks).digest(&woven.text, &signature);
        woven.text = with_stamp(&woven.text, &digest, line_end(text));
    }
    woven
}

/// The stamp that belongs to a copy: it depends on the source, the options and the copy.
fn copy_stamp(source: &str, copy: &str, options: &Options) -> String {
    let mut digest = stamp::Digest::new(&signature(options));
    digest.add(source);
    digest.add(copy);
    digest.text()
}

/// Whether a copy that was made before is still right, by its stamp; nothing is run.
///
/// ```
/// use polarform::source::SourceFile;
/// use polarform::weave::{Mode, Options, copy_is_fresh, weave_copy};
/// let source = SourceFile::new("a.md", "{{ 1 + 1 }}\n");
/// let options = Options { mode: Mode::Template, ..Options::default() };
/// let copy = weave_copy(&source, &options).text;
/// assert!(copy.starts_with("$2$\n<!-- woven by polarform"));
/// assert!(copy_is_fresh(&source, &copy, &options));
/// assert!(!copy_is_fresh(&source, &copy.replace('2', "3"), &options));
/// ```
pub fn copy_is_fresh(source: &SourceFile, copy: &str, options: &Options) -> bool {
    let (body, stamp) = without_stamp(copy);
    !options.fresh && stamp.is_some_and(|stamp| stamp == copy_stamp(source.text(), body, options))
}

/// Weaves a Markdown text as a template into a copy with a stamp at its end.
///
/// Cost: as for [`weave_markdown`].
pub fn weave_copy(source: &SourceFile, options: &Options) -> Woven {
    let options = Options { mode: Mode::Template, ..options.clone() };
    let mut woven = weave_markdown(source, &options);
    if woven.is_clean() {
        let stamp = copy_stamp(source.text(), &woven.text, &options);
        woven.text = with_stamp(&woven.text, &stamp, line_end(&woven.text));
    }
    woven
}
