//! Where the readers of containers put what they find.

use super::arguments::command_name;
use super::clean::cleaned;
use super::code_spans::InCode;
use super::macros::Macros;
use super::parts::Layout;
use super::plain;
use super::signs::line_at;
use crate::document::{Document, Enclosure, Formula, Item, Style};
use crate::formula::source::{Pieces, SourceFile, Span};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::latex;

/// So many problems are told of a file; the rest are of the same kind.
const MAX_PROBLEMS: usize = 1000;

/// So many commands of LaTeX are looked at in a line of words.
const MAX_COMMANDS: usize = 100;

/// The pieces found so far.
#[derive(Default)]
pub(super) struct Collector {
    items: Vec<Item>,
    problems: Vec<Diagnostic>,
    pub(super) macros: Macros,
    /// Where everything stands, if that is asked for.
    pub(super) layout: Option<Layout>,
    /// What the code spans of this page hold.
    pub(super) in_code: InCode,
    /// Whether what stands in backquotes without a role is a formula (reStructuredText).
    pub(super) default_role: bool,
    /// The files that the page includes, and that are not LaTeX.
    pub(super) includes: Vec<Include>,
    /// Whether the text stands in strings of JSON.
    pub(super) escaped: bool,
    /// Whether something was said since the last paragraph or enclosure.
    said: bool,
}

/// A file that a page includes.
pub(super) struct Include {
    /// Its name, as it stands there.
    pub(super) name: String,
    pub(super) place: Span,
}

impl Collector {
    /// A collector that goes on with the macros and problems of another.
    pub(super) fn with(macros: Macros, problems: Vec<Diagnostic>) -> Self {
        Collector { macros, problems, ..Collector::default() }
    }

    /// The macros and problems that it has so far.
    #[cfg(feature = "files")]
    pub(super) fn known(&self) -> (Macros, Vec<Diagnostic>) {
        (self.macros.clone(), self.problems.clone())
    }

    /// What was found in the file.
    pub(super) fn into_document(self, file: SourceFile) -> Document {
        Document { file, items: self.items, problems: self.problems, escaped: self.escaped }
    }

    /// What was found in a part of the file: items and problems.
    pub(super) fn into_parts(self) -> (Vec<Item>, Vec<Diagnostic>, Macros) {
        (self.items, self.problems, self.macros)
    }

    pub(super) fn push(&mut self, item: Item) {
        match item {
            Item::Words(_) | Item::Formula(_) | Item::Heading { .. } => self.said = true,
            Item::Break | Item::Enter(_) | Item::Leave(_) => self.said = false,
            Item::Declaration { .. } | Item::Title { .. } => {}
        }
        self.items.push(item);
    }

    pub(super) fn problem(&mut self, problem: Diagnostic) {
        if self.problems.len() < MAX_PROBLEMS {
            self.problems.push(problem);
        }
    }

    /// A formula: `text` as it stands at byte `start`, without the signs around it.
    pub(super) fn formula(&mut self, style: Style, text: &str, start: usize) {
        self.formula_of(style, text, start, false);
    }

    /// A formula of a LaTeX file, where comments may stand in it.
    pub(super) fn commented_formula(&mut self, style: Style, text: &str, start: usize) {
        self.formula_of(style, text, start, true);
    }

    fn formula_of(&mut self, style: Style, text: &str, start: usize, comments: bool) {
        let start = start + (text.len() - text.trim_start().len());
        let span = Span::new(start, start + text.trim().len());
        let text = cleaned(text.trim(), start, comments);
        let (mut text, problem) = self.macros.expand(text);
        if let Some(problem) = problem {
            self.problem(problem);
        }
        text.text.truncate(text.text.trim_end().len());
        if !text.text.is_empty() {
            self.push(Item::Formula(Formula { style, span, text: text.text, places: text.places }));
        }
    }

    /// A block of queries; `text` stands at byte `start`.
    pub(super) fn queries(&mut self, text: &str, start: usize) {
        let span = Span::new(start, start + text.len());
        self.push(Item::Declaration { text: text.to_owned(), span, block: true });
    }

    /// Words on one or several lines.
    pub(super) fn words(&mut self, text: &str, start: usize) {
        for (line, at) in lines(text, start) {
            self.line(line, at);
        }
    }

