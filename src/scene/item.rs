//! What a scene consists of.

use super::{Ink, Spot, Style};
use crate::formula::Expr;

/// What a label says.
#[derive(Clone, Debug, PartialEq)]
pub enum Text {
    /// A formula, set as mathematics.
    Formula(Expr),
    /// Words.
    Words(String),
}

impl From<Expr> for Text {
    fn from(formula: Expr) -> Self {
        Text::Formula(formula)
    }
}

impl From<&str> for Text {
    fn from(words: &str) -> Self {
        Text::Words(words.to_owned())
    }
}

/// A part of a scene.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// Lines and curves.
    Path(Path),
    /// A mark at a place.
    Marker(Marker),
    /// A formula or words.
    Label(Label),
    /// An axis with its ticks.
    Axis(Axis),
}

/// The next piece of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Segment {
    /// A straight line to this place.
    Line(Spot),
    /// The cubic Bézier curve with the last place as b_0 and these b_1, b_2, b_3.
    Cubic([Spot; 3]),
}

impl Segment {
    /// Where it ends.
    pub fn end(&self) -> Spot {
        match self {
            Segment::Line(end) | Segment::Cubic([_, _, end]) => *end,
        }
    }
}

/// Lines and curves without interruption.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// Where it begins.
    pub start: Spot,
    /// Its pieces in order.
    pub segments: Vec<Segment>,
    /// Whether it is closed.
    pub closed: bool,
    /// How it is drawn.
    pub style: Style,
    /// Whether it ends in an arrowhead.
    pub arrow: bool,
    /// Whether its two ends, which lie in centred labels, stop at the boxes of these.
    pub trimmed: bool,
}

impl Path {
    /// The polyline through some places; `None` if there are none.
    pub fn lines(places: impl IntoIterator<Item = Spot>, style: Style) -> Option<Self> {
        let mut places = places.into_iter();
        let start = places.next()?;
        let segments = places.map(Segment::Line).collect();
        Some(Path { start, segments, closed: false, style, arrow: false, trimmed: false })
    }

    /// A path of given pieces.
    pub fn new(start: Spot, segments: Vec<Segment>, style: Style) -> Self {
        Path { start, segments, closed: false, style, arrow: false, trimmed: false }
    }

    /// The line from one place to another.
    pub fn line(from: Spot, to: Spot, style: Style) -> Self {
        Path::new(from, vec![Segment::Line(to)], style)
    }

    /// The same path, closed.
    pub fn close(self) -> Self {
        Path { closed: true, ..self }
    }

    /// The same path with an arrowhead at its end.
    pub fn with_arrow(self) -> Self {
        Path { arrow: true, ..self }
    }

    /// The same path, which ends at the boxes of labels around its ends.
    pub fn trim(self) -> Self {
        Path { trimmed: true, ..self }
    }

    /// Where it ends.
    pub fn end(&self) -> Spot {
        self.segments.last().map_or(self.start, Segment::end)
    }
}

/// The shape of a marker.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shape {
    /// A filled disc.
    Dot,
    /// A circle, which shows what is under it only around it.
    Ring,
    /// A filled square.
    Square,
    /// A filled square on its corner.
    Diamond,
    /// Two crossing strokes.
    Cross,
}

/// A mark at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Marker {
    /// Where.
    pub at: Spot,
    /// Its shape.
    pub shape: Shape,
    /// Half its width, in pixels.
    pub radius: f64,
    /// Its colour.
    pub ink: Ink,
    /// How far it is moved in the picture: pixels to the right and upwards.
    pub offset: [f64; 2],
}

impl Marker {
    /// A marker of usual size.
    pub fn new(at: Spot, shape: Shape, ink: Ink) -> Self {
        let radius = match shape {
            Shape::Dot | Shape::Square => 3.4,
            Shape::Ring | Shape::Cross => 4.2,
            Shape::Diamond => 5.0,
        };
        Marker { at, shape, radius, ink, offset: [0.0, 0.0] }
    }

    /// The same, moved by pixels to the right and upwards.
    pub fn moved(self, right: f64, up: f64) -> Self {
        Marker { offset: [right, up], ..self }
    }
}

/// A direction in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// To the right.
    East,
    /// To the right and upwards.
    NorthEast,
    /// Upwards.
    North,
    /// To the left and upwards.
    NorthWest,
    /// To the left.
    West,
    /// To the left and downwards.
    SouthWest,
    /// Downwards.
    South,
    /// To the right and downwards.
    SouthEast,
}

impl Direction {
    /// All directions, against the clock from the east.
    pub const ALL: [Direction; 8] = [
        Direction::East,
        Direction::NorthEast,
        Direction::North,
        Direction::NorthWest,
        Direction::West,
        Direction::SouthWest,
        Direction::South,
        Direction::SouthEast,
    ];

