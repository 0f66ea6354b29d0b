//! Values of Python as arguments.

use num_bigint::BigInt;
use polarform::number::{Int, Rational};
use polarform::value::Value as Native;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyInt, PyList, PyString, PyTuple, PyType};

use crate::value::Value;

/// An equation between two arguments, for functions that take some: `pf.solve(pf.Equation("x + 1", 3), "x")`.
#[pyclass(frozen, module = "polarform")]
pub struct Equation {
    left: Py<PyAny>,
    right: Py<PyAny>,
}

#[pymethods]
impl Equation {
    #[new]
    fn new(left: Py<PyAny>, right: Py<PyAny>) -> Self {
        Equation { left, right }
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!("Equation({}, {})", self.left.bind(py).repr()?, self.right.bind(py).repr()?))
    }
}

/// An argument: a formula to be read, a value, a list of arguments, an equation.
pub enum Operand {
    Text(String),
    Value(Native),
    List(Vec<Operand>),
    Equation(Box<[Operand; 2]>),
}

fn fraction_class<'py>(py: Python<'py>) -> PyResult<&'py Bound<'py, PyType>> {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    CLASS.import(py, "fractions", "Fraction")
}

/// An integer of any size.
pub fn integer(number: &Bound<'_, PyAny>) -> PyResult<Int> {
    match number.extract::<i64>() {
        Ok(small) => Ok(Int::from(small)),
        Err(_) => Ok(Int::from(number.extract::<BigInt>()?)),
    }
}

/// A number as Python's `Fraction`.
pub fn to_fraction<'py>(py: Python<'py>, number: &Rational) -> PyResult<Bound<'py, PyAny>> {
    fraction_class(py)?.call1((to_int(py, number.numer())?, to_int(py, number.denom())?))
}

/// An integer as Python's `int`.
pub fn to_int<'py>(py: Python<'py>, number: &Int) -> PyResult<Bound<'py, PyAny>> {
    Ok(match number.as_small() {
        Some(small) => small.into_pyobject(py)?.into_any(),
        None => number.to_big().into_pyobject(py)?.into_any(),
    })
}

/// What stands for an argument; lists, tuples and what Python's part of the module turns into such things.
///
/// # Errors
/// `TypeError` for what has no exact meaning, floating-point numbers above all.
pub fn operand(object: &Bound<'_, PyAny>) -> PyResult<Operand> {
    let py = object.py();
    if let Ok(value) = object.cast::<Value>() {
        return Ok(Operand::Value(value.get().value.clone()));
    }
    if object.is_instance_of::<PyInt>() {
        return Ok(Operand::Value(Native::number(Rational::from_integer(integer(object)?))));
    }
    if let Ok(text) = object.cast::<PyString>() {
        return Ok(Operand::Text(text.to_str()?.to_owned()));
    }
    if let Ok(list) = object.cast::<PyList>() {
        return list.iter().map(|item| operand(&item)).collect::<PyResult<_>>().map(Operand::List);
    }
    if let Ok(tuple) = object.cast::<PyTuple>() {
        return tuple.iter().map(|item| operand(&item)).collect::<PyResult<_>>().map(Operand::List);
    }
    if object.is_instance(fraction_class(py)?)? {
        let part = |name| integer(&object.getattr(name)?);
        let number = Rational::new(part("numerator")?, part("denominator")?);
        return Ok(Operand::Value(Native::number(number)));
    }
    if let Ok(equation) = object.cast::<Equation>() {
        let equation = equation.get();
        let sides = [operand(equation.left.bind(py))?, operand(equation.right.bind(py))?];
        return Ok(Operand::Equation(Box::new(sides)));
    }
    if object.is_instance_of::<PyFloat>() {
        return Err(PyTypeError::new_err(format!(
            "{object} is a floating-point number and no exact one; give a Fraction, or text such as '{object}'"
        )));
    }
    // SymPy, numpy, Decimal: in Python, which knows them if they are there.
    let convert = py.import("polarform._convert")?.getattr("argument")?;
    operand(&convert.call1((object,))?)
}
