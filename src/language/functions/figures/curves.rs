//! Figures of curves.

use super::numeric::{
    Placed, Space, affine, form_name, local, number, place, placed, point_names, with_axes,
};
use super::options::{Labels, drawn, finished, labels};
use crate::formula::source::Span;
use crate::formula::{Accent, Expr, Kind, Rel};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::{curve_error, wrong_kind};
use crate::language::value::{Form, Value, polynomial_expr};
use crate::math::curve::{BezierCurve, CurveError};
use crate::math::number::{Rational, integer};
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Ring;
use crate::scene::pictures::{
    BezierPicture, BsplinePicture, CasteljauPicture, ContinuityPicture, Curve, HodographPicture, Plane,
    bspline_labels, casteljau_labels, polar_labels,
};
use num_traits::{One, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

/// Polar labels of a larger degree are too long to stand beside points.
const LONGEST_POLAR: usize = 5;

fn usual(degree: usize, rational: bool) -> Labels {
    if rational || degree > LONGEST_POLAR { Labels::Points } else { Labels::Polar }
}

/// The names of the control points of curve number k.
fn names(curve: &BezierCurve<Fraction>, k: usize, labels: Labels) -> Vec<Expr> {
    let (a, b) = curve.interval().ends();
    match labels {
        Labels::Polar => {
            polar_labels(&form_name(k), curve.degree(), &polynomial_expr(a), &polynomial_expr(b))
        }
        Labels::Points => point_names(k, curve.degree() + 1),
        Labels::Values | Labels::None => Vec::new(),
    }
}

/// Polar labels speak of a polynomial.
fn no_polar(args: &Arguments, wanted: Option<Labels>, form: Form) -> Result<()> {
    match (wanted, args.named("labels")) {
        (Some(Labels::Polar), Some((_, span))) if form.rational => {
            Err(Diagnostic::error(Code::NotPolynomial, "a rational curve has no polar form of its own")
                .at(span)
                .hint("labels=points names its control points"))
        }
        _ => Ok(()),
    }
}

/// Graphs, plane curves and curves in space do not share a picture.
fn one_space(spaces: impl Iterator<Item = (Space, Span)>) -> Result<Space> {
    let mut first = None;
    for (space, span) in spaces {
        if *first.get_or_insert(space) != space {
            return Err(Diagnostic::error(
                Code::Shape,
                "the curves of a figure need points with the same number of coordinates",
            )
            .at(span)
            .hint("beside(figure_bezier(c), figure_bezier(d)) draws them side by side"));
        }
    }
    Ok(first.unwrap_or(Space::Plane))
}

/// The parameters given as one number or as a list.
fn parameters(args: &Arguments) -> Result<(Vec<Fraction>, Span)> {
    match args.named("at") {
        None => Ok((Vec::new(), Span::default())),
        Some((Value::Scalar(t), span)) => Ok((vec![t.clone()], span)),
        Some((Value::List(items), span)) => {
            let list = items.iter().map(|item| {
                item.as_scalar().cloned().ok_or_else(|| wrong_kind("a parameter", item).at(span))
            });
            Ok((list.collect::<Result<_>>()?, span))
        }
        Some((other, span)) => {
            Err(wrong_kind("parameters", other).at(span).hint("for example at=[1/3, 2/3]"))
        }
    }
}

fn equation(name: &str, value: &Fraction) -> Expr {
    Expr::relation(Expr::name(name), Rel::Eq, polynomial_expr(value))
}

pub(super) fn bezier(args: &Arguments) -> Evaluated {
    let given = args.curves()?;
    let wanted = labels(args)?;
    let mut curves = Vec::with_capacity(given.len());
    let mut spaces = Vec::with_capacity(given.len());
    let mut all = Vec::new();
    for (k, (curve, form, span)) in given.iter().enumerate() {
        no_polar(args, wanted, *form)?;
        let Placed { points, space } = place(curve, *form, *span)?;
        all.extend(affine(&points));
        let labels = names(curve, k, wanted.unwrap_or_else(|| usual(curve.degree(), form.rational)));
        curves.push(Curve::rational(points).with_labels(labels));
        spaces.push((space, *span));
    }
    let space = one_space(spaces.into_iter())?;
    let (parameters, span) = parameters(args)?;
    for t in parameters {
        let mut inside = false;
        for (k, (curve, ..)) in given.iter().enumerate() {
            if curve.contains(&t) != Some(false) {
                inside = true;
                let marked = local(curve, &t, span)?;
                curves[k].marks.push((marked, equation("t", &t)));
            }
        }
        if !inside {
            let error = Diagnostic::error(Code::OutsideDomain, format!("no curve has the parameter {t}"));
            let (a, b) = given[0].0.interval().ends();
            return Err(error
                .at(span)
                .hint(format!("the interval is [{a}, {b}]; over(c, a, b) moves a curve")));
        }
    }
    let polygon = args.flag("polygon")?;
    let picture = BezierPicture { curves, parameters: Vec::new(), polygon, hull: args.flag("hull")? };
    let place = args.span(0);
    let scene = drawn(picture.scene().and_then(|scene| with_axes(scene, space, &all, &[])), place)?;
    finished(args, scene)
}

pub(super) fn casteljau(args: &Arguments) -> Evaluated {
    let (curve, form) = args.curve(0)?;
    let t = args.scalar(1)?;
    let at = local(&curve, &t, args.span(1))?;
    let Placed { points, space } = place(&curve, form, args.span(0))?;
    let points = Placed { points, space }.polynomial(args.span(0))?;
    let degree = curve.degree();
    let (a, b) = curve.interval().ends();
    // fractions are long and say nothing; t is explained below
    let letter = Symbol::new("t");
    let free = ![a, b].iter().any(|end| end.variables().contains(&letter));
    let short = t.as_rational().is_some_and(|q| q.is_integer()) || !free;
    let name = if short { polynomial_expr(&t) } else { Expr::name("t") };
    let wanted = labels(args)?.unwrap_or_else(|| usual(degree, false));
    let labels = match wanted {
        Labels::Polar => {
            casteljau_labels(&form_name(0), degree, &polynomial_expr(a), &polynomial_expr(b), &name)
        }
        Labels::Points => {
            let name = |r: usize, i: usize| match r {
                0 => Expr::indexed("b", i as i64),
                _ => Expr::indexed("b", i as i64).power(Expr::int(r as i64)),
            };
            (0..=degree).map(|r| (0..=degree - r).map(|i| name(r, i)).collect()).collect()
        }
        Labels::Values | Labels::None => Vec::new(),
    };
    let mut range = points.clone();
    if at < Rational::zero() || at > Rational::one() {
        range.extend(extrapolated(&points, &at));
    }
    let picture = CasteljauPicture { points, t: at, labels };
    let scene = drawn(picture.scene().and_then(|scene| with_axes(scene, space, &range, &[])), args.span(0))?;
    let title = format!("De Casteljau's algorithm at t = {t}");
    let words = format!(
        "The control polygon of a curve of degree {degree} and the points of all levels that lead to the point \
         of the curve at t = {t}."
    );
    let mut scene =
        scene.with_title(title).also("zh", format!("t = {t} 处的 de Casteljau 算法")).with_description(words);
    if !short {
        scene = scene.with_caption(equation("t", &t));
    }
    finished(args, scene)
}

/// The points of de Casteljau's algorithm, for the range of the axes.
fn extrapolated(points: &[Plane], t: &Rational) -> Vec<Plane> {
    let mut row = points.to_vec();
    let mut all = Vec::new();
    while row.len() > 1 {
        crate::budget::charge_terms(row.len() as u64);
        let mean = |pair: &[Plane]| [0, 1].map(|k| &pair[0][k] + t * (&pair[1][k] - &pair[0][k]));
        row = row.windows(2).map(mean).collect();
        all.extend(row.iter().cloned());
    }
    all
}

pub(super) fn bspline(args: &Arguments) -> Evaluated {
    let span = args.span(0);
    let (spline, form) = args.spline(0)?;
    let wanted = labels(args)?;
    no_polar(args, wanted, form)?;
    let knots = spline.knots();
    let greville = || (0..knots.count()).map(|i| number(&knots.greville(i), span)).collect();
    let (points, space) = placed(spline.points(), &greville, form, span)?;
    let n = spline.degree();
    let names = match wanted.unwrap_or_else(|| usual(n, form.rational)) {
        Labels::Polar => {
            let inner: Vec<Expr> =
                knots.knots()[1..knots.knots().len() - 1].iter().map(polynomial_expr).collect();
            bspline_labels(&form_name(0), n, &inner)
        }
        Labels::Points => (0..points.len()).map(|i| Expr::indexed("d", i as i64)).collect(),
        Labels::Values | Labels::None => Vec::new(),
    };
    let pieces: Vec<BezierCurve<Fraction>> = spline.bezier_pieces();
    let mut range = affine(&points);
    let mut drawings = Vec::with_capacity(pieces.len());
    let mut ends = Vec::with_capacity(pieces.len() + 1);
    for piece in &pieces {
        let (a, b) = piece.interval().ends();
        if ends.is_empty() {
            ends.push(polynomial_expr(a));
        }
        ends.push(polynomial_expr(b));
        let Placed { points, .. } = place(piece, form, span)?;
        range.extend(affine(&points));
        drawings.push(Curve::rational(points));
    }
    // the knots of a graph stand on its axis
    let marks = match (space, pieces.last()) {
        (Space::Graph, Some(last)) => {
            let starts = pieces.iter().map(|piece| piece.interval().start());
            starts.chain([last.interval().end()]).map(|knot| number(knot, span)).collect::<Result<_>>()?
        }
        _ => Vec::new(),
    };
    let picture = BsplinePicture {
        pieces: drawings,
        points: Curve::rational(points).with_labels(names),
        knots: if space == Space::Graph { Vec::new() } else { ends },
        bezier_points: args.flag("bezier")?,
    };
    let scene = drawn(picture.scene().and_then(|scene| with_axes(scene, space, &range, &marks)), span)?;
    finished(args, scene)
}

pub(super) fn continuity(args: &Arguments) -> Evaluated {
    let ((f, left), (g, right)) = (args.curve(0)?, args.curve(1)?);
    let ((r, s), (also, u)) = (f.interval().ends(), g.interval().ends());
    if s != also {
        return Err(curve_error(CurveError::NoCommonEnd)
            .at(args.span(1))
            .reason(format!("this curve begins at {also}, the other one ends at {s}"))
            .hint("for example bezier([[2, 2], [3, 2], [4, 0]], 1, 2) after a curve over [0, 1]"));
    }
    let knots = [(r, 0), (s, 0), (u, 1)].map(|(knot, i)| number(knot, args.span(i)));
    let [r, s, u] = knots;
    let knots = [r?, s?, u?];
    let n = f.degree().max(g.degree());
    let (f, g) = (f.elevate(n - f.degree()), g.elevate(n - g.degree()));
    let first = place(&f, left, args.span(0))?;
    let second = place(&g, right, args.span(1))?;
    let space = one_space([(first.space, args.span(0)), (second.space, args.span(1))].into_iter())?;
    let (first, second) = (first.polynomial(args.span(0))?, second.polynomial(args.span(1))?);
    let wanted = labels(args)?.unwrap_or_else(|| usual(n, false));
    let order = args.size_named("order")?;
    let marks = knots.clone();
    let mut range = first.clone();
    range.extend(second.iter().cloned());
    let picture = ContinuityPicture {
        left: first,
        right: second,
        knots,
        smoothness: order,
        left_labels: names(&f, 0, wanted),
        right_labels: names(&g, 1, wanted),
    };
    let scene =
        drawn(picture.scene().and_then(|scene| with_axes(scene, space, &range, &marks)), args.span(1))?;
    finished(args, scene)
}

pub(super) fn hodograph(args: &Arguments) -> Evaluated {
    let span = args.span(0);
    let (curve, form) = args.curve(0)?;
    let wanted = labels(args)?.unwrap_or(Labels::Points);
    if curve.degree() == 0 {
        return Err(Diagnostic::error(Code::ControlPoints, "a single point has no derivative to draw")
            .at(span)
            .hint("give at least two control points"));
    }
    let placed = place(&curve, form, span)?;
    let space = placed.space;
    let points = placed.polynomial(span)?;
    let (a, b) = curve.interval().ends();
    let length = number(&b.minus(a), span)?;
    let names_of_curve = names(&curve, 0, wanted);
    if space == Space::Graph {
        // the graphs of a function and of its derivative
        let derivative = curve.derivative();
        let second = place(&derivative, form, span)?.polynomial(span)?;
        let graph = |points: Vec<Plane>, labels: Vec<Expr>| {
            let picture = BezierPicture::of(Curve::new(points.clone()).with_labels(labels));
            picture.scene().and_then(|scene| with_axes(scene, space, &points, &[]))
        };
        let left = drawn(graph(points, names_of_curve), span)?;
        let right = drawn(graph(second, Vec::new()), span)?.with_title("its derivative").also("zh", "其导数");
        return finished(args, left.with_width(WIDE).beside(right));
    }
    let derivative_labels = match wanted {
        Labels::None | Labels::Values => Vec::new(),
        Labels::Points => {
            let factor = integer(curve.degree() as i64) / &length;
            let name = |i: usize| vec![Expr::name("Delta"), Expr::indexed("b", i as i64)];
            (0..curve.degree()).map(|i| scaled(&factor, name(i))).collect()
        }
        Labels::Polar => {
            // F'(t) = n f(t, …, t, 1̂)
            let (a, b) = (polynomial_expr(a), polynomial_expr(b));
            let hat: Expr = Kind::Accent(Accent::Hat, Box::new(Expr::int(1))).into();
            let n = curve.degree();
            let value = |i: usize| {
                let mut arguments = vec![a.clone(); n - 1 - i];
                arguments.extend(vec![b.clone(); i]);
                arguments.push(hat.clone());
                vec![Expr::apply(form_name(0), arguments)]
            };
            (0..n).map(|i| scaled(&integer(n as i64), value(i))).collect()
        }
    };
    let picture = HodographPicture { points, length, labels: names_of_curve, derivative_labels };
    finished(args, drawn(picture.scene(), span)?.with_width(WIDE))
}

/// factor · body; a factor 1 is not written.
fn scaled(factor: &Rational, body: Vec<Expr>) -> Expr {
    let factor = (!factor.is_one()).then(|| Expr::number(factor));
    Expr::product(factor.into_iter().chain(body).collect())
}

/// The width of two pictures side by side.
const WIDE: f64 = 640.0;
