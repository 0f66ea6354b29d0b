//! Products of sparse polynomials.
//!
//! Exponents are packed into one word by mixed radix, with room for the degrees of the
//! product, so that multiplying monomials is adding words and descending words are
//! descending lexicographic order. Coefficients that fit are summed in 128 bits, with the
//! bound known beforehand. Many terms in a small box go into a dense array, others into a
//! table; what does not fit takes the general way. One variable has kernels of its own.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use num_traits::Zero;

use super::multivariate::{Exponents, MultiPoly, Terms, aligned};
use super::one_variable;
use crate::budget;
use crate::math::number::Int;

/// A dense array may have this many cells for each elementary product.
const CELLS_PER_PRODUCT: u64 = 8;
const MOST_CELLS: u64 = 1 << 24;

/// a · b. Cost: one coefficient product for each pair of terms.
pub(super) fn product(a: &MultiPoly, b: &MultiPoly) -> MultiPoly {
    budget::steps(((a.len() + b.len()) / 16) as u32 + 1);
    let (vars, left, right) = aligned(a, b);
    if left.is_empty() || right.is_empty() {
        return MultiPoly::zero();
    }
    let den = if a.den == Int::ONE && b.den == Int::ONE { Int::ONE } else { &a.den * &b.den };
    if let [(e, c)] = right.as_ref() {
        return MultiPoly::from_sorted(vars, shifted(&left, e, c), den);
    }
    if let [(e, c)] = left.as_ref() {
        return MultiPoly::from_sorted(vars, shifted(&right, e, c), den);
    }
    let pairs = left.len() as u64 * right.len() as u64;
    if pairs <= 24 {
        let mut terms = Vec::with_capacity(pairs as usize);
        for (e, c) in left.iter() {
            terms.extend(shifted(&right, e, c));
        }
        return MultiPoly::from_unsorted(vars, terms, den);
    }
    if let [_] = *vars
        && let Some(terms) = one_variable::product(&left, &right)
    {
        return MultiPoly::from_sorted(vars, terms, den);
    }
    let Some(packing) = Packing::new(&left, &right, vars.len()) else {
        return MultiPoly::from_unsorted(vars, general(&left, &right), den);
    };
    let bits = |terms: &[(Exponents, Int)]| terms.iter().map(|(_, c)| c.bits()).max().unwrap_or(0);
    let shorter = left.len().min(right.len()) as u64;
    let sum_bits = bits(&left) + bits(&right) + u64::from(64 - shorter.leading_zeros());
    let words = |terms: &[(Exponents, Int)]| -> Option<Vec<(u64, i64)>> {
        terms.iter().map(|(e, c)| Some((packing.pack(e), c.as_small()?))).collect()
    };
    let small = if sum_bits < 127 { words(&left).zip(words(&right)) } else { None };
    let terms = match small {
        Some((x, y)) if packing.cells <= MOST_CELLS && packing.cells <= CELLS_PER_PRODUCT * pairs => {
            dense(&x, &y, &packing)
        }
        Some((x, y)) => table(&x, &y, &packing, |a, b| i128::from(*a) * i128::from(*b), Int::from),
        None => {
            let packed = |terms: &[(Exponents, Int)]| -> Vec<(u64, Int)> {
                terms.iter().map(|(e, c)| (packing.pack(e), c.clone())).collect()
            };
            table(&packed(&left), &packed(&right), &packing, |a: &Int, b: &Int| a * b, |c| c)
        }
    };
    MultiPoly::from_sorted(vars, terms, den)
}

/// One term times all others; the order stays.
fn shifted(terms: &[(Exponents, Int)], e: &Exponents, c: &Int) -> Terms {
    terms
        .iter()
        .map(|(exponents, d)| {
            let sum = exponents.iter().zip(e).map(|(x, y)| x.saturating_add(*y)).collect();
            (sum, d * c)
        })
        .collect()
}

fn general(left: &[(Exponents, Int)], right: &[(Exponents, Int)]) -> Terms {
    let mut sums: std::collections::BTreeMap<Exponents, Int> = std::collections::BTreeMap::new();
    for (e, c) in left {
        budget::steps(right.len() as u32);
        budget::charge_terms(sums.len() as u64);
        for (exponents, d) in shifted(right, e, c) {
            *sums.entry(exponents).or_default() += d;
        }
    }
    sums.into_iter().rev().collect()
}

/// Exponents packed into a word by mixed radix.
pub(super) struct Packing {
    /// Place value of each variable, the first one largest.
    strides: Vec<u64>,
    /// Size of the box of all exponents.
    pub(super) cells: u64,
}

