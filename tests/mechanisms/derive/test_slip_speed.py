"""Friction that depends on the slip speed: the rates of p by two other routes, refusals (proofs/slip_speed.md)."""

from __future__ import annotations

import math
import random
from typing import Any

import pytest
import sympy
from flint import arb, fmpq
from sympy import Rational

from gspot_verified import (
    approach,
    classify,
    classify_all,
    critical_friction,
    expand,
    find_g_spots,
    scene_before_spot,
    sweep,
)
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import partial_derivative
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.derived import Derived
from gspot_verified.mechanisms.derive.slip_speed import at_slip_speed, depends_on_slip_speed
from gspot_verified.mechanisms.derive.to_system import Shifted, shift
from gspot_verified.mechanisms.formulas.rewriting import replaced, simplified
from gspot_verified.mechanisms.formulas.simplify import constant, minus, negative, product_of, sum_of
from gspot_verified.mechanisms.formulas.symbol import SLIP_SPEED, Symbol
from gspot_verified.mechanisms.input.given import from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import working_bits
from gspot_verified.scenes.floats.float_function import float_function
from tests.mechanisms.chains import chain

RADIUS = arb(10) ** -25
STRIBECK = "rod with Stribeck friction"


def driven(mu: str) -> Mechanism:
    """Time in the mass, the forces and the contact point, as a moving surface has it."""
    return lagrangian(
        "driven", ["Y", "a"], [[3, "sin(a)"], ["sin(a)", "2 + t^2"]], ["-1 - Y_dot^3 + cos(t)", "a*Y_dot"],
        "Y/5 + cos(a + t)", "Y - sin(a - 2*t)*a", mu, time="t",
    )  # fmt: skip


def values(shifted: Shifted, functions: list[Expression], state: list[fmpq]) -> list[arb]:
    return BoxProgram(shifted.expressions(functions, BALLS), len(state)).values([arb(value) for value in state])


def by_hand(law: Any) -> dict[str, Any]:
    """p(q, q', t) with mu(u) in it, and its derivatives along F and G = G_N - mu G_T: sympy, from M q'' = f alone."""
    n = 2
    Y, a, Yd, _ad, t = symbols = sympy.symbols("Y a Y_dot a_dot t")
    q, rates = symbols[:n], symbols[n : 2 * n]
    M = sympy.Matrix([[3, sympy.sin(a)], [sympy.sin(a), 2 + t**2]])
    f = sympy.Matrix([-1 - Yd**3 + sympy.cos(t), a * Yd])
    x, y = Y / 5 + sympy.cos(a + t), Y - sympy.sin(a - 2 * t) * a
    inverse = M.inv()
    normal, tangent = (inverse * sympy.Matrix([g.diff(c) for c in q]) for g in (y, x))
    u = sum(x.diff(c) * r for c, r in zip(q, rates, strict=True)) + x.diff(t)
    mu = law(u)
    push = normal - mu * tangent
    p = sum(y.diff(c) * push[i] for i, c in enumerate(q))
    free = inverse * f
    along_f = sum(p.diff(c) * r for c, r in zip((*q, *rates), (*rates, *free), strict=True)) + p.diff(t)
    along_g = sum(p.diff(r) * push[i] for i, r in enumerate(rates))
    return {"symbols": symbols, "u": u, "p": p, "along_f": along_f, "along_g": along_g}


def rate_of_p(functions: Derived[Expression]) -> tuple[Expression, Expression]:
    """L_F p and L_G p in positive slip by the formulas of the proof page, section 1.

    With mu' the derivative by the slip speed and alpha_1 that of a fixed one they are alpha_1 - mu' a B and
    mu' B (mu A - B).
    """
    free = len(functions.F)  # a component that the state does not have, for the slip speed
    (friction,) = replaced([functions.mu], {Symbol(SLIP_SPEED): Variable(free)})
    (slope,) = simplified(partial_derivative(friction, free, free + 1))
    f = functions
    drift = sum_of(f.alpha_1, negative(product_of(slope, product_of(f.a, f.B))))
    push = product_of(product_of(slope, f.B), minus(product_of(f.mu, f.A), f.B))
    first, second = replaced([drift, push], {Variable(free): f.u, Symbol(SLIP_SPEED): f.u})
    return first, second


