//! Splines of any degree from values, and functionals for their control points.

use super::NEW;
use super::data::{Datum, Result, data};
use super::energy::{approximation_error, polynomial};
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::functions::Builtin;

use crate::language::functions::gives::Gives;
use crate::language::functions::parameter::{
    DEGREE, END, KNOTS, NODES, Parameter, SPLINE, START, VALUES, named, required, size,
};
use crate::language::functions::record::Variant;
use crate::language::functions::splines::knots_at;
use crate::language::ops::calculus::nth_derivative;
use crate::language::ops::errors::{curve_error, division_by_zero, spline_error, wrong_kind};
use crate::language::ops::formula::curve_of;
use crate::language::ops::geometry::{bezier, scalar_list, spline};
use crate::language::ops::takes::Takes;
use crate::language::value::{Form, Value, polynomial_expr};
use crate::math::approximation::{
    ApproximationError, Smoothing, averaged_knots, de_boor_fix, fitted_spline, interpolating_spline,
    quasi_interpolant, schoenberg,
};
use crate::math::curve::{BezierCurve, Interval, Point};
use crate::math::interpolate::InterpolationError;
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use crate::math::spline::{BSpline, KnotVector, SplineError};
use num_traits::{One, Signed, Zero};

const FUNCTION: Parameter = required("F", Takes::Coordinates, "the function, or a list of its coordinates");

const TAU: Parameter = required("tau", Takes::Scalar, "where the derivatives are taken");

