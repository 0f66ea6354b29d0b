//! Expressions as they are typed in lectures, with the value each of them must have, and a
//! whole session, line by line.
//!
//! A file of `tests/corpus/expressions` holds lines `expression  ==>  result`; lines
//! `given: definition` hold for all of the file, `#` starts a comment. The result is
//!
//! - of a value: its plain text, a polar form with its arguments as f(t1, …, tn) = …;
//! - of a claim: one word, `true`, `false` or `undecided`; of a chain, `false` if any of its
//!   relations is refuted, else `undecided` if any is.
//!
//! Every result was worked out without this program.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use polarform::session::Session;
use polarform::value::{Value, Verdict};
use polarform::write;

/// What stands between an expression and its result.
const ARROW: &str = "  ==>  ";

fn files(folder: &str) -> Vec<(PathBuf, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(folder);
    let mut paths: Vec<PathBuf> =
        fs::read_dir(&folder).expect("the folder is there").map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "txt"));
    paths.sort();
    assert!(!paths.is_empty(), "no files in {}", folder.display());
    paths
        .into_iter()
        .map(|path| {
            let text = fs::read_to_string(&path).unwrap();
            (path, text)
        })
        .collect()
}

/// The result as the corpus gives it.
fn shown(value: &Value) -> String {
    match value {
        Value::Claim(claim) => match claim.verdict() {
            Verdict::Proved => "true".to_owned(),
            Verdict::Sampled => "sampled".to_owned(),
            Verdict::Refuted => "false".to_owned(),
            Verdict::Undecided => "undecided".to_owned(),
        },
        value => write::text(&value.to_expr()),
    }
}

