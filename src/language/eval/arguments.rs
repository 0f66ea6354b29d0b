//! Arguments of the program's functions: by place and by name.

mod geometry;

use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Rel};
use crate::language::diagnostic::{At, Code, Diagnostic, nearest};
use crate::language::ops::errors::wrong_kind;
use crate::language::ops::formula::{Univariate, symbol_of, univariate};
use crate::language::value::{Polar, Value};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, Symbol};
use nalgebra::DMatrix;

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

/// The arguments of one call.
#[derive(Clone, Debug, Default)]
pub struct Arguments {
    positional: Vec<(Value, Span)>,
    named: Vec<(String, Value, Span)>,
}

impl Arguments {
    pub(crate) fn push(&mut self, value: Value, span: Span) {
        self.positional.push((value, span));
    }

    pub(crate) fn push_named(&mut self, name: String, value: Value, span: Span) {
        self.named.push((name, value, span));
    }

    /// The same arguments with another first one.
    pub(crate) fn with_first(&self, value: Value) -> Self {
        let mut other = self.clone();
        if let Some(first) = other.positional.first_mut() {
            first.0 = value;
        }
        other
    }

    /// The first `count` arguments given by place.
    pub(crate) fn only(&self, count: usize) -> Self {
        Arguments { positional: self.positional.iter().take(count).cloned().collect(), named: Vec::new() }
    }

    /// The arguments after the first one, without those under the given names.
    pub(crate) fn after_first(&self, names: &[&str]) -> Self {
        let mut rest = self.without(names);
        rest.positional.drain(..1.min(rest.positional.len()));
        rest
    }

    /// All arguments but those under the given names.
    pub(crate) fn without(&self, names: &[&str]) -> Self {
        let mut rest = self.clone();
        rest.named.retain(|(name, ..)| !names.contains(&name.as_str()));
        rest
    }

    /// All arguments but the one at a place.
    pub(crate) fn without_place(&self, place: usize) -> Self {
        let mut other = self.clone();
        if place < other.positional.len() {
            other.positional.remove(place);
        }
        other
    }

    /// Number of arguments given by place.
    pub fn len(&self) -> usize {
        self.positional.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.positional.is_empty()
    }

    /// Checks how many arguments there are and which names are used.
    pub fn expect(
        &self,
        signature: &str,
        count: std::ops::RangeInclusive<usize>,
        names: &[&str],
    ) -> Result<()> {
        if let Some((name, _, span)) = self.named.iter().find(|(name, ..)| !names.contains(&name.as_str())) {
            let known = nearest(name, names.iter().copied());
            let error = Diagnostic::error(Code::Arity, format!("there is no argument '{name}'"))
                .at(*span)
                .reason(format!("the form is {signature}"));
            return Err(match known {
                Some(best) => error.hint(format!("did you mean '{best}'?")),
                None => error,
            });
        }
        if count.contains(&self.len()) {
            return Ok(());
        }
        let wanted = match (count.start(), count.end()) {
            (a, b) if a == b => a.to_string(),
            (a, b) if *b == usize::MAX => format!("at least {a}"),
            (a, b) => format!("{a} to {b}"),
        };
        let error = Diagnostic::error(
            Code::Arity,
            format!("{wanted} argument{} needed, {} given", if wanted == "1" { "" } else { "s" }, self.len()),
        )
        .hint(format!("the form is {signature}"));
        Err(match self.positional.get(*count.end()) {
            Some((_, span)) => error.at(*span),
            None => error,
        })
    }

    /// The i-th argument.
    pub fn value(&self, i: usize) -> Result<&Value> {
        self.positional
            .get(i)
            .map(|(value, _)| value)
            .ok_or_else(|| Diagnostic::error(Code::Arity, format!("argument {} is missing", i + 1)))
    }

    /// All arguments given by place.
    pub fn values(&self) -> impl Iterator<Item = &Value> {
        self.positional.iter().map(|(value, _)| value)
    }

    /// The place of the i-th argument.
    pub fn span(&self, i: usize) -> Span {
        self.positional.get(i).map_or_else(Span::default, |(_, span)| *span)
    }

    /// The argument given under a name, or else at a place.
    pub fn named_or(&self, name: &str, i: usize) -> Option<(&Value, Span)> {
        self.named
            .iter()
            .find(|(n, ..)| n == name)
            .map(|(_, value, span)| (value, *span))
            .or_else(|| self.positional.get(i).map(|(value, span)| (value, *span)))
    }

