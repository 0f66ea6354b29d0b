//! Proofs of identities in symbolic integers n, i, k, …
//!
//! [`prove`] says whether an equation such as `B_i^n(t) = (1-t) B_i^{n-1}(t) + t B_{i-1}^{n-1}(t)`
//! holds for *all* integers in the natural range. A proof is a proof: nothing is sampled.
//!
//! **What is proved.** Integers are the names in indices, binomials, factorials, exponents and
//! bounds of sums; they are ≥ 0. The upper entries of binomials, degrees of Bernstein
//! polynomials and arguments of factorials are ≥ 0 as far as they do not depend on variables of
//! sums. For all such integers for which both sides have a value they are equal, as rational
//! functions of the other letters. Binomials and Bernstein polynomials are 0 when the lower
//! entry is out of range, an empty sum is 0, 0^0 is 1. Where that fails, it is tried
//! - for 0 ≤ i ≤ n for each binomial C(n, i) or B_i^n with a single letter i that is in no upper
//!   entry, and
//! - for b ≥ a − 1 for each sum from a to b where a is not a number,
//!
//! and the reason says so ("…; for 0 ≤ i ≤ n"). An equation that has a value only where, say,
//! n = k is not proved. Indexed symbols and functions that nobody defines may have any values;
//! products of capitals or of letters with an accent are refused, for they may be matrices or
//! vectors.
//!
//! **How.** Some equations follow from two simpler ones (`order`). Otherwise the difference of
//! the sides becomes a sum of hypergeometric terms (`read`, `term`), is split by the indexed
//! symbols in it (`families`), sums are evaluated (`summation`) or compared (`induction`), and
//! what is left vanishes class by class (`classes`) in every case (`decide`).
//!
//! Reference: Petkovšek, Wilf, Zeilberger, *A = B*, A K Peters 1996.

mod calculus;
mod classes;
mod context;
mod decide;
mod families;
mod induction;
mod known;
mod linear;
mod names;
mod order;
mod ranges;
mod read;
mod summation;
mod term;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;

use num_traits::{One, Zero};

use crate::formula::Expr;
use crate::math::poly::{Fraction, MonomialOrder, Symbol};
use context::Context;
use decide::{Decision, Step};
use linear::Linear;
use read::Reader;
use term::{Term, collected};

/// Why an identity holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Proof {
    /// A sentence for a lecturer.
    pub reason: String,
}

/// Proves left = right for all integers in the natural range (see the head of the module), or
/// says nothing: `None` means "not proved", never "false".
///
/// `lookup` is asked first for names, indexed names and calls; it returns what they stand for,
/// with the arguments put in. What it does not know has its standard meaning (B_i^n, C(n, k),
/// σ_{i,n}, Δ) or is an independent symbol.
///
/// Cost: milliseconds for the identities of lecture notes; the budget of the caller is respected.
///
/// ```
/// use polarform::expr::Kind;
/// use polarform::latex;
/// use polarform::judge::prove::prove;
/// let sides = |text: &str| match latex::read(text).unwrap().kind {
///     Kind::Chain(left, mut links) => (*left, links.remove(0).expr),
///     _ => unreachable!(),
/// };
/// let (left, right) = sides(r"B_i^n(t) = (1-t) B_i^{n-1}(t) + t B_{i-1}^{n-1}(t)");
/// assert!(prove(&left, &right, &|_| None).is_some());
/// let (left, right) = sides(r"B_i^n(t) = (1-t) B_i^{n-1}(t) + t B_{i+1}^{n-1}(t)");
/// assert!(prove(&left, &right, &|_| None).is_none());
/// ```
pub fn prove(left: &Expr, right: &Expr, lookup: &dyn Fn(&Expr) -> Option<Expr>) -> Option<Proof> {
    for (left, right) in [(left, right), (right, left)] {
        if let Some(found) = order::equations(left, right, lookup) {
            let shown = [&found.start, &found.step].into_iter().all(|(left, right)| {
                Equation::read(left, right, lookup).is_some_and(|equation| equation.holds_widely().is_some())
            });
            return shown.then(|| Proof { reason: found.reason.to_owned() });
        }
    }
    Equation::read(left, right, lookup)?.proof()
}

/// An equation as the difference of its sides, with what it takes for granted.
struct Equation {
    difference: Vec<Term>,
    domain: Context,
    ranges: Vec<(Symbol, Linear)>,
    lengths: Vec<Linear>,
    symmetric: bool,
}

impl Equation {
    fn read(left: &Expr, right: &Expr, lookup: read::Lookup<'_>) -> Option<Self> {
        // A first reading finds out which names are integers: n (n−1) is a product then.
        let mut first = reader(left, right, lookup);
        let _ = (first.read(left), first.read(right));
        let mut reader = reader(left, right, lookup);
        reader.expected = first.integers;
        let (left, right) = (reader.read(left)?, reader.read(right)?);
        let mixed = reader.reals.intersection(&reader.integers).next().is_some();
        if mixed || !left.iter().chain(&right).all(|term| commutes(term, &reader.integers)) {
            return None;
        }
        let minus = -Fraction::one();
        let difference = collected(left.into_iter().chain(right.iter().map(|term| term.scaled(&minus))));
        let domain = reader.known();
        let ranges = natural_ranges(&reader);
        let lengths = reader.lengths.into_iter().filter(|length| !domain.entails(length)).collect();
        Some(Equation { difference, domain, ranges, lengths, symmetric: reader.symmetric })
    }

    /// What was used, if the equation holds for all integers for which it has a value.
    fn holds_widely(&self) -> Option<BTreeSet<Step>> {
        holds(&self.difference, &self.domain, self.symmetric)
    }

