//! A_n and its inverse, raising and lowering the degree: matrices in closed form.
//!
//! Entries come from their neighbours by a product and a quotient of one word each, in
//! lowest terms by construction, so no gcd of two long numbers is ever taken.

use nalgebra::DMatrix;
use num_integer::Integer;
use num_traits::{One, Zero};

use super::BasisError;
use crate::budget;
use crate::math::number::{Int, Rational, binomial_row};

/// A_n, which turns Bézier ordinates over [0, 1] into power coefficients.
///
/// f(t) = (1 t … t^n) A_n (b_0 … b_n)^T, (n+1)×(n+1), lower triangular with integer entries
/// (A_n)_{ij} = (−1)^{i−j} C(n,i) C(i,j) for j ≤ i (Farouki 2012, section 3).
///
/// Cost: n²/12 products and quotients by a word, n² copies: |(A_n)_{ij}| is the trinomial
/// coefficient n! / (j! (i−j)! (n−i)!), of whose six permutations only one is computed.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::basis::bernstein_to_power;
/// use polarform::number::integer as z;
/// assert_eq!(bernstein_to_power(2), DMatrix::from_row_slice(3, 3, &[
///     z(1), z(0), z(0),
///     z(-2), z(2), z(0),
///     z(1), z(-2), z(1)
/// ]));
/// ```
pub fn bernstein_to_power(n: usize) -> DMatrix<Rational> {
    let mut entries = zeros(n, n);
    // n!/(a! b! c!) for a ≤ b ≤ c, beginning with a = b = 0.
    let mut first = Int::ONE;
    for a in 0..=n / 3 {
        let mut value = first.clone();
        for b in a..=(n - a) / 2 {
            budget::step();
            let c = n - a - b;
            let negated = -&value;
            // (j, i−j, n−i) runs through the permutations; equal ones are harmless.
            for (j, difference) in [(a, b), (a, c), (b, a), (b, c), (c, a), (c, b)] {
                let signed = if difference.is_odd() { &negated } else { &value };
                entries[(j + difference, j)] = whole(signed.clone());
            }
            value *= Int::from(c);
            value = value.div_exact(&Int::from(b + 1));
        }
        // (a, a, c) -> (a+1, a+1, c−2)
        let c = n - 2 * a;
        if c >= 2 {
            first *= Int::from(c);
            first *= Int::from(c - 1);
            first = first.div_exact(&Int::from(a + 1)).div_exact(&Int::from(a + 1));
        }
    }
    entries
}

/// A_n^{-1}, which turns power coefficients into Bézier ordinates over [0, 1].
///
/// (n+1)×(n+1), lower triangular, rows for ordinates and columns for powers:
/// (A_n^{-1})_{ij} = C(i,j) / C(n,j) for j ≤ i (Farouki 2012, section 3).
///
/// Cost: n²/4 products and quotients by a word, n² copies: the entry equals the one in row
/// n−j and column n−i.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::basis::power_to_bernstein;
/// use polarform::number::rational as q;
/// assert_eq!(power_to_bernstein(2), DMatrix::from_row_slice(3, 3, &[
///     q(1, 1), q(0, 1), q(0, 1),
///     q(1, 1), q(1, 2), q(0, 1),
///     q(1, 1), q(1, 1), q(1, 1)
/// ]));
/// ```
pub fn power_to_bernstein(n: usize) -> DMatrix<Rational> {
    let mut entries = zeros(n, n);
    for (j, binomial) in binomial_row(n).into_iter().enumerate().take(n / 2 + 1) {
        let (mut numerator, mut denominator) = (Int::ONE, binomial);
        for i in j..=n - j {
            budget::step();
            let value = Rational::new_raw(numerator.clone(), denominator.clone());
            if n - j != i {
                entries[(n - j, n - i)] = value.clone();
            }
            entries[(i, j)] = value;
            // C(i+1, j) = C(i, j) (i+1)/(i+1−j)
            multiply_reduced(&mut numerator, &mut denominator, i + 1, i + 1 - j);
        }
    }
    entries
}

