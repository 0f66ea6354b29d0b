//! What functions such as `derivative`, `casteljau` and `elevate` do with a surface.

use super::gives::Gives;
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::{curve_error, division_by_zero, spline_error, wrong_kind};
use std::sync::Arc;

use super::notions::chosen;
use super::parameter::{Need, Parameter, SURFACE, named, optional, required, size};
use super::record::Variant;
use super::surfaces::{polynomial_only, surface, tensor, triangular};
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::function;
use crate::language::ops::takes::{Takes, word_of};
use crate::language::value::{Cell, Form, Geometry, Polar, PolarKind, Table, Value, polynomial_expr};
use crate::math::blossom::{TensorPolarForm, TotalDegreePolarForm};
use crate::math::curve::{
    Direction, Point, RationalPatch, RationalTriangle, Scheme, TensorPatch, TrianglePatch, Vector, indices,
};
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Ring;
use crate::math::spline::{RationalSplineSurface, SplineSurface};

/// u, v, or both at once.
const DIRECTIONS: Takes = Takes::Word(&["u", "v", "bilinear"]);

pub(super) const POLAR: Option<Variant> = Variant::new(&[SURFACE], Gives::Polar, polar);

pub(super) const ELEVATE: Option<Variant> = Variant::new(
    &[
        SURFACE,
        optional("k", Takes::Size, "1", "by how many degrees in u, or of a triangular patch"),
        optional("l", Takes::Size, "k", "by how many degrees in v"),
    ],
    Gives::Surface,
    elevate,
);

pub(super) const REDUCE: Option<Variant> = Variant::new(
    &[
        SURFACE,
        optional("k", Takes::Size, "1", "by how many degrees in u, or of a triangular patch"),
        optional("l", Takes::Size, "k", "by how many degrees in v"),
    ],
    Gives::Surface,
    reduce,
);

pub(super) const DERIVATIVE: Option<Variant> = Variant::new(
    &[
        SURFACE,
        required(
            "r",
            Takes::OneOf(&[Takes::Size, Takes::Point]),
            "how often in u; or a direction, for a triangular patch",
        ),
        Parameter {
            need: Need::Many(0, usize::MAX),
            ..optional(
                "s",
                Takes::OneOf(&[Takes::Size, Takes::Point]),
                "0",
                "how often in v; or further directions",
            )
        },
    ],
    Gives::Surface,
    derivative,
);

pub(super) const INTEGRATE: Option<Variant> = Variant::new(&[SURFACE], Gives::Point, integrate);

pub(super) const DEGREE: Option<Variant> = Variant::new(&[SURFACE], Gives::Any, degree);

pub(super) const CASTELJAU: Option<Variant> = Variant::new(
    &[
        SURFACE,
        required(
            "u",
            Takes::OneOf(&[Takes::Scalar, Takes::Point]),
            "the first parameter; or the point, for a triangular patch",
        ),
        optional("v", Takes::Scalar, "the point is given", "the second parameter"),
        named("first=u", DIRECTIONS, "u", "which parameter comes first"),
    ],
    Gives::Table,
    casteljau,
);

pub(super) const SUBDIVIDE: Option<Variant> = Variant::new(
    &[
        SURFACE,
        optional(
            "u",
            Takes::OneOf(&[Takes::Scalar, Takes::Point]),
            "no cut",
            "where u is cut; or the point, for a triangular patch",
        ),
        optional("v", Takes::Scalar, "no cut", "where v is cut"),
    ],
    Gives::Surfaces,
    subdivide,
);

pub(super) const PART: Option<Variant> = Variant::new(
    &[
        SURFACE,
        required(
            "u",
            Takes::OneOf(&[Takes::Interval, Takes::Triangle]),
            "the interval of u; or three corners, for a triangular patch",
        )
        .shown("[a, b]"),
        optional("v", Takes::Interval, "[0, 1]", "the interval of v").shown("[c, d]"),
    ],
    Gives::Surface,
    part,
);

pub(super) const PIECES: Option<Variant> = Variant::new(&[SURFACE], Gives::Surfaces, pieces);

