"""C by its two routes, on the whole of (0, 1) and in the scale of epsilon, where both serve.

Page: proofs/first_integrals.md, sections 2 and 3. Both ends: test_sharpness.py.
"""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import fmpq

from gspot_verified.compliant.model.kernel import kernel
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.compliant.slow.slow_coefficient import _logistic, _scaled
from gspot_verified.numbers.balls import relative_bits, working_bits

STATE = Deviation(fmpq(5, 2), fmpq(1, 5_000), fmpq(1, 2), fmpq(1, 10**4), fmpq(-2, 3), fmpq(300), fmpq(-200))


@pytest.mark.parametrize("p", [fmpq(1, 2), fmpq(3)])
@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(5, 2), fmpq(13, 2)])
def test_both_routes_agree(beta: fmpq, p: fmpq) -> None:
    """Each term of k counts: with hats of such sizes x^2 Y and x^3 lambda are seen, and so is the cubic exponent."""
    with working_bits(140):
        data = kernel(replace(STATE, beta=beta, p=p))
        whole, scaled = _logistic(data, 90), _scaled(data, 60)
        assert min(relative_bits(whole), relative_bits(scaled)) > 40
        assert whole.overlaps(scaled)


def test_the_scaled_route_is_refused_without_its_hypotheses() -> None:
    """p > 0, and epsilon at most 1/2."""
    with working_bits(100):
        assert _scaled(kernel(STATE), 40).is_finite()
        for refused in (replace(STATE, epsilon=fmpq(51, 100)), replace(STATE, epsilon=fmpq(3))):
            assert not _scaled(kernel(refused), 40).is_finite()
