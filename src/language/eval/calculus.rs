//! Derivatives, integrals, composition and values at a bar, as they are written.

use super::arguments::Arguments;
use super::machine::{Evaluated, Machine};
use super::names::name_of;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::calculus;
use crate::language::ops::errors::{division_by_zero, unsupported, wrong_kind};
use crate::language::ops::formula::{symbol_of, variable_of};
use crate::language::value::Value;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;

impl Machine {
    /// The bare symbol an expression names, for binding it.
    pub(crate) fn binder(&mut self, expr: &Expr) -> Result<Symbol, Diagnostic> {
        name_of(expr, self).ok_or_else(|| {
            Diagnostic::error(Code::BadDefinition, "expected a variable").at(expr.span).reason("not a name")
        })
    }

    pub(crate) fn eval_scalar(&mut self, expr: &Expr) -> Result<Fraction, Diagnostic> {
        match self.eval(expr)? {
            Value::Scalar(x) => Ok(x),
            other => Err(wrong_kind("a number or formula", &other).at(expr.span)),
        }
    }

    /// F^(k) of a value; of a curve or surface by the function of that name.
    pub(super) fn derivative_of(&mut self, value: &Value, order: usize, span: Span) -> Evaluated {
        if let Value::List(coordinates) = self.in_coordinates(value.clone()) {
            let each = coordinates.iter().map(|coordinate| self.derivative_of(coordinate, order, span));
            return each.collect::<Result<_, _>>().map(|values| Value::List(coordinates.with(values)));
        }
        if !matches!(value, Value::Geometry(_) | Value::Piecewise(_)) {
            return calculus::derivative(value, order).at(span);
        }
        let mut arguments = Arguments::default();
        arguments.push(value.clone(), span);
        arguments.push(Value::int(order as i64), span);
        self.call_function("derivative", arguments).at(span)
    }

    /// F ∘ G; what a curve is composed with says the function of that name.
    pub(super) fn compose(&mut self, outer: Value, inner: Value, span: Span) -> Evaluated {
        if !matches!(outer, Value::Geometry(_) | Value::Piecewise(_)) {
            return calculus::compose(&outer, &inner).at(span);
        }
        let mut arguments = Arguments::default();
        arguments.push(outer, span);
        arguments.push(inner, span);
        self.call_function("compose", arguments).at(span)
    }

    pub(crate) fn eval_integral(
        &mut self,
        lower: Option<&Expr>,
        upper: Option<&Expr>,
        body: &Expr,
        variable: &Expr,
    ) -> Evaluated {
        let name = self.binder(variable)?;
        let bounds = match (lower, upper) {
            (Some(a), Some(b)) => Some((self.eval_scalar(a)?, self.eval_scalar(b)?)),
            (None, None) => None,
            (Some(one), None) | (None, Some(one)) => {
                return Err(unsupported("an integral with one bound only").at(one.span));
            }
        };
        let own = Value::symbol(name.clone());
        let integrand = self.with_locals([(name.clone(), own)], |machine| machine.eval_scalar(body))?;
        let bounds = bounds.as_ref().map(|(a, b)| (a, b));
        calculus::integrate(&integrand, &name, bounds).map(Value::Scalar).at(body.span)
    }

