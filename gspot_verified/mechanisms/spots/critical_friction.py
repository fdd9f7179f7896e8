"""The critical friction coefficient of a mechanism: below it p = C - mu B is positive wherever there is contact.

Proof page: ``proofs/critical_friction.md``.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, reduce
from typing import ClassVar

from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import partial_derivative, substitute
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.functions.periods import period_factor
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.mass_matrix import leading_minors
from gspot_verified.mechanisms.derive.to_system import Shifted, shift, stays
from gspot_verified.mechanisms.formulas.symbol import SLIP_SPEED
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.g_spot import DEFAULT_BITS, place_in, whole_component
from gspot_verified.mechanisms.spots.g_spot_list import in_words
from gspot_verified.mechanisms.spots.search_region import fixed_name
from gspot_verified.mechanisms.spots.sign_of_p import widest
from gspot_verified.mechanisms.spots.spot_conditions import components_of, take_apart
from gspot_verified.mechanisms.zeros.all_zeros import Box, Budget, ZeroSearch, halves
from gspot_verified.numbers.balls import ShownBall, ball_text, checked_bits, hull, nonfinite, working_bits
from gspot_verified.numbers.short_text import table_text
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written

_EVERYWHERE = "in every configuration in contact with a positive definite mass matrix"
_NOT_SHOWN = "the mass matrix was not shown to be positive definite everywhere in contact"
_NOT_DEFINITE = "the mass matrix is not certainly positive definite where B/C is largest"
DEFAULT_BUDGET = 20_000  # how many boxes are looked at: a limit against endless work
_MASS_BOXES = 2000  # boxes in which the mass matrix is looked at: a limit against endless work
_SHORT_BITS = 10  # relative: below that six digits are none, for the search ended early
_EXTRA_BITS = 40  # working bits beyond those asked for: any number is correct

Place = tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class CriticalFriction(NoTruthValue, Written):
    """The result of :func:`critical_friction`.

    For 0 <= mu < ``value``: p > 0 in every configuration with y = 0 in which the mass matrix is positive definite; at
    mu = ``value`` (a ball) p vanishes at one of ``places``. ``value`` is infinite when no mu >= 0 makes p vanish, and
    None when nothing was found; ``reason`` says why. ``friction`` is the mechanism's own mu, None when it varies.
    ``mass_matrix`` is empty when the mass matrix is positive definite in every configuration with y = 0; else it says
    that it is not, or that this was not shown. ``held`` are fixed components with the values for which all this holds.
    ``beyond_box``: it stands beside a search in a box, and is about all configurations none the less.
    """

    ask: ClassVar[str] = ".value is a ball, infinite, or None; .is_below is True, False or None"
    written: ClassVar[str] = "value=finite_value infinite places below=is_below reason mass_matrix held"

    name: str
    value: arb | None
    places: tuple[Place, ...]
    friction: arb | None
    reason: str = ""
    mass_matrix: str = ""
    held: Place = ()
    beyond_box: bool = False

    @property
    def infinite(self) -> bool:
        """Whether no friction makes p vanish."""
        return self.value is not None and not self.value.is_finite()

    @property
    def finite_value(self) -> ShownBall | None:
        """The value where it is finite."""
        return None if self.infinite else self.value

    @property
    def is_below(self) -> bool | None:
        """Whether the mechanism's friction coefficient is certainly below the critical one, or certainly above.

        None also for a negative coefficient: nothing is said of p there.
        """
        if self.value is None or self.friction is None or not self.friction >= 0:
            return None
        if self.friction < self.value:
            return True
        return False if self.friction > self.value else None

    def __str__(self) -> str:
        if self.value is None:
            return f"critical friction: not found: {self.reason}{self._conditions()}"
        if not self.value.is_finite():
            why = self.reason or f"for every mu >= 0 p > 0 {_EVERYWHERE}"
            return f"critical friction: infinite ({why}){self._conditions()}"
        places = "; ".join(", ".join(f"{word} = {text}" for word, text in place) for place in self.places)
        where = "at" if len(self.places) == 1 else "at one of these places, at least:"
        text = f"critical friction mu_c = {ball_text(self.value)}, attained {where} {places}"
        if self.is_below and self.friction is not None:
            text += f"\n  mu = {ball_text(self.friction)} lies below mu_c: p > 0 {_EVERYWHERE}"
        return text + self._conditions()

    def _conditions(self) -> str:
        """What is to be known of the configurations beside."""
        held = "with " + ", ".join(f"{word} = {value}" for word, value in self.held) + " fixed" if self.held else ""
        scope = "of all configurations, not of the box alone" if self.beyond_box and self.value is not None else ""
        return "".join(f"; {text}" for text in (scope, held, self.mass_matrix) if text)

    def in_short(self) -> str:
        """The same in one line, with six digits and without the places."""
        if self.value is None or not self.value.is_finite():
            return str(self)
        text = f"critical friction mu_c = {table_text(self.value)}"
        if self.value.rel_accuracy_bits() < _SHORT_BITS:
            text += " (found roughly; critical_friction takes longer and may say more)"
        if self.is_below:  # six digits of both would not show it
            text += f"; mu lies below it: p > 0 {_EVERYWHERE}"
        return text + self._conditions()


def critical_friction(mechanism: Mechanism, bits: int = DEFAULT_BITS, budget: int = DEFAULT_BUDGET) -> CriticalFriction:
    """The smallest constant mu >= 0 for which p = C - mu B vanishes in a configuration with y = 0.

    Found for mechanisms whose B, C and y depend on angles only, after a translation is eliminated by y = 0, and on
    components that are fixed in the mechanism's place: these keep their values there.

    :raises ValueError: ``bits`` is no int, or below 2.
    :raises MechanismError: the mechanism is not complete.

    >>> from gspot_verified import load
    >>> critical = critical_friction(load("genot_brogliato_rod"))
    >>> critical.value is not None and critical.value.overlaps(arb(4) / 3)
    True
    """
    bits = checked_bits(bits, 2)
    with working_bits(bits + _EXTRA_BITS):
        return critical_friction_of(shift(mechanism, slip_speed=True), Budget(budget))


def critical_friction_of(shifted: Shifted, budget: Budget) -> CriticalFriction:
    """The same, at the working precision in force."""
    return _Maximum(shifted).found(budget)


class _Maximum:
    """The largest value of B/C where y = 0."""

    def __init__(self, shifted: Shifted) -> None:
        functions = shifted.functions
        self._mechanism = shifted.mechanism
        self._constrained = bool(shifted.constraints)
        self._size = len(self._mechanism.state)
        speed = {SLIP_SPEED: Variable(self._size)}  # a component on which the friction coefficient may depend
        entries = [entry for row in functions.inertia for entry in row]
        parts = [functions.B, functions.C, functions.y, functions.mu, *entries]
        B, C, self._y, self._mu, *entries = shifted.expressions(parts, BALLS, speed)
        values = self._solved_for()
        fixed = self._fixed(shifted, [substitute(f, values) for f in (B / C, self._y)])
        if fixed:
            values = self._solved_for(fixed)
        self.held = tuple(
            (word, whole_component(self._mechanism, word, given))
            for word, given in place_in(shifted, BALLS).items()
            if self._mechanism.state.index(word) in fixed
        )
        self._ratio, constraint = substitute(B / C, values), substitute(self._y, values)
        self._mass_matrix = [substitute(entry, values) for entry in entries]
        self._mass_size = len(functions.inertia)
        solved = self._y_is_solved
        self._constraint = None if solved else constraint
        self._all = [self._ratio] if self._constraint is None else [self._ratio, self._constraint]
        depends = BoxProgram(self._all, self._size, ()).depends
        self._variables = sorted(frozenset[int]().union(*depends))

    def _solved_for(self, fixed: Mapping[int, Expression] | None = None) -> list[Expression]:
        """The components, those that are fixed or that y = 0 gives as functions of the others."""
        conditions = {fixed_name(self._mechanism.state[i]): function for i, function in (fixed or {}).items()}
        apart = take_apart({"y": self._y, **conditions}, self._size)
        self._y_is_solved = "y" not in apart.functions
        values: list[Expression] = [Variable(i) for i in range(self._size)]
        for each in apart.explicit:
            values[each.index] = each.value
        return values

    def _fixed(self, shifted: Shifted, functions: Sequence[Expression]) -> dict[int, Expression]:
        """Of the components that are fixed in the mechanism's place those in which a function is not periodic."""
        given, fixed = place_in(shifted, BALLS), {}
        for word in self._mechanism.place.fixed or ():
            i = self._mechanism.state.index(word)
            used = any(i in components_of(function) for function in functions)
            if used and word in given and period_factor(functions, i) is None:
                fixed[i] = stays(i, given[word], BALLS)
        return fixed

    @cached_property
    def _friction(self) -> arb | None:
        program = BoxProgram([self._mu], self._size + 1, ())
        return None if program.depends[0] else program.values([arb(0)] * (self._size + 1))[0]

    def found(self, budget: Budget) -> CriticalFriction:
        """The critical friction, with what is known of the mass matrix in contact and of fixed components."""
        if refused := self._refused():
            return self._result(None, (), refused)
        found = self._searched(budget)
        if found.infinite and found.reason:
            return replace(found, held=self.held)
        mass = self._mass_matrix_in_contact()
        return replace(found, mass_matrix="" if found.value is None and mass == _NOT_SHOWN else mass, held=self.held)

    def _refused(self) -> str:
        """Why nothing is searched; empty where it is."""
        if self._constrained:
            return "the mechanism has constraints with multipliers"
        words = [self._mechanism.state[i] for i in self._variables if period_factor(self._all, i) is None]
        return f"B, C and y are not periodic in {', '.join(words)}" if words else ""

    def _searched(self, budget: Budget) -> CriticalFriction:
        """Search for the places where B/C is stationary; the largest of its values there is the maximum."""
        periods = [period_factor(self._all, i) for i in self._variables]
        objective = BoxProgram([self._ratio], self._size, self._variables)
        state = [arb(0)] * self._size
        if self._constraint is not None and not components_of(self._constraint):
            (height,) = BoxProgram([self._constraint], self._size, ()).values(state)
            if height > 0 or height < 0:
                return self._result(arb.pos_inf(), (), "no configuration has y = 0")
            return self._result(None, (), "y = 0 holds no component that is not fixed")
        if not self._variables:
            here = self._is_definite(())
            return self._from(objective.values(state)[0], [()]) if here else self._result(None, (), _NOT_DEFINITE)
        program = BoxProgram(self._stationary(), self._size, self._variables)
        lengths = [2 * arb.pi() * arb(factor) for factor in periods if factor is not None]
        search = ZeroSearch(program, state, lengths, objective)
        zeros = search.run([arb(0, (length / 2).upper()) for length in lengths], budget)
        boxes: list[Box] = [search.sharpened(zero) for zero in zeros.zeros]
        candidates = [(objective.mean_values(search.state(box))[0], box) for box in [*boxes, *zeros.left]]
        if not candidates:
            return self._result(arb.pos_inf(), (), "no configuration has y = 0")
        if not all(value.is_finite() for value, _ in candidates):
            return self._result(None, (), zeros.stopped or "B/C is not bounded on a box that is left: C may vanish")
        if not boxes:
            return self._result(None, (), "no configuration in contact was proved: " + (zeros.stopped or "singular"))
        definite = [value for value, box in candidates[: len(boxes)] if self._is_definite(box)]
        if not definite:
            return self._result(None, (), _NOT_DEFINITE)
        lower, reached = (
            reduce(arb.max, ends) for ends in zip(*((v.lower(), v.upper()) for v in definite), strict=True)
        )
        upper = reduce(arb.max, [value.upper() for value, _ in candidates])
        highest = [(value, box, self._is_definite(box)) for value, box in candidates if value.upper() >= lower]
        if any(value.lower() > reached for value, _, certain in highest if not certain):
            return self._result(None, (), _NOT_DEFINITE)
        return self._from(hull([lower, upper]), [box for _, box, certain in highest if certain])

    def _stationary(self) -> list[Expression]:
        """What vanishes at every place where B/C is largest: its gradient; with a constraint the minors with it."""
        slopes = [partial_derivative(self._ratio, i, self._size) for i in self._variables]
        if self._constraint is None:
            return slopes
        normal = [partial_derivative(self._constraint, i, self._size) for i in self._variables]
        minors = [g * normal[-1] - slopes[-1] * n for g, n in zip(slopes[:-1], normal[:-1], strict=True)]
        return [self._constraint, *minors]

    def _from(self, largest: arb, boxes: list[Box]) -> CriticalFriction:
        if largest <= 0:
            return self._result(arb.pos_inf(), (), "")
        if not largest > 0:
            return self._result(None, (), "B may vanish where B/C is largest")
        places = tuple(
            tuple(
                (self._mechanism.state[i], in_words(self._mechanism, self._mechanism.state[i], side))
                for i, side in zip(self._variables, box, strict=True)
            )
            for box in boxes
        )
        return self._result(1 / largest, places, "")

    @cached_property
    def _mass(self) -> tuple[BoxProgram, list[arb]]:
        """The entries of the mass matrix and y, by all angles on which they depend, and one period of each angle."""
        functions = [*self._mass_matrix, *([] if self._constraint is None else [self._constraint])]
        used = sorted({i for function in functions for i in components_of(function)})
        factors = {i: period_factor(functions, i) for i in used}
        variables = [i for i in used if factors[i] is not None]
        sides = [arb(0, (arb.pi() * arb(factor)).upper()) for i in variables if (factor := factors[i]) is not None]
        return BoxProgram(functions, self._size, variables), sides

    def _minors(self, state: Sequence[arb]) -> list[arb]:
        n = self._mass_size
        entries = self._mass[0].mean_values(state)
        return list(leading_minors([entries[i * n : (i + 1) * n] for i in range(n)]))

    def _mass_state(self, sides: Mapping[int, arb]) -> list[arb]:
        """The state with these sides, one period of other angles, and nothing known of the rest."""
        program, whole = self._mass
        everywhere = dict(zip(program.variables, whole, strict=True)) | dict(sides)
        return [everywhere.get(i, nonfinite()) for i in range(self._size)]

    def _is_definite(self, box: Box) -> bool:
        """Whether the mass matrix is positive definite on the box, and so C > 0."""
        state = self._mass_state(dict(zip(self._variables, box, strict=True)))
        return all(minor > 0 for minor in self._minors(state))

    def _mass_matrix_in_contact(self) -> str:
        """Empty if the mass matrix is positive definite wherever y = 0; else a place where it is not, or that this
        was not shown."""
        program, whole = self._mass
        waiting: deque[Box] = deque([tuple(whole)])
        for _ in range(_MASS_BOXES):
            if not waiting:
                return ""
            box = waiting.popleft()
            state = self._mass_state(dict(zip(program.variables, box, strict=True)))
            if self._constraint is not None and not program.mean_values(state)[-1].contains(0):
                continue
            minors = self._minors(state)
            if all(minor > 0 for minor in minors):
                continue
            if any(minor < 0 for minor in minors) and self._is_in_contact(box):
                return f"the mass matrix is not positive definite {self._in_words(box)}"
            if not box:
                break
            waiting += halves(box, widest(box))
        return _NOT_SHOWN

    def _is_in_contact(self, box: Box) -> bool:
        """Whether y = 0 somewhere in the box: y is continuous there and has both signs."""
        if self._constraint is None:
            return True
        program, _ = self._mass
        if not program.values(self._mass_state(dict(zip(program.variables, box, strict=True))))[-1].is_finite():
            return False
        middle = [side.mid() for side in box]
        steps = [middle, *([*middle[:i], middle[i] + sign * box[i].rad() / 2, *middle[i + 1 :]]
                           for i in range(len(box)) for sign in (1, -1))]  # fmt: skip
        heights = [program.values(self._mass_state(dict(zip(program.variables, at, strict=True))))[-1] for at in steps]
        return any(y > 0 for y in heights) and any(y < 0 for y in heights)

    def _in_words(self, box: Box) -> str:
        if not box:
            return "in any configuration"
        pairs = zip(self._mass[0].variables, box, strict=True)
        sides = ", ".join(f"{word} = {in_words(self._mechanism, word, side)}" for i, side in pairs
                          for word in [self._mechanism.state[i]])  # fmt: skip
        return f"everywhere in contact: not somewhere at {sides}"

    def _result(self, value: arb | None, places: tuple[Place, ...], reason: str) -> CriticalFriction:
        return CriticalFriction(self._mechanism.name, value, places, self._friction, reason)
