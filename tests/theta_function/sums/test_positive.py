"""The saddle point at plus infinity with its explicit remainder.

Page: proofs/positive.md.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import assume, given
from hypothesis import strategies as st
from samples.strategies import near_integers, small_heights, to_fmpq, to_fraction
from witnesses.theta import contains_witness, theta_witness

from gspot_verified.numbers.balls import relative_bits
from gspot_verified.theta_function.sums.positive import SaddlePlan, positive_sum
from gspot_verified.theta_function.value.integer import polynomial_value

_BETAS = st.one_of(small_heights(), near_integers(12)).filter(lambda b: abs(b) <= 20)


_DISCS = st.integers(5, 80).map(lambda n: fmpq(n, 100))


@given(st.integers(9, 40), _BETAS, st.integers(1, 25), _DISCS)
def test_saddle_point_contains_the_witness(tau: int, beta: Fraction, terms: int, disc: fmpq) -> None:
    plan = SaddlePlan(terms, disc, min(1 - disc, fmpq(9, 20)))
    value = positive_sum(fmpq(tau), to_fmpq(beta), plan, 400)
    assume(value.is_finite())
    assert contains_witness(value, theta_witness(Fraction(tau), beta), 58)


@pytest.mark.parametrize(
    "plan",
    [
        SaddlePlan(0, fmpq(1, 2), fmpq(1, 4)),
        SaddlePlan(5, fmpq(1), fmpq(1, 4)),
        SaddlePlan(5, fmpq(1, 2), fmpq(3, 5)),
        SaddlePlan(5, fmpq(1, 2), fmpq(0)),
        SaddlePlan(500, fmpq(1, 2), fmpq(1, 4)),  # lambda sigma^2 < 2N
        SaddlePlan(5, fmpq(-1, 2), fmpq(1, 4)),
    ],
)
def test_saddle_point_refuses_a_plan_outside_its_hypotheses(plan: SaddlePlan) -> None:
    assert not positive_sum(fmpq(20), fmpq(1, 2), plan, 100).is_finite()


def test_saddle_point_wants_tau_certainly_positive() -> None:
    plan = SaddlePlan(3, fmpq(1, 2), fmpq(1, 4))
    assert not positive_sum(arb(1, 2), fmpq(1, 2), plan, 100).is_finite()
    assert not positive_sum(fmpq(-20), fmpq(1, 2), plan, 100).is_finite()
    # beta so negative that 2 lambda sigma > -beta - 1 fails
    assert not positive_sum(fmpq(9), fmpq(-1000), plan, 100).is_finite()


@given(st.integers(10, 30), st.integers(0, 10))
def test_saddle_point_at_integers_is_the_polynomial(tau: int, n: int) -> None:
    value = positive_sum(fmpq(tau), fmpq(n), SaddlePlan(3, fmpq(1, 2), fmpq(1, 4)), 200)
    assert relative_bits(value) > 150
    assert value.overlaps(arb(polynomial_value(fmpq(tau), n)))


@given(
    st.integers(9, 40), st.integers(1, 4), _BETAS, st.integers(1, 25), st.integers(20, 80).map(lambda n: fmpq(n, 100))
)
def test_both_ways_of_summing_give_one_number(above: int, below: int, beta: Fraction, terms: int, disc: fmpq) -> None:
    tau, b = fmpq(below * above, below + 1), to_fmpq(beta)
    plan = SaddlePlan(terms, disc, min(1 - disc, fmpq(9, 20)))
    plain, split = positive_sum(tau, b, plan, 400), positive_sum(tau, b, replace(plan, split=True), 400)
    assume(plain.is_finite() and split.is_finite())
    assert plain.overlaps(split)
    assert contains_witness(split, theta_witness(to_fraction(tau), beta), 58)


@pytest.mark.parametrize("beta", [fmpq(7, 3), fmpq(2) + fmpq(1, 10**60), fmpq(-1, 2), fmpq(5, 2)])
@pytest.mark.parametrize("bits", [200, 1_200])
def test_the_algebraic_part_is_as_accurate_as_the_sum_needs(beta: fmpq, bits: int) -> None:
    """Next to an integer both parts show at moderate tau: what the smaller one leaves out must not."""
    plan = SaddlePlan(3, fmpq(18, 25), fmpq(7, 25))
    for tau in (fmpq(12), fmpq(30), fmpq(60)):
        value, finer = positive_sum(tau, beta, plan, bits), positive_sum(tau, beta, plan, 2 * bits)
        assert value.is_finite()
        assert finer.is_finite()
        assert value.overlaps(finer)
        assert value.rad() <= finer.rad() * (1 + arb(2) ** -20) + abs(finer.mid()) * arb(2) ** (40 - bits)


def test_a_split_plan_that_outgrows_its_hypotheses_is_refused() -> None:
    # N rises to whole blocks of 8: lambda sigma^2 >= 2N holds for 9 terms and not for 16
    plan = SaddlePlan(9, fmpq(1, 2), fmpq(1, 4))
    tau = fmpq(25)
    assert positive_sum(tau, fmpq(1, 2), plan, 100).is_finite()
    assert not positive_sum(tau, fmpq(1, 2), replace(plan, split=True), 100).is_finite()
