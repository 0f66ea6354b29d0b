//! A page checked: statements one after the other, what they define is known to those after them.
//!
//! `asked` makes a page of one claim, `backwards` looks back at a formula that a new name completes, `declare` takes in
//! declarations, `derivation` reads D as an operator, `implied` knows what a sentence says beside its formula, and `blame` finds which of several formulas of a sentence is wrong.

pub(crate) mod asked;
mod backwards;
mod blame;
mod declare;
mod derivation;
mod implied;
mod marks;
mod operators;
mod rivals;

use std::rc::Rc;

use crate::budget::{self, Stop};
use crate::formula::{Expr, Kind, Link, Rel, interval};
use crate::judge::known::checker::Checker;
use crate::judge::known::meaning::{definable, is_root_of};
use crate::judge::known::unread::Unread;
use crate::judge::page::context::{Body, Condition, Definition, Mark, is_variable};
use crate::judge::page::finding::{Finding, Verdict, blank, of_side, without_statement};
use crate::judge::page::members::with_members_listed;
use crate::judge::page::object::{Declared, Object};
use crate::judge::page::reach::whole_sums;
use crate::judge::page::statement::{Chain, Role, Said, Side, Statement, equates_values};
use crate::judge::page::topic::Topic;
use crate::judge::reasons::lint;
use crate::judge::written::names::{Head, bases, is_range};

const ASKED: &str = "asked for, not claimed";

impl Checker {
    /// Judges the next statement, or takes in what it defines.
    pub fn statement(&mut self, statement: &Statement) {
        let first = self.findings.len();
        self.take_in(statement);
        self.note_senses(statement, first);
        match &statement.said {
            Said::Chain(chain) => self.seen.extend(chain.sides.iter().flat_map(|side| bases(&side.expr))),
            Said::Condition(side) | Said::Bare(side, _) => self.seen.extend(bases(&side.expr)),
            Said::Object(_)
            | Said::Contact(_)
            | Said::Triangles(..)
            | Said::Declaration(..)
            | Said::Queries(..) => {}
        }
    }

    /// Judges by all that was said. To be called after the last statement.
    pub fn conclude(&mut self) {
        self.finish();
        self.by_rows();
        self.hear_appeals();
    }

