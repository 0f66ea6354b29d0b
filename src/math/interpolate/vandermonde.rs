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

use super::InterpolationError;
use super::datum::{distinct, enough, reciprocal};
use super::lagrange::LagrangeForm;
use crate::budget;
use crate::math::number::{Int, Rational, factorial};
use crate::math::ring::{Field, Ring};

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

/// V^{-1} for n + 1 distinct nodes: column j has the power coefficients of L_j. Cost: 3n² products.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::interpolate::vandermonde_inverse;
/// use polarform::number::integer as z;
/// let inverse = vandermonde_inverse(&[0, 1].map(z))?;
/// assert_eq!(inverse, DMatrix::from_row_slice(2, 2, &[1, 0, -1, 1].map(z)));
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
///
/// # Errors
/// [`InterpolationError`] when there are no nodes, or two are equal.
pub fn vandermonde_inverse<C: Field>(nodes: &[C]) -> Result<DMatrix<C>, InterpolationError> {
    let form = LagrangeForm::new(nodes, nodes)?;
    let count = nodes.len();
    Ok(DMatrix::from_iterator(count, count, form.basis_polynomials().into_iter().flatten()))
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

/// Its determinant ∏_i ∏_{k<m_i} k! · ∏_{i<j} (x_j − x_i)^{m_i m_j}.
///
/// ```
/// use polarform::interpolate::confluent_determinant;
/// use polarform::number::integer as z;
/// assert_eq!(confluent_determinant(&[(z(2), 2), (z(5), 1)]), z(9));
/// ```
pub fn confluent_determinant<C: Ring>(nodes: &[(C, usize)]) -> C {
    charged_size(nodes);
    let mut product = C::one();
    for (j, (right, m)) in nodes.iter().enumerate() {
        let factorials: Int = (0..*m).map(factorial).product();
        product = product.scaled(&Rational::from_integer(factorials));
        for (left, other) in &nodes[..j] {
            budget::step();
            product *= num_traits::pow(right.minus(left), m.saturating_mul(*other));
        }
    }
    product
}

/// Gautschi's bound max_j ∏_{k≠j} (1 + |x_k|)/|x_j − x_k| for the norm ‖V^{-1}‖_1, the largest sum
/// of the absolute power coefficients of an L_j. It is attained when no two nodes have
/// opposite signs. Cost: n² products.
///
/// ```
/// use polarform::interpolate::gautschi_bound;
/// use polarform::number::integer as z;
/// assert_eq!(gautschi_bound(&[0, 1, 2].map(z)), Ok(z(3))); // L_0 = 1 − 3/2 t + 1/2 t^2
/// ```
///
/// # Errors
/// [`InterpolationError`] when there are no nodes, or two are equal.
pub fn gautschi_bound(nodes: &[Rational]) -> Result<Rational, InterpolationError> {
    use num_traits::{One, Signed, Zero};
    enough(nodes.len(), 1)?;
    distinct(nodes)?;
    let product = |(j, x): (usize, &Rational)| {
        let others = nodes.iter().enumerate().filter(|(k, _)| *k != j);
        others.fold(Rational::one(), |product, (_, y)| {
            budget::step();
            product * (Rational::one() + y.abs()) * reciprocal(&(x - y).abs())
        })
    };
    Ok(nodes.iter().enumerate().map(product).max().unwrap_or_else(Rational::zero))
}
