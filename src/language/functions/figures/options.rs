//! What all figures can be told, and how a picture becomes a value.

use crate::language::eval::Arguments;
use std::sync::Arc;

use crate::formula::source::Span;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::functions::notions::chosen;
use crate::language::functions::parameter::{Parameter, named};
use crate::language::ops::takes::Takes;
use crate::language::value::Value;
use crate::scene::{Scene, SceneError};

type Result<T> = std::result::Result<T, Diagnostic>;

/// What every figure can be told.
pub(super) const COMMON: &[Parameter] = &[
    named("width=560", Takes::Size, "560, more for two pictures", "the width in pixels, 80 to 10000"),
    named("title=\"...\"", Takes::Text, "what is drawn", "the title, read to those who do not see it"),
    named("caption=\"...\"", Takes::Text, "none", "the words below the picture"),
];

/// The words for labels of curves and surfaces.
pub(super) const LABELS: &[&str] = &["polar", "points", "none"];

/// The words for labels of graphs.
pub(super) const GRAPH_LABELS: &[&str] = &["points", "none"];

pub(super) const POLYGON: Parameter =
    named("polygon=0", Takes::Flag, "1", "whether the control polygon or net is drawn");

/// `labels=…`
pub(super) const fn label_words(
    form: &'static str,
    words: &'static [&'static str],
    default: &'static str,
) -> Parameter {
    named(form, Takes::Word(words), default, "what is written at the points")
}

/// What is written at points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Labels {
    /// Values of the polar form: f(0, 0, 1).
    Polar,
    /// Names: b_1.
    Points,
    /// Coordinates, as far as there are such labels.
    Values,
    /// Nothing.
    None,
}

impl Labels {
    const WORDS: [(&'static str, Labels); 4] = [
        ("polar", Labels::Polar),
        ("points", Labels::Points),
        ("values", Labels::Values),
        ("none", Labels::None),
    ];
}

/// The value of `labels=…`.
pub(super) fn labels(args: &Arguments) -> Result<Option<Labels>> {
    args.named("labels").map(|given| chosen(Some(given), &Labels::WORDS)).transpose()
}

/// The scene as a value, with the width, title and caption that were asked for.
pub(super) fn finished(args: &Arguments, mut scene: Scene) -> Result<Value> {
    if let Some((value, span)) = args.named("width") {
        let width = value.as_int().filter(|width| (80..=10_000).contains(width)).ok_or_else(|| {
            Diagnostic::error(Code::Domain, "the width of a figure is 80 to 10000 pixels")
                .at(span)
                .hint("the usual width is 560")
        })?;
        scene = scene.with_width(width as f64);
    }
    let words = |name: &str| match args.named(name) {
        Some((Value::Text(words), _)) => Some(words.clone()),
        _ => None,
    };
    if let Some(title) = words("title") {
        scene = scene.with_title(title);
    }
    if let Some(caption) = words("caption") {
        scene = scene.with_caption(caption.as_str());
    }
    Ok(Value::Figure(Arc::new(scene)))
}

/// The scene, or what is wrong with its data, at their place.
pub(super) fn drawn<T>(result: std::result::Result<T, SceneError>, span: Span) -> Result<T> {
    result.map_err(|error| {
        let message = error.to_string();
        let (code, hint) = match error {
            SceneError::TooLarge { .. } => (Code::Undrawable, "draw the curve divided by a large number"),
            SceneError::AtInfinity { .. } => {
                (Code::Undrawable, "draw a part of the curve, or another interval, where the weight is not 0")
            }
            SceneError::Empty { .. } => (Code::ControlPoints, "give at least one point"),
            SceneError::Shape { .. } => (Code::ControlPoints, "check the number of points"),
            SceneError::Interval { .. } => (Code::Coincident, "the first end has to be less than the second"),
        };
        Diagnostic::error(code, message).at(span).hint(hint)
    })
}
