//! Surfaces made of curves: ruled, swept, blended and turned.

use std::sync::Arc;

use super::Builtin;
use super::by_pieces::pieces_of;
use super::gives::Gives;
use super::joins::polynomial_pair;
use super::parameter::{Parameter, required};
use super::rational::turned;
use super::surfaces::tensor;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::{curve_error, spline_error, wrong_kind};
use crate::language::ops::geometry::{as_rational_form, as_spline};
use crate::language::ops::takes::Takes;
use crate::language::value::{Form, Geometry, Value};
use crate::math::curve::{self, BezierCurve, CurveError, Interval, Point, RationalCurve};
use crate::math::poly::{Coefficients, Fraction};
use crate::math::ring::Ring;
use crate::math::spline::{BSpline, SplineError, SplineSurface, coons_spline, ruled_spline};
use num_traits::Zero;

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Surfaces");

const FIRST: Parameter = required("c", Takes::Curve, "a curve in u");

const SECOND: Parameter = required("d", Takes::Curve, "the other curve");

pub(super) const BOUNDARY: &[Parameter] = &[
    required("bottom", Takes::Curve, "the boundary curve in u where v starts").shown("c_0"),
    required("top", Takes::Curve, "the one where v ends").shown("c_1"),
    required("left", Takes::Curve, "the boundary curve in v where u starts").shown("d_0"),
    required("right", Takes::Curve, "the one where u ends").shown("d_1"),
];

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "ruled",
        parameters: &[FIRST, SECOND],
        summary: "the ruled surface (1 - v) c(u) + v d(u) of two curves or splines, rational ones too",
        gives: Gives::Surface,
        example: "ruled(bezier([[0, 0, 0], [1, 0, 0]]), bezier([[0, 1, 0], [1, 1, 1]]))",
        call: |_, args| ruled(args),
        ..NEW
    },
    Builtin {
        name: "sweep",
        parameters: &[FIRST, required("d", Takes::Curve, "the curve along which it is moved, in v")],
        summary: "the surface c(u) + d(v) - d(a) that c sweeps when it is moved along d from where d starts",
        gives: Gives::Surface,
        example: "sweep(bezier([[0, 0, 0], [1, 0, 0]]), bezier([[0, 0, 0], [0, 1, 1], [0, 2, 0]]))",
        call: |_, args| {
            let (c, d, form) = pair(args)?;
            curve::swept_surface(&c, &d).map(|s| tensor(s, form)).map_err(curve_error).at(args.span(1))
        },
        ..NEW
    },
    Builtin {
        name: "coons",
        parameters: BOUNDARY,
        summary: "Coons' bilinearly blended surface of four boundary curves that meet at the corners",
        gives: Gives::Surface,
        example: "coons(bezier([[0, 0], [1, 0]]), bezier([[0, 1], [1, 1]]), bezier([[0, 0], [0, 1]]), bezier([[1, 0], [2, 1], [1, 1]]))",
        call: |_, args| {
            if (0..4).any(|i| args.value(i).is_ok_and(|value| pieces_of(value).is_some())) {
                return coons_of_splines(args);
            }
            let (_, surface, form) = coons(args)?;
            Ok(tensor(surface, form))
        },
        ..NEW
    },
    Builtin {
        name: "gordon",
        parameters: &[
            required("curves", Takes::List, "curves in u").shown("[c_0, ..., c_m]"),
            required("v", Takes::Scalars, "the v of each of them").shown("[v_0, ..., v_m]"),
            required("others", Takes::List, "curves in v").shown("[d_0, ..., d_n]"),
            required("u", Takes::Scalars, "the u of each of them").shown("[u_0, ..., u_n]"),
        ],
        summary: "Gordon's surface through a network of curves that meet: c_j(u_i) = d_i(v_j)",
        gives: Gives::Surface,
        example: "gordon([bezier([0, 2, 0]), bezier([1, 1])], [0, 1], [bezier([0, 1]), bezier([0, 3, 1])], [0, 1])",
        call: |_, args| {
            let ((in_u, left), (in_v, right)) = (family(args, 0)?, family(args, 2)?);
            let form = Form { scalar: left && right, rational: false };
            they_meet(args, &in_u, &in_v)?;
            let s = curve::gordon_surface(&in_u, &args.scalars(1)?, &in_v, &args.scalars(3)?);
            s.map(|s| tensor(s, form)).map_err(network_error).at(args.span(0).to(args.span(3)))
        },
        ..NEW
    },
    Builtin {
        name: "torus",
        parameters: &[
            required("R", Takes::Scalar, "the distance of the circle from the axis"),
            required("r", Takes::Scalar, "the radius of the circle"),
        ],
        summary: "the torus about the z axis as 16 rational patches of degrees 2 and 2",
        gives: Gives::Surfaces,
        example: "torus(3, 1)",
        call: |_, args| {
            let (distance, radius) = (args.scalar(0)?, args.scalar(1)?);
            if radius.is_zero() {
                let error = Diagnostic::error(Code::Degenerate, "the radius is 0").at(args.span(1));
                return Err(error.hint("a circle has a radius: torus(3, 1)"));
            }
            let centre = [distance.clone(), Fraction::zero()];
            let start = [distance.plus(&radius), Fraction::zero()];
            let quarters: Vec<RationalCurve<Fraction>> =
                curve::circle_quarters(&centre, &start).map_err(curve_error)?.into_iter().collect();
            let patches = quarters.iter().map(curve::revolve).collect::<std::result::Result<Vec<_>, _>>();
            let patches = patches.map_err(curve_error).at(args.span(0))?;
            Ok(Value::List(patches.into_iter().flatten().map(turned).collect()))
        },
        ..NEW
    },
];

