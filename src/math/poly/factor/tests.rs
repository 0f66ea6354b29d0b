//! Factors multiply to the whole, none splits further, and they agree with other ways to them.

use num_traits::{One, Zero};
use proptest::prelude::*;

use super::Factorization;
use crate::math::number::{Int, Rational, integer};
use crate::math::poly::{MultiPoly, Poly, Symbol};
use crate::math::ring::Ring;

fn whole<P: Ring>(f: &Factorization<P>) -> P {
    let powers = f.factors.iter().map(|(p, m)| p.powered(*m as u32));
    powers.fold(P::from_rational(&f.constant), |product, p| product.times(&p))
}

fn poly(coefficients: &[i64]) -> Poly {
    coefficients.iter().map(|&c| integer(c)).collect()
}

fn count(f: &Poly) -> usize {
    f.factors().factors.iter().map(|(_, m)| m).sum()
}

/// Whether a divisor of degree d over the integers exists: Kronecker's way, by values at d + 1 points.
fn has_divisor(f: &Poly, degree: usize) -> bool {
    let f = f.primitive_part();
    let value = |x: i64| f.value(&integer(x)).numer().clone();
    let points: Vec<i64> =
        (0..).map(|k| if k % 2 == 0 { k / 2 } else { -(k + 1) / 2 }).take(degree + 1).collect();
    if points.iter().any(|&x| value(x).is_zero()) {
        return true;
    }
    let divisors = |n: Int| {
        let n = n.as_small().unwrap().abs();
        (1..=n).filter(|d| n % d == 0).flat_map(|d| [d, -d]).collect::<Vec<i64>>()
    };
    let choices: Vec<Vec<i64>> = points.iter().map(|&x| divisors(value(x))).collect();
    let mut picked = vec![0; points.len()];
    loop {
        let mut candidate = Poly::zero();
        for (i, &x) in points.iter().enumerate() {
            let mut part = Poly::constant(integer(choices[i][picked[i]]));
            for &y in points.iter().filter(|&&y| y != x) {
                part *= Poly::variable() - Poly::constant(integer(y));
                part = part.scale(&integer(x - y).recip());
            }
            candidate += part;
        }
        if candidate.degree() > Some(0) && f.div_exact(&candidate).is_some() {
            return true;
        }
        let Some(i) = (0..picked.len()).find(|&i| picked[i] + 1 < choices[i].len()) else { return false };
        picked[i] += 1;
        picked[..i].fill(0);
    }
}

fn small(len: usize) -> impl Strategy<Value = Poly> {
    prop::collection::vec(-6i64..7, 0..len).prop_map(|c| poly(&c))
}

/// Polynomials in x, y, z of small degree.
fn several(terms: usize) -> impl Strategy<Value = MultiPoly> {
    let term = (-4i64..5, 0u32..3, 0u32..3, 0u32..2).prop_map(|(c, i, j, k)| {
        let symbol = |name: &str| Symbol::new(name);
        (vec![(symbol("x"), i), (symbol("y"), j), (symbol("z"), k)], integer(c))
    });
    prop::collection::vec(term, 1..terms).prop_map(MultiPoly::from_terms)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn factors_multiply_to_the_whole(f in small(6), g in small(5), h in small(4), m in 1u32..4) {
        let product = f * g * h.pow(m);
        let found = product.factors();
        prop_assert_eq!(whole(&found), product);
        for (p, _) in &found.factors {
            prop_assert_eq!(count(p), 1);
            prop_assert!(p.primitive_part() == *p && p.leading_coefficient() > Rational::zero());
        }
    }

    #[test]
    fn factors_are_irreducible(f in prop::collection::vec(-3i64..4, 3..6)) {
        for (p, _) in poly(&f).factors().factors {
            for degree in 1..=p.degree().unwrap_or(0) / 2 {
                prop_assert!(!has_divisor(&p, degree), "{p}");
            }
        }
    }

    #[test]
    fn factors_in_several_variables(f in several(4), g in several(4), h in several(3)) {
        let product = f.times(&g).times(&h);
        let found = product.factors();
        prop_assert_eq!(whole(&found), product);
        let parts: usize = [&f, &g, &h].map(|p| p.factors().factors.iter().map(|(_, m)| m).sum()).iter().sum();
        let all: usize = found.factors.iter().map(|(_, m)| m).sum();
        if !(f.is_zero() || g.is_zero() || h.is_zero()) {
            prop_assert_eq!(all, parts);
        }
        // What is irreducible stays so at almost all values; where it splits, the whole has more factors.
        let x = Symbol::new("x");
        let at = |y: &Symbol| (*y != x).then(|| integer(17));
        for (p, _) in &found.factors {
            prop_assert_eq!(p.factors().factors.len(), 1);
            if p.value(&at).factors().factors.len() == 1 && p.degree_in(&x) > 0 {
                prop_assert_eq!(p.factors().factors.len(), 1);
            }
        }
    }
}

#[test]
fn degenerate() {
    let zero = Poly::zero().factors();
    assert!(zero.constant.is_zero() && zero.factors.is_empty());
    let number = poly(&[-6]).factors();
    assert!(number.constant == integer(-6) && number.factors.is_empty());
    assert_eq!(
        poly(&[0, 0, 0, -2]).factors(),
        Factorization { constant: integer(-2), factors: vec![(poly(&[0, 1]), 3)] }
    );
    assert!(MultiPoly::zero().factors().factors.is_empty());
    assert!(MultiPoly::one().factors().constant.is_one());
}

#[test]
fn known_numbers_of_factors() {
    // x^n - 1 has a factor for each divisor of n; the polynomial of Swinnerton-Dyer has none of its own,
    // but factors of degree at most 2 modulo every prime.
    for n in [1, 2, 6, 12, 30, 36] {
        let f = Poly::variable().pow(n) - Poly::one();
        assert_eq!(count(&f), (1..=n).filter(|d| n % d == 0).count(), "x^{n} - 1");
    }
    assert_eq!(count(&poly(&[1, 0, -10, 0, 1])), 1);
    assert_eq!(count(&poly(&[576, 0, -960, 0, 352, 0, -40, 0, 1])), 1);
    // Large coefficients: the lifting takes many steps.
    let big = |k: u32| Poly::constant(Rational::from_integer(Int::from(10).pow(k)));
    let f =
        (Poly::variable().pow(3) * big(40) + poly(&[7])) * (Poly::variable().pow(2) + big(55) + Poly::one());
    assert_eq!(count(&f), 2);
}

#[test]
fn several_variables_by_hand() {
    let [a, b, t] = ["a", "b", "t"].map(|name| MultiPoly::symbol(Symbol::new(name)));
    let shown =
        |p: &MultiPoly| p.factors().factors.iter().map(|(p, m)| format!("({p})^{m}")).collect::<Vec<_>>();
    assert_eq!(shown(&t.minus(&a).times(&t.minus(&b)).times(&t.minus(&b))), ["(a - t)^1", "(b - t)^2"]);
    assert_eq!(shown(&a.powered(2).minus(&b.powered(2))), ["(a - b)^1", "(a + b)^1"]);
    // Leading coefficients that are no numbers, a repeated factor among others.
    let p = a.times(&t).plus(&b).times(&b.times(&t).minus(&a)).times(&a.plus(&b).powered(2));
    assert_eq!(shown(&p).len(), 3);
    assert_eq!(shown(&a.powered(2).plus(&b.powered(2))), ["(a^2 + b^2)^1"]);
}
