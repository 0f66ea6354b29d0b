//! Rational Bézier curves.
//!
//! Definition: control points p_i with weights w_i give the curve Σ w_i p_i B_i^n / Σ w_i B_i^n.
//! It is kept as the polynomial curve with control vectors (w_i p_i, w_i) in one dimension more;
//! subdivision and change of degree are those of that curve. A control vector of weight 0 is a
//! point at infinity.
//!
//! **Invariant.** The homogeneous curve has at least one coordinate, the weight, the last one.
//!
//! References: G. Farin, *Curves and Surfaces for CAGD*, 5th ed. (2002), chapters 12 and 13;
//! L. Piegl, W. Tiller, *The NURBS Book* (1997), chapter 4.

use super::projective::{check_weight, lifted, parted, projected, quotient_derivatives};
use super::{BezierCurve, CurveError, Interval, Point, Vector, dimension, polygon};
use crate::math::number::exact_root;
use crate::math::ring::Field;

/// A rational curve over an interval.
///
/// ```
/// use polarform::curve::{CurveError, Interval, RationalCurve};
/// use polarform::number::{integer as z, rational as q};
/// // a quarter of the unit circle
/// let points = [[1, 0], [1, 1], [0, 1]].map(|p| p.map(z).to_vec()).to_vec();
/// let quarter = RationalCurve::new(points, [1, 1, 2].map(z).to_vec(), Interval::unit())?;
/// assert_eq!(quarter.value(&q(1, 2))?, [q(3, 5), q(4, 5)]);
/// # Ok::<(), CurveError>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct RationalCurve<C> {
    homogeneous: BezierCurve<C>,
}

impl<C: Field> RationalCurve<C> {
    /// The curve with these control points and weights over an interval [a, b].
    ///
    /// # Errors
    /// [`CurveError::WeightCount`], [`CurveError::ZeroWeight`], and those of [`BezierCurve::new`].
    pub fn new(
        points: Vec<impl Into<Point<C>>>,
        weights: Vec<C>,
        interval: Interval<C>,
    ) -> Result<Self, CurveError> {
        let points: Vec<Point<C>> = points.into_iter().map(Into::into).collect();
        dimension(&points)?;
        Ok(RationalCurve { homogeneous: BezierCurve::new(lifted(&points, &weights)?, interval)? })
    }

    /// The image of a polynomial curve, its last coordinate being the weight. Control vectors may
    /// have weight 0.
    ///
    /// # Errors
    /// [`CurveError::DimensionsOf`] if there are no coordinates.
    pub fn from_homogeneous(homogeneous: BezierCurve<C>) -> Result<Self, CurveError> {
        check_weight(homogeneous.dimension())?;
        Ok(RationalCurve { homogeneous })
    }

    /// The polynomial curve with the weight as its last coordinate.
    pub fn homogeneous(&self) -> &BezierCurve<C> {
        &self.homogeneous
    }

    /// The degree n.
    pub fn degree(&self) -> usize {
        self.homogeneous.degree()
    }

    /// The number of coordinates, without the weight.
    pub fn dimension(&self) -> usize {
        self.homogeneous.dimension() - 1
    }

    /// [a, b]
    pub fn interval(&self) -> &Interval<C> {
        self.homogeneous.interval()
    }

    /// w_0, …, w_n
    pub fn weights(&self) -> Vec<C> {
        self.homogeneous.points().iter().map(|vector| parted(vector).1.clone()).collect()
    }

    /// The control points; `None` for one at infinity.
    pub fn points(&self) -> Vec<Option<Point<C>>> {
        self.homogeneous.points().iter().map(|vector| projected(vector).ok()).collect()
    }

    /// The curve point at t, inside of the interval or outside.
    ///
    /// # Errors
    /// [`CurveError::ZeroDenominator`].
    pub fn value(&self, t: &C) -> Result<Point<C>, CurveError> {
        projected(&self.homogeneous.value(t))
    }

