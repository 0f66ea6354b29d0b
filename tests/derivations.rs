//! Every line of every derivation is read back and judged: by the language, with F, f and the like
//! defined in another way, and by the checker of lecture notes, which knows only the lines
//! themselves. How they look: `derivation_words`.

use crate::common::derivations::{assert_true, assert_true_in_notes, derived, formulas, run};
use polarform::blossom::Method;
use polarform::expr::{Expr, Kind};
use polarform::session::Session;
use polarform::value::{Derivation, Language, Value, Verdict};
use polarform::write::{latex, text};
use proptest::prelude::*;

/// Definitions of F, G, H and their polar forms of these degrees.
fn polynomials(list: &[(&str, &str, usize)]) -> Vec<String> {
    let mut context = Vec::new();
    for (name, formula, degree) in list {
        context.push(format!("{name}(t) := {formula}"));
        if *degree > 0 {
            let small = name.to_lowercase();
            context.push(format!("{small} := polar({name}, degree={degree}, variable=t)"));
        }
    }
    context
}

fn strings(list: &[&str]) -> Vec<String> {
    list.iter().map(|item| (*item).to_owned()).collect()
}

const CUBIC: &str = "t^3 + 3 t^2 + 5 t + 1";
const GENERIC: &str = "c_0 + c_1 t + c_2 t^2";

#[test]
fn polar_forms_by_every_method() {
    for (formula, degree) in [
        (CUBIC, 3),
        (GENERIC, 2),
        ("t^3 - 2 t", 5),
        ("-t", 1),
        ("1/2 - t^4", 4),
        ("t^2/c - c", 2),
        ("7", 2),
        ("0", 1),
    ] {
        let context = polynomials(&[("F", formula, degree)]);
        for method in Method::ALL {
            let query = format!("derive(polar, {formula}, degree={degree}, variable=t, method={method})");
            let derivation = derived(&[], &query);
            assert!(assert_true(&query, &context, &derivation) > 1, "{query}");
            if !formula.contains("/c") {
                assert_true_in_notes(&query, "", &derivation);
            }
        }
    }
    for constant in ["7", "0", "c_0"] {
        for method in Method::ALL {
            let query = format!("derive(polar, {constant}, variable=t, method={method})");
            assert_true(&query, &polynomials(&[("F", constant, 0)]), &derived(&[], &query));
        }
    }
}

#[test]
fn polar_forms_of_other_kinds() {
    let query = "derive(polar, polar_tensor(u^2 v - 3 v, u, v, 2, 1))";
    let context = strings(&["F(u, v) := u^2 v - 3 v", "f := polar_tensor(F(u, v), u, v, 2, 1)"]);
    assert_true(query, &context, &derived(&[], query));
    let query = "derive(polar, polar_total(u v + u, [u, v], degree=2))";
    let context = strings(&["F(u, v) := u v + u", "f := polar_total(F(u, v), [u, v], degree=2)"]);
    assert_true(query, &context, &derived(&[], query));
    // The degree of a curve is the largest one.
    let context =
        strings(&["F_1(t) := 3 t", "F_2(t) := t^2", "f_1 := polar(F_1, degree=2)", "f_2 := polar(F_2)"]);
    for method in Method::ALL {
        let query = format!("derive(polar, [3 t, t^2], method={method})");
        assert_true(&query, &context, &derived(&[], &query));
    }
    // A variable called like one of the names on the way.
    let context = strings(&["F(tau) := tau^2 + s i", "f := polar(tau^2 + s i, variable=tau)"]);
    for method in Method::ALL {
        let query = format!("derive(polar, tau^2 + s i, variable=tau, method={method})");
        assert_true(&query, &context, &derived(&[], &query));
    }
}

#[test]
fn equations_of_plane_curves() {
    for curve in [
        "[t^2, t^3]",
        "[t^2 - 1, t^3 - t]",
        "[(1 - t^2)/(1 + t^2), 2 t/(1 + t^2)]",
        "[t^2, t^4]",
        "bezier([[0, 0], [1, 2], [3, 1]])",
        "bezier([[0, 0], [a, 2], [3, b]])",
        "bezier([[1, 0], [1, 1], [0, 1]], weights=[1, 1, 2])",
    ] {
        let query = format!("derive(implicit, {curve})");
        assert!(assert_true(&query, &[], &derived(&[], &query)) > 0, "{query}");
    }
}

