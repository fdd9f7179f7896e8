"""A system to try things on, and other descriptions of a given system: other units, other coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from flint import fmpq

from gspot_verified.expansion.series.system import System
from gspot_verified.functions.derivative import lie_derivative, plus, substitute, times
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.numbers.balls import ExactInput, exact


def extended_example(chi: ExactInput, alpha: tuple[ExactInput, ExactInput, ExactInput] = (-1, -1, "-3/2")) -> System:
    """The paper's extended example (Sec. 5) with alpha_1, alpha_2, alpha_3 at the G-spot; by default the printed ones.

    The state is (x, u, y, v, p, b): x' = u, u' = -lambda_N, y' = v, v' = b + p lambda_N, p' = alpha_1 + chi b,
    b' = alpha_2 - alpha_3 lambda_N; J = (x, u).

    >>> extended_example(chi=1).check()
    (-1, -1, -3/2)
    """
    first, second, third = (Constant(exact(value, f"alpha[{i}]")) for i, value in enumerate(alpha))
    x = [Variable(i) for i in range(6)]
    nothing = Constant(fmpq(0))
    slope = plus(first, times(Constant(exact(chi, "chi")), x[5]))
    return System(
        "extended example",
        F=(x[1], nothing, x[3], x[5], slope, second),
        G=(nothing, Constant(fmpq(-1)), nothing, x[4], nothing, -third),
        y=x[2],
        v=x[3],
        p=x[4],
        b=x[5],
        alpha_1=slope,
        alpha_2=second,
        alpha_3=third,
        J=(x[0], x[1]),
        point=(fmpq(0),) * 6,
    )


def in_units(system: System, time: ExactInput, length: ExactInput) -> System:
    """The same system with t, epsilon in units of ``time``, y in units of ``length``.

    The law: v, b, lambda_N are measured in length/time, length/time^2, length/time^2, p stays, alpha_1 and alpha_3 are
    multiplied by time, alpha_2 by time^3/length. These are all scalings that keep genSysXi to genSysLN.

    >>> in_units(extended_example(chi=1), 2, 3).check()
    (-2, -8/3, -3)
    """
    tau, unit = exact(time, "time"), exact(length, "length")

    def scaled(function: Expression, factor: Any) -> Expression:
        return times(Constant(factor), function)

    force = unit / (tau * tau)
    return replace(
        system,
        F=tuple(scaled(f, tau) for f in system.F),
        G=tuple(scaled(g, tau * force) for g in system.G),
        y=scaled(system.y, 1 / unit),
        v=scaled(system.v, tau / unit),
        b=scaled(system.b, tau * tau / unit),
        alpha_1=scaled(system.alpha_1, tau),
        alpha_2=scaled(system.alpha_2, tau * tau * tau / unit),
        alpha_3=scaled(system.alpha_3, tau),
    )


def sheared(system: System, index: int, shift: Expression) -> System:
    """The same system with the coordinate xi_index + shift in the place of xi_index.

    ``shift`` must not depend on xi_index.
    """
    forward = plus(Variable(index), shift)
    back: list[Expression] = [Variable(i) for i in range(len(system.point))]
    back[index] = Variable(index) - shift

    def moved(function: Expression) -> Expression:
        return substitute(function, back)

    def field(components: Sequence[Expression]) -> tuple[Expression, ...]:
        changed = list(components)
        changed[index] = lie_derivative(forward, components)
        return tuple(moved(component) for component in changed)

    point = list(system.point)
    point[index] = system.values_at_point([forward])[0]
    return replace(
        system,
        F=field(system.F),
        G=field(system.G),
        y=moved(system.y),
        v=moved(system.v),
        p=moved(system.p),
        b=moved(system.b),
        alpha_1=moved(system.alpha_1),
        alpha_2=moved(system.alpha_2),
        alpha_3=moved(system.alpha_3),
        J=tuple(moved(condition) for condition in system.J),
        point=tuple(point),
    )
