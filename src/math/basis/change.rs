//! Change of basis.
//!
//! Both sides go through powers of t − o. On the way there each basis has a point o
//! about which its functions are simplest: the start of its interval, its first node.
//! The other basis is moved by −o (all definitions are invariant under translation), so
//! that nothing is expanded only to cancel again: symbolic ends stay factored, and large
//! numbers that are close together stay small.
//!
//! From powers, no basis needs a division by anything but integers: values by Horner's
//! scheme (Lagrange), repeated division by t − x_k (Newton and Taylor: the remainders are
//! the coefficients), derivatives (Hermite), substitution and A_n^{-1} (Bernstein).

use nalgebra::DMatrix;
use num_traits::Zero;

use super::bernstein::powers;
use super::evaluate::reciprocal;
use super::legendre::{legendre_to_power, power_to_legendre};
use super::{Basis, BasisError, bernstein_to_power, power_to_bernstein};
use crate::budget;
use crate::math::interval::Interval;
use crate::math::linalg::multiply;
use crate::math::number::{Int, Rational, factorial};
use crate::math::poly::Coefficients;
use crate::math::ring::Field;

/// The matrix M that takes coefficients in one basis to coefficients in another.
///
/// (n+1)×(n+1), c_to = M c_from for every polynomial of degree at most n; column j has the
/// coefficients of the j-th function of `from`. Cost: O(n³) products and sums at most,
/// O(n²) between powers and Bernstein polynomials at the same point.
///
/// # Errors
/// [`BasisError`] as by [`Basis::validate`].
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::basis::{Basis, change_of_basis};
/// use polarform::interval::Interval;
/// use polarform::number::integer as z;
/// let bezier = Basis::Bernstein(Interval::unit());
/// let hermite = Basis::HermiteEndpoints(Interval::unit());
/// // f(0) = b_0, f'(0) = 3 (b_1 − b_0), f(1) = b_3, f'(1) = 3 (b_3 − b_2)
/// assert_eq!(change_of_basis(3, &bezier, &hermite), Ok(DMatrix::from_row_slice(4, 4, &[
///     z(1), z(0), z(0), z(0),
///     z(-3), z(3), z(0), z(0),
///     z(0), z(0), z(0), z(1),
///     z(0), z(0), z(-3), z(3)
/// ])));
/// ```
pub fn change_of_basis<F: Field>(n: usize, from: &Basis<F>, to: &Basis<F>) -> Result<DMatrix<F>, BasisError> {
    from.validate(n)?;
    to.validate(n)?;
    let size = (n as u64).saturating_add(1);
    budget::charge_terms(size.saturating_mul(size));
    let Local { origin, columns } = local_polynomials(n, from);
    let target = Target::new(n, &to.translated(&origin));
    let entries = columns.into_iter().flat_map(|column| target.coefficients(column)).collect();
    Ok(DMatrix::from_vec(n + 1, n + 1, entries))
}

impl<F: Field> Basis<F> {
    /// The basis of the functions φ_j(t + by).
    fn translated(&self, by: &F) -> Basis<F> {
        if by.is_zero() {
            return self.clone();
        }
        let moved = |x: &F| x.minus(by);
        let shifted = |interval: &Interval<F>| interval.moved(&-by.clone());
        match self {
            Basis::Power => Basis::Taylor { at: -by.clone() },
            Basis::Taylor { at } => Basis::Taylor { at: moved(at) },
            Basis::Bernstein(interval) => Basis::Bernstein(shifted(interval)),
            Basis::Legendre(interval) => Basis::Legendre(shifted(interval)),
            Basis::Lagrange(nodes) => Basis::Lagrange(nodes.iter().map(moved).collect()),
            Basis::Newton(nodes) => Basis::Newton(nodes.iter().map(moved).collect()),
            Basis::HermiteEndpoints(interval) => Basis::HermiteEndpoints(shifted(interval)),
        }
    }
}

/// Polynomials as coefficients of the powers of t − origin, lowest first, n+1 for each.
struct Local<F> {
    origin: F,
    columns: Vec<Vec<F>>,
}

