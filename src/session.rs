//! One input, one outcome: reading, evaluating under limits, keeping or dropping the result.
//!
//! A statement is evaluated against a copy of the names (copies are cheap) and its definition
//! is kept only when everything went well: a failed line changes nothing.

mod foreign;
mod given;
mod hints;
mod lines;
mod spoken;

use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::budget::{self, Limits, Stop};
use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind};
use crate::judge::check::asked;
use crate::judge::values::evaluator;
use crate::judge::written::ambiguous;
use crate::language::derive::shows_negative_value;
use crate::language::diagnostic::{Code, Diagnostic, is_left_over, may_be_of_words};
use crate::language::eval::{self, Env, Equals, Outcome};
use crate::language::functions::Arrangement;
use crate::language::lexicon::{asking, signs, words};
use crate::language::value::{Value, symbol_expr};
use crate::language::{latex, syntax, write};
use crate::math::poly::Symbol;

pub use given::Conditions;
pub use hints::completion::{Candidate, completions};

/// A statement that failed, with the text it was read from.
#[derive(Clone, Debug)]
pub struct Failure {
    /// What is wrong.
    pub problem: Diagnostic,
    /// Where it was read.
    pub file: SourceFile,
}

/// The outcome of one statement, with the text it was read from.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The statement as read.
    pub statement: Expr,
    /// What it did.
    pub outcome: Outcome,
    /// Where it was read.
    pub file: SourceFile,
}

impl Answer {
    /// What the value is called where it is shown: polar forms always have a name, other values if they
    /// are defined here.
    pub fn name(&self) -> Option<Expr> {
        match &self.outcome.value {
            Value::Polar(_) => Some(self.function_name()),
            _ => self.outcome.defined.as_ref().map(symbol_expr),
        }
    }

    /// What a function is called where it is shown: as it is defined here, or by the name that was asked
    /// for; f if it has none.
    pub fn function_name(&self) -> Expr {
        match (&self.outcome.defined, &self.statement.kind) {
            (Some(name), _) => symbol_expr(name),
            (None, Kind::Name(_) | Kind::Subscript(..)) => self.statement.clone(),
            (None, _) => Expr::name("f"),
        }
    }
}

/// Names and limits of a sequence of statements.
///
/// ```
/// use polarform::session::Session;
/// let mut session = Session::default();
/// session.run("f := polar(t^2 + 2t)").unwrap();
/// let answer = session.run("f(0, 1)").unwrap();
/// assert_eq!(answer.outcome.value.as_int(), Some(1));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Session {
    /// The names defined so far.
    pub env: Env,
    /// The limits of each statement.
    pub limits: Limits,
    /// How answers are arranged.
    pub arrangement: Arrangement,
}

impl Session {
    /// A session with the given limits.
    pub fn new(limits: Limits) -> Self {
        Session { limits, ..Session::default() }
    }

    /// Runs one statement given as text.
    ///
    /// # Errors
    /// The problem with its place; the session is as before.
    pub fn run(&mut self, text: &str) -> Result<Answer, Box<Failure>> {
        self.run_statement(&SourceFile::new("<query>", text), None, Equals::DefinesUnbound)
    }

    /// Runs a part of a file (or all of it) as one statement.
    ///
    /// # Errors
    /// As for [`Session::run`].
    pub fn run_statement(
        &mut self,
        file: &SourceFile,
        part: Option<Span>,
        equals: Equals,
    ) -> Result<Answer, Box<Failure>> {
        let whole = part.unwrap_or(Span::new(0, file.text().len()));
        let mut answers = self.run_advised(file, whole, equals)?;
        let last = answers.pop().ok_or_else(|| {
            let problem = Diagnostic::error(Code::Usage, "a name needs no declaration")
                .hint("leave it out: a name without a value is a symbol");
            Box::new(Failure { problem, file: file.clone() })
        })?;
        Ok(last)
    }

