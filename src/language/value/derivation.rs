//! Derivations: lines of formulas, each with its reason in every language.

use std::fmt;
use std::str::FromStr;

use crate::formula::{Expr, Kind};

/// The languages in which reasons are given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Language {
    /// `en`
    #[default]
    English,
    /// `zh`
    Chinese,
}

impl Language {
    /// All of them.
    pub const ALL: [Language; 2] = [Language::English, Language::Chinese];

    /// Its code, as given with `--lang`.
    ///
    /// ```
    /// use polarform::value::Language;
    /// assert_eq!("zh".parse(), Ok(Language::Chinese));
    /// assert_eq!(Language::English.code(), "en");
    /// ```
    pub fn code(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::Chinese => "zh",
        }
    }
}

impl fmt::Display for Language {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.code())
    }
}

impl FromStr for Language {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Language::ALL.into_iter().find(|language| language.code() == text).ok_or_else(|| {
            let known = Language::ALL.map(Language::code).join(", ");
            format!("no language '{text}'; the languages are {known}")
        })
    }
}

/// The same words in every language. Formulas stand between backticks, in plain notation;
/// [`crate::language::write::write_words`] sets them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Words([String; Language::ALL.len()]);

impl Words {
    /// The words that `say` has for each language.
    pub fn new(say: impl FnMut(Language) -> String) -> Self {
        Words(Language::ALL.map(say))
    }

    /// The words in one language.
    pub fn text(&self, language: Language) -> &str {
        let place = Language::ALL.iter().position(|known| *known == language);
        &self.0[place.expect("every language is in the list of all")]
    }

    /// The words after a change that is made in every language, such as another name for F.
    pub fn map(&self, change: impl Fn(&str) -> String) -> Self {
        Words(self.0.each_ref().map(|text| change(text)))
    }
}

/// One line of a derivation.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The formula: an equation, or several side by side.
    pub formula: Expr,
    /// Why it holds.
    pub reason: Words,
}

/// A derivation as one writes it on a board.
///
/// **Invariant.** Every line makes sense after the lines before it, which introduce its names.
#[derive(Clone, Debug, PartialEq)]
pub struct Derivation {
    /// What is derived.
    pub title: Words,
    /// Its lines; the last one is the result.
    pub lines: Vec<Line>,
    /// The language somebody asked for; `None` to leave it to the one who prints.
    pub language: Option<Language>,
}

impl Derivation {
    /// The formulas without their reasons, as a list.
    pub fn to_expr(&self) -> Expr {
        Kind::List(self.lines.iter().map(|line| line.formula.clone()).collect()).into()
    }
}
