//! Irreducible factors in several variables.
//!
//! A square-free F, monic in one variable x, is factored at numbers for the others, where its factors are
//! known from one variable. These are lifted to all degrees in the others: with ∏ G_j = F up to degree k − 1,
//! the terms of degree k of F − ∏ G_j are shared out by the s_j with Σ s_j ∏_{i≠j} u_i = 1, where u_j is G_j at
//! these numbers. A true factor is a product of some G_j, cut at the degree of F. A leading coefficient c is
//! moved into x: c^{n−1} f(x/c) is monic in x.
//!
//! P. S. Wang, "An improved multivariate polynomial factoring algorithm", Math. Comp. 32 (1978).

use std::collections::BTreeMap;

use num_traits::One;

use super::modular::random;
use crate::budget;
use crate::math::number::{Combinations, Rational, integer};
use crate::math::poly::{MonomialOrder, MultiPoly, Poly, Powers, Symbol};
use crate::math::ring::Ring;

/// So many points are tried for one with few factors.
const POINTS: usize = 4;

/// The irreducible factors, primitive over the integers, with their multiplicities.
pub(super) fn factors(p: &MultiPoly) -> Vec<(MultiPoly, usize)> {
    let p = p.primitive_part();
    match p.variables() {
        [] => Vec::new(),
        [x] => {
            let factors = one_variable(&p, x).factors().factors;
            factors.into_iter().map(|(factor, m)| (in_variable(&factor, x).primitive_part(), m)).collect()
        }
        _ => {
            let x = main_variable(&p);
            let coefficients = p.coefficients_in(&x);
            let content = coefficients.iter().fold(MultiPoly::zero(), |g, c| g.gcd(c));
            let mut found = factors(&content);
            for (part, multiplicity) in square_free(&divided(&p, &content), &x) {
                found.extend(split(&part, &x).into_iter().map(|factor| (factor, multiplicity)));
            }
            found
        }
    }
}

/// The variable that needs the least lifting: with a number as leading coefficient, of small degree.
fn main_variable(p: &MultiPoly) -> Symbol {
    let cost = |x: &&Symbol| {
        let lead = p.coefficients_in(x).pop().unwrap_or_else(MultiPoly::zero);
        (lead.as_constant().is_none(), p.degree_in(x))
    };
    p.variables().iter().min_by_key(cost).expect("a variable").clone()
}

fn one_variable(p: &MultiPoly, x: &Symbol) -> Poly {
    p.coefficients_in(x).iter().map(|c| c.as_constant().expect("one variable")).collect()
}

fn in_variable(p: &Poly, x: &Symbol) -> MultiPoly {
    p.value_in(&MultiPoly::symbol(x.clone()))
}

fn divided(a: &MultiPoly, b: &MultiPoly) -> MultiPoly {
    a.div_exact(b).expect("a divisor")
}

/// Yun's algorithm for a polynomial without a factor that is free of x: square-free parts with their
/// multiplicities.
fn square_free(p: &MultiPoly, x: &Symbol) -> Vec<(MultiPoly, usize)> {
    let mut parts = Vec::new();
    let derivative = p.derivative(x);
    let repeated = p.gcd(&derivative);
    let (mut v, mut w) = (divided(p, &repeated), divided(&derivative, &repeated));
    let mut multiplicity = 1;
    while v.degree_in(x) > 0 {
        w = w.minus(&v.derivative(x));
        let factor = v.gcd(&w);
        (v, w) = (divided(&v, &factor), divided(&w, &factor));
        if factor.degree_in(x) > 0 {
            parts.push((factor.primitive_part(), multiplicity));
        }
        multiplicity += 1;
    }
    parts
}

/// The irreducible factors of a square-free polynomial of which none is free of x.
fn split(f: &MultiPoly, x: &Symbol) -> Vec<MultiPoly> {
    let coefficients = f.coefficients_in(x);
    let degree = coefficients.len() - 1;
    if degree <= 1 {
        return vec![f.primitive_part()];
    }
    let lead = &coefficients[degree];
    if let Some(c) = lead.as_constant() {
        return split_monic(&f.scaled(&c.recip()), x).iter().map(MultiPoly::primitive_part).collect();
    }
    let mut power = MultiPoly::one();
    let mut monic = vec![MultiPoly::one()];
    for c in coefficients[..degree].iter().rev() {
        monic.push(c.times(&power));
        power = power.times(lead);
    }
    monic.reverse();
    let found = split_monic(&MultiPoly::from_coefficients_in(x, &monic), x);
    let scaled = lead.times(&MultiPoly::symbol(x.clone()));
    let back = |factor: &MultiPoly| {
        let factor = factor.substitute(&[(x.clone(), scaled.clone())]);
        let content = factor.coefficients_in(x).iter().fold(MultiPoly::zero(), |g, c| g.gcd(c));
        divided(&factor, &content).primitive_part()
    };
    found.iter().map(back).collect()
}

/// The factors, monic in x, of a square-free polynomial that is monic in x.
fn split_monic(f: &MultiPoly, x: &Symbol) -> Vec<MultiPoly> {
    let others: Vec<Symbol> = f.variables().iter().filter(|y| *y != x).cloned().collect();
    let (point, parts) = at_a_point(f, x, &others);
    if parts.len() == 1 {
        return vec![f.clone()];
    }
    let moved = |sign: i64| {
        let to = |(y, a): (&Symbol, &i64)| {
            (y.clone(), MultiPoly::symbol(y.clone()).plus(&MultiPoly::constant(integer(sign * a))))
        };
        others.iter().zip(&point).map(to).collect::<Vec<_>>()
    };
    let f = f.substitute(&moved(1));
    let degree_of = |powers: &Powers| powers.iter().filter(|(y, _)| y != x).map(|(_, e)| e).sum::<u32>();
    let degree = f.terms(MonomialOrder::Lex).iter().map(|(powers, _)| degree_of(powers)).max().unwrap_or(0);
    let lifted = lifted(&f, x, &parts, degree, &degree_of);
    put_together(f, lifted, |p| cut(p, degree, &degree_of)).iter().map(|g| g.substitute(&moved(-1))).collect()
}

