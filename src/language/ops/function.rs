//! Functions of one variable given by one formula, and what is done with them pointwise.

use std::sync::Arc;

use super::calculus::nth_derivative;
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

/// The formula of a function of several variables, in other variables.
pub(crate) fn formula_in(function: &Function, variables: &[Symbol]) -> Option<Fraction> {
    let (own, formula) = function.as_formula_of_many().filter(|(own, _)| own.len() == variables.len())?;
    let places = own.into_iter().cloned();
    let values = variables.iter().map(|name| Fraction::from(MultiPoly::symbol(name.clone())));
    formula.substitute(&places.zip(values).collect::<Vec<_>>()).ok()
}

/// The partial derivatives of a function of several variables, of the given orders, as a function of them;
/// `None` if it has no such variables.
pub(crate) fn partial(function: &Function, orders: &[(Symbol, usize)]) -> Option<Value> {
    let (own, formula) = function.as_formula_of_many()?;
    if !orders.iter().all(|(name, _)| own.contains(&name)) {
        return None;
    }
    let derivative = orders.iter().fold(formula.clone(), |f, (name, order)| nth_derivative(&f, name, *order));
    Some(function_of(own.into_iter().cloned().collect(), derivative))
}

/// The function variable ↦ formula.
pub(crate) fn formula_function(variable: Symbol, formula: Fraction) -> Value {
    function_of(vec![variable], formula)
}

/// The function (variables) ↦ formula.
pub(crate) fn function_of(variables: Vec<Symbol>, formula: Fraction) -> Value {
    Value::Function(Arc::new(Function {
        name: None,
        shape: Shape::plain(variables.len()),
        clauses: vec![Clause {
            parameters: variables.into_iter().map(Parameter::Name).collect(),
            body: crate::language::value::polynomial_expr(&formula),
            written: false,
            formula: Some(formula),
            scope: Default::default(),
        }],
    }))
}