#[test]
fn surfaces_of_four_curves() {
    for curves in [
        "bezier([0, 1]), bezier([1, 3]), bezier([0, 1, 1]), bezier([1, 3])",
        "bezier([0, 4, 2], 1, 3), bezier([5, b], 1, 3), bezier([0, a, 5], 2, 4), bezier([2, b], 2, 4)",
        "bezier([[0, 0], [1, 1], [2, 0]]), bezier([[0, 2], [2, 3]]), bezier([[0, 0], [0, 2]]), bezier([[2, 0], [3, 1], [2, 3]])",
    ] {
        let query = format!("derive(coons, {curves})");
        assert!(assert_true(&query, &[], &derived(&[], &query)) > 8, "{query}");
    }
}

#[test]
fn multirational_blossoms() {
    for (f, u, v) in [
        ("1/t", "u", "v, w"),
        ("1/t^2", "", "v, w"),
        ("1/(2 - t)^3", "1", "0, 1, 3, 5"),
        ("t/(t - 4)", "a", "1, 2"),
        ("1/t", "", "2"),
        ("1/t", "2", "3, 3"),
        ("t^2 + 2 t - 1", "a, b, c", "d"),
        ("t^3", "1, 2, 3", ""),
        ("5", "a", "b"),
    ] {
        let query = format!("derive(multirational, {f}, [{u}], [{v}], variable=t)");
        let derivation = derived(&[], &query);
        let context = strings(&[&format!("F(t) := {f}")]);
        assert!(assert_true(&query, &context, &derivation) > 1, "{query}");
    }
}

#[test]
fn sums_products_compositions() {
    for (f, m, g, n) in [
        ("t^2 + 2 t", 2, "t^3 + 1", 3),
        ("t^3 + 1", 3, "t", 1),
        ("t", 1, "t^2 - 1/2", 2),
        (GENERIC, 2, "1 - 2 t", 1),
        ("5", 0, "t^2 + t", 2),
        ("t^2 + t", 2, "-5", 0),
        ("3", 0, "4", 0),
        ("t^3 - t", 3, "2 t^2 - t", 2),
        ("t^4", 4, "t^4 - 1", 4),
    ] {
        for (kind, h, degree) in [
            ("sum", format!("({f}) + ({g})"), m.max(n)),
            ("product", format!("({f}) ({g})"), m + n),
            ("compose", String::new(), m * n),
        ] {
            if degree > 8 {
                continue;
            }
            let mut context = polynomials(&[("F", f, m), ("G", g, n)]);
            if kind == "compose" {
                context.push("H(t) := F(G(t))".to_owned());
                let polar = format!("h := polar(H, degree={degree})");
                context.extend((degree > 0).then_some(polar));
            } else {
                context.extend(polynomials(&[("H", &h, degree)]));
            }
            let query = format!("derive({kind}, polar({f}, variable=t), polar({g}, variable=t))");
            let derivation = derived(&[], &query);
            assert!(assert_true(&query, &context, &derivation) > 2, "{query}");
            if m > 0 && n > 0 {
                assert_true_in_notes(&query, "", &derivation);
            }
        }
    }
}

#[test]
fn derivatives_and_elevation() {
    for (formula, degree) in [(CUBIC, 3), (GENERIC, 2), ("t^4 - t/2", 4), ("2 - t", 1)] {
        let mut context = polynomials(&[("F", formula, degree)]);
        for k in 0..=degree + 1 {
            let query = format!("derive(derivative, polar({formula}, variable=t), {k})");
            let derivation = derived(&[], &query);
            assert_true(&query, &context, &derivation);
            assert_true_in_notes(&query, "", &derivation);
        }
        for k in 1..=3 {
            // The elevated forms are f_n, computed here from the coefficients.
            context.push(format!("f_{} := elevate(f, {k})", degree + k));
            let query = format!("derive(elevate, polar({formula}, variable=t), {k})");
            let derivation = derived(&[], &query);
            assert!(assert_true(&query, &context, &derivation) > 2 * k, "{query}");
            assert_true_in_notes(&query, "", &derivation);
        }
    }
    let query = "derive(elevate, bezier([[0, 0], [1, 2], [2, 0]], 1, 3), 2)";
    let mut context = strings(&["c := control_points(elevate(bezier([[0, 0], [1, 2], [2, 0]], 1, 3), 2))"]);
    context.extend((0..=4).map(|i| format!("b_{{4,{i}}} := c_{i}")));
    assert!(assert_true(query, &context, &derived(&[], query)) >= 10);
    let query = "derive(elevate, bezier([b_0, b_1]))";
    assert_true(query, &[], &derived(&[], query));
    let query = "derive(elevate, 7, 2)";
    assert_true(query, &[], &derived(&[], query));
}

