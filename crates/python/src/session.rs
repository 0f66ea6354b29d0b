//! Sessions: names that are kept from one text to the next.

use std::sync::{Mutex, PoisonError};

use polarform::budget::Limits;
use polarform::diagnostic::{Code, Diagnostic};
use polarform::eval::{Equals, name_of};
use polarform::functions::builtin;
use polarform::judge::evaluator;
use polarform::poly::Symbol;
use polarform::session::{Answer, Failure, Session as Native};
use polarform::source::{SourceFile, Span};
use polarform::syntax;
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::argument::{Operand, operand};
use crate::call::{Callee, Given, answered, run};
use crate::compute::{changed, compute, limits};
use crate::error::failed;
use crate::value::Value;

/// Names and limits of a sequence of texts.
#[pyclass(frozen, module = "polarform")]
pub struct Session {
    native: Mutex<Native>,
}

/// All statements of a text, one after the other, up to the first that fails.
fn run_text(session: &mut Native, text: &str) -> Result<Vec<Answer>, Box<Failure>> {
    let file = SourceFile::new("<text>", text);
    if syntax::statements(text).is_ok_and(|spans| spans.is_empty()) {
        // Says what is wrong with it.
        return session.run_statement(&file, None, Equals::DefinesUnbound).map(|answer| vec![answer]);
    }
    let mut answers = Vec::new();
    let mut failure = None;
    session.run_file(&file, |_, result| match result {
        Ok(answer) => {
            answers.push(answer);
            true
        }
        Err(problem) => {
            failure = Some(problem);
            false
        }
    });
    match failure {
        Some(failure) => Err(failure),
        None => Ok(answers),
    }
}

fn shown(py: Python<'_>, answer: Answer) -> PyResult<Value> {
    let name = answer.name();
    Value::told(py, answer.outcome.value, name, answer.outcome.notes)
}

/// Puts the values of Python under their names.
fn set_all(session: &mut Native, names: Vec<(String, Operand)>) -> Result<(), Box<Failure>> {
    for (name, operand) in names {
        let symbol = symbol_of(session, &name)?;
        let given = Given { places: vec![operand], named: Vec::new() };
        let value = run(session, Callee::Sign("+"), given)?.0.plain();
        session.env.set(symbol, value);
    }
    Ok(())
}

/// The name that a text is: `f`, `b_0`, `p_{1,2}`. Indices stand for themselves.
pub fn symbol_of(session: &Native, text: &str) -> Result<Symbol, Box<Failure>> {
    let file = SourceFile::new("<name>", text);
    let read = session.read(&file, Span::new(0, text.len()))?;
    let symbol = name_of(&read, &mut evaluator::machine());
    let wrong = |code, message: String, hint: &str| {
        let problem = Diagnostic::error(code, message).at(Span::new(0, text.len())).hint(hint);
        Err(Box::new(Failure { problem, file: file.clone() }))
    };
    match symbol {
        None => {
            let hint = "a name is a letter or a word, perhaps with indices: f, b_0, curve";
            wrong(Code::BadDefinition, format!("'{text}' is no name"), hint)
        }
        Some(_) if builtin(text).is_some() => {
            wrong(Code::ReservedName, format!("'{text}' is a function of polarform"), "choose another name")
        }
        Some(symbol) => Ok(symbol),
    }
}

impl Session {
    fn copied(&self) -> Native {
        self.native.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Works on a copy, so that no lock is held meanwhile, and keeps what came of it if that went well.
    fn change<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut Native) -> Result<T, Box<Failure>> + Send,
    ) -> PyResult<T> {
        let mut copy = self.copied();
        let own = copy.limits.clone();
        let (mut copy, result) = compute(py, &own, move |limits| {
            copy.limits = limits.clone();
            let result = work(&mut copy);
            (copy, result)
        })?;
        let result = result.map_err(|failure| failed(py, &failure));
        // Statements before the one that failed have been done.
        copy.limits = own;
        *self.native.lock().unwrap_or_else(PoisonError::into_inner) = copy;
        result
    }
}

