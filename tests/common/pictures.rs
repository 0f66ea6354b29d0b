//! One picture of each kind, as a lecturer would want it.

use polarform::expr::Expr;
use polarform::number::{Rational, integer as z, rational as q};
use polarform::scene::pictures::{
    Apex, BasisPicture, BezierPicture, BsplinePicture, CasteljauPicture, ContinuityPicture, Curve, Function,
    HodographPicture, Knot, PatchPicture, Piece, Plane, PyramidPicture, TriangleDomain, TrianglePicture,
    bspline_labels, casteljau_labels, polar_labels, triangle_labels,
};
use polarform::scene::{Scene, SceneError};
use polarform::syntax::parse;

pub fn points(list: &[[i64; 2]]) -> Vec<Plane> {
    list.iter().map(|point| point.map(z)).collect()
}

pub fn formula(text: &str) -> Expr {
    parse(text).expect("the formulas of the examples can be read")
}

fn int(value: i64) -> Expr {
    Expr::int(value)
}

fn indexed(base: &str, count: usize) -> Vec<Expr> {
    (0..count).map(|i| Expr::indexed(base, i as i64)).collect()
}

/// Every kind with its name.
pub fn standard() -> Result<Vec<(&'static str, Scene)>, SceneError> {
    Ok(vec![
        ("bezier", bezier().scene()?),
        ("bezier-several", several().scene()?),
        ("bezier-rational", circle().scene()?),
        ("casteljau", casteljau().scene()?),
        ("bspline", bspline().scene()?),
        ("basis-bernstein", bernstein().scene()?),
        ("basis-bspline", bspline_basis().scene()?),
        ("basis-negative", hermite().scene()?),
        ("pyramid", pyramid().scene()?),
        ("pyramid-weights", weights(Apex::Right).scene()?),
        ("pyramid-top", weights(Apex::Top).scene()?),
        ("patch", patch().scene()?),
        ("triangle-domain", domain().scene()?),
        ("triangle", triangle().scene()?),
        ("continuity", continuity().scene()?),
        ("continuity-broken", broken().scene()?),
        ("hodograph", hodograph().scene()?.with_width(640.0)),
    ])
}

const ARCH: [[i64; 2]; 4] = [[0, 0], [1, 3], [4, 4], [6, 1]];

pub fn bezier() -> BezierPicture {
    let labels = polar_labels(&Expr::name("f"), 3, &int(0), &int(1));
    let curve = Curve::new(points(&ARCH)).with_labels(labels);
    BezierPicture { hull: true, parameters: vec![q(1, 3), q(2, 3)], ..BezierPicture::of(curve) }
}

fn several() -> BezierPicture {
    let first = Curve::new(points(&ARCH)).with_labels(indexed("b", 4)).named(formula("F(t)"));
    let second = Curve::new(points(&[[0, 3], [2, 0], [5, 0], [4, 5], [7, 4]]))
        .with_labels(indexed("c", 5))
        .named(formula("G(t)"));
    BezierPicture { curves: vec![first, second], ..BezierPicture::of(Curve::new(Vec::new())) }
}

/// A quarter of a circle, and the complementary arc with the opposite weight.
fn circle() -> BezierPicture {
    let arc = |w: i64| {
        let list = [[5, 0, 5], [4 * w, 4 * w, 4 * w], [0, 5, 5]];
        Curve::rational(list.into_iter().map(|point| point.map(z)).collect())
    };
    let first = arc(1).with_labels(indexed("b", 3)).named(formula("w = 4/5"));
    BezierPicture { curves: vec![first, arc(2).named(formula("w = 8/5"))], ..BezierPicture::of(arc(1)) }
}

pub fn casteljau() -> CasteljauPicture {
    CasteljauPicture {
        points: points(&ARCH),
        t: q(2, 5),
        labels: casteljau_labels(&Expr::name("f"), 3, &int(0), &int(1), &Expr::name("t")),
    }
}

