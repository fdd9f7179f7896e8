"""The rates a and c tried for the growth set: heuristics, any choice is right."""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpq

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.motion.growth_set import load, slopes
from gspot_verified.numbers.balls import approximate

_STEPS = 12  # between the two ends, in geometric progression
LAGS = (fmpq(1, 4), fmpq(3, 10), fmpq(1, 8), fmpq(1, 20))


def growth_rates(state: ContactState) -> Iterator[fmpq]:
    """Rates a between kappa/q, below which lambda could turn, and G/S, the largest that the state allows."""
    x = slopes(state)
    q, S = approximate(x.q), approximate(x.S)
    if not (q > 0 and S > 0):
        return
    least, largest = approximate(load(state)) / q, approximate(x.G) / S
    yield from (fmpq(*rate.as_integer_ratio()) for rate in _between(least, min(largest, 0.9)))


def _between(least: float, largest: float) -> Iterator[float]:
    """The geometric mean first, then the other steps of a geometric progression."""
    if not 0 < least < largest:
        return
    ratio = largest / least
    for k in sorted(range(1, _STEPS), key=lambda k: abs(k - _STEPS / 2)):
        yield least * ratio ** (k / _STEPS)
