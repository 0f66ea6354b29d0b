//! Edits written as people would.

use super::edits::is_zero;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Quotient, Sign, Term};
use crate::math::number::Rational;
use num_traits::{Signed, Zero};

/// N(2x) for N(2x + 0), i + 2 for (i + 1) + 1, n F for (n) F
pub(super) fn tidy(edit: &mut Expr) {
    edit.for_each_child_mut(&mut tidy);
    ungroup(edit);
    let Kind::Add(terms) = &mut edit.kind else { return };
    let number = |term: &Term| matches!(term.expr.kind, Kind::Number(_));
    let inner = |expr: &Expr| match &expr.kind {
        Kind::Add(inner) => Some(inner.clone()),
        Kind::Group(group) => match &group.kind {
            Kind::Add(inner) if inner.iter().any(number) => Some(inner.clone()),
            _ => None,
        },
        _ => None,
    };
    let first = terms.first().filter(|first| first.sign == Sign::Plus).and_then(|first| inner(&first.expr));
    if let Some(inner) = first
        && (matches!(terms[0].expr.kind, Kind::Add(_)) || terms[1..].iter().any(number))
    {
        terms.splice(..1, inner);
        let sum: Rational = terms.iter().fold(Rational::zero(), |sum, term| match &term.expr.kind {
            Kind::Number(q) if term.sign == Sign::Plus => sum + q,
            Kind::Number(q) => sum - q,
            _ => sum,
        });
        if terms.iter().filter(|term| number(term)).count() > 1 && !terms.iter().all(number) {
            terms.retain(|term| !number(term));
            let sign = if sum.is_negative() { Sign::Minus } else { Sign::Plus };
            terms.push(Term { sign, expr: Expr::number(&sum.abs()) });
        }
    }
    drop_zeros(edit);
}

/// Takes new groups away, and those of which only a name is left, where nothing needs them.
fn ungroup(edit: &mut Expr) {
    let bare = |child: &mut Expr, any: bool| {
        let Kind::Group(inner) = &child.kind else { return };
        let length = |span: Span| span.end - span.start;
        let alone = matches!(inner.kind, Kind::Name(_) | Kind::Subscript(..));
        // (n - 1), of which n is left
        let rest = alone && length(child.span) > length(inner.span) + 2;
        let new = rest || child.span == Span::default() || inner.span == Span::default();
        if new && (any || alone) {
            *child = inner.as_ref().clone();
        }
    };
    match &mut edit.kind {
        Kind::Div(above, below, Quotient::Fraction) => {
            bare(above, true);
            bare(below, true);
        }
        Kind::Binomial(above, below, _) => {
            bare(above, true);
            bare(below, true);
        }
        Kind::Pow(_, exponent) => bare(exponent, true),
        Kind::Subscript(_, indices) => indices.iter_mut().for_each(|index| bare(index, true)),
        // n (b - a) would be a call of n.
        Kind::Mul(factors) => {
            // 2 a b for 2 (a b)
            let product = |factor: &Expr| match &factor.kind {
                Kind::Group(inner) if factor.span == Span::default() || inner.span == Span::default() => {
                    match &inner.kind {
                        Kind::Mul(own) => Some(own.clone()),
                        _ => None,
                    }
                }
                Kind::Mul(own) => Some(own.clone()),
                _ => None,
            };
            let flat = |factor: Expr| product(&factor).unwrap_or_else(|| vec![factor]);
            *factors = std::mem::take(factors).into_iter().flat_map(flat).collect();
            for at in 0..factors.len() {
                let called = factors.get(at + 1).is_some_and(|next| matches!(next.kind, Kind::Group(_)));
                if !called {
                    bare(&mut factors[at], false);
                }
            }
        }
        Kind::Add(terms) => terms.iter_mut().for_each(|term| bare(&mut term.expr, false)),
        _ => {}
    }
}

fn drop_zeros(edit: &mut Expr) {
    if let Kind::Add(terms) = &mut edit.kind
        && terms.len() > 1
        && terms.iter().any(|term| is_zero(&term.expr))
    {
        terms.retain(|term| !is_zero(&term.expr));
        *edit = Expr::sum(std::mem::take(terms));
    }
}
