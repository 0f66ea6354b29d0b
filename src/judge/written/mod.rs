//! Formulas as they are written: their names, the notations in them, and what can be read in two ways.

pub(crate) mod ambiguous;
pub(super) mod bare;
pub(super) mod commuting;
pub(super) mod features;
pub(crate) mod names;
