//! Terms and names at the ends of dots: what changes from one end to the other.

use crate::formula::{Expr, Kind};
use crate::judge::written::names::Head;
use crate::language::eval::Machine;

/// In t_2, t_1, …, t_n the dots do not stand for t_2 again. `list` is what stands for t_1, …, t_n, the
/// last one as written being `last`. `None` if a name that is pulled forward does not exist (n = 1).
pub(super) fn not_yet_named(mut list: Vec<Expr>, items: &[Expr], last: &Expr) -> Option<Vec<Expr>> {
    let index = |expr: &Expr| Head::of(expr)?.index()?.as_number().cloned();
    let (Some(first), None) = (list.first().and_then(index), index(last)) else { return Some(list) };
    let written = Head::of(last)?;
    for ahead in items.iter().take_while(|item| item.kind != Kind::Ellipsis) {
        let pulled = Head::of(ahead).is_some_and(|head| head.base == written.base)
            && index(ahead).is_some_and(|index| index > first);
        if pulled {
            let at = list.iter().position(|entry| entry.same_as(ahead))?;
            list.remove(at);
        }
    }
    Some(list)
}

/// How a term changes from one end of the dots to the other.
pub(super) struct Steps {
    first: Expr,
    /// Paths to the integers that change, with their first value and their step.
    places: Vec<(Vec<usize>, i64, i64)>,
    /// How many steps lead to the other end; −1 if it comes just before.
    pub(super) count: i64,
}

impl Steps {
    /// From the first end to the last; `None` if they differ in other ways than by integers.
    pub(super) fn between(machine: &mut Machine, first: &Expr, last: &Expr) -> Option<Steps> {
        let mut ends = Vec::new();
        differences(machine, first, last, &mut Vec::new(), &mut ends)?;
        let count = ends.iter().map(|(_, a, b)| (b - a).abs()).max()?;
        // One index that goes back by one leaves nothing between the ends.
        if let [(path, a, b)] = ends.as_slice() {
            return Some(Steps { first: first.clone(), places: vec![(path.clone(), *a, 1)], count: b - a });
        }
        let mut places = Vec::with_capacity(ends.len());
        for (path, a, b) in ends {
            if (b - a).abs() != count {
                return None;
            }
            places.push((path, a, (b - a).signum()));
        }
        Some(Steps { first: first.clone(), places, count })
    }

    /// The term after `k` steps.
    pub(super) fn at(&self, k: i64) -> Expr {
        let mut term = self.first.clone();
        for (path, start, step) in &self.places {
            replace(&mut term, path, &Expr::int(start + k * step));
        }
        term
    }
}

fn replace(expr: &mut Expr, path: &[usize], by: &Expr) {
    let Some((first, rest)) = path.split_first() else {
        *expr = by.clone();
        return;
    };
    let mut at = 0;
    expr.for_each_child_mut(&mut |child| {
        if at == *first {
            replace(child, rest, by);
        }
        at += 1;
    });
}

/// The places where two formulas of the same shape hold different integers.
fn differences(
    machine: &mut Machine,
    a: &Expr,
    b: &Expr,
    path: &mut Vec<usize>,
    found: &mut Vec<(Vec<usize>, i64, i64)>,
) -> Option<()> {
    if a.same_as(b) {
        return Some(());
    }
    let whole = matches!(a.kind, Kind::Number(_) | Kind::Name(_) | Kind::Add(_) | Kind::Mul(_));
    if whole && let (Some(x), Some(y)) = (integer(machine, a), integer(machine, b)) {
        // They may be equal by chance: t_1, …, t_n with n = 1.
        found.push((path.clone(), x, y));
        return Some(());
    }
    if std::mem::discriminant(&a.kind) != std::mem::discriminant(&b.kind) {
        return None;
    }
    let (mut left, mut right) = (Vec::new(), Vec::new());
    a.for_each_child(&mut |child| left.push(child));
    b.for_each_child(&mut |child| right.push(child));
    if left.len() != right.len() || left.is_empty() {
        return None;
    }
    for (i, (x, y)) in left.into_iter().zip(right).enumerate() {
        path.push(i);
        differences(machine, x, y, path, found)?;
        path.pop();
    }
    Some(())
}

fn integer(machine: &mut Machine, expr: &Expr) -> Option<i64> {
    machine.eval(expr).ok()?.as_int()
}