impl Packing {
    /// Room for the exponents of a product; `None` if a word has too few bits.
    pub(super) fn new(
        left: &[(Exponents, Int)],
        right: &[(Exponents, Int)],
        variables: usize,
    ) -> Option<Self> {
        let degree = |terms: &[(Exponents, Int)], k: usize| terms.iter().map(|(e, _)| e[k]).max();
        let mut strides = vec![1; variables];
        let mut cells = 1u64;
        for k in (0..variables).rev() {
            strides[k] = cells;
            let top = u64::from(degree(left, k)?) + u64::from(degree(right, k)?);
            cells = cells.checked_mul(top + 1)?;
        }
        Some(Packing { strides, cells })
    }

    pub(super) fn pack(&self, e: &Exponents) -> u64 {
        e.iter().zip(&self.strides).map(|(x, stride)| u64::from(*x) * stride).sum()
    }

    pub(super) fn unpack(&self, mut key: u64) -> Exponents {
        self.strides
            .iter()
            .map(|stride| {
                let x = key / stride;
                key %= stride;
                x as u32
            })
            .collect()
    }
}

fn dense(left: &[(u64, i64)], right: &[(u64, i64)], packing: &Packing) -> Terms {
    let mut cells = vec![0i128; packing.cells as usize];
    for (key, c) in left {
        budget::steps((right.len() / 256) as u32 + 1);
        let row = &mut cells[*key as usize..];
        for (other, d) in right {
            row[*other as usize] += i128::from(*c) * i128::from(*d);
        }
    }
    let count = cells.iter().filter(|c| **c != 0).count();
    budget::charge_terms(count as u64);
    let mut terms = Vec::with_capacity(count);
    for (key, c) in cells.iter().enumerate().rev().filter(|(_, c)| **c != 0) {
        terms.push((packing.unpack(key as u64), Int::from(*c)));
    }
    terms
}

/// The sums of all products, in a table. Many products go band by band, from the largest monomials down: a table that
/// fits into the cache is faster than one for all, and there is never more in memory than the result and a band.
///
/// S. C. Johnson, "Sparse polynomial arithmetic", SIGSAM Bulletin 8 (1974), merges the rows in this order by a heap.
fn table<C, D: std::ops::AddAssign + Default>(
    left: &[(u64, C)],
    right: &[(u64, C)],
    packing: &Packing,
    multiply: impl Fn(&C, &C) -> D,
    finish: impl Fn(D) -> Int,
) -> Terms {
    let mut terms = Terms::new();
    let mut sums: HashMap<u64, D, BuildHasherDefault<WordHasher>> = HashMap::default();
    // For each row, the first product that is still to come.
    let mut next = vec![0; left.len()];
    for lowest in bands(left, right) {
        for ((key, c), next) in left.iter().zip(&mut next) {
            let rest = &right[*next..];
            let count = rest.partition_point(|(other, _)| key + other >= lowest);
            if count == 0 {
                continue;
            }
            budget::steps((count / 64) as u32 + 1);
            budget::charge_terms((terms.len() + sums.len()) as u64);
            for (other, d) in &rest[..count] {
                *sums.entry(key + other).or_default() += multiply(c, d);
            }
            *next += count;
        }
        let mut list: Vec<(u64, D)> = sums.drain().collect();
        list.sort_unstable_by_key(|(key, _)| std::cmp::Reverse(*key));
        let band = list.into_iter().map(|(key, sum)| (packing.unpack(key), finish(sum)));
        terms.extend(band.filter(|(_, c)| !c.is_zero()));
    }
    terms
}

/// The lower ends of bands of about as many products each, descending to 0.
fn bands<C>(left: &[(u64, C)], right: &[(u64, C)]) -> Vec<u64> {
    const PRODUCTS: usize = 1 << 16;
    const SAMPLES: usize = 64;
    let wanted = (left.len() * right.len()) / PRODUCTS;
    let some = |terms: &[(u64, C)]| -> Vec<u64> {
        terms.iter().step_by(terms.len().div_ceil(SAMPLES)).map(|(key, _)| *key).collect()
    };
    let (x, y) = (some(left), some(right));
    let mut sample: Vec<u64> = x.iter().flat_map(|a| y.iter().map(move |b| a + b)).collect();
    sample.sort_unstable_by_key(|key| std::cmp::Reverse(*key));
    let step = (sample.len() / (wanted + 1)).max(1);
    let mut ends: Vec<u64> = sample.into_iter().skip(step).step_by(step).take(wanted).collect();
    ends.push(0);
    ends
}

/// Multiplicative hashing of one word; the keys come from our own arithmetic.
#[derive(Default)]
struct WordHasher(u64);

impl Hasher for WordHasher {
    fn finish(&self) -> u64 {
        self.0
    }
    fn write(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.write_u64(u64::from(*byte));
        }
    }
    fn write_u64(&mut self, key: u64) {
        let mixed = (self.0 ^ key).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        self.0 = mixed ^ (mixed >> 32);
    }
}
