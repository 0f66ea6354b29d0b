//! Tensor-product B-spline surfaces.
//!
//! Control points d_ij over knots in u and in v. A row of the net is a point of a larger space, so
//! that each operation in u is that of a curve whose points are rows; in v the same on columns.
//!
//! Reference: L. Piegl, W. Tiller, *The NURBS Book* (1997), sections 3.4 and 5.3.

use super::{BSpline, KnotVector, SplineError};
use crate::math::blossom::Argument;
use crate::math::curve::transposed;
use crate::math::curve::{
    BezierCurve, CurveError, Direction, Interval, Net, Point, PolarValue, Surface, TensorPatch, Vector,
    quartered,
};
use crate::math::ring::Field;

/// A spline surface by its knots and control net.
#[derive(Clone, PartialEq)]
pub struct SplineSurface<C> {
    u: KnotVector<C>,
    v: KnotVector<C>,
    net: Net<C>,
}

/// The points of a row one after the other.
fn flat<C: Clone>(row: &[Point<C>]) -> Point<C> {
    row.iter().flat_map(|point| point.iter().cloned()).collect()
}

fn unflat<C: Clone>(row: &[C], dimension: usize) -> Vec<Point<C>> {
    row.chunks(dimension.max(1)).map(Point::from).collect()
}

impl<C: Field> SplineSurface<C> {
    /// The surface with this net: one row for each basis function in u.
    ///
    /// # Errors
    /// [`SplineError::PointCount`] for a number of rows or columns that does not fit the knots,
    /// [`CurveError::RaggedNet`], points of different dimensions, [`SplineError::NoDomain`].
    ///
    /// ```
    /// use polarform::interval::Interval;
    /// use polarform::number::{integer as z, rational as q};
    /// use polarform::spline::{KnotVector, SplineSurface};
    /// let u = KnotVector::clamped(1, &[z(1)], &Interval::new(z(0), z(2))?)?;
    /// let v = KnotVector::clamped(1, &[], &Interval::unit())?;
    /// let heights = [[0, 0], [1, 3], [2, 2]];
    /// let net = heights.map(|row| row.map(|h| vec![z(h)]).to_vec()).to_vec();
    /// let s = SplineSurface::new(u, v, net)?;
    /// assert_eq!(s.value(&q(1, 2), &q(1, 2))?, [z(1)]);
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn new(
        u: KnotVector<C>,
        v: KnotVector<C>,
        net: Vec<Vec<impl Into<Point<C>>>>,
    ) -> Result<Self, SplineError> {
        let row = |row: Vec<_>| row.into_iter().map(Into::into).collect();
        let net: Net<C> = net.into_iter().map(row).collect();
        let columns = net.first().map_or(0, Vec::len);
        if let Some(row) = net.iter().position(|row| row.len() != columns) {
            return Err(CurveError::RaggedNet { row, found: net[row].len(), expected: columns }.into());
        }
        crate::math::curve::dimension(&net.concat())?;
        for (knots, points) in [(&u, net.len()), (&v, columns)] {
            if points != knots.count() {
                let (degree, knots) = (knots.degree(), knots.knots().len());
                return Err(SplineError::PointCount { points, knots, degree });
            }
            knots.interval()?;
        }
        Ok(SplineSurface { u, v, net })
    }

    /// The knots in u and in v.
    pub fn knots(&self) -> (&KnotVector<C>, &KnotVector<C>) {
        (&self.u, &self.v)
    }

    /// The control net.
    pub fn net(&self) -> &[Vec<Point<C>>] {
        &self.net
    }

    /// The number of coordinates.
    pub fn dimension(&self) -> usize {
        self.net[0][0].len()
    }

    /// The curve in u whose points are the rows.
    fn rows(&self) -> BSpline<C> {
        let rows = self.net.iter().map(|row| flat(row)).collect();
        BSpline::new(self.u.clone(), rows).expect("the net fits its knots")
    }

    /// The surface with other rows, over other knots in u.
    fn with_rows(&self, rows: &BSpline<C>) -> Result<Self, SplineError> {
        let net = rows.points().iter().map(|row| unflat(row, self.dimension())).collect();
        SplineSurface::new(rows.knots().clone(), self.v.clone(), net)
    }

    /// The surface with u and v exchanged.
    pub fn transposed(&self) -> Self {
        SplineSurface { u: self.v.clone(), v: self.u.clone(), net: transposed(&self.net) }
    }

