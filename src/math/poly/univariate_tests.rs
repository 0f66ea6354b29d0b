//! Laws of univariate polynomials, each result derived in a second way.

use crate::math::interval::Interval;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

use super::Poly;
use super::dense::tests::entry;
use crate::budget::{self, Limits, Stop};
use crate::math::number::{Int, Rational, integer, rational};
use crate::math::ring::Ring;

/// Checks the canonical form and passes the value on.
fn canonical(f: Poly) -> Poly {
    assert!(f.denominator().is_positive());
    assert!(f.numerators().last().is_none_or(|lead| !lead.is_zero()));
    let common = f.numerators().iter().fold(f.denominator().clone(), |g, a| g.gcd(a));
    assert!(common.is_one(), "{f:?} over {} shares {common}", f.denominator());
    f
}

/// Zero, constants, monomials, sparse and dense polynomials with entries of all sizes.
fn any_poly() -> impl Strategy<Value = Poly> {
    let denominator = prop_oneof![
        4 => (1i64..13).prop_map(Int::from),
        1 => (-12i64..0).prop_map(Int::from),
        1 => (1u32..300).prop_map(|e| Int::from(6).pow(e)),
    ];
    let general = (prop::collection::vec(entry(), 0..9), denominator)
        .prop_map(|(num, den)| Poly::from_integers(num, den));
    prop_oneof![6 => general, 4 => small_poly(8), 1 => (entry(), 0usize..20).prop_map(|(c, k)| {
        Poly::monomial(Rational::from_integer(c), k)
    })]
}

fn small_poly(len: usize) -> impl Strategy<Value = Poly> {
    prop::collection::vec((-9i64..10, 1i64..7), 0..len)
        .prop_map(|c| c.into_iter().map(|(p, q)| rational(p, q)).collect::<Poly>())
}

fn any_rational() -> impl Strategy<Value = Rational> {
    prop_oneof![
        4 => (-20i64..20, 1i64..9).prop_map(|(p, q)| rational(p, q)),
        1 => (entry(), 1u32..200).prop_map(|(p, e)| Rational::new(p, Int::from(10).pow(e))),
    ]
}

fn horner(f: &Poly, x: &Rational) -> Rational {
    f.coefficients().iter().rev().fold(Rational::zero(), |value, c| value * x + c)
}

