//! Kernels on dense integer vectors: the polynomial Σ a_k t^k is the slice a.
//!
//! **Canonical form.** No trailing zero; the zero polynomial is the empty vector.
//! Every function here takes and returns vectors in this form.
//!
//! [`product`] picks its method by size: sums of word products while the entries
//! are words, schoolbook on big integers for few entries, number-theoretic
//! transforms (see `dense_ntt`) otherwise. The thresholds were measured.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::dense_ntt::{self, Plan};
use crate::budget;
use crate::math::number::Int;

/// Drops trailing zeros.
pub(super) fn trim(a: &mut Vec<Int>) {
    while a.last().is_some_and(Zero::is_zero) {
        a.pop();
    }
}

/// The number of bits of the largest entry in size; 0 for the zero polynomial.
pub(super) fn height_bits(a: &[Int]) -> u64 {
    a.iter().map(Int::bits).max().unwrap_or(0)
}

/// a + b
pub(super) fn sum(a: &[Int], b: &[Int]) -> Vec<Int> {
    let (long, short) = if a.len() >= b.len() { (a, b) } else { (b, a) };
    let mut out: Vec<Int> = long.iter().zip(short).map(|(x, y)| x + y).collect();
    out.extend_from_slice(&long[short.len()..]);
    trim(&mut out);
    out
}

/// −a
pub(super) fn negated(a: &[Int]) -> Vec<Int> {
    a.iter().map(|x| -x).collect()
}

/// c·a
pub(super) fn scaled(a: &[Int], c: &Int) -> Vec<Int> {
    if c.is_one() {
        return a.to_vec();
    }
    if c.is_zero() {
        return Vec::new();
    }
    a.iter().map(|x| x * c).collect()
}

/// a / c where c divides every entry.
pub(super) fn divided(mut a: Vec<Int>, c: &Int) -> Vec<Int> {
    if !c.is_one() {
        for x in &mut a {
            *x = x.div_exact(c);
        }
    }
    a
}

/// The greatest common divisor of `start` and all entries, not negative.
///
/// Looks at no more entries once it is 1, and takes a gcd only for an entry that
/// the divisor found so far does not divide.
pub(super) fn common_divisor<'a>(start: &Int, a: impl IntoIterator<Item = &'a Int>) -> Int {
    let mut divisor = start.abs();
    for x in a {
        if divisor.is_one() {
            break;
        }
        if divisor.is_zero() {
            divisor = x.abs();
            continue;
        }
        let rest = x % &divisor;
        if !rest.is_zero() {
            divisor = divisor.gcd(&rest);
        }
    }
    divisor
}

/// The greatest common divisor of the entries, not negative.
pub(super) fn content(a: &[Int]) -> Int {
    // The end coefficients are the likeliest to share little.
    let end = a.last().cloned().unwrap_or(Int::ZERO);
    common_divisor(&end, a)
}

/// a / content(a), with the sign of a.
pub(super) fn primitive(a: Vec<Int>) -> Vec<Int> {
    let divisor = content(&a);
    if divisor.is_zero() { a } else { divided(a, &divisor) }
}

/// Σ k a_k t^{k−1}
pub(super) fn derivative(a: &[Int]) -> Vec<Int> {
    a.iter().enumerate().skip(1).map(|(k, x)| x * Int::from(k)).collect()
}

/// a·b. Cost: O(N log N) word operations for N words in all once both are large.
pub(super) fn product(a: &[Int], b: &[Int]) -> Vec<Int> {
    let (Some(first), Some(second)) = (a.first(), b.first()) else {
        return Vec::new();
    };
    if a.len() == 1 {
        return scaled(b, first);
    }
    if b.len() == 1 {
        return scaled(a, second);
    }
    budget::charge_terms((a.len() + b.len() - 1) as u64);
    let (bits_a, bits_b) = (height_bits(a), height_bits(b));
    let pairs = a.len() as u64 * b.len() as u64;
    let sum_bits = bits_a + bits_b + u64::from(usize::BITS - a.len().min(b.len()).leading_zeros());
    let words = bits_a <= 63 && bits_b <= 63 && sum_bits <= 127;
    let school_cost =
        if words { word_cost(a.len(), b.len()) } else { big_pair_cost(bits_a, bits_b).saturating_mul(pairs) };
    if school_cost > SMALLEST_TRANSFORM_COST {
        let plan = Plan::new(a.len(), bits_a, b.len(), bits_b);
        if transform_cost(&plan) < school_cost {
            return dense_ntt::product(a, b, &plan);
        }
    }
    if words { product_of_words(a, b) } else { product_schoolbook(a, b) }
}

// Costs below are in nanoseconds on a machine of 2023; mostly their ratios matter.

/// No transform is worth its set-up below this.
const SMALLEST_TRANSFORM_COST: u64 = 4_000;

/// The product by sums of word products.
fn word_cost(len_a: usize, len_b: usize) -> u64 {
    (len_a as u64 * len_b as u64) * 3 / 5 + 30 * (len_a + len_b) as u64
}

