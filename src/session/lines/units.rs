//! The statements of a file, one after the other; sentences of one line that are read together: `Control points 0, 2, 4. Value at t = 1/2?`

use crate::formula::source::{SourceFile, Span};
use crate::language::eval::Equals;
use crate::language::syntax;
use crate::session::{Answer, Failure, Session};

impl Session {
    /// Runs all statements of a file, one after the other, calling `each` after every one.
    /// `each` says whether to go on.
    pub fn run_file(
        &mut self,
        file: &SourceFile,
        mut each: impl FnMut(&mut Session, Result<Answer, Box<Failure>>) -> bool,
    ) {
        let spans = match syntax::statements(file.text()) {
            Ok(spans) => spans,
            Err(problem) => {
                each(self, Err(Box::new(Failure { problem, file: file.clone() })));
                return;
            }
        };
        for span in self.units(file, spans) {
            if !self.run_span(file, span, &mut each) {
                return;
            }
        }
    }

    /// Runs the statement at `span`, calling `each` after it, or after each of the definitions that it
    /// is; false as soon as `each` says not to go on.
    pub fn run_span(
        &mut self,
        file: &SourceFile,
        span: Span,
        mut each: impl FnMut(&mut Session, Result<Answer, Box<Failure>>) -> bool,
    ) -> bool {
        match self.run_advised(file, span, Equals::DefinesUnbound) {
            Ok(answers) => answers.into_iter().all(|answer| each(self, Ok(answer))),
            Err(failure) => each(self, Err(failure)),
        }
    }

    /// The statements of a file, where those of one line are one if they are a request only together.
    pub fn units(&self, file: &SourceFile, statements: Vec<Span>) -> Vec<Span> {
        let mut units: Vec<Span> = Vec::new();
        let mut line: Vec<Span> = Vec::new();
        for span in statements {
            let apart = line
                .last()
                .is_some_and(|last| file.slice(Span::new(last.end, span.start.max(last.end))).contains('\n'));
            if apart {
                units.extend(self.together(file, std::mem::take(&mut line)));
            }
            line.push(span);
        }
        units.extend(self.together(file, line));
        units
    }

    fn together(&self, file: &SourceFile, line: Vec<Span>) -> Vec<Span> {
        let Some(whole) = line.iter().copied().reduce(Span::to).filter(|_| line.len() > 1) else {
            return line;
        };
        // What words ask for; formulas side by side are statements.
        if !matches!(self.spoken(file, whole), Ok(Some(_))) && self.described(file, whole).is_none() {
            return line;
        }
        let mut there = self.clone();
        let fails = line.iter().any(|span| there.run_part(file, *span, Equals::DefinesUnbound).is_err());
        let mut there = self.clone();
        match fails && there.run_part(file, whole, Equals::DefinesUnbound).is_ok() {
            true => vec![whole],
            false => line,
        }
    }
}
