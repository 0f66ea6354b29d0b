//! Dixon's p-adic lifting for systems of integers.
//!
//! With C the inverse of A modulo a prime p, the digits of the solution in base p are
//! x_k = C r_k mod p with r_0 = b and r_{k+1} = (r_k − A x_k)/p. After enough digits the solution
//! N/D is recovered from its residue modulo M = p^k.
//!
//! **Certificate.** If N ≡ D Σ x_k p^k, then A N − D b is 0 modulo M. If it is also smaller than M in
//! size, which is seen from the sizes of its parts, it is 0. So what is returned is proved, however it
//! was found.
//!
//! J. D. Dixon, "Exact solution of linear equations using p-adic expansions", Numer. Math. 40 (1982).

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::budget;
use crate::math::number::{Int, Modulus, primes};

/// For fewer rows elimination is as fast.
pub(super) const SMALLEST: usize = 8;

/// A matrix of integers that is invertible modulo a prime.
pub(super) struct Lifting<'a> {
    rows: &'a [Vec<Int>],
    /// The entries, if residuals fit in 128 bits.
    words: Option<Vec<Vec<i64>>>,
    /// Bits of the largest entry.
    height: u64,
    field: Modulus,
    /// C by rows, in Montgomery form.
    inverse: Vec<Vec<u64>>,
}

impl<'a> Lifting<'a> {
    /// `None` if the matrix is singular modulo the prime, as it likely is then anyway. Cost: n³
    /// products of words.
    pub(super) fn new(rows: &'a [Vec<Int>]) -> Option<Self> {
        let field = primes().next()?;
        let residue = |x: &Int| field.enter(x.mod_word(field.p));
        let inverse =
            inverse_modulo(&field, rows.iter().map(|row| row.iter().map(residue).collect()).collect())?;
        let height = rows.iter().flatten().map(Int::bits).max().unwrap_or(0);
        let row_of_words = |row: &Vec<Int>| row.iter().map(Int::as_small).collect::<Option<Vec<i64>>>();
        let fits = height + 62 + u64::from(usize::BITS - rows.len().leading_zeros()) <= 125;
        let words = if fits { rows.iter().map(row_of_words).collect() } else { None };
        Some(Lifting { rows, words, height, field, inverse })
    }

    /// The numerators of the solution and a common denominator; `guess` is a number that may be a
    /// multiple of the denominator. `None` for a singular matrix.
    ///
    /// Cost: 2n² products of words for each digit.
    pub(super) fn solve(&self, right: &[Int], guess: &Int) -> Option<(Vec<Int>, Int)> {
        let n = self.rows.len();
        let right_bits = right.iter().map(Int::bits).max().unwrap_or(0);
        let size_bits = u64::from(usize::BITS - n.leading_zeros());
        // By Hadamard's bound and Cramer's rule there is an end.
        let minor_bits = n as u64 * (self.height + size_bits);
        let most = 2 * (2 * minor_bits + right_bits + self.height + size_bits) / 61 + 4;
        let mut residual = right.to_vec();
        let mut digits: Vec<Vec<u64>> = Vec::new();
        let mut next_look = 2;
        while (digits.len() as u64) < most {
            budget::steps((n * n / 64) as u32 + 1);
            let digit = self.digit(&residual);
            self.subtract(&mut residual, &digit);
            digits.push(digit);
            if digits.len() < next_look && !residual.iter().all(Int::is_zero) {
                continue;
            }
            next_look = digits.len() + 2 + digits.len() / 4;
            let modulus = Int::from(self.field.p).pow(digits.len() as u32);
            budget::charge_bits(modulus.bits());
            let found = recovered(&residues(&digits, self.field.p), &modulus, guess);
            if let Some((numerators, denominator)) = found {
                let largest = numerators.iter().map(Int::bits).max().unwrap_or(0);
                let left = self.height + largest + size_bits;
                if left.max(right_bits + denominator.bits()) + 2 < modulus.bits() {
                    return Some((numerators, denominator));
                }
            }
        }
        None
    }

    /// C r mod p.
    fn digit(&self, residual: &[Int]) -> Vec<u64> {
        let field = &self.field;
        let r: Vec<u64> = residual.iter().map(|x| field.enter(x.mod_word(field.p))).collect();
        let entry = |row: &Vec<u64>| {
            // Four products of numbers below p are below p·2^64.
            let sum = row.chunks(4).zip(r.chunks(4)).fold(0, |sum, (c, r)| {
                let part: u128 = c.iter().zip(r).map(|(c, r)| u128::from(*c) * u128::from(*r)).sum();
                field.canonical(sum + field.canonical(field.reduce(part)))
            });
            field.leave(sum)
        };
        self.inverse.iter().map(entry).collect()
    }

