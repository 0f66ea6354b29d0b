//! Division of dense integer vectors, in the form of `dense`.
//!
//! An exact quotient is found from the top, each coefficient from one sum of products, and then proved: by the
//! product with the divisor, or, where the division is known modulo a number, by the sizes alone. With word-sized
//! entries of the divisor, division with remainder keeps its long rows in place, as words in two's complement.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::dense::{add_product, common_divisor, height_bits, product, trim};
use crate::budget;
use crate::math::number::{Int, limbs};

/// The result of [`pseudo_division`]: scale · a = quotient · b + remainder.
pub(super) struct Division {
    pub quotient: Vec<Int>,
    pub remainder: Vec<Int>,
    /// Positive.
    pub scale: Int,
}

/// From this many entries of the triangle of a division on, rows of words are faster.
const FEW_ENTRIES: usize = 64;

/// Division of a by b ≠ 0 over the integers, with the least scaling at each step.
///
/// The scale divides a power of lead(b); it is 1 when b is monic.
/// Cost: O((deg a − deg b + 1) · deg b) products by a word if b has words, else of long integers.
pub(super) fn pseudo_division(a: &[Int], b: &[Int]) -> Division {
    let steps = (a.len() + 1).saturating_sub(b.len());
    let word = |x: &Int| x.as_small().filter(|x| *x != i64::MIN);
    match b.iter().map(word).collect::<Option<Vec<i64>>>() {
        Some(words) if steps.saturating_mul(b.len()) >= FEW_ENTRIES => division_by_words(a, &words),
        _ => plain_division(a, b),
    }
}

/// What takes the leading coefficient `top` away: (factor, growth) with growth · top = factor · lead, growth > 0.
fn least_factors(top: &Int, lead: &Int) -> (Int, Int) {
    let shared = common_divisor(top, std::slice::from_ref(lead));
    let (factor, growth) = (top.div_exact(&shared), lead.div_exact(&shared));
    if growth.is_negative() { (-factor, -growth) } else { (factor, growth) }
}

/// [`pseudo_division`] from its definition.
fn plain_division(a: &[Int], b: &[Int]) -> Division {
    let mut remainder = a.to_vec();
    let mut scale = Int::ONE;
    let mut quotient = vec![Int::ZERO; (a.len() + 1).saturating_sub(b.len())];
    let lead = &b[b.len() - 1];
    while remainder.len() >= b.len() {
        let offset = remainder.len() - b.len();
        let (factor, growth) = least_factors(&remainder[remainder.len() - 1], lead);
        if !growth.is_one() {
            budget::charge_bits(remainder[0].bits());
            for x in remainder.iter_mut().chain(&mut quotient[offset..]) {
                *x *= &growth;
            }
            scale *= &growth;
        }
        budget::steps(1 + (b.len() / 64) as u32);
        for (x, y) in remainder[offset..].iter_mut().zip(b) {
            if !y.is_zero() {
                *x -= &factor * y;
            }
        }
        quotient[offset] = factor;
        trim(&mut remainder);
    }
    trim(&mut quotient);
    Division { quotient, remainder, scale }
}

/// Steps of a division after which the size of the rows is looked at again.
const STEPS_BETWEEN_MEASURES: usize = 8;

/// [`pseudo_division`] by a polynomial of words other than −2^63, longer than none.
///
/// Only the entries that the divisor reaches are scaled at each step, in place, together with the subtraction; an entry
/// below gets all scales at once when it is reached, a coefficient of the quotient at the end.
fn division_by_words(a: &[Int], b: &[i64]) -> Division {
    let m = b.len();
    let lead = Int::from(b[m - 1]);
    let divisor_bits = u64::from(b.iter().map(|y| 64 - y.unsigned_abs().leading_zeros()).max().unwrap_or(0));
    let mut quotient = vec![Int::ZERO; a.len() + 1 - m];
    let mut growths = vec![Int::ONE; quotient.len()];
    let mut scale = Int::ONE;
    // No entry of a row has more bits than this.
    let mut bits = height_bits(a);
    let mut width = (bits / 64 + 1) as usize;
    // The rows of the entries from `reached` on.
    let mut reached = a.len() + 1 - m;
    let mut rows: std::collections::VecDeque<Vec<u64>> =
        a[reached..].iter().map(|x| limbs::from_int(x, width)).collect();
    for step in 0usize.. {
        while rows.back().is_some_and(|row| row.iter().all(Zero::is_zero)) {
            rows.pop_back();
        }
        let length = reached + rows.len();
        if length < m || length == 0 {
            break;
        }
        let offset = length - m;
        while reached > offset {
            reached -= 1;
            let entry = &a[reached] * &scale;
            bits = bits.max(entry.bits());
            widen(&mut rows, &mut width, bits);
            rows.push_front(limbs::from_int(&entry, width));
        }
        let top = limbs::into_int(rows.pop_back().unwrap_or_default());
        if top.is_zero() {
            continue;
        }
        let (factor, growth) = least_factors(&top, &lead);
        let grown = if growth.is_one() { 0 } else { growth.bits() };
        bits = (bits + grown).max(factor.bits() + divisor_bits) + 1;
        budget::charge_bits(bits);
        budget::steps(1 + (m * width / 256) as u32);
        widen(&mut rows, &mut width, bits);
        let plus = limbs::from_int(&factor, width);
        let mut minus = plus.clone();
        limbs::negate(&mut minus);
        let growth_word = growth.as_small().unwrap_or(1).unsigned_abs();
        for (row, &y) in rows.iter_mut().zip(b) {
            let other = if y > 0 { &minus } else { &plus };
            limbs::scale_and_add(row, growth_word, other, y.unsigned_abs());
        }
        scale *= &growth;
        growths[offset] = growth;
        quotient[offset] = factor;
        if step % STEPS_BETWEEN_MEASURES == STEPS_BETWEEN_MEASURES - 1 {
            bits = rows.iter().map(|row| limbs::bits(row)).max().unwrap_or(0);
        }
    }
    let mut remainder: Vec<Int> = a[..reached].iter().map(|x| x * &scale).collect();
    remainder.extend(rows.into_iter().map(limbs::into_int));
    trim(&mut remainder);
    let mut later = Int::ONE;
    for (x, growth) in quotient.iter_mut().zip(&growths) {
        *x *= &later;
        later *= growth;
    }
    trim(&mut quotient);
    Division { quotient, remainder, scale }
}

