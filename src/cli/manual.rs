//! What shells and readers of manuals are told of the program, made from its arguments.

use std::fs;
use std::io;
use std::path::Path;

use clap::{Command, CommandFactory};
use clap_complete::Shell;
use clap_mangen::Man;

use super::Status;
use super::arguments::Arguments;
use super::commands::{Ran, Stop};
use super::output::{Output, shown};
use crate::formula::source::{SourceFile, Span};
use crate::language::diagnostic::{Code, Diagnostic, nearest};
use crate::session::Failure;

/// Prints a script that completes the arguments of the program.
pub(super) fn completions(shell: Shell, output: &Output) -> Ran {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "polarform", &mut script);
    output.bytes(&script)?;
    Ok(Status::Fine)
}

/// Prints the page of a command, or writes all pages into a folder.
pub(super) fn man(words: &[String], folder: Option<&Path>, output: &Output) -> Ran {
    let mut program = Arguments::command().disable_help_subcommand(true);
    // Building puts the options of every command where its page is made.
    program.build();
    if let Some(folder) = folder {
        let written = fs::create_dir_all(folder).and_then(|()| write_pages(&program, folder));
        let count = written.map_err(|error| {
            let message = format!("cannot write the pages into {}: {error}", folder.display());
            failed(Diagnostic::error(Code::File, message).hint("name another folder"), "")
        })?;
        output.remark(&format!("{count} manual pages written to {}", shown(folder)));
        return Ok(Status::Fine);
    }
    let mut command = &program;
    for word in words {
        command = command.find_subcommand(word).ok_or_else(|| unknown(command, word))?;
    }
    let mut text = Vec::new();
    page(command).render(&mut text)?;
    output.bytes(&text)?;
    Ok(Status::Fine)
}

fn page(command: &Command) -> Man {
    Man::new(command.clone()).source(concat!("polarform ", env!("CARGO_PKG_VERSION"))).manual("polarform")
}

/// Writes the pages of a command and of those below it; how many these are.
fn write_pages(command: &Command, folder: &Path) -> io::Result<usize> {
    page(command).generate_to(folder)?;
    let mut count = 1;
    for below in command.get_subcommands() {
        count += write_pages(below, folder)?;
    }
    Ok(count)
}

fn unknown(command: &Command, word: &str) -> Stop {
    let known: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
    let problem = Diagnostic::error(Code::Usage, format!("there is no command '{word}' here"))
        .at(Span::new(0, word.len()));
    let problem = match nearest(word, known.iter().copied()) {
        Some(best) => problem.hint(format!("did you mean '{best}'?")),
        None if known.is_empty() => problem.hint(format!("'{}' has no commands", command.get_name())),
        None => problem.hint(format!("the commands are {}", known.join(", "))),
    };
    failed(problem, word)
}

fn failed(problem: Diagnostic, text: &str) -> Stop {
    Stop::Failed(Box::new(Failure { problem, file: SourceFile::new("<command>", text) }))
}
