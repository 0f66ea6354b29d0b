//! The commands: each is a short way to say a query of the language.

use std::io::{self, IsTerminal};
use std::path::Path;
use std::sync::Arc;

use super::Status;
use super::argument_reader::{ArgumentReader, Failed, bound};
use super::arguments::{Arguments, Command, FormatArgument, Global, MatrixArguments, PolarArguments, Two};
use super::output::{Output, Trouble};
use super::script::{script_file, scripts_in};
use super::waiting::Waiting;
use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, applied, call, named};
use crate::language::diagnostic::{Code, Diagnostic, nearest};
use crate::language::eval::Equals;
use crate::language::functions::{BUILTINS, builtin};
use crate::language::syntax;
use crate::language::value::{PolarKind, Value, Verdict};
use crate::session::{Answer, Failure, Session, read};

/// Why a command ends before its end.
pub(super) enum Stop {
    Failed(Box<Failure>),
    Trouble(Trouble),
}

impl From<Box<Failure>> for Stop {
    fn from(failure: Box<Failure>) -> Self {
        Stop::Failed(failure)
    }
}

impl From<Trouble> for Stop {
    fn from(trouble: Trouble) -> Self {
        Stop::Trouble(trouble)
    }
}

impl From<io::Error> for Stop {
    fn from(error: io::Error) -> Self {
        Stop::Trouble(Trouble::Output(error))
    }
}

pub(super) type Ran = Result<Status, Stop>;

pub(super) fn run(arguments: &Arguments) -> Status {
    let mut output = Output::new(&arguments.global);
    let mut session = Session::new(arguments.global.limits());
    session.arrangement = arguments.global.arrange;
    let figure = matches!(arguments.command, Some(Command::Figure(_)));
    if arguments.global.format == Some(FormatArgument::Svg) && !figure {
        let problem = Diagnostic::error(Code::Usage, "only figures are written as SVG")
            .hint("polarform figure query \"figure_basis(3)\" --format svg");
        output.problem(&problem, &SourceFile::new("<arguments>", ""));
        return Status::Failed;
    }
    let result = match &arguments.command {
        None if io::stdin().is_terminal() => return super::repl::run(&mut session, &mut output),
        None => match script_file(Path::new("-")) {
            Ok(file) => super::repl::piped(&mut session, &mut output, &file),
            Err(failure) => Err(failure.into()),
        },
        Some(command) => dispatch(command, &arguments.global, &mut session, &output),
    };
    match result {
        Ok(status) => status,
        Err(Stop::Failed(failure)) => {
            output.failure(&failure);
            Status::Failed
        }
        Err(Stop::Trouble(trouble)) => report(&output, &trouble, &SourceFile::new("<output>", "")),
    }
}

/// For callers without a status to give: a failure in words.
pub(super) fn settle(stop: Stop) -> Result<(), Trouble> {
    match stop {
        Stop::Failed(failure) => Err(Trouble::Problem(Box::new(failure.problem))),
        Stop::Trouble(trouble) => Err(trouble),
    }
}

/// A closed pipe ends the program quietly, as other programs do.
fn report(output: &Output, trouble: &Trouble, file: &SourceFile) -> Status {
    match trouble {
        Trouble::Output(error) if error.kind() == io::ErrorKind::BrokenPipe => Status::Fine,
        Trouble::Output(error) => {
            let problem = Diagnostic::error(Code::File, format!("cannot write the result: {error}"));
            output.problem(&problem, file);
            Status::Failed
        }
        Trouble::Problem(problem) => {
            output.problem(problem, file);
            Status::Failed
        }
    }
}

