//! Deterministic inputs for the benchmarks, and checksums of their results.
//!
//! Every workload W2 … W8 is drawn from a 64-bit linear congruential generator with
//! a fixed seed, so that other systems can be timed on the very same numbers. A
//! result is compared by a checksum modulo p = 2^61 − 1:
//!
//! - a rational a/b is a·b^{-1} mod p;
//! - a polynomial in one variable is its value at 1000003, one in t_1, t_2, … (or
//!   x, y, z, w) its value at t_i = 1000003 + 1000 i;
//! - a list is h with h ← 1000033 h + v, from h = 0, in order.
//!
//! | workload | what is timed | input |
//! | --- | --- | --- |
//! | W2 n | expanded polar form of F | [`in_w2`] |
//! | W3 n | one value of the polar form of F | [`in_w3`] |
//! | W4 d | product F G | [`in_w4`], [`in_w4_long`] |
//! | W5 d | composition F∘G | [`in_w5`] |
//! | W6 n | basis matrix A_n and its inverse | n alone |
//! | W7 | degree elevation 100 → 200, subdivision of degree 200 at 1/3 | [`in_w7`] |
//! | W8 m | expanded polar form of F G | [`in_w8`] |
//! | W8 fateman k | f (f + 1) for f = (1 + x + y + z + w)^k | k alone |
//! | W9 basis n | all B-spline basis functions of degree n on 50 knots | [`in_w9_knots`] |
//! | W9 insert | 1000 knots inserted into a cubic of 1000 control points | [`in_w9_insertion`] |
//! | gcd | gcd of products with a common factor, exact division by it | [`in_gcd`] |

// Every benchmark includes this file and uses a part of it.
#![allow(dead_code)]

use num_bigint::BigInt;
use polarform::number::{Int, Rational};
use polarform::poly::{MultiPoly, Symbol};

/// x ← 6364136223846793005 x + 1442695040888963407 mod 2^64; draws the upper 32 bits (Knuth's MMIX).
pub struct Lcg(u64);

impl Lcg {
    pub fn new(seed: u64) -> Self {
        Lcg(seed)
    }

    pub fn draw(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 32) as u32
    }

    pub fn below(&mut self, bound: u32) -> i64 {
        i64::from(self.draw() % bound)
    }

    /// A nonzero integer of size at most `bound`.
    pub fn num(&mut self, bound: u32) -> i64 {
        let size = self.below(bound) + 1;
        if self.below(2) == 1 { -size } else { size }
    }

    /// A rational of numerator at most `num` in size and denominator at most `den`, before reduction.
    pub fn rat(&mut self, num: u32, den: u32) -> Rational {
        let p = self.num(num);
        Rational::new(Int::from(p), Int::from(self.below(den) + 1))
    }

    /// A rational with a numerator of `bits` bits and denominator at most `den`, before reduction.
    pub fn bigrat(&mut self, bits: u32, den: u32) -> Rational {
        let words = bits.div_ceil(32);
        let mut value = BigInt::ZERO;
        for _ in 0..words {
            value = (value << 32u32) | BigInt::from(self.draw());
        }
        value >>= 32 * words - bits;
        if bits == 64 {
            value = value.max(BigInt::from(1));
        } else {
            value.set_bit(u64::from(bits) - 1, true);
        }
        if self.below(2) == 1 {
            value = -value;
        }
        Rational::new(Int::from(value), Int::from(self.below(den) + 1))
    }

    /// Coefficients a_0 … a_n.
    pub fn poly(&mut self, n: usize, num: u32, den: u32) -> Vec<Rational> {
        (0..=n).map(|_| self.rat(num, den)).collect()
    }
}

/// F of degree n.
pub fn in_w2(n: usize) -> Vec<Rational> {
    Lcg::new(200 + n as u64).poly(n, 100, 100)
}

