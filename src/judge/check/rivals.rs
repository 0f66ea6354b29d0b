//! Rival meanings: names that a page gives more than one meaning, in examples, items of a list, or for a comparison.
//!
//! **Rule.** A relation that fails is not wrong if it holds with another meaning that the page itself gives to a name in
//! it, before or after: which of them is meant was misunderstood. The other meaning must be one that the page gives
//! elsewhere, not in the relation, and not one that is its own slip said again.

use std::rc::Rc;

use crate::budget::Limits;
use crate::formula::{Expr, Kind, Link, Rel};
use crate::judge::instances::setting;
use crate::judge::known::checker::Checker;
use crate::judge::known::meaning::definable;
use crate::judge::known::senses::{Appeal, Means, Sense};
use crate::judge::page::context::{Body, Mark, Source, is_variable};
use crate::judge::page::finding::{Finding, Verdict};
use crate::judge::page::statement::{Chain, Said, Statement};
use crate::judge::written::names::bases;

/// So many other meanings are tried for one formula.
const TRIES: usize = 24;

/// x = a, f(t) = t^2: a name, and what it is said to be.
fn equation(left: &Expr, rel: Rel, right: &Expr) -> Option<Means> {
    let head = definable(left).filter(|_| matches!(rel, Rel::Eq | Rel::Define))?;
    let of_itself = bases(right).contains(&head.base) || right.kind == Kind::Ellipsis;
    (!of_itself).then(|| Means::Formula(head, right.clone()))
}

