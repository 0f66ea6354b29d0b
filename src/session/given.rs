//! What a query may use: definitions, and conditions on the names of the claim, given beside it or in its own sentence,
//! `t^2 <= t for t in [0, 1]`, `F(t) where F(t) = t^2`.
//!
//! An equation that defines nothing is solved for one of its names, which then has that value; so
//! `a - b = 0` makes a the same as b. Other conditions are kept: a counterexample counts only where
//! they hold.

mod counterexamples;
mod intervals;

use std::collections::BTreeSet;
use std::sync::Arc;

use super::{Answer, Failure, Session, defines, guarded, read_in};
use crate::formula::source::{SourceFile, Span};
use crate::formula::{Enclosure, Expr, Kind, Link, Rel, call, interval, named, spread};
use crate::judge::check::asked;
use crate::judge::values::evaluator;
use crate::judge::values::inequality::{decided_in, positive};
use crate::judge::written::names::{Head, bases};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::{Env, Equals};
use crate::language::functions::builtin;
use crate::language::lexicon::letters;
use crate::language::syntax::{self, Sentence};
use crate::language::value::{Claim, Judgement, Value, Verdict};
use crate::language::write;
use crate::math::poly::{Fraction, Symbol};
use crate::math::ring::{Field, Ring};
use crate::session::given::counterexamples::refutations;
use num_traits::Signed;

/// A definition or a condition, where it stands.
#[derive(Clone)]
pub(super) struct Given {
    pub(super) file: SourceFile,
    pub(super) statement: Expr,
}

impl Given {
    /// The name that it defines, and its formula.
    pub(super) fn definition(&self) -> Option<(String, &Expr)> {
        match &self.statement.kind {
            Kind::Chain(left, links) if links[0].rel == Rel::Define => {
                Some((Head::of(left)?.base, &links[0].expr))
            }
            _ => None,
        }
    }
}

/// The conditions that are no equations, for the claims to which they apply.
#[derive(Default)]
pub struct Conditions {
    claims: Vec<Given>,
    judgements: Vec<Judgement>,
}

type Failed<T> = Result<T, Box<Failure>>;

impl Session {
    /// Runs the definitions in texts, and solves the conditions that are equations: `polarform check --given`.
    ///
    /// # Errors
    /// The problem of the first text that is neither a definition nor a condition that can be used.
    ///
    /// ```
    /// use polarform::session::Session;
    /// let mut session = Session::default();
    /// session.give(&["a + b = 1".to_owned()]).unwrap();
    /// assert_eq!(session.run("a + b").unwrap().outcome.value.as_int(), Some(1));
    /// ```
    pub fn give(&mut self, texts: &[String]) -> Failed<Conditions> {
        let start = self.env.clone();
        let (mut given, mut claims) = (Vec::new(), Vec::new());
        for (i, text) in texts.iter().enumerate() {
            let file = SourceFile::new(format!("<given {}>", i + 1), text.as_str());
            let fail = |problem| Box::new(Failure { problem, file: file.clone() });
            for span in syntax::statements(text).map_err(fail)? {
                let read = self.read(&file, span)?;
                for statement in self.given_in(read) {
                    let one = Given { file: file.clone(), statement: bounded(statement) };
                    // What comes later may need it to be read.
                    if self.supposed(&one)?.outcome.defined.is_none() {
                        claims.push(given.len());
                    }
                    given.push(one);
                }
            }
        }
        self.solve(start, &given, claims)
    }

    /// The parts of what is given: definitions side by side, or conditions.
    fn given_in(&self, read: Expr) -> Vec<Expr> {
        let said = match &read.kind {
            Kind::Sequence(items) => spread(items.clone()),
            _ => Vec::new(),
        };
        let conditions = said.iter().all(|item| match &item.kind {
            Kind::Chain(_, links) => links.iter().all(|link| !matches!(link.rel, Rel::Eq | Rel::Define)),
            _ => false,
        });
        if conditions && !said.is_empty() { said } else { self.statements_in(read, Equals::DefinesUnbound) }
    }

    fn take(&mut self, given: &[Given]) -> Failed<Conditions> {
        let start = self.env.clone();
        let claims = self.suppose(given)?;
        self.solve(start, given, claims)
    }

    /// Runs what is given; the numbers of what defined nothing.
    fn suppose(&mut self, given: &[Given]) -> Failed<Vec<usize>> {
        let mut claims = Vec::new();
        for (at, one) in given.iter().enumerate() {
            if self.supposed(one)?.outcome.defined.is_none() {
                claims.push(at);
            }
        }
        Ok(claims)
    }

