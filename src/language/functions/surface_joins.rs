//! How surfaces meet, and surfaces in other representations.

use super::gives::Gives;
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::{curve_error, spline_error};
use std::sync::Arc;

use super::on_surface::{direction, net_value, not_for, pieces, polar};
use super::parameter::{Parameter, SURFACE, named, optional, required};
use super::record::Variant;
use super::surfaces::{polynomial_only, surface, tensor, triangular};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::takes::{Takes, word_of};
use crate::language::value::{Cell, Form, Geometry, Table, Value};
use crate::math::curve::{Direction, EdgeEquation, Point, TensorPatch, TrianglePatch};
use crate::math::poly::Fraction;
use crate::math::spline::SplineSurface;

/// A second surface.
const SECOND: Parameter = required("second", Takes::Surface, "the other surface").shown("r");

const ACROSS: Parameter =
    named("across=u", Takes::Word(&["u", "v"]), "the one that fits", "the direction across the common edge");

pub(super) const JOINING_CONDITIONS: Option<Variant> = Variant::new(
    &[SURFACE, SECOND, optional("k", Takes::Size, "1", "the order"), ACROSS],
    Gives::Any,
    joining_conditions,
);

pub(super) const CONTINUITY: Option<Variant> =
    Variant::new(&[SURFACE, SECOND, ACROSS], Gives::Table, continuity);

pub(super) const HOMOGENEOUS: Option<Variant> = Variant::new(&[SURFACE], Gives::Surface, homogeneous);

pub(super) const CONVERT: Option<Variant> = Variant::new(
    &[
        SURFACE,
        required(
            "to",
            Takes::Word(&["triangle", "tensor", "degenerate", "polar", "pieces", "bspline", "power"]),
            "the representation",
        ),
        optional(
            "domain",
            Takes::OneOf(&[Takes::Interval, Takes::Triangle]),
            "the unit square or triangle",
            "the triangle, or the interval of u",
        ),
        optional("second", Takes::Interval, "[0, 1]", "the interval of v").shown("domain"),
    ],
    Gives::Any,
    convert,
);

/// The equations for two patches to join, as far as asked.
fn equations(args: &Arguments, k: usize) -> Result<(Vec<EdgeEquation<Fraction>>, Form), Diagnostic> {
    let (first, second) = (args.geometry(0)?, args.geometry(1)?);
    polynomial_only(first.form(), args)?;
    let equations = match (&*first, &*second) {
        (Geometry::Patch(f, _), Geometry::Patch(g, _)) => match direction(args, "across")? {
            Some(across) => f.join_conditions(g, across, k),
            None => f.join_conditions(g, Direction::U, k).or_else(|_| f.join_conditions(g, Direction::V, k)),
        },
        (Geometry::Triangle(f, _), Geometry::Triangle(g, _)) => f.join_conditions(g, k),
        (_, other) => {
            return Err(Diagnostic::error(
                Code::Type,
                format!("{} and {} are not joined", first.kind(), other.kind()),
            )
            .at(args.span(1))
            .hint(
                "two patches of one kind are; convert(s, tensor) and convert(s, triangle) change the kind",
            ));
        }
    };
    Ok((equations.map_err(curve_error).at(args.span(1))?, first.form()))
}

fn equation_row(equation: &EdgeEquation<Fraction>, form: Form) -> Vec<Cell> {
    vec![
        Cell::Value(Value::int(equation.order as i64)),
        Cell::Value(Value::int(equation.place as i64)),
        Cell::Value(form.plain(equation.required.clone())),
        Cell::Value(form.plain(equation.found.clone())),
        Cell::words(super::joins::holds_word(&equation.required, &equation.found)),
    ]
}

fn joining_conditions(args: &Arguments) -> Evaluated {
    let k = args.size(2)?;
    let (equations, form) = equations(args, k)?;
    let mut table = Table::with_header(["order", "place", "required", "found", "holds"]);
    table.rows = equations.iter().map(|equation| equation_row(equation, form)).collect();
    Ok(Value::Table(Arc::new(table)))
}

