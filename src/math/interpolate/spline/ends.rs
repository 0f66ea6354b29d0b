//! The conditions at the two ends of a cubic spline, as equations.

use super::Unknowns;
use crate::math::interpolate::datum::{Datum, reciprocal, share};
use crate::math::number::rational;
use crate::math::ring::Field;

/// The condition at one end.
#[derive(Clone, Debug, PartialEq)]
pub enum End<V> {
    /// S'' = 0.
    Natural,
    /// S' is given (a clamped end).
    Slope(V),
    /// S'' is given.
    SecondDerivative(V),
    /// S''' is continuous at the node next to the end, so that the two pieces there are one
    /// polynomial. Where there are too few nodes for this to say anything, the spline is the
    /// polynomial of least degree: a straight line through 2 points or a parabola through 3 if
    /// both ends are of this kind; if only one of 2 points is, a parabola.
    NotAKnot,
}

/// The conditions at both ends.
#[derive(Clone, Debug, PartialEq)]
pub enum Ends<V> {
    /// S, S' and S'' have the same values at both ends.
    Periodic,
    /// One condition for each end.
    Each {
        /// That at x_0.
        first: End<V>,
        /// That at x_n.
        last: End<V>,
    },
}

impl<V> Ends<V> {
    /// S'' = 0 at both ends.
    pub fn natural() -> Self {
        Ends::Each { first: End::Natural, last: End::Natural }
    }

    /// S' given at both ends.
    pub fn clamped(first: V, last: V) -> Self {
        Ends::Each { first: End::Slope(first), last: End::Slope(last) }
    }

    /// S'' given at both ends.
    pub fn second_derivatives(first: V, last: V) -> Self {
        Ends::Each { first: End::SecondDerivative(first), last: End::SecondDerivative(last) }
    }

    /// S''' continuous at x_1 and x_{n−1}.
    pub fn not_a_knot() -> Self {
        Ends::Each { first: End::NotAKnot, last: End::NotAKnot }
    }

    /// The data given at the ends.
    pub(super) fn data(&self) -> impl Iterator<Item = &V> {
        let ends = match self {
            Ends::Periodic => [None, None],
            Ends::Each { first, last } => [Some(first), Some(last)],
        };
        ends.into_iter().flatten().filter_map(|end| match end {
            End::Slope(datum) | End::SecondDerivative(datum) => Some(datum),
            End::Natural | End::NotAKnot => None,
        })
    }
}

/// outer · (unknown at the end) + inner · (its neighbour) = right.
pub(super) struct Equation<C, V> {
    pub(super) outer: C,
    pub(super) inner: C,
    pub(super) right: V,
}

/// What "not a knot" can mean with few nodes.
#[derive(Clone, Copy, PartialEq)]
enum Meaning {
    /// S''' is continuous at the next node.
    Joined,
    /// The piece at the end is a parabola.
    Parabola,
    /// It is a straight line.
    Line,
}

/// The intervals at an end and beside it.
struct Place<'a, C, V> {
    /// h of the interval at the end, and of the next one.
    near: &'a C,
    next: &'a C,
    /// δ of these.
    rise: &'a V,
    next_rise: &'a V,
    /// 1 at x_0 and −1 at x_n: all equations are those of the reflected data, where
    /// differences, slopes and their right sides change sign.
    sign: i64,
    not_a_knot: Meaning,
}

/// The equations of the first and the last node.
pub(super) fn equations<C: Field, V: Datum<C>>(
    unknowns: Unknowns,
    lengths: &[C],
    differences: &[V],
    first: &End<V>,
    last: &End<V>,
) -> [Equation<C, V>; 2] {
    let n = lengths.len();
    let both = matches!((first, last), (End::NotAKnot, End::NotAKnot));
    let not_a_knot = match (n, both) {
        (1, true) => Meaning::Line,
        (1, false) | (2, true) => Meaning::Parabola,
        _ => Meaning::Joined,
    };
    let place = |near: usize, next: usize, sign: i64| Place {
        near: &lengths[near],
        next: &lengths[next],
        rise: &differences[near],
        next_rise: &differences[next],
        sign,
        not_a_knot,
    };
    let (start, stop) = (place(0, 1.min(n - 1), 1), place(n - 1, n.saturating_sub(2), -1));
    match unknowns {
        Unknowns::Moments => [start.by_moments(first), stop.by_moments(last)],
        Unknowns::Slopes => [start.by_slopes(first), stop.by_slopes(last)],
    }
}

