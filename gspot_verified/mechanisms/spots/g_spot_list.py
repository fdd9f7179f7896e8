"""What a search for all G-spots gives: those that were proved, what is left open, a patch where they form a surface."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.g_spot import GSpot
from gspot_verified.numbers.balls import ball_text
from gspot_verified.numbers.verdict import NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written

_SHOWN = 20


@dataclass(frozen=True)
class Left(NoTruthValue, Written):
    """A box of states in which G-spots are neither found nor excluded, and why."""

    ask: ClassVar[str] = ".why says why the box is left open"
    written: ClassVar[str] = "box=sides why"

    sides: tuple[tuple[str, str], ...]
    why: str

    def __str__(self) -> str:
        return ", ".join(f"{word} = {text}" for word, text in self.sides) + f": {self.why}"


@dataclass(frozen=True)
class Patch(NoTruthValue, Written):
    """For all values of ``parameters`` in their intervals exactly one G-spot has the other components in ``box``.

    ``dimension`` is that of the curve or surface which the G-spots form there, free components included.
    """

    ask: ClassVar[str] = ".dimension is that of the curve or surface"

    dimension: int
    parameters: tuple[tuple[str, str], ...]
    box: tuple[tuple[str, str], ...]

    def __str__(self) -> str:
        over = ", ".join(f"{word} in {text}" for word, text in self.parameters)
        there = ", ".join(f"{word} in {text}" for word, text in self.box)
        return f"for all {over} exactly one with {there}"


@dataclass(frozen=True)
class GSpots(NoTruthValue, Written):
    """The G-spots of a mechanism in a region of states.

    ``spots`` are proved to lie in the region, each alone in its box. ``boundary`` are proved too, but so near to the
    end of an interval that they may lie outside. Every other G-spot in the region lies in a box of ``left``: none, when
    ``complete``. ``searched`` says for each component what the region is. ``free`` are components that no condition
    holds: the spots repeat for all their values. They repeat with ``periods`` too (2 pi times the number given), in
    the angles of which one turn was searched. ``patch`` is given where there are fewer conditions than unknowns.
    """

    ask: ClassVar[str] = ".complete is True when all G-spots in the region are listed; .verdict has three outcomes"
    written: ClassVar[str] = "name verdict complete searched free spots boundary left patch"

    name: str
    spots: tuple[GSpot, ...]
    boundary: tuple[GSpot, ...]
    left: tuple[Left, ...]
    searched: tuple[tuple[str, str], ...]
    free: tuple[str, ...]
    patch: Patch | None = None
    periods: tuple[tuple[str, fmpq], ...] = ()

    @property
    def complete(self) -> bool:
        """Whether every G-spot in the region is in the list, and everything in the list in the region."""
        return not self.left and not self.boundary and self.patch is None

    @property
    def verdict(self) -> Verdict:
        """On the statement that the region has G-spots, which are those of the list."""
        if self.patch is not None:
            return Verdict.argued(f"{self.name} has G-spots that form a {shape(self.patch.dimension)}", str(self.patch))
        if self.complete and self.spots:
            return Verdict.argued(f"{self.name} has exactly {_count(len(self.spots))} in the region searched")
        statement = f"{self.name} has G-spots in the region searched"
        if self.complete:
            return Verdict.argued(statement, witness="every box of the region was excluded")
        detail = f"{len(self.spots)} proved, {len(self.boundary)} at the boundary, {len(self.left)} boxes left"
        budget = any("budget" in left.why for left in self.left)
        return Verdict.undecided(
            f"the list of the G-spots of {self.name} is complete",
            Reason.BUDGET if budget else Reason.HYPOTHESIS,
            detail,
        )

    def __str__(self) -> str:
        return "\n".join([*self.about(), *self._listed()])

    def about(self) -> list[str]:
        """The lines of the text that say what was searched, what was found and what is left, without the list."""
        lines = [str(self.verdict).splitlines()[0]]
        if self.patch is not None:
            lines.append(f"  {self.patch}")
            lines.append("  fix components (fixed, conditions) for isolated G-spots and a complete list")
        lines += [f"  {word}: {text}" for word, text in self.searched]
        lines += [f"  left open: {left}" for left in self.left[:_SHOWN]]
        if len(self.left) > _SHOWN:
            lines.append(f"  and {len(self.left) - _SHOWN} boxes more are left open")
        return lines

    def _listed(self) -> list[str]:
        lines = []
        for title, spots in (("G-spot", self.spots), ("at the boundary of the region", self.boundary)):
            for n, spot in enumerate(spots, 1):
                lines.append(f"  {title} {n}: " + ", ".join(f"{k} = {v}" for k, v in spot.to_json().items()))
        return lines


def shape(dimension: int) -> str:
    """The name of a set of this dimension."""
    return {1: "curve", 2: "surface"}.get(dimension, f"set of dimension {dimension}")


def in_words(mechanism: Mechanism, word: str, value: arb) -> str:
    """A component of the shifted state as text: an angle as ``reference + deviation``."""
    reference = next((angle.name for angle in mechanism.angles if angle.coordinate == word), None)
    return ball_text(value) if reference is None else f"{reference} + {ball_text(value)}"


def _count(number: int) -> str:
    return "one G-spot" if number == 1 else f"{number} G-spots"