    fn take_in(&mut self, statement: &Statement) {
        if let Some(chain) = self.sum_of_known(statement) {
            return self.take_in(&Statement { said: Said::Chain(chain), ..statement.clone() });
        }
        match &statement.said {
            Said::Declaration(text, span) => self.declare(text, &statement.place, Some(*span)),
            Said::Object(object) => self.object(object, &statement.place),
            Said::Contact(contact) => {
                let context = Rc::make_mut(&mut self.context);
                if contact.possible.is_none() {
                    context.unread.insert(statement.place.group);
                }
                if !contact.certain.is_empty() {
                    context.contacts.push((statement.place.clone(), contact.clone()));
                }
            }
            Said::Triangles(readings, formulas) => self.triangle(readings, formulas, statement),
            Said::Queries(text, span) => self.queries(text, &statement.place, *span),
            Said::Condition(side) => {
                let mut finding = of_side(side, Verdict::Definition, 1);
                finding.reason = Some("a condition".to_owned());
                if side.is_unread() {
                    finding.verdict = Verdict::Unread;
                }
                self.findings.push(finding);
                Rc::make_mut(&mut self.context).hear(&side.expr, &statement.place);
                // A case is a condition of the claims of its sentence, and of nothing else.
                if !statement.is_case() {
                    // A range said in passing holds in its paragraph.
                    let passing = is_range(&side.expr) && statement.role != Some(Role::Introduced);
                    let assumed = statement.role == Some(Role::Assumed) || passing;
                    self.condition(side.expr.clone(), side.expr.span, assumed, &statement.place);
                }
            }
            Said::Bare(side, problems) => {
                let mut finding = without_statement(side);
                if side.is_unread() {
                    finding.verdict = Verdict::Unread;
                    finding.reason = problems.first().map(|problem| problem.message.clone());
                }
                self.findings.push(finding);
                Rc::make_mut(&mut self.context).hear(&side.expr, &statement.place);
                self.remember_list(&side.expr, statement);
                self.join(&side.expr, statement);
            }
            Said::Chain(chain) => {
                let chain = &whole_sums(chain);
                let derived = self.without_operator(chain, &statement.place);
                let chain = derived.as_ref().unwrap_or(chain);
                let operated = self.with_operators(chain);
                let chain = operated.as_ref().unwrap_or(chain);
                let renamed = self.with_marked_names(chain, &statement.place);
                let chain = renamed.as_ref().unwrap_or(chain);
                let characteristic = marks::with_characteristic_function(chain);
                let chain = characteristic.as_ref().unwrap_or(chain);
                let general = |base: &str| {
                    let mut known = self.context.visible(base, &statement.place);
                    known.any(|(_, own, _)| own.head.lower.iter().any(|index| !bases(index).is_empty()))
                };
                let listed = with_members_listed(chain, &general);
                let chain = listed.as_ref().unwrap_or(chain);
                if self.ignored > 0 {
                    self.ignored -= 1;
                    for at in 0..chain.relations.len() {
                        let mut finding = blank(chain, at);
                        finding.verdict = Verdict::Undecided;
                        finding.reason = Some("the file says to ignore this".to_owned());
                        self.findings.push(finding);
                    }
                    return;
                }
                self.diagonal(chain, statement);
                self.operators(chain, &statement.place);
                let before = self.context.mark();
                self.before = before;
                // [c, d] = [1, 2]; b_3 = (16, 0) is a point.
                let closed =
                    |side: &&Side| interval(&side.expr).is_some_and(|(_, open)| open != [true, true]);
                for side in chain.sides.iter().filter(closed) {
                    Rc::make_mut(&mut self.context).hear(&side.expr, &statement.place);
                }
                if equates_values(chain) {
                    Rc::make_mut(&mut self.context).hear(&chain.whole(), &statement.place);
                }
                let required = self.required(chain, statement);
                let statement = required.as_ref().unwrap_or(statement);
                if let Some(mut findings) = self.unasserted(chain, statement) {
                    Rc::make_mut(&mut self.context).hear(&chain.whole(), &statement.place);
                    // What two curves have to fulfil where they meet is known.
                    let join = statement.role == Some(Role::Assumed) && statement.topics.has(Topic::Join);
                    if statement.role == Some(Role::Sought) {
                        self.remember(chain, statement, &findings);
                    }
                    if statement.role == Some(Role::Equivalent) {
                        self.as_a_consequence(chain, statement, &mut findings);
                    }
                    self.keep_equations(chain, statement, &findings);
                    if join || statement.role == Some(Role::Equivalent) {
                        self.by_the_field(chain, statement, &mut findings, before);
                    }
                    self.warn_of_weights(chain, statement, &mut findings);
                    self.findings.extend(findings);
                    return;
                }
                match self.judged(chain, statement, before) {
                    Ok(mut findings) => {
                        self.as_said_of_any(chain, statement, &mut findings, before);
                        self.note_appeal(chain, statement, before, &findings);
                        self.blame(chain, statement, &mut findings, before);
                        self.remember(chain, statement, &findings);
                        self.keep_equations(chain, statement, &findings);
                        self.remember_law(chain, &statement.place, &findings);
                        let line = self.line(chain.sides[0].expr.span);
                        self.unread.extend(Unread::of(chain, &statement.place, &findings, line, &self.seen));
                        self.remember_row(chain, statement, self.findings.len());
                        self.findings.extend(findings);
                    }
                    Err(stop) => {
                        Rc::make_mut(&mut self.context).forget(before);
                        for at in 0..chain.relations.len() {
                            let mut finding = blank(chain, at);
                            finding.verdict = Verdict::Undecided;
                            finding.reason = Some(stop.to_string());
                            self.findings.push(finding);
                        }
                    }
                }
            }
        }
    }

