//! Prime factors of integers: small divisors, then Pollard's rho, and primes that are proved.
//!
//! **Certificate.** The test of Miller and Rabin is exact below 3.3·10^24 for the first 13 primes as bases. A larger
//! number that passes it is proved by the prime factors of n − 1 (Lucas): a is a primitive root modulo n if a^(n−1) is 1
//! and a^((n−1)/q) is not for any prime q of n − 1.
//!
//! J. M. Pollard, "A Monte Carlo method for factorization", BIT 15 (1975); R. P. Brent, "An improved Monte Carlo
//! factorization algorithm", BIT 20 (1980); J. Sorenson and J. Webster, "Strong pseudoprimes to twelve prime bases",
//! Math. Comp. 86 (2017).

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::Int;
use crate::budget;

/// Divisors below this are tried one after the other.
const TRIED: i64 = 1000;

/// The bases for which the test of Miller and Rabin is exact below [`exact_below`].
const BASES: [i64; 13] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41];

fn exact_below() -> Int {
    Int::from(3_317_044_064_679_887_385_961_981_i128)
}

/// The primes that divide |n|, increasing, with their multiplicities; none for 0.
///
/// Cost: about the square root of each prime factor but the largest in products modulo n (a factor of 18 digits takes
/// some ten minutes), and that for p − 1 where a factor p has more than 24 digits.
///
/// ```
/// use polarform::number::{Int, prime_factors};
/// let factors: Vec<(String, u32)> = prime_factors(&Int::from(-360)).into_iter().map(|(p, m)| (p.to_string(), m)).collect();
/// assert_eq!(factors, [("2".into(), 3), ("3".into(), 2), ("5".into(), 1)]);
/// ```
pub fn prime_factors(n: &Int) -> Vec<(Int, u32)> {
    let mut rest = n.abs();
    let mut found: BTreeMap<Int, u32> = BTreeMap::new();
    if rest.is_zero() {
        return Vec::new();
    }
    for divisor in std::iter::once(2).chain((3..TRIED).step_by(2)) {
        budget::step();
        while rest.mod_word(divisor as u64) == 0 {
            rest = rest.div_exact(&Int::from(divisor));
            *found.entry(Int::from(divisor)).or_default() += 1;
        }
    }
    let mut waiting = vec![rest];
    while let Some(part) = waiting.pop() {
        if part.is_one() {
            continue;
        }
        if is_prime(&part) {
            *found.entry(part).or_default() += 1;
            continue;
        }
        let divisor = divisor(&part);
        waiting.push(part.div_exact(&divisor));
        waiting.push(divisor);
    }
    found.into_iter().collect()
}

/// For n without divisors below [`TRIED`].
fn is_prime(n: &Int) -> bool {
    if *n < Int::from(TRIED * TRIED) {
        return true;
    }
    if !BASES.iter().all(|base| passes(n, *base)) {
        return false;
    }
    *n < exact_below() || is_proved(n)
}

/// Whether n is a strong probable prime to a base.
fn passes(n: &Int, base: i64) -> bool {
    let (n, one) = (n.to_big(), BigInt::one());
    let below = &n - &one;
    let twos = below.trailing_zeros().unwrap_or(0);
    // A product of numbers of 64 bits takes about a tenth of a step.
    budget::steps((n.bits() * n.bits() / 4096) as u32 + 1);
    let mut x = BigInt::from(base).modpow(&(&below >> twos), &n);
    if x == one || x == below {
        return true;
    }
    (1..twos).any(|_| {
        x = &x * &x % &n;
        x == below
    })
}

/// Whether some small number is a primitive root modulo n, as half of all are unless n has small divisors.
fn is_proved(n: &Int) -> bool {
    let below = n - Int::ONE;
    let primes = prime_factors(&below);
    let (modulus, exponent) = (n.to_big(), below.to_big());
    (2..).map(BigInt::from).take(1000).any(|base| {
        budget::steps((primes.len() as u64 * n.bits() * n.bits() / 4096) as u32 + 1);
        base.modpow(&exponent, &modulus).is_one()
            && primes.iter().all(|(prime, _)| !base.modpow(&(&exponent / prime.to_big()), &modulus).is_one())
    })
}

