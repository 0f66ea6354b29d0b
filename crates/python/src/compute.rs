//! Computations under limits, without the lock of the interpreter, that the user can stop.

use std::cell::{Cell, RefCell};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use polarform::budget::{Limits, MOST_DEPTH};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::error::defect;

/// Bits of a decimal digit, rounded up.
const BITS: f64 = std::f64::consts::LOG2_10;

/// Signals are looked for so often.
const LOOK: Duration = Duration::from_millis(20);

/// What can be set: seconds, terms, digits, depth.
type Settings = (Option<f64>, u64, u64, usize);

static LIMITS: Mutex<Option<Limits>> = Mutex::new(None);

thread_local! {
    /// What a signal raised while Rust was at work.
    static RAISED: RefCell<Option<PyErr>> = const { RefCell::new(None) };
    static LOOKED: Cell<Option<Instant>> = const { Cell::new(None) };
}

/// The limits of all that has none of its own.
pub fn limits() -> Limits {
    LIMITS.lock().unwrap_or_else(PoisonError::into_inner).clone().unwrap_or_default()
}

/// Limits from what Python gives; what is `None` is as in `base`.
pub fn changed(
    base: Limits,
    timeout: Option<f64>,
    max_terms: Option<u64>,
    max_digits: Option<u64>,
    max_depth: Option<usize>,
) -> PyResult<Limits> {
    let mut limits = base;
    if let Some(seconds) = timeout {
        let time = Duration::try_from_secs_f64(seconds)
            .map_err(|_| PyValueError::new_err("timeout is a number of seconds, 0 for no limit"))?;
        limits.time = (!time.is_zero()).then_some(time);
    }
    if let Some(depth) = max_depth.filter(|depth| *depth > MOST_DEPTH) {
        return Err(PyValueError::new_err(format!("max_depth is at most {MOST_DEPTH}, not {depth}")));
    }
    limits.terms = max_terms.unwrap_or(limits.terms);
    limits.bits = max_digits.map_or(limits.bits, |digits| (digits as f64 * BITS).ceil() as u64);
    limits.depth = max_depth.unwrap_or(limits.depth);
    Ok(limits)
}

fn settings(limits: &Limits) -> Settings {
    let digits = (limits.bits as f64 / BITS) as u64;
    (limits.time.map(|time| time.as_secs_f64()), limits.terms, digits, limits.depth)
}

/// The limits of all that has none of its own: seconds, terms, digits, depth.
#[pyfunction]
pub fn get_limits() -> Settings {
    settings(&limits())
}

/// Sets limits; those not given stay.
#[pyfunction]
#[pyo3(signature = (timeout=None, max_terms=None, max_digits=None, max_depth=None))]
pub fn set_limits(
    timeout: Option<f64>,
    max_terms: Option<u64>,
    max_digits: Option<u64>,
    max_depth: Option<usize>,
) -> PyResult<()> {
    let new = changed(limits(), timeout, max_terms, max_digits, max_depth)?;
    *LIMITS.lock().unwrap_or_else(PoisonError::into_inner) = Some(new);
    Ok(())
}

/// Whether a signal has raised something, such as KeyboardInterrupt. Other threads of Python may run meanwhile.
fn signalled() -> bool {
    if RAISED.with_borrow(Option::is_some) {
        return true;
    }
    let now = Instant::now();
    if LOOKED.get().is_some_and(|last| now.duration_since(last) < LOOK) {
        return false;
    }
    LOOKED.set(Some(now));
    let raised = Python::attach(|py| py.check_signals().err());
    RAISED.with_borrow_mut(|slot| {
        *slot = raised;
        slot.is_some()
    })
}

/// Does something without the lock of the interpreter; a signal stops it, and what it raises is the result.
pub fn compute<T: Send>(
    py: Python<'_>,
    limits: &Limits,
    work: impl FnOnce(&Limits) -> T + Send,
) -> PyResult<T> {
    let limits = Limits { interrupt: Arc::default(), watch: Some(signalled), ..limits.clone() };
    // The first look costs nothing to a computation that is short.
    LOOKED.set(Some(Instant::now()));
    let result = py.detach(|| catch_unwind(AssertUnwindSafe(|| work(&limits))));
    match (RAISED.take(), result) {
        (Some(raised), _) => Err(raised),
        (None, Ok(result)) => Ok(result),
        (None, Err(_)) => Err(defect(py)),
    }
}
