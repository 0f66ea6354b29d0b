//! The polar form of a polynomial in one variable, as n + 1 coefficients.
//!
//! **Definition.** Let F(t) = Σ c_i t^i have degree at most n. Its polar form is the
//! unique symmetric map f of n arguments that is affine in each and has the diagonal
//! f(t, …, t) = F(t). It is
//!
//! f(t_1, …, t_n) = Σ_i c_i σ_{i,n},   σ_{i,n} = e_i(t_1, …, t_n) / C(n, i),
//!
//! with e_i the i-th elementary symmetric function, so the n + 1 numbers c_i say all.
//! The degree n is part of the polar form: t has a different polar form for n = 1, 2, 3, …
//!
//! **Invariant.** There is at least one coefficient; leading ones may be zero.
//!
//! Reference: L. Ramshaw, *Blossoms are polar forms*, CAGD 6 (1989) 323–358.

use std::any::Any;
use std::fmt;

use super::evaluator::PreparedForm;
use crate::math::interval::Interval;
use crate::math::number::{Int, Rational, binomials_where};
use crate::math::poly::Coefficients;
use crate::math::ring::{Field, Ring};
use num_integer::Integer;

/// The polar form (blossom) of a polynomial of degree at most n.
///
/// ```
/// use polarform::blossom::PolarForm;
/// use polarform::number::{integer, rational};
/// // F(t) = t^3 + 3t^2 + 5t + 1
/// let f = PolarForm::new([1, 5, 3, 1].map(integer).to_vec());
/// let value = f.value(&[integer(0), integer(1), integer(2)]).unwrap();
/// assert_eq!(value, integer(8)); // 0 + (0 + 0 + 2) + 5/3 · 3 + 1
/// assert_eq!(f.value(&[rational(1, 2), rational(1, 2), rational(1, 2)]).unwrap(),
///            rational(35, 8)); // the diagonal is F(1/2)
/// ```
#[doc(alias = "blossom")]
#[derive(Clone, PartialEq)]
pub struct PolarForm<C> {
    coefficients: Vec<C>,
}

/// An argument of a polar form: a point, or a vector (a difference of points); of the line, unless
/// said otherwise.
///
/// A vector argument v̂ = p − q means f(…, v̂, …) = f(…, p, …) − f(…, q, …); the unit
/// vector 1̂ = 1 − 0 gives derivatives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Argument<P, V = P> {
    /// A point: on the line a parameter value.
    Point(P),
    /// A difference of points, written with a hat.
    Vector(V),
}

impl<C> From<C> for Argument<C> {
    fn from(point: C) -> Self {
        Argument::Point(point)
    }
}

impl<C> Argument<C> {
    /// The number itself.
    pub fn coordinate(&self) -> &C {
        match self {
            Argument::Point(u) | Argument::Vector(u) => u,
        }
    }
}

/// Why an operation on polar forms has no result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PolarError {
    /// The wrong number of arguments.
    ArgumentCount {
        /// The degree.
        expected: usize,
        /// How many were given.
        given: usize,
    },
    /// More arguments than the degree.
    TooManyArguments {
        /// The degree.
        degree: usize,
        /// How many were given.
        given: usize,
    },
    /// The degree bound is below the degree of the polynomial.
    DegreeTooSmall {
        /// Degree of the polynomial.
        polynomial: usize,
        /// The bound asked for.
        asked: usize,
    },
    /// The coefficient of this power is not zero, so the degree cannot be reduced.
    NotReducible {
        /// The highest power with a nonzero coefficient.
        power: usize,
        /// The degree asked for.
        asked: usize,
    },
    /// Operands of different degrees where equal ones are needed.
    DegreeMismatch {
        /// Degree of the first.
        left: usize,
        /// Degree of the second.
        right: usize,
    },
    /// There are no coefficients or control points at all.
    NoCoefficients,
}

impl fmt::Display for PolarError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PolarError::ArgumentCount { expected, given } => {
                let plural = if *expected == 1 { "" } else { "s" };
                write!(f, "a polar form of degree {expected} takes {expected} argument{plural}, not {given}")
            }
            PolarError::TooManyArguments { degree, given } => {
                write!(f, "a polar form of degree {degree} takes at most {degree} arguments, not {given}")
            }
            PolarError::DegreeTooSmall { polynomial, asked } => {
                write!(f, "the polynomial has degree {polynomial}, more than the bound {asked}")
            }
            PolarError::NotReducible { power, asked } => {
                write!(f, "the coefficient of t^{power} is not 0, so the degree cannot be reduced to {asked}")
            }
            PolarError::DegreeMismatch { left, right } => {
                write!(f, "the degrees {left} and {right} differ; elevate the lower one first")
            }
            PolarError::NoCoefficients => f.write_str("there are no coefficients"),
        }
    }
}

