//! An interval of the line by its two ends: the frame of everything that is given over one.
//!
//! Definition: over [a, b] each parameter is u = (1 − s) a + s b with s = (u − a)/(b − a). The ends
//! are in either order; where an order matters it is said.
//!
//! **Invariant.** a ≠ b.
//!
//! Reference: G. Farin, *Curves and Surfaces for CAGD*, 5th ed. (2002), section 3.2.

use std::fmt;

use crate::math::ring::{Field, Ring, compare};

/// The two ends of an interval are equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EmptyInterval;

impl fmt::Display for EmptyInterval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the ends of the interval are equal")
    }
}

impl std::error::Error for EmptyInterval {}

/// An interval with two different ends, in either order.
///
/// ```
/// use polarform::interval::{EmptyInterval, Interval};
/// use polarform::number::{integer as z, rational as q};
/// let interval = Interval::new(z(1), z(5))?;
/// assert_eq!(interval.local(&z(2)), q(1, 4));
/// assert_eq!(Interval::new(z(1), z(1)), Err(EmptyInterval));
/// # Ok::<(), EmptyInterval>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct Interval<C> {
    a: C,
    b: C,
    /// 1 / (b − a)
    inverse: C,
}

impl<C: Field> Interval<C> {
    /// The interval [a, b].
    ///
    /// # Errors
    /// [`EmptyInterval`] if a = b.
    pub fn new(a: C, b: C) -> Result<Self, EmptyInterval> {
        let inverse = b.minus(&a).inverse().ok_or(EmptyInterval)?;
        Ok(Interval { a, b, inverse })
    }

    /// [a, t] and [t, b].
    ///
    /// # Errors
    /// [`EmptyInterval`] if t is an end.
    pub fn split(&self, t: &C) -> Result<(Self, Self), EmptyInterval> {
        Ok((Interval::new(self.a.clone(), t.clone())?, Interval::new(t.clone(), self.b.clone())?))
    }
}

impl<C: Ring> Interval<C> {
    /// [0, 1]
    pub fn unit() -> Self {
        Interval { a: C::zero(), b: C::one(), inverse: C::one() }
    }

    /// The first end, a.
    pub fn start(&self) -> &C {
        &self.a
    }

    /// The second end, b.
    pub fn end(&self) -> &C {
        &self.b
    }

    /// a and b.
    pub fn ends(&self) -> (&C, &C) {
        (&self.a, &self.b)
    }

    /// 1 / (b − a)
    pub fn inverse_width(&self) -> &C {
        &self.inverse
    }

    /// b − a
    pub fn width(&self) -> C {
        self.b.minus(&self.a)
    }

    /// [a + by, b + by]
    pub fn moved(&self, by: &C) -> Self {
        Interval { a: self.a.plus(by), b: self.b.plus(by), inverse: self.inverse.clone() }
    }

    /// (u − a)/(b − a)
    pub fn local(&self, u: &C) -> C {
        u.minus(&self.a).times(&self.inverse)
    }

    /// Whether a parameter lies between the ends; `None` if that depends on symbols.
    pub fn contains(&self, u: &C) -> Option<bool> {
        let s = self.local(u);
        Some(not_negative(&s)? && not_negative(&C::one().minus(&s))?)
    }
}

/// `[a, b]`
impl<C: fmt::Display> fmt::Display for Interval<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "[{}, {}]", self.a, self.b)
    }
}

debug_by_text!(Interval);

/// Whether x ≥ 0, if x is a number.
pub(in crate::math) fn not_negative<C: Ring>(x: &C) -> Option<bool> {
    compare(x, &C::zero()).map(std::cmp::Ordering::is_ge)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{Rational, integer as z};

    #[test]
    fn ends_stand_in_either_order() {
        assert!(Interval::<Rational>::unit().split(&z(1)).is_err());
        let backwards = Interval::new(z(3), z(1)).unwrap();
        assert_eq!(
            [0, 1, 2, 3, 4].map(|u| backwards.contains(&z(u)) == Some(true)),
            [false, true, true, true, false]
        );
        assert_eq!(format!("{backwards} {backwards:?}"), "[3, 1] Interval([3, 1])");
    }
}
