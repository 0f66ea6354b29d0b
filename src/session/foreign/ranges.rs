//! Sums, products and lists over ranges: `{k, 1, 5}`, `(k, 1, 5)`, `k = 1..5`.

use crate::formula::source::Span;
use crate::formula::{BigOp, Enclosure, Expr, Kind, Link, Rel, Sign, Term, applied};

/// The sum or product that a name means elsewhere.
pub(super) fn big_operator(name: &str) -> Option<BigOp> {
    match name {
        "Sum" | "sum" | "summation" | "add" => Some(BigOp::Sum),
        "Product" | "product" | "prod" | "mul" => Some(BigOp::Product),
        _ => None,
    }
}

/// Whether a name makes a list of the values of a formula.
pub(super) fn list_maker(name: &str) -> bool {
    matches!(name, "Table" | "seq" | "makelist" | "Sequence" | "create_list")
}

/// An index and its values.
struct Range {
    name: Expr,
    from: Expr,
    to: Expr,
    /// What it is counted by, if not by 1.
    step: Option<Expr>,
    span: Span,
}

/// A range as other systems have it; a pair in parentheses is a point.
fn range(expr: &Expr) -> Option<Range> {
    let span = expr.span;
    let one = Expr { span, ..Expr::int(1) };
    let (name, from, to, step) = match &expr.kind {
        Kind::Set(items, None) => match items.as_slice() {
            [name, to] => (name, &one, to, None),
            [name, from, to] => (name, from, to, None),
            [name, from, to, step] => (name, from, to, Some(step.clone())),
            _ => return None,
        },
        Kind::Tuple(items) => match items.as_slice() {
            [name, from, to] => (name, from, to, None),
            _ => return None,
        },
        Kind::Chain(name, links) => match links.as_slice() {
            [Link { rel: Rel::Eq | Rel::In, expr: Expr { kind: Kind::Range(from, to), .. }, .. }] => {
                (&**name, &**from, &**to, None)
            }
            _ => return None,
        },
        _ => return None,
    };
    matches!(name.kind, Kind::Name(_)).then(|| Range {
        name: name.clone(),
        from: from.clone(),
        to: to.clone(),
        step,
        span,
    })
}

/// Table[f, {i, a, b}, {j, c, d}], a list for each i: the last range is the inner one.
pub(super) fn listed(arguments: &[Expr]) -> Option<Kind> {
    // makelist(F, i, 0, 3)
    if let [body, name, from, to] = arguments
        && matches!(name.kind, Kind::Name(_))
    {
        return Some(list_of(body, name, from, to));
    }
    let (body, ranges) = arguments.split_first()?;
    let mut whole = body.clone();
    for written in ranges.iter().rev() {
        let range = range(written)?;
        let kind = match &range.step {
            None => list_of(&whole, &range.name, &range.from, &range.to),
            Some(step) => stepped(&whole, &range, step),
        };
        whole = Expr::new(kind, whole.span.to(range.span));
    }
    (!ranges.is_empty()).then_some(whole.kind)
}

/// The values of a formula for a range of its index.
pub(super) fn list_of(body: &Expr, name: &Expr, from: &Expr, to: &Expr) -> Kind {
    let span = from.span.to(to.span);
    let values = Expr::new(Kind::Range(Box::new(from.clone()), Box::new(to.clone())), span);
    mapped(body, name, values)
}

fn mapped(body: &Expr, name: &Expr, values: Expr) -> Kind {
    let span = values.span;
    let function = Kind::Lambda(vec![name.clone()], Box::new(body.clone()));
    let arguments = vec![Expr::new(function, body.span), values];
    applied(Expr { span: body.span, ..Expr::name("map") }, arguments, span).kind
}

/// The same for an index that is not counted by 1.
fn stepped(body: &Expr, range: &Range, step: &Expr) -> Kind {
    let span = range.span;
    let times = Expr { span, ..Expr::name("iota") };
    let grouped = |expr: &Expr| expr.clone().grouped();
    let of = |sign: Sign, expr: Expr| Term { sign, expr };
    let difference =
        Expr::sum(vec![of(Sign::Plus, grouped(&range.to)), of(Sign::Minus, grouped(&range.from))]).grouped();
    let count = Kind::Enclosed(Enclosure::Floor, Box::new(difference.over(grouped(step))));
    let multiple = Expr::product(vec![times.clone(), grouped(step)]);
    let value = Expr::sum(vec![of(Sign::Plus, grouped(&range.from)), of(Sign::Plus, multiple)]);
    let values = list_of(&value, &times, &Expr { span, ..Expr::int(0) }, &Expr::new(count, span));
    mapped(body, &range.name, Expr::new(values, span))
}

/// Sum[f, {i, a, b}, {j, c, d}]: the last range is the inner one.
pub(super) fn over_ranges(op: BigOp, arguments: &[Expr]) -> Option<Kind> {
    let (body, ranges) = arguments.split_first()?;
    let mut whole = body.clone();
    for written in ranges.iter().rev() {
        let Range { name, from, to, step: None, span } = range(written)? else { return None };
        let lower = Expr { span: name.span.to(to.span), ..Expr::relation(name, Rel::Eq, from) };
        let span = whole.span.to(span);
        let body = Expr { span: whole.span, ..whole.grouped() };
        let kind = Kind::Big { op, lower: vec![lower], upper: Some(Box::new(to)), body: Box::new(body) };
        whole = Expr::new(kind, span);
    }
    (!ranges.is_empty()).then_some(whole.kind)
}
