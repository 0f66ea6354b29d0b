//! polarform: exact polynomials and their polar forms (blossoms).
pub mod budget;
pub mod diagnostic;
pub mod expr;
pub mod latex;
pub mod number;
pub mod source;
pub mod syntax;
pub mod write;
