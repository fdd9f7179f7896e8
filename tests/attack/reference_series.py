"""Power series in time, coefficient after coefficient, in fixed-point integers: what the plain Taylor method needs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

BITS = 288
"""Bits after the point; a product is rounded down to them."""
ORDER = 44
_GOAL = -200


def _nothing(_: int) -> int:
    return 0


class Series:
    """A power series that computes each coefficient when it is first asked for."""

    def __init__(self, rule: Callable[[int], int]) -> None:
        self._rule = rule
        self._known: list[int] = []

    def __getitem__(self, k: int) -> int:
        while len(self._known) <= k:
            self._known.append(self._rule(len(self._known)))
        return self._known[k]

    def __add__(self, other: Series | int | Fraction) -> Series:
        right = series(other)
        return Series(lambda k: self[k] + right[k])

    __radd__ = __add__

    def __neg__(self) -> Series:
        return Series(lambda k: -self[k])

    def __sub__(self, other: Series | int | Fraction) -> Series:
        right = series(other)
        return Series(lambda k: self[k] - right[k])

    def __rsub__(self, other: Series | int | Fraction) -> Series:
        return series(other) - self

    def __mul__(self, other: Series | int | Fraction) -> Series:
        if not isinstance(other, Series):
            factor = Fraction(other)
            return Series(lambda k: self[k] * factor.numerator // factor.denominator)
        return Series(lambda k: sum(self[j] * other[k - j] for j in range(k + 1)) >> BITS)

    __rmul__ = __mul__

    def __truediv__(self, other: int | Fraction) -> Series:
        return self * (1 / Fraction(other))


def series(value: Series | int | Fraction) -> Series:
    """A constant as a series; a series as it is."""
    if isinstance(value, Series):
        return value
    first = fixed(Fraction(value))
    return Series(lambda k: 0 if k else first)


def fixed(value: Fraction) -> int:
    """The fixed-point integer next below."""
    return (value.numerator << BITS) // value.denominator


def number(value: int) -> Fraction:
    """What a fixed-point integer stands for."""
    return Fraction(value, 1 << BITS)


Rates = Callable[[Sequence[Series]], Sequence[Series]]


def solution(rates: Rates, start: Sequence[int]) -> list[Series]:
    """The series of the states of an ODE from their values."""
    states = [Series(_nothing) for _ in start]
    found = rates(states)
    for state, first, rate in zip(states, start, found, strict=True):
        state._rule = _integral(first, series(rate))
    return states


def _integral(first: int, rate: Series) -> Callable[[int], int]:
    return lambda k: rate[k - 1] // k if k else first


def value(of: Series, time: int) -> int:
    """The sum of the first terms at a fixed-point time."""
    total = 0
    for k in range(ORDER, -1, -1):
        total = (total * time >> BITS) + of[k]
    return total


def slope(of: Series, time: int) -> int:
    """The same of the derivative."""
    total = 0
    for k in range(ORDER, 0, -1):
        total = (total * time >> BITS) + k * of[k]
    return total


def good_step(states: Sequence[Series], largest: int) -> int:
    """A step after which the last terms are below 2^-200 of the states or of 1."""
    step = largest
    for state in states:
        size = max(abs(state[0]), 1 << BITS).bit_length()
        for k in (ORDER - 1, ORDER):
            # |c_k| h^k < size 2^goal, in logarithms.
            excess = abs(state[k]).bit_length() - size - _GOAL
            limit = BITS - max(0, excess) / k
            step = min(step, int(2.0 ** (limit - BITS + 64)) << (BITS - 64)) if excess > 0 else step
    return step
