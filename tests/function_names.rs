//! Functions and arguments that the program itself calls by their names are those of the table: a name
//! that is no longer there would find nothing, and nobody would be told.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use polarform::functions::BUILTINS;

use crate::architecture::sources;

fn library() -> BTreeMap<String, String> {
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"))
}

fn functions() -> BTreeSet<&'static str> {
    BUILTINS
        .iter()
        .flat_map(|function| std::iter::once(*function).chain(function.subjects))
        .map(|f| f.name)
        .collect()
}

fn parameters() -> BTreeSet<&'static str> {
    let all = BUILTINS.iter().flat_map(|function| std::iter::once(*function).chain(function.subjects));
    let lists = all.flat_map(|function| {
        let variants: Vec<_> = function.other_forms().flat_map(|(_, variant)| variant.parameters).collect();
        function.parameters.iter().chain(function.common).chain(variants)
    });
    lists.map(|parameter| parameter.name).collect()
}

/// The words in quotation marks behind one of these beginnings, with the file.
fn quoted(text: &str, beginnings: &[&str]) -> Vec<String> {
    let behind = |beginning: &&str| -> Vec<String> {
        let beginning = format!("{beginning}\"");
        let parts = text.split(&beginning).skip(1);
        parts.filter_map(|rest| rest.split('"').next()).map(str::to_owned).collect()
    };
    beginnings.iter().flat_map(behind).collect()
}

/// The words in quotation marks with which what stands before `.name` is compared, in `==`, `!=` and `matches!`.
fn compared(text: &str, whose: &str) -> Vec<String> {
    let mut found = quoted(text, &[&format!("{whose}.name == "), &format!("{whose}.name != ")]);
    for rest in text.split(&format!("{whose}.name, \"")).skip(1) {
        // matches!(builtin.name, "a" | "b")
        let words = rest.split(')').next().unwrap_or_default();
        if let Some(list) = words.strip_suffix('"') {
            found.extend(list.split("\" | \"").map(str::to_owned));
        }
    }
    found
}

fn unknown(known: &BTreeSet<&str>, words: impl Fn(&str, &str) -> Vec<String>) -> (usize, Vec<String>) {
    let (mut count, mut wrong) = (0, Vec::new());
    for (file, text) in library() {
        for word in words(&file, &text) {
            count += 1;
            if !known.contains(word.as_str()) {
                wrong.push(format!("{file}: {word}"));
            }
        }
    }
    (count, wrong)
}

#[test]
fn functions_are_called_by_names_of_the_table() {
    let (count, wrong) = unknown(&functions(), |file, text| {
        let mut words = compared(text, "builtin");
        words.extend(quoted(text, &["builtin(", "callable(", "function_called("]));
        if file.starts_with("session/") || file.starts_with("cli/") {
            words.extend(quoted(text, &[" called(", "(called(", "::called("]));
        }
        words
    });
    assert!(wrong.is_empty(), "no functions: {}", wrong.join(", "));
    assert!(count > 80, "{count}");
}

#[test]
fn arguments_are_asked_for_by_names_of_the_table() {
    let asked = [
        ".named(",
        ".flag(",
        ".flag_or(",
        ".size_named(",
        ".named_size(",
        ".named_scalars(",
        ".named_interval(",
    ];
    let (count, wrong) = unknown(&parameters(), |file, text| {
        if file.starts_with("language/functions/") { quoted(text, &asked) } else { Vec::new() }
    });
    assert!(wrong.is_empty(), "no arguments: {}", wrong.join(", "));
    assert!(count > 60, "{count}");
}

/// What is called in hints and is no function of the table: notations, and functions of the caller's.
const NOTATIONS: &[&str] =
    &["f", "F", "c", "s", "p", "q", "g", "b", "hat", "sum", "prod", "n", "d", "t_", "floor", "cases", "norm"];

/// The calls in a text: names before a bracket.
fn calls(text: &str) -> Vec<String> {
    let name = |before: &str| -> Option<String> {
        let start = before.rfind(|c: char| !(c.is_alphanumeric() || c == '_')).map_or(0, |at| at + 1);
        // {name}(…) is filled in; \binom{n}{k}( is LaTeX.
        let own = &before[start..];
        let open = before[..start].ends_with(['{', '\\', '}', '\'']);
        (!own.is_empty() && !own.starts_with(|c: char| c.is_ascii_digit()) && !open).then(|| own.to_owned())
    };
    let mut found = Vec::new();
    for (at, _) in text.match_indices('(') {
        found.extend(name(&text[..at]));
    }
    found
}

#[test]
fn hints_call_functions_of_the_table() {
    let known: BTreeSet<&str> = functions().into_iter().chain(NOTATIONS.iter().copied()).collect();
    let (count, wrong) = unknown(&known, |file, text| {
        if !(file.starts_with("language/functions/")
            || file.starts_with("language/ops/")
            || file.starts_with("language/eval/")
            || file.starts_with("session/"))
        {
            return Vec::new();
        }
        let hints = quoted(
            text,
            &[".hint(", ".hint(format!(", "Code::Shape, ", "Code::Domain, ", "Code::Undecided, "],
        );
        hints.iter().flat_map(|hint| calls(hint)).collect()
    });
    assert!(wrong.is_empty(), "no functions in hints: {}", wrong.join(", "));
    assert!(count > 60, "{count}");
}

#[test]
fn a_name_that_is_gone_is_found() {
    let text = "let f = builtin(\"beziers\"); if draft.builtin.name == \"polarr\" || \
                matches!(builtin.name, \"bezier\" | \"spilne\") { args.named(\"wieghts\") }";
    assert_eq!(quoted(text, &["builtin("]), ["beziers"]);
    assert_eq!(compared(text, "builtin"), ["polarr", "bezier", "spilne"]);
    assert_eq!(quoted(text, &[".named("]), ["wieghts"]);
    assert_eq!(calls("write bezeir([0, 1]) or {name}(t)"), ["bezeir"]);
}
