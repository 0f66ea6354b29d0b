//! Bézier curves as pictures take them, and how their control points are drawn.

use num_traits::{One, ToPrimitive, Zero};

use super::Plane;
use crate::budget;
use crate::formula::Expr;
use crate::math::number::Rational;
use crate::scene::{
    Direction, Ink, Label, Marker, Path, Scene, SceneError, Shape, Spot, Style, bezier_path,
    rational_bezier_path,
};

/// A polynomial or rational Bézier curve over [0, 1].
///
/// **Representation.** Homogeneous control points (w x, w y, w); the curve is polynomial when all
/// weights are 1. A point with w = 0 is a vector: it has a part in the curve but no place.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The control points (w x, w y, w).
    pub points: Vec<[Rational; 3]>,
    /// Their names, in order; points beyond have none.
    pub labels: Vec<Expr>,
    /// The name of the curve, for the legend.
    pub name: Option<Expr>,
    /// Points of the curve that are marked: parameters in [0, 1], and what is written there. A curve
    /// over another interval [a, b] is drawn like that over [0, 1]; its point at t is that at
    /// (t − a)/(b − a), and what is written there says t.
    pub marks: Vec<(Rational, Expr)>,
}

impl Curve {
    /// The polynomial curve with these control points.
    pub fn new(points: Vec<Plane>) -> Self {
        Curve::rational(points.into_iter().map(|[x, y]| [x, y, Rational::one()]).collect())
    }

    /// The rational curve with these homogeneous control points (w x, w y, w).
    ///
    /// ```
    /// use polarform::number::integer as z;
    /// use polarform::scene::pictures::Curve;
    /// // a quarter of the unit circle
    /// let quarter = Curve::rational(vec![[1, 0, 1], [1, 1, 1], [0, 2, 2]].into_iter().map(|p| p.map(z)).collect());
    /// assert_eq!(quarter.value(&polarform::number::rational(1, 2)), Some([(3, 5), (4, 5)].map(|(p, q)| polarform::number::rational(p, q))));
    /// ```
    pub fn rational(points: Vec<[Rational; 3]>) -> Self {
        Curve { points, labels: Vec::new(), name: None, marks: Vec::new() }
    }

    /// The same with names for its control points.
    pub fn with_labels(self, labels: Vec<Expr>) -> Self {
        Curve { labels, ..self }
    }

    /// The same with a name.
    pub fn named(self, name: Expr) -> Self {
        Curve { name: Some(name), ..self }
    }

    /// The point of the curve at t, exactly; `None` at infinity or without control points.
    pub fn value(&self, t: &Rational) -> Option<Plane> {
        let [x, y, w] = levels(&self.points, t).pop()?.pop()?;
        (!w.is_zero()).then(|| [x / &w, y / w])
    }

    /// The control points with a place, with their numbers.
    pub(super) fn places(&self) -> Vec<(usize, Plane)> {
        let affine = |(i, [x, y, w]): (usize, &[Rational; 3])| (!w.is_zero()).then(|| (i, [x / w, y / w]));
        self.points.iter().enumerate().filter_map(affine).collect()
    }

    /// The curve on the page.
    pub(super) fn path(&self, style: Style) -> Result<Path, SceneError> {
        budget::charge_terms(self.points.len() as u64);
        if self.points.iter().all(|[_, _, w]| w.is_one()) {
            let spots = spots(&self.places())?;
            let start = *spots.first().ok_or(SceneError::Empty { what: "control points" })?;
            return Ok(Path::new(start, bezier_path(&spots)?, style));
        }
        // weights may be scaled together, which keeps them within range
        let largest =
            self.points.iter().map(|p| num_traits::abs(p[2].clone())).max().unwrap_or_else(Rational::one);
        let scale = if largest.is_zero() { Rational::one() } else { largest };
        let float = |value: &Rational| (value / &scale).to_f64().unwrap_or(f64::INFINITY);
        let points: Vec<[f64; 3]> = self.points.iter().map(|p| [0, 1, 2].map(|k| float(&p[k]))).collect();
        let (start, segments) = rational_bezier_path(&points)?;
        Ok(Path::new(start, segments, style))
    }
}

