"""Places where a bound is attained almost exactly: a radius smaller by 2^-20 would exclude the value here.

``tests/house/test_sabotage.py`` runs this file with each bound shrunk on purpose and wants it red.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from samples.strategies import ends
from witnesses.theta import theta_witness

from gspot_verified.theta_function.sums.finite_part import series_part
from gspot_verified.theta_function.sums.laplace import LaplacePlan, laplace_sum
from gspot_verified.theta_function.sums.negative import negative_sum
from gspot_verified.theta_function.sums.positive import SaddlePlan, positive_sum
from gspot_verified.theta_function.sums.splitting import splitting_sum
from gspot_verified.theta_function.sums.taylor import taylor_sum

_TINY = fmpq(1, 10**9)


def _contained(value: arb, number: Fraction) -> bool:
    lower, upper = ends(value)
    return lower <= number <= upper


def _exact(value: arb) -> Fraction:
    """The midpoint of a very accurate enclosure, for comparison with a much wider one."""
    lower, upper = ends(value)
    return (lower + upper) / 2


@pytest.mark.parametrize("terms", [1, 2, 5])
@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(-7, 3)])
def test_enveloping_series_far_out(terms: int, beta: fmpq) -> None:
    truth = _exact(negative_sum(fmpq(-(10**6)), beta, terms + 6, 2000))
    assert _contained(negative_sum(fmpq(-(10**6)), beta, terms, 1000), truth)


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(-7, 3)])
def test_taylor_series_next_to_zero(beta: fmpq) -> None:
    truth = theta_witness(Fraction(1, 10**9), Fraction(int(beta.p), int(beta.q)), 300)
    assert _contained(taylor_sum(_TINY, beta, 6, 500), truth)
    assert _contained(splitting_sum(_TINY, beta, 6, 500, 1), truth)


@pytest.mark.parametrize("tau", [fmpq(20), fmpq(40)])
@pytest.mark.parametrize("terms", [1, 2])
def test_saddle_point_with_few_terms(tau: fmpq, terms: int) -> None:
    truth = theta_witness(Fraction(int(tau.p)), Fraction(-1, 2), 80)
    assert _contained(positive_sum(tau, fmpq(-1, 2), SaddlePlan(terms, fmpq(3, 5), fmpq(2, 5)), 200), truth)


def test_laplace_integral_with_an_early_end() -> None:
    truth = theta_witness(Fraction(0), Fraction(-1, 2), 80)
    plan = LaplacePlan(fmpq(1, 4), fmpq(2), 80, fmpq(1))
    assert _contained(laplace_sum(fmpq(0), fmpq(-1, 2), plan, 200), truth)


def test_finite_part_with_few_terms() -> None:
    few = series_part(fmpq(-1), fmpq(-1, 2), fmpq(1, 100), 2, 200)
    many = series_part(fmpq(-1), fmpq(-1, 2), fmpq(1, 100), 60, 400)
    assert _contained(few, _exact(many))
