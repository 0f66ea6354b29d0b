//! Small pieces of formulas that all derivations are put together from.

use num_traits::{One, Zero};

use super::words::Reason;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Rel, Sign, Term};
use crate::language::value::{Line, exact_term, polynomial_expr};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Symbol};

/// Means over more terms than this are said in words only: they would not fit on the board.
pub(super) const TERMS_UP_TO: usize = 6;

pub(super) fn line(formula: Expr, reason: Reason) -> Line {
    Line { formula, reason: reason.words() }
}

/// a = b = c; a side that repeats the one before is left out.
pub(super) fn chain(sides: impl IntoIterator<Item = Expr>) -> Expr {
    let mut kept: Vec<Expr> = Vec::new();
    for side in sides {
        if kept.last() != Some(&side) {
            kept.push(side);
        }
    }
    let first = kept.remove(0);
    if kept.is_empty() {
        return first;
    }
    let links = kept.into_iter().map(|expr| Link { rel: Rel::Eq, span: Span::default(), expr });
    Kind::Chain(Box::new(first), links.collect()).into()
}

/// Several formulas side by side.
pub(super) fn sequence(mut items: Vec<Expr>) -> Expr {
    if items.len() == 1 { items.remove(0) } else { Kind::Sequence(items).into() }
}

/// name(arguments), or the bare name if there are none.
pub(super) fn call(name: Expr, arguments: Vec<Expr>) -> Expr {
    if arguments.is_empty() { name } else { Expr::apply(name, arguments) }
}

/// name_{i,j}
pub(super) fn subscript(name: &str, indices: &[usize]) -> Expr {
    let indices = indices.iter().map(|&i| Expr::int(i as i64)).collect();
    Kind::Subscript(Box::new(Expr::name(name)), indices).into()
}

/// F, F', F'', F''', F^{(4)}, …
pub(super) fn derivative(function: Expr, order: usize) -> Expr {
    match order {
        0 => function,
        1..=3 => Kind::Prime(Box::new(function), order as u32).into(),
        _ => Kind::Upper(Box::new(function), vec![Expr::int(order as i64)]).into(),
    }
}

/// base^exponent, where the exponents 0 and 1 are not written.
pub(super) fn power(base: Expr, exponent: usize) -> Option<Expr> {
    match exponent {
        0 => None,
        1 => Some(base),
        _ => Some(base.power(Expr::int(exponent as i64))),
    }
}

/// In brackets if it is a sum, so that it can stand in a product.
pub(super) fn factor(expr: Expr) -> Expr {
    if matches!(expr.kind, Kind::Add(_)) { expr.grouped() } else { expr }
}

/// A product without products inside.
pub(super) fn product(factors: Vec<Expr>) -> Expr {
    let mut flat = Vec::with_capacity(factors.len());
    for factor in factors {
        match factor.kind {
            Kind::Mul(inner) => flat.extend(inner),
            _ => flat.push(factor),
        }
    }
    Expr::product(flat)
}

/// weight · factors, with its sign; a weight 1 is not written.
pub(super) fn term(weight: &Fraction, factors: Vec<Expr>) -> Term {
    let Term { sign, expr } = match weight.as_rational() {
        Some(q) => exact_term(&q, factors),
        None => {
            let (sign, weight) = match polynomial_expr(weight) {
                Expr { kind: Kind::Add(mut terms), .. } if terms.len() == 1 => {
                    let only = terms.remove(0);
                    (only.sign, only.expr)
                }
                other => (Sign::Plus, factor(other)),
            };
            Term { sign, expr: Expr::product(std::iter::once(weight).chain(factors).collect()) }
        }
    };
    match expr.kind {
        Kind::Mul(factors) => Term { sign, expr: product(factors) },
        _ => Term { sign, expr },
    }
}

/// weight · factors on its own.
pub(super) fn multiple(weight: &Rational, factors: Vec<Expr>) -> Expr {
    Expr::sum(vec![term(&Fraction::from(weight.clone()), factors)])
}

/// Σ weight · body, terms with weight 0 left out.
pub(super) fn combination(items: impl IntoIterator<Item = (Fraction, Expr)>) -> Expr {
    let items = items.into_iter().filter(|(weight, _)| !weight.is_zero());
    let one = |body: &Expr| matches!(&body.kind, Kind::Number(q) if q.is_one());
    let term = |(weight, body): (Fraction, Expr)| {
        let factors = if one(&body) { Vec::new() } else { vec![factor(body)] };
        term(&weight, factors)
    };
    Expr::sum(items.map(term).collect())
}

/// The mean of several formulas, 1/k (a + b + …).
pub(super) fn mean(items: Vec<Expr>) -> Expr {
    let share = Rational::new(1.into(), (items.len().max(1) as i64).into());
    let plus = |expr| Term { sign: Sign::Plus, expr };
    match items.len() {
        0 | 1 => Expr::sum(items.into_iter().map(plus).collect()),
        _ => multiple(&share, vec![Expr::sum(items.into_iter().map(plus).collect()).grouped()]),
    }
}

pub(super) fn symbol(symbol: &Symbol) -> Fraction {
    Fraction::from(MultiPoly::symbol(symbol.clone()))
}

pub(super) fn integer(value: usize) -> Fraction {
    Fraction::from(crate::math::number::integer(value as i64))
}

pub(super) fn ratio(p: usize, q: usize) -> Fraction {
    Fraction::from(crate::math::number::rational(p as i64, q as i64))
}

/// The first of some letters that does not occur among the symbols.
pub(super) fn fresh(letters: &[&str], taken: &[Symbol]) -> Symbol {
    let free = letters.iter().map(|letter| Symbol::new(*letter)).find(|letter| !taken.contains(letter));
    free.unwrap_or_else(|| Symbol::new(letters[0]))
}
