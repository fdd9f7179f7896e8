"""One rigid body, known by numbers: those that its file gives, and what is none."""

from __future__ import annotations

import math

import pytest

from gspot_verified import from_sympy, load
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.contact_floats import contact_floats
from gspot_verified.scenes.simulators.planar_body import planar_model
from gspot_verified.scenes.simulators.planar_model import PlanarModel

START = (0.0, math.sin(0.8), 0.8, 5.0, 3.3 * math.cos(0.8), 3.3)


def the_rod() -> PlanarModel:
    return planar_model(None, contact_floats(load("rod with a wrist")), START)


def test_mass_inertia_and_arm_are_those_of_the_file() -> None:
    """m = l = 1, J = m l^2/3, mu = 3/2; the tip is X + cos(theta), Y - sin(theta): the angle counts from X to -Y."""
    rod = the_rod()
    ((link,), angle) = rod.bodies.links, rod.bodies.joints[2]
    assert (link.mass, link.inertia, rod.friction) == pytest.approx((1, 1 / 3, 1.5))
    assert (rod.order, angle.turn, angle.is_hinge) == ((0, 1, 2), -1, True)
    assert rod.bodies.point == pytest.approx((math.cos(0.8), -math.sin(0.8)))


def test_accelerations_are_of_gravity_push_and_wrist() -> None:
    """(-9.81 - 5)/m on Y, (-5 (theta - 0.9) - theta')/J on theta."""
    state = [0.3, 2.0, 1.1, 4.0, 1.0, -2.0]
    assert the_rod().accelerations(state) == pytest.approx([0, -14.81, 3 * (-5 * 0.2 + 2.0)])


def test_a_state_goes_there_and_back() -> None:
    rod, state = the_rod(), [0.3, 2.0, 1.1, 4.0, 1.0, -2.0]
    assert rod.places(START) == pytest.approx([0, 0, 0])
    assert rod.places(state)[2] == pytest.approx(0.3)
    assert rod.state(rod.places(state), rod.rates(state)) == pytest.approx(state)


def test_an_angle_from_x_to_y_in_another_order() -> None:
    import sympy
    from sympy.physics.mechanics import dynamicsymbols

    angle, high, far = dynamicsymbols("angle high far")
    contact = {"x": far - 2 * sympy.sin(angle), "y": high + 2 * sympy.cos(angle) + 1, "mu": 1}
    block = from_sympy((sympy.diag(4, 3, 3), [0, -7, 5]), coordinates=[angle, high, far], contact=contact)
    found = planar_model(None, contact_floats(block), [0.0, -3.0, 1.0, 0.0, 0.0, 1.0])
    ((link,), turn) = found.bodies.links, found.bodies.joints[2].turn
    assert (found.order, turn, link.mass, link.inertia) == ((2, 1, 0), 1, pytest.approx(3), pytest.approx(4))
    assert found.bodies.point == pytest.approx((0, 2))
    assert found.accelerations([0.0, -3.0, 1.0, 0.0, 0.0, 1.0]) == pytest.approx([5 / 3, -7 / 3, 0])


@pytest.mark.parametrize(
    ("masses", "x", "y", "mu", "message"),
    [
        ((3, 4, 2), "cos(angle)", "sin(angle)", "1", "the mass matrix diag"),  # moved as none is
        ((3, 3, 2), "cos(angle)", "2*sin(angle)", "1", "the mass matrix diag"),
        ((3, 3, 2), "cos(angle)", "sin(angle) + far/5", "1", "the mass matrix diag"),
        ((3, 3, 2), "0", "0", "1", "the mass matrix diag"),  # the mass centre touches
        ((3, 3, 2), "cos(2*angle)/4", "sin(2*angle)/2", "1", "the mass matrix diag"),  # right but for its length
        ((3, 3, 2), "cos(angle)", "sin(angle)", "1 + angle^2/9", "a constant friction coefficient"),
    ],
)
def test_what_is_no_such_body(masses: tuple[int, int, int], x: str, y: str, mu: str, message: str) -> None:
    from gspot_verified.mechanisms.input.given import lagrangian

    rows = [[masses[i] if i == j else 0 for j in range(3)] for i in range(3)]
    found = lagrangian(
        "body", ["far", "high", "angle"], rows, [0, -9, 0], y=f"high + {y}", mu=mu, x=f"far + {x}", parameters={}
    )
    with pytest.raises(SceneError, match=message):
        planar_model(None, contact_floats(found), [0.1, 0.2, 0.5, 1.0, 0.3, 0.4])


def test_other_numbers_of_coordinates() -> None:
    oscillator = contact_floats(load("oscillator"))
    with pytest.raises(SceneError, match="only one rigid body with two places and one angle"):
        planar_model(None, oscillator, [0.0] * len(oscillator.names))
