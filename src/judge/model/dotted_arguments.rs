//! Dots and braces among arguments: t_1, …, t_n, and t, …, t over a brace with a count.

use super::Model;
use super::arguments::is_counted;
use super::calls::unclear;
use super::dots::run;
use super::steps::not_yet_named;
use crate::formula::{Accent, Expr, Kind};
use crate::judge::written::names::{Head, walk};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::value::Value;

impl Model {
    /// Arguments with dots and braces written out.
    pub(super) fn dotted_arguments(
        &self,
        machine: &mut Machine,
        items: &[Expr],
        arity: Option<usize>,
        expr: &Expr,
    ) -> Result<Vec<Value>, Diagnostic> {
        // First the braces, which say how many.
        let mut pieces: Vec<Piece> = Vec::with_capacity(items.len());
        let is_dots = |at: Option<usize>| {
            at.and_then(|at| items.get(at)).is_some_and(|item| item.kind == Kind::Ellipsis)
        };
        for (at, item) in items.iter().enumerate() {
            match &item.kind {
                Kind::Brace(list, Some(label)) => {
                    let values = self.braced(machine, list, label, expr)?;
                    pieces.push(Piece::Values(values));
                }
                // f(t^r, t_{i+1}, …, t_{i+n-r}), but not f(1, t, t^2, …, t^n)
                _ if is_counted(item) && !is_dots(Some(at + 1)) && !is_dots(at.checked_sub(1)) => {
                    pieces.push(Piece::Values(self.copies(machine, item)?));
                }
                Kind::Brace(list, None) => pieces.extend(list.iter().cloned().map(Piece::Item)),
                _ => pieces.push(Piece::Item(item.clone())),
            }
        }
        // Then dots between the same item twice: as many as are missing.
        let mut flexible: Option<usize> = None;
        let mut values: Vec<Value> = Vec::new();
        let mut at = 0;
        while at < pieces.len() {
            let item = match &pieces[at] {
                Piece::Values(list) => {
                    values.extend(list.iter().cloned());
                    at += 1;
                    continue;
                }
                Piece::Item(item) => item.clone(),
            };
            let next = |k: usize| match pieces.get(at + k) {
                Some(Piece::Item(item)) => Some(item),
                _ => None,
            };
            let dots = next(1).is_some_and(|item| item.kind == Kind::Ellipsis);
            match (dots, next(2)) {
                // t_1, …, X, …, t_d: X stands at one place of the list
                (true, Some(middle))
                    if next(3).is_some_and(|item| item.kind == Kind::Ellipsis)
                        && next(4).is_some_and(|last| same_base(&item, last)) =>
                {
                    let last = next(4).cloned().unwrap_or_else(|| item.clone());
                    let others = values.len() + pieces.len() - at - 5;
                    let own = arity.map(|arity| arity.saturating_sub(others));
                    values.extend(self.with_one_replaced(machine, &item, middle, &last, own, expr)?);
                    at += 5;
                }
                (true, Some(after)) if after.same_as(&item) => {
                    if flexible.is_some() {
                        return Err(unclear("how many arguments the dots stand for", expr));
                    }
                    let value = self.argument(machine, &item)?;
                    values.push(value.clone());
                    flexible = Some(values.len());
                    values.push(value);
                    at += 3;
                }
                (true, Some(after)) => {
                    let list = run(machine, &item, after)
                        .and_then(|list| not_yet_named(list, items, after))
                        .ok_or_else(|| unclear("what the dots stand for", expr))?;
                    for entry in list {
                        values.push(self.argument(machine, &entry)?);
                    }
                    at += 3;
                }
                // f(u, …, u, 1̂, …) with nothing after the dots
                (true, None) => {
                    return Err(unclear("where the dots end", expr));
                }
                (false, _) => {
                    if item.kind == Kind::Ellipsis {
                        return Err(unclear("what the dots stand for", expr));
                    }
                    values.push(self.argument(machine, &item)?);
                    at += 1;
                }
            }
        }
        if let Some(place) = flexible {
            let arity = arity.unwrap_or_else(|| {
                self.record.borrow_mut().flexible = true;
                self.flexible.set(true);
                values.len()
            });
            // Both ends of t, …, t are one item if there is room for one only.
            let filler = values[place].clone();
            let others = values.len() - 2;
            let Some(count) = arity.checked_sub(others) else {
                return Err(Diagnostic::error(Code::Arity, "more arguments than the degree").at(expr.span));
            };
            values.splice(place - 1..=place, std::iter::repeat_n(filler, count));
        }
        Ok(values)
    }

