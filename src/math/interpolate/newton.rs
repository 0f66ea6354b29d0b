//! Divided differences and Newton's form of the interpolating polynomial.
//!
//! **Definition.** f\[x_i\] = f(x_i), and for x_i ≠ x_{i+k}
//!
//! f[x_i, …, x_{i+k}] = (f[x_{i+1}, …, x_{i+k}] − f[x_i, …, x_{i+k−1}]) / (x_{i+k} − x_i).
//!
//! Equal nodes stand next to each other, and where all k+1 of them are equal the value is
//! f^{(k)}(x_i)/k!. The polynomial of degree at most n that agrees with f at x_0, …, x_n (and, at
//! a node repeated m times, in the derivatives below order m) is
//!
//! p(t) = Σ_k f[x_0, …, x_k] (t − x_0) ⋯ (t − x_{k−1}).
//!
//! References: J. Stoer, R. Bulirsch, *Introduction to Numerical Analysis* (2002), sections
//! 2.1.3 and 2.1.5; C. de Boor, "Divided differences", Surveys in Approximation Theory 1 (2005).

use super::InterpolationError;
use super::datum::{
    Datum, as_many, check, enough, fitting, over_factorial, reciprocal, same_dimension, times_linear,
};
use super::numbers;
use crate::budget;
use crate::math::ring::{Field, Ring};

/// The table of all divided differences of consecutive nodes.
///
/// ```
/// use polarform::interpolate::DividedDifferences;
/// use polarform::number::integer as z;
/// // f(t) = t^3 at 0, 1, 2, 4
/// let nodes = [0, 1, 2, 4].map(z);
/// let table = DividedDifferences::new(&nodes, &[0, 1, 8, 64].map(z))?;
/// assert_eq!(table.column(1), [1, 7, 28].map(z));
/// assert_eq!(table.coefficients(), [0, 1, 3, 1].map(z));
/// assert_eq!(table.newton_form().to_power(), [0, 0, 0, 1].map(z));
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DividedDifferences<C, V = C> {
    nodes: Vec<C>,
    /// columns[k][i] = f[x_i, …, x_{i+k}]
    columns: Vec<Vec<V>>,
}

impl<C: Field, V: Datum<C>> DividedDifferences<C, V> {
    /// The table for values at distinct nodes. Cost: n²/2 quotients.
    ///
    /// # Errors
    /// [`InterpolationError`] when there are no nodes, two are equal, or the values do not fit.
    pub fn new(nodes: &[C], values: &[V]) -> Result<Self, InterpolationError> {
        check(nodes, values)?;
        Ok(Self::build(nodes.to_vec(), values))
    }

    /// The table for nodes that may repeat: where a node stands for the (j+1)-st time, the datum
    /// is the j-th derivative there. Equal nodes must be neighbours. Cost: n²/2 quotients.
    ///
    /// ```
    /// use polarform::interpolate::DividedDifferences;
    /// use polarform::number::integer as z;
    /// // p(0) = 1, p'(0) = 2, p(1) = 4
    /// let table = DividedDifferences::with_repeats(&[0, 0, 1].map(z), &[1, 2, 4].map(z))?;
    /// assert_eq!(table.coefficients(), [1, 2, 1].map(z));
    /// # Ok::<(), polarform::interpolate::InterpolationError>(())
    /// ```
    ///
    /// # Errors
    /// As [`DividedDifferences::new`]; equal nodes are wrong only if they stand apart.
    pub fn with_repeats(nodes: &[C], data: &[V]) -> Result<Self, InterpolationError> {
        enough(nodes.len(), 1)?;
        as_many("values", data.len(), nodes.len())?;
        same_dimension(data)?;
        for (second, node) in nodes.iter().enumerate().skip(1) {
            budget::step();
            if *node != nodes[second - 1]
                && let Some(first) = nodes[..second - 1].iter().position(|x| x == node)
            {
                return Err(InterpolationError::NodesApart { first, second });
            }
        }
        Ok(Self::build(nodes.to_vec(), data))
    }

    /// Equal nodes are neighbours, and there are as many data as nodes.
    pub(super) fn build(nodes: Vec<C>, data: &[V]) -> Self {
        let count = nodes.len();
        budget::charge_terms((count as u64).saturating_mul(count as u64) / 2);
        // Where the run of equal nodes starts to which a node belongs.
        let mut start: Vec<usize> = (0..count).collect();
        for i in 1..count {
            if nodes[i] == nodes[i - 1] {
                start[i] = start[i - 1];
            }
        }
        let mut columns = vec![start.iter().map(|&i| data[i].clone()).collect::<Vec<V>>()];
        for k in 1..count {
            let before = &columns[k - 1];
            let column = (0..count - k).map(|i| {
                if start[i] == start[i + k] {
                    over_factorial(&data[start[i] + k], k)
                } else {
                    quotient(&nodes, before, i, k)
                }
            });
            let column = column.collect();
            columns.push(column);
        }
        DividedDifferences { nodes, columns }
    }

