//! The plain notation: text to formula tree.
//!
//! **Definition.** A *statement* is one formula, as in `F(t) := t^2 + 2t` or
//! `f(0, 1) = 2/3`; a *program* is a list of statements separated by `;` or by line
//! ends. The grammar opens the file `parser.rs`.
//!
//! **Invariants.** Reading is a pure function of the text. The tree is exactly what
//! was written (nothing is simplified, parentheses stay), every node carries the
//! half-open byte span it was read from, spans lie on character boundaries and a
//! child's span lies within its parent's. Whatever the text, reading takes time
//! linear in its length (but for very long numerals, see [`MAX_DIGITS`]), its
//! recursion is bounded by [`MAX_DEPTH`], and the height of the tree by
//! [`MAX_HEIGHT`], so that walking or dropping it cannot overflow the stack.
//!
//! **Reference.** Operators are read by precedence with an explicit stack, as in
//! Dijkstra's shunting-yard algorithm (*Algol 60 translation*, 1961).

// Pieces of a text are taken by `Pieces`, which no text can bring down.
#![cfg_attr(not(test), deny(clippy::string_slice))]

mod chars;
mod clauses;
mod items;
mod lexer;
mod line;
mod parser;
mod pieces;
mod sentence;
mod spoken;
mod statement;
mod token;
pub(crate) mod truncated;
mod unknown;

#[cfg(test)]
mod tests;

pub(crate) use clauses::{after_introduction, asked, clause, continuations};
pub use items::spaced_items;
pub(crate) use line::{Line, Piece, Role, line};
pub use parser::{MAX_DEPTH, MAX_DIGITS, MAX_HEIGHT};
pub(crate) use parser::{congruence, is_special, reach_of_mod, special_call};
pub(crate) use pieces::{is_aside, is_title, without_text_commands};
pub(crate) use sentence::{Sentence, conditions_in as conditions, sentence};
pub(crate) use spoken::{
    Asked, Call, Count, Request, Said, Total, What, family_index, loosely, place_without_value, request,
};
pub use token::MAX_TOKENS;
pub(crate) use unknown::{Unknown, letter_of_object, unknown};

use crate::formula::Expr;
use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::lexicon::{letters, words};

/// The formula in `text`, which holds one statement; comments start with `#`.
///
/// Cost: linear in the length of the text.
///
/// # Errors
/// A [`Diagnostic`] with its place when the text is empty, is not a formula, holds
/// more than one statement, or passes a limit.
///
/// ```
/// use polarform::expr::{Expr, Kind};
/// use polarform::source::Span;
/// use polarform::syntax::parse;
/// let formula = parse("t1 t2 + 1").unwrap();
/// assert_eq!(formula.span, Span::new(0, 9));
/// assert!(matches!(formula.kind, Kind::Add(ref terms) if terms.len() == 2));
/// assert!(parse("t1").unwrap().same_as(&Expr::indexed("t", 1)));
/// assert!(parse("(t + 1").is_err());
/// ```
pub fn parse(text: &str) -> Result<Expr, Diagnostic> {
    let tokens = lexer::lex(text)?;
    let ranges = statement::split(text, &tokens);
    let Some(first) = ranges.first() else {
        return Err(Diagnostic::error(Code::Empty, "there is no formula to read")
            .at(Span::new(0, 0))
            .hint("write a formula such as t^2 + 1"));
    };
    let formula = parser::parse_statement(text, &tokens[first.clone()])?;
    if let Some(second) = ranges.get(1) {
        return Err(Diagnostic::error(Code::UnexpectedToken, "a second formula begins here")
            .at(tokens[second.start].span())
            .reason("only one formula is wanted")
            .hint("keep one of the two, or join their lines: end the first line with an operator"));
    }
    Ok(formula)
}