/// Small numbers for the other variables at which no factor is repeated, and the monic factors there: of
/// some points one with the fewest.
fn at_a_point(f: &MultiPoly, x: &Symbol, others: &[Symbol]) -> (Vec<i64>, Vec<Poly>) {
    let mut best: Option<(Vec<i64>, Vec<Poly>)> = None;
    let (mut seed, mut tried, mut range) = (0, 0, 2);
    while tried < POINTS {
        budget::step();
        let mut number = || (random(&mut seed) % (2 * range + 1)) as i64 - range as i64;
        let point: Vec<i64> = others.iter().map(|_| number()).collect();
        range += 1;
        let value = |y: &Symbol| others.iter().position(|other| other == y).map(|i| integer(point[i]));
        let image = one_variable(&f.value(&value), x);
        if image.gcd(&image.derivative()).degree() != Some(0) {
            continue;
        }
        tried += 1;
        let parts: Vec<Poly> = image.factors().factors.iter().map(|(part, _)| part.leading_monic()).collect();
        if best.as_ref().is_none_or(|(_, fewest)| parts.len() < fewest.len()) {
            best = Some((point, parts));
        }
        if best.as_ref().is_some_and(|(_, fewest)| fewest.len() == 1) {
            break;
        }
    }
    best.expect("a point was tried")
}

/// The terms of a polynomial up to a degree in the other variables.
fn cut(p: &MultiPoly, degree: u32, degree_of: &impl Fn(&Powers) -> u32) -> MultiPoly {
    MultiPoly::from_terms(
        p.terms(MonomialOrder::Lex).into_iter().filter(|(powers, _)| degree_of(powers) <= degree),
    )
}

/// The factors at 0 lifted up to a degree in the other variables.
fn lifted(
    f: &MultiPoly,
    x: &Symbol,
    parts: &[Poly],
    degree: u32,
    degree_of: &impl Fn(&Powers) -> u32,
) -> Vec<MultiPoly> {
    let remainder = |a: &Poly, b: &Poly| a.div_rem(b).map_or_else(Poly::zero, |(_, rest)| rest);
    let cofactor = |j: usize| {
        let others = parts.iter().enumerate().filter(|(i, _)| *i != j);
        let product = others.fold(Poly::one(), |product, (_, u)| remainder(&(product * u), &parts[j]));
        inverse(&product, &parts[j])
    };
    let cofactors: Vec<Poly> = (0..parts.len()).map(cofactor).collect();
    let mut found: Vec<MultiPoly> = parts.iter().map(|u| in_variable(u, x)).collect();
    for k in 1..=degree {
        let product = found
            .iter()
            .fold(MultiPoly::one(), |product, g| cut(&product.times(&cut(g, k, degree_of)), k, degree_of));
        let mut errors: BTreeMap<Powers, Vec<Rational>> = BTreeMap::new();
        for (powers, c) in f.minus(&product).terms(MonomialOrder::Lex) {
            if degree_of(&powers) != k {
                continue;
            }
            let (in_x, rest): (Powers, Powers) = powers.into_iter().partition(|(y, _)| y == x);
            let e = in_x.first().map_or(0, |(_, e)| *e as usize);
            let row = errors.entry(rest).or_default();
            row.resize(row.len().max(e + 1), Rational::default());
            row[e] = c;
        }
        for (monomial, row) in errors {
            let error = Poly::from_coefficients(row);
            let monomial = MultiPoly::from_terms([(monomial, Rational::one())]);
            for ((g, u), s) in found.iter_mut().zip(parts).zip(&cofactors) {
                let change = remainder(&(remainder(&error, u) * s), u);
                *g = g.plus(&in_variable(&change, x).times(&monomial));
            }
        }
    }
    found
}

/// The s with a s = 1 mod f, for coprime a and f.
fn inverse(a: &Poly, f: &Poly) -> Poly {
    let (mut r0, mut r1) = (f.clone(), a.clone());
    let (mut s0, mut s1) = (Poly::zero(), Poly::one());
    while r1.degree() > Some(0) {
        let (q, rest) = r0.div_rem(&r1).expect("a divisor");
        let s = s0 - q * &s1;
        (r0, r1) = (r1, rest);
        (s0, s1) = (s1, s);
    }
    let s = s1.scale(&r1.leading_coefficient().recip());
    s.div_rem(f).map_or_else(Poly::zero, |(_, rest)| rest)
}

/// Products of the parts, few first, that divide f.
fn put_together(
    mut f: MultiPoly,
    mut parts: Vec<MultiPoly>,
    cut: impl Fn(&MultiPoly) -> MultiPoly,
) -> Vec<MultiPoly> {
    let mut factors = Vec::new();
    let mut size = 1;
    while 2 * size <= parts.len() {
        let found = Combinations::new(parts.len(), size).find_map(|chosen| {
            budget::step();
            let product = chosen.iter().fold(MultiPoly::one(), |p, &i| cut(&p.times(&parts[i])));
            f.div_exact(&product).map(|rest| (chosen, product, rest))
        });
        match found {
            Some((chosen, factor, rest)) => {
                factors.push(factor);
                f = rest;
                let left = parts.into_iter().enumerate().filter(|(i, _)| !chosen.contains(i));
                parts = left.map(|(_, part)| part).collect();
            }
            None => size += 1,
        }
    }
    factors.push(f);
    factors
}
