"""Ranges of tau and beta: open or closed at each end, finite or infinite, always exact."""

from __future__ import annotations

import re
from dataclasses import dataclass

from flint import fmpq

from gspot_verified.numbers.balls import exact

_TEXT = re.compile(
    r"(?P<left>[\[(]?)(?P<lower>[^.\[\]()]*(?:\.[^.\[\]()]+)?)\.\.(?P<upper>[^\[\]()]*)(?P<right>[\])]?)"
)
_INFINITE = {"inf": 1, "+inf": 1, "-inf": -1}


@dataclass(frozen=True, slots=True)
class Range:
    """An interval of real numbers; ``None`` as an end is infinity.

    :raises TypeError: an end is neither ``fmpq`` nor ``None``.
    :raises ValueError: it holds no number (empty or reversed), or an infinite end is closed.

    >>> str(Range.parse("0..1", "beta")), str(Range.parse("[-2..inf)", "tau")), str(Range.parse("7/3", "beta"))
    ('(0, 1)', '[-2, inf)', '[7/3, 7/3]')
    """

    lower: fmpq | None
    upper: fmpq | None
    lower_closed: bool
    upper_closed: bool

    def __post_init__(self) -> None:
        for end in (self.lower, self.upper):
            if end is not None and type(end) is not fmpq:  # a subclass may compare in its own way
                raise TypeError(f"the end of a range must be fmpq or None, got {type(end).__name__}")
        if (self.lower is None and self.lower_closed) or (self.upper is None and self.upper_closed):
            raise ValueError("a range must be open at an infinite end")
        if self.lower is None or self.upper is None:
            return
        if self.lower > self.upper:
            raise ValueError(f"the range is reversed: {self.lower} > {self.upper}")
        if self.lower == self.upper and not (self.lower_closed and self.upper_closed):
            raise ValueError(f"the range {self} is empty; a single number is written as that number")

    @classmethod
    def parse(cls, text: str, name: str) -> Range:
        """Read ``a..b`` (open), ``[a..b]``, ``[a..b)``, ``(a..b]``, or one number; ends as exact numbers, inf, -inf.

        :raises TypeError: not a text.
        :raises ValueError: any other text; an empty or reversed range; NaN. The message names the argument.
        """
        if not isinstance(text, str):
            raise TypeError(f'{name}: expected a Range or a text such as "0..1", got {type(text).__name__}')
        word = text.strip().replace("\N{MINUS SIGN}", "-")
        if ".." not in word:
            if word.lower() in _INFINITE:
                raise ValueError(f'{name}: a single value must be finite; a range is written "a..b"')
            point = exact(word, name)
            assert isinstance(point, fmpq)
            return cls(point, point, True, True)
        match = _TEXT.fullmatch(word)
        # "0...5" may mean 0 to 0.5 or 0. to 5; a bracket at one end only is a slip.
        if match is None or "..." in word or bool(match["left"]) != bool(match["right"]):
            raise ValueError(f'{name}: expected a range such as "0..1", "[0..1)" or "-inf..inf", got {word[:60]!r}')
        lower, upper = _end(match["lower"], -1, name), _end(match["upper"], 1, name)
        try:
            return cls(lower, upper, match["left"] == "[", match["right"] == "]")
        except ValueError as error:
            raise ValueError(f"{name}: {error}") from None

    def __str__(self) -> str:
        lower = "-inf" if self.lower is None else str(self.lower)
        upper = "inf" if self.upper is None else str(self.upper)
        return f"{'[' if self.lower_closed else '('}{lower}, {upper}{']' if self.upper_closed else ')'}"

    @property
    def is_point(self) -> bool:
        """Whether the range is one number."""
        return self.lower is not None and self.lower == self.upper

    def contains(self, value: fmpq) -> bool:
        """Whether the number belongs to the range, exactly."""
        above = self.lower is None or value > self.lower or (self.lower_closed and value == self.lower)
        below = self.upper is None or value < self.upper or (self.upper_closed and value == self.upper)
        return above and below


def _end(text: str, side: int, name: str) -> fmpq | None:
    word = text.strip().lower()
    if word in _INFINITE:
        if _INFINITE[word] != side:
            raise ValueError(f"{name}: the range is empty: an infinite end on the wrong side")
        return None
    value = exact(word, name)
    assert isinstance(value, fmpq)
    return value
