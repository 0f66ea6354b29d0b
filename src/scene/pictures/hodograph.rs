//! A curve and its derivative.

use num_traits::Zero;

use super::curve::add_names;
use super::{BezierPicture, Curve, Plane};
use crate::formula::Expr;
use crate::math::number::{Rational, integer};
use crate::scene::{Ink, Marker, Path, Scene, SceneError, Shape, Spot, Style};

/// A Bézier curve beside its hodograph, the curve F'(t) of its derivatives.
///
/// The control points of the hodograph are n/(b − a) (b_{i+1} − b_i) for a curve over [a, b], drawn
/// as arrows from the origin.
///
/// ```
/// use polarform::number::integer as z;
/// use polarform::scene::pictures::HodographPicture;
/// let picture = HodographPicture {
///     points: [[0, 0], [1, 2], [3, 2], [4, 0]].map(|p| p.map(z)).to_vec(),
///     length: z(1),
///     labels: Vec::new(),
///     derivative_labels: Vec::new(),
/// };
/// assert_eq!(picture.scene()?.panels().len(), 2);
/// # Ok::<(), polarform::scene::SceneError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct HodographPicture {
    /// The control points, at least two.
    pub points: Vec<Plane>,
    /// The length b − a of the interval of the parameter.
    pub length: Rational,
    /// Their names.
    pub labels: Vec<Expr>,
    /// The names of the control points of the derivative.
    pub derivative_labels: Vec<Expr>,
}

impl HodographPicture {
    /// The two pictures side by side.
    ///
    /// # Errors
    /// [`SceneError`] for coordinates too large, with less than two control points, and for an
    /// interval of length 0.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        if self.points.len() < 2 {
            return Err(SceneError::Empty { what: "two control points" });
        }
        if self.length.is_zero() {
            return Err(SceneError::Interval { what: "the interval of the parameter" });
        }
        let factor = integer(self.points.len() as i64 - 1) / &self.length;
        let difference = |pair: &[Plane]| [0, 1].map(|k| &factor * (&pair[1][k] - &pair[0][k]));
        let derivative: Vec<Plane> = self.points.windows(2).map(difference).collect();
        let curve = Curve::new(self.points.clone()).with_labels(self.labels.clone());
        let hodograph = Curve::new(derivative).with_labels(self.derivative_labels.clone());

        let mut right = Scene::new("its derivative").also("zh", "其导数");
        for (_, point) in hodograph.places() {
            right.add(Path::line(Spot::default(), Spot::exact(&point)?, Style::guide()).with_arrow());
        }
        right.add(hodograph.path(Style::curve(1))?);
        add_names(&mut right, &hodograph, 0)?;
        right.add(Marker::new(Spot::default(), Shape::Cross, Ink::Text));
        Ok(BezierPicture::of(curve).scene()?.beside(right))
    }
}
