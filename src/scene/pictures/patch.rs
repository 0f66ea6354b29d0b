//! Tensor-product surfaces.

use super::Space;
use super::curve::outward;
use super::projection::{Point, de_casteljau, light, nearness, point, project, project_homogeneous};
use crate::budget;
use crate::formula::Expr;
use crate::math::number::Rational;
use crate::scene::spot::rounded;
use crate::scene::{
    Ink, Label, Marker, Path, Scene, SceneError, Shape, Spot, Style, bezier_path, rational_bezier_path,
};

/// How many pieces the surface has in each direction.
const PIECES: usize = 14;

/// Control points by rows, and their weights.
type WeightedNet = (Vec<Vec<Space>>, Vec<Vec<Rational>>);

/// A homogeneous point (w x, w y, w z, w).
type Weighted = [f64; 4];

/// Tensor-product Bézier surfaces over [0, 1]², seen from above, the first with its control net.
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
    /// Their weights, in the same rows; 1 where there are none.
    pub weights: Vec<Vec<Rational>>,
    /// Their names, in the same rows; missing ones are not shown.
    pub labels: Vec<Vec<Expr>>,
    /// Further patches of the surface, with their weights; their control nets are not drawn.
    pub others: Vec<WeightedNet>,
    /// How many lines of constant u, and of constant v, are drawn; two are the boundary.
    pub lines: [usize; 2],
    /// Whether the control net is drawn.
    pub polygon: bool,
}

impl PatchPicture {
    /// The surface with its control net and five lines in each direction.
    pub fn of(net: Vec<Vec<Space>>) -> Self {
        PatchPicture {
            net,
            weights: Vec::new(),
            labels: Vec::new(),
            others: Vec::new(),
            lines: [5, 5],
            polygon: true,
        }
    }

    /// The picture.
    ///
    /// # Errors
    /// [`SceneError::Shape`] for rows of different lengths, [`SceneError::Empty`] without points,
    /// [`SceneError::AtInfinity`] where a weight vanishes, [`SceneError::TooLarge`].
    pub fn scene(&self) -> Result<Scene, SceneError> {
        let first = weighted(&self.net, &self.weights)?;
        let others = self.others.iter().map(|(net, weights)| weighted(net, weights));
        let nets: Vec<Vec<Vec<Weighted>>> =
            std::iter::once(Ok(first)).chain(others).collect::<Result<_, _>>()?;
        let mut scene = Scene::new("Tensor-product surface").also("zh", "张量积曲面");
        let pieces: Vec<[Point; 4]> =
            nets.iter().map(|net| pieces(net)).collect::<Result<Vec<_>, _>>()?.concat();
        add_pieces(&mut scene, pieces)?;
        for net in &nets {
            self.add_curves(&mut scene, net)?;
        }
        if self.polygon {
            self.add_net(&mut scene)?;
        }
        let columns = self.net.first().map_or(0, Vec::len);
        Ok(scene.with_description(format!(
            "A surface of degree ({}, {}) with its control net.",
            self.net.len().saturating_sub(1),
            columns.saturating_sub(1)
        )))
    }

    /// The lines of constant u and v.
    fn add_curves(&self, scene: &mut Scene, net: &[Vec<Weighted>]) -> Result<(), SceneError> {
        let columns = net.first().map_or(0, Vec::len);
        for k in 0..self.lines[0].min(200) {
            // u constant: the control points are values of the columns
            let u = part(k, self.lines[0]);
            let points: Vec<Weighted> = (0..columns).map(|j| de_casteljau(&column(net, j), u)).collect();
            scene.add(curve(&points, k == 0 || k + 1 == self.lines[0])?);
        }
        for k in 0..self.lines[1].min(200) {
            let v = part(k, self.lines[1]);
            let points: Vec<Weighted> = net.iter().map(|row| de_casteljau(row, v)).collect();
            scene.add(curve(&points, k == 0 || k + 1 == self.lines[1])?);
        }
        Ok(())
    }

    fn add_net(&self, scene: &mut Scene) -> Result<(), SceneError> {
        let columns = self.net.first().map_or(0, Vec::len);
        let rows: Vec<Vec<Spot>> = self
            .net
            .iter()
            .map(|row| row.iter().map(|exact| project(point(exact)?)).collect())
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

/// The homogeneous control points of a patch, if it is one.
fn weighted(net: &[Vec<Space>], weights: &[Vec<Rational>]) -> Result<Vec<Vec<Weighted>>, SceneError> {
    let columns = net.first().map_or(0, Vec::len);
    if columns == 0 {
        return Err(SceneError::Empty { what: "control points" });
    }
    if net.iter().any(|row| row.len() != columns) {
        return Err(SceneError::Shape { what: "the rows of a net need equally many points".to_owned() });
    }
    budget::charge_terms((net.len() * columns) as u64 + (PIECES * PIECES) as u64);
    let entry = |i: usize, j: usize| {
        let [x, y, z] = point(&net[i][j])?;
        let weight = weights.get(i).and_then(|row| row.get(j));
        let w = weight.map_or(Ok(1.0), |weight| rounded(weight, "a weight"))?;
        Ok([x * w, y * w, z * w, w])
    };
    (0..net.len()).map(|i| (0..columns).map(|j| entry(i, j)).collect()).collect()
}

fn column(net: &[Vec<Weighted>], j: usize) -> Vec<Weighted> {
    net.iter().map(|row| row[j]).collect()
}

fn part(k: usize, count: usize) -> f64 {
    if count < 2 { 0.5 } else { k as f64 / (count - 1) as f64 }
}

/// A line on the surface; projected control points give the projected curve.
fn curve(points: &[Weighted], boundary: bool) -> Result<Path, SceneError> {
    budget::steps(u32::try_from(points.len() * points.len()).unwrap_or(u32::MAX));
    let style = Style::line(Ink::Series(0), if boundary { 2.0 } else { 1.0 });
    if points.iter().all(|point| point[3] == 1.0) {
        let spots: Vec<Spot> =
            points.iter().map(|&[x, y, z, _]| project([x, y, z])).collect::<Result<_, _>>()?;
        return Ok(Path::new(spots.first().copied().unwrap_or_default(), bezier_path(&spots)?, style));
    }
    let projected: Vec<[f64; 3]> = points.iter().map(|&point| project_homogeneous(point)).collect();
    let (start, segments) = rational_bezier_path(&projected)?;
    Ok(Path::new(start, segments, style))
}

/// The surface as flat pieces.
fn pieces(net: &[Vec<Weighted>]) -> Result<Vec<[Point; 4]>, SceneError> {
    let affine = |[x, y, z, w]: Weighted| match w == 0.0 {
        true => Err(SceneError::AtInfinity { what: "the surface".to_owned() }),
        false => Ok([x / w, y / w, z / w]),
    };
    let values: Vec<Vec<Point>> = (0..=PIECES)
        .map(|k| {
            let v = k as f64 / PIECES as f64;
            let points: Vec<Weighted> = net.iter().map(|row| de_casteljau(row, v)).collect();
            budget::steps(u32::try_from(net.len() * points.len()).unwrap_or(u32::MAX));
            (0..=PIECES).map(|l| affine(de_casteljau(&points, l as f64 / PIECES as f64))).collect()
        })
        .collect::<Result<_, _>>()?;
    let mut pieces: Vec<[Point; 4]> = Vec::with_capacity(PIECES * PIECES);
    for pair in values.windows(2) {
        for l in 0..PIECES {
            pieces.push([pair[0][l], pair[0][l + 1], pair[1][l + 1], pair[1][l]]);
        }
    }
    Ok(pieces)
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
