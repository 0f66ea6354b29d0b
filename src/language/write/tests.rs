//! Every kind of node in all four notations, parentheses, KaTeX's opinion, and long input.

mod arithmetic;
mod constructs;
mod trees;

use proptest::prelude::*;
use proptest::strategy::ValueTree;

use self::arithmetic::{Row, arithmetic, names_and_numbers};
use self::constructs::{calls_and_brackets, operators, relations};
use self::trees::*;
use super::*;
use crate::formula::{Expr, Kind, Link, Precedence, Rel};

/// The SymPy form; errors with a `!` before them.
fn sympy_or_error(expr: &Expr) -> String {
    sympy(expr).unwrap_or_else(|problem| match problem {
        WriteError::NotSupported(what) => format!("!{what}"),
        WriteError::Output => "!output".to_owned(),
    })
}

#[track_caller]
fn check(rows: Vec<Row>) {
    for (expr, plain, signs, tex, python) in rows {
        assert_eq!(
            [text(&expr), unicode(&expr), latex(&expr), sympy_or_error(&expr)],
            [plain, signs, tex, python].map(str::to_owned),
            "{expr:?}"
        );
    }
}

#[test]
fn names_and_numbers_print() {
    check(names_and_numbers());
}

#[test]
fn arithmetic_prints() {
    check(arithmetic());
}

#[test]
fn calls_and_brackets_print() {
    check(calls_and_brackets());
}

#[test]
fn operators_print() {
    check(operators());
    check(relations());
}

/// The polar form of t^3 + 3t^2 + 5t + 1, as in the lecture.
#[test]
fn worked_example() {
    let product = |indices: &[i64]| mul(indices.iter().map(|&i| t(i)).collect::<Vec<_>>());
    let pairs = add([product(&[1, 2]), product(&[1, 3]), product(&[2, 3])]).grouped();
    let singles = mul([n(5).over(n(3)), add([t(1), t(2), t(3)]).grouped()]);
    let form = add([product(&[1, 2, 3]), pairs, singles, n(1)]);
    check(vec![(
        form,
        "t1 t2 t3 + (t1 t2 + t1 t3 + t2 t3) + 5/3 (t1 + t2 + t3) + 1",
        "t₁t₂t₃ + (t₁t₂ + t₁t₃ + t₂t₃) + 5/3 (t₁ + t₂ + t₃) + 1",
        r"t_1 t_2 t_3 + (t_1 t_2 + t_1 t_3 + t_2 t_3) + \frac{5}{3} (t_1 + t_2 + t_3) + 1",
        "t1*t2*t3 + (t1*t2 + t1*t3 + t2*t3) + Rational(5, 3)*(t1 + t2 + t3) + 1",
    )]);
}

#[test]
fn chains_in_chains_do_not_explode_in_sympy() {
    let mut chain = v("a");
    for _ in 0..100 {
        let link = |expr| Link { rel: Rel::Eq, span: Default::default(), expr };
        chain = Kind::Chain(Box::new(v("b")), vec![link(chain), link(v("c"))]).into();
    }
    assert_eq!(sympy(&chain), Err(WriteError::NotSupported("a chain of relations inside another")));
}

#[test]
fn long_sums_are_linear() {
    let terms: Vec<Expr> = (0..20_000).map(|i| mul([n(i), t(i), t(i + 1)])).collect();
    let sum = add(terms);
    for output in [text(&sum), unicode(&sum), latex(&sum), sympy(&sum).unwrap()] {
        assert!(output.len() > 200_000 && output.len() < 1_200_000);
    }
}

#[test]
fn deep_trees_need_no_stack() {
    let mut tree = v("t");
    for i in 0..200_000 {
        tree = if i % 2 == 0 { tree.negated() } else { tree.grouped() };
    }
    let lengths = [text(&tree), unicode(&tree), latex(&tree), sympy(&tree).unwrap()].map(|s| s.len());
    assert_eq!(lengths, [300_001; 4]);
    // Dropping a tree recurses, so this one is taken apart by hand.
    while let Some(inner) = match tree.kind {
        Kind::Add(mut terms) => terms.pop().map(|term| term.expr),
        Kind::Group(inner) => Some(*inner),
        _ => None,
    } {
        tree = inner;
    }
}

#[test]
fn streams_stop_at_the_first_error() {
    struct Full;
    impl std::fmt::Write for Full {
        fn write_str(&mut self, _: &str) -> std::fmt::Result {
            Err(std::fmt::Error)
        }
    }
    let tree = add([v("a"), v("b")]);
    assert!(write_text(&mut Full, &tree).is_err());
    assert!(write_latex(&mut Full, &tree).is_err());
    assert_eq!(write_sympy(&mut Full, &tree), Err(WriteError::Output));
}

/// What KaTeX says about a formula.
fn katex_accepts(tex: &str, options: &katex::Opts) -> Result<(), String> {
    katex::render_with_opts(tex, options).map(drop).map_err(|problem| format!("{tex}\n{problem}"))
}

/// One test for all formulas: the JavaScript engine takes a while to start.
#[test]
fn katex_accepts_all() {
    let options =
        katex::Opts::builder().display_mode(true).throw_on_error(true).build().expect("fixed options");
    assert!(katex_accepts(r"\frac{1", &options).is_err());
    let unread = |expr: &Expr| matches!(expr.kind, Kind::Unread(_));
    let tables = [names_and_numbers(), arithmetic(), calls_and_brackets(), operators(), relations()];
    for (expr, ..) in tables.into_iter().flatten().filter(|row| !unread(&row.0)) {
        assert_eq!(katex_accepts(&latex(&expr), &options), Ok(()));
    }
    for words in ["a_b^c", r"50% of {x} & \y ~ #1 $", "é"] {
        assert_eq!(katex_accepts(&latex(&Kind::Text(words.into()).into()), &options), Ok(()));
        assert_eq!(katex_accepts(&latex(&v(words)), &options), Ok(()));
    }
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    for _ in 0..60 {
        let tree = formula().new_tree(&mut runner).expect("the strategy makes trees").current();
        assert_eq!(katex_accepts(&latex(&tree), &options), Ok(()));
    }
}

proptest! {
    /// Brackets are balanced, nothing blows up, and streaming gives the same as the string.
    #[test]
    fn any_formula_prints(expr in formula()) {
        for output in [text(&expr), latex(&expr)] {
            let depth = output.chars().try_fold(0_i32, |depth, c| match c {
                '(' | '[' | '{' => Some(depth + 1),
                ')' | ']' | '}' => Some(depth - 1).filter(|&depth| depth >= 0),
                _ => Some(depth),
            });
            prop_assert_eq!(depth, Some(0), "{}", output);
        }
        let _ = sympy(&expr);
    }

    /// In parentheses, a formula prints the same inside, wherever it stands.
    #[test]
    fn groups_stay(expr in formula()) {
        let inside = text(&expr);
        prop_assert_eq!(text(&expr.clone().grouped()), format!("({inside})"));
        let product = mul([v("a"), expr.clone()]);
        let needs = super::plain::level(&expr) < Precedence::Compose;
        prop_assert_eq!(text(&product).contains(&format!("a ({inside})")) || !needs, true);
    }
}
