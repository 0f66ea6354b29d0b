//! Judging one chain of relations: what it defines, and what comes of its claims.

use std::rc::Rc;

use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::tally::Tally;
use crate::judge::known::checker::Checker;
use crate::judge::known::meaning::{definable, is_root_of};
use crate::judge::known::unread::{family_told, is_whole_family};
use crate::judge::page::context::{Body, is_variable};
use crate::judge::page::finding::{Evidence, Finding, Verdict, blank};
use crate::judge::page::object::{Declared, Sort};
use crate::judge::page::statement::{Chain, Curve, Role, Side, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::reasons::lint;
use crate::judge::reasons::refute;
use crate::judge::verdict::forms::{is_at_variable, is_law, names_its_variables};
use crate::judge::verdict::relation::Judged;
use crate::judge::written::features::has_call;
use crate::judge::written::names::{Head, bases, contains, symbol_of};
use crate::language::value::{Value, symbol_expr};
use crate::math::poly::Index;
use num_traits::Zero;

/// Dots between names stand for fewer than so many.
const MOST_DOTS: i64 = 64;

impl Checker {
    pub(in crate::judge) fn chain(&mut self, chain: &Chain, statement: &Statement) -> Vec<Finding> {
        let place = &statement.place;
        let mut findings: Vec<Finding> = (0..chain.relations.len()).map(|at| blank(chain, at)).collect();
        for (at, finding) in findings.iter_mut().enumerate() {
            let unread = chain.sides[at + 1].is_unread() || chain.sides[at].is_unread();
            if unread {
                finding.verdict = Verdict::Unread;
                finding.reason = chain.problems.first().map(|problem| problem.message.clone());
            }
        }
        let checkable = |rel: Rel| {
            matches!(
                rel,
                Rel::Eq
                    | Rel::Define
                    | Rel::Equiv
                    | Rel::Approx
                    | Rel::Le
                    | Rel::Lt
                    | Rel::Ge
                    | Rel::Gt
                    | Rel::Ne
            )
        };
        if let Some(at) = chain.relations.iter().position(|(rel, _)| !checkable(*rel)) {
            for (i, finding) in findings.iter_mut().enumerate() {
                let (rel, _) = chain.relations[i];
                if finding.verdict != Verdict::Unread && !checkable(rel) {
                    let declares = matches!(
                        rel,
                        Rel::In | Rel::NotIn | Rel::Subset | Rel::Colon | Rel::To | Rel::MapsTo
                    );
                    finding.verdict = if declares { Verdict::Definition } else { Verdict::Undecided };
                    finding.reason = Some(
                        if declares {
                            "says what a name ranges over"
                        } else {
                            "this relation is not checked"
                        }
                        .to_owned(),
                    );
                }
            }
            // What stands before and after it is judged by itself.
            for (from, to) in [(0, at), (at + 1, chain.relations.len())] {
                if from < to {
                    let part = Chain {
                        sides: chain.sides[from..=to].to_vec(),
                        relations: chain.relations[from..to].to_vec(),
                        ..chain.clone()
                    };
                    for (mut finding, place) in self.chain(&part, statement).into_iter().zip(from..to) {
                        finding.relation = place + 1;
                        findings[place] = finding;
                    }
                }
            }
            return findings;
        }
        if let Some(reason) = lint::declares(chain) {
            for finding in findings.iter_mut().filter(|finding| finding.verdict != Verdict::Unread) {
                finding.verdict = Verdict::Definition;
                finding.reason = Some(reason.to_owned());
            }
            // w_0 = w_2 = 1
            if let Some(Side { expr: value, .. }) = chain.sides.last()
                && bases(value).is_empty()
                && value.kind != Kind::Ellipsis
                && chain.relations.iter().all(|(rel, _)| *rel == Rel::Eq)
            {
                for side in &with_dots_written_out(&chain.sides) {
                    let certain = |head: &Head| {
                        head.lower
                            .iter()
                            .chain(&head.upper)
                            .all(|index| matches!(index.kind, Kind::Number(_)))
                    };
                    // M_0 = M_n = 0, where M_i = s''(x_i): a condition on s
                    if Head::of(side).is_some_and(|head| self.is_of_any_spline(&head, place)) {
                        let equation = Expr::relation(side.clone(), Rel::Eq, value.clone());
                        self.condition(equation, side.span, false, place);
                    } else if let Some(head) = Head::of(side).filter(certain) {
                        self.define(head, Body::Formula(value.clone()), &[], place, side.span);
                    }
                }
            }
            return findings;
        }
        if let Some(found) = self.in_case_of_value(chain, statement) {
            return found;
        }
        if self.gives_values(chain, statement) || self.gives_entries(chain, place) {
            findings[0].verdict = Verdict::Definition;
            findings[0].reason = Some("says what these names are".to_owned());
            return findings;
        }
        let curve = statement.curve();
        let joins = lint::joins(&self.context, chain, place).filter(|_| {
            // F(τ) = G(τ) of two functions that words introduced, or where curves join: it is no definition of F.
            let joined = statement.topics.has(Topic::Join);
            chain.sides.iter().take(2).all(|side| {
                Head::of(&side.expr).is_some_and(|head| {
                    joined && head.arguments.is_some()
                        || self.context.object_called(&head.base, place).is_some()
                })
            })
        });
        // D = F' says what D is; D alone is an operator.
        let named = |expr: &Expr| match (&expr.kind, &chain.sides[1].expr.kind) {
            (Kind::Name(name), Kind::Prime(..)) if name == "D" => Head::of(expr),
            _ => None,
        };
        let left = &chain.sides[0].expr;
        let head = definable(left)
            .or_else(|| named(left))
            .map(|head| self.context.with_pairs_apart(head))
            .filter(|_| joins.is_none())
            .filter(|head| !self.is_power_of_member(head, &chain.sides[1].expr, place))
            // D = d/dt is the operator.
            .filter(|_| !matches!(chain.sides[1].expr.kind, Kind::Derivative { body: None, .. }))
            .filter(|_| matches!(chain.relations[0].0, Rel::Eq | Rel::Define))
            // S_{uv} is known where S(u, v) is.
            .filter(|head| self.context.variables_of_partial(head, place).is_none())
            .filter(|head| statement.role != Some(Role::All) || !is_root_of(head, chain))
            .filter(|head| {
                let right = &chain.sides[1].expr;
                chain.relations[0].0 == Rel::Define
                    || names_its_variables(head, right) && !is_law(head, right)
            });
        let queried = head.as_ref().is_some_and(|head| self.is_queried(head, place));
        let first_known = queried
            || head.as_ref().is_some_and(|head| self.is_known(head, &chain.sides[1].expr, place, &curve));
        let elsewhere = head.as_ref().is_some_and(|head| self.is_of_another_case(head, chain, place));
        let first_known = first_known && !elsewhere;
        if let Some(listed) = self.listed(chain, place) {
            return vec![listed];
        }
        // x = x + 1 defines nothing.
        let circular = head.is_some()
            && chain.relations[0].0 == Rel::Eq
            && contains(&chain.sides[1].expr, &chain.sides[0].expr);
        let first_known = first_known || circular;
        let defines = chain.relations[0].0 == Rel::Define && !first_known;
        let mut start = 0;
        if let Some(head) = &head
            && (!first_known || defines)
            && !chain.sides[0].is_unread()
        {
            // What is said to follow is a claim, if the facts say what its name is.
            // Facts that speak of it may say what it is already.
            let spoken =
                || self.context.object(head, place).is_some() || self.is_constrained(&head.base, place);
            let known = || !head.lower.is_empty() && self.is_covered(head, place);
            let claimed = statement.role == Some(Role::Claimed);
            let introduced = statement.role == Some(Role::Introduced);
            let told = !claimed && !introduced && (spoken() || known());
            // P_i = f(a, …, b), where F(t) = Σ P_i B_i^n(t) and f is its polar form: it speaks of itself.
            let right = &chain.sides[1].expr;
            let around = !told
                && !introduced
                && !bases(right).contains(&head.base)
                && self.context.reached(&[right], place).contains(&head.base);
            let claims = (claimed || told || around) && !elsewhere;
            if claims && !defines {
                let before = self.context.mark();
                let mut tried = findings.clone();
                self.judge(chain, 0, statement, curve.clone(), None, &mut tried);
                let settled = match tried[0].verdict {
                    Verdict::Proved | Verdict::Sampled => true,
                    // Nothing can be wrong of a family that the page never spoke of.
                    Verdict::Refuted => {
                        let symbol =
                            symbol_of(&head.base).with_upper(head.upper.iter().map(|_| Index::Number(0)));
                        let given = self.context.object(head, place).is_some_and(|d| d.object.has_values());
                        (claimed || tried[0].evidence.contains(&Evidence::Names)) && given
                            || around
                            || tried[0].determined
                            || self
                                .agreed
                                .iter()
                                .any(|(letter, other)| *letter == head.base && place.knows(other, false))
                            || head.arguments.is_none() && !self.is_open(&symbol, &curve)
                    }
                    _ => false,
                };
                if settled {
                    self.keep(chain, head, place, &tried[0]);
                    // Others of the control points that words speak of are told by one that agrees.
                    let points = |declared: &Declared| declared.object.sort == Sort::ControlPoints;
                    let value = !matches!(&chain.sides[1].expr.kind, Kind::Number(q) if q.is_zero());
                    if tried[0].verdict == Verdict::Proved
                        && value
                        && self.context.object(head, place).is_some_and(points)
                    {
                        self.agreed.push((head.base.clone(), place.clone()));
                    }
                    return tried;
                }
                Rc::make_mut(&mut self.context).forget(before);
            }
            // A new name: its right-hand side says what it is. A value of a variable in passing is none.
            let passing = head.lower.is_empty()
                && head.upper.is_empty()
                && head.arguments.is_none()
                && is_variable(&head.base)
                && !matches!(statement.role, Some(Role::Introduced))
                && !has_call(&chain.sides[1].expr)
                && chain.sides[1].expr.items().is_none_or(|items| items.len() < 4)
                && (self.seen.contains(&head.base) || bases(&chain.sides[1].expr).is_empty())
                && !defines;
            if passing {
                findings[0].verdict = Verdict::Definition;
                findings[0].reason = Some(format!("a value of {} in passing", head.base));
                let (left, right) = (&chain.sides[0].expr, &chain.sides[1].expr);
                if !chain.sides[1].is_unread() {
                    let value = Expr::relation(left.clone(), Rel::Eq, right.clone());
                    self.condition(value, findings[0].span, true, place);
                }
            } else {
                self.definition(chain, head, statement, &mut findings[0]);
                self.gives_knots(head, &chain.sides[1].expr, place);
                self.convention(head, &chain.sides[1].expr, statement);
            }
            start = 1;
        }
        if start == 0
            && let Some(derivative) = self.new_derivative(chain, place)
        {
            self.definition(chain, &derivative, statement, &mut findings[0]);
            let function = derivative.base.trim_end_matches('\'');
            findings[0].verdict = Verdict::Definition;
            findings[0].reason = Some(format!("says what the derivative of {function} is"));
            start = 1;
        }
        if start == 0
            && head.is_none()
            && chain.relations[0].0 == Rel::Eq
            && let (left, right) = (&chain.sides[0].expr, &chain.sides[1].expr)
            && let Some(Some(own)) = self.recursion(left, right, place)
        {
            self.definition(chain, &own, statement, &mut findings[0]);
            start = 1;
        }
        if start == 0
            && let Some(reason) = lint::joins(&self.context, chain, place)
        {
            let follows = chain.universal || self.concludes(statement);
            if follows {
                self.judge(chain, 0, statement, curve.clone(), None, &mut findings);
            }
            if !matches!(findings[0].verdict, Verdict::Proved | Verdict::Sampled)
                && findings[0].evidence != [Evidence::Facts]
            {
                let relation =
                    Expr::relation(chain.sides[0].expr.clone(), Rel::Eq, chain.sides[1].expr.clone());
                if chain.relations[0].0 == Rel::Eq && !follows {
                    self.condition_for(relation, &chain.conditions, findings[0].span, false, place);
                }
                findings[0] = Finding { reason: Some(reason), ..blank(chain, 0) };
            }
            start = 1;
        }
        if start < chain.relations.len() {
            self.judge(chain, start, statement, curve, head.as_ref(), &mut findings);
        }
        if let Some(head) = &head {
            self.keep(chain, head, place, &findings[0]);
        } else if findings[0].verdict == Verdict::Definition && start == 0 {
            self.gives_members(chain, place);
        }
        // B_2^5(t) = 10 t^2 (1 - t)^3: these are the Bernstein polynomials.
        if let Some(own) = Head::of(&chain.sides[0].expr).filter(Head::is_bernstein)
            && findings[0].verdict == Verdict::Proved
            && own.arguments.is_some()
        {
            self.agreed.push((own.base, place.clone()));
        }
        // s = N_0^2(t) + … shows the curve that a query gives.
        if queried && findings[0].verdict == Verdict::Undecided {
            findings[0].verdict = Verdict::Definition;
            findings[0].reason = Some("shows the value of a query".to_owned());
        }
        findings
    }

    /// "For X = (2, 1) it is X = A/4 + …": the case says what X is.
    fn in_case_of_value(&mut self, chain: &Chain, statement: &Statement) -> Option<Vec<Finding>> {
        let left = &chain.sides[0].expr;
        let head = Head::of(left).filter(|head| head.arguments.is_none() && !is_variable(&head.base))?;
        let value = |case: &Expr| match &case.kind {
            Kind::Chain(name, links) if name.same_as(left) => match links.as_slice() {
                [link] if link.rel == Rel::Eq && bases(&link.expr).is_empty() => Some(link.expr.clone()),
                _ => None,
            },
            _ => None,
        };
        let at = chain.conditions.iter().position(|case| value(case).is_some())?;
        let mut rest = chain.clone();
        let value = value(&rest.conditions.remove(at))?;
        let mark = self.context.mark();
        let span = left.span;
        self.define(head, Body::Formula(value), &[], &statement.place, span);
        let found = self.chain(&rest, statement);
        Rc::make_mut(&mut self.context).forget(mark);
        Some(found)
    }

    /// Puts the verdict on a relation to the others of its chain; `wrong` is what it is if others confirm its names.
    fn settle(
        &mut self,
        tally: &Tally,
        chain: &Chain,
        at: usize,
        finding: Finding,
        wrong: Option<Box<Finding>>,
        findings: &mut [Finding],
    ) {
        let old = findings[at].clone();
        let place = |finding: Finding| {
            let warning = match finding.verdict {
                Verdict::Proved | Verdict::Sampled => finding.warning.clone(),
                _ => finding.warning.clone().or(old.warning.clone()),
            };
            Finding {
                warning,
                span: old.span,
                mark: old.mark,
                latex: old.latex.clone(),
                reading: old.reading.clone(),
                relation: old.relation,
                ..finding
            }
        };
        findings[at] = place(finding);
        let sides = [0, 1].map(|i| &chain.sides[at + i].expr);
        let wrong = wrong.map(|wrong| place(*wrong));
        self.rely(tally, sides, self.findings.len() + at, findings[at].verdict, wrong);
    }

    /// Judges the relations from number `start` on.
    fn judge(
        &mut self,
        chain: &Chain,
        start: usize,
        statement: &Statement,
        curve: Option<Curve>,
        head: Option<&Head>,
        findings: &mut [Finding],
    ) {
        let place = &statement.place;
        let sides: Vec<&Expr> = chain.sides[start..].iter().map(|side| &side.expr).collect();
        let relations: Vec<Rel> = chain.relations[start..].iter().map(|(rel, _)| *rel).collect();
        let setting = self.setting(chain, place, curve);
        let mut best = self.attempts(&setting, &sides, &relations);
        self.retry(&setting, &sides, &relations, &mut best);
        if let (Some(head), 0) = (head, start) {
            findings[0].warning = lint::definition(head, &chain.sides[1].expr, &chain.conditions);
        }
        for (i, tally) in best.outcomes.tallies.iter().enumerate() {
            let at = start + i;
            if findings[at].verdict == Verdict::Unread {
                continue;
            }
            let from_start = at == 0;
            let mut verdict =
                self.verdict(tally, &best, &setting, at, statement, head.filter(|_| from_start));
            if let Judged::Verdict(finding) = &mut verdict
                && finding.verdict == Verdict::Undecided
                && tally.fails.is_empty()
                && let Some(found) = self.with_any_values(&setting, at, statement)
            {
                **finding = found;
            }
            // "Let B_i^n(t) = t^i": what everybody calls so is not meant.
            if let (Judged::Verdict(finding) | Judged::Unfounded(finding, _), Some(head), true) =
                (&verdict, head, from_start)
                && finding.verdict == Verdict::Refuted
                && statement.role == Some(Role::Introduced)
                && refute::is_standard(Some(head))
                && family_told(chain).is_some()
            {
                verdict = Judged::Redefinition(Some(refute::not_usual(head, finding.witness.clone())));
            }
            // What words say of s does not tell its values: the formula does.
            if let (Judged::Verdict(finding), Some(head), true) = (&verdict, head, from_start)
                && finding.verdict == Verdict::Undecided
                && statement.role != Some(Role::Claimed)
                && tally.record.unknown.contains(&head.base)
                && !head.flat().is_empty()
                && !bases(&chain.sides[1].expr).contains(&head.base)
            {
                self.definition(chain, head, statement, &mut findings[at]);
                continue;
            }
            match verdict {
                Judged::Verdict(finding) => self.settle(tally, chain, at, *finding, None, findings),
                Judged::Unfounded(finding, wrong) => {
                    self.settle(tally, chain, at, *finding, Some(wrong), findings);
                }
                Judged::Recursion(head) => self.definition(chain, &head, statement, &mut findings[at]),
                // d_j^p = s(u), where the page says what all d_i^r are, speaks of some of them.
                Judged::Redefinition(_)
                    if head
                        .is_some_and(|head| self.is_of_some_members(head, &chain.sides[1].expr, place)) =>
                {
                    let base = head.map(|head| head.base.as_str()).unwrap_or_default();
                    findings[at].reason = Some(format!("a condition on {base}"));
                }
                Judged::Redefinition(warning) => {
                    if let Some(head) = head {
                        let usual = refute::is_standard(Some(head)) && warning.is_some();
                        let meant = statement.role == Some(Role::Introduced) && is_whole_family(head);
                        if usual && meant {
                            self.means_its_own(&head.base, &statement.place);
                        } else if usual {
                            // What everybody calls so keeps its meaning.
                            findings[at].verdict = Verdict::Definition;
                            findings[at].reason = Some(format!("introduces {}", head.base));
                            findings[at].warning = warning;
                            continue;
                        }
                        self.definition(chain, head, statement, &mut findings[at]);
                        if let Some(why) = tally.unclear.first().or(tally.errors.first().map(|e| &e.message))
                            && let Some(reason) = &mut findings[at].reason
                        {
                            reason.push_str(&format!(" (not computed: {why})"));
                        }
                        if warning.is_some() {
                            findings[at].warning = warning;
                        }
                    }
                }
            }
        }
        self.across(&setting, start, best.choices, findings);
        // An equation that nothing decides and nobody claims is a condition that later lines may need.
        for (i, tally) in best.outcomes.tallies.iter().enumerate() {
            let at = start + i;
            let given = statement.role == Some(Role::Introduced)
                && findings[at].verdict == Verdict::Undecided
                && !tally.fails.is_empty();
            let datum = statement.role != Some(Role::Claimed)
                && findings[at].verdict == Verdict::Undecided
                && chain.relations[at].0 == Rel::Eq
                && (!tally.record.unknown.is_empty()
                    || self.is_value_of_spline(&chain.sides[at].expr, place))
                && head.is_none()
                && !is_at_variable(&chain.sides[at].expr)
                && self.is_datum(&chain.sides[at].expr, &chain.sides[at + 1].expr, place);
            let named = at == 0
                && findings[at].verdict != Verdict::Proved
                && self.names_a_value_of_spline(chain, place);
            if datum || named {
                findings[at].verdict = Verdict::Definition;
                findings[at].reason = Some(format!("says a value of {}", chain.sides[at].latex));
            }
            // "It passes through q, so c(1/2) = q" says what q is.
            let of_words = |side: &Expr| match &side.kind {
                Kind::Apply(callee, _) => Head::of(callee).is_some_and(|head| {
                    self.context.object(&head, place).is_some_and(|known| known.object.determines())
                }),
                _ => false,
            };
            if findings[at].verdict == Verdict::Undecided
                && chain.relations.len() == 1
                && chain.relations[at].0 == Rel::Eq
                && of_words(&chain.sides[0].expr)
                && let Kind::Name(name) = &chain.sides[1].expr.kind
                && !is_variable(name)
                && self.context.visible(name, place).next().is_none()
                && !self.context.object_called(name, place).is_some_and(|known| known.object.has_values())
                && let Some(head) = Head::of(&chain.sides[1].expr)
            {
                findings[at].verdict = Verdict::Definition;
                findings[at].reason = Some(format!("says what {name} is"));
                let value = chain.sides[0].expr.clone();
                self.define(head, Body::Formula(value), &[], place, findings[at].span);
            }
            // l_3 = r_0 = …, where l_3 was new, says what r_0 is, too.
            let between = at == 1
                && findings[0].verdict == Verdict::Definition
                && findings[1].verdict == Verdict::Undecided
                && chain.relations[1].0 == Rel::Eq;
            if between
                && let Some(own) = definable(&chain.sides[1].expr)
                && !self.is_known(&own, &chain.sides[2].expr, place, &None)
                && !bases(&chain.sides[2].expr).contains(&own.base)
            {
                findings[1].verdict = Verdict::Definition;
                findings[1].reason = Some(format!("introduces {}", own.base));
                let value = Body::Formula(chain.sides[2].expr.clone());
                self.define(own, value, &chain.conditions, place, findings[1].span);
            }
            // Let g have the values g(0) = 1, …: not the g of another section.
            let number = |expr: &Expr| bases(expr).is_empty();
            let anew = statement.role != Some(Role::Claimed)
                && findings[at].verdict == Verdict::Undecided
                && !tally.record.definitions.is_empty()
                && tally.record.definitions.iter().all(|(_, near)| !near)
                && matches!(&chain.sides[at].expr.kind, Kind::Apply(callee, groups)
                    if matches!(callee.kind, Kind::Name(_)) && groups.iter().flatten().all(number))
                && number(&chain.sides[at + 1].expr);
            if anew && let Some(head) = Head::of(&chain.sides[at].expr) {
                findings[at].verdict = Verdict::Definition;
                findings[at].reason = Some(format!("says a value of {}", chain.sides[at].latex));
                let value = chain.sides[at + 1].expr.clone();
                self.define(head, Body::Formula(value), &[], place, findings[at].span);
            }
            // What two curves have to fulfil where they meet
            let join = statement.topics.has(Topic::Join)
                && statement.role != Some(Role::Introduced)
                && findings[at].verdict == Verdict::Undecided
                && tally.fails.iter().any(|failure| failure.inner)
                && tally.is_of_two_functions();
            let open = given || join || findings[at].verdict == Verdict::Definition;
            if open && chain.relations[at].0 == Rel::Eq {
                let (left, right) = (&chain.sides[at].expr, &chain.sides[at + 1].expr);
                let relation = Expr::relation(left.clone(), Rel::Eq, right.clone());
                self.condition_for(relation, &chain.conditions, findings[at].span, false, place);
            }
        }
        // Equations for new coefficients say what these are.
        for (i, tally) in best.outcomes.tallies.iter().enumerate() {
            let at = start + i;
            if matches!(findings[at].verdict, Verdict::Undecided)
                && let [failure] = tally.fails.as_slice()
                && let Some(solution) = lint::unknowns(&self.context, place, &failure.left, &failure.right)
            {
                let names: Vec<String> = solution.iter().map(|(symbol, _)| symbol.to_string()).collect();
                for (symbol, value) in solution {
                    let expr = symbol_expr(&symbol);
                    if let Some(head) = Head::of(&expr) {
                        self.define(head, Body::Value(Value::Scalar(value)), &[], place, findings[at].span);
                    }
                }
                findings[at].verdict = Verdict::Definition;
                findings[at].reason = Some(format!("says what {} are", names.join(", ")));
                findings[at].witness = None;
                findings[at].suggestion = None;
            }
        }
    }
}

/// The sides of u_0 = … = u_2 = 0 with u_1, which the dots stand for.
fn with_dots_written_out(sides: &[Side]) -> Vec<Expr> {
    let member = |side: Option<&Side>| {
        let head = Head::of(&side?.expr).filter(|head| head.arguments.is_none() && head.upper.is_empty())?;
        let index = head.index()?.as_int()?;
        Some((head, index))
    };
    let mut written = Vec::new();
    for (at, side) in sides.iter().enumerate() {
        let before = at.checked_sub(1).and_then(|before| member(sides.get(before)));
        match (side.expr.kind == Kind::Ellipsis, before, member(sides.get(at + 1))) {
            (true, Some((head, first)), Some((other, last)))
                if head.base == other.base && last - first < MOST_DOTS =>
            {
                let member = |number| Expr { span: side.expr.span, ..Expr::indexed(&head.base, number) };
                written.extend((first + 1..last).map(member));
            }
            _ => written.push(side.expr.clone()),
        }
    }
    written
}