fn dispatch(command: &Command, global: &Global, session: &mut Session, output: &Output) -> Ran {
    match command {
        Command::Eval { statements } => {
            let mut status = Status::Fine;
            for (i, text) in statements.iter().enumerate() {
                let name =
                    if statements.len() == 1 { "<expr>".to_owned() } else { format!("<expr {}>", i + 1) };
                let file = SourceFile::new(name, text.as_str());
                if syntax::statements(text).is_ok_and(|spans| spans.is_empty()) {
                    formula(&file)?;
                }
                status = status.max(run_all(session, output, &file, true)?);
                if status == Status::Failed {
                    break;
                }
            }
            Ok(status)
        }
        Command::Run { file, stop } if file.is_dir() => scripts(session, global, output, file, *stop),
        Command::Run { file, stop } => script(session, output, file, *stop),
        Command::Polar(wanted) => polar(wanted, session, output),
        Command::Sum(two) => combine(session, output, two, "sum"),
        Command::Product(two) => combine(session, output, two, "product"),
        Command::Compose(two) => combine(session, output, two, "compose"),
        Command::Matrix(wanted) => {
            let mut reader = ArgumentReader::new(output);
            let query = matrix(&mut reader, wanted)?;
            print(session, output, &reader, query)
        }
        Command::Bezier(arguments) => {
            let mut reader = ArgumentReader::new(output);
            let query = super::curves::bezier(&mut reader, arguments)?;
            print(session, output, &reader, query)
        }
        Command::Bspline(arguments) => {
            let mut reader = ArgumentReader::new(output);
            let query = super::curves::bspline(&mut reader, arguments)?;
            print(session, output, &reader, query)
        }
        Command::Interpolate(wanted) => super::interpolate::run(wanted, session, output),
        Command::Check { claim, given } => check(session, output, claim, given),
        Command::Figure(figure) => super::figure::run(figure, global, session, output),
        Command::Notes(notes) => super::notes::run(notes, global, output),
        Command::Weave(arguments) => super::weave::run(arguments, global, output),
        Command::Lsp { .. } => super::lsp::run(global, super::notes::SECONDS),
        Command::Completions { shell } => super::manual::completions(*shell, output),
        Command::Man { command, output: folder } => super::manual::man(command, folder.as_deref(), output),
        Command::Explain { code } => explain(output, code.as_deref()),
        Command::Functions { name } => functions(output, name.as_deref()),
    }
}

/// Evaluates a query and prints what it gives.
fn print(session: &mut Session, output: &Output, reader: &ArgumentReader, query: Expr) -> Ran {
    output.value(&reader.evaluate(session, query)?, None)?;
    Ok(Status::Fine)
}

fn polar(wanted: &PolarArguments, session: &mut Session, output: &Output) -> Ran {
    let mut reader = ArgumentReader::new(output);
    let (_, polynomial) = reader.operand(session, "polynomial", &wanted.polynomial)?;
    let whole = polynomial.span;
    let mut arguments = vec![polynomial];
    if let Some(degree) = wanted.degree {
        arguments.push(named("degree", reader.number("degree", degree)));
    }
    if let Some(variable) = &wanted.variable {
        arguments.push(named("variable", reader.formula("variable", variable)?));
    }
    let value = reader.evaluate(session, call("polar", arguments, whole))?;
    let form = bound(session, "<polar>", value.clone(), whole);
    if wanted.steps {
        let method = named("method", reader.word("method", wanted.method.name()));
        let subject = Expr::new(Kind::Name("polar".to_owned()), whole);
        let query = call("derive", vec![subject, form.clone(), method], whole);
        output.value(&reader.evaluate(session, query)?, None)?;
    }
    match &wanted.at {
        None if wanted.steps => {}
        None => output.value(&value, None)?,
        Some(at) => {
            let arguments = polar_arguments(&mut reader, at, &value)?;
            let shown = Expr::apply(Expr::name("f"), arguments.clone());
            let query = applied(form, arguments, reader.last_span());
            output.value(&reader.evaluate(session, query)?, Some(shown))?;
        }
    }
    Ok(Status::Fine)
}

/// `0, 1` and also `(0, 1)`, unless the arguments of the form are points: then `(0, 1)` is one of them.
fn polar_arguments(reader: &mut ArgumentReader, at: &str, form: &Value) -> Failed<Vec<Expr>> {
    let of_points = match form {
        Value::Polar(polar) => matches!(polar.kind, PolarKind::Total(_)),
        _ => false,
    };
    if !of_points {
        return reader.arguments("at", at);
    }
    match reader.points("at", at)?.kind {
        Kind::List(items) => Ok(items),
        _ => Ok(Vec::new()),
    }
}

