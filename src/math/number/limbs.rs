//! Arithmetic on rows of machine words, modulo 2^(64 w).
//!
//! A row of w words stands for an integer in two's complement, least significant
//! word first. Sums and products by one word are taken modulo 2^(64 w), so signs
//! need no care as long as the true result fits.

use num_bigint::{BigInt, BigUint, Sign};

use super::Int;

/// acc += row · factor (mod 2^(64 w)); the row is read up to the length of `acc`.
#[inline]
pub(crate) fn add_scaled(acc: &mut [u64], row: &[u64], factor: u64) {
    let mut carry = 0u64;
    for (a, &r) in acc.iter_mut().zip(row) {
        let sum = u128::from(r) * u128::from(factor) + u128::from(*a) + u128::from(carry);
        *a = sum as u64;
        carry = (sum >> 64) as u64;
    }
}

/// acc −= row · factor (mod 2^(64 w)).
#[inline]
pub(crate) fn sub_scaled(acc: &mut [u64], row: &[u64], factor: u64) {
    let mut borrow = 0u64;
    for (a, &r) in acc.iter_mut().zip(row) {
        let product = u128::from(r) * u128::from(factor) + u128::from(borrow);
        let (difference, under) = a.overflowing_sub(product as u64);
        *a = difference;
        borrow = (product >> 64) as u64 + u64::from(under);
    }
}

/// acc = row · factor (mod 2^(64 w)).
#[inline]
pub(crate) fn set_scaled(acc: &mut [u64], row: &[u64], factor: u64) {
    let mut carry = 0u64;
    for (a, &r) in acc.iter_mut().zip(row) {
        let product = u128::from(r) * u128::from(factor) + u128::from(carry);
        *a = product as u64;
        carry = (product >> 64) as u64;
    }
}

/// Replaces the row by its negative (mod 2^(64 w)).
pub(crate) fn negate(row: &mut [u64]) {
    let mut carry = true;
    for word in row {
        let (flipped, overflow) = (!*word).overflowing_add(u64::from(carry));
        *word = flipped;
        carry = overflow;
    }
}

/// Whether the row stands for a negative number.
pub(crate) fn is_negative(row: &[u64]) -> bool {
    row.last().is_some_and(|&top| top >> 63 == 1)
}

/// The number modulo the word `m`, for a row read as nonnegative.
pub(crate) fn mod_word(row: &[u64], m: u64) -> u64 {
    row.iter().rev().fold(0, |r, &word| (((u128::from(r) << 64) | u128::from(word)) % u128::from(m)) as u64)
}

/// Divides a row read as nonnegative by the word `m`, which must divide it.
pub(crate) fn divide_word(row: &mut [u64], m: u64) {
    let mut remainder = 0u64;
    for word in row.iter_mut().rev() {
        let value = (u128::from(remainder) << 64) | u128::from(*word);
        *word = (value / u128::from(m)) as u64;
        remainder = (value % u128::from(m)) as u64;
    }
    debug_assert_eq!(remainder, 0);
}

/// row = row · scale + other · factor (mod 2^(64 w)), for words below 2^63.
#[inline]
pub(crate) fn scale_and_add(row: &mut [u64], scale: u64, other: &[u64], factor: u64) {
    debug_assert!(scale >> 63 == 0 && factor >> 63 == 0);
    let mut carry = 0u64;
    for (a, &r) in row.iter_mut().zip(other) {
        // Two products below 2^127 − 2^63 and a word.
        let sum = u128::from(*a) * u128::from(scale) + u128::from(r) * u128::from(factor) + u128::from(carry);
        *a = sum as u64;
        carry = (sum >> 64) as u64;
    }
}

/// The word that continues a number upwards.
pub(crate) fn fill(row: &[u64]) -> u64 {
    if is_negative(row) { u64::MAX } else { 0 }
}

/// The number of bits of the absolute value, at most one more.
pub(crate) fn bits(row: &[u64]) -> u64 {
    let fill = fill(row);
    let used = row.len() - row.iter().rev().take_while(|word| **word == fill).count();
    match row[..used].last() {
        None => u64::from(fill != 0),
        Some(top) => 64 * used as u64 - u64::from((top ^ fill).leading_zeros()) + u64::from(fill != 0),
    }
}

/// The integer as a row of `width` words, which it must fit.
pub(crate) fn from_int(x: &Int, width: usize) -> Vec<u64> {
    let mut row = match x.as_big() {
        None => vec![x.as_small().unwrap_or(0).unsigned_abs()],
        Some(big) => big.iter_u64_digits().collect(),
    };
    debug_assert!(row.len() <= width);
    row.resize(width, 0);
    if num_traits::Signed::is_negative(x) {
        negate(&mut row);
    }
    row
}

/// The integer that a row stands for.
pub(crate) fn into_int(mut row: Vec<u64>) -> Int {
    let fill = fill(&row);
    while row.len() > 1 && row[row.len() - 1] == fill && row[row.len() - 2] >> 63 == fill >> 63 {
        row.pop();
    }
    if let [word] = row[..] {
        return Int::from(word as i64);
    }
    let sign = if fill == 0 { Sign::Plus } else { Sign::Minus };
    if sign == Sign::Minus {
        negate(&mut row);
    }
    let halves = row.iter().flat_map(|&word| [word as u32, (word >> 32) as u32]).collect();
    Int::from(BigInt::from_biguint(sign, BigUint::new(halves)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_int() -> impl Strategy<Value = Int> {
        prop_oneof![
            (-3i64..4).prop_map(Int::from),
            any::<i64>().prop_map(Int::from),
            Just(Int::from(i64::MIN)),
            any::<i128>().prop_map(Int::from),
            Just(Int::from(i128::MIN)),
            (any::<i128>(), 1u32..5).prop_map(|(x, e)| Int::from(x).pow(e)),
            (0u32..600, any::<bool>())
                .prop_map(|(e, minus)| Int::from(2).pow(e) * Int::from(if minus { -1 } else { 1 })),
        ]
    }

    proptest! {
        #[test]
        fn rows_are_integers(x in any_int(), y in any_int(), scale in 0..1u64 << 63, factor in 0..1u64 << 63) {
            let width = (x.bits().max(y.bits()) / 64 + 3) as usize;
            let (mut row, other) = (from_int(&x, width), from_int(&y, width));
            prop_assert_eq!(&into_int(row.clone()), &x);
            prop_assert!((x.bits()..=x.bits() + 1).contains(&bits(&row)));
            scale_and_add(&mut row, scale, &other, factor);
            prop_assert_eq!(into_int(row), x * Int::from(scale) + y * Int::from(factor));
        }
    }
}
