//! The kernel of a matrix whose entries are known modulo primes.
//!
//! Columns that are independent modulo one prime are independent. Where one relation is left, its entries are put together from their
//! residues by the Chinese remainder theorem and read as fractions; whoever asks has a proof that it is one.

use crate::budget;
use crate::math::number::{Int, Modulus, combine, primes};

use super::lifting::recovered;

/// How many independent relations there are between the columns.
#[derive(Debug, PartialEq)]
pub(crate) enum Kernel {
    /// None.
    Trivial,
    /// One, by integers without a common factor.
    Line(Vec<Int>),
    /// Several, as far as a prime tells.
    Larger,
}

/// The kernel of a matrix of integers. `rows` are the rows modulo a prime, in Montgomery form, or others with the same kernel; `holds` proves
/// a relation, of which is known that it holds modulo some primes.
///
/// Cost for r rows and n columns: r n² products of words for each prime, about one prime for 31 bits of the result.
pub(crate) fn kernel(
    rows: impl Fn(&Modulus) -> Vec<Vec<u64>>,
    columns: usize,
    holds: impl Fn(&[Int]) -> bool,
) -> Kernel {
    let (mut found, mut modulus) = (vec![Int::ZERO; columns], Int::ONE);
    let mut place = None;
    let (mut taken, mut next_look) = (0, 1);
    for field in primes() {
        let pivots = echelon(&field, rows(&field), columns);
        let free: Vec<usize> = (0..columns).filter(|&j| pivots[j].is_none()).collect();
        let [free] = free[..] else {
            if free.is_empty() {
                return Kernel::Trivial;
            }
            if place.is_none() {
                return Kernel::Larger;
            }
            continue;
        };
        // For a few primes the relation begins later than for all others.
        if *place.get_or_insert(free) != free {
            continue;
        }
        combine(&mut found, &modulus, &relation(&field, &pivots, free, columns), &field);
        modulus *= Int::from(field.p);
        budget::charge_bits(modulus.bits());
        taken += 1;
        if taken < next_look {
            continue;
        }
        next_look = taken + 1 + taken / 3;
        if let Some((numerators, _)) = recovered(&found, &modulus, &Int::ONE) {
            let common = numerators.iter().fold(Int::ZERO, |g, x| num_integer::Integer::gcd(&g, x));
            let relation: Vec<Int> = numerators.iter().map(|x| x.div_exact(&common)).collect();
            if holds(&relation) {
                return Kernel::Line(relation);
            }
        }
    }
    Kernel::Larger
}

/// For each column the row with a 1 there and 0 before, if there is one.
fn echelon(field: &Modulus, rows: Vec<Vec<u64>>, columns: usize) -> Vec<Option<Vec<u64>>> {
    let mut pivots: Vec<Option<Vec<u64>>> = vec![None; columns];
    let mut found = 0;
    for mut row in rows {
        if found == columns {
            break;
        }
        budget::steps(1 + (found * columns / 512) as u32);
        for j in 0..columns {
            if row[j] == 0 {
                continue;
            }
            match &pivots[j] {
                Some(pivot) => {
                    let factor = field.sub(0, row[j]);
                    for (x, y) in row[j..].iter_mut().zip(&pivot[j..]) {
                        let sum = *x + field.canonical(field.mul(*y, factor));
                        *x = field.canonical(sum);
                    }
                }
                None => {
                    let inverse = field.invert(row[j]);
                    row.iter_mut().for_each(|x| *x = field.canonical(field.mul(*x, inverse)));
                    pivots[j] = Some(row);
                    found += 1;
                    break;
                }
            }
        }
    }
    pivots
}

/// The relation with a 1 at the only column without a row, as residues.
fn relation(field: &Modulus, pivots: &[Option<Vec<u64>>], free: usize, columns: usize) -> Vec<u64> {
    let mut x = vec![0; columns];
    x[free] = field.enter(1);
    for j in (0..free).rev() {
        if let Some(row) = &pivots[j] {
            let sum = row[j + 1..=free]
                .iter()
                .zip(&x[j + 1..=free])
                .fold(0, |sum, (a, b)| field.canonical(sum + field.canonical(field.mul(*a, *b))));
            x[j] = field.sub(0, sum);
        }
    }
    x.into_iter().map(|x| field.leave(x)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::linalg::null_space;
    use crate::math::number::{Rational, integer};
    use nalgebra::DMatrix;
    use num_traits::Zero;
    use proptest::prelude::*;

    proptest! {
        /// The same as the null space over the rational numbers.
        #[test]
        fn agrees_with_the_null_space(
            rows in 1usize..7, columns in 1usize..7, entries in prop::collection::vec(-9i64..10, 49),
            mix in prop::collection::vec(-3i64..4, 7), singular: bool,
        ) {
            let mut a = DMatrix::from_fn(rows, columns, |i, j| integer(entries[7 * i + j]));
            if singular {
                // The last column depends on the others.
                for i in 0..rows {
                    let sum = (0..columns - 1).fold(integer(0), |sum, j| sum + &a[(i, j)] * integer(mix[j]));
                    a[(i, columns - 1)] = sum;
                }
            }
            let residues = |field: &Modulus| -> Vec<Vec<u64>> {
                a.row_iter().map(|row| row.iter().map(|x| field.enter(x.numer().mod_word(field.p))).collect()).collect()
            };
            let holds = |x: &[Int]| a.row_iter().all(|row| {
                row.iter().zip(x).fold(Rational::zero(), |sum, (a, x)| sum + a * Rational::from_integer(x.clone())).is_zero()
            });
            let basis = null_space(&a);
            match kernel(residues, columns, holds) {
                Kernel::Trivial => prop_assert_eq!(basis.ncols(), 0),
                Kernel::Larger => prop_assert!(basis.ncols() > 1),
                Kernel::Line(x) => {
                    prop_assert_eq!(basis.ncols(), 1);
                    prop_assert!(holds(&x) && x.iter().any(|x| !x.is_zero()));
                }
            }
        }
    }
}
