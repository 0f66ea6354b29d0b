//! Whether the words of a text ask for anything.

use super::{Request, Said, pairs};
use crate::formula::source::Pieces;
use crate::language::lexicon::phrases::{Label, Phrase};
use crate::language::syntax::pieces::{Part, begins_equation, is_several};

/// Whether a function is named, or what is said needs one.
pub(super) fn is_request(text: &str, parts: &[Part]) -> bool {
    let named = |part: &Part| {
        let names = |phrase: &Phrase| match phrase {
            Phrase::Function(_)
            | Phrase::Command(_)
            | Phrase::Part(..)
            | Phrase::Total(_)
            | Phrase::Between(_)
            | Phrase::Which
            | Phrase::Takes
            | Phrase::TrueDegree
            | Phrase::Uniform
            | Phrase::Vanishes
            | Phrase::Multiaffine
            | Phrase::Equals => true,
            // N_{0,2}(1/2) for the knots 0, 1, 2, 3
            Phrase::Label(label) => label.names_values(),
            _ => false,
        };
        matches!(part, Part::Phrase(phrase, _) if names(phrase))
    };
    let label =
        |part: &Part| matches!(part, Part::Phrase(Phrase::Label(label), _) if label.function().is_some());
    let labelled =
        parts.windows(2).any(|pair| label(&pair[0]) && matches!(pair[1], Part::Phrase(Phrase::Of, _)));
    let curve = parts.windows(2).any(|pair| {
        matches!(pair[0], Part::Phrase(Phrase::Curve, _))
            && matches!(pair[1], Part::Piece(span)
                if is_several(text.piece(span.range())) && !begins_equation(text.piece(span.range())))
    });
    let polite = matches!(parts.first(), Some(Part::Phrase(Phrase::Filler, _)))
        || matches!(parts.last(), Some(Part::Phrase(Phrase::Filler, _)));
    // bspline(2, [0, 0, 0, 1, 1, 1], [1, 2, 3]) at 1/2
    let valued = matches!(parts,
        [Part::Piece(_), Part::Phrase(Phrase::Label(Label::At), _), Part::Piece(at)]
            if !text.piece(at.range()).contains('='));
    // the rational quadratic (0, 0), (1, 2), (2, 0)
    let qualified = parts.windows(2).any(|pair| {
        matches!(pair[0], Part::Phrase(Phrase::Rational | Phrase::Degree(_), _))
            && matches!(pair[1], Part::Piece(span) if is_several(text.piece(span.range())))
    });
    // elevate(c) twice
    let repeated = matches!(parts, [Part::Piece(called), Part::Phrase(Phrase::Ordinal(_), _)]
        if text.piece(called.range()).ends_with(')'));
    // are 0, 1, 2 and 2, 3, 5 C^1?
    let smooth = parts.iter().any(|part| {
        matches!(part, Part::Piece(span)
            if text.piece(span.range()).split_whitespace().next_back().is_some_and(pairs::is_order))
    });
    // given b0 = 1, b1 = 3, b2 = 1, at 1/2
    let member = |part: &&Part| is_member(text, part);
    let at = |part: &Part| matches!(part, Part::Phrase(Phrase::Label(Label::At) | Phrase::Place(_), _));
    let given = parts.iter().filter(member).count() > 1 && parts.iter().any(at);
    parts.iter().any(named)
        || polite
        || labelled
        || valued
        || qualified
        || smooth
        || given
        || curve
        || repeated
}

/// Whether a value is asked for of something that was said before, or members are given of which something is asked behind.
pub(super) fn is_about_something(text: &str, parts: &[Part]) -> bool {
    let value = |part: &Part| matches!(part, Part::Phrase(Phrase::Label(Label::At) | Phrase::Place(_), _));
    let points = parts.windows(2).any(|pair| {
        matches!(pair[0], Part::Phrase(Phrase::Label(Label::Points) | Phrase::Function("in_bernstein"), _))
            && matches!(pair[1], Part::Piece(span) if is_several(text.piece(span.range())))
    });
    points || parts.iter().any(value) || parts.iter().filter(|part| is_member(text, part)).count() > 1
}

/// b1 = 3
fn is_member(text: &str, part: &Part) -> bool {
    matches!(part, Part::Piece(span) if {
        let piece = text.piece(span.range());
        let index = piece.trim_start_matches(char::is_alphabetic).trim_start_matches(['_', '{']);
        begins_equation(&piece.replace(['{', '}'], "")) && index.starts_with(|c: char| c.is_ascii_digit())
    })
}

/// From one basis to another: `Bernstein to monomials: 1, 0, 2` are the monomials of what is given in the first.
pub(super) fn from_one_to_another(mut parts: Vec<Part>) -> Vec<Part> {
    let basis = |part: &Part| {
        matches!(
            part,
            Part::Phrase(Phrase::Function("in_bernstein" | "expand" | "bezier" | "bezier_points"), _)
        )
    };
    let start = usize::from(matches!(parts.first(), Some(Part::Phrase(Phrase::Label(Label::From), _))));
    if let Some([from, Part::Phrase(Phrase::Label(Label::To), _), to, Part::Piece(_)]) =
        parts.get(start..start + 4)
        && basis(from)
        && basis(to)
    {
        let (from, to) = (*from, *to);
        parts.splice(..start + 3, [to, from]);
    }
    parts
}

impl Request {
    /// What is said besides.
    pub(super) fn labels(&mut self) -> Option<&mut Vec<Said>> {
        match self {
            Request::Formula(_, labels) => Some(labels),
            Request::Call(call) => Some(&mut call.labels),
            Request::Total(_)
            | Request::Joined(..)
            | Request::Added(_)
            | Request::Curves(_)
            | Request::Count(_) => None,
        }
    }

    /// Whether a place is said.
    pub(super) fn has_place(&self) -> bool {
        let place = |said: &Said| said.label == Label::At;
        match self {
            Request::Formula(_, labels) => labels.iter().any(place),
            Request::Call(call) => {
                call.labels.iter().any(place) || call.subject.as_ref().is_some_and(|inner| inner.has_place())
            }
            _ => false,
        }
    }

    /// Whether it may be said what value it has.
    pub(super) fn has_value(&self) -> bool {
        match self {
            Request::Call(_) | Request::Total(_) | Request::Added(_) => true,
            // the cubic 0, 1, 3, 1 has the value 2 at 1/2
            Request::Formula(items, labels) => !items.is_empty() && !labels.is_empty(),
            _ => false,
        }
    }
}
