//! Homogenised sums Σ a_k x^k y^{n−k} by divide and conquer: evaluation, composition, shift.
//!
//! To evaluate at p/q or to compose with g/d without fractions, the denominators
//! are made homogeneous: Σ a_k (p/q)^k = q^{−n} Σ a_k p^k q^{n−k}. Neighbouring
//! blocks are then merged, so that most of the work is in products of large
//! operands of equal size, where fast multiplication pays.
//!
//! W. Hart, A. Novocin, "Practical divide-and-conquer algorithms for polynomial
//! arithmetic", CASC 2011.

use num_traits::{One, Zero};

use super::dense;
use crate::budget;
use crate::math::number::Int;

/// Merges the one-coefficient blocks a_0, a_1, … into Σ a_k x^k y^{n−k}.
///
/// `merge(low, high, X, Y)` computes low·Y + high·X.
fn homogeneous_sum<T>(
    mut blocks: Vec<T>,
    x: T,
    y: &Int,
    square: impl Fn(&T) -> T,
    merge: impl Fn(T, T, &T, &Int) -> T,
) -> Option<T> {
    let mut x_power = x; // x^size
    let mut y_power = y.clone(); // y^size
    let mut size: u32 = 1;
    let mut last: u32 = 1; // coefficients in the last block
    while blocks.len() > 1 {
        let count = blocks.len();
        let y_last = if last == size { y_power.clone() } else { y.pow(last) };
        let mut merged = Vec::with_capacity(count.div_ceil(2));
        let mut rest = blocks.into_iter();
        while let Some(low) = rest.next() {
            budget::step();
            merged.push(match rest.next() {
                Some(high) => {
                    // A block is of degree one less than its number of coefficients, so the low
                    // one gets as many factors y as the high one has coefficients.
                    let y = if rest.len() == 0 { &y_last } else { &y_power };
                    merge(low, high, &x_power, y)
                }
                None => low,
            });
        }
        if count.is_multiple_of(2) {
            last += size;
        }
        blocks = merged;
        if blocks.len() > 1 {
            x_power = square(&x_power);
            y_power = &y_power * &y_power;
            size *= 2;
        }
    }
    blocks.pop()
}

/// Below this many coefficients Horner's rule is at least as fast.
const HORNER_LIMIT: usize = 24;

/// Σ a_k p^k q^{n−k} with n = deg a; 0 for the zero polynomial.
///
/// Cost: n products by p and by q for small n; O(M(N) log n) for values of N bits.
pub(super) fn homogeneous_value(a: &[Int], p: &Int, q: &Int) -> Int {
    if p.is_zero() {
        let Some(first) = a.first() else { return Int::ZERO };
        return first * q.pow((a.len() - 1) as u32);
    }
    if a.len() > HORNER_LIMIT {
        let value = homogeneous_sum(
            a.to_vec(),
            p.clone(),
            q,
            |x| x * x,
            |low, high, x, y| if y.is_one() { low + high * x } else { low * y + high * x },
        );
        return value.unwrap_or(Int::ZERO);
    }
    let mut value = Int::ZERO;
    let mut q_power = Int::ONE;
    for (step, x) in a.iter().rev().enumerate() {
        value *= p;
        if q.is_one() {
            value += x;
        } else {
            if step > 0 {
                q_power *= q;
            }
            value += x * &q_power;
        }
    }
    value
}

/// Σ a_k g^k d^{n−k} with n = deg a: the numerators of a∘(g/d) over d^n.
///
/// Cost: O(M(N) log n) for a result of N bits in all.
pub(super) fn composed(a: &[Int], g: &[Int], d: &Int) -> Vec<Int> {
    let blocks = a.iter().map(|c| if c.is_zero() { Vec::new() } else { vec![c.clone()] }).collect();
    let result = homogeneous_sum(
        blocks,
        g.to_vec(),
        d,
        |x| dense::product(x, x),
        |low, high, x, y| dense::sum(&dense::scaled(&low, y), &dense::product(&high, x)),
    );
    result.unwrap_or_default()
}

/// Up to this many coefficients a shift by repeated synthetic division is faster than composition.
const SYNTHETIC_LIMIT: usize = 150;

/// Σ a_k (q t + p)^k q^{n−k} with n = deg a: the numerators of a(t + p/q) over q^n.
pub(super) fn shifted(a: &[Int], p: &Int, q: &Int) -> Vec<Int> {
    if a.len() > SYNTHETIC_LIMIT {
        return composed(a, &[p.clone(), q.clone()], q);
    }
    // With s = q t this is B(s + p) for B = Σ a_k q^{n−k} s^k.
    let n = a.len();
    let mut b = a.to_vec();
    scale_by_powers(b.iter_mut().rev(), q);
    for end in 0..n.saturating_sub(1) {
        budget::steps(1 + (n / 32) as u32);
        for k in (end..n - 1).rev() {
            if p.is_one() {
                let (low, high) = b.split_at_mut(k + 1);
                low[k] += &high[0];
            } else {
                let carry = &b[k + 1] * p;
                b[k] += carry;
            }
        }
    }
    scale_by_powers(b.iter_mut(), q);
    b
}

/// Multiplies the entries by 1, c, c², … in turn.
pub(super) fn scale_by_powers<'a>(entries: impl Iterator<Item = &'a mut Int>, c: &Int) {
    if c.is_one() {
        return;
    }
    let mut power = Int::ONE;
    for entry in entries {
        *entry *= &power;
        power *= c;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::poly::dense::{power, scaled, sum};
    use proptest::prelude::*;

    fn ints(range: std::ops::Range<i64>, len: std::ops::Range<usize>) -> impl Strategy<Value = Vec<Int>> {
        prop::collection::vec(range.prop_map(Int::from), len).prop_map(|mut a| {
            dense::trim(&mut a);
            a
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn values_match_the_definition(a in ints(-99..99, 0..70), p in -12i64..12, q in 1i64..9) {
            let (p, q) = (Int::from(p), Int::from(q));
            let n = a.len().saturating_sub(1);
            let expected: Int = (0..a.len()).map(|k| &a[k] * p.pow(k as u32) * q.pow((n - k) as u32)).sum();
            prop_assert_eq!(homogeneous_value(&a, &p, &q), expected);
        }

        #[test]
        fn compositions_match_the_definition(a in ints(-9..9, 0..20), g in ints(-9..9, 0..6), d in 1i64..9) {
            let d = Int::from(d);
            let n = a.len().saturating_sub(1);
            let expected = (0..a.len()).fold(Vec::new(), |total, k| {
                let term = scaled(&power(&g, k as u32), &(&a[k] * d.pow((n - k) as u32)));
                sum(&total, &term)
            });
            prop_assert_eq!(composed(&a, &g, &d), expected);
        }

        #[test]
        fn shifts_agree(a in ints(-99..99, 0..200), p in -5i64..6, q in 1i64..5) {
            let (p, q) = (Int::from(p), Int::from(q));
            prop_assert_eq!(shifted(&a, &p, &q), composed(&a, &[p, q.clone()], &q));
        }
    }
}
