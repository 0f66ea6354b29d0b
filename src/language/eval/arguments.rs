//! Arguments of the program's functions: by place and by name.

mod geometry;

use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Rel};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::errors::wrong_kind;
use crate::language::ops::formula::{Univariate, form_of, symbol_of, univariate};
use crate::language::ops::takes::Takes;
use crate::language::value::{Claim, Function, List, Polar, Value};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, Symbol};
use nalgebra::DMatrix;
use std::sync::Arc;

type Result<T> = std::result::Result<T, Diagnostic>;

/// `name = value` inside a call.
pub(crate) fn named(expr: &Expr) -> Option<(String, &Expr)> {
    match &expr.kind {
        Kind::Chain(left, links) if links.len() == 1 && links[0].rel == Rel::Eq => match &left.kind {
            Kind::Name(name) => Some((name.clone(), &links[0].expr)),
            _ => None,
        },
        _ => None,
    }
}

/// A list of rows as a matrix: [[1, 2], [3, 4]].
pub(super) fn matrix_of(value: &Value) -> Option<DMatrix<Fraction>> {
    let Value::List(rows) = value else { return None };
    let row = |row: &Value| match row {
        Value::List(items) => items.iter().map(|item| item.as_scalar().cloned()).collect(),
        _ => None,
    };
    let rows: Vec<Vec<Fraction>> = rows.iter().map(row).collect::<Option<_>>()?;
    let columns = rows.first().map_or(0, Vec::len);
    let whole = columns > 0 && rows.iter().all(|row| row.len() == columns);
    whole.then(|| DMatrix::from_row_iterator(rows.len(), columns, rows.into_iter().flatten()))
}

/// The arguments of one call.
#[derive(Clone, Debug, Default)]
pub struct Arguments {
    /// By place; `None` where one is left out and a later one is given by its name.
    places: Vec<Option<(Value, Span)>>,
    named: Vec<(String, Value, Span)>,
    /// Values of names with indices: c_0=1.
    indexed: Vec<(Symbol, Value, Span)>,
    /// Where the names stand, if they are written down.
    name_spans: Vec<(String, Span)>,
}

impl Arguments {
    pub(crate) fn push(&mut self, value: Value, span: Span) {
        self.places.push(Some((value, span)));
    }

    pub(crate) fn push_named(&mut self, name: String, value: Value, span: Span) {
        self.named.push((name, value, span));
    }

    /// An argument as it is written, with the place of its name.
    pub(crate) fn push_written(&mut self, written: &Expr, name: String, value: Value, span: Span) {
        if let Kind::Chain(left, _) = &written.kind
            && !left.span.is_empty()
        {
            self.name_spans.push((name.clone(), left.span));
        }
        self.push_named(name, value, span);
    }

    /// Where a name stands.
    pub(crate) fn span_of_name(&self, name: &str) -> Option<Span> {
        self.name_spans.iter().find(|(own, _)| own == name).map(|(_, span)| *span)
    }

    pub(crate) fn push_indexed(&mut self, name: Symbol, value: Value, span: Span) {
        self.indexed.push((name, value, span));
    }

    /// Sets the argument at a place.
    pub(crate) fn put(&mut self, place: usize, value: Value, span: Span) {
        if self.places.len() <= place {
            self.places.resize(place + 1, None);
        }
        self.places[place] = Some((value, span));
    }

    /// Moves the arguments from a place on to the next ones.
    pub(crate) fn leave_out(&mut self, place: usize) {
        self.places.insert(place, None);
    }

    /// Removes the argument at a place, where there is one; later ones move up.
    pub(crate) fn take_place(&mut self, place: usize) -> Option<(Value, Span)> {
        (place < self.places.len()).then(|| self.places.remove(place)).flatten()
    }

    /// Equations at the first places as one argument.
    pub(crate) fn with_equations_together(mut self) -> Self {
        while let [Some((Value::Claim(first), start)), Some((Value::Claim(next), end)), ..] =
            self.places.as_slice()
        {
            let judgements = first.judgements.iter().chain(&next.judgements).cloned().collect();
            let both = Value::Claim(Arc::new(Claim { judgements }));
            self.places[0] = Some((both, start.to(*end)));
            self.places.remove(1);
        }
        self
    }

    /// Removes the argument under a name.
    pub(crate) fn take_named(&mut self, name: &str) -> Option<(String, Value, Span)> {
        let at = self.named.iter().position(|(n, ..)| n == name)?;
        Some(self.named.remove(at))
    }

    /// Removes all arguments that are given under names.
    pub(crate) fn take_all_named(&mut self) -> Vec<(String, Value, Span)> {
        std::mem::take(&mut self.named)
    }

