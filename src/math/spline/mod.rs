//! B-splines with exact, perhaps symbolic, knots: everything is the choice of a blossom argument.
//!
//! A spline of degree n has knots t_0 ≤ … ≤ t_{m+n} and control points d_0, …, d_{m−1}. On a knot
//! interval [t_j, t_{j+1}] it is one polynomial F_j with polar form f_j, and
//! d_i = f_j(t_{i+1}, …, t_{i+n}) for every interval in the support [t_i, t_{i+n+1}] of N_i^n.
//! Inserting a knot, raising the degree, going to Bézier pieces: each asks f_j for other labels.
//!
//! **Invariant.** Knots do not decrease where their differences are numbers, no knot has a
//! multiplicity above n + 1, and there are m + n + 1 of them for m control points. Symbolic
//! knots are taken to be in the order given, different symbols to be different.
//!
//! References: L. Ramshaw, "Blossoms are polar forms", CAGD 6 (1989); C. de Boor, *A Practical
//! Guide to Splines* (2001), chapters IX–XI; L. Piegl, W. Tiller, *The NURBS Book* (1997).

mod basis;
mod blend;
mod bspline;
mod calculus;
mod convert;
mod degree;
mod display;
mod insertion;
mod integers;
mod knots;
mod parts;
mod rational;
mod rational_surface;
mod sum;
mod surface;
#[cfg(test)]
mod tests;

use std::fmt;

use crate::math::curve::CurveError;
use crate::math::interval::EmptyInterval;

pub use blend::{coons_spline, ruled_spline};
pub use bspline::{BSpline, DeBoor};
pub use insertion::Defect;
pub use knots::KnotVector;
pub use rational::RationalSpline;
pub use rational_surface::RationalSplineSurface;
pub use surface::SplineSurface;

/// Why a spline cannot be made or changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SplineError {
    /// There are fewer knots than a single basis function needs.
    TooFewKnots {
        /// The degree.
        degree: usize,
        /// How many knots are needed at least.
        needed: usize,
        /// How many there are.
        given: usize,
    },
    /// A knot is smaller than the one before it.
    DecreasingKnots {
        /// The place of the offending knot, from 0.
        index: usize,
    },
    /// A knot is repeated more often than degree + 1 times.
    Multiplicity {
        /// The place of its first occurrence, from 0.
        index: usize,
        /// Its multiplicity.
        found: usize,
        /// The largest one allowed.
        allowed: usize,
    },
    /// The number of control points is not that of the knots minus degree + 1.
    PointCount {
        /// Number of control points.
        points: usize,
        /// Number of knots.
        knots: usize,
        /// The degree.
        degree: usize,
    },
    /// A curve needs at least degree + 1 control points and an interval where it lives.
    NoDomain,
    /// A basis function with this number does not exist.
    NoSuchFunction {
        /// The number asked for.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// The parameter lies outside of the domain of the curve.
    OutsideDomain,
    /// On which knot interval the parameter lies depends on symbols.
    Unordered,
    /// The parameter is not a knot, or not often enough.
    NotAKnot {
        /// How often it occurs inside of the domain.
        multiplicity: usize,
        /// How often it was to be removed.
        times: usize,
    },
    /// The pieces of the function do not fit the knots: at the given knot it is less smooth.
    NotSmooth {
        /// The place of the knot, from 0.
        knot: usize,
    },
    /// A knot of the spline is missing among the finer knots, or not there often enough.
    MissingKnot {
        /// The place of the knot, from 0.
        index: usize,
    },
    /// One polynomial piece has a larger degree than asked for.
    PieceDegree {
        /// The piece, from 0.
        piece: usize,
        /// Its exact degree.
        exact: usize,
        /// The degree asked for.
        asked: usize,
    },
    /// The two splines have different domains.
    Domains,
    /// A problem with the control points.
    Curve(CurveError),
}

impl fmt::Display for SplineError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SplineError::TooFewKnots { degree, needed, given } => {
                write!(f, "degree {degree} needs at least {needed} knots, {given} given")
            }
            SplineError::DecreasingKnots { index } => {
                write!(f, "knot t_{index} is smaller than the one before it")
            }
            SplineError::Multiplicity { index, found, allowed } => {
                write!(f, "knot t_{index} is repeated {found} times, at most {allowed} are possible")
            }
            SplineError::PointCount { points, knots, degree } => {
                let needed = knots.saturating_sub(degree + 1);
                write!(f, "{knots} knots of degree {degree} need {needed} control points, {points} given")
            }
            SplineError::NoDomain => {
                f.write_str("a curve of degree n needs n + 1 control points and a knot interval between them")
            }
            SplineError::NoSuchFunction { index, count } => {
                write!(
                    f,
                    "there is no basis function {index}: they are numbered 0 to {}",
                    count.saturating_sub(1)
                )
            }
            SplineError::OutsideDomain => f.write_str("the parameter lies outside of the domain"),
            SplineError::Unordered => {
                f.write_str("on which knot interval the parameter lies depends on symbols")
            }
            SplineError::NotAKnot { multiplicity: 0, .. } => {
                f.write_str("this parameter is no knot inside of the domain")
            }
            SplineError::NotAKnot { multiplicity, times } => {
                write!(f, "this knot occurs {multiplicity} times, it cannot be removed {times} times")
            }
            SplineError::NotSmooth { knot } => {
                write!(f, "the pieces do not meet smoothly enough at knot t_{knot}")
            }
            SplineError::MissingKnot { index } => {
                write!(f, "the knot t_{index} of the spline is not there, or not as often")
            }
            SplineError::PieceDegree { piece, exact, asked } => {
                write!(f, "piece {piece} has degree {exact}, more than {asked}")
            }
            SplineError::Domains => f.write_str("the two splines have different domains"),
            SplineError::Curve(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for SplineError {}

impl From<EmptyInterval> for SplineError {
    fn from(empty: EmptyInterval) -> Self {
        SplineError::Curve(empty.into())
    }
}

impl From<CurveError> for SplineError {
    fn from(error: CurveError) -> Self {
        SplineError::Curve(error)
    }
}

impl From<crate::math::piecewise::PiecewiseError> for SplineError {
    fn from(error: crate::math::piecewise::PiecewiseError) -> Self {
        match error {
            crate::math::piecewise::PiecewiseError::OutsideDomain => SplineError::OutsideDomain,
            crate::math::piecewise::PiecewiseError::Order { index } => SplineError::DecreasingKnots { index },
            _ => SplineError::Unordered,
        }
    }
}
