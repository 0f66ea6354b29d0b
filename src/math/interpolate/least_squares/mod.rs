//! Least squares by the normal equations, exactly.
//!
//! **Definition.** For a matrix A with m rows, right sides b and weights w_i ≥ 0, W = diag(w), the c
//! that makes Σ w_i |b_i − (A c)_i|² least solves A^T W A c = A^T W b: the residual r = b − A c is
//! orthogonal to the columns of A, A^T W r = 0. Under conditions G c = g there are multipliers λ
//! with A^T W A c + G^T λ = A^T W b, so that A^T W r = G^T λ.
//!
//! For a polynomial the entries of A are the values of basis functions at the nodes. In floating
//! point the normal equations square the condition number; exactly that costs nothing.
//!
//! References: Å. Björck, *Numerical Methods for Least Squares Problems* (1996), sections 1.1
//! and 5.1; P. J. Davis, *Interpolation and Approximation* (1975), chapter VIII.

#[cfg(test)]
mod tests;

use nalgebra::DMatrix;
use num_traits::Signed;

use crate::budget;
use crate::math::basis::{Basis, change_of_basis, evaluate_basis};
use crate::math::interpolate::InterpolationError;
use crate::math::interpolate::datum::{
    Datum, as_many, combination, distinct, enough, fitting, same_dimension,
};
use crate::math::linalg::{multiply, rank, reduced_row_echelon, solve};
use crate::math::ring::Field;

/// The solution of a least squares problem, with everything on the way to it.
#[derive(Clone, Debug, PartialEq)]
pub struct LeastSquares<C, V = C> {
    /// A, one row for each datum, one column for each coefficient.
    pub matrix: DMatrix<C>,
    /// b
    pub right: Vec<V>,
    /// w, the diagonal of W.
    pub weights: Vec<C>,
    /// G, one row for each condition.
    pub condition_matrix: DMatrix<C>,
    /// g
    pub condition_values: Vec<V>,
    /// A^T W A
    pub normal_matrix: DMatrix<C>,
    /// A^T W b
    pub normal_right: Vec<V>,
    /// c
    pub coefficients: Vec<V>,
    /// λ, one for each condition.
    pub multipliers: Vec<V>,
    /// r = b − A c
    pub residuals: Vec<V>,
    /// Σ w_i |r_i|², over all coordinates of points.
    pub squared_norm: C,
}

impl<C: Field, V: Datum<C>> LeastSquares<C, V> {
    /// A^T W r − G^T λ: zero for the solution, the residual's orthogonality.
    #[cfg(test)]
    fn orthogonality(&self) -> Vec<V> {
        let column = |j: usize| {
            let weighted = (0..self.right.len()).map(|i| self.matrix[(i, j)].times(&self.weights[i]));
            let conditions = (0..self.multipliers.len()).map(|i| -self.condition_matrix[(i, j)].clone());
            let factors: Vec<C> = weighted.chain(conditions).collect();
            combination(factors.iter().zip(self.residuals.iter().chain(&self.multipliers)))
                .expect("there is at least one datum")
        };
        (0..self.matrix.ncols()).map(column).collect()
    }
}

/// Linear conditions G c = g on the coefficients.
#[derive(Clone, Debug, PartialEq)]
pub struct Conditions<C, V = C> {
    /// G, one row for each condition, one column for each coefficient.
    pub matrix: DMatrix<C>,
    /// g
    pub values: Vec<V>,
}

