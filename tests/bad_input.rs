//! Whatever is typed: a code, a place, a hint, soon, in little memory, and never a panic.

use std::time::{Duration, Instant};

use crate::common::{Run, errors, run, run_with};
use polarform::diagnostic::{Code, Severity, render};
use polarform::session::Session;
use polarform::source::SourceFile;
use polarform::syntax;
use proptest::prelude::*;

/// What an answer may take in an unoptimised program on a busy machine.
const SOON: Duration = Duration::from_secs(20);

/// Each error of the corpus is printed as its page shows it; `UPDATE_CORPUS=1` writes the pages anew.
#[test]
fn errors_are_printed_as_the_corpus_shows() {
    for page in errors::pages() {
        let name = page.path.display();
        let mut printed = Vec::new();
        for case in &page.cases {
            let failure = Session::default().run(&case.query).expect_err("the query is wrong");
            printed.push(render(&failure.problem, &failure.file, false).trim_end().to_owned());
        }
        let renewed = page.with_errors(&printed);
        if std::env::var_os("UPDATE_CORPUS").is_some() {
            std::fs::write(&page.path, renewed).expect("the corpus is writable");
            continue;
        }
        for (case, printed) in page.cases.iter().zip(&printed) {
            let title = &case.title;
            assert_eq!(case.error, *printed, "{name}, {title}: run with UPDATE_CORPUS=1 to accept");
        }
        assert_eq!(page.text, renewed, "{name}: run with UPDATE_CORPUS=1 to accept");
    }
}

/// Every error of the corpus has a place inside the text and a hint.
#[test]
fn errors_have_a_place_and_a_hint() {
    let mut codes = Vec::new();
    for case in errors::pages().into_iter().flat_map(|page| page.cases) {
        let (name, text) = (&case.title, &case.query);
        let problem = Session::default().run(text).expect_err("the query is wrong").problem;
        assert_eq!(problem.severity, Severity::Error);
        let span = problem.span.unwrap_or_else(|| panic!("{name}: {} has no place", problem.code));
        assert!(span.end <= text.len() && text.is_char_boundary(span.start), "{name}: {span:?}");
        assert!(!problem.hints.is_empty(), "{name}: {} has no hint", problem.code);
        assert!(!problem.message.ends_with('.'), "{name}: {}", problem.message);
        codes.push(problem.code);
    }
    codes.sort();
    codes.dedup();
    // Those a query of one statement cannot lead to.
    let elsewhere = [
        Code::UnsupportedLatex,
        Code::TooLong,
        Code::Recursion,
        Code::AmbiguousVariable,
        Code::Undecided,
        Code::Timeout,
        Code::Interrupted,
        Code::File,
        Code::Usage,
        Code::Internal,
        Code::StandardMeaning,
        Code::MoreCases,
        Code::Letters,
        Code::Called,
        Code::NoIdentity,
        Code::SymbolicBounds,
        Code::NotReal,
        Code::LeftOut,
        Code::TakenAt,
        Code::UnclosedFormula,
        Code::UnclosedBlock,
        Code::HalfDefinition,
        Code::MacroTooLarge,
        Code::Include,
        Code::Encoding,
        Code::BrokenNotebook,
        Code::UnseenFormula,
        Code::FileKind,
        Code::BrokenFormula,
        Code::UnclosedQuery,
        Code::BlockOption,
        Code::OutOfDate,
        Code::Refuted,
        Code::Changed,
    ];
    let missing: Vec<_> =
        Code::ALL.iter().filter(|code| !codes.contains(code) && !elsewhere.contains(code)).collect();
    assert!(missing.is_empty(), "no golden error for {missing:?}");
}

/// Status 2, nothing on standard output, an error with code, place, caret and hint, soon.
fn assert_clear(what: &str, ran: &Run, code: &str) {
    let shown: String = ran.err.chars().take(300).collect();
    assert_eq!(ran.status, Some(2), "{what}: {shown}");
    assert!(ran.out.is_empty(), "{what}: {}", &ran.out[..ran.out.len().min(200)]);
    assert!(ran.err.starts_with(&format!("error[{code}]")), "{what}: {shown}");
    assert!(ran.err.contains("-->"), "{what} has no place: {shown}");
    assert!(ran.err.contains('^'), "{what} has no caret: {shown}");
    assert!(ran.err.contains("= help:"), "{what} has no hint: {shown}");
    assert!(!ran.err.contains("panicked"), "{what}: {shown}");
    assert!(ran.err.len() < 4000, "{what}: a message of {} bytes", ran.err.len());
    assert!(ran.time < SOON, "{what} took {:?}", ran.time);
}

