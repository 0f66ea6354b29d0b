//! Lists with dots and braces written out: t_1, …, t_5.

use super::machine::Machine;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::ops::errors::unsupported;
use crate::language::value::Value;

impl Machine {
    /// Items of a list, with `a_1, ..., a_n` and underbraces written out.
    pub(crate) fn expand_items(&mut self, items: &[Expr]) -> Result<Vec<Value>, Diagnostic> {
        let mut values = Vec::with_capacity(items.len());
        let mut skip = false;
        for (at, item) in items.iter().enumerate() {
            if std::mem::take(&mut skip) {
                continue;
            }
            match &item.kind {
                Kind::Ellipsis => skip = self.fill_dots(items, at, &mut values)?,
                Kind::Brace(list, label) => {
                    let label = label.as_deref();
                    values.extend(self.repeated(list, label, item.span)?);
                }
                _ => values.push(self.eval(item)?),
            }
        }
        Ok(values)
    }

    /// Writes out the dots at a place; `values` has what stands before them. Says whether the item
    /// after them is to be left out.
    pub(super) fn fill_dots(
        &mut self,
        items: &[Expr],
        at: usize,
        values: &mut Vec<Value>,
    ) -> Result<bool, Diagnostic> {
        let span = items[at].span;
        let (Some(before), Some(after)) = (at.checked_sub(1).map(|i| &items[i]), items.get(at + 1)) else {
            return Err(unsupported("an ellipsis needs an item on both sides")
                .at(span)
                .hint("write the first and the last item: t1, ..., t5"));
        };
        let too_many = self.fill_ellipsis(before, after, values, span)?;
        if too_many > 1 {
            values.pop();
        }
        Ok(too_many > 0)
    }

    /// `t, ..., t` with a count below the brace.
    pub(super) fn repeated(
        &mut self,
        items: &[Expr],
        label: Option<&Expr>,
        span: Span,
    ) -> Result<Vec<Value>, Diagnostic> {
        let plain: Vec<&Expr> = items.iter().filter(|item| item.kind != Kind::Ellipsis).collect();
        let same = plain.windows(2).all(|pair| pair[0].same_as(pair[1]));
        match (label, plain.first()) {
            (Some(label), Some(item)) if same => {
                let count = self.eval_int(label)?;
                let count = usize::try_from(count).map_err(|_| {
                    Diagnostic::error(Code::Domain, format!("{count} copies make no sense")).at(label.span)
                })?;
                crate::budget::charge_terms(count as u64);
                Ok(vec![self.eval(item)?; count])
            }
            (Some(_), Some(_)) => self.expand_items(items),
            (None, Some(_)) if plain.len() == items.len() => self.expand_items(items),
            _ => Err(unsupported("how many copies the brace stands for is not said")
                .at(span)
                .hint("write the number below the brace: \\underbrace{t,\\ldots,t}_{3}")),
        }
    }

