//! What functions such as `derivative` and `elevate` do with curves.

use super::gives::Gives;
use crate::language::eval::{Arguments, Evaluated, call_geometry, call_piecewise};
use crate::language::ops::arithmetic;
use crate::language::ops::errors::{curve_error, division_by_zero, polar_error, spline_error, wrong_kind};
use crate::language::ops::geometry::{bezier, scalar_list, spline};
use std::sync::Arc;

use super::parameter::{CURVE, free, named, optional, required};
use super::record::Variant;
use crate::formula::source::Span;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::takes::Takes;
use crate::language::value::{Form, Geometry, PiecewiseFunction, Polar, PolarKind, Value, symbol_expr};
use crate::math::curve::{Interval, RationalCurve};
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::{Field, Ring};
use crate::math::spline::RationalSpline;
use num_traits::{One, Zero};

pub(super) const POLAR: Option<Variant> = Variant::new(
    &[
        CURVE,
        named("span=j", Takes::Size, "the only one", "the knot interval of a spline"),
        named("degree=n", Takes::Size, "the degree of the curve", "the number of arguments"),
    ],
    Gives::Polar,
    polar,
);

pub(super) const ELEVATE: Option<Variant> =
    Variant::new(&[CURVE, optional("k", Takes::Size, "1", "by how many degrees")], Gives::SameCurve, elevate);

pub(super) const REDUCE: Option<Variant> =
    Variant::new(&[CURVE, optional("k", Takes::Size, "1", "by how many degrees")], Gives::SameCurve, reduce);

pub(super) const DERIVATIVE: Option<Variant> = Variant::new(
    &[
        CURVE,
        optional("variable", Takes::Variable, "the parameter", "the variable, as for formulas").shown("t"),
        optional("k", Takes::Size, "1", "how often, also in the second place"),
    ],
    Gives::SameCurve,
    derivative,
);

pub(super) const SUBS: Option<Variant> = Variant::new(
    &[CURVE, free("t=value", Takes::Scalar, "the parameter at which its value is wanted")],
    Gives::Point,
    subs,
);

pub(super) const INTEGRATE: Option<Variant> = Variant::new(
    &[
        CURVE,
        optional("variable", Takes::Variable, "the parameter", "the variable, as for formulas").shown("t"),
        optional("a", Takes::Scalar, "the whole interval", "the lower bound, also in the second place"),
        optional("b", Takes::Scalar, "the whole interval", "the upper bound, also in the third place"),
    ],
    Gives::Point,
    integrate,
);

pub(super) const BEZIER_POINTS: Option<Variant> = Variant::new(
    &[
        CURVE,
        optional("a", Takes::Scalar, "its own interval", "the start of the interval"),
        optional("b", Takes::Scalar, "a + 1", "its end"),
    ],
    Gives::Points,
    bezier_points,
);

pub(super) const COMPOSE: Option<Variant> = Variant::new(
    &[CURVE, required("G", Takes::Polynomial, "the function that is put in for the parameter")],
    Gives::Curve,
    compose,
);

pub(super) const DEGREE: Option<Variant> = Variant::new(&[CURVE], Gives::Count, degree);

pub(super) const COEFFICIENTS: Option<Variant> = Variant::new(&[CURVE], Gives::Points, coefficients);

/// A rational curve has no polar form of its own: only its homogeneous one.
fn polynomial(form: Form, args: &Arguments) -> Result<(), Diagnostic> {
    if !form.rational {
        return Ok(());
    }
    Err(Diagnostic::error(Code::NotPolynomial, "this curve is rational, not polynomial")
        .at(args.span(0))
        .hint("homogeneous(c) is the polynomial curve of its homogeneous coordinates"))
}

fn not_a_curve(geometry: &Geometry, args: &Arguments) -> Diagnostic {
    Diagnostic::error(Code::Type, format!("expected a curve, not {}", geometry.kind()))
        .at(args.span(0))
        .hint("boundary_curves(s) are curves of a surface")
}

