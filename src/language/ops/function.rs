//! Functions of one variable given by one formula, and what is done with them pointwise.

use std::sync::Arc;

use super::errors::{division_by_zero, mismatch};
use crate::language::diagnostic::Diagnostic;
use crate::language::value::{Clause, Function, Parameter, Shape, Value};
use crate::math::poly::{Fraction, MultiPoly, Symbol};

type Result<T> = std::result::Result<T, Diagnostic>;

/// Applies an operation to functions of one variable (or a function and a scalar) pointwise.
pub(crate) fn pointwise(
    left: &Value,
    right: &Value,
    verb: &str,
    operation: impl Fn(Fraction, Fraction) -> Result<Fraction>,
) -> Result<Value> {
    let parts = |value: &Value| -> Option<(Option<Symbol>, Fraction)> {
        match value {
            Value::Function(f) => f.as_formula().map(|(t, formula)| (Some(t.clone()), formula.clone())),
            Value::Scalar(a) => Some((None, a.clone())),
            _ => None,
        }
    };
    let (Some((left_name, a)), Some((right_name, b))) = (parts(left), parts(right)) else {
        return Err(mismatch(verb, left, right)
            .hint("functions are combined only if each is given by one formula in one variable"));
    };
    let Some(variable) = left_name.clone().or_else(|| right_name.clone()) else {
        return Err(mismatch(verb, left, right));
    };
    let b = match right_name {
        Some(name) if name != variable => b
            .substitute(&[(name, Fraction::from(MultiPoly::symbol(variable.clone())))])
            .map_err(|_| division_by_zero())?,
        _ => b,
    };
    Ok(formula_function(variable, operation(a, b)?))
}

/// The function variable ↦ formula.
pub(crate) fn formula_function(variable: Symbol, formula: Fraction) -> Value {
    Value::Function(Arc::new(Function {
        name: None,
        shape: Shape::plain(1),
        clauses: vec![Clause {
            parameters: vec![Parameter::Name(variable)],
            body: crate::language::value::polynomial_expr(&formula),
            written: false,
            formula: Some(formula),
            scope: Default::default(),
        }],
    }))
}
