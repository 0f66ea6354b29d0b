//! Interpolating polynomials in the forms of Lagrange, Newton, Hermite, Neville and Aitken.

use crate::language::eval::Arguments;
use crate::language::functions::gives::Gives;
use crate::language::ops::errors::{curve_error, linalg_error, wrong_kind};
use crate::language::ops::geometry::{bezier, scalar_list};
use std::sync::Arc;

use num_traits::Zero;

use super::NEW;
use super::data::{
    Datum, NORMS, Result, Samples, datum, difference_label, indexed, interpolation_error, norm, numbers,
    occurs, polynomial, scalar_polynomial, symbol,
};
use super::tables;
use crate::formula::{Expr, Kind, Rel, Sign, Term};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::functions::Builtin;
use crate::language::functions::notions::words_of;
use crate::language::functions::parameter::{
    DEGREE, NODES, Parameter, RESULT_VARIABLE, VALUES, VARIABLE, optional, required,
};
use crate::language::ops::takes::Takes;
use crate::language::value::{Cell, Form, Table, Value, newton_function, nodes_expr, symbol_expr};
use crate::math::curve::{BezierCurve, Interval};
use crate::math::interpolate::{
    DividedDifferences, InterpolationError, LagrangeForm, NewtonForm, Remainder, Scheme, Tableau,
    barycentric_weights, confluent_vandermonde, hermite_basis, hermite_bezier, matrix_condition,
    polynomial_through, power_bernstein_condition, vandermonde, vandermonde_determinant,
};
use crate::math::poly::{Fraction, Symbol};

const DATA: Parameter = required("data", Takes::Rows, "each node with its value and derivatives")
    .shown("[[x_0, f, f', ...], ..., [x_n, f, f', ...]]");

const REPEATED: Parameter =
    required("nodes", Takes::Scalars, "the nodes, equal ones together").shown("[x_0, x_0, ..., x_n]");

const NORM: Parameter = optional(
    "norm",
    Takes::OneOf(&[Takes::Word(&words_of(&NORMS)), Takes::Exactly(1)]),
    "infinity",
    "the sums of rows (infinity) or of columns (one)",
)
.shown("norm=infinity");

/// Of the tableaux of Neville and Aitken.
const PYRAMID: &[Parameter] =
    &[NODES, VALUES, optional("t", Takes::Scalar, "the variable", "the parameter"), RESULT_VARIABLE];

