//! `solve`: linear equations in unknowns, and polynomial equations in one.

use nalgebra::DMatrix;
use num_traits::{One, Zero};

use super::parameter::{Parameter, Takes, named, optional, required};
use super::record::Variant;
use super::roots::note_complex;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Rel};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated, Machine};
use crate::language::ops::arithmetic::{add, negate};
use crate::language::ops::errors::{division_by_zero, linalg_error, wrong_kind};
use crate::language::ops::formula::symbol_of;
use crate::language::value::{Claim, PolarKind, Value, grouped_expr, polynomial_expr, symbol_expr};
use crate::language::write::text;
use crate::math::linalg::solutions;
use crate::math::poly::{Fraction, MultiPoly, Poly, Symbol};
use crate::math::ring::Ring;

type Result<T> = std::result::Result<T, Diagnostic>;

const PARAMETERS: &[Parameter] = &[
    required("equations", Takes::Equations, "equations, linear or polynomials in one unknown")
        .shown("[equation, ...]"),
    optional("unknowns", Takes::Any, "all symbols", "the unknown, or the list of them").shown("[x, ...]"),
    named(
        "all=t",
        Takes::Any,
        "no symbol",
        "the symbol for all values of which the equations hold, or the list",
    ),
];

/// How `solve` works on equations.
pub(super) const EQUATIONS: Option<Variant> = Variant::noting(PARAMETERS, solve);

/// The solutions of F = 0, where F stands by itself.
pub(super) fn zeros_of(machine: &mut Machine, args: &Arguments, formula: &Fraction) -> Evaluated {
    let equations = vec![formula.numerator().clone()];
    let (unknowns, _) = match args.given(1) {
        Some((value, span)) => symbols(value, span)?,
        None => all_symbols(&equations),
    };
    match unknowns.as_slice() {
        [unknown] if formula.numerator().degree_in(unknown) > 0 => {
            in_one_unknown(machine, args, &equations, unknown)
        }
        _ => Err(Diagnostic::error(Code::AmbiguousVariable, "for which variable is this to be solved?")
            .at(args.span(0))
            .hint("name it: solve(x^2 - a = 0, x)")),
    }
}

fn solve(machine: &mut Machine, args: &Arguments) -> Evaluated {
    let Value::Claim(claim) = args.value(0)? else { return Err(wrong_kind("equations", args.value(0)?)) };
    let span = args.span(0);
    let mut equations = zeros(claim).at(span)?;
    if let Some((value, span)) = args.named("all") {
        for symbol in symbols(value, span)?.0 {
            equations = equations.iter().flat_map(|p| p.coefficients_in(&symbol)).collect();
        }
    }
    let (unknowns, single) = match args.given(1) {
        Some((value, span)) => symbols(value, span)?,
        None => all_symbols(&equations),
    };
    if let [unknown] = unknowns.as_slice()
        && equations.iter().any(|p| p.degree_in(unknown) > 1)
    {
        return in_one_unknown(machine, args, &equations, unknown);
    }
    let (matrix, right) = linear(&equations, &unknowns).at(span)?;
    let found = solutions(&matrix, &right).map_err(linalg_error).at(span)?;
    if let Some(condition) = condition(&found.minor) {
        let note = format!("this holds where {condition}");
        machine.note(Diagnostic::note(Code::Singular, note).at(span));
    }
    let Some(constants) = found.constants else { return Ok(Value::Text("no solution".to_owned())) };
    let symbol = |i: usize| Fraction::from(MultiPoly::symbol(unknowns[i].clone()));
    if !found.free.is_empty() {
        let names: Vec<String> = found.free.iter().map(|&i| text(&symbol_expr(&unknowns[i]))).collect();
        let is = if names.len() == 1 { "is" } else { "are" };
        let note = format!("{} {is} free", names.join(", "));
        machine.note(Diagnostic::note(Code::Singular, note).at(span));
    }
    let mut values: Vec<Fraction> = (0..unknowns.len()).map(symbol).collect();
    for (k, (&i, constant)) in found.determined.iter().zip(constants).enumerate() {
        values[i] = found
            .free
            .iter()
            .enumerate()
            .fold(constant, |sum, (c, &j)| sum.plus(&found.coefficients[(k, c)].times(&symbol(j))));
    }
    if single {
        return Ok(Value::Scalar(values.swap_remove(0)));
    }
    let relation = |&i: &usize| Expr::relation(symbol_expr(&unknowns[i]), Rel::Eq, grouped_expr(&values[i]));
    let shown: Expr = Kind::List(found.determined.iter().map(relation).collect()).into();
    Ok(Value::written(Value::List(values.into_iter().map(Value::Scalar).collect()), shown))
}