/// F of degree n and n arguments.
pub fn in_w3(n: usize) -> (Vec<Rational>, Vec<Rational>) {
    let mut lcg = Lcg::new(300 + n as u64);
    let f = lcg.poly(n, 100, 100);
    let arguments = (0..n).map(|_| lcg.rat(1000, 1000)).collect();
    (f, arguments)
}

/// F and G of degree d with numerators of 64 bits.
pub fn in_w4(d: usize) -> (Vec<Rational>, Vec<Rational>) {
    long_pair(400 + d as u64, d, 64)
}

/// F and G of degree 1000 with numerators of 1000 bits.
pub fn in_w4_long() -> (Vec<Rational>, Vec<Rational>) {
    long_pair(499, 1000, 1000)
}

fn long_pair(seed: u64, d: usize, bits: u32) -> (Vec<Rational>, Vec<Rational>) {
    let mut lcg = Lcg::new(seed);
    let mut draw = || (0..=d).map(|_| lcg.bigrat(bits, 16)).collect();
    (draw(), draw())
}

/// F and G of degree d.
pub fn in_w5(d: usize) -> (Vec<Rational>, Vec<Rational>) {
    let mut lcg = Lcg::new(500 + d as u64);
    (lcg.poly(d, 10, 10), lcg.poly(d, 10, 10))
}

/// n + 1 control points in the plane; seed and n are 700 and 100 for elevation, 701 and 200 for subdivision.
pub fn in_w7(seed: u64, n: usize) -> Vec<[Rational; 2]> {
    let mut lcg = Lcg::new(seed);
    (0..=n).map(|_| [lcg.rat(1000, 1000), lcg.rat(1000, 1000)]).collect()
}

/// F and G of degree m.
pub fn in_w8(m: usize) -> (Vec<Rational>, Vec<Rational>) {
    let mut lcg = Lcg::new(800 + m as u64);
    (lcg.poly(m, 100, 100), lcg.poly(m, 100, 100))
}

/// `count` increasing knots from 0 on.
fn knots(lcg: &mut Lcg, count: usize) -> Vec<Rational> {
    let mut list = vec![Rational::from_integer(Int::from(0))];
    for _ in 1..count {
        let step = Rational::new(Int::from(lcg.below(9) + 1), Int::from(lcg.below(9) + 1));
        list.push(&list[list.len() - 1] + step);
    }
    list
}

/// 50 knots.
pub fn in_w9_knots() -> Vec<Rational> {
    knots(&mut Lcg::new(900), 50)
}

/// 1004 knots, 1000 control points in the plane, 1000 further knots in the order of insertion.
pub fn in_w9_insertion() -> (Vec<Rational>, Vec<Vec<Rational>>, Vec<Rational>) {
    let mut lcg = Lcg::new(901);
    let t = knots(&mut lcg, 1004);
    let points = (0..1000).map(|_| vec![lcg.rat(1000, 1000), lcg.rat(1000, 1000)]).collect();
    let fresh = (0..1000).map(|_| {
        let s = 3 + lcg.below(997) as usize;
        &t[s] + (&t[s + 1] - &t[s]) * Rational::new(Int::from(lcg.below(15) + 1), Int::from(16))
    });
    let fresh = fresh.collect();
    (t, points, fresh)
}

/// The prime 2^61 − 1.
pub const P: u64 = (1 << 61) - 1;

/// Three random polynomials: seed 1000 + 100 v + n; each n times an exponent below `degree` for each
/// of the v variables x, y, z, w, and a coefficient of size at most 100; equal monomials add up.
pub fn in_gcd(variables: usize, terms: usize, degree: u32) -> [MultiPoly; 3] {
    let mut lcg = Lcg::new(1000 + 100 * variables as u64 + terms as u64);
    [0; 3].map(|_| {
        MultiPoly::from_terms((0..terms).map(|_| {
            let names = ["x", "y", "z", "w"].into_iter().take(variables).map(Symbol::new);
            let powers = names.map(|name| (name, lcg.below(degree) as u32)).collect();
            (powers, Rational::from(Int::from(lcg.num(100))))
        }))
    })
}

