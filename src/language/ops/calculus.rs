//! Derivatives, integrals and composition of functions and formulas.

use std::sync::Arc;

use super::errors::{division_by_zero, wrong_kind};
use super::formula::{coefficients_in, variable_of};
use super::function::formula_function;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::value::{Polar, PolarKind, Value};
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;

type Result<T> = std::result::Result<T, Diagnostic>;

/// F^(k) of a function given by one formula, or the polar form of the derivative.
pub(crate) fn derivative(value: &Value, order: usize) -> Result<Value> {
    match value {
        Value::Function(function) => {
            let Some((variable, formula)) = function.as_formula() else {
                return Err(Diagnostic::error(
                    Code::Type,
                    "only functions of one variable given by one formula have a derivative here",
                )
                .hint("use diff(formula, variable)"));
            };
            Ok(formula_function(variable.clone(), nth_derivative(formula, variable, order)))
        }
        Value::Polar(polar) => match &polar.kind {
            PolarKind::Univariate(form) => Ok(Value::Polar(Arc::new(Polar {
                kind: PolarKind::Univariate(form.nth_derivative(order)),
                variables: polar.variables.clone(),
            }))),
            _ => Err(Diagnostic::error(Code::Type, "say in which direction to differentiate")
                .hint("derivative(f, 1, 0) counts for each variable")),
        },
        Value::Scalar(formula) => {
            let variable = variable_of(formula, None)?;
            Ok(Value::Scalar(nth_derivative(formula, &variable, order)))
        }
        other => Err(wrong_kind("a function", other)),
    }
}

/// d^k/dt^k.
pub(crate) fn nth_derivative(formula: &Fraction, variable: &Symbol, order: usize) -> Fraction {
    let mut result = formula.clone();
    for _ in 0..order {
        if num_traits::Zero::is_zero(&result) {
            break;
        }
        result = result.derivative(variable);
    }
    result
}

/// ∫_a^b of a polynomial in the variable; without bounds the antiderivative that is 0 at 0.
pub(crate) fn integrate(
    formula: &Fraction,
    variable: &Symbol,
    bounds: Option<(&Fraction, &Fraction)>,
) -> Result<Fraction> {
    let primitive = Coefficients::new(coefficients_in(formula, variable)?).antiderivative();
    Ok(match bounds {
        Some((a, b)) => primitive.value(b).minus(&primitive.value(a)),
        None => primitive.value(&Fraction::from(MultiPoly::symbol(variable.clone()))),
    })
}

/// F ∘ G of functions or formulas.
pub(crate) fn compose(outer: &Value, inner: &Value) -> Result<Value> {
    let parts = |value: &Value| -> Result<(Symbol, Fraction)> {
        match value {
            Value::Function(f) => f
                .as_formula()
                .map(|(t, formula)| (t.clone(), formula.clone()))
                .ok_or_else(|| wrong_kind("a function of one variable given by one formula", value)),
            Value::Scalar(formula) => Ok((variable_of(formula, None)?, formula.clone())),
            other => Err(wrong_kind("a function", other)),
        }
    };
    let scalars = matches!((outer, inner), (Value::Scalar(_), Value::Scalar(_)));
    let (variable, formula) = parts(outer)?;
    let (inner_variable, inner_formula) = parts(inner)?;
    let result = formula.substitute(&[(variable, inner_formula)]).map_err(|_| division_by_zero())?;
    Ok(if scalars { Value::Scalar(result) } else { formula_function(inner_variable, result) })
}
