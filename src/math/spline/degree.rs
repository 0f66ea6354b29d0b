//! Raising and lowering the degree, products.
//!
//! Raising by one repeats every knot once more; the new polar form is the mean over the ways to
//! drop one argument. A product of splines of degrees m and n has at a knot the smaller of the
//! two smoothnesses, so its multiplicity there is m + n minus that.

use super::{BSpline, KnotVector, SplineError};
use crate::budget;
use crate::math::blossom::PolarForm;
use crate::math::curve::{BezierCurve, CurveError};
use crate::math::interval::Interval;
use crate::math::ring::Field;

impl<C: Field> BSpline<C> {
    /// The spline over given knots that is made of these Bézier pieces, in order.
    ///
    /// Each control point is a polar value of a piece in its support; all pieces there have to
    /// agree on it. Pieces of a lower degree are raised.
    ///
    /// # Errors
    /// [`SplineError::Domains`] unless the pieces lie on the knot intervals one by one,
    /// [`SplineError::PieceDegree`], [`SplineError::NotSmooth`] if two pieces disagree.
    pub fn from_pieces(knots: KnotVector<C>, pieces: &[BezierCurve<C>]) -> Result<Self, SplineError> {
        let n = knots.degree();
        knots.interval()?;
        let spans = knots.spans();
        let fits = |(&span, piece): (&usize, &BezierCurve<C>)| {
            piece.interval().ends() == (&knots.knots()[span], &knots.knots()[span + 1])
        };
        if spans.len() != pieces.len() || !spans.iter().zip(pieces).all(fits) {
            return Err(SplineError::Domains);
        }
        let mut forms: Vec<Vec<PolarForm<C>>> = Vec::with_capacity(pieces.len());
        for (i, piece) in pieces.iter().enumerate() {
            if piece.dimension() != pieces[0].dimension() {
                let (found, expected) = (piece.dimension(), pieces[0].dimension());
                return Err(CurveError::Dimensions { index: i, found, expected }.into());
            }
            let degree = piece.degree();
            let fitted = if degree > n {
                piece.reduce(degree - n).map_err(|_| SplineError::PieceDegree {
                    piece: i,
                    exact: piece.exact_degree(),
                    asked: n,
                })?
            } else {
                piece.elevate(n - degree)
            };
            forms.push(fitted.polar_forms());
        }
        let mut points = Vec::with_capacity(knots.count());
        for i in 0..knots.count() {
            budget::step();
            let label = knots.label(i);
            let value = |k: usize| -> Vec<C> {
                forms[k].iter().map(|form| form.value(label).expect("n arguments")).collect()
            };
            let support: Vec<usize> =
                (0..spans.len()).filter(|&k| i <= spans[k] && spans[k] <= i + n).collect();
            let first = *support.first().unwrap_or(&if i < spans[0] { 0 } else { spans.len() - 1 });
            let point = value(first);
            if let Some(&odd) = support.iter().skip(1).find(|&&k| value(k) != point) {
                return Err(SplineError::NotSmooth { knot: spans[odd] });
            }
            points.push(point);
        }
        BSpline::new(knots, points)
    }

    /// The same curve with degree n + by: every knot of the domain gains multiplicity `by`.
    ///
    /// The outermost knots of the new vector are those that the domain keeps: for clamped knots
    /// all of them. Cost: for each control point a polar value of degree n + by.
    ///
    /// # Errors
    /// None for a spline whose knots are in order; they are passed on.
    ///
    /// ```
    /// use polarform::interval::Interval;
    /// use polarform::number::{integer as z, rational as q};
    /// use polarform::spline::{BSpline, KnotVector};
    /// let knots = KnotVector::clamped(1, &[z(1)], &Interval::new(z(0), z(2))?)?;
    /// let s = BSpline::new(knots, vec![vec![z(0)], vec![z(2)], vec![z(0)]])?.elevate(1)?;
    /// assert_eq!(s.points(), [[z(0)], [z(1)], [z(2)], [z(1)], [z(0)]]);
    /// assert_eq!(s.reduce(1)?.points(), [[z(0)], [z(2)], [z(0)]]);
    /// # Ok::<(), polarform::spline::SplineError>(())
    /// ```
    pub fn elevate(&self, by: usize) -> Result<Self, SplineError> {
        budget::charge_terms((self.points().len() as u64).saturating_mul(by as u64));
        let n = self.degree();
        let repeated = self.knots().multiplicities();
        let knots: Vec<C> =
            repeated.iter().flat_map(|(knot, k)| std::iter::repeat_n(knot.clone(), k + by)).collect();
        // Keep as many knots outside of the domain as the old vector has, and n + by at most.
        let knots = self.trimmed_to_domain(&knots, n + by)?;
        let pieces: Vec<BezierCurve<C>> =
            self.bezier_pieces().iter().map(|piece| piece.elevate(by)).collect();
        BSpline::from_pieces(knots, &pieces)
    }

    /// Drops outer knots until the domain is that of self.
    pub(super) fn trimmed_to_domain(&self, knots: &[C], degree: usize) -> Result<KnotVector<C>, SplineError> {
        let (start, end) = self.interval().ends();
        let last_start = knots.iter().rposition(|knot| knot == start).ok_or(SplineError::NoDomain)?;
        let first_end = knots.iter().position(|knot| knot == end).ok_or(SplineError::NoDomain)?;
        let from = last_start.checked_sub(degree).ok_or(SplineError::NoDomain)?;
        let to = first_end + degree;
        if to >= knots.len() {
            return Err(SplineError::NoDomain);
        }
        KnotVector::new(degree, knots[from..=to].to_vec())
    }