/// The c that makes Σ w_i |b_i − (A c)_i|² least.
///
/// `weights` are all 1 if not given; a datum of weight 0 counts for nothing. Numbers among the
/// weights must not be negative. Cost: m n² products and an exact solution of n equations.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::interpolate::least_squares;
/// use polarform::number::{integer as z, rational as q};
/// // the best constant is the mean
/// let fit = least_squares(&DMatrix::from_element(3, 1, z(1)), &[1, 2, 6].map(z), None)?;
/// assert_eq!(fit.coefficients, [z(3)]);
/// assert_eq!(fit.squared_norm, z(4 + 1 + 9));
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
///
/// # Errors
/// [`InterpolationError`] when there are no rows, the numbers of rows, right sides and weights
/// differ, a weight is negative, or the columns of A are dependent.
pub fn least_squares<C: Field, V: Datum<C>>(
    matrix: &DMatrix<C>,
    right: &[V],
    weights: Option<&[C]>,
) -> Result<LeastSquares<C, V>, InterpolationError> {
    let none = Conditions { matrix: DMatrix::zeros(0, matrix.ncols()), values: Vec::new() };
    least_squares_under(matrix, right, weights, &none)
}

/// The same among the c that satisfy G c = g exactly.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::interpolate::{Conditions, least_squares_under};
/// use polarform::number::integer as z;
/// // closest to (3, 1) on the line c_0 = c_1
/// let equal = Conditions { matrix: DMatrix::from_row_slice(1, 2, &[z(1), z(-1)]), values: vec![z(0)] };
/// let fit = least_squares_under(&DMatrix::identity(2, 2), &[z(3), z(1)], None, &equal)?;
/// assert_eq!(fit.coefficients, [z(2), z(2)]);
/// assert_eq!(fit.multipliers, [z(1)]);
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
///
/// # Errors
/// As [`least_squares`], and when the conditions are dependent or too many.
pub fn least_squares_under<C: Field, V: Datum<C>>(
    matrix: &DMatrix<C>,
    right: &[V],
    weights: Option<&[C]>,
    conditions: &Conditions<C, V>,
) -> Result<LeastSquares<C, V>, InterpolationError> {
    let (rows, columns) = matrix.shape();
    let count = conditions.values.len();
    enough(rows, 1)?;
    as_many("right sides", right.len(), rows)?;
    as_many("rows of conditions", conditions.matrix.nrows(), count)?;
    as_many("columns of conditions", conditions.matrix.ncols(), columns)?;
    same_dimension(right)?;
    fitting("condition", &conditions.values, &right[0])?;
    let weights = weights.map_or_else(|| vec![C::one(); rows], <[C]>::to_vec);
    check_weights(&weights, rows)?;
    check_conditions(&conditions.matrix)?;

    let weighted = DMatrix::from_fn(columns, rows, |j, i| matrix[(i, j)].times(&weights[i]));
    let normal_matrix = multiply(&weighted, matrix).expect("both have as many columns and rows as data");
    let normal_right: Vec<V> = (0..columns)
        .map(|j| combination(weighted.row(j).iter().zip(right)).expect("there is at least one datum"))
        .collect();

    // [A^T W A  G^T; G  0] [c; λ] = [A^T W b; g]
    let size = columns + count;
    budget::charge_terms((size as u64).saturating_mul(size as u64));
    let given = &conditions.matrix;
    let system = DMatrix::from_fn(size, size, |i, j| match (i < columns, j < columns) {
        (true, true) => normal_matrix[(i, j)].clone(),
        (true, false) => given[(j - columns, i)].clone(),
        (false, true) => given[(i - columns, j)].clone(),
        (false, false) => C::zero(),
    });
    let dimension = right[0].dimension();
    let entries = normal_right.iter().chain(&conditions.values).flat_map(|v| v.coordinates().iter().cloned());
    let right_matrix = DMatrix::from_row_iterator(size, dimension, entries);
    let Ok(solution) = solve(&system, &right_matrix) else {
        return Err(dependent(matrix, &weights, given, &system));
    };
    let mut coefficients: Vec<V> =
        solution.row_iter().map(|row| V::from_coordinates(row.iter().cloned().collect())).collect();
    let multipliers = coefficients.split_off(columns);

    let residual = |(i, b): (usize, &V)| match combination(matrix.row(i).iter().zip(&coefficients)) {
        Some(value) => b.less(&value),
        None => b.clone(),
    };
    let residuals: Vec<V> = right.iter().enumerate().map(residual).collect();
    let squared_norm = residuals.iter().zip(&weights).fold(C::zero(), |sum, (r, w)| {
        let square = r.coordinates().iter().fold(C::zero(), |sum, x| sum.plus(&x.times(x)));
        sum.plus(&square.times(w))
    });
    Ok(LeastSquares {
        matrix: matrix.clone(),
        right: right.to_vec(),
        weights,
        condition_matrix: given.clone(),
        condition_values: conditions.values.clone(),
        normal_matrix,
        normal_right,
        coefficients,
        multipliers,
        residuals,
        squared_norm,
    })
}

