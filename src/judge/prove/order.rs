//! Equations that are shown by two others.
//!
//! **Integrals**: ∫_a^t F(x) dx = G(t) follows from G(a) = 0 and d/dt G(t) = F(t).
//!
//! **Derivatives of symbolic order**: d^k/dt^k F = G(k) for all k ≥ 0 by induction on k. It is
//! to be shown that F = G(0) and d/dt G(k) = G(k+1). The induction runs through all
//! smaller k, so G must have a value for each of them: the inequalities under which it has one
//! describe an interval of k that contains 0, and no denominator depends on k.

use super::read::{Lookup, Reader};
use crate::formula::{Expr, Kind, Sign, Term};
use crate::math::poly::Symbol;

/// Two equations from which another one follows.
pub struct Equations {
    /// F = G(0), or G(a) = 0.
    pub start: (Expr, Expr),
    /// d/dt G(k) = G(k+1), or d/dt G(t) = F(t).
    pub step: (Expr, Expr),
    /// How the other one follows.
    pub reason: &'static str,
}

/// The equations for a side of one of the kinds at the head of this module.
pub fn equations(left: &Expr, right: &Expr, lookup: Lookup<'_>) -> Option<Equations> {
    of_integral(left, right, lookup).or_else(|| of_order(left, right, lookup))
}

fn of_integral(left: &Expr, right: &Expr, lookup: Lookup<'_>) -> Option<Equations> {
    let Kind::Integral { lower: Some(from), upper: Some(to), body, variable } = &left.kind else {
        return None;
    };
    let (Kind::Name(t), Kind::Name(x)) = (&to.kind, &variable.kind) else { return None };
    let free = |expr: &Expr| lookup(expr).is_none();
    if mentions(from, t)
        || mentions(from, x)
        || binds(right, t)
        || !mentions(right, t)
        || !free(to)
        || !free(variable)
    {
        return None;
    }
    if t != x && (mentions(body, t) || binds(body, x)) {
        return None;
    }
    let slope = Kind::Derivative {
        partial: false,
        variables: vec![((**to).clone(), None)],
        body: Some(Box::new(right.clone())),
    };
    Some(Equations {
        start: (put(right, t, &(**from).clone().grouped()), Expr::int(0)),
        step: (slope.into(), put(body, x, to)),
        reason: "by differentiation",
    })
}

/// The equations, if the left side is a derivative whose order is a name and the right side has
/// a value whenever it has one for a larger order.
fn of_order(left: &Expr, right: &Expr, lookup: Lookup<'_>) -> Option<Equations> {
    let (body, variable, order) = derivative(left, lookup)?;
    let Kind::Name(k) = &order.kind else { return None };
    if mentions(&body, k) || mentions(&variable, k) || binds(right, k) || !mentions(right, k) {
        return None;
    }
    if !has_values_below(right, k, lookup) {
        return None;
    }
    let next = Expr::sum(vec![
        Term { sign: Sign::Plus, expr: order.clone() },
        Term { sign: Sign::Plus, expr: Expr::int(1) },
    ])
    .grouped();
    let slope = Kind::Derivative {
        partial: false,
        variables: vec![(variable, None)],
        body: Some(Box::new(right.clone())),
    };
    Some(Equations {
        start: (body, put(right, k, &Expr::int(0))),
        step: (slope.into(), put(right, k, &next)),
        reason: "by induction on the order of the derivative",
    })
}

/// Body, variable and order of d^k/dt^k body or F^{(k)}(t).
fn derivative(expr: &Expr, lookup: Lookup<'_>) -> Option<(Expr, Expr, Expr)> {
    match &expr.kind {
        Kind::Group(body) => derivative(body, lookup),
        Kind::Derivative { variables, body: Some(body), .. } => match variables.as_slice() {
            [(variable, Some(order))] => Some(((**body).clone(), variable.clone(), order.clone())),
            _ => None,
        },
        Kind::Apply(callee, groups) => {
            let (Kind::Upper(name, order), [group]) = (&callee.kind, groups.as_slice()) else { return None };
            let ([order], [argument]) = (order.as_slice(), group.as_slice()) else { return None };
            let call = Expr::apply((**name).clone(), vec![argument.clone()]);
            let defined = matches!((&name.kind, &argument.kind), (Kind::Name(_), Kind::Name(_)))
                && lookup(expr).is_none()
                && lookup(&call).is_some();
            defined.then(|| (call, argument.clone(), order.clone()))
        }
        _ => None,
    }
}

/// Whether G has a value for all smaller k ≥ 0, if it has one for k.
fn has_values_below(right: &Expr, k: &str, lookup: Lookup<'_>) -> bool {
    let mut reader = Reader::new(lookup);
    reader.names.scan(right);
    let order = Symbol::new(k);
    let Some(terms) = reader.read(right) else { return false };
    let known = reader.known();
    terms.iter().all(|term| {
        let mut inside = known.clone();
        term.guards.iter().for_each(|guard| inside.assume(guard));
        let safe = term.defined.iter().all(|fact| {
            let plain = !fact.terms().keys().any(|symbol| term.bound.contains(symbol));
            (plain && term.guards.is_empty()) || inside.entails(fact)
        });
        safe && !term.coefficient.denominator().variables().contains(&order)
    })
}

fn mentions(expr: &Expr, name: &str) -> bool {
    let mut found = matches!(&expr.kind, Kind::Name(other) if other == name);
    expr.for_each_child(&mut |child| found |= mentions(child, name));
    found
}

/// Whether the name is a variable of a sum, an integral or the like somewhere.
fn binds(expr: &Expr, name: &str) -> bool {
    let mut found = match &expr.kind {
        Kind::Big { lower, .. } => lower.iter().any(|item| match &item.kind {
            Kind::Chain(first, links) => {
                mentions(first, name) || links.iter().rev().skip(1).any(|link| mentions(&link.expr, name))
            }
            _ => mentions(item, name),
        }),
        Kind::Lambda(..) | Kind::ForAll(..) | Kind::At { .. } => true,
        Kind::Integral { variable, .. } => mentions(variable, name),
        Kind::Derivative { variables, .. } => variables.iter().any(|(variable, _)| mentions(variable, name)),
        _ => false,
    };
    expr.for_each_child(&mut |child| found |= binds(child, name));
    found
}

/// The formula with another one put in for a name.
fn put(expr: &Expr, name: &str, value: &Expr) -> Expr {
    if matches!(&expr.kind, Kind::Name(other) if other == name) {
        return value.clone();
    }
    let mut result = expr.clone();
    result.for_each_child_mut(&mut |child| *child = put(child, name, value));
    result
}
