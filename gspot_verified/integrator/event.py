"""The first time at which a function of the state rises through zero, in a bracket, with the sign of its derivative.

Proof page: ``proofs/validated_step.md``, Theorem V5.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from typing import Protocol

from flint import arb

from gspot_verified.balls import current_bits
from gspot_verified.expansion.box_program import BoxProgram
from gspot_verified.expansion.derivative import lie_derivative
from gspot_verified.expansion.expressions import Expression
from gspot_verified.integrator.field import VectorField

_DEPTH = 26
_MAX_PIECES = 2000


class Length(Protocol):
    """A step of some kind."""

    @property
    def h(self) -> arb:
        """Its length."""


class Segment(Protocol):
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
class Crossing:
    """Every solution of the run has g < 0 before the bracket, g > 0 at its end, and exactly one zero of g in it.

    ``time`` is the bracket, ``states`` encloses the states in it, ``rate`` > 0 the derivative of g at the zero.
    """

    name: str
    time: arb
    states: tuple[arb, ...]
    rate: arb


@dataclass(frozen=True, slots=True)
class Unclear:
    """The function could not be followed: it is not certain whether it has a zero."""

    name: str
    time: arb


@dataclass(frozen=True, slots=True)
class _Piece:
    segment: Segment
    left: arb
    right: arb

    def box(self) -> list[arb]:
        return self.segment.states(self.left.union(self.right))

    def time(self, tau: arb) -> arb:
        return self.segment.time + tau * self.segment.step.h


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
        derivatives = [function, lie_derivative(function, field.functions)]
        self._program = BoxProgram(derivatives, field.dimension)
        self._rising: _Piece | None = None
        self._leaving = from_zero > 0
        if from_zero == 2:
            derivatives.append(lie_derivative(derivatives[1], field.functions))
        self._first = BoxProgram(derivatives[-1:], field.dimension)

    def value(self, states: list[arb]) -> arb:
        """An enclosure of g."""
        return self._program.values(states)[0]

    def along(self, segment: Segment) -> Crossing | Unclear | None:
        """What happens on the next segment: nothing (g < 0 is proved, or it still rises), a crossing, or unclear."""
        for count, (piece, kind) in enumerate(self._pieces(segment, arb(0), arb(1), 0)):
            if kind is None or count == _MAX_PIECES:
                return Unclear(self.name, piece.time(piece.left))
            if kind is Kind.NEGATIVE:
                self._rising, self._leaving = None, False
            elif kind is Kind.FALLING:
                self._leaving = not self.value(segment.states(piece.right)) < 0
            elif self._leaving:
                return Unclear(self.name, piece.time(piece.left))
            else:
                if self.value(segment.states(piece.left)) < 0:
                    self._rising = piece  # g rises, so what lies before has no zero
                elif self._rising is None:
                    return Unclear(self.name, piece.time(piece.left))
                if self._rising is not None and self.value(segment.states(piece.right)) > 0:
                    return self._bracket(self._rising, piece)
        return None

    def excluded(self, segment: Segment) -> bool:
        """Whether g has certainly no zero up to the end of a segment on which :meth:`along` found nothing.

        Where g still rises at the end, only a certain sign there excludes a zero on the way.
        """
        return bool(self.value(segment.states(arb(1))) < 0)

    def _pieces(self, segment: Segment, left: arb, right: arb, depth: int) -> Iterator[tuple[_Piece, Kind | None]]:
        """Pieces in order, each with what is certain on it, or None; FALLING only as long as g leaves 0."""
        piece = _Piece(segment, left, right)
        value, rate = self._program.mean_values(piece.box())
        if value < 0:
            yield piece, Kind.NEGATIVE
        elif rate > 0:
            yield piece, Kind.RISING
        elif self._leaving and self._first.mean_values(piece.box())[0] < 0:
            yield piece, Kind.FALLING
        elif depth == _DEPTH:
            yield piece, None
        else:
            middle = (left + right) / 2
            yield from self._pieces(segment, left, middle, depth + 1)
            yield from self._pieces(segment, middle, right, depth + 1)

    def _bracket(self, start: _Piece, end: _Piece) -> Crossing:
        left, right = start.left, end.right
        states = start.box()
        if start is end:
            left = self._last(start, left, right, -1)
            right = self._last(start, left, right, 1)
            states = start.segment.states(left.union(right))
        else:
            states = [a.union(b) for a, b in zip(states, end.box(), strict=True)]
        time = start.time(left).union(end.time(right))
        return Crossing(self.name, time, tuple(states), self._program.mean_values(states)[1])

    def _last(self, piece: _Piece, left: arb, right: arb, sign: int) -> arb:
        """By bisection: the last point where g < 0 is certain (sign -1), or the first one where g > 0 is."""
        for _ in range(current_bits()):
            middle = (left + right) / 2
            certain = self.value(piece.segment.states(middle)) * sign > 0
            if sign < 0:
                left, right = (middle, right) if certain else (left, middle)
            else:
                left, right = (left, middle) if certain else (middle, right)
        return left if sign < 0 else right
