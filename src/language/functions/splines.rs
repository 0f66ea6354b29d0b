//! B-splines and piecewise polynomials.

use std::sync::Arc;

use super::Builtin;
use crate::language::derive::polar_label;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::ops::errors::{piecewise_error, polar_error, spline_error, wrong_kind};
use crate::language::ops::formula;
use crate::language::ops::geometry::{bezier, scalar_list, spline};
use crate::language::value::{Cell, Form, PiecewiseFunction, Table, Value};
use crate::math::piecewise::{Outside, Piecewise};
use crate::math::poly::{Fraction, Symbol};
use crate::math::spline::{BSpline, DeBoor, KnotVector};
use num_traits::{One, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

const TOPIC: &str = "B-splines";

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "bspline",
        signature: "bspline(n, [t_0, ..., t_k], [d_0, ..., d_m], weights=[w_0, ..., w_m])",
        summary: "the spline of degree n with these knots and control points; k = m + n + 1",
        example: "bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4])(1)",
        topic: TOPIC,
        call: |_, args| {
            let signature = "bspline(n, [t_0, ..., t_k], [d_0, ..., d_m], weights=[w_0, ..., w_m])";
            args.expect(signature, 3..=3, &["weights", "homogeneous"])?;
            let knots = knots(args)?;
            let (points, form) = args.control_points(2)?;
            let s = BSpline::new(knots, points).map_err(spline_error).at(args.span(2))?;
            Ok(spline(s, form))
        },
    },
    Builtin {
        name: "periodic_spline",
        signature: "periodic_spline(n, [t_0, ..., t_m], [d_0, ..., d_(m-1)])",
        summary: "the closed spline with knots t_0 < ... < t_m over one period and m control points",
        example: "periodic_spline(2, [0, 1, 2, 3], [[0, 0], [3, 0], [0, 3]])",
        topic: TOPIC,
        call: |_, args| {
            let signature = "periodic_spline(n, [t_0, ..., t_m], [d_0, ..., d_(m-1)])";
            args.expect(signature, 3..=3, &["weights"])?;
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
    },
    Builtin {
        name: "spline_of",
        signature: "spline_of(F, n, [t_0, ..., t_k])",
        summary: "a polynomial as a spline: control points f(t_(i+1), ..., t_(i+n)), as Marsden says",
        example: "spline_of((x - t)^2, 2, [0, 0, 0, 1, 2, 2, 2], variable=t)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("spline_of(F, n, [t_0, ..., t_k])", 3..=3, &["variable"])?;
            let given = args.univariate(0, usize::MAX)?;
            let own = given.coefficients.iter().rposition(|c| !c.is_zero()).unwrap_or(0);
            let form = crate::math::blossom::PolarForm::with_degree(&given.coefficients, own)
                .map_err(polar_error)?;
            let knots = knots_at(args, 1, 2)?;
            let s = BSpline::of_polynomial(knots, &[form]).map_err(spline_error).at(args.span(0))?;
            Ok(spline(s, Form { scalar: true, rational: false }))
        },
    },
    Builtin {
        name: "spline_from_pieces",
        signature: "spline_from_pieces(n, [t_0, ..., t_k], [c_0, c_1, ...])",
        summary: "Bézier curves over the knot intervals joined to a spline, where they fit exactly",
        example: "spline_from_pieces(1, [0, 0, 1, 2, 2], [bezier([0, 1]), bezier([1, 5], 1, 2)])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("spline_from_pieces(n, [t_0, ..., t_k], [c_0, c_1, ...])", 3..=3, &[])?;
            let knots = knots(args)?;
            let Value::List(items) = args.value(2)? else {
                return Err(wrong_kind("a list of Bézier curves", args.value(2)?).at(args.span(2)));
            };
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
    },
    Builtin {
        name: "uniform_knots",
        signature: "uniform_knots(n, m, a, h)",
        summary: "the knots a, a + h, ... for m control points of degree n (a = 0, h = 1)",
        example: "uniform_knots(3, 5)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("uniform_knots(n, m, a, h)", 2..=4, &[])?;
            let a = if args.len() > 2 { args.scalar(2)? } else { Fraction::zero() };
            let h = if args.len() > 3 { args.scalar(3)? } else { Fraction::one() };
            let knots = KnotVector::uniform(args.size(0)?, args.size(1)?, &a, &h).map_err(spline_error)?;
            Ok(scalar_list(knots.knots().iter().cloned()))
        },
    },
    Builtin {
        name: "clamped_knots",
        signature: "clamped_knots(n, [a, t_1, ..., b])",
        summary: "the same knots with both ends repeated n + 1 times",
        example: "clamped_knots(2, [0, 1, 2])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("clamped_knots(n, [a, t_1, ..., b])", 2..=2, &[])?;
            let n = args.size(0)?;
            let list = args.scalars(1)?;
            let [a, inner @ .., b] = list.as_slice() else {
                return Err(Diagnostic::error(Code::Knots, "two ends are needed")
                    .at(args.span(1))
                    .hint("such as [0, 1, 2]"));
            };
            let knots = KnotVector::clamped(n, a, inner, b).map_err(spline_error).at(args.span(1))?;
            Ok(scalar_list(knots.knots().iter().cloned()))
        },
    },
    Builtin {
        name: "greville",
        signature: "greville(n, [t_0, ..., t_k])",
        summary: "the Greville abscissae: means of n consecutive knots",
        example: "greville(3, [0, 0, 0, 0, 1, 2, 2, 2, 2])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("greville(n, [t_0, ..., t_k])", 1..=2, &[])?;
            let knots = knots_or_spline(args)?;
            Ok(scalar_list((0..knots.count()).map(|i| knots.greville(i))))
        },
    },
    Builtin {
        name: "knots",
        signature: "knots(s)",
        summary: "the knots of a spline",
        example: "knots(bspline(1, [0, 0, 1, 2, 2], [1, 3, 2]))",
        topic: TOPIC,
        call: |_, args| {
            args.expect("knots(s)", 1..=1, &[])?;
            Ok(scalar_list(args.spline(0)?.0.knots().knots().iter().cloned()))
        },
    },
    Builtin {
        name: "multiplicities",
        signature: "multiplicities(n, [t_0, ..., t_k])",
        summary: "the distinct knots with their multiplicities and the smoothness n - s they promise",
        example: "multiplicities(2, [0, 0, 0, 1, 1, 2, 2, 2])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("multiplicities(n, [t_0, ..., t_k])", 1..=2, &[])?;
            let knots = knots_or_spline(args)?;
            let mut table = Table::with_header(["knot", "multiplicity", "smoothness"]);
            for (knot, s) in knots.multiplicities() {
                let promise = Value::int(knots.degree() as i64 - s as i64);
                let row = [Value::Scalar(knot), Value::int(s as i64), promise];
                table.rows.push(row.map(Cell::Value).to_vec());
            }
            Ok(Value::Table(Arc::new(table)))
        },
    },
    Builtin {
        name: "labels",
        signature: "labels(s)",
        summary: "each control point with its polar label f(t_(i+1), ..., t_(i+n)) and Greville abscissa",
        example: "labels(bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]))",
        topic: TOPIC,
        call: |_, args| {
            args.expect("labels(s)", 1..=1, &[])?;
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
    },
    Builtin {
        name: "bspline_basis",
        signature: "bspline_basis(n, [t_0, ..., t_k], i)",
        summary: "the basis function N_i^n as a piecewise polynomial; without i, all of them",
        example: "bspline_basis(2, [0, 1, 2, 3], 0)(3/2)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("bspline_basis(n, [t_0, ..., t_k], i)", 2..=3, &["method"])?;
            let knots = knots(args)?;
            if args.len() == 3 {
                let function = knots.basis_function(args.size(2)?).map_err(spline_error).at(args.span(2))?;
                return Ok(piecewise(function));
            }
            Ok(Value::List(knots.basis_functions().into_iter().map(piecewise).collect()))
        },
    },
    Builtin {
        name: "piecewise",
        signature: "piecewise([x_0, ..., x_m], [p_1, ..., p_m], outside=0)",
        summary: "polynomials between breakpoints; with outside=0 it is 0 elsewhere",
        example: "piecewise([0, 1, 2], [t, 2 - t], outside=0)",
        topic: TOPIC,
        call: |_, args| {
            let signature = "piecewise([x_0, ..., x_m], [p_1, ..., p_m], outside=0)";
            args.expect(signature, 2..=2, &["variable", "outside", "closed"])?;
            let breaks = args.scalars(0)?;
            let formulas = args.scalars(1)?;
            let given = match args.named_or("variable", usize::MAX) {
                Some((value, span)) => {
                    Some(formula::symbol_of(value).ok_or_else(|| wrong_kind("a variable", value).at(span))?)
                }
                None => None,
            };
            let guess = || -> Result<Symbol> {
                for formula in &formulas {
                    if !formula.variables().is_empty() {
                        return formula::variable_of(formula, None).at(args.span(1));
                    }
                }
                Ok(Symbol::new("t"))
            };
            let variable = given.map_or_else(guess, Ok)?;
            let piece = |formula: &Fraction| formula::coefficients_in(formula, &variable).at(args.span(1));
            let pieces = formulas.iter().map(piece).collect::<Result<Vec<_>>>()?;
            let outside = match args.named_or("outside", usize::MAX) {
                None => Outside::Undefined,
                Some((value, _)) if value.as_int() == Some(0) => Outside::Zero,
                Some((value, span)) => {
                    return Err(wrong_kind("0", value).at(span).hint("outside=0, or leave it out"));
                }
            };
            let function =
                Piecewise::new(breaks, pieces, outside).map_err(piecewise_error).at(args.span(0))?;
            let open =
                args.named_or("closed", usize::MAX).is_some_and(|(value, _)| value.as_int() == Some(0));
            let function = if open { function.half_open() } else { function };
            Ok(Value::Piecewise(Arc::new(PiecewiseFunction { function, variable })))
        },
    },
    Builtin {
        name: "deboor",
        signature: "deboor(s, u_1, ..., u_n, span=j)",
        summary: "de Boor's scheme with polar labels, for one parameter or for n of them",
        example: "deboor(bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]), 1/2)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("deboor(s, u_1, ..., u_n, span=j)", 2..=usize::MAX, &["span"])?;
            let (s, form) = args.spline(0)?;
            let (scheme, _) = de_boor(args, &s)?;
            Ok(super::curves::scheme(&scheme.tableau, &scheme.ratios, form))
        },
    },
    Builtin {
        name: "insert_knots",
        signature: "insert_knots(s, t_1, ..., t_k)",
        summary: "the same curve with these knots added; span=j names the interval of a symbol",
        example: "insert_knots(bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]), 1/2, 1/2)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("insert_knots(s, t_1, ..., t_k, span=j)", 2..=usize::MAX, &["span"])?;
            let (s, form) = args.spline(0)?;
            if let Some(j) = args.named_size("span", usize::MAX)? {
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
    },
    Builtin {
        name: "insertion_ratios",
        signature: "insertion_ratios(n, [t_0, ..., t_k], t, span=j)",
        summary: "the ratios (t - t_i)/(t_(i+n) - t_i) by which inserting t mixes d_(i-1) and d_i",
        example: "insertion_ratios(2, [t_0, t_1, t_2, t_3, t_4, t_5], t, span=2)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("insertion_ratios(n, [t_0, ..., t_k], t, span=j)", 3..=3, &["span"])?;
            let knots = knots(args)?;
            let t = args.scalar(2)?;
            let j = match args.named_size("span", usize::MAX)? {
                Some(j) => j,
                None => knots.span_of(&t).map_err(spline_error).at(args.span(2))?,
            };
            let mut table = Table::with_header(["i", "ratio"]);
            for (i, ratio) in knots.insertion_ratios(j, &t).map_err(spline_error)? {
                table.rows.push(vec![Cell::Value(Value::int(i as i64)), Cell::Value(Value::Scalar(ratio))]);
            }
            Ok(Value::Table(Arc::new(table)))
        },
    },
    Builtin {
        name: "refine",
        signature: "refine(s, [t_0, ..., t_k])",
        summary: "the same curve over finer knots (the Oslo algorithm)",
        example: "refine(bspline(1, [0, 0, 2, 2], [1, 5]), [0, 0, 1, 2, 2])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("refine(s, [t_0, ..., t_k])", 2..=2, &[])?;
            let (s, form) = args.spline(0)?;
            let finer =
                KnotVector::new(s.degree(), args.scalars(1)?).map_err(spline_error).at(args.span(1))?;
            s.refine(finer).map(|s| spline(s, form)).map_err(spline_error).at(args.span(1))
        },
    },
    Builtin {
        name: "remove_knot",
        signature: "remove_knot(s, t, times=k)",
        summary: "the same curve with an inner knot removed, where that is exact",
        example: "remove_knot(insert_knots(bspline(2, [0, 0, 0, 2, 2, 2], [1, 3, 2]), 1), 1)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("remove_knot(s, t, times=k)", 2..=2, &["times"])?;
            let (s, form) = args.spline(0)?;
            let times = args.named_size("times", usize::MAX)?.unwrap_or(1);
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
    },
    Builtin {
        name: "pieces",
        signature: "pieces(s)",
        summary: "the Bézier curves of a spline, or the polynomials of a piecewise one",
        example: "pieces(bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]))",
        topic: TOPIC,
        call: |_, args| {
            args.expect("pieces(s)", 1..=1, &[])?;
            if let Value::Piecewise(function) = args.value(0)? {
                return Ok(scalar_list(function.formulas()));
            }
            let (s, form) = args.spline(0)?;
            Ok(Value::List(s.bezier_pieces().into_iter().map(|piece| bezier(piece, form)).collect()))
        },
    },
    Builtin {
        name: "power_pieces",
        signature: "power_pieces(s)",
        summary: "a spline as a piecewise polynomial in t, one for each coordinate",
        example: "power_pieces(bspline(1, [0, 0, 1, 2, 2], [1, 3, 2]))",
        topic: TOPIC,
        call: |_, args| {
            args.expect("power_pieces(s)", 1..=1, &[])?;
            let (s, form) = args.spline(0)?;
            if form.rational {
                return Err(Diagnostic::error(Code::NotPolynomial, "this spline is rational")
                    .at(args.span(0))
                    .hint("homogeneous(s) is the polynomial spline of its homogeneous coordinates"));
            }
            let mut list: Vec<Value> = s.power_pieces().into_iter().map(piecewise).collect();
            Ok(if form.scalar { list.swap_remove(0) } else { Value::List(list) })
        },
    },
    Builtin {
        name: "smoothness",
        signature: "smoothness(s)",
        summary: "for each inner knot: its multiplicity and how smooth the curve is there",
        example: "smoothness(bspline(2, [0, 0, 0, 1, 1, 2, 2, 2], [1, 3, 5, 7, 4]))",
        topic: TOPIC,
        call: |_, args| {
            args.expect("smoothness(s)", 1..=1, &[])?;
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
    },
    Builtin {
        name: "spline_to_bezier",
        signature: "spline_to_bezier(n, [t_0, ..., t_k])",
        summary: "the matrix from control points to the Bézier points of all pieces",
        example: "spline_to_bezier(2, [0, 0, 0, 1, 2, 2, 2])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("spline_to_bezier(n, [t_0, ..., t_k])", 2..=2, &[])?;
            knots(args)?.to_bezier_matrix().map(Value::Matrix).map_err(spline_error).at(args.span(1))
        },
    },
    Builtin {
        name: "spline_to_power",
        signature: "spline_to_power(n, [t_0, ..., t_k], j)",
        summary: "the matrix from the n + 1 control points of interval j to power coefficients in t",
        example: "spline_to_power(3, uniform_knots(3, 4, -3), 3)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("spline_to_power(n, [t_0, ..., t_k], j)", 3..=3, &[])?;
            knots(args)?.power_matrix(args.size(2)?).map(Value::Matrix).map_err(spline_error).at(args.span(2))
        },
    },
];

