//! Calls `f(a, b; c)` and the calls that have a node of their own, such as `sum(i=0..n, …)`.

use super::super::token::Token;
use super::operand::{Cell, Inside, Items};
use super::{Node, Parsed, Parser};
use crate::formula::source::Span;
use crate::formula::{Accent, BigOp, BinomialStyle, Enclosure, Expr, Kind, Link, Rel};

/// What a special name makes of its arguments.
#[derive(Clone, Copy)]
enum Special {
    Accent(Accent),
    Enclosed(Enclosure),
    Big(BigOp),
    Binomial,
    Integral,
    Transpose,
    Compose,
    Cases,
}

/// The node for the special name, if it is one.
fn special(name: &str) -> Option<Special> {
    use Special as S;
    Some(match name {
        "hat" => S::Accent(Accent::Hat),
        "bar" => S::Accent(Accent::Bar),
        "vec" => S::Accent(Accent::Vec),
        "tilde" => S::Accent(Accent::Tilde),
        "dot" => S::Accent(Accent::Dot),
        "ddot" => S::Accent(Accent::Ddot),
        "bold" => S::Accent(Accent::Bold),
        "script" => S::Accent(Accent::Script),
        "blackboard" => S::Accent(Accent::Blackboard),
        "abs" => S::Enclosed(Enclosure::Abs),
        "norm" => S::Enclosed(Enclosure::Norm),
        "floor" => S::Enclosed(Enclosure::Floor),
        "ceil" => S::Enclosed(Enclosure::Ceil),
        "sum" => S::Big(BigOp::Sum),
        "prod" | "product" => S::Big(BigOp::Product),
        "max" => S::Big(BigOp::Max),
        "min" => S::Big(BigOp::Min),
        "union" => S::Big(BigOp::Union),
        "intersection" => S::Big(BigOp::Intersection),
        "binomial" | "binom" => S::Binomial,
        "integral" | "int" => S::Integral,
        "transpose" => S::Transpose,
        "compose" => S::Compose,
        "cases" => S::Cases,
        _ => return None,
    })
}

impl Special {
    /// Whether it has a meaning with these arguments; sums have more ways.
    fn takes(self, items: &[&Expr]) -> bool {
        match self {
            Special::Accent(_) | Special::Enclosed(_) | Special::Transpose => items.len() == 1,
            Special::Binomial => items.len() == 2,
            Special::Integral => items.len() == 2 && is_integration(items[1]),
            Special::Compose => items.len() >= 2,
            Special::Big(_) => items.len() == 2 && split_range(items[0]).is_some(),
            Special::Cases => false,
        }
    }

    /// What it makes of its arguments, of which [`Special::takes`] holds.
    fn of(self, mut list: Vec<Expr>) -> Kind {
        if let Special::Compose | Special::Cases = self {
            return Kind::Compose(list);
        }
        let second = (list.len() > 1).then(|| list.remove(1));
        let first = Box::new(list.remove(0));
        match (self, second) {
            (Special::Accent(accent), _) => Kind::Accent(accent, first),
            (Special::Enclosed(enclosure), _) => Kind::Enclosed(enclosure, first),
            (Special::Binomial, Some(lower)) => {
                Kind::Binomial(first, Box::new(lower), BinomialStyle::Stacked)
            }
            (Special::Integral, Some(over)) => integral(first, over),
            (Special::Big(op), Some(body)) => {
                let (lower, upper) = match first.kind {
                    Kind::Chain(name, links) => from_range(*name, links),
                    kind => (Expr::new(kind, first.span), None),
                };
                Kind::Big { op, lower: vec![lower], upper, body: Box::new(body) }
            }
            _ => Kind::Transpose(first),
        }
    }
}

/// The node of a call such as `hat(1)` or `sum(i=0..n, t^i)`, for other readers; the arguments come
/// back if the name means nothing special, or not with these.
pub(crate) fn special_call(name: &str, items: Vec<Expr>) -> Result<Kind, Vec<Expr>> {
    match special(name) {
        Some(special) if special.takes(&items.iter().collect::<Vec<_>>()) => Ok(special.of(items)),
        _ => Err(items),
    }
}

/// The accent that a name sets over its argument.
pub(super) fn accent_of(name: &str) -> Option<Accent> {
    match special(name) {
        Some(Special::Accent(accent)) => Some(accent),
        _ => None,
    }
}

/// Whether the calls of a name have nodes of their own, such as those of `sum`.
pub(crate) fn is_special(name: &str) -> bool {
    special(name).is_some()
}

/// One operator over a range: what stands below and above it.
struct Bound {
    span: Span,
    lower: Vec<Expr>,
    upper: Option<Box<Expr>>,
}

