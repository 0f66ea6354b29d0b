//! Matrices, and the matrices between polynomial bases.

use nalgebra::DMatrix;

use super::Builtin;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::ops::arithmetic;
use crate::language::ops::errors::{linalg_error, wrong_kind};
use crate::language::value::Value;
use crate::math::basis::{self, Basis, BasisError};
use crate::math::linalg;
use crate::math::number::Rational;
use crate::math::poly::Fraction;

type Result<T> = std::result::Result<T, Diagnostic>;

const TOPIC: &str = "Matrices and bases";

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "bernstein_to_power",
        signature: "bernstein_to_power(n)",
        summary: "A_n: Bézier points over [0, 1] to power coefficients",
        example: "bernstein_to_power(3)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("bernstein_to_power(n)", 1..=1, &[])?;
            let n = sized(args, 0)?;
            Ok(lifted(&basis::bernstein_to_power(n)))
        },
    },
    Builtin {
        name: "power_to_bernstein",
        signature: "power_to_bernstein(n)",
        summary: "the inverse of A_n: power coefficients to Bézier points over [0, 1]",
        example: "power_to_bernstein(3)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("power_to_bernstein(n)", 1..=1, &[])?;
            let n = sized(args, 0)?;
            Ok(lifted(&basis::power_to_bernstein(n)))
        },
    },
    Builtin {
        name: "raising",
        signature: "raising(m, n)",
        summary: "the matrix from Bézier points of degree m to those of degree n >= m",
        example: "raising(2, 3)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("raising(m, n)", 2..=2, &[])?;
            let (m, n) = (sized(args, 0)?, sized(args, 1)?);
            basis::raising(m, n).map(|matrix| lifted(&matrix)).map_err(basis_error)
        },
    },
    Builtin {
        name: "lowering",
        signature: "lowering(n, m)",
        summary: "a left inverse of raising(m, n): exact for polynomials of degree at most m",
        example: "lowering(3, 2)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("lowering(n, m)", 2..=2, &[])?;
            let (n, m) = (sized(args, 0)?, sized(args, 1)?);
            basis::lowering(n, m).map(|matrix| lifted(&matrix)).map_err(basis_error)
        },
    },
    Builtin {
        name: "change_of_basis",
        signature: "change_of_basis(n, from, to)",
        summary: "the matrix between bases: power, bernstein, taylor, lagrange, newton, hermite",
        example: "change_of_basis(2, [bernstein, 0, 2], power)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("change_of_basis(n, from, to)", 3..=3, &["from", "to"])?;
            let n = sized(args, 0)?;
            let (from, to) = (read_basis(args, 1)?, read_basis(args, 2)?);
            basis::change_of_basis(n, &from, &to).map(Value::Matrix).map_err(basis_error)
        },
    },
    Builtin {
        name: "inverse",
        signature: "inverse(M)",
        summary: "the inverse of a square matrix; also written M^-1",
        example: "inverse([1, 2; 3, 4])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("inverse(M)", 1..=1, &[])?;
            linalg::inverse(&args.matrix(0)?).map(Value::Matrix).map_err(linalg_error).at(args.span(0))
        },
    },
    Builtin {
        name: "det",
        signature: "det(M)",
        summary: "the determinant",
        example: "det([1, 2; 3, 4])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("det(M)", 1..=1, &[])?;
            linalg::determinant(&args.matrix(0)?).map(Value::Scalar).map_err(linalg_error).at(args.span(0))
        },
    },
    Builtin {
        name: "rank",
        signature: "rank(M)",
        summary: "the rank",
        example: "rank([1, 2; 2, 4])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("rank(M)", 1..=1, &[])?;
            Ok(Value::int(linalg::rank(&args.matrix(0)?) as i64))
        },
    },
    Builtin {
        name: "null_space",
        signature: "null_space(M)",
        summary: "a basis of the x with M x = 0, as columns",
        example: "null_space([1, 2; 2, 4])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("null_space(M)", 1..=1, &[])?;
            Ok(Value::Matrix(linalg::null_space(&args.matrix(0)?)))
        },
    },
    Builtin {
        name: "solve",
        signature: "solve(M, b)",
        summary: "the x with M x = b, for a list or matrix b",
        example: "solve([2, 0; 0, 4], [1, 1])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("solve(M, b)", 2..=2, &[])?;
            let matrix = args.matrix(0)?;
            if let Value::List(_) = args.value(1)? {
                let column = args.scalars(1)?;
                let right = DMatrix::from_vec(column.len(), 1, column);
                let solution = linalg::solve(&matrix, &right).map_err(linalg_error)?;
                return Ok(Value::List(solution.iter().cloned().map(Value::Scalar).collect()));
            }
            linalg::solve(&matrix, &args.matrix(1)?).map(Value::Matrix).map_err(linalg_error)
        },
    },
    Builtin {
        name: "transpose",
        signature: "transpose(M)",
        summary: "rows and columns exchanged; a list becomes a column",
        example: "transpose([1, 2; 3, 4])",
        topic: TOPIC,
        call: |_, args| {
            args.expect("transpose(M)", 1..=1, &[])?;
            arithmetic::transpose(args.value(0)?.clone()).at(args.span(0))
        },
    },
    Builtin {
        name: "identity",
        signature: "identity(n)",
        summary: "the n x n identity matrix",
        example: "identity(3)",
        topic: TOPIC,
        call: |_, args| {
            args.expect("identity(n)", 1..=1, &[])?;
            let n = sized(args, 0)?;
            Ok(Value::Matrix(DMatrix::identity(n, n)))
        },
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
        BasisError::EqualEnds | BasisError::EqualNodes { .. } => Code::Coincident,
        _ => Code::Shape,
    };
    Diagnostic::error(code, error.to_string())
}

/// `power`, `bernstein`, `[bernstein, a, b]`, `[lagrange, t_0, …]` and so on.
pub(super) fn read_basis(args: &Arguments, i: usize) -> Result<Basis<Fraction>> {
    let value = args.value(i)?;
    let wrong = || {
        wrong_kind("a basis", value)
            .at(args.span(i))
            .hint("power, bernstein, [bernstein, a, b], [taylor, a], [lagrange, t0, t1, ...]")
            .hint("or [newton, t0, t1, ...], [hermite, a, b]")
    };
    let (name, rest) = match value {
        Value::List(items) => items.split_first().ok_or_else(wrong)?,
        single => (single, &[] as &[Value]),
    };
    let name = match name {
        Value::Text(word) => word.as_str(),
        Value::Builtin(word) => word,
        _ => return Err(wrong()),
    };
    let numbers: Option<Vec<Fraction>> = rest.iter().map(|item| item.as_scalar().cloned()).collect();
    let numbers = numbers.ok_or_else(wrong)?;
    let ends = |numbers: &[Fraction]| -> Result<(Fraction, Fraction)> {
        match numbers {
            [] => Ok((num_traits::Zero::zero(), num_traits::One::one())),
            [a, b] => Ok((a.clone(), b.clone())),
            _ => Err(wrong()),
        }
    };
    match name {
        "power" if numbers.is_empty() => Ok(Basis::Power),
        "taylor" => match numbers.as_slice() {
            [at] => Ok(Basis::Taylor { at: at.clone() }),
            _ => Err(wrong()),
        },
        "bernstein" => ends(&numbers).map(|(a, b)| Basis::Bernstein { a, b }),
        "hermite" => ends(&numbers).map(|(a, b)| Basis::HermiteEndpoints { a, b }),
        "lagrange" => Ok(Basis::Lagrange(numbers)),
        "newton" => Ok(Basis::Newton(numbers)),
        _ => Err(wrong()),
    }
}
