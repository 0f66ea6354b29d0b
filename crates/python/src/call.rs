//! Calls with arguments from Python, as nodes of a query.
//!
//! The arguments stand side by side in one row, `polar(t^2 + 2t, degree=3)`, so that a problem has a place that can be
//! shown. Only formulas that were given as text are read there; values are bound to names that nobody can type.

use polarform::diagnostic::{Code, Diagnostic};
use polarform::eval::Equals;
use polarform::expr::{Accent, Expr, Kind, Link, Quotient, Rel, Sign, Term};
use polarform::functions::{Takes, builtin};
use polarform::poly::Symbol;
use polarform::session::{Failure, Session};
use polarform::source::{SourceFile, Span};
use polarform::value::Value as Native;
use polarform::write;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::argument::{Operand, operand};
use crate::compute::{compute, limits};
use crate::error::failed;
use crate::value::Value;

/// A value of more terms is told by its kind.
const SHORT: usize = 4;

/// What is done with the arguments.
pub enum Callee {
    /// A function, by its name.
    Function(String),
    /// What a value is at its arguments.
    Value(Native),
    /// A sign between two arguments, or before one: + - * / ^ =, or hat.
    Sign(&'static str),
}

/// Arguments by place, and by name.
#[derive(Default)]
pub struct Given {
    pub places: Vec<Operand>,
    pub named: Vec<(String, Operand)>,
}

impl Given {
    /// The arguments of a call in Python; a named one that is `None` is not given.
    pub fn of(args: &Bound<'_, PyTuple>, kwargs: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let places = args.iter().map(|argument| operand(&argument)).collect::<PyResult<_>>()?;
        let mut named = Vec::new();
        for (name, value) in kwargs.into_iter().flatten() {
            if !value.is_none() {
                // Names that are words of Python have a stroke behind them there.
                let name: String = name.extract()?;
                named.push((name.strip_suffix('_').unwrap_or(&name).to_owned(), operand(&value)?));
            }
        }
        Ok(Given { places, named })
    }
}

/// An argument at its place in the row.
enum Part {
    Formula(Span),
    Words(String, Span),
    Value(Native, Span),
    List(Vec<Part>, Span),
    Equation(Box<[Part; 2]>, Span),
}

/// The row, while it is written.
#[derive(Default)]
struct Row {
    text: String,
}

impl Row {
    /// Adds an argument; `words` says that a text is not read as a formula.
    fn add(&mut self, operand: Operand, words: bool) -> Part {
        let start = self.text.len();
        match operand {
            Operand::Text(text) if words => {
                self.text += &format!("{text:?}");
                Part::Words(text, Span::new(start, self.text.len()))
            }
            Operand::Text(text) => {
                self.text += &text;
                Part::Formula(Span::new(start, self.text.len()))
            }
            Operand::Value(value) => {
                self.text += &shown(&value);
                Part::Value(value, Span::new(start, self.text.len()))
            }
            Operand::List(items) => {
                self.text.push('[');
                let mut parts = Vec::with_capacity(items.len());
                for (at, item) in items.into_iter().enumerate() {
                    self.text += if at > 0 { ", " } else { "" };
                    parts.push(self.add(item, words));
                }
                self.text.push(']');
                Part::List(parts, Span::new(start, self.text.len()))
            }
            Operand::Equation(sides) => {
                let [left, right] = *sides;
                let left = self.add(left, false);
                self.text += " = ";
                let right = self.add(right, false);
                Part::Equation(Box::new([left, right]), Span::new(start, self.text.len()))
            }
        }
    }
}

/// A value in the row: short numbers and formulas as they are, others by their kind.
fn shown(value: &Native) -> String {
    match value {
        Native::Scalar(formula)
            if formula.numerator().len() <= SHORT && formula.denominator().len() <= SHORT =>
        {
            write::text(&value.to_expr())
        }
        value => format!("<{}>", value.kind()),
    }
}

/// Whether an argument of a function, by its place or its name, is words and no formula.
fn takes_words(function: &str, place: Option<usize>, name: Option<&str>) -> bool {
    let Some(function) = builtin(function) else { return false };
    let all = function.parameters.iter().chain(function.common);
    let parameter = match (place, name) {
        (Some(place), _) => function.parameters.get(place),
        (None, name) => all.clone().find(|parameter| Some(parameter.name) == name),
    };
    parameter.is_some_and(|parameter| parameter.kind == Takes::Text)
}

/// Turns the parts of the row into formulas.
struct Reader<'a> {
    session: &'a mut Session,
    file: SourceFile,
    bound: usize,
}

impl Reader<'_> {
    fn expr(&mut self, part: Part) -> Result<Expr, Box<Failure>> {
        Ok(match part {
            Part::Formula(span) => self.formula(span)?,
            Part::Words(words, span) => Expr::new(Kind::Text(words), span),
            Part::Value(value, span) => self.bind(value, span),
            Part::List(parts, span) => {
                let items = parts.into_iter().map(|part| self.expr(part)).collect::<Result<_, _>>()?;
                Expr::new(Kind::List(items), span)
            }
            Part::Equation(sides, span) => {
                let [left, right] = *sides;
                let (left, right) = (self.expr(left)?, self.expr(right)?);
                let relation = relation(left.grouped(), right, span);
                Expr::new(relation.kind, span)
            }
        })
    }

    fn formula(&mut self, span: Span) -> Result<Expr, Box<Failure>> {
        let read = self.session.read(&self.file, span)?;
        match read.kind {
            Kind::Sequence(_) => {
                let problem =
                    Diagnostic::error(Code::Arity, "several formulas stand where one argument is expected")
                        .at(span)
                        .hint("give each as an argument of its own, or all of them as a list");
                Err(Box::new(Failure { problem, file: self.file.clone() }))
            }
            // It is no argument with a name, as degree = 3 would be.
            Kind::Chain(..) => Ok(Expr::new(Kind::Group(Box::new(read)), span)),
            _ => Ok(read),
        }
    }

    /// A formula whose value is given.
    fn bind(&mut self, value: Native, span: Span) -> Expr {
        self.bound += 1;
        let name = format!("<{}>", self.bound);
        self.session.env.set(Symbol::new(&name), value);
        Expr::new(Kind::Group(Box::new(Expr::new(Kind::Name(name), span))), span)
    }
}

