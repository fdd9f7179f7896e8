"""The critical friction coefficient of a mechanism: below it p = C - mu B is positive wherever there is contact.

Proof page: ``proofs/critical_friction.md``.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, reduce
from typing import ClassVar

from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import partial_derivative, substitute
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.functions.periods import period_factor
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.to_system import Shifted, shift
from gspot_verified.mechanisms.formulas.symbol import SLIP_SPEED
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.g_spot import DEFAULT_BITS
from gspot_verified.mechanisms.spots.g_spot_list import in_words
from gspot_verified.mechanisms.spots.spot_conditions import take_apart
from gspot_verified.mechanisms.zeros.all_zeros import Box, Budget, ZeroSearch
from gspot_verified.numbers.balls import ShownBall, ball_text, hull, working_bits
from gspot_verified.numbers.short_text import table_text
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written

_EVERYWHERE = "in every configuration in contact with a positive definite mass matrix"
DEFAULT_BUDGET = 20_000  # how many boxes are looked at: a limit against endless work
_EXTRA_BITS = 40  # working bits beyond those asked for: any number is correct

Place = tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class CriticalFriction(NoTruthValue, Written):
    """The result of :func:`critical_friction`.

    For 0 <= mu < ``value``: p > 0 in every configuration with y = 0 in which the mass matrix is positive definite; at
    mu = ``value`` (a ball) p vanishes at one of ``places``. ``value`` is infinite when no friction makes p vanish, and
    None when nothing was found; ``reason`` says why. ``friction`` is the mechanism's own mu, None when it varies.
    """

    ask: ClassVar[str] = ".value is a ball, infinite, or None; .is_below is True, False or None"
    written: ClassVar[str] = "value=finite_value infinite places below=is_below reason"

    name: str
    value: arb | None
    places: tuple[Place, ...]
    friction: arb | None
    reason: str = ""

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
            return f"critical friction: not found: {self.reason}"
        if not self.value.is_finite():
            why = self.reason or f"for every mu p > 0 {_EVERYWHERE}"
            return f"critical friction: infinite ({why})"
        places = "; ".join(", ".join(f"{word} = {text}" for word, text in place) for place in self.places)
        text = f"critical friction mu_c = {ball_text(self.value)}, attained at {places}"
        if self.is_below and self.friction is not None:
            text += f"\n  mu = {ball_text(self.friction)} lies below mu_c: p > 0 {_EVERYWHERE}"
        return text

    def in_short(self) -> str:
        """The same in one line, with six digits and without the places."""
        if self.value is None or not self.value.is_finite():
            return str(self)
        text = f"critical friction mu_c = {table_text(self.value)}"
        if self.is_below and self.friction is not None:
            text += f"; mu = {table_text(self.friction)} lies below it: p > 0 {_EVERYWHERE}"
        return text


def critical_friction(mechanism: Mechanism, bits: int = DEFAULT_BITS, budget: int = DEFAULT_BUDGET) -> CriticalFriction:
    """The smallest constant mu >= 0 for which p = C - mu B vanishes in a configuration with y = 0.

    Found for mechanisms whose B, C and y depend on angles only, after a translation is eliminated by y = 0.

    :raises MechanismError: the mechanism is not complete.

    >>> from gspot_verified import load
    >>> critical = critical_friction(load("genot_brogliato_rod"))
    >>> critical.value is not None and critical.value.overlaps(arb(4) / 3)
    True
    """
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
        parts = [functions.B, functions.C, functions.y, functions.mu]
        B, C, self._y, self._mu = shifted.expressions(parts, BALLS, speed)
        apart = take_apart({"y": self._y}, self._size)
        values: list[Expression] = [Variable(i) for i in range(self._size)]
        for each in apart.explicit:
            values[each.index] = each.value
        self._C, self._ratio = substitute(C, values), substitute(B / C, values)
        self._constraint = apart.functions.get("y")
        self._all = [self._ratio] if self._constraint is None else [self._ratio, self._constraint]
        depends = BoxProgram(self._all, self._size, ()).depends
        self._variables = sorted(frozenset[int]().union(*depends))

    @cached_property
    def _friction(self) -> arb | None:
        program = BoxProgram([self._mu], self._size + 1, ())
        return None if program.depends[0] else program.values([arb(0)] * (self._size + 1))[0]

    def found(self, budget: Budget) -> CriticalFriction:
        """Search for the places where B/C is stationary; the largest of its values there is the maximum."""
        if self._constrained:
            return self._result(None, (), "the mechanism has constraints with multipliers")
        periods = [period_factor(self._all, i) for i in self._variables]
        if any(factor is None for factor in periods):
            words = [self._mechanism.state[i] for i, r in zip(self._variables, periods, strict=True) if r is None]
            return self._result(None, (), f"B, C and y are not periodic in {', '.join(words)}")
        objective = BoxProgram([self._ratio], self._size, self._variables)
        state = [arb(0)] * self._size
        if not self._variables:
            return self._from(objective.values(state)[0], [()])
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
        lower = reduce(arb.max, [value.lower() for value, _ in candidates[: len(boxes)]])
        upper = reduce(arb.max, [value.upper() for value, _ in candidates])
        attained = [box for value, box in candidates if value.upper() >= lower]
        return self._from(hull([lower, upper]), attained)

    def _stationary(self) -> list[Expression]:
        """What vanishes at every place where B/C is largest: its gradient; with a constraint the minors with it."""
        slopes = [partial_derivative(self._ratio, i, self._size) for i in self._variables]
        if self._constraint is None:
            return slopes
        normal = [partial_derivative(self._constraint, i, self._size) for i in self._variables]
        minors = [g * normal[-1] - slopes[-1] * n for g, n in zip(slopes[:-1], normal[:-1], strict=True)]
        return [self._constraint, *minors]

    def _from(self, largest: arb, boxes: list[Box]) -> CriticalFriction:
        if not self._positive_definite_at(boxes):
            return self._result(
                None, (), "C is not positive where B/C is largest: the mass matrix is not definite there"
            )
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

    def _positive_definite_at(self, boxes: list[Box]) -> bool:
        """Whether C > 0 on the boxes, as it is where the mass matrix is positive definite.

        C has no zero on a box with a finite enclosure of B/C: its sign at the midpoint is that on the box.
        """
        program = BoxProgram([self._C], self._size, ())
        for box in boxes:
            state = [arb(0)] * self._size
            for i, side in zip(self._variables, box, strict=True):
                state[i] = side.mid()
            if not program.values(state)[0] > 0:
                return False
        return True

    def _result(self, value: arb | None, places: tuple[Place, ...], reason: str) -> CriticalFriction:
        return CriticalFriction(self._mechanism.name, value, places, self._friction, reason)
