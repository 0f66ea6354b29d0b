//! Hermite interpolation: values and derivatives, any number of them at each node.
//!
//! **Definition.** At node x_i the values f(x_i), f'(x_i), …, f^{(m_i−1)}(x_i) are given,
//! m_i ≥ 1. There is exactly one polynomial of degree below Σ m_i with these values. Its Newton
//! form comes from divided differences with x_i repeated m_i times.
//!
//! For two nodes a < b the Bézier points over [a, b] can be written down at once: with n + 1 data,
//! b_i = Σ_{k≤i} C(i,k) (n−k)!/n! (b−a)^k f^{(k)}(a), and mirrored at b.
//!
//! References: J. Stoer, R. Bulirsch, *Introduction to Numerical Analysis* (2002), section
//! 2.1.5; G. Farin, *Curves and Surfaces for CAGD* (2002), section 7.5.

use super::InterpolationError;
use super::datum::{Datum, distinct, enough, fitting, same_dimension};
use super::newton::DividedDifferences;
use crate::budget;
use crate::math::interval::Interval;
use crate::math::number::{Int, Rational};
use crate::math::ring::Field;

impl<C: Field, V: Datum<C>> DividedDifferences<C, V> {
    /// The table for Hermite data: each node with f, f', f'', … there.
    ///
    /// ```
    /// use polarform::interpolate::DividedDifferences;
    /// use polarform::number::integer as z;
    /// // the smooth step: 0 and 1 with horizontal tangents, 3t^2 − 2t^3
    /// let table = DividedDifferences::hermite(&[(z(0), vec![z(0), z(0)]), (z(1), vec![z(1), z(0)])])?;
    /// assert_eq!(table.nodes(), [0, 0, 1, 1].map(z));
    /// assert_eq!(table.newton_form().to_power(), [0, 0, 3, -2].map(z));
    /// # Ok::<(), polarform::interpolate::InterpolationError>(())
    /// ```
    ///
    /// # Errors
    /// [`InterpolationError`] when there are no nodes, two are equal, one has no value, or a
    /// datum has another dimension than the first.
    pub fn hermite(data: &[(C, Vec<V>)]) -> Result<Self, InterpolationError> {
        enough(data.len(), 1)?;
        if let Some(index) = data.iter().position(|(_, values)| values.is_empty()) {
            return Err(InterpolationError::NoData { index });
        }
        let needed = data[0].1[0].dimension();
        for (node, (_, values)) in data.iter().enumerate() {
            if let Some(datum) = values.iter().position(|datum| datum.dimension() != needed) {
                let given = values[datum].dimension();
                return Err(InterpolationError::DatumDimensions { node, datum, given, needed });
            }
        }
        distinct(&data.iter().map(|(node, _)| node.clone()).collect::<Vec<C>>())?;
        let repeated = data.iter().flat_map(|(node, values)| std::iter::repeat_n(node.clone(), values.len()));
        let values: Vec<V> = data.iter().flat_map(|(_, values)| values.iter().cloned()).collect();
        Ok(Self::build(repeated.collect(), &values))
    }
}

/// The Hermite basis for nodes x_i with multiplicities m_i: the polynomials H_{i,k} dual to the
/// data, by their power coefficients.
///
/// Entry \[i\]\[k\] belongs to f^{(k)}(x_i): its k-th derivative is 1 at x_i, all other data are 0.
/// The interpolant is Σ f^{(k)}(x_i) H_{i,k}. Cost: O(n²) for each of the n + 1 polynomials.
///
/// ```
/// use polarform::interpolate::hermite_basis;
/// use polarform::number::integer as z;
/// let basis = hermite_basis(&[(z(0), 2), (z(1), 2)])?;
/// assert_eq!(basis[0][0], [1, 0, -3, 2].map(z));
/// assert_eq!(basis[1][1], [0, 0, -1, 1].map(z));
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
///
/// # Errors
/// As [`DividedDifferences::hermite`].
pub fn hermite_basis<C: Field>(nodes: &[(C, usize)]) -> Result<Vec<Vec<Vec<C>>>, InterpolationError> {
    let total = nodes.iter().fold(0u64, |sum, (_, m)| sum.saturating_add(*m as u64));
    budget::charge_terms(total.saturating_mul(total));
    let zeros: Vec<(C, Vec<C>)> = nodes.iter().map(|(x, m)| (x.clone(), vec![C::zero(); *m])).collect();
    DividedDifferences::hermite(&zeros)?;
    let polynomial = |i: usize, k: usize| {
        let mut data = zeros.clone();
        data[i].1[k] = C::one();
        Ok(DividedDifferences::hermite(&data)?.newton_form().to_power())
    };
    nodes.iter().enumerate().map(|(i, (_, m))| (0..*m).map(|k| polynomial(i, k)).collect()).collect()
}

