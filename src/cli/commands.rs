//! The commands: each is a short way to say a query of the language.

use std::fs;
use std::io::{self, IsTerminal, Read};
use std::path::Path;

use super::Status;
use super::arguments::{Arguments, Command, FormatArgument, Global, Two};
use super::output::{Output, Trouble};
use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Rel};
use crate::language::diagnostic::{Code, Diagnostic, nearest};
use crate::language::eval::Equals;
use crate::language::functions::{BUILTINS, builtin};
use crate::language::syntax;
use crate::language::value::{Value, Verdict, symbol_expr};
use crate::language::write::text;
use crate::math::poly::Symbol;
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
    let figure = matches!(arguments.command, Some(Command::Figure(_)));
    if arguments.global.format == Some(FormatArgument::Svg) && !figure {
        let problem = Diagnostic::error(Code::Usage, "only figures are written as SVG")
            .hint("polarform figure query \"figure_basis(3)\" --format svg");
        output.problem(&problem, &SourceFile::new("<arguments>", ""));
        return Status::Failed;
    }
    let result = match &arguments.command {
        None if io::stdin().is_terminal() => return super::repl::run(&mut session, &mut output),
        None => script(&mut session, &output, Path::new("-"), false),
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
        Command::Run { file, stop } => script(session, output, file, *stop),
        Command::Polar { polynomial, degree, variable, method, at, steps } => {
            let file = SourceFile::new("<polynomial>", polynomial.as_str());
            let value = operand(session, &file)?;
            let mut named = vec![];
            if let Some(degree) = degree {
                named.push(("degree", Expr::int(i64::try_from(*degree).unwrap_or(i64::MAX))));
            }
            if let Some(variable) = variable {
                let file = SourceFile::new("<variable>", variable.as_str());
                named.push(("variable", formula(&file)?));
            }
            session.env.set(Symbol::new("F"), value);
            let whole = Span::new(0, polynomial.len());
            let polar = query(session, &file, whole, "polar", vec![Expr::name("F")], named)?;
            if *steps {
                session.env.set(Symbol::new("F"), polar.clone());
                let subject = vec![Expr::name("polar"), Expr::name("F")];
                let method = vec![("method", Expr::name(method.name()))];
                output.value(&query(session, &file, whole, "derive", subject, method)?, None)?;
                if at.is_none() {
                    return Ok(Status::Fine);
                }
            }
            match at {
                None => output.value(&polar, None)?,
                Some(at) => {
                    let file = SourceFile::new("<at>", at.as_str());
                    let arguments = list(&file)?;
                    session.env.set(Symbol::new("f"), polar.clone());
                    let call = Expr::new(
                        Kind::Apply(Box::new(Expr::name("f")), vec![arguments]),
                        Span::new(0, at.len()),
                    );
                    let value = evaluated(session, &file, call.clone())?;
                    output.value(&value, Some(call))?;
                }
            }
            Ok(Status::Fine)
        }
        Command::Sum(two) => combine(session, output, two, "sum"),
        Command::Product(two) => combine(session, output, two, "product"),
        Command::Compose(two) => combine(session, output, two, "compose"),
        Command::Matrix { degree, from, to, inverse, interval, raise_to, steps } => {
            // The query is written out, so that what is wrong is shown in it.
            let query = match raise_to {
                Some(m) => format!("raising({degree}, {m})"),
                None if *steps => {
                    let (from, to) = if *inverse { (to, from) } else { (from, to) };
                    format!("derive({}, {degree})", derivable_matrix(from, to)?)
                }
                None => {
                    let ends = match interval {
                        Some(interval) => list(&SourceFile::new("<interval>", interval.as_str()))?,
                        None => Vec::new(),
                    };
                    let from = basis("<from>", from, &ends)?;
                    let to = basis("<to>", to, &ends)?;
                    let (from, to) = if *inverse { (to, from) } else { (from, to) };
                    format!("change_of_basis({degree}, {}, {})", text(&from), text(&to))
                }
            };
            let matrix = operand(session, &SourceFile::new("<matrix>", query))?;
            output.value(&matrix, None)?;
            Ok(Status::Fine)
        }
        Command::Bezier(arguments) => {
            let query = SourceFile::new("<bezier>", super::curves::bezier(arguments));
            output.value(&operand(session, &query)?, None)?;
            Ok(Status::Fine)
        }
        Command::Bspline(arguments) => {
            let query = SourceFile::new("<bspline>", super::curves::bspline(arguments));
            output.value(&operand(session, &query)?, None)?;
            Ok(Status::Fine)
        }
        Command::Interpolate(wanted) => super::interpolate::run(wanted, session, output),
        Command::Check { claim, given } => check(session, output, claim, given),
        Command::Figure(figure) => super::figure::run(figure, global, session, output),
        Command::Notes(notes) => super::notes::run(notes, global, output),
        Command::Weave(arguments) => super::weave::run(arguments, global, output),
        Command::Explain { code } => explain(output, code.as_deref()),
        Command::Functions { name } => functions(output, name.as_deref()),
    }
}

