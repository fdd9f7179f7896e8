"""The surviving exponent: the closed form of the model system, small p, other springs, a linear solve."""

from __future__ import annotations

import numpy as np
import pytest
from flint import arb, fmpq

from gspot_verified.compliant.fast.fast_coefficient import saddle
from gspot_verified.expansion.series.regularisation import PAPER, Regularisation
from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.fast_decay import decay_rate, surviving_exponent
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import approximate

OTHER = Regularisation(fmpq(2), fmpq(5), fmpq(1, 3))


@pytest.mark.parametrize("p", [fmpq(1, 100), fmpq(1, 2), fmpq(3)])
def test_the_exponent_of_the_model_system_is_that_of_its_saddle(p: fmpq) -> None:
    """Re g(r_+) with g(r) = r - r^2/2 - r^3/3 - ln(1 + r) - p r (proofs/first_integrals.md)."""
    r = saddle(p)
    expected = ((r - r * r / 2 - r * r * r / 3) - (1 + r).log() - r * arb(p)).real
    start = approximate(p)
    times = np.linspace(0, start, 200)
    assert surviving_exponent([*times], [*(start - times)], PAPER) == pytest.approx(approximate(expected), rel=1e-6)


def test_at_p_one_half_the_small_p_formula_is_two_per_mille_too_large() -> None:
    times = np.linspace(0, 0.5, 200)
    found = surviving_exponent([*times], [*(0.5 - times)], PAPER)
    assert found == pytest.approx(0.0155914, rel=1e-5)
    assert found == pytest.approx(0.5**2 / 16, rel=3e-3)


@pytest.mark.parametrize("regularisation", [PAPER, OTHER])
def test_the_rate_is_that_of_the_linear_system(regularisation: Regularisation) -> None:
    """Eigenvalues of Y' = V, V' = p lambda, c Z' = -k_1 Z - lambda, lambda = k_2 (Z - Y); for small p c k_2^2 p/..."""
    k_1, k_2, c = (approximate(value) for value in (regularisation.k_1, regularisation.k_2, regularisation.c))
    for p in (1e-4, 0.3, 2.0):
        matrix = np.array([[0, 1, 0], [-p * k_2, 0, p * k_2], [k_2 / c, 0, -(k_1 + k_2) / c]])
        assert decay_rate(p, regularisation) == pytest.approx(-np.linalg.eigvals(matrix).real.max(), rel=1e-9)
    small = c * k_2**2 * 1e-4 / (2 * (k_1 + k_2) ** 2)
    assert decay_rate(1e-4, regularisation) == pytest.approx(small, rel=1e-3)


def test_without_damping_nothing_dies_out() -> None:
    assert decay_rate(0.5, Regularisation(fmpq(1), fmpq(1), fmpq(0))) == pytest.approx(0, abs=1e-12)


def test_approach_prints_it_and_only_at_a_g_spot() -> None:
    model = shipped_mechanism("model system")
    reached = approach(model, {"x": 0, "u": 3, "p": "1/2", "b": "-2"})
    assert reached.fast_exponent == pytest.approx(0.0155914, rel=1e-5)
    assert "about e^(-0.01559/epsilon) of a fast oscillation at the start is left at the G-spot" in str(reached)
    assert reached.to_json()["fast_exponent"] == reached.fast_exponent
    stuck = approach(model, {"x": 0, "u": "1/1000", "p": "1/2", "b": "-2"})
    assert stuck.end != "G-spot"
    assert stuck.fast_exponent is None
    assert "oscillation" not in str(stuck)
