"""Where the contact force may have its first zero: a heuristic. ``first_zero.py`` proves a zero near it, or refuses."""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpq

from gspot_verified.compliant.motion.force_range import ForceRange

_PIECES_BEFORE = 12  # times before the G-spot, the denser the nearer
_SCALED_STEP = fmpq(1)  # in tau, after the G-spot
_LAST_SCALED = 60  # tau up to which the force is looked at


def rough_zero(force: ForceRange, start: fmpq, unit: fmpq) -> fmpq | None:
    """Near the first change of sign of the force at sample times, in T; ``unit`` is about that of tau."""
    previous = None
    for place in _samples(start, unit):
        if force.near(place) < 0:
            return None if previous is None else _bisected(force, previous, place)
        previous = place
    return None


def _samples(start: fmpq, unit: fmpq) -> Iterator[fmpq]:
    """From the initial state to the G-spot in steps that shrink, then in steps of 1 in tau."""
    for k in range(_PIECES_BEFORE):
        yield start * fmpq((_PIECES_BEFORE - k) ** 2, _PIECES_BEFORE**2)
    for k in range(int(_LAST_SCALED / _SCALED_STEP)):
        yield k * _SCALED_STEP * unit


def _bisected(force: ForceRange, left: fmpq, right: fmpq) -> fmpq:
    for _ in range(6):
        middle = (left + right) / 2
        left, right = (left, middle) if force.near(middle) < 0 else (middle, right)
    return (left + right) / 2
