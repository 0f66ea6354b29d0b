//! The number that a numeral should have been.
//!
//! **Method.** A numeral is replaced by a symbol; where the difference of the sides is linear in it, one number makes
//! it vanish, or none does.

use super::edits::at_every_node;
use crate::formula::{Expr, Kind, Term};
use crate::judge::instances::setting::Setting;
use crate::judge::known::checker::Checker;
use crate::judge::model::Choices;
use crate::language::value::Value;
use crate::math::number::Rational;
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::Ring;
use num_traits::{One, Signed};

/// A letter that no page uses.
const UNKNOWN: &str = "\u{f8ff}";

/// The sides of a relation with one numeral changed, or added to a term, so that its first instance is true. Cost: an instance for each
/// numeral that is no index or exponent, and each term.
pub(super) fn candidates(
    checker: &Checker,
    setting: &Setting,
    at: usize,
    choices: Choices,
) -> Vec<(Expr, Expr)> {
    let chain = setting.chain;
    let sides = [&chain.sides[at].expr, &chain.sides[at + 1].expr];
    let rel = chain.relations[at].0;
    let mut found = Vec::new();
    for (changed, side) in sides.into_iter().enumerate().rev() {
        at_every_node(side, false, &mut |node, in_index, rebuild| {
            if in_index {
                return;
            }
            let written = match &node.kind {
                Kind::Number(written) => written.clone(),
                _ => Rational::one(),
            };
            let unknown = Expr::new(Kind::Name(UNKNOWN.to_owned()), node.span);
            for (place, open) in with_number(node, &unknown).into_iter().enumerate() {
                let mut put = sides.map(Clone::clone);
                put[changed] = rebuild(open);
                let outcomes = checker.trial(setting, &[&put[0], &put[1]], &[rel], choices).first(1);
                let failure = outcomes.tallies[0].fails.first();
                let solved = failure.and_then(|failure| solved(&failure.left, &failure.right));
                if let Some(number) = solved.filter(|number| is_like(number, &written)) {
                    let mut number = Expr::number(&number);
                    number.span = node.span;
                    put[changed] = rebuild(with_number(node, &number).swap_remove(place));
                    found.push(put.into());
                }
            }
        });
    }
    found
}

/// The node with a number where one may be wrong: in the place of a numeral, or before a term that has none.
fn with_number(node: &Expr, number: &Expr) -> Vec<Expr> {
    let has_number = |term: &Term| match &term.expr.kind {
        Kind::Number(_) => true,
        Kind::Mul(factors) => matches!(factors[0].kind, Kind::Number(_)),
        _ => false,
    };
    match &node.kind {
        Kind::Number(_) => vec![number.clone()],
        Kind::Add(terms) if terms.len() > 1 => {
            let bare = (0..terms.len()).filter(|at| !has_number(&terms[*at]));
            bare.map(|at| {
                let mut changed = terms.clone();
                changed[at].expr = Expr::product(vec![number.clone(), terms[at].expr.clone()]);
                Expr::new(Kind::Add(changed), node.span)
            })
            .collect()
        }
        _ => Vec::new(),
    }
}

/// The number for which the sides are equal.
fn solved(left: &Value, right: &Value) -> Option<Rational> {
    let (left, right) = (left.as_scalar()?, right.as_scalar()?);
    // Between numbers there is always one.
    if left.variables().len().max(right.variables().len()) < 2 {
        return None;
    }
    let difference = left.minus(right);
    let coefficients = difference.numerator().coefficients_in(&Symbol::new(UNKNOWN));
    let [constant, slope] = coefficients.as_slice() else { return None };
    Fraction::new(-constant.clone(), slope.clone()).ok()?.as_rational()
}

/// Whether a number may have been meant by another: not 0, of the same sign, and as simple.
fn is_like(number: &Rational, written: &Rational) -> bool {
    let size = |q: &Rational| q.numer().bits() + q.denom().bits();
    number.is_positive() && size(number) <= size(written) + 3
}
