//! The interactive session.

use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use rustyline::error::ReadlineError;
use rustyline::history::FileHistory;
use rustyline::{Config, Editor};

use super::Status;
use super::argument_reader::ArgumentReader;
use super::commands;
use super::output::{Output, Trouble, shown};
use super::repl_helper::Helper;
use super::waiting::Waiting;
use crate::budget::MOST_DEPTH;
use crate::document::read_string;
use crate::figure::{TikzOptions, tikz};
use crate::formula::source::SourceFile;
use crate::formula::{Expr, Kind, call, named};
use crate::language::diagnostic::{Code, Diagnostic, nearest};
use crate::language::syntax;
use crate::language::value::{Notation, Value, symbol_expr};
use crate::language::write::{Format, text};
use crate::math::blossom::Method;
use crate::math::poly::Symbol;
use crate::session::Session;

/// A command of the session, as listed by `:help`.
pub(super) struct ColonCommand {
    pub name: &'static str,
    pub usage: &'static str,
    pub summary: &'static str,
}

pub(super) const COLON_COMMANDS: &[ColonCommand] = &[
    ColonCommand { name: "help", usage: ":help [NAME]", summary: "this list, or about a function" },
    ColonCommand { name: "functions", usage: ":functions", summary: "all functions" },
    ColonCommand { name: "explain", usage: ":explain CODE", summary: "about an error code" },
    ColonCommand { name: "text", usage: ":text", summary: "print plain text" },
    ColonCommand { name: "unicode", usage: ":unicode", summary: "print t₁t₂" },
    ColonCommand { name: "latex", usage: ":latex", summary: "print LaTeX" },
    ColonCommand { name: "json", usage: ":json", summary: "print JSON" },
    ColonCommand { name: "sympy", usage: ":sympy", summary: "print SymPy syntax" },
    ColonCommand {
        name: "notation",
        usage: ":notation NAME",
        summary: "polar forms as grouped, expanded, sigma or ellipsis",
    },
    ColonCommand {
        name: "arrange",
        usage: ":arrange NAME",
        summary: "formulas as usual, or by collect, expand, factor, in_powers, in_bernstein",
    },
    ColonCommand {
        name: "steps",
        usage: ":steps [METHOD] POLYNOMIAL",
        summary: "derive a polar form step by step",
    },
    ColonCommand { name: "time", usage: ":time", summary: "show how long statements take, on or off" },
    ColonCommand { name: "timeout", usage: ":timeout SECONDS", summary: "time allowed (0: no limit)" },
    ColonCommand { name: "max-terms", usage: ":max-terms N", summary: "terms a value may have" },
    ColonCommand {
        name: "max-depth",
        usage: ":max-depth N",
        summary: "how deeply functions may call each other",
    },
    ColonCommand { name: "vars", usage: ":vars", summary: "the names defined here" },
    ColonCommand { name: "forget", usage: ":forget NAME", summary: "forget a name" },
    ColonCommand { name: "reset", usage: ":reset", summary: "forget everything" },
    ColonCommand { name: "save", usage: ":save FILE", summary: "save the session as a script" },
    ColonCommand { name: "load", usage: ":load FILE", summary: "run a script here" },
    ColonCommand { name: "copy", usage: ":copy", summary: "the last result alone, as LaTeX, for copying" },
    ColonCommand { name: "quit", usage: ":quit", summary: "leave (also Ctrl-D)" },
];

/// Lines kept in the history file.
const HISTORY_LINES: usize = 2000;

struct Repl<'a> {
    session: &'a mut Session,
    output: &'a mut Output,
    /// Statements that succeeded, for `:save`.
    log: Vec<String>,
    timing: bool,
    count: usize,
}

