//! Gram matrices of Bernstein polynomials and B-splines, and the energies of curves.
//!
//! B_i^m B_j^n = C(m,i) C(n,j)/C(m+n,i+j) B_{i+j}^{m+n}, and each B_k^N has the integral 1/(N+1) over [0, 1].
//! Derivatives are differences of coefficients; B-splines are combinations of Bernstein polynomials on
//! each knot interval.

use nalgebra::DMatrix;

use crate::budget;
use crate::math::curve::{BezierCurve, Interval};
use crate::math::linalg::multiply;
use crate::math::number::{Int, Rational, binomial_row};
use crate::math::ring::Field;
use crate::math::spline::{BSpline, KnotVector, SplineError};

/// ∫ B_i^m B_j^n over [0, 1], (m+1)×(n+1).
pub(super) fn unit_gram(m: usize, n: usize) -> DMatrix<Rational> {
    budget::charge_terms((m as u64 + 1).saturating_mul(n as u64 + 1));
    let (rows, columns, whole) = (binomial_row(m), binomial_row(n), binomial_row(m + n));
    let share = Int::from(m + n + 1);
    DMatrix::from_fn(m + 1, n + 1, |i, j| {
        budget::step();
        Rational::new(&rows[i] * &columns[j], &whole[i + j] * &share)
    })
}

/// The matrix from Bézier points over [0, 1] to those of the r-th derivative: n!/(n−r)! Δ^r, with
/// n + 1 − r rows; none for r > n.
fn difference_matrix(n: usize, r: usize) -> DMatrix<Rational> {
    let binomials = binomial_row(r);
    let falling = (0..r).fold(Int::ONE, |product, k| product * Int::from(n.saturating_sub(k)));
    DMatrix::from_fn((n + 1).saturating_sub(r), n + 1, |i, j| match j.checked_sub(i).filter(|k| *k <= r) {
        Some(k) => {
            let value = &binomials[k] * &falling;
            Rational::from_integer(if (r - k).is_multiple_of(2) { value } else { -value })
        }
        None => Rational::from_integer(Int::from(0usize)),
    })
}

/// The Gram matrix of the r-th derivatives over [0, 1].
fn unit_gram_of_derivatives(n: usize, r: usize) -> DMatrix<Rational> {
    if r > n {
        return DMatrix::from_element(n + 1, n + 1, Rational::from_integer(Int::from(0usize)));
    }
    let differences = difference_matrix(n, r);
    let half = multiply(&differences.transpose(), &unit_gram(n - r, n - r));
    multiply(&half.expect("the shapes fit"), &differences).expect("the shapes fit")
}

/// width^(1 − 2r)
fn stretch<C: Field>(interval: &Interval<C>, r: usize) -> C {
    let (a, b) = interval.ends();
    let inverse = num_traits::pow(interval.inverse_width().clone(), 2 * r);
    b.minus(a).times(&inverse)
}

/// ∫ (d/dt)^r B_i^n (d/dt)^r B_j^n over an interval, for the Bernstein polynomials of that interval:
/// (n+1)×(n+1); the mass matrix for r = 0, the stiffness matrix for r = 1.
///
/// Cost: O(n²) quotients for r = 0, else two products of (n+1)×(n+1) matrices of numbers.
///
/// ```
/// use polarform::approximation::bernstein_gram;
/// use polarform::curve::Interval;
/// use polarform::number::{integer as z, rational as q};
/// let mass = bernstein_gram(1, &Interval::new(z(0), z(3))?, 0);
/// assert_eq!(mass.as_slice(), [q(1, 1), q(1, 2), q(1, 2), q(1, 1)]);
/// let stiffness = bernstein_gram(1, &Interval::new(z(0), z(3))?, 1);
/// assert_eq!(stiffness.as_slice(), [q(1, 3), q(-1, 3), q(-1, 3), q(1, 3)]);
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn bernstein_gram<C: Field>(n: usize, interval: &Interval<C>, r: usize) -> DMatrix<C> {
    let factor = stretch(interval, r);
    unit_gram_of_derivatives(n, r).map(|q| factor.scaled(&q))
}