    fn proof(&self) -> Option<Proof> {
        if let Some(steps) = self.holds_widely() {
            return Some(Proof { reason: reason(&self.difference, &steps, &[]) });
        }
        if self.ranges.is_empty() && self.lengths.is_empty() {
            return None;
        }
        let mut narrow = self.domain.clone();
        self.ranges.iter().for_each(|(i, n)| narrow.assume(&n.minus(&Linear::symbol(i))));
        self.lengths.iter().for_each(|length| narrow.assume(length));
        let steps = holds(&self.difference, &narrow, self.symmetric)?;
        let ranges = self.ranges.iter().map(|(i, n)| format!("0 ≤ {i} ≤ {n}"));
        let lengths = self.lengths.iter().map(|length| format!("{length} ≥ 0"));
        let conditions: Vec<String> = ranges.chain(lengths).collect();
        Some(Proof { reason: reason(&self.difference, &steps, &conditions) })
    }
}

fn reader<'a>(left: &Expr, right: &Expr, lookup: read::Lookup<'a>) -> Reader<'a> {
    let mut reader = Reader::new(lookup);
    reader.names.scan(left);
    reader.names.scan(right);
    reader
}

/// Whether the sum of the terms is 0 throughout the context, which must not be empty.
fn holds(difference: &[Term], context: &Context, symmetric: bool) -> Option<BTreeSet<Step>> {
    let mut decision = Decision::default();
    let mut sensible = context.clone();
    for term in difference.iter().filter(|t| t.guards.is_empty() && t.bound.is_empty()) {
        term.defined.iter().for_each(|fact| sensible.assume(fact));
    }
    // An equation that has a value for n = k only does not say what was meant.
    if sensible.is_impossible() || sensible.forced().is_some() {
        return None;
    }
    let mut terms = difference.to_vec();
    if symmetric {
        decision.steps.insert(Step::Symmetric);
        terms = families::shortened(terms)?;
    }
    let groups = families::weights(&terms)?;
    if groups.keys().any(|signature| !signature.is_empty()) {
        decision.steps.insert(Step::Coefficients);
    }
    groups.values().all(|weights| decision.vanishes(weights, context)).then_some(decision.steps)
}

/// Whether the term holds at most one symbol that may be a matrix or a vector, as a factor.
fn commutes(term: &Term, integers: &BTreeSet<Symbol>) -> bool {
    let special =
        |symbol: &Symbol| !integers.contains(symbol) && names::may_be_matrix(&families::head(symbol));
    let in_bases = term.powers.keys().any(|base| base.poly().variables().iter().any(special));
    let below = term.coefficient.denominator().variables().iter().any(special);
    let indexed: i64 = term
        .symbols
        .iter()
        .filter(|(symbol, _)| names::may_be_matrix(&symbol.head))
        .map(|(_, e)| if *e < 0 { 2 } else { i64::from(*e) })
        .sum();
    let degree = |powers: &crate::math::poly::Powers| -> i64 {
        powers.iter().filter(|(symbol, _)| special(symbol)).map(|(_, e)| i64::from(*e)).sum()
    };
    let terms = term.coefficient.numerator().terms(MonomialOrder::Lex);
    !in_bases && !below && terms.iter().all(|(powers, _)| degree(powers) + indexed <= 1)
}

/// For each index the weakest of its ranges, if they can be compared.
fn natural_ranges(reader: &Reader<'_>) -> Vec<(Symbol, Linear)> {
    let mut ranges: Vec<(Symbol, Linear)> = Vec::new();
    let mut doubtful: BTreeSet<&Symbol> = BTreeSet::new();
    for (i, n) in &reader.natural {
        match ranges.iter_mut().find(|(other, _)| other == i) {
            None => ranges.push((i.clone(), n.clone())),
            Some((_, other)) => match n.minus(other).as_constant() {
                Some(difference) if *difference > crate::math::number::Int::ZERO => *other = n.clone(),
                Some(_) => {}
                None => {
                    doubtful.insert(i);
                }
            },
        }
    }
    // C(n−i, n), written by mistake, does not mean that i is 0.
    ranges.retain(|(i, _)| !doubtful.contains(i) && !reader.uppers.contains(i));
    ranges
}

/// The sentence that explains a proof.
fn reason(difference: &[Term], steps: &BTreeSet<Step>, conditions: &[String]) -> String {
    let mut parts: Vec<String> = Vec::new();
    if steps.contains(&Step::Coefficients) {
        parts.push("both sides have the same coefficients".to_owned());
    }
    if steps.contains(&Step::Symmetric) {
        parts.push("by the recurrence of elementary symmetric functions".to_owned());
    }
    if steps.contains(&Step::BinomialTheorem) {
        parts.push("by the binomial theorem".to_owned());
    }
    if steps.contains(&Step::Vandermonde) {
        parts.push("by Vandermonde's identity".to_owned());
    }
    if steps.contains(&Step::PowerSum) {
        parts.push("by summing powers".to_owned());
    }
    if steps.contains(&Step::TermByTerm) {
        parts.push("the sums agree term by term".to_owned());
    }
    if steps.contains(&Step::Induction) {
        parts.push("by induction on the upper bound".to_owned());
    }
    if parts.is_empty() {
        parts.push(match classes::classes(difference).as_deref() {
            Some([class]) if class.coefficient.is_zero() && class.text() != "1" => {
                format!("divided by {}, both sides are the same rational function", class.text())
            }
            _ => "both sides are the same after cancelling factorials and powers".to_owned(),
        });
    }
    if steps.contains(&Step::Cases) {
        parts.push("the boundary cases looked at one by one".to_owned());
    }
    let mut text = parts.join(", ");
    if !conditions.is_empty() {
        text.push_str(&format!("; for {}", conditions.join(", ")));
    }
    text
}