/// The real solutions of polynomial equations in one unknown: the roots of their greatest common divisor.
fn in_one_unknown(
    machine: &mut Machine,
    args: &Arguments,
    equations: &[MultiPoly],
    unknown: &Symbol,
) -> Result<Value> {
    let common = equations.iter().fold(MultiPoly::zero(), |common, p| common.gcd(p));
    let coefficients = common.coefficients_in(unknown);
    let numbers: Option<Poly> = coefficients.iter().map(MultiPoly::as_constant).collect();
    let values = match numbers {
        Some(polynomial) => {
            let found = polynomial.real_roots(None, None).unwrap_or_default();
            let real = found.iter().map(|(_, m)| m).sum();
            note_complex(machine, real, polynomial.degree().unwrap_or(0), args);
            found.into_iter().map(|(root, _)| Value::root(root, unknown)).collect()
        }
        None => by_linear_factors(machine, args.span(0), &common, unknown)?,
    };
    if values.is_empty() {
        return Ok(Value::Text("no real solution".to_owned()));
    }
    let relation = |value: &Value| Expr::relation(symbol_expr(unknown), Rel::Eq, value.to_expr());
    let shown: Expr = Kind::List(values.iter().map(relation).collect()).into();
    Ok(Value::written(Value::list(values), shown))
}

/// The solutions of a product of factors that are linear in the unknown.
fn by_linear_factors(
    machine: &mut Machine,
    span: Span,
    product: &MultiPoly,
    unknown: &Symbol,
) -> Result<Vec<Value>> {
    let mut values = Vec::new();
    // What is divided by, and factors without the unknown: if one is 0, more is a solution.
    let mut others = MultiPoly::one();
    for (factor, _) in product.factors().factors {
        match factor.coefficients_in(unknown).as_slice() {
            [constant] => others = others.times(constant),
            [constant, slope] => {
                others = others.times(slope);
                let root = Fraction::new(-constant.clone(), slope.clone());
                values.push(Value::Scalar(root.map_err(|_| division_by_zero())?));
            }
            list => {
                let x = text(&symbol_expr(unknown));
                let message =
                    format!("an equation of degree {} in {x} has symbols as coefficients", list.len() - 1);
                return Err(Diagnostic::error(Code::Unsupported, message)
                    .at(span)
                    .hint("give the other symbols values first, then its roots are isolated")
                    .hint("discriminant(F, x) says where it has a repeated root"));
            }
        }
    }
    if let Some(condition) = condition(&Fraction::from(others)) {
        let note = format!("this holds where {condition}");
        machine.note(Diagnostic::note(Code::Singular, note).at(span));
    }
    Ok(values)
}

/// The polynomials that are 0 where the equations hold.
fn zeros(claim: &Claim) -> Result<Vec<MultiPoly>> {
    let mut all = Vec::new();
    for relation in &claim.judgements {
        if relation.rel != Rel::Eq {
            return Err(Diagnostic::error(Code::Type, "only equations can be solved")
                .hint("give equations: solve([x + y = 3, x - y = 1], [x, y])"));
        }
        let difference = negate(relation.right.clone()).and_then(|right| add(relation.left.clone(), right));
        components(&difference?, &mut all)?;
    }
    Ok(all.iter().map(|f: &Fraction| f.numerator().clone()).filter(|p| !p.is_zero()).collect())
}

