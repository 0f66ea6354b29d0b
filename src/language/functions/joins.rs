//! How curves meet, and one function for changes of representation.

use super::gives::Gives;
use crate::language::eval::Arguments;
use crate::language::ops::errors::{curve_error, linalg_error, wrong_kind};
use crate::language::ops::formula;
use crate::language::ops::geometry::{as_rational_form, as_rational_spline, bezier, joined, spline};
use std::sync::Arc;

use super::matrices::basis_error;
use super::notions::{BASIS, read_basis};
use super::parameter::{CURVE, FIRST_CURVE, Parameter, SECOND_CURVE, named, optional, required};
use super::{Builtin, solve, surface_joins};
use crate::formula::{Accent, Expr, Kind};
use crate::language::derive::polar_label;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::takes::{Takes, word_of};
use crate::language::value::{Cell, Form, Geometry, Table, Value, collected, polynomial_expr};
use crate::math::basis::{Basis, change_of_basis};
use crate::math::curve::{self, BezierCurve, Interval, Point};
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Ring;

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Continuity and conversion");

/// The representations of a curve that a word names.
const FORMS: &[&str] = &["bezier", "bspline", "power", "polar", "pieces"];

/// For which symbols conditions are solved.
pub(super) const UNKNOWNS: Parameter = named(
    "unknowns=[x, ...]",
    Takes::OneOf(&[Takes::Variable, Takes::Variables]),
    "the conditions as a table",
    "the symbols for which the conditions are solved",
);

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "joining_conditions",
        parameters: &[FIRST_CURVE, SECOND_CURVE, optional("k", Takes::Size, "1", "the order"), UNKNOWNS],
        summary: "what the control points of d have to be for c and d to meet C^k (k = 1 if not given)",
        gives: Gives::Any,
        example: "joining_conditions(bezier([b_0, b_1, b_2]), bezier([c_0, c_1, c_2], 1, 2), 2)",
        on_surface: surface_joins::JOINING_CONDITIONS,
        call: |machine, args| {
            let ((f, left), (g, right)) = (args.bezier(0)?, args.bezier(1)?);
            let k = args.size(2)?;
            let form = polynomial_pair(args, left, right)?;
            let conditions = curve::joining_conditions(&f, &g, k).map_err(curve_error).at(args.span(1))?;
            if let Some((unknowns, span)) = args.named("unknowns") {
                let pairs = conditions.iter().flat_map(|c| c.found.iter().zip(&c.required));
                return solve::equal(machine, args, pairs, unknowns, span);
            }
            let mut table = Table::with_header(["order", "polar value", "required", "found", "holds"]);
            for condition in conditions {
                let holds = holds_word(&condition.required, &condition.found);
                table.rows.push(vec![
                    Cell::Value(Value::int(condition.order as i64)),
                    Cell::Formula(polar_label(&condition.label)),
                    collected_cell(form, condition.required, f.points()),
                    Cell::Value(form.plain(condition.found)),
                    Cell::words(holds),
                ]);
            }
            Ok(Value::Table(Arc::new(table)))
        },
        ..NEW
    },
    Builtin {
        name: "continuation",
        parameters: &[
            CURVE,
            optional("k", Takes::Size, "1", "the order"),
            optional(
                "end",
                Takes::Scalar,
                "an interval as long as that of the curve",
                "the end of the next interval",
            ),
        ],
        summary: "the first k + 1 control points of a curve of its degree that joins its end C^k",
        gives: Gives::Points,
        example: "continuation(bezier([0, 1, 3, 4]), 2)",
        call: |_, args| {
            let (curve, form) = args.bezier(0)?;
            if form.rational {
                return Err(Diagnostic::error(Code::NotPolynomial, "this curve is rational, not polynomial")
                    .at(args.span(0))
                    .hint("homogeneous(c) is the polynomial curve of its homogeneous coordinates"));
            }
            let k = args.size(1)?;
            if k > curve.degree() {
                let message =
                    format!("a curve of degree {} has {} control points", curve.degree(), curve.degree() + 1);
                return Err(Diagnostic::error(Code::Domain, message)
                    .at(args.span(1))
                    .hint(format!("choose an order of at most {}", curve.degree())));
            }
            let (start, b) = curve.interval().ends();
            let end = args.optional_scalar(2)?.unwrap_or_else(|| b.plus(&b.minus(start)));
            let place = if args.given(2).is_some() { args.span(2) } else { args.span(0) };
            let next = curve.part(Interval::new(b.clone(), end).map_err(curve_error).at(place)?);
            Ok(Value::list(next.points().iter().take(k + 1).map(|point| form.plain(point.clone())).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "continuity",
        parameters: &[
            FIRST_CURVE,
            SECOND_CURVE,
            optional("at", Takes::Scalar, "the common end", "where they meet").shown("at=t"),
        ],
        summary: "up to which order two curves agree at t, and the first polar values that differ",
        gives: Gives::Table,
        example: "continuity(bezier([0, 1, 2]), bezier([2, 3, 5], 1, 2))",
        on_surface: surface_joins::CONTINUITY,
        call: |_, args| {
            let ((f, left), (g, right)) = (args.bezier(0)?, args.bezier(1)?);
            let form = polynomial_pair(args, left, right)?;
            let t = match args.given(2) {
                Some((Value::Scalar(t), _)) => t.clone(),
                Some((other, span)) => return Err(wrong_kind("a number or symbol", other).at(span)),
                None if f.interval().end() == g.interval().start() => g.interval().start().clone(),
                None => {
                    return Err(Diagnostic::error(
                        Code::Domain,
                        "the curves have no common end; where do they meet?",
                    )
                    .at(args.span(1))
                    .hint("name the parameter: continuity(c, d, at=1)"));
                }
            };
            let report = curve::continuity_at(&f, &g, &t).map_err(curve_error).at(args.span(1))?;
            let mut table = Table::with_header(["continuity", "order", "polar value", "left", "right"]);
            let mut row = vec![match report.order {
                _ if report.same => Cell::words("one polynomial"),
                order => class("C", order),
            }];
            if let Some((order, p, q)) = report.failure {
                let n = f.degree().max(g.degree());
                let mut arguments = vec![polynomial_expr(&t); n - order];
                let hat: Expr = Kind::Accent(Accent::Hat, Box::new(Expr::int(1))).into();
                arguments.extend(vec![hat; order]);
                let label = if arguments.is_empty() {
                    Expr::name("f")
                } else {
                    Expr::apply(Expr::name("f"), arguments)
                };
                row.extend([
                    Cell::Value(Value::int(order as i64)),
                    Cell::Formula(label),
                    Cell::Value(form.plain(p.coordinates())),
                    Cell::Value(form.plain(q.coordinates())),
                ]);
            } else {
                table.header.truncate(1);
            }
            table.rows.push(row);
            Ok(Value::Table(Arc::new(table)))
        },
        ..NEW
    },
];

pub(super) const CONVERSIONS: &[Builtin] = &[
    Builtin {
        name: "homogeneous",
        parameters: &[CURVE],
        summary: "the polynomial curve of the homogeneous coordinates of a rational one, weight last",
        gives: Gives::SameCurve,
        example: "homogeneous(bezier([0, 1, 2], weights=[1, 2, 1]))",
        call: |_, args| {
            Ok(match &*args.geometry(0)? {
                Geometry::Bezier(curve, form) => bezier(as_rational_form(curve, *form), Form::default()),
                Geometry::Spline(s, form) => spline(as_rational_spline(s, *form), Form::default()),
                _ => return Err(wrong_kind("a curve", args.value(0)?).at(args.span(0))),
            })
        },
        on_surface: surface_joins::HOMOGENEOUS,
        ..NEW
    },
    Builtin {
        name: "convert",
        parameters: &[
            required(
                "c",
                Takes::OneOf(&[Takes::Curve, Takes::List]),
                "the curve, spline or piecewise polynomial",
            ),
            required("to", Takes::OneOf(&[Takes::Word(FORMS), BASIS]), "the representation"),
        ],
        summary: "a curve as: bezier, bspline, power, polar, pieces, hermite or [lagrange, t_0, ...]",
        gives: Gives::Any,
        example: "convert(bspline(2, [0, 0, 0, 1, 1, 1], [1, 3, 2]), bezier)",
        on_surface: surface_joins::CONVERT,
        call: |_, args| convert(args),
        ..NEW
    },
];

/// A point that is a combination of symbolic points, written as one; any other as it is.
pub(super) fn collected_cell(form: Form, point: impl Into<Vec<Fraction>>, of: &[Point<Fraction>]) -> Cell {
    let point = point.into();
    let symbols: Option<Vec<Symbol>> = of
        .iter()
        .map(|point| match &point[..] {
            [x] => formula::symbol_of(&Value::Scalar(x.clone())),
            _ => None,
        })
        .collect();
    match symbols.and_then(|symbols| collected(&point[0], &symbols)) {
        Some(formula) => Cell::Formula(formula),
        None => Cell::Value(form.plain(point)),
    }
}

/// Whether two points are equal: open, if that depends on symbols.
pub(super) fn holds_word(required: &[Fraction], found: &[Fraction]) -> &'static str {
    use num_traits::Zero;
    let differences: Vec<Fraction> = required.iter().zip(found).map(|(x, y)| x.clone() - y.clone()).collect();
    if differences.iter().all(Zero::is_zero) {
        "yes"
    } else if differences.iter().any(|d| d.as_rational().is_some_and(|q| !q.is_zero())) {
        "no"
    } else {
        "open"
    }
}

/// C^k or G^k; words for a jump.
pub(super) fn class(letter: &str, order: Option<usize>) -> Cell {
    match order {
        Some(k) => Cell::Formula(Expr::name(letter).power(Expr::int(k as i64))),
        None => Cell::words("none"),
    }
}

/// Both curves have to be polynomial.
pub(super) fn polynomial_pair(args: &Arguments, left: Form, right: Form) -> Result<Form> {
    for (i, form) in [left, right].into_iter().enumerate() {
        if form.rational {
            return Err(Diagnostic::error(Code::NotPolynomial, "this curve is rational")
                .at(args.span(i))
                .hint("homogeneous(c) is the polynomial curve of its homogeneous coordinates"));
        }
    }
    Ok(Form { scalar: left.scalar && right.scalar, rational: false })
}

fn convert(args: &Arguments) -> Result<Value> {
    let target = args.value(1)?;
    let word = match target {
        Value::List(items) => items.first().and_then(word_of),
        single => word_of(single),
    };
    let word = word.unwrap_or_default();
    // A Bézier curve also from a spline that is one polynomial.
    let single = || -> Result<(BezierCurve<Fraction>, Form)> {
        let piecewise = matches!(args.value(0)?, Value::Piecewise(_))
            || matches!(args.value(0)?, Value::List(items) if matches!(items.first(), Some(Value::Piecewise(_))));
        if piecewise
            || matches!(args.value(0)?, Value::Geometry(geometry) if matches!(**geometry, Geometry::Spline(..)))
        {
            let (s, form) = &args.spline(0)?;
            let pieces = s.bezier_pieces();
            let whole = pieces[0].part(s.interval().clone());
            for (i, piece) in pieces.iter().enumerate() {
                if &whole.part(piece.interval().clone()) != piece {
                    return Err(Diagnostic::error(
                        Code::NotReducible,
                        format!("piece {i} is another polynomial than piece 0"),
                    )
                    .at(args.span(0))
                    .hint("pieces(s) are the Bézier curves of the spline, one for each interval"));
                }
            }
            return Ok((whole, *form));
        }
        args.bezier(0)
    };
    match word {
        "bezier" => single().map(|(curve, form)| bezier(curve, form)),
        "bspline" => {
            if let Value::List(items) = args.value(0)?
                && items.iter().all(|item| matches!(item, Value::Geometry(_)))
                && !items.is_empty()
            {
                let curves =
                    items.iter().map(|item| args.with_first(item.clone()).bezier(0).at(args.span(0)));
                let curves = curves.collect::<Result<Vec<_>>>()?;
                let form = curves[0].1;
                let pieces: Vec<_> = curves.into_iter().map(|(curve, _)| curve).collect();
                return joined(&pieces).map(|s| spline(s, form)).at(args.span(0));
            }
            args.spline(0).map(|(s, form)| spline(s, form))
        }
        "polar" => {
            let (curve, form) = single()?;
            let args = args.with_first(bezier(curve, form)).only(1);
            super::on_geometry::polar(&args)
        }
        "power" => {
            let (curve, form) = single()?;
            let args = args.with_first(bezier(curve, form)).only(1);
            super::on_geometry::coefficients(&args)
        }
        "pieces" => {
            let (s, form) = args.spline(0)?;
            Ok(Value::List(s.bezier_pieces().into_iter().map(|piece| bezier(piece, form)).collect()))
        }
        "lagrange" | "newton" | "hermite" | "taylor" | "bernstein" => {
            let (curve, form) = single()?;
            polynomial_pair(args, form, form)?;
            let target = match (word, target) {
                ("hermite", Value::Text(_) | Value::Builtin(_)) => {
                    let (a, b) = curve.interval().ends();
                    Value::list(vec![target.clone(), Value::Scalar(a.clone()), Value::Scalar(b.clone())])
                }
                _ => target.clone(),
            };
            crate::budget::charge_terms((curve.degree() as u64 + 1).saturating_pow(2));
            let basis = read_basis(&target, args.span(1))?;
            let matrix = change_of_basis(curve.degree(), &Basis::Power, &basis).map_err(basis_error)?;
            let mut rows = Vec::with_capacity(curve.dimension());
            for column in curve.power() {
                let column = nalgebra::DMatrix::from_vec(column.len(), 1, column);
                let product = crate::math::linalg::multiply(&matrix, &column).map_err(linalg_error)?;
                rows.push(Value::List(product.iter().cloned().map(Value::Scalar).collect()));
            }
            Ok(if form.scalar { rows.swap_remove(0) } else { Value::list(rows) })
        }
        _ => Err(wrong_kind("a representation", target).at(args.span(1)).hint(
            "bezier, bspline, power, polar, pieces, hermite, [lagrange, t_0, ...] or [newton, t_0, ...]",
        )),
    }
}
