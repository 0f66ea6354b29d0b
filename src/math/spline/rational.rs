//! Rational B-spline curves (NURBS).
//!
//! Definition: control points d_i with weights w_i give Σ w_i d_i N_i^n / Σ w_i N_i^n. The curve is
//! kept as the spline with control vectors (w_i d_i, w_i) in one dimension more; knots are
//! inserted and degrees changed there. Its pieces are rational Bézier curves.
//!
//! **Invariant.** The homogeneous spline has at least one coordinate, the weight, the last one.
//!
//! Reference: L. Piegl, W. Tiller, *The NURBS Book* (1997), chapter 4.

use super::{BSpline, KnotVector, SplineError};
use crate::math::blossom::Argument;
use crate::math::curve::{
    BezierCurve, Curve, Point, PolarValue, RationalCurve, Vector, check_weight, lifted, parted, projected,
};
use crate::math::interval::Interval;
use crate::math::ring::Field;

/// A rational spline by its homogeneous one.
///
/// ```
/// use polarform::interval::Interval;
/// use polarform::number::{integer as z, rational as q};
/// use polarform::spline::{KnotVector, RationalSpline};
/// // half of the unit circle from two quarters
/// let points = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0]].map(|p| p.map(z)).to_vec();
/// let knots = KnotVector::clamped(2, &[z(1), z(1)], &Interval::new(z(0), z(2))?)?;
/// let half = RationalSpline::new(knots, points, [2, 1, 1, 1, 2].map(z).to_vec())?;
/// assert_eq!(half.value(&q(1, 2))?, [q(4, 5), q(3, 5)]);
/// assert_eq!(half.derivative()?.value(&z(0))?, [z(0), z(1)]);
/// # Ok::<(), polarform::spline::SplineError>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct RationalSpline<C> {
    homogeneous: BSpline<C>,
}

impl<C: Field> RationalSpline<C> {
    /// The spline with these control points and weights.
    ///
    /// # Errors
    /// [`crate::math::curve::CurveError::WeightCount`], [`crate::math::curve::CurveError::ZeroWeight`],
    /// and those of [`BSpline::new`].
    pub fn new(
        knots: KnotVector<C>,
        points: Vec<impl Into<Point<C>>>,
        weights: Vec<C>,
    ) -> Result<Self, SplineError> {
        let points: Vec<Point<C>> = points.into_iter().map(Into::into).collect();
        crate::math::curve::dimension(&points)?;
        Ok(RationalSpline { homogeneous: BSpline::new(knots, lifted(&points, &weights)?)? })
    }

    /// The image of a polynomial spline, its last coordinate being the weight. Control vectors may
    /// have weight 0.
    ///
    /// # Errors
    /// [`crate::math::curve::CurveError::DimensionsOf`] if there are no coordinates.
    pub fn from_homogeneous(homogeneous: BSpline<C>) -> Result<Self, SplineError> {
        check_weight(homogeneous.dimension())?;
        Ok(RationalSpline { homogeneous })
    }

    /// The polynomial spline with the weight as its last coordinate.
    pub fn homogeneous(&self) -> &BSpline<C> {
        &self.homogeneous
    }

    /// w_0, …, w_{m−1}
    pub fn weights(&self) -> Vec<C> {
        self.homogeneous.points().iter().map(|vector| parted(vector).1.clone()).collect()
    }

    /// The control points; `None` for one at infinity.
    pub fn points(&self) -> Vec<Option<Point<C>>> {
        self.homogeneous.points().iter().map(|vector| projected(vector).ok()).collect()
    }

    /// The curve point at t.
    ///
    /// # Errors
    /// [`crate::math::curve::CurveError::ZeroDenominator`], and as [`KnotVector::span_of`].
    pub fn value(&self, t: &C) -> Result<Point<C>, SplineError> {
        Ok(projected(&self.homogeneous.value(t)?)?)
    }

    /// The position vector of the curve point and the derivatives up to order k at t, those of
    /// the piece after t at a knot. Cost: a Bézier piece and [`RationalCurve::derivatives`].
    ///
    /// # Errors
    /// As [`RationalSpline::value`].
    pub fn derivatives(&self, t: &C, k: usize) -> Result<Vec<Vector<C>>, SplineError> {
        let piece = self.homogeneous.bezier_piece(self.homogeneous.knots().span_of(t)?)?;
        Ok(RationalCurve::from_homogeneous(piece)?.derivatives(t, k)?)
    }

    /// The Bézier curves of all knot intervals of the domain.
    pub fn bezier_pieces(&self) -> Vec<RationalCurve<C>> {
        let piece = |curve| RationalCurve::from_homogeneous(curve).expect("the spline has a weight");
        self.homogeneous.bezier_pieces().into_iter().map(piece).collect()
    }

    /// The derivative (w x' − w' x)/w² as a rational spline of degree 2n with clamped knots. At a knot
    /// of multiplicity s it is as smooth as a derivative of degree n is, so its knot there has
    /// multiplicity n + s + 1.
    ///
    /// # Errors
    /// [`SplineError::NotSmooth`] at an inner knot of multiplicity n + 1, where the curve may jump.
    pub fn derivative(&self) -> Result<Self, SplineError> {
        let n = self.homogeneous.degree();
        let own = self.homogeneous.knots();
        let mut inner = Vec::new();
        for (knot, multiplicity) in self.homogeneous.inner_knots() {
            if multiplicity > n {
                let place = own.knots().iter().position(|other| *other == knot).unwrap_or(0);
                return Err(SplineError::NotSmooth { knot: place });
            }
            inner.extend(vec![knot; n + multiplicity + 1]);
        }
        let pieces: Vec<BezierCurve<C>> =
            self.bezier_pieces().iter().map(|piece| piece.derivative().homogeneous().clone()).collect();
        let knots = KnotVector::clamped(2 * n, &inner, self.homogeneous.interval())?;
        RationalSpline::from_homogeneous(BSpline::from_pieces(knots, &pieces)?)
    }
}

