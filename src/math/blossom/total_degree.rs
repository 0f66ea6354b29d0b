//! Polar forms of total degree: arguments are points with m coordinates.
//!
//! **Definition.** For F of total degree at most d on R^m, f is the unique symmetric map
//! of d points that is affine in each point, with f(p, …, p) = F(p). A monomial x^α turns
//! into the mean, over all ways to hand its |α| factors to distinct arguments, of the
//! products. For m = 2 this is the polar form behind triangular Bézier patches.
//!
//! It differs from the tensor-product form: the total-degree form of u v for d = 2 is
//! (u1 v2 + u2 v1)/2, while (u1 + u2)(v1 + v2)/4 is not affine in the point (u1, v1).
//!
//! **Values.** Make F homogeneous with a further coordinate w. Putting in one argument p
//! (w = 1 for a point, 0 for a vector) is f(p, ·) = 1/d Σ_k p_k ∂F/∂x_k: Laguerre's polar.
//!
//! Reference: Ramshaw (1989), sections 4 and 11; Farin, ch. 17.

use std::collections::BTreeMap;

use super::polar_form::{Argument, PolarError};
use crate::budget;
use crate::math::number::{Int, Rational};
use crate::math::ring::Ring;

/// Exponents of x_1, …, x_m.
type Exponents = Vec<u32>;

/// The polar form of a polynomial on R^m of total degree at most d.
///
/// **Invariant.** No stored coefficient is zero; every exponent list has m entries with sum at most d.
///
/// ```
/// use polarform::blossom::TotalDegreePolarForm;
/// use polarform::number::{integer, rational};
/// // F(u, v) = u v of total degree 2: f = (u1 v2 + u2 v1)/2
/// let f = TotalDegreePolarForm::new(2, 2, [(vec![1, 1], integer(1))]).unwrap();
/// let value = f.value(&[vec![integer(1), integer(2)], vec![integer(3), integer(4)]]);
/// assert_eq!(value, Ok(integer(5))); // (1·4 + 3·2)/2
/// ```
#[doc(alias = "triangular")]
#[derive(Clone, PartialEq)]
pub struct TotalDegreePolarForm<C> {
    dimension: usize,
    degree: usize,
    coefficients: BTreeMap<Exponents, C>,
}

/// An argument: a point of R^m or a vector, as its coordinates.
pub type PointArgument<C> = Argument<Vec<C>>;

impl<C: Ring> TotalDegreePolarForm<C> {
    /// The polar form of Σ c_α x^α with |α| ≤ d; repeated exponents add up.
    ///
    /// # Errors
    /// [`PolarError::DegreeTooSmall`] if some |α| exceeds d; [`PolarError::ArgumentCount`] if an
    /// exponent list does not have m entries.
    pub fn new(
        dimension: usize,
        degree: usize,
        terms: impl IntoIterator<Item = (Exponents, C)>,
    ) -> Result<Self, PolarError> {
        let mut form = TotalDegreePolarForm { dimension, degree, coefficients: BTreeMap::new() };
        for (exponents, c) in terms {
            if exponents.len() != dimension {
                return Err(PolarError::ArgumentCount { expected: dimension, given: exponents.len() });
            }
            let total: usize = exponents.iter().map(|&e| e as usize).sum();
            if total > degree && !c.is_zero() {
                return Err(PolarError::DegreeTooSmall { polynomial: total, asked: degree });
            }
            form.add(exponents, c);
        }
        Ok(form)
    }

    fn add(&mut self, exponents: Exponents, c: C) {
        if c.is_zero() {
            return;
        }
        match self.coefficients.entry(exponents) {
            std::collections::btree_map::Entry::Vacant(place) => {
                place.insert(c);
            }
            std::collections::btree_map::Entry::Occupied(mut place) => {
                *place.get_mut() += c;
                if place.get().is_zero() {
                    place.remove();
                }
            }
        }
    }

    /// The degree d, the number of arguments.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The number m of coordinates of each argument.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The terms c_α x^α of the diagonal, by ascending exponents.
    pub fn terms(&self) -> impl Iterator<Item = (&[u32], &C)> {
        self.coefficients.iter().map(|(exponents, c)| (exponents.as_slice(), c))
    }

    /// Puts in one argument.
    fn put(&self, argument: &PointArgument<C>) -> Self {
        let inverse = Rational::new(Int::ONE, Int::from(self.degree));
        let mut result = TotalDegreePolarForm {
            dimension: self.dimension,
            degree: self.degree - 1,
            coefficients: BTreeMap::new(),
        };
        for (exponents, c) in &self.coefficients {
            budget::steps(self.dimension as u32 + 1);
            let used: u32 = exponents.iter().sum();
            let share = |count: u32| c.scaled(&(&inverse * Rational::from_integer(count.into())));
            let slack = self.degree as u32 - used;
            if slack > 0 && matches!(argument, Argument::Point(_)) {
                result.add(exponents.clone(), share(slack));
            }
            for (k, x) in argument.coordinate().iter().enumerate() {
                if exponents[k] > 0 {
                    let mut lower = exponents.clone();
                    lower[k] -= 1;
                    result.add(lower, share(exponents[k]).times(x));
                }
            }
        }
        result
    }

