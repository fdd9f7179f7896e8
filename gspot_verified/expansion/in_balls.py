"""The expansion of a rational system in balls: for numbers, where exact coefficients are too long."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from flint import arb, fmpq

from gspot_verified.expansion.accuracy import Accuracy
from gspot_verified.expansion.series.system import SymbolsError, System
from gspot_verified.expansion.trajectory import Trajectory, certain_bits_of, checked_order, terms_of
from gspot_verified.functions.rings import BALLS
from gspot_verified.numbers.balls import working_bits

_LEAST_BITS = 32  # a limit of input: ValueError beyond it
_MOST_BITS = 1_000_000  # a limit of input: ValueError beyond it


def expand_in_balls(
    system: System, order: int, bits: int, progress: Callable[[int, int], None] | None = None
) -> Trajectory:
    """The terms as balls, computed with ``bits`` working bits, whatever the numbers of the system.

    Exact coefficients of order n have about n^2 bits; balls have as many at every order, so that high orders cost a
    small part of the time. ``accuracy.certain_bits`` says what is left of the bits.

    :raises TypeError: ``order`` is not an int.
    :raises SymbolsError: the numbers of the system are symbols.
    :raises ValueError: ``order`` is not in 1..2000, or ``bits`` not in 32..10^6.

    >>> from gspot_verified.testing import extended_example
    >>> trajectory = expand_in_balls(extended_example(chi=1), 7, 100)
    >>> trajectory.p[6].coefficients()[1].contains(-96), trajectory.accuracy.certain_bits > 80
    (True, True)
    """
    order = checked_order(order)
    if type(bits) is not int or not _LEAST_BITS <= bits <= _MOST_BITS:
        raise ValueError(f"bits must be an int in {_LEAST_BITS}..{_MOST_BITS}, got {bits!r}")
    trajectory = terms_of(_in_balls(system, bits), order, bits, progress)
    certain = certain_bits_of(trajectory)
    assert certain is not None
    digits = max(1, math.floor((certain - 1) / math.log2(10)))
    return replace(trajectory, accuracy=Accuracy(digits, certain, bits, 1))


def _in_balls(system: System, bits: int) -> System:
    """The same system with balls for its numbers."""
    if not all(isinstance(value, fmpq | arb | int) for value in system.point):
        raise SymbolsError("balls need numbers: put numbers in the place of the symbols")
    with working_bits(bits):
        return replace(system, ring=BALLS, point=tuple(arb(value) for value in system.point))
