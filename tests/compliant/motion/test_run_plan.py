"""The times at which a run is looked at: after the G-spot, in the order and the unit of tau."""

from __future__ import annotations

from itertools import pairwise

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import compliant_model
from gspot_verified.compliant.motion.run_plan import later_times
from gspot_verified.numbers.balls import working_bits


@pytest.mark.parametrize(("epsilon", "alpha_1"), [("1e-6", -1), ("1/10", -1), ("1e-9", -3)])
def test_later_times(epsilon: str, alpha_1: int) -> None:
    """t = epsilon T, T an integer next above tau (epsilon |alpha_1|/2)^(-1/3), tau from 2 to 32."""
    model = compliant_model("3/2", epsilon, alpha_1=alpha_1)
    times = list(later_times(model))
    assert all(0 < first < second for first, second in pairwise(times))
    with working_bits(100):
        unit = 1 / (arb(model.scaled_epsilon) / 2).root(3)
        for time, tau in ((times[0], 2), (times[-1], 32)):
            duration = time / model.epsilon
            assert duration.q == 1
            assert tau * unit * (1 - fmpq(1, 10**9)) < duration < tau * unit + fmpq(11, 10)