    /// Puts in k ≤ d arguments and leaves d − k free.
    ///
    /// Cost: O(k m N) ring operations for N terms.
    ///
    /// # Errors
    /// [`PolarError::TooManyArguments`], or [`PolarError::ArgumentCount`] for a point with a
    /// wrong number of coordinates.
    pub fn partial(&self, arguments: &[PointArgument<C>]) -> Result<Self, PolarError> {
        if arguments.len() > self.degree {
            return Err(PolarError::TooManyArguments { degree: self.degree, given: arguments.len() });
        }
        let mut form = self.clone();
        for argument in arguments {
            let given = argument.coordinate().len();
            if given != self.dimension {
                return Err(PolarError::ArgumentCount { expected: self.dimension, given });
            }
            form = form.put(argument);
        }
        Ok(form)
    }

    /// f(p_1, …, p_d) at points, or at points and vectors, mixed.
    ///
    /// # Errors
    /// [`PolarError::ArgumentCount`] for a wrong number of arguments or coordinates.
    pub fn value<A: Clone + Into<PointArgument<C>>>(&self, arguments: &[A]) -> Result<C, PolarError> {
        if arguments.len() != self.degree {
            return Err(PolarError::ArgumentCount { expected: self.degree, given: arguments.len() });
        }
        let arguments: Vec<PointArgument<C>> = arguments.iter().cloned().map(Into::into).collect();
        let form = self.partial(&arguments)?;
        Ok(form.coefficients.into_values().next().unwrap_or_else(C::zero))
    }

    /// F(p), the diagonal, by its monomials (an independent way to f(p, …, p)).
    pub fn diagonal_at(&self, point: &[C]) -> C {
        let mut sum = C::zero();
        for (exponents, c) in &self.coefficients {
            let powers = exponents.iter().zip(point).map(|(&e, x)| x.powered(e));
            sum += powers.fold(c.clone(), |product, p| product.times(&p));
        }
        sum
    }

    /// The same polynomial with more arguments.
    pub fn elevate(&self, by: usize) -> Self {
        TotalDegreePolarForm { degree: self.degree + by, ..self.clone() }
    }

    /// The same polynomial with fewer arguments.
    ///
    /// # Errors
    /// [`PolarError::NotReducible`] if the polynomial really has a higher degree.
    pub fn reduce(&self, by: usize) -> Result<Self, PolarError> {
        let asked = self.degree.saturating_sub(by);
        let top = self.coefficients.keys().map(|e| e.iter().map(|&e| e as usize).sum()).max();
        match top {
            Some(power) if power > asked => Err(PolarError::NotReducible { power, asked }),
            _ => Ok(TotalDegreePolarForm { degree: asked, ..self.clone() }),
        }
    }

    /// The polar form of the derivative in the given directions, of degree d − k:
    /// d!/(d−k)! f(·, …, ·, v̂_1, …, v̂_k); degree 0 and zero when k > d.
    ///
    /// # Errors
    /// [`PolarError::ArgumentCount`] for a direction with a wrong number of coordinates.
    pub fn derivative<V: Clone + Into<Vec<C>>>(&self, directions: &[V]) -> Result<Self, PolarError> {
        let k = directions.len();
        if k > self.degree {
            return TotalDegreePolarForm::new(self.dimension, 0, []);
        }
        let vectors: Vec<_> = directions.iter().cloned().map(|v| Argument::Vector(v.into())).collect();
        let mut form = self.partial(&vectors)?;
        let factor: Int = (self.degree - k + 1..=self.degree).map(Int::from).product();
        let factor = Rational::from_integer(factor);
        form.coefficients.values_mut().for_each(|c| *c = c.scaled(&factor));
        Ok(form)
    }

    /// The Bézier points over a simplex with corners a_0, …, a_m: for every multi-index
    /// (i_0, …, i_m) with sum d, in descending lexicographic order, the value with a_k taken
    /// i_k times. For a triangle these are f(a^i b^j c^k).
    ///
    /// # Errors
    /// [`PolarError::ArgumentCount`] unless there are m + 1 corners with m coordinates each.
    pub fn bezier_points(&self, corners: &[Vec<C>]) -> Result<Vec<(Vec<usize>, C)>, PolarError> {
        if corners.len() != self.dimension + 1 {
            return Err(PolarError::ArgumentCount { expected: self.dimension + 1, given: corners.len() });
        }
        let corners: Vec<_> = corners.iter().cloned().map(Argument::Point).collect();
        let mut points = Vec::new();
        self.collect_points(&corners, &mut Vec::new(), &mut points)?;
        Ok(points)
    }

