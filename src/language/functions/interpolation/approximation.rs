//! Least squares, and parameters for points.

use std::sync::Arc;

use super::TOPIC;
use super::data::{Datum, Result, Samples, data, datum, interpolation_error, numbers, polynomial, word};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Machine};
use crate::language::functions::Builtin;
use crate::language::functions::matrices::read_basis;
use crate::language::ops::errors::wrong_kind;
use crate::language::value::{Cell, Form, Table, Value};
use crate::math::basis::Basis;
use crate::math::interpolate::{
    FitOptions, InterpolationError, Parameterization, PolynomialFit, Scale, fit_polynomial, parameters,
};
use crate::math::number::Rational;
use crate::math::poly::Fraction;

/// A system with more coefficients is not shown as a matrix.
const LARGEST_SHOWN: usize = 6;

pub(crate) const TABLE: &[Builtin] = &[
    Builtin {
        name: "least_squares",
        signature: "least_squares([x_0, ..., x_m], [y_0, ..., y_m], n, weights=[w_0, ..., w_m], through=[[x, y], ...])",
        summary: "the polynomial of degree n with the least sum of w_i (y_i - p(x_i))^2",
        example: "least_squares([0, 1, 2, 3], [0, 1, 1, 2], 1)",
        topic: TOPIC,
        call: |_, args| {
            let (samples, fit) = fitted(args, "least_squares")?;
            Ok(polynomial(&fit.power, samples.form, &samples.variable(args)?))
        },
    },
    Builtin {
        name: "least_squares_report",
        signature: "least_squares_report([x_0, ..., x_m], [y_0, ..., y_m], n, basis=power)",
        summary: "its coefficients in a basis, residuals, their squared norm and the normal equations",
        example: "least_squares_report([-1, 0, 1, 2], [1, 0, 0, 2], 2)",
        topic: TOPIC,
        call: |_, args| {
            let (samples, fit) = fitted(args, "least_squares_report")?;
            let variable = samples.variable(args)?;
            let polynomial = polynomial(&fit.power, samples.form, &variable);
            Ok(Value::Table(Arc::new(report(&fit, polynomial, samples.form))))
        },
    },
    Builtin {
        name: "parameters",
        signature: "parameters([p_0, ..., p_n], method, decimals=k, scale=unit)",
        summary: "parameters for points; methods are uniform, chord, centripetal and foley",
        example: "parameters([[0, 0], [3, 4], [9, 12]], chord)",
        topic: TOPIC,
        call: parameters_of,
    },
];

/// The data and the fit.
fn fitted(args: &Arguments, name: &str) -> Result<(Samples, PolynomialFit<Fraction, Datum>)> {
    let names = &["degree", "weights", "basis", "through", "variable"];
    args.expect(&format!("{name}(nodes, values, degree)"), 2..=3, names)?;
    let samples = Samples::read(args)?;
    let degree = args.named_size("degree", 2)?.ok_or_else(|| {
        Diagnostic::error(Code::Arity, "the degree of the polynomial is missing")
            .hint(format!("write it third: {name}(nodes, values, 1) is a straight line"))
    })?;
    let size = samples.nodes.len() as u64;
    crate::budget::charge_terms((degree as u64).saturating_add(1).saturating_mul(size.max(1)));
    let span_of = |name: &str| args.named_or(name, usize::MAX).map(|(_, span)| span);
    // An argument given by name, as the first of others.
    let alone = |name: &str| {
        args.named_or(name, usize::MAX).map(|(value, span)| {
            let mut own = Arguments::default();
            own.push(value.clone(), span);
            own
        })
    };
    let weights = alone("weights").map(|own| own.scalars(0)).transpose()?;
    let basis = alone("basis").map_or(Ok(Basis::Power), |own| read_basis(&own, 0))?;
    let conditions = conditions(args, samples.form)?;
    let options = FitOptions { basis, weights, conditions };
    let fit = fit_polynomial(&samples.nodes, &samples.values, degree, options).map_err(|error| {
        use InterpolationError as E;
        let (error, name) = match error {
            // Nodes may repeat, places of conditions not.
            E::EqualNodes { second, .. } if span_of("through").is_some() => {
                (E::DependentCondition { index: second }, "through")
            }
            E::Basis(_) | E::EqualNodes { .. } => (error, "basis"),
            E::Lengths { what: "weights", .. } | E::NegativeWeight { .. } => (error, "weights"),
            E::TooManyConditions { .. } | E::DependentCondition { .. } => (error, "through"),
            _ => (error, ""),
        };
        match span_of(name) {
            Some(span) => interpolation_error(error).at(span),
            None => Samples::failed(args)(error),
        }
    })?;
    Ok((samples, fit))
}

