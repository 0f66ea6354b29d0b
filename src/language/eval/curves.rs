//! Values of curves and surfaces: geometry, piecewise polynomials, lists of coordinate functions.

use super::arguments::{Arguments, named};
use super::machine::{Evaluated, Machine};
use crate::formula::Expr;
use crate::formula::source::Span;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::errors::{curve_error, piecewise_error, polar_error, spline_error, wrong_kind};
use crate::language::ops::geometry::point_of;
use crate::language::ops::polar::argument;
use crate::language::value::{Geometry, PiecewiseFunction, PolarKind, Value};
use crate::math::curve::{CurveError, Point};
use crate::math::poly::Fraction;
use crate::math::ring::Ring;
use crate::math::spline::SplineError;
use num_traits::{One, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

impl Machine {
    /// `s(t, span=j)`: the polynomial of a spline on a knot interval, at a parameter; `None` without a span.
    pub(super) fn piece_of_spline(
        &mut self,
        spline: &Value,
        groups: &[Vec<Expr>],
        span: Span,
    ) -> Result<Option<Value>> {
        let [group] = groups else { return Ok(None) };
        let [parameter, interval] = group.as_slice() else { return Ok(None) };
        let Some((name, interval)) = named(interval).filter(|(name, _)| name == "span") else {
            return Ok(None);
        };
        let mut arguments = Arguments::default();
        arguments.push(spline.clone(), span);
        let value = self.eval(interval)?;
        arguments.push_named(name, value, interval.span);
        let form = self.call_function("polar", arguments)?;
        let at = (self.eval(parameter)?, parameter.span);
        let diagonal = |machine: &mut Self, form: &Value| match form {
            Value::Polar(polar) => match &polar.kind {
                PolarKind::Univariate(own) => machine.coordinate(form, &vec![at.clone(); own.degree()], span),
                _ => Err(wrong_kind("a spline", form).at(span)),
            },
            other => Err(wrong_kind("a spline", other).at(span)),
        };
        match &form {
            Value::List(items) => {
                let values = items.iter().map(|item| diagonal(self, item)).collect::<Result<_>>();
                values.map(|values| Some(Value::List(items.with(values))))
            }
            form => diagonal(self, form).map(Some),
        }
    }

    /// One coordinate of a curve at the given arguments.
    pub(crate) fn coordinate(&mut self, item: &Value, values: &[(Value, Span)], span: Span) -> Evaluated {
        match item {
            Value::Function(function) => self.call(function, values.to_vec(), span),
            Value::Polar(polar) => {
                let PolarKind::Univariate(form) = &polar.kind else {
                    return Err(wrong_kind("a polar form of a curve", item).at(span));
                };
                let list: Result<Vec<_>> =
                    values.iter().map(|(value, place)| argument(value.clone()).at(*place)).collect();
                form.value(&list?).map(Value::Scalar).map_err(polar_error).at(span)
            }
            Value::Piecewise(function) => call_piecewise(function, values, span),
            other => Err(wrong_kind("a function", other).at(span)),
        }
    }
}

/// The value of a curve or surface at the arguments of a call.
pub(crate) fn call_geometry(geometry: &Geometry, values: &[(Value, Span)], span: Span) -> Result<Value> {
    let form = geometry.form();
    let point = match geometry {
        Geometry::Bezier(curve, _) => {
            let [(t, place)] = scalars(geometry, values, span)?;
            if curve.contains(&t) == Some(false) {
                return Err(outside(place, "interval", curve.interval().ends()));
            }
            curve.value(&t)
        }
        Geometry::Spline(spline, _) => {
            let [(t, place)] = scalars(geometry, values, span)?;
            spline.value(&t).map_err(|error| match error {
                SplineError::OutsideDomain => outside(place, "domain", spline.interval().ends()),
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
    Ok([x, y].into())
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
