//! Where curves meet others, surfaces and themselves, and the parameters of their points.

use super::gives::Gives;
use std::sync::Arc;

use super::Builtin;
use super::by_pieces::{self, pieces_of};
use super::parameter::{Parameter, named, optional, required};
use super::rational::homogeneous_coordinates;
use super::sections::{is_surface, letters_of_space, only_space, parametric_surface};
use super::solve::system_error;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Machine};
use crate::language::ops::arithmetic::{add, negate};
use crate::language::ops::errors::wrong_kind;
use crate::language::ops::geometry::bezier;
use crate::language::ops::takes::Takes;
use crate::language::value::{Cell, Table, Value};
use crate::math::curve::{self, MovingLine, PlaneCurve, SpaceCurve};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Poly, RealRoot, Symbol};
use crate::math::system::{Bounds, SystemError};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Intersections");

/// Points are left out for parameters of higher degree, unless they are asked for.
const DEGREE_WITH_POINTS: usize = 12;

pub(super) const PLANE_CURVE: Parameter = required(
    "curve",
    Takes::OneOf(&[Takes::Curve, Takes::Coordinates]),
    "a Bézier curve of the plane, or its coordinates as formulas",
)
.shown("c");

const POINTS: Parameter = named(
    "points=1",
    Takes::Flag,
    "1 for parameters of degree 12 at most",
    "whether the points are given as well",
);

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "intersections",
        parameters: &[
            required(
                "curve",
                Takes::OneOf(&[Takes::Curve, Takes::Coordinates]),
                "a Bézier curve of the plane or of space, or its coordinates as formulas",
            )
            .shown("c"),
            required(
                "other",
                Takes::OneOf(&[Takes::Curve, Takes::Surface, Takes::Coordinates, Takes::Equations]),
                "another curve, a surface, or the left side of F(x, y) = 0 or F(x, y, z) = 0",
            )
            .shown("d"),
            POINTS,
        ],
        summary: "where a curve meets another one, F(x, y) = 0, F(x, y, z) = 0 or a surface, exactly",
        gives: Gives::Any,
        example: "intersections([t, t^2], x^2 + y^2 - 2)",
        call: intersections,
        by_pieces: Some(by_pieces::rows),
        ..NEW
    },
    Builtin {
        name: "double_points",
        parameters: &[PLANE_CURVE, POINTS],
        summary: "the pairs of real parameters s <= t of one point of a plane curve; s = t at a cusp",
        gives: Gives::Any,
        example: "double_points([t^2, t^3 - t])",
        call: |machine, args| {
            let curve = plane_curve(args, 0)?;
            let found = curve.double_points().map_err(|error| twice(error, args))?;
            if found.is_empty() {
                let note =
                    "no two real parameters have one point; isolated double points have complex parameters";
                machine.note(Diagnostic::note(Code::NotReal, note).at(args.span(0)));
            }
            let rows = found.into_iter().map(|pair| (pair.parameters.to_vec(), pair.degree));
            table(machine, args, ["s", "t"].as_slice(), &|t| curve.point(t).to_vec(), rows.collect())
        },
        ..NEW
    },
    Builtin {
        name: "cusps",
        parameters: &[PLANE_CURVE, POINTS],
        summary: "the real parameters at which a plane curve has a cusp, with its points",
        gives: Gives::Any,
        example: "cusps([t^2, t^3])",
        call: |machine, args| {
            let curve = plane_curve(args, 0)?;
            let found = curve.double_points().map_err(|error| twice(error, args))?;
            let cusps = found.into_iter().filter(|pair| pair.parameters[0] == pair.parameters[1]);
            let rows: Vec<_> = cusps.map(|pair| (vec![pair.parameters[0].clone()], pair.degree)).collect();
            if rows.is_empty() {
                let note = "no real parameter gives a cusp";
                machine.note(Diagnostic::note(Code::NotReal, note).at(args.span(0)));
            }
            table(machine, args, ["t"].as_slice(), &|t| curve.point(t).to_vec(), rows)
        },
        ..NEW
    },
    Builtin {
        name: "inversion",
        parameters: &[PLANE_CURVE, optional("p", Takes::Point, "the point (x, y)", "a point of the curve")],
        summary: "the parameters of a point of a plane curve; without a point the formula in x and y",
        gives: Gives::Any,
        example: "inversion([t^2, t^3])",
        call: inversion,
        ..NEW
    },
    Builtin {
        name: "moving_lines",
        parameters: &[PLANE_CURVE],
        summary: "two lines that follow a plane curve, of least degree; their resultant is its equation",
        gives: Gives::Functions,
        example: "moving_lines([t^2, t^3])",
        call: |_, args| {
            let coordinates = numbers(args, 0)?.0;
            let basis = curve::moving_lines(&coordinates).ok_or_else(|| single_point(args))?;
            let [x, y, t] = ["x", "y", "t"].map(|name| MultiPoly::symbol(Symbol::new(name)));
            let written = |line: &MovingLine| {
                let [a, b, c] = line.each_ref().map(|f| f.value_in(&t));
                Value::Scalar(Fraction::from(a * x.clone() + b * y.clone() + c))
            };
            Ok(Value::List(basis.iter().map(written).collect()))
        },
        ..NEW
    },
];

