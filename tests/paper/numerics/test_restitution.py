"""Coefficients of restitution: against scipy, the bounds of Theorems Q2 and Q3, bad input.

Page: proofs/restitution.md.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from flint import arb, arb_mat, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import ends
from scipy.integrate import solve_ivp

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.numerics import restitution as module
from gspot_verified.paper.numerics.restitution import elastic_loss, inelastic_bound, restitution

PLACES = [(1, 1), (1, 100), (30, 1), (1, fmpq(1, 20)), (fmpq(1, 100), fmpq(1, 3)), (fmpq(1, 256), fmpq(1, 4)), (3, 7)]


def by_scipy(k_1: float, k_2: float, damper: float, p: float) -> float:
    """e from compliant1 and compliant2 as they stand, with another time and other units than in the library."""

    def rates(_: float, x: np.ndarray) -> list[float]:
        y, v, z = x
        force = k_2 * (z - y)
        return [v, p * force, (-k_1 * z - force) / damper]

    def force(_: float, x: np.ndarray) -> float:
        return float(x[2] - x[0])

    force.terminal, force.direction = True, -1  # type: ignore[attr-defined]
    first = 1e-9 / math.sqrt(k_2 * p)
    found = solve_ivp(
        rates, (first, 1e4), [-3.0 * first, -3.0, 0.0], method="Radau", events=force, rtol=1e-10, atol=1e-13
    )
    assert found.t_events[0].size == 1
    return float(found.y_events[0][0][1]) / 3.0


@pytest.mark.parametrize(("rho", "zeta"), PLACES)
def test_the_coefficient_against_scipy(rho: fmpq, zeta: fmpq) -> None:
    found = restitution(fmpq(rho), fmpq(zeta))
    assert found.is_finite()
    low, high = map(float, ends(found))
    assert high - low < 2e-3
    ratio, lag = (float(int(fmpq(x).p) / int(fmpq(x).q)) for x in (rho, zeta))
    k_2, p = 5.0, 2.0
    expected = by_scipy(ratio * k_2, k_2, lag * math.sqrt(k_2 / p), p)
    assert low - 1e-6 < expected < high + 1e-6


def test_without_the_damper_in_the_way_the_motion_is_a_half_oscillation() -> None:
    """c → ∞: the first spring does not move, and e → 1."""
    assert restitution(fmpq(1), fmpq(10**6)) > arb("0.9998")


@settings(max_examples=15, deadline=None)
@given(st.integers(1, 40), st.integers(1, 40), st.integers(-3, 3))
def test_the_bounds_hold(numerator: int, denominator: int, power: int) -> None:
    rho, zeta = fmpq(numerator, denominator), fmpq(2) ** power
    e = restitution(rho, zeta)
    with working_bits(64):
        assert e.is_finite()
        assert 0 < e < 1
        assert 1 - e**2 < elastic_loss(rho, zeta)
        assert e < inelastic_bound(rho, zeta)


def test_every_part_of_theorem_q2_is_used_where_it_is_the_best() -> None:
    stiff, viscous, soft = (elastic_loss(fmpq(rho), fmpq(zeta)) for rho, zeta in ((100, 1), (1, 10**4), (1, 1)))
    with working_bits(64):
        assert stiff < arb("0.001")
        assert viscous.overlaps(arb(8) / 10**4)
        assert soft == 2  # neither (b) nor (c) applies
        assert elastic_loss(fmpq(1), fmpq(1, 100)) < arb("0.03")
        assert elastic_loss(fmpq(10**6), fmpq(10)) <= arb(2) / 10**6


def test_the_range_of_a_step_is_taylors_formula() -> None:
    """x' = x from 1: e^t at one time to the last digit of the remainder, and all of [1, e] over [0, 1]."""
    one = arb_mat([[1]])
    with working_bits(200):
        whole = arb_mat([[arb(0).union(arb(1)).exp()]])
        at_end = module._range(one, one, one, whole, arb(1))
        assert at_end.contains(arb(1).exp())
        assert at_end.rad() < arb(2) / math.factorial(module._TERMS)
        assert not module._range(one, one, one, one, arb(1)).contains(arb(1).exp())
        over = module._range(one, one, one, whole, arb(0).union(arb(1)))
        assert over.contains(arb(1))
        assert over.contains(arb(1).exp())


def test_a_step_on_which_nothing_is_known_ends_the_search(monkeypatch: pytest.MonkeyPatch) -> None:
    """The first zero is proved to be the first; and the remainder is taken over the whole step, its beginning too."""
    honest, steps = module._range, [0]

    def doubtful(row: arb_mat, matrix: arb_mat, state: arb_mat, along: arb_mat, time: arb) -> arb:
        assert all(x.contains(y) for x, y in zip(along.entries(), state.entries(), strict=True))
        assert time.contains(0)
        steps[0] += 1
        return arb(0, 1) if 10 < steps[0] < 16 else honest(row, matrix, state, along, time)

    assert restitution(fmpq(1), fmpq(1)).is_finite()
    monkeypatch.setattr(module, "_range", doubtful)
    assert not restitution(fmpq(1), fmpq(1)).is_finite()


@pytest.mark.parametrize(("rho", "zeta"), [(0, 1), (1, 0), (-1, 1), (1, -1)])
def test_bad_input(rho: int, zeta: int) -> None:
    with pytest.raises(ValueError, match="must be positive"):
        restitution(fmpq(rho), fmpq(zeta))
