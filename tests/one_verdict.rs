//! A claim has one verdict however it is asked: at the prompt, by `check`, on a page in a display or in a line.
//!
//! Each line of the corpus is a verdict and a claim in LaTeX.

use std::fmt::Write as _;

use polarform::document::{Container, document};
use polarform::eval::Equals;
use polarform::notes::{Options, check_document};
use polarform::session::Session;
use polarform::source::SourceFile;
use polarform::value::Value;

fn asked(claim: &str, equals: Equals) -> String {
    let file = SourceFile::new("<claim>", claim);
    match Session::default().run_statement(&file, None, equals) {
        Ok(answer) => match answer.outcome.value {
            Value::Claim(claim) => claim.verdict().word().to_owned(),
            other => format!("no claim, but {}", other.kind()),
        },
        Err(failure) => format!("an error: {}", failure.problem.code.id()),
    }
}

fn on_page(page: &str) -> String {
    let document = document(SourceFile::new("page.md", page), Container::Markdown);
    let report = check_document(&document, &Options::default());
    let verdicts: Vec<&str> = report.findings.iter().map(|finding| finding.verdict.word()).collect();
    verdicts.join(", ")
}

#[test]
fn a_claim_has_one_verdict_in_all_ways() {
    let corpus = include_str!("corpus/claims/all_ways.txt");
    let claims = corpus.lines().filter(|line| !line.starts_with('%') && !line.is_empty());
    let (mut wrong, mut count) = (String::new(), 0);
    for line in claims {
        let (verdict, claim) = line.split_once(": ").unwrap();
        count += 1;
        let ways = [
            ("prompt", asked(&format!("${claim}$"), Equals::DefinesUnbound)),
            ("check", asked(&format!("${claim}$"), Equals::Claims)),
            ("display", on_page(&format!("Then\n\n$$\n{claim}\n$$\n"))),
            ("line", on_page(&format!("We have ${claim}$.\n"))),
        ];
        for (way, got) in ways.into_iter().filter(|(_, got)| got != verdict) {
            let _ = writeln!(wrong, "{claim}: {verdict}, but {got} ({way})");
        }
    }
    assert!(count >= 100, "only {count} claims");
    assert!(wrong.is_empty(), "{wrong}");
}
