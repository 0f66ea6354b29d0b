//! Roots found in two ways, and known beforehand.

use crate::math::interval::Interval;
use std::cmp::Ordering;

use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

use super::bernstein;
use super::{AlgebraicNumber, Positivity, RealRoot};
use crate::math::number::{Int, Rational, binomial, integer, rational};
use crate::math::poly::Poly;

fn linear(q: &Rational) -> Poly {
    Poly::variable() - Poly::constant(q.clone())
}

/// t² − c
fn square(c: i64) -> Poly {
    Poly::variable().pow(2) - Poly::from(c)
}

fn irrational(f: &Poly, number: usize) -> AlgebraicNumber {
    match f.real_roots(None, None).unwrap().remove(number).0 {
        RealRoot::Irrational(root) => root,
        RealRoot::Rational(q) => panic!("{q} is rational"),
    }
}

/// Whether a certificate proves that F ≥ 0 on [a, b], checked from its numbers alone.
fn proves(shown: &Positivity, f: &Poly, a: Option<&Rational>, b: Option<&Rational>) -> bool {
    let none_negative = |list: &[Rational]| list.iter().all(|c| !c.is_negative());
    if *f != &shown.root_of_square * &shown.root_of_square * &shown.rest {
        return false;
    }
    if f.is_zero() || a.zip(b).is_some_and(|(a, b)| a > b) {
        return true;
    }
    let start = shown.below.as_ref().map(|(c, _)| c).or(a).unwrap();
    let end = shown.above.as_ref().map(|(c, _)| c).or(b).unwrap();
    let tails =
        shown.below.iter().all(|(c, p)| {
            *p == shown.rest.compose(&(Poly::constant(c.clone()) - Poly::variable()))
                && none_negative(&p.coefficients())
        }) && shown.above.iter().all(|(c, p)| *p == shown.rest.shift(c) && none_negative(&p.coefficients()));
    let mut at = start.clone();
    for (lower, upper, list) in &shown.parts {
        let n = list.len() - 1;
        // Σ b_i B_i^n is G, by values.
        let same = (0..=n).all(|j| {
            let s = rational(j as i64, n.max(1) as i64);
            let term = |(i, c): (usize, &Rational)| {
                c * Rational::from_integer(binomial(n, i))
                    * crate::math::ring::Ring::powered(&s, i as u32)
                    * crate::math::ring::Ring::powered(&(integer(1) - &s), (n - i) as u32)
            };
            let sum: Rational = list.iter().enumerate().map(term).sum();
            sum == shown.rest.value(&(lower + (upper - lower) * &s))
        });
        if *lower != at || !same || !none_negative(list) {
            return false;
        }
        at = upper.clone();
    }
    tails
        && (at == *end || start > end)
        && (a.is_some() || b.is_some() || !shown.parts.is_empty() || start == end)
}

/// Small, sparse and long coefficients.
fn any_poly(len: usize) -> impl Strategy<Value = Poly> {
    let entry = prop_oneof![
        4 => -9i64..10,
        2 => Just(0i64),
        1 => any::<i64>(),
    ];
    prop::collection::vec((entry, 1i64..5), 0..len)
        .prop_map(|list| list.into_iter().map(|(p, q)| rational(p, q)).collect())
}

/// Everything a list of roots promises, checked by Sturm's theorem.
fn check(f: &Poly, a: Option<&Rational>, b: Option<&Rational>) -> Result<(), TestCaseError> {
    let roots = f.real_roots(a, b).unwrap();
    let (bound, factors) = (f.root_bound(), f.square_free_factors());
    let lower = a.cloned().unwrap_or_else(|| -&bound);
    let upper = b.cloned().unwrap_or_else(|| bound.clone());
    let at_lower = usize::from(lower <= upper && f.value(&lower).is_zero());
    let inside =
        Interval::new(lower.clone(), upper.clone()).map_or(0, |whole| f.count_roots(&whole).unwrap());
    prop_assert_eq!(roots.len(), inside + at_lower);
    for pair in roots.windows(2) {
        prop_assert!(pair[0].0 < pair[1].0);
    }
    for (root, multiplicity) in &roots {
        let own = |(p, m): &(Poly, usize)| root.sign_of(p).is_eq().then_some(*m);
        prop_assert_eq!(factors.iter().find_map(own), Some(*multiplicity));
        if let RealRoot::Irrational(number) = root {
            let (l, u) = number.ends();
            prop_assert!(lower <= l && u <= upper);
            prop_assert_eq!(
                f.count_roots(&Interval::new(l.clone(), u.clone()).unwrap()),
                Some(1 + usize::from(f.value(&u).is_zero()))
            );
            prop_assert_eq!(number.polynomial().content(), integer(1));
            // A rational root of it would have been taken out.
            let lead = number.polynomial().leading_coefficient();
            let candidate =
                (number.refined(&(integer(1) / lead.abs() / integer(2))).ends().1 * &lead).round() / lead;
            prop_assert!(!number.polynomial().value(&candidate).is_zero());
        }
    }
    Ok(())
}

