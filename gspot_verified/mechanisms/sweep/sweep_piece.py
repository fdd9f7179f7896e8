"""Pieces of a sweep: a box of parameter values and what is proved for every one of them.

What each kind says: ``proofs/sweep.md``, section 5. Numbers are exact rationals and intervals, so that pieces cross
processes and files unchanged.
"""

from __future__ import annotations

import enum
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

from flint import arb, fmpq

from gspot_verified.mechanisms.zeros.tube import Tube
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.packed import PackedIntervals
from gspot_verified.numbers.verdict import NoTruthValue

NUMBERS = ("alpha_1", "alpha_2", "alpha_3", "beta", "mean_force", "slip_velocity")
"""What is enclosed on a piece; None where it is not defined for all its parameter values, or not certainly."""

_RADIUS_BITS = 28  # two less than FLINT's 30 for a radius: room to come back without rounding up

ENDED = "the boxes of the cell ended"
"""What keeps a piece without a tube from being divided further, before it is too small."""

NO_NUMBERS = PackedIntervals([None] * len(NUMBERS))


def columns(*groups: tuple[str, Sequence[str]]) -> list[str]:
    """The names of the columns of a table, no two the same: one that is taken gets its group's prefix.

    >>> columns(("", ["beta_lower", "case"]), ("spot_", ["beta_lower", "beta_upper"]))
    ['beta_lower', 'case', 'spot_beta_lower', 'beta_upper']
    """
    made: list[str] = []
    for prefix, names in groups:
        for name in names:
            free = name
            while free in made:
                free = f"{prefix or '_'}{free}"
            made.append(free)
    return made


Intervals = tuple[Dyadic, ...]
Box = tuple[tuple[fmpq, ...], tuple[fmpq, ...]]
"""The lower ends and the upper ends."""


class Kind(enum.Enum):
    """What is known of a piece."""

    SETTLED = "settled"
    CROSSING = "crossing"
    OPEN = "open"
    NO_TUBE = "no tube"
    FOLD = "fold"
    BEYOND = "beyond a fold"


@dataclass(frozen=True, slots=True)
class TubeRecord:
    """A :class:`Tube` in exact intervals: centre, slopes row by row, within, found, of so many ``unknowns``.

    ``within`` is a little smaller than the tube's (and comes back as it is): in a wider one the zero was not shown to
    be the only one.
    """

    unknowns: int
    sides: PackedIntervals

    @classmethod
    def of(cls, tube: Tube) -> TubeRecord:
        """The record of a tube."""
        slopes = [slope for row in tube.slopes for slope in row]
        balls = (*tube.centre, *slopes, *map(_not_wider, tube.within), *tube.found)
        return cls(len(tube.centre), PackedIntervals(map(Dyadic.from_ball, balls)))

    def parts(self) -> tuple[Intervals, Intervals, Intervals, Intervals]:
        """Centre, slopes row by row, within, found."""
        n = self.unknowns
        sides = tuple(side for side in self.sides if side is not None)
        return sides[:n], sides[n : -2 * n], sides[-2 * n : -n], sides[-n:]

    def tube(self, lower: tuple[fmpq, ...], upper: tuple[fmpq, ...]) -> Tube:
        """The tube over its box of parameters. Centre and slopes come back exactly."""
        k = len(lower)
        centre, slopes, within, rests = ([side.to_ball() for side in part] for part in self.parts())
        rows = tuple(tuple(slopes[i * k : (i + 1) * k]) for i in range(len(centre)))
        return Tube(lower, upper, tuple(centre), rows, tuple(within), tuple(rests))


@dataclass(frozen=True, slots=True)
class Passing:
    """A quantity that may vanish on the piece, where it is strictly monotone along one parameter.

    ``quantity`` is "alpha_1", "alpha_2", "alpha_3", "alpha_3 - alpha_1" or "beta - n"; ``direction`` the sign of its
    derivative by the parameter number ``along``. ``before``, ``after``: its signs at the ends of a piece of one
    parameter, None where not certain.
    """

    quantity: str
    along: int
    direction: int
    before: int | None = None
    after: int | None = None


