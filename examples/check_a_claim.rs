//! Definitions, a true claim and a wrong one with its reasons.
#![allow(clippy::print_stdout)]

use polarform::session::{Failure, Session};
use polarform::value::{Value, Verdict};

fn main() -> Result<(), Box<Failure>> {
    let mut session = Session::default();
    session.run("F(t) := t^2 + 2t")?;
    session.run("f := polar(F)")?;

    for claim in ["f(t, t) = F(t)", "f(t1, t2) = t1 t2 + 2 (t1 + t2)"] {
        let answer = session.run(claim)?;
        let Value::Claim(verdict) = &answer.outcome.value else {
            unreachable!("an equation of defined names is a claim")
        };
        println!("{claim}: {}", verdict.verdict().word());
        for judgement in verdict.judgements.iter().filter(|j| j.verdict == Verdict::Refuted) {
            for reason in &judgement.reasons {
                println!("  {reason}");
            }
            if let Some(witness) = &judgement.witness {
                println!("  for instance {} on the left, {} on the right", witness.left, witness.right);
            }
        }
    }

    // What cannot be read says where and why, and changes nothing.
    if let Err(failure) = session.run("f(0, 1, 2)") {
        println!("{}: {}", failure.problem.code, failure.problem.message);
    }
    Ok(())
}
