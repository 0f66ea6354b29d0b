//! Random formulas and values.

use std::sync::Arc;

use nalgebra::DMatrix;
use polarform::blossom::{PolarForm, TensorPolarForm, TotalDegreePolarForm};
use polarform::expr::{Accent, BinomialStyle, Enclosure, Expr, Kind, Quotient, Rel, Sign, Term};
use polarform::number::{Rational, rational};
use polarform::poly::{Fraction, Index, MultiPoly, Symbol};
use polarform::value::{Polar, PolarKind, Value, symbol_expr};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

/// Some values of a strategy, the same ones every time.
pub fn samples<S: Strategy>(strategy: &S, count: usize) -> Vec<S::Value> {
    let mut runner = TestRunner::deterministic();
    (0..count).map(|_| strategy.new_tree(&mut runner).expect("nothing is filtered away").current()).collect()
}

/// Names as they occur in lectures.
pub fn symbol() -> impl Strategy<Value = Symbol> {
    prop::sample::select(vec![
        Symbol::new("t"),
        Symbol::new("x"),
        Symbol::new("alpha"),
        Symbol::new("tau"),
        Symbol::indexed("t", 1),
        Symbol::indexed("t", 12),
        Symbol::indexed("c", 0),
        Symbol::indexed("c", 10),
        Symbol::new("p").with_indices([Index::Number(1), Index::Number(2)]),
        Symbol::new("b").with_indices([Index::Word("01".to_owned())]),
        Symbol::new("p").with_indices([Index::Word("i".to_owned())]),
        Symbol::indexed("v", 2),
        Symbol::indexed("omega", 3),
    ])
}

/// Zero, small and large fractions of either sign.
pub fn number() -> impl Strategy<Value = Rational> {
    prop_oneof![
        2 => (-4i64..5).prop_map(|p| rational(p, 1)),
        2 => (-30i64..31, 1i64..12).prop_map(|(p, q)| rational(p, q)),
        1 => (any::<i64>(), 1..i64::MAX).prop_map(|(p, q)| rational(p, q)),
    ]
}

fn leaf() -> impl Strategy<Value = Expr> {
    prop_oneof![
        3 => symbol().prop_map(|s| symbol_expr(&s)),
        1 => (0i64..20).prop_map(Expr::int),
        1 => number().prop_map(|q| Expr::number(&q)),
    ]
}

fn sign() -> impl Strategy<Value = Sign> {
    prop_oneof![Just(Sign::Plus), Just(Sign::Minus)]
}

/// Formulas in numbers and symbols; F and G stand for functions of one variable, f for one of two.
pub fn formula() -> impl Strategy<Value = Expr> {
    leaf().prop_recursive(5, 40, 4, |inner| {
        let boxed = |e: Expr| Box::new(e);
        prop_oneof![
            4 => prop::collection::vec((sign(), inner.clone()), 2..4).prop_map(|terms| {
                Kind::Add(terms.into_iter().map(|(sign, expr)| Term { sign, expr }).collect()).into()
            }),
            4 => prop::collection::vec(inner.clone(), 2..4).prop_map(|factors| Kind::Mul(factors).into()),
            2 => (inner.clone(), inner.clone(), any::<bool>()).prop_map(move |(a, b, slash)| {
                let style = if slash { Quotient::Slash } else { Quotient::Fraction };
                Kind::Div(Box::new(a), Box::new(b), style).into()
            }),
            2 => (inner.clone(), -2i64..4).prop_map(|(base, k)| base.power(Expr::int(k))),
            2 => inner.clone().prop_map(Expr::negated),
            1 => inner.clone().prop_map(Expr::grouped),
            1 => inner.clone().prop_map(|a| Expr::apply(Expr::name("F"), vec![a])),
            1 => (inner.clone(), inner.clone()).prop_map(|(a, b)| Expr::apply(Expr::name("f"), vec![a, b])),
            1 => inner.clone().prop_map(move |a| {
                let slope = Kind::Prime(boxed(Expr::name("F")), 1);
                Expr::apply(slope.into(), vec![a])
            }),
            1 => inner.clone().prop_map(|a| {
                let both = Kind::Compose(vec![Expr::name("F"), Expr::name("G")]);
                Expr::apply(Expr::from(both).grouped(), vec![a])
            }),
            1 => inner.clone().prop_map(|a| {
                let hat = Kind::Accent(Accent::Hat, Box::new(a)).into();
                Expr::apply(Expr::name("f"), vec![Expr::name("t"), hat])
            }),
            1 => (0i64..7, 0i64..7).prop_map(|(n, k)| {
                Kind::Binomial(Box::new(Expr::int(n)), Box::new(Expr::int(k)), BinomialStyle::Stacked).into()
            }),
            1 => (0i64..7).prop_map(|n| Kind::Factorial(Box::new(Expr::int(n))).into()),
            1 => number().prop_map(|q| Kind::Enclosed(Enclosure::Abs, Box::new(Expr::number(&q))).into()),
        ]
    })
}

