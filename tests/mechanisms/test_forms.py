"""What the literature writes: the same mechanism in another form has the same G-spot and the same alphas, exactly."""

from __future__ import annotations

from typing import Any

import pytest
from flint import fmpq

from gspot_verified.expansion.series.recursion import Recursion
from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.mechanisms.approach.slip_state import StateError, slip_state
from gspot_verified.mechanisms.derive.lie_derivatives import (
    Reader,
    check_lagrangian_conditions,
    derive,
    vanishes_identically,
)
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.formulas.simplify import minus, rational_value
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.given import from_energies, from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.iwc import iwc
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.classify import classify
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.numbers.balls import working_bits
from gspot_verified.testing import check_expansion

ROD: dict[str, Any] = {
    "name": "rod", "coordinates": ["X", "Y", "theta"], "mass_matrix": [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]],
    "forces": [0, "-3/5", 0], "x": "X + cos(theta)", "y": "Y - sin(theta)", "mu": "73/36",
    "angles": {"theta": ("3/5", "4/5")},
    "place": {"X": 0, "Y": "3/5", "theta": "theta_ref", "X_dot": 2, "Y_dot": "4/5", "theta_dot": 1},
}  # fmt: skip
ALPHA = [fmpq(-55, 12), fmpq(4, 5), fmpq(-3, 2)]
"""Of the rod, alpha_1, alpha_2, alpha_3: as in the docstring of classify."""


def alphas(mechanism: Mechanism) -> list[Any]:
    found = classify(mechanism)
    assert found.exact
    return [found.alpha_1, found.alpha_2, found.alpha_3]


def same_by_sympy(mechanism: Mechanism) -> None:
    """The second route has the same functions: sympy proves that the differences vanish."""
    second = derive(mechanism)
    check_lagrangian_conditions(mechanism, second)
    assert not mechanism.angles
    f = shift(mechanism).functions
    read = Reader(mechanism)
    for letter in ("u", "v", "a", "b", "A", "B", "C", "p", "alpha_1", "alpha_2", "alpha_3"):
        assert vanishes_identically(read(getattr(f, letter)) - getattr(second, letter)), letter


def test_negative_slip_is_mirrored_and_said() -> None:
    """The rod seen from behind: x counts the other way, slip is negative."""
    seen = {"x": "X - cos(theta)", "slip": "negative"}
    place = ROD["place"] | {"X_dot": -2}
    mirrored = lagrangian(**ROD | seen | {"place": place})
    assert alphas(mirrored) == ALPHA
    found = classify(mirrored)
    assert found.slip_velocity == fmpq(7, 5)
    assert any("negative slip: mirrored, x counts" in note for note in found.notes)
    assert "note: negative slip: mirrored" in str(found)
    assert found.to_json()["notes"] == list(found.notes)
    assert classify(lagrangian(**ROD)).notes == ()
    with pytest.raises(GSpotError, match="not a G-spot"):
        find_g_spot(lagrangian(**ROD | seen | {"place": place, "slip": "positive"}))


def test_negative_slip_of_fields_turns_the_tangential_direction() -> None:
    extended: dict[str, Any] = {
        "name": "fields", "state": ["x", "u", "y", "v", "p", "b"], "F": ["u", 0, "v", "b", -1, -1],
        "G_T": [0, "3/(2*(1 - p))", 0, "1/2", 0, "-3/4/(1 - p)"], "G_N": [0, "1/2", 0, "(1 + p)/2", 0, "3/4"],
        "x": "x", "y": "y", "mu": "1 - p", "place": {"x": 0, "u": 1, "y": 0, "v": 0, "p": 0, "b": 0},
    }  # fmt: skip
    wanted = alphas(from_fields(**extended))
    other = extended | {"x": "-x", "G_T": [0, "-3/(2*(1 - p))", 0, "-1/2", 0, "3/4/(1 - p)"], "slip": "negative"}
    assert alphas(from_fields(**other)) == wanted
    with pytest.raises(GSpotError, match="p ="):
        find_g_spot(from_fields(**other | {"slip": "positive"}))


def test_the_slip_velocity_in_the_place_of_x() -> None:
    velocity = {"x": None, "slip_velocity": "X_dot - sin(theta)*theta_dot"}
    assert alphas(lagrangian(**ROD | velocity)) == ALPHA
    mirrored = velocity | {"slip_velocity": "sin(theta)*theta_dot - X_dot", "slip": "negative"}
    assert alphas(lagrangian(**ROD | mirrored)) == ALPHA
    assert "the slip velocity counts" in lagrangian(**ROD | mirrored).notes[0]


