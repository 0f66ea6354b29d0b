//! Curves: lists of functions, piecewise ones too, or polar forms, one for each coordinate.

use std::sync::Arc;

use super::apply::to_argument;
use super::{Evaluated, Machine, arguments, geometry, wrong_kind};
use crate::formula::source::Span;
use crate::language::diagnostic::At;
use crate::language::value::{Polar, PolarKind, Value};

impl Machine {
    /// One coordinate of a curve at the given arguments.
    pub(crate) fn coordinate(&mut self, item: &Value, values: &[(Value, Span)], span: Span) -> Evaluated {
        match item {
            Value::Function(function) => self.call(function, values.to_vec(), span),
            Value::Polar(polar) => {
                let PolarKind::Univariate(form) = &polar.kind else {
                    return Err(wrong_kind("a polar form of a curve", item).at(span));
                };
                let list: Result<Vec<_>, _> = values.iter().cloned().map(to_argument).collect();
                form.value(&list?).map(Value::Scalar).map_err(arguments::polar).at(span)
            }
            Value::Piecewise(function) => geometry::call_piecewise(function, values, span),
            other => Err(wrong_kind("a function", other).at(span)),
        }
    }
}

/// Whether a list can be called like a function.
pub(crate) fn is_curve(items: &[Value]) -> bool {
    let callable = |item: &Value| matches!(item, Value::Function(_) | Value::Polar(_) | Value::Piecewise(_));
    !items.is_empty() && items.iter().all(callable)
}

/// The coordinates of a curve as polar forms of one degree, the largest.
pub(crate) fn levelled(list: Vec<Value>) -> Vec<Value> {
    let degree = |value: &Value| match value {
        Value::Polar(polar) => match &polar.kind {
            PolarKind::Univariate(form) => Some(form.degree()),
            _ => None,
        },
        _ => None,
    };
    let Some(top) = list.iter().map(degree).collect::<Option<Vec<usize>>>().and_then(|d| d.into_iter().max())
    else {
        return list;
    };
    list.into_iter()
        .map(|value| match &value {
            Value::Polar(polar) => match &polar.kind {
                PolarKind::Univariate(form) => Value::Polar(Arc::new(Polar {
                    kind: PolarKind::Univariate(form.elevate(top - form.degree())),
                    variables: polar.variables.clone(),
                })),
                _ => value,
            },
            _ => value,
        })
        .collect()
}
