"""The equations of a contact phase as functions of the force: what the theorems on growing force speak of.

Proof page: ``proofs/invariant_region.md``, section 1.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import ONE, ZERO, lie_derivative, partial_derivative, rewritten, substitute
from gspot_verified.functions.expressions import Constant, Expression, Product, Sum, Variable, in_order
from gspot_verified.functions.straight_line import StraightLine
from gspot_verified.scenes.equations.scaled_system import ScaledSystem
from gspot_verified.scenes.equations.terms import FLIGHT


class NotOfThisForm(ValueError):
    """The equations are not of the form that the theorems on growing force cover: no impact is shown by them."""


@dataclass(frozen=True)
class ContactBounds:
    """Enclosures over a box of states, clock and force λ: F = dV/dT and H, each at λ = 0 and its derivative by λ; the
    same for the rates of the other states and of the functions at whose zeros the phase stops (lift-off left out).
    """

    still: arb
    slope: arb
    constant: arb
    factor: arb
    rates: tuple[arb, ...]
    pushes: tuple[arb, ...]
    stops: tuple[arb, ...]
    stop_rates: tuple[arb, ...]
    stop_pushes: tuple[arb, ...]

    def are_finite(self) -> bool:
        """Whether all of them are; the functions at whose zeros the phase stops need not be."""
        needed = (self.still, self.slope, self.constant, self.factor, *self.rates, *self.pushes)
        return all(value.is_finite() for value in needed)


class ContactForm:
    """The structure of one phase in contact, read off its equations and checked.

    The contact must be Y' = V, Z' = -kappa Z - gamma lambda, lambda = k (Z - Y) with constants, and every other rate a
    function of lambda and of the states without Z. ``slow``: the components other than Y, V, Z.

    :raises NotOfThisForm: the equations are not of this form.
    """

    def __init__(self, system: ScaledSystem) -> None:
        self.names = system.states
        size = self.size = len(self.names)
        self.Y, self.V, self.Z = Y, V, Z = tuple(self.names.index(name) for name in "YVZ")
        self.slow = [i for i in range(size) if i not in (Y, V, Z)]
        force = system.shown("lambda_N")
        slopes = [_constant(partial_derivative(force, i, size + 1)) for i in range(size + 1)]
        closing = [_constant(partial_derivative(system.right_hand_side[Z], i, size + 1)) for i in range(size + 1)]
        self.k = slopes[Z]
        if not (self.k > 0 and slopes == _at(size + 1, {Z: self.k, Y: -self.k}) and _at_zero(force, size) == 0):
            raise NotOfThisForm("the force is not of the form that the invariant region covers")
        # Z' = -κZ - γk (Z - Y)
        self.gamma = closing[Y] / self.k
        self.kappa = -closing[Z] - closing[Y]
        sound = (
            self.kappa > 0
            and self.gamma > 0
            and closing == _at(size + 1, {Z: closing[Z], Y: closing[Y]})
            and _at_zero(system.right_hand_side[Z], size) == 0
            and system.right_hand_side[Y] == Variable(V)
        )
        stops = [event.function for event in system.events if event.next_phase != FLIGHT]
        roots = [rate for i, rate in enumerate(system.right_hand_side) if i != Z] + stops
        table = _with_force(roots, Y, Z, self.k, size + 1)
        if not sound or any(Z in _variables(table[root]) for root in roots):
            raise NotOfThisForm("the contact is not of the form that the invariant region covers")
        rates = [ZERO if i == Z else table[rate] for i, rate in enumerate(system.right_hand_side)]
        self._compile(rates, [table[stop] for stop in stops])

    @property
    def s(self) -> fmpq:
        """κ + γk: the decay of D = λ' by itself."""
        return self.kappa + self.gamma * self.k

    def _compile(self, rates: list[Expression], stops: list[Expression]) -> None:
        size = self.size
        flow = [*rates, ONE, ZERO]
        acceleration = rates[self.V]
        load = lie_derivative(acceleration, flow)
        along = [lie_derivative(stop, flow) for stop in stops]
        by_force = [acceleration, load, *(rates[i] for i in self.slow), *along]
        without = [*(Variable(i) for i in range(size + 1)), ZERO]
        stills = [substitute(function, without) for function in by_force]
        pushes = [partial_derivative(function, size + 1, size + 2) for function in by_force]
        self._count = len(self.slow), len(stops)
        self._program = BoxProgram([*stills, *pushes, *stops], size + 2)
        self._acceleration = BoxProgram([acceleration], size + 2)
        self.affine = all(size + 1 not in used for used in self._program.depends[len(stills) : 2 * len(stills)])
        """Whether all these functions are seen to be affine in λ: then the enclosures do not depend on its range."""
        self.constant_load = self._has_constant_load(pushes[0], flow, stills[1], pushes[1])

    def _has_constant_load(
        self, slope: Expression, flow: Sequence[Expression], still: Expression, push: Expression
    ) -> bool:
        """Whether q = -∂F/∂λ rises at a constant rate >= 0, and H is a constant plus a constant times λ.

        ``flow`` lets λ stand still: q must not depend on λ.
        """
        drift = _rational(lie_derivative(slope, flow))
        rises = self.affine and drift is not None and bool(drift <= 0)
        return rises and None not in (_rational(still), _rational(push))

    def acceleration(self, box: Sequence[arb]) -> arb:
        """F on a box of states, clock and λ."""
        return self._acceleration.values(box)[0]

    def bounds(self, box: Sequence[arb]) -> ContactBounds:
        """Enclosures on a box of states, clock and λ."""
        values = self._program.mean_values(box)
        slow, stops = self._count
        half = 2 + slow + stops
        still, push = values[:half], values[half : 2 * half]
        return ContactBounds(
            still=still[0],
            slope=push[0],
            constant=still[1],
            factor=push[1],
            rates=tuple(still[2 : 2 + slow]),
            pushes=tuple(push[2 : 2 + slow]),
            stops=tuple(values[2 * half :]),
            stop_rates=tuple(still[2 + slow :]),
            stop_pushes=tuple(push[2 + slow :]),
        )


