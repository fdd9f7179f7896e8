"""From a mechanism to the :class:`expansion.series.system.System` that Theorem 1 works on.

The functions are derived once, with the parameters put in and the angles shifted. For a ring the numbers
that have a name get their value: a rational point has exact rational power series, elsewhere the same code runs in
balls, and parameters without a value become symbols of the ring.

The Lagrangian character that the paper asks of a system is proved as identities in the state:
L_GT x = L_GN x = L_GT y = L_GN y = 0 (eq. lagrangian1), L_GN u = L_GT v, and L_G p = 0 (eq. lagrangian2). With a mass
matrix they hold by the way the functions are derived (:mod:`derivation`). Fields that are given directly
are checked: a function that simplifies to the constant 0 is 0; what does not is left to sympy.

Every angle is counted from its reference: then all power series may be rational. An angle with a rational sine and
cosine at its reference is written φ = φ_ref + φ~, the state holds φ~, and
sin φ = sin(φ_ref) cos φ~ + cos(φ_ref) sin φ~: at φ~ = 0 all power series have exact rational coefficients.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from flint import arb, fmpq

from gspot_verified.expansion.series.system import System
from gspot_verified.functions.derivative import ZERO, powers_as_products, rewritten
from gspot_verified.functions.expressions import Constant, Cosine, Expression, Product, Sine, Sum, Variable, in_order
from gspot_verified.functions.rings import BALLS, Ring
from gspot_verified.functions.symbols import Symbols
from gspot_verified.mechanisms.derive.derivation import derive_expressions
from gspot_verified.mechanisms.derive.derived import Derived
from gspot_verified.mechanisms.derive.slip_speed import NOT_LAGRANGIAN, depends_on_slip_speed
from gspot_verified.mechanisms.formulas.rewriting import along, rebuilt
from gspot_verified.mechanisms.formulas.simplify import (
    NoNumberError,
    constant,
    cosine_of,
    minus,
    product_of,
    sine_of,
    split,
    sum_of,
)
from gspot_verified.mechanisms.formulas.symbol import PI, Symbol, symbol_names
from gspot_verified.mechanisms.input.mechanism import (
    Lagrangian,
    Mechanism,
    MechanismError,
    ReferenceAngle,
    require_mechanism,
)

_MAX_TURNS = 64  # largest multiple of a reference angle whose sine and cosine are computed: they grow long
_MAX_MULTIPLIED_OUT = 64  # terms: longer products stay products


class Preparation:
    """Rewrites formulas of a mechanism: parameters put in, an angle φ replaced by φ_ref + φ~ (φ~ takes its place)."""

    def __init__(self, mechanism: Mechanism) -> None:
        self._name = mechanism.name
        self._angles = {Symbol(angle.name): angle for angle in mechanism.angles}
        self._quarter = Symbol(PI)
        self._table: dict[Expression, Expression] = {
            Symbol(name): value for name, value in mechanism.parameter_values().items()
        }
        for angle in mechanism.angles:
            component = Variable(mechanism.state.index(angle.coordinate))
            self._table[component] = sum_of(component, Symbol(angle.name))
        self._references = {angle.name for angle in mechanism.angles} | {PI}

    def __call__(self, functions: Sequence[Expression]) -> list[Expression]:
        """The functions of the shifted state.

        :raises MechanismError: a division by zero, a number that is not real or grows too large, with these parameters.
        """
        made: dict[Expression, Expression] = {}
        try:
            for node in in_order(functions):
                made[node] = self._table[node] if node in self._table else self._rewritten(node, made)
        except (ZeroDivisionError, NoNumberError) as error:
            raise MechanismError(f"{self._name}: with the values of the parameters: {error}") from None
        return [made[function] for function in functions]

    def _rewritten(self, node: Expression, made: Mapping[Expression, Expression]) -> Expression:
        match node:
            case Sine(argument):
                return self._sine_cosine(made[argument])[0]
            case Cosine(argument):
                return self._sine_cosine(made[argument])[1]
            case Product(left, right):
                return self._product(made[left], made[right])
        return rebuilt(node, made)

    def _product(self, left: Expression, right: Expression) -> Expression:
        """The product; a sum in which a bare reference stands is multiplied out, so that the reference may cancel.

        Not where that gives many terms: such products could double in length with each factor.
        """
        for one, other in ((left, right), (right, left)):
            if not isinstance(one, Sum) or len(one.terms) * _length(other) > _MAX_MULTIPLIED_OUT:
                continue
            if any(symbol_names([term]) & self._references for term in one.terms):
                return sum_of(*(self._product(term, other) for term in one.terms))
        return product_of(left, right)

    def _sine_cosine(self, argument: Expression) -> tuple[Expression, Expression]:
        """sin and cos of n_1 ref_1 + ... + rest, by the addition formulas; the references' are exact numbers."""
        rest: list[Expression] = []
        sine, cosine = fmpq(0), fmpq(1)
        for term in argument.terms if isinstance(argument, Sum) else (argument,):
            turn = self._turn(*split(term))
            if turn is None:
                rest.append(term)
            else:
                sine, cosine = sine * turn[1] + cosine * turn[0], cosine * turn[1] - sine * turn[0]
        inner = sum_of(*rest)
        if cosine == 1:
            return sine_of(inner), cosine_of(inner)
        s, c, s_rest, c_rest = constant(sine), constant(cosine), sine_of(inner), cosine_of(inner)
        return (
            sum_of(product_of(s, c_rest), product_of(c, s_rest)),
            sum_of(product_of(c, c_rest), product_of(constant(-sine), s_rest)),
        )

    def _turn(self, factor: fmpq, symbol: Expression) -> tuple[fmpq, fmpq] | None:
        """Exact sine and cosine of an integer multiple of a reference, or of a multiple of pi/2."""
        if symbol is self._quarter and (2 * factor).q == 1:
            quarters = int((2 * factor).p) % 4
            return fmpq((0, 1, 0, -1)[quarters]), fmpq((1, 0, -1, 0)[quarters])
        angle = self._angles.get(symbol) if isinstance(symbol, Symbol) else None
        if angle is None or factor.q != 1 or abs(factor) > _MAX_TURNS:
            return None
        return _multiple(angle, int(factor.p))


