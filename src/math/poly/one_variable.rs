//! Polynomials in several symbols that have only one: the kernels of [`Poly`](super::Poly) on them.
//!
//! The exponents of c t^3 + d t^5 + e t^11 are 3 + 2k: a *row* holds the coefficients for
//! k = 0, 1, …, here c, d, 0, 0, e. Where most of a row is not 0, arithmetic of rows is arithmetic of
//! dense vectors; other polynomials are *sparse*, and the functions here leave them to the caller.

use num_integer::Integer;
use num_traits::{Signed, Zero};

use super::multivariate::{Exponents, MultiPoly, Terms};
use super::{dense, dense_compose, dense_divide};
use crate::budget;
use crate::math::number::{Int, Rational};
use crate::math::ring::Ring;

type Term = (Exponents, Int);

/// A row may be this many times as long as the list of its terms.
const SPARSEST: u64 = 2;
/// Rows of up to this length are divided whatever their number of terms.
const SHORT_DIVIDEND: u64 = 1 << 16;

/// Coefficients of t^low, t^(low + step), … with the first and the last not 0.
struct Row {
    low: u32,
    coefficients: Vec<Int>,
}

/// Whether there is exactly one variable.
pub(super) fn has_one_variable(p: &MultiPoly) -> bool {
    p.vars.len() == 1
}

/// The lowest exponent and the highest.
fn ends(terms: &[Term]) -> (u32, u32) {
    match (terms.last(), terms.first()) {
        (Some((low, _)), Some((high, _))) => (low[0], high[0]),
        _ => (0, 0),
    }
}

/// The largest step that fits all lists.
fn common_step(lists: &[&[Term]]) -> u32 {
    difference_gcd(lists).max(1)
}

/// The gcd of all differences of exponents within a list; 0 for monomials.
fn difference_gcd(lists: &[&[Term]]) -> u32 {
    let mut step = 0;
    for terms in lists {
        let low = ends(terms).0;
        for (e, _) in terms.iter().rev() {
            step = step.gcd(&(e[0] - low));
            if step == 1 {
                return 1;
            }
        }
    }
    step
}

fn row_length(terms: &[Term], step: u32) -> u64 {
    let (low, high) = ends(terms);
    u64::from((high - low) / step) + 1
}

fn is_dense(terms: &[Term], step: u32) -> bool {
    row_length(terms, step) <= SPARSEST * terms.len() as u64
}

impl Row {
    fn of(terms: &[Term], step: u32) -> Row {
        Row::from_low(terms, step, ends(terms).0)
    }

    /// The coefficients from t^low on, where low may lie below the lowest exponent.
    fn from_low(terms: &[Term], step: u32, low: u32) -> Row {
        let mut coefficients = vec![Int::ZERO; ((ends(terms).1 - low) / step) as usize + 1];
        for (e, c) in terms {
            coefficients[((e[0] - low) / step) as usize] = c.clone();
        }
        Row { low, coefficients }
    }

    /// The terms in descending order.
    fn into_terms(self, step: u32) -> Terms {
        let list = self.coefficients.into_iter().zip(0u32..).filter(|(c, _)| !c.is_zero());
        let mut terms: Terms =
            list.map(|(c, k)| (Exponents::from_slice(&[self.low + k * step]), c)).collect();
        terms.reverse();
        terms
    }
}

/// The terms of a · b for polynomials in the same single variable; `None` if one is sparse.
pub(super) fn product(a: &[Term], b: &[Term]) -> Option<Terms> {
    ends(a).1.checked_add(ends(b).1)?;
    let step = common_step(&[a, b]);
    if !is_dense(a, step) || !is_dense(b, step) {
        return None;
    }
    let (a, b) = (Row::of(a, step), Row::of(b, step));
    let coefficients = dense::product(&a.coefficients, &b.coefficients);
    Some(Row { low: a.low + b.low, coefficients }.into_terms(step))
}

/// The terms of the power; `None` if the polynomial is sparse.
pub(super) fn power(a: &[Term], exponent: u32) -> Option<Terms> {
    ends(a).1.checked_mul(exponent)?;
    let step = common_step(&[a]);
    if !is_dense(a, step) {
        return None;
    }
    let row = Row::of(a, step);
    let coefficients = dense::power(&row.coefficients, exponent);
    Some(Row { low: row.low * exponent, coefficients }.into_terms(step))
}

