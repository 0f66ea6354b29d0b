//! What is asked of a polynomial, a curve or a list of numbers at a glance: critical points, mean values, slopes and tangents,
//! boxes, changes of sign, how often a number stands.

use super::Builtin;
use super::gives::Gives;
use super::parameter::{CURVE, Parameter, VARIABLE, optional, required};
use super::record::Variant;
use super::roots::{LOWER, UPPER, interval, numeric};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::ops::errors::curve_error;
use crate::language::ops::formula;
use crate::language::ops::geometry::{point_of, scalar_list};
use crate::language::ops::takes::Takes;
use crate::language::value::{Form, Value, free_parameter};
use crate::math::curve::{self, BezierCurve, Interval, Point};
use crate::math::number::{Rational, integer, rational};
use crate::math::poly::{Fraction, MultiPoly, Poly, Symbol, sign_changes};
use crate::math::ring::{Field, Ring};
use num_traits::Zero;

type Result<T> = std::result::Result<T, Diagnostic>;

const OF_POLYNOMIALS: Builtin = Builtin::about("Roots of polynomials");

const OF_FORMULAS: Builtin = Builtin::about("Polynomials");

const OF_CURVES: Builtin = Builtin::about("Curvature");

const OF_NUMBERS: Builtin = Builtin::about("Numbers");

const F: Parameter =
    required("F", Takes::Polynomial, "the polynomial or curve, with numbers as coefficients");

const POINTS: Parameter = required("points", Takes::Points, "the points").shown("[p_0, ..., p_n]");

const AT: Parameter = optional("t", Takes::Scalar, "a formula in the variable", "the parameter");

const PLACE: Parameter = required("t", Takes::Scalar, "the parameter");

/// The curve of the plane, which a function also takes for a formula.
const OF_CURVE: &[Parameter] = &[CURVE, PLACE];

