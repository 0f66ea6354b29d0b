//! What phrases mean beside each other, before the request is read: Bernstein coefficients that are given are points, a cubic
//! spline with control points is a B-spline.

use super::asks;
use super::moved::{
    between, crossings, degrees_before, in_letters, names_of_objects, points_on_curves, vanishing,
};
use super::pairs::is_order;
use crate::formula::source::{Pieces, Span};
use crate::language::lexicon::phrases::{Label, Phrase};
use crate::language::syntax::pieces::{Part, begins_equation, is_several};

/// The parts of a request that say something, as they are meant; `None` if a place is asked for that nothing tells.
pub(super) fn told(text: &str, parts: Vec<Part>, known: &dyn Fn(&str) -> bool) -> Option<Vec<Part>> {
    // A note tells where a largest value is taken; of other functions it is not known.
    let extreme = |part: &Part| {
        matches!(
            part,
            Part::Phrase(
                Phrase::Function(
                    "maximum"
                        | "minimum"
                        | "max"
                        | "min"
                        | "support"
                        | "roots"
                        | "critical_points"
                        | "inflections"
                        | "intersections"
                        | "double_points"
                        | "cusps"
                        | "cross"
                ) | Phrase::Command("maximum" | "minimum" | "max" | "min" | "intersections")
                    | Phrase::Vanishes,
                _
            )
        )
    };
    if parts.iter().any(|part| matches!(part, Part::Phrase(Phrase::Where, _))) && !parts.iter().any(extreme) {
        return None;
    }
    let says = |part: &Part| !matches!(part, Part::Phrase(Phrase::Filler | Phrase::Where, _));
    let parts = vanishing(parts);
    let parts: Vec<Part> = parts.into_iter().filter(says).collect();
    Some(settled(text, asks::from_one_to_another(parts), known))
}

/// The parts of a request with the phrases in place of which others are meant.
fn settled(text: &str, mut parts: Vec<Part>, known: &dyn Fn(&str) -> bool) -> Vec<Part> {
    names_of_objects(text, &mut parts, known);
    points_on_curves(text, &mut parts);
    degrees_before(text, &mut parts);
    in_letters(text, &mut parts);
    methods(&mut parts);
    crossings(text, &mut parts);
    between(&mut parts);
    ends(&mut parts);
    of_derivative(&mut parts);
    basis_function(text, &mut parts);
    of_points(&mut parts);
    properties(&mut parts);
    steps(&mut parts);
    curves(text, &mut parts);
    behind(text, &mut parts);
    weights(text, &mut parts);
    continuations(text, &mut parts);
    true_degrees(text, &mut parts);
    given_in_bernstein(text, &mut parts);
    uniform_knots(&mut parts);
    splines(&mut parts);
    formulas_in_bernstein(text, &mut parts);
    applied(&mut parts);
    within(text, &mut parts);
    parts
}

/// A curve is reparametrized to a subinterval of its own by taking that part of it.
fn within(text: &str, parts: &mut [Part]) {
    let sub = |part: &Part| {
        matches!(part, Part::Phrase(Phrase::Label(Label::Over), span)
            if ["sub", "teil", "sous", "子"].iter().any(|start| text.piece(span.range()).to_lowercase().starts_with(start)))
    };
    let Some(_) = parts.iter().find(|part| sub(part)) else { return };
    for part in parts.iter_mut() {
        if let Part::Phrase(phrase @ Phrase::Command("over"), _) = part {
            *phrase = Phrase::Command("part");
        }
    }
}

