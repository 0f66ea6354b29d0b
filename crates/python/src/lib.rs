//! polarform as a Python module: values, sessions, verdicts. Everything that decides stands in the library; what is
//! here turns Python's values into arguments and back. `python/polarform` beside it is the module that people import.

mod argument;
mod call;
mod check;
mod compute;
mod data;
mod error;
mod session;
mod table;
mod value;

use pyo3::prelude::*;

/// The part of the module that is compiled.
#[pymodule]
mod _native {
    #[pymodule_export]
    use super::argument::Equation;
    #[pymodule_export]
    use super::call::call;
    #[pymodule_export]
    use super::check::{Finding, Problem, Report, check, check_file};
    #[pymodule_export]
    use super::compute::{get_limits, set_limits};
    #[pymodule_export]
    use super::session::{Session, eval};
    #[pymodule_export]
    use super::table::{explain, function_names, function_table};
    #[pymodule_export]
    use super::value::{Value, fraction_of_terms, symbol, vector};
    #[pymodule_export]
    #[allow(non_upper_case_globals)]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
