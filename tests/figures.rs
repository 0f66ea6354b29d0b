//! Drawings as a reader gets them: well-formed, complete, legible.

use std::process::{Command, Stdio};
use std::{env, fs};

use crate::common::pictures::{bezier, casteljau, formula, points, standard};
use num_traits::pow;
use polarform::expr::Expr;
use polarform::figure::{SvgOptions, Theme, TikzOptions, measure, svg, terminal, tikz};
use polarform::number::{Rational, integer, rational};
use polarform::scene::pictures::{
    BasisPicture, BezierPicture, Curve, Function, PatchPicture, Piece, PyramidPicture, casteljau_labels,
    polar_labels,
};
use polarform::scene::{
    Aspect, Axis, Direction, Ink, Label, Layout, Mark, Marker, Orientation, Path, Scene, SceneError, Shape,
    Spot, Style, Tick, exact_text, layout,
};
use polarform::write::text;
use proptest::prelude::*;

/// What must hold of every page: everything is on it, and no label covers another.
fn check(name: &str, page: &Layout) {
    let (width, height) = (page.width, page.height);
    assert!(
        width.is_finite() && height.is_finite() && width > 0.0 && height > 0.0,
        "{name}: {width} {height}"
    );
    for mark in &page.marks {
        let area = mark.area();
        let inside = area.low[0] >= -0.02
            && area.low[1] >= -0.02
            && area.high[0] <= width + 0.02
            && area.high[1] <= height + 0.02;
        // handles of cubics may lie outside, curves do not
        assert!(inside, "{name}: {mark:?} is outside of {width} by {height}");
    }
    let texts: Vec<_> = page.texts().collect();
    for (i, text) in texts.iter().enumerate() {
        for other in &texts[..i] {
            assert!(text.area.overlap(&other.area) == 0.0, "{name}: {:?} covers {:?}", text.text, other.text);
        }
    }
}

fn well_formed(name: &str, text: &str) {
    let document = roxmltree::Document::parse(text).unwrap_or_else(|e| panic!("{name}: {e}"));
    let root = document.root_element();
    assert_eq!((root.tag_name().name(), root.attribute("role")), ("svg", Some("img")));
    assert!(root.children().any(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "title"))));
    assert!(!text.contains("NaN") && !text.contains("inf"), "{name} has numbers that are none");
}

#[test]
fn standard_pictures_are_legible() {
    for (name, scene) in standard().unwrap() {
        for width in [400.0, 560.0, 640.0, 900.0] {
            let page = layout(&scene.clone().with_width(width), &measure);
            check(name, &page);
            assert_eq!(page.hidden, 0, "{name} at {width} lost labels");
        }
        let page = layout(&scene, &measure);
        // nor do names cover points
        let covered = page.marks.iter().filter(|mark| match mark {
            Mark::Marker { at, .. } => page.texts().any(|text| {
                let [x, y] = *at;
                text.area.low[0] < x && x < text.area.high[0] && text.area.low[1] < y && y < text.area.high[1]
            }),
            _ => false,
        });
        assert_eq!(covered.count(), 0, "{name}");
        assert!(page.width <= 641.0, "{name} is {} wide", page.width);
        for theme in [Theme::Auto, Theme::Light, Theme::Dark] {
            well_formed(name, &svg(&scene, &SvgOptions { theme, background: true }));
        }
        assert_eq!(tikz(&scene, &TikzOptions::default()), tikz(&scene, &TikzOptions::default()));
    }
}

/// Without the many small pieces of surfaces.
fn without_pieces(text: &str) -> String {
    let piece = |line: &&str| {
        line.contains("crispEdges") || (line.contains("fill opacity=") && !line.contains("draw="))
    };
    let pieces = text.lines().filter(piece).count();
    let rest: Vec<&str> = text.lines().filter(|line| !piece(line)).collect();
    if pieces > 3 { format!("{}\n[{pieces} pieces]\n", rest.join("\n")) } else { text.to_owned() }
}

