//! Graphs of functions.

use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::budget;
use crate::formula::Expr;
use crate::math::number::{Rational, binomial};
use crate::scene::{
    Aspect, Axis, Direction, Ink, Label, Marker, Orientation, Path, Scene, SceneError, Segment, Shape, Spot,
    Style, Text, Tick, bezier_path, exact_text, nice_ticks,
};

/// A polynomial on an interval.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Where it holds.
    pub interval: [Rational; 2],
    /// Its coefficients c_0, c_1, … for the powers of the variable.
    pub coefficients: Vec<Rational>,
}

/// A function that is a polynomial on each of some intervals.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// Its pieces in ascending order; elsewhere nothing is drawn.
    pub pieces: Vec<Piece>,
    /// Its name, written near its maximum.
    pub label: Option<Expr>,
}

/// A number on the axis that is marked.
#[derive(Clone, Debug, PartialEq)]
pub struct Knot {
    /// The number.
    pub at: Rational,
    /// How many dots are below it.
    pub multiplicity: usize,
    /// What is written below; the number, if nothing else is said.
    pub label: Option<Expr>,
}

/// Graphs of functions over an interval, as of a basis, with knots on the axis.
///
/// ```
/// use polarform::expr::Expr;
/// use polarform::number::integer as z;
/// use polarform::scene::pictures::{BasisPicture, Function, Piece};
/// let piece = |c: [i64; 2]| Piece { interval: [z(0), z(1)], coefficients: c.map(z).to_vec() };
/// let functions = [[1, -1], [0, 1]].map(|c| Function { pieces: vec![piece(c)], label: None });
/// let picture = BasisPicture::of(functions.to_vec(), [z(0), z(1)]);
/// assert!(picture.scene().is_ok());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BasisPicture {
    /// The functions, each in its own colour.
    pub functions: Vec<Function>,
    /// What is shown of the axis.
    pub interval: [Rational; 2],
    /// Marks on the axis; without knots, round numbers.
    pub knots: Vec<Knot>,
    /// The name of the variable.
    pub variable: Option<Expr>,
    /// The height of the graphs in pixels.
    pub height: f64,
}

/// The graph of a piece: its polynomial over an interval by Bézier ordinates.
struct Graph {
    interval: [Rational; 2],
    ordinates: Vec<Rational>,
}

impl BasisPicture {
    /// Graphs over an interval in the variable t.
    pub fn of(functions: Vec<Function>, interval: [Rational; 2]) -> Self {
        BasisPicture {
            functions,
            interval,
            knots: Vec::new(),
            variable: Some(Expr::name("t")),
            height: 260.0,
        }
    }

    /// The picture.
    ///
    /// # Errors
    /// [`SceneError::Interval`] when the interval is empty, [`SceneError::TooLarge`].
    pub fn scene(&self) -> Result<Scene, SceneError> {
        let [from, to] = &self.interval;
        if from >= to {
            return Err(SceneError::Interval { what: "the interval of the graphs" });
        }
        let mut scene = Scene::new("Graphs of functions")
            .also("zh", "函数图像")
            .with_aspect(Aspect::Free { height: self.height });
        let mut graphs = Vec::new();
        for function in &self.functions {
            let mut of_function = Vec::new();
            for piece in &function.pieces {
                let [a, b] = &piece.interval;
                let interval = [a.max(from).clone(), b.min(to).clone()];
                if interval[0] < interval[1] {
                    let ordinates = ordinates(&piece.coefficients, &interval);
                    of_function.push(Graph { interval, ordinates });
                }
            }
            graphs.push(of_function);
        }
        let mut paths = Vec::new();
        for (number, pieces) in graphs.iter().enumerate() {
            paths.push(joined(pieces, Style { width: 2.0, ..Style::curve(number) })?);
        }
        let (low, high) = range(&paths);
        // below the least value room for a name
        let low = if low < 0.0 { low - 0.1 * (high - low) } else { low };
        self.axes(
            &mut scene,
            &graphs,
            low.min(0.0),
            if high > low || high > 0.0 { high } else { low + 1.0 },
        )?;
        for (paths, function) in paths.into_iter().zip(&self.functions) {
            let extreme = paths.iter().flat_map(places).max_by(|a, b| {
                // of equal ones the first, so that names do not depend on noise
                a.y().abs().total_cmp(&b.y().abs()).then(b.x().total_cmp(&a.x()))
            });
            if let (Some(extreme), Some(label)) = (extreme, &function.label) {
                let (at, direction) = self.name_place(&paths, extreme)?;
                scene.add(Label::beside(at, label.clone(), direction));
            }
            paths.into_iter().for_each(|path| scene.add(path));
        }
        Ok(scene.with_description(format!(
            "The graphs of {} functions over the interval from {from} to {to}.",
            self.functions.len()
        )))
    }

