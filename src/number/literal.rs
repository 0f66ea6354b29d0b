//! Reading decimal literals exactly: 0.25 is 1/4, never a float.

use std::fmt;

use super::{Int, Rational};

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
/// Cost: that of radix conversion of the digits, quadratic in their number at worst.
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
    let digits = format!("{whole}{fraction}");
    let numerator: Int = digits.parse().map_err(|_| LiteralError::NoDigits)?;
    if fraction.is_empty() {
        return Ok(Rational::from_integer(numerator));
    }
    let places = u32::try_from(fraction.len()).map_err(|_| LiteralError::Unexpected(text.len()))?;
    Ok(Rational::new(numerator, Int::from(10).pow(places)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::rational;

    #[test]
    fn exact() {
        assert_eq!(parse_decimal("0.1"), Ok(rational(1, 10)));
        assert_eq!(parse_decimal("3."), Ok(rational(3, 1)));
        assert_eq!(parse_decimal(".5"), Ok(rational(1, 2)));
        assert_eq!(parse_decimal("007"), Ok(rational(7, 1)));
        assert_eq!(parse_decimal(""), Err(LiteralError::NoDigits));
        assert_eq!(parse_decimal("."), Err(LiteralError::NoDigits));
        assert_eq!(parse_decimal("1e5"), Err(LiteralError::Unexpected(1)));
    }
}
