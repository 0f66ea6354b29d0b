//! What holds for every text: no panic, sensible spans, and the two readers agree.

use proptest::prelude::*;

use super::sexpr::sexpr;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::latex::{commands, environments, read, read_rows, read_tolerant};

/// Formulas to cut pieces from.
const SAMPLES: &[&str] = &[
    r"f(\underbrace{t,\ldots,t}_{n-k},\underbrace{\hat 1,\dots,\hat 1}_k) = \frac{(n-k)!}{n!} F^{(k)}(t)",
    r"\frac{\sum_\limits{S\subseteq\{1,\dots,n\},|S|=i} \prod_\limits{j\in S}t_j}{C_n^i}",
    r"\begin{aligned} A_2&\triangleq\left(\begin{matrix}1&0\\-2&2\\\end{matrix}\right)\\ \pmb{f}(t)&=A_2 t\\\end{aligned}\\",
    r"\left. \frac { \partial } { \partial u } f ( u , v ) \right| _ { u = 0 } = d \sum _ { j = 0 } ^ { d } B _ { j } ^ { ( d ) } ( v )",
    r"N_{i}^1(t) = \begin{cases} 1,\ if \ i \le t \lt i+1 \\ 0,\ otherwise \end{cases}",
    r"\int_a^b f(x)\,dx, \quad \forall x \in [a,b), ||x|| \ge |a|",
    r"{n-1 \choose i} t^i (1-t)^{n-i-1} \bigg|_{t=0} \text{ with } \sqrt[3]{x} \stackrel{\text{def}}{=} y'",
    "∑ᵢ aᵢ = 1 其中 t³ ≤ σ₁₂(τ)，∀x∈ℝ",
];

/// Short formulas as they stand in lecture notes on curves and surfaces.
const NOTES: &[&str] = &[
    r"\hat{1}=1-0,\hat{\pmb{1}}=[1,\dots,1]^\top-\pmb{0}",
    r"f(0^{n-i}1^i) = b_i \text{ for } i = 0, \dots, n",
    r"\{\vec{x}_i = x_i - x_1\}_2^k",
    r"\sum a_i x_i, a_i \in \mathbb{R}",
    r"F ( \pmb{x} ) = \sum _ { i + j + k = d\\i,j,k\ge0 } \frac { d ! } { i ! j ! k ! } \alpha ^ { i } \beta ^ { j } \gamma ^ { k }",
    r"\pmb{n}(u,v)=\text{normalize}\left(\frac{\part \pmb{f}}{\part u} \times \frac{\part \pmb{f}}{\part v}\right)",
    r"k_2(A) = \frac {\max_{x \neq 0} \frac {||Ax||} {||x||}} {\min_{x \neq 0} \frac {||Ax||} {||x||}}",
    r"M(x)=EIk(x)=EI \frac {y''(x)} {(1+(y'(x))^2)^\frac 3 2}",
    r"t_{i+1} - t_i = \sqrt {|| k_{i+1} - k_i||}",
    r"L=span\{f_1, f_2, \cdots, f_n\} = \{\sum_{i=1}^n a_i f_i(x) | a_i \in R \}",
    r"C(S_0, T) = \lim_{k \to \inf} S_k",
    r"P_n(t) = (1 - t)P_{n-1}(b_0, ..., b_{n-1}; t) + tP_{n-1}(b_1, ..., b_n; t)",
    r"\frac{i!}{n!}(-D)^{n-i}\prod_{1}^{n}(t_i-\tau)",
    r"\alpha = \frac { \operatorname { area } \left( \Delta \left( p _ { 2 } , p _ { 3 } , p \right) \right) } { 2 } ,",
    r"e^{-\frac {(x-\mu)^2} {2 \sigma^2}} = e^{\frac 1 2 (\frac 1 a x - \frac \mu \sigma)^2}",
    r"\phi(t)(a \le t \le b) \in GC^n[a, b]",
    r"b_i(t):[t_0,t_1]\to \mathbb{R}^d",
    r"\begin{cases} x = x(t) \\ y = y(t) \end{cases} \ \ t \in [0, 1]",
];

