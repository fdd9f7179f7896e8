"""Names in formulas: which there can be, which letters are one, and which name may have been meant."""

from __future__ import annotations

import re
from collections.abc import Iterable
from difflib import get_close_matches

from gspot_verified.mechanisms.formulas.symbol import PI

FUNCTIONS = ("sin", "cos", "tan", "exp", "sqrt", "log")

LETTERS = (
    "A-Za-z\N{GREEK CAPITAL LETTER ALPHA}-\N{GREEK CAPITAL LETTER OMEGA}"
    "\N{GREEK SMALL LETTER ALPHA}-\N{GREEK SMALL LETTER OMEGA}"
)
_NAME = re.compile(rf"[{LETTERS}][{LETTERS}0-9_]{{0,39}}")
_SAMELETTERS = str.maketrans(
    {
        "\N{MINUS SIGN}": "-",
        "\N{MICRO SIGN}": "\N{GREEK SMALL LETTER MU}",
        "\N{GREEK PHI SYMBOL}": "\N{GREEK SMALL LETTER PHI}",
        "\N{GREEK THETA SYMBOL}": "\N{GREEK SMALL LETTER THETA}",
        "\N{GREEK LUNATE EPSILON SYMBOL}": "\N{GREEK SMALL LETTER EPSILON}",
    }
)
_LOOKS = str.maketrans("ΑΒΕΖΗΙΚΜΝΟΡΤΥΧο", "ABEZHIKMNOPTYXo")  # Greek, Latin


class FormulaError(ValueError):
    """The text is no formula; the message shows where."""


def normal_name(name: str) -> str:
    """The name with letters that look alike made one: the micro sign is the Greek mu.

    >>> normal_name("\N{MICRO SIGN}") == "\N{GREEK SMALL LETTER MU}"
    True
    """
    return name.translate(_SAMELETTERS)


def check_name(name: str) -> str:
    """The name itself, if it can stand in a formula.

    :raises FormulaError: it is no name, or it is a function's.

    >>> check_name("theta_dot")
    'theta_dot'
    """
    if not isinstance(name, str) or not _NAME.fullmatch(normal_name(name)):
        raise FormulaError(
            f"{str(name)[:50]!r} is no name: Latin or Greek letters, digits and _, a letter first, "
            "at most 40 characters"
        )
    if name in FUNCTIONS:
        raise FormulaError(f"{name!r} is a function and cannot be a name")
    if name == PI:
        raise FormulaError(f"{name!r} is a number and cannot be a name")
    return normal_name(name)


def alike(names: Iterable[str]) -> tuple[str, str] | None:
    """Two names that no reader can tell apart: a Greek letter stands in the one where the other has a Latin one.

    >>> alike(["X", "Y", "\N{GREEK CAPITAL LETTER CHI}"]) == ("X", "\N{GREEK CAPITAL LETTER CHI}")
    True
    """
    seen: dict[str, str] = {}
    for name in names:
        other = seen.setdefault(name.translate(_LOOKS), name)
        if other != name:
            return other, name
    return None


def nearest(name: str, known: Iterable[str]) -> str:
    """``; did you mean 'theta'?`` for a name that is nearly one of the known names, else nothing.

    >>> nearest("thetta", ["theta", "phi"])
    "; did you mean 'theta'?"
    """
    matches = get_close_matches(name[:40], list(known)[:1000], 1)
    return f"; did you mean {matches[0]!r}?" if matches else ""