def test_a_moving_belt_changes_the_slip_velocity_alone() -> None:
    """The classical rod on a belt (the surface moves with 3): the alphas are those at rest, u is less by 3."""
    belt = lagrangian(**ROD | {"x": None, "slip_velocity": "X_dot - sin(theta)*theta_dot - 3"})
    found = classify(belt)
    assert alphas(belt) == ALPHA
    assert found.slip_velocity == fmpq(7, 5) - 3
    assert any("u < 0" in warning for warning in found.warnings)
    moving = classify(lagrangian(**ROD | {"x": None, "slip_velocity": "X_dot - sin(theta)*theta_dot + 3"}))
    assert (moving.slip_velocity, moving.warnings) == (fmpq(22, 5), ())


ROLLING: dict[str, Any] = {
    "name": "wheel on a rod", "coordinates": ["X", "Y", "theta", "wheel"],
    "mass_matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, "1/3", 0], [0, 0, 0, "1/50"]], "forces": [0, "-3/5", 0, 0],
    "x": None, "slip_velocity": "X_dot - sin(theta)*theta_dot + wheel_dot/5", "y": "Y - sin(theta)", "mu": 2,
}  # fmt: skip


def test_a_rolling_contact_by_hand() -> None:
    """A wheel of radius 1/5 at the rod's end: A gains radius^2/inertia = 2, B and C are those of the rod."""
    f = shift(lagrangian(**ROLLING)).functions
    rod = shift(lagrangian(**ROD | {"angles": None, "place": None, "mu": 2})).functions
    assert rational_value(minus(f.A, rod.A)) == 2
    assert f.B is rod.B
    assert f.C is rod.C
    same_by_sympy(lagrangian(**ROLLING))


def test_what_a_slip_velocity_must_be() -> None:
    for wrong in ("X_dot^2", "X_dot*Y_dot", "sin(X_dot)"):
        with pytest.raises(MechanismError, match="linear in the velocities"):
            shift(lagrangian(**ROD | {"x": None, "slip_velocity": wrong}))
    with pytest.raises(MechanismError, match="either x or slip_velocity"):
        lagrangian(**ROD | {"slip_velocity": "X_dot"})
    with pytest.raises(MechanismError, match="either x or slip_velocity"):
        lagrangian(**ROD | {"x": None})


def test_energies_of_the_oscillator_give_the_shipped_one() -> None:
    """Sec. 6: T and V of the two masses and the springs; the dampers by Rayleigh's function."""
    shipped = shipped_mechanism("frictional impact oscillator, all parameters")
    mechanism = from_energies(
        "oscillator", ["phi", "psi"],
        "m_1*((l*cos(phi)*phi_dot)^2 + (psi_dot + l*sin(phi)*phi_dot)^2)/2 + m_2*psi_dot^2/2",
        "m_1*g*(psi + l*(1 - cos(phi))) + m_2*g*psi + k_phi*(phi - phi_ref - offset)^2/2 + k_psi*psi^2/2",
        "l*sin(phi)", "psi + l*(1 - cos(phi))", "mu",
        {"m_1": 1, "m_2": 1, "l": 1, "g": 1, "mu": "25/12", "offset": "49/45", "k_phi": 1, "c_phi": 0, "k_psi": 0,
         "c_psi": "125/324"},
        {"phi": ("4/5", "3/5")}, {"phi": "phi_ref", "psi": "-2/5", "phi_dot": -1, "psi_dot": "4/5"},
        dissipation="c_phi*phi_dot^2/2 + c_psi*psi_dot^2/2",
    )  # fmt: skip
    first, second = derive(mechanism, substitute=False), derive(shipped, substitute=False)
    for letter in ("p", "b", "alpha_1", "alpha_2", "alpha_3"):
        assert vanishes_identically(getattr(first, letter) - getattr(second, letter))
    exact = find_g_spot(mechanism)
    assert exact.exact
    Recursion(exact.system).advance()


@pytest.mark.parametrize(
    ("change", "part"),
    [
        ({"kinetic": "(X_dot^2 + Y_dot^2)^2"}, "kinetic energy must be quadratic"),
        ({"kinetic": "X_dot^3 + Y_dot^2"}, "kinetic energy must be quadratic"),
        ({"potential": "Y*X_dot"}, "potential energy must not depend on velocities"),
        ({"forces": [1]}, "2 forces, one for each coordinate, got 1"),
        ({"kinetic": "X_dot^2"}, "singular"),
    ],
)
def test_energies_that_are_refused(change: dict[str, Any], part: str) -> None:
    block = {"name": "block", "coordinates": ["X", "Y"], "kinetic": "(X_dot^2 + Y_dot^2)/2", "potential": "Y",
             "x": "X", "y": "Y", "mu": 1}  # fmt: skip
    shift(from_energies(**block))
    with pytest.raises(MechanismError, match=part):
        shift(from_energies(**block | change))


