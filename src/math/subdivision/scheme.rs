//! Masks, their symbols and matrices, and steps of subdivision.

use nalgebra::DMatrix;

use super::SubdivisionError;
use crate::budget;
use crate::math::curve::Point;
use crate::math::number::{Int, Rational, binomial_row};
use crate::math::poly::Coefficients;
use crate::math::ring::Field;

/// A binary subdivision scheme by its mask a_first, …, a_last; the first and the last are not 0.
///
/// ```
/// use polarform::number::integer as z;
/// use polarform::subdivision::Scheme;
/// let chaikin = Scheme::lane_riesenfeld(2);
/// let square = [[0, 0], [4, 0], [4, 4], [0, 4]].map(|p| p.map(z).into());
/// let finer = chaikin.refine(&square, true)?;
/// assert_eq!(finer[..3], [[0, 1].map(z), [1, 0].map(z), [3, 0].map(z)]);
/// # Ok::<(), polarform::subdivision::SubdivisionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Scheme<C> {
    mask: Vec<C>,
    first: i64,
}

impl<C: Field> Scheme<C> {
    /// The scheme with the mask a_first, a_{first+1}, …; zeros at its ends are dropped.
    ///
    /// # Errors
    /// [`SubdivisionError::EmptyMask`] if all are 0.
    pub fn new(mask: Vec<C>, first: i64) -> Result<Self, SubdivisionError> {
        let zeros = mask.iter().take_while(|a| a.is_zero()).count();
        let mask = Coefficients::new(mask.into_iter().skip(zeros).collect()).into_vec();
        if mask.is_empty() {
            return Err(SubdivisionError::EmptyMask);
        }
        Ok(Scheme { mask, first: first + zeros as i64 })
    }

    /// The scheme of Lane and Riesenfeld, a(z) = (1 + z)^{n+1}/2^n up to a shift: uniform B-splines of degree n.
    /// Chaikin's corner cutting for n = 2.
    pub fn lane_riesenfeld(n: usize) -> Self {
        budget::charge_bits(n as u64);
        let share = Rational::new(Int::ONE, Int::from(2usize).pow(n as u32));
        let row = binomial_row(n + 1).into_iter();
        let mask = row.map(|b| C::from_rational(&(Rational::from_integer(b) * &share))).collect();
        Scheme { mask, first: -(n.div_ceil(2) as i64) }
    }

    /// The interpolatory four-point scheme with tension w: p'_{2j+1} = (1/2 + w)(p_j + p_{j+1}) − w (p_{j−1} + p_{j+2}).
    /// It reproduces cubics for w = 1/16.
    ///
    /// N. Dyn, D. Levin, J. A. Gregory, "A 4-point interpolatory subdivision scheme for curve design", CAGD 4 (1987).
    pub fn four_point(w: &C) -> Self {
        let inner = C::from_rational(&Rational::new(Int::ONE, Int::from(2usize))).plus(w);
        let outer = -w.clone();
        let zero = C::zero();
        let mask = vec![outer.clone(), zero.clone(), inner.clone(), C::one(), inner, zero, outer];
        Scheme::new(mask, -3).expect("a_0 is 1")
    }

    /// Corner cutting: each edge p_j p_{j+1} keeps its part from (1 − λ) p_j + λ p_{j+1} to
    /// μ p_j + (1 − μ) p_{j+1}. Chaikin for λ = μ = 1/4, de Rham's trisection for 1/3.
    pub fn corner_cutting(lambda: &C, mu: &C) -> Self {
        let rest = |x: &C| C::one().minus(x);
        Scheme::new(vec![lambda.clone(), rest(mu), rest(lambda), mu.clone()], -2).expect("their sum is 2")
    }

    /// a_first, …, a_last
    pub fn mask(&self) -> &[C] {
        &self.mask
    }

    /// The index of the first coefficient.
    pub fn first(&self) -> i64 {
        self.first
    }

    /// The index of the last coefficient.
    pub fn last(&self) -> i64 {
        self.first + self.mask.len() as i64 - 1
    }

    /// a_k, 0 outside of the mask.
    pub fn coefficient(&self, k: i64) -> C {
        let place = usize::try_from(k - self.first).ok();
        place.and_then(|k| self.mask.get(k)).cloned().unwrap_or_else(C::zero)
    }

    /// z^{−first} a(z), a polynomial with a constant term.
    pub fn symbol(&self) -> Coefficients<C> {
        Coefficients::new(self.mask.clone())
    }

    /// The order of the sum rules: the largest k for which (1 + z)^k divides the symbol.
    ///
    /// ```
    /// use polarform::number::rational as q;
    /// use polarform::subdivision::Scheme;
    /// assert_eq!(Scheme::four_point(&q(1, 16)).sum_rules(), 4);
    /// assert_eq!(Scheme::four_point(&q(1, 8)).sum_rules(), 2);
    /// ```
    pub fn sum_rules(&self) -> usize {
        let (mut rest, minus_one) = (self.symbol(), -C::one());
        let mut order = 0;
        loop {
            let (quotient, remainder) = rest.divided_by_root(&minus_one);
            if !remainder.is_zero() {
                return order;
            }
            (rest, order) = (quotient, order + 1);
        }
    }

