//! What a line asks for inside of other words: `is t^2 + 1 > 0? use Bernstein coefficients`, `variation diminishing: how many …`.

use crate::formula::source::{SourceFile, Span};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Equals;
use crate::language::functions::function_in_words;
use crate::language::lexicon::asking;
use crate::language::syntax;
use crate::language::value::Value;
use crate::session::{Answer, Failure, Session, defines};

/// How many places of a line are looked at.
const PLACES: usize = 6;

impl Session {
    /// Runs a line without the words around it that ask for nothing, which a note names; `None` if there are none.
    pub(in crate::session) fn run_core(
        &mut self,
        file: &SourceFile,
        whole: Span,
        equals: Equals,
    ) -> Result<Option<Vec<Answer>>, Box<Failure>> {
        let text = file.slice(whole);
        let known = |word: &str| defines(&self.env, word);
        let found = asking::clauses(text).into_iter().take(PLACES).find_map(|(end, start)| {
            let (head, tail) = (Span::new(0, end), Span::new(start, text.len()));
            let [before, after] = [head, tail].map(|part| text.get(part.range()).unwrap_or_default());
            let part = |part: Span| part.shifted(whole.start);
            if syntax::is_aside(after, &known) && !before.trim().is_empty() {
                return Some((part(head), part(tail)));
            }
            let titled = text.get(end..).is_some_and(|rest| rest.starts_with(':'))
                && syntax::is_title(before, &known, &function_in_words)
                && matches!(self.spoken(file, part(tail)), Ok(Some(_)));
            titled.then(|| (part(tail), part(head)))
        });
        let Some((core, left)) = found else { return Ok(None) };
        let mut there = self.clone();
        let mut answers = there.run_part(file, core, equals)?;
        // What is neither a formula nor a claim nor asked for in words is not surely understood.
        let claimed =
            |answer: &Answer| matches!(answer.outcome.value, Value::Claim(_) | Value::Derivation(_));
        let understood = answers.iter().all(claimed)
            || self.read(file, core).is_ok()
            || matches!(self.spoken(file, core), Ok(Some(_)));
        if !understood {
            return Ok(None);
        }
        self.env = there.env;
        if let Some(first) = answers.first_mut() {
            let said = file.slice(left).trim().trim_matches(['(', ')', '.', '?', '!']);
            let note = format!("'{said}' changes nothing here");
            first.outcome.notes.push(Diagnostic::note(Code::StandardMeaning, note).at(left));
        }
        Ok(Some(answers))
    }
}
