"""Lie derivatives against numerical differentiation along the flow, and the Lagrangian conditions."""

from __future__ import annotations

import random
from typing import Any

import mpmath
import pytest
import sympy

from gspot_verified.mechanisms.derive.derived import Derived
from gspot_verified.mechanisms.derive.lie_derivatives import (
    Reader,
    check_lagrangian_conditions,
    derive,
    lagrangian_conditions,
    lie_derivative,
    vanishes_identically,
)
from gspot_verified.mechanisms.input.given import from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism, shipped_names

ALL = [name for name in shipped_names() if name not in ("falling rod, lower friction", "rod with Stribeck friction")]


def numerical(mechanism: Mechanism, function: Any) -> Any:
    references = [sympy.Symbol(angle.name) for angle in mechanism.angles]
    return sympy.lambdify([*mechanism.symbols, *references], function, "mpmath")


def along(field: list[Any], function: Any, point: list[Any], extra: list[Any]) -> Any:
    """The derivative at 0 of function(point + h field(point)), which is the Lie derivative, by mpmath."""
    slope = [f(*point, *extra) for f in field]
    return mpmath.diff(lambda h: function(*[x + h * s for x, s in zip(point, slope, strict=True)], *extra), 0)


@pytest.mark.parametrize("name", ALL)
def test_against_numerical_derivatives(name: str) -> None:
    mechanism = shipped_mechanism(name)
    found = derive(mechanism)
    f = {key: numerical(mechanism, value) for key, value in vars(found).items() if not isinstance(value, tuple | None)}
    fields = {key: [numerical(mechanism, part) for part in getattr(found, key)] for key in ("F", "G_T", "G_N", "G")}
    rules = [
        ("u", "F", "x", 1), ("v", "F", "y", 1), ("a", "F", "u", 1), ("b", "F", "v", 1), ("A", "G_T", "u", 1),
        ("B", "G_N", "u", 1), ("B", "G_T", "v", 1), ("C", "G_N", "v", 1), ("p", "G", "v", 1),
        ("alpha_1", "F", "p", 1), ("alpha_2", "F", "b", 1), ("alpha_3", "G", "b", -1),
    ]  # fmt: skip
    source = random.Random(name)
    with mpmath.workdps(40):
        for _ in range(3):
            point = [mpmath.mpf(source.randint(-90, 90)) / 97 for _ in mechanism.state]
            extra = [
                mpmath.atan2(*(mpmath.mpf(int(part.p)) / int(part.q) for part in (angle.sine, angle.cosine)))
                for angle in mechanism.angles
            ]
            for result, field, function, sign in rules[
                found.x is None :
            ]:  # the slip velocity may be given instead of x
                wanted = sign * along(fields[field], f[function], point, extra)
                assert mpmath.almosteq(f[result](*point, *extra), wanted, 1e-12, 1e-12), (result, field)
            p, C, B, mu = (f[key](*point, *extra) for key in ("p", "C", "B", "mu"))
            assert mpmath.almosteq(p, C - mu * B, 1e-30, 1e-30)


def test_accelerations_solve_the_equations_of_motion() -> None:
    """M q'' = f + Q_N λ_N + Q_T λ_T at random exact points, for arbitrary forces."""
    mechanism = shipped_mechanism("oscillator")
    found = derive(mechanism)
    motion = mechanism.motion
    read = Reader(mechanism)
    phi = sympy.Symbol("phi")
    q = mechanism.symbols[:2]
    at = {sympy.sin(phi): sympy.Rational(5, 13), sympy.cos(phi): sympy.Rational(12, 13)}
    lambda_n, lambda_t = sympy.Rational(3, 7), sympy.Rational(-2, 9)
    for i in range(2):
        row = read.all(motion.mass_matrix[i])  # type: ignore[union-attr]
        accelerations = [found.F[2 + j] + found.G_N[2 + j] * lambda_n + found.G_T[2 + j] * lambda_t for j in range(2)]
        left = sum(entry * acceleration for entry, acceleration in zip(row, accelerations, strict=True))
        right = read(motion.forces[i])  # type: ignore[union-attr]
        right += sympy.diff(found.y, q[i]) * lambda_n + sympy.diff(found.x, q[i]) * lambda_t
        assert sympy.expand((left - right).xreplace(at)) == 0


