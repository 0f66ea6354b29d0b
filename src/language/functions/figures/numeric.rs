//! From values to what can be drawn: numbers in the plane.

use crate::formula::Expr;
use crate::formula::source::Span;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::ops::errors::curve_error;
use crate::language::ops::geometry::points_of;
use crate::language::value::{Form, Geometry, Value};
use crate::math::curve::{BezierCurve, Interval, Point};
use crate::math::number::{Rational, rational};
use crate::math::poly::{Fraction, Symbol};
use crate::scene::pictures::{Plane, as_graph, projected};
use crate::scene::{Scene, SceneError};
use num_traits::{One, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

/// How high graphs are, in pixels.
pub(super) const HEIGHT: f64 = 280.0;

/// The letters of polar forms and of control points of several curves.
const FORMS: [&str; 6] = ["f", "g", "h", "k", "l", "m"];
const POINTS: [&str; 6] = ["b", "c", "d", "e", "p", "q"];

/// The polar form of curve number k.
pub(super) fn form_name(k: usize) -> Expr {
    FORMS.get(k).map_or_else(|| Expr::indexed("f", k as i64), |letter| Expr::name(*letter))
}

/// The names of the control points of curve number k; none after many curves.
pub(super) fn point_names(k: usize, count: usize) -> Vec<Expr> {
    let names = |letter: &&str| (0..count).map(|i| Expr::indexed(*letter, i as i64)).collect();
    POINTS.get(k).map(names).unwrap_or_default()
}

/// A number, not a formula in symbols.
pub(super) fn number(value: &Fraction, span: Span) -> Result<Rational> {
    value.as_rational().ok_or_else(|| {
        let symbols: Vec<String> = value.variables().iter().map(Symbol::to_string).collect();
        let plural = if symbols.len() == 1 { "has" } else { "have" };
        let first = symbols.first().map_or("t", String::as_str);
        Diagnostic::error(
            Code::Undrawable,
            format!("a drawing needs numbers, but {} {plural} no value", symbols.join(", ")),
        )
        .at(span)
        .hint(format!("give the symbols values first, for example {first} := 1"))
    })
}

pub(super) fn numbers(values: &[Fraction], span: Span) -> Result<Vec<Rational>> {
    values.iter().map(|value| number(value, span)).collect()
}

/// What the coordinates of a curve mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Space {
    /// A function: its control points stand over their Greville abscissae.
    Graph,
    /// The plane.
    Plane,
    /// Space, seen as surfaces are.
    Solid,
}

/// Control points in the plane with their weights, (w x, w y, w).
pub(super) type Homogeneous = [Rational; 3];

/// Control points as they are drawn. `abscissae` are those of the control points of F(t) = t,
/// which graphs need.
pub(super) fn placed(
    points: &[Point<Fraction>],
    abscissae: &dyn Fn() -> Result<Vec<Rational>>,
    form: Form,
    span: Span,
) -> Result<(Vec<Homogeneous>, Space)> {
    let mut rows: Vec<Vec<Rational>> =
        points.iter().map(|point| numbers(point, span)).collect::<Result<_>>()?;
    let weights: Vec<Rational> = rows
        .iter_mut()
        .map(|row| if form.rational { row.pop() } else { None }.unwrap_or_else(Rational::one))
        .collect();
    let dimension = rows.first().map_or(0, Vec::len);
    let space = match dimension {
        1 if form.rational => {
            return Err(Diagnostic::error(
                Code::Undrawable,
                "the graph of a rational function has no control points over t",
            )
            .at(span)
            .hint("give the points of a plane curve: bezier([[0, 0], [1, 2], [2, 0]], weights=[1, 2, 1])"));
        }
        1 => Space::Graph,
        2 => Space::Plane,
        3 => Space::Solid,
        _ => {
            return Err(Diagnostic::error(
                Code::Undrawable,
                format!("points of {dimension} coordinates cannot be drawn"),
            )
            .at(span)
            .hint("1 coordinate gives a graph, 2 a curve in the plane, 3 one in space"));
        }
    };
    let abscissae = if space == Space::Graph { abscissae()? } else { Vec::new() };
    let mut placed = Vec::with_capacity(rows.len());
    for (i, (row, weight)) in rows.into_iter().zip(weights).enumerate() {
        placed.push(match <[Rational; 3]>::try_from(row) {
            Ok(point) => {
                let [x, y] = projected(&point);
                [x, y, weight]
            }
            Err(row) => match <[Rational; 2]>::try_from(row) {
                Ok([x, y]) => [x, y, weight],
                Err(row) => {
                    let y = row.into_iter().next().unwrap_or_else(Rational::zero);
                    [abscissae.get(i).cloned().unwrap_or_else(Rational::zero), y, weight]
                }
            },
        });
    }
    Ok((placed, space))
}