impl<C: Field, V: Datum<C>> Place<'_, C, V> {
    fn by_moments(&self, end: &End<V>) -> Equation<C, V> {
        let zero = self.rise.origin();
        match end {
            End::Natural => equation(number(2), C::zero(), zero),
            End::SecondDerivative(datum) => equation(number(2), C::zero(), times(datum, 2)),
            // 2 M_0 + M_1 = 6 (δ_0 − m_0)/h_0
            End::Slope(slope) => {
                let bend = self.rise.less(slope).multiple(&reciprocal(self.near));
                equation(number(2), C::one(), times(&bend, 6 * self.sign))
            }
            End::NotAKnot => match self.not_a_knot {
                Meaning::Line => equation(number(2), C::zero(), zero),
                Meaning::Parabola => equation(C::one(), -C::one(), zero),
                // (M_1 − M_0)/h_0 = (M_2 − M_1)/h_1, and M_2 from the equation of x_1:
                // (h_0 − h_1) M_0 + (2h_0 + h_1) M_1 = 6 h_0 (δ_1 − δ_0)/(h_0 + h_1)
                Meaning::Joined => {
                    let share = self.near.times(&self.inverse_sum());
                    let bend = self.next_rise.less(self.rise).multiple(&share);
                    let inner = self.near.plus(self.near).plus(self.next);
                    equation(self.near.minus(self.next), inner, times(&bend, 6 * self.sign))
                }
            },
        }
    }

    fn by_slopes(&self, end: &End<V>) -> Equation<C, V> {
        // 2 m_0 + m_1 = 3 δ_0 − h_0 M_0/2
        let bent = |moment: &V| {
            let half = share(&moment.multiple(self.near), &rational(self.sign, 2));
            equation(number(2), C::one(), times(self.rise, 3).less(&half))
        };
        match end {
            End::Natural => bent(&self.rise.origin()),
            End::SecondDerivative(datum) => bent(datum),
            End::Slope(slope) => equation(number(2), C::zero(), times(slope, 2)),
            End::NotAKnot => match self.not_a_knot {
                Meaning::Line => equation(number(2), C::zero(), times(self.rise, 2)),
                Meaning::Parabola => equation(C::one(), C::one(), times(self.rise, 2)),
                // h_1 m_0 + (h_0 + h_1) m_1
                //   = ((3h_0 + 2h_1) h_1 δ_0 + h_0² δ_1)/(h_0 + h_1)   (de Boor 2001, IV (17))
                Meaning::Joined => {
                    let inverse = self.inverse_sum();
                    let sum = self.near.plus(self.next);
                    let weight = sum.plus(&sum).plus(self.near).times(self.next);
                    let right = self.rise.multiple(&weight.times(&inverse));
                    let square = self.near.times(self.near).times(&inverse);
                    equation(self.next.clone(), sum, right.added(&self.next_rise.multiple(&square)))
                }
            },
        }
    }

    /// 1/(h_0 + h_1), the length of two neighbouring intervals
    fn inverse_sum(&self) -> C {
        reciprocal(&self.near.plus(self.next))
    }
}

fn equation<C, V>(outer: C, inner: C, right: V) -> Equation<C, V> {
    Equation { outer, inner, right }
}

fn number<C: Field>(q: i64) -> C {
    C::from_rational(&rational(q, 1))
}

fn times<C: Field, V: Datum<C>>(datum: &V, q: i64) -> V {
    share(datum, &rational(q, 1))
}
