//! The state of one evaluation.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::rc::Rc;

use super::arguments::Arguments;
use super::entries::Counted;
use super::env::Env;
use super::tools::{Callable, Tools};
use crate::formula::Expr;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::ops::errors::wrong_kind;
use crate::language::value::{Scope, Value};
use crate::math::number::Rational;
use crate::math::poly::Symbol;

/// Room on the stack below which a new segment is taken, and its size.
const RED_ZONE: usize = 256 * 1024;
const SEGMENT: usize = 4 * 1024 * 1024;
/// Segments the evaluations of a thread may hold at a time, 512 MiB: what calls take depends on how deeply the formulas
/// between them are nested, so their number alone does not bound the memory.
const MOST_SEGMENTS: usize = 128;

thread_local! {
    static SEGMENTS: Cell<usize> = const { Cell::new(0) };
}

/// One more segment of this thread's stack, until it is dropped.
struct Segment;

impl Segment {
    fn taken() -> Option<Self> {
        let held = SEGMENTS.get();
        (held < MOST_SEGMENTS).then(|| {
            SEGMENTS.set(held + 1);
            Segment
        })
    }
}

impl Drop for Segment {
    fn drop(&mut self) {
        SEGMENTS.set(SEGMENTS.get() - 1);
    }
}

/// A value, or what is wrong.
pub(crate) type Evaluated = Result<Value, Diagnostic>;

/// A way of understanding formulas that goes before the usual one: it may give names, calls and
/// notations a meaning that they do not have in the language. Lecture notes are read like this.
pub trait Reading {
    /// The value of a formula, or `None` to leave it to the language. Parts of it are evaluated
    /// with [`Machine::eval`], which asks this reading again.
    fn eval(&self, machine: &mut Machine, expr: &Expr) -> Option<Result<Value, Diagnostic>>;
}

/// The state of one evaluation.
pub struct Machine {
    pub(super) tools: Tools,
    pub(super) reading: Option<Rc<dyn Reading>>,
    pub(super) scope: Scope,
    /// Local names, innermost last.
    pub(super) locals: Vec<(Symbol, Value)>,
    pub(super) depth: usize,
    pub(super) notes: Vec<Diagnostic>,
    /// Whether what is evaluated is called, so that members of families in it are functions: (B_0^2 + B_1^2)(t).
    pub(super) called: bool,
    /// Whether the statement asks for a value, so that sums may have symbols as bounds.
    pub(super) answers: bool,
    /// Where an index that counts from 0 or from 1 stands in brackets, if no other one tells which.
    pub(super) counted: Counted,
    /// Values of functions of numbers already computed in this statement.
    pub(super) memo: BTreeMap<(Symbol, Vec<Rational>), Value>,
}

impl Machine {
    /// An evaluator that knows no names yet.
    pub fn new(tools: Tools) -> Self {
        Machine {
            tools,
            reading: None,
            scope: Scope::default(),
            locals: Vec::new(),
            depth: 0,
            notes: Vec::new(),
            called: false,
            answers: false,
            counted: Counted::default(),
            memo: BTreeMap::new(),
        }
    }

    /// The same with a way of understanding formulas that goes before the usual one.
    pub fn with_reading(mut self, reading: Rc<dyn Reading>) -> Self {
        self.reading = Some(reading);
        self
    }

    /// Whether another way of understanding formulas goes first.
    pub(crate) fn has_reading(&self) -> bool {
        self.reading.is_some()
    }

    /// The same with names that are defined already.
    pub fn with_names(mut self, env: &Env) -> Self {
        self.scope = env.names.clone();
        self
    }

    /// The value of a name where we are.
    pub fn lookup(&self, name: &Symbol) -> Option<&Value> {
        let local = self.locals.iter().rev().find(|(n, _)| n == name).map(|(_, value)| value);
        local.or_else(|| self.scope.get(name))
    }

    /// Runs `work` with some names bound.
    ///
    /// # Errors
    /// Those of the work.
    pub fn with_locals<T>(
        &mut self,
        names: impl IntoIterator<Item = (Symbol, Value)>,
        work: impl FnOnce(&mut Self) -> Result<T, Diagnostic>,
    ) -> Result<T, Diagnostic> {
        let before = self.locals.len();
        self.locals.extend(names);
        let result = work(self);
        self.locals.truncate(before);
        result
    }

    pub(crate) fn note(&mut self, note: Diagnostic) {
        // A remark is made once, at the first place it is about.
        if !self.notes.iter().any(|known| known.code == note.code && known.message == note.message) {
            self.notes.push(note);
        }
    }

    /// What something gives, and the remarks made there, which are not told.
    pub(crate) fn aside<T>(&mut self, ask: impl FnOnce(&mut Self) -> T) -> (T, Vec<Diagnostic>) {
        let before = std::mem::take(&mut self.notes);
        let value = ask(self);
        (value, std::mem::replace(&mut self.notes, before))
    }

    /// The value of an expression.
    ///
    /// # Errors
    /// A [`Diagnostic`] with its place.
    pub fn eval(&mut self, expr: &Expr) -> Evaluated {
        self.eval_as_written(expr).map(Value::plain)
    }

    /// The same with the arrangement that the formula asks for, for an answer.
    pub(super) fn eval_as_written(&mut self, expr: &Expr) -> Evaluated {
        crate::budget::step();
        if stacker::remaining_stack().is_some_and(|left| left >= RED_ZONE) {
            return self.eval_here(expr);
        }
        let Some(_segment) = Segment::taken() else {
            let message = format!("calls nested {} deep take too much memory", self.depth);
            return Err(without_end(message).at(expr.span));
        };
        stacker::grow(SEGMENT, || self.eval_here(expr))
    }

    fn eval_here(&mut self, expr: &Expr) -> Evaluated {
        if let Some(reading) = self.reading.clone()
            && let Some(result) = reading.eval(self, expr)
        {
            return result;
        }
        self.eval_kind(expr)
    }

    /// The integer an expression denotes.
    ///
    /// # Errors
    /// What is wrong with the expression, or that its value is no integer.
    pub fn eval_int(&mut self, expr: &Expr) -> Result<i64, Diagnostic> {
        let value = self.eval(expr)?;
        value.as_int().ok_or_else(|| wrong_kind("an integer", &value).at(expr.span))
    }

    /// Calls a function of the program by its name.
    pub(super) fn call_function(&mut self, name: &str, arguments: Arguments) -> Evaluated {
        self.function(name)?.run(self, arguments)
    }

    /// A function of the program that has to exist.
    pub(super) fn function(&self, name: &str) -> Result<&'static dyn Callable, Diagnostic> {
        (self.tools.function)(name)
            .ok_or_else(|| Diagnostic::error(Code::Internal, format!("no function {name}")))
    }
}

/// Calls that do not seem to come to an end.
pub(super) fn without_end(message: String) -> Diagnostic {
    Diagnostic::error(Code::Recursion, message)
        .reason("this refers to itself without end")
        .hint("give a base case, for example F(0) := 1 before F(n) := n F(n-1)")
}
