//! A dot between two points: their scalar product.

use crate::formula::source::{SourceFile, Span};
use crate::formula::{Accent, Expr, Kind, applied};

/// The same formula, with `(1, 2) \cdot (3, 4)` as a scalar product. `is_point` says which names stand for points.
pub(in crate::session) fn with_scalar_products(
    mut expr: Expr,
    file: &SourceFile,
    is_point: &dyn Fn(&str) -> bool,
) -> Expr {
    rewrite(&mut expr, file, is_point);
    expr
}

fn rewrite(expr: &mut Expr, file: &SourceFile, is_point: &dyn Fn(&str) -> bool) {
    expr.for_each_child_mut(&mut |child| rewrite(child, file, is_point));
    let span = expr.span;
    let Kind::Mul(factors) = &mut expr.kind else { return };
    let mut at = 0;
    while at + 1 < factors.len() {
        let dotted = has_dot(file, factors[at].span, factors[at + 1].span)
            && is_vector(&factors[at], is_point)
            && is_vector(&factors[at + 1], is_point);
        if dotted {
            let right = factors.remove(at + 1);
            let left = factors[at].clone();
            let place = left.span.to(right.span);
            factors[at] = applied(Expr { span: place, ..Expr::name("dot") }, vec![left, right], place);
        }
        at += 1;
    }
    if factors.len() == 1
        && let Some(only) = factors.pop()
    {
        *expr = Expr { span, ..only };
    }
}

/// Whether only a dot stands between two places.
fn has_dot(file: &SourceFile, left: Span, right: Span) -> bool {
    left.end < right.start
        && matches!(file.slice(Span::new(left.end, right.start)).trim(), "\\cdot" | "·" | "⋅" | "∙")
}

/// Whether a formula is a point as it is written: coordinates, a column, \vec a, a name that stands for one.
fn is_vector(expr: &Expr, is_point: &dyn Fn(&str) -> bool) -> bool {
    match &expr.kind {
        Kind::Tuple(_) => true,
        Kind::List(items) => items.len() > 1,
        Kind::Matrix(rows, _) => rows.len() > 1 && rows.iter().all(|row| row.len() == 1),
        Kind::Name(name) => is_point(name),
        Kind::Accent(Accent::Vec | Accent::Bold, inner) | Kind::Group(inner) => is_vector(inner, is_point),
        Kind::Add(terms) => terms.iter().any(|term| is_vector(&term.expr, is_point)),
        Kind::Mul(factors) => factors.iter().filter(|factor| is_vector(factor, is_point)).count() == 1,
        _ => false,
    }
}
