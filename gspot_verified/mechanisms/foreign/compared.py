"""The accelerations that this library derives, beside those that sympy's own equations give, at exact states.

Theirs are numbers of sympy: the equations as they were formed, at a state, solved for the accelerations, and for the
answer to a normal and a tangential contact force. Ours are balls of F, G_N, G_T. The two share the contact point and
nothing else: a name that was mixed up, speeds that were transformed wrongly, a term that was lost make them differ.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.foreign.sympy_equations import SympyEquations, time_symbol
from gspot_verified.mechanisms.formulas.in_sympy import to_sympy
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism, MechanismError
from gspot_verified.numbers.balls import working_bits

_POINTS, _TRIES = 2, 6  # states that are compared, and states that are tried
_DIGITS = 50  # of sympy's numbers
_BITS = 200  # of our balls
_AGREE = arb("1e-30")  # relative to 1 + the number


@dataclass(frozen=True)
class Compared:
    """The equations, the contact as sympy's functions of q, q', t, and the name here of each parameter of sympy's."""

    equations: SympyEquations
    slip_velocity: Any
    y: Any
    parameters: Mapping[Any, str]


def compare(mechanism: Mechanism, theirs: Compared) -> int:
    """At how many states the accelerations were compared and agree; 0 where no state had values.

    :raises MechanismError: they differ: what was read is not what was given.
    """
    free = {name: fmpq(7 + 2 * i, 5) for i, (name, value) in enumerate(mechanism.parameters) if value is None}
    valued = mechanism.with_parameters(**free)
    numbers = {name: to_sympy(value) for name, value in valued.parameter_values().items()}
    parameters = {symbol: numbers[name] for symbol, name in theirs.parameters.items()}
    agreed = 0
    with working_bits(_BITS):
        for turn in range(_TRIES):
            if agreed == _POINTS:
                break
            state = [_rational((3 + 5 * turn + 7 * i) % 11 + 1, 13 + turn) for i in range(len(mechanism.state))]
            given = list(_their_rates(valued, theirs, state, parameters))
            own = _our_rates(valued, state)
            if not given or not all(value.is_finite() for value in own):
                continue
            for number, ball in zip(given, own, strict=True):
                if not abs(ball - number) <= _AGREE * (1 + abs(number)):
                    raise MechanismError(
                        f"{mechanism.name}: the accelerations derived here differ from those of the equations given: "
                        f"{ball.str(12)} and {number.str(12)} at {', '.join(map(str, state))}; no mechanism is made"
                    )
            agreed += 1
    return agreed


def _rational(numerator: int, denominator: int) -> Any:
    import sympy

    return sympy.Rational(numerator, denominator)


def _our_rates(mechanism: Mechanism, state: Sequence[Any]) -> list[arb]:
    """q'' of F, G_N, G_T."""
    assert isinstance(mechanism.motion, Lagrangian)
    n = len(mechanism.motion.coordinates)
    shifted = shift(mechanism, slip_speed=True)
    f = shifted.functions
    functions = [row[n + i] for row in (f.F, f.G_N, f.G_T) for i in range(n)]
    values = [arb(fmpq(int(number.p), int(number.q))) for number in state]
    return BoxProgram(shifted.expressions(functions, BALLS), len(state)).values(values)


def _their_rates(
    mechanism: Mechanism, theirs: Compared, state: Sequence[Any], parameters: Mapping[Any, Any]
) -> Iterator[arb]:
    """The same by sympy; nothing where the equations are singular or a number is not finite and real."""
    import sympy
    from sympy.matrices.exceptions import NonInvertibleMatrixError

    equations = theirs.equations
    n = len(equations.coordinates)
    references = {angle.coordinate: sympy.atan2(_exact(angle.sine), _exact(angle.cosine)) for angle in mechanism.angles}
    places = [value + references.get(word, 0) for word, value in zip(mechanism.state[:n], state[:n], strict=True)]
    q = dict(zip(equations.coordinates, places, strict=True))
    velocities = {c.diff(time_symbol()): v for c, v in zip(equations.coordinates, state[n : 2 * n], strict=True)}
    time = {time_symbol(): state[-1]} if len(state) > 2 * n else {}
    second = {c.diff(time_symbol(), 2): sympy.Dummy() for c in equations.coordinates}
    unknowns = {unknown: second.get(unknown, sympy.Dummy()) for unknown in equations.unknowns}

    def at_state(expression: Any, speeds: Mapping[Any, Any]) -> Any:
        """Derivatives first: a dynamic symbol stands inside its own."""
        for table in (second | unknowns, velocities, {**speeds, **q}, {**time, **parameters}):
            expression = expression.xreplace(table)
        return expression

    speeds = _their_speeds(equations, at_state)
    directions = [
        sympy.zeros(n, 1),
        sympy.Matrix([theirs.y.diff(c) for c in equations.coordinates]),
        sympy.Matrix([theirs.slip_velocity.diff(v) for v in velocities]),
    ]
    loads = [at_state(equations.loads * direction, speeds) for direction in directions]
    left = at_state(sympy.Matrix(equations.residual), speeds)
    letters = list(unknowns.values())
    matrix = left.jacobian(letters)
    rest = left.xreplace(dict.fromkeys(letters, sympy.Integer(0)))
    final = [at_state(acceleration, speeds) for acceleration in equations.accelerations]
    free = None
    for load in loads:
        try:
            answer = matrix.evalf(_DIGITS).LUsolve((load - rest).evalf(_DIGITS))
        except NonInvertibleMatrixError:
            return
        numbers = [each.xreplace(dict(zip(letters, answer, strict=True))).evalf(_DIGITS) for each in final]
        if not all(number.is_real and number.is_finite for number in numbers):
            return
        free = numbers if free is None else free
        for number, start in zip(numbers, free, strict=True):
            yield arb(str(number if free is numbers else number - start))


def _their_speeds(equations: SympyEquations, at_state: Any) -> dict[Any, Any]:
    """The generalised speeds at the state, from the kinematic equations as they were given."""
    import sympy

    if not equations.kinematics:
        return {}
    letters = {speed: sympy.Dummy() for speed in equations.speeds}
    gaps = [at_state(velocity - right, letters) for velocity, right in equations.kinematics.items()]
    matrix, right = sympy.linear_eq_to_matrix(gaps, *letters.values())
    return dict(zip(letters, matrix.evalf(_DIGITS).LUsolve(right.evalf(_DIGITS)), strict=True))


def _exact(value: fmpq) -> Any:
    return _rational(int(value.p), int(value.q))
