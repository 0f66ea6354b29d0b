//! A chain of relations tried on all small instances.
//!
//! A `setting` has what a chain may rest on. `integers` says which values are tried and `places` where piecewise
//! polynomials are; `trial` evaluates the sides, `conditions`, `hypotheses` and what functions have in common (`related`)
//! are put in before they are compared, and `tally` counts how it went.

pub(super) mod conditions;
pub(super) mod hypotheses;
pub(super) mod integers;
mod places;
pub(super) mod related;
pub(super) mod setting;
pub(super) mod tally;
pub(super) mod trial;
