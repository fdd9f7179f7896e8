"""The region of states in which G-spots are looked for: given intervals, whole periods of angles, stated bounds.

Proof page: ``proofs/all_g_spots.md``, section 5.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from types import MappingProxyType

from flint import arb, fmpq

from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.periods import period_factor
from gspot_verified.mechanisms.derive.to_system import angle_ball
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.spots.spot_conditions import TakenApart
from gspot_verified.numbers.balls import Exact, ExactInput, ball, certainly_less, exact, hull
from gspot_verified.numbers.evidence import at_most, equal, every, less
from gspot_verified.numbers.inner_text import text_of_each
from gspot_verified.numbers.verdict import Evidence

DEFAULT_BOUND = 10
"""The bound on a component that has neither an interval nor a period, and is not found in closed form."""


_MORE_THAN_HALF_A_TURN = fmpq(13, 4)
"""In units of the period over 2 pi. The ends of exactly one turn are likely places of G-spots: not to be cut there."""


class Region:
    """Make one with :func:`search_region`. Components are known by their index, angles counted from their references.

    A closed interval for some components, a period for others; the rest take every value, until :meth:`side` is asked
    for one of them: then the default bound holds for it. Intervals that are not given lie about the mechanism's
    ``place``, where that has a value for the component, else about 0.
    """

    def __init__(
        self, mechanism: Mechanism, given: Mapping[int, tuple[Exact, Exact]], place: Mapping[str, arb] | None = None
    ) -> None:
        self._state = mechanism.state
        self._place = dict(place or {})
        self._references = {mechanism.state.index(a.coordinate): angle_ball(a) for a in mechanism.angles}
        self._names = {mechanism.state.index(a.coordinate): a.name for a in mechanism.angles}
        self._given = dict(given)
        self._intervals: dict[int, tuple[arb, arb]] = {}
        for i, (lower, upper) in given.items():
            reference = self._references.get(i, arb(0))
            self._intervals[i] = (ball(lower) - reference, ball(upper) - reference)
        self._turns: dict[int, fmpq] = {}
        self._one_turn: dict[int, tuple[fmpq, fmpq]] = {}
        self._bounded: dict[int, tuple[fmpq, fmpq]] = {}

    def add_period(self, index: int, factor: fmpq, of_all: bool) -> None:
        """All conditions (or only those that are searched for this component) have the period 2 pi ``factor`` in it."""
        if of_all:
            self._turns[index] = factor
        else:
            self._one_turn[index] = self._about_place(index, _MORE_THAN_HALF_A_TURN * factor, factor / 4)
            lower, upper = self._one_turn[index]
            self._intervals[index] = (arb(lower), arb(upper))

    def _about_place(self, index: int, half: fmpq, step: fmpq) -> tuple[fmpq, fmpq]:
        """An interval about the multiple of ``step`` next to the place: any would do, as it is said which it is."""
        value = self._place.get(self._state[index], arb(0))
        number = (value / arb(step) + arb(fmpq(1, 2))).floor().unique_fmpz()
        centre = fmpq(0) if number is None else step * fmpq(number)
        return centre - half, centre + half

    def period(self, index: int) -> arb | None:
        """The period of all conditions in the component, if the whole circle is searched."""
        factor = self._turns.get(index)
        return None if factor is None else 2 * arb.pi() * arb(factor)

    def periods(self) -> tuple[tuple[str, fmpq], ...]:
        """The components of which one period of all conditions is searched, with the period over 2 pi."""
        return tuple((self._state[index], factor) for index, factor in sorted(self._turns.items()))

    def side(self, index: int) -> arb:
        """A ball that holds the interval of the component, or one period of it."""
        if index in self._turns:
            return arb(0, (arb.pi() * arb(self._turns[index])).upper())
        if index not in self._intervals:
            self._bounded[index] = self._about_place(index, fmpq(DEFAULT_BOUND), fmpq(1))
            first, last = self._bounded[index]
            self._intervals[index] = (arb(first), arb(last))
        lower, upper = self._intervals[index]
        return hull([lower, upper])

    def known_side(self, index: int) -> arb | None:
        """The same; None for a component that takes every value."""
        return self.side(index) if index in self._turns or index in self._intervals else None

    def given(self, index: int) -> arb | None:
        """A ball around the given interval of a component; None where none is given."""
        return self.side(index) if index in self._given else None

    def within_one_period(self, index: int, value: arb) -> arb:
        """The value moved by whole periods towards 0."""
        period = self.period(index)
        if period is None:
            return value
        return value - period * round(float(value.mid() / period.mid()))

    def position(self, point: Sequence[arb]) -> tuple[str, Evidence | None]:
        """ "inside" or "outside" with the comparisons, or "boundary" when the balls leave it open."""
        within: list[Evidence | None] = [equal(len(self._state), len(point))]
        for i, (lower, upper) in self._intervals.items():
            beyond = less(point[i], lower) or less(upper, point[i])
            if beyond is not None:
                return "outside", beyond
            within += [at_most(lower, point[i]), at_most(point[i], upper)]
        inside = every(within)
        return ("boundary", None) if inside is None else ("inside", inside)

    def searched(self, apart: TakenApart) -> tuple[tuple[str, str], ...]:
        """For each component in words what was searched."""
        explicit = {each.index: each.condition for each in apart.explicit}
        rows = []
        for i, word in enumerate(self._state):
            if i in self._given:
                lower, upper = self._given[i]
                text = f"[{text_of_each(lower)}, {text_of_each(upper)}]"
                text += "; free: no condition holds it" if i in apart.free else ""
            elif i in explicit:
                text = "fixed" if explicit[i] == fixed_name(word) else f"follows from {explicit[i]} = 0"
            elif i in apart.free:
                text = "free: no condition holds it"
            elif i in self._turns:
                text = f"every angle (all conditions have the period {_pi(2 * self._turns[i])})"
            elif i in self._one_turn:
                text = f"{self._stated(i)} (default: more than one period)"
            elif i in self._bounded:
                text = f"{self._stated(i)} (default bound)"
            else:
                text = "every value"
            rows.append((word, text))
        return tuple(rows)

    def defaults(self, apart: TakenApart) -> tuple[str, ...]:
        """The components that were searched in an interval that was not given, with it."""
        held = {*self._given, *(each.index for each in apart.explicit), *apart.free}
        return tuple(f"{self._state[i]} in {self._stated(i)}" for i in sorted({*self._one_turn, *self._bounded} - held))

    def _stated(self, index: int) -> str:
        """An interval that was not given; of an angle with a reference its distance from that."""
        lower, upper = self._one_turn[index] if index in self._one_turn else self._bounded[index]
        reference = self._names.get(index)
        return f"[{lower}, {upper}]{f' about {reference}' if reference else ''}"

    def in_words(
        self,
        apart: TakenApart,
        fixed: Mapping[str, str],
        at_value: Mapping[int, str] = MappingProxyType({}),
        one_period: Collection[int] = (),
    ) -> str:
        """The same in one phrase: what is searched, and the values ``fixed``; what follows from these is left out.

        ``at_value``: components for which a value is stated in the place of all that were searched, because the mass
        matrix or mu depends on them; ``one_period``: angles with which these do not repeat.
        """
        explicit = {each.index: each.condition for each in apart.explicit}
        angles, bounded, every, free, held = (list[str]() for _ in range(5))
        for i, word in enumerate(self._state):
            if i in at_value:
                bounded.append(f"{word} = {at_value[i]} (the mass matrix or mu depends on it, no condition does)")
            elif i in one_period:
                repeats = "(the mass matrix or mu does not repeat with it)"
                bounded.append(f"the angle {word}, one period of it as shown {repeats}")
            elif i in self._given:
                lower, upper = self._given[i]
                within = f"{word} in [{text_of_each(lower)}, {text_of_each(upper)}]"
                (free if i in apart.free else bounded).append(within)
            elif explicit.get(i) == fixed_name(word):
                held.append(f"{word} = {fixed[word]}" if word in fixed else word)
            elif i in explicit:
                continue
            elif i in apart.free:
                free.append(word)
            elif i in self._turns:
                # Of one turn nothing need be said; another period changes the number of the spots in a turn.
                one_turn = self._turns[i] == 1
                angles.append(word if one_turn else f"{word} (counted in one period, {_pi(2 * self._turns[i])})")
            elif i in self._one_turn or i in self._bounded:
                bounded.append(f"{word} in {self._stated(i)} (default)")
            else:
                every.append(word)
        parts = [
            *(f"every angle {word}" for word in angles),
            *bounded,
            *([f"every value of {', '.join(every)}"] if every else []),
            *([f"any {', '.join(free)} (no condition holds {'it' if len(free) == 1 else 'them'})"] if free else []),
            *([f"{', '.join(held)} fixed"] if held else []),
        ]
        return "; ".join(parts)


def fixed_name(word: str) -> str:
    """The name of the condition that a component keeps its value: unlike p, b, y, v, whatever the component's name."""
    return f"fixed {word}"


