//! Polar forms (blossoms).