def _with_force(roots: Sequence[Expression], Y: int, Z: int, k: fmpq, contact: int) -> dict[Expression, Expression]:
    """All nodes with the multiple of ``Variable(contact)`` in the place of each multiple of Z - Y."""

    def rule(node: Expression) -> Expression | None:
        if not (isinstance(node, Sum) and len(node.terms) == 2):
            return None
        factors = dict(map(_multiple, node.terms))
        if set(factors) != {Y, Z} or factors[Y] != -factors[Z]:
            return None
        factor = factors[Z] / k
        return Variable(contact) if factor == 1 else Product(Constant(factor), Variable(contact))

    return rewritten(roots, rule)


def _multiple(term: Expression) -> tuple[int, fmpq]:
    """The index and the factor of a rational multiple of a component; -1 for what is none."""
    if isinstance(term, Variable):
        return term.index, fmpq(1)
    match term:
        case Product(Constant(fmpq() as factor), Variable(index)):
            return index, factor
    return -1, fmpq(0)


def _at(size: int, values: dict[int, fmpq]) -> list[fmpq]:
    return [values.get(i, fmpq(0)) for i in range(size)]


def _variables(expression: Expression) -> set[int]:
    return {node.index for node in in_order([expression]) if isinstance(node, Variable)}


def _at_zero(expression: Expression, size: int) -> fmpq:
    return _constant(substitute(expression, [ZERO] * (size + 2)))


def _constant(expression: Expression) -> fmpq:
    """The rational that an expression is.

    :raises NotOfThisForm: it is not seen to be one.
    """
    value = _rational(expression)
    if value is None:
        raise NotOfThisForm("a coefficient of the contact is not a constant")
    return value


def _rational(expression: Expression) -> fmpq | None:
    """The rational that an expression is seen to be; None: it is not."""
    code = StraightLine()
    return code.number(code.value(expression))
