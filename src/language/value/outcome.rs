//! What comes of a claim.

use super::Value;
use crate::formula::Rel;
use crate::math::number::Rational;
use crate::math::poly::Symbol;

/// The answer to one relation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// An exact identity, for all values of its symbols.
    Proved,
    /// A family in integer names: exact for every instance tried.
    Sampled,
    /// Wrong, with a counterexample.
    Refuted,
    /// Read, but not decidable as it stands.
    Undecided,
}

impl Verdict {
    /// The word used in reports.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Proved => "proved",
            Verdict::Sampled => "sampled",
            Verdict::Refuted => "refuted",
            Verdict::Undecided => "undecided",
        }
    }
}

/// Values of the symbols at which the two sides differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Witness {
    /// The assignment; symbols that do not occur are left out.
    pub assignment: Vec<(Symbol, Rational)>,
    /// Value of the left-hand side there.
    pub left: Rational,
    /// Value of the right-hand side there.
    pub right: Rational,
}

/// One relation of a chain with its verdict.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// The relation sign.
    pub rel: Rel,
    /// Left-hand side.
    pub left: Value,
    /// Right-hand side.
    pub right: Value,
    /// The verdict.
    pub verdict: Verdict,
    /// left − right, if that makes sense and is not zero.
    pub difference: Option<Value>,
    /// A counterexample.
    pub witness: Option<Witness>,
    /// Explanations in words, most important first.
    pub reasons: Vec<String>,
}

/// A chain of relations with their verdicts.
#[derive(Clone, Debug, PartialEq)]
pub struct Claim {
    /// One for each relation sign.
    pub judgements: Vec<Judgement>,
}

impl Claim {
    /// Refuted if any relation is, else undecided if any is, else sampled if any is, else proved.
    pub fn verdict(&self) -> Verdict {
        let any = |verdict| self.judgements.iter().any(|judgement| judgement.verdict == verdict);
        if any(Verdict::Refuted) {
            Verdict::Refuted
        } else if any(Verdict::Undecided) {
            Verdict::Undecided
        } else if any(Verdict::Sampled) {
            Verdict::Sampled
        } else {
            Verdict::Proved
        }
    }
    /// Whether the claim holds as a condition; `None` if that depends on symbols.
    pub fn decided(&self) -> Option<bool> {
        let constant = |j: &Judgement| j.left.as_rational().is_some() && j.right.as_rational().is_some();
        match self.verdict() {
            Verdict::Proved => Some(true),
            Verdict::Refuted if self.judgements.iter().all(constant) => Some(false),
            _ => None,
        }
    }
}
