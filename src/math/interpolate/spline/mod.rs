//! Interpolating cubic splines.
//!
//! **Definition.** A cubic spline S with the nodes x_0 < … < x_n is a polynomial of degree at most
//! 3 on each [x_i, x_{i+1}] and twice continuously differentiable. It interpolates y_i if
//! S(x_i) = y_i; two more conditions, at the ends, make it unique. With h_i = x_{i+1} − x_i,
//! δ_i = (y_{i+1} − y_i)/h_i and
//!
//! μ_i = h_{i−1}/(h_{i−1} + h_i),  λ_i = h_i/(h_{i−1} + h_i) = 1 − μ_i,
//!
//! there are two systems of equations for it, for 0 < i < n:
//! - by moments M_i = S''(x_i): μ_i M_{i−1} + 2 M_i + λ_i M_{i+1} = d_i with
//!   d_i = 6 (δ_i − δ_{i−1})/(h_{i−1} + h_i) = 6 f[x_{i−1}, x_i, x_{i+1}] (S' is continuous)
//! - by slopes m_i = S'(x_i): λ_i m_{i−1} + 2 m_i + μ_i m_{i+1} = 3 (λ_i δ_{i−1} + μ_i δ_i)
//!   (S'' is continuous)
//!
//! Both are tridiagonal, cyclic for periodic splines. Values may be points of any dimension.
//!
//! References: J. Stoer, R. Bulirsch, *Introduction to Numerical Analysis* (2002), section 2.4;
//! C. de Boor, *A Practical Guide to Splines* (2001), chapter IV.

mod ends;
mod tridiagonal;

#[cfg(test)]
mod tests;

use crate::budget;
use crate::math::interpolate::InterpolationError;
use crate::math::interpolate::datum::{
    Datum, as_many, enough, fitting, increasing, reciprocal, same_dimension, share, times_linear,
};
use crate::math::number::rational;
use crate::math::piecewise::{Outside, Piecewise};
use crate::math::poly::Coefficients;
use crate::math::ring::Field;

pub use ends::{End, Ends};
pub use tridiagonal::Tridiagonal;

/// What a spline is computed from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknowns {
    /// The second derivatives M_i at the nodes.
    Moments,
    /// The first derivatives m_i at the nodes.
    Slopes,
}

/// The system of equations of a spline: matrix · unknowns = right.
#[derive(Clone, Debug, PartialEq)]
pub struct SplineSystem<C, V = C> {
    /// What the unknowns are.
    pub unknowns: Unknowns,
    /// The index of the first unknown: 0, or 1 for a periodic spline, whose M_0 is M_n.
    pub first: usize,
    /// The matrix.
    pub matrix: Tridiagonal<C>,
    /// The right sides.
    pub right: Vec<V>,
}

impl<C: Field, V: Datum<C>> SplineSystem<C, V> {
    /// The unknowns. Cost: O(n).
    ///
    /// # Errors
    /// [`InterpolationError::Singular`]; impossible when the nodes increase.
    pub fn solve(&self) -> Result<Vec<V>, InterpolationError> {
        self.matrix.solve(&self.right)
    }
}

/// h_i and δ_i.
struct Steps<C, V> {
    lengths: Vec<C>,
    differences: Vec<V>,
}