impl Parser<'_> {
    /// The call of `callee`; an opening parenthesis stands here.
    pub(super) fn call(&mut self, callee: Node) -> Parsed<Node> {
        let inside = self.inside(false)?;
        self.apply(callee, inside)
    }

    /// An ordinary application. A group of arguments may be empty: `f()`, `f(; v)`.
    fn apply(&self, callee: Node, inside: Inside) -> Parsed<Node> {
        let span = callee.extent.to(inside.span());
        let mut height = callee.height;
        let mut groups = Vec::with_capacity(inside.rows.len());
        for row in inside.rows {
            let alone = row.len() == 1;
            let mut items = Items::default();
            for cell in row {
                match cell.item {
                    Some(item) => items.push(item),
                    None if alone => {}
                    None => return Err(self.missing_item(cell.end)),
                }
            }
            height = height.max(items.height);
            groups.push(items.list);
        }
        self.node(Kind::Apply(Box::new(callee.expr), groups), span, height)
    }

    /// The call of a special name, whose parenthesis stands here.
    pub(super) fn special(&mut self, name: Token) -> Parsed<Node> {
        let special = special(self.text_of(name));
        let inside = self.inside(matches!(special, Some(Special::Cases)))?;
        let callee = self.name(name)?;
        match special {
            Some(special) => self.special_node(special, callee, inside),
            None => self.apply(callee, inside),
        }
    }

    /// Arguments that the special name does not understand make an ordinary call,
    /// about which the evaluator knows more.
    fn special_node(&self, special: Special, name: Node, inside: Inside) -> Parsed<Node> {
        let span = name.extent.to(inside.span());
        if let Special::Cases = special {
            return self.cases(name, inside);
        }
        let mut inside = inside;
        let full = inside.rows.len() == 1 && inside.rows[0].iter().all(|cell| cell.item.is_some());
        if full {
            spell_bounds(special, &mut inside.rows[0]);
        }
        let bounded = |cell: &Cell| cell.item.as_ref().is_some_and(|item| is_bound(&item.expr));
        let items: Vec<&Expr> =
            inside.rows[0].iter().filter_map(|cell| cell.item.as_ref()).map(|item| &item.expr).collect();
        let expected = match special {
            Special::Big(_) => inside.rows[0].iter().any(bounded),
            _ => special.takes(&items),
        };
        if !full || !expected {
            return self.apply(name, inside);
        }
        let mut items = Items::default();
        inside.rows.into_iter().flatten().filter_map(|cell| cell.item).for_each(|item| items.push(item));
        let Items { list, height } = items;
        if let Special::Big(op) = special {
            return self.big(op, list, span, height);
        }
        let kind = special.of(list);
        self.node(kind, span, height)
    }

    /// `sum(i=0..n, j=0..i, j != 3, body)`: nested sums; relations restrict the bound before them.
    fn big(&self, op: BigOp, mut items: Vec<Expr>, span: Span, mut height: u32) -> Parsed<Node> {
        // sum(k^2, k=1..4) is sum(k=1..4, k^2)
        if items.first().is_some_and(|first| !is_bound(first)) && items.last().is_some_and(is_bound) {
            items.rotate_left(1);
        }
        let is_body = items.last().is_some_and(|last| split_range(last).is_none());
        let Some(body) = items.pop().filter(|_| is_body && !items.is_empty()) else {
            return Err(self.missing_body(op, span));
        };
        let mut bounds: Vec<Bound> = Vec::new();
        for item in items {
            let whole = item.span;
            match (item.kind, bounds.last_mut()) {
                (Kind::Chain(first, links), _) if is_range(&links) => {
                    let (lower, upper) = from_range(*first, links);
                    bounds.push(Bound { span: whole, lower: vec![lower], upper });
                }
                (kind @ Kind::Chain(..), last) => {
                    let relation = Expr::new(kind, whole);
                    match last {
                        Some(bound) if !is_membership(&relation) => bound.lower.push(relation),
                        _ => bounds.push(Bound { span: whole, lower: vec![relation], upper: None }),
                    }
                }
                (_, _) => return Err(self.not_a_bound(op, whole)),
            }
        }
        let mut result = body;
        while let Some(Bound { span: start, lower, upper }) = bounds.pop() {
            let whole = if bounds.is_empty() { span } else { start.to(result.span) };
            let kind = Kind::Big { op, lower, upper, body: Box::new(result) };
            let node = self.node(kind, whole, height)?;
            height = node.height;
            result = node.expr;
        }
        Ok(Node { expr: result, extent: span, height })
    }

    /// `cases(1 if i = 0, t otherwise)`
    fn cases(&self, name: Node, inside: Inside) -> Parsed<Node> {
        let span = name.extent.to(inside.span());
        let mut height = name.height;
        let mut cases = Vec::new();
        for cell in inside.rows.into_iter().flatten() {
            let Some(value) = cell.item else { return Err(self.missing_item(cell.end)) };
            let Some(condition) = cell.condition else { return Err(self.missing_condition(&value)) };
            height = height.max(value.height).max(condition.as_ref().map_or(0, |c| c.height));
            cases.push((value.expr, condition.map(|c| c.expr)));
        }
        self.node(Kind::Cases(cases), span, height)
    }
}