fn forms_value(forms: Vec<crate::math::blossom::PolarForm<Fraction>>, form: Form) -> Value {
    // Knots called t_1, t_2 would be mistaken for the arguments.
    let taken = |name: &str| {
        let all = forms.iter().flat_map(|form| form.coefficients());
        all.flat_map(Fraction::variables).any(|symbol| symbol.base() == name)
    };
    let name = ["t", "u", "v", "x"].into_iter().find(|name| !taken(name)).unwrap_or("t");
    let wrap = |form| {
        Value::Polar(Arc::new(Polar {
            kind: PolarKind::Univariate(form),
            variables: vec![Symbol::new(name)],
        }))
    };
    let mut list: Vec<Value> = forms.iter().cloned().map(wrap).collect();
    if form.scalar && list.len() == 1 { list.swap_remove(0) } else { Value::point(list) }
}

pub(crate) fn polar(args: &Arguments) -> Evaluated {
    let geometry = args.geometry(0)?;
    polynomial(geometry.form(), args)?;
    let curve = match &*geometry {
        Geometry::Bezier(curve, _) => curve.clone(),
        Geometry::Spline(spline, _) => {
            let span = match args.named_size("span")? {
                Some(span) => span,
                None => match spline.knots().spans().as_slice() {
                    [only] => *only,
                    many => {
                        let list: Vec<String> = many.iter().map(usize::to_string).collect();
                        return Err(Diagnostic::error(
                            Code::Undecided,
                            "a spline has a polar form for each knot interval",
                        )
                        .at(args.span(0))
                        .hint(format!("name one: polar(s, span=j) with j one of {}", list.join(", "))));
                    }
                },
            };
            spline.bezier_piece(span).map_err(spline_error)?
        }
        other => return Err(not_a_curve(other, args)),
    };
    let by = match args.named_size("degree")? {
        Some(degree) => degree.checked_sub(curve.degree()).ok_or_else(|| {
            Diagnostic::error(Code::DegreeTooSmall, format!("the curve has degree {}", curve.degree()))
        })?,
        None => 0,
    };
    let forms = curve.polar_forms().into_iter().map(|form| form.elevate(by)).collect();
    Ok(forms_value(forms, geometry.form()))
}

fn elevate(args: &Arguments) -> Evaluated {
    let by = args.size(1)?;
    match &*args.geometry(0)? {
        Geometry::Bezier(curve, form) => Ok(bezier(curve.elevate(by), *form)),
        Geometry::Spline(s, form) => s.elevate(by).map(|s| spline(s, *form)).map_err(spline_error),
        other => Err(not_a_curve(other, args)),
    }
}

fn reduce(args: &Arguments) -> Evaluated {
    let by = args.size(1)?;
    match &*args.geometry(0)? {
        Geometry::Bezier(curve, form) => {
            curve.reduce(by).map(|c| bezier(c, *form)).map_err(curve_error).at(args.span(0))
        }
        Geometry::Spline(s, form) => {
            s.reduce(by).map(|s| spline(s, *form)).map_err(spline_error).at(args.span(0))
        }
        other => Err(not_a_curve(other, args)),
    }
}

fn derivative(args: &Arguments) -> Evaluated {
    nth_derivative(args, args.size(2)?)
}

/// The derivative of that order of the curve at the first place.
pub(super) fn nth_derivative(args: &Arguments, order: usize) -> Evaluated {
    if let Value::Piecewise(function) = args.value(0)? {
        let derived = function.function.nth_derivative(order);
        let variable = function.variable.clone();
        return Ok(Value::Piecewise(Arc::new(PiecewiseFunction::new(derived, variable))));
    }
    match &*args.geometry(0)? {
        Geometry::Bezier(curve, form) if form.rational => {
            let curve =
                RationalCurve::from_homogeneous(curve.clone()).map_err(curve_error).at(args.span(0))?;
            let derived = (0..order).fold(curve, |curve, _| curve.derivative());
            Ok(bezier(derived.homogeneous().clone(), *form))
        }
        Geometry::Bezier(curve, form) => Ok(bezier(curve.nth_derivative(order), *form)),
        Geometry::Spline(s, form) if form.rational => {
            let derived = RationalSpline::from_homogeneous(s.clone())
                .and_then(|s| (0..order).try_fold(s, |s, _| s.derivative()));
            let derived = derived.map_err(spline_error).at(args.span(0))?;
            Ok(spline(derived.homogeneous().clone(), *form))
        }
        Geometry::Spline(s, form) => {
            s.nth_derivative(order).map(|s| spline(s, *form)).map_err(spline_error).at(args.span(0))
        }
        other => Err(not_a_curve(other, args)),
    }
}