    /// The position vector of the curve point and the derivatives up to order k at t. Cost: k polar values, O(k²) products.
    ///
    /// # Errors
    /// [`CurveError::ZeroDenominator`].
    pub fn derivatives(&self, t: &C, k: usize) -> Result<Vec<Vector<C>>, CurveError> {
        crate::budget::charge_terms(k as u64);
        let homogeneous: Vec<Vec<Vector<C>>> =
            (0..=k).map(|r| vec![self.homogeneous.nth_derivative(r).value(t).position()]).collect();
        Ok(quotient_derivatives(&homogeneous)?.into_iter().flatten().collect())
    }

    /// The derivative as a rational curve of degree 2n: (w x' − w' x) / w².
    pub fn derivative(&self) -> Self {
        let coordinates = |curve: &BezierCurve<C>| -> Vec<Vec<Vec<C>>> {
            let column = |k: usize| curve.points().iter().map(|vector| vector[k].clone()).collect();
            (0..curve.dimension()).map(|k| vec![column(k)]).collect()
        };
        let (x, v) = (coordinates(&self.homogeneous), coordinates(&self.homogeneous.derivative()));
        let size = self.dimension();
        let numerator: Vec<Vec<C>> = (0..size)
            .map(|k| {
                let (left, right) = (polygon::product(&x[size], &v[k]), polygon::product(&v[size], &x[k]));
                left[0].iter().zip(&right[0]).map(|(x, y)| x.minus(y)).collect()
            })
            .collect();
        let weight = polygon::product(&x[size], &x[size]).swap_remove(0);
        let count = numerator.first().map_or(1, Vec::len);
        let low: Vec<Point<C>> =
            (0..count).map(|i| numerator.iter().map(|column| column[i].clone()).collect()).collect();
        let points = polygon::elevated(&low, weight.len() - count).into_iter().zip(weight);
        self.with_points(points.map(|(point, w)| point.into_iter().chain([w]).collect()).collect())
    }

    fn with_points(&self, points: Vec<Point<C>>) -> Self {
        let homogeneous = BezierCurve::new(points, self.interval().clone());
        RationalCurve { homogeneous: homogeneous.expect("vectors of equal length") }
    }

    /// The same curve of degree n + by.
    pub fn elevate(&self, by: usize) -> Self {
        RationalCurve { homogeneous: self.homogeneous.elevate(by) }
    }

    /// The same curve with weights w_i λ^i: the change of parameter s ↦ λ s / ((1 − s) + λ s) of
    /// the local parameter, which keeps the ends. λ = −1 gives the complementary arc.
    ///
    /// # Errors
    /// [`CurveError::Impossible`] if λ = 0.
    ///
    /// ```
    /// use polarform::curve::{Interval, RationalCurve};
    /// use polarform::number::{integer as z, rational as q};
    /// let points = vec![vec![z(0)], vec![z(1)]];
    /// let line = RationalCurve::new(points, vec![z(1), z(1)], Interval::unit())?;
    /// let faster = line.reparameterized(&z(2))?;
    /// assert_eq!(faster.weights(), [z(1), z(2)]);
    /// assert_eq!(faster.value(&q(1, 2))?, [q(2, 3)]);
    /// # Ok::<(), polarform::curve::CurveError>(())
    /// ```
    pub fn reparameterized(&self, lambda: &C) -> Result<Self, CurveError> {
        if lambda.is_zero() {
            return Err(CurveError::Impossible { why: "the factor of the weights is 0" });
        }
        let mut power = C::one();
        let mut points = Vec::with_capacity(self.degree() + 1);
        for vector in self.homogeneous.points() {
            points.push((vector.position() * &power).from_origin());
            power = power.times(lambda);
        }
        Ok(self.with_points(points))
    }

    /// The same curve with first and last weight 1, by a change of parameter that keeps the ends:
    /// λ^n = w_0 / w_n, with λ > 0 where there is a choice. Roots of symbols are not looked for.
    ///
    /// # Errors
    /// [`CurveError::ZeroWeight`] if an end is at infinity, [`CurveError::Irrational`] if there is
    /// no such λ among the rational numbers.
    pub fn standard_form(&self) -> Result<Self, CurveError> {
        let n = self.degree();
        let weights = self.weights();
        let inverse = |index: usize| weights[index].inverse().ok_or(CurveError::ZeroWeight { index });
        let (first, last) = (inverse(0)?, inverse(n)?);
        let ratio = weights[0].times(&last);
        let lambda = if n <= 1 || ratio.is_one() {
            ratio
        } else {
            let root = ratio.as_rational().and_then(|q| exact_root(&q, u32::try_from(n).ok()?));
            let what = "the parameter that makes the first and the last weight equal";
            C::from_rational(&root.ok_or(CurveError::Irrational { what })?)
        };
        let divided = |v: &Point<C>| (v.position() * &first).from_origin();
        let unit = self.with_points(self.homogeneous.points().iter().map(divided).collect());
        unit.reparameterized(&lambda)
    }

