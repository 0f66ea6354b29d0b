//! Derivations as values, with reasons in the language that was asked for.

use std::sync::Arc;

use super::parameter::{Parameter, named};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::takes::Takes;
use crate::language::value::{Derivation, Language, Value};

/// The language of the reasons.
pub(super) const LANG: Parameter =
    named("lang=en", Takes::Word(&["en", "zh"]), "that of the session", "the language of the reasons");

/// The derivation as a value, in the language that was asked for.
pub(super) fn told(args: &Arguments, mut derivation: Derivation) -> Evaluated {
    derivation.language = match args.named("lang") {
        Some((Value::Text(code), _)) => code.parse::<Language>().ok(),
        _ => None,
    };
    Ok(Value::Derivation(Arc::new(derivation)))
}
