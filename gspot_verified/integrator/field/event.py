"""The first time at which a function of the state rises through zero, in a bracket, and which of several is first.

Proof page: ``proofs/validated_step.md``, Theorems V5 and V6; ``proofs/norm_step.md``, Theorem N3.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from functools import lru_cache
from typing import Protocol

from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import lie_derivative
from gspot_verified.functions.expressions import Expression
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.numbers.balls import current_bits, hull
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import Evidence

_LEAST_DEPTH, _BITS_PER_HALVING = 26, 3  # halvings of a segment: at least so many, more with more bits
_KEPT = 16  # watched functions whose programs are kept
_MAX_PIECES = 2000  # of one segment, against endless work; then it is unclear


class Length(Protocol):
    """A step of some kind."""

    @property
    def h(self) -> arb:
        """Its length."""


class ProvedSegment(Protocol):
    """A proved step of a run, from ``time`` on."""

    @property
    def time(self) -> arb:
        """The time at its beginning."""

    @property
    def step(self) -> Length:
        """The step."""

    def states(self, tau: arb) -> list[arb]:
        """The states at the times ``time`` + τ h, τ in a ball inside [0, 1]."""


@dataclass(frozen=True, slots=True)
class Moment:
    """One time of a run: τ in [0, 1] of a segment."""

    segment: ProvedSegment
    tau: arb

    @property
    def time(self) -> arb:
        """The time; as uncertain as the length of its step."""
        return self.segment.time + self.tau * self.segment.step.h

    def states(self) -> list[arb]:
        """The states at this time."""
        return self.segment.states(self.tau)

    def certainly_by(self, other: Moment) -> bool:
        """Whether both are of one segment, and it is certainly not after the other, whatever the step's length is."""
        return self.segment is other.segment and bool(self.tau <= other.tau)


@dataclass(frozen=True, slots=True)
class Crossing:
    """Every solution of the run has g < 0 up to ``begin``, g > 0 at ``end``, and exactly one zero of g up to ``end``.

    ``states`` encloses the states at all times from ``begin`` to ``end``, ``rate`` > 0 the derivative of g. The
    ``evidence`` is these three signs.
    """

    name: str
    begin: Moment
    end: Moment
    states: tuple[arb, ...]
    rate: arb
    evidence: Evidence

    @property
    def time(self) -> arb:
        """The time of the zero."""
        return hull((self.begin.time, self.end.time))


@dataclass(frozen=True, slots=True)
class Unclear:
    """The function could not be followed from ``time`` on: it is not certain whether it has a zero."""

    name: str
    time: arb


_SMALL_PART = arb((1, -20))  # of an enclosure's radius: by so much a bracket may be wider than it must


@dataclass(frozen=True, slots=True)
class _Piece:
    segment: ProvedSegment
    left: arb
    right: arb

    @property
    def begin(self) -> Moment:
        return Moment(self.segment, self.left)

    @property
    def end(self) -> Moment:
        return Moment(self.segment, self.right)

    def box(self) -> list[arb]:
        return self.segment.states(hull((self.left, self.right)))


class Kind(Enum):
    """What is certain of g on a piece of time."""

    NEGATIVE = "negative"
    RISING = "rising"
    FALLING = "falling"


