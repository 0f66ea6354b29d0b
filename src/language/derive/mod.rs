//! Derivations as a person writes them on a board: lines of formulas, each with its reason.
//!
//! **Definition.** A *derivation* ([`crate::language::value::Derivation`]) is a list of lines; each line is
//! an equation (or several side by side) that either introduces a name or holds by the lines before
//! it, and words that say why. The last line is the result. Numbers are put in: nothing is left to
//! be computed by the reader.
//!
//! **Invariant.** Every line is true. The tests read each one back and have it checked, by the
//! language and by the checker of lecture notes.
//!
//! | for | see |
//! | --- | --- |
//! | a polar form by each of six methods | [`polar()`] |
//! | the polar form of a sum, product, composition | [`combination`] |
//! | derivatives by vector arguments; elevation | [`derivative`], [`elevation`], [`elevation_of_curve`] |
//! | A_n and its inverse | [`power_matrix`], [`bernstein_matrix`] |
//! | values by schemes; inserted knots | [`casteljau`], [`de_boor`], [`insertion`] |
//! | C^k conditions | [`joining`] |
//! | divided differences; cubic splines | [`newton()`], [`moments()`] |
//! | real roots in intervals of their own | [`roots()`] |
//! | F ≥ 0 or F > 0 on an interval | [`positivity()`], [`positivity_by_elevation`] |
//! | Sturm's chain with its signs; Sylvester's determinant | [`sturm`]; [`resultant`] |
//! | how two curves meet G^k | [`geometric_steps`] |
//! | the hull property; a curvature | [`hull()`]; [`curvature()`] |
//! | F ≥ 0 on a rectangle or triangle; a box or tetrahedron | [`positivity_over`] |
//! | real roots by convex hulls | [`clipping()`] |
//! | the β-matrix of G^k | [`connection_matrix`] |
//! | the equation of a plane curve | [`implicit()`] |
//! | Coons' surface; a multirational blossom | [`coons`]; [`multirational_steps`] |
//! | all words, in all languages | [`words`] |
//!
//! References: those of the modules whose results are derived: [`crate::math::blossom`],
//! [`crate::math::curve`], [`crate::math::spline`], [`crate::math::interpolate`].

mod blend;
mod calculus;
mod clipping;
mod combine;
mod connection;
mod curvature;
mod elimination;
mod geometric;
mod hull;
mod implicit;
mod join;
mod lines;
mod matrices;
mod moments;
mod multirational;
mod newton;
mod polar;
mod positivity;
mod region;
mod roots;
mod schemes;
pub mod words;

pub use blend::coons;
pub use calculus::{derivative, elevation, elevation_of_curve};
pub use clipping::clipping;
pub use combine::{Combination, combination};
pub use connection::connection_matrix;
pub use curvature::curvature;
pub use elimination::{resultant, sturm};
pub use geometric::geometric_steps;
pub use hull::hull;
pub use implicit::implicit;
pub use join::joining;
pub use matrices::{bernstein_matrix, power_matrix};
pub use moments::moments;
pub use multirational::multirational_steps;
pub use newton::newton;
pub use polar::{Names, polar, polar_of_curve};
pub use positivity::{Claimed, positivity, positivity_by_elevation, shows_negative_value};
pub use region::positivity_over;
pub use roots::roots;
pub use schemes::{casteljau, de_boor, insertion, mean_of_two, polar_label, shown_as_means};
