//! Exact division and greatest common divisors in several variables.
//!
//! The gcd is primitive with positive leading coefficient (lexicographic order). Trivial
//! cases come first, and one variable has an algorithm of its own. Then each common variable gets a bound for its degree in the gcd: the
//! degree of the gcd of the images modulo a prime, all other variables replaced by numbers.
//! A bound of 0 for all variables proves that the gcd is 1, the common case. Otherwise the
//! primitive remainder sequence in one variable, with coefficients treated recursively,
//! finds it.
//!
//! Reference: W. S. Brown, *On Euclid's algorithm and the computation of polynomial greatest
//! common divisors*, J. ACM 18 (1971) 478–504; Knuth, TAOCP vol. 2, 4.6.1.

use super::multivariate::{Exponents, MultiPoly, Terms, aligned};
use super::one_variable;
use super::symbol::Symbol;
use crate::budget;
use crate::math::number::{Int, Rational};
use crate::math::ring::Ring;
use num_integer::Integer;
use num_traits::{One, Zero};
use std::collections::BTreeMap;

/// The prime 2^61 − 1, for images.
const PRIME: u64 = (1 << 61) - 1;

impl MultiPoly {
    /// self / divisor if the division leaves no remainder.
    ///
    /// Cost: terms of the quotient times terms of the divisor.
    ///
    /// ```
    /// use polarform::poly::{MultiPoly, Symbol};
    /// let (x, y) = (MultiPoly::symbol(Symbol::new("x")), MultiPoly::symbol(Symbol::new("y")));
    /// let product = (x.clone() + y.clone()) * (x.clone() - y.clone());
    /// assert_eq!(product.div_exact(&(x.clone() + y.clone())), Some(x.clone() - y.clone()));
    /// assert_eq!(x.div_exact(&y), None);
    /// ```
    pub fn div_exact(&self, divisor: &MultiPoly) -> Option<MultiPoly> {
        if divisor.is_zero() {
            return None;
        }
        if self.is_zero() {
            return Some(MultiPoly::zero());
        }
        if let Some(c) = divisor.as_constant() {
            return Some(self.scaled(&c.recip()));
        }
        if divisor.variables().iter().any(|s| self.degree_in(s) < divisor.degree_in(s)) {
            return None;
        }
        // Over Z with primitive operands the quotient is integral (Gauss).
        let (a, b) = (self.primitive_part(), divisor.primitive_part());
        let (vars, dividend, by) = aligned(&a, &b);
        let scale = self.leading_coefficient()
            / a.leading_coefficient()
            / (divisor.leading_coefficient() / b.leading_coefficient());
        if let [_] = *vars
            && let Some(quotient) = one_variable::quotient(&dividend, &by)
        {
            return Some(MultiPoly::from_sorted(vars, quotient?, Int::ONE).scaled(&scale));
        }
        let (lead, lead_c) = by.first()?;
        let mut rest: BTreeMap<Exponents, Int> = dividend.iter().cloned().collect();
        let mut quotient: Terms = Vec::new();
        while let Some((e, c)) = rest.pop_last() {
            if c.is_zero() {
                continue;
            }
            budget::steps(by.len() as u32 / 16 + 1);
            let shift: Option<Exponents> = e.iter().zip(lead).map(|(x, y)| x.checked_sub(*y)).collect();
            let (shift, (q, r)) = (shift?, c.div_rem(lead_c));
            if !r.is_zero() {
                return None;
            }
            for (exponents, d) in &by[1..] {
                let place: Exponents = exponents.iter().zip(&shift).map(|(x, y)| x + y).collect();
                *rest.entry(place).or_default() -= d * &q;
            }
            quotient.push((shift, q));
        }
        let quotient = MultiPoly::from_sorted(vars, quotient, Int::ONE);
        Some(quotient.scaled(&scale))
    }

    /// The greatest common divisor: primitive with positive leading coefficient; for 0 and p it
    /// is the primitive part of p, and gcd(0, 0) = 0.
    ///
    /// ```
    /// use polarform::poly::{MultiPoly, Symbol};
    /// let (x, y) = (MultiPoly::symbol(Symbol::new("x")), MultiPoly::symbol(Symbol::new("y")));
    /// let (a, b) = (x.clone() * x.clone() - y.clone() * y.clone(), x.clone() * y.clone() + y.clone() * y.clone());
    /// assert_eq!(a.gcd(&b), x + y);
    /// ```
    pub fn gcd(&self, other: &MultiPoly) -> MultiPoly {
        if self.is_zero() {
            return other.primitive_part();
        }
        if other.is_zero() || self == other {
            return self.primitive_part();
        }
        if self.as_constant().is_some() || other.as_constant().is_some() {
            return MultiPoly::one();
        }
        let (a, b) = (self.primitive_part(), other.primitive_part());
        // Its cost grows with both; limits by steps rest on this count.
        crate::budget::steps(u32::try_from(a.len().saturating_mul(b.len())).unwrap_or(u32::MAX).max(16));
        if a.len() == 1 || b.len() == 1 {
            return monomial_gcd(&a, &b);
        }
        if one_variable::has_one_variable(&a) && a.variables() == b.variables() {
            return one_variable::gcd(&a, &b);
        }
        let common: Vec<Symbol> = a.variables().iter().filter(|s| b.degree_in(s) > 0).cloned().collect();
        if common.is_empty() {
            return MultiPoly::one();
        }
        let bounds: Vec<u32> = common.iter().map(|symbol| degree_bound(&a, &b, symbol)).collect();
        if bounds.iter().all(|&bound| bound == 0) {
            return MultiPoly::one();
        }
        let (small, large) = if a.len() <= b.len() { (&a, &b) } else { (&b, &a) };
        if large.div_exact(small).is_some() {
            return small.clone();
        }
        // A variable that the gcd does not contain leaves it a divisor of all coefficients.
        let absent = a
            .variables()
            .iter()
            .chain(b.variables())
            .find(|symbol| common.iter().position(|s| s == *symbol).is_none_or(|k| bounds[k] == 0));
        if let Some(symbol) = absent {
            return coefficient_gcd(&[&a, &b], symbol);
        }
        let main = common
            .iter()
            .min_by_key(|symbol| a.degree_in(symbol).max(b.degree_in(symbol)))
            .unwrap_or(&common[0]);
        euclid(&a, &b, main)
    }

