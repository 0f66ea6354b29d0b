//! Least squares, and parameters for points.

use crate::language::eval::{Arguments, Machine};
use crate::language::functions::gives::Gives;
use crate::language::ops::errors::wrong_kind;
use crate::language::ops::geometry::scalar_list;
use std::sync::Arc;

use super::NEW;
use super::data::{Datum, Result, Samples, data, datum, interpolation_error, numbers, polynomial};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::functions::Builtin;
use crate::language::functions::notions::{BASIS as BASES, chosen, read_basis, words_of};
use crate::language::functions::parameter::{NODES, Parameter, RESULT_VARIABLE, VALUES, named, required};
use crate::language::ops::takes::Takes;
use crate::language::value::{Cell, Form, Table, Value};
use crate::math::basis::Basis;
use crate::math::interpolate::{
    FitOptions, InterpolationError, Parameterization, PolynomialFit, Scale, fit_polynomial, least_squares,
    parameters,
};
use crate::math::number::Rational;
use crate::math::poly::Fraction;

/// A system with more coefficients is not shown as a matrix.
const LARGEST_SHOWN: usize = 6;

const FIT_DEGREE: Parameter = required("degree", Takes::Size, "the degree of the polynomial").shown("n");

const FIT_WEIGHTS: Parameter =
    named("weights=[w_0, ..., w_m]", Takes::Scalars, "all 1", "the weights of the nodes");

const THROUGH: Parameter =
    named("through=[[x, y], ...]", Takes::Rows, "none", "points through which the polynomial goes exactly");

const BASIS: Parameter = named("basis=power", BASES, "power", "the basis in which it is found");

const FIT: &[Parameter] = &[
    NODES.shown("[x_0, ..., x_m]"),
    VALUES.shown("[y_0, ..., y_m]"),
    FIT_DEGREE,
    FIT_WEIGHTS,
    THROUGH,
    BASIS,
    RESULT_VARIABLE,
];

const METHODS: [(&str, Parameterization); 4] = [
    ("uniform", Parameterization::Uniform),
    ("chord", Parameterization::Chord),
    ("centripetal", Parameterization::Centripetal),
    ("foley", Parameterization::Foley),
];

const SCALES: [(&str, Scale); 2] = [("unit", Scale::Unit), ("length", Scale::Sum)];

pub(crate) const TABLE: &[Builtin] = &[
    Builtin {
        name: "least_squares",
        parameters: FIT,
        summary: "the polynomial of degree n with the least sum of w_i (y_i - p(x_i))^2",
        gives: Gives::Function,
        example: "least_squares([0, 1, 2, 3], [0, 1, 1, 2], 1)",
        call: |_, args| {
            let (samples, fit) = fitted(args)?;
            Ok(polynomial(&fit.power, samples.form, &samples.variable(args)?))
        },
        ..NEW
    },
    Builtin {
        name: "least_squares_solution",
        parameters: &[
            required("M", Takes::Matrix, "the matrix, its columns independent"),
            required("b", Takes::Scalars, "the right side").shown("[b_1, ..., b_m]"),
            named("weights=[w_1, ..., w_m]", Takes::Scalars, "all 1", "the weights of the rows"),
        ],
        summary: "the x with the least |M x - b|^2, which solves M^T M x = M^T b",
        gives: Gives::Any,
        example: "least_squares_solution([1, 0; 1, 1; 1, 2], [1, 2, 6])",
        call: |_, args| {
            let weights = args.named_scalars("weights")?;
            let fit = least_squares(&args.matrix(0)?, &args.scalars(1)?, weights.as_deref());
            fit.map(|fit| scalar_list(fit.coefficients)).map_err(|error| match error {
                InterpolationError::DependentColumns { column } => {
                    let place = column + 1;
                    let message = format!("column {place} of M is a combination of those before it");
                    Diagnostic::error(Code::Singular, message)
                        .at(args.span(0))
                        .hint("several x are best; rank(M) tells how many columns are independent")
                }
                other => interpolation_error(other).at(args.span(1)),
            })
        },
        ..NEW
    },
    Builtin {
        name: "least_squares_report",
        parameters: FIT,
        summary: "its coefficients in a basis, residuals, their squared norm and the normal equations",
        gives: Gives::Table,
        example: "least_squares_report([-1, 0, 1, 2], [1, 0, 0, 2], 2)",
        call: |_, args| {
            let (samples, fit) = fitted(args)?;
            let variable = samples.variable(args)?;
            let polynomial = polynomial(&fit.power, samples.form, &variable);
            Ok(Value::Table(Arc::new(report(&fit, polynomial, samples.form))))
        },
        ..NEW
    },
    Builtin {
        name: "parameters",
        parameters: &[
            required("points", Takes::Points, "the points").shown("[p_0, ..., p_n]"),
            required("method", Takes::Word(&words_of(&METHODS)), "how distances make them"),
            named(
                "decimals=k",
                Takes::Size,
                "exact values",
                "to how many decimals irrational values are rounded",
            ),
            named(
                "scale=unit",
                Takes::Word(&words_of(&SCALES)),
                "unit",
                "whether they end at 1 or at the sum of all distances",
            ),
        ],
        summary: "parameters for points; methods are uniform, chord, centripetal and foley",
        gives: Gives::Points,
        example: "parameters([[0, 0], [3, 4], [9, 12]], chord)",
        call: parameters_of,
        ..NEW
    },
];

/// The data and the fit.
fn fitted(args: &Arguments) -> Result<(Samples, PolynomialFit<Fraction, Datum>)> {
    let samples = Samples::read(args)?;
    let degree = args.size(2)?;
    let size = samples.nodes.len() as u64;
    crate::budget::charge_terms((degree as u64).saturating_add(1).saturating_mul(size.max(1)));
    let span_of = |name: &str| args.named(name).map(|(_, span)| span);
    let weights = args.named_scalars("weights")?;
    let basis = args.named("basis").map_or(Ok(Basis::Power), |(value, span)| read_basis(value, span))?;
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
    let Some((value, span)) = args.named("through") else { return Ok(Vec::new()) };
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
    let value = args.value(0)?;
    let span = args.span(0);
    let (points, _) = data(value).ok_or_else(|| {
        wrong_kind("a list of points", value).at(span).hint("such as [[0, 0], [3, 4], [9, 12]]")
    })?;
    let row = |point: &Datum| numbers(point, "the distance of points", span);
    let points: Vec<Vec<Rational>> = points.iter().map(row).collect::<Result<_>>()?;
    let method = chosen(args.given(1), &METHODS)?;
    let scale = chosen(args.named("scale"), &SCALES)?;
    let decimals = args.named_size("decimals")?;
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
