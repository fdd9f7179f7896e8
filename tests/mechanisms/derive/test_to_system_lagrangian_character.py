"""The Lagrangian character of fields that are given: every identity is asked for, and one that fails is named.

With a mass matrix they hold by the derivation.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
import sympy

from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.mechanisms.derive import lie_derivatives
from gspot_verified.mechanisms.derive.derivation import derive_expressions
from gspot_verified.mechanisms.derive.derived import Derived
from gspot_verified.mechanisms.derive.to_system import Preparation, check_lagrangian_character
from gspot_verified.mechanisms.input.given import from_fields
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism

GOOD: dict[str, Any] = {
    "name": "fields", "state": ["x", "u", "y", "v", "w"], "F": ["u", 0, "v", "w", 1], "G_T": [0, 2, 0, "w", 0],
    "G_N": [0, "w", 0, 3, 0], "x": "x", "y": "y", "mu": 1,
}  # fmt: skip


def derived(made: Mechanism) -> Derived[Expression]:
    return derive_expressions(made, Preparation(made))


def check(**change: Any) -> None:
    made = from_fields(**GOOD | change)
    check_lagrangian_character(made, derived(made))


def test_good_fields_need_no_sympy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lie_derivatives, "check_lagrangian_conditions", None)
    check()
    check(x=None, slip_velocity="u")


@pytest.mark.parametrize(
    ("change", "name"),
    [
        ({"G_T": [1, 2, 0, "w", 0]}, "L_GT x"),
        ({"G_N": [1, "w", 0, 3, 0]}, "L_GN x"),
        ({"G_T": [0, 2, 1, "w", 0]}, "L_GT y"),
        ({"G_N": [0, "w", 1, 3, 0]}, "L_GN y"),
        ({"G_T": [0, 2, 0, 1, 0]}, "L_GN u - L_GT v"),
        ({"G_T": [0, 2, 0, "w", 1]}, "L_G p"),
        ({"x": None, "slip_velocity": "u", "G_N": [0, "w", 1, 3, 0]}, "L_GN y"),
    ],
)
def test_each_identity_that_fails_is_named(change: dict[str, Any], name: str) -> None:
    with pytest.raises(MechanismError, match=f"fields: {name} must vanish"):
        check(**change)


def test_what_simplifies_only_in_sympy_is_accepted() -> None:
    check(G_T=[0, 2, 0, "w*(sin(w)^2 + cos(w)^2)", 0])


def test_a_mass_matrix_gives_them_without_a_check(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lie_derivatives, "check_lagrangian_conditions", None)
    rod = shipped_mechanism("rod")
    found = derived(rod)
    check_lagrangian_character(rod, replace(found, B=Variable(0)))


def ladder(share: str) -> Mechanism:
    """A rod of length 2 with its upper end on a wall: the wall's force has the direction (1, share), as its friction
    makes it while that end slips downwards and the wall pushes; it is solved for, with the constraint."""
    X, Y, T, Xd, Yd, Td = sympy.symbols("X Y T X_dot Y_dot T_dot")
    q, rates = (X, Y, T), (Xd, Yd, Td)
    inverse = sympy.diag(1, 1, 3)
    gap, x, y = X - sympy.cos(T), X + sympy.cos(T), Y - sympy.sin(T)
    across = sympy.Matrix([gap.diff(c) for c in q])
    up = sympy.Matrix([sympy.diff(Y + sympy.sin(T), c) for c in q])
    pushed = inverse * (across + sympy.Rational(share) * up)
    bend = sum(gap.diff(c, d) * r * s for c, r in zip(q, rates, strict=True) for d, s in zip(q, rates, strict=True))

    def held(free: Any, extra: Any) -> list[Any]:
        return list(free - pushed * (across.dot(free) + extra) / across.dot(pushed))

    normal, tangent = (inverse * sympy.Matrix([g.diff(c) for c in q]) for g in (y, x))
    fields = {
        "F": [*rates, *held(sympy.Matrix([0, -1, 0]), bend)],
        "G_T": [0, 0, 0, *held(tangent, 0)],
        "G_N": [0, 0, 0, *held(normal, 0)],
    }
    return from_fields("ladder", ["X", "Y", "T", "X_dot", "Y_dot", "T_dot"], **fields, x=x, y=y, mu="1/2")


def test_friction_in_a_joint_breaks_the_symmetry_of_the_contact() -> None:
    """What the page on what is outside says: with dry friction in it the joint is no ideal constraint."""
    smooth, rough = ladder("0"), ladder("1/5")
    check_lagrangian_character(smooth, derived(smooth))
    with pytest.raises(MechanismError, match="ladder: L_GN u - L_GT v must vanish"):
        check_lagrangian_character(rough, derived(rough))