/// through=[[x, y], …]
fn conditions(args: &Arguments, form: Form) -> Result<Vec<(Fraction, Datum)>> {
    let Some((value, span)) = args.named_or("through", usize::MAX) else { return Ok(Vec::new()) };
    let wrong = |value: &Value| {
        wrong_kind("a list of points [x, y]", value).at(span).hint("such as through=[[0, 1], [2, 3]]")
    };
    let Value::List(items) = value else { return Err(wrong(value)) };
    let condition = |item: &Value| match item {
        Value::List(two) => match two.as_slice() {
            [Value::Scalar(x), y] => Ok((x.clone(), datum(y, form, span)?)),
            _ => Err(wrong(item)),
        },
        other => Err(wrong(other)),
    };
    items.iter().map(condition).collect()
}

/// What a lecture shows of a fit.
fn report(fit: &PolynomialFit<Fraction, Datum>, polynomial: Value, form: Form) -> Table {
    let solution = &fit.solution;
    let list = |data: &[Datum]| Value::List(data.iter().map(|datum| form.plain(datum.clone())).collect());
    let mut table = Table::default();
    let mut row = |words: &str, value: Value| table.rows.push(vec![Cell::words(words), Cell::Value(value)]);
    row("polynomial", polynomial);
    row("coefficients", list(&solution.coefficients));
    row("residuals", list(&solution.residuals));
    row("squared norm", Value::Scalar(solution.squared_norm.clone()));
    if solution.coefficients.len() <= LARGEST_SHOWN {
        row("normal matrix", Value::Matrix(solution.normal_matrix.clone()));
        row("its right side", list(&solution.normal_right));
    }
    if !solution.multipliers.is_empty() {
        row("multipliers", list(&solution.multipliers));
    }
    table
}

fn parameters_of(machine: &mut Machine, args: &Arguments) -> Result<Value> {
    let signature = "parameters([p_0, ..., p_n], method, decimals=k, scale=unit)";
    args.expect(signature, 1..=2, &["method", "decimals", "scale"])?;
    let value = args.value(0)?;
    let span = args.span(0);
    let (points, _) = data(value).ok_or_else(|| {
        wrong_kind("a list of points", value).at(span).hint("such as [[0, 0], [3, 4], [9, 12]]")
    })?;
    let row = |point: &Datum| numbers(point, "the distance of points", span);
    let points: Vec<Vec<Rational>> = points.iter().map(row).collect::<Result<_>>()?;
    let method = match word(args, "method", 1) {
        Some(("uniform", ..)) => Parameterization::Uniform,
        Some(("chord", ..)) => Parameterization::Chord,
        Some(("centripetal", ..)) => Parameterization::Centripetal,
        Some(("foley", ..)) => Parameterization::Foley,
        other => {
            let problem = match other {
                Some((_, value, span)) => wrong_kind("a way to parameters", value).at(span),
                None => Diagnostic::error(Code::Arity, "the way to the parameters is missing"),
            };
            return Err(problem.hint("uniform, chord, centripetal or foley"));
        }
    };
    let scale = match word(args, "scale", usize::MAX) {
        None | Some(("unit", ..)) => Scale::Unit,
        Some(("length", ..)) => Scale::Sum,
        Some((_, value, span)) => {
            return Err(wrong_kind("a scale", value)
                .at(span)
                .hint("scale=unit ends at 1, scale=length at the sum of all distances"));
        }
    };
    let decimals = args.named_size("decimals", usize::MAX)?;
    let decimals = decimals.map(|decimals| u32::try_from(decimals).unwrap_or(u32::MAX));
    let found = parameters(&points, method, scale, decimals).map_err(interpolation_error).at(span)?;
    if let Some(decimals) = found.decimals.filter(|_| !found.exact) {
        let plural = if decimals == 1 { "" } else { "s" };
        machine.note(
            Diagnostic::note(
                Code::Irrational,
                format!("the values are rounded to {decimals} decimal{plural}"),
            )
            .at(span),
        );
    }
    Ok(Value::List(found.values.into_iter().map(Value::number).collect()))
}
