//! Arguments of calls: dots and braces written out, powers as repetitions, vectors.

use super::{Evaluated, Model};
use crate::formula::{Accent, Expr, Kind};
use crate::judge::page::object::Sort;
use crate::judge::written::names::{Head, bases};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Machine;
use crate::language::value::Value;

impl Model {
    /// How many arguments a group is to have, where dots leave that open.
    pub(super) fn arity(&self, head: &Head, stated: Option<usize>, groups: usize) -> Option<usize> {
        if groups == 2 {
            return Some(2);
        }
        let lifted = head.parenthesized
            && matches!(head.upper.as_slice(), [one] if matches!(&one.kind, Kind::Add(terms) if terms.len() == 1));
        stated.or(self.degree).map(|degree| degree + usize::from(lifted))
    }

    /// The values of a list of arguments: with dots and braces written out and powers repeated.
    /// Dots without a count are filled up to `arity`.
    pub(in crate::judge) fn arguments(
        &self,
        machine: &mut Machine,
        items: &[Expr],
        arity: Option<usize>,
        expr: &Expr,
    ) -> Result<Vec<Value>, Diagnostic> {
        // f(0^{n-i} 1^i), f(0^2, t)
        if let Some(values) = self.repeated_by_powers(machine, items, None)? {
            return Ok(values);
        }
        if !items.iter().any(|item| matches!(item.kind, Kind::Ellipsis | Kind::Brace(..))) {
            return items.iter().map(|item| self.argument(machine, item)).collect();
        }
        self.dotted_arguments(machine, items, arity, expr)
    }

    /// The value of an argument: a name that words call a vector is one, and so is a name below an arrow.
    pub(super) fn argument(&self, machine: &mut Machine, item: &Expr) -> Evaluated {
        let value = machine.eval(item)?;
        let vector = || {
            let arrow = matches!(item.kind, Kind::Accent(Accent::Vec, _));
            arrow
                || Head::of(item).is_some_and(|head| {
                    let spoken = self.object(&head).is_some_and(|d| d.object.sort == Sort::Vectors);
                    head.arguments.is_none() && spoken
                })
        };
        match value {
            Value::Scalar(step) if vector() => Ok(Value::Vector(step)),
            value => Ok(value),
        }
    }

    pub(super) fn repeated_by_powers(
        &self,
        machine: &mut Machine,
        items: &[Expr],
        arity: Option<usize>,
    ) -> Result<Option<Vec<Value>>, Diagnostic> {
        let is_product = |item: &Expr| match &item.kind {
            Kind::Mul(factors) => factors.iter().any(|factor| power(factor).is_some()),
            _ => false,
        };
        let factors: Vec<(&Expr, bool)> = items
            .iter()
            .flat_map(|item| match &item.kind {
                Kind::Mul(factors) if is_product(item) => factors.iter().map(|one| (one, false)).collect(),
                _ => vec![(item, true)],
            })
            .collect();
        let number =
            |factor: &Expr| power(factor).is_some_and(|(base, _)| matches!(base.kind, Kind::Number(_)));
        let count = |&(factor, whole): &(&Expr, bool)| match repetition(factor) {
            Some((_, exponent)) => machine.eval_int(exponent).ok(),
            None => (is_single(factor) || whole && power(factor).is_none()).then_some(1),
        };
        // Powers of names are repetitions where that gives the number of arguments, and the powers do not.
        let repeated = factors.iter().any(|(factor, _)| number(factor))
            || arity.is_some_and(|arity| {
                (arity != items.len() || factors.iter().any(|(factor, _)| is_counted(factor)))
                    && factors.iter().map(count).sum::<Option<i64>>() == i64::try_from(arity).ok()
            });
        if !repeated {
            return Ok(None);
        }
        let mut values = Vec::new();
        for (factor, _) in factors {
            values.extend(self.copies(machine, factor)?);
        }
        Ok(Some(values))
    }

    /// The values that an argument stands for: one, or as many as a power says, t^3, (t + h)^{(m)}.
    pub(super) fn copies(&self, machine: &mut Machine, factor: &Expr) -> Result<Vec<Value>, Diagnostic> {
        let Some((base, exponent)) = repetition(factor) else {
            return Ok(vec![self.argument(machine, factor)?]);
        };
        let count = machine.eval_int(exponent)?;
        let count = usize::try_from(count).map_err(|_| {
            Diagnostic::error(Code::Domain, format!("{count} copies make no sense")).at(factor.span)
        })?;
        crate::budget::charge_terms(count as u64);
        let value = self.argument(machine, base)?;
        Ok(vec![value; count])
    }
}

/// An argument and how often it stands: t^3, t^{[3]}, t^{(3)}.
fn power(expr: &Expr) -> Option<(&Expr, &Expr)> {
    match &expr.kind {
        Kind::Pow(base, exponent) => Some((base.as_ref(), exponent.as_ref())),
        Kind::Upper(base, exponents) => match exponents.as_slice() {
            [exponent] => Some((base.as_ref(), exponent)),
            _ => None,
        },
        _ => None,
    }
}

fn is_single(expr: &Expr) -> bool {
    matches!(expr.kind, Kind::Number(_) | Kind::Name(_) | Kind::Accent(..))
}

/// Whether its exponent can only count: nobody writes f(r^{n-i}, s^i) for powers.
pub(super) fn is_counted(factor: &Expr) -> bool {
    let symbolic = power(factor).is_some_and(|(_, exponent)| !bases(exponent).is_empty());
    symbolic || matches!(factor.kind, Kind::Upper(..))
}

/// A power that may be a repetition: t^3, (t + h)^{(m)}.
fn repetition(factor: &Expr) -> Option<(&Expr, &Expr)> {
    power(factor)
        .filter(|(base, _)| is_single(base) || matches!(base.kind, Kind::Group(_)) && is_counted(factor))
}
