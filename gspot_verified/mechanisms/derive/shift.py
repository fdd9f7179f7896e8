"""Put the parameters in and count every angle from its reference: then all power series may be rational.

An angle with a rational sine and cosine at its reference is written φ = φ_ref + φ~, the state holds φ~, and
sin φ = sin(φ_ref) cos φ~ + cos(φ_ref) sin φ~: at φ~ = 0 all power series have exact rational coefficients.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from flint import fmpq

from gspot_verified.functions.expressions import Cosine, Expression, Product, Sine, Sum, Variable, in_order
from gspot_verified.mechanisms.formulas.rewriting import rebuilt
from gspot_verified.mechanisms.formulas.simplify import (
    NumberTooLargeError,
    constant,
    cosine_of,
    product_of,
    sine_of,
    split,
    sum_of,
)
from gspot_verified.mechanisms.formulas.symbol import PI, Symbol, symbol_names
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError, ReferenceAngle

_MAX_TURNS = 64
_MAX_MULTIPLIED_OUT = 64


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

        :raises MechanismError: a division by zero, or a number that grows too large, with these parameters.
        """
        made: dict[Expression, Expression] = {}
        try:
            for node in in_order(functions):
                made[node] = self._table[node] if node in self._table else self._rewritten(node, made)
        except (ZeroDivisionError, NumberTooLargeError) as error:
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
