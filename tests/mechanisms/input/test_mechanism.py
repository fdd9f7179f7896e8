"""A mechanism: values of its parameters, its notes, and exact numbers."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
import sympy
from flint import arb, fmpq

from gspot_verified.functions.derivative import ONE
from gspot_verified.functions.expressions import Variable
from gspot_verified.mechanisms.formulas.simplify import constant, power_of, sum_of
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import (
    Fields,
    Lagrangian,
    Mechanism,
    MechanismError,
    ReferenceAngle,
    exact_rational,
)


def body(parameters: dict[str, Any] | None = None, **options: Any) -> Mechanism:
    return lagrangian("body", ["q", "s"], [[1, 0], [0, 1]], [0, 0], "q", "s", 1, parameters, **options)


def test_values_of_parameters_are_exact_and_of_known_names() -> None:
    made = body({"m": 2, "k": None})
    assert dict(made.with_parameters(m="1/3", k=Fraction(2, 7)).parameters) == {
        "m": constant(fmpq(1, 3)), "k": constant(fmpq(2, 7)),
    }  # fmt: skip
    assert dict(made.with_parameters(m=None).parameters) == {"m": None, "k": None}
    assert made.with_parameters() == made
    with pytest.raises(MechanismError, match=r"body has no parameter 'mm'; did you mean 'm'.; it has: m, k"):
        made.with_parameters(mm=1)
    with pytest.raises(MechanismError, match="body has no parameter 'm'; it has: none"):
        body().with_parameters(m=1)
    with pytest.raises(MechanismError, match="m: a float is not taken as exact"):
        made.with_parameters(m=0.5)  # type: ignore[arg-type]


def test_a_mechanism_says_its_state_and_is_not_mirrored_unless_it_is_said() -> None:
    made = body()
    assert str(made) == f"body: a mechanism with the state {', '.join(made.state)}; parameters: none"
    assert str(body({"m": 2, "k": None})).endswith("; parameters: m, k")
    bare = Mechanism(made.name, made.state, made.motion, made.x, made.y, made.mu)
    assert not bare.mirrored
    assert bare.notes == ()


def test_values_use_each_other() -> None:
    made = body({"a": "b + c", "b": "2*c", "c": 5, "free": None})
    assert made.parameter_values() == {"a": constant(15), "b": constant(10), "c": constant(5)}
    assert body({"a": "free + 1", "free": None}).parameter_values().keys() == {"a"}
    with pytest.raises(MechanismError, match="body: parameters whose values use each other in a circle: a, b"):
        body({"a": "b", "b": "a", "c": 1}).parameter_values()
    with pytest.raises(MechanismError, match="body: parameter a: division by zero"):
        body({"a": "1/b", "b": 0}).parameter_values()
    with pytest.raises(MechanismError, match="body: parameter a: a number grows beyond"):
        body({"a": "b^64", "b": "c^64", "c": "9^64"}).parameter_values()


def test_parts_replaced_by_hand_must_fit() -> None:
    made = body({"a": 1})
    motion = made.motion
    assert isinstance(motion, Lagrangian)
    (first, second), forces = motion.mass_matrix, motion.forces
    q, s = Variable(0), Variable(1)
    whole, out = power_of(sum_of(q, s), fmpq(2)), sum_of(q * q, constant(2) * q * s, s * s)
    assert replace(motion, mass_matrix=((ONE, whole), (out, ONE))).mass_matrix == ((ONE, whole), (out, ONE))
    for rows in ((first, (ONE, second[1])), ((ONE, whole), (sum_of(out, constant(fmpq(1, 10**30))), ONE))):
        with pytest.raises(MechanismError, match=r"not symmetric: entry \(2, 1\) is .*, entry \(1, 2\) is "):
            replace(motion, mass_matrix=rows)
    wrong: dict[str, Any]
    for wrong in ({"mass_matrix": (first,)}, {"mass_matrix": (first, second, second)}, {"mass_matrix": (first, (ONE,))},
                  {"forces": forces[:1]}, {"forces": (*forces, ONE)}):  # fmt: skip
        with pytest.raises(MechanismError, match="2 coordinates need a mass matrix with 2 rows of 2 formulas, and 2"):
            replace(motion, **wrong)
    for x, slip_velocity in ((made.x, made.x), (None, None)):
        with pytest.raises(MechanismError, match="body: the contact needs either x or slip_velocity"):
            replace(made, x=x, slip_velocity=slip_velocity)
    fields = Fields((ONE,) * 4, (ONE,) * 4, (ONE,) * 4)
    assert replace(made, motion=fields).motion is fields
    bad: dict[str, Any]
    for bad in ({"state": made.state[::-1]}, {"state": (*made.state, "t")}, {"motion": replace(fields, G_T=(ONE,))}):
        with pytest.raises(MechanismError, match=r"body: the state .* is not that of the motion"):
            replace(made, **bad)
    with pytest.raises(MechanismError, match="body: sympy's symbol a is assumed negative; its value is 1"):
        replace(made, assumed=(("a", "negative"),))


def test_a_reference_angle_lies_on_the_circle() -> None:
    assert ReferenceAngle("phi", fmpq(3, 5), fmpq(-4, 5)).name == "phi_ref"
    for sine, cosine in ((fmpq(3, 5), fmpq(3, 5)), (fmpq(1), fmpq(1)), (fmpq(0), fmpq(0)), (fmpq(4, 5), fmpq(1, 5))):
        with pytest.raises(MechanismError, match=f"angle phi: sine {sine} and cosine {cosine} must satisfy"):
            ReferenceAngle("phi", sine, cosine)


def test_notes_say_how_it_was_read() -> None:
    assert body().notes == ()
    assert body().symbols == sympy.symbols("q s q_dot s_dot")
    assert body(slip="negative").notes == (
        "negative slip: mirrored, x counts in the opposite direction, so that u > 0 and lambda_T = -mu lambda_N; the "
        "velocity of a surface counts as u does",
    )
    belt = lagrangian(
        "belt", ["q", "s"], [[1, 0], [0, 1]], [0, 0], None, "s", 1, slip_velocity="q_dot - 1", slip="negative",
        regularisation={"k_1": 2, "k_2": 4, "c": 3},
    )  # fmt: skip
    first, second = belt.notes
    assert first.startswith("negative slip: mirrored, the slip velocity counts in the opposite direction")
    assert second.startswith("compliance k_1 = 2/epsilon^2, k_2 = 4/epsilon^2, c = 3/epsilon: ")
    assert second.endswith("with epsilon^2 times 3/8 in the leading order")  # (1/2 + 1/4)/2


def test_a_rational_number_is_asked_for() -> None:
    assert exact_rational("0.1", "m") == fmpq(1, 10)
    assert exact_rational(arb(3) / 4, "m") == fmpq(3, 4)
    for value, message in ((0.5, "m: a float"), ("x", "m"), (arb(1, "0.1"), "m: must be a rational number")):
        with pytest.raises(MechanismError, match=message):
            exact_rational(value, "m")  # type: ignore[arg-type]


def test_its_text_names_state_and_parameters_and_repeats_the_notes() -> None:
    plain = lagrangian("block", ["q", "s"], [[1, 0], [0, 1]], [0, 0], "q", "s", 1)
    line = "block: a mechanism with the state q, s, q_dot, s_dot; parameters: none"
    assert str(plain) == line
    assert str(replace(plain, remarks=("renamed: x is q here",))) == f"{line}\n  note: renamed: x is q here"
    bare = Mechanism(plain.name, plain.state, plain.motion, plain.x, plain.y, plain.mu)
    assert bare == plain
    assert not bare.mirrored
