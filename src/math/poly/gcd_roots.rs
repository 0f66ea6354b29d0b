//! From the values of a sparse polynomial at a geometric sequence of points to its terms.
//!
//! At the points ω^0, ω^1, ω^2, … the polynomial Σ c_i x^{e_i} has the values s_j = Σ c_i r_i^j with
//! r_i = ω^{e_i}. They satisfy a linear recurrence whose characteristic polynomial has the roots r_i;
//! [`Recurrence`] finds it, [`logarithms`] its roots as powers of ω, and [`weights`] the c_i.
//! All residues are in Montgomery form and below p.
//!
//! M. Ben-Or, P. Tiwari, "A deterministic algorithm for sparse multivariate polynomial
//! interpolation", STOC 1988; J. L. Massey, IEEE Trans. Inf. Theory 15 (1969).

use super::dense_modular::Modulus;
use crate::budget;

fn times(field: &Modulus, x: u64, y: u64) -> u64 {
    field.canonical(field.mul(x, y))
}

/// The shortest linear recurrence of a sequence, by the algorithm of Berlekamp and Massey.
pub(super) struct Recurrence {
    /// The values so far, the latest last.
    values: Vec<u64>,
    /// 1 + c_1 z + … + c_L z^L with s_n + c_1 s_{n−1} + … + c_L s_{n−L} = 0.
    connection: Vec<u64>,
    /// The connection polynomial before the length last changed, times the inverse of its discrepancy.
    before: Vec<u64>,
    /// Values since then, that one included.
    gap: usize,
    length: usize,
}

impl Recurrence {
    pub fn new(field: &Modulus) -> Self {
        let one = vec![field.enter(1)];
        Recurrence { values: Vec::new(), connection: one.clone(), before: one, gap: 1, length: 0 }
    }

    /// The next value of the sequence. Cost: O(L).
    pub fn push(&mut self, field: &Modulus, value: u64) {
        self.values.push(value);
        let recent = self.values.iter().rev();
        let discrepancy = self.connection.iter().zip(recent).fold(0, |sum, (c, s)| {
            let sum = sum + times(field, *c, *s);
            field.canonical(sum)
        });
        if discrepancy == 0 {
            self.gap += 1;
            return;
        }
        let longer = 2 * self.length < self.values.len();
        let old = longer.then(|| self.connection.clone());
        self.connection.resize(self.connection.len().max(self.before.len() + self.gap), 0);
        for (c, b) in self.connection[self.gap..].iter_mut().zip(&self.before) {
            *c = field.sub(*c, times(field, discrepancy, *b));
        }
        self.gap += 1;
        if let Some(mut old) = old {
            let inverse = field.invert(discrepancy);
            old.iter_mut().for_each(|c| *c = times(field, *c, inverse));
            self.before = old;
            self.length = self.values.len() - self.length;
            self.gap = 1;
        }
    }

    /// Whether two more values than a recurrence of this length needs have confirmed it.
    pub fn is_settled(&self) -> bool {
        self.values.len() >= 2 * self.length + 2
    }

    pub fn values(&self) -> &[u64] {
        &self.values
    }

    /// The monic polynomial with the roots r_i, the constant coefficient first.
    pub fn characteristic(&self) -> Vec<u64> {
        let mut polynomial: Vec<u64> = self.connection.clone();
        polynomial.resize(self.length + 1, 0);
        polynomial.reverse();
        polynomial
    }
}

/// e_1, e_2, … in 0..2^k with f = ∏ (x − ω^{e_i}), for monic f and ω of order 2^k; `None` if f has
/// other roots or multiple ones.
///
/// One bit after the other: the roots with the next bit 0 have a known power. Cost: O(k d²) products
/// for each level at which roots part, of which there are at most k, for degree d.
pub(super) fn logarithms(field: &Modulus, f: Vec<u64>, omega: u64, k: u32) -> Option<Vec<u64>> {
    // x^(2^i) modulo f
    let mut powers = Vec::with_capacity(k as usize);
    let mut power = remainder(field, vec![0, field.enter(1)], &f);
    for _ in 0..k {
        budget::steps(1 + (f.len() * f.len() / 512) as u32);
        let square = remainder(field, product(field, &power, &power), &f);
        powers.push(std::mem::replace(&mut power, square));
    }
    if f.len() > 1 && power != [field.enter(1)] {
        return None;
    }
    let mut found = Vec::with_capacity(f.len() - 1);
    split(field, Part { f, powers, bits: 0, low: 0 }, omega, k, &mut found)?;
    Some(found)
}

/// A factor f whose roots are ω^e with e ≡ low modulo 2^bits.
struct Part {
    f: Vec<u64>,
    /// x^(2^i) modulo f, for i < k − bits.
    powers: Vec<Vec<u64>>,
    bits: u32,
    low: u64,
}

fn split(field: &Modulus, mut part: Part, omega: u64, k: u32, found: &mut Vec<u64>) -> Option<()> {
    while part.f.len() > 1 && part.bits < k {
        budget::steps(1 + (part.f.len() * part.f.len() / 512) as u32);
        let mut power = part.powers.pop()?;
        let zero_bit = field.pow(omega, part.low << (k - 1 - part.bits));
        if power.is_empty() {
            return None; // 0 is no power of ω
        }
        power[0] = field.sub(power[0], zero_bit);
        trim(&mut power);
        let zeros = super::dense_modular::gcd(field, part.f.clone(), power);
        let one = part.low | 1 << part.bits;
        part.bits += 1;
        if zeros.len() == 1 {
            part.low = one;
        } else if zeros.len() < part.f.len() {
            let ones = quotient(field, part.f, &zeros);
            let reduced = |f: &[u64]| part.powers.iter().map(|p| remainder(field, p.clone(), f)).collect();
            let other = Part { powers: reduced(&ones), f: ones, bits: part.bits, low: one };
            part.powers = reduced(&zeros);
            part.f = zeros;
            split(field, other, omega, k, found)?;
        }
    }
    match part.f.len() {
        1 => Some(()),
        2 => {
            found.push(part.low);
            Some(())
        }
        _ => None,
    }
}

