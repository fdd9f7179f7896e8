"""All G-spots of a mechanism in a box of its states, each proved unique in a box of its own, and no others.

Proof page: ``proofs/all_g_spots.md``. The conditions are taken apart (:mod:`spot_conditions`), solved stage by stage
(:mod:`all_zeros`, :mod:`velocity_roots`), and each solution is proved once more as a zero of all conditions together.

A whole state from the components that a search has found (section 5): what follows from them, and what no condition
holds.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from flint import arb

from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import partial_derivative
from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.mass_matrix import check_mass_matrix
from gspot_verified.mechanisms.derive.slip_hypotheses import SlipHypotheses
from gspot_verified.mechanisms.derive.to_system import Shifted, shift, stays
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.spots.classify import classify_g_spot, sign_of_exact
from gspot_verified.mechanisms.spots.g_spot import (
    DEFAULT_BITS,
    GSpot,
    place_in,
    prove_near,
    shifted_conditions,
    whole_component,
)
from gspot_verified.mechanisms.spots.g_spot_list import Account, GSpots, Left, Patch, in_words
from gspot_verified.mechanisms.spots.search_region import Region, fixed_name, search_region
from gspot_verified.mechanisms.spots.sign_of_p import SignOfP, sign_of_p
from gspot_verified.mechanisms.spots.spot_conditions import Stage, TakenApart, components_of, take_apart
from gspot_verified.mechanisms.spots.spot_patch import find_patch
from gspot_verified.mechanisms.zeros.all_zeros import Box, Budget, Zero, Zeros, ZeroSearch, clusters
from gspot_verified.mechanisms.zeros.velocity_roots import VelocityRoots
from gspot_verified.numbers.balls import ExactInput, add_remainder, ball, checked_bits, nonfinite, working_bits
from gspot_verified.numbers.evidence import differ, equal, every, inside
from gspot_verified.numbers.inner_text import in_inner_interval, inner_text
from gspot_verified.numbers.verdict import Evidence


class WholeState:
    """``place`` are the values that the mechanism gives for components, by name; ``words`` the names of all."""

    def __init__(self, apart: TakenApart, region: Region, place: Mapping[str, arb], words: Sequence[str]) -> None:
        self._apart, self._region, self._place, self._words = apart, region, place, words
        self._program = BoxProgram([each.value for each in apart.explicit], len(words), ())

    def state(self, values: Mapping[int, arb], free: Mapping[int, arb]) -> list[arb]:
        """The whole state: also the free components, and those that follow from the others."""
        known = {**values, **free}
        state = [known.get(i, arb(0)) for i in range(len(self._words))]
        for each, value in zip(self._apart.explicit, self._program.values(state), strict=True):
            state[each.index] = value
        return state

    def chosen_free(self) -> dict[int, arb]:
        """For each free component one value: that of the mechanism's place, or 0, or the middle of its interval."""
        chosen = {}
        for i in self._apart.free:
            value, side = self._place.get(self._words[i], arb(0)), self._region.given(i)
            chosen[i] = value if side is None or side.contains(value) else side.mid()
        return chosen

    def any_free(self) -> dict[int, arb]:
        """For each free component all of its values: its interval, or no information."""
        sides = {i: self._region.given(i) for i in self._apart.free}
        return {i: nonfinite() if side is None else side for i, side in sides.items()}

    def depends_on_free(self) -> bool:
        """Whether a component with an interval follows from free components."""
        return any(
            self._region.given(each.index) is not None and depends & set(self._apart.free)
            for each, depends in zip(self._apart.explicit, self._program.depends, strict=True)
        )


DEFAULT_BUDGET = 100_000
"""How many boxes are looked at."""

_EXTRA_BITS = 40  # working bits beyond those asked for: any number is correct
_ROOM = (-8, -12, -16, -24, -32, -48, -64, -96, -128)  # exponents of what an interval is wider by: any will do


@dataclass(frozen=True)
class _Partial:
    """Values of the components solved for so far: one solution when ``proved``, otherwise perhaps some or none."""

    values: Mapping[int, arb]
    proved: bool = True
    why: str = ""
    same: tuple[Callable[[Sequence[arb]], Evidence | None], ...] = ()
    """For each stage: that a zero of all conditions, given by enclosures, is this solution."""
    shown: tuple[Evidence | None, ...] = ()
    """For each stage: that there is this solution."""


