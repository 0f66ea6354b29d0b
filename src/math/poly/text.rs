//! Sums of terms as text.

use std::fmt::{Display, Formatter, Result};

use super::Coefficients;
use crate::math::ring::Ring;

/// The sum of coefficients, each times what is written behind it; nothing is written behind a constant. Terms that
/// are 0 are left out.
pub(in crate::math) fn sum<'a, C: Ring + Display>(
    f: &mut Formatter<'_>,
    terms: impl IntoIterator<Item = (&'a C, String)>,
) -> Result {
    let mut first = true;
    for (coefficient, behind) in terms.into_iter().filter(|(c, _)| !c.is_zero()) {
        let text = coefficient.to_string();
        let several = text.contains(" + ") || text.contains(" - ");
        let (sign, size) = match text.strip_prefix('-') {
            Some(rest) if !several => ("-", rest.to_owned()),
            _ => ("", text),
        };
        f.write_str(match (first, sign) {
            (true, sign) => sign,
            (false, "") => " + ",
            (false, _) => " - ",
        })?;
        first = false;
        match (behind.as_str(), size.as_str()) {
            ("", size) => f.write_str(size)?,
            (behind, "1") => f.write_str(behind)?,
            (behind, size) if several => write!(f, "({size}) {behind}")?,
            (behind, size) => write!(f, "{size} {behind}")?,
        }
    }
    if first { f.write_str("0") } else { Ok(()) }
}

/// `x^k`, nothing for k = 0.
pub(in crate::math) fn power(name: &str, exponent: usize) -> String {
    match exponent {
        0 => String::new(),
        1 => name.to_owned(),
        k => format!("{name}^{k}"),
    }
}

/// `t^2 + 2 t`
impl<C: Ring + Display> Display for Coefficients<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        sum(f, self.iter().enumerate().rev().map(|(k, c)| (c, power("t", k))))
    }
}

debug_by_text!(Coefficients);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer as z, rational as q};

    #[test]
    fn highest_power_first() {
        let list = Coefficients::new(vec![q(-1, 2), z(0), z(1), z(-3)]);
        assert_eq!(list.to_string(), "-3 t^3 + t^2 - 1/2");
        assert_eq!(format!("{list:?}"), "Coefficients(-3 t^3 + t^2 - 1/2)");
        assert_eq!(Coefficients::<crate::math::number::Rational>::zero().to_string(), "0");
    }
}