/// The query of `polarform matrix`.
fn matrix(reader: &mut ArgumentReader, wanted: &MatrixArguments) -> Failed<Expr> {
    let degree = reader.number("degree", wanted.degree);
    let whole = degree.span;
    if let Some(higher) = wanted.raise_to {
        let higher = reader.number("raise-to", higher);
        let span = higher.span;
        return Ok(call("raising", vec![degree, higher], span));
    }
    let from = named_basis(reader.formula("from", &wanted.from)?);
    let to = named_basis(reader.formula("to", &wanted.to)?);
    if wanted.steps {
        let subject = if wanted.inverse { derivable(&to, &from) } else { derivable(&from, &to) };
        let Some(subject) = subject else {
            let message = format!("there are no steps from {} to {}", wanted.from, wanted.to);
            let odd = if matches!(basis_name(&from), Some("bernstein" | "power")) { &to } else { &from };
            let problem = Diagnostic::error(Code::Unsupported, message)
                .at(odd.span)
                .hint("--steps is for the matrix from bernstein to power, and its inverse");
            return Err(reader.failure(problem));
        };
        let subject = Expr::new(Kind::Name(subject.to_owned()), whole);
        return Ok(call("derive", vec![subject, degree], whole));
    }
    let (ends, span) = match &wanted.interval {
        Some(interval) => (reader.arguments("interval", interval)?, reader.last_span()),
        None => (Vec::new(), whole),
    };
    let (from, to) = (over(from, &ends, span), over(to, &ends, span));
    let (from, to) = if wanted.inverse { (to, from) } else { (from, to) };
    Ok(call("change_of_basis", vec![degree, from, to], span))
}

/// A basis whose name was read letter by letter, as LaTeX reads words, gets its name back.
fn named_basis(basis: Expr) -> Expr {
    const NAMES: [&str; 6] = ["power", "bernstein", "taylor", "lagrange", "newton", "hermite"];
    let span = basis.span;
    match basis.kind {
        Kind::List(mut items) if !items.is_empty() => {
            let name = named_basis(items.remove(0));
            items.insert(0, name);
            Expr::new(Kind::List(items), span)
        }
        Kind::Mul(letters) => {
            let word: String = letters.iter().filter_map(basis_name).collect();
            match NAMES.iter().find(|name| **name == word) {
                Some(name) => Expr::new(Kind::Name((*name).to_owned()), span),
                None => Expr::new(Kind::Mul(letters), span),
            }
        }
        kind => Expr::new(kind, span),
    }
}

fn basis_name(basis: &Expr) -> Option<&str> {
    match &basis.kind {
        Kind::Name(name) => Some(name),
        _ => None,
    }
}

/// The derivation of the matrix from one basis to another.
fn derivable(from: &Expr, to: &Expr) -> Option<&'static str> {
    match (basis_name(from)?, basis_name(to)?) {
        ("bernstein", "power") => Some("matrix"),
        ("power", "bernstein") => Some("inverse_matrix"),
        _ => None,
    }
}

/// `bernstein` with the interval, other bases as they are.
fn over(basis: Expr, ends: &[Expr], span: Span) -> Expr {
    if ends.is_empty() || !matches!(basis_name(&basis), Some("bernstein" | "hermite")) {
        return basis;
    }
    Expr::new(Kind::List(std::iter::once(basis).chain(ends.iter().cloned()).collect()), span)
}

/// Reads a text as one formula.
fn formula(file: &SourceFile) -> Result<Expr, Box<Failure>> {
    read(file, None).map_err(|problem| Box::new(Failure { problem, file: file.clone() }))
}