fn piecewise(function: Piecewise<Fraction>) -> Value {
    Value::Piecewise(Arc::new(PiecewiseFunction { function, variable: Symbol::new("t") }))
}

/// Degree and knots at the first two places.
pub(super) fn knots(args: &Arguments) -> Result<KnotVector<Fraction>> {
    knots_at(args, 0, 1)
}

fn knots_at(args: &Arguments, degree: usize, list: usize) -> Result<KnotVector<Fraction>> {
    KnotVector::new(args.size(degree)?, args.scalars(list)?).map_err(spline_error).at(args.span(list))
}

fn knots_or_spline(args: &Arguments) -> Result<KnotVector<Fraction>> {
    if args.len() == 1 { Ok(args.spline(0)?.0.knots().clone()) } else { knots(args) }
}

/// The knot interval nearest to a parameter.
pub(super) fn nearest_piece(s: &BSpline<Fraction>, t: &Fraction) -> Result<usize> {
    use std::cmp::Ordering;
    let spans = s.knots().spans();
    match s.knots().span_of(t) {
        Ok(span) => Ok(span),
        Err(crate::math::spline::SplineError::OutsideDomain) => {
            let before = crate::math::piecewise::compare(t, s.domain().0) == Some(Ordering::Less);
            Ok(if before { spans[0] } else { spans[spans.len() - 1] })
        }
        Err(error) => Err(spline_error(error)),
    }
}

/// The scheme asked for by (s, u…, span=j), and its arguments.
pub(super) fn de_boor(args: &Arguments, s: &BSpline<Fraction>) -> Result<(DeBoor<Fraction>, Vec<Fraction>)> {
    let mut list = args.scalars_from(1)?;
    let span = match args.named_size("span", usize::MAX)? {
        Some(span) => span,
        None => s.knots().span_of(&list[0]).map_err(spline_error).at(args.span(1))?,
    };
    list = super::curves::repeated(list, s.degree());
    let scheme = s.de_boor(span, &list).map_err(spline_error).at(args.span(1))?;
    Ok((scheme, list))
}
