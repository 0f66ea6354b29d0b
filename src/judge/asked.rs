//! A claim asked by itself is a page of one formula: what its values leave open, the judge of pages may decide, so
//! that a claim has one verdict wherever it is asked.

use std::sync::Arc;

use super::check::Checker;
use super::family::may_be_family;
use super::finding::{self, Finding};
use super::names::bases;
use super::statement::{Chain, Place, Role, Said, Side, Statement};
use crate::budget::{self, Limits};
use crate::formula::source::SourceFile;
use crate::formula::{Expr, Kind, Link};
use crate::language::diagnostic::Diagnostic;
use crate::language::eval::{Env, Outcome};
use crate::language::value::{Claim, Judgement, Value, Verdict};
use crate::language::write;
use crate::math::poly::Symbol;

/// The outcome of a statement, with the verdicts that a page would give where its values decide nothing. Names with
/// a value in the session are not those of a page.
pub(crate) fn refined(
    statement: &Expr,
    env: &Env,
    outcome: Result<Outcome, Diagnostic>,
) -> Result<Outcome, Diagnostic> {
    let Kind::Chain(first, links) = &statement.kind else { return outcome };
    let outcome = outcome.map(|outcome| match env.get(&Symbol::new(PI)) {
        None => without_numbers_as_letters(outcome, first, links),
        Some(_) => outcome,
    });
    if bases(statement).iter().any(|base| env.get(&Symbol::new(base)).is_some()) {
        return outcome;
    }
    match outcome {
        Ok(Outcome { value: Value::Claim(claim), defined: None, notes })
            if claim.judgements.iter().any(is_open) =>
        {
            let findings = findings(statement, &[]);
            let judged = claim.judgements.iter().zip(&findings).map(|(judgement, finding)| {
                match verdict(finding).filter(|_| is_open(judgement)) {
                    Some(verdict @ (Verdict::Proved | Verdict::Sampled)) => {
                        Judgement { verdict, reasons: reasons(finding), witness: None, ..judgement.clone() }
                    }
                    _ => judgement.clone(),
                }
            });
            let same = findings.len() == claim.judgements.len();
            let claim = if same { Arc::new(Claim { judgements: judged.collect() }) } else { claim.clone() };
            Ok(Outcome { value: Value::Claim(claim), defined: None, notes })
        }
        Err(error) if may_be_family(&error) || has_dots(statement) => {
            let findings = findings(statement, &[]);
            let side = |expr: &Expr| Value::Text(write::text(expr));
            let lefts = std::iter::once(first.as_ref()).chain(links.iter().map(|link| &link.expr));
            let judged: Option<Vec<Judgement>> = findings
                .iter()
                .zip(lefts.zip(links))
                .map(|(finding, (left, link))| {
                    Some(Judgement {
                        rel: link.rel,
                        left: side(left),
                        right: side(&link.expr),
                        verdict: verdict(finding)?,
                        difference: None,
                        witness: None,
                        reasons: reasons(finding),
                    })
                })
                .collect();
            match judged.filter(|judgements| judgements.len() == links.len()) {
                Some(judgements) => {
                    let value = Value::Claim(Arc::new(Claim { judgements }));
                    Ok(Outcome { value, defined: None, notes: Vec::new() })
                }
                None => Err(error),
            }
        }
        outcome => outcome,
    }
}

/// The verdicts on a claim under conditions, with those that a page would give where the others are open.
pub(crate) fn under_conditions(statement: &Expr, conditions: &[Expr], env: &Env, claim: Claim) -> Claim {
    let named = std::iter::once(statement).chain(conditions).flat_map(bases);
    let defined = named.into_iter().any(|base| env.get(&Symbol::new(base)).is_some());
    if defined || conditions.is_empty() || !claim.judgements.iter().any(is_open) {
        return claim;
    }
    let findings = findings(statement, conditions);
    if findings.len() != claim.judgements.len() {
        return claim;
    }
    let judged =
        claim.judgements.into_iter().zip(&findings).map(|(judgement, finding)| match verdict(finding) {
            Some(verdict @ (Verdict::Proved | Verdict::Sampled)) if is_open(&judgement) => {
                Judgement { verdict, reasons: reasons(finding), witness: None, ..judgement }
            }
            _ => judgement,
        });
    Claim { judgements: judged.collect() }
}

/// π is a number: a claim that fails for some value of the letter is not refuted.
fn without_numbers_as_letters(mut outcome: Outcome, first: &Expr, links: &[Link]) -> Outcome {
    let Value::Claim(claim) = &outcome.value else { return outcome };
    let sides: Vec<bool> =
        std::iter::once(first).chain(links.iter().map(|link| &link.expr)).map(names_pi).collect();
    if claim.judgements.len() != links.len() {
        return outcome;
    }
    let judged =
        claim.judgements.iter().zip(sides.windows(2)).map(|(judgement, about_pi)| match judgement.verdict {
            Verdict::Refuted if about_pi.contains(&true) => Judgement {
                verdict: Verdict::Undecided,
                difference: None,
                witness: None,
                reasons: vec!["pi is read as a letter, not as the number".to_owned()],
                ..judgement.clone()
            },
            _ => judgement.clone(),
        });
    outcome.value = Value::Claim(Arc::new(Claim { judgements: judged.collect() }));
    outcome
}

const PI: &str = "pi";

fn names_pi(expr: &Expr) -> bool {
    bases(expr).iter().any(|base| base == PI)
}

/// 1 + 2 + ⋯ + n
fn has_dots(expr: &Expr) -> bool {
    let mut found = expr.kind == Kind::Ellipsis;
    expr.for_each_child(&mut |child| found = found || has_dots(child));
    found
}

fn is_open(judgement: &Judgement) -> bool {
    matches!(judgement.verdict, Verdict::Sampled | Verdict::Undecided)
}

fn verdict(finding: &Finding) -> Option<Verdict> {
    match finding.verdict {
        finding::Verdict::Proved => Some(Verdict::Proved),
        finding::Verdict::Sampled => Some(Verdict::Sampled),
        finding::Verdict::Refuted => Some(Verdict::Refuted),
        _ => None,
    }
}

fn reasons(finding: &Finding) -> Vec<String> {
    [&finding.reason, &finding.instances, &finding.witness].into_iter().flatten().cloned().collect()
}

/// What a page would say of a claim under conditions.
fn findings(claim: &Expr, conditions: &[Expr]) -> Vec<Finding> {
    let Kind::Chain(first, links) = &claim.kind else { return Vec::new() };
    let side = |expr: &Expr| Side { expr: expr.clone(), latex: write::latex(expr) };
    let sides = std::iter::once(first.as_ref()).chain(links.iter().map(|link| &link.expr));
    let relations = links.iter().map(|link| (link.rel, link.span)).collect();
    let chain = Chain {
        universal: conditions.is_empty(),
        conditions: conditions.to_vec(),
        ..Chain::new(sides.map(side).collect(), relations)
    };
    let place = Place { scope: Vec::new(), group: 0, formula: 1, blocks: Vec::new(), recalled: None };
    let statement = Statement { role: Some(Role::Claimed), ..Statement::new(Said::Chain(chain), place) };
    let limits = Limits { steps: Some(STEPS), ..Limits::default() };
    let mut checker = Checker::new(&SourceFile::new("", ""), &limits, std::slice::from_ref(&statement));
    match budget::run(&limits, || checker.statement(&statement)) {
        Ok(()) => checker.findings,
        Err(_) => Vec::new(),
    }
}

/// Steps for the second look: as for a formula of a page.
const STEPS: u64 = 4_000_000;