const NUMBERS: Parameter = required("list", Takes::Scalars, "the numbers").shown("[c_0, ..., c_n]");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "critical_points",
        parameters: &[F, LOWER, UPPER, VARIABLE],
        summary: "where the derivative is 0, each place once; of a curve for each coordinate",
        gives: Gives::List,
        example: "critical_points(t^3 - 3t)",
        on_curve: Variant::new(&[CURVE], Gives::List, |args| {
            let (coordinates, ends, form) = coordinates_of(args)?;
            let [weight, coordinates @ ..] = coordinates.as_slice() else {
                return Err(Diagnostic::error(Code::Shape, "the curve has no coordinates").at(args.span(0)));
            };
            let letter = Symbol::new("t");
            let of_one = |coordinate: &Poly| {
                let slope = coordinate.derivative() * weight - coordinate * weight.derivative();
                // A coordinate that is constant has none.
                let found = slope.real_roots(Some(&ends[0]), Some(&ends[1])).unwrap_or_default();
                Value::List(found.into_iter().map(|(root, _)| Value::root(root, &letter)).collect())
            };
            match coordinates {
                [one] if form.scalar => Ok(of_one(one)),
                several => Ok(Value::list(several.iter().map(of_one).collect())),
            }
        }),
        call: |_, args| {
            let (polynomial, variable) = numeric(args, 0)?;
            let (a, b) = interval(args, 1)?;
            let found = polynomial.derivative().real_roots(a.as_ref(), b.as_ref()).ok_or_else(|| {
                Diagnostic::error(Code::Domain, "the derivative of a constant is 0 everywhere")
                    .at(args.span(0))
                    .hint("give a polynomial that is not constant")
            })?;
            Ok(Value::List(found.into_iter().map(|(root, _)| Value::root(root, &variable)).collect()))
        },
        ..OF_POLYNOMIALS
    },
    Builtin {
        name: "mean_value",
        parameters: &[
            F,
            required("a", Takes::Number, "the lower end"),
            required("b", Takes::Number, "the upper end"),
            VARIABLE,
        ],
        summary: "the integral over [a, b], divided by b - a",
        gives: Gives::Scalar,
        example: "mean_value(t^2, 0, 3)",
        call: |_, args| {
            let (polynomial, _) = numeric(args, 0)?;
            let (a, b) = (args.rational(1)?, args.rational(2)?);
            let length = &b - &a;
            let whole = Interval::new(a, b).map_err(|_| {
                Diagnostic::error(Code::Domain, "the ends of the interval are equal")
                    .at(args.span(2))
                    .hint("give the lower end first, then a larger one")
            })?;
            Ok(Value::number(polynomial.integral(&whole) / length))
        },
        ..OF_POLYNOMIALS
    },
    Builtin {
        name: "from_roots",
        parameters: &[
            required("roots", Takes::Scalars, "the roots, each as often as it is repeated")
                .shown("[r_1, ..., r_n]"),
            super::parameter::RESULT_VARIABLE,
        ],
        summary: "the monic polynomial with these roots",
        gives: Gives::Scalar,
        example: "from_roots([1, 2, 3])",
        call: |_, args| {
            let letter = Fraction::from(MultiPoly::symbol(args.letter()?));
            let factors = args.scalars(0)?.into_iter().map(|root| letter.minus(&root));
            Ok(Value::Scalar(
                factors.fold(Fraction::from(integer(1)), |product, factor| product.times(&factor)),
            ))
        },
        ..OF_FORMULAS
    },
    Builtin {
        name: "slope",
        parameters: &[required("F", Takes::Scalar, "the formula"), AT, VARIABLE],
        summary: "the derivative of a formula, or y'/x' of a plane curve, at a parameter",
        gives: Gives::Scalar,
        example: "slope(t^3, 2)",
        on_curve: Variant::new(OF_CURVE, Gives::Scalar, |args| {
            let (_, [x, y]) = jet_in_plane(args)?;
            let inverse = x.inverse().ok_or_else(|| {
                Diagnostic::error(Code::Domain, "the tangent is vertical there, or there is none")
                    .at(args.span(1))
                    .hint("derivative(c)(t) gives the vector")
            })?;
            Ok(Value::Scalar(y.times(&inverse)))
        }),
        call: |_, args| {
            let (_, slope, variable) = slope_of(args)?;
            Ok(Value::Scalar(match args.optional_scalar(1)? {
                Some(at) => slope.substitute(&[(variable, at)]).map_err(|_| pole(args))?,
                None => slope,
            }))
        },
        ..OF_CURVES
    },
    Builtin {
        name: "tangent_line",
        parameters: &[required("F", Takes::Scalar, "the formula"), PLACE, VARIABLE],
        summary: "F(a) + F'(a) (t - a), or a formula in x and y that is 0 on the tangent of a curve",
        gives: Gives::Scalar,
        example: "tangent_line(x^2, 3)",
        on_curve: Variant::noting(OF_CURVE, Gives::Scalar, |machine, args| {
            let (point, [x, y]) = jet_in_plane(args)?;
            if x.is_zero() && y.is_zero() {
                return Err(Diagnostic::error(Code::Domain, "the derivative is 0 there")
                    .at(args.span(1))
                    .hint("take another parameter"));
            }
            let note = "the tangent is where this is 0";
            machine.note(Diagnostic::note(Code::StandardMeaning, note).at(args.span(0)));
            let [to_x, to_y] = [0, 1].map(|i| {
                let letter = Fraction::from(MultiPoly::symbol(Symbol::new(["x", "y"][i])));
                letter.minus(&point[i])
            });
            Ok(Value::Scalar(x.times(&to_y).minus(&y.times(&to_x))))
        }),
        call: |_, args| {
            let (formula, slope, variable) = slope_of(args)?;
            let at = args.scalar(1)?;
            let value =
                |of: &Fraction| of.substitute(&[(variable.clone(), at.clone())]).map_err(|_| pole(args));
            let run = Fraction::from(MultiPoly::symbol(variable.clone())).minus(&at);
            Ok(Value::Scalar(value(&formula)?.plus(&value(&slope)?.times(&run))))
        },
        ..OF_CURVES
    },
    Builtin {
        name: "bounding_box",
        parameters: &[CURVE],
        summary: "the least and the largest value of each coordinate of a curve, exactly",
        gives: Gives::List,
        example: "bounding_box(bezier([[0, 0], [1, 2], [2, 0]]))",
        call: |_, args| {
            let (coordinates, ends, _) = coordinates_of(args)?;
            let letter = Symbol::new("t");
            let (weight, coordinates) = coordinates.split_first().ok_or_else(|| pole(args))?;
            let side = |coordinate: &Poly| -> Option<Value> {
                let of = |largest| coordinate.extreme(weight, ends.each_ref(), [false, false], largest);
                let [least, most] = [of(false)?, of(true)?].map(|found| Value::root(found.value, &letter));
                Some(Value::list(vec![least, most]))
            };
            let sides: Option<Vec<Value>> = coordinates.iter().map(side).collect();
            sides.map(Value::list).ok_or_else(|| {
                Diagnostic::error(Code::Domain, "the curve is not bounded there")
                    .at(args.span(0))
                    .hint("its weight is 0 somewhere: part(c, r, s) is a part of it")
            })
        },
        ..Builtin::about("Bézier curves")
    },
    Builtin {
        name: "polygon_length",
        parameters: &[POINTS],
        summary: "the length of a polygon: exactly where its edges are rational, else [lower, upper]",
        gives: Gives::Point,
        example: "polygon_length([[0, 0], [3, 4], [6, 0]])",
        on_curve: Variant::new(&[CURVE], Gives::Point, |args| {
            let (curve, form) = args.bezier(0)?;
            let points: Result<Vec<Point<Fraction>>> = curve
                .points()
                .iter()
                .map(|point| {
                    let value = form.value(point.clone()).map_err(curve_error).at(args.span(0))?;
                    point_of(&value).map(|(point, _)| point).ok_or_else(|| Takes::Point.refuses(&value))
                })
                .collect();
            length_of(&points?, args)
        }),
        call: |_, args| length_of(&args.control_points(0)?.0, args),
        ..Builtin::about("Lengths and areas")
    },
    Builtin {
        name: "midpoint",
        parameters: &[
            required("p", Takes::Point, "a point or number; or a curve alone"),
            required("q", Takes::Point, "another one"),
        ],
        summary: "the point in the middle between two points",
        gives: Gives::Point,
        example: "midpoint([0, 2], [4, 4])",
        on_curve: Variant::new(&[CURVE], Gives::Point, |args| {
            let (curve, form) = args.bezier(0)?;
            let (a, b) = curve.interval().ends();
            let middle = a.plus(b).scaled(&rational(1, 2));
            form.value(curve.value(&middle)).map_err(curve_error).at(args.span(0))
        }),
        call: |_, args| {
            let half = rational(1, 2);
            let point = |i: usize| {
                let given = args.value(i)?;
                point_of(given).ok_or_else(|| Takes::Point.refuses(given).at(args.span(i)))
            };
            let ((p, plain), (q, _)) = (point(0)?, point(1)?);
            if p.len() != q.len() {
                let message = format!("the dimensions {} and {} differ", p.len(), q.len());
                return Err(Diagnostic::error(Code::Shape, message)
                    .at(args.span(1))
                    .hint("both need the same number of coordinates"));
            }
            let form = Form { scalar: plain, ..Form::default() };
            Ok(form.plain(p.iter().zip(q.iter()).map(|(x, y)| x.plus(y).scaled(&half)).collect::<Vec<_>>()))
        },
        ..Builtin::about("Bézier curves")
    },
    Builtin {
        name: "sign_changes",
        parameters: &[NUMBERS],
        summary: "how often the sign changes in a list of numbers, zeros left out",
        gives: Gives::Count,
        example: "sign_changes([1, -2, 0, 3])",
        call: |_, args| {
            let numbers: Option<Vec<Rational>> = args.scalars(0)?.iter().map(Fraction::as_rational).collect();
            let numbers = numbers.ok_or_else(|| {
                Diagnostic::error(Code::Type, "the signs of symbols are not known")
                    .at(args.span(0))
                    .hint("give the symbols values first")
            })?;
            Ok(Value::int(i64::try_from(sign_changes(&numbers)).unwrap_or(i64::MAX)))
        },
        ..OF_NUMBERS
    },
    Builtin {
        name: "cross_ratio",
        parameters: &[
            required("p", Takes::Scalar, "the first number"),
            required("q", Takes::Scalar, "the second"),
            required("r", Takes::Scalar, "the third"),
            required("s", Takes::Scalar, "the fourth"),
        ],
        summary: "(r - p)(s - q)/((r - q)(s - p)) of four numbers",
        gives: Gives::Scalar,
        example: "cross_ratio(0, 1, 2, 3)",
        call: |_, args| {
            let [a, b, c, d] = [args.scalar(0)?, args.scalar(1)?, args.scalar(2)?, args.scalar(3)?];
            let below = c.minus(&b).times(&d.minus(&a));
            let inverse = below.inverse().ok_or_else(|| {
                Diagnostic::error(Code::DivisionByZero, "two of the numbers are equal")
                    .at(args.span(1))
                    .hint("q and r differ, and so do p and s")
            })?;
            Ok(Value::Scalar(c.minus(&a).times(&d.minus(&b)).times(&inverse)))
        },
        ..OF_NUMBERS
    },
    Builtin {
        name: "multiplicity",
        parameters: &[
            required("t", Takes::Scalar, "the knot"),
            required("knots", Takes::Scalars, "the knots").shown("[t_0, ..., t_k]"),
        ],
        summary: "how often a number stands in a list of knots",
        gives: Gives::Count,
        example: "multiplicity(2, [0, 0, 1, 2, 2, 3])",
        call: |_, args| {
            let at = args.scalar(0)?;
            let count = args.scalars(1)?.iter().filter(|knot| **knot == at).count();
            Ok(Value::int(i64::try_from(count).unwrap_or(i64::MAX)))
        },
        ..Builtin::about("B-splines")
    },
];

