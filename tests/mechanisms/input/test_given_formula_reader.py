"""The formulas of one mechanism: which names they may use, where a message says they stand, and how many are read."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
import sympy
from flint import fmpq

from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.functions.expressions import Constant, Variable
from gspot_verified.mechanisms.formulas.rewriting import simplified
from gspot_verified.mechanisms.formulas.simplify import constant, negative, sum_of
from gspot_verified.mechanisms.formulas.symbol import Symbol, count_operations
from gspot_verified.mechanisms.input.given import (
    MAX_OPERATIONS,
    MAX_PARAMETERS,
    MAX_STATE,
    Contact,
    FormulaReader,
    lagrangian,
)
from gspot_verified.mechanisms.input.mechanism import Fields, Lagrangian, Mechanism, MechanismError

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
    found = read.mechanism(Fields((), (), ()), Contact("x", "v", "k"), {})
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
    found = reader().mechanism(motion, Contact("x", "x", 1, None, "negative"), {})
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
