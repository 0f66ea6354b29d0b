//! The command line: the only place that prints.

mod argument_reader;
mod arguments;
mod commands;
mod curves;
mod figure;
mod figure_arguments;
mod interpolate;
mod notes;
mod output;
mod repl;
mod repl_helper;
mod watch;
mod weave;

use std::process::ExitCode;

use clap::Parser;

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

/// Runs the program with the arguments of the process.
pub fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            let failed = error.use_stderr();
            // Nothing better can be done when even the message cannot be printed.
            let _ = error.print();
            return ExitCode::from(if failed { Status::Failed as u8 } else { Status::Fine as u8 });
        }
    };
    ExitCode::from(commands::run(&arguments) as u8)
}
