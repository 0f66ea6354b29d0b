//! Exact linear algebra on nalgebra matrices.