impl<C: Field, V: Datum<C>> Steps<C, V> {
    fn new(nodes: &[C], values: &[V], ends: &Ends<V>) -> Result<Self, InterpolationError> {
        enough(nodes.len(), 2)?;
        as_many("values", values.len(), nodes.len())?;
        same_dimension(values)?;
        fitting("end", ends.data(), &values[0])?;
        increasing(nodes)?;
        if matches!(ends, Ends::Periodic) && values[0] != values[values.len() - 1] {
            return Err(InterpolationError::NotPeriodic);
        }
        budget::charge_terms(nodes.len() as u64);
        let lengths: Vec<C> = nodes.windows(2).map(|pair| pair[1].minus(&pair[0])).collect();
        // Sums of two lengths are divided by; only symbolic nodes out of order make one vanish.
        if let Some(first) = nodes.windows(3).position(|three| three[0] == three[2]) {
            return Err(InterpolationError::EqualNodes { first, second: first + 2 });
        }
        if lengths[0].plus(&lengths[lengths.len() - 1]).is_zero() {
            return Err(InterpolationError::NotIncreasing { index: lengths.len() });
        }
        let differences =
            values.windows(2).zip(&lengths).map(|(pair, h)| pair[1].less(&pair[0]).multiple(&reciprocal(h)));
        Ok(Steps { differences: differences.collect(), lengths })
    }

    /// The row of a node between intervals `left` and `right`: below, above, right side.
    fn row(&self, unknowns: Unknowns, left: usize, right: usize) -> (C, C, V) {
        budget::step();
        let (before, after) = (&self.lengths[left], &self.lengths[right]);
        let inverse = reciprocal(&before.plus(after));
        let (mu, lambda) = (before.times(&inverse), after.times(&inverse));
        let (down, up) = (&self.differences[left], &self.differences[right]);
        match unknowns {
            Unknowns::Moments => {
                let second = up.less(down).multiple(&inverse);
                (mu, lambda, share(&second, &rational(6, 1)))
            }
            Unknowns::Slopes => {
                let mean = down.multiple(&lambda).added(&up.multiple(&mu));
                (lambda, mu, share(&mean, &rational(3, 1)))
            }
        }
    }

    fn system(&self, unknowns: Unknowns, ends: &Ends<V>) -> Result<SplineSystem<C, V>, InterpolationError> {
        let n = self.lengths.len();
        let two = C::from_rational(&rational(2, 1));
        let mut rows = Vec::with_capacity(n + 1);
        for i in 1..n {
            let (below, above, right) = self.row(unknowns, i - 1, i);
            rows.push((below, two.clone(), above, right));
        }
        match ends {
            Ends::Periodic => {
                let (below, above, right) = self.row(unknowns, n - 1, 0);
                rows.push((below, two, above, right));
            }
            Ends::Each { first, last } => {
                let [start, stop] = ends::equations(unknowns, &self.lengths, &self.differences, first, last);
                rows.insert(0, (C::zero(), start.outer, start.inner, start.right));
                rows.push((stop.inner, stop.outer, C::zero(), stop.right));
            }
        }
        let cyclic = matches!(ends, Ends::Periodic);
        let (mut lower, mut diagonal, mut upper, mut right) = (vec![], vec![], vec![], vec![]);
        for (below, on, above, datum) in rows {
            lower.push(below);
            diagonal.push(on);
            upper.push(above);
            right.push(datum);
        }
        let matrix = Tridiagonal::new(lower, diagonal, upper, cyclic)?;
        Ok(SplineSystem { unknowns, first: usize::from(cyclic), matrix, right })
    }

    /// m_i = δ_i − h_i (2 M_i + M_{i+1})/6, and m_n = δ_{n−1} + h_{n−1} (M_{n−1} + 2 M_n)/6.
    fn slopes(&self, moments: &[V]) -> Vec<V> {
        let n = self.lengths.len();
        let part = |i: usize, near: &V, far: &V| {
            share(&near.added(near).added(far).multiple(&self.lengths[i]), &rational(1, 6))
        };
        let at = |i: usize| self.differences[i].less(&part(i, &moments[i], &moments[i + 1]));
        let last = self.differences[n - 1].added(&part(n - 1, &moments[n], &moments[n - 1]));
        (0..n).map(at).chain([last]).collect()
    }