pub(super) const INSERT_KNOTS: Option<Variant> = Variant::new(
    &[
        SURFACE,
        named("u=[t_1, ...]", Takes::ScalarOrList, "none", "the new knots in u"),
        named("v=[t_1, ...]", Takes::ScalarOrList, "none", "the new knots in v"),
    ],
    Gives::Surface,
    insert_knots,
);

pub(super) const CONTROL_POINTS: Option<Variant> = Variant::new(&[SURFACE], Gives::List, control_points);

pub(super) const LABELS: Option<Variant> = Variant::new(&[SURFACE], Gives::Table, labels);

pub(super) const EXTENDED: Option<Variant> = Variant::new(
    &[
        SURFACE,
        required(
            "u",
            Takes::OneOf(&[Takes::Scalar, Takes::Point]),
            "the first parameter; or the point, for a triangular patch",
        ),
        optional("v", Takes::Scalar, "the point is given", "the second parameter"),
    ],
    Gives::Point,
    extended,
);

pub(super) const DERIVATIVES_AT: Option<Variant> = Variant::new(
    &[
        SURFACE,
        required("u", Takes::Scalar, "the first parameter"),
        required("v", Takes::Scalar, "the second parameter"),
        size("k", "the highest order"),
    ],
    Gives::List,
    derivatives_at,
);

pub(super) fn not_for(geometry: &Geometry, args: &Arguments) -> Diagnostic {
    Diagnostic::error(Code::Type, format!("this is not offered for {}", geometry.kind()))
        .at(args.span(0))
        .hint(match geometry {
            Geometry::Surface(..) => "pieces(s) are the Bézier patches of a spline surface",
            Geometry::Triangle(..) => "it is for tensor-product patches: patch(net) makes one",
            _ => "give a surface: patch(net) makes one",
        })
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
    if form.scalar && list.len() == 1 { list.swap_remove(0) } else { Value::point(list) }
}

pub(super) fn polar(args: &Arguments) -> Evaluated {
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
    let k = args.size(1)?;
    Ok((k, args.optional_size(2)?.unwrap_or(k)))
}

fn elevate(args: &Arguments) -> Evaluated {
    let (k, l) = both(args)?;
    match &*args.geometry(0)? {
        Geometry::Patch(patch, form) => Ok(tensor(patch.elevate(k, l), *form)),
        Geometry::Triangle(patch, form) => Ok(triangular(patch.elevate(k), *form)),
        Geometry::Surface(s, form) => {
            let raised = s.elevate(k, l);
            raised.map(|s| surface(s, *form)).map_err(spline_error)
        }
        other => Err(not_for(other, args)),
    }
}

fn reduce(args: &Arguments) -> Evaluated {
    let (k, l) = both(args)?;
    match &*args.geometry(0)? {
        Geometry::Patch(patch, form) => {
            patch.reduce(k, l).map(|p| tensor(p, *form)).map_err(curve_error).at(args.span(0))
        }
        Geometry::Triangle(patch, form) => {
            patch.reduce(k).map(|p| triangular(p, *form)).map_err(curve_error).at(args.span(0))
        }
        Geometry::Surface(s, form) => {
            let lower = s.reduce(k, l);
            lower.map(|s| surface(s, *form)).map_err(spline_error).at(args.span(0))
        }
        other => Err(not_for(other, args)),
    }
}

/// Of a patch by r times u and s times v; of a triangular one also in given directions.
fn derivative(args: &Arguments) -> Evaluated {
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    polynomial_only(form, args)?;
    if let Geometry::Triangle(patch, _) = &*geometry
        && let Some(directions) = directions(args)?
    {
        return patch
            .derivative(&directions)
            .map(|p| triangular(p, form))
            .map_err(curve_error)
            .at(args.span(1));
    }
    let (r, s) = (args.size(1)?, args.optional_size(2)?.unwrap_or(0));
    match &*geometry {
        Geometry::Patch(patch, _) => Ok(tensor(patch.derivative(r, s), form)),
        Geometry::Triangle(patch, _) => Ok(triangular(patch.partial_derivative(r, s), form)),
        Geometry::Surface(spline, _) => {
            spline.derivative(r, s).map(|d| surface(d, form)).map_err(spline_error).at(args.span(0))
        }
        other => Err(not_for(other, args)),
    }
}

