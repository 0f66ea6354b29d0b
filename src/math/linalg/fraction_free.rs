//! Bareiss' elimination: rational rows are made integer, and stay so.
//!
//! Step k replaces each entry below the pivot row by a_ij ← (p a_ij − a_ic a_kj) / d,
//! where p is the pivot, c its column and d the pivot before (1 at first). By
//! Sylvester's identity the division is exact and every entry is a minor of the
//! integer matrix, so numbers stay as short as the answer needs without any gcd.
//!
//! **Invariant.** After r steps the pivot d_r is the minor of the pivot rows and
//! columns. By Cramer's rule d_r times the coordinates of any column are integers;
//! back substitution finds those, again by exact divisions.

use num_integer::Integer;
use num_traits::{One, Zero};

use crate::budget;
use crate::math::number::{Int, Rational};

/// An echelon form of an integer matrix whose rows are multiples of the given ones.
pub(super) struct Echelon {
    /// The pivot rows, first pivot first.
    rows: Vec<Vec<Int>>,
    pivots: Vec<usize>,
    /// The last pivot; 1 if there is none.
    minor: Int,
    /// The determinant of the given matrix, if it is square.
    determinant: Rational,
}

impl Echelon {
    /// Reduces the matrix with these rows (of equal length); pivots are sought in the
    /// first `limit` columns.
    pub(super) fn new(rows: &[Vec<Rational>], limit: usize) -> Self {
        let mut scale = Rational::one();
        let mut rows: Vec<Vec<Int>> = rows
            .iter()
            .map(|row| {
                let (integers, factor) = integer_row(row);
                scale *= factor;
                integers
            })
            .collect();
        let (pivots, minor, odd) = eliminate(&mut rows, limit);
        let full = pivots.len() == rows.len();
        let signed = Rational::from_integer(if odd { -&minor } else { minor.clone() });
        let determinant = if full { signed / scale } else { Rational::zero() };
        rows.truncate(pivots.len());
        Echelon { rows, pivots, minor, determinant }
    }

    pub(super) fn pivots(&self) -> &[usize] {
        &self.pivots
    }

    pub(super) fn determinant(&self) -> Rational {
        self.determinant.clone()
    }

    /// The x with column = Σ x_k (k-th pivot column).
    pub(super) fn coordinates(&self, column: usize) -> Vec<Rational> {
        let rank = self.pivots.len();
        let mut scaled = vec![Int::ZERO; rank];
        for k in (0..rank).rev() {
            let row = &self.rows[k];
            let mut sum = &self.minor * &row[column];
            for l in k + 1..rank {
                budget::step();
                if !scaled[l].is_zero() && !row[self.pivots[l]].is_zero() {
                    sum -= &row[self.pivots[l]] * &scaled[l];
                }
            }
            if !sum.is_zero() {
                scaled[k] = sum.div_exact(&row[self.pivots[k]]);
            }
        }
        scaled.into_iter().map(|x| Rational::new(x, self.minor.clone())).collect()
    }
}

/// The row times the positive factor that makes its entries integers without a common
/// divisor, and that factor (1 for a row of zeros).
pub(super) fn integer_row(row: &[Rational]) -> (Vec<Int>, Rational) {
    let denominator = common_denominator(row);
    let mut integers: Vec<Int> = row.iter().map(|q| q.numer() * denominator.div_exact(q.denom())).collect();
    let mut content = Int::ZERO;
    for x in &integers {
        content = content.gcd(x);
        if content.is_one() {
            return (integers, Rational::from_integer(denominator));
        }
    }
    if content.is_zero() {
        return (integers, Rational::one());
    }
    for x in &mut integers {
        *x = x.div_exact(&content);
    }
    (integers, Rational::new(denominator, content))
}

/// The least common multiple of the denominators.
pub(super) fn common_denominator<'a>(entries: impl IntoIterator<Item = &'a Rational>) -> Int {
    entries.into_iter().fold(Int::ONE, |common, q| match q.denom() {
        denominator if denominator.is_one() => common,
        denominator => common.lcm(denominator),
    })
}

/// Brings the rows to echelon form, pivot rows first. Returns the pivot columns, the last
/// pivot, and whether the number of row exchanges was odd.
fn eliminate(rows: &mut [Vec<Int>], limit: usize) -> (Vec<usize>, Int, bool) {
    let mut pivots = Vec::new();
    let mut previous = Int::ONE;
    let mut odd = false;
    for column in 0..limit {
        let done = pivots.len();
        // All candidates lead to entries of the same size; the shortest costs least now.
        let candidates = (done..rows.len()).filter(|&i| !rows[i][column].is_zero());
        let Some(chosen) = candidates.min_by_key(|&i| rows[i][column].bits()) else { continue };
        if chosen != done {
            rows.swap(chosen, done);
            odd = !odd;
        }
        let (above, below) = rows.split_at_mut(done + 1);
        let pivot_row = &above[done];
        let pivot = &pivot_row[column];
        for row in below {
            let factor = std::mem::replace(&mut row[column], Int::ZERO);
            let words = ((pivot.bits() + factor.bits()) / 512).min(1 << 20) as u32;
            for (x, y) in row.iter_mut().zip(pivot_row).skip(column + 1) {
                if x.is_zero() && (factor.is_zero() || y.is_zero()) {
                    continue;
                }
                budget::steps(1 + words);
                let mut minor = pivot * &*x;
                if !factor.is_zero() && !y.is_zero() {
                    minor -= &factor * y;
                }
                *x = minor.div_exact(&previous);
            }
        }
        previous = pivot.clone();
        pivots.push(column);
    }
    (pivots, previous, odd)
}
