//! Extreme values of quotients of polynomials on an interval, also where they are taken at numbers that are not rational.
//!
//! A value P(α)/Q(α) is a root of Res_t(M(t), Q(t) y − P(t)) for a polynomial M with the root α, and an interval around α
//! that is short enough tells which.

use std::cmp::Ordering;

use super::algebraic::{AlgebraicNumber, RealRoot};
use crate::math::interval::Interval;
use crate::math::number::{Rational, integer};
use crate::math::poly::{MultiPoly, Poly, Symbol};
use crate::math::ring::Ring;

/// The largest or the smallest value of a function, and where it is taken.
#[derive(Clone, Debug, PartialEq)]
pub struct Extreme {
    /// The value.
    pub value: RealRoot,
    /// Where it is taken, in increasing order; the ends only, for a constant.
    pub places: Vec<RealRoot>,
}

impl AlgebraicNumber {
    /// P/Q there, of which Q must not be 0 between the ends.
    ///
    /// Cost: a resultant of polynomials in two variables, its real roots, and bisection until they are told apart.
    fn quotient(&self, p: &Poly, q: &Poly) -> RealRoot {
        let [t, y] = ["t", "y"].map(Symbol::new);
        let lifted =
            |f: &Poly| -> Vec<MultiPoly> { f.coefficients().into_iter().map(MultiPoly::constant).collect() };
        let below = MultiPoly::from_coefficients_in(&t, &lifted(q)).times(&MultiPoly::symbol(y.clone()));
        let relation = below.minus(&MultiPoly::from_coefficients_in(&t, &lifted(p)));
        let eliminated = MultiPoly::from_coefficients_in(&t, &lifted(self.polynomial()))
            .resultant(&relation, &t)
            .coefficients_in(&y);
        let eliminated = eliminated.iter().map(|c| c.as_constant().unwrap_or_default()).collect();
        let roots = Poly::from_coefficients(eliminated).real_roots(None, None).unwrap_or_default();
        let mut candidates: Vec<RealRoot> = roots.into_iter().map(|(root, _)| root).collect();
        let mut near = self.clone();
        loop {
            let (lower, upper) = near.ends();
            let isolating =
                Interval::new(lower.clone(), upper.clone()).expect("an isolating interval has a width");
            let enclosed = |f: &Poly| -> Option<[Rational; 2]> {
                let list = f.bernstein_coefficients(&isolating);
                Some([list.iter().min()?.clone(), list.iter().max()?.clone()])
            };
            if let (Some(above), Some(below)) = (enclosed(p), enclosed(q))
                && (below[0] > integer(0) || below[1] < integer(0))
            {
                let corners = above.iter().flat_map(|a| below.iter().map(move |b| a / b));
                let corners: Vec<Rational> = corners.collect();
                if let (Some(least), Some(most)) = (corners.iter().min(), corners.iter().max()) {
                    candidates.retain(|root| compared(root, least).is_ge() && compared(root, most).is_le());
                }
            }
            if candidates.len() == 1 {
                return candidates.remove(0);
            }
            near = near.refined(&((upper - lower) / integer(4)));
        }
    }
}

fn compared(root: &RealRoot, q: &Rational) -> Ordering {
    root.cmp(&RealRoot::Rational(q.clone()))
}

impl Poly {
    /// The largest or smallest value of P/Q for P = self between a and b; an end that is `open` does not count. `None`
    /// if there is none: the interval is empty, the value is only approached, or Q has a root in [a, b].
    ///
    /// Cost: that of the real roots of P'Q − PQ', and for each of them that is not rational a resultant.
    ///
    /// ```
    /// use polarform::number::{integer, rational};
    /// use polarform::poly::{Poly, RealRoot};
    /// // 3 t (1 - t)^2
    /// let t = Poly::variable();
    /// let f = Poly::from(3) * &t * (Poly::from(1) - &t).pow(2);
    /// let [a, b] = [integer(0), integer(1)];
    /// let largest = f.extreme(&Poly::from(1), [&a, &b], [false, false], true).unwrap();
    /// assert_eq!(largest.value, RealRoot::Rational(rational(4, 9)));
    /// assert_eq!(largest.places, [RealRoot::Rational(rational(1, 3))]);
    /// ```
    pub fn extreme(
        &self,
        q: &Poly,
        [a, b]: [&Rational; 2],
        open: [bool; 2],
        largest: bool,
    ) -> Option<Extreme> {
        if a > b || a == b && open != [false, false] || !q.real_roots(Some(a), Some(b))?.is_empty() {
            return None;
        }
        let value = |place: &RealRoot| match place {
            RealRoot::Rational(t) => RealRoot::Rational(self.value(t) / q.value(t)),
            RealRoot::Irrational(number) => number.quotient(self, q),
        };
        let ends = [a, b].map(|end| RealRoot::Rational(end.clone()));
        let slope = self.derivative() * q - self * q.derivative();
        let mut places: Vec<(RealRoot, bool)> = slope
            .real_roots(Some(a), Some(b))
            .unwrap_or_else(|| vec![(RealRoot::Rational((a + b) / integer(2)), 1)])
            .into_iter()
            .map(|(root, _)| (root, true))
            .filter(|(root, _)| !ends.contains(root))
            .collect();
        let [first, last] = ends;
        if a < b {
            places.push((last, !open[1]));
        }
        places.insert(0, (first, !open[0]));
        let values: Vec<RealRoot> = places.iter().map(|(place, _)| value(place)).collect();
        let best = if largest { values.iter().max() } else { values.iter().min() }?;
        let taken = places.iter().zip(&values).filter(|((_, counts), value)| *counts && *value == best);
        let places: Vec<RealRoot> = taken.map(|((place, _), _)| place.clone()).collect();
        (!places.is_empty()).then(|| Extreme { value: best.clone(), places })
    }
}