    /// The polynomial z^{−first} a(z)/(1 + z)^k; `None` if that is none.
    pub fn divided(&self, k: usize) -> Option<Coefficients<C>> {
        let minus_one = -C::one();
        (0..k).try_fold(self.symbol(), |rest, _| {
            let (quotient, remainder) = rest.divided_by_root(&minus_one);
            remainder.is_zero().then_some(quotient)
        })
    }

    /// The numbers i of the new points of an open polygon of m points: those for which the mask needs no
    /// points before the first or after the last one. Empty for too few points.
    fn open(&self, m: usize) -> std::ops::Range<i64> {
        self.last() - 1..2 * m as i64 + self.first
    }

    /// The rows of the subdivision matrix: for each new point the old ones with their weights.
    fn rows(&self, m: usize, closed: bool) -> Result<Vec<Vec<(usize, C)>>, SubdivisionError> {
        // 2m − (last − first) + 1 new points
        let needed = if closed { 1 } else { (self.mask.len() - 1).div_ceil(2).max(1) };
        if m < needed {
            return Err(SubdivisionError::TooFewPoints { needed, given: m });
        }
        budget::charge_terms((m as u64).saturating_mul(self.mask.len() as u64));
        let numbers = if closed { 0..2 * m as i64 } else { self.open(m) };
        let row = |i: i64| {
            let (from, to) = ((i - self.last() + 1).div_euclid(2), (i - self.first).div_euclid(2));
            let mut row: Vec<(usize, C)> = Vec::new();
            for j in from..=to {
                budget::step();
                let (place, weight) = (j.rem_euclid(m as i64) as usize, self.coefficient(i - 2 * j));
                match row.iter_mut().find(|(known, _)| *known == place) {
                    Some((_, sum)) => *sum += weight,
                    None => row.push((place, weight)),
                }
            }
            row
        };
        Ok(numbers.map(row).collect())
    }

    /// One step: 2m points of a closed polygon of m, or the 2m + 1 − (last − first) of an open one that the
    /// mask determines.
    ///
    /// Cost: for each new point as many products as half of the mask is long.
    ///
    /// # Errors
    /// [`SubdivisionError::TooFewPoints`], [`SubdivisionError::Dimensions`].
    pub fn refine(&self, points: &[Point<C>], closed: bool) -> Result<Vec<Point<C>>, SubdivisionError> {
        let size = points.first().map_or(0, |point| point.len());
        if let Some(index) = points.iter().position(|point| point.len() != size) {
            return Err(SubdivisionError::Dimensions { index });
        }
        let rows = self.rows(points.len(), closed)?;
        let value = |row: &Vec<(usize, C)>| -> Point<C> {
            (0..size)
                .map(|k| row.iter().fold(C::zero(), |sum, (j, w)| sum.plus(&w.times(&points[*j][k]))))
                .collect()
        };
        Ok(rows.iter().map(value).collect())
    }

    /// Several steps.
    ///
    /// # Errors
    /// As [`Scheme::refine`].
    pub fn refine_often(
        &self,
        points: &[Point<C>],
        closed: bool,
        steps: usize,
    ) -> Result<Vec<Point<C>>, SubdivisionError> {
        (0..steps).try_fold(points.to_vec(), |points, _| self.refine(&points, closed))
    }

    /// The matrix of a step for m points; its entry in row i and column j is a_{i−2j}.
    ///
    /// # Errors
    /// [`SubdivisionError::TooFewPoints`].
    pub fn matrix(&self, m: usize, closed: bool) -> Result<DMatrix<C>, SubdivisionError> {
        let rows = self.rows(m, closed)?;
        budget::charge_terms((rows.len() as u64).saturating_mul(m as u64));
        let mut matrix = DMatrix::zeros(rows.len(), m);
        for (i, row) in rows.into_iter().enumerate() {
            for (j, weight) in row {
                matrix[(i, j)] += weight;
            }
        }
        Ok(matrix)
    }

    /// The square matrix of a_{i−2j} for −last < i, j < −first: the points around p_0 that matter there, and
    /// the new ones in their places. Its eigenvalues decide how the limits behave at the points of the
    /// polygon. Empty for masks of one or two coefficients.
    pub fn local_matrix(&self) -> DMatrix<C> {
        let size = (self.mask.len() as i64 - 2).max(0);
        budget::charge_terms((size * size) as u64);
        let at = |i: usize| i as i64 + 1 - self.last();
        DMatrix::from_fn(size as usize, size as usize, |i, j| self.coefficient(at(i) - 2 * at(j)))
    }
}
