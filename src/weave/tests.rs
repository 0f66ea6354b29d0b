//! Texts woven whole.
