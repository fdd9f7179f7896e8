"""What a search for all G-spots gives: those that were proved, what is left open, a patch where they form a surface."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.g_spot import GSpot
from gspot_verified.mechanisms.spots.sign_of_p import SignOfP
from gspot_verified.numbers.balls import ball_text
from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.evidence import equal, every
from gspot_verified.numbers.verdict import Evidence, NoTruthValue, Outcome, Reason, Verdict
from gspot_verified.numbers.written import Written

_SHOWN = 20  # open boxes that the text lists
_EXCLUDED = "every box of the region was excluded"


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
    """For all values of ``parameters`` in their intervals exactly one G-spot has the other components in ``box``, where
    those of ``free``, which no condition holds, have the values given; fixed components have the values that the region
    of :class:`GSpots` names, and its conditions J hold.

    ``dimension`` is that of the curve or surface which the G-spots form there, free components included. ``shown`` is
    what was compared for it, for the intervals as they are written.
    """

    ask: ClassVar[str] = ".dimension is that of the curve or surface"

    dimension: int
    parameters: tuple[tuple[str, str], ...]
    box: tuple[tuple[str, str], ...]
    free: tuple[tuple[str, str], ...] = ()
    shown: Evidence | None = field(default=None, compare=False, repr=False)

    def __str__(self) -> str:
        over = ", ".join(f"{word} in {text}" for word, text in self.parameters)
        there = ", ".join(f"{word} in {text}" for word, text in self.box)
        where = ", ".join(f"{word} = {text}" for word, text in self.free)
        return f"for all {over} exactly one with {there}" + (f", where {where}" if where else "")


@dataclass
class Account:
    """What a search for all G-spots compared, so that a solution that is lost on the way is missed.

    The search begins with one solution, that nothing is known. Each time that a stage is solved for one solution it has
    ``extensions`` in its place, by ``stages``. In the end each solution is one G-spot of the region, by ``inside``, or
    lies outside, by ``outside``, or stays open.
    """

    extensions: list[int] = field(default_factory=list)
    stages: list[Evidence | None] = field(default_factory=list)
    inside: list[Evidence | None] = field(default_factory=list)
    outside: list[Evidence | None] = field(default_factory=list)

    def extended(self, solutions: Sequence[object], shown: Evidence | None) -> None:
        """A solution of the stages before has these extensions, all different, and no others."""
        self.extensions.append(len(solutions))
        self.stages.append(shown)

    def evidence(self, spots: int, open_places: int) -> Evidence | None:
        """That these are all G-spots in the region, and nothing is open."""
        solutions = 1 + sum(number - 1 for number in self.extensions)
        return every(
            [
                equal(open_places, 0),
                equal(spots, len(self.inside)),
                equal(len(self.inside) + len(self.outside), solutions),
                *self.stages,
                *self.inside,
                *self.outside,
            ]
        )


@dataclass(frozen=True)
class GSpots(NoTruthValue, Written):
    """The G-spots of a mechanism in a region of states.

    ``spots`` are proved to lie in the region, each alone in its box. ``boundary`` are proved too, but so near to the
    end of an interval that they may lie outside. Every other G-spot in the region lies in a box of ``left``: none, when
    ``complete``. ``searched`` says for each component what the region is, ``region`` the same in one phrase,
    ``defaults`` which components were searched in an interval that was not given. ``free``
    are components that no condition holds: the spots repeat for all their values, but for those that ``region`` names
    with one value, because the mass matrix or mu depends on them. They repeat with ``periods`` too
    (2 pi times the number given), in the angles of which one turn was searched. ``patch`` is given where there are
    fewer conditions than unknowns. ``account`` is what was compared; ``sign_of_p`` that of p in the whole region,
    where there is no G-spot and it was shown.

    The numbers of the spots, from 1, are those that ``spot`` takes everywhere.
    """

    ask: ClassVar[str] = ".complete is True when all G-spots in the region are listed; .verdict has three outcomes"
    written: ClassVar[str] = "name verdict complete searched free spots boundary left patch"

    name: str
    spots: tuple[GSpot, ...]
    boundary: tuple[GSpot, ...]
    left: tuple[Left, ...]
    searched: tuple[tuple[str, str], ...]
    region: str
    defaults: tuple[str, ...]
    free: tuple[str, ...]
    patch: Patch | None = None
    periods: tuple[tuple[str, fmpq], ...] = ()
    account: Account = field(default_factory=Account, compare=False, repr=False)
    sign_of_p: SignOfP | None = None

    def spot(self, number: int) -> GSpot:
        """The G-spot of this number, from 1.

        :raises ValueError: there is none; the message says how many there are.
        """
        count = len(self.spots)
        if type(number) is not int or not 1 <= number <= count:
            if count == 0:
                raise ValueError(
                    f"spot: {self.name}: no G-spot was found (classify --all says why), got {number!r:.20}"
                )
            listed = f"{self.name} has {'' if self.complete else 'at least '}{counted(count, 'G-spot')}"
            wanted = f"expected {'1' if count == 1 else f'a number in 1..{count}'}, got {number!r:.20}"
            inside = " in the region searched by default" if self.defaults else ""
            raise ValueError(f"spot: {listed}{inside} (classify --all lists them): {wanted}")
        return self.spots[number - 1]

    @property
    def complete(self) -> bool:
        """Whether every G-spot in the region is in the list, and everything in the list in the region."""
        return self.patch is None and self._all_shown is not None

    @property
    def _all_shown(self) -> Evidence | None:
        return self.account.evidence(len(self.spots), len(self.left) + len(self.boundary))

    @property
    def verdict(self) -> Verdict:
        """On the statement that the region has G-spots, which are those of the list."""
        if self.patch is not None and self.patch.shown is not None:
            form = f"{self.name} has G-spots that form a {shape(self.patch.dimension)} in the region: {self.region}"
            return Verdict.proved(form, self.patch.shown, str(self.patch))
        shown = self._all_shown if self.patch is None else None
        if shown is not None:
            if self.spots:
                exactly = f"{self.name} has exactly {counted(len(self.spots), 'G-spot')} in the region: {self.region}"
                return Verdict.proved(exactly, shown)
            statement, witness = f"{self.name} has a G-spot in the region: {self.region}", _EXCLUDED
            if self.sign_of_p is None:
                return Verdict.refuted(statement, witness, shown)
            return Verdict.refuted(statement, witness, every([shown, self.sign_of_p.shown]), str(self.sign_of_p))
        left = counted(len(self.left), "box", "boxes")
        detail = f"{len(self.spots)} proved, {len(self.boundary)} at the boundary, {left} left"
        budget = any("budget" in left.why for left in self.left)
        return Verdict.undecided(
            f"the list of the G-spots of {self.name} is complete in the region: {self.region}",
            Reason.BUDGET if budget else Reason.HYPOTHESIS,
            detail,
        )

    def __str__(self) -> str:
        return "\n".join([*self.about(), *self._listed()])

    def about(self) -> list[str]:
        """The lines of the text that say what was searched, what was found and what is left, without the list."""
        lines = self.summary()
        lines[1:1] = [f"  {word}: {text}" for word, text in self.searched]
        return lines

    def summary(self) -> list[str]:
        """The same with the region in one phrase."""
        lines = [self._in_a_sentence()]
        if self.patch is not None:
            lines.append(f"  {self.patch}")
            lines.append("  fix components (fixed, conditions) for isolated G-spots and a complete list")
        lines += [] if self.sign_of_p is None else [f"  {self.sign_of_p}"]
        if self.defaults and self.patch is None:
            where = ", ".join(self.defaults)
            lines.append(f"  {where}: beyond it nothing was searched; an interval of yours (box, --box) may be longer")
        lines += [f"  left open: {left}" for left in self.left[:_SHOWN]]
        if len(self.left) > _SHOWN:
            lines.append(f"  and {counted(len(self.left) - _SHOWN, 'box', 'boxes')} more left open")
        return lines

    def _in_a_sentence(self) -> str:
        verdict = self.verdict
        if verdict.outcome is Outcome.REFUTED:
            return f"{self.name} has no G-spot in the region (refuted that there is one): {self.region}"
        return str(verdict).splitlines()[0]

    def _listed(self) -> list[str]:
        lines = []
        for title, spots in (("G-spot", self.spots), ("at the boundary of the region", self.boundary)):
            for n, spot in enumerate(spots, 1):
                lines.append(f"  {title} {n}: " + ", ".join(f"{k} = {v}" for k, v in spot.to_json().items()))
        return lines


def shape(dimension: int) -> str:
    """The name of a set of this dimension."""
    return {1: "curve", 2: "surface"}.get(dimension, f"set of dimension {dimension}")


def in_words(mechanism: Mechanism, word: str, value: arb, written: Callable[[arb], str] = ball_text) -> str:
    """A component of the shifted state as text: an angle as ``reference + deviation``."""
    reference = next((angle.name for angle in mechanism.angles if angle.coordinate == word), None)
    return written(value) if reference is None else f"{reference} + {written(value)}"
