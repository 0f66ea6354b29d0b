//! The functions of the language: one table for evaluation, help, completion and docs.

mod callable;
mod curves;
mod derive;
mod figures;
mod interpolation;
mod joins;
mod matrices;
mod numbers;
mod on_geometry;
mod on_surface;
mod polar;
mod polynomials;
mod rational;
mod splines;
mod surfaces;

pub(crate) use callable::{callable, names};

use crate::language::eval::{Arguments, Evaluated, Machine};

/// A function of the program.
pub struct Builtin {
    /// Its name.
    pub name: &'static str,
    /// How it is called.
    pub signature: &'static str,
    /// What it does, in one line.
    pub summary: &'static str,
    /// An example that runs.
    pub example: &'static str,
    /// The chapter of the reference it belongs to.
    pub topic: &'static str,
    /// The function itself.
    pub call: fn(&mut Machine, &Arguments) -> Evaluated,
}

impl std::fmt::Debug for Builtin {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.signature)
    }
}

/// All functions, by topic.
pub static BUILTINS: &[&Builtin] = &{
    const fn all<const N: usize>(tables: &[&'static [Builtin]]) -> [&'static Builtin; N] {
        let mut list = [&tables[0][0]; N];
        let (mut at, mut table) = (0, 0);
        while table < tables.len() {
            let mut i = 0;
            while i < tables[table].len() {
                list[at] = &tables[table][i];
                at += 1;
                i += 1;
            }
            table += 1;
        }
        list
    }
    const COUNT: usize = polar::TABLE.len()
        + polynomials::TABLE.len()
        + matrices::TABLE.len()
        + curves::TABLE.len()
        + splines::TABLE.len()
        + joins::TABLE.len()
        + derive::TABLE.len()
        + figures::TABLE.len()
        + surfaces::TABLE.len()
        + rational::TABLE.len()
        + interpolation::POLYNOMIALS.len()
        + interpolation::SPLINES.len()
        + interpolation::APPROXIMATION.len()
        + numbers::TABLE.len();
    all::<COUNT>(&[
        polar::TABLE,
        polynomials::TABLE,
        matrices::TABLE,
        curves::TABLE,
        splines::TABLE,
        rational::TABLE,
        surfaces::TABLE,
        joins::TABLE,
        derive::TABLE,
        interpolation::POLYNOMIALS,
        interpolation::SPLINES,
        interpolation::APPROXIMATION,
        figures::TABLE,
        numbers::TABLE,
    ])
};

/// Functions that work on a curve coordinate by coordinate when their first argument is a list
/// of polynomials, functions or polar forms.
pub(super) const COORDINATEWISE: &[&str] =
    &["polar", "elevate", "reduce", "partial", "diagonal", "derivative", "diff"];

/// Arguments whose value is a word, as in `labels=points`.
pub(super) const WORD_ARGUMENTS: &[&str] = &["labels", "apex", "method", "lang", "ends"];

/// Functions whose first argument is a word, as in `derive(sum, F, G)`.
pub(super) const WORD_FIRST: &[&str] = &["derive"];

/// The function of that name.
pub fn builtin(name: &str) -> Option<&'static Builtin> {
    BUILTINS.iter().copied().find(|builtin| builtin.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_complete() {
        for (i, builtin) in BUILTINS.iter().enumerate() {
            assert!(builtin.signature.starts_with(builtin.name), "{}", builtin.name);
            assert!(builtin.example.contains(builtin.name), "{}", builtin.name);
            let sentence = builtin.summary.ends_with('.') && !builtin.summary.ends_with("...");
            assert!(!sentence && builtin.summary.len() < 90, "{}", builtin.name);
            assert!(BUILTINS[..i].iter().all(|other| other.name != builtin.name), "{}", builtin.name);
        }
    }
}
