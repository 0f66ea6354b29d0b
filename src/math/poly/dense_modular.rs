//! Greatest common divisors of polynomials modulo word-sized primes; residues in Montgomery form.

use crate::budget;

pub(super) use crate::math::number::{Modulus, primes};

/// The monic greatest common divisor of two polynomials modulo p.
///
/// Entries in Montgomery form, no trailing zeros, not both empty. Euclid's
/// algorithm; cost O(deg a · deg b).
pub(super) fn gcd(field: &Modulus, mut a: Vec<u64>, mut b: Vec<u64>) -> Vec<u64> {
    while !b.is_empty() {
        if b.len() > 1 && a.len() == b.len() + 1 {
            remainder_by_one_less(field, &mut a, &b);
        } else {
            remainder(field, &mut a, &b);
        }
        std::mem::swap(&mut a, &mut b);
    }
    if let Some(&lead) = a.last() {
        let scale = field.invert(lead);
        for x in &mut a {
            *x = field.canonical(field.mul(*x, scale));
        }
    }
    a
}

/// Below this length of the divisor an inverse costs more than to scale the dividend.
const SHORT: usize = 32;

/// Replaces a by a mod b, times a constant, which is 1 if b is monic; b is not empty.
pub(super) fn remainder(field: &Modulus, a: &mut Vec<u64>, b: &[u64]) {
    if b.len() < SHORT {
        return scaled_remainder(field, a, b);
    }
    let inverse = field.invert(b[b.len() - 1]);
    while a.len() >= b.len() {
        budget::steps(1 + (b.len() / 256) as u32);
        let factor = field.canonical(field.mul(a[a.len() - 1], inverse));
        let offset = a.len() - b.len();
        for (x, &y) in a[offset..].iter_mut().zip(b) {
            *x = field.sub(*x, field.canonical(field.mul(y, factor)));
        }
        while a.last() == Some(&0) {
            a.pop();
        }
    }
}

/// Replaces a by a mod b, times a constant, for deg a = deg b + 1 ≥ 2: what nearly every step of Euclid's algorithm
/// does. Both steps of the division are taken in one pass, with one reduction for each entry and without an inverse:
/// l² a − (l α t + β) b, where l = lead(b), α = lead(a), and β makes the next coefficient vanish.
fn remainder_by_one_less(field: &Modulus, a: &mut Vec<u64>, b: &[u64]) {
    budget::steps(1 + (b.len() / 256) as u32);
    let (m, lead) = (b.len(), b[b.len() - 1]);
    let minus = |x: u64| field.canonical(field.p - field.canonical(x));
    let square = field.canonical(field.mul(lead, lead));
    let minus_alpha = minus(a[m]);
    let alpha_lead = field.canonical(field.mul(minus_alpha, lead));
    // β = l a_{m−1} − α b_{m−2}, as a sum of two products.
    let beta = field
        .reduce(u128::from(lead) * u128::from(a[m - 1]) + u128::from(minus_alpha) * u128::from(b[m - 2]));
    let minus_beta = minus(beta);
    a.truncate(m - 1);
    let mut lower = 0;
    for (x, &y) in a.iter_mut().zip(b) {
        // Below 3p² < p·2^64, so one reduction is enough.
        let sum = u128::from(*x) * u128::from(square)
            + u128::from(lower) * u128::from(alpha_lead)
            + u128::from(y) * u128::from(minus_beta);
        *x = field.canonical(field.reduce(sum));
        lower = y;
    }
    while a.last() == Some(&0) {
        a.pop();
    }
}

/// [`remainder`] without an inverse.
fn scaled_remainder(field: &Modulus, a: &mut Vec<u64>, b: &[u64]) {
    let Some((&lead, rest)) = b.split_last() else { return };
    while a.len() >= b.len() {
        budget::step();
        let Some(top) = a.pop() else { return };
        let minus_top = field.sub(0, top);
        let offset = a.len() - rest.len();
        for x in &mut a[..offset] {
            *x = field.canonical(field.mul(*x, lead));
        }
        for (x, &y) in a[offset..].iter_mut().zip(rest) {
            // Below 2p², so one reduction is enough.
            let sum = u128::from(*x) * u128::from(lead) + u128::from(y) * u128::from(minus_top);
            *x = field.canonical(field.reduce(sum));
        }
        while a.last() == Some(&0) {
            a.pop();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const FIELD: Modulus = Modulus::new((1 << 62) - 57);

    /// Entries near both ends of the field, and often 0, so that degrees drop by more than one.
    fn polynomial(longest: usize) -> impl Strategy<Value = Vec<u64>> {
        let entry = prop_oneof![
            2 => Just(0),
            2 => 1u64..4,
            1 => FIELD.p - 3..FIELD.p,
            3 => 0..FIELD.p,
        ];
        prop::collection::vec(entry, 1..longest).prop_map(trimmed)
    }

    fn trimmed(mut a: Vec<u64>) -> Vec<u64> {
        while a.last() == Some(&0) {
            a.pop();
        }
        a
    }

    fn times(a: &[u64], b: &[u64]) -> Vec<u64> {
        let mut product = vec![0; (a.len() + b.len()).saturating_sub(1)];
        for (i, &x) in a.iter().enumerate() {
            for (j, &y) in b.iter().enumerate() {
                product[i + j] = FIELD.canonical(product[i + j] + FIELD.canonical(FIELD.mul(x, y)));
            }
        }
        trimmed(product)
    }

    /// Euclid's algorithm by whole divisions with an inverse.
    fn plain(mut a: Vec<u64>, mut b: Vec<u64>) -> Vec<u64> {
        while let Some(&lead) = b.last() {
            let inverse = FIELD.invert(lead);
            while a.len() >= b.len() {
                let (offset, top) = (a.len() - b.len(), a[a.len() - 1]);
                let factor = FIELD.canonical(FIELD.mul(top, inverse));
                for (x, &y) in a[offset..].iter_mut().zip(&b) {
                    *x = FIELD.sub(*x, FIELD.canonical(FIELD.mul(y, factor)));
                }
                a = trimmed(a);
            }
            std::mem::swap(&mut a, &mut b);
        }
        a
    }

    fn monic(a: &[u64]) -> Vec<u64> {
        let scale = a.last().map_or(0, |&lead| FIELD.invert(lead));
        a.iter().map(|&x| FIELD.canonical(FIELD.mul(x, scale))).collect()
    }

    proptest! {
        #[test]
        fn gcds_agree_with_plain_divisions(f in polynomial(50), g in polynomial(50), c in polynomial(12)) {
            let (a, b) = (times(&f, &c), times(&g, &c));
            prop_assume!(!a.is_empty() || !b.is_empty());
            let found = gcd(&FIELD, a.clone(), b.clone());
            prop_assert_eq!(&found, &monic(&plain(a.clone(), b.clone())));
            prop_assert_eq!(gcd(&FIELD, b, a), found);
        }
    }
}
