//! Piecewise polynomials on triangulations.

use super::Builtin;
use super::gives::Gives;
use super::parameter::{Parameter, named, required, size};
use super::surfaces::triangular;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::ops::errors::{curve_error, wrong_kind};
use crate::language::ops::geometry::point_of;
use crate::language::ops::takes::Takes;
use crate::language::value::{Form, Value};
use crate::math::curve::{CornerData, Point, Triangle, Triangulation, clough_tocher, powell_sabin};
use crate::math::number::Rational;
use crate::math::poly::Fraction;
use num_traits::Signed;

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Surfaces");

const CORNERS: Parameter = required("corners", Takes::Triangle, "the corners").shown("[p, q, r]");

const DATA: Parameter =
    required("data", Takes::List, "value and gradient at each corner").shown("[[f, f_x, f_y], ...]");

const SPLIT: Parameter =
    named("split=[x, y]", Takes::Point, "the centroid", "the point inside at which the triangle is split");

const HEIGHTS: Form = Form { scalar: true, rational: false };

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "spline_dimension",
        parameters: &[
            required("points", Takes::Points, "the points of a triangulation").shown("[p_0, ..., p_m]"),
            required("triangles", Takes::List, "the numbers of the corners of each triangle, from 0")
                .shown("[[i, j, k], ...]"),
            size("d", "the degree"),
            size("r", "the order of continuity"),
        ],
        summary: "the dimension of the piecewise polynomials of degree d on a triangulation that are C^r",
        gives: Gives::Count,
        example: "spline_dimension([[0, 0], [3, 0], [0, 3], [1, 1]], [[0, 1, 3], [1, 2, 3], [2, 0, 3]], 3, 1)",
        call: |_, args| {
            let triangulation = triangulation(args)?;
            Ok(Value::int(triangulation.dimension(args.size(2)?, args.size(3)?) as i64))
        },
        ..NEW
    },
    Builtin {
        name: "clough_tocher",
        parameters: &[
            CORNERS,
            DATA,
            named(
                "normals=[a, b, c]",
                Takes::Scalars,
                "means of those at the ends",
                "derivatives at the midpoints of p q, q r, r p, along the edge turned to the left",
            ),
            SPLIT,
        ],
        summary: "Clough and Tocher's element: three cubic patches that meet C^1 around a point inside",
        gives: Gives::Surfaces,
        example: "clough_tocher([[0, 0], [1, 0], [0, 1]], [[0, 0, 0], [1, 2, 0], [0, 0, 0]])",
        call: |_, args| {
            let (triangle, data) = (args.triangle(0)?, data(args)?);
            let across = match args.named_scalars("normals")? {
                None => None,
                Some(list) => Some(<[Fraction; 3]>::try_from(list).map_err(|list| {
                    let message = format!("three derivatives are needed, not {}", list.len());
                    let error = Diagnostic::error(Code::Shape, message);
                    match args.named("normals") {
                        Some((_, span)) => error.at(span),
                        None => error,
                    }
                })?),
            };
            let split = split(args, &triangle)?;
            let patches = clough_tocher(&triangle, &data, across.as_ref(), split.as_ref());
            let patches = patches.map_err(curve_error).at(args.span(0))?;
            Ok(Value::list(patches.into_iter().map(|patch| triangular(patch, HEIGHTS)).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "powell_sabin",
        parameters: &[
            CORNERS,
            DATA,
            SPLIT,
            named(
                "edges=[a, b, c]",
                Takes::Scalars,
                "[1/2, 1/2, 1/2]",
                "the ratios at which p q, q r, r p are split: (1 - a) p + a q",
            ),
        ],
        summary: "Powell and Sabin's element: six quadratic patches that meet C^1 around a point inside",
        gives: Gives::Surfaces,
        example: "powell_sabin([[0, 0], [1, 0], [0, 1]], [[0, 0, 0], [1, 2, 0], [0, 0, 0]])",
        call: |_, args| {
            let triangle = args.triangle(0)?;
            let split = split(args, &triangle)?;
            let edges = edges(args)?;
            let patches = powell_sabin(&triangle, &data(args)?, split.as_ref(), edges.as_ref());
            let patches = patches.map_err(curve_error).at(args.span(0))?;
            Ok(Value::list(patches.into_iter().map(|patch| triangular(patch, HEIGHTS)).collect()))
        },
        ..NEW
    },
];

/// The point at which the triangle is split, which lies inside.
fn split(args: &Arguments, triangle: &Triangle<Fraction>) -> Result<Option<Point<Fraction>>> {
    let Some((value, span)) = args.named("split") else { return Ok(None) };
    let point = point_of(value).map(|(point, _)| point).filter(|point| point.len() == 2);
    let point = point.ok_or_else(|| wrong_kind("a point of the plane", value).at(span))?;
    let inside = triangle.barycentric(&point).map_err(curve_error).at(span)?;
    if inside.iter().filter_map(Fraction::as_rational).any(|weight| !weight.is_positive()) {
        let error = Diagnostic::error(Code::Domain, "the point does not lie inside of the triangle").at(span);
        return Err(error.hint("all its barycentric coordinates have to be positive"));
    }
    Ok(Some(point))
}

/// Three ratios between 0 and 1.
fn edges(args: &Arguments) -> Result<Option<[Fraction; 3]>> {
    let Some(list) = args.named_scalars("edges")? else { return Ok(None) };
    let span = args.named("edges").map_or_else(|| args.span(0), |(_, span)| span);
    let between = |x: &Rational| x.is_positive() && *x < Rational::from_integer(1.into());
    match <[Fraction; 3]>::try_from(list) {
        Ok(list) if list.iter().filter_map(Fraction::as_rational).all(|x| between(&x)) => Ok(Some(list)),
        _ => Err(Diagnostic::error(Code::Domain, "three ratios between 0 and 1 are needed")
            .at(span)
            .hint("edges=[1/2, 1/2, 1/2] are the midpoints")),
    }
}

/// Three times value and gradient.
fn data(args: &Arguments) -> Result<[CornerData<Fraction>; 3]> {
    let wrong = || {
        let error =
            wrong_kind("value and gradient at three corners", args.value(1).unwrap_or(&Value::int(0)));
        error.at(args.span(1)).hint("[[f, f_x, f_y], ...] with three entries")
    };
    let Value::List(items) = args.value(1)? else { return Err(wrong()) };
    let corner = |item: &Value| -> Option<CornerData<Fraction>> {
        let Value::List(entries) = item else { return None };
        let entries: Vec<Fraction> = entries.iter().map(|x| x.as_scalar().cloned()).collect::<Option<_>>()?;
        let [value, x, y] = <[Fraction; 3]>::try_from(entries).ok()?;
        Some(CornerData { value, gradient: [x, y] })
    };
    let list: Option<Vec<CornerData<Fraction>>> = items.iter().map(corner).collect();
    list.and_then(|list| list.try_into().ok()).ok_or_else(wrong)
}

fn triangulation(args: &Arguments) -> Result<Triangulation> {
    let (points, _) = args.control_points(0)?;
    let numbers = |point: &[Fraction]| -> Option<[Rational; 2]> {
        point.iter().map(Fraction::as_rational).collect::<Option<Vec<_>>>()?.try_into().ok()
    };
    let points: Option<Vec<[Rational; 2]>> = points.iter().map(|p| numbers(p)).collect();
    let points = points.ok_or_else(|| {
        let error = Diagnostic::error(Code::Type, "points of the plane with numbers are needed");
        error.at(args.span(0)).hint("such as [[0, 0], [1, 0], [0, 1]]")
    })?;
    let wrong = || {
        let error = wrong_kind("triples of numbers of points", args.value(1).unwrap_or(&Value::int(0)));
        error.at(args.span(1)).hint("[[0, 1, 2], [1, 3, 2]] are two triangles")
    };
    let Value::List(items) = args.value(1)? else { return Err(wrong()) };
    let triangle = |item: &Value| -> Option<[usize; 3]> {
        let Value::List(corners) = item else { return None };
        let list: Option<Vec<usize>> =
            corners.iter().map(|x| x.as_int().and_then(|i| usize::try_from(i).ok())).collect();
        list?.try_into().ok()
    };
    let triangles: Option<Vec<[usize; 3]>> = items.iter().map(triangle).collect();
    Triangulation::new(points, triangles.ok_or_else(wrong)?).map_err(curve_error).at(args.span(1))
}
