//! How smoothly two curves join.

use super::curve::{add_names, add_points, add_polygon, levels};
use super::{Curve, Plane};
use crate::formula::Expr;
use crate::math::number::Rational;
use crate::scene::{Dash, Ink, Marker, Path, Scene, SceneError, Shape, Spot, Style};

/// Two curves of the same degree over [r, s] and [s, u], and the construction that tells how
/// smoothly they join.
///
/// The curve on the left, continued to [s, u] by de Casteljau's algorithm at (u − r)/(s − r),
/// has the control points f(s, …, s, u, …, u). The two join with k continuous derivatives
/// exactly if its first k + 1 points there are those of the curve on the right.
///
/// ```
/// use polarform::number::integer as z;
/// use polarform::scene::pictures::ContinuityPicture;
/// let points = |list: [[i64; 2]; 3]| list.map(|p| p.map(z)).to_vec();
/// let picture = ContinuityPicture {
///     left: points([[0, 0], [1, 2], [2, 2]]),
///     right: points([[2, 2], [3, 2], [4, 1]]),
///     knots: [0, 1, 2].map(z),
///     smoothness: 1,
///     left_labels: Vec::new(),
///     right_labels: Vec::new(),
/// };
/// assert_eq!(picture.continuity()?, Some(1));
/// # Ok::<(), polarform::scene::SceneError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ContinuityPicture {
    /// The control points of the curve over [r, s].
    pub left: Vec<Plane>,
    /// The control points of the curve over [s, u].
    pub right: Vec<Plane>,
    /// r < s < u.
    pub knots: [Rational; 3],
    /// Up to which derivative the construction is shown; at most the degree.
    pub smoothness: usize,
    /// The names of the control points on the left.
    pub left_labels: Vec<Expr>,
    /// The names of those on the right; the first one is not shown where the curves meet.
    pub right_labels: Vec<Expr>,
}

impl ContinuityPicture {
    /// The greatest k such that the curves join with k continuous derivatives, up to the degree;
    /// `None` if they do not meet.
    ///
    /// # Errors
    /// As for [`ContinuityPicture::scene`].
    pub fn continuity(&self) -> Result<Option<usize>, SceneError> {
        let construction = self.construction(self.left.len().saturating_sub(1))?;
        let equal =
            construction.iter().zip(&self.right).take_while(|(level, point)| level.last() == Some(*point));
        Ok(equal.count().checked_sub(1))
    }

    /// The points of de Casteljau's algorithm on the last k + 1 control points of the left curve:
    /// level j ends in the point that should be number j on the right.
    fn construction(&self, smoothness: usize) -> Result<Vec<Vec<Plane>>, SceneError> {
        let [r, s, u] = &self.knots;
        if !(r < s && s < u) {
            return Err(SceneError::Interval { what: "one of the intervals" });
        }
        if self.left.is_empty() || self.left.len() != self.right.len() {
            return Err(SceneError::Shape {
                what: "the two curves need equally many control points".to_owned(),
            });
        }
        let t = (u - r) / (s - r);
        let first = self.left.len() - 1 - smoothness.min(self.left.len() - 1);
        Ok(levels(&self.left[first..], &t))
    }

    /// The picture.
    ///
    /// # Errors
    /// [`SceneError`] when the knots do not ascend, the numbers of control points differ, or a
    /// coordinate is too large.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        let construction = self.construction(self.smoothness)?;
        let mut scene = Scene::new("Two curves and their join").also("zh", "两条曲线及其连接");
        let style = Style::line(Ink::Guide, 1.2);
        let left = Curve::new(self.left.clone()).with_labels(self.left_labels.clone());