    /// The least common multiple, primitive with positive leading coefficient.
    pub fn lcm(&self, other: &MultiPoly) -> MultiPoly {
        let g = self.gcd(other);
        match self.div_exact(&g) {
            Some(cofactor) => cofactor.times(other).primitive_part(),
            None => MultiPoly::zero(),
        }
    }
}

/// gcd when one of the two is a monomial with coefficient 1.
fn monomial_gcd(a: &MultiPoly, b: &MultiPoly) -> MultiPoly {
    let powers = a.variables().iter().filter_map(|symbol| {
        let lowest =
            |p: &MultiPoly| p.coefficients_in(symbol).iter().position(|c| !c.is_zero()).unwrap_or(0) as u32;
        let e = lowest(a).min(if b.degree_in(symbol) > 0 { lowest(b) } else { 0 });
        (e > 0).then(|| (symbol.clone(), e))
    });
    MultiPoly::from_terms([(powers.collect(), Rational::one())])
}

/// The gcd of all coefficients of the given polynomials in `symbol`.
fn coefficient_gcd(polys: &[&MultiPoly], symbol: &Symbol) -> MultiPoly {
    let mut list: Vec<MultiPoly> = polys.iter().flat_map(|p| p.coefficients_in(symbol)).collect();
    list.retain(|c| !c.is_zero());
    list.sort_by_key(MultiPoly::len);
    let mut g = MultiPoly::zero();
    for c in &list {
        g = g.gcd(c);
        if g.is_one() {
            break;
        }
    }
    g
}

/// Primitive remainder sequence in the main variable.
fn euclid(a: &MultiPoly, b: &MultiPoly, main: &Symbol) -> MultiPoly {
    let (content_a, content_b) = (coefficient_gcd(&[a], main), coefficient_gcd(&[b], main));
    let content = content_a.gcd(&content_b);
    let strip = |p: &MultiPoly, c: &MultiPoly| p.div_exact(c).unwrap_or_else(|| p.clone());
    let (mut p, mut q) = (strip(a, &content_a), strip(b, &content_b));
    if p.degree_in(main) < q.degree_in(main) {
        std::mem::swap(&mut p, &mut q);
    }
    while !q.is_zero() {
        budget::step();
        if q.degree_in(main) == 0 {
            return content.primitive_part();
        }
        let remainder = pseudo_remainder(&p, &q, main);
        p = q;
        q = if remainder.is_zero() {
            remainder
        } else {
            let c = coefficient_gcd(&[&remainder], main);
            strip(&remainder, &c).primitive_part()
        };
    }
    p.times(&content).primitive_part()
}

/// The remainder of lc(q)^k p by q in the main variable.
fn pseudo_remainder(p: &MultiPoly, q: &MultiPoly, main: &Symbol) -> MultiPoly {
    let mut rest = p.coefficients_in(main);
    let by = q.coefficients_in(main);
    let lead = &by[by.len() - 1];
    while rest.len() >= by.len() {
        budget::step();
        let Some(top) = rest.pop() else { break };
        let shift = rest.len() + 1 - by.len();
        if top.is_zero() {
            continue;
        }
        for (k, c) in rest.iter_mut().enumerate() {
            let scaled = c.times(lead);
            *c = match k.checked_sub(shift) {
                Some(j) => scaled.minus(&top.times(&by[j])),
                None => scaled,
            };
        }
    }
    MultiPoly::from_coefficients_in(main, &rest)
}

