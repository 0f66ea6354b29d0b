//! A new formula for a name of which the page said something before: what was said has to hold with it.
//!
//! **Definition.** A *fact* about a name is an equation of the section that speaks of it, and that could not be
//! judged because nothing said what the name is: p(0) = y_0, L_i(x_j) = δ_{ij}. Once a formula for the name is given,
//! each fact is tried with it. It *fails* if both sides are made of the same symbols and differ.
//!
//! The formula is wrong if a fact fails. It is right if facts hold and decide: with each slip in its place some fact
//! fails.

use std::rc::Rc;

use crate::budget;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::hypotheses::is_coefficient;
use crate::judge::instances::setting;
use crate::judge::instances::tally::Failure;
use crate::judge::known::checker::Checker;
use crate::judge::known::meaning::definable;
use crate::judge::page::context::{Body, Condition, Mark, value_given};
use crate::judge::page::finding::{Finding, Verdict};
use crate::judge::page::object::UNNAMED;
use crate::judge::page::statement::{Chain, Role, Side, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::reasons::counterexample;
use crate::judge::repair;
use crate::judge::values::compare;
use crate::judge::written::names::{Head, bases, calls, contains, is_range};
use crate::language::write;
use crate::math::poly::Symbol;

/// A fact with the definition in question at hand.
enum Tried {
    Holds,
    Fails(Box<Failure>),
    /// It says nothing of this definition.
    Open,
}

/// So many facts that hold show that a formula is meant for the name they speak of.
const ENOUGH: usize = 2;

impl Checker {
    /// Keeps what could not be judged: it may tell of a formula that comes later.
    pub(in crate::judge) fn remember(&mut self, chain: &Chain, statement: &Statement, findings: &[Finding]) {
        for (at, finding) in findings.iter().enumerate() {
            if finding.verdict == Verdict::Undecided && chain.relations[at].0 == Rel::Eq && !chain.blocked {
                let (left, right) = (&chain.sides[at].expr, &chain.sides[at + 1].expr);
                let expr = Expr::relation(left.clone(), Rel::Eq, right.clone());
                let line = self.line(finding.span);
                let place = statement.place.clone();
                let (assumed, ranges) = (!chain.conditions.is_empty(), chain.conditions.clone());
                self.open.push(Condition { expr, assumed, place, line, ranges });
            }
        }
    }

    /// Judges a definition that a chain made, by the facts about its name.
    pub(in crate::judge) fn by_what_was_said(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
        before: Mark,
    ) {
        let made = self.context.definitions[before.definitions()..].first();
        let Some(definition) = made.filter(|_| findings[0].verdict == Verdict::Definition) else { return };
        let (head, right) = match &definition.body {
            Body::Formula(body) => (definition.head.clone(), body.clone()),
            Body::Value(_) => return,
        };
        // A number in passing, h = 1, is no formula for it, nor is one for a part of the range, s(x) = s(2 - x), or a value
        // at points that have names.
        let place = &statement.place;
        let point = |argument: &Expr| {
            let Kind::Name(letter) = &argument.kind else { return false };
            let mut given = self.context.conditions.iter().filter(|one| place.knows(&one.place, one.assumed));
            self.context.visible(letter, place).next().is_some()
                || given.any(|one| value_given(&one.expr).is_some_and(|(name, _)| name == letter))
        };
        if head.flat().into_iter().any(point) {
            return;
        }
        let whole = chain.conditions.is_empty() && !calls(&right, &head.base);
        let formula = whole && head.arguments.is_some()
            || statement.role == Some(Role::Claimed) && !head.lower.is_empty();
        let facts = if formula { self.facts_about(&head, chain, statement, before) } else { Vec::new() };
        if facts.is_empty() {
            return;
        }
        let limits = self.limits.clone();
        let finding = findings[0].clone();
        let found =
            budget::run(&limits, || self.judged_by(&facts, chain, &right, statement, before, finding));
        let Ok(Some(found)) = found else { return };
        if found.verdict == Verdict::Refuted {
            Rc::make_mut(&mut self.context).forget(before);
        }
        findings[0] = found;
    }

    /// The facts about a name, of its paragraph, or of its section if the formula is said to follow.
    fn facts_about(&self, head: &Head, chain: &Chain, statement: &Statement, before: Mark) -> Vec<Condition> {
        let place = &statement.place;
        // What is said for N = 2 says nothing of N = 3.
        let value = |case: &Expr| match &case.kind {
            Kind::Chain(left, links) if links.len() == 1 && links[0].rel == Rel::Eq => {
                Some((left.as_ref().clone(), links[0].expr.clone()))
            }
            _ => None,
        };
        let own: Vec<(Expr, Expr)> = chain.conditions.iter().filter_map(value).collect();
        let elsewhere = |fact: &Condition| {
            fact.ranges.iter().filter_map(value).any(|(name, other)| {
                own.iter().any(|(known, value)| known.same_as(&name) && !value.same_as(&other))
            })
        };
        // "p(0) = 0, p(1) = 1 give p(t) = t. p(0) = 1, p(1) = 1 give p(t) = 1": what the first formula came of is settled.
        let settled = |fact: &Condition| {
            let known = &self.context.definitions[..before.definitions()];
            head.arguments.is_some()
                && known.iter().any(|own| {
                    own.head.base == head.base
                        && own.head.lower.len() == head.lower.len()
                        && own.head.flat().iter().all(|argument| matches!(argument.kind, Kind::Name(_)))
                        && own.head.arguments.is_some()
                        && own.place.formula > fact.place.formula
                        && place.knows(&own.place, own.assumed)
                })
        };
        let told = |fact: &&Condition| {
            !elsewhere(fact)
                && !settled(fact)
                && place.in_reach(&fact.place, fact.assumed)
                && place.sees(&fact.place)
                && (fact.place.group == place.group
                    || statement.role == Some(Role::Claimed)
                    || fact.place.scope == place.scope
                        && (!head.lower.is_empty() || statement.role != Some(Role::Introduced)))
                && fact.place.formula < place.formula
                && matches!(&fact.expr.kind, Kind::Chain(_, links) if links.len() == 1 && links[0].rel == Rel::Eq)
                && !is_range(&fact.expr)
                && !gives(&fact.expr)
                && !self.context.is_spoken_of_anew(&head.base, &fact.place, place)
                && self.context.reached(&[&fact.expr], place).contains(&head.base)
        };
        self.context.conditions[..before.conditions()]
            .iter()
            .chain(&self.open)
            .filter(told)
            .cloned()
            .collect()
    }

    /// The finding that the facts lead to.
    fn judged_by(
        &mut self,
        facts: &[Condition],
        chain: &Chain,
        right: &Expr,
        statement: &Statement,
        before: Mark,
        finding: Finding,
    ) -> Option<Finding> {
        let mut holding = Vec::new();
        let mut failing = None;
        for fact in facts {
            match self.tried(fact, statement, before) {
                Tried::Holds => holding.push(fact),
                Tried::Fails(failure) => {
                    failing.get_or_insert((fact, failure));
                }
                Tried::Open => {}
            }
        }
        let start = budget::spent();
        let setting = self.setting(chain, &statement.place, None);
        let kept = self.context.clone();
        let left = &chain.sides[0].expr;
        let mut edits = repair::edits(right, left, &None).into_iter().filter(|edit| !contains(edit, left));
        if let Some((fact, failure)) = failing {
            // A slip, if with a small change all that was said holds.
            let repaired = edits.find(|edit| {
                if budget::spent() - start > setting::share(&self.limits, 4) {
                    return false;
                }
                Rc::make_mut(&mut self.context).replace(before.definitions(), edit.clone());
                matches!(self.tried(fact, statement, before), Tried::Holds)
                    && facts
                        .iter()
                        .all(|fact| !matches!(self.tried(fact, statement, before), Tried::Fails(_)))
            });
            self.context = kept;
            // Or else, if other facts of the same name hold with it.
            let own =
                |fact: &Condition| definable(left).is_some_and(|head| bases(&fact.expr).contains(&head.base));
            let told = holding.iter().filter(|fact| own(fact)).count();
            // A polynomial is a piece of a spline.
            let piece = statement.topics.has(Topic::Spline);
            if repaired.is_none() && (told < ENOUGH || !own(fact) || piece) {
                return None;
            }
            // The page has no names for its curves.
            let unnamed = bases(&fact.expr).iter().any(|name| name.starts_with(UNNAMED));
            let told = if unnamed { "the join of the curves".to_owned() } else { write::text(&fact.expr) };
            let suggestion =
                repaired.and_then(|repaired| self.suggestion(chain, 0, [left, &repaired], &[], statement));
            return Some(Finding {
                verdict: Verdict::Refuted,
                reason: Some(format!("with it {told}, which line {} says, is wrong", fact.line)),
                witness: counterexample::counterexample(&failure),
                suggestion,
                ..finding
            });
        }
        let first = holding.first()?;
        let noticed = edits.all(|edit| {
            if budget::spent() - start > setting::share(&self.limits, 2) {
                return false;
            }
            if self.agree(&setting, &edit, right) {
                return true;
            }
            Rc::make_mut(&mut self.context).replace(before.definitions(), edit);
            holding.iter().any(|fact| matches!(self.tried(fact, statement, before), Tried::Fails(_)))
        });
        self.context = kept;
        if !noticed {
            return None;
        }
        Some(Finding {
            verdict: Verdict::Sampled,
            reason: Some(format!("what line {} says determines it", first.line)),
            ..finding
        })
    }

    /// A fact with what is defined now.
    fn tried(&self, fact: &Condition, statement: &Statement, before: Mark) -> Tried {
        let Kind::Chain(left, links) = &fact.expr.kind else { return Tried::Open };
        let side = |expr: &Expr| Side { expr: expr.clone(), latex: String::new() };
        let chain = Chain::new(vec![side(left), side(&links[0].expr)], vec![(Rel::Eq, links[0].span)]);
        let setting = self.setting(&chain, &statement.place, statement.curve()).without_equations();
        let sides: Vec<&Expr> = chain.sides.iter().map(|side| &side.expr).collect();
        let attempt = self.attempts(&setting, &sides, &[Rel::Eq]);
        let tally = &attempt.outcomes.tallies[0];
        if !tally.record.definitions.iter().any(|(number, _)| *number == before.definitions()) {
            return Tried::Open;
        }
        // A number is that of the knots meant, not of any.
        let number = matches!(&self.context.definitions[before.definitions()].body, Body::Formula(body) if bases(body).is_empty());
        let cut = tally.record.unbounded || tally.record.infinite;
        let bounded = !(cut || number && tally.record.any_knots);
        if let Some(failure) =
            tally.fails.iter().find(|failure| !failure.outside && self.is_certain(failure, statement))
        {
            return if bounded { Tried::Fails(Box::new(failure.clone())) } else { Tried::Open };
        }
        if tally.nonzero > 0 { Tried::Holds } else { Tried::Open }
    }

    /// Whether both sides are made of the same symbols, and none of something that nobody introduced.
    fn is_certain(&self, failure: &Failure, statement: &Statement) -> bool {
        let known = |symbol: &Symbol| {
            let name = symbol.base().trim_start_matches('[').trim_end_matches(']');
            !is_coefficient(symbol) || self.context.object_called(name, &statement.place).is_some()
        };
        let (left, right) = (compare::symbols(&failure.left), compare::symbols(&failure.right));
        left.iter().all(known)
            && left.iter().all(|s| right.contains(s))
            && right.iter().all(|s| left.contains(s))
    }
}

/// Whether an equation is itself a formula for a name.
fn gives(fact: &Expr) -> bool {
    matches!(&fact.kind, Kind::Chain(left, _) if definable(left).is_some())
}
