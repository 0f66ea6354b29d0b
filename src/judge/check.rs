//! Judging statements one after the other: what they define is known to those after them.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use super::agreement::Agreement;
use super::context::{Body, Condition, Context, Definition, Mark, Source, is_variable};
use super::described::Taken;
use super::finding::{Finding, Verdict};
use super::known::definable;
use super::letters::Letters;
use super::lint;
use super::model::Ambiguity;
use super::names::{Head, bases, is_range};
use super::object::{Declared, Object, Sort};
use super::reach::whole_sums;
use super::reliance::Use;
use super::scheme::Scheme;
use super::statement::{Chain, Place, Role, Said, Side, Statement, links};
use super::topic::Topic;
use super::unread::Unread;
use crate::budget::{self, Limits, Stop};
use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Link, Rel, interval};
use crate::language::diagnostic::Diagnostic;
use crate::language::write;
use num_traits::Zero;

const ASKED: &str = "asked for, not claimed";

/// Judges statements in their order.
#[derive(Clone)]
pub struct Checker {
    pub(super) file: SourceFile,
    pub(super) context: Rc<Context>,
    pub(super) limits: Limits,
    /// How many of the next formulas are not to be judged.
    pub(super) ignored: usize,
    /// Names that stand beside something that could not be read.
    pub(super) unread: Vec<Unread>,
    /// What could not be judged, for formulas that come later.
    pub(super) open: Vec<Condition>,
    /// What relied on definitions of the page.
    pub(super) uses: Vec<Use>,
    /// What new names were found to mean.
    pub(super) taken: Vec<Taken>,
    /// Schemes of which points agreed.
    pub(super) schemes: Vec<Scheme>,
    /// The letters that occurred so far.
    pub(super) seen: BTreeSet<String>,
    /// Letters of control points that words speak of, of which one agreed.
    pub(super) agreed: Vec<(String, Place)>,
    /// Theorems that gave a member of a family.
    pub(super) agreements: Vec<Agreement>,
    /// How ambiguous notations were found to be meant: true is the second reading.
    pub(super) settled: RefCell<BTreeMap<Ambiguity, bool>>,
    /// Functions with laws that stayed open, each with its place and line.
    pub(super) laws: Vec<(String, Place, usize)>,
    /// What was known before the statement that is judged.
    pub(super) before: Mark,
    /// Whether a repair is judged, for which no other is looked for.
    pub(super) confirming: bool,
    /// What was found so far, one finding for each relation.
    pub findings: Vec<Finding>,
    /// What is wrong with declarations.
    pub problems: Vec<Diagnostic>,
}

impl Checker {
    /// Before the first statement; `statements` are all that will come, for what letters are used as.
    pub fn new(file: &SourceFile, limits: &Limits, statements: &[Statement]) -> Self {
        let letters = Letters::of(statements);
        Checker {
            file: file.clone(),
            context: Rc::new(Context::new(letters)),
            limits: limits.clone(),
            ignored: 0,
            unread: Vec::new(),
            open: Vec::new(),
            uses: Vec::new(),
            taken: Vec::new(),
            schemes: Vec::new(),
            seen: BTreeSet::new(),
            agreed: Vec::new(),
            agreements: Vec::new(),
            settled: RefCell::default(),
            laws: Vec::new(),
            before: Mark::default(),
            confirming: false,
            findings: Vec::new(),
            problems: Vec::new(),
        }
    }

    /// A state of an earlier run to go on from in this one, if letters are used alike on both pages, of which what was
    /// judged must be the same.
    pub fn resumed(&self, earlier: &Checker) -> Option<Checker> {
        (self.context.letters == earlier.context.letters).then(|| Checker {
            file: self.file.clone(),
            limits: self.limits.clone(),
            ..earlier.clone()
        })
    }

    pub(super) fn line(&self, span: Span) -> usize {
        self.file.line_column(span.start).0
    }

