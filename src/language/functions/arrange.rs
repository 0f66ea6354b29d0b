//! Arrangements of a formula: the value stays, only how the answer is written changes.

use super::Builtin;
use super::parameter::{CURVE, Parameter, SURFACE, Takes, VARIABLE, named, optional, required};
use super::record::Variant;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, call_geometry};
use crate::language::ops::errors::{curve_error, polar_error, wrong_kind};
use crate::language::ops::formula::Univariate;
use crate::language::value::{Form, Geometry, Notation, Value, in_powers_of};
use crate::math::blossom::PolarError;
use crate::math::curve::{BezierCurve, Interval};
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};
use num_traits::{One, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Polynomials");

const FORMULA: Parameter = required("F", Takes::Coordinates, "the polynomial; a list of them for a curve");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "expand",
        parameters: &[required("F", Takes::Any, "the formula")],
        summary: "the formula multiplied out",
        example: "expand((t - a)(t - b))",
        call: |_, args| {
            let value = args.value(0)?.clone();
            let expr = value.to_expr_in(Notation::Expanded);
            Ok(Value::written(value, expr))
        },
        ..NEW
    },
    Builtin {
        name: "simplify",
        parameters: &[required("F", Takes::Any, "the formula")],
        summary: "the formula in lowest terms, grouped (every answer is written that way)",
        example: "simplify((t^2 - 1)/(t - 1))",
        call: |_, args| Ok(args.value(0)?.clone()),
        ..NEW
    },
    Builtin {
        name: "collect",
        parameters: &[
            FORMULA,
            optional("variable", Takes::Variable, "the only variable, or t", "its variable").shown("t"),
        ],
        summary: "the polynomial by descending powers of its variable, with their coefficients",
        example: "collect(a x + b x + c, x)",
        call: |_, args| {
            let given = args.optional_symbol(1)?;
            arranged(args, |args| args.univariate_in(0, given.clone()), &Fraction::zero())
        },
        ..NEW
    },
    Builtin {
        name: "in_powers",
        parameters: &[
            FORMULA,
            optional("a", Takes::Scalar, "0", "the point at which it is expanded"),
            VARIABLE,
        ],
        summary: "the polynomial by powers of t - a: its expansion by Taylor's formula",
        example: "in_powers(t^3, 1)",
        on_curve: Variant::new(
            &[CURVE, optional("a", Takes::Scalar, "0", "the point at which it is expanded")],
            curve_in_powers,
        ),
        call: |_, args| {
            let at = args.optional_scalar(1)?.unwrap_or_else(Fraction::zero);
            arranged(args, |args| args.univariate(0), &at)
        },
        ..NEW
    },
    Builtin {
        name: "in_bernstein",
        parameters: &[
            FORMULA,
            optional("degree", Takes::Size, "the degree of F", "the degree of the basis").shown("n"),
            named("a=0", Takes::Scalar, "0", "the start of the interval"),
            named("b=1", Takes::Scalar, "1", "its end"),
            VARIABLE,
        ],
        summary: "the polynomial as a combination of Bernstein polynomials over [a, b]",
        example: "in_bernstein(t^2, 3)",
        on_curve: Variant::new(&[CURVE], |args| Ok(in_its_basis(args.value(0)?))),
        on_surface: Variant::new(&[SURFACE], |args| Ok(in_its_basis(args.value(0)?))),
        call: |_, args| in_bernstein(args),
        ..NEW
    },
];

/// Each coordinate by powers of t - a.
fn arranged(
    args: &Arguments,
    read: impl Fn(&Arguments) -> Result<Univariate>,
    at: &Fraction,
) -> Result<Value> {
    let one = |item: &Value| -> Result<(Value, Expr)> {
        let given = read(&args.with_first(item.clone()))?;
        if at.variables().contains(&given.variable) {
            let error = Diagnostic::error(Code::Domain, "the point must not depend on the variable");
            return Err(error.at(args.span(1)).hint("choose a number or another letter"));
        }
        Ok((formula_of(&given), in_powers_of(&given.coefficients, &given.variable, at)))
    };
    match args.value(0)? {
        Value::List(items) => {
            let parts = items.iter().map(one).collect::<Result<Vec<_>>>()?;
            let (values, exprs) = parts.into_iter().unzip();
            Ok(Value::written(Value::List(values), Kind::List(exprs).into()))
        }
        item => one(item).map(|(value, expr)| Value::written(value, expr)),
    }
}

/// The polynomial with these coefficients.
fn formula_of(given: &Univariate) -> Value {
    let t = Fraction::from(MultiPoly::symbol(given.variable.clone()));
    Value::Scalar(Coefficients::new(given.coefficients.clone()).value(&t))
}

fn curve_in_powers(args: &Arguments) -> Result<Value> {
    let Value::Geometry(curve) = args.value(0)? else { return Err(wrong_kind("a curve", args.value(0)?)) };
    let t = Value::symbol(curve.parameter());
    let formula = call_geometry(curve, &[(t, args.span(0))], args.span(0))?;
    let at = args.optional_scalar(1)?.unwrap_or_else(Fraction::zero);
    arranged(&args.with_first(formula), |args| args.univariate_in(0, Some(curve.parameter())), &at)
}

/// A curve or surface by its control points and basis functions.
fn in_its_basis(geometry: &Value) -> Value {
    Value::written(geometry.clone(), geometry.display_expr(Notation::Grouped))
}

fn in_bernstein(args: &Arguments) -> Result<Value> {
    let (items, scalar) = match args.value(0)? {
        Value::List(items) => (items.clone(), false),
        one => (vec![one.clone()], true),
    };
    let read = |item: &Value| args.with_first(item.clone()).univariate(0);
    let parts = items.iter().map(read).collect::<Result<Vec<Univariate>>>()?;
    let end = |name: &str, usual: Fraction| match args.named(name) {
        None => Ok(usual),
        Some((Value::Scalar(x), _)) => Ok(x.clone()),
        Some((other, span)) => Err(wrong_kind("a number or formula", other).at(span)),
    };
    let interval = Interval::new(end("a", Fraction::zero())?, end("b", Fraction::one())?);
    let coordinates: Vec<Vec<Fraction>> = parts.iter().map(|part| part.coefficients.clone()).collect();
    let curve = interval.and_then(|interval| BezierCurve::from_power(&coordinates, interval));
    let mut curve = curve.map_err(curve_error).at(args.span(0))?;
    if let Some(asked) = args.optional_size(1)? {
        let polynomial = curve.degree();
        let more = asked.checked_sub(polynomial);
        let too_small = || polar_error(PolarError::DegreeTooSmall { polynomial, asked }).at(args.span(1));
        curve = curve.elevate(more.ok_or_else(too_small)?);
    }
    let parameter = parts.first().map_or_else(|| Symbol::new("t"), |part| part.variable.clone());
    let expr = Geometry::Bezier(curve, Form { scalar, rational: false }).display_expr_in(&parameter);
    let mut formulas: Vec<Value> = parts.iter().map(formula_of).collect();
    let value = if scalar { formulas.swap_remove(0) } else { Value::List(formulas) };
    Ok(Value::written(value, expr))
}