    /// The same of a part, with advice for words that nobody reads.
    fn run_advised(
        &mut self,
        file: &SourceFile,
        whole: Span,
        equals: Equals,
    ) -> Result<Vec<Answer>, Box<Failure>> {
        let failure = match self.run_part(file, whole, equals) {
            Ok(answers) => return Ok(answers),
            Err(failure) => failure,
        };
        // What is wrong with a request that was read stays wrong.
        let of_arguments = matches!(failure.problem.code, Code::Type | Code::Arity | Code::AmbiguousVariable);
        let of_words = of_arguments || may_be_of_words(&failure.problem) || is_left_over(&failure.problem);
        match of_words.then(|| self.run_loosely(file, whole)).flatten() {
            Some(answer) => Ok(vec![answer]),
            None => Err(self.advised(file, whole, failure)),
        }
    }

    /// Runs a part of a file; `k = 1, b = 2` are two statements. What is no formula may be a line of several.
    fn run_part(
        &mut self,
        file: &SourceFile,
        whole: Span,
        equals: Equals,
    ) -> Result<Vec<Answer>, Box<Failure>> {
        let failure = match self.run_statements(file, whole, equals) {
            Ok(answers) => return Ok(answers),
            Err(failure) => failure,
        };
        if let Some(answers) = self.run_condition(file, whole)? {
            return Ok(answers);
        }
        if let Some(answers) = self.run_described(file, whole, equals)? {
            return Ok(answers);
        }
        let failure = match self.run_line(file, whole, equals) {
            Ok(Some(answers)) => return Ok(answers),
            Ok(None) => failure,
            Err(failure) => failure,
        };
        // Given b0 = 1, b1 = 3, b2 = 1, find the point at t = 1/2: the definitions are data of a request.
        if let Ok(Some(formula)) = self.spoken(file, whole) {
            return self
                .evaluated_as(file, formula, whole, equals)
                .map(|answer| vec![answer])
                .map_err(|_| failure);
        }
        match self.run_core(file, whole, equals) {
            Ok(Some(answers)) => Ok(answers),
            _ => Err(failure),
        }
    }

