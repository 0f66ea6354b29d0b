//! From a claim and what is known to a verdict.
//!
//! A statement is a chain of relations with its conditions (`page`), written in names and notations (`written`). A new
//! name is a definition (`known`); a claim is tried on all small `instances`, each with a meaning for every name
//! (`model`), and `values` are compared exactly. What holds in every instance may have a proof for all (`prove`);
//! what fails is refuted only if it can be nothing but a claim (`reasons`), and gets a suggestion (`repair`). What the
//! page leaves open may be known by the field (`theorems`) or described in words (`described`). `verdict` judges a chain,
//! `check` a page.
//!
//! The rooms stand above each other as `tests/architecture.rs` says.

pub mod check;
mod described;
mod instances;
pub mod known;
mod model;
pub mod page;
pub mod prove;
mod reasons;
mod repair;
mod theorems;
pub mod values;
mod verdict;
pub(crate) mod written;

pub use page::finding;
pub use values::evaluator;
