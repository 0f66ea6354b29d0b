//! The error of interpolation, exactly.
//!
//! **Fact.** For a polynomial f, nodes x_0, …, x_n (repeated or not) and the p of degree at most n
//! that interpolates f there,
//!
//! f(t) − p(t) = f[x_0, …, x_n, t] ω(t),   ω(t) = (t − x_0) ⋯ (t − x_n):
//!
//! p is the remainder and t ↦ f[x_0, …, x_n, t] the quotient of f by ω.
//!
//! Reference: C. de Boor, "Divided differences", Surveys in Approximation Theory 1 (2005).

use super::InterpolationError;
use super::datum::{Datum, divided, enough, same_dimension};
use super::lagrange::nodal_polynomial;
use super::newton::NewtonForm;
use crate::math::ring::Ring;

/// A polynomial f, split into its interpolant and the error f − p = quotient · ω.
///
/// ```
/// use polarform::interpolate::Remainder;
/// use polarform::number::integer as z;
/// // t^3 at the nodes 0 and 1: t^3 − t = (t + 1) · t (t − 1)
/// let remainder = Remainder::new(&[0, 0, 0, 1].map(z), &[0, 1].map(z))?;
/// assert_eq!(remainder.interpolant.to_power(), [0, 1].map(z));
/// assert_eq!(remainder.quotient, [1, 1].map(z));
/// assert_eq!(remainder.nodal, [0, -1, 1].map(z));
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Remainder<C, V = C> {
    /// p, with the coefficients f\[x_0\], …, f[x_0, …, x_n].
    pub interpolant: NewtonForm<C, V>,
    /// The power coefficients of t ↦ f[x_0, …, x_n, t], of degree deg f − n − 1; none if f = p.
    pub quotient: Vec<V>,
    /// The power coefficients of ω.
    pub nodal: Vec<C>,
}

impl<C: Ring, V: Datum<C>> Remainder<C, V> {
    /// Divides f, given by its power coefficients, by t − x_0, …, t − x_n in turn; no differences
    /// of nodes are divided by, so nodes may repeat in any order. Cost: one product for each
    /// node and coefficient.
    ///
    /// # Errors
    /// [`InterpolationError`] when there are no nodes or coefficients, or their dimensions differ.
    pub fn new(f: &[V], nodes: &[C]) -> Result<Self, InterpolationError> {
        enough(nodes.len(), 1)?;
        enough(f.len(), 1)?;
        same_dimension(f)?;
        let zero = f[0].origin();
        let mut quotient = f.to_vec();
        let mut coefficients = Vec::with_capacity(nodes.len());
        for node in nodes {
            let (rest, remainder) = divided(&quotient, node).unwrap_or((Vec::new(), zero.clone()));
            coefficients.push(remainder);
            quotient = rest;
        }
        let interpolant = NewtonForm::new(nodes[..nodes.len() - 1].to_vec(), coefficients)?;
        Ok(Remainder { interpolant, quotient, nodal: nodal_polynomial(nodes) })
    }
}
