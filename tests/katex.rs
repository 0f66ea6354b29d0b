//! A real renderer accepts the LaTeX that is written.

use std::fs;
use std::process::Command;

use crate::common::expressions::{any_polar, samples, shared, statement, value};
use katex::Opts;
use polarform::blossom::Method;
use polarform::derive::{self, Names};
use polarform::functions::BUILTINS;
use polarform::session::Session;
use polarform::value::{Language, Notation, Value};
use polarform::write::{Format, latex, latex_table, write_derivation};

const NOTATIONS: [Notation; 4] = [Notation::Grouped, Notation::Expanded, Notation::Sigma, Notation::Ellipsis];

/// The LaTeX of a value in every notation, and of all steps that lead to a polar form.
fn write_down(formulas: &mut Vec<String>, value: &Value) {
    match value {
        Value::Table(table) => formulas.push(latex_table(table)),
        _ => formulas.extend(NOTATIONS.iter().map(|&notation| latex(&value.display_expr(notation)))),
    }
    if let Value::Polar(polar) = value {
        for method in Method::ALL {
            let lines = derive::polar(polar, method, &Names::default()).lines;
            formulas.extend(lines.iter().map(|line| latex(&line.formula)));
        }
    }
}

/// Derivations of every kind, as LaTeX.
fn derivations(language: Language) -> Vec<String> {
    let spline = "bspline(2, [0, 0, 0, 1, 2, 2, 2], [[1, 1], [3, 0], [2, 5], [4, 1]])";
    let mut queries: Vec<String> = [
        "derive(sum, t^4 - 1, t)",
        "derive(product, c_0 + c_1 t, t^2)",
        "derive(compose, c_0 + c_1 t, t^2)",
        "derive(derivative, t^5 - t/2, 4)",
        "derive(elevate, t^2 + 2t, 2)",
        "derive(elevate, bezier([[0, 0], [1, 2], [2, 0]]))",
        "derive(matrix, 3)",
        "derive(inverse_matrix, 3)",
        "derive(casteljau, bezier([b_0, b_1, b_2], r, s), t)",
        "derive(casteljau, bezier([[1, 0], [1, 1], [0, 1]], weights=[1, 1, 2]), 1/2)",
        "derive(deboor, bspline(2, [t_0, t_1, t_2, t_3, t_4, t_5], [d_0, d_1, d_2]), t, span=2)",
        "derive(join, bezier([b_0, b_1, b_2]), bezier([c_0, c_1, c_2], 1, 2), 2)",
        "derive(join, bezier([0, 1, 2]), bezier([2, 3, 5], 1, 2), 2)",
        "derive(newton, [0, 1, 3], [1, 2, 10])",
        "derive(newton, [0, 0, 1], [[1, 1], [2, 0], [4, 4]])",
        "derive(moments, [0, 1, 2, 4], [0, 1, 0, 2])",
        "derive(moments, [0, 1, 2], [[0, 0], [1, 1], [0, 0]], ends=periodic)",
        "derive(moments, [0, 1, 2], [0, 1, 0], slopes=[-1, s])",
        "derive(moments, [0, 1, 2, 3], [0, 1, 8, 27], ends=not_a_knot)",
        "derive(polar, polar_tensor(u v, u, v, 2, 1))",
        "derive(polar, polar_total(u v, [u, v], degree=2))",
    ]
    .map(str::to_owned)
    .to_vec();
    queries.extend(["deboor", "insert"].map(|what| format!("derive({what}, {spline}, 3/2)")));
    for method in Method::ALL {
        let subjects = ["c_0 + c_1 t + c_2 t^2", "t^3 + 3 t^2 + 5 t + 1", "[t, t^2]", "7"];
        queries.extend(subjects.map(|f| format!("derive(polar, {f}, method={method}, variable=t)")));
    }
    let written = queries.iter().map(|query| {
        let answer = Session::default().run(query).unwrap_or_else(|f| panic!("{query}: {:?}", f.problem));
        let Value::Derivation(derivation) = answer.outcome.value else { panic!("{query}") };
        write_derivation(&derivation, Format::Latex, language).expect("LaTeX has all signs")
    });
    written.collect()
}

