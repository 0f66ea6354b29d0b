//! Definitions in words: `let f be the polar form of t^2`, `f = derivative of t^3; f(2)`.

use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Rel};
use crate::judge::values::evaluator;
use crate::language::eval::Equals;
use crate::language::syntax;
use crate::session::given::{Given, in_order};
use crate::session::lines::several::defining;
use crate::session::{Answer, Failure, Session, defines};

impl Session {
    /// Runs a definition in words, and what is asked after it in the same statement; `None` if there is none.
    pub(in crate::session) fn run_clause(
        &mut self,
        file: &SourceFile,
        whole: Span,
        equals: Equals,
    ) -> Result<Option<Vec<Answer>>, Box<Failure>> {
        let text = file.slice(whole);
        let Some(clause) = syntax::clause(text) else { return Ok(None) };
        let body = clause.rest.shifted(whole.start);
        let define = |formula: Expr| {
            let name = Expr { span: clause.place.shifted(whole.start), ..Expr::name(clause.name) };
            let span = name.span.to(body);
            Expr { span, ..Expr::relation(name, Rel::Define, formula) }
        };
        for found in syntax::continuations(file.slice(body)) {
            let head = Span::new(body.start, body.start + found.end);
            let Some(rest) = found.rest(file.slice(body)) else { continue };
            let rest = rest.shifted(body.start);
            if !mentions(file.slice(rest), clause.name) {
                continue;
            }
            let Ok(Some(formula)) = self.spoken(file, head) else { continue };
            let mut there = self.clone();
            let defined = there.evaluated(file, define(formula), Equals::DefinesUnbound, false)?;
            let mut answers = there.run_part(file, rest, equals)?;
            if let Some(first) = answers.first_mut() {
                first.outcome.notes.insert(0, crate::session::read_as(&defined.statement, head));
            }
            self.env = there.env;
            return Ok(Some(answers));
        }
        let Some(formula) = self.spoken(file, body)? else { return Ok(None) };
        let definition = define(formula);
        let answer = self.evaluated_as(file, definition, whole, Equals::DefinesUnbound)?;
        Ok(Some(vec![answer]))
    }
}

impl Session {
    /// Runs a formula under a definition in words that follows it: `f(0, 1) where f is the polar form of t^2`.
    pub(in crate::session) fn run_where(
        &mut self,
        file: &SourceFile,
        whole: Span,
        equals: Equals,
    ) -> Result<Option<Vec<Answer>>, Box<Failure>> {
        let masked = syntax::without_text_commands(file.slice(whole));
        let words = ["where", "wobei", "où", "if", "wenn", "falls", "si"].into_iter();
        let Some(at) = words.filter_map(|word| masked.find(&format!(" {word} "))).min() else {
            return Ok(None);
        };
        let mut text = file.text().to_owned();
        text.replace_range(whole.range(), &masked);
        let masked = SourceFile::new(file.name(), text);
        let (head, rest) =
            (Span::new(whole.start, whole.start + at), Span::new(whole.start + at + 1, whole.end));
        let mut there = self.clone();
        let Ok(Some(defined)) = there.run_clause(&masked, rest, Equals::DefinesUnbound) else {
            return Ok(None);
        };
        let mut answers = there.run_part(&masked, head, equals)?;
        if let (Some(first), Some(definition)) = (answers.first_mut(), defined.first()) {
            first.outcome.notes.insert(0, crate::session::read_as(&definition.statement, rest));
        }
        Ok(Some(answers))
    }

    /// Runs definitions by formulas, and what words ask for after them: `F(t) = t^2, what is F(2)?`.
    pub(in crate::session) fn run_continued(
        &mut self,
        file: &SourceFile,
        whole: Span,
        equals: Equals,
    ) -> Result<Option<Vec<Answer>>, Box<Failure>> {
        // f(t) = 2t. f(0)?
        let question = file.slice(whole).trim_end().ends_with(['?', '？']);
        for found in syntax::continuations(file.slice(whole)).into_iter().filter(|found| {
            found.asked
                || question && file.slice(whole).get(found.end..).is_some_and(|rest| rest.starts_with('.'))
        }) {
            let Some(rest) = found.rest(file.slice(whole)) else { continue };
            // Given x = 1 and y = 2, compute x + y: values for all that follows.
            let head = file.slice(whole).get(..found.end).map_or(0, syntax::after_introduction);
            let head = Span::new(whole.start + head, whole.start + found.end);
            let known = |word: &str| defines(&self.env, word);
            // What a condition gives ends with its sentence.
            if syntax::sentence(file.slice(head), &known).is_some_and(|said| !said.conditions.is_empty()) {
                continue;
            }
            let mut there = self.clone();
            let Ok(mut answers) = there.run_given(file, head) else { continue };
            if answers.iter().any(|answer| answer.outcome.defined.is_none()) {
                continue;
            }
            let equals = if found.claims { Equals::Claims } else { equals };
            answers.extend(there.run_part(file, rest.shifted(whole.start), equals)?);
            self.env = there.env;
            return Ok(Some(answers));
        }
        Ok(None)
    }

    /// Runs what is given, each definition after those that it uses: a = 2b and b = 3.
    fn run_given(&mut self, file: &SourceFile, head: Span) -> Result<Vec<Answer>, Box<Failure>> {
        if let Ok(read) = self.read(file, head)
            && matches!(read.kind, Kind::Sequence(_))
        {
            let given: Vec<Expr> =
                self.statements_in(read, Equals::DefinesUnbound).into_iter().map(defining).collect();
            let all = given.iter().all(|one| evaluator::machine_in(&self.env).defines(one));
            if all && given.len() > 1 {
                let given =
                    given.into_iter().map(|statement| Given { file: file.clone(), statement }).collect();
                let run = |one: Given| self.evaluated(file, one.statement, Equals::DefinesUnbound, false);
                return in_order(given).into_iter().map(run).collect();
            }
        }
        self.run_part(file, head, Equals::DefinesUnbound)
    }

    /// Runs what is asked for with words such as "compute" and "show that".
    pub(in crate::session) fn run_asked(
        &mut self,
        file: &SourceFile,
        whole: Span,
        equals: Equals,
    ) -> Result<Option<Vec<Answer>>, Box<Failure>> {
        let text = file.slice(whole);
        let Some((rest, claims)) = syntax::asked(text) else { return Ok(None) };
        let word: String = text.trim_start().chars().take_while(|c| c.is_alphabetic()).collect();
        if defines(&self.env, &word) {
            return Ok(None);
        }
        let equals = if claims { Equals::Claims } else { equals };
        self.run_part(file, rest.shifted(whole.start), equals).map(Some)
    }
}

/// Whether a name stands in a text, by itself.
fn mentions(text: &str, name: &str) -> bool {
    text.split(|c: char| !c.is_alphabetic()).any(|word| word == name)
}
