//! Sums of terms without summation: classes of terms whose quotients are rational functions.
//!
//! Two terms are in one class if, up to constant shifts, they have the same factorials and the
//! same powers. Each class is written as (rational function) · (common term); the sum is 0
//! wherever all terms are defined if each of these rational functions is 0.

use std::collections::BTreeMap;

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::linear::Linear;
use super::term::{Base, Term, power, rising};
use crate::budget;
use crate::math::number::Int;
use crate::math::poly::{Fraction, MonomialOrder, MultiPoly};
use crate::math::ring::Ring;

/// What the terms of a class have in common: linear parts of the arguments of factorials with
/// their multiplicity, bases with the linear parts of their exponents.
pub type Key = (Vec<(Linear, i32)>, Vec<(Base, Linear)>);

/// A member of a class: its rational function and the offsets of the factorials, part by part.
struct Member {
    coefficient: Fraction,
    offsets: Vec<Vec<i64>>,
}

/// A class as the product of a rational function and a term.
pub struct Class {
    /// The rational function.
    pub coefficient: Fraction,
    /// The common term; its coefficient is 1.
    pub common: Term,
}

/// The classes of a sum of terms in which no variable is bound and all guards hold.
/// `None` if arguments or exponents lie too far apart.
pub fn classes(terms: &[Term]) -> Option<Vec<Class>> {
    let mut found: BTreeMap<Key, Vec<Member>> = BTreeMap::new();
    for term in refined(terms)? {
        budget::step();
        let term = term.cancelled()?;
        if term.coefficient.is_zero() {
            continue;
        }
        let (key, member) = split(term)?;
        found.entry(key).or_default().push(member);
    }
    found.into_iter().map(|(key, members)| class(key, members)).collect()
}

/// Whether the sum is 0 wherever all its terms are defined; `false` may mean that this is open.
pub fn vanishes(terms: &[Term]) -> bool {
    classes(terms).is_some_and(|list| list.iter().all(|class| class.coefficient.is_zero()))
}

/// The class of a term.
pub fn key(term: &Term) -> Option<Key> {
    Some(split(term.cancelled()?)?.0)
}

fn split(term: Term) -> Option<(Key, Member)> {
    let mut coefficient = term.coefficient;
    let mut parts: BTreeMap<Linear, (i32, Vec<i64>)> = BTreeMap::new();
    for (form, m) in term.factorials {
        let entry = parts.entry(form.without_offset()).or_default();
        entry.0 += m;
        let offset = form.offset().as_small()?;
        entry.1.extend(std::iter::repeat_n(offset, m.unsigned_abs() as usize));
    }
    let mut powers = Vec::new();
    for (base, exponent) in term.powers {
        let mut offset = exponent.offset().as_small()?;
        let mut part = exponent.without_offset();
        if base.is_sign() {
            offset = offset.rem_euclid(2);
            part = parity(&part);
        }
        coefficient *= power(&Fraction::from(base.poly()), offset)?;
        if part != Linear::default() {
            powers.push((base, part));
        }
    }
    let factorials = parts.iter().map(|(part, (m, _))| (part.clone(), *m)).collect();
    let offsets = parts.into_values().map(|(_, offsets)| offsets).collect();
    Some(((factorials, powers), Member { coefficient, offsets }))
}

/// The form with its coefficients reduced modulo 2, for exponents of −1.
fn parity(form: &Linear) -> Linear {
    form.terms()
        .iter()
        .filter(|(_, a)| a.is_odd())
        .fold(Linear::default(), |sum, (symbol, _)| sum.plus(&Linear::symbol(symbol)))
}

fn class((factorials, powers): Key, members: Vec<Member>) -> Option<Class> {
    let mut common = Term::new(Fraction::one());
    // Numerators refer to the smallest argument, denominators to the largest: then
    // (L+a)! = (L+r+1)…(L+a) (L+r)! and 1/(L+a)! = (L+a+1)…(L+r)/(L+r)! hold everywhere.
    let mut references = Vec::new();
    for (k, (part, m)) in factorials.iter().enumerate() {
        let offsets = members.iter().flat_map(|member| &member.offsets[k]);
        let reference = if *m > 0 { *offsets.min()? } else { *offsets.max()? };
        common.multiply_factorial(part.shifted(reference), *m);
        references.push(reference);
    }
    for (base, part) in &powers {
        common.multiply_power(&Fraction::from(base.poly()), part)?;
    }
    let mut sum = Fraction::zero();
    for member in members {
        budget::step();
        let mut product = MultiPoly::one();
        for ((part, m), (offsets, reference)) in factorials.iter().zip(member.offsets.iter().zip(&references))
        {
            for offset in offsets {
                let factor = if *m > 0 {
                    rising(part, reference + 1, *offset)?
                } else {
                    rising(part, offset + 1, *reference)?
                };
                product = product.times(&factor);
            }
        }
        sum += member.coefficient.times(&Fraction::from(product));
    }
    Some(Class { coefficient: sum, common })
}

