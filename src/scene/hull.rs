//! The convex hull of points in the plane, exactly.
//!
//! Reference: A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions",
//! Inform. Process. Lett. 9 (1979).

use num_traits::Signed;

use crate::budget;
use crate::number::Rational;

/// The corners of the convex hull against the clock, from the one with the least x (then y).
///
/// No three corners are on a line; equal points count once, so one or two corners may be left.
/// Cost: n log n comparisons and products of rationals.
///
/// ```
/// use polarform::number::integer as z;
/// use polarform::scene::convex_hull;
/// let square = [[0, 0], [2, 2], [1, 1], [2, 0], [0, 2], [1, 0]].map(|p| p.map(z));
/// assert_eq!(convex_hull(&square), [[0, 0], [2, 0], [2, 2], [0, 2]].map(|p| p.map(z)));
/// ```
pub fn convex_hull(points: &[[Rational; 2]]) -> Vec<[Rational; 2]> {
    let mut sorted: Vec<&[Rational; 2]> = points.iter().collect();
    sorted.sort();
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted.into_iter().cloned().collect();
    }
    let mut hull = chain(sorted.iter().copied());
    let upper = chain(sorted.iter().rev().copied());
    // each chain ends where the other begins
    hull.pop();
    hull.extend(&upper[..upper.len() - 1]);
    hull.into_iter().cloned().collect()
}

/// One half of the boundary: only turns to the left.
fn chain<'a>(points: impl Iterator<Item = &'a [Rational; 2]>) -> Vec<&'a [Rational; 2]> {
    let mut chain: Vec<&[Rational; 2]> = Vec::new();
    for point in points {
        budget::step();
        while let [.., first, second] = chain.as_slice()
            && !cross(first, second, point).is_positive()
        {
            chain.pop();
        }
        chain.push(point);
    }
    chain
}

/// Twice the signed area of the triangle a, b, c: positive when it turns to the left.
fn cross(a: &[Rational; 2], b: &[Rational; 2], c: &[Rational; 2]) -> Rational {
    let across = |i: usize, j: usize| (&b[i] - &a[i]) * (&c[j] - &a[j]);
    across(0, 1) - across(1, 0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::integer;
    use num_traits::Zero;
    use proptest::prelude::*;

    fn points() -> impl Strategy<Value = Vec<[Rational; 2]>> {
        // few values, so that equal points and points on a line are common
        proptest::collection::vec((-4_i64..5, -4_i64..5), 0..14)
            .prop_map(|list| list.into_iter().map(|(x, y)| [integer(x), integer(y)]).collect())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn all_points_inside(points in points()) {
            let hull = convex_hull(&points);
            prop_assert!(hull.iter().all(|corner| points.contains(corner)));
            if hull.len() < 3 {
                // everything on the line between the two corners
                if let [a, b] = hull.as_slice() {
                    prop_assert!(points.iter().all(|p| cross(a, b, p).is_zero() && a <= p && p <= b));
                }
                return Ok(());
            }
            for (i, a) in hull.iter().enumerate() {
                let b = &hull[(i + 1) % hull.len()];
                prop_assert!(points.iter().all(|p| !cross(a, b, p).is_negative()));
                prop_assert!(cross(a, b, &hull[(i + 2) % hull.len()]).is_positive());
            }
        }
    }

    #[test]
    fn degenerate() {
        assert!(convex_hull(&[]).is_empty());
        let one = [integer(1), integer(2)];
        assert_eq!(convex_hull(&[one.clone(), one.clone(), one.clone()]), [one]);
    }
}
