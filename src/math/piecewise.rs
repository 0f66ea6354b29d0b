//! Piecewise polynomials, exact, with breakpoints that may be symbols.
//!
//! Definition: breakpoints x_0 < x_1 < … < x_m and on each [x_i, x_{i+1}) one polynomial, kept
//! by its coefficients in t. The last interval includes
//! its end, unless the function is made half-open or another breakpoint is made to belong to the interval on its left. Outside, the
//! function is 0 or has no value, as [`Outside`] says.
//!
//! **Invariant.** m ≥ 1; two neighbouring breakpoints are never equal, and in increasing order
//! wherever their difference is a number. Symbolic breakpoints are taken to be in the order
//! given.
//!
//! Reference: C. de Boor, *A Practical Guide to Splines* (2001), chapter VII.

use std::cmp::Ordering;
use std::fmt;

use crate::budget;
use crate::math::poly::Coefficients;
use crate::math::ring::{Ring, compare};

/// What a piecewise polynomial is outside of its breakpoints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outside {
    /// Zero, as a B-spline basis function.
    Zero,
    /// Without a value, as a curve.
    Undefined,
}

/// Why something is not a piecewise polynomial, or has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PiecewiseError {
    /// The numbers of breakpoints and pieces do not fit together: m pieces need m + 1 of them.
    Counts {
        /// Number of breakpoints.
        breaks: usize,
        /// Number of pieces.
        pieces: usize,
    },
    /// A breakpoint is not larger than the one before it.
    Order {
        /// The place of the offending breakpoint, from 0.
        index: usize,
    },
    /// The parameter lies outside of the breakpoints.
    OutsideDomain,
    /// On which piece the parameter lies depends on symbols.
    Unordered,
}

impl fmt::Display for PiecewiseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PiecewiseError::Counts { breaks, pieces } => {
                write!(f, "{pieces} pieces need {} breakpoints, not {breaks}", pieces + 1)
            }
            PiecewiseError::Order { index } => {
                write!(f, "breakpoint {index} is not larger than the one before it")
            }
            PiecewiseError::OutsideDomain => f.write_str("the parameter lies outside of the breakpoints"),
            PiecewiseError::Unordered => f.write_str("on which piece the parameter lies depends on symbols"),
        }
    }
}

impl std::error::Error for PiecewiseError {}

/// `t^2 on [0, 1), 2 - t on [1, 2]`, and `0 outside` if it is.
impl<C: Ring + fmt::Display> fmt::Display for Piecewise<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let last = self.pieces.len();
        let to_the_left = |i: usize| if i == last { self.is_closed() } else { self.inner_left() == Some(i) };
        for (i, (piece, ends)) in self.pieces.iter().zip(self.breaks.windows(2)).enumerate() {
            let open = if i > 0 && to_the_left(i) { '(' } else { '[' };
            let close = if to_the_left(i + 1) { ']' } else { ')' };
            let behind = if i > 0 { ", " } else { "" };
            write!(f, "{behind}{piece} on {open}{}, {}{close}", ends[0], ends[1])?;
        }
        if self.outside == Outside::Zero { f.write_str(", 0 outside") } else { Ok(()) }
    }
}

debug_by_text!(Piecewise);

/// A piecewise polynomial.
#[derive(Clone, PartialEq)]
pub struct Piecewise<C> {
    breaks: Vec<C>,
    pieces: Vec<Coefficients<C>>,
    outside: Outside,
    /// The breakpoint that belongs to what is on its left. Usually it is the last one.
    left: Option<usize>,
}