    /// Does something to the curves in one direction. The rule may change knots and the number of
    /// points.
    fn along(
        &self,
        direction: Direction,
        rule: impl FnOnce(&BSpline<C>) -> Result<BSpline<C>, SplineError>,
    ) -> Result<Self, SplineError> {
        match direction {
            Direction::U => self.with_rows(&rule(&self.rows())?),
            Direction::V => Ok(self.transposed().along(Direction::U, rule)?.transposed()),
        }
    }

    /// F(u, v): de Boor's algorithm in u on rows, then in v.
    ///
    /// # Errors
    /// As [`KnotVector::span_of`].
    pub fn value(&self, u: &C, v: &C) -> Result<Point<C>, SplineError> {
        let row = self.rows().value(u)?;
        BSpline::new(self.v.clone(), unflat(&row, self.dimension()))?.value(v)
    }

    /// f(u_1, …, u_m; v_1, …, v_n) of the patch on one pair of knot intervals.
    ///
    /// # Errors
    /// As [`BSpline::blossom`].
    pub fn blossom(
        &self,
        spans: (usize, usize),
        u: &[Argument<C>],
        v: &[Argument<C>],
    ) -> Result<PolarValue<C>, SplineError> {
        let row = self.rows().blossom(spans.0, u)?;
        let column = BSpline::new(self.v.clone(), unflat(row.coordinates(), self.dimension()))?;
        Ok(PolarValue::of(column.blossom(spans.1, v)?.into_point(), &[u, v].concat()))
    }

    /// The sum of two surfaces over one rectangle, over the knots of both.
    ///
    /// # Errors
    /// As [`BSpline::in_common`], and different dimensions.
    pub fn sum(&self, other: &Self) -> Result<Self, SplineError> {
        if self.dimension() != other.dimension() {
            return Err(CurveError::DimensionsOf { left: self.dimension(), right: other.dimension() }.into());
        }
        let over_common_rows = |a: &Self, b: &Self| -> Result<(Self, Self), SplineError> {
            let (rows, others) = a.rows().in_common(&b.rows())?;
            Ok((a.with_rows(&rows)?.transposed(), b.with_rows(&others)?.transposed()))
        };
        let (a, b) = over_common_rows(self, other)?;
        let (a, b) = over_common_rows(&a, &b)?;
        let row = |(p, q): (&Vec<Point<C>>, &Vec<Point<C>>)| -> Vec<Point<C>> {
            p.iter().zip(q).map(|(x, y)| x + &y.position()).collect()
        };
        SplineSurface::new(a.u.clone(), a.v.clone(), a.net.iter().zip(&b.net).map(row).collect())
    }

    /// The same surface with knots added in one direction.
    ///
    /// # Errors
    /// As [`BSpline::insert_all`].
    pub fn insert(&self, direction: Direction, knots: &[C]) -> Result<Self, SplineError> {
        self.along(direction, |spline| spline.insert_all(knots))
    }

    /// The same surface of degree (m + by_u, n + by_v).
    ///
    /// # Errors
    /// As [`BSpline::elevate`].
    pub fn elevate(&self, by_u: usize, by_v: usize) -> Result<Self, SplineError> {
        self.along(Direction::U, |spline| spline.elevate(by_u))?
            .along(Direction::V, |spline| spline.elevate(by_v))
    }

    /// The same surface of degree (m − by_u, n − by_v), where that is exact.
    ///
    /// # Errors
    /// As [`BSpline::reduce`], u first.
    pub fn reduce(&self, by_u: usize, by_v: usize) -> Result<Self, SplineError> {
        self.along(Direction::U, |spline| spline.reduce(by_u))?
            .along(Direction::V, |spline| spline.reduce(by_v))
    }

    /// ∂^{r+s}/∂u^r ∂v^s.
    ///
    /// # Errors
    /// As [`BSpline::derivative`].
    pub fn derivative(&self, r: usize, s: usize) -> Result<Self, SplineError> {
        self.along(Direction::U, |spline| spline.nth_derivative(r))?
            .along(Direction::V, |spline| spline.nth_derivative(s))
    }

