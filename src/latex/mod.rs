//! LaTeX as authors write it: text to formula tree.