    /// Solves those of the claims that are equations, after all that is given has run from the start.
    fn solve(&mut self, start: Env, given: &[Given], mut claims: Vec<usize>) -> Failed<Conditions> {
        let mut solved: Vec<(Symbol, Fraction)> = Vec::new();
        loop {
            let (mut equation, mut others, mut judgements) = (None, Vec::new(), Vec::new());
            for one in claims.iter().map(|&at| &given[at]) {
                let answer = self.supposed(one)?;
                let Value::Claim(claim) = &answer.outcome.value else { continue };
                for judgement in claim.judgements.iter().filter(|judgement| !holds(judgement)) {
                    match judgement.rel {
                        Rel::Eq | Rel::Equiv if equation.is_none() => {
                            equation = Some((judgement.clone(), answer.clone()));
                        }
                        Rel::Eq | Rel::Equiv => {}
                        _ => {
                            others.push(one.clone());
                            judgements.push(judgement.clone());
                        }
                    }
                }
            }
            let Some((equation, answer)) = equation else {
                return Ok(Conditions { claims: others, judgements });
            };
            let value = solution(&equation, &judgements).ok_or_else(|| unused(&answer))?;
            // A function that was defined before keeps its symbols.
            if solved.iter().any(|(name, _)| *name == value.0) {
                return Err(unused(&answer));
            }
            solved.push(value);
            self.env = with(&start, &solved);
            claims = self.suppose(given)?;
        }
    }

    /// Reads a part of a file as one formula, with the names of the session and under its limits.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn read(&self, file: &SourceFile, span: Span) -> Failed<Expr> {
        guarded(&self.limits, || read_in(&self.env, file, Some(span)))
            .map_err(|problem| Box::new(Failure { problem, file: file.clone() }))
    }

    fn supposed(&mut self, given: &Given) -> Failed<Answer> {
        let mut statement = given.statement.clone();
        let outcome = self.evaluate(&mut statement, Equals::DefinesUnbound);
        match outcome {
            Ok(outcome) => Ok(Answer { statement, outcome, file: given.file.clone() }),
            Err(problem) => {
                let problem = problem.at(statement.span);
                Err(Box::new(Failure { problem, file: given.file.clone() }))
            }
        }
    }

    /// Answers the formula of a sentence under its conditions, which end with it; `None` if its words are not those of
    /// conditions.
    pub(super) fn run_sentence(
        &mut self,
        file: &SourceFile,
        sentence: &Sentence,
        equals: Equals,
    ) -> Failed<Option<Vec<Answer>>> {
        self.run_said(file, sentence, None, equals)
    }

    /// The same, with another formula than the one that stands there if words say more of that: t^2 + 1 is positive.
    pub(super) fn run_said(
        &mut self,
        file: &SourceFile,
        sentence: &Sentence,
        meant: Option<Expr>,
        equals: Equals,
    ) -> Failed<Option<Vec<Answer>>> {
        let fail = |problem| Box::new(Failure { problem, file: file.clone() });
        let mut given = Vec::new();
        let formula = match &meant {
            Some(meant) => meant.clone(),
            None => self.read(file, sentence.formula)?,
        };
        // \textbf{Claim.} For all n, ...
        if matches!(formula.kind, Kind::Text(_)) {
            return Ok(None);
        }
        let (mut items, mut free) = (Vec::new(), Vec::new());
        for (span, all) in &sentence.conditions {
            let read =
                self.read(file, *span).or_else(|failure| self.half_open(file, *span).ok_or(failure))?;
            let own = match read.kind {
                Kind::Sequence(items) => items,
                _ => vec![read],
            };
            free.extend(own.iter().filter(|_| *all).map(|item| item.span));
            items.extend(own.into_iter().flat_map(each_equal));
        }
        let items = self.with_products(&bases(&formula), items);
        for item in spread(items) {
            match &item.kind {
                // for all t, u
                Kind::Name(_) | Kind::Subscript(..) if free.contains(&item.span) => {}
                // t^2 <= t on [0, 1]
                _ if interval(&item).is_some() && matches!(formula.kind, Kind::Chain(..)) => {
                    let name = self.only_variable(&formula, item.span).map_err(fail)?;
                    let span = item.span;
                    let within = Expr { span, ..Expr::relation(Expr { span, ..name }, Rel::In, item) };
                    given.push(Given { file: file.clone(), statement: bounded(within) });
                }
                Kind::Chain(..) => {
                    let statement = bounded(value_given(item).map_err(fail)?);
                    given.push(Given { file: file.clone(), statement });
                }
                _ => return Ok(None),
            }
        }
        no_name_twice(&given).map_err(fail)?;
        let asks = |expr: &Expr| matches!(expr.kind, Kind::Chain(..));
        let several = matches!(&formula.kind, Kind::Sequence(items)
            if items.iter().all(|item| asks(item) || matches!(item.kind, Kind::Text(_))));
        if sentence.asked && !asks(&formula) && !several {
            return Ok(None);
        }
        let late = self.late(&formula, &mut given);
        uses_all(&formula, &given).map_err(fail)?;
        let mut there = self.clone();
        let conditions = there.take(&in_order(given))?;
        let equals = if sentence.asked { Equals::Claims } else { equals };
        let mut answers = match late.or(meant) {
            None => there.run_part(file, sentence.formula, equals)?,
            Some(formula) => vec![there.evaluated(file, formula, equals, false)?],
        };
        for answer in &mut answers {
            match &answer.outcome.value {
                Value::Claim(claim) => {
                    let claim = conditions.applied(&there, claim);
                    let said: Vec<Expr> = conditions.claims.iter().map(|one| one.statement.clone()).collect();
                    let claim = asked::under_conditions(&answer.statement, &said, &self.env, claim);
                    answer.outcome.value = Value::Claim(Arc::new(claim));
                }
                _ => conditions.are_for_claims().map_err(fail)?,
            }
        }
        for name in
            answers.iter().filter_map(|answer| answer.outcome.defined.clone()).chain([Symbol::new("ans")])
        {
            if let Some(value) = there.env.get(&name) {
                self.env.set(name, value.clone());
            }
        }
        Ok(Some(answers))
    }
}

