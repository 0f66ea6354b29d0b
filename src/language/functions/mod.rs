//! The functions of the language: one table for evaluation, help, completion and docs.

mod arrange;
mod callable;
mod curves;
mod derive;
mod differential;
mod figures;
mod interpolation;
mod joins;
mod matrices;
mod numbers;
mod on_form;
mod on_geometry;
mod on_surface;
mod parameter;
mod polar;
mod polynomials;
mod rational;
mod record;
mod roots;
mod solve;
mod splines;
mod surface_joins;
mod surfaces;
mod table;

pub(crate) use callable::{alias, callable, is_argument_word, names, synonym};
pub(crate) use matrices::is_basis;

pub use arrange::Arrangement;
pub use parameter::{Need, Parameter, Takes};
pub use record::{Builtin, Variant};
pub use table::{BUILTINS, builtin};

#[cfg(test)]
mod tests;