/// Every statement of `text` in order, each with its own result; spans count from the start of `text`.
///
/// A bracket that is never closed ends with its line, so that one slip does not
/// hide the statements after it.
///
/// ```
/// use polarform::syntax::parse_program;
/// let results = parse_program("F(t) := t^2  # a square\n f(0, 1); (t +\n 1)^2\n * 3 +");
/// assert_eq!(results.len(), 3);
/// assert!(results[0].is_ok() && results[1].is_ok() && results[2].is_err());
/// ```
pub fn parse_program(text: &str) -> Vec<Result<Expr, Diagnostic>> {
    match lexer::lex(text) {
        Ok(tokens) => statement::split(text, &tokens)
            .into_iter()
            .map(|range| parser::parse_statement(text, &tokens[range]))
            .collect(),
        Err(problem) => vec![Err(problem)],
    }
}

/// Where the statements of `text` stand, without reading them.
///
/// For texts that mix the plain notation and LaTeX: cut first, then choose the
/// reader of each piece with [`looks_like_latex`]. Inside `$…$` and between
/// `\begin` and `\end` nothing is cut.
///
/// # Errors
/// When the text is longer than the limit.
///
/// ```
/// use polarform::syntax::statements;
/// let text = "F := t^2; # the first\n G := (t,\n t^3)";
/// let pieces: Vec<_> = statements(text).unwrap().into_iter().map(|s| &text[s.range()]).collect();
/// assert_eq!(pieces, ["F := t^2", "G := (t,\n t^3)"]);
/// ```
pub fn statements(text: &str) -> Result<Vec<Span>, Diagnostic> {
    let tokens = lexer::lex(text)?;
    let spans = statement::split(text, &tokens).into_iter();
    Ok(spans.map(|range| tokens[range.start].span().to(tokens[range.end - 1].span())).collect())
}

/// Whether `text` stops in the middle of a statement: a bracket is open or an operator has no right side.
///
/// A command loop asks for another line then.
///
/// ```
/// use polarform::syntax::is_incomplete;
/// assert!(is_incomplete("F(t) :="));
/// assert!(is_incomplete("[1, 2;\n 3"));
/// assert!(!is_incomplete("F(t) := t^2"));
/// ```
pub fn is_incomplete(text: &str) -> bool {
    lexer::lex(text).is_ok_and(|tokens| statement::is_incomplete(text, &tokens))
}

/// Whether a statement should go to the LaTeX reader: it has a `$`, a sign or word such as ∑ or `sum` with bounds below
/// it, or a backslash that does not begin the name of a Greek letter.
///
/// ```
/// use polarform::syntax::looks_like_latex;
/// assert!(looks_like_latex(r"\frac{1}{2} t"));
/// assert!(looks_like_latex("$t^2$"));
/// assert!(looks_like_latex("∑_{i=0}^n t^i") && looks_like_latex("sum_{i=0}^n t^i"));
/// assert!(!looks_like_latex(r"\alpha t_{12}^{2}"));
/// ```
pub fn looks_like_latex(text: &str) -> bool {
    let bytes = text.as_bytes();
    // ∫₀²
    let below = |(before, after): (char, char)| "∑∏∫".contains(before) && ('₀'..='₎').contains(&after);
    let unicode = !text.is_ascii() && text.chars().zip(text.chars().skip(1)).any(below);
    unicode
        || bytes.iter().enumerate().any(|(at, &byte)| match byte {
            // diff(t^4, t$2)
            b'$' => {
                !(at > 0
                    && bytes[at - 1].is_ascii_alphabetic()
                    && bytes.get(at + 1).is_some_and(u8::is_ascii_digit)
                    && bytes.iter().filter(|&&byte| byte == b'$').count() == 1)
            }
            b'{' => text.piece(at..).starts_with("{,}"),
            b'_' => {
                let before = text.piece(..at).trim_end();
                let word = before.rsplit(|c: char| !c.is_ascii_alphabetic()).next();
                ["∑", "∏", "∫"].iter().any(|sign| before.ends_with(sign))
                    || word.is_some_and(|word| words::is_sign_with_bounds(word, text.piece(before.len()..)))
            }
            // A \ b solves equations elsewhere.
            b'\\' if at > 0 && bytes[at - 1] == b' ' && bytes.get(at + 1) == Some(&b' ') => false,
            b'\\' => {
                let letters = bytes[at + 1..].iter().take_while(|b| b.is_ascii_alphabetic()).count();
                letters::sign(text.piece(at + 1..at + 1 + letters)).is_none()
            }
            _ => false,
        })
}