#[test]
fn snapshots() {
    for (name, scene) in standard().unwrap() {
        if ["bezier-several", "basis-bspline", "pyramid", "continuity-broken"].contains(&name) {
            continue;
        }
        insta::assert_snapshot!(format!("{name}.svg"), without_pieces(&svg(&scene, &SvgOptions::default())));
        insta::assert_snapshot!(
            format!("{name}.tikz"),
            without_pieces(&tikz(&scene, &TikzOptions::default()))
        );
    }
}

#[test]
fn on_a_terminal() {
    let basis = standard().unwrap().into_iter().find(|(name, _)| *name == "basis-bernstein").unwrap().1;
    insta::assert_snapshot!("basis.terminal", terminal(&basis, 60, 14));
    insta::assert_snapshot!("bezier.terminal", terminal(&bezier().scene().unwrap(), 50, 14));
    for (columns, rows) in [(1, 1), (3, 100), (0, 0), (200, 2)] {
        let text = terminal(&basis, columns, rows);
        assert!(text.lines().count() <= rows.max(1));
        assert!(text.lines().all(|line| line.chars().count() <= columns.max(1)));
    }
    assert_eq!(terminal(&Scene::new("empty"), 10, 10), "");
}

/// All numbers of a text.
fn numbers(text: &str) -> Vec<f64> {
    let part = |c: char| !(c.is_ascii_digit() || c == '.' || c == '-');
    text.split(part).filter_map(|piece| piece.parse().ok()).collect()
}

#[test]
fn scale_does_not_matter() {
    let factors = [pow(integer(10), 30), pow(integer(10), 30).recip(), pow(integer(10), 140)];
    for factor in &factors {
        let scaled = |points: &[[Rational; 2]]| -> Vec<[Rational; 2]> {
            points.iter().map(|point| [0, 1].map(|k| &point[k] * factor)).collect()
        };
        let mut large = casteljau();
        large.points = scaled(&large.points);
        let (first, second) = (casteljau().scene().unwrap(), large.scene().unwrap());
        let [first, second] = [first, second].map(|scene| numbers(&svg(&scene, &SvgOptions::default())));
        assert_eq!(first.len(), second.len());
        assert!(first.iter().zip(&second).all(|(a, b)| (a - b).abs() < 0.02));
    }
}

#[test]
fn what_does_not_fit_is_refused() {
    let huge = pow(integer(10), 400);
    let curve = Curve::new(vec![[huge.clone(), integer(0)], [integer(0), integer(1)]]);
    let error = BezierPicture::of(curve).scene().unwrap_err();
    assert!(matches!(&error, SceneError::TooLarge { .. }), "{error}");
    assert!(matches!(BezierPicture::of(Curve::new(Vec::new())).scene(), Err(SceneError::Empty { .. })));
    let pole = Curve::rational([[0, 0, 1], [1, 0, -1], [2, 1, 1]].map(|p| p.map(integer)).to_vec());
    assert!(matches!(BezierPicture::of(pole).scene(), Err(SceneError::AtInfinity { .. })));
    let ragged = vec![vec![[0, 0, 0].map(integer)], Vec::new()];
    assert!(matches!(PatchPicture::of(ragged).scene(), Err(SceneError::Shape { .. })));
    let wide = vec![vec![Expr::int(1)], vec![Expr::int(1), Expr::int(2)]];
    assert!(matches!(PyramidPicture::of(wide).scene(), Err(SceneError::Shape { .. })));
    // a constant of any size fits, as a graph of height zero
    let high = Piece { interval: [integer(0), integer(1)], coefficients: vec![pow(integer(10), 100)] };
    let picture =
        BasisPicture::of(vec![Function { pieces: vec![high], label: None }], [integer(0), integer(1)]);
    check("constant", &layout(&picture.scene().unwrap(), &measure));
}

#[test]
fn strange_words_stay_words() {
    let mut scene = Scene::new("<svg> & \"quotes\" \u{0} \u{7}");
    for words in
        ["</text><script>alert(1)</script>", "a & b", "]]>", "\u{1b}[31m\u{fffe}", "\\end{document}", "漢字"]
    {
        scene.add(Label::beside(Spot::default(), words, Direction::East));
    }
    let scene = scene.with_description("--> <!--").with_caption("50% & more");
    let text = svg(&scene, &SvgOptions::default());
    well_formed("strange", &text);
    assert!(!text.contains("<script"));
    assert!(!tikz(&scene, &TikzOptions::default()).contains("{\\end{document}"));
    check("strange", &layout(&scene, &measure));
}

