//! Factors of polynomials modulo word-sized primes. Entries in Montgomery form, no trailing zeros.
//!
//! Distinct degrees first, then equal degrees by random elements of a fixed sequence (D. G. Cantor,
//! H. Zassenhaus, "A new algorithm for factoring polynomials over finite fields", Math. Comp. 36, 1981).

use crate::budget;
use crate::math::number::{Int, Modulus};
use crate::math::poly::dense_modular::{gcd, remainder};

/// The image of integers.
pub(super) fn image(field: &Modulus, a: &[Int]) -> Vec<u64> {
    trimmed(a.iter().map(|x| field.enter(x.mod_word(field.p))).collect())
}

pub(super) fn trimmed(mut a: Vec<u64>) -> Vec<u64> {
    while a.last() == Some(&0) {
        a.pop();
    }
    a
}

/// The polynomial divided by its leading coefficient.
pub(super) fn monic(field: &Modulus, mut a: Vec<u64>) -> Vec<u64> {
    let Some(&lead) = a.last() else { return a };
    scale(field, &mut a, field.invert(lead));
    a
}

pub(super) fn scale(field: &Modulus, a: &mut [u64], by: u64) {
    for x in a {
        *x = field.canonical(field.mul(*x, by));
    }
}

pub(super) fn derivative(field: &Modulus, a: &[u64]) -> Vec<u64> {
    let term = |(k, &x): (usize, &u64)| field.canonical(field.mul(x, field.enter(k as u64)));
    trimmed(a.iter().enumerate().skip(1).map(term).collect())
}

pub(super) fn minus(field: &Modulus, a: &[u64], b: &[u64]) -> Vec<u64> {
    let at = |list: &[u64], k: usize| list.get(k).copied().unwrap_or(0);
    trimmed((0..a.len().max(b.len())).map(|k| field.sub(at(a, k), at(b, k))).collect())
}

pub(super) fn times(field: &Modulus, a: &[u64], b: &[u64]) -> Vec<u64> {
    if a.is_empty() || b.is_empty() {
        return Vec::new();
    }
    let mut product = vec![0; a.len() + b.len() - 1];
    for (i, &x) in a.iter().enumerate() {
        budget::step();
        for (sum, &y) in product[i..].iter_mut().zip(b) {
            *sum = field.canonical(*sum + field.canonical(field.mul(x, y)));
        }
    }
    trimmed(product)
}

/// a mod f for a monic f.
pub(super) fn reduced(field: &Modulus, mut a: Vec<u64>, f: &[u64]) -> Vec<u64> {
    remainder(field, &mut a, f);
    a
}

/// The quotient of a by a monic f that divides it.
pub(super) fn quotient(field: &Modulus, mut a: Vec<u64>, f: &[u64]) -> Vec<u64> {
    let mut quotient = vec![0; (a.len() + 1).saturating_sub(f.len())];
    for k in (0..quotient.len()).rev() {
        budget::step();
        let top = a[k + f.len() - 1];
        quotient[k] = top;
        for (x, &y) in a[k..].iter_mut().zip(f) {
            *x = field.sub(*x, field.canonical(field.mul(top, y)));
        }
    }
    quotient
}

/// a^e mod f for a monic f.
fn power(field: &Modulus, a: &[u64], mut e: u64, f: &[u64]) -> Vec<u64> {
    let mut base = reduced(field, a.to_vec(), f);
    let mut result = reduced(field, vec![field.enter(1)], f);
    while e > 0 {
        if e & 1 == 1 {
            result = reduced(field, times(field, &result, &base), f);
        }
        base = reduced(field, times(field, &base, &base), f);
        e >>= 1;
    }
    result
}

/// The b with a b = 1 mod f, for coprime a and f: Euclid's algorithm with one cofactor.
pub(super) fn inverse(field: &Modulus, a: &[u64], f: &[u64]) -> Vec<u64> {
    let (mut r0, mut r1) = (f.to_vec(), monic(field, reduced(field, a.to_vec(), f)));
    let lead = reduced(field, a.to_vec(), f).last().map_or(0, |&lead| field.invert(lead));
    let (mut s0, mut s1) = (Vec::new(), vec![lead]);
    while r1.len() > 1 {
        // r0 = q r1 + r with the monic r1; s follows.
        let rest = reduced(field, r0.clone(), &r1);
        let q = quotient(field, minus(field, &r0, &rest), &r1);
        let mut s = minus(field, &s0, &times(field, &q, &s1));
        let lead = rest.last().map_or(0, |&lead| field.invert(lead));
        scale(field, &mut s, lead);
        (r0, r1) = (r1, monic(field, rest));
        (s0, s1) = (s1, s);
    }
    reduced(field, s1, f)
}

