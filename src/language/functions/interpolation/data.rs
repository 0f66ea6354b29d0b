//! Reading data for interpolation from arguments, results for them, and the words for errors.

use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::functions::matrices::basis_error;
use crate::language::functions::notions::chosen;
use crate::language::ops::errors::wrong_kind;
use crate::language::ops::geometry::{point_of, points_of};
use crate::language::ops::takes::word_of;
use crate::language::value::{Cell, Form, Value, polynomial_expr};
use crate::math::interpolate::{InterpolationError, Norm};
use crate::math::number::Rational;
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};

pub(crate) type Result<T> = std::result::Result<T, Diagnostic>;

/// A number or a point.
pub(crate) type Datum = Vec<Fraction>;

/// The diagnostic for an error of interpolation.
pub(crate) fn interpolation_error(error: InterpolationError) -> Diagnostic {
    use InterpolationError as E;
    let message = error.to_string();
    let (code, hint) = match error {
        E::TooFewPoints { .. } => (Code::Shape, "give more nodes, each with its value"),
        E::Lengths { .. } => (Code::Shape, "both lists need the same length"),
        E::Dimensions { .. } | E::DatumDimensions { .. } => {
            (Code::Shape, "give every point the same number of coordinates")
        }
        E::NoData { .. } => (Code::Shape, "write each node with its value: [x_0, y_0]"),
        E::EqualNodes { .. } => (
            Code::Coincident,
            "hermite([[x_0, f, f'], ...]) takes derivatives at a node, least_squares several values",
        ),
        E::NodesApart { .. } => (Code::Coincident, "write equal nodes one after the other"),
        E::NotIncreasing { .. } => (Code::Knots, "write the nodes in increasing order, with their values"),
        E::NotPeriodic => (Code::Domain, "repeat the first value at the end, or choose other ends"),
        E::Singular { .. } | E::DependentColumns { .. } | E::DependentCondition { .. } => {
            (Code::Singular, "choose a smaller degree, or other nodes, weights or conditions")
        }
        E::TooFewNodes { .. } => (Code::Shape, "choose a smaller degree or give more nodes"),
        E::TooManyConditions { .. } => (Code::Shape, "choose a larger degree or fewer conditions"),
        E::NegativeWeight { .. } => (Code::Domain, "weights are 0 or positive"),
        E::Basis(inner) => return basis_error(inner).hint("such as [bernstein, 0, 2], or power"),
        E::CoincidentPoints { .. } => (Code::Coincident, "leave one of them out, or choose uniform"),
        E::Irrational { .. } => {
            let cure = "decimals=6 gives them rounded to 6 decimals; uniform is always exact";
            // The message of the library asks for decimals; here the hint says how.
            let message = message.split(';').next().unwrap_or_default();
            return Diagnostic::error(Code::Irrational, message).hint(cure);
        }
        E::TooFewDecimals { .. } => (Code::Domain, "ask for more decimals"),
    };
    Diagnostic::error(code, message).hint(hint)
}

/// Nodes at the first place, values at the second.
pub(crate) struct Samples {
    pub nodes: Vec<Fraction>,
    pub values: Vec<Datum>,
    pub form: Form,
}

impl Samples {
    pub fn read(args: &Arguments) -> Result<Self> {
        let nodes = args.scalars(0)?;
        let value = args.value(1)?;
        let (values, scalar) = data(value).ok_or_else(|| {
            wrong_kind("a list of values", value)
                .at(args.span(1))
                .hint("numbers or symbols such as [1, 3, 2], or points such as [[0, 0], [1, 2]]")
        })?;
        Ok(Samples { nodes, values, form: Form { scalar, rational: false } })
    }

    /// The error at the list that is to blame.
    pub fn failed(args: &Arguments) -> impl Fn(InterpolationError) -> Diagnostic {
        let (nodes, values) = (args.span(0), args.span(1));
        move |error| {
            let place = match &error {
                InterpolationError::Lengths { .. }
                | InterpolationError::Dimensions { .. }
                | InterpolationError::NotPeriodic => values,
                _ => nodes,
            };
            interpolation_error(error).at(place)
        }
    }

    /// The variable of the result, which must not occur in the data.
    pub fn variable(&self, args: &Arguments) -> Result<Symbol> {
        let variable = args.letter()?;
        let used = |x: &Fraction| x.variables().contains(&variable);
        if self.nodes.iter().any(used) {
            return Err(occurs(&variable).at(args.span(0)));
        }
        if self.values.iter().flatten().any(used) {
            let place = if args.given(1).is_some() { 1 } else { 0 };
            return Err(occurs(&variable).at(args.span(place)));
        }
        Ok(variable)
    }
}