    /// Whether one is given under this name.
    pub(crate) fn has_name(&self, name: &str) -> bool {
        self.named.iter().any(|(known, ..)| known == name)
    }

    /// Whether some are given under names.
    pub(crate) fn has_names(&self) -> bool {
        !(self.named.is_empty() && self.indexed.is_empty())
    }

    /// The same arguments with another first one.
    pub(crate) fn with_first(&self, value: Value) -> Self {
        let mut other = self.clone();
        if let Some(Some(first)) = other.places.first_mut() {
            first.0 = value;
        }
        other
    }

    /// The first `count` arguments given by place.
    pub(crate) fn only(&self, count: usize) -> Self {
        Arguments { places: self.places.iter().take(count).cloned().collect(), ..Arguments::default() }
    }

    /// All arguments but the first one.
    pub(crate) fn after_first(&self) -> Self {
        let mut rest = self.clone();
        rest.places.drain(..1.min(rest.places.len()));
        rest
    }

    /// All arguments but those under the given names.
    pub(crate) fn without(&self, names: &[&str]) -> Self {
        let mut rest = self.clone();
        rest.named.retain(|(name, ..)| !names.contains(&name.as_str()));
        rest
    }

    /// Number of places, up to the last one with an argument.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// Whether no argument has a place.
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// The argument at a place, if there is one.
    pub fn given(&self, i: usize) -> Option<(&Value, Span)> {
        self.places.get(i)?.as_ref().map(|(value, span)| (value, *span))
    }

    /// The i-th argument.
    pub fn value(&self, i: usize) -> Result<&Value> {
        self.given(i)
            .map(|(value, _)| value)
            .ok_or_else(|| Diagnostic::error(Code::Arity, format!("argument {} is missing", i + 1)))
    }

    /// All arguments that have a place.
    pub fn values(&self) -> impl Iterator<Item = &Value> {
        self.places.iter().flatten().map(|(value, _)| value)
    }

    /// The arguments with a place as the items of one.
    pub(crate) fn gathered(mut self, span: Span) -> Self {
        let items = self.places.drain(..).flatten().map(|(value, _)| value).collect();
        self.places.push(Some((Value::List(items), span)));
        self
    }

    /// The place of the i-th argument.
    pub fn span(&self, i: usize) -> Span {
        self.given(i).map_or_else(Span::default, |(_, span)| span)
    }

    /// The argument given under a name.
    pub fn named(&self, name: &str) -> Option<(&Value, Span)> {
        self.named.iter().find(|(n, ..)| n == name).map(|(_, value, span)| (value, *span))
    }

    /// The arguments given as t=value, if there are any.
    pub fn substitutions(&self) -> Result<Vec<(Symbol, Fraction)>> {
        let plain = self.named.iter().map(|(name, value, span)| (Symbol::new(name), value, span));
        let indexed = self.indexed.iter().map(|(name, value, span)| (name.clone(), value, span));
        plain
            .chain(indexed)
            .map(|(name, value, span)| match value {
                Value::Scalar(value) => Ok((name, value.clone())),
                other => Err(wrong_kind("a number or formula", other).at(*span)),
            })
            .collect()
    }

    /// A scalar.
    pub fn scalar(&self, i: usize) -> Result<Fraction> {
        let value = self.value(i)?;
        value.as_scalar().cloned().ok_or_else(|| Takes::Scalar.refuses(value).at(self.span(i)))
    }

    /// A rational number.
    pub fn rational(&self, i: usize) -> Result<Rational> {
        let value = self.value(i)?;
        value.as_rational().ok_or_else(|| Takes::Number.refuses(value).at(self.span(i)))
    }

    /// A scalar that may be left out.
    pub fn optional_scalar(&self, i: usize) -> Result<Option<Fraction>> {
        self.given(i).map(|_| self.scalar(i)).transpose()
    }

    /// An integer that is at least 0.
    pub fn size(&self, i: usize) -> Result<usize> {
        size_of(self.value(i)?, self.span(i))
    }

    /// A size that may be left out.
    pub fn optional_size(&self, i: usize) -> Result<Option<usize>> {
        self.given(i).map(|(value, span)| size_of(value, span)).transpose()
    }

    /// A size under a name.
    pub fn named_size(&self, name: &str) -> Result<Option<usize>> {
        self.named(name).map(|(value, span)| size_of(value, span)).transpose()
    }

    /// A size under a name that the table gives a value otherwise.
    pub fn size_named(&self, name: &str) -> Result<usize> {
        self.named_size(name)?
            .ok_or_else(|| Diagnostic::error(Code::Arity, format!("the argument '{name}' is missing")))
    }

