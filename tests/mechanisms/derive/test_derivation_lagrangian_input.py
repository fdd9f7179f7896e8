"""A mechanism with a mass matrix, prepared: which of its functions may depend on velocities."""

from __future__ import annotations

from typing import Any

import pytest

from gspot_verified.functions.derivative import ONE, ZERO
from gspot_verified.functions.expressions import Variable
from gspot_verified.mechanisms.derive.derivation import LagrangianInput, lagrangian_input
from gspot_verified.mechanisms.derive.to_system import Preparation
from gspot_verified.mechanisms.formulas.rewriting import simplified
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Lagrangian, MechanismError

BODY: dict[str, Any] = {
    "name": "body", "coordinates": ["X", "Y", "Z"], "mass_matrix": [[2, "X", 0], ["X", 3, "Z"], [0, "Z", 5]],
    "forces": ["X_dot", "Y_dot*Z_dot", "t"], "x": "X*Y - t^2", "y": "Y - Z", "mu": "1 + X^2", "time": "t",
    "constraints": ["X - Z*t"],
}  # fmt: skip
"""The state is X, Y, Z, X_dot, Y_dot, Z_dot, t."""


def prepared(**change: Any) -> LagrangianInput:
    made = lagrangian(**BODY | change)
    assert isinstance(made.motion, Lagrangian)
    return lagrangian_input(made, made.motion, Preparation(made))


def test_every_function_is_in_its_place() -> None:
    found = prepared()
    X, Y, Z, t = (Variable(i) for i in (0, 1, 2, 6))
    assert (found.n, found.m) == (3, 7)
    assert found.glide == (Variable(3), Variable(4), Variable(5), ZERO, ZERO, ZERO, ONE)
    assert [list(row) for row in found.rows] == [
        simplified(*row) for row in ([ONE + ONE, X, ZERO], [X, ONE + ONE + ONE, Z], [ZERO, Z, sum([ONE] * 4, ONE)])
    ]
    assert [list(found.forces), list(found.constraints)] == [
        simplified(Variable(3), Variable(4) * Variable(5), t), simplified(X - Z * t)
    ]  # fmt: skip
    assert [found.x, found.y, found.mu] == simplified(X * Y - t * t, Y - Z, ONE + X * X)
    assert [found.u] == simplified(Variable(3) * Y + X * Variable(4) - t - t)


def test_a_slip_velocity_stands_for_x() -> None:
    found = prepared(x=None, slip_velocity="X*X_dot + 2*Z_dot - t")
    assert found.x is None
    X, t = Variable(0), Variable(6)
    assert [found.u] == simplified(X * Variable(3) + (ONE + ONE) * Variable(5) - t)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"x": "X + Y_dot"}, "body: x and y must not depend on velocities"),
        ({"y": "Y + Z_dot"}, "body: x and y must not depend on velocities"),
        ({"x": None, "slip_velocity": "X_dot", "y": "Y + X_dot"}, "body: x and y must not depend on velocities"),
        ({"x": None, "slip_velocity": "X_dot*Z_dot"}, "body: the slip velocity must be linear in the velocities"),
        ({"x": None, "slip_velocity": "Z_dot^2"}, "body: the slip velocity must be linear in the velocities"),
        ({"constraints": ["Z_dot"]}, "body: a constraint must not depend on velocities"),
        (
            {"mass_matrix": [[2, 0, 0], [0, 3, 0], [0, 0, "1 + Z_dot^2"]]},
            "body: the mass matrix must not depend on vel",
        ),
        (
            {"mass_matrix": [["1 + X_dot^2", 0, 0], [0, 3, 0], [0, 0, 1]]},
            "body: the mass matrix must not depend on vel",
        ),
        ({"mu": "1 + X_dot^2"}, "body: the friction coefficient must not depend on velocities: L_G p must vanish"),
    ],
)
def test_what_must_not_depend_on_velocities_is_refused(change: dict[str, Any], message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        prepared(**change)


def test_time_and_positions_are_no_velocities() -> None:
    found = prepared(
        mu="1 + t^2 + Z^2", y="Y - t", constraints=["X - t^2"], mass_matrix=[[1, 0, 0], [0, "1 + t^2", 0], [0, 0, 1]]
    )
    assert found.m == 7
