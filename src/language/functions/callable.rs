//! The functions of the table as the evaluator calls them.

use super::record::Builtin;
use super::table::{BUILTINS, builtin};
use crate::language::eval::{Arguments, Callable, Evaluated, Machine, Slot};

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
        self.signature()
    }

    fn takes_word(&self, slot: Slot, word: &str, defined: bool) -> bool {
        match slot {
            Slot::Place(place) => self.takes_word_at(place, word, defined),
            Slot::Name(name) => self.takes_word_under(name, word, defined),
        }
    }

    fn run(&self, machine: &mut Machine, arguments: Arguments) -> Evaluated {
        Builtin::run(self, machine, arguments)
    }
}
