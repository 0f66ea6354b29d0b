//! Numbers that follow from each other: how many control points a spline has by its degree and its knots, how smooth it is at a
//! knot of some multiplicity.

use super::{Reader, Request, What};
use crate::formula::source::{Pieces, Span};
use crate::language::lexicon::phrases::{Label, Phrase};
use crate::language::syntax::pieces::Part;

/// What a number counts.
#[derive(Clone, Copy, PartialEq)]
enum Of {
    Degree,
    Knots,
    Points,
    Multiplicity,
}

/// A sum of numbers: each with whether it is subtracted.
pub(crate) type Count = Vec<(bool, What)>;

impl Reader<'_> {
    /// What is counted, by what else is said; `None` if anything else is said besides.
    pub(super) fn counted(&self) -> Option<Request> {
        let mut known: Vec<(Of, What)> = Vec::new();
        let (mut wanted, mut spline, mut bezier, mut smooth) = (None, false, false, false);
        let mut at = 0;
        while let Some(part) = self.parts.get(at) {
            let next = self.parts.get(at + 1);
            at += 1;
            match part {
                Part::Phrase(Phrase::Function("length"), _) if wanted.is_none() && !smooth => {
                    wanted = Some(next.and_then(counted_by)?);
                    at += 1;
                }
                Part::Phrase(Phrase::Function("smoothness" | "continuity"), _)
                    if !smooth && wanted.is_none() =>
                {
                    smooth = true;
                }
                Part::Phrase(Phrase::Label(Label::OfDegree), _) => match next {
                    Some(Part::Piece(span)) => {
                        known.push((Of::Degree, self.number(*span)?));
                        at += 1;
                    }
                    _ if wanted.is_none() && !smooth => wanted = Some(Of::Degree),
                    _ => return None,
                },
                Part::Phrase(Phrase::Label(Label::Multiplicity), _) => {
                    let Some(Part::Piece(span)) = next else { return None };
                    known.push((Of::Multiplicity, self.number(*span)?));
                    at += 1;
                }
                Part::Phrase(Phrase::Multiplicity(number), _) => {
                    known.push((Of::Multiplicity, What::Degree(*number)));
                }
                Part::Phrase(Phrase::Degree(degree), _) => known.push((Of::Degree, What::Degree(*degree))),
                Part::Phrase(Phrase::Function("cubic_spline"), _) => {
                    spline = true;
                    known.push((Of::Degree, What::Degree(3)));
                }
                Part::Phrase(Phrase::Function("bspline" | "bspline_basis"), _) => spline = true,
                Part::Phrase(Phrase::Function("bezier"), _) => bezier = true,
                Part::Phrase(
                    Phrase::Of
                    | Phrase::And
                    | Phrase::Is
                    | Phrase::Label(Label::With | Label::At | Label::To | Label::In),
                    _,
                ) => {}
                Part::Piece(span) => {
                    known.push((next.and_then(counted_by)?, self.number(*span)?));
                    at += 1;
                }
                Part::Phrase(..) => return None,
            }
        }
        let one = |of: Of| {
            let mut own = known.iter().filter(|(known, _)| *known == of).map(|(_, number)| *number);
            own.next().filter(|_| own.next().is_none())
        };
        let unit = What::Degree(1);
        let count: Count = match (wanted, smooth, known.len()) {
            (None, true, 2) => vec![(false, one(Of::Degree)?), (true, one(Of::Multiplicity)?)],
            (Some(Of::Points), false, 1) if bezier && !spline => {
                vec![(false, one(Of::Degree)?), (false, unit)]
            }
            (Some(Of::Degree), false, 1) if bezier && !spline => {
                vec![(false, one(Of::Points)?), (true, unit)]
            }
            _ if bezier => return None,
            (Some(Of::Points), false, 2) => {
                vec![(false, one(Of::Knots)?), (true, one(Of::Degree)?), (true, unit)]
            }
            (Some(Of::Knots), false, 2) => {
                vec![(false, one(Of::Points)?), (false, one(Of::Degree)?), (false, unit)]
            }
            (Some(Of::Degree), false, 2) => {
                vec![(false, one(Of::Knots)?), (true, one(Of::Points)?), (true, unit)]
            }
            _ => return None,
        };
        Some(Request::Count(count))
    }

    /// A whole number that stands by itself.
    fn number(&self, span: Span) -> Option<What> {
        let text = self.text.piece(span.range());
        let whole = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        let letter = text.chars().all(char::is_alphabetic) && text.chars().count() == 1;
        (whole || letter).then_some(What::Formula(span))
    }
}

/// 11 knots
fn counted_by(part: &Part) -> Option<Of> {
    match part {
        Part::Phrase(Phrase::Label(Label::Knots), _) => Some(Of::Knots),
        Part::Phrase(Phrase::Function("control_points") | Phrase::Label(Label::Points), _) => {
            Some(Of::Points)
        }
        _ => None,
    }
}