    /// M_i = (6 δ_i − 4 m_i − 2 m_{i+1})/h_i, and M_n = (2 m_{n−1} + 4 m_n − 6 δ_{n−1})/h_{n−1}.
    fn moments(&self, slopes: &[V]) -> Vec<V> {
        let n = self.lengths.len();
        let bend = |i: usize, near: &V, far: &V| {
            let rest = share(&self.differences[i], &rational(3, 1)).less(near).less(near).less(far);
            share(&rest.multiple(&reciprocal(&self.lengths[i])), &rational(2, 1))
        };
        let last = bend(n - 1, &slopes[n], &slopes[n - 1]);
        (0..n).map(|i| bend(i, &slopes[i], &slopes[i + 1])).chain([last.origin().less(&last)]).collect()
    }
}

/// An interpolating cubic spline and the system it was found by.
///
/// ```
/// use polarform::interpolate::{CubicSpline, Ends};
/// use polarform::number::{integer as z, rational as q};
/// let nodes = [0, 1, 2].map(z);
/// let spline = CubicSpline::by_moments(&nodes, &[0, 1, 0].map(z), Ends::natural())?;
/// assert_eq!(spline.moments(), [0, -3, 0].map(z));
/// assert_eq!(spline.slopes(), [q(3, 2), z(0), q(-3, 2)]);
/// assert_eq!(spline.power(0), [z(0), q(3, 2), z(0), q(-1, 2)]);
/// let other = CubicSpline::by_slopes(&nodes, &[0, 1, 0].map(z), Ends::natural())?;
/// assert_eq!(spline.moments(), other.moments());
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CubicSpline<C, V = C> {
    nodes: Vec<C>,
    values: Vec<V>,
    ends: Ends<V>,
    moments: Vec<V>,
    slopes: Vec<V>,
    system: SplineSystem<C, V>,
}

impl<C: Field, V: Datum<C>> CubicSpline<C, V> {
    /// The spline by its moments: second derivatives are the unknowns. Cost: O(n).
    ///
    /// # Errors
    /// [`InterpolationError`] when there are fewer than two nodes, they do not increase (where
    /// they are numbers), the values do not fit, or those of a periodic spline do not close.
    pub fn by_moments(nodes: &[C], values: &[V], ends: Ends<V>) -> Result<Self, InterpolationError> {
        Self::new(Unknowns::Moments, nodes, values, ends)
    }

    /// The same spline by its slopes: first derivatives are the unknowns. Cost: O(n).
    ///
    /// # Errors
    /// As [`CubicSpline::by_moments`].
    pub fn by_slopes(nodes: &[C], values: &[V], ends: Ends<V>) -> Result<Self, InterpolationError> {
        Self::new(Unknowns::Slopes, nodes, values, ends)
    }

    fn new(unknowns: Unknowns, nodes: &[C], values: &[V], ends: Ends<V>) -> Result<Self, InterpolationError> {
        let steps = Steps::new(nodes, values, &ends)?;
        let system = steps.system(unknowns, &ends)?;
        let mut solution = system.solve()?;
        if system.first == 1 {
            solution.insert(0, solution[solution.len() - 1].clone());
        }
        let (moments, slopes) = match unknowns {
            Unknowns::Moments => {
                let slopes = steps.slopes(&solution);
                (solution, slopes)
            }
            Unknowns::Slopes => (steps.moments(&solution), solution),
        };
        let (nodes, values) = (nodes.to_vec(), values.to_vec());
        Ok(CubicSpline { nodes, values, ends, moments, slopes, system })
    }

    /// x_0, …, x_n
    pub fn nodes(&self) -> &[C] {
        &self.nodes
    }

    /// y_0, …, y_n
    pub fn values(&self) -> &[V] {
        &self.values
    }

    /// The conditions at the ends.
    pub fn ends(&self) -> &Ends<V> {
        &self.ends
    }

    /// M_0, …, M_n
    pub fn moments(&self) -> &[V] {
        &self.moments
    }

    /// m_0, …, m_n
    pub fn slopes(&self) -> &[V] {
        &self.slopes
    }

    /// The equations that were solved.
    pub fn system(&self) -> &SplineSystem<C, V> {
        &self.system
    }

