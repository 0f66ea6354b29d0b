//! What is named beside its own notation: the divided difference f[a, b], the blossom p(a, b, c); names and values said in
//! another way than a function takes them.

use std::collections::BTreeSet;

use super::Read;
use super::draft::{Draft, list};
use super::lists;
use super::utterance::Utterance;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Rel, applied, call, named};
use crate::judge::written::names::bases;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Env;
use crate::language::functions::builtin;
use crate::language::lexicon::phrases::Label;
use crate::language::value::Value;
use crate::math::poly::Symbol;

/// The formula that a function names with its own notation, and how many of the labels it has used, the first ones; `None`
/// if it is asked for of something else.
pub(super) fn meant(
    draft: &Draft,
    items: &[Expr],
    said: &[Read],
    env: &Env,
    topic: Option<&Expr>,
) -> Option<(Expr, usize)> {
    // the divided differences of 1, 4, 9 at 1, 2, 3
    let several = items.len() > 1 && items.iter().all(is_number);
    if several && matches!(draft.builtin.name, "divided_differences" | "newton" | "lagrange") {
        return meant(draft, &[list(items.to_vec())], said, env, topic);
    }
    let [item] = items else { return None };
    match (draft.builtin.name, &item.kind) {
        // the divided difference [0, 1, 2] t^3
        ("divided_differences", Kind::Mul(factors)) if said.is_empty() => {
            let [Expr { kind: Kind::List(nodes), .. }, function @ ..] = factors.as_slice() else {
                return None;
            };
            let [letter] = bases(item).into_iter().collect::<Vec<_>>().try_into().ok()?;
            let letter: String = letter;
            let function = Expr::product(function.to_vec());
            let function = Expr::new(Kind::Lambda(vec![Expr::name(letter)], Box::new(function)), item.span);
            let nodes = vec![list(nodes.clone())];
            Some((Expr::new(Kind::Subscript(Box::new(function.grouped()), nodes), item.span), 0))
        }
        // the Bernstein polynomial B_2^4
        ("bernstein", Kind::Pow(base, exponent))
            if matches!(base.kind, Kind::Subscript(..)) && exponent.as_int().is_some() =>
        {
            Some((item.clone(), 0))
        }
        // the divided difference f[a, b]
        ("divided_differences", Kind::Subscript(_, nodes))
            if said.is_empty() && matches!(nodes.as_slice(), [Expr { kind: Kind::List(_), .. }]) =>
        {
            Some((item.clone(), 0))
        }
        ("divided_differences" | "newton" | "lagrange", Kind::List(values)) => match said {
            [Read { label: Label::At | Label::Nodes | Label::With, items: nodes }, ..] => {
                let nodes = match nodes.as_slice() {
                    [Expr { kind: Kind::List(nodes), .. }] => nodes.clone(),
                    nodes => nodes.to_vec(),
                };
                let fits = nodes.len() == values.len()
                    && nodes.len() > 1
                    && nodes.iter().chain(values).all(is_number);
                fits.then(|| (call(draft.builtin.name, vec![list(nodes), item.clone()], item.span), 1))
            }
            _ => None,
        },
        // the blossom p(a, b, c) of a polynomial p(t)
        ("polar", Kind::Apply(callee, groups)) if said.is_empty() => {
            let (Kind::Name(name), [arguments]) = (&callee.kind, groups.as_slice()) else { return None };
            // control points 0, 1, 3: blossom b(0, 1)
            if let (Some(topic), None) = (topic, env.get(&Symbol::new(name)))
                && arguments.len() > 1
                && (name.chars().count() == 1)
            {
                let called = matches!(&topic.kind, Kind::Name(own) if own != name);
                let form = call("polar", vec![topic.clone()], callee.span);
                return (!called).then(|| (applied(form, arguments.clone(), item.span), 0));
            }
            let of_one = match env.get(&Symbol::new(name)) {
                Some(Value::Function(function)) => function.as_formula().is_some(),
                Some(Value::Scalar(formula)) => formula.variables().len() == 1,
                _ => false,
            };
            let form = call("polar", vec![(**callee).clone()], callee.span);
            (of_one && arguments.len() > 1).then(|| (applied(form, arguments.clone(), item.span), 0))
        }
        _ => None,
    }
}

