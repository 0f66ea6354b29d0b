//! Parameters for points that a curve is to interpolate.
//!
//! **Definition.** For points P_0, …, P_n with chords d_i = |P_{i+1} − P_i| the parameters are
//! t_0 = 0 and t_{i+1} = t_i + Δ_i with
//! - uniform: Δ_i = 1
//! - chord: Δ_i = d_i
//! - centripetal: Δ_i = √d_i
//! - Foley: Δ_i = d_i (1 + (3/2) θ̂_i d_{i−1}/(d_{i−1} + d_i) + (3/2) θ̂_{i+1} d_{i+1}/(d_i + d_{i+1})),
//!   where θ̂_i = min(π − θ_i, π/2), θ_i is the angle P_{i−1} P_i P_{i+1}, and terms with a chord that
//!   does not exist are left out
//!
//! and for the unit interval all are divided by the last. The formula of Foley and Nielson is
//! symmetric: reversing the points reverses the Δ_i. (Some notes have d_i for d_{i+1} in the last
//! numerator, which is not.) Their metric, invariant under affine maps, is not used; lengths and
//! angles are Euclidean.
//!
//! **Exactness.** Roots and angles are irrational in general. The result is exact where it can
//! be: over the unit interval whenever all ratios Δ_i/Δ_0 of chords or their roots are rational,
//! which for these methods is so exactly when all parameters are. Otherwise a number of decimals
//! has to be asked for. Each parameter is then the true number, rounded once to that many
//! decimals, half to even: it is enclosed between rational bounds (integer square roots, the
//! series of arctan) that are refined until they agree on the rounded value. Floating point is
//! never used. Angles other than 0 have irrational ratios to roots, so Foley's parameters are
//! exact only for points on a line that does not turn.
//!
//! References: T. A. Foley, G. M. Nielson, "Knot selection for parametric spline interpolation",
//! in *Mathematical Methods in CAGD* (1989); E. T. Y. Lee, "Choosing nodes in parametric curve
//! interpolation", CAD 21 (1989); G. Farin, *Curves and Surfaces for CAGD* (2002), section 9.6.

mod enclosure;

#[cfg(test)]
mod tests;

use num_traits::{One, Zero};

use crate::budget;
use crate::math::interpolate::InterpolationError;
use crate::math::interpolate::datum::{enough, same_dimension};
use crate::math::number::{Int, Rational, rational};
use enclosure::{Bounds, root};

/// How distances of parameters follow from points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parameterization {
    /// Δ_i = 1.
    Uniform,
    /// Δ_i = d_i, the length of the chord.
    Chord,
    /// Δ_i = √d_i.
    Centripetal,
    /// The chord, lengthened where the polygon turns.
    Foley,
}

/// Where the parameters end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// t_n = 1.
    Unit,
    /// t_n = Σ Δ_i.
    Sum,
}

/// Parameters t_0 = 0 < t_1 < … < t_n.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameters {
    /// t_0, …, t_n
    pub values: Vec<Rational>,
    /// Whether these are the true numbers. Otherwise each is rounded.
    pub exact: bool,
    /// The number of decimals each is rounded to, if it is rounded.
    pub decimals: Option<u32>,
}