pub(crate) const TABLE: &[Builtin] = &[
    Builtin {
        name: "interpolating_spline",
        parameters: &[
            DEGREE,
            NODES,
            VALUES,
            named("knots=[t_0, ..., t_k]", Takes::Scalars, "averaged_knots(n, nodes)", "the knots"),
        ],
        summary: "the spline of degree n with given values at the nodes, if Schoenberg and Whitney allow",
        gives: Gives::Spline,
        example: "interpolating_spline(2, [0, 1, 2, 3], [0, 1, 0, 2])",
        call: |_, args| {
            let (n, nodes) = (args.size(0)?, args.scalars(1)?);
            let (values, form) = values(args, 2)?;
            let knots = match args.named("knots") {
                None => averaged_knots(n, &nodes).map_err(approximation_error).at(args.span(1))?,
                Some((_, span)) => {
                    let list = args.named_scalars("knots")?.unwrap_or_default();
                    KnotVector::new(n, list).map_err(spline_error).at(span)?
                }
            };
            let found = interpolating_spline(knots.clone(), &nodes, &values);
            found.map(|s| spline(s, form)).map_err(|error| {
                use ApproximationError as E;
                let place = match (&error, args.named("knots")) {
                    (E::Interpolation(InterpolationError::Lengths { .. }), _) => args.span(2),
                    (E::NodeCount { .. } | E::SchoenbergWhitney { .. }, Some((_, span))) => span,
                    _ => args.span(1),
                };
                told(error, &knots).at(place)
            })
        },
        ..NEW
    },
    Builtin {
        name: "least_squares_spline",
        parameters: &[
            DEGREE,
            KNOTS,
            NODES.shown("[x_0, ..., x_m]"),
            VALUES.shown("[y_0, ..., y_m]"),
            named("weights=[w_0, ..., w_m]", Takes::Scalars, "all 1", "the weights of the nodes"),
            named("smoothing=lambda", Takes::Scalar, "0", "the factor of the integral of |S^(r)|^2"),
            named("derivative=r", Takes::Size, "2", "which derivative is made small"),
        ],
        summary: "the spline with the least sum of w_i |y_i - S(x_i)|^2, smoothed by lambda |S^(r)|^2",
        gives: Gives::Spline,
        example: "least_squares_spline(1, [0, 0, 3, 3], [0, 1, 2, 3], [0, 1, 1, 2])",
        call: |_, args| {
            let knots = knots_at(args, 0, 1)?;
            let nodes = args.scalars(2)?;
            let (values, form) = values(args, 3)?;
            let weights = args.named_scalars("weights")?;
            let order = args.size_named("derivative")?;
            let smoothing = match args.named("smoothing") {
                None => None,
                Some((Value::Scalar(weight), span)) => {
                    if weight.as_rational().is_some_and(|q| q.is_negative()) {
                        let message = "the factor of a penalty is 0 or positive";
                        return Err(Diagnostic::error(Code::Domain, message).at(span));
                    }
                    Some(Smoothing { weight: weight.clone(), order }).filter(|_| !weight.is_zero())
                }
                Some((other, span)) => return Err(wrong_kind("a number or formula", other).at(span)),
            };
            let fit = fitted_spline(knots.clone(), &nodes, &values, weights.as_deref(), smoothing.as_ref());
            fit.map(|fit| spline(fit, form)).map_err(|error| {
                use InterpolationError as E;
                let place = match &error {
                    ApproximationError::Interpolation(
                        E::Lengths { what: "weights", .. } | E::NegativeWeight { .. },
                    ) => args.named("weights").map_or_else(|| args.span(2), |(_, span)| span),
                    ApproximationError::Interpolation(E::Lengths { .. }) => args.span(3),
                    _ => args.span(2),
                };
                told(error, &knots).at(place)
            })
        },
        ..NEW
    },
    Builtin {
        name: "smoothing_spline",
        parameters: &[
            NODES.shown("[x_0, ..., x_m]"),
            VALUES.shown("[y_0, ..., y_m]"),
            required("lambda", Takes::Scalar, "the factor of the integral of |S''|^2"),
            named("weights=[w_0, ..., w_m]", Takes::Scalars, "all 1", "the weights of the nodes"),
        ],
        summary: "the natural cubic spline with the least sum of w_i |y_i - S(x_i)|^2 + lambda |S''|^2",
        gives: Gives::Spline,
        example: "smoothing_spline([0, 1, 2, 3], [0, 1, 0, 1], 1)",
        call: |_, args| {
            let nodes = args.scalars(0)?;
            let (values, form) = values(args, 1)?;
            let lambda = args.scalar(2)?;
            if lambda.as_rational().is_some_and(|q| !q.is_positive()) {
                let error =
                    Diagnostic::error(Code::Domain, "the factor of the penalty is positive").at(args.span(2));
                return Err(error.hint("without a penalty it is cubic_spline(nodes, values)"));
            }
            let (Some(first), Some(last), true) = (nodes.first(), nodes.last(), nodes.len() > 1) else {
                let error = Diagnostic::error(Code::Shape, "two nodes or more are needed").at(args.span(0));
                return Err(error.hint("such as [0, 1, 2]"));
            };
            // The least of all functions is a cubic spline whose knots are the nodes; that it is natural follows.
            let whole = Interval::new(first.clone(), last.clone()).map_err(curve_error).at(args.span(0))?;
            let inner = &nodes[1..nodes.len() - 1];
            let knots = KnotVector::clamped(3, inner, &whole).map_err(spline_error).at(args.span(0))?;
            let weights = args.named_scalars("weights")?;
            let smoothing = Smoothing { weight: lambda, order: 2 };
            let fit = fitted_spline(knots.clone(), &nodes, &values, weights.as_deref(), Some(&smoothing));
            fit.map(|fit| spline(fit, form)).map_err(|error| told(error, &knots).at(args.span(0)))
        },
        ..NEW
    },
    Builtin {
        name: "averaged_knots",
        parameters: &[DEGREE, NODES],
        summary: "clamped knots for interpolation at the nodes: means of n consecutive ones",
        gives: Gives::Scalars,
        example: "averaged_knots(3, [0, 1, 2, 4, 5])",
        call: |_, args| {
            let knots = averaged_knots(args.size(0)?, &args.scalars(1)?)
                .map_err(approximation_error)
                .at(args.span(1))?;
            Ok(scalar_list(knots.knots().iter().cloned()))
        },
        ..NEW
    },
    Builtin {
        name: "bernstein_approximation",
        parameters: &[FUNCTION, DEGREE, START, END],
        summary: "Bernstein's operator: the sum of F(a + i (b - a)/n) B_i^n over [a, b], or [0, 1]",
        gives: Gives::Any,
        example: "bernstein_approximation(t^2, 3)",
        call: |_, args| {
            let (functions, form) = functions(args)?;
            let n = args.size(1)?;
            if n == 0 {
                return Err(Diagnostic::error(Code::Domain, "the degree is at least 1").at(args.span(1)));
            }
            let a = args.optional_scalar(2)?.unwrap_or_else(Fraction::zero);
            let b = args.optional_scalar(3)?.unwrap_or_else(Fraction::one);
            let step = b.minus(&a).scaled(&Rational::new(1.into(), n.into()));
            let point = |i: usize| -> Result<Point<Fraction>> {
                let x = a.plus(&step.scaled(&Rational::from_integer(i.into())));
                functions.iter().map(|function| value(function, 0, &x, args)).collect()
            };
            let points = (0..=n).map(point).collect::<Result<Vec<_>>>()?;
            let interval = Interval::new(a, b).map_err(curve_error).at(args.span(0))?;
            let curve = BezierCurve::new(points, interval).map_err(curve_error).at(args.span(0))?;
            match (form.scalar, functions.as_slice()) {
                (true, [(variable, _)]) => {
                    let t = Fraction::from(MultiPoly::symbol(variable.clone()));
                    let value = curve.value(&t);
                    Ok(Value::Scalar(value[0].clone()))
                }
                _ => Ok(bezier(curve, form)),
            }
        },
        ..NEW
    },
    Builtin {
        name: "schoenberg",
        parameters: &[FUNCTION, DEGREE, KNOTS],
        summary: "Schoenberg's spline: control points F(xi_i) at the Greville abscissae",
        gives: Gives::Spline,
        example: "schoenberg(t^2, 2, [0, 0, 0, 2, 4, 4, 4])",
        call: |_, args| sampled(args, |knots, function| schoenberg(knots, function)),
        ..NEW
    },
    Builtin {
        name: "quasi_interpolant",
        parameters: &[FUNCTION, DEGREE, KNOTS],
        summary: "the spline with control points by blossoms of local interpolants: exact for degree n",
        gives: Gives::Spline,
        example: "quasi_interpolant(t^2, 2, [0, 0, 0, 2, 4, 4, 4])",
        call: |_, args| sampled(args, |knots, function| quasi_interpolant(knots, function)),
        ..NEW
    },
    Builtin {
        name: "deboor_fix",
        parameters: &[FUNCTION, DEGREE, KNOTS, size("i", "the number of the control point"), TAU],
        summary: "the functional of de Boor and Fix: control point d_i from derivatives at tau",
        gives: Gives::Point,
        example: "deboor_fix(t^2, 2, [0, 1, 2, 3, 4, 5], 0, 0)",
        on_curve: Variant::new(
            &[SPLINE, size("i", "the number of the control point"), TAU],
            Gives::Point,
            of_spline,
        ),
        call: |_, args| {
            let (functions, form) = functions(args)?;
            let knots = knots_at(args, 1, 2)?;
            let (i, tau) = (number(args, 3, &knots)?, args.scalar(4)?);
            let weights = de_boor_fix(knots.label(i), &tau);
            let mut point = Vec::with_capacity(functions.len());
            for function in &functions {
                let mut sum = Fraction::zero();
                for (r, weight) in weights.iter().enumerate() {
                    sum += weight.times(&value(function, r, &tau, args)?);
                }
                point.push(sum);
            }
            Ok(form.plain(point))
        },
        ..NEW
    },
];

