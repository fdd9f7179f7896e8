"""The bounds of the ways to a G-spot against motions in floats, and states that do not reach it.

Page: proofs/approach.md, section 2.
"""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from flint import fmpq

from gspot_verified.paper.section_1 import section_1_open_sets as ledger


def motion(alphas: tuple[float, float, float], p: float, b: float, bend: float) -> tuple[float, float, float, float]:
    """p, b and the integrals of p and |b| after a long time, by Euler's method; the α's bend with b."""
    step, of_p, of_b = 1e-3, 0.0, 0.0
    for _ in range(20_000):
        of_p, of_b = of_p + step * p, of_b + step * abs(b)
        first = alphas[0] + bend * b
        p, b = p + step * first * p, b + step * (alphas[1] * p + alphas[2] * b)
    return p, b, of_p, of_b


@pytest.mark.parametrize("name", list(ledger.SYSTEM))
def test_the_bounds_hold_for_motions(name: str) -> None:
    texts, (p, b) = ledger.SYSTEM[name]
    alphas = tuple(float(Fraction(text)) for text in texts)
    assert len(alphas) == 3
    start = float(p), float(b)
    a1, a3, large = 0.9 * -alphas[0], -alphas[2], abs(alphas[1])
    p_end, b_end, of_p, of_b = motion(alphas, *start, bend=1.0)
    assert 0 < p_end < 1e-6
    assert -1e-6 < b_end < 0
    assert of_p <= start[0] / a1
    assert of_b <= (a1 * -start[1] + large * start[0]) / (a1 * a3)
    weight, decay = -start[1] + 2 * large / a1 * start[0], min(a3, a1 / 2)
    assert -b_end + 2 * large / a1 * p_end <= weight * math.exp(-decay * 20)


@pytest.mark.parametrize("name", list(ledger.SYSTEM))
def test_a_set_of_states_is_captured(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.is_captured(name) is True
    alphas, (p, b) = ledger.SYSTEM[name]
    for wrong in (((alphas[0], alphas[1], "1/2"), (p, b)), (("1", *alphas[1:]), (p, b)), (alphas, (p, -b))):
        monkeypatch.setitem(ledger.SYSTEM, name, wrong)
        assert ledger.is_captured(name) is None


def test_in_case_ii_a_small_force_falls(monkeypatch: pytest.MonkeyPatch) -> None:
    """λ_N = 1 divides the states of this Case, and the radius of the set counts."""
    alphas, (p, _) = ledger.SYSTEM["1-case-II"]
    for share, answer in ((fmpq(99, 100), None), (fmpq(101, 100), None), (fmpq(3), True)):
        monkeypatch.setitem(ledger.SYSTEM, "1-case-II", (alphas, (p, -share * p)))
        assert ledger.is_captured("1-case-II") is answer
