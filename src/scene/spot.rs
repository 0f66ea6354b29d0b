//! Places in the plane, and why something cannot be drawn.

use std::fmt;

use num_traits::ToPrimitive;

use crate::math::number::Rational;

/// A place in the plane, in the coordinates of the data.
///
/// **Invariant.** Both coordinates are finite and at most [`Spot::LARGEST`] in absolute value, so
/// that means, differences and squares of distances are finite too: no drawing meets a NaN.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spot {
    x: f64,
    y: f64,
}

impl Spot {
    /// The largest absolute value of a coordinate.
    pub const LARGEST: f64 = 1e150;

    /// The place (x, y).
    ///
    /// # Errors
    /// [`SceneError::TooLarge`] when a coordinate is beyond [`Spot::LARGEST`] or no number.
    ///
    /// ```
    /// use polarform::scene::Spot;
    /// assert_eq!(Spot::new(1.0, 2.0)?.x(), 1.0);
    /// assert!(Spot::new(f64::NAN, 0.0).is_err());
    /// # Ok::<(), polarform::scene::SceneError>(())
    /// ```
    pub fn new(x: f64, y: f64) -> Result<Self, SceneError> {
        for (name, value) in [("x", x), ("y", y)] {
            if value.is_nan() || value.abs() > Spot::LARGEST {
                return Err(SceneError::TooLarge { what: format!("the coordinate {name} = {value}") });
            }
        }
        Ok(Spot { x, y })
    }

    /// The place with these exact coordinates, each rounded once.
    ///
    /// # Errors
    /// [`SceneError::TooLarge`], as for [`Spot::new`].
    pub fn exact([x, y]: &[Rational; 2]) -> Result<Self, SceneError> {
        Ok(Spot { x: rounded(x, "x")?, y: rounded(y, "y")? })
    }

    /// The first coordinate.
    pub fn x(self) -> f64 {
        self.x
    }

    /// The second coordinate.
    pub fn y(self) -> f64 {
        self.y
    }

    /// (1 − t) self + t other for t in [0, 1], which is inside the bounds as both ends are.
    pub fn toward(self, other: Spot, t: f64) -> Spot {
        let t = if t.is_nan() { 0.0 } else { t.clamp(0.0, 1.0) };
        Spot { x: (1.0 - t) * self.x + t * other.x, y: (1.0 - t) * self.y + t * other.y }
    }

    /// self + (dx, dy), kept inside the bounds; NaN counts as 0.
    pub(super) fn moved(self, dx: f64, dy: f64) -> Spot {
        let inside = |value: f64, old: f64| {
            if value.is_nan() { old } else { value.clamp(-Spot::LARGEST, Spot::LARGEST) }
        };
        Spot { x: inside(self.x + dx, self.x), y: inside(self.y + dy, self.y) }
    }

    /// The distance to another place.
    pub fn distance(self, other: Spot) -> f64 {
        (self.x - other.x).hypot(self.y - other.y)
    }
}

/// A number as a coordinate called `name`.
pub(super) fn rounded(value: &Rational, name: &str) -> Result<f64, SceneError> {
    match value.to_f64() {
        Some(rounded) if rounded.abs() <= Spot::LARGEST => Ok(rounded),
        _ => Err(SceneError::TooLarge { what: format!("a coordinate {name}") }),
    }
}

/// Why something cannot be drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SceneError {
    /// A coordinate does not fit a drawing, see [`Spot::LARGEST`].
    TooLarge {
        /// Which.
        what: String,
    },
    /// A rational curve passes through infinity: its weight function vanishes.
    AtInfinity {
        /// Which curve, or point.
        what: String,
    },
    /// Nothing to draw.
    Empty {
        /// What is missing.
        what: &'static str,
    },
    /// Numbers of points that do not fit each other.
    Shape {
        /// What was expected.
        what: String,
    },
    /// An interval of length 0, or ends in the wrong order.
    Interval {
        /// Which.
        what: &'static str,
    },
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneError::TooLarge { what } => write!(f, "{what} is too large to be drawn"),
            SceneError::AtInfinity { what } => {
                write!(f, "{what} passes through infinity: its weight vanishes")
            }
            SceneError::Empty { what } => write!(f, "nothing to draw: there are no {what}"),
            SceneError::Shape { what } => f.write_str(what),
            SceneError::Interval { what } => write!(f, "{what} is empty or runs backwards"),
        }
    }
}

impl std::error::Error for SceneError {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{integer, rational};

    #[test]
    fn rounding() {
        let third = Spot::exact(&[rational(1, 3), integer(-2)]).unwrap();
        assert_eq!((third.x(), third.y()), (1.0 / 3.0, -2.0));
        // both numbers far beyond f64, their quotient not
        let huge = num_traits::pow(integer(10), 400);
        let one = Spot::exact(&[(huge.clone() + integer(1)) / huge.clone(), integer(0)]).unwrap();
        assert_eq!(one.x(), 1.0);
        assert_eq!(
            Spot::exact(&[integer(0), huge]).unwrap_err().to_string(),
            "a coordinate y is too large to be drawn"
        );
        assert!(Spot::new(0.0, f64::INFINITY).is_err());
    }

    #[test]
    fn moving_stays_inside() {
        let edge = Spot::new(Spot::LARGEST, 0.0).unwrap();
        assert_eq!(edge.moved(f64::INFINITY, f64::NAN), edge);
        assert_eq!(edge.toward(Spot::default(), f64::NAN), edge);
        assert_eq!(edge.toward(Spot::default(), 2.0), Spot::default());
    }
}
