//! Polynomials in one and in several variables, and their fractions.

mod fraction;
mod gcd;
mod multiply;
mod multivariate;
mod symbol;

pub use fraction::{DivisionByZero, Fraction};
pub use multivariate::{MonomialOrder, MultiPoly, Powers};
pub use symbol::{Index, Symbol};
