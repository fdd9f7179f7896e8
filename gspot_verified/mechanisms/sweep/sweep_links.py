"""Which pieces hold the continued spot: neighbours whose tubes hold the same zero at a common parameter value.

Proof page: ``proofs/sweep.md``, section 2.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Sequence
from itertools import accumulate, pairwise

from flint import arb, fmpq

from gspot_verified.mechanisms.sweep.sweep_piece import Box, SweepPiece
from gspot_verified.mechanisms.sweep.sweep_pieces import Block, PieceStore
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.zeros.tube import Equations, Tube


def common_place(first: Box, second: Box) -> tuple[fmpq, ...] | None:
    """The middle of what two boxes share, if that is a point (one parameter) or a part of a side (two)."""
    place, wide = [], 0
    for low, high, other_low, other_high in zip(*first, *second, strict=True):
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


def groups_in_a_row(equations: Equations, pieces_by_cell: Sequence[Sequence[SweepPiece]]) -> array[int]:
    """For each piece, cell after cell, a number from 0: two with the same one certainly hold the same zero, continued.

    Only pieces of one cell and of the next are looked at.
    """
    pieces = [piece for cell in pieces_by_cell for piece in cell]
    ends = [0, *accumulate(map(len, pieces_by_cell))]
    groups = Groups(len(pieces))
    tubes = [piece.tube() for piece in pieces]
    for k, (begin, end) in enumerate(pairwise(ends)):
        for number in range(begin, end):
            for other in range(number + 1, ends[min(k + 2, len(ends) - 1)]):
                own, its = tubes[number], tubes[other]
                if own is None or its is None or groups.of(number) == groups.of(other):
                    continue
                shared = common_place(pieces[number].box, pieces[other].box)
                if shared is not None and same_zero(equations, own, its, shared):
                    groups.join(number, other)
    numbers: dict[int, int] = {}
    return array("I", (numbers.setdefault(groups.of(number), len(numbers)) for number in range(len(pieces))))


class Groups:
    """Numbers from 0, some of which are joined, for good."""

    def __init__(self, count: int) -> None:
        self._less = list(range(count))  # of each one in its group that is not larger

    def add(self, count: int) -> int:
        """So many more, each alone: the first of them."""
        first = len(self._less)
        self._less.extend(range(first, first + count))
        return first

    def of(self, number: int) -> int:
        """The least number of its group."""
        while self._less[number] != number:
            self._less[number] = self._less[self._less[number]]
            number = self._less[number]
        return number

    def join(self, number: int, other: int) -> None:
        """The two groups are one from now on."""
        first, second = sorted((self.of(number), self.of(other)))
        self._less[second] = first

    def with_first(self) -> list[bool]:
        """Of each number whether it is joined with 0."""
        return [self.of(number) == 0 for number in range(len(self._less))]


class Links:
    """Which of the pieces in a store hold the continued spot: they come with groups, which are joined where two pieces
    certainly hold the same zero. ``spot`` encloses it at ``place``.

    A link lasts, also through a piece in whose place parts stand later: the continuation along it was proved.
    """

    def __init__(self, store: PieceStore, equations: Equations, place: Sequence[fmpq], spot: Sequence[arb]) -> None:
        self._store, self._equations, self._place, self._spot = store, equations, place, spot
        self._joined = Groups(1)  # 0 is the continued spot
        self._groups = array("I")

    def add(self, block: Block, groups: Sequence[int]) -> range:
        """The numbers of the pieces of a block, with the groups of :func:`groups_in_a_row`."""
        first = self._joined.add(max(groups, default=-1) + 1)
        self._groups.extend(first + group for group in groups)
        return self._store.add(block)

    def link(self, numbers: Iterable[int], others: Sequence[int]) -> None:
        """Look where a piece of the one kind meets one of the other."""
        for number in numbers:
            own = self._joined.of(self._groups[number])
            for other in others:
                if own != self._joined.of(self._groups[other]) and self._same(number, other):
                    self._joined.join(own, self._groups[other])
                    own = self._joined.of(own)

    def are_one(self, start: int, stop: int) -> bool:
        """Whether all pieces from one number up to another are in one group."""
        return len({*map(self._joined.of, {*self._groups[start:stop]})}) == 1

    def begin(self, numbers: Iterable[int]) -> None:
        """Look which of the pieces hold the spot where it is known."""
        for number in numbers:
            piece = self._store[number]
            tube = piece.tube() if piece.holds(self._place) else None
            if tube is not None and tube.holds_at(self._place, self._spot):
                self._joined.join(0, self._groups[number])

    def own(self) -> list[bool]:
        """Of each piece, by its number, whether it certainly holds the continued spot."""
        return list(map(self._joined.with_first().__getitem__, self._groups))

    def _same(self, number: int, other: int) -> bool:
        place = common_place(self._store.box(number), self._store.box(other))
        own, its = (None, None) if place is None else (self._store[number].tube(), self._store[other].tube())
        if place is None or own is None or its is None:
            return False
        return same_zero(self._equations, own, its, place)


def _exact(value: arb) -> fmpq:
    mantissa, exponent = value.mid().man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)