#[test]
fn matrices() {
    for n in 0..=4 {
        for (query, own) in [
            (format!("derive(matrix, {n})"), format!("A_{n} := bernstein_to_power({n})")),
            (format!("derive(inverse_matrix, {n})"), format!("A_{n} := power_to_bernstein({n})^-1")),
        ] {
            let derivation = derived(&[], &query);
            assert_true(&query, &[own], &derivation);
            assert_true_in_notes(&query, "", &derivation);
        }
    }
}

#[test]
fn schemes_of_bezier_curves() {
    for (curve, u) in [
        ("bezier([1, 3, 4, -2])", "1/3"),
        ("bezier([[0, 0], [1, 2], [2, 0]])", "1/2"),
        ("bezier([[0, 0], [1, 2], [2, 0]], 1, 3)", "-1"),
        ("bezier([b_0, b_1, b_2])", "t"),
        ("bezier([b_0, b_1, b_2, b_3], r, s)", "t"),
        ("bezier([1, 2, 4])", "t"),
        ("bezier([1, 2, 4])", "u, v"),
        ("bezier([5])", "1/2"),
    ] {
        let context = [format!("F(t) := {curve}(t)"), format!("f := polar({curve})")];
        // The polar form of a constant is no function.
        let context = if curve == "bezier([5])" { &context[..1] } else { &context[..] };
        let query = format!("derive(casteljau, {curve}, {u})");
        let derivation = derived(&[], &query);
        let outside = u == "-1";
        assert!(
            assert_true(&query, if outside { &context[1..] } else { context }, &derivation) > 0,
            "{query}"
        );
        // The checker of notes reads no points, and no polynomials over [r, s].
        if !curve.contains("[[") && !curve.contains('r') && curve != "bezier([5])" {
            assert_true_in_notes(&query, "", &derivation);
        }
    }
    // A rational curve: homogeneous points on the way.
    let curve = "bezier([[1, 0], [1, 1], [0, 1]], weights=[1, 1, 2])";
    let query = format!("derive(casteljau, {curve}, 1/2)");
    let context = [format!("F := {curve}"), format!("f := polar(homogeneous({curve}))")];
    let derivation = derived(&[], &query);
    // The first line says F as a quotient of points.
    let rest = Derivation { lines: derivation.lines[1..].to_vec(), ..derivation };
    assert_eq!(text(&rest.lines.last().unwrap().formula), "F(1/2) = (3/5, 4/5)");
    assert!(assert_true(&query, &context, &rest) >= 10);
}

#[test]
fn schemes_of_splines() {
    for (spline, u, span) in [
        ("bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4])", "3/2", 3),
        ("bspline(2, [0, 0, 0, 1, 2, 2, 2], [[1, 1], [3, 0], [2, 5], [4, 1]])", "1", 3),
        ("bspline(3, uniform_knots(3, 5), [1, 0, 0, 2, 1])", "7/2", 3),
        ("bspline(3, uniform_knots(3, 5), [1, 0, 0, 2, 1])", "5", 4),
        ("bspline(2, [t_0, t_1, t_2, t_3, t_4, t_5], [d_0, d_1, d_2])", "t, span=2", 2),
        ("bspline(1, [0, 0, 1, 1], [2, 3])", "1/3", 1),
    ] {
        let query = format!("derive(deboor, {spline}, {u})");
        let derivation = derived(&[], &query);
        let symbolic = u.starts_with('t');
        let mut context = vec![format!("f := polar({spline}, span={span})")];
        if !symbolic {
            context.push(format!("F := {spline}"));
        }
        context.push(format!("T := knots({spline})"));
        assert!(assert_true(&query, &context, &derivation) >= 4, "{query}");

        if symbolic {
            continue;
        }
        let query = format!("derive(insert, {spline}, {u})");
        let derivation = derived(&[], &query);
        let fine = format!("insert_knots({spline}, {u})");
        let mut context = vec![format!("f := polar({spline}, span={span})")];
        context.push(format!("T := knots({spline})"));
        context.push(format!("U := knots({fine})"));
        context.push(format!("e := control_points({fine})"));
        // The ratios α_i are introduced, all else is known.
        let introduced = spline[8..9].parse::<usize>().unwrap();
        let equations: usize = derivation
            .lines
            .iter()
            .flat_map(|line| formulas(&line.formula))
            .map(|formula| if let Kind::Chain(_, links) = &formula.kind { links.len() } else { 0 })
            .sum();
        let proved = assert_true(&query, &context, &derivation);
        assert_eq!(proved + 2 * introduced, equations, "{query}");
    }
}

