//! Short ways to build trees, and random ones.

use proptest::prelude::*;

use crate::formula::{Accent, BigOp, Delimiter, Expr, Kind, Quotient, Rel, Sign, Term};
use crate::math::number::{integer, rational};

pub(super) fn n(value: i64) -> Expr {
    Kind::Number(integer(value)).into()
}

pub(super) fn v(name: &str) -> Expr {
    Expr::name(name)
}

pub(super) fn t(index: i64) -> Expr {
    Expr::indexed("t", index)
}

pub(super) fn add(terms: impl IntoIterator<Item = Expr>) -> Expr {
    Kind::Add(terms.into_iter().map(|expr| Term { sign: Sign::Plus, expr }).collect()).into()
}

pub(super) fn sub(a: Expr, b: Expr) -> Expr {
    Kind::Add(vec![Term { sign: Sign::Plus, expr: a }, Term { sign: Sign::Minus, expr: b }]).into()
}

pub(super) fn mul(factors: impl Into<Vec<Expr>>) -> Expr {
    Kind::Mul(factors.into()).into()
}

pub(super) fn div(a: Expr, b: Expr) -> Expr {
    Kind::Div(Box::new(a), Box::new(b), Quotient::Slash).into()
}

pub(super) fn pow(a: Expr, b: Expr) -> Expr {
    a.power(b)
}

pub(super) fn eq(a: Expr, b: Expr) -> Expr {
    Expr::relation(a, Rel::Eq, b)
}

pub(super) fn index(base: Expr, indices: impl Into<Vec<Expr>>) -> Expr {
    Kind::Subscript(Box::new(base), indices.into()).into()
}

pub(super) fn accent(accent: Accent, body: Expr) -> Expr {
    Kind::Accent(accent, Box::new(body)).into()
}

pub(super) fn prime(body: Expr, count: u32) -> Expr {
    Kind::Prime(Box::new(body), count).into()
}

pub(super) fn factorial(body: Expr) -> Expr {
    Kind::Factorial(Box::new(body)).into()
}

pub(super) fn upper(body: Expr, index: Expr) -> Expr {
    Kind::Upper(Box::new(body), vec![index]).into()
}

pub(super) fn call(name: &str, arguments: impl Into<Vec<Expr>>) -> Expr {
    Expr::apply(v(name), arguments.into())
}

pub(super) fn matrix(rows: Vec<Vec<Expr>>, delimiter: Delimiter) -> Expr {
    Kind::Matrix(rows.into_iter().map(|row| row.into_iter().map(Some).collect()).collect(), delimiter).into()
}

pub(super) fn big(op: BigOp, lower: Vec<Expr>, upper: Option<Expr>, body: Expr) -> Expr {
    Kind::Big { op, lower, upper: upper.map(Box::new), body: Box::new(body) }.into()
}

pub(super) fn sum(body: Expr) -> Expr {
    big(BigOp::Sum, vec![eq(v("i"), n(0))], Some(v("n")), body)
}

pub(super) fn derivative(partial: bool, variables: Vec<(Expr, Option<Expr>)>, body: Option<Expr>) -> Expr {
    Kind::Derivative { partial, variables, body: body.map(Box::new) }.into()
}

pub(super) fn compose(functions: impl Into<Vec<Expr>>) -> Expr {
    Kind::Compose(functions.into()).into()
}

pub(super) fn dots() -> Expr {
    Kind::Ellipsis.into()
}

/// Any formula out of the kinds that readers make.
pub(super) fn formula() -> impl Strategy<Value = Expr> {
    let leaf = prop_oneof![
        (0..30_i64).prop_map(n),
        (-9..9_i64, 1..9_i64).prop_map(|(p, q)| Expr::number(&rational(p, q))),
        (1..99_i64).prop_map(t),
        proptest::sample::select(vec!["a", "t", "sigma", "polar", "e", "F"]).prop_map(v),
        Just(dots()),
    ];
    leaf.prop_recursive(5, 40, 3, |inner| {
        let list = proptest::collection::vec(inner.clone(), 2..4);
        prop_oneof![
            (list.clone(), any::<bool>()).prop_map(|(mut items, minus)| {
                let last = items.pop().expect("two items at least");
                let sum = add(items);
                if minus { sub(sum, last) } else { sum }
            }),
            list.clone().prop_map(mul),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| div(a, b)),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| a.over(b)),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| pow(a, b)),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| index(a, [b])),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| upper(a, b)),
            (proptest::sample::select(vec!["f", "F", "polar"]), list.clone()).prop_map(|(f, x)| call(f, x)),
            list.clone().prop_map(|x| Expr::apply(compose([v("f"), v("g")]).grouped(), x)),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| eq(a, b)),
            inner.clone().prop_map(Expr::grouped),
            inner.clone().prop_map(factorial),
            inner.clone().prop_map(sum),
            inner.clone().prop_map(|a| prime(a, 1)),
            inner.clone().prop_map(|a| accent(Accent::Hat, a)),
            list.clone().prop_map(compose),
            list.clone().prop_map(|a| Kind::List(a).into()),
            list.clone().prop_map(|a| Kind::Set(a, None).into()),
            list.prop_map(|a| matrix(vec![a], Delimiter::Paren)),
            inner.prop_map(|a| derivative(false, vec![(v("t"), None)], Some(a))),
        ]
    })
}
