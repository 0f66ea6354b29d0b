//! What a page says, and what is told of it.
//!
//! A `statement` stands at a place of the page; its words say what names stand for (`object`) and what its section is
//! about (`topic`). `context` holds what was met so far: definitions, conditions, objects, `knots`. What comes of each
//! relation is a `finding`.

pub(super) mod context;
mod data;
pub mod finding;
mod knots;
pub(super) mod letters;
pub(in crate::judge) mod members;
pub(crate) mod object;
pub(super) mod reach;
pub mod statement;
pub mod topic;
