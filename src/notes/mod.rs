//! Checking lecture notes: every formula of a file gets a verdict.
//!
//! A file taken apart ([`crate::document`]) becomes statements (`statement`): chains of relations
//! with their conditions. One after the other they are judged ([`crate::judge`], `page`). The
//! outcome is a list of findings, printed by `report`.

// Pieces of a text are taken by `Pieces`, which no text can bring down.
#![cfg_attr(not(test), deny(clippy::string_slice))]

mod again;
mod blocks;
mod brackets;
mod cases;
mod conditions;
mod fixes;
mod items;
mod objects;
mod page;
mod primes;
mod released;
pub mod report;
mod sentence;
mod spare;
mod speech;
mod statement;
mod superscripts;
mod triangles;

pub use again::{Memory, Progress, check_again};
pub use page::{Options, check_document, listing};
