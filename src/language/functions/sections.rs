//! Surfaces cut by planes, by equations and by other surfaces; surfaces as an intersection needs them.

use super::Builtin;
use super::gives::Gives;
use super::intersections::equation;
use super::parameter::{Parameter, required};
use super::solve::system_error;
use super::surface_schemes::surface_coordinates;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::takes::Takes;
use crate::language::value::{Geometry, Value};
use crate::math::curve::{ParametricSurface, Point, surface_equation};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use crate::math::system::Bounds;
use num_traits::{One, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

const SURFACE: Parameter = required(
    "surface",
    Takes::OneOf(&[Takes::Surface, Takes::Coordinates]),
    "a patch, or three coordinates as formulas in u and v",
)
.shown("s");

pub(super) const TABLE: &[Builtin] = &[Builtin {
    name: "intersection_curve",
    parameters: &[
        SURFACE,
        required(
            "other",
            Takes::OneOf(&[Takes::Scalar, Takes::Equations, Takes::Surface, Takes::Coordinates]),
            "the left side of F(x, y, z) = 0, an equation, or a surface of low degree",
        )
        .shown("d"),
    ],
    summary: "the polynomial in u and v that is 0 where a surface meets F(x, y, z) = 0 or another",
    gives: Gives::Any,
    example: "intersection_curve([u, v, u v], x + y - z)",
    call: |_, args| intersection_curve(args),
    ..Builtin::about("Intersections")
}];

/// x, y and z
pub(super) fn letters_of_space() -> [Symbol; 3] {
    ["x", "y", "z"].map(Symbol::new)
}

/// Whether an argument is a surface: a patch, or formulas in u and v.
pub(super) fn is_surface(value: &Value) -> bool {
    match value {
        Value::Geometry(geometry) => geometry.is_surface(),
        Value::List(items) => {
            let formulas: Option<Vec<&Fraction>> = items.iter().map(Value::as_scalar).collect();
            let occurs = |name: &str| {
                let letter = Symbol::new(name);
                formulas.iter().flatten().any(|f| f.variables().contains(&letter))
            };
            formulas.is_some() && occurs("u") && occurs("v")
        }
        _ => false,
    }
}

/// That an equation has no other symbols than x, y and z.
pub(super) fn only_space(args: &Arguments, equation: &MultiPoly) -> Result<()> {
    let letters = letters_of_space();
    match equation.variables().iter().find(|s| !letters.contains(s)) {
        None => Ok(()),
        Some(other) => {
            let message = format!("the equation has the symbol {other} besides x, y and z");
            Err(Diagnostic::error(Code::Type, message).at(args.span(1)).hint("give it a value first"))
        }
    }
}

/// A surface with numbers as coefficients.
pub(super) fn parametric_surface(args: &Arguments, i: usize) -> Result<ParametricSurface> {
    let parameters = ["u", "v"].map(Symbol::new);
    let formulas = surface_coordinates(args, i)?;
    if let Some(other) = formulas.iter().flat_map(Fraction::variables).find(|s| !parameters.contains(s)) {
        let message = format!("the surface has the symbol {other} besides u and v");
        return Err(Diagnostic::error(Code::Type, message).at(args.span(i)).hint("give it a value first"));
    }
    let weight = formulas.iter().fold(MultiPoly::one(), |product, f| {
        let common = product.gcd(f.denominator());
        let rest = f.denominator().div_exact(&common).unwrap_or_else(|| f.denominator().clone());
        product.times(&rest)
    });
    let scaled = |f: &Fraction| f.times(&Fraction::from(weight.clone())).numerator().clone();
    let coordinates = formulas.iter().map(scaled).chain([weight.clone()]).collect();
    let (bounds, sides) = match args.value(i)? {
        Value::Geometry(geometry) => domain(geometry, &parameters).ok_or_else(|| {
            let message = "numbers are needed as bounds of the parameters";
            Diagnostic::error(Code::Type, message).at(args.span(i)).hint("give symbols values first")
        })?,
        _ => Default::default(),
    };
    Ok(ParametricSurface { coordinates, parameters, bounds, sides })
}

/// Bounds of the parameters, and what is not negative besides.
fn domain(geometry: &Geometry, parameters: &[Symbol; 2]) -> Option<([Bounds; 2], Vec<MultiPoly>)> {
    let between = |ends: (&Fraction, &Fraction)| -> Option<Bounds> {
        let (a, b) = (ends.0.as_rational()?, ends.1.as_rational()?);
        Some((Some(a.clone().min(b.clone())), Some(a.max(b))))
    };
    match geometry {
        Geometry::Patch(patch, _) => {
            let (u, v) = (between(patch.u().ends())?, between(patch.v().ends())?);
            Some(([u, v], Vec::new()))
        }
        Geometry::Triangle(patch, _) => {
            let numbers = |p: &Point<Fraction>| -> Option<[Rational; 2]> {
                Some([p.first()?.as_rational()?, p.get(1)?.as_rational()?])
            };
            let corners = patch.triangle().corners().iter().map(numbers).collect::<Option<Vec<_>>>()?;
            let bound = |k: usize| {
                let list = || corners.iter().map(|p| p[k].clone());
                (list().min(), list().max())
            };
            let [x, y] = parameters.clone().map(MultiPoly::symbol);
            let turn = |i: usize| {
                let ([a, b], [c, d]) = (&corners[i], &corners[(i + 1) % 3]);
                (y.clone() - MultiPoly::constant(b.clone())).scaled(&(c - a))
                    - (x.clone() - MultiPoly::constant(a.clone())).scaled(&(d - b))
            };
            let area = (&corners[1][0] - &corners[0][0]) * (&corners[2][1] - &corners[0][1])
                - (&corners[1][1] - &corners[0][1]) * (&corners[2][0] - &corners[0][0]);
            let sign = if area < Rational::zero() { -Rational::one() } else { Rational::one() };
            Some(([bound(0), bound(1)], (0..3).map(|i| turn(i).scaled(&sign)).collect()))
        }
        _ => None,
    }
}

/// Where a surface lies on F = 0, in its parameters.
fn intersection_curve(args: &Arguments) -> Evaluated {
    let surface = parametric_surface(args, 0)?;
    let letters = letters_of_space();
    if surface.coordinates.len() != 4 {
        let message = format!(
            "a surface in space is needed, this one has {} coordinates",
            surface.coordinates.len() - 1
        );
        return Err(Diagnostic::error(Code::Shape, message).at(args.span(0)).hint("such as [u, v, u v]"));
    }
    let equation = match is_surface(args.value(1)?) {
        true => {
            let other = surface_coordinates(args, 1)?;
            let count = other.len();
            let other: [Fraction; 3] = other.try_into().map_err(|_| {
                let message = format!("a surface in space is needed, this one has {count} coordinates");
                Diagnostic::error(Code::Shape, message).at(args.span(1)).hint("such as [u, v, u v]")
            })?;
            let [u, v] = &surface.parameters;
            surface_equation(&other, [u, v], &letters).map_err(system_error).at(args.span(1))?.ok_or_else(
                || {
                    let error = Diagnostic::error(Code::Degenerate, "this surface is a curve or a point");
                    error
                        .at(args.span(1))
                        .hint("intersections(c, s) are the common points of a curve and a surface")
                },
            )?
        }
        false => equation(args)?.ok_or_else(|| {
            crate::language::ops::errors::wrong_kind(
                "a surface or a formula in x, y and z",
                args.value(1).unwrap_or(&Value::int(0)),
            )
            .at(args.span(1))
            .hint("intersection_curve(s, z - 1)")
        })?,
    };
    only_space(args, &equation)?;
    let section = surface.section(&equation, &letters);
    if section.is_zero() {
        let error = Diagnostic::error(Code::Degenerate, "the whole surface lies there").at(args.span(1));
        return Err(error.hint("implicit_surface(s) is its equation"));
    }
    if section.as_constant().is_some() {
        return Ok(Value::Text("no common point".to_owned()));
    }
    Ok(Value::Scalar(Fraction::from(section)))
}
