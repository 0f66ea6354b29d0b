//! De Boor's scheme for surfaces, and their equations.

use super::gives::Gives;
use std::sync::Arc;

use super::on_surface::{net_value, not_for};
use super::parameter::{SURFACE, required};
use super::record::Variant;
use super::{Builtin, solve};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::{spline_error, wrong_kind};
use crate::language::ops::takes::Takes;
use crate::language::value::{Cell, Geometry, Table, Value};
use crate::math::curve::{Point, surface_equation};
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::spline::BSpline;

pub(super) const DEBOOR: Option<Variant> = Variant::new(
    &[
        SURFACE,
        required("u", Takes::Scalar, "the first parameter"),
        required("v", Takes::Scalar, "the second parameter"),
    ],
    Gives::Table,
    de_boor,
);

pub(super) const TABLE: &[Builtin] = &[Builtin {
    name: "implicit_surface",
    parameters: &[required(
        "surface",
        Takes::OneOf(&[Takes::Surface, Takes::Coordinates]),
        "a patch, or three coordinates as formulas in u and v",
    )
    .shown("s")],
    summary: "the polynomial in x, y and z that is 0 on a surface of low degree, also a rational one",
    gives: Gives::Scalar,
    example: "implicit_surface([u, v, u v])",
    call: |_, args| equation(args),
    ..Builtin::about("Intersections")
}];

/// First m levels in u for the columns that matter, then n levels in v.
fn de_boor(args: &Arguments) -> Evaluated {
    let geometry = args.geometry(0)?;
    let Geometry::Surface(s, form) = &*geometry else { return Err(not_for(&geometry, args)) };
    let (u, v) = (args.scalar(1)?, args.scalar(2)?);
    let (in_u, in_v) = s.knots();
    let span = |knots: &crate::math::spline::KnotVector<Fraction>, t: &Fraction, i: usize| {
        knots.span_of(t).map_err(spline_error).at(args.span(i))
    };
    let (at_u, at_v) = (span(in_u, &u, 1)?, span(in_v, &v, 2)?);
    let (m, n) = (in_u.degree(), in_v.degree());
    let columns = s.transposed();
    let mut schemes = Vec::with_capacity(columns.net().len());
    for column in columns.net() {
        let curve = BSpline::new(in_u.clone(), column.clone()).map_err(spline_error)?;
        schemes.push(curve.de_boor(at_u, &vec![u.clone(); m]).map_err(spline_error)?.tableau);
    }
    let mut table = Table::with_header(["level", "points"]);
    let mut push = |level: usize, net: Vec<Vec<Point<Fraction>>>| {
        table.rows.push(vec![Cell::Value(Value::int(level as i64)), Cell::Value(net_value(&net, *form))]);
    };
    let shown = &schemes[at_v - n..=at_v];
    for level in 0..=m {
        let row = |i: usize| shown.iter().map(|scheme| scheme.levels[level][i].clone()).collect();
        push(level, (0..=m - level).map(row).collect());
    }
    let points: Vec<Point<Fraction>> = schemes.iter().map(|scheme| scheme.result().clone()).collect();
    let curve = BSpline::new(in_v.clone(), points).map_err(spline_error)?;
    let scheme = curve.de_boor(at_v, &vec![v.clone(); n]).map_err(spline_error)?.tableau;
    for (level, points) in scheme.levels.into_iter().enumerate().skip(1) {
        push(m + level, vec![points]);
    }
    Ok(Value::Table(Arc::new(table)))
}

/// The coordinates of a surface as formulas in u and v: of a patch, or as given.
pub(super) fn surface_coordinates(args: &Arguments, i: usize) -> Result<Vec<Fraction>, Diagnostic> {
    let formulas = |items: &mut dyn Iterator<Item = &Value>| -> Result<Vec<Fraction>, Diagnostic> {
        let formula = |item: &Value| {
            item.as_scalar().cloned().ok_or_else(|| wrong_kind("a formula", item).at(args.span(i)))
        };
        items.map(formula).collect()
    };
    match args.value(i)? {
        Value::Geometry(geometry) if geometry.is_surface() => {
            let at =
                ["u", "v"].map(|name| Value::Scalar(Fraction::from(MultiPoly::symbol(Symbol::new(name)))));
            match on_patch(geometry, args, at)? {
                Value::List(items) => formulas(&mut items.iter()),
                single => formulas(&mut std::iter::once(&single)),
            }
        }
        Value::List(items) => formulas(&mut items.iter()),
        other => Err(wrong_kind("a surface", other)
            .at(args.span(i))
            .hint("a patch, or formulas such as [u, v, u v]")),
    }
}

/// The equation of a surface that is given by formulas or as a patch.
fn equation(args: &Arguments) -> Evaluated {
    let [u, v] = ["u", "v"].map(Symbol::new);
    let coordinates = surface_coordinates(args, 0)?;
    let [x, y, z] = <[Fraction; 3]>::try_from(coordinates).map_err(|list| {
        let message = format!("a surface in space has three coordinates, not {}", list.len());
        Diagnostic::error(Code::Shape, message).at(args.span(0)).hint("implicit_surface([u, v, u v])")
    })?;
    let reserved = ["x", "y", "z"].map(Symbol::new);
    let known: Vec<Symbol> = [&x, &y, &z].iter().flat_map(|f| f.variables()).collect();
    if known.iter().any(|s| reserved.contains(s)) {
        let error = Diagnostic::error(Code::Domain, "x, y and z are the coordinates of the equation");
        return Err(error.at(args.span(0)).hint("write the surface in u and v"));
    }
    let found =
        surface_equation(&[x, y, z], [&u, &v], &reserved).map_err(solve::system_error).at(args.span(0))?;
    found.map(|f| Value::Scalar(Fraction::from(f))).ok_or_else(|| {
        let error = Diagnostic::error(Code::Degenerate, "the surface is a curve or a point").at(args.span(0));
        error.hint("it has no single equation")
    })
}

/// The coordinates of a patch at symbols.
fn on_patch(geometry: &Geometry, args: &Arguments, [u, v]: [Value; 2]) -> Evaluated {
    let (Some(u), Some(v)) = (u.as_scalar(), v.as_scalar()) else { return Err(not_for(geometry, args)) };
    let point = match geometry {
        Geometry::Patch(patch, _) => patch.value(u, v),
        Geometry::Triangle(patch, _) => {
            patch.value(&[u.clone(), v.clone()]).map_err(crate::language::ops::errors::curve_error)?
        }
        other => return Err(not_for(other, args).hint("pieces(s) are its patches")),
    };
    geometry.form().value(point).map_err(crate::language::ops::errors::curve_error)
}
