//! Claims between a function and a formula.
//!
//! A polar form is compared with a formula in its arguments, a function or a curve with a formula in
//! its parameter: `polar(t^2) = t1 t2` means `polar(t^2)(t1, t2) = t1 t2`, and a note says so.

use super::machine::Machine;
use super::names::name_of;
use crate::formula::{Expr, Kind, Link, Rel};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::ops::formula::is_parameter;
use crate::language::ops::lists::is_curve;
use crate::language::value::{Parameter, PolarKind, Value, symbol_expr};
use crate::language::write::text;
use crate::math::poly::{Fraction, Symbol};

impl Machine {
    /// The chain with its functions called at their parameters, where other sides are formulas in
    /// these; `None` if nothing has to be called.
    pub(super) fn of_one_kind(&mut self, first: &Expr, links: &[Link]) -> Option<(Expr, Vec<Link>)> {
        let equation = |link: &Link| matches!(link.rel, Rel::Eq | Rel::Equiv | Rel::Ne);
        if self.reading.is_some() || !links.iter().all(equation) {
            return None;
        }
        let sides: Vec<&Expr> = std::iter::once(first).chain(links.iter().map(|link| &link.expr)).collect();
        if !sides.iter().any(|side| self.names_a_function(side)) {
            return None;
        }
        let mut values: Vec<Value> = sides.iter().map(|side| self.quietly(side)).collect::<Option<_>>()?;
        let mut symbols: Vec<Symbol> = Vec::new();
        for value in &values {
            match value {
                Value::Scalar(formula) => symbols.extend(formula.variables()),
                Value::List(items) => {
                    let formulas: Option<Vec<&Fraction>> = items.iter().map(Value::as_scalar).collect();
                    symbols.extend(formulas.into_iter().flatten().flat_map(Fraction::variables));
                }
                _ => {}
            }
        }
        symbols.sort();
        symbols.dedup();
        if !values.iter().any(|value| matches!(value, Value::Scalar(_)) || is_point(value)) {
            return None;
        }
        // F = b_0 B_0^1 + b_1 B_1^1, where members of families are functions, too
        for (side, value) in sides.iter().zip(&mut values) {
            if matches!(value, Value::Scalar(_))
                && let Some(function @ Value::Function(_)) = self.quietly_called(side)
            {
                *value = function;
            }
        }
        if !values.iter().any(|value| matches!(value, Value::Scalar(_)) || is_point(value)) {
            symbols = values.iter().find_map(own_parameter).into_iter().collect();
        }
        let mut called = Vec::with_capacity(sides.len());
        let mut read = None;
        for (side, value) in sides.iter().zip(&values) {
            called.push(match self.call_at_parameters(side, value, &symbols) {
                Some(call) => {
                    self.quietly(&call)?;
                    read.get_or_insert_with(|| call.clone());
                    call
                }
                None => (*side).clone(),
            });
        }
        let read = read?;
        let note = format!("compared at its parameters: {}", text(&read));
        self.note(Diagnostic::note(Code::Called, note).at(read.span));
        let mut called = called.into_iter();
        let first = called.next()?;
        let links = links.iter().zip(called).map(|(link, expr)| Link { expr, ..link.clone() }).collect();
        Some((first, links))
    }

    /// The value of a side, without remarks; `None` if it has none.
    fn quietly(&mut self, side: &Expr) -> Option<Value> {
        let before = self.notes.clone();
        let value = self.eval(side).ok();
        self.notes = before;
        value
    }

    /// The same where members of families are functions: B_0^1 is B_0^1(t).
    fn quietly_called(&mut self, side: &Expr) -> Option<Value> {
        let before = std::mem::replace(&mut self.called, true);
        let value = self.quietly(side);
        self.called = before;
        value
    }