fn is_number(item: &Expr) -> bool {
    !matches!(item.kind, Kind::Chain(..) | Kind::List(_) | Kind::Tuple(_))
}

/// Refuses a curve of control points that is said to go through points.
pub(super) fn meets_points(drafts: &[Draft], through: Option<Span>) -> Result<(), Diagnostic> {
    let of_control_points = |draft: &Draft| matches!(draft.builtin.name, "bezier" | "bspline" | "patch");
    match (through, drafts.last()) {
        (Some(place), Some(draft)) if of_control_points(draft) => {
            Err(Diagnostic::error(Code::Usage, "control points, or points on the curve?")
                .at(place)
                .reason("a curve goes through its first and last control point")
                .hint("write control points 0, 1, 3 for the first")
                .hint("the polynomial through points is lagrange([0, 1, 2], [1, 3, 2])"))
        }
        _ => Ok(()),
    }
}

/// The laws of a polar form, for what is asked to be one: is f(u, v) = u v + u a blossom?
pub(super) fn is_polar(claimed: &Expr, asked: &Utterance) -> Option<Expr> {
    let [Draft { builtin, .. }] = asked.drafts.as_slice() else { return None };
    if builtin.name != "polar" || !asked.items.is_empty() || !asked.said.is_empty() {
        return None;
    }
    let (letters, formula) = match signature(claimed) {
        Some((letters, formula)) => (letters.to_vec(), formula),
        None if matches!(claimed.kind, Kind::Chain(..)) => return None,
        None => (lists::letters(claimed, &Expr::int(0)), claimed),
    };
    let name = |letter: &Expr| matches!(letter.kind, Kind::Name(_) | Kind::Subscript(..));
    if letters.len() < 2 || !letters.iter().all(name) {
        return None;
    }
    let used: BTreeSet<String> = letters.iter().chain([formula]).flat_map(bases).collect();
    let free = ["t", "x", "u", "z"].into_iter().find(|letter| !used.contains(*letter))?;
    let variable = Expr { span: formula.span, ..Expr::name(free) };
    let by: Vec<(Expr, Expr)> = letters.iter().map(|letter| (letter.clone(), variable.clone())).collect();
    let diagonal = formula.with_parts(&by);
    Some(call("laws", vec![formula.clone(), list(letters), diagonal], claimed.span))
}

/// The arguments and the formula of f(u, v) = u v.
pub(super) fn signature(claimed: &Expr) -> Option<(&[Expr], &Expr)> {
    let Kind::Chain(left, links) = &claimed.kind else { return None };
    let ([Link { rel: Rel::Eq | Rel::Define, expr: formula, .. }], Kind::Apply(_, groups)) =
        (links.as_slice(), &left.kind)
    else {
        return None;
    };
    match groups.as_slice() {
        [arguments] => Some((arguments, formula)),
        _ => None,
    }
}

/// The claim that f(u, v) = u v is the polar form of something, or f((x_1, y_1), (x_2, y_2)) = x_1 x_2 that of something in
/// several variables.
pub(super) fn is_polar_of(
    claimed: &Expr,
    asked: &Utterance,
    variables: &dyn Fn(&Expr) -> Vec<Expr>,
) -> Option<Expr> {
    let ([Draft { builtin, .. }], [of], []) =
        (asked.drafts.as_slice(), asked.items.as_slice(), asked.said.as_slice())
    else {
        return None;
    };
    let (arguments, formula) = signature(claimed).filter(|_| builtin.name == "polar")?;
    let span = claimed.span;
    let degree = Expr { span, ..Expr::int(i64::try_from(arguments.len()).ok()?) };
    let pairs = arguments.iter().all(|argument| matches!(argument.kind, Kind::Tuple(_)));
    let variables = if pairs { variables(of) } else { Vec::new() };
    let fits = |argument: &Expr| argument.items().is_some_and(|own| own.len() == variables.len());
    let form = match pairs && arguments.iter().all(fits) {
        true => call("polar_total", vec![of.clone(), list(variables), named("degree", degree)], span),
        false => call("polar", vec![of.clone(), named("degree", degree)], span),
    };
    let form = applied(form, arguments.to_vec(), span);
    Some(Expr { span, ..Expr::relation(form, Rel::Eq, formula.clone()) })
}

