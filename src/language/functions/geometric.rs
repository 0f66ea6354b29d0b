//! Geometric continuity: the β-matrix, and how two curves meet after a change of parameter.

use super::gives::Gives;
use std::sync::Arc;

use super::joins::{UNKNOWNS, class, collected_cell, polynomial_pair};
use super::parameter::{FIRST_CURVE, SECOND_CURVE, optional, size};
use super::{Builtin, solve};
use crate::language::diagnostic::At;
use crate::language::eval::{Arguments, Evaluated, Machine};
use crate::language::ops::errors::curve_error;
use crate::language::ops::takes::Takes;
use crate::language::value::{Cell, Form, Table, Value, symbol_expr};
use crate::math::curve::{self, BezierCurve, CurveError, GeometricFailure, Interval, Point};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Symbol};

const NEW: Builtin = Builtin::about("Continuity and conversion");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "geometric_continuity",
        parameters: &[
            FIRST_CURVE,
            SECOND_CURVE,
            optional("k", Takes::Size, "2", "the highest order that is looked at"),
            UNKNOWNS,
        ],
        summary: "up to which G^k two curves meet, with the change of parameter beta_1, ..., beta_k",
        gives: Gives::Any,
        example: "geometric_continuity(bezier([[0, 0], [1, 0]]), bezier([[1, 0], [3, 0]]))",
        call: geometric_continuity,
        ..NEW
    },
    Builtin {
        name: "connection_matrix",
        parameters: &[size("k", "the order")],
        summary: "the matrix from the derivatives of F to those of G for G^k, in beta_1, ..., beta_k",
        gives: Gives::Matrix,
        example: "connection_matrix(3)",
        call: |_, args| Ok(Value::Matrix(curve::beta_matrix(&betas(args.size(0)?)))),
        ..NEW
    },
];

fn beta(i: usize) -> Symbol {
    Symbol::indexed("beta", i as i64)
}

fn betas(k: usize) -> Vec<Fraction> {
    crate::budget::charge_terms(k as u64);
    (1..=k).map(|i| Fraction::from(MultiPoly::symbol(beta(i)))).collect()
}

fn geometric_continuity(machine: &mut Machine, args: &Arguments) -> Evaluated {
    let ((f, left), (g, right)) = (args.bezier(0)?, args.bezier(1)?);
    let form = polynomial_pair(args, left, right)?;
    let k = args.size(2)?;
    crate::budget::charge_terms((k as u64).saturating_mul(k as u64));
    let (Some(numbers), Some(others), None) = (numeric(&f), numeric(&g), args.named("unknowns")) else {
        return conditions(machine, args, (&f, &g), form, k);
    };
    let report = curve::geometric_continuity(&numbers, &others, k).map_err(curve_error).at(args.span(1))?;
    let mut table = Table::with_header(["continuity"]);
    let mut row = vec![class("G", report.order)];
    // Two columns at least, as the shortest report has.
    for i in 1..=k.max(2) {
        table.header.push(symbol_expr(&beta(i)));
        row.push(report.betas.get(i - 1).map_or(Cell::Empty, |q| Cell::Value(Value::number(q.clone()))));
    }
    table.header.extend(Table::with_header(["why not more"]).header);
    row.push(Cell::words(match report.failure {
        None => "higher orders are not examined",
        Some(GeometricFailure::PointsDiffer) => "the points differ",
        Some(GeometricFailure::NotRegular) => "a derivative is zero there",
        Some(GeometricFailure::TangentsDiffer) => "the tangents differ",
        Some(GeometricFailure::Opposite) => "the tangents are opposite: a cusp",
        Some(GeometricFailure::CurvaturesDiffer) => "the curvatures differ",
        Some(GeometricFailure::HigherDiffer) => "no change of parameter fits the next derivatives",
    }));
    table.rows.push(row);
    Ok(Value::Table(Arc::new(table)))
}

/// The curve over the numbers, if it has no symbols.
pub(super) fn numeric(curve: &BezierCurve<Fraction>) -> Option<BezierCurve<Rational>> {
    let point = |point: &Point<Fraction>| point.iter().map(Fraction::as_rational).collect();
    let points: Option<Vec<Point<Rational>>> = curve.points().iter().map(point).collect();
    let (a, b) = curve.interval().ends();
    let interval = Interval::new(a.as_rational()?, b.as_rational()?).ok()?;
    BezierCurve::new(points?, interval).ok()
}

/// What the derivatives of d have to be for G^k: the β-matrix times those of c; solved for unknowns, if some are named.
fn conditions(
    machine: &mut Machine,
    args: &Arguments,
    (f, g): (&BezierCurve<Fraction>, &BezierCurve<Fraction>),
    form: Form,
    k: usize,
) -> Evaluated {
    if f.dimension() != g.dimension() {
        let error = CurveError::DimensionsOf { left: f.dimension(), right: g.dimension() };
        return Err(curve_error(error).at(args.span(1)));
    }
    let left = curve::jet(f, f.interval().end(), k);
    let right = curve::jet(g, g.interval().start(), k);
    let needed = curve::transferred(&left, &betas(k));
    if let Some((unknowns, span)) = args.named("unknowns") {
        let pairs = right.iter().zip(&needed).flat_map(|(x, y)| x.iter().zip(y.iter()));
        return solve::equal(machine, args, pairs, unknowns, span);
    }
    let mut table = Table::with_header(["order", "required", "found"]);
    for (order, (required, found)) in needed.into_iter().zip(right).enumerate() {
        table.rows.push(vec![
            Cell::Value(Value::int(order as i64)),
            collected_cell(form, required, f.points()),
            collected_cell(form, found, g.points()),
        ]);
    }
    Ok(Value::Table(Arc::new(table)))
}
