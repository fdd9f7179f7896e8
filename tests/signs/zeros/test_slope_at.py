from __future__ import annotations

from typing import Any

import pytest
from flint import fmpq

from gspot_verified.signs.zeros import slope_at
from gspot_verified.signs.zeros.slope_at import SlopeAt, UndecidedError


@pytest.mark.parametrize("digits", [20, 60])
@pytest.mark.parametrize(("beta", "tau"), [(3, 0), (6, 0), (2, 0)])
def test_the_sign_at_a_zero_is_open(beta: int, tau: int, digits: int) -> None:
    with pytest.raises(UndecidedError, match="is open"):
        SlopeAt(fmpq(beta), fmpq(4), digits).sign(fmpq(tau))


def test_near_0_nothing_is_evaluated(monkeypatch: pytest.MonkeyPatch) -> None:
    """For 1 < beta < 2 there is one zero: both signs occur."""

    def evaluate(*_: Any, **__: Any) -> Any:
        raise AssertionError("evaluated")

    monkeypatch.setattr(slope_at, "evaluate", evaluate)
    slope = SlopeAt(fmpq(3, 2), fmpq(4), 20)
    inside = [slope.sign(fmpq(k, 2)) for k in range(-8, 9)]
    assert len(set(inside)) == 2
    slope.newton(fmpq(-4), 20)
    for tau in (fmpq(9, 2), fmpq(-9, 2)):
        with pytest.raises(AssertionError, match="evaluated"):
            slope.sign(tau)
        with pytest.raises(AssertionError, match="evaluated"):
            slope.newton(tau, 20)


@pytest.mark.parametrize("digits", [20, 60])
def test_a_step_of_newtons_method_squares_the_distance(digits: int) -> None:
    """The zero of beta = 5/2 near 1.53, carried along tau and evaluated; the distance of the start is below 1/500."""
    slope = SlopeAt(fmpq(5, 2), fmpq(4), digits)
    assert slope.is_carried is (digits == 20)
    near = fmpq(153, 100)
    first = slope.newton(near, 20).mid().fmpq()
    assert abs(first - near) > fmpq(1, 1000)
    assert slope.sign(first - fmpq(1, 10**4)) == -slope.sign(first + fmpq(1, 10**4))
