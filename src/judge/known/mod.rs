//! What is known when a statement is judged: of the page and of what was found so far.
//!
//! A `checker` holds all of it, `found` what came of relations before. `meaning` says whether a name has one already,
//! `objects` takes in what words say of names, `contact` makes equations of words, `unread` keeps what may say something
//! and was not understood. A `setting` is what a chain may rest on; `unfold` puts definitions in.

pub mod checker;
mod contact;
pub(super) mod found;
pub(super) mod meaning;
mod objects;
pub(super) mod senses;
mod setting;
pub(super) mod unfold;
pub(super) mod unread;
