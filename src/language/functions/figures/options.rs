//! What all figures can be told, and how a picture becomes a value.

use std::sync::Arc;

use crate::formula::source::Span;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::ops::errors::wrong_kind;
use crate::language::value::Value;
use crate::scene::{Scene, SceneError};

type Result<T> = std::result::Result<T, Diagnostic>;

/// Arguments of every figure.
const COMMON: [&str; 3] = ["width", "title", "caption"];

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

/// Checks the arguments of a figure: its own names and those of every figure.
pub(super) fn expect(
    args: &Arguments,
    signature: &str,
    count: std::ops::RangeInclusive<usize>,
    own: &[&str],
) -> Result<()> {
    let names: Vec<&str> = own.iter().copied().chain(COMMON).collect();
    args.expect(signature, count, &names)
}

/// The value of `labels=…`, which must be among those allowed.
pub(super) fn labels(args: &Arguments, allowed: &[Labels]) -> Result<Option<Labels>> {
    let Some((value, span)) = args.named_or("labels", usize::MAX) else { return Ok(None) };
    let allowed = || Labels::WORDS.iter().filter(|(_, labels)| allowed.contains(labels));
    let word = word(value);
    if let Some((_, labels)) = allowed().find(|(name, _)| word == Some(*name)) {
        return Ok(Some(*labels));
    }
    let names: Vec<&str> = allowed().map(|(name, _)| *name).collect();
    let (last, rest) = names
        .split_last()
        .map_or(("", ""), |(last, rest)| (*last, if rest.is_empty() { "" } else { " or " }));
    let list = format!("{}{rest}{last}", names[..names.len().saturating_sub(1)].join(", "));
    let found = word.map_or_else(|| value.kind().to_owned(), |word| format!("'{word}'"));
    Err(Diagnostic::error(Code::Domain, format!("labels are {list} here, not {found}"))
        .at(span)
        .hint(format!("for example labels={last}")))
}

/// A word as an argument: a text or the bare name of a function.
pub(super) fn word(value: &Value) -> Option<&str> {
    match value {
        Value::Text(word) => Some(word),
        Value::Builtin(word) => Some(word),
        _ => None,
    }
}

/// The value of `name=1` or `name=0`.
pub(super) fn flag(args: &Arguments, name: &str, default: bool) -> Result<bool> {
    match args.named_or(name, usize::MAX) {
        None => Ok(default),
        Some((value, span)) => match value.as_int() {
            Some(0) => Ok(false),
            Some(1) => Ok(true),
            _ => Err(wrong_kind("0 or 1", value).at(span).hint(format!("{name}=1 or {name}=0"))),
        },
    }
}

/// The scene as a value, with the width, title and caption that were asked for.
pub(super) fn finished(args: &Arguments, mut scene: Scene) -> Result<Value> {
    if let Some((value, span)) = args.named_or("width", usize::MAX) {
        let width = value.as_int().filter(|width| (80..=10_000).contains(width)).ok_or_else(|| {
            Diagnostic::error(Code::Domain, "the width of a figure is 80 to 10000 pixels")
                .at(span)
                .hint("the usual width is 560")
        })?;
        scene = scene.with_width(width as f64);
    }
    let words = |name: &str| match args.named_or(name, usize::MAX) {
        None => Ok(None),
        Some((Value::Text(words), _)) => Ok(Some(words.clone())),
        Some((other, span)) => {
            Err(wrong_kind("words", other).at(span).hint(format!("in quotation marks: {name}=\"A curve\"")))
        }
    };
    if let Some(title) = words("title")? {
        scene = scene.with_title(title);
    }
    if let Some(caption) = words("caption")? {
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
