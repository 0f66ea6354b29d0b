//! Splines of any degree from values: interpolation, least squares, smoothing.
//!
//! A spline Σ d_i N_i takes the values y at the nodes x_0 < … < x_{m−1} in exactly one way iff N_i(x_i) ≠ 0
//! for all i (I. J. Schoenberg, A. Whitney 1953): t_i < x_i < t_{i+n+1}, or x_i is an end of the domain
//! where N_i is not 0. For least squares some of the nodes have to satisfy this.

use nalgebra::DMatrix;
use num_traits::Signed;

use super::{ApproximationError, spline_gram};
use crate::budget;
use crate::math::curve::Point;
use crate::math::interpolate::{InterpolationError, increasing};
use crate::math::interval::Interval;
use crate::math::linalg::{rank, solve};
use crate::math::number::{Int, Rational};
use crate::math::ring::Field;
use crate::math::spline::{BSpline, KnotVector};

/// λ ∫ |S^(r)|², added to what is made least.
#[derive(Clone, Debug, PartialEq)]
pub struct Smoothing<C> {
    /// λ
    pub weight: C,
    /// r
    pub order: usize,
}

/// The values N_{j−n}(x), …, N_j(x) at each node, and j.
type Rows<C> = Vec<(usize, Vec<C>)>;

fn rows<C: Field>(knots: &KnotVector<C>, nodes: &[C]) -> Result<Rows<C>, ApproximationError> {
    budget::charge_terms((nodes.len() as u64).saturating_mul(knots.degree() as u64 + 1));
    nodes.iter().map(|node| Ok(knots.values_at(node)?)).collect()
}

/// Whether N_i is not 0 at the node of a row.
fn reaches<C: Field>((span, values): &(usize, Vec<C>), i: usize) -> bool {
    let first = span + 1 - values.len();
    i.checked_sub(first).and_then(|k| values.get(k)).is_some_and(|value| !value.is_zero())
}

fn as_many<C: Field>(nodes: &[C], values: &[Point<C>]) -> Result<usize, ApproximationError> {
    let (given, needed) = (values.len(), nodes.len());
    if given != needed {
        return Err(InterpolationError::Lengths { what: "values", given, needed }.into());
    }
    Ok(crate::math::curve::dimension(values)?)
}

fn as_points<C: Field>(solution: &DMatrix<C>) -> Vec<Point<C>> {
    solution.row_iter().map(|row| row.iter().cloned().collect()).collect()
}

/// The spline over these knots with the value y_i at x_i, as many nodes as basis functions.
///
/// Cost: n² products for each node, and the solution of m equations.
///
/// # Errors
/// [`ApproximationError::SchoenbergWhitney`], [`ApproximationError::NodeCount`], nodes that do not
/// increase or lie outside of the domain, and different numbers of values or coordinates.
///
/// ```
/// use polarform::approximation::{ApproximationError, interpolating_spline};
/// use polarform::interval::Interval;
/// use polarform::number::{integer as z, rational as q};
/// use polarform::spline::KnotVector;
/// let whole = Interval::new(z(0), z(4))?;
/// let knots = || KnotVector::clamped(2, &[z(2)], &whole);
/// let values = [0, 1, 9, 16].map(|y| [z(y)].into());
/// let s = interpolating_spline(knots()?, &[0, 1, 3, 4].map(z), &values)?;
/// assert_eq!(s.points(), [[z(0)], [z(0)], [z(8)], [z(16)]]); // t²
/// let hats = KnotVector::clamped(1, &[z(2), z(3)], &whole)?;
/// let early = interpolating_spline(hats, &[q(0, 1), q(1, 1), q(3, 2), q(4, 1)], &values);
/// assert_eq!(early, Err(ApproximationError::SchoenbergWhitney { index: 2 }));
/// # Ok::<(), ApproximationError>(())
/// ```
pub fn interpolating_spline<C: Field>(
    knots: KnotVector<C>,
    nodes: &[C],
    values: &[Point<C>],
) -> Result<BSpline<C>, ApproximationError> {
    knots.interval()?;
    let m = knots.count();
    if nodes.len() != m {
        return Err(ApproximationError::NodeCount { nodes: nodes.len(), functions: m });
    }
    let size = as_many(nodes, values)?;
    increasing(nodes)?;
    let rows = rows(&knots, nodes)?;
    if let Some(index) = (0..m).find(|&i| !reaches(&rows[i], i)) {
        return Err(ApproximationError::SchoenbergWhitney { index });
    }
    budget::charge_terms((m as u64).saturating_mul(m as u64));
    let mut matrix = DMatrix::zeros(m, m);
    for (i, (span, values)) in rows.into_iter().enumerate() {
        for (j, value) in (span + 1 - values.len()..).zip(values) {
            matrix[(i, j)] = value;
        }
    }
    let right = DMatrix::from_fn(m, size, |i, k| values[i][k].clone());
    let singular = |_| InterpolationError::Singular { unknowns: m, rank: rank(&matrix) };
    let solution = solve(&matrix, &right).map_err(singular)?;
    Ok(BSpline::new(knots, as_points(&solution))?)
}

