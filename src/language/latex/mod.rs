//! LaTeX as authors write it: text to formula tree.
//!
//! [`read`] turns a formula into the tree of [`crate::formula`], exactly as written:
//! nothing is simplified, `B_i^n` stays a B with an index and a superscript, and
//! every node knows its bytes. It accepts what is met in lecture notes and on
//! pages made from scans: spaced tokens (`t _ { 1 }`), unbraced arguments
//! (`\frac 3 2`), misplaced `\limits`, Unicode letters and signs, `&` and `\\`
//! without an environment, matrices inside `\left( … \right)`.
//!
//! [`read_tolerant`] and [`read_rows`] are for texts that may hold anything: a part
//! that cannot be read becomes [`Kind::Unread`] and spoils neither the other sides
//! of its relations nor the other rows.
//!
//! The grammar stands at the head of `reader.rs`; [`commands`] lists what is known.
//! Reference for what the commands mean in print: Knuth, *The TeXbook*, chapters 16–19,
//! and the amsmath user's guide.

// Pieces of a text are taken by `Pieces`, which no text can bring down.
#![cfg_attr(not(test), deny(clippy::string_slice))]

mod atoms;
mod big;
mod brackets;
mod characters;
mod commands;
mod environments;
mod forms;
mod fractions;
mod lexer;
mod nesting;
mod numbers;
mod postfix;
mod reader;
mod rows;
mod sequences;
mod spelling;
mod tables;
mod terms;
mod token;
mod truncated;

#[cfg(test)]
mod tests;

pub use commands::{Command, commands};
pub use environments::environments;
pub use rows::Row;

use crate::formula::source::{Pieces, Span};
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic};
use reader::Reader;

/// A longer text is refused.
const MAX_BYTES: usize = 1 << 22;

/// Reads a formula. `$ … $`, `$$ … $$`, `\( … \)` and `\[ … \]` around it are passed over.
///
/// Rows separated by `\\` become a [`Kind::Sequence`]; a row that begins with a
/// relation goes on with the chain of the row above.
///
/// Cost: linear in the length for the nesting depths met in practice.
///
/// # Errors
/// A diagnostic with the place of the first thing that cannot be read: unknown or
/// unsupported commands, unbalanced brackets, missing operands, nesting deeper than
/// 256 levels (a bracket or argument counts two), numbers of more than 20,000 digits,
/// texts of more than 4 MiB.
///
/// ```
/// use polarform::expr::Kind;
/// let tree = polarform::latex::read(r"$F(t) = \frac{1}{2} t^2$").unwrap();
/// assert!(matches!(tree.kind, Kind::Chain(..)));
///
/// let problem = polarform::latex::read(r"\farc{1}{2}").unwrap_err();
/// assert_eq!(problem.hints[0], r"did you mean \frac?");
/// ```
pub fn read(text: &str) -> Result<Expr, Diagnostic> {
    let span = checked(text)?;
    let mut reader = Reader::new(text, span, false);
    let window = 0..reader.end;
    reader.display(window, false).map_err(|problem| *problem)
}

/// What a run of letters in LaTeX is.
#[derive(Debug)]
pub(crate) enum Word {
    /// A name of several letters.
    Name,
    /// A product of its letters.
    Letters,
    /// Neither; what is wrong, without a place.
    Refused(Box<Diagnostic>),
}

/// What each run of letters is; the flag says whether a parenthesis follows it.
pub(crate) type Words<'w> = &'w dyn Fn(&str, bool) -> Word;

/// Reads a query: a formula in which runs of letters may be names, and square brackets may hold
/// indices.
///
/// # Errors
/// As for [`read`]; also what is wrong with a word.
pub(crate) fn read_query(text: &str, words: Words) -> Result<Expr, Diagnostic> {
    let span = checked(text)?;
    let mut reader = Reader::of_query(text, span, words);
    let window = 0..reader.end;
    reader.display(window, false).map_err(|problem| *problem)
}

/// Reads what can be read of a formula, with the problems of the rest.
///
/// A side of a relation that cannot be read becomes [`Kind::Unread`] with its text; the
/// other sides stay. If there are no problems, the tree is that of [`read`].
///
/// ```
/// use polarform::latex::read_tolerant;
/// let (tree, problems) = read_tolerant(r"F(t) = \foo{t} = t^2");
/// assert_eq!(problems.len(), 1);
/// assert!(matches!(tree.kind, polarform::expr::Kind::Chain(..)));
/// ```
pub fn read_tolerant(text: &str) -> (Expr, Vec<Diagnostic>) {
    let span = match checked(text) {
        Ok(span) => span,
        Err(problem) => return (Expr::new(Kind::Unread(String::new()), Span::default()), vec![problem]),
    };
    let mut problems = Vec::new();
    let mut formulas = Vec::new();
    for row in rows::read_rows(text, span, true) {
        problems.extend(row.problems);
        formulas.push(row.expr);
    }
    let tree = match formulas.len() {
        0 => {
            problems.push(empty(span));
            Expr::new(Kind::Unread(text.piece(span.range()).to_owned()), span)
        }
        1 => formulas.remove(0),
        _ => Expr::new(Kind::Sequence(formulas), span),
    };
    (tree, problems)
}

/// The rows of a display, each read by itself, so that one that cannot be read does not spoil
/// the others.
///
/// The display may be an environment (`aligned`, `gather`, `split`, …), an array that is used
/// as one, a system of equations in `cases`, or rows separated by bare `\\`. A row break
/// inside brackets that close in a later row does not end the row, nor does one before a row
/// that begins with `+` or another operator.
///
/// ```
/// use polarform::expr::Rel;
/// use polarform::latex::read_rows;
/// let rows = read_rows(r"\begin{aligned} F(t) &= (t+1)^2 \\ &= t^2 + 2t + 1 \end{aligned}");
/// assert_eq!(rows.len(), 2);
/// assert_eq!(rows[1].leading.map(|(rel, _)| rel), Some(Rel::Eq));
/// ```
pub fn read_rows(text: &str) -> Vec<Row> {
    let span = match checked(text) {
        Ok(span) => span,
        Err(problem) if problem.code == Code::Empty => return Vec::new(),
        Err(problem) => {
            let expr = Expr::new(Kind::Unread(String::new()), Span::default());
            let (leading, trailing) = (None, None);
            return vec![Row { span: Span::default(), leading, trailing, expr, problems: vec![problem] }];
        }
    };
    rows::read_rows(text, span, false)
}

/// The formula in `text`, if there is one of bearable length.
fn checked(text: &str) -> Result<Span, Diagnostic> {
    if text.len() > MAX_BYTES {
        let message = format!("a formula of {} bytes; at most {MAX_BYTES} can be read", text.len());
        return Err(Diagnostic::error(Code::TooLong, message));
    }
    let span = rows::formula_span(text);
    if span.is_empty() {
        return Err(empty(span));
    }
    Ok(span)
}

fn empty(span: Span) -> Diagnostic {
    Diagnostic::error(Code::Empty, "there is no formula to read").at(span)
}