    /// What stands over a brace with a count.
    fn braced(
        &self,
        machine: &mut Machine,
        list: &[Expr],
        label: &Expr,
        expr: &Expr,
    ) -> Result<Vec<Value>, Diagnostic> {
        let count = machine.eval_int(label)?;
        let Ok(count) = usize::try_from(count) else {
            return Err(
                Diagnostic::error(Code::Domain, format!("{count} copies make no sense")).at(label.span)
            );
        };
        crate::budget::charge_terms(count as u64);
        let plain: Vec<&Expr> = list.iter().filter(|item| item.kind != Kind::Ellipsis).collect();
        let dots = list.iter().position(|item| item.kind == Kind::Ellipsis);
        match (plain.as_slice(), dots) {
            ([], _) => Err(unclear("what the brace holds", expr)),
            ([one], _) => Ok(vec![self.argument(machine, one)?; count]),
            (many, Some(_)) if many.windows(2).all(|pair| pair[0].same_as(pair[1])) => {
                Ok(vec![self.argument(machine, many[0])?; count])
            }
            (many, Some(dots)) if dots > 0 => {
                if let Some(after) = list.get(dots + 1)
                    && let Some(entries) = run(machine, &list[dots - 1], after)
                {
                    let mut values = Vec::new();
                    for item in &list[..dots - 1] {
                        values.push(self.argument(machine, item)?);
                    }
                    for entry in entries {
                        values.push(self.argument(machine, &entry)?);
                    }
                    for item in &list[dots + 2..] {
                        values.push(self.argument(machine, item)?);
                    }
                    if values.len() != count {
                        self.record.borrow_mut().mixed = true;
                    }
                    return Ok(values);
                }
                // u, …, u, 1̂ over n − q: the dots repeat what stands before them.
                let mut values = Vec::new();
                for item in many {
                    values.push(self.argument(machine, item)?);
                }
                let Some(missing) = count.checked_sub(values.len()) else {
                    // Fewer than are written: the repeated ones go first.
                    let surplus = values.len() - count;
                    if surplus <= dots + 1 {
                        values.drain(..surplus);
                        return Ok(values);
                    }
                    return Err(
                        Diagnostic::error(Code::Arity, "more items than the brace says").at(expr.span)
                    );
                };
                let filler = values[dots - 1].clone();
                values.splice(dots..dots, std::iter::repeat_n(filler, missing));
                Ok(values)
            }
            (many, _) => {
                let mut values = Vec::new();
                for item in many {
                    values.push(self.argument(machine, item)?);
                }
                if values.len() != count {
                    self.record.borrow_mut().mixed = true;
                }
                Ok(values)
            }
        }
    }

    /// t_1, …, X, …, t_d with X in the place of the t_i that it is made of; t_i with a hat is left out where one
    /// argument is too many.
    fn with_one_replaced(
        &self,
        machine: &mut Machine,
        first: &Expr,
        middle: &Expr,
        last: &Expr,
        arity: Option<usize>,
        expr: &Expr,
    ) -> Result<Vec<Value>, Diagnostic> {
        let (Some(head), Some(end)) = (Head::of(first), Head::of(last)) else {
            return Err(unclear("what the dots stand for", expr));
        };
        let ([from], [to]) = (head.lower.as_slice(), end.lower.as_slice()) else {
            return Err(unclear("what the dots stand for", expr));
        };
        let (from_value, to_value) = (machine.eval_int(from)?, machine.eval_int(to)?);
        let mut own: Option<Expr> = None;
        walk(middle, &mut |part| {
            if own.is_none()
                && let Some(inner) = Head::of(part)
                && inner.base == head.base
                && let Some(index) = inner.lower.first()
            {
                own = Some(match &index.kind {
                    Kind::Mul(factors) => factors[0].clone(),
                    _ => index.clone(),
                });
            }
        });
        let place = match own {
            Some(index) => machine.eval_int(&index)?,
            None => from_value + 1,
        };
        if !(from_value..=to_value).contains(&place) {
            return Err(Diagnostic::error(Code::Domain, "there is no such argument").at(expr.span));
        }
        let whole = usize::try_from(to_value - from_value + 1).ok();
        let left_out = matches!(&middle.kind, Kind::Accent(Accent::Hat, inner) if same_base(inner, first))
            && arity.is_none_or(|arity| Some(arity) != whole);
        let mut values = Vec::new();
        for i in from_value..=to_value {
            if i == place && left_out {
                continue;
            }
            if i == place {
                values.push(machine.eval(middle)?);
            } else {
                let Kind::Subscript(base, _) = &strip(first).kind else {
                    return Err(unclear("what the dots stand for", expr));
                };
                let entry = Expr::new(Kind::Subscript(base.clone(), vec![Expr::int(i)]), expr.span);
                values.push(self.argument(machine, &entry)?);
            }
        }
        Ok(values)
    }
}

/// Part of a list of arguments.
enum Piece {
    Item(Expr),
    Values(Vec<Value>),
}

fn strip(expr: &Expr) -> &Expr {
    match &expr.kind {
        Kind::Accent(Accent::Bold, inner) => strip(inner),
        _ => expr,
    }
}

fn same_base(a: &Expr, b: &Expr) -> bool {
    match (Head::of(a), Head::of(b)) {
        (Some(a), Some(b)) => {
            a.base == b.base
                && a.lower.len() == 1
                && b.lower.len() == 1
                && a.upper.is_empty()
                && b.upper.is_empty()
        }
        _ => false,
    }
}
