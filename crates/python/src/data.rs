//! Values in parts of Python, from which `_convert.py` makes expressions of SymPy and arrays of numpy.

use polarform::eval::Equals;
use polarform::piecewise::Outside;
use polarform::poly::{Fraction, MonomialOrder, MultiPoly, Symbol};
use polarform::session::Session;
use polarform::value::{Notation, Value as Native};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

use crate::argument::{to_fraction, to_int};
use crate::compute::{compute, limits};
use crate::error::exception;

fn terms<'py>(py: Python<'py>, polynomial: &MultiPoly) -> PyResult<Bound<'py, PyList>> {
    let list = PyList::empty(py);
    for (powers, coefficient) in polynomial.terms(MonomialOrder::Lex) {
        let powers: Vec<(String, u32)> =
            powers.into_iter().map(|(symbol, exponent)| (symbol.to_string(), exponent)).collect();
        list.append((to_int(py, coefficient.numer())?, to_int(py, coefficient.denom())?, powers))?;
    }
    Ok(list)
}

fn scalar<'py>(py: Python<'py>, formula: &Fraction) -> PyResult<Bound<'py, PyTuple>> {
    match formula.as_rational() {
        Some(number) => ("number", to_fraction(py, &number)?).into_pyobject(py),
        None => {
            ("quotient", terms(py, formula.numerator())?, terms(py, formula.denominator())?).into_pyobject(py)
        }
    }
}

fn function<'py>(py: Python<'py>, names: &[Symbol], formula: &Fraction) -> PyResult<Bound<'py, PyTuple>> {
    let names: Vec<String> = names.iter().map(Symbol::to_string).collect();
    ("function", names, scalar(py, formula)?).into_pyobject(py)
}

/// The value in parts.
pub fn data(py: Python<'_>, value: &Native) -> PyResult<Py<PyAny>> {
    let parts = match value {
        Native::Written(written) => return data(py, &written.value),
        Native::Scalar(formula) => scalar(py, formula)?,
        Native::Vector(formula) => ("vector", scalar(py, formula)?).into_pyobject(py)?,
        Native::Text(words) => ("text", words).into_pyobject(py)?,
        Native::List(items) => {
            let list = PyList::empty(py);
            for item in items {
                list.append(data(py, item)?)?;
            }
            ("list", list).into_pyobject(py)?
        }
        Native::Matrix(matrix) => {
            let rows = PyList::empty(py);
            for row in matrix.row_iter() {
                let list = PyList::empty(py);
                for entry in row.iter() {
                    list.append(scalar(py, entry)?)?;
                }
                rows.append(list)?;
            }
            ("matrix", rows).into_pyobject(py)?
        }
        Native::Algebraic(root) => {
            let coefficients = PyList::empty(py);
            for coefficient in root.number.polynomial().coefficients() {
                coefficients.append(to_fraction(py, &coefficient)?)?;
            }
            let (lower, upper) = root.number.ends();
            let name = root.variable.to_string();
            ("root", name, coefficients, to_fraction(py, &lower)?, to_fraction(py, &upper)?)
                .into_pyobject(py)?
        }
        Native::Polar(polar) => {
            // The form written out is a formula in its arguments.
            let arguments: Vec<Symbol> = polar.arguments().into_iter().flatten().flatten().collect();
            let mut body = polar.body(Notation::Expanded);
            let outcome = compute(py, &limits(), |limits| {
                Session::new(limits.clone()).evaluate(&mut body, Equals::Claims)
            })?;
            let outcome = outcome.map_err(|problem| {
                exception(py, &problem, &polarform::source::SourceFile::new("<value>", ""))
            })?;
            match outcome.value.plain() {
                Native::Scalar(formula) => function(py, &arguments, &formula)?,
                other => return Err(PyTypeError::new_err(format!("{} has no form in SymPy", other.kind()))),
            }
        }
        Native::Function(given) => match given.as_formula_of_many() {
            Some((names, formula)) => {
                let names: Vec<Symbol> = names.into_iter().cloned().collect();
                function(py, &names, formula)?
            }
            None => return Err(PyTypeError::new_err("a function in several cases has no form in SymPy")),
        },
        Native::Piecewise(given) => {
            let list = |formulas: &[Fraction]| -> PyResult<Bound<'_, PyList>> {
                let list = PyList::empty(py);
                for formula in formulas {
                    list.append(scalar(py, formula)?)?;
                }
                Ok(list)
            };
            let zero = given.function.outside() == Outside::Zero;
            let parts = (
                "piecewise",
                given.variable.to_string(),
                list(given.function.breaks())?,
                list(&given.formulas())?,
                zero,
                given.function.is_closed(),
            );
            parts.into_pyobject(py)?
        }
        other => {
            return Err(PyTypeError::new_err(format!(
                "{} has no form in SymPy; take its parts, such as pf.control_points(c), first",
                other.kind()
            )));
        }
    };
    Ok(parts.into_any().unbind())
}
