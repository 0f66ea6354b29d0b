//! Polar forms of sums, products and compositions, each in two ways.
//!
//! The first way works on the diagonals: add, multiply or compose the polynomials
//! and polarise the result. The second symmetrises the polar forms themselves. Both
//! stay on n + 1 coefficients: symmetrising e_i(t_S) e_j(t_{S^c}) over all S of m out
//! of m + n arguments gives, for each monomial of degree k = i + j, the share
//! C(k, i) C(m+n−k, m−i) / C(m+n, m).
//!
//! Reference: Ramshaw (1989), section 8; DeRose, Goldman, Hagen, Mann, *Functional
//! composition algorithms via blossoming*, ACM TOG 12 (1993) 113–135.

use super::polar_form::PolarForm;
use crate::budget;
use crate::math::number::{Rational, binomial, binomial_row};
use crate::math::ring::Ring;

impl<C: Ring> PolarForm<C> {
    /// The polar form of F + G, of the larger degree: elevate, then add. Cost: O(n).
    ///
    /// ```
    /// use polarform::blossom::PolarForm;
    /// use polarform::number::integer;
    /// let f = PolarForm::new([0, 2, 1].map(integer).to_vec()); // t^2 + 2t
    /// let g = PolarForm::new([1, 0, 0, 1].map(integer).to_vec()); // t^3 + 1
    /// assert_eq!(f.sum(&g).coefficients(), [1, 2, 1, 1].map(integer));
    /// ```
    pub fn sum(&self, other: &Self) -> Self {
        let n = self.degree().max(other.degree());
        let (left, right) = (self.elevate(n - self.degree()), other.elevate(n - other.degree()));
        PolarForm::new(left.coefficients().iter().zip(right.coefficients()).map(|(a, b)| a.plus(b)).collect())
    }

    /// The polar form of F · G, of degree m + n, by multiplying the diagonals.
    ///
    /// Cost: (m + 1)(n + 1) ring operations.
    pub fn product(&self, other: &Self) -> Self {
        PolarForm::new(self.diagonal().times(&other.diagonal()).padded(self.degree() + other.degree()))
    }

    /// The same by symmetrising f(t_1, …, t_m) g(t_{m+1}, …, t_{m+n}) over all choices of m
    /// arguments for f.
    ///
    /// Cost: (m + 1)(n + 1) ring operations and as many binomial coefficients.
    ///
    /// ```
    /// use polarform::blossom::PolarForm;
    /// use polarform::number::integer;
    /// let f = PolarForm::new([0, 2, 1].map(integer).to_vec());
    /// let g = PolarForm::new([1, 0, 0, 1].map(integer).to_vec());
    /// assert_eq!(f.product(&g), f.product_by_symmetrizing(&g));
    /// ```
    pub fn product_by_symmetrizing(&self, other: &Self) -> Self {
        let (m, n) = (self.degree(), other.degree());
        let (left, right) = (self.weights(), other.weights());
        let ways = binomial(m + n, m);
        let mut weights = vec![C::zero(); m + n + 1];
        for (i, a) in left.iter().enumerate() {
            budget::steps(n as u32);
            for (j, b) in right.iter().enumerate() {
                let k = i + j;
                let share = Rational::new(binomial(k, i) * binomial(m + n - k, m - i), ways.clone());
                weights[k] += a.times(b).scaled(&share);
            }
        }
        let row = binomial_row(m + n);
        PolarForm::new(weights.iter().zip(row).map(|(w, b)| w.scaled(&Rational::from_integer(b))).collect())
    }

    /// The polar form of F ∘ G, of degree m n, by composing the diagonals (Horner).
    ///
    /// Cost: O(m² n²) ring operations; with numbers as coefficients that of [`Poly::compose`](crate::math::poly::Poly::compose).
    pub fn compose(&self, inner: &Self) -> Self {
        let degree = self.degree() * inner.degree();
        budget::charge_terms(degree as u64 + 1);
        PolarForm::new(self.diagonal().compose(&inner.diagonal()).padded(degree))
    }

