//! Arrangements of a formula: the value stays, only how the answer is written changes.

use super::Builtin;
use super::builtin;
use super::gives::Gives;
use super::parameter::{CURVE, Parameter, SURFACE, VARIABLE, named, optional, required};
use super::record::Variant;
use crate::formula::source::Span;
use crate::formula::{Expr, Term};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Machine, call_geometry};
use crate::language::ops::errors::{curve_error, polar_error, wrong_kind};
use crate::language::ops::formula::{Univariate, is_parameter};
use crate::language::ops::takes::{Takes, alternatives};
use crate::language::value::{Form, Geometry, Notation, Value, exact_term, grouped_expr, in_powers_of};
use crate::math::blossom::PolarError;
use crate::math::curve::{BezierCurve, Interval};
use crate::math::number::{Int, Rational, prime_factors};
use crate::math::poly::{Coefficients, Fraction, MonomialOrder, MultiPoly, Symbol};
use num_traits::{One, Signed, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

/// How answers are arranged if a query does not say so.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Arrangement {
    /// Grouped, as on a board.
    #[default]
    Usual,
    /// As `collect` does it.
    Collect,
    /// As `expand`.
    Expand,
    /// As `factor`.
    Factor,
    /// As `in_powers`.
    InPowers,
    /// As `in_bernstein`.
    InBernstein,
}

impl Arrangement {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Usual, Self::Collect, Self::Expand, Self::Factor, Self::InPowers, Self::InBernstein];

    /// The word by which it is chosen: the function that does it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Usual => "usual",
            Self::Collect => "collect",
            Self::Expand => "expand",
            Self::Factor => "factor",
            Self::InPowers => "in_powers",
            Self::InBernstein => "in_bernstein",
        }
    }

    /// An answer so arranged; anything but a formula or a list of formulas stays, and so does what is
    /// arranged already.
    ///
    /// # Errors
    /// Why a formula cannot be arranged so.
    pub fn applied(self, machine: &mut Machine, value: &Value) -> Result<Option<Value>> {
        let formulas = match value {
            Value::Scalar(_) => std::slice::from_ref(value),
            Value::List(items) => items,
            _ => return Ok(None),
        };
        let Some(function) = builtin(self.name()) else { return Ok(None) };
        let varies = formulas.iter().any(|f| f.as_scalar().is_some_and(|f| !f.variables().is_empty()));
        if !varies || formulas.iter().any(|f| f.as_scalar().is_none()) {
            return Ok(None);
        }
        let mut arguments = Arguments::default();
        arguments.push(value.clone(), Span::default());
        function.run(machine, arguments).map(Some)
    }
}

impl std::str::FromStr for Arrangement {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        Self::ALL.into_iter().find(|one| one.name() == text).ok_or_else(|| {
            let names: Vec<&str> = Self::ALL.iter().map(|one| one.name()).collect();
            format!("'{text}' is no arrangement: {}", alternatives(&names))
        })
    }
}

const NEW: Builtin = Builtin::about("Polynomials");

