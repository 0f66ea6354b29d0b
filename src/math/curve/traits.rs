//! What all curves share, and what all patches share.

use super::{
    BezierCurve, CurveError, Direction, Interval, Point, PolarValue, RationalCurve, RationalPatch,
    RationalTriangle, TensorPatch, Triangle, TrianglePatch, Vector,
};
use crate::math::blossom::Argument;
use crate::math::ring::Field;

/// A curve over an interval: polynomial, rational or a spline.
///
/// ```
/// use polarform::curve::{BezierCurve, Curve, Interval};
/// use polarform::number::{integer as z, rational as q};
/// use polarform::ring::Field;
/// use polarform::spline::{BSpline, KnotVector};
///
/// /// The point at the middle parameter, from both halves.
/// fn middle<C: Field, K: Curve<C>>(curve: &K) -> Result<C, K::Error> {
///     let (a, b) = curve.ends();
///     let t = a.plus(b).scaled(&q(1, 2));
///     let (left, right) = curve.subdivide(&t)?;
///     assert_eq!(left.value(&t)?, right.value(&t)?);
///     Ok(left.value(&t)?[0].clone())
/// }
/// let points = || [0, 1, 4].map(|x| vec![z(x)]).to_vec();
/// assert_eq!(middle(&BezierCurve::new(points(), Interval::unit()).unwrap()), Ok(q(3, 2)));
/// let knots = KnotVector::clamped(1, &z(0), &[z(1)], &z(2)).unwrap();
/// assert_eq!(middle(&BSpline::new(knots, points()).unwrap()), Ok(z(1)));
/// ```
pub trait Curve<C: Field>: Sized {
    /// What can go wrong.
    type Error;

    /// The degree n of the representation.
    fn degree(&self) -> usize;

    /// The number of coordinates of a curve point.
    fn dimension(&self) -> usize;

    /// The two ends of the interval.
    fn ends(&self) -> (&C, &C);

    /// The curve point at t.
    ///
    /// # Errors
    /// If there is none.
    fn value(&self, t: &C) -> Result<Point<C>, Self::Error>;

    /// The polar form at n arguments, of the piece on which t lies.
    ///
    /// # Errors
    /// If their number is not n, or there is no such piece.
    fn blossom(&self, t: &C, arguments: &[Argument<C>]) -> Result<PolarValue<C>, Self::Error>;

    /// The curve of the derivatives.
    ///
    /// # Errors
    /// If the curve is not smooth.
    fn derivative(&self) -> Result<Self, Self::Error>;

    /// The same curve of degree n + by.
    ///
    /// # Errors
    /// If it cannot be written so.
    fn elevate(&self, by: usize) -> Result<Self, Self::Error>;

    /// The parts before and after t.
    ///
    /// # Errors
    /// If t is an end.
    fn subdivide(&self, t: &C) -> Result<(Self, Self), Self::Error>;

    /// The part from r to s.
    ///
    /// # Errors
    /// If the two are equal.
    fn part(&self, r: &C, s: &C) -> Result<Self, Self::Error>;
}

impl<C: Field> Curve<C> for BezierCurve<C> {
    type Error = CurveError;
    fn degree(&self) -> usize {
        self.degree()
    }
    fn dimension(&self) -> usize {
        self.dimension()
    }
    fn ends(&self) -> (&C, &C) {
        self.interval().ends()
    }
    fn value(&self, t: &C) -> Result<Point<C>, CurveError> {
        Ok(self.value(t))
    }
    fn blossom(&self, _: &C, arguments: &[Argument<C>]) -> Result<PolarValue<C>, CurveError> {
        self.blossom(arguments)
    }
    fn derivative(&self) -> Result<Self, CurveError> {
        Ok(self.derivative(1))
    }
    fn elevate(&self, by: usize) -> Result<Self, CurveError> {
        Ok(self.elevate(by))
    }
    fn subdivide(&self, t: &C) -> Result<(Self, Self), CurveError> {
        self.subdivide(t)
    }
    fn part(&self, r: &C, s: &C) -> Result<Self, CurveError> {
        self.part(r, s)
    }
}