impl<C: Ring> Piecewise<C> {
    /// The function with these breakpoints and, between them, the polynomials with these power
    /// coefficients.
    ///
    /// # Errors
    /// [`PiecewiseError::Counts`], [`PiecewiseError::Order`].
    ///
    /// ```
    /// use polarform::number::integer as z;
    /// use polarform::piecewise::{Outside, Piecewise};
    /// // the hat function: t on [0, 1), 2 − t on [1, 2]
    /// let pieces = vec![vec![z(0), z(1)], vec![z(2), z(-1)]];
    /// let hat = Piecewise::new(vec![z(0), z(1), z(2)], pieces, Outside::Zero)?;
    /// assert_eq!(hat.value(&z(1)), Ok(z(1)));
    /// assert_eq!(hat.value(&z(5)), Ok(z(0)));
    /// # Ok::<(), polarform::piecewise::PiecewiseError>(())
    /// ```
    pub fn new(
        breaks: Vec<C>,
        pieces: Vec<impl Into<Coefficients<C>>>,
        outside: Outside,
    ) -> Result<Self, PiecewiseError> {
        if pieces.is_empty() || breaks.len() != pieces.len() + 1 {
            return Err(PiecewiseError::Counts { breaks: breaks.len(), pieces: pieces.len() });
        }
        for (i, pair) in breaks.windows(2).enumerate() {
            if matches!(compare(&pair[0], &pair[1]), Some(Ordering::Equal | Ordering::Greater)) {
                return Err(PiecewiseError::Order { index: i + 1 });
            }
        }
        let pieces: Vec<Coefficients<C>> = pieces.into_iter().map(Into::into).collect();
        let left = Some(pieces.len());
        Ok(Piecewise { breaks, pieces, outside, left })
    }

    /// The same function without its value at x_m: there it is what it is outside. A basis
    /// function that jumps at its last knot is such. Where it is 0 at x_m nothing changes.
    #[must_use]
    pub fn half_open(mut self) -> Self {
        self.left = None;
        self.settled()
    }

    /// The same function, only that the breakpoint x belongs to what is on its left, the interval or for x_0 the outside, and x_m to the outside
    /// on its right. If x is no breakpoint it is half-open. Where the function is continuous nothing changes.
    ///
    /// ```
    /// use polarform::number::integer as z;
    /// use polarform::piecewise::{Outside, Piecewise};
    /// let steps = Piecewise::new([0, 1, 2].map(z).to_vec(), vec![vec![z(5)], vec![z(7)]], Outside::Zero)?;
    /// assert_eq!(steps.value(&z(1)), Ok(z(7)));
    /// assert_eq!(steps.clone().left_at(&z(1)).value(&z(1)), Ok(z(5)));
    /// assert_eq!(steps.left_at(&z(0)).value(&z(0)), Ok(z(0)));
    /// # Ok::<(), polarform::piecewise::PiecewiseError>(())
    /// ```
    #[must_use]
    pub fn left_at(mut self, x: &C) -> Self {
        self.left = self.breaks.iter().position(|y| y == x);
        self.settled()
    }

    /// The number of the breakpoint that belongs to what is on its left, if it is not the last one.
    pub fn inner_left(&self) -> Option<usize> {
        self.left.filter(|&k| k < self.pieces.len())
    }

    /// Whether x_m belongs to the last interval.
    pub fn is_closed(&self) -> bool {
        self.left == Some(self.pieces.len())
    }

    /// Whether it matters to which side a breakpoint belongs.
    fn jumps(&self, k: usize) -> bool {
        let x = &self.breaks[k];
        let before = k.checked_sub(1).map(|k| self.pieces[k].value(x));
        let after = self.pieces.get(k).map(|piece| piece.value(x));
        match (before, after) {
            (None, _) if self.outside == Outside::Undefined => true,
            (before, after) => before.unwrap_or_else(C::zero) != after.unwrap_or_else(C::zero),
        }
    }

    /// One form for functions with the same values.
    fn settled(mut self) -> Self {
        self.left = self.left.filter(|&k| k == self.pieces.len() || self.jumps(k));
        if self.left.is_none() && !self.jumps(self.pieces.len()) {
            self.left = Some(self.pieces.len());
        }
        self
    }

    /// x_0, …, x_m
    pub fn breaks(&self) -> &[C] {
        &self.breaks
    }

    /// The polynomial on each interval.
    pub fn pieces(&self) -> &[Coefficients<C>] {
        &self.pieces
    }

