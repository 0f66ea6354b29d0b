//! What a query may use: definitions, and conditions on the names of the claim.
//!
//! An equation that defines nothing is solved for one of its names, which then has that value; so
//! `a - b = 0` makes a the same as b. Other conditions are kept: a counterexample counts only where
//! they hold.

use super::argument_reader::Failed;
use crate::formula::Rel;
use crate::formula::source::SourceFile;
use crate::judge::inequality::{decided_in, positive};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Env;
use crate::language::value::{Claim, Judgement, Value, Verdict};
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::{Field, Ring};
use crate::session::{Answer, Failure, Session};
use num_traits::Signed;

/// The conditions that are no equations.
#[derive(Default)]
pub(super) struct Conditions {
    files: Vec<SourceFile>,
    judgements: Vec<Judgement>,
}

/// Runs the definitions, and solves the conditions that are equations.
pub(super) fn give(session: &mut Session, given: &[String]) -> Failed<Conditions> {
    let files: Vec<SourceFile> = given
        .iter()
        .enumerate()
        .map(|(i, text)| SourceFile::new(format!("<given {}>", i + 1), text.as_str()))
        .collect();
    let start = session.env.clone();
    let mut solved: Vec<(Symbol, Fraction)> = Vec::new();
    loop {
        session.env = with(&start, &solved);
        let mut claims = Vec::new();
        for file in &files {
            if run(session, file)?.iter().any(|answer| answer.outcome.defined.is_none()) {
                claims.push(file.clone());
            }
        }
        let (mut found, mut others, mut judgements) = (None, Vec::new(), Vec::new());
        for file in &claims {
            for answer in run(session, file)? {
                let Value::Claim(claim) = &answer.outcome.value else { continue };
                for judgement in claim.judgements.iter().filter(|judgement| !holds(judgement)) {
                    match judgement.rel {
                        Rel::Eq | Rel::Equiv if found.is_none() => {
                            found = Some(solution(judgement).ok_or_else(|| unused(&answer))?);
                        }
                        Rel::Eq | Rel::Equiv => {}
                        _ => {
                            others.push(file.clone());
                            judgements.push(judgement.clone());
                        }
                    }
                }
            }
        }
        match found {
            Some(value) => solved.push(value),
            None => return Ok(Conditions { files: others, judgements }),
        }
    }
}

impl Conditions {
    /// The claim, where conditions hold: a counterexample that they exclude is none.
    pub fn applied(&self, session: &Session, claim: &Claim) -> Claim {
        let judged = |judgement: &Judgement| {
            if !holds(judgement) && self.judgements.iter().any(|condition| follows(judgement, condition)) {
                let reasons = vec!["it follows from a condition".to_owned()];
                return Judgement { verdict: Verdict::Proved, witness: None, reasons, ..judgement.clone() };
            }
            if !holds(judgement)
                && let Some(decided) = decided_in(judgement, &self.judgements)
                && (holds(&decided) || self.allow(session, &decided))
            {
                return decided;
            }
            let open = !holds(judgement) && judgement.witness.is_some();
            if self.files.is_empty() || !open || self.allow(session, judgement) {
                return judgement.clone();
            }
            let reason = "a counterexample was found, but a condition excludes it".to_owned();
            Judgement {
                verdict: Verdict::Undecided,
                witness: None,
                reasons: vec![reason],
                ..judgement.clone()
            }
        };
        Claim { judgements: claim.judgements.iter().map(judged).collect() }
    }

    /// Whether all conditions hold at the counterexample.
    fn allow(&self, session: &Session, judgement: &Judgement) -> bool {
        let Some(witness) = &judgement.witness else { return false };
        let mut there = session.clone();
        for (name, value) in &witness.assignment {
            there.env.set(name.clone(), Value::number(value.clone()));
        }
        self.files.iter().all(|file| {
            run(&mut there, file).is_ok_and(|answers| {
                answers.iter().all(|answer| match &answer.outcome.value {
                    Value::Claim(claim) => claim.decided() == Some(true),
                    _ => true,
                })
            })
        })
    }
}

/// Whether an inequality follows from another one: d = k c + m with k > 0 and m ≥ 0.
fn follows(claim: &Judgement, condition: &Judgement) -> bool {
    let (Some((d, strict)), Some((c, given))) = (positive(claim), positive(condition)) else { return false };
    let Some(name) = c.variables().into_iter().next() else { return false };
    let factor =
        c.derivative(&name).inverse().and_then(|slope| d.derivative(&name).times(&slope).as_rational());
    let Some(factor) = factor.filter(|factor| factor.is_positive()) else { return false };
    d.minus(&c.scaled(&factor))
        .as_rational()
        .is_some_and(|rest| rest.is_positive() || num_traits::Zero::is_zero(&rest) && (given || !strict))
}

fn holds(judgement: &Judgement) -> bool {
    matches!(judgement.verdict, Verdict::Proved | Verdict::Sampled)
}

fn with(start: &Env, solved: &[(Symbol, Fraction)]) -> Env {
    let mut env = start.clone();
    // Later solutions stand in earlier ones.
    let mut values: Vec<(Symbol, Fraction)> = Vec::new();
    for (name, value) in solved {
        for (_, known) in &mut values {
            if let Ok(put_in) = known.substitute(&[(name.clone(), value.clone())]) {
                *known = put_in;
            }
        }
        values.push((name.clone(), value.clone()));
    }
    for (name, value) in values {
        env.set(name, Value::Scalar(value));
    }
    env
}

/// The answers to the statements of a condition or definition.
fn run(session: &mut Session, file: &SourceFile) -> Failed<Vec<Answer>> {
    let mut result = Ok(Vec::new());
    session.run_file(file, |_, answer| match (answer, &mut result) {
        (Ok(answer), Ok(answers)) => {
            answers.push(answer);
            true
        }
        (Err(failure), _) => {
            result = Err(failure);
            false
        }
        _ => false,
    });
    result
}

/// A name with the value that the equation gives it: one that occurs with a number before it.
fn solution(judgement: &Judgement) -> Option<(Symbol, Fraction)> {
    let Some(Value::Scalar(difference)) = &judgement.difference else { return None };
    let equation = difference.numerator();
    equation.variables().iter().find_map(|name| {
        if equation.degree_in(name) != 1 {
            return None;
        }
        let parts = equation.coefficients_in(name);
        let factor = parts.get(1)?.as_constant()?;
        let rest = Fraction::from(parts[0].clone());
        let inverse = Fraction::from(MultiPoly::constant(factor)).inverse()?;
        Some((name.clone(), -(rest.times(&inverse))))
    })
}

/// The error for a condition that cannot be used.
fn unused(answer: &Answer) -> Box<Failure> {
    let problem = Diagnostic::error(Code::Undecided, "this condition cannot be solved for one of its names")
        .at(answer.statement.span)
        .reason("neither a definition nor a linear equation")
        .hint("write it as a definition, for example a := 1 - b");
    Box::new(Failure { problem, file: answer.file.clone() })
}
