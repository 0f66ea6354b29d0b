//! Products of matrices.

use nalgebra::DMatrix;
use num_traits::Zero;

use super::fraction_free::integer_row;
use super::{LinalgError, joined_rows, rational_rows};
use crate::budget;
use crate::math::number::{Int, Rational};
use crate::math::ring::Ring;

/// The product A B of a k×l and an l×m matrix.
///
/// Cost: k l m products. When all entries are rational numbers, they are integer
/// products: rows of A and columns of B get common denominators first, and each entry
/// of the result needs a single gcd; the `*` of nalgebra takes one for each product and
/// each sum.
///
/// # Errors
/// [`LinalgError::Shape`] when A has not as many columns as B has rows.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::{linalg::multiply, number::rational};
/// let a = DMatrix::from_row_slice(1, 2, &[rational(1, 2), rational(1, 3)]);
/// let b = DMatrix::from_row_slice(2, 1, &[rational(1, 1), rational(3, 2)]);
/// assert_eq!(multiply(&a, &b), Ok(DMatrix::from_row_slice(1, 1, &[rational(1, 1)])));
/// ```
pub fn multiply<C: Ring>(a: &DMatrix<C>, b: &DMatrix<C>) -> Result<DMatrix<C>, LinalgError> {
    if a.ncols() != b.nrows() {
        return Err(LinalgError::Shape { operation: "the product A B", left: a.shape(), right: b.shape() });
    }
    budget::charge_terms((a.nrows() as u64).saturating_mul(b.ncols() as u64));
    let (rows, columns) = (joined_rows(a, None), joined_rows(&b.transpose(), None));
    if let (Some(rows), Some(columns)) = (rational_rows(&rows), rational_rows(&columns)) {
        let rows: Vec<_> = rows.iter().map(|row| integer_row(row)).collect();
        let columns: Vec<_> = columns.iter().map(|column| integer_row(column)).collect();
        return Ok(DMatrix::from_fn(a.nrows(), b.ncols(), |i, j| {
            let ((row, row_factor), (column, column_factor)) = (&rows[i], &columns[j]);
            let sum = integer_dot(row, column);
            C::from_rational(&(Rational::from_integer(sum) / (row_factor * column_factor)))
        }));
    }
    Ok(DMatrix::from_fn(a.nrows(), b.ncols(), |i, j| {
        let mut sum = C::zero();
        for (x, y) in rows[i].iter().zip(&columns[j]) {
            budget::step();
            if !x.is_zero() && !y.is_zero() {
                sum += x.times(y);
            }
        }
        sum
    }))
}

fn integer_dot(row: &[Int], column: &[Int]) -> Int {
    let mut sum = Int::ZERO;
    for (x, y) in row.iter().zip(column) {
        budget::step();
        if !x.is_zero() && !y.is_zero() {
            sum += x * y;
        }
    }
    sum
}
