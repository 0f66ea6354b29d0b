//! Polynomials and rational functions: parts, division, calculus.

use super::gives::Gives;
use super::parameter::{DEGREE, Parameter, free, many, optional, required, size};
use super::{Builtin, on_form, on_geometry, on_surface, surface_compositions};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::lexicon::families;
use crate::language::ops::errors::{division_by_zero, wrong_kind};
use crate::language::ops::takes::Takes;
use crate::language::ops::{calculus, formula, function};
use crate::language::value::Value;
use crate::math::number::Rational;
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use num_traits::{One, Signed, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Polynomials");

/// The variable of a formula, at its place.
const LETTER: Parameter =
    optional("variable", Takes::Variable, "the only variable, or t", "its variable").shown("t");

/// Of a division with remainder.
const DIVISION: &[Parameter] =
    &[required("F", Takes::Scalar, "the dividend"), required("G", Takes::Scalar, "the divisor"), LETTER];

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "degree",
        parameters: &[required("F", Takes::Polynomial, "the polynomial or polar form"), LETTER],
        summary: "the degree of a polynomial in its variable, or of a polar form",
        gives: Gives::Any,
        example: "degree(t^3 + 1)",
        on_curve: on_geometry::DEGREE,
        on_surface: on_surface::DEGREE,
        call: |_, args| {
            if let Value::Polar(polar) = args.value(0)? {
                let arity = polar.arity();
                return Ok(match arity.as_slice() {
                    [one] => Value::int(*one as i64),
                    many => Value::List(many.iter().map(|n| Value::int(*n as i64)).collect()),
                });
            }
            let given = args.univariate_in(0, args.optional_symbol(1)?)?;
            Ok(match given.coefficients.iter().rposition(|c| !c.is_zero()) {
                Some(degree) => Value::int(degree as i64),
                None => Value::Text("the zero polynomial has no degree".to_owned()),
            })
        },
        ..NEW
    },
    Builtin {
        name: "coefficients",
        parameters: &[required("F", Takes::Polynomial, "the polynomial"), LETTER],
        summary: "the list of coefficients, the constant first",
        gives: Gives::List,
        example: "coefficients(t^3 + 3t^2 + 5t + 1)",
        on_curve: on_geometry::COEFFICIENTS,
        call: |_, args| {
            let given = args.univariate_in(0, args.optional_symbol(1)?)?;
            Ok(Value::List(given.coefficients.into_iter().map(Value::Scalar).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "coefficient",
        parameters: &[
            required("F", Takes::Polynomial, "the polynomial"),
            required("t", Takes::Variable, "its variable"),
            size("k", "the exponent"),
        ],
        summary: "the coefficient of t^k",
        gives: Gives::Scalar,
        example: "coefficient((t + 1)^5, t, 2)",
        call: |_, args| {
            let k = args.size(2)?;
            let given = args.univariate_in(0, args.optional_symbol(1)?)?;
            Ok(Value::Scalar(given.coefficients.get(k).cloned().unwrap_or_else(Fraction::zero)))
        },
        ..NEW
    },
    Builtin {
        name: "subs",
        parameters: &[
            required("F", Takes::Formula, "the formula"),
            required("t", Takes::Variable, "the variable"),
            required("value", Takes::Scalar, "what stands in its place"),
            free("t=value", Takes::Scalar, "instead, values for any variables at once, such as t=3, c_0=1"),
        ],
        summary: "puts a value in place of a variable; subs(F, t=value) is the same",
        gives: Gives::Any,
        example: "subs(t^2 + c_0, t, 3)",
        on_curve: on_geometry::SUBS,
        each: true,
        call: |_, args| {
            let mut values = args.substitutions()?;
            let Value::Function(of) = args.value(0)? else {
                return substituted(args.scalar(0)?, values, args);
            };
            // F(t) = a t with a=2 is 2 t, as a function of t; with t=2 it is a value.
            let Some((names, formula)) = of.as_formula_of_many() else {
                return Err(wrong_kind("a number or formula", args.value(0)?).at(args.span(0)));
            };
            if values.is_empty() {
                values.push((args.symbol(1)?, args.scalar(2)?));
            }
            let bound = values.iter().any(|(name, _)| names.contains(&name));
            let value = substituted(formula.clone(), values, args)?;
            Ok(match value {
                Value::Scalar(formula) if !bound => {
                    function::function_of(names.into_iter().cloned().collect(), formula)
                }
                value => value,
            })
        },
        ..NEW
    },
    Builtin {
        name: "diff",
        parameters: &[
            required("F", Takes::Function, "the formula, function or polar form; a list of them for a curve"),
            LETTER,
            optional("k", Takes::Size, "1", "how often"),
        ],
        summary: "the k-th derivative (the first if k is not given)",
        gives: Gives::Function,
        example: "diff(t^3, t, 2)",
        each: true,
        on_curve: on_geometry::DERIVATIVE,
        on_surface: on_surface::DERIVATIVE,
        on_form: on_form::DERIVATIVE,
        call: |_, args| {
            let order = args.size(2)?;
            match args.value(0)? {
                Value::Scalar(formula) => {
                    let given = args.optional_symbol(1)?;
                    let variable = formula::variable_of(formula, given).at(args.span(0))?;
                    Ok(Value::Scalar(calculus::nth_derivative(formula, &variable, order)))
                }
                other => {
                    let given = args.optional_symbol(1)?;
                    let partial = match (other, given) {
                        (Value::Function(function), Some(name)) => {
                            function::partial(function, &[(name, order)])
                        }
                        _ => None,
                    };
                    partial.map_or_else(|| calculus::derivative(other, order).at(args.span(0)), Ok)
                }
            }
        },
        ..NEW
    },
    Builtin {
        name: "derivative",
        parameters: &[
            required("f", Takes::Function, "the function, formula or polar form; a list of them for a curve"),
            optional("k", Takes::Size, "1", "how often"),
        ],
        summary: "the k-th derivative of a function, formula or polar form (by unit vectors)",
        gives: Gives::Function,
        example: "derivative(polar(t^3), 1)",
        each: true,
        on_curve: on_geometry::DERIVATIVE,
        on_surface: on_surface::DERIVATIVE,
        on_form: on_form::DERIVATIVE,
        call: |_, args| {
            let order = args.size(1)?;
            calculus::derivative(args.value(0)?, order).at(args.span(0))
        },
        ..NEW
    },
    Builtin {
        name: "taylor",
        parameters: &[
            required("F", Takes::Scalar, "the formula, also a fraction"),
            required("a", Takes::Scalar, "the point"),
            DEGREE,
            LETTER,
        ],
        summary: "the Taylor polynomial of degree n at a: the sum of F^(k)(a)/k! (t - a)^k for k up to n",
        gives: Gives::Function,
        example: "taylor(t^4, 1, 2)",
        call: |_, args| {
            let (formula, at, degree) = (args.scalar(0)?, args.scalar(1)?, args.size(2)?);
            let variable = formula::variable_of(&formula, args.optional_symbol(3)?).at(args.span(0))?;
            let step = Fraction::from(MultiPoly::symbol(variable.clone())).minus(&at);
            let (mut sum, mut power, mut derived) = (Fraction::zero(), Fraction::one(), formula);
            for k in 0..=degree {
                let value = derived.substitute(&[(variable.clone(), at.clone())]);
                sum = sum.plus(&value.map_err(|_| division_by_zero()).at(args.span(1))?.times(&power));
                let next =
                    Fraction::from(MultiPoly::constant(Rational::new(1.into(), (k as u64 + 1).into())));
                power = power.times(&step).times(&next);
                derived = derived.derivative(&variable);
            }
            Ok(Value::Scalar(sum))
        },
        ..NEW
    },
    Builtin {
        name: "integrate",
        parameters: &[
            required("F", Takes::Function, "the formula, or a function of one variable"),
            LETTER,
            optional("a", Takes::Scalar, "no bounds", "the lower bound"),
            optional("b", Takes::Scalar, "no bounds", "the upper bound"),
        ],
        summary: "the integral over [a, b]; without bounds the antiderivative that is 0 at 0",
        gives: Gives::Scalar,
        example: "integrate(t^2, t, 0, 1)",
        on_curve: on_geometry::INTEGRATE,
        on_surface: on_surface::INTEGRATE,
        call: |_, args| {
            let (formula, own) = match args.value(0)? {
                Value::Function(function) if let Some((own, formula)) = function.as_formula() => {
                    (formula.clone(), Some(own.clone()))
                }
                _ => (args.scalar(0)?, None),
            };
            let variable =
                formula::variable_of(&formula, args.optional_symbol(1)?.or(own)).at(args.span(0))?;
            let bounds = on_geometry::bounds(args)?;
            let bounds = bounds.as_ref().map(|(a, b)| (a, b));
            calculus::integrate(&formula, &variable, bounds).map(Value::Scalar).at(args.span(0))
        },
        ..NEW
    },
    Builtin {
        name: "compose",
        parameters: &[
            required("F", Takes::Function, "the outer function"),
            required("G", Takes::Function, "the inner function"),
        ],
        summary: "F(G(t)); also written F ∘ G",
        gives: Gives::Function,
        example: "compose(t^2 + 2t, t^3 + 1)",
        on_curve: on_geometry::COMPOSE,
        on_surface: surface_compositions::COMPOSE,
        call: |_, args| calculus::compose(args.value(0)?, args.value(1)?),
        ..NEW
    },
    Builtin {
        name: "gcd",
        parameters: &[many("a, b, ...", Takes::Scalar, 1, "numbers or polynomials")],
        summary: "the greatest common divisor of numbers or polynomials, with that of their coefficients",
        gives: Gives::Scalar,
        example: "gcd(t^2 - 1, t^2 + 2t + 1)",
        call: |_, args| {
            let mut common = polynomial(args, 0)?;
            for at in 1..args.len() {
                common = with_contents(&common, &polynomial(args, at)?);
            }
            Ok(Value::Scalar(Fraction::from(common)))
        },
        ..NEW
    },
    Builtin {
        name: "lcm",
        parameters: &[many("a, b, ...", Takes::Scalar, 1, "numbers or polynomials")],
        summary: "the least common multiple: the product of two divided by their greatest common divisor",
        gives: Gives::Scalar,
        example: "lcm(t^2 - 1, t^2 + 2t + 1)",
        call: |_, args| {
            let mut multiple = polynomial(args, 0)?;
            for at in 1..args.len() {
                let next = polynomial(args, at)?;
                let common = with_contents(&multiple, &next);
                multiple = multiple.times(&next).div_exact(&common).unwrap_or_else(MultiPoly::zero);
            }
            // Of numbers it is not negative, as their greatest common divisor.
            let negative = multiple.as_constant().is_some_and(|number| number.is_negative());
            Ok(Value::Scalar(Fraction::from(if negative {
                multiple.scaled(&Rational::from_integer((-1).into()))
            } else {
                multiple
            })))
        },
        ..NEW
    },
    Builtin {
        name: "quotient",
        parameters: DIVISION,
        summary: "the quotient of the division of F by G with remainder",
        gives: Gives::Function,
        example: "quotient(t^3 + 1, t - 1, t)",
        call: |_, args| divided(args).map(|(q, _)| Value::Scalar(q)),
        ..NEW
    },
    Builtin {
        name: "remainder",
        parameters: DIVISION,
        summary: "the remainder of the division of F by G",
        gives: Gives::Function,
        example: "remainder(t^3 + 1, t - 1, t)",
        call: |_, args| divided(args).map(|(_, r)| Value::Scalar(r)),
        ..NEW
    },
    Builtin {
        name: "numerator",
        parameters: &[required("R", Takes::Scalar, "the fraction")],
        summary: "the numerator in lowest terms",
        gives: Gives::Scalar,
        example: "numerator((t^2 - 1)/(t - 1))",
        call: |_, args| Ok(part(&args.scalar(0)?, true)),
        ..NEW
    },
    Builtin {
        name: "denominator",
        parameters: &[required("R", Takes::Scalar, "the fraction")],
        summary: "the denominator in lowest terms",
        gives: Gives::Scalar,
        example: "denominator(1/(2t) + 1/3)",
        call: |_, args| Ok(part(&args.scalar(0)?, false)),
        ..NEW
    },
    Builtin {
        name: "bernstein",
        parameters: &[
            DEGREE,
            optional("i", Takes::Integer, "all of them", "its number"),
            optional("t", Takes::Scalar, "t", "the parameter"),
        ],
        summary: "the Bernstein polynomial C(n, i) t^i (1 - t)^(n - i), or 0; without i, all of them",
        gives: Gives::Point,
        example: "bernstein(3, 1, t)",
        call: |_, args| {
            let n = args.size(0)?;
            let t = match args.given(2) {
                Some(_) => args.scalar(2)?,
                None => Fraction::from(MultiPoly::symbol(Symbol::new("t"))),
            };
            let one = |i| Value::Scalar(families::bernstein(n as i64, i, &t));
            let Some((index, span)) = args.given(1) else {
                return Ok(Value::List((0..=n as i64).map(one).collect()));
            };
            index.as_int().map(one).ok_or_else(|| wrong_kind("an integer", index).at(span))
        },
        ..NEW
    },
];

/// The gcd of two polynomials as those over the integers have it, extended to fractions: gcd(c a, c b) =
/// |c| gcd(a, b). The quotients by it have integer coefficients without a common divisor.
fn with_contents(a: &MultiPoly, b: &MultiPoly) -> MultiPoly {
    let (x, y) = (a.content(), b.content());
    let numerator = num_integer::Integer::gcd(&(x.numer() * y.denom()), &(y.numer() * x.denom()));
    a.gcd(b).scaled(&Rational::new(numerator, x.denom() * y.denom()))
}

fn polynomial(args: &Arguments, i: usize) -> Result<MultiPoly> {
    let formula = args.scalar(i)?;
    formula
        .as_polynomial()
        .cloned()
        .ok_or_else(|| wrong_kind("a polynomial", &Value::Scalar(formula.clone())).at(args.span(i)))
}

/// Numerator and denominator with integer coefficients.
fn part(f: &Fraction, numerator: bool) -> Value {
    let content = f.numerator().content();
    let scale = |p: &MultiPoly, by: &crate::math::number::Int| {
        Value::Scalar(Fraction::from(p.scaled(&Rational::from_integer(by.clone()))))
    };
    if numerator { scale(f.numerator(), content.denom()) } else { scale(f.denominator(), content.denom()) }
}

/// Quotient and remainder in one variable, coefficients in the field of fractions.
pub(super) fn divided(args: &Arguments) -> Result<(Fraction, Fraction)> {
    let given = args.optional_symbol(2)?;
    let (f, g) = (args.scalar(0)?, args.scalar(1)?);
    // As constant polynomials, which leave nothing, they are hardly meant.
    if let (Some(a), Some(b), None) = (f.as_rational(), g.as_rational(), &given) {
        return Err(Diagnostic::error(Code::Type, "numbers, or constant polynomials?")
            .at(args.span(0))
            .hint(format!("of numbers write mod({a}, {b}) and floor({a}/({b}))"))
            .hint("of polynomials name the variable: remainder(F, G, t)"));
    }
    let variable = formula::variable_of(&f.plus(&g), given).at(args.span(0))?;
    let dividend = Coefficients::new(formula::coefficients_in(&f, &variable).at(args.span(0))?);
    let divisor = Coefficients::new(formula::coefficients_in(&g, &variable).at(args.span(1))?);
    let (quotient, rest) = dividend.div_rem(&divisor).ok_or_else(|| division_by_zero().at(args.span(1)))?;
    let t = Fraction::from(MultiPoly::symbol(variable));
    Ok((quotient.value(&t), rest.value(&t)))
}

/// A formula with values in place of names.
fn substituted(formula: Fraction, mut values: Vec<(Symbol, Fraction)>, args: &Arguments) -> Result<Value> {
    match values.is_empty() {
        true => values.push((args.symbol(1)?, args.scalar(2)?)),
        false => occur(&formula, &values, args)?,
    }
    formula.substitute(&values).map(Value::Scalar).map_err(|_| division_by_zero())
}

/// Refuses a value for a name that does not occur in a formula with other names: it would change nothing.
fn occur(formula: &Fraction, values: &[(Symbol, Fraction)], args: &Arguments) -> Result<()> {
    let names = formula.variables();
    let unknown = values.iter().find(|(name, _)| !names.is_empty() && !names.contains(name));
    let Some((name, _)) = unknown else { return Ok(()) };
    let place = args.named(&name.to_string()).map_or_else(|| args.span(1), |(_, span)| span);
    let listed: Vec<String> = names.iter().map(ToString::to_string).collect();
    Err(Diagnostic::error(Code::Usage, format!("{name} does not occur in the formula"))
        .at(place)
        .reason("this value changes nothing")
        .hint(format!("give a value to one of its names: {}", listed.join(", "))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::rational;
    use crate::math::poly::Symbol;

    /// Of numbers by Euclid's algorithm on fractions; of polynomials by its laws: it divides both, the quotients
    /// have integer coefficients without a common divisor, and factors come out.
    #[test]
    fn common_divisors_include_those_of_the_coefficients() {
        let euclid = |mut a: Rational, mut b: Rational| {
            while !b.is_zero() {
                let rest = &a - &b * (&a / &b).floor();
                (a, b) = (b, rest);
            }
            num_traits::Signed::abs(&a)
        };
        let x = MultiPoly::symbol(Symbol::new("x"));
        let y = MultiPoly::symbol(Symbol::new("y"));
        for i in -6..7_i64 {
            for j in -6..7_i64 {
                let (p, q) = (rational(i, 1 + j * j % 4), rational(3 * j, 1 + i * i % 5));
                let (a, b) = (MultiPoly::constant(p.clone()), MultiPoly::constant(q.clone()));
                assert_eq!(
                    with_contents(&a, &b),
                    MultiPoly::constant(euclid(p.clone(), q.clone())),
                    "{p}, {q}"
                );
                let a = (x.clone() + a.clone()) * (x.clone() + y.clone()).scaled(&rational(i, 4));
                let b = (y.clone() + b.clone()) * (x.clone() + y.clone()).scaled(&rational(5, 6));
                let g = with_contents(&a, &b);
                assert_eq!(with_contents(&b, &a), g);
                let c = rational(-7, 3);
                assert_eq!(with_contents(&a.scaled(&c), &b.scaled(&c)), g.scaled(&rational(7, 3)));
                let quotients = [a, b].map(|p| p.div_exact(&g).expect("it divides both"));
                let contents = quotients.map(|q| q.content());
                assert!(contents.iter().all(Rational::is_integer), "{contents:?}");
                assert_eq!(euclid(contents[0].clone(), contents[1].clone()), rational(1, 1));
            }
        }
    }
}
