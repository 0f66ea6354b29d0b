//! What everybody in the field writes in the same way: its letters.

pub mod letters;
