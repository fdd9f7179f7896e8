"""From a mechanism to the :class:`expansion.series.system.System` that Theorem 1 works on.

The functions are derived once, with the parameters put in and the angles shifted (:mod:`shift`). For a ring the numbers
that have a name get their value: a rational point has exact rational power series, elsewhere the same code runs in
balls, and parameters without a value become symbols of the ring.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from flint import arb

from gspot_verified.expansion.series.system import System
from gspot_verified.functions.derivative import powers_as_products, rewritten
from gspot_verified.functions.expressions import Constant, Expression, Sum, Variable
from gspot_verified.functions.rings import BALLS, Ring
from gspot_verified.functions.symbols import Symbols
from gspot_verified.mechanisms.derive.derivation import derive_expressions
from gspot_verified.mechanisms.derive.derived import Derived
from gspot_verified.mechanisms.derive.lagrangian_character import check_lagrangian_character
from gspot_verified.mechanisms.derive.shift import Preparation
from gspot_verified.mechanisms.formulas.rewriting import along
from gspot_verified.mechanisms.formulas.symbol import PI, Symbol
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism, MechanismError, ReferenceAngle


class NotRationalError(MechanismError):
    """A number that the mechanism needs is not rational: use balls."""


@dataclass(frozen=True)
class Shifted:
    """A mechanism's functions with the parameters put in and every angle counted from its reference.

    ``functions`` are expressions of the shifted state in which symbols may be left: bare reference angles, pi, and the
    parameters without a value.
    """

    mechanism: Mechanism
    functions: Derived[Expression]
    prepare: Preparation = field(repr=False, compare=False)

    @property
    def constraints(self) -> tuple[Expression, ...]:
        """The constraints and their rates: functions of the shifted state that vanish along every motion."""
        motion = self.mechanism.motion
        if not isinstance(motion, Lagrangian):
            return ()
        found = self.prepare(motion.constraints)
        return (*found, *(along(self.functions.F, constraint) for constraint in found))

    def expressions(
        self, functions: Sequence[Expression], ring: Ring, symbols: Mapping[str, Expression] | None = None
    ) -> list[Expression]:
        """The functions with a value of the ring for every symbol; shared parts stay shared.

        ``symbols`` gives values to some parameters that have none, for example a further ``Variable``.

        :raises NotRationalError: an angle itself, or pi, is needed in exact arithmetic.
        :raises MechanismError: a parameter has no value.
        """
        known = dict(symbols or {})

        def value(node: Expression) -> Expression | None:
            if not isinstance(node, Symbol):
                return None
            if node.name not in known:
                known[node.name] = self._number(node.name, ring)
            return known[node.name]

        named = rewritten(functions, value)
        products = powers_as_products([named[function] for function in functions])
        return [products[named[function]] for function in functions]

    def _number(self, name: str, ring: Ring) -> Expression:
        angle = next((angle for angle in self.mechanism.angles if angle.name == name), None)
        if angle is None and name != PI:
            if isinstance(ring, Symbols) and name in dict(self.mechanism.parameters):
                return Constant(ring.symbol(name))
            raise MechanismError(f"{self.mechanism.name}: {name} has no value")
        if ring is not BALLS:
            raise NotRationalError(
                f"{self.mechanism.name}: {name} stands outside a sine or cosine and does not cancel: not rational"
            )
        return Constant(arb.pi() if angle is None else angle_ball(angle))


def shift(mechanism: Mechanism, free: bool = False) -> Shifted:
    """Derive the functions of Sec. 2 after the parameters are put in and the angles are shifted.

    With ``free`` parameters may stay without a value.

    :raises MechanismError: a parameter without a value, or the Lagrangian character is violated.
    """
    missing = [name for name, value in mechanism.parameters if value is None]
    if missing and not free:
        raise MechanismError(f"{mechanism.name}: parameters without a value: {', '.join(missing)}")
    prepare = Preparation(mechanism)
    functions = derive_expressions(mechanism, prepare)
    check_lagrangian_character(mechanism, functions)
    return Shifted(mechanism, functions, prepare)


def angle_ball(angle: ReferenceAngle) -> arb:
    """An enclosure of the reference angle in (-π, π], at the working precision."""
    return arb.atan2(arb(angle.sine), arb(angle.cosine))


def to_system(
    shifted: Shifted, values: Mapping[str, Any], ring: Ring, conditions: Sequence[Expression], name: str | None = None
) -> System:
    """The system at the point ``values`` (numbers of the ring, angles counted from their references).

    ``conditions`` are the m - 4 extra functions J of the shifted state.

    :raises NotRationalError: exact arithmetic cannot hold it.
    """
    f = shifted.functions
    m = len(shifted.mechanism.state)
    scalars = [f.y, f.v, f.p, f.b, f.alpha_1, f.alpha_2, f.alpha_3]
    found = shifted.expressions([*f.F, *f.G, *scalars, *conditions], ring)
    J = tuple(found[2 * m + 7 :])
    y, v, p, b, first, second, third = found[2 * m : 2 * m + 7]
    point = tuple(values[word] for word in shifted.mechanism.state)
    return System(
        name=name or shifted.mechanism.name,
        F=tuple(found[:m]),
        G=tuple(found[m : 2 * m]),
        y=y,
        v=v,
        p=p,
        b=b,
        alpha_1=first,
        alpha_2=second,
        alpha_3=third,
        J=J,
        point=point,
        ring=ring,
        regularisation=shifted.mechanism.regularisation,
    )


def stays(index: int, value: Any, ring: Ring) -> Expression:
    """The condition that a component of the state keeps its value."""
    return Variable(index) if ring.is_zero(value) else Sum((Variable(index), Constant(-value)))