/// An upper bound for the degree of gcd(a, b) in `symbol`, from an image modulo a prime.
///
/// If the leading coefficient of one of them in `symbol` does not vanish in the image, the
/// image of the gcd has the same degree as the gcd and divides the gcd of the images.
fn degree_bound(a: &MultiPoly, b: &MultiPoly, symbol: &Symbol) -> u32 {
    let fallback = a.degree_in(symbol).min(b.degree_in(symbol));
    for attempt in 0..3u64 {
        let (Some(x), Some(y)) = (image(a, symbol, attempt), image(b, symbol, attempt)) else {
            return fallback;
        };
        let full = |list: &[u64], p: &MultiPoly| list.len() == p.degree_in(symbol) as usize + 1;
        if full(&x, a) || full(&y, b) {
            return (gcd_mod(x, y).len().saturating_sub(1) as u32).min(fallback);
        }
    }
    fallback
}

/// The coefficients of p in `symbol` modulo the prime, the other variables at fixed pseudo-random
/// values; without leading zeros. `None` if the denominator vanishes.
fn image(p: &MultiPoly, symbol: &Symbol, attempt: u64) -> Option<Vec<u64>> {
    if p.den.mod_word(PRIME) == 0 {
        return None;
    }
    let main = p.vars.iter().position(|s| s == symbol)?;
    let values: Vec<u64> = p.vars.iter().map(|s| value_of(s, attempt)).collect();
    let mut list = vec![0u64; p.degree_in(symbol) as usize + 1];
    for (e, c) in &p.terms {
        let mut term = c.mod_word(PRIME);
        for (k, &x) in e.iter().enumerate().filter(|(k, x)| *k != main && **x > 0) {
            term = mul_mod(term, pow_mod(values[k], u64::from(x)));
        }
        let cell = &mut list[e[main] as usize];
        *cell = (*cell + term) % PRIME;
    }
    while list.last() == Some(&0) {
        list.pop();
    }
    Some(list)
}

/// A fixed value for a symbol, spread over the prime field by its name.
fn value_of(symbol: &Symbol, attempt: u64) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325u64 ^ attempt.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    for byte in symbol.to_string().bytes() {
        hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    }
    hash ^= hash >> 29;
    hash % (PRIME - 2) + 2
}

fn mul_mod(a: u64, b: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(PRIME)) as u64
}

fn pow_mod(mut base: u64, mut exponent: u64) -> u64 {
    let mut result = 1;
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = mul_mod(result, base);
        }
        base = mul_mod(base, base);
        exponent >>= 1;
    }
    result
}

/// gcd of coefficient lists modulo the prime, without leading zeros.
fn gcd_mod(mut a: Vec<u64>, mut b: Vec<u64>) -> Vec<u64> {
    while let Some(&lead) = b.last() {
        let inverse = pow_mod(lead, PRIME - 2);
        while a.len() >= b.len() {
            let Some(top) = a.pop() else { break };
            let factor = mul_mod(top, inverse);
            let shift = a.len() + 1 - b.len();
            for (j, &c) in b[..b.len() - 1].iter().enumerate() {
                let product = mul_mod(factor, c);
                let cell = &mut a[shift + j];
                *cell = (*cell + PRIME - product) % PRIME;
            }
        }
        while a.last() == Some(&0) {
            a.pop();
        }
        std::mem::swap(&mut a, &mut b);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::rational;
    use proptest::prelude::*;

    fn any_poly() -> impl Strategy<Value = MultiPoly> {
        let term = (prop::collection::vec(0u32..3, 3), -5i64..6, 1i64..4);
        prop::collection::vec(term, 0..4).prop_map(|terms| {
            MultiPoly::from_terms(terms.into_iter().map(|(e, p, q)| {
                let names = ["x", "y", "t"].map(Symbol::new);
                (names.into_iter().zip(e).collect(), rational(p, q))
            }))
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(150))]
        #[test]
        fn products_have_the_factor(a in any_poly(), b in any_poly(), g in any_poly()) {
            let (x, y) = (a.times(&g), b.times(&g));
            let d = x.gcd(&y);
            assert!(d.is_canonical());
            if g.is_zero() || (a.is_zero() && b.is_zero()) {
                assert!(d.is_zero());
                return Ok(());
            }
            assert!(d.div_exact(&g.primitive_part()).is_some(), "gcd({x}, {y}) = {d} misses {g}");
            let (u, v) = (x.div_exact(&d).unwrap(), y.div_exact(&d).unwrap());
            assert_eq!(u.times(&d), x);
            assert!(u.gcd(&v).is_one() || x.is_zero() || y.is_zero());
            assert_eq!(d, y.gcd(&x));
        }

        #[test]
        fn exact_division(a in any_poly(), b in any_poly()) {
            if b.is_zero() {
                assert_eq!(a.div_exact(&b), None);
                return Ok(());
            }
            assert_eq!(a.times(&b).div_exact(&b), Some(a.clone()));
            if let Some(q) = a.div_exact(&b) {
                assert_eq!(q.times(&b), a);
            }
        }
    }

    #[test]
    fn degenerate() {
        let x = MultiPoly::symbol(Symbol::new("x"));
        let zero = MultiPoly::zero();
        assert!(zero.gcd(&zero).is_zero());
        assert_eq!(zero.gcd(&x.scaled(&rational(-2, 3))), x);
        assert!(x.gcd(&MultiPoly::one()).is_one());
        let big = x.powered(50);
        assert_eq!(big.gcd(&x.powered(30)), x.powered(30));
    }
}
