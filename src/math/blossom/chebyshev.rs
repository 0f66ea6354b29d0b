//! The blossom in a space of functions other than polynomials.
//!
//! **Definition.** Let 1, φ_1, …, φ_n span an extended Chebyshev space: a function of it that is not 0 has at most n zeros, with
//! multiplicities. The curve Φ = (φ_1, …, φ_n) has the osculating flats Osc_k(u) = Φ(u) + span(Φ'(u), …, Φ^{(k)}(u)). For different
//! u_i that stand μ_i times among n arguments, Osc_{n−μ_1}(u_1) ∩ Osc_{n−μ_2}(u_2) ∩ … is one point φ(u_1, …, u_n), and the blossom of
//! F = c_0 + Σ c_i φ_i is c_0 + Σ c_i φ_i(u_1, …, u_n). For φ_i = t^i it is the polar form. In general it is symmetric, it has F on
//! its diagonal, and in each argument it is affine up to a change of parameter that is the same for all F.
//!
//! It is computed from derivatives of φ_i at the arguments, by linear equations: so it is rational where these are, as for the powers of
//! t with any exponents (Müntz spaces).
//!
//! H. Pottmann, "The geometry of Tchebycheffian splines", CAGD 10 (1993); M.-L. Mazure, "Blossoming: a geometrical approach", Constructive
//! Approximation 15 (1999).

use nalgebra::DMatrix;

use crate::budget;
use crate::math::linalg::{null_space, solve};
use crate::math::ring::Field;

/// An argument that stands μ times, with Φ, Φ', …, Φ^{(n−μ)} there.
#[derive(Clone, Debug, PartialEq)]
pub struct Osculation<C> {
    /// The n coordinates of each derivative, the value first.
    pub jet: Vec<Vec<C>>,
}

/// The point φ(u_1, …, u_n) of different arguments; `None` if the flats have not exactly one point in common.
///
/// Cost: a null space of size n for each argument and a linear system of size n.
///
/// # Panics
/// Unless the multiplicities n + 1 − (length of the jet) sum to n.
///
/// ```
/// use polarform::blossom::{Osculation, chebyshev_point};
/// use polarform::number::{integer as z, rational as q};
/// // Φ = (t, t³) at 1 and 2: tangents (1, 1) + x (1, 3) and (2, 8) + x (1, 12)
/// let tangent = |t: i64| Osculation { jet: vec![[t, t * t * t].map(z).to_vec(), [1, 3 * t * t].map(z).to_vec()] };
/// assert_eq!(chebyshev_point(&[tangent(1), tangent(2)]), Some(vec![q(14, 9), q(8, 3)]));
/// ```
pub fn chebyshev_point<C: Field>(arguments: &[Osculation<C>]) -> Option<Vec<C>> {
    let n = arguments.first().map_or(0, |argument| argument.jet[0].len());
    let total: usize = arguments.iter().map(|argument| n + 1 - argument.jet.len()).sum();
    assert_eq!(total, n, "as many arguments as functions");
    let mut rows: Vec<Vec<C>> = Vec::with_capacity(n);
    let mut right: Vec<C> = Vec::with_capacity(n);
    for Osculation { jet } in arguments {
        budget::step();
        // The μ vectors that are orthogonal to the directions of the flat.
        let directions = DMatrix::from_fn(jet.len() - 1, n, |i, j| jet[i + 1][j].clone());
        let normals = match jet.len() {
            1 => DMatrix::identity(n, n),
            _ => null_space(&directions),
        };
        for normal in normals.column_iter() {
            let product =
                |point: &[C]| normal.iter().zip(point).fold(C::zero(), |sum, (a, b)| sum.plus(&a.times(b)));
            right.push(product(&jet[0]));
            rows.push(normal.iter().cloned().collect());
        }
    }
    if rows.len() != n {
        return None;
    }
    let matrix = DMatrix::from_fn(n, n, |i, j| rows[i][j].clone());
    let found = solve(&matrix, &DMatrix::from_fn(n, 1, |i, _| right[i].clone())).ok()?;
    Some(found.iter().cloned().collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::blossom::PolarForm;
    use crate::math::number::{Rational, integer as z, rational as q};
    use crate::math::poly::Poly;
    use crate::math::ring::Ring;
    use proptest::prelude::*;

    /// The flats of t^{k_1}, …, t^{k_n} at some arguments.
    fn flats(exponents: &[u32], arguments: &[Rational]) -> Vec<Osculation<Rational>> {
        let n = exponents.len();
        let mut different = arguments.to_vec();
        different.sort();
        different.dedup();
        let times = |x: &Rational| arguments.iter().filter(|y| *y == x).count();
        let jet = |x: &Rational, order: usize| {
            exponents
                .iter()
                .map(|&k| (0..order).fold(Poly::variable().pow(k), |p, _| p.derivative()).value(x))
                .collect::<Vec<_>>()
        };
        different
            .iter()
            .map(|x| Osculation { jet: (0..=n - times(x)).map(|k| jet(x, k)).collect() })
            .collect()
    }

    fn arguments() -> impl Strategy<Value = Vec<Rational>> {
        prop::collection::vec((1i64..6, 1i64..4).prop_map(|(a, b)| q(a, b)), 4)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// For 1, t, …, t^n it is the polar form.
        #[test]
        fn powers_have_their_polar_forms(u in arguments(), n in 1usize..5) {
            let u = &u[..n];
            let exponents: Vec<u32> = (1..=n as u32).collect();
            let point = chebyshev_point(&flats(&exponents, u)).unwrap();
            for (i, x) in point.iter().enumerate() {
                let mut c = vec![z(0); n + 1];
                c[i + 1] = z(1);
                prop_assert_eq!(x, &PolarForm::new(c).value(u).unwrap());
            }
        }

        /// On the diagonal it is Φ, and differences in one argument have one ratio for all coordinates.
        #[test]
        fn diagonal_and_pseudoaffinity(u in arguments(), gaps in prop::collection::vec(1u32..4, 3)) {
            let exponents: Vec<u32> = gaps.iter().scan(0, |sum, gap| { *sum += gap; Some(*sum) }).collect();
            let at = |u: &[Rational]| chebyshev_point(&flats(&exponents, u)).unwrap();
            let t = u[0].clone();
            let diagonal: Vec<Rational> = exponents.iter().map(|&k| t.powered(k)).collect();
            prop_assert_eq!(at(&[t.clone(), t.clone(), t]), diagonal);
            let with = |x: Rational| at(&[u[1].clone(), u[2].clone(), x]);
            let (a, b, c) = (with(z(1)), with(z(2)), with(u[3].clone()));
            for i in 0..3 {
                for j in 0..i {
                    let minor = (&b[i] - &a[i]) * (&c[j] - &a[j]) - (&b[j] - &a[j]) * (&c[i] - &a[i]);
                    prop_assert_eq!(minor, z(0));
                }
            }
            let differs = (0..3).any(|i| b[i] != a[i]);
            prop_assert!(differs);
        }
    }

    #[test]
    fn flats_that_do_not_meet_in_a_point() {
        // t² alone at −1 and 1 with t⁴: the tangents of (t², t⁴) are the same line.
        assert_eq!(chebyshev_point(&flats(&[2, 4], &[z(-1), z(1)])), None);
    }
}
