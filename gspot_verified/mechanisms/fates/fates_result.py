"""The result of a sweep over states, as text, JSON and CSV."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

from flint import fmpq

from gspot_verified.mechanisms.approach.approach_result import STOPS_BEFORE
from gspot_verified.mechanisms.fates.box_fate import Fate
from gspot_verified.mechanisms.fates.fate_piece import FatePiece
from gspot_verified.mechanisms.fates.spot_sides import SpotSides
from gspot_verified.mechanisms.spots.classify import case_text
from gspot_verified.mechanisms.sweep.sweep_grid import Axis
from gspot_verified.numbers.balls import ExactInput, approximate, ball_text, rounded_text
from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.evidence import cover_by_boxes
from gspot_verified.numbers.verdict import NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written, rows_text, under

_SUMMARY = "name axes state surface_velocity sides verdict shares notes"
_WORDS = {
    Fate.BELOW: "a G-spot is reached with C1 < 0",
    Fate.ABOVE: "a G-spot is reached with C1 > 0",
    Fate.SPOT: "a G-spot is reached, the sign of C1 is open",
    Fate.LIFT_OFF: "lift-off before any G-spot",
    Fate.STOPS: STOPS_BEFORE,
    Fate.OPENS: "no slip in contact: p > 0 and b > 0, the contact opens at once",
    Fate.PAINLEVE: "p < 0 at the start (Painlevé's paradox): nothing more is said",
    Fate.NO_SLIP: "no positive slip at the start",
    Fate.UNDECIDED: "undecided",
}

_REACH = {Fate.BELOW, Fate.ABOVE, Fate.SPOT}
_NOT_KNOWN = {Fate.SPOT, Fate.UNDECIDED}
"""Those that leave something open: their share is rounded up."""

_ENDS = {*_REACH, Fate.LIFT_OFF, Fate.STOPS}
"""Those in which slip is followed to its end."""


@dataclass(frozen=True)
class Fates(NoTruthValue, Written):
    """The result of :func:`fates`. ``pieces`` cover the range; of each the fate holds for every state in it.

    ``state`` is what does not vary. ``sides``: what the sign of C_1 means at the G-spot. The pieces that reach it and
    whose sign of C_1 is open bracket the states with C_1 = 0, the canard's, as far as no other piece is undecided.
    """

    ask: ClassVar[str] = ".verdict.outcome says whether the fate of every state is known"
    written: ClassVar[str] = f"{_SUMMARY} pieces"

    name: str
    axes: tuple[Axis, ...]
    state: tuple[tuple[str, str], ...]
    surface_velocity: fmpq
    sides: SpotSides
    pieces: tuple[FatePiece, ...]
    notes: tuple[str, ...] = ()

    @property
    def shares(self) -> dict[str, fmpq]:
        """How much of the range has each fate, as a part of 1."""
        total = _size(tuple(axis.lower for axis in self.axes), tuple(axis.upper for axis in self.axes))
        sizes: dict[str, fmpq] = {}
        for piece in self.pieces:
            name = piece.fate.value
            sizes[name] = sizes.get(name, fmpq(0)) + _size(piece.lower, piece.upper) / total
        return sizes

    @property
    def verdict(self) -> Verdict:
        """Proved when no piece is undecided; then the sign of C_1 may be open on some, along the canard's curve."""
        statement = f"{self.name}: {self._what}, for every {self.states}"
        lower, upper = tuple(axis.lower for axis in self.axes), tuple(axis.upper for axis in self.axes)
        left = sum(piece.fate is Fate.UNDECIDED for piece in self.pieces)
        known = cover_by_boxes(
            ((piece.lower, piece.upper) for piece in self.pieces if piece.fate is not Fate.UNDECIDED), (lower, upper)
        )
        if left or known is None:
            detail = (
                f"{left} of {counted(len(self.pieces), 'piece')} left; more cells, or a larger budget, may settle more"
            )
            return Verdict.undecided(statement, Reason.BUDGET, detail)
        crossed = sum(piece.fate is Fate.SPOT for piece in self.pieces)
        return Verdict.proved(
            statement, known, f"the sign of C1 is open on {counted(crossed, 'piece')}" if crossed else ""
        )

    @property
    def _what(self) -> str:
        """What is said of the states, in words that hold for all pieces."""
        found = {piece.fate for piece in self.pieces}
        if len(found) == 1 and Fate.UNDECIDED not in found:
            return _WORDS[next(iter(found))]
        return "where rigid slip ends" if found <= _ENDS else "where rigid slip ends, or why it is not followed"

    @property
    def states(self) -> str:
        """Of which states, on which surface."""
        over = [f"{axis.name} in [{axis.lower}, {axis.upper}]" for axis in self.axes]
        given = [f"{word} = {value}" for word, value in self.state]
        velocity = f"with the velocity u = {self.surface_velocity}" if self.surface_velocity else "at rest"
        return f"{', '.join([*over, *given])}, in contact on a surface {velocity}"

    @property
    def names_a_side(self) -> bool:
        """Whether some piece reaches the G-spot with a certain sign of C_1, to which a side belongs."""
        return self.sides.below is not None and any(piece.fate in (Fate.BELOW, Fate.ABOVE) for piece in self.pieces)

    def at(self, **values: ExactInput) -> FatePiece:
        """A piece that holds these values of the components that vary.

        :raises ValueError: a value is missing, or outside of the range.
        """
        place = tuple(axis.value_in(values) for axis in self.axes)
        return next(piece for piece in self.pieces if piece.holds(place))

    def words(self, fate: Fate) -> str:
        """The fate in words, with the side for small epsilon where Theorem R gives one."""
        side = {Fate.BELOW: self.sides.below, Fate.ABOVE: self.sides.above}.get(fate)
        names = {"lift-off": "lift-off", "impact": "impact without collision"}
        return _WORDS[fate] + (f": {names[side]} for small epsilon" if side else "")

    def __str__(self) -> str:
        lines = [str(self.verdict)]
        reached = any(piece.fate in _REACH for piece in self.pieces)
        which = "each G-spot that a piece is said to reach" if reached else "the G-spot that was looked for"
        lines.append(f"  {which}: {case_text(self.sides.case)}, beta = {ball_text(self.sides.beta, 8)}")
        for fate in Fate:
            share = self.shares.get(fate.value)
            if share is not None:
                lines.append(f"  {_percent(share, 1 if fate in _NOT_KNOWN else -1)} %: {self.words(fate)}")
        if self.names_a_side:
            lines.append(f"  {self.sides.rests_on}")
        elif self.sides.why:
            lines.append(f"  no side for small epsilon: {self.sides.why}")
        return "\n".join([*lines, *(f"  note: {note}" for note in self.notes)])

    def to_csv(self) -> str:
        """One line for each piece: its ends exactly and as the nearest doubles, the fate, the side, why it is open."""
        return "".join(self.csv_lines())

    def csv_lines(self) -> Iterator[str]:
        """The lines of :meth:`to_csv` with their line feeds, one after the other."""
        head = [f"{a.name}_{end}{form}" for a in self.axes for end in ("lower", "upper") for form in ("", "_exact")]
        yield ",".join([*head, "fate", "side", "why"]) + "\n"
        sides = {Fate.BELOW: self.sides.below or "", Fate.ABOVE: self.sides.above or ""}
        for piece in self.pieces:
            ends = [
                text
                for low, high in zip(piece.lower, piece.upper, strict=True)
                for end in (low, high)
                for text in (repr(approximate(end)), str(end))
            ]
            words = [piece.fate.value, sides.get(piece.fate, ""), piece.why]
            yield ",".join([*ends, *(f'"{word}"' if "," in word else word for word in words)]) + "\n"

    def in_parts(self) -> tuple[dict[str, Any], Iterator[str]]:
        """The plain data without the pieces, and that of the pieces as JSON, one after the other."""
        return FatesSummary(self).to_json(), (rows_text([piece.to_json()]) for piece in self.pieces)


@dataclass(frozen=True)
class FatesSummary(NoTruthValue, Written):
    """What a sweep over states says of its range as a whole: its plain data without the pieces."""

    ask: ClassVar[str] = ".fates.verdict.outcome says whether the fate of every state is known"
    written: ClassVar[str] = under("fates", _SUMMARY)

    fates: Fates


def _percent(share: fmpq, direction: int) -> str:
    """Four digits, rounded down (direction -1) or up (1); rounded down, 100 is said of the whole range alone."""
    if share == 1:
        return "100"
    return rounded_text(min(approximate(100 * share), math.nextafter(100.0, 0.0)), direction, 4)


def _size(lower: tuple[fmpq, ...], upper: tuple[fmpq, ...]) -> fmpq:
    size = fmpq(1)
    for low, high in zip(lower, upper, strict=True):
        size *= high - low
    return size
