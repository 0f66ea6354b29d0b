//! The functions of the language: one table for evaluation, help, completion and docs.

mod arrange;
mod blends;
mod blossoms;
mod callable;
mod curves;
mod derive;
mod differential;
mod figures;
mod geometric;
mod interpolation;
mod intersections;
mod joins;
mod matrices;
mod measure;
mod numbers;
mod on_form;
mod on_geometry;
mod on_surface;
mod parameter;
mod polar;
mod polynomials;
mod rational;
mod rational_blossoms;
mod record;
mod regions;
mod roots;
mod sections;
mod solve;
mod splines;
mod subdivision;
mod surface_compositions;
mod surface_joins;
mod surface_schemes;
mod surfaces;
mod symmetric;
mod table;
mod told;
mod triangulations;
mod vertices;

pub(crate) use callable::{
    alias, callable, function_called, function_in_words, function_meant, is_argument_word, names, synonym,
};

pub use arrange::Arrangement;
pub use parameter::{Need, Parameter, Takes};
pub use record::{Builtin, Variant};
pub use table::{BUILTINS, builtin};

/// Whether a word that stands in a list names a basis or a subdivision scheme.
pub(crate) fn is_word(word: &str) -> bool {
    matrices::is_basis(word) || subdivision::is_scheme(word)
}

#[cfg(test)]
mod tests;
