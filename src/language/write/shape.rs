//! Shapes that the notations have in common: sums, products, chains of operators.
//!
//! Each function says which precedence the places of its operands require, which is
//! all there is to know about parentheses.

use super::walk::Pieces;
use crate::formula::{Expr, Kind, Link, Precedence, Rel, Sign, Term};

/// A sum of signed terms: ` + ` between them, without blanks in indices and exponents.
///
/// `dots` is how an ellipsis among the terms looks, if unlike one among the items of a list.
pub(super) fn sum<'a>(terms: &'a [Term], dots: Option<&'static str>, out: &mut Pieces<'a>) {
    for (i, term) in terms.iter().enumerate() {
        out.str(match (term.sign, i, out.compact()) {
            (Sign::Plus, 0, _) if terms.len() > 1 => "",
            (Sign::Plus, 0, _) | (Sign::Plus, _, true) => "+",
            (Sign::Minus, 0, _) | (Sign::Minus, _, true) => "-",
            (Sign::Plus, _, false) => " + ",
            (Sign::Minus, _, false) => " - ",
        });
        node_or_dots(&term.expr, dots, Precedence::Product, out);
    }
}

/// An operand; an ellipsis among operators is set as high as they are.
pub(super) fn node_or_dots<'a>(
    expr: &'a Expr,
    dots: Option<&'static str>,
    level: Precedence,
    out: &mut Pieces<'a>,
) {
    match (&expr.kind, dots) {
        (Kind::Ellipsis, Some(dots)) => out.str(dots),
        _ => out.node(expr, level),
    }
}

/// A product, with `dots` for an ellipsis. `open` tells the factors that take in everything to their right, such as a sum
/// sign in LaTeX, which are fine at the end only; `hint` is told two factors that meet
/// and goes to [`Pieces::times`].
pub(super) fn product<'a>(
    factors: &'a [Expr],
    dots: Option<&'static str>,
    out: &mut Pieces<'a>,
    open: impl Fn(&Expr) -> bool,
    hint: impl Fn(&Expr, &Expr) -> bool,
) {
    for (i, factor) in factors.iter().enumerate() {
        if i > 0 {
            let before = &factors[i - 1];
            out.times(hint(before, factor), before.is_mixed_with(factor));
        }
        let level = factor_level(factor, i == 0, i + 1 == factors.len(), &open);
        node_or_dots(factor, dots, level, out);
    }
}

fn factor_level(factor: &Expr, first: bool, last: bool, open: &impl Fn(&Expr) -> bool) -> Precedence {
    let loose = match &factor.kind {
        Kind::Mul(_) => false, // it would become part of this product
        _ if open(factor) => last,
        _ => first,
    };
    if loose { Precedence::Product } else { Precedence::Compose }
}

/// `a/b`, which groups from the left as products do.
pub(super) fn slash<'a>(
    above: &'a Expr,
    below: &'a Expr,
    out: &mut Pieces<'a>,
    open: impl Fn(&Expr) -> bool,
) {
    let is_open = match &above.kind {
        Kind::Mul(factors) => factors.last().is_some_and(&open),
        _ => open(above),
    };
    out.node(above, if is_open { Precedence::Compose } else { Precedence::Product });
    out.str("/");
    out.node(below, Precedence::Compose);
}

/// What stands before primes, which are counted together with its own.
pub(super) fn primed<'a>(body: &'a Expr, out: &mut Pieces<'a>) {
    match body.kind {
        Kind::Prime(..) => out.wrapped("(", body, ")"),
        _ => out.node(body, Precedence::Postfix),
    }
}

/// A chain of relations; `sign` gives each with its blanks, and is told whether this is in an
/// index or exponent. The right side of a definition may
/// be a chain itself.
pub(super) fn chain<'a>(
    first: &'a Expr,
    links: &'a [Link],
    out: &mut Pieces<'a>,
    sign: impl Fn(Rel, bool) -> &'static str,
) {
    out.node(first, Precedence::Lambda);
    for link in links {
        out.str(sign(link.rel, out.compact()));
        let defined = link.rel == Rel::Define && links.len() == 1 && !is_definition(&link.expr);
        out.node(&link.expr, if defined { Precedence::Relation } else { Precedence::Lambda });
    }
}

fn is_definition(expr: &Expr) -> bool {
    matches!(&expr.kind, Kind::Chain(_, links) if links.iter().any(|link| link.rel == Rel::Define))
}

/// The index, lower and upper bound of an operator over `i = low` up to `high`, with further
/// conditions after the first.
pub(super) fn bounds<'a>(
    lower: &'a [Expr],
    upper: Option<&'a Expr>,
) -> Option<(&'a Expr, &'a Expr, &'a Expr, &'a [Expr])> {
    let (first, rest) = lower.split_first()?;
    match &first.kind {
        Kind::Chain(index, links) => match links.as_slice() {
            [Link { rel: Rel::Eq, expr: low, .. }] => Some((index, low, upper?, rest)),
            _ => None,
        },
        _ => None,
    }
}