/// The primitive gcd, with positive leading coefficient, of primitive polynomials in one variable.
pub(super) fn gcd(a: &MultiPoly, b: &MultiPoly) -> MultiPoly {
    let step = common_step(&[&a.terms, &b.terms]);
    budget::charge_terms(row_length(&a.terms, step).max(row_length(&b.terms, step)));
    let (x, y) = (Row::of(&a.terms, step), Row::of(&b.terms, step));
    let mut coefficients = super::univariate_gcd::primitive_gcd(&x.coefficients, &y.coefficients);
    if coefficients.last().is_some_and(Signed::is_negative) {
        coefficients = dense::negated(&coefficients);
    }
    let terms = Row { low: x.low.min(y.low), coefficients }.into_terms(step);
    MultiPoly::from_sorted(a.vars.clone(), terms, Int::ONE)
}

/// The terms of a / b over the integers: `Some(None)` if that is no polynomial with integer
/// coefficients, `None` if one is sparse.
pub(super) fn quotient(a: &[Term], b: &[Term]) -> Option<Option<Terms>> {
    let step = common_step(&[a, b]);
    let length = row_length(a, step);
    if !is_dense(b, step) || (length > SHORT_DIVIDEND && !is_dense(a, step)) {
        return None;
    }
    budget::charge_terms(length);
    let (a, b) = (Row::of(a, step), Row::of(b, step));
    let Some(low) = a.low.checked_sub(b.low) else { return Some(None) };
    let quotient = dense_divide::exact_quotient(&a.coefficients, &b.coefficients);
    Some(quotient.map(|coefficients| Row { low, coefficients }.into_terms(step)))
}

/// The value at a number, for a polynomial in one variable.
pub(super) fn value(p: &MultiPoly, x: &Rational) -> Rational {
    let (low, high) = ends(&p.terms);
    let (top, bottom) = (x.numer(), x.denom());
    let bits = top.bits().max(bottom.bits()).saturating_sub(1);
    budget::charge_bits(bits.saturating_mul(u64::from(high)));
    let numerator = if is_dense(&p.terms, 1) {
        let row = Row::of(&p.terms, 1).coefficients;
        dense_compose::homogeneous_value(&row, top, bottom) * top.pow(low)
    } else {
        let term = |(e, c): &Term| {
            budget::step();
            c * top.pow(e[0]) * bottom.pow(high - e[0])
        };
        p.terms.iter().map(term).sum()
    };
    Rational::new(numerator, &p.den * bottom.pow(high))
}

/// p ∘ inner for p in one variable and inner in one, perhaps another.
pub(super) fn composition(p: &MultiPoly, inner: &MultiPoly) -> MultiPoly {
    let step = common_step(&[&p.terms]);
    let low = ends(&p.terms).0;
    let constant = |c: &Int| MultiPoly::constant(Rational::new(c.clone(), p.den.clone()));
    if is_dense(&p.terms, step) {
        let row = Row::of(&p.terms, step).coefficients;
        let argument = inner.pow(step);
        if let Some(value) = dense_composition(&row, &p.den, &argument) {
            return if low == 0 { value } else { inner.pow(low).times(&value) };
        }
    }
    // Horner's rule, from one exponent that occurs to the next.
    let mut value = MultiPoly::zero();
    for (k, (e, c)) in p.terms.iter().enumerate() {
        let next = p.terms.get(k + 1).map_or(0, |(e, _)| e[0]);
        value = value.plus(&constant(c)).times(&inner.pow(e[0] - next));
    }
    value
}

