//! Arithmetic modulo word-sized primes, in Montgomery form.
//!
//! With R = 2^64, the *Montgomery product* of x and y is x·y·R^{-1} mod p. It costs
//! three word multiplications and no division. Residues are kept *lazily*: any
//! representative below 2p (or below 4p inside a transform) will do, which is why
//! the primes stay below 2^62.
//!
//! P. L. Montgomery, "Modular multiplication without trial division",
//! Math. Comp. 44 (1985); D. Harvey, "Faster arithmetic for number-theoretic
//! transforms", J. Symb. Comp. 60 (2014).

use super::Int;

/// An odd prime below 2^62 with its Montgomery constants.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Modulus {
    /// The prime.
    pub p: u64,
    /// p^{-1} mod 2^64.
    inverse: u64,
    /// R² mod p, which brings a residue into Montgomery form.
    r2: u64,
}

impl Modulus {
    /// The constants of the odd prime `p` < 2^62.
    pub const fn new(p: u64) -> Self {
        // Newton's iteration doubles the number of correct bits, from 3.
        let mut inverse = p;
        let mut round = 0;
        while round < 5 {
            inverse = inverse.wrapping_mul(2u64.wrapping_sub(p.wrapping_mul(inverse)));
            round += 1;
        }
        let r = ((1u128 << 64) % p as u128) as u64;
        let r2 = (r as u128 * r as u128 % p as u128) as u64;
        Modulus { p, inverse, r2 }
    }

    /// x·R^{-1} mod p in 1..2p, for x < p·R.
    #[inline(always)]
    pub const fn reduce(&self, x: u128) -> u64 {
        let q = (x as u64).wrapping_mul(self.inverse);
        let t = ((q as u128 * self.p as u128) >> 64) as u64;
        ((x >> 64) as u64).wrapping_sub(t).wrapping_add(self.p)
    }

    /// The Montgomery product, in 1..2p, for x·y < p·R (so x < 4p and y < p will do, or both < 2p).
    #[inline(always)]
    pub const fn mul(&self, x: u64, y: u64) -> u64 {
        self.reduce(x as u128 * y as u128)
    }

    /// The representative in 0..p of x < 2p.
    #[inline(always)]
    pub const fn canonical(&self, x: u64) -> u64 {
        if x >= self.p { x - self.p } else { x }
    }

    /// x − y for x, y in 0..p.
    #[inline(always)]
    pub const fn sub(&self, x: u64, y: u64) -> u64 {
        if x >= y { x - y } else { x + self.p - y }
    }

    /// The Montgomery form x·R mod p of x < 2p.
    #[inline]
    pub const fn enter(&self, x: u64) -> u64 {
        self.canonical(self.mul(x, self.r2))
    }

    /// The residue in 0..p whose Montgomery form is x.
    #[inline]
    pub const fn leave(&self, x: u64) -> u64 {
        self.canonical(self.reduce(x as u128))
    }

    /// The Montgomery form of x^e, for x in Montgomery form.
    pub const fn pow(&self, mut x: u64, mut e: u64) -> u64 {
        let mut y = self.enter(1);
        while e > 0 {
            if e & 1 == 1 {
                y = self.canonical(self.mul(y, x));
            }
            x = self.canonical(self.mul(x, x));
            e >>= 1;
        }
        y
    }

    /// The Montgomery form of 1/x, for x ≠ 0 in Montgomery form (Fermat).
    pub const fn invert(&self, x: u64) -> u64 {
        self.pow(x, self.p - 2)
    }
}

/// Primes below 2^62 in decreasing order.
pub(crate) fn primes() -> impl Iterator<Item = Modulus> {
    (0..).map(|k| (1u64 << 62) - 1 - 2 * k).filter(|&n| is_prime(n)).map(Modulus::new)
}

/// Changes `found`, known modulo `modulus`, to agree with `image` modulo p as well, keeping
/// entries least in size. Returns whether nothing changed.
pub(crate) fn combine(found: &mut [Int], modulus: &Int, image: &[u64], field: &Modulus) -> bool {
    let p = field.p;
    let inverse = field.invert(field.enter(modulus.mod_word(p)));
    let mut stable = true;
    for (x, &y) in found.iter_mut().zip(image) {
        let difference = field.sub(y, x.mod_word(p));
        if difference != 0 {
            stable = false;
            let k = field.canonical(field.mul(difference, inverse));
            // x is in (−M/2, M/2), so with k in (−p/2, p/2) the new x is in (−pM/2, pM/2).
            let k = if k > p / 2 { Int::from(k) - Int::from(p) } else { Int::from(k) };
            *x += k * modulus;
        }
    }
    stable
}

/// Miller–Rabin with the first twelve primes as bases, which is exact below 3·10^23
/// (Sorenson and Webster, Math. Comp. 86, 2017). For odd n between 37 and 2^62.
fn is_prime(n: u64) -> bool {
    const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    if BASES.iter().any(|b| n.is_multiple_of(*b)) {
        return false;
    }
    let ring = Modulus::new(n);
    let (one, minus_one) = (ring.enter(1), ring.enter(n - 1));
    let twos = (n - 1).trailing_zeros();
    BASES.iter().all(|&b| {
        let mut x = ring.pow(ring.enter(b), (n - 1) >> twos);
        if x == one || x == minus_one {
            return true;
        }
        (1..twos).any(|_| {
            x = ring.canonical(ring.mul(x, x));
            x == minus_one
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn first_primes_below_two_to_the_62() {
        // 2^62 - 57 is the largest (sequence A013603 of the OEIS: 57 for exponent 62).
        let first: Vec<u64> = primes().take(3).map(|m| m.p).collect();
        assert_eq!(first[0], (1 << 62) - 57);
        assert!(first.windows(2).all(|w| w[0] > w[1]));
        assert!(!is_prime(3_215_031_751)); // a strong pseudoprime to bases 2, 3, 5, 7
    }

    proptest! {
        #[test]
        fn montgomery_agrees_with_plain_remainders(x in any::<u64>(), y in any::<u64>()) {
            let m = primes().next().unwrap();
            let (x, y) = (x % m.p, y % m.p);
            let product = m.leave(m.canonical(m.mul(m.enter(x), m.enter(y))));
            prop_assert_eq!(u128::from(product), u128::from(x) * u128::from(y) % u128::from(m.p));
            if x != 0 {
                let inverse = m.invert(m.enter(x));
                prop_assert_eq!(m.leave(m.canonical(m.mul(inverse, m.enter(x)))), 1);
            }
        }
    }
}
