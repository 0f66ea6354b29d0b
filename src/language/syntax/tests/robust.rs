//! Limits, and texts that nobody would write on purpose.

use proptest::prelude::*;

use super::*;

fn code(text: &str) -> Code {
    parse(text).map(|_| "a formula").expect_err("too much").code
}

#[test]
fn depth_is_limited() {
    for (open, middle, close) in [
        ("(", "t", ")"),
        ("f(", "t", ")"),
        ("[", "t", "]"),
        ("x_{", "t", "}"),
        ("x^{", "t", "}"),
        ("a=b+c*d^(", "t", ")"),
        ("sum(i=0..-(", "t", "),i)"),
        ("(a)((", "t", "))"),
        ("x^{(", "t", ")}"),
        ("cases(x if ", "y", ")"),
    ] {
        let deep = |n: usize| format!("{}{middle}{}", open.repeat(n), close.repeat(n));
        assert!(parse(&deep(50)).is_ok(), "{open}");
        assert_eq!(code(&deep(10_000)), Code::TooDeep, "{open}");
        assert_eq!(code(&open.repeat(20_000)), Code::TooDeep, "{open}");
        // The deepest one that is read can also be walked, copied and dropped.
        let depths: Vec<usize> = (1..=MAX_DEPTH).collect();
        let most = depths.partition_point(|&n| parse(&deep(n)).is_ok());
        let deepest = parse(&deep(most)).expect("depth 50 works");
        assert!(deepest.same_as(&deepest.clone()), "{open}");
    }
    assert!(parse(&("(".repeat(MAX_DEPTH) + "t" + &")".repeat(MAX_DEPTH))).is_ok());
    let place = parse(&"(".repeat(10_000)).expect_err("too deep").span;
    assert_eq!(place, Some(Span::new(MAX_DEPTH, MAX_DEPTH + 1)));
    for chain in ["1/", "2^", "-", "t->"] {
        assert_eq!(code(&(chain.repeat(20_000) + "t")), Code::TooDeep, "{chain}");
    }
    assert_eq!(code(&("f".to_owned() + &"(t)".repeat(20_000))), Code::TooDeep);
    assert_eq!(code(&("f".to_owned() + &"!'".repeat(20_000))), Code::TooDeep);
    assert_eq!(code(&("t".to_owned() + &"²".repeat(3) + &"^2".repeat(20_000))), Code::TooDeep);
}

#[test]
fn long_formulas_stay_flat() {
    for (operator, count) in
        [("+", 100_000), ("-", 1000), (" ", 1000), ("*", 1000), ("=", 1000), ("∘", 1000), (", ", 1000)]
    {
        let text = vec!["t"; count].join(operator);
        let expr = parse(&text).expect("a long formula");
        assert_eq!(expr.span, Span::new(0, text.len()));
        let mut children = 0;
        expr.for_each_child(&mut |_| children += 1);
        assert_eq!(children, count, "{operator}");
    }
}

#[test]
fn size_is_limited() {
    assert_eq!(code(&"1".repeat(MAX_DIGITS + 1)), Code::TooLong);
    assert_eq!(code(&vec!["1".repeat(MAX_DIGITS / 1000); 1001].join("+")), Code::TooLong);
    let digits = "7".repeat(2000);
    let Kind::Number(value) = parse(&digits).unwrap().kind else { panic!("a number") };
    assert_eq!(value.to_string(), digits);
    let error = lexer::lex(&"+".repeat(MAX_TOKENS + 1)).expect_err("too many tokens");
    assert_eq!(error.code, Code::TooLong);
}

const PIECES: &[&str] = &[
    "t",
    "t1",
    "f",
    "F(t)",
    "B_i^n",
    "alpha",
    "σ",
    r"\sigma",
    "2",
    "0.5",
    "1.2.3",
    "+",
    "-",
    "*",
    "/",
    "^",
    "!",
    "_",
    "'",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ";",
    ":=",
    "=",
    "<=",
    "!=",
    "->",
    "..",
    "...",
    "∘",
    "²",
    "⁽²⁾",
    "₁",
    "⁻",
    " ",
    " ",
    "\n",
    "#",
    "|",
    "in",
    "if ",
    "otherwise",
    "cases(",
    "sum(i=0..n,",
    "integral(",
    "hat(",
    "binomial(",
    "^{(",
    "\"",
    "$",
    "̂",
    "é",
    "（",
    "\\",
    r"\frac",
    "\u{0}",
    "⌊",
    "⌋",
    "1e5",
    "ℝ",
    "∞",
    "…",
    "，",
];

fn check_any(text: &str) {
    for result in parse_program(text).into_iter().chain([parse(text)]) {
        match result {
            Ok(expr) => {
                assert_spans(&expr, text);
                show(&expr);
            }
            Err(problem) => {
                let file = SourceFile::new("<test>", text);
                let span = problem.span.expect("every problem has a place");
                assert!(text.get(span.range()).is_some(), "{span:?} in {text:?}");
                assert!(problem.labels.iter().all(|label| text.get(label.span.range()).is_some()));
                render(&problem, &file, false);
            }
        }
    }
    for span in statements(text).expect("short texts have statements") {
        assert!(text.get(span.range()).is_some());
    }
    is_incomplete(text);
    looks_like_latex(text);
}

proptest! {
    #[test]
    fn any_string_is_harmless(text in any::<String>()) {
        check_any(&text);
    }

    #[test]
    fn any_mixture_is_harmless(pieces in prop::collection::vec(prop::sample::select(PIECES), 0..24)) {
        check_any(&pieces.concat());
    }

    #[test]
    fn any_mutation_is_harmless(
        formula in prop::sample::select(&[
            "F(t) := t^3 + 3t^2 + 5t + 1", "f(u1,u2; v1) = 1/2 (u1 v1 + u2 v1)",
            "cases(1 if i = 0, t^{(2)} otherwise)", "sum(i=0..n, binomial(n,i) t^i (1-t)^(n-i))",
            "[1, 2; 3, 4] hat(v)_{i,j}!", "{x | x > 0} ⊆ (t₁, t²)",
        ][..]),
        at in any::<prop::sample::Index>(),
        piece in prop::sample::select(PIECES),
        remove in 0_usize..3,
    ) {
        let letters: Vec<char> = formula.chars().collect();
        let at = at.index(letters.len());
        let mut text: String = letters[..at].iter().collect();
        text.push_str(piece);
        text.extend(letters[(at + remove).min(letters.len())..].iter());
        check_any(&text);
    }

    #[test]
    fn layout_does_not_matter(names in prop::collection::vec("[a-z]{1,3}", 1..8), blanks in "[ \t]{1,3}") {
        // These are no names, or none where another name follows.
        let words = ["and", "for", "in", "if", "hat", "bar", "vec", "dot", "mod"];
        prop_assume!(names.iter().all(|name| !words.contains(&name.as_str()) && parse(name).is_ok()));
        let plain = names.join(" ");
        let wide = names.join(&blanks);
        prop_assert!(parse(&plain).unwrap().same_as(&parse(&wide).unwrap()));
        let stars = names.join("*");
        prop_assert!(parse(&plain).unwrap().same_as(&parse(&stars).unwrap()));
    }
}