/// Degree 3 over the knots 0, 0, 0, 1, 2, 3, 3, 3.
fn bspline() -> BsplinePicture {
    let knots = [0, 0, 0, 1, 2, 3, 3, 3];
    let boor = points(&[[0, 0], [0, 4], [4, 6], [8, 5], [10, 1], [7, -1]]);
    // Bézier points of the piece over [a, b]: values of the polar form, by de Boor's algorithm
    let value = |piece: usize, arguments: [i64; 3]| -> Plane {
        let mut row: Vec<Plane> = boor[piece..piece + 4].to_vec();
        for (level, u) in arguments.into_iter().enumerate() {
            for i in 0..3 - level {
                let (low, high) = (knots[piece + i + level], knots[piece + i + 3]);
                let t = q(u - low, high - low);
                row[i] = [0, 1].map(|k| (z(1) - &t) * &row[i][k] + &t * &row[i + 1][k]);
            }
        }
        row.swap_remove(0)
    };
    let piece = |i: usize| {
        let (a, b) = (i as i64, i as i64 + 1);
        Curve::new([[a, a, a], [a, a, b], [a, b, b], [b, b, b]].map(|list| value(i, list)).to_vec())
    };
    BsplinePicture {
        pieces: (0..3).map(piece).collect(),
        points: Curve::new(boor.clone()).with_labels(bspline_labels(&Expr::name("f"), 3, &knots.map(int))),
        knots: (0..4).map(int).collect(),
        bezier_points: false,
    }
}

/// Power coefficients of B_i^n over [0, 1].
fn bernstein_coefficients(n: usize, i: usize) -> Vec<Rational> {
    let binomial = |n: usize, k: usize| Rational::from_integer(polarform::number::binomial(n, k));
    (0..=n)
        .map(|k| match k.checked_sub(i) {
            Some(j) => binomial(n, i) * binomial(n - i, j) * z(if j % 2 == 0 { 1 } else { -1 }),
            None => z(0),
        })
        .collect()
}

fn bernstein() -> BasisPicture {
    let function = |i: usize| Function {
        pieces: vec![Piece { interval: [z(0), z(1)], coefficients: bernstein_coefficients(3, i) }],
        label: Some(formula(&format!("B_{i}^3"))),
    };
    BasisPicture::of((0..4).map(function).collect(), [z(0), z(1)])
}

/// The polynomial pieces of N_i^n over integer knots, by the recurrence, as power coefficients.
fn spline_pieces(knots: &[i64], i: usize, n: usize) -> Vec<(usize, Vec<Rational>)> {
    if n == 0 {
        return if knots[i] < knots[i + 1] { vec![(i, vec![z(1)])] } else { Vec::new() };
    }
    let mut sum: Vec<(usize, Vec<Rational>)> = Vec::new();
    // (t − a)/(b − a) times one function, (b − t)/(b − a) times the other
    let pairs = [(i, knots[i], knots[i + n], 1), (i + 1, knots[i + n + 1], knots[i + 1], -1)];
    for (index, zero, one, _) in pairs {
        if zero == one {
            continue;
        }
        for (interval, coefficients) in spline_pieces(knots, index, n - 1) {
            let mut product = vec![z(0); n + 1];
            for (k, c) in coefficients.iter().enumerate() {
                product[k] += c * q(-zero, one - zero);
                product[k + 1] += c * q(1, one - zero);
            }
            match sum.iter_mut().find(|(other, _)| *other == interval) {
                Some((_, total)) => total.iter_mut().zip(product).for_each(|(a, b)| *a += b),
                None => sum.push((interval, product)),
            }
        }
    }
    sum.sort_by_key(|(interval, _)| *interval);
    sum
}

fn bspline_basis() -> BasisPicture {
    let knots = [0, 0, 0, 0, 1, 2, 4, 4, 4, 4];
    let function = |i: usize| Function {
        pieces: spline_pieces(&knots, i, 3)
            .into_iter()
            .map(|(k, coefficients)| Piece { interval: [z(knots[k]), z(knots[k + 1])], coefficients })
            .collect(),
        label: Some(formula(&format!("N_{i}^3"))),
    };
    let knot = |at: i64, multiplicity: usize| Knot { at: z(at), multiplicity, label: None };
    BasisPicture {
        knots: vec![knot(0, 4), knot(1, 1), knot(2, 1), knot(4, 4)],
        ..BasisPicture::of((0..6).map(function).collect(), [z(0), z(4)])
    }
}