fn combine(session: &mut Session, output: &Output, two: &Two, name: &str) -> Ran {
    let mut reader = ArgumentReader::new(output);
    let (_, f) = reader.operand(session, "F", &two.f)?;
    let (_, g) = reader.operand(session, "G", &two.g)?;
    let whole = f.span;
    // Both operands are made polar forms first, so that what is wrong is shown where it stands.
    let mut polar = |name: &str, operand: Expr| -> Failed<Expr> {
        let span = operand.span;
        let value = reader.evaluate(session, call("polar", vec![operand], span))?;
        Ok(bound(session, name, value, span))
    };
    let mut operands = vec![polar("<polar F>", f)?, polar("<polar G>", g)?];
    if two.steps {
        operands.insert(0, Expr::new(Kind::Name(name.to_owned()), whole));
        return print(session, output, &reader, call("derive", operands, whole));
    }
    let value = reader.evaluate(session, call(&format!("polar_{name}"), operands, whole))?;
    output.value(&value, Some(Expr::name("h")))?;
    Ok(Status::Fine)
}

/// Runs all statements of a text and prints their results.
pub(super) fn run_all(session: &mut Session, output: &Output, file: &SourceFile, stop: bool) -> Ran {
    let mut printer = Printer::new(output, file, stop);
    match syntax::statements(file.text()) {
        Ok(spans) => {
            for span in session.units(file, spans) {
                if !printer.run(session, span) {
                    break;
                }
            }
        }
        // Says what is wrong with the whole.
        Err(_) => session.run_file(file, |_, result| printer.answer(result)),
    }
    printer.ended()
}

/// Runs one statement of a text and prints its results.
pub(super) fn run_statement(session: &mut Session, output: &Output, file: &SourceFile, span: Span) -> Ran {
    let mut printer = Printer::new(output, file, true);
    printer.run(session, span);
    printer.ended()
}

/// Prints the answers of a text one after the other.
struct Printer<'a> {
    output: &'a Output,
    file: &'a SourceFile,
    /// Whether a failure ends it.
    stop: bool,
    status: Status,
    trouble: Option<Trouble>,
}

impl<'a> Printer<'a> {
    fn new(output: &'a Output, file: &'a SourceFile, stop: bool) -> Self {
        Printer { output, file, stop, status: Status::Fine, trouble: None }
    }

    /// Runs the statement at `span` and prints its answers; whether to go on.
    fn run(&mut self, session: &mut Session, span: Span) -> bool {
        let mut waiting = Some(Waiting::of(self.file.slice(span)));
        self.output.begin();
        session.run_span(self.file, span, |_, result| {
            waiting = None;
            self.answer(result)
        })
    }

    /// Prints one answer; whether to go on.
    fn answer(&mut self, result: Result<Answer, Box<Failure>>) -> bool {
        match result {
            Ok(answer) => match show(self.output, &answer) {
                Ok(shown) => self.status = self.status.max(shown),
                Err(trouble @ Trouble::Output(_)) => {
                    self.trouble = Some(trouble);
                    return false;
                }
                Err(trouble) => self.status = self.status.max(report(self.output, &trouble, self.file)),
            },
            Err(failure) => {
                self.output.failure(&failure);
                self.status = Status::Failed;
                return !self.stop;
            }
        }
        true
    }

    fn ended(self) -> Ran {
        match self.trouble {
            Some(trouble) => Err(Stop::Trouble(trouble)),
            None => Ok(self.status),
        }
    }
}

/// Prints what a statement did.
pub(super) fn show(output: &Output, answer: &Answer) -> Result<Status, Trouble> {
    let claim = matches!(answer.outcome.value, Value::Claim(_));
    if output.quiet
        && let Value::Claim(claim) = &answer.outcome.value
        && matches!(claim.verdict(), Verdict::Proved | Verdict::Sampled)
    {
        return Ok(Status::Fine);
    }
    let notes = || answer.outcome.notes.iter().filter(|note| output.verbose || !claim || !is_usual(note));
    // A verdict goes before what is to be said of it.
    if claim {
        output.value(&answer.outcome.value, answer.name())?;
    }
    for note in notes() {
        output.problem(note, &answer.file);
    }
    if !claim {
        output.value(&answer.outcome.value, answer.name())?;
    }
    // Of several statements the next one begins.
    output.begin();
    Ok(match &answer.outcome.value {
        Value::Claim(claim) => match claim.verdict() {
            Verdict::Proved | Verdict::Sampled => Status::Fine,
            Verdict::Refuted => Status::Refuted,
            Verdict::Undecided => Status::Failed,
        },
        _ if answer.outcome.fails => Status::Refuted,
        _ => Status::Fine,
    })
}