    /// The direction next to that of the vector (x, y), y upwards; north for the vector 0.
    ///
    /// ```
    /// use polarform::scene::Direction;
    /// assert_eq!(Direction::of(-3.0, -3.1), Direction::SouthWest);
    /// assert_eq!(Direction::of(0.0, 0.0), Direction::North);
    /// ```
    pub fn of(x: f64, y: f64) -> Self {
        let size = x.abs().max(y.abs());
        if !(size > 0.0 && size.is_finite()) {
            return Direction::North;
        }
        let (x, y) = (x / size, y / size);
        // the tangent of an eighth of a right angle, between two directions
        let limit = std::f64::consts::SQRT_2 - 1.0;
        let sign = |value: f64| if value.abs() <= limit { 0 } else { value.signum() as i8 };
        match (sign(x), sign(y)) {
            (1, 1) => Direction::NorthEast,
            (1, -1) => Direction::SouthEast,
            (1, _) => Direction::East,
            (-1, 1) => Direction::NorthWest,
            (-1, -1) => Direction::SouthWest,
            (-1, _) => Direction::West,
            (_, -1) => Direction::South,
            _ => Direction::North,
        }
    }

    /// Its signs to the right and upwards: north-west is (−1, 1).
    pub fn signs(self) -> (i8, i8) {
        match self {
            Direction::East => (1, 0),
            Direction::NorthEast => (1, 1),
            Direction::North => (0, 1),
            Direction::NorthWest => (-1, 1),
            Direction::West => (-1, 0),
            Direction::SouthWest => (-1, -1),
            Direction::South => (0, -1),
            Direction::SouthEast => (1, -1),
        }
    }

    /// How many eighths of a turn lie between two directions: 0 to 4.
    pub fn turn(self, other: Direction) -> usize {
        let difference = (self as usize).abs_diff(other as usize);
        difference.min(8 - difference)
    }
}

/// How a label stands to its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// Beside it, if there is room in this direction.
    Beside(Direction),
    /// Around it; such a label is never moved.
    Centre,
}

/// The size of a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Size {
    /// For names of points.
    Normal,
    /// For ticks and remarks.
    Small,
}

/// A formula or words at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// What it says.
    pub text: Text,
    /// Where.
    pub at: Spot,
    /// How it stands to its place.
    pub anchor: Anchor,
    /// Its size.
    pub size: Size,
    /// Its colour.
    pub ink: Ink,
    /// The distance in pixels that it keeps from its place.
    pub gap: f64,
}

impl Label {
    /// A label of usual size beside a place.
    pub fn beside(at: Spot, text: impl Into<Text>, direction: Direction) -> Self {
        Label {
            text: text.into(),
            at,
            anchor: Anchor::Beside(direction),
            size: Size::Normal,
            ink: Ink::Text,
            gap: 7.0,
        }
    }

    /// A label around a place.
    pub fn centred(at: Spot, text: impl Into<Text>) -> Self {
        Label { anchor: Anchor::Centre, gap: 0.0, ..Label::beside(at, text, Direction::North) }
    }

    /// The same in small.
    pub fn small(self) -> Self {
        Label { size: Size::Small, ..self }
    }

    /// The same in another colour.
    pub fn inked(self, ink: Ink) -> Self {
        Label { ink, ..self }
    }
}

/// Which way an axis runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Orientation {
    /// To the right.
    Horizontal,
    /// Upwards.
    Vertical,
}

/// A mark on an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// The coordinate along the axis.
    pub at: f64,
    /// What is written there, usually the exact number.
    pub label: Option<Text>,
}

/// An axis with an arrowhead, ticks and a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Which way it runs.
    pub orientation: Orientation,
    /// Its first place.
    pub from: Spot,
    /// How far it runs along its orientation, in the coordinates of the data.
    pub length: f64,
    /// Its ticks, ascending.
    pub ticks: Vec<Tick>,
    /// Its name.
    pub name: Option<Text>,
}

/// A line of the legend.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// What it says.
    pub text: Text,
    /// The line it explains, if any.
    pub style: Option<Style>,
    /// The marker it explains, if any.
    pub marker: Option<(Shape, Ink)>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions() {
        for (number, direction) in Direction::ALL.into_iter().enumerate() {
            let angle = number as f64 * std::f64::consts::FRAC_PI_4;
            for turn in [-0.39, 0.0, 0.39] {
                let (y, x) = (angle + turn).sin_cos();
                assert_eq!(Direction::of(1e9 * x, 1e9 * y), direction);
            }
            assert_eq!(direction.turn(Direction::ALL[(number + 3) % 8]), 3);
            assert_eq!(direction.turn(Direction::ALL[(number + 5) % 8]), 3);
        }
    }
}
