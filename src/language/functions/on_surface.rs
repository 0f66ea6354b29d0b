//! What functions such as `derivative`, `casteljau` and `elevate` do with surfaces.

use std::sync::Arc;

use super::surfaces::{polynomial_only, surface, tensor, triangular};
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::{curve_error, spline_error, wrong_kind};
use crate::language::ops::formula;
use crate::language::value::{Cell, Form, Geometry, Polar, PolarKind, Table, Value, polynomial_expr};
use crate::math::blossom::{TensorPolarForm, TotalDegreePolarForm};
use crate::math::curve::{Direction, EdgeEquation, Scheme, TensorPatch, TrianglePatch, indices};
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Ring;
use num_traits::Zero;

/// The meaning of a function for a surface as its first argument, if it has one.
pub(super) fn method(name: &str) -> Option<fn(&Arguments) -> Evaluated> {
    Some(match name {
        "polar" => polar,
        "elevate" => elevate,
        "reduce" => reduce,
        "derivative" | "diff" => derivative,
        "integrate" => integrate,
        "degree" => degree,
        "casteljau" => casteljau,
        "subdivide" => subdivide,
        "part" => part,
        "pieces" => pieces,
        "insert_knots" => insert_knots,
        "control_points" | "bezier_points" => control_points,
        "labels" => labels,
        "joining_conditions" => joining_conditions,
        "continuity" => continuity,
        "extended" => extended,
        "derivatives_at" => derivatives_at,
        "convert" => convert,
        _ => return None,
    })
}

fn not_for(geometry: &Geometry, args: &Arguments) -> Diagnostic {
    Diagnostic::error(Code::Type, format!("this is not offered for {}", geometry.kind()))
        .at(args.span(0))
        .hint("pieces(s) are the Bézier patches of a spline surface")
}

fn tensor_polar(form: TensorPolarForm<Fraction>) -> Value {
    let variables = vec![Symbol::new("u"), Symbol::new("v")];
    Value::Polar(Arc::new(Polar { kind: PolarKind::Tensor(form), variables }))
}

fn total_polar(form: TotalDegreePolarForm<Fraction>) -> Value {
    let variables = vec![Symbol::new("u"), Symbol::new("v")];
    Value::Polar(Arc::new(Polar { kind: PolarKind::Total(form), variables }))
}

/// One value for each coordinate; a single one for scalar surfaces.
fn coordinates(mut list: Vec<Value>, form: Form) -> Value {
    if form.scalar && list.len() == 1 { list.swap_remove(0) } else { Value::List(list) }
}

fn polar(args: &Arguments) -> Evaluated {
    args.expect("polar(s)", 1..=1, &[])?;
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    polynomial_only(form, args)?;
    match &*geometry {
        Geometry::Patch(patch, _) => {
            Ok(coordinates(patch.polar_forms().into_iter().map(tensor_polar).collect(), form))
        }
        Geometry::Triangle(patch, _) => {
            Ok(coordinates(patch.polar_forms().into_iter().map(total_polar).collect(), form))
        }
        other => Err(not_for(other, args)),
    }
}

/// Steps in u and in v: 1 and 1 if not given, the same in both if there is one.
fn both(args: &Arguments) -> Result<(usize, usize), Diagnostic> {
    let k = args.named_size("k", 1)?.unwrap_or(1);
    Ok((k, args.named_size("l", 2)?.unwrap_or(k)))
}

fn elevate(args: &Arguments) -> Evaluated {
    args.expect("elevate(s, k, l)", 1..=3, &["k", "l"])?;
    let (k, l) = both(args)?;
    match &*args.geometry(0)? {
        Geometry::Patch(patch, form) => Ok(tensor(patch.elevate(k, l), *form)),
        Geometry::Triangle(patch, form) => Ok(triangular(patch.elevate(k), *form)),
        Geometry::Surface(s, form) => {
            let raised = s.elevate(Direction::U, k).and_then(|s| s.elevate(Direction::V, l));
            raised.map(|s| surface(s, *form)).map_err(spline_error)
        }
        other => Err(not_for(other, args)),
    }
}