#[pymethods]
impl Session {
    #[new]
    #[pyo3(signature = (*, timeout=None, max_terms=None, max_digits=None, max_depth=None))]
    fn new(
        timeout: Option<f64>,
        max_terms: Option<u64>,
        max_digits: Option<u64>,
        max_depth: Option<usize>,
    ) -> PyResult<Self> {
        let limits = changed(limits(), timeout, max_terms, max_digits, max_depth)?;
        Ok(Session { native: Mutex::new(Native::new(limits)) })
    }

    /// The value of a text; of several statements that of the last one.
    fn eval(&self, py: Python<'_>, text: &str) -> PyResult<Value> {
        let mut answers = self.change(py, |session| run_text(session, text))?;
        answers.pop().map_or_else(|| Err(crate::error::defect(py)), |answer| shown(py, answer))
    }

    /// The values of all statements of a text.
    fn run(&self, py: Python<'_>, text: &str) -> PyResult<Vec<Value>> {
        let answers = self.change(py, |session| run_text(session, text))?;
        answers.into_iter().map(|answer| shown(py, answer)).collect()
    }

    /// Calls a function with arguments that may use the names of the session.
    #[pyo3(signature = (name, *args, **kwargs))]
    fn call(
        &self,
        py: Python<'_>,
        name: String,
        args: &Bound<'_, PyTuple>,
        kwargs: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Value> {
        answered(py, &self.copied(), Callee::Function(name), Given::of(args, kwargs)?)
    }

    fn __getitem__(&self, py: Python<'_>, name: &str) -> PyResult<Value> {
        let session = self.copied();
        let symbol = symbol_of(&session, name).map_err(|failure| failed(py, &failure))?;
        match session.env.get(&symbol) {
            Some(value) => {
                Ok(Value::new(value.clone(), Some(polarform::value::symbol_expr(&symbol)), Vec::new()))
            }
            None => Err(PyKeyError::new_err(name.to_owned())),
        }
    }

    fn __setitem__(&self, py: Python<'_>, name: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
        let names = vec![(name.to_owned(), operand(value)?)];
        self.change(py, |session| set_all(session, names))
    }

    fn __delitem__(&self, py: Python<'_>, name: &str) -> PyResult<()> {
        let symbol = symbol_of(&self.copied(), name).map_err(|failure| failed(py, &failure))?;
        let removed = self.native.lock().unwrap_or_else(PoisonError::into_inner).env.remove(&symbol);
        if removed { Ok(()) } else { Err(PyKeyError::new_err(name.to_owned())) }
    }

    fn __contains__(&self, name: &str) -> bool {
        let session = self.copied();
        symbol_of(&session, name).is_ok_and(|symbol| session.env.get(&symbol).is_some())
    }

    /// The names that have values, `ans` apart.
    fn names(&self) -> Vec<String> {
        let names = self.copied();
        names.env.iter().map(|(name, _)| name.to_string()).filter(|name| name != "ans").collect()
    }

    fn __len__(&self) -> usize {
        self.names().len()
    }

    /// Another session with the same names.
    fn copy(&self) -> Self {
        Session { native: Mutex::new(self.copied()) }
    }

    fn __repr__(&self) -> String {
        match self.names() {
            names if names.is_empty() => "<polarform.Session>".to_owned(),
            names => format!("<polarform.Session with {}>", names.join(", ")),
        }
    }
}

/// The value of a text where the names given have their values.
#[pyfunction]
#[pyo3(signature = (text, /, **names))]
pub fn eval(py: Python<'_>, text: &str, names: Option<&Bound<'_, PyDict>>) -> PyResult<Value> {
    let given = Given::of(&PyTuple::empty(py), names)?.named;
    let limits: Limits = limits();
    let answers = compute(py, &limits, |limits| {
        let mut session = Native::new(limits.clone());
        set_all(&mut session, given)?;
        run_text(&mut session, text)
    })?;
    let mut answers = answers.map_err(|failure| failed(py, &failure))?;
    answers.pop().map_or_else(|| Err(crate::error::defect(py)), |answer| shown(py, answer))
}
