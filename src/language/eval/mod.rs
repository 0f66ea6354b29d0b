//! From a formula to its value.
//!
//! The formula tree says what was written; this module decides what it means, by the
//! names that are defined: `f(t + 1)` is a value when f is a function here and a product
//! when f is a scalar. Mathematical errors know no place; they get it here, with
//! [`At`](crate::language::diagnostic::At).
//!
//! Names without a value stand for themselves: single letters, Greek letters and anything
//! with a subscript are symbols. Other unknown words are errors, with the nearest known
//! name as a hint.

//!
//! The evaluator knows no function and judges no claim: it is handed both as [`Tools`].

mod apply;
pub(crate) mod arguments;
mod calculus;
mod call;
mod closed_sums;
mod curves;
mod define;
mod differences;
mod differentials;
mod dots;
mod entries;
mod env;
mod equations;
mod expression;
pub(crate) mod extremes;
mod formulas;
mod kinds;
mod lambda;
mod limits;
mod machine;
pub(crate) mod names;
mod patterns;
mod polar;
mod products;
mod sequences;
mod stand_ins;
mod statement;
mod sums;
mod tools;
mod unit_matrix;
mod words;

pub use arguments::Arguments;
pub(crate) use arguments::named;
pub(crate) use curves::{call_geometry, call_piecewise};
pub use env::Env;
pub(crate) use machine::Evaluated;
pub use machine::{Machine, Reading};
pub use names::name_of;
pub(crate) use statement::is_decimal_comma;
#[cfg(feature = "notes")]
pub(crate) use statement::is_decimal_part;
pub use statement::{Equals, Outcome, evaluate};
pub use tools::{Callable, Judge, Slot, Tools};
