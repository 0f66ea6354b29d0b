//! Functions with an index above: N^2(2x - 1), where words say that N^p is a B-spline, is a value and no product.

use std::collections::BTreeSet;

use super::primes::each;
use crate::formula::{Expr, Kind};
use crate::judge::page::statement::{Said, Statement};

/// Reads a bracket after such a letter with its index as an argument.
///
/// Cost: linear in the formulas.
pub(super) fn as_calls(statements: &mut [Statement]) {
    let mut letters: BTreeSet<String> = BTreeSet::new();
    for statement in statements.iter() {
        if let Said::Object(object) = &statement.said
            && object.is_function()
        {
            letters.extend(object.names.iter().filter_map(|name| letter(name)).map(str::to_owned));
        }
    }
    if letters.is_empty() {
        return;
    }
    for statement in statements {
        each(statement, &mut |expr| apply(expr, &letters));
    }
}

/// The letter of N^p.
fn letter(expr: &Expr) -> Option<&str> {
    match &expr.kind {
        Kind::Pow(base, _) | Kind::Upper(base, _) => match &base.kind {
            Kind::Name(name) => Some(name),
            _ => None,
        },
        _ => None,
    }
}

fn apply(expr: &mut Expr, letters: &BTreeSet<String>) {
    expr.for_each_child_mut(&mut |child| apply(child, letters));
    let Kind::Mul(factors) = &mut expr.kind else { return };
    let mut at = 0;
    while at + 1 < factors.len() {
        let called = letter(&factors[at]).is_some_and(|letter| letters.contains(letter));
        if let (true, Kind::Group(argument)) = (called, &factors[at + 1].kind) {
            let span = factors[at].span.to(factors[at + 1].span);
            let call = Kind::Apply(Box::new(factors[at].clone()), vec![vec![argument.as_ref().clone()]]);
            factors.splice(at..at + 2, [Expr::new(call, span)]);
        }
        at += 1;
    }
    if let [only] = factors.as_slice() {
        *expr = only.clone();
    }
}