    /// The number n of pieces.
    pub fn pieces(&self) -> usize {
        self.nodes.len() - 1
    }

    fn length(&self, i: usize) -> C {
        self.nodes[i + 1].minus(&self.nodes[i])
    }

    /// Piece i as textbooks write it: α, β, γ, η with
    /// S_i(t) = α (x_{i+1} − t)³ + β (t − x_i)³ + γ (x_{i+1} − t) + η (t − x_i), that is
    /// M_i/(6h_i), M_{i+1}/(6h_i), y_i/h_i − M_i h_i/6 and y_{i+1}/h_i − M_{i+1} h_i/6.
    ///
    /// # Panics
    /// If there is no piece i.
    #[cfg(test)]
    fn moment_form(&self, i: usize) -> [V; 4] {
        let h = self.length(i);
        let inverse = reciprocal(&h);
        let cubic = |moment: &V| share(&moment.multiple(&inverse), &rational(1, 6));
        let linear = |value: &V, moment: &V| {
            value.multiple(&inverse).less(&share(&moment.multiple(&h), &rational(1, 6)))
        };
        let (left, right) = (&self.moments[i], &self.moments[i + 1]);
        [cubic(left), cubic(right), linear(&self.values[i], left), linear(&self.values[i + 1], right)]
    }

    /// The coefficients of 1, t − x_i, (t − x_i)², (t − x_i)³ on piece i:
    /// y_i, m_i, M_i/2, (M_{i+1} − M_i)/(6h_i).
    ///
    /// # Panics
    /// If there is no piece i.
    pub fn taylor(&self, i: usize) -> [V; 4] {
        let inverse = reciprocal(&self.length(i));
        let (left, right) = (&self.moments[i], &self.moments[i + 1]);
        let third = share(&right.less(left).multiple(&inverse), &rational(1, 6));
        [self.values[i].clone(), self.slopes[i].clone(), share(left, &rational(1, 2)), third]
    }

    /// The four power coefficients in t of piece i, lowest first; leading ones may be zero.
    ///
    /// # Panics
    /// If there is no piece i.
    pub fn power(&self, i: usize) -> Vec<V> {
        let taylor = self.taylor(i);
        let [rest @ .., last] = &taylor;
        rest.iter().rev().fold(vec![last.clone()], |power, c| {
            let mut power = times_linear(power, &self.nodes[i]);
            power[0] = power[0].added(c);
            power
        })
    }

    /// The spline as piecewise polynomials, one for each coordinate.
    pub fn to_piecewise(&self) -> Vec<Piecewise<C>> {
        let pieces: Vec<Vec<V>> = (0..self.pieces()).map(|i| self.power(i)).collect();
        let coordinate = |k: usize| {
            let one = |piece: &Vec<V>| piece.iter().map(|c| c.coordinates()[k].clone()).collect();
            let polynomials: Vec<Coefficients<C>> = pieces.iter().map(one).collect();
            Piecewise::new(self.nodes.clone(), polynomials, Outside::Undefined)
                .expect("the nodes increase, and there is a piece between any two")
        };
        (0..self.values[0].dimension()).map(coordinate).collect()
    }

    /// ∫ ‖S''‖² from x_0 to x_n, Σ h_i (M_i² + M_i M_{i+1} + M_{i+1}²)/3 over all coordinates. Of all
    /// twice differentiable interpolants the natural spline has the smallest.
    pub fn bending_energy(&self) -> C {
        let mut sum = C::zero();
        for (i, pair) in self.moments.windows(2).enumerate() {
            let coordinates = pair[0].coordinates().iter().zip(pair[1].coordinates());
            let squares = coordinates.fold(C::zero(), |sum, (x, y)| {
                budget::step();
                sum.plus(&x.times(&x.plus(y))).plus(&y.times(y))
            });
            sum += squares.times(&self.length(i)).scaled(&rational(1, 3));
        }
        sum
    }
}
