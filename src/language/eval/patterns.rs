//! Sums and products with dots: 1 + 2 + ⋯ + 10, a_0 + a_1 t + ⋯ + a_4 t^4, (t - t_0)(t - t_1) ⋯ (t - t_3).
//!
//! What the dots stand for is the last term with one of its integers replaced, if that gives the terms before the
//! dots; if it can be read in two ways it is not clear.

use super::machine::{Evaluated, Machine};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Sign, Term};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::arithmetic;
use crate::language::ops::errors::unsupported;
use crate::language::value::Value;
use crate::math::number::Rational;
use num_traits::Zero;

type Combine = fn(Value, Value) -> Evaluated;

/// From where an index is tried.
const FIRST: i64 = -2;
/// Up to where.
const LAST: i64 = 12;
/// An integer that stands in more places is not tried.
const MOST_PLACES: u32 = 6;

impl Machine {
    pub(super) fn sum_with_dots(&mut self, terms: &[Term], span: Span) -> Evaluated {
        let items: Vec<Expr> = terms.iter().map(|term| term.expr.clone()).collect();
        match terms.iter().all(|term| term.sign == Sign::Plus) {
            true => self.with_dots(&items, arithmetic::add, &Value::int(0), span),
            false => Err(unclear(span)),
        }
    }

    pub(super) fn product_with_dots(&mut self, factors: &[Expr], span: Span) -> Evaluated {
        self.with_dots(factors, arithmetic::multiply, &Value::int(1), span)
    }

    fn with_dots(&mut self, items: &[Expr], combine: Combine, neutral: &Value, span: Span) -> Evaluated {
        let values = match self.expand_items(items) {
            Ok(values) => values,
            Err(error) if error.code == Code::Unsupported => self.by_pattern(items, span)?,
            Err(error) => return Err(error),
        };
        values.into_iter().try_fold(neutral.clone(), combine).at(span)
    }

    /// All items, where the one after the dots is the pattern of the others.
    fn by_pattern(&mut self, items: &[Expr], span: Span) -> Result<Vec<Value>, Diagnostic> {
        let dots = items.iter().position(|item| item.kind == Kind::Ellipsis).ok_or_else(|| unclear(span))?;
        let [last, rest @ ..] = &items[dots + 1..] else { return Err(unclear(span)) };
        if dots == 0 || rest.iter().any(|item| item.kind == Kind::Ellipsis) {
            return Err(unclear(span));
        }
        let before = items[..dots].iter().map(|item| self.eval(item)).collect::<Result<Vec<_>, _>>()?;
        let end = self.eval(last)?;
        let mut found: Vec<Vec<Value>> = Vec::new();
        for n in integers(last) {
            let places = with_integer(last, n, None).1;
            if places > MOST_PLACES {
                continue;
            }
            for mask in 1..1_u32 << places {
                // t + ⋯ + t^5: one term before the dots and one number to replace tell too little.
                if before.len() == 1 && mask.count_ones() == 1 {
                    continue;
                }
                if let Some(values) = self.values_of(last, (n, mask), &items[..dots], &before)
                    && !found.contains(&values)
                {
                    found.push(values);
                }
            }
        }
        if let Some(values) = powers(&before, &end).filter(|values| !found.contains(values)) {
            // Two numbers are too few to tell: 1/2 + 1/4 + ⋯ + 1/32.
            if before.len() < 3 {
                return Err(unclear(span));
            }
            found.push(values);
        }
        let [values] = found.as_mut_slice() else { return Err(unclear(span)) };
        let mut values = std::mem::take(values);
        for item in rest {
            values.push(self.eval(item)?);
        }
        Ok(values)
    }

    /// The values of a term for all integers up to n in the chosen places, if they begin with these. Numbers
    /// have to be written so, too, but for the first: 1^2 and 3^2 are 9^0 and 9^1 by chance.
    fn values_of(
        &mut self,
        last: &Expr,
        (n, mask): (i64, u32),
        written: &[Expr],
        before: &[Value],
    ) -> Option<Vec<Value>> {
        let numbers = before.iter().all(|value| value.as_rational().is_some());
        let mut at = |k: i64| {
            let notes = self.notes.len();
            let value = self.eval(&with_integer(last, n, Some((mask, k))).0).ok();
            self.notes.truncate(notes);
            value
        };
        let starts =
            |first: &i64| before.iter().zip(*first..).all(|(value, k)| at(k).as_ref() == Some(value));
        let first = (FIRST..=LAST.min(n)).find(starts)?;
        let as_written = |(item, k): (&Expr, i64)| item.same_as(&with_integer(last, n, Some((mask, k))).0);
        if numbers && !written.iter().zip(first..).skip(1).all(as_written) {
            return None;
        }
        let next = first + before.len() as i64;
        if next > n {
            return None;
        }
        crate::budget::charge_terms((n - next) as u64);
        let rest: Option<Vec<Value>> = (next..=n).map(&mut at).collect();
        Some([before.to_vec(), rest?].concat())
    }
}

/// The integers in a formula, each once.
fn integers(expr: &Expr) -> Vec<i64> {
    let mut found = Vec::new();
    fn collect(expr: &Expr, found: &mut Vec<i64>) {
        if let Some(n) = expr.as_int()
            && !found.contains(&n)
        {
            found.push(n);
        }
        expr.for_each_child(&mut |child| collect(child, found));
    }
    collect(expr, &mut found);
    found
}

/// The formula with another integer in the places of n that the bits of a mask choose, and how many places there are.
fn with_integer(expr: &Expr, n: i64, other: Option<(u32, i64)>) -> (Expr, u32) {
    fn replace(expr: &mut Expr, n: i64, other: Option<(u32, i64)>, places: &mut u32) {
        if expr.as_int() == Some(n) {
            if let Some((mask, k)) = other
                && mask >> *places & 1 == 1
            {
                let other = Expr::int(k);
                expr.kind = if k < 0 { other.grouped().kind } else { other.kind };
            }
            *places += 1;
            return;
        }
        expr.for_each_child_mut(&mut |child| replace(child, n, other, places));
    }
    let mut copy = expr.clone();
    let mut places = 0;
    replace(&mut copy, n, other, &mut places);
    (copy, places)
}

/// Numbers up to the last, if those before the dots are powers of one number times the first: 1 + 2 + 4 + ⋯ + 32.
fn powers(before: &[Value], end: &Value) -> Option<Vec<Value>> {
    /// More are not written with dots.
    const MOST: usize = 64;
    let mut values: Vec<Rational> = before.iter().map(Value::as_rational).collect::<Option<_>>()?;
    let end = end.as_rational()?;
    let [first, second, ..] = values.as_slice() else { return None };
    if first.is_zero() || second.is_zero() || first == second {
        return None;
    }
    let ratio = second / first;
    if values.windows(2).any(|pair| pair[1] != &pair[0] * &ratio) {
        return None;
    }
    while values.len() < MOST {
        let next = &values[values.len() - 1] * &ratio;
        values.push(next);
        if values.last() == Some(&end) {
            return Some(values.into_iter().map(Value::number).collect());
        }
    }
    None
}

fn unclear(span: Span) -> Diagnostic {
    unsupported("what the dots stand for is not clear")
        .at(span)
        .hint("write it with its index: sum(i=1..5, a_i t^i), prod(i=0..3, t - t_i)")
}
