//! Rows of displays, and reading that passes over what it cannot read.

use super::sexpr::sexpr;
use crate::formula::Rel;
use crate::language::latex::{Row, read_rows, read_tolerant};

/// Each row in one line: its leading relation, its tree, the number of its problems.
fn lines(text: &str) -> Vec<String> {
    let line = |row: Row| {
        let leading = row.leading.map(|(rel, _)| format!("{rel:?} ")).unwrap_or_default();
        format!("{leading}{} {}", sexpr(&row.expr), row.problems.len())
    };
    read_rows(text).into_iter().map(line).collect()
}

#[test]
fn rows_of_a_display() {
    let text =
        "$$\\begin{aligned}\nA &\\triangleq 1\\\\\n\nF(t) &= t \\\\ &\\le 2,\\\\\n\\end{aligned}\\\\$$";
    assert_eq!(lines(text), ["(A := 1) 0", "((F: t) = t) 0", "Le 2 0"]);
    let rows = read_rows(text);
    assert_eq!(&text[rows[0].span.range()], r"A &\triangleq 1");
    assert_eq!(&text[rows[2].span.range()], r"\le 2,");
    let (rel, place) = rows[2].leading.expect("the row begins with a relation");
    assert_eq!((rel, &text[place.range()]), (Rel::Le, r"\le"));
    assert!(rows[1].leading.is_none());
}

#[test]
fn kinds_of_displays() {
    assert_eq!(lines(r"a = b \\ c = d"), ["(a = b) 0", "(c = d) 0"]);
    assert_eq!(lines("= a + b"), ["Eq (+ a b) 0"]);
    assert_eq!(lines(r": a = b"), ["(a = b) 0"]);
    assert_eq!(lines(r"\begin{array}{l} { x = 1 } \\ { = y } \end{array}"), ["(x = 1) 0", "Eq y 0"]);
    assert_eq!(
        lines(r"\begin{cases} x = 1 \\ y = 2, n = 0 \end{cases}"),
        ["(x = 1) 0", "(seq (y = 2) (n = 0)) 0"]
    );
    assert_eq!(
        lines(r"\left\{\begin{array}{l} x = 1 \\ y = 2 \end{array}\right."),
        ["(x = 1) 0", "(y = 2) 0"]
    );
    assert_eq!(lines(r"\begin{array}{cc} a & b \\ c & d \end{array}"), ["(matrix a b / c d) 0"]);
    assert_eq!(lines(r"\begin{equation} \begin{split} a &= b \end{split} \end{equation}"), ["(a = b) 0"]);
    assert_eq!(
        lines(r"a = [b \\ + c] \\ - d \\ - e = f"),
        ["(a = (+ [(+ b c)] (- d))) 0", "((+ (- e)) = f) 0"]
    );
    assert_eq!(lines(r"a \stackrel{\text{def}}{=} b \\ \stackrel{1}{=} c"), ["(a := b) 0", "Eq c 0"]);
    assert_eq!(lines(""), [""; 0]);
}

#[test]
fn one_bad_row_does_not_spoil_the_others() {
    assert_eq!(
        lines(r"a = 1 \\ b = \foo{2} \\ c = 3"),
        ["(a = 1) 0", r#"(b = <unread "\\foo{2}">) 1"#, "(c = 3) 0"]
    );
    assert_eq!(lines(r"a = ( 1 \\ b = 2"), [r#"(a = <unread "( 1">) 1"#, "(b = 2) 0"]);
    assert_eq!(
        lines(r"\begin{aligned} a = 1 \\ b = \frac{2 \\ c = 3"),
        [r#"(<unread "\\begin{aligned} a"> = 1) 1"#, r#"(b = <unread "\\frac{2">) 1"#, "(c = 3) 0"]
    );
    assert_eq!(lines(r"a = \\ b = 2"), ["(a = b = 2) 0"]);
}

#[test]
fn pieces_that_cannot_be_read() {
    let check = |text: &str, tree: &str, count: usize| {
        let (expr, problems) = read_tolerant(text);
        assert_eq!((sexpr(&expr).as_str(), problems.len()), (tree, count), "{text}: {problems:?}");
    };
    check(r"a = \foo = c", r#"(a = <unread "\\foo"> = c)"#, 1);
    check(r"a = b + * c \le d, e = f", r#"(seq (a = <unread "b + * c"> ≤ d) (e = f))"#, 1);
    check(r"a = |b, c = d", r#"(seq (a = <unread "|b">) (c = d))"#, 1);
    check(r"\exists a, b", r#"(seq <unread "\\exists a"> b)"#, 1);
    check(r"a ) b = c", r#"(<unread "a ) b"> = c)"#, 1);
    check(r"a = \text{so} \quad b = \exists", r#"(seq (a = "so") (b = <unread "\\exists">))"#, 1);
    check(r"= \exists", r#"(<unread ""> = <unread "\\exists">)"#, 2);
    check(r"f(\foo, t) = t", r#"(<unread "f(\\foo, t)"> = t)"#, 1);
    check("", r#"<unread "">"#, 1);
    check("a = b", "(a = b)", 0);
}