#[test]
fn wrong_queries_of_every_command() {
    for (arguments, code) in [
        (&["polar", ""][..], "E105"),
        (&["polar", "   "], "E105"),
        (&["eval", ""], "E105"),
        (&["check", ""], "E105"),
        (&["polar", "(t + 1"], "E104"),
        (&["polar", "t + 1)"], "E104"),
        (&["polar", "t +"], "E103"),
        (&["polar", "whoknows + t"], "E201"),
        (&["polar", "t^2 + g(t)"], "E203"),
        (&["polar", "1/0"], "E303"),
        (&["eval", "1/(t - t)"], "E303"),
        (&["polar", "1/t"], "E304"),
        (&["polar", "1/(1 + t)"], "E304"),
        (&["product", "t", "1/t"], "E304"),
        (&["sum", "1/t", "t"], "E304"),
        (&["compose", "t^2", "1/t"], "E304"),
        (&["polar", "t^3", "--degree", "2"], "E305"),
        (&["polar", "t^2", "--at", "0"], "E301"),
        (&["polar", "t^2", "--at", "0,1,2"], "E301"),
        (&["eval", "polar(t^2)(0)"], "E301"),
        (&["eval", "polar()"], "E301"),
        (&["polar", "[1, 2; 3, 4]"], "E302"),
        (&["check", "t + 1"], "E502"),
        (&["explain", "E000"], "E502"),
        (&["functions", "polra"], "E202"),
        (&["matrix", "--degree", "2", "--interval", "1,1"], "E311"),
        (&["matrix", "--degree", "2", "--from", "whoknows"], "E201"),
        (&["matrix", "--degree", "3", "--raise-to", "2"], "E307"),
        (&["interpolate", "--nodes", "", "--values", "1"], "E105"),
        (&["interpolate", "--nodes", "0,1", "--values", "1,(2"], "E104"),
        (&["interpolate", "--nodes", "0,0", "--values", "1,2"], "E311"),
        (&["interpolate", "--nodes", "0,1", "--values", "1"], "E307"),
        (&["interpolate", "--nodes", "0,1", "--values", "1", "--method", "hermite"], "E307"),
        (&["interpolate", "--nodes", "0,1", "--values", "1,2", "--variable", "2t"], "E302"),
        (&["interpolate", "--nodes", "0,1", "--values", "1,2", "--ends", "natural"], "E502"),
        (&["interpolate", "--nodes", "0,1", "--values", "1,2", "--method", "least-squares"], "E502"),
        (&["interpolate", "--nodes", "1,0", "--values", "1,2", "--method", "spline"], "E316"),
        (&["interpolate", "--nodes", "0,1", "--values", "1,2", "--method", "spline", "--at", "2"], "E317"),
    ] {
        assert_clear(&format!("{arguments:?}"), &run(arguments), code);
    }
}

#[test]
fn absurd_sizes() {
    for (query, code) in [
        ("(t+1)^1000000000", "E402"),
        ("t^99999999999999999999", "E402"),
        ("polar(t^10000000)", "E402"),
        ("elevate(polar(t), 10^9)", "E402"),
        ("polar(t, degree=10^12)", "E402"),
        ("bernstein_to_power(100000)", "E402"),
        ("identity(100000)", "E402"),
        ("0..10^18", "E402"),
        ("sum(i=1..10^12, i)", "E402"),
        ("vandermonde([0, 1], degree=10^9)", "E402"),
        ("least_squares([0, 1], [1, 2], 10^9)", "E402"),
        ("basis_condition(10^6)", "E402"),
        ("parameters([[0, 0], [1, 0], [1, 2], [2, 3]], foley, decimals=10^9)", "E403"),
        ("2^(10^9)", "E403"),
        ("9^9^9^9", "E403"),
        ("100000000!", "E403"),
        ("20!!", "E102"),
        ("(20!)!", "E403"),
        ("binomial(10^9, 5*10^8)", "E403"),
        ("(1/3)^(10^9)", "E403"),
        ("diff(t^100, t, 10^18)", "E402"),
    ] {
        assert_clear(query, &run(&["eval", query]), code);
    }
    for degree in ["1000000000", "18446744073709551615"] {
        assert_clear(degree, &run(&["polar", "t", "--degree", degree]), "E402");
        assert_clear(degree, &run(&["matrix", "--degree", degree]), "E402");
    }
}

