"""All G-spots of a mechanism with what each of them is; where there is none, why: the critical friction."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import ClassVar

from flint import fmpq

from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.periods import period_factor
from gspot_verified.functions.rings import BALLS
from gspot_verified.functions.straight_line import StraightLine
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.all_g_spots import DEFAULT_BUDGET, find_g_spots
from gspot_verified.mechanisms.spots.classify import Classification, classify_g_spot
from gspot_verified.mechanisms.spots.critical_friction import CriticalFriction, critical_friction
from gspot_verified.mechanisms.spots.g_spot import DEFAULT_BITS, GSpot, find_g_spot
from gspot_verified.mechanisms.spots.g_spot_list import GSpots
from gspot_verified.mechanisms.spots.spot_table import spot_table
from gspot_verified.numbers.balls import ExactInput, ball, working_bits
from gspot_verified.numbers.evidence import every, inside
from gspot_verified.numbers.verdict import NoTruthValue, Outcome, Verdict
from gspot_verified.numbers.written import Written

_FRICTION_BUDGET = 4000  # boxes: the critical friction is an extra here, a fifth of its own budget
_MORE_BITS = 64  # for the G-spot of the place: its box is narrower than that in the list, and lies in it
_NUMBERS = ("alpha_1", "alpha_2", "alpha_3", "u", "a", "A", "B", "C", "mu")


@dataclass(frozen=True)
class AllClassified(NoTruthValue, Written):
    """The result of :func:`classify_all`: ``found`` are the G-spots, ``spots`` what each of ``found.spots`` is.

    ``vary`` names what depends on a free component, or has not the period of the conditions in an angle: it holds
    for the value shown only. ``at_place`` is the number of the spot found from the place that the mechanism names.
    """

    written: ClassVar[str] = "search=found critical_friction=critical spots vary"

    found: GSpots
    spots: tuple[Classification, ...]
    critical: CriticalFriction
    vary: tuple[tuple[str, tuple[str, ...]], ...]
    at_place: int | None = None

    @property
    def verdict(self) -> Verdict:
        """That of the search: proved when there are G-spots and all are listed, refuted when there is none."""
        return self.found.verdict

    @property
    def exit_code(self) -> int:
        """0 proved, 1 refuted, 2 undecided; 2 also when the case of one of the G-spots is open."""
        open_case = any(spot.case is None for spot in self.spots)
        return 2 if open_case and self.verdict.outcome is Outcome.PROVED else self.verdict.exit_code

    def __str__(self) -> str:
        follow = {word for word, text in self.found.searched if text.startswith("follows")}
        table = spot_table(self.spots, follow, self.at_place)
        return "\n".join([*self.found.summary(), f"  {self.critical.in_short()}", *self._remarks(), *table])

    def in_full(self) -> str:
        """The text with the balls of every number of every G-spot."""
        spots = [f"G-spot {n}: {spot}" for n, spot in enumerate(self.spots, 1)]
        return "\n".join([*self.found.about(), str(self.critical), *self._remarks(), *spots])

    def _remarks(self) -> list[str]:
        lines = [
            f"note: {word} stands in {', '.join(names)}, and "
            + ("no condition holds it" if word in self.found.free else "they have not the period of the conditions")
            + ": these are shown for one value of it"
            for word, names in self.vary
        ]
        return lines + [
            "at the boundary of the region: " + ", ".join(f"{k} = {v}" for k, v in spot.to_json().items())
            for spot in self.found.boundary
        ]


def classify_all(
    mechanism: Mechanism,
    box: Mapping[str, tuple[ExactInput, ExactInput]] | None = None,
    bits: int = DEFAULT_BITS,
    budget: int = DEFAULT_BUDGET,
) -> AllClassified:
    """Find all G-spots in a region of states, without a start, and say of each which of the three cases it is.

    Those that slip in contact may reach come first. They have numbers, which other functions take as ``spot``; not in a
    box, or with another budget: the list may be another one. The arguments are those of
    :func:`gspot_verified.mechanisms.spots.all_g_spots.find_g_spots`.

    :raises MechanismError: the mechanism is not complete, or the box names no component of the state, or one that the
        mechanism fixes.

    >>> from gspot_verified import load
    >>> result = classify_all(load("genot_brogliato_rod", mu="7/5"))
    >>> [spot.case for spot in result.spots]
    ['none', 'none', 'none', 'none']
    >>> result = classify_all(load("genot_brogliato_rod", mu="13/10"))
    >>> result.exit_code, result.critical.is_below
    (1, True)
    """
    found = find_g_spots(mechanism, box, bits, budget)
    named = named_spot(mechanism, found, bits)
    g_spots = with_the_exact_one(found, named)
    numbers = range(1, len(g_spots.spots) + 1) if not box and budget == DEFAULT_BUDGET else [None] * len(g_spots.spots)
    pairs = list(zip(numbers, g_spots.spots, strict=True))
    return AllClassified(
        g_spots,
        tuple(replace(classify_g_spot(spot), number=number) for number, spot in pairs),
        replace(critical_friction(mechanism, bits, _FRICTION_BUDGET), beyond_box=bool(box)),
        _vary(mechanism, g_spots),
        next((number for number, spot in pairs if named is not None and _is_named(spot, named)), None),
    )


def with_the_exact_one(g_spots: GSpots, named: GSpot | None) -> GSpots:
    """The list with the G-spot that the mechanism names, where it is rational, in the place of its enclosure."""
    if named is None or not named.exact:
        return g_spots
    return replace(g_spots, spots=tuple(named if _is_named(spot, named) else spot for spot in g_spots.spots))


def named_spot(mechanism: Mechanism, g_spots: GSpots, bits: int) -> GSpot | None:
    """The G-spot found from the place that the mechanism names; None where the list is empty, or none is found."""
    if not g_spots.spots:
        return None
    try:
        return find_g_spot(mechanism, bits + _MORE_BITS)
    except ValueError:
        return None


def _is_named(spot: GSpot, named: GSpot) -> bool:
    """Whether the box holds the named point or its box: then that is the one zero in it, with the same conditions."""
    with working_bits(named.bits):
        pairs = list(zip(map(ball, spot.system.point), map(ball, named.system.point), strict=True))
        if named.exact:
            return spot.fixed == named.fixed and all((x - y).contains(0) for x, y in pairs)
        return spot.fixed == named.fixed and every(inside(y, x) for x, y in pairs) is not None


def _vary(mechanism: Mechanism, g_spots: GSpots) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Which of the numbers of a classification differ where a free component, or a whole turn of an angle, differs.

    The mass matrix and mu are among them: where they differ, a translate may be no G-spot.
    """
    shifted = shift(mechanism)
    functions = shifted.functions
    parts: dict[str, list[Expression]] = {name: [getattr(functions, name)] for name in _NUMBERS}
    parts["the mass matrix"] = [entry for row in functions.mass_matrix or () for entry in row]
    parts = {name: shifted.expressions(own, BALLS) for name, own in parts.items()}
    state = mechanism.state
    listed = []
    for word in g_spots.free:
        listed.append((word, [name for name, own in parts.items() if _holds(own, state.index(word))]))
    for word, period in g_spots.periods:
        inside = [name for name, own in parts.items() if not _has_period(own, state.index(word), period)]
        listed.append((word, inside))
    return tuple((word, tuple(inside)) for word, inside in listed if inside)


def _holds(functions: list[Expression], index: int) -> bool:
    code = StraightLine()
    return any(index in code.depends(code.value(function)) for function in functions)


def _has_period(functions: list[Expression], index: int, period: fmpq) -> bool:
    """Whether the functions certainly have the period 2 pi ``period`` in this component."""
    own = period_factor(functions, index)
    return not _holds(functions, index) if own is None else (period / own).q == 1