#[test]
fn joining_conditions() {
    for (left, right, k) in [
        ("bezier([0, 1, 2])", "bezier([2, 3, 5], 1, 2)", 2),
        ("bezier([0, 1, 2])", "bezier([3, 3, 5], 1, 2)", 2),
        ("bezier([[0, 1], [1, 2], [2, 2]], 0, 2)", "bezier([[2, 2], [5/2, 2], [7, 1]], 2, 3)", 2),
        ("bezier([1, 4])", "bezier([4, 7], 1, 2)", 3),
        ("bezier([7])", "bezier([7], 1, 2)", 1),
    ] {
        let query = format!("derive(join, {left}, {right}, {k})");
        let mut context =
            vec![format!("F(t) := extended({left}, t)"), format!("G(t) := extended({right}, t)")];
        if left != "bezier([7])" {
            context.push(format!("f := polar({left})"));
            context.push(format!("g := polar({right})"));
        }
        assert!(assert_true(&query, &context, &derived(&[], &query)) >= 2, "{query}");
    }
    // Symbolic curves: the conditions say what c_0, c_1, … have to be.
    let query = "derive(join, bezier([b_0, b_1, b_2]), bezier([c_0, c_1, c_2], 1, 3), 2)";
    let derivation = derived(&[], query);
    assert_true_in_notes(query, "", &derivation);
    let conditions: Vec<String> = derivation.lines.iter().map(|line| text(&line.formula)).collect();
    for condition in ["c_0 = b_2", "c_1 = 3 b_2 - 2 b_1", "c_2 = 4 b_0 - 12 b_1 + 9 b_2"] {
        assert!(conditions.contains(&condition.to_owned()), "{condition}: {conditions:#?}");
    }
    // Where no single point is asked for, a difference has to vanish.
    let query = "derive(join, bezier([[a, 0], [b, 1]]), bezier([[c, 1], [d, 2]], 1, 2))";
    let context =
        strings(&["f := polar(bezier([[a, 0], [b, 1]]))", "g := polar(bezier([[c, 1], [d, 2]], 1, 2))"]);
    assert!(assert_true(query, &context, &derived(&[], query)) >= 7);
}

#[test]
fn divided_differences() {
    for (nodes, values, polynomial) in [
        ("[0, 1, 3]", "[1, 2, 10]", "t^2 + 1"),
        ("[2, -1, 1/2, 3]", "[0, 9, 9, -11]", "10 - t - 2 t^2"),
        ("[5]", "[3]", "3"),
        ("[1, 2]", "[0, 0]", "0"),
        ("[0, 0, 0, 2]", "[1, 2, 6, 25]", "t^3 + 3 t^2 + 2 t + 1"),
    ] {
        let query = format!("derive(newton, {nodes}, {values})");
        let derivation = derived(&[], &query);
        let last = text(&derivation.lines.last().unwrap().formula);
        let mut session = Session::default();
        run(&mut session, &last);
        // The interpolant is known.
        let Value::Claim(judged) = run(&mut session, &format!("p(t) = {polynomial}")) else {
            panic!("{last}")
        };
        assert_eq!(judged.verdict(), Verdict::Proved, "{last}");
        assert_true_in_notes(&query, &format!("$$f{}$$", latex_of(&last)), &derivation);
    }
}

/// `(t) = …` of a statement `p(t) = …`, as LaTeX.
fn latex_of(statement: &str) -> String {
    let formula = polarform::syntax::parse(statement).unwrap();
    latex(&formula).trim_start_matches('p').to_owned()
}

