//! Limits of rational functions.

use super::machine::{Evaluated, Machine};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Rel};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::errors::unsupported;
use crate::language::value::Value;
use crate::math::poly::{Fraction, MultiPoly};
use crate::math::ring::Field;
use num_traits::Zero;

impl Machine {
    /// The limit of a rational function: its value, once what numerator and denominator have in common is gone; at
    /// infinity the value of F(1/s) at s = 0.
    ///
    /// # Errors
    /// There is no finite limit, or the body is no rational function of the name.
    pub(super) fn eval_limit(&mut self, lower: &[Expr], body: &Expr, span: Span) -> Evaluated {
        let approach = match lower {
            [Expr { kind: Kind::Chain(name, links), .. }] => match links.as_slice() {
                [Link { rel: Rel::To | Rel::Implies, expr, .. }] if !self.has_reading() => Some((name, expr)),
                _ => None,
            },
            _ => None,
        };
        let approach = approach.map(|(name, goal)| (name, from_a_side(goal)));
        let Some((name, goal)) = approach else {
            return Err(unsupported("this limit has no value here").at(span));
        };
        let name = self.binder(name)?;
        let Some(formula) = self.formula_in(&name, body) else {
            return Err(unsupported("only limits of rational functions are known")
                .at(body.span)
                .hint("write the formula whose limit is taken with +, -, *, / and powers of numbers"));
        };
        let (formula, goal) = match is_infinite(goal) {
            true => {
                let symbol = Fraction::from(MultiPoly::symbol(name.clone()));
                let turned =
                    symbol.inverse().and_then(|inverse| formula.substitute(&[(name.clone(), inverse)]).ok());
                (turned, Fraction::zero())
            }
            false => (Some(formula), self.eval_scalar(goal)?),
        };
        let value = formula.and_then(|formula| formula.substitute(&[(name, goal)]).ok());
        value
            .map(Value::Scalar)
            .ok_or_else(|| {
                Diagnostic::error(Code::DivisionByZero, "there is no finite limit")
                    .reason("the denominator is 0 there")
            })
            .at(body.span)
    }
}

/// a for a^+ and a^-: where a rational function has a limit, it is that from each side.
fn from_a_side(goal: &Expr) -> &Expr {
    match &goal.kind {
        Kind::Pow(base, side) if matches!(&side.kind, Kind::Name(name) if name == "plus" || name == "minus") => {
            base
        }
        _ => goal,
    }
}

/// ∞, +∞ or −∞.
fn is_infinite(goal: &Expr) -> bool {
    match &goal.kind {
        Kind::Name(name) => name == "infty",
        Kind::Group(inner) => is_infinite(inner),
        Kind::Add(terms) => matches!(terms.as_slice(), [term] if is_infinite(&term.expr)),
        _ => false,
    }
}
