//! Surfaces: tensor-product and triangular patches, spline surfaces.

use super::gives::Gives;
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::{curve_error, spline_error, wrong_kind};
use crate::language::ops::geometry::{bezier, cross, spline};
use std::sync::Arc;

use super::parameter::{GRAPH, HOMOGENEOUS, SURFACE, named, optional, required, size};
use super::{Builtin, on_surface};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::takes::Takes;
use crate::language::value::{Form, Geometry, Value};
use crate::math::curve::{
    BezierCurve, Corner, CurveError, Interval, Point, RationalPatch, Side, TensorPatch, TrianglePatch, Vector,
};
use crate::math::poly::Fraction;
use crate::math::spline::{BSpline, KnotVector, SplineSurface};
use num_traits::One;

const NEW: Builtin = Builtin::about("Surfaces");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "patch",
        parameters: &[
            required("net", Takes::Net, "the control points, rows in u").shown("[[b_00, b_01, ...], ...]"),
            optional("u", Takes::Interval, "[0, 1]", "the interval of u").shown("[a, b]"),
            optional("v", Takes::Interval, "[0, 1]", "the interval of v").shown("[c, d]"),
            named("weights=[[...], ...]", Takes::Rows, "all 1", "the weights of the points"),
            HOMOGENEOUS,
        ],
        summary: "the tensor-product Bézier patch of a net, rows in u, over [a, b] x [c, d]",
        gives: Gives::Surface,
        example: "patch([[0, 1], [2, 5]])(1/2, 1/2)",
        call: |_, args| {
            let (net, form) = args.net(0)?;
            let (u, v) = (args.interval(1)?, args.interval(2)?);
            let patch = TensorPatch::new(net, u, v).map_err(curve_error).at(args.span(0))?;
            Ok(tensor(patch, form))
        },
        ..NEW
    },
    Builtin {
        name: "triangle_patch",
        parameters: &[
            required("points", Takes::Points, "the control points").shown("[b_n00, ..., b_00n]"),
            optional("corners", Takes::Triangle, "[0, 0], [1, 0], [0, 1]", "the corners of the domain")
                .shown("[p, q, r]"),
            named("weights=[...]", Takes::Scalars, "all 1", "the weights of the points"),
            HOMOGENEOUS,
        ],
        summary: "the triangular patch with points f(p^i q^j r^k): i, then j descending",
        gives: Gives::Surface,
        example: "triangle_patch([b_200, b_110, b_101, b_020, b_011, b_002])",
        call: |_, args| {
            let (points, form) = args.control_points(0)?;
            let patch = TrianglePatch::new(points, args.triangle(1)?).map_err(curve_error).at(args.span(0))?;
            Ok(triangular(patch, form))
        },
        ..NEW
    },
    Builtin {
        name: "spline_surface",
        parameters: &[
            size("m", "the degree in u"),
            size("n", "the degree in v"),
            required("u", Takes::Scalars, "the knots in u").shown("[u_0, ...]"),
            required("v", Takes::Scalars, "the knots in v").shown("[v_0, ...]"),
            required("net", Takes::Net, "the control points, rows in u").shown("[[d_00, d_01, ...], ...]"),
            named("weights=[[...], ...]", Takes::Rows, "all 1", "the weights of the points"),
            HOMOGENEOUS,
        ],
        summary: "the B-spline surface of degrees m and n with these knots and net",
        gives: Gives::Surface,
        example: "spline_surface(1, 1, [0, 0, 1, 2, 2], [0, 0, 1, 1], [[0, 1], [2, 3], [0, 1]])(1/2, 1)",
        call: |_, args| {
            let knots = |degree: usize, list: usize| {
                KnotVector::new(args.size(degree)?, args.scalars(list)?)
                    .map_err(spline_error)
                    .at(args.span(list))
            };
            let (u, v) = (knots(0, 2)?, knots(1, 3)?);
            let (net, form) = args.net(4)?;
            let s = SplineSurface::new(u, v, net).map_err(spline_error).at(args.span(4))?;
            Ok(surface(s, form))
        },
        ..NEW
    },
    Builtin {
        name: "boundary_curves",
        parameters: &[SURFACE],
        summary: "the boundary of a surface: u = a, u = b, v = c, v = d; or opposite the three corners",
        gives: Gives::Curves,
        example: "boundary_curves(patch([[0, 1], [2, 5]]))",
        call: |_, args| {
            let curves = match &*args.geometry(0)? {
                Geometry::Patch(patch, form) => [Side::UStart, Side::UEnd, Side::VStart, Side::VEnd]
                    .map(|side| bezier(patch.boundary_curve(side), *form))
                    .to_vec(),
                Geometry::Triangle(patch, form) => {
                    let mut curves = Vec::with_capacity(3);
                    for corner in [Corner::A, Corner::B, Corner::C] {
                        let points = patch.boundary(corner);
                        let curve = BezierCurve::new(points, Interval::unit());
                        curves.push(bezier(curve.map_err(curve_error)?, *form));
                    }
                    curves
                }
                Geometry::Surface(s, form) => edges(s, *form)?,
                other => {
                    return Err(Diagnostic::error(
                        Code::Type,
                        format!("expected a surface, not {}", other.kind()),
                    )
                    .at(args.span(0)));
                }
            };
            Ok(Value::list(curves))
        },
        ..NEW
    },
    Builtin {
        name: "normal",
        parameters: &[SURFACE],
        summary: "the cross product of the partial derivatives of a polynomial patch, as a patch",
        gives: Gives::Surface,
        example: "normal(patch([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]))(0, 0)",
        call: |_, args| match &*args.geometry(0)? {
            geometry if geometry.form().rational => {
                Err(Diagnostic::error(Code::NotPolynomial, "this surface is rational")
                    .at(args.span(0))
                    .hint("normal_at(s, u, v) is the normal at one point"))
            }
            Geometry::Patch(patch, _) => {
                patch.normal().map(|n| tensor(n, Form::default())).map_err(curve_error).at(args.span(0))
            }
            Geometry::Triangle(patch, _) => {
                patch.normal().map(|n| triangular(n, Form::default())).map_err(curve_error).at(args.span(0))
            }
            _ => {
                Err(wrong_kind("a patch", args.value(0)?).at(args.span(0)).hint("pieces(s) are its patches"))
            }
        },
        ..NEW
    },
    Builtin {
        name: "normal_at",
        parameters: &[
            GRAPH,
            required("u", Takes::Scalar, "the first parameter"),
            required("v", Takes::Scalar, "the second parameter"),
        ],
        summary: "the cross product of the partial derivatives of a surface at one point",
        gives: Gives::Point,
        example: "normal_at(patch([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]), 1, 1)",
        call: |_, args| {
            let (u, v) = (args.scalar(1)?, args.scalar(2)?);
            if let Value::List(_) = args.value(0)? {
                return normal_of_formulas(args);
            }
            let point = match &*args.geometry(0)? {
                Geometry::Patch(patch, form) => patch_normal(patch, *form, &u, &v),
                Geometry::Surface(s, form) => {
                    let patch = s.patch_at(&u, &v).map_err(spline_error).at(args.span(1))?;
                    patch_normal(&patch, *form, &u, &v)
                }
                Geometry::Triangle(patch, form) if form.rational => {
                    let patch = crate::math::curve::RationalTriangle::from_homogeneous(patch.clone());
                    patch.and_then(|patch| patch.normal_at(&[u, v]))
                }
                Geometry::Triangle(patch, _) => patch.normal().and_then(|n| Ok(n.value(&[u, v])?.position())),
                _ => return Err(wrong_kind("a patch", args.value(0)?).at(args.span(0))),
            };
            Ok(Form::default().plain(point.map_err(curve_error).at(args.span(0))?))
        },
        ..NEW
    },
    Builtin {
        name: "tangent_planes",
        parameters: &[SURFACE],
        summary: "the tangent planes of a patch as a patch of vectors (n, e): n x + e = 0",
        gives: Gives::Surface,
        example: "tangent_planes(patch([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]))(1, 1)",
        call: |_, args| {
            let Geometry::Patch(patch, form) = &*args.geometry(0)? else {
                return Err(wrong_kind("a tensor-product patch", args.value(0)?).at(args.span(0)));
            };
            let patch = match form.rational {
                true => RationalPatch::from_homogeneous(patch.clone()),
                false => {
                    let ones = patch.net().iter().map(|row| vec![Fraction::one(); row.len()]).collect();
                    RationalPatch::new(patch.net().to_vec(), ones, patch.u().clone(), patch.v().clone())
                }
            };
            let planes = patch.and_then(|patch| patch.tangent_planes());
            Ok(tensor(planes.map_err(curve_error).at(args.span(0))?, Form::default()))
        },
        ..NEW
    },
    Builtin {
        name: "twist",
        parameters: &[
            SURFACE,
            required("u", Takes::Scalar, "the first parameter"),
            required("v", Takes::Scalar, "the second parameter"),
        ],
        summary: "the mixed second derivative of a patch at one point",
        gives: Gives::Point,
        example: "twist(patch([[0, 1], [2, 5]]), 0, 0)",
        call: |_, args| {
            let (mut jet, form) = on_surface::partial_derivatives(args, 2)?;
            Ok(form.plain(jet.swap_remove(1).swap_remove(1)))
        },
        ..NEW
    },
];