/// The functions of a validated basis.
fn local_polynomials<F: Field>(n: usize, basis: &Basis<F>) -> Local<F> {
    match basis {
        Basis::Power => Local { origin: F::zero(), columns: unit_columns(n) },
        Basis::Taylor { at } => Local { origin: at.clone(), columns: unit_columns(n) },
        Basis::Bernstein(interval) => {
            let matrix = bernstein_to_power(n);
            let columns = stretched(&matrix, &vec![0; n + 1], &interval.width());
            Local { origin: interval.start().clone(), columns }
        }
        Basis::Legendre(interval) => {
            let columns = stretched(&legendre_to_power(n), &vec![0; n + 1], &interval.width());
            Local { origin: interval.start().clone(), columns }
        }
        Basis::HermiteEndpoints(interval) => {
            let matrix = multiply(&bernstein_to_power(n), &hermite_to_bernstein(n));
            let orders: Vec<usize> = (0..=n / 2).chain(0..=n / 2).collect();
            let columns = stretched(&matrix.expect("both are (n+1)×(n+1)"), &orders, &interval.width());
            Local { origin: interval.start().clone(), columns }
        }
        Basis::Newton(nodes) => {
            let origin = nodes.first().cloned().unwrap_or_else(F::zero);
            let mut product = Coefficients::constant(F::one());
            let mut columns = Vec::with_capacity(n + 1);
            for node in &nodes[..n] {
                columns.push(product.clone().padded(n));
                product.multiply_by_root(&node.minus(&origin));
            }
            columns.push(product.into_vec());
            Local { origin, columns }
        }
        Basis::Lagrange(nodes) => lagrange_polynomials(nodes),
    }
}

fn unit_columns<F: Field>(n: usize) -> Vec<Vec<F>> {
    let unit = |j| (0..=n).map(|i| if i == j { F::one() } else { F::zero() }).collect();
    (0..=n).map(unit).collect()
}

/// The columns of M after the substitution t → t/h, where column j is a derivative of
/// order `orders[j]`: entries M_ij h^(orders[j] − i).
fn stretched<F: Field>(matrix: &DMatrix<Rational>, orders: &[usize], h: &F) -> Vec<Vec<F>> {
    let n = matrix.nrows() - 1;
    let up = powers(orders.iter().copied().max().unwrap_or(0), h);
    let down = powers(n, &reciprocal(h));
    let entry = |(i, q): (usize, &Rational), order: usize| {
        budget::step();
        if q.is_zero() {
            F::zero()
        } else if i < order {
            up[order - i].scaled(q)
        } else {
            down[i - order].scaled(q)
        }
    };
    let column = |(j, &order): (usize, &usize)| {
        matrix.column(j).iter().enumerate().map(|item| entry(item, order)).collect()
    };
    orders.iter().enumerate().map(column).collect()
}

/// The Bézier ordinates over [0, 1] for f^{(k)}(0) and f^{(k)}(1), k < m = (n+1)/2:
/// b_i = Σ_k C(i,k) (n−k)!/n! f^{(k)}(0) and b_{n−i} = Σ_k (−1)^k C(i,k) (n−k)!/n! f^{(k)}(1)
/// for i < m (Farin 2002, section 5.3, solved for the ordinates).
fn hermite_to_bernstein(n: usize) -> DMatrix<Rational> {
    let m = n.div_ceil(2);
    let mut matrix = DMatrix::zeros(n + 1, n + 1);
    // C(i,k) (n−k)!/n!, from i = k down the column
    let mut first = Rational::new(Int::ONE, Int::ONE);
    for k in 0..m {
        let mut value = first.clone();
        for i in k..m {
            matrix[(i, k)] = value.clone();
            matrix[(n - i, m + k)] = if k % 2 == 0 { value.clone() } else { -&value };
            value *= Rational::new(Int::from(i + 1), Int::from(i + 1 - k));
        }
        first /= Int::from(n - k);
    }
    matrix
}

