//! Sums of splines.

use std::cmp::Ordering;

use super::{BSpline, KnotVector, SplineError};
use crate::math::curve::CurveError;
use crate::math::ring::Field;
use crate::math::ring::compare;

impl<C: Field> BSpline<C> {
    /// The sum of two splines over one domain, of the larger degree. Over the same knots the control
    /// points are added; else both are refined to the knots of both, each as often as the one
    /// needs it that has it more often, the ends clamped.
    ///
    /// Cost: an elevation and a refinement of each.
    ///
    /// # Errors
    /// [`SplineError::Domains`], [`SplineError::Unordered`] if the order of the knots of both is
    /// not known, and different dimensions.
    ///
    /// ```
    /// use polarform::interval::Interval;
    /// use polarform::number::integer as z;
    /// use polarform::spline::{BSpline, KnotVector};
    /// let over = |inner: &[i64], points: &[i64]| {
    ///     let inner: Vec<_> = inner.iter().map(|&knot| z(knot)).collect();
    ///     let points = points.iter().map(|&x| vec![z(x)]).collect();
    ///     BSpline::new(KnotVector::clamped(1, &inner, &Interval::new(z(0), z(6))?)?, points)
    /// };
    /// let sum = over(&[2], &[0, 2, 2])?.sum(&over(&[3], &[0, 3, 0])?)?;
    /// assert_eq!(sum.points(), [[z(0)], [z(4)], [z(5)], [z(2)]]);
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn sum(&self, other: &Self) -> Result<Self, SplineError> {
        if self.dimension() != other.dimension() {
            let (left, right) = (self.dimension(), other.dimension());
            return Err(CurveError::DimensionsOf { left, right }.into());
        }
        let add = |a: &Self, b: &Self| {
            let points = a.points().iter().zip(b.points()).map(|(p, q)| p + &q.position()).collect();
            BSpline::new(a.knots().clone(), points)
        };
        let (left, right) = self.in_common(other)?;
        add(&left, &right)
    }

    /// Both splines over the same knots and of the larger degree, each knot as often as the one needs it that has it more often, the ends
    /// clamped; as they are if they have the same knots.
    ///
    /// Cost: an elevation and a refinement of each.
    ///
    /// # Errors
    /// [`SplineError::Domains`], [`SplineError::Unordered`] if the order of the knots of both is not known.
    pub fn in_common(&self, other: &Self) -> Result<(Self, Self), SplineError> {
        if self.knots() == other.knots() {
            return Ok((self.clone(), other.clone()));
        }
        if self.interval() != other.interval() {
            return Err(SplineError::Domains);
        }
        let n = self.degree().max(other.degree());
        let (left, right) = (self.elevate(n - self.degree())?, other.elevate(n - other.degree())?);
        let inner = merged(left.inner_knots(), right.inner_knots())?;
        let knots = KnotVector::clamped(n, &inner, self.interval())?;
        Ok((left.refine(knots.clone())?, right.refine(knots)?))
    }
}

/// The knots of both lists in increasing order, each with the larger of its multiplicities.
fn merged<C: Field>(left: Vec<(C, usize)>, right: Vec<(C, usize)>) -> Result<Vec<C>, SplineError> {
    let (mut left, mut right) = (left.into_iter().peekable(), right.into_iter().peekable());
    let mut knots = Vec::new();
    loop {
        let (knot, times) = match (left.peek(), right.peek()) {
            (None, None) => return Ok(knots),
            (Some(_), None) => left.next(),
            (None, Some(_)) => right.next(),
            (Some((a, s)), Some((b, r))) => match compare(a, b) {
                Some(Ordering::Less) => left.next(),
                Some(Ordering::Greater) => right.next(),
                Some(Ordering::Equal) => {
                    let both = (a.clone(), *s.max(r));
                    left.next();
                    right.next();
                    Some(both)
                }
                None => return Err(SplineError::Unordered),
            },
        }
        .expect("one of them was there");
        knots.extend(std::iter::repeat_n(knot, times));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::interval::Interval;
    use crate::math::number::{Rational, integer as z, rational as q};
    use crate::math::spline::tests::any_spline;
    use proptest::prelude::*;

    /// A spline moved to the domain [0, 1], clamped or not.
    fn over_unit(s: &BSpline<Rational>) -> BSpline<Rational> {
        let (a, b) = s.interval().ends();
        let moved = |x: &Rational| (x - a) / (b - a);
        let knots = s.knots().knots().iter().map(moved).collect();
        BSpline::new(KnotVector::new(s.degree(), knots).unwrap(), s.points().to_vec()).unwrap()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(96))]

        #[test]
        fn values_add(f in any_spline(), g in any_spline()) {
            let (f, g) = (over_unit(&f), over_unit(&g));
            match f.sum(&g) {
                Ok(sum) => {
                    prop_assert_eq!(sum.degree(), f.degree().max(g.degree()));
                    for k in 0..=12 {
                        let t = q(k, 12);
                        let expected = &f.value(&t).unwrap() + &g.value(&t).unwrap().position();
                        prop_assert_eq!(sum.value(&t).unwrap(), expected, "at {}", t);
                    }
                    prop_assert_eq!(g.sum(&f), Ok(sum));
                }
                Err(error) => {
                    prop_assert!(f.dimension() != g.dimension(), "{error}");
                }
            }
        }

        #[test]
        fn halved_knots_keep_the_curve(s in any_spline()) {
            let fine = s.refine(s.halved_knots().unwrap()).unwrap();
            prop_assert_eq!(fine.interval(), s.interval());
            prop_assert_eq!(fine.knots().spans().len(), 2 * s.knots().spans().len());
            let (a, b) = s.interval().ends();
            for k in 0..=12 {
                let t = a + (b - a) * q(k, 12);
                prop_assert_eq!(fine.value(&t).unwrap(), s.value(&t).unwrap());
            }
        }
    }

    #[test]
    fn outer_knots_may_differ_when_refining() {
        let s = BSpline::new(
            KnotVector::uniform(2, 4, &z(0), &z(1)).unwrap(),
            [1, 3, 2, 4].map(|x| vec![z(x)]).to_vec(),
        )
        .unwrap();
        let clamped =
            s.refine(KnotVector::clamped(2, &[z(3)], &Interval::new(z(2), z(4)).unwrap()).unwrap()).unwrap();
        assert_eq!(clamped.points(), [[z(2)], [z(3)], [z(2)], [z(3)]]);
        let smaller = KnotVector::clamped(2, &[], &Interval::new(z(2), z(3)).unwrap()).unwrap();
        assert_eq!(s.refine(smaller), Err(SplineError::Domains));
        let without = KnotVector::clamped(2, &[], &Interval::new(z(2), z(4)).unwrap()).unwrap();
        assert_eq!(s.refine(without), Err(SplineError::MissingKnot { index: 3 }));
    }

    #[test]
    fn sums_that_cannot_be() {
        let spline = |a: i64, b: i64, points: Vec<Vec<Rational>>| {
            BSpline::new(KnotVector::clamped(1, &[], &Interval::new(z(a), z(b)).unwrap()).unwrap(), points)
                .unwrap()
        };
        let line = spline(0, 1, vec![vec![z(0)], vec![z(1)]]);
        assert_eq!(line.sum(&spline(0, 2, vec![vec![z(0)], vec![z(1)]])), Err(SplineError::Domains));
        let plane = spline(0, 1, vec![vec![z(0); 2], vec![z(1); 2]]);
        assert_eq!(line.sum(&plane), Err(CurveError::DimensionsOf { left: 1, right: 2 }.into()));
    }
}
