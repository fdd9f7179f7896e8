"""A set of states in contact from which lambda_N grows for as long as the scene slips: an impact without collision.

Proof page: ``proofs/invariant_region.md``, Theorems R1 to R3.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.balls import add_remainder, approximate
from gspot_verified.expansion.box_program import BoxProgram
from gspot_verified.expansion.derivative import ONE, ZERO, lie_derivative, partial_derivative, rewritten, substitute
from gspot_verified.expansion.expressions import Expression, Variable, in_order
from gspot_verified.expansion.straight_line import StraightLine
from gspot_verified.scenes.scaled_system import ScaledSystem

CLOCK = "T"
_TRIES = 12
_DOUBLINGS = (40, 30, 24, 20, 16, 13, 10, 8, 6, 4, 3)
_ROUNDS = 6


@dataclass(frozen=True)
class Growth:
    """From the state on lambda_N > 0 grows at least like e^(rate T), T = t/epsilon, as long as the scene slips; and
    until it exceeds ``until`` times its value at the beginning (None: for ever)."""

    rate: arb
    until: int | None


class InvariantRegion:
    """The growth cone of one phase in contact. Its structure is read off the equations, and checked.

    The contact must be Y' = V, Z' = -kappa Z - gamma lambda, lambda = k (Z - Y) with constants, and no other rate may
    depend on Z except through lambda.

    :raises ValueError: the equations are not of this form.
    """

    def __init__(self, system: ScaledSystem) -> None:
        self.names = system.states
        size = len(self.names)
        self._size, force = size, system.shown("lambda_N")
        Y, V, Z = (self.names.index(name) for name in "YVZ")
        contact = Variable(size + 1)
        table = rewritten(system.right_hand_side, lambda node: contact if node is force else None)
        rates = [table[rate] for rate in system.right_hand_side]
        self._k = _constant(partial_derivative(force, Z, size + 2))
        self._kappa = -_constant(partial_derivative(rates[Z], Z, size + 2))
        self._gamma = -_constant(partial_derivative(rates[Z], size + 1, size + 2))
        sound = (
            _constant(partial_derivative(force, Y, size + 2)) == -self._k
            and _variables(force) == {Y, Z}
            and _at_zero(force, size) == 0
            and rates[Y] == Variable(V)
            and _variables(rates[Z]) <= {Z, size + 1}
            and _at_zero(rates[Z], size) == 0
            and all(Z not in _variables(rate) for i, rate in enumerate(rates) if i != Z)
            and self._k > 0
            and self._kappa > 0
            and self._gamma > 0
        )
        if not sound:
            raise ValueError("the contact is not of the form that the invariant region covers")
        acceleration = rates[V]
        slope = partial_derivative(acceleration, size + 1, size + 2)
        flow = [*rates, ONE, ZERO]
        flow[Z] = ZERO  # the acceleration does not depend on Z
        rest = lie_derivative(acceleration, flow)
        without = [*(Variable(i) for i in range(size + 1)), ZERO]
        self._slow = [i for i in range(size) if i not in (Y, V, Z)]
        self._program = BoxProgram(
            [
                acceleration,
                slope,
                substitute(rest, without),
                partial_derivative(rest, size + 1, size + 2),
                *(substitute(rates[i], without) for i in self._slow),
                *(partial_derivative(rates[i], size + 1, size + 2) for i in self._slow),
            ],
            size + 2,
        )
        self._for_ever = self._constants_for_ever(slope, rest, flow, without)

    def _constants_for_ever(
        self, slope: Expression, rest: Expression, flow: list[Expression], without: list[Expression]
    ) -> bool:
        """Whether q never decreases and H is a constant plus a constant times lambda (Theorem R2)."""
        try:
            drift = _constant(lie_derivative(slope, flow))
            _constant(substitute(rest, without))
            _constant(partial_derivative(rest, self._size + 1, self._size + 2))
        except ValueError:
            return False
        return bool(drift <= 0)

    def growth(self, state: Mapping[str, arb]) -> Growth | None:
        """What is certain of all states in the ball; None: nothing was shown."""
        box = [state[name] for name in self.names]
        Y, V, Z = (state[name] for name in "YVZ")
        force = self._k * (Z - Y)
        box += [state.get(CLOCK, arb(0)), force]
        acceleration, slope = self._program.values(box)[:2]
        if not (slope < 0 and force > 0 and V <= 0 and acceleration <= 0):
            return None
        rate_of_force = -(self._kappa + self._gamma * self._k) * force - self._kappa * self._k * Y - self._k * V
        S = -self._kappa * V - acceleration
        for i in range(_TRIES):
            a = arb(approximate(-slope) / 2 ** (1 + i / 2))
            inside = rate_of_force >= a * force and self._k * S >= a * (self._total + a) * force
            if not inside:
                continue
            if self._for_ever:
                constant, factor = self._program.values(box)[2:4]
                if self._holds(a, slope, constant, factor, force):
                    return Growth(a, None)
                continue
            for doublings in _DOUBLINGS:
                if self._holds_until(a, box, 2**doublings):
                    return Growth(a, 2**doublings)
        return None

    @property
    def _total(self) -> fmpq:
        return self._kappa + self._gamma * self._k

    def _holds(self, a: arb, slope: arb, constant: arb, factor: arb, force: arb) -> bool:
        """The inequality of Theorem R1 between a, q = -p and kappa."""
        load = (factor + constant.max(arb(0)) / force).max(arb(0))
        return bool(-self._k * slope >= a * (self._total + a) + self._k * load / a)

    def _holds_until(self, a: arb, box: list[arb], times: int) -> bool:
        """Theorem R3: a box of slow states that is not left before lambda has grown so many times."""
        names = self.names
        Y, V = names.index("Y"), names.index("V")
        force = box[-1]
        largest = arb((times * force).upper())
        time = (arb(times).log() / a).upper()
        tried = list(box)
        tried[-2] = box[-2] + _from_zero(time)
        tried[-1] = _from_zero(largest)
        for _ in range(_ROUNDS):
            values = self._program.values(tried)
            if not all(value.is_finite() for value in values):
                return False
            slope, constant, factor = values[1:4]
            count = len(self._slow)
            needed = list(tried)
            for i, still, pushed in zip(self._slow, values[4 : 4 + count], values[4 + count :], strict=True):
                needed[i] = add_remainder(box[i], (abs(still) * time + abs(pushed) * largest / a).upper())
            push = (abs(slope) + abs(factor) / a) * largest + abs(constant) * time
            start = self._program.values(box)[0]
            speed = (-box[V] + (abs(start) + push) * time).upper()
            needed[V] = -_from_zero(speed)
            needed[Y] = box[Y] - _from_zero((speed * time).upper())
            if all(_within(new, old) for new, old in zip(needed[:-2], tried[:-2], strict=True)):
                return bool(slope < 0) and self._holds(a, slope, constant, factor, force)
            tried[:-2] = [new + (new - new.mid()) / 4 for new in needed[:-2]]
        return False


def _from_zero(end: arb) -> arb:
    """The numbers from 0 to ``end``."""
    return arb(0).union(end)


def _within(inner: arb, outer: arb) -> bool:
    return bool(outer.contains(inner))


def _variables(expression: Expression) -> set[int]:
    return {node.index for node in in_order([expression]) if isinstance(node, Variable)}


def _at_zero(expression: Expression, size: int) -> fmpq:
    return _constant(substitute(expression, [ZERO] * (size + 2)))


def _constant(expression: Expression) -> fmpq:
    """The rational that an expression is.

    :raises ValueError: it is not seen to be one.
    """
    code = StraightLine()
    found = code.number(code.value(expression))
    if found is None:
        raise ValueError("not a constant")
    return found