    /// Judges the next statement, or takes in what it defines.
    pub fn statement(&mut self, statement: &Statement) {
        self.take_in(statement);
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
                self.join(&side.expr, statement);
            }
            Said::Chain(chain) => {
                let chain = &whole_sums(chain);
                let derived = self.without_operator(chain, &statement.place);
                let chain = derived.as_ref().unwrap_or(chain);
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
                // [c, d] = [1, 2]
                for side in chain.sides.iter().filter(|side| interval(&side.expr).is_some()) {
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
                    if join || statement.role == Some(Role::Equivalent) {
                        self.by_the_field(chain, statement, &mut findings, before);
                    }
                    self.findings.extend(findings);
                    return;
                }
                match self.judged(chain, statement, before) {
                    Ok(mut findings) => {
                        self.blame(chain, statement, &mut findings, before);
                        self.remember(chain, statement, &findings);
                        self.remember_law(chain, &statement.place, &findings);
                        let line = self.line(chain.sides[0].expr.span);
                        self.unread.extend(Unread::of(chain, &statement.place, &findings, line));
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
    pub(super) fn judged(
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
        self.by_own_values(chain, statement, &mut findings, before);
        self.as_supposed(chain, statement, &mut findings);
        Ok(findings)
    }

    /// Takes in what words say that names stand for.
    pub(super) fn object(&mut self, object: &Object, place: &Place) {
        let line = object.names.first().map_or(0, |name| self.line(name.span));
        let mut object = object.clone();
        // The pieces of a spline meet at the data, if nothing else is said.
        if object.sort == Sort::SplineCurve && object.knots.is_empty() && object.points.is_empty() {
            object.knots = object.data.iter().map(|(x, _)| x.clone()).collect();
        }
        // f(0, 1) in a table: a value of f says nothing of what f is.
        if let (Sort::Symbols, [name @ Expr { kind: Kind::Apply(..), .. }], [value]) =
            (&object.sort, object.names.as_slice(), object.values.as_slice())
        {
            let equation = Expr::relation(name.clone(), Rel::Eq, value.clone());
            self.condition(equation, name.span, false, place);
            return;
        }
        // "The point b_i arises …": the b_i that are known
        let known = |head: Head| {
            let known = self.context.object(&head, place).filter(|known| known.place.scope == place.scope);
            known.is_some_and(|known| known.object.has_values())
        };
        if matches!(object.sort, Sort::Symbols | Sort::ControlPoints)
            && object.is_bare()
            && object.names.iter().filter_map(Head::of).all(known)
        {
            return;
        }
        let object = Rc::new(object);
        let declared = Declared { object: object.clone(), place: place.clone(), line };
        Rc::make_mut(&mut self.context).declare(declared);
        if let [name] = object.names.as_slice() {
            for (x, y) in &object.data {
                let value = Expr::apply(name.clone(), vec![x.clone()]);
                self.condition(Expr::relation(value, Rel::Eq, y.clone()), name.span, false, place);
            }
        }
        if object.natural {
            self.natural(&object, place);
        }
        for (head, value) in object.members() {
            let span = value.span;
            self.define(head, Body::Formula(value), &[], place, span);
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
        let assumed = statement.role == Some(Role::Assumed);
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

    /// Adds a condition that later formulas may need.
    pub(super) fn condition(&mut self, expr: Expr, span: Span, assumed: bool, place: &Place) {
        self.condition_for(expr, &[], span, assumed, place);
    }

    /// The same for some values of its indices: F^{(k)}(τ) = G^{(k)}(τ) for k = 0, …, r.
    pub(super) fn condition_for(
        &mut self,
        expr: Expr,
        ranges: &[Expr],
        span: Span,
        assumed: bool,
        place: &Place,
    ) {
        let line = self.line(span);
        for expr in links(&expr) {
            let condition = Condition { expr, assumed, place: place.clone(), line, ranges: ranges.to_vec() };
            Rc::make_mut(&mut self.context).conditions.push(condition);
        }
    }

    /// Adds a definition that later formulas use.
    pub(super) fn define(&mut self, head: Head, body: Body, conditions: &[Expr], place: &Place, span: Span) {
        self.define_by(Source::Page, head, body, conditions, place, span);
    }

    pub(super) fn define_by(
        &mut self,
        source: Source,
        head: Head,
        body: Body,
        conditions: &[Expr],
        place: &Place,
        span: Span,
    ) {
        let (conditions, place, line) = (conditions.to_vec(), place.clone(), self.line(span));
        let definition = Definition { head, body, conditions, place, line, assumed: false, source };
        Rc::make_mut(&mut self.context).define(definition);
    }
}

/// f(x) = 0 says that x is a root of f, not that f is 0.
pub(super) fn is_root_of(head: &Head, chain: &Chain) -> bool {
    let zero = matches!(&chain.sides[1].expr.kind, Kind::Number(q) if q.is_zero());
    head.arguments.is_some() && chain.relations[0].0 == Rel::Eq && !chain.universal && zero
}

/// A finding for a relation, not judged yet.
pub fn blank(chain: &Chain, at: usize) -> Finding {
    let (left, right) = (&chain.sides[at], &chain.sides[at + 1]);
    let (rel, sign) = chain.relations[at];
    let sign_text = write::latex(&Expr::relation(Expr::name("a"), rel, Expr::name("b")));
    let sign_text = sign_text.trim_start_matches('a').trim_end_matches('b').trim().to_owned();
    let reading = Expr::relation(left.expr.clone(), rel, right.expr.clone());
    let latex = format!("{} {} {}", left.latex, sign_text, right.latex);
    let span = left.expr.span.to(sign).to(right.expr.span);
    Finding::new(span, sign, latex, write::latex(&reading), at + 1)
}

/// The finding for a formula that states nothing.
pub(super) fn without_statement(side: &Side) -> Finding {
    let reason = Some("it states nothing to check".to_owned());
    Finding { reason, ..of_side(side, Verdict::Undecided, 0) }
}

/// A finding for a formula without a relation.
pub fn of_side(side: &Side, verdict: Verdict, relation: usize) -> Finding {
    let span = side.expr.span;
    let finding = Finding::new(span, span, side.latex.clone(), write::latex(&side.expr), relation);
    Finding { verdict, ..finding }
}

/// Whether it says that two functions or their derivatives have one value somewhere: F'(a) = G'(a).
pub(super) fn equates_values(chain: &Chain) -> bool {
    let call = |side: &Side| matches!(side.expr.kind, Kind::Apply(..)) && !side.is_unread();
    matches!(chain.sides.as_slice(), [one, other] if call(one) && call(other))
        && matches!(chain.relations.as_slice(), [(Rel::Eq, _)])
}
