//! What speaks for a relation that fails being wrong.
//!
//! A misreading makes any formula false, and leaves it far from every truth. A slip leaves it one small change away
//! from one. So a relation is wrong if a small edit of it is true, or if it speaks of what the field or the page
//! determines: Bernstein polynomials, B-splines, the polar form of a given polynomial. For everything else that fails
//! the likelier cause is that it was not read as it was meant.

use super::Suspect;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::context::Definition;
use crate::judge::names::{bases, walk};
use crate::judge::repair::Repair;
use crate::language::value::Value;
use crate::math::poly::{MonomialOrder, Symbol};

impl Suspect<'_> {
    /// Why nothing shows that it is wrong, with the repair found.
    pub(in crate::judge) fn unfounded(&self, repair: Option<&Repair>) -> Option<String> {
        let here = self.tally.record.definitions.iter().all(|(_, near)| *near);
        let near = repair.is_some_and(|repair| repair.near) && (here || self.claimed());
        let founded = near
            || self.chain.universal
            || self.is_of_the_field()
            || self.is_closed()
            || self.is_calculation()
            || self.agrees_in_part();
        (!founded).then(|| {
            "it fails as it is read, and so does all that is near it: it may mean something else".to_owned()
        })
    }

    /// Whether it speaks of what has a meaning for everybody here, or of all members of a family of functions that
    /// the page defines.
    fn is_of_the_field(&self) -> bool {
        let record = &self.tally.record;
        let family = |definition: &Definition| {
            let head = &definition.head;
            head.arguments.is_some()
                && !(head.lower.is_empty() && head.upper.is_empty())
                && !head.lower.iter().chain(&head.upper).all(|index| matches!(index.kind, Kind::Number(_)))
        };
        !record.standard.is_empty()
            || !record.paired.is_empty()
            || !self.failure.integers.is_empty() && record.unknown.is_empty() && self.used().any(family)
    }

    /// Whether no name in it needs a meaning, and it is no equation: a sum or an integral in closed form, an inequality
    /// on a range.
    fn is_closed(&self) -> bool {
        let record = &self.tally.record;
        let operator = self
            .any(&mut |part| matches!(part.kind, Kind::Big { .. } | Kind::Integral { upper: Some(_), .. }));
        let whole = record.definitions.is_empty() && record.unknown.is_empty() && record.generic.is_empty();
        let order = matches!(self.rel(), Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge);
        let ranged = order
            && self.failure.integers.iter().all(|(name, _)| {
                self.chain.conditions.iter().any(|condition| bases(condition).contains(name))
            });
        let ranged = ranged && !(self.failure.integers.is_empty() && self.are_numbers());
        whole && (ranged || operator && self.failure.inner && self.symbols().iter().all(Symbol::is_plain))
    }

    /// Whether it calculates with numbers, and is said to follow; or has no solution, as x = x + 1.
    fn is_calculation(&self) -> bool {
        let [left, right] = self.sides();
        let literal = |side: &Expr| matches!(side.kind, Kind::Number(_));
        let numbers = self.sides().iter().all(|side| bases(side).is_empty());
        let circular = self.is_constant_apart() && contains(right, left);
        self.claimed() && numbers && !(literal(left) && literal(right)) || circular && !bases(left).is_empty()
    }

    /// Whether the sides are polynomials in the same names that agree in half of their terms.
    fn agrees_in_part(&self) -> bool {
        let (Value::Scalar(left), Value::Scalar(right)) = (&self.failure.left, &self.failure.right) else {
            return false;
        };
        let (Some(left), Some(right)) = (left.as_polynomial(), right.as_polynomial()) else { return false };
        let (own, others) = (left.terms(MonomialOrder::Lex), right.terms(MonomialOrder::Lex));
        let common = own.iter().filter(|term| others.contains(term)).count();
        self.tally.record.definitions.is_empty()
            && self.tally.record.unknown.is_empty()
            && self.is_equation()
            && left.variables() == right.variables()
            && common > 1
            && 2 * common >= own.len().max(others.len())
    }
}

/// Whether a formula is a part of another one.
fn contains(whole: &Expr, sought: &Expr) -> bool {
    let mut found = false;
    walk(whole, &mut |part| found |= part.same_as(sought));
    found
}
