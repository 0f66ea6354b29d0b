//! Irreducible factors over the integers: modulo a prime, lifted to a power of it, then put together.

use num_integer::Integer;
use num_traits::{Signed, Zero};

use super::modular;
use crate::budget;
use crate::math::number::{Combinations, Int, Modulus, primes};
use crate::math::poly::dense_modular::gcd;
use crate::math::poly::{dense, dense_divide};

/// So many primes are tried for one with few factors.
const PRIMES: usize = 4;

/// Products of so many parts are a small part of the work, for any number of parts.
pub(super) const FEW_PARTS: usize = 2;

/// For so many parts all of their products are few.
const ALL_PRODUCTS: usize = 12;

/// The irreducible factors, primitive, of a primitive polynomial without repeated factors.
pub(super) fn irreducible_factors(f: Vec<Int>) -> Vec<Vec<Int>> {
    factors_of_parts(f, usize::MAX)
}

/// The same, but where there are many factors modulo a prime, products of more than `most` of them are not tried and
/// may stay together.
pub(super) fn factors_of_parts(f: Vec<Int>, most: usize) -> Vec<Vec<Int>> {
    match f.len() {
        0 | 1 => Vec::new(),
        2 => vec![f],
        _ => {
            let (field, parts) = modulo_a_prime(&f);
            if parts.len() == 1 {
                return vec![f];
            }
            let (parts, modulus) = lifted(&f, &field, &parts);
            put_together(f, parts, &modulus, most)
        }
    }
}

/// A prime modulo which the polynomial keeps its degree and has no repeated factors, and its monic
/// factors there: of some primes that with the fewest.
fn modulo_a_prime(f: &[Int]) -> (Modulus, Vec<Vec<u64>>) {
    let usable = primes().filter_map(|field| {
        let image = modular::image(&field, f);
        let slope = modular::derivative(&field, &image);
        let keeps = image.len() == f.len() && gcd(&field, image.clone(), slope).len() == 1;
        keeps.then(|| (field, modular::monic(&field, image)))
    });
    let mut best: Option<(Modulus, Vec<Vec<u64>>)> = None;
    for (field, image) in usable.take(PRIMES) {
        let parts = modular::irreducible_factors(&field, image);
        if best.as_ref().is_none_or(|(_, fewest)| parts.len() < fewest.len()) {
            best = Some((field, parts));
        }
        if best.as_ref().is_some_and(|(_, fewest)| fewest.len() <= 2) {
            break;
        }
    }
    best.expect("only finitely many primes divide the discriminant")
}

/// The factors modulo a power of the prime that is larger than twice any coefficient of lead(f) times a
/// factor: by linear steps, all factors at once.
fn lifted(f: &[Int], field: &Modulus, parts: &[Vec<u64>]) -> (Vec<Vec<Int>>, Int) {
    let lead = &f[f.len() - 1];
    // Mignotte: no coefficient of a factor exceeds 2^deg times the length of f.
    let enough = dense::height_bits(f) + lead.bits() + 2 * f.len() as u64 + 2;
    let cofactors: Vec<Vec<u64>> = parts
        .iter()
        .enumerate()
        .map(|(i, part)| {
            let others = parts.iter().enumerate().filter(|(j, _)| *j != i);
            let product = others.fold(vec![field.enter(1)], |product, (_, other)| {
                modular::reduced(field, modular::times(field, &product, other), part)
            });
            modular::inverse(field, &product, part)
        })
        .collect();
    let p = Int::from(field.p);
    let inverse_lead = field.invert(field.enter(lead.mod_word(field.p)));
    let mut modulus = p.clone();
    let number = |x: &u64| Int::from(field.leave(*x));
    let mut found: Vec<Vec<Int>> = parts.iter().map(|part| part.iter().map(number).collect()).collect();
    while modulus.bits() <= enough {
        budget::charge_bits(modulus.bits().saturating_mul(f.len() as u64));
        let next = &modulus * &p;
        let product = found.iter().fold(vec![lead.clone()], |product, part| {
            dense::product(&product, part).iter().map(|x| x.mod_floor(&next)).collect()
        });
        // (f - lead ∏ parts)/modulus, a polynomial of smaller degree.
        let error = f.iter().zip(&product).map(|(x, y)| {
            let error = (x - y).mod_floor(&next).div_exact(&modulus);
            field.enter(error.mod_word(field.p))
        });
        let mut error = modular::trimmed(error.collect());
        modular::scale(field, &mut error, inverse_lead);
        for ((part, image), cofactor) in found.iter_mut().zip(parts).zip(&cofactors) {
            let error = modular::reduced(field, error.clone(), image);
            let change = modular::reduced(field, modular::times(field, &error, cofactor), image);
            for (x, y) in part.iter_mut().zip(&change) {
                *x += number(y) * &modulus;
            }
        }
        modulus = next;
    }
    (found, modulus)
}

/// Products of the parts, few first, that divide f.
fn put_together(mut f: Vec<Int>, mut parts: Vec<Vec<Int>>, modulus: &Int, most: usize) -> Vec<Vec<Int>> {
    let mut factors = Vec::new();
    let mut size = 1;
    while 2 * size <= parts.len() && (size <= most || parts.len() <= ALL_PRODUCTS) {
        let lead = f[f.len() - 1].clone();
        let found = Combinations::new(parts.len(), size).find_map(|chosen| {
            budget::step();
            // The last coefficient tells most wrong products at once.
            let last = chosen.iter().fold(lead.clone(), |x, &i| (x * &parts[i][0]).mod_floor(modulus));
            let last = least(last, modulus);
            let product = &lead * &f[0];
            if !(if last.is_zero() { product.is_zero() } else { product.is_multiple_of(&last) }) {
                return None;
            }
            let candidate = chosen.iter().fold(vec![lead.clone()], |product, &i| {
                dense::product(&product, &parts[i]).iter().map(|x| x.mod_floor(modulus)).collect()
            });
            let mut candidate: Vec<Int> = candidate.into_iter().map(|x| least(x, modulus)).collect();
            dense::trim(&mut candidate);
            let candidate = positive(dense::primitive(candidate));
            let rest = dense_divide::exact_quotient(&f, &candidate)?;
            Some((chosen, candidate, rest))
        });
        match found {
            Some((chosen, factor, rest)) => {
                factors.push(factor);
                f = rest;
                parts =
                    parts.into_iter().enumerate().filter(|(i, _)| !chosen.contains(i)).map(|x| x.1).collect();
            }
            None => size += 1,
        }
    }
    if f.len() > 1 {
        factors.push(positive(f));
    }
    factors
}

fn positive(f: Vec<Int>) -> Vec<Int> {
    if f.last().is_some_and(Signed::is_negative) { dense::negated(&f) } else { f }
}

/// The residue of least size.
fn least(x: Int, modulus: &Int) -> Int {
    if &x + &x > *modulus { x - modulus } else { x }
}