/// The value of a curve at its parameter, whatever that is called; its points keep their symbols.
fn subs(args: &Arguments) -> Evaluated {
    let values = args.substitutions()?;
    let span = args.span(0);
    let [(name, value)] = values.as_slice() else {
        return Err(Diagnostic::error(Code::Arity, "a curve has one parameter").at(span));
    };
    let curve = args.value(0)?;
    let letter = symbol_expr(name);
    if matches!(curve, Value::Geometry(_)) && curve.to_expr().has(&|part| part.same_as(&letter)) {
        let problem = Diagnostic::error(Code::Type, format!("{name} stands in the points of this curve"));
        return Err(problem.at(span).hint("a curve c has its value c(1/2)"));
    }
    value_at(curve, value.clone(), span)
}

/// The value of a curve or piecewise polynomial.
fn value_at(curve: &Value, t: Fraction, span: Span) -> Result<Value, Diagnostic> {
    let value = [(Value::Scalar(t), span)];
    match curve {
        Value::Piecewise(function) => call_piecewise(function, &value, span),
        Value::Geometry(geometry) => call_geometry(geometry, &value, span),
        other => Err(wrong_kind("a curve", other)),
    }
}

/// The bounds of an integral, behind its function and its variable.
pub(super) fn bounds(args: &Arguments) -> Result<Option<(Fraction, Fraction)>, Diagnostic> {
    match (args.optional_scalar(2)?, args.optional_scalar(3)?) {
        (Some(a), Some(b)) => Ok(Some((a, b))),
        (None, None) => Ok(None),
        _ => Err(Diagnostic::error(Code::Arity, "an integral needs both bounds or none")
            .at(args.span(args.len() - 1))),
    }
}

/// The integral over the whole interval, or from a to b.
fn integrate(args: &Arguments) -> Evaluated {
    if let Some((from, to)) = bounds(args)? {
        let primitive = antiderivative(&args.only(1))?;
        return arithmetic::add(
            value_at(&primitive, to, args.span(3))?,
            arithmetic::negate(value_at(&primitive, from, args.span(2))?)?,
        );
    }
    if let Value::Piecewise(function) = args.value(0)? {
        return Ok(Value::Scalar(function.function.integral()));
    }
    let geometry = args.geometry(0)?;
    polynomial(geometry.form(), args)?;
    let form = geometry.form();
    match &*geometry {
        Geometry::Bezier(curve, _) => Ok(form.plain(curve.integral())),
        Geometry::Spline(spline, _) => Ok(form.plain(spline.integral())),
        other => Err(not_a_curve(other, args)),
    }
}

pub(crate) fn antiderivative(args: &Arguments) -> Evaluated {
    match args.value(0)? {
        Value::Piecewise(function) => {
            let primitive = function.function.antiderivative();
            let variable = function.variable.clone();
            Ok(Value::Piecewise(Arc::new(PiecewiseFunction::new(primitive, variable))))
        }
        Value::Geometry(geometry) => {
            polynomial(geometry.form(), args)?;
            match &**geometry {
                Geometry::Bezier(curve, form) => {
                    let start = vec![Fraction::zero(); curve.dimension()];
                    curve.antiderivative(start).map(|c| bezier(c, *form)).map_err(curve_error)
                }
                Geometry::Spline(s, form) => {
                    s.antiderivative().map(|s| spline(s, *form)).map_err(spline_error)
                }
                other => Err(not_a_curve(other, args)),
            }
        }
        other => Err(wrong_kind("a curve or piecewise polynomial", other)
            .at(args.span(0))
            .hint("integrate(F, t) is an antiderivative of a formula")),
    }
}