pub(super) fn spots(points: &[(usize, Plane)]) -> Result<Vec<Spot>, SceneError> {
    points.iter().map(|(_, point)| Spot::exact(point)).collect()
}

/// The levels of de Casteljau's algorithm: level r has the points b_i^r = (1 − t) b_i^{r−1} +
/// t b_{i+1}^{r−1}; level 0 the given ones, the last one point.
pub(super) fn levels<const K: usize>(points: &[[Rational; K]], t: &Rational) -> Vec<Vec<[Rational; K]>> {
    budget::charge_terms((points.len() * points.len()) as u64);
    let rest = Rational::one() - t;
    let mut levels = Vec::with_capacity(points.len());
    let mut row = points.to_vec();
    while !row.is_empty() {
        let next = row
            .windows(2)
            .map(|pair| {
                budget::step();
                std::array::from_fn(|k| &rest * &pair[0][k] + t * &pair[1][k])
            })
            .collect();
        levels.push(std::mem::replace(&mut row, next));
    }
    levels
}

/// The direction away from the polyline at its point i, where its name stands best.
pub(super) fn outward(points: &[Spot], i: usize) -> Direction {
    let Some(&at) = points.get(i) else { return Direction::North };
    // the nearest different points before and after
    let before = points[..i].iter().rev().find(|p| **p != at);
    let after = points[i + 1..].iter().find(|p| **p != at);
    let away = |other: Option<&Spot>| {
        let (x, y) = other.map_or((0.0, 0.0), |other| (at.x() - other.x(), at.y() - other.y()));
        let length = x.hypot(y);
        if length > 0.0 { (x / length, y / length) } else { (0.0, 0.0) }
    };
    let (from, to) = (away(before), away(after));
    let sum = (from.0 + to.0, from.1 + to.1);
    if sum.0.hypot(sum.1) > 0.2 {
        return Direction::of(sum.0, sum.1);
    }
    // on a straight stretch: across it, away from the middle of all points
    let count = points.len() as f64;
    let (mut x, mut y) = (0.0, 0.0);
    for point in points {
        x += (at.x() - point.x()) / count;
        y += (at.y() - point.y()) / count;
    }
    let across = (-from.1, from.0);
    let sign = if across.0 * x + across.1 * y < 0.0 { -1.0 } else { 1.0 };
    Direction::of(sign * across.0, sign * across.1)
}

/// Adds the control polygon, below what comes later.
pub(super) fn add_polygon(scene: &mut Scene, curve: &Curve, style: Style) -> Result<(), SceneError> {
    if let Some(polygon) = Path::lines(spots(&curve.places())?, style) {
        scene.add(polygon);
    }
    Ok(())
}

/// Adds the control points with their names.
pub(super) fn add_points(scene: &mut Scene, curve: &Curve, shape: Shape, ink: Ink) -> Result<(), SceneError> {
    for spot in spots(&curve.places())? {
        scene.add(Marker::new(spot, shape, ink));
    }
    add_names(scene, curve, 0)
}

/// Adds the names of the control points from this number on.
pub(super) fn add_names(scene: &mut Scene, curve: &Curve, first: usize) -> Result<(), SceneError> {
    let places = curve.places();
    let spots = spots(&places)?;
    for (k, (i, _)) in places.iter().enumerate() {
        if let Some(label) = curve.labels.get(*i)
            && *i >= first
        {
            scene.add(Label::beside(spots[k], label.clone(), outward(&spots, k)));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spot(x: f64, y: f64) -> Spot {
        Spot::new(x, y).unwrap()
    }

    #[test]
    fn names_stand_outside() {
        let arch = [spot(0.0, 0.0), spot(1.0, 2.0), spot(3.0, 2.0), spot(4.0, 0.0)];
        assert_eq!(outward(&arch, 0), Direction::SouthWest);
        assert_eq!(outward(&arch, 1), Direction::NorthWest);
        assert_eq!(outward(&arch, 2), Direction::NorthEast);
        // inside a straight line, and where all points are one
        let line = [spot(0.0, 0.0), spot(1.0, 0.0), spot(2.0, 0.0)];
        assert!(matches!(outward(&line, 1), Direction::North | Direction::South));
        assert_eq!(outward(&[spot(1.0, 1.0); 3], 1), Direction::North);
    }
}