/// The numbers and formulas of which a value is made.
fn components(value: &Value, all: &mut Vec<Fraction>) -> Result<()> {
    match value {
        Value::Scalar(f) | Value::Vector(f) => all.push(f.clone()),
        Value::List(items) => items.iter().try_for_each(|item| components(item, all))?,
        Value::Matrix(matrix) => all.extend(matrix.transpose().iter().cloned()),
        Value::Polar(polar) if let PolarKind::Univariate(form) = &polar.kind => {
            all.extend(form.coefficients().iter().cloned());
        }
        other => {
            return Err(wrong_kind("numbers, formulas or points on both sides", other)
                .hint("write equations between values: f(0, 1) = 2, c(1) = d(0)")
                .hint(
                    "or between formulas, for all values of the parameter: solve(c(t) = ..., [x], all=t)",
                ));
        }
    }
    Ok(())
}

/// The symbols that an argument names, and whether it names one without a list.
fn symbols(value: &Value, span: Span) -> Result<(Vec<Symbol>, bool)> {
    let symbol = |item: &Value| {
        symbol_of(item).ok_or_else(|| {
            let error = wrong_kind("an unknown", item).at(span);
            error.hint("unknowns are symbols without a value: solve(2 x = 1, x)")
        })
    };
    match value {
        Value::List(items) => Ok((items.iter().map(symbol).collect::<Result<_>>()?, false)),
        one => Ok((vec![symbol(one)?], true)),
    }
}

fn all_symbols(equations: &[MultiPoly]) -> (Vec<Symbol>, bool) {
    let mut symbols: Vec<Symbol> = equations.iter().flat_map(|p| p.variables().to_vec()).collect();
    symbols.sort();
    symbols.dedup();
    let single = symbols.len() == 1;
    (symbols, single)
}

/// The matrix and the right sides of the equations.
fn linear(equations: &[MultiPoly], unknowns: &[Symbol]) -> Result<(DMatrix<Fraction>, Vec<Fraction>)> {
    let mut matrix = DMatrix::zeros(equations.len(), unknowns.len());
    let mut right = Vec::with_capacity(equations.len());
    let nothing: Vec<(Symbol, MultiPoly)> = unknowns.iter().map(|x| (x.clone(), MultiPoly::zero())).collect();
    for (i, equation) in equations.iter().enumerate() {
        for (j, x) in unknowns.iter().enumerate() {
            let coefficient = equation.derivative(x);
            if let Some(other) = coefficient.variables().iter().find(|y| unknowns.contains(y)) {
                let (x, other) = (text(&symbol_expr(x)), text(&symbol_expr(other)));
                let message = match x == other {
                    true => format!("an equation is not linear in {x}"),
                    false => format!("an equation has a product of the unknowns {x} and {other}"),
                };
                return Err(Diagnostic::error(Code::Unsupported, message)
                    .hint("name the unknowns in which it is linear: solve(a x = b, x)")
                    .hint("polynomial equations are solved in one unknown; resultant(F, G, x) eliminates x from two"));
            }
            matrix[(i, j)] = Fraction::from(coefficient);
        }
        right.push(Fraction::from(-equation.substitute(&nothing)));
    }
    Ok((matrix, right))
}

/// That no factor of the minor is 0; `None` if it is a number.
fn condition(minor: &Fraction) -> Option<String> {
    let factors = minor.numerator().factors().factors.into_iter();
    let shown: Vec<String> =
        factors.map(|(p, _)| format!("{} != 0", text(&polynomial_expr(&Fraction::from(p))))).collect();
    (!shown.is_empty()).then(|| shown.join(" and "))
}
