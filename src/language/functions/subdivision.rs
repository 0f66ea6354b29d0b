//! Subdivision of polygons and meshes, and the eigenvalues that decide how it behaves.

use super::gives::Gives;
use std::sync::Arc;

use super::Builtin;
use super::notions::{self, scheme};
use super::parameter::{Parameter, named, optional, required, size};
use crate::formula::{Expr, Rel};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::ops::errors::{linalg_error, subdivision_error, wrong_kind};
use crate::language::ops::geometry::{points_of, scalar_list};
use crate::language::ops::takes::Takes;
use crate::language::value::{Cell, Form, Table, Value, polynomial_expr, symbol_expr};
use crate::math::curve::Point;
use crate::math::linalg::characteristic_polynomial;
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Poly};
use crate::math::ring::Ring;
use crate::math::subdivision::{Contraction, contraction, limit_stencil};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Subdivision");

/// Norms are tried for so many steps if nothing else is said.
const STEPS: usize = 8;

const SCHEME: Parameter = required("scheme", notions::SCHEME, "the scheme, or its mask");

const POLYGON: Parameter = required("points", Takes::Points, "the points").shown("[p_0, ..., p_m]");

const CLOSED: Parameter =
    named("closed=1", Takes::Flag, "0", "whether the last point is followed by the first one");

const MATRIX: Parameter = required("M", Takes::Matrix, "the matrix");

