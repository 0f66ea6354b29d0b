//! A corpus of lecture notes: pages in the notations of the subject's textbooks, each relation with
//! the verdict it must get.
//!
//! A comment `expect: true false open definition` speaks for the relations since the comment before.
//! `false` must be refuted or carry a warning; nothing else may be refuted; `true` and `definition`
//! must be judged. What is not reached yet is listed in `tests/corpus/notes/known.txt`, line by line,
//! so that every change, for better or worse, is seen. `UPDATE_CORPUS=1` writes the list anew; no
//! false alarm may be in it.

#![allow(clippy::print_stdout, reason = "a summary for whoever works on the checker")]

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use polarform::document::{Reading, read_files};
use polarform::judge::finding::{Finding, Verdict};
use polarform::notes::{Options, check_document};

struct Expectation {
    place: usize,
    words: Vec<String>,
    repairs: Vec<String>,
}

fn expectations(text: &str) -> Vec<Expectation> {
    let mut found = Vec::new();
    let mut from = 0;
    while let Some(at) = text[from..].find("expect:") {
        let start = from + at + "expect:".len();
        let rest = &text[start..];
        let end = rest.find("-->").unwrap_or(usize::MAX).min(rest.find('\n').unwrap_or(rest.len()));
        let body = rest[..end].trim_end_matches("\\n\",").trim();
        let mut parts = body.split(" | ");
        let words = parts.next().unwrap_or("").split_whitespace().map(str::to_owned).collect();
        let repairs = parts.map(|part| part.trim().to_owned()).collect();
        found.push(Expectation { place: from + at, words, repairs });
        from = start;
    }
    found
}

fn pages() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/notes");
    let mut pages: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "md" || e == "tex" || e == "ipynb"))
        .collect();
    pages.sort();
    pages
}

fn kept(finding: &Finding, word: &str) -> bool {
    match word {
        "false" => finding.is_suspicious(),
        "open" => finding.verdict != Verdict::Refuted,
        "true" | "definition" => {
            matches!(finding.verdict, Verdict::Definition | Verdict::Proved | Verdict::Sampled)
        }
        other => panic!("no verdict is called {other}"),
    }
}

#[derive(Default)]
struct Tally {
    words: usize,
    kept: usize,
    wrong: usize,
    found: usize,
    repaired: usize,
    with_repair: usize,
}

#[test]
fn every_relation_gets_its_verdict() {
    let mut missed = String::new();
    let mut alarms = String::new();
    let mut tally = Tally::default();
    for page in pages() {
        let name = page.file_name().unwrap().to_string_lossy().into_owned();
        let documents = read_files(&page, &Reading::default()).unwrap();
        let document = &documents[0];
        let report = check_document(document, &Options::default());
        let mut relations: Vec<&Finding> = report.findings.iter().filter(|f| f.relation > 0).collect();
        relations.sort_by_key(|finding| finding.mark.start);
        let mut rest = relations.into_iter().peekable();
        for expectation in expectations(document.file.text()) {
            let mut group = Vec::new();
            while let Some(finding) = rest.next_if(|finding| finding.mark.start < expectation.place) {
                group.push(finding);
            }
            let line = document.file.line_column(expectation.place).0;
            if group.len() != expectation.words.len() {
                let _ = writeln!(
                    missed,
                    "{name}:{line}: {} relations read, {} expected",
                    group.len(),
                    expectation.words.len()
                );
                tally.words += expectation.words.len();
                continue;
            }
            let mut repairs = expectation.repairs.iter();
            for (finding, word) in group.into_iter().zip(&expectation.words) {
                tally.words += 1;
                let (line, column) = document.file.line_column(finding.mark.start);
                let latex: String = finding.latex.split_whitespace().collect::<Vec<_>>().join(" ");
                let short: String = latex.chars().take(90).collect();
                if word == "false" {
                    tally.wrong += 1;
                    tally.found += usize::from(finding.is_suspicious());
                    if let Some(repair) = repairs.next() {
                        let plain = |text: &str| -> String {
                            text.chars()
                                .filter(|c| !c.is_whitespace())
                                .collect::<String>()
                                .replace("\\left", "")
                                .replace("\\right", "")
                                .replace("\\,", "")
                                .replace("\\cdot", "")
                        };
                        tally.with_repair += 1;
                        let suggestion = finding.suggestion.as_deref().unwrap_or("");
                        tally.repaired += usize::from(plain(suggestion).contains(&plain(repair)));
                        if std::env::var_os("SHOW_REPAIRS").is_some() {
                            println!("{name}:{line} wanted {repair} got {suggestion}");
                        }
                    }
                }
                if kept(finding, word) {
                    tally.kept += 1;
                    continue;
                }
                let verdict = finding.verdict.word();
                let _ = writeln!(missed, "{name}:{line}:{column}: {word}, not {verdict}: {short}");
                if std::env::var_os("SHOW_REASONS").is_some() {
                    println!(
                        "{name}:{line}:{column}: {word}, not {verdict}: {short}\n     {} | {}",
                        finding.reason.as_deref().unwrap_or(""),
                        finding.witness.as_deref().unwrap_or("")
                    );
                }
                if finding.verdict == Verdict::Refuted {
                    let reason = finding.reason.as_deref().unwrap_or("");
                    let _ = writeln!(alarms, "{name}:{line}:{column}: {word}: {short}\n    {reason}");
                }
            }
        }
    }
    println!(
        "{} of {} words kept; {} of {} wrong relations found; {} of {} repairs",
        tally.kept, tally.words, tally.found, tally.wrong, tally.repaired, tally.with_repair
    );
    assert!(alarms.is_empty() || std::env::var_os("SHOW_REASONS").is_some(), "false alarms:\n{alarms}");
    let known = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/notes/known.txt");
    if std::env::var_os("UPDATE_CORPUS").is_some() {
        fs::write(&known, &missed).unwrap();
        return;
    }
    let expected = fs::read_to_string(&known).unwrap_or_default();
    assert_eq!(missed, expected, "run with UPDATE_CORPUS=1 to accept");
}
