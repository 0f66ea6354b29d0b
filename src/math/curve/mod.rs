//! Bézier curves and surfaces, polynomial and rational, exact.
//!
//! A point is a list of coordinates in a field: rational numbers, or formulas in symbols. Every
//! curve or surface is kept by its control points; by its polar form f they are f at arguments
//! taken from the ends of its interval, and every algorithm here is a choice of arguments.
//! A rational curve of dimension d is a polynomial one of dimension d + 1, the weight last.
//!
//! References: L. Ramshaw, "Blossoms are polar forms", CAGD 6 (1989); G. Farin, *Curves and
//! Surfaces for CAGD*, 5th ed. (2002); H. Prautzsch, W. Boehm, M. Paluszny, *Bézier and B-Spline
//! Techniques* (2002).

pub mod affine;
mod bezier;
mod blend;
mod circle;
mod conic;
mod curvature;
pub(crate) mod display;
mod domain;
mod edge;
mod geometric;
mod green;
mod hull;
mod implicit;
mod inflection;
mod integers;
mod intersect;
mod join;
mod length;
mod moving;
mod patch;
mod patch_conversion;
mod point;
mod polygon;
mod projective;
mod rational;
mod rational_surface;
mod region;
mod revolve;
mod space;
mod sphere;
mod surface_equation;
mod traits;
mod triangle;
mod triangulation;
mod turn;
mod vanishing;

use std::fmt;

use crate::math::interval::EmptyInterval;

pub use crate::math::interval::Interval;
pub use bezier::{BezierCurve, Tableau, bernstein_maximum, bernstein_scaling, bezier_edge_basis};
pub use blend::{gordon_surface, ruled_surface, swept_surface};
pub use circle::{CircleArc, circle_quarters, circle_quintic, circle_thirds, full_circle};
pub use conic::{ConicKind, ImplicitConic, conic_arc, conic_kind, conic_through};
pub use curvature::{squared_curvature, torsion, turn};
pub use domain::{Corner, Triangle};
pub use edge::EdgeEquation;
pub use geometric::{
    GeometricContinuity, GeometricFailure, beta_matrix, geometric_continuity, jet, transferred,
};
pub use green::{AreaError, green};
pub use hull::convex_hull;
pub use implicit::{bezout_matrix, implicit_equation};
pub use inflection::{Straight, inflections};
pub use intersect::{Meeting, PlaneCurve};
pub use join::{Continuity, JoiningCondition, continuity_at, joining_conditions};
pub use length::{arc_length, polygon_moments, pythagorean_curve, pythagorean_offset, speed};
pub use moving::{MovingLine, inversion_formula, moving_lines};
pub(crate) use patch::transposed;
pub use patch::{Direction, Net, Scheme, Side, TensorPatch};
pub use point::{Point, PolarValue, Vector, combination, lerp};
pub(in crate::math) use projective::{check_weight, lifted, lifted_net, parted, projected};
pub use rational::RationalCurve;
pub use rational_surface::{RationalPatch, RationalTriangle};
pub use region::{Region, RegionFailure, RegionPart, RegionPositivity, RegionShown, positivity_on};
pub use revolve::{revolve, revolve_along};
pub use space::{ParametricSurface, SpaceCurve};
pub use sphere::{sphere_octant, sphere_octant_triangle};
pub use surface_equation::{curve_equations, surface_equation};
pub(in crate::math) use traits::quartered;
#[cfg(test)]
pub(in crate::math) use traits::tests::check as check_surface;
pub use traits::{Curve, Surface};
pub use triangle::{TrianglePatch, indices};
pub use triangulation::{CornerData, Triangulation, clough_tocher, powell_sabin};
pub use turn::revolve_about;