    /// What the function is outside.
    pub fn outside(&self) -> Outside {
        self.outside
    }

    /// The largest degree of a piece; 0 for the zero function.
    pub fn degree(&self) -> usize {
        self.pieces.iter().filter_map(Coefficients::degree).max().unwrap_or(0)
    }

    /// Which piece a parameter lies on: i with x_i ≤ t < x_{i+1}, the last one at its end.
    ///
    /// # Errors
    /// [`PiecewiseError::OutsideDomain`], [`PiecewiseError::Unordered`].
    pub fn locate(&self, t: &C) -> Result<usize, PiecewiseError> {
        interval_of(&self.breaks, t)
    }

    /// The value at t. Cost: one product for each degree.
    ///
    /// # Errors
    /// As [`Piecewise::locate`]; outside is no error if the function is 0 there.
    pub fn value(&self, t: &C) -> Result<C, PiecewiseError> {
        let outside = || match self.outside {
            Outside::Zero => Ok(C::zero()),
            Outside::Undefined => Err(PiecewiseError::OutsideDomain),
        };
        if let Some(k) = self.inner_left()
            && *t == self.breaks[k]
        {
            return k.checked_sub(1).map_or_else(outside, |k| Ok(self.pieces[k].value(t)));
        }
        match self.locate(t) {
            Ok(_) if !self.is_closed() && *t == self.breaks[self.pieces.len()] => outside(),
            Ok(i) => Ok(self.pieces[i].value(t)),
            Err(PiecewiseError::OutsideDomain) => outside(),
            Err(error) => Err(error),
        }
    }

    /// The k-th derivative on each piece.
    pub fn nth_derivative(&self, k: usize) -> Self {
        let pieces = self.pieces.iter().map(|piece| piece.nth_derivative(k));
        Piecewise { pieces: pieces.collect(), ..self.clone() }.settled()
    }

    /// The continuous antiderivative that is 0 at x_0. It has no value outside.
    pub fn antiderivative(&self) -> Self {
        let mut start = C::zero();
        let mut pieces = Vec::with_capacity(self.pieces.len());
        for (piece, ends) in self.pieces.iter().zip(self.breaks.windows(2)) {
            let primitive = piece.antiderivative();
            let shift = start.minus(&primitive.value(&ends[0]));
            let primitive = primitive.plus(&Coefficients::constant(shift));
            start = primitive.value(&ends[1]);
            pieces.push(primitive);
        }
        let left = Some(pieces.len());
        Piecewise { breaks: self.breaks.clone(), pieces, outside: Outside::Undefined, left }
    }

    /// The integral over all pieces.
    pub fn integral(&self) -> C {
        let primitive = self.antiderivative();
        let last = primitive.breaks.last().expect("there are at least two breakpoints");
        primitive.pieces[primitive.pieces.len() - 1].value(last)
    }

    /// The largest k ≤ degree such that the pieces meet with equal derivatives of order 0, …, k
    /// at the inner breakpoint x_i; `None` if not even the values agree.
    #[cfg(test)]
    pub(crate) fn smoothness(&self, i: usize) -> Option<usize> {
        assert!(i >= 1 && i < self.pieces.len(), "an inner breakpoint");
        let mut rest = self.pieces[i].minus(&self.pieces[i - 1]);
        let mut order = None;
        for k in 0..=self.degree() {
            if !rest.value(&self.breaks[i]).is_zero() {
                break;
            }
            order = Some(k);
            rest = rest.derivative();
        }
        order
    }

    /// The same function with neighbouring equal pieces joined.
    pub fn merged(&self) -> Self {
        let mut breaks = vec![self.breaks[0].clone()];
        let mut pieces: Vec<Coefficients<C>> = Vec::new();
        for (piece, end) in self.pieces.iter().zip(&self.breaks[1..]) {
            if pieces.last() == Some(piece) {
                breaks.pop();
            } else {
                pieces.push(piece.clone());
            }
            breaks.push(end.clone());
        }
        let joined = Piecewise { left: None, breaks, pieces, outside: self.outside };
        match self.left {
            Some(k) => joined.left_at(&self.breaks[k]),
            None => joined,
        }
    }

