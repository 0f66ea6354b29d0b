//! The number that a numeral should have been.
//!
//! **Method.** A numeral is replaced by a symbol; where the difference of the sides is linear in it, one number makes
//! it vanish, or none does.

use super::edits::at_every_node;
use crate::formula::{Expr, Kind, Term};
use crate::judge::check::Checker;
use crate::judge::model::Choices;
use crate::judge::trial::Setting;
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
            let (written, places) = places(node);
            for place in places {
                let mut put = sides.map(Clone::clone);
                put[changed] = rebuild(place(Expr::new(Kind::Name(UNKNOWN.to_owned()), node.span)));
                let outcomes = checker.trial(setting, &[&put[0], &put[1]], &[rel], choices).first(1);
                let failure = outcomes.tallies[0].fails.first();
                let solved = failure.and_then(|failure| solved(&failure.left, &failure.right));
                if let Some(number) = solved.filter(|number| is_like(number, &written)) {
                    let mut number = Expr::number(&number);
                    number.span = node.span;
                    put[changed] = rebuild(place(number));
                    found.push(put.into());
                }
            }
        });
    }
    found
}

/// Where a number may be wrong in a node: a numeral itself, or before a term that has none.
fn places(node: &Expr) -> (Rational, Vec<Box<dyn Fn(Expr) -> Expr + '_>>) {
    match &node.kind {
        Kind::Number(written) => (written.clone(), vec![Box::new(|number| number)]),
        Kind::Add(terms) if terms.len() > 1 => {
            let bare = |term: &Term| {
                !matches!(&term.expr.kind, Kind::Number(_))
                    && !matches!(&term.expr.kind, Kind::Mul(factors) if matches!(factors[0].kind, Kind::Number(_)))
            };
            let places = (0..terms.len()).filter(|at| bare(&terms[*at])).map(|at| {
                let place: Box<dyn Fn(Expr) -> Expr> = Box::new(move |number| {
                    let mut changed = terms.clone();
                    changed[at].expr = Expr::product(vec![number, terms[at].expr.clone()]);
                    Expr::new(Kind::Add(changed), node.span)
                });
                place
            });
            (Rational::one(), places.collect())
        }
        _ => (Rational::one(), Vec::new()),
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