def find_g_spots(
    mechanism: Mechanism,
    box: Mapping[str, tuple[ExactInput, ExactInput]] | None = None,
    bits: int = DEFAULT_BITS,
    budget: int = DEFAULT_BUDGET,
) -> GSpots:
    """All G-spots p = b = y = v = 0 (and J = 0, where conditions or fixed components are given) in a box of states.

    ``box`` gives closed intervals for components; without one an angle takes every value, and so does a component that
    is found in closed form; the result says what was searched. ``budget`` is the number of boxes that are looked at.
    The place that the mechanism names is used for its fixed components and for components that no condition holds.

    :raises ValueError: ``bits`` is no int, or below 2; ``budget`` is no int, or below 1.
    :raises MechanismError: the mechanism is not complete, or the box names no component of the state, or one that the
        mechanism fixes.

    >>> from gspot_verified import load
    >>> g_spots = find_g_spots(load("genot_brogliato_rod", mu="7/5"))
    >>> len(g_spots.spots), g_spots.complete
    (4, True)
    >>> find_g_spots(load("genot_brogliato_rod", mu="13/10")).verdict.outcome.value
    'refuted'
    """
    if type(budget) is not int or budget < 1:
        raise ValueError(f"budget: expected a number of boxes, 1 or more, got {budget!r}")
    bits = checked_bits(bits, 2)
    shifted = shift(mechanism)
    with working_bits(bits + _EXTRA_BITS):
        return _Search(shifted, box or {}, bits, Budget(budget)).run()


def spot_conditions(shifted: Shifted) -> dict[str, Expression]:
    """p, b, y, v and the conditions J that the mechanism gives, as functions of its (shifted) state."""
    functions, place = shifted.functions, shifted.mechanism.place
    J = shifted_conditions(shifted)
    expressions = shifted.expressions([functions.p, functions.b, functions.y, functions.v, *J], BALLS)
    conditions = dict(zip(["p", "b", "y", "v", *(f"J_{i + 1}" for i in range(len(J)))], expressions, strict=True))
    given = place_in(shifted, BALLS)
    for word in place.fixed or ():
        if word not in given:
            raise MechanismError(f"{shifted.mechanism.name}: the fixed component {word} has no value")
        conditions[fixed_name(word)] = stays(shifted.mechanism.state.index(word), given[word], BALLS)
    return conditions


def _refuse_fixed(shifted: Shifted, box: Iterable[str]) -> None:
    """Of a component that keeps its value this value alone is searched: an interval for it is no region."""
    for word in set(shifted.mechanism.place.fixed or ()) & set(box):
        raise MechanismError(
            f"{shifted.mechanism.name}: box: {word} is among the components that the mechanism fixes, and the search "
            "takes this value alone; leave it out of the box, or set the value"
        )


