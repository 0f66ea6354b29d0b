//! The arguments of a command as parts of one query.
//!
//! Each argument is a file of its own and is read by itself, in plain notation or LaTeX. Its formulas
//! become nodes of the query; nothing is ever joined as text. So that a problem found while the query
//! is evaluated can be shown in the argument where it lies, the arguments stand side by side in one row
//! of places, and the spans of each begin where the argument stands in that row.

use super::output::Output;
use super::waiting::Waiting;
use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::Diagnostic;
use crate::language::eval::Equals;
use crate::language::value::Value;
use crate::math::number::Rational;
use crate::math::poly::Symbol;
use crate::session::{Failure, Session, read, read_items};

pub(super) type Failed<T> = Result<T, Box<Failure>>;

/// The arguments read so far.
pub(super) struct ArgumentReader<'o> {
    /// Each with its place in the row.
    files: Vec<(usize, SourceFile)>,
    /// Where remarks about the arguments go.
    output: &'o Output,
}

impl<'o> ArgumentReader<'o> {
    /// A reader of the arguments of one command.
    pub fn new(output: &'o Output) -> Self {
        ArgumentReader { files: Vec::new(), output }
    }

    /// An argument joins the row; where it stands there.
    fn add(&mut self, name: &str, text: &str) -> (SourceFile, usize) {
        // The gap keeps empty arguments apart.
        let start = self.files.last().map_or(0, |(start, file)| start + file.text().len() + 1);
        let file = SourceFile::new(format!("<{name}>"), text);
        self.files.push((start, file.clone()));
        (file, start)
    }

    /// Reads an argument that is one formula.
    pub fn formula(&mut self, name: &str, text: &str) -> Failed<Expr> {
        let (file, start) = self.add(name, text);
        let mut expr = read(&file, None).map_err(|problem| Box::new(Failure { problem, file }))?;
        expr.shift(start);
        Ok(expr)
    }

    /// Reads an argument that lists items, as far as they have no brackets around all of them.
    pub fn items(&mut self, name: &str, text: &str) -> Failed<Vec<Expr>> {
        let (file, start) = self.add(name, text);
        let mut items = read_items(&file).map_err(|problem| Box::new(Failure { problem, file }))?;
        for item in &mut items {
            item.shift(start);
        }
        Ok(items)
    }

    /// Reads an argument whose items become arguments of a function: `a, b` and also `(a, b)`.
    pub fn arguments(&mut self, name: &str, text: &str) -> Failed<Vec<Expr>> {
        Ok(unwrapped(self.items(name, text)?, |_| true).into_iter().map(closed).collect())
    }

    /// Reads an argument that is a list: `a, b`, `[a, b]` or `(a, b)`.
    pub fn list(&mut self, name: &str, text: &str) -> Failed<Expr> {
        self.list_if(name, text, |items| items.iter().all(is_bracketed) || !items.iter().any(is_bracketed))
    }

    /// Reads a list of points or ordinates: one pair of brackets alone makes a point.
    pub fn points(&mut self, name: &str, text: &str) -> Failed<Expr> {
        self.list_if(name, text, |items| items.first().is_some_and(is_bracketed))
    }

    fn list_if(&mut self, name: &str, text: &str, is_list: impl Fn(&[Expr]) -> bool) -> Failed<Expr> {
        let items = unwrapped(self.items(name, text)?, is_list).into_iter().map(closed).collect();
        Ok(Expr::new(Kind::List(items), self.last_span()))
    }

    /// A number that was an argument.
    pub fn number(&mut self, name: &str, number: usize) -> Expr {
        let (file, start) = self.add(name, &number.to_string());
        let expr = Expr::number(&Rational::from_integer(number.into()));
        Expr { span: Span::new(0, file.text().len()).shifted(start), ..expr }
    }

    /// A word of the language that was an argument.
    pub fn word(&mut self, name: &str, word: &str) -> Expr {
        self.add(name, word);
        Expr::new(Kind::Name(word.to_owned()), self.last_span())
    }

