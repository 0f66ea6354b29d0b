//! Theorems of the field with which a page agreed.

use super::statement::Place;
use crate::formula::Expr;

/// A theorem that gave a member of a family on the page.
#[derive(Clone, Debug)]
pub(super) struct Agreement {
    pub(super) theorem: &'static str,
    /// What stands for its letters and for its sizes.
    pub(super) letters: Vec<(String, Expr)>,
    pub(super) sizes: Vec<(String, Expr)>,
    pub(super) member: Expr,
    pub(super) place: Place,
}
