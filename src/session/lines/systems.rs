//! Equations between a brace, `\begin{cases} x + y = 3 \\ x y = 2 \end{cases}`: a system, which is solved.

use crate::formula::source::SourceFile;
use crate::formula::{Expr, Kind, call};
use crate::judge::values::evaluator;
use crate::language::eval::Equals;
use crate::session::given::is_equation;
use crate::session::{Answer, Failure, Session, read_as};

/// What opens such a brace in LaTeX.
const BRACES: &[&str] =
    &["\\begin{cases}", "\\begin{dcases}", "\\begin{rcases}", "\\left\\{", "\\cases{", "\\begin{array}"];

impl Session {
    /// Solves a statement that is nothing but a system of equations; `None` if it is none, or defines names.
    pub(in crate::session) fn run_system(
        &mut self,
        file: &SourceFile,
        statement: &Expr,
    ) -> Result<Option<Vec<Answer>>, Box<Failure>> {
        let text = file.slice(statement.span).trim_start_matches(['$', ' ']);
        let text =
            ["\\[", "\\("].iter().find_map(|open| text.strip_prefix(open)).unwrap_or(text).trim_start();
        let Kind::Sequence(items) = &statement.kind else { return Ok(None) };
        let mut machine = evaluator::machine_in(&self.env);
        if items.len() < 2
            || !items.iter().all(is_equation)
            || items.iter().all(|item| machine.defines(item))
            || !BRACES.iter().any(|brace| text.starts_with(brace))
        {
            return Ok(None);
        }
        let list = Expr::new(Kind::List(items.clone()), statement.span);
        let formula = call("solve", vec![list], statement.span);
        let note = read_as(&formula, statement.span);
        let mut answer = self.evaluated(file, formula, Equals::Claims, true)?;
        answer.outcome.notes.insert(0, note);
        Ok(Some(vec![answer]))
    }
}
