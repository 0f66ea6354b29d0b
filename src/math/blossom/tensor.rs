//! Tensor-product polar forms f(u_1, …, u_m; v_1, …, v_n).
//!
//! **Definition.** For F(u, v) = Σ c_{ij} u^i v^j of degree m in u and n in v, f is the
//! unique map that is affine in each argument, symmetric in the u's and symmetric in the
//! v's, with f(u, …, u; v, …, v) = F(u, v). It is Σ c_{ij} σ_{i,m}(u) σ_{j,n}(v), so the
//! grid of c_{ij} says all.
//!
//! Every operation acts on the rows (in v) or on the columns (in u) as on polar forms in
//! one variable; that the two directions commute is what the tests check.
//!
//! Reference: Ramshaw (1989), section 10; Farin, *Curves and Surfaces for CAGD*, ch. 14.

use super::polar_form::{Argument, PolarError, PolarForm};
use crate::math::interval::Interval;
use crate::math::ring::Ring;

/// The polar form of a polynomial in two variables, each with its own degree.
///
/// ```
/// use polarform::blossom::TensorPolarForm;
/// use polarform::number::{integer, rational};
/// // F(u, v) = u v with degrees (2, 2): f = (u1 + u2)(v1 + v2)/4
/// let (zero, one) = (integer(0), integer(1));
/// let mut grid = vec![vec![zero.clone(); 3]; 3];
/// grid[1][1] = one;
/// let f = TensorPolarForm::new(grid).unwrap();
/// let value = f.value(&[integer(1), integer(2)], &[integer(3), integer(4)]);
/// assert_eq!(value, Ok(rational(21, 4)));
/// ```
#[derive(Clone, PartialEq)]
pub struct TensorPolarForm<C> {
    /// rows[i] holds c_{i0}, …, c_{in}: for each power of u a polar form in v.
    rows: Vec<PolarForm<C>>,
}

impl<C> TensorPolarForm<C> {
    pub(super) fn rows(&self) -> &[PolarForm<C>] {
        &self.rows
    }
}

impl<C: Ring> TensorPolarForm<C> {
    /// The polar form of Σ c_{ij} u^i v^j, with the grid by rows (power of u first).
    ///
    /// # Errors
    /// [`PolarError::NoCoefficients`] for an empty grid, [`PolarError::DegreeMismatch`] for
    /// rows of different lengths.
    pub fn new(grid: Vec<Vec<C>>) -> Result<Self, PolarError> {
        let rows: Vec<PolarForm<C>> = grid.into_iter().map(PolarForm::new).collect();
        let left = rows.first().ok_or(PolarError::NoCoefficients)?.degree();
        match rows.iter().map(PolarForm::degree).find(|&right| right != left) {
            Some(right) => Err(PolarError::DegreeMismatch { left, right }),
            None => Ok(TensorPolarForm { rows }),
        }
    }

    /// The degrees (m, n) in u and in v.
    pub fn degrees(&self) -> (usize, usize) {
        (self.rows.len() - 1, self.rows[0].degree())
    }

    /// The grid c_{ij}, by rows.
    pub fn coefficients(&self) -> Vec<&[C]> {
        self.rows.iter().map(PolarForm::coefficients).collect()
    }

    /// The same map with the roles of u and v exchanged.
    pub fn transposed(&self) -> Self {
        let columns = (0..=self.degrees().1)
            .map(|j| PolarForm::new(self.rows.iter().map(|row| row.coefficients()[j].clone()).collect()));
        TensorPolarForm { rows: columns.collect() }
    }

    /// Applies an operation in v.
    fn in_v(
        &self,
        operation: impl Fn(&PolarForm<C>) -> Result<PolarForm<C>, PolarError>,
    ) -> Result<Self, PolarError> {
        Ok(TensorPolarForm { rows: self.rows.iter().map(operation).collect::<Result<_, _>>()? })
    }

    /// Applies an operation in u.
    fn in_u(
        &self,
        operation: impl Fn(&PolarForm<C>) -> Result<PolarForm<C>, PolarError>,
    ) -> Result<Self, PolarError> {
        Ok(self.transposed().in_v(operation)?.transposed())
    }

    /// f(u_1, …, u_m; v_1, …, v_n) at points, or at points and vectors, mixed.
    ///
    /// Cost: O(m n (m + n)) ring operations.
    ///
    /// # Errors
    /// [`PolarError::ArgumentCount`] for a wrong number in either group.
    pub fn value<U, V>(&self, u: &[U], v: &[V]) -> Result<C, PolarError>
    where
        U: Clone + Into<Argument<C>>,
        V: Clone + Into<Argument<C>>,
    {
        let along_v: Result<Vec<C>, _> = self.rows.iter().map(|row| row.value(v)).collect();
        PolarForm::new(along_v?).value(u)
    }

