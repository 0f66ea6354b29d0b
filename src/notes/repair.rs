//! The likely slip in a wrong formula.

use super::check::Checker;
use super::model::{Choices, Curve};
use super::statement::{Chain, Place};

/// A repair of the relation number `at`, as LaTeX.
pub fn suggestion(
    _checker: &Checker,
    _chain: &Chain,
    _at: usize,
    _place: &Place,
    _curve: &Option<Curve>,
    _choices: Choices,
) -> Option<String> {
    None
}
