//! Random inputs for the lexers, both readers, the evaluator and the writers: nothing may
//! panic, hang or answer with an internal error.
//!
//! Inputs are made from the seeds in `tests/corpus/fuzz` by cutting, splicing, repeating and
//! inserting tokens. The generator is deterministic. `cargo test` replays a short run; a long one is
//! `POLARFORM_FUZZ_SECONDS=3600 cargo test --release --test main fuzz -- --nocapture`. An input
//! that ever failed is kept as a seed.

#![allow(clippy::print_stdout, reason = "progress of long runs")]

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use crate::common::errors;
use polarform::budget::Limits;
use polarform::diagnostic::{Code, render};
use polarform::session::Session;
use polarform::write::{latex, sympy, text, unicode};
use polarform::{latex as latex_reader, syntax};

/// One statement may take this long, limits and printing included (debug builds are slow).
const LONGEST: Duration = Duration::from_secs(20);

const TOKENS: &[&str] = &[
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ";",
    ":",
    "=",
    ":=",
    "<=",
    "+",
    "-",
    "*",
    "/",
    "^",
    "_",
    "!",
    "'",
    "..",
    "...",
    "->",
    "t",
    "t1",
    "t_{1,2}",
    "f",
    "F",
    "c_0",
    "B_i^n",
    "sigma",
    "σ",
    "₁",
    "²",
    "0",
    "1",
    "2",
    "1/2",
    "0.25",
    "99999999999999999999",
    "hat(1)",
    "polar(",
    "elevate(",
    "sum(i=0..3, ",
    "prod(",
    "diff(",
    "cases(",
    " if ",
    "binomial(",
    "symmetrize(",
    "[t1, t2]",
    "degree=",
    "\\frac{1}{2}",
    "\\left(",
    "\\right)",
    "\\hat{1}",
    "\\sum_{i=0}^{n}",
    "\\binom{n}{i}",
    "\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix}",
    "&",
    "\\\\",
    "\\underbrace{t,\\ldots,t}_{2}",
    "\\int_0^1",
    "dt",
    "\\frac{d}{dt}",
    "$",
    "$$",
    "|",
    "\\circ",
    "∘",
    "^T",
    "^{-1}",
    "^{(2)}",
    "\\text{if}",
    "=",
    "\n",
    "#",
    "\u{301}",
    "\0",
    "，",
    "\\",
];

/// Knuth's 64-bit linear congruential generator.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % bound.max(1)
    }

    fn pick<T: Clone>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())].clone()
    }
}

fn seeds() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus");
    let mut files = Vec::new();
    collect(&folder, &mut files);
    files.sort();
    let cases = errors::pages().into_iter().flat_map(|page| page.cases);
    let mut seeds: Vec<String> =
        cases.map(|case| case.query).filter(|query| !query.starts_with('#')).collect();
    for file in files {
        let bytes = fs::read(file).unwrap();
        let content = String::from_utf8_lossy(&bytes).into_owned();
        for line in content.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
            seeds.push(line.split("==>").next().unwrap_or(line).trim().to_owned());
        }
    }
    assert!(!seeds.is_empty(), "no seeds");
    seeds
}

fn collect(folder: &Path, files: &mut Vec<std::path::PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|e| e == "txt") {
            files.push(path);
        }
    }
}

/// A place on a character boundary.
fn place(random: &mut Random, input: &str) -> usize {
    let mut at = random.below(input.len() + 1);
    while !input.is_char_boundary(at) {
        at -= 1;
    }
    at
}

