//! What functions give.

use crate::language::value::{Geometry, Value};

/// What a function gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gives {
    /// A number that counts something; words where there is none, as for the degree of 0.
    Count,
    /// A number or formula.
    Scalar,
    /// A function of its variable, as a formula, a function or a polar form: its formula may be a number.
    Function,
    /// A list of numbers or formulas.
    Scalars,
    /// A list of formulas, each a function.
    Functions,
    /// A point or number.
    Point,
    /// A list of points or numbers.
    Points,
    /// A polar form, or one for each coordinate.
    Polar,
    /// A Bézier curve.
    Curve,
    /// Bézier curves.
    Curves,
    /// A spline.
    Spline,
    /// A curve, spline or piecewise polynomial, as its first argument is.
    SameCurve,
    /// A piecewise polynomial, or one for each coordinate.
    Piecewise,
    /// A patch or spline surface.
    Surface,
    /// Patches or spline surfaces.
    Surfaces,
    /// A matrix.
    Matrix,
    /// A table.
    Table,
    /// A derivation.
    Derivation,
    /// A figure.
    Figure,
    /// Words.
    Text,
    /// A list.
    List,
    /// What that is depends on the arguments.
    Any,
}

fn is_scalar(value: &Value) -> bool {
    matches!(value, Value::Scalar(_) | Value::Algebraic(_))
}

fn is_function(value: &Value) -> bool {
    is_scalar(value) || matches!(value, Value::Function(_) | Value::Polar(_))
}

fn all(value: &Value, item: impl Fn(&Value) -> bool) -> bool {
    match value {
        Value::List(items) => items.iter().all(item),
        Value::Matrix(_) => item(&Value::int(0)),
        _ => false,
    }
}

fn is_bezier(value: &Value) -> bool {
    matches!(value, Value::Geometry(geometry) if matches!(**geometry, Geometry::Bezier(..)))
}

fn is_spline(value: &Value) -> bool {
    matches!(value, Value::Geometry(geometry) if matches!(**geometry, Geometry::Spline(..)))
}

fn is_surface(value: &Value) -> bool {
    matches!(value, Value::Geometry(geometry) if geometry.is_surface())
}

fn is_point(value: &Value) -> bool {
    is_scalar(value) || all(value, is_scalar)
}

impl Gives {
    /// What it is, in words.
    pub fn description(self) -> &'static str {
        match self {
            Gives::Count => "an integer",
            Gives::Scalar => "a number or formula",
            Gives::Function => "a function, by its formula",
            Gives::Scalars => "a list of numbers or formulas",
            Gives::Functions => "a list of functions, by their formulas",
            Gives::Point => "a point or number",
            Gives::Points => "a list of points or numbers",
            Gives::Polar => "a polar form",
            Gives::Curve => "a Bézier curve",
            Gives::Curves => "a list of curves",
            Gives::Spline => "a spline",
            Gives::SameCurve => "a curve of the same kind",
            Gives::Piecewise => "a piecewise polynomial",
            Gives::Surface => "a surface",
            Gives::Surfaces => "a list of surfaces",
            Gives::Matrix => "a matrix",
            Gives::Table => "a table",
            Gives::Derivation => "a derivation",
            Gives::Figure => "a figure",
            Gives::Text => "words",
            Gives::List => "a list",
            Gives::Any => "what its arguments ask for",
        }
    }

    /// Whether a value is that.
    pub fn includes(self, value: &Value) -> bool {
        if let Value::Written(written) = value {
            return self.includes(&written.value);
        }
        match self {
            Gives::Count => matches!(value, Value::Scalar(_) | Value::Text(_)),
            Gives::Scalar => is_scalar(value),
            Gives::Function => is_function(value) || all(value, is_function),
            Gives::Scalars => all(value, is_scalar),
            // The dual functions of B-splines are piecewise.
            Gives::Functions => all(value, |item| is_function(item) || matches!(item, Value::Piecewise(_))),
            Gives::Point => is_point(value),
            Gives::Points => all(value, is_point),
            Gives::Polar => {
                let one = |value: &Value| matches!(value, Value::Polar(_));
                one(value) || all(value, one)
            }
            Gives::Curve => is_bezier(value),
            Gives::Curves => all(value, |item| is_bezier(item) || is_spline(item)),
            Gives::Spline => is_spline(value),
            Gives::SameCurve => is_bezier(value) || is_spline(value) || matches!(value, Value::Piecewise(_)),
            Gives::Piecewise => {
                let one = |value: &Value| matches!(value, Value::Piecewise(_));
                one(value) || all(value, one)
            }
            Gives::Surface => is_surface(value),
            Gives::Surfaces => all(value, |item| is_surface(item) || all(item, is_surface)),
            Gives::Matrix => matches!(value, Value::Matrix(_)),
            Gives::Table => matches!(value, Value::Table(_)),
            Gives::Derivation => matches!(value, Value::Derivation(_)),
            Gives::Figure => matches!(value, Value::Figure(_)),
            Gives::Text => matches!(value, Value::Text(_)),
            Gives::List => matches!(value, Value::List(_)),
            Gives::Any => true,
        }
    }
}
