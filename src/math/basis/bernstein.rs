//! Values of the Bernstein polynomials on [0, 1].

use crate::budget;
use crate::math::number::{Int, Rational, binomial, binomial_row, multinomial};
use crate::math::ring::Ring;

/// B_i^n(t) = C(n,i) t^i (1−t)^{n−i}; 0 when i > n. Cost: O(log n) products.
///
/// ```
/// use polarform::{basis::bernstein, number::rational};
/// assert_eq!(bernstein(3, 1, &rational(1, 2)), rational(3, 8));
/// assert_eq!(bernstein(3, 4, &rational(1, 2)), rational(0, 1));
/// ```
pub fn bernstein<C: Ring>(n: usize, i: usize, t: &C) -> C {
    if i > n {
        return C::zero();
    }
    // C(n, i) ≥ 2^min(i, n−i), and the denominator of the powers is that of t^n.
    budget::charge_bits(i.min(n - i) as u64);
    if let Some(q) = t.as_rational() {
        budget::charge_bits((q.denom().bits() - 1).saturating_mul(n as u64));
    }
    let product = num_traits::pow(t.clone(), i).times(&num_traits::pow(C::one().minus(t), n - i));
    product.scaled(&Rational::from_integer(binomial(n, i)))
}

/// B_0^n(t), …, B_n^n(t); their sum is 1. Cost: 4n products.
///
/// ```
/// use polarform::{basis::bernstein_all, number::rational};
/// let t = rational(1, 3);
/// assert_eq!(bernstein_all(2, &t), [rational(4, 9), rational(4, 9), rational(1, 9)]);
/// ```
pub fn bernstein_all<C: Ring>(n: usize, t: &C) -> Vec<C> {
    budget::charge_terms(n as u64);
    let rest = powers(n, &C::one().minus(t));
    let weights = binomial_row(n);
    let weigh = |weight: Int, x: C| x.scaled(&Rational::from_integer(weight));
    powers(n, t)
        .iter()
        .zip(rest.iter().rev())
        .zip(weights)
        .map(|((left, right), weight)| weigh(weight, left.times(right)))
        .collect()
}

/// n!/(i! j! k! …) u^i v^j w^k …, the Bernstein polynomial over a simplex at barycentric coordinates, for indices that add up
/// to n. Cost: O(log n) products for each index.
///
/// ```
/// use polarform::{basis::bernstein_simplex, number::rational as q};
/// assert_eq!(bernstein_simplex(&[1, 0, 1], &[q(1, 2), q(1, 3), q(1, 6)]), q(1, 6));
/// ```
pub fn bernstein_simplex<C: Ring>(indices: &[usize], at: &[C]) -> C {
    let weight = C::from_rational(&Rational::from_integer(multinomial(indices)));
    indices.iter().zip(at).fold(weight, |product, (&i, x)| product.times(&num_traits::pow(x.clone(), i)))
}

/// 1, x, …, x^n.
pub(super) fn powers<C: Ring>(n: usize, x: &C) -> Vec<C> {
    let mut list = Vec::with_capacity(n + 1);
    let mut power = C::one();
    for _ in 0..n {
        budget::step();
        let following = power.times(x);
        list.push(power);
        power = following;
    }
    list.push(power);
    list
}
