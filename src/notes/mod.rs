//! Checking lecture notes: every formula of a file gets a verdict.

pub mod document;
pub mod finding;
pub mod prove;