fn check_weights<C: Field>(weights: &[C], rows: usize) -> Result<(), InterpolationError> {
    as_many("weights", weights.len(), rows)?;
    let negative = |w: &C| w.as_rational().is_some_and(|q| q.is_negative());
    match weights.iter().position(negative) {
        Some(index) => Err(InterpolationError::NegativeWeight { index }),
        None => Ok(()),
    }
}

/// The rows of G are independent.
fn check_conditions<C: Field>(given: &DMatrix<C>) -> Result<(), InterpolationError> {
    let (conditions, unknowns) = given.shape();
    if conditions > unknowns {
        return Err(InterpolationError::TooManyConditions { conditions, unknowns });
    }
    // The pivots of the transpose are the rows that are no combination of those before them.
    let pivots = reduced_row_echelon(&given.transpose()).pivots;
    match (0..conditions).find(|&index| pivots.get(index) != Some(&index)) {
        Some(index) => Err(InterpolationError::DependentCondition { index }),
        None => Ok(()),
    }
}

/// Why the system is singular: some column of A, in the rows that count and those of G together,
/// is a combination of the columns before it, or weights that are symbols cancel.
fn dependent<C: Field>(
    matrix: &DMatrix<C>,
    weights: &[C],
    given: &DMatrix<C>,
    system: &DMatrix<C>,
) -> InterpolationError {
    let unknowns = matrix.ncols();
    let kept: Vec<usize> = (0..weights.len()).filter(|&i| !weights[i].is_zero()).collect();
    let stacked = DMatrix::from_fn(kept.len() + given.nrows(), unknowns, |i, j| match kept.get(i) {
        Some(&row) => matrix[(row, j)].clone(),
        None => given[(i - kept.len(), j)].clone(),
    });
    let pivots = reduced_row_echelon(&stacked).pivots;
    match (0..unknowns).find(|&column| pivots.get(column) != Some(&column)) {
        Some(column) => InterpolationError::DependentColumns { column },
        None => InterpolationError::Singular { unknowns: system.nrows(), rank: rank(system) },
    }
}

/// How a polynomial is to be fitted.
#[derive(Clone, PartialEq)]
pub struct FitOptions<C, V = C> {
    /// The basis of the coefficients: powers, or the Bernstein basis over an interval, or any
    /// other. The polynomial does not depend on it.
    pub basis: Basis<C>,
    /// Weights of the data; all 1 if not given.
    pub weights: Option<Vec<C>>,
    /// Pairs (x, y) with f(x) = y, which hold exactly.
    pub conditions: Vec<(C, V)>,
}

debug_by_fields!(FitOptions<V>: basis, weights, conditions);

impl<C, V> Default for FitOptions<C, V> {
    /// Powers, equal weights, no conditions.
    fn default() -> Self {
        FitOptions { basis: Basis::Power, weights: None, conditions: Vec::new() }
    }
}

/// A polynomial fitted to data by least squares.
#[derive(Clone, PartialEq)]
pub struct PolynomialFit<C, V = C> {
    /// The basis of the coefficients.
    pub basis: Basis<C>,
    /// The solution: `coefficients` are those in the basis.
    pub solution: LeastSquares<C, V>,
    /// The power coefficients, lowest first.
    pub power: Vec<V>,
}

debug_by_fields!(PolynomialFit<V>: basis, solution, power);

