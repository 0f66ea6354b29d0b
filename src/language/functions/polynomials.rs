//! Polynomials and rational functions: parts, division, calculus.

use super::Builtin;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::arguments::{self, Arguments};
use crate::language::eval::arithmetic::{self, division_by_zero};
use crate::language::eval::{calculus, wrong_kind};
use crate::language::value::Value;
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use num_traits::Zero;

type Result<T> = std::result::Result<T, Diagnostic>;

const TOPIC: &str = "Polynomials";

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "degree",
        signature: "degree(F, t)",
        summary: "the degree of a polynomial in its variable, or of a polar form",
        example: "degree(t^3 + 1)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("degree(F, t)", 1..=2, &[])?;
            if let Value::Polar(polar) = args.value(0)? {
                let arity = polar.arity();
                return Ok(match arity.as_slice() {
                    [one] => Value::int(*one as i64),
                    many => Value::List(many.iter().map(|n| Value::int(*n as i64)).collect()),
                });
            }
            let given = args.univariate(0, 1)?;
            Ok(match given.coefficients.iter().rposition(|c| !c.is_zero()) {
                Some(degree) => Value::int(degree as i64),
                None => Value::Text("the zero polynomial has no degree".to_owned()),
            })
        },
    },
    Builtin {
        name: "coefficients",
        signature: "coefficients(F, t)",
        summary: "the list of coefficients, the constant first",
        example: "coefficients(t^3 + 3t^2 + 5t + 1)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("coefficients(F, t)", 1..=2, &[])?;
            let given = args.univariate(0, 1)?;
            Ok(Value::List(given.coefficients.into_iter().map(Value::Scalar).collect()))
        },
    },
    Builtin {
        name: "coefficient",
        signature: "coefficient(F, t, k)",
        summary: "the coefficient of t^k",
        example: "coefficient((t + 1)^5, t, 2)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("coefficient(F, t, k)", 3..=3, &[])?;
            let k = args.size(2)?;
            let given = args.univariate(0, 1)?;
            Ok(Value::Scalar(given.coefficients.get(k).cloned().unwrap_or_else(Fraction::zero)))
        },
    },
    Builtin {
        name: "expand",
        signature: "expand(F)",
        summary: "multiplied out (every value is kept that way; expand shows it)",
        example: "expand((t + 1)^3)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("expand(F)", 1..=1, &[])?;
            Ok(args.value(0)?.clone())
        },
    },
    Builtin {
        name: "subs",
        signature: "subs(F, t, value)",
        summary: "puts a value in place of a variable; subs(F, t=value) is the same",
        example: "subs(t^2 + c_0, t, 3)",
        topic: TOPIC,
        call: |_, args| {
            let formula = args.scalar(0)?;
            let mut values = args.substitutions()?;
            if values.is_empty() {
                args.expect("subs(F, t, value)", 3..=3, &[])?;
                values.push((args.symbol(1)?, args.scalar(2)?));
            }
            formula.substitute(&values).map(Value::Scalar).map_err(|_| division_by_zero())
        },
    },
    Builtin {
        name: "diff",
        signature: "diff(F, t, k)",
        summary: "the k-th derivative (the first if k is not given)",
        example: "diff(t^3, t, 2)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("diff(F, t, k)", 1..=3, &[])?;
            let order = args.named_size("k", 2)?.unwrap_or(1);
            match args.value(0)? {
                Value::Scalar(formula) => {
                    let given = if args.len() > 1 { Some(args.symbol(1)?) } else { None };
                    let variable = arguments::variable_of(formula, given).at(args.span(0))?;
                    Ok(Value::Scalar(calculus::nth_derivative(formula, &variable, order)))
                }
                other => calculus::derivative_of_function(other, order).at(args.span(0)),
            }
        },
    },
    Builtin {
        name: "derivative",
        signature: "derivative(f, k)",
        summary: "the k-th derivative of a function, formula or polar form (by unit vectors)",
        example: "derivative(polar(t^3), 1)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("derivative(f, k)", 1..=2, &[])?;
            let order = args.named_size("k", 1)?.unwrap_or(1);
            calculus::derivative_of_function(args.value(0)?, order).at(args.span(0))
        },
    },
    Builtin {
        name: "integrate",
        signature: "integrate(F, t, a, b)",
        summary: "the integral over [a, b]; without bounds the antiderivative that is 0 at 0",
        example: "integrate(t^2, t, 0, 1)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("integrate(F, t, a, b)", 1..=4, &[])?;
            let formula = args.scalar(0)?;
            let given = if args.len() > 1 { Some(args.symbol(1)?) } else { None };
            let variable = arguments::variable_of(&formula, given).at(args.span(0))?;
            let bounds = match args.len() {
                4 => Some((args.scalar(2)?, args.scalar(3)?)),
                3 => {
                    return Err(Diagnostic::error(Code::Arity, "an integral needs both bounds or none")
                        .at(args.span(2)));
                }
                _ => None,
            };
            let bounds = bounds.as_ref().map(|(a, b)| (a, b));
            calculus::integrate(&formula, &variable, bounds).map(Value::Scalar).at(args.span(0))
        },
    },
    Builtin {
        name: "compose",
        signature: "compose(F, G)",
        summary: "F(G(t)); also written F ∘ G",
        example: "compose(t^2 + 2t, t^3 + 1)",
        topic: TOPIC,
        call: |machine, args| {
            args.expect("compose(F, G)", 2..=2, &[])?;
            machine.compose(args.value(0)?.clone(), args.value(1)?.clone())
        },
    },
    Builtin {
        name: "gcd",
        signature: "gcd(a, b)",
        summary: "the greatest common divisor of two integers or polynomials",
        example: "gcd(t^2 - 1, t^2 + 2t + 1)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("gcd(a, b)", 2..=2, &[])?;
            let (a, b) = (polynomial(args, 0)?, polynomial(args, 1)?);
            if let (Some(x), Some(y)) = (a.as_constant(), b.as_constant())
                && x.is_integer()
                && y.is_integer()
            {
                let g = num_integer::Integer::gcd(x.numer(), y.numer());
                return Ok(Value::number(crate::math::number::Rational::from_integer(g)));
            }
            Ok(Value::Scalar(Fraction::from(a.gcd(&b))))
        },
    },
    Builtin {
        name: "quotient",
        signature: "quotient(F, G, t)",
        summary: "the quotient of the division of F by G with remainder",
        example: "quotient(t^3 + 1, t - 1, t)",
        topic: TOPIC,
        call: |_, args| divided(args, "quotient(F, G, t)").map(|(q, _)| Value::Scalar(q)),
    },
    Builtin {
        name: "remainder",
        signature: "remainder(F, G, t)",
        summary: "the remainder of the division of F by G",
        example: "remainder(t^3 + 1, t - 1, t)",
        topic: TOPIC,
        call: |_, args| divided(args, "remainder(F, G, t)").map(|(_, r)| Value::Scalar(r)),
    },
    Builtin {
        name: "count_roots",
        signature: "count_roots(F, a, b)",
        summary: "how many different real roots a polynomial has in (a, b], exactly (Sturm)",
        example: "count_roots(t^3 - t, 0, 2)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("count_roots(F, a, b)", 3..=3, &[])?;
            let given = args.univariate(0, usize::MAX)?;
            let list: Option<Vec<crate::math::number::Rational>> =
                given.coefficients.iter().map(Fraction::as_rational).collect();
            let list = list.ok_or_else(|| {
                Diagnostic::error(Code::Type, "roots are counted for numbers as coefficients only")
                    .at(args.span(0))
            })?;
            let roots = crate::math::poly::Poly::from_coefficients(list)
                .count_roots(&args.rational(1)?, &args.rational(2)?);
            match roots {
                Some(count) => Ok(Value::int(count as i64)),
                None => Err(Diagnostic::error(Code::Domain, "every number is a root of 0").at(args.span(0))),
            }
        },
    },
    Builtin {
        name: "numerator",
        signature: "numerator(R)",
        summary: "the numerator in lowest terms",
        example: "numerator((t^2 - 1)/(t - 1))",
        topic: TOPIC,
        call: |_, args| {
            args.expect("numerator(R)", 1..=1, &[])?;
            Ok(part(&args.scalar(0)?, true))
        },
    },
    Builtin {
        name: "denominator",
        signature: "denominator(R)",
        summary: "the denominator in lowest terms",
        example: "denominator(1/(2t) + 1/3)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("denominator(R)", 1..=1, &[])?;
            Ok(part(&args.scalar(0)?, false))
        },
    },
    Builtin {
        name: "bernstein",
        signature: "bernstein(n, i, t)",
        summary: "the Bernstein polynomial C(n, i) t^i (1 - t)^(n - i), 0 outside 0 <= i <= n",
        example: "bernstein(3, 1, t)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("bernstein(n, i, t)", 3..=3, &[])?;
            let n = args.size(0)?;
            let index = args.value(1)?;
            let i = index.as_int().ok_or_else(|| wrong_kind("an integer", index).at(args.span(1)))?;
            let t = args.scalar(2)?;
            let Some(i) = usize::try_from(i).ok().filter(|i| *i <= n) else { return Ok(Value::int(0)) };
            crate::budget::charge_terms(n as u64 + 1);
            let one = <Fraction as num_traits::One>::one();
            let powers = arithmetic::power(Value::Scalar(t.clone()), &Value::int(i as i64))?;
            let rest = arithmetic::power(Value::Scalar(one.minus(&t)), &Value::int((n - i) as i64))?;
            let count = Value::number(crate::math::number::Rational::from_integer(
                crate::math::number::binomial(n, i),
            ));
            arithmetic::multiply(arithmetic::multiply(count, powers)?, rest)
        },
    },
];

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
        Value::Scalar(Fraction::from(p.scaled(&crate::math::number::Rational::from_integer(by.clone()))))
    };
    if numerator { scale(f.numerator(), content.denom()) } else { scale(f.denominator(), content.denom()) }
}

/// Quotient and remainder in one variable, coefficients in the field of fractions.
fn divided(args: &Arguments, signature: &str) -> Result<(Fraction, Fraction)> {
    args.expect(signature, 2..=3, &[])?;
    let given: Option<Symbol> = if args.len() > 2 { Some(args.symbol(2)?) } else { None };
    let (f, g) = (args.scalar(0)?, args.scalar(1)?);
    let variable = arguments::variable_of(&f.plus(&g), given).at(args.span(0))?;
    let dividend = Coefficients::new(arguments::coefficients_in(&f, &variable).at(args.span(0))?);
    let divisor = Coefficients::new(arguments::coefficients_in(&g, &variable).at(args.span(1))?);
    let (quotient, rest) = dividend.div_rem(&divisor).ok_or_else(|| division_by_zero().at(args.span(1)))?;
    let t = Fraction::from(MultiPoly::symbol(variable));
    Ok((quotient.value(&t), rest.value(&t)))
}
