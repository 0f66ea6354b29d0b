//! Doubts about numbers: ranges, rounding, degrees, examples.

use super::Suspect;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::page::context::is_variable;
use crate::judge::page::statement::Role;
use crate::judge::page::topic::Topic;
use crate::judge::values::rounding::last_digit;
use crate::judge::written::names::{bases, walk};
use crate::math::number::Rational;
use num_traits::{One, Signed, Zero};

impl Suspect<'_> {
    /// An inequality holds for some range: it has to be given.
    pub(super) fn inequality_without_range(&self) -> Option<String> {
        if !matches!(self.rel(), Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge) {
            return None;
        }
        if self.statement.role == Some(Role::Introduced) {
            return Some("a condition".to_owned());
        }
        if let Some(name) = self.tally.record.unknown.iter().next() {
            return Some(format!("which values {name} has is not said"));
        }
        let ranged = |name: &str, plain: bool| {
            self.checker.is_restricted(name, &self.statement.place)
                || self.chain.conditions.iter().any(|condition| bases(condition).contains(name))
                || self.chain.universal
                || self.tally.record.unit && plain
        };
        let written = || self.sides().into_iter().flat_map(bases).filter(|name| is_variable(name));
        let free = self.symbols().into_iter().map(|symbol| (symbol.base().to_owned(), symbol.is_plain()));
        if let Some((name, _)) =
            free.chain(written().map(|name| (name, true))).find(|(name, plain)| !ranged(name, *plain))
        {
            return Some(format!("for which {name} it is meant is not said"));
        }
        let integer = self.failure.integers.iter().find(|(name, value)| {
            *value < 2 && !self.chain.conditions.iter().any(|condition| bases(condition).contains(name))
        });
        integer.map(|(name, _)| format!("for which {name} it is meant is not said"))
    }

    /// Numbers that were rounded, or that are counted modulo another.
    pub(super) fn rounded_or_modular(&self) -> Option<String> {
        if self.rel() == Rel::Equiv {
            return Some("it may be a congruence".to_owned());
        }
        let written = self.sides().into_iter().all(|side| bases(side).is_empty());
        if self.statement.role == Some(Role::Introduced)
            && !written
            && self.tally.record.definitions.is_empty()
            && self.tally.record.standard.is_empty()
        {
            return Some("a condition".to_owned());
        }
        if self.statement.topics.has(Topic::Modular) && self.tally.record.standard.is_empty() {
            return Some("it may be meant modulo a number, or in another ring".to_owned());
        }
        // The Legendre symbol of a and p
        let quotient = |side: &Expr| matches!(&side.kind, Kind::Group(inner) if matches!(inner.kind, Kind::Div(..) | Kind::Number(_)));
        if self.sides().into_iter().any(quotient) {
            return Some("the bracket may be a symbol".to_owned());
        }
        if !written {
            return None;
        }
        // 1 + 1 = 0, with a carry
        let digit = |q: &Rational| q.is_zero() || q.is_one();
        if !self.any(&mut |part| matches!(&part.kind, Kind::Number(q) if !digit(q))) {
            return Some("0 and 1 may be truth values or binary digits".to_owned());
        }
        let (Some(left), Some(right)) = (self.failure.left.as_rational(), self.failure.right.as_rational())
        else {
            return None;
        };
        // 125/2 = 62, and 1 is left
        let integer_part = |side: &Expr, value: &Rational, other: &Rational| {
            matches!(&side.kind, Kind::Div(..)) && other.is_integer() && value.floor() == *other
        };
        let [one, other] = self.sides();
        if integer_part(one, &left, &right) || integer_part(other, &right, &left) {
            return Some("it may be a division with remainder".to_owned());
        }
        // As many digits as the side shows.
        let mut finest: Option<Rational> = None;
        for side in self.sides() {
            walk(side, &mut |part| {
                if let Kind::Number(q) = &part.kind
                    && !q.is_integer()
                {
                    let digits = last_digit(q).unwrap_or_else(Rational::zero);
                    finest = Some(finest.take().map_or(digits.clone(), |known| known.max(digits)));
                }
            });
        }
        let near = finest.is_some_and(|digit| {
            let size = right.abs().max(Rational::from_integer(1.into()));
            (left - &right).abs() <= digit * size
        });
        near.then(|| "equal up to rounding".to_owned())
    }
}
