//! What a function can be told: its parameters, from which checks, forms, hints and help come.

use crate::language::ops::takes::Takes;
use crate::language::value::Value;
use crate::math::number::Rational;
use crate::math::poly::Symbol;

/// One thing a function can be told.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// The name by which it can be given, as in `degree=3`.
    pub name: &'static str,
    /// How the form of the function shows it, such as `[t_0, ..., t_k]`.
    pub form: &'static str,
    /// Whether and how it has to be given.
    pub need: Need,
    /// What it has to be.
    pub kind: Takes,
    /// What it means, in one line.
    pub doc: &'static str,
}

/// Whether and how a parameter has to be given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Need {
    /// At its place or by its name.
    Required,
    /// At its place or by its name, or not at all: what holds then.
    Optional(&'static str),
    /// By its name or not at all: what holds then.
    Named(&'static str),
    /// Any number of arguments, at least and at most so many, from its place on.
    Many(usize, usize),
    /// Any names of the caller's, such as `t=3`, in place of all arguments after the first.
    Free,
}

impl Parameter {
    /// The same parameter as the form of the function shows it.
    pub(super) const fn shown(mut self, form: &'static str) -> Self {
        self.form = form;
        self
    }

    /// Whether the function is called with it at a place.
    pub(super) fn has_place(&self) -> bool {
        !matches!(self.need, Need::Named(_) | Need::Free)
    }

    /// Whether one argument may be given by this name.
    pub(crate) fn has_name(&self) -> bool {
        !matches!(self.need, Need::Many(..) | Need::Free)
    }

    /// What it means, what it has to be and what holds otherwise:
    /// `how often (an integer that is 0 or more; else 1)`.
    pub fn explanation(&self) -> String {
        let kind = (self.kind != Takes::Any).then(|| self.kind.description().into_owned());
        let default = self.default().map(|default| format!("else {default}"));
        match kind.into_iter().chain(default).collect::<Vec<_>>().join("; ") {
            more if more.is_empty() => self.doc.to_owned(),
            more => format!("{} ({more})", self.doc),
        }
    }

    /// How it is given, by its name if it has one: `knots=[t_0, ..., t_k]`.
    pub fn called(&self) -> String {
        match self.has_name() && self.form != self.name && !self.form.contains('=') {
            true => format!("{}={}", self.name, self.form),
            false => self.form.to_owned(),
        }
    }

    /// The value that it has if it is not given, where that is one: not "all 1".
    pub(super) fn default_value(&self) -> Option<Value> {
        let default = self.default()?;
        let number = |text: &str| text.parse::<Rational>().ok().map(Value::number);
        match self.kind {
            kind if kind.has_word(default) => Some(Value::Text(default.to_owned())),
            Takes::Variable if default.chars().all(char::is_alphabetic) => {
                Some(Value::symbol(Symbol::new(default)))
            }
            Takes::Size | Takes::Integer | Takes::Number | Takes::Scalar | Takes::Flag => number(default),
            _ => None,
        }
    }

    /// What holds if it is not given.
    pub fn default(&self) -> Option<&'static str> {
        match self.need {
            Need::Optional(default) | Need::Named(default) => Some(default),
            _ => None,
        }
    }
}

/// A parameter that has to be given.
pub(super) const fn required(name: &'static str, kind: Takes, doc: &'static str) -> Parameter {
    Parameter { name, form: name, need: Need::Required, kind, doc }
}

/// A parameter with a place that may be left out.
pub(super) const fn optional(
    name: &'static str,
    kind: Takes,
    default: &'static str,
    doc: &'static str,
) -> Parameter {
    Parameter { name, form: name, need: Need::Optional(default), kind, doc }
}

/// A parameter given as `name=…` only; `form` shows an example, such as `degree=n`.
pub(super) const fn named(
    form: &'static str,
    kind: Takes,
    default: &'static str,
    doc: &'static str,
) -> Parameter {
    let (mut end, bytes) = (0, form.as_bytes());
    while bytes[end] != b'=' {
        end += 1;
    }
    Parameter { name: form.split_at(end).0, form, need: Need::Named(default), kind, doc }
}