/// Parameters for points; exact where they are rational, else rounded to `decimals` if given.
///
/// Cost: linear in the number of points; numbers of about four times as many digits as asked for.
///
/// ```
/// use polarform::interpolate::{InterpolationError, Parameterization, Scale, parameters};
/// use polarform::number::{integer as z, rational as q};
/// // chords 5 and 10
/// let points = [vec![z(0), z(0)], vec![z(3), z(4)], vec![z(9), z(12)]];
/// let chord = parameters(&points, Parameterization::Chord, Scale::Unit, None)?;
/// assert_eq!(chord.values, [q(0, 1), q(1, 3), q(1, 1)]);
/// assert!(chord.exact);
/// // their roots √5 and √10 have an irrational ratio
/// assert!(parameters(&points, Parameterization::Centripetal, Scale::Unit, None).is_err());
/// let rounded = parameters(&points, Parameterization::Centripetal, Scale::Unit, Some(3))?;
/// assert_eq!(rounded.values, [q(0, 1), q(414, 1000), q(1, 1)]); // 1/(1 + √2)
/// assert!(!rounded.exact);
/// # Ok::<(), InterpolationError>(())
/// ```
///
/// # Errors
/// [`InterpolationError::TooFewPoints`] for less than two points,
/// [`InterpolationError::Dimensions`], [`InterpolationError::CoincidentPoints`] (not for uniform
/// parameters), [`InterpolationError::Irrational`] when no decimals are given and
/// [`InterpolationError::TooFewDecimals`] when two parameters are equal after rounding.
pub fn parameters(
    points: &[Vec<Rational>],
    method: Parameterization,
    scale: Scale,
    decimals: Option<u32>,
) -> Result<Parameters, InterpolationError> {
    enough(points.len(), 2)?;
    same_dimension(points)?;
    budget::charge_terms(points.len() as u64);
    if method == Parameterization::Uniform {
        return Ok(exactly(&vec![Rational::one(); points.len() - 1], scale));
    }
    let polygon = Polygon::new(points)?;
    match (polygon.exact_steps(method, scale), decimals) {
        (Ok(steps), _) => Ok(exactly(&steps, scale)),
        (Err(_), Some(decimals)) => polygon.rounded(method, scale, decimals),
        (Err(error), None) => Err(error),
    }
}

/// The parameters with these differences, or such a ratio of differences.
fn exactly(steps: &[Rational], scale: Scale) -> Parameters {
    let mut values = vec![Rational::zero()];
    for step in steps {
        budget::step();
        values.push(&values[values.len() - 1] + step);
    }
    if scale == Scale::Unit {
        let total = values[values.len() - 1].clone();
        for value in &mut values {
            *value /= &total;
        }
    }
    Parameters { values, exact: true, decimals: None }
}

/// Edges of a polygon without edges of length 0.
struct Polygon {
    /// |P_{i+1} − P_i|²
    squares: Vec<Rational>,
    /// The scalar products of neighbouring edges.
    products: Vec<Rational>,
}

impl Polygon {
    fn new(points: &[Vec<Rational>]) -> Result<Self, InterpolationError> {
        let edge = |pair: &[Vec<Rational>]| pair[1].iter().zip(&pair[0]).map(|(x, y)| x - y).collect();
        let edges: Vec<Vec<Rational>> = points.windows(2).map(edge).collect();
        if let Some(index) = edges.iter().position(|edge| edge.iter().all(Zero::is_zero)) {
            return Err(InterpolationError::CoincidentPoints { index });
        }
        let dot = |a: &[Rational], b: &[Rational]| {
            budget::step();
            a.iter().zip(b).fold(Rational::zero(), |sum, (x, y)| sum + x * y)
        };
        Ok(Polygon {
            squares: edges.iter().map(|edge| dot(edge, edge)).collect(),
            products: edges.windows(2).map(|pair| dot(&pair[0], &pair[1])).collect(),
        })
    }

    /// The first edge after which the polygon turns.
    fn first_turn(&self) -> Option<usize> {
        self.products.iter().enumerate().position(|(i, product)| self.turn(i, product).is_some())
    }

    /// Between edges i and i + 1: `None` if they have one direction, else the square of the
    /// tangent of the turning angle if that is less than π/2.
    fn turn(&self, i: usize, product: &Rational) -> Option<Option<Rational>> {
        if *product <= Rational::zero() {
            return Some(None);
        }
        let square = product * product;
        let cross = &self.squares[i] * &self.squares[i + 1] - &square;
        (!cross.is_zero()).then(|| Some(cross / square))
    }

