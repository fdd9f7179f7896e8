"""Which pieces hold the continued spot: neighbours whose tubes hold the same zero at a common parameter value.

Proof page: ``proofs/sweep.md``, section 2.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from itertools import accumulate, pairwise

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


def groups_in_a_row(equations: Equations, pieces_by_cell: Sequence[Sequence[SweepPiece]]) -> list[int]:
    """For each piece, cell after cell, a number: two with the same one certainly hold the same zero, continued.

    Only pieces of one cell and of the next are looked at: what is left out :func:`linked` looks at.
    """
    pieces = [piece for cell in pieces_by_cell for piece in cell]
    ends = [0, *accumulate(map(len, pieces_by_cell))]
    groups = list(range(len(pieces)))
    tubes = [piece.tube() for piece in pieces]
    for k, (begin, end) in enumerate(pairwise(ends)):
        for number in range(begin, end):
            for other in range(number + 1, ends[min(k + 2, len(ends) - 1)]):
                own, its = tubes[number], tubes[other]
                if own is None or its is None or groups[number] == groups[other]:
                    continue
                shared = common_place(pieces[number], pieces[other])
                if shared is not None and same_zero(equations, own, its, shared):
                    groups = [groups[number] if group == groups[other] else group for group in groups]
    return groups


def linked(
    equations: Equations,
    pieces: Sequence[SweepPiece],
    neighbours: Callable[[int], Sequence[int]],
    place: Sequence[fmpq],
    spot: Sequence[arb],
    groups: Sequence[int] | None = None,
) -> set[int]:
    """The numbers of the pieces whose zero is the given spot, continued: ``spot`` encloses it at ``place``.

    ``groups``: pieces with the same number are known to hold the same zero, continued.
    """
    alike: dict[int, list[int]] = {}
    for number, group in enumerate(groups or range(len(pieces))):
        alike.setdefault(group, []).append(number)
    numbers: set[int] = set()
    waiting: deque[int] = deque()

    def take(number: int) -> None:
        together = alike[groups[number]] if groups else [number]
        numbers.update(together)
        waiting.extend(together)

    for number, piece in enumerate(pieces):
        if number not in numbers and piece.holds(place):
            tube = piece.tube()
            if tube is not None and tube.holds_at(place, spot):
                take(number)
    while waiting:
        number = waiting.popleft()
        open_neighbours = [other for other in neighbours(number) if other not in numbers]
        own = pieces[number].tube() if open_neighbours else None
        for other in open_neighbours:
            its = None if other in numbers else pieces[other].tube()
            shared = None if its is None else common_place(pieces[number], pieces[other])
            if shared is not None and own is not None and its is not None and same_zero(equations, own, its, shared):
                take(other)
    return numbers


def _exact(value: arb) -> fmpq:
    mantissa, exponent = value.mid().man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)
