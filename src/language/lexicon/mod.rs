//! What the field means by its letters and notations, whoever reads them.

pub(crate) mod families;
pub mod letters;
