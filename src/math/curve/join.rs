//! How smoothly two curves meet.
//!
//! **Parametric continuity.** F over [a, b] and G over [b, c] meet C^k at b iff
//! f(b^{n−j}, ·) and g(b^{n−j}, ·) agree for j ≤ k: by values f(b^{n−j}, c^j) = g(b^{n−j}, c^j),
//! or by hats f(b^{n−j}, 1̂^j) = g(b^{n−j}, 1̂^j), that is, equal derivatives. As g(b^{n−j} c^j)
//! is a control point of G, these are equations between control points.
//!
//! Reference: L. Ramshaw, "Blossoms are polar forms", CAGD 6 (1989).

use super::{BezierCurve, CurveError, Point, PolarValue};
use crate::math::blossom::Argument;
use crate::math::ring::Field;

/// One condition for C^k: what a control point of the second curve has to be.
#[derive(Clone, PartialEq)]
pub struct JoiningCondition<C> {
    /// The order j of the condition.
    pub order: usize,
    /// The arguments b^{n−j}, c^j of both polar forms.
    pub label: Vec<C>,
    /// f(b^{n−j}, c^j), from the first curve.
    pub required: Point<C>,
    /// g(b^{n−j}, c^j), the j-th control point of the second curve.
    pub found: Point<C>,
}

debug_by_fields!(JoiningCondition: order, label, required, found);

impl<C: Field> JoiningCondition<C> {
    /// Whether it holds.
    pub fn holds(&self) -> bool {
        self.required == self.found
    }
}

fn meeting<'a, C: Field>(
    left: &'a BezierCurve<C>,
    right: &'a BezierCurve<C>,
) -> Result<(&'a C, &'a C), CurveError> {
    if left.dimension() != right.dimension() {
        return Err(CurveError::DimensionsOf { left: left.dimension(), right: right.dimension() });
    }
    let (at, end) = right.interval().ends();
    if left.interval().end() != at {
        return Err(CurveError::NoCommonEnd);
    }
    Ok((at, end))
}

/// The conditions for the two curves to meet C^k where the first interval ends, for orders
/// 0, …, k (at most n). Cost: k de Casteljau schemes.
///
/// # Errors
/// [`CurveError::Degrees`], [`CurveError::DimensionsOf`], [`CurveError::NoCommonEnd`].
///
/// ```
/// use polarform::curve::{BezierCurve, Interval, joining_conditions};
/// use polarform::number::integer as z;
/// let f = BezierCurve::new(vec![vec![z(0)], vec![z(1)]], Interval::unit())?;
/// let g = BezierCurve::new(vec![vec![z(1)], vec![z(3)]], Interval::new(z(1), z(3))?)?;
/// assert!(joining_conditions(&f, &g, 1)?.iter().all(|condition| condition.holds()));
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn joining_conditions<C: Field>(
    left: &BezierCurve<C>,
    right: &BezierCurve<C>,
    k: usize,
) -> Result<Vec<JoiningCondition<C>>, CurveError> {
    let (at, end) = meeting(left, right)?;
    let n = left.degree();
    if right.degree() != n {
        return Err(CurveError::Degrees { left: n, right: right.degree() });
    }
    (0..=k.min(n))
        .map(|j| {
            let label: Vec<C> =
                std::iter::repeat_n(at, n - j).chain(std::iter::repeat_n(end, j)).cloned().collect();
            let arguments: Vec<Argument<C>> = label.iter().cloned().map(Argument::Point).collect();
            let required = left.blossom(&arguments)?.into_point();
            Ok(JoiningCondition { order: j, label, required, found: right.points()[j].clone() })
        })
        .collect()
}

/// Up to which order two curves meet, and the first order that fails.
#[derive(Clone, PartialEq)]
pub struct Continuity<C> {
    /// The largest k with C^k; `None` if not even the points agree; the degree if the two are
    /// one polynomial.
    pub order: Option<usize>,
    /// Whether the two are the same polynomial, hence C^∞.
    pub same: bool,
    /// The first condition that fails: the order, and f(t^{n−j}, 1̂^j) for both.
    pub failure: Option<(usize, PolarValue<C>, PolarValue<C>)>,
}

debug_by_fields!(Continuity: order, same, failure);

