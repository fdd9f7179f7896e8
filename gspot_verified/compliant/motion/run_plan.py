"""Times at which a run is looked at: heuristics, any choice is right."""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpq

from gspot_verified.compliant.model.normal_form import CompliantModel
from gspot_verified.numbers.balls import approximate

_SCALED_TIMES = (2, 3, 4, 6, 8, 12, 16, 24, 32)


def later_times(model: CompliantModel) -> Iterator[fmpq]:
    """t at tau from 2 to 32: t = epsilon T, T = tau (epsilon/2)^(-1/3), in the units of the paper."""
    unit = (approximate(model.scaled_epsilon) / 2) ** (-1 / 3)
    for tau in _SCALED_TIMES:
        yield model.epsilon * fmpq(int(tau * unit) + 1)