    /// The polar form of ∂^{r+s}F / ∂u^r ∂v^s, of degrees (m − r, n − s).
    ///
    /// # Errors
    /// None in fact: orders above the degree give the zero form.
    pub fn derivative(&self, r: usize, s: usize) -> Result<Self, PolarError> {
        self.in_v(|row| Ok(row.nth_derivative(s)))?.in_u(|column| Ok(column.nth_derivative(r)))
    }

    /// The same polynomial with more arguments in each group.
    pub fn elevate(&self, by_u: usize, by_v: usize) -> Result<Self, PolarError> {
        self.in_v(|row| Ok(row.elevate(by_v)))?.in_u(|column| Ok(column.elevate(by_u)))
    }

    /// The same polynomial with fewer arguments in each group.
    ///
    /// # Errors
    /// [`PolarError::NotReducible`] if a degree is really needed.
    pub fn reduce(&self, by_u: usize, by_v: usize) -> Result<Self, PolarError> {
        self.in_v(|row| row.reduce(by_v))?.in_u(|column| column.reduce(by_u))
    }

    /// The control net over u in [a, b] and v in [c, d]: entry (i, j) is f(a^{m−i}, b^i; c^{n−j}, d^j).
    pub fn bezier_net(&self, u: &Interval<C>, v: &Interval<C>) -> Vec<Vec<C>> {
        let rows = self.rows.iter().map(|row| PolarForm::new(row.bezier_points(v)));
        let along_v = TensorPolarForm { rows: rows.collect() };
        let columns =
            along_v.transposed().rows.into_iter().map(|column| PolarForm::new(column.bezier_points(u)));
        let net = TensorPolarForm { rows: columns.collect() }.transposed();
        net.rows.iter().map(|row| row.coefficients().to_vec()).collect()
    }

    /// The polar form of F + G, with the larger degree in each variable.
    pub fn sum(&self, other: &Self) -> Result<Self, PolarError> {
        let ((m, n), (k, l)) = (self.degrees(), other.degrees());
        let left = self.elevate(m.max(k) - m, n.max(l) - n)?;
        let right = other.elevate(m.max(k) - k, n.max(l) - l)?;
        let rows = left.rows.iter().zip(&right.rows).map(|(a, b)| a.sum(b)).collect();
        Ok(TensorPolarForm { rows })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{Rational, integer, rational};
    use proptest::prelude::*;

    fn any_form() -> impl Strategy<Value = TensorPolarForm<Rational>> {
        (1usize..5, 1usize..4).prop_flat_map(|(m, n)| {
            prop::collection::vec(prop::collection::vec((-9i64..10, 1i64..5), n), m).prop_map(|grid| {
                let grid = grid
                    .into_iter()
                    .map(|row| row.into_iter().map(|(p, q)| rational(p, q)).collect::<Vec<_>>());
                TensorPolarForm::new(grid.collect()).unwrap()
            })
        })
    }

    proptest! {
        #[test]
        fn directions_commute_and_nets_return(f in any_form(), seed in 0i64..50) {
            let (m, n) = f.degrees();
            let u: Vec<_> = (0..m as i64).map(|k| rational(seed + 3 * k, 2)).collect();
            let v: Vec<_> = (0..n as i64).map(|k| rational(5 * k - seed, 3)).collect();
            assert_eq!(f.value(&u, &v), f.transposed().value(&v, &u));
            let net = f.bezier_net(&Interval::unit(), &Interval::unit());
            for (i, row) in net.iter().enumerate() {
                for (j, point) in row.iter().enumerate() {
                    let ends = |n: usize, i: usize| -> Vec<Rational> {
                        (0..n).map(|k| integer(i64::from(k < i))).collect()
                    };
                    assert_eq!(f.value(&ends(m, i), &ends(n, j)).as_ref(), Ok(point));
                }
            }
            assert_eq!(f.elevate(2, 1).unwrap().reduce(2, 1), Ok(f));
        }

        #[test]
        fn sums_on_the_diagonal(f in any_form(), g in any_form(), u in -5i64..6, v in -5i64..6) {
            let at = |f: &TensorPolarForm<Rational>| {
                let (m, n) = f.degrees();
                f.value(&vec![integer(u); m], &vec![integer(v); n]).unwrap()
            };
            assert_eq!(at(&f.sum(&g).unwrap()), at(&f) + at(&g));
        }
    }

    #[test]
    fn ragged_grids_are_refused() {
        let grid = vec![vec![integer(1)], vec![integer(1), integer(2)]];
        assert_eq!(TensorPolarForm::new(grid), Err(PolarError::DegreeMismatch { left: 0, right: 1 }));
        assert_eq!(TensorPolarForm::<Rational>::new(vec![]), Err(PolarError::NoCoefficients));
    }
}