#[test]
fn moments_of_cubic_splines() {
    for (nodes, values, ends) in [
        ("[0, 1, 2, 4]", "[0, 1, 0, 2]", "ends=natural"),
        ("[0, 1, 2]", "[0, 1, 0]", "ends=periodic"),
        ("[0, 1, 3, 4]", "[2, 1, 0, 2]", "ends=periodic"),
        ("[-1, 1/2, 2]", "[0, 1, 5]", "slopes=[1, 0]"),
        ("[0, 1, 2]", "[0, 1, 4]", "moments=[2, 2]"),
        ("[0, 1, 2, 3]", "[0, 1, 8, 27]", "ends=not_a_knot"),
        ("[0, 2]", "[1, 5]", "ends=natural"),
        ("[0, 1, 2]", "[[0, 0], [1, 1], [2, 0]]", "ends=natural"),
    ] {
        let query = format!("derive(moments, {nodes}, {values}, {ends})");
        let derivation = derived(&[], &query);
        // The second derivatives of the last lines at the nodes are the moments.
        let mut context = Vec::new();
        let pieces: Vec<&Expr> =
            derivation.lines.iter().map(|line| &line.formula).filter(|f| text(f).starts_with("S_")).collect();
        // Each piece is written by its moments, then by powers.
        let pieces: Vec<&Expr> = pieces.into_iter().skip(1).step_by(2).collect();
        for piece in &pieces {
            let Kind::Chain(left, links) = &piece.kind else { panic!() };
            context.push(format!("{} := {}", text(left), text(&links.last().unwrap().expr)));
        }
        let n = pieces.len();
        context.push(format!("x := {nodes}"));
        context.push(format!("y := {values}"));
        let scalar = !values.contains("[[");
        if scalar {
            context.extend((0..n).map(|i| format!("M_{i} := S_{i}''(x_{i})")));
            context.push(format!("M_{n} := S_{}''(x_{n})", n - 1));
            let mut session = Session::default();
            context.iter().for_each(|statement| drop(run(&mut session, statement)));
            for i in 0..n {
                let mut claims =
                    vec![format!("S_{i}(x_{i}) = y_{i}"), format!("S_{i}(x_{}) = y_{}", i + 1, i + 1)];
                if i > 0 {
                    claims.push(format!("S_{i}'(x_{i}) = S_{}'(x_{i})", i - 1));
                    claims.push(format!("S_{i}''(x_{i}) = S_{}''(x_{i})", i - 1));
                }
                for claim in claims {
                    let Value::Claim(judged) = run(&mut session, &claim) else { panic!("{claim}") };
                    assert_eq!(judged.verdict(), Verdict::Proved, "{query}: {claim}");
                }
            }
            assert_true_in_notes(&query, "", &derivation);
        } else {
            context.extend(strings(&["M_0 := [0, 0]", "M_1 := [0, -3]", "M_2 := [0, 0]"]));
        }
        assert!(assert_true(&query, &context, &derivation) > 8, "{query}");
    }
}

fn coefficients(longest: usize) -> impl Strategy<Value = Vec<(i64, i64)>> {
    prop::collection::vec((-9i64..10, 1i64..4), 1..=longest)
}