    /// α + β + γ = 1 is a condition on names, unless formulas say what each of them is: then it is claimed.
    fn sum_of_known(&self, statement: &Statement) -> Option<Chain> {
        let Said::Condition(side) = &statement.said else { return None };
        if !matches!(statement.role, None | Some(Role::Claimed | Role::Always)) {
            return None;
        }
        let Kind::Chain(left, links) = &side.expr.kind else { return None };
        let [Link { rel: Rel::Eq, expr: right, span }] = links.as_slice() else { return None };
        let known = |base: &String| {
            let mut definitions = self.context.visible(base, &statement.place);
            definitions.any(|(_, definition, _)| matches!(definition.body, Body::Formula(_)))
        };
        let names = bases(left);
        if names.is_empty() || !names.iter().all(known) {
            return None;
        }
        let (before, after) = side.latex.rsplit_once('=')?;
        let side = |expr: &Expr, latex: &str| Side { expr: expr.clone(), latex: latex.trim().to_owned() };
        Some(Chain::new(vec![side(left, before), side(right, after)], vec![(Rel::Eq, *span)]))
    }

    /// "Given the points p_0, …, p_3, find the cubic x with x(i/3) = p_i": they are no control points of it.
    fn required(&mut self, chain: &Chain, statement: &Statement) -> Option<Statement> {
        let (Some(Role::Introduced), [(Rel::Eq, _)]) = (statement.role, chain.relations.as_slice()) else {
            return None;
        };
        let (call, value) = (Head::of(&chain.sides[0].expr)?, Head::of(&chain.sides[1].expr)?);
        if call.flat().len() != 1 || value.lower.is_empty() || value.arguments.is_some() {
            return None;
        }
        let told = self.context.object_called(&call.base, &statement.place)?;
        let mut points = told.object.points.iter().filter_map(Head::of);
        if !points.any(|point| point.base == value.base) {
            return None;
        }
        let object = Object { points: Vec::new(), ..told.object.as_ref().clone() };
        let declared = Declared { object: Rc::new(object), place: statement.place.clone(), line: told.line };
        Rc::make_mut(&mut self.context).declare(declared);
        Some(Statement { role: Some(Role::Assumed), ..statement.clone() })
    }

    /// Judges a chain in all ways.
    pub(in crate::judge) fn judged(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        before: Mark,
    ) -> Result<Vec<Finding>, Stop> {
        let limits = self.limits.clone();
        let mut findings = budget::run(&limits, || self.chain(chain, statement))?;
        self.by_what_was_said(chain, statement, &mut findings, before);
        self.by_the_field(chain, statement, &mut findings, before);
        self.by_description(chain, statement, &mut findings, before);
        self.by_scheme(chain, statement, &mut findings);
        self.by_insertion(chain, statement, &mut findings, before);
        self.by_curvature(chain, statement, &mut findings, before);
        self.by_own_values(chain, statement, &mut findings, before);
        self.by_what_it_completes(chain, statement, &mut findings, before);
        self.as_supposed(chain, statement, &mut findings);
        self.by_equations(chain, statement, &mut findings, before);
        self.as_said_before(chain, statement, &mut findings, before);
        self.warn_of_weights(chain, statement, &mut findings);
        Ok(findings)
    }

