//! What is interpolated: numbers or points; and polynomials with such coefficients.
//!
//! Everything in this module is linear in the data, so one algorithm serves scalars and points
//! of any dimension: it only adds data and multiplies them by scalars.

use std::cmp::Ordering;
use std::fmt::Debug;

use super::InterpolationError;
use crate::budget;
use crate::math::number::{Int, Rational, factorial};
use crate::math::ring::compare;
use crate::math::ring::{Field, Ring};

/// A number, or a point given by its coordinates: an element of a vector space over C.
///
/// The operations on two points need equal dimensions; every constructor of this module that
/// takes data checks them.
pub trait Datum<C: Ring>: Clone + PartialEq + Debug {
    /// self + other
    fn added(&self, other: &Self) -> Self;

    /// self − other
    fn less(&self, other: &Self) -> Self;

    /// factor · self
    fn multiple(&self, factor: &C) -> Self;

    /// The zero of the same dimension.
    fn origin(&self) -> Self;

    /// The coordinates; a number is its own coordinate.
    fn coordinates(&self) -> &[C];

    /// The datum with these coordinates, one for a number.
    fn from_coordinates(coordinates: Vec<C>) -> Self;

    /// The number of coordinates; 1 for a number.
    fn dimension(&self) -> usize {
        self.coordinates().len()
    }

    /// Whether this is zero.
    fn is_origin(&self) -> bool {
        self.coordinates().iter().all(|x| x.is_zero())
    }
}

impl<C: Ring> Datum<C> for C {
    fn added(&self, other: &Self) -> Self {
        self.plus(other)
    }
    fn less(&self, other: &Self) -> Self {
        self.minus(other)
    }
    fn multiple(&self, factor: &C) -> Self {
        factor.times(self)
    }
    fn origin(&self) -> Self {
        C::zero()
    }
    fn coordinates(&self) -> &[C] {
        std::slice::from_ref(self)
    }
    fn from_coordinates(coordinates: Vec<C>) -> Self {
        coordinates.into_iter().next().unwrap_or_else(C::zero)
    }
}

impl<C: Ring> Datum<C> for Vec<C> {
    fn added(&self, other: &Self) -> Self {
        self.iter().zip(other).map(|(x, y)| x.plus(y)).collect()
    }
    fn less(&self, other: &Self) -> Self {
        self.iter().zip(other).map(|(x, y)| x.minus(y)).collect()
    }
    fn multiple(&self, factor: &C) -> Self {
        self.iter().map(|x| factor.times(x)).collect()
    }
    fn origin(&self) -> Self {
        vec![C::zero(); self.len()]
    }
    fn coordinates(&self) -> &[C] {
        self
    }
    fn from_coordinates(coordinates: Vec<C>) -> Self {
        coordinates
    }
}

/// q · datum
pub(super) fn share<C: Ring, V: Datum<C>>(datum: &V, q: &Rational) -> V {
    datum.multiple(&C::from_rational(q))
}

/// datum / k!
pub(super) fn over_factorial<C: Ring, V: Datum<C>>(datum: &V, k: usize) -> V {
    if k < 2 { datum.clone() } else { share(datum, &Rational::new(Int::ONE, factorial(k))) }
}

/// Σ w_i v_i, of which there is at least one.
pub(super) fn combination<'a, C: Ring, V: Datum<C> + 'a>(
    terms: impl IntoIterator<Item = (&'a C, &'a V)>,
) -> Option<V> {
    let mut terms = terms.into_iter();
    let (weight, datum) = terms.next()?;
    Some(terms.fold(datum.multiple(weight), |sum, (weight, datum)| {
        budget::step();
        sum.added(&datum.multiple(weight))
    }))
}

/// 1/x for the difference x of two nodes known to be distinct, or a product of such.
pub(super) fn reciprocal<F: Field>(x: &F) -> F {
    x.inverse().expect("differences of distinct nodes are not zero, and a field has no zero divisors")
}

/// p(t) (t − node)
pub(super) fn times_linear<C: Ring, V: Datum<C>>(mut p: Vec<V>, node: &C) -> Vec<V> {
    let Some(first) = p.first() else { return p };
    p.insert(0, first.origin());
    for i in 1..p.len() {
        budget::step();
        p[i - 1] = p[i - 1].less(&p[i].multiple(node));
    }
    p
}

