"""Appendix B and Sec. 6: what is printed, what is derived, and that a wrong formula would be noticed."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
import sympy

from gspot_verified.functions.derivative import ONE
from gspot_verified.mechanisms.derive.lie_derivatives import derive, vanishes_identically
from gspot_verified.mechanisms.input.mechanism import Lagrangian
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.paper.numerics import oscillator_formulas
from gspot_verified.paper.numerics.oscillator_formulas import (
    APPENDIX_B,
    compare_appendix_b,
    compare_equations_of_motion,
    compare_section_6,
    printed_formula,
)


def test_appendix_b() -> None:
    rows = compare_appendix_b()
    assert [row.label for row in rows] == ["v", "p", "b", "alpha_1", "alpha_2", "alpha_3"]
    assert all(row.holds for row in rows)


def test_section_6() -> None:
    rows = compare_section_6()
    assert [row.label for row in rows if not row.holds] == ["G = M^-1(-Q_N + mu Q_T)"]
    assert len(rows) == 9
    sign = next(row for row in rows if not row.holds)
    assert sign.note == "L_G v is minus the printed p; right is G = M^-1(Q_N - mu Q_T)"
    assert str(sign) == f"{sign.label} (lines 2145-2148): WRONG as printed; {sign.note}"


@pytest.mark.parametrize("which", [0, 1])
@pytest.mark.parametrize("part", ["forces", "mass_matrix"])
def test_a_wrong_equation_of_motion_is_reported(which: int, part: str, monkeypatch: pytest.MonkeyPatch) -> None:
    mechanism = shipped_mechanism("frictional impact oscillator, all parameters")
    assert isinstance(mechanism.motion, Lagrangian)
    given: list[Any] = list(getattr(mechanism.motion, part))
    given[which] = given[which] + ONE if part == "forces" else (given[which][0] + ONE, given[which][1])
    wrong = replace(mechanism, motion=replace(mechanism.motion, **{part: tuple(given)}))
    monkeypatch.setattr(oscillator_formulas, "_mechanism", lambda: wrong)
    assert not compare_equations_of_motion().holds


def acceleration(v: dict[str, Fraction], s: Fraction, c: Fraction, normal: Fraction) -> tuple[Fraction, Fraction]:
    """phi'' and psi'' by Cramer's rule in fractions, with the force λ_N = normal, λ_T = -μ normal."""
    m_1, m_2, length, g = v["m_1"], v["m_2"], v["l"], v["g"]
    f_1 = -v["k_phi"] * (v["phi"] - v["phi_0"]) - v["c_phi"] * v["phi_dot"] - m_1 * g * length * s
    f_2 = -v["k_psi"] * v["psi"] - v["c_psi"] * v["psi_dot"] - (m_1 + m_2) * g - m_1 * length * c * v["phi_dot"] ** 2
    f_1 += normal * (length * s - v["mu"] * length * c)
    f_2 += normal
    determinant = m_1 * length**2 * (m_1 + m_2) - (m_1 * length * s) ** 2
    return (
        (f_1 * (m_1 + m_2) - m_1 * length * s * f_2) / determinant,
        (m_1 * length**2 * f_2 - m_1 * length * s * f_1) / determinant,
    )


def contact_acceleration(v: dict[str, Fraction], s: Fraction, c: Fraction, normal: Fraction) -> Fraction:
    """y'' of y = psi + l(1 - cos phi)."""
    first, second = acceleration(v, s, c, normal)
    return second + v["l"] * s * first + v["l"] * c * v["phi_dot"] ** 2


@pytest.mark.parametrize("seed", range(5))
def test_b_and_p_at_random_rational_points(seed: int) -> None:
    """A second route: the equations of motion in fractions; b = y'' without force, p its increase by one unit."""
    source = random.Random(seed)
    v = {
        name: Fraction(source.randint(1, 40), source.randint(1, 9))
        for name in (
            "m_1",
            "m_2",
            "l",
            "g",
            "mu",
            "k_phi",
            "c_phi",
            "k_psi",
            "c_psi",
            "phi",
            "phi_0",
            "psi",
            "phi_dot",
            "psi_dot",
        )
    }
    t = Fraction(source.randint(-20, 20), 7)
    s, c = 2 * t / (1 + t * t), (1 - t * t) / (1 + t * t)
    phi = sympy.Symbol("phi")
    table: dict[Any, Any] = {sympy.Symbol(name): sympy.Rational(x.numerator, x.denominator) for name, x in v.items()}
    table[sympy.Symbol("phi_ref")] = table[sympy.Symbol("phi_0")]
    table[sympy.Symbol("offset")] = sympy.Integer(0)
    angle = {
        sympy.sin(phi): sympy.Rational(s.numerator, s.denominator),
        sympy.cos(phi): sympy.Rational(c.numerator, c.denominator),
    }
    printed = {name: printed_formula(name).xreplace(angle).xreplace(table) for name in ("b", "p")}
    free = contact_acceleration(v, s, c, Fraction(0))
    assert Fraction(int(printed["b"].p), int(printed["b"].q)) == free
    assert Fraction(int(printed["p"].p), int(printed["p"].q)) == contact_acceleration(v, s, c, Fraction(1)) - free


@pytest.mark.parametrize("name", list(APPENDIX_B))
def test_a_changed_formula_is_noticed(name: str) -> None:
    mechanism = shipped_mechanism("frictional impact oscillator, all parameters")
    wrong = printed_formula(name) * sympy.Rational(10**6 + 1, 10**6)
    assert not vanishes_identically(wrong - getattr(derive(mechanism, substitute=False), name))


def test_a_changed_coefficient_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    lines, text = APPENDIX_B["alpha_2"]
    monkeypatch.setitem(
        oscillator_formulas.APPENDIX_B, "alpha_2", (lines, text.replace("- 3*m_1*m_2^2", "- 2*m_1*m_2^2"))
    )
    assert [row.label for row in compare_appendix_b() if not row.holds] == ["alpha_2"]
