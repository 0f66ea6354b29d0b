//! What calls, brackets, operators and relations print as in each notation.

use super::arithmetic::Row;
use super::trees::*;
use crate::formula::{BigOp, BinomialStyle, Delimiter, Enclosure, Expr, Kind, Link, Rel};

pub(super) fn calls_and_brackets() -> Vec<Row> {
    let b_in = || pow(index(v("B"), [v("i")]), v("n"));
    vec![
        (
            Kind::Apply(
                Box::new(v("f")),
                vec![vec![Expr::indexed("u", 1), Expr::indexed("u", 2)], vec![Expr::indexed("v", 1)]],
            )
            .into(),
            "f(u1, u2; v1)",
            "f(u₁, u₂; v₁)",
            "f(u_1, u_2; v_1)",
            "f(u1, u2, v1)",
        ),
        (call("polar", [v("t")]), "polar(t)", "polar(t)", r"\operatorname{polar}(t)", "polar(t)"),
        (call("sin", [v("t")]), "sin(t)", "sin(t)", r"\sin(t)", "sin(t)"),
        (call("sqrt", [v("t")]), "sqrt(t)", "sqrt(t)", r"\sqrt{t}", "sqrt(t)"),
        (call("root", [v("t"), n(3)]), "root(t, 3)", "root(t, 3)", r"\sqrt[{3}]{t}", "root(t, 3)"),
        (call("cup", [v("A"), v("B")]), "cup(A, B)", "cup(A, B)", r"A \cup B", "cup(A, B)"),
        (call("f", []), "f()", "f()", "f()", "f()"),
        (Expr::apply(call("f", [n(0)]), vec![n(1)]), "f(0)(1)", "f(0)(1)", "f(0)(1)", "!a call of this form"),
        (Expr::apply(b_in(), vec![v("t")]), "B_i^n(t)", "Bᵢⁿ(t)", "B_i^n(t)", "!a call of this form"),
        (
            Expr::apply(pow(v("f"), n(2)), vec![v("t")]),
            "(f^2)(t)",
            "(f²)(t)",
            "f^2(t)",
            "!a call of this form",
        ),
        (
            Expr::apply(add([v("f"), v("g")]), vec![n(0), n(1)]),
            "(f + g)(0, 1)",
            "(f + g)(0, 1)",
            "(f + g)(0, 1)",
            "!a call of this form",
        ),
        (call("f", [v("a").over(v("b"))]), "f(a/b)", "f(a/b)", r"f\left( \frac{a}{b} \right)", "f(a/b)"),
        (Kind::Tuple(vec![v("a"), v("b")]).into(), "(a, b)", "(a, b)", "(a, b)", "(a, b)"),
        (Kind::List(vec![v("a"), v("b")]).into(), "[a, b]", "[a, b]", "[a, b]", "[a, b]"),
        (Kind::Set(vec![v("a"), v("b")], None).into(), "{a, b}", "{a, b}", r"\{ a, b \}", "FiniteSet(a, b)"),
        (
            Kind::Set(vec![v("x")], Some(Box::new(Expr::relation(v("x"), Rel::Gt, n(0))))).into(),
            "{x | x > 0}",
            "{x | x > 0}",
            r"\{ x \mid x > 0 \}",
            "ConditionSet(x, Gt(x, 0))",
        ),
        (
            mul([v("a"), Kind::Set(vec![v("x")], None).into()]),
            "a*{x}",
            "a·{x}",
            r"a \cdot \{ x \}",
            "a*FiniteSet(x)",
        ),
        (
            Kind::Binomial(Box::new(v("n")), Box::new(v("k")), BinomialStyle::Stacked).into(),
            "binomial(n, k)",
            "binomial(n, k)",
            r"\binom{n}{k}",
            "binomial(n, k)",
        ),
        (
            pow(Kind::Binomial(Box::new(v("n")), Box::new(v("k")), BinomialStyle::Subscripted).into(), n(2)),
            "binomial(n, k)^2",
            "binomial(n, k)²",
            "(C_{n}^{k})^2",
            "binomial(n, k)**2",
        ),
        (factorial(sub(v("n"), v("k"))), "(n - k)!", "(n - k)!", "(n - k)!", "factorial(n - k)"),
        (
            Kind::Enclosed(Enclosure::Abs, Box::new(v("x"))).into(),
            "abs(x)",
            "abs(x)",
            r"\lvert x \rvert",
            "Abs(x)",
        ),
        (
            Kind::Enclosed(Enclosure::Norm, Box::new(v("x"))).into(),
            "norm(x)",
            "norm(x)",
            r"\lVert x \rVert",
            "!a norm",
        ),
        (
            Kind::Enclosed(Enclosure::Floor, Box::new(v("n").over(n(2)))).into(),
            "floor(n/2)",
            "⌊n/2⌋",
            r"\left\lfloor \frac{n}{2} \right\rfloor",
            "floor(n/2)",
        ),
        (
            Kind::Enclosed(Enclosure::Ceil, Box::new(v("x"))).into(),
            "ceil(x)",
            "⌈x⌉",
            r"\lceil x \rceil",
            "ceiling(x)",
        ),
        (
            matrix(vec![vec![v("a"), n(0)], vec![v("c"), n(-1)]], Delimiter::Paren),
            "[a, 0; c, -1]",
            "⎛ a  0  ⎞\n⎝ c  -1 ⎠",
            r"\begin{pmatrix} a & 0 \\ c & -1 \end{pmatrix}",
            "Matrix([[a, 0], [c, -1]])",
        ),
        (
            matrix(vec![vec![v("a"), v("b")]], Delimiter::Bracket),
            "[a, b;]",
            "[a, b;]",
            r"\begin{bmatrix} a & b \end{bmatrix}",
            "Matrix([[a, b]])",
        ),
        (
            mul([n(2), matrix(vec![vec![v("a")], vec![Kind::List(vec![v("b")]).into()]], Delimiter::Bar)]),
            "2 det([a; [b]])",
            "2 det([a; [b]])",
            r"2 \begin{vmatrix} a \\ {}[b] \end{vmatrix}",
            "2*det(Matrix([[a], [[b]]]))",
        ),
        (
            eq(v("A"), matrix(vec![vec![n(1)], vec![n(0)], vec![v("x").over(n(2))]], Delimiter::Bracket)),
            "A = [1; 0; x/2]",
            "    ⎡  1  ⎤\nA = ⎢  0  ⎥\n    ⎣ x/2 ⎦",
            r"A = \begin{bmatrix} 1 \\ 0 \\ \frac{x}{2} \end{bmatrix}",
            "Eq(A, Matrix([[1], [0], [x/2]]))",
        ),
        (
            add([v("a"), Kind::Matrix(vec![vec![None, Some(n(1))], vec![None]], Delimiter::None).into()]),
            "a + [, 1; ;]",
            "a + [, 1; ;]",
            r"a + \begin{matrix}  & 1 \\  \end{matrix}",
            "!a matrix with rows of different lengths",
        ),
        (
            Kind::Cases(vec![(n(1), Some(eq(v("i"), n(0)))), (v("t"), None)]).into(),
            "cases(1 if i = 0, t otherwise)",
            "cases(1 if i = 0, t otherwise)",
            r"\begin{cases} 1 & i = 0 \\ t & \text{otherwise} \end{cases}",
            "Piecewise((1, Eq(i, 0)), (t, True))",
        ),
        (
            call(
                "f",
                [Kind::Brace(vec![v("t"), dots(), v("t")], Some(Box::new(sub(v("n"), v("k"))))).into()],
            ),
            "f({t, ..., t}_(n-k))",
            "f({t, …, t}_(n-k))",
            r"f\left( \underbrace{t, \ldots, t}_{n-k} \right)",
            "!an underbrace",
        ),
        (
            call("f", [v("t"), dots(), v("t")]),
            "f(t, ..., t)",
            "f(t, …, t)",
            r"f(t, \ldots, t)",
            "!an ellipsis",
        ),
    ]
}

