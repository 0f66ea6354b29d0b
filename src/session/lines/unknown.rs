//! A function that linear conditions determine: values, derivatives, polar values.

use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Link, Rel, Sign, Term, applied, call, named};
use crate::judge::written::names::bases;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Equals;
use crate::language::functions::function_called;
use crate::language::syntax::{self, Unknown};
use crate::language::value::Value;
use crate::session::{Answer, Failure, Session, defines, guarded, items_in, read_as};

/// A value of a derivative, or of a polar form.
struct Condition {
    name: String,
    order: u32,
    arguments: Vec<Expr>,
    value: Expr,
}

impl Condition {
    fn of(item: Expr) -> Option<Condition> {
        let Kind::Chain(left, links) = item.kind else { return None };
        let [Link { rel: Rel::Eq, expr: value, .. }] = links.as_slice() else { return None };
        let Kind::Apply(callee, groups) = left.kind else { return None };
        let [arguments] = groups.as_slice() else { return None };
        let (callee, order) = match callee.kind {
            Kind::Prime(inner, order) => (*inner, order),
            _ => (*callee, 0),
        };
        let Kind::Name(name) = callee.kind else { return None };
        Some(Condition { name, order, arguments: arguments.clone(), value: value.clone() })
    }

    /// What the coefficient of t^k is multiplied by.
    fn factor(&self, k: u32) -> Option<Expr> {
        if let [at] = self.arguments.as_slice() {
            let Some(rest) = k.checked_sub(self.order) else { return Some(Expr::int(0)) };
            let falling =
                (rest + 1..=k).try_fold(1_i64, |product, factor| product.checked_mul(factor.into()))?;
            return Some(match rest {
                0 => Expr::int(falling),
                _ => Expr::product(vec![
                    Expr::int(falling),
                    at.clone().grouped().power(Expr::int(rest.into())),
                ]),
            });
        }
        let degree = i64::try_from(self.arguments.len()).ok()?;
        let arguments =
            [Expr::int(k.into()), Expr::int(degree)].into_iter().chain(self.arguments.iter().cloned());
        Some(call("sigma", arguments.collect(), Span::default()))
    }
}

impl Session {
    /// Answers what is asked about a function that is given by conditions; `None` if nothing of the kind is said.
    pub(in crate::session) fn run_unknown(
        &mut self,
        file: &SourceFile,
        whole: Span,
        equals: Equals,
    ) -> Result<Option<Vec<Answer>>, Box<Failure>> {
        let known = |word: &str| defines(&self.env, word);
        let Some(unknown) = syntax::unknown(file.slice(whole), &known, &function_called) else {
            return Ok(None);
        };
        let fail = |problem: Diagnostic| Box::new(Failure { problem: problem.at(whole), file: file.clone() });
        let mut conditions = Vec::new();
        for span in &unknown.conditions {
            let span = span.shifted(whole.start);
            let items = guarded(&self.limits, || items_in(&self.env, file, span)).map_err(fail)?;
            for item in items {
                // F(0, 0) = 1, F(0, 1) = 2, F symmetric
                if matches!((&item.kind, conditions.first()), (Kind::Name(own), Some(Condition { name, .. })) if own == name)
                {
                    continue;
                }
                let Some(condition) = Condition::of(item) else { return Ok(None) };
                conditions.push(condition);
            }
        }
        let Some(degree) = degree(&unknown, &conditions).map_err(fail)? else { return Ok(None) };
        let Some((matrix, right)) = system(&conditions, degree) else { return Ok(None) };
        let mut there = self.clone();
        let mut solved = Expr { span: whole, ..call("solve", vec![matrix, right], whole) };
        let solution = there.evaluate(&mut solved, Equals::Claims).map_err(|problem| {
            fail(match problem.code {
                Code::Singular => undetermined(&conditions),
                _ => problem,
            })
        })?;
        let Value::List(coefficients) = solution.value else { return Ok(None) };
        let coefficients = coefficients.iter().map(Value::to_expr).collect::<Vec<_>>();
        let letter = Expr { span: whole, ..Expr::name(free_letter(&coefficients)) };
        let mut polynomial = polynomial(coefficients, &letter);
        polynomial.span = whole;
        let polynomial = there.evaluate(&mut polynomial, Equals::Claims).map_err(fail)?.value.to_expr();
        let definition = definition(&conditions, polynomial, letter, whole);
        let note = read_as(&definition, whole);
        let mut answers = vec![there.evaluated(file, definition, Equals::DefinesUnbound, false)?];
        if let Some(form) = unknown.form {
            let name = Expr { span: whole, ..Expr::name(conditions[0].name.as_str()) };
            answers = vec![there.evaluated(file, call(form, vec![name], whole), Equals::Claims, false)?];
        }
        if let Some(asked) = unknown.asked {
            answers = there.run_part(file, asked.shifted(whole.start), equals)?;
        }
        if let Some(first) = answers.first_mut() {
            first.outcome.notes.insert(0, note);
        }
        self.env = there.env;
        Ok(Some(answers))
    }
}

