//! Figures: from curves, functions and schemes to drawings.
//!
//! Each function makes one of [`crate::scene::pictures`] from its arguments. What a drawing cannot
//! show (symbols without values, points at infinity) is an error at the argument; schemes are
//! formulas and may have symbols.

mod curves;
mod functions;
mod numeric;
mod options;
mod schemes;
mod surfaces;

use super::Builtin;
use crate::language::ops::errors::wrong_kind;
use crate::language::value::Value;
use crate::scene::Scene;

const TOPIC: &str = "Figures";

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "figure_bezier",
        signature: curves::BEZIER,
        summary: "Bézier curves with control polygons, hulls, and points at parameters",
        example: "figure_bezier(bezier([[0, 0], [1, 3], [4, 4], [6, 1]]), at=1/2, hull=1)",
        topic: TOPIC,
        call: |_, args| curves::bezier(args),
    },
    Builtin {
        name: "figure_casteljau",
        signature: curves::CASTELJAU,
        summary: "all points of de Casteljau's algorithm, level by level",
        example: "figure_casteljau(bezier([[0, 0], [1, 3], [4, 4], [6, 1]]), 2/5)",
        topic: TOPIC,
        call: |_, args| curves::casteljau(args),
    },
    Builtin {
        name: "figure_bspline",
        signature: curves::BSPLINE,
        summary: "a spline by its pieces, with its control points and its knots on the curve",
        example: "figure_bspline(bspline(2, [0, 0, 0, 1, 2, 2, 2], [[0, 0], [1, 3], [4, 3], [5, 0]]))",
        topic: TOPIC,
        call: |_, args| curves::bspline(args),
    },
    Builtin {
        name: "figure_basis",
        signature: functions::BASIS,
        summary: "the Bernstein polynomials of degree n, or the B-splines over knots",
        example: "figure_basis(2, [0, 0, 0, 1, 3, 3, 3])",
        topic: TOPIC,
        call: |_, args| functions::basis(args),
    },
    Builtin {
        name: "figure_functions",
        signature: functions::FUNCTIONS,
        summary: "the graphs of polynomials and piecewise polynomials over [a, b]",
        example: "figure_functions([t^2, t^3 - t], -1, 1)",
        topic: TOPIC,
        call: |_, args| functions::functions(args),
    },
    Builtin {
        name: "figure_pyramid",
        signature: schemes::PYRAMID,
        summary: "de Casteljau's or de Boor's scheme, or divided differences, as a triangle",
        example: "figure_pyramid(bezier([b_0, b_1, b_2], r, s), t)",
        topic: TOPIC,
        call: |_, args| schemes::pyramid(args),
    },
    Builtin {
        name: "figure_continuity",
        signature: curves::CONTINUITY,
        summary: "two curves, and the construction that tells how smoothly they join",
        example: "figure_continuity(bezier([[0, 0], [1, 2], [2, 2]]), bezier([[2, 2], [3, 2], [4, 0]], 1, 2))",
        topic: TOPIC,
        call: |_, args| curves::continuity(args),
    },
    Builtin {
        name: "figure_hodograph",
        signature: curves::HODOGRAPH,
        summary: "a curve beside the curve of its derivatives",
        example: "figure_hodograph(bezier([[0, 0], [1, 3], [4, 4], [6, 1]]))",
        topic: TOPIC,
        call: |_, args| curves::hodograph(args),
    },
    Builtin {
        name: "figure_patch",
        signature: surfaces::PATCH,
        summary: "a tensor-product surface with its net of points, or of heights over a square",
        example: "figure_patch([[0, 2, 0], [1, 4, 1], [0, 2, 0]])",
        topic: TOPIC,
        call: |_, args| surfaces::patch(args),
    },
    Builtin {
        name: "figure_triangle",
        signature: surfaces::TRIANGLE,
        summary: "the polar values of a triangular surface of degree n, or one with these points",
        example: "figure_triangle(2, [r, s, t])",
        topic: TOPIC,
        call: |_, args| surfaces::triangle(args),
    },
    Builtin {
        name: "beside",
        signature: "beside(figure_1, ..., figure_k)",
        summary: "figures side by side",
        example: "beside(figure_basis(1), figure_basis(2))",
        topic: TOPIC,
        call: |_, args| {
            options::expect(args, "beside(figure_1, ..., figure_k)", 1..=8, &[])?;
            let mut scenes = Vec::with_capacity(args.len());
            for i in 0..args.len() {
                match args.value(i)? {
                    Value::Figure(scene) => scenes.push((**scene).clone()),
                    other => {
                        let error = wrong_kind("a figure", other).at(args.span(i));
                        return Err(error.hint("such as figure_basis(3)"));
                    }
                }
            }
            let all = scenes.into_iter().reduce(Scene::beside);
            options::finished(args, all.unwrap_or_else(|| Scene::new("")))
        },
    },
];
