//! Judging statements one after the other: what they define is known to those after them.

use std::rc::Rc;

use super::context::{Body, Condition, Context, Definition, Letters, Source, is_variable};
use super::features::has_call;
use super::finding::{Finding, Verdict};
use super::known::definable;
use super::lint;
use super::model::{Choices, Curve};
use super::names::{Head, contains, is_index_letter, is_range};
use super::object::{Declared, Object, Sort};
use super::reach::whole_sums;
use super::refute;
use super::reliance::Use;
use super::statement::{Chain, Place, Role, Said, Side, Statement};
use super::topic::Topic;
use super::trial::Setting;
use super::verdict::Judged;
use crate::budget::{self, Limits};
use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Link, Rel};
use crate::language::diagnostic::Diagnostic;
use crate::language::value::Value;
use crate::language::write;
use crate::math::poly::{Index, Symbol};
use num_traits::Zero;

const ASKED: &str = "asked for, not claimed";

/// Judges statements in their order.
pub struct Checker {
    pub(super) file: SourceFile,
    pub(super) context: Rc<Context>,
    pub(super) limits: Limits,
    /// How many of the next formulas are not to be judged.
    pub(super) ignored: usize,
    /// What could not be judged, for formulas that come later.
    pub(super) open: Vec<Condition>,
    /// What relied on definitions of the page.
    pub(super) uses: Vec<Use>,
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
            open: Vec::new(),
            uses: Vec::new(),
            findings: Vec::new(),
            problems: Vec::new(),
        }
    }

    pub(super) fn line(&self, span: Span) -> usize {
        self.file.line_column(span.start).0
    }

    /// Judges the next statement, or takes in what it defines.
    pub fn statement(&mut self, statement: &Statement) {
        match &statement.said {
            Said::Declaration(text, span) => self.declare(text, &statement.place, Some(*span)),
            Said::Object(object) => self.object(object, &statement.place),
            Said::Queries(text, span) => self.queries(text, &statement.place, *span),
            Said::Condition(side) => {
                let mut finding = of_side(side, Verdict::Definition, 1);
                finding.reason = Some("a condition".to_owned());
                if side.is_unread() {
                    finding.verdict = Verdict::Unread;
                }
                self.findings.push(finding);
                // A case is a condition of the claims of its sentence, and of nothing else.
                if !statement.is_case() {
                    // A range said in passing holds in its paragraph.
                    let passing = is_range(&side.expr) && statement.role != Some(Role::Introduced);
                    let assumed = statement.role == Some(Role::Assumed) || passing;
                    self.condition(side.expr.clone(), side.expr.span, assumed, &statement.place);
                }
            }
            Said::Bare(side, problems) => {
                let mut finding = of_side(side, Verdict::Undecided, 0);
                finding.reason = Some("it states nothing to check".to_owned());
                if side.is_unread() {
                    finding.verdict = Verdict::Unread;
                    finding.reason = problems.first().map(|problem| problem.message.clone());
                }
                self.findings.push(finding);
            }
            Said::Chain(chain) => {
                let chain = &whole_sums(chain);
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
                let limits = self.limits.clone();
                let before = self.context.mark();
                if let Some(mut findings) = self.unasserted(chain, statement) {
                    // What two curves have to fulfil where they meet is known.
                    let join = statement.role == Some(Role::Assumed) && statement.topics.has(Topic::Join);
                    if statement.role == Some(Role::Sought) {
                        self.remember(chain, statement, &findings);
                    }
                    if join || statement.role == Some(Role::Equivalent) {
                        self.by_the_field(chain, statement, &mut findings, before);
                    }
                    self.findings.extend(findings);
                    return;
                }
                match budget::run(&limits, || self.chain(chain, statement)) {
                    Ok(mut findings) => {
                        self.by_what_was_said(chain, statement, &mut findings, before);
                        self.by_the_field(chain, statement, &mut findings, before);
                        self.remember(chain, statement, &findings);
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

    /// Takes in what words say that names stand for.
    pub(super) fn object(&mut self, object: &Object, place: &Place) {
        let line = object.names.first().map_or(0, |name| self.line(name.span));
        let declared = Declared { object: Rc::new(object.clone()), place: place.clone(), line };
        Rc::make_mut(&mut self.context).declare(declared);
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
        let new = definable(&chain.sides[0].expr).filter(|head| !is_root_of(head, chain)).filter(|head| {
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
                self.condition(relation, span, true, &statement.place);
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
        let line = self.line(span);
        let condition = Condition { expr, assumed, place: place.clone(), line };
        Rc::make_mut(&mut self.context).conditions.push(condition);
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

    fn chain(&mut self, chain: &Chain, statement: &Statement) -> Vec<Finding> {
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
                    let declares = matches!(rel, Rel::In | Rel::Subset | Rel::Colon | Rel::To | Rel::MapsTo);
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
                && matches!(value.kind, Kind::Number(_))
                && chain.relations.iter().all(|(rel, _)| *rel == Rel::Eq)
            {
                for side in &chain.sides {
                    let certain = |head: &Head| {
                        head.lower
                            .iter()
                            .chain(&head.upper)
                            .all(|index| matches!(index.kind, Kind::Number(_)))
                    };
                    if let Some(head) = Head::of(&side.expr).filter(certain) {
                        self.define(head, Body::Formula(value.clone()), &[], place, side.expr.span);
                    }
                }
            }
            return findings;
        }
        let curve = statement.curve();
        let head = definable(&chain.sides[0].expr)
            .filter(|_| matches!(chain.relations[0].0, Rel::Eq | Rel::Define))
            .filter(|head| statement.role != Some(Role::All) || !is_root_of(head, chain))
            .filter(|head| {
                chain.relations[0].0 == Rel::Define || names_its_variables(head, &chain.sides[1].expr)
            });
        let queried = head.as_ref().is_some_and(|head| self.is_queried(head, place));
        let first_known = queried
            || head.as_ref().is_some_and(|head| self.is_known(head, &chain.sides[1].expr, place, &curve));
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
            let claims = statement.role == Some(Role::Claimed)
                || !matches!(statement.role, Some(Role::Introduced)) && spoken();
            if claims && !defines {
                let before = self.context.mark();
                let mut tried = findings.clone();
                self.judge(chain, 0, statement, curve.clone(), None, &mut tried);
                let settled = match tried[0].verdict {
                    Verdict::Proved | Verdict::Sampled => true,
                    // Nothing can be wrong of a family that the page never spoke of.
                    Verdict::Refuted => {
                        let symbol =
                            Symbol::new(&head.base).with_upper(head.upper.iter().map(|_| Index::Number(0)));
                        let given = self.context.object(head, place).is_some_and(|d| d.object.has_values());
                        statement.role == Some(Role::Claimed) && given
                            || tried[0].determined
                            || head.arguments.is_none() && !self.is_open(&symbol, &curve)
                    }
                    _ => false,
                };
                if settled {
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
                self.definition(chain, head, place, &mut findings[0]);
                self.convention(head, &chain.sides[1].expr, statement);
            }
            start = 1;
        }
        if start == 0
            && let Some(function) = self.new_derivative(chain, place)
        {
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
            self.definition(chain, &own, place, &mut findings[0]);
            start = 1;
        }
        if start == 0
            && let Some(reason) = lint::joins(&self.context, chain, place)
        {
            findings[0].reason = Some(reason);
            start = 1;
        }
        if start < chain.relations.len() {
            self.judge(chain, start, statement, curve, head.as_ref(), &mut findings);
        }
        // s = N_0^2(t) + … shows the curve that a query gives.
        if queried && findings[0].verdict == Verdict::Undecided {
            findings[0].verdict = Verdict::Definition;
            findings[0].reason = Some("shows the value of a query".to_owned());
        }
        findings
    }

    fn definition(&mut self, chain: &Chain, head: &Head, place: &Place, finding: &mut Finding) {
        let body = &chain.sides[1];
        if body.is_unread() {
            return;
        }
        finding.verdict = Verdict::Definition;
        finding.reason = Some(format!("introduces {}", head.base));
        finding.warning = lint::definition(head, &body.expr, &chain.conditions);
        if self.is_queried(head, place) {
            return;
        }
        // A derivative is not defined by a formula for it, nor f(t) by one in t_1, …, t_n.
        let derivative = head.parenthesized
            && head.arguments.is_some()
            && head.upper.iter().all(|upper| matches!(&upper.kind, Kind::Name(_) | Kind::Number(_)));
        // The pieces of one B-spline follow from the recursion for all.
        let pieces = head.base == "N"
            && !head.lower.is_empty()
            && matches!(body.expr.kind, Kind::Cases(_))
            && head.lower.iter().all(|index| matches!(index.kind, Kind::Number(_)));
        // If p is prime, φ(p) = p - 1: of other p it says nothing.
        let restricted = head.flat().iter().filter_map(|argument| Head::of(argument)).any(|argument| {
            self.context
                .object_called(&argument.base, place)
                .is_some_and(|declared| matches!(declared.object.sort, Sort::Other(_)))
        });
        if derivative || pieces || restricted || lint::missing_argument(head, &body.expr).is_some() {
            return;
        }
        self.define(head.clone(), Body::Formula(body.expr.clone()), &chain.conditions, place, body.expr.span);
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
        let best = self.attempts(&setting, &sides, &relations);
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
            match verdict {
                Judged::Verdict(finding) => {
                    let old = &findings[at];
                    let warning = match finding.verdict {
                        Verdict::Proved | Verdict::Sampled => finding.warning.clone(),
                        _ => finding.warning.clone().or(old.warning.clone()),
                    };
                    self.rely(
                        tally,
                        [0, 1].map(|i| &chain.sides[at + i].expr),
                        self.findings.len() + at,
                        &finding,
                    );
                    findings[at] = Finding {
                        warning,
                        span: old.span,
                        mark: old.mark,
                        latex: old.latex.clone(),
                        reading: old.reading.clone(),
                        relation: old.relation,
                        ..*finding
                    };
                }
                Judged::Recursion(head) => self.definition(chain, &head, place, &mut findings[at]),
                Judged::Redefinition(warning) => {
                    if let Some(head) = head {
                        if refute::is_standard(Some(head)) {
                            // What everybody calls so keeps its meaning.
                            findings[at].verdict = Verdict::Definition;
                            findings[at].reason = Some(format!("introduces {}", head.base));
                            findings[at].warning = warning;
                            continue;
                        }
                        self.definition(chain, head, place, &mut findings[at]);
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
                && !tally.record.unknown.is_empty()
                && head.is_none()
                && self.is_datum(&chain.sides[at].expr, &chain.sides[at + 1].expr, place);
            if datum {
                findings[at].verdict = Verdict::Definition;
                findings[at].reason = Some(format!("says a value of {}", chain.sides[at].latex));
            }
            let open = given || findings[at].verdict == Verdict::Definition;
            if open && chain.relations[at].0 == Rel::Eq {
                let (left, right) = (&chain.sides[at].expr, &chain.sides[at + 1].expr);
                let relation = Expr::relation(left.clone(), Rel::Eq, right.clone());
                self.condition(relation, findings[at].span, false, place);
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
                    let expr = crate::language::value::symbol_expr(&symbol);
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

    /// Where a side in the middle of a chain is wrong, both relations around it fail: the second one
    /// is judged by comparing the sides around.
    fn across(&self, setting: &Setting, start: usize, choices: Choices, findings: &mut [Finding]) {
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
            if tally.fails.is_empty() && tally.holds_inner.max(tally.holds / 2) >= 1 {
                let next = &mut findings[at + 1];
                next.verdict = Verdict::Undecided;
                next.reason = Some("equal to the side before the last, not to the one between".to_owned());
                (next.witness, next.suggestion, next.warning) = (None, None, None);
            }
        }
    }
}

/// f(x) = 0 says that x is a root of f, not that f is 0.
fn is_root_of(head: &Head, chain: &Chain) -> bool {
    let zero = matches!(&chain.sides[1].expr.kind, Kind::Number(q) if q.is_zero());
    head.arguments.is_some() && chain.relations[0].0 == Rel::Eq && !chain.universal && zero
}

/// Whether a call on the left of an equation is one at variables: S(x) = … is, S(a) = y_0 is a value of S, and
/// g(a) = a says that a is a fixed point of g.
fn names_its_variables(head: &Head, body: &Expr) -> bool {
    let inside = super::names::bases(body);
    let arguments = head.flat();
    let Some(Expr { kind: Kind::Name(only), .. }) = arguments.first().filter(|_| arguments.len() == 1) else {
        return true;
    };
    let fixed = matches!(body.kind, Kind::Name(_));
    is_variable(only) || is_index_letter(only) || inside.contains(only) && !fixed
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

/// A finding for a formula without a relation.
pub fn of_side(side: &Side, verdict: Verdict, relation: usize) -> Finding {
    let span = side.expr.span;
    let finding = Finding::new(span, span, side.latex.clone(), write::latex(&side.expr), relation);
    Finding { verdict, ..finding }
}
