//! Completion, highlighting and multi-line input for the interactive session.

use std::borrow::Cow;

use rustyline::completion::{Completer, Pair};
use rustyline::highlight::{CmdKind, Highlighter};
use rustyline::hint::Hinter;
use rustyline::validate::{ValidationContext, ValidationResult, Validator};
use rustyline::{Context, Helper as RustylineHelper};

use super::repl::COLON_COMMANDS;
use crate::language::functions::builtin;
use crate::language::syntax;
use crate::session::completions;

/// What the line editor needs to know.
pub(super) struct Helper {
    names: Vec<String>,
    color: bool,
}

impl Helper {
    pub fn new(color: bool) -> Self {
        Helper { names: Vec::new(), color: color && std::env::var_os("NO_COLOR").is_none() }
    }

    /// The names defined in the session.
    pub fn set_names(&mut self, names: Vec<String>) {
        self.names = names;
    }

    /// Where the word at `pos` starts, and what may stand for it.
    pub fn candidates(&self, line: &str, pos: usize) -> (usize, Vec<(String, String)>) {
        let before = &line[..pos];
        if let Some(word) = before.trim_start().strip_prefix(':')
            && !word.contains(char::is_whitespace)
        {
            let start = pos - word.len();
            let list = COLON_COMMANDS.iter().filter(|command| command.name.starts_with(word));
            return (start, list.map(|c| (c.usage.to_owned(), c.name.to_owned())).collect());
        }
        let (start, list) = completions(before, &self.names);
        (start, list.into_iter().map(|candidate| (candidate.shown, candidate.put)).collect())
    }
}

impl Completer for Helper {
    type Candidate = Pair;
    fn complete(&self, line: &str, pos: usize, _: &Context<'_>) -> rustyline::Result<(usize, Vec<Pair>)> {
        let (start, list) = self.candidates(line, pos);
        let pairs = list.into_iter().map(|(display, replacement)| Pair { display, replacement });
        Ok((start, pairs.collect()))
    }
}

impl Hinter for Helper {
    type Hint = String;
    fn hint(&self, line: &str, pos: usize, _: &Context<'_>) -> Option<String> {
        // After `polar(` the rest of the signature is shown.
        if pos < line.len() {
            return None;
        }
        let open = line.strip_suffix('(')?;
        let start = open.rfind(|c: char| !c.is_alphanumeric() && c != '_').map_or(0, |at| at + 1);
        let signature = builtin(open.get(start..)?)?.signature();
        signature.split_once('(').map(|(_, rest)| rest.to_owned())
    }
}

impl Validator for Helper {
    fn validate(&self, context: &mut ValidationContext) -> rustyline::Result<ValidationResult> {
        let input = context.input();
        let incomplete = !input.trim_start().starts_with(':')
            && !syntax::looks_like_latex(input)
            && syntax::is_incomplete(input);
        Ok(if incomplete { ValidationResult::Incomplete } else { ValidationResult::Valid(None) })
    }
}

const NUMBER: &str = "\x1b[36m";
const KNOWN: &str = "\x1b[32m";
const FAINT: &str = "\x1b[2m";
const PLAIN: &str = "\x1b[0m";

impl Highlighter for Helper {
    fn highlight<'l>(&self, line: &'l str, _: usize) -> Cow<'l, str> {
        if !self.color {
            return Cow::Borrowed(line);
        }
        Cow::Owned(colored(line, &|word| builtin(word).is_some() || self.names.iter().any(|n| n == word)))
    }

    fn highlight_hint<'h>(&self, hint: &'h str) -> Cow<'h, str> {
        if self.color { Cow::Owned(format!("{FAINT}{hint}{PLAIN}")) } else { Cow::Borrowed(hint) }
    }

    fn highlight_char(&self, _: &str, _: usize, _: CmdKind) -> bool {
        self.color
    }
}

impl RustylineHelper for Helper {}

/// Numbers and known names in color, comments faint.
fn colored(line: &str, known: &dyn Fn(&str) -> bool) -> String {
    let mut out = String::with_capacity(line.len() + 32);
    let mut rest = line;
    while let Some(first) = rest.chars().next() {
        let take = |test: &dyn Fn(char) -> bool| rest.find(|c| !test(c)).unwrap_or(rest.len());
        let (end, color) = if first == '#' {
            (rest.len(), Some(FAINT))
        } else if first.is_ascii_digit() {
            (take(&|c| c.is_ascii_digit() || c == '.'), Some(NUMBER))
        } else if first.is_alphabetic() {
            let end = take(&|c| c.is_alphanumeric() || c == '_');
            (end, known(&rest[..end]).then_some(KNOWN))
        } else {
            (first.len_utf8(), None)
        };
        match color {
            Some(color) => {
                out.push_str(color);
                out.push_str(&rest[..end]);
                out.push_str(PLAIN);
            }
            None => out.push_str(&rest[..end]),
        }
        rest = &rest[end..];
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn replacements(line: &str) -> Vec<String> {
        let mut helper = Helper::new(false);
        helper.set_names(["point", "c_0"].map(str::to_owned).to_vec());
        helper.candidates(line, line.len()).1.into_iter().map(|(_, replacement)| replacement).collect()
    }

    #[test]
    fn completions() {
        assert!(replacements("po").contains(&"point".to_owned()));
        assert!(replacements("1 + polar_t").contains(&"polar_tensor(".to_owned()));
        assert_eq!(replacements("\\sigma"), ["σ"]);
        assert!(replacements("\\fra").contains(&"frac".to_owned()));
        assert!(replacements(":lat").contains(&"latex".to_owned()));
        assert!(replacements("1 + ").is_empty());
    }

    #[test]
    fn colors_change_nothing_else() {
        let line = "f(t₁) := 12.5 polar(σ) # note";
        let plain: String = colored(line, &|word| word == "polar");
        let stripped = [NUMBER, KNOWN, FAINT, PLAIN].iter().fold(plain, |text, code| text.replace(code, ""));
        assert_eq!(stripped, line);
    }
}