fn relation(left: Expr, right: Expr, span: Span) -> Expr {
    let link = Link { rel: Rel::Eq, span, expr: right };
    Expr::new(Kind::Chain(Box::new(left), vec![link]), span)
}

/// What comes of a sign between two formulas, or before one.
fn signed(sign: &str, mut parts: Vec<Expr>, span: Span) -> Expr {
    let last = parts.pop().unwrap_or_else(|| Expr::int(0));
    let Some(first) = parts.pop() else {
        return match sign {
            "hat" => Expr::new(Kind::Accent(Accent::Hat, Box::new(last)), span),
            "+" => last,
            _ => Expr::new(last.negated().kind, span),
        };
    };
    let term = |sign, expr| Term { sign, expr };
    let kind = match sign {
        "+" => Kind::Add(vec![term(Sign::Plus, first), term(Sign::Plus, last)]),
        "-" => Kind::Add(vec![term(Sign::Plus, first), term(Sign::Minus, last)]),
        "*" => Kind::Mul(vec![first, last]),
        "/" => Kind::Div(Box::new(first), Box::new(last), Quotient::Slash),
        "^" => Kind::Pow(Box::new(first), Box::new(last)),
        _ => return relation(first, last, span),
    };
    Expr::new(kind, span)
}

/// Does something with arguments in a session, whose names stay as they are.
pub fn run(
    session: &Session,
    callee: Callee,
    given: Given,
) -> Result<(Native, Vec<Diagnostic>, SourceFile), Box<Failure>> {
    let mut row = Row::default();
    let mut parts = Vec::new();
    let (mut function, mut head) = (None, None);
    match &callee {
        Callee::Function(name) => {
            row.text += name;
            row.text.push('(');
            function = Some((name.clone(), Span::new(0, name.len())));
        }
        Callee::Value(value) => {
            head = Some(row.add(Operand::Value(value.clone()), false));
            row.text.push('(');
        }
        Callee::Sign(_) => {}
    }
    let sign = match &callee {
        Callee::Sign(sign) => Some(*sign),
        _ => None,
    };
    let separator = sign.map_or(", ".to_owned(), |sign| format!(" {sign} "));
    let alone = given.places.len() == 1;
    let words_at = |place, name: Option<&str>| {
        function.as_ref().is_some_and(|(function, _)| takes_words(function, place, name))
    };
    for (place, operand) in given.places.into_iter().enumerate() {
        if place > 0 || alone && sign.is_some_and(|sign| sign != "+") {
            row.text += &separator;
        }
        let part = row.add(operand, words_at(Some(place), None));
        parts.push((None, part));
    }
    for (name, operand) in given.named {
        row.text += if parts.is_empty() { "" } else { ", " };
        row.text += &format!("{name}=");
        let words = words_at(None, Some(&name));
        let part = row.add(operand, words);
        parts.push((Some(name), part));
    }
    if sign.is_none() {
        row.text.push(')');
    }
    let whole = Span::new(0, row.text.len());
    let file = SourceFile::new("<call>", row.text);
    let mut inner = session.clone();
    let mut reader = Reader { session: &mut inner, file: file.clone(), bound: 0 };
    let mut arguments = Vec::with_capacity(parts.len());
    for (name, part) in parts {
        let value = reader.expr(part)?;
        arguments.push(match name {
            Some(name) => {
                let span = value.span;
                relation(Expr::new(Kind::Name(name), span), value, span)
            }
            None => value,
        });
    }
    let applied = |callee: Expr, arguments| Expr::new(Kind::Apply(Box::new(callee), vec![arguments]), whole);
    let mut query = match (sign, function, head) {
        (Some(sign), ..) => signed(sign, arguments, whole),
        (None, Some((name, span)), _) => applied(Expr::new(Kind::Name(name), span), arguments),
        (None, None, head) => {
            let callee = head.map_or_else(|| Ok(Expr::int(1)), |head| reader.expr(head))?;
            applied(callee, arguments)
        }
    };
    let outcome = inner
        .evaluate(&mut query, Equals::Claims)
        .map_err(|problem| Box::new(Failure { problem, file: file.clone() }))?;
    Ok((outcome.value, outcome.notes, file))
}

/// The same, from Python.
pub fn answered(py: Python<'_>, session: &Session, callee: Callee, given: Given) -> PyResult<Value> {
    let done = compute(py, &session.limits.clone(), |limits| {
        let mut session = session.clone();
        session.limits = limits.clone();
        run(&session, callee, given)
    })?;
    let (value, notes, _) = done.map_err(|failure| failed(py, &failure))?;
    Value::told(py, value, None, notes)
}

/// Calls a function of the table.
#[pyfunction]
pub fn call(
    py: Python<'_>,
    name: String,
    args: &Bound<'_, PyTuple>,
    kwargs: &Bound<'_, PyDict>,
) -> PyResult<Value> {
    let given = Given::of(args, Some(kwargs))?;
    answered(py, &Session::new(limits()), Callee::Function(name), given)
}