    /// Where the name of a function stands: above its maximum, below its minimum; a little inside
    /// if that is an end of the interval, where it would look like the name of an axis.
    fn name_place(&self, paths: &[Path], extreme: Spot) -> Result<(Spot, Direction), SceneError> {
        let [from, to] =
            [&self.interval[0], &self.interval[1]].map(|end| Spot::exact(&[end.clone(), Rational::zero()]));
        let (from, to) = (from?.x(), to?.x());
        let margin = 0.06 * (to - from);
        let inside = extreme.x().clamp(from + margin, to - margin);
        // not so far that the function is no longer large
        let near = |place: &Spot| {
            place.y().abs() >= 0.8 * extreme.y().abs() && (place.x() - extreme.x()).abs() <= 1.5 * margin
        };
        let distance = |place: &Spot| (place.x() - inside).abs();
        let nearest =
            paths.iter().flat_map(places).filter(near).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let at = if inside == extreme.x() { extreme } else { nearest.unwrap_or(extreme) };
        let up = if extreme.y() < 0.0 { -1.0 } else { 1.0 };
        let right = if inside > extreme.x() {
            1.0
        } else if inside < extreme.x() {
            -1.0
        } else {
            0.0
        };
        Ok((at, Direction::of(right, up)))
    }

    fn axes(&self, scene: &mut Scene, graphs: &[Vec<Graph>], low: f64, high: f64) -> Result<(), SceneError> {
        let [from, to] = &self.interval;
        let corner = Spot::exact(&[from.clone(), Rational::zero()])?;
        let end = Spot::exact(&[to.clone(), Rational::zero()])?;
        let bottom = Spot::new(corner.x(), low)?;
        if low < 0.0 {
            scene.add(Path::line(corner, end, Style::line(Ink::Guide, 0.8)));
        }
        let mut ticks = Vec::new();
        let mut marks: Vec<(f64, usize)> = Vec::new();
        if self.knots.is_empty() {
            for value in nice_ticks(from, to, 4) {
                let at = value.to_f64().unwrap_or(f64::NAN);
                ticks.push(Tick { at, label: Some(exact_text(&value).into()) });
            }
        } else {
            let inside = self.knots.iter().filter(|knot| from <= &knot.at && &knot.at <= to);
            for knot in inside {
                let at = Spot::exact(&[knot.at.clone(), Rational::zero()])?.x();
                let label = knot.label.clone().unwrap_or_else(|| exact_text(&knot.at));
                ticks.push(Tick { at, label: Some(label.into()) });
                marks.push((at, knot.multiplicity));
            }
            ticks.sort_by(|a, b| a.at.total_cmp(&b.at));
        }
        scene.add(Axis {
            orientation: Orientation::Horizontal,
            from: bottom,
            length: end.x() - corner.x(),
            ticks,
            name: self.variable.clone().map(Text::Formula),
        });
        for (at, multiplicity) in marks {
            // side by side below the number
            let count = multiplicity.min(40);
            for k in 0..count {
                let marker = Marker::new(Spot::new(at, low)?, Shape::Dot, Ink::Text);
                let right = 6.5 * (k as f64 - (count as f64 - 1.0) / 2.0);
                scene.add(Marker { radius: 2.3, ..marker }.moved(right, -29.0));
            }
        }
        // round numbers between the exact ordinates, those in sight
        let all = || graphs.iter().flatten().flat_map(|graph| &graph.ordinates);
        let zero = Rational::zero();
        let (least, greatest) =
            (all().min().unwrap_or(&zero).min(&zero), all().max().unwrap_or(&zero).max(&zero));
        let in_sight = |count: usize| -> Vec<Tick> {
            let tick = |value: &Rational| Tick {
                at: value.to_f64().unwrap_or(f64::NAN),
                label: Some(exact_text(value).into()),
            };
            let values = nice_ticks(least, greatest, count);
            let shown = values.iter().filter(|value| low < 0.0 || value.is_positive()).map(tick);
            shown.filter(|tick| low <= tick.at && tick.at <= high).collect()
        };
        // The ordinates may lie far outside of the graph; two numbers tell the scale.
        let counts = [4, 8, 16, 32, 64, 100];
        let ticks = counts.into_iter().map(in_sight).find(|ticks| ticks.len() > 1);
        let ticks = ticks.unwrap_or_else(|| in_sight(100));
        scene.add(Axis {
            orientation: Orientation::Vertical,
            from: bottom,
            length: high - low,
            ticks,
            name: None,
        });
        Ok(())
    }
}

