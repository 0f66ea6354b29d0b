//! The names defined so far.

use std::sync::Arc;

use crate::language::value::{Scope, Value};
use crate::math::poly::Symbol;

/// The names defined so far. Cloning is cheap.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Env {
    pub(super) names: Scope,
}

impl Env {
    /// The value of a name, if it is defined.
    pub fn get(&self, name: &Symbol) -> Option<&Value> {
        self.names.get(name)
    }

    /// Defines or redefines a name.
    pub fn set(&mut self, name: Symbol, value: Value) {
        Arc::make_mut(&mut self.names).insert(name, value);
    }

    /// Forgets a name; says whether it was defined.
    pub fn remove(&mut self, name: &Symbol) -> bool {
        Arc::make_mut(&mut self.names).remove(name).is_some()
    }

    /// All defined names in natural order.
    pub fn iter(&self) -> impl Iterator<Item = (&Symbol, &Value)> {
        self.names.iter()
    }
}
