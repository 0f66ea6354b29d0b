//! Arithmetic on rows of machine words, modulo 2^(64 w).
//!
//! A row of w words stands for an integer in two's complement, least significant
//! word first. Sums and products by one word are taken modulo 2^(64 w), so signs
//! need no care as long as the true result fits.

/// acc += row · factor (mod 2^(64 w)); the row is read up to the length of `acc`.
#[inline]
pub(super) fn add_scaled(acc: &mut [u64], row: &[u64], factor: u64) {
    let mut carry = 0u64;
    for (a, &r) in acc.iter_mut().zip(row) {
        let sum = u128::from(r) * u128::from(factor) + u128::from(*a) + u128::from(carry);
        *a = sum as u64;
        carry = (sum >> 64) as u64;
    }
}

/// acc −= row · factor (mod 2^(64 w)).
#[inline]
pub(super) fn sub_scaled(acc: &mut [u64], row: &[u64], factor: u64) {
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
pub(super) fn set_scaled(acc: &mut [u64], row: &[u64], factor: u64) {
    let mut carry = 0u64;
    for (a, &r) in acc.iter_mut().zip(row) {
        let product = u128::from(r) * u128::from(factor) + u128::from(carry);
        *a = product as u64;
        carry = (product >> 64) as u64;
    }
}

/// Replaces the row by its negative (mod 2^(64 w)).
pub(super) fn negate(row: &mut [u64]) {
    let mut carry = true;
    for word in row {
        let (flipped, overflow) = (!*word).overflowing_add(u64::from(carry));
        *word = flipped;
        carry = overflow;
    }
}

/// Whether the row stands for a negative number.
pub(super) fn is_negative(row: &[u64]) -> bool {
    row.last().is_some_and(|&top| top >> 63 == 1)
}

/// The number modulo the word `m`, for a row read as nonnegative.
pub(super) fn mod_word(row: &[u64], m: u64) -> u64 {
    row.iter().rev().fold(0, |r, &word| (((u128::from(r) << 64) | u128::from(word)) % u128::from(m)) as u64)
}

/// Divides a row read as nonnegative by the word `m`, which must divide it.
pub(super) fn divide_word(row: &mut [u64], m: u64) {
    let mut remainder = 0u64;
    for word in row.iter_mut().rev() {
        let value = (u128::from(remainder) << 64) | u128::from(*word);
        *word = (value / u128::from(m)) as u64;
        remainder = (value % u128::from(m)) as u64;
    }
    debug_assert_eq!(remainder, 0);
}
