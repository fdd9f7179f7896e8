"""Tests of what proofs/identities.md states."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from flint import arb, fmpq

from gspot_verified import BudgetError, evaluate, theta_by
from gspot_verified.numbers.balls import current_bits

BAD: list[tuple[dict[str, Any], type[Exception], str]] = [
    ({"tau": 0.1}, TypeError, "tau: a float is not taken as exact"),
    ({"tau": np.float64(0.1)}, TypeError, "tau: a float"),
    ({"beta": 0.5}, TypeError, "beta: a float"),
    ({"beta": None}, TypeError, "beta: expected"),
    ({"tau": True}, TypeError, "tau: expected"),
    ({"tau": float("nan")}, TypeError, "tau: a float"),
    ({"tau": arb("nan")}, ValueError, "tau: the ball must be finite"),
    ({"beta": arb("inf")}, ValueError, "beta: the ball must be finite"),
    ({"tau": "abc"}, ValueError, "tau: expected a number"),
    ({"tau": "nan"}, ValueError, "tau: expected a number"),
    ({"tau": "1/0"}, ValueError, "denominator"),
    ({"tau": "1e999999999"}, ValueError, "exponent"),
    ({"tau": 10**12 + 1}, ValueError, "tau: the library covers"),
    ({"beta": -(10**4) - 1}, ValueError, "beta: the library covers"),
    ({"tau": arb(10) ** 13}, ValueError, "tau: the library covers"),
    ({"tau": arb(0, 10**13)}, ValueError, "tau: the library covers"),
    ({"digits": 0}, ValueError, "digits must lie in"),
    ({"digits": -3}, ValueError, "digits must lie in"),
    ({"digits": 10**9}, ValueError, "digits must lie in"),
    ({"digits": 15.0}, TypeError, "digits must be an int"),
    ({"digits": True}, TypeError, "digits must be an int"),
    ({"derivative": -1}, ValueError, "derivative must lie in"),
    ({"derivative": 10**6}, ValueError, "derivative must lie in"),
    ({"derivative": 1.0}, TypeError, "derivative must be an int"),
    ({"max_bits": 1}, ValueError, "max_bits must be an int in"),
    ({"max_bits": "128"}, ValueError, "max_bits must be an int in .* got '128'"),
    ({"max_bits": 128.0}, ValueError, "max_bits must be an int in"),
]


@pytest.mark.parametrize(("change", "error", "message"), BAD)
def test_bad_input(change: dict[str, Any], error: type[Exception], message: str) -> None:
    arguments: dict[str, Any] = {"tau": 1, "beta": "1/2", **change}
    before = current_bits()
    with pytest.raises(error, match=message):
        evaluate(**arguments)
    assert current_bits() == before


def test_unknown_route() -> None:
    with pytest.raises(ValueError, match="route must be one of"):
        theta_by("magic", 1, 1)


def test_a_request_beyond_memory_is_refused_beforehand() -> None:
    # A million digits: Gamma of a rational of large height is not quasi-linear.
    with pytest.raises(BudgetError, match="memory"):
        evaluate(1, fmpq(1, 2) + fmpq(1, 10**4000), digits=1_000_000)
    with pytest.raises(ValueError, match="bits"):
        evaluate(1, fmpq(1, 2) + fmpq(1, 10**20000))