def test_energies_with_time_and_forces() -> None:
    """A support that shakes: T depends on time; against Newton's equation by hand, and the sympy route."""
    shaken = from_energies(
        "shaken", ["X", "Y"], "(X_dot^2 + (Y_dot + cos(3*t))^2)/2", "Y + X^2*t", "X", "Y*(1 + X)", "1/2", time="t",
        forces=["Y_dot", "sin(t)"],
    )  # fmt: skip
    same = lagrangian(
        "shaken", ["X", "Y"], [[1, 0], [0, 1]], ["Y_dot - 2*X*t", "sin(t) - 1 + 3*sin(3*t)"], "X", "Y*(1 + X)", "1/2",
        time="t",
    )  # fmt: skip
    assert shift(shaken).functions == shift(same).functions
    same_by_sympy(shaken)


# The oscillator of Sec. 6 with the pendulum's mass in Cartesian coordinates: the rod of length l is a constraint.
CONSTRAINED = """
format = 1
name = "oscillator with a constraint"
[lagrangian]
coordinates = ["X", "Z", "psi"]
mass_matrix = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
forces = ["49/27 - 2*(X - 4/5)", "-1", "-1 - 125/324*psi_dot"]
constraints = ["X^2 + (psi + 1 - Z)^2 - 1"]
[contact]
x = "X"
y = "Z"
mu = "25/12"
[g_spot]
[g_spot.point]
X = "4/5"
Z = 0
psi = "-2/5"
X_dot = "-3/5"
Z_dot = 0
psi_dot = "4/5"
"""


def test_a_constraint_is_the_reduced_mechanism() -> None:
    """X = sin(phi), Z = psi + 1 - cos(phi): the force along X acts on phi with the arm cos(phi)."""
    reduced = lagrangian(
        "reduced", ["phi", "psi"], [[1, "sin(phi)"], ["sin(phi)", 2]],
        ["(49/27 - 2*(sin(phi) - 4/5))*cos(phi) - sin(phi)", "-2 - 125/324*psi_dot - cos(phi)*phi_dot^2"], "sin(phi)",
        "psi + 1 - cos(phi)", "25/12", {}, {"phi": ("4/5", "3/5")},
        {"phi": "phi_ref", "psi": "-2/5", "phi_dot": -1, "psi_dot": "4/5"},
    )  # fmt: skip
    constrained = parse_mechanism(CONSTRAINED)
    assert alphas(constrained) == alphas(reduced)
    spot = find_g_spot(constrained)
    assert spot.fixed == ()
    recursion, other = Recursion(spot.system), Recursion(find_g_spot(reduced).system)
    for _ in range(6):
        recursion.advance()
        other.advance()
    assert [term.coefficients() for term in recursion.b] == [term.coefficients() for term in other.b]


def test_constraints_by_the_second_route() -> None:
    same_by_sympy(parse_mechanism(CONSTRAINED))


SPLIT: dict[str, Any] = ROD | {
    "coordinates": ["X", "Y", "theta", "W"], "constraints": ["W - X - 1"], "forces": [0, "-3/5", 0, 0],
    "mass_matrix": [["1/2", 0, 0, 0], [0, 1, 0, 0], [0, 0, "1/3", 0], [0, 0, 0, "1/2"]],
}  # fmt: skip
"""The rod with half of its mass along X on a slider W that a constraint ties to it (LDL^T of five rows)."""


def test_the_constraint_and_its_rate_are_conditions() -> None:
    place = ROD["place"] | {"W": 1, "W_dot": 2}
    assert alphas(lagrangian(**SPLIT | {"place": place})) == ALPHA
    assert find_g_spot(lagrangian(**SPLIT | {"place": place})).fixed == ("W", "W_dot")
    for change in ({"W": 2}, {"W_dot": 1}):
        with pytest.raises(GSpotError, match=r"the condition J_\d = .* must be 0 at the G-spot"):
            find_g_spot(lagrangian(**SPLIT | {"place": place | change}))
    conditions = {"place": place, "conditions": ["X", "X_dot^2 - 4"]}
    assert alphas(lagrangian(**SPLIT | conditions)) == ALPHA
    with pytest.raises(GSpotError, match="2 conditions J are needed, got 1"):
        find_g_spot(lagrangian(**SPLIT | conditions | {"conditions": ["X"]}))


