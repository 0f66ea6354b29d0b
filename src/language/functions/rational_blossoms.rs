//! Blossoms beyond polynomials: multirational ones, those in other spaces of functions; homogeneous arguments.

use super::Builtin;
use super::gives::Gives;
use super::parameter::{Parameter, VARIABLE, many, required};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::{division_by_zero, polar_error, wrong_kind};
use crate::language::ops::formula::{self, variable_of};
use crate::language::ops::takes::Takes;
use crate::language::value::{PolarKind, Value};
use crate::math::blossom::{
    MultirationalError, Osculation, chebyshev_point, homogeneous_value, multirational,
};
use crate::math::linalg::solutions;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use nalgebra::DMatrix;
use num_traits::{One, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Polar forms");

const FUNCTION: Parameter = required("F", Takes::Function, "a rational function of one variable");

pub(super) const MULTIRATIONAL: &[Parameter] = &[
    FUNCTION,
    required("u", Takes::Scalars, "the arguments in which it is affine").shown("[u_1, ..., u_m]"),
    required("v", Takes::Scalars, "the others").shown("[v_1, ..., v_n]"),
    VARIABLE,
];

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "multilinear",
        parameters: &[
            required("f", Takes::Polynomial, "a polynomial or polar form"),
            required(
                "arguments",
                Takes::Rows,
                "a pair for each argument: [t, 1] is a number, [1, 0] a vector",
            )
            .shown("[[u_1, w_1], ..., [u_n, w_n]]"),
        ],
        summary: "w_1 ... w_n f(u_1/w_1, ..., u_n/w_n): the polar form as a form linear in each pair",
        gives: Gives::Scalar,
        example: "multilinear(t^2 + t, [[t, w], [t, w]])",
        call: |_, args| multilinear(args),
        ..NEW
    },
    Builtin {
        name: "multirational",
        parameters: MULTIRATIONAL,
        summary: "the multirational blossom f(u_1, ..., u_m / v_1, ..., v_n), where it is rational",
        gives: Gives::Scalar,
        example: "multirational(1/t, [u], [v, w])",
        call: |_, args| {
            let (f, t) = function(args, 0)?;
            let (above, below) = over_polynomials(&f, &t);
            let value = multirational(&above, &below, &args.scalars(1)?, &args.scalars(2)?);
            value.map(Value::Scalar).map_err(|error| multirational_error(args, error))
        },
        ..NEW
    },
    Builtin {
        name: "chebyshev_blossom",
        parameters: &[
            FUNCTION,
            required("space", Takes::Scalars, "rational functions that span it together with 1")
                .shown("[phi_1, ..., phi_n]"),
            many("u_1, ..., u_n", Takes::Scalar, 1, "the arguments, one for each function"),
        ],
        summary: "the blossom of F in the space of 1, phi_1, ..., phi_n, by osculating flats",
        gives: Gives::Scalar,
        example: "chebyshev_blossom(t^3, [t, t^3], u, v)",
        call: |_, args| chebyshev(args),
        ..NEW
    },
];

pub(super) fn multirational_error(args: &Arguments, error: MultirationalError) -> Diagnostic {
    let (code, span, hint) = match error {
        MultirationalError::Degree { .. } => {
            (Code::DegreeTooSmall, args.span(1), "the order is the number of u minus the number of v")
        }
        MultirationalError::Logarithm { .. } => (
            Code::Irrational,
            args.span(2),
            "with one v more than u every rational function has a rational one",
        ),
        MultirationalError::Pole => (Code::DivisionByZero, args.span(2), "choose v that are no poles of F"),
    };
    Diagnostic::error(code, error.to_string()).at(span).hint(hint)
}

/// A formula or function, and its variable.
pub(super) fn function(args: &Arguments, i: usize) -> Result<(Fraction, Symbol)> {
    match args.value(i)? {
        Value::Scalar(f) => Ok((f.clone(), variable_of(f, args.variable()?).at(args.span(i))?)),
        Value::Function(function) if let Some((t, f)) = function.as_formula() => Ok((f.clone(), t.clone())),
        other => Err(wrong_kind("a formula", other).at(args.span(i))),
    }
}

/// Numerator and denominator by powers of the variable.
fn over_polynomials(f: &Fraction, t: &Symbol) -> (Vec<Fraction>, Vec<Fraction>) {
    let list = |p: &MultiPoly| p.coefficients_in(t).into_iter().map(Fraction::from).collect();
    (list(f.numerator()), list(f.denominator()))
}

