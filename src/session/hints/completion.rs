//! What may stand for a word that has been begun.

use crate::language::functions::BUILTINS;
use crate::language::latex;
use crate::language::lexicon::letters;
use crate::language::value::symbol_expr;
use crate::language::write::text;
use crate::session::Session;

/// A word that may stand in the place of another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Candidate {
    /// As it is shown in a list: a function with its arguments.
    pub shown: String,
    /// What is put in.
    pub put: String,
}

impl Candidate {
    fn new(shown: impl Into<String>, put: impl Into<String>) -> Self {
        Candidate { shown: shown.into(), put: put.into() }
    }
}

/// Where the word begins that ends with `before`, and what may stand for it: names of the session, as
/// given, functions, and behind a backslash letters and commands of LaTeX.
///
/// ```
/// use polarform::session::completions;
/// let (start, list) = completions("1 + polar_t", &[]);
/// assert_eq!((start, list[0].put.as_str()), (4, "polar_tensor("));
/// assert_eq!(completions("\\sigma", &[]).1[0].put, "σ");
/// ```
pub fn completions(before: &str, names: &[String]) -> (usize, Vec<Candidate>) {
    let letters = |c: char| c.is_alphanumeric() || c == '_';
    let word_len: usize = before.chars().rev().take_while(|&c| letters(c)).map(char::len_utf8).sum();
    let start = before.len() - word_len;
    let (rest, word) = before.split_at(start);
    if rest.ends_with('\\') {
        // \sigma becomes σ when it is complete; other commands are completed.
        if let Some(letter) = letters::sign(word) {
            return (start - 1, vec![Candidate::new(format!("{letter}  {word}"), letter.to_string())]);
        }
        let known = latex::commands().iter().filter(|c| c.is_supported());
        let commands = known.map(|command| command.name().trim_start_matches('\\'));
        let list = commands.filter(|name| !word.is_empty() && name.starts_with(word));
        return (start, list.map(|name| Candidate::new(format!("\\{name}"), name)).collect());
    }
    if word.is_empty() {
        return (start, Vec::new());
    }
    let own = names.iter().filter(|name| name.starts_with(word));
    let mut list: Vec<Candidate> = own.map(|name| Candidate::new(name, name)).collect();
    let functions = BUILTINS.iter().filter(|builtin| builtin.name.starts_with(word));
    list.extend(functions.map(|builtin| Candidate::new(builtin.signature(), format!("{}(", builtin.name))));
    (start, list)
}

impl Session {
    /// The names defined so far, as they are typed.
    pub fn names(&self) -> Vec<String> {
        self.env.iter().map(|(name, _)| text(&symbol_expr(name))).collect()
    }
}