const LETTER: Parameter =
    named("variable=lambda", Takes::Variable, "lambda", "the variable of the polynomial");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "subdivide_polygon",
        parameters: &[POLYGON, SCHEME, optional("k", Takes::Size, "1", "how many steps"), CLOSED],
        summary: "the polygon after k steps of a subdivision scheme; an open one loses its ends",
        gives: Gives::Points,
        example: "subdivide_polygon([0, 4, 8, 4], chaikin)",
        call: |_, args| {
            let (points, form) = polygon(args)?;
            let (scheme, steps) = (scheme(args, 1)?, args.size(2)?);
            let finer = scheme.refine_often(&points, args.flag("closed")?, steps);
            listed(finer.map_err(subdivision_error).at(args.span(0))?, form)
        },
        ..NEW
    },
    Builtin {
        name: "subdivision_mask",
        parameters: &[SCHEME],
        summary: "the coefficients a_k of p'_i = sum of a_(i - 2j) p_j; index 0 stands in the middle",
        gives: Gives::Scalars,
        example: "subdivision_mask([lane_riesenfeld, 3])",
        call: |_, args| Ok(scalar_list(scheme(args, 0)?.mask().iter().cloned())),
        ..NEW
    },
    Builtin {
        name: "subdivision_symbol",
        parameters: &[SCHEME, named("variable=z", Takes::Variable, "z", "the variable of the symbol")],
        summary: "the symbol, the sum of a_k z^k",
        gives: Gives::Scalar,
        example: "factor(subdivision_symbol(chaikin))",
        call: |_, args| {
            let scheme = scheme(args, 0)?;
            let z = letter(args)?;
            let polynomial = scheme.symbol().value(&z);
            let shift = num_traits::pow(z, scheme.first().unsigned_abs() as usize);
            Ok(Value::Scalar(if scheme.first() < 0 { polynomial / shift } else { polynomial.times(&shift) }))
        },
        ..NEW
    },
    Builtin {
        name: "sum_rules",
        parameters: &[SCHEME],
        summary: "the order k of the sum rules: (1 + z)^k divides the symbol, and no higher power",
        gives: Gives::Count,
        example: "sum_rules(four_point)",
        call: |_, args| Ok(Value::int(scheme(args, 0)?.sum_rules() as i64)),
        ..NEW
    },
    Builtin {
        name: "subdivision_matrix",
        parameters: &[SCHEME, size("m", "the number of points"), CLOSED],
        summary: "the matrix of a step for m points: a_(i - 2j) in row i and column j",
        gives: Gives::Matrix,
        example: "subdivision_matrix(chaikin, 3, closed=1)",
        call: |_, args| {
            let (scheme, m) = (scheme(args, 0)?, args.size(1)?);
            let matrix = scheme.matrix(m, args.flag("closed")?);
            matrix.map(Value::Matrix).map_err(subdivision_error).at(args.span(1))
        },
        ..NEW
    },
    Builtin {
        name: "local_matrix",
        parameters: &[SCHEME],
        summary: "the matrix of a_(i - 2j) around a point; left eigenvectors give limits and tangents",
        gives: Gives::Matrix,
        example: "local_matrix(cubic)",
        call: |_, args| Ok(Value::Matrix(scheme(args, 0)?.local_matrix())),
        ..NEW
    },
    Builtin {
        name: "subdivision_smoothness",
        parameters: &[SCHEME, named("steps=L", Takes::Size, "8", "the most steps whose norm is tried")],
        summary: "how smooth the limits are, by the norms of the iterated difference schemes",
        gives: Gives::Table,
        example: "subdivision_smoothness(four_point)",
        call: |_, args| {
            let (scheme, most) = (scheme(args, 0)?, args.size_named("steps")?);
            let mut table = Table::with_header(["class", "difference scheme", "steps", "norm"]);
            for order in 0..=scheme.sum_rules() {
                let found = contraction(&scheme, order, most).map_err(subdivision_error).at(args.span(0))?;
                let (words, numbers) = match &found {
                    Contraction::Shown { steps, norm } => ("contracts", Some((*steps, norm.clone()))),
                    Contraction::NoFactor => ("there is none", None),
                    Contraction::Eigenvalue => ("has an eigenvalue of modulus 1 or more", None),
                    Contraction::Open { steps, norm } => {
                        ("is not known to contract", Some((*steps, norm.clone())))
                    }
                };
                let mut row = vec![super::joins::class("C", Some(order)), Cell::words(words)];
                match numbers {
                    Some((steps, norm)) => {
                        row.extend([Value::int(steps as i64), Value::number(norm)].map(Cell::Value));
                    }
                    None => row.extend([Cell::Empty, Cell::Empty]),
                }
                table.rows.push(row);
                if !matches!(found, Contraction::Shown { .. }) {
                    break;
                }
            }
            Ok(Value::Table(Arc::new(table)))
        },
        ..NEW
    },
    Builtin {
        name: "limit_stencil",
        parameters: &[SCHEME, optional("r", Takes::Size, "0", "the order of the derivative")],
        summary: "the weights of p_(i+j) in the limit point at p_i, or in the derivative there",
        gives: Gives::Table,
        example: "limit_stencil(four_point, 1)",
        call: |_, args| {
            let stencil = stencil(args, 0, 1)?;
            let mut table = Table::with_header(["j", "weight"]);
            for (j, weight) in (stencil.first..).zip(stencil.weights) {
                table.rows.push([Value::int(j), Value::Scalar(weight)].map(Cell::Value).to_vec());
            }
            Ok(Value::Table(Arc::new(table)))
        },
        ..NEW
    },
    Builtin {
        name: "limit_points",
        parameters: &[
            POLYGON,
            SCHEME,
            optional("r", Takes::Size, "0", "the order of the derivative"),
            CLOSED,
        ],
        summary: "the points to which those of a polygon converge, or the derivatives there",
        gives: Gives::Points,
        example: "limit_points([[0, 0], [4, 0], [4, 4], [0, 4]], cubic, closed=1)",
        call: |_, args| {
            let (points, form) = polygon(args)?;
            let limits = stencil(args, 1, 2)?.apply(&points, args.flag("closed")?);
            listed(limits.map_err(subdivision_error).at(args.span(0))?, form)
        },
        ..NEW
    },
    Builtin {
        name: "characteristic_polynomial",
        parameters: &[MATRIX, LETTER],
        summary: "det(lambda I - M)",
        gives: Gives::Scalar,
        example: "characteristic_polynomial([1, 1; 1, 0])",
        call: |_, args| {
            let lambda = letter(args)?;
            Ok(Value::Scalar(Coefficients::new(characteristic(args)?).value(&lambda)))
        },
        ..NEW
    },
    Builtin {
        name: "eigenvalues",
        parameters: &[MATRIX, LETTER],
        summary: "the eigenvalues with multiplicities; those that are not rational by equations, isolated",
        gives: Gives::Table,
        example: "eigenvalues(local_matrix(four_point))",
        call: |_, args| {
            let lambda = letter(args)?;
            let symbol = args.letter()?;
            let polynomial = Coefficients::new(characteristic(args)?).value(&lambda);
            let mut table = Table::with_header(["eigenvalue", "multiplicity"]);
            for (factor, multiplicity) in polynomial.numerator().factors().factors {
                let coefficients = factor.coefficients_in(&symbol);
                let value = match coefficients.as_slice() {
                    [] | [_] => continue,
                    [constant, slope] => Cell::Value(Value::Scalar(
                        -Fraction::from(constant.clone()) / Fraction::from(slope.clone()),
                    )),
                    _ => {
                        let left = polynomial_expr(&Fraction::from(factor.clone()));
                        Cell::Formula(Expr::relation(left, Rel::Eq, Expr::int(0)))
                    }
                };
                let mut row = vec![value, Cell::Value(Value::int(multiplicity as i64))];
                let numbers: Option<Poly> = coefficients.iter().map(MultiPoly::as_constant).collect();
                if let Some(polynomial) = numbers.filter(|p| p.degree() > Some(1)) {
                    let real = polynomial.real_roots(None, None).unwrap_or_default();
                    let real = real.into_iter().map(|(root, _)| Value::root(root, &symbol)).collect();
                    row.push(Cell::Value(Value::list(real)));
                }
                table.rows.push(row);
            }
            if table.rows.iter().any(|row| row.len() > 2) {
                table.header.extend(Table::with_header(["real ones"]).header);
            }
            Ok(Value::Table(Arc::new(table)))
        },
        ..NEW
    },
];

