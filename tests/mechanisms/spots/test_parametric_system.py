"""A mechanism's conditions as functions of the state and of parameters: which conditions J, and none missing."""

from __future__ import annotations

import pytest
from flint import arb
from samples.families import family

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Variable
from gspot_verified.mechanisms.input.given import from_fields
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.parametric_system import parametric_system
from gspot_verified.numbers.balls import working_bits


def test_the_functions_at_one_place() -> None:
    """p = q - k: (x, u, y, v, q, b) = (1, 2, 3, 4, 5, 6), k = 7, and x, u stay at 0, 1."""
    system = parametric_system(family("q - k", "0"), ["k"], ["x", "u"])
    assert (system.parameters, system.dimension) == (("k",), 6)
    place = [arb(value) for value in range(1, 8)]
    values = BoxProgram(system.conditions, 7).values(place)
    assert values == [arb(-2), arb(6), arb(3), arb(4), arb(1), arb(1)]
    own = (system.alpha_1, system.alpha_2, system.alpha_3, system.slip, system.friction)
    found = BoxProgram(own, 7).values(place)
    assert [found[0], found[1], found[3], found[4]] == [arb(-1), arb(-1), arb(2), arb(3)]
    assert (found[2] + arb(3) / 2).contains(0)
    ((A, B), (_, C)) = system.matrix
    first, second, third = BoxProgram([A, B, C], 7).values(place)
    assert (third - 3 * second - values[0]).contains(0)
    assert (first - arb(1) / 2).contains(0)


def test_conditions_of_the_mechanism_stand_for_components_that_stay() -> None:
    made = from_fields(
        "own", ["x", "u", "y", "v", "q", "b"], ["u", 0, "v", "b", -1, -1], [0, 2, 0, "1 - q + k", 0, 0],
        [0, "1 - q + k", 0, 1, 0, 0], "x", "y", 1, {"k": 1}, place={"x": 0, "u": 1, "y": 0, "v": 0, "q": 1, "b": 0},
        conditions=["x - k", "u - 1"],
    )  # fmt: skip
    system = parametric_system(made, ["k"])
    values = BoxProgram(system.conditions, 7).values([arb(value) for value in range(1, 8)])
    assert values[4:] == [arb(-6), arb(1)]


def test_a_wrong_number_of_conditions_is_refused() -> None:
    for fixed in ([], ["x"], ["x", "u", "q"]):
        with pytest.raises(MechanismError, match=f"2 conditions J are needed, got {len(fixed)}"):
            parametric_system(family("q - k", "0"), ["k"], fixed)


def test_every_other_parameter_has_a_value() -> None:
    rod = shipped_mechanism("genot_brogliato_rod", g=None)
    with pytest.raises(MechanismError, match="parameters without a value: g"):
        parametric_system(rod, ["mu"], ["X", "X_dot"])
    assert parametric_system(rod, ["mu", "g"], ["X", "X_dot"]).friction is Variable(6)


def test_constants_are_narrow() -> None:
    """pi stands in the conditions as a ball; sweeps work at 80 bits."""
    with working_bits(80):
        system = parametric_system(family("pi*q - k", "0"), ["k"], ["x", "u"])
        at = [arb(0)] * 4 + [arb(1), arb(0), arb(3)]
        value = BoxProgram(system.conditions, 7).values(at)[0]
        assert (value - (arb.pi() - 3)).contains(0)
        assert value.rad() < arb("1e-20")