    /// The two surfaces on both sides of u = t, or of v = t.
    ///
    /// # Errors
    /// As [`BSpline::subdivide`].
    ///
    /// ```
    /// use polarform::curve::Direction;
    /// use polarform::interval::Interval;
    /// use polarform::number::{integer as z, rational as q};
    /// use polarform::spline::{KnotVector, SplineSurface};
    /// let knots = KnotVector::clamped(1, &[], &Interval::unit())?;
    /// let net = [[0, 2], [4, 6]].map(|row| row.map(|h| vec![z(h)]).to_vec()).to_vec();
    /// let s = SplineSurface::new(knots.clone(), knots, net)?;
    /// let (left, right) = s.subdivide(Direction::U, &q(1, 2))?;
    /// assert_eq!(left.net(), [[[z(0)], [z(2)]], [[z(2)], [z(4)]]]);
    /// assert_eq!(right.net(), [[[z(2)], [z(4)]], [[z(4)], [z(6)]]]);
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn subdivide(&self, direction: Direction, t: &C) -> Result<(Self, Self), SplineError> {
        match direction {
            Direction::U => {
                let (left, right) = self.rows().subdivide(t)?;
                Ok((self.with_rows(&left)?, self.with_rows(&right)?))
            }
            Direction::V => {
                let (left, right) = self.transposed().subdivide(Direction::U, t)?;
                Ok((left.transposed(), right.transposed()))
            }
        }
    }

    /// The part over a smaller rectangle.
    ///
    /// # Errors
    /// As [`BSpline::part`].
    pub fn part(&self, u: Interval<C>, v: Interval<C>) -> Result<Self, SplineError> {
        self.along(Direction::U, |spline| spline.part(u.clone()))?
            .along(Direction::V, |spline| spline.part(v.clone()))
    }

    /// The Bézier patch of the knot intervals of (u, v).
    ///
    /// # Errors
    /// As [`KnotVector::span_of`].
    ///
    /// ```
    /// use polarform::interval::Interval;
    /// use polarform::number::{integer as z, rational as q};
    /// use polarform::spline::{KnotVector, SplineSurface};
    /// let knots = KnotVector::clamped(1, &[z(1)], &Interval::new(z(0), z(2))?)?;
    /// let net = [[0, 1, 0], [1, 4, 1], [0, 1, 0]].map(|row| row.map(|h| vec![z(h)]).to_vec()).to_vec();
    /// let s = SplineSurface::new(knots.clone(), knots, net)?;
    /// let patch = s.patch_at(&q(1, 2), &q(3, 2))?;
    /// assert_eq!(patch.net(), [[[z(1)], [z(0)]], [[z(4)], [z(1)]]]);
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn patch_at(&self, u: &C, v: &C) -> Result<TensorPatch<C>, SplineError> {
        let strip = self.rows().bezier_piece(self.u.span_of(u)?)?;
        let piece = self.columns(&strip).bezier_piece(self.v.span_of(v)?)?;
        Ok(self.patch(&strip, &piece))
    }

    /// The Bézier patches of all pairs of knot intervals, by rows in u.
    pub fn patches(&self) -> Vec<Vec<TensorPatch<C>>> {
        let along_v = |strip: &BezierCurve<C>| {
            let pieces = self.columns(strip).bezier_pieces();
            pieces.iter().map(|piece| self.patch(strip, piece)).collect()
        };
        self.rows().bezier_pieces().iter().map(along_v).collect()
    }

    /// The curve in v whose points are the columns over a knot interval of u.
    fn columns(&self, strip: &BezierCurve<C>) -> BSpline<C> {
        let net: Net<C> = strip.points().iter().map(|row| unflat(row, self.dimension())).collect();
        let columns = transposed(&net).iter().map(|column| flat(column)).collect();
        BSpline::new(self.v.clone(), columns).expect("the net fits its knots")
    }

    /// The patch over a knot interval of u with these columns.
    fn patch(&self, strip: &BezierCurve<C>, columns: &BezierCurve<C>) -> TensorPatch<C> {
        let net: Net<C> = columns.points().iter().map(|column| unflat(column, self.dimension())).collect();
        TensorPatch::new(transposed(&net), strip.interval().clone(), columns.interval().clone())
            .expect("all rows have one length")
    }
}

