//! What letters of the table stand for, and whether a page uses a letter for something else.

use crate::formula::Expr;
use crate::judge::page::context::Context;
use crate::judge::page::object::Sort;
use crate::judge::page::statement::Place;
use crate::judge::written::names::{Head, letter_of};
use crate::language::lexicon::families::{self, Family};
use crate::language::lexicon::roles::{Listed, is_variable, listed};

/// What a letter with an index stands for in the table, and usually elsewhere. Nodes are knots here.
fn usual(letter: &str) -> Option<Listed> {
    match listed(letter_of(letter))? {
        Listed::Nodes => Some(Listed::Knots),
        Listed::Values => None,
        other => Some(other),
    }
}

/// Whether a letter of the table is a basis function, and that of the page is none: b_i^r(t) are points of de Casteljau's
/// algorithm, B_i^r(t) Bernstein polynomials.
pub(super) fn is_no_basis(theirs: &str, ours: &Expr, context: &Context, place: &Place) -> bool {
    let (family, sort) = match theirs {
        families::BERNSTEIN => (Family::Bernstein, Sort::Bernstein),
        families::SPLINE => (Family::Spline, Sort::BSpline),
        _ => return false,
    };
    let Some(head) = Head::of(ours) else { return false };
    let told = context.object_called(&head.base, place);
    if told.is_some_and(|told| matches!(told.object.sort, Sort::Other(_))) {
        return true;
    }
    let named = [(1, 1), (2, 0)].iter().any(|(lower, upper)| {
        families::notation(&head.base, *lower, *upper).is_some_and(|notation| notation.family == family)
    });
    !named && context.object_called(&head.base, place).is_none_or(|declared| declared.object.sort != sort)
}

/// Whether a letter of the page stands for something else than one of the table.
pub(super) fn clash(theirs: &str, ours: &Expr, context: &Context, place: &Place) -> bool {
    let (Some(role), Some(head)) = (usual(theirs), Head::of(ours)) else { return false };
    let said = context.object_called(&head.base, place).and_then(|declared| match declared.object.sort {
        Sort::ControlPoints => Some(Listed::Points),
        Sort::Knots | Sort::Nodes => Some(Listed::Knots),
        _ => None,
    });
    // Nobody calls knots e_0, e_1 without saying so.
    said.or_else(|| usual(&head.base))
        .map_or(role == Listed::Knots && !is_variable(&head.base), |own| own != role)
}