fn reduce(args: &Arguments) -> Evaluated {
    args.expect("reduce(s, k, l)", 1..=3, &["k", "l"])?;
    let (k, l) = both(args)?;
    match &*args.geometry(0)? {
        Geometry::Patch(patch, form) => {
            patch.reduce(k, l).map(|p| tensor(p, *form)).map_err(curve_error).at(args.span(0))
        }
        Geometry::Triangle(patch, form) => {
            patch.reduce(k).map(|p| triangular(p, *form)).map_err(curve_error).at(args.span(0))
        }
        Geometry::Surface(s, form) => {
            let lower = s.reduce(Direction::U, k).and_then(|s| s.reduce(Direction::V, l));
            lower.map(|s| surface(s, *form)).map_err(spline_error).at(args.span(0))
        }
        other => Err(not_for(other, args)),
    }
}

/// Of a patch by r times u and s times v; of a triangular one also in given directions.
fn derivative(args: &Arguments) -> Evaluated {
    args.expect("derivative(s, r, s)", 2..=usize::MAX, &[])?;
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    polynomial_only(form, args)?;
    if let Geometry::Triangle(patch, _) = &*geometry
        && matches!(args.value(1)?, Value::List(_))
    {
        let directions = (1..args.len()).map(|i| args.point(i)).collect::<Result<Vec<_>, _>>()?;
        return patch
            .derivative(&directions)
            .map(|p| triangular(p, form))
            .map_err(curve_error)
            .at(args.span(1));
    }
    let (r, s) = (args.size(1)?, if args.len() > 2 { args.size(2)? } else { 0 });
    match &*geometry {
        Geometry::Patch(patch, _) => Ok(tensor(patch.derivative(r, s), form)),
        Geometry::Triangle(patch, _) => Ok(triangular(patch.partial_derivative(r, s), form)),
        Geometry::Surface(spline, _) => {
            spline.derivative(r, s).map(|d| surface(d, form)).map_err(spline_error).at(args.span(0))
        }
        other => Err(not_for(other, args)),
    }
}

/// The integral over the domain.
fn integrate(args: &Arguments) -> Evaluated {
    args.expect("integrate(s)", 1..=1, &[])?;
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    polynomial_only(form, args)?;
    let over_patch = |patch: &TensorPatch<Fraction>| {
        let width = |i: &crate::math::curve::Interval<Fraction>| i.end().minus(i.start());
        let points = patch.net().concat();
        let count = crate::math::number::Rational::from_integer((points.len() as i64).into());
        let share = width(patch.u()).times(&width(patch.v())).scaled(&num_traits::Inv::inv(count));
        crate::math::curve::combination(patch.dimension(), points.iter().map(|point| (&share, point)))
    };
    match &*geometry {
        Geometry::Triangle(patch, _) => Ok(form.plain(patch.integral())),
        Geometry::Patch(patch, _) => Ok(form.plain(over_patch(patch))),
        Geometry::Surface(s, _) => {
            let zero = vec![Fraction::zero(); s.dimension()];
            let patches = s.patches().concat();
            let total =
                patches.iter().fold(zero, |sum, patch| crate::math::curve::sum(&sum, &over_patch(patch)));
            Ok(form.plain(total))
        }
        other => Err(not_for(other, args)),
    }
}

fn degree(args: &Arguments) -> Evaluated {
    args.expect("degree(s)", 1..=1, &[])?;
    let pair = |m: usize, n: usize| Value::List([m, n].map(|k| Value::int(k as i64)).to_vec());
    Ok(match &*args.geometry(0)? {
        Geometry::Patch(patch, _) => pair(patch.degrees().0, patch.degrees().1),
        Geometry::Surface(s, _) => pair(s.knots().0.degree(), s.knots().1.degree()),
        Geometry::Triangle(patch, _) => Value::int(patch.degree() as i64),
        other => return Err(not_for(other, args)),
    })
}

/// The letter u or v given under a name.
fn direction(args: &Arguments, name: &str) -> Result<Option<Direction>, Diagnostic> {
    let Some((value, span)) = args.named_or(name, usize::MAX) else { return Ok(None) };
    match formula::symbol_of(value).as_ref().map(Symbol::base) {
        Some("u") => Ok(Some(Direction::U)),
        Some("v") => Ok(Some(Direction::V)),
        _ => Err(wrong_kind("u or v", value).at(span).hint(format!("such as {name}=u"))),
    }
}

fn net_value(net: &[Vec<Vec<Fraction>>], form: Form) -> Value {
    let row = |row: &Vec<Vec<Fraction>>| Value::List(row.iter().map(|p| form.plain(p.clone())).collect());
    Value::List(net.iter().map(row).collect())
}