impl<C: Field> Surface<C> for SplineSurface<C> {
    type Domain = (Interval<C>, Interval<C>);
    type Arguments = (Vec<Argument<C>>, Vec<Argument<C>>);
    type Error = SplineError;
    fn dimension(&self) -> usize {
        self.dimension()
    }
    fn value(&self, [u, v]: &[C; 2]) -> Result<Point<C>, SplineError> {
        self.value(u, v)
    }
    fn blossom(&self, [u, v]: &[C; 2], (us, vs): &Self::Arguments) -> Result<PolarValue<C>, SplineError> {
        self.blossom((self.u.span_of(u)?, self.v.span_of(v)?), us, vs)
    }
    fn derivative(&self, r: usize, s: usize, [u, v]: &[C; 2]) -> Result<Vector<C>, SplineError> {
        Ok(self.patch_at(u, v)?.derivative_at(r, s, u, v))
    }
    fn elevate(&self, by: usize) -> Result<Self, SplineError> {
        self.elevate(by, by)
    }
    fn subdivide(&self, [u, v]: &[C; 2]) -> Result<Vec<Self>, SplineError> {
        quartered(self, Self::subdivide, u, v)
    }
    fn part(&self, (u, v): Self::Domain) -> Result<Self, SplineError> {
        self.part(u, v)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{Rational, integer as z, rational as q};
    use proptest::prelude::*;

    fn surface() -> impl Strategy<Value = SplineSurface<Rational>> {
        let heights = prop::collection::vec(prop::collection::vec(-9i64..10, 2), 20);
        heights.prop_map(|points| {
            let u = KnotVector::clamped(2, &[z(1), z(1)], &Interval::new(z(0), z(3)).unwrap()).unwrap();
            let v = KnotVector::uniform(3, 4, &z(-3), &z(1)).unwrap();
            let point = |k: usize| -> Point<Rational> { points[k].iter().map(|&x| z(x)).collect() };
            let net = (0..5).map(|i| (0..4).map(|j| point(4 * i + j)).collect()).collect();
            SplineSurface::new(u, v, net).unwrap()
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        #[test]
        fn every_representation_is_the_same_surface(s in surface(), i in 0i64..=12, j in 0i64..=4) {
            let (u, v) = (q(i, 4), q(j, 4));
            let value = s.value(&u, &v).unwrap();
            prop_assert_eq!(&s.transposed().value(&v, &u).unwrap(), &value);
            let fine = s.insert(Direction::U, &[q(1, 2)]).unwrap().insert(Direction::V, &[q(1, 3)]).unwrap();
            prop_assert_eq!(&fine.value(&u, &v).unwrap(), &value);
            let raised = s.elevate(0, 1).unwrap();
            prop_assert_eq!(&raised.value(&u, &v).unwrap(), &value);
            prop_assert_eq!(&raised.reduce(0, 1).unwrap().value(&u, &v).unwrap(), &value);
            let (a, b) = (s.knots().0.span_of(&u).unwrap(), s.knots().1.span_of(&v).unwrap());
            let patches = s.patches();
            let row = s.knots().0.spans().iter().position(|&k| k == a).unwrap();
            let column = s.knots().1.spans().iter().position(|&k| k == b).unwrap();
            let patch = &patches[row][column];
            prop_assert_eq!(&patch.value(&u, &v), &value);
            prop_assert_eq!(&s.patch_at(&u, &v).unwrap(), patch);
            let (us, vs) = (vec![Argument::Point(u.clone()); 2], vec![Argument::Point(v.clone()); 3]);
            prop_assert_eq!(s.blossom((a, b), &us, &vs).unwrap(), Argument::Point(value));
            let mixed = s.derivative(1, 1).unwrap();
            prop_assert_eq!(mixed.value(&u, &v).unwrap(), patch.derivative(1, 1).value(&u, &v));
            // a third of what is behind (u/2, v/2)
            let behind = |t: &Rational, end: i64| {
                let start = t / z(2);
                Interval::new(start.clone(), &start + (z(end) - &start) / z(3)).unwrap()
            };
            let (us, vs) = (behind(&u, 3), behind(&v, 1));
            let part = s.part(us.clone(), vs.clone()).unwrap();
            prop_assert_eq!((part.knots().0.interval(), part.knots().1.interval()), (Ok(&us), Ok(&vs)));
            let inside = |i: &Interval<Rational>| (i.start() + i.end() * z(2)) / z(3);
            for (u, v) in [(us.start(), vs.end()), (us.end(), &inside(&vs)), (&inside(&us), &inside(&vs))] {
                prop_assert_eq!(part.value(u, v), s.value(u, v));
            }
        }
    }

    #[test]
    fn what_is_wrong_is_said() {
        let knots = || KnotVector::clamped(1, &[], &Interval::unit()).unwrap();
        let row = || vec![vec![z(0)], vec![z(1)]];
        let ragged = SplineSurface::new(knots(), knots(), vec![row(), vec![vec![z(0)]]]);
        assert!(matches!(ragged, Err(SplineError::Curve(CurveError::RaggedNet { row: 1, .. }))));
        let short = SplineSurface::new(knots(), knots(), vec![row()]);
        assert!(matches!(short, Err(SplineError::PointCount { points: 1, .. })));
        assert!(SplineSurface::<Rational>::new(knots(), knots(), Vec::<Vec<Point<_>>>::new()).is_err());
    }
}
