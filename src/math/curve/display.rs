//! Curves as text: the calls by which the query language makes them.

use std::fmt::{Debug, Display, Formatter, Result};

use super::{BezierCurve, Point, RationalCurve};
use crate::math::ring::Field;

/// `[x, y, …]`
pub(crate) fn list<T>(
    f: &mut Formatter<'_>,
    items: &[T],
    mut write: impl FnMut(&mut Formatter<'_>, &T) -> Result,
) -> Result {
    f.write_str("[")?;
    for (i, item) in items.iter().enumerate() {
        if i > 0 {
            f.write_str(", ")?;
        }
        write(f, item)?;
    }
    f.write_str("]")
}

/// A number for a point of the line, else its coordinates in parentheses.
pub(crate) fn points<C: Display>(f: &mut Formatter<'_>, points: &[Point<C>]) -> Result {
    list(f, points, |f, point| match &point[..] {
        [x] => Display::fmt(x, f),
        coordinates => {
            let shown: Vec<String> = coordinates.iter().map(C::to_string).collect();
            write!(f, "({})", shown.join(", "))
        }
    })
}

fn ends<C: Field + Display>(f: &mut Formatter<'_>, (a, b): (&C, &C)) -> Result {
    if a.is_zero() && b.is_one() { Ok(()) } else { write!(f, ", {a}, {b}") }
}

/// `bezier([b_0, …, b_n], a, b)`, without the ends if they are 0 and 1.
impl<C: Field + Display> Display for BezierCurve<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str("bezier(")?;
        points(f, self.points())?;
        ends(f, self.interval().ends())?;
        f.write_str(")")
    }
}

/// The control points, what stands behind them, and `weights=[…]`; with `homogeneous=1` the control
/// vectors if a point is at infinity.
pub(crate) fn weighted<C: Display>(
    f: &mut Formatter<'_>,
    given: Vec<Option<Point<C>>>,
    vectors: &[Point<C>],
    behind: impl FnOnce(&mut Formatter<'_>) -> Result,
) -> Result {
    match given.into_iter().collect::<Option<Vec<_>>>() {
        Some(finite) => {
            points(f, &finite)?;
            behind(f)?;
            f.write_str(", weights=")?;
            list(f, vectors, |f, vector| vector.last().map_or(Ok(()), |weight| Display::fmt(weight, f)))
        }
        None => {
            list(f, vectors, |f, vector| list(f, vector, |f, x| Display::fmt(x, f)))?;
            behind(f)?;
            f.write_str(", homogeneous=1")
        }
    }
}

/// As for a polynomial curve, with `weights=[…]`; with `homogeneous=1` and the control vectors if one
/// has weight 0.
impl<C: Field + Display> Display for RationalCurve<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str("bezier(")?;
        weighted(f, self.points(), self.homogeneous().points(), |f| ends(f, self.interval().ends()))?;
        f.write_str(")")
    }
}

/// `BezierCurve(bezier([0, 1]))`
impl<C: Field + Display> Debug for BezierCurve<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "BezierCurve({self})")
    }
}

/// `RationalCurve(bezier([0, 1], weights=[1, 2]))`
impl<C: Field + Display> Debug for RationalCurve<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "RationalCurve({self})")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::Interval;
    use crate::math::number::{Rational, integer as z, rational as q};

    #[test]
    fn as_the_language_writes_them() {
        let plane = |p: &[[i64; 2]]| p.iter().map(|p| p.map(z).into()).collect::<Vec<Point<Rational>>>();
        let curve = BezierCurve::new(plane(&[[0, 0], [1, 2]]), Interval::unit()).unwrap();
        assert_eq!(curve.to_string(), "bezier([(0, 0), (1, 2)])");
        let line =
            BezierCurve::new(vec![vec![q(1, 2)], vec![z(3)]], Interval::new(z(0), z(2)).unwrap()).unwrap();
        assert_eq!(line.to_string(), "bezier([1/2, 3], 0, 2)");
        let arc =
            RationalCurve::new(plane(&[[1, 0], [1, 1], [0, 1]]), [1, 1, 2].map(z).to_vec(), Interval::unit());
        assert_eq!(arc.unwrap().to_string(), "bezier([(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2])");
        let infinite = RationalCurve::from_homogeneous(
            BezierCurve::new(plane(&[[1, 0], [1, 1]]), Interval::unit()).unwrap(),
        );
        assert_eq!(infinite.unwrap().to_string(), "bezier([[1, 0], [1, 1]], homogeneous=1)");
    }
}
