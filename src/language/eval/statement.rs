//! One statement: a definition, a claim, or a formula to evaluate.

use super::env::Env;
use super::machine::Machine;
use super::tools::Tools;
use crate::formula::{Expr, Kind, Rel};
use crate::language::diagnostic::Diagnostic;
use crate::language::value::Value;
use crate::math::poly::Symbol;

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
    let mut machine = Machine::new(tools);
    machine.scope = env.names.clone();
    let (value, defined) = machine.statement(expr, equals)?;
    if let Some(name) = &defined {
        env.set(name.clone(), value.clone());
    }
    Ok(Outcome { value, defined, notes: machine.notes })
}

impl Machine {
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
        self.eval(expr).map(|value| (value, None))
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
