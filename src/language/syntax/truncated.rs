//! Truncated powers: (x - j)_+^p is (x - j)^p where x - j >= 0, and 0 elsewhere.

use crate::formula::{Accent, Expr, Kind, Link, Rel};
use crate::language::lexicon::letters::is_one_letter;

/// Whether a formula can have a positive part: a variable, a number, a formula in brackets.
pub(crate) fn may_be_truncated(base: &Expr) -> bool {
    match &base.kind {
        Kind::Group(_) | Kind::Number(_) => true,
        Kind::Name(name) => is_one_letter(name) && name.starts_with(char::is_lowercase),
        Kind::Accent(Accent::Bold, inner) => may_be_truncated(inner),
        _ => false,
    }
}

/// The truncated power of a formula.
pub(crate) fn truncated(base: Expr, exponent: Option<Expr>) -> Kind {
    let span = base.span;
    let zero = || Expr::new(Expr::int(0).kind, span);
    let link = Link { rel: Rel::Ge, span, expr: zero() };
    let within = Expr::new(Kind::Chain(Box::new(base.clone()), vec![link]), span);
    let power = match exponent {
        Some(exponent) => Expr::new(Kind::Pow(Box::new(base), Box::new(exponent)), span),
        None => base,
    };
    Kind::Cases(vec![(power, Some(within)), (zero(), None)])
}
