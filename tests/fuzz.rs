//! Random inputs for everything that reads: the language and its writers, notes in each format with their reports,
//! weaving in each format. Nothing may panic, hang or answer with an internal error, and weaving twice changes
//! nothing.
//!
//! Inputs are made from the corpora by cutting, splicing, repeating and inserting tokens. The generator is
//! deterministic. `cargo test` replays a short run; a long one is
//! `POLARFORM_FUZZ_SECONDS=3600 cargo test --release --test main fuzz -- --nocapture`. `fuzz/run` is guided by
//! coverage. An input that ever failed is kept: a query in `tests/corpus/fuzz/seeds.txt`, a page in
//! `tests/corpus/fuzz/pages`.

#![allow(clippy::print_stdout, reason = "progress of long runs")]

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::common::attack::{Family, given};
use crate::common::errors;
use crate::common::mutation::{Random, mutated, tokens};

fn seeds_of_formulas() -> Vec<String> {
    let cases = errors::pages().into_iter().flat_map(|page| page.cases);
    let mut seeds: Vec<String> =
        cases.map(|case| case.query).filter(|query| !query.starts_with('#')).collect();
    for file in files(&["tests/corpus"], &["txt"]) {
        let content = String::from_utf8_lossy(&fs::read(file).unwrap()).into_owned();
        for line in content.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
            seeds.push(line.split("==>").next().unwrap_or(line).trim().to_owned());
        }
    }
    assert!(!seeds.is_empty(), "no seeds");
    seeds
}

/// The files with some endings in some folders, in their order.
fn files(folders: &[&str], endings: &[&str]) -> Vec<PathBuf> {
    fn collect(folder: &Path, endings: &[&str], files: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                collect(&path, endings, files);
            } else if path.extension().is_some_and(|ending| endings.iter().any(|known| *known == ending)) {
                files.push(path);
            }
        }
    }
    let mut found = Vec::new();
    for folder in folders {
        collect(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder), endings, &mut found);
    }
    found.sort();
    found
}

/// Pieces of some lines of the pages in the corpora; a notebook stays whole.
fn seeds_of_pages() -> Vec<String> {
    const LINES: usize = 12;
    let mut seeds = Vec::new();
    let folders = ["tests/corpus/notes", "docs/notes", "examples"];
    for file in files(&folders, &["md", "tex", "ipynb"]) {
        let text = fs::read_to_string(&file).unwrap();
        if file.extension().is_some_and(|ending| ending == "ipynb") {
            seeds.push(text);
            continue;
        }
        let lines: Vec<&str> = text.split_inclusive('\n').collect();
        seeds.extend(lines.chunks(LINES).map(|lines| lines.concat()));
    }
    seeds
}

/// Every seed, then random inputs: `count` of them, or for as long as the environment says. The bytes of a
/// mutated text are handed on with `families` in turn.
fn replay(families: &[Family], whole: &[String], seeds: &[String], tokens: &[String], count: u64) {
    let seconds = std::env::var("POLARFORM_FUZZ_SECONDS").ok().and_then(|s| s.parse::<u64>().ok());
    // Another run of the long kind explores other inputs.
    let seed = std::env::var("POLARFORM_FUZZ_SEED").ok().and_then(|s| s.parse().ok()).unwrap_or(1);
    let (given, start, mut random) = (given(), Instant::now(), Random(seed));
    let mut failures = Vec::new();
    let mut attack = |family: Family, input: &str| {
        let result = std::panic::catch_unwind(|| family.attack(input.as_bytes(), &given))
            .unwrap_or_else(|_| Err("panicked".to_owned()));
        if let Err(problem) = result {
            println!("FAILED, {family:?} on {input:?}: {problem}");
            failures.push((family, input.to_owned(), problem));
        }
    };
    for input in whole {
        families.iter().for_each(|family| attack(*family, input));
    }
    let mut done = 0;
    while seconds.map_or(done < count, |seconds| start.elapsed() < Duration::from_secs(seconds)) {
        let input = mutated(&mut random, seeds, tokens, 4000);
        attack(families[random.below(families.len())], &input);
        done += 1;
        if seconds.is_some() && done % 100_000 == 0 {
            println!("{done} inputs in {:?}", start.elapsed());
        }
    }
    println!("{done} inputs in {:?}", start.elapsed());
    assert!(failures.is_empty(), "{} inputs failed, the first: {:?}", failures.len(), failures[0]);
}

/// Pages that failed once.
fn kept_pages() -> Vec<String> {
    let kept = files(&["tests/corpus/fuzz/pages"], &["page"]);
    kept.iter().map(|file| String::from_utf8_lossy(&fs::read(file).unwrap()).into_owned()).collect()
}

#[test]
fn nothing_breaks() {
    let seeds = seeds_of_formulas();
    replay(&[Family::Language], &seeds, &seeds, &tokens(&["formulas.tokens"]), 600);
}

#[test]
fn nothing_breaks_in_notes() {
    let tokens = tokens(&["formulas.tokens", "pages.tokens"]);
    replay(&Family::NOTES, &kept_pages(), &seeds_of_pages(), &tokens, 120);
}

#[test]
fn nothing_breaks_in_weaving() {
    let tokens = tokens(&["formulas.tokens", "pages.tokens"]);
    replay(&Family::WEAVE, &kept_pages(), &seeds_of_pages(), &tokens, 120);
}
