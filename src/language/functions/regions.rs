//! Positivity on rectangles and triangles, boxes and tetrahedra.

use super::Builtin;
use super::parameter::{Takes, optional, required};
use super::told::{LANG, told};
use crate::language::derive;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::wrong_kind;
use crate::language::ops::formula::symbol_of;
use crate::language::value::Value;
use crate::math::curve::{Region, Solid};
use crate::math::number::Rational;
use crate::math::poly::Symbol;
use num_traits::Zero;

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
    example: "positivity_over(1 - u v, [[0, 1], [0, 1]])",
    call: |_, args| positivity(args),
    ..Builtin::about("Roots of polynomials")
}];

/// Two intervals or three points.
fn region(args: &Arguments) -> Result<Region> {
    let (value, span) = (args.value(1)?, args.span(1));
    if let Some([u, v]) = pairs(value) {
        if u[0] >= u[1] || v[0] >= v[1] {
            let error = Diagnostic::error(Code::Domain, "an interval of the box is empty or a single number");
            return Err(error.at(span).hint("give the lower ends first: [[0, 1], [0, 1]]"));
        }
        return Ok(Region::Rectangle(u, v));
    }
    let Some([p, q, r]) = pairs(value) else {
        let error = wrong_kind("two intervals or three points with numbers", value).at(span);
        return Err(error.hint("a box is [[0, 1], [0, 1]], a triangle [[0, 0], [1, 0], [0, 1]]"));
    };
    let area = (&q[0] - &p[0]) * (&r[1] - &p[1]) - (&q[1] - &p[1]) * (&r[0] - &p[0]);
    if area.is_zero() {
        let error = Diagnostic::error(Code::Degenerate, "the corners lie on a line").at(span);
        return Err(error.hint("choose corners in general position"));
    }
    Ok(Region::Triangle([p, q, r]))
}

/// A list of so many pairs of numbers.
fn pairs<const N: usize>(value: &Value) -> Option<[[Rational; 2]; N]> {
    rows(value)
}

/// Three intervals or four points of space.
fn solid(args: &Arguments) -> Result<Solid> {
    let (value, span) = (args.value(1)?, args.span(1));
    let solid = match (rows::<2, 3>(value), rows::<3, 4>(value)) {
        (Some(ends), _) => Solid::Box(ends),
        (_, Some(corners)) => Solid::Tetrahedron(corners),
        _ => {
            let error = wrong_kind("three intervals or four points of space with numbers", value).at(span);
            return Err(error
                .hint("a box is [[0, 1], [0, 1], [0, 1]],")
                .hint("a tetrahedron [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]"));
        }
    };
    if !solid.is_proper() {
        let (code, message, hint) = match solid {
            Solid::Box(_) => (
                Code::Domain,
                "an interval of the box is empty or a single number",
                "give the lower ends first",
            ),
            Solid::Tetrahedron(_) => {
                (Code::Degenerate, "the corners lie in a plane", "choose corners in general position")
            }
        };
        return Err(Diagnostic::error(code, message).at(span).hint(hint));
    }
    Ok(solid)
}

/// A list of N lists of M numbers.
fn rows<const M: usize, const N: usize>(value: &Value) -> Option<[[Rational; M]; N]> {
    let pair = |item: &Value| -> Option<[Rational; M]> {
        let Value::List(items) = item else { return None };
        items.iter().map(Value::as_rational).collect::<Option<Vec<_>>>()?.try_into().ok()
    };
    let Value::List(items) = value else { return None };
    items.iter().map(pair).collect::<Option<Vec<_>>>()?.try_into().ok()
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
    let shown = match unknowns.as_slice() {
        [u, v] => derive::positivity_over(polynomial, &[u.clone(), v.clone()], &region(args)?),
        [u, v, w] => {
            derive::positivity_in_space(polynomial, &[u.clone(), v.clone(), w.clone()], &solid(args)?)
        }
        list => {
            let message = format!("two or three variables are needed, there are {}", list.len());
            let error = Diagnostic::error(Code::AmbiguousVariable, message).at(args.span(0));
            return Err(error
                .hint("name them in the order of the region: positivity_over(F, [[0, 1], [0, 1]], [u, v])"));
        }
    };
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
