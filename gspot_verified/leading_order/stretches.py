"""sign * dTheta/dtau on a half-line: its critical points in brackets, its least value, and where it first falls through
a level. Between the brackets it is strictly monotone, and no bracket leaves the half-line.

Proof page: ``proofs/iwc.md``, sections 2 to 4.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

from flint import arb, fmpq

from gspot_verified.numbers.balls import Exact, bits_for_digits, hull, nonfinite, sign_of, working_bits
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import Evidence
from gspot_verified.signs.gamma.side import gamma_sign
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.theta_function.value.evaluate import evaluate

Level = Callable[[int], arb]
"""A number, enclosed to as many decimal digits as asked."""

_MAX_TAU = fmpq(10**12)  # as far as routes.py evaluates
_SPARE_DIGITS = 12  # beyond those asked for, lost in the difference with the level
_TRIES = 3  # each with twice the digits; then the sign stays open


@dataclass(frozen=True, slots=True)
class Bracket:
    """A closed interval and an enclosure of all values of sign * dTheta/dtau on it."""

    lower: fmpq
    upper: fmpq
    value: arb

    @property
    def ends(self) -> tuple[fmpq, fmpq]:
        """Both ends."""
        return self.lower, self.upper


@dataclass(frozen=True, slots=True)
class Stretches:
    """sign * dTheta/dtau at ``start`` (a bracket of width 0) and on brackets that hold all critical points beyond it.

    No bracket of ``critical`` reaches to the left of the start: the first is cut there, and may hold no critical point
    then; each other one holds one. ``whole_line``: on (-infinity, start] the function is strictly decreasing from
    +infinity.
    """

    beta: Exact
    sign: int
    start: Bracket
    critical: tuple[Bracket, ...]
    whole_line: bool

    @property
    def rises(self) -> bool:
        """Whether the function tends to +infinity as tau does; otherwise it tends to -infinity."""
        return self.sign == gamma_sign(self.beta)


@lru_cache(maxsize=16)
def stretches(beta: fmpq, sign: int, start: fmpq, digits: int = 15) -> Stretches:
    """The brackets have the width 10^-digits or less; the critical points are the zeros of dTheta/dtau(., beta - 1).

    :raises ValueError: beta <= 0 or an integer, or sign is not 1 or -1.

    >>> shape = stretches(fmpq(5, 2), -1, fmpq(-10))
    >>> len(shape.critical), shape.whole_line
    (1, True)
    """
    if beta <= 0 or beta.q == 1:
        raise ValueError(f"beta: expected a number > 0 that is not an integer, got {beta}")
    if sign not in (1, -1):
        raise ValueError(f"sign: expected 1 or -1, got {sign}")
    # For 0 < beta < 1 dTheta/dtau is strictly decreasing on the whole line.
    brackets = zeros_at(beta - 1, digits).brackets if beta > 1 else ()
    beyond = [(max(lower, start), upper) for lower, upper in brackets if upper > start]
    critical = tuple(_bracket(beta, sign, lower, upper, digits) for lower, upper in beyond)
    decreasing = beta > 1 and sign < 0 and all(start <= lower for lower, _ in brackets)
    return Stretches(beta, sign, _bracket(beta, sign, start, start, digits), critical, decreasing)


def _bracket(beta: fmpq, sign: int, lower: fmpq, upper: fmpq, digits: int) -> Bracket:
    with working_bits(2 * bits_for_digits(digits) + 128):
        place = hull([arb(lower), arb(upper)])
    # On a bracket of width w around a critical point the values differ by O(w^2).
    slope = evaluate(lower if lower == upper else place, beta, derivative=1, digits=2 * digits + _SPARE_DIGITS).value
    with working_bits(2 * bits_for_digits(digits) + 128):
        return Bracket(lower, upper, sign * slope)


def minimum(shape: Stretches) -> Bracket:
    """The least value on [start, infinity), enclosed, and an interval of that half-line in which it is attained.

    The interval is the start alone or one bracket, unless the balls leave open which of them has the least value.

    :raises ValueError: the function tends to -infinity.
    """
    if not shape.rises:
        raise ValueError("sign: the function tends to -infinity, it has no least value")
    pieces = [shape.start, *shape.critical]
    with working_bits(max(64, *(int(piece.value.bits()) + 64 for piece in pieces))):
        lower, upper = shape.start.value.lower(), shape.start.value.upper()
        for piece in shape.critical:
            lower, upper = lower.min(piece.value.lower()), upper.min(piece.value.upper())
        possible = [piece for piece in pieces if not piece.value.lower() > upper]
        return Bracket(possible[0].lower, possible[-1].upper, hull([lower, upper]))


@dataclass(frozen=True, slots=True)
class LevelCrossing:
    """The function is above -level on [start, lower] and has exactly one crossing of it in (lower, upper).

    It is strictly decreasing there. ``number``: all crossings on [start, infinity), None when some critical value is
    too close to -level. ``evidence``: the signs, at the start, at the critical points and at both ends.
    """

    lower: fmpq
    upper: fmpq
    number: int | None
    evidence: Evidence


class NotAbove(ValueError):
    """The function is certainly below -level at the start already."""


def first_crossing(shape: Stretches, level: Level, digits: int = 15) -> LevelCrossing | None:
    """Where the function first falls through -level, when it tends to -infinity; None when balls cannot tell.

    :raises NotAbove: it is below -level at the start.
    :raises ValueError: it tends to +infinity.
    """
    if shape.rises:
        raise ValueError("sign: the function tends to +infinity, it need not fall through a level")
    value = level(2 * digits + _SPARE_DIGITS)
    pieces = [shape.start, *shape.critical]
    with working_bits(int(value.bits()) + 64):
        heights = [bracket.value + value for bracket in pieces]
    signs = [sign_of(height) for height in heights]
    if signs[0] == -1:
        raise NotAbove
    following = next((i for i, sign in enumerate(signs) if sign != 1), None)
    if following is not None and signs[following] != -1:
        return None
    before = len(pieces) if following is None else following
    first = pieces[before - 1].upper
    height_at = _height(shape, level, digits)
    below = _below(height_at)
    last = _far(first, below) if following is None else pieces[following].lower
    if last is None:
        return None
    lower, upper = narrowed(below, first, last, digits)
    left = heights[before - 1] if lower == first else height_at(lower)
    right = heights[following] if following is not None and upper == last else height_at(upper)
    shown = [*(less(0, height) for height in heights[:before]), less(0, left), less(right, 0)]
    known = [sign for sign in signs if sign]  # 0 fixes no sign either
    number = None
    if len(known) == len(signs):
        number = sum(a != b for a, b in pairwise([*known, -1]))
        shown += [less(0, height) if sign > 0 else less(height, 0) for sign, height in zip(known, heights, strict=True)]
    evidence = every(shown)
    return None if evidence is None else LevelCrossing(lower, upper, number, evidence)


def _height(shape: Stretches, level: Level, digits: int) -> Callable[[fmpq], arb]:
    """sign * dTheta/dtau + level at a point, with a few rising accuracies until its sign is certain."""

    def height(tau: fmpq) -> arb:
        value = nonfinite()
        for attempt in range(_TRIES):
            accuracy = (digits + _SPARE_DIGITS) * 2**attempt
            slope, bound = evaluate(tau, shape.beta, derivative=1, digits=accuracy).value, level(accuracy)
            with working_bits(bits_for_digits(accuracy) + 64):
                value = shape.sign * slope + bound
            if sign_of(value):
                break
        return value

    return height


def _below(height: Callable[[fmpq], arb]) -> Callable[[fmpq], bool | None]:
    """Whether the height is < 0 at a point, certainly."""

    def below(tau: fmpq) -> bool | None:
        sign = sign_of(height(tau))
        return sign < 0 if sign else None

    return below


def _far(lower: fmpq, below: Callable[[fmpq], bool | None]) -> fmpq | None:
    """A point to the right where the function is below the level."""
    step = fmpq(1)
    while lower + step < _MAX_TAU:
        if below(lower + step):
            return lower + step
        step *= 2
    return None


def narrowed(beyond: Callable[[fmpq], bool | None], lower: fmpq, upper: fmpq, digits: int) -> tuple[fmpq, fmpq]:
    """Bisection on the grid of ``digits`` decimals: ``beyond`` is False at ``lower`` and True at ``upper``.

    The result is wider than 10^-digits only where ``beyond`` answers None.

    >>> narrowed(lambda tau: tau * tau > 2, fmpq(0), fmpq(2), 3)
    (707/500, 283/200)
    """
    scale = 10**digits
    while upper - lower > fmpq(1, scale):
        middle = fmpq(math.floor((lower + upper) / 2 * scale), scale)
        if middle <= lower:
            middle += fmpq(1, scale)
        answer = beyond(middle)
        if answer is None:
            break
        lower, upper = (lower, middle) if answer else (middle, upper)
    return lower, upper
