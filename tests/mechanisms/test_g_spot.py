"""G-spots: exact ones, found and proved ones, and points that are none."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.balls import working_bits
from gspot_verified.expansion.recursion import Recursion
from gspot_verified.expansion.system import GSpotError
from gspot_verified.mechanisms.g_spot import find_g_spot
from gspot_verified.mechanisms.given import from_fields, lagrangian
from gspot_verified.mechanisms.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.symbolic import symbolic_system


def holds(ball: arb, number: fmpq) -> bool:
    """Whether the ball contains p/q: exact integers, because contains() rounds a rational first."""
    return bool(ball.is_finite() and (ball * number.q - number.p).contains(0))


SPOT: dict[str, Any] = {
    "X": 0, "Y": "3/5", "theta": "theta_ref", "X_dot": 2, "Y_dot": "4/5", "theta_dot": 1,
}  # fmt: skip


def rod(place: dict[str, Any] | None = None, **options: Any) -> Mechanism:
    return lagrangian(
        "rod", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]], [0, "-3/5", 0], "X + cos(theta)",
        "Y - sin(theta)", "73/36", {}, {"theta": ("3/5", "4/5")}, SPOT | (place or {}), **options,
    )  # fmt: skip


def test_fixed_components_are_chosen() -> None:
    spot = find_g_spot(rod())
    assert spot.exact
    assert spot.fixed == ("X", "X_dot")


@pytest.mark.parametrize(
    ("place", "part"),
    [
        ({"Y": "4/5"}, "y = 1/5"),
        ({"Y_dot": 0}, "v = -4/5"),
        ({"theta_dot": 2}, "b = 9/5"),
        ({"theta_dot": -1}, "v = "),
    ],
)
def test_points_that_are_no_g_spots(place: dict[str, Any], part: str) -> None:
    with pytest.raises(GSpotError, match=f"not a G-spot: {part}"):
        find_g_spot(rod(place))


def test_a_missing_value_is_named() -> None:
    mechanism = lagrangian("block", ["X", "Y"], [[1, 0], [0, 1]], [0, 0], "X", "Y", 1, place={"X": 0})
    with pytest.raises(GSpotError, match="lacks a value for Y, X_dot, Y_dot"):
        find_g_spot(mechanism)


@pytest.mark.parametrize(
    ("options", "part"),
    [
        ({"fixed": ["X"]}, "2 components must be fixed"),
        ({"fixed": ["X", "X"]}, "2 components must be fixed"),
        ({"fixed": ["X", "theta"]}, "degenerate: the Jacobian"),
        ({"fixed": ["Y", "Y_dot"]}, "degenerate: the Jacobian"),
        ({"conditions": ["X"]}, "2 conditions J are needed, got 1"),
        ({"conditions": ["X", "X_dot"]}, "the condition J_2 = 2 must be 0"),
        ({"conditions": ["X", "X^2"]}, "degenerate"),
    ],
)
def test_wrong_conditions(options: dict[str, Any], part: str) -> None:
    with pytest.raises(GSpotError, match=part):
        find_g_spot(rod(**options))


@pytest.mark.parametrize(
    ("place", "part"), [({"Y": "4/5"}, "y = 1/5"), ({"Y_dot": 0}, "v = -4/5"), ({"theta_dot": 2}, "b = 9/5")]
)
def test_points_that_are_no_g_spots_with_conditions_that_hold(place: dict[str, Any], part: str) -> None:
    """The conditions J are met there, p = b = y = v = 0 are not."""
    with pytest.raises(GSpotError, match=f"not a G-spot: {part}"):
        find_g_spot(rod(place, conditions=["X", "X_dot - 2"]))


def test_a_state_of_fewer_than_4_components() -> None:
    mass = lagrangian("mass", ["Y"], [[1]], [0], "Y", "Y", 1, place={"Y": 0, "Y_dot": 0})
    with pytest.raises(GSpotError, match="p, b, y and v need a state of 4 components at least"):
        find_g_spot(mass)


def test_angles_are_shown_from_their_references() -> None:
    assert find_g_spot(rod()).values()["theta"] == "theta_ref"
    near = find_g_spot(rod({"theta": "theta_ref + 1/50"}, search=True)).values()["theta"]
    assert near.startswith("theta_ref + [")


def test_conditions_given_as_functions() -> None:
    spot = find_g_spot(rod(conditions=["X + theta - theta_ref", "X_dot^2 - 4"]))
    assert spot.exact
    Recursion(spot.system).advance()


def fields(p: str = "p", **options: Any) -> Mechanism:
    """The extended system with a function of p in the place of p."""
    return from_fields(
        "fields", ["x", "u", "y", "v", "p", "b"], ["u", 0, "v", "b", -1, -1],
        [0, f"3/(2*(1 - {p}))", 0, "1/2", 0, f"-3/4/(1 - {p})"], [0, "1/2", 0, f"(1 + {p})/2", 0, "3/4"],
        "x", "y", f"1 - {p}", **options,
    )  # fmt: skip


def test_degenerate_for_every_choice() -> None:
    """p^3 has no gradient at the G-spot, so no J makes the Jacobian regular."""
    here = {"x": 0, "u": 1, "y": 0, "v": 0, "p": 0, "b": 0}
    assert find_g_spot(fields(place=here)).exact
    with pytest.raises(GSpotError, match=r"degenerate: .* p, b, y, v have rank 3 there, not 4"):
        find_g_spot(fields("p^3", place=here))


def test_a_search_starts_where_no_g_spot_is() -> None:
    """At an exact place: without a search it is refused, with one the exact check must not stop the search."""
    near = {"x": 0, "u": 1, "y": "1/50", "v": "-1/40", "p": "1/30", "b": "1/20"}
    with pytest.raises(GSpotError, match="not a G-spot: p = 1/30"):
        find_g_spot(fields(place=near))
    found = find_g_spot(fields(place=near, fixed=["x", "u"], search=True))
    assert not found.exact
    for ball, number in zip(found.system.point, (0, 1, 0, 0, 0, 0), strict=True):
        assert holds(ball, fmpq(number))


def test_a_place_that_is_no_g_spot() -> None:
    block = lagrangian("block", ["X", "Y"], [[1, 0], [0, 1]], [0, 0], "X", "Y", 0,
                       place={"X": 0, "Y": 0, "X_dot": 1, "Y_dot": 0})  # fmt: skip
    with pytest.raises(GSpotError, match="not a G-spot: p = 1 must be 0"):
        find_g_spot(block)


def test_a_search_finds_the_exact_one_and_proves_it() -> None:
    exact = find_g_spot(rod())
    near = rod({"theta": "theta_ref + 1/50", "theta_dot": "51/50", "Y": "31/50"}, search=True)
    for bits in (64, 256):
        found = find_g_spot(near, bits)
        assert not found.exact
        assert found.fixed == ("X", "X_dot")
        with working_bits(bits + 40):
            for ball, number in zip(found.system.point, exact.system.point, strict=True):
                assert holds(ball, number)
                assert ball.rad() < arb(2) ** (-bits)


def test_an_irrational_place_is_proved() -> None:
    """The same rod in other units: theta_dot = sqrt(5/3) for g = 1."""
    mechanism = lagrangian(
        "rod", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]], [0, -1, 0], "X + cos(theta)",
        "Y - sin(theta)", "73/36", {}, {"theta": ("3/5", "4/5")},
        SPOT | {"theta_dot": "sqrt(5/3)", "Y_dot": "4/5*sqrt(5/3)"},
    )  # fmt: skip
    found = find_g_spot(mechanism)
    assert not found.exact
    with working_bits(160):
        assert (found.system.point[5] * found.system.point[5] * 3 - 5).contains(0)


@pytest.mark.parametrize("value", ["sqrt(2)", "exp(1)", "sin(1)"])
def test_an_irrational_place_that_is_no_g_spot(value: str) -> None:
    with pytest.raises(GSpotError, match="not a G-spot"):
        find_g_spot(rod({"Y": value}))


@pytest.mark.parametrize("value", ["sqrt(-1)", "1/(exp(1) - exp(1))", "exp(10^9)^9"])
def test_a_place_that_is_no_number(value: str) -> None:
    with pytest.raises((GSpotError, MechanismError)):
        find_g_spot(rod({"Y": value}))


def test_no_g_spot_near_the_start() -> None:
    """Friction below 4/3: p has no zero."""
    with pytest.raises(GSpotError, match="no G-spot"):
        find_g_spot(shipped_mechanism("genot_brogliato_rod", mu="13/10"))


def test_a_bare_reference_angle_makes_the_place_irrational() -> None:
    mechanism = lagrangian(
        "rod", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]], ["theta", "-3/5", 0], "X + cos(theta)",
        "Y - sin(theta)", "73/36", {}, {"theta": ("3/5", "4/5")}, SPOT,
    )  # fmt: skip
    found = find_g_spot(mechanism)
    assert not found.exact
    with working_bits(200):
        Recursion(found.system).advance()


def test_a_parameter_without_a_value() -> None:
    with pytest.raises(MechanismError, match="without a value: chi"):
        find_g_spot(shipped_mechanism("extended", chi=None))


def test_symbols_give_the_papers_example() -> None:
    """Sec. 5, the example after Theorem 1: the first terms of p and b in chi."""
    recursion = Recursion(symbolic_system(shipped_mechanism("extended", chi=None)))
    for _ in range(7):
        recursion.advance()
    assert str(recursion.p[6].coefficients()) == "[0, -96*chi^3, 0, 0, 3*chi^3]"
    assert str(recursion.b[4].coefficients()) == "[-96*chi^2, 0, 0, 12*chi^2]"


def test_a_point_that_is_no_g_spot_for_all_parameters() -> None:
    with pytest.raises(GSpotError, match="not a G-spot for all parameters: p = "):
        symbolic_system(shipped_mechanism("oscillator", mu=None))


def test_sympy_is_loaded_late() -> None:
    script = (
        "import sys, gspot_verified.mechanisms.classify, gspot_verified.mechanisms.oscillator_formulas;"
        "print('sympy' in sys.modules)"
    )
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "False"