/// Homogeneous coordinates with numbers as coefficients, and the bounds of the parameter.
type Numeric = ([Poly; 3], Bounds);

fn numbers(args: &Arguments, i: usize) -> Result<Numeric> {
    let (coordinates, range) = homogeneous_numbers(args, i)?;
    let coordinates = <[Poly; 3]>::try_from(coordinates).map_err(|list| {
        let message = format!("a curve of the plane is needed, this one has {} coordinates", list.len() - 1);
        let error = Diagnostic::error(Code::Shape, message).at(args.span(i));
        error.hint("implicit(c), inversion(c, p) and intersections(c, d) take curves in space, too")
    })?;
    Ok((coordinates, range))
}

/// The same in any dimension; the weight is the last one.
fn homogeneous_numbers(args: &Arguments, i: usize) -> Result<(Vec<Poly>, Bounds)> {
    let (coordinates, interval) = homogeneous_coordinates(args, i)?;
    let polynomial =
        |list: &Vec<Fraction>| -> Option<Poly> { list.iter().map(Fraction::as_rational).collect() };
    let end = |end: &Fraction| end.as_rational();
    let symbolic = || {
        Diagnostic::error(Code::Type, "numbers are needed as control points and as ends of the interval")
            .at(args.span(i))
            .hint("solve treats curves with symbols: solve(c(t) = [x, y], t)")
    };
    let polynomials: Option<Vec<Poly>> = coordinates.iter().map(polynomial).collect();
    let range = match interval {
        None => (None, None),
        Some(interval) => {
            let (a, b) = interval.ends();
            let (Some(a), Some(b)) = (end(a), end(b)) else { return Err(symbolic()) };
            (Some(a.clone().min(b.clone())), Some(a.max(b)))
        }
    };
    Ok((polynomials.ok_or_else(symbolic)?, range))
}

fn plane_curve(args: &Arguments, i: usize) -> Result<PlaneCurve> {
    let (coordinates, range) = numbers(args, i)?;
    PlaneCurve::new(coordinates, range)
        .ok_or_else(|| Diagnostic::error(Code::ZeroWeight, "the weight of every point is 0").at(args.span(i)))
}

/// The same of each piece of a spline, one after the other, and whether it is one.
pub(super) fn plane_pieces(args: &Arguments, i: usize) -> Result<(Vec<PlaneCurve>, bool)> {
    match pieces_of(args.value(i)?) {
        None => Ok((vec![plane_curve(args, i)?], false)),
        Some(pieces) => {
            let (curves, form) = pieces.at(args.span(i))?;
            let piece = |curve| {
                let mut own = args.clone();
                own.put(i, bezier(curve, form), args.span(i));
                plane_curve(&own, i)
            };
            Ok((curves.into_iter().map(piece).collect::<Result<_>>()?, true))
        }
    }
}

fn single_point(args: &Arguments) -> Diagnostic {
    Diagnostic::error(Code::Degenerate, "the curve is a single point").at(args.span(0)).hint("give a curve")
}

/// Infinitely many double points.
fn twice(error: SystemError, args: &Arguments) -> Diagnostic {
    match error {
        SystemError::Infinite => {
            let message =
                "infinitely many points belong to several parameters: the curve is run through several times";
            let error = Diagnostic::error(Code::Degenerate, message).at(args.span(0));
            error.hint("implicit(c) is its equation")
        }
        other => system_error(other).at(args.span(0)),
    }
}

/// A curve that lies on F = 0.
fn lies_there(args: &Arguments) -> Diagnostic {
    Diagnostic::error(Code::Degenerate, "the whole curve lies there")
        .at(args.span(1))
        .hint("implicit(c) is its equation")
}

/// Infinitely many solutions, which may be complex or outside of the domains, or belong to one point.
fn overlap(args: &Arguments) -> Diagnostic {
    let message = "the equations of the parameters have infinitely many complex solutions";
    let error = Diagnostic::error(Code::Degenerate, message).at(args.span(1));
    error.hint(match args.value(1).is_ok_and(is_surface) {
        true => "intersections(c, implicit_surface(s)) has the parameters of the curve alone",
        false => "one may be a part of the other, beyond their ends, or a point: implicit(c) is the equation",
    })
}

