//! Condition numbers of matrices and of bases, exactly.
//!
//! **Definition.** κ(A) = ‖A‖ ‖A^{-1}‖ bounds how much relative errors of the data can grow when
//! A x = b is solved. In the ∞-norm (largest absolute row sum) and the 1-norm (largest absolute
//! column sum) it is a rational number for a rational matrix.
//!
//! For A_n, the change from the Bernstein basis over [0, 1] to powers, both numbers are
//! (n+1) max_i 2^i C(n,i), the maximum being at i = ⌊2(n+1)/3⌋; they grow as 3^n.
//!
//! References: R. T. Farouki, V. T. Rajan, "On the numerical condition of polynomials in Bernstein
//! form", CAGD 4 (1987); R. T. Farouki, "The Bernstein polynomial basis: a centennial
//! retrospective", CAGD 29 (2012), section 6.

use nalgebra::DMatrix;
use num_traits::{Signed, Zero};

use crate::math::basis::{bernstein_to_power, power_to_bernstein};
use crate::math::linalg::{LinalgError, inverse};
use crate::math::number::Rational;

/// A norm of matrices whose value is rational.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Norm {
    /// ‖A‖_1, the largest sum of absolute values in a column.
    One,
    /// ‖A‖_∞, the largest sum of absolute values in a row.
    Infinity,
}

impl Norm {
    /// The norm of a matrix; 0 for an empty one.
    ///
    /// ```
    /// use nalgebra::DMatrix;
    /// use polarform::interpolate::Norm;
    /// use polarform::number::integer as z;
    /// let a = DMatrix::from_row_slice(2, 2, &[1, -2, 3, 4].map(z));
    /// assert_eq!((Norm::One.of(&a), Norm::Infinity.of(&a)), (z(6), z(7)));
    /// ```
    pub fn of(self, matrix: &DMatrix<Rational>) -> Rational {
        let rows = self == Norm::Infinity;
        let mut sums = vec![Rational::zero(); if rows { matrix.nrows() } else { matrix.ncols() }];
        for (j, column) in matrix.column_iter().enumerate() {
            for (i, x) in column.iter().enumerate() {
                crate::budget::steps(64);
                sums[if rows { i } else { j }] += x.abs();
            }
        }
        sums.into_iter().max().unwrap_or_else(Rational::zero)
    }
}

/// A condition number and the two norms it is the product of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Condition {
    /// Which norm.
    pub norm: Norm,
    /// ‖A‖
    pub of_matrix: Rational,
    /// ‖A^{-1}‖
    pub of_inverse: Rational,
}

impl Condition {
    fn new(norm: Norm, matrix: &DMatrix<Rational>, inverse: &DMatrix<Rational>) -> Self {
        Condition { norm, of_matrix: norm.of(matrix), of_inverse: norm.of(inverse) }
    }

    /// κ = ‖A‖ ‖A^{-1}‖
    pub fn number(&self) -> Rational {
        &self.of_matrix * &self.of_inverse
    }
}

/// The condition number of any invertible matrix. Cost: that of the exact inverse.
///
/// # Errors
/// [`LinalgError`] when the matrix is not square, or singular.
pub fn matrix_condition(matrix: &DMatrix<Rational>, norm: Norm) -> Result<Condition, LinalgError> {
    Ok(Condition::new(norm, matrix, &inverse(matrix)?))
}

/// The condition number of A_n, from the Bernstein basis on [0, 1] to powers, for degree n.
///
/// ```
/// use polarform::interpolate::{Norm, power_bernstein_condition};
/// use polarform::number::integer as z;
/// // A_2 has the rows 1, -2 2, 1 -2 1; its inverse the last row 1 1 1
/// let condition = power_bernstein_condition(2, Norm::Infinity);
/// assert_eq!(condition.number(), z(12));
/// ```
pub fn power_bernstein_condition(n: usize, norm: Norm) -> Condition {
    Condition::new(norm, &bernstein_to_power(n), &power_to_bernstein(n))
}