impl Session {
    /// Conditions in which a word is the product of its letters, if these are names of the formula: xy = 1 beside x + y.
    pub(super) fn with_products(&self, used: &BTreeSet<String>, items: Vec<Expr>) -> Vec<Expr> {
        let machine = evaluator::machine_in(&self.env);
        let is_product = |word: &String| {
            let letters: Vec<String> = word.chars().map(String::from).collect();
            letters.len() > 1
                && !used.contains(word)
                && letters.iter().all(|letter| used.contains(letter))
                && machine.is_product_of_letters(word)
        };
        let product = |word: &str| {
            let letters = word.chars().map(|letter| Expr::name(letter.to_string())).collect();
            Expr::product(letters)
        };
        let put_in = |item: Expr| {
            let words: Vec<String> = bases(&item).into_iter().filter(is_product).collect();
            words.into_iter().fold(item, |item, word| {
                let span = item.span;
                Expr { span, ..item.with_name(&word, &product(&word)) }
            })
        };
        items.into_iter().map(put_in).collect()
    }

    /// The one symbol of a claim, which runs through an interval.
    fn only_variable(&self, claim: &Expr, place: Span) -> Result<Expr, Diagnostic> {
        let symbol = |name: &String| !defines(&self.env, name) && builtin(name).is_none();
        let names: Vec<String> = bases(claim).into_iter().filter(symbol).collect();
        match names.as_slice() {
            [name] => Ok(Expr::name(name)),
            _ => Err(Diagnostic::error(Code::Usage, "which name runs through this interval?")
                .at(place)
                .reason("it is said of none")
                .hint("write for t in [0, 1]")),
        }
    }

    /// The formula with the values put in that are given for symbols of functions defined before: G(3) with a = 1/2 after
    /// G(t) = t^2 + a. These are no longer among what is given.
    fn late(&self, formula: &Expr, given: &mut Vec<Given>) -> Option<Expr> {
        let used = bases(formula);
        let own = |one: &Given| one.definition().map(|(name, _)| name).filter(|name| !used.contains(name));
        if matches!(formula.kind, Kind::Chain(..)) || !given.iter().any(|one| own(one).is_some()) {
            return None;
        }
        let outcome = self.clone().evaluate(&mut formula.clone(), Equals::Claims).ok()?;
        let symbols = match &outcome.value {
            Value::Scalar(formula) => formula.variables(),
            _ => return None,
        };
        let is_late = |one: &Given| {
            own(one)
                .is_some_and(|name| symbols.iter().any(|symbol| symbol.is_plain() && symbol.base() == name))
        };
        let mut arguments = vec![formula.clone()];
        arguments.extend(given.extract_if(.., |one| is_late(one)).filter_map(|one| {
            let (name, value) = one.definition()?;
            Some(named(&name, value.clone()))
        }));
        (arguments.len() > 1).then(|| call("subs", arguments, formula.span))
    }
}