fn hermite() -> BasisPicture {
    let function = |i: i64, coefficients: [i64; 4]| Function {
        pieces: vec![Piece { interval: [z(0), z(1)], coefficients: coefficients.map(z).to_vec() }],
        label: Some(Expr::indexed("H", i)),
    };
    let functions = vec![
        function(0, [1, 0, -3, 2]),
        function(1, [0, 1, -2, 1]),
        function(2, [0, 0, -1, 1]),
        function(3, [0, 0, 3, -2]),
    ];
    BasisPicture::of(functions, [z(0), z(1)])
}

fn pyramid() -> PyramidPicture {
    let levels = casteljau_labels(&Expr::name("f"), 3, &Expr::name("r"), &Expr::name("s"), &Expr::name("t"));
    PyramidPicture { marked: vec![(3, 0)], ..PyramidPicture::of(levels) }
}

fn weights(apex: Apex) -> PyramidPicture {
    let levels = casteljau_labels(&Expr::name("f"), 3, &int(0), &int(1), &Expr::name("t"));
    let pair = [formula("1 - t"), formula("t")];
    let weights = (1..4).map(|level| vec![pair.clone(); 4 - level]).collect();
    PyramidPicture { weights, apex, ..PyramidPicture::of(levels) }
}

fn patch() -> PatchPicture {
    let heights = [[0, 2, 1, 0], [1, 4, 3, 1], [1, 3, 4, 2], [0, 1, 2, 1]];
    let point = |(i, j): (usize, usize)| [z(2 * i as i64), z(2 * j as i64), z(heights[i][j])];
    PatchPicture {
        labels: (0..4).map(|i| (0..4).map(|j| formula(&format!("b_{{{i}{j}}}"))).collect()).collect(),
        ..PatchPicture::of((0..4).map(|i| (0..4).map(|j| point((i, j))).collect()).collect())
    }
}

fn domain() -> TriangleDomain {
    let name = Expr::name;
    TriangleDomain { degree: 3, labels: triangle_labels(&name("f"), 3, [&name("a"), &name("b"), &name("c")]) }
}

fn triangle() -> TrianglePicture {
    let heights = [0, 2, 1, 2, 4, 2, 0, 3, 2, 1];
    let mut list = Vec::new();
    let mut labels = Vec::new();
    for i in (0..4_i64).rev() {
        for j in (0..=3 - i).rev() {
            list.push([z(2 * i), z(2 * j), z(heights[list.len()])]);
            labels.push(formula(&format!("b_{{{i}{j}{}}}", 3 - i - j)));
        }
    }
    TrianglePicture { degree: 3, points: list, labels, polygon: true }
}

fn continuity() -> ContinuityPicture {
    // two derivatives agree: the construction ends in b_1 and b_2 of the right curve
    ContinuityPicture {
        left: points(&[[0, 0], [1, 4], [4, 6], [7, 6]]),
        right: points(&[[7, 6], [10, 6], [13, 4], [15, 0]]),
        knots: [0, 1, 2].map(z),
        smoothness: 2,
        left_labels: polar_labels(&Expr::name("f"), 3, &int(0), &int(1)),
        right_labels: polar_labels(&Expr::name("g"), 3, &int(1), &int(2)),
    }
}

fn broken() -> ContinuityPicture {
    ContinuityPicture { right: points(&[[7, 6], [10, 6], [13, 3], [15, 0]]), ..continuity() }
}

fn hodograph() -> HodographPicture {
    HodographPicture {
        points: points(&ARCH),
        length: z(1),
        labels: indexed("b", 4),
        derivative_labels: (0..3).map(|i| formula(&format!("3 Delta b_{i}"))).collect(),
    }
}
