//! Tridiagonal systems over a field, also cyclic ones.
//!
//! Row i is lower_i x_{i−1} + diagonal_i x_i + upper_i x_{i+1}. In a cyclic matrix the indices are
//! taken modulo n; otherwise lower_0 and upper_{n−1} are not used.
//!
//! Elimination goes down the band and exchanges a row with the next one only where a pivot is 0
//! (then one more diagonal fills in), so it finds the solution whenever there is one. Diagonally
//! dominant matrices, as those of splines, never need it. A cyclic system is solved by moving
//! the last unknown to the right side.

use nalgebra::DMatrix;

use crate::budget;
use crate::math::interpolate::InterpolationError;
use crate::math::interpolate::datum::{Datum, as_many, enough, same_dimension};
use crate::math::linalg::{LinalgError, rank, solve};
use crate::math::ring::Field;

/// A tridiagonal or cyclic tridiagonal matrix.
///
/// ```
/// use polarform::interpolate::Tridiagonal;
/// use polarform::number::{integer as z, rational as q};
/// let matrix = Tridiagonal::new([0, 1, 1].map(z).to_vec(), vec![z(2); 3], [1, 1, 0].map(z).to_vec(), false)?;
/// assert_eq!(matrix.solve(&[z(3), z(4), z(3)])?, [1, 1, 1].map(z));
/// assert_eq!(matrix.solve(&[z(2), q(3, 2), z(1)])?, [z(1), z(0), q(1, 2)]);
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Tridiagonal<C> {
    lower: Vec<C>,
    diagonal: Vec<C>,
    upper: Vec<C>,
    cyclic: bool,
}

impl<C: Field> Tridiagonal<C> {
    /// The matrix with these three diagonals of n entries each.
    ///
    /// # Errors
    /// [`InterpolationError`] when they are empty or of different lengths.
    pub fn new(
        lower: Vec<C>,
        diagonal: Vec<C>,
        upper: Vec<C>,
        cyclic: bool,
    ) -> Result<Self, InterpolationError> {
        enough(diagonal.len(), 1)?;
        as_many("entries below the diagonal", lower.len(), diagonal.len())?;
        as_many("entries above the diagonal", upper.len(), diagonal.len())?;
        Ok(Tridiagonal { lower, diagonal, upper, cyclic })
    }

    /// lower_0, …, lower_{n−1}
    pub fn lower(&self) -> &[C] {
        &self.lower
    }

    /// diagonal_0, …, diagonal_{n−1}
    pub fn diagonal(&self) -> &[C] {
        &self.diagonal
    }

    /// upper_0, …, upper_{n−1}
    pub fn upper(&self) -> &[C] {
        &self.upper
    }

    /// Whether the indices of the unknowns are taken modulo n.
    pub fn is_cyclic(&self) -> bool {
        self.cyclic
    }

    /// The number n of rows and columns.
    pub fn size(&self) -> usize {
        self.diagonal.len()
    }

    /// The entries of row i with their columns; a column may occur twice when n < 3.
    fn row(&self, i: usize) -> impl Iterator<Item = (usize, &C)> {
        let n = self.size();
        let before = if i > 0 { Some(i - 1) } else { self.cyclic.then_some(n - 1) };
        let after = if i + 1 < n { Some(i + 1) } else { self.cyclic.then_some(0) };
        let entries = [(before, &self.lower[i]), (Some(i), &self.diagonal[i]), (after, &self.upper[i])];
        entries.into_iter().filter_map(|(column, entry)| Some((column?, entry)))
    }

    /// All n² entries.
    pub fn matrix(&self) -> DMatrix<C> {
        let n = self.size();
        budget::charge_terms((n as u64).saturating_mul(n as u64));
        let mut matrix = DMatrix::zeros(n, n);
        for i in 0..n {
            for (j, entry) in self.row(i) {
                matrix[(i, j)] += entry.clone();
            }
        }
        matrix
    }

    /// The product with a column of numbers or points. Cost: 3n products.
    #[cfg(test)]
    pub(super) fn product<V: Datum<C>>(&self, x: &[V]) -> Vec<V> {
        let entry = |i: usize| {
            self.row(i).fold(x[i].origin(), |sum, (j, entry)| {
                budget::step();
                sum.added(&x[j].multiple(entry))
            })
        };
        (0..self.size()).map(entry).collect()
    }