fn roots(list: &[(i64, i64)]) -> Poly {
    list.iter().map(|&(p, q)| Poly::variable() - Poly::constant(rational(p, q))).product()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn ring_laws(f in any_poly(), g in any_poly(), h in any_poly()) {
        let zero = Poly::zero();
        prop_assert_eq!(canonical(&f + &g), &g + &f);
        prop_assert_eq!(canonical(&f * &g), &g * &f);
        prop_assert_eq!(canonical(&(&f + &g) + &h), &f + &(&g + &h));
        prop_assert_eq!(canonical(&(&f * &g) * &h), &f * &(&g * &h));
        prop_assert_eq!(canonical(&f * &(&g + &h)), &f * &g + &f * &h);
        prop_assert_eq!(canonical(&f - &g), &f + -&g);
        prop_assert_eq!(&f - &f, zero.clone());
        prop_assert_eq!(&f + &zero, f.clone());
        prop_assert_eq!(&f * &Poly::one(), f.clone());
        prop_assert_eq!(&f * &zero, zero);
        prop_assert_eq!(canonical(&f * &f), &f * &f.clone());
        let mut sum = f.clone();
        sum += &g;
        sum -= h.clone();
        sum *= &f;
        prop_assert_eq!(sum, (&f + &g - &h) * &f);
    }

    #[test]
    fn coefficients_give_the_polynomial_back(f in any_poly()) {
        prop_assert_eq!(canonical(Poly::from_coefficients(f.coefficients())), f.clone());
        let mut padded = f.coefficients();
        padded.push(integer(0));
        prop_assert_eq!(Poly::from_coefficients(padded), f.clone());
        let terms: Poly = (0..f.numerators().len()).map(|k| canonical(Poly::monomial(f.coefficient(k), k))).sum();
        prop_assert_eq!(terms, f.clone());
        prop_assert_eq!(canonical(f.primitive_part()).scale(&f.content()), f.clone());
        prop_assert!(f.primitive_part().denominator().is_one());
        prop_assert_eq!(canonical(f.leading_monic()).scale(&f.leading_coefficient()), f);
    }

    #[test]
    fn evaluation_is_a_homomorphism(f in any_poly(), g in any_poly(), x in any_rational()) {
        let value = f.value(&x);
        prop_assert_eq!(&Rational::new(value.numer().clone(), value.denom().clone()), &value, "in lowest terms");
        prop_assert_eq!(&value, &horner(&f, &x));
        prop_assert_eq!(&value, &f.value_in(&x));
        prop_assert_eq!((&f + &g).value(&x), &value + g.value(&x));
        prop_assert_eq!((&f * &g).value(&x), &value * g.value(&x));
        prop_assert_eq!(canonical(f.scale(&x)).value(&x), &value * &x);
    }

    #[test]
    fn composition_and_shift(f in small_poly(12), g in small_poly(6), x in any_rational()) {
        let composed = canonical(f.compose(&g));
        prop_assert_eq!(composed.value(&x), f.value(&g.value(&x)));
        prop_assert_eq!(&composed, &f.value_in(&g));
        let line = Poly::variable() + Poly::constant(x.clone());
        prop_assert_eq!(canonical(f.shift(&x)), f.compose(&line));
        prop_assert_eq!(f.shift(&x).shift(&-&x), f.clone());
        // Taylor's formula
        let mut factorial = integer(1);
        for k in 0..f.numerators().len() {
            factorial *= Int::from(k.max(1));
            prop_assert_eq!(f.shift(&x).coefficient(k), f.nth_derivative(k).value(&x) / &factorial);
        }
    }

    #[test]
    fn calculus(f in any_poly(), g in any_poly(), a in any_rational(), b in any_rational()) {
        prop_assert_eq!(canonical((&f * &g).derivative()), f.derivative() * &g + &f * g.derivative());
        prop_assert_eq!(canonical(f.nth_derivative(3)), f.derivative().derivative().derivative());
        prop_assert_eq!(f.nth_derivative(0), f.clone());
        prop_assert_eq!(canonical(f.antiderivative()).derivative(), f.clone());
        prop_assert!(f.antiderivative().coefficient(0).is_zero());
        if let Ok(interval) = Interval::new(a.clone(), b.clone()) {
            prop_assert_eq!(f.derivative().integral(&interval), f.value(&b) - f.value(&a));
        }
    }

    #[test]
    fn powers(f in small_poly(6), e in 0u32..7) {
        let expected = (0..e).fold(Poly::one(), |product, _| product * &f);
        prop_assert_eq!(canonical(f.pow(e)), expected.clone());
        prop_assert_eq!(Poly::monomial(rational(-2, 3), 4).pow(e), Poly::monomial(rational(-2, 3).powered(e), 4 * e as usize));
        prop_assert_eq!(f.powered(e), expected);
    }

    #[test]
    fn division(f in any_poly(), g in any_poly()) {
        match f.div_rem(&g) {
            None => prop_assert!(g.is_zero()),
            Some((q, r)) => {
                let (q, r) = (canonical(q), canonical(r));
                prop_assert!(r.is_zero() || r.degree() < g.degree());
                prop_assert_eq!(&q * &g + &r, f.clone());
                prop_assert_eq!(f.div_exact(&g), r.is_zero().then_some(q));
                prop_assert_eq!((&f * &g).div_exact(&g).map(canonical), Some(f));
            }
        }
    }

    #[test]
    fn gcds(f in any_poly(), g in any_poly(), h in any_poly()) {
        let (a, b) = (&f * &h, &g * &h);
        let d = canonical(a.gcd(&b));
        prop_assert_eq!(&d, &euclid(&a, &b));
        prop_assert_eq!(&d, &b.gcd(&a));
        if !d.is_zero() {
            prop_assert!(d.leading_coefficient().is_one());
            let cofactors = (a.div_exact(&d).unwrap(), b.div_exact(&d).unwrap());
            prop_assert_eq!(cofactors.0.gcd(&cofactors.1), Poly::one());
            prop_assert!(h.is_zero() || d.div_exact(&h).is_some());
        }
    }

    #[test]
    fn square_free_factorisation(f in small_poly(4), g in small_poly(4), lead in 1i64..9) {
        let product = f.pow(3) * g.pow(2).scale(&rational(-lead, 7));
        let factors = product.square_free_factors();
        if !product.is_zero() {
            let again: Poly = factors.iter().map(|(p, m)| p.pow(*m as u32)).product();
            prop_assert_eq!(again.scale(&product.leading_coefficient()), product.clone());
            let simple: Poly = factors.iter().map(|(p, _)| p.clone()).product();
            prop_assert_eq!(canonical(product.square_free_part()), simple);
        }
        for (k, (p, m)) in factors.iter().enumerate() {
            prop_assert_eq!(p.gcd(&p.derivative()), Poly::one());
            prop_assert!(factors[..k].iter().all(|(q, n)| n < m && q.gcd(p).is_one()));
        }
    }

    #[test]
    fn roots_of_a_known_factorisation(
        list in prop::collection::vec((-6i64..7, 1i64..4, 1u32..4), 0..5),
        ends in (-14i64..15, -14i64..15),
        sign in prop_oneof![Just(-1i64), Just(1)],
        complex in 0u32..3,
    ) {
        // Roots p/q with multiplicities, and factors t^2 + t + 1 without real roots.
        let t = Poly::variable();
        let mut f = (t.pow(2) + &t + Poly::one()).pow(complex).scale(&integer(sign));
        let mut multiplicity = std::collections::BTreeMap::new();
        for &(p, q, m) in &list {
            f *= roots(&[(p, q)]).pow(m);
            *multiplicity.entry(rational(p, q)).or_insert(0) += m;
        }
        let (a, b) = (rational(ends.0, 2), rational(ends.1, 2));
        let inside = multiplicity.keys().filter(|&r| &a < r && r <= &b).count();
        if let Ok(interval) = Interval::new(a.clone(), b.clone()) {
            prop_assert_eq!(f.count_roots(&interval), Some(inside));
        }
        prop_assert_eq!(f.count_real_roots(), Some(multiplicity.len()));
        // Nonnegative iff nonnegative at the ends and between neighbouring roots.
        let mut cuts: Vec<Rational> = multiplicity.keys().filter(|&r| &a < r && r < &b).cloned().collect();
        cuts.insert(0, a.clone());
        cuts.push(b.clone());
        let middles: Vec<Rational> = cuts.windows(2).map(|w| (&w[0] + &w[1]) / integer(2)).collect();
        let nonnegative = a > b || cuts.iter().chain(&middles).all(|x| !f.value(x).is_negative());
        prop_assert_eq!(f.negative_point(Some(&a), Some(&b)).is_none(), nonnegative);
    }
}

