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
use super::gives::Gives;
use super::parameter::{
    CURVE, DEGREE, Need, Parameter, SPAN, SPLINE, VARIABLE, many, named, optional, required,
};
use crate::language::ops::errors::wrong_kind;
use crate::language::ops::takes::Takes;
use crate::language::value::Value;
use crate::scene::Scene;

use crate::language::functions::notions::SCHEME;
use options::{COMMON, GRAPH_LABELS, LABELS, POLYGON, label_words};

const NEW: Builtin = Builtin { common: COMMON, gives: Gives::Figure, ..Builtin::about("Figures") };

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "figure_bezier",
        parameters: &[
            many("c_1, ..., c_k", Takes::Curve, 1, "the curves, those in lists too"),
            named("at=[t_1, ...]", Takes::ScalarOrList, "none", "parameters whose points are marked"),
            named("hull=1", Takes::Flag, "0", "whether the convex hull is drawn"),
            POLYGON,
            label_words("labels=polar", LABELS, "polar up to degree 5, else points"),
        ],
        summary: "Bézier curves with control polygons, hulls, and points at parameters",
        example: "figure_bezier(bezier([[0, 0], [1, 3], [4, 4], [6, 1]]), at=1/2, hull=1)",
        call: |_, args| curves::bezier(args),
        ..NEW
    },
    Builtin {
        name: "figure_casteljau",
        parameters: &[
            CURVE,
            required("t", Takes::Scalar, "the parameter"),
            label_words("labels=polar", LABELS, "polar up to degree 5, else points"),
        ],
        summary: "all points of de Casteljau's algorithm, level by level",
        example: "figure_casteljau(bezier([[0, 0], [1, 3], [4, 4], [6, 1]]), 2/5)",
        call: |_, args| curves::casteljau(args),
        ..NEW
    },
    Builtin {
        name: "figure_bspline",
        parameters: &[
            SPLINE,
            label_words("labels=polar", LABELS, "polar up to degree 5, else points"),
            named("bezier=1", Takes::Flag, "0", "whether the Bézier points of the pieces are drawn"),
        ],
        summary: "a spline by its pieces, with its control points and its knots on the curve",
        example: "figure_bspline(bspline(2, [0, 0, 0, 1, 2, 2, 2], [[0, 0], [1, 3], [4, 3], [5, 0]]))",
        call: |_, args| curves::bspline(args),
        ..NEW
    },
    Builtin {
        name: "figure_basis",
        parameters: &[
            DEGREE,
            optional("knots", Takes::Scalars, "Bernstein polynomials", "the knots of B-splines")
                .shown("[t_0, ..., t_k]"),
            label_words("labels=none", GRAPH_LABELS, "points up to 14 graphs"),
        ],
        summary: "the Bernstein polynomials of degree n, or the B-splines over knots",
        example: "figure_basis(2, [0, 0, 0, 1, 3, 3, 3])",
        call: |_, args| functions::basis(args),
        ..NEW
    },
    Builtin {
        name: "figure_functions",
        parameters: &[
            required("functions", Takes::OneOf(&[Takes::Coordinates, Takes::Curve]), "the functions")
                .shown("[F, G, ...]"),
            optional("a", Takes::Scalar, "where the functions start, or 0", "the start of the interval"),
            optional("b", Takes::Scalar, "where the functions end, or a + 1", "its end"),
            label_words("labels=none", GRAPH_LABELS, "points up to 14 graphs"),
            VARIABLE,
        ],
        summary: "the graphs of polynomials and piecewise polynomials over [a, b]",
        example: "figure_functions([t^2, t^3 - t], -1, 1)",
        call: |_, args| functions::functions(args),
        ..NEW
    },
    Builtin {
        name: "figure_pyramid",
        parameters: &[
            required(
                "c",
                Takes::OneOf(&[Takes::Curve, Takes::Scalars]),
                "the curve or spline, or a list of nodes",
            ),
            many(
                "u_1, ..., u_n",
                Takes::ScalarOrList,
                1,
                "one parameter, or as many as the degree; or the values at the nodes",
            ),
            label_words(
                "labels=values",
                &["polar", "points", "values"],
                "polar; values for divided differences of numbers, else points",
            ),
            named("weights=0", Takes::Flag, "1", "whether the weights stand at the arrows"),
            named(
                "apex=top",
                Takes::Word(&["right", "top", "bottom"]),
                "right",
                "where the last entry stands",
            ),
            SPAN,
        ],
        summary: "de Casteljau's or de Boor's scheme, or divided differences, as a triangle",
        example: "figure_pyramid(bezier([b_0, b_1, b_2], r, s), t)",
        call: |_, args| schemes::pyramid(args),
        ..NEW
    },
    Builtin {
        name: "figure_continuity",
        parameters: &[
            required("c", Takes::Curve, "the first curve"),
            required("d", Takes::Curve, "the second curve"),
            named("order=2", Takes::Size, "2", "the order up to which the construction is drawn"),
            label_words("labels=polar", LABELS, "polar up to degree 5, else points"),
        ],
        summary: "two curves, and the construction that tells how smoothly they join",
        example: "figure_continuity(bezier([[0, 0], [1, 2], [2, 2]]), bezier([[2, 2], [3, 2], [4, 0]], 1, 2))",
        call: |_, args| curves::continuity(args),
        ..NEW
    },
    Builtin {
        name: "figure_hodograph",
        parameters: &[CURVE, label_words("labels=points", LABELS, "points")],
        summary: "a curve beside the curve of its derivatives",
        example: "figure_hodograph(bezier([[0, 0], [1, 3], [4, 4], [6, 1]]))",
        call: |_, args| curves::hodograph(args),
        ..NEW
    },
    Builtin {
        name: "figure_subdivision",
        parameters: &[
            required("points", Takes::Points, "points of the plane").shown("[p_0, ..., p_m]"),
            required("scheme", SCHEME, "the subdivision scheme, or its mask"),
            optional("k", Takes::Size, "3", "how many steps, 8 at most"),
            named("closed=1", Takes::Flag, "0", "whether the last point is followed by the first one"),
            label_words("labels=points", GRAPH_LABELS, "points"),
        ],
        summary: "a polygon and those after each step of a subdivision scheme",
        example: "figure_subdivision([[0, 0], [1, 3], [4, 3], [5, 0]], chaikin, 3)",
        call: |_, args| schemes::subdivision(args),
        ..NEW
    },
    Builtin {
        name: "figure_patch",
        parameters: &[
            required(
                "net",
                Takes::OneOf(&[Takes::Net, Takes::Surface, Takes::List]),
                "the points or heights, or a patch",
            )
            .shown("[[b_00, ..., b_0n], ..., [b_m0, ..., b_mn]]"),
            label_words("labels=points", LABELS, "none"),
            named("polygon=0", Takes::Flag, "1 for points or heights", "whether the net is drawn"),
        ],
        summary: "a tensor-product surface with its net of points, or of heights over a square",
        example: "figure_patch([[0, 2, 0], [1, 4, 1], [0, 2, 0]])",
        call: |_, args| surfaces::patch(args),
        ..NEW
    },
    Builtin {
        name: "figure_triangle",
        parameters: &[
            required(
                "points",
                Takes::OneOf(&[Takes::Size, Takes::Points, Takes::Net, Takes::Surface]),
                "the degree, the points or heights, or a patch",
            )
            .shown("n or [b_n00, ..., b_00n]"),
            optional("corners", Takes::Scalars, "[r, s, t]", "the names of the corners").shown("[r, s, t]"),
            label_words("labels=points", LABELS, "polar for a degree or with corners, else none"),
            POLYGON,
        ],
        summary: "the polar values of a triangular surface of degree n, or one with these points",
        example: "figure_triangle(2, [r, s, t])",
        call: |_, args| surfaces::triangle(args),
        ..NEW
    },
    Builtin {
        name: "beside",
        parameters: &[Parameter {
            need: Need::Many(1, 8),
            ..many("figure_1, ..., figure_k", Takes::Figure, 1, "the figures")
        }],
        summary: "figures side by side",
        example: "beside(figure_basis(1), figure_basis(2))",
        call: |_, args| {
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
        ..NEW
    },
];
