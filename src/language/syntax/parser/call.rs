//! Calls `f(a, b; c)` and the calls that have a node of their own, such as `sum(i=0..n, …)`.

use super::super::token::Token;
use super::operand::{Inside, Items};
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
        "prod" => S::Big(BigOp::Product),
        "max" => S::Big(BigOp::Max),
        "min" => S::Big(BigOp::Min),
        "union" => S::Big(BigOp::Union),
        "intersection" => S::Big(BigOp::Intersection),
        "binomial" | "binom" => S::Binomial,
        "integral" => S::Integral,
        "transpose" => S::Transpose,
        "compose" => S::Compose,
        "cases" => S::Cases,
        _ => return None,
    })
}

pub(super) fn is_special(name: &str) -> bool {
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
        let full = inside.rows.len() == 1 && inside.rows[0].iter().all(|cell| cell.item.is_some());
        let count = inside.rows[0].len();
        let expected = match special {
            Special::Accent(_) | Special::Enclosed(_) | Special::Transpose => count == 1,
            Special::Binomial | Special::Integral => count == 2,
            Special::Compose => count >= 2,
            Special::Big(_) => inside.rows[0].iter().filter_map(|cell| cell.item.as_ref()).any(is_bound),
            Special::Cases => false,
        };
        if !full || !expected {
            return self.apply(name, inside);
        }
        if let Special::Integral = special
            && !inside.rows[0][1].item.as_ref().is_some_and(is_integration)
        {
            return self.apply(name, inside);
        }
        let mut items = Items::default();
        inside.rows.into_iter().flatten().filter_map(|cell| cell.item).for_each(|item| items.push(item));
        let Items { mut list, height } = items;
        let mut next = || Box::new(list.remove(0));
        let kind = match special {
            Special::Accent(accent) => Kind::Accent(accent, next()),
            Special::Enclosed(enclosure) => Kind::Enclosed(enclosure, next()),
            Special::Transpose => Kind::Transpose(next()),
            Special::Binomial => {
                let upper = next();
                Kind::Binomial(upper, next(), BinomialStyle::Stacked)
            }
            Special::Integral => {
                let body = next();
                integral(body, *next())
            }
            Special::Compose | Special::Cases => Kind::Compose(list),
            Special::Big(op) => return self.big(op, list, span, height),
        };
        self.node(kind, span, height)
    }

    /// `sum(i=0..n, j=0..i, j != 3, body)`: nested sums; relations restrict the bound before them.
    fn big(&self, op: BigOp, mut items: Vec<Expr>, span: Span, mut height: u32) -> Parsed<Node> {
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

/// Whether an argument bounds a sum: `i = 0..n` or `i in S`.
fn is_bound(node: &Node) -> bool {
    split_range(&node.expr).is_some() || is_membership(&node.expr)
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

fn is_integration(node: &Node) -> bool {
    split_range(&node.expr).is_some() || super::is_parameter(&node.expr.kind)
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