def test_the_rates_of_p_against_derivatives_by_hand() -> None:
    """Where mu(u) stands in p from the beginning, no rule for its derivative is needed."""
    mechanism = driven("1/2 + exp(-slip_speed/3)/7 + Y*slip_speed^2/5")
    hand = by_hand(lambda u: sympy.Rational(1, 2) + sympy.exp(-u / 3) / 7 + sympy.Symbol("Y") * u**2 / 5)
    shifted = shift(mechanism, slip_speed=True)
    source = random.Random(28)
    state = [fmpq(source.randint(-40, 60), 64) for _ in mechanism.state]
    at = dict(zip(hand["symbols"], (sympy.Rational(int(v.p), int(v.q)) for v in state), strict=True))
    with working_bits(160):
        (p,) = at_slip_speed([shifted.functions.p], shifted.functions.u)
        found = values(shifted, [shifted.functions.u, p, *rate_of_p(shifted.functions)], state)
        for ball, letter in zip(found, ("u", "p", "along_f", "along_g"), strict=True):
            assert ball.rad() < RADIUS, letter
            assert abs(ball - arb(str(sympy.N(hand[letter].subs(at), 35)))) < RADIUS, letter
        assert abs(found[3]) > fmpq(1, 1000)


@pytest.mark.parametrize("force", ["0", "3", "70"])
def test_the_rate_of_p_is_that_of_the_motion(force: str) -> None:
    """p at two states a small step along F + G lambda_N: no formula of a derivative, a chain of five coordinates."""
    mechanism = lagrangian_chain("2/(1 + slip_speed/4)")
    shifted = shift(mechanism, slip_speed=True)
    f = shifted.functions
    p, *G = at_slip_speed([f.p, *f.G], f.u)
    state = [fmpq(3 * i + 1, 7) * (-1) ** i for i in range(len(mechanism.state))]
    with working_bits(240):
        moved = [rate + constant(fmpq(int(force))) * push for rate, push in zip(f.F, G, strict=True)]
        rates = values(shifted, moved, state)
        step = arb(2) ** -60
        program = BoxProgram(shifted.expressions([p], BALLS), len(state))
        ahead, behind = (
            program.values([arb(v) + sign * step * rate for v, rate in zip(state, rates, strict=True)])[0]
            for sign in (1, -1)
        )
        drift, push = values(shifted, list(rate_of_p(shifted.functions)), state)
        assert abs((ahead - behind) / (2 * step) - (drift + int(force) * push)) < arb(2) ** -80
        assert abs(push) > fmpq(1, 1000)


def lagrangian_chain(mu: str) -> Mechanism:
    from dataclasses import replace

    mechanism = chain(3)
    rod = lagrangian("law", ["X", "Y"], [[1, 0], [0, 1]], [0, 0], "X", "Y", mu)
    return replace(mechanism, mu=rod.mu)


def test_where_p_vanishes_its_push_is_the_slope_times_the_determinant() -> None:
    """L_G p = mu'(u) (A C - B^2) at p = 0 (proof page, section 1)."""
    A, B, C, slope, mu = sympy.symbols("A B C slope mu")
    assert sympy.simplify((slope * B * (mu * A - B) - slope * (A * C - B**2)).subs(C, mu * B)) == 0


def rigid_slip(mechanism: Mechanism) -> dict[str, float]:
    """Functions at the end of dxi/ds = p F - b G from the start of the shipped scene on, or where p falls to 0."""
    from scipy.integrate import solve_ivp

    shifted = shift(mechanism, slip_speed=True)
    f = shifted.functions
    found = at_slip_speed([f.p, f.b, *f.F, *f.G, f.u, *rate_of_p(f), f.alpha_2, f.alpha_3], f.u)
    rates = float_function(shifted.expressions(found, BALLS))
    m = len(f.F)

    def slip(_: float, state: Any) -> list[float]:
        p, b, *fields = rates(list(state))
        return [p * drift - b * push for drift, push in zip(fields[:m], fields[m : 2 * m], strict=True)]

    def vanishes(_: float, state: Any) -> float:
        return rates(list(state))[0]

    vanishes.terminal = True  # type: ignore[attr-defined]
    angle = math.asin(0.6) - 0.1
    start = [0, math.sin(angle), -0.1, 2, 0.5 * math.cos(angle), 0.5]
    assert vanishes(0, start) > 0.1
    run = solve_ivp(slip, (0, 12), start, rtol=1e-9, atol=1e-12, events=vanishes)
    p, b, *others = rates(list(run.y[:, -1]))
    named = dict(zip(("u", "drift", "push", "alpha_2", "alpha_3"), others[2 * m :], strict=True))
    return {"p": p, "b": b, "time": run.t[-1], **named}


def test_slip_reaches_p_0_away_from_g_spots_where_friction_falls() -> None:
    """Theorem of the proof page, section 2."""
    end = rigid_slip(shipped_mechanism(STRIBECK))
    assert end["time"] < 12
    assert abs(end["p"]) < 1e-6
    assert end["b"] < -0.25
    assert end["u"] > 1
    assert end["push"] < 0