def _length(expression: Expression) -> int:
    return len(expression.terms) if isinstance(expression, Sum) else 1


def _multiple(angle: ReferenceAngle, count: int) -> tuple[fmpq, fmpq]:
    sine, cosine = fmpq(0), fmpq(1)
    s = angle.sine if count > 0 else -angle.sine
    for _ in range(abs(count)):
        sine, cosine = sine * angle.cosine + cosine * s, cosine * angle.cosine - sine * s
    return sine, cosine


def check_lagrangian_character(mechanism: Mechanism, derived: Derived[Expression]) -> None:
    """Checks eqs. lagrangian1, lagrangian2 and B = L_GN u = L_GT v as identities in the state.

    :raises MechanismError: one of them is not the zero function, or was not shown to be.
    """
    if isinstance(mechanism.motion, Lagrangian):
        return
    places = [derived.y] if derived.x is None else [derived.x, derived.y]
    checks = [along(field, function) for function in places for field in (derived.G_T, derived.G_N)]
    checks.append(minus(derived.B, along(derived.G_T, derived.v)))
    checks.append(along(derived.G, derived.p))
    if all(check is ZERO for check in checks):
        return
    from gspot_verified.mechanisms.derive.lie_derivatives import check_lagrangian_conditions, derive

    check_lagrangian_conditions(mechanism, derive(mechanism))


class NotRationalError(MechanismError):
    """A number that the mechanism needs is not rational: use balls."""


@dataclass(frozen=True)
class Shifted:
    """A mechanism's functions with the parameters put in and every angle counted from its reference.

    ``functions`` are expressions of the shifted state in which symbols may be left: bare reference angles, pi, and the
    parameters without a value. ``numbers`` are those of some of these symbols: rationals; or balls that stand for any
    number (see :mod:`shared_derivation`), then ``shared`` is one whose programs are to be used with the numbers.
    """

    mechanism: Mechanism
    functions: Derived[Expression]
    prepare: Preparation = field(repr=False, compare=False)
    numbers: tuple[tuple[str, fmpq | arb], ...] = field(default=(), compare=False)
    shared: Shifted | None = field(default=None, repr=False, compare=False)

    @property
    def constraints(self) -> tuple[Expression, ...]:
        """The constraints and their rates: functions of the shifted state that vanish along every motion."""
        motion = self.mechanism.motion
        if not isinstance(motion, Lagrangian):
            return ()
        prepared = self.prepare(motion.constraints)
        return (*prepared, *(along(self.functions.F, constraint) for constraint in prepared))

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
        number = dict(self.numbers).get(name)
        if number is not None:
            return Constant(number)
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


def shift(mechanism: Mechanism, free: bool = False, slip_speed: bool = False) -> Shifted:
    """Derive the functions of Sec. 2 after the parameters are put in and the angles are shifted.

    With ``free`` parameters may stay without a value. With ``slip_speed`` the friction coefficient may depend on the
    slip speed: it is held fixed and stays a symbol of the functions (:mod:`slip_speed`).

    :raises TypeError: it is no mechanism.
    :raises MechanismError: a parameter without a value, or the Lagrangian character is violated.
    """
    require_mechanism(mechanism)
    missing = [name for name, value in mechanism.parameters if value is None]
    if missing and not free:
        raise MechanismError(f"{mechanism.name}: parameters without a value: {', '.join(missing)}")
    prepare = Preparation(mechanism)
    functions = derive_expressions(mechanism, prepare)
    check_lagrangian_character(mechanism, functions)
    if not slip_speed and depends_on_slip_speed(mechanism, functions):
        raise MechanismError(f"{mechanism.name}: {NOT_LAGRANGIAN}")
    return Shifted(mechanism, functions, prepare)


def angle_ball(angle: ReferenceAngle) -> arb:
    """An enclosure of the reference angle in (-π, π], at the working precision."""
    return arb.atan2(arb(angle.sine), arb(angle.cosine))


def counted_from_zero(mechanism: Mechanism, state: Sequence[arb]) -> list[arb]:
    """The components of a shifted state with the reference angles added."""
    references = {angle.coordinate: angle_ball(angle) for angle in mechanism.angles}
    return [value + references.get(word, 0) for word, value in zip(mechanism.state, state, strict=True)]


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
    expressions = shifted.expressions([*f.F, *f.G, *scalars, *conditions], ring)
    J = tuple(expressions[2 * m + 7 :])
    y, v, p, b, first, second, third = expressions[2 * m : 2 * m + 7]
    point = tuple(values[word] for word in shifted.mechanism.state)
    return System(
        name=name or shifted.mechanism.name,
        F=tuple(expressions[:m]),
        G=tuple(expressions[m : 2 * m]),
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
