//! Which of several formulas is wrong: "f(t) = a t^2 + b t + c with a = …, b = … and c = …" fails if one of them has a slip.
//!
//! **Rule.** A formula that fails with what its own sentence adds to it ("with", "where") is not wrong itself if it
//! holds after a small change of one of these additions, and not after one of its own: then that is the one that is
//! wrong.

use std::rc::Rc;

use crate::budget::Limits;
use crate::formula::Expr;
use crate::formula::source::Span;
use crate::judge::instances::setting;
use crate::judge::known::checker::Checker;
use crate::judge::page::context::{Body, Mark};
use crate::judge::page::finding::{Evidence, Finding, Verdict};
use crate::judge::page::statement::{Chain, Statement};
use crate::judge::repair;
use crate::judge::written::names::bases;
use crate::language::write;

/// So many changes are tried.
const TRIES: usize = 1000;

/// A definition that is blamed, and what it should be.
struct Blamed {
    place: Span,
    repaired: Expr,
    /// What is found with the repair.
    findings: Vec<Finding>,
}

impl Checker {
    /// Moves refutations to the additions of their sentence that cause them.
    pub(in crate::judge) fn blame(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut Vec<Finding>,
        before: Mark,
    ) {
        // With a small change of its own it is as likely to be wrong itself.
        let far = |finding: &Finding| finding.verdict == Verdict::Refuted && finding.suggestion.is_none();
        if !findings.iter().any(far) {
            return;
        }
        let used = self
            .context
            .reached(&chain.sides.iter().map(|side| &side.expr).collect::<Vec<_>>(), &statement.place);
        let additions: Vec<usize> = (0..before.definitions())
            .filter(|&number| {
                let definition = &self.context.definitions[number];
                let own = definition.place.group == statement.place.group;
                own && definition.place.formula > statement.place.formula
                    && used.contains(&definition.head.base)
            })
            .collect();
        if additions.is_empty() {
            return;
        }
        let limits = self.limits.clone();
        let (kept, uses) = (self.context.clone(), self.uses.clone());
        let (taken, schemes) = (self.taken.len(), self.schemes.len());
        let steps = Some(setting::share(&limits, TRIES as u64));
        self.limits = Limits { steps, ..limits.clone() };
        let found = self.blamed(chain, statement, &additions, before);
        self.limits = limits;
        self.context = kept;
        self.uses = uses;
        self.taken.truncate(taken);
        self.schemes.truncate(schemes);
        let Some(Blamed { place, repaired, findings: others }) = found else { return };
        let line = self.line(chain.whole().span);
        let Some(slip) = self.findings.iter_mut().find(|finding| {
            finding.verdict == Verdict::Definition
                && finding.span.start <= place.start
                && place.end <= finding.span.end
        }) else {
            return;
        };
        slip.verdict = Verdict::Refuted;
        slip.reason = Some(format!("with it what line {line} says is wrong"));
        let name = slip.latex.split_once('=').map(|(name, _)| name.trim());
        slip.suggestion = name.map(|name| format!("{name} = {}", write::latex(&repaired)));
        slip.evidence = vec![Evidence::Near];
        let corrected = self.line(place);
        *findings = others;
        for finding in findings {
            finding.reason = Some(format!("once line {corrected} is put right"));
        }
    }

    fn blamed(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        additions: &[usize],
        before: Mark,
    ) -> Option<Blamed> {
        let right = &chain.sides[chain.sides.len() - 1].expr;
        let edits = |&number: &usize| {
            let definition = &self.context.definitions[number];
            let Body::Formula(body) = &definition.body else { return None };
            let base = &definition.head.base;
            let other = |edit: &Expr| !bases(edit).contains(base);
            let edits: Vec<Expr> = repair::edits(body, right, &None).into_iter().filter(other).collect();
            Some((number, body.span, edits))
        };
        let additions: Vec<(usize, Span, Vec<Expr>)> = additions.iter().filter_map(edits).collect();
        let longest = additions.iter().map(|(.., edits)| edits.len()).max()?;
        let kept = self.context.clone();
        // The small changes of all of them before the larger ones.
        let in_turn = (0..longest).flat_map(|at| {
            additions.iter().filter_map(move |(number, place, edits)| Some((*number, *place, edits.get(at)?)))
        });
        for (number, place, edit) in in_turn.take(TRIES) {
            self.context = kept.clone();
            let context = Rc::make_mut(&mut self.context);
            context.forget(before);
            context.replace(number, edit.clone());
            let findings = self.judged(chain, statement, before).ok()?;
            if findings.iter().all(|finding| matches!(finding.verdict, Verdict::Proved | Verdict::Sampled)) {
                return Some(Blamed { place, repaired: edit.clone(), findings });
            }
        }
        None
    }
}
