//! What the field means by its letters and notations, whoever reads them: their signs (`letters`), what
//! they usually stand for (`roles`), words (`words`), requests in words (`phrases`), and families with a standard meaning and its values (`families`).

pub(crate) mod asking;
pub(crate) mod families;
pub(crate) mod fractions;
pub mod letters;
pub(crate) mod phrases;
pub(crate) mod relations;
pub(crate) mod roles;
pub(crate) mod signs;
pub(crate) mod topics;
pub(crate) mod wanted;
pub mod words;
