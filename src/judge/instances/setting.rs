//! What surrounds a chain while it is tried: facts, the curve of its sentence, and its share of the steps.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use crate::budget::Limits;
use crate::formula::Expr;
use crate::judge::instances::related::Contacts;
use crate::judge::page::statement::{Chain, Curve, Place};
use crate::judge::written::names::is_range;
use crate::math::number::Rational;

/// Steps for one formula, if nothing else is said.
const STEPS: u64 = 4_000_000;

/// A part of the steps that one formula may take.
pub fn share(limits: &Limits, part: u64) -> u64 {
    limits.steps.unwrap_or(STEPS) / part
}

/// What a chain may rest on.
#[derive(Default)]
pub struct Facts {
    /// Conditions said before, those of the same section first, the latest first.
    pub earlier: Vec<Expr>,
    /// For which indices each of them is said.
    pub ranges: Vec<Vec<Expr>>,
    /// So many of them stand in the same section.
    pub near: usize,
    /// What words say of functions that agree.
    pub contacts: Contacts,
    /// The names in the chain, and those that what is known of these leads to.
    pub reached: BTreeSet<String>,
    /// Letters whose members are knots.
    pub knot_letters: Vec<String>,
    /// The knots that the page gives, by their numbers.
    pub given_knots: Rc<BTreeMap<i64, Rational>>,
}

/// What surrounds a chain.
pub struct Setting<'a> {
    /// The chain.
    pub chain: &'a Chain,
    /// Where it stands.
    pub place: &'a Place,
    /// The curve that its sentence speaks of.
    pub curve: Option<Curve>,
    /// What is known.
    pub facts: Rc<Facts>,
}

impl<'a> Setting<'a> {
    /// The same without the equations among the facts: what is tested may not rest on itself.
    pub(in crate::judge) fn without_equations(&self) -> Setting<'a> {
        let Facts { earlier, reached, knot_letters, given_knots, .. } = &*self.facts;
        let facts = Facts {
            earlier: earlier.iter().filter(|expr| is_range(expr)).cloned().collect(),
            ranges: Vec::new(),
            near: 0,
            contacts: Contacts::default(),
            reached: reached.clone(),
            knot_letters: knot_letters.clone(),
            given_knots: given_knots.clone(),
        };
        Setting { facts: Rc::new(facts), curve: self.curve.clone(), ..*self }
    }
}
