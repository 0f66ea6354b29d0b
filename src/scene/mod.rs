//! Pictures as data: what is drawn, where, and where the labels go; in no graphics language.
//!
//! **Definition.** A [`Scene`] is a row of panels; a [`Panel`] is a list of items (paths, markers,
//! labels, axes) in the coordinates of the data, with a legend. Looks are given by roles
//! ([`Ink`]), sizes in pixels of 1/96 inch. [`layout()`] turns a scene into marks on a page: it
//! chooses the scale, puts each movable label where it covers nothing, and needs to know only
//! how large a text is, which the caller says. [`pictures`] makes whole scenes from control
//! points, knots and polynomials; [`crate::figure`] writes them as SVG, TikZ or text.
//!
//! **Invariants.** Exact numbers become floating-point numbers in one place ([`Spot::exact`]),
//! which refuses what does not fit; so everything in a scene is finite, and drawing it cannot
//! fail. What is exact stays exact as long as possible: hulls, subdivision of control points,
//! ticks and continuity are computed with rationals. Everything is deterministic.
//!
//! ```
//! use polarform::scene::{Ink, Marker, Scene, Shape, Spot};
//! let mut scene = Scene::new("One point");
//! scene.add(Marker::new(Spot::new(0.0, 1.0)?, Shape::Dot, Ink::Accent));
//! assert_eq!(scene.panels().len(), 1);
//! # Ok::<(), polarform::scene::SceneError>(())
//! ```
//!
//! **Reference.** Placing labels greedily and then improving one at a time: Christensen, Marks,
//! Shieber, "An empirical study of algorithms for point-feature label placement", ACM Trans.
//! Graph. 14 (1995). Palette by roles: Okabe and Ito, "Color universal design" (2008).

mod item;
mod layout;
mod obstacles;
mod page;
pub mod pictures;
mod place;
mod sample;
mod spot;
mod style;
mod ticks;

pub use item::{
    Anchor, Axis, Direction, Entry, Item, Label, Marker, Orientation, Path, Segment, Shape, Size, Text, Tick,
};
pub use layout::layout;
#[cfg(feature = "figure")]
pub(crate) use page::trace;
pub use page::{Extent, Layout, Mark, Placed, Rect, Stroke};
pub use sample::{bezier_path, rational_bezier_path};
pub use spot::{SceneError, Spot};
pub use style::{Dash, Ink, Style};
pub use ticks::{exact_text, nice_ticks};

impl From<Path> for Item {
    fn from(path: Path) -> Self {
        Item::Path(path)
    }
}

impl From<Marker> for Item {
    fn from(marker: Marker) -> Self {
        Item::Marker(marker)
    }
}

impl From<Label> for Item {
    fn from(label: Label) -> Self {
        Item::Label(label)
    }
}

impl From<Axis> for Item {
    fn from(axis: Axis) -> Self {
        Item::Axis(axis)
    }
}

/// How the two coordinates are scaled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Aspect {
    /// Both alike: shapes keep their shape.
    Equal,
    /// Each by itself, to fill the width and this height in pixels: graphs of functions.
    Free {
        /// The height wanted.
        height: f64,
    },
}

/// One of the pictures that a scene shows side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// How coordinates are scaled.
    pub aspect: Aspect,
    /// What is drawn, the first item at the bottom.
    pub items: Vec<Item>,
    /// Explanations below the picture.
    pub legend: Vec<Entry>,
    /// Words below everything.
    pub caption: Option<Text>,
}

/// A drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    title: String,
    /// The title in other languages, by their codes.
    titles: Vec<(&'static str, String)>,
    description: String,
    width: f64,
    panels: Vec<Panel>,
}

impl Scene {
    /// The width of a drawing if nothing else is said, in pixels.
    pub const WIDTH: f64 = 560.0;

    /// An empty scene with one panel whose coordinates are scaled alike.
    ///
    /// The title is for those who cannot see the drawing, and for tooltips.
    pub fn new(title: impl Into<String>) -> Self {
        let panel = Panel { aspect: Aspect::Equal, items: Vec::new(), legend: Vec::new(), caption: None };
        Scene {
            title: title.into(),
            titles: Vec::new(),
            description: String::new(),
            width: Scene::WIDTH,
            panels: vec![panel],
        }
    }

