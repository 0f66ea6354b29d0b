//! Bézier clipping: real roots by convex hulls.
//!
//! Over [l, u] the graph of F is the Bézier curve with the points (i/n, b_i), l + (u − l) i/n at i/n. It lies in their convex
//! hull, so all roots lie where the hull meets the axis. That interval is the next one; if less than a fifth is cut off, the
//! interval is halved instead. Near a simple root the width is squared with each step, about. New ends are rounded
//! outwards to sixteenths of the new width, which keeps them short and loses no root.
//!
//! T. W. Sederberg, T. Nishita, "Curve intersection using Bézier clipping", CAD 22 (1990).

use num_traits::{Signed, Zero};

use crate::budget;
use crate::math::interval::Interval;
use crate::math::number::{Int, Rational, integer, rational};
use crate::math::poly::Poly;

/// An interval that is looked at, and what became of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    /// The lower end.
    pub lower: Rational,
    /// The upper end.
    pub upper: Rational,
    /// The Bernstein coefficients over it.
    pub coefficients: Vec<Rational>,
    /// What became of it.
    pub outcome: ClipOutcome,
}

/// What becomes of an interval.
#[derive(Clone, Debug, PartialEq)]
pub enum ClipOutcome {
    /// The hull does not meet the axis: there is no root.
    Empty,
    /// The hull meets the axis in one point, an end of the interval, which is a root.
    Exact(Rational),
    /// One sign change, and the interval is short enough: one root.
    Root,
    /// The hull meets the axis between these numbers, to which the interval shrinks.
    Clipped(Rational, Rational),
    /// Too little is cut off: both halves follow.
    Halved(Rational),
}

impl Poly {
    /// Bézier clipping of the roots in an interval [a, b] of the square-free part, down to intervals that are not wider than `width`. Each
    /// interval stands before those that follow from it. Empty if a > b and for constants.
    ///
    /// Cost: n² operations on numbers for each interval.
    ///
    /// # Panics
    /// If the width is not positive.
    ///
    /// ```
    /// # use polarform::{interval::Interval, number::{integer, rational}, poly::{ClipOutcome, Poly}};
    /// let f = Poly::variable().pow(2) - Poly::from(2);
    /// let steps = f.clipping(&Interval::new(integer(0), integer(2))?, &rational(1, 100));
    /// // (0, -2), (1/2, -2), (1, 2): the hull meets the axis from 1/2 to 3/4, so for t from 1 to 3/2.
    /// assert_eq!(steps[0].outcome, ClipOutcome::Clipped(integer(1), rational(3, 2)));
    /// assert_eq!(steps.last().unwrap().outcome, ClipOutcome::Root);
    /// # Ok::<(), polarform::interval::EmptyInterval>(())
    /// ```
    pub fn clipping(&self, interval: &Interval<Rational>, width: &Rational) -> Vec<Clip> {
        let (a, b) = interval.ends();
        assert!(width.is_positive(), "an interval needs a positive width");
        // Not monic: what is simple stays as it is.
        let simple = self.div_exact(&self.gcd(&self.derivative())).unwrap_or_else(Poly::zero);
        let mut steps = Vec::new();
        if a > b || simple.degree().is_none_or(|n| n == 0) {
            return steps;
        }
        let mut open = vec![(a.clone(), b.clone())];
        while let Some((lower, upper)) = open.pop() {
            let interval = Interval::new(lower.clone(), upper.clone()).expect("the parts have a width");
            let coefficients = simple.bernstein_coefficients(&interval);
            budget::charge_terms(coefficients.len() as u64);
            let outcome = outcome(&coefficients, &lower, &upper, width);
            match &outcome {
                ClipOutcome::Clipped(l, u) => open.push((l.clone(), u.clone())),
                ClipOutcome::Halved(middle) => {
                    open.push((middle.clone(), upper.clone()));
                    open.push((lower.clone(), middle.clone()));
                }
                _ => {}
            }
            steps.push(Clip { lower, upper, coefficients, outcome });
        }
        steps
    }
}

