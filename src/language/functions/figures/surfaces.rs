//! Figures of surfaces.

use super::numeric::{form_name, number};
use super::options::{Labels, drawn, finished, labels};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::wrong_kind;
use crate::language::ops::geometry::points_of;
use crate::language::value::{Form, Geometry, Value, polynomial_expr};
use crate::math::curve::{Net, Point, indices};
use crate::math::number::{Rational, rational};
use crate::math::poly::Fraction;
use crate::scene::pictures::{PatchPicture, TriangleDomain, TrianglePicture, triangle_labels};

type Result<T> = std::result::Result<T, Diagnostic>;

type Space = [Rational; 3];

/// A domain of more points is not legible.
const LARGEST_DOMAIN: usize = 40;

/// Longer names of points would cover the surface.
const LONGEST_NAMED: usize = 6;

/// The side of the square or triangle over which heights stand: so that they do not tower over it.
fn side<'a>(points: impl Iterator<Item = &'a Point<Fraction>>) -> Rational {
    let heights: Vec<Rational> = points.filter_map(|point| point.first()?.as_rational()).collect();
    match (heights.iter().min(), heights.iter().max()) {
        (Some(low), Some(high)) if low < high => (high - low) * rational(3, 2),
        _ => rational(1, 1),
    }
}

/// A point of space: its coordinates, or a height over a place of the domain.
fn space(point: &[Fraction], over: [Rational; 2], side: &Rational, span: Span) -> Result<Space> {
    match point {
        [x, y, z] => Ok([number(x, span)?, number(y, span)?, number(z, span)?]),
        [z] => {
            let [x, y] = over.map(|part| part * side);
            Ok([x, y, number(z, span)?])
        }
        _ => Err(Diagnostic::error(
            Code::Undrawable,
            format!("the points of a surface have 3 coordinates, not {}", point.len()),
        )
        .at(span)
        .hint("numbers alone are heights over a square or triangle")),
    }
}

/// i/n; 0 for n = 0
fn part(i: usize, n: usize) -> Rational {
    rational(i as i64, n.max(1) as i64)
}

fn digits(base: &str, digits: &[usize]) -> Expr {
    let long = digits.iter().any(|&digit| digit > 9);
    let index = match long {
        true => digits.iter().map(|&digit| Expr::int(digit as i64)).collect(),
        false => vec![Expr::name(digits.iter().map(usize::to_string).collect::<String>())],
    };
    Kind::Subscript(Box::new(Expr::name(base)), index).into()
}

/// Surfaces with weights are not drawn.
fn polynomial(form: Form, span: Span) -> Result<()> {
    if !form.rational {
        return Ok(());
    }
    Err(Diagnostic::error(Code::Unsupported, "only polynomial surfaces are drawn")
        .at(span)
        .hint("figure_bezier draws rational curves, such as boundary_curves(s)"))
}

/// A surface of several patches, also rational ones, without names of its points.
fn patches(args: &Arguments, items: &[Value]) -> Evaluated {
    let span = args.span(0);
    let mut nets = Vec::with_capacity(items.len());
    for item in items {
        let Value::Geometry(geometry) = item else {
            return Err(wrong_kind("a patch", item).at(span));
        };
        let Geometry::Patch(patch, form) = &**geometry else {
            return Err(wrong_kind("a patch", item).at(span));
        };
        let mut net = Vec::new();
        let mut weights = Vec::new();
        for row in patch.net() {
            let infinite = || {
                Diagnostic::error(Code::Undrawable, "a control point with weight 0 is at infinity")
                    .at(span)
                    .hint("subdivide the surface first")
            };
            let (values, own) = form.split(row).ok_or_else(infinite)?;
            let place = |value: &Value| match points_of(&Value::list(vec![value.clone()])) {
                Some((points, _)) if points[0].len() == 3 => {
                    space(&points[0], [0, 0].map(|k| rational(k, 1)), &rational(1, 1), span)
                }
                _ => Err(wrong_kind("points of space", value).at(span)),
            };
            net.push(values.iter().map(place).collect::<Result<Vec<Space>>>()?);
            weights.push(own.iter().map(|weight| number(weight, span)).collect::<Result<Vec<Rational>>>()?);
        }
        nets.push((net, weights));
    }
    let (net, weights) = nets.remove(0);
    let polygon = args.flag_or("polygon", nets.is_empty())?;
    let picture = PatchPicture { weights, others: nets, polygon, ..PatchPicture::of(net) };
    finished(args, drawn(picture.scene(), span)?)
}