#[test]
fn crowded_pictures_stay_legible() {
    // names for which there is no room are left out and counted
    let curve = Curve::new(vec![[integer(1), integer(2)]; 40])
        .with_labels((0..40).map(|i| Expr::indexed("b", i)).collect());
    let scene = BezierPicture::of(curve).scene().unwrap();
    let page = layout(&scene, &measure);
    check("one place", &page);
    assert_eq!(page.hidden + page.texts().count(), 40);
    assert!(page.hidden > 0 && svg(&scene, &SvgOptions::default()).contains("left out for lack of room"));

    // a scheme is enlarged instead
    let levels = casteljau_labels(&Expr::name("f"), 8, &formula("t_0"), &formula("t_1"), &formula("tau"));
    let picture =
        PyramidPicture { apex: polarform::scene::pictures::Apex::Top, ..PyramidPicture::of(levels) };
    let page = layout(&picture.scene().unwrap(), &measure);
    check("scheme", &page);
    assert_eq!((page.hidden, page.texts().count()), (0, 45));
}

#[test]
fn sizes_that_are_none() {
    let mut scene = Scene::new("sizes").with_width(f64::NAN);
    let [a, b] = [Spot::default(), Spot::new(1.0, 1.0).unwrap()];
    let style = Style { width: f64::NAN, opacity: f64::INFINITY, ..Style::curve(0) };
    scene.add(Path::line(a, b, style).with_arrow());
    scene.add(Path::line(a, a, Style::curve(0)).with_arrow());
    scene.add(
        Marker { radius: f64::NEG_INFINITY, ..Marker::new(a, Shape::Ring, Ink::Accent) }.moved(f64::NAN, 1e9),
    );
    scene.add(Label { gap: f64::NAN, ..Label::beside(b, "b", Direction::West) });
    let axis =
        Axis { orientation: Orientation::Vertical, from: a, length: f64::NAN, ticks: Vec::new(), name: None };
    let tick = |at: f64| Tick { at, label: Some("x".into()) };
    scene.add(Axis { ticks: vec![tick(f64::NAN), tick(0.5), tick(f64::INFINITY)], ..axis });
    scene = scene.with_aspect(Aspect::Free { height: f64::NAN });
    check("sizes", &layout(&scene, &measure));
    well_formed("sizes", &svg(&scene, &SvgOptions::default()));
    terminal(&scene, 10, 10);
}

#[test]
fn high_degree() {
    let list = (0..=60).map(|i: i64| [integer(i), integer(if i % 2 == 0 { 0 } else { 9 })]).collect();
    let scene = BezierPicture::of(Curve::new(list)).scene().unwrap();
    check("degree 60", &layout(&scene, &measure));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn any_curve_can_be_drawn(
        list in proptest::collection::vec((-3_i64..4, -3_i64..4), 1..7),
        weights in proptest::collection::vec(1_i64..4, 7),
        tiny in any::<bool>(),
        hull in any::<bool>(),
    ) {
        let unit = if tiny { pow(integer(10), 160).recip() } else { integer(1) };
        let homogeneous = list.iter().zip(&weights).map(|(&(x, y), &w)| {
            [integer(w * x) * &unit, integer(w * y), integer(w)]
        });
        let labels = polar_labels(&Expr::name("f"), list.len() - 1, &Expr::int(0), &Expr::int(1));
        let curve = Curve::rational(homogeneous.collect()).with_labels(labels);
        let picture = BezierPicture { hull, parameters: vec![integer(1) / integer(3)], ..BezierPicture::of(curve) };
        let scene = picture.scene().unwrap();
        check("any", &layout(&scene, &measure));
        well_formed("any", &svg(&scene, &SvgOptions::default()));
        prop_assert!(!tikz(&scene, &TikzOptions::default()).contains("NaN"));
        terminal(&scene, 20, 10);
    }
}

fn finds(program: &str, arguments: &[&str]) -> bool {
    let run = Command::new(program).args(arguments).stdout(Stdio::null()).stderr(Stdio::null()).status();
    run.is_ok_and(|status| status.success())
}

