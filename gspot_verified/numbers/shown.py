"""How results are shown where nobody prints them: one line at a prompt, what ``print`` shows in a notebook."""

from __future__ import annotations

import html
from dataclasses import fields, is_dataclass
from reprlib import Repr

_LONGEST = 300  # characters of a line
_PRE = '<pre style="font-family:monospace">'  # Jupyter would set it in the letters of a text, and columns would shift

_short = Repr()
_short.maxstring = _short.maxother = _short.maxlong = 40  # characters of a value


class Shown:
    """Base of what is shown by a short line, and in a notebook by its text, or a table of its fields.

    The text of ``str``, where a class has one, stays as long as it is.

    >>> from gspot_verified import side
    >>> side(1, 2)
    <SideSwitching: (1, 2): Γ(-β) > 0; Case III: C1 < 0 lifts off, C1 > 0 takes an IWC …>
    """

    __slots__ = ()

    def __init_subclass__(cls) -> None:
        """The line of this class stands before ``dataclass`` would write one that holds everything."""
        super().__init_subclass__()
        if "__repr__" not in vars(cls):
            cls.__repr__ = Shown.__repr__  # type: ignore[method-assign]

    def __repr__(self) -> str:
        name = type(self).__name__
        if not _has_text(self):
            return f"{name}({_cut(', '.join(f'{key}={value}' for key, value in _fields(self)))})"
        first, *further = str(self).split("\n", 1)
        return f"<{name}: {_cut(' '.join(first.split()))}{' …' if further else ''}>"

    def _repr_html_(self) -> str | None:
        if _has_text(self):
            return f"{_PRE}{html.escape(str(self))}</pre>"
        rows = (f"<tr><th>{key}</th><td>{html.escape(value)}</td></tr>" for key, value in _fields(self))
        return f"<table><caption>{type(self).__name__}</caption>{''.join(rows)}</table>"


def _has_text(value: Shown) -> bool:
    return type(value).__str__ is not object.__str__


def _fields(value: Shown) -> list[tuple[str, str]]:
    """The names and short texts of the fields, of a dataclass."""
    if not is_dataclass(value):
        return []
    return [(each.name, _short.repr(getattr(value, each.name))) for each in fields(value) if each.repr]


def _cut(line: str) -> str:
    return line if len(line) <= _LONGEST else f"{line[: _LONGEST - 1]}…"
