//! Formula trees as text, Unicode, LaTeX and SymPy syntax.
//!
//! **Definition.** A *writer* turns a formula tree ([`crate::formula`]) into one notation:
//!
//! | function | notation | for |
//! | --- | --- | --- |
//! | [`text()`] | `5/3 (t1 + t2)`, as typed | files, and the plain reader |
//! | [`unicode()`] | `5/3 (t₁ + t₂)` | a terminal; the plain reader reads it, too |
//! | [`latex()`] | `\frac{5}{3} (t_1 + t_2)` | KaTeX and LaTeX with amsmath |
//! | [`sympy()`] | `Rational(5, 3)*(t1 + t2)` | checking results with SymPy |
//!
//! Values and verdicts become data with [`value_json`] and [`claim_json`]; fully expanded polar
//! forms are streamed by [`write_expanded`].
//!
//! **Invariants.** The tree is printed as it is: nothing is simplified or reordered. An
//! operand gets parentheses exactly if its precedence
//! ([`Expr::precedence`](crate::formula::Expr::precedence), or that of what the notation makes
//! of it: a LaTeX fraction needs fewer parentheses than `a/b`) is looser than its place
//! requires; parentheses that were written ([`Kind::Group`](crate::formula::Kind::Group)) stay.
//! Writing streams into any [`std::fmt::Write`], takes time linear in the size of the tree
//! and what it prints as, and does not recurse, however deep the tree is.
//!
//! **Reference.** Oppen, *Prettyprinting* (1980), for printing from a stack of pending pieces;
//! here no line is broken, except for matrices in Unicode and by [`broken`] in LaTeX.

mod answer;
mod boxes;
mod decimal;
mod derivation;
mod expanded;
mod format;
mod json;
mod latex;
mod lines;
mod marks;
mod names;
mod plain;
mod radicals;
mod ruler;
mod shape;
mod sympy;
mod table;
mod text;
mod unicode;
mod walk;
mod words;

#[cfg(test)]
mod tests;

pub use answer::{Manner, verdict_in_words, write_answer};
pub use derivation::{
    derivation_json, repeats_left_side, split_at_relation, write_derivation, write_derivation_within,
};
pub use expanded::{expanded_terms, write_expanded, write_grouped};
pub use format::{Format, UnknownFormat};
pub use json::{claim_json, value_json};
pub use latex::{latex, write_latex};
pub use lines::{ARTICLE, Breaks, broken, lines_of};
pub use ruler::measured;
pub use sympy::{WriteError, sympy, write_sympy};
pub use table::{latex_table, latex_table_within, table_json, write_table};
pub use text::{text, write_text};
#[cfg(feature = "figure")]
pub(crate) use unicode::relation as unicode_relation;
pub use unicode::unicode;
pub use words::write_words;

use crate::formula::Expr;

/// The formula in one of the notations for formulas (for JSON, as text).
///
/// # Errors
/// [`WriteError`] for constructs without meaning in SymPy.
pub fn write_expr(expr: &Expr, format: Format) -> Result<String, WriteError> {
    match format {
        Format::Text | Format::Json => Ok(text(expr)),
        Format::Unicode => Ok(unicode(expr)),
        Format::Latex => Ok(latex(expr)),
        Format::Sympy => sympy(expr),
    }
}
