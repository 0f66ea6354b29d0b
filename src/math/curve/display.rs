//! Curves as text: the calls by which the query language makes them.

use std::fmt::{Display, Formatter, Result};

use super::{
    BezierCurve, Interval, Net, Point, RationalCurve, RationalPatch, RationalTriangle, TensorPatch, Triangle,
    TrianglePatch, Vector,
};
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
    list(f, points, |f, point| Display::fmt(point, f))
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
    weights: &[C],
    vectors: &[Point<C>],
    behind: impl FnOnce(&mut Formatter<'_>) -> Result,
) -> Result {
    match given.into_iter().collect::<Option<Vec<_>>>() {
        Some(finite) => {
            points(f, &finite)?;
            behind(f)?;
            f.write_str(", weights=")?;
            list(f, weights, |f, weight| Display::fmt(weight, f))
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
        weighted(f, self.points(), &self.weights(), self.homogeneous().points(), |f| {
            ends(f, self.interval().ends())
        })?;
        f.write_str(")")
    }
}

/// A net by rows, in brackets.
pub(crate) fn net<C: Display>(f: &mut Formatter<'_>, rows: &[Vec<Point<C>>]) -> Result {
    list(f, rows, |f, row| points(f, row))
}

/// As [`weighted`], for the rows of a net.
pub(crate) fn weighted_net<C: Display>(
    f: &mut Formatter<'_>,
    given: Vec<Vec<Option<Point<C>>>>,
    weights: &[Vec<C>],
    vectors: &[Vec<Point<C>>],
    behind: impl FnOnce(&mut Formatter<'_>) -> Result,
) -> Result {
    let finite: Option<Net<C>> = given.into_iter().map(|row| row.into_iter().collect()).collect();
    match finite {
        Some(finite) => {
            net(f, &finite)?;
            behind(f)?;
            f.write_str(", weights=")?;
            list(f, weights, |f, row| list(f, row, |f, weight| Display::fmt(weight, f)))
        }
        None => {
            list(f, vectors, |f, row| list(f, row, |f, vector| list(f, vector, |f, x| Display::fmt(x, f))))?;
            behind(f)?;
            f.write_str(", homogeneous=1")
        }
    }
}

/// The coordinates `(x, y, …)`; on the line the number alone.
impl<C: Display> Display for Point<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        coordinates(f, self, ["(", ")"])
    }
}

/// The coordinates `[x, y, …]`; on the line the number alone.
impl<C: Display> Display for Vector<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        coordinates(f, self, ["[", "]"])
    }
}

fn coordinates<C: Display>(f: &mut Formatter<'_>, list: &[C], [open, close]: [&str; 2]) -> Result {
    match list {
        [x] => Display::fmt(x, f),
        list => {
            let shown: Vec<String> = list.iter().map(C::to_string).collect();
            write!(f, "{open}{}{close}", shown.join(", "))
        }
    }
}

/// The corners `[(0, 0), (1, 0), (0, 1)]`.
impl<C: Display> Display for Triangle<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let [a, b, c] = &self.corners;
        write!(f, "[{a}, {b}, {c}]")
    }
}

fn rectangle<C: Field + Display>(f: &mut Formatter<'_>, patch: &TensorPatch<C>) -> Result {
    match (patch.u(), patch.v()) {
        (u, v) if *u == Interval::unit() && *v == Interval::unit() => Ok(()),
        (u, v) => write!(f, ", {u}, {v}"),
    }
}

fn corners<C: Field + Display>(f: &mut Formatter<'_>, patch: &TrianglePatch<C>) -> Result {
    match patch.triangle() {
        triangle if *triangle == Triangle::unit() => Ok(()),
        triangle => write!(f, ", {triangle}"),
    }
}

/// `patch([[b_00, …], …], [a, b], [c, d])`, without the intervals if both are [0, 1].
impl<C: Field + Display> Display for TensorPatch<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str("patch(")?;
        net(f, self.net())?;
        rectangle(f, self)?;
        f.write_str(")")
    }
}