/// One pair or triple of formulas with a letter: (t, t^2).
fn is_coordinates(text: &str, part: Option<&Part>) -> bool {
    matches!(part, Some(Part::Piece(span)) if {
        let inside = text.piece(span.range()).strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
        inside.is_some_and(|inside| inside.contains(['t', 'u', 's']) && !inside.contains(['_', '[']) && !inside.contains("),"))
    })
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
        let Part::Phrase(Phrase::Function(name @ ("in_bernstein" | "bernstein")), span) = parts[at] else {
            continue;
        };
        // bernstein(n, i) has two numbers.
        let numbers = matches!(parts.get(at + 1), Some(Part::Piece(span))
            if text.piece(span.range()).matches(',').count() > 1 && !text.piece(span.range()).contains(char::is_alphabetic));
        if name == "bernstein" && numbers {
            parts[at] = Part::Phrase(Phrase::Function("bezier"), span);
            continue;
        }
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
                Phrase::Label(Label::Points | Label::Values)
                    | Phrase::Function("control_points" | "bezier_points"),
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
        if let (
            Part::Phrase(Phrase::Function("bernstein"), span),
            Part::Phrase(Phrase::Label(Label::To | Label::In), _),
        ) = (parts[at], parts[at - 1])
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

/// The curve 0, 1, 3 is a Bézier curve; the curve y = x^2 is what its equation says.
fn curves(text: &str, parts: &mut Vec<Part>) {
    let other = |part: &Part| {
        matches!(
            part,
            Part::Phrase(
                Phrase::Label(Label::Knots | Label::Through | Label::Values | Label::Nodes)
                    | Phrase::Function(
                        "bezier"
                            | "bspline"
                            | "bspline_basis"
                            | "lagrange"
                            | "newton"
                            | "hermite"
                            | "cubic_spline"
                            | "continuity"
                            | "geometric_continuity"
                            | "insert_knots"
                    ),
                _
            )
        )
    };
    let others = parts.iter().any(other);
    let mut at = 0;
    while let Some(part) = parts.get(at) {
        let Part::Phrase(Phrase::Curve, span) = *part else {
            at += 1;
            continue;
        };
        let points = matches!(
            parts.get(at + 1),
            Some(Part::Phrase(
                Phrase::Label(Label::Points) | Phrase::Function("control_points" | "bezier_points"),
                _
            ))
        );
        let with =
            matches!(parts.get(at + 1), Some(Part::Phrase(Phrase::Label(Label::With) | Phrase::Of, _)))
                && matches!(
                    parts.get(at + 2),
                    Some(Part::Phrase(
                        Phrase::Label(Label::Points) | Phrase::Function("control_points" | "bezier_points"),
                        _
                    ))
                );
        let listed = several(text, parts.get(at + 1)) && !is_coordinates(text, parts.get(at + 1));
        if !others && (points || with || listed) {
            parts[at] = Part::Phrase(Phrase::Function("bezier"), span);
            // on the curve 0, 1, 3
            if at > 0
                && let Part::Phrase(Phrase::Label(Label::Over | Label::In | Label::With), place) =
                    parts[at - 1]
            {
                parts[at - 1] = Part::Phrase(Phrase::Of, place);
            }
            at += 1;
        } else {
            parts.remove(at);
        }
    }
}

/// The degree that is left when coefficients are 0: the true degree of the cubic 0, 1, 2, 3; is the cubic 0, 1, 2, 3 quadratic?
fn true_degrees(text: &str, parts: &mut Vec<Part>) {
    let expanded = |span| {
        [Part::Phrase(Phrase::Function("degree"), span), Part::Phrase(Phrase::Function("expand"), span)]
    };
    // is the cubic 0, 1, 2, 3 quadratic? has the curve 0, 1, 2, 3 the degree 1?
    if let Some((degree, list, quality)) = claimed_degree(text, parts) {
        let (Part::Piece(span) | Part::Phrase(_, span)) = list;
        let curve = Part::Phrase(Phrase::Function("bezier"), span);
        let [outer, inner] = expanded(span);
        *parts = vec![outer, inner];
        parts.extend(degree);
        parts.extend([curve, list, Part::Phrase(Phrase::Equals, span), quality]);
        return;
    }
    if let Some(at) = parts.iter().position(|part| matches!(part, Part::Phrase(Phrase::TrueDegree, _))) {
        let Part::Phrase(_, span) = parts[at] else { return };
        let own = parts.iter().any(|part| {
            matches!(part, Part::Phrase(Phrase::Function("bezier") | Phrase::Label(Label::Points), _))
        });
        parts.splice(at..=at, expanded(span));
        // of 0, 1, 2, 3
        let rest = parts.iter().skip(at + 2).position(|part| several(text, Some(part)));
        if let (Some(list), false) = (rest, own) {
            parts.insert(at + 2 + list, Part::Phrase(Phrase::Function("bezier"), span));
        }
    }
}

/// What something has, before it: the derivative 0 at 1/2 that the cubic 0, 1, 3, 1 has is its derivative, which equals 0.
fn properties(parts: &mut Vec<Part>) {
    while let Some(at) = parts.iter().position(|part| matches!(part, Part::Phrase(Phrase::Has, _))) {
        let Part::Phrase(_, span) = parts.remove(at) else { return };
        let ordinal = usize::from(matches!(parts.get(at), Some(Part::Phrase(Phrase::Ordinal(_), _))));
        if let (Some(Part::Phrase(Phrase::Function("derivative"), _)), Some(Part::Piece(_))) =
            (parts.get(at + ordinal), parts.get(at + ordinal + 1))
            && at > 0
        {
            let start = usize::from(matches!(parts.first(), Some(Part::Phrase(Phrase::Is, _))));
            let function: Vec<Part> =
                parts.splice(at..=at + ordinal, [Part::Phrase(Phrase::Equals, span)]).collect();
            parts.splice(start..start, function.into_iter().chain([Part::Phrase(Phrase::Of, span)]));
        }
    }
}

/// A kind of curve behind its points: evaluate 1, 3, 2 at 1/2 (bezier); a part that is cut off.
fn behind(text: &str, parts: &mut Vec<Part>) {
    let part = parts.iter().position(|part| matches!(part, Part::Phrase(Phrase::Part("subdivide", _), _)));
    let cut = parts.iter().rposition(|part| matches!(part, Part::Phrase(Phrase::Command("subdivide"), _)));
    if let (Some(part), Some(cut)) = (part, cut)
        && part < cut
    {
        parts.remove(cut);
    }
    let kind = |at: usize| matches!(parts.get(at), Some(Part::Phrase(Phrase::Function("bezier"), _)));
    let only = (0..parts.len()).filter(|at| kind(*at)).count() == 1;
    let place = (1..parts.len().saturating_sub(1)).find(|at| {
        kind(*at)
            && several(text, parts.get(at - 1))
            && matches!(parts.get(at + 1), Some(Part::Phrase(Phrase::Label(Label::Over | Label::At), _)))
            && !matches!(
                at.checked_sub(2).and_then(|at| parts.get(at)),
                Some(Part::Phrase(Phrase::Label(_), _))
            )
    });
    if let (Some(at), true) = (place, only) {
        parts.swap(at - 1, at);
        return;
    }
    let last = parts.len().saturating_sub(1);
    let Some(Part::Phrase(Phrase::Function("bezier"), span)) = parts.get(last).copied() else { return };
    let others =
        parts.iter().filter(|part| matches!(part, Part::Phrase(Phrase::Function("bezier"), _))).count();
    let list = parts.iter().position(|part| several(text, Some(part)));
    let bare = |at: usize| {
        at == 0
            || !matches!(
                parts.get(at - 1),
                Some(Part::Phrase(
                    Phrase::Label(_) | Phrase::Function("bezier_points" | "control_points"),
                    _
                ))
            )
    };
    if let Some(at) =
        list.filter(|at| others == 1 && *at > 0 && bare(*at) || others == 1 && at + 1 < last && bare(*at))
    {
        parts.truncate(last);
        parts.insert(at, Part::Phrase(Phrase::Function("bezier"), span));
    }
}

/// Weights that are brought to standard form: normalise the weights 1, 2, 4; the standard form of the weights 1, 2, 4.
fn weights(text: &str, parts: &mut Vec<Part>) {
    let of_weights = parts.iter().any(|part| matches!(part, Part::Phrase(Phrase::Label(Label::Weights), _)));
    if let Some(kind) =
        parts.iter().find(|part| matches!(part, Part::Phrase(Phrase::Function("conic_kind"), _))).copied()
    {
        // Ellipse, parabola or hyperbola: each is one of the answers.
        let named = |part: &Part| match part {
            Part::Phrase(Phrase::Degree(2), span) => {
                text.piece(span.range()).to_lowercase().starts_with("para")
            }
            Part::Phrase(
                Phrase::Is | Phrase::Or | Phrase::Function("bezier" | "bspline" | "conic_kind"),
                _,
            ) => true,
            _ => false,
        };
        parts.retain(|part| !named(part));
        parts.insert(0, kind);
        return;
    }
    // A vector is normalised in another way.
    if !of_weights
        && let Some(Part::Phrase(phrase @ Phrase::Command("standard_form"), _)) =
            parts.iter_mut().find(|part| matches!(part, Part::Phrase(Phrase::Command("standard_form"), _)))
    {
        *phrase = Phrase::Or;
        return;
    }
    let rational = of_weights || parts.iter().any(|part| matches!(part, Part::Phrase(Phrase::Rational, _)));
    if let (Some(Part::Phrase(Phrase::Function("expand"), span)), true) = (parts.first().copied(), rational)
        && text.piece(span.range()).to_lowercase().starts_with("standard")
        && parts.iter().any(|part| several(text, Some(part)))
        && !matches!(
            parts.get(1..3),
            Some([Part::Phrase(Phrase::Of, _), Part::Phrase(Phrase::Label(Label::Weights), _)])
        )
    {
        parts[0] = Part::Phrase(Phrase::Function("standard_form"), span);
        return;
    }
    let points = |part: &Part| {
        matches!(
            part,
            Part::Phrase(
                Phrase::Label(Label::Points) | Phrase::Function("bezier" | "control_points" | "bspline"),
                _
            )
        )
    };
    if !of_weights || parts.iter().any(points) {
        return;
    }
    let standard = |part: &Part| match part {
        Part::Phrase(Phrase::Function("expand"), span) => Some((*span, true)),
        Part::Phrase(Phrase::Command("standard_form"), span) => Some((*span, false)),
        _ => None,
    };
    let command = parts.iter().any(|part| matches!(standard(part), Some((_, false))));
    let Some(at) = parts.iter().position(|part| standard(part).is_some_and(|(_, form)| form != command))
    else {
        return;
    };
    let Some((span, _)) = standard(&parts[at]) else { return };
    parts.splice(
        at..=at,
        [
            Part::Phrase(Phrase::Function("weights"), span),
            Part::Phrase(Phrase::Function("standard_form"), span),
        ],
    );
    // to standard form
    if let [
        ..,
        Part::Phrase(Phrase::Label(Label::To | Label::In), _),
        Part::Phrase(Phrase::Function("expand"), _),
    ] = parts.as_slice()
    {
        parts.truncate(parts.len() - 2);
    }
}

/// The order to which a curve is continued, and how many control points that determines: continue 0, 1, 3 C^1, first two points.
fn continuations(text: &str, parts: &mut Vec<Part>) {
    let own = |part: &Part| {
        matches!(part, Part::Phrase(Phrase::Function("continuation") | Phrase::Command("continuation"), _))
    };
    if !parts.iter().any(own) {
        return;
    }
    let mut order = None;
    for at in 0..parts.len() {
        let Part::Piece(span) = parts[at] else { continue };
        let piece = text.piece(span.range());
        let Some(word) = piece.split_whitespace().next_back().filter(|word| is_order(word)) else { continue };
        let Ok(number) = word.trim_start_matches(['C', 'G', '^']).parse::<i64>() else { return };
        // Geometric continuity does not determine the points.
        if word.starts_with('G') {
            parts.push(Part::Phrase(Phrase::Or, span));
            return;
        }
        order = Some(number);
        let rest = piece.strip_suffix(word).unwrap_or(piece).trim_end_matches([',', ' ']);
        let phrase = Part::Phrase(Phrase::Ordinal(number), Span::new(span.end - word.len(), span.end));
        match rest.is_empty() {
            true => parts[at] = phrase,
            false => {
                parts.splice(at..=at, [Part::Piece(Span::new(span.start, span.start + rest.len())), phrase]);
            }
        }
        break;
    }
    let (Some(number), Some(from)) = (order, parts.iter().position(own)) else { return };
    let first = |part: &Part| matches!(part, Part::Phrase(Phrase::First(count), _) if *count == number + 1);
    if let Some(at) = parts.iter().skip(from).position(first) {
        parts.remove(from + at);
    }
    if let Some(Part::Phrase(
        Phrase::Function("control_points" | "bezier_points") | Phrase::Label(Label::Points),
        _,
    )) = parts.last()
    {
        parts.pop();
    }
}

/// 2 steps: how often stands before its word.
fn steps(parts: &mut [Part]) {
    for at in 0..parts.len().saturating_sub(1) {
        let label = at > 0 && matches!(parts[at - 1], Part::Phrase(Phrase::Label(_), _));
        if let (Part::Piece(_), Part::Phrase(Phrase::Label(Label::Times), _), false) =
            (parts[at], parts[at + 1], label)
            && at > 0
        {
            parts.swap(at, at + 1);
        }
    }
}

/// What a function gives is said behind it again: the quadratic with ordinates 0, 4, 0 restricted to [1/4, 1/2], new ordinates?
fn ends(parts: &mut Vec<Part>) {
    let function = parts.iter().any(|part| {
        matches!(
            part,
            Part::Phrase(
                Phrase::Command("part" | "elevate" | "reduce" | "insert_knots")
                    | Phrase::Function("part" | "elevate" | "reduce"),
                _
            )
        )
    });
    let label = matches!(
        parts.last(),
        Some(Part::Phrase(
            Phrase::Label(Label::Values | Label::Points)
                | Phrase::Function("control_points" | "bezier_points"),
            _
        ))
    );
    if function && label && matches!(parts.iter().rev().nth(1), Some(Part::Piece(_))) {
        parts.pop();
    }
}

/// The derivative control points of a curve are the control points of its derivative; so are the second derivative control points.
fn of_derivative(parts: &mut Vec<Part>) {
    let points = |part: Option<&Part>| {
        matches!(part, Some(Part::Phrase(Phrase::Function("control_points" | "bezier_points"), _)))
    };
    let at = (0..parts.len()).find(|at| {
        matches!(parts[*at], Part::Phrase(Phrase::Function("derivative"), _)) && points(parts.get(at + 1))
    });
    // derivative: control points 0, 1, 3
    if let Some(at) = at.filter(|at| !matches!(parts.get(at + 2), Some(Part::Piece(_)))) {
        let own = parts.remove(at + 1);
        let ordinal = at > 0 && matches!(parts[at - 1], Part::Phrase(Phrase::Ordinal(_), _));
        parts.insert(at - usize::from(ordinal), own);
    }
}

/// How something is done says nothing of what is asked: using de Casteljau's algorithm.
fn methods(parts: &mut Vec<Part>) {
    while let Some(at) = parts.iter().position(|part| matches!(part, Part::Phrase(Phrase::Using, _))) {
        parts.remove(at);
        let others = parts
            .iter()
            .filter(|part| matches!(part, Part::Phrase(Phrase::Function(_) | Phrase::Command(_), _)));
        if at > 0
            && matches!(
                parts.get(at),
                Some(Part::Phrase(Phrase::Function("polar" | "casteljau" | "deboor" | "subdivide"), _))
            )
            && (others.count() > 1 || at + 1 == parts.len())
        {
            parts.remove(at);
        }
    }
}

/// N(t) over knots is the basis function.
fn basis_function(text: &str, parts: &mut [Part]) {
    let knots = parts.iter().any(|part| matches!(part, Part::Phrase(Phrase::Label(Label::Knots), _)));
    let function = parts.iter().any(|part| matches!(part, Part::Phrase(Phrase::Function(_), _)));
    if let (Some(Part::Piece(span)), true, false) = (parts.first().copied(), knots, function)
        && matches!(text.piece(span.range()), "N(t)" | "N(x)" | "N(u)" | "B(t)" | "B(x)" | "N" | "B")
    {
        parts[0] = Part::Phrase(Phrase::Function("bspline_basis"), span);
    }
}

/// A list that is claimed to have a degree: the degree that it seems to have, the list, the degree.
fn claimed_degree(text: &str, parts: &[Part]) -> Option<(Option<Part>, Part, Part)> {
    let mut rest: Vec<Part> = parts.to_vec();
    let asks = rest.iter().position(|part| matches!(part, Part::Phrase(Phrase::Is, _)))?;
    rest.remove(asks);
    if matches!(rest.first(), Some(Part::Phrase(Phrase::Function("bezier"), _))) {
        rest.remove(0);
    }
    let degree = rest.first().copied().filter(|part| matches!(part, Part::Phrase(Phrase::Degree(_), _)));
    let rest = rest.get(usize::from(degree.is_some())..)?;
    let (list, rest) = rest.split_first()?;
    if !several(text, Some(list)) {
        return None;
    }
    match rest {
        [quality @ Part::Phrase(Phrase::Degree(_), _)] => Some((degree, *list, *quality)),
        [Part::Phrase(Phrase::Label(Label::OfDegree), _), quality @ Part::Piece(_)] => {
            Some((degree, *list, *quality))
        }
        _ => None,
    }
}

/// Uniform knots that are not written down.
fn uniform_knots(parts: &mut Vec<Part>) {
    let at = (0..parts.len()).find(|at| {
        matches!(parts[*at], Part::Phrase(Phrase::Uniform, _))
            && matches!(parts.get(at + 1), Some(Part::Phrase(Phrase::Label(Label::Knots), _)))
            && !matches!(parts.get(at + 2), Some(Part::Piece(_)))
    });
    if let Some(at) = at {
        parts.remove(at + 1);
        if at > 0 && matches!(parts[at - 1], Part::Phrase(Phrase::Label(Label::With), _)) {
            parts.remove(at - 1);
        }
    }
}

/// The largest of the control points is no value of their curve.
fn of_points(parts: &mut Vec<Part>) {
    let at = (0..parts.len()).find(|at| {
        matches!(
            parts.get(*at..*at + 4),
            Some([
                Part::Phrase(
                    Phrase::Function("maximum" | "minimum" | "max" | "min")
                        | Phrase::Command("maximum" | "minimum" | "max" | "min"),
                    _
                ),
                Part::Phrase(Phrase::Of, _),
                Part::Phrase(
                    Phrase::Label(Label::Points)
                        | Phrase::Function("control_points" | "bezier_points" | "in_bernstein"),
                    _
                ),
                Part::Piece(_),
            ])
        )
    });
    if let Some(at) = at {
        parts.remove(at + 2);
    }
}
