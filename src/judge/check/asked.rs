//! A claim asked by itself is a page of one formula: what its values leave open, the judge of pages may decide, so
//! that a claim has one verdict wherever it is asked.

use std::sync::Arc;

use crate::budget::{self, Limits};
use crate::formula::source::SourceFile;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::known::checker::Checker;
use crate::judge::page::finding::{self, Finding};
use crate::judge::page::statement::{Chain, Layout, Place, Role, Said, Side, Statement};
use crate::judge::values::family::may_be_family;
use crate::judge::written::names::bases;
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
    let Kind::Chain(_, links) = &statement.kind else { return outcome };
    let outcome = outcome.map(|outcome| match env.get(&Symbol::new(PI)) {
        None => without_numbers_as_letters(outcome, statement),
        Some(_) => outcome,
    });
    if bases(statement).iter().any(|base| env.get(&Symbol::new(base)).is_some()) {
        return outcome;
    }
    match outcome {
        Ok(Outcome { value: Value::Claim(claim), defined: None, notes, fails: false })
            if claim.judgements.iter().any(is_open) =>
        {
            let findings = findings(statement, &[]);
            let claim = match findings.len() == claim.judgements.len() {
                true => Arc::new(looked_at_again(&claim, &findings, statement)),
                false => claim,
            };
            Ok(Outcome { value: Value::Claim(claim), defined: None, notes, fails: false })
        }
        Err(error) if may_be_family(&error) || has_dots(statement) => {
            let findings = findings(statement, &[]);
            let sides = sides(statement);
            let judged = findings.iter().zip(sides.windows(2)).zip(links);
            let judged: Option<Vec<Judgement>> = judged
                .map(|((finding, sides), link)| {
                    Some(asked(link.rel, verdict(finding)?, finding, [sides[0], sides[1]]))
                })
                .collect();
            match judged.filter(|judgements| judgements.len() == links.len()) {
                Some(judgements) => {
                    let value = Value::Claim(Arc::new(Claim { judgements }));
                    Ok(Outcome { value, defined: None, notes: Vec::new(), fails: false })
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
    looked_at_again(&claim, &findings, statement)
}

/// The judgements of a claim, with what a page says where they are open.
fn looked_at_again(claim: &Claim, findings: &[Finding], statement: &Expr) -> Claim {
    let sides = sides(statement);
    let judged = claim.judgements.iter().zip(findings).zip(sides.windows(2));
    let judged = judged.map(|((judgement, finding), sides)| match verdict(finding) {
        Some(verdict) if is_open(judgement) => asked(judgement.rel, verdict, finding, [sides[0], sides[1]]),
        _ => judgement.clone(),
    });
    Claim { judgements: judged.collect() }
}

/// What a page says of a relation.
fn asked(rel: Rel, verdict: Verdict, finding: &Finding, sides: [&Expr; 2]) -> Judgement {
    let [left, right] = sides.map(|side| Value::Text(write::text(side)));
    Judgement { rel, left, right, verdict, difference: None, witness: None, reasons: reasons(finding) }
}

fn sides(chain: &Expr) -> Vec<&Expr> {
    let Kind::Chain(first, links) = &chain.kind else { return Vec::new() };
    std::iter::once(first.as_ref()).chain(links.iter().map(|link| &link.expr)).collect()
}

/// π is a number: a claim that fails for some value of the letter is not refuted.
fn without_numbers_as_letters(mut outcome: Outcome, statement: &Expr) -> Outcome {
    let Value::Claim(claim) = &outcome.value else { return outcome };
    let sides: Vec<bool> = sides(statement).into_iter().map(names_pi).collect();
    if claim.judgements.len() + 1 != sides.len() {
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
    let Kind::Chain(_, links) = &claim.kind else { return Vec::new() };
    let side = |expr: &Expr| Side { expr: expr.clone(), latex: write::latex(expr) };
    let sides = sides(claim).into_iter();
    let relations = links.iter().map(|link| (link.rel, link.span)).collect();
    let chain = Chain {
        universal: conditions.is_empty(),
        conditions: conditions.to_vec(),
        ..Chain::new(sides.map(side).collect(), relations)
    };
    let place = Place::from(Layout { formula: 1, ..Layout::default() });
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
