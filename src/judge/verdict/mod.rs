//! The verdict on a chain of relations by what its instances and its proof say.
//!
//! `chain` tells definitions from claims, `across` looks around a side that is wrong, `attempt` tries the readings of a claim, `relation` gives the verdict, and
//! `learn` keeps what the chain defines. `lists` and `opaque` judge what has no instances.

mod across;
mod attempt;
mod chain;
mod forms;
mod learn;
mod lists;
mod opaque;
mod relation;
