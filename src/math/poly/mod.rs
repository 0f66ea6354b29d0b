//! Polynomials in one and in several variables, and their fractions.

mod coefficients;
mod definite;
mod dense;
mod dense_compose;
mod dense_divide;
mod dense_modular;
mod dense_ntt;
mod divide;
mod factor;
mod fraction;
mod gcd;
mod gcd_modular;
mod gcd_roots;
#[cfg(test)]
mod gcd_tests;
mod multiply;
mod multivariate;
mod one_variable;
mod real_roots;
mod resultant;
mod ring_ops;
mod symbol;
pub(in crate::math) mod text;
mod univariate;
mod univariate_gcd;
mod univariate_ops;
#[cfg(test)]
mod univariate_tests;

pub use coefficients::Coefficients;
pub(crate) use coefficients::horner;
pub use factor::Factorization;
pub use fraction::{DivisionByZero, Fraction};
pub use multivariate::{MonomialOrder, MultiPoly, Powers};
pub use real_roots::{AlgebraicNumber, Clip, ClipOutcome, Extreme, Part, Positivity, RealRoot, sign_changes};
pub use symbol::{Index, Symbol};
pub use univariate::Poly;
