//! Formulas that cannot be read: which problem, and where.

use crate::language::diagnostic::Code;
use crate::language::latex::read;

/// The problem's code, the text it points at, and its hint.
#[track_caller]
fn check(text: &str, code: Code, place: &str, hint: &str) {
    let problem = read(text).expect_err(text);
    assert_eq!(problem.code, code, "{text}: {problem:?}");
    let span = problem.span.expect("every problem has a place");
    assert_eq!(&text[span.range()], place, "{text}: {problem:?}");
    let hints = problem.hints.join("; ");
    assert!(hints.contains(hint), "{text}: {hints:?}");
}

#[test]
fn unknown_and_unsupported() {
    check(r"\farc{1}{2}", Code::UnknownCommand, r"\farc", r"did you mean \frac?");
    check(r"a + \cdotb", Code::UnknownCommand, r"\cdotb", r"did you mean \cdot b?");
    check(r"\xyzzy", Code::UnknownCommand, r"\xyzzy", "docs/latex.md");
    check(r"\exists x", Code::UnsupportedLatex, r"\exists", "");
    check(r"\oint f(t)\,dt", Code::UnsupportedLatex, r"\oint", r"\oint_D");
    check(r"x \not\approx 1", Code::UnsupportedLatex, r"\not", "");
    check(r"\int f(t)", Code::UnsupportedLatex, r"\int", r"\,dt");
    check(r"\begin{algned} a \end{algned}", Code::UnknownCommand, r"\begin{algned}", "aligned");
    check(r"\overset{a}{b}", Code::UnsupportedLatex, r"\overset", "");
}

#[test]
fn unbalanced() {
    check("(a + b", Code::Unbalanced, "(", "closing");
    check("a + b)", Code::Unbalanced, ")", "opening");
    check(r"\frac{a", Code::Unbalanced, "{", "'}'");
    check("a}", Code::Unbalanced, "}", "");
    check(r"\left( a", Code::Unbalanced, r"\left(", r"\right.");
    check(r"a \right)", Code::Unbalanced, r"\right)", "");
    check(r"\begin{matrix} a", Code::Unbalanced, r"\begin{matrix}", r"\end");
    check(r"\begin{matrix} a \end{pmatrix}", Code::Unbalanced, r"\begin{matrix}", "same name");
    check("|a", Code::Unbalanced, "|", "bar");
    check("[a, b, c)", Code::Unbalanced, "[", "");
    check(r"\{ a )", Code::Unbalanced, r"\{", "");
    check(r"\text{abc", Code::Unbalanced, r"\text{", "}");
}

#[test]
fn missing_parts() {
    check("", Code::Empty, "", "");
    check("$$ $$", Code::Empty, "", "");
    check("a +", Code::UnexpectedEnd, "+", "");
    check("a =", Code::UnexpectedEnd, "=", "");
    check(r"\sum_{i=0}^n", Code::UnexpectedEnd, r"\sum", "");
    check(r"\frac{1}", Code::UnexpectedEnd, "}", "");
    check(r"\frac{}{2}", Code::UnexpectedEnd, "{}", "");
    check("= b", Code::UnexpectedToken, "=", "");
    check("f(a,,b)", Code::UnexpectedToken, ",", "");
    check("f(a,)", Code::UnexpectedEnd, ",", "");
    check("a * / b", Code::UnexpectedToken, "/", "");
    check("^2", Code::UnexpectedToken, "^", "");
    check("x^2^3", Code::UnexpectedToken, "^", "braces");
    check("x^10", Code::AmbiguousProduct, "10", "^{10}");
    check("x_12 + 1", Code::AmbiguousProduct, "12", "_1 2");
    check("x_1_2", Code::UnexpectedToken, "_", "braces");
    check(r"a \over b \over c", Code::UnexpectedToken, r"\over", "");
    check("a # b", Code::UnexpectedCharacter, "#", "");
    check("a$ and $b", Code::UnexpectedCharacter, "$", "");
    check("1.2.3", Code::BadNumber, "1.2.3", "");
}

