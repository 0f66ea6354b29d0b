//! A function that conditions determine: `cubic p with p(0) = 0, p'(0) = 1, p(1) = 2, p'(1) = 0`,
//! `given f(0,0) = 1, f(0,1) = 3, f(1,1) = 2, find f(2,2)`.

use super::clauses::after_introduction;
use super::pieces::{Part, has_words, parts, without_text_commands};
use crate::formula::source::{Pieces, Span};
use crate::language::lexicon::asking;
use crate::language::lexicon::phrases::{Label, Phrase};

/// A function that is asked for by conditions.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Unknown {
    /// Its degree, if a word says it.
    pub degree: Option<i64>,
    /// Whether a word says that it interpolates: its degree is as small as it can be.
    pub interpolates: bool,
    /// Where the conditions stand, each perhaps several.
    pub conditions: Vec<Span>,
    /// What is asked about it; else the function itself.
    pub asked: Option<Span>,
    /// The function that gives the form in which it is wanted: as Bézier curve.
    pub form: Option<&'static str>,
}

/// The function that a text asks for by conditions; `None` if it is no such text, or not all of its words are known.
pub(crate) fn unknown(
    text: &str,
    known: &dyn Fn(&str) -> bool,
    function: &dyn Fn(&str) -> Option<&'static str>,
) -> Option<Unknown> {
    // No condition without a sign of equality: most lines need no words looked up.
    if !text.contains('=') {
        return None;
    }
    let masked = without_text_commands(text);
    // If f(0, 0) = 1, …
    let start = after_introduction(masked.as_ref());
    let mut masked = " ".repeat(start) + masked.piece(start..);
    // f is the blossom of a quadratic with …
    if let Some((name, rest)) = masked.piece(start..).split_once(' ')
        && name.chars().count() == 1
        && let Some((_, length)) = asking::copula(rest)
    {
        let from = masked.len() - rest.len();
        masked.replace_range(from..from + length, &" ".repeat(length));
    }
    let text = masked.as_str();
    let parts = parts(text, known, function);
    // Without a word it is a claim: f(0, 1) = 2.
    let says = |part: &Part| matches!(part, Part::Phrase(phrase, _) if *phrase != Phrase::And);
    if !parts.iter().any(says) {
        return None;
    }
    let mut found =
        Unknown { degree: None, interpolates: false, conditions: Vec::new(), asked: None, form: None };
    let mut name: Option<&str> = None;
    let mut parts = parts.into_iter().peekable();
    while let Some(part) = parts.next() {
        let span = match part {
            Part::Phrase(Phrase::Degree(degree), _) if found.degree.is_none() => {
                found.degree = Some(degree);
                continue;
            }
            Part::Phrase(Phrase::Label(Label::OfDegree), _) if found.degree.is_none() => {
                let Some(Part::Piece(number)) = parts.next() else { return None };
                found.degree = Some(text.piece(number.range()).parse().ok()?);
                continue;
            }
            Part::Phrase(Phrase::Function("hermite" | "lagrange") | Phrase::Command("lagrange"), _) => {
                found.interpolates = true;
                continue;
            }
            Part::Phrase(
                Phrase::Function(
                    "bezier" | "bezier_points" | "control_points" | "in_bernstein" | "bernstein",
                ),
                _,
            ) if found.form.is_none() && !found.conditions.is_empty() => {
                found.form = Some("bezier_points");
                continue;
            }
            Part::Phrase(Phrase::Label(Label::To | Label::In), _) if !found.conditions.is_empty() => continue,
            Part::Phrase(
                Phrase::Filler
                | Phrase::Curve
                | Phrase::Of
                | Phrase::And
                | Phrase::Has
                | Phrase::Multiaffine
                | Phrase::Function("polar")
                | Phrase::Label(Label::With | Label::Values),
                _,
            ) => continue,
            Part::Phrase(..) => return None,
            Part::Piece(span) => span,
        };
        let piece = text.piece(span.range());
        if has_words(piece, known) || found.asked.is_some() {
            return None;
        }
        match condition(piece) {
            Some(own) if name.is_none_or(|name| name == own) => {
                name = Some(own);
                found.conditions.push(span);
            }
            // F biaffine
            None if name == Some(piece) => {}
            // the cubic p
            None if found.conditions.is_empty() && piece.chars().all(char::is_alphabetic) => {
                if name.replace(piece).is_some() {
                    return None;
                }
            }
            None if !found.conditions.is_empty() && !piece.contains('=') => found.asked = Some(span),
            _ => return None,
        }
    }
    let name = name.filter(|name| !known(name) && function(name).is_none())?;
    let asks = found.asked.is_none_or(|span| text.piece(span.range()).contains(name));
    (!found.conditions.is_empty() && asks && (found.form.is_none() || found.asked.is_none())).then_some(found)
}

/// Where the letter of an object stands before what it has: F in "the cubic F has the points 0, 1, 3, 2".
pub(crate) fn letter_of_object(text: &str, function: &dyn Fn(&str) -> Option<&'static str>) -> Option<Span> {
    let masked = without_text_commands(text);
    let parts = parts(masked.as_ref(), &|_| false, function);
    let has = |part: &Part| {
        matches!(
            part,
            Part::Phrase(
                Phrase::Has
                    | Phrase::Takes
                    | Phrase::Label(Label::With | Label::Points | Label::Knots | Label::Through),
                _
            )
        )
    };
    let kind = |part: &Part| {
        matches!(
            part,
            Part::Phrase(Phrase::Degree(_) | Phrase::Curve | Phrase::Rational | Phrase::Function(_), _)
                | Part::Phrase(Phrase::Filler, _)
        )
    };
    let kinds = parts.iter().take_while(|part| kind(part)).count();
    let named = parts.iter().take(kinds).any(|part| !matches!(part, Part::Phrase(Phrase::Filler, _)));
    match parts.get(kinds..)? {
        [Part::Piece(span), next, ..] if named && has(next) => {
            let letter = masked.piece(span.range()).trim_matches('$');
            (letter.chars().count() == 1 && letter.starts_with(char::is_alphabetic)).then_some(*span)
        }
        _ => None,
    }
}

/// The function of which a text gives a value: p'(0) = 1.
fn condition(piece: &str) -> Option<&str> {
    let end = piece.find(|c: char| !c.is_alphabetic())?;
    let rest = piece.piece(end..).trim_start_matches(['\'', '′', '’']);
    (end > 0 && rest.starts_with('(') && rest.contains('=')).then(|| piece.piece(..end))
}
