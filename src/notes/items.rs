//! The items of a formula with commas: what stands together is put together.

use super::conditions::is_condition;
use super::speech;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Rel};
use crate::judge::written::names::{bases, is_index_letter};
use crate::language::eval::is_decimal_part;

/// t_0, …, t_3 = 0, 0, 1, 1 and a_0, …, a_3 = ¼(1, 3, 3, 1): one list equals the other.
fn listed_values(items: &[Expr]) -> Option<Expr> {
    let at = items.iter().position(|item| matches!(item.kind, Kind::Chain(..)))?;
    let Kind::Chain(left, links) = &items[at].kind else { return None };
    let [Link { rel: Rel::Eq, span, expr: first }] = links.as_slice() else { return None };
    let inside = left.items().filter(|_| at == 0);
    let names: Vec<Expr> = match inside {
        Some(names) => names.to_vec(),
        None => items[..at].iter().chain([left.as_ref()]).cloned().collect(),
    };
    let list = multiplied(first).filter(|list| list.len() > 1 && at + 1 == items.len());
    let values = match &list {
        Some(list) => list.clone(),
        None => [first].into_iter().chain(&items[at + 1..]).cloned().collect(),
    };
    let member = |name: &&Expr| matches!(name.kind, Kind::Subscript(..));
    let index = |name: &Expr| match &name.kind {
        Kind::Subscript(_, lower) => lower.first()?.as_int(),
        _ => None,
    };
    let dots = names.iter().any(|name| name.kind == Kind::Ellipsis);
    let named = names.iter().filter(|name| name.kind != Kind::Ellipsis).all(|name| member(&name));
    let (least, count) = match dots {
        true => (index(names.first()?)?, index(names.last()?)? - index(names.first()?)? + 1),
        false => (0, names.len() as i64),
    };
    let constant = values.iter().all(|value| bases(value).is_empty() && value.kind != Kind::Ellipsis);
    let apart = at > 0 || inside.is_some() && list.is_some();
    if !(apart && named && constant && count == values.len() as i64) {
        return None;
    }
    let names = match (&names[0].kind, list.is_some() && dots) {
        (Kind::Subscript(letter, _), true) => (least..least + count)
            .map(|j| Expr::new(Kind::Subscript(letter.clone(), vec![Expr::int(j)]), names[0].span))
            .collect(),
        _ => names,
    };
    let start = if at == 0 { left.span } else { items[0].span };
    let end = items[at + 1..].last().map_or(first.span, |last| last.span);
    let left = Expr::new(Kind::Tuple(names), start.to(left.span));
    let right = Expr::new(Kind::Tuple(values), first.span.to(end));
    let link = Link { rel: Rel::Eq, span: *span, expr: right };
    Some(Expr::new(Kind::Chain(Box::new(left), vec![link]), start.to(end)))
}

/// The items of a list, each with the number before it: ¼(1, 3, 3, 1).
fn multiplied(list: &Expr) -> Option<Vec<Expr>> {
    match &list.kind {
        Kind::Mul(factors) => {
            let (last, before) = factors.split_last()?;
            let items = last.items().filter(|_| before.iter().all(|factor| bases(factor).is_empty()))?;
            let one = |item: &Expr| {
                let product = Expr::product(before.iter().chain([item]).cloned().collect());
                Expr::new(product.kind, item.span)
            };
            Some(items.iter().map(one).collect())
        }
        _ => list.items().map(<[Expr]>::to_vec),
    }
}

/// Two conditions with "or" between them as one.
pub(super) fn with_alternatives(items: Vec<Expr>) -> Vec<Expr> {
    let mut result: Vec<Expr> = Vec::with_capacity(items.len());
    for item in items {
        if let [.., one, Expr { kind: Kind::Text(text), .. }] = result.as_slice()
            && speech::goes_on(text) == Some(true)
            && [one, &item].into_iter().all(|side| is_condition(side, true) || side.alternatives().is_some())
        {
            let one = one.clone();
            result.truncate(result.len() - 2);
            let both = one.alternatives().map_or_else(|| vec![one.clone()], <[Expr]>::to_vec);
            let span = one.span.to(item.span);
            let any = Expr::any(both.into_iter().chain([item]).collect());
            result.push(Expr::new(any.kind, span));
        } else {
            result.push(item);
        }
    }
    result
}