/// (Σ a_k inner^k) / den; `None` if inner is sparse.
fn dense_composition(a: &[Int], den: &Int, inner: &MultiPoly) -> Option<MultiPoly> {
    let (low, high) = ends(&inner.terms);
    let degree = u32::try_from(a.len() - 1).ok()?;
    high.checked_mul(degree)?;
    let step = difference_gcd(&[&inner.terms]).gcd(&low);
    let length = u64::from(high / step) + 1;
    if length > SPARSEST * inner.terms.len() as u64 {
        return None;
    }
    budget::charge_terms(u64::from(degree).saturating_mul(length - 1).saturating_add(1));
    let (_, lead) = inner.terms.first()?;
    let bits = |x: &Int| x.bits().saturating_sub(1).saturating_mul(u64::from(degree));
    budget::charge_bits(bits(lead).max(bits(&inner.den)));
    let row = Row::from_low(&inner.terms, step, 0).coefficients;
    let coefficients = dense_compose::composed(a, &row, &inner.den);
    let terms = Row { low: 0, coefficients }.into_terms(step);
    Some(MultiPoly::from_sorted(inner.vars.clone(), terms, den * inner.den.pow(degree)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::poly::Symbol;
    use num_traits::One;
    use proptest::prelude::*;

    fn in_t(coefficients: &[(u32, i64)], den: i64) -> MultiPoly {
        let term = |&(e, c): &(u32, i64)| (vec![(Symbol::new("t"), e)], Rational::new(c.into(), den.into()));
        MultiPoly::from_terms(coefficients.iter().map(term))
    }

    /// Dense, evenly spaced and sparse lists of terms.
    fn any_poly() -> impl Strategy<Value = MultiPoly> {
        let spread = prop_oneof![4 => Just(1u32), 2 => Just(3u32), 1 => Just(11u32)];
        let exponents = prop::collection::vec((0u32..5, -5i64..6), 0..6);
        (spread, exponents, 0u32..3, 1i64..4).prop_map(|(step, list, low, den)| {
            let terms: Vec<(u32, i64)> = list.into_iter().map(|(e, c)| (low + step * e, c)).collect();
            in_t(&terms, den)
        })
    }

    /// Σ c_k x^k from the terms, with no kernel.
    fn by_terms(p: &MultiPoly, x: &Rational) -> Rational {
        let terms = p.terms(crate::math::poly::MonomialOrder::Lex);
        terms.into_iter().map(|(powers, c)| powers.iter().fold(c, |c, (_, e)| c * x.powered(*e))).sum()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(80))]
        #[test]
        fn operations_agree_with_values(a in any_poly(), b in any_poly(), p in -4i64..5, q in 1i64..4) {
            let x = Rational::new(p.into(), q.into());
            let t = Symbol::new("t");
            let at = |f: &MultiPoly| by_terms(f, &x);
            prop_assert!(a.times(&b).is_canonical());
            prop_assert_eq!(at(&a.times(&b)), at(&a) * at(&b));
            prop_assert_eq!(at(&a.pow(3)), at(&a).powered(3));
            prop_assert_eq!(a.value(&|_: &Symbol| Some(x.clone())).as_constant(), Some(at(&a)));
            let composed = a.substitute(&[(t, b.clone())]);
            prop_assert!(composed.is_canonical());
            prop_assert_eq!(at(&composed), by_terms(&a, &at(&b)));
            if !b.is_zero() {
                prop_assert_eq!(a.times(&b).div_exact(&b), Some(a.clone()));
            }
            let d = a.gcd(&b);
            prop_assert_eq!(d.is_zero(), a.is_zero() && b.is_zero());
            if !d.is_zero() {
                let (u, v) = (a.div_exact(&d).unwrap(), b.div_exact(&d).unwrap());
                prop_assert!(u.gcd(&v).is_one());
                prop_assert_eq!(d.primitive_part(), d);
            }
        }
    }

    #[test]
    fn few_terms_of_high_degree_stay_few() {
        let p = in_t(&[(3_000_000_000, 1), (0, 1)], 1);
        assert_eq!(p.pow(1).len(), 2);
        assert_eq!(p.times(&in_t(&[(1_000_000_000, 1), (7, 2)], 1)).len(), 4);
        assert_eq!(in_t(&[(2_000_000_000, 1), (0, -1)], 1).pow(2).len(), 3);
        let far = in_t(&[(2_000_000_000, 1), (1, -1)], 1);
        assert_eq!(far.pow(2).len(), 3);
        assert_eq!(in_t(&[(2, 1), (1, 1), (0, 1)], 1).substitute(&[(Symbol::new("t"), far)]).len(), 6);
    }

    #[test]
    fn a_difference_of_powers_is_divided() {
        let quotient = in_t(&[(600, 1), (0, -1)], 1).div_exact(&in_t(&[(2, 1), (0, -1)], 1)).unwrap();
        assert_eq!(quotient.len(), 300);
        assert_eq!(
            in_t(&[(600, 1), (0, -1)], 1).gcd(&in_t(&[(400, 1), (0, -1)], 1)),
            in_t(&[(200, 1), (0, -1)], 1)
        );
    }
}
