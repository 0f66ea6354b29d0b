//! Problems, places and words as JSON.

use polarform::diagnostic::{Diagnostic, render_json};
use polarform::source::{SourceFile, Span};
use polarform::syntax::parse;
use polarform::write::latex;
use serde_json::{Value, json};

use super::typst::typst;

/// So many UTF-16 code units stand before a byte.
pub(crate) fn units(text: &str, byte: usize) -> usize {
    let mut end = byte.min(text.len());
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    text.get(..end).map_or(0, |before| before.encode_utf16().count())
}

/// Places of a text in the order in which they are asked for, each counted on from the one before.
pub(crate) struct Places<'a> {
    text: &'a str,
    byte: usize,
    unit: usize,
}

impl<'a> Places<'a> {
    pub fn new(text: &'a str) -> Self {
        Places { text, byte: 0, unit: 0 }
    }

    pub fn unit(&mut self, byte: usize) -> usize {
        if byte < self.byte {
            (self.byte, self.unit) = (0, 0);
        }
        self.unit += units(&self.text[self.byte..], byte - self.byte);
        self.byte = byte.min(self.text.len());
        self.unit
    }

    pub fn of(&mut self, span: Span) -> (usize, usize) {
        let from = self.unit(span.start);
        (from, self.unit(span.end))
    }
}

/// A problem as the program tells it as JSON, and with its place as `from` and `to`. Hints on options of the program
/// are left out: here is nothing to put them in.
pub(crate) fn problem(problem: &Diagnostic, file: &SourceFile) -> Value {
    let mut problem = problem.clone();
    problem.hints.retain(|hint| !hint.contains("--"));
    let mut told = render_json(&problem, file);
    if let Some(span) = problem.span {
        told["from"] = units(file.text(), span.start).into();
        told["to"] = units(file.text(), span.end).into();
    }
    told
}

/// Words with formulas between backticks as pieces: `{"words"}`, and `{"latex", "typst"}`.
pub(crate) fn words(words: &str) -> Vec<Value> {
    let pieces = words.split('`').enumerate().filter(|(_, piece)| !piece.is_empty());
    pieces
        .map(|(i, piece)| match parse(piece) {
            Ok(formula) if i % 2 == 1 => {
                let latex = latex(&formula);
                json!({"typst": typst(&latex), "latex": latex})
            }
            _ => json!({"words": piece}),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_count_as_browsers_do() {
        let text = "a𝕋é多b";
        assert_eq!(units(text, text.len()), "a𝕋é多b".encode_utf16().count());
        let mut places = Places::new(text);
        assert_eq!(places.of(Span::new(1, 5)), (1, 3));
        assert_eq!(places.of(Span::new(5, 7)), (3, 4));
        assert_eq!(places.of(Span::new(0, 1)), (0, 1));
    }

    #[test]
    fn formulas_among_words() {
        assert_eq!(
            words("the mean of `t_1^2` < 1"),
            [
                json!({"words": "the mean of "}),
                json!({"typst": "t_(1)^(2)", "latex": "t_1^2"}),
                json!({"words": " < 1"})
            ]
        );
    }
}
