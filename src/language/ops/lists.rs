//! Lists of values: claims side by side, vectors, curves by their coordinates.

use std::sync::Arc;

use super::errors::unsupported;
use crate::language::diagnostic::Diagnostic;
use crate::language::value::{Claim, Value};

/// A list of values; several claims side by side are one claim with all their relations.
pub(crate) fn together(values: Vec<Value>) -> Result<Value, Diagnostic> {
    let claims = values.iter().filter(|value| matches!(value, Value::Claim(_))).count();
    if claims == 0 {
        return Ok(Value::list(values));
    }
    let choice = |value: &Value| matches!(value, Value::Text(word) if ["or", "oder", "ou", "或"].contains(&word.trim()));
    if values.iter().any(choice) {
        return Err(unsupported("a choice between claims").hint("give the claims one at a time"));
    }
    let words = values.iter().filter(|value| matches!(value, Value::Text(_))).count();
    if claims + words < values.len() {
        return Err(unsupported("a claim among other things").hint(
            "give claims one at a time; a condition such as i = 0 goes before them: --given \"i := 0\"",
        ));
    }
    let judgements = values.into_iter().flat_map(|value| match value {
        Value::Claim(claim) => claim.judgements.clone(),
        _ => Vec::new(),
    });
    Ok(Value::Claim(Arc::new(Claim { judgements: judgements.collect() })))
}

/// The vector with the given coordinates; anything else comes back.
pub(crate) fn vector(value: Value) -> Result<Value, Value> {
    match value {
        Value::Scalar(v) => Ok(Value::Vector(v)),
        Value::List(items) => {
            let vectors = items.iter().cloned().map(vector).collect::<Result<_, _>>()?;
            Ok(Value::List(items.with(vectors)))
        }
        other => Err(other),
    }
}

/// Whether a list can be called like a function.
pub(crate) fn is_curve(items: &[Value]) -> bool {
    let callable = |item: &Value| matches!(item, Value::Function(_) | Value::Polar(_) | Value::Piecewise(_));
    !items.is_empty() && items.iter().all(callable)
}