    /// The same curve with degree n − by, if that is exact. Each knot of the domain loses the
    /// multiplicity `by` (an inner one that occurs less often is lost if the curve is smooth there).
    ///
    /// # Errors
    /// [`SplineError::PieceDegree`] with the first piece that needs the degree,
    /// [`SplineError::NotSmooth`].
    pub fn reduce(&self, by: usize) -> Result<Self, SplineError> {
        let n = self.degree();
        let pieces = self.bezier_pieces();
        for (piece, curve) in pieces.iter().enumerate() {
            let exact = curve.exact_degree();
            if by > n || exact > n - by {
                return Err(SplineError::PieceDegree { piece, exact, asked: n.saturating_sub(by) });
            }
        }
        let degree = n - by;
        let (start, end) = self.interval().ends();
        let mut knots = vec![start.clone(); degree + 1];
        let mut kept = vec![pieces[0].reduce(by)?];
        for (piece, (knot, multiplicity)) in pieces[1..].iter().zip(self.inner_knots()) {
            let reduced = piece.reduce(by)?;
            let meet = crate::math::curve::continuity_at(&kept[kept.len() - 1], &reduced, &knot)?;
            // The polynomials meet C^k: multiplicity degree − k suffices.
            let needed = if meet.same { 0 } else { meet.order.map_or(degree + 1, |k| degree - k) };
            let wanted = multiplicity.saturating_sub(by).max(needed);
            if wanted == 0 {
                let before = kept.pop().expect("there is a piece before");
                kept.push(before.part(Interval::new(
                    before.interval().start().clone(),
                    reduced.interval().end().clone(),
                )?));
            } else {
                knots.extend(vec![knot; wanted]);
                kept.push(reduced);
            }
        }
        knots.extend(vec![end.clone(); degree + 1]);
        let outer = self.outer_knots(degree, by, knots);
        BSpline::from_pieces(KnotVector::new(degree, outer)?, &kept)
    }

    /// Replaces the clamped ends by the outer knots that self has, each with its multiplicity
    /// lowered by `by`, where there are enough of them.
    fn outer_knots(&self, degree: usize, by: usize, clamped: Vec<C>) -> Vec<C> {
        let (start, end) = self.interval().ends();
        let lowered: Vec<C> = self
            .knots()
            .multiplicities()
            .iter()
            .flat_map(|(knot, k)| {
                std::iter::repeat_n(
                    knot.clone(),
                    k.saturating_sub(by).max(usize::from(knot == start || knot == end)),
                )
            })
            .collect();
        let inner = &clamped[degree + 1..clamped.len() - degree - 1];
        let before = lowered.iter().rposition(|knot| knot == start).unwrap_or(0);
        let after = lowered.iter().position(|knot| knot == end).unwrap_or(0);
        if before < degree || lowered.len() < after + degree + 1 {
            return clamped;
        }
        let mut knots = lowered[before - degree..=before].to_vec();
        knots.extend_from_slice(inner);
        knots.extend_from_slice(&lowered[after..=after + degree]);
        knots
    }

    /// The knots strictly inside of the domain with their multiplicities.
    pub fn inner_knots(&self) -> Vec<(C, usize)> {
        let spans = self.knots().spans();
        let inside = spans.iter().skip(1).map(|&j| self.knots().knots()[j].clone());
        inside.map(|knot| (knot.clone(), self.knots().multiplicity(&knot))).collect()
    }

    /// The product with another spline over the same domain, clamped: of a function and a curve,
    /// or the scalar product of two curves.
    ///
    /// # Errors
    /// [`SplineError::Domains`], [`SplineError::Unordered`] if the order of the knots of both is
    /// not known, and different dimensions.
    pub fn product(&self, other: &Self) -> Result<Self, SplineError> {
        if self.interval() != other.interval() {
            return Err(SplineError::Domains);
        }
        let (m, n) = (self.degree(), other.degree());
        let fine = |spline: &Self, by: &Self| -> Result<Self, SplineError> {
            let missing: Vec<C> = by
                .inner_knots()
                .into_iter()
                .map(|(knot, _)| knot)
                .filter(|knot| spline.knots().multiplicity(knot) == 0)
                .collect();
            spline.insert_all(&missing)
        };
        let (left, right) = (fine(self, other)?, fine(other, self)?);
        let mut pieces = Vec::new();
        for (f, g) in left.bezier_pieces().iter().zip(right.bezier_pieces()) {
            pieces.push(f.product(&g)?);
        }
        let (start, end) = self.interval().ends();
        let mut knots = vec![start.clone(); m + n + 1];
        for (knot, _) in left.inner_knots() {
            let repeated = |spline: &Self, degree| match spline.knots().multiplicity(&knot) {
                0 => 0,
                k => k + degree,
            };
            knots.extend(vec![knot.clone(); repeated(self, n).max(repeated(other, m))]);
        }
        knots.extend(vec![end.clone(); m + n + 1]);
        BSpline::from_pieces(KnotVector::new(m + n, knots)?, &pieces)
    }
}
