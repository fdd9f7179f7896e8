"""Accelerations by sympy and by this library: the same, or no mechanism is made."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy
from mechanisms.foreign.two_link import VALUES, by_kane, by_textbook, contact, q1, q2, u1, u2

from gspot_verified.mechanisms.foreign.compared import Compared, compare
from gspot_verified.mechanisms.foreign.exact_formulas import ExactFormulas
from gspot_verified.mechanisms.foreign.sympy_equations import sympy_equations, time_symbol
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError


@pytest.fixture(scope="module")
def theirs() -> Compared:
    equations = sympy_equations("arm", by_kane(u1, u1 + 2 * u2), ExactFormulas("arm"))
    parts = contact()
    return Compared(equations, parts["x"].diff(time_symbol()), parts["y"], {symbol: str(symbol) for symbol in VALUES})


def test_two_states_agree(theirs: Compared) -> None:
    assert compare(by_textbook(), theirs) == 2


TIP = "l1*sin(q1) + l2*sin(q2)"
HEIGHT = f"h + {TIP}"
PLACE = "l1*cos(q1) + l2*cos(q2)"
D12 = "m2*l1*l2/2*cos(q2 - q1)"
FORCE = "m2*l1*l2/2*sin(q2 - q1)"


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("m1*l1^2/3", "m2*l1^2/3"),  # two parameters mixed up
        ("q2_dot^2", "q1_dot^2"),  # two velocities
        ("m2*l2/2*g", "m2*l2*g"),  # a factor lost
        (HEIGHT, f"h - ({TIP})"),  # the contact upside down: the free motion is the same
        (PLACE, "l1*cos(q1)"),  # another contact point
    ],
)
def test_another_mechanism_is_refused(theirs: Compared, old: str, new: str) -> None:
    def made(text: str) -> str:
        return text.replace(old, new)

    def arm(change: Callable[[str], str]) -> Mechanism:
        rows = [["m1*l1^2/3 + m2*l1^2", D12], [D12, "m2*l2^2/3"]]
        forces = [f"{FORCE}*q2_dot^2 - (m1/2 + m2)*l1*g*cos(q1)", f"-{FORCE}*q1_dot^2 - m2*l2/2*g*cos(q2)"]
        values = {str(key): value for key, value in VALUES.items()}
        changed = [[change(entry) for entry in row] for row in rows]
        return lagrangian(
            "arm", ["q1", "q2"], changed, [*map(change, forces)], change(PLACE), change(HEIGHT), "mu", values
        )

    assert compare(arm(str), theirs) == 2
    with pytest.raises(MechanismError, match=r"differ from those of the equations given.*no mechanism is made"):
        compare(arm(made), theirs)


def test_equations_without_a_value_are_not_compared() -> None:
    formulas = ExactFormulas("arm")
    nowhere = sympy_equations("arm", (sympy.eye(2), [sympy.log(q1 - 9), 0]), formulas, [q1, q2])
    mechanism = lagrangian("arm", ["q1", "q2"], [[1, 0], [0, 1]], ["log(q1 - 9)", 0], "q2", "q1", 1)
    assert compare(mechanism, Compared(nowhere, q2.diff(), q1, {})) == 0


def test_an_acceleration_that_vanishes_agrees_up_to_rounding() -> None:
    """In numbers sin^2 + cos^2 - 1 is not exactly 0, and no multiple of it bounds the difference."""
    pair = (sympy.eye(2), [sympy.sin(q1) ** 2 + sympy.cos(q1) ** 2 - 1, -1])
    equations = sympy_equations("arm", pair, ExactFormulas("arm"), [q1, q2])
    mechanism = lagrangian("arm", ["q1", "q2"], [[1, 0], [0, 1]], ["sin(q1)^2 + cos(q1)^2 - 1", -1], "q1", "q2", 1)
    assert compare(mechanism, Compared(equations, q1.diff(), q2, {})) == 2


def test_large_accelerations_agree_in_their_own_size() -> None:
    equations = sympy_equations("arm", (sympy.eye(2), [10**40 * sympy.sin(q1), -1]), ExactFormulas("arm"), [q1, q2])
    mechanism = lagrangian("arm", ["q1", "q2"], [[1, 0], [0, 1]], ["(10^20)^2*sin(q1)", -1], "q1", "q2", 1)
    assert compare(mechanism, Compared(equations, q1.diff(), q2, {})) == 2
