//! Values compared, and claims that are decided by their values alone.
//!
//! `equality` and `inequality` decide for all values of the symbols, `compare` for two sides of notes. A claim within
//! the language (`claim`, `family`) needs nothing else; `evaluator` hands this judge and the functions of the program to
//! the evaluator.

mod claim;
pub(super) mod compare;
pub(super) mod consequences;
pub(super) mod equality;
pub mod evaluator;
pub(super) mod family;
pub mod inequality;
pub(super) mod roots;
pub(super) mod rounding;
mod same_geometry;