/// The largest order up to which two patches join.
fn continuity(args: &Arguments) -> Evaluated {
    let highest = match &*args.geometry(0)? {
        Geometry::Patch(patch, _) => patch.degrees().0.max(patch.degrees().1),
        Geometry::Triangle(patch, _) => patch.degree(),
        other => return Err(not_for(other, args)),
    };
    let (equations, form) = equations(args, highest)?;
    let mut table = Table::with_header(["continuity", "order", "place", "required", "found", "holds"]);
    match equations.iter().find(|equation| !equation.holds()) {
        None => {
            table.header.truncate(1);
            table.rows.push(vec![Cell::words("one polynomial")]);
        }
        Some(equation) => {
            let mut row = vec![super::joins::class("C", equation.order.checked_sub(1))];
            row.extend(equation_row(equation, form));
            table.rows.push(row);
        }
    }
    Ok(Value::Table(Arc::new(table)))
}

fn convert(args: &Arguments) -> Evaluated {
    let target = args.value(1)?;
    // The domains stand after the word.
    match (&*args.geometry(0)?, word_of(target).unwrap_or_default()) {
        (Geometry::Patch(patch, form), "triangle") => {
            polynomial_only(*form, args)?;
            patch.to_triangle(args.triangle(2)?).map(|p| triangular(p, *form)).map_err(curve_error).at(args.span(0))
        }
        (Geometry::Triangle(patch, form), "tensor") => {
            polynomial_only(*form, args)?;
            Ok(tensor(patch.to_tensor(args.interval(2)?, args.interval(3)?), *form))
        }
        (Geometry::Triangle(patch, form), "degenerate") => Ok(tensor(patch.to_degenerate_tensor(), *form)),
        (Geometry::Patch(..) | Geometry::Triangle(..), "polar") => polar(&args.only(1)),
        (Geometry::Surface(..), "pieces") => pieces(&args.only(1)),
        (Geometry::Patch(patch, form), "bspline") => {
            let knots = |interval: &crate::math::curve::Interval<Fraction>, n: usize| {
                crate::math::spline::KnotVector::clamped(n, &[], interval).map_err(spline_error)
            };
            let (m, n) = patch.degrees();
            let (u, v) = (knots(patch.u(), m)?, knots(patch.v(), n)?);
            crate::math::spline::SplineSurface::new(u, v, patch.net().to_vec()).map(|s| surface(s, *form)).map_err(spline_error)
        }
        (Geometry::Patch(patch, form), "power") => {
            polynomial_only(*form, args)?;
            Ok(net_value(&patch.power_coefficients(), *form))
        }
        (geometry, _) => Err(Diagnostic::error(Code::Type, format!("{} has no such representation", geometry.kind()))
            .at(args.span(1))
            .hint("patches: triangle, polar, power, bspline; triangular ones: tensor, degenerate, polar; spline surfaces: pieces")),
    }
}

/// The surface of the homogeneous coordinates, the weight last.
fn homogeneous(args: &Arguments) -> Evaluated {
    let geometry = args.geometry(0)?;
    let rational = geometry.form().rational;
    let lifted = |point: &Point<Fraction>| -> Point<Fraction> {
        let weight = (!rational).then(|| Fraction::from(crate::math::number::integer(1)));
        point.iter().cloned().chain(weight).collect()
    };
    let net = |net: &[Vec<Point<Fraction>>]| -> Vec<Vec<Point<Fraction>>> {
        net.iter().map(|row| row.iter().map(lifted).collect()).collect()
    };
    let form = Form::default();
    match &*geometry {
        Geometry::Patch(patch, _) => {
            let lifted = TensorPatch::new(net(patch.net()), patch.u().clone(), patch.v().clone());
            lifted.map(|patch| tensor(patch, form)).map_err(curve_error).at(args.span(0))
        }
        Geometry::Triangle(patch, _) => {
            let points = patch.points().iter().map(lifted).collect();
            let lifted = TrianglePatch::new(points, patch.triangle().clone());
            lifted.map(|patch| triangular(patch, form)).map_err(curve_error).at(args.span(0))
        }
        Geometry::Surface(s, _) => {
            let (u, v) = s.knots();
            let lifted = SplineSurface::new(u.clone(), v.clone(), net(s.net()));
            lifted.map(|s| surface(s, form)).map_err(spline_error).at(args.span(0))
        }
        other => Err(not_for(other, args)),
    }
}
