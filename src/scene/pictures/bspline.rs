//! Spline curves.

use super::Curve;
use super::curve::{add_points, add_polygon};
use crate::formula::Expr;
use crate::scene::{Dash, Direction, Ink, Label, Marker, Scene, SceneError, Shape, Style};

/// A spline curve by its Bézier pieces, with its de Boor points and its knots on the curve.
///
/// ```
/// use polarform::expr::Expr;
/// use polarform::number::{integer as z, rational as q};
/// use polarform::scene::pictures::{BsplinePicture, Curve, bspline_labels};
/// // degree 2 over the knots 0, 0, 1, 2, 2
/// let half = |p: i64, r: i64| [q(p, 2), q(r, 2)];
/// let knots = [0, 0, 1, 2, 2].map(Expr::int);
/// let picture = BsplinePicture {
///     pieces: vec![
///         Curve::new(vec![[z(0), z(0)], [z(1), z(2)], half(4, 4)]),
///         Curve::new(vec![half(4, 4), [z(3), z(2)], [z(4), z(0)]]),
///     ],
///     points: Curve::new([[0, 0], [1, 2], [3, 2], [4, 0]].map(|p| p.map(z)).to_vec())
///         .with_labels(bspline_labels(&Expr::name("f"), 2, &knots)),
///     knots: [0, 1, 2].map(Expr::int).to_vec(),
///     bezier_points: false,
/// };
/// assert!(picture.scene().is_ok());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BsplinePicture {
    /// The pieces in order.
    pub pieces: Vec<Curve>,
    /// The de Boor points with their names.
    pub points: Curve,
    /// What is written at the start of each piece, and at the end of the last.
    pub knots: Vec<Expr>,
    /// Whether the Bézier points of the pieces are marked, too.
    pub bezier_points: bool,
}

impl BsplinePicture {
    /// The picture.
    ///
    /// # Errors
    /// [`SceneError`] for coordinates too large, pieces through infinity or without points.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        if self.pieces.is_empty() {
            return Err(SceneError::Empty { what: "pieces" });
        }
        let mut scene = Scene::new("Spline curve").also("zh", "样条曲线");
        add_polygon(&mut scene, &self.points, Style::line(Ink::Guide, 1.2))?;
        let mut ends = Vec::new();
        for (number, piece) in self.pieces.iter().enumerate() {
            if self.bezier_points {
                let style = Style::line(Ink::Series(number % 2), 0.9).dashed(Dash::Dashed);
                add_polygon(&mut scene, piece, style)?;
                add_points(&mut scene, piece, Shape::Cross, Ink::Series(number % 2))?;
            }
            // neighbours in two colours
            let path = piece.path(Style::curve(number % 2))?;
            if ends.is_empty() {
                ends.push(path.start);
            }
            ends.push(path.end());
            scene.add(path);
        }
        add_points(&mut scene, &self.points, Shape::Dot, Ink::Text)?;
        for (i, &end) in ends.iter().enumerate() {
            let marker = Marker::new(end, Shape::Square, Ink::Text);
            scene.add(Marker { radius: 2.8, ..marker });
            if let Some(label) = self.knots.get(i) {
                scene.add(Label::beside(end, label.clone(), Direction::South).small());
            }
        }
        Ok(scene.with_description(format!(
            "A spline curve of {} pieces with {} control points; its knots are marked on the curve.",
            self.pieces.len(),
            self.points.points.len()
        )))
    }
}
