//! Running the built program and writing down what it did.

pub mod attack;
pub mod derivations;
pub mod errors;
pub mod expressions;
pub mod folder;
pub mod mutation;
pub mod pictures;

use std::io::Write;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// What a run of the program left behind.
pub struct Run {
    /// Exit status; `None` if a signal ended it.
    pub status: Option<i32>,
    /// Standard output.
    pub out: String,
    /// Standard error.
    pub err: String,
    /// How long it took.
    pub time: Duration,
}

/// The program with arguments, in a plain environment.
pub fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_polarform"));
    command.args(arguments).env("NO_COLOR", "1").env_remove("RUST_BACKTRACE");
    command
}

/// Runs the program with an empty standard input.
pub fn run(arguments: &[&str]) -> Run {
    run_with(arguments, b"")
}

/// Runs the program with the given standard input.
pub fn run_with(arguments: &[&str], input: &[u8]) -> Run {
    let begin = Instant::now();
    let mut child = command(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("standard input is piped");
    let input = input.to_vec();
    // The program may end before it has read everything: a broken pipe is no failure here.
    let writer = std::thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().expect("the program ends");
    writer.join().expect("writing does not panic");
    Run {
        status: output.status.code(),
        out: String::from_utf8(output.stdout).expect("results are UTF-8"),
        err: String::from_utf8(output.stderr).expect("messages are UTF-8"),
        time: begin.elapsed(),
    }
}

/// A session as it would look on a terminal: the command, its results, its messages, its status.
pub fn transcript(arguments: &[&str]) -> String {
    let mut text = String::from("$ polarform");
    for argument in arguments {
        let plain =
            !argument.is_empty() && argument.chars().all(|c| c.is_ascii_alphanumeric() || "-_.,".contains(c));
        let quoted = if plain { (*argument).to_owned() } else { format!("'{argument}'") };
        text.push(' ');
        text.push_str(&quoted);
    }
    text.push('\n');
    let ran = run(arguments);
    text.push_str(&ran.out);
    for line in ran.err.lines() {
        text.push_str(format!("! {line}").trim_end());
        text.push('\n');
    }
    if ran.status != Some(0) {
        text.push_str(&format!("(exit status {})\n", ran.status.unwrap_or(-1)));
    }
    text
}

/// Several sessions, one after the other.
pub fn transcripts<'a>(runs: impl IntoIterator<Item = Vec<&'a str>>) -> String {
    runs.into_iter().map(|arguments| transcript(&arguments)).collect::<Vec<_>>().join("\n")
}

/// The names of the output formats.
pub const FORMATS: [&str; 5] = ["text", "unicode", "latex", "json", "sympy"];

/// The same command in every output format.
pub fn in_every_format(arguments: &[&str]) -> String {
    transcripts(FORMATS.map(|format| [arguments, &["--format", format]].concat()))
}
