//! The functions of the language: one table for evaluation, help, completion and docs.

mod arrange;
mod blends;
mod blossoms;
mod by_pieces;
mod callable;
mod conversions;
mod curves;
mod derive;
mod differential;
mod features;
mod figures;
mod geometric;
mod gives;
mod interpolation;
mod intersections;
mod joins;
mod matrices;
mod measure;
mod notions;
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
    alias, callable, function_called, function_in_words, function_meant, is_argument_word, names, senses,
    synonym,
};

pub(crate) use notions::{BASIS, BASIS_OR_KNOTS, SCHEME, is_word};

pub use super::ops::takes::{Notion, Takes};
pub use arrange::Arrangement;
pub use gives::Gives;
pub use parameter::{Need, Parameter};
pub use record::{Builtin, Variant};
pub use table::{BUILTINS, builtin};

#[cfg(test)]
mod tests;