/// A Bézier curve as it is drawn.
pub(super) struct Placed {
    pub points: Vec<Homogeneous>,
    pub space: Space,
}

impl Placed {
    /// Control points without weights; an error for rational curves.
    pub(super) fn polynomial(&self, span: Span) -> Result<Vec<Plane>> {
        if self.points.iter().any(|[_, _, w]| !w.is_one()) {
            return Err(Diagnostic::error(Code::NotPolynomial, "this curve is rational, not polynomial")
                .at(span)
                .hint("figure_bezier draws rational curves; homogeneous(c) is a polynomial one in space"));
        }
        Ok(self.points.iter().map(|[x, y, _]| [x.clone(), y.clone()]).collect())
    }
}

/// a, a + (b − a)/n, …, b
fn steps(curve: &BezierCurve<Fraction>, span: Span) -> Result<Vec<Rational>> {
    let (a, b) = curve.interval().ends();
    let (a, b) = (number(a, span)?, number(b, span)?);
    let n = curve.degree().max(1) as i64;
    Ok((0..=curve.degree() as i64).map(|i| &a + (&b - &a) * rational(i, n)).collect())
}

/// A Bézier curve in the plane; a graph of degree 0 is drawn with degree 1.
pub(super) fn place(curve: &BezierCurve<Fraction>, form: Form, span: Span) -> Result<Placed> {
    let curve = if curve.degree() == 0 && curve.dimension() == 1 { curve.elevate(1) } else { curve.clone() };
    let (points, space) = placed(curve.points(), &|| steps(&curve, span), form, span)?;
    Ok(Placed { points, space })
}

/// (t − a)/(b − a)
pub(super) fn local(curve: &BezierCurve<Fraction>, t: &Fraction, span: Span) -> Result<Rational> {
    number(&curve.interval().local(t), span)
}

/// The scene as a graph with these numbers on its axis, if it is one.
pub(super) fn with_axes(
    scene: Scene,
    space: Space,
    points: &[Plane],
    marks: &[Rational],
) -> std::result::Result<Scene, SceneError> {
    if space == Space::Graph {
        as_graph(scene, points, marks, Some(Expr::name("t")), HEIGHT)
    } else {
        Ok(scene)
    }
}

/// Points without their weights, those at infinity left out.
pub(super) fn affine(points: &[Homogeneous]) -> Vec<Plane> {
    points.iter().filter(|[_, _, w]| !w.is_zero()).map(|[x, y, w]| [x / w, y / w]).collect()
}

impl Arguments {
    /// A Bézier curve; a list of points is one over [0, 1].
    pub(super) fn curve(&self, i: usize) -> Result<(BezierCurve<Fraction>, Form)> {
        let value = self.value(i)?;
        match points_of(value) {
            Some((points, scalar)) => {
                let curve = BezierCurve::new(points, Interval::unit());
                let curve = curve.map_err(curve_error).at(self.span(i))?;
                Ok((curve, Form { scalar, rational: false }))
            }
            None => self.bezier(i),
        }
    }

    /// The Bézier curves given by place, those in lists too.
    pub(super) fn curves(&self) -> Result<Vec<(BezierCurve<Fraction>, Form, Span)>> {
        let mut found = Vec::new();
        for i in 0..self.len() {
            let span = self.span(i);
            match self.value(i)? {
                Value::List(items)
                    if !items.is_empty() && items.iter().all(|item| matches!(item, Value::Geometry(_))) =>
                {
                    for item in items {
                        let (curve, form) = self.with_first(item.clone()).bezier(0).at(span)?;
                        found.push((curve, form, span));
                    }
                }
                Value::Geometry(geometry) if matches!(**geometry, Geometry::Spline(..)) => {
                    let error = Diagnostic::error(
                        Code::Type,
                        format!("expected a Bézier curve, not {}", geometry.kind()),
                    );
                    return Err(error
                        .at(span)
                        .hint("figure_bspline(s) draws a spline, figure_bezier(pieces(s)) its pieces"));
                }
                _ => {
                    let (curve, form) = self.curve(i)?;
                    found.push((curve, form, span));
                }
            }
        }
        Ok(found)
    }
}
