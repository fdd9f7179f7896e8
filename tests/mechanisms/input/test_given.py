"""Mechanisms given by a mass matrix, by energies, by fields: shapes, and Lagrange's equations against sympy's."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
import sympy
from flint import fmpq

from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.functions.expressions import Constant, Variable
from gspot_verified.mechanisms.formulas.in_sympy import to_sympy
from gspot_verified.mechanisms.formulas.rewriting import simplified
from gspot_verified.mechanisms.formulas.simplify import constant, negative, sum_of
from gspot_verified.mechanisms.formulas.symbol import Symbol, count_operations
from gspot_verified.mechanisms.input.given import (
    MAX_OPERATIONS,
    MAX_PARAMETERS,
    MAX_STATE,
    Contact,
    FormulaReader,
    from_energies,
    from_fields,
    lagrangian,
)
from gspot_verified.mechanisms.input.mechanism import Fields, Lagrangian, Mechanism, MechanismError

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


# The formulas of one mechanism: which names they may use, where a message says they stand, and how many are read.


X, V = Variable(0), Variable(1)
ANGLE = {"x": ("3/5", "4/5")}


def reader(state: tuple[str, ...] = ("x", "v"), parameters: Any = None, angles: Any = None) -> FormulaReader:
    return FormulaReader("body", state, {"m": 2, "k": None} if parameters is None else parameters, angles or {})


def mechanism(contact: Contact | None = None, place: Any = None, **options: Any) -> Mechanism:
    read = reader(angles=ANGLE)
    motion = Fields(read.all(["v", "m"], "F"), read.all([1, "x"], "G_T"), read.all([0, 1], "G_N"))
    return read.mechanism(motion, contact or Contact("x", "v", "k"), place or {}, **options)


def test_a_formula_is_a_text_a_number_or_a_sympy_expression() -> None:
    read = reader()
    assert read("x + m", "f") == sum_of(X, Symbol("m"))
    assert read(3, "f") == constant(fmpq(3))
    assert read(Fraction(1, 3), "f") == constant(fmpq(1, 3))
    assert read("1/3", "f") == Constant(fmpq(1, 3))
    assert read(sympy.Symbol("v") + 1, "f") == sum_of(V, constant(1))
    assert read.all(["x", "v"], "f") == (X, V)
    assert reader(angles=ANGLE)("x_ref", "f") == Symbol("x_ref")


@pytest.mark.parametrize(
    ("formula", "message"),
    [
        ("z", "body: here: unknown name 'z'"),
        (0.5, "body: here: .*a float"),
        ("1/0", "body: here: division by zero"),
        (sympy.Symbol("z"), "body: here: .*z"),
        ("x_ref", "body: here: unknown name 'x_ref'"),
    ],
)
def test_what_is_none_is_refused_with_its_place(formula: Any, message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        reader()(formula, "here")
    with pytest.raises(MechanismError, match="body: force 2: "):
        reader().all([1, formula], "force")


def test_parameters_use_parameters_and_reference_angles_stay_out() -> None:
    read = reader(parameters={"m": 2, "k": "m + 1", "free": None})
    found = read.mechanism(Fields((V, X), (X, X), (X, X)), Contact("x", "v", "k"), {})
    assert found.parameters == (("m", constant(2)), ("k", sum_of(Symbol("m"), constant(1))), ("free", None))
    with pytest.raises(MechanismError, match="body: parameter k: unknown name 'x'"):
        reader(parameters={"k": "x"})
    with pytest.raises(MechanismError, match="body: parameter k: unknown name 'x_ref'"):
        reader(parameters={"k": "x_ref"}, angles=ANGLE)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"parameters": {"x": 1}}, "body: the name 'x' is used twice"),
        ({"parameters": {"x_ref": 1}, "angles": ANGLE}, "body: the name 'x_ref' is used twice"),
        ({"state": ("x", "x")}, "body: the name 'x' is used twice"),
        (
            {"parameters": {"A": 1, "\N{GREEK CAPITAL LETTER ALPHA}": 2}},
            r"body: the names 'A' and '\\u0391' look alike: one has a Greek letter",
        ),
        ({"state": ("x", "x_ref"), "angles": ANGLE}, "body: the name 'x_ref' is used twice"),
        ({"state": ("x", "sin")}, "body: 'sin' is a function"),
        ({"angles": {"z": ("3/5", "4/5")}}, "body: angle 'z' is no component of the state; it has: x, v"),
        ({"angles": {"x": (0.6, "4/5")}}, "sine of x: a float"),
        ({"angles": {"x": ("3/5", 0.8)}}, "cosine of x: a float"),
        ({"angles": {"x": ("3/5", "3/5")}}, "sine.* and cosine.* must satisfy"),
    ],
)
def test_names_are_of_one_thing_each(options: Any, message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        reader(**options)


def test_the_limits_are_where_they_are_said_to_be() -> None:
    names = tuple(f"q{i}" for i in range(MAX_STATE + 1))
    assert len(reader(names[:MAX_STATE]).state) == MAX_STATE
    with pytest.raises(MechanismError, match=f"body: at most {MAX_STATE} components of the state, got {MAX_STATE + 1}"):
        reader(names)
    many = {f"a{i}": None for i in range(MAX_PARAMETERS + 1)}
    reader(parameters=dict(list(many.items())[:MAX_PARAMETERS]))
    with pytest.raises(MechanismError, match=f"body: at most {MAX_PARAMETERS} parameters, got {MAX_PARAMETERS + 1}"):
        reader(parameters=many)
    read, one = reader(), count_operations(reader()("x*v", "f"))
    assert one > 0
    assert MAX_OPERATIONS % one == 0
    for _ in range(MAX_OPERATIONS // one):
        read("x*v", "f")
    with pytest.raises(MechanismError, match=f"body: the formulas have more than {MAX_OPERATIONS} operations"):
        read("x*v", "f")


def test_the_parts_come_together() -> None:
    found = mechanism(place={"x": "x_ref + m", "v": 1}, search=True, fixed=["x"], conditions=["v - 1"])
    assert (found.name, found.state, found.x, found.y) == ("body", ("x", "v"), X, V)
    assert (found.mu, found.slip_velocity, found.mirrored) == (Symbol("k"), None, False)
    assert dict(found.place.values) == {"x": sum_of(Symbol("x_ref"), Symbol("m")), "v": constant(1)}
    assert (found.place.search, found.place.fixed) == (True, ("x",))
    assert found.place.conditions == (sum_of(V, constant(-1)),)
    assert [(angle.coordinate, angle.sine, angle.cosine) for angle in found.angles] == [("x", fmpq(3, 5), fmpq(4, 5))]
    plain = mechanism()
    assert (plain.place.values, plain.place.fixed, plain.place.conditions) == ((), None, None)
    with pytest.raises(MechanismError, match="body: G-spot: 'z' is no component"):
        mechanism(place={"z": 1})
    with pytest.raises(MechanismError, match="body: G-spot: 'z' is no component"):
        mechanism(fixed=["z"])
    with pytest.raises(MechanismError, match="body: condition 2: unknown name 'z'"):
        mechanism(conditions=["x", "z"])
    with pytest.raises(MechanismError, match="body: G-spot, x: unknown name 'v'"):
        mechanism(place={"x": "v"})


@pytest.mark.parametrize("velocity", [True, False])
def test_negative_slip_turns_x_or_the_slip_velocity_and_the_tangential_field(velocity: bool) -> None:
    def made(slip: str) -> Mechanism:
        return mechanism(Contact(None, "v", 1, "v - 1", slip) if velocity else Contact("x - 1", "v", 1, None, slip))

    forward, turned = made("positive"), made("negative")
    assert (forward.mirrored, turned.mirrored) == (False, True)
    for one, other in ((forward.x, turned.x), (forward.slip_velocity, turned.slip_velocity)):
        assert (one is None) == (other is None)
        if one is not None and other is not None:
            assert simplified(sum_of(one, other)) == [constant(0)]
    assert (forward.x is None) == velocity
    assert (forward.slip_velocity is None) != velocity
    assert isinstance(forward.motion, Fields)
    assert isinstance(turned.motion, Fields)
    assert tuple(negative(part) for part in forward.motion.G_T) == turned.motion.G_T
    assert (turned.motion.F, turned.motion.G_N) == (forward.motion.F, forward.motion.G_N)
    with pytest.raises(MechanismError, match="slip must be 'positive' or 'negative', got 'left'"):
        made("left")


def test_a_mass_matrix_has_no_tangential_field_to_turn() -> None:
    motion = Lagrangian(("x",), ((constant(1),),), (constant(0),), None)
    found = reader(("x", "x_dot")).mechanism(motion, Contact("x", "x", 1, None, "negative"), {})
    assert found.mirrored
    assert found.motion is motion


@pytest.mark.parametrize("contact", [Contact(None, "v", 1), Contact("x", "v", 1, "v")])
def test_the_contact_has_x_or_a_slip_velocity(contact: Contact) -> None:
    with pytest.raises(MechanismError, match="body: the contact needs either x or slip_velocity"):
        mechanism(contact)


def test_the_compliance_of_the_contact() -> None:
    assert mechanism().regularisation is PAPER
    found = mechanism(regularisation={"k_1": 3, "c": "1/2"}).regularisation
    assert (found.k_1, found.k_2, found.c) == (3, 1, fmpq(1, 2))
    bad: dict[str, dict[str, Any]] = {
        r"the constants are k_1, k_2, c, got \['k'\]": {"k": 1},
        "c": {"c": -1},
        "k_1": {"k_1": 0.5},
    }
    for message, given in bad.items():
        with pytest.raises(MechanismError, match=f"body: regularisation: .*{message}"):
            mechanism(regularisation=given)


def test_the_operations_of_a_drawing_are_counted_apart() -> None:
    """So many and no more, whatever the mechanism itself has."""
    circles = [["2*X", "Y", 1]] * MAX_OPERATIONS

    def block(circles: list[list[Any]]) -> Mechanism:
        forces = ["3*X", "-1"]
        return lagrangian("block", ["X", "Y"], [[1, 0], [0, 1]], forces, "X", "Y", 0, drawing={"circles": circles})

    assert block(circles).drawing is not None
    with pytest.raises(MechanismError, match=f"more than {MAX_OPERATIONS} operations"):
        block([*circles, circles[0]])


def test_a_place_in_two_spellings() -> None:
    micro, greek = "\N{MICRO SIGN}", "\N{GREEK SMALL LETTER MU}"
    with pytest.raises(MechanismError, match=f"G-spot: {greek} is given twice"):
        lagrangian("drop", [greek, "y"], [[1, 0], [0, 1]], [0, -1], greek, "y", 0, place={micro: 0, greek: 1})
