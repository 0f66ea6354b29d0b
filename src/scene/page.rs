//! A scene laid out: marks on a page, in pixels from its upper left corner, y downwards.

use super::{Ink, Shape, Size, Style, Text};

/// A place on the page: pixels to the right and downwards.
pub(super) type Pixel = [f64; 2];

impl Size {
    /// The height of the letters (one em) in pixels.
    pub fn em(self) -> f64 {
        match self {
            Size::Normal => 16.0,
            Size::Small => 13.0,
        }
    }
}

/// How large a text is, in pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extent {
    /// Its width.
    pub width: f64,
    /// How far it reaches above the line it stands on.
    pub ascent: f64,
    /// How far it reaches below.
    pub descent: f64,
}

impl Extent {
    pub(super) fn height(&self) -> f64 {
        self.ascent + self.descent
    }
}

/// An upright rectangle on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// The upper left corner.
    pub low: [f64; 2],
    /// The lower right corner.
    pub high: [f64; 2],
}

impl Rect {
    /// What contains nothing yet.
    pub(super) const EMPTY: Rect =
        Rect { low: [f64::INFINITY, f64::INFINITY], high: [f64::NEG_INFINITY, f64::NEG_INFINITY] };

    pub(super) fn around([x, y]: Pixel, radius: f64) -> Self {
        Rect { low: [x - radius, y - radius], high: [x + radius, y + radius] }
    }

    /// Its width.
    pub fn width(&self) -> f64 {
        self.high[0] - self.low[0]
    }

    /// Its height.
    pub fn height(&self) -> f64 {
        self.high[1] - self.low[1]
    }

    pub(super) fn grown(&self, by: f64) -> Self {
        Rect { low: [self.low[0] - by, self.low[1] - by], high: [self.high[0] + by, self.high[1] + by] }
    }

    pub(super) fn add(&mut self, other: &Rect) {
        for k in 0..2 {
            self.low[k] = self.low[k].min(other.low[k]);
            self.high[k] = self.high[k].max(other.high[k]);
        }
    }

    pub(super) fn contains(&self, [x, y]: Pixel) -> bool {
        self.low[0] <= x && x <= self.high[0] && self.low[1] <= y && y <= self.high[1]
    }

    /// The area common to both.
    pub fn overlap(&self, other: &Rect) -> f64 {
        let side = |k: usize| self.high[k].min(other.high[k]) - self.low[k].max(other.low[k]);
        side(0).max(0.0) * side(1).max(0.0)
    }

    /// The part of the line from `a` to `b` inside: two parameters in [0, 1]
    /// (Liang and Barsky, 1984).
    pub(super) fn clip(&self, a: Pixel, b: Pixel) -> Option<(f64, f64)> {
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        for k in 0..2 {
            let step = b[k] - a[k];
            if step == 0.0 {
                if a[k] < self.low[k] || a[k] > self.high[k] {
                    return None;
                }
                continue;
            }
            let (enter, leave) = ((self.low[k] - a[k]) / step, (self.high[k] - a[k]) / step);
            first = first.max(enter.min(leave));
            last = last.min(enter.max(leave));
        }
        (first <= last).then_some((first, last))
    }
}

/// The next piece of a path on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stroke {
    /// A straight line to this place.
    Line([f64; 2]),
    /// A cubic Bézier curve by its last three control points.
    Cubic([[f64; 2]; 3]),
}

impl Stroke {
    /// Where it ends.
    pub fn end(&self) -> [f64; 2] {
        match self {
            Stroke::Line(end) | Stroke::Cubic([_, _, end]) => *end,
        }
    }
}

/// A text on the page.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// What it says.
    pub text: Text,
    /// The space reserved for it.
    pub area: Rect,
    /// The height of the line it stands on.
    pub baseline: f64,
    /// Which of its sides stays where it is when a font is wider or narrower than expected: the
    /// left (−1), the middle (0), the right (1); and the upper (−1), the middle, the lower (1).
    pub fixed: (i8, i8),
    /// Its size.
    pub size: Size,
    /// Its colour.
    pub ink: Ink,
}

