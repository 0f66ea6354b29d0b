//! What functions such as `derivative` and `elevate` do with curves.

use std::sync::Arc;

use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated, call_geometry, call_piecewise};
use crate::language::ops::errors::{curve_error, division_by_zero, polar_error, spline_error, wrong_kind};
use crate::language::ops::geometry::{bezier, scalar_list, spline};
use crate::language::ops::{arithmetic, formula};
use crate::language::value::{Form, Geometry, PiecewiseFunction, Polar, PolarKind, Value};
use crate::math::curve::RationalCurve;
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::{Field, Ring};
use num_traits::{One, Zero};

/// The meaning of a function for a curve or surface as its first argument, if it has one.
pub(crate) fn method(name: &str, first: &Value) -> Option<fn(&Arguments) -> Evaluated> {
    match first {
        Value::Geometry(geometry) if geometry.is_surface() => super::on_surface::method(name),
        Value::Geometry(_) | Value::Piecewise(_) => on_curve(name),
        _ => None,
    }
}

fn on_curve(name: &str) -> Option<fn(&Arguments) -> Evaluated> {
    Some(match name {
        "polar" => polar,
        "elevate" => elevate,
        "reduce" => reduce,
        "derivative" | "diff" => derivative,
        "integrate" => integrate,
        "bezier_points" => bezier_points,
        "compose" => compose,
        "degree" => degree,
        "coefficients" => coefficients,
        _ => return None,
    })
}

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
    if form.scalar && list.len() == 1 { list.swap_remove(0) } else { Value::List(list) }
}