/// The lines between points with the same parameter. Rational curves with the same weights share their homogeneous coordinates; with
/// others (1 − v) X/W + v Y/Z is ((1 − v) X Z + v Y W)/(W Z).
fn ruled(args: &Arguments) -> Evaluated {
    if [0, 1].iter().any(|&i| args.value(i).is_ok_and(|value| pieces_of(value).is_some())) {
        let ((c, left), (d, right)) = (spline_at(args, 0)?, spline_at(args, 1)?);
        let form = polynomial_pair(args, left, right)?;
        let s = ruled_spline(&c, &d, &Interval::unit()).map_err(spline_error).at(args.span(1))?;
        return Ok(spline_surface(s, form));
    }
    let ((c, left), (d, right)) = (args.bezier(0)?, args.bezier(1)?);
    let form = Form { scalar: left.scalar && right.scalar, rational: left.rational || right.rational };
    if !form.rational {
        return curve::ruled_surface(&c, &d).map(|s| tensor(s, form)).map_err(curve_error).at(args.span(1));
    }
    let (c, d) = (as_rational_form(&c, left), as_rational_form(&d, right));
    let n = c.degree().max(d.degree());
    let (c, d) = (c.elevate(n - c.degree()), d.elevate(n - d.degree()));
    let last = c.dimension() - 1;
    let same = c.points().iter().zip(d.points()).all(|(p, q)| p.last() == q.last());
    let (c, d) = if same || d.dimension() != last + 1 {
        (c, d)
    } else {
        (times_weight(&c, &d)?, times_weight(&d, &c)?)
    };
    curve::ruled_surface(&c, &d).map(|s| tensor(s, form)).map_err(curve_error).at(args.span(1))
}

/// Homogeneous coordinates times the weight of another curve over an interval of the same length.
fn times_weight(c: &BezierCurve<Fraction>, d: &BezierCurve<Fraction>) -> Result<BezierCurve<Fraction>> {
    let weight = |p: &Point<Fraction>| -> Point<Fraction> { vec![p[p.len() - 1].clone(); p.len()].into() };
    let weights = BezierCurve::new(d.points().iter().map(weight).collect(), c.interval().clone())
        .map_err(curve_error)?;
    let product =
        |(x, w): (Vec<Fraction>, Vec<Fraction>)| Coefficients::new(x).times(&Coefficients::new(w)).to_vec();
    let power: Vec<Vec<Fraction>> = c.power().into_iter().zip(weights.power()).map(product).collect();
    BezierCurve::from_power(&power, c.interval().clone()).map_err(curve_error)
}

/// A curve of any kind as a spline.
fn spline_at(args: &Arguments, i: usize) -> Result<(BSpline<Fraction>, Form)> {
    if pieces_of(args.value(i)?).is_some() {
        return args.spline(i);
    }
    let (curve, form) = args.bezier(i)?;
    Ok((as_spline(&curve).map_err(spline_error).at(args.span(i))?, form))
}

fn spline_surface(s: SplineSurface<Fraction>, form: Form) -> Value {
    Value::Geometry(Arc::new(Geometry::Surface(s, form)))
}

/// Coons' surface where some of the boundary curves are splines.
fn coons_of_splines(args: &Arguments) -> Evaluated {
    let mut scalar = true;
    let mut one = |i: usize| {
        let (s, form) = spline_at(args, i)?;
        polynomial(args, i, form)?;
        scalar &= form.scalar;
        Ok(s)
    };
    let (in_u, in_v) = ([one(0)?, one(1)?], [one(2)?, one(3)?]);
    let surface = coons_spline(&in_u, &in_v).map_err(|error| match error {
        SplineError::Curve(error) => network_error(error),
        error => spline_error(error),
    });
    let form = Form { scalar, rational: false };
    surface.map(|s| spline_surface(s, form)).at(args.span(0).to(args.span(3)))
}