    /// The same by putting polar forms of G with distinct arguments into f and symmetrising:
    /// c_i times the symmetrised product of i copies of g, elevated to m n arguments.
    pub fn compose_by_symmetrizing(&self, inner: &Self) -> Self {
        let size = self.degree() * inner.degree();
        budget::charge_terms(size as u64 + 1);
        let mut power = PolarForm::new(vec![C::one()]);
        let mut result = PolarForm::new(vec![C::zero(); size + 1]);
        for (i, c) in self.coefficients().iter().enumerate() {
            if i > 0 {
                power = power.product_by_symmetrizing(inner);
            }
            result = result.sum(&power.elevate(size - power.degree()).map(|x| x.times(c)));
        }
        result
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::interval::Interval;
    use crate::math::number::{Int, integer, rational};
    use proptest::prelude::*;

    fn any_form(max: usize) -> impl Strategy<Value = PolarForm<Rational>> {
        prop::collection::vec((-9i64..10, 1i64..6), 1..max + 2)
            .prop_map(|list| PolarForm::new(list.into_iter().map(|(p, q)| rational(p, q)).collect()))
    }

    /// The mean over the n + 1 ways to leave out one of n + 1 arguments, written out: the
    /// elevated form derived from its definition rather than from the coefficients.
    ///
    /// f^(+1)(t_1, …, t_{n+1}) = 1/(n+1) Σ_i f(t_1, …, t_{i−1}, t_{i+1}, …, t_{n+1})
    fn elevate_by_mean(form: &PolarForm<Rational>) -> PolarForm<Rational> {
        // A monomial of degree k in n + 1 arguments survives in n + 1 − k of the n + 1 terms.
        let n = form.degree();
        let weights = form.weights();
        let row = binomial_row(n + 1);
        let coefficients = (0..=n + 1)
            .map(|k| match weights.get(k) {
                Some(w) => {
                    let share = Rational::new(Int::from(n + 1 - k) * &row[k], Int::from(n + 1));
                    w * share
                }
                None => integer(0),
            })
            .collect();
        PolarForm::new(coefficients)
    }

    proptest! {
        #[test]
        fn both_ways_agree(f in any_form(5), g in any_form(4)) {
            assert_eq!(f.product(&g), f.product_by_symmetrizing(&g));
            assert_eq!(f.compose(&g), f.compose_by_symmetrizing(&g));
            assert_eq!(f.elevate(1), elevate_by_mean(&f));
            assert_eq!(f.elevate(3).reduce(3), Ok(f.clone()));
        }

        #[test]
        fn bezier_points_and_back(f in any_form(6), a in -5i64..5, w in 1i64..6) {
            let (a, b) = (integer(a), rational(2 * a + w, 2));
            if a == b { return Ok(()); }
            let points = f.bezier_points(&Interval::new(a.clone(), b.clone()).unwrap());
            for (i, point) in points.iter().enumerate() {
                let mut arguments = vec![a.clone(); f.degree() - i];
                arguments.extend(vec![b.clone(); i]);
                assert_eq!(f.value(&arguments).as_ref(), Ok(point));
            }
            assert_eq!(PolarForm::from_bezier_points_over(&points, &Interval::new(a.clone(), b.clone()).unwrap()), Ok(f));
        }

        #[test]
        fn derivative_by_unit_vectors(f in any_form(6), k in 0usize..8, t in -4i64..5) {
            // d^k/dt^k on the coefficients is the independent way.
            let mut list = f.coefficients().to_vec();
            for _ in 0..k {
                list = list.iter().enumerate().skip(1).map(|(i, c)| c * integer(i as i64)).collect();
            }
            let derivative = f.nth_derivative(k);
            let expected = list.iter().rev().fold(integer(0), |s, c| s * integer(t) + c);
            let value = derivative.value(&vec![integer(t); derivative.degree()]);
            assert_eq!(value, Ok(expected));
        }
    }
}