pub(super) fn patch(args: &Arguments) -> Evaluated {
    let span = args.span(0);
    let wanted = labels(args)?.unwrap_or(Labels::None);
    let value = args.value(0)?;
    let wrong = |value: &Value| {
        wrong_kind("rows of control points or heights", value)
            .at(span)
            .hint("for example figure_patch([[0, 1], [1, 0]])")
    };
    let rows: Net<Fraction> = match value {
        Value::List(items) if items.iter().any(|item| matches!(item, Value::Geometry(_))) => {
            return patches(args, items);
        }
        Value::List(rows) if !rows.is_empty() => {
            let row = |row: &Value| points_of(row).map(|(points, _)| points).ok_or_else(|| wrong(row));
            rows.iter().map(row).collect::<Result<_>>()?
        }
        Value::Geometry(geometry) => match &**geometry {
            Geometry::Patch(patch, form) if !form.rational => patch.net().to_vec(),
            Geometry::Patch(..) => return patches(args, std::slice::from_ref(value)),
            Geometry::Surface(..) => {
                return Err(wrong(value).hint("pieces(s) are the patches of a spline surface"));
            }
            _ => return Err(wrong(value)),
        },
        Value::Matrix(matrix) => {
            matrix.row_iter().map(|row| row.iter().map(|x| [x.clone()].into()).collect()).collect()
        }
        other => return Err(wrong(other)),
    };
    let m = rows.len() - 1;
    let side = side(rows.iter().flatten());
    let point = |i: usize, (j, point): (usize, &Point<Fraction>)| {
        let n = rows[i].len() - 1;
        space(point, [part(i, m), part(j, n)], &side, span)
    };
    let net: Vec<Vec<Space>> = rows
        .iter()
        .enumerate()
        .map(|(i, row)| row.iter().enumerate().map(|entry| point(i, entry)).collect())
        .collect::<Result<_>>()?;
    let label = |i: usize, j: usize, n: usize| match wanted {
        Labels::Polar => {
            let arguments = |i: usize, n: usize| -> Vec<Expr> {
                (0..n).map(|k| Expr::int(i64::from(k + i >= n))).collect()
            };
            let groups: Vec<Vec<Expr>> =
                [arguments(i, m), arguments(j, n)].into_iter().filter(|group| !group.is_empty()).collect();
            if groups.is_empty() { form_name(0) } else { Kind::Apply(Box::new(form_name(0)), groups).into() }
        }
        _ => digits("b", &[i, j]),
    };
    let picture = PatchPicture {
        labels: match wanted {
            Labels::None => Vec::new(),
            _ => net
                .iter()
                .enumerate()
                .map(|(i, row)| (0..row.len()).map(|j| label(i, j, row.len() - 1)).collect())
                .collect(),
        },
        polygon: args.flag_or("polygon", true)?,
        ..PatchPicture::of(net)
    };
    finished(args, drawn(picture.scene(), span)?)
}

pub(super) fn triangle(args: &Arguments) -> Evaluated {
    let span = args.span(0);
    let wanted = labels(args)?;
    let corners: Option<[Expr; 3]> = match args.given(1) {
        Some(_) => {
            let given = args.scalars(1)?;
            let corners: Vec<Expr> = given.iter().map(polynomial_expr).collect();
            Some(corners.try_into().map_err(|given: Vec<Expr>| {
                Diagnostic::error(Code::Domain, format!("a triangle has 3 corners, not {}", given.len()))
                    .at(args.span(1))
                    .hint("for example figure_triangle(2, [r, s, t])")
            })?)
        }
        None => None,
    };
    let names = |n: usize, usual: Labels| {
        let usual = if n > LONGEST_NAMED { Labels::None } else { usual };
        match wanted.unwrap_or(usual) {
            Labels::Polar => {
                let [r, s, t] = corners.clone().unwrap_or_else(|| ["r", "s", "t"].map(Expr::name));
                triangle_labels(&form_name(0), n, [&r, &s, &t])
            }
            Labels::Points => indices(n).iter().map(|index| digits("b", index)).collect(),
            Labels::Values | Labels::None => Vec::new(),
        }
    };
    if args.value(0)?.as_rational().is_some() {
        let n = args.size(0)?;
        if n > LARGEST_DOMAIN {
            return Err(Diagnostic::error(
                Code::Undrawable,
                format!("a triangle of degree {n} does not fit a page"),
            )
            .at(span)
            .hint(format!("choose a degree up to {LARGEST_DOMAIN}")));
        }
        let picture = TriangleDomain { degree: n, labels: names(n, Labels::Polar) };
        return finished(args, drawn(picture.scene(), span)?);
    }
    let value = args.value(0)?;
    let points = match value {
        Value::Geometry(geometry) => match &**geometry {
            Geometry::Triangle(patch, form) => {
                polynomial(*form, span)?;
                Some(patch.points().to_vec())
            }
            _ => None,
        },
        _ => points_of(value).map(|(points, _)| points),
    };
    let points = points.ok_or_else(|| {
        wrong_kind("a degree, control points or heights", value)
            .at(span)
            .hint("for example figure_triangle(2, [r, s, t]) or figure_triangle([0, 1, 1, 0, 2, 0])")
    })?;
    let degree = (0..points.len()).find(|n| (n + 1) * (n + 2) / 2 >= points.len());
    let Some(n) = degree.filter(|n| (n + 1) * (n + 2) / 2 == points.len()) else {
        return Err(Diagnostic::error(
            Code::ControlPoints,
            format!("{} points do not make a triangular surface", points.len()),
        )
        .at(span)
        .hint("degree n needs (n + 1)(n + 2)/2 points: 3, 6, 10, 15, ..."));
    };
    let side = side(points.iter());
    let placed = points.iter().zip(indices(n));
    let placed = placed.map(|(point, [i, j, _])| space(point, [part(i, n), part(j, n)], &side, span));
    let usual = if corners.is_some() { Labels::Polar } else { Labels::None };
    let picture = TrianglePicture {
        degree: n,
        points: placed.collect::<Result<_>>()?,
        labels: names(n, usual),
        polygon: args.flag("polygon")?,
    };
    finished(args, drawn(picture.scene(), span)?)
}