    /// Words among which formulas in plain notation may stand; `continues` a formula before them.
    pub(super) fn prose(&mut self, text: &str, start: usize, continues: bool) {
        let mut at = 0;
        // Up to where lines that belong together were looked at as one.
        let mut tried = 0;
        while at <= text.len() {
            let continues = continues && at == 0;
            let line = line_at(text, at);
            let end = if at < tried { at + line.len() } else { derivation_end(text, at) };
            tried = tried.max(end);
            let all = text.piece(at..end);
            let joined = (line.len() < all.len())
                .then(|| plain::find(&all.replace(['\n', '\r'], " "), continues))
                .filter(|found| found.iter().any(|found| found.range.contains(&line.len())));
            let (piece, found) = match joined {
                Some(found) => (all, found),
                None => (line, plain::find(line, continues)),
            };
            let mut said = 0;
            for found in found {
                self.words_of(piece.piece(said..found.range.start), start + at + said);
                said = found.range.end;
                self.formula(found.style, &found.text, start + at + found.range.start);
            }
            self.words_of(piece.piece(said..), start + at + said);
            at += piece.len() + 1;
        }
    }

    /// Words outside of formulas; a command of LaTeX among them belongs to a formula without signs.
    fn words_of(&mut self, text: &str, at: usize) {
        for (line, at) in lines(text, at) {
            if let Some(found) = command(line) {
                let span = Span::new(at + found.start, at + found.end);
                self.unseen(span, "this looks like a formula and was not read");
            }
            self.line(line, at);
        }
    }

    fn line(&mut self, line: &str, at: usize) {
        let begin = at + (line.len() - line.trim_start().len());
        let len = line.trim().len();
        if len > 0 {
            self.push(Item::Words(Span::new(begin, begin + len)));
        }
    }

    /// The end of a paragraph, unless nothing was said since the last one.
    pub(super) fn end_paragraph(&mut self) {
        if self.said {
            self.push(Item::Break);
        }
    }

    pub(super) fn enter(&mut self, what: Enclosure) {
        self.push(Item::Enter(what));
    }

    pub(super) fn leave(&mut self, what: Enclosure) {
        self.push(Item::Leave(what));
    }

    /// The row of a table ends; one in which nothing stands was none.
    pub(super) fn end_row(&mut self) {
        if self.items.last() == Some(&Item::Enter(Enclosure::Row)) {
            self.items.pop();
        } else {
            self.end_paragraph();
            self.leave(Enclosure::Row);
        }
    }

    /// Something that a person would take for a formula and that is not read.
    pub(super) fn unseen(&mut self, span: Span, what: &str) {
        let problem = Diagnostic::warning(Code::UnseenFormula, what).at(span);
        self.problem(problem.hint("write it between $ and $, or as the format of the page wants it"));
    }

    /// A sign that opens a formula which is never closed.
    pub(super) fn unclosed(&mut self, sign: &str, at: usize, closing: &str) {
        let problem = Diagnostic::warning(Code::UnclosedFormula, format!("{sign} is never closed"))
            .at(Span::new(at, at + sign.len()))
            .reason("a formula begins here");
        self.problem(if sign == "$" {
            problem.hint(r"write $ after the formula, or \$ for the currency")
        } else {
            problem.hint(format!("write {closing} after the formula"))
        });
    }
}

/// The first command of LaTeX in a line that only formulas have.
fn command(line: &str) -> Option<std::ops::Range<usize>> {
    const GROUPS: [&str; 4] =
        ["fractions and roots", "sums, limits and integrals", "letters and symbols", "relations"];
    let mathematical = |name: &str| {
        name.len() > 1
            && latex::commands().iter().any(|known| known.name() == name && GROUPS.contains(&known.group()))
    };
    line.match_indices('\\').take(MAX_COMMANDS).find_map(|(at, _)| {
        let name = command_name(line, at);
        let escaped = line.piece(..at).ends_with('\\');
        (!escaped && mathematical(name)).then(|| at..at + 1 + name.len())
    })
}

/// The end of the line at `at` and of those after it that begin with a relation: `= 2t + 1`.
fn derivation_end(text: &str, at: usize) -> usize {
    let goes_on = |line: &str| {
        let line = line.trim();
        let signs = ["= ", "≤ ", "≥ ", "<= ", ">= "];
        signs.iter().any(|sign| line.starts_with(sign))
    };
    let mut end = at + line_at(text, at).len();
    while end < text.len() {
        let next = line_at(text, end + 1);
        if !goes_on(next) {
            break;
        }
        end += 1 + next.len();
    }
    end
}

/// The lines of a text with the bytes where they start.
fn lines(text: &str, start: usize) -> impl Iterator<Item = (&str, usize)> {
    let mut at = start;
    text.split('\n').map(move |line| {
        let begin = at;
        at += line.len() + 1;
        (line, begin)
    })
}
