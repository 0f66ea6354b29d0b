//! Curves as cubic Bézier pieces.
//!
//! A polynomial curve of degree at most 3 is one piece, by raising the degree, without loss.
//! Others are halved (de Casteljau) until the cubic with the same ends and derivatives there
//! differs from the curve by less than a small part of its size at the quarter points.
//!
//! Reference: G. Farin, *Curves and Surfaces for CAGD*, 5th ed. (2002), chapters 5 and 13.

use crate::budget;

use super::{SceneError, Segment, Spot};

/// The difference allowed, in parts of the size of the control polygon: 1/10 pixel of 500.
const TOLERANCE: f64 = 2e-4;

/// At most 2^12 pieces for a curve.
const DEPTH: u32 = 12;

/// The Bézier curve with these control points as pieces that follow its first point.
///
/// Cost: n² for each piece; cubics and below are exact.
///
/// # Errors
/// [`SceneError::Empty`] without control points.
///
/// ```
/// use polarform::scene::{Segment, Spot, bezier_path};
/// let [a, b] = [Spot::new(0.0, 0.0)?, Spot::new(3.0, 6.0)?];
/// assert_eq!(bezier_path(&[a, b])?, [Segment::Line(b)]);
/// # Ok::<(), polarform::scene::SceneError>(())
/// ```
pub fn bezier_path(points: &[Spot]) -> Result<Vec<Segment>, SceneError> {
    match points {
        [] => Err(SceneError::Empty { what: "control points" }),
        [_] => Ok(Vec::new()),
        [_, b] => Ok(vec![Segment::Line(*b)]),
        [a, b, c] => Ok(vec![Segment::Cubic([a.toward(*b, 2.0 / 3.0), c.toward(*b, 2.0 / 3.0), *c])]),
        [_, b, c, d] => Ok(vec![Segment::Cubic([*b, *c, *d])]),
        many => {
            let homogeneous: Vec<[f64; 3]> = many.iter().map(|p| [p.x(), p.y(), 1.0]).collect();
            approximate(&homogeneous, "the curve")
        }
    }
}

/// The rational Bézier curve with homogeneous control points (w x, w y, w).
///
/// Points with w = 0 are vectors; the whole may be multiplied by any number.
///
/// # Errors
/// [`SceneError::AtInfinity`] when the weight w(t) vanishes for some t in [0, 1];
/// [`SceneError::Empty`] without points; [`SceneError::TooLarge`].
pub fn rational_bezier_path(points: &[[f64; 3]]) -> Result<(Spot, Vec<Segment>), SceneError> {
    let first = points.first().ok_or(SceneError::Empty { what: "control points" })?;
    if points.iter().flatten().any(|value| !value.is_finite()) {
        return Err(SceneError::TooLarge { what: "a control point".to_owned() });
    }
    let start = affine(first, "the curve")?;
    let pieces = approximate(points, "the curve")?;
    Ok((start, pieces))
}

/// (x/w, y/w)
fn affine(&[x, y, w]: &[f64; 3], what: &str) -> Result<Spot, SceneError> {
    if w == 0.0 {
        return Err(SceneError::AtInfinity { what: what.to_owned() });
    }
    Spot::new(x / w, y / w)
}

fn approximate(points: &[[f64; 3]], what: &str) -> Result<Vec<Segment>, SceneError> {
    let mut pieces = Vec::new();
    // the second half waits while the first is worked on
    let mut waiting = vec![(points.to_vec(), 0)];
    let mut size: f64 = 0.0;
    let known: Vec<Spot> = points.iter().filter_map(|point| affine(point, what).ok()).collect();
    for place in &known {
        size = size.max(place.distance(known[0]));
    }
    while let Some((points, depth)) = waiting.pop() {
        budget::steps(u32::try_from(points.len() * points.len() / 16 + 1).unwrap_or(u32::MAX));
        let one_sign = points.iter().all(|p| p[2] > 0.0) || points.iter().all(|p| p[2] < 0.0);
        if one_sign {
            let piece = hermite(&points, what)?;
            if depth >= DEPTH || difference(&points, &piece, what)? <= TOLERANCE * size {
                pieces.push(Segment::Cubic([piece[1], piece[2], piece[3]]));
                continue;
            }
        } else if depth >= 2 * DEPTH {
            return Err(SceneError::AtInfinity { what: what.to_owned() });
        }
        let (first, second) = halves(&points);
        waiting.push((second, depth + 1));
        waiting.push((first, depth + 1));
    }
    Ok(pieces)
}

/// The control points of the two halves: one de Casteljau scheme at 1/2.
fn halves(points: &[[f64; 3]]) -> (Vec<[f64; 3]>, Vec<[f64; 3]>) {
    let mut row = points.to_vec();
    let mut first = Vec::with_capacity(row.len());
    let mut second = Vec::with_capacity(row.len());
    while let (Some(&a), Some(&b)) = (row.first(), row.last()) {
        first.push(a);
        second.push(b);
        for i in 1..row.len() {
            row[i - 1] = std::array::from_fn(|k| 0.5 * row[i - 1][k] + 0.5 * row[i][k]);
        }
        row.pop();
    }
    second.reverse();
    (first, second)
}

