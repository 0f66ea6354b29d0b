//! Calls of formulas: after `p = t^2 + 2t`, `p(3)` is 15.
//!
//! A name that the input gave a formula in one of the usual parameters is a function of it, and a
//! note says so. A number or symbol before a parenthesis is a factor.

use super::machine::{Evaluated, Machine};
use super::names::name_of;
use super::tools::Callable;
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

    /// The value at `argument` of a formula that something has computed: derivative(t^3)(2). `None` if the
    /// parenthesis is a factor.
    ///
    /// # Errors
    /// It may be either.
    pub(super) fn value_of_result(
        &mut self,
        value: &Value,
        callee: &Expr,
        argument: &Expr,
        span: Span,
    ) -> Result<Option<Value>, Diagnostic> {
        let Some(formula) = value.as_scalar().filter(|_| self.reading.is_none()) else { return Ok(None) };
        let function = self.called_function(callee);
        // lagrange_basis([0, 1, 2])[1](2)
        let item = self.is_item(callee);
        if function.is_none() && !item && !self.is_computed(callee) {
            return Ok(None);
        }
        let alone = matches!(argument.kind, Kind::Name(_) | Kind::Subscript(..)) || is_numeric(argument);
        let ambiguous = |reason: String| {
            Diagnostic::error(Code::AmbiguousProduct, "is this the value of the result or a product?")
                .at(argument.span)
                .reason(reason)
        };
        let product = "write * (...) for the product";
        if formula.as_rational().is_some() {
            // lagrange([0, 1], [5, 5])(2): a function that happens to be constant.
            if !function.is_some_and(|function| function.gives_function()) {
                return match item && alone && name_of(callee, self).is_some() {
                    true => Err(ambiguous("this item of the list is constant".to_owned()).hint(product)),
                    false => Ok(None),
                };
            }
            if !alone {
                return Err(ambiguous("the result is constant".to_owned()).hint(product));
            }
            let note =
                Diagnostic::note(Code::Called, "the result, which is constant, is called as a function");
            self.note(note.at(span).hint(product));
            return Ok(Some(value.clone()));
        }
        let Ok(variable) = variable_of(formula, None) else { return Ok(None) };
        if !is_parameter(&variable) || !formula.variables().contains(&variable) {
            return Ok(None);
        }
        if !alone && (function.is_some() || item) {
            return Err(ambiguous(format!("the result is a formula in {variable}"))
                .hint(format!("write subs(..., {variable}=...) for the value"))
                .hint(format!("or {product}")));
        }
        if !alone {
            return Ok(None);
        }
        let at = self.eval_scalar(argument)?;
        self.note(
            Diagnostic::note(Code::Called, format!("the result is called as a function of {variable}"))
                .at(span)
                .hint(product),
        );
        let value = formula.substitute(&[(variable, at)]).map_err(|_| division_by_zero()).at(span)?;
        Ok(Some(Value::Scalar(value)))
    }

    /// A remark on (t^2 + 1)(3), which may be meant as a value.
    pub(super) fn note_product_by_number(&mut self, value: &Value, span: Span) {
        let Some(formula) = value.as_scalar().filter(|_| self.reading.is_none()) else { return };
        if let Some(variable) = formula.variables().into_iter().find(is_parameter) {
            self.note(
                Diagnostic::note(Code::Called, "read as a product, not as a value")
                    .at(span)
                    .hint(format!("the value is subs(..., {variable}=...)")),
            );
        }
    }

    /// Whether an expression is a sum, an integral, a composition or a derivative, which may stand in parentheses.
    fn is_computed(&mut self, expr: &Expr) -> bool {
        let derivative = |machine: &mut Self, expr: &Expr| match &expr.kind {
            Kind::Derivative { .. } => true,
            Kind::Mul(factors) => machine.differential(factors, expr.span).is_some(),
            _ => false,
        };
        match &expr.kind {
            Kind::Group(inner) => derivative(self, inner),
            Kind::Big { .. } | Kind::Integral { .. } | Kind::Compose(_) => true,
            _ => derivative(self, expr),
        }
    }

    /// Whether an expression is an item of a list: p_1 and p[1] of a list p, bernstein(2)[1].
    pub(super) fn is_item(&mut self, expr: &Expr) -> bool {
        let Kind::Subscript(base, _) = &expr.kind else { return false };
        match name_of(base, self) {
            Some(name) => matches!(self.lookup(&name), Some(Value::List(_))),
            None => matches!(base.kind, Kind::Apply(..) | Kind::List(_)),
        }
    }

    /// The function of the program of which an expression is the call.
    fn called_function(&self, expr: &Expr) -> Option<&'static dyn Callable> {
        let Kind::Apply(callee, _) = &expr.kind else { return None };
        let Kind::Name(name) = &callee.kind else { return None };
        (self.tools.function)(name).filter(|_| self.lookup(&Symbol::new(name)).is_none())
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

/// Whether an expression is a number as written: 2, 1/2, -3.
fn is_numeric(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Number(_) => true,
        Kind::Div(above, below, _) => is_numeric(above) && is_numeric(below),
        Kind::Add(terms) => matches!(terms.as_slice(), [term] if is_numeric(&term.expr)),
        _ => false,
    }
}
