//! Polar forms called with brackets: b\[t_1, t_2, t_3\] or b⟨t_1, t_2, t_3⟩ beside the curve b(t).

use std::collections::BTreeSet;

use super::primes::each;
use crate::formula::{Accent, Expr, Kind, bracketed};
use crate::judge::names::{Head, walk};
use crate::judge::statement::Statement;
use crate::judge::topic::Topic;

/// Reads a bracket after a letter as arguments where the page, or a section with that letter, speaks of polar forms
/// and not of divided differences. A letter that is applied with parentheses, too, gets another name with brackets.
///
/// Cost: linear in the formulas.
pub(super) fn as_arguments(statements: &mut [Statement]) {
    let polar = |s: &Statement| s.topics.has(Topic::PolarForm) && !s.topics.has(Topic::DividedDifference);
    let differences = statements.iter().any(|s| s.topics.has(Topic::DividedDifference));
    let mut letters = BTreeSet::new();
    let mut called = BTreeSet::new();
    let general = !differences && statements.iter().any(polar);
    for statement in statements.iter_mut() {
        let meant = general || polar(statement);
        each(statement, &mut |expr| {
            walk(expr, &mut |part| match &part.kind {
                Kind::Mul(factors) if meant => {
                    let pairs = factors.windows(2);
                    letters.extend(pairs.filter_map(|pair| call(&pair[0], &pair[1]).map(|head| head.base)));
                }
                Kind::Apply(callee, groups) if groups.iter().flatten().count() == 1 => {
                    called.extend(Head::of(underived(callee)).map(|head| head.base));
                }
                _ => {}
            });
        });
    }
    if letters.is_empty() {
        return;
    }
    for statement in statements {
        each(statement, &mut |expr| apply(expr, &letters, &called));
    }
}

/// A function without the marks of derivatives: F of F'(t).
fn underived(callee: &Expr) -> &Expr {
    match &callee.kind {
        Kind::Prime(function, _) | Kind::Accent(Accent::Dot | Accent::Ddot, function) => function,
        _ => callee,
    }
}

/// What stands in a bracket of one of these kinds.
fn inside(bracket: &Expr) -> Option<&[Expr]> {
    match &bracket.kind {
        Kind::List(items) => Some(items),
        Kind::Apply(callee, groups) if matches!(&callee.kind, Kind::Name(name) if name == "inner") => {
            groups.first().map(Vec::as_slice)
        }
        _ => None,
    }
}

/// The letter before a bracket with several items.
fn call(function: &Expr, bracket: &Expr) -> Option<Head> {
    let several = inside(bracket).is_some_and(|items| items.len() > 1);
    // s_j[u, v] is the polar form of a piece.
    let plain = |head: &Head| head.lower.len() < 2 && head.upper.is_empty() && head.arguments.is_none();
    Head::of(function).filter(|head| several && plain(head))
}

fn apply(expr: &mut Expr, letters: &BTreeSet<String>, called: &BTreeSet<String>) {
    expr.for_each_child_mut(&mut |child| apply(child, letters, called));
    let Kind::Mul(factors) = &mut expr.kind else { return };
    let mut at = 0;
    while at + 1 < factors.len() {
        if let Some(head) = call(&factors[at], &factors[at + 1])
            && letters.contains(&head.base)
            && let Some(items) = inside(&factors[at + 1])
        {
            let mut callee = factors[at].clone();
            if called.contains(&head.base) {
                rename(&mut callee);
            }
            let span = callee.span.to(factors[at + 1].span);
            let value = Expr::new(Kind::Apply(Box::new(callee), vec![items.to_vec()]), span);
            factors.splice(at..at + 2, [value]);
        }
        at += 1;
    }
    if let [only] = factors.as_slice() {
        *expr = only.clone();
    }
}

fn rename(callee: &mut Expr) {
    match &mut callee.kind {
        Kind::Name(name) => *name = bracketed(name),
        Kind::Accent(Accent::Bold | Accent::Script | Accent::Blackboard, inner)
        | Kind::Subscript(inner, _) => rename(inner),
        _ => {}
    }
}