/// Pieces of formulas, whole tokens.
fn soup() -> impl Strategy<Value = String> {
    let mut pieces: Vec<String> = commands().iter().map(|command| format!("\\{} ", command.name())).collect();
    for (name, _) in environments() {
        pieces.push(format!("\\begin{{{name}}}"));
        pieces.push(format!("\\end{{{name}}}"));
    }
    let plain = [
        "{",
        "}",
        "(",
        ")",
        "[",
        "]",
        "|",
        "||",
        "_",
        "^",
        "'",
        "+",
        "-",
        "*",
        "/",
        "=",
        "<",
        ">",
        ",",
        ";",
        ".",
        "...",
        ":",
        "!",
        "&",
        "$",
        "~",
        "%",
        "\\\\",
        "\\{",
        "\\}",
        "1",
        "0.5",
        "12",
        "a",
        "d",
        "t",
        "C",
        " ",
        "α",
        "²",
        "₁",
        "≤",
        "次",
        "\\left(",
        "\\right)",
        "\\left.",
        "\\right|",
        "{d}",
        "_{i=0}",
        "^{n}",
        "{a}",
        "{b}",
        "\\left\\{",
        "if",
        "or",
        "<=",
        "{{",
        "}}",
    ];
    // plain pieces as often as commands
    for _ in 0..4 {
        pieces.extend(plain.iter().map(|&piece| piece.to_owned()));
    }
    prop::collection::vec(prop::sample::select(pieces), 0..30).prop_map(|list| list.concat())
}

/// A slice of a sample, perhaps with another one behind it.
fn slices() -> impl Strategy<Value = String> {
    let slice = (0..SAMPLES.len(), any::<prop::sample::Index>(), any::<prop::sample::Index>()).prop_map(
        |(number, a, b)| {
            let sample = SAMPLES[number];
            let cuts: Vec<usize> = sample.char_indices().map(|(at, _)| at).chain([sample.len()]).collect();
            let (a, b) = (cuts[a.index(cuts.len())], cuts[b.index(cuts.len())]);
            sample[a.min(b)..a.max(b)].to_owned()
        },
    );
    prop::collection::vec(slice, 1..3).prop_map(|list| list.concat())
}

fn check_spans(expr: &Expr, outer: Span, text: &str) {
    let span = expr.span;
    assert!(
        outer.start <= span.start && span.end <= outer.end,
        "{span:?} in {outer:?}: {text:?} {}",
        sexpr(expr)
    );
    let slice = text.get(span.range());
    assert!(slice.is_some(), "{span:?} is no part of {text:?}");
    if let Kind::Unread(unread) = &expr.kind {
        assert_eq!(Some(unread.as_str()), slice);
    }
    if let Kind::Chain(_, links) = &expr.kind {
        for link in links {
            assert!(span.start <= link.span.start && link.span.end <= span.end, "{text:?}");
        }
    }
    expr.for_each_child(&mut |child| check_spans(child, span, text));
}

fn check(text: &str) {
    let whole = Span::new(0, text.len());
    let strict = read(text);
    let (tolerant, problems) = read_tolerant(text);
    check_spans(&tolerant, whole, text);
    match &strict {
        Ok(expr) => {
            check_spans(expr, whole, text);
            assert!(problems.is_empty(), "{text:?}: {problems:?}");
            assert!(expr.same_as(&tolerant), "{text:?}: {} or {}", sexpr(expr), sexpr(&tolerant));
        }
        Err(problem) => {
            assert!(!problems.is_empty(), "{text:?}: {problem:?}, but {}", sexpr(&tolerant));
            let span = problem.span.expect("every problem has a place");
            assert!(text.get(span.range()).is_some(), "{span:?} is no part of {text:?}");
        }
    }
    for row in read_rows(text) {
        assert!(text.get(row.span.range()).is_some());
        check_spans(&row.expr, whole, text);
    }
}

#[test]
fn samples_are_read() {
    for text in SAMPLES.iter().chain(NOTES) {
        check(text);
        assert!(read(text).is_ok(), "{text}: {:?}", read(text));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn any_text(text in "\\PC{0,60}") {
        check(&text);
    }

    #[test]
    fn any_ascii(text in "[ -~\\n]{0,60}") {
        check(&text);
    }

    #[test]
    fn any_tokens(text in soup()) {
        check(&text);
    }

    #[test]
    fn any_slices(text in slices()) {
        check(&text);
    }
}

#[test]
fn what_a_sized_bracket_opens_begins_with_its_size() {
    for text in [
        r"x = \Bigl(1 - t\Bigr)",
        r"x = \bigl|1 + t\bigr| + 2",
        r"x = \big\Big [1, t\big]",
        r"x = \Bigl\lfloor t\Bigr\rfloor",
    ] {
        let Kind::Chain(_, links) = read(text).unwrap().kind else { panic!("{text}") };
        assert_eq!(&text[links[0].expr.span.range()], &text[4..], "{text}");
    }
    // A size by itself belongs to nothing.
    let Kind::Chain(_, links) = read(r"x = \big 2 (t)").unwrap().kind else { panic!() };
    assert_eq!(links[0].expr.span.start, r"x = \big ".len());
}
