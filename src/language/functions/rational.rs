//! Rational curves and surfaces: conics, circles, surfaces of revolution.

use super::curves::interval;
use super::differential::{PARAMETER, derivatives};
use super::gives::Gives;
use super::parameter::{CURVE, END, LINE, Parameter, START, named, required, size};
use super::solve::system_error;
use super::surfaces::{tensor, triangular};
use super::{Builtin, by_pieces, on_surface};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::ops::errors::{curve_error, wrong_kind};
use crate::language::ops::formula;
use crate::language::ops::geometry::{as_rational_form, bezier, points_of, scalar_list};
use crate::language::ops::takes::{Takes, word_of};
use crate::language::value::{Form, Geometry, Value};
use crate::math::curve::{
    self, CircleArc, ConicKind, ImplicitConic, Interval, Point, RationalCurve, RationalPatch,
};
use crate::math::number::integer;
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};
use crate::math::ring::{Field, Ring};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Rational curves and surfaces");

const RATIONAL: Form = Form { scalar: false, rational: true };

const ARC_FORMS: &[&str] = &["standard", "rational"];
const CIRCLE_FORMS: &[&str] = &["quintic", "quartic", "quarters", "thirds"];
const OCTANT_FORMS: &[&str] = &["tensor", "triangle"];

const THREE: Parameter = required("points", Takes::Points, "the control points").shown("[p_0, p_1, p_2]");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "conic_arc",
        parameters: &[THREE, required("w", Takes::Scalar, "the weight of p_1")],
        summary: "the conic of three points with weights 1, w, 1",
        gives: Gives::Curve,
        example: "conic_arc([[1, 0], [1, 1], [0, 1]], 1)(1/2)",
        call: |_, args| {
            let arc = curve::conic_arc(three_points(args, 0)?, args.scalar(1)?);
            arc.map(rational).map_err(curve_error).at(args.span(0))
        },
        ..NEW
    },
    Builtin {
        name: "conic_through",
        parameters: &[THREE, required("q", Takes::Point, "the point")],
        summary: "the conic from p_0 to p_2 with tangents towards p_1 that passes through q",
        gives: Gives::Curve,
        example: "conic_through([[1, 0], [1, 1], [0, 1]], [3/5, 4/5])",
        call: |_, args| {
            let arc = curve::conic_through(three_points(args, 0)?, &args.point(1)?);
            arc.map(rational).map_err(curve_error).at(args.span(1))
        },
        ..NEW
    },
    Builtin {
        name: "conic_kind",
        parameters: &[CURVE],
        summary: "ellipse, parabola or hyperbola: w_1^2 less than, equal to or greater than w_0 w_2",
        gives: Gives::Text,
        example: "conic_kind(conic_arc([[1, 0], [1, 1], [0, 1]], 1/2))",
        call: |_, args| {
            let curve = rational_curve(args, 0)?;
            if curve.degree() != 2 {
                return Err(Diagnostic::error(
                    Code::Shape,
                    format!("a conic has degree 2, this curve has degree {}", curve.degree()),
                )
                .at(args.span(0))
                .hint("conic_arc([p_0, p_1, p_2], w) makes one"));
            }
            let kind = curve::conic_kind(&curve).map_err(curve_error).at(args.span(0))?;
            let word = match kind {
                Some(ConicKind::Ellipse) => "an ellipse",
                Some(ConicKind::Parabola) => "a parabola",
                Some(ConicKind::Hyperbola) => "a hyperbola",
                Some(ConicKind::Line) => "a line",
                None => {
                    return Err(Diagnostic::error(Code::Undecided, "the kind depends on symbols")
                        .at(args.span(0))
                        .hint("give the weights values first"));
                }
            };
            Ok(Value::Text(word.to_owned()))
        },
        ..NEW
    },
    Builtin {
        name: "implicit_conic",
        parameters: &[CURVE],
        summary: "the polynomial in x and y that vanishes on a rational quadratic curve of the plane",
        gives: Gives::Scalar,
        example: "implicit_conic(bezier([[1, 0], [1, 1], [0, 1]], weights=[1, 1, 2]))",
        call: |_, args| {
            let conic = ImplicitConic::new(&rational_curve(args, 0)?).map_err(curve_error).at(args.span(0))?;
            let symbol = |name: &str| Fraction::from(MultiPoly::symbol(Symbol::new(name)));
            let value = conic.value(&[symbol("x"), symbol("y")]).map_err(curve_error)?;
            // The equation is meant up to a factor.
            Ok(Value::Scalar(
                value.as_polynomial().map_or_else(|| value.clone(), |p| Fraction::from(p.primitive_part())),
            ))
        },
        ..NEW
    },
    Builtin {
        name: "implicit",
        parameters: &[required(
            "curve",
            Takes::OneOf(&[Takes::Curve, Takes::Coordinates]),
            "a Bézier curve, or its coordinates as formulas",
        )
        .shown("c")],
        summary: "the polynomial in x and y that is 0 on a plane curve; in space, several in x, y and z",
        gives: Gives::Any,
        example: "implicit([t^2 - 1, t^3 - t])",
        call: |_, args| implicit(args),
        by_pieces: Some(by_pieces::each),
        ..NEW
    },
    Builtin {
        name: "conic_centre",
        parameters: &[CURVE],
        summary: "the centre of symmetry of a conic of the plane; a parabola has none",
        gives: Gives::Point,
        example: "conic_centre(bezier([[1, 0], [1, 1], [0, 1]], weights=[1, 1, 2]))",
        call: |_, args| {
            let conic = ImplicitConic::new(&rational_curve(args, 0)?).map_err(curve_error).at(args.span(0))?;
            conic.centre().map(|centre| Form::default().plain(centre)).ok_or_else(|| {
                Diagnostic::error(Code::Degenerate, "a parabola has no centre").at(args.span(0))
            })
        },
        ..NEW
    },
    Builtin {
        name: "circle_arc",
        parameters: &[
            required("m", Takes::Point, "the centre"),
            required("p", Takes::Point, "the start"),
            required("q", Takes::Point, "the end"),
            named(
                "form=standard",
                Takes::Word(ARC_FORMS),
                "standard",
                "which end weights: 1 and 1, or rational",
            ),
            named("long=1", Takes::Flag, "0", "whether it is the longer of the two arcs"),
        ],
        summary: "the arc of the circle about m from p to q; form=rational for other end weights",
        gives: Gives::Curve,
        example: "circle_arc([0, 0], [1, 0], [7/25, 24/25])",
        call: |_, args| {
            let arc = CircleArc::new(args.point(0)?, args.point(1)?, args.point(2)?);
            let shorter = arc.map_err(circle_error).at(args.span(2))?;
            let arc = if args.flag("long")? { shorter.complement() } else { shorter };
            match form(args) {
                "standard" => arc.standard().map(rational).map_err(|error| {
                    let squared = arc.squared_weight();
                    curve_error(error)
                        .at(args.span(2))
                        .hint(format!("with weights 1, w, 1 it has w^2 = {squared}"))
                        .hint("form=rational gives the same arc with other end weights")
                }),
                _ => Ok(rational(arc.rational())),
            }
        },
        ..NEW
    },
    Builtin {
        name: "circle",
        parameters: &[
            required("m", Takes::Point, "the centre"),
            required("p", Takes::Point, "a point of the circle, or its radius"),
            named(
                "form=quintic",
                Takes::Word(CIRCLE_FORMS),
                "quintic",
                "one curve of degree 5 or 4, or four or three arcs",
            ),
        ],
        summary: "the circle about m through p: quintic or quartic as one curve, quarters or thirds",
        gives: Gives::Curve,
        example: "circle([0, 0], [1, 0])(1/2)",
        call: |_, args| {
            let m = args.point(0)?;
            let p = match (args.value(1)?, &m[..]) {
                (Value::Scalar(radius), [x, y]) => [x.plus(radius), y.clone()].into(),
                _ => args.point(1)?,
            };
            let list = |pieces: Vec<RationalCurve<Fraction>>| {
                Value::List(pieces.into_iter().map(rational).collect())
            };
            let circle = match form(args) {
                "quintic" => curve::circle_quintic(&m, &p).map(rational),
                "quartic" => curve::full_circle(&m, &p).map(rational),
                "quarters" => curve::circle_quarters(&m, &p).map(list),
                _ => curve::circle_thirds(&m, &p).map(list),
            };
            circle.map_err(circle_error).at(args.span(1))
        },
        ..NEW
    },
    Builtin {
        name: "standard_form",
        parameters: &[CURVE],
        summary: "the same rational curve with both end weights 1, where the root is rational",
        gives: Gives::Curve,
        example: "standard_form(bezier([0, 1, 2], weights=[1, 2, 4]))",
        call: |_, args| {
            let curve = rational_curve(args, 0)?.standard_form().map_err(curve_error).at(args.span(0))?;
            Ok(bezier(curve.homogeneous().clone(), args.bezier(0)?.1))
        },
        ..NEW
    },
    Builtin {
        name: "shape_invariants",
        parameters: &[CURVE],
        summary: "the quotients w_(i-1) w_(i+1)/w_i^2, which no change of parameter alters",
        gives: Gives::Scalars,
        example: "shape_invariants(bezier([0, 1, 2], weights=[1, 2, 3]))",
        call: |_, args| {
            rational_curve(args, 0)?.shape_invariants().map(scalar_list).map_err(curve_error).at(args.span(0))
        },
        ..NEW
    },
    Builtin {
        name: "farin_points",
        parameters: &[CURVE],
        summary: "the weight points (w_i b_i + w_(i+1) b_(i+1))/(w_i + w_(i+1)) on the control polygon",
        gives: Gives::Points,
        example: "farin_points(bezier([0, 1, 2], weights=[1, 2, 1]))",
        call: |_, args| {
            let form = Form { rational: false, ..args.bezier(0)?.1 };
            let points = rational_curve(args, 0)?.farin_points().map_err(curve_error).at(args.span(0))?;
            Ok(Value::List(points.into_iter().map(|point| form.plain(point)).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "from_farin_points",
        parameters: &[
            required("points", Takes::Points, "the control points").shown("[p_0, ..., p_n]"),
            required("farin", Takes::Points, "a point on each edge").shown("[q_1, ..., q_n]"),
            START,
            END,
        ],
        summary: "the rational curve with these control points and Farin points, and w_0 = 1",
        gives: Gives::Curve,
        example: "farin_points(from_farin_points([[0, 0], [3, 0], [3, 3]], [[2, 0], [3, 1]]))",
        call: |_, args| {
            let ((points, form), (farin, _)) = (args.control_points(0)?, args.control_points(1)?);
            let curve = RationalCurve::from_farin_points(points, &farin, interval(args, 2)?);
            let curve = curve.map_err(curve_error).at(args.span(1))?;
            Ok(bezier(curve.homogeneous().clone(), Form { rational: true, ..form }))
        },
        ..NEW
    },
    Builtin {
        name: "derivatives_at",
        parameters: &[LINE, PARAMETER, size("k", "the highest order")],
        summary: "value and derivatives up to order k of a curve at t, or of a surface: (s, u, v, k)",
        gives: Gives::List,
        example: "derivatives_at(bezier([[1, 0], [1, 1], [0, 1]], weights=[1, 1, 2]), 0, 2)",
        on_surface: on_surface::DERIVATIVES_AT,
        call: |_, args| {
            let order = args.size(2)?;
            let (list, form) = derivatives(args, order)?;
            Ok(Value::List(list.into_iter().map(|vector| form.plain(vector)).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "sphere_octant",
        parameters: &[
            required("m", Takes::Point, "the centre"),
            required("r", Takes::Scalar, "the radius"),
            named(
                "form=tensor",
                Takes::Word(OCTANT_FORMS),
                "tensor",
                "a biquadratic patch, or a triangular one of degree 4",
            ),
        ],
        summary: "an octant of a sphere: a biquadratic patch, or form=triangle of degree 4",
        gives: Gives::Surface,
        example: "sphere_octant([0, 0, 0], 1)(1/2, 1/2)",
        call: |_, args| {
            let (m, r) = (args.point(0)?, args.scalar(1)?);
            match form(args) {
                "tensor" => {
                    let patch = curve::sphere_octant(&m, &r).map_err(circle_error).at(args.span(1))?;
                    Ok(tensor(patch.homogeneous().clone(), RATIONAL))
                }
                _ => {
                    let unit = curve::Triangle::unit();
                    let patch =
                        curve::sphere_octant_triangle(&m, &r, unit).map_err(curve_error).at(args.span(0))?;
                    Ok(triangular(patch.homogeneous().clone(), RATIONAL))
                }
            }
        },
        ..NEW
    },
    Builtin {
        name: "revolve",
        parameters: &[
            required(
                "curve",
                Takes::Any,
                "a profile (x, z), or with an axis a curve in space; a spline gives more patches",
            )
            .shown("c"),
            named("axis=[p, q]", Takes::Points, "the z axis", "two points of the axis"),
        ],
        summary: "the surface of revolution of a profile (x, z) about the z axis, or any axis: four patches",
        gives: Gives::Surfaces,
        example: "revolve(bezier([[2, 0], [0, 1]]))",
        call: |_, args| revolve(args),
        ..NEW
    },
];

/// A rational patch as a value.
pub(super) fn turned(patch: RationalPatch<Fraction>) -> Value {
    tensor(patch.homogeneous().clone(), RATIONAL)
}

fn revolve(args: &Arguments) -> Result<Value> {
    let curves: Vec<RationalCurve<Fraction>> = match args.value(0)? {
        Value::Geometry(geometry) if let Geometry::Spline(s, form) = &**geometry => {
            let pieces = s.bezier_pieces().into_iter();
            let pieces = pieces.map(|piece| RationalCurve::from_homogeneous(as_rational_form(&piece, *form)));
            pieces.collect::<std::result::Result<_, _>>().map_err(curve_error).at(args.span(0))?
        }
        _ => vec![rational_curve(args, 0)?],
    };
    let patches: std::result::Result<Vec<_>, _> = match args.named("axis") {
        None => curves.iter().map(curve::revolve).collect(),
        Some((value, span)) => {
            let points = points_of(value).map(|(points, _)| points).and_then(|list| list.try_into().ok());
            let [p, q]: [Point<Fraction>; 2] = points.ok_or_else(|| {
                wrong_kind("two points of the axis", value).at(span).hint("axis=[[0, 0, 0], [1, 1, 0]]")
            })?;
            if p == q {
                let error = Diagnostic::error(Code::Degenerate, "the two points of the axis are the same");
                return Err(error.at(span).hint("give two different points: axis=[[0, 0, 0], [0, 0, 1]]"));
            }
            curves.iter().map(|curve| curve::revolve_about(curve, &p, &q)).collect()
        }
    };
    let patches = patches.map_err(curve_error).at(args.span(0))?;
    Ok(Value::list(patches.into_iter().flatten().map(turned).collect()))
}

fn rational(curve: RationalCurve<Fraction>) -> Value {
    bezier(curve.homogeneous().clone(), RATIONAL)
}

/// A Bézier curve as a rational one.
pub(super) fn rational_curve(args: &Arguments, i: usize) -> Result<RationalCurve<Fraction>> {
    let (curve, form) = args.bezier(i)?;
    RationalCurve::from_homogeneous(as_rational_form(&curve, form)).map_err(curve_error).at(args.span(i))
}

fn three_points(args: &Arguments, i: usize) -> Result<[Point<Fraction>; 3]> {
    let (points, _) = args.control_points(i)?;
    let given = points.len();
    <[Point<Fraction>; 3]>::try_from(points).map_err(|_| {
        Diagnostic::error(Code::ControlPoints, format!("a conic has 3 control points, not {given}"))
            .at(args.span(i))
    })
}

/// Degenerate circles have words of their own.
fn circle_error(error: curve::CurveError) -> Diagnostic {
    match error {
        curve::CurveError::Degenerate => {
            Diagnostic::error(Code::Degenerate, "the radius is 0, or both ends are the same point")
                .hint("choose two different points at one positive distance from the centre")
        }
        other => curve_error(other),
    }
}

/// The word given as `form=…`.
fn form(args: &Arguments) -> &str {
    args.named("form").and_then(|(value, _)| word_of(value)).unwrap_or_default()
}

/// Homogeneous coordinates by powers, and the interval of the curve, if it has one.
type Homogeneous = (Vec<Vec<Fraction>>, Option<Interval<Fraction>>);

/// Homogeneous coordinates by powers, of a Bézier curve or of coordinates as formulas; and its interval, if it has one.
pub(super) fn homogeneous_coordinates(args: &Arguments, i: usize) -> Result<Homogeneous> {
    if let Some((t, formulas)) = formula::curve_of(args.value(i)?).at(args.span(i))? {
        return Ok((formula::over_one_weight(&formulas, &t).at(args.span(i))?, None));
    }
    let (curve, form) = args.bezier(i)?;
    let mut power = curve.power();
    if !form.rational {
        power.push(vec![Fraction::from(integer(1))]);
    }
    Ok((power, Some(curve.interval().clone())))
}

/// The irreducible equation of a plane curve; equations of one in space.
fn implicit(args: &Arguments) -> Result<Value> {
    let (coordinates, _) = homogeneous_coordinates(args, 0)?;
    let letters = ["x", "y", "z"].map(Symbol::new);
    let dimension = coordinates.len() - 1;
    if !(2..=3).contains(&dimension) {
        let message =
            format!("a curve of the plane or of space is needed, this one has {dimension} coordinates");
        let error = Diagnostic::error(Code::Shape, message).at(args.span(0));
        return Err(error.hint("such as implicit([t^2, t^3])"));
    }
    if coordinates.iter().flatten().any(|c| c.variables().iter().any(|s| letters[..dimension].contains(s))) {
        let shown = if dimension == 2 { "x and y" } else { "x, y and z" };
        let error = Diagnostic::error(Code::Domain, format!("{shown} are the coordinates of the equation"));
        return Err(error.at(args.span(0)).hint("choose other letters for the control points"));
    }
    match <[Vec<Fraction>; 3]>::try_from(coordinates) {
        Ok(coordinates) => {
            let found =
                curve::implicit_equation(&coordinates, [&letters[0], &letters[1]]).ok_or_else(|| {
                    let error =
                        Diagnostic::error(Code::Degenerate, "the curve is a single point").at(args.span(0));
                    error.hint("a point has no single equation; give a curve")
                })?;
            Ok(Value::Scalar(Fraction::from(found)))
        }
        Err(coordinates) => {
            let t = Symbol::new("\u{25e6}");
            let value = |list: &Vec<Fraction>| {
                Coefficients::new(list.clone()).value(&Fraction::from(MultiPoly::symbol(t.clone())))
            };
            let weight = value(&coordinates[dimension]).inverse().ok_or_else(|| {
                Diagnostic::error(Code::ZeroWeight, "the weight of every point is 0").at(args.span(0))
            })?;
            let list: Vec<Fraction> =
                coordinates[..dimension].iter().map(|x| value(x).times(&weight)).collect();
            let found = curve::curve_equations(&list, &t, &letters).map_err(system_error).at(args.span(0))?;
            Ok(Value::list(found.into_iter().map(|f| Value::Scalar(Fraction::from(f))).collect()))
        }
    }
}
