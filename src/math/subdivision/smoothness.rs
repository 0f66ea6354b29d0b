//! Whether differences contract.

use nalgebra::DMatrix;
use num_traits::{Signed, Zero};

use super::{Scheme, SubdivisionError};
use crate::budget;
use crate::math::interval::Interval;
use crate::math::linalg::characteristic_polynomial;
use crate::math::number::{Int, Rational};
use crate::math::poly::{Coefficients, Poly};
use crate::math::ring::Field;

/// What is known of the difference scheme of one order.
#[derive(Clone, Debug, PartialEq)]
pub enum Contraction {
    /// The norm of the L-th iterate is below 1: the limits have continuous derivatives up to this order.
    Shown {
        /// L, the smallest one.
        steps: usize,
        /// ‖S_q^L‖
        norm: Rational,
    },
    /// Never: (1 + z)^{order+1} does not divide the symbol, or a(1) is not 2.
    NoFactor,
    /// Never: a local matrix of the difference scheme has a real eigenvalue of modulus 1 or more.
    Eigenvalue,
    /// Not within these steps.
    Open {
        /// How many were tried.
        steps: usize,
        /// The norm after them.
        norm: Rational,
    },
}

/// The norm ‖S_q^L‖ of the L-th iterate of the scheme with the symbol q: the largest sum of |c_{i − 2^L j}|
/// over j, c the coefficients of q(z) q(z²) ⋯ q(z^{2^{L−1}}). Cost: these are 2^L times as many as those of q.
///
/// ```
/// use polarform::number::rational as q;
/// use polarform::poly::Coefficients;
/// use polarform::subdivision::iterated_norm;
/// // the differences of Chaikin's scheme: (1 + z)²/4
/// let chaikin = Coefficients::new(vec![q(1, 4), q(1, 2), q(1, 4)]);
/// assert_eq!(iterated_norm(&chaikin, 1), q(1, 2));
/// assert_eq!(iterated_norm(&chaikin, 2), q(1, 4));
/// ```
pub fn iterated_norm(symbol: &Coefficients<Rational>, steps: usize) -> Rational {
    let mut product = vec![Rational::from_integer(Int::ONE)];
    for k in 0..steps {
        // times q(z^{2^k})
        let gap = 1_usize << k.min(62);
        let size = product.len() + symbol.len().saturating_sub(1).saturating_mul(gap);
        budget::charge_terms(size as u64);
        let mut next = vec![Rational::zero(); size];
        for (i, x) in product.iter().enumerate() {
            for (j, y) in symbol.iter().enumerate() {
                budget::step();
                next[i + j * gap] += x * y;
            }
        }
        product = next;
    }
    let classes = 1_usize << steps.min(62);
    let sum =
        |i: usize| product.iter().skip(i).step_by(classes).fold(Rational::zero(), |sum, x| sum + x.abs());
    (0..classes.min(product.len())).map(sum).max().unwrap_or_else(Rational::zero)
}

/// Whether the limits of a scheme have continuous derivatives up to an order, by the norms of the iterated
/// difference scheme 2^order a(z)/(1 + z)^{order+1}, tried up to `most` steps.
///
/// Cost: that of [`iterated_norm`] for each step; eigenvalues by a characteristic polynomial.
///
/// # Errors
/// [`SubdivisionError::Symbols`] if the mask is not of numbers.
///
/// ```
/// use polarform::number::rational as q;
/// use polarform::subdivision::{Contraction, Scheme, contraction};
/// let four_point = Scheme::four_point(&q(1, 16));
/// assert_eq!(contraction(&four_point, 1, 8)?, Contraction::Shown { steps: 2, norm: q(3, 4) });
/// assert_eq!(contraction(&four_point, 2, 8)?, Contraction::Eigenvalue);
/// # Ok::<(), polarform::subdivision::SubdivisionError>(())
/// ```
pub fn contraction<C: Field>(
    scheme: &Scheme<C>,
    order: usize,
    most: usize,
) -> Result<Contraction, SubdivisionError> {
    let numbers: Option<Vec<Rational>> = scheme.mask().iter().map(C::as_rational).collect();
    let numbers = Scheme::new(numbers.ok_or(SubdivisionError::Symbols)?, scheme.first())?;
    // Limits of nonzero constants are these constants: a(1) = 2.
    let total = numbers.mask().iter().fold(Rational::zero(), |sum, a| sum + a);
    let Some(quotient) = numbers.divided(order + 1).filter(|_| total == Rational::from_integer(2.into()))
    else {
        return Ok(Contraction::NoFactor);
    };
    let symbol = quotient.scaled(&Rational::from_integer(Int::from(2usize).pow(order as u32)));
    let mut norm = Rational::from_integer(Int::ONE);
    for steps in 1..=most {
        norm = iterated_norm(&symbol, steps);
        if norm < Rational::from_integer(Int::ONE) {
            return Ok(Contraction::Shown { steps, norm });
        }
        // Once suffices, and most schemes contract at the first or second step.
        if steps == 2.min(most) && [0, 1].iter().any(|&phase| expands(&symbol, phase)) {
            return Ok(Contraction::Eigenvalue);
        }
    }
    Ok(Contraction::Open { steps: most, norm })
}

/// Whether the matrix of q_{2i+phase−j}, 0 ≤ i, j < n, for q of degree n has a real eigenvalue of modulus 1 or
/// more. The entries of its powers are coefficients of the iterated symbol, a column those of one class, so
/// that the norms are never below 1 then.
fn expands(symbol: &Coefficients<Rational>, phase: i64) -> bool {
    let n = symbol.len() as i64 - 1;
    let size = n.max(1) as usize;
    let entry = |i: usize, j: usize| {
        let k = 2 * i as i64 + phase - j as i64;
        usize::try_from(k).ok().and_then(|k| symbol.get(k)).cloned().unwrap_or_else(Rational::zero)
    };
    let matrix = DMatrix::from_fn(size, size, entry);
    let polynomial = characteristic_polynomial(&matrix).expect("the matrix is square");
    let polynomial: Poly = polynomial.iter().cloned().collect();
    let one = Rational::from_integer(Int::ONE);
    let around = Interval::new(-one.clone(), one.clone()).expect("1 is not -1");
    let inside = polynomial.count_roots(&around).unwrap_or(0);
    let at_one = usize::from(polynomial.value(&one).is_zero());
    polynomial.count_real_roots().unwrap_or(0) > inside - at_one
}