impl std::error::Error for PolarError {}

impl<C: Ring> PolarForm<C> {
    /// The polar form of Σ c_i t^i, of degree n = number of coefficients − 1.
    ///
    /// No coefficients at all mean the zero form of degree 0.
    pub fn new(mut coefficients: Vec<C>) -> Self {
        if coefficients.is_empty() {
            coefficients.push(C::zero());
        }
        PolarForm { coefficients }
    }

    /// The polar form of Σ c_i t^i as a polynomial of degree at most `degree`.
    ///
    /// # Errors
    /// [`PolarError::DegreeTooSmall`] if a coefficient beyond the bound is not 0.
    ///
    /// ```
    /// use polarform::blossom::PolarForm;
    /// use polarform::number::integer;
    /// let t = [integer(0), integer(1)];
    /// let f = PolarForm::with_degree(&t, 3).unwrap(); // (t1 + t2 + t3)/3
    /// assert_eq!(f.value(&[integer(1), integer(2), integer(6)]), Ok(integer(3)));
    /// ```
    pub fn with_degree(coefficients: impl Into<Vec<C>>, degree: usize) -> Result<Self, PolarError> {
        let mut list = coefficients.into();
        let polynomial = list.iter().rposition(|c| !c.is_zero()).unwrap_or(0);
        if polynomial > degree {
            return Err(PolarError::DegreeTooSmall { polynomial, asked: degree });
        }
        crate::budget::charge_terms(degree as u64 + 1);
        list.resize(degree + 1, C::zero());
        Ok(PolarForm { coefficients: list })
    }

    /// The degree n, the number of arguments.
    pub fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// c_0, …, c_n: the power coefficients of the diagonal F.
    pub fn coefficients(&self) -> &[C] {
        &self.coefficients
    }

    /// The diagonal F(t) = f(t, …, t).
    pub fn diagonal(&self) -> Coefficients<C> {
        Coefficients::new(self.coefficients.clone())
    }

    /// c_i / C(n, i): the coefficients of the elementary symmetric functions e_i.
    ///
    /// Cost: binomial coefficients from the nearer end of their row to the innermost c_i ≠ 0.
    pub fn weights(&self) -> Vec<C> {
        with_binomials(self.coefficients.clone(), |b| Rational::new_raw(Int::ONE, b))
    }

    fn from_weights(weights: Vec<C>) -> Self {
        PolarForm::new(with_binomials(weights, Rational::from_integer))
    }

    /// f at points, or at points and vectors, mixed.
    ///
    /// Cost: O(n²) ring operations; over Q word operations on integers with one reduction
    /// at the end (prepare an [`PreparedForm`] for many values of one form).
    ///
    /// # Errors
    /// [`PolarError::ArgumentCount`] unless exactly n arguments are given.
    pub fn value<A: Clone + Into<Argument<C>>>(&self, arguments: &[A]) -> Result<C, PolarError> {
        let arguments: Vec<Argument<C>> = arguments.iter().cloned().map(Into::into).collect();
        // Over Q there is a much faster way with the same result.
        let form: &dyn Any = self;
        if self.degree() > 4
            && let Some(form) = form.downcast_ref::<PolarForm<Rational>>()
            && let Some(list) = rational_arguments(&arguments)
        {
            let value: Box<dyn Any> = Box::new(PreparedForm::new(form).value(&list)?);
            if let Ok(value) = value.downcast::<C>() {
                return Ok(*value);
            }
        }
        self.value_generic(&arguments)
    }

    /// The value in any ring: one argument after the other is put in.
    pub(super) fn value_generic(&self, arguments: &[Argument<C>]) -> Result<C, PolarError> {
        if arguments.len() != self.degree() {
            return Err(PolarError::ArgumentCount { expected: self.degree(), given: arguments.len() });
        }
        let mut weights = self.partial_weights(arguments);
        Ok(weights.swap_remove(0))
    }