/// Gives all rows room for numbers of so many bits, and a sign.
fn widen(rows: &mut std::collections::VecDeque<Vec<u64>>, width: &mut usize, bits: u64) {
    let wanted = (bits / 64 + 1) as usize;
    if wanted > *width {
        rows.iter_mut().for_each(|row| row.resize(wanted, limbs::fill(row)));
        *width = wanted;
    }
}

/// a / b over the integers if it has integer entries, for b ≠ 0.
///
/// Cost: the product of the lengths of quotient and divisor at most.
pub(super) fn exact_quotient(a: &[Int], b: &[Int]) -> Option<Vec<Int>> {
    let quotient = quotient_from_top(a, b)?;
    (product(&quotient, b) == a).then_some(quotient)
}

/// Whether b divides a over the integers, given that it does modulo `modulus`, which is prime to lead(b); b ≠ 0.
///
/// The quotient found from the top is the one modulo `modulus`, so that a − quotient · b is 0 modulo it, and 0 if it is
/// small.
pub(super) fn divides_given_modulo(a: &[Int], b: &[Int], modulus: &Int) -> bool {
    let Some(quotient) = quotient_from_top(a, b) else { return false };
    let terms = u64::from(usize::BITS - quotient.len().min(b.len()).leading_zeros());
    let bits = (height_bits(&quotient) + height_bits(b) + terms).max(height_bits(a));
    // |a − quotient · b| < 2^(bits + 1) ≤ modulus
    bits + 2 <= modulus.bits() || product(&quotient, b) == a
}

/// The only candidate for a / b over the integers; `None` if there is none. b ≠ 0.
fn quotient_from_top(a: &[Int], b: &[Int]) -> Option<Vec<Int>> {
    if a.is_empty() {
        return Some(Vec::new());
    }
    let length = (a.len() + 1).checked_sub(b.len()).filter(|length| *length > 0)?;
    // The lowest coefficients tell most failures.
    let (first, divisor) = (&a[0], &b[0]);
    if if divisor.is_zero() { !first.is_zero() } else { !(first % divisor).is_zero() } {
        return None;
    }
    match quotient_of_words(a, b, length) {
        Some(quotient) => quotient,
        None => quotient_of_integers(a, b, length),
    }
}

fn quotient_of_integers(a: &[Int], b: &[Int], length: usize) -> Option<Vec<Int>> {
    let (lead, lower) = b.split_last()?;
    let mut quotient = vec![Int::ZERO; length];
    for k in (0..length).rev() {
        let (done, later) = quotient.split_at_mut(k + 1);
        budget::steps(1 + (later.len().min(lower.len()) / 64) as u32);
        let mut total = BigInt::ZERO;
        for (x, y) in later.iter().zip(lower.iter().rev()) {
            add_product(&mut total, x, y);
        }
        let (factor, rest) = (&a[k + lower.len()] - Int::from(total)).div_rem(lead);
        if !rest.is_zero() {
            return None;
        }
        done[k] = factor;
    }
    Some(quotient)
}