def test_slip_comes_to_the_g_spot_with_a_finite_force_where_friction_rises() -> None:
    """Proof page, section 3: the force tends to a zero of (L_G p) f^2 + (L_F p - alpha_3) f + alpha_2."""
    end = rigid_slip(shipped_mechanism(STRIBECK, mu_s="19/10", delta="-1/20"))
    assert end["time"] == 12
    assert 0 < end["p"] < 1e-8
    assert end["push"] > 0
    force = -end["b"] / end["p"]
    assert end["push"] * force**2 + (end["drift"] - end["alpha_3"]) * force + end["alpha_2"] == pytest.approx(
        0, abs=1e-3
    )


def test_a_law_that_does_not_vary_is_coulombs() -> None:
    rod, stribeck = shipped_mechanism("rod"), shipped_mechanism(STRIBECK, delta=0, mu_s="73/36")
    assert not depends_on_slip_speed(stribeck, shift(stribeck).functions)
    assert shift(stribeck).functions == shift(rod).functions


def test_the_rod_depends_on_its_slip_speed() -> None:
    mechanism = shipped_mechanism(STRIBECK)
    functions = shift(mechanism, slip_speed=True).functions
    assert depends_on_slip_speed(mechanism, functions)
    assert at_slip_speed([functions.mu], constant(fmpq(10))) == [constant(fmpq(7, 6))]


def test_a_parameter_of_that_name_is_the_parameter() -> None:
    own = {"parameters": {"slip_speed": "1/3"}, "x": "X", "y": "Y", "mu": "slip_speed"}
    mechanism = lagrangian("own", ["X", "Y"], [[1, 0], [0, 1]], [0, -1], **own)
    assert shift(mechanism).functions.mu == constant(fmpq(1, 3))


def test_a_parameter_of_that_name_may_stay_without_a_value() -> None:
    own = {"parameters": {"slip_speed": None}, "x": "X", "y": "Y", "mu": "slip_speed"}
    mechanism = lagrangian("own", ["X", "Y"], [[1, 0], [0, 1]], [0, -1], **own)
    assert shift(mechanism, free=True).functions.mu == Symbol(SLIP_SPEED)


REFUSED: dict[str, Any] = {
    "classify": classify,
    "classify_all": classify_all,
    "expand": lambda rod: expand(rod, order=4),
    "approach": lambda rod: approach(rod, {"theta": "theta_ref - 1/10", "theta_dot": "1/2", "X_dot": 2, "X": 0}),
    "find_g_spots": find_g_spots,
    "sweep": lambda rod: sweep(rod, {"mu_s": "2..3"}),
    "scene_before_spot": lambda rod: scene_before_spot(rod, 1),
}


@pytest.mark.parametrize("command", REFUSED)
def test_what_rests_on_the_lagrangian_character_is_refused(command: str) -> None:
    with pytest.raises(
        MechanismError, match=r"rod with Stribeck friction: the friction coefficient depends on the slip"
    ):
        REFUSED[command](shipped_mechanism(STRIBECK))


def test_the_critical_friction_is_about_the_configuration() -> None:
    found, coulomb = critical_friction(shipped_mechanism(STRIBECK)), critical_friction(shipped_mechanism("rod"))
    assert found.value is not None
    assert coulomb.value is not None
    assert found.value.overlaps(coulomb.value)
    assert found.friction is None
    assert found.is_below is None


def test_fields_are_checked_at_every_fixed_speed() -> None:
    """The other hypotheses of Sec. 2 are asked for, as of any fields."""
    parts: dict[str, Any] = {"state": ["X", "Y", "U", "V"], "F": ["U", "V", 0, -1], "G_T": [0, 0, 1, 0]}
    good = from_fields("block", **parts, G_N=[0, 0, 0, 1], x="X", y="Y", mu="1/(2 + slip_speed)")
    assert shift(good, slip_speed=True).functions.p == constant(fmpq(1))
    bad = from_fields("block", **parts, G_N=[0, 0, "1/3", 1], x="X", y="Y", mu="1/(2 + slip_speed)")
    with pytest.raises(MechanismError, match="L_GN u - L_GT v must vanish"):
        shift(bad, slip_speed=True)


def test_the_slip_speed_stands_in_the_friction_alone() -> None:
    with pytest.raises(MechanismError, match="slip_speed"):
        lagrangian("drag", ["X", "Y"], [[1, 0], [0, 1]], ["-slip_speed", -1], "X", "Y", "1/2")


def test_velocities_in_the_friction_are_still_refused() -> None:
    with pytest.raises(MechanismError, match=r"for simulate .* a formula in slip_speed"):
        shift(lagrangian("block", ["X", "Y"], [[1, 0], [0, 1]], [0, -1], "X", "Y", "1 + X_dot"), slip_speed=True)


# Theorem 1 with friction that depends on the slip speed: the construction of proofs/slip_speed.md, by sympy.


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
