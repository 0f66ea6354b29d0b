//! Small pages, each with one claim: the last relations of the page, with the verdict that they must get.
//!
//! A line `=== true`, `=== false` or `=== open` begins a page. What is wrong must be refuted; nothing else on any page may
//! be; what is open, since the page does not say enough, must not be confirmed either.
//! Pages are added for what a lecturer writes: the same thing in several words and languages, true and false.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use polarform::document::{Container, document};
use polarform::formula::source::SourceFile;
use polarform::judge::finding::{Finding, Verdict};
use polarform::notes::report::{fixed, fixes};
use polarform::notes::{Options, check_document};

/// The pages of a file: the line where each begins, whether its claim is true, if that can be said, and its text.
fn pages(text: &str) -> Vec<(usize, Option<bool>, String)> {
    let mut found: Vec<(usize, Option<bool>, String)> = Vec::new();
    for (line, words) in text.lines().enumerate() {
        match (words.strip_prefix("=== "), found.last_mut()) {
            (Some(truth), _) => {
                let truth = match truth.trim() {
                    "true" => Some(true),
                    "false" => Some(false),
                    other => {
                        assert_eq!(other, "open", "line {}", line + 1);
                        None
                    }
                };
                found.push((line + 1, truth, String::new()));
            }
            (None, Some((_, _, page))) => {
                page.push_str(words);
                page.push('\n');
            }
            (None, None) => {}
        }
    }
    found
}

/// The findings on the last formula of a page that states something: those after the last formula but one.
fn last<'a>(findings: &'a [Finding], page: &str) -> Vec<&'a Finding> {
    let display = page.rfind("$$").map(|end| page[..end].rfind("$$").unwrap_or(end));
    let start = display.or_else(|| findings.iter().filter(|f| f.relation > 0).map(|f| f.span.start).max());
    let inside = |finding: &&Finding| start.is_some_and(|start| finding.span.end > start);
    findings.iter().filter(|finding| finding.relation > 0).filter(inside).collect()
}

#[test]
fn every_page_gets_its_verdict() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/pages");
    let mut wrong = String::new();
    let mut count = 0;
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    for file in files {
        let name = file.file_name().unwrap().to_string_lossy().into_owned();
        for (line, truth, page) in pages(&fs::read_to_string(&file).unwrap()) {
            count += 1;
            let document = document(SourceFile::new("page.md", page.as_str()), Container::Markdown);
            let report = check_document(&document, &Options::default());
            let claim = last(&report.findings, &page);
            let confirmed = |f: &&Finding| matches!(f.verdict, Verdict::Proved | Verdict::Sampled);
            let right = match truth {
                Some(true) => claim.iter().any(confirmed),
                Some(false) => claim.iter().any(|finding| finding.is_suspicious()),
                None => !claim.iter().any(confirmed),
            };
            if !right {
                let verdicts: Vec<&str> = claim.iter().map(|finding| finding.verdict.word()).collect();
                let _ = writeln!(wrong, "{name}:{line}: {truth:?}, but it is {verdicts:?}");
            }
            let alarms = report.findings.iter().filter(|finding| {
                finding.verdict == Verdict::Refuted
                    && (truth != Some(false) || !claim.iter().any(|own| own.span == finding.span))
            });
            for alarm in alarms {
                let _ = writeln!(wrong, "{name}:{line}: a false alarm: {}", alarm.latex);
            }
        }
    }
    assert!(count > 50, "only {count} pages");
    assert!(wrong.is_empty(), "{wrong}");
}

/// Suggestions are put into a page so many times.
const ROUNDS: usize = 4;

/// A page that a suggestion changed has nothing refuted any more: a suggestion is right where it is put.
#[test]
fn suggestions_settle() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/pages");
    let mut wrong = String::new();
    let (mut count, mut repaired) = (0, 0);
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    for file in files {
        let name = file.file_name().unwrap().to_string_lossy().into_owned();
        for (line, _, page) in pages(&fs::read_to_string(&file).unwrap())
            .into_iter()
            .filter(|(_, truth, _)| *truth == Some(false))
        {
            count += 1;
            let mut text = page;
            for round in 0..=ROUNDS {
                let document = document(SourceFile::new("page.md", text.as_str()), Container::Markdown);
                let report = check_document(&document, &Options::default());
                let fixes = fixes(&document, &report);
                let refuted: Vec<&Finding> =
                    report.findings.iter().filter(|finding| finding.verdict == Verdict::Refuted).collect();
                if round > 0 && !refuted.is_empty() && fixes.is_empty() || round == ROUNDS {
                    let left: Vec<&str> = refuted.iter().map(|finding| finding.latex.as_str()).collect();
                    if !left.is_empty() {
                        let _ = writeln!(wrong, "{name}:{line}: refuted after {round} rounds: {left:?}");
                    }
                }
                if fixes.is_empty() {
                    repaired += usize::from(round > 0);
                    break;
                }
                text = fixed(&text, &fixes);
            }
        }
    }
    assert!(2 * repaired > count, "only {repaired} of {count} wrong pages were repaired");
    assert!(wrong.is_empty(), "{wrong}");
}
