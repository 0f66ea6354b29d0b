//! Equations between combinations of indexed symbols, coefficient by coefficient.
//!
//! Σ_i w_i b_{i+s} is written Σ_j w_{j−s} b_j, so that in all terms the symbols have the same
//! indices. If then the weights agree for each j, both sides are equal whatever the symbols are.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::Zero;

use super::linear::Linear;
use super::term::{Indexed, Term, add};
use crate::budget;
use crate::math::poly::{Fraction, Index, MonomialOrder, MultiPoly, Symbol};

/// The symbols of a term: their names, the number of their indices, their powers.
pub type Signature = Vec<(String, usize, i32)>;

/// Longer recurrences are not followed.
const MAX_STEPS: i64 = 8;

/// What the family of a symbol is called.
pub fn head(symbol: &Symbol) -> String {
    Symbol::new(symbol.base()).with_accent(symbol.accent()).to_string()
}

/// The weights of each combination of symbols, over common indices.
/// `None` if a symbol occurs in a way that cannot be separated.
pub fn weights(terms: &[Term]) -> Option<BTreeMap<Signature, Vec<Term>>> {
    let mut groups: BTreeMap<Signature, Vec<Term>> = BTreeMap::new();
    for term in numbered(terms)? {
        budget::step();
        let (signature, weight) = aligned(term)?;
        add(groups.entry(signature).or_default(), weight);
    }
    Some(groups)
}

/// The terms with b_0, b_1, … as members of the family where b_i with a letter i occurs.
fn numbered(terms: &[Term]) -> Option<Vec<Term>> {
    let heads: BTreeSet<&String> = terms.iter().flat_map(|t| t.symbols.keys().map(|s| &s.head)).collect();
    let member = |symbol: &Symbol| -> Option<Indexed> {
        let head = head(symbol);
        if symbol.indices().is_empty() || !symbol.upper().is_empty() || !heads.contains(&head) {
            return None;
        }
        let indices = symbol.indices().iter().map(|index| match index {
            Index::Number(i) => Some(Linear::constant(*i)),
            Index::Word(_) => None,
        });
        Some(Indexed { head, indices: indices.collect::<Option<_>>()? })
    };
    let mut result = Vec::new();
    for term in terms {
        let found: Vec<Symbol> =
            term.coefficient.variables().into_iter().filter(|s| member(s).is_some()).collect();
        let in_bases = term.powers.keys().any(|b| b.poly().variables().iter().any(|s| member(s).is_some()));
        let below = found.iter().any(|s| term.coefficient.denominator().variables().contains(s));
        if in_bases || below {
            return None;
        }
        if found.is_empty() {
            result.push(term.clone());
            continue;
        }
        for (powers, c) in term.coefficient.numerator().terms(MonomialOrder::Lex) {
            budget::step();
            let (symbols, rest): (Vec<_>, Vec<_>) = powers.into_iter().partition(|(s, _)| found.contains(s));
            let numerator = MultiPoly::from_terms([(rest, c)]);
            let mut part = Term {
                coefficient: Fraction::new(numerator, term.coefficient.denominator().clone()).ok()?,
                ..term.clone()
            };
            for (symbol, e) in symbols {
                let entry = part.symbols.entry(member(&symbol)?).or_default();
                *entry = entry.checked_add(i32::try_from(e).ok()?)?;
            }
            part.symbols.retain(|_, e| *e != 0);
            add(&mut result, part);
        }
    }
    Some(result)
}

