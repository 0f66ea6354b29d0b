//! What the word for a function means of the object that it is asked of: the power form of a spline, the area under a curve.

use super::Reader;
use super::draft::{Draft, list};
use super::utterance::Utterance;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, call};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::functions::builtin;

impl Reader<'_> {
    /// Puts the function that is meant of a spline or a curve in the place of the one that the word names elsewhere.
    pub(super) fn in_sense_of_object(&self, asked: &mut Utterance) {
        // The power form of a spline is that of its pieces.
        if let [Draft { builtin: spline, .. }, outer] = asked.drafts.as_mut_slice()
            && (spline.name, outer.builtin.name) == ("bspline", "expand")
            && let Some(pieces) = builtin("power_pieces")
        {
            outer.builtin = pieces;
        }
        // The antiderivative of a curve is a curve.
        if let [Draft { builtin: curve, .. }, outer] = asked.drafts.as_mut_slice()
            && (curve.name, outer.builtin.name) == ("bezier", "integrate")
            && ["antideriv", "stammf", "primitiv"]
                .iter()
                .any(|word| self.file.slice(outer.phrase).to_lowercase().starts_with(word))
            && let Some(primitive) = builtin("antiderivative")
        {
            outer.builtin = primitive;
        }
    }

    /// The area under a plane curve: its integral has two coordinates, the area is a number.
    pub(super) fn area_under_curve(&self, asked: &Utterance) -> Option<Expr> {
        let ([Draft { builtin: curve, .. }, outer], []) = (asked.drafts.as_slice(), asked.said.as_slice())
        else {
            return None;
        };
        let phrase = self.file.slice(outer.phrase).to_lowercase();
        let area = ["area", "fläche", "aire", "área"].iter().any(|word| phrase.starts_with(word));
        ((curve.name, outer.builtin.name) == ("bezier", "integrate") && area)
            .then(|| area_under(&asked.items, outer.phrase))?
    }

    /// The length of a control polygon is none of its curve.
    pub(super) fn of_polygon(&self, asked: &Utterance) -> Option<Diagnostic> {
        let draft = asked.drafts.iter().find(|draft| draft.builtin.name == "arc_length")?;
        let text = self.file.slice(Span::new(self.start, self.file.text().len())).to_lowercase();
        let own = match asked.items.as_slice() {
            [list @ Expr { kind: Kind::List(_), .. }] => list.clone(),
            items => list(items.to_vec()),
        };
        let points = crate::language::write::text(&own);
        ["polygon", "polygone", "polígono", "poligono", "多边形"].iter().any(|word| text.contains(word)).then(
            || {
                Diagnostic::error(Code::Usage, "the length of the polygon, or of its curve?")
                    .at(draft.phrase)
                    .reason("a polygon is as long as its edges together")
                    .hint(format!("of the polygon: polygon_length({points})"))
                    .hint(format!("of the curve: arc_length(bezier({points}))"))
            },
        )
    }
}

/// The area under a plane curve, whose integral is none: that of the curve closed by the axis y = 0, below which it counts
/// as negative.
fn area_under(points: &[Expr], span: Span) -> Option<Expr> {
    let pair = |point: &Expr| match point.items() {
        Some([x, y]) => Some((x.clone(), y.clone())),
        _ => None,
    };
    let [(p, _), (q, _)] = [pair(points.first()?)?, pair(points.last()?)?];
    if !points.iter().all(|point| matches!(point.kind, Kind::Tuple(_)) && pair(point).is_some()) {
        return None;
    }
    let foot = |x: Expr| Expr::new(Kind::Tuple(vec![x, Expr::int(0)]), span);
    let (right, left) = (foot(q), foot(p));
    let curve = |points: Vec<Expr>| call("bezier", vec![list(points)], span);
    let pieces = vec![
        curve(points.to_vec()),
        curve(vec![points.last()?.clone(), right.clone()]),
        curve(vec![right, left.clone()]),
        curve(vec![left, points.first()?.clone()]),
    ];
    Some(Expr { span, ..call("area", vec![list(pieces)], span).negated() })
}