/// w(t)/(t − x_j) / w'(x_j) with w = ∏ (t − x_k), for each j.
fn lagrange_polynomials<F: Field>(nodes: &[F]) -> Local<F> {
    let origin = nodes.first().cloned().unwrap_or_else(F::zero);
    let nodes: Vec<F> = nodes.iter().map(|node| node.minus(&origin)).collect();
    let product = Coefficients::from_roots(&nodes);
    let column = |node: &F| {
        // The value of the quotient at x_j is w'(x_j).
        let (quotient, _) = product.divided_by_root(node);
        quotient.scaled(&reciprocal(&quotient.value(node))).into_vec()
    };
    Local { columns: nodes.iter().map(column).collect(), origin }
}

/// Divides by t − x_0, the quotient by t − x_1 and so on, in place: the k-th entry becomes
/// the k-th remainder, and the entries after the last node the last quotient.
fn divide_out<'a, F: Field>(polynomial: &mut [F], nodes: impl IntoIterator<Item = &'a F>) {
    let n = polynomial.len() - 1;
    for (k, node) in (0..n).zip(nodes) {
        if node.is_zero() {
            continue;
        }
        for i in (k..n).rev() {
            budget::step();
            if !polynomial[i + 1].is_zero() {
                let carried = polynomial[i + 1].times(node);
                polynomial[i] += carried;
            }
        }
    }
}

/// A basis to go to, with what is the same for all polynomials.
enum Target<F> {
    Power,
    Newton(Vec<F>),
    Lagrange(Vec<F>),
    /// Start of the interval, powers of its length, the matrix from powers of the local parameter.
    Stretched(F, Vec<F>, DMatrix<Rational>),
    /// The ends, and k! for the orders of derivatives.
    Hermite([F; 2], Vec<Rational>),
}

impl<F: Field> Target<F> {
    fn new(n: usize, basis: &Basis<F>) -> Self {
        match basis {
            Basis::Power => Target::Power,
            Basis::Taylor { at } => Target::Newton(vec![at.clone(); n]),
            Basis::Newton(nodes) => Target::Newton(nodes.clone()),
            Basis::Lagrange(nodes) => Target::Lagrange(nodes.clone()),
            Basis::Bernstein(interval) => Target::Stretched(
                interval.start().clone(),
                powers(n, &interval.width()),
                power_to_bernstein(n),
            ),
            Basis::Legendre(interval) => Target::Stretched(
                interval.start().clone(),
                powers(n, &interval.width()),
                power_to_legendre(n),
            ),
            Basis::HermiteEndpoints(interval) => {
                let factorials = (0..n.div_ceil(2)).map(|k| Rational::from_integer(factorial(k)));
                Target::Hermite([interval.start().clone(), interval.end().clone()], factorials.collect())
            }
        }
    }

    /// The coefficients of the polynomial with these power coefficients.
    fn coefficients(&self, mut polynomial: Vec<F>) -> Vec<F> {
        match self {
            Target::Power => polynomial,
            Target::Newton(nodes) => {
                divide_out(&mut polynomial, nodes);
                polynomial
            }
            Target::Lagrange(nodes) => {
                let polynomial = Coefficients::new(polynomial);
                nodes.iter().map(|node| polynomial.value(node)).collect()
            }
            Target::Stretched(start, lengths, matrix) => {
                divide_out(&mut polynomial, std::iter::repeat_n(start, lengths.len()));
                for (coefficient, power) in polynomial.iter_mut().zip(lengths) {
                    if !coefficient.is_zero() {
                        *coefficient *= power.clone();
                    }
                }
                apply(matrix, &polynomial)
            }
            Target::Hermite(ends, factorials) => {
                let at = |end: &F| {
                    let mut taylor = polynomial.clone();
                    divide_out(&mut taylor, std::iter::repeat_n(end, factorials.len()));
                    taylor.iter().zip(factorials).map(|(x, q)| x.scaled(q)).collect::<Vec<F>>()
                };
                ends.iter().flat_map(at).collect()
            }
        }
    }
}

/// The product of a triangular matrix and a column.
fn apply<F: Field>(matrix: &DMatrix<Rational>, column: &[F]) -> Vec<F> {
    let mut result = vec![F::zero(); column.len()];
    for (j, x) in column.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
        for (sum, entry) in result.iter_mut().zip(matrix.column(j)).filter(|(_, entry)| !entry.is_zero()) {
            budget::step();
            *sum += x.scaled(entry);
        }
    }
    result
}
