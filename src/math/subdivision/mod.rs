//! Subdivision of polygons by a mask, and of meshes around a vertex.
//!
//! **Definition.** A binary scheme with the mask a makes of the points p_j the points p'_i = Σ_j a_{i−2j} p_j. Its
//! symbol is a(z) = Σ a_k z^k. Where the polygons converge, to Σ p_j φ(x − j), the basic limit function φ
//! satisfies φ(x) = Σ a_k φ(2x − k).
//!
//! **Facts.** Sum rules of order k say that (1 + z)^k divides a(z). If a(z) = (1 + z) q(z), the differences of the
//! points are subdivided by the mask of q. The limits are C^m for all points if the differences of order
//! m + 1, divided by the width of the steps, go to 0: if for q(z) = 2^m a(z)/(1 + z)^{m+1} the norm of some
//! iterate, ‖S_q^L‖ = max_i Σ_j |c_{i − 2^L j}| with the coefficients c of q(z) q(z²) ⋯ q(z^{2^{L−1}}), is below 1.
//!
//! References: N. Dyn, "Subdivision schemes in computer-aided geometric design" (1992); N. Dyn, D. Levin,
//! "Subdivision schemes in geometric modelling", Acta Numerica 11 (2002); J. Warren, H. Weimer, *Subdivision
//! Methods for Geometric Design* (2002).

mod limit;
mod scheme;
mod smoothness;
mod tangent;
#[cfg(test)]
mod tests;
mod vertex;

use std::fmt;

pub use limit::{Stencil, limit_stencil};
pub use scheme::Scheme;
pub use smoothness::{Contraction, contraction, iterated_norm};
pub use tangent::{Weight, vertex_tangents};
pub use vertex::{Cosine, VertexScheme, vertex_eigenvalues, vertex_limit, vertex_matrix};

/// Why points cannot be subdivided, or a scheme not be analysed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SubdivisionError {
    /// All coefficients of the mask are 0.
    EmptyMask,
    /// There are too few points for one new one.
    TooFewPoints {
        /// How many are needed.
        needed: usize,
        /// How many there are.
        given: usize,
    },
    /// The points have different numbers of coordinates.
    Dimensions {
        /// The first that differs.
        index: usize,
    },
    /// A norm needs numbers, the mask has symbols.
    Symbols,
    /// That the limits are so smooth could not be shown.
    NotShown {
        /// The order of the derivative asked for.
        order: usize,
    },
    /// The values of the limit function are not determined by the eigenvectors of the local matrix.
    NotDetermined {
        /// The order of the derivative asked for.
        order: usize,
    },
    /// Faces and vertices have at least three edges.
    Valence {
        /// The number given.
        given: usize,
    },
}

impl fmt::Display for SubdivisionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SubdivisionError::EmptyMask => f.write_str("all coefficients of the mask are 0"),
            SubdivisionError::TooFewPoints { needed, given } => {
                write!(f, "this scheme needs at least {needed} points, {given} given")
            }
            SubdivisionError::Dimensions { index } => {
                write!(f, "point {index} has another number of coordinates than the first one")
            }
            SubdivisionError::Symbols => f.write_str("whether this scheme converges depends on symbols"),
            SubdivisionError::NotShown { order: 0 } => {
                f.write_str("that this scheme converges could not be shown")
            }
            SubdivisionError::NotShown { order } => {
                write!(f, "that the limits of this scheme are C^{order} could not be shown")
            }
            SubdivisionError::NotDetermined { order } => {
                write!(
                    f,
                    "the eigenvectors of the local matrix do not determine the derivatives of order {order}"
                )
            }
            SubdivisionError::Valence { given } => write!(f, "a vertex has 3 or more edges, not {given}"),
        }
    }
}

impl std::error::Error for SubdivisionError {}
