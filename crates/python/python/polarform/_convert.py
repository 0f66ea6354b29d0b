"""Values of SymPy and numpy as arguments, and values of polarform as theirs. Both are imported only if they are there."""

from __future__ import annotations

import functools
import operator
import sys
from collections.abc import Iterable
from decimal import Decimal
from fractions import Fraction
from typing import Any

from . import _native


def argument(value: Any) -> Any:
    """What the compiled part can take in the place of a value: a number, text, a Value, or a list of such things."""
    if isinstance(value, Decimal):
        if not value.is_finite():
            raise TypeError(f"{value} is no number")
        return Fraction(value)
    sympy = sys.modules.get("sympy")
    if sympy is not None and isinstance(value, (sympy.Basic, sympy.MatrixBase)):
        return _from_sympy(value, sympy)
    numpy = sys.modules.get("numpy")
    if numpy is not None and isinstance(value, numpy.ndarray):
        return value.tolist()
    if numpy is not None and isinstance(value, numpy.floating):
        return float(value)
    if hasattr(type(value), "__index__"):
        return operator.index(value)
    if isinstance(value, Iterable) and not isinstance(value, (bytes, dict, set, frozenset)):
        return list(value)
    raise TypeError(
        f"{type(value).__name__} has no meaning here; give an integer, a Fraction, text, a list, a Value or an expression of SymPy"
    )


def _from_sympy(expr: Any, sympy: Any) -> Any:
    if isinstance(expr, sympy.MatrixBase):
        return [[argument(entry) for entry in row] for row in expr.tolist()]
    if isinstance(expr, sympy.Equality):
        return _native.Equation(argument(expr.lhs), argument(expr.rhs))
    if isinstance(expr, (sympy.Tuple, sympy.FiniteSet)):
        return [argument(item) for item in expr]
    if isinstance(expr, sympy.Poly):
        return _from_sympy(expr.as_expr(), sympy)
    return _formula(expr, sympy)


def _formula(expr: Any, sympy: Any) -> _native.Value:
    """A rational function of SymPy, term by term."""
    if isinstance(expr, sympy.Rational):
        return _native.Value(Fraction(int(expr.p), int(expr.q)))
    if isinstance(expr, sympy.Symbol):
        return _native.symbol(_name(expr.name))
    parts = (_formula(part, sympy) for part in expr.args)
    if isinstance(expr, sympy.Add):
        return functools.reduce(operator.add, parts)
    if isinstance(expr, sympy.Mul):
        return functools.reduce(operator.mul, parts)
    if isinstance(expr, sympy.Pow) and isinstance(expr.exp, sympy.Integer):
        return _formula(expr.base, sympy) ** int(expr.exp)
    hint = "; give a Rational in its place" if isinstance(expr, sympy.Float) else ""
    raise TypeError(f"{expr} ({type(expr).__name__} of SymPy) is no exact number, symbol or rational function{hint}")


def _name(name: str) -> str:
    """A name as polarform has it: λ is `lambda` there, which is no name of a variable in Python."""
    return name.removesuffix("_")


def to_sympy(value: _native.Value) -> Any:
    """The value as SymPy has it."""
    try:
        import sympy
    except ImportError as error:
        raise ImportError("SymPy is not installed: pip install sympy") from error
    return _sympy(value._data(), sympy)


def _symbol(name: str, sympy: Any) -> Any:
    return sympy.Symbol(name)


def _polynomial(terms: Any, sympy: Any) -> Any:
    return sympy.Add(
        *(
            sympy.Mul(sympy.Rational(p, q), *(_symbol(name, sympy) ** exponent for name, exponent in powers))
            for p, q, powers in terms
        )
    )


def _sympy(data: Any, sympy: Any) -> Any:
    kind, *rest = data
    if kind == "number":
        return sympy.Rational(rest[0].numerator, rest[0].denominator)
    if kind == "quotient":
        return _polynomial(rest[0], sympy) / _polynomial(rest[1], sympy)
    if kind == "list":
        return [_sympy(item, sympy) for item in rest[0]]
    if kind == "matrix":
        return sympy.Matrix([[_sympy(entry, sympy) for entry in row] for row in rest[0]])
    if kind == "function":
        names, body = rest
        return sympy.Lambda(tuple(_symbol(name, sympy) for name in names), _sympy(body, sympy))
    if kind == "piecewise":
        name, breaks, pieces, zero, closed = rest
        t = _symbol(name, sympy)
        ends = [_sympy(end, sympy) for end in breaks]
        cases = []
        for at, piece in enumerate(pieces):
            last = closed and at == len(pieces) - 1
            upper = t <= ends[at + 1] if last else t < ends[at + 1]
            cases.append((_sympy(piece, sympy), sympy.And(ends[at] <= t, upper)))
        if zero:
            cases.append((sympy.Integer(0), True))
        return sympy.Piecewise(*cases)
    if kind == "root":
        name, coefficients, lower, upper = rest
        rational = [sympy.Rational(c.numerator, c.denominator) for c in reversed(coefficients)]
        polynomial = sympy.Poly(rational, _symbol(name, sympy))
        low, high = (sympy.Rational(end.numerator, end.denominator) for end in (lower, upper))
        (root,) = (root for root in polynomial.real_roots(multiple=True) if low < root and root < high)
        return root
    if kind == "text":
        return rest[0]
    raise TypeError(f"a {kind} has no form in SymPy")


def to_numpy(value: _native.Value, dtype: Any = None) -> Any:
    """The value as an array: of fractions and, where there are symbols, values of polarform."""
    try:
        import numpy
    except ImportError as error:
        raise ImportError("numpy is not installed: pip install numpy") from error

    def entry(value: _native.Value) -> Any:
        try:
            items = value.items()
        except TypeError:
            pass
        else:
            return [entry(item) for item in items]
        try:
            return value.fraction()
        except TypeError:
            return value

    nested = entry(value)
    array = numpy.empty(_shape(nested), dtype=object)
    if array.shape == ():
        array[()] = nested
    else:
        _fill(array, nested)
    return array if dtype is None else array.astype(dtype)


def _shape(nested: Any) -> tuple[int, ...]:
    """The shape of lists in lists, as deep as they are of equal lengths."""
    if not isinstance(nested, list):
        return ()
    shapes = {_shape(item) for item in nested}
    return (len(nested), *(shapes.pop() if len(shapes) == 1 else ()))


def _fill(array: Any, nested: Any) -> None:
    for at, item in enumerate(nested):
        if array.ndim == 1:
            array[at] = item
        else:
            _fill(array[at], item)
