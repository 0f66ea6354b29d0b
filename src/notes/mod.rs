//! Checking lecture notes: every formula of a file gets a verdict.
//!
//! A file is taken apart (`extract`) into formulas and words (`document`), these become statements
//! (`statement`): chains of relations with their conditions. One after the other they are judged
//! (`check`): a new name is a definition (`known`, `context`); a claim is tried on all small
//! instances (`trial`), each with a meaning for every name (`model`), compared exactly (`compare`).
//! What holds in every instance may have a proof for all (`prove`); what fails is refuted only if it
//! can be nothing but a claim (`refute`), and gets a suggestion (`repair`). The outcome is a list of
//! findings (`finding`), printed by `report`.

mod attempt;
mod check;
mod compare;
mod context;
mod declare;
pub mod document;
pub mod extract;
mod features;
pub mod finding;
mod known;
mod lint;
mod lists;
mod model;
mod names;
pub mod prove;
mod refute;
mod repair;
pub mod report;
mod statement;
mod trial;
mod unfold;

pub use check::{Options, check_document, listing};
