//! Functions of functions that the page defines: λ_i(f) = f(t_i), ⟨f, g⟩ = ∫ f(t) g(t) dt.

use super::{Evaluated, Model};
use crate::formula::{Expr, Kind};
use crate::judge::page::context::{Body, Definition};
use crate::judge::written::names::{Head, integer_names};
use crate::language::eval::Machine;
use crate::language::value::Value;
use crate::math::poly::Symbol;

impl Model {
    /// λ_i(f) = f(t_i), ⟨f, g⟩ = ∫ f(t) g(t) dt at functions: these stand in the places of f and g.
    pub(super) fn functional(
        &self,
        machine: &mut Machine,
        callee: &Expr,
        groups: &[Vec<Expr>],
    ) -> Option<Evaluated> {
        let head = Head::of(callee)?;
        let given: Vec<&Expr> = groups.iter().flatten().collect();
        let context = self.context.clone();
        let fits = |definition: &Definition| {
            let Body::Formula(body) = &definition.body else { return None };
            let own = definition.head.flat();
            if own.len() != given.len() || own.is_empty() {
                return None;
            }
            let names = own.iter().map(|argument| match &argument.kind {
                Kind::Name(name) if applies(body, name) => Some(name.clone()),
                _ => None,
            });
            Some((names.collect::<Option<Vec<String>>>()?, body.clone()))
        };
        let plain = Head { arguments: None, ..head.clone() };
        let found = context.visible(&head.base, &self.place).find_map(|(number, definition, near)| {
            let (names, body) = fits(definition)?;
            let (bound, _) = self.matches(machine, definition, &plain, None)?;
            Some((number, near, names, body, bound))
        });
        let (number, near, names, mut body, bound) = found?;
        if !given.iter().all(|function| Head::of(function).is_some() && self.is_function(machine, function)) {
            return None;
        }
        for (name, function) in names.iter().zip(given) {
            let mut function = function.clone();
            for index in integer_names(&function) {
                if let Some(value) = machine.lookup(&Symbol::new(&index)).and_then(Value::as_int) {
                    function = function.with_name(&index, &Expr::int(value));
                }
            }
            body = body.with_name(name, &function);
        }
        self.record.borrow_mut().definitions.insert((number, near));
        Some(machine.with_locals(bound, |machine| machine.eval(&body)))
    }
}

/// Whether a formula applies a name to something.
pub(in crate::judge) fn applies(body: &Expr, name: &str) -> bool {
    body.has(&|part| {
        let callee = match &part.kind {
            Kind::Apply(callee, _) => callee,
            _ => return false,
        };
        let function = match &callee.kind {
            Kind::Prime(inner, _) => inner,
            _ => callee,
        };
        Head::of(function).is_some_and(|head| head.base == name && head.lower.is_empty())
    })
}
