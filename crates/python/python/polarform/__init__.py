"""Exact polynomials and their polar forms (blossoms): ask, write, check.

>>> import polarform as pf
>>> f = pf.polar("t^3 + 3t^2 + 5t + 1")
>>> print(f)
f(t1, t2, t3) = t1 t2 t3 + (t1 t2 + t1 t3 + t2 t3) + 5/3 (t1 + t2 + t3) + 1
>>> f(0, 0, 1)
8/3
>>> f(0, 0, 1).fraction()
Fraction(8, 3)

A text is a query in the language of polarform, in plain notation or LaTeX; a session keeps names:

>>> session = pf.Session()
>>> session.eval("F(t) := t^2 + 2t; f := polar(F)")
f(t1, t2) = t1 t2 + (t1 + t2)
>>> session.eval(r"f(0, \\frac12)")
1/2
>>> pf.eval("f(t1, t2) = t1 t2 + 2 (t1 + t2)", f=session["f"]).verdict
'refuted'

Lecture notes are checked as they stand:

>>> [finding.suggestion for finding in pf.check("Now $2 + 2 = 5$.").refuted]
['2 + 2 = 4']

Every function of the language is a function here, too; `help(pf.functions)` lists them.
"""

from __future__ import annotations

import contextlib as _contextlib
from collections.abc import Iterator as _Iterator
from typing import TYPE_CHECKING as _TYPE_CHECKING, Any as _Any

from . import functions
from ._errors import LimitError, PolarformError, PolarformWarning
from ._native import (
    Equation,
    Finding,
    Problem,
    Report,
    Session,
    Value,
    __version__,
    check,
    check_file,
    eval,
    explain,
    get_limits as _get_limits,
    set_limits as _set_limits,
    symbol,
    vector,
)

if _TYPE_CHECKING:
    from .functions import *

__all__ = [
    "Equation",
    "Finding",
    "LimitError",
    "PolarformError",
    "PolarformWarning",
    "Problem",
    "Report",
    "Session",
    "Value",
    "__version__",
    "check",
    "check_file",
    "eval",
    "explain",
    "functions",
    "limits",
    "symbol",
    "vector",
]


def __getattr__(name: str) -> _Any:
    # pf.polar is pf.functions.polar, and so on.
    if name in functions.__all__:
        return getattr(functions, name)
    raise AttributeError(f"module 'polarform' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *functions.__all__})


@_contextlib.contextmanager
def _restored(before: tuple[float | None, int, int, int]) -> _Iterator[None]:
    try:
        yield
    finally:
        timeout, terms, digits, depth = before
        _set_limits(timeout or 0, terms, digits, depth)


def limits(
    *,
    timeout: float | None = None,
    max_terms: int | None = None,
    max_digits: int | None = None,
    max_depth: int | None = None,
) -> _contextlib.AbstractContextManager[None]:
    """Sets limits: seconds (0 for no limit), terms of a value, digits of a number, nested calls; what is not given stays.

    They hold from now on, or inside of `with`:

    >>> import polarform as pf
    >>> with pf.limits(max_terms=100):
    ...     try:
    ...         pf.eval("expand((x + y + z)^100)")
    ...     except pf.LimitError as error:
    ...         print(error.code)
    E402
    """
    before = _get_limits()
    _set_limits(timeout, max_terms, max_digits, max_depth)
    return _restored(before)


def load_ipython_extension(shell: _Any) -> None:
    """`%load_ext polarform`: the magics `%polarform` and `%%polarform`."""
    from .magic import load

    load(shell)