const FORMULA: Parameter = required("F", Takes::Coordinates, "the polynomial; a list of them for a curve");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "expand",
        parameters: &[required("F", Takes::Any, "the formula")],
        summary: "the formula multiplied out",
        gives: Gives::Any,
        example: "expand((t - a)(t - b))",
        call: |_, args| {
            let value = args.value(0)?.clone();
            let expr = value.to_expr_in(Notation::Expanded);
            Ok(Value::written(value, expr))
        },
        ..NEW
    },
    Builtin {
        name: "factor",
        parameters: &[required("F", Takes::Formula, "the polynomial or rational function, or an integer")],
        summary: "the irreducible factors over Q, of a number the primes",
        gives: Gives::Scalar,
        example: "factor(2 t^4 - 8 t^2)",
        each: true,
        call: |_, args| {
            let value = match args.value(0)? {
                Value::Function(_) => formula_of(&args.univariate(0)?),
                _ => Value::Scalar(args.scalar(0)?),
            };
            let expr = value.as_scalar().map_or_else(|| value.to_expr(), factored);
            Ok(Value::written(value, expr))
        },
        ..NEW
    },
    Builtin {
        name: "simplify",
        parameters: &[required("F", Takes::Any, "the formula")],
        summary: "the formula in lowest terms, grouped (every answer is written that way)",
        gives: Gives::Any,
        example: "simplify((t^2 - 1)/(t - 1))",
        call: |_, args| Ok(args.value(0)?.clone()),
        ..NEW
    },
    Builtin {
        name: "collect",
        parameters: &[
            FORMULA,
            optional("variable", Takes::Variable, "the only variable, or t", "its variable").shown("t"),
        ],
        summary: "the polynomial by descending powers of its variable, with their coefficients",
        gives: Gives::Any,
        example: "collect(a x + b x + c, x)",
        call: |_, args| {
            let given = args.optional_symbol(1)?;
            arranged(args, |args| args.univariate_in(0, given.clone()), &Fraction::zero())
        },
        ..NEW
    },
    Builtin {
        name: "in_powers",
        parameters: &[
            FORMULA,
            optional("a", Takes::Scalar, "0", "the point at which it is expanded"),
            VARIABLE,
        ],
        summary: "the polynomial by powers of t - a: its expansion by Taylor's formula",
        gives: Gives::Any,
        example: "in_powers(t^3, 1)",
        on_curve: Variant::new(
            &[CURVE, optional("a", Takes::Scalar, "0", "the point at which it is expanded")],
            Gives::Any,
            curve_in_powers,
        ),
        call: |_, args| {
            let at = args.scalar(1)?;
            arranged(args, |args| args.univariate(0), &at)
        },
        ..NEW
    },
    Builtin {
        name: "in_bernstein",
        parameters: &[
            FORMULA,
            optional("degree", Takes::Size, "the degree of F", "the degree of the basis").shown("n"),
            named("a=0", Takes::Scalar, "0", "the start of the interval"),
            named("b=1", Takes::Scalar, "1", "its end"),
            VARIABLE,
        ],
        summary: "the polynomial as a combination of Bernstein polynomials over [a, b]",
        gives: Gives::Any,
        example: "in_bernstein(t^2, 3)",
        on_curve: Variant::new(&[CURVE], Gives::Any, |args| Ok(in_its_basis(args.value(0)?))),
        on_surface: Variant::new(&[SURFACE], Gives::Any, |args| Ok(in_its_basis(args.value(0)?))),
        call: |_, args| in_bernstein(args),
        ..NEW
    },
];

/// A formula as a number times powers of irreducible polynomials, over such a product.
fn factored(f: &Fraction) -> Expr {
    let number = f.as_rational();
    let (mut top, bottom) = (f.numerator().factors(), f.denominator().factors());
    top.constant /= bottom.constant;
    let power = |base: Expr, m: usize| if m == 1 { base } else { base.power(Expr::int(m as i64)) };
    if let Some(q) = number.filter(|q| !q.is_zero()) {
        let primes = |n: &Int| {
            let primes = prime_factors(n).into_iter();
            let prime = |(p, m): (Int, u32)| power(Expr::number(&Rational::from_integer(p)), m as usize);
            Expr::product(primes.map(prime).collect())
        };
        let whole = primes(q.numer());
        let expr = if q.denom().is_one() { whole } else { whole.over(primes(q.denom())) };
        return if q.is_negative() { expr.negated() } else { expr };
    }
    let mut powers = |factors: Vec<(MultiPoly, usize)>| -> Vec<Expr> {
        let one = |(p, m): (MultiPoly, usize)| {
            let (p, turned) = upright(p);
            if turned && m % 2 == 1 {
                top.constant = -top.constant.clone();
            }
            power(grouped_expr(&Fraction::from(p)), m)
        };
        // t^2 before the sums.
        let (symbols, sums): (Vec<_>, Vec<_>) = factors.into_iter().partition(|(p, _)| p.len() == 1);
        symbols.into_iter().chain(sums).map(one).collect()
    };
    let (above, below) = (powers(top.factors), powers(bottom.factors));
    let term = exact_term(&top.constant, above);
    let expr = if below.is_empty() { term.expr } else { term.expr.over(Expr::product(below)) };
    Expr::sum(vec![Term { sign: term.sign, expr }])
}