    /// Runs a part of a file as a formula, a request or a sentence.
    fn run_statements(
        &mut self,
        file: &SourceFile,
        whole: Span,
        equals: Equals,
    ) -> Result<Vec<Answer>, Box<Failure>> {
        let fail = |problem| Box::new(Failure { problem, file: file.clone() });
        let limits = self.limits.clone();
        // t^2 + 2t = ?
        let text = file.slice(whole).trim_end();
        // x = Symbol('x'): a name without a value is a symbol
        if let Some(names) = foreign::scripts::declared(text) {
            for name in names {
                self.env.remove(&Symbol::new(name));
            }
            return Ok(Vec::new());
        }
        if let Some(start) = foreign::scripts::after_package(text) {
            return self.run_part(file, Span::new(whole.start + start, whole.end), equals);
        }
        if let Some(answers) = self.run_sought(file, whole)? {
            return Ok(answers);
        }
        let asked = text.trim_end_matches(['?', '？']).trim_end().strip_suffix('=');
        if let Some(formula) =
            asked.filter(|text| !text.trim().is_empty() && !text.ends_with([':', '<', '>', '=', '!']))
        {
            if text.ends_with('=')
                && file.slice(Span::new(whole.end, file.text().len())).trim_start().starts_with('#')
            {
                let problem = Diagnostic::error(Code::UnexpectedEnd, "nothing stands after '='")
                    .at(Span::new(whole.start, whole.start + text.len()))
                    .reason("# begins a comment")
                    .hint("a function without a name is t -> t^2");
                return Err(fail(problem));
            }
            let part = Span::new(whole.start, whole.start + formula.len());
            if let Some(problem) = self.lacks_value(formula, Span::new(part.end, part.end + 1)) {
                return Err(fail(problem));
            }
            if let Ok(statement) = self.read(file, part)
                && let Some(answers) = self.run_data(file, &statement, true)?
            {
                return Ok(answers);
            }
            return self.run_part(file, part, Equals::Claims);
        }
        if let Some(claim) = asking::without_question_of_truth(file.slice(whole)) {
            let part = Span::new(whole.start, whole.start + claim.len());
            return self.run_part(file, part, Equals::Claims);
        }
        if let Some(answers) = self.run_clause(file, whole, equals)? {
            return Ok(answers);
        }
        if let Some(answers) = self.run_where(file, whole, equals)? {
            return Ok(answers);
        }
        if let Some(answers) = self.run_unknown(file, whole, equals)? {
            return Ok(answers);
        }
        if let Some(answers) = self.run_continued(file, whole, equals)? {
            return Ok(answers);
        }
        let found = signs::sign_claim(file.slice(whole)).map(|found| self.directed(file, whole, found));
        let certified = match &found {
            Some(found) => {
                if let Some(shape) =
                    found.shape.filter(|shape| shape.is_strict() || found.condition.is_some())
                    && let Some(answers) = self.run_relation(file, whole, found, shape)?
                {
                    return Ok(answers);
                }
                self.certified(file, whole, found)?
            }
            None => None,
        };
        if certified.is_none()
            && let Some(questions) = self.described_and_asked(file, whole)
        {
            let answer = |(formula, place)| self.evaluated_as(file, formula, place, equals);
            return questions.into_iter().map(answer).collect();
        }
        let formula = match certified {
            Some(formula) => Some(formula),
            None => self.spoken(file, whole)?,
        };
        if let Some(formula) = formula.or_else(|| self.called_in_words(file, whole)) {
            let mut answer = self
                .evaluated_as(file, formula, whole, equals)
                .map_err(|failure| self.with_what_is_missing(file, whole, failure))?;
            answer.outcome.fails =
                matches!(&answer.outcome.value, Value::Derivation(shown) if shows_negative_value(shown));
            return Ok(vec![answer]);
        }
        if let Some(answers) = self.run_asked(file, whole, equals)? {
            return Ok(answers);
        }
        let known = |word: &str| defines(&self.env, word);
        if let Some(sentence) = syntax::sentence(file.slice(whole), &known) {
            let sentence = sentence.shifted(whole.start);
            // a and b with p(1) = 0 and p(2) = 3
            if let Some(formula) = self.unknown_of(file, sentence.formula, &sentence.conditions) {
                let answer = self.evaluated_as(file, formula, sentence.formula, Equals::Claims)?;
                return Ok(vec![answer]);
            }
            if let Some(answers) = self.run_sentence(file, &sentence, equals)? {
                return Ok(answers);
            }
        }
        let statement = guarded(&limits, || read_in(&self.env, file, Some(whole))).map_err(fail)?;
        if let Some(sentence) = given::beside(&statement)
            && let Some(answers) = self.run_sentence(file, &sentence, equals)?
        {
            return Ok(answers);
        }
        if let Some(answers) = self.run_data(file, &statement, false)? {
            return Ok(answers);
        }
        if let Some(answers) = self.run_system(file, &statement)? {
            return Ok(answers);
        }
        let before = self.env.clone();
        let latex = syntax::looks_like_latex(file.slice(whole));
        let mut answers = Vec::new();
        for statement in self.statements_in(statement, equals) {
            match self.evaluated(file, statement, equals, latex) {
                Ok(answer) => answers.push(answer),
                Err(failure) => {
                    self.env = before;
                    return Err(failure);
                }
            }
        }
        Ok(answers)
    }

    /// A formula that words stand for, with the remark how they were read.
    fn evaluated_as(
        &mut self,
        file: &SourceFile,
        formula: Expr,
        words: Span,
        equals: Equals,
    ) -> Result<Answer, Box<Failure>> {
        let note = read_as(&formula, words);
        let mut answer = self.evaluated(file, formula, equals, false)?;
        answer.outcome.notes.insert(0, note);
        Ok(answer)
    }

    fn evaluated(
        &mut self,
        file: &SourceFile,
        mut statement: Expr,
        equals: Equals,
        latex: bool,
    ) -> Result<Answer, Box<Failure>> {
        let span = statement.span;
        let (with_arguments, remark) = self.with_members_called(statement);
        let (with_operator, operator) = self.with_operator_applied(with_arguments);
        statement = with_operator;
        let known = |name: &str| defines(&self.env, name);
        if let Some(problem) = foreign::spelling::set_of_numbers(&statement, &known) {
            return Err(Box::new(Failure { problem, file: file.clone() }));
        }
        if let Some(problem) = ambiguous::touching_list(&statement) {
            return Err(Box::new(Failure { problem, file: file.clone() }));
        }
        match self.evaluate(&mut statement, equals) {
            Ok(mut outcome) => {
                ambiguous::products(&statement, latex, &mut outcome.notes);
                foreign::spelling::remarks(&statement, file, &mut outcome.notes);
                let function = |name: &str| matches!(self.env.get(&Symbol::new(name)), Some(Value::Function(own)) if own.as_formula().is_some());
                foreign::spelling::differences(&statement, &function, &mut outcome.notes);
                outcome.notes.extend(remark.into_iter().chain(operator));
                outcome
                    .notes
                    .extend(foreign::spelling::degree_last(&statement, &|name| defines(&self.env, name)));
                Ok(Answer { statement, outcome, file: file.clone() })
            }
            // What exceeds a limit has no place of its own; the statement will do.
            Err(problem) => Err(Box::new(Failure { problem: problem.at(span), file: file.clone() })),
        }
    }

