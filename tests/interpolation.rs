//! Interpolation and approximation in the language: each result a second way.

use crate::common::run;
use polarform::session::Session;
use polarform::value::{Cell, PiecewiseFunction, Table, Value};
use polarform::write::{Format, table_json, write_table};
use proptest::prelude::*;

fn value(text: &str) -> Value {
    let answer = Session::default().run(text);
    answer.unwrap_or_else(|failure| panic!("{text}: {}", failure.problem.message)).outcome.value
}

fn table(text: &str) -> Table {
    match value(text) {
        Value::Table(table) => (*table).clone(),
        other => panic!("{text}: {}", other.kind()),
    }
}

fn piecewise(text: &str) -> PiecewiseFunction {
    match value(text) {
        Value::Piecewise(function) => (*function).clone(),
        other => panic!("{text}: {}", other.kind()),
    }
}

/// The last cell of the last row.
fn tip(table: &Table) -> Value {
    match table.rows.last().and_then(|row| row.last()) {
        Some(Cell::Labelled(_, value)) => value.clone(),
        other => panic!("{other:?}"),
    }
}

fn list(items: &[i64]) -> String {
    format!("{items:?}")
}

/// Distinct nodes in increasing order, and as many values.
fn samples(most: usize) -> impl Strategy<Value = (Vec<i64>, Vec<i64>)> {
    (proptest::collection::btree_set(-6i64..=6, 2..most), proptest::collection::vec(-9i64..=9, most))
        .prop_map(|(nodes, mut values)| {
            let nodes: Vec<i64> = nodes.into_iter().collect();
            values.truncate(nodes.len());
            (nodes, values)
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn all_ways_lead_to_one_polynomial((nodes, values) in samples(6)) {
        let (x, y, n) = (list(&nodes), list(&values), nodes.len() - 1);
        let expected = value(&format!("lagrange({x}, {y})"));
        let rows: Vec<String> = nodes.iter().zip(&values).map(|(x, y)| format!("[{x}, {y}]")).collect();
        for other in [
            format!("newton({x}, {y})(t)"),
            format!("hermite([{}])", rows.join(", ")),
            format!("least_squares({x}, {y}, {n})"),
            format!("least_squares({x}, {y}, {n}, basis=[bernstein, -7, 7])"),
        ] {
            prop_assert_eq!(&value(&other), &expected, "{}", other);
        }
        for scheme in ["neville", "aitken"] {
            let scheme = table(&format!("{scheme}({x}, {y})"));
            prop_assert_eq!(&tip(&scheme), &expected);
        }
        // The basis with the values as weights, and the solution of the system in powers.
        let mut session = Session::default();
        let mut run = |text: String| session.run(&text).unwrap().outcome.value;
        run(format!("L := lagrange_basis({x})"));
        run(format!("Y := {y}"));
        run(format!("c := solve(vandermonde({x}), Y)"));
        prop_assert_eq!(&run(format!("sum(i=0..{n}, c_i t^i)")), &expected);
        let sum = run(format!("sum(i=0..{n}, Y_i L_i)"));
        prop_assert_eq!(&sum, &expected);
    }

    #[test]
    fn splines_are_twice_smooth((nodes, values) in samples(6), slope in -3i64..=3) {
        let (x, mut values) = (list(&nodes), values);
        for ends in ["natural", "not_a_knot", "periodic", "clamped"] {
            if ends == "periodic" {
                let last = values.len() - 1;
                values[last] = values[0];
            }
            let more = if ends == "clamped" { format!(", slopes=[{slope}, 1]") } else { String::new() };
            let call = |name: &str, more_yet: &str| {
                format!("{name}({x}, {}, ends={ends}{more}{more_yet})", list(&values))
            };
            let spline = piecewise(&call("cubic_spline", ""));
            prop_assert_eq!(&spline, &piecewise(&call("cubic_spline", ", method=slopes")));
            let (first, second) = (spline.function.nth_derivative(1), spline.function.nth_derivative(2));
            let (slopes, moments) = (value(&call("spline_slopes", "")), value(&call("spline_moments", "")));
            let (Value::List(slopes), Value::List(moments)) = (slopes, moments) else { panic!("lists") };
            for (i, y) in values.iter().enumerate() {
                let at = &spline.function.breaks()[i];
                prop_assert_eq!(spline.value(at).unwrap(), Value::int(*y));
                prop_assert_eq!(Value::Scalar(first.value(at).unwrap()), slopes[i].clone());
                prop_assert_eq!(Value::Scalar(second.value(at).unwrap()), moments[i].clone());
                if i > 0 && i + 1 < nodes.len() {
                    let pieces = spline.function.pieces();
                    let (mut left, mut right) = (pieces[i - 1].clone(), pieces[i].clone());
                    for order in 0..=2 {
                        prop_assert_eq!(left.value(at), right.value(at), "{} order {}", ends, order);
                        (left, right) = (left.derivative(), right.derivative());
                    }
                }
            }
            match ends {
                "natural" => {
                    prop_assert_eq!(&moments[0], &Value::int(0));
                    prop_assert_eq!(&moments[nodes.len() - 1], &Value::int(0));
                }
                "clamped" => {
                    prop_assert_eq!(&slopes[0], &Value::int(slope));
                    prop_assert_eq!(&slopes[nodes.len() - 1], &Value::int(1));
                }
                "periodic" => {
                    prop_assert_eq!(&moments[0], &moments[nodes.len() - 1]);
                    prop_assert_eq!(&slopes[0], &slopes[nodes.len() - 1]);
                }
                _ => {}
            }
            // The solutions of both systems of equations.
            for (method, expected) in [("moments", &moments), ("slopes", &slopes)] {
                let system = table(&call("spline_system", &format!(", method={method}")));
                for (row, expected) in system.rows.iter().zip(expected) {
                    match row.last() {
                        Some(Cell::Labelled(_, found)) => prop_assert_eq!(found, expected),
                        Some(Cell::Formula(_)) => prop_assert_eq!(ends, "periodic"),
                        other => panic!("{other:?}"),
                    }
                }
            }
        }
    }

    #[test]
    fn a_polynomial_is_its_interpolant_and_the_rest((nodes, coefficients) in samples(6)) {
        let power = |i: usize| format!("({}) t^{i}", coefficients[i]);
        let formula = (0..coefficients.len()).map(power).collect::<Vec<_>>().join(" + ") + " + t^6";
        let values: Vec<String> = nodes.iter().map(|x| format!("F({x})")).collect();
        let mut session = Session::default();
        session.run(&format!("F(t) := {formula}")).unwrap();
        let mut get = |text: &str| session.run(text).unwrap().outcome.value;
        let Value::Table(error) = get(&format!("interpolation_error(F, {})", list(&nodes))) else { panic!() };
        let (Cell::Labelled(_, interpolant), Cell::Labelled(_, quotient)) =
            (&error.rows[0][0], &error.rows[1][0])
        else {
            panic!("{error:?}")
        };
        prop_assert_eq!(interpolant, &get(&format!("lagrange({}, [{}])", list(&nodes), values.join(", "))));
        let (Value::Scalar(p), Value::Scalar(q)) = (interpolant, quotient) else { panic!() };
        let omega: Vec<String> = nodes.iter().map(|x| format!("(t - ({x}))")).collect();
        let Value::Scalar(omega) = get(&omega.join("*")) else { panic!() };
        prop_assert_eq!(Value::Scalar(p.clone() + q.clone() * omega), get("F(t)"));
    }
}

/// With symbols; here the claims are judged by the program.
#[test]
fn symbolic_data() {
    for claim in [
        "lagrange([a, b, c], [p, q, r]) = newton([a, b, c], [p, q, r])(t)",
        "hermite([[a, p], [b, q]]) = lagrange([a, b], [p, q])",
        "hermite([[a, p, q, r]]) = p + q (t - a) + r/2 (t - a)^2",
        "vandermonde_det([a, b, c]) = det(vandermonde([a, b, c]))",
        "vandermonde_det([a, b, c]) = (b - a) (c - a) (c - b)",
        "cubic_spline([0, 1, 2], [p, q, r])(1) = q",
        "lagrange([a, b], [p, q], variable=s) = (p (b - s) + q (s - a))/(b - a)",
        "condition_number(bernstein_to_power(4)) = basis_condition(4)",
        "condition_number(bernstein_to_power(4), norm=one) = basis_condition(4, one)",
        "condition_number([1, 2; 3, 4], norm=one) = 21",
        "parameters([[0, 0], [3, 4], [9, 12]], chord, scale=length) = [0, 5, 15]",
        "parameters([0, 1, 5], uniform) = [0, 1/2, 1]",
        "least_squares([0, 1, 1], [2, p, q], 1) = 2 + ((p + q)/2 - 2) t",
        "least_squares([0, 1, 2], [p, q, r], 1, through=[[0, p]]) = p + ((q - p) + 2 (r - p))/5 t",
    ] {
        let Value::Claim(claim_value) = value(claim) else { panic!("{claim}") };
        assert_eq!(claim_value.verdict(), polarform::value::Verdict::Proved, "{claim}");
    }
}

/// What is done to points is done to each coordinate.
#[test]
fn points_are_their_coordinates() {
    let (nodes, xs, ys) = ("[0, 1, 3]", "[2, 0, 1]", "[1, -1, 4]");
    let points = "[[2, 1], [0, -1], [1, 4]]";
    for call in ["lagrange(X, Y)", "cubic_spline(X, Y)", "least_squares(X, Y, 1)", "spline_moments(X, Y)"] {
        let on = |data: &str| value(&call.replace('X', nodes).replace('Y', data));
        let (both, first, second) = (on(points), on(xs), on(ys));
        let expected = match (first, second) {
            (Value::List(a), Value::List(b)) => {
                Value::List(a.into_iter().zip(b).map(|(a, b)| Value::list(vec![a, b])).collect())
            }
            (a, b) => Value::list(vec![a, b]),
        };
        assert_eq!(both, expected, "{call}");
    }
    assert_eq!(value(&format!("newton({nodes}, {points})(1)")), value("[0, -1]"));
    assert_eq!(value(&format!("cubic_spline({nodes}, {points})(1)")), value("[0, -1]"));
    assert_eq!(value(&format!("derivative(cubic_spline({nodes}, {points}), 2)(0)")), value("[0, 0]"),);
    let clamped = format!("derivative(cubic_spline({nodes}, {points}, slopes=[[1, 2], [3, 4]]))(0)");
    assert_eq!(value(&clamped), value("[1, 2]"));
    let data = "[[0, [0, 0], [1, 0]], [1, [1, 1], [1, 0]]]";
    assert_eq!(value(&format!("hermite({data})")), value("[t, 3t^2 - 2t^3]"));
}

/// Stoer, Bulirsch (2002), 2.1.2 to 2.1.5.
#[test]
fn tables_as_books_print_them() {
    let shown = |text: &str| write_table(&table(text), Format::Text).unwrap();
    assert_eq!(
        shown("divided_differences([0, 1, 3], [1, 3, 2])"),
        "x0 = 0  f[x0] = 1\n\
         x1 = 1  f[x1] = 3  f[x0, x1] = 2\n\
         x2 = 3  f[x2] = 2  f[x1, x2] = -1/2  f[x0, x1, x2] = -5/6"
    );
    assert_eq!(
        shown("neville([0, 1, 3], [1, 3, 2], 2)"),
        "x0 = 0  p_0 = 1\n\
         x1 = 1  p_1 = 3  p_{0,1} = 5\n\
         x2 = 3  p_2 = 2  p_{1,2} = 5/2  p_{0,1,2} = 10/3"
    );
    let hermite = table("hermite_table([[0, -1, -2], [1, 0, 10, 40]])");
    let diagonal: Vec<Value> = hermite
        .rows
        .iter()
        .map(|row| match row.last() {
            Some(Cell::Labelled(_, value)) => value.clone(),
            other => panic!("{other:?}"),
        })
        .collect();
    assert_eq!(diagonal, [-1, -2, 3, 6, 5].map(Value::int));
    // Symbolic nodes: quotients of quotients stay what they are.
    let symbolic = shown("divided_differences([a, b, c], [p, q, r])");
    assert!(symbolic.ends_with("f[x0, x1, x2] = (f[x1, x2] - f[x0, x1])/(c - a)"), "{symbolic}");
    let json = table_json(&table("spline_system([0, 1, 2], [0, 1, 0])"));
    assert_eq!(json["rows"][1][5]["label"], "M_1");
    assert_eq!(json["rows"][1][5]["number"], "-3");
    assert!(json["latex"].as_str().unwrap().contains("\\mu_1 = \\frac{1}{2}"), "{json}");
}

/// The words before a bracket are functions, elsewhere bases; other words have a meaning only where a
/// parameter takes them.
#[test]
fn words_keep_their_meaning() {
    assert_eq!(value("change_of_basis(1, [newton, 2], power)"), value("[1, -2; 0, 1]"));
    assert_eq!(value("change_of_basis(1, [lagrange, 0, 1], power)"), value("[1, 0; -1, 1]"));
    assert_eq!(value("convert(bezier([0, 1]), hermite)"), value("[0, 1]"));
    for word in ["power", "taylor", "lagrange", "newton", "hermite"] {
        assert_eq!(value(word), Value::Text(word.to_owned()));
    }
    assert!(Session::default().run("natural").is_err());
    // A word may be given another meaning.
    let mut session = Session::default();
    session.run("natural := 3").unwrap();
    assert_eq!(session.run("natural + 1").unwrap().outcome.value, Value::int(4));
}

/// Newton's form is kept as it is written, also under a name, and computes as any function.
#[test]
fn newton_s_form_stays() {
    let mut session = Session::default();
    let mut shown = |text: &str| polarform::write::text(&session.run(text).unwrap().outcome.value.to_expr());
    assert_eq!(shown("newton([0, 1, 3], [1, 3, 2])"), "t -> 1 + 2 t - 5/6 t (t - 1)");
    assert_eq!(shown("P := newton([0, 1, 3], [1, 3, 2])"), "P(t) := 1 + 2 t - 5/6 t (t - 1)");
    assert_eq!(shown("P'(0)"), "17/6");
    assert_eq!(shown("polar(P)(0, 1)"), "29/12");
    assert_eq!(shown("newton([a, b], [p, q])"), "t -> p + (q - p)/(b - a) (t - a)");
    assert_eq!(shown("newton([-1, 0], [5, 5])"), "t -> 5");
    assert_eq!(shown("newton([0], [0])"), "t -> 0");
}

#[test]
fn rounded_parameters_say_so() {
    let answer = Session::default().run("parameters([[0, 0], [1, 0], [2, 1]], chord, decimals=3)").unwrap();
    assert_eq!(answer.outcome.value, value("[0, 0.414, 1]"));
    assert_eq!(answer.outcome.notes.len(), 1);
    assert_eq!(answer.outcome.notes[0].message, "the values are rounded to 3 decimals");
    // Exact ones need no note.
    let answer = Session::default().run("parameters([[0, 0], [3, 4]], chord, decimals=3)").unwrap();
    assert!(answer.outcome.notes.is_empty());
}

#[test]
fn the_command_asks_the_same_queries() {
    let out = |arguments: &[&str]| {
        let ran = run(&[&["interpolate"], arguments].concat());
        assert_eq!(ran.status, Some(0), "{}", ran.err);
        ran.out
    };
    let data = ["--nodes", "0,1,3", "--values", "1,3,2"];
    for method in ["lagrange", "newton", "hermite", "neville", "aitken"] {
        let at = [&data[..], &["--method", method, "--at", "2"]].concat();
        assert_eq!(out(&at), "p(2) = 10/3\n", "{method}");
    }
    assert_eq!(out(&data), "p(t) = -5/6 t^2 + 17/6 t + 1\n");
    let squares = [&data[..], &["--method", "least-squares", "--degree", "2"]].concat();
    assert_eq!(out(&squares), out(&data));
    let weights = [&squares[..], &["--weights", "1,2,3"]].concat();
    assert_eq!(out(&weights), out(&data));
    let spline = [&data[..], &["--method", "spline", "--ends", "not_a_knot", "--at", "2"]].concat();
    assert_eq!(out(&spline), "S(2) = 10/3\n");
    let points = ["--nodes", "0,1", "--values", "[0, 1], [2, 3]", "--variable", "s"];
    assert_eq!(out(&points), "p(s) = (2 s, 2 s + 1)\n");
    assert_eq!(out(&["--nodes", "[0, 1]", "--values", "[a, b]"]), "p(t) = (b - a) t + a\n");
    assert_eq!(out(&["--nodes", "0..2", "--values", "0,1,4", "--at", "-1"]), "p(-1) = 1\n");
}