    /// The function with every piece changed by a map of polynomials.
    pub fn map(&self, change: impl FnMut(&Coefficients<C>) -> Coefficients<C>) -> Self {
        let pieces = self.pieces.iter().map(change).collect();
        Piecewise { pieces, ..self.clone() }.settled()
    }

    /// The sum of two functions, over the breakpoints of both; `None` if the order of these depends
    /// on symbols. A function that has no value outside of its breakpoints gives none to the sum. Where one belongs to the left and the
    /// other one to the right and both jump, an inner breakpoint of the sum belongs to the right, the last one to the left.
    pub fn sum(&self, other: &Self) -> Option<Self> {
        let breaks = if self.breaks == other.breaks {
            self.breaks.clone()
        } else {
            let mut all: Vec<C> = self.breaks.iter().chain(&other.breaks).cloned().collect();
            let known = all.iter().all(|x| compare(x, &all[0]).is_some());
            if !known {
                return None;
            }
            all.sort_by(|x, y| compare(x, y).unwrap_or(Ordering::Equal));
            all.dedup();
            all
        };
        // Where one of them has no value the sum has none.
        let inside = |f: &Self, a: &C| {
            f.outside == Outside::Zero || f.locate(a).is_ok_and(|_| a != &f.breaks[f.breaks.len() - 1])
        };
        let kept: Vec<usize> = (0..breaks.len() - 1)
            .filter(|&i| inside(self, &breaks[i]) && inside(other, &breaks[i]))
            .collect();
        let (&first, &last) = (kept.first()?, kept.last()?);
        let breaks = breaks[first..=last + 1].to_vec();
        let piece = |f: &Self, a: &C| -> Coefficients<C> {
            match f.locate(a) {
                Ok(i) if a != &f.breaks[f.breaks.len() - 1] => f.pieces[i].clone(),
                _ => Coefficients::zero(),
            }
        };
        let pieces: Vec<Coefficients<C>> =
            breaks[..breaks.len() - 1].iter().map(|a| piece(self, a).plus(&piece(other, a))).collect();
        let outside = match (self.outside, other.outside) {
            (Outside::Zero, Outside::Zero) => Outside::Zero,
            _ => Outside::Undefined,
        };
        let jumps_at = |f: &Self, x: &C| f.breaks.iter().position(|y| y == x).filter(|&k| f.jumps(k));
        let takes_left = |f: &Self, x: &C| jumps_at(f, x).is_none_or(|k| f.left == Some(k));
        let agrees = |x: &C| takes_left(self, x) && takes_left(other, x);
        let own = |f: &Self| f.left.filter(|&k| f.jumps(k)).map(|k| f.breaks[k].clone());
        let end = breaks[breaks.len() - 1].clone();
        let sum = Piecewise { left: Some(pieces.len()), breaks, pieces, outside };
        let ends_open = |f: &Self| f.breaks[f.pieces.len()] == end && !f.is_closed();
        let ends_closed =
            |f: &Self| f.breaks[f.pieces.len()] == end && f.is_closed() && f.jumps(f.pieces.len());
        let inner = [own(self), own(other)].into_iter().flatten().find(|x| *x != end && agrees(x));
        Some(match inner {
            Some(x) if !ends_closed(self) && !ends_closed(other) => sum.left_at(&x),
            _ if (ends_open(self) || ends_open(other)) && !ends_closed(self) && !ends_closed(other) => {
                sum.half_open()
            }
            _ => sum,
        })
    }
}

/// i with `breaks[i]` ≤ t < `breaks[i+1]`, these two different; the end of the last such
/// interval belongs to it. Cost: O(log) comparisons among numbers, else at most one for each breakpoint.
///
/// # Errors
/// [`PiecewiseError::OutsideDomain`], and [`PiecewiseError::Unordered`] if the place depends on
/// symbols. A breakpoint equal to t is found also among symbols.
pub fn interval_of<C: Ring>(breaks: &[C], t: &C) -> Result<usize, PiecewiseError> {
    by_bisection(breaks, t).unwrap_or_else(|| by_comparing_all(breaks, t))
}