/// Refuses points without rows for a surface that has a net of them.
pub(super) fn has_rows(drafts: &[Draft], items: &[Expr]) -> Result<(), Diagnostic> {
    let flat = |item: &Expr| !matches!(&item.kind, Kind::List(_) | Kind::Chain(..) | Kind::Apply(..));
    match (drafts.first(), items) {
        (Some(draft), [a, b, c, d]) if draft.builtin.name == "patch" && items.iter().all(flat) => {
            let rows = |one: [&Expr; 2], other: [&Expr; 2]| {
                let row = |points: [&Expr; 2]| list(points.map(Clone::clone).to_vec());
                let net = list(vec![row(one), row(other)]);
                format!("write {}", crate::language::write::text(&call("patch", vec![net], a.span)))
            };
            Err(Diagnostic::error(Code::Usage, "which of these corners are neighbours?")
                .at(a.span.to(d.span))
                .reason("rows of points are needed, each for one value of u")
                .hint(format!("{} if the first two have u = 0", rows([a, b], [c, d])))
                .hint(format!("{} if the first two have v = 0", rows([a, c], [b, d]))))
        }
        _ => Ok(()),
    }
}

/// Points with a degree or with weights are those of a Bézier curve: the rational quadratic (0, 0), (1, 2), (2, 0) with weights
/// 1, 3, 1; the cubic 0, 0, 8, 8 at 1/2.
pub(super) fn curve_of_points(drafts: &mut Vec<Draft>, items: &[Expr], said: &[Read]) {
    let says = |label: Label| said.iter().any(|read| read.label == label);
    let number = |item: &Expr| {
        matches!(
            item.kind,
            Kind::Number(_) | Kind::Div(..) | Kind::Tuple(_) | Kind::Subscript(..) | Kind::Name(_)
        ) || matches!(&item.kind, Kind::Add(terms) if terms.len() == 1)
    };
    let counted = said.iter().any(|read| {
        read.label == Label::OfDegree
            && matches!(read.items.as_slice(), [degree] if degree.as_int().is_some_and(|n| usize::try_from(n + 1) == Ok(items.len())))
    }) && items.iter().all(number);
    let curve = says(Label::Rational) || counted || says(Label::OfDegree) && says(Label::At);
    if let (true, [first, _, ..], true, false) = (drafts.is_empty(), items, curve, says(Label::Knots))
        && let Some(bezier) = builtin("bezier")
    {
        drafts.push(Draft::new(bezier, first.span));
    }
}

/// Several letters that are said of a polar form are its arguments: the blossom of t^2 in u and v.
pub(super) fn letters_of_polar(drafts: &[Draft], said: &mut Vec<Read>) {
    let letter = |read: &Read| {
        read.label == Label::In && matches!(read.items.as_slice(), [Expr { kind: Kind::Name(_), .. }])
    };
    let count = said.iter().filter(|read| letter(read)).count();
    if count > 1 && drafts.last().is_some_and(|draft| draft.builtin.name == "polar") {
        let mut items = Vec::new();
        said.retain_mut(|read| {
            let own = letter(read);
            if own {
                items.append(&mut read.items);
            }
            !own
        });
        said.push(Read { label: Label::At, items });
    }
}