    /// Whether an argument is given under this name.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.named.iter().any(|(n, ..)| n == name)
    }

    /// The arguments given as t=value, if there are any.
    pub fn substitutions(&self) -> Result<Vec<(Symbol, Fraction)>> {
        self.named
            .iter()
            .map(|(name, value, span)| match value {
                Value::Scalar(value) => Ok((Symbol::new(name), value.clone())),
                other => Err(wrong_kind("a number or formula", other).at(*span)),
            })
            .collect()
    }

    /// A scalar.
    pub fn scalar(&self, i: usize) -> Result<Fraction> {
        let value = self.value(i)?;
        value.as_scalar().cloned().ok_or_else(|| wrong_kind("a number or formula", value).at(self.span(i)))
    }

    /// A rational number.
    pub fn rational(&self, i: usize) -> Result<Rational> {
        let value = self.value(i)?;
        value.as_rational().ok_or_else(|| wrong_kind("a number", value).at(self.span(i)))
    }

    /// An integer that is at least 0.
    pub fn size(&self, i: usize) -> Result<usize> {
        size_of(self.value(i)?, self.span(i))
    }

    /// A size under a name or at a place.
    pub fn named_size(&self, name: &str, i: usize) -> Result<Option<usize>> {
        self.named_or(name, i).map(|(value, span)| size_of(value, span)).transpose()
    }

    /// A symbol.
    pub fn symbol(&self, i: usize) -> Result<Symbol> {
        let value = self.value(i)?;
        symbol_of(value).ok_or_else(|| wrong_kind("a variable", value).at(self.span(i)))
    }

    /// A list of scalars.
    pub fn scalars(&self, i: usize) -> Result<Vec<Fraction>> {
        match self.value(i)? {
            Value::List(items) => items
                .iter()
                .map(|item| {
                    item.as_scalar()
                        .cloned()
                        .ok_or_else(|| wrong_kind("a list of numbers or formulas", item).at(self.span(i)))
                })
                .collect(),
            other => Err(wrong_kind("a list such as [0, 1/2, 1]", other).at(self.span(i))),
        }
    }

    /// A matrix (a list of lists will do).
    pub fn matrix(&self, i: usize) -> Result<DMatrix<Fraction>> {
        match self.value(i)? {
            Value::Matrix(matrix) => Ok(matrix.clone()),
            other => Err(wrong_kind("a matrix such as [1, 2; 3, 4]", other).at(self.span(i))),
        }
    }

    /// A polar form.
    pub fn polar(&self, i: usize) -> Result<std::sync::Arc<Polar>> {
        match self.value(i)? {
            Value::Polar(polar) => Ok(polar.clone()),
            other => Err(wrong_kind("a polar form", other)
                .at(self.span(i))
                .hint("polar(F) is the polar form of a polynomial")),
        }
    }

    /// A polynomial in one variable: a formula, a function, or the diagonal of a polar form.
    /// The variable may be named at place `variable`.
    pub fn univariate(&self, i: usize, variable: usize) -> Result<Univariate> {
        let given = match self.named_or("variable", variable) {
            Some((value, span)) => {
                Some(symbol_of(value).ok_or_else(|| wrong_kind("a variable", value).at(span))?)
            }
            None => None,
        };
        self.univariate_in(i, given)
    }

    /// The same with the variable already known.
    pub fn univariate_in(&self, i: usize, given: Option<Symbol>) -> Result<Univariate> {
        let value = self.value(i)?;
        univariate(value, given).at(self.span(i))
    }
}

fn size_of(value: &Value, span: Span) -> Result<usize> {
    value.as_int().and_then(|k| usize::try_from(k).ok()).filter(|&k| k <= u32::MAX as usize).ok_or_else(
        || match value.as_rational() {
            Some(q) if q.is_integer() && q > Rational::from_integer(0.into()) => {
                Diagnostic::error(Code::TooManyTerms, "this number is too large here").at(span)
            }
            Some(_) => Diagnostic::error(Code::Domain, "expected an integer that is 0 or more").at(span),
            None => wrong_kind("an integer that is 0 or more", value).at(span),
        },
    )
}
