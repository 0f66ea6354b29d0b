//! Bernstein coefficients as integers, up to one positive factor.
//!
//! Over [l, u] let F = Σ b_i B_i^n. Then b_i = Σ_k C(i, k)/C(n, k) c_k for F(l + (u − l) s) = Σ c_k s^k, and the coefficients over
//! the two halves are the ends of de Casteljau's scheme for s = 1/2.
//!
//! G. Farin, "Curves and Surfaces for CAGD", chapters 4 and 5.

use num_integer::Integer;
use num_traits::Signed;

use crate::budget;
use crate::math::number::{Int, Rational, factorial};
use crate::math::poly::{dense, dense_compose};

/// A positive multiple of the Bernstein coefficients of F over [l, u], for a degree n of at least 0.
///
/// Cost: a Taylor shift, and n²/2 additions of numbers that grow by n log n bits.
pub(super) fn over(f: &[Int], lower: &Rational, upper: &Rational) -> Vec<Int> {
    let n = f.len() - 1;
    let width = upper - lower;
    let den = lower.denom().lcm(width.denom());
    let over_den = |q: &Rational| q.numer() * den.div_exact(q.denom());
    let mut list = dense_compose::composed(f, &[over_den(lower), over_den(&width)], &den);
    list.resize(n + 1, Int::ZERO);
    // n! c_k/C(n, k) = k! (n − k)! c_k
    let mut share = factorial(n);
    for (k, c) in list.iter_mut().enumerate() {
        *c *= &share;
        if k < n {
            share = (share * Int::from(k + 1)).div_exact(&Int::from(n - k));
        }
    }
    // Σ_k C(i, k) e_k by Pascal's rule.
    for start in 1..=n {
        budget::steps(1 + (n / 32) as u32);
        for i in (start..=n).rev() {
            let (low, high) = list.split_at_mut(i);
            high[0] += &low[i - 1];
        }
    }
    dense::primitive(list)
}

/// The coefficients over both halves of the interval, up to one positive factor.
///
/// Cost: n²/2 additions of numbers that grow by n bits.
pub(super) fn halves(list: &[Int]) -> (Vec<Int>, Vec<Int>) {
    let n = list.len() - 1;
    let mut row = list.to_vec();
    let (mut left, mut right) = (Vec::with_capacity(n + 1), vec![Int::ZERO; n + 1]);
    // Level r has the factor 2^r, and gets 2^{n − r}.
    let mut scale = Int::from(2).pow(n as u32);
    for r in 0..=n {
        budget::steps(1 + (n / 32) as u32);
        left.push(&row[0] * &scale);
        right[n - r] = &row[n - r] * &scale;
        for i in 0..n - r {
            let (low, high) = row.split_at_mut(i + 1);
            low[i] += &high[0];
        }
        scale = scale.div_floor(&Int::from(2));
    }
    (dense::primitive(left), dense::primitive(right))
}

/// How often the signs change from one coefficient to the next, zeros left out.
pub fn sign_changes<'a, N: Signed + 'a>(list: impl IntoIterator<Item = &'a N>) -> usize {
    let mut previous = false;
    let mut changes = 0;
    for (k, x) in list.into_iter().filter(|x| !x.is_zero()).enumerate() {
        changes += usize::from(k > 0 && x.is_negative() != previous);
        previous = x.is_negative();
    }
    changes
}
