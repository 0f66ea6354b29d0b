//! B-spline curves: values, polar forms of their pieces, de Boor's algorithm.

use super::{KnotVector, SplineError};
use crate::budget;
use crate::math::blossom::Argument;
use crate::math::curve::{BezierCurve, Point, PolarValue, Tableau, dimension, lerp};
use crate::math::interval::Interval;
use crate::math::number::Rational;
use crate::math::piecewise::{Outside, Piecewise};
use crate::math::ring::Field;

/// A spline curve by its knots and control points.
#[derive(Clone, PartialEq)]
pub struct BSpline<C> {
    knots: KnotVector<C>,
    points: Vec<Point<C>>,
}

/// De Boor's tableau together with its ratios.
#[derive(Clone, PartialEq)]
pub struct DeBoor<C> {
    /// The knot interval.
    pub span: usize,
    /// The points and their labels.
    pub tableau: Tableau<C>,
    /// `ratios[r][i]` = (u − t_k)/(t_{k+n−r} − t_k): how point i of level r + 1 lies between points
    /// i and i + 1 of level r.
    pub ratios: Vec<Vec<C>>,
}

debug_by_fields!(DeBoor: span, tableau, ratios);

impl<C: Field> BSpline<C> {
    /// The spline with these control points.
    ///
    /// # Errors
    /// [`SplineError::PointCount`], [`SplineError::NoDomain`], and points of different dimensions.
    ///
    /// ```
    /// use polarform::interval::Interval;
    /// use polarform::number::{integer as z, rational as q};
    /// use polarform::spline::{BSpline, KnotVector};
    /// let knots = KnotVector::clamped(2, &[z(1)], &Interval::new(z(0), z(2))?)?;
    /// let points = [(0, 0), (1, 2), (3, 2), (4, 0)].map(|(x, y)| vec![z(x), z(y)]).to_vec();
    /// let s = BSpline::new(knots, points)?;
    /// assert_eq!(s.value(&z(1))?, [z(2), z(2)]);
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn new(knots: KnotVector<C>, points: Vec<impl Into<Point<C>>>) -> Result<Self, SplineError> {
        let points: Vec<Point<C>> = points.into_iter().map(Into::into).collect();
        dimension(&points)?;
        if points.len() != knots.count() {
            return Err(SplineError::PointCount {
                points: points.len(),
                knots: knots.knots().len(),
                degree: knots.degree(),
            });
        }
        knots.interval()?;
        Ok(BSpline { knots, points })
    }

    /// The closed spline over one period: knots t_0 < … < t_m (t_m is t_0 one period later) and m
    /// control points; both are continued periodically. The domain is [t_0, t_m].
    ///
    /// # Errors
    /// [`SplineError::TooFewKnots`] for fewer than 2 knots, [`SplineError::PointCount`], and as
    /// [`BSpline::new`].
    pub fn periodic(degree: usize, period: &[C], points: &[Point<C>]) -> Result<Self, SplineError> {
        let m = period.len().saturating_sub(1);
        if m == 0 {
            return Err(SplineError::TooFewKnots { degree, needed: 2, given: period.len() });
        }
        if points.len() != m {
            return Err(SplineError::PointCount { points: points.len(), knots: m + 1, degree: 0 });
        }
        budget::charge_terms((m as u64).saturating_add(degree as u64).saturating_mul(2));
        let length = period[m].minus(&period[0]);
        // t_{i + km} = t_i + k (t_m − t_0)
        let knot = |i: i64| {
            let (turn, place) = (i.div_euclid(m as i64), i.rem_euclid(m as i64));
            let turns = crate::math::number::Rational::from_integer(crate::math::number::Int::from(turn));
            period[place as usize].plus(&length.scaled(&turns))
        };
        let n = degree as i64;
        let knots = KnotVector::new(degree, (-n..=m as i64 + n).map(knot).collect())?;
        let points = (0..m + degree).map(|i| points[i % m].clone()).collect();
        BSpline::new(knots, points)
    }

