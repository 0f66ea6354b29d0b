//! A name that is defined in words, and what is said with it: `let f be the polar form of t^2; f(0, 1)`,
//! `if f is the derivative of t^3, what is f(2)?`.

use crate::formula::source::{Pieces, Span};
use crate::language::lexicon::asking::{self, Copula};
use crate::language::lexicon::phrases::{Phrase, phrase};
use crate::language::lexicon::words;

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
    while let Some(length) = asking::introduces(text.piece(at..)) {
        introduced = true;
        at = skip(text, at + length);
    }
    let start = at;
    let dollar = usize::from(text.piece(at..).starts_with('$'));
    at += dollar;
    let name_start = at;
    at += text.piece(at..).chars().take_while(|c| c.is_alphabetic()).map(char::len_utf8).sum::<usize>();
    let name = text.piece(name_start..at);
    // where do they meet
    let verb = name.chars().count() > 1 && matches!(phrase(name, &|_| None), Some((Phrase::Is, _)));
    if name.is_empty() || words::is_prose(name) || verb {
        return None;
    }
    if dollar > 0 {
        at += text.piece(at..).strip_prefix('$').map(|_| 1)?;
    }
    let place = Span::new(start, at);
    let gap = skip(text, at);
    // "f is" is a question or a claim without a word before it; "sei f die Ableitung" needs no second one.
    let length = match asking::copula(text.piece(gap..)) {
        Some((copula, length)) if introduced || copula == Copula::Sign => length,
        None if introduced => 0,
        _ => return None,
    };
    let rest = skip(text, gap + length);
    Some(Clause { name, place, rest: Span::new(rest, text.len()), introduced })
}

/// A place at which a text may go on after a definition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Continuation {
    /// The end of the definition.
    pub end: usize,
    /// Where the rest begins, behind the words that ask for it.
    start: usize,
    /// Whether words ask for it.
    pub asked: bool,
    /// Whether they say that it is a claim.
    pub claims: bool,
}

impl Continuation {
    /// What follows, without the signs of a question; `None` if that is nothing.
    pub(crate) fn rest(&self, text: &str) -> Option<Span> {
        trimmed(text, self.start)
    }
}

/// Where the text after a definition may go on, the last place first.
pub(crate) fn continuations(text: &str) -> Vec<Continuation> {
    let mut depth = 0_i32;
    let mut found = Vec::new();
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ',' | '.' | ';' | ':' if depth == 0 => {
                let after = at + c.len_utf8();
                if c != '.' || text.piece(after..).starts_with(char::is_whitespace) {
                    let (start, asked, claims) = after_asking(text, skip(text, after));
                    found.push(Continuation { end: at, start, asked, claims });
                }
            }
            _ => {}
        }
    }
    found.reverse();
    found
}

/// The place after words such as "given" that introduce definitions.
pub(crate) fn after_introduction(text: &str) -> usize {
    let mut at = skip(text, 0);
    while let Some(length) = asking::introduces(text.piece(at..)) {
        at = skip(text, at + length);
    }
    at
}

/// What a text asks for that begins with words such as "compute" and "show that", and whether it is a claim.
///
/// Shorter words may be products of letters: `so t`.
pub(crate) fn asked(text: &str) -> Option<(Span, bool)> {
    const SHORT: usize = 3;
    let start = skip(text, 0);
    let first = asking::asks(text.piece(start..))?;
    let word = text.piece(start..start + first.length);
    if word.is_ascii() && word.len() <= SHORT {
        return None;
    }
    let (start, _, claims) = after_asking(text, start);
    trimmed(text, start).map(|span| (span, claims))
}

/// The place after words that ask, whether there are some, and whether they say that a claim follows.
fn after_asking(text: &str, mut start: usize) -> (usize, bool, bool) {
    let (mut asked, mut claims) = (false, false);
    if !text.piece(start..).starts_with(char::is_alphabetic) {
        return (start, asked, claims);
    }
    while let Some(words) = asking::asks(text.piece(start..)) {
        start = skip(text, start + words.length);
        // Compute: 3 + 4
        if let Some(rest) = text.piece(start..).strip_prefix(':').filter(|rest| !rest.starts_with('=')) {
            start = skip(text, text.len() - rest.len());
        }
        asked = true;
        claims |= words.claims;
    }
    (start, asked, claims)
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
        let found = continuations(text)[0];
        assert_eq!(
            (text.piece(..found.end), text.piece(found.rest(text).unwrap().range())),
            ("the polar form of (t, 1)", "f(0)")
        );
    }

    #[test]
    fn what_is_asked_follows_words() {
        let of = |text: &'static str| asked(text).map(|(span, claims)| (text.piece(span.range()), claims));
        assert_eq!(of("Compute g(3)."), Some(("g(3)", false)));
        assert_eq!(of("zeige, dass a = a"), Some(("a = a", true)));
        assert_eq!(of("so t"), None);
    }
}