/// One product of two big integers added to a sum.
fn big_pair_cost(bits_a: u64, bits_b: u64) -> u64 {
    let (long, short) = (bits_a.max(bits_b).div_ceil(64), bits_a.min(bits_b).div_ceil(64));
    // Quadratic up to 32 words, then close to Karatsuba: as the power 3/2.
    let per_word = if short <= 32 { short } else { 32 * (short / 32).isqrt() };
    50 + long * per_word.max(1) * 6 / 5
}

/// The transforms modulo three primes and the passes before and after them.
fn transform_cost(plan: &Plan) -> u64 {
    let n = plan.length as u64;
    2_000 + n * (45 + 6 * u64::from(n.ilog2()))
}

/// a·b for entries that fit in words and sums that fit in 127 bits.
fn product_of_words(a: &[Int], b: &[Int]) -> Vec<Int> {
    let word = |x: &Int| x.as_small().unwrap_or(0);
    let a: Vec<i64> = a.iter().map(word).collect();
    let reversed: Vec<i64> = b.iter().rev().map(word).collect();
    let (n, m) = (a.len(), reversed.len());
    (0..n + m - 1)
        .map(|k| {
            budget::steps((n.min(m) / 1024) as u32);
            let from = (k + 1).saturating_sub(m);
            let to = n.min(k + 1);
            let pairs = a[from..to].iter().zip(&reversed[m - 1 + from - k..]);
            Int::from(pairs.map(|(x, y)| i128::from(*x) * i128::from(*y)).sum::<i128>())
        })
        .collect()
}

/// a·b from the definition.
fn product_schoolbook(a: &[Int], b: &[Int]) -> Vec<Int> {
    (0..a.len() + b.len() - 1)
        .map(|k| {
            budget::step();
            let from = (k + 1).saturating_sub(b.len());
            let to = a.len().min(k + 1);
            let mut total = BigInt::ZERO;
            for (i, x) in a[from..to].iter().enumerate() {
                add_product(&mut total, x, &b[k - from - i]);
            }
            Int::from(total)
        })
        .collect()
}

pub(super) fn add_product(total: &mut BigInt, x: &Int, y: &Int) {
    match (x.as_big(), y.as_big()) {
        (Some(x), Some(y)) => *total += x * y,
        (Some(big), None) => add_small_product(total, big, y),
        (None, Some(big)) => add_small_product(total, big, x),
        (None, None) => {
            let (x, y) = (x.as_small().unwrap_or(0), y.as_small().unwrap_or(0));
            *total += i128::from(x) * i128::from(y);
        }
    }
}

fn add_small_product(total: &mut BigInt, big: &BigInt, small: &Int) {
    let small = small.as_small().unwrap_or(0);
    if small != 0 {
        *total += big * small;
    }
}

/// a^exponent.
///
/// Cost: for few words a recurrence with one word product per coefficient of `a` and coefficient of
/// the result, else repeated squaring.
pub(super) fn power(a: &[Int], exponent: u32) -> Vec<Int> {
    let low = a.iter().take_while(|x| x.is_zero()).count();
    if low > 0 && low < a.len() {
        let mut out = vec![Int::ZERO; low * exponent as usize];
        out.extend(power(&a[low..], exponent));
        return out;
    }
    if exponent > 1
        && let Some(power) = power_by_recurrence(a, exponent)
    {
        return power;
    }
    let mut out = vec![Int::ONE];
    for bit in (0..u32::BITS - exponent.leading_zeros()).rev() {
        out = product(&out, &out);
        if exponent >> bit & 1 == 1 {
            out = product(&out, a);
        }
    }
    out
}

/// With at most this many coefficients the recurrence is faster than products.
const RECURRENCE_LENGTH: usize = 13;

