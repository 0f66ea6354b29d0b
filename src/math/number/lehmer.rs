//! Greatest common divisors of long integers by Lehmer's method.
//!
//! The first quotients of Euclid's algorithm depend on the leading digits only. So the algorithm
//! runs on the leading 128 bits of both numbers, as long as the quotients are certain (Collins'
//! condition), and its steps, collected in a matrix of words, are applied to all digits at once:
//! one pass over the digits for about 64 bits. Cost: O(n²) word products for n words.
//!
//! D. H. Lehmer, Amer. Math. Monthly 45 (1938); Knuth, TAOCP vol. 2, 4.5.2, algorithm L;
//! J. Sorenson, "An analysis of Lehmer's Euclidean GCD algorithm", ISSAC 1995, for the condition.

use num_bigint::BigUint;

use super::gcd_word;

/// The greatest common divisor.
pub(super) fn gcd(x: &BigUint, y: &BigUint) -> BigUint {
    let (mut a, mut b) = (x.to_u64_digits(), y.to_u64_digits());
    let mut spare = (Vec::new(), Vec::new());
    loop {
        if is_less(&a, &b) {
            std::mem::swap(&mut a, &mut b);
        }
        if a.len() <= 2 {
            return BigUint::from(gcd_of_doubles(double(&a), double(&b)));
        }
        if b.is_empty() {
            return from_words(&a);
        }
        match steps_of_leading_digits(&a, &b) {
            Some(steps) => {
                steps.apply(&a, &b, &mut spare.0, &mut spare.1);
                std::mem::swap(&mut a, &mut spare.0);
                std::mem::swap(&mut b, &mut spare.1);
            }
            None => {
                // b is much shorter, or the quotient has more than a word.
                let rest = (from_words(&a) % from_words(&b)).to_u64_digits();
                a = std::mem::replace(&mut b, rest);
            }
        }
    }
}

fn from_words(words: &[u64]) -> BigUint {
    BigUint::new(words.iter().flat_map(|w| [*w as u32, (*w >> 32) as u32]).collect())
}

fn is_less(a: &[u64], b: &[u64]) -> bool {
    a.len().cmp(&b.len()).then_with(|| a.iter().rev().cmp(b.iter().rev())).is_lt()
}

fn double(words: &[u64]) -> u128 {
    let word = |k: usize| u128::from(words.get(k).copied().unwrap_or(0));
    word(0) | word(1) << 64
}

/// gcd(x, y) for x ≥ y: Euclid's algorithm down to a word, where the binary one goes on.
fn gcd_of_doubles(mut x: u128, mut y: u128) -> u128 {
    while y >> 64 != 0 {
        (x, y) = (y, quotient(x, y).1);
    }
    match u64::try_from(y) {
        Ok(y) if y != 0 => u128::from(gcd_word(y, (x % u128::from(y)) as u64)),
        _ => x,
    }
}

/// Steps of Euclid's algorithm: (a, b) becomes (±(u0 a − v0 b), ±(v1 b − u1 a)), + if `even`.
struct Steps {
    u0: u64,
    v0: u64,
    u1: u64,
    v1: u64,
    even: bool,
}

/// The steps that the leading 128 bits determine, for a ≥ b and a of at least three words;
/// `None` if they determine none.
fn steps_of_leading_digits(a: &[u64], b: &[u64]) -> Option<Steps> {
    let n = a.len();
    let shift = a[n - 1].leading_zeros();
    let leading = |x: &[u64]| {
        let word = |k: usize| x.get(k).copied().unwrap_or(0);
        let top = u128::from(word(n - 1)) << 64 | u128::from(word(n - 2));
        if shift == 0 { top } else { top << shift | u128::from(word(n - 3) >> (64 - shift)) }
    };
    let (mut x, mut y) = (leading(a), leading(b));
    // Signs of the cofactors alternate; these are their sizes.
    let (mut u0, mut u1, mut u2) = (0u64, 1u64, 0u64);
    let (mut v0, mut v1, mut v2) = (0u64, 0u64, 1u64);
    let mut even = false;
    while y >= u128::from(v2) && x - y >= u128::from(v1) + u128::from(v2) {
        let (q, rest) = quotient(x, y);
        let next = |c1: u64, c2: u64| match q {
            1 => c1.checked_add(c2),
            _ => c2.checked_mul(u64::try_from(q).ok()?)?.checked_add(c1),
        };
        let (Some(u), Some(v)) = (next(u1, u2), next(v1, v2)) else { break };
        (x, y) = (y, rest);
        (u0, u1, u2) = (u1, u2, u);
        (v0, v1, v2) = (v1, v2, v);
        even = !even;
    }
    (v0 != 0).then_some(Steps { u0, v0, u1, v1, even })
}