fn mutate(random: &mut Random, seeds: &[String]) -> String {
    let mut input = random.pick(seeds);
    for _ in 0..=random.below(5) {
        let (a, b) = (place(random, &input), place(random, &input));
        let (from, to) = (a.min(b), a.max(b));
        match random.below(7) {
            0 => input.replace_range(from..to, ""),
            1 => {
                let token: &str = random.pick(TOKENS);
                input.insert_str(a, token);
            }
            2 => {
                let other = random.pick(seeds);
                let cut = place(random, &other);
                input.insert_str(a, &other[cut..]);
            }
            3 => {
                let piece = input[from..to].to_owned();
                input.insert_str(b, &piece);
            }
            4 => {
                let token: &str = random.pick(TOKENS);
                input.replace_range(from..to, token);
            }
            5 => {
                let token: &str = random.pick(TOKENS);
                let token = token.repeat(1 + random.below(40));
                input.insert_str(a, &token);
            }
            _ => {
                let odd = char::from_u32(random.below(0x2fff) as u32).unwrap_or('?');
                input.insert(a, odd);
            }
        }
        if input.len() > 4000 {
            let cut = place(random, &input[..2000]);
            input.truncate(cut);
        }
    }
    input
}

/// Runs everything on one input; the answer says what is wrong, if anything.
fn attack(input: &str, given: &Session) -> Result<(), String> {
    let start = Instant::now();
    let _ = syntax::parse_program(input);
    let (tree, _) = latex_reader::read_tolerant(input);
    let _ = (text(&tree), unicode(&tree), latex(&tree), sympy(&tree).is_ok());
    let _ = latex_reader::read_rows(input);
    let mut session = given.clone();
    let file = polarform::source::SourceFile::new("<fuzz>", input);
    let mut problem = None;
    session.run_file(&file, |session, result| {
        match result {
            Ok(answer) => {
                let limits = session.limits.clone();
                let value = answer.outcome.value;
                // A value too large to print is stopped, which is fine.
                let _ = polarform::budget::run(&limits, || {
                    let expr = value.to_expr();
                    (text(&expr), unicode(&expr), latex(&expr), sympy(&expr).is_ok())
                });
            }
            Err(failure) => {
                let shown = render(&failure.problem, &failure.file, false);
                if failure.problem.code == Code::Internal {
                    problem = Some(shown);
                }
            }
        }
        start.elapsed() < LONGEST
    });
    if let Some(problem) = problem {
        return Err(problem);
    }
    match start.elapsed() {
        time if time >= LONGEST => Err(format!("took {time:?}")),
        _ => Ok(()),
    }
}

#[test]
fn nothing_breaks() {
    let seconds = std::env::var("POLARFORM_FUZZ_SECONDS").ok().and_then(|s| s.parse::<u64>().ok());
    let limits =
        Limits { time: Some(Duration::from_millis(200)), terms: 20_000, bits: 1 << 16, ..Limits::default() };
    let mut given = Session::new(limits);
    for definition in
        ["f := polar(t^3 + 3t^2 + 5t + 1)", "F(t) := t^2 + 2t", "g := polar(t^2)", "n := 3", "i := 1"]
    {
        given.run(definition).unwrap();
    }
    let seeds = seeds();
    let start = Instant::now();
    // Another run of the long kind explores other inputs.
    let seed = std::env::var("POLARFORM_FUZZ_SEED").ok().and_then(|s| s.parse().ok()).unwrap_or(1);
    let mut random = Random(seed);
    let mut count = 0u64;
    let mut failures = Vec::new();
    for seed in &seeds {
        if let Err(problem) = attack(seed, &given) {
            failures.push((seed.clone(), problem));
        }
    }
    let more = |count: u64| match seconds {
        Some(seconds) => start.elapsed() < Duration::from_secs(seconds),
        None => count < 1500,
    };
    while more(count) {
        let input = mutate(&mut random, &seeds);
        count += 1;
        let result = std::panic::catch_unwind(|| attack(&input, &given))
            .unwrap_or_else(|_| Err("panicked outside the session".to_owned()));
        if let Err(problem) = result {
            println!("FAILED on {input:?}: {problem}");
            failures.push((input, problem));
        }
        if seconds.is_some() && count.is_multiple_of(100_000) {
            println!("{count} inputs in {:?}, {} failures", start.elapsed(), failures.len());
        }
    }
    println!("{count} inputs in {:?}", start.elapsed());
    assert!(failures.is_empty(), "{} inputs failed, the first: {:?}", failures.len(), failures[0]);
}