/// The weight, 1 if there are none, and the coordinates of a curve with numbers as control points; its interval.
fn coordinates_of(args: &Arguments) -> Result<(Vec<Poly>, [Rational; 2], Form)> {
    let (curve, form) = args.bezier(0)?;
    let numbers = |list: &Vec<Fraction>| -> Option<Poly> { list.iter().map(Fraction::as_rational).collect() };
    let coordinates: Option<Vec<Poly>> = curve.power().iter().map(numbers).collect();
    let (a, b) = curve.interval().ends();
    let (Some(mut coordinates), Some(a), Some(b)) = (coordinates, a.as_rational(), b.as_rational()) else {
        return Err(Diagnostic::error(Code::Type, "numbers are needed as control points")
            .at(args.span(0))
            .hint("give the symbols values first"));
    };
    let weight = form.rational.then(|| coordinates.pop()).flatten().unwrap_or_else(Poly::one);
    coordinates.insert(0, weight);
    Ok((coordinates, [a.clone().min(b.clone()), a.max(b)], form))
}

/// The point and the derivative of a curve of the plane at a parameter.
fn jet_in_plane(args: &Arguments) -> Result<(Vec<Fraction>, [Fraction; 2])> {
    let (curve, form) = args.bezier(0)?;
    let at = args.scalar(1)?;
    let used = curve.points().iter().flat_map(|point| point.iter());
    let letter = free_parameter(used.chain([&at]));
    let along = curve.value(&Fraction::from(MultiPoly::symbol(letter.clone())));
    let mut coordinates: Vec<Fraction> = along.iter().cloned().collect();
    if form.rational {
        let weight = coordinates.pop().and_then(|weight| weight.inverse()).ok_or_else(|| pole(args))?;
        coordinates.iter_mut().for_each(|coordinate| *coordinate = coordinate.times(&weight));
    }
    // The graph of a polynomial.
    if form.scalar {
        coordinates.insert(0, Fraction::from(MultiPoly::symbol(letter.clone())));
    }
    let value = |of: &Fraction| of.substitute(&[(letter.clone(), at.clone())]).map_err(|_| pole(args));
    let point = coordinates.iter().map(value).collect::<Result<Vec<_>>>()?;
    let slopes = coordinates.iter().map(|of| value(&of.derivative(&letter))).collect::<Result<Vec<_>>>()?;
    let count = slopes.len();
    let slopes = <[Fraction; 2]>::try_from(slopes).map_err(|_| {
        let message = format!("a curve of the plane is needed, this one has {count} coordinates");
        Diagnostic::error(Code::Shape, message)
            .at(args.span(0))
            .hint("derivative(c)(t) gives the tangent vector of any curve")
    })?;
    Ok((point, slopes))
}

