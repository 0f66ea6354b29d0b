//! Triangular surfaces, and the names of their control points.

use super::Space;
use super::curve::outward;
use super::patch::add_pieces;
use super::projection::{Point, between, point, project};
use crate::budget;
use crate::formula::Expr;
use crate::scene::{Ink, Label, Marker, Path, Scene, SceneError, Shape, Spot, Style, bezier_path};

/// How many pieces the surface has along each side.
const PIECES: usize = 14;

/// The (i, j, k) with i + j + k = n in the order in which control points are given:
/// descending by i, then by j.
pub(super) fn indices(degree: usize) -> Vec<[usize; 3]> {
    budget::charge_terms(expected(degree) as u64);
    let row = |i: usize| (0..=degree - i).rev().map(move |j| [i, j, degree - i - j]);
    (0..=degree).rev().flat_map(row).collect()
}

/// The place of (i, j, k) in that order.
fn position(degree: usize, [i, _, k]: [usize; 3]) -> usize {
    let before = degree - i;
    before * (before + 1) / 2 + k
}

/// The small triangles of the net that point as the whole: (i+1, j, k), (i, j+1, k), (i, j, k+1)
/// for i + j + k = n − 1.
fn upright(degree: usize) -> Vec<[usize; 3]> {
    let Some(less) = degree.checked_sub(1) else { return Vec::new() };
    let corners = |[i, j, k]: [usize; 3]| {
        [[i + 1, j, k], [i, j + 1, k], [i, j, k + 1]].map(|index| position(degree, index))
    };
    indices(less).into_iter().map(corners).collect()
}

fn expected(degree: usize) -> usize {
    degree.saturating_add(1).saturating_mul(degree.saturating_add(2)) / 2
}

/// The names of the control points of a triangular surface, each at its place in the domain.
///
/// There are (n + 1)(n + 2)/2 of them, for the (i, j, k) with i + j + k = n in descending order of
/// i, then of j: for n = 2 those of aa, ab, ac, bb, bc, cc. The corner a is on the lower left, b on
/// the lower right, c at the top.
///
/// ```
/// use polarform::expr::Expr;
/// use polarform::scene::pictures::{TriangleDomain, triangle_labels};
/// let name = Expr::name;
/// let labels = triangle_labels(&name("f"), 3, [&name("a"), &name("b"), &name("c")]);
/// assert!(TriangleDomain { degree: 3, labels }.scene().is_ok());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TriangleDomain {
    /// The degree n.
    pub degree: usize,
    /// The names; without names, there are dots.
    pub labels: Vec<Expr>,
}

impl TriangleDomain {
    /// The picture.
    ///
    /// # Errors
    /// [`SceneError::Shape`] when the number of names is neither 0 nor that of the points.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        let n = self.degree;
        if !self.labels.is_empty() && self.labels.len() != expected(n) {
            return Err(SceneError::Shape { what: format!("degree {n} needs {} names", expected(n)) });
        }
        let mut scene =
            Scene::new(format!("Triangular net of degree {n}")).also("zh", format!("{n} 次三角形网"));
        let places: Vec<Spot> = indices(n)
            .iter()
            .map(|[_, j, k]| Spot::new(*j as f64 + *k as f64 / 2.0, *k as f64 * 3.0_f64.sqrt() / 2.0))
            .collect::<Result<_, _>>()?;
        for corners in upright(n) {
            let corners = corners.map(|at| places[at]);
            for (from, to) in [(0, 1), (1, 2), (2, 0)] {
                scene.add(Path::line(corners[from], corners[to], Style::line(Ink::Guide, 1.1)).trim());
            }
        }
        for (i, &place) in places.iter().enumerate() {
            match self.labels.get(i) {
                Some(label) => scene.add(Label::centred(place, label.clone())),
                None => scene.add(Marker::new(place, Shape::Dot, Ink::Text)),
            }
        }
        Ok(scene.with_description(format!(
            "The {} control points of a triangular surface of degree {n}, arranged as in its domain.",
            expected(n)
        )))
    }
}

/// A triangular Bézier surface, seen from above, with its control net.
///
/// F = Σ n!/(i! j! k!) u^i v^j w^k b_ijk for u + v + w = 1; the control points in the order of
/// [`TriangleDomain`].
#[derive(Clone, Debug, PartialEq)]
pub struct TrianglePicture {
    /// The degree n.
    pub degree: usize,
    /// The (n + 1)(n + 2)/2 control points.
    pub points: Vec<Space>,
    /// Their names; missing ones are not shown.
    pub labels: Vec<Expr>,
    /// Whether the control net is drawn.
    pub polygon: bool,
}

