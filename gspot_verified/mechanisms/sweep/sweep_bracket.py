"""Where a quantity that is monotone along a piece of one parameter passes zero: a short bracket, once at most.

Proof page: ``proofs/sweep.md``, section 4.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.zeros.tube import Equations, OnTube, Quantity
from gspot_verified.numbers.balls import sign_of

_STEPS = 12  # of Newton's method: a limit of effort
_LEAST = fmpq(1, 2**20)  # the size that a place near 0 counts with, so that its bracket has a width

Pick = Callable[[OnTube], Quantity]
"""The quantity in question, next to a tube."""
Find = Callable[[Equations, tuple[fmpq, ...], tuple[fmpq, ...], Origin], OnTube | None]
"""What :func:`proved_tube` does."""


@dataclass(frozen=True, slots=True)
class Cut:
    """The quantity has the first of ``signs`` before ``ends`` and the second after them, up to the piece's ends.

    ``ends`` None: it has one sign on the whole piece. ``direction`` is the sign of its derivative, ``before`` and
    ``after`` its signs at ``ends``, None where not certain (at an end of the piece).
    """

    ends: tuple[fmpq, fmpq] | None
    signs: tuple[int, ...]
    direction: int
    before: int | None = None
    after: int | None = None


def bracket(equations: Equations, on: OnTube, pick: Pick, digits: int, find: Find = proved_tube) -> Cut | None:
    """Cut a piece at the zero of a quantity whose derivative has a certain sign on it; None where it has not.

    ``find``: how tubes are proved.
    """
    (lower,), (upper,) = on.tube.lower, on.tube.upper
    (slope,) = on.slopes(pick(on))
    direction = sign_of(slope)
    if direction not in (1, -1) or lower == upper:
        return None
    before, after = (_sign(equations, on, pick, end, find) for end in (lower, upper))
    if before == direction or after == -direction:  # it moves away from 0
        return Cut(None, (direction if before == direction else -direction,), direction)
    ends = _ends(equations, on, pick, digits, find)
    if ends is None:
        return None
    start, end = ends
    before = before if start == lower else _sign(equations, on, pick, start, find)
    after = after if end == upper else _sign(equations, on, pick, end, find)
    # Where the bracket ends inside the piece the sign there must be certain: it holds up to the piece's end.
    if (start > lower and before != -direction) or (end < upper and after != direction):
        return None
    return Cut((start, end), (-direction, direction), direction, before or None, after or None)


def _sign(equations: Equations, on: OnTube, pick: Pick, place: fmpq, find: Find) -> int | None:
    """The quantity's sign at one parameter value, by a tube over that value alone that lies in the given one."""
    at = find(equations, (place,), (place,), Origin.of(on))
    if at is None or not on.tube.holds_at((place,), at.tube.zero_at((place,))):
        return None
    return sign_of(at.value(pick(at)))


def _ends(equations: Equations, on: OnTube, pick: Pick, digits: int, find: Find) -> tuple[fmpq, fmpq] | None:
    """A short interval around the zero that Newton's method finds. A heuristic: the signs at its ends decide."""
    (lower,), (upper,) = on.tube.lower, on.tube.upper
    place = (lower + upper) / 2
    origin = Origin.of(on)
    for _ in range(_STEPS):
        at = find(equations, (place,), (place,), origin)
        if at is None:
            return None
        own = pick(at)
        (slope,) = at.slopes(own)
        step = (at.value(own) / slope).mid()
        if not step.is_finite():
            return None
        moved = min(max(place - _rounded(step), lower), upper)
        done = abs(moved - place) <= fmpq(1, 10 ** (digits + 3)) * max(abs(place), fmpq(1))
        place = moved
        if done:
            break
    half = fmpq(1, 2 * 10**digits) * max(_power_of_two(place), upper - lower)
    grid = _power_of_two(half / 64, least=fmpq(0))
    short = (place / grid).floor() * grid  # a rational with few digits, much nearer than the bracket is wide
    return max(short - half, lower), min(short + half, upper)


def _rounded(value: arb) -> fmpq:
    """A short rational near an exact ball."""
    mantissa, exponent = value.man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)


def _power_of_two(value: fmpq, least: fmpq = _LEAST) -> fmpq:
    """The power of two next above |value| and ``least``."""
    size = max(abs(value), least)
    exponent = int(size.p.bit_length()) - int(size.q.bit_length())
    power = fmpq(2) ** exponent
    while power < size:
        power *= 2
    return power