    /// w_{i−1} w_{i+1} / w_i² for i = 1, …, n − 1: the numbers that neither a common factor of the
    /// weights nor [`RationalCurve::reparameterized`] changes. Together with the control points
    /// they say the curve as a set of points.
    ///
    /// # Errors
    /// [`CurveError::ZeroWeight`] for an inner weight 0.
    pub fn shape_invariants(&self) -> Result<Vec<C>, CurveError> {
        let weights = self.weights();
        let invariant = |(i, w): (usize, &[C])| {
            let inverse = w[1].times(&w[1]).inverse().ok_or(CurveError::ZeroWeight { index: i + 1 })?;
            Ok(w[0].times(&w[2]).times(&inverse))
        };
        weights.windows(3).enumerate().map(invariant).collect()
    }

    /// The Farin points (w_i p_i + w_{i+1} p_{i+1}) / (w_i + w_{i+1}) on the edges of the control
    /// polygon; they tell the ratios of the weights.
    ///
    /// # Errors
    /// [`CurveError::ZeroDenominator`] if two neighbouring weights sum to 0.
    pub fn farin_points(&self) -> Result<Vec<Point<C>>, CurveError> {
        let sum = |pair: &[Point<C>]| &pair[0] + &pair[1].position();
        self.homogeneous.points().windows(2).map(|pair| projected(&sum(pair))).collect()
    }

