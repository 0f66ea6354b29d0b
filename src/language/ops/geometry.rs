//! Curves as values: points, changes of representation, sums and multiples.

use std::sync::Arc;

use super::errors::{curve_error, spline_error};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::value::{Form, Geometry, PiecewiseFunction, Value, homogeneous};
use crate::math::curve::{BezierCurve, CurveError, Interval, Point};
use crate::math::poly::Fraction;
use crate::math::ring::Ring;
use crate::math::spline::{BSpline, KnotVector, SplineError};
use num_traits::{One, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

/// A list of points: numbers and symbols (then `true`) or lists of coordinates.
pub(crate) fn points_of(value: &Value) -> Option<(Vec<Point<Fraction>>, bool)> {
    match value {
        Value::List(items) if !items.is_empty() => {
            let scalars: Option<Vec<Point<Fraction>>> =
                items.iter().map(|item| item.as_scalar().map(|x| [x.clone()].into())).collect();
            if let Some(points) = scalars {
                return Some((points, true));
            }
            let point = |item: &Value| match item {
                Value::List(coordinates) => {
                    coordinates.iter().map(|x| x.as_scalar().cloned()).collect::<Option<Point<Fraction>>>()
                }
                Value::Matrix(column) if column.ncols() == 1 => Some(column.iter().cloned().collect()),
                _ => None,
            };
            items.iter().map(point).collect::<Option<_>>().map(|points| (points, false))
        }
        // The rows of a matrix are points as well.
        Value::Matrix(matrix) => {
            Some((matrix.row_iter().map(|row| row.iter().cloned().collect()).collect(), false))
        }
        _ => None,
    }
}

fn is_coordinates(value: &Value) -> bool {
    match value {
        Value::List(items) => items.iter().all(|x| x.as_scalar().is_some()),
        Value::Matrix(column) => column.ncols() == 1,
        _ => false,
    }
}

/// Whether it is a point, see [`point_of`]. Nothing is copied.
pub(crate) fn is_point(value: &Value) -> bool {
    value.as_scalar().is_some() || is_coordinates(value)
}

/// Whether it is a list of points, see [`points_of`]. Nothing is copied.
pub(crate) fn is_points(value: &Value) -> bool {
    match value {
        Value::List(items) if !items.is_empty() => {
            items.iter().all(|item| item.as_scalar().is_some()) || items.iter().all(is_coordinates)
        }
        Value::Matrix(_) => true,
        _ => false,
    }
}

/// One point: coordinates, or a single number.
pub(crate) fn point_of(value: &Value) -> Option<(Point<Fraction>, bool)> {
    match value {
        Value::Scalar(x) => Some(([x.clone()].into(), true)),
        Value::List(items) => {
            items.iter().map(|x| x.as_scalar().cloned()).collect::<Option<_>>().map(|p| (p, false))
        }
        Value::Matrix(column) if column.ncols() == 1 => Some((column.iter().cloned().collect(), false)),
        _ => None,
    }
}

/// A list of scalars.
pub(crate) fn scalar_list(items: impl IntoIterator<Item = Fraction>) -> Value {
    Value::List(items.into_iter().map(Value::Scalar).collect())
}

/// A Bézier curve as a value.
pub(crate) fn bezier(curve: BezierCurve<Fraction>, form: Form) -> Value {
    Value::Geometry(Arc::new(Geometry::Bezier(curve, form)))
}

/// A spline as a value.
pub(crate) fn spline(spline: BSpline<Fraction>, form: Form) -> Value {
    Value::Geometry(Arc::new(Geometry::Spline(spline, form)))
}

/// A Bézier curve as a spline without inner knots.
pub(crate) fn as_spline(
    curve: &BezierCurve<Fraction>,
) -> std::result::Result<BSpline<Fraction>, SplineError> {
    let knots = KnotVector::clamped(curve.degree(), &[], curve.interval())?;
    BSpline::new(knots, curve.points().to_vec())
}

/// The curve with homogeneous coordinates, all weights 1 if it is polynomial.
pub(crate) fn as_rational_form(curve: &BezierCurve<Fraction>, form: Form) -> BezierCurve<Fraction> {
    if form.rational {
        return curve.clone();
    }
    let points = curve.points().iter().map(|point| homogeneous(point, &Fraction::one())).collect();
    BezierCurve::new(points, curve.interval().clone()).expect("only a coordinate was added")
}

/// The spline with homogeneous coordinates, all weights 1 if it is polynomial.
pub(crate) fn as_rational_spline(spline: &BSpline<Fraction>, form: Form) -> BSpline<Fraction> {
    if form.rational {
        return spline.clone();
    }
    let points = spline.points().iter().map(|point| homogeneous(point, &Fraction::one())).collect();
    BSpline::new(spline.knots().clone(), points).expect("only a coordinate was added")
}

/// Bézier curves one after the other as a clamped spline with the smallest multiplicities.
pub(crate) fn joined(pieces: &[BezierCurve<Fraction>]) -> Result<BSpline<Fraction>> {
    let n = pieces.iter().map(BezierCurve::degree).max().unwrap_or(0);
    let mut knots = vec![pieces[0].interval().start().clone(); n + 1];
    for pair in pieces.windows(2) {
        let at = pair[1].interval().start().clone();
        if pair[0].interval().end() != &at {
            return Err(curve_error(CurveError::NoCommonEnd));
        }
        let order = crate::math::curve::continuity_at(&pair[0], &pair[1], &at).map_err(curve_error)?.order;
        // One polynomial keeps a simple knot, so that each piece stays one.
        let multiplicity = order.map_or(n + 1, |order| (n - order.min(n)).max(1));
        knots.extend(vec![at; multiplicity]);
    }
    knots.extend(vec![pieces[pieces.len() - 1].interval().end().clone(); n + 1]);
    let knots = KnotVector::new(n, knots).map_err(spline_error)?;
    BSpline::from_pieces(knots, pieces).map_err(spline_error)
}

/// The pieces of a piecewise polynomial, or of several over the same breakpoints, one for each
/// coordinate.
pub(crate) fn polynomial_pieces(
    value: &Value,
) -> Option<std::result::Result<Vec<BezierCurve<Fraction>>, CurveError>> {
    let functions: Vec<&PiecewiseFunction> = match value {
        Value::Piecewise(function) => vec![function],
        Value::List(items) => items
            .iter()
            .map(|item| if let Value::Piecewise(function) = item { Some(&**function) } else { None })
            .collect::<Option<_>>()?,
        _ => return None,
    };
    let breaks = functions.first()?.function.breaks();
    if functions.iter().any(|other| other.function.breaks() != breaks) {
        return None;
    }
    let piece = |i: usize| {
        let padded = |function: &&PiecewiseFunction| {
            let mut piece = function.function.pieces()[i].to_vec();
            piece.resize(piece.len().max(1), Fraction::zero());
            piece
        };
        let coordinates: Vec<Vec<Fraction>> = functions.iter().map(padded).collect();
        let interval = Interval::new(breaks[i].clone(), breaks[i + 1].clone())?;
        BezierCurve::from_power(&coordinates, interval)
    };
    Some((0..breaks.len() - 1).map(piece).collect())
}

/// The sum of two piecewise polynomials.
pub(crate) fn add_piecewise(a: &PiecewiseFunction, b: &PiecewiseFunction) -> Result<Value> {
    let function = a.function.sum(&b.function).ok_or_else(|| {
        Diagnostic::error(Code::Undecided, "the breakpoints of the two functions cannot be put in one order")
            .hint("symbolic breakpoints have to be the same in both")
    })?;
    Ok(Value::Piecewise(Arc::new(PiecewiseFunction::new(function, a.variable.clone()))))
}

/// A multiple of a piecewise polynomial.
pub(crate) fn scale_piecewise(factor: &Fraction, f: &PiecewiseFunction) -> Value {
    let function = f.function.map(|piece| piece.scaled(factor));
    Value::Piecewise(Arc::new(PiecewiseFunction::new(function, f.variable.clone())))
}

/// The same curve from its end to its start, over the same interval.
pub(crate) fn backwards(c: &Geometry) -> Result<Value> {
    match c {
        Geometry::Bezier(curve, form) => {
            let points = curve.points().iter().rev().cloned().collect();
            BezierCurve::new(points, curve.interval().clone()).map(|c| bezier(c, *form)).map_err(curve_error)
        }
        Geometry::Spline(s, form) => {
            let knots = s.knots().knots();
            let ends = knots[0].plus(&knots[knots.len() - 1]);
            let mirrored = knots.iter().rev().map(|knot| ends.minus(knot)).collect();
            let knots = KnotVector::new(s.degree(), mirrored).map_err(spline_error)?;
            let points = s.points().iter().rev().cloned().collect();
            BSpline::new(knots, points).map(|s| spline(s, *form)).map_err(spline_error)
        }
        other => Err(Diagnostic::error(Code::Type, format!("{} is not run through backwards", other.kind()))),
    }
}

/// A curve moved by a vector.
pub(crate) fn translate(c: &Geometry, by: &Value) -> Result<Value> {
    let form = c.form();
    let Some((by, _)) = point_of(by).filter(|(_, scalar)| *scalar == form.scalar) else {
        let message = format!("{} and {} cannot be added", c.kind(), by.kind());
        return Err(Diagnostic::error(Code::Type, message)
            .hint("a curve is moved by a point of as many coordinates: c + [1, 0]"));
    };
    let moved = |point: &Point<Fraction>| -> Option<Point<Fraction>> {
        let weight = if form.rational { point.last()?.clone() } else { Fraction::one() };
        let size = point.len() - usize::from(form.rational);
        (size == by.len()).then(|| {
            let place =
                |(k, x): (usize, &Fraction)| by.get(k).map_or(x.clone(), |b| x.plus(&b.times(&weight)));
            point.iter().enumerate().map(place).collect()
        })
    };
    let unequal =
        || Diagnostic::error(Code::Shape, "the curve and the point have different numbers of coordinates");
    let all =
        |points: &[Point<Fraction>]| points.iter().map(moved).collect::<Option<Vec<_>>>().ok_or_else(unequal);
    match c {
        Geometry::Bezier(curve, _) => {
            let curve = BezierCurve::new(all(curve.points())?, curve.interval().clone());
            curve.map(|c| bezier(c, form)).map_err(curve_error)
        }
        Geometry::Spline(s, _) => {
            BSpline::new(s.knots().clone(), all(s.points())?).map(|s| spline(s, form)).map_err(spline_error)
        }
        other => Err(Diagnostic::error(Code::Type, format!("{} is not moved here", other.kind()))),
    }
}

/// The sum of two polynomial curves over one domain, of the larger degree; with a spline among them, a spline.
pub(crate) fn add(a: &Geometry, b: &Geometry) -> Result<Value> {
    if matches!(a, Geometry::Spline(..)) || matches!(b, Geometry::Spline(..)) {
        let both = form_of_sum(a.form(), b.form())?;
        let either = |c: &Geometry| match c {
            Geometry::Spline(s, _) => Some(s.clone()),
            Geometry::Bezier(curve, _) => as_spline(curve).ok(),
            _ => None,
        };
        if let (Some(f), Some(g)) = (either(a), either(b)) {
            return f.sum(&g).map(|s| spline(s, both)).map_err(spline_error);
        }
    }
    let (Geometry::Bezier(f, left), Geometry::Bezier(g, right)) = (a, b) else {
        let message = format!("{} and {} cannot be added", a.kind(), b.kind());
        return Err(Diagnostic::error(Code::Type, message)
            .hint("polynomial curves and splines over one interval can be"));
    };
    let both = form_of_sum(*left, *right)?;
    if f.interval().ends() != g.interval().ends() {
        return Err(Diagnostic::error(Code::Shape, "only polynomial curves over one interval can be added")
            .hint("over(c, a, b) moves a curve to another interval"));
    }
    if f.dimension() != g.dimension() {
        return Err(curve_error(CurveError::DimensionsOf { left: f.dimension(), right: g.dimension() }));
    }
    let n = f.degree().max(g.degree());
    let (f, g) = (f.elevate(n - f.degree()), g.elevate(n - g.degree()));
    let points = f.points().iter().zip(g.points()).map(|(p, q)| p + &q.position()).collect();
    let curve = BezierCurve::new(points, f.interval().clone()).map_err(curve_error)?;
    Ok(bezier(curve, both))
}

/// How the coordinates of a sum are read; weights cannot be added.
fn form_of_sum(left: Form, right: Form) -> Result<Form> {
    if left.rational || right.rational {
        let message = "only polynomial curves over one interval can be added";
        return Err(Diagnostic::error(Code::Shape, message)
            .hint("homogeneous(c) is the polynomial curve of its homogeneous coordinates"));
    }
    Ok(Form { scalar: left.scalar && right.scalar, rational: false })
}

/// The cross product of the partial derivatives of a surface.
pub(crate) fn cross(u: &[Fraction], v: &[Fraction]) -> Result<[Fraction; 3]> {
    if u.len() != 3 {
        let message = format!("a surface in space is needed, this one has {} coordinates", u.len());
        return Err(Diagnostic::error(Code::Shape, message).hint("give points with three coordinates"));
    }
    let minor = |i: usize, j: usize| u[i].times(&v[j]).minus(&u[j].times(&v[i]));
    Ok([minor(1, 2), minor(2, 0), minor(0, 1)])
}

/// A curve scaled from the origin.
pub(crate) fn scale(factor: &Fraction, c: &Geometry) -> Result<Value> {
    let form = c.form();
    let scaled = |point: &Point<Fraction>| -> Point<Fraction> {
        let last = point.len() - usize::from(form.rational);
        point.iter().enumerate().map(|(k, x)| if k < last { x.times(factor) } else { x.clone() }).collect()
    };
    match c {
        Geometry::Bezier(curve, _) => {
            let points = curve.points().iter().map(scaled).collect();
            BezierCurve::new(points, curve.interval().clone()).map(|c| bezier(c, form)).map_err(curve_error)
        }
        Geometry::Spline(s, _) => {
            let points = s.points().iter().map(scaled).collect();
            BSpline::new(s.knots().clone(), points).map(|s| spline(s, form)).map_err(spline_error)
        }
        other => Err(Diagnostic::error(Code::Type, format!("{} has no multiples here", other.kind()))),
    }
}
