//! A spline among other curves: its parts, what it shares with Bézier curves.

use super::{BSpline, KnotVector, SplineError};
use crate::math::blossom::Argument;
use crate::math::curve::{Curve, CurveError, Interval, Point, PolarValue};
use crate::math::ring::Field;

impl<C: Field> BSpline<C> {
    /// The parts before and after t, by inserting t until its multiplicity is n + 1.
    ///
    /// # Errors
    /// [`CurveError::EmptyInterval`] if t is an end of the interval, and as [`KnotVector::span_of`].
    ///
    /// ```
    /// use polarform::interval::Interval;
    /// use polarform::number::integer as z;
    /// use polarform::spline::{BSpline, KnotVector};
    /// let knots = KnotVector::clamped(1, &[z(1)], &Interval::new(z(0), z(2))?)?;
    /// let s = BSpline::new(knots, vec![vec![z(0)], vec![z(4)], vec![z(0)]])?;
    /// let (left, right) = s.subdivide(&z(1))?;
    /// assert_eq!(left.points(), [[z(0)], [z(4)]]);
    /// assert_eq!(right.interval(), &Interval::new(z(1), z(2))?);
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn subdivide(&self, t: &C) -> Result<(Self, Self), SplineError> {
        let (a, b) = self.interval().ends();
        if t == a || t == b {
            return Err(CurveError::EmptyInterval.into());
        }
        let n = self.degree();
        let missing = (n + 1).saturating_sub(self.knots().multiplicity(t));
        let whole = self.insert_all(&vec![t.clone(); missing])?;
        let (knots, points) = (whole.knots().knots(), whole.points());
        let at = knots.iter().position(|knot| knot == t).ok_or(SplineError::OutsideDomain)?;
        let part = |knots: &[C], points: &[Point<C>]| {
            BSpline::new(KnotVector::new(n, knots.to_vec())?, points.to_vec())
        };
        Ok((part(&knots[..at + n + 1], &points[..at])?, part(&knots[at..], &points[at..])?))
    }

    /// The part over [r, s] inside of its own interval, r before s.
    ///
    /// # Errors
    /// As [`BSpline::subdivide`] for parameters that are not ends.
    pub fn part(&self, interval: Interval<C>) -> Result<Self, SplineError> {
        let ((a, b), (r, s)) = (self.interval().ends(), interval.ends());
        let from = if r == a { self.clone() } else { self.subdivide(r)?.1 };
        if s == b { Ok(from) } else { Ok(from.subdivide(s)?.0) }
    }
}

impl<C: Field> Curve<C> for BSpline<C> {
    type Error = SplineError;
    fn degree(&self) -> usize {
        self.degree()
    }
    fn dimension(&self) -> usize {
        self.dimension()
    }
    fn interval(&self) -> &Interval<C> {
        self.interval()
    }
    fn value(&self, t: &C) -> Result<Point<C>, SplineError> {
        self.value(t)
    }
    fn blossom(&self, t: &C, arguments: &[Argument<C>]) -> Result<PolarValue<C>, SplineError> {
        self.blossom(self.knots().span_of(t)?, arguments)
    }
    fn derivative(&self) -> Result<Self, SplineError> {
        self.derivative()
    }
    fn elevate(&self, by: usize) -> Result<Self, SplineError> {
        self.elevate(by)
    }
    fn subdivide(&self, t: &C) -> Result<(Self, Self), SplineError> {
        self.subdivide(t)
    }
    fn part(&self, interval: Interval<C>) -> Result<Self, SplineError> {
        self.part(interval)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{Rational, integer as z, rational as q};
    use crate::math::spline::RationalSpline;

    /// A cubic with a double knot at 2, unclamped at its start.
    fn cubic() -> BSpline<Rational> {
        let knots = [-2, -1, 0, 0, 1, 2, 2, 4, 4, 4, 4].map(z).to_vec();
        let points = [[0, 1], [2, 5], [3, -1], [4, 4], [6, 0], [7, 7], [8, 1]].map(|p| p.map(z).to_vec());
        BSpline::new(KnotVector::new(3, knots).unwrap(), points.to_vec()).unwrap()
    }

    #[test]
    fn parts_are_the_curve() {
        let s = cubic();
        for t in [q(1, 2), z(1), z(2), q(7, 2)] {
            let (left, right) = s.subdivide(&t).unwrap();
            assert_eq!((left.interval().ends(), right.interval().ends()), ((&z(0), &t), (&t, &z(4))));
            for k in 0..=16 {
                let x = q(k, 4);
                let half = if x < t { &left } else { &right };
                assert_eq!(half.value(&x).unwrap(), s.value(&x).unwrap(), "at {x}, cut at {t}");
            }
        }
        let part = s.part(Interval::new(q(1, 3), z(3)).unwrap()).unwrap();
        assert_eq!(part.interval().ends(), (&q(1, 3), &z(3)));
        assert_eq!(part.value(&z(2)).unwrap(), s.value(&z(2)).unwrap());
        let t = q(5, 2);
        let same = vec![Argument::Point(t.clone()); 3];
        assert_eq!(Curve::blossom(&s, &t, &same).unwrap(), Argument::Point(s.value(&t).unwrap()));
        assert_eq!(s.subdivide(&z(0)), Err(CurveError::EmptyInterval.into()));
        assert!(s.subdivide(&z(9)).is_err());
    }

    #[test]
    fn pieces_of_degree_0_are_cut_too() {
        let knots = KnotVector::new(0, [0, 1, 2].map(z).to_vec()).unwrap();
        let steps = BSpline::new(knots, vec![vec![z(5)], vec![z(6)]]).unwrap();
        let (left, right) = steps.subdivide(&q(1, 2)).unwrap();
        assert_eq!((left.points().len(), right.points().len()), (1, 2));
        assert_eq!(steps.subdivide(&z(1)).unwrap().1.points(), [[z(6)]]);
    }

    #[test]
    fn as_the_language_writes_it() {
        let knots = KnotVector::clamped(1, &[], &Interval::unit()).unwrap();
        let line = BSpline::new(knots, vec![vec![q(1, 2)], vec![z(3)]]).unwrap();
        assert_eq!(line.to_string(), "bspline(1, [0, 0, 1, 1], [1/2, 3])");
        let plane = [[0, 1], [2, 3]].map(|p| p.map(z)).to_vec();
        let rational = RationalSpline::new(line.knots().clone(), plane, vec![z(1), z(4)]).unwrap();
        assert_eq!(rational.to_string(), "bspline(1, [0, 0, 1, 1], [(0, 1), (2, 3)], weights=[1, 4])");
        let vectors = vec![vec![z(1), z(0)], vec![z(2), z(1)]];
        let infinite = BSpline::new(line.knots().clone(), vectors).unwrap();
        let infinite = RationalSpline::from_homogeneous(infinite).unwrap();
        assert_eq!(infinite.to_string(), "bspline(1, [0, 0, 1, 1], [[1, 0], [2, 1]], homogeneous=1)");
        assert_eq!(format!("{line:?}"), "BSpline(bspline(1, [0, 0, 1, 1], [1/2, 3]))");
    }
}
