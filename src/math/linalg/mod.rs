//! Exact linear algebra on nalgebra matrices over a [`Field`].
//!
//! nalgebra's own decompositions need floating point numbers; here every answer is
//! exact, so a matrix is singular or it is not. All functions rest on one row
//! reduction, except that systems of numbers are solved by substitution if they are triangular, and
//! by Dixon's lifting if they are large. A matrix all of whose entries are rational numbers (in whatever
//! field) is reduced by Bareiss' fraction-free elimination on integers; any other
//! by Gauss' elimination, which prefers pivots that are rational numbers.
//!
//! **Invariant.** The reduced row echelon form of a matrix is unique, so both
//! reductions give the same results; the tests compare them.
//!
//! References: E. H. Bareiss, "Sylvester's identity and multistep integer-preserving
//! Gaussian elimination", Math. Comp. 22 (1968); K. O. Geddes, S. R. Czapor, G. Labahn,
//! *Algorithms for Computer Algebra* (1992), chapter 9.

mod characteristic;
mod determinant;
mod elimination;
mod fraction_free;
mod kernel;
mod lifting;
mod product;
mod solutions;
mod triangular;

use std::fmt;

use nalgebra::DMatrix;

use crate::budget;
use crate::math::number::{Int, Rational, over_one_denominator};
use crate::math::ring::{Field, Ring};

pub use characteristic::characteristic_polynomial;
pub(crate) use kernel::{Kernel, kernel};
pub use product::multiply;
pub use solutions::{Solutions, solutions};

/// Why an operation on matrices has no result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LinalgError {
    /// The matrix has to be square.
    NotSquare {
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
    },
    /// The shapes of the two matrices do not fit together.
    Shape {
        /// What was asked for: "the product A B" or "the system A X = B".
        operation: &'static str,
        /// (rows, columns) of A.
        left: (usize, usize),
        /// (rows, columns) of B.
        right: (usize, usize),
    },
    /// The matrix is square but has no inverse.
    Singular {
        /// Number of rows and columns.
        size: usize,
        /// Its rank, less than `size`.
        rank: usize,
        /// The first column, counted from 0, that is a combination of those before it.
        column: usize,
    },
}

impl fmt::Display for LinalgError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LinalgError::NotSquare { rows, columns } => {
                write!(f, "the matrix is {rows}×{columns}, it has to be square")
            }
            LinalgError::Shape { operation, left, right } => {
                let ((m, n), (k, l)) = (left, right);
                write!(f, "{operation} is not defined: A is {m}×{n}, B is {k}×{l}")
            }
            LinalgError::Singular { size, rank, column } => {
                write!(
                    f,
                    "the {size}×{size} matrix is singular, its rank is {rank}: column {} ",
                    column + 1
                )?;
                match column {
                    0 => f.write_str("is zero"),
                    _ => f.write_str("is a combination of the columns before it"),
                }
            }
        }
    }
}

impl std::error::Error for LinalgError {}

/// A matrix in reduced row echelon form.
#[derive(Clone, Debug, PartialEq)]
pub struct Echelon<F: Field> {
    /// The form: each row starts with a 1, alone in its column and to the right of
    /// the one above; zero rows come last.
    pub matrix: DMatrix<F>,
    /// The columns of those leading ones, increasing. Their number is the rank.
    pub pivots: Vec<usize>,
}

/// A matrix brought to (unreduced) echelon form by one of the two eliminations.
enum Reduced<F> {
    Integer(fraction_free::Echelon),
    General(elimination::Echelon<F>),
}

impl<F: Field> Reduced<F> {
    /// Reduces [a | b]; pivots are sought in the columns of `a` only.
    fn new(a: &DMatrix<F>, b: Option<&DMatrix<F>>) -> Self {
        let width = a.ncols() + b.map_or(0, |b| b.ncols());
        budget::charge_terms((a.nrows() as u64).saturating_mul(width as u64));
        let rows = joined_rows(a, b);
        match rational_rows(&rows) {
            Some(rows) => Reduced::Integer(fraction_free::Echelon::new(&rows, a.ncols())),
            None => Reduced::General(elimination::Echelon::new(rows, a.ncols())),
        }
    }

    fn pivots(&self) -> &[usize] {
        match self {
            Reduced::Integer(echelon) => echelon.pivots(),
            Reduced::General(echelon) => echelon.pivots(),
        }
    }

    /// The determinant, for a square matrix.
    fn determinant(&self) -> F {
        match self {
            Reduced::Integer(echelon) => F::from_rational(&echelon.determinant()),
            Reduced::General(echelon) => echelon.determinant(),
        }
    }

    /// The x with column = Σ x_k (k-th pivot column).
    fn coordinates(&self, column: usize) -> Vec<F> {
        match self {
            Reduced::Integer(echelon) => echelon.coordinates(column).iter().map(F::from_rational).collect(),
            Reduced::General(echelon) => echelon.coordinates(column),
        }
    }
}

