"""The rates that are tried lie where a growth set can hold: any choice is right, a choice outside is of no use."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.motion.growth_choice import LAGS, growth_rates


def state(q: fmpq, W: fmpq, G: fmpq) -> ContactState:
    """beta = 2 and epsilon = 1/100: kappa = 1/100; without force G = -b."""
    return ContactState(fmpq(2), fmpq(1, 100), fmpq(-1), arb(-q), arb(-G), arb(-W), arb(0), arb(0))


@pytest.mark.parametrize("W", [fmpq(1), fmpq(3)])
def test_rates_between_the_two_ends(W: fmpq) -> None:
    """kappa/q = 1/25 < a < G/S = 1/(1 + W)."""
    rates = list(growth_rates(state(fmpq(1, 4), W, fmpq(1))))
    assert len(set(rates)) == len(rates) > 1
    assert all(fmpq(1, 25) < rate < 1 / (1 + W) for rate in rates)
    assert all(0 < lag < 1 for lag in LAGS)


@pytest.mark.parametrize(("q", "W", "G"), [(-1, 1, 1), (0, 1, 1), (1, -1, 1), (1, 1, 0), (1, 1000, 1)])
def test_no_rate_where_there_is_none(q: int, W: int, G: int) -> None:
    assert list(growth_rates(state(fmpq(q), fmpq(W), fmpq(G)))) == []