def search_region(
    mechanism: Mechanism,
    conditions: Mapping[str, Expression],
    apart: TakenApart,
    box: Mapping[str, tuple[ExactInput, ExactInput]],
    place: Mapping[str, arb] | None = None,
) -> Region:
    """The region: the box where it names a component, one period where the conditions have one.

    ``place`` are the values that the mechanism gives, angles counted from their references.

    :raises MechanismError: the box names no component, or an interval is empty.
    """
    region = Region(mechanism, _intervals(mechanism, box), place)
    for stage in apart.stages:
        functions = [apart.functions[name] for name in stage.conditions]
        for i in stage.variables:
            if mechanism.state[i] in box:
                continue
            of_all = period_factor(list(conditions.values()), i)
            own = period_factor(functions, i)
            if of_all is not None:
                region.add_period(i, of_all, True)
            elif own is not None:
                region.add_period(i, own, False)
    return region


def _intervals(
    mechanism: Mechanism, box: Mapping[str, tuple[ExactInput, ExactInput]]
) -> dict[int, tuple[Exact, Exact]]:
    intervals = {}
    for word, pair in box.items():
        if word not in mechanism.state:
            raise MechanismError(
                f"{mechanism.name}: box: {word!r} is no component of the state: {', '.join(mechanism.state)}"
            )
        try:
            lower, upper = (exact(value, f"box, {word}") for value in pair)
        except (TypeError, ValueError) as error:
            raise MechanismError(f"{mechanism.name}: {error}") from None
        if not _is_interval(lower, upper):
            raise MechanismError(f"{mechanism.name}: box: the interval of {word} is empty or reversed")
        intervals[mechanism.state.index(word)] = (lower, upper)
    return intervals


def _is_interval(lower: Exact, upper: Exact) -> bool:
    if isinstance(lower, fmpq) and isinstance(upper, fmpq):
        return bool(lower <= upper)
    return certainly_less(ball(upper), ball(lower)) is False


def _pi(factor: fmpq) -> str:
    return "pi" if factor == 1 else f"{factor} pi"
