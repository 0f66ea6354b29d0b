//! Tensor-product surfaces.

use super::Space;
use super::curve::outward;
use super::projection::{Point, de_casteljau, light, nearness, point, project};
use crate::budget;
use crate::formula::Expr;
use crate::scene::{Ink, Label, Marker, Path, Scene, SceneError, Shape, Spot, Style, bezier_path};

/// How many pieces the surface has in each direction.
const PIECES: usize = 14;

/// A tensor-product Bézier surface over [0, 1]², seen from above, with its control net.
///
/// The control points F(u, v) = Σ B_i^m(u) B_j^n(v) b_ij stand in rows of equal i.
///
/// ```
/// use polarform::number::integer as z;
/// use polarform::scene::pictures::PatchPicture;
/// let net = [[0, 1], [1, 0]].iter().enumerate().map(|(i, row)| {
///     row.iter().enumerate().map(|(j, &h)| [z(i as i64), z(j as i64), z(h)]).collect()
/// });
/// assert!(PatchPicture::of(net.collect()).scene().is_ok());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PatchPicture {
    /// The control points b_ij by rows.
    pub net: Vec<Vec<Space>>,
    /// Their names, in the same rows; missing ones are not shown.
    pub labels: Vec<Vec<Expr>>,
    /// How many lines of constant u, and of constant v, are drawn; two are the boundary.
    pub lines: [usize; 2],
    /// Whether the control net is drawn.
    pub polygon: bool,
}

impl PatchPicture {
    /// The surface with its control net and five lines in each direction.
    pub fn of(net: Vec<Vec<Space>>) -> Self {
        PatchPicture { net, labels: Vec::new(), lines: [5, 5], polygon: true }
    }

    /// The picture.
    ///
    /// # Errors
    /// [`SceneError::Shape`] for rows of different lengths, [`SceneError::Empty`] without points,
    /// [`SceneError::TooLarge`].
    pub fn scene(&self) -> Result<Scene, SceneError> {
        let columns = self.net.first().map_or(0, Vec::len);
        if columns == 0 {
            return Err(SceneError::Empty { what: "control points" });
        }
        if self.net.iter().any(|row| row.len() != columns) {
            return Err(SceneError::Shape { what: "the rows of a net need equally many points".to_owned() });
        }
        budget::charge_terms((self.net.len() * columns) as u64 + (PIECES * PIECES) as u64);
        let net: Vec<Vec<Point>> =
            self.net.iter().map(|row| row.iter().map(point).collect()).collect::<Result<_, _>>()?;
        let mut scene = Scene::new("Tensor-product surface");
        surface(&mut scene, &net)?;
        for k in 0..self.lines[0].min(200) {
            // u constant: the control points are values of the columns
            let u = part(k, self.lines[0]);
            let points: Vec<Point> = (0..columns).map(|j| de_casteljau(&column(&net, j), u)).collect();
            scene.add(curve(&points, k == 0 || k + 1 == self.lines[0])?);
        }
        for k in 0..self.lines[1].min(200) {
            let v = part(k, self.lines[1]);
            let points: Vec<Point> = net.iter().map(|row| de_casteljau(row, v)).collect();
            scene.add(curve(&points, k == 0 || k + 1 == self.lines[1])?);
        }
        if self.polygon {
            self.add_net(&mut scene, &net)?;
        }
        Ok(scene.with_description(format!(
            "A surface of degree ({}, {}) with its control net.",
            net.len() - 1,
            columns - 1
        )))
    }

    fn add_net(&self, scene: &mut Scene, net: &[Vec<Point>]) -> Result<(), SceneError> {
        let columns = net.first().map_or(0, Vec::len);
        let rows: Vec<Vec<Spot>> = net
            .iter()
            .map(|row| row.iter().map(|&point| project(point)).collect())
            .collect::<Result<_, _>>()?;
        for row in &rows {
            scene.add_lines(row.iter().copied());
        }
        for j in 0..columns {
            scene.add_lines(rows.iter().map(|row| row[j]));
        }
        for (i, row) in rows.iter().enumerate() {
            for (j, &spot) in row.iter().enumerate() {
                let marker = Marker::new(spot, Shape::Dot, Ink::Text);
                scene.add(Marker { radius: 2.8, ..marker });
                if let Some(label) = self.labels.get(i).and_then(|labels| labels.get(j)) {
                    let direction = outward(row, j);
                    scene.add(Label::beside(spot, label.clone(), direction).small());
                }
            }
        }
        Ok(())
    }
}

impl Scene {
    /// A polyline that guides the eye.
    pub(super) fn add_lines(&mut self, places: impl IntoIterator<Item = Spot>) {
        if let Some(path) = Path::lines(places, Style::guide()) {
            self.add(path);
        }
    }
}

fn column(net: &[Vec<Point>], j: usize) -> Vec<Point> {
    net.iter().map(|row| row[j]).collect()
}

fn part(k: usize, count: usize) -> f64 {
    if count < 2 { 0.5 } else { k as f64 / (count - 1) as f64 }
}

/// A line on the surface; projected control points give the projected curve.
fn curve(points: &[Point], boundary: bool) -> Result<Path, SceneError> {
    budget::steps(u32::try_from(points.len() * points.len()).unwrap_or(u32::MAX));
    let spots: Vec<Spot> = points.iter().map(|&point| project(point)).collect::<Result<_, _>>()?;
    let style = Style::line(Ink::Series(0), if boundary { 2.0 } else { 1.0 });
    Ok(Path::new(spots.first().copied().unwrap_or_default(), bezier_path(&spots)?, style))
}

/// The surface as flat pieces, the far ones first.
fn surface(scene: &mut Scene, net: &[Vec<Point>]) -> Result<(), SceneError> {
    let values: Vec<Vec<Point>> = (0..=PIECES)
        .map(|k| {
            let v = k as f64 / PIECES as f64;
            let points: Vec<Point> = net.iter().map(|row| de_casteljau(row, v)).collect();
            budget::steps(u32::try_from(net.len() * points.len()).unwrap_or(u32::MAX));
            (0..=PIECES).map(|l| de_casteljau(&points, l as f64 / PIECES as f64)).collect()
        })
        .collect();
    let mut pieces: Vec<[Point; 4]> = Vec::with_capacity(PIECES * PIECES);
    for pair in values.windows(2) {
        for l in 0..PIECES {
            pieces.push([pair[0][l], pair[0][l + 1], pair[1][l + 1], pair[1][l]]);
        }
    }
    add_pieces(scene, pieces)
}

/// Flat pieces, the far ones first, the more opaque the less light they get.
pub(super) fn add_pieces<const K: usize>(
    scene: &mut Scene,
    mut pieces: Vec<[Point; K]>,
) -> Result<(), SceneError> {
    let distance = |corners: &[Point; K]| corners.iter().map(|&corner| nearness(corner)).sum::<f64>();
    pieces.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
    for corners in pieces {
        let opacity = 0.46 - 0.34 * light(corners[0], corners[1], corners[2]);
        let spots: Vec<Spot> = corners.iter().map(|&corner| project(corner)).collect::<Result<_, _>>()?;
        if let Some(path) = Path::lines(spots, Style::fill(Ink::Series(0), opacity)) {
            scene.add(path.close());
        }
    }
    Ok(())
}
