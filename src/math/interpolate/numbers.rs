//! Interpolation of numbers at numbers: integers over one denominator, by a tree of products.
//!
//! For nodes x_j = a_j/b_j let M_j(t) = b_j t − a_j. The polynomial Σ c_j ∏_{k≠j} M_k is built from
//! halves: N = N₁ M₂ + N₂ M₁ and M = M₁ M₂ ([`Poly`] keeps them over one denominator). Cost:
//! O(M(B) log n) for a result of B bits.
//!
//! J. von zur Gathen, J. Gerhard, "Modern Computer Algebra", section 10.2.

use num_traits::One;

use super::datum::Datum;
use crate::budget;
use crate::math::number::{Int, Rational};
use crate::math::poly::Poly;
use crate::math::ring::Ring;

/// The same numbers, if all are.
pub(super) fn numbers<C: Ring>(list: &[C]) -> Option<Vec<Rational>> {
    list.iter().map(Ring::as_rational).collect()
}

/// w_j = 1/∏_{k≠j} (x_j − x_k) for distinct nodes. Cost: n² products of an integer by a short one.
pub(super) fn weights(nodes: &[Rational]) -> Vec<Rational> {
    let denominators: Int = nodes.iter().map(|x| x.denom().clone()).product();
    let weight = |(j, x): (usize, &Rational)| {
        // ∏ (x_j − x_k) = ∏ (a_j b_k − a_k b_j) / ∏ b_j b_k
        let mut product = Int::ONE;
        for (_, y) in nodes.iter().enumerate().filter(|(k, _)| *k != j) {
            budget::step();
            product *= x.numer() * y.denom() - y.numer() * x.denom();
        }
        let exponent = u32::try_from(nodes.len()).unwrap_or(u32::MAX).saturating_sub(2);
        let scale = if nodes.len() == 1 { Int::ONE } else { &denominators * x.denom().pow(exponent) };
        Rational::new(scale, product)
    };
    nodes.iter().enumerate().map(weight).collect()
}

/// The power coefficients of Σ y_j w_j ∏_{k≠j} (t − x_k), lowest first, as many as nodes.
pub(super) fn combination<C: Ring, V: Datum<C>>(
    nodes: &[Rational],
    weights: &[Rational],
    values: &[V],
) -> Option<Vec<V>> {
    let dimension = values.first()?.dimension();
    budget::charge_terms((nodes.len() as u64).saturating_mul(dimension as u64));
    let denominators: Int = nodes.iter().map(|x| x.denom().clone()).product();
    let scale = Rational::new(Int::ONE, denominators);
    let linear: Vec<Poly> =
        nodes.iter().map(|x| Poly::from_integers(vec![-x.numer(), x.denom().clone()], Int::ONE)).collect();
    let coordinate = |k: usize| -> Option<Vec<Rational>> {
        let leaf = |((y, w), x): ((&V, &Rational), &Rational)| {
            Some(Poly::constant(y.coordinates()[k].as_rational()? * w * x.denom()))
        };
        let leaves: Vec<Poly> = values.iter().zip(weights).zip(nodes).map(leaf).collect::<Option<_>>()?;
        let sum = tree(&leaves, &linear).0.scale(&scale);
        Some((0..nodes.len()).map(|i| sum.coefficient(i)).collect())
    };
    let columns: Vec<Vec<Rational>> = (0..dimension).map(coordinate).collect::<Option<_>>()?;
    let point = |i: usize| V::from_coordinates(columns.iter().map(|c| C::from_rational(&c[i])).collect());
    Some((0..nodes.len()).map(point).collect())
}

/// Σ c_j ∏_{k≠j} M_k and ∏ M_k.
fn tree(leaves: &[Poly], linear: &[Poly]) -> (Poly, Poly) {
    budget::steps(leaves.len() as u32);
    if let ([leaf], [factor]) = (leaves, linear) {
        return (leaf.clone(), factor.clone());
    }
    let half = leaves.len() / 2;
    let (left, left_product) = tree(&leaves[..half], &linear[..half]);
    let (right, right_product) = tree(&leaves[half..], &linear[half..]);
    (&left * &right_product + &right * &left_product, &left_product * &right_product)
}

/// w_j ∏_{k≠j} (t − x_k) for each j, as lists of as many power coefficients as nodes.
pub(super) fn basis(nodes: &[Rational], weights: &[Rational]) -> Vec<Vec<Rational>> {
    let linear = |x: &Rational| Poly::from_integers(vec![-x.numer(), x.denom().clone()], Int::ONE);
    let product = nodes.iter().fold(Poly::one(), |product, x| &product * &linear(x));
    let denominators: Int = nodes.iter().map(|x| x.denom().clone()).product();
    let polynomial = |(x, w): (&Rational, &Rational)| {
        let quotient = product.div_exact(&linear(x)).unwrap_or_default();
        let scaled = quotient.scale(&(w * Rational::new(x.denom().clone(), denominators.clone())));
        (0..nodes.len()).map(|i| scaled.coefficient(i)).collect()
    };
    nodes.iter().zip(weights).map(polynomial).collect()
}

/// The power coefficients of Σ c_k (t − x_0) ⋯ (t − x_{k−1}), as many as there are c_k.
pub(super) fn from_newton<C: Ring, V: Datum<C>>(nodes: &[Rational], coefficients: &[V]) -> Option<Vec<V>> {
    let dimension = coefficients.first()?.dimension();
    let linear: Vec<Poly> =
        nodes.iter().map(|x| Poly::from_coefficients(vec![-x, Rational::one()])).collect();
    let coordinate = |k: usize| -> Option<Poly> {
        let column: Vec<C> = coefficients.iter().map(|c| c.coordinates()[k].clone()).collect();
        Some(newton_tree(&numbers(&column)?, &linear).0)
    };
    let columns: Vec<Poly> = (0..dimension).map(coordinate).collect::<Option<_>>()?;
    let point =
        |i: usize| V::from_coordinates(columns.iter().map(|c| C::from_rational(&c.coefficient(i))).collect());
    Some((0..coefficients.len()).map(point).collect())
}

/// Newton's sum, and the product of as many factors as it has coefficients (of all there are).
fn newton_tree(coefficients: &[Rational], linear: &[Poly]) -> (Poly, Poly) {
    budget::steps(coefficients.len() as u32);
    if let [c] = coefficients {
        return (Poly::constant(c.clone()), linear.first().cloned().unwrap_or_else(Poly::one));
    }
    let half = coefficients.len() / 2;
    let (low, product) = newton_tree(&coefficients[..half], &linear[..half]);
    let (high, rest) = newton_tree(&coefficients[half..], &linear[half..]);
    (low + &product * &high, &product * &rest)
}