        // the lines along which the construction continues the polygon
        for pair in construction.windows(2) {
            for (leg, end) in pair[0].windows(2).zip(&pair[1]) {
                let (from, to) = (Spot::exact(&leg[1])?, Spot::exact(end)?);
                scene.add(Path::line(from, to, Style::line(Ink::Accent, 1.2).dashed(Dash::Dashed)));
            }
        }
        for level in construction.iter().skip(1) {
            let spots: Vec<Spot> = level.iter().map(Spot::exact).collect::<Result<_, _>>()?;
            if let Some(path) = Path::lines(spots.iter().copied(), Style::line(Ink::Accent, 0.9)) {
                scene.add(path);
            }
            for &spot in &spots {
                scene.add(Marker { radius: 2.4, ..Marker::new(spot, Shape::Dot, Ink::Accent) });
            }
        }
        let mut right = Curve::new(self.right.clone());
        add_polygon(&mut scene, &left, style)?;
        add_polygon(&mut scene, &right, style)?;
        scene.add(left.path(Style::curve(0))?);
        scene.add(right.path(Style::curve(1))?);
        add_points(&mut scene, &left, Shape::Dot, Ink::Series(0))?;
        add_points(&mut scene, &right, Shape::Dot, Ink::Series(1))?;
        // where the curves meet, one name is enough
        right.labels = self.right_labels.clone();
        add_names(&mut scene, &right, usize::from(self.left.last() == self.right.first()))?;
        // where the continued curve would need them
        for (level, point) in construction.iter().zip(&self.right).skip(1) {
            if let Some(wanted) = level.last() {
                let spot = Spot::exact(wanted)?;
                let shape = if wanted == point { Shape::Ring } else { Shape::Cross };
                let marker = Marker::new(spot, shape, Ink::Accent);
                scene.add(Marker { radius: 6.0, ..marker });
            }
        }
        if let Some(join) = self.left.last() {
            scene.add(Marker::new(Spot::exact(join)?, Shape::Square, Ink::Text));
        }
        let found = match self.continuity()? {
            None => "The two curves do not meet.".to_owned(),
            Some(k) if k + 1 >= self.left.len() => {
                "The two curves are the same polynomial; all derivatives agree.".to_owned()
            }
            Some(0) => "The two curves meet; their first derivatives differ.".to_owned(),
            Some(1) => "The two curves join with a continuous first derivative, and no more.".to_owned(),
            Some(k) => format!("The two curves join with {k} continuous derivatives, and no more."),
        };
        Ok(scene.with_description(found))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer, rational};
    use num_traits::{One, Zero, pow};
    use proptest::prelude::*;

    /// f(x, …, x, y, …, y) of a polynomial curve given by power coefficients, by symmetrising.
    fn polar(coefficients: &[i64], arguments: &[Rational]) -> Rational {
        let n = arguments.len();
        let mut elementary = vec![Rational::zero(); n + 1];
        elementary[0] = Rational::one();
        for (count, x) in arguments.iter().enumerate() {
            for k in (1..=count + 1).rev() {
                elementary[k] = &elementary[k] + &elementary[k - 1] * x;
            }
        }
        let terms = coefficients.iter().enumerate();
        terms
            .map(|(k, &c)| {
                integer(c) * &elementary[k] / Rational::from_integer(crate::math::number::binomial(n, k))
            })
            .fold(Rational::zero(), |sum, term| sum + term)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        /// Two pieces of one polynomial, changed by c (t − s)^{k+1}, join with k derivatives.
        #[test]
        fn continuity_is_found(
            coefficients in proptest::collection::vec(-9_i64..9, 4),
            k in 0_usize..3,
            change in 1_i64..5,
            steps in (1_i64..4, 1_i64..4),
        ) {
            let n = coefficients.len() - 1;
            let knots = [integer(-1), integer(-1) + integer(steps.0), integer(-1) + integer(steps.0 + steps.1)];
            let points = |c: &[i64], a: &Rational, b: &Rational| -> Vec<Plane> {
                (0..=n)
                    .map(|i| {
                        let arguments: Vec<Rational> =
                            std::iter::repeat_n(a.clone(), n - i).chain(std::iter::repeat_n(b.clone(), i)).collect();
                        let x = arguments.iter().fold(Rational::zero(), |sum, x| sum + x) / integer(n as i64);
                        [x, polar(c, &arguments)]
                    })
                    .collect()
            };
            // the coefficients of change · (t − s)^{k+1}
            let s = steps.0 - 1;
            let mut other = coefficients.clone();
            for (j, coefficient) in other.iter_mut().enumerate().take(k + 2) {
                let binomial = crate::math::number::binomial(k + 1, j).as_small().unwrap();
                *coefficient += change * binomial * pow(-s, k + 1 - j);
            }
            let picture = ContinuityPicture {
                left: points(&coefficients, &knots[0], &knots[1]),
                right: points(&other, &knots[1], &knots[2]),
                knots,
                smoothness: n,
                left_labels: Vec::new(),
                right_labels: Vec::new(),
            };
            prop_assert_eq!(picture.continuity(), Ok(Some(k)));
            prop_assert!(picture.scene().is_ok());
        }
    }

    #[test]
    fn bad_input() {
        let mut picture = ContinuityPicture {
            left: vec![[integer(0), integer(0)]],
            right: vec![[rational(1, 2), integer(0)]],
            knots: [0, 1, 2].map(integer),
            smoothness: 7,
            left_labels: Vec::new(),
            right_labels: Vec::new(),
        };
        assert_eq!(picture.continuity(), Ok(None));
        assert!(picture.scene().is_ok());
        picture.right.clear();
        assert!(matches!(picture.scene(), Err(SceneError::Shape { .. })));
        picture.knots[2] = integer(1);
        assert!(matches!(picture.scene(), Err(SceneError::Interval { .. })));
    }
}