/// A list of numbers (then `true`) or points; an empty one is a list of numbers.
pub(crate) fn data(value: &Value) -> Option<(Vec<Datum>, bool)> {
    match value {
        Value::List(items) if items.is_empty() => Some((Vec::new(), true)),
        _ => points_of(value).map(|(points, scalar)| (points.into_iter().map(Datum::from).collect(), scalar)),
    }
}

pub(crate) fn occurs(variable: &Symbol) -> Diagnostic {
    Diagnostic::error(
        Code::AmbiguousVariable,
        format!("{variable} occurs in the data, so it cannot be the variable"),
    )
    .reason(format!("contains {variable}"))
    .hint("name another variable: variable=s")
}

/// The variable as a formula.
pub(crate) fn symbol(variable: &Symbol) -> Fraction {
    Fraction::from(MultiPoly::symbol(variable.clone()))
}

/// Power coefficients of a polynomial; for points, one polynomial for each coordinate.
pub(crate) fn polynomial(power: &[Datum], form: Form, variable: &Symbol) -> Value {
    let t = symbol(variable);
    let dimension = power.first().map_or(0, Vec::len);
    let coordinate = |k: usize| {
        let coefficients: Vec<Fraction> = power.iter().map(|c| c[k].clone()).collect();
        Coefficients::new(coefficients).value(&t)
    };
    form.plain((0..dimension).map(coordinate).collect::<Datum>())
}

/// One polynomial with numbers or formulas as power coefficients.
pub(crate) fn scalar_polynomial(power: &[Fraction], variable: &Symbol) -> Value {
    Value::Scalar(Coefficients::new(power.to_vec()).value(&symbol(variable)))
}

/// A datum given under a name.
pub(crate) fn datum(value: &Value, form: Form, span: Span) -> Result<Datum> {
    match point_of(value) {
        Some((point, scalar)) if scalar == form.scalar => Ok(point.into()),
        _ if form.scalar => Err(wrong_kind("a number or formula", value).at(span)),
        _ => Err(wrong_kind("a point", value).at(span).hint("such as [1, 0]: the values are points")),
    }
}

/// Two data given under a name.
pub(crate) fn pair(value: &Value, form: Form, span: Span) -> Result<(Datum, Datum)> {
    match value {
        Value::List(items) if items.len() == 2 => {
            Ok((datum(&items[0], form, span)?, datum(&items[1], form, span)?))
        }
        other => Err(wrong_kind("a list of two", other)
            .at(span)
            .hint("one for the first node and one for the last, such as [0, 1]")),
    }
}

/// The word that an argument is, with the argument; the empty word for other values.
pub(crate) fn word(given: Option<(&Value, Span)>) -> Option<(&str, &Value, Span)> {
    given.map(|(value, span)| (word_of(value).unwrap_or_default(), value, span))
}

/// Norms by their words.
pub(crate) const NORMS: [(&str, Norm); 2] = [("infinity", Norm::Infinity), ("one", Norm::One)];

/// norm=one or norm=infinity, also norm=1.
pub(crate) fn norm(args: &Arguments, place: usize) -> Result<Norm> {
    match args.given(place) {
        Some((value, _)) if value.as_int() == Some(1) => Ok(Norm::One),
        given => chosen(given, &NORMS),
    }
}

/// All entries as numbers.
pub(crate) fn numbers<'a>(
    items: impl IntoIterator<Item = &'a Fraction>,
    what: &str,
    span: Span,
) -> Result<Vec<Rational>> {
    let number = |x: &Fraction| {
        x.as_rational().ok_or_else(|| {
            Diagnostic::error(Code::Undecided, format!("{what} with symbols depends on their values"))
                .at(span)
                .hint("give the symbols values first")
        })
    };
    items.into_iter().map(number).collect()
}

/// base_{i}
pub(crate) fn indexed(base: &str, i: usize) -> Expr {
    Expr::indexed(base, i as i64)
}

/// base_{i,j,…}
pub(crate) fn indexed_by(base: &str, indices: impl IntoIterator<Item = usize>) -> Expr {
    let indices = indices.into_iter().map(|i| Expr::int(i as i64)).collect();
    Kind::Subscript(Box::new(Expr::name(base)), indices).into()
}

/// f[x_i, x_j, …]
pub(crate) fn difference_label(nodes: impl IntoIterator<Item = Expr>) -> Expr {
    Expr::product(vec![Expr::name("f"), Kind::List(nodes.into_iter().collect()).into()])
}

/// x_i = value, or x_i alone if that is its value.
pub(crate) fn labelled(label: Expr, value: Value) -> Cell {
    if value.to_expr().same_as(&label) { Cell::Formula(label) } else { Cell::Labelled(label, value) }
}

/// a − b in brackets, or the single term it is.
pub(crate) fn difference(a: &Fraction, b: &Fraction) -> Expr {
    let expr = polynomial_expr(&(a.clone() - b.clone()));
    if matches!(expr.kind, Kind::Add(_)) { expr.grouped() } else { expr }
}