/// The derivation of the matrix from one basis to another.
fn derivable_matrix(from: &str, to: &str) -> Result<&'static str, Box<Failure>> {
    match (from.trim(), to.trim()) {
        ("bernstein", "power") => Ok("matrix"),
        ("power", "bernstein") => Ok("inverse_matrix"),
        _ => {
            let problem =
                Diagnostic::error(Code::Unsupported, format!("there are no steps from {from} to {to}"))
                    .hint("--steps is for the matrix from bernstein to power, and its inverse");
            Err(Box::new(Failure { problem, file: SourceFile::new("<matrix>", "") }))
        }
    }
}

/// `bernstein` with the interval, other bases as they are.
fn basis(name: &str, text: &str, ends: &[Expr]) -> Result<Expr, Box<Failure>> {
    let expr = formula(&SourceFile::new(name, text))?;
    let bernstein = matches!(&expr.kind, Kind::Name(word) if word == "bernstein" || word == "hermite");
    if bernstein && !ends.is_empty() {
        let items = std::iter::once(expr).chain(ends.iter().cloned()).collect();
        return Ok(Kind::List(items).into());
    }
    Ok(expr)
}

/// Reads a text as one formula.
pub(super) fn formula(file: &SourceFile) -> Result<Expr, Box<Failure>> {
    read(file, None).map_err(|problem| Box::new(Failure { problem, file: file.clone() }))
}

/// Reads `a, b, c`.
pub(super) fn list(file: &SourceFile) -> Result<Vec<Expr>, Box<Failure>> {
    Ok(match formula(file)? {
        Expr { kind: Kind::Sequence(items), .. } => items,
        one => vec![one],
    })
}

pub(super) fn evaluated(
    session: &mut Session,
    file: &SourceFile,
    mut expr: Expr,
) -> Result<Value, Box<Failure>> {
    match session.evaluate(&mut expr, Equals::Claims) {
        Ok(outcome) => Ok(outcome.value),
        Err(problem) => Err(Box::new(Failure { problem, file: file.clone() })),
    }
}

/// The value of an operand given on the command line: `F(t) = t^2` is its right-hand side.
pub(super) fn operand(session: &mut Session, file: &SourceFile) -> Result<Value, Box<Failure>> {
    let answer = session.run_statement(file, None, Equals::DefinesUnbound)?;
    Ok(answer.outcome.value)
}

/// name(arguments, named), with errors placed at `span` of the file.
pub(super) fn query(
    session: &mut Session,
    file: &SourceFile,
    span: Span,
    name: &str,
    arguments: Vec<Expr>,
    named: Vec<(&str, Expr)>,
) -> Result<Value, Box<Failure>> {
    let mut items = arguments;
    items.extend(named.into_iter().map(|(name, value)| Expr::relation(Expr::name(name), Rel::Eq, value)));
    for item in &mut items {
        if item.span == Span::default() {
            item.span = span;
        }
        if let Kind::Chain(_, links) = &mut item.kind {
            links.iter_mut().for_each(|link| link.expr.span = span);
        }
    }
    let call = Expr::new(Kind::Apply(Box::new(Expr::name(name)), vec![items]), span);
    evaluated(session, file, call)
}

fn combine(session: &mut Session, output: &Output, two: &Two, name: &str) -> Ran {
    let (f_file, g_file) = (SourceFile::new("<F>", two.f.as_str()), SourceFile::new("<G>", two.g.as_str()));
    let f = operand(session, &f_file)?;
    let g = operand(session, &g_file)?;
    session.env.set(Symbol::new("F"), f.clone());
    session.env.set(Symbol::new("G"), g.clone());
    let whole = Span::new(0, two.f.len());
    // Both operands are made polar forms first, so that what is wrong is shown where it stands.
    let (f_name, g_name) = (Expr::name("F"), Expr::name("G"));
    let f_polar = query(session, &f_file, whole, "polar", vec![f_name.clone()], vec![])?;
    let g_whole = Span::new(0, two.g.len());
    let g_polar = query(session, &g_file, g_whole, "polar", vec![g_name.clone()], vec![])?;
    session.env.set(Symbol::new("F"), f_polar.clone());
    session.env.set(Symbol::new("G"), g_polar.clone());
    if two.steps {
        let subject = vec![Expr::name(name), f_name, g_name];
        let derivation = query(session, &f_file, whole, "derive", subject, vec![])?;
        output.value(&derivation, None)?;
        return Ok(Status::Fine);
    }
    let name = format!("polar_{name}");
    let value = query(session, &f_file, whole, &name, vec![f_name, g_name], vec![])?;
    output.value(&value, Some(Expr::name("h")))?;
    Ok(Status::Fine)
}

