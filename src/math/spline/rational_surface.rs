//! Rational B-spline surfaces (NURBS surfaces).
//!
//! Definition: a net d_ij with weights w_ij gives Σ w_ij d_ij N_i^m(u) N_j^n(v) over the same sum
//! of the weights. As for curves, the surface is kept as the spline surface with control vectors
//! (w_ij d_ij, w_ij) in one dimension more; everything linear is done there.
//!
//! **Invariant.** The homogeneous surface has at least one coordinate, the weight, the last one.
//!
//! Reference: L. Piegl, W. Tiller, *The NURBS Book* (1997), sections 4.4 and 4.5.

use super::{KnotVector, SplineError, SplineSurface};
use crate::math::blossom::Argument;
use crate::math::curve::{
    Direction, Interval, Point, PolarValue, RationalPatch, Surface, Vector, check_weight, lifted_net, parted,
    projected, quartered,
};
use crate::math::ring::Field;

/// A rational spline surface by its homogeneous one.
///
/// ```
/// use polarform::interval::Interval;
/// use polarform::number::{integer as z, rational as q};
/// use polarform::spline::{KnotVector, RationalSplineSurface};
/// // half of the cylinder x² + y² = 1 of height 1, from two quarters
/// let u = KnotVector::clamped(2, &[z(1), z(1)], &Interval::new(z(0), z(2))?)?;
/// let v = KnotVector::clamped(1, &[], &Interval::unit())?;
/// let circle = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0]];
/// let net = circle.map(|[x, y]| [0, 1].map(|h| [x, y, h].map(z)).to_vec()).to_vec();
/// let weights = [2, 1, 1, 1, 2].map(|w| vec![z(w); 2]).to_vec();
/// let half = RationalSplineSurface::new(u, v, net, weights)?;
/// assert_eq!(half.value(&q(1, 2), &q(1, 3))?, [q(4, 5), q(3, 5), q(1, 3)]);
/// # Ok::<(), polarform::spline::SplineError>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct RationalSplineSurface<C> {
    homogeneous: SplineSurface<C>,
}

impl<C: Field> RationalSplineSurface<C> {
    /// The surface with this net of control points and of weights.
    ///
    /// # Errors
    /// [`crate::math::curve::CurveError::WeightCount`] (of all points, or of the first row that
    /// differs), [`crate::math::curve::CurveError::ZeroWeight`] with the place counted along the
    /// rows, and those of [`SplineSurface::new`].
    pub fn new(
        u: KnotVector<C>,
        v: KnotVector<C>,
        points: Vec<Vec<impl Into<Point<C>>>>,
        weights: Vec<Vec<C>>,
    ) -> Result<Self, SplineError> {
        let plain = SplineSurface::new(u, v, points)?;
        let (u, v) = plain.knots();
        let net = lifted_net(plain.net(), &weights)?;
        Ok(RationalSplineSurface { homogeneous: SplineSurface::new(u.clone(), v.clone(), net)? })
    }

    /// The image of a polynomial surface, its last coordinate being the weight. Control vectors may
    /// have weight 0.
    ///
    /// # Errors
    /// [`crate::math::curve::CurveError::DimensionsOf`] if there are no coordinates.
    pub fn from_homogeneous(homogeneous: SplineSurface<C>) -> Result<Self, SplineError> {
        check_weight(homogeneous.dimension())?;
        Ok(RationalSplineSurface { homogeneous })
    }

    /// The polynomial surface with the weight as its last coordinate.
    pub fn homogeneous(&self) -> &SplineSurface<C> {
        &self.homogeneous
    }

    /// The weights by rows.
    pub fn weights(&self) -> Vec<Vec<C>> {
        let weights = |row: &Vec<Point<C>>| row.iter().map(|vector| parted(vector).1.clone()).collect();
        self.homogeneous.net().iter().map(weights).collect()
    }

