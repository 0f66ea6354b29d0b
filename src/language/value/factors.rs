//! Simple factors for printing: symbols, differences of two symbols, and repeated factors.
//!
//! Denominators met with symbolic knots and interval ends are products of such factors, and
//! a person writes them that way: (t − t_1)/(t_2 − t_1), not a multiplied-out quotient.

use num_traits::{One, Signed, Zero};

use crate::math::number::Rational;
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};
use crate::math::ring::Ring;

/// A constant times powers of simple factors times a rest.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Factors {
    pub constant: Rational,
    pub powers: Vec<(MultiPoly, u32)>,
}

/// Polynomials with more terms are not searched for factors.
const MOST_TERMS: usize = 200;

/// Takes a polynomial apart; the product of all parts is the polynomial.
pub(super) fn factors(p: &MultiPoly) -> Factors {
    let mut rest = p.primitive_part();
    let lead =
        |q: &MultiPoly| q.terms(MonomialOrder::Lex).first().map_or_else(Rational::zero, |t| t.1.clone());
    let mut result = Factors { constant: Rational::one(), powers: Vec::new() };
    if p.is_zero() {
        result.constant = Rational::zero();
        return result;
    }
    result.constant = lead(p) / lead(&rest);
    if p.len() > MOST_TERMS {
        result.powers.push((rest, 1));
        return result;
    }
    let variables: Vec<Symbol> = rest.variables().to_vec();
    let symbol = |s: &Symbol| MultiPoly::symbol(s.clone());
    for s in &variables {
        take(&mut rest, symbol(s), &mut result.powers);
    }
    for (i, a) in variables.iter().enumerate() {
        for b in &variables[i + 1..] {
            // Written with the later symbol first: t_2 − t_1. The sign goes to the constant.
            let difference = symbol(b).minus(&symbol(a));
            let before = result.powers.len();
            take(&mut rest, difference, &mut result.powers);
            if result.powers.len() > before && lead(&rest).is_negative() {
                rest = -rest;
                result.constant = -result.constant;
            }
        }
    }
    if let Some(c) = rest.as_constant() {
        result.constant *= c;
        return result;
    }
    for (factor, power) in repeated(&rest) {
        result.powers.push((factor, power));
    }
    result
}

/// Divides by the factor as often as possible and notes how often.
fn take(rest: &mut MultiPoly, factor: MultiPoly, powers: &mut Vec<(MultiPoly, u32)>) {
    let mut count = 0;
    while let Some(quotient) = rest.div_exact(&factor) {
        *rest = quotient;
        count += 1;
    }
    if count > 0 {
        powers.push((factor, count));
    }
}

/// p as a power of one polynomial if it is one, else p itself.
fn repeated(p: &MultiPoly) -> Vec<(MultiPoly, u32)> {
    let Some(variable) = p.variables().first() else { return vec![(p.clone(), 1)] };
    let g = p.gcd(&p.derivative(variable));
    let Some(root) = p.div_exact(&g).map(|root| root.primitive_part()) else { return vec![(p.clone(), 1)] };
    let (mut rest, mut count) = (p.clone(), 0);
    while let Some(quotient) = rest.div_exact(&root) {
        rest = quotient;
        count += 1;
    }
    if rest.is_one() && count > 1 { vec![(root, count)] } else { vec![(p.clone(), 1)] }
}

/// Numerator and denominator taken apart, odd powers of differences turned so that the
/// quotient needs as few minus signs as possible.
pub(super) fn quotient(f: &Fraction) -> (Factors, Factors) {
    let (mut top, mut bottom) = (factors(f.numerator()), factors(f.denominator()));
    top.constant = &top.constant / &bottom.constant;
    bottom.constant = Rational::one();
    if top.constant.is_negative()
        && let Some((factor, _)) =
            top.powers.iter_mut().find(|(factor, power)| power % 2 == 1 && factor.len() == 2)
    {
        *factor = -factor.clone();
        top.constant = -top.constant;
    }
    (top, bottom)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn s(name: &str) -> MultiPoly {
        MultiPoly::symbol(Symbol::new(name))
    }

    fn product(f: &Factors) -> MultiPoly {
        let powers = f.powers.iter().map(|(p, k)| p.powered(*k));
        powers.fold(MultiPoly::constant(f.constant.clone()), |product, p| product.times(&p))
    }

    #[test]
    fn parts_multiply_to_the_whole() {
        let (r, t, x) = (s("r"), s("t"), s("x"));
        let gap = t.minus(&r);
        let other = x.plus(&t).plus(&MultiPoly::one());
        for p in [
            gap.powered(3).times(&x.powered(2)).scaled(&crate::math::number::rational(-2, 3)),
            other.powered(2),
            other.times(&gap),
            MultiPoly::one(),
            MultiPoly::zero(),
            x.minus(&r).times(&t.minus(&x)).times(&gap),
        ] {
            assert_eq!(product(&factors(&p)), p);
        }
        assert_eq!(factors(&other.powered(2)).powers, [(other, 2)]);
        assert_eq!(factors(&gap.powered(2)).powers, [(gap, 2)]);
    }
}