    /// The definitions that stand side by side in a statement, and what follows them: `k = 1, b = 2`,
    /// `x = 3, x^2`; any other statement is one.
    fn statements_in(&self, statement: Expr, equals: Equals) -> Vec<Expr> {
        let Kind::Sequence(items) = &statement.kind else { return vec![statement] };
        let joins = |item: &&Expr| matches!(&item.kind, Kind::Text(word) if words::joins_statements(word));
        let parts: Vec<&Expr> = items.iter().filter(|item| !joins(item)).collect();
        let mut machine = evaluator::machine_in(&self.env);
        let definitions = parts.iter().take_while(|item| machine.defines(item)).count();
        // x = 1,5
        let decimal = parts.windows(2).any(|pair| eval::is_decimal_comma(pair[0], pair[1]));
        if equals == Equals::DefinesUnbound && definitions > 0 && definitions + 1 >= parts.len() && !decimal {
            return parts.into_iter().cloned().collect();
        }
        vec![statement]
    }

    /// Evaluates a formula that has been read already.
    ///
    /// # Errors
    /// The problem with its place; the session is as before.
    pub fn evaluate(&mut self, statement: &mut Expr, equals: Equals) -> Result<Outcome, Diagnostic> {
        let mut env = self.env.clone();
        let limits = self.limits.clone();
        let mut outcome = guarded(&limits, || {
            let outcome = evaluator::evaluate(statement, &mut env, equals);
            asked::refined(statement, &self.env, outcome)
                .map(|outcome| self.arranged(outcome, statement.span))
        })
        .map_err(|problem| complete(problem, statement.span))?;
        self.symbols_of_before(&mut outcome, statement.span);
        if outcome.defined.is_none() {
            env.set(Symbol::new("ans"), outcome.value.clone().plain());
        }
        self.env = env;
        Ok(outcome)
    }

    /// An answer in the arrangement of the session, or a remark that it has none.
    fn arranged(&self, mut outcome: Outcome, span: Span) -> Outcome {
        if self.arrangement == Arrangement::Usual {
            return outcome;
        }
        match self.arrangement.applied(&mut evaluator::machine_in(&self.env), &outcome.value) {
            Ok(Some(value)) => outcome.value = value,
            Ok(None) => {}
            Err(problem) => {
                let note = format!("arranged as usual: {}", problem.message);
                outcome.notes.push(Diagnostic::note(problem.code, note).at(span));
            }
        }
        outcome
    }

    /// A remark on an answer with a symbol that has got a value since: y = 2x, x = 3, y.
    fn symbols_of_before(&self, outcome: &mut Outcome, span: Span) {
        let (Value::Scalar(formula), None) = (&outcome.value, &outcome.defined) else { return };
        let value = |name: &Symbol| self.env.get(name).map(Value::as_rational);
        let Some((name, value)) =
            formula.variables().into_iter().find_map(|name| value(&name).map(|value| (name, value)))
        else {
            return;
        };
        let hint = match value {
            Some(value) => format!("put the value in with subs(..., {name}={value})"),
            None => format!("define {name} before what is made of it"),
        };
        outcome.notes.push(
            Diagnostic::note(
                Code::AmbiguousVariable,
                format!("{name} is a symbol here, from before it got a value"),
            )
            .at(span)
            .hint(hint),
        );
    }
}

/// The remark how words were read.
fn read_as(formula: &Expr, place: Span) -> Diagnostic {
    Diagnostic::note(Code::StandardMeaning, format!("read as {}", write::text(formula))).at(place)
}