    /// The control points by rows; `None` for one at infinity.
    pub fn points(&self) -> Vec<Vec<Option<Point<C>>>> {
        let points = |row: &Vec<Point<C>>| row.iter().map(|vector| projected(vector).ok()).collect();
        self.homogeneous.net().iter().map(points).collect()
    }

    /// The surface point at (u, v).
    ///
    /// # Errors
    /// [`crate::math::curve::CurveError::ZeroDenominator`], and as [`KnotVector::span_of`].
    pub fn value(&self, u: &C, v: &C) -> Result<Point<C>, SplineError> {
        Ok(projected(&self.homogeneous.value(u, v)?)?)
    }

    /// The position vector and all partial derivatives of order at most k at (u, v), those of the
    /// patch after a knot. Cost: a Bézier patch and [`RationalPatch::derivatives`].
    ///
    /// # Errors
    /// As [`RationalSplineSurface::value`].
    pub fn derivatives(&self, u: &C, v: &C, k: usize) -> Result<Vec<Vec<Vector<C>>>, SplineError> {
        let patch = self.homogeneous.patch_at(u, v)?;
        Ok(RationalPatch::from_homogeneous(patch)?.derivatives(u, v, k)?)
    }

    /// The two surfaces on both sides of u = t, or of v = t.
    ///
    /// # Errors
    /// As [`SplineSurface::subdivide`].
    pub fn subdivide(&self, direction: Direction, t: &C) -> Result<(Self, Self), SplineError> {
        let (left, right) = self.homogeneous.subdivide(direction, t)?;
        Ok((RationalSplineSurface { homogeneous: left }, RationalSplineSurface { homogeneous: right }))
    }
}