/// Σ p/q t^i
fn polynomial(list: &[(i64, i64)]) -> String {
    let terms = list.iter().enumerate().map(|(i, (p, q))| format!("({p}/{q}) t^{i}"));
    terms.collect::<Vec<_>>().join(" + ")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    #[test]
    fn random_polynomials(f in coefficients(5), g in coefficients(3), k in 0usize..4) {
        let (m, n) = (f.len() - 1, g.len() - 1);
        prop_assume!(m > 0 && n > 0);
        let (first, second) = (polynomial(&f), polynomial(&g));
        let context = polynomials(&[("F", &first, m), ("G", &second, n)]);
        for method in Method::ALL {
            let query = format!("derive(polar, {first}, degree={m}, variable=t, method={method})");
            let derivation = derived(&[], &query);
            assert_true(&query, &context, &derivation);
            assert_true_in_notes(&query, "", &derivation);
        }
        for (kind, whole, degree) in [
            ("sum", format!("{first} + {second}"), m.max(n)),
            ("product", format!("({first}) ({second})"), m + n),
        ] {
            let query = format!("derive({kind}, f, g)");
            let mut more = context.clone();
            more.extend(polynomials(&[("H", &whole, degree)]));
            assert_true(&query, &more, &derived(&context, &query));
        }
        if m * n <= 6 {
            let mut more = context.clone();
            more.push("H(t) := F(G(t))".to_owned());
            more.push(format!("h := polar(H, degree={})", m * n));
            assert_true("compose", &more, &derived(&context, "derive(compose, f, g)"));
        }
        let query = format!("derive(derivative, f, {k})");
        assert_true(&query, &context, &derived(&context, &query));
    }

    #[test]
    fn random_curves(points in prop::collection::vec((-9i64..10, -9i64..10), 2..5), u in (-4i64..9, 1i64..5)) {
        let list: Vec<String> = points.iter().map(|(x, y)| format!("[{x}, {y}]")).collect();
        let curve = format!("bezier([{}], -5, 9)", list.join(", "));
        let query = format!("derive(casteljau, {curve}, {}/{})", u.0, u.1);
        let context = [format!("F(t) := {curve}(t)"), format!("f := polar({curve})")];
        assert_true(&query, &context, &derived(&[], &query));
        let n = points.len() - 1;
        let ends = |x: i64| vec![x.to_string(); n + 1].join(", ");
        let spline = format!("bspline({n}, [{}, {}], [{}])", ends(-5), ends(9), list.join(", "));
        let query = format!("derive(insert, {spline}, {}/{})", u.0, u.1);
        let context = [format!("f := polar({curve})"), format!("U := knots(insert_knots({spline}, {}/{}))", u.0, u.1)];
        assert_true(&query, &context, &derived(&[], &query));
    }
}

/// Every value of the polar form, every product and every root is proved; the changes of sign are counted again.
#[test]
fn real_roots() {
    for (formula, degree, simple, ends) in [
        ("t^3 - 3 t + 1", 3, None, ", -2, 2"),
        ("t^2 - 2", 2, None, ", 0, 2"),
        ("t^2 + 1", 2, None, ", -1, 1"),
        ("2 t^4 - 6 t^2 + 1/3", 4, None, ""),
        ("(t - 1/2)^2 (t - 3)", 3, Some(("(t - 1/2) (t - 3)", 2)), ", 0, 4"),
        ("-3 (t^2 - 2)^3", 6, Some(("t^2 - 2", 2)), ""),
        ("t (2 t - 1) (t - 1)", 3, None, ", 0, 1"),
        ("t - 7", 1, None, ", 0, 10"),
    ] {
        let query = format!("derive(roots, {formula}{ends})");
        let derivation = derived(&[], &query);
        let mut context = polynomials(&[("F", formula, degree)]);
        context.extend(simple.map(|(g, n)| polynomials(&[("G", g, n)])).into_iter().flatten());
        assert!(assert_true(&query, &context, &derivation) > 2, "{query}");
        for line in &derivation.lines {
            let words = line.reason.text(Language::English);
            let value = |one: &Expr| match &one.kind {
                Kind::Chain(_, links) => text(&links[0].expr),
                _ => panic!("{query}: no equation"),
            };
            let count = match words.split(' ').next() {
                Some("no") => 0,
                Some("one") => 1,
                Some(number) if words.contains("changes of sign") => number.parse().unwrap(),
                _ => continue,
            };
            let values: Vec<String> =
                formulas(&line.formula).iter().map(value).filter(|value| value != "0").collect();
            let signs: Vec<bool> = values.iter().map(|value| value.starts_with('-')).collect();
            assert_eq!(signs.windows(2).filter(|pair| pair[0] != pair[1]).count(), count, "{query}: {words}");
        }
    }
    assert_true_in_notes("roots", "", &derived(&[], "derive(roots, (t - 1/2)^2 (t - 3), 0, 4)"));
}

