//! Whole pictures from control points, knots and polynomials.
//!
//! Each file holds one kind of picture: a plain structure of exact data with public fields, and
//! a method `scene` that gives the [`Scene`](super::Scene). Nothing here knows where the data
//! come from; names of points are formulas that the caller gives, and [`polar_labels`] and its
//! relatives make those in which control points are values f(r, …, s, …) of the polar form.
//!
//! | picture | shows |
//! | --- | --- |
//! | [`BezierPicture`] | Bézier curves with control polygons, hulls, points |
//! | [`CasteljauPicture`] | all levels of de Casteljau's algorithm |
//! | [`BsplinePicture`] | the pieces of a spline, its de Boor points, its knots |
//! | [`BasisPicture`] | graphs of functions over knots |
//! | [`PyramidPicture`] | a triangular scheme |
//! | [`PatchPicture`] | a tensor-product surface with its net |
//! | [`TrianglePicture`], [`TriangleDomain`] | a triangular surface; the names of its points |
//! | [`ContinuityPicture`] | whether two curves join with continuous derivatives |
//! | [`HodographPicture`] | a curve and its derivative |
//! | [`SubdivisionPicture`] | the polygons of a subdivision scheme |
//!
//! Reference: G. Farin, *Curves and Surfaces for CAGD*, 5th ed. (2002); L. Ramshaw, "Blossoms
//! are polar forms", CAGD 6 (1989).

mod axes;
mod basis;
mod bezier;
mod bspline;
mod casteljau;
mod continuity;
mod curve;
mod hodograph;
mod labels;
mod patch;
mod projection;
mod pyramid;
mod subdivision;
mod triangle;

pub use axes::as_graph;
pub use basis::{BasisPicture, Function, Knot, Piece};
pub use bezier::BezierPicture;
pub use bspline::BsplinePicture;
pub use casteljau::CasteljauPicture;
pub use continuity::ContinuityPicture;
pub use curve::Curve;
pub use hodograph::HodographPicture;
pub use labels::{bspline_labels, casteljau_labels, polar_labels, triangle_labels};
pub use patch::PatchPicture;
pub use projection::projected;
pub use pyramid::{Apex, PyramidPicture};
pub use subdivision::SubdivisionPicture;
pub use triangle::{TriangleDomain, TrianglePicture};

use crate::math::number::Rational;

/// A point of the plane, exactly.
pub type Plane = [Rational; 2];

/// A point of space, exactly.
pub type Space = [Rational; 3];