impl<C: Field> Surface<C> for RationalSplineSurface<C> {
    type Domain = (Interval<C>, Interval<C>);
    type Arguments = (Vec<Argument<C>>, Vec<Argument<C>>);
    type Error = SplineError;
    fn dimension(&self) -> usize {
        self.homogeneous.dimension() - 1
    }
    fn value(&self, [u, v]: &[C; 2]) -> Result<Point<C>, SplineError> {
        self.value(u, v)
    }
    fn blossom(&self, p: &[C; 2], arguments: &Self::Arguments) -> Result<PolarValue<C>, SplineError> {
        let vector = Surface::blossom(&self.homogeneous, p, arguments)?;
        Ok(Argument::Point(projected(vector.coordinates())?))
    }
    fn derivative(&self, r: usize, s: usize, [u, v]: &[C; 2]) -> Result<Vector<C>, SplineError> {
        Ok(self.derivatives(u, v, r + s)?.swap_remove(r).swap_remove(s))
    }
    fn elevate(&self, by: usize) -> Result<Self, SplineError> {
        Ok(RationalSplineSurface { homogeneous: Surface::elevate(&self.homogeneous, by)? })
    }
    fn subdivide(&self, [u, v]: &[C; 2]) -> Result<Vec<Self>, SplineError> {
        quartered(self, Self::subdivide, u, v)
    }
    fn part(&self, (u, v): Self::Domain) -> Result<Self, SplineError> {
        Ok(RationalSplineSurface { homogeneous: self.homogeneous.part(u, v)? })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::{CurveError, check_surface};
    use crate::math::number::{Rational, integer as z, rational as q};
    use proptest::prelude::*;

    fn knots() -> [KnotVector<Rational>; 2] {
        let u = KnotVector::clamped(2, &[z(1), z(1)], &Interval::new(z(0), z(3)).unwrap()).unwrap();
        [u, KnotVector::uniform(3, 4, &z(-3), &z(1)).unwrap()]
    }

    /// Points of the plane and weights, 5 by 4.
    fn net() -> impl Strategy<Value = (Vec<Vec<Point<Rational>>>, Vec<Vec<Rational>>)> {
        let entry =
            (-9i64..10, -9i64..10, 1i64..9).prop_map(|(x, y, w)| (Point::from([z(x), z(y)]), q(w, 2)));
        let rows = prop::collection::vec(prop::collection::vec(entry, 4), 5);
        rows.prop_map(|rows| rows.into_iter().map(|row| row.into_iter().unzip()).unzip())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        #[test]
        fn values_are_quotients_of_sums((points, weights) in net(), i in 0i64..12, j in 0i64..4) {
            let (u, v) = (q(i, 4), q(j, 4));
            let [in_u, in_v] = knots();
            let s = RationalSplineSurface::new(in_u.clone(), in_v.clone(), points.clone(), weights.clone()).unwrap();
            // Σ w_ij d_ij N_i N_j / Σ w_ij N_i N_j with the basis functions by their recurrence
            let basis = |knots: &KnotVector<Rational>, t: &Rational| -> Vec<Rational> {
                knots.basis_functions().iter().map(|function| function.value(t).unwrap()).collect()
            };
            let (along_u, along_v) = (basis(&in_u, &u), basis(&in_v, &v));
            let mut sums = [z(0), z(0), z(0)];
            for (i, row) in points.iter().enumerate() {
                for (j, point) in row.iter().enumerate() {
                    let share = &along_u[i] * &along_v[j] * &weights[i][j];
                    sums[0] += &share * &point[0];
                    sums[1] += &share * &point[1];
                    sums[2] += share;
                }
            }
            let expected = [&sums[0] / &sums[2], &sums[1] / &sums[2]];
            prop_assert_eq!(s.value(&u, &v).unwrap(), expected.clone());
            let given: Vec<Vec<_>> = s.points().into_iter().map(|row| row.into_iter().map(Option::unwrap).collect()).collect();
            prop_assert_eq!((given, s.weights()), (points, weights));
            // the patch after the knot, and its quotient rule
            let jet = s.derivatives(&u, &v, 1).unwrap();
            prop_assert_eq!(&jet[0][0], &expected);
            let homogeneous = s.homogeneous().patch_at(&u, &v).unwrap();
            let by_u = homogeneous.derivative(1, 0).value(&u, &v);
            for k in 0..2 {
                let quotient = (&by_u[k] * &sums[2] - &sums[k] * &by_u[2]) / (&sums[2] * &sums[2]);
                prop_assert_eq!(&jet[1][0][k], &quotient);
            }
            let diagonal = (vec![Argument::Point(u.clone()); 2], vec![Argument::Point(v.clone()); 3]);
            let p = [u, v];
            if i > 0 && j > 0 {
                check_surface(&s, &p, &diagonal);
                check_surface(s.homogeneous(), &p, &diagonal);
            } else {
                prop_assert_eq!(Surface::subdivide(&s, &p), Err(CurveError::EmptyInterval.into()));
            }
        }
    }

    #[test]
    fn bad_weights_are_refused() {
        let flat = || KnotVector::clamped(1, &[], &Interval::unit()).unwrap();
        let points = || vec![vec![Point::from([z(1)]), Point::from([z(2)])]; 2];
        let new = |weights: Vec<Vec<Rational>>| RationalSplineSurface::new(flat(), flat(), points(), weights);
        assert!(new(vec![vec![z(1); 2], vec![z(1); 2]]).is_ok());
        let few = CurveError::WeightCount { weights: 2, points: 4 };
        assert_eq!(new(vec![vec![z(1); 2]]), Err(few.into()));
        let zero = CurveError::ZeroWeight { index: 3 };
        assert_eq!(new(vec![vec![z(1); 2], vec![z(1), z(0)]]), Err(zero.into()));
        let bare = SplineSurface::new(flat(), flat(), vec![vec![Vec::new(); 2]; 2]).unwrap();
        assert!(RationalSplineSurface::<Rational>::from_homogeneous(bare).is_err());
        // A denominator that vanishes: weights 1 and -1 in v.
        let s = new(vec![vec![z(1), z(-1)], vec![z(1), z(-1)]]).unwrap();
        assert_eq!(s.value(&z(0), &q(1, 2)), Err(CurveError::ZeroDenominator.into()));
        assert_eq!(s.derivatives(&z(0), &q(1, 2), 1), Err(CurveError::ZeroDenominator.into()));
    }
}
