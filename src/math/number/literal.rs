//! Reading decimal literals exactly: 0.25 is 1/4, never a float.

use std::fmt;

use num_integer::Integer;
use num_traits::Zero;

use super::{Int, Rational};

/// Numerals of at most this many digits are converted at once.
const SHORT: usize = 2_000;

/// Why a numeral could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LiteralError {
    /// There is no digit.
    NoDigits,
    /// A character other than a digit or a single decimal point stands at this byte.
    Unexpected(usize),
}

impl fmt::Display for LiteralError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LiteralError::NoDigits => f.write_str("a number needs at least one digit"),
            LiteralError::Unexpected(at) => {
                write!(f, "unexpected character at byte {at} of a number")
            }
        }
    }
}

impl std::error::Error for LiteralError {}

/// The exact value of an unsigned decimal numeral such as `12`, `0.25`, `.5` or `3.`.
///
/// Cost: a few multiplications of integers with that many digits (a million digits
/// take about a tenth of a second).
///
/// # Errors
/// [`LiteralError`] when the text is not such a numeral.
///
/// ```
/// use polarform::number::parse_decimal;
/// assert_eq!(parse_decimal("0.25").unwrap().to_string(), "1/4");
/// assert!(parse_decimal("1.2.3").is_err());
/// ```
pub fn parse_decimal(text: &str) -> Result<Rational, LiteralError> {
    let mut point = None;
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'0'..=b'9' => {}
            b'.' if point.is_none() => point = Some(at),
            _ => return Err(LiteralError::Unexpected(at)),
        }
    }
    let (whole, fraction) = match point {
        Some(at) => (&text[..at], &text[at + 1..]),
        None => (text, ""),
    };
    if whole.is_empty() && fraction.is_empty() {
        return Err(LiteralError::NoDigits);
    }
    let fraction = fraction.trim_end_matches('0');
    let numerator = integer(&format!("{whole}{fraction}"));
    let places = u32::try_from(fraction.len()).map_err(|_| LiteralError::Unexpected(text.len()))?;
    if text.len() <= SHORT {
        return Ok(Rational::new(numerator, Int::from(10).pow(places)));
    }
    // The denominator has no other primes than 2 and 5; a gcd would be far slower.
    let (numerator, twos) = without_factor(numerator, 2, places);
    let (numerator, fives) = without_factor(numerator, 5, places);
    Ok(Rational::new_raw(numerator, Int::from(2).pow(places - twos) * Int::from(5).pow(places - fives)))
}

/// The value of a decimal number times a power of ten: `2.5E2`, `1500E-1`.
///
/// # Errors
/// As for [`parse_decimal`]; also an exponent of more than four digits. Cost: that of 10^exponent.
///
/// ```
/// use polarform::number::parse_scientific;
/// assert_eq!(parse_scientific("2.5E2").unwrap().to_string(), "250");
/// assert_eq!(parse_scientific("1E-3").unwrap().to_string(), "1/1000");
/// assert!(parse_scientific("1E123456").is_err());
/// ```
pub fn parse_scientific(text: &str) -> Result<Rational, LiteralError> {
    const LONGEST: usize = 4;
    let Some((number, power)) = text.split_once(['E', 'e']) else { return parse_decimal(text) };
    let place = number.len() + 1;
    let digits = power.trim_start_matches(['+', '-']);
    let exponent: u32 = match digits.len() <= LONGEST {
        true => digits.parse().map_err(|_| LiteralError::Unexpected(place))?,
        false => return Err(LiteralError::Unexpected(place)),
    };
    let scale = Rational::from_integer(Int::from(10).pow(exponent));
    let value = parse_decimal(number)?;
    Ok(if power.starts_with('-') { value / scale } else { value * scale })
}

/// The value of a run of digits: the halves of a long one are converted by themselves.
fn integer(digits: &str) -> Int {
    if digits.len() <= SHORT {
        return digits.parse().unwrap_or(Int::ZERO); // only the empty run does not parse
    }
    let low = digits.len() / 2;
    let (high, rest) = digits.split_at(digits.len() - low);
    let places = u32::try_from(low).unwrap_or(u32::MAX); // no text in memory has 2^33 digits
    integer(high) * Int::from(10).pow(places) + integer(rest)
}

/// Divides by p as often as it goes, at most `limit` times; says how often.
///
/// Tries p, p², p⁴, … and then the same powers downwards, so that the number of
/// divisions is logarithmic.
fn without_factor(mut number: Int, p: i64, limit: u32) -> (Int, u32) {
    if number.is_zero() {
        return (number, limit);
    }
    let mut count = 0;
    let mut powers = vec![(Int::from(p), 1_u32)];
    while let Some((power, exponent)) = powers.last().filter(|(_, e)| *e <= limit - count) {
        let (quotient, remainder) = number.div_rem(power);
        if !remainder.is_zero() {
            break;
        }
        number = quotient;
        count += exponent;
        let next = (power * power, exponent * 2);
        powers.push(next);
    }
    for (power, exponent) in powers.iter().rev().filter(|(_, e)| *e <= limit) {
        if *exponent > limit - count {
            continue;
        }
        let (quotient, remainder) = number.div_rem(power);
        if remainder.is_zero() {
            number = quotient;
            count += exponent;
        }
    }
    (number, count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::rational;

    #[test]
    fn exact() {
        assert_eq!(parse_decimal("0.1"), Ok(rational(1, 10)));
        assert_eq!(parse_decimal("3."), Ok(rational(3, 1)));
        assert_eq!(parse_decimal(".5"), Ok(rational(1, 2)));
        assert_eq!(parse_decimal("007"), Ok(rational(7, 1)));
        assert_eq!(parse_decimal(""), Err(LiteralError::NoDigits));
        assert_eq!(parse_decimal("."), Err(LiteralError::NoDigits));
        assert_eq!(parse_decimal("0.00"), Ok(rational(0, 1)));
        assert_eq!(parse_decimal("2.50"), Ok(rational(5, 2)));
        assert_eq!(parse_decimal("1e5"), Err(LiteralError::Unexpected(1)));
    }

    #[test]
    fn long_numerals_agree_with_the_gcd() {
        let power = |p: i64, n: u32| Int::from(p).pow(n).to_string();
        for digits in [
            "1".repeat(SHORT + 1),
            "0".repeat(2 * SHORT + 3),
            power(2, 9000),
            power(5, 4000),
            power(10, 3000),
            format!("{}1", power(5, 4000)),
            format!("{}{}", power(7, 3000), power(2, 101)),
        ] {
            let value: Int = digits.parse().expect("digits");
            assert_eq!(parse_decimal(&digits), Ok(Rational::from_integer(value.clone())));
            for places in [1, 2, 100, digits.len() - 1, digits.len()] {
                let (whole, fraction) = digits.split_at(digits.len() - places);
                let expected = Rational::new(value.clone(), Int::from(10).pow(places as u32));
                assert_eq!(parse_decimal(&format!("{whole}.{fraction}")), Ok(expected));
            }
        }
    }
}