/// Up to which order two polynomial curves agree at t, by hats: f(t^{n−j}, 1̂^j) for j = 0, 1, ….
///
/// The curves need not have the same degree or interval: the lower degree is raised.
///
/// # Errors
/// [`CurveError::DimensionsOf`].
pub fn continuity_at<C: Field>(
    left: &BezierCurve<C>,
    right: &BezierCurve<C>,
    t: &C,
) -> Result<Continuity<C>, CurveError> {
    if left.dimension() != right.dimension() {
        return Err(CurveError::DimensionsOf { left: left.dimension(), right: right.dimension() });
    }
    let n = left.degree().max(right.degree());
    let (left, right) = (left.elevate(n - left.degree()), right.elevate(n - right.degree()));
    let mut order = None;
    for j in 0..=n {
        let mut arguments = vec![Argument::Point(t.clone()); n - j];
        arguments.extend(vec![Argument::Vector(C::one()); j]);
        let (f, g) = (left.blossom(&arguments)?, right.blossom(&arguments)?);
        if f != g {
            return Ok(Continuity { order, same: false, failure: Some((j, f, g)) });
        }
        order = Some(j);
    }
    Ok(Continuity { order, same: true, failure: None })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::Interval;
    use crate::math::curve::bezier::tests::any_curve;
    use crate::math::number::integer as z;
    use crate::math::poly::{Fraction, MultiPoly, Symbol};
    use proptest::prelude::*;

    proptest! {
        /// The three ways to ask for C^k agree: control points, hats, derivatives.
        #[test]
        fn three_ways_agree(f in any_curve(), k in 0usize..4, extra in 1i64..4) {
            let n = f.degree();
            let (_, b) = f.interval().ends();
            let c = b + z(extra);
            // The continuation of f, changed from control point k + 1 on: exactly C^k.
            let mut points = f.part(Interval::new(b.clone(), c.clone()).unwrap()).points().to_vec();
            if k < n {
                points[k + 1][0] += z(1);
            }
            let g = BezierCurve::new(points, Interval::new(b.clone(), c).unwrap()).unwrap();
            let conditions = joining_conditions(&f, &g, n).unwrap();
            let by_points = conditions.iter().take_while(|c| c.holds()).count().checked_sub(1);
            let by_hats = continuity_at(&f, &g, b).unwrap();
            let by_derivatives =
                (0..=n).take_while(|&j| f.nth_derivative(j).value(b) == g.nth_derivative(j).value(b)).count().checked_sub(1);
            prop_assert_eq!(by_points, by_hats.order);
            prop_assert_eq!(by_derivatives, by_hats.order);
            prop_assert_eq!(by_points, Some(k.min(n)));
            prop_assert_eq!(by_hats.same, k >= n);
        }
    }

    #[test]
    fn the_cubic_conditions_in_symbols() {
        let symbol = |name: &str, i: i64| Fraction::from(MultiPoly::symbol(Symbol::indexed(name, i)));
        let net = |name: &str| (0..4).map(|i| vec![symbol(name, i)]).collect::<Vec<_>>();
        let number = |k| Fraction::from_rational(&z(k));
        use crate::math::ring::Ring;
        let f = BezierCurve::new(net("b"), Interval::unit()).unwrap();
        let after = Interval::new(number(1), number(2)).unwrap();
        let g = BezierCurve::new(net("c"), after.clone()).unwrap();
        let conditions = joining_conditions(&f, &g, 2).unwrap();
        // c_0 = b_3, c_1 = 2 b_3 − b_2, c_2 = b_1 − 4 b_2 + 4 b_3
        let scaled = |k, x: Fraction| x.scaled(&z(k));
        assert_eq!(conditions[1].required, [scaled(2, symbol("b", 3)) - symbol("b", 2)]);
        let second = symbol("b", 1) + scaled(-4, symbol("b", 2)) + scaled(4, symbol("b", 3));
        assert_eq!(conditions[2].required, [second]);
        assert_eq!(conditions[2].found, [symbol("c", 2)]);
        let short = BezierCurve::new(vec![vec![number(0)]], after).unwrap();
        assert_eq!(joining_conditions(&f, &short, 1), Err(CurveError::Degrees { left: 3, right: 0 }));
        assert_eq!(joining_conditions(&g, &f, 1), Err(CurveError::NoCommonEnd));
    }
}
