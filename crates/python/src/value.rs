//! Values of the language as objects of Python.

use std::hash::{DefaultHasher, Hash, Hasher};

use polarform::budget;
use polarform::diagnostic::{Code, Diagnostic, Severity};
use polarform::expr::Expr;
use polarform::figure::{SvgOptions, TikzOptions, figure_json, svg, terminal, tikz};
use polarform::number::{Int, Rational};
use polarform::poly::{Fraction, MultiPoly, Symbol};
use polarform::session::Session;
use polarform::source::SourceFile;
use polarform::value::{Cell, Claim, Language, Notation, Value as Native, Verdict};
use polarform::write::{Format, Manner, write_answer, write_expr};
use pyo3::exceptions::{PyIndexError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::argument::{Operand, integer, operand, to_fraction, to_int};
use crate::call::{Callee, Given, answered};
use crate::compute::{compute, limits};
use crate::data::data;
use crate::error::{exception, warn};

/// The columns and rows of a picture in characters.
const PREVIEW: (usize, usize) = (72, 20);

/// A value: a number, a formula, a polar form, a curve, a matrix, a claim with its verdict, a picture, …
#[pyclass(frozen, module = "polarform")]
pub struct Value {
    pub value: Native,
    name: Option<Expr>,
    notes: Vec<Diagnostic>,
}

impl Value {
    pub fn new(value: Native, name: Option<Expr>, notes: Vec<Diagnostic>) -> Self {
        Value { value, name, notes }
    }

    /// The same for an answer: what could have been read otherwise is a warning.
    pub fn told(py: Python<'_>, value: Native, name: Option<Expr>, notes: Vec<Diagnostic>) -> PyResult<Self> {
        for note in &notes {
            let usual = note.code == Code::StandardMeaning && note.hints.is_empty();
            // E2…: how names and formulas are read. What a value or a verdict says by itself is no warning.
            let reading = note.code == Code::AmbiguousVariable
                || note.code.id().starts_with("E2") && note.code != Code::NoIdentity;
            if reading && !usual {
                let hints = note.hints.iter().map(|hint| format!("; {hint}")).collect::<String>();
                warn(py, &format!("{}{hints}", note.message))?;
            }
        }
        Ok(Value::new(value, name, notes))
    }

    fn bare(value: Native) -> Self {
        Value::new(value, None, Vec::new())
    }

    /// The value itself, however it is arranged.
    fn plain(&self) -> &Native {
        match &self.value {
            Native::Written(written) => &written.value,
            value => value,
        }
    }

    fn number(&self) -> PyResult<Rational> {
        self.plain()
            .as_rational()
            .ok_or_else(|| PyTypeError::new_err(format!("{} is no rational number", self.value.kind())))
    }

    fn claim(&self) -> PyResult<&Claim> {
        match self.plain() {
            Native::Claim(claim) => Ok(claim),
            other => Err(PyTypeError::new_err(format!("{} has no verdict", other.kind()))),
        }
    }

    /// The items of what has some: lists, rows of matrices, rows of tables.
    fn list(&self) -> PyResult<Vec<Native>> {
        let row = |cells: &Vec<Cell>| Native::List(cells.iter().filter_map(cell).collect());
        match self.plain() {
            Native::List(items) => Ok(items.iter().cloned().collect()),
            Native::Matrix(matrix) => Ok(matrix
                .row_iter()
                .map(|row| Native::List(row.iter().cloned().map(Native::Scalar).collect()))
                .collect()),
            Native::Table(table) => Ok(table.rows.iter().map(row).collect()),
            other => Err(PyTypeError::new_err(format!("{} has no items", other.kind()))),
        }
    }

    fn written(&self, py: Python<'_>, manner: Manner) -> PyResult<String> {
        let done = compute(py, &limits(), |limits| {
            budget::run(limits, || write_answer(&self.value, self.name.clone(), &manner))
        })?;
        match done {
            Ok(written) => written.map_err(|error| PyTypeError::new_err(error.to_string())),
            Err(stop) => {
                let problem = Diagnostic::error(
                    match stop {
                        budget::Stop::Terms { .. } => Code::TooManyTerms,
                        budget::Stop::Bits { .. } => Code::TooManyDigits,
                        _ => Code::Timeout,
                    },
                    stop.to_string(),
                );
                Err(exception(py, &problem, &SourceFile::new("<value>", "")))
            }
        }
    }

    fn combined(&self, sign: &'static str, other: &Bound<'_, PyAny>, swapped: bool) -> PyResult<Py<PyAny>> {
        let py = other.py();
        let own = Operand::Value(self.value.clone());
        let other = match operand(other) {
            // "1" + value says nothing about what is meant.
            Ok(Operand::Text(_)) => return Ok(py.NotImplemented()),
            Err(error) if error.is_instance_of::<PyTypeError>(py) => return Ok(py.NotImplemented()),
            other => other?,
        };
        let places = if swapped { vec![other, own] } else { vec![own, other] };
        let value =
            answered(py, &Session::new(limits()), Callee::Sign(sign), Given { places, named: Vec::new() })?;
        Ok(Py::new(py, value)?.into_any())
    }
}

/// What stands in a cell, if it is a value.
fn cell(cell: &Cell) -> Option<Native> {
    match cell {
        Cell::Value(value) | Cell::Labelled(_, value) => Some(value.clone()),
        _ => None,
    }
}

fn parsed<T: std::str::FromStr>(what: &str, word: &str) -> PyResult<T> {
    word.parse().map_err(|_| PyValueError::new_err(format!("there is no {what} '{word}'")))
}

fn notation(word: &str) -> PyResult<Notation> {
    Ok(match word {
        "grouped" => Notation::Grouped,
        "expanded" => Notation::Expanded,
        "sigma" => Notation::Sigma,
        "ellipsis" => Notation::Ellipsis,
        _ => return Err(PyValueError::new_err("the notations are grouped, expanded, sigma and ellipsis")),
    })
}

#[pymethods]
impl Value {
    /// The value of a formula, a number, a list, an expression of SymPy.
    #[new]
    fn from_python(py: Python<'_>, value: &Bound<'_, PyAny>) -> PyResult<Self> {
        let given = Given { places: vec![operand(value)?], named: Vec::new() };
        answered(py, &Session::new(limits()), Callee::Sign("+"), given)
    }

    /// What kind of value it is, in words: "a number", "a polar form".
    #[getter]
    fn kind(&self) -> &'static str {
        self.value.kind()
    }

    /// The name under which it was defined.
    #[getter]
    fn name(&self) -> Option<String> {
        self.name.as_ref().and_then(|name| write_expr(name, Format::Text).ok())
    }

    /// How the query was read where it could be read otherwise, and what else is worth knowing.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.notes
            .iter()
            .filter(|note| note.severity != Severity::Error)
            .map(|note| note.message.clone())
            .collect()
    }

    /// The names of the symbols in a number or formula.
    #[getter]
    fn variables(&self) -> Vec<String> {
        self.plain()
            .as_scalar()
            .map(Fraction::variables)
            .unwrap_or_default()
            .iter()
            .map(Symbol::to_string)
            .collect()
    }

    /// As text: `format` is text, unicode, latex, json or sympy; `notation`, of polar forms, is grouped, expanded,
    /// sigma or ellipsis; `width` breaks wider LaTeX, in points; `lang`, of derivations, is en or zh.
    #[pyo3(signature = (format="text", *, notation="grouped", width=None, lang="en"))]
    fn text(
        &self,
        py: Python<'_>,
        format: &str,
        notation: &str,
        width: Option<f64>,
        lang: &str,
    ) -> PyResult<String> {
        let manner = Manner {
            format: parsed::<Format>("format", format)?,
            notation: self::notation(notation)?,
            language: parsed::<Language>("language", lang)?,
            width: width.unwrap_or(f64::INFINITY),
            ..Manner::default()
        };
        if let (Native::Figure(scene), Format::Json) = (&self.value, manner.format) {
            return compute(py, &limits(), |_| figure_json(scene).to_string());
        }
        self.written(py, manner)
    }

    /// As LaTeX, for a formula; `width` breaks what is wider, in points.
    #[pyo3(signature = (*, notation="grouped", width=None, lang="en"))]
    fn latex(&self, py: Python<'_>, notation: &str, width: Option<f64>, lang: &str) -> PyResult<String> {
        match &self.value {
            Native::Figure(_) => self.tikz(py, false),
            _ => self.text(py, "latex", notation, width, lang),
        }
    }

    fn __str__(&self, py: Python<'_>) -> PyResult<String> {
        match &self.value {
            Native::Figure(scene) => compute(py, &limits(), |_| terminal(scene, PREVIEW.0, PREVIEW.1)),
            _ => self.written(py, Manner::default()),
        }
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        self.__str__(py)
    }

    /// For notebooks.
    fn _repr_latex_(&self, py: Python<'_>) -> PyResult<Option<String>> {
        Ok(match &self.value {
            Native::Figure(_) | Native::Text(_) | Native::Claim(_) => None,
            Native::List(items)
                if items.iter().any(|item| matches!(item, Native::Text(_) | Native::Figure(_))) =>
            {
                None
            }
            Native::Derivation(_) => Some(format!("$$\n{}\n$$", self.latex(py, "grouped", None, "en")?)),
            _ => Some(format!("$\\displaystyle {}$", self.latex(py, "grouped", None, "en")?)),
        })
    }

    /// For notebooks: pictures.
    fn _repr_svg_(&self, py: Python<'_>) -> PyResult<Option<String>> {
        if matches!(self.value, Native::Figure(_)) { self.svg(py).map(Some) } else { Ok(None) }
    }

    /// A picture as SVG.
    fn svg(&self, py: Python<'_>) -> PyResult<String> {
        match &self.value {
            Native::Figure(scene) => compute(py, &limits(), |_| svg(scene, &SvgOptions::default())),
            other => Err(PyTypeError::new_err(format!("{} is no picture", other.kind()))),
        }
    }

    /// A picture as TikZ; `standalone` makes a document of it.
    #[pyo3(signature = (standalone=false))]
    fn tikz(&self, py: Python<'_>, standalone: bool) -> PyResult<String> {
        match &self.value {
            Native::Figure(scene) => compute(py, &limits(), |_| tikz(scene, &TikzOptions { standalone })),
            other => Err(PyTypeError::new_err(format!("{} is no picture", other.kind()))),
        }
    }

    /// A number as `fractions.Fraction`.
    fn fraction<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_fraction(py, &self.number()?)
    }

    /// The numerator of a number; of a formula, a formula.
    #[getter]
    fn numerator(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.part(py, Rational::numer, Fraction::numerator)
    }

    /// The denominator of a number; of a formula, a formula.
    #[getter]
    fn denominator(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.part(py, Rational::denom, Fraction::denominator)
    }

    /// Numerator and denominator of a number.
    fn as_integer_ratio<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let number = self.number()?;
        Ok((to_int(py, number.numer())?, to_int(py, number.denom())?))
    }

    fn __int__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let number = self.number()?;
        match number.is_integer() {
            true => to_int(py, number.numer()),
            false => Err(PyValueError::new_err(format!("{number} is no integer"))),
        }
    }

    fn __index__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.__int__(py).map_err(|error| PyTypeError::new_err(error.value(py).to_string()))
    }

    /// The nearest floating-point number.
    fn __float__(&self, py: Python<'_>) -> PyResult<f64> {
        match self.plain() {
            Native::Algebraic(root) => {
                // The ends of an interval around it, until both have the same nearest floating-point number.
                let mut number = root.number.clone();
                loop {
                    let (low, high) = number.ends();
                    let near = |end: &Rational| -> PyResult<f64> {
                        to_fraction(py, end)?.call_method0("__float__")?.extract()
                    };
                    let (below, above) = (near(&low)?, near(&high)?);
                    if below == above {
                        return Ok(below);
                    }
                    number = number.refined(&((high - low) / Rational::from_integer(Int::from(1_i64 << 32))));
                }
            }
            _ => self.fraction(py)?.call_method0("__float__")?.extract(),
        }
    }

    fn __bool__(&self) -> PyResult<bool> {
        match self.plain() {
            Native::Claim(claim) => match claim.verdict() {
                Verdict::Proved | Verdict::Sampled => Ok(true),
                Verdict::Refuted => Ok(false),
                Verdict::Undecided => {
                    Err(PyValueError::new_err("the claim is undecided; look at its verdict"))
                }
            },
            Native::Scalar(formula) => Ok(*formula != Fraction::from(MultiPoly::zero())),
            Native::List(items) => Ok(!items.is_empty()),
            _ => Ok(true),
        }
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        let py = other.py();
        let same = match operand(other) {
            Ok(Operand::Value(other)) => *self.plain() == other.plain(),
            _ => return Ok(py.NotImplemented()),
        };
        Ok(same.into_pyobject(py)?.to_owned().into_any().unbind())
    }

    fn __hash__(&self, py: Python<'_>) -> PyResult<isize> {
        // A number is equal to Python's numbers, so their hashes are equal.
        if let Some(number) = self.plain().as_rational() {
            return to_fraction(py, &number)?.hash();
        }
        match self.plain() {
            Native::Scalar(formula) => {
                let mut hasher = DefaultHasher::new();
                formula.to_string().hash(&mut hasher);
                Ok(hasher.finish() as isize)
            }
            other => Err(PyTypeError::new_err(format!("{} has no hash", other.kind()))),
        }
    }

    fn __len__(&self) -> PyResult<usize> {
        self.list().map(|items| items.len())
    }

    fn __getitem__(&self, py: Python<'_>, index: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        if let Ok(place) = index.cast::<PyTuple>() {
            let mut found: Py<PyAny> = Py::new(py, Value::bare(self.value.clone()))?.into_any();
            for index in place.iter() {
                found = found.bind(py).get_item(index)?.unbind();
            }
            return Ok(found);
        }
        let mut items = self.list()?;
        let length = items.len() as isize;
        let at: isize = index.extract()?;
        let at = if at < 0 { at + length } else { at };
        if !(0..length).contains(&at) {
            return Err(PyIndexError::new_err(format!("there are {length} items, counted from 0")));
        }
        Ok(Py::new(py, Value::bare(items.swap_remove(at as usize)))?.into_any())
    }

    /// The items of a list, the rows of a matrix or table.
    fn items(&self) -> PyResult<Vec<Value>> {
        Ok(self.list()?.into_iter().map(Value::bare).collect())
    }

    fn __iter__(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        let items = self.items()?.into_pyobject(py)?;
        Ok(items.try_iter()?.into_any().unbind())
    }

    /// Rows and columns of a matrix.
    #[getter]
    fn shape(&self) -> PyResult<(usize, usize)> {
        match self.plain() {
            Native::Matrix(matrix) => Ok(matrix.shape()),
            other => Err(PyTypeError::new_err(format!("{} has no rows and columns", other.kind()))),
        }
    }

    /// The verdict on a claim: proved, sampled, refuted or undecided.
    #[getter]
    fn verdict(&self) -> PyResult<&'static str> {
        Ok(self.claim()?.verdict().word())
    }

    /// Why a claim got its verdict.
    #[getter]
    fn reasons(&self) -> PyResult<Vec<String>> {
        Ok(self.claim()?.judgements.iter().flat_map(|judgement| judgement.reasons.clone()).collect())
    }

    /// Values of the symbols at which the sides of a claim differ, and these: `{"t": …, "left": …, "right": …}`.
    #[getter]
    fn counterexample<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let claim = self.claim()?;
        let Some(witness) = claim.judgements.iter().find_map(|judgement| judgement.witness.as_ref()) else {
            return Ok(None);
        };
        let found = PyDict::new(py);
        for (symbol, value) in &witness.assignment {
            found.set_item(symbol.to_string(), to_fraction(py, value)?)?;
        }
        found.set_item("left", to_fraction(py, &witness.left)?)?;
        found.set_item("right", to_fraction(py, &witness.right)?)?;
        Ok(Some(found))
    }

    /// What it is at its arguments: a value of a function, of a polar form, of a curve.
    #[pyo3(signature = (*args, **kwargs))]
    fn __call__(
        &self,
        py: Python<'_>,
        args: &Bound<'_, PyTuple>,
        kwargs: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Value> {
        let callable = matches!(
            self.plain(),
            Native::Polar(_)
                | Native::Function(_)
                | Native::Builtin(_)
                | Native::Geometry(_)
                | Native::Piecewise(_)
                | Native::List(_)
        );
        if !callable {
            return Err(PyTypeError::new_err(format!(
                "{} is not called; put values in with pf.subs(value, t=3)",
                self.value.kind()
            )));
        }
        answered(py, &Session::new(limits()), Callee::Value(self.value.clone()), Given::of(args, kwargs)?)
    }

    fn __add__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        self.combined("+", other, false)
    }

    fn __radd__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        self.combined("+", other, true)
    }

    fn __sub__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        self.combined("-", other, false)
    }

    fn __rsub__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        self.combined("-", other, true)
    }

    fn __mul__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        self.combined("*", other, false)
    }

    fn __rmul__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        self.combined("*", other, true)
    }

    fn __matmul__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        self.combined("*", other, false)
    }

    fn __truediv__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        self.combined("/", other, false)
    }

    fn __rtruediv__(&self, other: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        self.combined("/", other, true)
    }

    fn __pow__(&self, other: &Bound<'_, PyAny>, modulus: Option<&Bound<'_, PyAny>>) -> PyResult<Py<PyAny>> {
        match modulus {
            Some(_) => Ok(other.py().NotImplemented()),
            None => self.combined("^", other, false),
        }
    }

    fn __rpow__(&self, other: &Bound<'_, PyAny>, modulus: Option<&Bound<'_, PyAny>>) -> PyResult<Py<PyAny>> {
        match modulus {
            Some(_) => Ok(other.py().NotImplemented()),
            None => self.combined("^", other, true),
        }
    }

    fn __neg__(&self, py: Python<'_>) -> PyResult<Value> {
        let given = Given { places: vec![Operand::Value(self.value.clone())], named: Vec::new() };
        answered(py, &Session::new(limits()), Callee::Sign("-"), given)
    }

    /// The claim that it is equal to something, with its verdict.
    fn equals(&self, py: Python<'_>, other: &Bound<'_, PyAny>) -> PyResult<Value> {
        let places = vec![Operand::Value(self.value.clone()), operand(other)?];
        answered(py, &Session::new(limits()), Callee::Sign("="), Given { places, named: Vec::new() })
    }

    /// The value in parts, for `sympy()` and `numpy()`.
    fn _data(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        data(py, self.plain())
    }

    /// As an expression of SymPy; lists as lists, matrices as matrices.
    fn sympy(slf: &Bound<'_, Self>) -> PyResult<Py<PyAny>> {
        Ok(slf.py().import("polarform._convert")?.getattr("to_sympy")?.call1((slf,))?.unbind())
    }

    /// As an array of numpy, of fractions unless `dtype` says otherwise.
    #[pyo3(signature = (dtype=None))]
    fn numpy(slf: &Bound<'_, Self>, dtype: Option<&Bound<'_, PyAny>>) -> PyResult<Py<PyAny>> {
        Ok(slf.py().import("polarform._convert")?.getattr("to_numpy")?.call1((slf, dtype))?.unbind())
    }

    /// The value as objects of JSON.
    fn json(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        let text = self.text(py, "json", "grouped", None, "en")?;
        Ok(py.import("json")?.call_method1("loads", (text,))?.unbind())
    }
}