#[test]
fn one_number_is_an_interval() {
    let f = -Poly::variable().pow(2);
    let zero = integer(0);
    let shown = f.positivity(Some(&zero), Some(&zero)).expect("it is 0 there");
    assert!(proves(&shown, &f, Some(&zero), Some(&zero)), "{shown:?}");
    assert_eq!(f.positivity(Some(&integer(1)), Some(&integer(1))).unwrap_err(), integer(1));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn roots_keep_their_promises(f in any_poly(9), a in -6i64..7, b in -6i64..7, k in 1u32..3, g in any_poly(4)) {
        let f = f * g.pow(k);
        prop_assume!(!f.is_zero());
        let (a, b) = (rational(a, 2), rational(b, 3));
        check(&f, None, None)?;
        check(&f, Some(&a), None)?;
        check(&f, None, Some(&b))?;
        if a <= b {
            check(&f, Some(&a), Some(&b))?;
        } else {
            prop_assert_eq!(f.real_roots(Some(&a), Some(&b)), Some(Vec::new()));
        }
    }

    #[test]
    fn known_roots_are_found(
        list in prop::collection::vec((-8i64..9, 1i64..5, 1u32..4), 0..6), squares in prop::collection::vec(1i64..40, 0..3),
    ) {
        let mut f = Poly::from(3);
        let mut expected = std::collections::BTreeMap::new();
        for (p, q, m) in list {
            f *= linear(&rational(p, q)).pow(m);
            *expected.entry(RealRoot::Rational(rational(p, q))).or_insert(0) += m as usize;
        }
        for c in squares {
            f *= square(c);
            for root in [0, 1] {
                let root = square(c).real_roots(None, None).unwrap().remove(root).0;
                *expected.entry(root).or_insert(0) += 1;
            }
        }
        prop_assert_eq!(f.real_roots(None, None).unwrap(), expected.into_iter().collect::<Vec<_>>());
    }

    #[test]
    fn bernstein_coefficients_are_those_of_the_definition(f in any_poly(8), a in -5i64..6, width in 1i64..9) {
        prop_assume!(!f.is_zero());
        let (a, b) = (rational(a, 3), rational(a, 3) + rational(width, 4));
        let n = f.degree().unwrap();
        let list = bernstein::over(f.numerators(), &a, &b);
        let same = |list: &[Int], f: &Poly, a: &Rational, b: &Rational| {
            // Σ b_i B_i^n(s) at n + 1 places is a positive multiple of F.
            let value = |j: usize| {
                let s = rational(j as i64, n.max(1) as i64);
                let sum = list.iter().enumerate().map(|(i, c)| {
                    let basis = Rational::from_integer(binomial(n, i))
                        * crate::math::ring::Ring::powered(&s, i as u32)
                        * crate::math::ring::Ring::powered(&(integer(1) - &s), (n - i) as u32);
                    basis * Rational::from_integer(c.clone())
                });
                (sum.sum::<Rational>(), f.value(&(a + (b - a) * &s)))
            };
            let values: Vec<_> = (0..=n).map(value).collect();
            let factor = values.iter().find(|(_, y)| !y.is_zero()).map(|(x, y)| x / y).unwrap();
            factor.is_positive() && values.iter().all(|(x, y)| *x == &factor * y)
        };
        prop_assert!(same(&list, &f, &a, &b));
        let middle = (&a + &b) / integer(2);
        let (left, right) = bernstein::halves(&list);
        prop_assert!(same(&left, &f, &a, &middle));
        prop_assert!(same(&right, &f, &middle, &b));
    }

    /// A point is one, and without a point all that the certificate says is true and enough.
    #[test]
    fn signs_are_certified(f in any_poly(6), g in any_poly(4), k in 0u32..3, a in -6i64..7, b in -6i64..7) {
        let (a, b) = (rational(a, 2), rational(b, 3));
        let f = f * g.pow(k);
        for (a, b) in [(None, None), (Some(&a), None), (None, Some(&b)), (Some(&a), Some(&b))] {
            // F ≥ 0 has no other end than a square.
            for f in [f.clone(), -f.clone(), &f * &f, (&f * &f) * (Poly::variable().pow(2) + Poly::one())] {
                match f.positivity(a, b) {
                    Err(point) => {
                        prop_assert!(f.value(&point).is_negative());
                        prop_assert!(a.is_none_or(|a| *a <= point) && b.is_none_or(|b| point <= *b));
                    }
                    Ok(shown) => prop_assert!(proves(&shown, &f, a, b), "{f} on {a:?}, {b:?}: {shown:?}"),
                }
            }
        }
        if let (a, b) = (&a, &b) && a < b && !f.is_zero() {
            // By Sturm: no root of odd multiplicity inside, and the sign of one more point.
            let odd: Poly = f.square_free_factors().into_iter().filter(|(_, m)| m % 2 == 1).map(|(p, _)| p).product();
            let whole = Interval::new(a.clone(), b.clone()).unwrap();
            let inside = odd.count_roots(&whole).unwrap_or(0) - usize::from(odd.value(b).is_zero());
            let middle = odd.value(&((a + b) / integer(2)));
            let sturm = inside == 0 && middle.is_negative() == f.leading_coefficient().is_negative();
            prop_assert_eq!(f.negative_point(Some(a), Some(b)).is_none(), sturm);
        }
    }

    #[test]
    fn chains_of_sturm_end_in_the_gcd(f in any_poly(7), g in any_poly(3)) {
        let f = &f * &g * &g;
        let chain = f.sturm_chain();
        prop_assert_eq!(chain.is_empty(), f.is_zero());
        for triple in chain.windows(3) {
            // −P_{k+1} is a positive multiple of the remainder.
            let rest = -triple[0].div_rem(&triple[1]).unwrap().1;
            prop_assert_eq!(rest.leading_monic(), triple[2].leading_monic());
            prop_assert!((rest.leading_coefficient() / triple[2].leading_coefficient()).is_positive());
        }
        if let [.., before, last] = chain.as_slice() {
            prop_assert_eq!(last.leading_monic(), f.gcd(&f.derivative()));
            prop_assert!(before.div_exact(last).is_some());
        }
    }

    #[test]
    fn signs_agree_with_refined_intervals(f in any_poly(6), c in 2i64..30, negative: bool) {
        let g = square(c);
        let root = if negative { g.real_roots(None, None).unwrap().remove(0).0 } else { g.real_roots(None, None).unwrap().remove(1).0 };
        let RealRoot::Irrational(number) = &root else { return Ok(()) };
        // F mod t² − c is p + q t, whose sign at ±√c is that of p² against c q².
        let rest = f.div_rem(&g).unwrap().1;
        let (p, q) = (rest.coefficient(0), rest.coefficient(1));
        let q = if negative { -q } else { q };
        let (p2, q2) = (&p * p.abs(), &q * q.abs() * integer(c));
        prop_assert_eq!(number.sign_of(&f), (p2 + q2).cmp(&Rational::zero()));
    }
}

