"""Magics for Jupyter: `%load_ext polarform`, then `%polarform f(0, 1)` for one query and cells with `%%polarform`."""

from __future__ import annotations

import sys
from typing import Any

from ._errors import PolarformError
from ._native import Session, Value

#: The name of the session among the variables of the notebook.
SESSION = "polarform_session"


class CellError(PolarformError):
    """A cell of queries that failed; a notebook shows the place in the cell in place of a traceback."""

    def _render_traceback_(self) -> list[str]:
        return str(self).splitlines()


def _session(shell: Any) -> Session:
    session = shell.user_ns.get(SESSION)
    if not isinstance(session, Session):
        session = Session()
        shell.user_ns[SESSION] = session
    return session


def _run(shell: Any, text: str) -> list[Value]:
    try:
        return _session(shell).run(text)
    except PolarformError as error:
        details = dict(vars(error))
        message = details.pop("message")
        raise CellError(message, **details, rendered=str(error)) from None


def load(shell: Any) -> None:
    """Registers the magics."""
    from IPython.display import display as shown

    display: Any = shown

    def polarform(line: str, cell: str | None = None) -> Value | None:
        """%polarform QUERY gives the value of a query; a cell with %%polarform shows those of all its statements.

        Both use one session, `polarform_session`, whose names are kept. Options: `--new` begins a new session.
        """
        words = line.split()
        if "--new" in words:
            shell.user_ns[SESSION] = Session()
            words.remove("--new")
        if cell is None:
            if not words:
                return None
            values = _run(shell, line.replace("--new", "", 1) if "--new" in line.split() else line)
            _remarks(values)
            return values[-1]
        if words:
            raise ValueError(f"%%polarform has no option {words[0]}; there is --new")
        values = _run(shell, cell)
        _remarks(values)
        for value in values:
            display(value)
        return None

    shell.register_magic_function(polarform, magic_kind="line_cell", magic_name="polarform")


def _remarks(values: list[Value]) -> None:
    for value in values:
        for note in value.notes:
            print(f"note: {note}", file=sys.stderr)
