//! Relations of a chain judged by the sides around them.

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::setting::Setting;
use crate::judge::known::checker::Checker;
use crate::judge::model::Choices;
use crate::judge::page::finding::{Evidence, Finding, Verdict};
use crate::judge::written::names::{Head, bases};
use crate::language::write;

impl Checker {
    /// Where a side in the middle of a chain is wrong, both relations around it fail: the second one
    /// is judged by comparing the sides around.
    pub(super) fn across(&self, setting: &Setting, start: usize, choices: Choices, findings: &mut [Finding]) {
        let chain = setting.chain;
        for at in start..chain.relations.len().saturating_sub(1) {
            let open = |finding: &Finding| {
                matches!(finding.verdict, Verdict::Refuted | Verdict::Undecided | Verdict::Unread)
            };
            let equal = |at: usize| matches!(chain.relations[at].0, Rel::Eq | Rel::Equiv);
            if !(open(&findings[at]) && open(&findings[at + 1]) && equal(at) && equal(at + 1)) {
                continue;
            }
            if chain.sides[at].is_unread() || chain.sides[at + 2].is_unread() {
                continue;
            }
            let sides = [&chain.sides[at].expr, &chain.sides[at + 2].expr];
            let outcomes = self.trial(setting, &sides, &[Rel::Eq], choices).run();
            let tally = &outcomes.tallies[0];
            // c(1/4) = b_0^2(1/4) = 29/8: whatever stands between is, c(1/4) is a number, too.
            let number = |side: &Expr| bases(side).is_empty();
            if let ([failure], Kind::Apply(_, groups)) = (tally.fails.as_slice(), &sides[0].kind)
                && findings[at].verdict == Verdict::Undecided
                && findings[at + 1].verdict == Verdict::Undecided
                && groups.iter().flatten().all(number)
                && number(sides[1])
                && tally.record.unknown.is_empty()
                && tally.record.definitions.iter().all(|(_, near)| *near)
                && [&failure.left, &failure.right].into_iter().all(|value| value.as_rational().is_some())
            {
                let (next, left) = (&mut findings[at + 1], &chain.sides[at].latex);
                next.verdict = Verdict::Refuted;
                next.reason = Some(format!("{left} is {}", write::text(&failure.left.to_expr())));
                next.evidence = vec![Evidence::Value];
                continue;
            }
            if tally.fails.is_empty() && tally.holds_inner.max(tally.holds / 2) >= 1 {
                let next = &mut findings[at + 1];
                next.verdict = Verdict::Undecided;
                next.reason = Some("equal to the side before the last, not to the one between".to_owned());
                (next.witness, next.suggestion, next.warning) = (None, None, None);
                if self.is_alone_wrong(setting, at, choices, tally.holds_inner)
                    && findings[at].verdict == Verdict::Undecided
                {
                    let wrong = &mut findings[at];
                    wrong.verdict = Verdict::Refuted;
                    wrong.reason = Some("the sides around it are equal, it differs from both".to_owned());
                    wrong.evidence = vec![Evidence::Value];
                }
            }
        }
    }

    /// Whether a side between two that are equal, made of the same names in the same shapes, differs from them wherever it
    /// is tried: what is read right around it is read right there.
    fn is_alone_wrong(&self, setting: &Setting, at: usize, choices: Choices, around: usize) -> bool {
        let [left, middle, right] = [0, 1, 2].map(|i| &setting.chain.sides[at + i].expr);
        let known: BTreeSet<(String, [usize; 3])> = [left, right].into_iter().flat_map(shapes).collect();
        if around == 0 || bases(middle).is_empty() || !shapes(middle).is_subset(&known) {
            return false;
        }
        let outcomes = self.trial(setting, &[left, middle], &[Rel::Eq], choices).run();
        let tally = &outcomes.tallies[0];
        !tally.fails.is_empty() && tally.holds == 0
    }
}

/// The names in a formula with how many indices and arguments they have.
fn shapes(expr: &Expr) -> BTreeSet<(String, [usize; 3])> {
    let mut found = BTreeSet::new();
    gather_shapes(expr, &mut found);
    found
}

fn gather_shapes(expr: &Expr, found: &mut BTreeSet<(String, [usize; 3])>) {
    if let Some(head) = Head::of(expr) {
        let count = [head.lower.len(), head.upper.len(), head.flat().len()];
        found.insert((head.base.clone(), count));
        let parts = head.lower.iter().chain(&head.upper).chain(head.flat());
        parts.for_each(|part| gather_shapes(part, found));
        return;
    }
    expr.for_each_child(&mut |child| gather_shapes(child, found));
}
