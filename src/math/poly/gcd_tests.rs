//! The gcd in several variables against the remainder sequence, and by its laws.

use super::gcd::{euclid, modular};
use super::gcd_modular::degree_bounds;
use super::multivariate::aligned;
use super::{MultiPoly, Symbol};
use crate::math::number::Int;
use crate::math::number::rational;
use crate::math::ring::Ring;
use num_traits::{One, Zero};
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

/// A polynomial with `terms` draws of a term in `names`, degrees below `degree`, numbers of `bits` bits.
fn drawn(state: &mut u64, names: &[&str], terms: usize, degree: u32, bits: u32) -> MultiPoly {
    let mut draw = || {
        *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (*state >> 33) as u32
    };
    MultiPoly::from_terms((0..terms).map(|_| {
        let powers = names.iter().map(|name| (Symbol::new(*name), draw() % degree)).collect();
        let number = (0..bits.div_ceil(30))
            .fold(Int::ZERO, |c, _| c * Int::from(1 << 30) + Int::from(draw() % (1 << bits.min(30))));
        let sign = if draw() % 2 == 0 { Int::ONE } else { Int::from(-1) };
        (powers, (number * sign).into())
    }))
}

/// gcd(A C, B C) is a multiple of C, and the cofactors have no common factor: a law that determines it.
fn check(a: &MultiPoly, b: &MultiPoly, c: &MultiPoly) {
    let (x, y) = (a.times(c), b.times(c));
    let g = x.gcd(&y);
    assert!(g.is_canonical());
    if x.is_zero() || y.is_zero() {
        return;
    }
    assert!(g.div_exact(c).is_some(), "gcd({x}, {y}) = {g} misses {c}");
    let (u, v) = (x.div_exact(&g).unwrap(), y.div_exact(&g).unwrap());
    let (_, in_u, in_v) = aligned(&u, &v);
    assert!(degree_bounds(&in_u, &in_v, aligned(&u, &v).0.len()).iter().all(|d| *d == 0), "{u}, {v}");
}

#[test]
fn random_factors() {
    let mut state = 7;
    for names in [&["x", "y"][..], &["x", "y", "z"], &["w", "x", "y", "z"], &["u", "v", "w", "x", "y", "z"]] {
        for (terms, degree, bits) in
            [(2, 3, 3), (5, 4, 7), (8, 6, 20), (6, 4, 60), (4, 3, 300), (12, 10, 7), (6, 60, 40)]
        {
            let [a, b, c] = [0; 3].map(|_| drawn(&mut state, names, terms, degree, bits));
            check(&a, &b, &c);
            check(&a.plus(&MultiPoly::one()), &b, &c.times(&c));
        }
    }
}

/// Contents in each variable, numbers as contents, leading coefficients in common.
#[test]
fn factors_that_lack_variables() {
    let mut state = 11;
    for round in 0..12 {
        let bits = [4, 70][round % 2];
        let mut product = |lists: &[&[&str]]| {
            lists.iter().fold(MultiPoly::one(), |p, names| p.times(&drawn(&mut state, names, 3, 3, bits)))
        };
        let c = product(&[&["x"], &["y", "z"], &["x", "z"]]);
        let (a, b) = (product(&[&["y"], &["x", "y", "z"]]), product(&[&["z"], &["x", "y", "z"]]));
        check(&a, &b, &c);
    }
}

#[test]
fn the_two_ways_agree() {
    let mut state = 5;
    for _ in 0..60 {
        let [a, b, c] = [0; 3].map(|_| drawn(&mut state, &["x", "y"], 3, 3, 5));
        let (a, b) = (a.times(&c).primitive_part(), b.times(&c).primitive_part());
        let (vars, in_a, in_b) = aligned(&a, &b);
        let bounds = degree_bounds(&in_a, &in_b, vars.len());
        if a.vars == b.vars && vars.len() == 2 && bounds.iter().all(|d| *d > 0) {
            let expected = euclid(&a, &b, &vars[0]);
            assert_eq!(modular(&a, &b, &bounds), Some(expected.clone()));
            assert_eq!(modular(&a, &b, &[a.degree_in(&vars[0]), a.degree_in(&vars[1])]), Some(expected));
        }
    }
}

/// Numbers that vanish modulo the first prime, so that terms are missed there.
#[test]
fn multiples_of_the_primes() {
    let p = Int::from(super::dense_ntt::FIELDS[0].p);
    let names = ["x", "y", "z"].map(|name| MultiPoly::symbol(Symbol::new(name)));
    let [x, y, z] = &names;
    let times_p = |f: &MultiPoly| f.scaled(&p.clone().into());
    let c = x.pow(2).plus(&times_p(&y.times(z))).plus(&y.pow(3)).plus(&z.scaled(&Int::from(3).into()));
    let d = times_p(&x.pow(2)).plus(&y.times(z)).plus(&z.pow(2)).plus(&x.times(y));
    let (a, b) = (x.plus(y).plus(z), x.times(y).minus(z));
    check(&a, &b, &c);
    check(&a, &b, &d);
    check(&a, &b, &c.times(&d));
}

/// Exponents beyond what the images can tell apart.
#[test]
fn huge_exponents() {
    let at = |name: &str, e: u32| MultiPoly::symbol(Symbol::new(name)).pow(e);
    let c = ["u", "v", "w", "x", "y", "z"].iter().fold(MultiPoly::one(), |c, name| c.plus(&at(name, 1)));
    let a = ["u", "v", "w"].iter().fold(at("x", 900), |c, name| c.times(&at(name, 700))).plus(&at("y", 3));
    let (x, y) = (a.times(&c), c.times(&at("z", 5).plus(&MultiPoly::one())));
    assert_eq!(x.gcd(&y), c);
}

#[test]
fn quotients_of_each_kind() {
    let mut state = 3;
    for (terms, degree, bits) in [(30, 3, 5), (30, 4, 62), (10, 100, 9), (10, 3, 500), (10, 1 << 20, 9)] {
        let [a, b] = [0; 2].map(|_| drawn(&mut state, &["x", "y", "z"], terms, degree, bits));
        let product = a.times(&b);
        assert_eq!(product.div_exact(&b), Some(a.clone()));
        assert_eq!(product.plus(&MultiPoly::one()).div_exact(&b), None);
        assert_eq!(product.plus(&a).div_exact(&b), None);
    }
}