/// What is said of each name in a = d = 1.
pub(super) fn each_equal(item: Expr) -> Vec<Expr> {
    let Kind::Chain(first, links) = &item.kind else { return vec![item] };
    let name = |expr: &Expr| matches!(expr.kind, Kind::Name(_) | Kind::Subscript(..));
    let Some((last, between)) = links.split_last() else { return vec![item] };
    let names: Vec<&Expr> =
        std::iter::once(first.as_ref()).chain(between.iter().map(|link| &link.expr)).collect();
    if between.is_empty()
        || links.iter().any(|link| link.rel != Rel::Eq)
        || !names.iter().all(|expr| name(expr))
    {
        return vec![item];
    }
    let one =
        |name: &Expr| Expr { span: item.span, ..Expr::relation(name.clone(), Rel::Eq, last.expr.clone()) };
    names.into_iter().map(one).collect()
}

/// Refuses two values for one name: t^2 at t = 1 and t = 2.
fn no_name_twice(given: &[Given]) -> Result<(), Diagnostic> {
    let mut seen: Vec<String> = Vec::new();
    for one in given.iter().filter(|one| one.definition().is_some()) {
        let Kind::Chain(left, _) = &one.statement.kind else { continue };
        let name = write::text(left);
        if seen.contains(&name) {
            return Err(Diagnostic::error(Code::Usage, format!("two values for {name}"))
                .at(one.statement.span)
                .reason("it has one already")
                .hint("ask for each by itself, or for a list: [t^2 for t = 0..2]"));
        }
        seen.push(name);
    }
    Ok(())
}

/// Refuses a value for a name that occurs nowhere: a curve at t = 1/2.
fn uses_all(formula: &Expr, given: &[Given]) -> Result<(), Diagnostic> {
    for (at, one) in given.iter().enumerate() {
        let Some((name, _)) = one.definition() else { continue };
        let others =
            given.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, other)| &other.statement);
        // f(0, 1) for F(t) = t^2
        let names = |base: &String| *base == name || letters::capital(base).as_ref() == Some(&name);
        if !std::iter::once(formula).chain(others).any(|part| bases(part).iter().any(names)) {
            return Err(Diagnostic::error(Code::Usage, format!("{name} does not occur in the formula"))
                .at(one.statement.span)
                .reason("this value changes nothing")
                .hint("a function or a curve c has its value c(1/2)"));
        }
    }
    Ok(())
}

/// What a definition uses goes before it: F(t) = t^2 + a and a = 1.
pub(super) fn in_order(mut given: Vec<Given>) -> Vec<Given> {
    let mut ordered = Vec::new();
    while !given.is_empty() {
        let names: Vec<Option<String>> =
            given.iter().map(|one| one.definition().map(|(name, _)| name)).collect();
        let is_ready = |one: &Given| match one.definition() {
            Some((own, body)) => {
                let used = bases(body);
                names.iter().flatten().all(|name| *name == own || !used.contains(name))
            }
            None => names.iter().all(Option::is_none),
        };
        let next = given.iter().position(is_ready).unwrap_or(0);
        ordered.push(given.remove(next));
    }
    ordered
}

/// A formula with the values of its names after it: Σ_{i=0}^n i, n = 4.
pub(super) fn beside(statement: &Expr) -> Option<Sentence> {
    let Kind::Sequence(items) = &statement.kind else { return None };
    let (formula, values) = items.split_first()?;
    // a claim and its condition in parentheses: \quad (n \ge 1)
    let condition = |item: &Expr| match &item.kind {
        Kind::Group(inner) if matches!(inner.kind, Kind::Chain(..)) => Some((inner.span, false)),
        _ => None,
    };
    if matches!(formula.kind, Kind::Chain(..))
        && !values.is_empty()
        && let Some(conditions) = values.iter().map(condition).collect::<Option<Vec<_>>>()
    {
        return Some(Sentence { formula: formula.span, conditions, asked: false });
    }
    let used = bases(formula);
    let value = |item: &Expr| match &item.kind {
        Kind::Chain(left, links) => {
            let name = matches!(&left.kind, Kind::Name(name) if used.contains(name));
            name && matches!(links.as_slice(), [Link { rel: Rel::Eq | Rel::Define, .. }])
        }
        _ => false,
    };
    let beside = !matches!(formula.kind, Kind::Chain(..)) && !values.is_empty() && values.iter().all(value);
    let conditions = values.iter().map(|item| (item.span, false)).collect();
    beside.then_some(Sentence { formula: formula.span, conditions, asked: false })
}

