//! Lines of scripts elsewhere that say nothing here: `from sympy import *`, `x = Symbol('x')`, `syms t`.

use crate::formula::source::Pieces;

/// Words that begin a line which only prepares what follows.
const PREPARATIONS: &[&str] = &["from", "import", "using", "syms"];

/// Calls that declare a name to be a symbol, or a ring.
const DECLARATIONS: &[&str] = &[
    "symbols",
    "Symbol",
    "var",
    "Function",
    "Symbols",
    "PolynomialRing",
    "QQ",
    "ZZ",
    "QQ[]",
    "ZZ[]",
    "init_printing",
    "declare",
];

/// The names that a text declares, if that is all it does.
pub(in crate::session) fn declared(text: &str) -> Option<Vec<&str>> {
    let text = text.trim().trim_end_matches([':', ';']);
    let (first, rest) = word(text);
    if PREPARATIONS.contains(&first)
        && (first != "from" || rest.contains(" import "))
        && rest.starts_with([' ', '\t'])
        && !rest.trim_start().starts_with(['=', ':', '('])
    {
        let names = if first == "syms" { names_in(rest) } else { Vec::new() };
        return Some(names);
    }
    // var('t'), x, y = sp.symbols('x y')
    let (left, call) = match text.split_once('=') {
        Some((left, right)) if left.chars().all(|c| c.is_alphanumeric() || ", _.<>".contains(c)) => {
            (left, right.trim())
        }
        _ => ("", text),
    };
    let call = call.split_once('.').filter(|(library, _)| library.len() < 6).map_or(call, |(_, call)| call);
    let (function, arguments) = word(call);
    let quoted = arguments.starts_with("('") || arguments.starts_with("(\"");
    let ring = left.contains(".<") && arguments.starts_with(['(', '[']);
    if !DECLARATIONS.contains(&function) || !(quoted || ring) || !arguments.ends_with([')', ']']) {
        return None;
    }
    let mut names = names_in(left.rsplit(".<").next().unwrap_or_default());
    names.extend(names_in(arguments));
    Some(names)
}

/// The text behind `with(LinearAlgebra):`, which makes functions known in Maple.
pub(in crate::session) fn after_package(text: &str) -> Option<usize> {
    let inside = text.trim_start().strip_prefix("with(")?;
    let (package, rest) = inside.split_once(')')?;
    let name = package.chars().all(char::is_alphanumeric) && package.len() > 1;
    let rest = rest.trim_start().strip_prefix(':').filter(|rest| !rest.starts_with('=') && name)?;
    (!rest.trim().is_empty()).then_some(text.len() - rest.len())
}

fn word(text: &str) -> (&str, &str) {
    let length = text.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(text.len());
    (text.piece(..length), text.piece(length..))
}

fn names_in(text: &str) -> Vec<&str> {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_')).filter(|name| !name.is_empty()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn declarations_are_told_from_statements() {
        for (text, names) in [
            ("from sympy import *", vec![]),
            ("x = Symbol('x')", vec!["x", "x"]),
            ("x, y = sp.symbols('x y')", vec!["x", "y", "x", "y"]),
            ("var('t')", vec!["t"]),
            ("syms s t", vec!["s", "t"]),
            ("R.<t> = QQ[]", vec!["t"]),
        ] {
            assert_eq!(declared(text), Some(names), "{text}");
        }
        for text in [
            "x = 3",
            "f = var",
            "clear = 2",
            "load(t)",
            "symbols = 3",
            "x = t'",
            "F = t^2",
            "from 1 to 2",
            "clear t",
        ] {
            assert_eq!(declared(text), None, "{text}");
        }
        assert_eq!(after_package("with(LinearAlgebra): det(A)"), Some(20));
        assert_eq!(after_package("with(t): 3"), None);
    }
}
