"""Mechanisms given by a mass matrix, by energies, by fields: shapes, and Lagrange's equations against sympy's."""

from __future__ import annotations

from typing import Any

import pytest
import sympy

from gspot_verified.mechanisms.formulas.in_sympy import to_sympy
from gspot_verified.mechanisms.input.given import from_energies, from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import Lagrangian, MechanismError

NAMES = sympy.symbols("q s q_dot s_dot t")
Q, S, Q_DOT, S_DOT, T = NAMES


def test_lagranges_equations_by_sympy() -> None:
    """Every term stands: a mass that depends on q and t, a gyroscopic term, a forced potential, damping, a force."""
    kinetic = (2 + sympy.sin(Q) ** 2) * Q_DOT**2 / 2 + Q * S * Q_DOT * S_DOT + (3 + T) * S_DOT**2 / 2 + S * T * Q_DOT
    potential = Q**2 * S + sympy.cos(S) * T
    loss = Q_DOT**2 / 2 + Q_DOT * S_DOT / 3
    given = from_energies(
        "body", ["q", "s"], str(kinetic).replace("**", "^"), str(potential).replace("**", "^"), "q", "s", 1,
        time="t", forces=["s_dot", "5*t"], dissipation=str(loss).replace("**", "^"),
    )  # fmt: skip
    assert given.state == ("q", "s", "q_dot", "s_dot", "t")
    motion = given.motion
    assert isinstance(motion, Lagrangian)
    assert (motion.coordinates, motion.time) == (("q", "s"), "t")
    for i, (place, rate, applied) in enumerate(((Q, Q_DOT, S_DOT), (S, S_DOT, 5 * T))):
        momentum = sympy.diff(kinetic, rate)
        turning = sum(sympy.diff(momentum, one) * speed for one, speed in ((Q, Q_DOT), (S, S_DOT), (T, 1)))
        force = applied - sympy.diff(loss, rate) + sympy.diff(kinetic - potential, place) - turning
        assert sympy.expand(force - to_sympy(motion.forces[i], given.state)) == 0
        for j, other in enumerate((Q_DOT, S_DOT)):
            entry = to_sympy(motion.mass_matrix[i][j], given.state)
            assert sympy.expand(sympy.diff(momentum, other) - entry) == 0


def test_without_forces_damping_and_time() -> None:
    given = from_energies("body", ["q"], "q_dot^2", "q^2", "q", "q", 1)
    assert given == lagrangian("body", ["q"], [[2]], ["-2*q"], "q", "q", 1)
    assert given.state == ("q", "q_dot")


BODY: dict[str, Any] = {
    "name": "body", "coordinates": ["q", "s"], "mass_matrix": [[1, 0], [0, 1]], "forces": [0, 0], "x": "q", "y": "s",
    "mu": 1,
}  # fmt: skip
ENERGIES: dict[str, Any] = {
    "name": "body", "coordinates": ["q", "s"], "kinetic": "q_dot^2 + s_dot^2", "potential": 0, "x": "q", "y": "s",
    "mu": 1,
}  # fmt: skip
FIELDS: dict[str, Any] = {
    "name": "body", "state": ["q", "s"], "F": ["s", 0], "G_T": [0, 0], "G_N": [0, 1], "x": 0, "y": "q", "mu": 1,
}  # fmt: skip


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"mass_matrix": [[1, 0]]}, "body: the mass matrix must have 2 rows of 2 formulas"),
        ({"mass_matrix": [[1, 0], [0, 1, 0]]}, "the mass matrix must have 2 rows of 2 formulas"),
        ({"mass_matrix": [[1, 0], "01"]}, "the mass matrix must have 2 rows of 2 formulas"),
        ({"mass_matrix": [[1, "q"], ["s", 1]]}, r"not symmetric: entry \(2, 1\) is s, entry \(1, 2\) is q"),
        ({"mass_matrix": [[1, 0], ["z", 1]]}, r"body: mass matrix entry \(2, 1\): unknown name 'z'"),
        ({"forces": [0]}, "body: 2 forces, one for each coordinate, got 1"),
        ({"forces": [0, "z"]}, "body: force 2: unknown name 'z'"),
        ({"constraints": ["q", "s"]}, "body: 2 constraints leave none of the 2 coordinates free"),
        ({"coordinates": []}, "body: between 1 and 12 coordinates, got 0"),
        ({"coordinates": [f"q{i}" for i in range(13)]}, "body: between 1 and 12 coordinates, got 13"),
    ],
)
def test_shapes_that_do_not_fit(change: dict[str, Any], message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        lagrangian(**BODY | change)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"forces": [0]}, "body: 2 forces, one for each coordinate, got 1"),
        ({"potential": "q + s_dot"}, "body: the potential energy must not depend on velocities"),
        ({"kinetic": "q_dot^3 + s_dot^2"}, "body: the kinetic energy must be quadratic in the velocities"),
        ({"kinetic": "z"}, "body: kinetic energy: unknown name 'z'"),
        ({"potential": "z"}, "body: potential energy: unknown name 'z'"),
        ({"dissipation": "z"}, "body: dissipation function: unknown name 'z'"),
        ({"constraints": ["q", "s"]}, "2 constraints leave none"),
    ],
)
def test_energies_that_do_not_fit(change: dict[str, Any], message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        from_energies(**ENERGIES | change)


@pytest.mark.parametrize("label", ["F", "G_T", "G_N"])
@pytest.mark.parametrize("wrong", [["s"], ["s", 0, 0], "q"])
def test_fields_that_do_not_fit(label: str, wrong: Any) -> None:
    with pytest.raises(MechanismError, match=f"body: {label} must have 2 formulas, one for each component"):
        from_fields(**FIELDS | {label: wrong})
    with pytest.raises(MechanismError, match=f"body: {label} must have 2 formulas"):
        from_fields(**FIELDS | {label: "qs"})


def test_entries_that_are_equal_when_multiplied_out_are_symmetric() -> None:
    found = lagrangian(**BODY | {"mass_matrix": [["4", "(q + 1)^2"], ["q^2 + 2*q + 1", "4"]]})
    assert isinstance(found.motion, Lagrangian)
    assert lagrangian(**BODY | {"constraints": ["q - s"]}).motion != found.motion
