//! What is known when a statement is judged: of the page and of what was found so far.
//!
//! A `checker` holds all of it. `meaning` says whether a name has one already, `unfold` puts definitions in,
//! `contact` makes equations of words, `unread` keeps what may say something and was not understood.

pub mod checker;
mod contact;
pub(super) mod found;
pub(super) mod meaning;
pub(super) mod unfold;
pub(super) mod unread;
