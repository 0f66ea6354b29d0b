"""What is raised when a query has no answer."""

from __future__ import annotations

from typing import Any


class PolarformError(Exception):
    """A query or page has no answer; `str(error)` shows the place with a caret.

    >>> import polarform as pf
    >>> try:
    ...     pf.eval("t^2 +")
    ... except pf.PolarformError as error:
    ...     print(error.code, error.span, error.line, error.column)
    E103 (4, 5) 1 5
    """

    #: The stable code, such as ``E203``; ``pf.explain(code)`` tells more.
    code: str
    #: What is wrong, in one sentence.
    message: str
    #: Why, if that is known.
    reason: str | None
    #: What to do about it.
    hints: list[str]
    #: The text in which the place is.
    source: str
    #: The characters that are wrong: ``error.source[start:end]``.
    span: tuple[int, int] | None
    #: Counted from 1.
    line: int | None
    #: Counted from 1, in characters.
    column: int | None

    def __init__(
        self,
        message: str,
        *,
        code: str = "E599",
        reason: str | None = None,
        hints: list[str] | None = None,
        source: str = "",
        span: tuple[int, int] | None = None,
        line: int | None = None,
        column: int | None = None,
        rendered: str | None = None,
    ) -> None:
        super().__init__(rendered if rendered is not None else message)
        self.message = message
        self.code = code
        self.reason = reason
        self.hints = list(hints or [])
        self.source = source
        self.span = span
        self.line = line
        self.column = column

    def __reduce__(self) -> Any:
        return (_rebuilt, (type(self), dict(self.__dict__), self.args))


class PolarformWarning(UserWarning):
    """A text could have been read otherwise; the message says how it was read."""


class LimitError(PolarformError):
    """A computation took more time, terms or digits than `pf.limits` allows."""


def _rebuilt(kind: type[PolarformError], details: dict[str, Any], args: tuple[Any, ...]) -> PolarformError:
    error = kind.__new__(kind, *args)
    error.__dict__.update(details)
    error.args = args
    return error
