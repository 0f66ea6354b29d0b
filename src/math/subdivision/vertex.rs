//! Subdivision of meshes around a vertex or face of any valence.

use nalgebra::DMatrix;

use super::SubdivisionError;
use crate::budget;
use crate::math::linalg::null_space;
use crate::math::number::{Int, Rational};

/// A scheme for meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VertexScheme {
    /// Catmull–Clark: bicubic splines on regular meshes of quadrilaterals.
    CatmullClark,
    /// Doo–Sabin: biquadratic splines, around a face.
    DooSabin,
    /// Loop: box splines of degree 4 on regular triangulations, with Loop's weights.
    Loop,
    /// The same with Warren's weights 3/(8n), 3/16 for n = 3, which are rational.
    Warren,
}

/// cos(2π/n) where it is rational.
fn cosine(n: usize) -> Result<Rational, SubdivisionError> {
    let value = |p: i64, q: i64| Ok(Rational::new(Int::from(p), Int::from(q)));
    match n {
        3 => value(-1, 2),
        4 => value(0, 1),
        6 => value(1, 2),
        _ => Err(SubdivisionError::Irrational { valence: n }),
    }
}

/// The matrix of one step around a vertex with n edges, or for Doo–Sabin around a face with n corners: the
/// new points in rows by the old ones in columns, in the same order.
///
/// Catmull–Clark: the vertex, its n neighbours along edges, the n opposite corners of the faces, the i-th face
/// between edges i and i + 1. Loop: the vertex and its n neighbours. Doo–Sabin: the corners.
///
/// E. Catmull, J. Clark, "Recursively generated B-spline surfaces on arbitrary topological meshes", and D. Doo,
/// M. Sabin, "Behaviour of recursive division surfaces near extraordinary points", CAD 10 (1978); C. Loop,
/// "Smooth subdivision surfaces based on triangles" (1987); J. Warren, "Subdivision methods for geometric design" (1995).
///
/// # Errors
/// [`SubdivisionError::Valence`] for n < 3, [`SubdivisionError::Irrational`] for Doo–Sabin and Loop unless
/// n is 3, 4 or 6.
///
/// ```
/// use polarform::number::rational as q;
/// use polarform::subdivision::{VertexScheme, vertex_matrix};
/// let regular = vertex_matrix(VertexScheme::CatmullClark, 4)?;
/// assert_eq!(regular[(0, 0)], q(9, 16));
/// assert_eq!(vertex_matrix(VertexScheme::Warren, 6)?[(0, 1)], q(1, 16));
/// # Ok::<(), polarform::subdivision::SubdivisionError>(())
/// ```
pub fn vertex_matrix(scheme: VertexScheme, n: usize) -> Result<DMatrix<Rational>, SubdivisionError> {
    if n < 3 {
        return Err(SubdivisionError::Valence { given: n });
    }
    let size = (2 * n as u64).saturating_add(1);
    budget::charge_terms(size.saturating_mul(size));
    match scheme {
        VertexScheme::CatmullClark => Ok(catmull_clark(n)),
        VertexScheme::DooSabin => doo_sabin(n),
        VertexScheme::Loop => {
            // β = (5/8 − (3/8 + cos(2π/n)/4)²)/n
            let inner = q(3, 8) + cosine(n)? * q(1, 4);
            Ok(triangles(n, &((q(5, 8) - &inner * &inner) / Int::from(n))))
        }
        VertexScheme::Warren => Ok(triangles(n, &if n == 3 { q(3, 16) } else { q(3, 8 * n) })),
    }
}

/// The weights of the points around a vertex in its limit, for Doo–Sabin those of the corners in the limit of the centre of the face: the
/// left eigenvector of the matrix for the eigenvalue 1 with sum 1.
///
/// Cost: a null space as large as the matrix.
///
/// # Errors
/// As [`vertex_matrix`].
///
/// ```
/// use polarform::number::rational as q;
/// use polarform::subdivision::{VertexScheme, vertex_limit};
/// let weights = vertex_limit(VertexScheme::CatmullClark, 4)?;
/// assert_eq!([&weights[0], &weights[1], &weights[5]], [&q(4, 9), &q(1, 9), &q(1, 36)]);
/// # Ok::<(), polarform::subdivision::SubdivisionError>(())
/// ```
pub fn vertex_limit(scheme: VertexScheme, n: usize) -> Result<Vec<Rational>, SubdivisionError> {
    let matrix = vertex_matrix(scheme, n)?;
    let size = matrix.nrows();
    let shifted = matrix.transpose() - DMatrix::from_fn(size, size, |i, j| q(usize::from(i == j), 1));
    let basis = null_space(&shifted);
    let sum: Rational = basis.column(0).iter().cloned().sum();
    Ok(basis.column(0).iter().map(|w| w / &sum).collect())
}

fn q(numerator: usize, denominator: usize) -> Rational {
    Rational::new(Int::from(numerator), Int::from(denominator))
}

fn catmull_clark(n: usize) -> DMatrix<Rational> {
    let (edge, face) = (|i: usize| 1 + i % n, |i: usize| 1 + n + i % n);
    let mut matrix = DMatrix::from_element(2 * n + 1, 2 * n + 1, q(0, 1));
    // 1 − 7/(4n), 3/(2n²), 1/(4n²)
    matrix[(0, 0)] = q(1, 1) - q(7, 4 * n);
    for i in 0..n {
        matrix[(0, edge(i))] = q(3, 2 * n * n);
        matrix[(0, face(i))] = q(1, 4 * n * n);
        for (place, weight) in [
            (0, q(3, 8)),
            (edge(i), q(3, 8)),
            (edge(i + 1), q(1, 16)),
            (edge(i + n - 1), q(1, 16)),
            (face(i), q(1, 16)),
            (face(i + n - 1), q(1, 16)),
        ] {
            matrix[(edge(i), place)] += weight;
        }
        for place in [0, edge(i), edge(i + 1), face(i)] {
            matrix[(face(i), place)] = q(1, 4);
        }
    }
    matrix
}

fn triangles(n: usize, beta: &Rational) -> DMatrix<Rational> {
    let edge = |i: usize| 1 + i % n;
    let mut matrix = DMatrix::from_element(n + 1, n + 1, q(0, 1));
    matrix[(0, 0)] = q(1, 1) - beta * Int::from(n);
    for i in 0..n {
        matrix[(0, edge(i))] = beta.clone();
        for (place, weight) in
            [(0, q(3, 8)), (edge(i), q(3, 8)), (edge(i + 1), q(1, 8)), (edge(i + n - 1), q(1, 8))]
        {
            matrix[(edge(i), place)] += weight;
        }
    }
    matrix
}

/// (3 + 2 cos(2πj/n))/(4n), and (n + 5)/(4n) for j = 0.
fn doo_sabin(n: usize) -> Result<DMatrix<Rational>, SubdivisionError> {
    let first = cosine(n)?;
    // cos((j+1)x) = 2 cos x cos jx − cos((j−1)x)
    let mut cosines = vec![q(1, 1), first.clone()];
    for j in 1..n {
        cosines.push(&first * &cosines[j] * q(2, 1) - &cosines[j - 1]);
    }
    let weight = |j: usize| match j {
        0 => q(n + 5, 4 * n),
        _ => (q(3, 1) + &cosines[j] * q(2, 1)) / Int::from(4 * n),
    };
    Ok(DMatrix::from_fn(n, n, |i, j| weight((j + n - i) % n)))
}
