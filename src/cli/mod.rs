//! The command line: the only place that prints.

mod argument_reader;
mod arguments;
mod beside;
mod commands;
mod curves;
mod figure;
mod figure_arguments;
mod interpolate;
mod lsp;
mod manual;
mod notes;
mod notes_arguments;
mod notes_config;
mod notes_input;
mod output;
mod pictures;
mod raster;
mod repl;
mod repl_helper;
mod script;
mod waiting;
mod watch;
mod weave;

use std::ffi::OsString;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

use clap::Parser;
use clap::error::{ContextKind, ContextValue};

use arguments::Arguments;

use crate::document::Container;
use crate::language::write::Format;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Status {
    /// Done; all claims are true.
    Fine = 0,
    /// A claim is refuted.
    Refuted = 1,
    /// Something could not be read or decided.
    Failed = 2,
}

/// A formula that begins with a minus sign, `-2^2` or `-t`, is no option: a blank before it tells.
fn formula_or_option(argument: OsString) -> OsString {
    let is_formula = argument.to_str().and_then(|text| text.strip_prefix('-')).is_some_and(|rest| {
        let mut characters = rest.chars();
        match (characters.next(), characters.next()) {
            (Some(first), None) => first.is_ascii_digit(),
            (Some(first), Some(second)) => {
                first.is_ascii_digit()
                    || matches!(first, '(' | '[' | '\\' | '.')
                    || (first.is_ascii_alphabetic()
                        && matches!(second, '^' | '_' | '*' | '+' | '/' | ' ' | '('))
            }
            _ => false,
        }
    });
    match is_formula {
        true => {
            let mut spaced = OsString::from(" ");
            spaced.push(argument);
            spaced
        }
        false => argument,
    }
}

/// A function or a file in the place of a command is for another one; in the place of the kind of a
/// figure, a function needs that kind before it; `--latex` is a format.
fn advise(error: &mut clap::Error, arguments: &[OsString]) {
    if let Some(ContextValue::String(given)) = error.get(ContextKind::InvalidValue)
        && let Some((function, _)) = given.split_once('(')
        && matches!(error.get(ContextKind::InvalidArg), Some(ContextValue::String(name)) if name == "<KIND>")
    {
        let kind = if function.starts_with("figure_") { "query" } else { function };
        let advice = format!("the kind of the figure goes first: polarform figure {kind} \"{given}\"");
        error.remove(ContextKind::SuggestedValue);
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![advice.into()]));
        return;
    }
    if let Some(ContextValue::String(given)) = error.get(ContextKind::InvalidArg)
        && let Ok(format) = given.trim_start_matches('-').parse::<Format>()
    {
        let advice = format!("results are printed so by --format {}", format.name());
        error.remove(ContextKind::SuggestedArg);
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![advice.into()]));
        return;
    }
    let Some(ContextValue::String(given)) = error.get(ContextKind::InvalidSubcommand) else { return };
    let advice = match crate::language::functions::builtin(given) {
        _ if is_page(given) => format!("formulas in a file are checked by: polarform notes check {given}"),
        Some(function) => {
            let rest = arguments.iter().skip_while(|argument| argument.to_str() != Some(given)).skip(1);
            let own: Vec<_> = rest.filter_map(|argument| argument.to_str()).map(str::trim).collect();
            let call = match own.is_empty() || own.iter().any(|argument| argument.starts_with('-')) {
                true => function.example.to_owned(),
                false => format!("{given}({})", own.join(", ")),
            };
            format!("a function of the language: polarform \"{call}\"")
        }
        None => return,
    };
    error.remove(ContextKind::SuggestedSubcommand);
    error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![advice.into()]));
}

/// A word, as commands, functions and files are named.
fn is_word(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'-' || byte == b'_')
}

/// Reads the arguments. A formula in the place of a command is evaluated: `polarform "t^2 for t = 3"`.
fn read(arguments: Vec<OsString>) -> Result<Arguments, clap::Error> {
    Arguments::try_parse_from(&arguments).or_else(|mut error| {
        advise(&mut error, &arguments);
        let Some(ContextValue::String(given)) = error.get(ContextKind::InvalidSubcommand) else {
            return Err(error);
        };
        let at = arguments.iter().position(|argument| argument.to_str() == Some(given));
        match at.filter(|_| !is_word(given) && !is_page(given)) {
            Some(at) => {
                let (before, mut formulas) = arguments.split_at(at);
                // polarform -- "-t^2": the command goes before the dashes.
                let before = match before.split_last() {
                    Some((dashes, rest)) if dashes == "--" => {
                        formulas = &arguments[at - 1..];
                        rest
                    }
                    _ => before,
                };
                Arguments::try_parse_from([before, &[OsString::from("eval")], formulas].concat())
            }
            None => Err(error),
        }
    })
}

/// Whether a file is named in the place of a command.
fn is_page(given: &str) -> bool {
    let path = Path::new(given);
    path.exists() || path.extension().is_some() && Container::of(path).is_ok()
}

/// Runs the program with the arguments of the process.
pub fn main() -> ExitCode {
    let arguments = match read(std::env::args_os().map(formula_or_option).collect()) {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help that cannot be printed is a failure; nothing better can be done about a message.
            let printed = error.print().and_then(|()| std::io::stdout().flush());
            let failed = error.use_stderr() || printed.is_err();
            return ExitCode::from(if failed { Status::Failed as u8 } else { Status::Fine as u8 });
        }
    };
    ExitCode::from(commands::run(&arguments) as u8)
}