/// a ↦ a^p modulo a monic f, which is linear: a^p = a(x^p). Its matrix takes as long as n products, a power some 120.
struct Frobenius {
    modulus: Vec<u64>,
    /// x^(p i) mod f for i = 0, …, n − 1, once it is asked for.
    rows: Vec<Vec<u64>>,
}

/// Matrices of this size still pay.
const LARGEST_MATRIX: usize = 1500;

impl Frobenius {
    /// a^p mod f for a reduced a.
    fn apply(&mut self, field: &Modulus, a: &[u64]) -> Vec<u64> {
        let size = self.modulus.len() - 1;
        if !(3..=LARGEST_MATRIX).contains(&size) {
            return power(field, a, field.p, &self.modulus);
        }
        if self.rows.is_empty() {
            budget::charge_terms((size * size) as u64 / 8);
            let step = power(field, &[0, field.enter(1)], field.p, &self.modulus);
            let mut row = vec![field.enter(1)];
            for _ in 0..size {
                let next = reduced(field, times(field, &row, &step), &self.modulus);
                self.rows.push(std::mem::replace(&mut row, next));
            }
        }
        let mut sum = vec![0; size];
        for (&c, row) in a.iter().zip(&self.rows) {
            budget::step();
            for (x, &y) in sum.iter_mut().zip(row) {
                *x = field.canonical(*x + field.canonical(field.mul(c, y)));
            }
        }
        trimmed(sum)
    }
}

/// The monic irreducible factors of a monic polynomial without repeated factors.
pub(super) fn irreducible_factors(field: &Modulus, f: Vec<u64>) -> Vec<Vec<u64>> {
    let x = vec![0, field.enter(1)];
    let mut map = Frobenius { modulus: f.clone(), rows: Vec::new() };
    let (mut rest, mut found, mut degree) = (f, Vec::new(), 0);
    let mut frobenius = x.clone();
    while rest.len() > 2 * (degree + 1) {
        degree += 1;
        // x^(p^degree) mod f, whose gcd with x is made of the factors whose degree divides it.
        frobenius = map.apply(field, &frobenius);
        let difference = reduced(field, minus(field, &frobenius, &x), &rest);
        let product = if difference.is_empty() { rest.clone() } else { gcd(field, rest.clone(), difference) };
        if product.len() > 1 {
            rest = quotient(field, rest, &product);
            equal_degrees(field, product, degree, &mut map, &mut found);
        }
    }
    if rest.len() > 1 {
        found.push(rest);
    }
    found
}

/// Splits a product of irreducible factors of one degree.
fn equal_degrees(
    field: &Modulus,
    f: Vec<u64>,
    degree: usize,
    map: &mut Frobenius,
    found: &mut Vec<Vec<u64>>,
) {
    let one = field.enter(1);
    let mut seed = 0;
    let mut open = vec![f];
    while let Some(f) = open.pop() {
        if f.len() == degree + 1 {
            found.push(f);
            continue;
        }
        // A random r; r^((p^degree - 1)/2) is 1 modulo about half of the factors.
        let r = trimmed((1..f.len()).map(|_| field.enter(random(&mut seed) % field.p)).collect());
        let (mut norm, mut conjugate) = (r.clone(), r);
        for _ in 1..degree {
            conjugate = reduced(field, map.apply(field, &conjugate), &f);
            norm = reduced(field, times(field, &norm, &conjugate), &f);
        }
        let half = minus(field, &power(field, &norm, (field.p - 1) / 2, &f), &[one]);
        let part = if half.is_empty() { f.clone() } else { gcd(field, f.clone(), half) };
        if part.len() > 1 && part.len() < f.len() {
            open.push(quotient(field, f, &part));
            open.push(part);
        } else {
            open.push(f);
        }
    }
}

/// The next of a fixed sequence of numbers without visible order (G. L. Steele and others, "Fast splittable
/// pseudorandom number generators", OOPSLA 2014).
pub(super) fn random(seed: &mut u64) -> u64 {
    *seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *seed;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
