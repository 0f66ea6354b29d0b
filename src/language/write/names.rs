//! Names: Greek letters, LaTeX commands, Python identifiers.

use crate::language::lexicon::letters;

/// Further names that are commands of their own in LaTeX.
const COMMANDS: &[&str] = &[
    "hbar", "imath", "jmath", "infty", "nabla", "partial", "emptyset", "top", "bot", "dagger", "star",
    "angle", "sin", "cos", "tan", "cot", "sec", "csc", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh",
    "exp", "log", "ln", "lg", "det", "dim", "deg", "gcd", "ker", "arg", "inf", "sup", "Pr", "max", "min",
    "lim",
];

/// What an infix operator that the tree keeps as a call of two or more is in LaTeX: `a \cup b`.
const OPERATORS: &[(&str, &str)] = &[
    ("cup", " \\cup "),
    ("cap", " \\cap "),
    ("setminus", " \\setminus "),
    ("otimes", " \\otimes "),
    ("oplus", " \\oplus "),
];

/// The sign of a name in Unicode, if it has one.
pub(super) fn sign(name: &str) -> Option<&'static str> {
    if name == "infty" {
        return Some("∞");
    }
    letters::sign(name)
}

/// The infix sign in LaTeX of a function that is written between its arguments.
pub(super) fn operator(name: &str) -> Option<&'static str> {
    OPERATORS.iter().find(|(operator, _)| *operator == name).map(|(_, sign)| *sign)
}

/// Whether the name is that of a LaTeX command that KaTeX and amsmath both have.
pub(super) fn is_command(name: &str) -> bool {
    // Omicron looks like the letter o, which is why TeX has no command for it.
    name != "omicron" && (COMMANDS.contains(&name) || letters::sign(name).is_some())
}

/// Words in LaTeX text mode, with the signs that mean something there escaped.
pub(super) fn escaped(words: &str) -> String {
    let mut text = String::with_capacity(words.len());
    for c in words.chars() {
        match c {
            '\\' => text.push_str("\\textbackslash{}"),
            '^' => text.push_str("\\textasciicircum{}"),
            '~' => text.push_str("\\textasciitilde{}"),
            '{' | '}' | '$' | '%' | '#' | '&' | '_' => {
                text.push('\\');
                text.push(c);
            }
            c if c.is_control() => text.push(' '),
            c => text.push(c),
        }
    }
    text
}

/// Words that cannot be names in Python.
const KEYWORDS: &[&str] = &[
    "False", "None", "True", "and", "as", "assert", "async", "await", "break", "class", "continue", "def",
    "del", "elif", "else", "except", "finally", "for", "from", "global", "if", "import", "in", "is",
    "lambda", "nonlocal", "not", "or", "pass", "raise", "return", "try", "while", "with", "yield",
];

/// Names of letters that SymPy takes for a number or function of its own.
const OF_SYMPY: &[&str] = &[
    "E", "I", "N", "O", "Q", "S", "beta", "gamma", "zeta", "pi", "Lambda", "E1", "Chi", "Ci", "Ei", "Li",
    "Si",
];

/// The name as a Python identifier that is a symbol to SymPy: keywords and names that mean
/// something to it get an underscore at their end, and what cannot stand in an identifier becomes one.
pub(super) fn identifier(name: &str) -> String {
    let mut text = String::new();
    for c in name.chars() {
        match c {
            '\'' => text.push_str("_prime"),
            '^' => text.push_str("_to_"),
            _ => text.push(if c.is_alphabetic() || c.is_ascii_digit() { c } else { '_' }),
        }
    }
    if text.chars().next().is_none_or(|c| c.is_ascii_digit()) {
        text.insert(0, '_');
    }
    if KEYWORDS.contains(&text.as_str()) || OF_SYMPY.contains(&text.as_str()) {
        text.push('_');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers() {
        for (name, identifier_) in [
            ("t", "t"),
            ("lambda", "lambda_"),
            ("01", "_01"),
            ("a b", "a_b"),
            ("", "_"),
            ("Bézier", "Bézier"),
            ("E", "E_"),
            ("beta", "beta_"),
        ] {
            assert_eq!(identifier(name), identifier_);
        }
    }

    #[test]
    fn escapes() {
        assert_eq!(
            escaped("50% of {x}_1^2 \\ ~"),
            r"50\% of \{x\}\_1\textasciicircum{}2 \textbackslash{} \textasciitilde{}"
        );
    }
}