fn intersections(machine: &mut Machine, args: &Arguments) -> Result<Value> {
    if is_surface(args.value(0)?) {
        let error = Diagnostic::error(Code::Type, "the first argument is a surface").at(args.span(0));
        return Err(error
            .hint("intersection_curve(s, d) is the equation of the common curve in u and v")
            .hint("intersections(c, s) are the common points of a curve and a surface"));
    }
    if homogeneous_coordinates(args, 0)?.0.len() != 3 {
        return in_space(machine, args);
    }
    let curve = plane_curve(args, 0)?;
    if let Some(equation) = equation(args)? {
        let symbols = ["x", "y"].map(Symbol::new);
        if let Some(other) = equation.variables().iter().find(|s| !symbols.contains(s)) {
            let message = format!("the equation has the symbol {other} besides x and y");
            return Err(Diagnostic::error(Code::Type, message)
                .at(args.span(1))
                .hint("give it a value first; a curve is a list of its coordinates: [t, t^2]"));
        }
        let found = curve.on(&equation, &symbols).ok_or_else(|| lies_there(args))?;
        let rows = found.into_iter().map(|t| (vec![t.clone()], degree(&t)));
        return table(machine, args, &["t"], &|t| curve.point(t).to_vec(), rows.collect());
    }
    let other = plane_curve(args, 1)?;
    let found = curve.meetings(&other).map_err(|error| match error {
        SystemError::Infinite => overlap(args),
        error => system_error(error).at(args.span(1)),
    })?;
    let rows = found.into_iter().map(|meeting| (meeting.parameters.to_vec(), meeting.degree));
    table(machine, args, &["t of the first", "t of the second"], &|t| curve.point(t).to_vec(), rows.collect())
}

/// A curve in space with an equation, a surface or another curve.
fn in_space(machine: &mut Machine, args: &Arguments) -> Result<Value> {
    let space_curve = |i: usize| -> Result<SpaceCurve> {
        let (coordinates, range) = homogeneous_numbers(args, i)?;
        SpaceCurve::new(coordinates, range).ok_or_else(|| {
            Diagnostic::error(Code::ZeroWeight, "the weight of every point is 0").at(args.span(i))
        })
    };
    let curve = space_curve(0)?;
    let dimension = homogeneous_coordinates(args, 0)?.0.len() - 1;
    let same = |other: usize| match other == dimension {
        true => Ok(()),
        false => {
            let message = format!("the curve has {dimension} coordinates, this has {other}");
            Err(Diagnostic::error(Code::Shape, message)
                .at(args.span(1))
                .hint("both need the same number of them"))
        }
    };
    let point = |t: &RealRoot| curve.point(t);
    if let Some(equation) = equation(args)? {
        same(3)?;
        only_space(args, &equation)?;
        let found = curve.on(&equation, &letters_of_space()).ok_or_else(|| lies_there(args))?;
        let rows = found.into_iter().map(|t| (vec![t.clone()], degree(&t)));
        return table(machine, args, &["t"], &point, rows.collect());
    }
    let failed = |error| match error {
        SystemError::Infinite => overlap(args),
        error => system_error(error).at(args.span(1)),
    };
    if is_surface(args.value(1)?) {
        let surface = parametric_surface(args, 1)?;
        same(surface.coordinates.len() - 1)?;
        let found = curve.on_surface(&surface).map_err(failed)?;
        let rows = found.into_iter().map(|list| (list.to_vec(), degree(&list[0])));
        return table(machine, args, &["t", "u", "v"], &point, rows.collect());
    }
    let other = space_curve(1)?;
    same(homogeneous_coordinates(args, 1)?.0.len() - 1)?;
    let found = curve.meetings(&other).map_err(failed)?;
    let rows = found.into_iter().map(|pair| (pair.to_vec(), degree(&pair[0])));
    table(machine, args, &["t of the first", "t of the second"], &point, rows.collect())
}

fn degree(t: &RealRoot) -> usize {
    match t {
        RealRoot::Rational(_) => 1,
        RealRoot::Irrational(number) => number.polynomial().degree().unwrap_or(0),
    }
}

/// The numerator of F where the second argument is a formula or equation, so no curve.
pub(super) fn equation(args: &Arguments) -> Result<Option<MultiPoly>> {
    Ok(match args.value(1)? {
        Value::Scalar(f) => Some(f.numerator().clone()),
        Value::Claim(claim) => {
            let [one] = claim.judgements.as_slice() else {
                return Err(wrong_kind("one equation", args.value(1)?).at(args.span(1)));
            };
            let difference = negate(one.right.clone()).and_then(|right| add(one.left.clone(), right))?;
            difference.as_scalar().map(|f| f.numerator().clone())
        }
        _ => None,
    })
}

