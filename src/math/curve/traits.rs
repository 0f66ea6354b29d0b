//! What all curves share, and what all patches share.

use super::projective::projected;
use super::{
    BezierCurve, CurveError, Direction, Interval, Point, PolarValue, RationalCurve, RationalPatch,
    RationalTriangle, TensorPatch, Triangle, TrianglePatch, Vector,
};
use crate::math::blossom::{Argument, PointArgument};
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
///     let (a, b) = curve.interval().ends();
///     let t = a.plus(b).scaled(&q(1, 2));
///     let (left, right) = curve.subdivide(&t)?;
///     assert!(left.value(&t)? == right.value(&t)?);
///     Ok(left.value(&t)?[0].clone())
/// }
/// let points = || [0, 1, 4].map(|x| vec![z(x)]).to_vec();
/// assert_eq!(middle(&BezierCurve::new(points(), Interval::unit()).unwrap()), Ok(q(3, 2)));
/// let knots = KnotVector::clamped(1, &[z(1)], &Interval::new(z(0), z(2)).unwrap()).unwrap();
/// assert_eq!(middle(&BSpline::new(knots, points()).unwrap()), Ok(z(1)));
/// ```
pub trait Curve<C: Field>: Sized {
    /// What can go wrong.
    type Error;

    /// The degree n of the representation.
    fn degree(&self) -> usize;

    /// The number of coordinates of a curve point.
    fn dimension(&self) -> usize;

    /// The interval [a, b] over which the curve is given.
    fn interval(&self) -> &Interval<C>;

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

    /// The part over another interval, for splines inside of their own.
    ///
    /// # Errors
    /// If there is none.
    fn part(&self, interval: Interval<C>) -> Result<Self, Self::Error>;
}