impl Value {
    /// A part of a quotient: of a number, an integer.
    fn part(
        &self,
        py: Python<'_>,
        number: fn(&Rational) -> &Int,
        formula: fn(&Fraction) -> &MultiPoly,
    ) -> PyResult<Py<PyAny>> {
        let value = self.plain().as_scalar();
        let value =
            value.ok_or_else(|| PyTypeError::new_err(format!("{} is no quotient", self.value.kind())))?;
        match value.as_rational() {
            Some(value) => Ok(to_int(py, number(&value))?.unbind()),
            None => {
                let part = Fraction::from(formula(value).clone());
                Ok(Py::new(py, Value::bare(Native::Scalar(part)))?.into_any())
            }
        }
    }
}

/// The symbol of a name, such as `t` or `b_0`; it stands for itself.
#[pyfunction]
pub fn symbol(py: Python<'_>, name: &str) -> PyResult<Value> {
    let symbol = crate::session::symbol_of(&Session::new(limits()), name)
        .map_err(|failure| crate::error::failed(py, &failure))?;
    Ok(Value::bare(Native::symbol(symbol)))
}

/// The vector argument of polar forms: f(0, 1, vector(1)) is f(0, 1, hat 1).
#[pyfunction]
pub fn vector(py: Python<'_>, value: &Bound<'_, PyAny>) -> PyResult<Value> {
    let given = Given { places: vec![operand(value)?], named: Vec::new() };
    answered(py, &Session::new(limits()), Callee::Sign("hat"), given)
}