pub(crate) fn polar(args: &Arguments) -> Evaluated {
    args.expect("polar(c, span=j)", 1..=1, &["span", "degree"])?;
    let geometry = args.geometry(0)?;
    polynomial(geometry.form(), args)?;
    let curve = match &*geometry {
        Geometry::Bezier(curve, _) => curve.clone(),
        Geometry::Spline(spline, _) => {
            let span = match args.named_size("span", usize::MAX)? {
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
    let by = match args.named_size("degree", usize::MAX)? {
        Some(degree) => degree.checked_sub(curve.degree()).ok_or_else(|| {
            Diagnostic::error(Code::DegreeTooSmall, format!("the curve has degree {}", curve.degree()))
        })?,
        None => 0,
    };
    let forms = curve.polar_forms().into_iter().map(|form| form.elevate(by)).collect();
    Ok(forms_value(forms, geometry.form()))
}

fn elevate(args: &Arguments) -> Evaluated {
    args.expect("elevate(c, k)", 1..=2, &["k"])?;
    let by = args.named_size("k", 1)?.unwrap_or(1);
    match &*args.geometry(0)? {
        Geometry::Bezier(curve, form) => Ok(bezier(curve.elevate(by), *form)),
        Geometry::Spline(s, form) => s.elevate(by).map(|s| spline(s, *form)).map_err(spline_error),
        other => Err(not_a_curve(other, args)),
    }
}

fn reduce(args: &Arguments) -> Evaluated {
    args.expect("reduce(c, k)", 1..=2, &["k"])?;
    let by = args.named_size("k", 1)?.unwrap_or(1);
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

pub(crate) fn derivative(args: &Arguments) -> Evaluated {
    // diff(c, t) names the variable as for formulas.
    let args = &match args.value(1) {
        Ok(value) if formula::symbol_of(value).is_some() => args.without_place(1),
        _ => args.clone(),
    };
    args.expect("derivative(c, k)", 1..=2, &["k"])?;
    let order = args.named_size("k", 1)?.unwrap_or(1);
    if let Value::Piecewise(function) = args.value(0)? {
        let derived = function.function.derivative(order);
        let variable = function.variable.clone();
        return Ok(Value::Piecewise(Arc::new(PiecewiseFunction { function: derived, variable })));
    }
    match &*args.geometry(0)? {
        Geometry::Bezier(curve, form) if form.rational => {
            let curve =
                RationalCurve::from_homogeneous(curve.clone()).map_err(curve_error).at(args.span(0))?;
            let derived = (0..order).fold(curve, |curve, _| curve.derivative());
            Ok(bezier(derived.homogeneous().clone(), *form))
        }
        Geometry::Bezier(curve, form) => Ok(bezier(curve.derivative(order), *form)),
        Geometry::Spline(_, form) if form.rational => Err(Diagnostic::error(
            Code::Unsupported,
            "derivatives of rational splines are taken piece by piece",
        )
        .at(args.span(0))
        .hint("P := pieces(s), then derivative(P_0) is that of the first piece")),
        Geometry::Spline(s, form) => {
            s.nth_derivative(order).map(|s| spline(s, *form)).map_err(spline_error).at(args.span(0))
        }
        other => Err(not_a_curve(other, args)),
    }
}

/// The integral over the whole interval, or from a to b.
fn integrate(args: &Arguments) -> Evaluated {
    args.expect("integrate(c, a, b)", 1..=4, &[])?;
    // integrate(c, t, a, b) names the variable as for formulas.
    let args = &match args.len() {
        4 => args.without_place(1),
        _ => args.clone(),
    };
    if args.len() > 1 {
        args.expect("integrate(c, a, b)", 3..=3, &[])?;
        let ends = [args.scalar(1)?, args.scalar(2)?];
        let primitive = antiderivative(&args.only(1))?;
        let at = |i: usize| {
            let value = [(Value::Scalar(ends[i].clone()), args.span(i + 1))];
            match &primitive {
                Value::Piecewise(function) => call_piecewise(function, &value, args.span(i + 1)),
                Value::Geometry(geometry) => call_geometry(geometry, &value, args.span(i + 1)),
                other => Err(wrong_kind("a curve", other)),
            }
        };
        return arithmetic::add(at(1)?, arithmetic::negate(at(0)?)?);
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
            Ok(Value::Piecewise(Arc::new(PiecewiseFunction { function: primitive, variable })))
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
    args.expect("bezier_points(c)", 1..=3, &[])?;
    let (curve, form) = args.bezier(0)?;
    let curve = match args.len() {
        1 => curve,
        _ => {
            let (a, b) = super::curves::ends(args, 1)?;
            curve.part(&a, &b).map_err(curve_error).at(args.span(1))?
        }
    };
    match form.split(curve.points()) {
        Some((values, _)) => Ok(Value::List(values)),
        None => Err(curve_error(crate::math::curve::CurveError::ZeroDenominator).at(args.span(0))),
    }
}

/// c(G(t)): over the interval that G takes to that of c if G is linear, else over [0, 1].
fn compose(args: &Arguments) -> Evaluated {
    args.expect("compose(c, G)", 2..=2, &[])?;
    let (curve, form) = args.bezier(0)?;
    let inner = args.univariate(1, usize::MAX)?.coefficients;
    let (a, b) = match inner.as_slice() {
        [shift, slope] if !slope.is_zero() => {
            let inverse = Field::inverse(slope).ok_or_else(division_by_zero)?;
            let (a, b) = curve.interval();
            (a.minus(shift).times(&inverse), b.minus(shift).times(&inverse))
        }
        _ => (Fraction::zero(), Fraction::one()),
    };
    let inner = crate::math::blossom::PolarForm::with_degree(&inner, inner.len() - 1).map_err(polar_error)?;
    curve.compose(&inner, a, b).map(|c| bezier(c, form)).map_err(curve_error)
}

fn degree(args: &Arguments) -> Evaluated {
    args.expect("degree(c)", 1..=1, &[])?;
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
    args.expect("coefficients(c)", 1..=1, &[])?;
    let (curve, form) = args.bezier(0)?;
    polynomial(form, args)?;
    let mut rows: Vec<Value> = curve.power().into_iter().map(scalar_list).collect();
    Ok(if form.scalar { rows.swap_remove(0) } else { Value::List(rows) })
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
