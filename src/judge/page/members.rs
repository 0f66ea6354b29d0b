//! Members that dots leave out: (t_1, …, t_7) = (0, 0, 0, 1, 2, 2, 2) is said of t_1, t_2, …, t_7.

use crate::formula::{Expr, Kind};
use crate::judge::page::statement::Chain;
use crate::judge::written::names::Head;

/// The chain with lists of members written out, where another side has as many items; `is_known` tells whether the page has a
/// formula for the members of a family: else the list says what they are.
pub(in crate::judge) fn with_members_listed(chain: &Chain, is_known: &dyn Fn(&str) -> bool) -> Option<Chain> {
    let dotted = |expr: &Expr| match expr.items() {
        Some([first, Expr { kind: Kind::Ellipsis, .. }, last]) => Some((first.clone(), last.clone())),
        _ => None,
    };
    let at = chain.sides.iter().position(|side| dotted(&side.expr).is_some())?;
    let (first, last) = dotted(&chain.sides[at].expr)?;
    let (one, other) = (Head::of(&first)?, Head::of(&last)?);
    let (from, to) = (one.index()?.as_int()?, other.index()?.as_int()?);
    let count = usize::try_from(to - from + 1).ok()?;
    let fits = |expr: &Expr| {
        expr.items().is_some_and(|items| {
            items.len() == count && !items.iter().any(|item| item.kind == Kind::Ellipsis)
        })
    };
    let alike = one.base == other.base && one.arguments.is_none() && one.upper.is_empty();
    if !alike
        || !is_known(&one.base)
        || !other.upper.is_empty()
        || !chain.sides.iter().any(|side| fits(&side.expr))
    {
        return None;
    }
    let member = |index: i64| {
        let mut member = first.clone();
        if let Kind::Subscript(_, lower) = &mut member.kind {
            lower[0] = Expr::new(Expr::int(index).kind, lower[0].span);
        }
        member
    };
    let mut listed = chain.clone();
    if let Kind::Tuple(items) | Kind::List(items) = &mut listed.sides[at].expr.kind {
        *items = (from..=to).map(member).collect();
    }
    Some(listed)
}
