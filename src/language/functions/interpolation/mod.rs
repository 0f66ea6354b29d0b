//! Interpolation by polynomials and cubic splines, and approximation by least squares.

mod approximation;
mod data;
mod polynomials;
mod splines;
mod tables;

pub(crate) use approximation::TABLE as APPROXIMATION;
pub(crate) use data::Samples;
pub(crate) use polynomials::TABLE as POLYNOMIALS;
pub(crate) use splines::TABLE as SPLINES;
pub(crate) use splines::{ENDS, MOMENTS, SLOPES, ends};

use super::Builtin;

const NEW: Builtin = Builtin::about("Interpolation and approximation");
