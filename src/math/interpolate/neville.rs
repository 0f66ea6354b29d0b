//! Neville's and Aitken's algorithm: interpolation by repeated affine interpolation.
//!
//! **Definition.** Let p_{i,k} be the polynomial of degree at most k that agrees with the data at
//! x_i, …, x_{i+k}. Then p_{i,0} = y_i and
//!
//! p_{i,k}(t) = ((x_{i+k} − t) p_{i,k−1}(t) + (t − x_i) p_{i+1,k−1}(t)) / (x_{i+k} − x_i):
//!
//! the affine map that takes x_i, x_{i+k} to p_{i,k−1}(t), p_{i+1,k−1}(t), at t. The weights sum
//! to 1, so every entry of the tableau is an affine combination of the points. The same pyramid
//! with other pairs of knots in the weights is de Casteljau's or de Boor's algorithm.
//!
//! References: J. Stoer, R. Bulirsch, *Introduction to Numerical Analysis* (2002), section
//! 2.1.2; R. N. Goldman, *Pyramid Algorithms* (2003), chapter 2.

use super::InterpolationError;
use super::datum::{Datum, check, reciprocal};
use crate::budget;
use crate::math::ring::Field;

/// In which order the interpolants are combined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    /// Neville: entry i of level k belongs to the nodes x_i, …, x_{i+k}.
    Neville,
    /// Aitken: entry i of level k belongs to the nodes x_0, …, x_{k−1}, x_{k+i}.
    Aitken,
}

impl Scheme {
    /// Entry i of level k ≥ 1 is combined from two entries of level k − 1, the left and the
    /// right one, and is the affine map over [x_l, x_r]: (left, right, l, r).
    fn step(self, i: usize, k: usize) -> (usize, usize, usize, usize) {
        match self {
            Scheme::Neville => (i, i + 1, i, i + k),
            Scheme::Aitken => (0, i + 1, k - 1, i + k),
        }
    }
}

/// All values of the pyramid at one parameter.
///
/// ```
/// use polarform::interpolate::{Scheme, Tableau};
/// use polarform::number::{integer as z, rational as q};
/// let tableau = Tableau::new(Scheme::Neville, &[0, 1, 3].map(z), &[1, 3, 2].map(z), &z(2))?;
/// assert_eq!(tableau.levels()[1], [z(5), q(5, 2)]);
/// assert_eq!(tableau.value(), &q(10, 3));
/// assert_eq!(tableau.weights(2, 0), Some((q(1, 3), q(2, 3))));
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Tableau<C, V = C> {
    scheme: Scheme,
    nodes: Vec<C>,
    at: C,
    levels: Vec<Vec<V>>,
}

impl<C: Field, V: Datum<C>> Tableau<C, V> {
    /// The tableau at the parameter `at`. Cost: n²/2 affine combinations.
    ///
    /// # Errors
    /// [`InterpolationError`] when there are no nodes, two are equal, or the values do not fit.
    pub fn new(scheme: Scheme, nodes: &[C], values: &[V], at: &C) -> Result<Self, InterpolationError> {
        check(nodes, values)?;
        let weights = |l: usize, r: usize| affine_weights(&nodes[l], &nodes[r], at);
        let levels = pyramid(scheme, values.to_vec(), |left: &V, right: &V, l, r| {
            let (first, second) = weights(l, r);
            left.multiple(&first).added(&right.multiple(&second))
        });
        Ok(Tableau { scheme, nodes: nodes.to_vec(), at: at.clone(), levels })
    }

    /// Neville's or Aitken's order.
    pub fn scheme(&self) -> Scheme {
        self.scheme
    }

    /// x_0, …, x_n
    pub fn nodes(&self) -> &[C] {
        &self.nodes
    }

    /// The parameter t.
    pub fn parameter(&self) -> &C {
        &self.at
    }

    /// All levels, from the data to the value; level k has n + 1 − k values.
    pub fn levels(&self) -> &[Vec<V>] {
        &self.levels
    }

    /// The weights with which entry i of level k ≥ 1 is made of the two entries below it; they
    /// sum to 1. `None` if there is no such entry.
    pub fn weights(&self, k: usize, i: usize) -> Option<(C, C)> {
        if k == 0 || i >= self.levels.get(k)?.len() {
            return None;
        }
        let (_, _, l, r) = self.scheme.step(i, k);
        Some(affine_weights(&self.nodes[l], &self.nodes[r], &self.at))
    }

    /// The two entries of level k − 1 of which entry i of level k ≥ 1 is made.
    pub fn parents(&self, k: usize, i: usize) -> Option<(usize, usize)> {
        if k == 0 || i >= self.levels.get(k)?.len() {
            return None;
        }
        let (left, right, _, _) = self.scheme.step(i, k);
        Some((left, right))
    }

    /// p(t), the tip.
    pub fn value(&self) -> &V {
        &self.levels[self.levels.len() - 1][0]
    }
}

/// (b − t)/(b − a) and (t − a)/(b − a) for a ≠ b.
fn affine_weights<C: Field>(a: &C, b: &C, t: &C) -> (C, C) {
    let inverse = reciprocal(&b.minus(a));
    (b.minus(t).times(&inverse), t.minus(a).times(&inverse))
}

/// Levels 0, …, n from level 0 and the step (left, right, l, r) over [x_l, x_r].
fn pyramid<T>(scheme: Scheme, first: Vec<T>, step: impl Fn(&T, &T, usize, usize) -> T) -> Vec<Vec<T>> {
    let count = first.len();
    budget::charge_terms((count as u64).saturating_mul(count as u64) / 2);
    let mut levels = vec![first];
    for k in 1..count {
        let below = &levels[k - 1];
        let level = (0..count - k).map(|i| {
            budget::step();
            let (left, right, l, r) = scheme.step(i, k);
            step(&below[left], &below[right], l, r)
        });
        let level = level.collect();
        levels.push(level);
    }
    levels
}