/// Puts `i = 0, …, n`, which the reader gives as three pieces, together as i = 0..n.
pub(super) fn regrouped(items: Vec<Expr>) -> Vec<Expr> {
    if let Some(lists) = listed_values(&items) {
        return vec![lists];
    }
    let mut result: Vec<Expr> = Vec::with_capacity(items.len());
    let mut rest = items.into_iter().peekable();
    while let Some(item) = rest.next() {
        if let Kind::Chain(left, links) = &item.kind
            && let [Link { rel: Rel::Eq, span, expr: from }] = links.as_slice()
            && matches!(left.kind, Kind::Name(_))
            && rest.peek().is_some_and(|next| {
                matches!(next.kind, Kind::Ellipsis | Kind::Number(_) | Kind::Add(_) | Kind::Name(_))
            })
        {
            let mut taken = Vec::new();
            while let Some(next) = rest.next_if(|next| {
                matches!(next.kind, Kind::Ellipsis | Kind::Number(_) | Kind::Add(_) | Kind::Name(_))
            }) {
                taken.push(next);
            }
            let dots = taken.iter().any(|e| e.kind == Kind::Ellipsis);
            let index = matches!(&left.kind, Kind::Name(letter) if is_index_letter(letter));
            // k = 0, 1, 2
            let first = from.as_int();
            let follows =
                |(at, next): (usize, &Expr)| next.as_int() == first.map(|first| first + at as i64 + 1);
            let consecutive = || first.is_some() && taken.iter().enumerate().all(follows);
            let restricted = taken.last().and_then(|last| {
                let (rel, expr) = if dots && last.kind != Kind::Ellipsis || !dots && index && consecutive() {
                    let range = Kind::Range(Box::new(from.clone()), Box::new(last.clone()));
                    (Rel::Eq, Expr::new(range, from.span.to(last.span)))
                } else if dots && index {
                    // i = 0, 1, 2, …, without an end
                    (Rel::Ge, from.clone())
                } else {
                    return None;
                };
                let link = Link { rel, span: *span, expr };
                Some(Expr::new(Kind::Chain(left.clone(), vec![link]), item.span.to(last.span)))
            });
            match restricted {
                Some(restricted) => result.push(restricted),
                None => {
                    result.push(item);
                    result.extend(taken);
                }
            }
            continue;
        }
        match item.kind {
            Kind::Tuple(inner) if inner.iter().any(|e| matches!(e.kind, Kind::Chain(..))) => {
                result.extend(regrouped(inner));
            }
            Kind::Group(inner) if matches!(inner.kind, Kind::Chain(..)) => result.push(*inner),
            _ => result.push(item),
        }
    }
    result
}

/// {u_0 < u_1 < … < u_m} has the members u_0, …, u_m.
pub(super) fn ordered_members(expr: &mut Expr) {
    if let Kind::Set(members, None) = &mut expr.kind
        && let [Expr { kind: Kind::Chain(first, links), .. }] = members.as_slice()
        && links.len() > 1
        && links.iter().all(|link| matches!(link.rel, Rel::Lt | Rel::Le))
    {
        *members =
            std::iter::once(first.as_ref()).chain(links.iter().map(|link| &link.expr)).cloned().collect();
    }
    expr.for_each_child_mut(&mut ordered_members);
}

/// In 2{.}5 · 2 = 5 and 1.000,5 + 1 = … a sign without space stands between two numbers: it may be that of a decimal number
/// that is not read, so that what follows it is half of something.
pub(super) fn with_doubtful_numbers(items: Vec<Expr>, between: impl Fn(Span) -> bool) -> Vec<Expr> {
    let mut found: Vec<Expr> = Vec::with_capacity(items.len());
    for mut item in items {
        if let (Some(before), Kind::Chain(left, _)) = (found.last(), &mut item.kind)
            && before.span.end < left.span.start
            && is_decimal_part(before, left)
            && between(Span::new(before.span.end, left.span.start))
        {
            **left = Expr::new(Kind::Unread("a decimal sign, or two numbers?".to_owned()), left.span);
        }
        found.push(item);
    }
    found
}