/// a·b mod p
pub fn times(a: u64, b: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(P)) as u64
}

/// a + b mod p
pub fn plus(a: u64, b: u64) -> u64 {
    (a + b) % P
}

/// a^e mod p
pub fn power(mut a: u64, mut e: u64) -> u64 {
    let mut result = 1;
    while e > 0 {
        if e & 1 == 1 {
            result = times(result, a);
        }
        a = times(a, a);
        e >>= 1;
    }
    result
}

/// 1/a mod p
pub fn inverse(a: u64) -> u64 {
    power(a, P - 2)
}

/// A rational mod p.
pub fn modp(x: &Rational) -> u64 {
    times(x.numer().mod_word(P), inverse(x.denom().mod_word(P)))
}

/// Where checksums evaluate t_i, i = 1, 2, …; the single variable of a polynomial is t_0.
pub fn point(i: u64) -> u64 {
    1000003 + 1000 * i
}

/// The checksum of a polynomial given by integer numerators over one denominator.
pub fn ck_integers(numerators: &[Int], denominator: &Int) -> u64 {
    let value = numerators.iter().rev().fold(0, |h, a| plus(times(h, point(0)), a.mod_word(P)));
    times(value, inverse(denominator.mod_word(P)))
}

/// The checksum of a polynomial given by its coefficients, the constant one first.
pub fn ck_poly(coefficients: &[Rational]) -> u64 {
    coefficients.iter().rev().fold(0, |h, c| plus(times(h, point(0)), modp(c)))
}

/// The checksum of a list of residues.
pub fn ck_residues(values: impl IntoIterator<Item = u64>) -> u64 {
    values.into_iter().fold(0, |h, v| plus(times(h, 1000033), v))
}

/// The checksum of a list of rationals.
pub fn ck_list<'a>(values: impl IntoIterator<Item = &'a Rational>) -> u64 {
    ck_residues(values.into_iter().map(modp))
}

/// The checksum that `case` must have. Panics if there is no such case.
pub fn expected(case: &str) -> u64 {
    match EXPECTED.iter().find(|(name, _)| *name == case) {
        Some((_, checksum)) => *checksum,
        None => panic!("no checksum is known for {case}"),
    }
}

/// Checksums on which several independent systems agree.
const EXPECTED: &[(&str, u64)] = &[
    ("W2/6", 442469113913824021),
    ("W2/7", 1743135108658185987),
    ("W2/8", 1776847303672901618),
    ("W2/12", 838846360979693930),
    ("W2/16", 422792518746413642),
    ("W3/10", 1959455914099396523),
    ("W3/100", 1345056937319975757),
    ("W3/1000", 490632364152688286),
    ("W4/100", 1679029576901347344),
    ("W4/1000", 528700475983298427),
    ("W4/10000", 1848921946020300632),
    ("W4/1000x1000bit", 1475940226344235270),
    ("W5/20", 133395135093255686),
    ("W5/50", 141852840948290483),
    ("W5/100", 778460883684185343),
    ("W6/10", 626487238658041442),
    ("W6/50", 1824450226778819112),
    ("W6/100", 89528609887334768),
    ("W6/200", 977231951255209951),
    ("W6/500", 454141090641784341),
    ("W7/elevate", 877462301443316675),
    ("W7/subdivide", 1736157445236804534),
    ("W8/5", 765757491865750487),
    ("W8/6", 812936327441747753),
    ("W8/7", 1498999933188436559),
    ("W8/fateman/8", 853521835298218450),
    ("W8/fateman/12", 779602828084918809),
    ("W8/fateman/16", 1238188987469243973),
    ("W9/basis10", 1041621730699439575),
    ("W9/basis3", 589777664599715480),
    ("W9/insert1000", 736049157021878726),
];
