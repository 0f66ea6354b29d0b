//! Lengths, areas and centroids; inflections; curves with Pythagorean hodographs; curvatures of surfaces.

use super::geometric::numeric;
use super::gives::Gives;
use super::intersections::{PLANE_CURVE, plane_pieces};
use super::on_surface::partial_derivatives;
use super::parameter::{CURVE, GRAPH, Parameter, named, optional, required};
use super::roots;
use super::{Builtin, by_pieces};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::{curve_error, wrong_kind};
use crate::language::ops::geometry::{bezier, cross, points_of};
use crate::language::ops::takes::Takes;
use crate::language::value::{Form, Value, in_letter};
use crate::math::curve::{self, AreaError, BezierCurve, Interval, Point};
use crate::math::number::{Rational, rational};
use crate::math::poly::{Coefficients, Fraction, Symbol};
use crate::math::ring::{Field, Ring};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Lengths and areas");

const SURFACES: Builtin = Builtin::about("Curvature");

const OUTLINE: Parameter = required(
    "outline",
    Takes::OneOf(&[Takes::Points, Takes::Curve, Takes::List]),
    "points, a closed curve of the plane or a list of curves",
)
.shown("[p_0, ..., p_m]");

const AT: [Parameter; 3] = [
    GRAPH,
    required("u", Takes::Scalar, "the first parameter"),
    required("v", Takes::Scalar, "the second parameter"),
];

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "area",
        parameters: &[OUTLINE],
        summary: "the area inside of a polygon or of closed curves, positive if they run counterclockwise",
        gives: Gives::Scalar,
        example: "area([[0, 0], [2, 0], [0, 3]])",
        call: |_, args| Ok(Value::Scalar(moments(args)?[0].clone())),
        ..NEW
    },
    Builtin {
        name: "centroid",
        parameters: &[OUTLINE],
        summary: "the centroid of the area inside of a polygon or of closed curves",
        gives: Gives::Point,
        example: "centroid([[0, 0], [2, 0], [0, 3]])",
        call: |_, args| {
            let [area, x, y] = moments(args)?;
            let inverse = area.inverse().ok_or_else(|| {
                Diagnostic::error(Code::Degenerate, "the area is 0")
                    .at(args.span(0))
                    .hint("give an outline with an area")
            })?;
            Ok(Form::default().plain(vec![x.times(&inverse), y.times(&inverse)]))
        },
        ..NEW
    },
    Builtin {
        name: "arc_length",
        parameters: &[
            CURVE,
            named("width=1/1000", Takes::Number, "1/1000", "how far the bounds may be apart"),
        ],
        summary: "the length of a curve: exactly where |c'| is a polynomial, else bounds [lower, upper]",
        gives: Gives::Point,
        example: "arc_length(bezier([[0, 0], [1, 1], [2, 0]]), width=1/50)",
        call: |machine, args| {
            let curve = numbers(args)?;
            let width = roots::width(args)?.unwrap_or_else(|| rational(1, 1000));
            let (lower, upper) = curve::arc_length(&curve, &width);
            if lower == upper {
                return Ok(Value::number(lower));
            }
            let note = "the length lies between these; it is the integral of a root";
            machine.note(Diagnostic::note(Code::Irrational, note).at(args.span(0)));
            Ok(Value::list(vec![Value::number(lower), Value::number(upper)]))
        },
        by_pieces: Some(by_pieces::sum),
        ..NEW
    },
    Builtin {
        name: "speed",
        parameters: &[CURVE],
        summary: "|c'| of a curve with a Pythagorean hodograph, as a polynomial up to its sign",
        gives: Gives::Scalar,
        example: "speed(pythagorean_curve(1, t))",
        call: |_, args| {
            let curve = numbers(args)?;
            let letter = Symbol::new("t");
            let found = curve::speed(&curve).map(|p| Value::Scalar(Fraction::from(in_letter(&p, &letter))));
            found.ok_or_else(|| {
                let message = "|c'|^2 is not the square of a polynomial: the hodograph is not Pythagorean";
                let error = Diagnostic::error(Code::Irrational, message).at(args.span(0));
                error.hint("arc_length(c) gives bounds of the length")
            })
        },
        ..NEW
    },
    Builtin {
        name: "pythagorean_curve",
        parameters: &[
            required("U", Takes::Polynomial, "a polynomial"),
            required("V", Takes::Polynomial, "another one"),
            optional("p", Takes::Point, "[0, 0]", "where the curve starts"),
        ],
        summary: "the curve over [0, 1] with the derivative (U^2 - V^2, 2 U V) and |c'| = U^2 + V^2",
        gives: Gives::Curve,
        example: "pythagorean_curve(1, t)",
        call: |_, args| pythagorean(args),
        ..NEW
    },
    Builtin {
        name: "offset",
        parameters: &[CURVE, required("d", Takes::Number, "the distance, positive to the left of a curve")],
        summary: "the curve at distance d, of a plane curve with a Pythagorean hodograph: it is rational",
        gives: Gives::Curve,
        example: "offset(pythagorean_curve(1, t), 1)",
        call: |_, args| {
            let curve = numbers(args)?;
            if curve.dimension() != 2 {
                let message =
                    format!("a curve of the plane is needed, this one has {} coordinates", curve.dimension());
                let error = Diagnostic::error(Code::Shape, message).at(args.span(0));
                return Err(error.hint("only plane curves have offsets to their left and right"));
            }
            let moved = curve::pythagorean_offset(&curve, &args.rational(1)?).ok_or_else(|| {
                let error = Diagnostic::error(Code::Irrational, "the offset of this curve is not rational");
                error
                    .at(args.span(0))
                    .reason("|c'|^2 is not the square of a polynomial that is not 0")
                    .hint("pythagorean_curve(U, V) makes curves whose offsets are rational")
            })?;
            let point =
                |p: &Point<Rational>| -> Point<Fraction> { p.iter().cloned().map(Fraction::from).collect() };
            let (a, b) = moved.interval().ends();
            let interval =
                Interval::new(Fraction::from(a.clone()), Fraction::from(b.clone())).map_err(curve_error)?;
            let moved = BezierCurve::new(moved.points().iter().map(point).collect(), interval)
                .map_err(curve_error)?;
            Ok(bezier(moved, Form { scalar: false, rational: true }))
        },
        ..NEW
    },
    Builtin {
        name: "inflections",
        parameters: &[PLANE_CURVE],
        summary: "the parameters at which the curvature of a plane curve changes its sign, exactly",
        gives: Gives::Scalars,
        example: "inflections(bezier([[0, 0], [1, 2], [2, -2], [3, 0]]))",
        call: |_, args| {
            let (pieces, _) = plane_pieces(args, 0)?;
            let letter = Symbol::new("t");
            let list = curve::inflections(&pieces).map_err(|curve::Straight(i)| {
                let which = if pieces.len() == 1 { "the curve".to_owned() } else { format!("piece {i}") };
                let error =
                    Diagnostic::error(Code::Degenerate, format!("{which} is straight")).at(args.span(0));
                error.hint("its curvature is 0 everywhere")
            })?;
            Ok(Value::List(list.into_iter().map(|t| Value::root(t, &letter)).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "gaussian_curvature",
        parameters: &AT,
        summary: "the Gaussian curvature (L N - M^2)/(E G - F^2) of a surface in space",
        gives: Gives::Scalar,
        example: "gaussian_curvature(patch([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]), 0, 0)",
        call: |_, args| {
            let forms = fundamental(args)?;
            let [l, m, n] = &forms.second;
            let inverse = forms.area.times(&forms.area).inverse().ok_or_else(|| flat(args))?;
            Ok(Value::Scalar(l.times(n).minus(&m.times(m)).times(&inverse)))
        },
        ..SURFACES
    },
    Builtin {
        name: "squared_mean_curvature",
        parameters: &AT,
        summary: "the square of the mean curvature (E N - 2 F M + G L)/(2 (E G - F^2)), which is rational",
        gives: Gives::Scalar,
        example: "squared_mean_curvature(patch([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]), 1, 1)",
        call: |_, args| {
            let forms = fundamental(args)?;
            let ([e, f, g], [l, m, n]) = (&forms.first, &forms.second);
            let sum = e.times(n).minus(&f.times(m).scaled(&rational(2, 1))).plus(&g.times(l));
            let below = forms.area.powered(3).scaled(&rational(4, 1));
            let inverse = below.inverse().ok_or_else(|| flat(args))?;
            Ok(Value::Scalar(sum.times(&sum).times(&inverse)))
        },
        ..SURFACES
    },
];

/// E, F, G; L, M, N times |n| for the normal n = s_u × s_v; and |n|² = E G − F².
struct Fundamental {
    first: [Fraction; 3],
    second: [Fraction; 3],
    area: Fraction,
}

fn fundamental(args: &Arguments) -> Result<Fundamental> {
    let (jet, _) = partial_derivatives(args, 2)?;
    let (u, v) = (&jet[1][0], &jet[0][1]);
    let normal = cross(u, v).at(args.span(0))?;
    let dot = |a: &[Fraction], b: &[Fraction]| {
        a.iter().zip(b).fold(Fraction::from(rational(0, 1)), |sum, (x, y)| sum.plus(&x.times(y)))
    };
    let first = [dot(u, u), dot(u, v), dot(v, v)];
    let second = [&jet[2][0], &jet[1][1], &jet[0][2]].map(|d| dot(d, &normal));
    let area = dot(&normal, &normal);
    Ok(Fundamental { first, second, area })
}

fn flat(args: &Arguments) -> Diagnostic {
    let error = Diagnostic::error(Code::Degenerate, "the partial derivatives are parallel or 0 there");
    error.at(args.span(1)).hint("derivatives_at(s, u, v, 1) shows them")
}

/// The polynomial curve at the first place, with numbers.
fn numbers(args: &Arguments) -> Result<BezierCurve<Rational>> {
    let (curve, form) = args.bezier(0)?;
    if form.rational {
        return Err(Diagnostic::error(Code::NotPolynomial, "this curve is rational")
            .at(args.span(0))
            .hint("a polynomial curve is needed"));
    }
    numeric(&curve).ok_or_else(|| {
        Diagnostic::error(Code::Type, "numbers are needed as control points")
            .at(args.span(0))
            .hint("give the symbols values first")
    })
}

/// The area and its moments in x and y.
fn moments(args: &Arguments) -> Result<[Fraction; 3]> {
    let outline = args.value(0)?;
    let curve = |item: &Value| matches!(item, Value::Geometry(geometry) if !geometry.is_surface());
    let curves: Vec<Value> = match outline {
        Value::List(items) if items.iter().any(curve) => items.to_vec(),
        one if curve(one) => vec![one.clone()],
        _ => return polygon(args, outline),
    };
    let mut list = Vec::new();
    for item in curves {
        list.extend(plane_pieces(&args.with_first(item), 0)?.0);
    }
    let sums = curve::green(&list).map_err(|error| no_area(error, list.len(), args))?;
    Ok(sums.map(Fraction::from))
}

/// Why a closed curve has no rational area.
fn no_area(error: AreaError, count: usize, args: &Arguments) -> Diagnostic {
    let which = |i: usize| if count == 1 { "the curve".to_owned() } else { format!("curve {}", i + 1) };
    let told = |code: Code, message: String| Diagnostic::error(code, message).at(args.span(0));
    match error {
        AreaError::Endless(i) => told(Code::Domain, format!("{} has no ends", which(i)))
            .hint("give it an interval: over([t, t^2], 0, 1), or control points"),
        AreaError::Apart(i) if count == 1 => {
            told(Code::Shape, format!("{} is not closed: it does not end where it starts", which(i)))
                .hint("close it: area([c, bezier([q, p])]) with the segment from its end q to its start p")
        }
        AreaError::Apart(i) => {
            let before = (i + count - 1) % count;
            told(Code::Shape, format!("{} does not start where {} ends", which(i), which(before)))
                .hint("give the curves in the order in which they are run through, and closed")
        }
        AreaError::Infinite(i) => told(Code::ZeroWeight, format!("{} goes through infinity", which(i)))
            .hint("give a part of it with positive weights"),
        AreaError::NotRational(i) => told(
            Code::Irrational,
            format!("the area below {} is no rational number", which(i)),
        )
        .reason("the antiderivative of (X Y' - Y X')/W^2 has logarithms or arcus tangents, as for circles")
        .hint("area takes polynomial curves, and rational ones whose integral is rational"),
    }
}

fn polygon(args: &Arguments, outline: &Value) -> Result<[Fraction; 3]> {
    let wrong = || wrong_kind("points of the plane or a closed curve", outline).at(args.span(0));
    let (points, _) = points_of(outline).ok_or_else(|| wrong().hint("area([[0, 0], [2, 0], [0, 3]])"))?;
    if points.len() == 3 && points.iter().any(|p| p.len() == 1) {
        let error = Diagnostic::error(Code::ControlPoints, "the points have no coordinates").at(args.span(0));
        return Err(error
            .reason("a symbol is a number here")
            .hint("write points by their coordinates: area([[x_1, y_1], [x_2, y_2], [x_3, y_3]])"));
    }
    if points.len() < 3 || points.iter().any(|p| p.len() != 2) {
        return Err(Diagnostic::error(
            Code::ControlPoints,
            "an outline has three points of the plane or more",
        )
        .at(args.span(0))
        .hint("area([[0, 0], [2, 0], [0, 3]])"));
    }
    Ok(curve::polygon_moments(&points))
}

fn pythagorean(args: &Arguments) -> Evaluated {
    let (u, v) = (args.univariate(0)?, args.univariate(1)?);
    if u.coefficients.len() > 1 && v.coefficients.len() > 1 && u.variable != v.variable {
        let message = format!("{} and {}: one variable is needed", u.variable, v.variable);
        return Err(Diagnostic::error(Code::AmbiguousVariable, message)
            .at(args.span(1))
            .hint("use t in both"));
    }
    let start = match args.given(2) {
        None => [0, 0].map(|x| Fraction::from(rational(x, 1))),
        Some((_, span)) => {
            let point: Vec<Fraction> = args.point(2)?.iter().cloned().collect();
            point.try_into().map_err(|_| {
                let error = Diagnostic::error(Code::Shape, "a point of the plane is needed").at(span);
                error.hint("such as [0, 0]")
            })?
        }
    };
    let (u, v) = (Coefficients::new(u.coefficients), Coefficients::new(v.coefficients));
    let power = curve::pythagorean_curve(&u, &v, start).map(|p| p.to_vec());
    let curve = BezierCurve::from_power(&power, Interval::unit()).map_err(curve_error)?;
    Ok(bezier(curve, Form::default()))
}
