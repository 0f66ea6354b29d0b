//! Derivations as values, with reasons in the language that was asked for.

use std::sync::Arc;

use super::parameter::{Parameter, named};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::wrong_kind;
use crate::language::ops::takes::Takes;
use crate::language::value::{Derivation, Language, Value};

/// The language of the reasons.
pub(super) const LANG: Parameter =
    named("lang=en", Takes::Word(&["en", "zh"]), "that of the session", "the language of the reasons");

/// The derivation as a value, in the language that was asked for.
pub(super) fn told(args: &Arguments, mut derivation: Derivation) -> Evaluated {
    derivation.language = match args.named("lang") {
        Some((Value::Text(code), span)) => Some(
            code.parse::<Language>()
                .map_err(|message| Diagnostic::error(Code::Domain, message).at(span).hint("lang=en"))?,
        ),
        Some((other, span)) => return Err(wrong_kind("a language", other).at(span).hint("lang=en")),
        None => None,
    };
    Ok(Value::Derivation(Arc::new(derivation)))
}
