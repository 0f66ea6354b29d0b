//! The claims in a formula: each relation of a chain, as its two sides are evaluated.

use std::sync::Arc;

use crate::formula::{Expr, Kind, Link};
use crate::judge::values::equality;
use crate::language::diagnostic::Diagnostic;
use crate::language::eval::Machine;
use crate::language::ops::formula::symbol_of;
use crate::language::ops::polar::laws_report;
use crate::language::value::{Judgement, Polar, PolarKind, Value, Verdict};
use crate::math::blossom::laws::ArgumentNames;
use crate::math::poly::Symbol;

/// Judges each relation of a chain as it stands.
pub(crate) fn judge_plainly(
    machine: &mut Machine,
    first: &Expr,
    links: &[Link],
) -> Result<Vec<Judgement>, Diagnostic> {
    let mut judgements = Vec::with_capacity(links.len());
    let (mut left_expr, mut left) = (first, machine.eval(first)?);
    for link in links {
        let right = machine.eval(&link.expr)?;
        let mut judgement = equality::judge(link.rel, &left, &right).map_err(|error| error.at(link.span))?;
        if judgement.verdict == Verdict::Refuted {
            let reasons = explain(machine, left_expr, &left, &link.expr, &right)?;
            judgement.reasons.splice(0..0, reasons);
        }
        judgements.push(judgement);
        (left_expr, left) = (&link.expr, right);
    }
    Ok(judgements)
}

/// Reasons for a wrong claim about a polar form: which law fails, which coefficient is off.
fn explain(
    machine: &mut Machine,
    left_expr: &Expr,
    left: &Value,
    right_expr: &Expr,
    right: &Value,
) -> Result<Vec<String>, Diagnostic> {
    let calls = [polar_at_symbols(machine, left_expr)?, polar_at_symbols(machine, right_expr)?];
    if calls.iter().all(Option::is_some) {
        // Two values of polar forms: neither is a proposed polar form.
        return Ok(Vec::new());
    }
    for (call, claim) in [(left_expr, right), (right_expr, left)] {
        if let Some((polar, arrangement)) = polar_at_symbols(machine, call)?
            && let Value::Scalar(claim) = claim
        {
            return Ok(laws_report(&polar, claim, &arrangement));
        }
    }
    Ok(Vec::new())
}

/// A polar form applied to distinct symbols: the form and its arguments.
fn polar_at_symbols(
    machine: &mut Machine,
    call: &Expr,
) -> Result<Option<(Arc<Polar>, ArgumentNames)>, Diagnostic> {
    let Kind::Apply(callee, groups) = &call.kind else { return Ok(None) };
    let Ok(Value::Polar(polar)) = machine.eval(callee) else { return Ok(None) };
    let mut lists: Vec<Vec<Vec<Symbol>>> = Vec::new();
    for group in groups {
        let mut list = Vec::new();
        for value in machine.expand_items(group)? {
            let Some(symbols) = symbols_of(&value) else { return Ok(None) };
            list.push(symbols);
        }
        lists.push(list);
    }
    if let (PolarKind::Tensor(form), [all]) = (&polar.kind, lists.as_slice()) {
        let (m, n) = form.degrees();
        if all.len() == m + n {
            lists = vec![all[..m].to_vec(), all[m..].to_vec()];
        }
    }
    let mut flat: Vec<&Symbol> = lists.iter().flatten().flatten().collect();
    let count = flat.len();
    flat.sort();
    flat.dedup();
    let fits = lists.iter().map(Vec::len).eq(polar.arity());
    Ok((fits && flat.len() == count).then(|| (polar, ArgumentNames::new(lists))))
}

/// The symbols of an argument: one for a number, several for a point.
fn symbols_of(value: &Value) -> Option<Vec<Symbol>> {
    match value {
        Value::List(items) => items.iter().map(symbol_of).collect(),
        other => symbol_of(other).map(|symbol| vec![symbol]),
    }
}