/// A row for each parameter or pair of them, with the point of the first curve.
fn table(
    machine: &mut Machine,
    args: &Arguments,
    header: &[&str],
    point: &dyn Fn(&RealRoot) -> Vec<RealRoot>,
    rows: Vec<(Vec<RealRoot>, usize)>,
) -> Result<Value> {
    if rows.is_empty() {
        return Ok(Value::list(Vec::new()));
    }
    let t = Symbol::new("t");
    let highest = rows.iter().map(|(_, degree)| *degree).max().unwrap_or(1);
    let with_points = args.flag_or("points", highest <= DEGREE_WITH_POINTS)?;
    if !with_points && args.named("points").is_none() {
        let message =
            format!("the points are left out: a parameter is a root of a polynomial of degree {highest}");
        let note = Diagnostic::note(Code::LeftOut, message).at(args.span(0));
        machine.note(note.hint("points=1 gives them"));
    }
    let mut result = Table::with_header(header.iter().copied().chain(with_points.then_some("point")));
    for (parameters, _) in rows {
        let mut row: Vec<Cell> = parameters.iter().map(|p| Cell::Value(Value::root(p.clone(), &t))).collect();
        if with_points {
            let letters = ["x", "y", "z"].map(Symbol::new).into_iter().chain(std::iter::repeat(t.clone()));
            let coordinates = point(&parameters[0]).into_iter().zip(letters);
            row.push(Cell::Value(Value::point(coordinates.map(|(x, s)| Value::root(x, &s)).collect())));
        }
        result.rows.push(row);
    }
    Ok(Value::Table(Arc::new(result)))
}

fn inversion(machine: &mut Machine, args: &Arguments) -> Result<Value> {
    if homogeneous_coordinates(args, 0)?.0.len() > 3 && args.given(1).is_some() {
        return inversion_in_space(machine, args);
    }
    let (coordinates, range) = numbers(args, 0)?;
    let Some((_, span)) = args.given(1) else {
        let [x, y] = ["x", "y"].map(Symbol::new);
        if curve::moving_lines(&coordinates).is_none() {
            return Err(single_point(args));
        }
        return curve::inversion_formula(&coordinates, [&x, &y]).map(Value::Scalar).ok_or_else(|| {
            let message = "the parameter is no function of the point: the curve is run through several times";
            Diagnostic::error(Code::Degenerate, message).at(args.span(0)).hint("implicit(c) is its equation")
        });
    };
    let point = args.point(1)?;
    let numbers: Option<Vec<Rational>> = point.iter().map(Fraction::as_rational).collect();
    let point: [Rational; 2] = numbers.and_then(|list| list.try_into().ok()).ok_or_else(|| {
        Diagnostic::error(Code::Shape, "a point with two numbers as coordinates is needed").at(span)
    })?;
    let curve = PlaneCurve::new(coordinates, range).ok_or_else(|| {
        Diagnostic::error(Code::ZeroWeight, "the weight of every point is 0").at(args.span(0))
    })?;
    let found = curve.parameters_of(&point).ok_or_else(|| single_point(args))?;
    Ok(parameters(machine, args, found))
}

/// Parameters of a point; a remark where there is none.
fn parameters(machine: &mut Machine, args: &Arguments, found: Vec<RealRoot>) -> Value {
    if found.is_empty() {
        let note =
            "the point does not lie on the curve, or its parameter is not real or outside of the interval";
        machine.note(Diagnostic::note(Code::OutsideDomain, note).at(args.span(1)));
    }
    let t = Symbol::new("t");
    Value::List(found.into_iter().map(|root| Value::root(root, &t)).collect())
}

/// The parameters of a point in space: common roots of X − x W, Y − y W, Z − z W.
fn inversion_in_space(machine: &mut Machine, args: &Arguments) -> Result<Value> {
    let (coordinates, (lower, upper)) = homogeneous_numbers(args, 0)?;
    let point = args.point(1)?;
    let numbers: Option<Vec<Rational>> = point.iter().map(Fraction::as_rational).collect();
    let dimension = coordinates.len() - 1;
    let point = numbers.filter(|list| list.len() == dimension).ok_or_else(|| {
        Diagnostic::error(Code::Shape, format!("a point with {dimension} numbers as coordinates is needed"))
            .at(args.span(1))
    })?;
    let weight = &coordinates[dimension];
    let differences = coordinates.iter().zip(&point).map(|(x, c)| x - &weight.scale(c));
    let common = differences.reduce(|p, q| p.gcd(&q)).ok_or_else(|| single_point(args))?;
    let found = common.real_roots(lower.as_ref(), upper.as_ref()).ok_or_else(|| single_point(args))?;
    let finite = |(t, _): (RealRoot, usize)| (!t.sign_of(weight).is_eq()).then_some(t);
    Ok(parameters(machine, args, found.into_iter().filter_map(finite).collect()))
}