/// Reads plain notation or LaTeX, whichever it looks like; spans count from the start of the file.
///
/// # Errors
/// What is wrong with the text.
pub fn read(file: &SourceFile, part: Option<Span>) -> Result<Expr, Diagnostic> {
    read_in(&Env::default(), file, part)
}

/// The same where some names are defined.
fn read_in(env: &Env, file: &SourceFile, part: Option<Span>) -> Result<Expr, Diagnostic> {
    let span = part.unwrap_or(Span::new(0, file.text().len()));
    let text = file.slice(span);
    let result = if syntax::looks_like_latex(text) {
        let machine = evaluator::machine_in(env);
        let alone = letters_alone(text);
        let words =
            |word: &str, called| machine.word_in_latex(word, called, &|letter| alone.contains(&letter));
        latex::read_query(text, &words)
    } else {
        syntax::parse(text)
    };
    match result {
        Ok(mut expr) => {
            expr.shift(span.start);
            let expr = foreign::with_calls(expr, &|name| defines(env, name));
            Ok(foreign::with_scalar_products(expr, file, &|name| is_point(env, name)))
        }
        Err(problem) => {
            let problem = problem.shifted(span.start);
            let rest = file.slice(Span::new(span.end, file.text().len()));
            let comment = rest.trim_start_matches([' ', '\t']).starts_with('#') || text.contains('#');
            let open = matches!(problem.code, Code::UnexpectedEnd | Code::Unbalanced);
            Err(match comment && open {
                true => problem.hint("# begins a comment; a function without a name is t -> t^2"),
                false => problem,
            })
        }
    }
}

/// Whether a name stands for a point, which may be a column.
fn is_point(env: &Env, name: &str) -> bool {
    match env.get(&Symbol::new(name)) {
        Some(Value::List(items)) => items.len() > 1,
        Some(Value::Matrix(matrix)) => matrix.ncols() == 1,
        _ => false,
    }
}

/// Whether a word is a name with a value.
fn defines(env: &Env, word: &str) -> bool {
    env.get(&Symbol::new(word)).is_some()
}

/// The letters that stand by themselves in a formula in LaTeX.
fn letters_alone(text: &str) -> BTreeSet<char> {
    let runs = text.split(|c: char| !c.is_ascii_alphabetic() && c != '\\');
    runs.filter_map(|run| run.parse::<char>().ok()).filter(char::is_ascii_alphabetic).collect()
}

/// Reads the items of a list that is given by itself: `a, b, c`, in plain notation or LaTeX.
///
/// In plain notation blanks separate numbers and points as well, and a range of integers stands for
/// its numbers, so that `0 0 1..3 3` are the items 0, 0, 1, 2, 3, 3.
///
/// # Errors
/// What is wrong with the text; also a sign that might be that of an item or a difference (`1 -1`).
///
/// ```
/// use polarform::session::read_items;
/// use polarform::source::SourceFile;
/// let count = |text| read_items(&SourceFile::new("<knots>", text)).map(|items| items.len());
/// assert_eq!(count("0, 1/2, t"), Ok(3));
/// assert_eq!(count(r"0, \frac12, t"), Ok(3));
/// assert_eq!(count("0 0 1..3 3"), Ok(6));
/// assert!(count("1 -1").is_err());
/// ```
pub fn read_items(file: &SourceFile) -> Result<Vec<Expr>, Diagnostic> {
    items_in(&Env::default(), file, Span::new(0, file.text().len()))
}

/// The same of a part of a file, where some names are defined.
fn items_in(env: &Env, file: &SourceFile, part: Span) -> Result<Vec<Expr>, Diagnostic> {
    let text = file.slice(part);
    let spaced = match syntax::looks_like_latex(text) {
        true => None,
        false => syntax::spaced_items(text).map_err(|problem| problem.shifted(part.start))?,
    };
    let read = |span: Span| read_in(env, file, Some(span.shifted(part.start)));
    let items = match spaced {
        Some(spans) => spans.into_iter().map(read).collect::<Result<_, _>>()?,
        None => match read(Span::new(0, text.len()))? {
            Expr { kind: Kind::Sequence(items), .. } => items,
            one => vec![one],
        },
    };
    Ok(items.into_iter().flat_map(numbers_of_range).collect())
}

