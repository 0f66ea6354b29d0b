//! Lagrange's form of the interpolating polynomial, in barycentric notation.
//!
//! **Definition.** For distinct nodes x_0, …, x_n let ω(t) = ∏ (t − x_k) and
//! w_j = 1/∏_{k≠j} (x_j − x_k) = 1/ω'(x_j). The basis is L_j(t) = w_j ∏_{k≠j} (t − x_k), and
//!
//! p(t) = Σ y_j L_j(t) = ω(t) Σ w_j y_j/(t − x_j) = (Σ w_j y_j/(t − x_j)) / (Σ w_j/(t − x_j)).
//!
//! Reference: J.-P. Berrut, L. N. Trefethen, "Barycentric Lagrange interpolation", SIAM Review
//! 46 (2004).

use super::InterpolationError;
use super::datum::{Datum, check, combination, distinct, divided, enough, reciprocal};
use super::numbers::{self, numbers};
use crate::budget;
use crate::math::poly::Coefficients;
use crate::math::ring::{Field, Ring};

/// Values at distinct nodes with their barycentric weights.
///
/// ```
/// use polarform::interpolate::LagrangeForm;
/// use polarform::number::{integer as z, rational as q};
/// let form = LagrangeForm::new(&[0, 1, 2].map(z), &[0, 1, 4].map(z))?;
/// assert_eq!(form.weights(), [q(1, 2), z(-1), q(1, 2)]);
/// assert_eq!(form.value(&z(5)), z(25));
/// // points of the plane: a parabola through three of them
/// let points = [vec![z(0), z(0)], vec![z(1), z(2)], vec![z(2), z(0)]];
/// let curve = LagrangeForm::new(&[0, 1, 2].map(z), &points)?;
/// assert_eq!(curve.value(&q(1, 2)), [q(1, 2), q(3, 2)]);
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LagrangeForm<C, V = C> {
    nodes: Vec<C>,
    weights: Vec<C>,
    values: Vec<V>,
}

impl<C: Field, V: Datum<C>> LagrangeForm<C, V> {
    /// The form for these nodes and values. Cost: n² products, n quotients.
    ///
    /// # Errors
    /// [`InterpolationError`] when there are no nodes, two are equal, or the values do not fit.
    pub fn new(nodes: &[C], values: &[V]) -> Result<Self, InterpolationError> {
        check(nodes, values)?;
        Ok(LagrangeForm { nodes: nodes.to_vec(), weights: weights_of(nodes), values: values.to_vec() })
    }

    /// w_0, …, w_n
    pub fn weights(&self) -> &[C] {
        &self.weights
    }

    /// L_0(t), …, L_n(t); their sum is 1. Cost: 4n products, no quotient.
    pub fn basis_values(&self, t: &C) -> Vec<C> {
        let mut values = self.weights.clone();
        let mut product = C::one();
        for (x, value) in self.nodes.iter().zip(&mut values) {
            *value *= product.clone();
            product *= t.minus(x);
        }
        product = C::one();
        for (x, value) in self.nodes.iter().zip(&mut values).rev() {
            *value *= product.clone();
            product *= t.minus(x);
        }
        values
    }

    /// p(t) = Σ y_j L_j(t). Cost: 5n products.
    pub fn value(&self, t: &C) -> V {
        combination(self.basis_values(t).iter().zip(&self.values)).expect("there is at least one node")
    }

    /// The power coefficients of L_0, …, L_n, each a list of n + 1, lowest first. Cost: 2n²
    /// products, for numbers of integers.
    pub fn basis_polynomials(&self) -> Vec<Vec<C>> {
        budget::charge_terms((self.nodes.len() as u64).saturating_mul(self.nodes.len() as u64));
        if let (Some(nodes), Some(weights)) = (numbers(&self.nodes), numbers(&self.weights)) {
            let lists = numbers::basis(&nodes, &weights);
            return lists.iter().map(|list| list.iter().map(C::from_rational).collect()).collect();
        }
        let product = nodal_polynomial(&self.nodes);
        let polynomial = |(x, w): (&C, &C)| {
            let quotient = divided(&product, x).map_or_else(Vec::new, |(quotient, _)| quotient);
            quotient.iter().map(|c| c.times(w)).collect()
        };
        self.nodes.iter().zip(&self.weights).map(polynomial).collect()
    }

