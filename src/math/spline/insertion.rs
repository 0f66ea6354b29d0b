//! Inserting knots, and removing them where that is exact.
//!
//! A new knot t in [t_j, t_{j+1}) changes n control points only:
//! d'_i = (1 − α_i) d_{i−1} + α_i d_i, α_i = (t − t_i)/(t_{i+n} − t_i), j − n < i ≤ j (Boehm).
//! Removing solves these equations from the left; the last one says whether it is possible.
//!
//! References: W. Boehm, "Inserting new knots into B-spline curves", CAD 12 (1980); E. Cohen,
//! T. Lyche, R. Riesenfeld, "Discrete B-splines and subdivision techniques" (1980; the Oslo
//! algorithm), here by blossoms.

use super::{BSpline, KnotVector, SplineError};
use crate::budget;
use crate::math::blossom::Argument;
use crate::math::curve::{Point, Vector, lerp};
use crate::math::number::{Int, Rational};
use crate::math::ring::Field;

/// Why a knot cannot be removed: the derivative that jumps there.
#[derive(Clone, PartialEq)]
pub struct Defect<C> {
    /// The order of the derivative that has to be continuous.
    pub order: usize,
    /// Its value after the knot minus that before.
    pub jump: Vector<C>,
}

debug_by_fields!(Defect: order, jump);

/// (t − t_i)/(t_{i+n} − t_i), for an interval that is not empty.
fn ratio<C: Field>(knots: &[C], n: usize, i: usize, t: &C) -> C {
    let unit = knots[i + n].minus(&knots[i]).inverse().expect("the interval contains the span");
    t.minus(&knots[i]).times(&unit)
}

impl<C: Field> KnotVector<C> {
    /// (t − t_i)/(t_{i+n} − t_i) for the n control points i = j−n+1, …, j that a new knot changes in
    /// the interval [t_j, t_{j+1}].
    ///
    /// # Errors
    /// [`SplineError::NoDomain`] unless j is one of [`KnotVector::spans`].
    pub fn insertion_ratios(&self, span: usize, t: &C) -> Result<Vec<(usize, C)>, SplineError> {
        let n = self.degree();
        if !self.spans().contains(&span) {
            return Err(SplineError::NoDomain);
        }
        Ok((span + 1 - n..=span).map(|i| (i, ratio(self.knots(), n, i, t))).collect())
    }
}

impl<C: Field> BSpline<C> {
    /// The ratios of [`KnotVector::insertion_ratios`] on the interval of t.
    ///
    /// # Errors
    /// As [`KnotVector::span_of`].
    pub fn insertion_ratios(&self, t: &C) -> Result<Vec<(usize, C)>, SplineError> {
        self.knots().insertion_ratios(self.knots().span_of(t)?, t)
    }

    /// The same curve with one more knot. Cost: n affine combinations, after finding the place.
    ///
    /// # Errors
    /// As [`KnotVector::span_of`]; [`SplineError::Multiplicity`] for a knot that is there n + 1 times.
    ///
    /// ```
    /// use polarform::interval::Interval;
    /// use polarform::number::{integer as z, rational as q};
    /// use polarform::spline::{BSpline, KnotVector};
    /// let knots = KnotVector::clamped(1, &[], &Interval::unit())?;
    /// let s = BSpline::new(knots, vec![vec![z(0)], vec![z(4)]])?.insert(&q(1, 4))?;
    /// assert_eq!(s.points(), [[z(0)], [z(1)], [z(4)]]);
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn insert(&self, t: &C) -> Result<Self, SplineError> {
        self.insert_on(self.knots().span_of(t)?, t)
    }

    /// The same with the knot interval named, for knots whose order only the caller knows.
    ///
    /// # Errors
    /// [`SplineError::NoDomain`] unless span is one of [`KnotVector::spans`], and as
    /// [`BSpline::insert`].
    pub fn insert_on(&self, span: usize, t: &C) -> Result<Self, SplineError> {
        let n = self.degree();
        let ratios = self.knots().insertion_ratios(span, t)?;
        let mut points = Vec::with_capacity(self.points().len() + 1);
        points.extend_from_slice(&self.points()[..=span - n]);
        for (i, ratio) in &ratios {
            points.push(lerp(&self.points()[i - 1], &self.points()[*i], ratio));
        }
        points.extend_from_slice(&self.points()[span..]);
        let mut knots = self.knots().knots().to_vec();
        knots.insert(span + 1, t.clone());
        let knots = KnotVector::new(n, knots)?;
        BSpline::new(knots, points)
    }