@dataclass(frozen=True, slots=True)
class SweepPiece(NoTruthValue):
    """One piece. ``case``, ``lift_off_sign``, ``impact_sign`` as in :class:`Classification`; they hold on all of it.

    ``unsure`` names what keeps a piece from being settled.
    """

    ask: ClassVar[str] = ".kind is Kind.SETTLED where Case and side hold on the whole piece"

    lower: tuple[fmpq, ...]
    upper: tuple[fmpq, ...]
    kind: Kind
    case: str | None = None
    lift_off_sign: int | None = None
    impact_sign: int | None = None
    unsure: tuple[str, ...] = ()
    passing: Passing | None = None
    numbers: PackedIntervals = NO_NUMBERS
    record: TubeRecord | None = None

    @property
    def box(self) -> Box:
        """Its corners."""
        return self.lower, self.upper

    @property
    def middle(self) -> tuple[fmpq, ...]:
        """The middle of the box."""
        return tuple((low + high) / 2 for low, high in zip(self.lower, self.upper, strict=True))

    @property
    def answer(self) -> tuple[str | None, int | None, int | None]:
        """Case and the two signs of C_1."""
        return self.case, self.lift_off_sign, self.impact_sign

    def tube(self) -> Tube | None:
        """The tube over the piece, in balls."""
        return None if self.record is None else self.record.tube(self.lower, self.upper)

    def number(self, name: str) -> Dyadic | None:
        """The interval that holds one of ``NUMBERS`` for every parameter value of the piece."""
        return self.numbers[NUMBERS.index(name)]

    def holds(self, place: Sequence[fmpq]) -> bool:
        """Whether the parameter values lie in the (closed) box."""
        return all(low <= value <= high for low, value, high in zip(self.lower, place, self.upper, strict=True))

    def to_json(self) -> dict[str, Any]:
        """Plain data for ``json.dumps``: all of it, exactly."""
        record, passing = self.record, self.passing
        return {
            "lower": [str(end) for end in self.lower],
            "upper": [str(end) for end in self.upper],
            "kind": self.kind.value,
            "case": self.case,
            "lift_off_sign_of_C1": self.lift_off_sign,
            "impact_sign_of_C1": self.impact_sign,
            "unsure": list(self.unsure),
            "passing": None
            if passing is None
            else [passing.quantity, passing.along, passing.direction, passing.before, passing.after],
            "numbers": [None if number is None else str(number) for number in self.numbers],
            "tube": None if record is None else [[str(side) for side in part] for part in record.parts()],
        }


def _not_wider(side: arb) -> arb:
    """A ball inside of the given one whose radius has few enough bits not to be rounded up on its way back."""
    mantissa, exponent = side.rad().man_exp()
    cut = max(mantissa.bit_length() - _RADIUS_BITS, 0)
    return arb(side.mid().man_exp(), (mantissa >> cut, exponent + cut))


def interval(value: arb | None) -> Dyadic | None:
    """A ball as an exact interval; None where it says nothing."""
    return None if value is None or not value.is_finite() else Dyadic.from_ball(value)


class PassingRow(NamedTuple):
    """A quantity that vanishes on a piece, the number of the parameter along which it is monotone, and the sign."""

    quantity: str
    along: int
    direction: int


class PieceRow(NamedTuple):
    """A piece as a user reads it: what holds on it, with the numbers in balls."""

    lower: tuple[fmpq, ...]
    upper: tuple[fmpq, ...]
    kind: Kind
    case: str | None
    lift_off_sign_of_C1: int | None
    impact_sign_of_C1: int | None
    unsure: tuple[str, ...]
    passing: PassingRow | None
    alpha_1: Dyadic | None
    alpha_2: Dyadic | None
    alpha_3: Dyadic | None
    beta: Dyadic | None
    mean_force: Dyadic | None
    slip_velocity: Dyadic | None


def piece_row(piece: SweepPiece) -> PieceRow:
    """The piece without its tube."""
    boundary = piece.passing
    passing = None if boundary is None else PassingRow(boundary.quantity, boundary.along, boundary.direction)
    what = (piece.kind, piece.case, piece.lift_off_sign, piece.impact_sign, piece.unsure, passing)
    return PieceRow(piece.lower, piece.upper, *what, *piece.numbers)
