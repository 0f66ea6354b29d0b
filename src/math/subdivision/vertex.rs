//! Subdivision of meshes around a vertex or face of any valence.

use nalgebra::DMatrix;

use super::SubdivisionError;
use crate::budget;
use crate::math::linalg::solve;
use crate::math::number::{Int, Rational};
use crate::math::poly::{Poly, RealRoot};
use crate::math::system::image;

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

/// c = cos(2π/n), of which the weights of Loop and of Doo and Sabin are polynomials.
#[derive(Clone, Debug, PartialEq)]
pub struct Cosine {
    /// The irreducible polynomial of which c is a root, x − c if c is rational.
    pub equation: Poly,
    /// c
    pub value: RealRoot,
}

impl Cosine {
    /// The cosine for a valence n ≥ 3: the largest root but 1 of T_n − 1, with Chebyshev's polynomial T_n(cos x) = cos n x.
    ///
    /// Cost: the factors of a polynomial of degree n.
    ///
    /// ```
    /// use polarform::subdivision::Cosine;
    /// assert_eq!(Cosine::new(6).value.to_string(), "1/2");
    /// assert_eq!(Cosine::new(5).value.to_string(), "4 t^2 + 2 t - 1 in (1/4, 1/2)");
    /// ```
    pub fn new(n: usize) -> Self {
        let others = frequencies(n);
        let roots = others.real_roots(None, None).unwrap_or_default();
        let (value, _) = roots.into_iter().next_back().expect("n is 3 or more");
        let factors = others.factors().factors.into_iter().map(|(factor, _)| factor);
        let equation = factors.into_iter().find(|factor| value.sign_of(factor).is_eq());
        Cosine { equation: equation.expect("the value is a root"), value }
    }

    /// The remainder of a polynomial in c.
    pub(super) fn reduced(&self, f: &Poly) -> Poly {
        f.div_rem(&self.equation).map_or_else(|| f.clone(), |(_, rest)| rest)
    }

    /// 1/f(c) as a polynomial, where f(c) ≠ 0.
    fn inverse(&self, f: &Poly) -> Poly {
        let size = self.equation.degree().unwrap_or(0);
        let images: Vec<Poly> =
            (0..size).map(|k| self.reduced(&(f * &Poly::variable().pow(k as u32)))).collect();
        let matrix = DMatrix::from_fn(size, size, |i, k| images[k].coefficient(i));
        let one = DMatrix::from_fn(size, 1, |i, _| q(usize::from(i == 0), 1));
        let found = solve(&matrix, &one).expect("an element of a field that is not 0");
        found.iter().cloned().collect()
    }
}

