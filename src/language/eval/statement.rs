//! One statement: a definition, a claim, or a formula to evaluate.

use super::define::power_or_upper_index;
use super::env::Env;
use super::machine::Machine;
use super::names::name_of;
use super::tools::Tools;
use crate::formula::{Expr, Kind, Rel};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::value::{Value, Verdict};
use crate::math::poly::Symbol;
use num_traits::{One, Zero};

/// What a statement did.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Its value.
    pub value: Value,
    /// The name it defined, if it was a definition.
    pub defined: Option<Symbol>,
    /// Remarks: readings that somebody might not expect.
    pub notes: Vec<Diagnostic>,
}

/// How `=` is understood at the top of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equals {
    /// An unbound name on its left is defined.
    DefinesUnbound,
    /// Always a claim.
    Claims,
}

/// Evaluates one statement and, if it is a definition, adds it to `env`.
///
/// `env` is changed only on success. Limits are those of [`crate::budget::run`] around it.
///
/// # Errors
/// A [`Diagnostic`] with its place.
pub fn evaluate(expr: &Expr, env: &mut Env, equals: Equals, tools: Tools) -> Result<Outcome, Diagnostic> {
    let mut machine = Machine::new(tools).with_names(env);
    let (value, defined) = machine.statement(expr, equals)?;
    if let Some(name) = &defined {
        env.set(name.clone(), value.clone().plain());
    }
    Ok(Outcome { value, defined, notes: machine.notes })
}

impl Machine {
    /// Whether a statement defines a new name.
    pub(crate) fn defines(&mut self, statement: &Expr) -> bool {
        let Kind::Chain(left, links) = &statement.kind else { return false };
        match links[0].rel {
            Rel::Define => true,
            Rel::Eq => links.len() == 1 && self.is_new_definition(left, &links[0].expr),
            _ => false,
        }
    }

    fn statement(&mut self, expr: &Expr, equals: Equals) -> Result<(Value, Option<Symbol>), Diagnostic> {
        if let Kind::Chain(left, links) = &expr.kind {
            let defines = links[0].rel == Rel::Define
                || (equals == Equals::DefinesUnbound
                    && links[0].rel == Rel::Eq
                    && self.is_new_definition(left, &links[0].expr));
            if defines {
                return self.define(left, links).map(|(name, value)| (value, Some(name)));
            }
        }
        self.is_no_prose(expr)?;
        if equals == Equals::DefinesUnbound {
            self.is_no_power_defined(expr)?;
        }
        let value = self.eval_as_written(expr)?;
        if let Kind::Chain(left, links) = &expr.kind
            && let (Kind::Name(name), [link], Equals::DefinesUnbound) = (&left.kind, links.as_slice(), equals)
            && link.rel == Rel::Eq
            && matches!(&value, Value::Claim(claim) if claim.verdict() == Verdict::Refuted)
        {
            let note = Diagnostic::note(Code::BadDefinition, format!("a claim: {name} has a value already"));
            self.note(note.at(left.span).hint(format!("write {name} := ... to give it another")));
        }
        if let Kind::Sequence(items) = &expr.kind {
            self.warn_of_commas(items);
        }
        Ok((value, None))
    }

    /// Nobody claims that b_0^1 is something: without a value for b_0 it is meant as a definition.
    fn is_no_power_defined(&mut self, statement: &Expr) -> Result<(), Diagnostic> {
        let Kind::Chain(left, links) = &statement.kind else { return Ok(()) };
        let (Kind::Pow(base, exponent), [link]) = (&left.kind, links.as_slice()) else { return Ok(()) };
        let Kind::Subscript(letter, _) = &base.kind else { return Ok(()) };
        let trivial = matches!(&exponent.kind, Kind::Number(k) if k.is_zero() || k.is_one());
        let known = |machine: &mut Self, expr: &Expr| {
            name_of(expr, machine).is_none_or(|name| machine.lookup(&name).is_some())
        };
        match name_of(letter, self) {
            Some(name) if link.rel == Rel::Eq && trivial && !known(self, base) && !known(self, letter) => {
                Err(power_or_upper_index(&name, left.span))
            }
            _ => Ok(()),
        }
    }

    /// `1,5` is a list of two numbers; somebody may mean one and a half.
    fn warn_of_commas(&mut self, items: &[Expr]) {
        let touch = |pair: &&[Expr]| {
            pair[0].span.end + 1 == pair[1].span.start
                && ends_in_number(&pair[0])
                && begins_with_number(&pair[1])
        };
        if let Some(pair) = items.windows(2).find(touch) {
            let warning = Diagnostic::warning(Code::BadNumber, "a list of numbers, not one decimal number");
            self.note(
                warning.at(pair[0].span.to(pair[1].span)).hint("decimals are written with a point: 1.5"),
            );
        }
    }
}

fn ends_in_number(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Number(_) => true,
        Kind::Add(terms) => terms.last().is_some_and(|term| ends_in_number(&term.expr)),
        Kind::Mul(factors) => factors.last().is_some_and(ends_in_number),
        Kind::Chain(_, links) => links.last().is_some_and(|link| ends_in_number(&link.expr)),
        _ => false,
    }
}

fn begins_with_number(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Number(_) => true,
        Kind::Add(terms) => terms.first().is_some_and(|term| begins_with_number(&term.expr)),
        Kind::Mul(factors) => factors.first().is_some_and(begins_with_number),
        Kind::Div(above, ..) | Kind::Pow(above, _) => begins_with_number(above),
        Kind::Chain(left, _) => begins_with_number(left),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::syntax;

    /// Without tools there are formulas and definitions, but no functions and no verdicts.
    #[test]
    fn the_evaluator_knows_only_what_it_is_handed() {
        let tools = Tools {
            function: |_| None,
            names: Vec::new,
            synonym: |_| None,
            is_word: |_| false,
            argument_word: |_| false,
            judge: |_, _, _| Ok(Vec::new()),
        };
        let mut env = Env::default();
        let mut run = |text: &str| {
            let statement = syntax::parse(text).unwrap();
            evaluate(&statement, &mut env, Equals::DefinesUnbound, tools)
        };
        run("F(t) := t^2 + 1").unwrap();
        assert_eq!(run("F(3)").unwrap().value.as_int(), Some(10));
        assert_eq!(run("sum(i=1..4, i)").unwrap().value.as_int(), Some(10));
        assert!(run("degree(t^2, t)").is_err());
        let Value::Claim(claim) = run("1 + 1 = 3").unwrap().value else { panic!("not a claim") };
        assert!(claim.judgements.is_empty());
    }
}