class _Search:
    def __init__(
        self, shifted: Shifted, box: Mapping[str, tuple[ExactInput, ExactInput]], bits: int, budget: Budget
    ) -> None:
        self._shifted, self._bits, self._budget = shifted, bits, budget
        self._state = shifted.mechanism.state
        _refuse_fixed(shifted, box)
        conditions = spot_conditions(shifted)
        kept = [self._state.index(word) for word in box if word in self._state]
        self._apart: TakenApart = take_apart(conditions, len(self._state), kept)
        self._place = place_in(shifted, BALLS)
        self._region: Region = search_region(shifted.mechanism, conditions, self._apart, box, self._place)
        self._whole = WholeState(self._apart, self._region, self._place, self._state)
        self._supposed = SlipHypotheses(shifted)
        self._left: list[Left] = []
        self._account = Account()

    def run(self) -> GSpots:
        partials = [_Partial({})]
        for i, stage in enumerate(self._apart.stages):
            if stage.dimension > 0:
                return self._with_more_freedom(partials, self._apart.stages[i:])
            solved: list[_Partial] = []
            for partial in partials:
                solved += self._solve(stage, partial)
            partials = solved
        spots: list[GSpot] = []
        boundary: list[GSpot] = []
        for partial in partials:
            self._finish(partial, spots, boundary)
        return self._result(spots, boundary)

    def _result(self, spots: Sequence[GSpot], boundary: Sequence[GSpot], patch: Patch | None = None) -> GSpots:
        return GSpots(
            name=self._shifted.mechanism.name,
            spots=tuple(relevant_first(spots)),
            boundary=tuple(boundary),
            left=tuple(self._left),
            searched=self._region.searched(self._apart),
            region=self._region_in_words(spots),
            defaults=self._region.defaults(self._apart),
            free=tuple(self._state[i] for i in self._apart.free),
            patch=patch,
            periods=self._region.periods(),
            account=self._account,
            sign_of_p=None if spots or boundary or self._left or patch is not None else self._sign_of_p(),
        )

    def _region_in_words(self, spots: Sequence[GSpot]) -> str:
        mechanism = self._shifted.mechanism
        place = {word: whole_component(mechanism, word, value) for word, value in self._place.items()}
        text = self._region.in_words(self._apart, place, *self._as_shown(spots))
        return f"{text}; the given conditions J = 0" if mechanism.place.conditions else text

    def _as_shown(self, spots: Sequence[GSpot]) -> tuple[dict[int, str], set[int]]:
        """The free components and the angles for whose other values the spots need not be G-spots: the mass matrix
        and mu depend on them, or do not repeat with them, and are not certain for all values (section 5)."""
        if not spots:
            return {}, set()
        turns = ((self._state.index(word), period) for word, period in self._region.periods())
        one_period = {i for i, period in turns if not self._supposed.repeats(i, period)}
        free = self._whole.any_free()
        seen = self._supposed.components & set(free)
        everywhere = [
            self._supposed.checked(self._whole.state(dict(enumerate(map(ball, spot.system.point))), free))
            for spot in spots
            if seen
        ]
        shown = [found for found in everywhere if isinstance(found, Evidence)]
        if len(shown) == len(everywhere):
            self._account.stages += shown
            return {}, one_period
        mechanism, chosen = self._shifted.mechanism, self._whole.chosen_free()
        return {i: whole_component(mechanism, self._state[i], chosen[i]) for i in seen}, one_period

    def _sign_of_p(self) -> SignOfP | None:
        """That of p in every state of the region with y = 0; asked where there is no G-spot."""
        functions, size = self._apart.functions, len(self._state)
        used = components_of(functions["p"]) | (components_of(functions["y"]) if "y" in functions else frozenset())
        given = [name for name in functions if name not in ("p", "b") and components_of(functions[name]) <= used]
        supposed, known = self._supposed, [self._region.known_side(i) for i in range(size)]
        divided = {i for i in supposed.components if known[i] is not None}
        program = BoxProgram([functions[name] for name in ("p", *given)], size, sorted(used | divided))
        sides = [side for i in program.variables if (side := known[i]) is not None]
        turns = ((self._state.index(word), period) for word, period in self._region.periods())
        if len(sides) < len(program.variables) or not all(supposed.repeats(i, period) for i, period in turns):
            return None
        everywhere = {i: nonfinite() if side is None else side for i, side in enumerate(known)}

        def hypotheses(box: Box) -> Evidence | str:
            within = dict(zip(program.variables, box, strict=True))
            return supposed.checked(self._whole.state({**everywhere, **within}, {}))

        return sign_of_p(program, sides, hypotheses)

    def _full(self, values: Mapping[int, arb]) -> list[arb]:
        return [values.get(i, arb(0)) for i in range(len(self._state))]

    def _functions(self, stage: Stage) -> list[Expression]:
        return [self._apart.functions[name] for name in stage.conditions]

    def _solve(self, stage: Stage, partial: _Partial) -> list[_Partial]:
        if not stage.variables:
            return self._decide(stage, partial)
        closed = VelocityRoots.of(self._functions(stage), len(self._state), stage.variables)
        if closed is not None:
            return self._in_closed_form(closed, stage, partial)
        return self._by_boxes(stage, partial)

    def _decide(self, stage: Stage, partial: _Partial) -> list[_Partial]:
        """Conditions that hold no unknown any more."""
        values = BoxProgram(self._functions(stage), len(self._state), ()).values(self._full(partial.values))
        for value in values:
            if (away := differ(0, value)) is not None:
                self._account.extended([], away)
                return []
        names = ", ".join(stage.conditions)
        return [replace(partial, proved=False, why=f"{names} may vanish there, with no component left to solve it for")]

    def _in_closed_form(self, closed: VelocityRoots, stage: Stage, partial: _Partial) -> list[_Partial]:
        roots = closed.all_roots(self._full(partial.values))
        if roots.open is not None:
            if roots.near is None:
                return self._by_boxes(stage, partial)
            here = dict(zip(stage.variables, roots.near, strict=True))
            self._account.extended([roots.near], roots.shown)
            return [_Partial({**partial.values, **here}, False, partial.why or roots.open)]
        solved = []
        for point in roots.points:
            others = [other for other in roots.points if other is not point]

            def same(at: Sequence[arb], others: Sequence[Sequence[arb]] = others) -> Evidence | None:
                own = [at[i] for i in stage.variables]
                one = equal(len(others) + 1, len(roots.points))
                return every([one, *(_apart(own, other) for other in others)])

            values = {**partial.values, **dict(zip(stage.variables, point, strict=True))}
            solved.append(
                replace(partial, values=values, same=(*partial.same, same), shown=(*partial.shown, roots.shown))
            )
        self._account.extended(solved, roots.shown)
        return solved

    def _by_boxes(self, stage: Stage, partial: _Partial) -> list[_Partial]:
        program = BoxProgram(self._functions(stage), len(self._state), stage.variables)
        periods = [self._region.period(i) for i in stage.variables]
        search = ZeroSearch(program, self._full(partial.values), periods)
        zeros = search.run([self._region.side(i) for i in stage.variables], self._budget)
        solved = [self._one_zero(search, zero, stage, partial) for zero in zeros.zeros]
        left = zeros.left if zeros.stopped and self._budget.boxes <= 0 else clusters(zeros.left)
        for box in left:
            values = {**partial.values, **dict(zip(stage.variables, box, strict=True))}
            why = zeros.stopped or partial.why or _singular(self._functions(stage), stage, self._full(values))
            solved.append(_Partial(values, False, why))
        self._account.extended(solved, _all_of(zeros, left))
        return solved

    def _one_zero(self, search: ZeroSearch, zero: Zero, stage: Stage, partial: _Partial) -> _Partial:
        enclosure = search.sharpened(zero)

        def same(at: Sequence[arb]) -> Evidence | None:
            return search.same([at[i] for i in stage.variables], zero)

        moved = [self._region.within_one_period(i, side) for i, side in zip(stage.variables, enclosure, strict=True)]
        values = {**partial.values, **dict(zip(stage.variables, moved, strict=True))}
        return replace(partial, values=values, same=(*partial.same, same), shown=(*partial.shown, zero.evidence))

    def _finish(self, partial: _Partial, spots: list[GSpot], boundary: list[GSpot]) -> None:
        """Prove the solution as a zero of all conditions, and sort it: inside, perhaps inside, outside, or open."""
        position, beyond = self._region.position(self._whole.state(partial.values, self._whole.any_free()))
        if position == "outside":
            self._account.outside.append(beyond)
            return
        place = self._whole.state(partial.values, self._whole.chosen_free())
        values = dict(enumerate(place))
        if not partial.proved:
            self._leave(values, partial.why)
            return
        if position == "boundary" and self._whole.depends_on_free():
            self._leave(
                values, "a component with an interval depends on a free one: give that one an interval or fix it"
            )
            return
        try:
            spot = prove_near(self._shifted, self._start(place), self._bits + _EXTRA_BITS)
        except (GSpotError, MechanismError) as error:
            self._leave(values, str(error))
            return
        point = list(spot.system.point)
        stages = sum(1 for stage in self._apart.stages if stage.variables)
        same = every([equal(len(partial.same), stages), *(same(point) for same in partial.same)])
        if not all(x.overlaps(y) for x, y in zip(point, place, strict=True)) or same is None:
            self._leave(values, "its proof as a zero of all conditions together is of another point")
            return
        position, where = self._region.position(point)
        if position == "inside":
            spots.append(spot)
            self._account.inside.append(every([spot.shown, same, where]))
        elif position == "outside":
            self._account.outside.append(every([spot.shown, same, where]))
        elif position == "boundary":
            boundary.append(spot)

    def _start(self, place: Sequence[arb]) -> dict[str, arb]:
        """Where Newton's method starts: midpoints, but the whole balls of the components that are fixed at them."""
        fixed = self._shifted.mechanism.place.fixed or ()
        pairs = zip(self._state, place, strict=True)
        return {word: value if word in fixed else value.mid() for word, value in pairs}

    def _leave(self, values: Mapping[int, arb], why: str) -> None:
        words = {self._state[i]: in_words(self._shifted.mechanism, self._state[i], v) for i, v in values.items()}
        self._left.append(Left(tuple((word, words[word]) for word in self._state if word in words), why))

    def _with_more_freedom(self, partials: Sequence[_Partial], stages: Sequence[Stage]) -> GSpots:
        """Fewer conditions than unknowns: no G-spot, or a certified patch of the curve or surface that they form."""
        first = stages[0]
        program = BoxProgram(self._functions(first), len(self._state), first.variables)
        patch = None
        for partial in partials:
            search = ZeroSearch(program, self._full(partial.values), [self._region.period(i) for i in first.variables])
            share = Budget(min(self._budget.boxes, 2000))
            self._budget.boxes -= share.boxes
            zeros = search.run([self._region.side(i) for i in first.variables], share)
            self._account.extended(zeros.left, zeros.evidence)
            for box in zeros.left:
                values = {**partial.values, **dict(zip(first.variables, box, strict=True))}
                if patch is None and partial.proved:
                    patch = self._patch(stages, values, partial)
                if len(self._left) < 50 and patch is None:
                    self._leave(values, "no patch of G-spots could be proved, and their absence was not proved either")
        if patch is not None:
            self._left.clear()
        return self._result((), (), patch)

    def _patch(self, stages: Sequence[Stage], values: Mapping[int, arb], before: _Partial) -> Patch | None:
        """A patch over a solution of the stages before."""
        functions = [function for stage in stages for function in self._functions(stage)]
        variables = sorted({i for stage in stages for i in stage.variables})
        graph = find_patch(functions, variables, self._full(values))
        if graph is None:
            return None
        everywhere = {**values, **graph.parameters, **graph.box}
        _, inside_region = self._region.position(self._whole.state(everywhere, self._whole.any_free()))
        place = self._whole.state(everywhere, self._whole.chosen_free())
        try:
            with working_bits(64):
                definite = check_mass_matrix(self._shifted, dict(zip(self._state, place, strict=True)), BALLS)
        except MechanismError:
            return None
        alone = self._alone(before)
        if alone is None:
            return None
        box = {**alone, **graph.alone}
        as_written = [in_inner_interval(everywhere[i], side) for i, side in box.items()]
        shown = every([*before.shown, self._is(before, alone), graph.shown, *as_written, inside_region, definite])
        if shown is None:
            return None
        mechanism, state = self._shifted.mechanism, self._state

        def words(sides: Mapping[int, arb]) -> tuple[tuple[str, str], ...]:
            return tuple((state[i], in_words(mechanism, state[i], side, inner_text)) for i, side in sides.items())

        free = self._whole.chosen_free()
        return Patch(
            len(graph.parameters) + len(self._apart.free),
            words(graph.parameters),
            words(box),
            tuple((state[i], whole_component(mechanism, state[i], value)) for i, value in free.items()),
            shown,
        )

    def _alone(self, partial: _Partial) -> dict[int, arb] | None:
        """For each component that the stages before solved for an interval, to be written: the solution lies in all of
        them, and no other one does."""
        for exponent in _ROOM:
            room = {i: add_remainder(x, (1 + abs(x)) * arb((1, exponent))) for i, x in partial.values.items()}
            if self._is(partial, room) is not None:
                return room
        return None

    def _is(self, partial: _Partial, box: Mapping[int, arb]) -> Evidence | None:
        """That the only solution of the stages before in the box is this one."""
        return every([equal(len(partial.same), len(partial.shown)), *(same(self._full(box)) for same in partial.same)])


