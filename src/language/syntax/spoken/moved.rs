//! Phrases that mean something at another place than they stand at: where a curve crosses a line, whether it passes through a
//! point, the name of an object beside its kind.

use crate::formula::source::{Pieces, Span};
use crate::language::lexicon::phrases::{Label, Phrase};
use crate::language::syntax::pieces::{Part, begins_equation};

/// Where something vanishes are its roots; else it is claimed to be 0.
pub(super) fn vanishing(mut parts: Vec<Part>) -> Vec<Part> {
    let asks_where = parts.iter().any(|part| matches!(part, Part::Phrase(Phrase::Where, _)));
    while let Some(at) = parts.iter().position(|part| matches!(part, Part::Phrase(Phrase::Vanishes, _))) {
        let (Part::Piece(span) | Part::Phrase(_, span)) = parts[at];
        let meant: &[Phrase] = match asks_where {
            true => &[Phrase::Function("roots")],
            false => &[Phrase::Equals, Phrase::Degree(0)],
        };
        parts.splice(at..=at, meant.iter().map(|phrase| Part::Phrase(*phrase, span)));
    }
    // Where does the curve meet the line? That asks for no yes or no.
    if asks_where {
        parts.retain(|part| !matches!(part, Part::Phrase(Phrase::Is, _)));
    }
    parts
}

/// A curve that crosses a line meets it: (0, 0), (1, 2), (2, 0) crosses y = 1/2.
pub(super) fn crossings(text: &str, parts: &mut [Part]) {
    for at in 1..parts.len().saturating_sub(1) {
        if let (Part::Phrase(Phrase::Function("cross"), span), Part::Piece(line)) = (parts[at], parts[at + 1])
            && begins_equation(text.piece(line.range()))
        {
            parts[at] = Part::Phrase(Phrase::Function("intersections"), span);
        }
    }
}

/// A name for an object beside its kind says nothing more: the B-spline N(t) on 0, 1, 2, 3.
pub(super) fn names_of_objects(text: &str, parts: &mut Vec<Part>, known: &dyn Fn(&str) -> bool) {
    let kind = |part: &Part| {
        matches!(
            part,
            Part::Phrase(Phrase::Function("bspline_basis" | "bspline" | "bezier"), _)
                | Part::Phrase(Phrase::Curve, _)
        )
    };
    let name = |part: &Part| {
        let Part::Piece(span) = part else { return false };
        let piece = text.piece(span.range());
        let Some((letter, rest)) = piece.split_once('(') else { return false };
        let argument = rest.strip_suffix(')').unwrap_or_default();
        letter.chars().count() == 1
            && letter.chars().all(char::is_alphabetic)
            && matches!(argument, "t" | "u" | "x" | "s")
            && !known(letter)
    };
    let label = |part: &Part| matches!(part, Part::Phrase(Phrase::Label(_), _));
    let at = (1..parts.len().saturating_sub(1))
        .find(|at| kind(&parts[at - 1]) && name(&parts[*at]) && label(&parts[at + 1]));
    if let Some(at) = at {
        parts.remove(at);
    }
}

/// A number before a hyphen is a degree: the 3-blossom of t^2.
pub(super) fn degrees_before(text: &str, parts: &mut [Part]) {
    for at in 0..parts.len().saturating_sub(1) {
        let (Part::Piece(number), Part::Phrase(Phrase::Function("polar"), _)) = (parts[at], parts[at + 1])
        else {
            continue;
        };
        let piece = text.piece(number.range());
        let Some(digits) =
            piece.strip_suffix('-').filter(|digits| digits.bytes().all(|byte| byte.is_ascii_digit()))
        else {
            continue;
        };
        let Ok(degree) = digits.parse() else { continue };
        parts[at] = Part::Phrase(Phrase::Degree(degree), Span::new(number.start, number.end - 1));
        return;
    }
}

/// The letter of the form that is wanted: as a polynomial in t.
pub(super) fn in_letters(text: &str, parts: &mut Vec<Part>) {
    let at = (1..parts.len()).find(|at| {
        matches!((parts[at - 1], parts[*at]), (Part::Phrase(Phrase::Function("expand"), form), Part::Piece(letter))
            if matches!(text.piece(letter.range()), "t" | "x" | "u" | "s")
                && [" in", " of", " von", " en", " de", " di"].iter().any(|end| text.piece(form.range()).ends_with(end)))
    });
    if let Some(at) = at {
        parts.remove(at);
    }
}

/// Is the point (1, 1) on the curve (0, 0), (1, 2), (2, 0)? Does it lie on it?
pub(super) fn points_on_curves(text: &str, parts: &mut Vec<Part>) {
    let start = usize::from(matches!(parts.first(), Some(Part::Phrase(Phrase::Is, _))));
    let point = |part: &Part| {
        matches!(part, Part::Piece(span) if {
            let piece = text.piece(span.range());
            piece.starts_with('(') && piece.ends_with(')') && piece.matches('(').count() == 1 && !piece.contains(char::is_alphabetic)
        })
    };
    let (Some(own), Some(Part::Phrase(Phrase::Label(Label::Over | Label::In), span))) =
        (parts.get(start), parts.get(start + 1))
    else {
        return;
    };
    let curve = |part: &Part| {
        matches!(
            part,
            Part::Phrase(
                Phrase::Curve | Phrase::Function("bezier") | Phrase::Degree(_) | Phrase::Rational,
                _
            )
        )
    };
    if start == 0 || !point(own) || !parts.get(start + 2).is_some_and(curve) {
        return;
    }
    let (own, span) = (*own, *span);
    parts.drain(..start + 2);
    parts.insert(0, Part::Phrase(Phrase::Function("inversion"), span));
    parts.extend([Part::Phrase(Phrase::Label(Label::At), span), own]);
}

/// A function of two things whose name stands between them goes before both: the curve passes through the point.
pub(super) fn between(parts: &mut Vec<Part>) {
    let two = |part: &Part| matches!(part, Part::Phrase(Phrase::Function("inversion" | "intersections"), _));
    let Some(at) = parts.iter().position(two).filter(|at| *at > 0 && *at + 2 == parts.len()) else { return };
    if !parts[..at].iter().any(|part| matches!(part, Part::Piece(_))) {
        return;
    }
    let function = parts.remove(at);
    let (Part::Piece(span) | Part::Phrase(_, span)) = function;
    let label = match function {
        Part::Phrase(Phrase::Function("inversion"), _) => Label::At,
        _ => Label::With,
    };
    parts.insert(at, Part::Phrase(Phrase::Label(label), span));
    if matches!(parts.first(), Some(Part::Phrase(Phrase::Is, _))) {
        parts.remove(0);
    }
    parts.insert(0, function);
}
