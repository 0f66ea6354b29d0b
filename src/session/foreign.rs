//! Calls as other systems have them, `D[t^3, t]`, `add(k^2, k = 1..5)` and `linspace(0, 1, 5)`, as calls of the functions here,
//! and spellings that have another meaning elsewhere.

mod points;
mod ranges;
pub(super) mod scripts;
pub(super) mod spelling;
mod spellings;
mod templates;

use self::ranges::{big_operator, list_maker, listed, over_ranges};
use self::spellings::{called_elsewhere, derivatives};
use self::templates::is_called_elsewhere;
use crate::formula::{Expr, Kind, Link, Rel, applied, call, named};
use crate::language::functions::{Need, Takes, builtin, function_called, function_meant};
use crate::language::lexicon::roles;

pub(super) use points::with_scalar_products;

/// The same formula, with calls in square brackets read as calls. A name that is `known` has its own meaning.
pub(super) fn with_calls(mut expr: Expr, known: &dyn Fn(&str) -> bool) -> Expr {
    rewrite(&mut expr, known);
    expr
}

/// Whether a new function is given its formula here, range(n) := n^2, so that its name has its own meaning.
fn defines_function(expr: &Expr) -> bool {
    let Kind::Chain(left, links) = &expr.kind else { return false };
    let letter = |expr: &Expr| matches!(expr.kind, Kind::Name(_));
    let head = match &left.kind {
        Kind::Apply(callee, groups) => match &callee.kind {
            Kind::Name(name) => function_meant(name).is_none() && groups.iter().flatten().all(letter),
            _ => false,
        },
        _ => false,
    };
    head && links.first().is_some_and(|link| matches!(link.rel, Rel::Eq | Rel::Define))
}

fn rewrite(expr: &mut Expr, known: &dyn Fn(&str) -> bool) {
    if defines_function(expr) {
        if let Kind::Chain(_, links) = &mut expr.kind {
            links.iter_mut().for_each(|link| rewrite(&mut link.expr, known));
        }
        return;
    }
    // BezierFunction[{{0, 0}, {1, 2}}][1/2]
    if let Kind::Subscript(base, inside) = &expr.kind
        && let (Kind::Subscript(function, _), [Expr { kind: Kind::List(arguments), .. }]) =
            (&base.kind, inside.as_slice())
        && let Kind::Name(name) = &function.kind
        && name.len() > 2
        && !known(name)
        && (function_meant(name).is_some() || is_called_elsewhere(name))
    {
        expr.kind = Kind::Apply(base.clone(), vec![arguments.clone()]);
    }
    expr.for_each_child_mut(&mut |child| rewrite(child, known));
    // bezier({0, 1, 3}, 0, 1)
    if let Kind::Apply(callee, groups) = &mut expr.kind
        && let (Kind::Name(name), [arguments]) = (&callee.kind, groups.as_mut_slice())
        && !known(name)
        && let Some(own) = function_called(name).and_then(builtin)
    {
        for (argument, parameter) in arguments.iter_mut().zip(own.parameters) {
            let lists = matches!(parameter.kind, Takes::Points | Takes::Scalars | Takes::Net | Takes::Rows);
            if lists && matches!(argument.kind, Kind::Set(_, None)) {
                *argument = as_list(argument.clone());
            }
        }
    }
    // D(f)(2/3)
    if let Kind::Apply(callee, groups) = &expr.kind
        && let (Kind::Name(d), Some([Expr { kind: Kind::Name(f), .. }])) =
            (&callee.kind, groups.first().map(Vec::as_slice))
        && d == "D"
        && known(f)
        && !known(d)
    {
        let derivative = call("derivative", groups[0].clone(), callee.span);
        expr.kind = match groups.split_first() {
            Some((_, [])) | None => derivative.kind,
            Some((_, rest)) => Kind::Apply(Box::new(derivative), rest.to_vec()),
        };
        return;
    }
    if let Some(kind) = with_range(expr, known) {
        expr.kind = kind;
        return;
    }
    if let Some(kind) = called_elsewhere(expr, known) {
        expr.kind = kind;
        return;
    }
    // sum(k^2, (k, 1, 5)), seq(k^2, k = 1..5)
    if let Kind::Apply(callee, groups) = &expr.kind
        && let (Kind::Name(name), [arguments]) = (&callee.kind, groups.as_slice())
        && !known(name)
    {
        let kind = match big_operator(name) {
            Some(op) => over_ranges(op, arguments),
            None if list_maker(name) => listed(arguments),
            None => None,
        };
        if let Some(kind) = kind {
            expr.kind = kind;
            return;
        }
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
    if list_maker(name) {
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
    if function == "diff"
        && let Some(kind) = derivatives(&own, expr.span, known)
    {
        expr.kind = kind;
        return;
    }
    expr.kind = applied(callee(function), own, expr.span).kind;
}

/// A call whose range or parameter goes by the name of a letter: integrate(F, t=0..1), subdivide(c, t=1/2).
fn with_range(expr: &Expr, known: &dyn Fn(&str) -> bool) -> Option<Kind> {
    let Kind::Apply(callee, groups) = &expr.kind else { return None };
    let (Kind::Name(name), [arguments]) = (&callee.kind, groups.as_slice()) else { return None };
    let own = function_meant(name).filter(|_| !known(name)).and_then(builtin)?;
    let [first, rest @ ..] = arguments.as_slice() else { return None };
    let has = |name: &str| own.parameters.iter().any(|parameter| parameter.name == name);
    let [argument] = rest else { return None };
    let Kind::Chain(letter, links) = &argument.kind else { return None };
    let (Kind::Name(letter), [Link { rel: Rel::Eq, expr: value, .. }]) = (&letter.kind, links.as_slice())
    else {
        return None;
    };
    // Of surfaces the parameters have names.
    let elsewhere =
        own.other_forms().any(|(_, others)| others.parameters.iter().any(|other| other.name == letter));
    if has(letter) || elsewhere || !roles::is_variable(letter) {
        return None;
    }
    let written = |arguments: Vec<Expr>| {
        Some(Kind::Apply(callee.clone(), vec![std::iter::once(first.clone()).chain(arguments).collect()]))
    };
    match &value.kind {
        Kind::Range(a, b) if has("a") && has("b") => {
            let name = Expr { span: argument.span, ..Expr::name(letter) };
            let variable = has("variable").then(|| named("variable", name));
            let ends = [named("a", (**a).clone()), named("b", (**b).clone())];
            written(variable.into_iter().chain(ends).collect())
        }
        Kind::Range(..) => None,
        _ => {
            let second = own.parameters.get(1)?;
            let parameter = matches!(second.need, Need::Many(..)) || second.need == Need::Required;
            let number = matches!(second.kind, Takes::Scalar | Takes::Number | Takes::ScalarOrList);
            (parameter && number).then(|| written(vec![value.clone()]))?
        }
    }
}

/// Sets as lists: {{0, 1}, {1, 3}}.
pub(super) fn as_list(mut expr: Expr) -> Expr {
    if let Kind::Set(items, None) = &expr.kind {
        expr.kind = Kind::List(items.iter().cloned().map(as_list).collect());
    }
    expr
}