/// Where LaTeX with TikZ is installed, it accepts all pictures, in a document and alone.
#[test]
fn latex_accepts_the_pictures() {
    if !finds("pdflatex", &["--version"]) || !finds("kpsewhich", &["tikz.sty"]) {
        return;
    }
    let folder = env::temp_dir().join(format!("polarform-figures-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let mut document = String::from("\\documentclass{article}\n\\usepackage{tikz}\n\\begin{document}\n");
    for (_, scene) in standard().unwrap() {
        document.push_str(&tikz(&scene, &TikzOptions::default()));
        document.push_str("\n\\clearpage\n");
    }
    document.push_str("\\end{document}\n");
    compile(&folder, "all", &document);
    if finds("kpsewhich", &["standalone.cls"]) {
        compile(&folder, "alone", &tikz(&bezier().scene().unwrap(), &TikzOptions { standalone: true }));
    }
    fs::remove_dir_all(&folder).unwrap();
}

fn compile(folder: &std::path::Path, name: &str, document: &str) {
    fs::write(folder.join(format!("{name}.tex")), document).unwrap();
    let run = Command::new("pdflatex")
        .args(["-interaction=nonstopmode", "-halt-on-error", &format!("{name}.tex")])
        .current_dir(folder)
        .output()
        .unwrap();
    let log = String::from_utf8_lossy(&run.stdout);
    assert!(run.status.success() && folder.join(format!("{name}.pdf")).exists(), "{log}");
}

#[test]
fn panels_share_the_width() {
    let one = BezierPicture::of(Curve::new(points(&[[0, 0], [1, 1], [3, 0]]))).scene().unwrap();
    let three = one.clone().beside(one.clone()).beside(one).with_width(640.0);
    let page = layout(&three, &measure);
    check("three", &page);
    assert!((page.width - 640.0).abs() < 8.0, "{}", page.width);
}

#[test]
fn numbers_on_axes_are_exact_and_short() {
    let written = |value: &Rational| text(&exact_text(value));
    assert_eq!(written(&pow(integer(10), 30)), "10^30");
    assert_eq!(written(&(integer(-3) / pow(integer(10), 9))), "-3/1000000000");
    assert_eq!(written(&pow(integer(10), 9).recip()), "10^(-9)");
    assert_eq!(written(&integer(123_450)), "123450");
    assert_eq!(written(&rational(5, 2)), "5/2");
    assert_eq!(written(&integer(0)), "0");
}

/// Rational surfaces, also of several patches, are drawn as they are: on the sphere.
#[test]
fn rational_surfaces_are_drawn() {
    let mut session = polarform::session::Session::default();
    let mut draw = |query: &str| match session.run(query).map(|answer| answer.outcome.value) {
        Ok(polarform::value::Value::Figure(scene)) => layout(&scene, &measure),
        other => panic!("{query}: {other:?}"),
    };
    for query in [
        "figure_patch(sphere_octant([0, 0, 0], 1))",
        "figure_patch(revolve(bezier([[1, 0], [2, 1]])))",
        "figure_patch(patch([[[0, 0, 0], [1, 0, 1]], [[0, 1, 1], [1, 1, 0]]], weights=[[1, 2], [3, 4]]))",
    ] {
        check(query, &draw(query));
    }
    // The weights of a patch are those of its points: all alike they change nothing.
    let net = "[[[0, 0, 0], [1, 0, 1]], [[0, 1, 1], [1, 1, 0]]]";
    let plain = draw(&format!("figure_patch(patch({net}))"));
    let weighted = draw(&format!("figure_patch(patch({net}, weights=[[2, 2], [2, 2]]))"));
    assert!((plain.width - weighted.width).abs() < 0.1 && (plain.height - weighted.height).abs() < 0.1);
    let infinite =
        "figure_patch(patch([[[0, 0, 0, 1], [1, 0, 1, 0]], [[0, 1, 1, 1], [1, 1, 0, 1]]], homogeneous=1))";
    let problem = session.run(infinite).unwrap_err().problem;
    assert!(problem.message.contains("infinity"), "{}", problem.message);
}
