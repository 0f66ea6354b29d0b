//! Curves, splines and surfaces in the language: what is printed reads back, claims about them
//! hold, and the values agree with those of another program.

use std::fs;

use num_traits::ToPrimitive;
use polarform::functions::BUILTINS;
use polarform::session::Session;
use polarform::value::{Value, Verdict};
use polarform::write::text;

/// Whether a value has a text that makes it again.
fn is_object(value: &Value) -> bool {
    match value {
        Value::Geometry(_) | Value::Piecewise(_) => true,
        Value::List(items) => !items.is_empty() && items.iter().all(is_object),
        _ => false,
    }
}

#[test]
fn what_is_printed_makes_the_same_object() {
    let mut count = 0;
    let more = [
        "bezier([[0, 0], [1, 2]], r, s)",
        "bezier([[1, 0], [0, 1]], homogeneous=1)",
        "bezier([[0, 0, 0], [1, 2, 1], [1, 2, 0]], homogeneous=1)",
        "bspline(2, [0, 0, 0, 1, 1, 1], [[0, 0], [1, 1], [2, 0]], weights=[1, w, 1])",
        "bspline(1, [t_0, t_1, t_2, t_3], [d_0, d_1])",
        "bspline_basis(2, [t_0, t_1, t_1, t_2], 0)",
        "patch([[0, 1], [2, 5]], [r, s], [0, 2], weights=[[1, 2], [1, 1]])",
        "triangle_patch([b_200, b_110, b_101, b_020, b_011, b_002], [[0, 0], [2, 0], [0, 2]])",
        "spline_surface(1, 1, [0, 0, 1, 1], [0, 0, 1, 1], [[0, 1], [2, 3]], weights=[[1, 1], [2, 1]])",
        "piecewise([0, 1, 2], [x, 1], variable=x)",
    ];
    for example in BUILTINS.iter().map(|builtin| builtin.example).chain(more) {
        let answer = Session::default().run(example).unwrap_or_else(|f| panic!("{example}: {:?}", f.problem));
        let value = answer.outcome.value;
        if is_object(&value) {
            let printed = text(&value.to_expr());
            let again =
                Session::default().run(&printed).unwrap_or_else(|f| panic!("{printed}: {:?}", f.problem));
            assert_eq!(again.outcome.value, value, "{printed}");
            count += 1;
        }
    }
    assert!(count >= 30, "only {count} objects");
}

fn verdict(statement: &str) -> Verdict {
    let answer = Session::default().run(statement).unwrap_or_else(|f| panic!("{statement}: {:?}", f.problem));
    match answer.outcome.value {
        Value::Claim(claim) => claim.verdict(),
        other => panic!("{statement} is {}", other.kind()),
    }
}

#[test]
fn equal_curves() {
    for claim in [
        "elevate(bezier([b_0, b_1, b_2])) = bezier([b_0, b_0/3 + 2 b_1/3, 2 b_1/3 + b_2/3, b_2])",
        "insert_knots(bspline(2, [0, 0, 0, 1, 2, 2, 2], [d_0, d_1, d_2, d_3]), 1/2, 3/2) = bspline(2, [0, 0, 0, 1, 2, 2, 2], [d_0, d_1, d_2, d_3])",
        "convert(bezier([0, 1, 4]), bspline) = bezier([0, 1, 4])",
        "bezier([0, 1, 2], weights=[1, 1, 1]) = bezier([0, 1, 2])",
        "bezier([0, 1, 2], weights=[2, 3, 5]) = bezier([0, 1, 2], weights=[4, 6, 10])",
        "reduce(elevate(patch([[0, 1], [2, 5]]), 2, 1), 2, 1) = patch([[0, 1], [2, 5]])",
        "elevate(patch([[0, 1], [2, 5]])) = patch([[0, 1], [2, 5]])",
        "elevate(triangle_patch([0, 1, 5])) = triangle_patch([0, 1, 5])",
        "derivative(antiderivative(bspline(1, [0, 0, 1, 2, 2], [3, 1, 4]))) = bspline(1, [0, 0, 1, 2, 2], [3, 1, 4])",
        // An antiderivative has no value outside of the breakpoints.
        "derivative(antiderivative(bspline_basis(1, [0, 1, 2], 0))) = piecewise([0, 1, 2], [t, 2 - t])",
    ] {
        assert_eq!(verdict(claim), Verdict::Proved, "{claim}");
    }
    for claim in [
        "bezier([0, 1]) = bezier([0, 2])",
        "bezier([0, 1]) = bezier([0, 1], 0, 2)",
        "bezier([0, 1, 2], weights=[1, 2, 1]) = bezier([0, 1, 2])",
        "bezier([0, 1]) = bezier([[0, 1], [1, 2]])",
        "patch([[0, 1], [2, 5]]) = patch([[0, 1], [2, 4]])",
    ] {
        assert_eq!(verdict(claim), Verdict::Refuted, "{claim}");
    }
}

