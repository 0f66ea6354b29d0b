//! The forms in which a claim is compared with theorems: notations that mean the same are written in one way.

use crate::formula::{BigOp, Expr, Kind, Link, Rel};
use crate::judge::page::context::Context;
use crate::judge::page::object::Sort;
use crate::judge::page::statement::Place;
use crate::judge::written::names::{Head, bases, walk};
use crate::language::lexicon::families;

/// The one case of a formula that is not a number, or the formula.
pub(super) fn main_case(expr: &Expr) -> &Expr {
    let Kind::Cases(cases) = &expr.kind else { return expr };
    let mut formulas =
        cases.iter().map(|(body, _)| body).filter(|body| !matches!(body.kind, Kind::Number(_)));
    match (formulas.next(), formulas.next()) {
        (Some(only), None) => only,
        _ => expr,
    }
}

/// b_{ijk} beside b_{i-1,j,k}: indices that are written together; p_{i,…,k}, the first and the last index.
pub(super) fn with_indices_apart(sides: [&Expr; 2]) -> [Expr; 2] {
    let mut several: Vec<(String, usize)> = Vec::new();
    for side in sides {
        walk(side, &mut |part| {
            if let Kind::Subscript(base, indices) = &part.kind
                && let Some(head) = Head::of(base)
                && indices.len() > 1
            {
                several.push((head.base, indices.len()));
            }
        });
    }
    fn split(expr: &mut Expr, several: &[(String, usize)]) {
        expr.for_each_child_mut(&mut |child| split(child, several));
        let Kind::Subscript(base, indices) = &mut expr.kind else { return };
        // p_{i,…,k}: from i to k
        if let [_, dots, _] = indices.as_slice()
            && dots.kind == Kind::Ellipsis
        {
            indices.remove(1);
            return;
        }
        let [Expr { kind: Kind::Mul(factors), .. }] = indices.as_slice() else { return };
        if Head::of(base).is_some_and(|head| several.contains(&(head.base, factors.len()))) {
            *indices = factors.clone();
        }
    }
    sides.map(|side| {
        let mut side = side.clone();
        split(&mut side, &several);
        side
    })
}

/// A formula in which f(a^{⟨k⟩}, b) has a brace with a count, and so has f(a^k, b) where polar forms are spoken of.
pub(super) fn with_repetitions(expr: &Expr, polar: bool) -> Expr {
    let mut result = expr.clone();
    result.for_each_child_mut(&mut |child| *child = with_repetitions(child, polar));
    let Kind::Apply(_, groups) = &mut result.kind else { return result };
    if groups.iter().map(Vec::len).sum::<usize>() < 2 {
        return result;
    }
    for item in groups.iter_mut().flatten() {
        let repeated = match &item.kind {
            Kind::Upper(base, counts) if counts.len() == 1 => Some((base, &counts[0])),
            Kind::Pow(base, count) if polar && !bases(count).is_empty() => Some((base, count.as_ref())),
            _ => None,
        };
        if let Some((base, count)) = repeated
            && matches!(base.kind, Kind::Name(_) | Kind::Number(_) | Kind::Accent(..))
        {
            item.kind = Kind::Brace(vec![base.as_ref().clone()], Some(Box::new(count.clone())));
        }
    }
    result
}

/// A formula of the table in the order of indices that the page has: B_{n,i} for B_{i,n}, where its first index is the degree.
pub(super) fn in_order_of_page(expr: &mut Expr, context: &Context, place: &Place) {
    expr.for_each_child_mut(&mut |child| in_order_of_page(child, context, place));
    let Kind::Subscript(base, indices) = &mut expr.kind else { return };
    let (Some(letter), 2) = (Head::of(base), indices.len()) else { return };
    let first = context.object_called(&letter.base, place).is_some_and(|declared| {
        let own = declared.object.names.iter().filter_map(Head::of).find(|own| own.lower.len() == 2);
        declared.object.sort == Sort::Bernstein
            && own.is_some_and(|own| declared.object.has_degree_first(&own))
    });
    if first {
        indices.swap(0, 1);
    }
}

