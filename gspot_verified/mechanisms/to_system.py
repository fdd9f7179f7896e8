"""From a symbolic mechanism to the :class:`expansion.system.System` that Theorem 1 works on.

An angle with a rational sine and cosine at its reference is written φ = φ_ref + φ~, the state holds φ~, and
sin φ = sin(φ_ref) cos φ~ + cos(φ_ref) sin φ~: at φ~ = 0 all power series have exact rational coefficients.
Elsewhere the same code runs in balls.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from flint import arb, fmpq

from gspot_verified.expansion.expressions import (
    Constant,
    Cosine,
    Exponential,
    Expression,
    Power,
    Product,
    Sine,
    Sum,
    Variable,
)
from gspot_verified.expansion.rings import BALLS, Ring
from gspot_verified.expansion.symbols import Symbols
from gspot_verified.expansion.system import System
from gspot_verified.mechanisms.lie_derivatives import Derived, check_lagrangian_conditions, derive
from gspot_verified.mechanisms.mechanism import Mechanism, MechanismError, ReferenceAngle


class NotRationalError(MechanismError):
    """A number that the mechanism needs is not rational: use balls."""


@dataclass(frozen=True)
class Shifted:
    """A mechanism's functions with the parameters put in and every angle counted from its reference."""

    mechanism: Mechanism
    functions: Derived

    def expressions(self, functions: Sequence[Any], ring: Ring) -> list[Expression]:
        """Sympy functions of the shifted state as expressions of the ring; shared parts become shared nodes."""
        import sympy

        converter = Converter(self.mechanism, ring)
        parts, reduced = sympy.cse(list(functions), symbols=sympy.numbered_symbols(cls=sympy.Dummy))
        for symbol, part in parts:
            converter.known[symbol] = converter(part)
        return [converter(function) for function in reduced]


def shift(mechanism: Mechanism, free: bool = False) -> Shifted:
    """Derive the functions of Sec. 2 after the parameters are put in and the angles are shifted.

    With ``free`` parameters may stay without a value.

    :raises MechanismError: a parameter without a value, or the Lagrangian character is violated.
    """
    missing = [name for name, value in mechanism.parameters if value is None]
    if missing and not free:
        raise MechanismError(f"{mechanism.name}: parameters without a value: {', '.join(missing)}")
    functions = derive(mechanism)
    check_lagrangian_conditions(mechanism, functions)
    moved = Moves(mechanism)
    return Shifted(mechanism, Derived(**{name: moved(value) for name, value in vars(functions).items()}))


class Moves:
    """Replaces an angle φ by φ_ref + φ~ (called φ again), and sines and cosines of references by their numbers."""

    def __init__(self, mechanism: Mechanism) -> None:
        import sympy

        self._angles = {sympy.Symbol(angle.name): angle for angle in mechanism.angles}
        self._moves = {
            sympy.Symbol(angle.coordinate): sympy.Symbol(angle.coordinate) + symbol
            for symbol, angle in self._angles.items()
        }

    def __call__(self, value: Any) -> Any:
        """A function of the state, or a tuple of them, or None."""
        import sympy

        if value is None:
            return None
        if isinstance(value, tuple):
            return tuple(self(part) for part in value)
        moved = value.xreplace(self._moves)
        if not moved.free_symbols & set(self._angles):
            return moved
        known: dict[Any, Any] = {}
        for node in sorted(moved.atoms(sympy.sin, sympy.cos, sympy.tan), key=sympy.count_ops):
            sine, cosine = self._sine_cosine(node.args[0].xreplace(known))
            known[node] = {sympy.sin: sine, sympy.cos: cosine, sympy.tan: sine / cosine}[node.func]
        moved = moved.xreplace(known)
        return sympy.expand(moved) if moved.free_symbols & set(self._angles) else moved

    def _sine_cosine(self, argument: Any) -> tuple[Any, Any]:
        """sin and cos of n_1 ref_1 + ... + rest, by the addition formulas; the references' are exact numbers."""
        import sympy

        rest: list[Any] = []
        sine, cosine = fmpq(0), fmpq(1)
        for term in sympy.Add.make_args(argument):
            factor, symbol = term.as_coeff_Mul()
            angle = self._angles.get(symbol)
            if angle is None or not factor.is_Integer or abs(factor) > 64:
                rest.append(term)
                continue
            for _ in range(abs(int(factor))):
                s = angle.sine if factor > 0 else -angle.sine
                sine, cosine = sine * angle.cosine + cosine * s, cosine * angle.cosine - sine * s
        inner = sympy.Add(*rest)
        s_number, c_number = (sympy.Rational(int(value.p), int(value.q)) for value in (sine, cosine))
        s_rest, c_rest = sympy.sin(inner), sympy.cos(inner)
        return s_number * c_rest + c_number * s_rest, c_number * c_rest - s_number * s_rest