    pub(crate) fn eval_derivative(
        &mut self,
        variables: &[(Expr, Option<Expr>)],
        body: Option<&Expr>,
        span: Span,
    ) -> Evaluated {
        let Some(body) = body else {
            return Err(unsupported("a differential operator without a function").at(span));
        };
        let mut orders = Vec::with_capacity(variables.len());
        for (variable, order) in variables {
            let order = match order {
                Some(order) => self.eval_int(order)?,
                None => 1,
            };
            let order = usize::try_from(order).map_err(|_| {
                Diagnostic::error(Code::BadExponent, "a negative order of differentiation").at(span)
            })?;
            orders.push((self.binder(variable)?, order));
        }
        let own: Vec<(Symbol, Value)> =
            orders.iter().map(|(name, _)| (name.clone(), Value::symbol(name.clone()))).collect();
        // θ(x) is no product where it is differentiated by x.
        if let Kind::Apply(callee, groups) = &body.kind
            && let [(variable, _)] = variables
            && matches!(groups.as_slice(), [group] if group.len() == 1 && group[0].same_as(variable))
            && !callee.same_as(variable)
            && let Some(name) = name_of(callee, self).filter(|_| !self.has_reading())
            && self.lookup(&name).is_none()
            && name.is_plain()
            && (self.tools.function)(name.base()).is_none()
        {
            return Err(Diagnostic::error(Code::AmbiguousProduct, format!("'{name}' has no value here"))
                .at(callee.span)
                .reason("what is differentiated?")
                .hint(format!("define it first: {name}(t) := ...")));
        }
        let value = self.with_locals(own, |machine| machine.eval(body))?;
        // ∂u/∂ξ, where u was given by x and y, is not 0, nor is d/dx f(2).
        let written = |variable: &Expr| body.has(&|part| part.same_as(variable));
        if self.has_reading()
            && body.has(&|part| matches!(part.kind, Kind::Name(_)))
            && let Value::Scalar(formula) = &value
            && let Some(((variable, _), _)) =
                orders.iter().zip(variables).find(|((name, _), (as_written, _))| {
                    !formula.variables().contains(name) && !written(as_written)
                })
        {
            let message = format!("how this depends on {variable} is not said");
            return Err(Diagnostic::error(Code::UnknownName, message).at(body.span));
        }
        // The derivative of an undefined F is not 0.
        if let (Some(symbol), Some(name)) = (symbol_of(&value), name_of(body, self))
            && symbol == name
            && !orders.iter().any(|(variable, _)| *variable == symbol)
        {
            return Err(Diagnostic::error(Code::UnknownName, format!("'{symbol}' is not defined"))
                .at(body.span)
                .reason("what is differentiated?")
                .hint(format!("define it first: {symbol}(t) := ...")));
        }
        if let Value::Function(function) = &value
            && let Some(partial) = self.partial_of(function, &orders)
        {
            return Ok(partial);
        }
        if let (Value::Function(_) | Value::Polar(_), [(_, order)]) = (&value, orders.as_slice()) {
            return calculus::derivative(&value, *order).at(body.span);
        }
        let Value::Scalar(mut result) = value else {
            return Err(wrong_kind("a formula or function to differentiate", &value).at(body.span));
        };
        for (name, order) in &orders {
            result = calculus::nth_derivative(&result, name, *order);
        }
        // Outside the operator the variables have their own values again.
        let bound: Vec<(Symbol, Fraction)> = orders
            .iter()
            .filter_map(|(name, _)| Some((name.clone(), self.lookup(name)?.as_scalar()?.clone())))
            .collect();
        result.substitute(&bound).map(Value::Scalar).map_err(|_| division_by_zero()).at(span)
    }

    pub(crate) fn eval_at(
        &mut self,
        body: &Expr,
        lower: &[Expr],
        upper: Option<&Expr>,
        span: Span,
    ) -> Evaluated {
        if let Some(upper) = upper {
            return self.eval_between(body, lower, upper, span);
        }
        let mut names = Vec::new();
        for piece in lower {
            let Kind::Chain(left, links) = &piece.kind else {
                return Err(unsupported("expected t = value at the bar").at(piece.span));
            };
            let Some(last) = links.last() else { continue };
            let value = self.eval_scalar(&last.expr)?;
            names.push((self.binder(left)?, value.clone()));
            for link in &links[..links.len() - 1] {
                if link.expr.kind != Kind::Ellipsis {
                    names.push((self.binder(&link.expr)?, value.clone()));
                }
            }
        }
        let own: Vec<(Symbol, Value)> =
            names.iter().map(|(name, _)| (name.clone(), Value::symbol(name.clone()))).collect();
        let formula = self.with_locals(own, |machine| match machine.eval(body)? {
            // dF/dt is a function; its variable is the one at the bar
            Value::Function(function) => match (function.as_formula(), names.as_slice()) {
                (Some((own, formula)), [(name, _)]) => formula
                    .substitute(&[(own.clone(), Fraction::from(MultiPoly::symbol(name.clone())))])
                    .map_err(|_| division_by_zero()),
                _ => Err(wrong_kind("a formula", &Value::Function(function))),
            },
            Value::Scalar(formula) => Ok(formula),
            other => Err(wrong_kind("a number or formula", &other)),
        });
        let formula = formula.at(body.span)?;
        formula.substitute(&names).map(Value::Scalar).map_err(|_| division_by_zero()).at(span)
    }

    /// [F(t)]_a^b = F(b) - F(a).
    fn eval_between(&mut self, body: &Expr, lower: &[Expr], upper: &Expr, span: Span) -> Evaluated {
        let [from] = lower else {
            return Err(unsupported("several lower bounds at a bar").at(span));
        };
        let (given, from) = match &from.kind {
            Kind::Chain(left, links) => (Some(self.binder(left)?), &links[links.len() - 1].expr),
            _ => (None, from),
        };
        let upper = match &upper.kind {
            Kind::Chain(_, links) => &links[links.len() - 1].expr,
            _ => upper,
        };
        let (a, b) = (self.eval_scalar(from)?, self.eval_scalar(upper)?);
        let own = given.iter().map(|name| (name.clone(), Value::symbol(name.clone())));
        let formula = self.with_locals(own.collect::<Vec<_>>(), |machine| machine.eval_scalar(body))?;
        let variable = variable_of(&formula, given).at(body.span)?;
        let at = |x| formula.substitute(&[(variable.clone(), x)]).map_err(|_| division_by_zero());
        Ok(Value::Scalar(at(b).at(span)?.minus(&at(a).at(span)?)))
    }
}