    /// The curve with these control points and Farin points, one on each edge; w_0 = 1.
    ///
    /// # Errors
    /// [`CurveError::WeightCount`] unless there is one Farin point less than control points,
    /// [`CurveError::Degenerate`] for an edge of two equal points,
    /// [`CurveError::Impossible`] for a Farin point off its edge or at one of its ends; and those
    /// of [`BezierCurve::new`].
    pub fn from_farin_points(
        points: Vec<impl Into<Point<C>>>,
        farin: &[Point<C>],
        interval: Interval<C>,
    ) -> Result<Self, CurveError> {
        let points: Vec<Point<C>> = points.into_iter().map(Into::into).collect();
        let size = dimension(&points)?;
        if farin.len() + 1 != points.len() {
            return Err(CurveError::WeightCount { weights: farin.len() + 1, points: points.len() });
        }
        let off = CurveError::Impossible { why: "a Farin point lies strictly between its control points" };
        let mut weights = vec![C::one()];
        for (pair, point) in points.windows(2).zip(farin) {
            if point.len() != size {
                return Err(CurveError::DimensionsOf { left: size, right: point.len() });
            }
            let edge = &pair[1] - &pair[0];
            let k = edge.iter().position(|x| !x.is_zero()).ok_or(CurveError::Degenerate)?;
            // point = (1 − s) p_i + s p_{i+1} with s : (1 − s) = w_{i+1} : w_i
            let quotient = edge[k].inverse().ok_or(CurveError::Degenerate)?;
            let s = point[k].minus(&pair[0][k]).times(&quotient);
            let ratio = C::one().minus(&s).inverse().map(|inverse| s.times(&inverse));
            match ratio {
                Some(ratio) if !s.is_zero() && super::lerp(&pair[0], &pair[1], &s) == *point => {
                    weights.push(weights[weights.len() - 1].times(&ratio));
                }
                _ => return Err(off),
            }
        }
        RationalCurve::new(points, weights, interval)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::math::basis::bernstein_all;
    use crate::math::curve::Curve;
    use crate::math::curve::combination;
    use crate::math::number::{Rational, integer as z, rational as q};
    use crate::math::poly::{Fraction, MultiPoly, Symbol};
    use proptest::prelude::*;

    /// Curves of degree 0 to 4 with points and weights, in the plane.
    pub(in crate::math::curve) fn any_rational() -> impl Strategy<Value = RationalCurve<Rational>> {
        let coordinate = || (-9i64..10, 1i64..4).prop_map(|(p, r)| q(p, r));
        let weight =
            (1i64..9, 1i64..4, any::<bool>()).prop_map(|(p, r, s)| if s { q(p, r) } else { q(-p, r) });
        let control = (prop::collection::vec(coordinate(), 2), weight);
        (prop::collection::vec(control, 1..6), -3i64..3, 1i64..4).prop_map(|(list, a, width)| {
            let (points, weights) = list.into_iter().unzip();
            RationalCurve::new(points, weights, Interval::new(z(a), z(a + width)).unwrap()).unwrap()
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn values_agree(curve in any_rational(), t in (-9i64..10, 1i64..4), by in 0usize..3) {
            let t = q(t.0, t.1);
            let (a, b) = curve.interval().ends();
            let s = (&t - a) / (b - a);
            let basis = bernstein_all(curve.degree(), &s);
            let terms: Vec<Rational> = basis.iter().zip(curve.weights()).map(|(x, w)| x * w).collect();
            let points: Vec<Point<Rational>> = curve.points().into_iter().map(Option::unwrap).collect();
            let denominator: Rational = terms.iter().sum();
            let value = curve.value(&t);
            if denominator == z(0) {
                prop_assert_eq!(value, Err(CurveError::ZeroDenominator));
                return Ok(());
            }
            let expected = (combination(2, terms.iter().zip(&points)) * &(z(1) / denominator)).from_origin();
            prop_assert_eq!(value.as_ref(), Ok(&expected));
            prop_assert_eq!(&curve.elevate(by).value(&t), &value);
            if let Ok((left, right)) = curve.subdivide(&q(1, 7)) {
                prop_assert_eq!(&left.value(&t), &value);
                prop_assert_eq!(&right.value(&t), &value);
                prop_assert_eq!(&curve.part(right.interval().clone()).unwrap(), &right);
            }
        }

        #[test]
        fn derivatives_agree(curve in any_rational(), t in (-9i64..10, 1i64..4)) {
            let t = q(t.0, t.1);
            let Ok(list) = curve.derivatives(&t, 3) else { return Ok(()) };
            let mut derivative = curve.clone();
            for (k, expected) in list.iter().enumerate().take(3) {
                prop_assert_eq!(derivative.degree(), curve.degree() << k);
                prop_assert_eq!(&derivative.value(&t).unwrap().position(), expected);
                derivative = derivative.derivative();
            }
            // and Leibniz' rule backwards: x''' = Σ C(3, i) w^(i) p^(3−i)
            let homogeneous: Vec<_> = (0..4).map(|r| curve.homogeneous().nth_derivative(r).value(&t)).collect();
            let total = (0..4).map(|i| &homogeneous[i][2] * &list[3 - i][1] * z([1, 3, 3, 1][i]));
            prop_assert_eq!(total.sum::<Rational>(), homogeneous[3][1].clone());
        }

        #[test]
        fn projective_changes_of_parameter(curve in any_rational(), l in (1i64..6, 1i64..4), s in (-5i64..6, 1i64..5)) {
            let (lambda, s) = (q(l.0, l.1), q(s.0, s.1));
            let (a, b) = curve.interval().ends();
            let changed = curve.reparameterized(&lambda).unwrap();
            let denominator = (z(1) - &s) + &lambda * &s;
            if denominator != z(0) {
                let moved = &lambda * &s / denominator;
                let at = |s: Rational| a + s * (b - a);
                prop_assert_eq!(changed.value(&at(s)), curve.value(&at(moved)));
            }
            prop_assert_eq!(changed.shape_invariants(), curve.shape_invariants());
            match curve.standard_form() {
                Ok(standard) => {
                    let weights = standard.weights();
                    prop_assert_eq!((&weights[0], &weights[curve.degree()]), (&z(1), &z(1)));
                    prop_assert_eq!(standard.shape_invariants(), curve.shape_invariants());
                    prop_assert_eq!(standard.points(), curve.points());
                }
                Err(error) => {
                    let irrational = matches!(error, CurveError::Irrational { .. });
                    prop_assert!(irrational && curve.degree() > 1);
                }
            }
            // weights that are powers always have a standard form
            if curve.degree() > 0 {
                let points: Vec<_> = curve.points().into_iter().map(Option::unwrap).collect();
                let flat = RationalCurve::new(points.clone(), vec![z(3); points.len()], Interval::unit()).unwrap();
                let standard = flat.reparameterized(&lambda).unwrap().standard_form().unwrap();
                prop_assert!(standard.weights().iter().all(|w| *w == z(1)));
            }
        }

        #[test]
        fn farin_points_tell_the_weights(curve in any_rational()) {
            let points: Vec<Point<Rational>> = curve.points().into_iter().map(Option::unwrap).collect();
            let Ok(farin) = curve.farin_points() else { return Ok(()) };
            match RationalCurve::from_farin_points(points.clone(), &farin, curve.interval().clone()) {
                Ok(back) => {
                    let first = curve.weights()[0].clone();
                    let weights: Vec<Rational> = back.weights().iter().map(|w| w * &first).collect();
                    prop_assert_eq!(weights, curve.weights());
                }
                Err(error) => {
                    prop_assert_eq!(error, CurveError::Degenerate);
                    prop_assert!(points.windows(2).any(|pair| pair[0] == pair[1]));
                }
            }
        }
    }

    #[test]
    fn bad_weights_are_refused() {
        let points = vec![vec![z(0)], vec![z(1)]];
        let new = |weights: &[i64]| {
            RationalCurve::new(points.clone(), weights.iter().map(|&w| z(w)).collect(), Interval::unit())
                .unwrap_err()
        };
        assert_eq!(new(&[1]), CurveError::WeightCount { weights: 1, points: 2 });
        assert_eq!(new(&[1, 0]), CurveError::ZeroWeight { index: 1 });
        let none = RationalCurve::<Rational>::new(Vec::<Point<_>>::new(), vec![], Interval::unit());
        assert_eq!(none, Err(CurveError::TooFewPoints { needed: 1, given: 0 }));
        let bare = BezierCurve::new(vec![vec![]], Interval::unit()).unwrap();
        assert!(RationalCurve::<Rational>::from_homogeneous(bare).is_err());
        let line = RationalCurve::new(points.clone(), vec![z(1), z(-1)], Interval::unit()).unwrap();
        assert_eq!(line.value(&q(1, 2)), Err(CurveError::ZeroDenominator));
        assert_eq!(line.farin_points(), Err(CurveError::ZeroDenominator));
        assert!(line.reparameterized(&z(0)).is_err());
        let farin =
            |x: i64| RationalCurve::from_farin_points(points.clone(), &[[z(x)].into()], Interval::unit());
        assert!(matches!(farin(1), Err(CurveError::Impossible { .. })));
        assert!(matches!(farin(0), Err(CurveError::Impossible { .. })));
    }

    #[test]
    fn points_at_infinity() {
        // a half circle: the middle control vector is the direction (0, 1)
        let vectors = [[1, 0, 1], [0, 1, 0], [-1, 0, 1]].map(|v| v.map(z).to_vec()).to_vec();
        let half =
            RationalCurve::from_homogeneous(BezierCurve::new(vectors, Interval::unit()).unwrap()).unwrap();
        assert_eq!(half.points()[1], None);
        assert_eq!(half.value(&q(1, 2)).unwrap(), [z(0), z(1)]);
        assert_eq!(half.shape_invariants(), Err(CurveError::ZeroWeight { index: 1 }));
        assert_eq!(half.standard_form().unwrap(), half);
    }

    #[test]
    fn symbolic_weights() {
        let name = |s: &str| Fraction::from(MultiPoly::symbol(Symbol::new(s)));
        let one = Fraction::from(z(1));
        let points = ["p", "q", "r"].map(|s| vec![name(s)]).to_vec();
        let weights = vec![one.clone(), name("w"), one.clone()];
        let conic = RationalCurve::new(points, weights, Interval::unit()).unwrap();
        assert_eq!(conic.standard_form().unwrap(), conic);
        // the derivative at the start: n w_1/w_0 (p_1 − p_0)
        let list = conic.derivatives(&Fraction::from(z(0)), 1).unwrap();
        assert_eq!(list[1], [Fraction::from(z(2)) * name("w") * (name("q") - name("p"))]);
    }
}