/// The same while everything fits words, sums 127 bits; `None` if not.
fn quotient_of_words(a: &[Int], b: &[Int], length: usize) -> Option<Option<Vec<Int>>> {
    let words = |list: &[Int]| list.iter().map(Int::as_small).collect::<Option<Vec<i64>>>();
    let (a, mut reversed) = (words(a)?, words(b)?);
    reversed.reverse();
    let (lead, lower) = reversed.split_first()?;
    let size = |x: i64| 64 - x.unsigned_abs().leading_zeros();
    let divisor_bits = reversed.iter().map(|y| size(*y)).max()?;
    let room = 125u32.checked_sub(divisor_bits + (usize::BITS - length.min(lower.len()).leading_zeros()))?;
    let mut quotient = vec![0i64; length];
    for k in (0..length).rev() {
        let (done, later) = quotient.split_at_mut(k + 1);
        budget::steps((later.len().min(lower.len()) / 1024) as u32);
        let pairs = later.iter().zip(lower);
        let total: i128 = pairs.map(|(x, y)| i128::from(*x) * i128::from(*y)).sum();
        let (top, lead) = (i128::from(a[k + lower.len()]) - total, i128::from(*lead));
        let (factor, rest) = match (i64::try_from(top), i64::try_from(lead)) {
            (Ok(top), Ok(lead)) if lead != -1 => (i128::from(top / lead), i128::from(top % lead)),
            _ => (top / lead, top % lead),
        };
        if rest != 0 {
            return Some(None);
        }
        let factor = i64::try_from(factor).ok()?;
        if size(factor) > room {
            return None;
        }
        done[k] = factor;
    }
    Some(Some(quotient.into_iter().map(Int::from).collect()))
}

#[cfg(test)]
mod tests {
    use super::super::dense::tests::vector;
    use super::super::dense::{scaled, sum};
    use super::*;
    use proptest::prelude::*;

    /// Words of all sizes, often 0, with leads that share factors with what they divide.
    fn words(longest: usize) -> impl Strategy<Value = Vec<Int>> {
        let entry = prop_oneof![
            2 => Just(0i64),
            4 => -9i64..10,
            2 => prop_oneof![Just(60i64), Just(-120), Just(1), Just(-1)],
            1 => any::<i64>(),
            1 => prop_oneof![Just(i64::MIN), Just(i64::MAX), Just(-i64::MAX)],
        ];
        prop::collection::vec(entry.prop_map(Int::from), 1..longest).prop_map(|mut list| {
            trim(&mut list);
            list
        })
    }

    fn check_division(a: &[Int], b: &[Int]) {
        let plain = plain_division(a, b);
        for d in [pseudo_division(a, b), plain] {
            assert!(d.remainder.len() < b.len());
            assert!(d.scale.is_positive());
            assert!(d.quotient.last().is_none_or(|x| !x.is_zero()));
            assert!(d.remainder.last().is_none_or(|x| !x.is_zero()));
            assert_eq!(scaled(a, &d.scale), sum(&product(&d.quotient, b), &d.remainder));
        }
        let small: Option<Vec<i64>> = b.iter().map(|y| y.as_small().filter(|y| *y != i64::MIN)).collect();
        if let Some(small) = small
            && a.len() >= b.len()
        {
            let (rows, plain) = (division_by_words(a, &small), plain_division(a, b));
            assert_eq!(rows.scale, plain.scale);
            assert_eq!((rows.quotient, rows.remainder), (plain.quotient, plain.remainder));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(100))]

        #[test]
        fn divisions_satisfy_their_identities(a in vector(12), b in vector(6)) {
            prop_assume!(!b.is_empty());
            check_division(&a, &b);
            prop_assert_eq!(exact_quotient(&product(&a, &b), &b), Some(a.clone()));
            let off = sum(&scaled(&product(&a, &b), &Int::from(2)), &[Int::ONE]);
            let (two_b, zero) = (scaled(&b, &Int::from(2)), Vec::new());
            prop_assert_eq!(exact_quotient(&off, &two_b), None);
            prop_assert_eq!(exact_quotient(&zero, &b), Some(Vec::new()));
        }

        #[test]
        fn rows_of_words_agree_with_the_definition(a in words(60), b in words(20), c in words(9), long in vector(40)) {
            prop_assume!(!b.is_empty());
            check_division(&a, &b);
            check_division(&long, &b);
            // A quotient without denominators, and one with a short remainder.
            let multiple = product(&a, &b);
            check_division(&multiple, &b);
            check_division(&sum(&multiple, &c), &b);
            prop_assert_eq!(exact_quotient(&multiple, &b), Some(a.clone()));
        }

        /// A change of one coefficient spoils a quotient, wherever it is.
        #[test]
        fn what_is_not_divisible_has_no_quotient(a in words(30), b in words(12), at in 0usize..40, by in 1i64..3) {
            prop_assume!(b.len() > 1 && !a.is_empty());
            let mut multiple = product(&a, &b);
            let at = at % multiple.len();
            multiple[at] += Int::from(by);
            trim(&mut multiple);
            // Only a multiple of b may differ by c t^k.
            let monomial = b[..b.len() - 1].iter().all(Zero::is_zero);
            prop_assume!(!monomial);
            prop_assert_eq!(exact_quotient(&multiple, &b), None);
            prop_assert!(!divides_given_modulo(&multiple, &b, &Int::ONE));
            prop_assert!(divides_given_modulo(&product(&a, &b), &b, &Int::ONE));
        }
    }
}
