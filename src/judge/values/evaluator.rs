//! Evaluators with all they are handed: the functions of the program, and this judge.

use std::rc::Rc;

use crate::formula::{Expr, Link};
use crate::judge::values::claim::judge_plainly;
use crate::judge::values::family::{counts_divisors, judge_family, may_be_family, of_integers};
use crate::language::diagnostic::Diagnostic;
use crate::language::eval::{self, Env, Equals, Machine, Outcome, Reading, Tools};
use crate::language::functions;
use crate::language::value::{Judgement, Value};
use crate::math::number::Rational;
use crate::math::poly::Symbol;

/// The functions of the program and the judge of claims.
const TOOLS: Tools = Tools {
    function: functions::callable,
    names: functions::names,
    alias: functions::alias,
    synonym: functions::synonym,
    is_word: functions::is_word,
    argument_word: functions::is_argument_word,
    judge,
};

/// An evaluator that knows no names yet.
pub fn machine() -> Machine {
    Machine::new(TOOLS)
}

/// An evaluator that knows the given names.
pub fn machine_in(env: &Env) -> Machine {
    Machine::new(TOOLS).with_names(env)
}

/// Evaluates one statement and, if it is a definition, adds it to `env`, which is changed only on
/// success.
///
/// # Errors
/// A [`Diagnostic`] with its place.
pub fn evaluate(expr: &Expr, env: &mut Env, equals: Equals) -> Result<Outcome, Diagnostic> {
    eval::evaluate(expr, env, equals, TOOLS)
}

/// The value of a formula under a reading, with some names bound.
///
/// # Errors
/// A [`Diagnostic`] with its place.
pub fn evaluate_reading(
    expr: &Expr,
    reading: Rc<dyn Reading>,
    names: impl IntoIterator<Item = (Symbol, Value)>,
) -> Result<Value, Diagnostic> {
    machine().with_reading(reading).with_locals(names, |machine| machine.eval(expr))
}

/// The number that a formula without names of the page is.
pub fn number(expr: &Expr) -> Option<Rational> {
    machine().eval(expr).ok()?.as_rational()
}

/// Judges each relation of a chain; a chain with integer names without values by its instances.
fn judge(machine: &mut Machine, first: &Expr, links: &[Link]) -> Result<Vec<Judgement>, Diagnostic> {
    match judge_plainly(machine, first, links) {
        Err(error) if may_be_family(&error) => judge_family(machine, first, links).ok_or(error),
        Ok(judgements) if counts_divisors(first, links) => Ok(of_integers(machine, first, links, judgements)),
        result => result,
    }
}
