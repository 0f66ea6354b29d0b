//! What is printed reads back: to the same formula, and to the same value.

use std::time::Duration;

use crate::common::expressions::{any_polar, number, shared, statement, univariate, value};
use polarform::budget::Limits;
use polarform::eval::{Equals, Outcome};
use polarform::expr::{Expr, Kind};
use polarform::poly::Symbol;
use polarform::session::Session;
use polarform::syntax::parse;
use polarform::value::{Claim, Notation, PolarKind, Value, Verdict};
use polarform::write::{Format, latex, text, unicode, write_expr};
use proptest::prelude::*;

fn cases(count: u32) -> ProptestConfig {
    ProptestConfig { cases: count, failure_persistence: None, ..ProptestConfig::default() }
}

/// A session that knows the functions of the random formulas.
fn session() -> Session {
    let limits =
        Limits { time: Some(Duration::from_millis(500)), terms: 20_000, bits: 20_000, ..Limits::default() };
    let mut session = Session::new(limits);
    for definition in ["F(t) := t^2 + 2t", "G(t) := t^3 + 1", "f := polar(F)"] {
        session.run(definition).expect("the definitions are right");
    }
    session
}

/// The outcome, or the code of what is wrong with it.
fn evaluated(session: &mut Session, expr: &Expr) -> Result<Value, String> {
    let outcome: Result<Outcome, _> = session.evaluate(&mut expr.clone(), Equals::Claims);
    outcome.map(|outcome| outcome.value).map_err(|problem| problem.code.id().to_owned())
}

/// The formula printed in every notation that can be read, and what was read.
fn readings(expr: &Expr) -> Result<Vec<(String, Expr)>, TestCaseError> {
    let mut printed = vec![(text(expr), parse as fn(&str) -> _)];
    // Matrices in Unicode stand on several lines, for the eye only.
    if !holds(expr, &|kind| matches!(kind, Kind::Matrix(..))) {
        printed.push((unicode(expr), parse));
    }
    // LaTeX cannot tell a list of one item from a formula in square brackets.
    if !holds(expr, &|kind| matches!(kind, Kind::List(items) if items.len() == 1)) {
        printed.push((latex(expr), polarform::latex::read));
    }
    let all = printed.into_iter().map(|(printed, read)| (read(&printed), printed));
    all.map(|(read, printed)| match read {
        Ok(read) => Ok((printed, read)),
        Err(problem) => Err(TestCaseError::fail(format!("{printed}: {problem:?}"))),
    })
    .collect()
}

fn holds(expr: &Expr, wanted: &dyn Fn(&Kind) -> bool) -> bool {
    let mut found = wanted(&expr.kind);
    expr.for_each_child(&mut |child| found |= holds(child, wanted));
    found
}

/// Claims without the words about them.
fn essence(value: &Value) -> Value {
    match value {
        Value::Claim(claim) => Value::Text(claim.verdict().word().to_owned()),
        other => other.clone(),
    }
}

proptest! {
    #![proptest_config(cases(300))]

    /// Formulas: reading what was printed and printing it again changes nothing.
    #[test]
    fn formulas_are_stable(expr in statement()) {
        let printed = text(&expr);
        let read = parse(&printed).map_err(|p| TestCaseError::fail(format!("{printed}: {p:?}")))?;
        prop_assert_eq!(text(&read), printed.clone());
        let again = parse(&text(&read)).expect("it was read before");
        prop_assert!(again.same_as(&read), "{}", printed);
        let marks = unicode(&expr);
        let read = parse(&marks).map_err(|p| TestCaseError::fail(format!("{marks}: {p:?}")))?;
        prop_assert_eq!(unicode(&read), marks);
    }

    /// Formulas: what is printed means the same.
    #[test]
    fn formulas_keep_their_meaning(expr in statement()) {
        let mut session = session();
        let right = evaluated(&mut session, &expr);
        // What passes the limits passes them in another shape a little sooner or later.
        prop_assume!(!matches!(&right, Err(code) if code.starts_with("E4")));
        for (printed, read) in readings(&expr)? {
            let found = evaluated(&mut session, &read);
            let same = match (&right, &found) {
                (Ok(a), Ok(b)) => essence(a) == essence(b),
                (a, b) => a == b,
            };
            prop_assert!(same, "{printed}: {right:?} became {found:?}");
        }
    }

    /// Values: numbers, polynomials, fractions, vectors, lists, matrices.
    #[test]
    fn values_read_back(value in value()) {
        let mut session = Session::default();
        let expr = value.to_expr();
        for (printed, read) in readings(&expr)? {
            let found = evaluated(&mut session, &read)
                .map_err(|e| TestCaseError::fail(format!("{printed}: {e}")))?;
            prop_assert_eq!(&found, &value, "{}", printed);
        }
    }

    /// Numbers keep every digit, decimals too.
    #[test]
    fn numbers_read_back(q in number(), digits in "[0-9]{1,30}", decimals in "[0-9]{1,30}") {
        let mut session = Session::default();
        let read = parse(&q.to_string()).expect("a fraction");
        prop_assert_eq!(evaluated(&mut session, &read), Ok(Value::number(q)));
        let decimal = format!("{digits}.{decimals}");
        let quotient = format!("{digits}{decimals}/1{}", "0".repeat(decimals.len()));
        let claim = parse(&format!("{decimal} = {quotient}")).expect("a claim");
        prop_assert_eq!(verdict(evaluated(&mut session, &claim)), Some(Verdict::Proved));
    }
}