#[test]
fn facts_of_the_subject() {
    for claim in [
        // (1 − t) b_0 + t b_1 and so on
        "bezier([b_0, b_1, b_2])(t) = (1 - t)^2 b_0 + 2 t (1 - t) b_1 + t^2 b_2",
        // F'(0) = n (b_1 − b_0)
        "derivative(bezier([b_0, b_1, b_2, b_3]))(0) = 3 (b_1 - b_0)",
        "integrate(bezier([b_0, b_1, b_2], r, s)) = (s - r) (b_0 + b_1 + b_2)/3",
        // the ratio of knot insertion
        "insert_knots(bspline(1, [0, 0, 2, 2], [d_0, d_1]), 1/2) = bspline(1, [0, 0, 2, 2], [d_0, d_1])",
        // uniform quadratic B-spline at the middle of its support
        "bspline_basis(2, [0, 1, 2, 3], 0)(3/2) = 3/4",
        "bspline_basis(3, [0, 1, 2, 3, 4], 0)(2) = 2/3",
        // twist of a bilinear patch
        "derivative(patch([[p_0, p_1], [p_2, p_3]]), 1, 1)(0, 0) = p_0 - p_1 - p_2 + p_3",
        "triangle_patch([b_200, b_110, b_101, b_020, b_011, b_002])(1/2, 1/2) = b_020/4 + b_011/2 + b_002/4",
        "barycentric([x, y], [[0, 0], [1, 0], [0, 1]]) = [1 - x - y, x, y]",
        // basis functions that jump are half-open
        "sum(i = 0..2, bspline_basis(0, [1, 2, 3, 5], i)(3)) = 1",
        "sum(i = 0..3, bspline_basis(1, [0, 0, 1, 1, 2, 2], i)(1)) = 1",
        "sum(i = 0..3, bspline_basis(2, [0, 0, 0, 1, 2, 2, 2], i)) = piecewise([0, 2], [1], outside=0)",
        // an antiderivative starts where the curve does
        "antiderivative(bspline(1, [0, 1, 2, 3], [2, 4]))(1) = 0",
        "integrate(bezier([0, 1, 4]), 0, 1/2) = 1/3",
        "integrate(bspline(1, [0, 0, 1, 2, 2], [0, 2, 0]), t, 1/2, 1) = 3/4",
        // polar forms of surfaces in space
        "polar(patch([[[0, 0], [0, 1]], [[1, 0], [1, 1]]]))(1; -2) = [1, -2]",
        "polar(triangle_patch([[0, 1], [2, 3], [4, 5]]))([1, 2]) = [10, 11]",
        "triangle_patch([b_100, b_010, b_001])(1/2, 1/3, 1/6) = b_100/2 + b_010/3 + b_001/6",
        "compose(bezier([0, 1, 4], 1, 3), t) = bezier([0, 1, 4], 1, 3)",
        "bezier([0, 1]) + 2 bezier([1, 1, 2]) = bezier([2, 5/2, 5])",
        "convert(cubic_spline([0, 1, 2], [0, 1, 0]), bspline)(1/2) = cubic_spline([0, 1, 2], [0, 1, 0])(1/2)",
        "insert_knots(bspline(1, [t_0, t_1, t_2, t_3], [d_0, d_1]), t, span=1)(t_2) = d_1",
        "derivatives_at(sphere_octant([0, 0, 0], 1), 0, 0, 1) = [[[1, 0, 0], [0, 0, 2]], [[0, 2, 0]]]",
        // surfaces with base points
        "length(intersections([t, t, t], torus(3, 1)[0])) = 0",
        // parts of splines, also rational and over several intervals
        "part(bspline(1, [0, 0, 1, 2, 2], [d_0, d_1, d_2]), 1/2, 2) = bspline(1, [1/2, 1/2, 1, 2, 2], [(d_0 + d_1)/2, d_1, d_2])",
        "subdivide(bspline(2, [0, 0, 0, 1, 1, 1], [b_0, b_1, b_2]), 1/2)[0] = subdivide(bezier([b_0, b_1, b_2]), 1/2)[0]",
        "length(subdivide(bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 5, 7]), 3/2, 1/2, 1)) = 4",
        "subdivide(bspline(1, [0, 0, 1, 2, 2], [1, 3, 2], weights=[1, 1, 3]), 1/2)[1](3/2) = bspline(1, [0, 0, 1, 2, 2], [1, 3, 2], weights=[1, 1, 3])(3/2)",
        "pieces(part(spline_surface(1, 1, [0, 0, 1, 2, 2], [0, 0, 1, 1], [[a, b], [c, d], [e, f]]), [0, 1], [0, 1]))[0][0] = patch([[a, b], [c, d]])",
        "subdivide(spline_surface(1, 1, [0, 0, 1, 2, 2], [0, 0, 1, 1], [[a, b], [c, d], [e, f]]), u=1)[1](3/2, 0) = (c + e)/2",
        "subdivide(spline_surface(1, 1, [0, 0, 1, 2, 2], [0, 0, 1, 1], [[a, b], [c, d], [e, f]], weights=[[1, 1], [1, 2], [1, 1]]), 1/2, 1/2)[1][0](1, 1/4) = (3c/4 + d/2)/(5/4)",
        // derivatives of polar forms in two variables
        "derivative(polar_tensor(u^3 v^2, u, v), 1, 1) = polar_tensor(6 u^2 v, u, v)",
        "derivative(polar_tensor(u^3 v^2, u, v), 2) = polar_tensor(6 u v^2, u, v)",
        "derivative(polar_total(u^3 v + v^2, [u, v]), 1, 1) = polar_total(3 u^2, [u, v])",
        "derivative(polar_total(u v + u^2, [u, v]), [1, 2]) = polar_total(4 u + v, [u, v])",
        "derivative(polar_total(u v w, [u, v, w]), 0, 1, 1) = polar_total(u, [u, v, w])",
        "derivative(polar_total(u v, [u, v]), 0, 0) = polar_total(u v, [u, v])",
        "derivative(polar_total(u v, [u, v]), 2, 1)() = 0",
        // the best solution of too many equations
        "least_squares_solution([1, 0; 1, 1; 1, 2], [1, 2, 6]) = coefficients(least_squares([0, 1, 2], [1, 2, 6], 1))",
        "least_squares([0, 1], [5, 5], 0)(3) = 5",
        "least_squares_solution([1; 1], [x, y], weights=[1, 3]) = [(x + 3y)/4]",
        "least_squares_solution([1, 2; 3, 5], [a, b]) = solve([1, 2; 3, 5], [a, b])",
        // both ways to a product and to a composition
        "polar_product(t^2 + 2t, t^3 + 1, method=symmetrize) = polar_product(t^2 + 2t, t^3 + 1)",
        "polar_compose(a t^2 + 2t, t^3 + b, method=symmetrize) = polar_compose(a t^2 + 2t, t^3 + b)",
    ] {
        assert_eq!(verdict(claim), Verdict::Proved, "{claim}");
    }
}