/// Something on the page.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// Lines and curves.
    Path {
        /// Where they begin.
        start: [f64; 2],
        /// The pieces.
        strokes: Vec<Stroke>,
        /// Whether the path is closed.
        closed: bool,
        /// How it is drawn.
        style: Style,
        /// Whether it ends in an arrowhead.
        arrow: bool,
    },
    /// A marker.
    Marker {
        /// Where.
        at: [f64; 2],
        /// Its shape.
        shape: Shape,
        /// Half its width.
        radius: f64,
        /// Its colour.
        ink: Ink,
    },
    /// A text.
    Text(Placed),
}

impl Mark {
    /// The space it takes, with half the width of its lines.
    pub fn area(&self) -> Rect {
        match self {
            Mark::Path { start, strokes, style, .. } => {
                let mut area = Rect::around(*start, 0.0);
                trace(*start, strokes, &mut |_, to| area.add(&Rect::around(to, 0.0)));
                area.grown(style.width / 2.0)
            }
            Mark::Marker { at, radius, .. } => Rect::around(*at, radius + 1.0),
            Mark::Text(text) => text.area,
        }
    }

    pub(super) fn shift(&mut self, by: Pixel) {
        let shift = |place: &mut Pixel| {
            place[0] = hundredths(place[0] + by[0]);
            place[1] = hundredths(place[1] + by[1]);
        };
        match self {
            Mark::Path { start, strokes, .. } => {
                shift(start);
                for stroke in strokes {
                    match stroke {
                        Stroke::Line(to) => shift(to),
                        Stroke::Cubic(points) => points.iter_mut().for_each(shift),
                    }
                }
            }
            Mark::Marker { at, .. } => shift(at),
            Mark::Text(text) => {
                shift(&mut text.area.low);
                shift(&mut text.area.high);
                text.baseline = hundredths(text.baseline + by[1]);
            }
        }
    }
}

/// Calls `visit` with the ends of short straight pieces that follow the strokes.
pub(crate) fn trace(start: Pixel, strokes: &[Stroke], visit: &mut dyn FnMut(Pixel, Pixel)) {
    let mut from = start;
    for stroke in strokes {
        match stroke {
            Stroke::Line(to) => visit(from, *to),
            Stroke::Cubic([b, c, d]) => {
                let length: f64 = [(from, *b), (*b, *c), (*c, *d)]
                    .iter()
                    .map(|(p, q)| (p[0] - q[0]).hypot(p[1] - q[1]))
                    .sum();
                let pieces = (length / 12.0).ceil().clamp(1.0, 40.0) as u32;
                let mut last = from;
                for k in 1..=pieces {
                    let t = f64::from(k) / f64::from(pieces);
                    let s = 1.0 - t;
                    let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
                    let next = std::array::from_fn(|k| {
                        weights[0] * from[k] + weights[1] * b[k] + weights[2] * c[k] + weights[3] * d[k]
                    });
                    visit(last, next);
                    last = next;
                }
            }
        }
        from = stroke.end();
    }
}

/// Rounded to hundredths of a pixel: everything on a page is.
pub(super) fn hundredths(value: f64) -> f64 {
    // no negative zero
    (value * 100.0).round() / 100.0 + 0.0
}

/// A drawing as marks on a page.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// The width of the page in pixels.
    pub width: f64,
    /// Its height.
    pub height: f64,
    /// What is on it, the first mark at the bottom.
    pub marks: Vec<Mark>,
    /// How many labels were left out because there was no room for them.
    pub hidden: usize,
}

impl Layout {
    /// The texts on the page.
    pub fn texts(&self) -> impl Iterator<Item = &Placed> {
        self.marks.iter().filter_map(|mark| match mark {
            Mark::Text(text) => Some(text),
            _ => None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clipping() {
        let unit = Rect { low: [0.0, 0.0], high: [1.0, 1.0] };
        assert_eq!(unit.clip([-1.0, 0.5], [3.0, 0.5]), Some((0.25, 0.5)));
        assert_eq!(unit.clip([-1.0, 2.0], [3.0, 2.0]), None);
        assert_eq!(unit.clip([0.5, 0.5], [0.5, 0.5]), Some((0.0, 1.0)));
        assert_eq!(unit.clip([2.0, 0.0], [3.0, 1.0]), None);
    }
}
