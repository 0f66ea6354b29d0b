//! Polynomial bases and the matrices between them.