    /// The same with other scaling, in all panels.
    pub fn with_aspect(mut self, aspect: Aspect) -> Self {
        self.panels.iter_mut().for_each(|panel| panel.aspect = aspect);
        self
    }

    /// The same, this many pixels wide; 80 at least and 10 000 at most. A drawing gets narrower
    /// when its shape requires it, and wider when fixed labels would cover each other.
    pub fn with_width(mut self, width: f64) -> Self {
        self.width = if width.is_nan() { Scene::WIDTH } else { width.clamp(80.0, 10_000.0) };
        self
    }

    /// The same with another title, in all languages.
    pub fn with_title(mut self, title: impl Into<String>) -> Self {
        self.title = title.into();
        self.titles.clear();
        self
    }

    /// The same with its title in one more language.
    pub fn also(mut self, language: &'static str, title: impl Into<String>) -> Self {
        self.titles.push((language, title.into()));
        self
    }

    /// The same with its title in a language, if it is known in it.
    ///
    /// ```
    /// use polarform::scene::Scene;
    /// let scene = Scene::new("Spline curve").also("zh", "样条曲线");
    /// assert_eq!(scene.clone().in_language("zh").title(), "样条曲线");
    /// assert_eq!(scene.in_language("en").title(), "Spline curve");
    /// ```
    pub fn in_language(mut self, language: &str) -> Self {
        if let Some((_, title)) = self.titles.iter().find(|(code, _)| *code == language) {
            self.title.clone_from(title);
        }
        self
    }

    /// The same with a description for those who cannot see the drawing.
    pub fn with_description(mut self, description: impl Into<String>) -> Self {
        self.description = description.into();
        self
    }

    /// The same with words below the (last) panel.
    pub fn with_caption(mut self, caption: impl Into<Text>) -> Self {
        if let Some(panel) = self.panels.last_mut() {
            panel.caption = Some(caption.into());
        }
        self
    }

    /// Adds an item on top of what is in the last panel.
    pub fn add(&mut self, item: impl Into<Item>) {
        if let Some(panel) = self.panels.last_mut() {
            panel.items.push(item.into());
        }
    }

    /// Adds items below what is in the last panel.
    pub(crate) fn add_below(&mut self, items: Vec<Item>) {
        if let Some(panel) = self.panels.last_mut() {
            panel.items.splice(0..0, items);
        }
    }

    /// The same without legends and captions.
    #[cfg(feature = "figure")]
    pub(crate) fn without_words_below(mut self) -> Self {
        for panel in &mut self.panels {
            panel.legend.clear();
            panel.caption = None;
        }
        self
    }

    /// Adds an entry to the legend of the last panel.
    pub fn explain(&mut self, entry: Entry) {
        if let Some(panel) = self.panels.last_mut() {
            panel.legend.push(entry);
        }
    }

    /// Both drawings side by side, this one on the left, as wide as the wider one.
    ///
    /// ```
    /// use polarform::scene::Scene;
    /// let both = Scene::new("a curve").beside(Scene::new("its derivative"));
    /// assert_eq!((both.title(), both.panels().len()), ("a curve; its derivative", 2));
    /// ```
    pub fn beside(mut self, right: Scene) -> Self {
        let join = |first: &mut String, second: String| {
            if !second.is_empty() && *first != second {
                first.push_str(if first.is_empty() { "" } else { "; " });
                first.push_str(&second);
            }
        };
        // In another language, too, where both are known in it.
        let other =
            |code: &str| right.titles.iter().find(|(other, _)| *other == code).map(|(_, title)| title);
        self.titles.retain_mut(|(code, title)| other(code).map(|other| join(title, other.clone())).is_some());
        join(&mut self.title, right.title);
        join(&mut self.description, right.description);
        self.width = self.width.max(right.width);
        self.panels.extend(right.panels);
        self
    }

    /// What it shows, in a few words.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// What it shows, in a sentence or two.
    pub fn description(&self) -> &str {
        &self.description
    }

    /// The width wanted, in pixels.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// The pictures side by side; at least one.
    pub fn panels(&self) -> &[Panel] {
        &self.panels
    }
}
