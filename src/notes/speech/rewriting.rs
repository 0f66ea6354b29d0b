//! Formulas that a sentence writes in another form.

use super::normal;

/// Whether words between two formulas say that the one is written as the other: "as", or, after a function at an argument,
/// "as a sum of Bernstein polynomials".
pub fn says_as(words: &str, function: bool) -> bool {
    let text = normal(words);
    let short = text.chars().count() < 60 && !text.contains(['.', ',', ';', ':']);
    short
        && AS.iter().any(|(start, spaced)| {
            let rest = text.strip_prefix(start);
            rest.is_some_and(|rest| rest.is_empty() || function && (!spaced || rest.starts_with(' ')))
        })
}

/// How words begin that lead from a formula to another form of it, and whether blanks separate them.
const AS: &[(&str, bool)] = &[
    ("as", true),
    ("in the form", true),
    ("als", true),
    ("in der form", true),
    ("comme", true),
    ("sous la forme", true),
    ("写成", false),
    ("写为", false),
    ("表示为", false),
    ("表示成", false),
];
