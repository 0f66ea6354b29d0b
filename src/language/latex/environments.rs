//! The environments of LaTeX that the reader knows.

use super::token::Env;
use crate::formula::Delimiter;
use crate::language::diagnostic::nearest;

/// The environments the reader knows (each also with a star), with their meaning.
pub fn environments() -> impl Iterator<Item = (&'static str, &'static str)> {
    ENVIRONMENTS.iter().map(|&(name, meaning, _)| (name, meaning))
}

pub(super) fn lookup(name: &str) -> Option<Env> {
    let plain = name.strip_suffix('*').unwrap_or(name);
    ENVIRONMENTS.iter().find(|&&(known, ..)| known == plain).map(|&(_, _, env)| env)
}

pub(super) fn nearest_known(name: &str) -> Option<&'static str> {
    nearest(name, ENVIRONMENTS.iter().map(|&(known, ..)| known))
}

const ENVIRONMENTS: &[(&str, &str, Env)] = &[
    ("matrix", "matrix without brackets", Env::Matrix(Delimiter::None)),
    ("smallmatrix", "matrix without brackets", Env::Matrix(Delimiter::None)),
    ("pmatrix", "matrix in ( )", Env::Matrix(Delimiter::Paren)),
    ("bmatrix", "matrix in [ ]", Env::Matrix(Delimiter::Bracket)),
    ("Bmatrix", "matrix in { }", Env::Matrix(Delimiter::None)),
    ("vmatrix", "matrix in | |", Env::Matrix(Delimiter::Bar)),
    ("array", "matrix; aligned rows if its cells hold relations", Env::Array),
    ("subarray", "lines below a sum", Env::Array),
    ("cases", "values with conditions, or a system of equations", Env::Cases),
    ("dcases", "the same, set larger", Env::Cases),
    ("rcases", "the same, with the brace on the right", Env::Cases),
    ("align", "rows of formulas", Env::Rows),
    ("aligned", "rows of formulas", Env::Rows),
    ("alignat", "rows of formulas", Env::Rows),
    ("alignedat", "rows of formulas", Env::Rows),
    ("displaymath", "one formula", Env::Rows),
    ("eqnarray", "rows of formulas", Env::Rows),
    ("equation", "one formula", Env::Rows),
    ("flalign", "rows of formulas", Env::Rows),
    ("gather", "rows of formulas", Env::Rows),
    ("gathered", "rows of formulas", Env::Rows),
    ("math", "one formula", Env::Rows),
    ("multline", "a formula over several rows", Env::Rows),
    ("multlined", "a formula over several rows", Env::Rows),
    ("split", "rows of formulas", Env::Rows),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_found() {
        for (i, (name, ..)) in ENVIRONMENTS.iter().enumerate() {
            assert!(ENVIRONMENTS[..i].iter().all(|(other, ..)| other != name), "{name} twice");
        }
        assert_eq!(lookup("align*"), Some(Env::Rows));
        assert_eq!(nearest_known("algned"), Some("aligned"));
    }
}
