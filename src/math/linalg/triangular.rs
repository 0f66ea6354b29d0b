//! Systems with a triangular matrix of integers, by substitution.

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::budget;
use crate::math::number::Int;

/// The numerators of the solution and their common denominator; `None` if a diagonal entry is 0.
///
/// What is known stays integer over one denominator, which grows only as it must: there is one gcd for
/// each unknown. Cost: n²/2 products, and n²/2 more if the denominator changes each time.
pub(super) fn solve(rows: &[Vec<Int>], is_lower: bool, right: &[Int]) -> Option<(Vec<Int>, Int)> {
    let n = rows.len();
    let mut denominator = Int::ONE;
    let mut x = vec![Int::ZERO; n];
    for step in 0..n {
        let i = if is_lower { step } else { n - 1 - step };
        let known = if is_lower { 0..i } else { i + 1..n };
        let mut sum = if right[i].is_zero() { Int::ZERO } else { &right[i] * &denominator };
        for (t, y) in rows[i][known.clone()].iter().zip(&x[known.clone()]) {
            if !t.is_zero() && !y.is_zero() {
                budget::step();
                sum -= t * y;
            }
        }
        let diagonal = &rows[i][i];
        if diagonal.is_zero() {
            return None;
        }
        if sum.is_zero() {
            continue;
        }
        let mut shared = sum.gcd(diagonal);
        if diagonal.is_negative() {
            shared = -shared;
        }
        let growth = diagonal.div_exact(&shared);
        if !growth.is_one() {
            budget::charge_bits(denominator.bits() + growth.bits());
            denominator *= &growth;
            for y in x[known].iter_mut().filter(|y| !y.is_zero()) {
                budget::step();
                *y *= &growth;
            }
        }
        x[i] = sum.div_exact(&shared);
    }
    Some((x, denominator))
}