/// All levels of de Casteljau's algorithm.
fn casteljau(args: &Arguments) -> Evaluated {
    args.expect("casteljau(s, u, v, first=u)", 2..=3, &["first"])?;
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    let mut table = Table::with_header(["level", "points"]);
    match &*geometry {
        Geometry::Patch(patch, _) => {
            let bilinear = matches!(args.named_or("first", usize::MAX), Some((Value::Text(word), _)) if word == "bilinear");
            let scheme = if bilinear {
                Scheme::Bilinear
            } else {
                match direction(args, "first")? {
                    Some(Direction::V) => Scheme::VFirst,
                    _ => Scheme::UFirst,
                }
            };
            let nets = patch.tableau(&args.scalar(1)?, &args.scalar(2)?, scheme).map_err(curve_error)?;
            for (level, net) in nets.iter().enumerate() {
                table
                    .rows
                    .push(vec![Cell::Value(Value::int(level as i64)), Cell::Value(net_value(net, form))]);
            }
        }
        Geometry::Triangle(patch, _) => {
            let p = if args.len() == 3 { vec![args.scalar(1)?, args.scalar(2)?] } else { args.point(1)? };
            let levels = patch.tableau(&p).map_err(curve_error).at(args.span(1))?;
            for (level, points) in levels.into_iter().enumerate() {
                let points = Value::List(points.into_iter().map(|point| form.plain(point)).collect());
                table.rows.push(vec![Cell::Value(Value::int(level as i64)), Cell::Value(points)]);
            }
        }
        other => return Err(not_for(other, args)),
    }
    Ok(Value::Table(Arc::new(table)))
}

/// A patch at u and v in four, at u=t or v=t in two; a triangular one at a point in three.
fn subdivide(args: &Arguments) -> Evaluated {
    args.expect("subdivide(s, u, v)", 1..=3, &["u", "v"])?;
    let scalar = |name: &str| match args.named_or(name, usize::MAX) {
        Some((Value::Scalar(t), _)) => Ok(Some(t.clone())),
        Some((other, span)) => Err(wrong_kind("a number or symbol", other).at(span)),
        None => Ok(None),
    };
    match &*args.geometry(0)? {
        Geometry::Patch(patch, form) => {
            let named = (scalar("u")?, scalar("v")?);
            let pair = |direction, t: &Fraction| {
                let parts = patch.subdivide(direction, t).map_err(curve_error)?;
                Ok(Value::List(vec![tensor(parts.0, *form), tensor(parts.1, *form)]))
            };
            match named {
                (Some(u), None) => pair(Direction::U, &u),
                (None, Some(v)) => pair(Direction::V, &v),
                (Some(u), Some(v)) => quarters(patch, &u, &v, *form),
                (None, None) => quarters(patch, &args.scalar(1)?, &args.scalar(2)?, *form),
            }
        }
        Geometry::Triangle(patch, form) => {
            let p = if args.len() == 3 { vec![args.scalar(1)?, args.scalar(2)?] } else { args.point(1)? };
            let parts = patch.subdivide(&p).map_err(curve_error).at(args.span(1))?;
            Ok(Value::List(parts.into_iter().map(|part| triangular(part, *form)).collect()))
        }
        other => Err(not_for(other, args)),
    }
}

fn quarters(patch: &TensorPatch<Fraction>, u: &Fraction, v: &Fraction, form: Form) -> Evaluated {
    let parts = patch.quarters(u, v).map_err(curve_error)?;
    let row = |row: [TensorPatch<Fraction>; 2]| Value::List(row.map(|part| tensor(part, form)).to_vec());
    Ok(Value::List(parts.map(row).to_vec()))
}

/// Over a rectangle, or over a triangle.
fn part(args: &Arguments) -> Evaluated {
    args.expect("part(s, [a, b], [c, d])", 2..=3, &[])?;
    match &*args.geometry(0)? {
        Geometry::Patch(patch, form) => Ok(tensor(patch.part(args.interval(1)?, args.interval(2)?), *form)),
        Geometry::Triangle(patch, form) => Ok(triangular(patch.over(args.triangle(1)?), *form)),
        other => Err(not_for(other, args)),
    }
}

fn pieces(args: &Arguments) -> Evaluated {
    args.expect("pieces(s)", 1..=1, &[])?;
    match &*args.geometry(0)? {
        Geometry::Surface(s, form) => {
            let row = |row: Vec<TensorPatch<Fraction>>| {
                Value::List(row.into_iter().map(|p| tensor(p, *form)).collect())
            };
            Ok(Value::List(s.patches().into_iter().map(row).collect()))
        }
        other => Err(not_for(other, args)),
    }
}

