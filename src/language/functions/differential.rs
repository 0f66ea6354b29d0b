//! Derivatives of curves at a parameter, and the curvatures that follow from them.

use super::Builtin;
use super::gives::Gives;
use super::parameter::{LINE, Parameter, required};
use super::rational::rational_curve;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::ops::calculus::nth_derivative;
use crate::language::ops::errors::{curve_error, division_by_zero, spline_error};
use crate::language::ops::formula::curve_of;
use crate::language::ops::geometry::as_rational_spline;
use crate::language::ops::takes::Takes;
use crate::language::value::{Form, Geometry, Value, polynomial_expr};
use crate::math::curve::{self, CurveError, Vector};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, Poly, Symbol};
use crate::math::spline::RationalSpline;
use num_traits::{Signed, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Curvature");

pub(super) const PARAMETER: Parameter = required("t", Takes::Scalar, "the parameter");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "curvature",
        parameters: &[LINE, PARAMETER],
        summary: "|c' x c''|/|c'|^3; in the plane positive in a left turn",
        gives: Gives::Scalar,
        example: "curvature([t, t^2], 0)",
        call: |_, args| curvature(args),
        ..NEW
    },
    Builtin {
        name: "squared_curvature",
        parameters: &[LINE, PARAMETER],
        summary: "the square of the curvature, which is rational: (|c'|^2 |c''|^2 - (c' c'')^2)/|c'|^6",
        gives: Gives::Scalar,
        example: "squared_curvature([t, t^2], t)",
        call: |_, args| Ok(Value::Scalar(squared_and_turn(args)?.0)),
        ..NEW
    },
    Builtin {
        name: "torsion",
        parameters: &[LINE, PARAMETER],
        summary: "det(c', c'', c''')/|c' x c''|^2 of a curve in space",
        gives: Gives::Scalar,
        example: "torsion([t, t^2, t^3], 0)",
        call: |_, args| {
            let (list, _) = derivatives(args, 3)?;
            let torsion = curve::torsion(&list[1], &list[2], &list[3]);
            torsion.map(Value::Scalar).map_err(|error| still(error, args))
        },
        ..NEW
    },
];

/// The curvature, in the plane with its sign.
pub(super) fn curvature(args: &Arguments) -> Result<Value> {
    let (squared, turn) = squared_and_turn(args)?;
    if squared.is_zero() {
        return Ok(Value::Scalar(squared));
    }
    let Some(number) = squared.as_rational() else {
        let square = crate::language::write::text(&polynomial_expr(&squared));
        return Err(Diagnostic::error(Code::Irrational, format!("the curvature is the root of {square}"))
            .at(args.span(1))
            .hint("squared_curvature(c, t) is rational everywhere"));
    };
    // In space there is no sign.
    let turns_right = match turn.map(|turn| turn.as_rational()) {
        None => false,
        Some(Some(turn)) => turn.is_negative(),
        Some(None) => {
            return Err(Diagnostic::error(Code::Undecided, "the sign of the curvature depends on symbols")
                .at(args.span(1))
                .hint("squared_curvature(c, t) has none"));
        }
    };
    Ok(square_root(&number, turns_right))
}

/// ±√q for q ≥ 0, rational or the root of a polynomial.
fn square_root(q: &Rational, negative: bool) -> Value {
    let letter = Symbol::new("x");
    let square = Poly::variable().pow(2) - Poly::constant(q.clone());
    let roots = square.real_roots(None, None).unwrap_or_default();
    let end = if negative { roots.into_iter().next() } else { roots.into_iter().next_back() };
    end.map_or_else(|| Value::int(0), |(root, _)| Value::root(root, &letter))
}

/// The value and the derivatives up to an order of the curve at the first place, at the parameter
/// at the second. A list of formulas, [t, t^2], is a curve on the whole line.
pub(super) fn derivatives(args: &Arguments, order: usize) -> Result<(Vec<Vector<Fraction>>, Form)> {
    crate::budget::charge_terms(order as u64);
    let t = args.scalar(1)?;
    let (list, form) = match args.value(0)? {
        Value::Geometry(geometry) if matches!(**geometry, Geometry::Spline(..)) => {
            let (s, form) = args.spline(0)?;
            let s = RationalSpline::from_homogeneous(as_rational_spline(&s, form));
            (s.and_then(|s| s.derivatives(&t, order)).map_err(spline_error).at(args.span(1))?, form)
        }
        value => match curve_of(value).at(args.span(0))? {
            Some((variable, formulas)) => {
                let at = |k: usize| -> Result<Vector<Fraction>> {
                    let value = |formula: &Fraction| {
                        nth_derivative(formula, &variable, k).substitute(&[(variable.clone(), t.clone())])
                    };
                    let list = formulas.iter().map(value).collect::<std::result::Result<Vec<_>, _>>();
                    Ok(list.map_err(|_| division_by_zero()).at(args.span(1))?.into())
                };
                ((0..=order).map(at).collect::<Result<_>>()?, Form::default())
            }
            None => of_bezier(args, &t, order)?,
        },
    };
    Ok((list, Form { rational: false, ..form }))
}

fn of_bezier(args: &Arguments, t: &Fraction, order: usize) -> Result<(Vec<Vector<Fraction>>, Form)> {
    let list = rational_curve(args, 0)?.derivatives(t, order).map_err(curve_error).at(args.span(1))?;
    Ok((list, args.bezier(0)?.1))
}

/// The square of the curvature, and in the plane det(c', c''), which has its sign.
fn squared_and_turn(args: &Arguments) -> Result<(Fraction, Option<Fraction>)> {
    let (list, _) = derivatives(args, 2)?;
    let squared = curve::squared_curvature(&list[1], &list[2]).map_err(|error| still(error, args))?;
    Ok((squared, curve::turn(&list[1], &list[2]).ok()))
}

/// The error where a curve stands still or runs straight on.
pub(super) fn still(error: CurveError, args: &Arguments) -> Diagnostic {
    match error {
        CurveError::Degenerate => {
            Diagnostic::error(Code::Degenerate, "the derivatives vanish there, or are parallel")
                .at(args.span(1))
                .hint("derivatives_at(c, t, 3) shows them")
        }
        CurveError::DimensionsOf { left, right } => {
            let message = format!("a curve with {right} coordinates is needed, this one has {left}");
            let error = Diagnostic::error(Code::Shape, message).at(args.span(0));
            match left {
                1 => error.hint("a symbol is a number here: write points by their coordinates, [x_0, y_0]"),
                _ => error,
            }
        }
        other => curve_error(other).at(args.span(0)),
    }
}
