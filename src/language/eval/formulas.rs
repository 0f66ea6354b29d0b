//! Calls of formulas: after `p = t^2 + 2t`, `p(3)` is 15.
//!
//! A name that the input gave a formula in one of the usual parameters is a function of it, and a
//! note says so. A number or symbol before a parenthesis is a factor.

use super::machine::{Evaluated, Machine};
use super::names::name_of;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::lexicon::roles;
use crate::language::ops::errors::division_by_zero;
use crate::language::ops::formula::{is_parameter, symbol_of, variable_of};
use crate::language::value::Value;
use crate::math::poly::Symbol;

/// What a parenthesis after a formula does.
pub(super) enum Called {
    /// Its variable takes a value.
    At(Symbol),
    /// It has the same value everywhere.
    Constant,
}

impl Machine {
    /// What the parenthesis after `callee` does, whose value is a formula; `None` for a product.
    ///
    /// # Errors
    /// It may be either.
    pub(super) fn called_formula(
        &mut self,
        value: &Value,
        callee: &Expr,
    ) -> Result<Option<Called>, Diagnostic> {
        let Some(formula) = value.as_scalar().filter(|_| self.reading.is_none()) else { return Ok(None) };
        // p'(3): what depends on the variable of p
        if let Kind::Prime(base, _) = &callee.kind {
            let base = self.eval(base)?;
            let Some(base) = base.as_scalar() else { return Ok(None) };
            let variable = variable_of(base, None).at(callee.span)?;
            return Ok(Some(Called::At(variable)));
        }
        let Some(name) = name_of(callee, self) else { return Ok(None) };
        let local = self.locals.iter().any(|(local, _)| *local == name);
        if local || self.lookup(&name).is_none() || symbol_of(value).is_some() {
            return Ok(None);
        }
        let is_function = name.base().chars().next().is_some_and(char::is_uppercase)
            || roles::FUNCTIONS.contains(&name.base());
        if value.as_rational().is_some() {
            return Ok(is_function.then_some(Called::Constant));
        }
        match variable_of(formula, None) {
            Ok(variable) if is_parameter(&variable) && formula.variables().contains(&variable) => {
                Ok(Some(Called::At(variable)))
            }
            Ok(variable) if !is_function && !formula.variables().contains(&variable) => Ok(None),
            _ => Err(Diagnostic::error(
                Code::AmbiguousProduct,
                format!("{name} is a formula, not a function: is this its value or a product?"),
            )
            .at(callee.span)
            .reason(format!("{name} was defined without an argument"))
            .hint(format!("define it as a function: {name}(t) := ..."))
            .hint(format!("or write {name} * (...) for the product"))),
        }
    }

    /// The value of a formula at an argument.
    pub(super) fn call_formula(
        &mut self,
        called: &Called,
        value: &Value,
        callee: &Expr,
        argument: &Expr,
        span: Span,
    ) -> Evaluated {
        let (Called::At(variable), Value::Scalar(formula)) = (called, value) else {
            return Ok(value.clone());
        };
        let at = self.eval_scalar(argument)?;
        if let Some(name) = name_of(callee, self) {
            self.note(
                Diagnostic::note(Code::Called, format!("{name} is called as a function of {variable}"))
                    .at(callee.span)
                    .hint(format!("write {name} * (...) for the product")),
            );
        }
        formula
            .substitute(&[(variable.clone(), at)])
            .map(Value::Scalar)
            .map_err(|_| division_by_zero())
            .at(span)
    }
}