/// The directions given after the first argument; `None` if numbers are given.
pub(super) fn directions(args: &Arguments) -> Result<Option<Vec<Vector<Fraction>>>, Diagnostic> {
    if !matches!(args.value(1)?, Value::List(_)) {
        return Ok(None);
    }
    (1..args.len()).map(|i| Ok(args.point(i)?.position())).collect::<Result<_, _>>().map(Some)
}

/// The integral over the domain.
fn integrate(args: &Arguments) -> Evaluated {
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
            let zero = Vector::zero(s.dimension());
            let patches = s.patches().concat();
            Ok(form.plain(patches.iter().fold(zero, |total, patch| total + over_patch(patch))))
        }
        other => Err(not_for(other, args)),
    }
}

fn degree(args: &Arguments) -> Evaluated {
    let pair = |m: usize, n: usize| Value::list([m, n].map(|k| Value::int(k as i64)).to_vec());
    Ok(match &*args.geometry(0)? {
        Geometry::Patch(patch, _) => pair(patch.degrees().0, patch.degrees().1),
        Geometry::Surface(s, _) => pair(s.knots().0.degree(), s.knots().1.degree()),
        Geometry::Triangle(patch, _) => Value::int(patch.degree() as i64),
        other => return Err(not_for(other, args)),
    })
}

/// The letter u or v given under a name.
pub(super) fn direction(args: &Arguments, name: &str) -> Result<Option<Direction>, Diagnostic> {
    args.named(name).map(|given| chosen(Some(given), &[("u", Direction::U), ("v", Direction::V)])).transpose()
}

pub(super) fn net_value(net: &[Vec<Point<Fraction>>], form: Form) -> Value {
    let row = |row: &Vec<Point<Fraction>>| Value::List(row.iter().map(|p| form.plain(p.clone())).collect());
    Value::List(net.iter().map(row).collect())
}

