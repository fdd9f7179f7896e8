"""The two components that y = v = 0 determine, against formulas by hand."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.balls import working_bits
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.slip_state import StateError, slip_state
from gspot_verified.mechanisms.to_system import shift

OSCILLATOR = shipped_mechanism("frictional impact oscillator")


@pytest.mark.parametrize("bits", [64, 160, 400])
def test_the_oscillators_contact(bits: int) -> None:
    """psi = cos(phi) - 1, psi_dot = -sin(phi) phi_dot."""
    with working_bits(bits):
        found = slip_state(shift(OSCILLATOR), {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"})
        phi = arb(fmpq(3, 5)).acos() + arb(fmpq(1, 10))
        assert found.solved == ("psi", "psi_dot")
        assert all(side.is_finite() and side.rad() < arb(2) ** (24 - bits) for side in found.box)
        assert found.box[0].contains(fmpq(1, 10))
        assert found.box[1].overlaps(phi.cos() - 1)
        assert found.box[3].overlaps(phi.sin() * fmpq(9, 10))


def test_an_angle_that_is_solved_for() -> None:
    """phi from psi = cos(phi) - 1: the solution next to the G-spot."""
    with working_bits(160):
        found = slip_state(shift(OSCILLATOR), {"psi": "-2/5", "phi_dot": "-1"})
        assert found.solved == ("phi", "psi_dot")
        assert found.box[0].contains(0)
        assert found.box[0].rad() < 1e-30
        assert found.box[3].contains(fmpq(4, 5))


def test_no_solution() -> None:
    with working_bits(100), pytest.raises(StateError, match="do not certainly determine phi and psi_dot"):
        slip_state(shift(OSCILLATOR), {"psi": "1", "phi_dot": "-1"})


def test_balls_are_taken_whole() -> None:
    with working_bits(100):
        found = slip_state(shift(OSCILLATOR), {"phi": "phi_ref", "psi": "-2/5", "phi_dot": "-1", "psi_dot": "4/5"})
        assert found.solved == ()
        assert found.box[0].contains(0)
