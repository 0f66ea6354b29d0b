//! Interpolation as a system of linear equations.
//!
//! **Definition.** For nodes x_0, …, x_n the Vandermonde matrix has the entries V_{ij} = x_i^j; the
//! power coefficients a of the interpolating polynomial solve V a = y. Its determinant is
//! ∏_{i<j} (x_j − x_i), and column j of V^{-1} holds the power coefficients of Lagrange's L_j.
//!
//! For Hermite data the rows of a node are the derivatives of (1, t, …, t^n) there; the
//! determinant is then ∏_i ∏_{k<m_i} k! · ∏_{i<j} (x_j − x_i)^{m_i m_j}.
//!
//! References: W. Gautschi, "On inverses of Vandermonde and confluent Vandermonde matrices",
//! Numer. Math. 4 (1962); N. J. Higham, *Accuracy and Stability of Numerical Algorithms* (2002),
//! chapter 22.

use nalgebra::DMatrix;

use crate::budget;
use crate::math::number::{Int, Rational, factorial};
use crate::math::ring::Ring;

/// V with V_{ij} = x_i^j, one row for each node, columns for the degrees 0, …, `degree`.
///
/// Nodes may be equal. Cost: a product for each entry.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::interpolate::vandermonde;
/// use polarform::number::integer as z;
/// assert_eq!(vandermonde(&[2, 3].map(z), 2), DMatrix::from_row_slice(2, 3, &[1, 2, 4, 1, 3, 9].map(z)));
/// ```
pub fn vandermonde<C: Ring>(nodes: &[C], degree: usize) -> DMatrix<C> {
    let columns = degree.saturating_add(1);
    budget::charge_terms((nodes.len() as u64).saturating_mul(columns as u64));
    let powers = |x: &C| {
        std::iter::successors(Some(C::one()), |power| {
            budget::step();
            Some(power.times(x))
        })
        .take(columns)
        .collect::<Vec<C>>()
    };
    DMatrix::from_row_iterator(nodes.len(), columns, nodes.iter().flat_map(powers))
}

/// det V = ∏_{i<j} (x_j − x_i) of the square matrix for n + 1 nodes; 0 if two are equal, 1 for at
/// most one node. Cost: n²/2 products.
///
/// ```
/// use polarform::interpolate::vandermonde_determinant;
/// use polarform::number::integer as z;
/// assert_eq!(vandermonde_determinant(&[1, 2, 4].map(z)), z(6));
/// ```
pub fn vandermonde_determinant<C: Ring>(nodes: &[C]) -> C {
    let mut product = C::one();
    for (j, right) in nodes.iter().enumerate() {
        for left in &nodes[..j] {
            budget::step();
            product *= right.minus(left);
        }
    }
    product
}

/// The matrix for Hermite data at nodes x_i with multiplicities m_i: Σ m_i rows and columns, in the
/// block of x_i row k has the k-th derivatives j!/(j−k)! x_i^{j−k}.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::interpolate::confluent_vandermonde;
/// use polarform::number::integer as z;
/// let matrix = confluent_vandermonde(&[(z(2), 2), (z(5), 1)]);
/// assert_eq!(matrix, DMatrix::from_row_slice(3, 3, &[1, 2, 4, 0, 1, 4, 1, 5, 25].map(z)));
/// ```
pub fn confluent_vandermonde<C: Ring>(nodes: &[(C, usize)]) -> DMatrix<C> {
    let size = charged_size(nodes);
    let mut matrix = DMatrix::zeros(size, size);
    let mut row = 0;
    for (x, multiplicity) in nodes {
        for k in 0..*multiplicity {
            // j!/(j−k)! x^{j−k}, from j = k on
            let mut falling = factorial(k);
            let mut power = C::one();
            for j in k..size {
                budget::step();
                matrix[(row, j)] = power.scaled(&Rational::from_integer(falling.clone()));
                power *= x.clone();
                falling = (falling * Int::from(j + 1)).div_exact(&Int::from(j + 1 - k));
            }
            row += 1;
        }
    }
    matrix
}

/// Σ m_i, charged for as a square matrix.
fn charged_size<C>(nodes: &[(C, usize)]) -> usize {
    let size = nodes.iter().fold(0usize, |sum, (_, m)| sum.saturating_add(*m));
    budget::charge_terms((size as u64).saturating_mul(size as u64));
    size
}
