//! The plain notation: text to formula tree.