    /// Fills `a_1, ..., a_5` or `1, ..., n`: what stands before is already in `values`.
    ///
    /// Says how many of the two ends are too many: in t_1, ..., t_{i-1} one for i = 2, when both
    /// ends are t_1, and two for i = 1, when there is nothing at all.
    fn fill_ellipsis(
        &mut self,
        before: &Expr,
        after: &Expr,
        values: &mut Vec<Value>,
        span: Span,
    ) -> Result<usize, Diagnostic> {
        let unclear = || {
            unsupported("what the ellipsis stands for is not clear")
                .at(span)
                .hint("it is filled between numbers (1, ..., 5) and between indices (t1, ..., t5)")
        };
        // In 0, 2, ..., 10 the two numbers before the dots tell the step.
        let known: Vec<i64> = values.iter().rev().map_while(Value::as_int).collect();
        let (first, last) = (self.eval(before)?, self.eval(after)?);
        if let (Some(a), Some(b)) = (first.as_int(), last.as_int())
            && is_counted(before)
            && is_counted(after)
            && !are_members(before, after)
        {
            let Some(step) = step(&known, b) else { return Err(unclear()) };
            crate::budget::charge_terms(b.saturating_sub(a).unsigned_abs());
            let within = |x: &i64| if step > 0 { *x < b } else { *x > b };
            let next = |x: &i64| x.checked_add(step).filter(within);
            values.extend(std::iter::successors(next(&a), next).map(Value::int));
            return Ok(too_many(before, after, a, b));
        }
        let (Kind::Subscript(base, from), Kind::Subscript(_, to)) = (&before.kind, &after.kind) else {
            return Err(unclear());
        };
        let place = from.iter().zip(to).position(|(a, b)| !a.same_as(b)).ok_or_else(unclear)?;
        let (a, b) = (self.eval_int(&from[place])?, self.eval_int(&to[place])?);
        crate::budget::charge_terms(b.saturating_sub(a).max(0) as u64);
        for i in a + 1..b {
            let mut indices = from.clone();
            indices[place] = Expr::int(i);
            values.push(self.eval(&Kind::Subscript(base.clone(), indices).into())?);
        }
        Ok(too_many(&from[place], &to[place], a, b))
    }
}

/// Whether both ends are members of one family, a_0 and a_5: the dots are counted by their indices.
fn are_members(first: &Expr, last: &Expr) -> bool {
    match (&first.kind, &last.kind) {
        (Kind::Subscript(one, from), Kind::Subscript(other, to)) => {
            one.same_as(other) && from.len() == to.len()
        }
        _ => false,
    }
}

/// Whether a formula is a number of a progression as it is written, 3 or 2n - 1; 1^2 and 1*2 are not.
fn is_counted(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Number(_) | Kind::Name(_) | Kind::Subscript(..) => true,
        Kind::Add(terms) => terms.iter().all(|term| is_counted(&term.expr)),
        Kind::Mul(factors) => {
            factors.iter().all(is_counted)
                && factors.iter().filter(|factor| matches!(factor.kind, Kind::Number(_))).count() < 2
        }
        Kind::Group(body) => is_counted(body),
        _ => false,
    }
}

/// The step from the last of some integers, given first, to b: that between all of them. `None` if there is
/// none, or if 1, 4, ..., 25 may also be squares or 2, 4, ..., 32 powers.
fn step(known: &[i64], b: i64) -> Option<i64> {
    let (&[a, ref before @ ..], Some(&p)) = (known, known.get(1)) else { return Some(1) };
    let step = a.checked_sub(p)?;
    let even = known.windows(2).all(|pair| pair[0].checked_sub(pair[1]) == Some(step));
    let onwards = b >= a;
    // 3, 1, ..., 2 goes on from the 1.
    if step == 1 || step == 0 || (step < 0 && onwards) {
        return Some(1);
    }
    if !even || (onwards == (step > 0) && b.checked_sub(a)? % step != 0) {
        return None;
    }
    let root = |x: i64, k: u32| (1..=x.min(1000)).find(|r: &i64| r.checked_pow(k) == Some(x));
    let powers = |k: u32| match (root(p, k), root(a, k), root(b, k)) {
        (Some(p), Some(a), Some(_)) => a == p + 1,
        _ => false,
    };
    let is_geometric = p > 0 && a % p == 0 && {
        let ratio = a / p;
        let mut x = a;
        while x < b && ratio > 1 {
            x = x.saturating_mul(ratio);
        }
        x == b && ratio > 1
    };
    let other = before.len() == 1 && (is_geometric || (2..=4).any(powers));
    (!other).then_some(step)
}

/// How many of the ends a and b of dots are too many: none if both are written as numbers.
fn too_many(from: &Expr, to: &Expr, a: i64, b: i64) -> usize {
    let literal = |index: &Expr| matches!(index.kind, Kind::Number(_));
    if literal(from) && literal(to) {
        return 0;
    }
    usize::try_from(a.saturating_sub(b).saturating_add(1)).unwrap_or(0).min(2)
}