/// Reads statements until the end of input.
pub(super) fn run(session: &mut Session, output: &mut Output) -> Status {
    // Ctrl-C during a computation sets the flag that the computation looks at; while a line
    // is edited the terminal delivers it as a key instead.
    let interrupt = session.limits.interrupt.clone();
    let handler = ctrlc::set_handler(move || interrupt.store(true, Ordering::Relaxed));
    if handler.is_err() {
        let _ = writeln!(io::stderr(), "Ctrl-C will end the program: its handler could not be installed");
    }
    let config = Config::builder()
        .auto_add_history(false)
        .max_history_size(HISTORY_LINES)
        .map(|builder| builder.build())
        .unwrap_or_default();
    let mut editor: Editor<Helper, FileHistory> = match Editor::with_config(config) {
        Ok(editor) => editor,
        Err(error) => {
            let problem = Diagnostic::error(Code::File, format!("no line editing here: {error}"));
            output.problem(&problem, &SourceFile::new("<terminal>", ""));
            return Status::Failed;
        }
    };
    editor.set_helper(Some(Helper::new(io::stdout().is_terminal())));
    let history = history_file();
    if let Some(path) = &history {
        // A first session has no history yet.
        let _ = editor.load_history(path);
    }
    let mut repl = Repl { session, output, log: Vec::new(), timing: false, count: 0 };
    let _ = repl
        .output
        .line(&format!("polarform {} — :help for help, :quit to leave", env!("CARGO_PKG_VERSION")));
    loop {
        if let Some(helper) = editor.helper_mut() {
            helper.set_names(repl.session.names());
        }
        match editor.readline("> ") {
            Ok(line) => {
                if line.trim().is_empty() {
                    continue;
                }
                let _ = editor.add_history_entry(line.as_str());
                if let Some(path) = &history {
                    let _ = save_history(&mut editor, path);
                }
                match repl.line(&line) {
                    Ok(true) => {}
                    Ok(false) => return Status::Fine,
                    Err(Trouble::Output(_)) => return Status::Fine,
                    Err(Trouble::Problem(problem)) => {
                        repl.output.problem(&problem, &SourceFile::new("<input>", line.as_str()));
                    }
                }
            }
            Err(ReadlineError::Interrupted) => {}
            Err(ReadlineError::Eof) => return Status::Fine,
            Err(ReadlineError::Io(error)) if error.kind() == io::ErrorKind::InvalidData => {
                let problem = Diagnostic::error(Code::File, "this line is not UTF-8 text")
                    .hint("type it again; nothing is lost");
                repl.output.problem(&problem, &SourceFile::new("<terminal>", ""));
            }
            Err(error) => {
                let problem = Diagnostic::error(Code::File, format!("cannot read the line: {error}"));
                repl.output.problem(&problem, &SourceFile::new("<terminal>", ""));
                return Status::Failed;
            }
        }
    }
}

fn save_history(editor: &mut Editor<Helper, FileHistory>, path: &Path) -> rustyline::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    editor.save_history(path)
}

/// `POLARFORM_HISTORY`, or a file in the state folder of the user.
fn history_file() -> Option<PathBuf> {
    if let Some(path) = std::env::var_os("POLARFORM_HISTORY") {
        return (!path.is_empty()).then(|| PathBuf::from(path));
    }
    let state = std::env::var_os("XDG_STATE_HOME").map(PathBuf::from).or_else(|| {
        let home = std::env::var_os("HOME").or_else(|| std::env::var_os("USERPROFILE"))?;
        Some(PathBuf::from(home).join(".local/state"))
    })?;
    Some(state.join("polarform/history"))
}

/// Runs what comes on standard input: statements and commands, one after the other.
pub(super) fn piped(session: &mut Session, output: &mut Output, file: &SourceFile) -> commands::Ran {
    let Ok(spans) = syntax::statements(file.text()) else {
        return commands::run_all(session, output, file, false);
    };
    let mut status = Status::Fine;
    for span in spans {
        let mut repl = Repl { session, output, log: Vec::new(), timing: false, count: 0 };
        let Some(command) = repl.command_in(file.slice(span)) else {
            status = status.max(commands::run_statement(session, output, file, span)?);
            continue;
        };
        match repl.command(&command) {
            Ok(true) => {}
            Ok(false) => break,
            Err(Trouble::Problem(problem)) => {
                output.problem(&problem.at(span), file);
                status = Status::Failed;
            }
            Err(trouble) => return Err(trouble.into()),
        }
    }
    Ok(status)
}

