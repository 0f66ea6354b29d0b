//! Checking lecture notes: every formula of a file gets a verdict.

mod check;
mod compare;
mod context;
mod declare;
pub mod document;
pub mod extract;
pub mod finding;
mod known;
mod lint;
mod lists;
mod model;
mod names;
mod refute;
mod repair;
pub mod report;
mod statement;
mod trial;

pub use check::{Options, check_document, listing};
