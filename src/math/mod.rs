//! The mathematics: exact numbers, polynomials, polar forms, curves and splines. It knows no text,
//! no formulas and no places; what can go wrong is a small error of its own.

pub mod approximation;
pub mod basis;
pub mod blossom;
pub mod curve;
pub mod interpolate;
pub mod interval;
pub mod linalg;
pub mod number;
pub mod piecewise;
pub mod poly;
pub mod ring;
pub mod spline;
pub mod subdivision;
pub mod system;
