//! `polarform figure` and figures as values, from outside.

use std::fs;

use crate::common::{FORMATS, run};
use polarform::session::Session;
use polarform::value::Value;
use proptest::prelude::*;

const CURVE: &str = "[0,0], [1,2], [3,2]";

fn drawn(query: &str) -> polarform::scene::Scene {
    let answer = Session::default().run(query);
    match answer.unwrap_or_else(|failure| panic!("{query}: {}", failure.problem.message)).outcome.value {
        Value::Figure(scene) => (*scene).clone(),
        other => panic!("{query} is {}", other.kind()),
    }
}

fn svg_of(arguments: &[&str]) -> String {
    let ran = run(&[&["figure"], arguments].concat());
    assert_eq!(ran.status, Some(0), "{arguments:?}: {}", ran.err);
    assert!(roxmltree::Document::parse(&ran.out).is_ok(), "{arguments:?}");
    ran.out
}

#[test]
fn every_kind_is_drawn() {
    let spline = "bspline(2, [0,0,0,1,2,2,2], [[0,0],[1,3],[4,3],[5,0]])";
    for arguments in [
        &["bezier", CURVE][..],
        &["bezier", CURVE, "bezier([[0,1],[2,2]])", "--at", "1/2", "--hull", "--no-polygon"],
        &["bezier", "bezier([[0,0,0],[1,0,2],[1,2,2]])"],
        &["bezier", r"\frac{1}{2} t^2 + t"],
        &["casteljau", CURVE, "1/3"],
        &["casteljau", CURVE, "-1", "--labels", "points"],
        &["bspline", spline, "--bezier-points"],
        &["basis", "3"],
        &["basis", "2", "[0,0,0,1,1,1]"],
        &["functions", "[t, t^2], -1, 1"],
        &["functions", "bspline_basis(1, [0, 1, 2, 3])"],
        &["functions", "[piecewise([0, 1, 2], [t, 2 - t], outside=0), t]", "-1", "3"],
        &["patch", "[0,1], [1,0]", "--labels", "polar"],
        &["patch", "patch([[[0,0,0],[0,1,1]],[[1,0,1],[1,1,0]]])"],
        &["triangle", "2", "[r,s,t]"],
        &["triangle", "[0,1,1,0,2,0]", "--labels", "points"],
        &["continuity", CURVE, "bezier([[3,2],[5,2],[6,0]], 1, 2)", "--order", "1"],
        &["pyramid", "bezier([b_0, b_1, b_2], r, s)", "t", "--apex", "bottom", "--no-weights"],
        &["pyramid", spline, "1/2", "--labels", "values"],
        &["pyramid", "[x_0, x_0, x_1]", "[y_0, z_0, y_1]"],
        &["hodograph", CURVE, "--labels", "polar"],
        &["hodograph", "bezier([0, 3, 1])"],
        &[
            "query",
            "beside(figure_basis(n), figure_bezier(c))",
            "--given",
            "n := 2",
            "--given",
            "c := [0, 1]",
        ],
    ] {
        svg_of(arguments);
    }
}

#[test]
fn the_file_says_what_is_written() {
    let folder = tempfile::tempdir().unwrap();
    for (name, start) in [
        ("a.svg", "<svg"),
        ("a.tex", "% Bézier curve\n\\begin{tikzpicture}"),
        ("a.TIKZ", "% "),
        ("a.txt", ""),
        ("a.json", "{\"kind\":\"figure\",\"title\":\"Bézier curve\""),
    ] {
        let path = folder.path().join(name);
        let ran = run(&["figure", "bezier", CURVE, "-o", path.to_str().unwrap()]);
        assert_eq!((ran.status, ran.out.as_str()), (Some(0), ""), "{name}: {}", ran.err);
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.starts_with(start) && text.ends_with('\n'), "{name}: {text}");
    }
    // what is asked for goes before the name
    let path = folder.path().join("b.txt");
    run(&["figure", "bezier", CURVE, "--format", "svg", "-o", path.to_str().unwrap()]);
    assert!(fs::read_to_string(&path).unwrap().starts_with("<svg"));
}

