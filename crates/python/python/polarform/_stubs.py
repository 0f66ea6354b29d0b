"""Writes `functions.pyi` from the table of functions: `python -m polarform._stubs FOLDER`."""

from __future__ import annotations

import keyword
import sys
from pathlib import Path
from typing import Any

from . import _native

_HEAD = '"""Every function of the language. Written by `python -m polarform._stubs`."""'

_TYPES = {"integer": "Integer", "number": "Number", "flag": "Integer", "text": "str", "list": "Items"}


def _annotation(parameter: dict[str, Any]) -> str:
    if parameter["kind"] == "word" and parameter["words"]:
        return "Literal[" + ", ".join(f'"{word}"' for word in parameter["words"]) + "]"
    return _TYPES.get(parameter["kind"], "Argument")


def _identifier(name: str) -> str:
    return name + "_" if keyword.iskeyword(name) else name


def _signatures(parameters: list[dict[str, Any]], subject: str | None) -> list[str]:
    """How it is called; with free names in place of what follows the first argument, in two ways."""
    free = any(parameter["need"] == "free" for parameter in parameters)
    places = [f'subject: Literal["{subject}"]'] if subject else []
    first = len(places) + 1
    named: list[str] = []
    several: str | None = None
    optional = False
    for parameter in parameters:
        need, kind = parameter["need"], _annotation(parameter)
        name = _identifier(parameter["name"])
        if need == "many":
            several = f"*{name if name.isidentifier() else 'arguments'}: {kind}"
        elif need == "named" or several is not None:
            named.append(f"{name}: {kind} | None = None")
        elif need == "required" and not optional:
            places.append(f"{name}: {kind}")
        elif need in ("required", "optional"):
            optional = True
            places.append(f"{name}: {kind} | None = None")
    star = [several] if several else ["*"] if named else []
    ways = [places + star + named]
    if free:
        ways.append(places[:first] + ["**values: Argument"])
    return [", ".join(way) for way in ways]


def text() -> str:
    """The text of `functions.pyi`."""
    table = _native.function_table()
    lines = [_HEAD, "", "from typing import Literal, overload", ""]
    lines += ["from ._native import Argument, Integer, Items, Number, Value", ""]
    lines += ["__all__ = [", *(f'    "{_identifier(entry["name"])}",' for entry in table), "]", ""]
    for entry in table:
        forms = [(entry["parameters"], None)] + [(parameters, None) for _, parameters in entry["variants"]]
        if entry["subjects"]:
            forms = [(subject["parameters"], subject["name"]) for subject in entry["subjects"]]
        found: list[str] = []
        for parameters, subject in forms:
            found += [way for way in _signatures(parameters, subject) if way not in found]
        for way in found:
            lines += ["@overload"] if len(found) > 1 else []
            lines.append(f"def {_identifier(entry['name'])}({way}) -> Value: ...")
    return "\n".join(lines) + "\n"


def main() -> None:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    (folder / "functions.pyi").write_text(text(), encoding="utf-8")


if __name__ == "__main__":
    main()
