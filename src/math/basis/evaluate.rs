//! Values of all basis functions at a point.

use super::bernstein::{bernstein_all, powers};
use super::{Basis, BasisError, legendre_all};
use crate::budget;
use crate::math::number::{Int, Rational};
use crate::math::ring::Field;

/// φ_0(t), …, φ_n(t).
///
/// Each from the formula that defines it (see [`Basis`]); for Hermite data at two ends from
/// the two-point Taylor formula: with u = (t−a)/(b−a) and n + 1 = 2m, the function dual to
/// f^{(k)}(a) is (t−a)^k/k! (1−u)^m Σ_{l<m−k} C(m−1+l, l) u^l (P. J. Davis, *Interpolation and
/// Approximation*, 1975, section 2.5). Cost: O(n) products, O(n²) for Lagrange and Hermite.
///
/// # Errors
/// [`BasisError`] as by [`Basis::validate`].
///
/// ```
/// use polarform::basis::{Basis, evaluate_basis};
/// use polarform::number::integer as z;
/// let basis = Basis::Newton(vec![z(0), z(1), z(2)]);
/// assert_eq!(evaluate_basis(2, &basis, &z(5)), Ok(vec![z(1), z(5), z(20)]));
/// ```
pub fn evaluate_basis<F: Field>(n: usize, basis: &Basis<F>, t: &F) -> Result<Vec<F>, BasisError> {
    basis.validate(n)?;
    budget::charge_terms(n as u64);
    Ok(match basis {
        Basis::Power => powers(n, t),
        Basis::Taylor { at } => powers(n, &t.minus(at)),
        Basis::Bernstein(interval) => bernstein_all(n, &interval.local(t)),
        Basis::Legendre(interval) => {
            let (a, b) = interval.ends();
            let x = t.plus(t).minus(a).minus(b).times(interval.inverse_width());
            legendre_all(n, &x)
        }
        Basis::Newton(nodes) => {
            let mut values = vec![F::one()];
            for (k, node) in nodes.iter().take(n).enumerate() {
                budget::step();
                values.push(values[k].times(&t.minus(node)));
            }
            values
        }
        Basis::Lagrange(nodes) => lagrange(nodes, t),
        Basis::HermiteEndpoints(interval) => {
            let (a, b) = interval.ends();
            let m = n.div_ceil(2);
            let mut values = hermite_half(m, a, b, t);
            values.extend(hermite_half(m, b, a, t));
            values
        }
    })
}

/// ∏_{k≠j} (t − x_k)/(x_j − x_k) for each j.
fn lagrange<F: Field>(nodes: &[F], t: &F) -> Vec<F> {
    let mut values: Vec<F> = Vec::with_capacity(nodes.len());
    let mut left = F::one();
    for node in nodes {
        values.push(left.clone());
        left *= t.minus(node);
    }
    let mut right = F::one();
    for (j, value) in values.iter_mut().enumerate().rev() {
        let mut denominator = F::one();
        for (k, node) in nodes.iter().enumerate() {
            budget::step();
            if k != j {
                denominator *= nodes[j].minus(node);
            }
        }
        *value *= right.times(&reciprocal(&denominator));
        right *= t.minus(&nodes[j]);
    }
    values
}

/// The functions dual to f(a), f'(a), …, f^{(m−1)}(a), at t.
fn hermite_half<F: Field>(m: usize, a: &F, b: &F, t: &F) -> Vec<F> {
    let s = t.minus(a);
    let u = s.times(&reciprocal(&b.minus(a)));
    let decay = num_traits::pow(F::one().minus(&u), m);
    // partial[l] = Σ_{i≤l} C(m−1+i, i) u^i
    let mut partial = Vec::with_capacity(m);
    let mut sum = F::zero();
    let mut weight = Int::ONE;
    for (l, power) in powers(m - 1, &u).iter().enumerate() {
        sum += power.scaled(&Rational::from_integer(weight.clone()));
        partial.push(sum.clone());
        weight = (weight * Int::from(m + l)).div_exact(&Int::from(l + 1));
    }
    let mut front = decay;
    let mut values = Vec::with_capacity(m);
    for k in 0..m {
        budget::step();
        values.push(front.times(&partial[m - 1 - k]));
        front = front.times(&s).scaled(&Rational::new(Int::ONE, Int::from(k + 1)));
    }
    values
}

/// 1/x where x is a product of differences that [`Basis::validate`] found not to be 0.
pub(super) fn reciprocal<F: Field>(x: &F) -> F {
    x.inverse().expect("differences of distinct nodes are not zero, and a field has no zero divisors")
}
