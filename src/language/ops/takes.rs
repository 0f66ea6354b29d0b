//! What an argument of a function has to be: in words, for a value, and in the error for any other one.

use std::borrow::Cow;

use super::errors::wrong_kind;
use super::formula::symbol_of;
use super::geometry::{is_point, is_points};
use crate::language::diagnostic::{Code, Diagnostic, nearest};
use crate::language::value::Value;
use crate::math::number::Rational;

/// What an argument has to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Takes {
    /// 0, 1, 2, …
    Size,
    /// …, −1, 0, 1, …
    Integer,
    /// A rational number.
    Number,
    /// A number or formula.
    Scalar,
    /// A formula, or a function of the caller's.
    Formula,
    /// An argument of a polar form: a number, a formula or a vector such as hat(1).
    Argument,
    /// A list of numbers or formulas.
    Scalars,
    /// One number or formula, or a list of them.
    ScalarOrList,
    /// A symbol such as t.
    Variable,
    /// A list of symbols.
    Variables,
    /// A formula, a function of one formula or a polar form.
    Polynomial,
    /// Polynomials, one for each coordinate.
    Coordinates,
    /// What can be differentiated and composed: formulas, functions, polar forms.
    Function,
    /// A function such as i -> i^2.
    Mapping,
    /// A polar form.
    Polar,
    /// A Bézier curve, or what can be read as one.
    Curve,
    /// A spline, or what can be read as one.
    Spline,
    /// A curve or surface.
    Geometry,
    /// A surface.
    Surface,
    /// A piecewise polynomial.
    Piecewise,
    /// Coordinates.
    Point,
    /// A list of points, or of numbers.
    Points,
    /// A list of lists of points, or of numbers.
    Net,
    /// Rows of numbers or formulas.
    Rows,
    /// Two ends.
    Interval,
    /// Three points of the plane.
    Triangle,
    /// A matrix.
    Matrix,
    /// Equations.
    Equations,
    /// A list of anything.
    List,
    /// A picture.
    Figure,
    /// 1 or 0.
    Flag,
    /// Words in quotation marks.
    Text,
    /// One of these words.
    Word(&'static [&'static str]),
    /// A word with numbers, alone or first in a list.
    Named(&'static Notion),
    /// This number.
    Exactly(i64),
    /// What one of these is.
    OneOf(&'static [Takes]),
    /// Anything: the function says what it can use.
    Any,
}

/// Things that have names, some of them with numbers: bases, subdivision schemes.
#[derive(Debug, PartialEq, Eq)]
pub struct Notion {
    /// What each of them is.
    pub what: &'static str,
    /// How they are written: `power`, `[bernstein, a, b]`.
    pub forms: &'static [&'static str],
    /// What stands for one without a name: a mask.
    pub unnamed: Option<&'static str>,
}

impl Notion {
    /// All ways to write one of them: power, bernstein or [bernstein, a, b].
    pub fn ways(&self) -> String {
        alternatives(&self.all_ways().collect::<Vec<_>>())
    }

    /// The name in a way to write one of them.
    pub(crate) fn name(form: &str) -> &str {
        form.trim_start_matches('[').split([',', ']']).next().unwrap_or_default()
    }

    fn names(&self) -> impl Iterator<Item = &'static str> {
        self.forms.iter().map(|form| Notion::name(form))
    }

    fn all_ways(&self) -> impl Iterator<Item = &'static str> {
        self.forms.iter().copied().chain(self.unnamed)
    }
}

/// A word as an argument: a text, or the bare name of a function.
pub(crate) fn word_of(value: &Value) -> Option<&str> {
    match value {
        Value::Text(word) => Some(word),
        Value::Builtin(word) => Some(word),
        _ => None,
    }
}

/// a, b or c
pub(crate) fn alternatives(words: &[&str]) -> String {
    match words {
        [rest @ .., last] if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        words => words.concat(),
    }
}

fn all(value: &Value, item: impl Fn(&Value) -> bool) -> bool {
    matches!(value, Value::List(items) if items.iter().all(item))
}

fn is_scalar(value: &Value) -> bool {
    matches!(value, Value::Scalar(_))
}

fn is_polynomial(value: &Value) -> bool {
    matches!(value, Value::Scalar(_) | Value::Function(_) | Value::Polar(_))
}

fn is_curve(value: &Value) -> bool {
    matches!(value, Value::Piecewise(_))
        || matches!(value, Value::Geometry(geometry) if !geometry.is_surface())
}

fn is_row(value: &Value) -> bool {
    matches!(value, Value::List(_))
}

