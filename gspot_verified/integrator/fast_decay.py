"""When the fast parts of a solution have died out, and how long a step along the slow manifold may be. Heuristic."""

from __future__ import annotations

import math
from collections.abc import Sequence

from gspot_verified.integrator.slow_curve import FAST, SlowCurve

_SHARE = 0.12
_COUNTED = 0.02
_LEAST_GAIN = 20.0
_DEAD = 0.62
_TAIL_BITS = 16.0
_LARGEST_CHANGE = 8.0
_RECOVERY = 1.3
_GAIN_AT_CONSTANT_RATES = 64.0
_ACCEPTED = 0.8


class FastDecay:
    """Follows the eigenvalues from step to step: how far the fast ones have decayed, how fast all of them change."""

    def __init__(self) -> None:
        self._last: list[complex] = []
        self._decayed = 0.0
        self._length = 0.0
        self._constant = False
        self._limit = math.inf

    def passed(self, values: Sequence[complex], h: float) -> None:
        """A step of length h with these eigenvalues."""
        now = sorted(values, key=lambda value: (abs(value), value.imag))
        if len(self._last) == len(now):
            changes = [(abs(a), abs(a - b)) for a, b in zip(now, self._last, strict=True) if abs(a) * h > _COUNTED]
            scale = min((size * h / change for size, change in changes if change > 1e-12 * size), default=math.inf)
            self._constant = scale == math.inf
            self._length = _GAIN_AT_CONSTANT_RATES * h if self._constant else _SHARE * scale
            fast = [value for value in now if abs(value) * self._length > FAST]
            self._decayed += h * min((-value.real for value in fast), default=0.0)
        self._last = now

    def slow_length(self, bits: int, resolved: float) -> float:
        """The length of a slow step worth trying; 0: none is."""
        ready = self._decayed > _DEAD * bits * math.log(2)
        length = min(self._length, self._limit)
        return length if ready and length > _LEAST_GAIN * resolved else 0.0

    def accepts(self, found: SlowCurve | None, bits: int) -> bool:
        """Whether a curve is good enough; what is learned of lengths and of the time to wait."""
        if found is None:
            self._decayed = 0.0
            return False
        if found.start > -_DEAD * bits:
            self._decayed = max(0.0, -found.start * math.log(2))
            return False
        if found.tail > -_ACCEPTED * bits:
            self._limit = min(self._limit, self._length) / 2
            return False
        change = 2 ** ((-bits + _TAIL_BITS - found.tail) / (len(found.jacobian) - 1))
        if change < 1 or self._constant:
            self._length *= min(change, _LARGEST_CHANGE)
        self._limit *= _RECOVERY
        return True

    def failed(self) -> None:
        """No step could be proved."""
        self._limit = min(self._limit, self._length) / 2