pub(super) fn operators() -> Vec<Row> {
    let member = || Expr::relation(v("S"), Rel::Subset, v("T"));
    let integral = |lower: Option<Expr>, upper: Option<Expr>, body| {
        Expr::from(Kind::Integral {
            lower: lower.map(Box::new),
            upper: upper.map(Box::new),
            body: Box::new(body),
            variable: Box::new(v("t")),
        })
    };
    vec![
        (
            sum(mul([index(v("c"), [v("i")]), pow(v("t"), v("i"))])),
            "sum(i=0..n, c_i t^i)",
            "sum(i=0..n, cᵢtⁱ)",
            r"\sum_{i=0}^{n} c_i t^i",
            "Sum(c[i]*t**i, (i, 0, n))",
        ),
        (
            mul([sum(v("a")), v("b")]),
            "sum(i=0..n, a) b",
            "sum(i=0..n, a) b",
            r"\left( \sum_{i=0}^{n} a \right) b",
            "Sum(a, (i, 0, n))*b",
        ),
        (
            div(mul([n(2), sum(v("a"))]), v("b")),
            "2 sum(i=0..n, a)/b",
            "2 sum(i=0..n, a)/b",
            r"\left( 2 \sum_{i=0}^{n} a \right)/b",
            "2*Sum(a, (i, 0, n))/b",
        ),
        (
            add([mul([n(2), sum(v("a"))]), v("b")]),
            "2 sum(i=0..n, a) + b",
            "2 sum(i=0..n, a) + b",
            r"2 \sum_{i=0}^{n} a + b",
            "2*Sum(a, (i, 0, n)) + b",
        ),
        (
            sum(add([v("a"), v("b")])),
            "sum(i=0..n, a + b)",
            "sum(i=0..n, a + b)",
            r"\sum_{i=0}^{n} (a + b)",
            "Sum(a + b, (i, 0, n))",
        ),
        (
            big(
                BigOp::Product,
                vec![eq(v("i"), n(0)), Expr::relation(v("i"), Rel::Ne, v("j"))],
                Some(v("n")),
                t(1),
            ),
            "prod(i=0..n, i != j, t1)",
            "prod(i=0..n, i ≠ j, t₁)",
            r"\prod_{\substack{i = 0 \\ i \ne j}}^{n} t_1",
            "!a sum or product that is not over an integer range",
        ),
        (
            big(BigOp::Max, vec![member(), eq(call("size", [v("S")]), v("i"))], None, v("x")),
            "max(S ⊆ T, size(S) = i, x)",
            "max(S ⊆ T, size(S) = i, x)",
            r"\max_{\substack{S \subseteq T \\ \operatorname{size}(S) = i}} x",
            "!a maximum or minimum over a range",
        ),
        (
            big(BigOp::Sum, vec![v("i")], Some(v("n")), v("x")),
            "sum(i; n; x)",
            "sum(i; n; x)",
            r"\sum_{i}^{n} x",
            "!a sum or product that is not over an integer range",
        ),
        (
            big(BigOp::Limit, vec![Expr::relation(v("t"), Rel::To, n(0))], None, call("f", [v("t")])),
            "lim(t -> 0, f(t))",
            "lim(t → 0, f(t))",
            r"\lim_{t \to 0} f(t)",
            "Limit(f(t), t, 0, '+-')",
        ),
        (
            big(BigOp::Union, vec![Expr::relation(v("i"), Rel::In, v("I"))], None, v("A")),
            "union(i in I, A)",
            "union(i ∈ I, A)",
            r"\bigcup_{i \in I} A",
            "!a union or intersection over a range",
        ),
        (
            integral(Some(v("a")), Some(v("b")), add([v("t"), n(1)])),
            "integral(t + 1, t=a..b)",
            "integral(t + 1, t=a..b)",
            r"\int_{a}^{b} (t + 1) \, dt",
            "Integral(t + 1, (t, a, b))",
        ),
        (integral(None, None, v("t")), "integral(t, t)", "integral(t, t)", r"\int t \, dt", "Integral(t, t)"),
        (
            derivative(false, vec![(v("t"), Some(v("k")))], Some(call("f", [v("t")]))),
            "diff(f(t), t, k)",
            "diff(f(t), t, k)",
            r"\frac{d^k}{dt^k} f(t)",
            "Derivative(f(t), (t, k))",
        ),
        (
            derivative(true, vec![(v("u"), Some(n(2))), (v("tau"), None)], Some(v("f"))),
            "diff(diff(f, tau), u, 2)",
            "diff(diff(f, τ), u, 2)",
            r"\frac{\partial^{2+1}}{\partial u^2 \partial\tau} f",
            "Derivative(f, (u, 2), tau)",
        ),
        (
            derivative(false, vec![(v("t"), None)], None),
            "diff(; t)",
            "diff(; t)",
            r"\frac{d}{dt}",
            "!a derivative of nothing",
        ),
        (
            Kind::At { body: Box::new(call("f", [v("t")])), lower: vec![eq(v("t"), n(0))], upper: None }
                .into(),
            "at(f(t), t = 0)",
            "at(f(t), t = 0)",
            r"\left. f(t) \right|_{t=0}",
            "Subs(f(t), t, 0)",
        ),
        (
            Kind::At { body: Box::new(v("F")), lower: vec![v("a")], upper: Some(Box::new(v("b"))) }.into(),
            "at(F, a; b)",
            "at(F, a; b)",
            r"\left[ F \right]_{a}^{b}",
            "!a value at a place of this form",
        ),
        (
            Kind::Range(Box::new(n(0)), Box::new(sub(v("n"), n(1)))).into(),
            "0..n - 1",
            "0..n - 1",
            "0..n - 1",
            "Range(0, n - 1 + 1)",
        ),
        (
            Kind::Lambda(vec![v("t")], Box::new(pow(v("t"), n(2)))).into(),
            "t -> t^2",
            "t ↦ t²",
            r"t \mapsto t^2",
            "Lambda(t, t**2)",
        ),
        (
            Expr::apply(
                Kind::Lambda(vec![v("i"), v("n")], Box::new(div(v("i"), v("n")))).into(),
                vec![n(1), n(2)],
            ),
            "((i, n) -> i/n)(1, 2)",
            "((i, n) ↦ i/n)(1, 2)",
            r"((i, n) \mapsto i/n)(1, 2)",
            "Lambda((i, n), i/n)(1, 2)",
        ),
        (
            Kind::Chain(
                Box::new(v("a")),
                [(Rel::Eq, v("b")), (Rel::Le, v("c"))]
                    .map(|(rel, expr)| Link { rel, span: Default::default(), expr })
                    .into(),
            )
            .into(),
            "a = b <= c",
            "a = b ≤ c",
            r"a = b \le c",
            "And(Eq(a, b), Le(b, c))",
        ),
        (
            Expr::relation(call("F", [v("t")]), Rel::Define, eq(v("a"), v("b"))),
            "F(t) := a = b",
            "F(t) := a = b",
            "F(t) := a = b",
            "Eq(F(t), Eq(a, b))",
        ),
        (eq(eq(v("a"), v("b")), v("c")), "(a = b) = c", "(a = b) = c", "(a = b) = c", "Eq(Eq(a, b), c)"),
        (
            Kind::Sequence(vec![eq(v("i"), n(1)), dots(), v("n")]).into(),
            "i = 1, ..., n",
            "i = 1, …, n",
            r"i = 1, \ldots, n",
            "!an ellipsis",
        ),
        (
            Kind::ForAll(vec![Expr::relation(v("x"), Rel::In, v("P"))], Some(Box::new(eq(v("x"), v("y")))))
                .into(),
            "forall(x in P; x = y)",
            "forall(x ∈ P; x = y)",
            r"\forall x \in P: x = y",
            "!a statement for all values",
        ),
    ]
}