#[test]
fn numbers_are_the_same_by_different_polynomials() {
    let (two, eight) = (irrational(&square(2), 1), irrational(&square(8), 1));
    let other = irrational(&(Poly::variable().pow(4) - Poly::variable().pow(2) - Poly::from(2)), 1);
    assert_eq!(two, other);
    assert!(two < eight && irrational(&square(2), 0) < two);
    assert_eq!(two.compare_with(&rational(141_421_356, 100_000_000)), Ordering::Greater);
    assert_eq!(two.compare_with(&rational(141_421_357, 100_000_000)), Ordering::Less);
    // Close neighbours: √2 and the root near it of t^2 − 2 − 10^-40.
    let near = Poly::variable().pow(2)
        - Poly::from(2)
        - Poly::constant(Rational::new(1.into(), Int::from(10).pow(40)));
    assert!(two < irrational(&near, 1));
    // Ten digits, and a hundred.
    let (lower, upper) = two.refined(&Rational::new(1.into(), Int::from(10).pow(100))).ends();
    assert!(&lower * &lower < integer(2) && &upper * &upper > integer(2));
}

#[test]
fn degenerate_polynomials() {
    assert_eq!(Poly::zero().real_roots(None, None), None);
    assert_eq!(Poly::from(7).real_roots(None, None), Some(Vec::new()));
    assert!(Poly::zero().sturm_chain().is_empty());
    assert_eq!(Poly::from(-7).sturm_chain(), [Poly::from(-7)]);
    assert_eq!(Poly::variable().real_roots(Some(&integer(0)), Some(&integer(0))).unwrap().len(), 1);
    assert_eq!(Poly::zero().root_bound(), Rational::one());
    assert!(Poly::from(7).subdivision(&Interval::unit()).is_empty());
    let many = (1..=20).map(|k| linear(&integer(k))).product::<Poly>();
    assert_eq!(many.real_roots(Some(&integer(3)), Some(&rational(21, 2))).unwrap().len(), 8);
    // Mignotte's polynomial: two roots closer than 10^-15.
    let t = Poly::variable();
    let close = t.pow(13) - Poly::from(2) * (Poly::from(1000) * &t - Poly::one()).pow(2);
    let roots = close.real_roots(None, None).unwrap();
    assert_eq!(roots.len(), 3);
    check(&close, None, None).unwrap();
}