/// Without fonts on the system there are neither PDF nor PNG, and that is said.
#[test]
fn pdf_and_png() {
    let folder = tempfile::tempdir().unwrap();
    let drawn = |name: &str, more: &[&str]| {
        let path = folder.path().join(name);
        let ran = run(&[&["figure", "bezier", CURVE, "-o", path.to_str().unwrap()], more].concat());
        if ran.status != Some(0) {
            assert!(ran.err.contains("no fonts"), "{name}: {}", ran.err);
            return None;
        }
        Some(fs::read(path).unwrap())
    };
    if let Some(pdf) = drawn("a.pdf", &[]) {
        assert!(
            pdf.starts_with(b"%PDF-") && pdf.windows(6).any(|bytes| bytes == b"/Font " || bytes == b"/Fonts")
        );
    }
    if let Some(png) = drawn("a.png", &["--width", "200"]) {
        assert!(png.starts_with(b"\x89PNG\r\n\x1a\n"));
        // The width stands in the first chunk.
        assert_eq!(u32::from_be_bytes(png[16..20].try_into().unwrap()), 400);
        assert!(drawn("b.png", &["--width", "200"]) == Some(png), "the same picture twice");
    }
}

#[test]
fn files_that_cannot_be_written() {
    let folder = tempfile::tempdir().unwrap();
    let inside = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let old = inside("old.svg");
    fs::write(&old, "old").unwrap();
    for (file, query, code) in [
        (inside("missing/a.svg"), CURVE, "E501"),
        (folder.path().to_str().unwrap().to_owned(), CURVE, "E502"),
        (inside("a.gif"), CURVE, "E502"),
        (inside("a"), CURVE, "E502"),
        (old.clone(), "[0, 0], [a, 1]", "E321"),
        (old.clone(), "[0, 0], [1", "E104"),
    ] {
        let ran = run(&["figure", "bezier", query, "-o", &file]);
        assert_eq!((ran.status, ran.out.as_str()), (Some(2), ""), "{file}");
        assert!(ran.err.starts_with(&format!("error[{code}]")), "{file}: {}", ran.err);
        assert!(ran.err.contains("= help:"), "{file}: {}", ran.err);
    }
    assert_eq!(fs::read_to_string(&old).unwrap(), "old");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "nothing else is left behind");
}

#[test]
fn usage() {
    for arguments in [
        &["figure", "bezier", CURVE, "--format", "sympy"][..],
        &["figure", "query", "t^2"],
        &["figure", "basis", "3", "--hull"],
        &["figure", "circle", "3"],
        &["figure", "basis"],
        &["figure", "basis", "3", "--width", "20"],
        &["eval", "t^2", "--format", "svg"],
        &["eval", "figure_basis(1)", "--format", "sympy"],
    ] {
        let ran = run(arguments);
        assert_eq!((ran.status, ran.out.as_str()), (Some(2), ""), "{arguments:?}");
        assert!(ran.err.starts_with("error") && !ran.err.contains("panicked"), "{arguments:?}: {}", ran.err);
    }
}

#[test]
fn looks() {
    let plain = svg_of(&["basis", "2"]);
    assert!(plain.contains("pf-auto") && !plain.contains("class=\"paper\""));
    let dark = svg_of(&["basis", "2", "--theme", "dark", "--standalone", "--width", "300"]);
    assert!(dark.contains("pf-dark") && dark.contains("class=\"paper\""));
    let words = svg_of(&["basis", "2", "--title", "a \"b\" <c>", "--caption", "below & beyond"]);
    assert!(
        words.contains("<title>a &quot;b&quot; &lt;c&gt;</title>") && words.contains("below &amp; beyond")
    );
    let document = run(&["figure", "basis", "2", "--standalone", "--format", "latex"]).out;
    assert!(document.contains("\\begin{document}"));
}

