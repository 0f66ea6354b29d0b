//! What an expression may be by its form: a function, a power, a transpose.

use crate::formula::{Expr, Kind, Sign};
use crate::language::lexicon::letters::is_one_letter;
use crate::language::lexicon::roles::NAMED_FUNCTIONS;

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

pub(super) fn is_sum(expr: &Expr) -> bool {
    matches!(expr.kind, Kind::Add(_))
}

/// Whether it is a sum in brackets of numbers and of letters that usually are no functions: `(1-t)^{(n-i)}` is a
/// power, `(fg)^{(n-1)}` and `(f+g)^{(n-1)}` are derivatives.
pub(super) fn is_sum_of_letters(expr: &Expr) -> bool {
    fn letters(expr: &Expr) -> bool {
        let kind = match &expr.kind {
            Kind::Name(name) => is_one_letter(name) && !NAMED_FUNCTIONS.contains(&name.as_str()),
            Kind::Number(_)
            | Kind::Group(_)
            | Kind::Add(_)
            | Kind::Mul(_)
            | Kind::Div(..)
            | Kind::Pow(..)
            | Kind::Subscript(..) => true,
            _ => false,
        };
        let mut all = kind;
        expr.for_each_child(&mut |child| all = all && letters(child));
        all
    }
    matches!(&expr.kind, Kind::Group(inner) if is_sum(inner) && letters(inner))
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
