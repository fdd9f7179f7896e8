"""Appendix B and Sec. 6: what is printed, what is derived, and that a wrong formula would be noticed."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest
import sympy

from gspot_verified.mechanisms.derive.lie_derivatives import Reader, derive, vanishes_identically
from gspot_verified.mechanisms.formulas.in_sympy import sympy_formula
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.symbolic import symbolic_system
from gspot_verified.paper.numerics.oscillator_formulas import APPENDIX_B, SECTION_6, printed_formula

ENERGIES = (
    "m_1*((l*cos(phi)*phi_dot)^2 + (psi_dot + l*sin(phi)*phi_dot)^2)/2 + m_2*psi_dot^2/2",
    "m_1*g*(psi + l*(1 - cos(phi))) + m_2*g*psi + k_phi*(phi - phi_0)^2/2 + k_psi*psi^2/2",
    "c_phi*phi_dot^2/2 + c_psi*psi_dot^2/2",
)
"""Kinetic and potential energy; half the power that the dampers take."""


def oscillator() -> Mechanism:
    return shipped_mechanism("frictional impact oscillator, all parameters")


@pytest.mark.parametrize("name", list(APPENDIX_B))
def test_the_shipped_oscillator_has_the_formulas_of_appendix_b(name: str) -> None:
    derived = getattr(derive(oscillator(), substitute=False), name)
    assert vanishes_identically(printed_formula(name) - derived)
    assert not vanishes_identically(printed_formula(name) * sympy.Rational(10**6 + 1, 10**6) - derived)


def test_the_shipped_oscillator_has_the_values_of_section_6() -> None:
    system = symbolic_system(shipped_mechanism("frictional impact oscillator", beta=None, kappa=None))
    assert all(value == 0 for value in system.values_at_point(system.conditions))
    values = system.values_at_point((system.alpha_1, system.alpha_2, system.alpha_3))
    names = {name: sympy.Symbol(name) for name in ("beta", "kappa")}
    for (_, text), value in zip(SECTION_6.values(), values, strict=True):
        assert sympy.expand(sympy_formula(text, names) - sympy_formula(str(value), names)) == 0


def test_the_shipped_oscillator_moves_by_lagranges_equations() -> None:
    mechanism = oscillator()
    motion = mechanism.motion
    assert isinstance(motion, Lagrangian)
    read = Reader(mechanism, substitute=False)
    q, rates = mechanism.symbols[:2], mechanism.symbols[2:]
    names = {str(symbol): symbol for symbol in mechanism.symbols}
    names |= {name: sympy.Symbol(name) for name, _ in mechanism.parameters}
    names["phi_0"] = sympy.Symbol("phi_ref") + sympy.Symbol("offset")
    kinetic, potential, loss = (sympy_formula(text, names) for text in ENERGIES)
    for i in range(2):
        momentum = sympy.diff(kinetic, rates[i])
        force = sympy.diff(kinetic - potential, q[i]) - sympy.diff(loss, rates[i])
        force -= sympy.Add(*(sympy.diff(momentum, q[j]) * rates[j] for j in range(2)))
        assert vanishes_identically(force - read(motion.forces[i]))
        for j in range(2):
            assert vanishes_identically(sympy.diff(momentum, rates[j]) - read(motion.mass_matrix[i][j]))


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