class Watch:
    """Follows a function g along the segments of a run that starts with g < 0.

    A sign counts only where it is certain for all of the set, so a set that has become too wide gives no bracket.

    ``from_zero`` = k > 0: the run starts with g = 0 instead, and for k = 2 with dg/dt = 0, too; the k-th derivative
    must be seen to be negative first: then g < 0 after the start.

    :raises ValueError: ``from_zero`` is not 0, 1 or 2.
    """

    def __init__(self, name: str, function: Expression, field: VectorField, from_zero: int = 0) -> None:
        if from_zero not in (0, 1, 2):
            raise ValueError(f"from_zero: expected 0, 1 or 2, got {from_zero}")
        self.name = name
        self._program, self._first = (each.at(field.given) for each in _programs(function, field.first, from_zero))
        self._stretch: list[_Piece] = []  # g rises on them all, and g < 0 at the begin of the first
        self._followed: Moment | None = None
        self._leaving = from_zero > 0

    def value(self, states: list[arb]) -> arb:
        """An enclosure of g."""
        return self._program.mean_values(states)[0]

    def along(self, segment: ProvedSegment) -> Crossing | Unclear | None:
        """What happens on the next segment: nothing (g < 0 is proved, or it still rises), a crossing, or unclear."""
        for count, (piece, kind) in enumerate(self._pieces(segment, arb(0), arb(1), 0)):
            self._followed = piece.begin
            if kind is None or count == _MAX_PIECES:
                return Unclear(self.name, piece.begin.time)
            if kind is Kind.NEGATIVE:
                self._stretch, self._leaving = [], False
            elif kind is Kind.FALLING:
                self._leaving = not self._negative(piece.end)
            else:
                if self._negative(piece.begin):
                    self._stretch, self._leaving = [], False  # g rises, so what lies before has no zero
                elif not self._stretch:
                    return Unclear(self.name, piece.begin.time)
                self._stretch.append(piece)
                if self.value(piece.end.states()) > 0:
                    self._followed = piece.end
                    return self._bracket(self._stretch)
        self._followed = Moment(segment, arb(1))
        return None

    def excluded(self, moment: Moment) -> Evidence | None:
        """That g has no zero after the start and up to a moment of the segment that was followed last; None: that is
        not certain.

        g must have been followed up to there, and where it rises only a certain sign excludes a zero on the way.
        """
        if self._followed is None or not moment.certainly_by(self._followed):
            return None
        return less(self.value(moment.states()), 0)

    def _negative(self, moment: Moment) -> bool:
        return bool(self.value(moment.states()) < 0)

    def _pieces(
        self, segment: ProvedSegment, left: arb, right: arb, depth: int
    ) -> Iterator[tuple[_Piece, Kind | None]]:
        """Pieces in order, each with what is certain on it, or None; FALLING only as long as g leaves 0."""
        piece = _Piece(segment, left, right)
        value, rate = self._program.mean_values(piece.box())
        if value < 0:
            yield piece, Kind.NEGATIVE
        elif rate > 0:
            yield piece, Kind.RISING
        elif self._leaving and self._first.mean_values(piece.box())[0] < 0:
            yield piece, Kind.FALLING
        elif depth >= max(_LEAST_DEPTH, current_bits() // _BITS_PER_HALVING):
            yield piece, None
        else:
            middle = (left + right) / 2
            yield from self._pieces(segment, left, middle, depth + 1)
            yield from self._pieces(segment, middle, right, depth + 1)

    def _bracket(self, stretch: Sequence[_Piece]) -> Crossing | Unclear:
        """The zero on pieces on which g rises, from g < 0 to g > 0."""
        first, last = stretch[0], stretch[-1]
        left = self._last(first, first.left, first.right, -1)
        right = self._last(last, last.left, last.right, 1)
        parts = list(stretch)
        parts[0] = replace(parts[0], left=left)
        parts[-1] = replace(parts[-1], right=right)
        boxes = [part.box() for part in parts]
        rate = hull(self._program.mean_values(box)[1] for box in boxes)
        begin, end = parts[0].begin, parts[-1].end
        signs = [less(self.value(begin.states()), 0), less(0, rate), less(0, self.value(end.states()))]
        evidence = every(signs)
        if evidence is None:
            return Unclear(self.name, begin.time)
        states = tuple(hull(sides) for sides in zip(*boxes, strict=True))
        return Crossing(self.name, begin, end, states, rate, evidence)

    def _last(self, piece: _Piece, left: arb, right: arb, sign: int) -> arb:
        """The last point where g < 0 is certain (sign -1), or the first one where g > 0 is, but for a small part.

        By secants, where a side that stays counts half; by halves where they give no point between.
        """
        near, far = (left, right) if sign < 0 else (right, left)
        at_near, at_far = (self._certain(piece, place, sign)[0] for place in (near, far))
        before = 0
        for _ in range(2 * current_bits()):
            share = at_near / (at_near - at_far) if at_near > 0 and at_far < 0 else arb(1) / 2
            places = [(near + (far - near) * part).mid() for part in (share, arb(1) / 2)]
            middle = next((place for place in places if near < place < far or far < place < near), None)
            if middle is None:  # as fine as τ can be told apart
                break
            here, small = self._certain(piece, middle, sign)
            if here > -small:
                near, at_near, at_far = middle, here, at_far / (2 if before > 0 else 1)
                before = 1
                if here < small:
                    break
            else:
                far, at_far, at_near = middle, here, at_near / (2 if before < 0 else 1)
                before = -1
        return near

    def _certain(self, piece: _Piece, tau: arb, sign: int) -> tuple[arb, arb]:
        """By how much sign g is above a small part of its enclosure's radius, and that part: the sign is certain where
        the sum of both is positive."""
        value = self.value(piece.segment.states(tau)) * sign
        small = value.rad() * _SMALL_PART
        return value.lower() - small, small


@lru_cache(_KEPT)
def _programs(function: Expression, field: VectorField, from_zero: int) -> tuple[BoxProgram, BoxProgram]:
    """g and its derivative; and the derivative by which g leaves 0. Both arguments are known by their identity."""
    derivatives = [function, lie_derivative(function, field.functions)]
    both = BoxProgram(derivatives, field.dimension)
    if from_zero == 2:
        derivatives.append(lie_derivative(derivatives[1], field.functions))
    return both, BoxProgram(derivatives[-1:], field.dimension)


def first_crossing(
    watches: Sequence[Watch], hits: Sequence[Crossing | Unclear | None]
) -> tuple[Crossing, Evidence] | None:
    """Of what :meth:`Watch.along` found on one segment the crossing before which no other function has a zero, and the
    signs that show it; None: that is not certain of any.
    """
    for hit in hits:
        if isinstance(hit, Crossing):
            others = [watch.excluded(hit.end) for watch, other in zip(watches, hits, strict=True) if other is not hit]
            evidence = every([hit.evidence, *others])
            if evidence is not None:
                return hit, evidence
    return None


def rivals(hit: Crossing, watches: Sequence[Watch], hits: Sequence[Crossing | Unclear | None]) -> list[str]:
    """The names of the other functions that may have a zero up to the end of a crossing."""
    pairs = zip(watches, hits, strict=True)
    return [watch.name for watch, other in pairs if other is not hit and watch.excluded(hit.end) is None]