/// The spline that an operator makes of the values of the function.
fn sampled(
    args: &Arguments,
    operator: impl FnOnce(
        KnotVector<Fraction>,
        &dyn Fn(&Fraction) -> Result<Point<Fraction>>,
    ) -> Result<std::result::Result<BSpline<Fraction>, SplineError>>,
) -> Result<Value> {
    let (functions, form) = functions(args)?;
    let knots = knots_at(args, 1, 2)?;
    let values = |x: &Fraction| functions.iter().map(|function| value(function, 0, x, args)).collect();
    let s = operator(knots, &values)?.map_err(spline_error).at(args.span(2))?;
    Ok(spline(s, form))
}

/// Points or numbers at a place.
fn values(args: &Arguments, i: usize) -> Result<(Vec<Point<Fraction>>, Form)> {
    let value = args.value(i)?;
    let (list, scalar): (Vec<Datum>, bool) = data(value).ok_or_else(|| {
        wrong_kind("a list of values", value)
            .at(args.span(i))
            .hint("numbers or symbols such as [1, 3, 2], or points such as [[0, 0], [1, 2]]")
    })?;
    Ok((list.into_iter().map(Point::from).collect(), Form { scalar, rational: false }))
}

/// A formula or function, or those of the coordinates, each with its variable.
fn functions(args: &Arguments) -> Result<(Vec<(Symbol, Fraction)>, Form)> {
    let value = args.value(0)?;
    let (items, scalar) = match value {
        Value::List(items) => (items.as_slice(), false),
        one => (std::slice::from_ref(one), true),
    };
    let constants = || {
        let list: Option<Vec<Fraction>> = items.iter().map(|item| item.as_scalar().cloned()).collect();
        list.map(|list| list.into_iter().map(|formula| (Symbol::new("t"), formula)).collect())
    };
    let list = Value::list(items.to_vec());
    let with =
        |(t, formulas): (Symbol, Vec<Fraction>)| formulas.into_iter().map(|f| (t.clone(), f)).collect();
    let found = curve_of(&list).at(args.span(0))?.map(with).or_else(constants);
    let found = found.ok_or_else(|| wrong_kind("a function or a list of them", value).at(args.span(0)))?;
    Ok((found, Form { scalar, rational: false }))
}