/// The Bézier points over [a, b] of the polynomial with given f, f', f'', … at a and at b.
///
/// Two data at each end give a cubic, three a quintic; the numbers need not be equal, and one of
/// them may be 0. With n + 1 data in all, n + 1 points. Cost: n² products at most.
///
/// ```
/// use polarform::interpolate::hermite_bezier;
/// use polarform::interval::Interval;
/// use polarform::number::integer as z;
/// // b_1 = p_0 + m_0/3, b_2 = p_1 − m_1/3 over an interval of length 1
/// let points = hermite_bezier(&Interval::unit(), &[z(1), z(6)], &[z(4), z(3)])?;
/// assert_eq!(points, [1, 3, 3, 4].map(z));
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
///
/// # Errors
/// [`InterpolationError`] when there are no data, or their dimensions differ.
pub fn hermite_bezier<C: Field, V: Datum<C>>(
    interval: &Interval<C>,
    left: &[V],
    right: &[V],
) -> Result<Vec<V>, InterpolationError> {
    let count = left.len() + right.len();
    enough(count, 1)?;
    if let Some(first) = left.first() {
        fitting("datum", left.iter().chain(right), first)?;
    }
    same_dimension(right)?;
    budget::charge_terms(count as u64);
    let h = interval.width();
    let mut points = from_one_end(count - 1, left, &h);
    let mut mirrored = from_one_end(count - 1, right, &(-h));
    mirrored.reverse();
    points.append(&mut mirrored);
    Ok(points)
}

/// b_i = Σ_{k≤i} C(i,k) (n−k)!/n! h^k f^{(k)} for as many i as there are data.
fn from_one_end<C: Field, V: Datum<C>>(n: usize, data: &[V], h: &C) -> Vec<V> {
    // Forward differences at the end: Δ^k b_0 = (n−k)!/n! h^k f^{(k)}.
    let mut factor = C::one();
    let mut differences: Vec<V> = Vec::with_capacity(data.len());
    for (k, datum) in data.iter().enumerate() {
        differences.push(datum.multiple(&factor));
        if k < n {
            factor = factor.times(h).scaled(&Rational::new(Int::ONE, Int::from(n - k)));
        }
    }
    // Summing them up again, one order after the other.
    let mut points = Vec::with_capacity(data.len());
    while let Some(first) = differences.first() {
        points.push(first.clone());
        differences = differences.windows(2).map(|pair| pair[0].added(&pair[1])).collect();
        budget::steps(differences.len() as u32);
    }
    points
}

/// The derivatives f', f'', … at the start of Bézier points over [a, b]: the inverse of
/// [`hermite_bezier`] at one end, f^{(k)}(a) = n!/(n−k)! (b−a)^{−k} Δ^k b_0 for k = 0, …, orders.
///
/// # Errors
/// [`InterpolationError`] when a = b, or there are fewer than `orders` + 1 points.
#[cfg(test)]
pub(super) fn end_derivatives<C: Field, V: Datum<C>>(
    a: &C,
    b: &C,
    points: &[V],
    orders: usize,
) -> Result<Vec<V>, InterpolationError> {
    enough(points.len(), orders.saturating_add(1))?;
    same_dimension(points)?;
    let Some(inverse) = b.minus(a).inverse() else {
        return Err(InterpolationError::EqualNodes { first: 0, second: 1 });
    };
    let n = points.len() - 1;
    let mut differences = points[..=orders].to_vec();
    let mut factor = C::one();
    let mut derivatives = Vec::with_capacity(orders + 1);
    for k in 0..=orders {
        derivatives.push(differences[0].multiple(&factor));
        if k < n {
            factor = factor.times(&inverse).scaled(&Rational::from_integer(Int::from(n - k)));
        }
        differences = differences.windows(2).map(|pair| pair[1].less(&pair[0])).collect();
    }
    Ok(derivatives)
}
