//! What is done with values, whoever asks: no formula, no names, no places.

pub(crate) mod arithmetic;
pub(crate) mod calculus;
pub(crate) mod errors;
pub(crate) mod formula;
pub(crate) mod function;
pub(crate) mod geometry;
pub(crate) mod lists;
pub(crate) mod polar;
pub(crate) mod takes;