impl Repl<'_> {
    /// Carries out one input; false means leave.
    fn line(&mut self, line: &str) -> Result<bool, Trouble> {
        match self.command_in(line) {
            Some(command) => self.command(&command),
            None => {
                self.statements(line.trim_end())?;
                Ok(true)
            }
        }
    }

    /// The command that an input is, with or without its colon.
    fn command_in(&self, line: &str) -> Option<String> {
        let line = line.trim();
        match line.strip_prefix(':') {
            Some(command) if !command.starts_with('=') => Some(command.to_owned()),
            _ => spoken(line, |name| self.session.env.get(&Symbol::new(name)).is_some()),
        }
    }

    fn statements(&mut self, text: &str) -> Result<(), Trouble> {
        self.count += 1;
        let file = SourceFile::new(format!("<input {}>", self.count), text);
        let start = Instant::now();
        self.session.limits.interrupt.store(false, Ordering::Relaxed);
        let mut trouble = None;
        let (output, log) = (&*self.output, &mut self.log);
        let mut waiting = Some(Waiting::of(text));
        output.begin();
        self.session.run_file(&file, |_, result| match result {
            Ok(answer) => {
                waiting = None;
                log.push(answer.file.slice(answer.statement.span).to_owned());
                match commands::show(output, &answer) {
                    Ok(_) => true,
                    Err(error) => {
                        trouble = Some(error);
                        false
                    }
                }
            }
            Err(failure) => {
                waiting = None;
                output.failure(&failure);
                false
            }
        });
        if self.timing {
            self.output.line(&format!("({:.1} ms)", start.elapsed().as_secs_f64() * 1000.0))?;
        }
        match trouble {
            Some(trouble) => Err(trouble),
            None => Ok(()),
        }
    }

    fn command(&mut self, command: &str) -> Result<bool, Trouble> {
        let (name, rest) = command.split_once(char::is_whitespace).unwrap_or((command, ""));
        let rest = rest.trim();
        match name {
            "quit" | "q" | "exit" => return Ok(false),
            "help" | "h" | "?" if rest.is_empty() => self.help()?,
            "help" | "h" | "?" => self.about(rest)?,
            "functions" => commands::functions(self.output, None).map(drop).or_else(commands::settle)?,
            "explain" => {
                let code = (!rest.is_empty()).then_some(rest);
                commands::explain(self.output, code).map(drop).or_else(commands::settle)?;
            }
            "notation" => {
                self.output.notation = match rest {
                    "grouped" => Notation::Grouped,
                    "expanded" => Notation::Expanded,
                    "sigma" => Notation::Sigma,
                    "ellipsis" => Notation::Ellipsis,
                    _ => return Err(usage(":notation grouped, expanded, sigma or ellipsis")),
                }
            }
            "arrange" => {
                self.session.arrangement = rest.parse().map_err(|_| {
                    usage(":arrange usual, collect, expand, factor, in_powers or in_bernstein")
                })?;
            }
            "steps" => self.steps(rest)?,
            "time" => {
                self.timing = !self.timing;
                self.output.line(if self.timing { "timing on" } else { "timing off" })?;
            }
            "timeout" => {
                let seconds: f64 =
                    rest.parse().ok().filter(|s: &f64| *s >= 0.0).ok_or_else(|| usage(":timeout SECONDS"))?;
                let time = Duration::try_from_secs_f64(seconds).map_err(|_| usage(":timeout SECONDS"))?;
                self.session.limits.time = (seconds > 0.0).then_some(time);
            }
            "max-terms" => {
                self.session.limits.terms = rest.parse().map_err(|_| usage(":max-terms N"))?;
            }
            "max-depth" => {
                let depth = rest.parse().ok().filter(|depth| *depth <= MOST_DEPTH);
                self.session.limits.depth = depth.ok_or_else(|| usage(":max-depth N with N up to 20000"))?;
            }
            "vars" => self.vars()?,
            "forget" => {
                let found = self
                    .session
                    .env
                    .iter()
                    .map(|(symbol, _)| symbol)
                    .find(|symbol| symbol.to_string() == rest || text(&symbol_expr(symbol)) == rest);
                match found.cloned() {
                    Some(symbol) => {
                        self.session.env.remove(&symbol);
                    }
                    None => return Err(usage(":forget NAME, for a name listed by :vars")),
                }
            }
            "reset" => {
                self.session.env = Default::default();
                self.log.clear();
            }
            "save" => self.save(rest)?,
            "load" => self.load(rest)?,
            "copy" => {
                let last = self.session.env.get(&Symbol::new("ans")).cloned();
                let last = last.ok_or_else(|| usage(":copy after a result"))?;
                if let Value::Figure(scene) = &last {
                    self.output.text(&tikz(scene, &TikzOptions::default()))?;
                    return Ok(true);
                }
                let body = match &last {
                    Value::Polar(polar) => polar.body(self.output.notation),
                    other => other.to_expr(),
                };
                self.output.line(&crate::language::write::latex(&body))?;
            }
            _ => match name.parse::<Format>() {
                Ok(format) => self.output.format = format,
                Err(_) => {
                    let known = COLON_COMMANDS.iter().map(|command| command.name);
                    let problem = Diagnostic::error(Code::Usage, format!("there is no command :{name}"));
                    return Err(Trouble::Problem(Box::new(match nearest(name, known) {
                        Some(best) => problem.hint(format!("did you mean :{best}?")),
                        None => problem.hint(":help lists the commands"),
                    })));
                }
            },
        }
        Ok(true)
    }

    fn help(&self) -> Result<(), Trouble> {
        self.output.line("Type a formula, a definition (f := polar(t^2)) or a claim (f(0,1) = 0).")?;
        self.output.line("LaTeX works too: \\frac{1}{2} t^2. The last result is called ans.\n")?;
        for command in COLON_COMMANDS {
            self.output.line(&format!("  {:<28} {}", command.usage, command.summary))?;
        }
        Ok(())
    }

    fn about(&self, name: &str) -> Result<(), Trouble> {
        if let Ok(code) = name.parse::<Code>() {
            return commands::explain(self.output, Some(code.id())).map(drop).or_else(commands::settle);
        }
        if let Some(command) = COLON_COMMANDS.iter().find(|c| c.name == name.trim_start_matches(':')) {
            return Ok(self.output.line(&format!("{}  {}", command.usage, command.summary))?);
        }
        commands::functions(self.output, Some(name)).map(drop).or_else(commands::settle)
    }

    fn steps(&mut self, rest: &str) -> Result<(), Trouble> {
        let (method, polynomial) = match rest.split_once(char::is_whitespace) {
            Some((first, others)) if first.parse::<Method>().is_ok() => {
                (first.parse().unwrap_or(Method::Elementary), others)
            }
            _ => (Method::Elementary, rest),
        };
        if polynomial.trim().is_empty() {
            return Err(usage(":steps POLYNOMIAL, or :steps taylor POLYNOMIAL"));
        }
        let mut reader = ArgumentReader::new(self.output);
        // What follows the polynomial may be named arguments, such as degree = 3.
        let query = reader.items("steps", polynomial).map(|mut arguments| {
            let whole = reader.last_span();
            arguments.insert(0, Expr::new(Kind::Name("polar".to_owned()), whole));
            arguments.push(named("method", reader.word("method", method.name())));
            call("derive", arguments, whole)
        });
        // The names stay as they are: only the value is of interest.
        let before = self.session.env.clone();
        let result = query.and_then(|query| reader.evaluate(self.session, query));
        self.session.env = before;
        match result {
            Ok(derivation) => self.output.value(&derivation, None)?,
            Err(failure) => self.output.failure(&failure),
        }
        Ok(())
    }

    fn vars(&self) -> Result<(), Trouble> {
        let mut any = false;
        for (name, value) in self.session.env.iter() {
            any = true;
            let name = text(&symbol_expr(name));
            self.output.line(&format!("{name:<12} {}", value.kind()))?;
        }
        if !any {
            self.output.line("nothing is defined yet")?;
        }
        Ok(())
    }

    fn save(&self, path: &str) -> Result<(), Trouble> {
        if path.is_empty() {
            return Err(usage(":save FILE"));
        }
        let mut script = String::from("# a polarform session; run it with: polarform run FILE\n");
        for statement in &self.log {
            script.push_str(statement.trim());
            script.push('\n');
        }
        fs::write(path, script).map_err(|error| file_problem(path, &error))?;
        Ok(self.output.line(&format!("saved {} statements to {}", self.log.len(), shown(Path::new(path))))?)
    }

    fn load(&mut self, path: &str) -> Result<(), Trouble> {
        if path.is_empty() {
            return Err(usage(":load FILE"));
        }
        let script = read_string(Path::new(path)).map_err(|problem| Trouble::Problem(Box::new(problem)))?;
        self.statements(&script)
    }
}

