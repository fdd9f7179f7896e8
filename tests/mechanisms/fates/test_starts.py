"""Boxes of initial states on the contact, and which are none (proofs/fates.md, section 1)."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.mechanisms.approach.slip_state import StateError
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.fates import starts as module
from gspot_verified.mechanisms.fates.starts import Starts, _solved_once
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import working_bits

ROD, OSCILLATOR = shipped_mechanism("rod"), shipped_mechanism("oscillator")
GIVEN: dict[str, Any] = {"X": 0, "X_dot": 5}


def test_an_angle_is_counted_from_its_reference() -> None:
    """sin = 3/5 at the reference of the falling rod: what is found is theta less it, and Y = sin theta."""
    with working_bits(64):
        starts = Starts(shift(ROD), GIVEN, ["theta", "theta_dot"])
        found = starts.whole([fmpq(7, 10), fmpq(3)], [fmpq(8, 10), fmpq(4)])
        assert found is not None
        reference = arb("0.6").asin()
        assert abs((found[2] + reference).lower() - arb("0.7")) < arb("1e-8")
        assert abs((found[2] + reference).upper() - arb("0.8")) < arb("1e-8")
        assert found[5].contains(3)
        assert found[5].contains(4)
        assert found[1].overlaps(arb("0.75").sin())


@pytest.mark.parametrize(
    ("given", "names", "message"),
    [
        ({**GIVEN, "Q": 0}, ["theta", "theta_dot"], "'Q' is no component of the state; it has: X, Y, theta"),
        (GIVEN, ["theta", "phi"], "'phi' is no component"),
        ({**GIVEN, "theta": 0}, ["theta", "theta_dot"], "theta is given and varies, too"),
        ({"X": 0, "theta": 0, "X_dot": 0}, ["X", "X_dot", "theta"], "X is given and varies, too"),
        (GIVEN, ["theta"], "leave out two components, .*; left out: Y, Y_dot, theta_dot"),
        ({**GIVEN, "Y": 0}, ["theta", "theta_dot"], "left out: Y_dot"),
        ({**GIVEN, "Y": 0, "Y_dot": 0}, ["theta", "theta_dot"], "left out: none"),
    ],
)
def test_names_that_are_refused(given: dict[str, Any], names: list[str], message: str) -> None:
    with pytest.raises(StateError, match=message):
        Starts(shift(ROD), given, names)


def test_several_solutions_and_constraints_are_refused() -> None:
    with working_bits(64), pytest.raises(StateError, match="may have several solutions in theta and theta_dot"):
        Starts(shift(ROD), {"X": 0, "X_dot": 5}, ["Y", "Y_dot"])
    held: Any = SimpleNamespace(mechanism=ROD, constraints=("held",))
    with pytest.raises(StateError, match="no sweep over the states of a mechanism with constraints"):
        Starts(held, GIVEN, ["theta", "theta_dot"])


def test_where_the_contact_does_not_certainly_determine_two_there_is_no_box(monkeypatch: pytest.MonkeyPatch) -> None:
    with working_bits(64):
        starts = Starts(shift(ROD), GIVEN, ["theta", "theta_dot"])
        monkeypatch.setattr(module, "solved_components", lambda *_: None)
        assert starts.whole([fmpq(0), fmpq(0)], [fmpq(1), fmpq(1)]) is None


def test_when_the_contact_has_one_solution_at_most() -> None:
    """y holds one of x_0, x_1 alone and is affine in it, v is affine in the other."""
    x, y, z = (Variable(i) for i in range(3))
    two = Constant(fmpq(2))

    def once(height: Expression, speed: Expression) -> bool:
        return _solved_once([height, speed], [0, 1])

    assert once(two * x + z * z, z * y + x * x)
    assert once(z * y, x + y * y * y)
    assert once(z * z, y)  # y does not hold it at all: then the Jacobian is singular, which is asked elsewhere
    assert not once(x * x + z, y)
    assert not once(x, y * y)
    assert not once(x + y, y)
    assert not once(x + y, x)
    assert not once(y * y, x * x)
