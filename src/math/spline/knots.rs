//! Knot vectors.

use std::cmp::Ordering;

use super::SplineError;
use crate::math::interval::Interval;
use crate::math::number::{Int, Rational};
use crate::math::ring::{Field, compare};

/// Knots t_0 ≤ … ≤ t_{m+n} for basis functions of degree n: m = (number of knots) − n − 1 of them.
#[derive(Clone, PartialEq)]
pub struct KnotVector<C> {
    degree: usize,
    pub(super) knots: Vec<C>,
    /// [t_n, t_m], if the basis functions sum to 1 somewhere.
    interval: Option<Interval<C>>,
}

impl<C: Field> KnotVector<C> {
    /// The knot vector with these knots.
    ///
    /// # Errors
    /// [`SplineError::TooFewKnots`] for fewer than n + 2, [`SplineError::DecreasingKnots`],
    /// [`SplineError::Multiplicity`] for one repeated more than n + 1 times.
    ///
    /// ```
    /// use polarform::number::integer as z;
    /// use polarform::spline::KnotVector;
    /// let knots = KnotVector::new(2, [0, 0, 0, 1, 2, 2, 2].map(z).to_vec())?;
    /// assert_eq!(knots.count(), 4);
    /// assert_eq!(knots.label(1), [z(0), z(1)]);
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn new(degree: usize, knots: Vec<C>) -> Result<Self, SplineError> {
        if knots.len() < degree.saturating_add(2) {
            let needed = degree.saturating_add(2);
            return Err(SplineError::TooFewKnots { degree, needed, given: knots.len() });
        }
        if let Some(i) = knots.windows(2).position(|pair| compare(&pair[1], &pair[0]) == Some(Ordering::Less))
        {
            return Err(SplineError::DecreasingKnots { index: i + 1 });
        }
        let mut start = 0;
        for run in knots.chunk_by(|x, y| x == y) {
            if run.len() > degree + 1 {
                return Err(SplineError::Multiplicity {
                    index: start,
                    found: run.len(),
                    allowed: degree + 1,
                });
            }
            start += run.len();
        }
        let last = knots.len() - degree - 1;
        let full = (last > degree).then(|| Interval::new(knots[degree].clone(), knots[last].clone()).ok());
        Ok(KnotVector { degree, knots, interval: full.flatten() })
    }

    /// The knots a, a + h, a + 2h, … for `count` basis functions.
    ///
    /// # Errors
    /// As [`KnotVector::new`].
    pub fn uniform(degree: usize, count: usize, a: &C, h: &C) -> Result<Self, SplineError> {
        crate::budget::charge_terms((count as u64).saturating_add(degree as u64).saturating_add(1));
        let knot = |i: usize| a.plus(&h.scaled(&Rational::from_integer(Int::from(i))));
        KnotVector::new(degree, (0..count + degree + 1).map(knot).collect())
    }

    /// The ends of the interval, each n + 1 times, and between them the inner knots.
    ///
    /// # Errors
    /// As [`KnotVector::new`].
    pub fn clamped(degree: usize, inner: &[C], interval: &Interval<C>) -> Result<Self, SplineError> {
        let (a, b) = interval.ends();
        crate::budget::charge_terms((degree as u64).saturating_mul(2));
        let mut knots = vec![a.clone(); degree + 1];
        knots.extend_from_slice(inner);
        knots.extend(vec![b.clone(); degree + 1]);
        KnotVector::new(degree, knots)
    }

    /// The degree n.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// All knots.
    pub fn knots(&self) -> &[C] {
        &self.knots
    }

    /// The number m of basis functions.
    pub fn count(&self) -> usize {
        self.knots.len() - self.degree - 1
    }

    /// t_{i+1}, …, t_{i+n}: the arguments of the polar form that give control point i.
    ///
    /// # Panics
    /// If i is not less than the number of basis functions.
    pub fn label(&self, i: usize) -> &[C] {
        &self.knots[i + 1..i + 1 + self.degree]
    }

    /// t_i, …, t_{i+n+1}: the knots of basis function i.
    ///
    /// # Panics
    /// As [`KnotVector::label`].
    pub fn support(&self, i: usize) -> &[C] {
        &self.knots[i..=i + self.degree + 1]
    }

    /// The Greville abscissa (t_{i+1} + … + t_{i+n})/n: the control points over them are those of
    /// the function F(t) = t. For degree 0 the middle of the interval.
    ///
    /// # Panics
    /// As [`KnotVector::label`].
    pub fn greville(&self, i: usize) -> C {
        let label = if self.degree == 0 { &self.knots[i..i + 2] } else { self.label(i) };
        let sum = label.iter().fold(C::zero(), |sum, knot| sum.plus(knot));
        sum.scaled(&Rational::new(Int::ONE, Int::from(label.len())))
    }

    /// The distinct knots with their multiplicities.
    pub fn multiplicities(&self) -> Vec<(C, usize)> {
        self.knots.chunk_by(|x, y| x == y).map(|run| (run[0].clone(), run.len())).collect()
    }

    /// How often a parameter occurs among the knots.
    pub fn multiplicity(&self, t: &C) -> usize {
        self.knots.iter().filter(|knot| *knot == t).count()
    }

    /// The interval [t_n, t_m] on which the basis functions sum to 1: the domain of splines.
    ///
    /// # Errors
    /// [`SplineError::NoDomain`] if there are fewer than n + 1 basis functions or the ends are equal.
    pub fn interval(&self) -> Result<&Interval<C>, SplineError> {
        self.interval.as_ref().ok_or(SplineError::NoDomain)
    }

    /// The numbers j of the intervals [t_j, t_{j+1}] of the domain that are not empty.
    pub fn spans(&self) -> Vec<usize> {
        (self.degree..self.count()).filter(|&j| self.knots[j] != self.knots[j + 1]).collect()
    }

    /// The number j of the interval of the domain with t_j ≤ t < t_{j+1}; the end of the domain
    /// belongs to the last one. Cost: O(log) comparisons where all are possible.
    ///
    /// # Errors
    /// [`SplineError::NoDomain`], [`SplineError::OutsideDomain`], [`SplineError::Unordered`].
    pub fn span_of(&self, t: &C) -> Result<usize, SplineError> {
        self.interval()?;
        let inner = &self.knots[self.degree..=self.count()];
        Ok(self.degree + crate::math::piecewise::interval_of(inner, t)?)
    }
}