/// Formulas, lists of them, and equations.
pub fn statement() -> impl Strategy<Value = Expr> {
    prop_oneof![
        4 => formula(),
        1 => prop::collection::vec(formula(), 0..4).prop_map(|items| Kind::List(items).into()),
        1 => (formula(), formula()).prop_map(|(a, b)| Expr::relation(a, Rel::Eq, b)),
    ]
}

/// Polynomials in several symbols.
pub fn polynomial() -> impl Strategy<Value = MultiPoly> {
    let power = (symbol(), 1u32..4);
    prop::collection::vec((prop::collection::vec(power, 0..3), number()), 0..5)
        .prop_map(MultiPoly::from_terms)
}

/// Polynomials and proper fractions.
pub fn scalar() -> impl Strategy<Value = Fraction> {
    prop_oneof![
        2 => polynomial().prop_map(Fraction::from),
        1 => (polynomial(), polynomial()).prop_map(|(p, q)| {
            let denominator = q + MultiPoly::symbol(Symbol::indexed("h", 1));
            Fraction::new(p, denominator).expect("the denominator holds h_1")
        }),
    ]
}

/// Coefficients of a polar form: mostly numbers, some symbolic.
fn coefficients(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<Fraction>> {
    let coefficient = prop_oneof![
        4 => number().prop_map(Fraction::from),
        1 => (0i64..4, number()).prop_map(|(k, q)| {
            Fraction::from(MultiPoly::from_terms([(vec![(Symbol::indexed("c", k), 1)], q)]))
        }),
    ];
    prop::collection::vec(coefficient, count)
}

fn polar(kind: PolarKind, variables: &[&str]) -> Polar {
    Polar { kind, variables: variables.iter().map(|name| Symbol::new(*name)).collect() }
}

/// Polar forms in one variable.
pub fn univariate() -> impl Strategy<Value = Polar> {
    coefficients(1..6).prop_map(|c| polar(PolarKind::Univariate(PolarForm::new(c)), &["t"]))
}

/// Polar forms of all three kinds.
pub fn any_polar() -> impl Strategy<Value = Polar> {
    let tensor = (1usize..4, 1usize..4).prop_flat_map(|(m, n)| {
        prop::collection::vec(coefficients(n..n + 1), m).prop_map(|grid| {
            let form = TensorPolarForm::new(grid).expect("the rows are of one length");
            polar(PolarKind::Tensor(form), &["u", "v"])
        })
    });
    let total = coefficients(6..7).prop_map(|c| {
        let exponents = (0..3u32).flat_map(|i| (0..3 - i).map(move |j| [i, j].into_iter().collect()));
        let form = TotalDegreePolarForm::new(2, 2, exponents.zip(c)).expect("the degrees are at most 2");
        polar(PolarKind::Total(form), &["u", "v"])
    });
    prop_oneof![2 => univariate(), 1 => tensor, 1 => total]
}

/// Numbers, polynomials, fractions, vectors, lists and matrices.
pub fn value() -> impl Strategy<Value = Value> {
    let matrix = (1usize..4, 1usize..4).prop_flat_map(|(m, n)| {
        prop::collection::vec(scalar(), m * n)
            .prop_map(move |entries| Value::Matrix(DMatrix::from_row_slice(m, n, &entries)))
    });
    let flat = prop_oneof![
        2 => number().prop_map(Value::number),
        4 => scalar().prop_map(Value::Scalar),
        1 => scalar().prop_map(Value::Vector),
        2 => matrix,
    ];
    flat.prop_recursive(2, 8, 3, |inner| prop::collection::vec(inner, 0..4).prop_map(Value::list))
}

/// A polar form as a value.
pub fn shared(polar: Polar) -> Value {
    Value::Polar(Arc::new(polar))
}