#[test]
fn figures_in_every_format() {
    let starts =
        ["1⡇", "1⡇", "% Bernstein polynomials of degree 1\n\\begin{tikzpicture}", "{\"kind\":\"figure\""];
    for (format, start) in FORMATS.iter().zip(starts) {
        let ran = run(&["eval", "figure_basis(1)", "--format", format]);
        assert!(ran.status == Some(0) && ran.out.starts_with(start), "{format}: {}{}", ran.out, ran.err);
    }
    // in a list, and under a name
    let list = run(&["eval", "[figure_basis(1), 2]", "--format", "json"]).out;
    let list: serde_json::Value = serde_json::from_str(&list).unwrap();
    assert!(list["items"][0]["svg"].as_str().unwrap().starts_with("<svg"));
    assert!(list["items"][0]["tikz"].as_str().unwrap().contains("tikzpicture"));
    assert_eq!(list["items"][1]["number"], "2");
    assert!(run(&["eval", "p := figure_basis(1)"]).out.starts_with("p =\n1⡇"));
    assert_eq!(run(&["eval", "[figure_basis(1)]"]).out, "[\"figure: Bernstein polynomials of degree 1\"]\n");
}

#[test]
fn the_ways_to_a_curve_agree() {
    let curve = drawn("figure_bezier(bezier([[0, 0], [1, 2], [3, 2]]))");
    for query in [
        "figure_bezier([[0, 0], [1, 2], [3, 2]])",
        "figure_bezier([0, 0; 1, 2; 3, 2])",
        "figure_bezier([bezier([[0, 0], [1, 2], [3, 2]])])",
        "figure_bezier(curve_of([t^2 + 2t, 4t - 2t^2]))",
    ] {
        assert_eq!(drawn(query), curve, "{query}");
    }
    // the parameter is that of the curve, and where it is drawn does not depend on the interval
    let marked = |query: &str| drawn(query).panels()[0].items.len();
    assert_eq!(
        marked("figure_bezier(bezier([[0, 0], [1, 2]], 2, 4), at=[2, 3])"),
        marked("figure_bezier([[0, 0], [1, 2]], at=[0, 1/2])")
    );
    // symbols may name the interval
    assert_eq!(
        marked("figure_bezier(bezier([[0, 0], [1, 2]], r, s), at=(r + s)/2)"),
        marked("figure_bezier([[0, 0], [1, 2]], at=1/2)")
    );
}

#[test]
fn joins_are_told() {
    let second = |x: i64| format!("bezier([[2, 2], [3, 2], [{x}, 0]], 1, 2)");
    let described = |x| drawn(&format!("figure_continuity(bezier([[0, 0], [1, 2], [2, 2]]), {})", second(x)));
    // f(2, 2) of the left curve is (4, 0)
    assert!(described(4).description().contains("the same polynomial"));
    assert!(described(5).description().contains("continuous first derivative, and no more"));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// Any points: a figure or an error with a place, never a panic.
    #[test]
    fn any_points(
        rows in prop::collection::vec(prop::collection::vec(-3_i64..4, 0..4), 0..5),
        kind in prop::sample::select(vec!["bezier", "casteljau", "hodograph", "patch", "triangle", "functions", "basis", "pyramid", "continuity", "bspline"]),
        second in prop::sample::select(vec!["", ", 1/2", ", [r, s, t]", ", [0, 0, 1, 1]", ", bezier([[0, 0], [1, 1]], 1, 2)"]),
    ) {
        let list = |row: &Vec<i64>| format!("[{}]", row.iter().map(i64::to_string).collect::<Vec<_>>().join(", "));
        let rows: Vec<String> = rows.iter().map(list).collect();
        let query = format!("figure_{kind}([{}]{second})", rows.join(", "));
        match Session::default().run(&query) {
            Ok(answer) => prop_assert!(matches!(answer.outcome.value, Value::Figure(_)), "{}", query),
            Err(failure) => {
                prop_assert!(failure.problem.code != polarform::diagnostic::Code::Internal, "{}", query);
                prop_assert!(failure.problem.span.is_some() && !failure.problem.hints.is_empty(), "{}: {:?}", query, failure.problem);
            }
        }
    }
}
