//! What a line could be: queries for words that nobody reads, and what may stand for a word that has been begun.

mod advice;
mod clauses;
pub(super) mod completion;