/// The Bézier ordinates of Σ c_k t^k over [a, b].
///
/// First the coefficients d of the powers of u for t = a + (b − a) u, by Horner's scheme, then
/// b_i = Σ_{j ≤ i} C(i, j)/C(n, j) d_j.
fn ordinates(coefficients: &[Rational], [a, b]: &[Rational; 2]) -> Vec<Rational> {
    let mut shifted = coefficients.to_vec();
    if shifted.is_empty() {
        shifted.push(Rational::zero());
    }
    let n = shifted.len() - 1;
    budget::charge_terms((n as u64 + 1).saturating_pow(2));
    for first in 0..n {
        for k in (first..n).rev() {
            budget::step();
            shifted[k] = &shifted[k] + a * &shifted[k + 1];
        }
    }
    let length = b - a;
    let mut scale = Rational::one();
    for (j, coefficient) in shifted.iter_mut().enumerate() {
        *coefficient = &*coefficient * &scale / Rational::from_integer(binomial(n, j));
        scale = &scale * &length;
    }
    // d_j / C(n, j) are differences Δ^j b_0: sum them up
    for level in (0..n).rev() {
        for k in level..n {
            budget::step();
            shifted[k + 1] = &shifted[k + 1] + &shifted[k];
        }
    }
    shifted
}

/// The graphs of pieces; those that meet are one path.
fn joined(pieces: &[Graph], style: Style) -> Result<Vec<Path>, SceneError> {
    let mut paths: Vec<Path> = Vec::new();
    for Graph { interval: [a, b], ordinates } in pieces {
        let n = ordinates.len() - 1;
        let abscissa = |i: usize| match n {
            0 => a.clone(),
            _ => a + (b - a) * Rational::new(i.into(), n.into()),
        };
        let mut spots: Vec<Spot> = ordinates
            .iter()
            .enumerate()
            .map(|(i, y)| Spot::exact(&[abscissa(i), y.clone()]))
            .collect::<Result<_, _>>()?;
        if n == 0 {
            spots.push(Spot::exact(&[b.clone(), ordinates[0].clone()])?);
        }
        let segments: Vec<Segment> = bezier_path(&spots)?;
        match paths.last_mut() {
            Some(path) if path.end() == spots[0] => path.segments.extend(segments),
            _ => paths.push(Path::new(spots[0], segments, style)),
        }
    }
    Ok(paths)
}

/// Points along a path.
fn places(path: &Path) -> Vec<Spot> {
    let mut from = path.start;
    let mut list = vec![from];
    for segment in &path.segments {
        match segment {
            Segment::Line(to) => list.push(*to),
            Segment::Cubic([b, c, d]) => {
                let at = |k: u32| crate::scene::sample::cubic_at(&[from, *b, *c, *d], f64::from(k) / 16.0);
                list.extend((1..=16).map(at));
            }
        }
        from = segment.end();
    }
    list
}

fn range(paths: &[Vec<Path>]) -> (f64, f64) {
    let all = paths.iter().flatten().flat_map(places);
    let (low, high) =
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(p.y()), high.max(p.y())));
    if low <= high { (low, high) } else { (0.0, 1.0) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::basis::{Basis, change_of_basis};
    use crate::math::interval::Interval;
    use crate::math::number::{integer, rational};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]

        #[test]
        fn ordinates_agree_with_the_change_of_basis(
            coefficients in proptest::collection::vec(-9_i64..9, 1..7),
            a in -5_i64..5,
            length in 1_i64..5,
        ) {
            let coefficients: Vec<Rational> = coefficients.into_iter().map(|c| rational(c, 3)).collect();
            let (a, b) = (rational(a, 2), rational(a, 2) + rational(length, 3));
            let basis = Basis::Bernstein(Interval::new(a.clone(), b.clone()).unwrap());
            let matrix = change_of_basis(coefficients.len() - 1, &Basis::Power, &basis).unwrap();
            let expected = matrix * nalgebra::DVector::from_vec(coefficients.clone());
            prop_assert_eq!(ordinates(&coefficients, &[a, b]), expected.as_slice());
        }
    }

    #[test]
    fn bad_input() {
        let mut picture = BasisPicture::of(Vec::new(), [integer(0), integer(1)]);
        assert!(picture.scene().is_ok());
        let nothing = Piece { interval: [integer(0), integer(1)], coefficients: Vec::new() };
        picture.functions.push(Function { pieces: vec![nothing], label: None });
        assert!(picture.scene().is_ok());
        picture.interval[1] = integer(0);
        assert!(matches!(picture.scene(), Err(SceneError::Interval { .. })));
    }
}