/// The terms over pairwise coprime bases.
fn refined(terms: &[Term]) -> Option<Vec<Term>> {
    let mut bases: Vec<MultiPoly> = Vec::new();
    for base in terms.iter().flat_map(|term| term.powers.keys()) {
        let p = base.poly();
        if p.as_constant().is_none() && !bases.contains(&p) {
            bases.push(p);
        }
    }
    let basis = coprime(&bases);
    if bases.iter().all(|b| basis.contains(b)) {
        return Some(terms.to_vec());
    }
    terms.iter().map(|term| over(term, &basis)).collect()
}

/// The term with its bases factored over the basis.
fn over(term: &Term, basis: &[MultiPoly]) -> Option<Term> {
    let mut result = Term { powers: BTreeMap::new(), ..term.clone() };
    for (base, exponent) in &term.powers {
        let mut rest = base.poly();
        for factor in basis {
            let mut multiplicity = 0;
            while let (None, Some(quotient)) = (rest.as_constant(), rest.div_exact(factor)) {
                budget::step();
                multiplicity += 1;
                rest = quotient;
            }
            if multiplicity > 0 {
                result.multiply_power(
                    &Fraction::from(factor.clone()),
                    &exponent.scaled(&Int::from(multiplicity)),
                )?;
            }
        }
        result.multiply_power(&Fraction::from(rest), exponent)?;
    }
    Some(result)
}

/// Pairwise coprime primitive polynomials of which all the given ones are products.
fn coprime(polys: &[MultiPoly]) -> Vec<MultiPoly> {
    let mut basis: Vec<MultiPoly> = Vec::new();
    let mut waiting = polys.to_vec();
    while let Some(p) = waiting.pop() {
        budget::step();
        if p.as_constant().is_some() || basis.contains(&p) {
            continue;
        }
        let shared = basis.iter().enumerate().find_map(|(k, q)| {
            let g = p.gcd(q);
            g.as_constant().is_none().then_some((k, g))
        });
        match shared {
            None => basis.push(p),
            Some((k, g)) => {
                let q = basis.swap_remove(k);
                waiting
                    .extend([&p, &q].into_iter().filter_map(|x| x.div_exact(&g)).map(|x| x.primitive_part()));
                waiting.push(g);
            }
        }
    }
    basis
}

impl Class {
    /// The common term as a person would write it, (1 − t)^k rather than (−1)^k (t − 1)^k.
    pub fn text(&self) -> String {
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for (form, m) in &self.common.factorials {
            let text = if form.as_symbol().is_some() { format!("{form}!") } else { format!("({form})!") };
            let list = if *m > 0 { &mut above } else { &mut below };
            list.extend(std::iter::repeat_n(text, m.unsigned_abs() as usize));
        }
        let mut sign = Linear::default();
        let mut powers = Vec::new();
        for (base, exponent) in &self.common.powers {
            let plain = exponent.as_symbol().is_some() || exponent.as_constant().is_some();
            let exponent_text = if plain { exponent.to_string() } else { format!("({exponent})") };
            let p = base.poly();
            if base.is_sign() {
                sign = sign.plus(exponent);
            } else if let Some(flipped) = flipped(&p) {
                sign = sign.plus(exponent);
                powers.push(format!("({flipped})^{exponent_text}"));
            } else {
                let base = if p.len() > 1 { format!("({p})") } else { p.to_string() };
                powers.push(format!("{base}^{exponent_text}"));
            }
        }
        let sign = parity(&sign);
        if sign != Linear::default() {
            let plain = sign.as_symbol().is_some();
            powers.insert(0, if plain { format!("(-1)^{sign}") } else { format!("(-1)^({sign})") });
        }
        let quotient = match (above.is_empty(), below.len()) {
            (true, 0) => String::new(),
            (no_above, n) => {
                let top = if no_above { "1".to_owned() } else { above.join(" ") };
                match n {
                    0 => top,
                    1 => format!("{top}/{}", below[0]),
                    _ => format!("{top}/({})", below.join(" ")),
                }
            }
        };
        let pieces: Vec<String> = std::iter::once(quotient).filter(|q| !q.is_empty()).chain(powers).collect();
        if pieces.is_empty() { "1".to_owned() } else { pieces.join(" ") }
    }
}

/// 1 − t for t − 1.
fn flipped(p: &MultiPoly) -> Option<String> {
    let terms = p.terms(MonomialOrder::GrLex);
    let [(powers, a), (none, c)] = terms.as_slice() else { return None };
    if !none.is_empty() || !c.is_negative() || a.is_negative() {
        return None;
    }
    let rest = MultiPoly::from_terms([(powers.clone(), a.clone())]);
    Some(format!("{} - {rest}", -c))
}
