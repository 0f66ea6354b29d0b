//! Gauss' elimination over any field.
//!
//! Row operations a_i ← a_i − (a_ic / p) a_k and back substitution, with elements in
//! canonical form throughout. Among the possible pivots of a column a rational number
//! is preferred to a symbolic entry, and then the row with the fewest entries: both
//! keep what is carried to the other rows small.

use crate::budget;
use crate::math::ring::Field;

/// An echelon form of a matrix.
pub(super) struct Echelon<F> {
    /// The pivot rows, first pivot first.
    rows: Vec<Vec<F>>,
    pivots: Vec<usize>,
    /// The reciprocals of the pivots.
    reciprocals: Vec<F>,
    /// The determinant of the given matrix, if it is square.
    determinant: F,
}

impl<F: Field> Echelon<F> {
    /// Reduces the matrix with these rows (of equal length); pivots are sought in the
    /// first `limit` columns.
    pub(super) fn new(mut rows: Vec<Vec<F>>, limit: usize) -> Self {
        let mut pivots = Vec::new();
        let mut reciprocals = Vec::new();
        let mut determinant = F::one();
        for column in 0..limit {
            let done = pivots.len();
            let Some(chosen) = (done..rows.len())
                .filter(|&i| !rows[i][column].is_zero())
                .min_by_key(|&i| (rows[i][column].as_rational().is_none(), entries(&rows[i][column..])))
            else {
                continue;
            };
            if chosen != done {
                rows.swap(chosen, done);
                determinant = -determinant;
            }
            let (above, below) = rows.split_at_mut(done + 1);
            let pivot_row = &above[done];
            determinant = determinant.times(&pivot_row[column]);
            let reciprocal = pivot_row[column].inverse().expect("a pivot is not zero");
            for row in below {
                let factor = std::mem::replace(&mut row[column], F::zero()).times(&reciprocal);
                if factor.is_zero() {
                    continue;
                }
                for (x, y) in row.iter_mut().zip(pivot_row).skip(column + 1) {
                    budget::step();
                    if !y.is_zero() {
                        *x -= factor.times(y);
                    }
                }
            }
            pivots.push(column);
            reciprocals.push(reciprocal);
        }
        if pivots.len() < rows.len() {
            determinant = F::zero();
        }
        rows.truncate(pivots.len());
        Echelon { rows, pivots, reciprocals, determinant }
    }

    pub(super) fn pivots(&self) -> &[usize] {
        &self.pivots
    }

    pub(super) fn determinant(&self) -> F {
        self.determinant.clone()
    }

    /// The x with column = Σ x_k (k-th pivot column).
    pub(super) fn coordinates(&self, column: usize) -> Vec<F> {
        let rank = self.pivots.len();
        let mut x = vec![F::zero(); rank];
        for k in (0..rank).rev() {
            let row = &self.rows[k];
            let mut sum = row[column].clone();
            for l in k + 1..rank {
                budget::step();
                if !x[l].is_zero() && !row[self.pivots[l]].is_zero() {
                    sum -= row[self.pivots[l]].times(&x[l]);
                }
            }
            x[k] = sum.times(&self.reciprocals[k]);
        }
        x
    }
}

fn entries<F: Field>(row: &[F]) -> usize {
    row.iter().filter(|x| !x.is_zero()).count()
}