/// Runs all statements of a text and prints their results.
fn run_all(session: &mut Session, output: &Output, file: &SourceFile, stop: bool) -> Ran {
    let mut status = Status::Fine;
    let mut ended: Option<Stop> = None;
    session.run_file(file, |_, result| {
        match result {
            Ok(answer) => match show(output, &answer) {
                Ok(shown) => status = status.max(shown),
                Err(trouble @ Trouble::Output(_)) => {
                    ended = Some(Stop::Trouble(trouble));
                    return false;
                }
                Err(trouble) => status = status.max(report(output, &trouble, file)),
            },
            Err(failure) => {
                output.failure(&failure);
                status = Status::Failed;
                return !stop;
            }
        }
        true
    });
    match ended {
        Some(stop) => Err(stop),
        None => Ok(status),
    }
}

/// Prints what a statement did.
pub(super) fn show(output: &Output, answer: &Answer) -> Result<Status, Trouble> {
    for note in &answer.outcome.notes {
        output.problem(note, &answer.file);
    }
    let name = match &answer.outcome.value {
        Value::Polar(_) => Some(answer.function_name()),
        _ => answer.outcome.defined.as_ref().map(symbol_expr),
    };
    output.value(&answer.outcome.value, name)?;
    Ok(match &answer.outcome.value {
        Value::Claim(claim) => match claim.verdict() {
            Verdict::Proved | Verdict::Sampled => Status::Fine,
            Verdict::Refuted => Status::Refuted,
            Verdict::Undecided => Status::Failed,
        },
        _ => Status::Fine,
    })
}

/// Larger scripts are refused rather than read.
const LONGEST_INPUT: u64 = 64 << 20;

fn script(session: &mut Session, output: &Output, path: &Path, stop: bool) -> Ran {
    let standard = path == Path::new("-");
    let name = if standard { "<stdin>".to_owned() } else { path.display().to_string() };
    let failed = |message: String| {
        Stop::Failed(Box::new(Failure {
            problem: Diagnostic::error(Code::File, message),
            file: SourceFile::new(name.clone(), ""),
        }))
    };
    let mut bytes = Vec::new();
    let result = if standard {
        io::stdin().lock().take(LONGEST_INPUT + 1).read_to_end(&mut bytes)
    } else {
        fs::File::open(path).and_then(|file| file.take(LONGEST_INPUT + 1).read_to_end(&mut bytes))
    };
    result.map_err(|error| failed(format!("cannot read {name}: {error}")))?;
    if bytes.len() as u64 > LONGEST_INPUT {
        return Err(failed(format!("{name} is longer than {} MB", LONGEST_INPUT >> 20)));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        failed(format!("{name} is not UTF-8 text (byte {at})"))
    })?;
    let file = SourceFile::new(name.clone(), text);
    run_all(session, output, &file, stop)
}

/// Runs definitions that a query uses.
pub(super) fn give(session: &mut Session, given: &[String]) -> Result<(), Box<Failure>> {
    for (i, definition) in given.iter().enumerate() {
        let file = SourceFile::new(format!("<given {}>", i + 1), definition.as_str());
        let mut failure = None;
        session.run_file(&file, |_, result| match result {
            Ok(_) => true,
            Err(problem) => {
                failure = Some(problem);
                false
            }
        });
        if let Some(failure) = failure {
            return Err(failure);
        }
    }
    Ok(())
}

fn check(session: &mut Session, output: &Output, claim: &str, given: &[String]) -> Ran {
    give(session, given)?;
    let file = SourceFile::new("<claim>", claim);
    let answer = session.run_statement(&file, None, Equals::Claims)?;
    if !matches!(answer.outcome.value, Value::Claim(_)) {
        let problem = Diagnostic::error(Code::Usage, "nothing is claimed here")
            .at(answer.statement.span)
            .reason("a value, not a claim")
            .hint("write an equation, for example \"f(0,1) = 1/2\"");
        return Err(Box::new(Failure { problem, file }).into());
    }
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
            let problem = Diagnostic::error(Code::Usage, format!("there is no code '{text}'"))
                .at(Span::new(0, text.len()))
                .hint("polarform explain lists all codes");
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
