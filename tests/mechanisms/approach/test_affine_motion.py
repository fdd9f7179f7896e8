"""Mechanisms with affine alphas are found as such (proofs/from_state.md, section 8)."""

from __future__ import annotations

from pathlib import Path

import pytest
from flint import fmpq

from gspot_verified import load, mechanism_side
from gspot_verified.expansion.from_state.affine_system import Affine
from gspot_verified.mechanisms.approach.affine_motion import affine_system_of, with_explicit


def test_the_extended_system_is_affine() -> None:
    """alpha_1 = -1 + chi b; its formulas hold factors 1 - p that cancel."""
    found = affine_system_of(load("extended system"))
    assert found is not None
    names, system = found
    assert names == ("p", "b")
    assert system.alpha_1 == Affine(fmpq(-1), fmpq(0), fmpq(1))
    assert system.alpha_2 == Affine(fmpq(-1))
    assert system.alpha_3 == Affine(fmpq(-3, 2))


@pytest.mark.parametrize("name", ["oscillator", "falling rod"])
def test_other_mechanisms_are_not(name: str) -> None:
    assert affine_system_of(load(name)) is None


def test_without_p_and_b_as_rational_numbers_nothing_is_added() -> None:
    """A state far away says by what it fails."""
    mechanism = load("extended system")
    state = {"x": 0, "u": 1, "p": "1/5", "b": "-1/50"}
    found = mechanism_side(mechanism, state)
    assert found.explicit is None
    assert with_explicit(found, mechanism, {"x": 0, "u": 1, "y": 0, "v": 0}).explicit is None
    told = with_explicit(found, mechanism, state)
    assert told.explicit is not None
    assert told.explicit.side is None
    assert "explicit epsilon_0 (proofs/from_state.md, section 8): undecided" in str(told)
    assert told.to_json()["explicit"] is not None


_ANGLE = """
format = 1
name = "p is an angle, counted from its reference"
[fields]
state = ["x", "u", "y", "v", "phi", "b"]
F = ["u", 0, "v", "b", "-1 + b", "-1"]
G_T = [0, "3/(2*(1 - phi + phi_ref))", 0, "1/2", 0, "-3/(4*(1 - phi + phi_ref))"]
G_N = [0, "1/2", 0, "(1 + phi - phi_ref)/2", 0, "3/4"]
[angles.phi]
sine = "3/5"
cosine = "4/5"
[contact]
x = "x"
y = "y"
mu = "1 - phi + phi_ref"
[g_spot]
fixed = ["x", "u"]
[g_spot.point]
u = 1
phi = "phi_ref"
"""


def test_an_angle_is_not_taken_for_p(tmp_path: Path) -> None:
    """phi = 1/100 is p = 1/100 - phi_ref there: another state than the one that would be proved."""
    file = tmp_path / "angle.toml"
    file.write_text(_ANGLE)
    assert affine_system_of(load(file)) is None