    /// An option without a value, as the number it stands for.
    pub fn flag(&mut self, name: &str, number: i64) -> Expr {
        self.add(name, &format!("--{name}"));
        Expr { span: self.last_span(), ..Expr::int(number) }
    }

    /// The value of an argument: `F(t) = t^2` is its right-hand side. With a formula that stands for it
    /// in queries.
    pub fn operand(&mut self, session: &mut Session, name: &str, text: &str) -> Failed<(Value, Expr)> {
        let (file, _) = self.add(name, text);
        let outcome = session.run_statement(&file, None, Equals::DefinesUnbound)?.outcome;
        for note in &outcome.notes {
            self.output.problem(note, &file);
        }
        let value = outcome.value;
        let formula = bound(session, file.name(), value.clone(), self.last_span());
        Ok((value, formula))
    }

    /// All of the argument that was read last.
    pub fn last_span(&self) -> Span {
        self.files
            .last()
            .map_or(Span::default(), |(start, file)| Span::new(0, file.text().len()).shifted(*start))
    }

    /// The value of a query that is made of arguments.
    pub fn evaluate(&self, session: &mut Session, mut query: Expr) -> Failed<Value> {
        let texts: Vec<&str> = self.files.iter().map(|(_, file)| file.text()).collect();
        let waiting = Waiting::of(&texts.join(", "));
        self.output.begin();
        let evaluated = session.evaluate(&mut query, Equals::Claims);
        drop(waiting);
        match evaluated {
            Ok(outcome) => {
                for note in outcome.notes {
                    let Failure { problem, file } = *self.failure(note);
                    self.output.problem(&problem, &file);
                }
                Ok(outcome.value)
            }
            Err(problem) => Err(self.failure(problem)),
        }
    }

    /// A problem with a place in the row, shown in the argument that stands there.
    pub fn failure(&self, mut problem: Diagnostic) -> Box<Failure> {
        let at = problem.span.map_or(0, |span| span.start);
        let after = self.files.partition_point(|(start, _)| *start <= at);
        let Some((start, file)) = after.checked_sub(1).and_then(|last| self.files.get(last)) else {
            return Box::new(Failure { problem, file: SourceFile::new("<arguments>", "") });
        };
        let length = file.text().len();
        let own = |span: Span| {
            let inside = span.start >= *start && span.start <= start + length;
            inside.then(|| Span::new(span.start - start, (span.end - start).min(length)))
        };
        problem.span = problem.span.and_then(own);
        // A remark about another argument has no line to stand in.
        problem.labels.retain_mut(|label| own(label.span).map(|span| label.span = span).is_some());
        Box::new(Failure { problem, file: file.clone() })
    }
}

/// Without the brackets around all items, if what is in them is a list.
fn unwrapped(mut items: Vec<Expr>, is_list: impl Fn(&[Expr]) -> bool) -> Vec<Expr> {
    match items.as_mut_slice() {
        [Expr { kind: Kind::List(inner) | Kind::Tuple(inner), .. }] if is_list(inner) => {
            std::mem::take(inner)
        }
        _ => items,
    }
}

pub(super) fn is_bracketed(expr: &Expr) -> bool {
    matches!(expr.kind, Kind::List(_) | Kind::Tuple(_))
}

/// An item that cannot be taken for a named argument, as `degree = 3` could.
fn closed(item: Expr) -> Expr {
    match item.kind {
        Kind::Chain(..) => Expr { span: item.span, ..item.grouped() },
        _ => item,
    }
}

/// A formula whose value is given. Its name is one that nobody can type.
pub(super) fn bound(session: &mut Session, name: &str, value: Value, span: Span) -> Expr {
    session.env.set(Symbol::new(name), value);
    let name = Expr::new(Kind::Name(name.to_owned()), span);
    // Messages about a function would tell its name.
    Expr::new(Kind::Group(Box::new(name)), span)
}
