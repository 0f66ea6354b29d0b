//! How things look, by the part they play: no colour is named here.

/// The part something plays; the renderers have a colour for each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Ink {
    /// Words, axes: the colour of the text around the figure.
    Text,
    /// What guides the eye: control polygons, grids.
    Guide,
    /// What the picture is about: the final point, a join.
    Accent,
    /// The curve (function, surface) of this number; numbers beyond the palette begin it anew.
    Series(usize),
}

/// Whether a line is interrupted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Dash {
    /// In one stroke.
    #[default]
    Solid,
    /// Long dashes.
    Dashed,
}

/// How a path is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// The line, if there is one.
    pub stroke: Option<Ink>,
    /// Its width in pixels.
    pub width: f64,
    /// Its dashes.
    pub dash: Dash,
    /// What the path encloses, if that is filled.
    pub fill: Option<Ink>,
    /// The opacity of the filling, from 0 to 1.
    pub opacity: f64,
}

impl Style {
    /// A line.
    pub fn line(ink: Ink, width: f64) -> Self {
        Style { stroke: Some(ink), width, dash: Dash::Solid, fill: None, opacity: 1.0 }
    }

    /// The curve of this number.
    pub fn curve(number: usize) -> Self {
        Style::line(Ink::Series(number), 2.4)
    }

    /// A thin line that guides the eye.
    pub fn guide() -> Self {
        Style::line(Ink::Guide, 1.1)
    }

    /// A filling without an outline.
    pub fn fill(ink: Ink, opacity: f64) -> Self {
        Style { stroke: None, width: 0.0, dash: Dash::Solid, fill: Some(ink), opacity }
    }

    /// The same with other dashes.
    pub fn dashed(self, dash: Dash) -> Self {
        Style { dash, ..self }
    }
}