/// Swinnerton-Dyer's polynomial has 16 factors modulo every prime; its roots ±√2 ± √3 ± √5 ± √7 ± √11 are found all the same.
#[test]
fn many_factors_modulo_primes() {
    let t = Poly::variable();
    let mut f = t.clone();
    for prime in [2, 3, 5, 7, 11] {
        // F(t − √p) F(t + √p) as the norm of F(t + s) modulo s² − p.
        let n = f.degree().unwrap();
        let (mut even, mut odd) = (Poly::zero(), Poly::zero());
        let mut derivative = f.clone();
        let mut share = integer(1);
        for k in 0..=n {
            let scale = &share * Rational::from_integer(Int::from(prime).pow((k / 2) as u32));
            if k % 2 == 0 {
                even += derivative.scale(&scale)
            } else {
                odd += derivative.scale(&scale)
            }
            derivative = derivative.derivative();
            share /= integer(k as i64 + 1);
        }
        f = even.pow(2) - odd.pow(2).scale(&integer(prime));
    }
    assert_eq!(f.degree(), Some(32));
    assert_eq!(f.real_roots(None, None).unwrap().len(), 32);
    let with_rational = f * linear(&rational(3, 7));
    let rational_roots =
        |(root, _): &(RealRoot, usize)| matches!(root, RealRoot::Rational(q) if *q == rational(3, 7));
    assert_eq!(with_rational.real_roots(None, None).unwrap().iter().filter(|r| rational_roots(r)).count(), 1);
}

/// P/Q of an extreme value lies between its values at many places, and is one of them up to the width of the intervals.
fn bounds_all_values(p: &Poly, q: &Poly, a: &Rational, b: &Rational) {
    for largest in [true, false] {
        let found = p.extreme(q, [a, b], [false, false], largest).unwrap();
        let steps = 40;
        for k in 0..=steps {
            let at = a + (b - a) * rational(k, steps);
            let value = RealRoot::Rational(p.value(&at) / q.value(&at));
            assert!(if largest { value <= found.value } else { value >= found.value });
        }
        // The values around a place where it is taken enclose it.
        for place in &found.places {
            let (lower, upper) = match place {
                RealRoot::Rational(t) => (t.clone(), t.clone()),
                RealRoot::Irrational(number) => number.refined(&rational(1, 1 << 20)).ends(),
            };
            let near = RealRoot::Rational(p.value(&lower) / q.value(&lower));
            let distance = RealRoot::Rational(p.value(&upper) / q.value(&upper));
            let slack = rational(1, 1000);
            let least = near.clone().min(distance.clone());
            let most = near.max(distance);
            let shifted = |root: RealRoot, by: Rational| match root {
                RealRoot::Rational(value) => RealRoot::Rational(value + by),
                root @ RealRoot::Irrational(_) => root,
            };
            assert!(shifted(least, -slack.clone()) <= found.value && found.value <= shifted(most, slack));
        }
    }
}

proptest! {
    #[test]
    fn extreme_values_bound_all_others(
        p in proptest::collection::vec(-6_i64..=6, 1..6),
        q in proptest::collection::vec(-3_i64..=3, 1..3),
        ends in (-3_i64..=3, 0_i64..=4),
    ) {
        let poly = |list: &[i64]| Poly::from_coefficients(list.iter().map(|&c| integer(c)).collect());
        let (a, b) = (integer(ends.0), integer(ends.0 + ends.1));
        let (p, q) = (poly(&p), poly(&q));
        let poles = q.real_roots(Some(&a), Some(&b));
        if poles.is_some_and(|poles| poles.is_empty()) {
            bounds_all_values(&p, &q, &a, &b);
        } else {
            prop_assert_eq!(p.extreme(&q, [&a, &b], [false, false], true), None);
        }
    }
}

#[test]
fn extreme_values_at_open_ends_are_none() {
    let t = Poly::variable();
    let one = Poly::one();
    let [a, b] = [integer(0), integer(2)];
    let of = |f: &Poly, open: [bool; 2], largest| {
        f.extreme(&one, [&a, &b], open, largest).map(|e| (e.value, e.places))
    };
    let number = |q: i64| RealRoot::Rational(integer(q));
    assert_eq!(of(&t, [false, true], true), None);
    assert_eq!(of(&t, [false, true], false), Some((number(0), vec![number(0)])));
    assert_eq!(of(&one, [true, true], true), Some((number(1), vec![number(1)])));
    assert_eq!(of(&(&t * (Poly::from(2) - &t)), [true, true], true), Some((number(1), vec![number(1)])));
    assert_eq!(Poly::zero().extreme(&one, [&b, &a], [false, false], true), None);
    assert_eq!(one.extreme(&t, [&a, &b], [false, false], true), None);
}