/// Whether a note tells of a reading that every textbook has.
fn is_usual(note: &Diagnostic) -> bool {
    note.code == Code::StandardMeaning && note.hints.is_empty() && !note.message.starts_with("read as ")
}

fn script(session: &mut Session, output: &Output, path: &Path, stop: bool) -> Ran {
    run_all(session, output, &script_file(path)?, stop)
}

/// The scripts of a folder, in the order of their names.
fn scripts(session: &mut Session, global: &Global, output: &Output, folder: &Path, stop: bool) -> Ran {
    let mut status = Status::Fine;
    for file in scripts_in(folder)? {
        let arrangement = session.arrangement;
        *session = Session::new(global.limits());
        session.arrangement = arrangement;
        if !output.quiet {
            output.line(&format!("# {}", file.display()))?;
        }
        status = status.max(script(session, output, &file, stop)?);
    }
    Ok(status)
}

fn check(session: &mut Session, output: &Output, claim: &str, given: &[String]) -> Ran {
    let conditions = session.give(given)?;
    let file = SourceFile::new("<claim>", claim);
    let mut answer = session.run_statement(&file, None, Equals::Claims)?;
    let Value::Claim(judged) = answer.outcome.value.clone() else {
        let problem = Diagnostic::error(Code::Usage, "nothing is claimed here")
            .at(answer.statement.span)
            .reason("a value, not a claim")
            .hint("write an equation, for example \"f(0,1) = 1/2\"");
        return Err(Box::new(Failure { problem, file }).into());
    };
    answer.outcome.value = Value::Claim(Arc::new(conditions.applied(session, &judged)));
    Ok(show(output, &answer)?)
}

pub(super) fn explain(output: &Output, code: Option<&str>) -> Ran {
    let Some(text) = code else {
        for code in Code::ALL {
            output.line(&format!("{}  {}", code.id(), code.title()))?;
        }
        return Ok(Status::Fine);
    };
    match text.parse::<Code>() {
        Ok(code) => {
            output.line(&format!("{}: {}\n", code.id(), code.title()))?;
            for line in code.explanation().lines() {
                output.line(line.trim())?;
            }
            Ok(Status::Fine)
        }
        Err(()) => {
            let hint = match builtin(text) {
                Some(_) => format!("polarform functions {text} tells about the function"),
                None => "polarform explain lists all codes".to_owned(),
            };
            let problem = Diagnostic::error(Code::Usage, format!("there is no code '{text}'"))
                .at(Span::new(0, text.len()))
                .hint(hint);
            Err(Box::new(Failure { problem, file: SourceFile::new("<code>", text) }).into())
        }
    }
}

pub(super) fn functions(output: &Output, name: Option<&str>) -> Ran {
    match name {
        None => {
            let mut topic = "";
            for entry in BUILTINS {
                if entry.topic != topic {
                    topic = entry.topic;
                    output.line(&format!("{topic}:"))?;
                }
                output.line(&format!("  {:<42} {}", entry.signature(), entry.summary))?;
            }
            Ok(Status::Fine)
        }
        Some(name) => match builtin(name) {
            Some(entry) => {
                for line in entry.help() {
                    output.line(&line)?;
                }
                Ok(Status::Fine)
            }
            None => {
                let mut problem =
                    Diagnostic::error(Code::UnknownFunction, format!("there is no function '{name}'"))
                        .at(Span::new(0, name.len()));
                if let Some(best) = nearest(name, BUILTINS.iter().map(|b| b.name)) {
                    problem = problem.hint(format!("did you mean '{best}'?"));
                } else {
                    problem = problem.hint("polarform functions lists all of them");
                }
                Err(Box::new(Failure { problem, file: SourceFile::new("<name>", name) }).into())
            }
        },
    }
}
