"""Every function of the language: `polar`, `casteljau`, `bspline`, `figure_bezier`, …

They are made of the table of functions when they are first used. An argument is a number, a `Fraction`, a list, a value,
an expression of SymPy, or text in the language of polarform; a named one may be left out.

>>> import polarform as pf
>>> pf.functions.elevate(pf.polar("t^2"), k=1)
f(t1, t2, t3) = 1/3 (t1 t2 + t1 t3 + t2 t3)
"""

from __future__ import annotations

import functools as _functools
import inspect as _inspect
import keyword as _keyword
import textwrap as _textwrap

from . import _native


@_functools.cache
def _table() -> dict[str, dict]:
    return {_identifier(entry["name"]): entry for entry in _native.function_table()}


def _identifier(name: str) -> str:
    return name + "_" if _keyword.iskeyword(name) else name


__all__ = sorted(_identifier(name) for name in _native.function_names())


def __getattr__(name: str):
    if name not in __all__:
        raise AttributeError(f"module 'polarform.functions' has no attribute {name!r}")
    made = _made(_table()[name])
    globals()[name] = made
    return made


def __dir__() -> list[str]:
    return list(__all__)


def _made(entry: dict):
    own = entry["name"]

    def function(*args, **kwargs):
        return _native.call(own, args, kwargs)

    function.__name__ = function.__qualname__ = _identifier(own)
    function.__module__ = __name__
    function.__doc__ = _documentation(entry)
    function.__signature__ = _signature(entry["parameters"])  # type: ignore[attr-defined]
    return function


def _lines(parameters: list[dict]) -> list[str]:
    lines: list[str] = []
    for parameter in parameters:
        lines += _textwrap.wrap(
            f"{parameter['name']}: {parameter['doc']}",
            100,
            initial_indent="    ",
            subsequent_indent="        ",
            break_long_words=False,
            break_on_hyphens=False,
        )
    return lines


def _documentation(entry: dict) -> str:
    lines = [f"{entry['form']}: {entry['summary']}.", "", *_lines(entry["parameters"])]
    for form, parameters in entry["variants"]:
        lines += ["", f"Also {form}:", *_lines(parameters)]
    for subject in entry["subjects"]:
        lines += ["", f"{subject['form']}: {subject['summary']}.", *_lines(subject["parameters"])]
    return "\n".join([*lines, "", *_example(entry["example"])])


def _example(query: str) -> list[str]:
    """The example as it runs, with what it gives."""
    value = _native.eval(query)
    picture = value.kind == "a figure"
    quote = "'" if '"' in query else '"'
    call = f"pf.eval({quote}{query}{quote})"
    if picture:
        return [f">>> {call}.kind", repr(value.kind)]
    return [f">>> print({call})", *(line.rstrip() or "<BLANKLINE>" for line in str(value).splitlines())]


def _signature(parameters: list[dict]) -> _inspect.Signature:
    """The parameters as Python shows them; the function itself is called with whatever the language takes."""
    kinds = _inspect.Parameter
    made: list[_inspect.Parameter] = []
    open_end = any(parameter["need"] in ("many", "free") for parameter in parameters)
    several = False
    for parameter in parameters:
        name, need = _identifier(parameter["name"]), parameter["need"]
        default = kinds.empty if need == "required" and not open_end else None
        if need == "many":
            several = True
            made.append(kinds(name if name.isidentifier() else "arguments", kinds.VAR_POSITIONAL))
        elif need == "free":
            made.append(kinds("values", kinds.VAR_KEYWORD))
        elif need == "named" or several:
            made.append(kinds(name, kinds.KEYWORD_ONLY, default=None))
        else:
            optional = any(other.default is None for other in made)
            default = None if optional else default
            made.append(kinds(name, kinds.POSITIONAL_OR_KEYWORD, default=default))
    return _inspect.Signature(sorted(made, key=lambda parameter: parameter.kind))
