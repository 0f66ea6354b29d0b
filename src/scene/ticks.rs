//! Round numbers on an axis, exactly.

use num_traits::{One, Signed, ToPrimitive, pow};

use crate::formula::{Expr, Kind, Quotient, Sign, Term};
use crate::math::number::{Int, Rational, integer, rational};

/// About `count` multiples of 1, 2, 5/2 or 5 times a power of ten in [from, to], ascending.
///
/// Empty when `from > to` or an end is beyond the range of floating-point numbers; for
/// `from = to` only that number.
///
/// ```
/// use polarform::number::{integer, rational};
/// use polarform::scene::nice_ticks;
/// let ticks = nice_ticks(&integer(0), &integer(1), 4);
/// assert_eq!(ticks, [0, 1, 2, 3, 4].map(|i| rational(i, 4)));
/// ```
pub fn nice_ticks(from: &Rational, to: &Rational, count: usize) -> Vec<Rational> {
    if from == to {
        return vec![from.clone()];
    }
    let length = to - from;
    let Some(wanted) = (length.clone() / integer(count.clamp(1, 100) as i64)).to_f64() else {
        return Vec::new();
    };
    if !(length.is_positive() && wanted > 0.0 && wanted.is_finite()) {
        return Vec::new();
    }
    let exponent = wanted.log10().floor() as i32;
    // quarters, but not 5/2
    let quarter = if exponent == 0 { None } else { Some(rational(5, 2)) };
    let digits = [Some(integer(1)), Some(integer(2)), quarter, Some(integer(5)), Some(integer(10))];
    let farness = |step: &Rational| step.to_f64().map_or(f64::INFINITY, |step| (step / wanted).ln().abs());
    let Some(step) = digits
        .into_iter()
        .flatten()
        .map(|digit| digit * power_of_ten(exponent))
        .min_by(|a, b| farness(a).total_cmp(&farness(b)))
    else {
        return Vec::new();
    };
    let first = (from / &step).ceil();
    let last = (to / &step).floor();
    let number = (&last - &first).to_integer().to_usize().unwrap_or(0).min(400);
    if last < first {
        return Vec::new();
    }
    (0..=number).map(|i| (&first + integer(i as i64)) * &step).collect()
}

fn power_of_ten(exponent: i32) -> Rational {
    let power = pow(integer(10), exponent.unsigned_abs() as usize);
    if exponent < 0 { power.recip() } else { power }
}

/// The exact number as it is best written beside a picture.
///
/// Integers and quotients of small integers as they are (`1/3`), longer integers by their
/// leading digits and a power of ten if that is shorter (`2·10^30`); nothing is rounded.
///
/// ```
/// use polarform::number::{integer, rational};
/// use polarform::{scene::exact_text, write::text};
/// assert_eq!(text(&exact_text(&rational(-1, 3))), "-1/3");
/// assert_eq!(text(&exact_text(&integer(2_000_000_000))), "2*10^9");
/// ```
pub fn exact_text(value: &Rational) -> Expr {
    let magnitude = value.abs();
    let unsigned = match decimal_power(&magnitude) {
        Some((mantissa, exponent)) => {
            let power = Expr::int(10).power(Expr::int(exponent));
            if mantissa.is_one() {
                power
            } else {
                Kind::Mul(vec![Kind::Number(Rational::from_integer(mantissa)).into(), power]).into()
            }
        }
        None if magnitude.is_integer() => Kind::Number(magnitude).into(),
        None => {
            let part = |x: &Int| Box::new(Expr::from(Kind::Number(Rational::from_integer(x.clone()))));
            Kind::Div(part(magnitude.numer()), part(magnitude.denom()), Quotient::Slash).into()
        }
    };
    if value.is_negative() {
        Kind::Add(vec![Term { sign: Sign::Minus, expr: unsigned }]).into()
    } else {
        unsigned
    }
}

/// m and e with value = m 10^e and m not divisible by 10, where that is much shorter.
fn decimal_power(value: &Rational) -> Option<(Int, i64)> {
    let (digits, sign) = if value.is_integer() {
        (value.numer().to_string(), 1)
    } else if value.numer().is_one() {
        (value.denom().to_string(), -1)
    } else {
        return None;
    };
    let short = digits.trim_end_matches('0');
    let zeros = digits.len() - short.len();
    if short.is_empty() || zeros < 5 || (sign < 0 && short != "1") {
        return None;
    }
    let mantissa: Int = short.parse().ok()?;
    Some((mantissa, sign * i64::try_from(zeros).ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn ends() {
        assert_eq!(nice_ticks(&integer(3), &integer(3), 4), [integer(3)]);
        assert!(nice_ticks(&integer(3), &integer(2), 4).is_empty());
        let huge = pow(integer(10), 400);
        assert!(nice_ticks(&integer(0), &huge, 4).is_empty());
        assert_eq!(nice_ticks(&integer(0), &huge.recip(), 4), []);
        assert_eq!(nice_ticks(&integer(-1), &integer(3), 4), [-1, 0, 1, 2, 3].map(integer));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn a_few_ticks_inside(from in -5000_i64..5000, length in 1_i64..9999, divisor in 1_i64..900, count in 2_usize..9) {
            let (from, to) = (rational(from, divisor), rational(from + length, divisor));
            let ticks = nice_ticks(&from, &to, count);
            prop_assert!(!ticks.is_empty() && ticks.len() <= 2 * count + 1, "{ticks:?}");
            prop_assert!(ticks.iter().all(|tick| &from <= tick && tick <= &to));
            prop_assert!(ticks.windows(3).all(|w| &w[1] - &w[0] == &w[2] - &w[1]));
        }
    }
}
