//! Values in the arrangement that was asked for.

use std::sync::Arc;

use super::Value;
use crate::formula::Expr;

/// A value, and the formula that shows it: (t - 1)^2 + 2 (t - 1) for t^2 - 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Written {
    /// What is calculated with.
    pub value: Value,
    /// How it is shown.
    pub expr: Expr,
}

impl Value {
    /// A value that is shown as `expr` where it is the answer; in further calculations it is itself.
    pub fn written(value: Value, expr: Expr) -> Self {
        Value::Written(Arc::new(Written { value, expr }))
    }

    /// The value without its arrangement.
    pub fn plain(self) -> Self {
        match self {
            Value::Written(written) => written.value.clone(),
            value => value,
        }
    }
}
