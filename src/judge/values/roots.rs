//! Square roots of numbers: symbols √p of primes, whose squares are p.
//!
//! The products of different √p are linearly independent over the rational numbers, so a polynomial in them in
//! which every power is below 2 is 0 only if all of its coefficients are.

use crate::judge::values::equality::differences;
use crate::language::value::Value;
use crate::math::number::{Int, Rational, integer, rational};
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};
use crate::math::ring::Ring;
use num_traits::{One, Signed, ToPrimitive, Zero};

const SIGN: char = '√';

/// Larger numbers are not taken apart.
const LARGEST: u64 = 1_000_000;

/// √q as a product of a number and symbols; `None` for negative and for large numbers.
///
/// Cost: the square root of the numerator times the denominator, in trial divisions.
pub fn square_root(q: &Rational) -> Option<Fraction> {
    if q.is_negative() {
        return None;
    }
    // √(a/b) = √(ab)/b
    let mut rest = (q.numer() * q.denom()).to_u64().filter(|product| *product <= LARGEST)?;
    if rest == 0 {
        return Some(Fraction::zero());
    }
    let mut root = Fraction::from_rational(&Rational::new(Int::one(), q.denom().clone()));
    let factor = |prime: u64, root: &mut Fraction, count: u32| {
        let whole = Rational::from_integer(Int::from(prime).pow(count / 2));
        *root = root.scaled(&whole);
        if count % 2 == 1 {
            *root = root.times(&Fraction::from(MultiPoly::symbol(Symbol::new(format!("{SIGN}{prime}")))));
        }
    };
    let mut prime = 2;
    while prime * prime <= rest {
        let mut count = 0;
        while rest % prime == 0 {
            rest /= prime;
            count += 1;
        }
        factor(prime, &mut root, count);
        prime += 1;
    }
    if rest > 1 {
        factor(rest, &mut root, 1);
    }
    Some(root)
}

/// cos(qπ), where it is a polynomial in square roots: for multiples of 15° and of 36°.
pub fn cosine(q: &Rational) -> Option<Fraction> {
    let whole = q.abs() % integer(2);
    let mirrored = if whole > integer(1) { integer(2) - whole } else { whole };
    let obtuse = mirrored > rational(1, 2);
    let acute = if obtuse { integer(1) - mirrored } else { mirrored };
    let root = |number: i64| square_root(&integer(number));
    let number = |value: Rational| Some(Fraction::from_rational(&value));
    let part = |sum: Fraction, of: i64| sum.scaled(&rational(1, of));
    let value = match (acute.numer().to_u64()?, acute.denom().to_u64()?) {
        (0, 1) => number(integer(1))?,
        (1, 2) => Fraction::zero(),
        (1, 3) => number(rational(1, 2))?,
        (1, 4) => part(root(2)?, 2),
        (1, 6) => part(root(3)?, 2),
        (1, 5) => part(number(integer(1))?.plus(&root(5)?), 4),
        (2, 5) => part(root(5)?.minus(&number(integer(1))?), 4),
        (1, 12) => part(root(6)?.plus(&root(2)?), 4),
        (5, 12) => part(root(6)?.minus(&root(2)?), 4),
        _ => return None,
    };
    Some(if obtuse { -value } else { value })
}

/// Whether a symbol stands for the root of a number.
pub fn is_root(symbol: &Symbol) -> bool {
    radicand(symbol).is_some()
}

fn radicand(symbol: &Symbol) -> Option<u64> {
    symbol.base().strip_prefix(SIGN)?.parse().ok()
}

/// The polynomial with every √p² put as p.
fn reduced(polynomial: &MultiPoly) -> MultiPoly {
    let roots: Vec<(Symbol, u64)> =
        polynomial.variables().iter().filter_map(|s| Some((s.clone(), radicand(s)?))).collect();
    let mut result = polynomial.clone();
    for (symbol, prime) in roots {
        let mut parts = [MultiPoly::zero(), MultiPoly::zero()];
        let mut power = Rational::one();
        for (k, coefficient) in result.coefficients_in(&symbol).into_iter().enumerate() {
            parts[k % 2] = parts[k % 2].plus(&coefficient.scaled(&power));
            if k % 2 == 1 {
                power *= Rational::from_integer(prime.into());
            }
        }
        let [even, odd] = parts;
        result = even.plus(&odd.times(&MultiPoly::symbol(symbol)));
    }
    result
}

/// Numbers between which a formula of roots and numbers is, apart by some 10^-40.
pub fn bounds(formula: &Fraction) -> Option<(Rational, Rational)> {
    let digits = Int::from(10).pow(40);
    let below = |symbol: &Symbol| -> Option<Rational> {
        let whole = (Int::from(radicand(symbol)?) * &digits * &digits).into_big().sqrt();
        Some(Rational::new(Int::from(whole), digits.clone()))
    };
    let polynomial = |f: &MultiPoly| -> Option<(Rational, Rational)> {
        let mut sum = (Rational::zero(), Rational::zero());
        for (powers, coefficient) in f.terms(MonomialOrder::Lex) {
            let (mut low, mut high) = (Rational::one(), Rational::one());
            for (symbol, power) in powers.iter() {
                let root = below(symbol)?;
                let above = &root + Rational::new(Int::one(), digits.clone());
                low *= num_traits::pow(root, *power as usize);
                high *= num_traits::pow(above, *power as usize);
            }
            if coefficient.is_negative() {
                std::mem::swap(&mut low, &mut high);
            }
            sum = (sum.0 + low * &coefficient, sum.1 + high * &coefficient);
        }
        Some(sum)
    };
    let (above, below) = (polynomial(formula.numerator())?, polynomial(formula.denominator())?);
    if !below.0.is_positive() && !below.1.is_negative() {
        return None;
    }
    let ends = [&above.0 / &below.0, &above.0 / &below.1, &above.1 / &below.0, &above.1 / &below.1];
    Some((ends.iter().min()?.clone(), ends.iter().max()?.clone()))
}

/// Whether values with roots in them are equal; `None` if there are no roots, or they cannot be compared.
pub fn equal(left: &Value, right: &Value) -> Option<bool> {
    let differences = differences(left, right)?;
    let has_roots = |f: &Fraction| f.variables().iter().any(is_root);
    if !differences.iter().any(has_roots) {
        return None;
    }
    if differences.iter().any(|f| reduced(f.denominator()).is_empty()) {
        return None;
    }
    Some(differences.iter().all(|f| reduced(f.numerator()).is_empty()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer, rational};

    fn root(q: Rational) -> Value {
        Value::Scalar(square_root(&q).unwrap())
    }

    fn product(a: &Value, b: &Value) -> Value {
        Value::Scalar(a.as_scalar().unwrap().times(b.as_scalar().unwrap()))
    }

    #[test]
    fn squares_of_roots() {
        for q in [rational(1, 2), integer(12), rational(9, 4), integer(0), rational(6, 35), integer(97)] {
            let r = root(q.clone());
            let square = product(&r, &r);
            let whole =
                equal(&square, &Value::number(q.clone())).unwrap_or(square == Value::number(q.clone()));
            assert!(whole, "{q}");
            assert_ne!(equal(&square, &Value::number(q + integer(1))), Some(true));
        }
        assert!(square_root(&integer(-1)).is_none());
    }

    #[test]
    fn products_of_roots_agree_with_roots_of_products() {
        let (a, b, c) = (root(integer(6)), root(integer(10)), root(integer(60)));
        assert_eq!(equal(&product(&a, &b), &c), Some(true));
        assert_eq!(equal(&product(&a, &b), &root(integer(15))), Some(false));
    }
}
