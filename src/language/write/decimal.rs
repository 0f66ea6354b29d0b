//! Numerals: decimals where the expansion ends.

use num_traits::{Signed, Zero};

use crate::formula::Precedence;
use crate::math::number::{Int, Rational};

/// The precedence of a numeral that is printed by [`numeral`].
pub(super) fn level(value: &Rational) -> Precedence {
    if value.is_negative() {
        Precedence::Sum
    } else if value.is_integer() || places(value.denom()).is_some() {
        Precedence::Atom
    } else {
        Precedence::Product
    }
}

/// The numeral: an integer, a decimal where it ends, otherwise `p/q`.
pub(super) fn numeral(value: &Rational) -> String {
    match decimal(value) {
        Some(digits) => digits,
        None => format!("{}/{}", value.numer(), value.denom()),
    }
}

/// The decimal expansion if it ends. Numerals with a denominator come from decimals
/// (fractions are quotients in the tree), so that this is what was written.
pub(super) fn decimal(value: &Rational) -> Option<String> {
    if value.is_integer() {
        return Some(value.numer().to_string());
    }
    let (twos, fives) = places(value.denom())?;
    let places = twos.max(fives);
    let factor = power(2, places - twos) * power(5, places - fives);
    let digits = (value.numer().abs() * factor).to_string();
    let places = usize::try_from(places).ok()?;
    let sign = if value.is_negative() { "-" } else { "" };
    let padded = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = padded.split_at(padded.len() - places);
    Some(format!("{sign}{whole}.{fraction}"))
}

/// The exponents a, b if the denominator is 2^a 5^b.
fn places(denominator: &Int) -> Option<(u64, u64)> {
    if let Some(mut rest) = denominator.as_small() {
        let mut strip = |prime: i64| {
            let mut count = 0;
            while rest % prime == 0 {
                rest /= prime;
                count += 1;
            }
            count
        };
        let exponents = (strip(2), strip(5));
        return (rest == 1).then_some(exponents);
    }
    let big = denominator.to_big();
    let twos = big.trailing_zeros().unwrap_or(0);
    let rest = big >> twos;
    // 5^b has about b log2(5) bits: three candidates, instead of a division for each 5.
    let estimate = (rest.bits() as f64 / 5_f64.log2()) as u64;
    let fives = (estimate.saturating_sub(1)..=estimate + 1).find(|&exponent| {
        u32::try_from(exponent).is_ok_and(|e| num_bigint::BigInt::from(5).pow(e) == rest)
    })?;
    Some((twos, fives))
}

fn power(base: i64, exponent: u64) -> Int {
    if exponent.is_zero() {
        return Int::ONE;
    }
    let exponent = u32::try_from(exponent).expect("the denominator itself has a power of this size");
    Int::from(num_bigint::BigInt::from(base).pow(exponent))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{parse_decimal, rational};

    #[test]
    fn decimals_end_or_not() {
        for (p, q, text) in [
            (1, 4, "0.25"),
            (-1, 4, "-0.25"),
            (5, 2, "2.5"),
            (1, 1000, "0.001"),
            (1, 3, "1/3"),
            (-7, 6, "-7/6"),
            (12, 1, "12"),
            (0, 1, "0"),
            (1, 1 << 40, "0.0000000000009094947017729282379150390625"),
        ] {
            assert_eq!(numeral(&rational(p, q)), text);
        }
        assert_eq!(level(&rational(1, 3)), Precedence::Product);
        assert_eq!(level(&rational(1, 4)), Precedence::Atom);
        assert_eq!(level(&rational(-1, 4)), Precedence::Sum);
    }

    #[test]
    fn long_decimals_read_back() {
        for digits in [20, 50, 400] {
            for last in ["1", "5", "25", "2", "4"] {
                let text = format!("3.{}{last}", "0".repeat(digits));
                assert_eq!(numeral(&parse_decimal(&text).unwrap()), text);
            }
        }
    }
}