/// All coefficients of a certificate are proved to be values of the polar form, and none is negative.
#[test]
fn signs_on_intervals() {
    for (formula, degree, rest, ends) in [
        ("t^2 - t + 1/3", 2, None, ", 0, 1"),
        ("t^4 - t + 1", 4, None, ""),
        ("t (1 - t)", 2, None, ", 0, 1"),
        ("(t^2 - 2)^2 (t + 1)", 5, Some(("t + 1", 1)), ", -1"),
        ("t^2 (1 - t)", 3, Some(("1 - t", 1)), ", 0, 1"),
        ("(t - 1)^2", 2, Some(("1", 0)), ""),
        ("7", 0, None, ""),
        ("0", 0, None, ", 0, 1"),
        ("2 - t", 1, None, ", 3/2, 2"),
    ] {
        let query = format!("positivity({formula}{ends}, variable=t)");
        let derivation = derived(&[], &query);
        let mut context = polynomials(&[("F", formula, degree)]);
        context.extend(rest.map(|(g, n)| polynomials(&[("G", g, n)])).into_iter().flatten());
        assert!(assert_true(&query, &context, &derivation) > 1, "{query}");
        for line in &derivation.lines {
            if line.reason.text(Language::English).starts_with("no coefficient") {
                assert!(!text(&line.formula).contains("= -"), "{query}: {}", text(&line.formula));
            }
        }
    }
    for (formula, ends) in [("t^2 - t", ", 0, 1"), ("t", ""), ("-7", ""), ("2 - t^2", ", 0, 3")] {
        let query = format!("positivity({formula}{ends}, variable=t)");
        let derivation = derived(&[], &query);
        assert_true(&query, &polynomials(&[("F", formula, 0)]), &derivation);
        assert!(text(&derivation.lines[1].formula).contains("= -"), "{query}");
    }
    assert_true_in_notes("positivity", "", &derived(&[], "positivity((t - 1)^2 (t + 1), 0, 2)"));
}

/// Strict signs, signs of quotients and by a higher degree.
#[test]
fn strict_signs_on_intervals() {
    for (formula, degree, ends) in
        [("t^2 + 1", 2, ", 0, 1"), ("t^2 - t + 1/3", 2, ", 0, 1"), ("t^4 - t + 1", 4, ""), ("7", 0, "")]
    {
        let query = format!("positivity({formula}{ends}, strict=1, variable=t)");
        let derivation = derived(&[], &query);
        assert!(assert_true(&query, &polynomials(&[("F", formula, degree)]), &derivation) > 1, "{query}");
    }
    for (formula, ends) in [("(t - 1)^2", ", 0, 2"), ("t^2 - 2", ", 0, 2"), ("0", ", 0, 1"), ("t", ", 0, 1")]
    {
        let query = format!("positivity({formula}{ends}, strict=1, variable=t)");
        let derivation = derived(&[], &query);
        assert_true(&query, &polynomials(&[("F", formula, 0)]), &derivation);
        let last = text(&derivation.lines[derivation.lines.len() - 1].formula);
        assert!(last.contains("= -") || last.ends_with("= 0"), "{query}: {last}");
    }
    let query = "positivity(t^2 - t + 1/3, 0, 1, degree=5, strict=1)";
    assert_true_in_notes(query, "", &derived(&[], query));
}

/// Each line is true in lecture notes.
#[test]
fn eliminations_and_curves() {
    for query in [
        "derive(sturm, t^3 - 3t + 1)",
        "derive(sturm, (t - 1)^2 (t + 1), 0, 2)",
        "derive(geometric_continuity, bezier([[0, 0], [1, 0], [2, 1]]), bezier([[2, 1], [4, 3], [5, 9]]), 1)",
    ] {
        let shown = derived(&[], query);
        assert!(shown.lines.len() > 4, "{query}");
        assert_true(query, &[], &shown);
    }
    for (query, last) in [
        ("derive(resultant, x - t^2, y - t^3, t)", "det(M) = x^3 - y^2"),
        ("derive(resultant, t^2 - 1, t - 1)", "det(M) = 0"),
        (
            "derive(hull, bezier([[0, 0], [1, 2], [2, 0]]), 1/3)",
            "F(1/3) = 4/9 (0, 0) + 4/9 (1, 2) + 1/9 (2, 0) = (2/3, 8/9)",
        ),
        ("derive(curvature, [t, t^2], 0)", "kappa = 2"),
        (
            "derive(curvature, [t, t^2, t^3], t)",
            "kappa^2 = (E S - D^2)/E^3 = (36 t^4 + 36 t^2 + 4)/(9 t^4 + 4 t^2 + 1)^3",
        ),
        ("derive(sturm, t^3 - t, 0, 2)", "1 - 0 = 1"),
        ("derive(geometric_continuity, bezier([[0, 0], [1, 0]]), bezier([[1, 0], [3, 0]]), 1)", "beta_1 = 2"),
    ] {
        let shown = derived(&[], query);
        assert_eq!(text(&shown.lines[shown.lines.len() - 1].formula), last, "{query}");
    }
}
