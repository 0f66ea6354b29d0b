//! Polar forms as values: their arguments, sums and multiples, and what their laws say.

use std::sync::Arc;

use super::errors::{polar_error, wrong_kind};
use crate::formula::Accent;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::value::{Polar, PolarKind, Value};
use crate::math::blossom::laws::{self, ArgumentNames};
use crate::math::blossom::{
    Argument, PointArgument, TensorPolarForm, TotalDegreePolarForm, Written, expand_tensor, expand_total,
    expand_univariate,
};
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;

type Result<T> = std::result::Result<T, Diagnostic>;

/// A value as an argument of a polar form.
pub(crate) fn argument(value: Value) -> Result<Argument<Fraction>> {
    match value {
        Value::Scalar(u) if is_vector(&u) => Ok(Argument::Vector(u)),
        Value::Scalar(u) => Ok(Argument::Point(u)),
        Value::Vector(v) => Ok(Argument::Vector(v)),
        other => Err(wrong_kind("a number, symbol or vector argument", &other)),
    }
}

/// Whether a formula is a combination of names with an arrow, such as `vec(d) - 2 vec(e)`.
fn is_vector(formula: &Fraction) -> bool {
    let arrows: Vec<Symbol> =
        formula.variables().into_iter().filter(|symbol| symbol.accent() == Accent::Vec.name()).collect();
    let doubled = arrows.iter().map(|arrow| {
        let arrow_twice = Fraction::from(MultiPoly::symbol(arrow.clone()))
            .plus(&Fraction::from(MultiPoly::symbol(arrow.clone())));
        (arrow.clone(), arrow_twice)
    });
    let doubled: Vec<(Symbol, Fraction)> = doubled.collect();
    !arrows.is_empty() && formula.substitute(&doubled).is_ok_and(|value| value == formula.plus(formula))
}

/// A point of several coordinates, or a vector argument of such.
pub(crate) fn point_argument(value: &Value) -> Option<PointArgument<Fraction>> {
    let Value::List(items) = value else { return None };
    let points: Option<Vec<Fraction>> = items.iter().map(|item| item.as_scalar().cloned()).collect();
    if let Some(points) = points {
        return Some(Argument::Point(points));
    }
    let vectors: Option<Vec<Fraction>> = items
        .iter()
        .map(|item| match item {
            Value::Vector(v) => Some(v.clone()),
            _ => None,
        })
        .collect();
    vectors.map(Argument::Vector)
}

/// The sum of two polar forms with as many arguments.
pub(crate) fn add(a: &Polar, b: &Polar) -> Result<Value> {
    let unequal = || {
        Diagnostic::error(Code::Arity, "polar forms with different arguments cannot be added")
            .hint("elevate the lower degree first, or use polar_sum(f, g), which does it")
    };
    let kind = match (&a.kind, &b.kind) {
        (PolarKind::Univariate(f), PolarKind::Univariate(g)) if f.degree() == g.degree() => {
            PolarKind::Univariate(f.sum(g))
        }
        (PolarKind::Tensor(f), PolarKind::Tensor(g)) if f.degrees() == g.degrees() => {
            PolarKind::Tensor(f.sum(g).map_err(|_| unequal())?)
        }
        _ => return Err(unequal()),
    };
    Ok(Value::Polar(Arc::new(Polar { kind, variables: a.variables.clone() })))
}

/// A multiple of a polar form.
pub(crate) fn scale(a: &Fraction, f: &Polar) -> Result<Value> {
    let kind = match &f.kind {
        PolarKind::Univariate(form) => PolarKind::Univariate(form.map(|c| c.times(a))),
        PolarKind::Tensor(form) => {
            let rows = form.coefficients();
            let grid = rows.iter().map(|row| row.iter().map(|c| c.times(a)).collect());
            PolarKind::Tensor(TensorPolarForm::new(grid.collect()).map_err(polar_error)?)
        }
        PolarKind::Total(form) => {
            let terms = form.terms().map(|(e, c)| (e.to_vec(), c.times(a)));
            PolarKind::Total(
                TotalDegreePolarForm::new(form.dimension(), form.degree(), terms).map_err(polar_error)?,
            )
        }
    };
    Ok(Value::Polar(Arc::new(Polar { kind, variables: f.variables.clone() })))
}

/// The coordinates of a curve or surface as polar forms of one degree, the largest.
pub(crate) fn levelled(list: Vec<Value>) -> Vec<Value> {
    let degrees = |value: &Value| match value {
        Value::Polar(polar) => Some(match &polar.kind {
            PolarKind::Univariate(form) => (0, form.degree(), 0),
            PolarKind::Tensor(form) => (1, form.degrees().0, form.degrees().1),
            PolarKind::Total(form) => (2 + form.dimension(), form.degree(), 0),
        }),
        _ => None,
    };
    let Some(all) = list.iter().map(degrees).collect::<Option<Vec<_>>>() else { return list };
    let Some(&(kind, ..)) = all.first().filter(|first| all.iter().all(|other| other.0 == first.0)) else {
        return list;
    };
    let top = all.iter().fold((kind, 0, 0), |top, other| (kind, top.1.max(other.1), top.2.max(other.2)));
    let raised = |(value, own): (Value, (usize, usize, usize))| {
        let Value::Polar(polar) = &value else { return value };
        let by = (top.1 - own.1, top.2 - own.2);
        let kind = match &polar.kind {
            PolarKind::Univariate(form) => PolarKind::Univariate(form.elevate(by.0)),
            PolarKind::Total(form) => PolarKind::Total(form.elevate(by.0)),
            PolarKind::Tensor(form) => match form.elevate(by.0, by.1) {
                Ok(form) => PolarKind::Tensor(form),
                Err(_) => return value,
            },
        };
        Value::Polar(Arc::new(Polar { kind, variables: polar.variables.clone() }))
    };
    list.into_iter().zip(all).map(raised).collect()
}

/// The form written out in the arguments of the arrangement; `None` if a coefficient is a
/// proper quotient.
pub(crate) fn expand_polar(polar: &Polar, arrangement: &ArgumentNames) -> Option<MultiPoly> {
    let written = |c: &Fraction| c.as_written().is_some();
    match &polar.kind {
        PolarKind::Univariate(form) => {
            form.coefficients().iter().all(written).then(|| expand_univariate(form, arrangement))
        }
        PolarKind::Tensor(form) => form
            .coefficients()
            .iter()
            .all(|row| row.iter().all(written))
            .then(|| expand_tensor(form, arrangement)),
        PolarKind::Total(form) => {
            form.terms().all(|(_, c)| written(c)).then(|| expand_total(form, arrangement))
        }
    }
}

/// What the laws of polar forms say about a claimed expression.
pub(crate) fn laws_report(polar: &Polar, claim: &Fraction, arrangement: &ArgumentNames) -> Vec<String> {
    let Some(claim) = claim.as_polynomial() else {
        return vec!["the claimed expression is not a polynomial in the arguments".to_owned()];
    };
    let Some(right) = expand_polar(polar, arrangement) else { return Vec::new() };
    laws::check(claim, &right, arrangement).describe()
}
