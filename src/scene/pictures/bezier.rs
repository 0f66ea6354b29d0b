//! Bézier curves with their control polygons.

use super::Curve;
use super::curve::{add_points, add_polygon};
use crate::formula::{Expr, Rel};
use crate::math::curve::{Point, convex_hull};
use crate::math::number::Rational;
use crate::scene::{
    Dash, Direction, Entry, Ink, Label, Marker, Path, Scene, SceneError, Shape, Spot, Style, Text, exact_text,
};

/// Bézier curves, their control polygons, hulls, and points at given parameters.
///
/// ```
/// use polarform::number::{integer as z, rational};
/// use polarform::scene::pictures::{BezierPicture, Curve};
/// let curve = Curve::new(vec![[z(0), z(0)], [z(1), z(2)], [z(3), z(2)], [z(4), z(0)]]);
/// let picture = BezierPicture { hull: true, parameters: vec![rational(1, 3)], ..BezierPicture::of(curve) };
/// assert_eq!(picture.scene()?.panels().len(), 1);
/// # Ok::<(), polarform::scene::SceneError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BezierPicture {
    /// The curves, each in its own colour.
    pub curves: Vec<Curve>,
    /// Parameters in [0, 1] whose points are marked on each curve.
    pub parameters: Vec<Rational>,
    /// Whether the control polygons are drawn.
    pub polygon: bool,
    /// Whether the convex hulls of the control points are shaded.
    pub hull: bool,
}

impl BezierPicture {
    /// One curve with its control polygon.
    pub fn of(curve: Curve) -> Self {
        BezierPicture { curves: vec![curve], parameters: Vec::new(), polygon: true, hull: false }
    }

    /// The picture.
    ///
    /// # Errors
    /// [`SceneError`] for coordinates too large, curves through infinity, and curves without
    /// control points.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        let several = self.curves.len() > 1;
        let mut scene =
            Scene::new(if several { "Bézier curves" } else { "Bézier curve" }).also("zh", "Bézier 曲线");
        if self.hull {
            for (number, curve) in self.curves.iter().enumerate() {
                let places = curve.places().into_iter().map(|(_, place)| Point::from(&place[..]));
                let hull = convex_hull(&places.collect::<Vec<_>>()).unwrap_or_default();
                let corner = |p: &Point<Rational>| Spot::exact(&[p[0].clone(), p[1].clone()]);
                let corners: Vec<Spot> = hull.iter().map(corner).collect::<Result<_, _>>()?;
                if let Some(hull) = Path::lines(corners, Style::fill(Ink::Series(number), 0.12)) {
                    scene.add(hull.close());
                }
            }
        }
        if self.polygon {
            let dash = if several { Dash::Dashed } else { Dash::Solid };
            for curve in &self.curves {
                add_polygon(&mut scene, curve, Style::line(Ink::Guide, 1.2).dashed(dash))?;
            }
        }
        for (number, curve) in self.curves.iter().enumerate() {
            scene.add(curve.path(Style::curve(number))?);
            if let Some(name) = &curve.name {
                let style = Some(Style::curve(number));
                scene.explain(Entry { text: Text::Formula(name.clone()), style, marker: None });
            }
        }
        for (number, curve) in self.curves.iter().enumerate() {
            if self.polygon {
                let ink = if several { Ink::Series(number) } else { Ink::Text };
                add_points(&mut scene, curve, Shape::Dot, ink)?;
            }
            let of_all = self.parameters.iter().map(|parameter| {
                (parameter, Expr::relation(Expr::name("t"), Rel::Eq, exact_text(parameter)))
            });
            let own = curve.marks.iter().map(|(parameter, text)| (parameter, text.clone()));
            for (parameter, text) in of_all.chain(own) {
                let what = || format!("the curve at t = {parameter}");
                let point = curve.value(parameter).ok_or_else(|| SceneError::AtInfinity { what: what() })?;
                let spot = Spot::exact(&point)?;
                scene.add(Marker::new(spot, Shape::Diamond, Ink::Accent));
                scene.add(Label::beside(spot, text, Direction::South).small());
            }
        }
        let degrees: Vec<String> =
            self.curves.iter().map(|curve| curve.points.len().saturating_sub(1).to_string()).collect();
        let plural = if several { "s of degrees" } else { " of degree" };
        Ok(scene
            .with_description(format!("Bézier curve{plural} {} with control points.", degrees.join(", "))))
    }
}
