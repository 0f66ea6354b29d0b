//! Tangents of limit surfaces at vertices.
//!
//! Left eigenvectors of the matrix of a step for its second largest eigenvalue λ, which is double, are weights of two tangent vectors. By
//! the discrete Fourier transform they belong to the frequency 1: with θ_i = 2πi/n and c = cos(2π/n) the weights are cos θ_i for the
//! neighbours of Loop and Warren and for the corners of Doo and Sabin. Those of Catmull and Clark are A cos θ_i for neighbours and
//! cos θ_i + cos θ_{i+1} for opposite corners, where λ A = A (3 + c)/8 + (1 + c)/2 and λ = A/16 + 1/4; so A = 16 λ − 4 and
//! λ² − (5 + c) λ/8 + 1/16 = 0. The second vector has them moved by one edge, so that no sines are needed.
//!
//! M. Halstead, M. Kass, T. DeRose, "Efficient, fair interpolation using Catmull–Clark surfaces", SIGGRAPH 1993; J. Peters, U. Reif,
//! "Subdivision Surfaces" (2008).

use super::{Cosine, SubdivisionError, VertexScheme, vertex_eigenvalues};
use crate::budget;
use crate::math::number::{integer, rational};
use crate::math::poly::{Poly, RealRoot};

/// A weight p(c) + q(c) λ.
pub type Weight = [Poly; 2];

/// The weights of two tangent vectors at the limit of a vertex, in the order of the rows of the matrix of a step, as p(c) + q(c) λ with c = cos(2π/n), and
/// λ; they span the tangent plane where the limit is regular. If λ is rational no weight contains it.
///
/// Cost: n polynomials of the degree of c.
///
/// # Errors
/// [`SubdivisionError::Valence`] for n < 3.
///
/// ```
/// use polarform::poly::Poly;
/// use polarform::subdivision::{VertexScheme, vertex_tangents};
/// let (rows, lambda) = vertex_tangents(VertexScheme::CatmullClark, 4)?;
/// assert_eq!(lambda.to_string(), "1/2");
/// // On a regular mesh: 4 (e_0 − e_2) + f_0 − f_1 − f_2 + f_3.
/// let shown: Vec<String> = rows[0].iter().map(|w| w[0].to_string()).collect();
/// assert_eq!(shown, ["0", "4", "0", "-4", "0", "1", "-1", "-1", "1"]);
/// # Ok::<(), polarform::subdivision::SubdivisionError>(())
/// ```
pub fn vertex_tangents(
    scheme: VertexScheme,
    n: usize,
) -> Result<([Vec<Weight>; 2], RealRoot), SubdivisionError> {
    let eigenvalues = vertex_eigenvalues(scheme, n)?;
    let cosine = Cosine::new(n);
    budget::charge_terms(n as u64);
    // cos(kθ) = T_k(c)
    let mut cosines = vec![Poly::one(), cosine.reduced(&Poly::variable())];
    for k in 2..=n {
        let next = (Poly::variable() * &cosines[k - 1]).scale(&integer(2)) - &cosines[k - 2];
        cosines.push(cosine.reduced(&next));
    }
    // λ of the frequency 1
    let c = Poly::variable();
    let lambda = match scheme {
        VertexScheme::CatmullClark => of_catmull_clark(&eigenvalues, n),
        VertexScheme::DooSabin => RealRoot::Rational(rational(1, 2)),
        VertexScheme::Loop | VertexScheme::Warren => {
            let value = c.scale(&rational(1, 4)) + Poly::constant(rational(3, 8));
            crate::math::system::image(&cosine.value, &value, &Poly::one())
        }
    };
    let plain = |p: Poly| [p, Poly::zero()];
    let at = |i: usize| cosines[i % n].clone();
    let row = |turned: usize| -> Vec<Weight> {
        let place = |i: usize| i + n - turned;
        let zero = || plain(Poly::zero());
        match scheme {
            VertexScheme::DooSabin => (0..n).map(|i| plain(at(place(i)))).collect(),
            VertexScheme::Loop | VertexScheme::Warren => {
                std::iter::once(zero()).chain((0..n).map(|i| plain(at(place(i))))).collect()
            }
            VertexScheme::CatmullClark => {
                let neighbour = |i: usize| {
                    let own = at(place(i));
                    match &lambda {
                        RealRoot::Rational(q) => plain(own.scale(&(q * integer(16) - integer(4)))),
                        RealRoot::Irrational(_) => [own.scale(&integer(-4)), own.scale(&integer(16))],
                    }
                };
                let corner = |i: usize| plain(at(place(i)) + at(place(i) + 1));
                std::iter::once(zero()).chain((0..n).map(neighbour)).chain((0..n).map(corner)).collect()
            }
        }
    };
    Ok(([row(0), row(1)], lambda))
}