    /// The polynomial with these polar forms as a spline over these knots: d_i = f(t_{i+1}, …, t_{i+n}).
    /// For F(t) = (x − t)^n this is Marsden's identity.
    ///
    /// # Errors
    /// [`SplineError::PieceDegree`] if the degree of the knots is too small, and as [`BSpline::new`].
    pub fn of_polynomial(
        knots: KnotVector<C>,
        forms: &[crate::math::blossom::PolarForm<C>],
    ) -> Result<Self, SplineError> {
        let n = knots.degree();
        let mut raised = Vec::with_capacity(forms.len());
        for form in forms {
            if form.degree() > n {
                return Err(SplineError::PieceDegree { piece: 0, exact: form.degree(), asked: n });
            }
            raised.push(form.elevate(n - form.degree()));
        }
        let point = |i: usize| {
            let at =
                |form: &crate::math::blossom::PolarForm<C>| form.value(knots.label(i)).expect("n arguments");
            raised.iter().map(at).collect()
        };
        let points: Vec<Point<C>> = (0..knots.count()).map(point).collect();
        BSpline::new(knots, points)
    }

    /// The knots.
    pub fn knots(&self) -> &KnotVector<C> {
        &self.knots
    }

    /// The control points.
    pub fn points(&self) -> &[Point<C>] {
        &self.points
    }

    /// The degree n.
    pub fn degree(&self) -> usize {
        self.knots.degree()
    }

    /// The number of coordinates.
    pub fn dimension(&self) -> usize {
        self.points[0].len()
    }

    /// [t_n, t_m], the domain.
    pub fn interval(&self) -> &Interval<C> {
        self.knots.interval().expect("a spline has a domain")
    }

    /// f_j(u_1, …, u_n): the polar form of the piece on [t_j, t_{j+1}], by de Boor's scheme.
    ///
    /// Cost: n²/2 affine combinations, of integers over one denominator if everything is a number.
    ///
    /// # Errors
    /// [`SplineError::NoDomain`] unless j is one of [`KnotVector::spans`];
    /// [`crate::math::curve::CurveError::Arguments`] unless there are n arguments.
    pub fn blossom(&self, span: usize, arguments: &[Argument<C>]) -> Result<PolarValue<C>, SplineError> {
        self.check(span, arguments.len())?;
        let value = self.blossom_of_numbers(span, arguments);
        let value = value.unwrap_or_else(|| self.blossom_by_steps(span, arguments));
        Ok(PolarValue::of(value, arguments))
    }

    /// `None` unless everything is a number.
    fn blossom_of_numbers(&self, span: usize, arguments: &[Argument<C>]) -> Option<Point<C>> {
        let number = |argument: &Argument<C>| match argument {
            Argument::Point(u) => u.as_rational(),
            Argument::Vector(_) => None,
        };
        let arguments: Vec<Rational> = arguments.iter().map(number).collect::<Option<_>>()?;
        let n = self.degree();
        let knots: Vec<Rational> =
            self.knots.knots()[span + 1 - n..=span + n].iter().map(C::as_rational).collect::<Option<_>>()?;
        let coordinates = |point: &Point<C>| point.iter().map(C::as_rational).collect();
        let points: Vec<Vec<Rational>> =
            self.points[span - n..=span].iter().map(coordinates).collect::<Option<_>>()?;
        let value = super::integers::de_boor(&knots, &points, &arguments);
        Some(value.iter().map(C::from_rational).collect())
    }

    /// The same over any field.
    pub(super) fn blossom_by_steps(&self, span: usize, arguments: &[Argument<C>]) -> Point<C> {
        let n = self.degree();
        let mut level = self.points[span - n..=span].to_vec();
        for (r, argument) in arguments.iter().enumerate() {
            budget::step();
            level = self.step(span, r, &level, argument);
        }
        level.swap_remove(0)
    }

    fn check(&self, span: usize, arguments: usize) -> Result<(), SplineError> {
        let n = self.degree();
        if span < n || span >= self.points.len() || self.knots.knots()[span] == self.knots.knots()[span + 1] {
            return Err(SplineError::NoDomain);
        }
        if arguments != n {
            return Err(crate::math::curve::CurveError::Arguments { expected: n, given: arguments }.into());
        }
        Ok(())
    }

    /// 1/(t_{k+n−r} − t_k) and t_k for point i of level r + 1, where k = span − n + r + 1 + i.
    fn between(&self, span: usize, r: usize, i: usize) -> (C, &C) {
        let n = self.degree();
        let k = span + r + 1 + i - n;
        let (start, end) = (&self.knots.knots()[k], &self.knots.knots()[k + n - r]);
        (end.minus(start).inverse().expect("the interval contains the span"), start)
    }

    fn step(&self, span: usize, r: usize, level: &[Point<C>], argument: &Argument<C>) -> Vec<Point<C>> {
        level
            .windows(2)
            .enumerate()
            .map(|(i, pair)| {
                let (unit, start) = self.between(span, r, i);
                match argument {
                    Argument::Point(u) => lerp(&pair[0], &pair[1], &u.minus(start).times(&unit)),
                    Argument::Vector(v) => ((&pair[1] - &pair[0]) * &v.times(&unit)).from_origin(),
                }
            })
            .collect()
    }

