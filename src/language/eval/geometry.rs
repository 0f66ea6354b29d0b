//! Curves and surfaces in the language: reading their parts from arguments, their values, and the
//! words for their errors.

use std::sync::Arc;

use super::Arguments;
use super::wrong_kind;
use crate::formula::source::Span;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::value::{Form, Geometry, PiecewiseFunction, Value, homogeneous};
use crate::math::curve::{BezierCurve, CurveError, Interval, Point, Triangle};
use crate::math::piecewise::PiecewiseError;
use crate::math::poly::Fraction;
use crate::math::ring::Ring;
use crate::math::spline::{BSpline, SplineError};
use num_traits::{One, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

/// The diagnostic for an error of curves.
pub(crate) fn curve_error(error: CurveError) -> Diagnostic {
    let message = error.to_string();
    let (code, hint) = match error {
        CurveError::TooFewPoints { .. } => (Code::ControlPoints, "a point is a list such as [1, 2]"),
        CurveError::Dimensions { .. } => {
            (Code::ControlPoints, "give every point the same number of coordinates")
        }
        CurveError::EmptyInterval => (Code::Coincident, "choose two different ends, such as 0 and 1"),
        CurveError::WeightCount { .. } => (Code::ControlPoints, "give one weight for each control point"),
        CurveError::ZeroWeight { .. } => (
            Code::ZeroWeight,
            "a weight of 0 needs homogeneous points: homogeneous=1, coordinates with the weight last",
        ),
        CurveError::ZeroDenominator => (Code::ZeroWeight, "the point lies at infinity"),
        CurveError::OutsideDomain => {
            (Code::OutsideDomain, "extended(c, t) gives the value of the polynomial there")
        }
        CurveError::Arguments { .. } => (Code::Arity, "a polar form has as many arguments as its degree"),
        CurveError::Degrees { .. } => (Code::Shape, "elevate(c, k) raises a degree"),
        CurveError::DimensionsOf { .. } => (Code::Shape, "both need the same number of coordinates"),
        CurveError::NotReducible { .. } => (
            Code::NotReducible,
            "differences(control_points(c), n) shows the difference that would have to vanish",
        ),
        CurveError::RaggedNet { .. } => (Code::ControlPoints, "give every row the same number of points"),
        CurveError::NotTriangular { .. } => {
            (Code::ControlPoints, "a triangular patch of degree n has (n+1)(n+2)/2 points")
        }
        CurveError::Degenerate => (Code::Degenerate, "choose corners in general position"),
        CurveError::NoCommonEdge => (Code::Coincident, "the domains have to share an edge"),
        CurveError::NoCommonEnd => (Code::Coincident, "over(c, a, b) moves a curve to another interval"),
        CurveError::Irrational { .. } => {
            (Code::Irrational, "choose numbers whose root is rational, or another parameterization")
        }
        CurveError::Impossible { .. } => (Code::Domain, "there is no such object"),
    };
    Diagnostic::error(code, message).hint(hint)
}

/// The diagnostic for an error of splines.
pub(crate) fn spline_error(error: SplineError) -> Diagnostic {
    let message = error.to_string();
    let (code, hint) = match error {
        SplineError::Curve(inner) => return curve_error(inner),
        SplineError::TooFewKnots { .. } | SplineError::PointCount { .. } => {
            (Code::Knots, "m control points of degree n need m + n + 1 knots")
        }
        SplineError::DecreasingKnots { .. } => (Code::Knots, "write the knots in increasing order"),
        SplineError::Multiplicity { .. } => (Code::Knots, "a knot can be repeated degree + 1 times at most"),
        SplineError::NoDomain => (Code::Knots, "the domain is [t_n, t_m], for m control points of degree n"),
        SplineError::NoSuchFunction { .. } => (Code::Domain, "choose a smaller number"),
        SplineError::OutsideDomain => (Code::OutsideDomain, "extended(s, t) takes the nearest piece"),
        SplineError::Unordered => {
            (Code::Undecided, "name the knot interval: deboor(s, t, span=j) for t_j <= t < t_(j+1)")
        }
        SplineError::MissingKnot { .. } => (Code::Knots, "finer knots contain all knots of the spline"),
        SplineError::NotAKnot { .. } => (Code::Domain, "only inner knots can be removed"),
        SplineError::NotSmooth { .. } => (Code::NotReducible, "smoothness(s) tells how the pieces meet"),
        SplineError::PieceDegree { .. } => (Code::NotReducible, "pieces(s) are its polynomial pieces"),
        SplineError::Domains => (Code::Shape, "both need the same domain, piece by piece"),
    };
    Diagnostic::error(code, message).hint(hint)
}

pub(crate) fn piecewise_error(error: PiecewiseError) -> Diagnostic {
    let code = match error {
        PiecewiseError::Counts { .. } | PiecewiseError::Order { .. } => Code::Knots,
        PiecewiseError::OutsideDomain => Code::OutsideDomain,
        PiecewiseError::Unordered => Code::Undecided,
    };
    let hint = match code {
        Code::Undecided => "give the variable a number, or take one of its pieces",
        Code::OutsideDomain => "the function is given between its breakpoints only",
        _ => "m pieces stand between m + 1 increasing breakpoints",
    };
    Diagnostic::error(code, error.to_string()).hint(hint)
}

/// Bézier curves one after the other as a clamped spline with the smallest multiplicities.
pub(crate) fn joined(pieces: &[BezierCurve<Fraction>]) -> Result<BSpline<Fraction>> {
    let n = pieces.iter().map(BezierCurve::degree).max().unwrap_or(0);
    let mut knots = vec![pieces[0].interval().0.clone(); n + 1];
    for pair in pieces.windows(2) {
        let at = pair[1].interval().0.clone();
        if pair[0].interval().1 != &at {
            return Err(curve_error(CurveError::NoCommonEnd));
        }
        let order = crate::math::curve::continuity_at(&pair[0], &pair[1], &at).map_err(curve_error)?.order;
        // One polynomial keeps a simple knot, so that each piece stays one.
        let multiplicity = order.map_or(n + 1, |order| (n - order.min(n)).max(1));
        knots.extend(vec![at; multiplicity]);
    }
    knots.extend(vec![pieces[pieces.len() - 1].interval().1.clone(); n + 1]);
    let knots = crate::math::spline::KnotVector::new(n, knots).map_err(spline_error)?;
    BSpline::from_pieces(knots, pieces).map_err(spline_error)
}

/// The pieces of a piecewise polynomial, or of several over the same breakpoints, one for each
/// coordinate.
fn polynomial_pieces(value: &Value) -> Option<std::result::Result<Vec<BezierCurve<Fraction>>, CurveError>> {
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
        BezierCurve::from_power(&coordinates, breaks[i].clone(), breaks[i + 1].clone())
    };
    Some((0..breaks.len() - 1).map(piece).collect())
}

