//! Real roots of [`Poly`] in an interval, counted exactly by Sturm's theorem.
//!
//! For a square-free P let P_0 = P, P_1 = P', P_{k+1} = −(P_{k−1} mod P_k), up to
//! positive factors, and V(x) the number of changes of sign in P_0(x), P_1(x), …
//! with zeros left out. The number of roots in (a, b] is V(a) − V(b).
//!
//! S. Basu, R. Pollack, M.-F. Roy, "Algorithms in Real Algebraic Geometry", section 2.2.2.

use num_integer::Integer;
use num_traits::Signed;

use super::bernstein;
use crate::math::interval::Interval;
use crate::math::number::{Int, Rational};
use crate::math::poly::{Poly, dense, dense_compose, dense_divide};

/// Integer multiples of the polynomials of a Sturm sequence.
struct Sturm(Vec<Vec<Int>>);

/// Sturm's chain of a polynomial that is not constant, up to positive factors.
fn chain(first: Vec<Int>) -> Vec<Vec<Int>> {
    let mut last = dense::primitive(dense::derivative(&first));
    let mut chain = vec![dense::primitive(first)];
    while !last.is_empty() {
        let division = dense_divide::pseudo_division(&chain[chain.len() - 1], &last);
        let next = dense::negated(&dense::primitive(division.remainder));
        chain.push(std::mem::replace(&mut last, next));
    }
    chain
}

impl Sturm {
    /// The sequence of a square-free polynomial that is not 0.
    fn new(square_free: &Poly) -> Sturm {
        Sturm(chain(square_free.numerators().to_vec()))
    }

    /// V(x)
    fn sign_changes(&self, x: &Rational) -> usize {
        let value = |p: &Vec<Int>| dense_compose::homogeneous_value(p, x.numer(), x.denom());
        bernstein::sign_changes(&self.0.iter().map(value).collect::<Vec<_>>())
    }

    /// V at infinity or, with `negative`, at minus infinity.
    fn sign_changes_at_infinity(&self, negative: bool) -> usize {
        let sign = |p: &Vec<Int>| {
            let sign = p.last()?.signum();
            Some(if negative && p.len().is_even() { -sign } else { sign })
        };
        bernstein::sign_changes(&self.0.iter().filter_map(sign).collect::<Vec<_>>())
    }
}

impl Poly {
    /// Sturm's chain P_0 = F, P_1 = F', P_{k+1} = −(P_{k−1} mod P_k) up to the last that is not 0, where from P_2 on
    /// positive factors are left out, so that the coefficients are coprime integers. Empty for 0.
    ///
    /// The last polynomial is gcd(F, F') up to a factor. If neither F(a) nor F(b) is 0, the number of different
    /// roots between a and b is the number of changes of sign that the chain has more at a than at b.
    ///
    /// Cost: as for counting roots.
    ///
    /// ```
    /// # use polarform::poly::Poly;
    /// let t = Poly::variable();
    /// let chain = (t.pow(3) - &t).sturm_chain();
    /// let shown: Vec<String> = chain.iter().map(|p| p.to_string()).collect();
    /// assert_eq!(shown, ["t^3 - t", "3 t^2 - 1", "t", "1"]);
    /// ```
    pub fn sturm_chain(&self) -> Vec<Poly> {
        if self.degree().is_none_or(|n| n == 0) {
            return if self.is_zero() { Vec::new() } else { vec![self.clone()] };
        }
        let rest = chain(self.numerators().to_vec()).into_iter().skip(2);
        let rest = rest.map(|p| Poly::from_integers(p, Int::ONE));
        [self.clone(), self.derivative()].into_iter().chain(rest).collect()
    }

    /// The number of distinct real roots in the half-open interval (a, b]; 0 if a > b.
    /// `None` for the zero polynomial, of which every number is a root.
    ///
    /// Cost: a remainder sequence, O(n²) products of integers of up to O(n) times the bits
    /// of the coefficients.
    ///
    /// ```
    /// # use polarform::{interval::Interval, number::integer, poly::Poly};
    /// let f = Poly::variable().pow(2) - Poly::from(4);
    /// assert_eq!(f.count_roots(&Interval::new(integer(-2), integer(2))?), Some(1));
    /// assert_eq!(f.count_roots(&Interval::new(integer(-3), integer(2))?), Some(2));
    /// # Ok::<(), polarform::interval::EmptyInterval>(())
    /// ```
    pub fn count_roots(&self, interval: &Interval<Rational>) -> Option<usize> {
        let (a, b) = interval.ends();
        let degree = self.degree()?;
        if degree == 0 || a > b {
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
}
