//! Convex hulls of points in the plane, exact.
//!
//! A Bézier curve lies in the convex hull of its control points, because the Bernstein
//! polynomials are not negative on [0, 1] and sum to 1.
//!
//! Reference: A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions",
//! Information Processing Letters 9 (1979).

use num_traits::Signed;

use super::{CurveError, Point, dimension};
use crate::math::number::Rational;

/// (q − p) × (r − p): positive if r lies to the left of the line from p to q.
fn turn(p: &[Rational], q: &[Rational], r: &[Rational]) -> Rational {
    (&q[0] - &p[0]) * (&r[1] - &p[1]) - (&q[1] - &p[1]) * (&r[0] - &p[0])
}

/// The corners of the convex hull of points in the plane, counterclockwise from the one that is
/// lowest in the order of coordinates; no three of them on a line. Cost: O(n log n).
///
/// # Errors
/// [`CurveError::TooFewPoints`] without points, [`CurveError::Dimensions`], and
/// [`CurveError::DimensionsOf`] unless they have two coordinates.
///
/// ```
/// use polarform::curve::{Point, convex_hull};
/// use polarform::number::integer as z;
/// let points = [[0, 0], [1, 1], [2, 0], [1, 3]].map(|p| Point::from(p.map(z)));
/// assert_eq!(convex_hull(&points)?, [[0, 0], [2, 0], [1, 3]].map(|p| p.map(z)));
/// # Ok::<(), polarform::curve::CurveError>(())
/// ```
pub fn convex_hull(points: &[Point<Rational>]) -> Result<Vec<Point<Rational>>, CurveError> {
    let size = dimension(points)?;
    if size != 2 {
        return Err(CurveError::DimensionsOf { left: size, right: 2 });
    }
    let mut sorted = points.to_vec();
    sorted.sort_by(|p, q| p.cmp(q));
    sorted.dedup();
    if sorted.len() < 3 {
        return Ok(sorted);
    }
    let chain = |points: &mut dyn Iterator<Item = &Point<Rational>>| {
        let mut hull: Vec<Point<Rational>> = Vec::new();
        for point in points {
            while hull.len() >= 2 && !turn(&hull[hull.len() - 2], &hull[hull.len() - 1], point).is_positive()
            {
                hull.pop();
            }
            hull.push(point.clone());
        }
        hull.pop();
        hull
    };
    let mut hull = chain(&mut sorted.iter());
    hull.extend(chain(&mut sorted.iter().rev()));
    Ok(hull)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::{BezierCurve, Interval};
    use crate::math::number::{integer as z, rational as q};
    use num_traits::Zero;
    use proptest::prelude::*;

    /// Whether a point lies in a convex polygon given counterclockwise, its border included. A
    /// polygon of one or two corners is a point or a segment.
    fn in_convex_polygon(corners: &[Point<Rational>], p: &[Rational]) -> bool {
        match corners {
            [] => false,
            [only] => only == p,
            [a, b] => {
                let along = |k: usize| {
                    let (low, high) = if a[k] <= b[k] { (&a[k], &b[k]) } else { (&b[k], &a[k]) };
                    low <= &p[k] && &p[k] <= high
                };
                turn(a, b, p).is_zero() && along(0) && along(1)
            }
            _ => (0..corners.len())
                .all(|i| !turn(&corners[i], &corners[(i + 1) % corners.len()], p).is_negative()),
        }
    }

    proptest! {
        #[test]
        fn the_hull_holds_the_points_and_the_curve(
            raw in prop::collection::vec((-5i64..6, -5i64..6), 1..9), k in 0i64..=16
        ) {
            let points: Vec<Point<Rational>> = raw.iter().map(|&(x, y)| [z(x), z(y)].into()).collect();
            let hull = convex_hull(&points).unwrap();
            prop_assert!(points.iter().all(|p| in_convex_polygon(&hull, p)));
            prop_assert!(hull.iter().all(|p| points.contains(p)));
            prop_assert_eq!(convex_hull(&hull).unwrap(), hull.clone());
            let curve = BezierCurve::new(points, Interval::unit()).unwrap();
            prop_assert!(in_convex_polygon(&hull, &curve.value(&q(k, 16))));
            prop_assert!(!in_convex_polygon(&hull, &[z(6), z(6)]));
        }
    }

    #[test]
    fn degenerate_hulls() {
        let p = Point::from([z(1), z(2)]);
        assert_eq!(convex_hull(&[p.clone(), p.clone()]), Ok(vec![p]));
        let line: Vec<Point<Rational>> = (0..5).map(|k| [z(k), z(2 * k)].into()).collect();
        assert_eq!(convex_hull(&line), Ok(vec![line[0].clone(), line[4].clone()]));
        assert!(convex_hull(&[[z(1)].into()]).is_err());
    }
}
