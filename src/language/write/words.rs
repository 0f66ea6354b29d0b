//! Sentences with formulas in them.

use super::{Format, latex, text, unicode};
use crate::language::syntax::parse;

/// A sentence whose formulas stand between backticks, in plain notation: they are written in
/// the given format, in LaTeX between dollar signs as `\text{…}` wants them.
///
/// ```
/// use polarform::write::{Format, write_words};
/// let words = "the mean of `t_1^2`";
/// assert_eq!(write_words(words, Format::Text), "the mean of t1^2");
/// assert_eq!(write_words(words, Format::Latex), "the mean of $t_1^2$");
/// ```
pub fn write_words(words: &str, format: Format) -> String {
    let piece = |(i, piece): (usize, &str)| match parse(piece) {
        Ok(formula) if i % 2 == 1 => match format {
            Format::Latex => format!("${}$", latex(&formula)),
            Format::Unicode => unicode(&formula),
            Format::Text | Format::Json | Format::Sympy => text(&formula),
        },
        _ => piece.to_owned(),
    };
    words.split('`').enumerate().map(piece).collect()
}
