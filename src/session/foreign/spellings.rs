//! Functions that have another form elsewhere: `Matrix([[1, 2], [3, 4]])`, `diff(F, x, y)`, `linspace(0, 1, 5)`.

use crate::formula::source::Span;
use crate::formula::{BigOp, Delimiter, Expr, Kind, Link, Rel, Sign, Term, applied};

use super::as_list;
use super::templates::{INDEX, TEMPLATES};

/// Calls as SymPy, Maple, MATLAB and Maxima have them, of functions with another form here.
pub(super) fn called_elsewhere(expr: &Expr, known: &dyn Fn(&str) -> bool) -> Option<Kind> {
    let (callee, arguments) = match &expr.kind {
        Kind::Apply(callee, groups) => match groups.as_slice() {
            [arguments] => (callee, arguments.as_slice()),
            // basis_element([0, 1, 2])(1)
            [first, rest @ ..] => {
                let called = Expr::new(Kind::Apply(callee.clone(), vec![first.clone()]), expr.span);
                let kind = called_elsewhere(&called, known)?;
                return Some(Kind::Apply(Box::new(Expr::new(kind, expr.span)), rest.to_vec()));
            }
            [] => return None,
        },
        Kind::Subscript(callee, inside) => match inside.as_slice() {
            [Expr { kind: Kind::List(arguments), .. }] => (callee, arguments.as_slice()),
            _ => return None,
        },
        _ => return None,
    };
    // Res_x(F, G)
    if let (Kind::Subscript(name, indices), [first, second]) = (&callee.kind, arguments)
        && let [letter] = indices.as_slice()
        && matches!(&name.kind, Kind::Name(name) if matches!(name.as_str(), "Res" | "res" | "Resultant") && !known(name))
        && matches!(letter.kind, Kind::Name(_))
    {
        let function = Expr { span: callee.span, ..Expr::name("resultant") };
        return Some(applied(function, vec![first.clone(), second.clone(), letter.clone()], expr.span).kind);
    }
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
    if let Some(meant) = TEMPLATES.iter().find_map(|template| template.filled(name, arguments, expr.span)) {
        return Some(meant);
    }
    match (name.as_str(), arguments) {
        // diff(F, x, y), F.derivative(t)
        ("diff" | "derivative", [_, rest @ ..]) if rest.iter().any(|name| is_unknown(name, known)) => {
            derivatives(arguments, expr.span, known)
        }
        // np.array([1, 2]), Vector([1, 2]), list(range(5))
        (
            "array" | "Array" | "Vector" | "vector" | "list" | "List" | "tuple" | "print" | "disp"
            | "display" | "Point",
            [item],
        ) if !bracketed => Some(Kind::Group(Box::new(item.clone()))),
        ("Point" | "vector" | "Vector", coordinates) if coordinates.len() > 1 => {
            Some(Kind::Tuple(coordinates.to_vec()))
        }
        // range(5), arange(1, 5): the end is none of them
        ("range" | "arange", [to]) if !bracketed => Some(numbers_below(&Expr::int(0), to, expr.span)),
        ("range" | "arange", [from, to]) if !bracketed => Some(numbers_below(from, to, expr.span)),
        ("ones", [rows, columns]) => filled(rows, columns, 1),
        ("zeros", [rows, columns]) => filled(rows, columns, 0),
        // Coefficients from the highest power down: polyval([1, -3, 2], 3), roots([1, -3, 2])
        ("polyval", [Expr { kind: Kind::List(list), .. }, at])
            if list.iter().all(plain) && !list.is_empty() =>
        {
            Some(Kind::Group(Box::new(in_powers(list, at))))
        }
        ("polyder", [Expr { kind: Kind::List(list), .. }]) if list.len() > 1 && list.iter().all(plain) => {
            Some(Kind::List(derivative_of(list)))
        }
        ("conv", [Expr { kind: Kind::List(f), .. }, Expr { kind: Kind::List(g), .. }])
            if [f, g].iter().all(|list| !list.is_empty() && list.iter().all(plain)) =>
        {
            Some(Kind::List(product_of(f, g)))
        }
        // scipy: BSpline.basis_element([0, 1, 2, 3]), all knots of one B-spline
        ("basis_element", [knots @ Expr { kind: Kind::List(list), .. }]) if list.len() > 1 => {
            let degree = i64::try_from(list.len() - 2).ok()?;
            Some(call("bspline_basis", vec![Expr::int(degree), knots.clone(), Expr::int(0)]))
        }
        // bspline_basis(2, (0, 1, 2, 3), 0, x)
        ("bspline_basis", [degree, knots, number, at])
            if !matches!(at.kind, Kind::Chain(..)) && knots.items().is_some() =>
        {
            let function =
                call("bspline_basis", vec![degree.clone(), as_list(knots.clone()), number.clone()]);
            match at.kind {
                Kind::Name(_) => Some(function),
                _ => Some(applied(Expr::new(function, expr.span), vec![at.clone()], expr.span).kind),
            }
        }
        // interpolate([(0, 1), (1, 3)], x), InterpolatingPolynomial({1, 4, 9}, x) with the nodes 1, 2, 3
        ("interpolate" | "interpolating_poly" | "InterpolatingPolynomial", [data, letter])
            if is_name(letter) =>
        {
            interpolated(items_in(data)?, letter).map(|arguments| call("lagrange", arguments))
        }
        // maximize(F, x = 0..1), MaxValue({F, 0 <= x <= 1}, x)
        ("maximize" | "Maximize" | "MaxValue" | "minimize" | "Minimize" | "MinValue", arguments) => {
            let op = if name.to_lowercase().starts_with("max") { BigOp::Max } else { BigOp::Min };
            extreme(op, arguments)
        }
        ("roots", [Expr { kind: Kind::List(list), .. }]) if list.len() > 1 && list.iter().all(plain) => {
            Some(call("roots", vec![in_powers(list, &Expr { span: expr.span, ..Expr::name("t") })]))
        }
        // Matrix([1, 2]), a column
        ("Matrix" | "matrix", [Expr { kind: Kind::List(items), .. }])
            if !items.is_empty() && items.iter().all(plain) =>
        {
            Some(Kind::Matrix(
                items.iter().map(|item| vec![Some(item.clone())]).collect(),
                Delimiter::Bracket,
            ))
        }
        // Matrix([[1, 2], [3, 4]]), matrix([1, 2], [3, 4])
        ("Matrix" | "matrix", [Expr { kind: Kind::List(rows), .. }])
            if rows.iter().all(|row| matches!(row.kind, Kind::List(_))) =>
        {
            matrix_of(rows)
        }
        ("matrix", rows) if rows.len() > 1 && rows.iter().all(|row| matches!(row.kind, Kind::List(_))) => {
            matrix_of(rows)
        }
        // matrix(QQ, [[1, 2], [3, 4]])
        ("Matrix" | "matrix" | "vector", [Expr { kind: Kind::Name(ring), .. }, rest @ ..])
            if matches!(ring.as_str(), "QQ" | "ZZ" | "RR") && !known(ring) && !rest.is_empty() =>
        {
            called_elsewhere(&Expr::new(call(name, rest.to_vec()), expr.span), known)
        }
        // Polynomial({(0, 0), (1, 1), (2, 8)}) through points
        ("Polynomial", points) if !bracketed && !points.is_empty() => {
            let letter = Expr { span: callee.span, ..Expr::name("x") };
            let point = |expr: &Expr| matches!(&expr.kind, Kind::Tuple(items) if items.len() == 2);
            let points = match points {
                [list] if !point(list) => items_in(list)?,
                points => points,
            };
            let points = points.iter().all(point).then_some(points)?;
            interpolated(points, &letter).map(|arguments| call("lagrange", arguments))
        }
        // Intersect(y = x^2, x + y = 2), Intersect(x^2, 2 - x)
        ("Intersect" | "intersect", [first, second]) if !bracketed => {
            let equation =
                |expr: &Expr| matches!(&expr.kind, Kind::Chain(_, links) if links[0].rel == Rel::Eq);
            let list = |items: Vec<Expr>| Expr::new(Kind::List(items), expr.span);
            match (equation(first), equation(second)) {
                (true, true) => Some(call("solve", vec![list(vec![first.clone(), second.clone()])])),
                (false, false) if plain(first) && plain(second) && !is_name(first) && !is_name(second) => {
                    let meet =
                        Expr { span: expr.span, ..Expr::relation(first.clone(), Rel::Eq, second.clone()) };
                    Some(call("solve", vec![meet]))
                }
                _ => None,
            }
        }
        // bspline_basis(2, [0, 1, 2, 3], 0).subs(x, 1/2): the value of a curve at its parameter
        ("subs", [curve @ Expr { kind: Kind::Apply(function, _), .. }, letter, value])
            if is_name(letter)
                && matches!(&function.kind, Kind::Name(name) if matches!(name.as_str(), "bspline_basis" | "bezier" | "bspline")) =>
        {
            Some(applied(curve.clone(), vec![value.clone()], expr.span).kind)
        }
        // D(t -> t^2)
        ("D", [function]) if !bracketed && matches!(function.kind, Kind::Lambda(..)) => {
            Some(call("derivative", vec![function.clone()]))
        }
        ("Rational", [above, below]) => {
            Some(Kind::Group(Box::new(above.clone().grouped().over(below.clone().grouped()))))
        }
        // {{1, 2}, {3, 4}}.{x, y}
        ("dot" | "termwise", items) if items.iter().any(|item| matches!(item.kind, Kind::Set(..))) => {
            Some(call(name, items.iter().cloned().map(as_list).collect()))
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
            // NSolve[x^2 == 2, x]
            if let (Kind::Chain(..), true) = (&equations.kind, name.as_str() != "solve") {
                return Some(call("solve", arguments.iter().cloned().map(as_list).collect()));
            }
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
        ("doit", [formula]) => Some(Kind::Group(Box::new(formula.clone()))),
        _ => None,
    }
}

/// Whether an expression is a name without a value.
fn is_unknown(expr: &Expr, known: &dyn Fn(&str) -> bool) -> bool {
    matches!(&expr.kind, Kind::Name(name) if !known(name))
}

/// The derivative by several names, each perhaps with its order behind it: diff(F, x, y), D[F, {x, 2}, y].
pub(super) fn derivatives(arguments: &[Expr], span: Span, known: &dyn Fn(&str) -> bool) -> Option<Kind> {
    let (formula, rest) = arguments.split_first()?;
    let mut whole = formula.clone();
    let mut rest = rest.iter().peekable();
    let mut count = 0;
    while let Some(name) = rest.next() {
        if !is_unknown(name, known) {
            return None;
        }
        let mut own = vec![whole, name.clone()];
        own.extend(rest.next_if(|next| !is_unknown(next, known)).cloned());
        whole = applied(Expr { span, ..Expr::name("diff") }, own, span);
        count += 1;
    }
    (count > 0).then_some(whole.kind)
}

/// The list of the integers from a number on that are below another one.
fn numbers_below(from: &Expr, to: &Expr, span: Span) -> Kind {
    let one = Expr { span, ..Expr::int(1) };
    let last = match to.as_int() {
        Some(end) => Expr { span, ..Expr::int(end - 1) },
        None => {
            let terms = [(Sign::Plus, to.clone().grouped()), (Sign::Minus, one)];
            Expr { span, ..Expr::sum(terms.into_iter().map(|(sign, expr)| Term { sign, expr }).collect()) }
        }
    };
    let first = Expr { span, ..from.clone() };
    super::ranges::list_of(&Expr::name(INDEX), &Expr::name(INDEX), &first, &last)
}

/// A matrix with the same number everywhere.
fn filled(rows: &Expr, columns: &Expr, number: i64) -> Option<Kind> {
    const LARGEST: i64 = 100;
    let size = |expr: &Expr| expr.as_int().filter(|size| (1..=LARGEST).contains(size));
    let (rows, columns) = (size(rows)?, size(columns)?);
    let row = || (0..columns).map(|_| Some(Expr::int(number))).collect();
    Some(Kind::Matrix((0..rows).map(|_| row()).collect(), Delimiter::Bracket))
}

/// The polynomial with the given coefficients, from the highest power down.
fn in_powers(coefficients: &[Expr], at: &Expr) -> Expr {
    let last = coefficients.len() - 1;
    let term = |(k, coefficient): (usize, &Expr)| {
        let power = i64::try_from(last - k).unwrap_or(i64::MAX);
        let mut factors = vec![coefficient.clone().grouped()];
        if power > 0 {
            factors.push(at.clone().grouped().power(Expr::int(power)));
        }
        Term { sign: Sign::Plus, expr: Expr::product(factors) }
    };
    Expr::sum(coefficients.iter().enumerate().map(term).collect())
}

/// The coefficients of the derivative, from the highest power down.
fn derivative_of(coefficients: &[Expr]) -> Vec<Expr> {
    let powers = (1..coefficients.len()).rev().map(|power| i64::try_from(power).unwrap_or(i64::MAX));
    let scaled = |(power, c): (i64, &Expr)| Expr::product(vec![Expr::int(power), c.clone().grouped()]);
    powers.zip(coefficients).map(scaled).collect()
}

/// The coefficients of the product of two polynomials with these coefficients.
fn product_of(f: &[Expr], g: &[Expr]) -> Vec<Expr> {
    let entry = |k: usize| {
        let terms = f.iter().enumerate().filter_map(|(i, a)| {
            let b = g.get(k.checked_sub(i)?)?;
            let expr = Expr::product(vec![a.clone().grouped(), b.clone().grouped()]);
            Some(Term { sign: Sign::Plus, expr })
        });
        Expr::sum(terms.collect())
    };
    (0..f.len() + g.len() - 1).map(entry).collect()
}

/// Nodes, values and the variable, of points or of values at 1, 2, 3, ...
fn interpolated(data: &[Expr], letter: &Expr) -> Option<Vec<Expr>> {
    let (nodes, values): (Vec<Expr>, Vec<Expr>) = match data.iter().all(|item| items_in(item).is_some()) {
        true => {
            let pair = |item: &Expr| match items_in(item)? {
                [node, value] => Some((node.clone(), value.clone())),
                _ => None,
            };
            data.iter().map(pair).collect::<Option<Vec<_>>>()?.into_iter().unzip()
        }
        false => (1..).map(Expr::int).zip(data.iter().cloned()).unzip(),
    };
    let list = |items: Vec<Expr>| Expr { span: letter.span, ..Expr::new(Kind::List(items), letter.span) };
    let variable = crate::formula::named("variable", letter.clone());
    (!nodes.is_empty()).then(|| vec![list(nodes), list(values), variable])
}

/// The extreme value of a formula for a name in a range or under a condition.
fn extreme(op: BigOp, arguments: &[Expr]) -> Option<Kind> {
    let (body, condition) = match arguments {
        [Expr { kind: Kind::Set(items, None) | Kind::List(items), .. }, _] => match items.as_slice() {
            [body, condition] => (body, condition),
            _ => return None,
        },
        [body, condition, ..] => (body, condition),
        _ => return None,
    };
    let Kind::Chain(left, links) = &condition.kind else { return None };
    let condition = match links.as_slice() {
        [Link { rel: Rel::Eq, expr: Expr { kind: Kind::Range(from, to), .. }, .. }] => {
            let interval = Expr::new(Kind::List(vec![(**from).clone(), (**to).clone()]), condition.span);
            Expr { span: condition.span, ..Expr::relation((**left).clone(), Rel::In, interval) }
        }
        [_, _] => condition.clone(),
        _ => return None,
    };
    Some(Kind::Big { op, lower: vec![condition], upper: None, body: Box::new(body.clone().grouped()) })
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
