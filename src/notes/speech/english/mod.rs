//! English.

mod roles;
mod topics;
mod words;

pub(super) use roles::{BLOCKS, CONCLUSIONS, CUES, FILLERS, PROOFS, RECALLS, SUBJECTS, ZERO};
pub(super) use topics::TOPICS;
pub(super) use words::WORDS;