/// Bounds as other systems write them, `sum(k^2, k, 1, 4)` and `sum(k, 1, 4, k^2)`, become `k = 1..4`.
fn spell_bounds(special: Special, cells: &mut Vec<Cell>) {
    if !matches!(special, Special::Big(BigOp::Sum | BigOp::Product) | Special::Integral) {
        return;
    }
    let named = |cell: &Cell| cell.item.as_ref().is_some_and(|item| super::is_parameter(&item.expr.kind));
    let plain = |cell: &Cell| {
        cell.item.as_ref().is_some_and(|item| !matches!(item.expr.kind, Kind::Chain(..) | Kind::Range(..)))
    };
    let at = match cells.as_slice() {
        [_, name, _, _] if named(name) => 1,
        [name, _, _, _] if named(name) && matches!(special, Special::Big(_)) => 0,
        _ => return,
    };
    if !cells.iter().all(plain) {
        return;
    }
    let mut taken = cells.drain(at..at + 3).filter_map(|cell| Some((cell.item?, cell.end)));
    let (Some((name, _)), Some((low, _)), Some((high, end))) = (taken.next(), taken.next(), taken.next())
    else {
        return;
    };
    drop(taken);
    let extent = name.extent.to(high.extent);
    let height = name.height.max(low.height).max(high.height) + 2;
    let bounds = low.extent.to(high.extent);
    let range = Expr::new(Kind::Range(Box::new(low.expr), Box::new(high.expr)), bounds);
    let link = Link { rel: Rel::Eq, span: bounds, expr: range };
    let expr = Expr::new(Kind::Chain(Box::new(name.expr), vec![link]), extent);
    let cell = Cell { item: Some(Node { expr, extent, height }), end, condition: None };
    cells.insert(at, cell);
}

/// Whether an argument bounds a sum: `i = 0..n` or `i in S`.
fn is_bound(expr: &Expr) -> bool {
    split_range(expr).is_some() || is_membership(expr)
}

fn is_membership(expr: &Expr) -> bool {
    matches!(&expr.kind, Kind::Chain(_, links) if matches!(links.as_slice(), [Link { rel: Rel::In, .. }]))
}

fn is_range(links: &[Link]) -> bool {
    matches!(links, [Link { rel: Rel::Eq, expr: Expr { kind: Kind::Range(..), .. }, .. }])
}

/// The name of `name = low..high`.
fn split_range(expr: &Expr) -> Option<&Expr> {
    match &expr.kind {
        Kind::Chain(name, links) if is_range(links) => Some(name),
        _ => None,
    }
}

/// `i = 0..n`, of which [`is_range`] holds, as the relation i = 0 and the bound n.
fn from_range(name: Expr, mut links: Vec<Link>) -> (Expr, Option<Box<Expr>>) {
    let mut upper = None;
    for link in &mut links {
        let placeholder = Expr::new(Kind::Ellipsis, link.expr.span);
        link.expr = match std::mem::replace(&mut link.expr, placeholder) {
            Expr { kind: Kind::Range(low, high), .. } => {
                upper = Some(high);
                *low
            }
            other => other,
        };
    }
    let span = links.iter().fold(name.span, |span, link| span.to(link.expr.span));
    (Expr::new(Kind::Chain(Box::new(name), links), span), upper)
}

fn is_integration(expr: &Expr) -> bool {
    split_range(expr).is_some() || super::is_parameter(&expr.kind)
}

/// The integral over a variable, of which [`is_integration`] holds.
fn integral(body: Box<Expr>, over: Expr) -> Kind {
    match over.kind {
        Kind::Chain(name, links) => {
            let mut lower = None;
            let mut upper = None;
            for link in links {
                if let Kind::Range(low, high) = link.expr.kind {
                    lower = Some(low);
                    upper = Some(high);
                }
            }
            Kind::Integral { lower, upper, body, variable: name }
        }
        _ => Kind::Integral { lower: None, upper: None, body, variable: Box::new(over) },
    }
}
