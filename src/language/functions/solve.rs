//! `solve`: linear equations in unknowns, polynomial ones with finitely many solutions; Gröbner bases.

use super::gives::Gives;
use nalgebra::DMatrix;
use num_traits::{One, Zero};

use super::notions::{chosen, words_of};
use super::parameter::{Parameter, named, optional, required};
use super::record::{Builtin, Variant};
use super::roots::note_complex;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Rel};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated, Machine};
use crate::language::ops::arithmetic::{add, negate};
use crate::language::ops::errors::{division_by_zero, linalg_error, wrong_kind};
use crate::language::ops::formula::symbol_of;
use crate::language::ops::takes::Takes;
use crate::language::value::{Claim, PolarKind, Value, grouped_expr, polynomial_expr, symbol_expr};
use crate::language::write::text;
use crate::math::linalg::solutions;
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Poly, Symbol};
use crate::math::ring::Ring;
use crate::math::system::{RealZero, SystemError, common_zeros, groebner_basis, real_zeros};

type Result<T> = std::result::Result<T, Diagnostic>;

const ORDERS: [(&str, MonomialOrder); 3] =
    [("lex", MonomialOrder::Lex), ("grlex", MonomialOrder::GrLex), ("grevlex", MonomialOrder::GrevLex)];

const PARAMETERS: &[Parameter] = &[
    required("equations", Takes::Equations, "equations, linear or polynomial").shown("[equation, ...]"),
    optional(
        "unknowns",
        Takes::OneOf(&[Takes::Variable, Takes::List]),
        "all symbols",
        "the unknown, or the list of them",
    )
    .shown("[x, ...]"),
    named(
        "all=t",
        Takes::OneOf(&[Takes::Variable, Takes::Variables]),
        "no symbol",
        "the symbol for all values of which the equations hold, or the list",
    ),
];

/// How `solve` works on equations.
pub(super) const EQUATIONS: Option<Variant> = Variant::noting(PARAMETERS, Gives::Any, solve);

