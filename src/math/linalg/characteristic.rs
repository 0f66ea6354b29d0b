//! Characteristic polynomials.

use nalgebra::DMatrix;

use super::{LinalgError, multiply};
use crate::budget;
use crate::math::number::{Int, Rational};
use crate::math::ring::Ring;

/// The coefficients of det(λ I − A), the constant one first, the last one 1.
///
/// By traces: M_1 = I, c_{n−k} = −tr(A M_k)/k, M_{k+1} = A M_k + c_{n−k} I (Leverrier, Faddeev). No element of the
/// ring is divided by another. Cost: n products of n×n matrices.
///
/// # Errors
/// [`LinalgError::NotSquare`].
///
/// ```
/// use nalgebra::DMatrix;
/// use polarform::{linalg::characteristic_polynomial, number::integer as z};
/// let a = DMatrix::from_row_slice(2, 2, &[1, 2, 3, 4].map(z));
/// assert_eq!(characteristic_polynomial(&a), Ok([-2, -5, 1].map(z).to_vec()));
/// ```
pub fn characteristic_polynomial<C: Ring>(a: &DMatrix<C>) -> Result<Vec<C>, LinalgError> {
    let n = a.nrows();
    if n != a.ncols() {
        return Err(LinalgError::NotSquare { rows: n, columns: a.ncols() });
    }
    budget::charge_terms((n as u64).saturating_mul(n as u64));
    let mut coefficients = vec![C::one()];
    let mut product = a.clone();
    for k in 1..=n {
        let trace = (0..n).fold(C::zero(), |sum, i| sum.plus(&product[(i, i)]));
        let coefficient = trace.scaled(&Rational::new(Int::from(-1), Int::from(k)));
        if k < n {
            (0..n).for_each(|i| product[(i, i)] += coefficient.clone());
            product = multiply(a, &product)?;
        }
        coefficients.push(coefficient);
    }
    coefficients.reverse();
    Ok(coefficients)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::linalg::{determinant, surd::Surd};
    use crate::math::number::{integer as z, rational as q};
    use proptest::prelude::*;

    proptest! {
        /// Its value at each number is a determinant, and n + 1 values decide.
        #[test]
        fn values_are_determinants(n in 0usize..6, entries in prop::collection::vec((-20i64..20, 1i64..5), 36)) {
            let a = DMatrix::from_fn(n, n, |i, j| q(entries[6 * i + j].0, entries[6 * i + j].1));
            let p = characteristic_polynomial(&a).unwrap();
            prop_assert_eq!(p.len(), n + 1);
            for x in 0..=n as i64 {
                let value = p.iter().rev().fold(z(0), |sum, c| sum * z(x) + c);
                let shifted = DMatrix::from_fn(n, n, |i, j| if i == j { z(x) } else { z(0) } - &a[(i, j)]);
                prop_assert_eq!(value, determinant(&shifted).unwrap());
            }
        }
    }

    #[test]
    fn over_other_fields_and_degenerate() {
        let root = Surd(z(0), z(1));
        let a =
            DMatrix::from_row_slice(2, 2, &[root.clone(), Surd(z(1), z(0)), Surd(z(0), z(0)), root.clone()]);
        let p = characteristic_polynomial(&a).unwrap();
        assert_eq!(p, [Surd(z(2), z(0)), Surd(z(0), z(-2)), Surd(z(1), z(0))]);
        let wide = DMatrix::from_element(1, 2, z(1));
        assert_eq!(characteristic_polynomial(&wide), Err(LinalgError::NotSquare { rows: 1, columns: 2 }));
        assert_eq!(
            characteristic_polynomial(&DMatrix::from_element(3, 3, z(0))).unwrap(),
            [0, 0, 0, 1].map(z)
        );
    }
}