/// numerator/denominator ← numerator/denominator · up/down, all positive; lowest terms are kept.
fn multiply_reduced(numerator: &mut Int, denominator: &mut Int, up: usize, down: usize) {
    let common = up.gcd(&down);
    let (up, down) = (Int::from(up / common), Int::from(down / common));
    let across = |long: &mut Int, word: Int| {
        let common = word.gcd(long);
        *long = long.div_exact(&common);
        word.div_exact(&common)
    };
    let down = across(numerator, down);
    let up = across(denominator, up);
    *numerator *= up;
    *denominator *= down;
}

/// The matrix that raises the degree of Bézier ordinates from m to n.
///
/// (n+1)×(m+1), with entries C(m,j) C(n−m,i−j) / C(n,i) (Farin 2002, section 6.1, for
/// n = m+1). Equal to A_n^{-1} times A_m with n−m rows of zeros below. Each row sums to 1:
/// the new ordinates are means of the old ones. Cost: n (m+1) products, each with a gcd.
///
/// # Errors
/// [`BasisError::Degrees`] when m > n.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::basis::raising;
/// use polarform::number::rational as q;
/// assert_eq!(raising(1, 2), Ok(DMatrix::from_row_slice(3, 2, &[
///     q(1, 1), q(0, 1),
///     q(1, 2), q(1, 2),
///     q(0, 1), q(1, 1)
/// ])));
/// ```
pub fn raising(m: usize, n: usize) -> Result<DMatrix<Rational>, BasisError> {
    let gap = n.checked_sub(m).ok_or(BasisError::Degrees { from: m, to: n })?;
    let mut entries = zeros(n, m);
    let (before, between, after) = (binomial_row(m), binomial_row(gap), binomial_row(n));
    for j in 0..=m {
        for i in j..=j + gap {
            budget::step();
            entries[(i, j)] = Rational::new(&before[j] * &between[i - j], after[i].clone());
        }
    }
    Ok(entries)
}

/// The matrix that lowers the degree of Bézier ordinates from n to m.
///
/// (m+1)×(n+1), with entries (−1)^{i−j} C(n−m+i−j−1, i−j) C(n,j) / C(m,i) for j ≤ i, else 0.
/// It undoes [`raising`]: exact for polynomials of degree at most m. Of any other it keeps
/// the powers 1, t, …, t^m and drops the rest: it equals A_m^{-1} times the first m+1 rows
/// of A_n. Cost: m²/2 products, each with a gcd.
///
/// The formula: with weights C(n,i), ordinates are the coefficients of a polynomial in x,
/// raising multiplies that by (1+x)^{n−m}, and lowering by the power series of its inverse.
///
/// # Errors
/// [`BasisError::Degrees`] when m > n.
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::basis::lowering;
/// use polarform::number::integer as z;
/// assert_eq!(lowering(2, 1), Ok(DMatrix::from_row_slice(2, 3, &[z(1), z(0), z(0), z(-1), z(2), z(0)])));
/// ```
pub fn lowering(n: usize, m: usize) -> Result<DMatrix<Rational>, BasisError> {
    let gap = n.checked_sub(m).ok_or(BasisError::Degrees { from: n, to: m })?;
    let mut entries = zeros(m, n);
    let (before, after) = (binomial_row(n), binomial_row(m));
    // (−1)^k C(gap+k−1, k), the coefficients of (1+x)^{−gap}.
    let mut series = vec![Int::ONE];
    for k in 0..m {
        let following = &series[k] * Int::from(gap + k);
        series.push(-following.div_exact(&Int::from(k + 1)));
    }
    for j in 0..=m {
        for i in j..=m {
            budget::step();
            entries[(i, j)] = Rational::new(&series[i - j] * &before[j], after[i].clone());
        }
    }
    Ok(entries)
}

fn whole(value: Int) -> Rational {
    Rational::new_raw(value, Int::ONE)
}

/// The zero matrix for degrees `rows` and `columns`.
fn zeros(rows: usize, columns: usize) -> DMatrix<Rational> {
    let (rows, columns) = (rows.saturating_add(1), columns.saturating_add(1));
    budget::charge_terms((rows as u64).saturating_mul(columns as u64));
    DMatrix::from_element(rows, columns, Rational::new_raw(Int::zero(), Int::one()))
}
