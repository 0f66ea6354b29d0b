//! Calls as Mathematica has them, `D[t^3, t]` and `Sum[k^2, {k, 1, 5}]`, as calls of the functions here.

use crate::formula::{BigOp, Expr, Kind, Rel, applied, named};
use crate::language::functions::function_meant;

/// The same formula, with calls in square brackets read as calls. A name that is `known` has its own meaning.
pub(super) fn with_calls(mut expr: Expr, known: &dyn Fn(&str) -> bool) -> Expr {
    rewrite(&mut expr, known);
    expr
}

fn rewrite(expr: &mut Expr, known: &dyn Fn(&str) -> bool) {
    expr.for_each_child_mut(&mut |child| rewrite(child, known));
    // Rational(1, 3)
    if let Kind::Apply(callee, groups) = &expr.kind
        && let (Kind::Name(name), [arguments]) = (&callee.kind, groups.as_slice())
        && let ("Rational", [above, below], false) = (name.as_str(), arguments.as_slice(), known(name))
    {
        let quotient = above.clone().grouped().over(below.clone().grouped());
        expr.kind = Kind::Group(Box::new(quotient));
        return;
    }
    // sum(k^2, (k, 1, 5))
    if let Kind::Apply(callee, groups) = &expr.kind
        && let (Kind::Name(name), [arguments]) = (&callee.kind, groups.as_slice())
        && let Some(op) = big_operator(name)
        && !known(name)
        && let Some(kind) = over_ranges(op, arguments)
    {
        expr.kind = kind;
        return;
    }
    let Kind::Subscript(base, inside) = &expr.kind else { return };
    let (Kind::Name(name), [Expr { kind: Kind::List(arguments), .. }]) = (&base.kind, inside.as_slice())
    else {
        return;
    };
    if known(name) {
        return;
    }
    if let Some(op) = big_operator(name) {
        if let Some(kind) = over_ranges(op, arguments) {
            expr.kind = kind;
        }
        return;
    }
    if name == "Table" {
        if let Some(kind) = listed(arguments) {
            expr.kind = kind;
        }
        return;
    }
    let function = match name.as_str() {
        "D" => Some("diff"),
        other => function_meant(other).filter(|_| other.len() > 2),
    };
    let Some(function) = function else { return };
    // {t, 0, 1} after the first argument, {{0, 1}, {1, 3}} as the first one
    let mut own = Vec::new();
    for (place, argument) in arguments.iter().enumerate() {
        match &argument.kind {
            Kind::Set(items, None)
                if place > 0 && matches!(items.first(), Some(Expr { kind: Kind::Name(_), .. })) =>
            {
                own.extend(items.iter().cloned());
            }
            _ => own.push(as_list(argument.clone())),
        }
    }
    let callee = |function: &str| Expr { span: base.span, ..Expr::name(function) };
    match (function, own.as_slice()) {
        // Blossom[t^2, {0, 1}]
        ("polar", [formula, Expr { kind: Kind::List(at), .. }]) => {
            let form = applied(callee("polar"), vec![formula.clone()], base.span);
            expr.kind = applied(form, at.clone(), expr.span).kind;
            return;
        }
        // SymmetricPolynomial[2, {x, y, z}]
        ("esym", [number, Expr { kind: Kind::List(of), .. }]) => {
            let arguments = std::iter::once(number).chain(of).cloned().collect();
            expr.kind = applied(callee("esym"), arguments, expr.span).kind;
            return;
        }
        // BSplineBasis[{2, {0, 1, 2, 3}}, 0, x]
        ("bspline_basis", [Expr { kind: Kind::List(degree_and_knots), .. }, number, rest @ ..]) => {
            let mut arguments = degree_and_knots.clone();
            arguments.push(number.clone());
            let function = applied(callee("bspline_basis"), arguments, expr.span);
            expr.kind = match rest {
                // The whole function, in t.
                [] | [Expr { kind: Kind::Name(_), .. }] => function.kind,
                values => applied(function, values.to_vec(), expr.span).kind,
            };
            return;
        }
        _ => {}
    }
    // The letter of what is interpolated goes by its name.
    if function == "lagrange"
        && let [_, letter] = own.as_mut_slice()
        && matches!(letter.kind, Kind::Name(_))
    {
        *letter = named("variable", letter.clone());
    }
    expr.kind = applied(callee(function), own, expr.span).kind;
}

/// Table[f, {i, a, b}], a list.
fn listed(arguments: &[Expr]) -> Option<Kind> {
    let [body, range] = arguments else { return None };
    let Kind::Set(items, None) = &range.kind else { return None };
    let one = Expr { span: range.span, ..Expr::int(1) };
    let (name, from, to) = match items.as_slice() {
        [name, to] => (name, &one, to),
        [name, from, to] => (name, from, to),
        _ => return None,
    };
    if !matches!(name.kind, Kind::Name(_)) {
        return None;
    }
    let function = Kind::Lambda(vec![name.clone()], Box::new(body.clone()));
    let values = Kind::Range(Box::new(from.clone()), Box::new(to.clone()));
    let arguments = vec![Expr::new(function, body.span), Expr::new(values, range.span)];
    Some(applied(Expr { span: body.span, ..Expr::name("map") }, arguments, range.span).kind)
}

fn big_operator(name: &str) -> Option<BigOp> {
    match name {
        "Sum" | "sum" | "summation" => Some(BigOp::Sum),
        "Product" | "product" | "prod" => Some(BigOp::Product),
        _ => None,
    }
}

/// Sum[f, {i, a, b}, {j, c, d}]: the last range is the inner one.
fn over_ranges(op: BigOp, arguments: &[Expr]) -> Option<Kind> {
    let (body, ranges) = arguments.split_first()?;
    let mut whole = body.clone();
    for range in ranges.iter().rev() {
        let (Kind::Set(items, None) | Kind::Tuple(items)) = &range.kind else { return None };
        // (k, 1, 5); a pair is a point
        if matches!(range.kind, Kind::Tuple(_)) && items.len() != 3
            || !matches!(items.first(), Some(Expr { kind: Kind::Name(_), .. }))
        {
            return None;
        }
        let one = Expr { span: range.span, ..Expr::int(1) };
        let (name, from, to) = match items.as_slice() {
            [name, to] => (name, &one, to),
            [name, from, to] => (name, from, to),
            _ => return None,
        };
        let lower =
            Expr { span: name.span.to(to.span), ..Expr::relation(name.clone(), Rel::Eq, from.clone()) };
        let span = whole.span.to(range.span);
        let body = Expr { span: whole.span, ..whole.grouped() };
        let kind =
            Kind::Big { op, lower: vec![lower], upper: Some(Box::new(to.clone())), body: Box::new(body) };
        whole = Expr::new(kind, span);
    }
    (!ranges.is_empty()).then_some(whole.kind)
}

/// Sets as lists: {{0, 1}, {1, 3}}.
pub(super) fn as_list(mut expr: Expr) -> Expr {
    if let Kind::Set(items, None) = &expr.kind {
        expr.kind = Kind::List(items.iter().cloned().map(as_list).collect());
    }
    expr
}
