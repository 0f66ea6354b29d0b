//! Curves and surfaces among the arguments of a call.

use std::sync::Arc;

use super::Arguments;
use crate::formula::source::Span;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::errors::{curve_error, spline_error, wrong_kind};
use crate::language::ops::formula::{coefficients_in, curve_of, is_parameter, over_one_weight};
use crate::language::ops::geometry::{
    as_spline, joined, point_of, points_of, polynomial_pieces, scalar_list,
};
use crate::language::ops::lists::is_curve;
use crate::language::ops::takes::Takes;
use crate::language::value::{Form, Geometry, Value, homogeneous};
use crate::math::curve::{BezierCurve, CurveError, Interval, Point, Triangle};
use crate::math::poly::Fraction;
use crate::math::spline::BSpline;
use num_traits::Zero;

type Result<T> = std::result::Result<T, Diagnostic>;

fn has_parameter(formula: &Fraction) -> bool {
    formula.variables().iter().any(is_parameter)
}

impl Arguments {
    /// Control points at a place, with weights or homogeneous coordinates if they are named.
    pub(crate) fn control_points(&self, i: usize) -> Result<(Vec<Point<Fraction>>, Form)> {
        let value = self.value(i)?;
        let (points, scalar) =
            points_of(value).ok_or_else(|| Takes::Points.refuses(value).at(self.span(i)))?;
        let already = self.flag("homogeneous")?;
        let Some((weights, span)) = self.named("weights") else {
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
            other => Err(Takes::Geometry.refuses(other).at(self.span(i))),
        }
    }

    /// A Bézier curve; a polynomial, polar form or list of such is one over [0, 1], and so are formulas and control points.
    pub(crate) fn bezier(&self, i: usize) -> Result<(BezierCurve<Fraction>, Form)> {
        let value = self.value(i)?;
        if let Some((t, formulas)) = curve_of(value).at(self.span(i))? {
            let mut coordinates = over_one_weight(&formulas, &t).at(self.span(i))?;
            let rational = coordinates.last().is_some_and(|weight| weight.len() > 1);
            if !rational {
                coordinates = formulas.iter().map(|f| coefficients_in(f, &t)).collect::<Result<_>>()?;
            }
            let curve = BezierCurve::from_power(&coordinates, Interval::unit()).map_err(curve_error)?;
            return Ok((curve, Form { scalar: false, rational }));
        }
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
                let curve = BezierCurve::from_power(&[form.coefficients], Interval::unit());
                return Ok((curve.map_err(curve_error)?, Form { scalar: true, rational: false }));
            }
            Value::List(items) if is_curve(items) => {
                let coordinates = items.iter().map(|item| {
                    self.with_first(item.clone()).univariate_in(0, None).map(|given| given.coefficients)
                });
                let coordinates: Vec<Vec<Fraction>> = coordinates.collect::<Result<_>>().at(self.span(i))?;
                let curve = BezierCurve::from_power(&coordinates, Interval::unit());
                return Ok((curve.map_err(curve_error)?, Form::default()));
            }
            // [0, 1, 4], [[0, 0], [1, 2]]: control points; in [t, t^2] they might be coordinates.
            Value::List(_) => {
                if let Some((points, scalar)) = points_of(value)
                    && !points.iter().flat_map(|point| point.iter()).any(has_parameter)
                {
                    let curve = BezierCurve::new(points, Interval::unit());
                    return Ok((
                        curve.map_err(curve_error).at(self.span(i))?,
                        Form { scalar, rational: false },
                    ));
                }
            }
            _ => {}
        }
        Err(Takes::Curve.refuses(value).at(self.span(i)))
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
        Err(Takes::Spline.refuses(value).at(self.span(i)))
    }

    /// A control net at a place: rows of points, with weights if they are named.
    pub(crate) fn net(&self, i: usize) -> Result<(Vec<Vec<Point<Fraction>>>, Form)> {
        let wrong = |value: &Value| Takes::Net.refuses(value).at(self.span(i));
        let value = self.value(i)?;
        let rows: Vec<Value> = match value {
            Value::List(rows) => rows.to_vec(),
            Value::Matrix(matrix) => matrix.row_iter().map(|row| scalar_list(row.iter().cloned())).collect(),
            other => return Err(wrong(other)),
        };
        let weights = match self.named("weights") {
            None => None,
            Some((Value::List(rows), _)) => Some(rows.to_vec()),
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
                let place = self.named("weights").map_or(self.span(i), |(_, span)| span);
                part.push_named("weights".to_owned(), weights[k].clone(), place);
            }
            if let Some((value, span)) = self.named("homogeneous") {
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
        if self.given(i).is_none() {
            return Ok(Interval::unit());
        }
        interval_of(self.scalars(i)?, self.span(i))
    }

    /// An interval under a name.
    pub(crate) fn named_interval(&self, name: &str) -> Result<Option<Interval<Fraction>>> {
        let span = self.named(name).map_or_else(Span::default, |(_, span)| span);
        self.named_scalars(name)?.map(|ends| interval_of(ends, span)).transpose()
    }

    /// A triangle `[[0, 0], [1, 0], [0, 1]]` in the plane at a place; that one if it is missing.
    pub(crate) fn triangle(&self, i: usize) -> Result<Triangle<Fraction>> {
        if self.given(i).is_none() {
            return Ok(Triangle::unit());
        }
        let value = self.value(i)?;
        let corners = points_of(value).and_then(|(points, _)| <[Point<Fraction>; 3]>::try_from(points).ok());
        let corners = corners.ok_or_else(|| Takes::Triangle.refuses(value).at(self.span(i)))?;
        Triangle::new(corners).map_err(curve_error).at(self.span(i))
    }

    /// A point at a place.
    pub(crate) fn point(&self, i: usize) -> Result<Point<Fraction>> {
        let value = self.value(i)?;
        point_of(value).map(|(point, _)| point).ok_or_else(|| Takes::Point.refuses(value).at(self.span(i)))
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

fn interval_of(ends: Vec<Fraction>, span: Span) -> Result<Interval<Fraction>> {
    let [a, b] = <[Fraction; 2]>::try_from(ends).map_err(|_| {
        Diagnostic::error(Code::Shape, "an interval has two ends").at(span).hint("such as [0, 1]")
    })?;
    Interval::new(a, b).map_err(curve_error).at(span)
}

/// The first item that is not a weight.
fn weights_value(items: &[Value]) -> &Value {
    items.iter().find(|item| item.as_scalar().is_none()).unwrap_or(&items[0])
}