    /// The weights after putting in some arguments. A point u turns Σ w_i e_i of n arguments
    /// into Σ (w_i + u w_{i+1}) e_i of n − 1; a vector v gives Σ v w_{i+1} e_i.
    fn partial_weights(&self, arguments: &[Argument<C>]) -> Vec<C> {
        let mut weights = self.weights();
        for argument in arguments {
            crate::budget::steps(weights.len() as u32);
            for i in 0..weights.len() - 1 {
                let next = weights[i + 1].times(argument.coordinate());
                weights[i] = match argument {
                    Argument::Point(_) => weights[i].plus(&next),
                    Argument::Vector(_) => next,
                };
            }
            weights.pop();
            crate::budget::charge_terms(weights.iter().map(C::size).sum());
        }
        weights
    }

    /// Puts in k ≤ n arguments and leaves n − k free: the polar form
    /// g(t_1, …, t_{n−k}) = f(u_1, …, u_k, t_1, …, t_{n−k}).
    ///
    /// Cost: O(k n) ring operations.
    ///
    /// # Errors
    /// [`PolarError::TooManyArguments`] if k > n.
    ///
    /// ```
    /// use polarform::blossom::{Argument, PolarForm};
    /// use polarform::number::integer;
    /// // f(u, v) = u v for F = t^2; f(3, t) = 3t
    /// let f = PolarForm::new([0, 0, 1].map(integer).to_vec());
    /// let g = f.partial(&[Argument::Point(integer(3))]).unwrap();
    /// assert_eq!(g, PolarForm::new([0, 3].map(integer).to_vec()));
    /// ```
    pub fn partial(&self, arguments: &[Argument<C>]) -> Result<Self, PolarError> {
        if arguments.len() > self.degree() {
            return Err(PolarError::TooManyArguments { degree: self.degree(), given: arguments.len() });
        }
        Ok(PolarForm::from_weights(self.partial_weights(arguments)))
    }

    /// The polar form of the k-th derivative, of degree n − k (degree 0 and zero when k > n):
    /// n!/(n−k)! f(t_1, …, t_{n−k}, 1̂, …, 1̂).
    ///
    /// Cost: O(k n).
    pub fn nth_derivative(&self, k: usize) -> Self {
        let n = self.degree();
        if k > n {
            return PolarForm::new(vec![C::zero()]);
        }
        let unit = vec![Argument::Vector(C::one()); k];
        let weights = self.partial_weights(&unit);
        let factor: Int = (n - k + 1..=n).map(Int::from).product();
        let factor = Rational::from_integer(factor);
        PolarForm::from_weights(weights.iter().map(|w| w.scaled(&factor)).collect())
    }

    /// The same polynomial with `by` more arguments. The coefficients stay; the polar
    /// values are the means over all ways to leave out arguments. Cost: O(n).
    pub fn elevate(&self, by: usize) -> Self {
        crate::budget::charge_terms((self.coefficients.len() + by) as u64);
        let mut coefficients = self.coefficients.clone();
        coefficients.resize(self.coefficients.len() + by, C::zero());
        PolarForm { coefficients }
    }

    /// The same polynomial with `by` fewer arguments.
    ///
    /// # Errors
    /// [`PolarError::NotReducible`] if the polynomial really has a higher degree.
    pub fn reduce(&self, by: usize) -> Result<Self, PolarError> {
        let asked = self.degree().saturating_sub(by);
        match self.coefficients.iter().rposition(|c| !c.is_zero()) {
            Some(power) if power > asked => Err(PolarError::NotReducible { power, asked }),
            _ => Ok(PolarForm { coefficients: self.coefficients[..=asked].to_vec() }),
        }
    }

    /// The Bézier points over an interval [a, b]: b_i = f(a, …, a, b, …, b) with i times b.
    ///
    /// Cost: O(n²) ring operations.
    ///
    /// ```
    /// use polarform::blossom::PolarForm;
    /// use polarform::interval::Interval;
    /// use polarform::number::integer;
    /// let f = PolarForm::new([0, 0, 1].map(integer).to_vec()); // t^2
    /// assert_eq!(f.bezier_points(&Interval::unit()), [0, 0, 1].map(integer));
    /// ```
    pub fn bezier_points(&self, interval: &Interval<C>) -> Vec<C> {
        // F(a + (b − a) s) = Σ d_i s^i has the polar values b_i = Σ_j C(i,j)/C(n,j) d_j over [0, 1].
        let local = self.reparameterize(interval.start(), &interval.width());
        // Repeated sums turn the weights w_j into Σ_j C(i, j) w_j.
        running(local.weights(), Running::Sums)
    }