/// All levels of de Casteljau's algorithm.
fn casteljau(args: &Arguments) -> Evaluated {
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    let mut table = Table::with_header(["level", "points"]);
    match &*geometry {
        Geometry::Patch(patch, _) => {
            let scheme = match args.named("first").and_then(|(value, _)| word_of(value)) {
                Some("bilinear") => Scheme::Bilinear,
                _ => match direction(args, "first")? {
                    Some(Direction::V) => Scheme::VFirst,
                    _ => Scheme::UFirst,
                },
            };
            let nets = patch.tableau(&args.scalar(1)?, &args.scalar(2)?, scheme).map_err(curve_error)?;
            for (level, net) in nets.iter().enumerate() {
                table
                    .rows
                    .push(vec![Cell::Value(Value::int(level as i64)), Cell::Value(net_value(net, form))]);
            }
        }
        Geometry::Triangle(patch, _) => {
            let p = plane_point(args)?;
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

/// A point of the plane: its two coordinates, or both in a list.
fn plane_point(args: &Arguments) -> Result<Point<Fraction>, Diagnostic> {
    match args.given(2) {
        Some(_) => Ok([args.scalar(1)?, args.scalar(2)?].into()),
        None => args.point(1),
    }
}

/// At u and v in four, at u=t or v=t in two; a triangular patch at a point in three.
fn subdivide(args: &Arguments) -> Evaluated {
    match &*args.geometry(0)? {
        Geometry::Patch(patch, form) => {
            let rule = |p: &TensorPatch<_>, direction, t: &_| p.subdivide(direction, t).map_err(curve_error);
            cut(args, patch, rule, |part| tensor(part, *form))
        }
        Geometry::Surface(s, form) => {
            let rule =
                |s: &SplineSurface<_>, direction, t: &_| s.subdivide(direction, t).map_err(spline_error);
            cut(args, s, rule, |part| surface(part, *form))
        }
        Geometry::Triangle(patch, form) => {
            let p = plane_point(args)?;
            let parts = patch.subdivide(&p).map_err(curve_error).at(args.span(1))?;
            Ok(Value::List(parts.into_iter().map(|part| triangular(part, *form)).collect()))
        }
        other => Err(not_for(other, args)),
    }
}

/// In four at u and v, by rows; in two at one of them.
fn cut<S>(
    args: &Arguments,
    s: &S,
    rule: impl Fn(&S, Direction, &Fraction) -> Result<(S, S), Diagnostic>,
    value: impl Fn(S) -> Value,
) -> Evaluated {
    let pair = |s: &S, direction, t: &Fraction, i: usize| {
        let (before, after) = rule(s, direction, t).at(args.span(i))?;
        Ok([before, after])
    };
    let list = |parts: [S; 2]| Value::list(parts.map(&value).to_vec());
    match (args.optional_scalar(1)?, args.optional_scalar(2)?) {
        (Some(u), None) => pair(s, Direction::U, &u, 1).map(list),
        (None, Some(v)) => pair(s, Direction::V, &v, 2).map(list),
        (Some(u), Some(v)) => {
            let [before, after] = pair(s, Direction::U, &u, 1)?;
            let halves = |half: &S| pair(half, Direction::V, &v, 2).map(list);
            Ok(Value::list(vec![halves(&before)?, halves(&after)?]))
        }
        (None, None) => Err(Diagnostic::error(Code::Arity, "where is the surface cut?")
            .at(args.span(0))
            .hint("subdivide(s, u, v) cuts it in four, subdivide(s, u=t) in two")),
    }
}

/// Over a rectangle, or over a triangle.
fn part(args: &Arguments) -> Evaluated {
    match &*args.geometry(0)? {
        Geometry::Patch(patch, form) => Ok(tensor(patch.part(args.interval(1)?, args.interval(2)?), *form)),
        Geometry::Triangle(patch, form) => Ok(triangular(patch.part(args.triangle(1)?), *form)),
        Geometry::Surface(s, form) => {
            let part = s.part(args.interval(1)?, args.interval(2)?).map_err(spline_error);
            part.map(|part| surface(part, *form)).at(args.span(1))
        }
        other => Err(not_for(other, args)),
    }
}

pub(super) fn pieces(args: &Arguments) -> Evaluated {
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

/// Entry (r, s) is the derivative of order r in u and s in v, for r + s up to k.
type Jet = Vec<Vec<Vector<Fraction>>>;

/// All partial derivatives of order at most k of a surface at (u, v), and how they are shown.
pub(super) fn partial_derivatives(args: &Arguments, k: usize) -> Result<(Jet, Form), Diagnostic> {
    if let Some(coordinates) = formulas_in_u_and_v(args.value(0)?) {
        return of_formulas(args, &coordinates, k);
    }
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    let (u, v) = (args.scalar(1)?, args.scalar(2)?);
    crate::budget::charge_terms((k as u64 + 1).saturating_mul(k as u64 + 1));
    let polynomial = |patch: &TensorPatch<Fraction>| -> Jet {
        let row = |r: usize| (0..=k - r).map(|s| patch.derivative_at(r, s, &u, &v)).collect();
        (0..=k).map(row).collect()
    };
    let jet = match &*geometry {
        Geometry::Triangle(patch, _) if form.rational => RationalTriangle::from_homogeneous(patch.clone())
            .and_then(|patch| patch.derivatives(&[u, v], k))
            .map_err(curve_error),
        Geometry::Patch(patch, _) if form.rational => RationalPatch::from_homogeneous(patch.clone())
            .and_then(|patch| patch.derivatives(&u, &v, k))
            .map_err(curve_error),
        Geometry::Surface(s, _) if form.rational => RationalSplineSurface::from_homogeneous(s.clone())
            .and_then(|s| s.derivatives(&u, &v, k))
            .map_err(spline_error),
        Geometry::Surface(s, _) => s.patch_at(&u, &v).map(|patch| polynomial(&patch)).map_err(spline_error),
        Geometry::Patch(patch, _) => Ok(polynomial(patch)),
        Geometry::Triangle(patch, _) => {
            let place = [u, v];
            let at = |r: usize, s: usize| patch.partial_derivative(r, s).value(&place).map(|p| p.position());
            let rows = (0..=k).map(|r| (0..=k - r).map(|s| at(r, s)).collect());
            rows.collect::<Result<Jet, _>>().map_err(curve_error)
        }
        other => return Err(not_for(other, args)),
    };
    Ok((jet.at(args.span(1))?, Form { rational: false, ..form }))
}

/// The coordinates of a surface that is given by formulas in u and v, or by functions of two variables.
fn formulas_in_u_and_v(value: &Value) -> Option<Vec<Fraction>> {
    let Value::List(items) = value else { return None };
    let variables = ["u", "v"].map(Symbol::new);
    let formula = |item: &Value| match item {
        Value::Function(function) => function::formula_in(function, &variables),
        other => other.as_scalar().cloned(),
    };
    items.iter().map(formula).collect()
}

/// The same of coordinates as formulas in u and v.
fn of_formulas(args: &Arguments, coordinates: &[Fraction], k: usize) -> Result<(Jet, Form), Diagnostic> {
    let [u, v] = ["u", "v"].map(Symbol::new);
    let place = [(u.clone(), args.scalar(1)?), (v.clone(), args.scalar(2)?)];
    let derivative = |r: usize, s: usize| -> Result<Vector<Fraction>, Diagnostic> {
        let value = |f: &Fraction| {
            let once = |f: Fraction, x: &Symbol| f.derivative(x);
            let slope = (0..s).fold((0..r).fold(f.clone(), |f, _| once(f, &u)), |f, _| once(f, &v));
            slope.substitute(&place)
        };
        let list = coordinates.iter().map(value).collect::<Result<Vec<_>, _>>();
        Ok(list.map_err(|_| division_by_zero()).at(args.span(1))?.into())
    };
    let row = |r: usize| (0..=k - r).map(|s| derivative(r, s)).collect();
    Ok(((0..=k).map(row).collect::<Result<_, _>>()?, Form::default()))
}

fn derivatives_at(args: &Arguments) -> Evaluated {
    let (grid, form) = partial_derivatives(args, args.size(3)?)?;
    let row =
        |row: Vec<Vector<Fraction>>| Value::List(row.into_iter().map(|point| form.plain(point)).collect());
    Ok(Value::List(grid.into_iter().map(row).collect()))
}

/// The value at any parameters.
fn extended(args: &Arguments) -> Evaluated {
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    let point = match &*geometry {
        Geometry::Patch(patch, _) => patch.value(&args.scalar(1)?, &args.scalar(2)?),
        Geometry::Triangle(patch, _) => {
            let p = plane_point(args)?;
            patch.value(&p).map_err(curve_error).at(args.span(1))?
        }
        other => return Err(not_for(other, args)),
    };
    form.value(point).map_err(curve_error)
}

/// Knots named by their direction: u=[…], v=[…].
fn insert_knots(args: &Arguments) -> Evaluated {
    let geometry = args.geometry(0)?;
    let Geometry::Surface(s, form) = &*geometry else { return Err(not_for(&geometry, args)) };
    let mut finer = s.clone();
    for (name, direction) in [("u", Direction::U), ("v", Direction::V)] {
        let Some((value, span)) = args.named(name) else { continue };
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
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    let split = |points: &[Point<Fraction>]| {
        form.split(points)
            .map(|(values, _)| Value::list(values))
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
    let geometry = args.geometry(0)?;
    let form = geometry.form();
    let mut table = Table::default();
    match &*geometry {
        Geometry::Patch(patch, _) => {
            let (m, n) = patch.degrees();
            for (i, row) in patch.net().iter().enumerate() {
                let cell = |(j, point): (usize, &Point<Fraction>)| {
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
                let cell = |(j, point): (usize, &Point<Fraction>)| {
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