/// The rows of [a | b].
fn joined_rows<C: Ring>(a: &DMatrix<C>, b: Option<&DMatrix<C>>) -> Vec<Vec<C>> {
    let mut rows: Vec<Vec<C>> = a.row_iter().map(|row| row.iter().cloned().collect()).collect();
    if let Some(b) = b {
        for (row, right) in rows.iter_mut().zip(b.row_iter()) {
            row.extend(right.iter().cloned());
        }
    }
    rows
}

/// The same entries as rational numbers, if they all are.
fn rational_rows<C: Ring>(rows: &[Vec<C>]) -> Option<Vec<Vec<Rational>>> {
    rows.iter().map(|row| row.iter().map(Ring::as_rational).collect()).collect()
}

fn require_square<F>(a: &DMatrix<F>) -> Result<usize, LinalgError> {
    let (rows, columns) = (a.nrows(), a.ncols());
    if rows == columns { Ok(rows) } else { Err(LinalgError::NotSquare { rows, columns }) }
}

/// The X with A X = B.
///
/// A is n×n, B and X are n×m. Cost: about n³/3 + n²m steps; over the rationals n²m/2 products of
/// integers for a triangular A, otherwise for large A n³ steps on words and then n²m for each word of
/// the numbers in X.
///
/// # Errors
/// [`LinalgError`] when A is not square or singular, or B has not n rows.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::linalg::solve;
/// use polarform::number::{integer, rational};
/// let a = DMatrix::from_row_slice(2, 2, &[2, 1, 1, 3].map(integer));
/// let b = DMatrix::from_row_slice(2, 1, &[1, 1].map(integer));
/// assert_eq!(solve(&a, &b), Ok(DMatrix::from_row_slice(2, 1, &[rational(2, 5), rational(1, 5)])));
/// ```
pub fn solve<F: Field>(a: &DMatrix<F>, b: &DMatrix<F>) -> Result<DMatrix<F>, LinalgError> {
    let size = require_square(a)?;
    if b.nrows() != size {
        return Err(LinalgError::Shape {
            operation: "the system A X = B",
            left: a.shape(),
            right: b.shape(),
        });
    }
    if let Some(columns) = solution_of_numbers(a, b) {
        return Ok(DMatrix::from_vec(size, b.ncols(), columns));
    }
    let reduced = Reduced::new(a, Some(b));
    let pivots = reduced.pivots();
    let rank = pivots.len();
    if rank < size {
        let column = pivots.iter().zip(0..).find(|&(&pivot, i)| pivot != i).map_or(rank, |(_, i)| i);
        return Err(LinalgError::Singular { size, rank, column });
    }
    let columns = (size..size + b.ncols()).flat_map(|column| reduced.coordinates(column)).collect();
    Ok(DMatrix::from_vec(size, b.ncols(), columns))
}

/// The columns of X, if all entries are numbers and there is a faster way than elimination.
fn solution_of_numbers<F: Field>(a: &DMatrix<F>, b: &DMatrix<F>) -> Option<Vec<F>> {
    if b.ncols() == 0 {
        return None; // nothing would tell a singular matrix
    }
    let left = rational_rows(&joined_rows(a, None))?;
    let is_lower = is_lower_triangular(a);
    let is_triangular = is_lower || is_upper_triangular(a);
    if !is_triangular && left.len() < lifting::SMALLEST {
        return None;
    }
    let right = rational_rows(&joined_rows(b, None))?;
    budget::charge_terms((a.nrows() as u64).saturating_mul((a.ncols() + b.ncols()) as u64));
    let (rows, factors): (Vec<Vec<Int>>, Vec<Rational>) =
        left.iter().map(|row| fraction_free::integer_row(row)).unzip();
    let lifting = if is_triangular { None } else { Some(lifting::Lifting::new(&rows)?) };
    let mut columns = Vec::with_capacity(a.nrows() * b.ncols());
    let mut guess = Int::ONE;
    for k in 0..b.ncols() {
        let column: Vec<Rational> = right.iter().zip(&factors).map(|(row, f)| &row[k] * f).collect();
        let (integers, scale) = over_one_denominator(&column);
        let (numerators, denominator) = match &lifting {
            Some(lifting) => lifting.solve(&integers, &guess)?,
            None => triangular::solve(&rows, is_lower, &integers)?,
        };
        guess = denominator.clone();
        let denominator = denominator * scale;
        columns
            .extend(numerators.into_iter().map(|x| F::from_rational(&Rational::new(x, denominator.clone()))));
    }
    Some(columns)
}

/// The inverse of a square matrix: [`solve`] with the identity on the right. Cost: about n³ steps.
///
/// # Errors
/// [`LinalgError`] when the matrix is not square or singular.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::linalg::{inverse, LinalgError};
/// use polarform::number::{integer, rational};
/// let a = DMatrix::from_row_slice(2, 2, &[1, 0, -2, 2].map(integer));
/// let expected = [integer(1), integer(0), integer(1), rational(1, 2)];
/// assert_eq!(inverse(&a), Ok(DMatrix::from_row_slice(2, 2, &expected)));
/// let b = DMatrix::from_row_slice(2, 2, &[1, 2, 2, 4].map(integer));
/// assert_eq!(inverse(&b), Err(LinalgError::Singular { size: 2, rank: 1, column: 1 }));
/// ```
pub fn inverse<F: Field>(a: &DMatrix<F>) -> Result<DMatrix<F>, LinalgError> {
    let size = require_square(a)?;
    solve(a, &DMatrix::identity(size, size))
}

