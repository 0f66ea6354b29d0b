//! Knots that are not written down: those of uniform splines, and the places that a spline has by its knots.

use super::Read;
use super::draft::{Draft, list};
use super::utterance::Utterance;
use crate::formula::{Expr, Kind};
use crate::language::functions::builtin;
use crate::language::lexicon::phrases::Label;

fn is_spline(draft: &Draft) -> bool {
    matches!(
        draft.builtin.name,
        "bspline" | "bspline_basis" | "deboor" | "pieces" | "bezier_points" | "control_points"
    )
}

fn items_of(read: &Read) -> Vec<Expr> {
    match read.items.as_slice() {
        [Expr { kind: Kind::List(items) | Kind::Tuple(items), .. }] => items.clone(),
        items => items.to_vec(),
    }
}

fn degree_said(asked: &Utterance) -> Option<usize> {
    let read = asked.said.iter().find(|read| read.label == Label::OfDegree)?;
    usize::try_from(read.items.first()?.as_int()?).ok()
}

/// Gives a uniform spline the knots 0, 1, 2, …: uniform cubic B-spline with control points 1, 4, 2, 0.
pub(super) fn uniform(asked: &mut Utterance) {
    let Some(at) = asked.said.iter().position(|read| read.label == Label::Uniform) else { return };
    let spline =
        asked.drafts.iter().position(|draft| matches!(draft.builtin.name, "bspline" | "bspline_basis"));
    let (Some(degree), Some(spline)) = (degree_said(asked), spline) else { return };
    if asked.says(Label::Knots) {
        return;
    }
    let points = asked.said.iter().find(|read| read.label == Label::Points).map(items_of).or_else(|| {
        (asked.items.len() > 1).then(|| asked.items.clone()).or_else(|| match asked.items.as_slice() {
            [Expr { kind: Kind::List(items), .. }] => Some(items.clone()),
            _ => None,
        })
    });
    let count = points.as_ref().map_or(1, Vec::len);
    if count > 1 && count <= degree {
        return;
    }
    let span = asked.said.remove(at).items.first().map_or(asked.drafts[spline].phrase, |item| item.span);
    let knots = (0..i64::try_from(count + degree).unwrap_or(0) + 1).map(Expr::int).collect();
    asked.said.push(Read { label: Label::Knots, items: vec![Expr { span, ..list(knots) }] });
    let Some(points) = points else { return };
    if let Some(curve) = builtin("bspline") {
        asked.drafts[spline].builtin = curve;
    }
    if !asked.says(Label::Points) {
        asked.items.clear();
        asked.said.push(Read { label: Label::Points, items: points });
    }
    // The Bézier points of a spline are those of its pieces.
    if let Some(pieces) = builtin("pieces")
        && let Some(outer) = asked.drafts.iter_mut().find(|draft| draft.builtin.name == "bezier_points")
    {
        outer.builtin = pieces;
    }
}

impl super::Reader<'_> {
    /// The B-spline with some knots is the one that has all of them: support of the B-spline with knots 0, 1, 3, 4.
    pub(super) fn only_basis_function(&self, asked: &mut Utterance) {
        let Some(draft) = asked.drafts.iter().find(|draft| draft.builtin.name == "bspline_basis") else {
            return;
        };
        let phrase = self.file.slice(draft.phrase).to_lowercase();
        let several =
            phrase.ends_with('s') || asked.drafts.iter().any(|draft| draft.builtin.name == "length");
        let told = [Label::OfDegree, Label::Points, Label::Values, Label::Uniform, Label::Number];
        if several || told.into_iter().any(|label| asked.says(label)) || !asked.items.is_empty() {
            return;
        }
        let phrase = draft.phrase;
        let knots = asked
            .said
            .iter()
            .find(|read| read.label == Label::Knots || read.label == Label::Over && read.items.len() > 2)
            .map(items_of);
        let degree = knots.and_then(|knots| i64::try_from(knots.len()).ok()).map(|count| count - 2);
        if let Some(degree) = degree.filter(|degree| *degree >= 0) {
            asked.said.push(Read {
                label: Label::OfDegree,
                items: vec![Expr { span: phrase, ..Expr::int(degree) }],
            });
        }
    }
}

/// The ends of the interval of a spline, or of the knots of a basis function.
pub(super) fn ends(asked: &Utterance) -> Option<[Expr; 2]> {
    if !asked.drafts.iter().any(is_spline) {
        return None;
    }
    let knots = asked
        .said
        .iter()
        .find(|read| read.label == Label::Knots || read.label == Label::Over && read.items.len() > 2)
        .map(items_of)?;
    let points = asked.said.iter().find(|read| read.label == Label::Points).map(items_of);
    let skipped = match &points {
        None => 0,
        Some(points) => knots.len().checked_sub(points.len() + 1)?,
    };
    let last = knots.len().checked_sub(skipped + 1)?;
    Some([knots.get(skipped)?.clone(), knots.get(last)?.clone()])
}
