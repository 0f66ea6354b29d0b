//! Curves that are graphs of functions.

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::Plane;
use crate::formula::Expr;
use crate::math::number::{Rational, rational};
use crate::scene::{
    Aspect, Axis, Ink, Item, Orientation, Path, Scene, SceneError, Spot, Style, Text, Tick, exact_text,
    nice_ticks,
};

/// The scene as the graph of a function of `variable`: its two coordinates scaled each by itself,
/// with axes at the left and below that span these points.
///
/// The axis below is at 0 if that is near the points. It is marked at the given numbers, as at knots;
/// without such, at round ones.
///
/// # Errors
/// [`SceneError::Empty`] without points, [`SceneError::TooLarge`].
///
/// ```
/// use polarform::expr::Expr;
/// use polarform::number::integer as z;
/// use polarform::scene::pictures::{BezierPicture, Curve, as_graph};
/// // t^2 over [0, 1]: the ordinates 0, 0, 1 stand over i/2
/// let points = [[0, 0], [1, 0], [2, 2]].map(|p| p.map(|k| z(k) / z(2))).to_vec();
/// let scene = BezierPicture::of(Curve::new(points.clone())).scene()?;
/// let graph = as_graph(scene, &points, &[], Some(Expr::name("t")), 260.0)?;
/// assert_eq!(graph.panels().len(), 1);
/// # Ok::<(), polarform::scene::SceneError>(())
/// ```
pub fn as_graph(
    scene: Scene,
    points: &[Plane],
    marks: &[Rational],
    variable: Option<Expr>,
    height: f64,
) -> Result<Scene, SceneError> {
    let extent = |k: usize| {
        let low = points.iter().map(|point| &point[k]).min()?.clone();
        Some([low, points.iter().map(|point| &point[k]).max()?.clone()])
    };
    let (Some([left, right]), Some([least, greatest])) = (extent(0), extent(1)) else {
        return Err(SceneError::Empty { what: "points" });
    };
    let right = if left == right { &right + Rational::one() } else { right };
    let range = &greatest - &least;
    let zero = Rational::zero();
    let mut low = if least.is_positive() && least <= range { zero.clone() } else { least.clone() };
    let mut high = if greatest.is_negative() && -greatest.clone() <= range { zero.clone() } else { greatest };
    if low == high {
        let around = if low.is_zero() { Rational::one() } else { low.abs() };
        high += &around * rational(1, 2);
        if !low.is_zero() {
            low -= around * rational(1, 2);
        }
    } else if !low.is_zero() {
        // room for names below the lowest point
        low -= (&high - &low) * rational(1, 12);
    }
    let corner = Spot::exact(&[left.clone(), low.clone()])?;
    let (east, north) =
        (Spot::exact(&[right.clone(), low.clone()])?, Spot::exact(&[left.clone(), high.clone()])?);
    let ticks = |values: &[Rational]| -> Vec<Tick> {
        let at = |value: &Rational| value.to_f64().unwrap_or(f64::NAN);
        values.iter().map(|value| Tick { at: at(value), label: Some(exact_text(value).into()) }).collect()
    };
    let along = if marks.is_empty() { ticks(&nice_ticks(&left, &right, 4)) } else { ticks(marks) };
    let mut below: Vec<Item> = Vec::new();
    if low.is_negative() && high.is_positive() {
        let [from, to] = [Spot::new(corner.x(), 0.0)?, Spot::new(east.x(), 0.0)?];
        below.push(Path::line(from, to, Style::line(Ink::Guide, 0.8)).into());
    }
    below.push(
        Axis {
            orientation: Orientation::Horizontal,
            from: corner,
            length: east.x() - corner.x(),
            ticks: along,
            name: variable.map(Text::Formula),
        }
        .into(),
    );
    // the corner itself carries the number of the axis below
    let upright =
        ticks(&nice_ticks(&low, &high, 4)).into_iter().filter(|tick| tick.at != corner.y()).collect();
    let length = north.y() - corner.y();
    below.push(
        Axis { orientation: Orientation::Vertical, from: corner, length, ticks: upright, name: None }.into(),
    );
    let mut scene = scene.with_aspect(Aspect::Free { height });
    scene.add_below(below);
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::integer;
    use crate::scene::{Extent, layout};

    #[test]
    fn axes_of_any_range() {
        let huge = num_traits::pow(integer(10), 140);
        for (from, to) in [
            (integer(0), integer(1)),
            (integer(-3), integer(5)),
            (integer(100), integer(101)),
            (integer(-7), integer(-7)),
            (integer(0), integer(0)),
            (-huge.clone(), huge),
        ] {
            let points = [[integer(0), from.clone()], [integer(1), to.clone()]];
            let scene = as_graph(Scene::new("range"), &points, &[], None, 260.0).unwrap();
            let page = layout(&scene, &|_, _| Extent::default());
            assert!(page.height.is_finite() && page.texts().count() > 1, "{from} to {to}");
        }
        assert!(matches!(as_graph(Scene::new(""), &[], &[], None, 1.0), Err(SceneError::Empty { .. })));
        let far = num_traits::pow(integer(10), 400);
        assert!(as_graph(Scene::new(""), &[[far.clone(), far]], &[], None, 1.0).is_err());
    }
}
