//! Cutting a text into statements.
//!
//! Statements end at `;`, at line ends and at full stops of sentences. A line end inside brackets, after an
//! operator that needs a right side, or before one that needs a left side, does not
//! count. Here any closing bracket closes any opening one: which kinds belong
//! together is the readers' business (LaTeX has half-open intervals `[0,1)`).

use std::ops::Range;

use super::token::{Token, TokenKind};
use crate::formula::source::Pieces;
use crate::language::lexicon::letters::is_ideograph;
use crate::language::lexicon::{asking, words};

/// The token ranges of the statements; none is empty, line ends at their ends are cut off.
pub(super) fn split(text: &str, tokens: &[Token]) -> Vec<Range<usize>> {
    let Nesting { change, .. } = nesting(text, tokens);
    let mut ranges = Vec::new();
    let mut depth = 0_usize;
    let mut start = 0;
    let mut last = None; // the last token of the statement that is no line end
    for (i, token) in tokens.iter().enumerate() {
        match change[i] {
            1 => depth += 1,
            -1 => depth = depth.saturating_sub(1),
            _ => {}
        }
        let ends = depth == 0
            && match token.kind {
                TokenKind::Semicolon => true,
                TokenKind::Newline => {
                    !last.is_some_and(|at: usize| needs_right(tokens[at].kind))
                        && !next_in_text(tokens, i).is_some_and(needs_left)
                }
                _ => ends_sentence(text, token),
            };
        if ends {
            // t^2.
            if token.kind == TokenKind::Number {
                start = last.map_or(i, |_| start);
                last = Some(i);
            }
            ranges.extend(last.take().map(|last| start..last + 1));
        } else if token.kind != TokenKind::Newline {
            if last.is_none() {
                start = i;
            }
            last = Some(i);
        }
    }
    ranges.extend(last.map(|last| start..last + 1));
    ranges
}

/// Whether a full stop ends a sentence here, `t^2.` with it: the text ends or goes on with a capital letter. What is asked
/// of a definition, `. Find f(2)`, belongs to its statement.
fn ends_sentence(text: &str, token: &Token) -> bool {
    let written = token.text(text);
    let stop = match token.kind {
        TokenKind::Unknown => matches!(written, "." | "。"),
        TokenKind::Number => written.ends_with('.'),
        _ => false,
    };
    if !stop {
        return false;
    }
    let rest = text.piece(token.span().end..);
    let next = rest.trim_start_matches([' ', '\t']);
    // A . Vector([1, 2]) is a product
    let word = next.trim_start_matches(|c: char| c.is_alphanumeric() || c == '_');
    let factor = token.spaced && word.len() < next.len() && word.starts_with(['(', '[']);
    let sentence = next.starts_with(|c: char| c.is_uppercase() || is_ideograph(c))
        && asking::asks(next).is_none()
        && !words::is_question(next)
        && !factor;
    // b = 4. b(1/2)? is no product
    let name = next.trim_start_matches(char::is_alphabetic);
    let called = token.kind == TokenKind::Number
        && name.len() < next.len()
        && name.trim_start_matches(['\'', '′']).starts_with('(');
    next.is_empty()
        || next.starts_with(['\n', '#'])
        || (sentence || called) && (rest != next || written == "。")
}

/// Whether the last statement needs another line.
pub(super) fn is_incomplete(text: &str, tokens: &[Token]) -> bool {
    let last = tokens.iter().rev().find(|token| token.kind != TokenKind::Newline);
    last.is_some_and(|token| needs_right(token.kind)) || nesting(text, tokens).unclosed
}

pub(super) struct Nesting {
    /// For each token 1 if it opens a bracket that is closed later, -1 if it closes one.
    pub change: Vec<i8>,
    /// Whether some bracket is never closed.
    unclosed: bool,
}

pub(super) fn nesting(text: &str, tokens: &[Token]) -> Nesting {
    let mut change = vec![0; tokens.len()];
    let mut open: Vec<usize> = Vec::new();
    let mut dollar: Option<usize> = None; // where in `open` an opening dollar stands
    let mut unclosed = false;
    for (i, token) in tokens.iter().enumerate() {
        let partner = match token.kind {
            TokenKind::Open(_) => {
                open.push(i);
                None
            }
            TokenKind::Close(_) => open.pop(),
            TokenKind::Command if token.text(text) == "\\begin" => {
                open.push(i);
                None
            }
            TokenKind::Command if token.text(text) == "\\end" => open.pop(),
            TokenKind::Dollar => match dollar {
                Some(position) => {
                    unclosed |= open.len() > position + 1;
                    open.truncate(position + 1);
                    open.pop()
                }
                None => {
                    dollar = Some(open.len());
                    open.push(i);
                    None
                }
            },
            _ => None,
        };
        dollar = dollar.filter(|&position| position < open.len());
        if let Some(partner) = partner {
            change[partner] = 1;
            change[i] = -1;
        }
    }
    Nesting { change, unclosed: unclosed || !open.is_empty() }
}

fn next_in_text(tokens: &[Token], at: usize) -> Option<TokenKind> {
    // Only the token right after the line end: blank lines separate.
    tokens.get(at + 1).map(|token| token.kind)
}

fn needs_right(kind: TokenKind) -> bool {
    needs_left(kind) || matches!(kind, TokenKind::Plus | TokenKind::Minus | TokenKind::Underscore)
}

fn needs_left(kind: TokenKind) -> bool {
    use TokenKind::*;
    matches!(kind, Star | Slash | Caret | Comma | Relation(_) | Arrow | Compose | DotDot)
}