/// A formula, its derivative and its variable.
fn slope_of(args: &Arguments) -> Result<(Fraction, Fraction, Symbol)> {
    let formula = args.scalar(0)?;
    let variable = formula::variable_of(&formula, args.variable()?).at(args.span(0))?;
    let slope = formula.derivative(&variable);
    Ok((formula, slope, variable))
}

fn pole(args: &Arguments) -> Diagnostic {
    Diagnostic::error(Code::DivisionByZero, "the denominator is 0 there")
        .at(args.span(0))
        .hint("take another parameter")
}

/// The edges together; where a length is not rational, the bounds of the whole.
fn length_of(points: &[Point<Fraction>], args: &Arguments) -> Result<Value> {
    let number = |point: &Point<Fraction>| -> Option<Point<Rational>> {
        point.iter().map(Fraction::as_rational).collect()
    };
    let points: Option<Vec<Point<Rational>>> = points.iter().map(number).collect();
    let points = points.ok_or_else(|| {
        Diagnostic::error(Code::Type, "numbers are needed as points")
            .at(args.span(0))
            .hint("give the symbols values first")
    })?;
    let mut bounds = [Rational::zero(), Rational::zero()];
    for pair in points.windows(2) {
        let edge = BezierCurve::new(pair.to_vec(), Interval::unit()).map_err(curve_error).at(args.span(0))?;
        let (lower, upper) = curve::arc_length(&edge, &rational(1, 10_000));
        bounds[0] += lower;
        bounds[1] += upper;
    }
    let [lower, upper] = bounds;
    if lower == upper {
        return Ok(Value::number(lower));
    }
    Ok(scalar_list([lower, upper].map(Fraction::from)))
}