/// The polynomial of degree at most `degree` with the least Σ w_i |y_i − f(x_i)|².
///
/// Nodes may repeat (several measurements at one place). Cost: that of [`least_squares`].
///
/// ```
/// use polarform::basis::Basis;
/// use polarform::interpolate::{FitOptions, fit_polynomial};
/// use polarform::interval::Interval;
/// use polarform::number::{integer as z, rational as q};
/// // the straight line closest to 0, 1, 1, 2 at 0, 1, 2, 3
/// let fit = fit_polynomial(&[0, 1, 2, 3].map(z), &[0, 1, 1, 2].map(z), 1, FitOptions::default())?;
/// assert_eq!(fit.power, [q(1, 10), q(3, 5)]);
/// assert_eq!(fit.solution.squared_norm, q(1, 5));
/// // the same line by its Bézier ordinates over [0, 3]
/// let options = FitOptions { basis: Basis::Bernstein(Interval::new(z(0), z(3)).unwrap()), ..FitOptions::default() };
/// let fit = fit_polynomial(&[0, 1, 2, 3].map(z), &[0, 1, 1, 2].map(z), 1, options)?;
/// assert_eq!(fit.solution.coefficients, [q(1, 10), q(19, 10)]);
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
///
/// # Errors
/// As [`least_squares_under`]; [`InterpolationError::TooFewNodes`] when nodes of weight other than
/// 0 and places of conditions together are fewer than degree + 1 distinct ones;
/// [`InterpolationError::EqualNodes`] when two conditions are at one place;
/// [`InterpolationError::Basis`].
pub fn fit_polynomial<C: Field, V: Datum<C>>(
    nodes: &[C],
    values: &[V],
    degree: usize,
    options: FitOptions<C, V>,
) -> Result<PolynomialFit<C, V>, InterpolationError> {
    let FitOptions { basis, weights, conditions } = options;
    enough(nodes.len(), 1)?;
    as_many("values", values.len(), nodes.len())?;
    basis.validate(degree)?;
    if let Some(weights) = &weights {
        check_weights(weights, nodes.len())?;
    }
    let (places, targets): (Vec<C>, Vec<V>) = conditions.into_iter().unzip();
    distinct(&places)?;
    let unknowns = degree.saturating_add(1);
    if places.len() > unknowns {
        return Err(InterpolationError::TooManyConditions { conditions: places.len(), unknowns });
    }
    let counts = |i: &usize| weights.as_ref().is_none_or(|weights| !weights[*i].is_zero());
    let mut seen = places.clone();
    for i in (0..nodes.len()).filter(counts) {
        budget::step();
        // More distinct nodes than coefficients need not be told apart.
        if seen.len() < unknowns && !seen.contains(&nodes[i]) {
            seen.push(nodes[i].clone());
        }
    }
    if seen.len() < unknowns {
        return Err(InterpolationError::TooFewNodes { degree, distinct: seen.len() });
    }
    let matrix = values_at(nodes, degree, &basis)?;
    let given = Conditions { matrix: values_at(&places, degree, &basis)?, values: targets };
    let solution = least_squares_under(&matrix, values, weights.as_deref(), &given)?;
    let to_power = change_of_basis(degree, &basis, &Basis::Power)?;
    let row = |i: usize| combination(to_power.row(i).iter().zip(&solution.coefficients));
    let power = (0..=degree).map(|i| row(i).expect("there is at least one coefficient")).collect();
    Ok(PolynomialFit { basis, solution, power })
}

/// The matrix of φ_j(x_i).
fn values_at<C: Field>(
    nodes: &[C],
    degree: usize,
    basis: &Basis<C>,
) -> Result<DMatrix<C>, InterpolationError> {
    budget::charge_terms((nodes.len() as u64).saturating_mul((degree as u64).saturating_add(1)));
    let mut entries = Vec::new();
    for node in nodes {
        entries.extend(evaluate_basis(degree, basis, node)?);
    }
    Ok(DMatrix::from_row_iterator(nodes.len(), degree + 1, entries))
}