/// (T_n(x) − 1)/(x − 1), up to a factor the product of all x − cos(2πk/n) with 0 < k < n.
fn frequencies(n: usize) -> Poly {
    let x = Poly::variable();
    let mut pair = [Poly::one(), x.clone()];
    for _ in 1..n {
        budget::step();
        let next = (&x * &pair[1]).scale(&q(2, 1)) - pair[0].clone();
        pair = [pair[1].clone(), next];
    }
    let [_, last] = pair;
    (last - Poly::one()).div_exact(&(x - Poly::one())).expect("T_n(1) = 1")
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
/// The entries are polynomials in cos(2π/n), see [`Cosine`], of the least degree: numbers where that is rational, and for Catmull and
/// Clark's and Warren's weights.
///
/// # Errors
/// [`SubdivisionError::Valence`] for n < 3.
///
/// ```
/// use polarform::number::rational as q;
/// use polarform::poly::Poly;
/// use polarform::subdivision::{VertexScheme, vertex_matrix};
/// let regular = vertex_matrix(VertexScheme::CatmullClark, 4)?;
/// assert_eq!(regular[(0, 0)], Poly::constant(q(9, 16)));
/// let five = vertex_matrix(VertexScheme::DooSabin, 5)?;
/// assert_eq!(five[(0, 1)], Poly::from_coefficients(vec![q(3, 20), q(1, 10)]));
/// # Ok::<(), polarform::subdivision::SubdivisionError>(())
/// ```
pub fn vertex_matrix(scheme: VertexScheme, n: usize) -> Result<DMatrix<Poly>, SubdivisionError> {
    checked(n)?;
    let lifted = |matrix: DMatrix<Rational>| matrix.map(Poly::constant);
    match scheme {
        VertexScheme::CatmullClark => Ok(lifted(catmull_clark(n))),
        VertexScheme::DooSabin => Ok(doo_sabin(n)),
        VertexScheme::Loop => Ok(triangles(n, &beta(&Cosine::new(n), n))),
        VertexScheme::Warren => Ok(triangles(n, &Poly::constant(warren(n)))),
    }
}

/// The weights of the points around a vertex in its limit, for Doo–Sabin those of the corners in the limit of the centre of the face: the
/// left eigenvector of the matrix for the eigenvalue 1 with sum 1. As the entries of the matrix they are polynomials in cos(2π/n).
///
/// Triangles: 1/(3/(8β) + n) for each neighbour. Catmull–Clark: n/(n + 5), 4/(n (n + 5)), 1/(n (n + 5)). Doo–Sabin: 1/n.
///
/// # Errors
/// As [`vertex_matrix`].
///
/// ```
/// use polarform::number::rational as q;
/// use polarform::poly::Poly;
/// use polarform::subdivision::{VertexScheme, vertex_limit};
/// let weights = vertex_limit(VertexScheme::CatmullClark, 4)?;
/// assert_eq!(weights[5], Poly::constant(q(1, 36)));
/// # Ok::<(), polarform::subdivision::SubdivisionError>(())
/// ```
pub fn vertex_limit(scheme: VertexScheme, n: usize) -> Result<Vec<Poly>, SubdivisionError> {
    checked(n)?;
    let around = |centre: Poly, lists: &[Poly]| -> Vec<Poly> {
        std::iter::once(centre).chain(lists.iter().flat_map(|w| std::iter::repeat_n(w.clone(), n))).collect()
    };
    let number = |numerator: usize, denominator: usize| Poly::constant(q(numerator, denominator));
    let triangles = |weight: Poly| around(Poly::one() - weight.scale(&q(n, 1)), &[weight]);
    Ok(match scheme {
        VertexScheme::CatmullClark => {
            around(number(n, n + 5), &[number(4, n * (n + 5)), number(1, n * (n + 5))])
        }
        VertexScheme::DooSabin => vec![number(1, n); n],
        VertexScheme::Warren => {
            let beta = warren(n);
            triangles(Poly::constant((q(3, 8) / beta + q(n, 1)).recip()))
        }
        VertexScheme::Loop => {
            let cosine = Cosine::new(n);
            let beta = beta(&cosine, n);
            // 8β/(3 + 8nβ)
            let below = Poly::constant(q(3, 1)) + beta.scale(&q(8 * n, 1));
            triangles(cosine.reduced(&(cosine.inverse(&below) * beta.scale(&q(8, 1)))))
        }
    })
}

/// All eigenvalues of the matrix with their multiplicities, the largest first; they are real.
///
/// By the discrete Fourier transform they belong to frequencies k = 0, …, n − 1 with c_k = cos(2πk/n). Triangles: 1 and 5/8 − nβ for
/// k = 0, then 3/8 + c_k/4. Catmull–Clark: those of a matrix of size 3 for k = 0, then the roots of λ² − (5 + c_k)/8 λ + 1/16.
/// Doo–Sabin: 1, 1/2 twice, and 1/4.
///
/// J. Peters, U. Reif, *Subdivision Surfaces* (2008).
///
/// Cost: the real roots of a polynomial of degree 2n − 2 at most.
///
/// # Errors
/// As [`vertex_matrix`].
///
/// ```
/// use polarform::subdivision::{VertexScheme, vertex_eigenvalues};
/// let found = vertex_eigenvalues(VertexScheme::Loop, 5)?;
/// let shown: Vec<String> = found.iter().map(|(x, m)| format!("{x} ({m})")).collect();
/// assert_eq!(shown[0], "1 (1)");
/// assert_eq!(shown[1], "64 t^2 - 40 t + 5 in (1/4, 1/2) (2)");
/// # Ok::<(), polarform::subdivision::SubdivisionError>(())
/// ```
pub fn vertex_eigenvalues(
    scheme: VertexScheme,
    n: usize,
) -> Result<Vec<(RealRoot, usize)>, SubdivisionError> {
    checked(n)?;
    let number = |q: Rational| RealRoot::Rational(q);
    let roots = |f: &Poly| f.real_roots(None, None).unwrap_or_default();
    let x = Poly::variable();
    let mut found = vec![(number(q(1, 1)), 1)];
    // c_k = 4 λ − 3/2
    let of_triangles = || roots(&frequencies(n).compose(&Poly::from_coefficients(vec![-q(3, 2), q(4, 1)])));
    match scheme {
        VertexScheme::DooSabin => {
            found.push((number(q(1, 2)), 2));
            found.extend((n > 3).then(|| (number(q(1, 4)), n - 3)));
        }
        VertexScheme::Warren => {
            found.push((number(q(5, 8) - warren(n) * Int::from(n)), 1));
            found.extend(of_triangles());
        }
        VertexScheme::Loop => {
            let cosine = Cosine::new(n);
            let second = Poly::constant(q(5, 8)) - beta(&cosine, n).scale(&q(n, 1));
            found.push((image(&cosine.value, &second, &Poly::one()), 1));
            found.extend(of_triangles());
        }
        VertexScheme::CatmullClark => {
            // Of [1 − 7/(4n), 3/(2n), 1/(4n); 3/8, 1/2, 1/8; 1/4, 1/2, 1/4] without λ − 1: trace − 1 and determinant.
            let trace = q(3, 4) - q(7, 4 * n);
            let determinant = q(1, 16) - q(3, 16 * n);
            let quadratic = Poly::from_coefficients(vec![determinant, -trace, q(1, 1)]);
            found.extend(roots(&quadratic));
            // λ c_k = 8 λ² − 5 λ + 1/2
            let above = Poly::from_coefficients(vec![q(1, 2), -q(5, 1), q(8, 1)]);
            let list = frequencies(n).coefficients();
            let top = list.len() - 1;
            let sum = list.iter().enumerate().fold(Poly::zero(), |sum, (k, c)| {
                sum + (above.pow(k as u32) * x.pow((top - k) as u32)).scale(c)
            });
            found.extend(roots(&sum));
        }
    }
    found.sort_by(|a, b| b.0.cmp(&a.0));
    found.dedup_by(|later, first| {
        let same = later.0 == first.0;
        first.1 += if same { later.1 } else { 0 };
        same
    });
    Ok(found)
}

fn checked(n: usize) -> Result<(), SubdivisionError> {
    if n < 3 {
        return Err(SubdivisionError::Valence { given: n });
    }
    let size = (2 * n as u64).saturating_add(1);
    budget::charge_terms(size.saturating_mul(size));
    Ok(())
}

/// β = (5/8 − (3/8 + cos(2π/n)/4)²)/n
fn beta(cosine: &Cosine, n: usize) -> Poly {
    let inner = Poly::from_coefficients(vec![q(3, 8), q(1, 4)]);
    cosine.reduced(&(Poly::constant(q(5, 8)) - inner.pow(2)).scale(&q(1, n)))
}

fn warren(n: usize) -> Rational {
    if n == 3 { q(3, 16) } else { q(3, 8 * n) }
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

fn triangles(n: usize, beta: &Poly) -> DMatrix<Poly> {
    let edge = |i: usize| 1 + i % n;
    let number = |p: usize, r: usize| Poly::constant(q(p, r));
    let mut matrix = DMatrix::from_element(n + 1, n + 1, Poly::zero());
    matrix[(0, 0)] = Poly::one() - beta.scale(&q(n, 1));
    for i in 0..n {
        matrix[(0, edge(i))] = beta.clone();
        for (place, weight) in [
            (0, number(3, 8)),
            (edge(i), number(3, 8)),
            (edge(i + 1), number(1, 8)),
            (edge(i + n - 1), number(1, 8)),
        ] {
            matrix[(edge(i), place)] += weight;
        }
    }
    matrix
}

/// (3 + 2 cos(2πj/n))/(4n), and (n + 5)/(4n) for j = 0.
fn doo_sabin(n: usize) -> DMatrix<Poly> {
    let cosine = Cosine::new(n);
    // cos((j+1)x) = 2 cos x cos jx − cos((j−1)x)
    let first = cosine.reduced(&Poly::variable());
    let mut cosines = vec![Poly::one(), first.clone()];
    for j in 1..n {
        cosines.push(cosine.reduced(&((&first * &cosines[j]).scale(&q(2, 1)) - cosines[j - 1].clone())));
    }
    let weights: Vec<Poly> = (0..n)
        .map(|j| match j {
            0 => Poly::constant(q(n + 5, 4 * n)),
            _ => (Poly::constant(q(3, 1)) + cosines[j].scale(&q(2, 1))).scale(&q(1, 4 * n)),
        })
        .collect();
    DMatrix::from_fn(n, n, |i, j| weights[(j + n - i) % n].clone())
}
