//! Steps of a subdivision scheme.

use super::Plane;
use super::curve::outward;
use crate::formula::Expr;
use crate::scene::{Ink, Label, Marker, Path, Scene, SceneError, Shape, Spot, Style};

/// The polygon of a subdivision scheme and those after each step, the last one as the curve.
///
/// ```
/// use polarform::number::integer as z;
/// use polarform::scene::pictures::SubdivisionPicture;
/// let polygon = |points: &[[i64; 2]]| points.iter().map(|p| p.map(z)).collect();
/// let picture = SubdivisionPicture {
///     levels: vec![polygon(&[[0, 0], [4, 4], [8, 0]]), polygon(&[[1, 1], [3, 3], [5, 3], [7, 1]])],
///     closed: false,
///     labels: Vec::new(),
/// };
/// assert!(picture.scene().is_ok());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SubdivisionPicture {
    /// The points after 0, 1, … steps.
    pub levels: Vec<Vec<Plane>>,
    /// Whether the last point is followed by the first one.
    pub closed: bool,
    /// The names of the first points; missing ones are not shown.
    pub labels: Vec<Expr>,
}

impl SubdivisionPicture {
    /// The picture.
    ///
    /// # Errors
    /// [`SceneError`] for coordinates too large, and without points.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        let levels: Vec<Vec<Spot>> = self
            .levels
            .iter()
            .map(|level| level.iter().map(Spot::exact).collect())
            .collect::<Result<_, _>>()?;
        let first = levels.first().filter(|level| !level.is_empty());
        let first = first.ok_or(SceneError::Empty { what: "points" })?;
        let steps = levels.len() - 1;
        let mut scene = Scene::new(format!("A polygon after {steps} steps of subdivision"))
            .also("zh", format!("细分 {steps} 步后的多边形"));
        for (number, level) in levels.iter().enumerate() {
            let style = match number {
                0 => Style::line(Ink::Guide, 1.2),
                _ if number == steps => Style::curve(0),
                _ => Style::line(Ink::Series(number), 1.1),
            };
            if let Some(path) = Path::lines(level.iter().copied(), style) {
                scene.add(if self.closed { path.close() } else { path });
            }
        }
        for (number, level) in levels.iter().enumerate() {
            // Points of later steps lie too close for markers.
            let ink = if number == 0 { Ink::Text } else { Ink::Series(number) };
            if number == 0 || number == 1 && steps > 1 {
                level.iter().for_each(|&spot| scene.add(Marker::new(spot, Shape::Dot, ink)));
            }
        }
        for (i, label) in self.labels.iter().enumerate().take(first.len()) {
            scene.add(Label::beside(first[i], label.clone(), outward(first, i)));
        }
        Ok(scene.with_description(format!(
            "A polygon of {} points and the polygons after each of {steps} steps; the last one has {} points.",
            first.len(),
            levels[steps].len()
        )))
    }
}
