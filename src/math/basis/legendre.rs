//! Legendre polynomials of the interval [0, 1] in powers, and back.
//!
//! L_j(s) = P_j(2s − 1) = Σ_k (−1)^{j+k} C(j,k) C(j+k,k) s^k, and
//! s^k = Σ_j (2j+1) k!²/((k−j)! (k+j+1)!) L_j(s).

use nalgebra::DMatrix;

use crate::budget;
use crate::math::number::{Int, Rational, binomial_row};
use crate::math::ring::Ring;

/// P_0(x), …, P_n(x) on [−1, 1], by (j+1) P_{j+1} = (2j+1) x P_j − j P_{j−1}. Cost: 2n products.
///
/// ```
/// use polarform::{basis::legendre_all, number::{integer as z, rational as q}};
/// assert_eq!(legendre_all(2, &q(1, 3)), [z(1), q(1, 3), q(-1, 3)]);
/// ```
pub fn legendre_all<C: Ring>(n: usize, x: &C) -> Vec<C> {
    budget::charge_terms(n as u64);
    let mut values = vec![C::one()];
    for j in 0..n {
        budget::step();
        let next = Int::from(j + 1);
        let ahead = x.times(&values[j]).scaled(&Rational::new(Int::from(2 * j + 1), next.clone()));
        values.push(match j {
            0 => ahead,
            _ => ahead.minus(&values[j - 1].scaled(&Rational::new(Int::from(j), next))),
        });
    }
    values
}

/// The coefficients of L_0, …, L_n in powers of s, one column for each. Cost: n² products.
pub(super) fn legendre_to_power(n: usize) -> DMatrix<Rational> {
    let mut matrix = DMatrix::zeros(n + 1, n + 1);
    for j in 0..=n {
        let row = binomial_row(j);
        // C(j+k, k)
        let mut rising = Int::ONE;
        for (k, binomial) in row.iter().enumerate() {
            budget::step();
            let value = binomial * &rising;
            matrix[(k, j)] = Rational::from_integer(if (j + k).is_multiple_of(2) { value } else { -value });
            rising = (rising * Int::from(j + k + 1)).div_exact(&Int::from(k + 1));
        }
    }
    matrix
}

/// The inverse: the coefficients of 1, s, …, s^n in L_0, …, L_n, one column for each. Cost: n² products.
pub(super) fn power_to_legendre(n: usize) -> DMatrix<Rational> {
    let mut matrix = DMatrix::zeros(n + 1, n + 1);
    for k in 0..=n {
        // k!²/((k−j)! (k+j+1)!), from 1/(k+1) on
        let mut share = Rational::new(Int::ONE, Int::from(k + 1));
        for j in 0..=k {
            budget::step();
            matrix[(j, k)] = &share * Rational::from_integer(Int::from(2 * j + 1));
            share *= Rational::new(Int::from(k - j), Int::from(k + j + 2));
        }
    }
    matrix
}
