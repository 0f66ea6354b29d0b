//! Roots of polynomials: resultants, Sturm's chain, real roots.

use super::gives::Gives;
use super::parameter::{Parameter, VARIABLE, named, optional, required};
use super::told::{LANG, told};
use super::{Builtin, by_pieces};
use crate::language::derive;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::extremes::{self, Within};
use crate::language::eval::{Arguments, Machine};
use crate::language::ops::errors::wrong_kind;
use crate::language::ops::formula::{self, Univariate};
use crate::language::ops::takes::Takes;
use crate::language::value::{Value, in_letter};
use crate::math::interval::Interval;
use crate::math::number::{Rational, integer};
use crate::math::poly::{Fraction, MultiPoly, Poly, RealRoot, Symbol};
use crate::math::ring::{Field, Ring};
use num_traits::{Signed, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Roots of polynomials");

/// The variable of a formula, at its place.
const LETTER: Parameter =
    optional("variable", Takes::Variable, "the only variable, or t", "the variable; others are constants")
        .shown("t");

const POLYNOMIAL: Parameter =
    required("F", Takes::Polynomial, "the polynomial, with numbers as coefficients");

pub(super) const LOWER: Parameter = optional("a", Takes::Number, "no bound", "the lower end");

pub(super) const UPPER: Parameter = optional("b", Takes::Number, "no bound", "the upper end");

const WIDTH: Parameter = named(
    "width=1/1000",
    Takes::Number,
    "1, or less near 0",
    "how long the interval around a root may be that is not rational",
);

const EXTREME: &[Parameter] = &[
    required("F", Takes::Scalar, "a polynomial or a quotient of polynomials, with numbers as coefficients"),
    LOWER,
    UPPER,
    VARIABLE,
];

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "roots",
        parameters: &[POLYNOMIAL, LOWER, UPPER, WIDTH, VARIABLE],
        summary: "the real roots in increasing order, each as often as its multiplicity, exactly",
        gives: Gives::List,
        example: "roots((t - 1)^2 (t^2 - 2))",
        call: roots,
        by_pieces: Some(by_pieces::roots),
        ..NEW
    },
    Builtin {
        name: "root_of",
        parameters: &[
            POLYNOMIAL,
            required("a", Takes::Number, "the lower end of an interval with one root"),
            required("b", Takes::Number, "its upper end"),
            WIDTH,
            VARIABLE,
        ],
        summary: "the only real root in [a, b], a number that can be compared with others",
        gives: Gives::Scalar,
        example: "root_of(t^2 - 2, 1, 2) < 3/2",
        call: root_of,
        ..NEW
    },
    Builtin {
        name: "count_roots",
        parameters: &[
            POLYNOMIAL,
            optional("a", Takes::Number, "all real numbers", "the lower end, not counted"),
            optional("b", Takes::Number, "all real numbers", "the upper end, counted"),
        ],
        summary: "how many different real roots a polynomial has, or how many in (a, b], exactly (Sturm)",
        gives: Gives::Count,
        example: "count_roots(t^3 - t, 0, 2)",
        call: |_, args| {
            let (polynomial, _) = numeric(args, 0)?;
            let ends = match (args.given(1), args.given(2)) {
                (None, None) => {
                    // No root is larger than 1 + max |a_i / a_n|.
                    let coefficients = polynomial.coefficients();
                    let leading = coefficients.last().cloned().unwrap_or_default();
                    if leading.is_zero() {
                        return Err(zero_polynomial(args));
                    }
                    let ratios = coefficients.iter().map(|c| (c / &leading).abs());
                    let bound = ratios.max().unwrap_or_default() + Rational::from_integer(1.into());
                    [-bound.clone(), bound]
                }
                _ => [args.rational(1)?, args.rational(2)?],
            };
            let [a, b] = ends;
            let count = match Interval::new(a, b) {
                Ok(interval) => polynomial.count_roots(&interval),
                // Nothing lies between equal ends.
                Err(_) => polynomial.degree().map(|_| 0),
            };
            count.map(|count| Value::int(count as i64)).ok_or_else(|| zero_polynomial(args))
        },
        ..NEW
    },
    Builtin {
        name: "maximum",
        parameters: EXTREME,
        summary: "the largest value on [a, b] or of all, exactly; a note says where it is taken",
        gives: Gives::Scalar,
        example: "maximum(3t(1 - t)^2, 0, 1)",
        call: |machine, args| extreme(machine, args, true),
        by_pieces: Some(by_pieces::largest),
        ..NEW
    },
    Builtin {
        name: "minimum",
        parameters: EXTREME,
        summary: "the smallest value on [a, b] or of all, exactly; a note says where it is taken",
        gives: Gives::Scalar,
        example: "minimum(t^3 - t, 0, 1)",
        call: |machine, args| extreme(machine, args, false),
        by_pieces: Some(by_pieces::smallest),
        ..NEW
    },
    Builtin {
        name: "sturm",
        parameters: &[POLYNOMIAL, VARIABLE],
        summary: "Sturm's chain F, F', -(F mod F'), ... up to positive factors",
        gives: Gives::Functions,
        example: "sturm(t^3 - 3t + 1)",
        call: |_, args| {
            let (polynomial, variable) = numeric(args, 0)?;
            let chain = polynomial.sturm_chain();
            if chain.is_empty() {
                return Err(zero_polynomial(args));
            }
            let value = |p: &Poly| Value::Scalar(Fraction::from(in_letter(p, &variable)));
            Ok(Value::List(chain.iter().map(value).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "positivity",
        parameters: &[
            required(
                "F",
                Takes::Polynomial,
                "a polynomial or quotient of polynomials, with numbers as coefficients",
            ),
            LOWER,
            UPPER,
            named("strict=1", Takes::Flag, "0", "whether F > 0 is to be shown"),
            named(
                "degree=n",
                Takes::Size,
                "that of F, on parts of the interval",
                "the degree to which F is raised",
            ),
            VARIABLE,
        ],
        common: &[LANG],
        summary: "why F >= 0 or F > 0 on [a, b], by coefficients that anybody can check, or where not",
        gives: Gives::Derivation,
        example: "positivity(t^2 - t + 1/3, 0, 1)",
        call: |_, args| positivity(args),
        ..NEW
    },
    Builtin {
        name: "resultant",
        parameters: &[
            required("F", Takes::Scalar, "a polynomial"),
            required("G", Takes::Scalar, "another one"),
            LETTER,
        ],
        summary: "the resultant, 0 if and only if F and G have a common root or factor",
        gives: Gives::Scalar,
        example: "resultant(x - t^2, y - t^3, t)",
        call: |_, args| {
            let (f, g) = (args.scalar(0)?, args.scalar(1)?);
            let t = formula::variable_of(&f.plus(&g), args.optional_symbol(2)?).at(args.span(0))?;
            let ((p, below_p), (q, below_q)) = (over_constant(args, 0, &t)?, over_constant(args, 1, &t)?);
            // Res(P/a, Q/b) = Res(P, Q)/(a^n b^m)
            let (m, n) = (p.degree_in(&t), q.degree_in(&t));
            let value = Fraction::from(p.resultant(&q, &t));
            Ok(Value::Scalar(value.times(&below_p.powered(n)).times(&below_q.powered(m))))
        },
        ..NEW
    },
    Builtin {
        name: "discriminant",
        parameters: &[required("F", Takes::Scalar, "the polynomial"), LETTER],
        summary: "the discriminant, 0 if and only if F has a repeated root",
        gives: Gives::Scalar,
        example: "discriminant(a x^2 + b x + c, x)",
        call: |_, args| {
            let f = args.scalar(0)?;
            let t = formula::variable_of(&f, args.optional_symbol(1)?).at(args.span(0))?;
            let (p, below) = over_constant(args, 0, &t)?;
            let Some(value) = p.discriminant(&t) else {
                let message = format!("a polynomial without {t} has no discriminant");
                return Err(Diagnostic::error(Code::Domain, message).at(args.span(0)).hint(
                    "give a polynomial of degree 1 or more, and its variable: discriminant(t^2 + p t + q, t)",
                ));
            };
            Ok(Value::Scalar(Fraction::from(value).times(&below.powered(2 * p.degree_in(&t) - 2))))
        },
        ..NEW
    },
];

fn positivity(args: &Arguments) -> Result<Value> {
    let (a, b) = interval(args, 1)?;
    let strict = args.flag("strict")?;
    let (polynomial, variable, quotient) = match args.value(0)? {
        Value::Scalar(formula) if formula.denominator().as_constant().is_none() => {
            let (polynomial, variable) = with_its_sign(args, formula, [a.as_ref(), b.as_ref()])?;
            (polynomial, variable, Some(formula.clone()))
        }
        _ => {
            let (polynomial, variable) = numeric(args, 0)?;
            (polynomial, variable, None)
        }
    };
    let Some(n) = args.named_size("degree")? else {
        let claimed = derive::Claimed { quotient, strict };
        return told(args, derive::positivity(&polynomial, &variable, a.as_ref(), b.as_ref(), &claimed));
    };
    let span = args.named("degree").map_or_else(|| args.span(0), |(_, span)| span);
    let ends = a.zip(b).and_then(|(a, b)| Interval::new(a, b).ok()).filter(|_| quotient.is_none());
    let Some(ends) = ends else {
        let error =
            Diagnostic::error(Code::Domain, "a polynomial is raised over an interval [a, b]").at(span);
        return Err(error.hint("positivity(t^2 - t + 1/3, 0, 1, degree=4)"));
    };
    if polynomial.degree().unwrap_or(0) > n {
        let message = format!("the polynomial has degree {}", polynomial.degree().unwrap_or(0));
        return Err(Diagnostic::error(Code::DegreeTooSmall, message).at(span));
    }
    crate::budget::charge_terms((n as u64).saturating_mul(n as u64));
    let shown = derive::positivity_by_elevation(&polynomial, &variable, &ends, n, strict);
    let shown = shown.ok_or_else(|| {
        Diagnostic::error(
            Code::Undecided,
            format!("a coefficient of degree {n} is negative, which says nothing"),
        )
        .at(span)
        .hint("without degree=n the interval is halved until the sign is known; or try a higher degree")
    })?;
    told(args, shown)
}

/// P Q for P/Q, which has the sign of the quotient where Q is not 0.
fn with_its_sign(
    args: &Arguments,
    formula: &Fraction,
    ends: [Option<&Rational>; 2],
) -> Result<(Poly, Symbol)> {
    let variable = formula::variable_of(formula, args.variable()?).at(args.span(0))?;
    let of = |p: &MultiPoly| {
        p.coefficients_in(&variable).iter().map(MultiPoly::as_constant).collect::<Option<Poly>>()
    };
    let (Some(p), Some(q)) = (of(formula.numerator()), of(formula.denominator())) else {
        return Err(Diagnostic::error(Code::Type, "the signs of its values have to be known")
            .at(args.span(0))
            .hint("give the other symbols values first"));
    };
    if let Some((root, _)) = q.real_roots(ends[0], ends[1]).unwrap_or_default().into_iter().next() {
        let place = crate::language::write::text(&Value::root(root, &variable).to_expr());
        let message = format!("the denominator is 0 at {variable} = {place}");
        return Err(Diagnostic::error(Code::Domain, message)
            .at(args.span(0))
            .hint("give an interval in which it is not 0"));
    }
    Ok((&p * &q, variable))
}

/// A formula as a polynomial in the variable times a fraction without it.
fn over_constant(args: &Arguments, i: usize, variable: &Symbol) -> Result<(MultiPoly, Fraction)> {
    let f = args.scalar(i)?;
    // Says what is wrong if the variable stands below.
    formula::coefficients_in(&f, variable).at(args.span(i))?;
    let below = Fraction::from(f.denominator().clone()).inverse().unwrap_or_else(Fraction::zero);
    Ok((f.numerator().clone(), below))
}

/// The polynomial with these numbers as coefficients.
pub(super) fn with_numbers(given: &Univariate) -> Option<Poly> {
    given.coefficients.iter().map(Fraction::as_rational).collect()
}

/// A polynomial with numbers as coefficients, and its variable.
pub(super) fn numeric(args: &Arguments, i: usize) -> Result<(Poly, Symbol)> {
    let given = args.univariate(i)?;
    let polynomial = with_numbers(&given).ok_or_else(|| {
        let mut others: Vec<String> =
            given.coefficients.iter().flat_map(Fraction::variables).map(|s| s.to_string()).collect();
        others.sort();
        others.dedup();
        let message = "the signs of its values have to be known: numbers as coefficients are needed";
        Diagnostic::error(Code::Type, message).at(args.span(i)).hint(format!(
            "give {} a value first, for example {} := 3",
            others.join(", "),
            others[0]
        ))
    })?;
    Ok((polynomial, given.variable))
}

fn zero_polynomial(args: &Arguments) -> Diagnostic {
    Diagnostic::error(Code::Domain, "every number is a root of 0")
        .at(args.span(0))
        .hint("give a polynomial that is not 0")
}

/// The ends of an interval at two places, in order.
pub(super) fn interval(args: &Arguments, i: usize) -> Result<(Option<Rational>, Option<Rational>)> {
    let end = |i: usize| args.given(i).map(|_| args.rational(i)).transpose();
    let (a, b) = (end(i)?, end(i + 1)?);
    if let (Some(a), Some(b)) = (&a, &b)
        && a > b
    {
        let error = Diagnostic::error(Code::Domain, format!("the interval [{a}, {b}] is empty"));
        return Err(error.at(args.span(i + 1)).hint("give the lower end first"));
    }
    Ok((a, b))
}

pub(super) fn width(args: &Arguments) -> Result<Option<Rational>> {
    let Some((value, span)) = args.named("width") else { return Ok(None) };
    let width = value.as_rational().ok_or_else(|| wrong_kind("a number", value).at(span))?;
    if !width.is_positive() {
        let error = Diagnostic::error(Code::Domain, "a width has to be positive").at(span);
        return Err(error.hint("width=1/1000"));
    }
    Ok(Some(width))
}

fn shown(root: RealRoot, variable: &Symbol, width: Option<&Rational>) -> Value {
    let root = match (root, width) {
        (RealRoot::Irrational(number), Some(width)) => RealRoot::Irrational(number.refined(width)),
        (root, _) => root,
    };
    Value::root(root, variable)
}

fn roots(machine: &mut Machine, args: &Arguments) -> Result<Value> {
    let (polynomial, variable) = numeric(args, 0)?;
    let ((a, b), width) = (interval(args, 1)?, width(args)?);
    let found = polynomial.real_roots(a.as_ref(), b.as_ref()).ok_or_else(|| zero_polynomial(args))?;
    if let (None, None) = (&a, &b) {
        let real = found.iter().map(|(_, m)| m).sum();
        note_complex(machine, real, polynomial.degree().unwrap_or(0), args);
    }
    let list = found.into_iter().flat_map(|(root, multiplicity)| {
        let value = shown(root, &variable, width.as_ref());
        std::iter::repeat_n(value, multiplicity)
    });
    Ok(Value::List(list.collect()))
}

fn extreme(machine: &mut Machine, args: &Arguments, largest: bool) -> Result<Value> {
    let formula = args.scalar(0)?;
    let variable = formula::variable_of(&formula, args.variable()?).at(args.span(0))?;
    let (a, b) = match interval(args, 1)? {
        (Some(a), Some(b)) => (a, b),
        (a, b) => within_all(args, &formula, &variable, [a, b], largest)?,
    };
    let within = Within { name: &variable, ends: [&a, &b], open: [false, false] };
    let found = within.extreme(&formula, largest).at(args.span(0))?;
    machine.note(extremes::taken(&found, &variable).at(args.span(0)));
    Ok(Value::root(found.value, &variable))
}

/// An interval in which the largest or smallest value of a polynomial on a half-line or on all numbers is taken.
fn within_all(
    args: &Arguments,
    formula: &Fraction,
    variable: &Symbol,
    [a, b]: [Option<Rational>; 2],
    largest: bool,
) -> Result<(Rational, Rational)> {
    let numbers = |of: Vec<Fraction>| of.iter().map(Fraction::as_rational).collect::<Option<Poly>>();
    let polynomial = match formula.denominator().as_constant().is_some() {
        true => numbers(formula::coefficients_in(formula, variable).at(args.span(0))?),
        false => None,
    };
    let Some(polynomial) = polynomial else {
        return Err(Diagnostic::error(Code::Arity, "an interval is needed here")
            .at(args.span(0))
            .hint("without one there is a largest value of polynomials with numbers as coefficients only"));
    };
    let slope = polynomial.derivative();
    let leading = polynomial.leading_coefficient();
    // Beyond the critical points the values only fall, or rise.
    let ratios = slope.coefficients().iter().map(|c| (c / slope.leading_coefficient()).abs()).max();
    let bound = ratios.unwrap_or_default() + integer(1);
    let even = polynomial.degree().unwrap_or(0).is_multiple_of(2);
    let falls = |to_left: bool| leading.is_negative() != (to_left && !even);
    let open_left = a.is_none() && falls(true) != largest;
    let open_right = b.is_none() && falls(false) != largest;
    if !slope.is_zero() && (open_left || open_right) {
        let which = if largest { "largest" } else { "smallest" };
        let problem = Diagnostic::error(Code::Domain, format!("there is no {which} value"));
        return Err(problem
            .at(args.span(0))
            .reason(if largest { "the values have no upper bound" } else { "the values have no lower bound" })
            .hint("there is one on an interval: on [0, 1]"));
    }
    let lower = a.clone().unwrap_or_else(|| -b.clone().map_or(bound.clone(), |b| b.abs() + &bound));
    let upper = b.unwrap_or_else(|| a.map_or(bound.clone(), |a| a.abs() + &bound));
    Ok((lower, upper))
}

fn root_of(_: &mut Machine, args: &Arguments) -> Result<Value> {
    let (polynomial, variable) = numeric(args, 0)?;
    let ((a, b), width) = (interval(args, 1)?, width(args)?);
    let (from, to) = (a.clone().unwrap_or_else(|| integer(0)), b.clone().unwrap_or_else(|| integer(0)));
    let mut found = polynomial.real_roots(a.as_ref(), b.as_ref()).ok_or_else(|| zero_polynomial(args))?;
    match found.len() {
        1 => Ok(shown(found.remove(0).0, &variable, width.as_ref())),
        0 => {
            let error = Diagnostic::error(Code::Domain, format!("there is no root in [{from}, {to}]"));
            Err(error.at(args.span(0)).hint("roots(F) gives all real roots"))
        }
        count => {
            let error = Diagnostic::error(Code::Domain, format!("there are {count} roots in [{from}, {to}]"));
            Err(error
                .at(args.span(0))
                .hint("give an interval with one of them; roots(F, a, b) gives them all"))
        }
    }
}

/// Says how many roots are not real.
pub(super) fn note_complex(machine: &mut Machine, real: usize, degree: usize, args: &Arguments) {
    let message = match degree - real {
        0 => return,
        left if left == degree => format!("none of the {degree} roots is real"),
        left => format!("{left} of the {degree} roots are not real"),
    };
    machine.note(Diagnostic::note(Code::NotReal, message).at(args.span(0)));
}