/// `triangle_patch([b_n00, …, b_00n], [p, q, r])`, without the corners if they are (0, 0), (1, 0), (0, 1).
impl<C: Field + Display> Display for TrianglePatch<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str("triangle_patch(")?;
        points(f, self.points())?;
        corners(f, self)?;
        f.write_str(")")
    }
}

/// As for a polynomial patch, with `weights=[[…], …]`; with `homogeneous=1` and the control vectors if one has
/// weight 0.
impl<C: Field + Display> Display for RationalPatch<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let patch = self.homogeneous();
        f.write_str("patch(")?;
        weighted_net(f, self.points(), &self.weights(), patch.net(), |f| rectangle(f, patch))?;
        f.write_str(")")
    }
}

/// As for a polynomial patch, with `weights=[…]`; with `homogeneous=1` and the control vectors if one has weight 0.
impl<C: Field + Display> Display for RationalTriangle<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let patch = self.homogeneous();
        f.write_str("triangle_patch(")?;
        weighted(f, self.points(), &self.weights(), patch.points(), |f| corners(f, patch))?;
        f.write_str(")")
    }
}

debug_by_text!(
    BezierCurve,
    Point,
    RationalCurve,
    RationalPatch,
    RationalTriangle,
    TensorPatch,
    Triangle,
    TrianglePatch,
    Vector
);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::curve::Interval;
    use crate::math::number::{Rational, integer as z, rational as q};

    #[test]
    fn as_the_language_writes_them() {
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

    #[test]
    fn surfaces_points_and_vectors() {
        let p = Point::from([z(1), q(1, 2)]);
        assert_eq!(format!("{p} {p:?} {}", p.position()), "(1, 1/2) Point((1, 1/2)) [1, 1/2]");
        assert_eq!(format!("{:?}", Vector::from([z(7)])), "Vector(7)");
        let patch = |u| {
            TensorPatch::new(
                vec![vec![vec![z(0)], vec![z(1)]], vec![vec![z(2)], vec![z(5)]]],
                u,
                Interval::unit(),
            )
        };
        let unit = patch(Interval::unit()).unwrap();
        assert_eq!(format!("{unit:?}"), "TensorPatch(patch([[0, 1], [2, 5]]))");
        let wide = patch(Interval::new(z(0), z(2)).unwrap()).unwrap();
        assert_eq!(wide.to_string(), "patch([[0, 1], [2, 5]], [0, 2], [0, 1])");
        let net = vec![vec![[z(0)], [z(1)]], vec![[z(2)], [z(5)]]];
        let weights = [[1, 2], [1, 1]].map(|row| row.map(z).to_vec()).to_vec();
        let rational = RationalPatch::new(net, weights, Interval::unit(), Interval::unit());
        assert_eq!(rational.unwrap().to_string(), "patch([[0, 1], [2, 5]], weights=[[1, 2], [1, 1]])");
        let infinite = RationalPatch::from_homogeneous(
            TensorPatch::new(vec![plane(&[[1, 0], [1, 1]])], Interval::unit(), Interval::unit()).unwrap(),
        );
        assert_eq!(infinite.unwrap().to_string(), "patch([[[1, 0], [1, 1]]], homogeneous=1)");
        let points = [1, 2, 3].map(|x| [z(x)]).to_vec();
        let corners = Triangle::new([[z(0), z(0)], [z(2), z(0)], [z(0), z(1)]]).unwrap();
        let triangle = TrianglePatch::new(points.clone(), corners).unwrap();
        assert_eq!(triangle.to_string(), "triangle_patch([1, 2, 3], [(0, 0), (2, 0), (0, 1)])");
        let rational = RationalTriangle::new(points, [1, 2, 1].map(z).to_vec(), Triangle::unit()).unwrap();
        assert_eq!(format!("{rational:?}"), "RationalTriangle(triangle_patch([1, 2, 3], weights=[1, 2, 1]))");
    }

    fn plane(points: &[[i64; 2]]) -> Vec<Point<Rational>> {
        points.iter().map(|p| p.map(z).into()).collect()
    }
}