/// All the LaTeX of the examples, of typical statements and of random values.
fn formulas() -> Vec<String> {
    let mut formulas: Vec<String> = Vec::new();
    for builtin in BUILTINS {
        let answer = Session::default().run(builtin.example).expect("the examples run");
        write_down(&mut formulas, &answer.outcome.value);
    }
    let mut session = Session::default();
    for statement in [
        "F(t) := c_0 + c_1 t + c_2 t^2 + c_3 t^3",
        "f := polar(F)",
        "f(t, t, 1) - f(t, t, 0)",
        "[f(0, 0, 0), f(0, 0, 1), f(0, 1, 1), f(1, 1, 1)]",
        "bezier_points(f, r, s)",
        "polar(t^3 + 3t^2 + 5t + 1)",
        "polar_product(t^2 + 2t, t^3 + 1)",
        "polar_compose(t^2 + 2t, t^3 + 1)",
        "polar_total(u v, [u, v], degree=2)",
        "polar_tensor(u v, u, v, 2, 2)",
        "power_to_bernstein(3)",
        "change_of_basis(2, [bernstein, r, s], power)",
        "B(i, n, t) := binomial(n, i) t^i (1 - t)^(n - i)",
        "G := x -> x/(1 + x)",
        "hat(1/2)",
        "-t_1^2/alpha_1 + p_{1,2}",
        "polar(7)",
        "polar(0)",
        "F' = 3",
    ] {
        let answer = session.run(statement).unwrap_or_else(|f| panic!("{statement}: {:?}", f.problem));
        write_down(&mut formulas, &answer.outcome.value);
        formulas.push(latex(&answer.statement));
    }
    samples(&value(), 60).iter().for_each(|value| write_down(&mut formulas, value));
    samples(&any_polar(), 12).into_iter().map(shared).for_each(|polar| write_down(&mut formulas, &polar));
    formulas.extend(samples(&statement(), 250).iter().map(latex));
    formulas.sort();
    formulas.dedup();

    formulas.extend(derivations(Language::English));
    for command in ["sum", "product", "compose"] {
        formulas
            .push(crate::common::run(&[command, "t^2 + 2t", "t^3 + 1", "--format", "latex", "--steps"]).out);
    }

    assert!(formulas.len() > 500, "only {} formulas", formulas.len());
    formulas
}

/// One test for everything: starting the renderer is what takes time.
#[test]
fn everything_written_is_accepted() {
    let mut formulas = formulas();
    formulas.extend(derivations(Language::Chinese));
    let options = Opts::builder()
        .display_mode(true)
        .throw_on_error(true)
        .output_type(katex::OutputType::Mathml)
        .build()
        .expect("all options have defaults");
    assert!(katex::render_with_opts(r"\frac{1}{", &options).is_err(), "the renderer is strict");
    assert!(katex::render_with_opts(r"\nonsense", &options).is_err(), "the renderer is strict");
    for formula in &formulas {
        if let Err(error) = katex::render_with_opts(formula, &options) {
            panic!("{formula}: {error}");
        }
    }
}

/// The same with TeX itself, where there is one.
#[test]
fn tex_accepts_everything_written() {
    let present = Command::new("pdflatex").arg("--version").output().is_ok_and(|ran| ran.status.success());
    if !present {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let mut text =
        String::from("\\documentclass{article}\n\\usepackage{amsmath,amssymb,tikz}\n\\begin{document}\n");
    let formulas = formulas();
    for (i, formula) in formulas.iter().enumerate() {
        // Pictures are no formulas; the number of a formula is told if it fails.
        text += &match formula.contains("tikzpicture") {
            true => format!("\\typeout{{FORMULA {i}}}\n{formula}\n\n"),
            false => format!("\\typeout{{FORMULA {i}}}\n\\[ {formula} \\]\n"),
        };
    }
    text += "\\end{document}\n";
    fs::write(folder.path().join("all.tex"), text).unwrap();
    let ran = Command::new("pdflatex")
        .args(["-interaction=nonstopmode", "-halt-on-error", "-draftmode", "all.tex"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    let log = String::from_utf8_lossy(&ran.stdout);
    if !ran.status.success() {
        let number: Option<usize> = log
            .lines()
            .rev()
            .find_map(|line| line.strip_prefix("FORMULA ").and_then(|rest| rest.trim().parse().ok()));
        let error: Vec<&str> = log.lines().skip_while(|line| !line.starts_with('!')).take(4).collect();
        panic!("{}\n{}", number.map_or("", |i| formulas[i].as_str()), error.join("\n"));
    }
}
