"""The growth of dΘ/dτ without its saddle point: each step holds, and the means are those of Θ in numbers."""

from __future__ import annotations

from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.section_4_5 import growth
from gspot_verified.theta_function.value.evaluate import evaluate


@pytest.mark.parametrize(
    ("target", "name", "text", "fails"),
    [
        (growth, "EXPONENT", "r*tau - r^2/2", "third_moment_is_known"),
        (growth, "THIRD", "tau*M1", "third_moment_is_known"),
        (growth.RATES, "q", "s - 2*q^2", "means_move_so"),
        (growth.RATES, "s", "a + tau*q - 2*s*q", "means_move_so"),
        (growth.RATES, "s", "2 + tau*q - s*q", "distance_moves_so"),
    ],
)
def test_a_step_rests_on_its_formula(
    monkeypatch: pytest.MonkeyPatch, target: Any, name: str, text: str, fails: str
) -> None:
    step = getattr(growth, fails)
    assert step() is True
    if isinstance(target, dict):
        monkeypatch.setitem(target, name, text)
    else:
        monkeypatch.setattr(target, name, text)
    assert step() is False


@pytest.mark.parametrize("tau", [fmpq(4), fmpq(25), fmpq(100)])
@pytest.mark.parametrize("beta", [fmpq(3, 2), fmpq(7, 3)])
def test_the_means_in_numbers(beta: fmpq, tau: fmpq) -> None:
    """q² <= s, |s - τ| < 2, and q is sqrt(τ) up to 1/τ: q = Θ'/Θ and s = Θ''/Θ at β - n, by dΘ/dτ = -β Θ(β - 1)."""
    index = beta - beta.ceil()
    value, first, second = (evaluate(tau, index - k, digits=20).value for k in range(3))
    with working_bits(64):
        q = -index * first / value
        s = index * (index - 1) * second / value
        assert q**2 <= s
        assert abs(s - tau) < 2
        assert abs(q - arb(tau).sqrt()) < 2 / arb(tau)