def _apart(left: Sequence[arb], right: Sequence[arb]) -> Evidence | None:
    """That two boxes do not meet."""
    return next((shown for x, y in zip(left, right, strict=True) if (shown := differ(x, y)) is not None), None)


def _all_of(zeros: Zeros, gathered: Sequence[Box]) -> Evidence | None:
    """That each zero is one of those that were found, which are different, or lies in a gathered box."""
    if zeros.stopped:
        return None
    within = (
        next((shown for box in gathered if (shown := every(map(inside, part, box))) is not None), None)
        for part in zeros.left
    )
    return every([zeros.evidence, *within])


def _singular(functions: Sequence[Expression], stage: Stage, state: Sequence[arb]) -> str:
    """What is known of a small box in which the stage could not be settled."""
    if len(functions) == len(stage.variables) == 1:
        slope = partial_derivative(functions[0], stage.variables[0], len(state))
        _, rows = BoxProgram([slope], len(state), stage.variables).gradients(state)
        if rows[0][0] > 0 or rows[0][0] < 0:
            return (
                f"a fold: two zeros of {stage.conditions[0]} meet here, or nearly meet, or there is none; "
                "there are at most two, as its second derivative keeps its sign"
            )
    names = ", ".join(stage.conditions)
    return f"singular, or nearly: zeros of {names} meet here, or nearly meet, or there is none"


def relevant_first(spots: Sequence[GSpot]) -> list[GSpot]:
    """Cases I, II and III with u > 0, the three Cases without, those of which the case is open, the others.

    Slip from p > 0 and b < 0 approaches in these Cases (paper, Sec. 1.2), and on a surface at rest it is u > 0. Within
    each of the four groups the order is kept.
    """
    return sorted(spots, key=_rank)


def _rank(spot: GSpot) -> tuple[bool, bool, bool]:
    found = classify_g_spot(spot)
    in_a_case = found.case in ("I", "II", "III")
    return not in_a_case, found.case == "none", in_a_case and sign_of_exact(found.slip_velocity) != 1