/// The factor with a positive leading coefficient in its parameter, t - a rather than a - t, and whether its
/// sign was turned.
fn upright(p: MultiPoly) -> (MultiPoly, bool) {
    let Some(parameter) = p.variables().iter().find(|symbol| is_parameter(symbol)) else { return (p, false) };
    let lead =
        p.coefficients_in(parameter).pop().and_then(|lead| lead.terms(MonomialOrder::Lex).into_iter().next());
    match lead {
        Some((_, c)) if c.is_negative() => (-p, true),
        _ => (p, false),
    }
}

/// Each coordinate by powers of t - a.
fn arranged(
    args: &Arguments,
    read: impl Fn(&Arguments) -> Result<Univariate>,
    at: &Fraction,
) -> Result<Value> {
    let one = |item: &Value| -> Result<(Value, Expr)> {
        let given = read(&args.with_first(item.clone()))?;
        if at.variables().contains(&given.variable) {
            let error = Diagnostic::error(Code::Domain, "the point must not depend on the variable");
            return Err(error.at(args.span(1)).hint("choose a number or another letter"));
        }
        Ok((formula_of(&given), in_powers_of(&given.coefficients, &given.variable, at)))
    };
    match args.value(0)? {
        Value::List(items) => {
            let parts = items.iter().map(one).collect::<Result<Vec<_>>>()?;
            let (values, exprs) = parts.into_iter().unzip();
            Ok(Value::written(Value::List(items.with(values)), items.formula(exprs)))
        }
        item => one(item).map(|(value, expr)| Value::written(value, expr)),
    }
}

/// The polynomial with these coefficients.
fn formula_of(given: &Univariate) -> Value {
    let t = Fraction::from(MultiPoly::symbol(given.variable.clone()));
    Value::Scalar(Coefficients::new(given.coefficients.clone()).value(&t))
}

fn curve_in_powers(args: &Arguments) -> Result<Value> {
    let Value::Geometry(curve) = args.value(0)? else { return Err(wrong_kind("a curve", args.value(0)?)) };
    let t = Value::symbol(curve.parameter());
    let formula = call_geometry(curve, &[(t, args.span(0))], args.span(0))?;
    let at = args.scalar(1)?;
    arranged(&args.with_first(formula), |args| args.univariate_in(0, Some(curve.parameter())), &at)
}

/// A curve or surface by its control points and basis functions.
fn in_its_basis(geometry: &Value) -> Value {
    Value::written(geometry.clone(), geometry.display_expr(Notation::Grouped))
}

fn in_bernstein(args: &Arguments) -> Result<Value> {
    let (items, scalar) = match args.value(0)? {
        Value::List(items) => (items.to_vec(), false),
        one => (vec![one.clone()], true),
    };
    let read = |item: &Value| args.with_first(item.clone()).univariate(0);
    let parts = items.iter().map(read).collect::<Result<Vec<Univariate>>>()?;
    let end = |name: &str, usual: Fraction| match args.named(name) {
        None => Ok(usual),
        Some((Value::Scalar(x), _)) => Ok(x.clone()),
        Some((other, span)) => Err(wrong_kind("a number or formula", other).at(span)),
    };
    let interval = Interval::new(end("a", Fraction::zero())?, end("b", Fraction::one())?);
    let coordinates: Vec<Vec<Fraction>> = parts.iter().map(|part| part.coefficients.clone()).collect();
    let curve =
        interval.map_err(Into::into).and_then(|interval| BezierCurve::from_power(&coordinates, interval));
    let mut curve = curve.map_err(curve_error).at(args.span(0))?;
    if let Some(asked) = args.optional_size(1)? {
        let polynomial = curve.degree();
        let more = asked.checked_sub(polynomial);
        let too_small = || polar_error(PolarError::DegreeTooSmall { polynomial, asked }).at(args.span(1));
        curve = curve.elevate(more.ok_or_else(too_small)?);
    }
    let parameter = parts.first().map_or_else(|| Symbol::new("t"), |part| part.variable.clone());
    let expr = Geometry::Bezier(curve, Form { scalar, rational: false }).display_expr_in(&parameter);
    let mut formulas: Vec<Value> = parts.iter().map(formula_of).collect();
    let value = if scalar { formulas.swap_remove(0) } else { Value::point(formulas) };
    Ok(Value::written(value, expr))
}
