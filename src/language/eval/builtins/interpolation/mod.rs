//! Interpolation by polynomials and cubic splines, and approximation by least squares.

mod approximation;
mod data;
mod polynomials;
mod splines;
mod tables;

pub(super) use approximation::TABLE as APPROXIMATION;
pub(super) use data::Samples;
pub(super) use polynomials::TABLE as POLYNOMIALS;
pub(super) use splines::TABLE as SPLINES;
pub(super) use splines::ends;

const TOPIC: &str = "Interpolation and approximation";