#[test]
fn nesting_and_length() {
    let n = 10_000;
    for (what, text, code) in [
        ("parentheses", "(".repeat(n) + "t" + &")".repeat(n), "E106"),
        ("open parentheses", "(".repeat(n), "E106"),
        ("brackets", "[".repeat(n) + &"]".repeat(n), "E106"),
        ("braces", "t^{".repeat(n) + "1" + &"}".repeat(n), "E106"),
        ("calls", "f(".repeat(n) + "t" + &")".repeat(n), "E106"),
        ("hats", "hat(".repeat(n) + "1" + &")".repeat(n), "E106"),
        ("signs", "-".repeat(n) + "t", "E106"),
        ("powers", "t^".repeat(n) + "t", "E106"),
        ("quotients", "1/".repeat(n) + "t", "E106"),
        ("arrows", "t->".repeat(n) + "1", "E106"),
        ("indices", "t_".repeat(n) + "1", "E102"),
        ("factorials", "t".to_owned() + &"!".repeat(n), "E102"),
        ("commas", ",".repeat(n), "E102"),
        ("digits", "7".repeat(3_000_000), "E110"),
        ("decimals", "0.".to_owned() + &"7".repeat(3_000_000), "E110"),
        ("an index of many digits", "t".to_owned() + &"7".repeat(3_000_000), "E110"),
        ("a NUL", "t\0t".to_owned(), "E101"),
    ] {
        assert_clear(what, &run_with(&["run", "-"], text.as_bytes()), code);
    }
    // A very long name is an unknown name; the message does not repeat all of it.
    assert_clear("a long name", &run_with(&["run", "-"], "ab".repeat(500_000).as_bytes()), "E201");
}

#[test]
fn long_but_reasonable_input_is_read() {
    let sum = vec!["t"; 20_000].join(" + ");
    assert_eq!(run_with(&["run", "-"], sum.as_bytes()).out, "20000 t\n");
    let number = "7".repeat(20_000);
    assert_eq!(run_with(&["run", "-"], number.as_bytes()).out.trim_end(), number);
}

/// Peak memory of a run in kilobytes, where the system tells.
#[cfg(target_os = "linux")]
fn peak_memory(query: &str) -> Option<u64> {
    let mut child = crate::common::command(&["eval", query, "--timeout", "2"])
        .stdin(std::process::Stdio::null())
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::null())
        .spawn()
        .ok()?;
    let status = format!("/proc/{}/status", child.id());
    let mut peak = 0;
    let begin = Instant::now();
    while child.try_wait().ok()?.is_none() {
        assert!(begin.elapsed() < Duration::from_secs(20), "{query} does not stop");
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let line = text.lines().find(|line| line.starts_with("VmHWM:"));
        let value = line.and_then(|line| line.split_whitespace().nth(1)?.parse().ok());
        peak = peak.max(value.unwrap_or(0));
        assert!(peak < 1_500_000, "{query} takes {peak} kB");
        std::thread::sleep(Duration::from_millis(10));
    }
    Some(peak)
}

#[cfg(target_os = "linux")]
#[test]
fn memory_is_bounded() {
    for query in [
        "(t+1)^1000000000",
        "identity(1000000)",
        "0..10^15",
        "sum(i=1..10^9, t_i)",
        "prod(i=1..60, t_i + 1)",
        "polar(t^25, degree=50)",
    ] {
        assert!(peak_memory(query).is_some(), "{query}");
    }
    // An index needs no list of its values.
    let long = peak_memory("sum(i=1..3000000, i^5)").unwrap_or(0);
    assert!(long < 200_000, "a long sum takes {long} kB");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    /// Any text is answered, and the place of a problem lies in it.
    #[test]
    fn any_text_is_answered(text in "\\PC{0,40}") {
        check_any(&text)?;
    }

    /// So is any sequence of words of the language.
    #[test]
    fn any_sequence_of_words_is_answered(words in prop::collection::vec(word(), 0..14)) {
        check_any(&words.join(" "))?;
        check_any(&words.concat())?;
    }
}

fn word() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec![
        "t",
        "t1",
        "F",
        "f",
        "(",
        ")",
        "[",
        "]",
        "{",
        "}",
        ",",
        ";",
        "+",
        "-",
        "*",
        "/",
        "^",
        "=",
        ":=",
        "!",
        "'",
        "_",
        "..",
        "...",
        "->",
        "0",
        "1",
        "2",
        "7/3",
        "0.5",
        "polar",
        "polar(",
        "hat(",
        "sigma",
        "diff(",
        "sum(",
        "i=",
        "1..3",
        "∘",
        "²",
        "t₁",
        "binomial(",
        "degree=",
        "<",
        "<=",
        "in",
        "\"",
        "#",
        "|",
        "ans",
        "bernstein",
        "[1, 2; 3, 4]",
        "^-1",
        "\n",
    ])
}

fn check_any(text: &str) -> Result<(), TestCaseError> {
    let file = SourceFile::new("<text>", text);
    let mut session = Session::default();
    session.limits.time = Some(Duration::from_millis(300));
    session.limits.terms = 10_000;
    session.limits.bits = 100_000;
    let mut worst = Ok(());
    session.run_file(&file, |_, result| {
        if let Err(failure) = result {
            let problem = &failure.problem;
            let inside = problem.span.is_none_or(|span| {
                span.end <= text.len() && text.is_char_boundary(span.start) && text.is_char_boundary(span.end)
            });
            if problem.code == Code::Internal || !inside {
                worst = Err(TestCaseError::fail(format!("{text:?}: {problem:?}")));
            }
            render(problem, &failure.file, true);
        }
        true
    });
    let _ = syntax::is_incomplete(text);
    worst
}
