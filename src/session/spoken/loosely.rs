//! The last reading of a line in words: its parts wherever they stand, numbers in words, and words that carry no role left aside.

use super::{KINDS_NOTE, Reader};
use crate::budget::Limits;
use crate::formula::Expr;
use crate::formula::source::{SourceFile, Span};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Equals;
use crate::language::functions::function_in_words;
use crate::language::lexicon::{fractions, wanted};
use crate::language::syntax;
use crate::session::{Answer, Session, defines};
use std::cell::Cell;

/// Longer texts are no requests.
const LONGEST: usize = 1000;

/// The steps for a reading that is only tried.
const TRIED_STEPS: u64 = 2_000_000;

impl Session {
    /// The answer to a request that is not read word by word, with a note of the words left aside; `None` if there is no reading
    /// that has an answer.
    pub(in crate::session) fn run_loosely(&mut self, file: &SourceFile, whole: Span) -> Option<Answer> {
        let (_, aside, mut answer, there) = self.loosely(file, whole)?;
        answer.file = file.clone();
        answer.outcome.notes.extend(left_aside(file, whole, &aside));
        self.env = there.env;
        Some(answer)
    }

    /// The formula that such a request stands for.
    pub(in crate::session) fn spoken_loosely(&self, file: &SourceFile, whole: Span) -> Option<Expr> {
        self.loosely(file, whole).map(|(formula, ..)| formula)
    }

    /// The first reading that has an answer, with the words that it leaves aside.
    fn loosely(&self, file: &SourceFile, whole: Span) -> Option<(Expr, Vec<Span>, Answer, Session)> {
        let text = file.slice(whole);
        if text.len() > LONGEST || wanted::is_of_another(text) {
            return None;
        }
        let fractions = fractions::with_digits(text);
        let text = fractions.as_deref().unwrap_or(text);
        let counted = fractions::with_counts(text, &function_in_words);
        let text = counted.as_deref().unwrap_or(text);
        let mut all = file.text().to_owned();
        all.replace_range(whole.range(), text);
        let masked = SourceFile::new(file.name(), all);
        let known = |word: &str| defines(&self.env, word);
        let reader = Reader {
            session: self,
            file: &masked,
            start: whole.start,
            topic: None,
            used_topic: Cell::new(false),
        };
        let mut there = self.clone();
        there.limits = Limits { steps: Some(TRIED_STEPS), ..there.limits };
        for reading in syntax::loosely(text, &known, &function_in_words) {
            let bound = match &reading.asked.equals {
                Some(_) => Vec::new(),
                None => match reader.collected(reading.asked.request.clone()) {
                    Ok(Some(asked)) => reader.bound(&asked),
                    _ => Vec::new(),
                },
            };
            let usual = reader.formula(reading.asked).ok().flatten();
            for formula in usual.into_iter().chain(bound) {
                let mut tried = there.clone();
                let Ok(answer) = tried.evaluated_as(&masked, formula.clone(), whole, Equals::Claims) else {
                    continue;
                };
                // A list in the middle is no curve.
                if !answer.outcome.notes.iter().any(|note| note.message.starts_with(KINDS_NOTE)) {
                    tried.limits = self.limits.clone();
                    return Some((formula, reading.aside, answer, tried));
                }
            }
        }
        None
    }
}

/// The note that names words left aside.
fn left_aside(file: &SourceFile, whole: Span, words: &[Span]) -> Option<Diagnostic> {
    let shown: Vec<String> =
        words.iter().map(|span| format!("'{}'", file.slice(span.shifted(whole.start)).trim())).collect();
    let note = format!("left aside: {}", shown.join(", "));
    (!shown.is_empty()).then(|| Diagnostic::note(Code::StandardMeaning, note).at(whole))
}