    /// r ← (r − A x)/p, which is exact.
    fn subtract(&self, residual: &mut [Int], digit: &[u64]) {
        let p = Int::from(self.field.p);
        for (i, r) in residual.iter_mut().enumerate() {
            let product = match &self.words {
                Some(rows) => Int::from(
                    rows[i].iter().zip(digit).map(|(a, x)| i128::from(*a) * i128::from(*x)).sum::<i128>(),
                ),
                None => self.rows[i]
                    .iter()
                    .zip(digit)
                    .filter(|(a, _)| !a.is_zero())
                    .map(|(a, x)| a * Int::from(*x))
                    .sum(),
            };
            *r = (&*r - product).div_exact(&p);
        }
    }
}

/// Σ x_k p^k for each unknown.
fn residues(digits: &[Vec<u64>], p: u64) -> Vec<Int> {
    let p = Int::from(p);
    let unknowns = digits.first().map_or(0, Vec::len);
    let number = |i: usize| digits.iter().rev().fold(Int::ZERO, |sum, digit| sum * &p + Int::from(digit[i]));
    (0..unknowns).map(number).collect()
}

/// Numerators over one denominator that are congruent to the residues.
pub(super) fn recovered(residues: &[Int], modulus: &Int, guess: &Int) -> Option<(Vec<Int>, Int)> {
    let half = modulus / Int::from(2);
    let likely = modulus.bits() * 3 / 4;
    let mut denominator = guess.clone();
    let mut numerators: Vec<Int> = Vec::with_capacity(residues.len());
    for residue in residues {
        budget::step();
        let scaled = (residue * &denominator).mod_floor(modulus);
        let scaled = if scaled > half { scaled - modulus } else { scaled };
        if scaled.bits() <= likely {
            numerators.push(scaled);
            continue;
        }
        let (numerator, factor) = fraction(&scaled, modulus)?;
        numerators.iter_mut().for_each(|x| *x *= &factor);
        denominator *= &factor;
        numerators.push(numerator);
    }
    Some((numerators, denominator))
}

/// a/b with a ≡ b x, |a| and b > 0 below the square root of half the modulus; `None` if there is none.
///
/// The remainders of Euclid's algorithm; P. S. Wang, "A p-adic algorithm for univariate partial
/// fractions", SYMSAC 1981.
fn fraction(x: &Int, modulus: &Int) -> Option<(Int, Int)> {
    let bits = (modulus.bits() - 1) / 2;
    let (mut a, mut b) = (modulus.clone(), x.mod_floor(modulus));
    let (mut u, mut v) = (Int::ZERO, Int::ONE);
    while b.bits() > bits {
        budget::step();
        let (q, rest) = a.div_rem(&b);
        (a, b) = (b, rest);
        let next = u - &q * &v;
        (u, v) = (v, next);
    }
    (v.bits() <= bits && !v.is_zero() && b.gcd(&v).is_one())
        .then(|| if v.is_negative() { (-b, -v) } else { (b, v) })
}

/// The inverse of a matrix of residues in Montgomery form, by Gauss and Jordan; `None` if it is singular.
fn inverse_modulo(field: &Modulus, mut a: Vec<Vec<u64>>) -> Option<Vec<Vec<u64>>> {
    let n = a.len();
    let mut exchanged = Vec::with_capacity(n);
    for k in 0..n {
        budget::steps((n * n / 128) as u32 + 1);
        let chosen = (k..n).find(|&i| a[i][k] != 0)?;
        a.swap(k, chosen);
        exchanged.push(chosen);
        let mut pivot_row = std::mem::take(&mut a[k]);
        let inverse = field.invert(pivot_row[k]);
        pivot_row[k] = field.enter(1);
        for x in &mut pivot_row {
            *x = field.canonical(field.mul(*x, inverse));
        }
        for row in a.iter_mut().filter(|row| !row.is_empty()) {
            let factor = std::mem::replace(&mut row[k], 0);
            if factor != 0 {
                for (x, y) in row.iter_mut().zip(&pivot_row) {
                    *x = field.sub(*x, field.canonical(field.mul(*y, factor)));
                }
            }
        }
        a[k] = pivot_row;
    }
    for (k, chosen) in exchanged.into_iter().enumerate().rev() {
        a.iter_mut().for_each(|row| row.swap(k, chosen));
    }
    Some(a)
}