    /// What an earlier line says in the same words is not shown by it: "The tangent of a quadratic is p'(1) = …. That of a
    /// cubic is p'(1) = …"
    fn as_said_before(&self, chain: &Chain, statement: &Statement, findings: &mut [Finding], before: Mark) {
        let ([left, right], [finding]) = (chain.sides.as_slice(), findings) else { return };
        let holds = matches!(finding.verdict, Verdict::Proved | Verdict::Sampled);
        let again = chain.relations[0].0 == Rel::Define || statement.role == Some(Role::Introduced);
        if !holds || again || finding.reason.is_some() || bases(&right.expr).is_empty() {
            return;
        }
        // F(t) = t^2 - t: what F is may be said again.
        let head = definable(&left.expr);
        let arguments: Vec<String> = head.iter().flat_map(|head| head.flat()).flat_map(bases).collect();
        if !arguments.is_empty() && bases(&right.expr).iter().all(|name| arguments.contains(name)) {
            return;
        }
        let place = &statement.place;
        let whole = chain.whole();
        let told =
            self.context.definitions[..before.definitions()].iter().filter(|own| place.sees(&own.place));
        let defined = |own: &&Definition| {
            own.place.formula != place.formula
                && matches!(&own.body, Body::Formula(body) if body.same_as(&right.expr))
                && head.as_ref().is_some_and(|head| own.head.same_as(head))
        };
        let given =
            self.context.conditions[..before.conditions()].iter().filter(|own| place.sees(&own.place));
        let supposed = |own: &&Condition| own.expr.same_as(&whole) && own.place.formula != place.formula;
        let line = told.rev().find(defined).map(|own| own.line);
        if let Some(line) = line.or_else(|| given.rev().find(supposed).map(|own| own.line)) {
            finding.verdict = Verdict::Undecided;
            finding.reason = Some(format!("line {line} says the same, and nothing shows it"));
            finding.instances = None;
        }
    }

    /// Whether a sign with "!" above it says that it shall hold.
    fn is_demanded(&self, chain: &Chain) -> bool {
        chain.relations.iter().any(|(_, sign)| {
            let written = self.file.slice(*sign);
            written.starts_with('\\') && written.contains('!')
        })
    }

    /// A chain that its sentence assumes, asks for, or claims for cases that nothing describes.
    fn unasserted(&mut self, chain: &Chain, statement: &Statement) -> Option<Vec<Finding>> {
        let (verdict, reason) = match statement.role {
            Some(Role::Assumed) => (Verdict::Definition, "assumed here"),
            Some(Role::Asked | Role::Sought | Role::Equivalent) => (Verdict::Undecided, ASKED),
            _ if self.is_demanded(chain) => (Verdict::Undecided, ASKED),
            _ if statement.is_case() => (Verdict::Definition, "a condition"),
            _ if chain.partial => (Verdict::Definition, "said of the other cases"),
            _ => return None,
        };
        let place = &statement.place;
        let joins = lint::joins(&self.context, chain, place).is_some();
        let new = definable(&chain.sides[0].expr).filter(|head| !joins && !is_root_of(head, chain));
        let new = new.filter(|head| {
            chain.relations.len() == 1 && !self.is_known(head, &chain.sides[1].expr, place, &None)
        });
        // "The patch has the equation x(u, v) = …"
        let formula = new.as_ref().is_some_and(|head| {
            matches!(statement.role, Some(Role::Asked | Role::Sought))
                && !head.flat().is_empty()
                && head
                    .flat()
                    .iter()
                    .all(|argument| matches!(&argument.kind, Kind::Name(name) if is_variable(name)))
        });
        // "It is not assumed that p + q = 1"
        let assumed = statement.role == Some(Role::Assumed) && !statement.denied;
        if let (true, Some(head), [(Rel::Eq | Rel::Define, span)]) =
            (assumed || formula, new, chain.relations.as_slice())
            && !chain.sides[1].is_unread()
        {
            let body = Body::Formula(chain.sides[1].expr.clone());
            self.define(head, body, &chain.conditions, place, *span);
            if let Some(definition) = Rc::make_mut(&mut self.context).definitions.last_mut() {
                definition.assumed = assumed;
            }
        } else if assumed {
            for (at, (rel, span)) in chain.relations.iter().enumerate() {
                let link = Link { rel: *rel, span: *span, expr: chain.sides[at + 1].expr.clone() };
                let left = &chain.sides[at].expr;
                let span = left.span.to(link.expr.span);
                let relation = Expr::new(Kind::Chain(Box::new(left.clone()), vec![link]), span);
                self.condition_for(relation, &chain.conditions, span, true, &statement.place);
            }
        }
        let finding = |at: usize| {
            let unread = chain.sides[at].is_unread() || chain.sides[at + 1].is_unread();
            let verdict = if unread { Verdict::Unread } else { verdict };
            Finding { verdict, reason: Some(reason.to_owned()), ..blank(chain, at) }
        };
        Some((0..chain.relations.len()).map(finding).collect())
    }
}