/// The cubic with the same ends and the same derivatives there.
fn hermite(points: &[[f64; 3]], what: &str) -> Result<[Spot; 4], SceneError> {
    let n = points.len() - 1;
    let (start, end) = (affine(&points[0], what)?, affine(&points[n], what)?);
    // (n/3) (w_1/w_0) (p_1 − p_0) to the first, likewise from the last
    let handle = |near: usize, next: usize, place: Spot| -> Result<Spot, SceneError> {
        let other = affine(&points[next], what)?;
        let factor = n as f64 / 3.0 * (points[next][2] / points[near][2]);
        Ok(place.moved(factor * (other.x() - place.x()), factor * (other.y() - place.y())))
    };
    if n == 0 {
        return Ok([start; 4]);
    }
    Ok([start, handle(0, 1, start)?, handle(n, n - 1, end)?, end])
}

/// The largest distance between the two at t = 1/4, 1/2, 3/4.
fn difference(points: &[[f64; 3]], piece: &[Spot; 4], what: &str) -> Result<f64, SceneError> {
    let mut largest: f64 = 0.0;
    for t in [0.25, 0.5, 0.75] {
        let mut row = points.to_vec();
        for length in (1..row.len()).rev() {
            for i in 0..length {
                row[i] = std::array::from_fn(|k| (1.0 - t) * row[i][k] + t * row[i + 1][k]);
            }
        }
        largest = largest.max(affine(&row[0], what)?.distance(cubic_at(piece, t)));
    }
    Ok(largest)
}

/// The point of a cubic Bézier curve at t in [0, 1].
pub(super) fn cubic_at(points: &[Spot; 4], t: f64) -> Spot {
    let [a, b, c, d] = *points;
    let (ab, bc, cd) = (a.toward(b, t), b.toward(c, t), c.toward(d, t));
    ab.toward(bc, t).toward(bc.toward(cd, t), t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn spots() -> impl Strategy<Value = Vec<Spot>> {
        proptest::collection::vec((-9_i32..9, -9_i32..9), 1..9).prop_map(|list| {
            list.into_iter().map(|(x, y)| Spot::new(f64::from(x), f64::from(y)).unwrap()).collect()
        })
    }

    fn ends(start: Spot, pieces: &[Segment]) -> Spot {
        pieces.last().map_or(start, Segment::end)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        #[test]
        fn ends_are_kept(points in spots()) {
            let pieces = bezier_path(&points).unwrap();
            prop_assert_eq!(ends(points[0], &pieces), points[points.len() - 1]);
        }

        /// The pieces stay near the curve evaluated independently, by Bernstein polynomials.
        #[test]
        fn pieces_follow_the_curve(points in spots(), weights in proptest::collection::vec(1_i32..5, 9)) {
            let homogeneous: Vec<[f64; 3]> = points
                .iter()
                .zip(&weights)
                .map(|(p, &w)| { let w = f64::from(w); [w * p.x(), w * p.y(), w] })
                .collect();
            let (start, pieces) = rational_bezier_path(&homogeneous).unwrap();
            let mut trace = Vec::new();
            let mut from = start;
            for piece in &pieces {
                if let Segment::Cubic([b, c, d]) = piece {
                    trace.extend((0..=40).map(|k| cubic_at(&[from, *b, *c, *d], f64::from(k) / 40.0)));
                }
                from = piece.end();
            }
            let n = points.len() - 1;
            for k in 0..=24 {
                let t = f64::from(k) / 24.0;
                let mut sums = [0.0; 3];
                for (i, point) in homogeneous.iter().enumerate() {
                    let binomial: f64 = (0..i).map(|j| (n - j) as f64 / (j + 1) as f64).product();
                    let weight = binomial * t.powi(i as i32) * (1.0 - t).powi((n - i) as i32);
                    sums.iter_mut().zip(point).for_each(|(sum, x)| *sum += weight * x);
                }
                let place = Spot::new(sums[0] / sums[2], sums[1] / sums[2]).unwrap();
                let nearest = trace.iter().map(|p| p.distance(place)).fold(f64::INFINITY, f64::min);
                prop_assert!(trace.is_empty() || nearest < 0.5, "{place:?} is {nearest} away");
            }
        }
    }

    #[test]
    fn infinity_is_noticed() {
        let pole = [[0.0, 0.0, 1.0], [1.0, 0.0, -2.0], [2.0, 1.0, 1.0]];
        assert!(matches!(rational_bezier_path(&pole), Err(SceneError::AtInfinity { .. })));
        let end = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
        assert!(matches!(rational_bezier_path(&end), Err(SceneError::AtInfinity { .. })));
        assert!(matches!(rational_bezier_path(&[[f64::NAN; 3]]), Err(SceneError::TooLarge { .. })));
        assert!(rational_bezier_path(&[]).is_err());
        // a vector in the middle is fine: half a circle
        let circle = [[1.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 1.0]];
        let (start, pieces) = rational_bezier_path(&circle).unwrap();
        let mut from = start;
        for piece in pieces {
            let Segment::Cubic([b, c, d]) = piece else { panic!("a cubic") };
            for k in 0..=8 {
                let place = cubic_at(&[from, b, c, d], f64::from(k) / 8.0);
                assert!((place.distance(Spot::default()) - 1.0).abs() < 2e-3);
            }
            from = d;
        }
    }

    #[test]
    fn degenerate_curves() {
        let place = Spot::new(3.0, 4.0).unwrap();
        assert_eq!(bezier_path(&[place]), Ok(Vec::new()));
        assert_eq!(ends(place, &bezier_path(&[place; 30]).unwrap()), place);
        let far = Spot::new(Spot::LARGEST, -Spot::LARGEST).unwrap();
        let near = Spot::new(-Spot::LARGEST, Spot::LARGEST).unwrap();
        assert!(bezier_path(&[far, near, far, near, far]).is_ok());
    }
}