fn verdict(value: Result<Value, String>) -> Option<Verdict> {
    match value {
        Ok(Value::Claim(claim)) => Some(Claim::verdict(&claim)),
        _ => None,
    }
}

proptest! {
    #![proptest_config(cases(40))]

    /// Polar forms: the equation that is printed, read as a claim, is true in every notation.
    #[test]
    fn polar_forms_read_back(polar in any_polar()) {
        let mut session = Session::default();
        session.env.set(Symbol::new("f"), shared(polar.clone()));
        for notation in [Notation::Grouped, Notation::Expanded, Notation::Sigma] {
            if notation == Notation::Sigma && !matches!(polar.kind, PolarKind::Univariate(_)) {
                continue;
            }
            let equation = polar.equation(Expr::name("f"), notation);
            let constant = matches!(&equation.kind, Kind::Chain(left, _) if matches!(left.kind, Kind::Name(_)));
            for (printed, read) in readings(&equation)? {
                // Of no arguments there is nothing to apply the form to.
                if constant {
                    continue;
                }
                let found = verdict(evaluated(&mut session, &read));
                prop_assert_eq!(found, Some(Verdict::Proved), "{}", printed);
            }
        }
    }

    /// Polar forms: the printed equation defines a function equal to the form.
    #[test]
    fn printed_polar_forms_define_equal_functions(polar in univariate()) {
        prop_assume!(polar.arity() != [0]);
        let mut session = Session::default();
        let printed = text(&polar.equation(Expr::name("g"), Notation::Grouped));
        session.run(&printed).map_err(|failure| TestCaseError::fail(format!("{printed}: {failure:?}")))?;
        session.env.set(Symbol::new("f"), shared(polar));
        let claim = parse("f = g").expect("a claim");
        prop_assert_eq!(verdict(evaluated(&mut session, &claim)), Some(Verdict::Proved), "{}", printed);
    }
}

#[test]
fn functions_read_back() {
    for definition in [
        "F(t) := t^2 + 2t",
        "F(x, y) := x y/(x + y)",
        "B(i, n, t) := binomial(n, i) t^i (1 - t)^(n - i)",
        "F := t -> t^3 + c_0",
        "F(0) := 1",
        "lambda_1(t) := t/2",
    ] {
        for format in [Format::Text, Format::Unicode] {
            let mut session = Session::default();
            let value = session.run(definition).expect("a definition").outcome.value;
            let printed = write_expr(&value.to_expr(), format).expect("text has words for everything");
            let mut other = Session::default();
            let again =
                other.run(&printed).unwrap_or_else(|f| panic!("{printed}: {:?}", f.problem)).outcome.value;
            let once_more = write_expr(&again.to_expr(), format).expect("text has words for everything");
            assert_eq!(printed, once_more, "{definition}");
        }
    }
}

/// What print would show as a mixed number has a sign, and so have the ways that the hints of the reader show.
#[test]
fn mixed_numbers_are_neither_printed_nor_read() {
    let product = Expr::product(vec![Expr::int(3), Expr::int(1).over(Expr::int(2))]);
    assert_eq!(latex(&product), r"3 \cdot \frac{1}{2}");
    assert!(polarform::latex::read(&latex(&product)).expect("a product").same_as(&product));
    let problem = polarform::latex::read(r"3\frac12").expect_err("two readings");
    assert_eq!(problem.hints.len(), 2, "{problem:?}");
    let mut session = session();
    for (hint, value) in problem.hints.iter().zip(["3/2", "7/2"]) {
        let (formula, _) = hint.trim_start_matches("write ").split_once(" for ").expect("a formula");
        let found = session.run(formula).expect(formula).outcome.value;
        assert_eq!(found, session.run(value).expect(value).outcome.value, "{formula}");
    }
}