/// Tells the first two curves of a network that do not meet where they should.
fn they_meet(args: &Arguments, in_u: &[BezierCurve<Fraction>], in_v: &[BezierCurve<Fraction>]) -> Result<()> {
    let (v, u) = (args.scalars(1)?, args.scalars(3)?);
    for (j, c) in in_u.iter().enumerate().take(v.len()) {
        for (i, d) in in_v.iter().enumerate().take(u.len()) {
            let (p, q) = (c.value(&u[i]), d.value(&v[j]));
            if p.len() == q.len() && p != q {
                let shown = |p: &Point<Fraction>| {
                    crate::language::write::text(&Form::default().plain(p.clone()).to_expr())
                };
                let message = format!("curve {j} in u and curve {i} in v do not meet");
                return Err(Diagnostic::error(Code::Coincident, message)
                    .at(args.span(0).to(args.span(3)))
                    .reason(format!(
                        "at u = {} the one is at {}, at v = {} the other one at {}",
                        u[i],
                        shown(&p),
                        v[j],
                        shown(&q)
                    ))
                    .hint(
                        "a curve in u for v_j has at u_i the point that the curve in v for u_i has at v_j",
                    ));
            }
        }
    }
    Ok(())
}

/// Two curves in u, two in v, and Coons' surface of them.
#[expect(clippy::type_complexity, reason = "the curves by their parameter")]
pub(super) fn coons(
    args: &Arguments,
) -> Result<([[BezierCurve<Fraction>; 2]; 2], curve::TensorPatch<Fraction>, Form)> {
    let mut scalar = true;
    let mut one = |i: usize| {
        let (curve, form) = args.bezier(i)?;
        polynomial(args, i, form)?;
        scalar &= form.scalar;
        Ok(curve)
    };
    let (in_u, in_v) = ([one(0)?, one(1)?], [one(2)?, one(3)?]);
    let ends = |curve: &BezierCurve<Fraction>| {
        let (a, b) = curve.interval().ends();
        [a.clone(), b.clone()]
    };
    let surface = curve::gordon_surface(&in_u, &ends(&in_v[0]), &in_v, &ends(&in_u[0]));
    let surface = surface.map_err(network_error).at(args.span(0).to(args.span(3)))?;
    Ok(([in_u, in_v], surface, Form { scalar, rational: false }))
}

fn polynomial(args: &Arguments, i: usize, form: Form) -> Result<()> {
    match form.rational {
        false => Ok(()),
        true => Err(Diagnostic::error(Code::NotPolynomial, "this curve is rational").at(args.span(i)).hint(
            "for homogeneous(c) the surface is that of the homogeneous coordinates: of ruled surfaces the same",
        )),
    }
}

fn pair(args: &Arguments) -> Result<(BezierCurve<Fraction>, BezierCurve<Fraction>, Form)> {
    let ((c, left), (d, right)) = (args.bezier(0)?, args.bezier(1)?);
    let form = polynomial_pair(args, left, right)?;
    Ok((c, d, form))
}

/// A list of curves, and whether all have numbers as points.
fn family(args: &Arguments, i: usize) -> Result<(Vec<BezierCurve<Fraction>>, bool)> {
    let Value::List(items) = args.value(i)? else {
        return Err(wrong_kind("a list of curves", args.value(i)?).at(args.span(i)));
    };
    let mut list = Vec::with_capacity(items.len());
    let mut scalar = true;
    for item in items {
        let (curve, form) = args.with_first(item.clone()).bezier(0).at(args.span(i))?;
        polynomial(args, i, form)?;
        scalar &= form.scalar;
        list.push(curve);
    }
    Ok((list, scalar))
}

fn network_error(error: CurveError) -> Diagnostic {
    match error {
        CurveError::NoCommonEnd => {
            Diagnostic::error(Code::Coincident, "the curves do not meet where the network has its points")
                .hint("a curve in u for v_j has at u_i the point that the curve in v for u_i has at v_j")
        }
        CurveError::Degrees { left, right } => {
            Diagnostic::error(Code::Shape, format!("there are {left} curves and {right} parameters"))
                .hint("give one parameter for each curve")
        }
        CurveError::TooFewPoints { given, .. } => {
            Diagnostic::error(Code::Shape, format!("a network has two curves in each direction, not {given}"))
                .hint("coons(c_0, c_1, d_0, d_1) takes four")
        }
        other => curve_error(other),
    }
}
