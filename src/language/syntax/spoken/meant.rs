//! What phrases mean beside each other, before the request is read: Bernstein coefficients that are given are points, a cubic
//! spline with control points is a B-spline.

use crate::formula::source::Pieces;
use crate::language::lexicon::phrases::{Label, Phrase};
use crate::language::syntax::pieces::{Part, begins_equation, is_several};

/// The parts of a request with the phrases in place of which others are meant.
pub(super) fn settled(text: &str, mut parts: Vec<Part>) -> Vec<Part> {
    given_in_bernstein(text, &mut parts);
    splines(&mut parts);
    formulas_in_bernstein(text, &mut parts);
    applied(&mut parts);
    parts
}

fn several(text: &str, part: Option<&Part>) -> bool {
    matches!(part, Some(Part::Piece(span)) if {
        let piece = text.piece(span.range());
        is_several(piece) && !begins_equation(piece)
    })
}

/// The quadratic with Bernstein coefficients 0, 2, 1; the Bernstein polynomial with coefficients 1, 0, 1.
fn given_in_bernstein(text: &str, parts: &mut [Part]) {
    // The product of forms knows what they are.
    if parts.iter().any(|part| matches!(part, Part::Phrase(Phrase::Total(_), _))) {
        return;
    }
    for at in 0..parts.len() {
        let Part::Phrase(Phrase::Function(name @ ("in_bernstein" | "bernstein")), span) = parts[at] else { continue };
        if name == "in_bernstein" && several(text, parts.get(at + 1)) {
            parts[at] = Part::Phrase(Phrase::Label(Label::Points), span);
            continue;
        }
        let between = |part: &&Part| matches!(part, Part::Phrase(Phrase::Of | Phrase::Label(Label::With), _));
        let skipped = parts.iter().skip(at + 1).take_while(between).count();
        let data = parts.get(at + 1 + skipped..).unwrap_or_default();
        let points = matches!(
            data.first(),
            Some(Part::Phrase(
                Phrase::Label(Label::Points | Label::Values) | Phrase::Function("control_points" | "bezier_points"),
                _
            ))
        ) && several(text, data.get(1));
        if points {
            parts[at] = Part::Phrase(Phrase::Function("bezier"), span);
        }
    }
}

/// A cubic spline with control points is a B-spline, no interpolant.
fn splines(parts: &mut Vec<Part>) {
    let says = |own: &dyn Fn(Phrase) -> bool| {
        parts.iter().any(|part| matches!(part, Part::Phrase(phrase, _) if own(*phrase)))
    };
    let points = says(&|phrase| {
        matches!(phrase, Phrase::Label(Label::Points) | Phrase::Function("control_points") | Phrase::Uniform)
    });
    let values = says(&|phrase| matches!(phrase, Phrase::Label(Label::Values | Label::Nodes)));
    if !points || values {
        return;
    }
    if let Some(at) =
        parts.iter().position(|part| matches!(part, Part::Phrase(Phrase::Function("cubic_spline"), _)))
    {
        let Part::Phrase(_, span) = parts[at] else { return };
        parts.splice(
            at..=at,
            [Part::Phrase(Phrase::Degree(3), span), Part::Phrase(Phrase::Function("bspline"), span)],
        );
    }
}

/// A polynomial as a Bernstein polynomial is one in that form.
fn formulas_in_bernstein(text: &str, parts: &mut [Part]) {
    let formula = matches!(parts.first(), Some(part @ Part::Piece(_)) if !several(text, Some(part)));
    if !formula {
        return;
    }
    for at in 1..parts.len() {
        if let (Part::Phrase(Phrase::Function("bernstein"), span), Part::Phrase(Phrase::Label(Label::To | Label::In), _)) =
            (parts[at], parts[at - 1])
        {
            parts[at] = Part::Phrase(Phrase::Function("in_bernstein"), span);
        }
    }
}

/// What a function is applied to, where it stands behind what is said of the function: apply the operator of degree 3 to x^2.
fn applied(parts: &mut Vec<Part>) {
    let command = parts.iter().position(|part| matches!(part, Part::Phrase(Phrase::Apply, _)));
    if let Some(at) = command {
        parts.remove(at);
    }
    let to = |part: &Part| match part {
        Part::Phrase(Phrase::AppliedTo, _) => true,
        Part::Phrase(Phrase::Label(Label::To | Label::Over), _) => command.is_some(),
        _ => false,
    };
    let Some(at) = parts.iter().position(to) else { return };
    let function = parts.iter().position(|part| matches!(part, Part::Phrase(Phrase::Function(_), _)));
    if let (Some(function), Some(Part::Piece(_))) = (function.filter(|own| *own < at), parts.get(at + 1)) {
        let object: Vec<Part> = parts.drain(at..at + 2).skip(1).collect();
        parts.splice(function + 1..function + 1, object);
    }
}