    /// F(t).
    ///
    /// # Errors
    /// As [`KnotVector::span_of`].
    pub fn value(&self, t: &C) -> Result<Point<C>, SplineError> {
        let span = self.knots.span_of(t)?;
        self.value_on(span, t)
    }

    /// The value at t of the polynomial of one knot interval, wherever t is.
    ///
    /// # Errors
    /// As [`BSpline::blossom`].
    pub fn value_on(&self, span: usize, t: &C) -> Result<Point<C>, SplineError> {
        Ok(self.blossom(span, &vec![Argument::Point(t.clone()); self.degree()])?.into_point())
    }

    /// De Boor's tableau for f_j(u_1, …, u_n) with labels and ratios.
    ///
    /// # Errors
    /// As [`BSpline::blossom`].
    pub fn de_boor(&self, span: usize, arguments: &[C]) -> Result<DeBoor<C>, SplineError> {
        self.check(span, arguments.len())?;
        let n = self.degree();
        budget::charge_terms((n as u64 + 1) * (n as u64 + 2));
        let mut levels = vec![self.points[span - n..=span].to_vec()];
        let mut ratios = Vec::with_capacity(n);
        for (r, u) in arguments.iter().enumerate() {
            let level = &levels[levels.len() - 1];
            let ratio = |i: usize| {
                let (unit, start) = self.between(span, r, i);
                u.minus(start).times(&unit)
            };
            ratios.push((0..level.len() - 1).map(ratio).collect());
            levels.push(self.step(span, r, level, &Argument::Point(u.clone())));
        }
        // Point i of level r: t_{k+1}, …, t_{k+n−r} with k = span − n + r + i, and u_1, …, u_r between
        // the knots before the interval and those after it.
        let label = |r: usize, i: usize| {
            let k = span + r + i - n;
            let knots = self.knots.knots();
            let before = &knots[k + 1..=(k + n - r).min(span)];
            let after = &knots[(span + 1).max(k + 1)..=k + n - r];
            before.iter().chain(&arguments[..r]).chain(after).cloned().collect()
        };
        let labels = (0..=n).map(|r| (0..=n - r).map(|i| label(r, i)).collect()).collect();
        Ok(DeBoor { span, tableau: Tableau { levels, labels }, ratios })
    }

    /// The Bézier curve of one knot interval: f_j(t_j^{n−i}, t_{j+1}^i).
    ///
    /// # Errors
    /// As [`BSpline::blossom`].
    pub fn bezier_piece(&self, span: usize) -> Result<BezierCurve<C>, SplineError> {
        self.check(span, self.degree())?;
        let n = self.degree();
        let (a, b) = (self.knots.knots()[span].clone(), self.knots.knots()[span + 1].clone());
        let mut points = Vec::with_capacity(n + 1);
        // The scheme for t_j is shared: its level i is finished with t_{j+1}.
        let mut start = self.points[span - n..=span].to_vec();
        for r in 0..=n {
            let mut level = start.clone();
            for s in r..n {
                budget::step();
                level = self.step(span, s, &level, &Argument::Point(b.clone()));
            }
            points.push(level.swap_remove(0));
            if r < n {
                start = self.step(span, r, &start, &Argument::Point(a.clone()));
            }
        }
        points.reverse();
        Ok(BezierCurve::new(points, Interval::new(a, b)?)?)
    }

    /// The Bézier curves of all knot intervals of the domain.
    pub fn bezier_pieces(&self) -> Vec<BezierCurve<C>> {
        let piece = |j| self.bezier_piece(j).expect("a span of the domain");
        self.knots.spans().into_iter().map(piece).collect()
    }

    /// Each coordinate as a piecewise polynomial in powers of t.
    pub fn power_pieces(&self) -> Vec<Piecewise<C>> {
        let pieces: Vec<Vec<Vec<C>>> = self.bezier_pieces().iter().map(BezierCurve::power).collect();
        let spans = self.knots.spans();
        let mut breaks: Vec<C> = spans.iter().map(|&j| self.knots.knots()[j].clone()).collect();
        breaks.push(self.interval().end().clone());
        (0..self.dimension())
            .map(|k| {
                let column = pieces.iter().map(|piece| piece[k].clone()).collect();
                Piecewise::new(breaks.clone(), column, Outside::Undefined).expect("knots do not decrease")
            })
            .collect()
    }
}
