"""M and f of what sympy.mechanics has formed: a pendulum and a particle by hand, in each form that sympy has."""

from __future__ import annotations

from typing import Any

import pytest
import sympy
from sympy.physics.mechanics import (
    KanesMethod,
    LagrangesMethod,
    Particle,
    Point,
    ReferenceFrame,
    dynamicsymbols,
)

from gspot_verified.mechanisms.foreign.exact_formulas import ExactFormulas
from gspot_verified.mechanisms.foreign.sympy_equations import sympy_equations, time_symbol
from gspot_verified.mechanisms.input.mechanism import MechanismError

q, r, u, w = dynamicsymbols("q r u w")
g, k = sympy.symbols("g k")
t = time_symbol()
EXACT = ExactFormulas("it")


def read(method: Any, coordinates: Any = None) -> Any:
    return sympy_equations("it", method, EXACT, coordinates)


def particle(speed: Any, **options: Any) -> Any:
    """A particle of mass 3 on a line at q, with q' = speed, a spring and its weight."""
    N = ReferenceFrame("N")
    point = Point("P")
    point.set_vel(N, speed * N.x)
    method = KanesMethod(N, [q], [u], kd_eqs=[q.diff() - speed], **options)
    method.kanes_equations([Particle("p", point, sympy.Integer(3))], [(point, (-k * q - 3 * g) * N.x)])
    return method


@pytest.mark.parametrize("speed", [u, 2 * u, u * (1 + q**2), u + sympy.sin(t), u / (2 + sympy.cos(q))])
def test_a_speed_of_any_kind_gives_newtons_law(speed: Any) -> None:
    found = read(particle(speed))
    ratio = sympy.simplify(found.forces[0] / found.mass_matrix[0, 0])
    assert sympy.simplify(ratio - (-k * q - 3 * g) / 3) == 0
    assert sympy.simplify(found.mass_matrix[0, 0] - 3) == 0
    assert sympy.simplify(found.speeds[u].xreplace({q.diff(): speed}) - u) == 0
    assert (
        found.kinematics == {q.diff(): sympy.sympify(speed)} or sympy.simplify(found.kinematics[q.diff()] - speed) == 0
    )


def test_the_residual_is_kanes_equation() -> None:
    """q' = 2 u: the partial velocity is 2, the inertia force -3 q'' = -6 u'."""
    found = read(particle(2 * u))
    assert sympy.expand(found.residual[0] - (12 * u.diff() + 2 * k * q + 6 * g)) == 0
    assert found.accelerations == (2 * u.diff(),)
    assert found.loads == sympy.Matrix([[2]])


def test_speeds_that_determine_nothing_are_refused() -> None:
    N = ReferenceFrame("N")
    point = Point("P")
    point.set_vel(N, u * N.x)
    method = KanesMethod(N, [q, r], [u, w], kd_eqs=[q.diff() - u - w, r.diff() - u - w])
    method.kanes_equations([Particle("p", point, 1)], [(point, g * N.x)])
    with pytest.raises(MechanismError, match="do not determine the velocities"):
        read(method)


def test_lagrange_with_a_constraint_keeps_both() -> None:
    method = LagrangesMethod(q.diff() ** 2 + r.diff() ** 2 - g * r, [q, r], hol_coneqs=[q - r**2])
    found = read(method)
    assert found.mass_matrix == 2 * sympy.eye(2)
    assert list(found.forces) == [0, -g]
    assert found.constraints == (q - r**2,)
    assert len(found.unknowns) == 3
    assert len(found.residual) == 3
    assert found.loads.shape == (3, 2)


def test_a_velocity_in_a_constraint_is_refused() -> None:
    method = LagrangesMethod(q.diff() ** 2 + r.diff() ** 2, [q, r], hol_coneqs=[q.diff() - r])
    with pytest.raises(MechanismError, match="hol_coneqs: a constraint must not depend on velocities"):
        read(method)


@pytest.mark.skipif(not hasattr(sympy.physics.mechanics, "System"), reason="sympy has System from 1.13 on")
def test_a_system_of_sympy_is_read_by_its_method() -> None:
    N = ReferenceFrame("N")
    system = sympy.physics.mechanics.System(N)
    point = Point("P")
    point.set_pos(system.fixed_point, q * N.x)
    point.set_vel(N, u * N.x)
    system.add_bodies(Particle("p", point, sympy.Integer(3)))
    system.add_coordinates(q)
    system.add_speeds(u)
    system.add_kdes(q.diff() - u)
    system.add_loads((point, -k * q * N.x))
    with pytest.raises(MechanismError, match=r"call form_eoms\(\) first"):
        read(system)
    system.form_eoms()
    found = read(system)
    assert (found.mass_matrix[0, 0], found.forces[0]) == (3, -k * q)


def test_accelerations_must_be_linear() -> None:
    with pytest.raises(MechanismError, match="not linear in the accelerations"):
        read((sympy.Matrix([[1 + q.diff(t, 2)]]), [g]), [q])
    with pytest.raises(MechanismError, match="not linear in the accelerations"):
        read(LagrangesMethod(q.diff() ** 2 * q.diff(t, 2), [q]))