impl TrianglePicture {
    /// The picture.
    ///
    /// # Errors
    /// [`SceneError::Shape`] for a wrong number of points, [`SceneError::TooLarge`].
    pub fn scene(&self) -> Result<Scene, SceneError> {
        let n = self.degree;
        if self.points.len() != expected(n) {
            return Err(SceneError::Shape {
                what: format!("degree {n} needs {} control points", expected(n)),
            });
        }
        let points: Vec<Point> = self.points.iter().map(point).collect::<Result<_, _>>()?;
        let mut scene =
            Scene::new(format!("Triangular surface of degree {n}")).also("zh", format!("{n} 次三角曲面"));
        add_pieces(&mut scene, pieces(n, &points))?;
        for side in 0..3 {
            // an index 0 along the side opposite to its corner
            let on_side: Vec<Spot> = indices(n)
                .into_iter()
                .filter(|index| index[side] == 0)
                .map(|index| project(points[position(n, index)]))
                .collect::<Result<_, _>>()?;
            if let Some(&start) = on_side.first() {
                scene.add(Path::new(start, bezier_path(&on_side)?, Style::line(Ink::Series(0), 2.0)));
            }
        }
        let spots: Vec<Spot> = points.iter().map(|&point| project(point)).collect::<Result<_, _>>()?;
        if self.polygon {
            for corners in upright(n) {
                if let Some(path) = Path::lines(corners.map(|at| spots[at]), Style::guide()) {
                    scene.add(path.close());
                }
            }
            for (i, &spot) in spots.iter().enumerate() {
                let marker = Marker::new(spot, Shape::Dot, Ink::Text);
                scene.add(Marker { radius: 2.8, ..marker });
                if let Some(label) = self.labels.get(i) {
                    scene.add(Label::beside(spot, label.clone(), outward(&spots, i)).small());
                }
            }
        }
        Ok(scene.with_description("A triangular Bézier surface with its control net."))
    }
}

/// The surface as small flat triangles.
fn pieces(degree: usize, points: &[Point]) -> Vec<[Point; 3]> {
    let m = PIECES;
    let at = |index: [usize; 3]| value(degree, points, index.map(|i| i as f64 / m as f64));
    let values: Vec<Point> = indices(m).into_iter().map(at).collect();
    let mut pieces: Vec<[Point; 3]> = upright(m).iter().map(|corners| corners.map(|i| values[i])).collect();
    // those upside down: around (i+1, j+1, k+1) for i + j + k = m − 2
    for [i, j, k] in indices(m - 2) {
        let corners = [[i + 1, j + 1, k], [i + 1, j, k + 1], [i, j + 1, k + 1]];
        pieces.push(corners.map(|index| values[position(m, index)]));
    }
    pieces
}

/// The point of the surface with these barycentric coordinates, by de Casteljau's algorithm.
fn value(degree: usize, points: &[Point], [u, v, w]: [f64; 3]) -> Point {
    let mut row = points.to_vec();
    for n in (0..degree).rev() {
        budget::steps(u32::try_from(n / 8 + 1).unwrap_or(u32::MAX));
        row = indices(n)
            .into_iter()
            .map(|[i, j, k]| {
                let [a, b, c] =
                    [[i + 1, j, k], [i, j + 1, k], [i, j, k + 1]].map(|index| row[position(n + 1, index)]);
                // u + v + w = 1, in two steps of means
                let rest = if u < 1.0 { w / (1.0 - u) } else { 0.0 };
                debug_assert!((u + v + w - 1.0).abs() < 1e-9);
                between(a, between(b, c, rest), 1.0 - u)
            })
            .collect();
    }
    row.first().copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer, rational};

    #[test]
    fn order() {
        for degree in 0..6 {
            for (place, index) in indices(degree).into_iter().enumerate() {
                assert_eq!(position(degree, index), place);
            }
            assert_eq!(indices(degree).len(), expected(degree));
            assert_eq!(upright(degree).len(), degree * (degree + 1) / 2);
        }
    }

    /// Control points (i/n, j/n, q) of the plane with q the polar form of u v reproduce it.
    #[test]
    fn surface_of_a_product() {
        let points: Vec<Point> = indices(2)
            .into_iter()
            .map(|[i, j, _]| [i as f64 / 2.0, j as f64 / 2.0, if i == 1 && j == 1 { 0.5 } else { 0.0 }])
            .collect();
        for [u, v] in [[0.25, 0.5], [1.0, 0.0], [0.0, 0.3]] {
            let [x, y, z] = value(2, &points, [u, v, 1.0 - u - v]);
            assert!((x - u).abs() + (y - v).abs() + (z - u * v).abs() < 1e-12);
        }
    }

    #[test]
    fn numbers_of_points() {
        let picture = TrianglePicture { degree: 1, points: Vec::new(), labels: Vec::new(), polygon: true };
        assert!(matches!(picture.scene(), Err(SceneError::Shape { .. })));
        let one = vec![[integer(1), rational(1, 2), integer(0)]];
        assert!(TrianglePicture { degree: 0, points: one, ..picture }.scene().is_ok());
    }
}