/// The c_i with s_j = Σ c_i r_i^j for j = 0, …, d − 1, for d distinct r_i ≠ 0; `None` if two agree.
///
/// A transposed Vandermonde system. Cost: O(d²). R. Zippel, "Interpolating polynomials from their
/// values", J. Symb. Comp. 9 (1990).
pub(super) fn weights(field: &Modulus, roots: &[u64], values: &[u64]) -> Option<Vec<u64>> {
    let mut all = vec![field.enter(1)];
    for r in roots {
        // all · (x − r)
        budget::steps(1 + (all.len() / 64) as u32);
        all.push(0);
        for k in (0..all.len()).rev() {
            let lower = if k > 0 { all[k - 1] } else { 0 };
            all[k] = field.sub(lower, times(field, all[k], *r));
        }
    }
    roots
        .iter()
        .map(|r| {
            budget::steps(1 + (all.len() / 64) as u32);
            // q = all/(x − r), from the top; Σ q_j s_j = c q(r).
            let (mut q, mut at_r, mut sum) = (0, 0, 0);
            for k in (0..roots.len()).rev() {
                q = field.canonical(all[k + 1] + times(field, q, *r));
                at_r = field.canonical(times(field, at_r, *r) + q);
                sum = field.canonical(sum + times(field, q, values[k]));
            }
            (at_r != 0).then(|| times(field, sum, field.invert(at_r)))
        })
        .collect()
}

fn trim(a: &mut Vec<u64>) {
    while a.last() == Some(&0) {
        a.pop();
    }
}

fn product(field: &Modulus, a: &[u64], b: &[u64]) -> Vec<u64> {
    let mut out = vec![0; (a.len() + b.len()).saturating_sub(1)];
    for (i, x) in a.iter().enumerate() {
        for (cell, y) in out[i..].iter_mut().zip(b) {
            *cell = field.canonical(*cell + times(field, *x, *y));
        }
    }
    out
}

/// a modulo the monic f.
fn remainder(field: &Modulus, mut a: Vec<u64>, f: &[u64]) -> Vec<u64> {
    divide(field, &mut a, f);
    a.truncate(f.len() - 1);
    trim(&mut a);
    a
}

/// a / f for a monic divisor f.
fn quotient(field: &Modulus, mut a: Vec<u64>, f: &[u64]) -> Vec<u64> {
    divide(field, &mut a, f);
    a.drain(..f.len() - 1);
    a
}

/// Leaves the remainder in the lower and the quotient in the upper entries.
fn divide(field: &Modulus, a: &mut [u64], f: &[u64]) {
    let d = f.len() - 1;
    for k in (d..a.len()).rev() {
        let top = a[k];
        if top != 0 {
            for (x, y) in a[k - d..k].iter_mut().zip(f) {
                *x = field.sub(*x, times(field, top, *y));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::poly::gcd_modular::{field_with_roots, root_of_order};
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    proptest! {
        #[test]
        fn terms_are_found_again(
            list in prop::collection::btree_map(0u64..1 << 20, 1u64..1 << 61, 0..20), extra in 0u32..20,
        ) {
            let field = field_with_roots(0);
            let k = 20 + extra;
            let omega = root_of_order(0, k);
            let terms: Vec<(u64, u64)> = list.iter().map(|(e, c)| (*e, field.enter(*c))).collect();
            let mut recurrence = Recurrence::new(&field);
            for j in 0.. {
                if recurrence.is_settled() && j > 2 * terms.len() {
                    break;
                }
                let value = terms.iter().fold(0, |sum, (e, c)| {
                    field.canonical(sum + times(&field, *c, field.pow(omega, e * j as u64)))
                });
                recurrence.push(&field, value);
            }
            let logs = logarithms(&field, recurrence.characteristic(), omega, k).unwrap();
            let roots: Vec<u64> = logs.iter().map(|e| field.pow(omega, *e)).collect();
            let c = weights(&field, &roots, recurrence.values()).unwrap();
            let found: BTreeMap<u64, u64> =
                logs.into_iter().zip(c).map(|(e, c)| (e, field.leave(c))).collect();
            prop_assert_eq!(found, list);
        }
    }

    #[test]
    fn other_roots_are_refused() {
        let field = field_with_roots(1);
        let omega = root_of_order(1, 8);
        let linear = |root: u64| vec![field.sub(0, root), field.enter(1)];
        let (three, eight) = (field.pow(omega, 3), field.pow(omega, 8));
        assert_eq!(logarithms(&field, linear(three), omega, 8), Some(vec![3]));
        assert_eq!(logarithms(&field, linear(field.enter(3)), omega, 8), None);
        assert_eq!(logarithms(&field, linear(0), omega, 8), None);
        let twice = product(&field, &linear(eight), &linear(eight));
        assert_eq!(logarithms(&field, twice, omega, 8), None);
        assert_eq!(logarithms(&field, vec![field.enter(1)], omega, 8), Some(vec![]));
        assert_eq!(weights(&field, &[three, three], &[1, 1]), None);
    }
}