/// Euclid's algorithm over Q.
fn euclid(a: &Poly, b: &Poly) -> Poly {
    let (mut a, mut b) = (a.leading_monic(), b.leading_monic());
    while let Some((_, r)) = a.div_rem(&b) {
        a = std::mem::replace(&mut b, r.leading_monic());
    }
    a
}

#[test]
fn zero_in_every_role() {
    let (zero, one, x) = (Poly::zero(), Poly::one(), rational(7, 3));
    assert_eq!(zero.degree(), None);
    assert!(zero.leading_coefficient().is_zero() && zero.content().is_zero());
    assert!(zero.value(&x).is_zero() && zero.integral(&Interval::unit()).is_zero());
    for f in [
        zero.derivative(),
        zero.antiderivative(),
        zero.compose(&one),
        zero.shift(&x),
        zero.primitive_part(),
        zero.leading_monic(),
        zero.square_free_part(),
        zero.gcd(&zero),
        zero.pow(2),
        Poly::constant(rational(0, 5)),
        Poly::monomial(rational(0, 5), 9),
        Poly::from_integers(vec![Int::ZERO; 3], Int::from(-5)),
    ] {
        assert_eq!(canonical(f), zero);
    }
    assert_eq!(zero.pow(0), one);
    assert_eq!(Poly::variable().compose(&zero), zero);
    assert_eq!((Poly::variable() + &one).compose(&zero), one);
    assert_eq!(zero.gcd(&Poly::from(4)), one);
    assert!(zero.square_free_factors().is_empty() && one.square_free_factors().is_empty());
    assert_eq!(zero.count_roots(&Interval::unit()), None);
    assert_eq!(zero.count_real_roots(), None);
    assert!(zero.negative_point(Some(&integer(0)), Some(&integer(1))).is_none());
    assert_eq!(zero.as_rational(), Some(integer(0)));
    assert_eq!(Poly::constant(x.clone()).as_rational(), Some(x));
    assert_eq!(Poly::variable().as_rational(), None);
}