    /// A symbol.
    pub fn symbol(&self, i: usize) -> Result<Symbol> {
        let value = self.value(i)?;
        symbol_of(value).ok_or_else(|| Takes::Variable.refuses(value).at(self.span(i)))
    }

    /// A symbol that may be left out.
    pub fn optional_symbol(&self, i: usize) -> Result<Option<Symbol>> {
        self.given(i).map(|_| self.symbol(i)).transpose()
    }

    /// Whether `name=1` is given, or holds if nothing is.
    pub fn flag(&self, name: &str) -> Result<bool> {
        self.flag_or(name, false)
    }

    /// The same where what holds otherwise depends on more than the table can say.
    pub fn flag_or(&self, name: &str, otherwise: bool) -> Result<bool> {
        let Some((value, span)) = self.named(name) else { return Ok(otherwise) };
        match value.as_int() {
            Some(0) => Ok(false),
            Some(1) => Ok(true),
            _ => Err(Takes::Flag.refuses(value).at(span)),
        }
    }

    /// The symbol given as `variable=…`.
    pub fn variable(&self) -> Result<Option<Symbol>> {
        let symbol = |(value, span)| symbol_of(value).ok_or_else(|| Takes::Variable.refuses(value).at(span));
        self.named("variable").map(symbol).transpose()
    }

    /// The symbol given as `variable=…`, or the one that the table has.
    pub fn letter(&self) -> Result<Symbol> {
        self.variable()?.ok_or_else(|| Diagnostic::error(Code::Arity, "the argument 'variable' is missing"))
    }

    /// A list of scalars.
    pub fn scalars(&self, i: usize) -> Result<Vec<Fraction>> {
        scalars_of(self.value(i)?, self.span(i))
    }

    /// A list of scalars under a name.
    pub fn named_scalars(&self, name: &str) -> Result<Option<Vec<Fraction>>> {
        self.named(name).map(|(value, span)| scalars_of(value, span)).transpose()
    }

    /// A function of the caller's.
    pub(crate) fn mapping(&self, i: usize) -> Result<&Arc<Function>> {
        match self.value(i)? {
            Value::Function(function) => Ok(function),
            other => Err(Takes::Mapping.refuses(other).at(self.span(i))),
        }
    }

    /// The items of a list.
    pub(crate) fn list(&self, i: usize) -> Result<&List<Value>> {
        match self.value(i)? {
            Value::List(items) => Ok(items),
            other => Err(Takes::List.refuses(other).at(self.span(i))),
        }
    }

    /// A matrix (a list of lists will do).
    pub fn matrix(&self, i: usize) -> Result<DMatrix<Fraction>> {
        match self.value(i)? {
            Value::Matrix(matrix) => Ok(matrix.clone()),
            other => matrix_of(other).ok_or_else(|| Takes::Matrix.refuses(other).at(self.span(i))),
        }
    }

    /// A polar form, also one given as a function by its formula.
    pub fn polar(&self, i: usize) -> Result<std::sync::Arc<Polar>> {
        match self.value(i)? {
            Value::Polar(polar) => Ok(polar.clone()),
            Value::Function(function) => form_of(function).map(Arc::new).ok_or_else(|| {
                Diagnostic::error(Code::Type, "this function is not symmetric and affine in each argument")
                    .at(self.span(i))
                    .hint("polar(F) is the polar form of a polynomial")
            }),
            other => Err(Takes::Polar.refuses(other).at(self.span(i))),
        }
    }

    /// A polynomial in one variable: a formula, a function, or the diagonal of a polar form.
    /// The variable may be given as `variable=…`.
    pub fn univariate(&self, i: usize) -> Result<Univariate> {
        self.univariate_in(i, self.variable()?)
    }

    /// The same with the variable already known.
    pub fn univariate_in(&self, i: usize, given: Option<Symbol>) -> Result<Univariate> {
        let value = self.value(i)?;
        univariate(value, given).at(self.span(i))
    }
}

fn scalars_of(value: &Value, span: Span) -> Result<Vec<Fraction>> {
    let scalars = match value {
        Value::List(items) => items.iter().map(|item| item.as_scalar().cloned()).collect(),
        _ => None,
    };
    scalars.ok_or_else(|| Takes::Scalars.refuses(value).at(span))
}

fn size_of(value: &Value, span: Span) -> Result<usize> {
    value.as_int().and_then(|k| usize::try_from(k).ok()).filter(|&k| k <= u32::MAX as usize).ok_or_else(
        || match value.as_rational() {
            Some(q) if q.is_integer() && q > Rational::from_integer(0.into()) => {
                Diagnostic::error(Code::TooManyTerms, "this number is too large here").at(span)
            }
            _ => Takes::Size.refuses(value).at(span),
        },
    )
}