/// The numbers of a range of integers; anything else as it is, also a range that is very long.
fn numbers_of_range(item: Expr) -> Vec<Expr> {
    const LONGEST: i64 = 10_000;
    let Kind::Range(first, last) = &item.kind else { return vec![item] };
    match (first.as_signed_int(), last.as_signed_int()) {
        (Some(first), Some(last)) if last.saturating_sub(first) < LONGEST => {
            (first..=last).map(|number| Expr { span: item.span, ..Expr::int(number) }).collect()
        }
        _ => vec![item],
    }
}

/// Runs `work` under limits; what stops it becomes a diagnostic, and so does a defect of ours.
pub(crate) fn guarded<T>(
    limits: &Limits,
    work: impl FnOnce() -> Result<T, Diagnostic>,
) -> Result<T, Diagnostic> {
    match catch_unwind(AssertUnwindSafe(|| budget::run(limits, work))) {
        Ok(Ok(result)) => result,
        Ok(Err(stop)) => Err(stopped(&stop)),
        Err(_) => Err(Diagnostic::error(Code::Internal, "polarform met a defect of its own")
            .hint("please report the input that led here")),
    }
}

/// A problem with a place (the whole statement if nothing smaller is known) and with advice.
fn complete(problem: Diagnostic, statement: Span) -> Diagnostic {
    let problem = problem.at(statement);
    match usual_advice(problem.code) {
        Some(advice) if problem.hints.is_empty() => problem.hint(advice),
        _ => problem,
    }
}

/// What to do about a problem whose finder had nothing more precise to say.
fn usual_advice(code: Code) -> Option<&'static str> {
    Some(match code {
        Code::Arity => "give as many arguments as it takes; polarform functions shows the forms",
        Code::Type => "convert it first, or use a function that takes it; polarform functions lists them",
        Code::DivisionByZero => "leave this value out, or write a symbol and put in values later",
        Code::DegreeTooSmall => "give a degree that is at least that of the polynomial",
        Code::Shape => "make the numbers of rows, columns or items agree",
        Code::Singular => "only matrices of full rank can be inverted; rank(M) tells the rank",
        Code::NotReducible => "only a form whose highest coefficients are 0 has fewer arguments",
        Code::Coincident => "choose distinct points",
        Code::Domain => "choose a value in the range; polarform functions shows the forms",
        Code::Unsupported => "say it with the functions there are; polarform functions lists them",
        Code::TooManyTerms => "use smaller sizes; some need no expansion, such as f(0, 1) at numbers",
        Code::TooManyDigits => "use smaller numbers, or keep a symbol in their place",
        _ => return None,
    })
}

/// The diagnostic for a computation that was stopped.
pub(crate) fn stopped(stop: &Stop) -> Diagnostic {
    match stop {
        Stop::Time(_) | Stop::Steps(_) => {
            Diagnostic::error(Code::Timeout, stop.to_string()).hint("allow more time with --timeout SECONDS")
        }
        Stop::Terms { .. } => Diagnostic::error(Code::TooManyTerms, stop.to_string())
            .hint("allow more with --max-terms N; to print a large polar form use --notation sigma"),
        Stop::Bits { .. } => Diagnostic::error(Code::TooManyDigits, stop.to_string()),
        Stop::Interrupted => Diagnostic::error(Code::Interrupted, "interrupted"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_statement_changes_nothing() {
        let mut session = Session::default();
        session.run("a := 3").unwrap();
        let before = session.env.clone();
        for bad in ["a := 1/0", "b := nonsense", "(((", "F(t) := wrongname(t)"] {
            assert!(session.run(bad).is_err(), "{bad}");
            assert_eq!(session.env, before, "{bad}");
        }
    }

    #[test]
    fn limits_stop_what_is_absurd() {
        let mut session = Session::default();
        for (text, code) in [
            ("(t+1)^1000000000", Code::TooManyTerms),
            ("t^99999999999999999999", Code::TooManyTerms),
            ("2^(10^9)", Code::TooManyDigits),
            ("100000000!", Code::TooManyDigits),
        ] {
            let failure = session.run(text).unwrap_err();
            assert_eq!(failure.problem.code, code, "{text}");
        }
    }
}
