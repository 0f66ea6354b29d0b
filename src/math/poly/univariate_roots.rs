//! Real roots of [`Poly`] in an interval, counted exactly by Sturm's theorem.
//!
//! For a square-free P let P_0 = P, P_1 = P', P_{k+1} = −(P_{k−1} mod P_k), up to
//! positive factors, and V(x) the number of changes of sign in P_0(x), P_1(x), …
//! with zeros left out. The number of roots in (a, b] is V(a) − V(b).
//!
//! S. Basu, R. Pollack, M.-F. Roy, "Algorithms in Real Algebraic Geometry", section 2.2.2.

use num_integer::Integer;
use num_traits::{Signed, Zero};

use super::{Poly, dense, dense_compose};
use crate::math::number::{Int, Rational};

/// Integer multiples of the polynomials of a Sturm sequence.
struct Sturm(Vec<Vec<Int>>);

impl Sturm {
    /// The sequence of a square-free polynomial that is not 0.
    fn new(square_free: &Poly) -> Sturm {
        let first = dense::primitive(square_free.numerators().to_vec());
        let mut last = dense::primitive(dense::derivative(&first));
        let mut sequence = vec![first];
        while !last.is_empty() {
            let division = dense::pseudo_division(&sequence[sequence.len() - 1], &last);
            let mut next = dense::primitive(division.remainder);
            if division.scale.is_positive() {
                next = dense::negated(&next);
            }
            sequence.push(std::mem::replace(&mut last, next));
        }
        Sturm(sequence)
    }

    /// V(x)
    fn sign_changes(&self, x: &Rational) -> usize {
        let signs = self.0.iter().map(|p| dense_compose::homogeneous_value(p, x.numer(), x.denom()).signum());
        count_changes(signs)
    }

    /// V at infinity or, with `negative`, at minus infinity.
    fn sign_changes_at_infinity(&self, negative: bool) -> usize {
        let signs = self.0.iter().filter_map(|p| {
            let sign = p.last()?.signum();
            Some(if negative && p.len().is_even() { -sign } else { sign })
        });
        count_changes(signs)
    }
}

fn count_changes(signs: impl Iterator<Item = Int>) -> usize {
    let mut previous = Int::ZERO;
    let mut changes = 0;
    for sign in signs.filter(|s| !s.is_zero()) {
        changes += usize::from((&sign * &previous).is_negative());
        previous = sign;
    }
    changes
}

impl Poly {
    /// The number of distinct real roots in the half-open interval (a, b]; 0 if a ≥ b.
    /// `None` for the zero polynomial, of which every number is a root.
    ///
    /// Cost: a remainder sequence, O(n²) products of integers of up to O(n) times the bits
    /// of the coefficients.
    ///
    /// ```
    /// # use polarform::{number::integer, poly::Poly};
    /// let f = Poly::variable().pow(2) - Poly::from(4);
    /// assert_eq!(f.count_roots(&integer(-2), &integer(2)), Some(1));
    /// assert_eq!(f.count_roots(&integer(-3), &integer(2)), Some(2));
    /// ```
    pub fn count_roots(&self, a: &Rational, b: &Rational) -> Option<usize> {
        let degree = self.degree()?;
        if degree == 0 || a >= b {
            return Some(0);
        }
        let sturm = Sturm::new(&self.square_free_part());
        Some(sturm.sign_changes(a) - sturm.sign_changes(b))
    }

    /// The number of distinct real roots; `None` for the zero polynomial.
    ///
    /// ```
    /// # use polarform::poly::Poly;
    /// let f = Poly::variable().pow(3) - Poly::variable();
    /// assert_eq!(f.count_real_roots(), Some(3));
    /// ```
    pub fn count_real_roots(&self) -> Option<usize> {
        if self.degree()? == 0 {
            return Some(0);
        }
        let sturm = Sturm::new(&self.square_free_part());
        Some(sturm.sign_changes_at_infinity(true) - sturm.sign_changes_at_infinity(false))
    }

    /// Whether F(t) ≥ 0 for every t in the closed interval [a, b]; true if a > b.
    ///
    /// F changes sign exactly at its roots of odd multiplicity. So F ≥ 0 on [a, b] iff
    /// there is none in the open interval and F ≥ 0 at one more point that is no such root.
    ///
    /// ```
    /// # use polarform::{number::integer, poly::Poly};
    /// let f = Poly::variable().pow(2) * (Poly::variable() - Poly::from(3));
    /// assert!(f.is_nonnegative_on(&integer(3), &integer(9)));
    /// assert!(!f.is_nonnegative_on(&integer(-1), &integer(1)));
    /// assert!((-f).is_nonnegative_on(&integer(-1), &integer(3)));
    /// ```
    pub fn is_nonnegative_on(&self, a: &Rational, b: &Rational) -> bool {
        if self.is_zero() || a > b {
            return true;
        }
        if a == b {
            return !self.value(a).is_negative();
        }
        let odd: Poly =
            self.square_free_factors().into_iter().filter(|(_, m)| m.is_odd()).map(|(p, _)| p).product();
        let inside = odd.count_roots(a, b).unwrap_or(0) - usize::from(odd.value(b).is_zero());
        let middle = (a + b) / Rational::from_integer(Int::from(2));
        inside == 0 && odd.value(&middle).is_negative() == self.leading_coefficient().is_negative()
    }
}