/// `t = 2` beside a formula gives t its value here, whatever it was before.
fn value_given(mut statement: Expr) -> Result<Expr, Diagnostic> {
    let Kind::Chain(left, links) = &mut statement.kind else { return Ok(statement) };
    let name = |expr: &Expr| matches!(expr.kind, Kind::Name(_) | Kind::Subscript(..));
    let named = match &left.kind {
        Kind::Apply(callee, groups) => name(callee) && groups.iter().flatten().all(name),
        _ => name(left),
    };
    if let [link @ Link { rel: Rel::Eq, .. }] = links.as_mut_slice()
        && named
    {
        if matches!(link.expr.kind, Kind::Range(..)) {
            let list = format!("for a list write [... for {}]", write::text(&statement));
            return Err(Diagnostic::error(Code::Type, "several values at once")
                .at(statement.span)
                .hint(list));
        }
        link.rel = Rel::Define;
    }
    Ok(statement)
}

/// t ∈ [a, b] as a ≤ t ≤ b.
fn bounded(statement: Expr) -> Expr {
    let Kind::Chain(left, links) = &statement.kind else { return statement };
    // |x| < 1
    if let (Kind::Enclosed(Enclosure::Abs, inner), [link @ Link { rel: Rel::Lt | Rel::Le, .. }]) =
        (&left.kind, links.as_slice())
    {
        let links = vec![Link { expr: (**inner).clone(), ..link.clone() }, link.clone()];
        return Expr::new(Kind::Chain(Box::new(link.expr.clone().negated()), links), statement.span);
    }
    let [Link { rel: Rel::In, span, expr }] = links.as_slice() else { return statement };
    let Some(([from, to], open)) = interval(expr) else { return statement };
    let link = |open: bool, expr: &Expr| Link {
        rel: if open { Rel::Lt } else { Rel::Le },
        span: *span,
        expr: expr.clone(),
    };
    let links = vec![link(open[0], left), link(open[1], to)];
    Expr::new(Kind::Chain(Box::new(from.clone()), links), statement.span)
}

impl Conditions {
    /// The claim, where conditions hold: a counterexample that they exclude is none.
    pub fn applied(&self, session: &Session, claim: &Claim) -> Claim {
        let judged = |judgement: &Judgement| {
            if !holds(judgement) && self.judgements.iter().any(|condition| follows(judgement, condition)) {
                let reasons = vec!["it follows from a condition".to_owned()];
                return Judgement { verdict: Verdict::Proved, witness: None, reasons, ..judgement.clone() };
            }
            if !holds(judgement)
                && let Some(decided) = decided_in(judgement, &self.judgements)
                && (holds(&decided) || decided.witness.is_none() || self.allow(session, &decided))
            {
                return decided;
            }
            let open = !holds(judgement) && judgement.witness.is_some();
            if self.claims.is_empty() || !open || self.allow(session, judgement) {
                return judgement.clone();
            }
            let mut others = refutations(judgement, &self.judgements);
            if let Some(refuted) = others.find(|refuted| self.allow(session, refuted)) {
                return refuted;
            }
            let reason = "a counterexample was found, but a condition excludes it".to_owned();
            Judgement {
                verdict: Verdict::Undecided,
                witness: None,
                reasons: vec![reason],
                ..judgement.clone()
            }
        };
        Claim { judgements: claim.judgements.iter().map(judged).collect() }
    }

    /// Whether all conditions hold at the counterexample.
    fn allow(&self, session: &Session, judgement: &Judgement) -> bool {
        let Some(witness) = &judgement.witness else { return false };
        let mut there = session.clone();
        for (name, value) in &witness.assignment {
            there.env.set(name.clone(), Value::number(value.clone()));
        }
        self.claims.iter().all(|given| {
            there.supposed(given).is_ok_and(|answer| match &answer.outcome.value {
                Value::Claim(claim) => claim.decided() == Some(true),
                _ => true,
            })
        })
    }