/// x / y and the remainder for x ≥ y; most quotients are small.
fn quotient(x: u128, y: u128) -> (u128, u128) {
    let mut rest = x - y;
    for q in 1..4 {
        if rest < y {
            return (q, rest);
        }
        rest -= y;
    }
    if rest < y {
        return (4, rest);
    }
    (x / y, x % y)
}

impl Steps {
    fn apply(&self, a: &[u64], b: &[u64], first: &mut Vec<u64>, second: &mut Vec<u64>) {
        let (u, v) = ((self.u0, a), (self.v0, b));
        if self.even {
            difference(u, v, first)
        } else {
            difference(v, u, first)
        }
        let (u, v) = ((self.u1, a), (self.v1, b));
        if self.even { difference(v, u, second) } else { difference(u, v, second) }
    }
}

/// The words of c·x − d·y ≥ 0.
fn difference((c, x): (u64, &[u64]), (d, y): (u64, &[u64]), out: &mut Vec<u64>) {
    out.clear();
    let (mut carry_x, mut carry_y, mut borrow) = (0u64, 0u64, false);
    let mut push = |wx: u64, wy: u64| {
        let p = u128::from(c) * u128::from(wx) + u128::from(carry_x);
        let q = u128::from(d) * u128::from(wy) + u128::from(carry_y);
        (carry_x, carry_y) = ((p >> 64) as u64, (q >> 64) as u64);
        let (low, under) = (p as u64).overflowing_sub(q as u64);
        let (low, under_too) = low.overflowing_sub(u64::from(borrow));
        borrow = under || under_too;
        out.push(low);
    };
    let common = x.len().min(y.len());
    for (wx, wy) in x.iter().zip(y) {
        push(*wx, *wy);
    }
    for wx in &x[common..] {
        push(*wx, 0);
    }
    for wy in &y[common..] {
        push(0, *wy);
    }
    debug_assert!(carry_x == carry_y + u64::from(borrow), "the difference is shorter than its terms");
    while out.last() == Some(&0) {
        out.pop();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_integer::Integer;
    use num_traits::{One, Zero};
    use proptest::prelude::*;

    /// Random numbers, numbers close to powers of two, and those of long runs of equal digits.
    fn long() -> impl Strategy<Value = BigUint> {
        prop_oneof![
            4 => prop::collection::vec(any::<u32>(), 0..40).prop_map(BigUint::new),
            1 => (0u32..900, 0u32..3).prop_map(|(e, k)| (BigUint::one() << e) + k),
            1 => (0u32..900).prop_map(|e| (BigUint::one() << e) - 1u32),
            1 => (prop::collection::vec(prop_oneof![Just(0), Just(u32::MAX), any::<u32>()], 0..40))
                .prop_map(BigUint::new),
        ]
    }

    proptest! {
        #[test]
        fn agrees_with_the_binary_algorithm(a in long(), b in long(), g in long()) {
            prop_assert_eq!(gcd(&a, &b), a.gcd(&b));
            let (x, y) = (&a * &g, &b * &g);
            prop_assert_eq!(gcd(&x, &y), x.gcd(&y));
            prop_assert_eq!(gcd(&x, &g), if x.is_zero() { g.clone() } else { x.gcd(&g) });
        }

        #[test]
        fn chosen_quotients(quotients in prop::collection::vec(
            prop_oneof![4 => Just(1u64), 4 => 1u64..5, 1 => any::<u64>(), 1 => Just(u64::MAX)], 1..200)) {
            // Consecutive convergents are coprime, whatever the quotients.
            let (mut a, mut b) = (BigUint::one(), BigUint::zero());
            for q in quotients {
                (a, b) = (&a * q + &b, a);
            }
            prop_assert!(gcd(&a, &b).is_one());
            prop_assert_eq!(gcd(&(&a * 12u32), &(&b * 12u32)), BigUint::from(12u32));
        }
    }
}