/// The degree, if the conditions are about one function and as many as its coefficients.
fn degree(unknown: &Unknown, conditions: &[Condition]) -> Result<Option<u32>, Diagnostic> {
    let Some(first) = conditions.first() else { return Ok(None) };
    let count = first.arguments.len();
    let alike = |one: &Condition| {
        one.name == first.name && one.arguments.len() == count && (count == 1 || one.order == 0)
    };
    // f(a, b) = f(b, a) is a law.
    let own = |one: &Condition| {
        one.arguments.iter().chain([&one.value]).any(|part| bases(part).contains(&first.name))
    };
    if count == 0 || conditions.len() < 2 || !conditions.iter().all(alike) || conditions.iter().any(own) {
        return Ok(None);
    }
    let own = i64::try_from(count).ok().filter(|_| count > 1);
    let small = i64::try_from(conditions.len() - 1).ok().filter(|_| unknown.interpolates);
    let Some(degree) = unknown.degree.or(own).or(small) else { return Ok(None) };
    if own.is_some_and(|own| own != degree) {
        return Ok(None);
    }
    let needed = degree.checked_add(1).and_then(|needed| usize::try_from(needed).ok());
    if needed != Some(conditions.len()) {
        let message =
            format!("{} conditions for {} coefficients of {}", conditions.len(), degree + 1, first.name);
        return Err(Diagnostic::error(Code::Usage, message)
            .reason(format!("a polynomial of degree {degree} has {} coefficients", degree + 1))
            .hint(format!("give {} conditions", degree + 1)));
    }
    Ok(u32::try_from(degree).ok())
}

/// The linear equations for the power coefficients.
fn system(conditions: &[Condition], degree: u32) -> Option<(Expr, Expr)> {
    let list = |items: Vec<Expr>| Expr::new(Kind::List(items), Span::default());
    let row = |condition: &Condition| {
        (0..=degree).map(|k| condition.factor(k)).collect::<Option<Vec<_>>>().map(list)
    };
    let rows = conditions.iter().map(row).collect::<Option<Vec<_>>>()?;
    Some((list(rows), list(conditions.iter().map(|one| one.value.clone()).collect())))
}

fn undetermined(conditions: &[Condition]) -> Diagnostic {
    let name = conditions.first().map_or("f", |one| one.name.as_str());
    Diagnostic::error(Code::Singular, format!("the conditions do not determine {name}"))
        .reason("one follows from the others, or contradicts them")
        .hint("give conditions that are independent of each other")
}

/// A letter that is not among the coefficients.
fn free_letter(coefficients: &[Expr]) -> &'static str {
    let used: Vec<String> = coefficients.iter().flat_map(bases).collect();
    ["t", "x", "u", "s", "v"]
        .into_iter()
        .find(|letter| !used.iter().any(|name| name == letter))
        .unwrap_or("tau")
}

/// c_0 + c_1 t + ...
fn polynomial(coefficients: Vec<Expr>, letter: &Expr) -> Expr {
    let term = |(k, coefficient): (usize, Expr)| {
        let power = letter.clone().power(Expr::int(i64::try_from(k).unwrap_or(i64::MAX)));
        let factors = std::iter::once(coefficient.grouped()).chain((k > 0).then_some(power)).collect();
        Term { sign: Sign::Plus, expr: Expr::product(factors) }
    };
    Expr::sum(coefficients.into_iter().enumerate().map(term).collect())
}

/// p(t) := ..., or f := polar(..., degree=n)
fn definition(conditions: &[Condition], polynomial: Expr, letter: Expr, span: Span) -> Expr {
    let (name, count) = conditions.first().map_or(("f", 1), |one| (one.name.as_str(), one.arguments.len()));
    let name = Expr { span, ..Expr::name(name) };
    let (left, right) = match count {
        1 => (applied(name, vec![letter], span), polynomial),
        _ => {
            let degree = Expr { span, ..Expr::int(i64::try_from(count).unwrap_or(i64::MAX)) };
            let arguments = vec![polynomial, named("degree", degree), named("variable", letter)];
            (name, call("polar", arguments, span))
        }
    };
    Expr { span, ..Expr::relation(left, Rel::Define, right) }
}
