"""How far a run of slip goes on towards a G-spot before its numbers are read off: heuristics, any answer is correct."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Protocol

from flint import arb

from gspot_verified.mechanisms.approach.capture import Capture
from gspot_verified.numbers.balls import approximate

_DISC_BITS = 9  # the disc of Theorem A3 (proofs/approach.md) has at least the radius 2^-9
_CLOSE_DISC_BITS = 7  # likewise where p is not much smaller: from here on a quotient's disc is small enough
_LEAST_RATIO_BITS = 3  # of that radius and p
_FEWEST_TERMS = 4  # of the distinguished trajectory's polynomial in p: any number is correct
_TERMS_SPARE = 24  # bits of that polynomial beyond those of C_1
_LEAST_EXPONENT = 10.0  # bits that p is to lose at least
_FEW_BITS, _EXPONENT_OF_FEW = 64, 20.0  # with fewer working bits than those: such a run ends with its signs
_FIRST_SPARE = 6  # bits that p and the place of the G-spot must lose beyond those of C_1, in the first try
_NEAR = 32  # p is to be so much smaller than where power series end; up to twice as large the first state is taken


def _beta(neighbourhood: Capture) -> float:
    return approximate(neighbourhood.numbers.alpha_3) / approximate(neighbourhood.numbers.alpha_1)


def _rate(beta: float) -> float:
    """How many bits of C_1 each bit brings that p loses."""
    return 1.0 if beta > 1 else max(min(beta, 1 - beta), 0.01)


def exponent_for(neighbourhood: Capture, bits: int, wanted: int = 0) -> float:
    """How many bits p is to lose before C_1 is read off, ``wanted`` bits of it at least."""
    if bits < _FEW_BITS:
        return _EXPONENT_OF_FEW
    beta = _beta(neighbourhood)
    if beta <= 1:
        return min(bits - 35.0, max(48, wanted + 16) / _rate(beta))
    # From 14 bits on a quotient's disc in p is small enough, where the precision allows it.
    return max(_LEAST_EXPONENT, min(max(46.0, wanted + 12.0), (bits - 64) / beta), min(14.0, (bits - 24) / beta))


def too_few_bits(neighbourhood: Capture, bits: int, wanted: int) -> bool:
    """Whether the precision hardly gives as many bits of C_1."""
    beta = _beta(neighbourhood)
    needed = 64 + beta * (wanted + 12) if beta > 1 else 35 + (wanted + 16) / _rate(beta)
    return wanted > 0 and needed > bits


def disc_and_terms(beta: float, exponent: float, bits: int) -> tuple[int, int]:
    """The bits of the disc of Theorem A3 (proofs/approach.md), and how many terms leave so many bits of the deviation,
    where p has lost ``exponent`` bits."""
    disc = min(_DISC_BITS, max(round(exponent / 2), min(_CLOSE_DISC_BITS, round(exponent - _LEAST_RATIO_BITS))))
    return disc, max(_FEWEST_TERMS, round(beta) + 1, round(bits / max(exponent - disc, 2.0)))


def lost_bits(p: arb) -> float:
    """How many bits p > 0 has lost, about."""
    return -math.log2(approximate(p))


def bits_of_trial(neighbourhood: Capture, exponent: float, bits: int, wanted: int) -> int:
    """How many bits of the distinguished trajectory a first answer needs."""
    return min(bits, round((_beta(neighbourhood) - 1) * exponent) + wanted + _TERMS_SPARE)


class _Known(Protocol):
    """A state, and its neighbourhood."""

    @property
    def capture(self) -> Capture:
        """The neighbourhood."""

    @property
    def exponent(self) -> float:
        """How many bits p has lost."""


class Trials:
    """When C_1 is read off on the way, and from which state."""

    def __init__(self, wanted: int, dimension: int) -> None:
        self._wanted, self._dimension = wanted, dimension
        self._next = -math.inf

    def marked(self, states: Sequence[_Known]) -> int | None:
        """Which of the states gives C_1, where the last one gives the G-spot; None: it is too early."""
        last = states[-1]
        beta, spare = _beta(last.capture), self._wanted + _FIRST_SPARE
        if last.exponent < max(self._next, self._wanted / _rate(beta)):
            return None
        if self._dimension == 4 or beta <= 1:
            return len(states) - 1
        # Where the G-spot is known only by going there, its width in p counts against p^(beta - 1) at the state.
        fit = [i for i, known in enumerate(states) if (beta - 1) * known.exponent + spare <= last.exponent]
        return max(fit, default=None)

    def tried(self, last: _Known, found: int) -> None:
        """So many bits of C_1 were certain, which was not enough."""
        missing = (self._wanted - max(found, 0)) / _rate(_beta(last.capture))
        self._next = last.exponent + max(1.0, missing)


def last_exponent_for(neighbourhood: Capture, exponent: float, bits: int, dimension: int) -> float:
    """The same for the place of the G-spot, where it is not isolated and so known only by going there."""
    if dimension == 4:
        return exponent
    beta = max(_beta(neighbourhood), 1.0)
    return min(bits - 45.0, exponent * beta + bits / 5)


def state_to_start_from(sizes: Sequence[arb], radius: float) -> int:
    """Which state of a path is to be the start of a compliant motion, ``sizes`` being p and ``radius`` where the power
    series in p end."""
    goal, known = radius / _NEAR, [approximate(value) for value in sizes]
    if known[0] <= 2 * goal:
        return 0
    return next((i for i, size in enumerate(known) if size <= goal), len(known) - 1)
