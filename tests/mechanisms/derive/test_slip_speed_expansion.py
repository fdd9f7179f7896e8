"""Theorem 1 with friction that depends on the slip speed: the construction of proofs/slip_speed.md, by sympy."""

from __future__ import annotations

import pytest
import sympy
from sympy import Rational

s, delta = sympy.symbols("s delta")
M = 8  # orders of delta
DRIFT, PUSH, ALPHA_3 = Rational(-3), Rational(-2, 7), Rational(-7, 2)  # L_F p, L_G p, alpha_3 at the G-spot
SLOPES = (Rational(5, 3), Rational(-3, 2), Rational(2, 5), Rational(4, 3))
"""Of L_F p, L_G p, alpha_2, alpha_3 in t = delta^2 s."""


def zero_of(force: Rational) -> Rational:
    """alpha_2 at the G-spot with which slip enters it under this force (proof page, section 3)."""
    return -(PUSH * force**2 + (DRIFT - ALPHA_3) * force)


def functions(force: Rational) -> list[sympy.Expr]:
    """L_F p, L_G p, alpha_2, alpha_3 along the motion."""
    values = (DRIFT, PUSH, zero_of(force), ALPHA_3)
    return [value + slope * delta**2 * s for value, slope in zip(values, SLOPES, strict=True)]


def coefficient(function: sympy.Expr, n: int) -> sympy.Expr:
    return sympy.expand(function).coeff(delta, n)


def polynomial_of(right: sympy.Expr, first: Rational, third: Rational) -> sympy.Expr:
    """The c with 2 c''' + first s c' - third c = right, from the highest power down."""
    rest, found = sympy.Poly(right, s), sympy.Integer(0)
    while not rest.is_zero:
        k = rest.degree()
        term = rest.LC() / (k * first - third) * s**k
        found += term
        rest -= sympy.Poly(2 * sympy.diff(term, s, 3) + first * s * sympy.diff(term, s) - third * term, s)
    return found


def expansion(force: Rational) -> dict[str, list[sympy.Expr]]:
    """p_n, b_n, y_n, v_n, z_n, lambda_n by the four steps of the proof page, section 4."""
    drift, push, second, third = functions(force)
    alpha_1, alpha_3 = DRIFT + PUSH * force, ALPHA_3 - PUSH * force
    terms: dict[str, list[sympy.Expr]] = {name: [] for name in ("p", "b", "y", "v", "z", "force")}
    for n in range(M):
        before = sympy.diff(terms["z"][n - 1], s) if n else sympy.Integer(0)
        if n == 0:
            found, right = force, None
        else:
            right = coefficient(second + force * drift, n) - sum(
                coefficient(third - force * push, n - k) * terms["force"][k] for k in range(n)
            )
            r_v = sum(terms["p"][n - k] * terms["force"][k] for k in range(1, n))
            source = 2 * sympy.diff(right, s, 2) + alpha_3 * sympy.diff(before, s, 2)
            c = polynomial_of(sympy.expand(source + alpha_1 * s * right + alpha_3 * r_v), alpha_1, alpha_3)
            found = sympy.expand((right - sympy.diff(c, s)) / alpha_3)
        terms["force"].append(found)
        terms["z"].append(sympy.expand(-found - before))
        terms["y"].append(sympy.expand(-2 * found - before))
        terms["v"].append(sympy.diff(terms["y"][n], s))
        slope = coefficient(drift, n) + sum(coefficient(push, n - k) * terms["force"][k] for k in range(n + 1))
        terms["p"].append(sympy.integrate(sympy.expand(slope), s))
        terms["b"].append(sympy.expand(-force * terms["p"][0]) if n == 0 else sympy.expand(c - force * terms["p"][n]))
    return terms


def residuals(terms: dict[str, list[sympy.Expr]], force: Rational) -> dict[str, sympy.Expr]:
    """What the truncated sums leave in eqs. specialPP to specialL, with p' = L_F p + (L_G p) lambda_N."""
    p, b, y, v, z, f = (sum(term * delta**n for n, term in enumerate(terms[name])) for name in terms)
    drift, push, second, third = functions(force)
    return {
        "p": sympy.diff(p, s) - drift - push * f,
        "b": sympy.diff(b, s) - second + third * f,
        "y": sympy.diff(y, s) - v,
        "v": sympy.diff(v, s) - b - p * f,
        "z": delta * sympy.diff(z, s) + z + f,
        "force": f - z + y,
    }


@pytest.mark.parametrize("force", [Rational(3, 2), Rational(1, 5)])
def test_the_polynomials_solve_the_equations_to_their_order(force: Rational) -> None:
    terms = expansion(force)
    for name, left in residuals(terms, force).items():
        assert all(coefficient(left, n) == 0 for n in range(M)), name
    assert all(term.subs(s, 0) == 0 for term in terms["p"])
    assert any(terms["force"][n] != 0 for n in range(1, M))


def test_another_force_at_the_g_spot_solves_nothing() -> None:
    """The zero of the quadratic is needed: with another alpha_2 order 0 fails already."""
    terms = expansion(Rational(3, 2))
    assert coefficient(residuals(terms, Rational(1, 2))["b"], 0) != 0
