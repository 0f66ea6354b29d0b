//! From a claim and what is known to a verdict.
//!
//! A statement is a chain of relations with its conditions (`statement`). A new name is a definition
//! (`known`, `context`); a claim is tried on all small instances (`trial`), each with a meaning for
//! every name (`model`), compared exactly (`compare`) where the conditions hold (`conditions`,
//! `hypotheses`). What holds in every instance may have a proof for all (`prove`); what fails is
//! refuted only if it can be nothing but a claim (`verdict`, `refute`), and gets a suggestion
//! (`repair`). What comes of each relation is a `finding`.
//!
//! A claim within the language (`claim`, `family`) is judged by its values (`values`); `evaluator`
//! hands this judge and the functions of the program to the evaluator.

mod agreement;
pub(crate) mod asked;
mod attempt;
mod bare;
mod blame;
mod certainty;
mod chain;
pub mod check;
mod claim;
mod compare;
mod conditions;
mod contact;
mod context;
mod curves;
mod data;
mod declare;
mod derivation;
mod described;
pub(crate) mod doubtful;
mod doubts;
pub mod evaluator;
mod family;
mod features;
pub mod finding;
mod hypotheses;
pub mod inequality;
mod insertion;
mod integers;
mod knots;
mod known;
mod learn;
mod letters;
mod lint;
mod lists;
mod model;
pub(crate) mod names;
pub(crate) mod object;
mod opaque;
mod places;
pub mod prove;
mod reach;
mod refute;
mod related;
mod reliance;
mod repair;
mod roots;
mod rounding;
mod same_geometry;
mod scheme;
mod spoken;
pub mod statement;
mod supposed;
mod tally;
mod theorems;
pub mod topic;
mod trial;
mod triangle;
mod unfold;
mod unread;
mod values;
mod verdict;
mod witness;
