//! Determinants of integers, by a divisor and what is left of it modulo primes.
//!
//! By Cramer's rule the least common denominator D of the solution of A x = b divides det A, and for a random b it
//! is det A up to a small factor, as a rule. That factor has the size of Hadamard's bound over D at most; it is
//! found modulo as many primes as that needs.
//!
//! **Certificate.** D belongs to a solution that is proved, and the primes exceed twice the bound: nothing is left
//! to chance but the time.
//!
//! J. Abbott, M. Bronstein, T. Mulders, "Fast deterministic computation of determinants of dense matrices",
//! ISSAC 1999.

use num_integer::Integer;
use num_traits::{One, Signed};

use super::lifting::Lifting;
use crate::budget;
use crate::math::number::{Int, Modulus, primes};

/// The determinant of a square matrix of integers. `None` if it is 0 modulo a prime of 62 bits, as it likely is then
/// anyway.
///
/// Cost: n³ products of words and n² for each word of the determinant, if a word or two are left of it; else n³/3
/// for each word.
pub(super) fn determinant(rows: &[Vec<Int>]) -> Option<Int> {
    let most = hadamard_bits(rows);
    budget::charge_bits(most);
    let divisor = divisor(rows)?;
    // |det A| < 2^most, and D has at least 2^(bits − 1).
    let needed = most.saturating_sub(divisor.bits() - 1) + 1;
    let (mut factor, mut modulus) = (Int::ZERO, Int::ONE);
    for field in primes() {
        if modulus.bits() > needed {
            break;
        }
        let below = divisor.mod_word(field.p);
        if below == 0 {
            continue;
        }
        let determinant = determinant_modulo(&field, rows);
        // The factor in Montgomery form, and by Garner what is still missing of it.
        let residue = field.mul(determinant, field.invert(field.enter(below)));
        let known = field.enter(factor.mod_word(field.p));
        let missing = field.sub(field.canonical(residue), known);
        let unit = field.invert(field.enter(modulus.mod_word(field.p)));
        let digit = field.leave(field.mul(missing, unit));
        factor += &modulus * Int::from(digit);
        modulus *= Int::from(field.p);
    }
    let half = &modulus / Int::from(2);
    let factor = if factor > half { factor - modulus } else { factor };
    Some(factor * divisor)
}

/// A number that divides the determinant.
fn divisor(rows: &[Vec<Int>]) -> Option<Int> {
    let mut state = 1u64;
    let right: Vec<Int> = rows
        .iter()
        .map(|_| {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            Int::from((state >> 48) as i64 + 1)
        })
        .collect();
    let (numerators, denominator) = Lifting::new(rows)?.solve(&right, &Int::ONE)?;
    let mut common = denominator.clone();
    for numerator in &numerators {
        if common.is_one() {
            break;
        }
        common = common.gcd(numerator);
    }
    Some(denominator.div_exact(&common).abs())
}

/// A number of bits that the determinant does not exceed: the product of the lengths of the rows, or of the columns.
fn hadamard_bits(rows: &[Vec<Int>]) -> u64 {
    // |a|² < 2^b gives |a| < 2^(b/2), of which the halves are summed.
    let length =
        |entries: &mut dyn Iterator<Item = &Int>| -> u64 { entries.map(|x| x * x).sum::<Int>().bits() };
    let by_rows: u64 = rows.iter().map(|row| length(&mut row.iter())).sum();
    let by_columns: u64 = (0..rows.len()).map(|k| length(&mut rows.iter().map(|row| &row[k]))).sum();
    by_rows.min(by_columns).div_ceil(2)
}

/// The determinant modulo a prime, in Montgomery form, by elimination.
fn determinant_modulo(field: &Modulus, rows: &[Vec<Int>]) -> u64 {
    let n = rows.len();
    let residue = |x: &Int| field.enter(x.mod_word(field.p));
    let mut a: Vec<Vec<u64>> = rows.iter().map(|row| row.iter().map(residue).collect()).collect();
    let mut product = field.enter(1);
    for k in 0..n {
        budget::steps((n * (n - k) / 128) as u32 + 1);
        let Some(chosen) = (k..n).find(|&i| a[i][k] != 0) else { return 0 };
        if chosen != k {
            a.swap(k, chosen);
            product = field.sub(0, product);
        }
        let (above, below) = a.split_at_mut(k + 1);
        let pivot_row = &above[k];
        product = field.canonical(field.mul(product, pivot_row[k]));
        let inverse = field.invert(pivot_row[k]);
        for row in below {
            let factor = field.canonical(field.mul(row[k], inverse));
            if factor != 0 {
                for (x, y) in row[k + 1..].iter_mut().zip(&pivot_row[k + 1..]) {
                    *x = field.sub(*x, field.canonical(field.mul(*y, factor)));
                }
            }
        }
    }
    product
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::linalg::fraction_free::Echelon;
    use crate::math::number::Rational;
    use num_traits::Zero;
    use proptest::prelude::*;

    fn by_elimination(rows: &[Vec<Int>]) -> Int {
        let rows: Vec<Vec<Rational>> =
            rows.iter().map(|row| row.iter().cloned().map(Rational::from_integer).collect()).collect();
        Echelon::new(&rows, rows.len()).determinant().to_integer()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn agrees_with_elimination(
            n in 1usize..13,
            entries in prop::collection::vec(-1_000_000_000i64..1_000_000_000, 144),
            size in prop::sample::select(vec![2i64, 10, 1_000, 1_000_000_000]),
            shift in prop::sample::select(vec![0u32, 0, 70, 300]),
        ) {
            let entry = |i: usize, j: usize| Int::from(entries[12 * i + j] % size) * Int::from(2).pow(shift) + Int::from(i64::from(i == j));
            let rows: Vec<Vec<Int>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
            let expected = by_elimination(&rows);
            match determinant(&rows) {
                Some(found) => prop_assert_eq!(found, expected),
                None => prop_assert!(expected.is_zero()),
            }
        }

        /// Large factors that no solution shows: a multiple of a matrix of determinant ±1.
        #[test]
        fn what_the_divisor_lacks_is_found(n in 1usize..9, below in prop::collection::vec(-9i64..9, 64), scale in 1i64..1_000_000_007) {
            let lower = |i: usize, j: usize| if i == j { 1 } else if i > j { below[8 * i + j] } else { 0 };
            let product = |i: usize, j: usize| (0..n).map(|k| lower(i, k) * lower(j, k)).sum::<i64>();
            let rows: Vec<Vec<Int>> =
                (0..n).map(|i| (0..n).map(|j| Int::from(product(i, j)) * Int::from(scale)).collect()).collect();
            prop_assert_eq!(determinant(&rows), Some(Int::from(scale).pow(n as u32)));
        }
    }

    #[test]
    fn signs_and_bounds() {
        let exchanged: Vec<Vec<Int>> =
            (0..9).map(|i| (0..9).map(|j| Int::from(i64::from(i + j == 8) * 3)).collect()).collect();
        assert_eq!(determinant(&exchanged), Some(Int::from(19683)));
        assert_eq!(determinant(&[vec![Int::from(-5)]]), Some(Int::from(-5)));
        assert_eq!(determinant(&[vec![Int::ZERO]]), None);
    }
}
