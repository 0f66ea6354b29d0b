//! Formulas as text, Unicode, LaTeX and SymPy syntax; values as JSON.
//!
//! The writers of formulas thread precedence instead of guessing parentheses: an operand is
//! put in brackets exactly when it holds together less tightly than its place demands. Plain
//! text and LaTeX read back to the same formula; SymPy syntax is for checking elsewhere.

mod expanded;
mod json;
mod latex;
mod plain;
mod sympy;

use std::fmt;
use std::str::FromStr;

pub use expanded::{expanded_terms, write_expanded};
pub use json::{claim_json, value_json};
pub use latex::latex;
pub use plain::{text, unicode};
pub use sympy::{NotExpressible, sympy};

use crate::expr::{Expr, Kind};

/// The output formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Format {
    /// Plain notation, as one types it.
    #[default]
    Text,
    /// With subscripts and superscripts, for reading on a terminal.
    Unicode,
    /// LaTeX for amsmath or KaTeX.
    Latex,
    /// Data.
    Json,
    /// Python expressions for SymPy.
    Sympy,
}

impl Format {
    /// All formats.
    pub const ALL: [Format; 5] = [Format::Text, Format::Unicode, Format::Latex, Format::Json, Format::Sympy];

    /// The name used on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Format::Text => "text",
            Format::Unicode => "unicode",
            Format::Latex => "latex",
            Format::Json => "json",
            Format::Sympy => "sympy",
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Format {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        Format::ALL
            .into_iter()
            .find(|format| format.name() == text)
            .ok_or_else(|| format!("no format '{text}'; use text, unicode, latex, json or sympy"))
    }
}

/// The formula in one of the formats for formulas (JSON gives text).
///
/// # Errors
/// [`NotExpressible`] for constructs without meaning in SymPy.
pub fn write_expr(expr: &Expr, format: Format) -> Result<String, NotExpressible> {
    Ok(match format {
        Format::Text | Format::Json => text(expr),
        Format::Unicode => unicode(expr),
        Format::Latex => latex(expr),
        Format::Sympy => sympy(expr)?,
    })
}

/// Bases whose numbered names are written without underscore: t1, but c_0.
fn numbered_without_underscore(base: &str) -> bool {
    matches!(base, "t" | "u" | "v" | "w" | "x" | "y" | "z" | "s")
}

/// A nonnegative integer literal, as its digits.
fn digits(expr: &Expr) -> Option<String> {
    match &expr.kind {
        Kind::Number(q) if q.is_integer() && !num_traits::Signed::is_negative(q) => {
            Some(q.numer().to_string())
        }
        _ => None,
    }
}