/// The term with its k-th index renamed to the k-th common variable.
fn aligned(term: Term) -> Option<(Signature, Term)> {
    let mut weight = Term { symbols: BTreeMap::new(), ..term.clone() };
    let mut symbols: Vec<(Indexed, i32)> = term.symbols.into_iter().collect();
    symbols.sort_by(|a, b| (&a.0.head, a.1, &a.0.indices).cmp(&(&b.0.head, b.1, &b.0.indices)));
    let mut signature = Vec::new();
    let mut counter = 0;
    for at in 0..symbols.len() {
        signature.push((symbols[at].0.head.clone(), symbols[at].0.indices.len(), symbols[at].1));
        for place in 0..symbols[at].0.indices.len() {
            let form = symbols[at].0.indices[place].clone();
            counter += 1;
            let common = Symbol::new(format!("@{counter}"));
            let j = Linear::symbol(&common);
            let solved =
                weight.bound.iter().find(|u| form.coefficient(u).as_small().is_some_and(|a| a.abs() == 1));
            match solved.cloned() {
                Some(variable) => {
                    // ±u + rest = j
                    let sign = form.coefficient(&variable);
                    let rest = form.substitute(&variable, &Linear::default());
                    let value = j.minus(&rest).scaled(&sign);
                    weight = weight.substitute(&variable, &value)?;
                    for (symbol, _) in &mut symbols[at..] {
                        for index in &mut symbol.indices {
                            *index = index.substitute(&variable, &value);
                        }
                    }
                }
                None => {
                    weight.guards.extend([j.minus(&form), form.minus(&j)]);
                }
            }
        }
    }
    Some((signature, weight))
}

/// e_i(t_1..t_n) = e_i(t_1..t_{n−1}) + t_n e_{i−1}(t_1..t_{n−1}), down to the shortest list in
/// the terms. `None` if the lengths differ by too much.
pub fn shortened(terms: Vec<Term>) -> Option<Vec<Term>> {
    let is_symmetric = |symbol: &Indexed| symbol.head.starts_with("e(") && symbol.indices.len() == 2;
    let mut shortest: BTreeMap<(String, Linear), i64> = BTreeMap::new();
    for symbol in terms.iter().flat_map(|term| term.symbols.keys()).filter(|s| is_symmetric(s)) {
        let offset = symbol.indices[1].offset().as_small()?;
        let entry =
            shortest.entry((symbol.head.clone(), symbol.indices[1].without_offset())).or_insert(offset);
        *entry = offset.min(*entry);
    }
    let mut done = Vec::new();
    let mut waiting = terms;
    while let Some(mut term) = waiting.pop() {
        budget::step();
        if done.len() + waiting.len() > 200 {
            return None;
        }
        let longer = term.symbols.iter().find_map(|(symbol, e)| {
            if !is_symmetric(symbol) {
                return None;
            }
            let least = shortest.get(&(symbol.head.clone(), symbol.indices[1].without_offset()))?;
            let excess = symbol.indices[1].offset().as_small()?.checked_sub(*least)?;
            (excess > 0).then(|| (symbol.clone(), *e, excess))
        });
        let Some((symbol, e, excess)) = longer else {
            for symbol in term.symbols.keys().filter(|s| is_symmetric(s)) {
                let (i, n) = (&symbol.indices[0], &symbol.indices[1]);
                term.guards.extend([i.clone(), n.minus(i)]);
            }
            add(&mut done, term);
            continue;
        };
        if e < 1 || excess > MAX_STEPS {
            return None;
        }
        term.symbols.remove(&symbol);
        if e > 1 {
            term.symbols.insert(symbol.clone(), e - 1);
        }
        let (i, n) = (&symbol.indices[0], &symbol.indices[1]);
        let letter = symbol.head.strip_prefix("e(")?.strip_suffix(')')?.to_owned();
        let shorter = |i: Linear| Indexed { head: symbol.head.clone(), indices: vec![i, n.shifted(-1)] };
        let mut first = term.clone();
        *first.symbols.entry(shorter(i.clone())).or_default() += 1;
        *term.symbols.entry(shorter(i.shifted(-1))).or_default() += 1;
        *term.symbols.entry(Indexed { head: letter, indices: vec![n.clone()] }).or_default() += 1;
        waiting.extend([first, term]);
    }
    done.retain(|term| !term.coefficient.is_zero());
    Some(done)
}