    /// Refuses an inequality beside a value or a definition.
    fn are_for_claims(&self) -> Result<(), Diagnostic> {
        let Some(first) = self.claims.first() else { return Ok(()) };
        Err(Diagnostic::error(Code::Usage, "this condition is for claims only")
            .at(first.statement.span)
            .reason("a value does not depend on it")
            .hint("leave it out, or give a name its value: t^2 for t = 2")
            .hint("a function by cases is cases(t^2 if t < 1, 2t - 1 otherwise)"))
    }
}

/// Whether an inequality follows from another one: d = k c + m with k > 0 and m ≥ 0.
fn follows(claim: &Judgement, condition: &Judgement) -> bool {
    let (Some((d, strict)), Some((c, given))) = (positive(claim), positive(condition)) else { return false };
    let Some(name) = c.variables().into_iter().next() else { return false };
    let factor =
        c.derivative(&name).inverse().and_then(|slope| d.derivative(&name).times(&slope).as_rational());
    let Some(factor) = factor.filter(|factor| factor.is_positive()) else { return false };
    d.minus(&c.scaled(&factor))
        .as_rational()
        .is_some_and(|rest| rest.is_positive() || num_traits::Zero::is_zero(&rest) && (given || !strict))
}

fn holds(judgement: &Judgement) -> bool {
    matches!(judgement.verdict, Verdict::Proved | Verdict::Sampled)
}

fn with(start: &Env, solved: &[(Symbol, Fraction)]) -> Env {
    let mut env = start.clone();
    // Later solutions stand in earlier ones.
    let mut values: Vec<(Symbol, Fraction)> = Vec::new();
    for (name, value) in solved {
        for (_, known) in &mut values {
            if let Ok(put_in) = known.substitute(&[(name.clone(), value.clone())]) {
                *known = put_in;
            }
        }
        values.push((name.clone(), value.clone()));
    }
    for (name, value) in values {
        env.set(name, Value::Scalar(value));
    }
    env
}

/// A name with the value that the equation gives it: one that occurs with a number before it, or with a name that is not 0.
fn solution(judgement: &Judgement, conditions: &[Judgement]) -> Option<(Symbol, Fraction)> {
    let Some(Value::Scalar(difference)) = &judgement.difference else { return None };
    let equation = difference.numerator();
    let solved = |name: &Symbol, allowed: &dyn Fn(&Fraction) -> bool| {
        if equation.degree_in(name) != 1 {
            return None;
        }
        let parts = equation.coefficients_in(name);
        let factor = Fraction::from(parts.get(1)?.clone());
        let rest = Fraction::from(parts[0].clone());
        let inverse = factor.inverse().filter(|_| allowed(&factor))?;
        Some((name.clone(), -(rest.times(&inverse))))
    };
    let names = equation.variables();
    let number = |factor: &Fraction| factor.as_rational().is_some();
    let not_zero = |factor: &Fraction| conditions.iter().any(|condition| excludes_zero(condition, factor));
    names
        .iter()
        .find_map(|name| solved(name, &number))
        .or_else(|| names.iter().find_map(|name| solved(name, &not_zero)))
}

/// Whether a factor c t is not 0 where a condition holds: t > 0, t != 0.
fn excludes_zero(condition: &Judgement, factor: &Fraction) -> bool {
    let difference = match (condition.rel, positive(condition)) {
        (_, Some((difference, true))) => difference,
        (Rel::Ne, _) => match (condition.left.as_scalar(), condition.right.as_scalar()) {
            (Some(left), Some(right)) => left.minus(right),
            _ => return false,
        },
        _ => return false,
    };
    let quotient = difference.inverse().map(|inverse| factor.times(&inverse));
    quotient.is_some_and(|quotient| quotient.as_rational().is_some())
}

/// The error for a condition that cannot be used.
fn unused(answer: &Answer) -> Box<Failure> {
    let problem = Diagnostic::error(Code::Undecided, "this condition cannot be solved for one of its names")
        .at(answer.statement.span)
        .reason("neither a definition nor a linear equation")
        .hint("write it as a definition, for example a := 1 - b")
        .hint(format!("solve({}) gives the values for which it holds", write::text(&answer.statement)));
    Box::new(Failure { problem, file: answer.file.clone() })
}

/// Whether it says that two things are equal.
pub(super) fn is_equation(expr: &Expr) -> bool {
    matches!(&expr.kind, Kind::Chain(_, links) if matches!(links.as_slice(), [Link { rel: Rel::Eq, .. }]))
}