/// a^e for few coefficients a_0 ≠ 0, a_1, …, a_d of one word; `None` for others.
///
/// From a (a^e)' = e a' a^e: k a_0 c_k = Σ_{i ≥ 1} (i e − k + i) a_i c_{k−i}, J. C. P. Miller's rule
/// (Knuth, TAOCP vol. 2, 4.7).
fn power_by_recurrence(a: &[Int], exponent: u32) -> Option<Vec<Int>> {
    if a.len() > RECURRENCE_LENGTH {
        return None;
    }
    let words: Vec<i64> = a.iter().map(Int::as_small).collect::<Option<_>>()?;
    let (first, rest) = words.split_first().filter(|(first, _)| **first != 0)?;
    let top = i64::try_from(rest.len()).ok()?.checked_mul(i64::from(exponent))?;
    // |i e − k + i| ≤ top + d, and k ≤ top; thirteen products by words stay within 127 bits.
    let largest = words.iter().map(|x| x.unsigned_abs()).max()?;
    let factors = i64::try_from(largest).ok()?.checked_mul(top.checked_add(rest.len() as i64)?)?;
    if factors >= 1 << 58 {
        return None;
    }
    let mut out = Vec::with_capacity(usize::try_from(top).ok()? + 1);
    out.push(Int::from(*first).pow(exponent));
    for k in 1..=top {
        budget::step();
        let (mut small, mut big) = (0i128, BigInt::ZERO);
        for (i, (x, c)) in (1i64..).zip(rest.iter().zip(out.iter().rev())) {
            let factor = (i * i64::from(exponent) - k + i) * x;
            match c.as_big() {
                Some(c) if factor != 0 => big += c * factor,
                Some(_) => {}
                None => small += i128::from(c.as_small().unwrap_or(0)) * i128::from(factor),
            }
        }
        let divisor = k * first;
        out.push(if big.is_zero() {
            Int::from(small / i128::from(divisor))
        } else {
            Int::from((big + small) / divisor)
        });
    }
    Some(out)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Entries of very different sizes, of both signs, among them the ends of every word range.
    pub(in crate::math::poly) fn entry() -> impl Strategy<Value = Int> {
        prop_oneof![
            3 => (-9i64..10).prop_map(Int::from),
            2 => any::<i64>().prop_map(Int::from),
            1 => prop_oneof![Just(i64::MIN), Just(i64::MAX), Just(0), Just(-1)].prop_map(Int::from),
            1 => any::<i128>().prop_map(Int::from),
            1 => (any::<i128>(), 1u32..9).prop_map(|(x, e)| Int::from(x).pow(e)),
            1 => (1u32..700).prop_map(|e| Int::from(2).pow(e)),
            1 => (1u32..700).prop_map(|e| Int::from(1) - Int::from(2).pow(e)),
        ]
    }

    pub(in crate::math::poly) fn vector(len: usize) -> impl Strategy<Value = Vec<Int>> {
        prop::collection::vec(entry(), 0..len).prop_map(|mut a| {
            trim(&mut a);
            a
        })
    }

    fn by_transform(a: &[Int], b: &[Int]) -> Vec<Int> {
        if a.is_empty() || b.is_empty() {
            return Vec::new();
        }
        dense_ntt::product(a, b, &Plan::new(a.len(), height_bits(a), b.len(), height_bits(b)))
    }

    fn schoolbook(a: &[Int], b: &[Int]) -> Vec<Int> {
        if a.is_empty() || b.is_empty() { Vec::new() } else { product_schoolbook(a, b) }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn every_product_agrees_with_the_definition(a in vector(24), b in vector(24)) {
            let expected = schoolbook(&a, &b);
            prop_assert_eq!(&by_transform(&a, &b), &expected);
            prop_assert_eq!(&product(&a, &b), &expected);
            prop_assert_eq!(by_transform(&a, &a), schoolbook(&a, &a));
        }

        #[test]
        fn words_agree_with_the_definition(
            a in prop::collection::vec(-i64::MAX..i64::MAX, 1..40),
            b in prop::collection::vec(-1000i64..1000, 1..40),
        ) {
            let a: Vec<Int> = a.into_iter().map(Int::from).collect();
            let b: Vec<Int> = b.into_iter().map(Int::from).collect();
            prop_assert_eq!(product_of_words(&a, &b), product_schoolbook(&a, &b));
        }

        #[test]
        fn powers_are_repeated_products(a in vector(12), e in 0u32..6, word in -99i64..99) {
            let by_products = |a: &[Int]| (0..e).fold(vec![Int::ONE], |p, _| schoolbook(&p, a));
            prop_assert_eq!(power(&a, e), by_products(&a));
            let small: Vec<Int> = a.iter().map(|x| x % Int::from(100)).chain([Int::from(word), Int::ONE]).collect();
            prop_assert_eq!(power(&small, e), by_products(&small));
        }
    }

    /// Transforms of several lengths, depth first and by level, with all entries as large as they may be.
    #[test]
    fn extreme_entries_in_long_products() {
        let mut state = 1u64;
        let mut next = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            state >> 33
        };
        for (len_a, len_b, bits) in
            [(2000, 1100, 1), (1500, 1500, 85), (3000, 5000, 60), (90, 7, 300), (40, 40, 2000)]
        {
            let top = Int::from(2).pow(bits) - Int::ONE;
            for signed in [false, true] {
                let mut draw = |n: usize| -> Vec<Int> {
                    (0..n).map(|_| if signed && next() & 1 == 1 { -&top } else { top.clone() }).collect()
                };
                let (a, b) = (draw(len_a), draw(len_b));
                let c = by_transform(&a, &b);
                assert_eq!(c.len(), len_a + len_b - 1);
                // Entries are ±top, so every coefficient is top² times a small sum.
                let sign = |v: &[Int]| -> Vec<i64> {
                    v.iter().map(|x| if x.is_negative() { -1 } else { 1 }).collect()
                };
                let (s, t) = (sign(&a), sign(&b));
                for k in (0..c.len()).step_by(97).chain([c.len() - 1]) {
                    let from = (k + 1).saturating_sub(len_b);
                    let total: i64 = (from..len_a.min(k + 1)).map(|i| s[i] * t[k - i]).sum();
                    assert_eq!(c[k], &top * &top * Int::from(total));
                }
            }
        }
    }
}