impl<C: Field> Curve<C> for RationalSpline<C> {
    type Error = SplineError;
    fn degree(&self) -> usize {
        self.homogeneous.degree()
    }
    fn dimension(&self) -> usize {
        self.homogeneous.dimension() - 1
    }
    fn interval(&self) -> &Interval<C> {
        self.homogeneous.interval()
    }
    fn value(&self, t: &C) -> Result<Point<C>, SplineError> {
        self.value(t)
    }
    fn blossom(&self, t: &C, arguments: &[Argument<C>]) -> Result<PolarValue<C>, SplineError> {
        let span = self.homogeneous.knots().span_of(t)?;
        let vector = self.homogeneous.blossom(span, arguments)?;
        Ok(Argument::Point(projected(vector.coordinates())?))
    }
    fn derivative(&self) -> Result<Self, SplineError> {
        self.derivative()
    }
    fn elevate(&self, by: usize) -> Result<Self, SplineError> {
        Ok(RationalSpline { homogeneous: self.homogeneous.elevate(by)? })
    }
    fn subdivide(&self, t: &C) -> Result<(Self, Self), SplineError> {
        let (left, right) = self.homogeneous.subdivide(t)?;
        Ok((RationalSpline { homogeneous: left }, RationalSpline { homogeneous: right }))
    }
    fn part(&self, interval: Interval<C>) -> Result<Self, SplineError> {
        Ok(RationalSpline { homogeneous: self.homogeneous.part(interval)? })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::CurveError;
    use crate::math::number::{Rational, integer as z, rational as q};
    use crate::math::spline::tests::{any_spline, inside};
    use num_traits::Zero;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn values_and_derivatives_agree(homogeneous in any_spline(), k in 0usize..60) {
            let t = inside(&homogeneous, k);
            let s = RationalSpline::from_homogeneous(homogeneous.clone()).unwrap();
            // x/w, x'/w − x w'/w² and so on by hand, from the pieces in powers of t
            let jet: Vec<Vec<Rational>> = homogeneous.power_pieces().iter()
                .map(|p| (0..3).map(|r| p.nth_derivative(r).value(&t).unwrap()).collect()).collect();
            let ([x, x1, x2], [w, w1, w2]) = (
                <&[_; 3]>::try_from(&jet[0][..]).unwrap(), <&[_; 3]>::try_from(&jet[1][..]).unwrap());
            if w.is_zero() {
                prop_assert_eq!(s.value(&t), Err(CurveError::ZeroDenominator.into()));
                prop_assert_eq!(s.derivatives(&t, 2), Err(CurveError::ZeroDenominator.into()));
                return Ok(());
            }
            let first = (x1 * w - x * w1) / (w * w);
            let second = (x2 * w - x * w2) / (w * w) - z(2) * w1 / w * &first;
            prop_assert_eq!(s.value(&t).unwrap(), [x / w]);
            let list = s.derivatives(&t, 2).unwrap();
            prop_assert_eq!(&list, &[[x / w], [first], [second]]);
            match s.derivative() {
                Ok(derivative) => {
                    prop_assert_eq!(derivative.value(&t).unwrap().position(), list[1].clone());
                    prop_assert_eq!(Curve::degree(&derivative), 2 * homogeneous.degree());
                }
                Err(error) => {
                    let jumps = matches!(error, SplineError::NotSmooth { .. });
                    prop_assert!(jumps && homogeneous.inner_knots().iter().any(|(_, k)| *k > homogeneous.degree()));
                }
            }
            let raised = Curve::elevate(&s, 1).unwrap();
            prop_assert_eq!(raised.value(&t).unwrap(), s.value(&t).unwrap());
            if let Ok((left, right)) = Curve::subdivide(&s, &t) {
                prop_assert_eq!(right.value(&t).unwrap(), s.value(&t).unwrap());
                prop_assert_eq!(left.homogeneous().interval().end(), &t);
            }
        }
    }

    #[test]
    fn weights_and_points_return() {
        let knots = || KnotVector::clamped(1, &[z(1)], &Interval::new(z(0), z(2)).unwrap()).unwrap();
        let points: Vec<Point<Rational>> = [1, 5, 2].map(|x| [z(x)].into()).to_vec();
        let weights = [2, 1, 3].map(z);
        let s = RationalSpline::new(knots(), points.clone(), weights.to_vec()).unwrap();
        assert_eq!(s.weights(), weights);
        assert_eq!(s.points().into_iter().collect::<Option<Vec<_>>>(), Some(points.clone()));
        assert_eq!(s.value(&q(1, 2)).unwrap(), [q(7, 3)]);
        let zero = RationalSpline::new(knots(), points.clone(), [2, 0, 3].map(z).to_vec());
        assert_eq!(zero, Err(CurveError::ZeroWeight { index: 1 }.into()));
        let few = RationalSpline::new(knots(), points, weights[..2].to_vec());
        assert_eq!(few, Err(CurveError::WeightCount { weights: 2, points: 3 }.into()));
    }
}
