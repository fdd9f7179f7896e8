"""Rows of answers as lines of CSV: bounds of numbers rounded outward, what texts say quoted where it must be."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from typing import Protocol

from gspot_verified.numbers.balls import float_bounds
from gspot_verified.numbers.dyadic import Dyadic

Numbers = tuple[tuple[str, Dyadic | None], ...]
"""Names with what encloses the number; None: not known, or not defined."""


class AnsweredRow(Protocol):
    """The answer for one row of a table."""

    @property
    def outcome(self) -> str:
        """One of :data:`OUTCOMES`."""

    @property
    def summary(self) -> str:
        """The outcome in words: rows with the same one are counted together."""

    def to_csv(self) -> str:
        """The row as a line of CSV."""

    def csv_head(self) -> str:
        """The names of the columns, as a line of CSV: the same for all rows of one table."""


OUTCOMES = ("settled", "undecided", "refused")


def ends(numbers: Numbers) -> list[str]:
    """The names of two columns for each number."""
    return [f"{name}_{end}" for name, _ in numbers for end in ("lower", "upper")]


def bounds(numbers: Numbers) -> list[str]:
    """What stands in them."""
    return [text for _, number in numbers for text in _bounds(number)]


def line(fields: Sequence[str]) -> str:
    """A line of CSV with its line feed."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow(fields)
    return text.getvalue()


def _bounds(number: Dyadic | None) -> tuple[str, str]:
    if number is None:
        return "", ""
    lower, upper = float_bounds(number.to_ball())
    return repr(lower), repr(upper)
