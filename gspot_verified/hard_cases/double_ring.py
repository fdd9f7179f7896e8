"""Doubles as the numbers of the recursion of Theorem 1: the usual computation, with the library's own recursion."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from flint import fmpq


class DoublePolynomial:
    """A polynomial with doubles as coefficients; zeros at its end are cut off."""

    def __init__(self, coefficients: Any) -> None:
        self._values = np.trim_zeros(np.asarray(coefficients, dtype=float), "b")

    def coeffs(self) -> list[float]:
        """The coefficients, from the constant term on."""
        return [float(value) for value in self._values]

    def length(self) -> int:
        """How many coefficients there are."""
        return len(self._values)

    def __add__(self, other: DoublePolynomial) -> DoublePolynomial:
        return DoublePolynomial(_plus(self._values, other._values))

    def __sub__(self, other: DoublePolynomial) -> DoublePolynomial:
        return DoublePolynomial(_plus(self._values, -other._values))

    def __neg__(self) -> DoublePolynomial:
        return DoublePolynomial(-self._values)

    def __mul__(self, other: DoublePolynomial | float) -> DoublePolynomial:
        if not isinstance(other, DoublePolynomial):
            return DoublePolynomial(self._values * other)
        if not (self.length() and other.length()):
            return DoublePolynomial([])
        return DoublePolynomial(np.convolve(self._values, other._values))


def _plus(left: Any, right: Any) -> Any:
    total = np.zeros(max(len(left), len(right)))
    total[: len(left)] += left
    total[: len(right)] += right
    return total


NOISE = 1e-12


class Doubles:
    """The ring of the recursion (``expansion.rings.Ring``) in double precision; nothing in it is certain."""

    def number(self, value: Any) -> float:
        """The nearest double."""
        return value if isinstance(value, float) else int(fmpq(value).p) / int(fmpq(value).q)

    def polynomial(self, coefficients: Sequence[float]) -> DoublePolynomial:
        """A polynomial."""
        return DoublePolynomial(coefficients)

    def is_zero(self, value: float) -> bool:
        """As it looks."""
        return value == 0

    def is_nonzero(self, value: float) -> bool:
        """More than what rounding leaves."""
        return abs(value) > NOISE

    def is_negative(self, value: float) -> bool:
        """As it looks."""
        return value < 0

    def sine_cosine(self, value: float) -> tuple[float, float]:
        """Both."""
        return math.sin(value), math.cos(value)

    def exponential(self, value: float) -> float:
        """Its exponential."""
        return math.exp(value)

    def logarithm(self, value: float) -> float:
        """Its logarithm."""
        return math.log(value)

    def power(self, value: float, exponent: fmpq) -> float:
        """A rational power."""
        return float(value ** (int(exponent.p) / int(exponent.q)))
