//! Positivity on rectangles and triangles, boxes and tetrahedra.

use super::Builtin;
use super::gives::Gives;
use super::parameter::{optional, required};
use super::told::{LANG, told};
use crate::language::derive;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::wrong_kind;
use crate::language::ops::formula::symbol_of;
use crate::language::ops::takes::Takes;
use crate::language::value::Value;
use crate::math::curve::Region;
use crate::math::number::Rational;
use crate::math::poly::Symbol;

type Result<T> = std::result::Result<T, Diagnostic>;

pub(super) const TABLE: &[Builtin] = &[Builtin {
    name: "positivity_over",
    parameters: &[
        required("F", Takes::Scalar, "a polynomial in two or three variables, with numbers as coefficients"),
        required("region", Takes::List, "an interval for each variable, or three or four corners")
            .shown("[[a, b], [c, d]]"),
        optional("variables", Takes::Variables, "those of F", "the variables, in the order of the region")
            .shown("[u, v]"),
    ],
    common: &[LANG],
    summary: "why F >= 0 on a box, triangle or tetrahedron, by Bernstein coefficients, or where F < 0",
    gives: Gives::Derivation,
    example: "positivity_over(1 - u v, [[0, 1], [0, 1]])",
    call: |_, args| positivity(args),
    ..Builtin::about("Roots of polynomials")
}];

/// An interval for each of d variables, or d + 1 points.
fn region(args: &Arguments, dimension: usize) -> Result<Region> {
    let (value, span) = (args.value(1)?, args.span(1));
    let ends = || rows(value, dimension, 2)?.into_iter().map(|row| row.try_into().ok()).collect();
    let boxed: Option<Vec<[Rational; 2]>> = ends();
    let region =
        boxed.map(Region::Box).or_else(|| rows(value, dimension + 1, dimension).map(Region::Simplex));
    let Some(region) = region else {
        return Err(if dimension == 2 {
            wrong_kind("two intervals or three points with numbers", value)
                .at(span)
                .hint("a box is [[0, 1], [0, 1]], a triangle [[0, 0], [1, 0], [0, 1]]")
        } else {
            wrong_kind("three intervals or four points of space with numbers", value)
                .at(span)
                .hint("a box is [[0, 1], [0, 1], [0, 1]],")
                .hint("a tetrahedron [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]")
        });
    };
    if !region.is_proper() {
        let (code, message, hint) = match region {
            Region::Box(_) => (
                Code::Domain,
                "an interval of the box is empty or a single number",
                "give the lower ends first: [[0, 1], [0, 1]]",
            ),
            Region::Simplex(_) => (
                Code::Degenerate,
                if dimension == 2 { "the corners lie on a line" } else { "the corners lie in a plane" },
                "choose corners in general position",
            ),
        };
        return Err(Diagnostic::error(code, message).at(span).hint(hint));
    }
    Ok(region)
}

/// A list of so many lists of so many numbers.
fn rows(value: &Value, count: usize, length: usize) -> Option<Vec<Vec<Rational>>> {
    let row = |item: &Value| -> Option<Vec<Rational>> {
        let Value::List(items) = item else { return None };
        let numbers = items.iter().map(Value::as_rational).collect::<Option<Vec<_>>>()?;
        (numbers.len() == length).then_some(numbers)
    };
    let Value::List(items) = value else { return None };
    let found = items.iter().map(row).collect::<Option<Vec<_>>>()?;
    (found.len() == count).then_some(found)
}

/// Why F ≥ 0 on the region, or where it is negative.
fn positivity(args: &Arguments) -> Evaluated {
    let f = args.scalar(0)?;
    let unknowns = unknowns(args, &f.variables())?;
    let polynomial = f.as_polynomial().filter(|p| p.variables().iter().all(|s| unknowns.contains(s)));
    let Some(polynomial) = polynomial else {
        let message = "a polynomial in these variables is needed, with numbers as coefficients";
        let error = Diagnostic::error(Code::Type, message).at(args.span(0));
        return Err(error.hint("give other symbols values first, and name the variables: [u, v]"));
    };
    let count = unknowns.len();
    if !(2..=3).contains(&count) {
        let message = format!("two or three variables are needed, there are {count}");
        let error = Diagnostic::error(Code::AmbiguousVariable, message).at(args.span(0));
        return Err(
            error.hint("name them in the order of the region: positivity_over(F, [[0, 1], [0, 1]], [u, v])")
        );
    }
    let shown = derive::positivity_over(polynomial, &unknowns, &region(args, count)?);
    let derivation = shown.map_err(|error| {
        let message = format!("this stays open: {error}");
        let hint = "the sign of F is not known; subdivide the region, or lower the degree";
        Diagnostic::error(Code::Undecided, message).at(args.span(0)).hint(hint)
    })?;
    told(args, derivation)
}

/// The variables that are named, or those of F.
fn unknowns(args: &Arguments, known: &[Symbol]) -> Result<Vec<Symbol>> {
    let Some((value, span)) = args.given(2) else { return Ok(known.to_vec()) };
    let list = match value {
        Value::List(items) => items.iter().map(symbol_of).collect::<Option<Vec<_>>>(),
        _ => None,
    };
    list.ok_or_else(|| wrong_kind("variables", value).at(span).hint("such as [u, v]"))
}