impl Takes {
    /// The words that mean something here.
    pub fn words(self) -> Vec<&'static str> {
        match self {
            Takes::Word(words) => words.to_vec(),
            Takes::Named(notion) => notion.names().collect(),
            Takes::OneOf(kinds) => kinds.iter().flat_map(|kind| kind.words()).collect(),
            _ => Vec::new(),
        }
    }

    /// Whether a word means something here.
    pub fn has_word(self, word: &str) -> bool {
        match self {
            Takes::Word(words) => words.contains(&word),
            Takes::Named(notion) => notion.names().any(|name| name == word),
            Takes::OneOf(kinds) => kinds.iter().any(|kind| kind.has_word(word)),
            _ => false,
        }
    }

    /// Whether a formula is expected.
    pub(crate) fn is_formula(self) -> bool {
        matches!(self, Takes::Scalar | Takes::Formula | Takes::Polynomial | Takes::Function)
    }

    /// Whether a curve may be given, also by its coordinates.
    pub(crate) fn is_of_curves(self) -> bool {
        match self {
            Takes::Curve | Takes::Coordinates => true,
            Takes::OneOf(kinds) => kinds.iter().any(|kind| kind.is_of_curves()),
            _ => false,
        }
    }

    /// What is expected, in words.
    pub fn description(self) -> Cow<'static, str> {
        Cow::Borrowed(match self {
            Takes::Size => "an integer that is 0 or more",
            Takes::Integer => "an integer",
            Takes::Number => "a number",
            Takes::Scalar => "a number or formula",
            Takes::Formula => "a formula or function",
            Takes::Argument => "a number, formula or vector argument",
            Takes::Scalars => "a list of numbers or formulas",
            Takes::ScalarOrList => "a number or formula, or a list of them",
            Takes::Variable => "a variable",
            Takes::Variables => "a list of variables",
            Takes::Polynomial => "a polynomial in one variable",
            Takes::Coordinates => "a polynomial, or a list of them",
            Takes::Function => "a function or formula",
            Takes::Mapping => "a function such as i -> i^2",
            Takes::Polar => "a polar form",
            Takes::Curve => "a Bézier curve",
            Takes::Spline => "a spline",
            Takes::Geometry => "a curve or surface",
            Takes::Surface => "a surface",
            Takes::Piecewise => "a piecewise polynomial",
            Takes::Point => "a point",
            Takes::Points => "a list of points or numbers",
            Takes::Net => "rows of points or numbers",
            Takes::Rows => "rows of numbers",
            Takes::Interval => "an interval [a, b]",
            Takes::Triangle => "three points of the plane",
            Takes::Matrix => "a matrix",
            Takes::Equations => "equations",
            Takes::List => "a list",
            Takes::Figure => "a figure",
            Takes::Flag => "1 or 0",
            Takes::Text => "words in quotation marks",
            Takes::Word(words) => return Cow::Owned(alternatives(words)),
            Takes::Exactly(number) => return Cow::Owned(number.to_string()),
            Takes::Named(notion) => return Cow::Owned(notion.ways()),
            Takes::OneOf(_) => {
                let mut ways: Vec<Cow<'static, str>> = Vec::new();
                for way in self.ways() {
                    if !ways.contains(&way) {
                        ways.push(way);
                    }
                }
                let ways: Vec<&str> = ways.iter().map(AsRef::as_ref).collect();
                return Cow::Owned(alternatives(&ways));
            }
            Takes::Any => "any value",
        })
    }

    /// All that may be written, word by word where words are meant.
    fn ways(self) -> Vec<Cow<'static, str>> {
        match self {
            Takes::Word(words) => words.iter().map(|word| Cow::Borrowed(*word)).collect(),
            Takes::Named(notion) => notion.all_ways().map(Cow::Borrowed).collect(),
            Takes::OneOf(kinds) => kinds.iter().flat_map(|kind| kind.ways()).collect(),
            other => vec![other.description()],
        }
    }

    /// Whether a value is of this kind. What it says in detail, such as the number of points in a
    /// list, is for the function. Cost: that of looking at each item.
    pub fn accepts(self, value: &Value) -> bool {
        match self {
            Takes::Size => value.as_rational().is_some_and(|q| is_natural(&q)),
            Takes::Integer => value.as_rational().is_some_and(|q| q.is_integer()),
            Takes::Number => value.as_rational().is_some(),
            Takes::Scalar => is_scalar(value),
            Takes::Formula => matches!(value, Value::Scalar(_) | Value::Function(_)),
            Takes::Argument => matches!(value, Value::Scalar(_) | Value::Vector(_)),
            Takes::Scalars | Takes::Interval => all(value, is_scalar),
            Takes::ScalarOrList => is_scalar(value) || all(value, is_scalar),
            Takes::Variable => symbol_of(value).is_some(),
            Takes::Variables => all(value, |item| symbol_of(item).is_some()),
            Takes::Polynomial | Takes::Function => is_polynomial(value),
            Takes::Coordinates => is_polynomial(value) || is_row(value),
            Takes::Mapping => matches!(value, Value::Function(_)),
            Takes::Polar => matches!(value, Value::Polar(_) | Value::Function(_)),
            Takes::Curve => is_curve(value) || is_polynomial(value) || points_or_coordinates(value),
            Takes::Spline => is_curve(value) || all(value, |item| matches!(item, Value::Piecewise(_))),
            Takes::Geometry => matches!(value, Value::Geometry(_) | Value::Piecewise(_)),
            Takes::Surface => matches!(value, Value::Geometry(geometry) if geometry.is_surface()),
            Takes::Piecewise => matches!(value, Value::Piecewise(_)),
            Takes::Point => is_point(value),
            // How many there have to be says the function.
            Takes::Points => is_points(value) || all(value, |_| false),
            Takes::Triangle => is_points(value),
            Takes::Net => all(value, is_points) || matches!(value, Value::Matrix(_)),
            Takes::Rows => all(value, is_row) || matches!(value, Value::Matrix(_)),
            Takes::Matrix => matches!(value, Value::Matrix(_)) || all(value, |row| all(row, is_scalar)),
            Takes::Equations => matches!(value, Value::Claim(_)),
            Takes::List => is_row(value),
            Takes::Figure => matches!(value, Value::Figure(_)),
            Takes::Flag => matches!(value.as_int(), Some(0 | 1)),
            Takes::Text => matches!(value, Value::Text(_)),
            Takes::Word(words) => word_of(value).is_some_and(|word| words.contains(&word)),
            Takes::Exactly(number) => value.as_int() == Some(number),
            Takes::Named(notion) => notion.accepts(value),
            Takes::OneOf(kinds) => kinds.iter().any(|kind| kind.accepts(value)),
            Takes::Any => true,
        }
    }

    /// The error for a value of another kind, with what can be written instead.
    pub(crate) fn refuses(self, value: &Value) -> Diagnostic {
        let word =
            word_of(value).map(str::to_owned).or_else(|| symbol_of(value).map(|name| name.to_string()));
        let error = match (self, value) {
            (Takes::Size | Takes::Integer, _) if value.as_rational().is_some() => {
                Diagnostic::error(Code::Domain, format!("expected {}", self.description()))
            }
            (Takes::Points, Value::List(items)) if !items.is_empty() => {
                Diagnostic::error(Code::Type, "these are not all points with as many coordinates")
                    .reason("numbers and points side by side, or something else among them")
            }
            (Takes::Scalars, Value::List(items)) => {
                let other = items.iter().find(|item| !is_scalar(item)).unwrap_or(value);
                wrong_kind(&self.description(), other)
            }
            (Takes::Word(_), _) if word.is_some() => {
                let word = word.as_deref().unwrap_or_default();
                Diagnostic::error(Code::Domain, format!("expected {}, not '{word}'", self.description()))
            }
            (Takes::Named(notion), _) => wrong_kind(notion.what, value),
            _ => wrong_kind(&self.description(), value),
        };
        let near = word.and_then(|word| nearest(&word, self.words()));
        match (near, self.example()) {
            (Some(best), _) => error.hint(format!("did you mean '{best}'?")),
            (None, Some(example)) => error.hint(example),
            (None, None) => error,
        }
    }

    /// What can be written, where a word about it is not enough.
    fn example(self) -> Option<String> {
        Some(match self {
            Takes::Scalars => "such as [0, 1/2, 1]".to_owned(),
            Takes::Variables => "such as [u, v]".to_owned(),
            Takes::Polar => "polar(F) is the polar form of a polynomial".to_owned(),
            Takes::Curve | Takes::Geometry => "bezier([[0, 0], [1, 2], [2, 0]]) makes one".to_owned(),
            Takes::Spline => "bspline(2, [0, 0, 0, 1, 2, 2, 2], [1, 3, 2, 4]) makes one".to_owned(),
            Takes::Surface => "patch([[0, 1], [2, 5]]) makes one".to_owned(),
            Takes::Piecewise => "bspline_basis(1, [0, 1, 2], 0) is one".to_owned(),
            Takes::Points => "such as [[0, 0], [1, 2], [2, 0]], or [b_0, b_1, b_2] for symbols".to_owned(),
            Takes::Net => {
                "rows of points, such as [[[0, 0, 0], [0, 1, 1]], [[1, 0, 1], [1, 1, 0]]]".to_owned()
            }
            Takes::Interval => "such as [0, 1]".to_owned(),
            Takes::Triangle => "such as [[0, 0], [1, 0], [0, 1]]".to_owned(),
            Takes::Matrix => "such as [1, 2; 3, 4]".to_owned(),
            Takes::Figure => "such as figure_basis(3)".to_owned(),
            Takes::Text => "such as \"A curve\"".to_owned(),
            Takes::Named(notion) => notion.ways(),
            _ => return None,
        })
    }
}

impl Notion {
    fn accepts(&self, value: &Value) -> bool {
        let named = |value: &Value| word_of(value).is_some_and(|word| self.names().any(|name| name == word));
        match value {
            Value::List(items) => match items.split_first() {
                Some((first, rest)) if named(first) => rest.iter().all(is_scalar),
                _ => self.unnamed.is_some() && all(value, is_scalar),
            },
            single => named(single),
        }
    }
}

fn is_natural(q: &Rational) -> bool {
    q.is_integer() && *q >= Rational::from_integer(0.into())
}

/// [t, t^2], [0, 1, 4], [[0, 0], [1, 2]]
fn points_or_coordinates(value: &Value) -> bool {
    let part = |item: &Value| {
        is_polynomial(item) || is_row(item) || is_curve(item) || matches!(item, Value::Matrix(_))
    };
    matches!(value, Value::Matrix(_)) || all(value, part)
}
