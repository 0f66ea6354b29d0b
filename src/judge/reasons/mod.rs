//! Reasons: why a relation that fails is wrong, or why it stays open.
//!
//! | file | what it tells |
//! | --- | --- |
//! | `refute` | whether what fails is wrong, a condition, an equation or a new definition |
//! | `failure` | how the sides differ where it fails |
//! | `doubts` | what a name may mean otherwise |
//! | `unused` | what the page says of a name, and no instance used |
//! | `grounds` | how others fared that rest on the same names and definitions |
//! | `certainty` | all that has to be certain before a relation is called wrong |
//! | `counterexample` | the failure that shows a slip best, in words |
//! | `lint` | warnings about definitions |

pub(super) mod certainty;
pub(super) mod counterexample;
pub(super) mod doubts;
mod failure;
mod grounds;
pub(super) mod lint;
pub(super) mod refute;
mod unused;