/// Terms of a polynomial: numerator, denominator, and the exponents by the names of the symbols.
type PyTerms<'py> = Vec<(Bound<'py, PyAny>, Bound<'py, PyAny>, Vec<(String, u32)>)>;

/// The quotient of two polynomials given by their terms.
#[pyfunction]
pub fn fraction_of_terms(py: Python<'_>, above: PyTerms<'_>, below: PyTerms<'_>) -> PyResult<Value> {
    let session = Session::new(limits());
    let polynomial = |terms: PyTerms<'_>| -> PyResult<MultiPoly> {
        let terms = terms.into_iter().map(|(numerator, denominator, powers)| {
            let denominator: Int = integer(&denominator)?;
            if denominator == Int::from(0_i64) {
                return Err(PyValueError::new_err("a denominator is 0"));
            }
            let powers = powers.into_iter().map(|(name, exponent)| {
                let symbol = crate::session::symbol_of(&session, &name)
                    .map_err(|failure| crate::error::failed(py, &failure))?;
                Ok((symbol, exponent))
            });
            Ok((powers.collect::<PyResult<_>>()?, Rational::new(integer(&numerator)?, denominator)))
        });
        Ok(MultiPoly::from_terms(terms.collect::<PyResult<Vec<_>>>()?))
    };
    let (above, below) = (polynomial(above)?, polynomial(below)?);
    let quotient = compute(py, &limits(), |_| Fraction::new(above, below))?;
    quotient
        .map(|formula| Value::bare(Native::Scalar(formula)))
        .map_err(|error| PyValueError::new_err(error.to_string()))
}
