"""G-spots: exact ones, found and proved ones, and points that are none."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from typing import Any

import pytest
from flint import arb, fmpq, fmpq_mat
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.expansion.series.recursion import Recursion
from gspot_verified.expansion.series.system import GSpotError, System
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.formulas.simplify import constant, product_of, sum_of
from gspot_verified.mechanisms.input.given import from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots
from gspot_verified.mechanisms.spots.classify import classify
from gspot_verified.mechanisms.spots.classify_all import classify_all
from gspot_verified.mechanisms.spots.critical_friction import critical_friction
from gspot_verified.mechanisms.spots.g_spot import _choose_fixed, find_g_spot, prove_near, symbolic_place
from gspot_verified.mechanisms.symbolic import symbolic_system
from gspot_verified.mechanisms.zeros.newton import NotFoundError
from gspot_verified.numbers.balls import MAX_WORKING_BITS, working_bits


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
        ({"fixed": ["X", "X", "X_dot"]}, "2 components must be fixed"),
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
    assert find_g_spot(rod()).to_json()["theta"] == "theta_ref"
    near = find_g_spot(rod({"theta": "theta_ref + 1/50"}, search=True)).to_json()["theta"]
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
        assert found.bits >= bits
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


def with_slider(mass: int, place: dict[str, Any], **options: Any) -> Mechanism:
    """The rod, half of its mass along X on a slider W of its own, which a constraint may tie to it."""
    tied = "constraints" in options
    return lagrangian(
        "rod", ["X", "Y", "theta", "W"],
        [["1/2" if tied else 1, 0, 0, 0], [0, 1, 0, 0], [0, 0, "1/3", 0], [0, 0, 0, "1/2" if tied else mass]],
        [0, "-3/5", 0, 0], "X + cos(theta)", "Y - sin(theta)", "73/36", {}, {"theta": ("3/5", "4/5")},
        SPOT | {"W": 1, "W_dot": 2} | place, **options,
    )  # fmt: skip


@pytest.mark.parametrize("search", [False, True])
def test_a_constraint_and_its_rate_come_before_the_fixed_components(search: bool) -> None:
    start = {"X": "1/50"} if search else {}  # the constraint does not hold there
    found = find_g_spot(with_slider(1, start, constraints=["W - X - 1"], search=search))
    assert (found.exact, found.fixed, len(found.system.J)) == (not search, ("W", "W_dot"), 4)
    with working_bits(160):
        X, W = found.system.point[0], found.system.point[3]
        assert holds(W - X, fmpq(1)) if search else W - X == 1
    with pytest.raises(GSpotError, match="the condition J_1 = 1 must be 0"):
        find_g_spot(with_slider(1, {"W": 2}, constraints=["W - X - 1"]))


@pytest.mark.parametrize("search", [False, True])
def test_the_mass_matrix_is_checked_where_p_b_y_v_do_not_feel_it(search: bool) -> None:
    """A slider that nothing touches: of a negative mass."""
    assert find_g_spot(with_slider(1, {}, search=search)).exact is not search
    with pytest.raises(MechanismError, match="not positive definite at the G-spot: its leading minor of size 4"):
        find_g_spot(with_slider(-1, {}, search=search))


def test_a_number_that_is_not_rational_in_the_fields_alone() -> None:
    """p, b, y, v and J are rational at the point, F is not: the expansion could not be exact."""
    irrational = from_fields(
        "fields", ["x", "u", "y", "v", "p", "b"], ["u", "sqrt(2)", "v", "b", -1, -1],
        [0, "3/(2*(1 - p))", 0, "1/2", 0, "-3/4/(1 - p)"], [0, "1/2", 0, "(1 + p)/2", 0, "3/4"], "x", "y", "1 - p",
        place={"x": 0, "u": 1, "y": 0, "v": 0, "p": 0, "b": 0},
    )  # fmt: skip
    found = find_g_spot(irrational)
    assert not found.exact
    with working_bits(found.bits):
        (root,) = found.system.values_at_point([found.system.F[1]])
        assert root.is_finite()
        assert (root * root - 2).contains(0)


def test_a_search_from_where_a_root_has_no_value() -> None:
    with pytest.raises(GSpotError, match="rod: no G-spot found: "):
        find_g_spot(lagrangian(
            "rod", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]], [0, "-3/5", 0], "X + cos(theta)",
            "Y - sin(theta)", "sqrt(X - 1)", {}, {"theta": ("3/5", "4/5")}, SPOT, search=True,
        ))  # fmt: skip


def test_a_search_from_a_place_that_divides_by_zero() -> None:
    block = lagrangian(
        "block", ["X", "Y"], [[1, 0], [0, 1]], [0, 0], "X", "Y", 1, {"a": 0},
        place={"X": "1/a", "Y": 0, "X_dot": 1, "Y_dot": 0}, search=True,
    )  # fmt: skip
    with pytest.raises(MechanismError, match=r"block: .*division by zero"):
        find_g_spot(block)


def test_a_search_with_degenerate_conditions() -> None:
    with pytest.raises(GSpotError, match=r"rod: degenerate: the Jacobian .* not certainly regular during the search"):
        find_g_spot(rod(fixed=["Y", "Y_dot"], search=True))


def test_a_box_without_a_proof_is_no_g_spot(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gspot_verified.mechanisms.spots.g_spot.proved_box", lambda *_: None)
    with pytest.raises(NotFoundError, match="rod: no G-spot could be proved near"):
        find_g_spot(rod(search=True))


@given(st.lists(st.lists(st.integers(-2, 2), min_size=7, max_size=7), min_size=4, max_size=5))
def test_the_fixed_components_are_those_without_a_pivot(rows: list[list[int]]) -> None:
    """For linear p, b, y, v and possibly a constraint, against the reduced echelon form of FLINT."""
    count = len(rows)
    functions: list[Expression] = [
        sum_of(*(product_of(constant(a), Variable(j)) for j, a in enumerate(row))) for row in rows
    ]
    p, b, y, v = functions[:4]
    zero = constant(0)
    J = (*functions[4:], Variable(0), Variable(1), Variable(2))[:3]
    system = System("linear", (zero,) * 7, (zero,) * 7, y, v, p, b, zero, zero, zero, J, (fmpq(0),) * 7)
    reduced, rank = fmpq_mat(count, 7, [fmpq(a) for row in rows for a in row]).rref()
    pivots = [next(j for j in range(7) if reduced[i, j] != 0) for i in range(rank)]
    if rank < count:
        names = "p, b, y, v" if count == 4 else "p, b, y, v and the constraints"
        with pytest.raises(GSpotError, match=f"J: {names} have rank {rank} there, not {count}"):
            _choose_fixed(system, "abcdefg", count)
    else:
        assert _choose_fixed(system, "abcdefg", count) == tuple("abcdefg"[j] for j in range(7) if j not in pivots)


def test_a_constraint_that_leaves_no_room() -> None:
    block = lagrangian(
        "block", ["X", "Y"], [[1, 0], [0, 1]], [0, 0], "X", "Y", 1, constraints=["X"],
        place={"X": 0, "Y": 0, "X_dot": 0, "Y_dot": 0},
    )  # fmt: skip
    with pytest.raises(GSpotError, match="the constraints leave no room for the conditions p = b = y = v = 0"):
        find_g_spot(block)


def test_a_place_may_give_some_components() -> None:
    some = lagrangian("block", ["X", "Y"], [[1, 0], [0, 1]], [0, 0], "X", "Y", 1, place={"Y": "1/2", "X_dot": 3})
    assert symbolic_place(shift(some)) == {"Y": constant(fmpq(1, 2)), "X_dot": constant(3)}


def test_a_start_that_is_not_finite_is_named() -> None:
    start = dict.fromkeys(rod().state, arb(0)) | {"Y": arb("nan")}
    with pytest.raises(GSpotError, match="the G-spot's place is not finite"):
        prove_near(shift(rod()), start, 64)


def test_sympy_is_loaded_late() -> None:
    script = (
        "import sys, gspot_verified.mechanisms.spots.classify, gspot_verified.paper.numerics.oscillator_formulas;"
        "print('sympy' in sys.modules)"
    )
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "False"


@pytest.mark.parametrize("bits", ["128", True, 128.0, None, 1])
@pytest.mark.parametrize("function", [find_g_spot, classify, classify_all, find_g_spots, critical_friction])
def test_bits_that_are_no_number_of_bits_are_refused(function: Callable[..., Any], bits: Any) -> None:
    with pytest.raises(ValueError, match=f"bits must be an int in 2..{MAX_WORKING_BITS}, got {bits!r}"):
        function(shipped_mechanism("frictional impact oscillator"), bits=bits)
