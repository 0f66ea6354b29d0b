//! Derivatives, integrals and smoothness of splines.

use super::{BSpline, KnotVector, SplineError};
use crate::math::curve::{BezierCurve, Point, Vector};
use crate::math::number::{Int, Rational};
use crate::math::ring::Field;

impl<C: Field> BSpline<C> {
    /// The derivative, of degree n − 1: control points n (d_{i+1} − d_i)/(t_{i+n+1} − t_{i+1}), the
    /// outermost knots dropped. For degree 0 it is the zero function of degree 0.
    ///
    /// # Errors
    /// [`SplineError::NotSmooth`] at an inner knot of multiplicity n + 1, where the curve may jump.
    ///
    /// ```
    /// use polarform::interval::Interval;
    /// use polarform::number::integer as z;
    /// use polarform::spline::{BSpline, KnotVector};
    /// let knots = KnotVector::clamped(2, &[], &Interval::unit())?;
    /// let parabola = BSpline::new(knots, vec![vec![z(0)], vec![z(0)], vec![z(1)]])?;
    /// assert_eq!(parabola.derivative()?.points(), [[z(0)], [z(2)]]);
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn derivative(&self) -> Result<Self, SplineError> {
        let n = self.degree();
        let tight = self.tight();
        let knots = tight.knots().knots();
        if let Some((knot, _)) = self.inner_knots().into_iter().find(|(_, k)| *k > n) {
            let place = self.knots().knots().iter().position(|other| *other == knot).unwrap_or(0);
            return Err(SplineError::NotSmooth { knot: place });
        }
        if n == 0 {
            let points = vec![Vector::zero(self.dimension()).from_origin(); self.points().len()];
            return BSpline::new(self.knots().clone(), points);
        }
        let degree = Rational::from_integer(Int::from(n));
        let points = tight.points().windows(2).enumerate().map(|(i, pair)| {
            let unit = knots[i + n + 1].minus(&knots[i + 1]).inverse();
            let unit = unit.expect("inner knots have multiplicity n at most");
            ((&pair[1] - &pair[0]) * &unit.scaled(&degree)).from_origin()
        });
        let points: Vec<Point<C>> = points.collect();
        let inner = KnotVector::new(n - 1, knots[1..knots.len() - 1].to_vec())?;
        BSpline::new(inner, points)
    }

    /// The same curve without the control points that have no influence: those whose basis function
    /// vanishes on the domain, with t_{i+n+1} at its start or t_i at its end.
    pub fn tight(&self) -> Self {
        let n = self.degree();
        let knots = self.knots().knots();
        let (start, end) = self.interval().ends();
        let from = knots.iter().rposition(|knot| knot == start).unwrap_or(n).saturating_sub(n);
        let last = knots.iter().position(|knot| knot == end).unwrap_or(self.points().len());
        let (knots, points) = (knots[from..=last + n].to_vec(), self.points()[from..last].to_vec());
        KnotVector::new(n, knots)
            .and_then(|knots| BSpline::new(knots, points))
            .unwrap_or_else(|_| self.clone())
    }

    /// The k-th derivative.
    ///
    /// # Errors
    /// As [`BSpline::derivative`].
    pub fn nth_derivative(&self, k: usize) -> Result<Self, SplineError> {
        (0..k.min(self.degree() + 1)).try_fold(self.clone(), |spline, _| spline.derivative())
    }

    /// The antiderivative of degree n + 1 that is 0 at the start of the domain:
    /// e_{i+1} = e_i + (t_{i+n+1} − t_i)/(n+1) d_i, the outermost knots repeated once more.
    ///
    /// # Errors
    /// None for a valid spline; those of [`BSpline::new`] are passed on.
    pub fn antiderivative(&self) -> Result<Self, SplineError> {
        let n = self.degree();
        let knots = self.knots().knots();
        let share = Rational::new(Int::ONE, Int::from(n + 1));
        let mut points = vec![Vector::zero(self.dimension()).from_origin()];
        for (i, point) in self.points().iter().enumerate() {
            let weight = knots[i + n + 1].minus(&knots[i]).scaled(&share);
            points.push(&points[i] + &(point.position() * &weight));
        }
        let mut longer = vec![knots[0].clone()];
        longer.extend_from_slice(knots);
        longer.push(knots[knots.len() - 1].clone());
        let primitive = BSpline::new(KnotVector::new(n + 1, longer)?, points)?;
        let start = primitive.value(primitive.interval().start())?;
        let points = primitive.points().iter().map(|point| (point - &start).from_origin()).collect();
        BSpline::new(primitive.knots().clone(), points)
    }

    /// The integral over the domain, of position vectors.
    pub fn integral(&self) -> Vector<C> {
        let zero = Vector::zero(self.dimension());
        self.bezier_pieces().iter().fold(zero, |total, piece| total + piece.integral())
    }

    /// For each knot inside of the domain: its multiplicity s, the smoothness n − s that the
    /// knots promise (−1: a jump), and the exact one of this curve (`None`: a jump; `Some(n)` if the
    /// pieces are one polynomial).
    pub fn smoothness(&self) -> Vec<(C, usize, Option<usize>)> {
        let pieces: Vec<BezierCurve<C>> = self.bezier_pieces();
        let knots = self.inner_knots();
        pieces
            .windows(2)
            .zip(knots)
            .map(|(pair, (knot, multiplicity))| {
                let order = crate::math::curve::continuity_at(&pair[0], &pair[1], &knot)
                    .expect("the pieces have one dimension")
                    .order;
                (knot, multiplicity, order)
            })
            .collect()
    }
}
