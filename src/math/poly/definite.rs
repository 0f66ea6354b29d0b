//! Polynomials in several variables that are nowhere negative, as far as squares show it.

use num_traits::{One, Signed, Zero};

use super::{MonomialOrder, MultiPoly, Symbol};
use crate::math::number::Rational;

/// Polynomials of higher degree are not taken apart.
const HIGHEST_DEGREE: u32 = 12;

impl MultiPoly {
    /// Whether squares show that f ≥ 0, or f > 0, for all real values of its variables: f is a number times factors of
    /// which those with an odd multiplicity have a product of degree at most 2 that is a sum of squares of lines and a
    /// number. For degree 2 this decides; for a higher one (up to 12) false says nothing.
    ///
    /// Cost: that of the factors, and n³ steps for n variables.
    ///
    /// ```
    /// use polarform::poly::{MultiPoly, Symbol};
    /// let [a, b] = ["a", "b"].map(|name| MultiPoly::symbol(Symbol::new(name)));
    /// let square = &a * &a - &a * &b - &a * &b + &b * &b;
    /// assert!(square.is_nonnegative_by_squares(false));
    /// assert!(!square.is_nonnegative_by_squares(true));
    /// ```
    pub fn is_nonnegative_by_squares(&self, strict: bool) -> bool {
        match self.total_degree() {
            None => return !strict,
            Some(0..=2) => return is_semidefinite(self, strict),
            Some(degree) if degree > HIGHEST_DEGREE => return false,
            Some(_) => {}
        }
        let found = self.factors();
        let mut rest = MultiPoly::constant(found.constant);
        for (factor, multiplicity) in found.factors {
            match multiplicity % 2 {
                1 => rest *= factor,
                // An even power is 0 somewhere, unless its base is positive.
                _ if strict && !factor.is_nonnegative_by_squares(true) => return false,
                _ => {}
            }
            if rest.total_degree() > Some(2) {
                return false;
            }
        }
        is_semidefinite(&rest, strict)
    }
}

/// Whether a polynomial of degree at most 2 has no negative value, or its minimum is positive: by symmetric elimination
/// in its matrix, where each pivot has to be positive, or 0 with its whole row.
fn is_semidefinite(f: &MultiPoly, strict: bool) -> bool {
    let variables = f.variables();
    // The constant is eliminated last: what is left of it is the minimum.
    let last = variables.len();
    let place = |symbol: &Symbol| variables.iter().position(|own| own == symbol).unwrap_or(last);
    let size = last + 1;
    let mut rows = vec![vec![Rational::zero(); size]; size];
    let half = Rational::one() / Rational::from_integer(2.into());
    for (powers, c) in f.terms(MonomialOrder::Lex) {
        let (i, j) = match powers.as_slice() {
            [] => (last, last),
            [(x, 1)] => (last, place(x)),
            [(x, _)] => (place(x), place(x)),
            [(x, _), (y, _), ..] => (place(x), place(y)),
        };
        let share = if i == j { c } else { c * &half };
        rows[j][i] = share.clone();
        rows[i][j] = share;
    }
    for k in 0..size {
        if rows[k][k].is_zero() {
            if strict && k == last || rows[k][k..].iter().any(|entry| !entry.is_zero()) {
                return false;
            }
            continue;
        }
        if rows[k][k].is_negative() {
            return false;
        }
        let pivot = rows[k].clone();
        for row in rows.iter_mut().skip(k + 1) {
            let ratio = &row[k] / &pivot[k];
            for (entry, above) in row.iter_mut().zip(&pivot).skip(k) {
                *entry = &*entry - &ratio * above;
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::poly::Fraction;
    use proptest::prelude::*;

    fn symbols() -> [MultiPoly; 3] {
        ["a", "b", "c"].map(|name| MultiPoly::symbol(Symbol::new(name)))
    }

    fn number(c: i64) -> MultiPoly {
        MultiPoly::constant(Rational::from_integer(c.into()))
    }

    #[test]
    fn numbers_and_lines() {
        let [a, b, _] = symbols();
        for (f, nonnegative, positive) in [
            (number(0), true, false),
            (number(3), true, true),
            (number(-1), false, false),
            (a.clone(), false, false),
            (&a * &a, true, false),
            (&a * &a + &b * &b, true, false),
            (&a * &a + &b * &b + number(1), true, true),
            (&a * &b, false, false),
            (&a * &a - &a * &b, false, false),
            (&(&a * &a) * &(&b * &b), true, false),
            (&(&a * &a) * &b, false, false),
        ] {
            assert_eq!(f.is_nonnegative_by_squares(false), nonnegative, "{f}");
            assert_eq!(f.is_nonnegative_by_squares(true), positive, "{f}");
        }
    }

    proptest! {
        /// Sums of squares of linear forms are; and where it says so, no value is negative.
        #[test]
        fn sums_of_squares(
            lines in prop::collection::vec(prop::array::uniform4(-3i64..4), 1..4),
            other in prop::array::uniform10(-3i64..4),
            points in prop::collection::vec(prop::array::uniform3(-4i64..5), 20),
        ) {
            let [a, b, c] = symbols();
            let line = |l: &[i64; 4]| number(l[0]) + number(l[1]) * a.clone() + number(l[2]) * b.clone() + number(l[3]) * c.clone();
            let sum = lines.iter().map(|l| { let l = line(l); &l * &l }).fold(number(0), |sum, square| sum + square);
            prop_assert!(sum.is_nonnegative_by_squares(false));
            prop_assert!((sum.clone() + number(1)).is_nonnegative_by_squares(true));
            prop_assert!((&sum * &sum).is_nonnegative_by_squares(false));
            let monomials = [number(1), a.clone(), b.clone(), c.clone(), &a * &a, &a * &b, &a * &c, &b * &b, &b * &c, &c * &c];
            let any = monomials.iter().zip(other).fold(number(0), |sum, (m, q)| sum + number(q) * m.clone());
            for strict in [false, true] {
                if any.is_nonnegative_by_squares(strict) {
                    for point in &points {
                        let value = Fraction::from(any.clone()).value(&|s: &Symbol| {
                            let at = ["a", "b", "c"].iter().position(|name| s.base() == *name)?;
                            Some(Rational::from_integer(point[at].into()))
                        }).unwrap();
                        let right = if strict { value.is_positive() } else { !value.is_negative() };
                        prop_assert!(right);
                    }
                }
            }
        }
    }
}
