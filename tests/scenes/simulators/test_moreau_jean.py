"""Moreau's and Jean's steps: each solution obeys the laws of contact, and a flight is a parabola."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.mechanisms.load import load
from gspot_verified.scenes.simulators.contact_floats import Contact, contact_floats
from gspot_verified.scenes.simulators.moreau_jean import moreau_jean, solutions

FUNCTIONS = contact_floats(load("rod with a wrist"))
NUMBERS = st.floats(-3, 3, allow_nan=False)


@given(NUMBERS, NUMBERS, st.floats(0.1, 3), st.floats(0.1, 3), st.floats(-0.9, 0.9), st.floats(0, 2))
def test_every_solution_obeys_the_laws_of_contact(
    u: float, v: float, A: float, C: float, share: float, mu: float
) -> None:
    """Signorini: impulse >= 0, velocity >= 0, one of them 0; Coulomb: the cone, and against the slip."""
    B = share * math.sqrt(A * C)
    for normal, tangential in solutions(Contact(y=0, u=u, v=v, A=A, B=B, C=C, p=0, b=0, mu=mu)):
        after_n, after_t = v + C * normal + B * tangential, u + B * normal + A * tangential
        tolerance = 1e-9 * (1 + normal + abs(tangential))
        assert normal >= 0
        assert after_n >= -tolerance
        assert normal == 0 or abs(after_n) <= tolerance
        assert abs(tangential) <= mu * normal + tolerance
        if normal > 0 and abs(after_t) > tolerance:
            assert tangential == pytest.approx(-math.copysign(mu * normal, after_t))


def test_the_paradox_in_one_step() -> None:
    """p < 0: where v < 0 only an impulse that stops the slip serves; where v > 0 there are three solutions."""
    rod = Contact(y=0, u=1.0, v=-0.01, A=4.0, B=1.5, C=1.0, p=0, b=0, mu=1.0)
    ((normal, tangential),) = solutions(rod)
    assert abs(tangential) < normal
    assert len(solutions(replace(rod, v=0.01))) == 3


def test_a_rod_in_flight_falls_as_it_must() -> None:
    """Far above the surface no impulse is given, and the height is the parabola of gravity and of the push."""
    flight = moreau_jean(FUNCTIONS, [0.0, 9.0, 0.9, 1.0, 0.0, 0.0], step=1e-3, until=0.5)
    assert flight.forces is not None
    assert not any(flight.forces[1:])
    time, state = flight.times[-1], flight.states[-1]
    assert state[1] == pytest.approx(9 - (9.81 + 5) * time**2 / 2, abs=1e-3)
    assert state[0] == pytest.approx(time)


def test_time_may_be_a_component_of_the_state() -> None:
    """One coordinate far from the surface with the force -t: its velocity falls by t^2/2."""

    class Pushed:
        coordinates = 1

        def contact(self, _: object) -> Contact:
            return Contact(y=9.0, u=1.0, v=0.0, A=1.0, B=0.0, C=1.0, p=0.0, b=0.0, mu=0.0)

        def rates(self, state: list[float]) -> tuple[list[float], list[float], list[float]]:
            return [state[1], -state[2], 1.0], [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]

    run = moreau_jean(Pushed(), [2.0, 3.0, 0.0], step=1 / 64, until=0.5)  # type: ignore[arg-type]
    assert len(run.states[-1]) == 3
    assert run.states[-1] == pytest.approx([2 + 3 * 0.5 - 0.5**3 / 6, 3 - 0.5**2 / 2, 0.5], abs=1e-4)