pub(super) fn tensor(patch: TensorPatch<Fraction>, form: Form) -> Value {
    Value::Geometry(Arc::new(Geometry::Patch(patch, form)))
}

pub(super) fn triangular(patch: TrianglePatch<Fraction>, form: Form) -> Value {
    Value::Geometry(Arc::new(Geometry::Triangle(patch, form)))
}

pub(super) fn surface(s: SplineSurface<Fraction>, form: Form) -> Value {
    Value::Geometry(Arc::new(Geometry::Surface(s, form)))
}

/// The four boundary splines, where the knots are clamped.
fn edges(s: &SplineSurface<Fraction>, form: Form) -> Result<Vec<Value>, Diagnostic> {
    let clamped = |knots: &KnotVector<Fraction>| {
        let list = knots.knots();
        list[0] == list[knots.degree()] && list[knots.count()] == list[list.len() - 1]
    };
    let (u, v) = s.knots();
    if !clamped(u) || !clamped(v) {
        return Err(Diagnostic::error(Code::Unsupported, "the boundary of a surface with unclamped knots")
            .hint("repeat the end knots degree + 1 times, or take the patches: pieces(s)"));
    }
    let (rows, columns) = (s.net(), s.transposed());
    let curve = |knots: &KnotVector<Fraction>, points: &[Point<Fraction>]| {
        BSpline::new(knots.clone(), points.to_vec()).map(|s| spline(s, form)).map_err(spline_error)
    };
    let last = |net: &[Vec<Point<Fraction>>]| net[net.len() - 1].clone();
    Ok(vec![
        curve(v, &rows[0])?,
        curve(v, &last(rows))?,
        curve(u, &columns.net()[0])?,
        curve(u, &last(columns.net()))?,
    ])
}

/// The cross product of the partial derivatives of coordinates by formulas.
fn normal_of_formulas(args: &Arguments) -> Evaluated {
    let (jet, form) = on_surface::partial_derivatives(args, 1)?;
    Ok(form.plain(cross(&jet[1][0], &jet[0][1]).at(args.span(0))?))
}

/// The normal of a patch at one point.
fn patch_normal(
    patch: &TensorPatch<Fraction>,
    form: Form,
    u: &Fraction,
    v: &Fraction,
) -> Result<Vector<Fraction>, CurveError> {
    match form.rational {
        true => RationalPatch::from_homogeneous(patch.clone())?.normal_at(u, v),
        false => patch.normal().map(|n| n.value(u, v).position()),
    }
}

/// A patch as the first argument.
pub(super) fn polynomial_only(form: Form, args: &Arguments) -> Result<(), Diagnostic> {
    match form.rational {
        false => Ok(()),
        true => Err(Diagnostic::error(Code::NotPolynomial, "this surface is rational")
            .at(args.span(0))
            .hint("derivatives_at(s, u, v, k) are its derivatives at a point")),
    }
}