/// `None` if a comparison on the way depends on symbols.
fn by_bisection<C: Ring>(breaks: &[C], t: &C) -> Option<Result<usize, PiecewiseError>> {
    let last = breaks.len() - 1;
    let t = &t.as_rational()?;
    let at_most = |i: usize| Some(breaks[i].as_rational()? <= *t);
    if !at_most(0)? || breaks[last].as_rational()? < *t {
        return Some(Err(PiecewiseError::OutsideDomain));
    }
    if at_most(last)? {
        let before_end = breaks.iter().rposition(|x| *x != breaks[last]);
        return Some(before_end.ok_or(PiecewiseError::OutsideDomain));
    }
    // breaks[low] ≤ t < breaks[high]
    let (mut low, mut high) = (0, last);
    while high - low > 1 {
        budget::step();
        let middle = low + (high - low) / 2;
        if at_most(middle)? { low = middle } else { high = middle }
    }
    Some(Ok(low))
}

fn by_comparing_all<C: Ring>(breaks: &[C], t: &C) -> Result<usize, PiecewiseError> {
    let last = breaks.len() - 1;
    // A parameter that equals a breakpoint needs no order.
    if let Some(at) = breaks.iter().rposition(|x| x == t) {
        if at < last {
            return Ok(at);
        }
        return breaks.iter().rposition(|x| x != t).ok_or(PiecewiseError::OutsideDomain);
    }
    match (compare(&breaks[0], t), compare(&breaks[last], t)) {
        (Some(Ordering::Greater), _) | (_, Some(Ordering::Less)) => {
            return Err(PiecewiseError::OutsideDomain);
        }
        _ => {}
    }
    let mut from = None;
    for (i, x) in breaks.iter().enumerate() {
        budget::step();
        match compare(x, t) {
            Some(Ordering::Greater) => {
                // Between the last one known to be smaller and this one there are only symbols.
                return match from {
                    Some(j) if j + 1 == i => Ok(j),
                    _ => Err(PiecewiseError::Unordered),
                };
            }
            Some(_) => from = Some(i),
            None => {}
        }
    }
    Err(PiecewiseError::Unordered)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{Rational, integer as z, rational as q};
    use crate::math::poly::{Fraction, MultiPoly, Symbol};

    fn hat() -> Piecewise<Rational> {
        let pieces = vec![vec![z(0), z(1)], vec![z(2), z(-1), z(0)]];
        Piecewise::new(vec![z(0), z(1), z(2)], pieces, Outside::Zero).unwrap()
    }

    fn symbol(name: &str) -> Fraction {
        Fraction::from(MultiPoly::symbol(Symbol::new(name)))
    }

    #[test]
    fn values_and_ends() {
        let hat = hat();
        assert_eq!(hat.value(&q(1, 2)), Ok(q(1, 2)));
        assert_eq!(hat.value(&z(2)), Ok(z(0)));
        assert_eq!(hat.value(&z(-1)), Ok(z(0)));
        assert_eq!(hat.to_string(), "t on [0, 1), -t + 2 on [1, 2], 0 outside");
        assert_eq!(hat.integral(), z(1));
        assert_eq!(hat.antiderivative().value(&z(2)), Ok(z(1)));
        assert_eq!(hat.antiderivative().smoothness(1), Some(1));
        assert_eq!(hat.nth_derivative(1).smoothness(1), None);
        assert_eq!(hat.antiderivative().nth_derivative(1).pieces(), hat.pieces());
        assert_eq!(hat.antiderivative().value(&z(3)), Err(PiecewiseError::OutsideDomain));
    }

    proptest::proptest! {
        #[test]
        fn bisection_agrees_with_comparing_all(
            steps in proptest::collection::vec(0i64..3, 1..12), p in -3i64..30, half in proptest::bool::ANY,
        ) {
            let mut end = 0;
            let breaks: Vec<Rational> = steps.iter().map(|s| { end += s; z(end) }).collect();
            let t = if half { q(2 * p + 1, 2) } else { z(p) };
            assert_eq!(by_bisection(&breaks, &t), Some(by_comparing_all(&breaks, &t)));
        }
    }

    proptest::proptest! {
        /// Values of a function with one breakpoint that belongs to the left, of sums and of merged functions.
        #[test]
        fn one_breakpoint_may_belong_to_the_left(
            a in proptest::collection::vec(-2i64..3, 4), b in proptest::collection::vec(-2i64..3, 3),
            x in 0i64..6, twice in 0i64..12,
        ) {
            let step = |list: &[i64], start: i64| {
                let breaks = (0..=list.len() as i64).map(|k| z(start + k)).collect();
                Piecewise::new(breaks, list.iter().map(|&c| vec![z(c)]).collect(), Outside::Zero).unwrap()
            };
            let t = q(twice, 2);
            // From the left at x, from the right elsewhere, by doubled whole numbers.
            let expected = |list: &[i64], start: i64| {
                let place = if twice == 2 * x { twice - 1 } else { twice };
                let k = num_integer::Integer::div_floor(&(place - 2 * start), &2);
                usize::try_from(k).ok().and_then(|k| list.get(k)).copied().unwrap_or(0)
            };
            let (f, g) = (step(&a, 0).left_at(&z(x)), step(&b, 2).left_at(&z(x)));
            proptest::prop_assert_eq!(f.value(&t), Ok(z(expected(&a, 0))));
            proptest::prop_assert_eq!(g.value(&t), Ok(z(expected(&b, 2))));
            proptest::prop_assert_eq!(f.merged().value(&t), f.value(&t));
            let sum = f.sum(&g).unwrap();
            // Where both belong to the same side, or only one of them jumps, the sum has its values.
            let sides = |h: &Piecewise<Rational>| h.inner_left().is_some() || !h.is_closed() || h.breaks()[h.pieces().len()] == z(x);
            if sides(&f) && sides(&g) {
                proptest::prop_assert_eq!(sum.value(&t), Ok(z(expected(&a, 0) + expected(&b, 2))));
            }
        }
    }

    #[test]
    fn merging_joins_equal_pieces() {
        let p = vec![z(1), z(2)];
        let f =
            Piecewise::new(vec![z(0), z(1), z(2), z(3)], vec![p.clone(), p.clone(), vec![]], Outside::Zero);
        let merged = f.unwrap().merged();
        assert_eq!(merged.breaks(), [z(0), z(2), z(3)]);
        assert_eq!(merged.pieces(), [p.into(), Coefficients::zero()]);
    }

    #[test]
    fn symbols_are_found_only_where_order_is_known() {
        let (a, b, c) = (symbol("a"), symbol("b"), symbol("c"));
        let breaks = [a.clone(), b.clone(), c];
        assert_eq!(interval_of(&breaks, &b), Ok(1));
        assert_eq!(interval_of(&breaks, &symbol("t")), Err(PiecewiseError::Unordered));
        let number = |k| Fraction::from_rational(&z(k));
        let mixed = [number(0), number(1), a, number(5)];
        assert_eq!(interval_of(&mixed, &Fraction::from_rational(&q(1, 2))), Ok(0));
        assert_eq!(interval_of(&mixed, &number(2)), Err(PiecewiseError::Unordered));
        assert_eq!(interval_of(&mixed, &number(6)), Err(PiecewiseError::OutsideDomain));
    }

    #[test]
    fn what_is_wrong_is_said() {
        let piece = || vec![z(1)];
        let order = Piecewise::new(vec![z(0), z(0)], vec![piece()], Outside::Zero);
        assert_eq!(order, Err(PiecewiseError::Order { index: 1 }));
        let counts = Piecewise::new(vec![z(0)], vec![piece()], Outside::Zero);
        assert_eq!(counts, Err(PiecewiseError::Counts { breaks: 1, pieces: 1 }));
    }
}
