"""Which pieces hold the continued spot: neighbours whose tubes hold the same zero at a common parameter value.

Proof page: ``proofs/sweep.md``, section 2.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence

from flint import arb, fmpq

from gspot_verified.mechanisms.sweep.sweep_piece import SweepPiece
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.zeros.tube import Equations, Tube


def common_place(first: SweepPiece, second: SweepPiece) -> tuple[fmpq, ...] | None:
    """The middle of what two pieces share, if that is a point (one parameter) or a part of a side (two)."""
    place, wide = [], 0
    for low, high, other_low, other_high in zip(first.lower, first.upper, second.lower, second.upper, strict=True):
        start, end = max(low, other_low), min(high, other_high)
        if start > end:
            return None
        wide += start < end
        place.append((start + end) / 2)
    return tuple(place) if wide >= len(place) - 1 else None


def same_zero(equations: Equations, first: Tube, second: Tube, place: Sequence[fmpq]) -> bool:
    """Whether the two tubes certainly hold the same zero at a common parameter value (and so at all around it)."""
    if second.holds_at(place, first.zero_at(place)) or first.holds_at(place, second.zero_at(place)):
        return True
    origin = Origin(
        tuple(place),
        tuple(_exact(value) for value in first.zero_at(place)),
        tuple(tuple(map(_exact, row)) for row in first.slopes),
    )
    at = proved_tube(equations, tuple(place), tuple(place), origin)
    return at is not None and all(tube.holds_at(place, at.tube.zero_at(place)) for tube in (first, second))


def linked(
    equations: Equations,
    pieces: Sequence[SweepPiece],
    neighbours: Callable[[int], Sequence[int]],
    place: Sequence[fmpq],
    spot: Sequence[arb],
) -> set[int]:
    """The numbers of the pieces whose zero is the given spot, continued: ``spot`` encloses it at ``place``."""
    tubes = [piece.tube() for piece in pieces]
    numbers: set[int] = set()
    waiting: deque[int] = deque()
    for number, (piece, tube) in enumerate(zip(pieces, tubes, strict=True)):
        if tube is not None and piece.holds(place) and tube.holds_at(place, spot):
            numbers.add(number)
            waiting.append(number)
    while waiting:
        number = waiting.popleft()
        own = tubes[number]
        for other in neighbours(number):
            its = tubes[other]
            shared = None if other in numbers or its is None else common_place(pieces[number], pieces[other])
            if shared is not None and own is not None and its is not None and same_zero(equations, own, its, shared):
                numbers.add(other)
                waiting.append(other)
    return numbers


def _exact(value: arb) -> fmpq:
    mantissa, exponent = value.mid().man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)
