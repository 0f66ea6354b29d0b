//! Judging the statements of a document one after the other.

use std::rc::Rc;

use super::context::{Body, Condition, Context, Definition, Letters};
use super::document::Document;
use super::finding::{FileReport, Finding, Verdict};
use super::lint;
use super::model::{Ambiguity, Choices, Curve};
use super::names::{Head, bases};
use super::refute;
use super::statement::{Chain, Place, Said, Side, Statement, statements};
use super::trial::{Outcomes, Tally, Trial};
use crate::budget::{self, Limits};
use crate::expr::{Expr, Kind, Rel};
use crate::source::{SourceFile, Span};
use crate::value::Value;
use crate::write;

/// What to check with.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The limits of each formula.
    pub limits: Limits,
    /// Declarations in the query language, known before the first line.
    pub context: Option<String>,
}

/// Checks every formula of a document.
///
/// Cost: the statements are tried on up to some hundred small instances each; each chain has the
/// limits of the options.
pub fn check_document(document: &Document, options: &Options) -> FileReport {
    let statements = statements(document);
    let letters = Letters::of(&statements);
    let mut checker = Checker {
        file: document.file.clone(),
        context: Rc::new(Context { letters, ..Context::default() }),
        limits: options.limits.clone(),
        ignored: 0,
        findings: Vec::new(),
        problems: document.problems.clone(),
    };
    if let Some(context) = &options.context {
        checker.declare(context, &Place { scope: Vec::new(), group: 0, formula: 0 }, None);
    }
    for statement in &statements {
        checker.statement(statement);
    }
    FileReport { file: document.file.clone(), findings: checker.findings, problems: checker.problems }
}

/// How every formula of a document is read, without judging it.
pub fn listing(document: &Document) -> Vec<Finding> {
    let mut findings = Vec::new();
    for statement in statements(document) {
        match statement.said {
            Said::Chain(chain) => {
                for at in 0..chain.relations.len() {
                    findings.push(blank(&chain, at));
                }
            }
            Said::Condition(side) => findings.push(of_side(&side, Verdict::Definition, 1)),
            Said::Bare(side, problems) => {
                let mut finding = of_side(&side, Verdict::Undecided, 0);
                if side.is_unread() {
                    finding.verdict = Verdict::Unread;
                    finding.reason = problems.first().map(|problem| problem.message.clone());
                }
                findings.push(finding);
            }
            Said::Declaration(..) => {}
        }
    }
    findings
}

pub(super) struct Checker {
    pub(super) file: SourceFile,
    pub(super) context: Rc<Context>,
    pub(super) limits: Limits,
    /// How many of the next formulas are not to be judged.
    pub(super) ignored: usize,
    findings: Vec<Finding>,
    pub(super) problems: Vec<crate::diagnostic::Diagnostic>,
}

/// An attempt to judge a chain under one way of reading it.
pub(super) struct Attempt {
    pub(super) outcomes: Outcomes,
    pub(super) choices: Choices,
}

impl Checker {
    fn line(&self, span: Span) -> usize {
        self.file.line_column(span.start).0
    }

