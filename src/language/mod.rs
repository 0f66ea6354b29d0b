//! The language: from text to formulas, from formulas to values, and back to text.

pub mod derive;
pub mod diagnostic;
pub mod eval;
pub mod functions;
pub mod latex;
pub mod lexicon;
pub(crate) mod ops;
pub mod syntax;
pub mod value;
pub mod write;
