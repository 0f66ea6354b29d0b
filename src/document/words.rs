//! Words as they are read: without the commands of LaTeX for letters with accents.

use std::borrow::Cow;

use super::{Document, notebook};
use crate::formula::source::{Pieces, Span};

impl Document {
    /// The words of a span as they are read: `f\"ur` is für.
    pub fn words(&self, span: Span) -> Cow<'_, str> {
        match self.source(span) {
            Cow::Borrowed(text) => without_accents(text),
            Cow::Owned(text) => Cow::Owned(without_accents(&text).into_owned()),
        }
    }

    /// What the author wrote there; of a notebook, what it says in its strings.
    pub fn source(&self, span: Span) -> Cow<'_, str> {
        let text = self.file.slice(span);
        if self.escaped { Cow::Owned(notebook::decoded(text)) } else { Cow::Borrowed(text) }
    }
}

/// Accents of LaTeX, and what joins a letter to them in Unicode.
const ACCENTS: &[(char, char)] = &[
    ('"', '\u{308}'),
    ('\'', '\u{301}'),
    ('`', '\u{300}'),
    ('^', '\u{302}'),
    ('~', '\u{303}'),
    ('c', '\u{327}'),
    ('v', '\u{30c}'),
];

/// Letters with a command of their own.
const LETTERS: &[(&str, &str)] =
    &[("ss", "ß"), ("oe", "œ"), ("OE", "Œ"), ("ae", "æ"), ("AE", "Æ"), ("o", "ø"), ("O", "Ø")];

/// A text with letters in the place of `\"u`, `\'{e}`, `{\"o}`, `\c{c}`, `\ss`, and of `"u` within a word.
///
/// Cost: linear.
pub(super) fn without_accents(text: &str) -> Cow<'_, str> {
    if !text.contains(['\\', '"']) {
        return Cow::Borrowed(text);
    }
    let mut found = String::with_capacity(text.len());
    let mut at = 0;
    while let Some(next) = text.piece(at..).chars().next() {
        let letter = match next {
            '{' => accent(text, at + 1)
                .filter(|(_, end)| text.piece(*end..).starts_with('}'))
                .map(|(letter, end)| (letter, end + 1)),
            '\\' => accent(text, at),
            // The shorthand of German texts; between words it is a quotation mark.
            '"' if found.ends_with(char::is_alphabetic) => {
                let vowel = text.piece(at + 1..).chars().next().filter(|c| "aouAOU".contains(*c));
                vowel.and_then(|c| composed(c, '\u{308}')).map(|c| (c.to_string(), at + 2))
            }
            _ => None,
        };
        match letter {
            Some((letter, end)) => {
                found.push_str(&letter);
                at = end;
            }
            None => {
                found.push(next);
                at += next.len_utf8();
            }
        }
    }
    Cow::Owned(found)
}

/// The letter that a command at `at` writes, and the byte after it.
fn accent(text: &str, at: usize) -> Option<(String, usize)> {
    let rest = text.piece(at..).strip_prefix('\\')?;
    let whole = |name: &&(&str, &str)| {
        rest.strip_prefix(name.0).is_some_and(|after| !after.starts_with(|c: char| c.is_ascii_alphabetic()))
    };
    if let Some((name, letter)) = LETTERS.iter().find(whole) {
        let end = at + 1 + name.len();
        let after = text.piece(end..);
        let end = match after.strip_prefix("{}") {
            Some(_) => end + 2,
            None => end + after.len() - after.trim_start_matches(' ').len(),
        };
        return Some(((*letter).to_owned(), end));
    }
    let sign = rest.chars().next()?;
    let (_, mark) = ACCENTS.iter().find(|(known, _)| *known == sign)?;
    let after = text.piece(at + 2..);
    let inner = after.trim_start_matches(' ');
    // \c c and \v{s}, but not \vec and \cite
    if sign.is_ascii_alphabetic() && !inner.starts_with('{') && inner.len() == after.len() {
        return None;
    }
    let (body, closed) = match inner.strip_prefix('{') {
        Some(body) => (body, true),
        None => (inner, false),
    };
    let body = body.strip_prefix("\\i").map_or(body, |_| body.piece(1..));
    let letter = body.chars().next()?;
    let composed = composed(letter, *mark)?;
    let end = text.len() - body.len() + letter.len_utf8();
    if closed && !text.piece(end..).starts_with('}') {
        return None;
    }
    Some((composed.to_string(), end + usize::from(closed)))
}

/// The letters with accents of the languages that are read, each with its parts.
const COMPOSED: &str = "äa\u{308}öo\u{308}üu\u{308}ÄA\u{308}ÖO\u{308}ÜU\u{308}ëe\u{308}ïi\u{308}ée\u{301}áa\u{301}íi\u{301}óo\u{301}úu\u{301}\
     ÉE\u{301}èe\u{300}àa\u{300}ùu\u{300}òo\u{300}ìi\u{300}ÈE\u{300}ÀA\u{300}êe\u{302}âa\u{302}îi\u{302}ôo\u{302}ûu\u{302}ÊE\u{302}ÎI\u{302}\
     ñn\u{303}ãa\u{303}õo\u{303}çc\u{327}ÇC\u{327}čc\u{30c}šs\u{30c}žz\u{30c}";

fn composed(letter: char, mark: char) -> Option<char> {
    let all: Vec<char> = COMPOSED.chars().filter(|c| !c.is_whitespace()).collect();
    all.chunks(3).find(|parts| parts[1] == letter && parts[2] == mark).map(|parts| parts[0])
}

/// The label right after byte `at`, if one stands there.
pub(super) fn label_after(text: &str, at: usize) -> Option<String> {
    let mut rest = text.piece(at..).trim_start();
    if rest.starts_with('[') {
        rest = rest.piece(rest.find(']')? + 1..).trim_start();
    }
    let label = rest.strip_prefix(r"\label{")?;
    Some(label.piece(..label.find('}')?).trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_with_accents() {
        for (written, read) in [
            (r#"f\"ur B\'ezier"#, "für Bézier"),
            (r#"Graderh{\"o}hung, gr\"{o}\ss er, Stra\ss{}e"#, "Graderhöhung, größer, Straße"),
            (r"\'el\`eve, no\^{\i}tre, fa\c{c}on, c\oe ur", "élève, noître, façon, cœur"),
            (r#"f"ur, "Uber" und "gut""#, r#"für, "Uber" und "gut""#),
            (r"\vec, \cite{a}, \ref{main}, a\\b", r"\vec, \cite{a}, \ref{main}, a\\b"),
            ("été", "été"),
        ] {
            assert_eq!(without_accents(written), read);
        }
    }

    #[test]
    fn labels_of_environments() {
        assert_eq!(label_after(r"\begin{x}[of N] \label{ a:b } c", 9).as_deref(), Some("a:b"));
        assert_eq!(label_after(r"\begin{x} text \label{a}", 9), None);
        assert_eq!(label_after(r"\begin{x}[", 9), None);
    }
}