/// The spline with the least Σ w_i |y_i − S(x_i)|² + λ ∫ |S^(r)|²; all w_i are 1 if not given, and there
/// is no second term without smoothing. Nodes may repeat.
///
/// (A^T W A + λ G) d = A^T W y, A the values of the basis functions at the nodes, G their Gram matrix of order
/// r. Cost: n² products for each node, and the solution of m equations.
///
/// # Errors
/// [`ApproximationError::NoNodeFor`] if the spline is not unique (without smoothing), a singular
/// system (with), nodes that decrease, negative weights, lists of different lengths.
///
/// ```
/// use polarform::approximation::{ApproximationError, fitted_spline};
/// use polarform::interval::Interval;
/// use polarform::number::{integer as z, rational as q};
/// use polarform::spline::KnotVector;
/// // the line next to 0, 1, 1, 2
/// let knots = KnotVector::clamped(1, &[], &Interval::new(z(0), z(3))?)?;
/// let values = [0, 1, 1, 2].map(|y| [z(y)].into());
/// let fit = fitted_spline(knots, &[0, 1, 2, 3].map(z), &values, None, None)?;
/// assert_eq!(fit.points(), [[q(1, 10)], [q(19, 10)]]);
/// # Ok::<(), ApproximationError>(())
/// ```
pub fn fitted_spline<C: Field>(
    knots: KnotVector<C>,
    nodes: &[C],
    values: &[Point<C>],
    weights: Option<&[C]>,
    smoothing: Option<&Smoothing<C>>,
) -> Result<BSpline<C>, ApproximationError> {
    knots.interval()?;
    let size = as_many(nodes, values)?;
    let weights = weights.map_or_else(|| vec![C::one(); nodes.len()], <[C]>::to_vec);
    if weights.len() != nodes.len() {
        let (given, needed) = (weights.len(), nodes.len());
        return Err(InterpolationError::Lengths { what: "weights", given, needed }.into());
    }
    let negative = |w: &C| w.as_rational().is_some_and(|q| q.is_negative());
    if let Some(index) = weights.iter().position(negative) {
        return Err(InterpolationError::NegativeWeight { index }.into());
    }
    let mut distinct = nodes.to_vec();
    distinct.dedup();
    increasing(&distinct)?;
    let rows = rows(&knots, nodes)?;
    let m = knots.count();
    budget::charge_terms((m as u64).saturating_mul(m as u64));
    let mut matrix = match smoothing {
        Some(smoothing) => spline_gram(&knots, smoothing.order)?.map(|x| x.times(&smoothing.weight)),
        None => {
            without_gaps(m, nodes, &rows, &weights)?;
            DMatrix::zeros(m, m)
        }
    };
    let mut right = DMatrix::zeros(m, size);
    for (((span, row), weight), value) in rows.iter().zip(&weights).zip(values) {
        let first = span + 1 - row.len();
        for (i, x) in row.iter().enumerate() {
            budget::step();
            let weighted = x.times(weight);
            for (j, y) in row.iter().enumerate() {
                matrix[(first + i, first + j)] += weighted.times(y);
            }
            for (k, y) in value.iter().enumerate() {
                right[(first + i, k)] += weighted.times(y);
            }
        }
    }
    let singular = |_| InterpolationError::Singular { unknowns: m, rank: rank(&matrix) };
    Ok(BSpline::new(knots, as_points(&solve(&matrix, &right).map_err(singular)?))?)
}

/// Some of the nodes satisfy the condition of Schoenberg and Whitney: each function takes the first node
/// after that of the one before it at which it is not 0. Supports move to the right with i, so that no
/// other choice does better.
fn without_gaps<C: Field>(
    m: usize,
    nodes: &[C],
    rows: &Rows<C>,
    weights: &[C],
) -> Result<(), ApproximationError> {
    let counts = |k: &usize| !weights[*k].is_zero();
    let mut places: Vec<usize> = (0..nodes.len()).filter(counts).collect();
    places.dedup_by(|a, b| nodes[*a] == nodes[*b]);
    let mut places = places.into_iter();
    match (0..m).find(|&i| !places.any(|k| reaches(&rows[k], i))) {
        Some(index) => Err(ApproximationError::NoNodeFor { index }),
        None => Ok(()),
    }
}

/// Clamped knots for interpolation at given nodes: the inner ones are means of n consecutive nodes, so that
/// the condition of Schoenberg and Whitney holds (de Boor 2001, chapter XIII). For degree 0 they are
/// the middles between nodes.
///
/// # Errors
/// [`ApproximationError::NodeCount`] for fewer than n + 1 nodes, nodes that do not increase.
///
/// ```
/// use polarform::approximation::{ApproximationError, averaged_knots};
/// use polarform::number::{integer as z, rational as q};
/// let knots = averaged_knots(2, &[0, 1, 3, 4].map(z))?;
/// assert_eq!(knots.knots(), [0, 0, 0, 2, 4, 4, 4].map(z));
/// # Ok::<(), ApproximationError>(())
/// ```
pub fn averaged_knots<C: Field>(n: usize, nodes: &[C]) -> Result<KnotVector<C>, ApproximationError> {
    let m = nodes.len();
    if m < (n + 1).max(2) {
        return Err(ApproximationError::NodeCount { nodes: m, functions: (n + 1).max(2) });
    }
    increasing(nodes)?;
    let window = n.max(1) + usize::from(n == 0);
    let share = Rational::new(Int::ONE, Int::from(window));
    let mean = |j: usize| {
        let sum = nodes[j..j + window].iter().fold(C::zero(), |sum, node| sum.plus(node));
        sum.scaled(&share)
    };
    let first = usize::from(n > 0);
    let inner: Vec<C> = (first..first + m - n - 1).map(mean).collect();
    let interval = Interval::new(nodes[0].clone(), nodes[m - 1].clone())?;
    Ok(KnotVector::clamped(n, &inner, &interval)?)
}