/// Why a curve or surface cannot be made or changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CurveError {
    /// There are no control points, or fewer than needed.
    TooFewPoints {
        /// How many are needed.
        needed: usize,
        /// How many there are.
        given: usize,
    },
    /// A point has another number of coordinates than the first one.
    Dimensions {
        /// The place of the offending point, from 0.
        index: usize,
        /// Its number of coordinates.
        found: usize,
        /// That of the first point.
        expected: usize,
    },
    /// The ends of the interval are equal.
    EmptyInterval,
    /// Number of weights and of control points differ.
    WeightCount {
        /// Number of weights.
        weights: usize,
        /// Number of control points.
        points: usize,
    },
    /// A weight is zero.
    ZeroWeight {
        /// Its place, from 0.
        index: usize,
    },
    /// The denominator of a rational curve vanishes at the parameter.
    ZeroDenominator,
    /// The parameter lies outside of the interval.
    OutsideDomain,
    /// The polar form takes another number of arguments.
    Arguments {
        /// How many it takes.
        expected: usize,
        /// How many there are.
        given: usize,
    },
    /// The two operands have different degrees.
    Degrees {
        /// Degree of the first.
        left: usize,
        /// Degree of the second.
        right: usize,
    },
    /// The two operands have different dimensions.
    DimensionsOf {
        /// Dimension of the first.
        left: usize,
        /// Dimension of the second.
        right: usize,
    },
    /// The degree cannot be lowered by `by`: the curve has an exact degree in the way.
    NotReducible {
        /// The degree of the representation.
        degree: usize,
        /// The exact degree of the polynomial.
        exact: usize,
        /// How far it was to be lowered.
        by: usize,
    },
    /// The rows of a net have different lengths.
    RaggedNet {
        /// The row, from 0.
        row: usize,
        /// Its length.
        found: usize,
        /// The length of the first row.
        expected: usize,
    },
    /// The number of points is not (n+1)(n+2)/2.
    NotTriangular {
        /// The number of points.
        count: usize,
    },
    /// The corners of a triangle or simplex are affinely dependent.
    Degenerate,
    /// The two curves do not meet in a common parameter.
    NoCommonEnd,
    /// The two patches have no common edge.
    NoCommonEdge,
    /// A number has no rational square root.
    Irrational {
        /// What the root is needed for.
        what: &'static str,
    },
    /// The geometry asked for does not exist.
    Impossible {
        /// Why.
        why: &'static str,
    },
}

impl fmt::Display for CurveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CurveError::TooFewPoints { needed, given } => {
                write!(f, "{needed} control points needed, {given} given")
            }
            CurveError::Dimensions { index, found, expected } => {
                write!(f, "point {index} has {found} coordinates, the others have {expected}")
            }
            CurveError::EmptyInterval => EmptyInterval.fmt(f),
            CurveError::WeightCount { weights, points } => {
                write!(f, "{weights} weights for {points} control points")
            }
            CurveError::ZeroWeight { index } => write!(f, "weight {index} is zero"),
            CurveError::ZeroDenominator => f.write_str("the sum of the weights vanishes at this parameter"),
            CurveError::OutsideDomain => f.write_str("the parameter lies outside of the interval"),
            CurveError::Arguments { expected, given } => {
                write!(f, "the polar form takes {expected} arguments, not {given}")
            }
            CurveError::Degrees { left, right } => write!(f, "the degrees {left} and {right} differ"),
            CurveError::DimensionsOf { left, right } => {
                write!(f, "the dimensions {left} and {right} differ")
            }
            CurveError::NotReducible { degree, exact, by } => {
                write!(f, "degree {degree} cannot be lowered by {by}: the polynomial has degree {exact}")
            }
            CurveError::RaggedNet { row, found, expected } => {
                write!(f, "row {row} of the net has {found} points, the first row has {expected}")
            }
            CurveError::NotTriangular { count } => {
                write!(f, "{count} points form no triangle: 1, 3, 6, 10, … points do")
            }
            CurveError::Degenerate => f.write_str("the corners are affinely dependent"),
            CurveError::NoCommonEnd => {
                f.write_str("the first interval does not end where the second one starts")
            }
            CurveError::NoCommonEdge => f.write_str("the two patches have no common edge"),
            CurveError::Irrational { what } => write!(f, "{what} needs a square root that is not rational"),
            CurveError::Impossible { why } => f.write_str(why),
        }
    }
}

impl std::error::Error for CurveError {}

impl From<EmptyInterval> for CurveError {
    fn from(_: EmptyInterval) -> Self {
        CurveError::EmptyInterval
    }
}

/// The common number of coordinates of some points.
///
/// # Errors
/// [`CurveError::TooFewPoints`] if there are none, [`CurveError::Dimensions`].
pub fn dimension<C>(points: &[Point<C>]) -> Result<usize, CurveError> {
    let Some(first) = points.first() else {
        return Err(CurveError::TooFewPoints { needed: 1, given: 0 });
    };
    match points.iter().position(|point| point.len() != first.len()) {
        Some(index) => {
            Err(CurveError::Dimensions { index, found: points[index].len(), expected: first.len() })
        }
        None => Ok(first.len()),
    }
}