fn multilinear(args: &Arguments) -> Evaluated {
    let given = args.univariate(0)?;
    let (value, span) = args.given(1).ok_or_else(|| wrong_kind("pairs", &Value::list(Vec::new())))?;
    let wrong = || wrong_kind("a list of pairs", value).at(span).hint("such as [[t, 1], [1, 0]]");
    let pair = |item: &Value| -> Option<[Fraction; 2]> {
        let Value::List(items) = item else { return None };
        items.iter().map(|x| x.as_scalar().cloned()).collect::<Option<Vec<_>>>()?.try_into().ok()
    };
    let Value::List(items) = value else { return Err(wrong()) };
    let pairs: Vec<[Fraction; 2]> = items.iter().map(pair).collect::<Option<_>>().ok_or_else(wrong)?;
    let degree = match args.value(0)? {
        Value::Polar(polar) if let PolarKind::Univariate(form) = &polar.kind => form.degree(),
        _ => pairs.len(),
    };
    if degree != pairs.len() {
        let message = format!("a polar form of degree {degree} takes {degree} pairs, not {}", pairs.len());
        return Err(Diagnostic::error(Code::Arity, message).at(span).hint("give as many pairs as arguments"));
    }
    let mut list = given.coefficients;
    if list.len() > degree + 1 {
        let message =
            format!("the polynomial has degree {}, but there are {degree} arguments", list.len() - 1);
        return Err(Diagnostic::error(Code::DegreeTooSmall, message).at(span).hint("give more pairs"));
    }
    list.resize(degree + 1, Fraction::zero());
    let form = crate::math::blossom::PolarForm::with_degree(list, degree).map_err(polar_error)?;
    Ok(Value::Scalar(homogeneous_value(&form, &pairs)))
}

fn chebyshev(args: &Arguments) -> Evaluated {
    let (f, t) = function(args, 0)?;
    let space = args.scalars(1)?;
    // The letter of the functions, where F is a number.
    let t = if f.variables().contains(&t) {
        t
    } else {
        variable_of(&space.iter().fold(f.clone(), |sum, phi| sum.plus(phi)), None).at(args.span(1))?
    };
    let arguments: Vec<Fraction> = (2..args.len()).map(|i| args.scalar(i)).collect::<Result<_>>()?;
    let n = space.len();
    if arguments.len() != n {
        let message = format!("{n} functions besides 1 need {n} arguments, not {}", arguments.len());
        let error = Diagnostic::error(Code::Arity, message).at(args.span(2));
        return Err(error.hint("chebyshev_blossom(F, [phi_1, ..., phi_n], u_1, ..., u_n)"));
    }
    let coefficients = in_space(args, &f, &space, &t)?;
    let mut groups: Vec<(Fraction, usize)> = Vec::new();
    for u in arguments {
        match groups.iter_mut().find(|(known, _)| *known == u) {
            Some((_, times)) => *times += 1,
            None => groups.push((u, 1)),
        }
    }
    let flat = |(u, times): &(Fraction, usize)| -> Result<Osculation<Fraction>> {
        let mut derivatives = space.clone();
        let mut jet = Vec::with_capacity(n + 1 - times);
        for _ in 0..=n - times {
            let at = |g: &Fraction| g.substitute(&[(t.clone(), u.clone())]);
            let values = derivatives.iter().map(at).collect::<std::result::Result<Vec<_>, _>>();
            jet.push(values.map_err(|_| division_by_zero()).at(args.span(2))?);
            derivatives = derivatives.iter().map(|g| g.derivative(&t)).collect();
        }
        Ok(Osculation { jet })
    };
    let flats = groups.iter().map(flat).collect::<Result<Vec<_>>>()?;
    let point = chebyshev_point(&flats).ok_or_else(|| {
        let message = "the osculating flats at these arguments have not one point in common";
        let error = Diagnostic::error(Code::Degenerate, message).at(args.span(1));
        error.hint("a function of the space that is not 0 may have too many zeros; choose an interval without, such as t > 0")
    })?;
    let sum = point
        .iter()
        .zip(&coefficients[1..])
        .fold(coefficients[0].clone(), |sum, (x, c)| sum.plus(&x.times(c)));
    Ok(Value::Scalar(sum))
}

/// F as a combination of 1, φ_1, …, φ_n.
fn in_space(args: &Arguments, f: &Fraction, space: &[Fraction], t: &Symbol) -> Result<Vec<Fraction>> {
    let one = Fraction::one();
    let all: Vec<&Fraction> = std::iter::once(&one).chain(space).collect();
    let below = all.iter().chain([&f]).fold(MultiPoly::one(), |product, g| {
        let common = product.gcd(g.denominator());
        let rest = g.denominator().div_exact(&common).unwrap_or_else(|| g.denominator().clone());
        product.times(&rest)
    });
    let below = Fraction::from(below);
    let column = |g: &Fraction| formula::coefficients_in(&g.times(&below), t).at(args.span(1));
    let columns = all.iter().map(|g| column(g)).collect::<Result<Vec<_>>>()?;
    let right = column(f)?;
    let rows = columns.iter().map(Vec::len).max().unwrap_or(0).max(right.len());
    let entry = |list: &Vec<Fraction>, i: usize| list.get(i).cloned().unwrap_or_else(Fraction::zero);
    let matrix = DMatrix::from_fn(rows, columns.len(), |i, j| entry(&columns[j], i));
    let right: Vec<Fraction> = (0..rows).map(|i| entry(&right, i)).collect();
    let found = solutions(&matrix, &right).map_err(crate::language::ops::errors::linalg_error)?;
    if !found.free.is_empty() {
        let error = Diagnostic::error(Code::Degenerate, "1 and these functions are linearly dependent");
        return Err(error.at(args.span(1)).hint("1 belongs to the space without being named"));
    }
    found.constants.ok_or_else(|| {
        let error = Diagnostic::error(Code::Domain, "F is no combination of 1 and these functions");
        error.at(args.span(0)).hint("the blossom is defined for functions of the space")
    })
}