    /// The same curve with all these knots added, one for each time it is named (Boehm's way).
    ///
    /// Cost: n affine combinations and O(log m) comparisons for each knot.
    ///
    /// # Errors
    /// As [`BSpline::insert`].
    pub fn insert_all(&self, more: &[C]) -> Result<Self, SplineError> {
        budget::charge_terms(more.len() as u64);
        let n = self.degree();
        let mut knots = self.knots().knots().to_vec();
        let mut points = self.points().to_vec();
        for t in more {
            budget::step();
            let count = points.len();
            let span = n + place(&knots[n..=count], t)?;
            let fresh: Vec<Point<C>> = (span + 1 - n..=span)
                .map(|i| lerp(&points[i - 1], &points[i], &ratio(&knots, n, i, t)))
                .collect();
            if n == 0 {
                points.insert(span, points[span].clone());
            } else {
                points.splice(span + 1 - n..span, fresh);
            }
            knots.insert(span + 1, t.clone());
        }
        BSpline::new(KnotVector::new(n, knots)?, points)
    }

    /// The same curve over finer knots: d'_i = f_j(τ_{i+1}, …, τ_{i+n}), each from the polar form
    /// of a piece in its support (the Oslo algorithm, by blossoms). Equal to [`BSpline::insert_all`]
    /// where the outer knots stay; outside of the domain the new knots may be any.
    ///
    /// Cost: for each control point a polar value, n²/2 affine combinations.
    ///
    /// # Errors
    /// [`SplineError::Domains`] for another domain, [`SplineError::MissingKnot`] if an inner knot is
    /// not there, or not as often.
    ///
    /// ```
    /// use polarform::number::{integer as z, rational as q};
    /// use polarform::spline::{BSpline, KnotVector};
    /// // uniform knots halved: Chaikin's corner cutting
    /// let knots = KnotVector::uniform(2, 3, &z(-2), &z(1))?;
    /// let s = BSpline::new(knots, [0, 4, 0].map(|x| vec![z(x)]).to_vec())?;
    /// let fine = s.refine(s.halved_knots()?)?;
    /// assert_eq!(fine.knots().knots()[0], z(-1));
    /// assert_eq!(fine.points(), [[z(1)], [z(3)], [z(3)], [z(1)]]);
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn refine(&self, finer: KnotVector<C>) -> Result<Self, SplineError> {
        let n = self.degree();
        if finer.degree() != n {
            return Err(crate::math::curve::CurveError::Degrees { left: n, right: finer.degree() }.into());
        }
        if finer.interval()? != self.interval() {
            return Err(SplineError::Domains);
        }
        for (knot, multiplicity) in self.inner_knots() {
            if finer.multiplicity(&knot) < multiplicity {
                let place = self.knots().knots().iter().position(|other| *other == knot);
                return Err(SplineError::MissingKnot { index: place.unwrap_or(0) });
            }
        }
        self.relabelled(&finer, |span, label| {
            let arguments: Vec<Argument<C>> = label.iter().cloned().map(Argument::Point).collect();
            Ok(self.blossom(span, &arguments)?.into_point())
        })
    }

    /// The knots with the middle of each knot interval added, as many of them outside of the domain
    /// as there have to be: [`BSpline::refine`] then doubles a uniform spline (Chaikin for degree 2, Lane and
    /// Riesenfeld for every degree).
    ///
    /// # Errors
    /// None for a spline; those of [`KnotVector::new`] are passed on.
    pub fn halved_knots(&self) -> Result<KnotVector<C>, SplineError> {
        let knots = self.knots().knots();
        budget::charge_terms(2 * knots.len() as u64);
        let half = Rational::new(Int::ONE, Int::from(2usize));
        let mut finer = Vec::with_capacity(2 * knots.len());
        for pair in knots.windows(2) {
            finer.push(pair[0].clone());
            if pair[0] != pair[1] {
                finer.push(pair[0].plus(&pair[1]).scaled(&half));
            }
        }
        finer.push(knots[knots.len() - 1].clone());
        self.trimmed_to_domain(&finer, self.degree())
    }

