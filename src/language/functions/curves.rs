//! Bézier curves.

use super::gives::Gives;
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::{curve_error, spline_error, wrong_kind};
use crate::language::ops::geometry::{bezier, point_of, points_of, scalar_list, spline};
use std::sync::Arc;

use super::parameter::{
    CURVE, DEGREE, END, HOMOGENEOUS, Parameter, START, SURFACE, VARIABLE, many, named, optional, required,
    size,
};
use super::{Builtin, Variant, on_surface};
use crate::formula::{Expr, Rel};
use crate::language::derive::{mean_of_two, polar_label, shown_as_means};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::takes::Takes;
use crate::language::value::{Cell, Form, Geometry, Table, Value};
use crate::math::curve::{self, BezierCurve, Interval, Point, Tableau, affine};
use crate::math::number::Rational;
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use crate::math::spline::BSpline;
use num_traits::{One, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Bézier curves");

const POINTS: Parameter = required("points", Takes::Points, "the control points");

const ORDER_OF_DIFFERENCES: Parameter = optional("k", Takes::Size, "1", "the order");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "bezier",
        parameters: &[
            POINTS.shown("[b_0, ..., b_n]"),
            START,
            END,
            named("weights=[w_0, ..., w_n]", Takes::Scalars, "all 1", "the weights of the points"),
            HOMOGENEOUS,
        ],
        summary: "the Bézier curve with these control points over [a, b] (0 and 1 if not given)",
        gives: Gives::Curve,
        example: "bezier([[0, 0], [1, 2], [2, 0]])(1/2)",
        call: |_, args| {
            let (points, form) = args.control_points(0)?;
            let curve = BezierCurve::new(points, interval(args, 1)?).map_err(curve_error).at(args.span(0))?;
            Ok(bezier(curve, form))
        },
        ..NEW
    },
    Builtin {
        name: "curve_of",
        parameters: &[
            required("coordinates", Takes::Coordinates, "the coordinates").shown("[x(t), y(t), ...]"),
            START,
            END,
            VARIABLE,
        ],
        summary: "polynomials as the coordinates of a Bézier curve over [a, b]",
        gives: Gives::Curve,
        example: "curve_of([t, t^2], 0, 1)",
        call: |_, args| {
            let (items, scalar) = match args.value(0)? {
                Value::List(items) => (items.to_vec(), false),
                one => (vec![one.clone()], true),
            };
            let given = args.variable()?;
            let coordinate = |item: &Value| {
                args.with_first(item.clone()).univariate_in(0, given.clone()).map(|given| given.coefficients)
            };
            let coordinates = items.iter().map(coordinate).collect::<Result<Vec<_>>>()?;
            let curve = BezierCurve::from_power(&coordinates, interval(args, 1)?)
                .map_err(curve_error)
                .at(args.span(0))?;
            Ok(bezier(curve, Form { scalar, rational: false }))
        },
        ..NEW
    },
    Builtin {
        name: "extended",
        parameters: &[CURVE, required("t", Takes::Scalar, "the parameter")],
        summary: "the value of a curve at any parameter, also outside of its interval",
        gives: Gives::Point,
        example: "extended(bezier([0, 1, 3]), 2)",
        on_surface: on_surface::EXTENDED,
        call: |_, args| {
            let t = args.scalar(1)?;
            if let Value::Geometry(geometry) = args.value(0)?
                && let Geometry::Spline(spline, form) = &**geometry
            {
                let point = super::splines::nearest_piece(spline, &t)
                    .and_then(|span| spline.value_on(span, &t).map_err(spline_error));
                return form.value(point.at(args.span(1))?).map_err(curve_error);
            }
            let (curve, form) = args.bezier(0)?;
            form.value(curve.value(&t)).map_err(curve_error)
        },
        ..NEW
    },
    Builtin {
        name: "casteljau",
        parameters: &[
            CURVE,
            many("u_1, ..., u_n", Takes::Scalar, 1, "one parameter, or as many as the degree"),
        ],
        summary: "de Casteljau's scheme with polar labels, for one parameter or for n of them",
        gives: Gives::Table,
        example: "casteljau(bezier([0, 1, 4]), 1/2)",
        on_surface: on_surface::CASTELJAU,
        call: |_, args| {
            let (curve, form) = args.bezier(0)?;
            let list = repeated(args.scalars_from(1)?, curve.degree());
            let tableau = curve.tableau(&list).map_err(curve_error).at(args.span(1))?;
            let local = |u| curve.interval().local(u);
            let ratios = list.iter().enumerate().map(|(r, u)| vec![local(u); curve.degree() - r]);
            Ok(scheme(&tableau, &ratios.collect::<Vec<_>>(), form))
        },
        ..NEW
    },
    Builtin {
        name: "control_points",
        parameters: &[required("c", Takes::Geometry, "the curve")],
        summary: "the control points of a curve, without weights",
        gives: Gives::Points,
        example: "control_points(elevate(bezier([0, 2])))",
        on_surface: on_surface::CONTROL_POINTS,
        call: |_, args| {
            let geometry = args.geometry(0)?;
            let form = geometry.form();
            let points = geometry.control_points();
            match form.split(&points) {
                Some((values, _)) => Ok(Value::list(values)),
                None => Err(curve_error(crate::math::curve::CurveError::ZeroDenominator).at(args.span(0))),
            }
        },
        ..NEW
    },
    Builtin {
        name: "weights",
        parameters: &[required("c", Takes::Geometry, "the curve or surface")],
        summary: "the weights of a curve: all 1 if it is polynomial",
        gives: Gives::Scalars,
        example: "weights(bezier([0, 1, 2], weights=[1, 2, 1]))",
        call: |_, args| {
            let geometry = args.geometry(0)?;
            let points = geometry.control_points();
            let rational = geometry.form().rational;
            let weight = |point: &Point<Fraction>| {
                if rational { point[point.len() - 1].clone() } else { Fraction::one() }
            };
            Ok(scalar_list(points.iter().map(weight)))
        },
        ..NEW
    },
    Builtin {
        name: "subdivide",
        parameters: &[CURVE, many("t_1, ..., t_k", Takes::ScalarOrList, 1, "the parameters")],
        summary: "the parts of a curve between parameters, as a list",
        gives: Gives::Curves,
        example: "subdivide(bezier([0, 1, 4]), 1/2)",
        on_surface: on_surface::SUBDIVIDE,
        call: |_, args| {
            let mut places = args.scalars_or_list(1)?;
            if let Some((s, form)) = given_spline(args)? {
                return spline_parts(args, s, places, form);
            }
            let (curve, form) = args.bezier(0)?;
            if let Some(k) = places.iter().position(|t| curve.contains(t) == Some(false)) {
                let (a, b) = curve.interval().ends();
                return Err(curve_error(crate::math::curve::CurveError::OutsideDomain)
                    .at(args.span(k + 1))
                    .reason(format!("the interval is [{a}, {b}]"))
                    .hint("part(c, r, s) is the polynomial over any interval"));
            }
            let forwards = crate::math::ring::compare(curve.interval().start(), curve.interval().end());
            places.sort_by(|x, y| {
                let order = crate::math::ring::compare(x, y).unwrap_or(std::cmp::Ordering::Equal);
                if forwards == Some(std::cmp::Ordering::Greater) { order.reverse() } else { order }
            });
            let parts = curve.subdivide_at(&places).map_err(curve_error).at(args.span(1))?;
            Ok(Value::List(parts.into_iter().map(|part| bezier(part, form)).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "part",
        parameters: &[
            CURVE,
            required("r", Takes::Scalar, "where the part starts"),
            required("s", Takes::Scalar, "where it ends"),
        ],
        summary: "the part of a curve over [r, s]; of a Bézier curve also outside of its interval",
        gives: Gives::SameCurve,
        example: "part(bezier([0, 1, 4]), 1/2, 1)",
        on_surface: on_surface::PART,
        call: |_, args| {
            if let Some((s, form)) = given_spline(args)? {
                let part = stretch(args).and_then(|interval| s.part(interval).map_err(spline_error));
                return part.map(|part| spline(part, form)).at(args.span(1));
            }
            let (curve, form) = args.bezier(0)?;
            let interval = stretch(args).at(args.span(2))?;
            Ok(bezier(curve.part(interval), form))
        },
        ..NEW
    },
    Builtin {
        name: "reverse",
        parameters: &[required(
            "c",
            Takes::OneOf(&[Takes::Curve, Takes::List]),
            "a Bézier curve, a B-spline curve or a list",
        )],
        summary: "the same curve run through backwards, over the same interval; a list backwards",
        gives: Gives::Any,
        example: "reverse(bezier([0, 1, 4]))",
        call: |_, args| {
            if let Value::List(items) = args.value(0)? {
                return Ok(Value::List(items.iter().rev().cloned().collect()));
            }
            crate::language::ops::geometry::backwards(args.geometry(0)?.as_ref()).at(args.span(0))
        },
        ..NEW
    },
    Builtin {
        name: "over",
        parameters: &[
            CURVE,
            required("a", Takes::Scalar, "the start of the interval"),
            required("b", Takes::Scalar, "its end"),
        ],
        summary: "the same control points over another interval",
        gives: Gives::Curve,
        example: "over(bezier([0, 1, 4]), 1, 3)",
        call: |_, args| {
            let (curve, form) = args.bezier(0)?;
            let interval = Interval::new(args.scalar(1)?, args.scalar(2)?);
            Ok(bezier(curve.over(interval.map_err(curve_error).at(args.span(2))?), form))
        },
        ..NEW
    },
    Builtin {
        name: "hodograph",
        parameters: &[CURVE],
        summary: "the curve of the derivatives, with control points n/(b - a) (b_(i+1) - b_i)",
        gives: Gives::SameCurve,
        example: "hodograph(bezier([[0, 0], [1, 2], [2, 0]]))",
        call: |_, args| super::on_geometry::nth_derivative(args, 1),
        ..NEW
    },
    Builtin {
        name: "antiderivative",
        parameters: &[required("c", Takes::Geometry, "the curve or piecewise polynomial")],
        summary: "the curve with this derivative that starts at 0",
        gives: Gives::SameCurve,
        example: "antiderivative(bezier([1, 2]))",
        call: |_, args| super::on_geometry::antiderivative(args),
        ..NEW
    },
    Builtin {
        name: "support",
        parameters: &[required("N", Takes::Piecewise, "a piecewise polynomial, such as a basis function")],
        summary: "the interval outside of which a piecewise polynomial is 0, as [t_i, t_(i+n+1)] of N_i^n",
        gives: Gives::Scalars,
        example: "support(bspline_basis(2, [0, 1, 2, 3, 4], 1))",
        call: |_, args| {
            let Value::Piecewise(function) = args.value(0)? else {
                return Err(wrong_kind("a piecewise polynomial", args.value(0)?).at(args.span(0)));
            };
            let (breaks, pieces) = (function.function.breaks(), function.function.pieces());
            let used = |piece: &crate::math::poly::Coefficients<Fraction>| piece.degree().is_some();
            match (pieces.iter().position(used), pieces.iter().rposition(used)) {
                (Some(first), Some(last)) => {
                    Ok(scalar_list([&breaks[first], &breaks[last + 1]].into_iter().cloned()))
                }
                _ => Ok(Value::list(Vec::new())),
            }
        },
        ..NEW
    },
    Builtin {
        name: "domain",
        parameters: &[required("c", Takes::Geometry, "the curve, spline or piecewise polynomial")],
        summary: "the interval [a, b] over which a curve is given",
        gives: Gives::Scalars,
        example: "domain(bspline(2, [0, 1, 2, 3, 4, 5], [1, 3, 2]))",
        call: |_, args| {
            let (a, b) = match args.value(0)? {
                Value::Piecewise(function) => {
                    let breaks = function.function.breaks();
                    (&breaks[0], &breaks[breaks.len() - 1])
                }
                Value::Geometry(geometry) => match &**geometry {
                    Geometry::Bezier(curve, _) => curve.interval().ends(),
                    Geometry::Spline(spline, _) => spline.interval().ends(),
                    _ => return Err(wrong_kind("a curve", args.value(0)?).at(args.span(0))),
                },
                other => return Err(wrong_kind("a curve", other).at(args.span(0))),
            };
            Ok(Value::list(vec![Value::Scalar(a.clone()), Value::Scalar(b.clone())]))
        },
        ..NEW
    },
    Builtin {
        name: "differences",
        parameters: &[
            required("points", Takes::Points, "the points").shown("[b_0, ..., b_n]"),
            ORDER_OF_DIFFERENCES,
        ],
        summary: "the forward differences of order k (1 if not given)",
        gives: Gives::Points,
        example: "differences([b_0, b_1, b_2], 2)",
        on_curve: Variant::new(&[CURVE, ORDER_OF_DIFFERENCES], Gives::Points, differences),
        call: |_, args| differences(args),
        ..NEW
    },
    Builtin {
        name: "edges",
        parameters: &[CURVE],
        summary: "b_0 and the edge vectors: the coefficients in Bézier's original basis f_i^n",
        gives: Gives::Points,
        example: "edges(bezier([1, 2, 4]))",
        call: |_, args| {
            let (curve, form) = args.bezier(0)?;
            let (start, edges) = curve.edges();
            let edges = edges.into_iter().map(|edge| form.plain(edge));
            Ok(Value::List(std::iter::once(form.plain(start.clone())).chain(edges).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "from_edges",
        parameters: &[
            required("edges", Takes::Points, "the start and the edge vectors").shown("[a_0, ..., a_n]"),
            START,
            END,
        ],
        summary: "the Bézier curve with these edge vectors, the first being its start",
        gives: Gives::Curve,
        example: "from_edges([1, 1, 2])",
        call: |_, args| {
            let (mut edges, form) = args.control_points(0)?;
            let start = edges.remove(0);
            let edges: Vec<_> = edges.iter().map(Point::position).collect();
            let curve = BezierCurve::from_edges(start, &edges, interval(args, 1)?);
            let curve = curve.map_err(curve_error).at(args.span(0))?;
            Ok(bezier(curve, form))
        },
        ..NEW
    },
    Builtin {
        name: "edge_basis",
        parameters: &[DEGREE, optional("t", Takes::Scalar, "t", "the parameter")],
        summary: "Bézier's original basis f_0^n, ..., f_n^n with f_i = B_i^n + ... + B_n^n",
        gives: Gives::Scalars,
        example: "edge_basis(3, t)",
        call: |_, args| {
            let n = args.size(0)?;
            crate::budget::charge_terms((n as u64 + 1).saturating_mul(n as u64 + 1));
            let letter = || Fraction::from(MultiPoly::symbol(Symbol::new("t")));
            let t = args.optional_scalar(1)?.unwrap_or_else(letter);
            let lifted =
                |p: &Vec<Rational>| p.iter().map(Fraction::from_rational).collect::<Coefficients<_>>();
            let basis = curve::bezier_edge_basis(n);
            Ok(scalar_list(basis.iter().map(|p| lifted(p).value(&t))))
        },
        ..NEW
    },
    Builtin {
        name: "curve_product",
        parameters: &[
            required("c", Takes::Curve, "a curve or spline"),
            required("d", Takes::Curve, "another one"),
        ],
        summary: "function times curve, or the scalar product of two curves, over one interval",
        gives: Gives::SameCurve,
        example: "curve_product(bezier([1, 2]), bezier([[0, 0], [1, 3]]))",
        call: |_, args| super::on_geometry::product(args),
        ..NEW
    },
    Builtin {
        name: "convex_hull",
        parameters: &[required("points", Takes::Points, "the points").shown("[p_0, ..., p_n]")],
        summary: "the corners of the convex hull of points of the plane, counterclockwise",
        gives: Gives::Points,
        example: "convex_hull([[0, 0], [1, 1], [2, 0], [1, 3]])",
        on_curve: Variant::new(&[CURVE], Gives::Points, hull),
        on_surface: Variant::new(&[SURFACE], Gives::Points, hull),
        call: |_, args| hull(args),
        ..NEW
    },
    Builtin {
        name: "bernstein_maximum",
        parameters: &[DEGREE, size("i", "the number of the polynomial")],
        summary: "where B_i^n is largest on [0, 1], namely i/n, and its value there",
        gives: Gives::Scalars,
        example: "bernstein_maximum(3, 1)",
        call: |_, args| {
            let (place, value) = curve::bernstein_maximum(args.size(0)?, args.size(1)?).map_err(|_| {
                Diagnostic::error(Code::Domain, "i is at most n")
                    .at(args.span(1))
                    .hint("B_i^n has 0 <= i <= n")
            })?;
            Ok(Value::list(vec![Value::number(place), Value::number(value)]))
        },
        ..NEW
    },
    Builtin {
        name: "bernstein_scaling",
        parameters: &[DEGREE, required("c", Takes::Scalar, "the factor")],
        summary: "the matrix of the B_i^n(c t) in the B_j^n(t): its entries are B_i^j(c)",
        gives: Gives::Matrix,
        example: "bernstein_scaling(2, 1/2)",
        call: |_, args| {
            let n = args.size(0)?;
            crate::budget::charge_terms((n as u64 + 1).saturating_mul(n as u64 + 1));
            let rows = curve::bernstein_scaling(n, &args.scalar(1)?);
            Ok(Value::Matrix(nalgebra::DMatrix::from_fn(n + 1, n + 1, |i, j| rows[i][j].clone())))
        },
        ..NEW
    },
    Builtin {
        name: "affine_combination",
        parameters: &[
            required("points", Takes::Points, "the points").shown("[p_0, ..., p_k]"),
            required("weights", Takes::Scalars, "a weight for each point").shown("[w_0, ..., w_k]"),
        ],
        summary: "the weighted sum of points: weights of sum 1 give a point, of sum 0 a vector",
        gives: Gives::Point,
        example: "affine_combination([[0, 0], [2, 4]], [1/2, 1/2])",
        call: |_, args| {
            let (points, form) = args.control_points(0)?;
            let weights = args.scalars(1)?;
            let total = weights.iter().fold(Fraction::zero(), |sum, w| sum.plus(w));
            if !total.is_one() && !total.is_zero() {
                return Err(Diagnostic::error(
                    Code::Domain,
                    format!("the weights add up to {total}, not to 1 or 0"),
                )
                .at(args.span(1))
                .hint("only sums 1 (a point) and 0 (a vector) do not depend on the origin"));
            }
            affine::affine_combination(&points, &weights)
                .map(|p| form.plain(p.coordinates()))
                .map_err(curve_error)
        },
        ..NEW
    },
    Builtin {
        name: "barycentric",
        parameters: &[
            required("p", Takes::Point, "the point"),
            required("corners", Takes::Points, "the corners").shown("[a_0, ..., a_k]"),
        ],
        summary: "the barycentric coordinates of a point with respect to independent corners",
        gives: Gives::Scalars,
        example: "barycentric([1, 1], [[0, 0], [3, 0], [0, 3]])",
        call: |_, args| {
            let value = args.value(0)?;
            let (point, _) = point_of(value).ok_or_else(|| wrong_kind("a point", value).at(args.span(0)))?;
            let (corners, _) = args.control_points(1)?;
            if point.len() == 1 && corners.len() > 2 {
                let message = format!("{} corners on a line, where two are enough", corners.len());
                return Err(Diagnostic::error(Code::Degenerate, message)
                    .at(args.span(1))
                    .reason("a symbol is a number here")
                    .hint("write points by their coordinates, such as [x_0, y_0]"));
            }
            affine::barycentric(&corners, &point).map(scalar_list).map_err(curve_error).at(args.span(1))
        },
        ..NEW
    },
    Builtin {
        name: "affine_rank",
        parameters: &[required("points", Takes::Points, "the points").shown("[p_0, ..., p_k]")],
        summary: "the dimension of the affine span of points; k for independent ones",
        gives: Gives::Count,
        example: "affine_rank([[0, 0], [1, 1], [2, 2]])",
        call: |_, args| {
            let (points, _) = args.control_points(0)?;
            let rank = affine::affine_rank(&points).map_err(curve_error).at(args.span(0))?;
            Ok(Value::int(rank as i64))
        },
        ..NEW
    },
];

/// The first argument, if it is a B-spline curve.
fn given_spline(args: &Arguments) -> Result<Option<(BSpline<Fraction>, Form)>> {
    let Value::Geometry(geometry) = args.value(0)? else { return Ok(None) };
    Ok(if let Geometry::Spline(s, form) = &**geometry { Some((s.clone(), *form)) } else { None })
}

/// A spline cut at parameters inside of its domain.
fn spline_parts(
    args: &Arguments,
    s: BSpline<Fraction>,
    mut places: Vec<Fraction>,
    form: Form,
) -> Result<Value> {
    places.sort_by(|x, y| crate::math::ring::compare(x, y).unwrap_or(std::cmp::Ordering::Equal));
    let mut parts = Vec::with_capacity(places.len() + 1);
    let mut rest = s;
    for t in &places {
        let (before, after) = rest.subdivide(t).map_err(spline_error).at(args.span(1))?;
        parts.push(spline(before, form));
        rest = after;
    }
    parts.push(spline(rest, form));
    Ok(Value::list(parts))
}

/// The interval with its ends at the second and third place; 0 and the number after the start if not
/// given.
pub(super) fn interval(args: &Arguments, from: usize) -> Result<Interval<Fraction>> {
    let (a, b) = (args.optional_scalar(from)?, args.optional_scalar(from + 1)?);
    // bezier(points, 1/2) would be a curve over another interval, where a value was meant.
    if a.is_some() && b.is_none() {
        return Err(Diagnostic::error(Code::Arity, "an interval has two ends")
            .at(args.span(from))
            .reason("the start of an interval, or the parameter of a point?")
            .hint("write (...)(t) after the curve for its value at t")
            .hint("or give both ends of the interval"));
    }
    let (a, b) = (a.unwrap_or_else(Fraction::zero), b.unwrap_or_else(Fraction::one));
    Interval::new(a, b).map_err(curve_error).at(args.span(0))
}

/// The differences of points or of the control points of a curve.
fn differences(args: &Arguments) -> Evaluated {
    let order = args.size(1)?;
    let (points, form) = match args.value(0)? {
        Value::Geometry(geometry) => (geometry.control_points(), geometry.form()),
        _ => args.control_points(0)?,
    };
    let curve = BezierCurve::new(points, Interval::unit());
    let curve = curve.map_err(curve_error).at(args.span(0))?;
    let list = curve.differences(order.min(curve.degree() + 1));
    Ok(Value::List(list.into_iter().map(|point| form.plain(point)).collect()))
}

/// The hull of points or of the control points of a curve or surface.
fn hull(args: &Arguments) -> Evaluated {
    let points = match args.value(0)? {
        Value::Geometry(geometry) if !geometry.form().rational => geometry.control_points(),
        Value::Geometry(geometry) => {
            let split = geometry.form().split(&geometry.control_points());
            let positive =
                |w: &Fraction| w.as_rational().is_some_and(|q| num_traits::Signed::is_positive(&q));
            let (values, weights) = split.ok_or_else(|| {
                curve_error(crate::math::curve::CurveError::ZeroDenominator).at(args.span(0))
            })?;
            if !weights.iter().all(positive) {
                return Err(Diagnostic::error(
                    Code::Domain,
                    "the curve lies in the hull only if all weights are positive",
                )
                .at(args.span(0)));
            }
            values.iter().filter_map(|value| point_of(value).map(|(point, _)| point)).collect()
        }
        value => points_of(value).ok_or_else(|| wrong_kind("a list of points", value).at(args.span(0)))?.0,
    };
    let numbers: Option<Vec<Point<Rational>>> =
        points.iter().map(|point| point.iter().map(Fraction::as_rational).collect()).collect();
    let numbers = numbers.ok_or_else(|| {
        Diagnostic::error(Code::Undecided, "the hull of points with symbols depends on their values")
            .at(args.span(0))
            .hint("give the symbols values first")
    })?;
    let hull = curve::convex_hull(&numbers).map_err(curve_error).at(args.span(0))?;
    let corner = |point: Point<Rational>| scalar_list(point.iter().map(Fraction::from_rational));
    Ok(Value::List(hull.into_iter().map(corner).collect()))
}

/// [r, s] at the second and third place.
fn stretch(args: &Arguments) -> Result<Interval<Fraction>> {
    Interval::new(args.scalar(1)?, args.scalar(2)?).map_err(curve_error)
}

/// One parameter n times, or all arguments as they are.
pub(super) fn repeated(list: Vec<Fraction>, n: usize) -> Vec<Fraction> {
    match list.as_slice() {
        [t] => vec![t.clone(); n],
        _ => list,
    }
}

/// A scheme as a table; homogeneous points as they are. ratios[r][i] is how point i of level r + 1
/// lies between points i and i + 1 of level r. Where values would be long (symbolic points or
/// knots), each is shown as the mean it is.
pub(super) fn scheme(tableau: &Tableau<Fraction>, ratios: &[Vec<Fraction>], form: Form) -> Value {
    let as_means = shown_as_means(tableau, ratios);
    let cell = |r: usize, i: usize| {
        let label = polar_label(&tableau.labels[r][i]);
        if r == 0 || !as_means {
            return Cell::Labelled(label, form.plain(tableau.levels[r][i].clone()));
        }
        let below = |k: usize| polar_label(&tableau.labels[r - 1][k]);
        let mean = mean_of_two(&ratios[r - 1][i], below(i), below(i + 1));
        Cell::Formula(Expr::relation(label, Rel::Eq, mean))
    };
    let levels =
        (0..tableau.levels.len()).map(|r| (0..tableau.levels[r].len()).map(|i| cell(r, i)).collect());
    Value::Table(Arc::new(Table::triangle(levels.collect())))
}