fn outcome(list: &[Rational], lower: &Rational, upper: &Rational, width: &Rational) -> ClipOutcome {
    let Some((from, to)) = hull_on_axis(list) else { return ClipOutcome::Empty };
    let length = upper - lower;
    let at = |s: &Rational| lower + &length * s;
    if from == to && (from.is_zero() || from == integer(1)) {
        return ClipOutcome::Exact(at(&from));
    }
    let signs: Vec<bool> = list.iter().filter(|b| !b.is_zero()).map(Signed::is_negative).collect();
    let changes = signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
    let ends = list.first().is_some_and(Zero::is_zero) || list.last().is_some_and(Zero::is_zero);
    if changes == 1 && !ends && length <= *width {
        return ClipOutcome::Root;
    }
    if &to - &from > rational(4, 5) || from == to {
        return ClipOutcome::Halved(at(&rational(1, 2)));
    }
    // A power of 2 of at most a sixteenth of the new width.
    let target = (&to - &from) * &length / integer(16);
    let mut unit = integer(1);
    while unit > target {
        unit /= integer(2);
    }
    while &unit * integer(2) <= target {
        unit *= integer(2);
    }
    let rounded = |q: &Rational, up: bool| {
        let q = q / &unit;
        let whole: Int = if up { q.ceil().to_integer() } else { q.floor().to_integer() };
        Rational::from_integer(whole) * &unit
    };
    let (l, u) = (rounded(&at(&from), false).max(lower.clone()), rounded(&at(&to), true).min(upper.clone()));
    ClipOutcome::Clipped(l, u)
}

/// Between which numbers in [0, 1] the convex hull of the points (i/n, b_i) meets the axis. Cost: n².
fn hull_on_axis(list: &[Rational]) -> Option<(Rational, Rational)> {
    let n = list.len() as i64 - 1;
    // The hull meets the axis between the extreme points of all segments from one point to another.
    let mut found: Option<(Rational, Rational)> = None;
    let mut take = |x: Rational| {
        found = Some(match found.take() {
            None => (x.clone(), x),
            Some((low, high)) => (low.min(x.clone()), high.max(x)),
        });
    };
    for (i, p) in (0..).zip(list) {
        budget::steps(1 + list.len() as u32 / 8);
        if p.is_zero() {
            take(rational(i, n));
        }
        for (j, q) in (0..).zip(list).skip(i as usize + 1) {
            if p.is_negative() != q.is_negative() && !p.is_zero() && !q.is_zero() {
                let slope = p / (p - q);
                take((integer(i) + integer(j - i) * slope) / integer(n));
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::poly::RealRoot;
    use proptest::prelude::*;

    proptest! {
        /// Every root lies in exactly one interval with one root, or is found exactly; and nothing else does.
        #[test]
        fn clips_keep_all_roots(c in prop::collection::vec(-6i64..7, 2..7), planted in prop::collection::vec(-4i64..5, 0..3), a in -5i64..1, w in 1i64..9) {
            let mut f: Poly = c.into_iter().map(integer).collect();
            for root in planted {
                f *= Poly::variable() - Poly::constant(rational(root, 2));
            }
            prop_assume!(f.degree() > Some(0));
            let (a, b) = (integer(a), integer(a + w));
            let interval = Interval::new(a.clone(), b.clone()).unwrap();
            let steps = f.clipping(&interval, &rational(1, 50));
            let mut exact: Vec<Rational> = Vec::new();
            let mut inside: Vec<(Rational, Rational)> = Vec::new();
            for step in &steps {
                match &step.outcome {
                    ClipOutcome::Exact(root) => exact.push(root.clone()),
                    ClipOutcome::Root => inside.push((step.lower.clone(), step.upper.clone())),
                    _ => {}
                }
            }
            if f.square_free_part().degree() == f.degree() && let Some(first) = steps.first() {
                prop_assert_eq!(&first.coefficients, &f.bernstein_coefficients(&interval));
            }
            exact.sort();
            exact.dedup();
            let roots = f.real_roots(Some(&a), Some(&b)).unwrap();
            prop_assert_eq!(exact.len() + inside.len(), roots.len());
            prop_assert!(exact.iter().all(|t| f.value(t).is_zero()));
            for (l, u) in inside {
                let between = |root: &RealRoot| *root > RealRoot::Rational(l.clone()) && *root < RealRoot::Rational(u.clone());
                prop_assert_eq!(roots.iter().filter(|(root, _)| between(root)).count(), 1);
                prop_assert!(u - l <= rational(1, 50));
            }
        }
    }
}