impl<C: Field> Curve<C> for BezierCurve<C> {
    type Error = CurveError;
    fn degree(&self) -> usize {
        self.degree()
    }
    fn dimension(&self) -> usize {
        self.dimension()
    }
    fn interval(&self) -> &Interval<C> {
        self.interval()
    }
    fn value(&self, t: &C) -> Result<Point<C>, CurveError> {
        Ok(self.value(t))
    }
    fn blossom(&self, _: &C, arguments: &[Argument<C>]) -> Result<PolarValue<C>, CurveError> {
        self.blossom(arguments)
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
    fn part(&self, interval: Interval<C>) -> Result<Self, CurveError> {
        Ok(self.part(interval))
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
    fn interval(&self) -> &Interval<C> {
        self.interval()
    }
    fn value(&self, t: &C) -> Result<Point<C>, CurveError> {
        self.value(t)
    }
    fn blossom(&self, _: &C, arguments: &[Argument<C>]) -> Result<PolarValue<C>, CurveError> {
        projected(self.homogeneous().blossom(arguments)?.coordinates()).map(Argument::Point)
    }
    fn derivative(&self) -> Result<Self, CurveError> {
        Ok(self.derivative())
    }
    fn elevate(&self, by: usize) -> Result<Self, CurveError> {
        Ok(self.elevate(by))
    }
    fn subdivide(&self, t: &C) -> Result<(Self, Self), CurveError> {
        let (left, right) = self.homogeneous().subdivide(t)?;
        Ok((RationalCurve::from_homogeneous(left)?, RationalCurve::from_homogeneous(right)?))
    }
    fn part(&self, interval: Interval<C>) -> Result<Self, CurveError> {
        RationalCurve::from_homogeneous(self.homogeneous().part(interval))
    }
}

/// A surface over a rectangle or a triangle: polynomial, rational or a spline. A parameter has two
/// coordinates.
pub trait Surface<C: Field>: Sized {
    /// What the surface is given over.
    type Domain;
    /// The arguments of its polar form: numbers in two groups, or points of the plane.
    type Arguments;
    /// What can go wrong.
    type Error;

    /// The number of coordinates of a surface point.
    fn dimension(&self) -> usize;

    /// The surface point at a parameter.
    ///
    /// # Errors
    /// If there is none.
    fn value(&self, p: &[C; 2]) -> Result<Point<C>, Self::Error>;

    /// The polar form of the piece on which p lies; of a rational surface its projection.
    ///
    /// # Errors
    /// If the arguments are too many or too few, or there is no such piece.
    fn blossom(&self, p: &[C; 2], arguments: &Self::Arguments) -> Result<PolarValue<C>, Self::Error>;

    /// The r-th derivative in the first parameter and the s-th in the second; the position vector of
    /// the surface point if both are 0.
    ///
    /// # Errors
    /// If there is none.
    fn derivative(&self, r: usize, s: usize, p: &[C; 2]) -> Result<Vector<C>, Self::Error>;

    /// The same surface with each degree raised.
    ///
    /// # Errors
    /// If it cannot be written so.
    fn elevate(&self, by: usize) -> Result<Self, Self::Error>;

    /// The surfaces around an inner parameter: four of a rectangle by rows, three of a triangle.
    ///
    /// # Errors
    /// If the parameter lies on an edge.
    fn subdivide(&self, p: &[C; 2]) -> Result<Vec<Self>, Self::Error>;

    /// The same surface over another domain, for splines inside of their own.
    ///
    /// # Errors
    /// If it cannot be written so.
    fn part(&self, domain: Self::Domain) -> Result<Self, Self::Error>;
}

/// What is before and after u and v, by rows, from a rule that cuts in one direction.
pub(in crate::math) fn quartered<S, C, E>(
    surface: &S,
    cut: impl Fn(&S, Direction, &C) -> Result<(S, S), E>,
    u: &C,
    v: &C,
) -> Result<Vec<S>, E> {
    let (before, after) = cut(surface, Direction::U, u)?;
    let (first, second) = cut(&before, Direction::V, v)?;
    let (third, fourth) = cut(&after, Direction::V, v)?;
    Ok(vec![first, second, third, fourth])
}

impl<C: Field> Surface<C> for TensorPatch<C> {
    type Domain = (Interval<C>, Interval<C>);
    type Arguments = (Vec<Argument<C>>, Vec<Argument<C>>);
    type Error = CurveError;
    fn dimension(&self) -> usize {
        self.dimension()
    }
    fn value(&self, [u, v]: &[C; 2]) -> Result<Point<C>, CurveError> {
        Ok(self.value(u, v))
    }
    fn blossom(&self, _: &[C; 2], (us, vs): &Self::Arguments) -> Result<PolarValue<C>, CurveError> {
        self.blossom(us, vs)
    }
    fn derivative(&self, r: usize, s: usize, [u, v]: &[C; 2]) -> Result<Vector<C>, CurveError> {
        Ok(self.derivative_at(r, s, u, v))
    }
    fn elevate(&self, by: usize) -> Result<Self, CurveError> {
        Ok(self.elevate(by, by))
    }
    fn subdivide(&self, [u, v]: &[C; 2]) -> Result<Vec<Self>, CurveError> {
        quartered(self, Self::subdivide, u, v)
    }
    fn part(&self, (u, v): Self::Domain) -> Result<Self, CurveError> {
        Ok(self.part(u, v))
    }
}

impl<C: Field> Surface<C> for RationalPatch<C> {
    type Domain = (Interval<C>, Interval<C>);
    type Arguments = (Vec<Argument<C>>, Vec<Argument<C>>);
    type Error = CurveError;
    fn dimension(&self) -> usize {
        self.dimension()
    }
    fn value(&self, [u, v]: &[C; 2]) -> Result<Point<C>, CurveError> {
        self.value(u, v)
    }
    fn blossom(&self, _: &[C; 2], (us, vs): &Self::Arguments) -> Result<PolarValue<C>, CurveError> {
        projected(self.homogeneous().blossom(us, vs)?.coordinates()).map(Argument::Point)
    }
    fn derivative(&self, r: usize, s: usize, [u, v]: &[C; 2]) -> Result<Vector<C>, CurveError> {
        Ok(self.derivatives(u, v, r + s)?.swap_remove(r).swap_remove(s))
    }
    fn elevate(&self, by: usize) -> Result<Self, CurveError> {
        RationalPatch::from_homogeneous(self.homogeneous().elevate(by, by))
    }
    fn subdivide(&self, [u, v]: &[C; 2]) -> Result<Vec<Self>, CurveError> {
        quartered(self, Self::subdivide, u, v)
    }
    fn part(&self, (u, v): Self::Domain) -> Result<Self, CurveError> {
        RationalPatch::from_homogeneous(self.homogeneous().part(u, v))
    }
}

impl<C: Field> Surface<C> for TrianglePatch<C> {
    type Domain = Triangle<C>;
    type Arguments = Vec<PointArgument<C>>;
    type Error = CurveError;
    fn dimension(&self) -> usize {
        self.dimension()
    }
    fn value(&self, p: &[C; 2]) -> Result<Point<C>, CurveError> {
        self.value(p)
    }
    fn blossom(&self, _: &[C; 2], arguments: &Self::Arguments) -> Result<PolarValue<C>, CurveError> {
        self.blossom(arguments)
    }
    fn derivative(&self, r: usize, s: usize, p: &[C; 2]) -> Result<Vector<C>, CurveError> {
        Ok(self.partial_derivative(r, s).value(p)?.position())
    }
    fn elevate(&self, by: usize) -> Result<Self, CurveError> {
        Ok(self.elevate(by))
    }
    fn subdivide(&self, p: &[C; 2]) -> Result<Vec<Self>, CurveError> {
        self.subdivide(p).map(Vec::from)
    }
    fn part(&self, domain: Triangle<C>) -> Result<Self, CurveError> {
        Ok(self.part(domain))
    }
}

impl<C: Field> Surface<C> for RationalTriangle<C> {
    type Domain = Triangle<C>;
    type Arguments = Vec<PointArgument<C>>;
    type Error = CurveError;
    fn dimension(&self) -> usize {
        self.dimension()
    }
    fn value(&self, p: &[C; 2]) -> Result<Point<C>, CurveError> {
        self.value(p)
    }
    fn blossom(&self, _: &[C; 2], arguments: &Self::Arguments) -> Result<PolarValue<C>, CurveError> {
        projected(self.homogeneous().blossom(arguments)?.coordinates()).map(Argument::Point)
    }
    fn derivative(&self, r: usize, s: usize, p: &[C; 2]) -> Result<Vector<C>, CurveError> {
        Ok(self.derivatives(p, r + s)?.swap_remove(r).swap_remove(s))
    }
    fn elevate(&self, by: usize) -> Result<Self, CurveError> {
        RationalTriangle::from_homogeneous(self.homogeneous().elevate(by))
    }
    fn subdivide(&self, p: &[C; 2]) -> Result<Vec<Self>, CurveError> {
        self.homogeneous().subdivide(p)?.into_iter().map(RationalTriangle::from_homogeneous).collect()
    }
    fn part(&self, domain: Triangle<C>) -> Result<Self, CurveError> {
        RationalTriangle::from_homogeneous(self.homogeneous().part(domain))
    }
}

#[cfg(test)]
pub(in crate::math) mod tests {
    use super::*;
    use crate::math::number::{Rational, integer as z, rational as q};
    use std::fmt::Debug;

    /// The parts are the surface, and so is the elevated one; its polar form has it on the diagonal.
    pub(in crate::math) fn check<S: Surface<Rational, Error: Debug>>(
        surface: &S,
        p: &[Rational; 2],
        diagonal: &S::Arguments,
    ) {
        let value = surface.value(p).unwrap();
        assert_eq!(value.len(), surface.dimension());
        assert_eq!(surface.blossom(p, diagonal).unwrap(), Argument::Point(value.clone()));
        assert_eq!(surface.derivative(0, 0, p).unwrap(), value.position());
        let raised = surface.elevate(2).unwrap();
        assert_eq!(raised.derivative(1, 1, p).unwrap(), surface.derivative(1, 1, p).unwrap());
        for part in surface.subdivide(p).unwrap() {
            assert_eq!(part.value(p).unwrap(), value);
        }
    }

    #[test]
    fn patches_share_their_algorithms() {
        let unit = || Interval::unit();
        let net =
            |k: i64| vec![vec![vec![z(0), z(1)], vec![z(2), z(k)]], vec![vec![z(1), z(3)], vec![z(5), z(4)]]];
        let p = [q(1, 3), q(1, 2)];
        let patch = TensorPatch::new(net(7), unit(), unit()).unwrap();
        let diagonal = p.clone().map(|t| vec![Argument::Point(t)]).into();
        check(&patch, &p, &diagonal);
        check(&RationalPatch::from_homogeneous(patch.clone()).unwrap(), &p, &diagonal);
        let part = Surface::part(&patch, (Interval::new(z(2), z(3)).unwrap(), unit())).unwrap();
        assert_eq!(part.value(&p[0], &p[1]), patch.value(&p[0], &p[1]));
        let corners = [vec![z(0), z(0)], vec![z(1), z(0)], vec![z(0), z(1)]];
        let triangle = Triangle::new(corners).unwrap();
        let points = [[0, 1], [2, 3], [1, 5], [4, 2], [7, 1], [3, 3]].map(|p| p.map(z).to_vec()).to_vec();
        let patch = TrianglePatch::new(points, triangle).unwrap();
        let p = [q(1, 3), q(1, 4)];
        let diagonal = vec![Argument::Point(p.to_vec()); 2];
        check(&patch, &p, &diagonal);
        check(&RationalTriangle::from_homogeneous(patch.clone()).unwrap(), &p, &diagonal);
        for part in patch.subdivide(&p).unwrap() {
            assert_eq!(part.value(&[q(1, 7), q(2, 5)]), patch.value(&[q(1, 7), q(2, 5)]));
        }
    }
}
