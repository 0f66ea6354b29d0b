//! The table of functions, from which the wrappers and stubs of Python are written.

use polarform::diagnostic::Code;
use polarform::functions::{BUILTINS, Builtin, Need, Parameter, Takes};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// The word for a kind of argument, by which its type in Python is chosen.
fn kind(takes: Takes) -> &'static str {
    match takes {
        Takes::Size | Takes::Integer => "integer",
        Takes::Number => "number",
        Takes::Flag => "flag",
        Takes::Text => "text",
        Takes::Word(_) => "word",
        Takes::Scalars
        | Takes::Variables
        | Takes::Points
        | Takes::Point
        | Takes::Net
        | Takes::Rows
        | Takes::Interval
        | Takes::Triangle
        | Takes::List => "list",
        _ => "any",
    }
}

fn parameter<'py>(py: Python<'py>, parameter: &Parameter) -> PyResult<Bound<'py, PyDict>> {
    let entry = PyDict::new(py);
    let need = match parameter.need {
        Need::Required => "required",
        Need::Optional(_) => "optional",
        Need::Named(_) => "named",
        Need::Many(..) => "many",
        Need::Free => "free",
    };
    entry.set_item("name", parameter.name)?;
    entry.set_item("form", parameter.form)?;
    entry.set_item("need", need)?;
    entry.set_item("kind", kind(parameter.kind))?;
    entry.set_item("words", parameter.kind.words())?;
    entry.set_item("doc", parameter.explanation())?;
    Ok(entry)
}

fn parameters<'py>(
    py: Python<'py>,
    all: impl Iterator<Item = &'static Parameter>,
) -> PyResult<Bound<'py, PyList>> {
    let list = PyList::empty(py);
    for one in all {
        list.append(parameter(py, one)?)?;
    }
    Ok(list)
}

fn entry<'py>(py: Python<'py>, function: &'static Builtin) -> PyResult<Bound<'py, PyDict>> {
    let entry = PyDict::new(py);
    entry.set_item("name", function.name)?;
    entry.set_item("form", function.signature())?;
    entry.set_item("topic", function.topic)?;
    entry.set_item("summary", function.summary)?;
    entry.set_item("example", function.example)?;
    entry.set_item("parameters", parameters(py, function.parameters.iter().chain(function.common))?)?;
    let variants = PyList::empty(py);
    for (form, variant) in function.other_forms() {
        variants.append((form, parameters(py, variant.parameters.iter())?))?;
    }
    entry.set_item("variants", variants)?;
    let subjects = PyList::empty(py);
    for subject in function.subjects {
        subjects.append(self::entry(py, subject)?)?;
    }
    entry.set_item("subjects", subjects)?;
    Ok(entry)
}

/// All functions of the language, with their parameters.
#[pyfunction]
pub fn function_table(py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
    let list = PyList::empty(py);
    for function in BUILTINS {
        list.append(entry(py, function)?)?;
    }
    Ok(list)
}

/// The names of all functions.
#[pyfunction]
pub fn function_names() -> Vec<&'static str> {
    BUILTINS.iter().map(|function| function.name).collect()
}

/// What a code of an error means: `pf.explain("E203")`.
#[pyfunction]
pub fn explain(code: &str) -> PyResult<String> {
    let known = Code::ALL.iter().find(|known| known.id().eq_ignore_ascii_case(code.trim()));
    let lines = |code: &Code| code.explanation().lines().map(str::trim).collect::<Vec<_>>().join("\n");
    known
        .map(|code| format!("{}: {}\n\n{}", code.id(), code.title(), lines(code)))
        .ok_or_else(|| PyKeyError::new_err(format!("there is no code '{code}'")))
}
