//! Space seen from far away: an orthographic projection.
//!
//! The eye is above, turned off the diagonal of x and y, so that the points of a lattice do not
//! fall on each other as they do in the isometric projection.

use super::{Plane, Space};
use crate::math::number::rational;
use crate::scene::spot::rounded;
use crate::scene::{SceneError, Spot};

/// The projected point, exactly; linear, so that it may be used for homogeneous coordinates too.
///
/// ```
/// use polarform::number::integer as z;
/// use polarform::scene::pictures::projected;
/// let origin = projected(&[z(0), z(0), z(0)]);
/// let above = projected(&[z(0), z(0), z(1)]);
/// assert!(origin[0] == above[0] && origin[1] < above[1]);
/// ```
pub fn projected([x, y, z]: &Space) -> Plane {
    // sines and cosines as below
    let [turn, side, rise, flat] = [529_919, 848_048, 438_371, 898_794].map(|k| rational(k, 1_000_000));
    [y * &side - x * &turn, z * &flat - (x * &side + y * &turn) * &rise]
}

/// A point of space in floating-point numbers.
pub(super) type Point = [f64; 3];

/// The exact point, each coordinate rounded once.
pub(super) fn point([x, y, z]: &Space) -> Result<Point, SceneError> {
    Ok([rounded(x, "x")?, rounded(y, "y")?, rounded(z, "z")?])
}

/// Sine and cosine of the angle from the x-axis to the eye, and of the eye above the plane: 32°
/// and 26°.
const TURN: (f64, f64) = (0.529_919, 0.848_048);
const RISE: (f64, f64) = (0.438_371, 0.898_794);

/// The projection: z upwards, x to the lower left, y to the lower right.
pub(super) fn project([x, y, z]: Point) -> Result<Spot, SceneError> {
    let ((sin, cos), (up, flat)) = (TURN, RISE);
    Spot::new(y * cos - x * sin, z * flat - (x * cos + y * sin) * up)
}

/// The projected homogeneous point (w x, w y, w z, w), in homogeneous coordinates.
pub(super) fn project_homogeneous([x, y, z, w]: [f64; 4]) -> [f64; 3] {
    let ((sin, cos), (up, flat)) = (TURN, RISE);
    [y * cos - x * sin, z * flat - (x * cos + y * sin) * up, w]
}

/// How near a point is to the eye, apart from a constant.
pub(super) fn nearness([x, y, z]: Point) -> f64 {
    let ((sin, cos), (up, flat)) = (TURN, RISE);
    (x * cos + y * sin) * flat + z * up
}

/// How much light a flat piece with these corners gets, from 0 to 1; 1/2 if it has no area.
pub(super) fn light(a: Point, b: Point, c: Point) -> f64 {
    let scale = [a, b, c].iter().flatten().fold(0.0_f64, |m, v| m.max(v.abs()));
    if scale == 0.0 {
        return 0.5;
    }
    let edge = |p: Point| [0, 1, 2].map(|k| p[k] / scale - a[k] / scale);
    let (u, v) = (edge(b), edge(c));
    let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    // from above, a little from the left
    let sun = [0.5, -0.1, 0.86];
    let product: f64 = normal.iter().zip(sun).map(|(n, s)| n * s).sum();
    if length > 0.0 { (product / length).abs().min(1.0) } else { 0.5 }
}

/// (1 − t) a + t b
pub(super) fn between<const N: usize>(a: [f64; N], b: [f64; N], t: f64) -> [f64; N] {
    std::array::from_fn(|k| (1.0 - t) * a[k] + t * b[k])
}

/// The point of a Bézier curve in space, for t in [0, 1]; also in homogeneous coordinates.
pub(super) fn de_casteljau<const N: usize>(points: &[[f64; N]], t: f64) -> [f64; N] {
    let mut row = points.to_vec();
    for length in (1..row.len()).rev() {
        for i in 0..length {
            row[i] = between(row[i], row[i + 1], t);
        }
    }
    row.first().copied().unwrap_or([0.0; N])
}