/// p(t) of a polynomial given by its power coefficients, lowest first; `None` if there are none
/// (the zero polynomial, of unknown dimension). Cost: a product for each coefficient.
///
/// ```
/// use polarform::interpolate::value_of;
/// use polarform::number::integer as z;
/// assert_eq!(value_of(&[z(1), z(2), z(3)], &z(10)), Some(z(321)));
/// assert_eq!(value_of(&[vec![z(1), z(5)], vec![z(2), z(0)]], &z(10)), Some(vec![z(21), z(5)]));
/// ```
pub fn value_of<C: Ring, V: Datum<C>>(p: &[V], t: &C) -> Option<V> {
    let (last, rest) = p.split_last()?;
    Some(rest.iter().rev().fold(last.clone(), |value, c| {
        budget::step();
        value.multiple(t).added(c)
    }))
}

/// Divides p by t − node: (quotient, remainder p(node)); `None` if p has no coefficients.
pub(super) fn divided<C: Ring, V: Datum<C>>(p: &[V], node: &C) -> Option<(Vec<V>, V)> {
    let (last, rest) = p.split_last()?;
    let mut carry = last.clone();
    let mut quotient = Vec::with_capacity(rest.len());
    for c in rest.iter().rev() {
        budget::step();
        let following = carry.multiple(node).added(c);
        quotient.push(std::mem::replace(&mut carry, following));
    }
    quotient.reverse();
    Some((quotient, carry))
}

/// At least `needed` nodes.
pub(super) fn enough(given: usize, needed: usize) -> Result<(), InterpolationError> {
    if given < needed { Err(InterpolationError::TooFewPoints { needed, given }) } else { Ok(()) }
}

/// As many of `what` as needed.
pub(super) fn as_many(what: &'static str, given: usize, needed: usize) -> Result<(), InterpolationError> {
    if given == needed { Ok(()) } else { Err(InterpolationError::Lengths { what, given, needed }) }
}

/// All points have the dimension of the first.
pub(super) fn same_dimension<C: Ring, V: Datum<C>>(points: &[V]) -> Result<(), InterpolationError> {
    match points.first() {
        Some(first) => fitting("point", points, first),
        None => Ok(()),
    }
}

/// All data have the dimension of a point.
pub(super) fn fitting<'a, C: Ring, V: Datum<C> + 'a>(
    what: &'static str,
    data: impl IntoIterator<Item = &'a V>,
    point: &V,
) -> Result<(), InterpolationError> {
    let needed = point.dimension();
    match data.into_iter().map(Datum::dimension).enumerate().find(|(_, given)| *given != needed) {
        Some((index, given)) => Err(InterpolationError::Dimensions { what, index, given, needed }),
        None => Ok(()),
    }
}

/// No two nodes are equal. Cost: a comparison for each pair.
pub(super) fn distinct<C: Ring>(nodes: &[C]) -> Result<(), InterpolationError> {
    for (second, node) in nodes.iter().enumerate() {
        budget::step();
        if let Some(first) = nodes[..second].iter().position(|x| x == node) {
            return Err(InterpolationError::EqualNodes { first, second });
        }
    }
    Ok(())
}

/// Each node is larger than the one before it, as far as their difference is a number.
/// Symbolic nodes are taken to be in the order given; neighbours must differ.
pub(in crate::math) fn increasing<C: Ring>(nodes: &[C]) -> Result<(), InterpolationError> {
    for (i, pair) in nodes.windows(2).enumerate() {
        match compare(&pair[0], &pair[1]) {
            Some(Ordering::Equal) => {
                return Err(InterpolationError::EqualNodes { first: i, second: i + 1 });
            }
            Some(Ordering::Greater) => return Err(InterpolationError::NotIncreasing { index: i + 1 }),
            _ => {}
        }
    }
    Ok(())
}

/// Distinct nodes, at least one, each with a datum of one dimension.
pub(super) fn check<C: Ring, V: Datum<C>>(nodes: &[C], values: &[V]) -> Result<(), InterpolationError> {
    enough(nodes.len(), 1)?;
    as_many("values", values.len(), nodes.len())?;
    same_dimension(values)?;
    distinct(nodes)
}