/// ∫ (d/dt)^r N_i^n (d/dt)^r N_j^n over the domain [t_n, t_m]: m×m, zero where the supports do not meet
/// (|i − j| > n). At a knot where a derivative jumps, only the pieces beside it count.
///
/// Cost: for each knot interval two products of (n+1)×(n+1) matrices.
///
/// # Errors
/// [`SplineError::NoDomain`].
///
/// ```
/// use polarform::approximation::spline_gram;
/// use polarform::interval::Interval;
/// use polarform::number::{integer as z, rational as q};
/// use polarform::spline::KnotVector;
/// // hat functions over 0, 1, 2
/// let hats = KnotVector::clamped(1, &[z(1)], &Interval::new(z(0), z(2))?)?;
/// let mass = spline_gram(&hats, 0)?;
/// assert_eq!(mass.row(1).iter().cloned().collect::<Vec<_>>(), [q(1, 6), q(2, 3), q(1, 6)]);
/// # Ok::<(), polarform::spline::SplineError>(())
/// ```
pub fn spline_gram<C: Field>(knots: &KnotVector<C>, r: usize) -> Result<DMatrix<C>, SplineError> {
    knots.interval()?;
    let (m, n) = (knots.count(), knots.degree());
    budget::charge_terms((m as u64).saturating_mul(m as u64));
    let unit = unit_gram_of_derivatives(n, r).map(|q| C::from_rational(&q));
    let mut gram = DMatrix::zeros(m, m);
    for span in knots.spans() {
        let interval = Interval::new(knots.knots()[span].clone(), knots.knots()[span + 1].clone())?;
        let factor = stretch(&interval, r);
        let extraction = knots.extraction(span)?;
        let half = multiply(&extraction.transpose(), &unit).expect("both are (n+1)×(n+1)");
        let local = multiply(&half, &extraction).expect("both are (n+1)×(n+1)");
        for i in 0..=n {
            for j in 0..=n {
                gram[(span - n + i, span - n + j)] += local[(i, j)].times(&factor);
            }
        }
    }
    Ok(gram)
}

/// The coefficients of the dual basis: D_j = Σ_i c_ij B_i^n has ∫ D_j B_i^n = 1 over [0, 1] for i = j, else
/// 0. The inverse of the Gram matrix in closed form (Jüttler 1998, theorem 3):
/// c_ij = (−1)^(i+j)/(C(n,i) C(n,j)) Σ_k (2k+1) C(n+k+1,n−i) C(n−k,n−i) C(n+k+1,n−j) C(n−k,n−j), k ≤ min(i, j).
///
/// Over [a, b] divide by b − a. Cost: n³/6 products.
///
/// ```
/// use polarform::approximation::dual_bernstein;
/// use polarform::number::integer as z;
/// // 4 B_0 − 2 B_1 and −2 B_0 + 4 B_1
/// assert_eq!(dual_bernstein(1).as_slice(), [4, -2, -2, 4].map(z));
/// ```
pub fn dual_bernstein(n: usize) -> DMatrix<Rational> {
    budget::charge_terms((n as u64 + 1).saturating_mul(n as u64 + 1));
    let row = binomial_row(n);
    // term[k][i] = C(n+k+1, n−i) C(n−k, n−i), for k ≤ i
    let terms: Vec<Vec<Int>> = (0..=n)
        .map(|k| {
            let (upper, lower) = (binomial_row(n + k + 1), binomial_row(n - k));
            (k..=n).map(|i| &upper[n - i] * &lower[n - i]).collect()
        })
        .collect();
    DMatrix::from_fn(n + 1, n + 1, |i, j| {
        let sum = (0..=i.min(j)).fold(Int::from(0usize), |sum, k| {
            budget::step();
            sum + &(&terms[k][i - k] * &terms[k][j - k]) * &Int::from(2 * k + 1)
        });
        let value = Rational::new(sum, &row[i] * &row[j]);
        if (i + j).is_multiple_of(2) { value } else { -value }
    })
}

/// ∫ |c^(r)(t)|² dt over the interval of a curve, all coordinates together.
///
/// Cost: n² products.
///
/// ```
/// use polarform::approximation::energy;
/// use polarform::curve::{BezierCurve, Interval};
/// use polarform::number::{integer as z, rational as q};
/// let c = BezierCurve::new(vec![[z(0), z(0)], [z(0), z(1)], [z(1), z(1)]], Interval::unit())?;
/// assert_eq!(energy(&c, 2), z(8)); // c'' = (2, −2)
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn energy<C: Field>(curve: &BezierCurve<C>, r: usize) -> C {
    let derived = curve.nth_derivative(r);
    (0..derived.dimension()).fold(C::zero(), |sum, k| {
        let coordinate: Vec<Vec<C>> = derived.points().iter().map(|point| vec![point[k].clone()]).collect();
        let function = BezierCurve::new(coordinate, derived.interval().clone()).expect("as many points");
        let square = function.product(&function).expect("both have one coordinate");
        sum.plus(&square.integral()[0])
    })
}

/// The same of a spline over its domain, piece by piece.
///
/// ```
/// use polarform::approximation::spline_energy;
/// use polarform::interval::Interval;
/// use polarform::number::integer as z;
/// use polarform::spline::{BSpline, KnotVector};
/// let knots = KnotVector::clamped(1, &[z(1)], &Interval::new(z(0), z(3))?)?;
/// let s = BSpline::new(knots, [0, 2, 0].map(|y| vec![z(y)]).to_vec())?;
/// assert_eq!(spline_energy(&s, 1), z(4 + 2));
/// # Ok::<(), polarform::spline::SplineError>(())
/// ```
pub fn spline_energy<C: Field>(spline: &BSpline<C>, r: usize) -> C {
    spline.bezier_pieces().iter().fold(C::zero(), |sum, piece| sum.plus(&energy(piece, r)))
}
