//! Problems as exceptions of Python, with their places.

use polarform::diagnostic::{Code, Diagnostic, render};
use polarform::session::Failure;
use polarform::source::{SourceFile, Span};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyType};

/// The number of characters before a byte, as Python counts them.
pub fn characters(text: &str, byte: usize) -> usize {
    text.char_indices().take_while(|(at, _)| *at < byte).count()
}

/// A span in characters, so that `text[start:end]` is what it covers.
pub fn span_in_characters(text: &str, span: Span) -> (usize, usize) {
    let start = characters(text, span.start);
    let covered = text.get(span.range()).map_or(0, |covered| covered.chars().count());
    (start, start + covered)
}

fn class<'py>(py: Python<'py>, code: Code) -> PyResult<&'py Bound<'py, PyType>> {
    static LIMIT: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    static OTHER: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    match code {
        Code::Timeout | Code::TooManyTerms | Code::TooManyDigits => {
            LIMIT.import(py, "polarform._errors", "LimitError")
        }
        _ => OTHER.import(py, "polarform._errors", "PolarformError"),
    }
}

/// A warning of Python; as an error, if that is how warnings are set.
pub fn warn(py: Python<'_>, message: &str) -> PyResult<()> {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let class = CLASS.import(py, "polarform._errors", "PolarformWarning")?;
    py.import("warnings")?.call_method1("warn", (message, class))?;
    Ok(())
}

/// Advice in the words of Python in place of options of the command line.
fn for_python(problem: &Diagnostic) -> Diagnostic {
    let mut problem = problem.clone();
    match problem.code {
        Code::Timeout => problem.hints = vec!["allow more time: pf.limits(timeout=SECONDS)".to_owned()],
        Code::TooManyTerms => {
            problem.hints = vec!["allow more: pf.limits(max_terms=N), or keep it as a value".to_owned()];
        }
        Code::TooManyDigits => problem.hints = vec!["allow more: pf.limits(max_digits=N)".to_owned()],
        _ => {
            for hint in &mut problem.hints {
                *hint = hint.replace("polarform functions shows the forms", "help(pf.functions) shows them");
                *hint = hint.replace("polarform functions lists them", "help(pf.functions) lists them");
            }
        }
    }
    problem
}

/// The exception for a problem of a text.
pub fn exception(py: Python<'_>, problem: &Diagnostic, file: &SourceFile) -> PyErr {
    let problem = for_python(problem);
    let build = || -> PyResult<PyErr> {
        let place =
            problem.span.map(|span| (span_in_characters(file.text(), span), file.line_column(span.start)));
        let details = PyDict::new(py);
        details.set_item("message", &problem.message)?;
        details.set_item("code", problem.code.id())?;
        details.set_item("reason", &problem.reason)?;
        details.set_item("hints", problem.hints.clone())?;
        details.set_item("source", file.text())?;
        details.set_item("span", place.map(|(span, _)| span))?;
        details.set_item("line", place.map(|(_, (line, _))| line))?;
        details.set_item("column", place.map(|(_, (_, column))| column))?;
        details.set_item("rendered", render(&problem, file, false))?;
        let made = class(py, problem.code)?.call((), Some(&details))?;
        Ok(PyErr::from_value(made))
    };
    build().unwrap_or_else(|error| error)
}

/// The exception for a statement that failed.
pub fn failed(py: Python<'_>, failure: &Failure) -> PyErr {
    exception(py, &failure.problem, &failure.file)
}

/// A defect of ours.
pub fn defect(py: Python<'_>) -> PyErr {
    let problem = Diagnostic::error(Code::Internal, "polarform met a defect of its own")
        .hint("please report the input that led here");
    exception(py, &problem, &SourceFile::new("<python>", ""))
}
