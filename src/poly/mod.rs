//! Polynomials in one and in several variables, and their fractions.