/// A command written without its colon, as at other prompts: `help`, `quit()`, `? polar`. A name that
/// is defined is that name.
fn spoken(line: &str, defined: impl Fn(&str) -> bool) -> Option<String> {
    if let Some(name) = line.strip_prefix('?').or_else(|| line.strip_suffix('?')) {
        return Some(format!("help {}", name.trim()));
    }
    let bare = line.strip_suffix("()").unwrap_or(line);
    let (word, rest) = bare.split_once(char::is_whitespace).unwrap_or((bare, ""));
    match word {
        _ if defined(word) => None,
        "help" if rest.split_whitespace().count() <= 1 => Some(bare.to_owned()),
        "quit" | "exit" if rest.is_empty() => Some("quit".to_owned()),
        _ => None,
    }
}

fn usage(form: &str) -> Trouble {
    Trouble::Problem(Box::new(Diagnostic::error(Code::Usage, format!("the form is {form}"))))
}

fn file_problem(path: &str, error: &io::Error) -> Trouble {
    Trouble::Problem(Box::new(Diagnostic::error(Code::File, format!("{path}: {error}"))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_need_no_colon() {
        let said = |line| spoken(line, |name| name == "exit");
        for (line, command) in [
            ("help", Some("help")),
            ("help polar", Some("help polar")),
            ("? polar", Some("help polar")),
            ("polar?", Some("help polar")),
            ("quit", Some("quit")),
            ("quit()", Some("quit")),
            ("exit", None),
            ("help me please", None),
            ("t^2", None),
        ] {
            assert_eq!(said(line).as_deref(), command, "{line}");
        }
    }
}
