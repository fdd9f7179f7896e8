"""Matching on the inner scale: the polynomials Θ(τ, n) by another formula."""

from __future__ import annotations

from math import factorial

import pytest
from flint import fmpq

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.section_5.section_5_matching import theta_polynomial
from gspot_verified.theta_function.value.evaluate import evaluate


@pytest.mark.parametrize("n", range(10))
def test_theta_polynomials(n: int) -> None:
    """(-1)^n n!/((n - 3 j)! j!) (-1/3)^j for every 3 j <= n; and the value at τ = 2."""
    found = theta_polynomial(n)
    assert found == [
        fmpq((-1) ** (n + j) * factorial(n), 3**j * factorial(n - 3 * j) * factorial(j)) for j in range(n // 3 + 1)
    ]
    value = evaluate(2, n).value
    assert value.is_finite()
    with working_bits(64):
        assert value.overlaps(value * 0 + sum(c * fmpq(2) ** (n - 3 * j) for j, c in enumerate(found)))