/// The largest number of linearly independent rows (or columns). Cost: about n³/3 steps.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::{linalg::rank, number::integer};
/// let a = DMatrix::from_row_slice(2, 3, &[1, 2, 3, 2, 4, 6].map(integer));
/// assert_eq!(rank(&a), 1);
/// ```
pub fn rank<F: Field>(a: &DMatrix<F>) -> usize {
    Reduced::new(a, None).pivots().len()
}

/// The determinant; 1 for the 0×0 matrix. Cost: about n³/3 steps; over the rationals for large n n³ steps on words and
/// then n² for each word of the result, as a rule.
///
/// # Errors
/// [`LinalgError::NotSquare`].
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::{linalg::determinant, number::integer};
/// let a = DMatrix::from_row_slice(2, 2, &[1, 2, 3, 4].map(integer));
/// assert_eq!(determinant(&a), Ok(integer(-2)));
/// ```
pub fn determinant<F: Field>(a: &DMatrix<F>) -> Result<F, LinalgError> {
    let size = require_square(a)?;
    if size >= lifting::SMALLEST
        && !is_lower_triangular(a)
        && let Some(rows) = rational_rows(&joined_rows(a, None))
    {
        budget::charge_terms((size as u64).saturating_mul(size as u64));
        let (rows, factors): (Vec<Vec<Int>>, Vec<Rational>) =
            rows.iter().map(|row| fraction_free::integer_row(row)).unzip();
        if let Some(found) = determinant::determinant(&rows) {
            let scale = factors.into_iter().product::<Rational>();
            return Ok(F::from_rational(&(Rational::from_integer(found) / scale)));
        }
    }
    Ok(Reduced::new(a, None).determinant())
}

/// The reduced row echelon form, of the same shape, and its pivot columns. Cost: about n³/2 steps.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::{linalg::reduced_row_echelon, number::integer};
/// let a = DMatrix::from_row_slice(2, 3, &[1, 2, 3, 1, 2, 5].map(integer));
/// let form = reduced_row_echelon(&a);
/// assert_eq!(form.pivots, [0, 2]);
/// assert_eq!(form.matrix, DMatrix::from_row_slice(2, 3, &[1, 2, 0, 0, 0, 1].map(integer)));
/// ```
pub fn reduced_row_echelon<F: Field>(a: &DMatrix<F>) -> Echelon<F> {
    let reduced = Reduced::new(a, None);
    let pivots = reduced.pivots().to_vec();
    let mut matrix = DMatrix::zeros(a.nrows(), a.ncols());
    for column in 0..a.ncols() {
        match pivots.binary_search(&column) {
            Ok(k) => matrix[(k, column)] = F::one(),
            Err(_) => {
                for (k, x) in reduced.coordinates(column).into_iter().enumerate() {
                    matrix[(k, column)] = x;
                }
            }
        }
    }
    Echelon { matrix, pivots }
}

/// A matrix N whose columns are a basis of the solutions of A x = 0.
///
/// A is m×n, N is n×(n − rank A). Column c of N has a 1 in the place of the c-th
/// column of A that is not a pivot, and 0 in those of the others. Cost: about n³/2 steps.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::{linalg::null_space, number::integer};
/// let a = DMatrix::from_row_slice(1, 2, &[1, 2].map(integer));
/// assert_eq!(null_space(&a), DMatrix::from_row_slice(2, 1, &[-2, 1].map(integer)));
/// ```
pub fn null_space<F: Field>(a: &DMatrix<F>) -> DMatrix<F> {
    let reduced = Reduced::new(a, None);
    let pivots = reduced.pivots();
    let free: Vec<usize> = (0..a.ncols()).filter(|column| pivots.binary_search(column).is_err()).collect();
    let mut basis = DMatrix::zeros(a.ncols(), free.len());
    for (c, &column) in free.iter().enumerate() {
        basis[(column, c)] = F::one();
        for (&pivot, x) in pivots.iter().zip(reduced.coordinates(column)) {
            basis[(pivot, c)] = -x;
        }
    }
    basis
}

/// Whether all entries above the diagonal are 0. The matrix need not be square.
pub(crate) fn is_lower_triangular<C: Ring>(a: &DMatrix<C>) -> bool {
    (0..a.ncols()).all(|j| (0..a.nrows().min(j)).all(|i| a[(i, j)].is_zero()))
}

/// Whether all entries below the diagonal are 0. The matrix need not be square.
fn is_upper_triangular<C: Ring>(a: &DMatrix<C>) -> bool {
    (0..a.ncols()).all(|j| (j + 1..a.nrows()).all(|i| a[(i, j)].is_zero()))
}

#[cfg(test)]
pub(crate) mod surd;
#[cfg(test)]
mod tests;