/// A proper divisor of a number that is no prime and has no small divisors, by Pollard's rho in Brent's way.
fn divisor(n: &Int) -> Int {
    /// Differences that share one greatest common divisor.
    const TOGETHER: usize = 128;
    let mut shift = Int::ONE;
    loop {
        let next = |x: &Int| (x * x + &shift).mod_floor(n);
        let (mut y, mut steps) = (Int::from(2), 1_usize);
        let mut common = Int::ONE;
        while common.is_one() {
            let x = y.clone();
            let mut taken = 0;
            (0..steps).for_each(|_| {
                budget::step();
                y = next(&y);
            });
            while taken < steps && common.is_one() {
                let before = y.clone();
                let mut product = Int::ONE;
                for _ in 0..TOGETHER.min(steps - taken) {
                    budget::step();
                    y = next(&y);
                    product = (product * (&x - &y)).mod_floor(n);
                }
                common = product.gcd(n);
                if common == *n {
                    // Two divisors at once: one difference after the other.
                    y = before;
                    common = Int::ONE;
                    while common.is_one() {
                        budget::step();
                        y = next(&y);
                        common = (&x - &y).gcd(n);
                    }
                }
                taken += TOGETHER;
            }
            steps *= 2;
        }
        if common != *n {
            return common;
        }
        shift += Int::ONE;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn shown(n: &Int) -> String {
        let power = |(p, m): (Int, u32)| if m == 1 { p.to_string() } else { format!("{p}^{m}") };
        prime_factors(n).into_iter().map(power).collect::<Vec<_>>().join(" ")
    }

    fn int(text: &str) -> Int {
        text.parse().unwrap()
    }

    proptest! {
        #[test]
        fn primes_multiply_to_the_number(n in -100_000_000i64..100_000_000) {
            let factors = prime_factors(&Int::from(n));
            let product: Int = factors.iter().map(|(p, m)| p.pow(*m)).product();
            prop_assert_eq!(product, if n == 0 { Int::ONE } else { Int::from(n).abs() });
            for (p, _) in factors {
                let p = p.as_small().unwrap();
                prop_assert!(p > 1 && (2..p).take_while(|d| d * d <= p).all(|d| p % d != 0));
            }
        }

        /// The product of what was found for parts is found again.
        #[test]
        fn a_product_has_the_factors_of_its_parts(parts in prop::collection::vec(2i64..2_000_000, 1..5)) {
            let mut expected: BTreeMap<Int, u32> = BTreeMap::new();
            for part in &parts {
                for (p, m) in prime_factors(&Int::from(*part)) {
                    *expected.entry(p).or_default() += m;
                }
            }
            let product: Int = parts.iter().map(|part| Int::from(*part)).product();
            prop_assert_eq!(prime_factors(&product), expected.into_iter().collect::<Vec<_>>());
        }
    }

    #[test]
    fn numbers_of_the_literature() {
        for (n, factors) in [
            ("0", ""),
            ("1", ""),
            ("561", "3 11 17"),
            // Strong pseudoprimes to the first 4 and 9 primes as bases.
            ("3215031751", "151 751 28351"),
            ("3825123056546413051", "149491 747451 34233211"),
            // Fermat's F_6, Mersenne's M_59, and Mersenne primes below and above the bound of the test.
            ("18446744073709551617", "274177 67280421310721"),
            ("576460752303423487", "179951 3203431780337"),
            ("2305843009213693951", "2305843009213693951"),
            ("618970019642690137449562111", "618970019642690137449562111"),
            ("162259276829213363391578010288127", "162259276829213363391578010288127"),
            // Powers of a prime that is too large to be tried.
            ("1000006000009", "1000003^2"),
            ("1000009000027000027", "1000003^3"),
            (
                "14904315015220216637255064492460571600",
                "2^4 5^2 11^2 13 89 1181 350617999 725468503 885993701",
            ),
        ] {
            assert_eq!(shown(&int(n)), factors, "{n}");
            assert_eq!(shown(&-int(n)), factors, "-{n}");
        }
        // One to the first 12.
        assert!(!is_prime(&int("318665857834031151167461")));
    }

    /// Nothing beside what Miller and Rabin say: the proof finds out by itself.
    #[test]
    fn proofs_hold_for_primes_only() {
        for n in (TRIED + 1..TRIED + 400).step_by(2) {
            let is_prime = (2..n).take_while(|d| d * d <= n).all(|d| n % d != 0);
            assert_eq!(is_proved(&Int::from(n)), is_prime, "{n}");
        }
    }
}