#[test]
fn text() {
    let f = |c: &[(i64, i64)]| c.iter().map(|&(p, q)| rational(p, q)).collect::<Poly>().to_string();
    assert_eq!(f(&[(5, 3), (0, 1), (3, 1), (1, 1)]), "t^3 + 3 t^2 + 5/3");
    assert_eq!(f(&[(1, 1), (-1, 2), (0, 1), (-1, 1)]), "-t^3 - 1/2 t + 1");
    assert_eq!(f(&[]), "0");
    assert_eq!(f(&[(-1, 1)]), "-1");
    assert_eq!(f(&[(0, 1), (1, 1)]), "t");
}

/// Products long enough for transforms: values and a degree-1000 composition with a line.
#[test]
fn long_polynomials() {
    let f: Poly = (0..400i64).map(|k| rational(k * k - 7000, 1 + k % 12)).collect();
    let g: Poly = (0..300i64).map(|k| rational(5 - k, 1 + k % 7)).collect();
    let product = canonical(&f * &g);
    for x in [rational(1, 2), rational(-3, 1), rational(1, 1)] {
        assert_eq!(product.value(&x), horner(&f, &x) * horner(&g, &x));
    }
    let shifted = canonical(f.shift(&rational(2, 3)));
    assert_eq!(shifted.value(&integer(1)), f.value(&rational(5, 3)));
    assert_eq!(shifted.shift(&rational(-2, 3)), f);
    assert_eq!(product.gcd(&(&f * &(&g + Poly::one()))), f.leading_monic());
}

/// Wilkinson's polynomial: 20 real roots, hopeless in floating point.
#[test]
fn wilkinson() {
    let list: Vec<(i64, i64)> = (1..=20).map(|k| (k, 1)).collect();
    let f = roots(&list);
    assert_eq!(f.count_real_roots(), Some(20));
    assert_eq!(f.count_roots(&Interval::new(integer(3), rational(21, 2)).unwrap()), Some(7));
    // Changing the coefficient of t^19 by 2^-23 makes ten roots complex.
    let nudged = &f - Poly::monomial(rational(1, 1 << 23), 19);
    assert_eq!(nudged.count_real_roots(), Some(10));
}

#[test]
fn absurd_sizes_stop_before_they_are_built() {
    let limits = Limits { terms: 1000, bits: 10_000, ..Limits::default() };
    let t = Poly::variable();
    let stopped = |work: &dyn Fn() -> Poly| budget::run(&limits, work).expect_err("too large");
    assert_eq!(
        stopped(&|| (&t + Poly::one()).pow(1_000_000_000)),
        Stop::Terms { needed: 1_000_000_001, allowed: 1000 }
    );
    assert!(matches!(stopped(&|| Poly::from(3).pow(1_000_000)), Stop::Bits { .. }));
    assert!(matches!(stopped(&|| Poly::monomial(integer(1), usize::MAX)), Stop::Terms { .. }));
    let big = (&t + Poly::one()).pow(100);
    assert!(matches!(stopped(&|| big.compose(&big)), Stop::Terms { .. }));
    let value = budget::run(&limits, || big.value(&rational(1 << 60, (1 << 61) - 1).powered(4)));
    assert!(matches!(value, Err(Stop::Bits { .. })));
}