@dataclass
class Converter:
    """Sympy to expressions of one ring; ``known`` holds what was converted."""

    mechanism: Mechanism
    ring: Ring
    known: dict[Any, Expression] = field(default_factory=dict)

    def __post_init__(self) -> None:
        import sympy

        self._angles = {sympy.Symbol(angle.name): angle for angle in self.mechanism.angles}
        for i, symbol in enumerate(self.mechanism.symbols):
            self.known[symbol] = Variable(i)

    def __call__(self, node: Any) -> Expression:
        """The expression of one sympy node.

        :raises NotRationalError: it needs an angle itself (not its sine and cosine) in exact arithmetic.
        :raises MechanismError: a function that has no power series here.
        """
        found = self.known.get(node)
        if found is None:
            found = self.known[node] = self._convert(node)
        return found

    def _convert(self, node: Any) -> Expression:
        import sympy

        if node.is_Rational:
            return Constant(fmpq(int(node.p), int(node.q)))
        if node.is_Symbol:
            return self._angle(node)
        if node.is_Add:
            return Sum(tuple(self(part) for part in node.args))
        if node.is_Mul:
            return self._product(node.args)
        if node.is_Pow:
            return self._power(node)
        if isinstance(node, sympy.sin):
            return Sine(self(node.args[0]))
        if isinstance(node, sympy.cos):
            return Cosine(self(node.args[0]))
        if isinstance(node, sympy.tan):
            return Sine(self(node.args[0])) / Cosine(self(node.args[0]))
        if isinstance(node, sympy.exp):
            return Exponential(self(node.args[0]))
        if node is sympy.E:
            return Exponential(Constant(fmpq(1)))
        raise MechanismError(f"{self.mechanism.name}: no power series for {str(node)[:80]}")

    def _angle(self, symbol: Any) -> Expression:
        angle = self._angles.get(symbol)
        if angle is None and isinstance(self.ring, Symbols) and symbol.name in dict(self.mechanism.parameters):
            return Constant(self.ring.symbol(symbol.name))
        if angle is None:
            raise MechanismError(f"{self.mechanism.name}: {symbol} has no value")
        if self.ring is not BALLS:
            raise NotRationalError(
                f"{self.mechanism.name}: {symbol} stands outside a sine or cosine and does not cancel: not rational"
            )
        return ball_constant(angle_ball(angle))

    def _product(self, factors: Sequence[Any]) -> Expression:
        parts = [self(factor) for factor in factors]
        while len(parts) > 1:
            parts = [
                Product(parts[i], parts[i + 1]) if i + 1 < len(parts) else parts[i] for i in range(0, len(parts), 2)
            ]
        return parts[0]

    def _power(self, node: Any) -> Expression:
        base, exponent = node.args
        if not exponent.is_Rational:
            raise MechanismError(f"{self.mechanism.name}: no power series for {str(node)[:80]}")
        inner = self(base)
        if exponent.is_Integer and exponent > 0:
            return _repeated(inner, int(exponent))
        return Power(inner, fmpq(int(exponent.p), int(exponent.q)))


def _repeated(base: Expression, exponent: int) -> Expression:
    """A positive integer power by products: the base may vanish."""
    if exponent == 1:
        return base
    half = _repeated(base, exponent // 2)
    square = Product(half, half)
    return Product(square, base) if exponent % 2 else square


def angle_ball(angle: ReferenceAngle) -> arb:
    """An enclosure of the reference angle in (-π, π], at the working precision."""
    return arb.atan2(arb(angle.sine), arb(angle.cosine))


def to_system(
    shifted: Shifted, values: Mapping[str, Any], ring: Ring, conditions: Sequence[Any], name: str | None = None
) -> System:
    """The system at the point ``values`` (numbers of the ring, angles counted from their references).

    ``conditions`` are the m - 4 extra functions J, as sympy functions of the shifted state, or expressions.

    :raises NotRationalError: exact arithmetic cannot hold it.
    """
    f = shifted.functions
    m = len(shifted.mechanism.state)
    scalars = [f.y, f.v, f.p, f.b, f.alpha_1, f.alpha_2, f.alpha_3]
    symbolic = [J for J in conditions if not isinstance(J, Expression)]
    found = shifted.expressions([*f.F, *f.G, *scalars, *symbolic], ring)
    own = iter(found[2 * m + 7 :])
    J = tuple(given if isinstance(given, Expression) else next(own) for given in conditions)
    y, v, p, b, first, second, third = found[2 * m : 2 * m + 7]
    point = tuple(values[word] for word in shifted.mechanism.state)
    return System(
        name or shifted.mechanism.name, tuple(found[:m]), tuple(found[m : 2 * m]), y, v, p, b, first, second, third,
        J, point, ring,
    )  # fmt: skip


@dataclass(frozen=True, eq=False)
class BallConstant(Constant):
    """A constant that is a ball: equal only to itself, because balls have no certain equality."""

    __hash__ = object.__hash__

    def __eq__(self, other: object) -> bool:
        return self is other


def ball_constant(value: arb) -> Constant:
    """A ball as a constant function."""
    return BallConstant(value)


def stays(index: int, value: Any, ring: Ring) -> Expression:
    """The condition that a component of the state keeps its value."""
    if ring.is_zero(value):
        return Variable(index)
    return Sum((Variable(index), ball_constant(-value) if isinstance(value, arb) else Constant(-value)))
