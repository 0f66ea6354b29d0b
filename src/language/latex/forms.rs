//! What an expression may be by its form: a function, a transpose.

use crate::formula::{Expr, Kind, Sign};

/// Whether an expression may take arguments by its form.
pub(super) fn is_callee(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Name(name) => !matches!(name.as_str(), "infty" | "emptyset" | "cdot" | "ast"),
        // (F ∘ G)'(t)
        Kind::Prime(base, _) | Kind::Upper(base, _) if matches!(base.kind, Kind::Group(_)) => true,
        Kind::Subscript(base, _) | Kind::Accent(_, base) | Kind::Prime(base, _) | Kind::Upper(base, _) => {
            is_callee(base)
        }
        Kind::Pow(base, exponent) => {
            let allowed = match &exponent.kind {
                Kind::Number(_) => has_index(base),
                Kind::Add(terms) => !matches!(terms.as_slice(), [term] if term.sign == Sign::Minus),
                _ => true,
            };
            allowed && is_callee(base)
        }
        // dF/dt (t), but (d/dt f(t)) (1 - t) is a product
        Kind::Derivative { body: Some(body), .. } => is_callee(body),
        _ => false,
    }
}

fn has_index(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Subscript(..) => true,
        Kind::Accent(_, base) | Kind::Prime(base, _) | Kind::Upper(base, _) => has_index(base),
        _ => false,
    }
}

/// A matrix or row of numbers has no power T.
pub(super) fn is_transposed(base: &Expr, exponent: &Expr) -> bool {
    matches!(base.kind, Kind::Matrix(..) | Kind::List(_))
        && matches!(&exponent.kind, Kind::Name(name) if name == "T")
}