/// A list of points: numbers and symbols (then `true`) or lists of coordinates.
pub(crate) fn points_of(value: &Value) -> Option<(Vec<Point<Fraction>>, bool)> {
    match value {
        Value::List(items) if !items.is_empty() => {
            let scalars: Option<Vec<Point<Fraction>>> =
                items.iter().map(|item| item.as_scalar().map(|x| vec![x.clone()])).collect();
            if let Some(points) = scalars {
                return Some((points, true));
            }
            let point = |item: &Value| match item {
                Value::List(coordinates) => {
                    coordinates.iter().map(|x| x.as_scalar().cloned()).collect::<Option<Point<Fraction>>>()
                }
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

/// One point: coordinates, or a single number.
pub(crate) fn point_of(value: &Value) -> Option<(Point<Fraction>, bool)> {
    match value {
        Value::Scalar(x) => Some((vec![x.clone()], true)),
        Value::List(items) => {
            items.iter().map(|x| x.as_scalar().cloned()).collect::<Option<_>>().map(|p| (p, false))
        }
        _ => None,
    }
}

pub(crate) fn scalar_list(items: impl IntoIterator<Item = Fraction>) -> Value {
    Value::List(items.into_iter().map(Value::Scalar).collect())
}

pub(crate) fn bezier(curve: BezierCurve<Fraction>, form: Form) -> Value {
    Value::Geometry(Arc::new(Geometry::Bezier(curve, form)))
}

pub(crate) fn spline(spline: BSpline<Fraction>, form: Form) -> Value {
    Value::Geometry(Arc::new(Geometry::Spline(spline, form)))
}

impl Arguments {
    /// Control points at a place, with weights or homogeneous coordinates if they are named.
    pub(crate) fn control_points(&self, i: usize) -> Result<(Vec<Point<Fraction>>, Form)> {
        let value = self.value(i)?;
        let (points, scalar) = points_of(value).ok_or_else(|| {
            wrong_kind("a list of control points", value)
                .at(self.span(i))
                .hint("such as [[0, 0], [1, 2], [2, 0]], or [b_0, b_1, b_2] for symbols")
        })?;
        let wanted = self.named_or("homogeneous", usize::MAX);
        let already = wanted.is_some_and(|(value, _)| value.as_int() == Some(1));
        let Some((weights, span)) = self.named_or("weights", usize::MAX) else {
            let form =
                Form { scalar: (scalar && !already) || (already && points[0].len() == 2), rational: already };
            if already && points[0].len() < 2 {
                let error = Diagnostic::error(
                    Code::ControlPoints,
                    "homogeneous points have a coordinate and a weight",
                );
                return Err(error.at(self.span(i)).hint("write the weight as the last coordinate"));
            }
            return Ok((points, form));
        };
        let Value::List(items) = weights else {
            return Err(wrong_kind("a list of weights", weights).at(span));
        };
        let weights: Option<Vec<Fraction>> = items.iter().map(|item| item.as_scalar().cloned()).collect();
        let weights =
            weights.ok_or_else(|| wrong_kind("a list of weights", weights_value(items)).at(span))?;
        if weights.len() != points.len() {
            let error = CurveError::WeightCount { weights: weights.len(), points: points.len() };
            return Err(curve_error(error).at(span));
        }
        if let Some(index) = weights.iter().position(Zero::is_zero) {
            return Err(curve_error(CurveError::ZeroWeight { index }).at(span));
        }
        let points = points.iter().zip(&weights).map(|(point, weight)| homogeneous(point, weight)).collect();
        Ok((points, Form { scalar, rational: true }))
    }

    /// A curve or surface.
    pub(crate) fn geometry(&self, i: usize) -> Result<Arc<Geometry>> {
        match self.value(i)? {
            Value::Geometry(geometry) => Ok(geometry.clone()),
            other => Err(wrong_kind("a curve", other)
                .at(self.span(i))
                .hint("bezier([[0, 0], [1, 2], [2, 0]]) makes one")),
        }
    }

    /// A Bézier curve; a polynomial, polar form or list of such is one over [0, 1].
    pub(crate) fn bezier(&self, i: usize) -> Result<(BezierCurve<Fraction>, Form)> {
        let value = self.value(i)?;
        match value {
            Value::Geometry(geometry) => match &**geometry {
                Geometry::Bezier(curve, form) => return Ok((curve.clone(), *form)),
                other => {
                    return Err(Diagnostic::error(
                        Code::Type,
                        format!("expected a Bézier curve, not {}", other.kind()),
                    )
                    .at(self.span(i))
                    .hint("pieces(s) are the Bézier curves of a spline"));
                }
            },
            Value::Scalar(_) | Value::Function(_) | Value::Polar(_) => {
                let form = self.with_first(value.clone()).univariate_in(0, None).at(self.span(i))?;
                let curve = BezierCurve::from_power(&[form.coefficients], Fraction::zero(), Fraction::one());
                return Ok((curve.map_err(curve_error)?, Form { scalar: true, rational: false }));
            }
            Value::List(items) if super::curves::is_curve(items) => {
                let coordinates = items.iter().map(|item| {
                    self.with_first(item.clone()).univariate_in(0, None).map(|given| given.coefficients)
                });
                let coordinates: Vec<Vec<Fraction>> = coordinates.collect::<Result<_>>().at(self.span(i))?;
                let curve = BezierCurve::from_power(&coordinates, Fraction::zero(), Fraction::one());
                return Ok((curve.map_err(curve_error)?, Form::default()));
            }
            _ => {}
        }
        Err(wrong_kind("a Bézier curve", value)
            .at(self.span(i))
            .hint("bezier([[0, 0], [1, 2], [2, 0]]) makes one"))
    }

    /// A spline; a Bézier curve is one without inner knots.
    pub(crate) fn spline(&self, i: usize) -> Result<(BSpline<Fraction>, Form)> {
        let value = self.value(i)?;
        if let Value::Geometry(geometry) = value {
            match &**geometry {
                Geometry::Spline(spline, form) => return Ok((spline.clone(), *form)),
                Geometry::Bezier(curve, form) => {
                    return Ok((as_spline(curve).map_err(spline_error)?, *form));
                }
                _ => {}
            }
        }
        if let Some(pieces) = polynomial_pieces(value) {
            let scalar = matches!(value, Value::Piecewise(_));
            let joined = joined(&pieces.map_err(curve_error)?).at(self.span(i))?;
            return Ok((joined, Form { scalar, rational: false }));
        }
        Err(wrong_kind("a B-spline curve", value)
            .at(self.span(i))
            .hint("bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]) makes one"))
    }

    /// A control net at a place: rows of points, with weights if they are named.
    pub(crate) fn net(&self, i: usize) -> Result<(Vec<Vec<Point<Fraction>>>, Form)> {
        let wrong = |value: &Value| {
            wrong_kind("a control net", value)
                .at(self.span(i))
                .hint("rows of points, such as [[[0, 0, 0], [0, 1, 1]], [[1, 0, 1], [1, 1, 0]]]")
        };
        let value = self.value(i)?;
        let rows: Vec<Value> = match value {
            Value::List(rows) => rows.clone(),
            Value::Matrix(matrix) => matrix.row_iter().map(|row| scalar_list(row.iter().cloned())).collect(),
            other => return Err(wrong(other)),
        };
        let weights = match self.named_or("weights", usize::MAX) {
            None => None,
            Some((Value::List(rows), _)) => Some(rows.clone()),
            Some((Value::Matrix(matrix), _)) => {
                Some(matrix.row_iter().map(|row| scalar_list(row.iter().cloned())).collect())
            }
            Some((other, span)) => return Err(wrong_kind("rows of weights", other).at(span)),
        };
        if let Some(weights) = &weights
            && weights.len() != rows.len()
        {
            let error = CurveError::WeightCount { weights: weights.len(), points: rows.len() };
            return Err(curve_error(error).at(self.span(i)));
        }
        let mut net = Vec::with_capacity(rows.len());
        let mut form = Form::default();
        for (k, row) in rows.into_iter().enumerate() {
            if points_of(&row).is_none() {
                return Err(wrong(value));
            }
            let mut part = Arguments::default();
            part.push(row, self.span(i));
            if let Some(weights) = &weights {
                let place = self.named_or("weights", usize::MAX).map_or(self.span(i), |(_, span)| span);
                part.push_named("weights".to_owned(), weights[k].clone(), place);
            }
            if let Some((value, span)) = self.named_or("homogeneous", usize::MAX) {
                part.push_named("homogeneous".to_owned(), value.clone(), span);
            }
            let (points, own) = part.control_points(0)?;
            form = own;
            net.push(points);
        }
        Ok((net, form))
    }

    /// An interval `[a, b]` at a place; [0, 1] if it is missing.
    pub(crate) fn interval(&self, i: usize) -> Result<Interval<Fraction>> {
        if self.len() <= i {
            return Ok(Interval::unit());
        }
        let list = self.scalars(i)?;
        let [a, b] = list.as_slice() else {
            return Err(Diagnostic::error(Code::Shape, "an interval has two ends")
                .at(self.span(i))
                .hint("such as [0, 1]"));
        };
        Interval::new(a.clone(), b.clone()).map_err(curve_error).at(self.span(i))
    }

    /// A triangle `[[0, 0], [1, 0], [0, 1]]` in the plane at a place; that one if it is missing.
    pub(crate) fn triangle(&self, i: usize) -> Result<Triangle<Fraction>> {
        if self.len() <= i {
            return Ok(Triangle::unit());
        }
        let value = self.value(i)?;
        let corners = points_of(value).and_then(|(points, _)| <[Point<Fraction>; 3]>::try_from(points).ok());
        let corners = corners.ok_or_else(|| {
            wrong_kind("three points of the plane", value)
                .at(self.span(i))
                .hint("such as [[0, 0], [1, 0], [0, 1]]")
        })?;
        Triangle::new(corners).map_err(curve_error).at(self.span(i))
    }

    /// A point at a place.
    pub(crate) fn point(&self, i: usize) -> Result<Point<Fraction>> {
        let value = self.value(i)?;
        point_of(value).map(|(point, _)| point).ok_or_else(|| wrong_kind("a point", value).at(self.span(i)))
    }

    /// All further scalars.
    pub(crate) fn scalars_from(&self, first: usize) -> Result<Vec<Fraction>> {
        (first..self.len()).map(|i| self.scalar(i)).collect()
    }

    /// Scalars from one list, or written one after the other.
    pub(crate) fn scalars_or_list(&self, first: usize) -> Result<Vec<Fraction>> {
        match self.value(first) {
            Ok(Value::List(_)) => self.scalars(first),
            _ => self.scalars_from(first),
        }
    }
}

/// The first item that is not a weight.
fn weights_value(items: &[Value]) -> &Value {
    items.iter().find(|item| item.as_scalar().is_none()).unwrap_or(&items[0])
}

/// The value of a curve or surface at the arguments of a call.
pub(crate) fn call_geometry(geometry: &Geometry, values: &[(Value, Span)], span: Span) -> Result<Value> {
    let form = geometry.form();
    let point = match geometry {
        Geometry::Bezier(curve, _) => {
            let [(t, place)] = scalars(geometry, values, span)?;
            if curve.contains(&t) == Some(false) {
                return Err(outside(place, "interval", curve.interval()));
            }
            curve.value(&t)
        }
        Geometry::Spline(spline, _) => {
            let [(t, place)] = scalars(geometry, values, span)?;
            spline.value(&t).map_err(|error| match error {
                SplineError::OutsideDomain => outside(place, "domain", spline.domain()),
                other => spline_error(other).at(place),
            })?
        }
        Geometry::Patch(patch, _) => {
            let [u, v] = scalars(geometry, values, span)?;
            for ((t, place), interval) in [(&u, patch.u()), (&v, patch.v())] {
                if interval.contains(t) == Some(false) {
                    return Err(outside(*place, "interval", (interval.start(), interval.end())));
                }
            }
            patch.value(&u.0, &v.0)
        }
        Geometry::Surface(surface, _) => {
            let [(u, place), (v, _)] = scalars(geometry, values, span)?;
            surface.value(&u, &v).map_err(spline_error).at(place)?
        }
        Geometry::Triangle(patch, _) => {
            let p = plane_point(geometry, values, span)?;
            if patch.triangle().contains(&p) == Ok(Some(false)) {
                let problem = curve_error(CurveError::OutsideDomain).at(values[0].1);
                return Err(problem.reason("the point lies outside of the triangle"));
            }
            patch.value(&p).map_err(curve_error).at(span)?
        }
    };
    form.value(point).map_err(curve_error).at(span)
}

/// A point of the parameter plane: `[x, y]`, or x and y.
fn plane_point(geometry: &Geometry, values: &[(Value, Span)], span: Span) -> Result<Point<Fraction>> {
    if let [(value @ Value::List(_), place)] = values {
        let (point, _) = point_of(value).ok_or_else(|| wrong_kind("a point", value).at(*place))?;
        return Ok(point);
    }
    // Three numbers of sum 1 are barycentric coordinates.
    if let (Geometry::Triangle(patch, _), [_, _, _]) = (geometry, values) {
        let [(u, _), (v, _), (w, place)] = scalars(geometry, values, span)?;
        let weights = [u, v, w];
        let sum = weights.iter().fold(Fraction::zero(), |sum, x| sum.plus(x));
        if !sum.is_one() {
            let problem =
                Diagnostic::error(Code::Domain, format!("barycentric coordinates add up to 1, not to {sum}"));
            return Err(problem.at(place).hint("two numbers are coordinates of the parameter plane"));
        }
        return Ok(patch.triangle().point(&weights));
    }
    let [(x, _), (y, _)] = scalars(geometry, values, span)?;
    Ok(vec![x, y])
}

/// As many scalars as the call needs.
fn scalars<const N: usize>(
    geometry: &Geometry,
    values: &[(Value, Span)],
    span: Span,
) -> Result<[(Fraction, Span); N]> {
    let list = values.iter().map(|(value, place)| match value {
        Value::Scalar(x) => Ok((x.clone(), *place)),
        other => Err(wrong_kind("a number or symbol", other).at(*place)),
    });
    let list: Vec<(Fraction, Span)> = list.collect::<Result<_>>()?;
    let given = list.len();
    <[(Fraction, Span); N]>::try_from(list).map_err(|_| {
        let plural = if N == 1 { "" } else { "s" };
        Diagnostic::error(
            Code::Arity,
            format!("{} takes {N} parameter{plural}, not {given}", geometry.kind()),
        )
        .at(span)
        .hint("polar(c)(u, v, ...) is a value of its polar form")
    })
}

fn outside(place: Span, what: &str, (a, b): (&Fraction, &Fraction)) -> Diagnostic {
    curve_error(CurveError::OutsideDomain).at(place).reason(format!("the {what} is [{a}, {b}]"))
}

/// The value of a piecewise polynomial.
pub(crate) fn call_piecewise(
    function: &PiecewiseFunction,
    values: &[(Value, Span)],
    span: Span,
) -> Result<Value> {
    let [(argument, place)] = values else {
        return Err(
            Diagnostic::error(Code::Arity, format!("one argument needed, {} given", values.len())).at(span)
        );
    };
    let t = argument.as_scalar().ok_or_else(|| wrong_kind("a number or symbol", argument).at(*place))?;
    function.value(t).map_err(piecewise_error).at(*place)
}

/// The curve with homogeneous coordinates, all weights 1 if it is polynomial.
pub(crate) fn as_rational_form(curve: &BezierCurve<Fraction>, form: Form) -> BezierCurve<Fraction> {
    if form.rational {
        return curve.clone();
    }
    let points = curve.points().iter().map(|point| homogeneous(point, &Fraction::one())).collect();
    let (a, b) = curve.interval();
    BezierCurve::new(points, a.clone(), b.clone()).expect("only a coordinate was added")
}

/// A Bézier curve as a spline without inner knots.
pub(crate) fn as_spline(
    curve: &BezierCurve<Fraction>,
) -> std::result::Result<BSpline<Fraction>, SplineError> {
    let (a, b) = curve.interval();
    let knots = crate::math::spline::KnotVector::clamped(curve.degree(), a, &[], b)?;
    BSpline::new(knots, curve.points().to_vec())
}

/// The spline with homogeneous coordinates, all weights 1 if it is polynomial.
pub(crate) fn as_rational_spline(spline: &BSpline<Fraction>, form: Form) -> BSpline<Fraction> {
    if form.rational {
        return spline.clone();
    }
    let points = spline.points().iter().map(|point| homogeneous(point, &Fraction::one())).collect();
    BSpline::new(spline.knots().clone(), points).expect("only a coordinate was added")
}

/// The sum of two piecewise polynomials.
pub(crate) fn add_piecewise(a: &PiecewiseFunction, b: &PiecewiseFunction) -> Result<Value> {
    let function = a.function.sum(&b.function).ok_or_else(|| {
        Diagnostic::error(Code::Undecided, "the breakpoints of the two functions cannot be put in one order")
            .hint("symbolic breakpoints have to be the same in both")
    })?;
    Ok(Value::Piecewise(Arc::new(PiecewiseFunction { function, variable: a.variable.clone() })))
}

/// A multiple of a piecewise polynomial.
pub(crate) fn scale_piecewise(factor: &Fraction, f: &PiecewiseFunction) -> Value {
    let function = f.function.map(|piece| piece.scaled(factor));
    Value::Piecewise(Arc::new(PiecewiseFunction { function, variable: f.variable.clone() }))
}

/// The sum of two polynomial Bézier curves over one interval, of the larger degree.
pub(crate) fn add_curves(a: &Geometry, b: &Geometry) -> Result<Value> {
    let (Geometry::Bezier(f, left), Geometry::Bezier(g, right)) = (a, b) else {
        let message = format!("{} and {} cannot be added", a.kind(), b.kind());
        return Err(
            Diagnostic::error(Code::Type, message).hint("polynomial Bézier curves over one interval can be")
        );
    };
    if left.rational || right.rational || f.interval() != g.interval() {
        return Err(Diagnostic::error(Code::Shape, "only polynomial curves over one interval can be added")
            .hint("over(c, a, b) moves a curve to another interval"));
    }
    if f.dimension() != g.dimension() {
        return Err(curve_error(CurveError::DimensionsOf { left: f.dimension(), right: g.dimension() }));
    }
    let n = f.degree().max(g.degree());
    let (f, g) = (f.elevate(n - f.degree()), g.elevate(n - g.degree()));
    let points = f.points().iter().zip(g.points()).map(|(p, q)| crate::math::curve::sum(p, q)).collect();
    let (start, end) = f.interval();
    let curve = BezierCurve::new(points, start.clone(), end.clone()).map_err(curve_error)?;
    Ok(bezier(curve, Form { scalar: left.scalar && right.scalar, rational: false }))
}

/// A curve scaled from the origin.
pub(crate) fn scale_curve(factor: &Fraction, c: &Geometry) -> Result<Value> {
    let form = c.form();
    let scaled = |point: &Point<Fraction>| -> Point<Fraction> {
        let last = point.len() - usize::from(form.rational);
        point.iter().enumerate().map(|(k, x)| if k < last { x.times(factor) } else { x.clone() }).collect()
    };
    match c {
        Geometry::Bezier(curve, _) => {
            let (a, b) = curve.interval();
            let points = curve.points().iter().map(scaled).collect();
            BezierCurve::new(points, a.clone(), b.clone()).map(|c| bezier(c, form)).map_err(curve_error)
        }
        Geometry::Spline(s, _) => {
            let points = s.points().iter().map(scaled).collect();
            BSpline::new(s.knots().clone(), points).map(|s| spline(s, form)).map_err(spline_error)
        }
        other => Err(Diagnostic::error(Code::Type, format!("{} has no multiples here", other.kind()))),
    }
}