#[test]
fn scipy_agrees() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/corpus/scipy_bsplines.txt");
    let text = fs::read_to_string(path).unwrap();
    let mut count = 0;
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let [degree, knots, points, t, value, derivative] = line.split(';').collect::<Vec<_>>()[..] else {
            panic!("{line}");
        };
        let largest = points.split(',').map(|x| to_f64(x).abs()).fold(1.0, f64::max);
        let spline = format!("bspline({degree}, [{knots}], [{points}])");
        for (query, expected) in
            [(format!("{spline}({t})"), value), (format!("derivative({spline})({t})"), derivative)]
        {
            let answer =
                Session::default().run(&query).unwrap_or_else(|f| panic!("{query}: {:?}", f.problem));
            let exact = answer.outcome.value.as_rational().unwrap().to_f64().unwrap();
            let float: f64 = expected.trim().parse().unwrap();
            let scale = largest.max(float.abs());
            assert!((exact - float).abs() <= 1e-12 * scale, "{query}: {exact} and {float}");
            count += 1;
        }
    }
    assert_eq!(count, 48);
}

/// A fraction such as -793/672.
fn to_f64(text: &str) -> f64 {
    let number = |text: &str| text.trim().parse::<f64>().unwrap();
    text.split_once('/').map_or_else(|| number(text), |(p, q)| number(p) / number(q))
}

/// The pieces of a B-spline over symbolic knots are written as the products of the recurrence; read
/// back they are the pieces.
#[test]
fn pieces_of_basis_functions_are_products() {
    let mut session = polarform::session::Session::default();
    let mut value = |query: &str| session.run(query).map(|answer| answer.outcome.value).expect(query);
    for knots in ["k, m, n, p", "k, k, m, n", "k, m, m, n", "0, k, m, 1", "k, m, n, p, q", "k, k, k, m, n"] {
        for degree in 1..=3 {
            let count = knots.split(',').count();
            let repeated = knots.matches('k').count();
            if degree + 2 > count || repeated > degree + 1 {
                continue;
            }
            let query = format!("bspline_basis({degree}, [{knots}], 0)");
            let function = value(&query);
            let written = polarform::write::text(&function.to_expr());
            assert_eq!(value(&written), function, "{query}: {written}");
        }
    }
    let written = polarform::write::text(&value("bspline_basis(2, [k, m, n, p], 0)").to_expr());
    assert_eq!(written.matches("/((n - k) (n - m)) + ").count(), 1, "{written}");
}
