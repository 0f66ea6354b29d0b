//! Interpolation by polynomials and cubic splines, and approximation by least squares.

mod approximation;
mod data;
mod energy;
mod polynomials;
mod spline_fits;
mod splines;
mod tables;

pub(crate) use approximation::TABLE as APPROXIMATION;
pub(crate) use data::Samples;
pub(crate) use energy::TABLE as ENERGY;
pub(crate) use polynomials::TABLE as POLYNOMIALS;
pub(crate) use spline_fits::TABLE as SPLINE_FITS;
pub(crate) use splines::TABLE as SPLINES;
pub(crate) use splines::{ENDS, MOMENTS, ONE_END, SLOPES, ends};

use super::Builtin;

const NEW: Builtin = Builtin::about("Interpolation and approximation");
