//! The tiers of docs/architecture.md, read off the `use` lines: a file imports only from
//! lower tiers or from its own module.

use std::fs;
use std::path::{Path, PathBuf};

/// Top-level modules by tier, lowest first. Siblings of a tier do not import each other.
const TIERS: &[&[&str]] = &[
    &["budget", "number", "source"],
    &["ring", "expr", "diagnostic"],
    &["linalg", "poly"],
    &["basis", "blossom", "piecewise", "syntax", "latex"],
    &["curve", "interpolate"],
    &["spline", "scene"],
    &["value"],
    &["derive"],
    &["write"],
    &["figure"],
    &["eval"],
    &["session"],
    &["notes"],
    &["weave"],
    &["cli"],
];

/// The mathematics knows nothing of syntax, spans or terminals.
const MATHEMATICS: &[&str] =
    &["number", "ring", "linalg", "poly", "basis", "blossom", "piecewise", "curve", "interpolate", "spline"];
const LANGUAGE: &[&str] = &["source", "expr", "diagnostic", "syntax", "latex"];

const LONGEST_FILE: usize = 650;

fn tier(module: &str) -> Option<usize> {
    TIERS.iter().position(|tier| tier.contains(&module))
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// The top-level modules named in `crate::…` paths outside comments and test modules.
fn imports(text: &str) -> Vec<String> {
    let code = text.split("#[cfg(test)]").next().unwrap_or(text);
    let mut found = Vec::new();
    for line in code.lines().filter(|line| !line.trim_start().starts_with("//")) {
        for piece in line.split("crate::").skip(1) {
            let name: String = piece.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            if !name.is_empty() {
                found.push(name);
            }
        }
    }
    found
}

fn modules() -> Vec<(String, PathBuf, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&root, &mut files);
    files
        .into_iter()
        .filter_map(|path| {
            let relative = path.strip_prefix(&root).unwrap();
            let module = relative.iter().next()?.to_str()?.trim_end_matches(".rs").to_owned();
            let text = fs::read_to_string(&path).unwrap();
            (module != "lib" && module != "main").then_some((module, path, text))
        })
        .collect()
}

#[test]
fn imports_go_down() {
    for (module, path, text) in modules() {
        let own = tier(&module).unwrap_or_else(|| panic!("{module} has no tier"));
        for import in imports(&text).into_iter().filter(|import| *import != module) {
            let Some(other) = tier(&import) else {
                panic!("{}: unknown module crate::{import}", path.display())
            };
            assert!(other < own, "{}: {module} may not import {import}", path.display());
        }
    }
}

#[test]
fn mathematics_knows_no_language() {
    for (module, path, text) in modules() {
        if MATHEMATICS.contains(&module.as_str()) {
            for import in imports(&text) {
                assert!(!LANGUAGE.contains(&import.as_str()), "{} imports {import}", path.display());
            }
        }
    }
}

#[test]
fn files_stay_readable() {
    for (_, path, text) in modules() {
        let lines = text.lines().count();
        assert!(lines <= LONGEST_FILE, "{} has {lines} lines", path.display());
    }
}

#[test]
fn the_parser_of_imports_sees_them() {
    let text = "use crate::number::Int;\n// use crate::cli;\nlet x = crate::poly::Poly::zero();\n";
    assert_eq!(imports(text), ["number", "poly"]);
}