/// A formula in which the points b_i^r(t) of an algorithm are written b_i^r.
pub(super) fn without_parameters(expr: &Expr) -> Expr {
    let mut result = expr.clone();
    result.for_each_child_mut(&mut |child| *child = without_parameters(child));
    let Kind::Apply(callee, groups) = &result.kind else { return result };
    let name = |item: &&Expr| matches!(item.kind, Kind::Name(_));
    let one = matches!(groups.as_slice(), [group] if matches!(group.as_slice(), [item] if name(&item)));
    let point = Head::of(callee).is_some_and(|head| {
        let (lower, upper) = (head.lower.len(), head.upper.len());
        head.arguments.is_none()
            && lower + upper > 1
            && families::notation(&head.base, lower, upper).is_none()
    });
    if one && point { callee.as_ref().clone() } else { result }
}

/// A formula in which b_i^{(1)} is a member of a family with another name.
pub(super) fn without_marks(expr: &Expr) -> Expr {
    fn unmark(expr: &mut Expr) {
        // N_i'(t) is a derivative, y_0' the slope beside y_0.
        if let Kind::Apply(callee, groups) = &mut expr.kind
            && matches!(callee.kind, Kind::Prime(..))
        {
            return groups.iter_mut().flatten().for_each(unmark);
        }
        expr.for_each_child_mut(&mut unmark);
        if let Kind::Prime(base, order) = &expr.kind
            && let Kind::Subscript(letter, indices) = &base.kind
            && let Some(head) = Head::of(letter)
        {
            let marks = "'".repeat(*order as usize);
            let name = Expr::new(Kind::Name(format!("{}{marks}", head.base)), letter.span);
            expr.kind = Kind::Subscript(Box::new(name), indices.clone());
            return;
        }
        // b_i^*
        if let Kind::Pow(base, _) | Kind::Upper(base, _) | Kind::Accent(_, base) = &expr.kind
            && let Kind::Subscript(letter, indices) = &base.kind
            && let Some(head) = Head::of(expr)
            && head.upper.is_empty()
            && head.lower.len() == indices.len()
        {
            let name = Expr::new(Kind::Name(head.base), letter.span);
            expr.kind = Kind::Subscript(Box::new(name), indices.clone());
            return;
        }
        let Kind::Upper(base, upper) = &expr.kind else { return };
        let ([mark], Kind::Subscript(letter, indices)) = (upper.as_slice(), &base.kind) else { return };
        let mark = match &mark.kind {
            Kind::Number(number) => number.to_string(),
            Kind::Text(text) => text.clone(),
            _ => return,
        };
        let Some(head) = Head::of(letter) else { return };
        let name = Expr::new(Kind::Name(format!("{}({mark})", head.base)), letter.span);
        expr.kind = Kind::Subscript(Box::new(name), indices.clone());
    }
    let mut result = expr.clone();
    unmark(&mut result);
    result
}

/// So far a sum without bounds is written out: its terms are compared as they stand.
const WINDOW: i64 = 4;

/// A formula in which sums over all integers, \sum_j and \sum_{j \in \mathbb Z}, have few terms.
pub(super) fn with_windows(expr: &Expr) -> Expr {
    let mut result = expr.clone();
    result.for_each_child_mut(&mut |child| *child = with_windows(child));
    let Kind::Big { op: BigOp::Sum, lower, upper: upper @ None, .. } = &mut result.kind else {
        return result;
    };
    let index = match lower.as_slice() {
        [Expr { kind: Kind::Chain(index, links), .. }] => {
            let all = matches!(links.as_slice(), [link] if link.rel == Rel::In
                && matches!(&link.expr.kind, Kind::Name(set) if set == "ℤ"));
            all.then(|| index.as_ref().clone())
        }
        [index] => Some(index.clone()),
        _ => None,
    };
    if let Some(index) = index.filter(|index| matches!(index.kind, Kind::Name(_))) {
        let span = index.span;
        let link = Link { rel: Rel::Eq, span, expr: Expr::int(0) };
        *lower = vec![Expr::new(Kind::Chain(Box::new(index), vec![link]), span)];
        *upper = Some(Box::new(Expr::int(WINDOW)));
    }
    result
}
