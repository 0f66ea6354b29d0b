//! The functions of the table as the evaluator calls them.

use super::on_geometry::method;
use super::{BUILTINS, Builtin, COORDINATEWISE, WORD_ARGUMENTS, WORD_FIRST, builtin};
use crate::language::eval::{Arguments, Callable, Evaluated, Machine, Slot};
use crate::language::ops::polar::levelled;
use crate::language::value::Value;

/// The function of that name, for the evaluator.
pub(crate) fn callable(name: &str) -> Option<&'static dyn Callable> {
    builtin(name).map(|builtin| builtin as &dyn Callable)
}

/// The names of all functions.
pub(crate) fn names() -> Vec<&'static str> {
    BUILTINS.iter().map(|builtin| builtin.name).collect()
}

impl Callable for Builtin {
    fn name(&self) -> &'static str {
        self.name
    }

    fn form(&self) -> String {
        self.signature.to_owned()
    }

    fn takes_word(&self, slot: Slot, _: &str, _: bool) -> bool {
        match slot {
            Slot::Name(name) => WORD_ARGUMENTS.contains(&name),
            Slot::Place(place) => place == 0 && WORD_FIRST.contains(&self.name),
        }
    }

    /// As it applies to the kind of the first argument.
    fn run(&self, machine: &mut Machine, arguments: Arguments) -> Evaluated {
        let Some(first) = arguments.values().next() else { return (self.call)(machine, &arguments) };
        if let Some(method) = method(self.name, first) {
            return method(&arguments);
        }
        let Value::List(items) = first else { return (self.call)(machine, &arguments) };
        if !COORDINATEWISE.contains(&self.name) {
            return (self.call)(machine, &arguments);
        }
        let each = items.iter().map(|item| {
            let own = arguments.with_first(item.clone());
            method(self.name, item).map_or_else(|| (self.call)(machine, &own), |method| method(&own))
        });
        each.collect::<Result<_, _>>().map(|list| Value::List(levelled(list)))
    }
}
