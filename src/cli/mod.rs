//! The command line: the only place that prints.

mod argument_reader;
mod arguments;
mod commands;
mod curves;
mod figure;
mod figure_arguments;
mod given;
mod interpolate;
mod lsp;
mod manual;
mod notes;
mod notes_arguments;
mod notes_config;
mod notes_input;
mod output;
mod raster;
mod repl;
mod repl_helper;
mod script;
mod waiting;
mod watch;
mod weave;

use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

use clap::Parser;
use clap::error::{ContextKind, ContextValue};

use arguments::Arguments;

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

/// A formula or a function in the place of a command is for `eval`; in the place of the kind of a
/// figure, it needs that kind before it.
fn advise(error: &mut clap::Error) {
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
    let Some(ContextValue::String(given)) = error.get(ContextKind::InvalidSubcommand) else { return };
    let word = given.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'-' || byte == b'_');
    let advice = match (word, crate::language::functions::builtin(given)) {
        (false, _) => "a formula is evaluated by 'polarform eval FORMULA', in quotation marks".to_owned(),
        (true, Some(function)) => {
            format!("a function of the language: polarform eval \"{}\"", function.example)
        }
        (true, None) => return,
    };
    error.remove(ContextKind::SuggestedSubcommand);
    error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![advice.into()]));
}

/// Runs the program with the arguments of the process.
pub fn main() -> ExitCode {
    let arguments = match Arguments::try_parse_from(std::env::args_os().map(formula_or_option)) {
        Ok(arguments) => arguments,
        Err(mut error) => {
            advise(&mut error);
            // Help that cannot be printed is a failure; nothing better can be done about a message.
            let printed = error.print().and_then(|()| std::io::stdout().flush());
            let failed = error.use_stderr() || printed.is_err();
            return ExitCode::from(if failed { Status::Failed as u8 } else { Status::Fine as u8 });
        }
    };
    ExitCode::from(commands::run(&arguments) as u8)
}