pub(crate) const TABLE: &[Builtin] = &[
    Builtin {
        name: "lagrange",
        parameters: &[NODES, VALUES, RESULT_VARIABLE],
        summary: "the polynomial of degree at most n through n + 1 points, by Lagrange's formula",
        gives: Gives::Function,
        example: "lagrange([0, 1, 2], [1, 3, 2])",
        call: |_, args| {
            let samples = Samples::read(args)?;
            let power = polynomial_through(&samples.nodes, &samples.values);
            let power = power.map_err(Samples::failed(args))?;
            Ok(polynomial(&power, samples.form, &samples.variable(args)?))
        },
        ..NEW
    },
    Builtin {
        name: "lagrange_basis",
        parameters: &[NODES, RESULT_VARIABLE],
        summary: "Lagrange's polynomials L_0, ..., L_n: L_j is 1 at x_j and 0 at the other nodes",
        gives: Gives::Functions,
        example: "lagrange_basis([0, 1, 2])",
        call: |_, args| {
            let nodes = args.scalars(0)?;
            let form = LagrangeForm::new(&nodes, &nodes).map_err(Samples::failed(args))?;
            let samples = Samples { nodes, values: Vec::new(), form: Form::default() };
            let variable = samples.variable(args)?;
            let basis = form.basis_polynomials();
            Ok(Value::List(basis.iter().map(|p| scalar_polynomial(p, &variable)).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "barycentric_weights",
        parameters: &[NODES],
        summary: "w_j = 1/omega'(x_j) in L_j = w_j omega/(t - x_j), omega = (t - x_0) ... (t - x_n)",
        gives: Gives::Scalars,
        example: "barycentric_weights([0, 1, 2, 3])",
        call: |_, args| {
            barycentric_weights(&args.scalars(0)?).map(scalar_list).map_err(Samples::failed(args))
        },
        ..NEW
    },
    Builtin {
        name: "newton",
        parameters: &[NODES, VALUES, RESULT_VARIABLE],
        summary: "the same polynomial as a function in Newton's form c_0 + c_1 (t - x_0) + ...",
        gives: Gives::Function,
        example: "newton([0, 1, 3], [1, 3, 2])",
        call: |_, args| {
            let samples = Samples::read(args)?;
            let table = DividedDifferences::new(&samples.nodes, &samples.values);
            let table = table.map_err(Samples::failed(args))?;
            let variable = samples.variable(args)?;
            newton_form(&table, samples.form, &variable)
        },
        ..NEW
    },
    Builtin {
        name: "divided_differences",
        parameters: &[NODES, VALUES],
        summary: "the triangle of divided differences; its diagonal has the coefficients of newton",
        gives: Gives::Table,
        example: "divided_differences([0, 1, 3], [1, 3, 2])",
        call: |_, args| {
            let samples = Samples::read(args)?;
            let table = DividedDifferences::new(&samples.nodes, &samples.values);
            let table = table.map_err(Samples::failed(args))?;
            let places: Vec<usize> = (0..samples.nodes.len()).collect();
            Ok(Value::Table(Arc::new(tables::differences(&table, &places, samples.form))))
        },
        ..NEW
    },
    Builtin {
        name: "hermite",
        parameters: &[DATA, RESULT_VARIABLE],
        summary: "the polynomial with given values and derivatives at the nodes",
        gives: Gives::Function,
        example: "hermite([[0, 0, 0], [1, 1, 0]])",
        call: |_, args| {
            let (table, _, samples) = hermite_differences(args)?;
            Ok(polynomial(&table.newton_form().to_power(), samples.form, &samples.variable(args)?))
        },
        ..NEW
    },
    Builtin {
        name: "hermite_basis",
        parameters: &[REPEATED, RESULT_VARIABLE],
        summary: "the polynomials dual to values and derivatives: at a double node f and f' are given",
        gives: Gives::Functions,
        example: "hermite_basis([0, 0, 1, 1])",
        call: |_, args| {
            let basis = hermite_basis(&multiplicities(args)?).map_err(Samples::failed(args))?;
            let samples = Samples { nodes: args.scalars(0)?, values: Vec::new(), form: Form::default() };
            let variable = samples.variable(args)?;
            Ok(Value::List(basis.iter().flatten().map(|p| scalar_polynomial(p, &variable)).collect()))
        },
        ..NEW
    },
    Builtin {
        name: "hermite_bezier",
        parameters: &[DATA.shown("[[a, f, f', ...], [b, f, f', ...]]")],
        summary: "the Bézier curve over [a, b] with given values and derivatives at both ends",
        gives: Gives::Curve,
        example: "control_points(hermite_bezier([[0, 1, 6], [1, 4, 3]]))",
        call: |_, args| {
            let (data, form) = hermite_data(args)?;
            let [(a, left), (b, right)] = data.as_slice() else {
                let problem = format!("two nodes are needed, the ends of the interval, not {}", data.len());
                return Err(Diagnostic::error(Code::Shape, problem).at(args.span(0)));
            };
            let interval = Interval::new(a.clone(), b.clone());
            let interval = interval
                .map_err(|_| hermite_error(InterpolationError::EqualNodes { first: 0, second: 1 }))
                .at(args.span(0))?;
            let points = hermite_bezier(&interval, left, right).map_err(hermite_error).at(args.span(0))?;
            let curve = BezierCurve::new(points, interval).map_err(curve_error).at(args.span(0))?;
            Ok(bezier(curve, form))
        },
        ..NEW
    },
    Builtin {
        name: "hermite_table",
        parameters: &[DATA],
        summary: "divided differences with repeated nodes; f[x_0, ..., x_0] is a derivative over k!",
        gives: Gives::Table,
        example: "hermite_table([[0, 0, 0], [1, 1, 0]])",
        call: |_, args| {
            let (table, places, samples) = hermite_differences(args)?;
            Ok(Value::Table(Arc::new(tables::differences(&table, &places, samples.form))))
        },
        ..NEW
    },
    Builtin {
        name: "neville",
        parameters: PYRAMID,
        summary: "Neville's tableau at a parameter: p_{0,1,2} interpolates at x_0, x_1, x_2",
        gives: Gives::Table,
        example: "neville([0, 1, 3], [1, 3, 2], 2)",
        call: |_, args| pyramid(args, Scheme::Neville),
        ..NEW
    },
    Builtin {
        name: "aitken",
        parameters: PYRAMID,
        summary: "Aitken's tableau at a parameter, where each new node is joined to x_0, ..., x_k",
        gives: Gives::Table,
        example: "aitken([0, 1, 3], [1, 3, 2], 2)",
        call: |_, args| pyramid(args, Scheme::Aitken),
        ..NEW
    },
    Builtin {
        name: "vandermonde",
        parameters: &[
            NODES,
            optional("degree", Takes::Size, "one less than the number of nodes", "the degree")
                .shown("degree=k"),
        ],
        summary: "the matrix of 1, x_i, x_i^2, ..., of degree n if not given",
        gives: Gives::Matrix,
        example: "vandermonde([a, b, c])",
        call: |_, args| {
            let nodes = args.scalars(0)?;
            let Some(own) = nodes.len().checked_sub(1) else {
                return Err(Samples::failed(args)(InterpolationError::TooFewPoints { needed: 1, given: 0 }));
            };
            let degree = args.optional_size(1)?.unwrap_or(own);
            Ok(Value::Matrix(vandermonde(&nodes, degree)))
        },
        ..NEW
    },
    Builtin {
        name: "vandermonde_det",
        parameters: &[NODES],
        summary: "its determinant, the product of all x_j - x_i with i < j",
        gives: Gives::Scalar,
        example: "vandermonde_det([1, 2, 4])",
        call: |_, args| Ok(Value::Scalar(vandermonde_determinant(&args.scalars(0)?))),
        ..NEW
    },
    Builtin {
        name: "confluent_vandermonde",
        parameters: &[REPEATED],
        summary: "the matrix of Hermite interpolation: a node that stands k times has k - 1 derivatives",
        gives: Gives::Matrix,
        example: "confluent_vandermonde([a, a, b])",
        call: |_, args| Ok(Value::Matrix(confluent_vandermonde(&multiplicities(args)?))),
        ..NEW
    },
    Builtin {
        name: "interpolation_error",
        parameters: &[required("F", Takes::Polynomial, "the polynomial"), NODES, VARIABLE],
        summary: "F minus its interpolant p: the quotient f[x_0, ..., x_n, t] and the node polynomial",
        gives: Gives::Table,
        example: "interpolation_error(t^4, [-1, 0, 1])",
        call: |_, args| {
            let given = args.univariate(0)?;
            let nodes = args.scalars(1)?;
            let variable = given.variable;
            if nodes.iter().any(|x| x.variables().contains(&variable)) {
                return Err(occurs(&variable).at(args.span(1)));
            }
            let mut power = given.coefficients;
            if power.is_empty() {
                power.push(Fraction::zero());
            }
            let remainder = Remainder::new(&power, &nodes).map_err(interpolation_error).at(args.span(1))?;
            Ok(Value::Table(Arc::new(error_table(&remainder, &nodes, &variable))))
        },
        ..NEW
    },
    Builtin {
        name: "condition_number",
        parameters: &[required("M", Takes::Matrix, "the matrix"), NORM],
        summary: "|M| |M^-1| exactly, for norm=infinity (sums of rows) or norm=one (of columns)",
        gives: Gives::Scalar,
        example: "condition_number(vandermonde([0, 1, 2]))",
        call: |_, args| {
            let matrix = args.matrix(0)?;
            let entries = numbers(matrix.iter(), "the condition of a matrix", args.span(0))?;
            let matrix = nalgebra::DMatrix::from_vec(matrix.nrows(), matrix.ncols(), entries);
            let condition = matrix_condition(&matrix, norm(args, 1)?);
            Ok(Value::number(condition.map_err(linalg_error).at(args.span(0))?.number()))
        },
        ..NEW
    },
    Builtin {
        name: "basis_condition",
        parameters: &[DEGREE, NORM],
        summary: "the condition number of the change from Bézier points to powers, of degree n",
        gives: Gives::Scalar,
        example: "basis_condition(3)",
        call: |_, args| {
            let n = args.size(0)?;
            crate::budget::charge_terms((n as u64 + 1).saturating_mul(n as u64 + 1));
            Ok(Value::number(power_bernstein_condition(n, norm(args, 1)?).number()))
        },
        ..NEW
    },
];

/// The function shown in Newton's form; for points, one for each coordinate.
fn newton_form(table: &DividedDifferences<Fraction, Datum>, form: Form, variable: &Symbol) -> Result<Value> {
    let nodes = table.nodes()[..table.degree()].to_vec();
    let coefficients = table.coefficients();
    let coordinate = |k: usize| {
        let own = coefficients.iter().map(|c| c[k].clone()).collect();
        NewtonForm::new(nodes.clone(), own).map(|form| newton_function(&form, variable))
    };
    let functions = (0..coefficients[0].len()).map(coordinate).collect::<std::result::Result<Vec<_>, _>>();
    let mut functions = functions.map_err(interpolation_error)?;
    Ok(if form.scalar { functions.swap_remove(0) } else { Value::point(functions) })
}

/// The nodes, each with how often it stands there.
fn multiplicities(args: &Arguments) -> Result<Vec<(Fraction, usize)>> {
    let nodes = args.scalars(0)?;
    let mut runs: Vec<(Fraction, usize)> = Vec::new();
    for (second, node) in nodes.iter().enumerate() {
        crate::budget::step();
        match runs.last_mut() {
            Some((last, count)) if last == node => *count += 1,
            _ => match nodes[..second].iter().position(|other| other == node) {
                Some(first) => {
                    return Err(Samples::failed(args)(InterpolationError::NodesApart { first, second }));
                }
                None => runs.push((node.clone(), 1)),
            },
        }
    }
    Ok(runs)
}

/// Nodes with f, f', … there.
type HermiteData = Vec<(Fraction, Vec<Datum>)>;

/// The rows [x_i, f, f', …].
fn hermite_data(args: &Arguments) -> Result<(HermiteData, Form)> {
    let span = args.span(0);
    let value = args.value(0)?;
    let wrong = |value: &Value| {
        wrong_kind("a list of nodes with their data", value)
            .at(span)
            .hint("such as [[0, 1, 2], [1, 3]]: value 1 and derivative 2 at 0, value 3 at 1")
    };
    let rows: Vec<Vec<Value>> = match value {
        Value::List(items) => {
            let row = |item: &Value| match item {
                Value::List(row) => Ok(row.to_vec()),
                other => Err(wrong(other)),
            };
            items.iter().map(row).collect::<Result<_>>()?
        }
        Value::Matrix(matrix) => {
            matrix.row_iter().map(|row| row.iter().cloned().map(Value::Scalar).collect()).collect()
        }
        other => return Err(wrong(other)),
    };
    let scalar = rows.iter().find_map(|row| row.get(1)).is_none_or(|first| first.as_scalar().is_some());
    let form = Form { scalar, rational: false };
    let mut data: Vec<(Fraction, Vec<Datum>)> = Vec::with_capacity(rows.len());
    for row in &rows {
        let Some((Value::Scalar(node), rest)) = row.split_first() else { return Err(wrong(value)) };
        let own = rest.iter().map(|item| datum(item, form, span)).collect::<Result<_>>()?;
        data.push((node.clone(), own));
    }
    Ok((data, form))
}

fn hermite_error(error: InterpolationError) -> Diagnostic {
    let equal = matches!(error, InterpolationError::EqualNodes { .. });
    let mut problem = interpolation_error(error);
    if equal {
        problem.hints = vec!["write all data of a node in one list: [x_0, f, f', ...]".to_owned()];
    }
    problem
}

/// The data as a table of differences, the index of the node in each of its rows, and the data in
/// one list.
fn hermite_differences(
    args: &Arguments,
) -> Result<(DividedDifferences<Fraction, Datum>, Vec<usize>, Samples)> {
    let (data, form) = hermite_data(args)?;
    let table = DividedDifferences::hermite(&data).map_err(hermite_error).at(args.span(0))?;
    let places =
        data.iter().enumerate().flat_map(|(i, (_, own))| std::iter::repeat_n(i, own.len())).collect();
    let (nodes, values): (Vec<Fraction>, Vec<Vec<Datum>>) = data.into_iter().unzip();
    Ok((table, places, Samples { nodes, values: values.concat(), form }))
}

/// Neville's or Aitken's tableau at the third argument, or as polynomials.
fn pyramid(args: &Arguments, scheme: Scheme) -> Result<Value> {
    let samples = Samples::read(args)?;
    let at = match args.optional_scalar(2)? {
        Some(t) => t,
        None => symbol(&samples.variable(args)?),
    };
    let tableau = Tableau::new(scheme, &samples.nodes, &samples.values, &at);
    let tableau = tableau.map_err(Samples::failed(args))?;
    Ok(Value::Table(Arc::new(tables::tableau(&tableau, samples.form))))
}

/// p, f[x_0, …, x_n, t] and ω, and how the error is made of them.
fn error_table(remainder: &Remainder<Fraction>, nodes: &[Fraction], variable: &Symbol) -> Table {
    /// Of more nodes only the first and the last stand in the label.
    const MOST_NODES: usize = 4;
    let t = || symbol_expr(variable);
    let of_t = |name: &str| Expr::apply(Expr::name(name), vec![t()]);
    let n = nodes.len() - 1;
    let mut listed: Vec<Expr> = match n < MOST_NODES {
        true => (0..=n).map(|i| indexed("x", i)).collect(),
        false => vec![indexed("x", 0), Kind::Ellipsis.into(), indexed("x", n)],
    };
    listed.push(t());
    let quotient = difference_label(listed);
    let omega = of_t("omega");
    let product = nodes_expr(nodes, variable).unwrap_or_else(|| Expr::int(1));
    let error = Expr::sum(vec![
        Term { sign: Sign::Plus, expr: of_t("f") },
        Term { sign: Sign::Minus, expr: of_t("p") },
    ]);
    let mut factors = match &quotient.kind {
        Kind::Mul(factors) => factors.clone(),
        _ => vec![quotient.clone()],
    };
    factors.push(omega.clone());
    let right = Expr::product(factors);
    let rows = [
        Cell::Labelled(of_t("p"), scalar_polynomial(&remainder.interpolant.to_power(), variable)),
        Cell::Labelled(quotient, scalar_polynomial(&remainder.quotient, variable)),
        Cell::Formula(Expr::relation(omega, Rel::Eq, product)),
        Cell::Formula(Expr::relation(error, Rel::Eq, right)),
    ];
    Table { header: Vec::new(), rows: rows.into_iter().map(|cell| vec![cell]).collect() }
}
