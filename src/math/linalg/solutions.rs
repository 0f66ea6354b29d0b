//! All solutions of a linear system, whatever its rank.

use nalgebra::DMatrix;

use super::{LinalgError, determinant, reduced_row_echelon};
use crate::math::ring::Field;

/// The solutions of A x = b: x_p = constant_p + Σ_c coefficient_{p,c} x_c for the columns p that are
/// determined by the columns c that are free.
#[derive(Clone, Debug, PartialEq)]
pub struct Solutions<F: Field> {
    /// The columns of A that are determined, increasing.
    pub determined: Vec<usize>,
    /// The others, increasing.
    pub free: Vec<usize>,
    /// One for each determined column; `None` if there are no solutions at all.
    pub constants: Option<Vec<F>>,
    /// A row for each determined column, a column for each free one.
    pub coefficients: DMatrix<F>,
    /// The determinant by which all this was divided, not 0: where symbols in A or b make it 0, other
    /// solutions may hold.
    pub minor: F,
}

/// All solutions of A x = b. A is m×n, b has m entries; x has n.
///
/// Cost: about n³ steps, twice.
///
/// # Errors
/// [`LinalgError::Shape`] if b has not m entries.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::{linalg::solutions, number::integer};
/// // x + 2 y = 3
/// let found = solutions(&DMatrix::from_row_slice(1, 2, &[1, 2].map(integer)), &[integer(3)]).unwrap();
/// assert_eq!((found.determined, found.free), (vec![0], vec![1]));
/// assert_eq!((found.constants, found.coefficients[(0, 0)].clone()), (Some(vec![integer(3)]), integer(-2)));
/// ```
pub fn solutions<F: Field>(a: &DMatrix<F>, b: &[F]) -> Result<Solutions<F>, LinalgError> {
    let (rows, width) = a.shape();
    if b.len() != rows {
        let operation = "the system A x = b";
        return Err(LinalgError::Shape { operation, left: a.shape(), right: (b.len(), 1) });
    }
    let whole =
        DMatrix::from_fn(rows, width + 1, |i, j| if j < width { a[(i, j)].clone() } else { b[i].clone() });
    let form = reduced_row_echelon(&whole);
    // The rows that are needed: with the pivots, a matrix with a determinant.
    let needed = reduced_row_echelon(&whole.select_columns(&form.pivots).transpose()).pivots;
    let minor = determinant(&whole.select_columns(&form.pivots).select_rows(&needed))?;
    let solvable = form.pivots.last() != Some(&width);
    let determined: Vec<usize> = form.pivots.iter().copied().filter(|&p| p < width).collect();
    let free: Vec<usize> = (0..width).filter(|c| determined.binary_search(c).is_err()).collect();
    let constants =
        solvable.then(|| (0..determined.len()).map(|k| form.matrix[(k, width)].clone()).collect());
    let coefficients =
        DMatrix::from_fn(determined.len(), free.len(), |k, c| -form.matrix[(k, free[c])].clone());
    Ok(Solutions { determined, free, constants, coefficients, minor })
}