#[test]
fn limits() {
    let nested = |count: usize| format!("{}a{}", "(".repeat(count), ")".repeat(count));
    assert!(read(&nested(120)).is_ok());
    for deep in [nested(300), nested(100_000), "{".repeat(100_000), r"\frac".repeat(50_000)] {
        let problem = read(&deep).expect_err("too deep");
        assert!(matches!(problem.code, Code::TooDeep | Code::Unbalanced), "{problem:?}");
    }
    for deep in [
        "-".repeat(10_000),
        r"\sum".repeat(10_000),
        r"\hat".repeat(10_000),
        "|".repeat(9_999),
        vec!["a"; 10_000].join("/"),
        format!("a{}", "^{a".repeat(5_000) + &"}".repeat(5_000)),
        r"\sin".repeat(10_000),
        r"\bf ".repeat(10_000),
        r"\int a".repeat(10_000),
        r"\forall x:".repeat(10_000),
        r"\begin{matrix}".repeat(5_000) + &r"\end{matrix}".repeat(5_000),
        r"a \circ b \times ".repeat(5_000) + "c",
        r"\frac{d}{dt}".repeat(5_000),
        "a|_b".repeat(5_000),
    ] {
        let problem = read(&deep).expect_err("too deep");
        let head: String = deep.chars().take(20).collect();
        assert!(
            matches!(problem.code, Code::TooDeep | Code::UnsupportedLatex),
            "{head}: {:?}",
            problem.message
        );
    }
    assert_eq!(read(&"1".repeat(3_000_000)).expect_err("digits").code, Code::TooManyDigits);
    assert_eq!(read(&"a".repeat(5_000_000)).expect_err("long").code, Code::TooLong);
}

#[test]
fn long_formulas_are_read() {
    let terms: Vec<String> = (0..20_000).map(|i| format!("c_{{{i}}}t^{{{i}}}")).collect();
    assert!(read(&terms.join("+")).is_ok());
    assert!(read(&vec!["a"; 20_000].join("=")).is_ok());
    assert!(read(&vec!["a"; 20_000].join(",")).is_ok());
    assert!(read(&vec!["a = b"; 20_000].join(r"\\")).is_ok());
    assert!(read(&vec!["f(t)(a)"; 20_000].join(r"\quad ")).is_ok());
}

/// Each of these has two readings; neither is taken.
#[test]
fn numbers_with_two_readings() {
    for text in [
        r"3\tfrac12 = 3.5",
        r"3 \tfrac12",
        r"2\,\frac{3}{4} = x",
        r"2 \times 3\frac12 = 7",
        r"3\frac12 \times 2 = 7",
        r"\frac1{10} = 0,1",
        r"x = 2,5.",
        r"x = 2,5, \quad y = 3",
        r"12\,34 = 1234",
        r"2,5 = \frac52",
        r"\frac12 = 0,5",
        r"x = -1,25",
        "B\u{e9}zier(n, t) = 3",
        "\u{e9}(t) = 3",
    ] {
        let problem = crate::language::latex::read(text).expect_err(text);
        assert!(!problem.hints.is_empty(), "{text}: {problem:?}");
    }
    for text in [
        r"3\frac32",
        r"3\left(\frac12\right)",
        r"t^2\frac12",
        r"\sqrt3\frac12",
        r"t^2\,3",
        r"\frac12\,3",
        r"1\,024 = 2^{10}",
        r"10~000",
        r"0{,}5 = \frac12",
        r"10\,000",
        r"f(0,5) = 1",
        "i = 0,1",
        r"\sum_{i=0,1} t^i",
        r"0,2,\frac12",
        r"x \in 0, 2, \, \ldots, n",
        "i = 0,1,\\dots,n",
        r"x = 2, y = 3",
        "i = 1,3,5",
    ] {
        assert!(crate::language::latex::read(text).is_ok(), "{text}");
    }
}

#[test]
fn upper_indices_in_brackets_and_bold_letters() {
    let read = |text: &str| crate::language::latex::read(text).expect(text);
    assert!(read("c_1^{[0]}").same_as(&read("c_1^{(0)}")));
    assert!(read(r"\textbf{Q}_i").same_as(&read(r"\mathbf{Q}_i")));
}

#[test]
fn what_stands_above_nothing_is_missing() {
    for text in [r"\underset a", r"\underset{a}", r"(\underset a)"] {
        assert!(crate::language::latex::read(text).is_err(), "{text}");
    }
}

#[test]
fn groups_without_arguments_stand_in_their_brackets() {
    let read = crate::language::latex::read("0(;)").expect("a product");
    let mut inside = true;
    read.for_each_child(&mut |child| {
        inside &= read.span.start <= child.span.start && child.span.end <= read.span.end
    });
    read.for_each_child(&mut |child| {
        child.for_each_child(&mut |group| {
            inside &= child.span.start <= group.span.start && group.span.end <= child.span.end
        });
    });
    assert!(inside);
}