/// The larger root of λ² − (5 + c) λ/8 + 1/16: the second largest eigenvalue, or the third where the first frequency comes after another one.
fn of_catmull_clark(eigenvalues: &[(RealRoot, usize)], n: usize) -> RealRoot {
    let c = Cosine::new(n).value;
    let belongs = |lambda: &RealRoot| match lambda {
        // c = 8 λ + 1/(2 λ) − 5
        RealRoot::Rational(q) => {
            let value = q * integer(8) + (q * integer(2)).recip() - integer(5);
            RealRoot::Rational(value) == c
        }
        RealRoot::Irrational(_) => {
            let above = Poly::from_coefficients(vec![rational(1, 2), integer(-5), integer(8)]);
            crate::math::system::image(lambda, &above, &Poly::variable()) == c
        }
    };
    let mut found = eigenvalues.iter().skip(1).map(|(lambda, _)| lambda).filter(|lambda| belongs(lambda));
    found.next().cloned().unwrap_or_else(|| eigenvalues[1].0.clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::subdivision::vertex_matrix;

    /// p + q λ times λ, by λ² = s λ − 1/16 with s = (5 + c)/8, or λ = 1/2 and so on.
    #[test]
    fn rows_are_left_eigenvectors() {
        for scheme in
            [VertexScheme::CatmullClark, VertexScheme::DooSabin, VertexScheme::Loop, VertexScheme::Warren]
        {
            for n in 3..10 {
                let cosine = Cosine::new(n);
                let (rows, lambda) = vertex_tangents(scheme, n).unwrap();
                let matrix = vertex_matrix(scheme, n).unwrap();
                let c = Poly::variable();
                let times_lambda = |w: &Weight| -> Weight {
                    let by = |p: Poly| [cosine.reduced(&(&w[0] * &p)), cosine.reduced(&(&w[1] * &p))];
                    match (&lambda, scheme) {
                        (RealRoot::Rational(q), _) => by(Poly::constant(q.clone())),
                        (_, VertexScheme::CatmullClark) => {
                            let s = (&c + Poly::from(5)).scale(&rational(1, 8));
                            let rest = w[1].scale(&rational(-1, 16));
                            [rest, cosine.reduced(&(&w[0] + &w[1] * s))]
                        }
                        _ => by(c.scale(&rational(1, 4)) + Poly::constant(rational(3, 8))),
                    }
                };
                for row in &rows {
                    for j in 0..matrix.ncols() {
                        let sum = |k: usize| {
                            let terms = row.iter().enumerate().map(|(i, w)| &w[k] * &matrix[(i, j)]);
                            cosine.reduced(&terms.sum::<Poly>())
                        };
                        assert_eq!([sum(0), sum(1)], times_lambda(&row[j]), "{scheme:?} {n} {j}");
                    }
                }
                assert_ne!(rows[0], rows[1]);
            }
        }
        assert!(vertex_tangents(VertexScheme::Loop, 2).is_err());
    }
}
