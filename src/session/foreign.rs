//! Calls as Mathematica has them, `D[t^3, t]` and `Sum[k^2, {k, 1, 5}]`, as calls of the functions here.

use crate::formula::{BigOp, Delimiter, Expr, Kind, Link, Rel, applied, named};
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
    if let Some(kind) = called_elsewhere(expr, known) {
        expr.kind = kind;
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

/// Calls as SymPy, Maple and Maxima have them, of functions with another form here.
fn called_elsewhere(expr: &Expr, known: &dyn Fn(&str) -> bool) -> Option<Kind> {
    let (callee, arguments) = match &expr.kind {
        Kind::Apply(callee, groups) => match groups.as_slice() {
            [arguments] => (callee, arguments.as_slice()),
            _ => return None,
        },
        Kind::Subscript(callee, inside) => match inside.as_slice() {
            [Expr { kind: Kind::List(arguments), .. }] => (callee, arguments.as_slice()),
            _ => return None,
        },
        _ => return None,
    };
    let Kind::Name(name) = &callee.kind else { return None };
    let bracketed = matches!(expr.kind, Kind::Subscript(..));
    if known(name) || bracketed && name.chars().count() < 2 {
        return None;
    }
    let function = |name: &str| Expr { span: callee.span, ..Expr::name(name) };
    let call = |name: &str, arguments: Vec<Expr>| applied(function(name), arguments, expr.span).kind;
    let is_name = |expr: &Expr| matches!(expr.kind, Kind::Name(_) | Kind::Subscript(..));
    let plain =
        |expr: &Expr| !matches!(expr.kind, Kind::Chain(..) | Kind::List(_) | Kind::Tuple(_) | Kind::Set(..));
    match (name.as_str(), arguments) {
        // Matrix([[1, 2], [3, 4]]), matrix([1, 2], [3, 4])
        ("Matrix" | "matrix", [Expr { kind: Kind::List(rows), .. }])
            if rows.iter().all(|row| matches!(row.kind, Kind::List(_))) =>
        {
            matrix_of(rows)
        }
        ("matrix", rows) if rows.len() > 1 && rows.iter().all(|row| matches!(row.kind, Kind::List(_))) => {
            matrix_of(rows)
        }
        ("Eq" | "Equal", [left, right]) => Some(Expr::relation(left.clone(), Rel::Eq, right.clone()).kind),
        ("Poly" | "Expr", [formula]) => Some(Kind::Group(Box::new(formula.clone()))),
        ("Poly", [formula, name]) if is_name(name) => Some(Kind::Group(Box::new(formula.clone()))),
        // limit(F, t, a), Limit[F, t -> a]
        ("limit" | "Limit", [formula, name, goal]) if is_name(name) => Some(limit(formula, name, goal)),
        ("limit" | "Limit", [formula, Expr { kind: Kind::Lambda(names, goal), .. }]) => {
            match names.as_slice() {
                [name] => Some(limit(formula, name, goal)),
                _ => None,
            }
        }
        // unapply(F, t), Lambda(t, F), Function[{t}, F]
        ("unapply", [formula, names @ ..]) | ("Lambda", [names @ .., formula])
            if !names.is_empty() && names.iter().all(is_name) =>
        {
            let lambda = Kind::Lambda(names.to_vec(), Box::new(formula.clone()));
            Some(Kind::Group(Box::new(Expr::new(lambda, expr.span))))
        }
        ("Function", [Expr { kind: Kind::Set(names, None), .. }, formula]) if names.iter().all(is_name) => {
            let lambda = Kind::Lambda(names.clone(), Box::new(formula.clone()));
            Some(Kind::Group(Box::new(Expr::new(lambda, expr.span))))
        }
        // eval(F, t = 2), subs({t = 2, a = 3}, F), F.subs({x: 2}), F.subs([(x, 2)])
        ("eval", [formula, values @ ..])
            if !values.is_empty() && values.iter().all(|v| matches!(v.kind, Kind::Chain(..))) =>
        {
            plain(formula).then(|| call("subs", arguments.to_vec()))
        }
        (
            "subs",
            [Expr { kind: Kind::Set(values, None), .. }, formula]
            | [formula, Expr { kind: Kind::Set(values, None), .. }],
        ) if values.iter().all(|value| matches!(value.kind, Kind::Chain(..))) => {
            Some(call("subs", std::iter::once(formula).chain(values).cloned().collect()))
        }
        ("subs", [formula, Expr { kind: Kind::List(pairs), .. }]) => {
            let pair = |pair: &Expr| match pair.items()? {
                [name, value] if is_name(name) => {
                    Some(Expr { span: pair.span, ..Expr::relation(name.clone(), Rel::Eq, value.clone()) })
                }
                _ => None,
            };
            let values: Vec<Expr> = pairs.iter().map(pair).collect::<Option<_>>()?;
            Some(call("subs", std::iter::once(formula.clone()).chain(values).collect()))
        }
        // integrate(F, (t, 0, 2))
        ("integrate" | "Integral" | "integral", [formula, Expr { kind: Kind::Tuple(range), .. }]) => {
            match range.as_slice() {
                [name, _, _] if is_name(name) => {
                    Some(call("integrate", std::iter::once(formula).chain(range).cloned().collect()))
                }
                _ => None,
            }
        }
        // solve([x + y - 3, x - y - 1], [x, y]), solve({x + y = 3}, {x, y})
        ("solve" | "Solve" | "NSolve" | "nsolve" | "linsolve", [equations, rest @ ..]) => {
            let written = items_in(equations)?;
            let claims = written.iter().all(|item| matches!(item.kind, Kind::Chain(..)));
            let unknowns = matches!(rest, [names] if is_name(names) || items_in(names).is_some_and(|names| names.iter().all(is_name)));
            if !(claims && !matches!(equations.kind, Kind::List(_)) || unknowns && written.iter().all(plain))
            {
                return None;
            }
            let equation = |item: &Expr| match &item.kind {
                Kind::Chain(..) => item.clone(),
                _ => Expr { span: item.span, ..Expr::relation(item.clone(), Rel::Eq, Expr::int(0)) },
            };
            let list = Expr::new(Kind::List(written.iter().map(equation).collect()), equations.span);
            Some(call("solve", std::iter::once(list).chain(rest.iter().cloned().map(as_list)).collect()))
        }
        // makelist(F, i, 0, 3), seq(F, i = 0..3)
        ("makelist", [body, name, from, to]) if is_name(name) => Some(list_of(body, name, from, to)),
        ("seq", [body, Expr { kind: Kind::Chain(name, links), .. }]) if is_name(name) => {
            match links.as_slice() {
                [Link { rel: Rel::Eq, expr: Expr { kind: Kind::Range(from, to), .. }, .. }] => {
                    Some(list_of(body, name, from, to))
                }
                _ => None,
            }
        }
        ("doit", [formula]) => Some(Kind::Group(Box::new(formula.clone()))),
        _ => None,
    }
}

/// The items of a list, a tuple or a set.
fn items_in(expr: &Expr) -> Option<&[Expr]> {
    match &expr.kind {
        Kind::List(items) | Kind::Tuple(items) | Kind::Set(items, None) => Some(items),
        _ => None,
    }
}

fn matrix_of(rows: &[Expr]) -> Option<Kind> {
    let row = |row: &Expr| Some(row.items()?.iter().cloned().map(Some).collect());
    Some(Kind::Matrix(rows.iter().map(row).collect::<Option<_>>()?, Delimiter::Bracket))
}

fn limit(formula: &Expr, name: &Expr, goal: &Expr) -> Kind {
    let lower = vec![Expr { span: name.span, ..Expr::relation(name.clone(), Rel::To, goal.clone()) }];
    Kind::Big { op: BigOp::Limit, lower, upper: None, body: Box::new(formula.clone().grouped()) }
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
    Some(list_of(body, name, from, to))
}

/// The values of a formula for a range of its index.
fn list_of(body: &Expr, name: &Expr, from: &Expr, to: &Expr) -> Kind {
    let span = from.span.to(to.span);
    let function = Kind::Lambda(vec![name.clone()], Box::new(body.clone()));
    let values = Kind::Range(Box::new(from.clone()), Box::new(to.clone()));
    let arguments = vec![Expr::new(function, body.span), Expr::new(values, span)];
    applied(Expr { span: body.span, ..Expr::name("map") }, arguments, span).kind
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
