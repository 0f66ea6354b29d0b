//! Greatest common divisors of polynomials modulo word-sized primes; residues in Montgomery form.

use crate::budget;

pub(super) use crate::math::number::{Modulus, primes};

/// The monic greatest common divisor of two polynomials modulo p.
///
/// Entries in Montgomery form, no trailing zeros, not both empty. Euclid's
/// algorithm; cost O(deg a · deg b).
pub(super) fn gcd(field: &Modulus, mut a: Vec<u64>, mut b: Vec<u64>) -> Vec<u64> {
    while !b.is_empty() {
        remainder(field, &mut a, &b);
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