/// Row r, entry s: the derivative r times by u and s times by v, for r + s up to k.
fn derivatives_at(args: &Arguments) -> Evaluated {
    args.expect("derivatives_at(s, u, v, k)", 4..=4, &[])?;
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    let (u, v, k) = (args.scalar(1)?, args.scalar(2)?, args.size(3)?);
    crate::budget::charge_terms((k as u64 + 1).saturating_mul(k as u64 + 1));
    let grid = match &*geometry {
        Geometry::Patch(patch, _) if form.rational => {
            crate::math::curve::RationalPatch::from_homogeneous(patch.clone())
                .and_then(|p| p.derivatives(&u, &v, k))
        }
        Geometry::Triangle(patch, _) if form.rational => {
            crate::math::curve::RationalTriangle::from_homogeneous(patch.clone())
                .and_then(|p| p.derivatives(&[u, v], k))
        }
        Geometry::Patch(patch, _) => {
            let row = |r: usize| (0..=k - r).map(|s| patch.derivative_at(r, s, &u, &v)).collect();
            Ok((0..=k).map(row).collect())
        }
        other => return Err(not_for(other, args)),
    };
    let plain = Form { rational: false, ..form };
    let row =
        |row: Vec<Vec<Fraction>>| Value::List(row.into_iter().map(|point| plain.plain(point)).collect());
    Ok(Value::List(grid.map_err(curve_error).at(args.span(1))?.into_iter().map(row).collect()))
}

/// The value at any parameters.
fn extended(args: &Arguments) -> Evaluated {
    args.expect("extended(s, u, v)", 2..=3, &[])?;
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    let point = match &*geometry {
        Geometry::Patch(patch, _) => patch.value(&args.scalar(1)?, &args.scalar(2)?),
        Geometry::Triangle(patch, _) => {
            let p = if args.len() == 3 { vec![args.scalar(1)?, args.scalar(2)?] } else { args.point(1)? };
            patch.value(&p).map_err(curve_error).at(args.span(1))?
        }
        other => return Err(not_for(other, args)),
    };
    form.value(point).map_err(curve_error)
}

/// Knots named by their direction: u=[…], v=[…].
fn insert_knots(args: &Arguments) -> Evaluated {
    args.expect("insert_knots(s, u=[t_1, ...], v=[t_1, ...])", 1..=1, &["u", "v"])?;
    let geometry = args.geometry(0)?;
    let Geometry::Surface(s, form) = &*geometry else { return Err(not_for(&geometry, args)) };
    let mut finer = s.clone();
    for (name, direction) in [("u", Direction::U), ("v", Direction::V)] {
        let Some((value, span)) = args.named_or(name, usize::MAX) else { continue };
        let list: Option<Vec<Fraction>> = match value {
            Value::Scalar(t) => Some(vec![t.clone()]),
            Value::List(items) => items.iter().map(|item| item.as_scalar().cloned()).collect(),
            _ => None,
        };
        let list = list.ok_or_else(|| wrong_kind("a list of knots", value).at(span))?;
        finer = finer.insert(direction, &list).map_err(spline_error).at(span)?;
    }
    Ok(surface(finer, *form))
}

fn control_points(args: &Arguments) -> Evaluated {
    args.expect("control_points(s)", 1..=1, &[])?;
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    let split = |points: &[Vec<Fraction>]| {
        form.split(points)
            .map(|(values, _)| Value::List(values))
            .ok_or_else(|| curve_error(crate::math::curve::CurveError::ZeroDenominator).at(args.span(0)))
    };
    match &*geometry {
        Geometry::Patch(patch, _) => {
            patch.net().iter().map(|row| split(row)).collect::<Result<_, _>>().map(Value::List)
        }
        Geometry::Surface(s, _) => {
            s.net().iter().map(|row| split(row)).collect::<Result<_, _>>().map(Value::List)
        }
        other => split(&other.control_points()),
    }
}

/// f(u, u; v) or f(p, p, q).
fn groups_label(groups: [Vec<Expr>; 2]) -> Expr {
    let groups: Vec<Vec<Expr>> = groups.into_iter().filter(|group| !group.is_empty()).collect();
    match groups.is_empty() {
        true => Expr::name("f"),
        false => Kind::Apply(Box::new(Expr::name("f")), groups).into(),
    }
}

fn ends(interval: &crate::math::curve::Interval<Fraction>, n: usize, i: usize) -> Vec<Expr> {
    let (a, b) = (interval.start(), interval.end());
    std::iter::repeat_n(a, n - i).chain(std::iter::repeat_n(b, i)).map(polynomial_expr).collect()
}

