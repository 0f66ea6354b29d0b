//! Interpolation and approximation by polynomials and cubic splines, exactly.
//!
//! Nodes are elements of a field: rational numbers, or formulas in symbols where no order is
//! needed. Data are numbers of that field or points of any dimension ([`Datum`]). Everything a
//! lecture shows on the way is kept: tables of divided differences, Neville's tableau, systems of
//! equations and their matrices.
//!
//! | for | see |
//! | --- | --- |
//! | divided differences, Newton's form, repeated nodes | [`DividedDifferences`], [`NewtonForm`] |
//! | Lagrange's form, barycentric weights | [`LagrangeForm`], [`polynomial_through`] |
//! | Hermite data, Bézier points from them | [`DividedDifferences::hermite`], [`hermite_bezier`] |
//! | Neville's and Aitken's pyramid | [`Tableau`] |
//! | the matrices, their inverses and condition numbers | [`vandermonde`], [`Condition`] |
//! | the error of interpolation | [`Remainder`] |
//! | cubic splines by moments and by slopes | [`CubicSpline`], [`SplineSystem`] |
//! | least squares, weighted and with conditions | [`least_squares`], [`fit_polynomial`] |
//! | parameters for points: uniform, chord, centripetal, Foley | [`parameters()`] |
//!
//! **Invariant.** Every way to the same polynomial gives the same polynomial; the tests compare
//! them. Polynomials are lists of power coefficients, lowest first, of a length that the number
//! of data says: leading coefficients may be zero.
//!
//! Not here: radial basis functions and Gaussian fits, which are not polynomial.

mod condition;
mod datum;
mod error;
mod hermite;
mod lagrange;
mod least_squares;
mod neville;
mod newton;
mod numbers;
mod parameters;
mod remainder;
mod spline;
mod vandermonde;

#[cfg(test)]
mod tests;

pub use condition::{Condition, Norm, matrix_condition, power_bernstein_condition};
pub(in crate::math) use datum::increasing;
pub use datum::{Datum, value_of};
pub use error::InterpolationError;
pub use hermite::{hermite_basis, hermite_bezier};
pub use lagrange::{LagrangeForm, barycentric_weights, nodal_polynomial, polynomial_through};
pub use least_squares::{
    Conditions, FitOptions, LeastSquares, PolynomialFit, fit_polynomial, least_squares, least_squares_under,
};
pub use neville::{Scheme, Tableau};
pub use newton::{DividedDifferences, NewtonForm};
pub use parameters::{Parameterization, Parameters, Scale, parameters};
pub use remainder::Remainder;
pub use spline::{CubicSpline, End, Ends, SplineSystem, Tridiagonal, Unknowns};
pub use vandermonde::{confluent_vandermonde, vandermonde, vandermonde_determinant};