fn equations(expr: &Expr) -> Vec<Means> {
    match &expr.kind {
        Kind::Chain(left, links) => match links.as_slice() {
            [Link { rel, expr, .. }] => equation(left, *rel, expr).into_iter().collect(),
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
}

impl Checker {
    /// Keeps what a statement says that names mean; `first` is the number of its first finding.
    pub(in crate::judge) fn note_senses(&mut self, statement: &Statement, first: usize) {
        let (means, finding) = match &statement.said {
            Said::Chain(chain) => {
                let [left, right, ..] = chain.sides.as_slice() else { return };
                let read = !left.is_unread() && !right.is_unread();
                let own = equation(&left.expr, chain.relations[0].0, &right.expr).filter(|_| read);
                let means = own.into_iter().chain(chain.conditions.iter().flat_map(equations)).collect();
                (means, Some(first))
            }
            Said::Condition(side) => (equations(&side.expr), None),
            Said::Object(object) if object.has_values() => {
                (vec![Means::Object(Rc::new(object.as_ref().clone()))], None)
            }
            _ => return,
        };
        let (paragraph, formula) = (statement.place.group, statement.place.formula);
        let new = means.into_iter().map(|means| Sense { means, paragraph, formula, finding });
        self.senses.extend(new);
    }

    /// Keeps a formula of which a relation is or may become refuted.
    pub(in crate::judge) fn note_appeal(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        before: Mark,
        findings: &[Finding],
    ) {
        let first = self.findings.len();
        let pending = self.uses.iter().rev().take_while(|one| one.finding >= first);
        let refuted = findings.iter().any(|finding| finding.verdict == Verdict::Refuted);
        if refuted || pending.into_iter().any(|one| one.wrong.is_some()) {
            let (chain, statement) = (chain.clone(), statement.clone());
            let mut known = self.context.clone();
            Rc::make_mut(&mut known).forget(before);
            self.appeals.push(Appeal { first, chain, statement, known });
        }
    }

    /// Takes back what was refuted and holds with another meaning that the page gives to a name in it. To be called
    /// after the last statement.
    ///
    /// Cost: at most [`TRIES`] times that of each formula that is refuted.
    pub(in crate::judge) fn hear_appeals(&mut self) {
        let appeals = std::mem::take(&mut self.appeals);
        let senses = std::mem::take(&mut self.senses);
        for appeal in appeals {
            let count = appeal.chain.relations.len();
            let refuted = |own: &Self| {
                let own = &own.findings[appeal.first..appeal.first + count];
                own.iter().any(|finding| finding.verdict == Verdict::Refuted)
            };
            if !refuted(self) {
                continue;
            }
            for rival in self.rivals(&appeal, &senses) {
                let Some(findings) = self.judged_with(&appeal, &rival) else { continue };
                for (at, found) in findings.iter().enumerate() {
                    let own = &mut self.findings[appeal.first + at];
                    let holds = matches!(found.verdict, Verdict::Proved | Verdict::Sampled);
                    if own.verdict == Verdict::Refuted && holds {
                        let name = rival[0].bases().into_iter().next().unwrap_or_default();
                        *own = Finding {
                            verdict: Verdict::Undecided,
                            reason: Some(format!("it holds with another {name} of the page: which one is meant?")),
                            witness: None,
                            suggestion: None,
                            evidence: Vec::new(),
                            ..own.clone()
                        };
                    }
                }
                if !refuted(self) {
                    break;
                }
            }
        }
    }

    /// Other senses of the names of a formula, alone and with those of their paragraph.
    fn rivals<'a>(&self, appeal: &Appeal, senses: &'a [Sense]) -> Vec<Vec<&'a Sense>> {
        let Appeal { chain, statement, known, first, .. } = appeal;
        let sides: Vec<&Expr> = chain.sides.iter().map(|side| &side.expr).collect();
        let reached = known.reached(&sides, &statement.place);
        let own = *first..*first + chain.relations.len();
        let is_rival = |sense: &Sense| {
            let elsewhere = !sense.finding.is_some_and(|finding| own.contains(&finding));
            let refuted = sense.finding.is_some_and(|finding| {
                self.findings.get(finding).is_some_and(|finding| finding.verdict == Verdict::Refuted)
            });
            let other = match &sense.means {
                Means::Formula(head, body) => {
                    let whole = head.flat().iter().any(|argument| {
                        matches!(&argument.kind, Kind::Name(name) if is_variable(name))
                    });
                    let said = sides.iter().any(|side| side.same_as(body));
                    let valued = || {
                        known.visible(&head.base, &statement.place).next().is_some()
                            || known.object_called(&head.base, &statement.place).is_some()
                            || known
                                .values_heard(|place| place.group == statement.place.group)
                                .any(|(name, _)| name == head.base)
                    };
                    (!refuted || whole) && !said && valued()
                }
                Means::Object(_) => true,
            };
            elsewhere && other && sense.bases().iter().any(|base| reached.contains(base))
        };
        let all: Vec<&Sense> = senses.iter().filter(|sense| is_rival(sense)).collect();
        let distance = |sense: &Sense| sense.formula.abs_diff(statement.place.formula);
        let mut alone: Vec<Vec<&Sense>> = all.iter().map(|one| vec![*one]).collect();
        alone.sort_by_key(|one| distance(one[0]));
        let mut together: Vec<Vec<&Sense>> =
            all.chunk_by(|a, b| a.paragraph == b.paragraph).filter(|all| all.len() > 1).map(<[_]>::to_vec).collect();
        together.sort_by_key(|all| distance(all[0]));
        together.truncate(TRIES / 3);
        alone.truncate(TRIES - together.len());
        alone.into_iter().chain(together).collect()
    }

    /// What would be found with other senses.
    fn judged_with(&mut self, appeal: &Appeal, rival: &[&Sense]) -> Option<Vec<Finding>> {
        let Appeal { chain, statement, known, .. } = appeal;
        let mut other = Checker {
            context: known.clone(),
            limits: Limits { steps: Some(setting::share(&self.limits, 2)), ..self.limits.clone() },
            confirming: true,
            ..self.clone()
        };
        for sense in rival {
            match &sense.means {
                Means::Formula(head, body) => {
                    let (head, body) = (head.clone(), Body::Formula(body.clone()));
                    other.define_by(Source::Given, head, body, &[], &statement.place, chain.whole().span);
                }
                Means::Object(object) => other.object(object, &statement.place),
            }
        }
        let before = other.context.mark();
        other.before = before;
        other.judged(chain, statement, before).ok()
    }
}
