//! A repair as the judge sees it.
//!
//! **Rule.** A relation is proposed in the place of another one only if its chain, judged with it in the same place as the
//! page stands, is green there, and what held before it in the chain still holds.

use crate::formula::{Expr, Rel};
use crate::judge::known::checker::Checker;
use crate::judge::page::finding::Verdict;
use crate::judge::page::statement::{Chain, Statement};
use crate::language::write;
use std::rc::Rc;

impl Checker {
    /// An equation in the place of the relation number `at`, as LaTeX, if the judge confirms it there.
    pub(in crate::judge) fn suggestion(
        &self,
        chain: &Chain,
        at: usize,
        [left, right]: [&Expr; 2],
        held: &[usize],
        statement: &Statement,
    ) -> Option<String> {
        let confirmed = self.confirms(chain, at, [left, right], held, statement);
        confirmed.then(|| write::latex(&Expr::relation(left.clone(), Rel::Eq, right.clone())))
    }

    /// Whether a chain with other sides around the relation number `at` is right there; `held` are the numbers of the
    /// relations before it that hold. Cost: that of judging the chain.
    pub(in crate::judge) fn confirms(
        &self,
        chain: &Chain,
        at: usize,
        sides: [&Expr; 2],
        held: &[usize],
        statement: &Statement,
    ) -> bool {
        if self.confirming {
            return false;
        }
        let mut changed = chain.clone();
        for (side, expr) in changed.sides[at..].iter_mut().zip(sides) {
            if !side.expr.same_as(expr) {
                side.latex = write::latex(expr);
                side.expr = expr.clone();
            }
        }
        let mut judge = Checker { confirming: true, ..self.clone() };
        Rc::make_mut(&mut judge.context).forget(self.before);
        let green = |verdict: Verdict| matches!(verdict, Verdict::Proved | Verdict::Sampled);
        judge.judged(&changed, statement, self.before).is_ok_and(|findings| {
            let after = |at: &usize| findings.get(*at).is_some_and(|finding| green(finding.verdict));
            after(&at) && held.iter().all(after)
        })
    }
}
