//! The names of the output formats.

use std::fmt;
use std::str::FromStr;

/// How results are printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Format {
    /// The plain notation: `t1^2`
    #[default]
    Text,
    /// The plain notation with Unicode signs: `t₁²`
    Unicode,
    /// LaTeX: `t_1^2`
    Latex,
    /// JSON objects that hold the value in all its parts.
    Json,
    /// Python expressions for SymPy: `t1**2`
    Sympy,
}

impl Format {
    /// All formats, in the order in which help lists them.
    pub const ALL: [Format; 5] = [Format::Text, Format::Unicode, Format::Latex, Format::Json, Format::Sympy];

    /// The name as given on the command line.
    ///
    /// ```
    /// use polarform::write::Format;
    /// assert_eq!(Format::Latex.name(), "latex");
    /// assert_eq!("LaTeX".parse(), Ok(Format::Latex));
    /// ```
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
        f.pad(self.name())
    }
}

impl FromStr for Format {
    type Err = UnknownFormat;

    /// Letter case does not matter.
    fn from_str(text: &str) -> Result<Self, UnknownFormat> {
        let known = Format::ALL.into_iter().find(|format| format.name().eq_ignore_ascii_case(text.trim()));
        known.ok_or_else(|| UnknownFormat(text.to_owned()))
    }
}

/// A name that is no [`Format`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownFormat(pub String);

impl fmt::Display for UnknownFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "there is no format {:?}; choose one of", self.0)?;
        for (i, format) in Format::ALL.into_iter().enumerate() {
            write!(f, "{} {format}", if i == 0 { "" } else { "," })?;
        }
        Ok(())
    }
}

impl std::error::Error for UnknownFormat {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_read_back() {
        for format in Format::ALL {
            assert_eq!(format.to_string().parse(), Ok(format));
        }
        let problem = "pdf".parse::<Format>().unwrap_err();
        assert_eq!(
            problem.to_string(),
            "there is no format \"pdf\"; choose one of text, unicode, latex, json, sympy"
        );
    }
}
