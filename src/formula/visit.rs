//! Walking and comparing trees.

use super::{Expr, Kind};
use crate::formula::source::Span;

/// Calls a function on every direct child, in written order: with `iter`, or with `iter_mut` and `mut`.
macro_rules! for_each_child {
    ($kind:expr, $visit:ident, $iter:ident $(, $mut:tt)?) => {
        match $kind {
            Kind::Number(_) | Kind::Name(_) | Kind::Ellipsis | Kind::Text(_) | Kind::Unread(_) => {}
            Kind::Subscript(base, list) | Kind::Upper(base, list) => {
                $visit(base);
                list.$iter().for_each($visit);
            }
            Kind::Accent(_, body)
            | Kind::Prime(body, _)
            | Kind::Group(body)
            | Kind::Factorial(body)
            | Kind::Enclosed(_, body)
            | Kind::Transpose(body) => $visit(body),
            Kind::Add(terms) => terms.$iter().for_each(|term| $visit(&$($mut)? term.expr)),
            Kind::Mul(list)
            | Kind::Tuple(list)
            | Kind::List(list)
            | Kind::Compose(list)
            | Kind::Cross(list)
            | Kind::Sequence(list) => list.$iter().for_each($visit),
            Kind::Div(a, b, _) | Kind::Pow(a, b) | Kind::Binomial(a, b, _) | Kind::Range(a, b) => {
                $visit(a);
                $visit(b);
            }
            Kind::Apply(callee, groups) => {
                $visit(callee);
                groups.$iter().flatten().for_each($visit);
            }
            Kind::Set(list, condition) => {
                list.$iter().for_each(&mut *$visit);
                condition.$iter().for_each(|c| $visit(c));
            }
            Kind::Matrix(rows, _) => rows.$iter().flatten().flatten().for_each($visit),
            Kind::Big { lower, upper, body, .. } => {
                lower.$iter().for_each(&mut *$visit);
                upper.$iter().for_each(|u| $visit(u));
                $visit(body);
            }
            Kind::Integral { lower, upper, body, variable } => {
                lower.$iter().for_each(|x| $visit(x));
                upper.$iter().for_each(|x| $visit(x));
                $visit(body);
                $visit(variable);
            }
            Kind::Derivative { variables, body, .. } => {
                for (variable, order) in variables {
                    $visit(variable);
                    order.$iter().for_each(&mut *$visit);
                }
                body.$iter().for_each(|b| $visit(b));
            }
            Kind::At { body, lower, upper } => {
                $visit(body);
                lower.$iter().for_each(&mut *$visit);
                upper.$iter().for_each(|u| $visit(u));
            }
            Kind::Cases(cases) => {
                for (value, condition) in cases {
                    $visit(value);
                    condition.$iter().for_each(&mut *$visit);
                }
            }
            Kind::Brace(list, label) => {
                list.$iter().for_each(&mut *$visit);
                label.$iter().for_each(|l| $visit(l));
            }
            Kind::Lambda(parameters, body) => {
                parameters.$iter().for_each(&mut *$visit);
                $visit(body);
            }
            Kind::Chain(first, links) => {
                $visit(first);
                links.$iter().for_each(|link| $visit(&$($mut)? link.expr));
            }
            Kind::ForAll(list, body) => {
                list.$iter().for_each(&mut *$visit);
                body.$iter().for_each(|b| $visit(b));
            }
        }
    };
}

impl Expr {
    /// Calls `visit` on every direct child, in written order.
    pub fn for_each_child<'a>(&'a self, visit: &mut dyn FnMut(&'a Expr)) {
        for_each_child!(&self.kind, visit, iter);
    }

    /// Whether it, or a part of it, passes a test.
    pub fn has(&self, test: &dyn Fn(&Expr) -> bool) -> bool {
        let mut found = test(self);
        self.for_each_child(&mut |child| found = found || child.has(test));
        found
    }

    /// The same with a formula in the place of a name.
    pub fn with_name(&self, name: &str, other: &Expr) -> Expr {
        fn put_in(expr: &mut Expr, name: &str, other: &Expr) {
            if matches!(&expr.kind, Kind::Name(own) if own == name) {
                expr.kind = other.kind.clone();
                return;
            }
            expr.for_each_child_mut(&mut |child| put_in(child, name, other));
        }
        let mut copy = self.clone();
        put_in(&mut copy, name, other);
        copy
    }

    /// The same walk with mutable access.
    pub fn for_each_child_mut(&mut self, visit: &mut dyn FnMut(&mut Expr)) {
        for_each_child!(&mut self.kind, visit, iter_mut, mut);
    }

    /// Replaces every span of the tree.
    pub fn map_spans(&mut self, map: &dyn Fn(Span) -> Span) {
        self.span = map(self.span);
        if let Kind::Chain(_, links) = &mut self.kind {
            links.iter_mut().for_each(|link| link.span = map(link.span));
        }
        self.for_each_child_mut(&mut |child| child.map_spans(map));
    }

    /// Moves every span of the tree `offset` bytes further on (a formula inside a larger text).
    pub fn shift(&mut self, offset: usize) {
        self.map_spans(&|span| span.shifted(offset));
    }

    /// The same tree with all spans empty, for comparing structure.
    pub fn without_spans(mut self) -> Self {
        self.map_spans(&|_| Span::default());
        self
    }

    /// The formula with others in the places of some of its parts, all at once.
    pub fn with_parts(&self, by: &[(Expr, Expr)]) -> Expr {
        fn put_in(expr: &mut Expr, by: &[(Expr, Expr)]) {
            match by.iter().find(|(part, _)| part.same_as(expr)) {
                Some((_, other)) => *expr = other.clone(),
                None => expr.for_each_child_mut(&mut |child| put_in(child, by)),
            }
        }
        let mut copy = self.clone();
        put_in(&mut copy, by);
        copy
    }

    /// Whether both trees have the same structure, wherever they were read.
    pub fn same_as(&self, other: &Expr) -> bool {
        std::mem::discriminant(&self.kind) == std::mem::discriminant(&other.kind)
            && self.clone().without_spans() == other.clone().without_spans()
    }
}