    /// A spline over other knots from a rule for its control points: the value at a label of the
    /// polar form of the piece of `self` on a given span.
    pub(super) fn relabelled(
        &self,
        knots: &KnotVector<C>,
        rule: impl Fn(usize, &[C]) -> Result<Point<C>, SplineError>,
    ) -> Result<Self, SplineError> {
        let n = knots.degree();
        let spans = knots.spans();
        if spans.is_empty() || knots.interval()? != self.interval() {
            return Err(SplineError::Domains);
        }
        // Which piece of self each span of the new knots lies on.
        let mut old = Vec::with_capacity(spans.len());
        let mut current = self.knots().spans().into_iter().peekable();
        let mut at = current.next().ok_or(SplineError::NoDomain)?;
        for &span in &spans {
            if let Some(&next) = current.peek()
                && self.knots().knots()[next] == knots.knots()[span]
            {
                at = next;
                current.next();
            }
            old.push(at);
        }
        if current.peek().is_some() {
            return Err(SplineError::Domains);
        }
        let points = (0..knots.count()).map(|i| {
            budget::step();
            // The first span in the support [t_i, t_{i+n+1}] that belongs to the domain.
            let which = spans.iter().position(|&span| span >= i).filter(|&k| spans[k] <= i + n);
            // A control point without influence stays what it is, if it is there.
            if which.is_none()
                && n == self.degree()
                && let Some(same) =
                    (0..self.points().len()).find(|&k| self.knots().support(k) == knots.support(i))
            {
                return Ok(self.points()[same].clone());
            }
            let which = which.unwrap_or_else(|| if i < spans[0] { 0 } else { spans.len() - 1 });
            rule(old[which], knots.label(i))
        });
        let points: Result<Vec<_>, _> = points.collect();
        BSpline::new(knots.clone(), points?)
    }

    /// The same curve with the inner knot t removed `times` times, if that is exact.
    ///
    /// # Errors
    /// [`SplineError::NotAKnot`] if it does not occur so often inside of the domain; with
    /// `Ok(Err(defect))` the derivative whose jump is in the way.
    pub fn remove(&self, t: &C, times: usize) -> Result<Result<Self, Defect<C>>, SplineError> {
        let (start, end) = self.interval().ends();
        let multiplicity = if t == start || t == end { 0 } else { self.knots().multiplicity(t) };
        if multiplicity < times || multiplicity == 0 {
            return Err(SplineError::NotAKnot { multiplicity, times });
        }
        let mut spline = self.clone();
        for _ in 0..times {
            match spline.remove_one(t)? {
                Ok(next) => spline = next,
                Err(defect) => return Ok(Err(defect)),
            }
        }
        Ok(Ok(spline))
    }

    fn remove_one(&self, t: &C) -> Result<Result<Self, Defect<C>>, SplineError> {
        let n = self.degree();
        let mut knots = self.knots().knots().to_vec();
        let last = knots.iter().rposition(|knot| knot == t).expect("t is a knot");
        let left = knots.iter().filter(|knot| *knot == t).count() - 1;
        knots.remove(last);
        // In the coarser knots t lies in [t_j, t_{j+1}) and is there `left` times.
        let j = last - 1;
        let old = self.points();
        let mut points = old[..=j - n].to_vec();
        for (i, point) in old.iter().enumerate().take(j - left + 1).skip(j + 1 - n) {
            let ratio = ratio(&knots, n, i, t);
            let inverse = ratio.inverse().expect("t_i is smaller than t");
            // d_i = (1 − ratio) d'_{i−1} + ratio d'_i, solved for d'_i
            points.push(lerp(&points[points.len() - 1], point, &inverse));
        }
        let expected = &old[j - left + 1];
        // With multiplicity n + 1 nothing ties the two sides together.
        let computed = if left >= n { &old[j - left] } else { &points[points.len() - 1] };
        if computed != expected {
            return Ok(Err(self.defect(t, n - left.min(n))));
        }
        if left >= n {
            points.truncate(j - left + 1);
        }
        points.extend_from_slice(&old[j - left + 2..]);
        Ok(Ok(BSpline::new(KnotVector::new(n, knots)?, points)?))
    }

    /// The jump of the derivative of an order at an inner knot.
    fn defect(&self, t: &C, order: usize) -> Defect<C> {
        let pieces = self.bezier_pieces();
        let after = pieces.iter().position(|piece| piece.interval().start() == t).expect("an inner knot");
        let value = |k: usize| pieces[k].nth_derivative(order).value(t);
        Defect { order, jump: value(after) - value(after - 1) }
    }
}

/// The interval of sorted knots that holds t, by bisection where all comparisons are possible.
fn place<C: Field>(knots: &[C], t: &C) -> Result<usize, SplineError> {
    use crate::math::ring::compare;
    use std::cmp::Ordering;
    let (mut low, mut high) = (0, knots.len() - 1);
    if compare(&knots[low], t).is_none_or(|order| order == Ordering::Greater)
        || compare(&knots[high], t) != Some(Ordering::Greater)
    {
        return Ok(crate::math::piecewise::interval_of(knots, t)?);
    }
    while high - low > 1 {
        let middle = usize::midpoint(low, high);
        match compare(&knots[middle], t) {
            Some(Ordering::Greater) => high = middle,
            Some(_) => low = middle,
            None => return Ok(crate::math::piecewise::interval_of(knots, t)?),
        }
    }
    Ok(low)
}
