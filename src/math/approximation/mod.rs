//! Inner products of curves, and what is nearest in them.
//!
//! ⟨F, G⟩ = ∫ F(t) · G(t) dt over an interval or the domain of a spline, exactly. From the Gram matrix of a
//! basis follow the dual basis, the best approximations, the energies of curves. Besides: functionals that
//! give control points ([`de_boor_fix`]) and splines from values ([`interpolating_spline`],
//! [`fitted_spline`]).
//!
//! | for | see |
//! | --- | --- |
//! | Gram, mass and stiffness matrices | [`bernstein_gram`], [`spline_gram`] |
//! | the basis dual to the Bernstein polynomials | [`dual_bernstein`] |
//! | ∫ \|c^(k)\|² | [`energy`], [`spline_energy`] |
//! | the nearest curve of a lower degree | [`best_reduction`] |
//! | control points as functionals, Schoenberg's spline | [`de_boor_fix`], [`schoenberg`] |
//! | interpolation and least squares by splines of any degree | [`interpolating_spline`], [`fitted_spline`] |
//!
//! References: R. T. Farouki, "Legendre–Bernstein basis transformations", J. Comput. Appl. Math. 119 (2000);
//! B. Jüttler, "The dual basis functions for the Bernstein polynomials", Adv. Comput. Math. 8 (1998);
//! C. de Boor, *A Practical Guide to Splines* (2001), chapters IX, XII–XIV.

mod fit;
mod functional;
mod gram;
mod reduction;
#[cfg(test)]
mod tests;

use std::fmt;

use crate::math::curve::CurveError;
use crate::math::interpolate::InterpolationError;
use crate::math::interval::EmptyInterval;
use crate::math::spline::SplineError;

pub use fit::{Smoothing, averaged_knots, fitted_spline, interpolating_spline};
pub use functional::{de_boor_fix, quasi_interpolant, schoenberg};
pub use gram::{bernstein_gram, dual_bernstein, energy, spline_energy, spline_gram};
pub use reduction::best_reduction;

/// Why there is no such approximation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ApproximationError {
    /// What is fixed at the ends are more control points than there are.
    TooManyEnds {
        /// How many points the ends fix.
        fixed: usize,
        /// How many points the curve of the lower degree has.
        points: usize,
    },
    /// The condition of Schoenberg and Whitney fails: the basis function vanishes at the node that
    /// should determine its coefficient.
    SchoenbergWhitney {
        /// The number of the basis function, which is also that of the node.
        index: usize,
    },
    /// No node is left for a basis function when each takes one from its support, in order.
    NoNodeFor {
        /// The number of the basis function.
        index: usize,
    },
    /// The number of nodes is not that of the basis functions.
    NodeCount {
        /// How many nodes there are.
        nodes: usize,
        /// How many basis functions.
        functions: usize,
    },
    /// A problem with nodes, values or weights.
    Interpolation(InterpolationError),
    /// A problem with a spline.
    Spline(SplineError),
}

impl fmt::Display for ApproximationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ApproximationError::TooManyEnds { fixed, points } => {
                write!(f, "the ends fix {fixed} control points, the curve of lower degree has {points}")
            }
            ApproximationError::SchoenbergWhitney { index } => {
                write!(
                    f,
                    "the condition of Schoenberg and Whitney fails: N_{index} is 0 at the node x_{index}"
                )
            }
            ApproximationError::NoNodeFor { index } => {
                write!(f, "the condition of Schoenberg and Whitney fails: no node is left for N_{index}")
            }
            ApproximationError::NodeCount { nodes, functions } => {
                write!(f, "{functions} basis functions need {functions} nodes, {nodes} given")
            }
            ApproximationError::Interpolation(error) => error.fmt(f),
            ApproximationError::Spline(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for ApproximationError {}

impl From<SplineError> for ApproximationError {
    fn from(error: SplineError) -> Self {
        ApproximationError::Spline(error)
    }
}

impl From<EmptyInterval> for ApproximationError {
    fn from(empty: EmptyInterval) -> Self {
        ApproximationError::Spline(empty.into())
    }
}

impl From<CurveError> for ApproximationError {
    fn from(error: CurveError) -> Self {
        ApproximationError::Spline(error.into())
    }
}

impl From<InterpolationError> for ApproximationError {
    fn from(error: InterpolationError) -> Self {
        ApproximationError::Interpolation(error)
    }
}