    /// The x with A x = right. Cost: at most 9n products; n³/3 for a cyclic matrix that becomes
    /// singular without its last row and column.
    ///
    /// # Errors
    /// [`InterpolationError::Singular`]; others when the right side does not fit.
    pub fn solve<V: Datum<C>>(&self, right: &[V]) -> Result<Vec<V>, InterpolationError> {
        let n = self.size();
        as_many("right sides", right.len(), n)?;
        same_dimension(right)?;
        if !self.cyclic {
            let singular = || InterpolationError::Singular { unknowns: n, rank: rank(&self.matrix()) };
            let factors = Factors::new(&self.lower, &self.diagonal, &self.upper).ok_or_else(singular)?;
            return Ok(factors.solve(right.to_vec()));
        }
        match self.solve_cyclic(right) {
            Some(solution) => Ok(solution),
            None => self.solve_densely(right),
        }
    }

    /// The last unknown z moved to the right: x = p − z q with T p = right, T q = its column.
    fn solve_cyclic<V: Datum<C>>(&self, right: &[V]) -> Option<Vec<V>> {
        let last = self.size() - 1;
        if last < 2 {
            return None;
        }
        let factors = Factors::new(&self.lower[..last], &self.diagonal[..last], &self.upper[..last])?;
        let mut column = vec![C::zero(); last];
        column[0] = self.lower[0].clone();
        column[last - 1] = self.upper[last - 1].clone();
        let q = factors.solve(column);
        let mut p = factors.solve(right[..last].to_vec());
        let (down, up) = (&self.lower[last], &self.upper[last]);
        let pivot = self.diagonal[last].minus(&up.times(&q[0])).minus(&down.times(&q[last - 1]));
        let rest = right[last].less(&p[0].multiple(up)).less(&p[last - 1].multiple(down));
        let z = rest.multiple(&pivot.inverse()?);
        for (x, q) in p.iter_mut().zip(&q) {
            *x = x.less(&z.multiple(q));
        }
        p.push(z);
        Some(p)
    }

    fn solve_densely<V: Datum<C>>(&self, right: &[V]) -> Result<Vec<V>, InterpolationError> {
        let n = self.size();
        let entries = right.iter().flat_map(|row| row.coordinates().iter().cloned());
        let right = DMatrix::from_row_iterator(n, right[0].dimension(), entries);
        match solve(&self.matrix(), &right) {
            Ok(x) => Ok(x.row_iter().map(|row| V::from_coordinates(row.iter().cloned().collect())).collect()),
            Err(LinalgError::Singular { size, rank, .. }) => {
                Err(InterpolationError::Singular { unknowns: size, rank })
            }
            Err(LinalgError::NotSquare { .. } | LinalgError::Shape { .. }) => {
                Err(InterpolationError::Singular { unknowns: n, rank: 0 })
            }
        }
    }
}

/// The steps of the elimination and what is left on and above the diagonal.
struct Factors<C> {
    /// Whether rows i and i + 1 are exchanged, and how often row i is then taken off row i + 1.
    steps: Vec<(bool, C)>,
    /// The reciprocal of the pivot, and the two entries to its right.
    rows: Vec<[C; 3]>,
}

impl<C: Field> Factors<C> {
    /// `None` if the matrix is singular.
    fn new(lower: &[C], diagonal: &[C], upper: &[C]) -> Option<Self> {
        let n = diagonal.len();
        let entry = |i: usize| if i + 1 < n { upper[i].clone() } else { C::zero() };
        let (mut steps, mut rows) = (Vec::with_capacity(n), Vec::with_capacity(n));
        let mut current = [diagonal[0].clone(), entry(0), C::zero()];
        for i in 1..n {
            budget::step();
            let mut next = [lower[i].clone(), diagonal[i].clone(), entry(i)];
            let exchanged = current[0].is_zero();
            if exchanged {
                std::mem::swap(&mut current, &mut next);
            }
            let [pivot, first, second] = current;
            let inverse = pivot.inverse()?;
            let factor = next[0].times(&inverse);
            current =
                [next[1].minus(&factor.times(&first)), next[2].minus(&factor.times(&second)), C::zero()];
            steps.push((exchanged, factor));
            rows.push([inverse, first, second]);
        }
        let [pivot, first, second] = current;
        rows.push([pivot.inverse()?, first, second]);
        Some(Factors { steps, rows })
    }

    fn solve<V: Datum<C>>(&self, mut x: Vec<V>) -> Vec<V> {
        for (i, (exchanged, factor)) in self.steps.iter().enumerate() {
            budget::step();
            if *exchanged {
                x.swap(i, i + 1);
            }
            if !factor.is_zero() {
                x[i + 1] = x[i + 1].less(&x[i].multiple(factor));
            }
        }
        for (i, [inverse, first, second]) in self.rows.iter().enumerate().rev() {
            budget::step();
            let mut rest = x[i].clone();
            for (j, entry) in [(i + 1, first), (i + 2, second)] {
                if j < x.len() && !entry.is_zero() {
                    rest = rest.less(&x[j].multiple(entry));
                }
            }
            x[i] = rest.multiple(inverse);
        }
        x
    }
}