    /// The polar form of s ↦ F(origin + scale · s), of the same degree:
    /// its coefficients are C(n, i) f(origin, …, origin, ŝcale, …, ŝcale).
    ///
    /// Cost: O(n²) ring operations.
    pub fn reparameterize(&self, origin: &C, scale: &C) -> Self {
        let mut list = self.coefficients.clone();
        let n = self.degree();
        if !origin.is_zero() {
            for stage in 0..n {
                crate::budget::steps(n as u32);
                for i in (stage..n).rev() {
                    let carried = list[i + 1].times(origin);
                    list[i] = list[i].plus(&carried);
                }
            }
        }
        if !scale.is_one() {
            let mut power = C::one();
            for c in list.iter_mut().skip(1) {
                power = power.times(scale);
                *c = c.times(&power);
            }
        }
        PolarForm { coefficients: list }
    }

    /// The polar form with Bézier points b_0, …, b_n over [0, 1]:
    /// c_i = C(n, i) Δ^i b_0.
    ///
    /// Cost: O(n²) ring operations.
    ///
    /// # Errors
    /// [`PolarError::NoCoefficients`] for an empty list.
    pub fn from_bezier_points(points: &[C]) -> Result<Self, PolarError> {
        if points.is_empty() {
            return Err(PolarError::NoCoefficients);
        }
        Ok(PolarForm::from_weights(running(points.to_vec(), Running::Differences)))
    }

    /// Applies a map to every coefficient (for instance into a larger ring).
    pub fn map<D: Ring>(&self, map: impl FnMut(&C) -> D) -> PolarForm<D> {
        PolarForm { coefficients: self.coefficients.iter().map(map).collect() }
    }
}

/// Each x_i ≠ 0 of x_0, …, x_n times the factor that belongs to C(n, i).
fn with_binomials<C: Ring>(mut list: Vec<C>, factor: impl Fn(Int) -> Rational) -> Vec<C> {
    let zero: Vec<bool> = list.iter().map(C::is_zero).collect();
    for (i, b) in binomials_where(list.len().saturating_sub(1), |i| zero.get(i) == Some(&false)) {
        list[i] = list[i].scaled(&factor(b));
    }
    list
}

#[derive(Clone, Copy)]
enum Running {
    Sums,
    Differences,
}

/// Entry i becomes Σ_j C(i, j) x_j, or Σ_j (−1)^{i−j} C(i, j) x_j: n rounds of sums or differences of
/// neighbours. Rational numbers are brought over one denominator first, so that no step takes a gcd.
fn running<C: Ring>(mut list: Vec<C>, what: Running) -> Vec<C> {
    fn rounds<T>(list: &mut [T], step: impl Fn(&T, &T) -> T) {
        for level in 1..list.len() {
            crate::budget::steps(list.len() as u32);
            for i in (level..list.len()).rev() {
                list[i] = step(&list[i], &list[i - 1]);
            }
        }
    }
    let any: &mut dyn Any = &mut list;
    if let Some(numbers) = any.downcast_mut::<Vec<Rational>>() {
        let denominator = numbers.iter().fold(Int::ONE, |l, x| l.lcm(x.denom()));
        let mut integers: Vec<Int> =
            numbers.iter().map(|x| x.numer() * denominator.div_exact(x.denom())).collect();
        match what {
            Running::Sums => rounds(&mut integers, |a, b| a + b),
            Running::Differences => rounds(&mut integers, |a, b| a - b),
        }
        *numbers = integers.into_iter().map(|x| Rational::new(x, denominator.clone())).collect();
        return list;
    }
    match what {
        Running::Sums => rounds(&mut list, C::plus),
        Running::Differences => rounds(&mut list, C::minus),
    }
    list
}

fn rational_arguments<C: Ring>(arguments: &[Argument<C>]) -> Option<Vec<Argument<Rational>>> {
    arguments
        .iter()
        .map(|argument| {
            Some(match argument {
                Argument::Point(u) => Argument::Point(u.as_rational()?),
                Argument::Vector(v) => Argument::Vector(v.as_rational()?),
            })
        })
        .collect()
}

impl<C: Field> PolarForm<C> {
    /// The polar form with Bézier points b_0, …, b_n over an interval.
    ///
    /// # Errors
    /// [`PolarError::NoCoefficients`] for an empty list.
    pub fn from_bezier_points_over(points: &[C], interval: &Interval<C>) -> Result<Self, PolarError> {
        let inverse = interval.inverse_width();
        let origin = -interval.start().times(inverse);
        Ok(PolarForm::from_bezier_points(points)?.reparameterize(&origin, inverse))
    }
}
