//! Queries whose answers other systems gave as well: cases that `tests/differential.py` kept.

use std::path::Path;

use crate::common::run_with;

#[test]
fn answers_are_those_of_other_systems() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/differential.txt");
    let text = std::fs::read_to_string(path).expect("the cases are there");
    let cases: Vec<(&str, &str)> = text
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| line.split_once(" ==> ").expect("a query and its answer"))
        .collect();
    assert!(cases.len() > 200, "{} cases", cases.len());
    let script: String = cases.iter().map(|(query, _)| format!("{query}\n")).collect();
    let ran = run_with(&["--format", "sympy", "run", "-"], script.as_bytes());
    let answers: Vec<&str> = ran.out.lines().collect();
    assert_eq!(answers.len(), cases.len(), "{}", ran.err);
    for ((query, expected), answer) in cases.iter().zip(answers) {
        assert_eq!(answer, *expected, "{query}");
    }
}