/// F^(r)(x)
fn value(
    (variable, formula): &(Symbol, Fraction),
    r: usize,
    x: &Fraction,
    args: &Arguments,
) -> Result<Fraction> {
    let derived = nth_derivative(formula, variable, r).substitute(&[(variable.clone(), x.clone())]);
    derived.map_err(|_| division_by_zero()).at(args.span(0))
}

fn number(args: &Arguments, place: usize, knots: &KnotVector<Fraction>) -> Result<usize> {
    let (index, count) = (args.size(place)?, knots.count());
    if index >= count {
        return Err(spline_error(SplineError::NoSuchFunction { index, count }).at(args.span(place)));
    }
    Ok(index)
}

/// The functional of a spline: d_i again, if τ lies where N_i is not 0.
fn of_spline(args: &Arguments) -> Result<Value> {
    let (s, form) = args.spline(0)?;
    polynomial(form, args.span(0))?;
    let (i, tau) = (number(args, 1, s.knots())?, args.scalar(2)?);
    let span = s.knots().span_of(&tau).map_err(spline_error).at(args.span(2))?;
    if !(i..=i + s.degree()).contains(&span) {
        let error = Diagnostic::error(Code::OutsideDomain, format!("N_{i} is 0 there")).at(args.span(2));
        return Err(error.hint(format!("choose tau between {}", support(s.knots(), i))));
    }
    let piece = s.bezier_piece(span).map_err(spline_error)?;
    let weights = de_boor_fix(s.knots().label(i), &tau);
    let mut point = vec![Fraction::zero(); s.dimension()];
    for (r, weight) in weights.iter().enumerate() {
        for (sum, x) in point.iter_mut().zip(piece.nth_derivative(r).value(&tau).iter()) {
            *sum += weight.times(x);
        }
    }
    Ok(form.plain(point))
}

/// t_i = 0 and t_(i+n+1) = 3
fn support(knots: &KnotVector<Fraction>, i: usize) -> String {
    let shown = |k: usize| {
        let name = Kind::Subscript(Box::new(Expr::name("t")), vec![Expr::int(k as i64)]);
        let value = crate::language::write::text(&polynomial_expr(&knots.knots()[k]));
        format!("{} = {value}", crate::language::write::text(&name.into()))
    };
    format!("{} and {}", shown(i), shown(i + knots.degree() + 1))
}

/// The error, and where the node it speaks of would have to lie.
fn told(error: ApproximationError, knots: &KnotVector<Fraction>) -> Diagnostic {
    use ApproximationError as E;
    match error {
        E::SchoenbergWhitney { index } => {
            let advice = format!("x_{index} has to lie between {}", support(knots, index));
            approximation_error(E::SchoenbergWhitney { index }).hint(advice)
        }
        E::NoNodeFor { index } => {
            let advice = format!("a node of its own is needed between {}", support(knots, index));
            approximation_error(E::NoNodeFor { index }).hint(advice)
        }
        other => approximation_error(other),
    }
}
