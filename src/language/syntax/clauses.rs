//! A name that is defined in words, and what is said with it: `let f be the polar form of t^2; f(0, 1)`,
//! `if f is the derivative of t^3, what is f(2)?`.

use crate::formula::source::{Pieces, Span};
use crate::language::lexicon::words::{self, Copula};

/// A definition in words, taken apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Clause<'a> {
    /// The name.
    pub name: &'a str,
    /// Where it stands.
    pub place: Span,
    /// Where that stands which it is, perhaps with more behind it.
    pub rest: Span,
    /// Whether a word introduces the definition, so that nothing else can be meant.
    pub introduced: bool,
}

/// The definition with which a text begins, if it begins with a name and a word such as "is".
pub(crate) fn clause(text: &str) -> Option<Clause<'_>> {
    let mut at = skip(text, 0);
    let mut introduced = false;
    while let Some(length) = words::introduces(text.piece(at..)) {
        introduced = true;
        at = skip(text, at + length);
    }
    let start = at;
    let dollar = usize::from(text.piece(at..).starts_with('$'));
    at += dollar;
    let name_start = at;
    at += text.piece(at..).chars().take_while(|c| c.is_alphabetic()).map(char::len_utf8).sum::<usize>();
    let name = text.piece(name_start..at);
    if name.is_empty() || words::is_prose(name) {
        return None;
    }
    if dollar > 0 {
        at += text.piece(at..).strip_prefix('$').map(|_| 1)?;
    }
    let place = Span::new(start, at);
    let gap = skip(text, at);
    // "f is" is a question or a claim without a word before it; "sei f die Ableitung" needs no second one.
    let length = match words::copula(text.piece(gap..)) {
        Some((copula, length)) if introduced || copula == Copula::Sign => length,
        None if introduced => 0,
        _ => return None,
    };
    let rest = skip(text, gap + length);
    Some(Clause { name, place, rest: Span::new(rest, text.len()), introduced })
}

/// Where the text after a definition may go on, the last place first: each with the end of the definition.
pub(crate) fn continuations(text: &str) -> Vec<(usize, Span)> {
    let mut depth = 0_i32;
    let mut found = Vec::new();
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ',' | '.' | ';' | ':' if depth == 0 => {
                let after = at + c.len_utf8();
                if c != '.' || text.piece(after..).starts_with(char::is_whitespace) {
                    let mut start = skip(text, after);
                    while let Some(length) = words::goes_on(text.piece(start..)) {
                        start = skip(text, start + length);
                    }
                    if let Some(span) = trimmed(text, start) {
                        found.push((at, span));
                    }
                }
            }
            _ => {}
        }
    }
    found.reverse();
    found
}

/// From a place to the end, without the signs of a question: `$f(0, 1) =$`.
fn trimmed(text: &str, start: usize) -> Option<Span> {
    let ends = |c: char| c.is_whitespace() || matches!(c, '?' | '.' | '=' | '？' | '。');
    let tail = text.piece(start..);
    let inner = tail.trim_end_matches(ends);
    let (from, inner) = match (inner.strip_prefix('$'), inner.matches('$').count()) {
        (Some(inside), 2) => (start + 1, inside.strip_suffix('$')?),
        _ => (start, inner),
    };
    let inner = inner.trim_end_matches(ends);
    (!inner.is_empty()).then(|| Span::new(from, from + inner.len()))
}

fn skip(text: &str, at: usize) -> usize {
    let rest = text.piece(at..);
    at + (rest.len() - rest.trim_start().len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn definitions_are_told_from_questions() {
        let found = clause("let f be the polar form of t^2; f(0, 1)").unwrap();
        assert_eq!((found.name, found.introduced), ("f", true));
        assert_eq!(clause("f is symmetric"), None);
        assert!(clause("g = polar form of t").is_some_and(|found| !found.introduced));
    }

    #[test]
    fn what_goes_on_stands_after_a_stop() {
        let text = "the polar form of (t, 1), then what is f(0)?";
        let (end, rest) = continuations(text)[0];
        assert_eq!((text.piece(..end), text.piece(rest.range())), ("the polar form of (t, 1)", "f(0)"));
    }
}