fn bezier_points(args: &Arguments) -> Evaluated {
    let (curve, form) = args.bezier(0)?;
    let curve = match (args.optional_scalar(1)?, args.optional_scalar(2)?) {
        (None, None) => curve,
        (a, b) => {
            let a = a.unwrap_or_else(|| curve.interval().start().clone());
            let b = b.unwrap_or_else(|| a.plus(&Fraction::one()));
            let place = if args.given(1).is_some() { 1 } else { 2 };
            curve.part(Interval::new(a, b).map_err(curve_error).at(args.span(place))?)
        }
    };
    match form.split(curve.points()) {
        Some((values, _)) => Ok(Value::list(values)),
        None => Err(curve_error(crate::math::curve::CurveError::ZeroDenominator).at(args.span(0))),
    }
}

/// c(G(t)): over the interval that G takes to that of c if G is linear, else over [0, 1].
fn compose(args: &Arguments) -> Evaluated {
    let (curve, form) = args.bezier(0)?;
    let inner = args.univariate(1)?.coefficients;
    let interval = match inner.as_slice() {
        [shift, slope] if !slope.is_zero() => {
            let inverse = Field::inverse(slope).ok_or_else(division_by_zero)?;
            let (a, b) = curve.interval().ends();
            let taken = |x: &Fraction| x.minus(shift).times(&inverse);
            Interval::new(taken(a), taken(b)).map_err(curve_error)?
        }
        _ => Interval::unit(),
    };
    let degree = inner.len() - 1;
    let inner = crate::math::blossom::PolarForm::with_degree(inner, degree).map_err(polar_error)?;
    curve.compose(&inner, interval).map(|c| bezier(c, form)).map_err(curve_error)
}

fn degree(args: &Arguments) -> Evaluated {
    if let Value::Piecewise(function) = args.value(0)? {
        return Ok(Value::int(function.function.degree() as i64));
    }
    Ok(Value::int(match &*args.geometry(0)? {
        Geometry::Bezier(curve, _) => curve.degree(),
        Geometry::Spline(spline, _) => spline.degree(),
        other => return Err(not_a_curve(other, args)),
    } as i64))
}

/// The power coefficients of each coordinate, lowest first.
pub(crate) fn coefficients(args: &Arguments) -> Evaluated {
    let (curve, form) = args.bezier(0)?;
    polynomial(form, args)?;
    let mut rows: Vec<Value> = curve.power().into_iter().map(scalar_list).collect();
    Ok(if form.scalar { rows.swap_remove(0) } else { Value::list(rows) })
}

/// The product of two curves or splines over one interval.
pub(crate) fn product(args: &Arguments) -> Evaluated {
    let splines = [args.value(0)?, args.value(1)?].into_iter().any(
        |value| matches!(value, Value::Geometry(geometry) if matches!(**geometry, Geometry::Spline(..))),
    );
    let joint = |left: Form, right: Form, dimension: usize| -> Result<Form, Diagnostic> {
        polynomial(left, args)?;
        polynomial(right, args)?;
        Ok(Form { scalar: dimension == 1, rational: false })
    };
    if splines {
        let ((f, left), (g, right)) = (args.spline(0)?, args.spline(1)?);
        let product = f.product(&g).map_err(spline_error).at(args.span(1))?;
        let form = joint(left, right, product.dimension())?;
        return Ok(spline(product, form));
    }
    let ((f, left), (g, right)) = (args.bezier(0)?, args.bezier(1)?);
    let product = f.product(&g).map_err(curve_error).at(args.span(1))?;
    let form = joint(left, right, product.dimension())?;
    Ok(bezier(product, form))
}