    /// The Δ_i, or for the unit interval Δ_i/Δ_0, if they are rational.
    fn exact_steps(
        &self,
        method: Parameterization,
        scale: Scale,
    ) -> Result<Vec<Rational>, InterpolationError> {
        if method == Parameterization::Foley
            && let Some(segment) = self.first_turn()
        {
            let why = "turns into the next one by an angle that is not 0";
            return Err(InterpolationError::Irrational { segment, why });
        }
        let unit = match scale {
            Scale::Unit => self.squares[0].clone(),
            Scale::Sum => Rational::one(),
        };
        let centripetal = method == Parameterization::Centripetal;
        let step = |(segment, square): (usize, &Rational)| {
            budget::step();
            let chord = root(&(square / &unit));
            let step = if centripetal { chord.as_ref().and_then(root) } else { chord };
            step.ok_or(InterpolationError::Irrational {
                segment,
                why: match (scale, centripetal) {
                    (Scale::Unit, false) => "has an irrational ratio to the length of segment 0",
                    (Scale::Unit, true) => {
                        "has a length whose ratio to that of segment 0 has no rational root"
                    }
                    (Scale::Sum, false) => "has an irrational length",
                    (Scale::Sum, true) => "has a length without rational root",
                },
            })
        };
        self.squares.iter().enumerate().map(step).collect()
    }

    /// Bounds of all Δ_i, with about `digits` digits behind the point.
    fn bounds(&self, method: Parameterization, digits: u32) -> Vec<Bounds> {
        budget::charge_bits(u64::from(digits).saturating_mul(16));
        if method == Parameterization::Centripetal {
            return self.squares.iter().map(|square| Bounds::fourth_root(square, digits)).collect();
        }
        let chords: Vec<Bounds> =
            self.squares.iter().map(|square| Bounds::square_root(square, digits)).collect();
        if method == Parameterization::Chord {
            return chords;
        }
        let half_pi = Bounds::half_pi(digits);
        let mut steps = chords.clone();
        for (i, product) in self.products.iter().enumerate() {
            budget::step();
            let angle = match self.turn(i, product) {
                None => continue,
                Some(None) => half_pi.clone(),
                Some(Some(square)) => Bounds::arctan_of_root(&square, digits),
            };
            // (3/2) θ̂ d_{i} d_{i+1}/(d_i + d_{i+1}) belongs to the edges on both sides.
            let longer = chords[i].harmonic(&chords[i + 1]).times(&angle).scaled(&rational(3, 2));
            steps[i] = steps[i].plus(&longer);
            steps[i + 1] = steps[i + 1].plus(&longer);
        }
        steps
    }

    fn rounded(
        &self,
        method: Parameterization,
        scale: Scale,
        decimals: u32,
    ) -> Result<Parameters, InterpolationError> {
        budget::charge_bits(u64::from(decimals).saturating_mul(16));
        let n = self.squares.len();
        let mut digits = decimals.saturating_add(10);
        let values = loop {
            let steps = self.bounds(method, digits);
            let values: Option<Vec<Rational>> =
                sums(&steps, scale).iter().map(|bounds| bounds.settled(decimals)).collect();
            if let Some(values) = values {
                break values;
            }
            digits = digits.saturating_mul(2);
        };
        match (0..n).find(|&i| values[i] >= values[i + 1]) {
            Some(index) => Err(InterpolationError::TooFewDecimals { index, decimals }),
            None => Ok(Parameters { values, exact: false, decimals: Some(decimals) }),
        }
    }
}

/// Bounds of 0, Δ_0, Δ_0 + Δ_1, …, or of these divided by the last.
fn sums(steps: &[Bounds], scale: Scale) -> Vec<Bounds> {
    let zero = || Bounds::exactly(Rational::zero());
    let mut before = vec![zero()];
    for step in steps {
        budget::step();
        before.push(before[before.len() - 1].plus(step));
    }
    if scale == Scale::Sum {
        return before;
    }
    let mut after = vec![zero()];
    for step in steps.iter().rev() {
        after.push(after[after.len() - 1].plus(step));
    }
    after.reverse();
    let mut values: Vec<Bounds> = before.iter().zip(&after).map(|(left, right)| left.part(right)).collect();
    values[0] = zero();
    values[steps.len()] = Bounds::exactly(Rational::one());
    values
}

/// 10^digits
fn power_of_ten(digits: u32) -> Int {
    Int::from(10).pow(digits)
}