    /// Puts in the first corner as often as each multi-index wants, then goes on to the next.
    fn collect_points(
        &self,
        corners: &[PointArgument<C>],
        index: &mut Vec<usize>,
        points: &mut Vec<(Vec<usize>, C)>,
    ) -> Result<(), PolarError> {
        let [corner, others @ ..] = corners else { return Ok(()) };
        if others.is_empty() {
            let value = self.value(&vec![corner.clone(); self.degree])?;
            let mut full = index.clone();
            full.push(self.degree);
            points.push((full, value));
            return Ok(());
        }
        let mut stages = vec![self.clone()];
        for _ in 0..self.degree {
            let next = stages[stages.len() - 1].partial(std::slice::from_ref(corner))?;
            stages.push(next);
        }
        for (count, stage) in stages.iter().enumerate().rev() {
            index.push(count);
            stage.collect_points(others, index, points)?;
            index.pop();
        }
        Ok(())
    }

    /// The value by the polarisation identity: with F homogenised to degree d,
    /// f(p_1, …, p_d) = 1/d! Σ_{S ⊆ {1..d}} (−1)^{d−|S|} F(Σ_{j∈S} p_j).
    ///
    /// Cost: 2^d evaluations.
    ///
    /// # Errors
    /// As for [`TotalDegreePolarForm::value`].
    #[cfg(test)]
    fn value_by_polarization(&self, arguments: &[PointArgument<C>]) -> Result<C, PolarError> {
        let d = self.degree;
        if arguments.len() != d {
            return Err(PolarError::ArgumentCount { expected: d, given: arguments.len() });
        }
        let subsets = 1u64.checked_shl(d as u32).unwrap_or(u64::MAX);
        budget::charge_terms(subsets);
        let mut sum = C::zero();
        for subset in 0..subsets {
            budget::step();
            let mut weight = C::zero();
            let mut point = vec![C::zero(); self.dimension];
            for (j, argument) in arguments.iter().enumerate() {
                if subset >> j & 1 == 1 {
                    if matches!(argument, Argument::Point(_)) {
                        weight += C::one();
                    }
                    point.iter_mut().zip(argument.coordinate()).for_each(|(x, p)| *x += p.clone());
                }
            }
            let mut value = C::zero();
            for (exponents, c) in &self.coefficients {
                let used: u32 = exponents.iter().sum();
                let powers = exponents.iter().zip(&point).map(|(&e, x)| x.powered(e));
                let start = c.times(&weight.powered(d as u32 - used));
                value += powers.fold(start, |product, p| product.times(&p));
            }
            if (d - subset.count_ones() as usize).is_multiple_of(2) {
                sum += value;
            } else {
                sum -= value;
            }
        }
        Ok(sum.scaled(&Rational::new(Int::ONE, crate::math::number::factorial(d))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer, rational};
    use proptest::prelude::*;

    fn any_form() -> impl Strategy<Value = TotalDegreePolarForm<Rational>> {
        (1usize..4, 0usize..5).prop_flat_map(|(m, d)| {
            let term = (prop::collection::vec(0u32..5, m), (-9i64..10, 1i64..5));
            prop::collection::vec(term, 0..8).prop_map(move |terms| {
                let terms = terms.into_iter().filter_map(|(e, (p, q))| {
                    (e.iter().sum::<u32>() as usize <= d).then(|| (e, rational(p, q)))
                });
                TotalDegreePolarForm::new(m, d, terms).unwrap()
            })
        })
    }

    fn arguments(f: &TotalDegreePolarForm<Rational>, seed: i64) -> Vec<PointArgument<Rational>> {
        (0..f.degree() as i64)
            .map(|j| {
                let point = (0..f.dimension() as i64).map(|k| rational((seed * (j + 2) + 7 * k) % 11 - 5, 2));
                if (seed + j) % 4 == 3 {
                    Argument::Vector(point.collect())
                } else {
                    Argument::Point(point.collect())
                }
            })
            .collect()
    }

    proptest! {
        #[test]
        fn two_ways_agree_and_the_laws_hold(f in any_form(), seed in 0i64..100) {
            let list = arguments(&f, seed);
            let value = f.value(&list).unwrap();
            assert_eq!(f.value_by_polarization(&list).unwrap(), value);
            let mut swapped = list.clone();
            swapped.reverse();
            assert_eq!(f.value(&swapped).unwrap(), value);
            let point: Vec<_> = (0..f.dimension() as i64).map(|k| rational(seed - 9 * k, 3)).collect();
            assert_eq!(f.value(&vec![point.clone(); f.degree()]).unwrap(), f.diagonal_at(&point));
            assert_eq!(f.elevate(2).reduce(2), Ok(f));
        }

        #[test]
        fn corner_values(f in any_form()) {
            let m = f.dimension();
            let corner = |k: usize| (0..m).map(|j| integer(i64::from(j + 1 == k))).collect::<Vec<_>>();
            let corners: Vec<_> = (0..=m).map(corner).collect();
            let points = f.bezier_points(&corners).unwrap();
            let expected = crate::math::number::binomial(f.degree() + m, m);
            assert_eq!(Int::from(points.len()), expected);
            for (index, value) in points {
                let list: Vec<Vec<Rational>> = index.iter().zip(&corners)
                    .flat_map(|(&i, c)| vec![c.clone(); i]).collect();
                assert_eq!(f.value(&list).unwrap(), value);
            }
        }
    }
}
