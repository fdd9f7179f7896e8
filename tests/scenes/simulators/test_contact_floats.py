"""The numbers of a contact and the fields of its mechanism, against those worked out by hand."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.load import load
from gspot_verified.scenes.simulators.contact_floats import contact_floats

PLAIN = """
format = 1
name = "plain"
[lagrangian]
coordinates = ["X", "H"]
mass_matrix = [[2, 1], [1, 3]]
forces = ["-X", "-1 - H_dot"]
[contact]
x = "X"
y = "2*H"
mu = "1/3"
"""


def plain(folder: Path, text: str = PLAIN) -> Mechanism:
    (folder / "plain.toml").write_text(text)
    return load(folder / "plain.toml")


def test_the_numbers_of_a_linear_mechanism(tmp_path: Path) -> None:
    """M^-1 = (3, -1; -1, 2)/5, dx/dq = (1, 0), dy/dq = (0, 2)."""
    found = contact_floats(plain(tmp_path))
    contact = found.contact([0.5, 0.25, 3.0, 0.75])
    assert vars(contact) == pytest.approx({
        "y": 0.5, "u": 3.0, "v": 1.5, "A": 3 / 5, "B": -2 / 5, "C": 8 / 5, "p": 8 / 5 + 2 / 15,
        "b": 2 * (0.5 - 2 * 1.75) / 5, "mu": 1 / 3,
    })  # fmt: skip
    free, tangent, upward = found.rates([0.5, 0.25, 3.0, 0.75])
    assert free == pytest.approx([3.0, 0.75, (-3 * 0.5 + 1.75) / 5, (0.5 - 2 * 1.75) / 5])
    assert tangent == pytest.approx([0, 0, 3 / 5, -1 / 5])
    assert upward == pytest.approx([0, 0, -2 / 5, 4 / 5])
    assert (found.names, found.coordinates, found.references) == (("X", "H", "X_dot", "H_dot"), 2, (0, 0, 0, 0))


def test_an_angle_is_counted_from_its_reference(tmp_path: Path) -> None:
    turned = PLAIN.replace('"X", "H"', '"X", "th"').replace('"2*H"', '"sin(th)"').replace("H_dot", "th_dot")
    found = contact_floats(plain(tmp_path, turned.replace("[lagr", '[angles.th]\nsine = "3/5"\ncosine = "4/5"\n[lagr')))
    assert found.references == (0, pytest.approx(math.asin(0.6)), 0, 0)
    assert found.contact([9.0, 0.7, 0.0, 2.0]).y == pytest.approx(math.sin(0.7))
    assert found.contact([9.0, 0.7, 0.0, 2.0]).v == pytest.approx(2 * math.cos(0.7))
    with pytest.raises(ValueError, match="longer"):
        found.contact([9.0, 0.7, 0.0])


def test_a_mechanism_without_velocities_is_refused() -> None:
    with pytest.raises(MechanismError, match="need coordinates and velocities, not fields of a state"):
        contact_floats(load("model"))
