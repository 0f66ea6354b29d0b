//! B-splines and piecewise polynomials.

use super::gives::Gives;
use crate::language::eval::Arguments;
use crate::language::ops::errors::{piecewise_error, polar_error, spline_error, wrong_kind};
use crate::language::ops::formula;
use crate::language::ops::geometry::{bezier, scalar_list, spline};
use std::sync::Arc;

use super::parameter::{
    DEGREE, HOMOGENEOUS, KNOTS, Parameter, SPAN, SPLINE, VARIABLE, many, named, optional, required, size,
};
use super::{Builtin, on_surface};
use crate::formula::{Expr, Kind, Sign, Term};
use crate::language::derive::polar_label;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::takes::Takes;
use crate::language::value::{Cell, Form, PiecewiseFunction, Table, Value, free_parameter, polynomial_expr};
use crate::math::interval::Interval;
use crate::math::piecewise::{Outside, Piecewise};
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::{Field, Ring};
use crate::math::spline::{BSpline, DeBoor, KnotVector};
use num_traits::{One, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("B-splines");

const POINTS: Parameter = required("points", Takes::Points, "the control points");

/// The knots, where a spline may stand for degree and knots.
const OWN_KNOTS: Parameter =
    optional("knots", Takes::Scalars, "those of the spline", "the knots in increasing order")
        .shown("[t_0, ..., t_k]");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "bspline",
        parameters: &[
            DEGREE,
            KNOTS,
            POINTS.shown("[d_0, ..., d_m]"),
            named("weights=[w_0, ..., w_m]", Takes::Scalars, "all 1", "the weights of the points"),
            HOMOGENEOUS,
        ],
        summary: "the spline of degree n with these knots and control points; k = m + n + 1",
        gives: Gives::Spline,
        example: "bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4])(1)",
        call: |_, args| {
            let knots = knots(args)?;
            let (points, form) = args.control_points(2)?;
            let s = BSpline::new(knots, points).map_err(spline_error).at(args.span(2))?;
            Ok(spline(s, form))
        },
        ..NEW
    },
    Builtin {
        name: "periodic_spline",
        parameters: &[
            DEGREE,
            required("knots", Takes::Scalars, "the knots of one period").shown("[t_0, ..., t_m]"),
            POINTS.shown("[d_0, ..., d_(m-1)]"),
            named("weights=[w_0, ..., w_(m-1)]", Takes::Scalars, "all 1", "the weights of the points"),
        ],
        summary: "the closed spline with knots t_0 < ... < t_m over one period and m control points",
        gives: Gives::Spline,
        example: "periodic_spline(2, [0, 1, 2, 3], [[0, 0], [3, 0], [0, 3]])",
        call: |_, args| {
            let n = args.size(0)?;
            let period = args.scalars(1)?;
            let (points, form) = args.control_points(2)?;
            if period.len() != points.len() + 1 {
                let (m, k) = (points.len(), period.len());
                return Err(Diagnostic::error(
                    Code::Knots,
                    format!("{m} control points over one period need {} knots, not {k}", m + 1),
                )
                .at(args.span(1))
                .hint("the last knot is the first one of the next period"));
            }
            let s = BSpline::periodic(n, &period, &points).map_err(spline_error).at(args.span(1))?;
            Ok(spline(s, form))
        },
        ..NEW
    },
    Builtin {
        name: "spline_of",
        parameters: &[required("F", Takes::Polynomial, "the polynomial"), DEGREE, KNOTS, VARIABLE],
        summary: "a polynomial as a spline: control points f(t_(i+1), ..., t_(i+n)), as Marsden says",
        gives: Gives::Spline,
        example: "spline_of((x - t)^2, 2, [0, 0, 0, 1, 2, 2, 2], variable=t)",
        call: |_, args| {
            let given = args.univariate(0)?;
            let own = given.coefficients.iter().rposition(|c| !c.is_zero()).unwrap_or(0);
            let form =
                crate::math::blossom::PolarForm::with_degree(given.coefficients, own).map_err(polar_error)?;
            let knots = knots_at(args, 1, 2)?;
            let s = BSpline::of_polynomial(knots, &[form]).map_err(spline_error).at(args.span(0))?;
            Ok(spline(s, Form { scalar: true, rational: false }))
        },
        ..NEW
    },
    Builtin {
        name: "spline_from_pieces",
        parameters: &[
            DEGREE,
            KNOTS,
            required("pieces", Takes::List, "a Bézier curve for each interval").shown("[c_0, c_1, ...]"),
        ],
        summary: "Bézier curves over the knot intervals joined to a spline, where they fit exactly",
        gives: Gives::Spline,
        example: "spline_from_pieces(1, [0, 0, 1, 2, 2], [bezier([0, 1]), bezier([1, 5], 1, 2)])",
        call: |_, args| {
            let knots = knots(args)?;
            let items = args.list(2)?;
            let mut pieces = Vec::with_capacity(items.len());
            let mut form = Form::default();
            for item in items {
                let (curve, own) = args.with_first(item.clone()).bezier(0).at(args.span(2))?;
                form = own;
                pieces.push(curve);
            }
            let s = BSpline::from_pieces(knots, &pieces).map_err(spline_error).at(args.span(2))?;
            Ok(spline(s, form))
        },
        ..NEW
    },
    Builtin {
        name: "uniform_knots",
        parameters: &[
            DEGREE,
            size("m", "the number of control points"),
            optional("a", Takes::Scalar, "0", "the first knot"),
            optional("h", Takes::Scalar, "1", "the distance of knots"),
        ],
        summary: "the knots a, a + h, ... for m control points of degree n (a = 0, h = 1)",
        gives: Gives::Scalars,
        example: "uniform_knots(3, 5)",
        call: |_, args| {
            let a = args.scalar(2)?;
            let h = args.scalar(3)?;
            let knots = KnotVector::uniform(args.size(0)?, args.size(1)?, &a, &h).map_err(spline_error)?;
            Ok(scalar_list(knots.knots().iter().cloned()))
        },
        ..NEW
    },
    Builtin {
        name: "clamped_knots",
        parameters: &[
            DEGREE,
            required("knots", Takes::Scalars, "the ends and the knots between them")
                .shown("[a, t_1, ..., b]"),
        ],
        summary: "the same knots with both ends repeated n + 1 times",
        gives: Gives::Scalars,
        example: "clamped_knots(2, [0, 1, 2])",
        call: |_, args| {
            let n = args.size(0)?;
            let list = args.scalars(1)?;
            let [a, inner @ .., b] = list.as_slice() else {
                return Err(Diagnostic::error(Code::Knots, "two ends are needed")
                    .at(args.span(1))
                    .hint("such as [0, 1, 2]"));
            };
            let interval = Interval::new(a.clone(), b.clone())
                .map_err(|error| spline_error(error.into()))
                .at(args.span(1))?;
            let knots = KnotVector::clamped(n, inner, &interval).map_err(spline_error).at(args.span(1))?;
            Ok(scalar_list(knots.knots().iter().cloned()))
        },
        ..NEW
    },
    Builtin {
        name: "greville",
        parameters: &[size("n", "the degree; or a spline alone"), OWN_KNOTS],
        summary: "the Greville abscissae: means of n consecutive knots",
        gives: Gives::Scalars,
        example: "greville(3, [0, 0, 0, 0, 1, 2, 2, 2, 2])",
        call: |_, args| {
            let knots = knots_or_spline(args)?;
            Ok(scalar_list((0..knots.count()).map(|i| knots.greville(i))))
        },
        ..NEW
    },
    Builtin {
        name: "knots",
        parameters: &[SPLINE],
        summary: "the knots of a spline",
        gives: Gives::Scalars,
        example: "knots(bspline(1, [0, 0, 1, 2, 2], [1, 3, 2]))",
        call: |_, args| Ok(scalar_list(args.spline(0)?.0.knots().knots().iter().cloned())),
        ..NEW
    },
    Builtin {
        name: "multiplicities",
        parameters: &[size("n", "the degree; or a spline alone"), OWN_KNOTS],
        summary: "the distinct knots with their multiplicities and the smoothness n - s they promise",
        gives: Gives::Table,
        example: "multiplicities(2, [0, 0, 0, 1, 1, 2, 2, 2])",
        call: |_, args| {
            let knots = knots_or_spline(args)?;
            let mut table = Table::with_header(["knot", "multiplicity", "smoothness"]);
            for (knot, s) in knots.multiplicities() {
                let promise = Value::int(knots.degree() as i64 - s as i64);
                let row = [Value::Scalar(knot), Value::int(s as i64), promise];
                table.rows.push(row.map(Cell::Value).to_vec());
            }
            Ok(Value::Table(Arc::new(table)))
        },
        ..NEW
    },
    Builtin {
        name: "labels",
        parameters: &[SPLINE],
        summary: "each control point with its polar label f(t_(i+1), ..., t_(i+n)) and Greville abscissa",
        gives: Gives::Table,
        example: "labels(bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]))",
        on_surface: on_surface::LABELS,
        call: |_, args| {
            let (s, form) = args.spline(0)?;
            let mut table = Table::with_header(["i", "control point", "Greville abscissa"]);
            for (i, point) in s.points().iter().enumerate() {
                table.rows.push(vec![
                    Cell::Value(Value::int(i as i64)),
                    Cell::Labelled(polar_label(s.knots().label(i)), form.plain(point.clone())),
                    Cell::Value(Value::Scalar(s.knots().greville(i))),
                ]);
            }
            Ok(Value::Table(Arc::new(table)))
        },
        ..NEW
    },
    Builtin {
        name: "bspline_basis",
        parameters: &[DEGREE, KNOTS, optional("i", Takes::Size, "all of them", "the number of the function")],
        summary: "the basis function N_i^n as a piecewise polynomial; without i, all of them",
        gives: Gives::Piecewise,
        example: "bspline_basis(2, [0, 1, 2, 3], 0)(3/2)",
        call: |_, args| {
            let knots = knots(args)?;
            if let Some(i) = args.optional_size(2)? {
                let function = knots.basis_function(i).map_err(spline_error).at(args.span(2))?;
                return Ok(basis_function(&knots, i, function));
            }
            let functions = knots.basis_functions().into_iter().enumerate();
            Ok(Value::List(functions.map(|(i, function)| basis_function(&knots, i, function)).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "piecewise",
        parameters: &[
            required("breaks", Takes::Scalars, "the breakpoints in increasing order")
                .shown("[x_0, ..., x_m]"),
            required("pieces", Takes::Scalars, "a polynomial for each interval").shown("[p_1, ..., p_m]"),
            named("outside=0", Takes::Integer, "it has no value there", "the value outside, which is 0"),
            named(
                "closed=0",
                Takes::Any,
                "1",
                "0 if x_m does not belong to the last interval, [x_k] if x_k does to the one before it",
            ),
            VARIABLE,
        ],
        summary: "polynomials between breakpoints; with outside=0 it is 0 elsewhere",
        gives: Gives::Piecewise,
        example: "piecewise([0, 1, 2], [t, 2 - t], outside=0)",
        call: |_, args| {
            let breaks = args.scalars(0)?;
            let formulas = args.scalars(1)?;
            let guess = || -> Result<Symbol> {
                for formula in &formulas {
                    if !formula.variables().is_empty() {
                        return formula::variable_of(formula, None).at(args.span(1));
                    }
                }
                Ok(Symbol::new("t"))
            };
            let variable = args.variable()?.map_or_else(guess, Ok)?;
            let piece = |formula: &Fraction| formula::coefficients_in(formula, &variable).at(args.span(1));
            let pieces = formulas.iter().map(piece).collect::<Result<Vec<_>>>()?;
            let outside = match args.named("outside") {
                None => Outside::Undefined,
                Some((value, _)) if value.as_int() == Some(0) => Outside::Zero,
                Some((value, span)) => {
                    return Err(wrong_kind("0", value).at(span).hint("outside=0, or leave it out"));
                }
            };
            let function =
                Piecewise::new(breaks, pieces, outside).map_err(piecewise_error).at(args.span(0))?;
            let function = match args.named("closed") {
                Some((Value::List(items), span)) => match items.iter().collect::<Vec<_>>().as_slice() {
                    [Value::Scalar(x)] if function.breaks().contains(x) => function.left_at(x),
                    _ => {
                        let error =
                            wrong_kind("one of the breakpoints in a list", &Value::List(items.clone()));
                        return Err(error.at(span).hint("closed=[1]"));
                    }
                },
                _ if args.flag_or("closed", true)? => function,
                _ => function.half_open(),
            };
            Ok(Value::Piecewise(Arc::new(PiecewiseFunction::new(function, variable))))
        },
        ..NEW
    },
    Builtin {
        name: "deboor",
        parameters: &[
            SPLINE,
            many("u_1, ..., u_n", Takes::Scalar, 1, "one parameter, or as many as the degree"),
            SPAN,
        ],
        summary: "de Boor's scheme with polar labels, for one parameter or for n of them",
        gives: Gives::Table,
        example: "deboor(bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]), 1/2)",
        call: |_, args| {
            let (s, form) = args.spline(0)?;
            let (scheme, _) = de_boor(args, &s)?;
            Ok(super::curves::scheme(&scheme.tableau, &scheme.ratios, form))
        },
        on_surface: super::surface_schemes::DEBOOR,
        ..NEW
    },
    Builtin {
        name: "insert_knots",
        parameters: &[SPLINE, many("t_1, ..., t_k", Takes::ScalarOrList, 1, "the new knots"), SPAN],
        summary: "the same curve with these knots added; span=j names the interval of a symbol",
        gives: Gives::Spline,
        example: "insert_knots(bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]), 1/2, 1/2)",
        on_surface: on_surface::INSERT_KNOTS,
        call: |_, args| {
            let (s, form) = args.spline(0)?;
            if let Some(j) = args.named_size("span")? {
                if args.len() > 2 {
                    return Err(Diagnostic::error(Code::Arity, "with span=j one knot is inserted at a time")
                        .at(args.span(2)));
                }
                return s
                    .insert_on(j, &args.scalar(1)?)
                    .map(|s| spline(s, form))
                    .map_err(spline_error)
                    .at(args.span(1));
            }
            let fine = s.insert_all(&args.scalars_or_list(1)?).map_err(spline_error).at(args.span(1))?;
            Ok(spline(fine, form))
        },
        ..NEW
    },
    Builtin {
        name: "insertion_ratios",
        parameters: &[DEGREE, KNOTS, required("t", Takes::Scalar, "the new knot"), SPAN],
        summary: "the ratios (t - t_i)/(t_(i+n) - t_i) by which inserting t mixes d_(i-1) and d_i",
        gives: Gives::Table,
        example: "insertion_ratios(2, [t_0, t_1, t_2, t_3, t_4, t_5], t, span=2)",
        call: |_, args| {
            let knots = knots(args)?;
            let t = args.scalar(2)?;
            let j = match args.named_size("span")? {
                Some(j) => j,
                None => knots.span_of(&t).map_err(spline_error).at(args.span(2))?,
            };
            let mut table = Table::with_header(["i", "ratio"]);
            for (i, ratio) in knots.insertion_ratios(j, &t).map_err(spline_error)? {
                table.rows.push(vec![Cell::Value(Value::int(i as i64)), Cell::Value(Value::Scalar(ratio))]);
            }
            Ok(Value::Table(Arc::new(table)))
        },
        ..NEW
    },
    Builtin {
        name: "refine",
        parameters: &[
            SPLINE,
            optional(
                "knots",
                Takes::OneOf(&[Takes::Scalars, Takes::Size]),
                "each knot interval halved",
                "the finer knots, or how often the intervals are halved",
            )
            .shown("[t_0, ..., t_k]"),
        ],
        summary: "the same curve over finer knots (the Oslo algorithm), the outer ones as you like",
        gives: Gives::Spline,
        example: "refine(bspline(1, [0, 0, 2, 2], [1, 5]), [0, 0, 1, 2, 2])",
        call: |_, args| {
            let (mut s, form) = args.spline(0)?;
            if args.given(1).is_some_and(|(value, _)| Takes::Size.accepts(value)) {
                for _ in 0..args.size(1)? {
                    crate::budget::charge_terms(2 * s.points().len() as u64);
                    let finer = s.halved_knots();
                    s = finer.and_then(|finer| s.refine(finer)).map_err(spline_error).at(args.span(1))?;
                }
                return Ok(spline(s, form));
            }
            let finer = match args.given(1) {
                Some(_) => KnotVector::new(s.degree(), args.scalars(1)?),
                None => s.halved_knots(),
            };
            let finer = finer.map_err(spline_error).at(args.span(1))?;
            s.refine(finer).map(|s| spline(s, form)).map_err(spline_error).at(args.span(1))
        },
        ..NEW
    },
    Builtin {
        name: "remove_knot",
        parameters: &[
            SPLINE,
            required("t", Takes::Scalar, "the knot"),
            named("times=k", Takes::Size, "1", "how often it is removed"),
        ],
        summary: "the same curve with an inner knot removed, where that is exact",
        gives: Gives::Spline,
        example: "remove_knot(insert_knots(bspline(2, [0, 0, 0, 2, 2, 2], [1, 3, 2]), 1), 1)",
        call: |_, args| {
            let (s, form) = args.spline(0)?;
            let times = args.size_named("times")?;
            match s.remove(&args.scalar(1)?, times).map_err(spline_error).at(args.span(1))? {
                Ok(coarse) => Ok(spline(coarse, form)),
                Err(defect) => {
                    let jump = crate::language::write::text(&form.plain(defect.jump).to_expr());
                    Err(Diagnostic::error(
                        Code::NotReducible,
                        format!("the derivative of order {} jumps by {jump} at this knot", defect.order),
                    )
                    .at(args.span(1))
                    .hint("a knot can be removed exactly only where the curve is smoother than it promises"))
                }
            }
        },
        ..NEW
    },
    Builtin {
        name: "pieces",
        parameters: &[required("spline", Takes::Spline, "the spline or piecewise polynomial").shown("s")],
        summary: "the Bézier curves of a spline, or the polynomials of a piecewise one",
        gives: Gives::List,
        example: "pieces(bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]))",
        on_surface: on_surface::PIECES,
        call: |_, args| {
            if let Value::Piecewise(function) = args.value(0)? {
                return Ok(scalar_list(function.formulas()));
            }
            let (s, form) = args.spline(0)?;
            Ok(Value::List(s.bezier_pieces().into_iter().map(|piece| bezier(piece, form)).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "power_pieces",
        parameters: &[SPLINE],
        summary: "a spline as a piecewise polynomial in t, one for each coordinate",
        gives: Gives::Piecewise,
        example: "power_pieces(bspline(1, [0, 0, 1, 2, 2], [1, 3, 2]))",
        call: |_, args| {
            let (s, form) = args.spline(0)?;
            if form.rational {
                return Err(Diagnostic::error(Code::NotPolynomial, "this spline is rational")
                    .at(args.span(0))
                    .hint("homogeneous(s) is the polynomial spline of its homogeneous coordinates"));
            }
            let mut list: Vec<Value> = s.power_pieces().into_iter().map(piecewise).collect();
            Ok(if form.scalar { list.swap_remove(0) } else { Value::point(list) })
        },
        ..NEW
    },
    Builtin {
        name: "smoothness",
        parameters: &[SPLINE],
        summary: "for each inner knot: its multiplicity and how smooth the curve is there",
        gives: Gives::Table,
        example: "smoothness(bspline(2, [0, 0, 0, 1, 1, 2, 2, 2], [1, 3, 5, 7, 4]))",
        call: |_, args| {
            let (s, _) = args.spline(0)?;
            let mut table = Table::with_header(["knot", "multiplicity", "promised", "found"]);
            for (knot, multiplicity, order) in s.smoothness() {
                let promised = s.degree().checked_sub(multiplicity);
                let found = match order {
                    Some(k) if k == s.degree() => Cell::words("one polynomial"),
                    other => super::joins::class("C", other),
                };
                table.rows.push(vec![
                    Cell::Value(Value::Scalar(knot)),
                    Cell::Value(Value::int(multiplicity as i64)),
                    super::joins::class("C", promised),
                    found,
                ]);
            }
            Ok(Value::Table(Arc::new(table)))
        },
        ..NEW
    },
    Builtin {
        name: "spline_to_bezier",
        parameters: &[DEGREE, KNOTS],
        summary: "the matrix from control points to the Bézier points of all pieces",
        gives: Gives::Matrix,
        example: "spline_to_bezier(2, [0, 0, 0, 1, 2, 2, 2])",
        call: |_, args| {
            knots(args)?.to_bezier_matrix().map(Value::Matrix).map_err(spline_error).at(args.span(1))
        },
        ..NEW
    },
    Builtin {
        name: "spline_to_power",
        parameters: &[DEGREE, KNOTS, size("j", "the number of the interval [t_j, t_(j+1)]")],
        summary: "the matrix from the n + 1 control points of interval j to power coefficients in t",
        gives: Gives::Matrix,
        example: "spline_to_power(3, uniform_knots(3, 4, -3), 3)",
        call: |_, args| {
            knots(args)?.power_matrix(args.size(2)?).map(Value::Matrix).map_err(spline_error).at(args.span(2))
        },
        ..NEW
    },
];

pub(super) fn piecewise(function: Piecewise<Fraction>) -> Value {
    let variable = free_parameter(function.breaks());
    Value::Piecewise(Arc::new(PiecewiseFunction::new(function, variable)))
}

/// A basis function, over symbolic knots with its pieces as the products of the recurrence.
fn basis_function(knots: &KnotVector<Fraction>, i: usize, function: Piecewise<Fraction>) -> Value {
    /// Pieces of a larger degree have too many products.
    const LARGEST: usize = 5;
    let (n, variable) = (knots.degree(), free_parameter(function.breaks()));
    let support = knots.support(i);
    let symbolic = support.iter().any(|knot| knot.as_rational().is_none());
    let written = (symbolic && n <= LARGEST).then(|| products_of_recurrence(support, n, &variable));
    Value::Piecewise(Arc::new(PiecewiseFunction { function, variable, written }))
}

/// N_0^n over n + 2 knots by the recurrence of Cox and de Boor, each piece as a sum over the ways that
/// lead to it: (t - a)/(c - a) (c - t)/(c - b) + (d - t)/(d - b) (t - b)/(c - b). 2^n products.
fn products_of_recurrence(knots: &[Fraction], n: usize, variable: &Symbol) -> Vec<Expr> {
    let t = Fraction::from(MultiPoly::symbol(variable.clone()));
    let empty = |pair: &[Fraction]| pair[0] == pair[1];
    let mut level: Vec<Vec<Vec<Fraction>>> = knots
        .windows(2)
        .map(|pair| vec![if empty(pair) { Vec::new() } else { vec![Fraction::one()] }])
        .collect();
    for k in 1..=n {
        let share = |i: usize| knots[i + k].minus(&knots[i]).inverse();
        let times =
            |ways: &[Fraction], by: &Fraction| ways.iter().map(|way| way.times(by)).collect::<Vec<_>>();
        level = (0..level.len() - 1)
            .map(|i| {
                let mut pieces = vec![Vec::new(); k + 1];
                if let Some(s) = share(i) {
                    let rise = t.minus(&knots[i]).times(&s);
                    pieces
                        .iter_mut()
                        .zip(&level[i])
                        .for_each(|(piece, ways)| piece.extend(times(ways, &rise)));
                }
                if let Some(s) = share(i + 1) {
                    let fall = knots[i + k + 1].minus(&t).times(&s);
                    let shifted = pieces[1..].iter_mut().zip(&level[i + 1]);
                    shifted.for_each(|(piece, ways)| piece.extend(times(ways, &fall)));
                }
                pieces
            })
            .collect();
    }
    let sum = |ways: &Vec<Fraction>| {
        let term = |way: &Fraction| match polynomial_expr(way).kind {
            Kind::Add(mut terms) if terms.len() == 1 => terms.swap_remove(0),
            kind => Term { sign: Sign::Plus, expr: kind.into() },
        };
        Expr::sum(ways.iter().map(term).collect())
    };
    let pieces = level[0].iter().zip(knots.windows(2));
    pieces.filter(|(_, pair)| !empty(pair)).map(|(ways, _)| sum(ways)).collect()
}

/// Degree and knots at the first two places.
pub(super) fn knots(args: &Arguments) -> Result<KnotVector<Fraction>> {
    knots_at(args, 0, 1)
}

pub(super) fn knots_at(args: &Arguments, degree: usize, list: usize) -> Result<KnotVector<Fraction>> {
    KnotVector::new(args.size(degree)?, args.scalars(list)?).map_err(spline_error).at(args.span(list))
}

fn knots_or_spline(args: &Arguments) -> Result<KnotVector<Fraction>> {
    if args.given(1).is_none() { Ok(args.spline(0)?.0.knots().clone()) } else { knots(args) }
}

/// The knot interval nearest to a parameter.
pub(super) fn nearest_piece(s: &BSpline<Fraction>, t: &Fraction) -> Result<usize> {
    use std::cmp::Ordering;
    let spans = s.knots().spans();
    match s.knots().span_of(t) {
        Ok(span) => Ok(span),
        Err(crate::math::spline::SplineError::OutsideDomain) => {
            let before = crate::math::ring::compare(t, s.interval().start()) == Some(Ordering::Less);
            Ok(if before { spans[0] } else { spans[spans.len() - 1] })
        }
        Err(error) => Err(spline_error(error)),
    }
}

/// The scheme asked for by (s, u…, span=j), and its arguments.
pub(super) fn de_boor(args: &Arguments, s: &BSpline<Fraction>) -> Result<(DeBoor<Fraction>, Vec<Fraction>)> {
    let mut list = args.scalars_from(1)?;
    let span = match args.named_size("span")? {
        Some(span) => span,
        None => s.knots().span_of(&list[0]).map_err(spline_error).at(args.span(1))?,
    };
    list = super::curves::repeated(list, s.degree());
    let scheme = s.de_boor(span, &list).map_err(spline_error).at(args.span(1))?;
    Ok((scheme, list))
}
