//! Checking lecture notes: every formula of a file gets a verdict.

mod context;
pub mod document;
pub mod extract;
pub mod finding;
mod model;
mod names;
mod statement;