#[test]
fn expressions_are_read_as_meant() {
    let (mut count, mut wrong) = (0, String::new());
    for (path, text) in files("corpus/expressions") {
        let mut given = Session::default();
        for (at, line) in text.lines().enumerate().map(|(i, line)| (i + 1, line)) {
            let place = format!("{}:{at}", path.file_name().unwrap_or_default().to_string_lossy());
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            if let Some(definition) = line.strip_prefix("given: ") {
                let done = given.run(definition);
                let defined = done.unwrap_or_else(|failure| panic!("{place}: {:?}", failure.problem));
                assert!(defined.outcome.defined.is_some(), "{place} defines nothing");
                continue;
            }
            let Some((expression, wanted)) = line.split_once(ARROW) else {
                panic!("{place}: no result is given")
            };
            count += 1;
            let found = match given.clone().run(expression) {
                Ok(answer) => match answer.outcome.defined {
                    Some(name) => format!("(a definition of {name})"),
                    None => shown(&answer.outcome.value),
                },
                Err(failure) => format!("({:?})", failure.problem),
            };
            if found != wanted {
                let _ = writeln!(wrong, "{place}: {expression}\n  wanted {wanted}\n  found  {found}");
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(count >= 200, "only {count} expressions");
}

/// A hint that is followed leads to a result: what is refused, what its hint says, what that gives.
#[test]
fn hints_work_when_followed() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/hints.txt");
    let text = fs::read_to_string(path).unwrap();
    let (mut given, mut wrong) = (Session::default(), String::new());
    for (at, line) in text.lines().enumerate().map(|(i, line)| (i + 1, line)) {
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        if let Some(definition) = line.strip_prefix("given: ") {
            given.run(definition).unwrap_or_else(|failure| panic!("line {at}: {:?}", failure.problem));
            continue;
        }
        let parts: Vec<&str> = line.split(ARROW).collect();
        let [refused, advice, written, wanted] = parts.as_slice() else {
            panic!("line {at} has not 4 parts")
        };
        match given.clone().run(refused) {
            Ok(answer) => {
                let _ = writeln!(wrong, "line {at}: {refused} gives {}", shown(&answer.outcome.value));
            }
            Err(failure) => {
                let hints = &failure.problem.hints;
                if !hints.iter().any(|hint| hint.contains(advice)) || failure.problem.span.is_none() {
                    let _ = writeln!(wrong, "line {at}: {refused}\n  wanted {advice}\n  found  {hints:?}");
                }
            }
        }
        let found = match given.clone().run(written) {
            Ok(answer) => shown(&answer.outcome.value),
            Err(failure) => format!("({:?})", failure.problem),
        };
        if found != *wanted {
            let _ = writeln!(wrong, "line {at}: {written}\n  wanted {wanted}\n  found  {found}");
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn no_expression_is_there_twice() {
    for (path, text) in files("corpus/expressions") {
        let mut lines: Vec<&str> = text.lines().filter_map(|line| line.split(ARROW).next()).collect();
        lines.retain(|line| !line.is_empty());
        let count = lines.len();
        lines.sort_unstable();
        lines.dedup();
        assert_eq!(lines.len(), count, "{}", path.display());
    }
}

/// What the program prints for a session typed so far: results, then problems and remarks.
fn printed(typed: &str) -> (String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_polarform")).write_stdin(typed).output().unwrap();
    (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
}

/// In a transcript lines that start with `> ` are typed; what is printed follows each of them.
///
/// Piped input shows no prompts, so the answer to a line is what the session prints with it
/// and does not print without it.
#[test]
fn transcripts_come_out_as_written() {
    for (path, text) in files("transcripts") {
        let (mut typed, mut before) = (String::new(), (String::new(), String::new()));
        let mut found = String::new();
        for line in text.lines() {
            if line.starts_with('#') || line.is_empty() {
                found += line;
                found.push('\n');
            }
            let Some(input) = line.strip_prefix("> ") else { continue };
            typed += input;
            typed.push('\n');
            let after = printed(&typed);
            let _ = writeln!(found, "{line}");
            for (before, after) in [(&before.0, &after.0), (&before.1, &after.1)] {
                let new = after.strip_prefix(before.as_str()).expect("earlier answers do not change");
                found += new;
            }
            before = after;
        }
        if std::env::var_os("UPDATE_CORPUS").is_some() {
            std::fs::write(&path, found).expect("the transcripts are writable");
            continue;
        }
        assert_eq!(found, text, "{}: run with UPDATE_CORPUS=1 to accept", path.display());
    }
}

/// What a session answers, as text.
fn answer(session: &Session, query: &str) -> String {
    let outcome =
        session.clone().run(query).unwrap_or_else(|failure| panic!("{query}: {:?}", failure.problem));
    write::text(&outcome.outcome.value.to_expr())
}

/// A sum up to symbols has the values of the sums up to numbers, from where it is empty.
#[test]
fn sums_up_to_symbols() {
    let session = Session::default();
    for body in ["1", "k", "k^2 - 3 k + 1/2", "t (k + 1)^3", "k^6/7 - k(k - 1) a", "0"] {
        for first in -2..=3 {
            for last in first - 1..=first + 5 {
                let plain = answer(&session, &format!("sum(k={first}..{last}, {body})"));
                let upper = format!("subs(sum(k={first}..n, {body}), n={last})");
                let both = format!("subs(sum(k=m..n, {body}), m={first}, n={last})");
                assert_eq!(answer(&session, &upper), plain, "{upper}");
                assert_eq!(answer(&session, &both), plain, "{both}");
            }
        }
    }
}

/// The limit of the difference quotient is the derivative, that at infinity the quotient of the leading coefficients.
#[test]
fn limits() {
    let session = Session::default();
    for formula in ["t^3 - 2t", "1/(t + 1)", "a t^2/(t - b)", "7", "(t^2 - 1)/(t - 1)"] {
        let mut session = session.clone();
        session.run(&format!("F(t) := {formula}")).unwrap();
        let quotient = r"\lim_{h \to 0} \frac{F(t + h) - F(t)}{h}";
        assert_eq!(answer(&session, quotient), answer(&session, &format!("diff({formula}, t)")), "{formula}");
    }
    for (above, below, limit) in
        [("3n^2 + n", "2n^2 - 1", "3/2"), ("n", "n^2 + 1", "0"), ("a n + b", "c n", "a/c")]
    {
        let query = format!(r"\lim_{{n \to \infty}} \frac{{{above}}}{{{below}}}");
        assert_eq!(answer(&session, &query), limit, "{query}");
    }
}