    fn statement(&mut self, statement: &Statement) {
        match &statement.said {
            Said::Declaration(text, span) => self.declare(text, &statement.place, Some(*span)),
            Said::Condition(side) => {
                let mut finding = of_side(side, Verdict::Definition, 1);
                finding.reason = Some("a condition".to_owned());
                if side.is_unread() {
                    finding.verdict = Verdict::Unread;
                }
                self.findings.push(finding);
                let line = self.line(side.expr.span);
                let condition = Condition { expr: side.expr.clone(), place: statement.place.clone(), line };
                Rc::make_mut(&mut self.context).conditions.push(condition);
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
                let limits = self.limits.clone();
                let before = self.context.clone();
                match budget::run(&limits, || self.chain(chain, statement)) {
                    Ok(findings) => self.findings.extend(findings),
                    Err(stop) => {
                        self.context = before;
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

    /// Adds a definition that later formulas use.
    pub(super) fn define(&mut self, head: Head, body: Body, conditions: &[Expr], place: &Place, span: Span) {
        let definition = Definition {
            head,
            body,
            conditions: conditions.to_vec(),
            place: place.clone(),
            line: self.line(span),
        };
        Rc::make_mut(&mut self.context).definitions.push(definition);
    }

    fn chain(&mut self, chain: &Chain, statement: &Statement) -> Vec<Finding> {
        let place = &statement.place;
        let mut findings: Vec<Finding> = (0..chain.relations.len()).map(|at| blank(chain, at)).collect();
        for (at, finding) in findings.iter_mut().enumerate() {
            let unread = chain.sides[at + 1].is_unread() || (at == 0 && chain.sides[0].is_unread());
            if unread {
                finding.verdict = Verdict::Unread;
                finding.reason = chain.problems.first().map(|problem| problem.message.clone());
            }
        }
        let checkable = |rel: Rel| {
            matches!(
                rel,
                Rel::Eq | Rel::Define | Rel::Equiv | Rel::Le | Rel::Lt | Rel::Ge | Rel::Gt | Rel::Ne
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
        let curve = refute::curve_spoken_of(&statement.before);
        let head =
            definable(&chain.sides[0].expr).filter(|_| matches!(chain.relations[0].0, Rel::Eq | Rel::Define));
        let first_known =
            head.as_ref().is_some_and(|head| self.is_known(head, &chain.sides[1].expr, place, &curve));
        let defines = chain.relations[0].0 == Rel::Define && !first_known;
        let mut start = 0;
        if let Some(head) = &head
            && (!first_known || defines)
            && !chain.sides[0].is_unread()
        {
            // A new name: its right-hand side says what it is.
            self.definition(chain, head, place, &mut findings[0]);
            start = 1;
        }
        if start < chain.relations.len() {
            self.judge(chain, start, statement, curve, head.as_ref(), &mut findings);
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
        // A derivative is not defined by a formula for it, nor f(t) by one in t_1, …, t_n.
        if head.parenthesized && head.arguments.is_some()
            || lint::missing_argument(head, &body.expr).is_some()
        {
            return;
        }
        self.define(head.clone(), Body::Formula(body.expr.clone()), &chain.conditions, place, body.expr.span);
    }

    /// Whether a name has a meaning already, so that an equation for it is a claim.
    fn is_known(&self, head: &Head, body: &Expr, place: &Place, curve: &Option<Curve>) -> bool {
        let standard = match head.base.as_str() {
            "B" => {
                head.arguments.is_some() && matches!(head.lower.len() + head.upper.len(), 2 | 4)
                    || head.arguments.is_none() && head.lower.len() + head.upper.len() == 2
            }
            "sigma" => head.lower.len() == 2 && head.arguments.is_some(),
            _ => false,
        };
        if standard {
            return true;
        }
        let count = head.flat().len();
        let defined = self.context.visible(&head.base, place).any(|(_, definition, _)| {
            definition.head.lower.len() == head.lower.len()
                && definition.head.upper.len() == head.upper.len()
                && (definition.head.arguments.is_some() == head.arguments.is_some())
        });
        if defined {
            return true;
        }
        if curve.as_ref().is_some_and(|curve| curve.points == head.base) && head.arguments.is_none() {
            return true;
        }
        let derived = head.parenthesized || matches!(head.base.as_str(), base if base.starts_with("dot"));
        if derived && head.arguments.is_some() {
            return true;
        }
        // The polar form of a function that is known, or that the right-hand side speaks of.
        let capital = super::model::capital_of(&head.base);
        let small = head.base.to_lowercase();
        let right = bases(body);
        if head.arguments.is_some() && capital != head.base {
            let of_known = self.context.visible(&capital, place).any(|(_, definition, _)| {
                definition.head.flat().len() == 1
                    && definition.head.lower.is_empty()
                    && definition.head.upper.is_empty()
            });
            let polar = count > 1 || curve.is_some();
            if polar
                && (of_known || curve.is_some() || right.contains(&capital) || right.contains(&head.base))
            {
                return true;
            }
            if of_known && count == 1 {
                return true;
            }
        }
        if head.arguments.is_none() && head.lower.is_empty() && capital != head.base {
            let of_known = self.context.visible(&capital, place).any(|(_, definition, _)| {
                definition.head.flat().len() == 1 && definition.head.lower.is_empty()
            });
            if of_known && self.context.letters.is_function(&head.base) {
                return true;
            }
        }
        if head.arguments.is_some() && small != head.base && count == 1 {
            // F(t) = f(t, …, t), F(t) = Σ F^{(i)}(τ) …
            return right.contains(&small) && self.context.letters.is_function(&small)
                || refute::calls(body, &head.base);
        }
        // A recursion defines; a function within its own formula does not.
        head.lower.is_empty()
            && head.upper.is_empty()
            && head.arguments.is_some()
            && refute::calls(body, &head.base)
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
        let best = self.attempts(&sides, &relations, chain, place, curve.clone());
        if let (Some(head), 0) = (head, start)
            && !refute::is_standard(Some(head))
        {
            findings[0].warning = lint::definition(head, &chain.sides[1].expr, &chain.conditions);
        }
        for (i, tally) in best.outcomes.tallies.iter().enumerate() {
            let at = start + i;
            if findings[at].verdict == Verdict::Unread {
                continue;
            }
            let from_start = at == 0;
            let verdict = self.verdict(tally, &best, chain, at, statement, head.filter(|_| from_start));
            match verdict {
                Judged::Verdict(finding) => {
                    let old = &findings[at];
                    let warning = match finding.verdict {
                        Verdict::Proved | Verdict::Sampled => finding.warning.clone(),
                        _ => finding.warning.clone().or(old.warning.clone()),
                    };
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
                Judged::Redefinition(warning) => {
                    if let Some(head) = head {
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
        // Equations for new coefficients say what these are.
        for (i, tally) in best.outcomes.tallies.iter().enumerate() {
            let at = start + i;
            if matches!(findings[at].verdict, Verdict::Undecided)
                && let [failure] = tally.fails.as_slice()
                && let Some(solution) = lint::unknowns(&self.context, place, &failure.left, &failure.right)
            {
                let names: Vec<String> = solution.iter().map(|(symbol, _)| symbol.to_string()).collect();
                for (symbol, value) in solution {
                    let expr = crate::value::symbol_expr(&symbol);
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
        let suggestions: Vec<(usize, Option<String>)> = findings
            .iter()
            .enumerate()
            .filter(|(at, finding)| *at >= start && finding.verdict == Verdict::Refuted)
            .map(|(at, _)| (at, super::repair::suggestion(self, chain, at, place, &curve, best.choices)))
            .collect();
        for (at, suggestion) in suggestions {
            findings[at].suggestion = suggestion;
        }
    }

    /// Tries the readings of ambiguous notations until one makes everything true; else the first.
    fn attempts(
        &self,
        sides: &[&Expr],
        relations: &[Rel],
        chain: &Chain,
        place: &Place,
        curve: Option<Curve>,
    ) -> Attempt {
        let run = |choices: Choices| -> Attempt {
            Attempt {
                outcomes: self.trial(sides, relations, chain, place, curve.clone(), choices).run(),
                choices,
            }
        };
        let first = run(Choices::default());
        let bad =
            |attempt: &Attempt| attempt.outcomes.tallies.iter().map(|tally| tally.fails.len()).sum::<usize>();
        let good =
            |attempt: &Attempt| attempt.outcomes.tallies.iter().map(|tally| tally.holds).sum::<usize>();
        if bad(&first) == 0 && good(&first) > 0 {
            return first;
        }
        let mut ambiguous = std::collections::BTreeSet::new();
        let mut far = false;
        for tally in &first.outcomes.tallies {
            ambiguous.extend(tally.record.ambiguous.iter().copied());
            far |= tally.record.definitions.iter().any(|(_, near)| !near);
        }
        let mut options = vec![Choices::default()];
        for ambiguity in ambiguous {
            let more: Vec<Choices> = options
                .iter()
                .map(|choices| {
                    let mut other = *choices;
                    match ambiguity {
                        Ambiguity::Binomial => other.total_above = true,
                        Ambiguity::Bernstein => other.degree_first = true,
                        Ambiguity::Power => other.powers = true,
                        Ambiguity::Spline => other.spline_degree = true,
                    }
                    other
                })
                .collect();
            options.extend(more);
        }
        if far {
            let more: Vec<Choices> =
                options.iter().map(|choices| Choices { near_only: true, ..*choices }).collect();
            options.extend(more);
        }
        // A formula with integers in it speaks of functions in general.
        let general = !first.outcomes.integers.is_empty()
            || first.outcomes.tallies.iter().any(|tally| tally.record.infinite);
        let examples = |attempt: &Attempt| {
            attempt.outcomes.tallies.iter().any(|tally| !tally.record.definitions.is_empty())
        };
        let mut best = first;
        if general && examples(&best) {
            let attempt = run(Choices { general: true, ..Choices::default() });
            if good(&attempt) + bad(&attempt) > 0 {
                best = attempt;
                for choices in &mut options {
                    choices.general = true;
                }
                if bad(&best) == 0 {
                    return best;
                }
            }
        }
        for choices in options.into_iter().skip(1) {
            let attempt = run(choices);
            if bad(&attempt) < bad(&best) && good(&attempt) >= good(&best)
                || bad(&attempt) == 0 && good(&attempt) > 0
            {
                best = attempt;
            }
            if bad(&best) == 0 {
                break;
            }
        }
        best
    }

    pub(super) fn trial<'a>(
        &self,
        sides: &[&'a Expr],
        relations: &[Rel],
        chain: &Chain,
        place: &'a Place,
        curve: Option<Curve>,
        choices: Choices,
    ) -> Trial<'a> {
        let mut earlier: Vec<&Condition> =
            self.context.conditions.iter().filter(|c| !chain.conditions.contains(&c.expr)).collect();
        // The nearest and latest first.
        earlier.sort_by_key(|condition| (place.sees(&condition.place), condition.line));
        earlier.reverse();
        Trial {
            sides: sides.to_vec(),
            relations: relations.to_vec(),
            conditions: chain.conditions.clone(),
            earlier: earlier.into_iter().map(|condition| condition.expr.clone()).collect(),
            context: self.context.clone(),
            place,
            curve,
            choices,
        }
    }

    fn verdict(
        &self,
        tally: &Tally,
        attempt: &Attempt,
        chain: &Chain,
        at: usize,
        statement: &Statement,
        head: Option<&Head>,
    ) -> Judged {
        let mut finding = blank(chain, at);
        let outcomes = &attempt.outcomes;
        finding.notes = self.notes(tally);
        let ranged = !outcomes.integers.is_empty() || outcomes.degrees || tally.record.infinite;
        let range = || {
            let mut names = outcomes.integers.join(", ");
            if names.is_empty() {
                names = "the degree".to_owned();
            }
            let largest = if outcomes.integers.is_empty() { 4 } else { outcomes.largest };
            format!("{names} from 0 to {largest}")
        };
        if tally.fails.is_empty() && tally.holds > 0 {
            finding.verdict = if ranged { Verdict::Sampled } else { Verdict::Proved };
            if ranged {
                finding.instances = Some(format!("{} instances: {}", tally.holds, range()));
                if tally.holds < 2 || (tally.holds_inner == 0 && !outcomes.integers.is_empty()) {
                    finding.verdict = Verdict::Undecided;
                    finding.reason = Some("too few instances make sense".to_owned());
                }
            }
            if let Some(number) = tally.condition {
                finding.notes.push(format!("uses an earlier condition (number {number})"));
            }
            if finding.verdict == Verdict::Sampled
                && let (left, right) = (&chain.sides[at].expr, &chain.sides[at + 1].expr)
                && matches!(chain.relations[at].0, Rel::Eq | Rel::Equiv | Rel::Define)
                && tally.record.definitions.is_empty()
                && tally.condition.is_none()
                && let Some(reason) = self.proof(left, right)
            {
                finding.verdict = Verdict::Proved;
                finding.reason = Some(reason);
            }
            return Judged::Verdict(Box::new(finding));
        }
        // Wrong only where an integer is 0: meant for positive ones.
        let positive = |integers: &[(String, i64)]| integers.iter().all(|(_, value)| *value > 0);
        if tally.holds_inner >= 2
            && !outcomes.integers.is_empty()
            && tally.fails.iter().all(|failure| !positive(&failure.integers))
            && chain.conditions.is_empty()
            && tally.fails.len() < tally.holds
        {
            finding.verdict = Verdict::Sampled;
            finding.reason = Some("true for positive integers".to_owned());
            finding.instances = Some(format!("{} instances: {}", tally.holds, range()));
            return Judged::Verdict(Box::new(finding));
        }
        finding.verdict = Verdict::Undecided;
        if tally.fails.is_empty() {
            let reason = tally
                .unclear
                .first()
                .cloned()
                .or_else(|| tally.errors.first().map(|error| error.message.clone()));
            if tally.record.mixed && tally.holds == 0 {
                finding.warning = tally.errors.first().map(|error| error.message.clone());
            }
            if outcomes.integers.len() > 8 {
                finding.reason = Some("too many integers without values".to_owned());
            } else {
                finding.reason = reason.or_else(|| Some("no instance makes sense".to_owned()));
            }
            // A new name whose formula cannot be computed is defined all the same.
            if head.is_some() && !chain.sides[1].is_unread() && !refute::is_standard(head) {
                return Judged::Redefinition(finding.warning);
            }
            return Judged::Verdict(Box::new(finding));
        }
        let refutation = refute::decide(self, tally, outcomes, chain, at, statement, head);
        match refutation {
            refute::Decision::Refuted { failure, reasons } => {
                finding.verdict = Verdict::Refuted;
                finding.reason = Some(reasons);
                finding.witness = refute::counterexample(&failure);
                if ranged {
                    finding.instances = Some(format!(
                        "fails in {} of {} instances: {}",
                        tally.fails.len(),
                        tally.fails.len() + tally.holds,
                        range()
                    ));
                }
            }
            refute::Decision::Redefinition(warning) => return Judged::Redefinition(warning),
            refute::Decision::Sampled(reason) => {
                finding.verdict = Verdict::Sampled;
                finding.reason = Some(reason);
                finding.instances = Some(format!("{} instances: {}", tally.holds, range()));
            }
            refute::Decision::Open(reason) => {
                finding.reason = Some(reason);
            }
        }
        Judged::Verdict(Box::new(finding))
    }

    fn proof(&self, _left: &Expr, _right: &Expr) -> Option<String> {
        None
    }

    fn notes(&self, tally: &Tally) -> Vec<String> {
        let mut notes: Vec<String> = tally.record.standard.iter().cloned().collect();
        for (number, _) in &tally.record.definitions {
            let definition = &self.context.definitions[*number];
            notes.push(format!("{} as defined in line {}", definition.head.base, definition.line));
        }
        for name in &tally.record.unknown {
            notes.push(format!("{name} is any polynomial"));
        }
        notes
    }
}

/// What comes of one relation.
enum Judged {
    Verdict(Box<Finding>),
    /// It defines its name anew.
    Redefinition(Option<String>),
}

/// The left side of a definition: a name, perhaps with indices, applied to distinct names.
fn definable(expr: &Expr) -> Option<Head> {
    let head = Head::of(expr)?;
    let simple = |index: &Expr| {
        matches!(index.kind, Kind::Name(_) | Kind::Number(_) | Kind::Text(_) | Kind::Accent(..))
    };
    if !head.lower.iter().chain(&head.upper).all(simple) {
        return None;
    }
    if matches!(head.base.as_str(), "Delta" | "nabla") {
        return None;
    }
    let mut names: Vec<String> = Vec::new();
    for argument in head.flat() {
        if argument.kind == Kind::Ellipsis {
            continue;
        }
        let own = Head::of(argument)?;
        if own.arguments.is_some() || !own.upper.is_empty() {
            return None;
        }
        let text = write::text(argument);
        if names.contains(&text) {
            return None;
        }
        names.push(text);
    }
    Some(head)
}

/// A finding for a relation, not judged yet.
pub(super) fn blank(chain: &Chain, at: usize) -> Finding {
    let (left, right) = (&chain.sides[at], &chain.sides[at + 1]);
    let (rel, sign) = chain.relations[at];
    let sign_text = write::latex(&Expr::relation(Expr::name("a"), rel, Expr::name("b")));
    let sign_text = sign_text.trim_start_matches('a').trim_end_matches('b').trim().to_owned();
    let reading = Expr::relation(left.expr.clone(), rel, right.expr.clone());
    Finding {
        span: left.expr.span.to(sign).to(right.expr.span),
        mark: sign,
        latex: format!("{} {} {}", left.latex, sign_text, right.latex),
        reading: write::latex(&reading),
        relation: at + 1,
        verdict: Verdict::Undecided,
        reason: None,
        witness: None,
        suggestion: None,
        instances: None,
        warning: None,
        notes: Vec::new(),
    }
}

fn of_side(side: &Side, verdict: Verdict, relation: usize) -> Finding {
    Finding {
        span: side.expr.span,
        mark: side.expr.span,
        latex: side.latex.clone(),
        reading: write::latex(&side.expr),
        relation,
        verdict,
        reason: None,
        witness: None,
        suggestion: None,
        instances: None,
        warning: None,
        notes: Vec::new(),
    }
}

/// Whether a relation holds in every instance that makes sense, and in some.
pub(super) fn all_hold(outcomes: &Outcomes) -> bool {
    outcomes.tallies.iter().all(|tally| tally.fails.is_empty() && tally.holds > 0)
}
