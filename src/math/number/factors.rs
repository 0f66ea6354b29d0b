//! Prime factors of integers.

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::Int;
use crate::budget;

/// The primes that divide |n|, increasing, with their multiplicities; none for 0.
///
/// Cost: trial division, up to the square root of the largest factor but one; each divisor is a step of
/// the budget.
///
/// ```
/// use polarform::number::{Int, prime_factors};
/// let factors: Vec<(String, u32)> = prime_factors(&Int::from(-360)).into_iter().map(|(p, m)| (p.to_string(), m)).collect();
/// assert_eq!(factors, [("2".into(), 3), ("3".into(), 2), ("5".into(), 1)]);
/// ```
pub fn prime_factors(n: &Int) -> Vec<(Int, u32)> {
    let mut rest = n.abs();
    let mut found = Vec::new();
    if rest.is_zero() {
        return found;
    }
    let mut divisor = Int::from(2);
    while &divisor * &divisor <= rest {
        budget::step();
        let mut count = 0;
        loop {
            let (quotient, remainder) = rest.div_rem(&divisor);
            if !remainder.is_zero() {
                break;
            }
            rest = quotient;
            count += 1;
        }
        if count > 0 {
            found.push((divisor.clone(), count));
        }
        divisor += Int::from(if divisor.is_even() { 1 } else { 2 });
    }
    if !rest.is_one() {
        found.push((rest, 1));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn primes_multiply_to_the_number(n in -100_000i64..100_000) {
            let factors = prime_factors(&Int::from(n));
            let product: Int = factors.iter().map(|(p, m)| p.pow(*m)).product();
            prop_assert_eq!(product, if n == 0 { Int::ONE } else { Int::from(n).abs() });
            for (p, _) in factors {
                let p = p.as_small().unwrap();
                prop_assert!(p > 1 && (2..p).all(|d| d * d > p || p % d != 0));
            }
        }
    }
}