impl<C: Field> Curve<C> for RationalCurve<C> {
    type Error = CurveError;
    fn degree(&self) -> usize {
        self.degree()
    }
    fn dimension(&self) -> usize {
        self.dimension()
    }
    fn ends(&self) -> (&C, &C) {
        self.interval().ends()
    }
    fn value(&self, t: &C) -> Result<Point<C>, CurveError> {
        self.value(t)
    }
    fn blossom(&self, _: &C, arguments: &[Argument<C>]) -> Result<PolarValue<C>, CurveError> {
        self.blossom(arguments).map(Argument::Point)
    }
    fn derivative(&self) -> Result<Self, CurveError> {
        Ok(self.derivative())
    }
    fn elevate(&self, by: usize) -> Result<Self, CurveError> {
        Ok(self.elevate(by))
    }
    fn subdivide(&self, t: &C) -> Result<(Self, Self), CurveError> {
        self.subdivide(t)
    }
    fn part(&self, r: &C, s: &C) -> Result<Self, CurveError> {
        self.part(r, s)
    }
}

/// A patch over a rectangle or a triangle: polynomial or rational. A parameter has two coordinates.
pub trait Surface<C: Field>: Sized {
    /// What the patch is given over.
    type Domain;

    /// The number of coordinates of a surface point.
    fn dimension(&self) -> usize;

    /// The surface point at a parameter.
    ///
    /// # Errors
    /// If there is none.
    fn value(&self, p: &[C; 2]) -> Result<Point<C>, CurveError>;

    /// The r-th derivative in the first parameter and the s-th in the second; the position vector of
    /// the surface point if both are 0.
    ///
    /// # Errors
    /// If there is none.
    fn derivative(&self, r: usize, s: usize, p: &[C; 2]) -> Result<Vector<C>, CurveError>;

    /// The same surface with each degree raised.
    fn elevate(&self, by: usize) -> Self;

    /// The patches around an inner parameter: four of a rectangle by rows, three of a triangle.
    ///
    /// # Errors
    /// If the parameter lies on an edge.
    fn subdivide(&self, p: &[C; 2]) -> Result<Vec<Self>, CurveError>;

    /// The same surface over another domain.
    fn part(&self, domain: Self::Domain) -> Self;
}

impl<C: Field> Surface<C> for TensorPatch<C> {
    type Domain = (Interval<C>, Interval<C>);
    fn dimension(&self) -> usize {
        self.dimension()
    }
    fn value(&self, [u, v]: &[C; 2]) -> Result<Point<C>, CurveError> {
        Ok(self.value(u, v))
    }
    fn derivative(&self, r: usize, s: usize, [u, v]: &[C; 2]) -> Result<Vector<C>, CurveError> {
        Ok(self.derivative_at(r, s, u, v))
    }
    fn elevate(&self, by: usize) -> Self {
        self.elevate(by, by)
    }
    fn subdivide(&self, [u, v]: &[C; 2]) -> Result<Vec<Self>, CurveError> {
        Ok(self.quarters(u, v)?.into_iter().flatten().collect())
    }
    fn part(&self, (u, v): Self::Domain) -> Self {
        self.part(u, v)
    }
}

impl<C: Field> Surface<C> for RationalPatch<C> {
    type Domain = (Interval<C>, Interval<C>);
    fn dimension(&self) -> usize {
        self.dimension()
    }
    fn value(&self, [u, v]: &[C; 2]) -> Result<Point<C>, CurveError> {
        self.value(u, v)
    }
    fn derivative(&self, r: usize, s: usize, [u, v]: &[C; 2]) -> Result<Vector<C>, CurveError> {
        Ok(self.derivatives(u, v, r + s)?.swap_remove(r).swap_remove(s))
    }
    fn elevate(&self, by: usize) -> Self {
        self.elevate(by, by)
    }
    fn subdivide(&self, [u, v]: &[C; 2]) -> Result<Vec<Self>, CurveError> {
        let (below, above) = self.subdivide(Direction::U, u)?;
        let mut parts = Vec::with_capacity(4);
        for half in [below, above] {
            parts.extend(<[Self; 2]>::from(half.subdivide(Direction::V, v)?));
        }
        Ok(parts)
    }
    fn part(&self, (u, v): Self::Domain) -> Self {
        self.part(u, v)
    }
}