    /// Whether something in a formula has a value that can be called, or is a function of the program.
    fn names_a_function(&mut self, expr: &Expr) -> bool {
        if matches!(expr.kind, Kind::Name(_) | Kind::Subscript(..) | Kind::Upper(..))
            && let Some(name) = name_of(expr, self)
        {
            return match self.lookup(&name) {
                Some(Value::List(items)) => is_curve(items),
                Some(value) => !matches!(value, Value::Scalar(_) | Value::Vector(_) | Value::Matrix(_)),
                None => name.is_plain() && (self.tools.function)(name.base()).is_some(),
            };
        }
        let mut children = Vec::new();
        expr.for_each_child(&mut |child| children.push(child));
        children.into_iter().any(|child| self.names_a_function(child))
    }

    /// A function called with the names of its parameters, if the formulas it is compared with have
    /// no others, and none of them has a value.
    fn call_at_parameters(&self, side: &Expr, value: &Value, symbols: &[Symbol]) -> Option<Expr> {
        let callee = match side.kind {
            Kind::Name(_) | Kind::Subscript(..) | Kind::Apply(..) => side.clone(),
            _ => side.clone().grouped(),
        };
        let (call, parameters, constants) = match value {
            Value::Polar(polar) => {
                let parameters = polar.arguments().concat().concat();
                (polar.call(callee), parameters, constants_of(&polar.kind))
            }
            Value::List(items) if is_curve(items) => {
                return self.call_at_parameters(side, &items[0], symbols);
            }
            Value::Function(function) => {
                let [clause] = function.clauses.as_slice() else { return None };
                let name = |parameter: &Parameter| match parameter {
                    Parameter::Name(name) => Some(name.clone()),
                    Parameter::Exactly(_) => None,
                };
                let mut parameters: Vec<Symbol> =
                    clause.parameters.iter().map(name).collect::<Option<_>>()?;
                let constants = clause.formula.as_ref().map(Fraction::variables).unwrap_or_default();
                let constants: Vec<Symbol> =
                    constants.into_iter().filter(|symbol| !parameters.contains(symbol)).collect();
                if let [parameter] = parameters.as_mut_slice() {
                    *parameter = parameter_among(symbols, &constants, parameter);
                }
                let arguments = parameters.iter().map(symbol_expr).collect();
                (Expr::apply(callee, arguments), parameters, Some(constants))
            }
            Value::Geometry(geometry) if !geometry.is_surface() => {
                let parameter = parameter_among(symbols, &[], &geometry.parameter());
                (Expr::apply(callee, vec![symbol_expr(&parameter)]), vec![parameter], None)
            }
            _ => return None,
        };
        let free = |name: &Symbol| self.lookup(name).is_none();
        // A further name may be an argument under another name: polar(t^2) = a b.
        let known = |symbol: &Symbol| {
            parameters.contains(symbol)
                || constants.as_ref().is_none_or(|constants| constants.contains(symbol))
        };
        let fits = parameters.iter().all(free) && symbols.iter().all(known);
        fits.then_some(Expr { span: side.span, ..call })
    }
}

/// The one usual parameter among the symbols of a formula, if there is one that is no constant here;
/// else the parameter of the function.
fn parameter_among(symbols: &[Symbol], constants: &[Symbol], own: &Symbol) -> Symbol {
    let mut usual = symbols.iter().filter(|symbol| is_parameter(symbol) && !constants.contains(symbol));
    match (symbols.contains(own), usual.next(), usual.next()) {
        (false, Some(one), None) => one.clone(),
        _ => own.clone(),
    }
}

/// The parameter of a function of one variable by a formula.
fn own_parameter(value: &Value) -> Option<Symbol> {
    match value {
        Value::Function(function) => function.as_formula().map(|(parameter, _)| parameter.clone()),
        _ => None,
    }
}

/// The symbols in the coefficients of a form; `None` if they are not looked at.
fn constants_of(kind: &PolarKind) -> Option<Vec<Symbol>> {
    match kind {
        PolarKind::Univariate(form) => {
            Some(form.coefficients().iter().flat_map(Fraction::variables).collect())
        }
        _ => None,
    }
}

fn is_point(value: &Value) -> bool {
    matches!(value, Value::List(items) if items.iter().all(|item| matches!(item, Value::Scalar(_))))
}
