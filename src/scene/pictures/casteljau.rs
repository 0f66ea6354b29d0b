//! De Casteljau's algorithm.

use num_traits::{One, Zero};

use super::Plane;
use super::curve::{levels, outward};
use crate::formula::Expr;
use crate::math::number::Rational;
use crate::scene::{
    Dash, Direction, Ink, Label, Marker, Path, Scene, SceneError, Shape, Spot, Style, bezier_path,
};

/// All points of de Casteljau's algorithm at t, level by level, with the curve.
///
/// t may lie outside of [0, 1]; then the points are extrapolated.
///
/// ```
/// use polarform::expr::Expr;
/// use polarform::number::{integer as z, rational};
/// use polarform::scene::pictures::{CasteljauPicture, casteljau_labels};
/// let name = Expr::name;
/// let picture = CasteljauPicture {
///     points: vec![[z(0), z(0)], [z(1), z(3)], [z(4), z(3)]],
///     t: rational(1, 2),
///     labels: casteljau_labels(&name("f"), 2, &Expr::int(0), &Expr::int(1), &name("t")),
/// };
/// assert!(picture.scene().is_ok());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CasteljauPicture {
    /// The control points.
    pub points: Vec<Plane>,
    /// The parameter.
    pub t: Rational,
    /// The names of the points by level; missing ones are not shown.
    pub labels: Vec<Vec<Expr>>,
}

impl CasteljauPicture {
    /// The picture.
    ///
    /// # Errors
    /// [`SceneError`] for coordinates too large, and without control points.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        let degree = self.points.len().checked_sub(1).ok_or(SceneError::Empty { what: "control points" })?;
        let mut scene = Scene::new(format!("De Casteljau's algorithm at t = {}", self.t))
            .also("zh", format!("t = {} 处的 de Casteljau 算法", self.t));
        let levels: Vec<Vec<Spot>> = levels(&self.points, &self.t)
            .iter()
            .map(|level| level.iter().map(Spot::exact).collect())
            .collect::<Result<_, _>>()?;
        for (number, level) in levels.iter().enumerate() {
            let style = match number {
                0 => Style::line(Ink::Guide, 1.2),
                _ => Style::line(Ink::Series(number), 1.3),
            };
            if let Some(path) = Path::lines(level.iter().copied(), style) {
                scene.add(path);
            }
        }
        // outside of [0, 1] the points lie on the legs continued
        let (zero, one) = (Rational::zero(), Rational::one());
        if self.t < zero || self.t > one {
            let end = usize::from(self.t > one);
            for (number, pair) in levels.windows(2).enumerate() {
                let style = Style::line(if number == 0 { Ink::Guide } else { Ink::Series(number) }, 1.1);
                for (i, &to) in pair[1].iter().enumerate() {
                    scene.add(Path::line(pair[0][i + end], to, style.dashed(Dash::Dashed)));
                }
            }
        }
        scene.add(Path::new(levels[0][0], bezier_path(&levels[0])?, Style::curve(0)));
        for (number, level) in levels.iter().enumerate() {
            for (i, &spot) in level.iter().enumerate() {
                let marker = match number {
                    _ if number == degree => Marker::new(spot, Shape::Diamond, Ink::Accent),
                    0 => Marker::new(spot, Shape::Dot, Ink::Text),
                    _ => Marker::new(spot, Shape::Dot, Ink::Series(number)),
                };
                scene.add(marker);
                if let Some(label) = self.labels.get(number).and_then(|labels| labels.get(i)) {
                    let direction = outward_of_level(&levels, number, i);
                    let label = Label::beside(spot, label.clone(), direction);
                    scene.add(if number == 0 { label } else { label.small() });
                }
            }
        }
        Ok(scene.with_description(format!(
            "The control polygon of a curve of degree {degree} and the points of all levels that lead to the \
             point of the curve at t = {}.",
            self.t
        )))
    }
}

/// A point of a later level lies on a leg of the level before: its name stands across that leg,
/// on the side where the polygon has no further points.
fn outward_of_level(levels: &[Vec<Spot>], number: usize, i: usize) -> Direction {
    let Some(before) = number.checked_sub(1).and_then(|n| levels.get(n)) else {
        return outward(&levels[0], i);
    };
    let (a, b, at) = (before[i], before[i + 1], levels[number][i]);
    let across = (a.y() - b.y(), b.x() - a.x());
    let side: f64 = levels[0]
        .iter()
        .map(|point| across.0 * (point.x() - at.x()) + across.1 * (point.y() - at.y()))
        .map(|product| if product.is_finite() { product } else { 0.0 })
        .sum();
    let sign = if side > 0.0 { -1.0 } else { 1.0 };
    Direction::of(sign * across.0, sign * across.1)
}
