//! Matrices, and the matrices between polynomial bases.

use super::gives::Gives;
use crate::language::eval::Arguments;
use crate::language::ops::arithmetic;
use crate::language::ops::errors::linalg_error;
use nalgebra::DMatrix;

use super::parameter::{DEGREE, Parameter, optional, required, size};
use super::{Builtin, notions, solve};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::takes::Takes;
use crate::language::value::Value;
use crate::math::basis::{self, BasisError};
use crate::math::linalg;
use crate::math::number::Rational;
use crate::math::poly::Fraction;
use crate::math::ring::Ring;
use num_traits::Zero;

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Matrices and bases");

const MATRIX: Parameter = required("M", Takes::Matrix, "the matrix");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "bernstein_to_power",
        parameters: &[DEGREE],
        summary: "A_n: Bézier points over [0, 1] to power coefficients",
        gives: Gives::Matrix,
        example: "bernstein_to_power(3)",
        call: |_, args| {
            let n = sized(args, 0)?;
            Ok(lifted(&basis::bernstein_to_power(n)))
        },
        ..NEW
    },
    Builtin {
        name: "power_to_bernstein",
        parameters: &[DEGREE],
        summary: "the inverse of A_n: power coefficients to Bézier points over [0, 1]",
        gives: Gives::Matrix,
        example: "power_to_bernstein(3)",
        call: |_, args| {
            let n = sized(args, 0)?;
            Ok(lifted(&basis::power_to_bernstein(n)))
        },
        ..NEW
    },
    Builtin {
        name: "raising",
        parameters: &[size("m", "the degree of the points"), size("n", "the degree of the result")],
        summary: "the matrix from Bézier points of degree m to those of degree n >= m",
        gives: Gives::Matrix,
        example: "raising(2, 3)",
        call: |_, args| {
            let (m, n) = (sized(args, 0)?, sized(args, 1)?);
            basis::raising(m, n).map(|matrix| lifted(&matrix)).map_err(basis_error)
        },
        ..NEW
    },
    Builtin {
        name: "lowering",
        parameters: &[size("n", "the degree of the points"), size("m", "the degree of the result")],
        summary: "a left inverse of raising(m, n): exact for polynomials of degree at most m",
        gives: Gives::Matrix,
        example: "lowering(3, 2)",
        call: |_, args| {
            let (n, m) = (sized(args, 0)?, sized(args, 1)?);
            basis::lowering(n, m).map(|matrix| lifted(&matrix)).map_err(basis_error)
        },
        ..NEW
    },
    Builtin {
        name: "change_of_basis",
        parameters: &[
            DEGREE,
            required("from", notions::BASIS, "the basis of the given coefficients"),
            required("to", notions::BASIS, "the basis of the result"),
        ],
        summary: "the matrix between bases: power, bernstein, legendre, taylor, lagrange, newton, hermite",
        gives: Gives::Matrix,
        example: "change_of_basis(2, [bernstein, 0, 2], power)",
        call: |_, args| {
            let n = sized(args, 0)?;
            let (from, to) = (notions::basis(args, 1)?, notions::basis(args, 2)?);
            basis::change_of_basis(n, &from, &to).map(Value::Matrix).map_err(basis_error)
        },
        ..NEW
    },
    Builtin {
        name: "inverse",
        parameters: &[MATRIX],
        summary: "the inverse of a square matrix; also written M^-1",
        gives: Gives::Matrix,
        example: "inverse([1, 2; 3, 4])",
        call: |_, args| {
            linalg::inverse(&args.matrix(0)?).map(Value::Matrix).map_err(linalg_error).at(args.span(0))
        },
        ..NEW
    },
    Builtin {
        name: "det",
        parameters: &[MATRIX],
        summary: "the determinant",
        gives: Gives::Scalar,
        example: "det([1, 2; 3, 4])",
        call: |_, args| {
            linalg::determinant(&args.matrix(0)?).map(Value::Scalar).map_err(linalg_error).at(args.span(0))
        },
        ..NEW
    },
    Builtin {
        name: "trace",
        parameters: &[MATRIX],
        summary: "the sum of the diagonal of a square matrix",
        gives: Gives::Scalar,
        example: "trace([1, 2; 3, 4])",
        call: |_, args| {
            let matrix = args.matrix(0)?;
            if matrix.nrows() != matrix.ncols() {
                let message = format!("a {}x{} matrix has no trace", matrix.nrows(), matrix.ncols());
                return Err(Diagnostic::error(Code::Shape, message).at(args.span(0)));
            }
            Ok(Value::Scalar((0..matrix.nrows()).fold(Fraction::zero(), |sum, i| sum.plus(&matrix[(i, i)]))))
        },
        ..NEW
    },
    Builtin {
        name: "row_echelon",
        parameters: &[MATRIX],
        summary: "the reduced row echelon form",
        gives: Gives::Matrix,
        example: "row_echelon([1, 2, 3; 1, 2, 5])",
        call: |_, args| Ok(Value::Matrix(linalg::reduced_row_echelon(&args.matrix(0)?).matrix)),
        ..NEW
    },
    Builtin {
        name: "rank",
        parameters: &[MATRIX],
        summary: "the rank",
        gives: Gives::Count,
        example: "rank([1, 2; 2, 4])",
        call: |_, args| Ok(Value::int(linalg::rank(&args.matrix(0)?) as i64)),
        ..NEW
    },
    Builtin {
        name: "null_space",
        parameters: &[required(
            "M",
            Takes::OneOf(&[Takes::Matrix, Takes::Scalars]),
            "the matrix; a list is a row",
        )],
        summary: "a basis of the x with M x = 0, as columns",
        gives: Gives::Any,
        example: "null_space([1, 2; 2, 4])",
        call: |machine, args| {
            let matrix = match args.value(0)? {
                // A list is a row.
                Value::List(items) if items.iter().all(|item| item.as_scalar().is_some()) => {
                    let row = args.scalars(0)?;
                    DMatrix::from_vec(1, row.len(), row)
                }
                _ => args.matrix(0)?,
            };
            let basis = linalg::null_space(&matrix);
            if basis.ncols() == 0 {
                let note = "only x = 0 has M x = 0: the columns are independent";
                machine.note(Diagnostic::note(Code::Singular, note).at(args.span(0)));
                return Ok(Value::list(Vec::new()));
            }
            Ok(Value::Matrix(basis))
        },
        ..NEW
    },
    Builtin {
        name: "solve",
        parameters: &[
            required(
                "M",
                Takes::OneOf(&[Takes::Matrix, Takes::Scalar]),
                "the matrix, or a polynomial whose zeros are wanted",
            ),
            optional(
                "b",
                Takes::OneOf(&[Takes::Scalar, Takes::Points, Takes::Matrix]),
                "0",
                "the right side, a list or matrix; of a polynomial its variable",
            ),
        ],
        on_equations: solve::EQUATIONS,
        summary: "the x with M x = b, for a list or matrix b; of equations, their solutions",
        gives: Gives::Any,
        example: "solve([2, 0; 0, 4], [1, 1])",
        call: |machine, args| {
            if let Value::Scalar(formula) = args.value(0)? {
                return solve::zeros_of(machine, args, formula);
            }
            let matrix = args.matrix(0)?;
            if let Value::List(_) = args.value(1)? {
                let column = args.scalars(1)?;
                let right = DMatrix::from_vec(column.len(), 1, column);
                return match linalg::solve(&matrix, &right) {
                    Ok(x) => Ok(Value::List(x.iter().cloned().map(Value::Scalar).collect())),
                    Err(_) if matrix.nrows() == right.nrows() => {
                        solve::of_any_rank(machine, args, &matrix, right.as_slice())
                    }
                    Err(error) => Err(linalg_error(error)),
                };
            }
            linalg::solve(&matrix, &args.matrix(1)?).map(Value::Matrix).map_err(linalg_error)
        },
        ..NEW
    },
    Builtin {
        name: "transpose",
        parameters: &[required("M", Takes::Matrix, "the matrix or list")],
        summary: "rows and columns exchanged; a list becomes a column",
        gives: Gives::Any,
        example: "transpose([1, 2; 3, 4])",
        call: |_, args| arithmetic::transpose(args.value(0)?.clone()).at(args.span(0)),
        ..NEW
    },
    Builtin {
        name: "identity",
        parameters: &[size("n", "the number of rows")],
        summary: "the n x n identity matrix",
        gives: Gives::Matrix,
        example: "identity(3)",
        call: |_, args| {
            let n = sized(args, 0)?;
            Ok(Value::Matrix(DMatrix::identity(n, n)))
        },
        ..NEW
    },
];

/// A size whose square matrix stays within the limits.
fn sized(args: &Arguments, i: usize) -> Result<usize> {
    let n = args.size(i)?;
    crate::budget::charge_terms((n as u64 + 1).saturating_mul(n as u64 + 1));
    Ok(n)
}

fn lifted(matrix: &DMatrix<Rational>) -> Value {
    Value::Matrix(matrix.map(Fraction::from))
}

/// The diagnostic for an error of bases.
pub(super) fn basis_error(error: BasisError) -> Diagnostic {
    let code = match error {
        BasisError::EqualNodes { .. } => Code::Coincident,
        _ => Code::Shape,
    };
    Diagnostic::error(code, error.to_string())
}