impl<C: Field> Surface<C> for TrianglePatch<C> {
    type Domain = Triangle<C>;
    fn dimension(&self) -> usize {
        self.dimension()
    }
    fn value(&self, p: &[C; 2]) -> Result<Point<C>, CurveError> {
        self.value(p)
    }
    fn derivative(&self, r: usize, s: usize, p: &[C; 2]) -> Result<Vector<C>, CurveError> {
        Ok(self.partial_derivative(r, s).value(p)?.position())
    }
    fn elevate(&self, by: usize) -> Self {
        self.elevate(by)
    }
    fn subdivide(&self, p: &[C; 2]) -> Result<Vec<Self>, CurveError> {
        self.subdivide(p).map(Vec::from)
    }
    fn part(&self, domain: Triangle<C>) -> Self {
        self.over(domain)
    }
}

impl<C: Field> Surface<C> for RationalTriangle<C> {
    type Domain = Triangle<C>;
    fn dimension(&self) -> usize {
        self.dimension()
    }
    fn value(&self, p: &[C; 2]) -> Result<Point<C>, CurveError> {
        self.value(p)
    }
    fn derivative(&self, r: usize, s: usize, p: &[C; 2]) -> Result<Vector<C>, CurveError> {
        Ok(self.derivatives(p, r + s)?.swap_remove(r).swap_remove(s))
    }
    fn elevate(&self, by: usize) -> Self {
        self.elevate(by)
    }
    fn subdivide(&self, p: &[C; 2]) -> Result<Vec<Self>, CurveError> {
        self.subdivide(p).map(Vec::from)
    }
    fn part(&self, domain: Triangle<C>) -> Self {
        self.over(domain)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{Rational, integer as z, rational as q};

    /// The parts are the surface, and so is the elevated one.
    fn check<S: Surface<Rational>>(surface: &S, p: &[Rational; 2]) {
        let value = surface.value(p).unwrap();
        assert_eq!(value.len(), surface.dimension());
        assert_eq!(surface.derivative(0, 0, p).unwrap(), value.position());
        let raised = surface.elevate(2);
        assert_eq!(raised.derivative(1, 1, p).unwrap(), surface.derivative(1, 1, p).unwrap());
        for part in surface.subdivide(p).unwrap() {
            assert_eq!(part.value(p).unwrap(), value);
            let other = [q(1, 7), q(2, 5)];
            assert_eq!(part.value(&other).unwrap(), surface.value(&other).unwrap());
        }
    }

    #[test]
    fn patches_share_their_algorithms() {
        let unit = || Interval::unit();
        let net =
            |k: i64| vec![vec![vec![z(0), z(1)], vec![z(2), z(k)]], vec![vec![z(1), z(3)], vec![z(5), z(4)]]];
        let p = [q(1, 3), q(1, 2)];
        let patch = TensorPatch::new(net(7), unit(), unit()).unwrap();
        check(&patch, &p);
        check(&RationalPatch::from_homogeneous(patch).unwrap(), &p);
        let corners = [vec![z(0), z(0)], vec![z(1), z(0)], vec![z(0), z(1)]];
        let triangle = Triangle::new(corners).unwrap();
        let points = [[0, 1], [2, 3], [1, 5], [4, 2], [7, 1], [3, 3]].map(|p| p.map(z).to_vec()).to_vec();
        let patch = TrianglePatch::new(points, triangle).unwrap();
        check(&patch, &[q(1, 3), q(1, 4)]);
        check(&RationalTriangle::from_homogeneous(patch).unwrap(), &[q(1, 3), q(1, 4)]);
    }
}