fn corner_label(patch: &TrianglePatch<Fraction>, place: [usize; 3]) -> Expr {
    let corner = |k: usize| -> Expr {
        let point = &patch.triangle().corners()[k];
        Kind::Tuple(point.iter().map(polynomial_expr).collect()).into()
    };
    let list: Vec<Expr> = (0..3).flat_map(|k| vec![corner(k); place[k]]).collect();
    if list.is_empty() { Expr::name("f") } else { Expr::apply(Expr::name("f"), list) }
}

/// Every control point with its polar label.
fn labels(args: &Arguments) -> Evaluated {
    args.expect("labels(s)", 1..=1, &[])?;
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    let mut table = Table::default();
    match &*geometry {
        Geometry::Patch(patch, _) => {
            let (m, n) = patch.degrees();
            for (i, row) in patch.net().iter().enumerate() {
                let cell = |(j, point): (usize, &Vec<Fraction>)| {
                    let label = groups_label([ends(patch.u(), m, i), ends(patch.v(), n, j)]);
                    Cell::Labelled(label, form.plain(point.clone()))
                };
                table.rows.push(row.iter().enumerate().map(cell).collect());
            }
        }
        Geometry::Surface(s, _) => {
            let (u, v) = s.knots();
            let list = |label: &[Fraction]| label.iter().map(polynomial_expr).collect();
            for (i, row) in s.net().iter().enumerate() {
                let cell = |(j, point): (usize, &Vec<Fraction>)| {
                    Cell::Labelled(
                        groups_label([list(u.label(i)), list(v.label(j))]),
                        form.plain(point.clone()),
                    )
                };
                table.rows.push(row.iter().enumerate().map(cell).collect());
            }
        }
        Geometry::Triangle(patch, _) => {
            let mut row = Vec::new();
            let mut first = patch.degree();
            for (place, point) in indices(patch.degree()).into_iter().zip(patch.points()) {
                if place[0] != first {
                    table.rows.push(std::mem::take(&mut row));
                    first = place[0];
                }
                row.push(Cell::Labelled(corner_label(patch, place), form.plain(point.clone())));
            }
            table.rows.push(row);
        }
        other => return Err(not_for(other, args)),
    }
    Ok(Value::Table(Arc::new(table)))
}

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
    args.expect("joining_conditions(s, r, k, across=u)", 2..=3, &["k", "across"])?;
    let k = args.named_size("k", 2)?.unwrap_or(1);
    let (equations, form) = equations(args, k)?;
    let mut table = Table::with_header(["order", "place", "required", "found", "holds"]);
    table.rows = equations.iter().map(|equation| equation_row(equation, form)).collect();
    Ok(Value::Table(Arc::new(table)))
}

/// The largest order up to which two patches join.
fn continuity(args: &Arguments) -> Evaluated {
    args.expect("continuity(s, r, across=u)", 2..=2, &["across"])?;
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
    args.expect("convert(s, to, domain, domain)", 2..=4, &["to"])?;
    let target = args.value(1)?;
    let word = match target {
        Value::Text(word) => word.as_str(),
        Value::Builtin(word) => word,
        _ => "",
    };
    // The domains stand after the word.
    let rest = |i: usize| args.len() > i;
    match (&*args.geometry(0)?, word) {
        (Geometry::Patch(patch, form), "triangle") => {
            polynomial_only(*form, args)?;
            let corners = if rest(2) { args.triangle(2)? } else { crate::math::curve::Triangle::unit() };
            patch.to_triangle(corners).map(|p| triangular(p, *form)).map_err(curve_error).at(args.span(0))
        }
        (Geometry::Triangle(patch, form), "tensor") => {
            polynomial_only(*form, args)?;
            Ok(tensor(patch.to_tensor(args.interval(2)?, args.interval(3)?), *form))
        }
        (Geometry::Patch(..) | Geometry::Triangle(..), "polar") => polar(&args.only(1)),
        (Geometry::Surface(..), "pieces") => pieces(&args.only(1)),
        (Geometry::Patch(patch, form), "bspline") => {
            let knots = |interval: &crate::math::curve::Interval<Fraction>, n: usize| {
                crate::math::spline::KnotVector::clamped(n, interval.start(), &[], interval.end()).map_err(spline_error)
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
            .hint("patches: triangle, polar, power, bspline; triangular ones: tensor, polar; spline surfaces: pieces")),
    }
}