pub(super) fn relations() -> Vec<Row> {
    const SIGNS: [(Rel, &str, &str, &str, &str); 14] = [
        (Rel::Ne, "a != b", "a ≠ b", r"a \ne b", "Ne(a, b)"),
        (Rel::Lt, "a < b", "a < b", "a < b", "Lt(a, b)"),
        (Rel::Gt, "a > b", "a > b", "a > b", "Gt(a, b)"),
        (Rel::Ge, "a >= b", "a ≥ b", r"a \ge b", "Ge(a, b)"),
        (Rel::Equiv, "a ≡ b", "a ≡ b", r"a \equiv b", "!this relation"),
        (Rel::Approx, "a ≈ b", "a ≈ b", r"a \approx b", "!this relation"),
        (Rel::In, "a in b", "a ∈ b", r"a \in b", "Contains(a, b)"),
        (Rel::NotIn, "a ∉ b", "a ∉ b", r"a \notin b", "!this relation"),
        (Rel::Subset, "a ⊆ b", "a ⊆ b", r"a \subseteq b", "!this relation"),
        (Rel::To, "a -> b", "a → b", r"a \to b", "!this relation"),
        (Rel::MapsTo, "a -> b", "a ↦ b", r"a \mapsto b", "!this relation"),
        (Rel::Implies, "a => b", "a ⇒ b", r"a \Rightarrow b", "Implies(a, b)"),
        (Rel::Iff, "a <=> b", "a ⇔ b", r"a \Leftrightarrow b", "Equivalent(a, b)"),
        (Rel::Colon, "a: b", "a: b", r"a \colon b", "!this relation"),
    ];
    SIGNS.map(|(rel, a, b, c, d)| (Expr::relation(v("a"), rel, v("b")), a, b, c, d)).into()
}