fn stencil(args: &Arguments, i: usize, order: usize) -> Result<crate::math::subdivision::Stencil<Fraction>> {
    let order = args.size(order)?;
    limit_stencil(&scheme(args, i)?, order, STEPS).map_err(subdivision_error).at(args.span(i))
}

fn polygon(args: &Arguments) -> Result<(Vec<Point<Fraction>>, Form)> {
    let value = args.value(0)?;
    let (points, scalar) = points_of(value).ok_or_else(|| {
        wrong_kind("a list of points", value)
            .at(args.span(0))
            .hint("such as [[0, 0], [4, 0], [4, 4]], or [p_0, p_1, p_2] for symbols")
    })?;
    Ok((points, Form { scalar, rational: false }))
}

fn listed(points: Vec<Point<Fraction>>, form: Form) -> Result<Value> {
    Ok(Value::List(points.into_iter().map(|point| form.plain(point)).collect()))
}

fn characteristic(args: &Arguments) -> Result<Vec<Fraction>> {
    let matrix = args.matrix(0)?;
    let used = args.letter()?;
    if matrix.iter().any(|entry| entry.variables().contains(&used)) {
        let shown = crate::language::write::text(&symbol_expr(&used));
        let message = format!("{shown} occurs in the matrix, so it cannot be the variable");
        return Err(Diagnostic::error(Code::AmbiguousVariable, message)
            .at(args.span(0))
            .hint("name another variable: variable=x"));
    }
    characteristic_polynomial(&matrix).map_err(linalg_error).at(args.span(0))
}

fn letter(args: &Arguments) -> Result<Fraction> {
    Ok(Fraction::from(MultiPoly::symbol(args.letter()?)))
}