    /// The n + 1 power coefficients of p, lowest first; leading ones may be zero. Cost: 3n²
    /// products; for numbers O(M(B) log n) for B bits in all, M the cost of a product.
    pub fn to_power(&self) -> Vec<V> {
        if let (Some(nodes), Some(weights)) = (numbers(&self.nodes), numbers(&self.weights))
            && let Some(power) = numbers::combination(&nodes, &weights, &self.values)
        {
            return power;
        }
        self.to_power_by_basis()
    }

    /// The same for coefficients in any field.
    pub(super) fn to_power_by_basis(&self) -> Vec<V> {
        let basis = self.basis_polynomials();
        let coefficient = |i: usize| {
            combination(basis.iter().map(|p| &p[i]).zip(&self.values)).expect("there is at least one node")
        };
        (0..self.nodes.len()).map(coefficient).collect()
    }
}

/// The power coefficients, lowest first, of the polynomial of degree at most n through n + 1
/// points: values (or points of any dimension) at distinct nodes.
///
/// ```
/// use polarform::interpolate::polynomial_through;
/// use polarform::number::integer as z;
/// assert_eq!(polynomial_through(&[-1, 0, 1].map(z), &[2, 0, 2].map(z)), Ok(vec![z(0), z(0), z(2)]));
/// ```
///
/// # Errors
/// As [`LagrangeForm::new`].
pub fn polynomial_through<C: Field, V: Datum<C>>(
    nodes: &[C],
    values: &[V],
) -> Result<Vec<V>, InterpolationError> {
    LagrangeForm::new(nodes, values).map(|form| form.to_power())
}

/// The barycentric weights w_j = 1/∏_{k≠j} (x_j − x_k). Cost: n² products, n quotients.
///
/// ```
/// use polarform::interpolate::barycentric_weights;
/// use polarform::number::{integer as z, rational as q};
/// // equidistant nodes: (−1)^{n−j} C(n,j) / n!
/// let weights = barycentric_weights(&[0, 1, 2, 3].map(z))?;
/// assert_eq!(weights, [q(-1, 6), q(1, 2), q(-1, 2), q(1, 6)]);
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
///
/// # Errors
/// [`InterpolationError`] when there are no nodes, or two are equal.
pub fn barycentric_weights<C: Field>(nodes: &[C]) -> Result<Vec<C>, InterpolationError> {
    enough(nodes.len(), 1)?;
    distinct(nodes)?;
    Ok(weights_of(nodes))
}

fn weights_of<C: Field>(nodes: &[C]) -> Vec<C> {
    match numbers(nodes) {
        Some(nodes) => numbers::weights(&nodes).iter().map(C::from_rational).collect(),
        None => weights_by_differences(nodes),
    }
}

pub(super) fn weights_by_differences<C: Field>(nodes: &[C]) -> Vec<C> {
    let weight = |(j, x): (usize, &C)| {
        let mut product = C::one();
        for (k, other) in nodes.iter().enumerate() {
            budget::step();
            if k != j {
                product *= x.minus(other);
            }
        }
        reciprocal(&product)
    };
    nodes.iter().enumerate().map(weight).collect()
}

/// The power coefficients of ω(t) = ∏ (t − x_k), lowest first; \[1\] for no nodes. Cost: n²/2
/// products.
pub fn nodal_polynomial<C: Ring>(nodes: &[C]) -> Vec<C> {
    Coefficients::from_roots(nodes).into_vec()
}