def test_constraints_that_cannot_be() -> None:
    twice = SPLIT | {"constraints": ["W - X", "W - X"]}
    with pytest.raises(MechanismError, match="singular"):
        shift(lagrangian(**twice))
    with pytest.raises(MechanismError, match="a constraint must not depend on velocities"):
        shift(lagrangian(**SPLIT | {"constraints": ["W_dot - X_dot"]}))
    block = lagrangian(
        "block", ["X", "Y"], [[1, 0], [0, 1]], [0, 0], "X", "Y", 1, constraints=["X"],
        place={"X": 0, "Y": 0, "X_dot": 0, "Y_dot": 0},
    )  # fmt: skip
    with pytest.raises(GSpotError, match="leave no room for the conditions"):
        find_g_spot(block)


def test_all_g_spots_and_sweeps_keep_the_constraints() -> None:
    """A search that forgot them would find spots off the constraint, or a surface of them."""
    from gspot_verified.mechanisms.spots.all_g_spots import spot_conditions
    from gspot_verified.mechanisms.spots.parametric_system import parametric_system

    mechanism = lagrangian(**SPLIT | {"place": ROD["place"] | {"W": 1, "W_dot": 2}, "mu": "mu"}, parameters={"mu": 2})
    assert {"J_1", "J_2"} <= set(spot_conditions(shift(mechanism)))
    assert len(parametric_system(mechanism, ["mu"], ["X", "X_dot"]).conditions) == 8


def test_other_springs_and_dampers() -> None:
    """The constants reach the expansion and the notes; statements of the paper's compliant model are refused."""
    springs = {"k_1": 2, "k_2": "1/3", "c": "0.5"}
    mechanism = lagrangian(**ROD, regularisation=springs)
    assert alphas(mechanism) == ALPHA
    (note,) = classify(mechanism).notes
    assert note.startswith("compliance k_1 = 2/epsilon^2, k_2 = 1/3/epsilon^2, c = 1/2/epsilon")
    assert "epsilon^2 times 7/4" in note
    assert expand(mechanism, 9).y != expand(lagrangian(**ROD), 9).y
    check_expansion(find_g_spot(mechanism).system, 7)
    assert find_g_spot(lagrangian(**ROD, regularisation={})).system.regularisation.is_papers
    with pytest.raises(ValueError, match="the compliant model has k_1 = k_2"):
        iwc(mechanism)
    with pytest.raises(ValueError, match="the compliant model has k_1 = k_2"):
        iwc(classify(mechanism))
    iwc(lagrangian(**ROD))


@pytest.mark.parametrize(
    ("springs", "part"),
    [
        ({"k_1": 0}, "needs k_1 > 0"),
        ({"c": -1}, "c >= 0"),
        ({"k_3": 1}, "the constants are k_1, k_2, c, got .'k_3'."),
        ({"k_1": "x"}, "regularisation: "),
        ({"k_1": 0.5}, "regularisation: "),
    ],
)
def test_springs_and_dampers_that_are_refused(springs: dict[str, Any], part: str) -> None:
    with pytest.raises(MechanismError, match=part):
        lagrangian(**ROD, regularisation=springs)


def shaken(motion: str) -> Mechanism:
    """The rod on a surface that shakes: in its frame the weight is -3/5 - motion(t)."""
    place = ROD["place"] | {"t": 0}
    return lagrangian(**ROD | {"place": place, "forces": [0, f"-3/5 - {motion}", 0], "time": "t", "fixed": None})


def test_forcing_in_time() -> None:
    """b = y'' without contact holds the forcing: alpha_2 = L_F b loses its rate, -5 here; the others stay."""
    assert alphas(shaken("(1 - cos(5*t))")) == ALPHA
    assert alphas(shaken("sin(5*t)")) == [ALPHA[0], ALPHA[1] - 5, ALPHA[2]]
    spot = find_g_spot(shaken("sin(5*t)"))
    assert spot.fixed == ("X", "X_dot", "t")
    check_expansion(spot.system, 6)
    same_by_sympy(lagrangian(**ROD | {"place": None, "angles": None, "forces": [0, "-3/5 - sin(5*t)", 0], "time": "t"}))


@pytest.mark.parametrize(
    ("change", "part"), [({"W": 2}, "constraint 1 must be 0"), ({"W_dot": 1}, "the rate of constraint 1 must be 0")]
)
def test_a_state_off_a_constraint_is_refused(change: dict[str, Any], part: str) -> None:
    place = ROD["place"] | {"W": 1, "W_dot": 2}
    shifted = shift(lagrangian(**SPLIT | {"place": place}))
    state = {word: value for word, value in place.items() if word not in ("Y", "Y_dot")}
    with working_bits(100):
        assert slip_state(shifted, place).solved == ()
        assert slip_state(shifted, state).solved == ("Y", "Y_dot")
        for given in (place, state):
            with pytest.raises(StateError, match=part):
                slip_state(shifted, given | change)