@pytest.mark.parametrize("name", ALL)
def test_the_lagrangian_conditions_hold(name: str) -> None:
    mechanism = shipped_mechanism(name)
    found = derive(mechanism)
    check_lagrangian_conditions(mechanism, found)
    assert len(lagrangian_conditions(mechanism, found)) in ((3, 4) if found.x is None else (5, 6))
    assert vanishes_identically(found.B - lie_derivative(found.G_T, found.v, mechanism.symbols))


EXTENDED: dict[str, Any] = {
    "name": "test", "state": ["x", "u", "y", "v", "p", "b"], "F": ["u", 0, "v", "b", -1, -1],
    "G_T": [0, "3/(2*(1 - p))", 0, "1/2", 0, "-3/4/(1 - p)"], "G_N": [0, "1/2", 0, "(1 + p)/2", 0, "3/4"],
    "x": "x", "y": "y", "mu": "1 - p",
}  # fmt: skip


@pytest.mark.parametrize(
    ("change", "which"),
    [
        ({"y": "y + v"}, "L_GT y"),
        ({"x": "x + u"}, "L_GT x"),
        ({"G_T": [0, "3/2", 0, "1/3", 0, 0]}, "L_GN u - L_GT v"),
        ({"G_N": [0, "1/2", 0, "(1 + p + v)/2", 0, "3/4"]}, "L_G p"),
    ],
)
def test_violated_conditions_are_named(change: dict[str, Any], which: str) -> None:
    mechanism = from_fields(**EXTENDED | change)
    with pytest.raises(MechanismError, match=which):
        check_lagrangian_conditions(mechanism, derive(mechanism))


def test_vanishes_identically() -> None:
    x, y = sympy.symbols("x y")
    assert vanishes_identically(sympy.sin(x) ** 4 - sympy.cos(x) ** 4 - sympy.sin(x) ** 2 + sympy.cos(x) ** 2)
    assert vanishes_identically(sympy.tan(y) * sympy.cos(y) - sympy.sin(y))
    assert vanishes_identically(1 / (x + y) - (x - y) / (x**2 - y**2))
    assert not vanishes_identically(sympy.sin(x) ** 2 + sympy.cos(x) ** 2 - 1 + x * sympy.Rational(1, 10**9))


def test_singular_mass_matrix() -> None:
    mechanism = lagrangian("test", ["x", "y"], [[1, 1], [1, 1]], [0, 0], "x", "y", 1)
    with pytest.raises(MechanismError, match="singular"):
        derive(mechanism)


def test_time_is_a_component_of_the_state() -> None:
    mechanism = lagrangian("test", ["x", "y"], [[2, 0], [0, 2]], ["t*x", 0], "x - t^2", "y", 1, time="t")
    found: Derived[Any] = derive(mechanism)
    t, x, rate = sympy.symbols("t x x_dot")
    assert mechanism.state == ("x", "y", "x_dot", "y_dot", "t")
    assert sympy.expand(found.u - (rate - 2 * t)) == 0
    assert sympy.expand(found.a - (t * x / 2 - 2)) == 0


def test_contact_point_must_not_depend_on_velocities() -> None:
    with pytest.raises(MechanismError, match="velocities"):
        derive(lagrangian("test", ["x", "y"], [[1, 0], [0, 1]], [0, 0], "x_dot", "y", 1))


@pytest.mark.parametrize("factors", [30, 100])
def test_functions_that_grow_too_large_are_refused_soon(factors: int) -> None:
    product = "*".join(f"(x + {i}*y)" for i in range(1, factors))
    with pytest.raises(MechanismError, match="more than"):
        derive(lagrangian("test", ["x", "y"], [[1, 0], [0, 1]], [0, 0], "x", product, 1))


def test_lie_derivative_of_a_constant() -> None:
    assert lie_derivative((1, 1), sympy.Integer(3), sympy.symbols("x y")) == 0


def test_the_slip_velocity_stands_in_the_place_of_x() -> None:
    """A disc that rolls: u = X' + 2 phi', so G_T holds (1, 0, 2/I) and A = 1 + 4/I."""
    rows = [[1, 0, 0], [0, 1, 0], [0, 0, 5]]
    disc = lagrangian("disc", ["X", "Y", "phi"], rows, [0, -1, 0], None, "Y", 1, slip_velocity="X_dot + 2*phi_dot")
    found: Derived[Any] = derive(disc)
    assert found.x is None
    assert found.u == sympy.Symbol("X_dot") + 2 * sympy.Symbol("phi_dot")
    assert list(found.G_T[3:]) == [1, 0, sympy.Rational(2, 5)]
    assert sympy.Rational(9, 5) == found.A
