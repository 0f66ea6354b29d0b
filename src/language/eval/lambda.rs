//! Functions by their parameters and bodies.

use std::sync::Arc;

use super::machine::{Evaluated, Machine};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Rel};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::ops::function::{formula_function, function_of};
use crate::language::value::{Clause, Function, Parameter, Shape, Value};
use crate::math::poly::Symbol;

/// `t ↦ …`, nothing else.
pub(super) fn is_mapping(links: &[Link]) -> bool {
    matches!(links, [link] if link.rel == Rel::MapsTo)
}

/// t, or u and v of (u, v).
pub(super) fn parameters_of(expr: &Expr) -> &[Expr] {
    match &expr.kind {
        Kind::Tuple(items) => items,
        Kind::Group(inner) => parameters_of(inner),
        _ => std::slice::from_ref(expr),
    }
}

impl Machine {
    pub(crate) fn eval_lambda(&mut self, parameters: &[Expr], body: &Expr) -> Evaluated {
        let mut names = Vec::with_capacity(parameters.len());
        for parameter in parameters {
            names.push(self.binder(parameter)?);
        }
        let clause = self.clause(names.iter().cloned().map(Parameter::Name).collect(), body)?;
        Ok(Value::Function(Arc::new(Function {
            name: None,
            shape: Shape::plain(names.len()),
            clauses: vec![clause],
        })))
    }

    /// A function whose values are points, c(t) := (t^2, t^3), as the list of its coordinates;
    /// anything else as it is.
    pub(super) fn in_coordinates(&mut self, value: Value) -> Value {
        let Value::Function(function) = &value else { return value };
        let [Clause { parameters, formula: None, .. }] = function.clauses.as_slice() else { return value };
        let [Parameter::Name(parameter)] = parameters.as_slice() else {
            return self.coordinates_of(&function.clone()).map_or(value, Value::point);
        };
        let (parameter, before) = (parameter.clone(), self.notes.len());
        let point =
            self.call(function, vec![(Value::symbol(parameter.clone()), Span::default())], Span::default());
        self.notes.truncate(before);
        let Some(items) = point.ok().and_then(Value::coordinates) else { return value };
        let coordinate = |item: Value| match item {
            Value::Scalar(formula) => Some(formula_function(parameter.clone(), formula)),
            _ => None,
        };
        items.into_iter().map(coordinate).collect::<Option<_>>().map_or(value, Value::point)
    }

    /// The coordinates, as functions of the same variables, of a function of several variables whose values are
    /// points: r(u, v) := (u, v, u v).
    pub(super) fn coordinates_of(&mut self, function: &Function) -> Option<Vec<Value>> {
        let [Clause { parameters, formula: None, .. }] = function.clauses.as_slice() else { return None };
        let name = |parameter: &Parameter| match parameter {
            Parameter::Name(name) => Some(name.clone()),
            Parameter::Exactly(_) => None,
        };
        let names: Vec<Symbol> = parameters.iter().map(name).collect::<Option<_>>()?;
        let notes = self.notes.len();
        let symbols = names.iter().map(|name| (Value::symbol(name.clone()), Span::default())).collect();
        let point = self.call(&Arc::new(function.clone()), symbols, Span::default());
        self.notes.truncate(notes);
        let items = point.ok().and_then(Value::coordinates)?;
        let coordinate = |item: Value| match item {
            Value::Scalar(formula) => Some(function_of(names.clone(), formula)),
            _ => None,
        };
        items.into_iter().map(coordinate).collect()
    }

    /// A clause with the value of its body, if that exists for symbolic parameters. Unknown words in
    /// the body are reported where they are written, not when the function is called.
    pub(crate) fn clause(&mut self, parameters: Vec<Parameter>, body: &Expr) -> Result<Clause, Diagnostic> {
        let symbols: Vec<(Symbol, Value)> = parameters
            .iter()
            .filter_map(|parameter| match parameter {
                Parameter::Name(symbol) => Some((symbol.clone(), Value::symbol(symbol.clone()))),
                Parameter::Exactly(_) => None,
            })
            .collect();
        let notes = self.notes.len();
        // In b_i the parameter i chooses a name; there is no formula to put its value into.
        let chooses = symbols.iter().any(|(name, _)| is_index_in(name, body));
        let answers = std::mem::take(&mut self.answers);
        let value = self.with_locals(symbols, |machine| machine.eval(body));
        self.answers = answers;
        let formula = match value {
            Ok(Value::Scalar(formula)) if !chooses => Some(formula),
            Err(error) if matches!(error.code, Code::UnknownName | Code::UnknownFunction) => {
                return Err(error);
            }
            _ => None,
        };
        // What the body was read as is told here, once; the rest when the function is called.
        let told = self.notes.split_off(notes);
        self.notes.extend(told.into_iter().filter(|note| note.code == Code::Letters));
        let mut scope = self.scope.clone();
        for (name, value) in &self.locals {
            Arc::make_mut(&mut scope).insert(name.clone(), value.clone());
        }
        Ok(Clause { parameters, body: body.clone(), written: false, formula, scope })
    }
}

/// Whether a name occurs within the index of another: i in b_i, n - i in p_{n-i}.
fn is_index_in(name: &Symbol, expr: &Expr) -> bool {
    fn search(name: &Symbol, expr: &Expr, within: bool) -> bool {
        match &expr.kind {
            Kind::Name(other) => within && *name == Symbol::new(other),
            Kind::Subscript(base, indices) | Kind::Upper(base, indices) => {
                search(name, base, within) || indices.iter().any(|index| search(name, index, true))
            }
            _ => {
                let mut found = false;
                expr.for_each_child(&mut |child| found = found || search(name, child, within));
                found
            }
        }
    }
    search(name, expr, false)
}
