"""A power series in delta whose terms become known one order at a time."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


class Series:
    """All terms by order, and under their orders those that do not vanish; both grow."""

    __slots__ = ("_vanishes", "nonzero", "terms")

    def __init__(self, vanishes: Callable[[Any], bool]) -> None:
        self._vanishes = vanishes
        self.terms: list[Any] = []
        self.nonzero: dict[int, Any] = {}

    def append(self, term: Any) -> None:
        """Add the term of the next order."""
        if not self._vanishes(term):
            self.nonzero[len(self.terms)] = term
        self.terms.append(term)

    def drop_last(self) -> None:
        """Forget the term of the last order."""
        self.terms.pop()
        self.nonzero.pop(len(self.terms), None)