/// Any number of arguments, at least so many.
pub(super) const fn many(form: &'static str, kind: Takes, least: usize, doc: &'static str) -> Parameter {
    Parameter { name: form, form, need: Need::Many(least, usize::MAX), kind, doc }
}

/// Values for any names of the caller's.
pub(super) const fn free(form: &'static str, kind: Takes, doc: &'static str) -> Parameter {
    Parameter { name: form, form, need: Need::Free, kind, doc }
}

/// An integer that tells a degree, a size or an order.
pub(super) const fn size(name: &'static str, doc: &'static str) -> Parameter {
    required(name, Takes::Size, doc)
}

/// A curve, called c in the form.
pub(super) const CURVE: Parameter = required("curve", Takes::Curve, "the curve").shown("c");

/// A curve, also by formulas on the whole line, called c in the form.
pub(super) const LINE: Parameter = required(
    "curve",
    Takes::OneOf(&[Takes::Curve, Takes::Coordinates]),
    "the curve, or its coordinates as formulas",
)
.shown("c");

/// The first of two curves that meet.
pub(super) const FIRST_CURVE: Parameter = required("c", Takes::Curve, "the first curve");

/// The second of two curves that meet.
pub(super) const SECOND_CURVE: Parameter = required("d", Takes::Curve, "the second curve");

/// A spline, called s in the form.
pub(super) const SPLINE: Parameter = required("spline", Takes::Spline, "the spline").shown("s");

/// A surface, called s in the form.
pub(super) const SURFACE: Parameter = required("surface", Takes::Surface, "the surface").shown("s");

/// A surface, also by formulas, called s in the form.
pub(super) const GRAPH: Parameter = required(
    "surface",
    Takes::OneOf(&[Takes::Surface, Takes::Coordinates]),
    "the surface, or its coordinates as formulas in u and v",
)
.shown("s");

/// The letter of the parameter, where formulas have several.
pub(super) const VARIABLE: Parameter = named(
    "variable=t",
    Takes::Variable,
    "the only variable, or t",
    "the variable of the polynomial; other letters are constants",
);

/// A way to polar forms: all lead to the same form, their derivations differ.
pub(super) const METHOD: Parameter = named(
    "method=elementary",
    Takes::Word(&["elementary", "probability", "taylor", "parts", "laguerre", "bezier"]),
    "elementary",
    "the way to the polar form",
);

/// The letter of a polynomial that is made.
pub(super) const RESULT_VARIABLE: Parameter =
    named("variable=t", Takes::Variable, "t", "the variable of the result");

/// The number of a knot interval.
pub(super) const SPAN: Parameter = named(
    "span=j",
    Takes::Size,
    "the one that contains the parameter",
    "the knot interval [t_j, t_(j+1)], needed for symbols",
);

/// Points with their weights as last coordinates.
pub(super) const HOMOGENEOUS: Parameter =
    named("homogeneous=1", Takes::Flag, "0", "whether the last coordinate of each point is its weight");

/// The knots of a spline.
pub(super) const KNOTS: Parameter =
    required("knots", Takes::Scalars, "the knots in increasing order").shown("[t_0, ..., t_k]");

/// The degree of a spline.
pub(super) const DEGREE: Parameter = size("n", "the degree");

/// The nodes of an interpolation.
pub(super) const NODES: Parameter = required("nodes", Takes::Scalars, "the nodes").shown("[x_0, ..., x_n]");

/// The values at the nodes.
pub(super) const VALUES: Parameter =
    required("values", Takes::Points, "a number or point for each node").shown("[y_0, ..., y_n]");

/// The start of an interval.
pub(super) const START: Parameter =
    optional("a", Takes::Scalar, "0, as of [0, 1]", "the start of the interval");

/// The end of an interval.
pub(super) const END: Parameter = optional("b", Takes::Scalar, "1, as of [0, 1]", "its end");
