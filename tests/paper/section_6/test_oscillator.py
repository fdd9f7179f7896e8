"""The oscillator in exact polynomials: the same system as the shipped mechanism, and no changed term goes unnoticed."""

from __future__ import annotations

from typing import Any

import pytest
import sympy

from gspot_verified.mechanisms.derive.lie_derivatives import Reader, vanishes_identically
from gspot_verified.mechanisms.input.mechanism import Lagrangian
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.paper.numerics.oscillator_formulas import APPENDIX_B, SECTION_6, printed_formula
from gspot_verified.paper.section_6 import oscillator, section_6
from gspot_verified.paper.section_6.oscillator import (
    ALGEBRA,
    MOTION,
    PRINTED,
    at_g_spot,
    by_lie_derivatives,
    by_the_motion,
    normal,
)


def in_sympy(text: str) -> Any:
    """A text of FLINT as a function of the state and the parameters of the mechanism."""
    phi, m_1, m_2, length = sympy.symbols("phi m_1 m_2 l")
    names = {
        "S": sympy.sin(phi), "C": sympy.cos(phi), "w": sympy.Symbol("phi_dot"), "x": sympy.Symbol("psi_dot"),
        "e": phi - sympy.Symbol("phi_ref") - sympy.Symbol("offset"), "m1": m_1, "m2": m_2, "I": 1 / m_1,
        "J": 1 / length,
        "R": 1 / (m_2 + m_1 * sympy.cos(phi) ** 2),
        **{name: sympy.Symbol(f"{name[0]}_{name[1:]}") for name in ("kphi", "kpsi", "cphi", "cpsi")},
    }  # fmt: skip
    return sympy.sympify(text.replace("^", "**"), locals=names)


def test_the_printed_motion_is_that_of_the_shipped_mechanism() -> None:
    mechanism = shipped_mechanism("frictional impact oscillator, all parameters")
    motion = mechanism.motion
    assert isinstance(motion, Lagrangian)
    read = Reader(mechanism, substitute=False)
    for i in range(2):
        assert vanishes_identically(in_sympy(MOTION[f"f{i + 1}"]) - read(motion.forces[i]))
        for j in range(2):
            assert vanishes_identically(in_sympy(MOTION[f"M{i + 1}{j + 1}"]) - read(motion.mass_matrix[i][j]))
    assert vanishes_identically(in_sympy(MOTION["x"]) - read(mechanism.x))
    assert vanishes_identically(in_sympy(MOTION["y"]) - read(mechanism.y))


@pytest.mark.parametrize("name", APPENDIX_B)
def test_the_text_for_polynomials_is_the_text_for_sympy(name: str) -> None:
    assert vanishes_identically(in_sympy(PRINTED[f"B-{name}"]["formula"]) - printed_formula(name))


@pytest.mark.parametrize("name", APPENDIX_B)
def test_every_changed_coefficient_is_noticed_by_both_routes(name: str) -> None:
    formula = ALGEBRA.read(PRINTED[f"B-{name}"]["formula"])
    routes = [by_lie_derivatives()[name], by_the_motion()[name]]
    for exponents, number in formula.terms():
        changed = formula + ALGEBRA._context.from_dict({exponents: number})
        assert all(not normal(changed - route).is_zero() for route in routes)
        assert normal(formula - routes[0]).is_zero()


@pytest.mark.parametrize("name", SECTION_6)
def test_every_changed_number_at_the_g_spot_is_noticed(name: str) -> None:
    value = ALGEBRA.read(PRINTED[f"6-{name}"]["value"])
    for exponents, number in value.terms():
        changed = value + ALGEBRA._context.from_dict({exponents: number})
        assert not at_g_spot(changed - by_lie_derivatives()[name]).is_zero()


def test_normal_form() -> None:
    read = ALGEBRA.read
    assert normal(read("S^2 + C^2 - 1")).is_zero()
    assert normal(read("R*(m2 + m1*C^2) - I*m1*J*l")).is_zero()
    assert normal(read("S^3 - S*(1 - C^2)")).is_zero()
    assert not normal(read("R*m2 - 1")).is_zero()
    assert not normal(read("S - C")).is_zero()


def test_cases() -> None:
    from flint import fmpq

    values = [fmpq(-1), fmpq(-2), fmpq(-3)]
    assert section_6.in_case_iii(*values)
    assert section_6.approached_with_finite_force(*values)
    # Case I (alpha_1 < alpha_3 < 0), alpha_2 > 0 beside Case III, and a G-spot that repels.
    for wrong in ((-3, -2, -1), (-1, 2, -3), (1, -2, -3), (-1, -2, 3)):
        assert not section_6.in_case_iii(*(fmpq(a) for a in wrong))
        assert not section_6.approached_with_finite_force(*(fmpq(a) for a in wrong))


def test_the_place_is_on_the_circle(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(oscillator.G_SPOT, "C", "4/5")
    assert any(not value.is_zero() for value in oscillator.g_spot_is_consistent())