/// The solutions of F = 0, where F stands by itself.
pub(super) fn zeros_of(machine: &mut Machine, args: &Arguments, formula: &Fraction) -> Evaluated {
    let equations = vec![formula.numerator().clone()];
    let (unknowns, single) = match args.given(1) {
        Some((value, span)) => symbols(value, span)?,
        None => all_symbols(&equations),
    };
    match unknowns.as_slice() {
        [unknown] if formula.numerator().degree_in(unknown) > 0 => {
            solved(machine, args, &equations, &unknowns, single)
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
    solved(machine, args, &equations, &unknowns, single)
}

/// The unknowns for which pairs of values are equal.
pub(super) fn equal<'a>(
    machine: &mut Machine,
    args: &Arguments,
    pairs: impl Iterator<Item = (&'a Fraction, &'a Fraction)>,
    unknowns: &Value,
    span: Span,
) -> Result<Value> {
    let differences = pairs.map(|(x, y)| x.minus(y).numerator().clone()).filter(|p| !p.is_zero());
    let equations: Vec<MultiPoly> = differences.collect();
    let (unknowns, single) = symbols(unknowns, span)?;
    solved(machine, args, &equations, &unknowns, single)
}

/// The solutions of A x = b, whatever the rank; those that are free have names of their own.
pub(super) fn of_any_rank(
    machine: &mut Machine,
    args: &Arguments,
    a: &DMatrix<Fraction>,
    b: &[Fraction],
) -> Result<Value> {
    let taken: Vec<Symbol> = a.iter().chain(b).flat_map(Fraction::variables).collect();
    let letters = ["x", "y", "z", "lambda"];
    let letter = letters.into_iter().find(|letter| taken.iter().all(|symbol| symbol.base() != *letter));
    let unknowns: Vec<Symbol> =
        (1..=a.ncols()).map(|i| Symbol::indexed(letter.unwrap_or("xi"), i as i64)).collect();
    by_elimination(machine, args, &unknowns, (a, b), false)
}

/// The values of the unknowns for which some polynomials are 0.
fn solved(
    machine: &mut Machine,
    args: &Arguments,
    equations: &[MultiPoly],
    unknowns: &[Symbol],
    single: bool,
) -> Result<Value> {
    let span = args.span(0);
    if let [unknown] = unknowns
        && equations.iter().any(|p| p.degree_in(unknown) > 1)
    {
        return in_one_unknown(machine, args, equations, unknown);
    }
    let (matrix, right) = match linear(equations, unknowns) {
        Some(system) => system,
        None => return in_several_unknowns(equations, unknowns).at(span),
    };
    by_elimination(machine, args, unknowns, (&matrix, &right), single)
}

/// The solutions of a linear system for the unknowns.
fn by_elimination(
    machine: &mut Machine,
    args: &Arguments,
    unknowns: &[Symbol],
    (matrix, right): (&DMatrix<Fraction>, &[Fraction]),
    single: bool,
) -> Result<Value> {
    let span = args.span(0);
    let found = solutions(matrix, right).map_err(linalg_error).at(span)?;
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

/// The matrix and the right sides of the equations; `None` if one is not linear in the unknowns.
fn linear(equations: &[MultiPoly], unknowns: &[Symbol]) -> Option<(DMatrix<Fraction>, Vec<Fraction>)> {
    let mut matrix = DMatrix::zeros(equations.len(), unknowns.len());
    let mut right = Vec::with_capacity(equations.len());
    let nothing: Vec<(Symbol, MultiPoly)> = unknowns.iter().map(|x| (x.clone(), MultiPoly::zero())).collect();
    for (i, equation) in equations.iter().enumerate() {
        for (j, x) in unknowns.iter().enumerate() {
            let coefficient = equation.derivative(x);
            if coefficient.variables().iter().any(|y| unknowns.contains(y)) {
                return None;
            }
            matrix[(i, j)] = Fraction::from(coefficient);
        }
        right.push(Fraction::from(-equation.substitute(&nothing)));
    }
    Some((matrix, right))
}

/// All real solutions of polynomial equations with numbers as coefficients, if there are finitely many complex ones.
fn in_several_unknowns(equations: &[MultiPoly], unknowns: &[Symbol]) -> Result<Value> {
    if let Some(symbol) = equations.iter().flat_map(|p| p.variables()).find(|s| !unknowns.contains(s)) {
        let symbol = text(&symbol_expr(symbol));
        let message = format!("equations that are not linear in the unknowns have the symbol {symbol}");
        return Err(Diagnostic::error(Code::Unsupported, message)
            .hint(format!("give {symbol} a value, or name it among the unknowns"))
            .hint("name the unknowns in which they are linear: solve(a x = b, x)")
            .hint("groebner(equations, unknowns) eliminates unknowns with symbols as coefficients"));
    }
    let zeros = match (equations, unknowns) {
        ([p, q], [x, y]) => common_zeros(p, q, &[x.clone(), y.clone()], &Default::default()),
        _ => real_zeros(equations, unknowns),
    };
    let zeros = zeros.map_err(system_error)?;
    if zeros.is_empty() {
        return Ok(Value::Text("no real solution".to_owned()));
    }
    let t = Symbol::new("t");
    let point = |zero: &RealZero| -> Vec<Value> {
        zero.coordinates.iter().map(|x| Value::root(x.clone(), &t)).collect()
    };
    let relations = |zero: &RealZero| -> Expr {
        let relation =
            |(x, value): (&Symbol, Value)| Expr::relation(symbol_expr(x), Rel::Eq, value.to_expr());
        Kind::List(unknowns.iter().zip(point(zero)).map(relation).collect()).into()
    };
    let shown: Expr = Kind::List(zeros.iter().map(relations).collect()).into();
    let values = zeros.iter().map(|zero| Value::list(point(zero))).collect();
    Ok(Value::written(Value::List(values), shown))
}

/// The diagnostic for a system that is not solved.
pub(super) fn system_error(error: SystemError) -> Diagnostic {
    let hint = match error {
        SystemError::Infinite => {
            "give as many independent equations as unknowns; groebner(equations, unknowns) shows what they say"
        }
        SystemError::Many | SystemError::Degrees => {
            "fewer unknowns, or lower degrees; resultant(F, G, x) eliminates x from two"
        }
        SystemError::Pairs => "resultant(F, G, x) eliminates x from two",
        SystemError::Equation => {
            "lower degrees: biquadratic patches, or triangular ones of degree 3, have equations that are found"
        }
        SystemError::Entangled => "count_roots and resultant(F, G, x) tell more",
    };
    Diagnostic::error(Code::Unsupported, error.to_string()).hint(hint)
}

const BASIS_PARAMETERS: &[Parameter] = &[
    required("F", Takes::OneOf(&[Takes::Coordinates, Takes::Equations]), "the polynomials, or equations")
        .shown("[F_1, ...]"),
    required("unknowns", Takes::Variables, "the unknowns, the largest first").shown("[x, ...]"),
    named("order=lex", Takes::Word(&words_of(&ORDERS)), "lex", "the order of the monomials"),
];

pub(super) const TABLE: &[Builtin] = &[Builtin {
    name: "groebner",
    parameters: BASIS_PARAMETERS,
    summary: "the reduced Groebner basis of polynomials or equations, without denominators",
    gives: Gives::Functions,
    example: "groebner([x^2 + y^2 - 1, x - y], [x, y])",
    on_equations: Variant::new(BASIS_PARAMETERS, Gives::Any, |args| {
        let Value::Claim(claim) = args.value(0)? else { return Err(wrong_kind("equations", args.value(0)?)) };
        groebner(args, &zeros(claim).at(args.span(0))?)
    }),
    call: |_, args| {
        let polynomials = args.scalars(0)?;
        let polynomials: Vec<MultiPoly> = polynomials.iter().map(|f| f.numerator().clone()).collect();
        groebner(args, &polynomials)
    },
    ..Builtin::about("Roots of polynomials")
}];

fn groebner(args: &Arguments, polynomials: &[MultiPoly]) -> Result<Value> {
    let (value, span) = args.given(1).ok_or_else(|| wrong_kind("unknowns", &Value::list(Vec::new())))?;
    let (unknowns, _) = symbols(value, span)?;
    let order = chosen(args.named("order"), &ORDERS)?;
    let basis = groebner_basis(polynomials, &unknowns, order).map_err(system_error).at(args.span(0))?;
    Ok(Value::List(basis.into_iter().map(|f| Value::Scalar(Fraction::from(f))).collect()))
}

/// That no factor of the minor is 0; `None` if it is a number.
fn condition(minor: &Fraction) -> Option<String> {
    let factors = minor.numerator().factors().factors.into_iter();
    let shown: Vec<String> =
        factors.map(|(p, _)| format!("{} != 0", text(&polynomial_expr(&Fraction::from(p))))).collect();
    (!shown.is_empty()).then(|| shown.join(" and "))
}