    /// Adds a node and returns its place: behind the nodes equal to it, for which the datum is
    /// then the next derivative, else at the end. Only the differences that contain the new node
    /// are computed. Cost: n quotients at the end, at most n²/4 elsewhere.
    ///
    /// ```
    /// use polarform::interpolate::DividedDifferences;
    /// use polarform::number::integer as z;
    /// let mut table = DividedDifferences::new(&[0, 1].map(z), &[0, 1].map(z))?;
    /// assert_eq!(table.insert(z(3), z(9))?, 2); // t^2 at 3
    /// assert_eq!(table.insert(z(1), z(2))?, 2); // its derivative at 1
    /// assert_eq!(table.nodes(), [0, 1, 1, 3].map(z));
    /// assert_eq!(table.coefficients(), [0, 1, 1, 0].map(z));
    /// # Ok::<(), polarform::interpolate::InterpolationError>(())
    /// ```
    ///
    /// # Errors
    /// [`InterpolationError::Dimensions`].
    pub fn insert(&mut self, node: C, datum: V) -> Result<usize, InterpolationError> {
        fitting("datum", [&datum], &self.columns[0][0])?;
        let count = self.nodes.len();
        let (place, multiplicity) = match self.nodes.iter().rposition(|x| *x == node) {
            Some(last) => (last + 1, self.nodes.iter().filter(|x| **x == node).count()),
            None => (count, 0),
        };
        budget::charge_terms(((count + 1) as u64).saturating_mul(count as u64 + 1) / 2);
        self.nodes.insert(place, node);
        let old = std::mem::take(&mut self.columns);
        let first = place - multiplicity;
        while self.columns.len() <= count {
            let k = self.columns.len();
            let column = (0..=count - k).map(|i| {
                if i + k < place {
                    old[k][i].clone()
                } else if i > place {
                    old[k][i - 1].clone()
                } else if i >= first && i + k <= place {
                    // All nodes of this difference are equal to the new one.
                    if k < multiplicity { old[k][first].clone() } else { over_factorial(&datum, k) }
                } else {
                    quotient(&self.nodes, &self.columns[k - 1], i, k)
                }
            });
            let column = column.collect();
            self.columns.push(column);
        }
        Ok(place)
    }

    /// x_0, …, x_n
    pub fn nodes(&self) -> &[C] {
        &self.nodes
    }

    /// The degree n of the interpolating polynomial: one less than there are nodes.
    pub fn degree(&self) -> usize {
        self.nodes.len() - 1
    }

    /// All columns: the values, the first differences, and so on to f[x_0, …, x_n].
    pub fn columns(&self) -> &[Vec<V>] {
        &self.columns
    }

    /// f[x_i, …, x_{i+k}] for i = 0, …, n−k.
    ///
    /// # Panics
    /// If k is larger than the degree.
    pub fn column(&self, k: usize) -> &[V] {
        &self.columns[k]
    }

    /// f\[x_0\], f[x_0, x_1], …, f[x_0, …, x_n]: the coefficients of Newton's form.
    pub fn coefficients(&self) -> Vec<V> {
        self.columns.iter().map(|column| column[0].clone()).collect()
    }

    /// The form that starts at x_0.
    pub fn newton_form(&self) -> NewtonForm<C, V> {
        let nodes = self.nodes[..self.degree()].to_vec();
        NewtonForm { nodes, coefficients: self.coefficients() }
    }
}

/// The difference over i, …, i+k from those over one node less; x_i ≠ x_{i+k}.
fn quotient<C: Field, V: Datum<C>>(nodes: &[C], before: &[V], i: usize, k: usize) -> V {
    budget::step();
    before[i + 1].less(&before[i]).multiple(&reciprocal(&nodes[i + k].minus(&nodes[i])))
}

/// Σ_k c_k (t − x_0) ⋯ (t − x_{k−1}), k = 0, …, n, with n nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct NewtonForm<C, V = C> {
    nodes: Vec<C>,
    coefficients: Vec<V>,
}

impl<C: Ring, V: Datum<C>> NewtonForm<C, V> {
    /// The form with these nodes and one coefficient more.
    ///
    /// # Errors
    /// [`InterpolationError`] when their numbers or dimensions do not fit.
    pub fn new(nodes: Vec<C>, coefficients: Vec<V>) -> Result<Self, InterpolationError> {
        enough(coefficients.len(), 1)?;
        as_many("nodes", nodes.len(), coefficients.len() - 1)?;
        same_dimension(&coefficients)?;
        Ok(NewtonForm { nodes, coefficients })
    }

    /// x_0, …, x_{n−1}
    pub fn nodes(&self) -> &[C] {
        &self.nodes
    }

    /// c_0, …, c_n
    pub fn coefficients(&self) -> &[V] {
        &self.coefficients
    }

    /// p(t). Cost: n products.
    pub fn value(&self, t: &C) -> V {
        let n = self.nodes.len();
        let rest = self.nodes.iter().zip(&self.coefficients).rev();
        rest.fold(self.coefficients[n].clone(), |value, (node, c)| {
            budget::step();
            value.multiple(&t.minus(node)).added(c)
        })
    }

    /// The n + 1 power coefficients, lowest first; leading ones may be zero. Cost: n²/2 products;
    /// for numbers O(M(B) log n) for B bits in all, M the cost of a product.
    pub fn to_power(&self) -> Vec<V> {
        let numbers = numbers::numbers(&self.nodes);
        if let Some(power) = numbers.and_then(|nodes| numbers::from_newton(&nodes, &self.coefficients)) {
            return power;
        }
        self.to_power_by_steps()
    }

    /// The same for coefficients in any ring.
    pub(super) fn to_power_by_steps(&self) -> Vec<V> {
        let n = self.nodes.len();
        let rest = self.nodes.iter().zip(&self.coefficients).rev();
        rest.fold(vec![self.coefficients[n].clone()], |power, (node, c)| {
            let mut power = times_linear(power, node);
            power[0] = power[0].added(c);
            power
        })
    }
}
