//! polarform: exact polynomials and their polar forms (blossoms).
pub mod basis;
pub mod blossom;
pub mod budget;
pub mod cli;
pub mod diagnostic;
pub mod eval;
pub mod expr;
pub mod latex;
pub mod linalg;
pub mod number;
pub mod poly;
pub mod ring;
pub mod session;
pub mod source;
pub mod syntax;
pub mod value;
pub mod write;
